// The scenes of the page. Verdicts come from the module, pictures from curves.js.

const bytesOf = async (base64) => {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
};
let filesBytes = null;
const gc = await load({ wasm: await bytesOf(MODULE) });
// the readers of files are unpacked when they are needed
const files = async () => (filesBytes ??= await load({ wasm: await bytesOf(MODULE), filesWasm: await bytesOf(FILES) }));

const [stage, controls, verdict, details, nav] = ['stage', 'controls', 'verdict', 'details', 'scenes'].map((id) => document.getElementById(id));
const colours = ['var(--left)', 'var(--right)', 'var(--good)', '#9a6700', '#8250df', '#1b7c83', '#bf3989', '#4d7c0f', '#7c5a3c'];

const say = (...nodes) => verdict.replaceChildren(...nodes.map((n) => (typeof n === 'string' ? html('p', {}, n) : n)));
const strong = (text, good) => html('p', {}, html('strong', { class: good ? 'good' : 'bad' }, text));
const guarded = (f) => {
  try {
    return f();
  } catch (error) {
    say(strong(error.code ?? 'error', false), error.message);
    return null;
  }
};
const digits = (x) => (x === null ? 'unbounded' : Number(x.toPrecision(6)).toString());
const bounds = (e, unit = '') => (e === null ? 'undefined' : e[0] === e[1] ? `${digits(e[0])}${unit}` : `[${e[0].toPrecision(6)}, ${e[1] === null ? '∞' : e[1].toPrecision(6)}]${unit}`);
const orders = (j) => (j.c_order < 0 ? 'a gap' : `C${j.c_order} G${j.g_order} F${j.f_order}`);
const counted = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;
const shown = (text) => (text.length > 60 ? `${text.slice(0, 57)}…` : text);
const tableOf = (head, rows) =>
  html('table', {}, html('thead', {}, html('tr', {}, ...head.map((h) => html('th', { scope: 'col' }, h)))),
    html('tbody', {}, ...rows.map((row) => html('tr', {}, ...row.map((c) => (c instanceof Node ? html('td', {}, c) : html('td', { class: 'number' }, c)))))));

// A picture of [-12, 12] x [-8, 8] with points that move.
class Picture {
  constructor(label, points, { snap = 0, changed }) {
    Object.assign(this, { points, snap, changed });
    this.under = element('g');
    this.over = element('g');
    this.svg = element('svg', { class: 'scene', viewBox: '-12 -8 24 16', role: 'group', 'aria-label': label }, this.under, this.over);
    this.circles = points.map((p, i) => {
      const c = element('circle', { class: 'point', r: 0.22, tabindex: 0, role: 'button', stroke: p.colour });
      c.addEventListener('pointerdown', (e) => (c.setPointerCapture(e.pointerId), c.focus({ preventScroll: true }), e.preventDefault()));
      c.addEventListener('pointermove', (e) => c.hasPointerCapture(e.pointerId) && this.move(i, this.place(e)));
      c.addEventListener('keydown', (e) => {
        const step = (e.shiftKey ? 10 : 1) * (this.snap || 0.1), direction = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
        if (!direction) return;
        e.preventDefault();
        this.move(i, p.at.map((x, k) => x + step * direction[k]));
      });
      this.over.append(c);
      return c;
    });
    stage.replaceChildren(this.svg);
    this.place_circles();
  }
  place(event) {
    const m = this.svg.getScreenCTM().inverse(), p = new DOMPoint(event.clientX, event.clientY).matrixTransform(m);
    return [p.x, -p.y];
  }
  move(i, at) {
    const limit = [11.8, 7.8], unit = this.snap || 1 / 64; // so that numbers stay short
    const to = at.map((x, k) => Math.round(Math.min(limit[k], Math.max(-limit[k], x)) / unit) * unit);
    const old = this.points[i].at;
    if (to[0] === old[0] && to[1] === old[1]) return;
    for (const [j, p] of this.points.entries())
      if (j === i || this.points[i].with?.includes(j)) p.at = j === i ? to : p.at.map((x, k) => x + to[k] - old[k]);
    this.schedule();
  }
  schedule() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      const begin = performance.now();
      this.changed();
      this.place_circles();
      this.frame = performance.now() - begin;
    });
  }
  place_circles() {
    for (const [i, p] of this.points.entries()) {
      this.circles[i].setAttribute('cx', p.at[0]);
      this.circles[i].setAttribute('cy', -p.at[1]);
      this.circles[i].setAttribute('aria-label', `${p.name}, x ${digits(p.at[0])}, y ${digits(p.at[1])}`);
    }
  }
  // Draws curves with their polygons and combs, and grid lines where points snap.
  draw(curves, { combs = true } = {}) {
    const nodes = [];
    if (this.snap) for (let k = -12; k <= 12; ++k) nodes.push(element('path', { class: 'grid', d: `M${k} -8V8${Math.abs(k) <= 8 ? ` M-12 ${k}H12` : ''}` }));
    for (const { points, colour, legs } of curves) {
      if (legs) nodes.push(element('path', { class: 'leg', d: `M${line(points)}` }));
      if (combs) nodes.push(element('path', { class: 'comb', d: comb(samples(points), 3) }));
      nodes.push(element('path', { class: 'curve', stroke: colour, d: `M${line(samples(points).map((s) => s.x))}` }));
    }
    this.under.replaceChildren(...nodes);
  }
}

