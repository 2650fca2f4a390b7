// The scenes of the page. Verdicts come from the module, pictures from curves.js.

const bytesOf = async (base64) => {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
};
const gc = await load({ wasm: await bytesOf(MODULE) });
// the readers of files are unpacked when they are needed
let reader = null;
const files = () => (reader ??= Promise.all([MODULE, FILES].map(bytesOf)).then(([wasm, filesWasm]) => load({ wasm, filesWasm })));

const [stage, hint, controls, verdict, details, nav] = ['stage', 'hint', 'controls', 'verdict', 'details', 'scenes'].map((id) => document.getElementById(id));
const colours = ['var(--left)', 'var(--right)', 'var(--good)', '#9a6700', '#8250df', '#1b7c83', '#bf3989', '#4d7c0f', '#7c5a3c', '#6e7781', '#d4501e', '#00a0c0'];

const say = (...nodes) => verdict.replaceChildren(...nodes.map((n) => (typeof n === 'string' ? html('p', {}, n) : n)));
const strong = (text, good) => html('p', {}, html('strong', { class: good ? 'good' : 'bad' }, text));
// Shows what takes its time to compute, unless something else was asked for meanwhile, or another
// scene.
let asked = 0;
const latest = async (compute, show, failed) => {
  const mine = ++asked;
  stage.setAttribute('aria-busy', 'true');
  try {
    const result = await compute();
    if (mine === asked) show(result);
  } catch (error) {
    if (mine === asked) failed(error);
  }
  if (mine === asked) stage.removeAttribute('aria-busy');
};
const guarded = (f) => {
  try {
    return f();
  } catch (error) {
    say(strong(error.code ?? 'error', false), error.message);
    return null;
  }
};
const digits = (x) => (x === null ? 'unbounded' : Number(x.toPrecision(6)).toString());
// An enclosure; one number where both ends look the same.
const bounds = (e, unit = '') => {
  if (e === null) return 'undefined';
  if (e[0] === e[1]) return `${digits(e[0])}${unit}`;
  const [low, high] = e.map((x) => (x === null ? '∞' : x.toPrecision(6)));
  return low === high ? `≈ ${digits(e[0])}${unit}` : `[${low}, ${high}]${unit}`;
};
const orders = (j) => (j.c_order < 0 ? 'a gap' : `C${j.c_order} G${j.g_order} F${j.f_order}`);
const counted = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;
const shown = (text) => (text.length > 60 ? `${text.slice(0, 57)}…` : text);
const tableOf = (head, rows) =>
  html('table', {}, html('thead', {}, html('tr', {}, ...head.map((h) => html('th', { scope: 'col' }, h)))),
    html('tbody', {}, ...rows.map((row) => html('tr', {}, ...row.map((c) => (c instanceof Node ? html('td', {}, c) : html('td', { class: 'number' }, c)))))));

// A point that moves: its numbers as they are (`world`: numbers, or texts of exact ones), and its
// place in the picture (`at`).
const valueOf = (x) => {
  const [p, q = 1] = String(x).split('/').map(Number);
  return p / q;
};
// The part of the plane, or of two coordinates of space, that all points are in; for points within
// [-12, 12] x [-8, 8] the picture as it is.
class Frame {
  constructor(worlds) {
    const lists = worlds[0].map((_, k) => worlds.map((w) => valueOf(w[k]))), range = lists.map((list) => Math.max(...list) - Math.min(...list));
    this.axes = [...range.keys()].sort((i, j) => range[j] - range[i] || i - j).slice(0, 2).sort();
    this.hidden = [...range.keys()].filter((k) => !this.axes.includes(k));
    this.centre = [0, 0];
    this.scale = 1;
    const low = this.axes.map((k) => Math.min(...lists[k])), high = this.axes.map((k) => Math.max(...lists[k])), size = Math.max((high[0] - low[0]) / 20, (high[1] - low[1]) / 13);
    if (range.length === 2 && size > 0.4 && Math.max(...low.map((x, i) => Math.max(-x, high[i]) / [11.8, 7.8][i])) <= 1) return;
    this.scale = 1 / (size || 1);
    this.centre = low.map((x, i) => (x + high[i]) / 2);
  }
  get unit() { // so that numbers stay short: a power of two
    return 2 ** Math.round(Math.log2(1 / 64 / this.scale));
  }
  at(world) {
    return this.axes.map((k, i) => (valueOf(world[k]) - this.centre[i]) * this.scale);
  }
  // All coordinates, those of the picture first, for lengths and curvatures.
  whole(world) {
    return [...this.at(world), ...this.hidden.map((k) => valueOf(world[k]) * this.scale)];
  }
  get note() {
    return this.hidden.length === 0 ? [] : [`Two of three coordinates are drawn: ${this.axes.map((k) => 'xyz'[k]).join(' and ')}.`];
  }
  put(point, at) {
    point.at = at;
    for (const [i, k] of this.axes.entries()) {
      const old = valueOf(point.world[k]), x = at[i] / this.scale + this.centre[i], to = Math.round(x / this.unit) * this.unit;
      if (Math.abs(x - old) > this.unit / 4) point.world[k] = to;
    }
    point.at = this.at(point.world);
  }
}
const identity = new Frame([[-12, 0], [12, 0]]);
identity.scale = 1;
identity.centre = [0, 0];

// From how many pixels away a thumb, or a mouse, takes a point.
const reach = 24;

