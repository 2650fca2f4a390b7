// Draws a join: both curves with their curvature combs and handles, and grey what lies around.

const teeth = 48;

// The colours of the theme, read once for each theme.
let colours = {};
function readColours() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ['card', 'ink', 'soft', 'line', 'shade', 'left', 'right', 'handle', 'context', 'gap', 'fading corner', 'corner', 'kink',
    'bend', 'rounding', 'G0', 'undecided', 'G1', 'G2', 'boundary', 'collapsed', 'focus'])
    colours[name] = style.getPropertyValue('--' + name.split(' ')[0]).trim();
}

// Fits a canvas to its box on the screen and returns its context, in units of the page, and its
// size.
function prepared(canvas) {
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * scale)) canvas.width = Math.round(width * scale);
  if (canvas.height !== Math.round(height * scale)) canvas.height = Math.round(height * scale);
  const context = canvas.getContext('2d');
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineJoin = context.lineCap = 'round';
  return { context, width, height };
}

function polyline(context, points) {
  context.beginPath();
  points.forEach((p, i) => (i === 0 ? context.moveTo(p[0], p[1]) : context.lineTo(p[0], p[1])));
}

// The control points of both curves of a join.
function pointsOf(item) {
  const points = [];
  for (const curve of [item.left, item.right])
    for (let i = 0; i <= degreeOf(curve); ++i) points.push(controlPoint(curve, i));
  return points;
}

// A map from the space of the curves to the canvas: the join in the middle, and around it as much
// as the shorter of both curves takes, twice.
class View {
  constructor(item, width, height, zoom, shift, down) {
    this.directions = planeOf(pointsOf(item));
    this.centre = combine(controlPoint(item.left, -1), 0.5, controlPoint(item.right, 0), 0.5);
    const reach = (curve) => Math.max(0, ...curveBox(curve).map((p) => length(subtract(p, this.centre))));
    const a = reach(item.left), b = reach(item.right), least = Math.min(a, b) || Math.max(a, b) || 1;
    this.radius = Math.min(Math.max(a, b) || 1, 2 * least) / zoom;
    this.up = down ? 1 : -1;
    this.scale = 1;
    this.fit(item, width, height, Math.min(zoom, 1), zoom);
    this.origin[0] += shift[0];
    this.origin[1] += shift[1];
  }
  // Leaves space for the comb. With a zoom the join moves into the middle.
  fit(item, width, height, smaller, zoom) {
    const margin = 0.19 * Math.min(width, height), most = this.radius * Math.max(zoom, 1);
    const points = [this.centre.map(() => 0), ...offsetsWithin(curveBox(item.left).reverse(), this.centre, most, false),
      ...offsetsWithin(curveBox(item.right), this.centre, most, false),
      ...offsetsWithin(samples(item.left, 24).map((s) => s.x).reverse(), this.centre, most, true),
      ...offsetsWithin(samples(item.right, 24).map((s) => s.x), this.centre, most, true)].map((v) => this.vector(v));
    const range = [0, 1].map((i) => [Math.min(...points.map((p) => p[i])), Math.max(...points.map((p) => p[i]))]);
    const scales = [width, height].map((size, i) => (size - 2 * margin) / (range[i][1] - range[i][0]));
    const fitting = Math.min(...scales, 0.5 * width / most, 1.2 * height / most) * smaller;
    this.scale = fitting * Math.max(zoom, 1);
    const weight = 1 / Math.max(zoom, 1);
    this.origin = [width, height].map((size, i) => size / 2 - weight * fitting * (range[i][0] + range[i][1]) / 2);
  }
  vector(v) { return [this.scale * dot(v, this.directions[0]), this.up * this.scale * dot(v, this.directions[1])]; }
  point(p) {
    const v = this.vector(subtract(p, this.centre));
    return [this.origin[0] + v[0], this.origin[1] + v[1]];
  }
}