// Curvature against arc length, of curves one after the other.
function plot(chains) {
  const width = 480, height = 130, list = chains.map((chain) => {
    let s = 0;
    return chain.map(({ points, colour }) => {
      const all = samples(points).map((p) => ({ s: s + p.s, k: p.k }));
      s = all.at(-1).s;
      return { all, colour };
    });
  });
  const everything = list.flat(2).flatMap((c) => c.all), most = Math.max(0.1, ...everything.map((p) => Math.min(3, Math.abs(p.k)))), length = Math.max(...everything.map((p) => p.s)) || 1;
  const at = (p) => `${round((p.s / length) * width)} ${round(height / 2 - (Math.max(-most, Math.min(most, p.k)) / most) * (height / 2 - 8))}`;
  return html('figure', {}, element('svg', { class: 'plot', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Curvature against arc length' },
    element('path', { class: 'grid', d: `M0 ${height / 2}H${width}` }),
    ...list.flat().map(({ all, colour }) => element('path', { class: 'curve', stroke: colour, d: `M${all.map(at).join(' L')}` })),
    element('text', { x: 4, y: 14 }, `κ(s), up to ${digits(most)}`)), html('figcaption', {}, 'Curvature against arc length'));
}

const cubic = (names, at, colour) => at.map((p, i) => ({ at: p, name: `${names}, control point ${i}`, colour }));
const given = (parameters, defaults) => {
  const text = parameters.get('points');
  const list = text ? text.split(';').map((p) => p.split(',').map(Number)) : [];
  return list.length === defaults.length && list.every((p) => p.length === 2 && p.every(Number.isFinite)) ? list : defaults;
};

function joinScene(snap, defaults) {
  return (parameters) => {
    const at = given(parameters, defaults);
    const points = [...cubic('Left curve', at.slice(0, 4), colours[0]), ...cubic('Right curve', at.slice(4), colours[1])];
    for (const i of [3, 4]) points[i].with = [2, 3, 4, 5].filter((j) => j !== i); // a node takes its handles along
    points[4].name = 'Node, of the right curve';
    const curve = (i) => points.slice(i, i + 4).map((p) => p.at);
    const picture = new Picture('Two cubic curves that meet', points, { snap, changed });
    const align = (quiet) => {
      const left = [0, 1].map((k) => points[3].at[k] - points[2].at[k]), right = [0, 1].map((k) => points[5].at[k] - points[4].at[k]);
      const aligned = guarded(() => gc.alignHandles(left.map((x) => x / snap), right.map((x) => x / snap), 3));
      if (!aligned) return quiet || say('The handles form no kink that moves of three units would mend.');
      points[2].at = points[3].at.map((x, k) => x - snap * aligned.left[k]);
      points[5].at = points[4].at.map((x, k) => x + snap * aligned.right[k]);
      return null;
    };
    let magnet = null;
    if (snap) {
      magnet = html('input', { type: 'checkbox', id: 'magnet' });
      controls.append(html('button', { type: 'button', onclick: () => (align(false), changed(), picture.place_circles()) }, 'Make it smooth'),
        html('label', {}, magnet, ' while I drag'));
    } else
      controls.append(html('button', { type: 'button', onclick: () => {
        const d = [0, 1].map((k) => points[3].at[k] - points[2].at[k]), e = [0, 1].map((k) => points[5].at[k] - points[4].at[k]);
        const ratio = Math.max(1 / 8, Math.round((8 * Math.hypot(...e)) / (Math.hypot(...d) || 1)) / 8);
        points[4].at = [...points[3].at];
        points[5].at = points[4].at.map((x, k) => x + ratio * d[k]);
        changed();
        picture.place_circles();
      } }, 'Make it G1'), html('button', { type: 'button', onclick: () => {
        points[4].at = [...points[3].at];
        for (const [i, j] of [[5, 2], [6, 1]]) points[i].at = i === 5 ? points[3].at.map((x, k) => 2 * x - points[2].at[k]) : points[5].at.map((x, k) => 2 * x + points[1].at[k] - 2 * points[2].at[k]);
        changed();
        picture.place_circles();
      } }, 'Make it C2'));
    function changed() {
      if (magnet?.checked) align(true);
      const left = curve(0), right = curve(4);
      picture.draw([{ points: left, colour: colours[0], legs: true }, { points: right, colour: colours[1], legs: true }]);
      guarded(() => {
        const join = gc.continuity(left, right), d = gc.deviation(left, right), grade = gc.joinGrade(left, right);
        say(strong(`${orders(join)}${grade.grade ? `, ${grade.grade}` : ''}`, join.g_order >= 1),
          `β = ${join.betas.length ? shown(`(${join.betas.join(', ')})`) : 'none'}`,
          `angle ${bounds(d.angle_degrees, '°')}, a handle is off by ${bounds(grade.handle_offset)}`,
          `jump of the curvature ${bounds(d.curvature_percent, ' %')}, gap ${bounds(d.gap)}`);
      });
      details.replaceChildren(plot([[{ points: left, colour: colours[0] }, { points: right, colour: colours[1] }]]));
    }
    changed();
  };
}

function blendScene(parameters) {
  const at = given(parameters, [[-11, -5], [-9, 3], [-6, 5], [-3, 4], [3, -3], [6, -6], [8, -2], [11, 5]]);
  const points = [...cubic('First curve', at.slice(0, 4), colours[0]), ...cubic('Second curve', at.slice(4), colours[1])];
  const names = ['fair', 'energy3', 'energy2', 'c2', 'min_second', 'fair_g3', 'c3'];
  const wanted = new Set((parameters.get('strategies') ?? 'fair,energy3').split(',').filter((n) => names.includes(n)));
  for (const name of names)
    controls.append(html('label', {}, html('input', { type: 'checkbox', checked: wanted.has(name), onchange: (e) => (e.target.checked ? wanted.add(name) : wanted.delete(name), changed()) }), ` ${name}`));
  const picture = new Picture('Two curves and blends between them', points, { changed });
  function changed() {
    const phi = points.slice(0, 4).map((p) => p.at), psi = points.slice(4).map((p) => p.at);
    const ends = [{ points: phi, colour: colours[0], legs: true }, { points: psi, colour: colours[1], legs: true }];
    guarded(() => {
      const blends = [...wanted].map((strategy) => ({ ...gc.blend(phi, psi, { strategy }), colour: colours[2 + names.indexOf(strategy)] }));
      picture.draw([...ends, ...blends.map((b) => ({ points: b.curve.points, colour: b.colour }))]);
      const proved = blends.length > 0 && blends.every((b) => Math.min(b.start_join.g_order, b.end_join.g_order) >= 2);
      say(strong(blends.length === 0 ? 'Choose a strategy' : proved ? 'Every join is proved' : 'A join is not smooth', proved),
        ...blends.map((b) => html('p', { style: `color: ${b.colour}` }, `${b.strategy}: ${orders(b.start_join)} and ${orders(b.end_join)}, fairness ${b.fairness === null ? '∞' : digits(b.fairness)}`)));
      details.replaceChildren(plot(blends.map((b) => [ends[0], { points: b.curve.points, colour: b.colour }, ends[1]])),
        tableOf(['strategy', 'β', 'η'], blends.map((b) => [b.strategy, shown(b.shape.beta), shown(b.shape.eta)])));
    });
  }
  changed();
}

function cornerScene(parameters) {
  const at = given(parameters, [[-9, -5], [-2, 5], [9, -3]]);
  const points = at.map((p, i) => ({ at: p, name: ['Start', 'Corner', 'End'][i], colour: colours[i % 2] }));
  const slider = (name, value, most, step) => {
    const input = html('input', { type: 'range', min: 0, max: most, step, value, 'aria-label': name, oninput: () => changed() });
    controls.append(html('label', {}, `${name} `, input));
    return input;
  };
  const radius = slider('Radius', 2.5, 6, 0.05), smoothing = slider('Smoothing in percent', 60, 100, 1);
  const copy = html('button', { type: 'button', onclick: async () => {
    const text = details.querySelector('textarea').value;
    try {
      await navigator.clipboard.writeText(text);
    } catch { // from a file
      details.querySelector('textarea').select();
      document.execCommand('copy');
    }
    copy.textContent = 'Copied';
    setTimeout(() => (copy.textContent = 'Copy the path'), 1500);
  } }, 'Copy the path');
  controls.append(copy);
  const picture = new Picture('A corner and what it becomes', points, { changed });
  function changed() {
    const [a, b, c] = points.map((p) => p.at), legs = [a, c].map((p) => Math.hypot(p[0] - b[0], p[1] - b[1]));
    const cosine = ((a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1])) / (legs[0] * legs[1]), half = Math.acos(Math.max(-1, Math.min(1, cosine))) / 2;
    // where a circle of this radius would begin, and as much farther as the smoothing says
    const distance = Math.min((Number(radius.value) / Math.tan(half)) * (1 + Number(smoothing.value) / 100), 0.95 * Math.min(...legs));
    const lines = [[a, b], [b, c]];
    if (!(distance > 1e-6)) {
      picture.draw(lines.map((points, i) => ({ points, colour: colours[i] })));
      return say('A corner', 'Radius 0 leaves it as it is.');
    }
    guarded(() => {
      const r = gc.roundCorner(lines[0], lines[1], distance);
      const parts = [r.left.points, r.blend.curve.points, r.right.points];
      picture.draw(parts.map((points, i) => ({ points, colour: colours[[0, 2, 1][i]] })));
      say(strong(`${orders(r.blend.start_join)} and ${orders(r.blend.end_join)}`, r.blend.start_join.g_order >= 2),
        `cut off at the distance ${digits(distance)} along both sides; the curvature is continuous, exactly`);
      const path = parts.map((p, i) => pathData(p, i === 0)).join('').trim();
      details.replaceChildren(plot([parts.map((points, i) => ({ points, colour: colours[[0, 2, 1][i]] }))]),
        html('label', {}, 'The path as cubics, rounded to three decimals: no longer exact', html('textarea', { readonly: true, spellcheck: 'false' }, path)));
    });
    return null;
  }
  changed();
}