// A picture of [-12, 12] x [-8, 8] with points that move.
class Picture {
  constructor(label, points, { snap = 0, frame = identity, changed, address }) {
    Object.assign(this, { points, snap, frame, changed, address });
    for (const p of points) p.at = frame.at(p.world);
    this.under = element('g');
    this.over = element('g');
    this.svg = element('svg', { class: 'scene', viewBox: '-12 -8 24 16', role: 'group', 'aria-label': label }, this.under, this.over);
    this.circles = points.map((p, i) => {
      const c = element('circle', { class: 'point', r: 0.22, tabindex: 0, role: 'button', stroke: p.colour });
      c.addEventListener('keydown', (e) => {
        const step = (e.shiftKey ? 10 : 1) * (this.snap || 0.1), direction = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
        if (!direction) return;
        e.preventDefault();
        this.move(i, p.at.map((x, k) => x + step * direction[k]));
      });
      this.over.append(c);
      return c;
    });
    this.svg.addEventListener('pointerdown', (e) => this.grip(e));
    this.svg.addEventListener('pointermove', (e) => this.drag(e));
    for (const type of ['pointerup', 'pointercancel']) this.svg.addEventListener(type, (e) => e.pointerId === this.held?.pointer && (this.held = null));
    stage.replaceChildren(this.svg);
    this.place_circles();
  }
  // The number of the point that is nearest to the pointer, in one place the last one, which is on
  // top; -1 where none is within reach.
  near(event) {
    const at = this.place(event);
    let nearest = -1, least = reach / (this.svg.getScreenCTM().a || 1);
    for (const [i, p] of this.points.entries()) {
      const distance = Math.hypot(p.at[0] - at[0], p.at[1] - at[1]);
      if (distance <= least) [nearest, least] = [i, distance];
    }
    return nearest;
  }
  // The point keeps its distance to the pointer, so that a finger does not hide it.
  grip(event) {
    const i = this.near(event);
    if (this.held || i < 0) return;
    event.preventDefault();
    this.svg.setPointerCapture(event.pointerId);
    this.circles[i].focus({ preventScroll: true });
    const at = this.place(event);
    this.held = { i, pointer: event.pointerId, offset: this.points[i].at.map((x, k) => x - at[k]) };
  }
  drag(event) {
    if (!this.held) this.svg.style.cursor = this.near(event) < 0 ? '' : 'grab';
    else if (event.pointerId === this.held.pointer) this.move(this.held.i, this.place(event).map((x, k) => x + this.held.offset[k]));
  }
  place(event) {
    const m = this.svg.getScreenCTM().inverse(), p = new DOMPoint(event.clientX, event.clientY).matrixTransform(m);
    return [p.x, -p.y];
  }
  move(i, at) {
    const limit = [11.8, 7.8], unit = this.snap || this.frame.unit * this.frame.scale;
    const to = at.map((x, k) => Math.round(Math.min(limit[k], Math.max(-limit[k], x)) / unit) * unit);
    const old = this.points[i].at;
    if (Math.hypot(to[0] - old[0], to[1] - old[1]) < unit / 2) return;
    for (const [j, p] of this.points.entries())
      if (j === i || this.points[i].with?.includes(j)) this.frame.put(p, p.at.map((x, k) => x + to[k] - old[k]));
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
      this.work = performance.now() - begin;
    });
  }
  // The link of the page is that of what is seen: in the address a moment after the last change.
  remember() {
    clearTimeout(this.remembering);
    this.remembering = setTimeout(() => this.svg.isConnected && history.replaceState(null, '', `#${this.address()}`), 300);
  }
  place_circles() {
    for (const [i, p] of this.points.entries()) {
      if (this.circles[i].getAttribute('cx') === String(p.at[0]) && this.circles[i].getAttribute('cy') === String(-p.at[1])) continue;
      this.circles[i].setAttribute('cx', p.at[0]);
      this.circles[i].setAttribute('cy', -p.at[1]);
      this.circles[i].setAttribute('aria-label', `${p.name}, ${p.world.map((x, k) => `${'xyz'[k]} ${digits(valueOf(x))}`).join(', ')}`);
    }
    if (this.shown && this.address) this.remember();
    this.shown = true;
  }
  // Draws curves with their polygons and combs, and grid lines where points snap.
  draw(curves, { combs = true } = {}) {
    const nodes = [];
    if (this.snap) for (let k = -12; k <= 12; ++k) nodes.push(element('path', { class: 'grid', d: `M${k} -8V8${Math.abs(k) <= 8 ? ` M-12 ${k}H12` : ''}` }));
    for (const { points, weights, colour, legs } of curves) {
      if (legs) nodes.push(element('path', { class: 'leg', d: `M${line(points)}` }));
      if (combs) nodes.push(element('path', { class: 'comb', d: comb(samples(points, weights), 3) }));
      nodes.push(element('path', { class: 'curve', stroke: colour, d: `M${line(samples(points, weights).map((s) => s.x))}` }));
    }
    this.under.replaceChildren(...nodes);
  }
}

// Curvature against arc length, of curves one after the other.
function plot(chains, scale = 1) {
  const width = 480, height = 130, list = chains.map((chain) => {
    let s = 0;
    return chain.map(({ points, weights, colour }) => {
      const all = samples(points, weights).map((p) => ({ s: s + p.s, k: p.k }));
      s = all.at(-1).s;
      return { all, colour };
    });
  });
  const everything = list.flat(2).flatMap((c) => c.all), most = Math.max(0.1, ...everything.map((p) => Math.min(3, Math.abs(p.k)))), length = Math.max(...everything.map((p) => p.s)) || 1;
  const at = (p) => `${round((p.s / length) * width)} ${round(height / 2 - (Math.max(-most, Math.min(most, p.k)) / most) * (height / 2 - 8))}`;
  return html('figure', {}, element('svg', { class: 'plot', viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'Curvature against arc length' },
    element('path', { class: 'grid', d: `M0 ${height / 2}H${width}` }),
    ...list.flat().map(({ all, colour }) => element('path', { class: 'curve', stroke: colour, d: `M${all.map(at).join(' L')}` }))), html('figcaption', {}, `Curvature against arc length, up to ${digits(most * scale)}`));
}

const named = (name, worlds, colour) => worlds.map((world, i) => ({ world: [...world], name: `${name}, control point ${i}`, colour }));
// A number that moved, as the double that it is; and as a decimal, where it is one.
const written = (x) => (typeof x === 'string' || Number.isInteger(x) ? String(x) : x.toFixed(100).replace(/0+$/, ''));
const decimal = (x) => {
  const [p, q = ''] = written(x).split('/');
  let k = 0;
  while (q && k < 400 && 10n ** BigInt(k) % BigInt(q)) ++k;
  if (!q || k === 400) return q ? String(valueOf(x)) : p;
  const all = String((BigInt(p.replace('-', '')) * 10n ** BigInt(k)) / BigInt(q)).padStart(k + 1, '0'), whole = all.length - k;
  return `${p[0] === '-' ? '-' : ''}${all.slice(0, whole)}${k ? '.' : ''}${all.slice(whole)}`;
};
const numbersOf = (text) => (text ?? '').split(';').filter((x) => x !== '').map((p) => p.split(','));
const isNumber = (x) => x.length < 2000 && /^-?\d+(\.\d+)?(e-?\d+)?$|^-?\d+\/[1-9]\d*$/.test(x) && Number.isFinite(valueOf(x));
const texts = (list) => list.map((p) => p.join(',')).join(';');
// The points that the address has; otherwise the defaults. So many points, or as many as there are.
const given = (parameters, key, defaults, any = false) => {
  const list = numbersOf(parameters.get(key));
  const good = list.length > 1 && list.length <= 33 && list.every((p) => p.length === list[0].length && p.every(isNumber)) && (any ? list[0].length === 2 || list[0].length === 3 : list.length === defaults.length && list[0].length === 2);
  return good ? list : defaults;
};
const list = (parameters, key, n) => {
  const values = (parameters.get(key) ?? '').split(';');
  return values.length === n && values.every(isNumber) ? values : null;
};

// The two curves of an address, with weights and domains where it has some.
function pairOf(parameters, names, defaults, any = true) {
  let lists = ['left', 'right'].map((key, i) => given(parameters, key, defaults[i], any));
  if (lists[0][0].length !== lists[1][0].length) lists = defaults;
  const sides = lists.map((side, i) => named(names[i], side, colours[i]));
  const options = ['left', 'right'].map((key, i) => ({ weights: list(parameters, `${key}_weights`, sides[i].length), domain: list(parameters, `${key}_domain`, 2) }));
  const worlds = (i) => sides[i].map((p) => p.world), texts_of = (i) => texts(worlds(i).map((p) => p.map(written)));
  return { sides, options, worlds, points: sides.flat(), plane: lists[0][0].length === 2,
    curve: (i) => ({ control_points: worlds(i), ...options[i] }),
    drawn: (frame) => [0, 1].map((i) => ({ points: worlds(i).map((p) => frame.whole(p)), weights: options[i].weights?.map(valueOf), colour: colours[i], legs: true })),
    address: () => ['left', 'right'].map((key, i) => [`${key}=${texts_of(i)}`, ...['weights', 'domain'].flatMap((k) => (options[i][k] ? [`${key}_${k}=${options[i][k].join(';')}`] : []))].join('&')).join('&') };
}