// The offsets from the centre of those points that lie within the distance `most`, and, on the way
// out, of the place where it is reached.
function offsetsWithin(points, centre, most, wayOut) {
  const result = [];
  for (const p of points) {
    const v = subtract(p, centre), distance = length(v);
    if (distance <= most * 1.001) result.push(v);
    else if (wayOut) {
      result.push(v.map((x) => x * most / distance));
      break;
    }
  }
  return result;
}

function curveBox(curve) {
  const points = [];
  for (let i = 0; i <= degreeOf(curve); ++i) points.push(controlPoint(curve, i));
  return points;
}

// A ball that contains the control points.
function ballOf(curve) {
  if (!curve.ball) {
    const points = curveBox(curve);
    const low = points.reduce((a, p) => a.map((x, i) => Math.min(x, p[i]))), high = points.reduce((a, p) => a.map((x, i) => Math.max(x, p[i])));
    curve.ball = { centre: combine(low, 0.5, high, 0.5), radius: length(subtract(high, low)) / 2 };
  }
  return curve.ball;
}

// The curvature to which the longest teeth belong: that at the join, where it is not much less than
// elsewhere.
function referenceCurvature(left, right) {
  const all = [...left, ...right].filter((s) => s.k).map((s) => length(s.k)).sort((a, b) => a - b);
  if (all.length === 0) return 0;
  const last = left[left.length - 1].k, first = right[0].k;
  return Math.max(last ? length(last) : 0, first ? length(first) : 0, all[Math.floor(all.length * 0.6)]);
}

function drawComb(context, view, curve, colour, unit, longest) {
  const ends = [], bases = [];
  for (const s of curve) {
    if (!s.k) continue;
    const k = view.vector(s.k), size = Math.hypot(k[0], k[1]), base = view.point(s.x);
    // a curve in space may bend towards the viewer: the tooth is as long as the curvature, seen
    // from here
    const wanted = size === 0 ? 0 : Math.min(size / view.scale * unit, longest) / size;
    bases.push(base);
    ends.push([base[0] - k[0] * wanted, base[1] - k[1] * wanted]);
  }
  if (ends.length === 0) return;
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = 0.1;
  polyline(context, [...bases, ...ends.slice().reverse()]);
  context.fill();
  context.globalAlpha = 0.4;
  context.lineWidth = 0.75;
  context.beginPath();
  ends.forEach((e, i) => { context.moveTo(bases[i][0], bases[i][1]); context.lineTo(e[0], e[1]); });
  context.stroke();
  context.globalAlpha = 0.95;
  context.lineWidth = 1.25;
  polyline(context, ends);
  context.stroke();
  context.globalAlpha = 1;
}

// The sides of the control polygon at the ends, or all of them for higher degrees; the control
// points between as squares.
function drawHandles(context, view, curve) {
  const n = degreeOf(curve);
  if (n < 2) return;
  const p = curveBox(curve).map((x) => view.point(x));
  context.strokeStyle = colours.handle;
  context.lineWidth = 1;
  context.beginPath();
  for (let i = 0; i < n; ++i)
    if (n !== 3 || i !== 1) { context.moveTo(p[i][0], p[i][1]); context.lineTo(p[i + 1][0], p[i + 1][1]); }
  context.stroke();
  context.fillStyle = colours.card;
  for (let i = 1; i < n; ++i) {
    context.fillRect(p[i][0] - 3, p[i][1] - 3, 6, 6);
    context.strokeRect(p[i][0] - 3, p[i][1] - 3, 6, 6);
  }
}

