// Draws surfaces with their edges coloured by grade, from far to near, as seen along a direction
// that the user turns.

// A model is {patches: [{m, n, points}], edges: [{points, grade, patches}]}: each patch a grid of
// (m + 1) (n + 1) points, or with triangles, by threes the numbers of its points.
class Model {
  constructor(data) {
    this.patches = data.patches.map((p) => ({ points: triples(p.points), colour: p.colour && softened(p.colour) }));
    const size = sizeOfTriangles(data.patches, this.patches);
    data.patches.forEach((p, i) => {
      this.patches[i].facets = p.triangles ? trianglesOf(p, this.patches[i].points, size) : facetsOf(p);
      this.patches[i].cell = this.patches[i].facets.reduce((most, f) => Math.max(most, length(subtract(f.corners[2], f.corners[0]))), 0);
    });
    // an edge lies in front of the cells that have it
    const most = data.patches.some((p) => p.triangles) ? size : Infinity;
    this.edges = data.edges.map((e) => ({ ...e, points: refined(triples(e.points), most),
      bias: 0.55 * Math.max(0, ...e.patches.map((i) => this.patches[i].cell)) }));
    this.all = this.patches.map((_, i) => i);
    this.frame = frameOf(this.patches.flatMap((p) => p.points).concat(this.edges.flatMap((e) => e.points)));
  }
  // The middle and the size of what a card shows: both patches of an edge, not far around it.
  frameAround(edge) {
    const own = frameOf(edge.points);
    const near = edge.patches.flatMap((i) => (this.patches[i] ? this.patches[i].points : []));
    const all = frameOf(near.concat(edge.points));
    return { centre: own.centre, radius: Math.min(all.radius, 1.7 * own.radius) || all.radius };
  }
}

function triples(flat) {
  const points = [];
  for (let i = 0; i + 2 < flat.length; i += 3) points.push(flat.slice(i, i + 3));
  return points;
}

function frameOf(points) {
  let low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of points) { low = low.map((x, i) => Math.min(x, p[i])); high = high.map((x, i) => Math.max(x, p[i])); }
  if (points.length === 0) return { centre: [0, 0, 0], radius: 1 };
  const centre = combine(low, 0.5, high, 0.5);
  return { centre, radius: points.reduce((most, p) => Math.max(most, length(subtract(p, centre))), 0) || 1 };
}

function facetsOf({ m, n, points }) {
  const at = (i, j) => points.slice(3 * (j * (m + 1) + i), 3 * (j * (m + 1) + i) + 3), facets = [];
  for (let j = 0; j < n; ++j)
    for (let i = 0; i < m; ++i) {
      const corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      facets.push(facetOf(corners, subtract(corners[2], corners[0]), subtract(corners[3], corners[1])));
    }
  return facets;
}

// A facet with its unit normal, which is across a and b.
function facetOf(corners, a, b) {
  const normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]], size = length(normal);
  return { corners, normal: size > 0 ? normal.map((x) => x / size) : null };
}

const cornersOf = ({ triangles }, points) => Array.from({ length: triangles.length / 3 }, (_, i) =>
  [0, 1, 2].map((j) => points[triangles[3 * i + j]]));
const sidesOf = (corners) => corners.map((p, i) => length(subtract(corners[(i + 1) % 3], p)));

// The length beyond which sides of triangles are halved, so that the middle of each tells what lies
// in front of what; but not so short that the pieces are too many to be drawn.
function sizeOfTriangles(data, patches) {
  const boxes = [];
  data.forEach((p, i) => {
    if (p.triangles) for (const corners of cornersOf(p, patches[i].points)) boxes.push(sidesOf(corners).sort((a, b) => b - a));
  });
  let size = frameOf(patches.flatMap((p) => p.points)).radius / 12;
  const pieces = () => boxes.reduce((sum, [a, , c]) => sum + Math.ceil(a / size) * Math.ceil(c / size), 0);
  for (const most = 40000 + 2 * boxes.length; pieces() > most;) size *= 1.4;
  return size;
}

// The points of a polyline, and so many between them that its segments are no longer than this
// size.
function refined(points, size) {
  return points.flatMap((p, i) => {
    const n = i === 0 ? 1 : Math.max(1, Math.ceil(length(subtract(p, points[i - 1])) / size));
    return Array.from({ length: n }, (_, j) => (j + 1 === n ? p : combine(points[i - 1], 1 - (j + 1) / n, p, (j + 1) / n)));
  });
}

function trianglesOf(data, points, size) {
  const facets = [];
  const add = (corners) => {
    const sides = sidesOf(corners), longest = sides.indexOf(Math.max(...sides));
    const [a, b, c] = [0, 1, 2].map((i) => corners[(longest + i) % 3]);
    if (sides[longest] > size) {
      const middle = combine(a, 0.5, b, 0.5);
      add([a, middle, c]);
      add([middle, b, c]);
    } else facets.push(facetOf([a, c, b], subtract(b, a), subtract(c, a))); // the longest side is that from the first to the third
  };
  cornersOf(data, points).forEach(add);
  return facets;
}