function joinScene(snap, defaults) {
  return (parameters) => {
    const pair = pairOf(parameters, ['Left curve', 'Right curve'], defaults, !snap), { points, options, plane } = pair;
    const [n, m] = pair.sides.map((side) => side.length - 1), frame = snap ? identity : new Frame(points.map((p) => p.world));
    for (const i of [n, n + 1]) points[i].with = [n - 1, n, n + 1, n + 2].filter((j) => j !== i && (n > 1 || j !== n - 1) && (m > 1 || j !== n + 2)); // a node takes its handles along
    points[n + 1].name = 'Node, of the right curve';
    const address = () => `${snap ? 'grid' : 'join'}?${pair.address()}`;
    const picture = new Picture('Two curves that meet', points, { snap, frame, changed, address });
    const set = (p, world) => ((p.world = [...world]), (p.at = frame.at(world)));
    const update = () => (changed(), picture.place_circles());
    const align = (quiet) => {
      const d = [0, 1].map((k) => points[n].at[k] - points[n - 1].at[k]), e = [0, 1].map((k) => points[n + 2].at[k] - points[n + 1].at[k]);
      const aligned = guarded(() => gc.alignHandles(d.map((x) => x / snap), e.map((x) => x / snap), 3));
      if (!aligned) return quiet || say('The handles form no kink that moves of three units would mend.');
      set(points[n - 1], points[n].at.map((x, k) => x - snap * aligned.left[k]));
      set(points[n + 2], points[n + 1].at.map((x, k) => x + snap * aligned.right[k]));
      return null;
    };
    let magnet = null;
    if (snap) {
      magnet = html('input', { type: 'checkbox', id: 'magnet' });
      controls.append(html('button', { type: 'button', onclick: () => (align(false), update()) }, 'Make it smooth'),
        html('label', {}, magnet, ' while I drag'));
    } else if (!options[0].weights && !options[1].weights) {
      // Computations with doubles are exact where the points have few digits, so other points move
      // to the grid of the picture.
      const on_grid = (p) => set(p, p.world.map(valueOf).map((x) => (Number.isInteger((x / frame.unit) * 1024) ? x : Math.round(x / frame.unit) * frame.unit)));
      // The numbers of the points from a handle over the node to the handle that moves: on the
      // right, or on the left where the right curve has less than so many sides.
      const across = (sides) => (m < sides && n >= sides ? [n + 2, n + 1, n, n - 1] : [n - 1, n, n + 1, n + 2]);
      // Puts the handle behind the node on the line of the one before it, as long as it was but for
      // a number of four bits times `odd`. Returns this line and the ratio of the lengths.
      const straighten = ([handle, node, other, moved], odd = 1) => {
        for (const i of [handle, node]) on_grid(points[i]);
        const d = points[node].world.map((x, k) => x - points[handle].world[k]), e = points[moved].world.map((x, k) => valueOf(x) - valueOf(points[other].world[k]));
        if (d.every((x) => x === 0)) return (update(), say(strong('A handle lies at its node', false), 'There is no tangent to go on with.'), null);
        const length = Math.hypot(...e) / Math.hypot(...d) || 1, step = odd * 2 ** (Math.floor(Math.log2(length / odd)) - 3), ratio = Math.round(length / step) * step;
        set(points[other], points[node].world);
        set(points[moved], points[node].world.map((x, k) => x + ratio * d[k]));
        return { d, ratio };
      };
      controls.append(html('button', { type: 'button', onclick: () => straighten(across(2)) && update() }, 'Make it G1'));
      if (Math.max(n, m) > 2)
        controls.append(html('button', { type: 'button', onclick: () => {
          // of points f0, f1, f2 of degree p before the node and g0 = f0, g1, g2 of degree q behind
          // it: g2 - 2 g1 + g0 = ratio^2 top / bottom (f2 - 2 f1 + f0) + free (f0 - f1)
          const numbers = across(3), step = numbers[3] - numbers[2], [p, q] = step > 0 ? [n, m] : [m, n], top = q * (p - 1), bottom = p * (q - 1);
          const divisor = (a, b) => (b ? divisor(b, a % b) : a), odd_part = (x) => (x % 2 ? x : odd_part(x / 2));
          if (p > 1) on_grid(points[numbers[0] - step]);
          const line = straighten(numbers, odd_part(bottom / divisor(bottom, top)));
          if (!line) return;
          const [f0, f1, f2, g1] = [numbers[1], numbers[0], numbers[0] - (p > 1 ? step : 0), numbers[3]].map((k) => points[k].world), second = points[numbers[3] + step], { d, ratio } = line;
          const from = g1.map((x, k) => 2 * x - f0[k] + ((ratio * ratio * top) / bottom) * (f2[k] - 2 * f1[k] + f0[k]));
          // the nearest such point, of short numbers
          const free = dot(second.world.map((x, k) => valueOf(x) - from[k]), d) / dot(d, d), grain = 2 ** Math.round(Math.log2(frame.unit / Math.hypot(...d)));
          set(second, from.map((x, k) => x + Math.round(free / grain) * grain * d[k]));
          update();
        } }, 'Make it G2'));
      if (n === m && n > 1 && !options[0].domain && !options[1].domain)
        controls.append(html('button', { type: 'button', onclick: () => {
          for (const i of [n - 2, n - 1, n]) on_grid(points[i]);
          const [a, b, c] = [points[n - 2].world, points[n - 1].world, points[n].world], first = c.map((x, k) => 2 * x - b[k]);
          set(points[n + 1], c);
          set(points[n + 2], first);
          set(points[n + 3], first.map((x, k) => 2 * x + a[k] - 2 * b[k]));
          update();
        } }, 'Make it C2'));
    }
    // the join of a drawing that was opened here
    const source = open_drawing?.join && open_drawing.join.address === location.hash ? open_drawing : null;
    if (source)
      controls.append(html('button', { type: 'button', onclick: () => {
        source.outlines.replace([source.join.left, source.join.right], [0, 1].map(pair.worlds));
        open_drawing = { text: source.outlines.drawing() };
        location.hash = 'drawing';
      } }, 'Put it back into the drawing'));
    function changed() {
      if (magnet?.checked) align(true);
      const curves = pair.drawn(frame);
      picture.draw(curves);
      if (source) source.join.address = `#${address()}`;
      guarded(() => {
        const [a, b] = [0, 1].map(pair.curve), join = gc.continuity(a, b), d = gc.deviation(a, b);
        const grade = plane && !a.weights && !b.weights ? gc.joinGrade(a, b) : null, word = grade?.grade && !/^G/.test(grade.grade) && join.c_order >= 0 ? `, ${grade.grade}` : '';
        say(strong(`${orders(join)}${word}`, join.g_order >= 1),
          `β = ${join.betas.length ? shown(`(${join.betas.join(', ')})`) : 'none'}`,
          `angle ${bounds(d.angle_degrees, '°')}${grade ? `, a handle is off by ${bounds(grade.handle_offset)}` : ''}`,
          `jump of the curvature ${bounds(d.curvature_percent, ' %')}, gap ${bounds(d.gap)}`,
          ...frame.note, ...(source ? source.outlines.beside([source.join.left, source.join.right], [0, 1].map(pair.worlds)) : []));
      });
      details.replaceChildren(plot([curves], frame.scale));
    }
    changed();
  };
}