function dotAt(context, p, radius, colour) {
  context.beginPath();
  context.arc(p[0], p[1], radius, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.fill();
}

// Other curves of the same contour or chain, where they come into view.
function drawContext(context, view, item, curves, width, height) {
  context.strokeStyle = colours.context;
  context.lineWidth = 1.5;
  const reach = (Math.hypot(width, height) + Math.hypot(view.origin[0] - width / 2, view.origin[1] - height / 2)) / view.scale;
  for (const curve of curves) {
    if (curve === item.left || curve === item.right) continue;
    const ball = ballOf(curve);
    if (Math.abs(ball.centre[0] - view.centre[0]) > ball.radius + reach || length(subtract(ball.centre, view.centre)) > ball.radius + reach)
      continue;
    polyline(context, samples(curve, degreeOf(curve) < 2 && !curve.weights ? 1 : 24).map((s) => view.point(s.x)));
    context.stroke();
  }
}

// Options: curves (of the group), down, zoom, shift, comb (a factor).
function drawJoin(canvas, item, options) {
  const { context, width, height } = prepared(canvas);
  if (width === 0 || !item.left) return;
  const view = new View(item, width, height, options.zoom || 1, options.shift || [0, 0], options.down);
  drawContext(context, view, item, options.curves, width, height);
  const left = samples(item.left, teeth), right = samples(item.right, teeth);
  const reference = referenceCurvature(left, right), longest = 0.2 * Math.min(width, height) * (options.comb || 1);
  const unit = reference > 0 ? longest / 1.15 / reference : 0;
  drawComb(context, view, left, colours.left, unit, 1.6 * longest);
  drawComb(context, view, right, colours.right, unit, 1.6 * longest);
  drawHandles(context, view, item.left);
  drawHandles(context, view, item.right);
  for (const [curve, colour] of [[left, colours.left], [right, colours.right]]) {
    context.strokeStyle = colour;
    context.lineWidth = 2.25;
    polyline(context, curve.map((s) => view.point(s.x)));
    context.stroke();
  }
  const a = view.point(controlPoint(item.left, -1)), b = view.point(controlPoint(item.right, 0));
  if (item.grade === 'gap') {
    context.setLineDash([4, 4]);
    context.strokeStyle = colours.gap;
    context.lineWidth = 1.5;
    polyline(context, [a, b]);
    context.stroke();
    context.setLineDash([]);
  }
  for (const p of [a, b]) {
    dotAt(context, p, 6, colours.card);
    dotAt(context, p, 4.5, colours[item.grade]);
  }
  if (options.locator) drawLocator(context, options.locator, item, width, height, options.down);
}

// A small map of the whole contour in the corner, drawn once and kept.
function drawLocator(context, locator, item, width, height, down) {
  const size = 74, left = width - size - 2, scale = window.devicePixelRatio || 1;
  if (!locator.image || locator.colour !== colours.context || locator.scale !== scale) {
    const points = locator.curves.flatMap(curveBox);
    locator.plane = planeOf(points.length > 500 ? points.filter((_, i) => i % Math.ceil(points.length / 500) === 0) : points);
    const flat = points.map((p) => locator.plane.map((e) => dot(p, e)));
    let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const p of flat) { low = p.map((x, i) => Math.min(x, low[i])); high = p.map((x, i) => Math.max(x, high[i])); }
    const unit = (size - 12) / (Math.max(high[0] - low[0], high[1] - low[1]) || 1);
    locator.place = (p) => [0, 1].map((i) =>
      size / 2 + (i === 1 && !down ? -1 : 1) * unit * (dot(p, locator.plane[i]) - (low[i] + high[i]) / 2));
    locator.image = document.createElement('canvas');
    locator.image.width = locator.image.height = Math.round(size * scale);
    locator.colour = colours.context;
    locator.scale = scale;
    const c = locator.image.getContext('2d');
    c.scale(scale, scale);
    c.strokeStyle = colours.handle;
    c.lineWidth = 1;
    for (const curve of locator.curves) { polyline(c, samples(curve, locator.curves.length > 300 ? 4 : 12).map((s) => locator.place(s.x))); c.stroke(); }
  }
  context.fillStyle = colours.card;
  context.globalAlpha = 0.85;
  context.fillRect(left, 0, size, size);
  context.globalAlpha = 1;
  context.drawImage(locator.image, left, 0, size, size);
  const p = locator.place(controlPoint(item.left, -1));
  dotAt(context, [left + p[0], p[1]], 4.5, colours.card);
  dotAt(context, [left + p[0], p[1]], 3.5, colours[item.grade]);
}
