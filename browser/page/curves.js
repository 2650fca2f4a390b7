// Curves as doubles, to be drawn: nothing is decided here.

const NS = 'http://www.w3.org/2000/svg';
function element(name, attributes = {}, ...children) {
  const e = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  e.append(...children);
  return e;
}
function html(name, attributes = {}, ...children) {
  const e = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith('on')) e.addEventListener(key.slice(2), value);
    else if (value !== false) e.setAttribute(key, value === true ? '' : value);
  e.append(...children);
  return e;
}

// The point and the first two derivatives of a Bezier curve, in the plane or in space, by de
// Casteljau; with weights those of a rational one.
function jet(points, t, weights = null) {
  if (weights) {
    const h = jet(points.map((p, i) => [...p, 1].map((x) => weights[i] * x)), t), [w, dw, ddw] = [h.x, h.d, h.dd].map((list) => list.pop());
    const x = h.x.map((c) => c / w), d = x.map((c, k) => (h.d[k] - dw * c) / w);
    return { x, d, dd: x.map((c, k) => (h.dd[k] - 2 * dw * d[k] - ddw * c) / w) };
  }
  const n = points.length - 1, rows = [points];
  for (let k = 1; k <= n; ++k)
    rows.push(rows[k - 1].slice(1).map((p, j) => p.map((x, i) => (1 - t) * rows[k - 1][j][i] + t * x)));
  const row = (k) => rows[n - k];
  const x = row(0)[0];
  const d = n < 1 ? points[0].map(() => 0) : row(1)[1].map((b, i) => n * (b - row(1)[0][i]));
  const dd = n < 2 ? points[0].map(() => 0) : row(2)[2].map((c, i) => n * (n - 1) * (c - 2 * row(2)[1][i] + row(2)[0][i]));
  return { x, d, dd };
}
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
// The vector to the centre of curvature, as long as the curvature.
function curvature_vector({ d, dd }) {
  const square = dot(d, d);
  return d.map((x, k) => (square > 0 ? (dd[k] - (dot(d, dd) / square) * x) / square : 0));
}
// Signed in the plane.
function curvature({ d, dd }) {
  return Math.hypot(...curvature_vector({ d, dd })) * (d.length === 2 ? Math.sign(d[0] * dd[1] - d[1] * dd[0]) : 1);
}
function samples(points, weights = null, n = 64) {
  const list = [];
  let s = 0;
  for (let k = 0; k <= n; ++k) {
    const j = jet(points, k / n, weights);
    if (k > 0) s += Math.hypot(...j.x.map((x, i) => x - list[k - 1].x[i]));
    list.push({ ...j, s, k: curvature(j) });
  }
  return list;
}
const round = (x) => String(Math.round(x * 1000) / 1000);
const line = (points) => points.map(([x, y]) => `${round(x)} ${round(-y)}`).join(' L');
function comb(list, scale) {
  const tips = list.map((p) => curvature_vector(p).map((x, k) => p.x[k] - scale * x));
  return `M${line(tips)}` + list.map((p, i) => (i % 2 ? '' : ` M${line([p.x, tips[i]])}`)).join('');
}
// The path of a curve: of degree 1 to 3 as SVG has it, otherwise as cubics within a thousandth of
// its size.
function pathData(points, first = true) {
  const at = (p) => `${round(p[0])} ${round(-p[1])}`;
  const start = first ? `M${at(points[0])} ` : '';
  if (points.length === 2) return `${start}L${at(points[1])} `;
  if (points.length === 4) return `${start}C${points.slice(1).map(at).join(' ')} `;
  let text = start;
  const pieces = 8;
  for (let k = 0; k < pieces; ++k) {
    const a = jet(points, k / pieces), b = jet(points, (k + 1) / pieces), h = 1 / pieces / 3;
    text += `C${at(a.x.map((x, i) => x + h * a.d[i]))} ${at(b.x.map((x, i) => x - h * b.d[i]))} ${at(b.x)} `;
  }
  return text;
}