function blendScene(parameters) {
  const pair = pairOf(parameters, ['First curve', 'Second curve'], [[[-11, -5], [-9, 3], [-6, 5], [-3, 4]], [[3, -3], [6, -6], [8, -2], [11, 5]]]);
  const names = ['fair', 'energy3', 'energy2', 'c2', 'normal', 'min_second', 'near_line', 'fair_g3', 'energy4_g3', 'c3'], frame = new Frame(pair.points.map((p) => p.world));
  const wanted = new Set((parameters.get('strategies') ?? 'normal,energy3,fair').split(',').filter((n) => names.includes(n)));
  const box = (name, checked, act) => {
    const input = html('input', { type: 'checkbox', checked, onchange: () => (act?.(input.checked), changed(), picture.remember()) });
    controls.append(html('label', {}, input, ` ${name}`));
    return input;
  };
  for (const name of names) box(name, wanted.has(name), (checked) => (checked ? wanted.add(name) : wanted.delete(name)));
  const plain = box('β = η = 1, the speed of the curves', parameters.get('shape') === '1,1');
  const picture = new Picture('Two curves and blends between them', pair.points, { frame, changed,
    address: () => `blend?${pair.address()}&strategies=${[...wanted].join(',')}${plain.checked ? '&shape=1,1' : ''}` });
  function changed() {
    const ends = pair.drawn(frame);
    guarded(() => {
      const blends = [...wanted].map((strategy) => ({ ...gc.blend(pair.curve(0), pair.curve(1), { strategy, ...(plain.checked ? { beta: 1, eta: 1 } : {}) }), colour: colours[2 + names.indexOf(strategy)] }));
      for (const b of blends) b.drawn = { points: b.curve.points.map((p) => frame.whole(p)), colour: b.colour };
      picture.draw([...ends, ...blends.map((b) => b.drawn)]);
      const proved = blends.length > 0 && blends.every((b) => Math.min(b.start_join.g_order, b.end_join.g_order) >= 2);
      say(strong(blends.length === 0 ? 'Choose a strategy' : proved ? 'Every join is proved' : 'A join is not smooth', proved),
        ...blends.map((b) => html('p', { style: `color: ${b.colour}` }, `${b.strategy}: ${orders(b.start_join)} and ${orders(b.end_join)}, fairness ${b.fairness === null ? '∞' : digits(b.fairness)}`)), ...frame.note);
      details.replaceChildren(plot(blends.map((b) => [ends[0], b.drawn, ends[1]]), frame.scale),
        tableOf(['strategy', 'β', 'η'], blends.map((b) => [b.strategy, shown(b.shape.beta), shown(b.shape.eta)])));
    });
  }
  changed();
  return null;
}

function cornerScene(parameters) {
  const worlds = given(parameters, 'points', [[-9, -5], [-2, 5], [9, -3]]);
  const points = worlds.map((world, i) => ({ world: [...world], name: ['Start', 'Corner', 'End'][i], colour: colours[i % 2] }));
  const within = (key, most, otherwise) => (isNumber(parameters.get(key) ?? '') ? Math.max(0, Math.min(most, Number(parameters.get(key)))) : otherwise);
  const slider = (name, value, most, step) => {
    const number = html('output', {}, String(value)), input = html('input', { type: 'range', min: 0, max: most, step, value, 'aria-label': name, oninput: () => ((number.textContent = input.value), changed(), picture.remember()) });
    controls.append(html('label', {}, `${name} `, input, ' ', number));
    return input;
  };
  const radius = slider('Radius', within('radius', 6, 2.5), 6, 0.05), smoothing = slider('Smoothing in percent', within('smoothing', 100, 60), 100, 1);
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
  const picture = new Picture('A corner and what it becomes', points, { changed,
    address: () => `corner?points=${texts(points.map((p) => p.world))}&radius=${radius.value}&smoothing=${smoothing.value}` });
  function changed() {
    const [a, b, c] = points.map((p) => p.at), legs = [a, c].map((p) => Math.hypot(p[0] - b[0], p[1] - b[1]));
    const cosine = ((a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1])) / (legs[0] * legs[1]), half = Math.acos(Math.max(-1, Math.min(1, cosine))) / 2;
    // where a circle of this radius would begin, and as much farther as the smoothing says
    const wanted = (Number(radius.value) / Math.tan(half)) * (1 + Number(smoothing.value) / 100), most = 0.95 * Math.min(...legs), distance = Math.min(wanted, most);
    const lines = [[a, b], [b, c]];
    if (!(distance > 1e-6)) {
      picture.draw(lines.map((points, i) => ({ points, colour: colours[i] })));
      return say('A corner', 'Radius 0 leaves it as it is.');
    }
    guarded(() => {
      const r = gc.roundCorner(lines[0], lines[1], distance);
      const parts = [r.left.points, r.blend.curve.points, r.right.points];
      picture.draw(parts.map((points, i) => ({ points, colour: colours[[0, 2, 1][i]] })));
      picture.under.prepend(element('path', { class: 'leg', d: `M${line([a, b, c])}` }));
      say(strong(`${orders(r.blend.start_join)} and ${orders(r.blend.end_join)}`, r.blend.start_join.g_order >= 2),
        `cut off at the distance ${digits(distance)} along both sides${wanted > most ? ', which is all that the shorter one has room for' : ''}; the curvature is continuous, exactly`);
      const path = parts.map((p, i) => pathData(p, i === 0)).join('').trim();
      details.replaceChildren(plot([parts.map((points, i) => ({ points, colour: colours[[0, 2, 1][i]] }))]),
        html('label', {}, 'The path as cubics, rounded to three decimals: no longer exact', html('textarea', { readonly: true, spellcheck: 'false' }, path)));
    });
    return null;
  }
  changed();
}

const svgText = (paths, attributes = {}) => new XMLSerializer().serializeToString(element('svg', attributes, ...paths.map((p) => element('path', { ...p, fill: 'none', stroke: 'currentColor' })))).replaceAll('<path', '\n<path').replace('</svg>', '\n</svg>\n');