function drawingScene() {
  const example = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 120 60">\n<path id="wave" fill="none" stroke="#0b62c4" stroke-width="3"\n  d="M5 30 C15 10 25 8 35 20 C45 33 55 52 70 40 C85 27 95 12 115 30"/>\n</svg>\n';
  const text = html('textarea', { 'aria-label': 'The drawing as SVG', spellcheck: 'false' });
  const picture = html('img', { alt: 'The drawing' }), file = html('input', { type: 'file', accept: '.svg,image/svg+xml', 'aria-label': 'A drawing' });
  let url = null;
  text.value = example;
  const show = async () => {
    if (url) URL.revokeObjectURL(url);
    picture.src = url = URL.createObjectURL(new Blob([text.value], { type: 'image/svg+xml' })); // as an image nothing in it is run
    try {
      const report = await (await files()).verifySvg(text.value), s = report.summary;
      say(strong(s.kinks === 0 ? 'No kinks' : counted(s.kinks, 'kink'), s.kinks === 0),
        `${counted(s.joins, 'join')} in ${counted(s.subpaths, 'subpath')}, ${counted(s.corners, 'corner')}, ${s.undecided} undecided`);
      const worst = report.joins.filter((j) => j.grade !== 'G2').sort((a, b) => (a.grade === 'kink' ? 0 : 1) - (b.grade === 'kink' ? 0 : 1));
      details.replaceChildren(tableOf(['element', 'commands', 'grade', 'angle'], worst.slice(0, 200).map((j) => [`${j.element}${j.id ? ` ${j.id}` : ''}, line ${j.line}`,
        `${j.left_command} ${j.left_letter} – ${j.right_command} ${j.right_letter}`, j.grade ?? 'undecided', j.angle_degrees ? bounds(j.angle_degrees, '°') : ''])));
    } catch (error) {
      say(strong(error.code ?? 'error', false), error.message);
      details.replaceChildren();
    }
  };
  const take = async (f) => f && ((text.value = await f.text()), await show());
  file.addEventListener('change', () => take(file.files[0]));
  text.addEventListener('change', show);
  controls.append(file, html('button', { type: 'button', onclick: async () => {
    try {
      const { svg, report } = await (await files()).repairSvg(text.value);
      text.value = svg;
      await show();
      verdict.append(html('p', {}, report.moves.length === 0 ? 'No handle moves.' : `${report.moves.length === 1 ? '1 handle has' : `${report.moves.length} handles have`} moved, by at most ${bounds(report.largest_move)} of the last decimal.`));
    } catch (error) {
      say(strong(error.code ?? 'error', false), error.message);
    }
  } }, 'Mend the kinks'), html('button', { type: 'button', onclick: () => {
    const link = html('a', { href: URL.createObjectURL(new Blob([text.value], { type: 'image/svg+xml' })), download: 'drawing.svg' });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  } }, 'Save'));
  stage.replaceChildren(picture, text);
  stage.ondragover = (e) => (e.preventDefault(), stage.classList.add('over'));
  stage.ondragleave = () => stage.classList.remove('over');
  stage.ondrop = (e) => (e.preventDefault(), stage.classList.remove('over'), take(e.dataTransfer.files[0]));
  show();
}

