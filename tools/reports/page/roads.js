// Draws roads: the network in plan with its lanes, and the curvature and the elevation along a
// road.

class Roads {
  constructor(data) {
    this.roads = data.roads.map((r) => ({ ...r, box: [Infinity, Infinity, -Infinity, -Infinity], driving: new Path2D(), other: new Path2D(),
      borders: new Path2D(), line: new Path2D() }));
    this.box = [Infinity, Infinity, -Infinity, -Infinity];
    for (const road of this.roads) this.prepare(road);
  }

  // Paths in the coordinates of the network, which are drawn at any scale.
  prepare(road) {
    const at = (i, t) => [road.x[i] - t * Math.sin(road.h[i]), road.y[i] + t * Math.cos(road.h[i])];
    const include = (p) => {
      for (const box of [road.box, this.box]) {
        for (const k of [0, 1]) { box[k] = Math.min(box[k], p[k]); box[k + 2] = Math.max(box[k + 2], p[k]); }
      }
      return p;
    };
    const trace = (path, points, goOn) => points.forEach((p, i) => (i === 0 && !goOn ? path.moveTo(p[0], p[1]) : path.lineTo(p[0], p[1])));
    for (const lane of road.lanes) {
      const left = lane.left.map((t, i) => include(at(lane.first + i, t))), right = lane.right.map((t, i) => include(at(lane.first + i, t)));
      const path = lane.driving ? road.driving : road.other;
      trace(path, left, false);
      trace(path, right.slice().reverse(), true);
      path.closePath();
      trace(road.borders, left, false);
      trace(road.borders, right, false);
    }
    trace(road.line, road.x.map((_, i) => include(at(i, 0))), false);
  }
}

// Options: centre and reach (metres), or neither for the whole network; zoom, shift, item, items
// (whose places are marked), fill, profiles (their height).
function drawRoads(canvas, roads, options) {
  const { context, width, height } = prepared(canvas);
  if (width === 0 || roads.box[0] > roads.box[2]) return;
  const below = options.profiles || 0, h = height - 2 * below, [x0, y0, x1, y1] = roads.box, zoom = options.zoom || 1;
  const centre = options.centre || [(x0 + x1) / 2, (y0 + y1) / 2];
  const scale = zoom * (options.centre ? Math.min(width, h) / options.reach : Math.min(width / (x1 - x0 + 20), h / (y1 - y0 + 20)));
  const shift = options.shift || [0, 0], origin = [width / 2 + shift[0], h / 2 + shift[1]], pixel = window.devicePixelRatio || 1;
  const place = (p) => [origin[0] + scale * (p[0] - centre[0]), origin[1] - scale * (p[1] - centre[1])];
  context.save();
  context.beginPath();
  context.rect(0, 0, width, h);
  context.clip();
  context.save();
  context.setTransform(pixel * scale, 0, 0, -pixel * scale, pixel * (origin[0] - scale * centre[0]), pixel * (origin[1] + scale * centre[1]));
  const seen = roads.roads.filter((r) => {
    const a = place([r.box[0], r.box[3]]), b = place([r.box[2], r.box[1]]);
    return a[0] < width && b[0] > 0 && a[1] < h && b[1] > 0;
  });
  const chosen = options.item ? roads.roads[options.item.road] : null;
  if (options.fill !== false) {
    context.fillStyle = colours.shade;
    for (const [lanes, alpha] of [['other', 0.3], ['driving', 0.85]]) {
      context.globalAlpha = alpha;
      for (const r of seen) context.fill(r[lanes]);
    }
    context.globalAlpha = 1;
  }
  context.lineWidth = 0.75 / scale;
  context.strokeStyle = colours.handle;
  if (scale > 0.5) for (const r of seen) context.stroke(r.borders);
  context.lineWidth = 1.25 / scale;
  for (const r of seen) { context.strokeStyle = r === chosen ? colours.left : colours.soft; context.stroke(r.line); }
  context.restore();
  for (const item of options.items || []) if (item !== options.item) dotAt(context, place(item.xy), 2.5, colours[item.grade]);
  if (options.item) {
    dotAt(context, place(options.item.xy), 7, colours.card);
    dotAt(context, place(options.item.xy), 5, colours[options.item.grade]);
  }
  drawScale(context, scale, width, h);
  context.restore();
  if (below && chosen) {
    drawProfile(context, 'curvature, 1/m', chosen.s, chosen.k, options.item, width, h, below);
    drawProfile(context, 'elevation, m', chosen.s, chosen.z, options.item, width, h + below, below);
  }
}

// A bar of a round length in the corner.
function drawScale(context, scale, width, height) {
  const wanted = 0.2 * width / scale, power = Math.pow(10, Math.floor(Math.log10(wanted)));
  const size = [5, 2, 1].map((d) => d * power).find((d) => d <= wanted) || power;
  context.strokeStyle = context.fillStyle = colours.ink;
  context.lineWidth = 1.5;
  polyline(context, [[10, height - 16], [10, height - 10], [10 + size * scale, height - 10], [10 + size * scale, height - 16]]);
  context.stroke();
  context.font = '12px sans-serif';
  context.fillText(`${Number(size.toPrecision(1))} m`, 16, height - 16);
}

// A function of the length along the road, with the place of the join.
function drawProfile(context, name, s, values, item, width, top, height) {
  if (s.length < 2) return;
  const margin = 34, low = Math.min(...values), high = Math.max(...values), middle = (low + high) / 2;
  const range = Math.max(high - low, 1e-6), x = (t) => margin + (width - 2 * margin) * (t - s[0]) / (s[s.length - 1] - s[0] || 1);
  const y = (v) => top + height / 2 - (height - 30) * (v - middle) / range;
  context.strokeStyle = colours.line;
  context.lineWidth = 1;
  polyline(context, [[0, top], [width, top]]);
  context.stroke();
  context.strokeStyle = colours[item.grade];
  context.setLineDash([3, 3]);
  polyline(context, [[x(item.s), top + 4], [x(item.s), top + height - 4]]);
  context.stroke();
  context.setLineDash([]);
  context.strokeStyle = colours.left;
  context.lineWidth = 1.5;
  polyline(context, s.map((t, i) => [x(t), y(values[i])]));
  context.stroke();
  context.fillStyle = colours.ink;
  context.font = '12px sans-serif';
  context.fillText(`${name}: ${Number(low.toPrecision(4))} to ${Number(high.toPrecision(4))}; s from ${s[0]} to ${s[s.length - 1]} m`, 8, top + 14);
}