// The outlines of a drawing or of a glyph, its kinks marked. Points are dragged where there are no
// arcs; nothing but what moves is drawn anew.
class Outlines {
  // subpaths: { closed, curves: [{ points: [[x, y], …], weights, exact }] }, y downwards unless
  // `up`.
  constructor(subpaths, label, { up = false, dragged = null, edited = null }) {
    Object.assign(this, { subpaths, up, dragged });
    this.curves = subpaths.flatMap((p) => p.curves);
    let base = 0;
    for (const { closed, curves } of subpaths) {
      for (const [i, c] of curves.entries()) Object.assign(c, { before: i > 0 || closed ? base + ((i + curves.length - 1) % curves.length) : -1, behind: i + 1 < curves.length || closed ? base + ((i + 1) % curves.length) : -1 });
      base += curves.length;
    }
    const all = this.curves.flatMap((c) => c.points), sides = [0, 1].map((k) => all.reduce(([low, high], p) => [Math.min(low, this.y(p, k)), Math.max(high, this.y(p, k))], [Infinity, -Infinity]));
    const size = Math.max(sides[0][1] - sides[0][0], sides[1][1] - sides[1][0]) || 1, margin = 0.04 * size;
    this.size = Number.isFinite(size) ? size : 1;
    this.decimals = Math.max(0, Math.min(12, Math.ceil(Math.log10(4000 / this.size))));
    this.still = element('path', { class: 'outline' });
    this.moving = element('path', { class: 'outline moving' });
    this.nodes = element('path', { class: 'nodes' });
    this.handles = element('path', { class: 'legs' });
    this.marks = element('g');
    this.svg = element('svg', { class: 'scene drawing', role: 'group', 'aria-label': label, viewBox: all.length === 0 ? '0 0 1 1' : `${sides[0][0] - margin} ${sides[1][0] - margin} ${sides[0][1] - sides[0][0] + 2 * margin} ${sides[1][1] - sides[1][0] + 2 * margin}` },
      this.still, this.handles, this.moving, this.nodes, this.marks);
    this.editable = edited && this.curves.every((c) => !c.weights);
    this.draw(this.still, subpaths.map((p) => p.curves));
    if (this.editable) {
      this.draw_nodes();
      this.svg.addEventListener('pointerdown', (e) => this.grip(e));
      this.svg.addEventListener('pointermove', (e) => this.drag(e));
      for (const type of ['pointerup', 'pointercancel']) this.svg.addEventListener(type, () => this.held && ((this.held = null), edited()));
    } else this.svg.style.touchAction = 'auto';
  }
  y(p, k) {
    return k === 1 && this.up ? -p[1] : p[k];
  }
  text(p) {
    return `${p[0]} ${this.up ? -p[1] : p[1]}`;
  }
  piece({ points, weights }, first) {
    const start = first ? `M${this.text(points[0])}` : '';
    if (weights) return start + samples(points, weights, 24).slice(1).map((s) => `L${this.text(s.x)}`).join('');
    return start + ' LQC'[points.length - 1] + points.slice(1).map((p) => this.text(p)).join(' ');
  }
  // Puts control points in the place of those of two curves that meet, and of the ends of their
  // neighbours.
  replace(numbers, sides) {
    for (const [i, k] of numbers.entries()) this.curves[k].exact = texts(sides[i].map((p) => p.map(decimal)));
    const ends = ([k, i], [l, j]) => {
      if (k < 0) return;
      const points = numbersOf(this.curves[k].exact);
      points[i < 0 ? points.length - 1 : 0] = numbersOf(this.curves[l].exact).at(j);
      this.curves[k].exact = texts(points);
    };
    const [left, right] = numbers;
    ends([this.curves[left].before, -1], [left, 0]);
    ends([this.curves[right].behind, 0], [right, -1]);
  }
  // Returns the joins next to two curves that get these control points, since a second handle may
  // belong to the next node.
  beside([left, right], [a, b]) {
    const { before } = this.curves[left], { behind } = this.curves[right], points = (k) => (k === left ? a : k === right ? b : numbersOf(this.curves[k].exact));
    const joins = [...(before < 0 ? [] : [[[...points(before).slice(0, -1), a[0]], a]]), ...(behind < 0 ? [] : [[b, [b.at(-1), ...points(behind).slice(1)]]])];
    return joins.length === 0 ? [] : [`Beside it in the drawing: ${joins.map((sides) => gc.joinGrade(...sides).grade ?? 'undecided').join(' and ')}.`];
  }
  // The drawing as the outlines that it has.
  drawing() {
    const elements = new Map();
    for (const p of this.subpaths.filter(({ curves }) => curves.length > 0)) {
      const lists = p.curves.map((c) => numbersOf(c.exact).map((x) => x.map(decimal).join(' '))), d = `M${lists[0][0]}${lists.map((list) => ' LQC'[list.length - 1] + list.slice(1).join(' ')).join('')}${p.closed ? 'Z' : ''}`;
      const key = `${p.element} ${p.line} ${p.id}`;
      elements.set(key, { id: p.id, d: (elements.get(key)?.d ?? '') + d });
    }
    return svgText([...elements.values()].map(({ id, d }) => ({ ...(id ? { id } : {}), d })), { viewBox: this.svg.getAttribute('viewBox') });
  }
  draw(path, chains) {
    path.setAttribute('d', chains.map((curves) => curves.map((c, i) => this.piece(c, i === 0)).join('')).join(''));
  }
  draw_nodes() {
    this.nodes.setAttribute('d', this.curves.map((c) => `M${this.text(c.points[0])}h0${c.behind < 0 ? `M${this.text(c.points.at(-1))}h0` : ''}`).join(''));
    if (this.curves.length <= 60) this.handles.setAttribute('d', this.curves.filter((c) => c.points.length > 2).map(({ points: p }) => `M${this.text(p[0])}L${this.text(p[1])}M${this.text(p.at(-1))}L${this.text(p.at(-2))}`).join(''));
  }
  mark(joins, opened) {
    this.marks.replaceChildren(...joins.slice(0, 200).map(({ point, label, left, right }) => {
      const act = () => opened(left, right), c = element('circle', { class: 'mark', r: this.size / 60, cx: point[0], cy: this.up ? -point[1] : point[1], tabindex: 0, role: 'button', 'aria-label': label }, element('title', {}, label));
      c.addEventListener('pointerdown', (e) => e.stopPropagation());
      c.addEventListener('click', act);
      c.addEventListener('keydown', (e) => (e.key === 'Enter' || e.key === ' ') && (e.preventDefault(), act()));
      return c;
    }));
  }
  // Takes the point that is next to the pointer, nodes first: it takes its handles along.
  grip(event) {
    const at = this.place(event), near = reach / (this.svg.getScreenCTM().a || 1);
    let best = null, least = Infinity;
    for (const [i, { points }] of this.curves.entries())
      for (const [j, p] of points.entries()) {
        const is_node = j === 0 || j === points.length - 1, distance = Math.hypot(p[0] - at[0], p[1] - at[1]);
        if (distance <= near && distance * (is_node ? 0.5 : 1) < least) [best, least] = [{ i, j }, distance * (is_node ? 0.5 : 1)];
      }
    if (!best) return;
    event.preventDefault();
    this.svg.setPointerCapture(event.pointerId);
    const held = [], c = this.curves[best.i], last = c.points.length - 1;
    const take = (i, j) => i >= 0 && held.push([this.curves[i].points, j]);
    const take_side = (i, is_end) => {
      if (i < 0) return;
      const n = this.curves[i].points.length - 1;
      take(i, is_end ? n : 0);
      if (n > 1) take(i, is_end ? n - 1 : 1);
    };
    if (best.j === 0) take_side(best.i, false), take_side(c.before, true);
    else if (best.j === last) take_side(best.i, true), take_side(c.behind, false);
    else take(best.i, best.j);
    const touched = [...new Set([best.i, ...(best.j === 0 ? [c.before] : best.j === last ? [c.behind] : [])])].filter((i) => i >= 0), others = new Set(touched);
    this.held = { from: at, points: [...new Map(held.map(([points, j]) => [points[j], { points, j, at: [...points[j]] }])).values()], touched };
    for (const i of touched) for (const k of [this.curves[i].before, this.curves[i].behind]) if (k >= 0) others.add(k);
    this.around = [...others];
    // what does not move is drawn once
    const chains = [], moving = new Set(touched.map((i) => this.curves[i]));
    for (const { curves } of this.subpaths) {
      let chain = [];
      for (const curve of curves)
        if (moving.has(curve)) chain.length && chains.push(chain), (chain = []);
        else chain.push(curve);
      if (chain.length) chains.push(chain);
    }
    this.draw(this.still, chains);
    this.draw(this.moving, touched.map((i) => [this.curves[i]]));
    this.svg.classList.add('dragging');
  }
  place(event) {
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
    return [p.x, this.up ? -p.y : p.y];
  }
  drag(event) {
    if (!this.held) return;
    this.to = this.place(event);
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => {
      this.pending = false;
      if (!this.held) return;
      const begin = performance.now(), power = 10 ** this.decimals, move = this.to.map((x, k) => x - this.held.from[k]);
      for (const { points, j, at } of this.held.points) points[j] = at.map((x, k) => Math.round((x + move[k]) * power) / power);
      for (const i of this.held.touched) this.curves[i].exact = texts(this.curves[i].points);
      this.draw(this.moving, this.held.touched.map((i) => [this.curves[i]]));
      this.dragged(this.around);
      this.work = performance.now() - begin;
    });
  }
}