function surfaceScene() {
  const canvas = html('canvas', { width: 720, height: 480, tabindex: 0, role: 'img', 'aria-label': 'Two patches with isophotes; the arrow keys turn them' });
  const slider = (name) => {
    const input = html('input', { type: 'range', min: -4, max: 4, step: 1, value: 0, 'aria-label': name, oninput: () => changed() });
    controls.append(html('label', {}, `${name} `, input));
    return input;
  };
  const first = slider('Second row of points'), second = slider('Third row of points');
  stage.replaceChildren(canvas);
  const a = [[0, 1, 1, 0], [1, 2, 2, 1], [2, 3, 3, 1], [2, 3, 2, 1]].map((row, i) => row.map((z, j) => [i - 3, j - 1.5, z / 4]));
  let turn = 0.7, tilt = 0.9;
  const second_patch = () => {
    const p = [3, 2, 1, 0].map((i) => a[i]), mirror = (x, y, k) => x.map((c, i) => 2 * c - y[i] + (i === 2 ? k : 0));
    const rows = [p[0], p[0].map((x, j) => mirror(x, p[1][j], Number(first.value) / 8))];
    rows.push(rows[1].map((x, j) => x.map((c, i) => 2 * c - 2 * p[1][j][i] + p[2][j][i] + (i === 2 ? Number(second.value) / 8 : 0))));
    rows.push(rows[2].map((x, j) => x.map((c, i) => 2 * c - rows[1][j][i])));
    return rows;
  };
  const at = (net, u, v) => {
    const side = (points, t) => {
      let r = points, d = null;
      while (r.length > 1) {
        if (r.length === 2) d = r[1].map((c, i) => 3 * (c - r[0][i]));
        r = r.slice(1).map((p, j) => p.map((c, i) => (1 - t) * r[j][i] + t * c));
      }
      return { x: r[0], d };
    };
    const { x, d: du } = side(net.map((row) => side(row, v).x), u), { d: dv } = side(net[0].map((_, j) => side(net.map((row) => row[j]), u).x), v);
    const n = [du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0]], l = Math.hypot(...n) || 1;
    return { x, n: n.map((c) => c / l) };
  };
  function paint(nets) {
    const c = canvas.getContext('2d'), size = 80, quads = [], scale = 100;
    const [ct, st, ce, se] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const view = ([x, y, z]) => {
      const px = ct * x - st * y, py = st * x + ct * y, pz = z - 0.4;
      return [360 + scale * px, 240 - scale * (se * pz + ce * py * 0.8), py * se - pz * ce];
    };
    for (const net of nets) {
      const grid = [];
      for (let i = 0; i <= size; ++i) grid.push(Array.from({ length: size + 1 }, (_, j) => at(net, i / size, j / size)));
      for (let i = 0; i < size; ++i)
        for (let j = 0; j < size; ++j) {
          const corners = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]], n = [0, 1, 2].map((k) => corners.reduce((s, p) => s + p.n[k], 0) / 4);
          const light = 0.45 * n[0] + 0.3 * n[1] + 0.84 * n[2], stripe = Math.sin(light * 45) > 0;
          const points = corners.map((p) => view(p.x));
          quads.push({ points, depth: points.reduce((s, p) => s + p[2], 0), shade: `hsl(212 ${stripe ? 70 : 25}% ${Math.round((stripe ? 30 : 62) + 25 * Math.abs(light))}%)` });
        }
    }
    quads.sort((p, q) => q.depth - p.depth);
    c.clearRect(0, 0, canvas.width, canvas.height);
    for (const { points, shade } of quads) {
      c.beginPath();
      for (const [i, p] of points.entries()) i ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1]);
      c.closePath();
      c.fillStyle = c.strokeStyle = shade;
      c.fill();
      c.stroke();
    }
    c.strokeStyle = '#d1242f';
    c.lineWidth = 2;
    c.beginPath();
    for (let j = 0; j <= size; ++j) {
      const p = view(at(nets[0], 1, j / size).x);
      j ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1]);
    }
    c.stroke();
    c.lineWidth = 1;
  }
  function changed() {
    const b = second_patch();
    paint([a, b]);
    guarded(() => {
      const e = gc.edgeContinuity(a, 'u1', b, 'u0');
      say(strong(e.g_order < 0 ? 'a gap' : `G${e.is_g3 ? 3 : e.g_order} along the whole edge`, e.g_order >= 1),
        e.defect === 'none' ? 'Tangent planes and curvatures agree.' : `What is missing: ${e.defect}.`,
        `The angle of the normals is at most ${digits(e.largest_angle_degrees)}°.`,
        e.g_order === 0 ? 'The stripes jump at the edge.' : e.g_order === 1 ? 'The stripes meet, with kinks at the edge.' : 'The stripes go on smoothly.');
    });
  }
  let from = null;
  canvas.style.touchAction = 'none';
  canvas.addEventListener('pointerdown', (e) => (canvas.setPointerCapture(e.pointerId), (from = [e.clientX, e.clientY])));
  canvas.addEventListener('pointermove', (e) => {
    if (!from) return;
    turn += (e.clientX - from[0]) / 150;
    tilt = Math.max(0.1, Math.min(1.5, tilt + (e.clientY - from[1]) / 150));
    from = [e.clientX, e.clientY];
    paint([a, second_patch()]);
  });
  canvas.addEventListener('pointerup', () => (from = null));
  canvas.addEventListener('keydown', (e) => {
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[e.key];
    if (!step) return;
    e.preventDefault();
    turn += step[0];
    tilt = Math.max(0.1, Math.min(1.5, tilt + step[1]));
    paint([a, second_patch()]);
  });
  changed();
}

