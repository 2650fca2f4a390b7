// Points and curvatures of Bezier curves, as a picture needs them. Whatever is stated about a join
// comes with the data.

// A curve is {dimension, points: flat coordinates, weights: an array or undefined, group}.
function degreeOf(curve) { return curve.points.length / curve.dimension - 1; }

function controlPoint(curve, i) {
  const j = i < 0 ? i + degreeOf(curve) + 1 : i;
  return curve.points.slice(j * curve.dimension, (j + 1) * curve.dimension);
}

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const combine = (a, s, b, t) => a.map((x, i) => s * x + t * b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const length = (a) => Math.hypot(...a);

// The homogeneous control points (w x, w).
function homogeneous(curve) {
  const rows = [];
  for (let i = 0; i <= degreeOf(curve); ++i) {
    const w = curve.weights ? curve.weights[i] : 1;
    rows.push([...controlPoint(curve, i).map((x) => w * x), w]);
  }
  return rows;
}

// The point x, and the derivatives x' and x'', by the scheme of de Casteljau, whose last three
// steps hold them, and the quotient rule.
function derivatives(rows, t) {
  const n = rows.length - 1;
  let level = rows, second = null, first = null;
  for (let size = n; size >= 0; --size) {
    if (size === 2) second = combine(combine(level[0], 1, level[1], -2), n * (n - 1), level[2], n * (n - 1));
    if (size === 1) first = combine(level[1], n, level[0], -n);
    if (size === 0) break;
    const next = [];
    for (let i = 0; i < size; ++i) next.push(combine(level[i], 1 - t, level[i + 1], t));
    level = next;
  }
  const p = level[0], d = p.length - 1, w = p[d], zero = p.map(() => 0);
  first = first || zero;
  second = second || zero;
  const x = p.slice(0, d).map((c) => c / w);
  const dx = x.map((c, i) => (first[i] - first[d] * c) / w);
  const ddx = x.map((c, i) => (second[i] - 2 * first[d] * dx[i] - second[d] * c) / w);
  return [x, dx, ddx];
}

// The curvature vector (x'' - (x'.x'' / x'.x') x') / x'.x', or null where there is no speed.
function curvatureVector([, dx, ddx]) {
  const speed = dot(dx, dx);
  if (!(speed > 0)) return null;
  const k = combine(ddx, 1 / speed, dx, -dot(dx, ddx) / (speed * speed));
  return k.every(Number.isFinite) ? k : null;
}

// Samples {x, k} at `count` + 1 parameters.
function samples(curve, count) {
  const rows = homogeneous(curve), result = [];
  for (let i = 0; i <= count; ++i) {
    const jet = derivatives(rows, i / count);
    result.push({ x: jet[0], k: curvatureVector(jet) });
  }
  return result;
}

// Two orthonormal directions of the plane in which these points extend most: the plane itself where
// there is one. By iteration on their second moments.
function planeOf(points) {
  const d = points[0].length;
  if (d === 2) return [[1, 0], [0, 1]];
  const mean = points.reduce((sum, p) => combine(sum, 1, p, 1 / points.length), new Array(d).fill(0));
  const offsets = points.map((p) => subtract(p, mean)), directions = [];
  for (let k = 0; k < 2; ++k) {
    const orthogonal = (v) => directions.reduce((u, e) => combine(u, 1, e, -dot(u, e)), v);
    let v = orthogonal(new Array(d).fill(0).map((_, i) => 1 / (i + 1 + k)));
    for (let step = 0; step < 60; ++step) {
      const u = orthogonal(offsets.reduce((sum, p) => combine(sum, 1, p, dot(p, v)), new Array(d).fill(0)));
      if (!(length(u) > 0)) break;
      v = u.map((x) => x / length(u));
    }
    if (!(length(v) > 0)) v = orthogonal(new Array(d).fill(0).map((_, i) => (i === k ? 1 : 0)));
    directions.push(v.map((x) => x / (length(v) || 1)));
  }
  return directions;
}