// The drawing, or the font, that is open: it stays while other scenes are shown.
let open_drawing = null;

function drawingScene(parameters) {
  const example = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 120 60">\n<path id="wave" fill="none" stroke="#0b62c4" stroke-width="3"\n  d="M5 30 C15 10 25 8 35 20 C45 33 55 52 70 40 C85 27 95 12 115 30"/>\n</svg>\n';
  const text = html('textarea', { 'aria-label': 'The drawing as SVG', spellcheck: 'false' });
  const place = html('div', {}), file = html('input', { type: 'file', accept: '.svg,.ttf,.otf,.woff,.pfb,image/svg+xml,font/*', 'aria-label': 'A drawing or a font' });
  let report = null, outlines = null;
  text.value = open_drawing?.text ?? example;
  if (parameters.has('d')) { // a link to a path
    text.value = svgText([{ d: parameters.get('d') }]);
    open_drawing = null;
    history.replaceState(null, '', '#drawing');
  }
  const failed = (error) => {
    say(strong(error.code ?? 'error', false), error.message);
    for (const e of [place, details]) e.replaceChildren();
  };
  const sides_of = (left, right) => [left, right].map((i) => outlines.curves[i].exact).filter((x) => x !== undefined);
  const opened = (left, right) => {
    const sides = sides_of(left, right);
    if (sides.length < 2) return;
    const address = `#join?left=${sides[0]}&right=${sides[1]}`;
    if (outlines.editable && open_drawing.outlines === outlines) open_drawing.join = { left, right, address };
    location.hash = address;
  };
  const commands = (j) => {
    const text = `${j.left_command} ${j.left_letter} – ${j.right_command} ${j.right_letter}`;
    return sides_of(j.left, j.right).length === 2 ? html('button', { type: 'button', title: 'Open it as a join', onclick: () => opened(j.left, j.right) }, text) : text;
  };
  const conclude = (grades) => {
    const count = (grade) => grades.reduce((n, g) => n + (g === grade), 0), kinks = count('kink');
    say(strong(kinks === 0 ? 'No kinks' : counted(kinks, 'kink'), kinks === 0),
      `${counted(grades.length, 'join')} in ${counted(outlines.subpaths.length, 'subpath')}, ${counted(count('corner'), 'corner')}, ${count(null)} undecided`,
      ...(outlines.editable ? [] : ['A drawing with arcs is not dragged.']));
  };
  const curves_of = (numbers) => numbers.map((c) => ({ ...c, points: c.points.flatMap((x, i, all) => (i % 2 ? [] : [[x, all[i + 1]]])) }));
  const show = (besides = []) => {
    const drawing = text.value;
    if (open_drawing?.text !== drawing) open_drawing = { text: drawing };
    for (const b of of_drawings) b.disabled = false;
    return latest(async () => {
      const module = await files();
      return [await module.verifySvg(drawing), await module.svgCurves(drawing)];
    }, ([report, { subpaths }]) => {
      const grades = report.joins.map((j) => j.grade), at = new Map(report.joins.map((j, k) => [j.left, k]));
      outlines = new Outlines(subpaths.map((p) => ({ ...p, curves: curves_of(p.curves) })), 'The outlines of the drawing; its kinks are marked', {
        edited,
        dragged: (around) => {
          for (const i of around) {
            const k = at.get(i), c = outlines.curves[i];
            if (k !== undefined) grades[k] = gc.joinGrade(exactly(c), exactly(outlines.curves[c.behind])).grade;
          }
          conclude(grades);
        } });
      open_drawing.outlines = outlines;
      place.replaceChildren(outlines.svg);
      conclude(grades);
      verdict.append(...besides.map((line) => html('p', {}, line)));
      // kinks first, the largest before others
      const kink = (j) => (j.grade === 'kink' ? (j.angle_degrees?.[0] ?? 0) : -1);
      const bad = report.joins.filter((j) => j.grade !== 'G2').sort((a, b) => kink(b) - kink(a));
      const label = (j) => `${j.grade ?? 'undecided'}${j.angle_degrees ? ` of ${bounds(j.angle_degrees, '°')}` : ''}, ${j.element}${j.id ? ` ${j.id}` : ''}, commands ${j.left_command} – ${j.right_command}`;
      outlines.mark(report.joins.filter((j) => j.grade === 'kink').map((j) => ({ point: outlines.curves[j.right].points[0], label: `${label(j)}: open it as a join`, left: j.left, right: j.right })), opened);
      details.replaceChildren(tableOf(['element', 'commands', 'grade', 'angle'], bad.slice(0, 200).map((j) => [`${j.element}${j.id ? ` ${j.id}` : ''}, line ${j.line}`, commands(j), j.grade ?? 'undecided', j.angle_degrees ? bounds(j.angle_degrees, '°') : ''])));
    }, failed);
  };
  const mend = () => latest(async () => (await files()).repairSvg(text.value), ({ svg, report: { moves, not_repaired: left, largest_move } }) => {
    const handles = moves.length === 1 ? '1 handle has' : `${moves.length} handles have`;
    text.value = svg;
    show([moves.length === 0 ? 'No handle moves.' : `${handles} moved, by at most ${bounds(largest_move)} of the last decimal.`,
      ...left.slice(0, 1).map((x) => `Not mended: ${left.length}. The first, at curve ${x.curve} of ${x.element}${x.id ? ` ${x.id}` : ''}: ${x.reason}. Drag the handles of what is left.`)]);
  }, failed);
  const exactly = (curve) => numbersOf(curve.exact);
  // Puts the dragged points into the drawing, which becomes its outlines.
  const edited = () => {
    text.value = outlines.drawing();
    return show();
  };
  // A font: its glyphs with kinks, each of which is shown.
  const show_font = (bytes, name) => {
    open_drawing = { font: bytes, name };
    for (const b of of_drawings) b.disabled = true;
    const contours_of = async (glyph) => [glyph, (await (await files()).fontCurves(bytes, { glyphs: `#${glyph.index}` })).glyphs[0].contours];
    const show_glyph = ([glyph, contours]) => {
      outlines = new Outlines(contours.map((curves) => ({ closed: true, curves: curves_of(curves).map((c) => ({ ...c, exact: texts(c.points) })) })), `Glyph ${glyph.name}; its kinks are marked`, { up: true });
      place.replaceChildren(outlines.svg);
      const starts = new Map(outlines.curves.map((c, i) => [`${c.points[0]}`, i]));
      outlines.mark(glyph.worst.flatMap(({ point, grade, angle_degrees }) => {
        const right = starts.get(`${point.map(Number)}`);
        return right === undefined ? [] : [{ point, label: `${grade} of ${bounds(angle_degrees, '°')}: open it as a join`, left: outlines.curves[right].before, right }];
      }), opened);
    };
    return latest(async () => {
      const font = await (await files()).verifyFont(bytes, { worst: 8 }), bad = font.glyphs.filter((g) => g.kinks + g.bends > 0).sort((a, b) => b.kinks - a.kinks).slice(0, 300);
      const first = bad[0] ?? font.glyphs.find((g) => g.joins > 0);
      return { font, bad, first: first && (await contours_of(first)) };
    }, ({ font: { name: itself, summary: s }, bad, first }) => {
      say(strong(s.kinks === 0 ? 'No kinks' : counted(s.kinks, 'kink'), s.kinks === 0), `${itself || name}: ${counted(s.joins, 'join')} of ${counted(s.glyphs, 'glyph')}, ${counted(s.corners, 'corner')}, ${s.rounding} rounded by a unit`);
      details.replaceChildren(...(bad.length === 0 ? [] : [tableOf(['glyph', 'kinks', 'bends', 'joins'], bad.map((g) => [html('button', { type: 'button', onclick: () => latest(() => contours_of(g), show_glyph, failed) }, g.name), g.kinks, g.bends, g.joins]))]));
      text.value = '';
      place.replaceChildren();
      if (first) show_glyph(first);
    }, failed);
  };
  const take = (f) => f && latest(() => f.arrayBuffer(), (bytes) => {
    if (/\.(ttf|otf|woff|pfb|pfa|ttc|otc|t1)$/i.test(f.name)) return show_font(new Uint8Array(bytes), f.name);
    text.value = new TextDecoder().decode(bytes);
    return show();
  }, failed);
  file.addEventListener('change', () => take(file.files[0]));
  text.addEventListener('change', () => show());
  const of_drawings = [html('button', { type: 'button', onclick: mend }, 'Mend the kinks'), html('button', { type: 'button', onclick: () => {
    const link = html('a', { href: URL.createObjectURL(new Blob([text.value], { type: 'image/svg+xml' })), download: 'drawing.svg' });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  } }, 'Save')];
  controls.append(file, ...of_drawings, html('button', { type: 'button', onclick: () => {
    file.value = '';
    text.value = example;
    show();
  } }, 'The example'));
  stage.replaceChildren(place, text);
  stage.ondragover = (e) => (e.preventDefault(), stage.classList.add('over'));
  stage.ondragleave = () => stage.classList.remove('over');
  stage.ondrop = (e) => (e.preventDefault(), stage.classList.remove('over'), (file.files = e.dataTransfer.files), take(e.dataTransfer.files[0]));
  if (open_drawing?.font) show_font(open_drawing.font, open_drawing.name);
  else show();
}