const scenes = {
  join: ['A join', joinScene(0, [[-10, -3], [-7, 3], [-4, 4], [0, 2], [0, 2], [3, 0.5], [6, -4], [10, -2]])],
  blend: ['Blends', blendScene],
  corner: ['A corner', cornerScene],
  grid: ['On a grid', joinScene(1, [[-11, -4], [-9, 2], [-6, 4], [0, 2], [0, 2], [8, -1], [9, -4], [11, -2]])],
  drawing: ['A drawing', drawingScene],
  surfaces: ['Surfaces', surfaceScene],
};
for (const [name, [title]] of Object.entries(scenes)) nav.append(html('a', { href: `#${name}`, id: `scene-${name}` }, title));
// #SCENE?points=x,y;x,y;…&strategies=fair,c2
function open() {
  const [name, query = ''] = location.hash.slice(1).split('?'), scene = Object.hasOwn(scenes, name) ? name : 'join';
  for (const a of nav.children) a.id === `scene-${scene}` ? a.setAttribute('aria-current', 'page') : a.removeAttribute('aria-current');
  for (const e of [stage, controls, details]) e.replaceChildren();
  stage.ondragover = stage.ondragleave = stage.ondrop = null;
  document.title = `${scenes[scene][0]} – Geometric continuity`;
  scenes[scene][1](new URLSearchParams(query));
}
addEventListener('hashchange', open);
controls.addEventListener('submit', (e) => e.preventDefault());
open();
document.documentElement.dataset.ready = 'yes';