// The rows are the directions to the right, up and towards the viewer, of a camera above the plane
// of x and y.
function cameraRows({ azimuth, elevation }) {
  const ca = Math.cos(azimuth), sa = Math.sin(azimuth), ce = Math.cos(elevation), se = Math.sin(elevation);
  return [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
}

// A colour of the file, so light that the edges stand out.
function softened(colour) {
  return '#' + [1, 3, 5].map((i) => Math.round(0.6 * parseInt(colour.slice(i, i + 2), 16) + 0.4 * 255).toString(16).padStart(2, '0')).join('');
}

function mixed(a, b, t) {
  const parse = (c) => [1, 3, 5].map((i) => parseInt(c.slice(i, i + 2), 16)), x = parse(a), y = parse(b);
  return `rgb(${x.map((v, i) => Math.round(v + (y[i] - v) * t)).join(' ')})`;
}

// Options: camera, frame, patches (numbers), edges (numbers, or all), chosen (the number of an
// edge), fill, zoom.
function drawModel(canvas, model, options) {
  const { context, width, height } = prepared(canvas);
  if (width === 0) return;
  const rows = cameraRows(options.camera), { centre, radius } = options.frame;
  const scale = (0.48 * Math.min(width, height) / radius) * options.camera.zoom * (options.zoom || 1);
  const project = (p) => {
    const q = subtract(p, centre);
    return [width / 2 + scale * dot(q, rows[0]), height / 2 - scale * dot(q, rows[1]), dot(q, rows[2])];
  };
  const parts = []; // {depth, draw}
  for (const i of options.patches) {
    if (!model.patches[i]) continue;
    const { colour } = model.patches[i];
    for (const facet of model.patches[i].facets) {
      const p = facet.corners.map(project), depth = p.reduce((sum, q) => sum + q[2], 0) / p.length;
      const light = facet.normal ? Math.abs(0.35 * dot(facet.normal, rows[1]) + 0.9 * dot(facet.normal, rows[2])) : 0.5;
      parts.push({ depth, draw: () => drawFacet(context, p, light, options.fill, colour) });
    }
  }
  const numbers = options.edges || model.edges.map((_, i) => i);
  for (const i of numbers) {
    const edge = model.edges[i], p = edge.points.map(project), chosen = i === options.chosen;
    for (let j = 0; j + 1 < p.length; ++j)
      for (const halo of chosen ? [true, false] : [false])
        parts.push({
          depth: (p[j][2] + p[j + 1][2]) / 2 + edge.bias * (chosen && !halo ? 1.6 : 1),
          draw: () => drawSegment(context, p[j], p[j + 1], edge.grade, chosen, halo),
        });
  }
  parts.sort((a, b) => a.depth - b.depth);
  for (const part of parts) part.draw();
}

function drawFacet(context, p, light, fill, colour) {
  polyline(context, p);
  context.closePath();
  context.lineWidth = 0.6;
  if (fill) {
    context.fillStyle = context.strokeStyle = colour ? mixed('#000000', colour, 0.6 + 0.4 * light * light)
      : mixed(colours.shade, colours.card, 0.05 + 0.9 * light * light);
    context.fill();
  } else
    context.strokeStyle = colours.line;
  context.stroke();
}

const thinGrades = new Set(['boundary', 'collapsed', 'G2']);

function drawSegment(context, a, b, grade, chosen, halo) {
  context.strokeStyle = halo ? mixed(colours.focus, colours.card, 0.6) : colours[grade];
  context.lineWidth = halo ? 10 : chosen ? 3.5 : thinGrades.has(grade) ? 1.4 : 2.6;
  polyline(context, [a, b]);
  context.stroke();
}

// Turns a camera with the mouse and the keys of a focused canvas; calls changed() after each step.
function turnWith(canvas, camera, changed) {
  const step = (right, up) => {
    camera.azimuth -= right;
    camera.elevation = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, camera.elevation + up));
    changed();
  };
  const zoom = (factor) => { camera.zoom = Math.max(0.3, Math.min(40, camera.zoom * factor)); changed(); };
  canvas.addEventListener('pointerdown', (e) => canvas.setPointerCapture(e.pointerId));
  canvas.addEventListener('pointermove', (e) => {
    if (canvas.hasPointerCapture(e.pointerId)) step(0.008 * e.movementX, 0.008 * e.movementY);
  });
  canvas.addEventListener('wheel', (e) => { e.preventDefault(); zoom(Math.exp(-0.0015 * e.deltaY)); }, { passive: false });
  const keys = {
    ArrowLeft: () => step(-0.1, 0), ArrowRight: () => step(0.1, 0), ArrowUp: () => step(0, -0.1), ArrowDown: () => step(0, 0.1),
    '+': () => zoom(1.2), '=': () => zoom(1.2), '-': () => zoom(1 / 1.2), 0: () => zoom(1 / camera.zoom),
  };
  canvas.addEventListener('keydown', (e) => {
    if (!keys[e.key] || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    e.stopPropagation();
    keys[e.key]();
  });
}