// The two nets of an address, `left=x,y,z;x,y,z:x,y,z;x,y,z&right=…`, a colon between rows; null
// where there are none. They meet along the last row of the left and the first of the right one.
function netsOf(parameters) {
  if (!parameters.has('left') && !parameters.has('right')) return null;
  return ['left', 'right'].map((key) => {
    const rows = (parameters.get(key) ?? '').split(':').map(numbersOf), refuse = (reason) => {
      throw new Error(`The ${key} net ${reason}.`);
    };
    const bad = rows.flat().find((p) => p.length !== 3 || !p.every(isNumber));
    if (bad) refuse(`has a point that is not three numbers: ${shown(bad.join(','))}`);
    if (rows.length < 2 || rows.some((row) => row.length < 2)) refuse('has less than two rows of two points: x,y,z;x,y,z:x,y,z;x,y,z');
    const other = rows.find((row) => row.length !== rows[0].length);
    if (other) refuse(`has rows of ${rows[0].length} and of ${other.length} points`);
    if (Math.max(rows.length, rows[0].length) > 17) refuse('has a degree above 16');
    return rows;
  });
}

function surfaceScene(parameters) {
  const canvas = html('canvas', { width: 720, height: 480, tabindex: 0, role: 'img', 'aria-label': 'Two patches with isophotes; the arrow keys turn them' });
  let given_nets = null;
  try {
    given_nets = netsOf(parameters);
  } catch (error) {
    return say(strong('No patches', false), error.message);
  }
  stage.replaceChildren(canvas);
  const nets = given_nets ? () => given_nets : slidingNets(parameters, () => changed());
  // The values and the derivatives of the Bernstein polynomials of a degree, these divided by it.
  const bernstein = (degree, t) => {
    let b = [1], lower = [];
    for (let k = 1; k <= degree; ++k) [lower, b] = [b, Array.from({ length: k + 1 }, (_, i) => (1 - t) * (b[i] ?? 0) + t * (b[i - 1] ?? 0))];
    return [b, b.map((_, i) => (lower[i - 1] ?? 0) - (lower[i] ?? 0))];
  };
  const size = 100, parameter = Array.from({ length: size + 1 }, (_, k) => k / size);
  const combined = (weights, points) => [0, 1, 2].map((k) => points.reduce((sum, p, i) => sum + weights[i] * p[k], 0));
  // Points and unit normals of a patch, size + 1 of them both ways.
  const gridOf = (net) => {
    const [along_u, along_v] = [net, net[0]].map((list) => parameter.map((t) => bernstein(list.length - 1, t)));
    const columns = along_v.map((both) => both.map((weights) => net.map((row) => combined(weights, row))));
    return along_u.map(([b, db]) => columns.map(([points, across]) => {
      const du = combined(db, points), dv = combined(b, across);
      const n = [du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0]], l = Math.hypot(...n) || 1;
      return { x: combined(b, points), n: n.map((c) => c / l) };
    }));
  };
  let turn = 0.7, tilt = 0.9, grids = [], edge = [], centre = [0, 0, 0], scale = 1;
  function paint() {
    const c = canvas.getContext('2d'), quads = [];
    const [ct, st, ce, se] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const view = (p) => {
      const [x, y, z] = p.map((c, k) => scale * (c - centre[k])), px = ct * x - st * y, py = st * x + ct * y;
      return [360 + px, 240 - (se * z + ce * py), py * se - z * ce];
    };
    for (const grid of grids) {
      for (const row of grid) for (const p of row) p.view = view(p.x);
      for (let i = 0; i < size; ++i)
        for (let j = 0; j < size; ++j) {
          const corners = [grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]], n = [0, 1, 2].map((k) => corners.reduce((s, p) => s + p.n[k], 0) / 4);
          const light = 0.45 * n[0] + 0.3 * n[1] + 0.84 * n[2], stripe = Math.sin(light * 45) > 0;
          const points = corners.map((p) => p.view);
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
    for (const [j, { view: p }] of edge.entries()) j ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1]);
    c.stroke();
    c.lineWidth = 1;
  }
  function changed() {
    const [a, b] = nets();
    guarded(() => {
      const e = gc.edgeContinuity(a, 'u1', b, 'u0'), part = e.whole_a && e.whole_b ? 'the whole edge' : 'the part of the edge that both have';
      const drawn = [a, e.reversed ? b.map((row) => [...row].reverse()) : b].map((net) => net.map((row) => row.map((p) => p.map(valueOf))));
      const most = Math.max(...drawn.flat(3).map(Math.abs)) || 1; // so that products neither overflow nor vanish
      grids = drawn.map((net) => gridOf(net.map((row) => row.map((p) => p.map((x) => x / most)))));
      const points = grids.flat(2).map((p) => p.x), ranges = [0, 1, 2].map((k) => points.reduce(([low, high], p) => [Math.min(low, p[k]), Math.max(high, p[k])], [Infinity, -Infinity]));
      centre = ranges.map(([low, high]) => (low + high) / 2);
      scale = 260 / (points.reduce((r, p) => Math.max(r, Math.hypot(...p.map((x, k) => x - centre[k]))), 0) || 1);
      edge = e.g_order < 0 ? [] : e.whole_a ? grids[0].at(-1) : grids[1][0];
      paint();
      if (e.g_order < 0) return say(strong('No common edge', false), 'The last row of the left net and the first row of the right one are not the points of one curve.');
      const stripes = { crease: 'The stripes jump at the edge.', curvature: 'The stripes meet, with kinks at the edge.', none: 'The stripes go on smoothly.' }[e.defect];
      return say(strong(e.collapsed ? 'The edge is a point' : `G${e.is_g3 ? 3 : e.g_order} along ${part}`, e.g_order >= 1),
        e.defect === 'none' ? 'Tangent planes and curvatures agree.' : `The defect: ${e.defect.replace('_', ' ')}.`,
        ...(e.largest_angle_degrees === null ? [] : [`The angle of the normals is at most ${digits(e.largest_angle_degrees)}°.`]),
        ...(stripes ? [stripes] : []));
    });
  }
  let from = null;
  canvas.style.touchAction = 'none';
  const turned = (by, up) => {
    turn += by;
    tilt = Math.max(0.1, Math.min(1.5, tilt + up));
    paint();
  };
  canvas.addEventListener('pointerdown', (e) => (canvas.setPointerCapture(e.pointerId), (from = [e.clientX, e.clientY])));
  canvas.addEventListener('pointermove', (e) => {
    if (!from) return;
    turned((e.clientX - from[0]) / 150, (e.clientY - from[1]) / 150);
    from = [e.clientX, e.clientY];
  });
  canvas.addEventListener('pointerup', () => (from = null));
  canvas.addEventListener('keydown', (e) => {
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[e.key];
    if (!step) return;
    e.preventDefault();
    turned(...step);
  });
  changed();
}

// Two patches whose second and third rows of points move, by sliders and buttons; what they are
// now.
function slidingNets(parameters, changed) {
  const slider = (name, key) => {
    const number = html('output', {}), input = html('input', { type: 'range', min: -4, max: 4, step: 1, value: Number(parameters.get(key)) || 0, 'aria-label': name, oninput: () => changed(), onchange: () => remember() });
    controls.append(html('label', {}, `${name} `, input, ' ', number));
    return { input, number, get value() { return input.value; } };
  };
  for (const [name, ...values] of [['G0', 1, 0], ['G1', 0, 2], ['G2', 0, 0]])
    controls.append(html('button', { type: 'button', onclick: () => {
      [first.input.value, second.input.value] = values;
      changed();
      remember();
    } }, `Show ${name}`));
  const first = slider('Second row of points', 'second'), second = slider('Third row of points', 'third');
  const remember = () => history.replaceState(null, '', `#surfaces?second=${first.value}&third=${second.value}`);
  const a = [[0, 1, 1, 0], [1, 2, 2, 1], [2, 3, 3, 1], [2, 3, 2, 1]].map((row, i) => row.map((z, j) => [i - 3, j - 1.5, z / 4]));
  const p = [3, 2, 1, 0].map((i) => a[i]), mirror = (x, y, k) => x.map((c, i) => 2 * c - y[i] + (i === 2 ? k : 0));
  return () => {
    for (const { number, value } of [first, second]) number.textContent = value;
    const rows = [p[0], p[0].map((x, j) => mirror(x, p[1][j], Number(first.value) / 8))];
    rows.push(rows[1].map((x, j) => x.map((c, i) => 2 * c - 2 * p[1][j][i] + p[2][j][i] + (i === 2 ? Number(second.value) / 8 : 0))));
    rows.push(rows[2].map((x, j) => x.map((c, i) => 2 * c - rows[1][j][i])));
    return [a, rows];
  };
}

const scenes = {
  join: ['A join', joinScene(0, [[[-10, -3], [-7, 3], [-4, 4], [0, 2]], [[0, 2], [3, 0.5], [6, -4], [10, -2]]]),
    'Two curves that meet: drag a point and read how smoothly. C: derivatives agree. G: tangents (G1), and curvatures (G2), as the eye sees them. F: Frenet frames.'],
  blend: ['Blends', blendScene,
    'Drag the two curves. Each box is a way to blend between them; the less the fairness, the fairer the blend.'],
  corner: ['A corner', cornerScene,
    'Drag the corner or its ends; the green curve takes the place of the corner.'],
  grid: ['On a grid', joinScene(1, [[[-11, -4], [-9, 2], [-6, 4], [0, 2]], [[0, 2], [8, -1], [9, -4], [11, -2]]]),
    'All points stay on the grid. Drag a handle, then move both to positions nearby that are exactly smooth.'],
  drawing: ['A drawing', drawingScene,
    'Drop an SVG or a font on the picture, choose a file, or edit the text under it. Circles mark kinks: click one to open it as a join, and put it back mended. Drag any point.'],
  surfaces: ['Surfaces', surfaceScene,
    'Compare the stripes across the red edge: they jump with G0, bend with G1, go on smoothly with G2. Drag the picture to turn it.'],
};
for (const [name, [title]] of Object.entries(scenes)) nav.append(html('a', { href: `#${name}`, id: `scene-${name}` }, title));
// #SCENE?left=x,y;x,y;…&right=…&strategies=fair,c2
function open() {
  const [name, query = ''] = location.hash.slice(1).split('?'), scene = Object.hasOwn(scenes, name) ? name : 'join';
  for (const a of nav.children) a.id === `scene-${scene}` ? a.setAttribute('aria-current', 'page') : a.removeAttribute('aria-current');
  for (const e of [stage, controls, details]) e.replaceChildren();
  ++asked;
  stage.removeAttribute('aria-busy');
  stage.ondragover = stage.ondragleave = stage.ondrop = null;
  hint.textContent = scenes[scene][2];
  document.title = `${scenes[scene][0]} – Geometric continuity`;
  scenes[scene][1](new URLSearchParams(query));
}
addEventListener('hashchange', open);
controls.addEventListener('submit', (e) => e.preventDefault());
open();
document.documentElement.dataset.ready = 'yes';
