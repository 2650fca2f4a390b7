// SPDX-License-Identifier: CC0-1.0

// paper.js: Segment.isSmooth(), and the curvature of its curves at their ends.
import paper from 'paper/dist/paper-core.js';
import { Unsupported, close, least, level, number, readChain, serve, tolerances } from '../answers.mjs';

paper.setup(new paper.Size(1, 1));

/** A path. What it cannot hold is not supported: gaps, weights, other degrees than 1 to 3. */
function path({ curves, closed }) {
  const result = new paper.Path({ insert: false });
  const point = p => {
    if (p.length !== 2) throw new Unsupported('curves in space');
    return new paper.Point(number(p[0]), number(p[1]));
  };
  curves.forEach((curve, i) => {
    if (curve.weights || curve.knots || curve.degree > 3) throw new Unsupported('such a curve');
    const [first, ...rest] = curve.points;
    if (i === 0) result.moveTo(point(first));
    else if (!result.lastSegment.point.equals(point(first))) throw new Unsupported('gaps');
    if (rest.length === 1) result.lineTo(point(rest[0]));
    else if (rest.length === 2) result.quadraticCurveTo(point(rest[0]), point(rest[1]));
    else result.cubicCurveTo(...rest.map(point));
  });
  if (closed) result.closePath();
  return result;
}

serve((file, order, text) => {
  if (order[0] === 'C') throw new Unsupported('C orders');
  if (text) throw new Unsupported('tolerances');
  const drawn = path(readChain(file));
  const segments = drawn.closed ? drawn.segments : drawn.segments.slice(1, -1);
  const reached = least(segments.map(s => {
    if (level(order) === 0) return 'G0';
    if (s.handleIn.isZero() || s.handleOut.isZero()) throw new Unsupported('segments without handles, which it calls not smooth by definition');
    if (!s.isSmooth()) return 'G0';
    if (level(order) === 1) return 'G1';
    const k = s.previous.curve.getCurvatureAtTime(1), l = s.curve.getCurvatureAtTime(0);
    if (Math.abs(k - l) * 100 > close.percent * Math.max(Math.abs(k), Math.abs(l))) return 'G1';
    return level(order) > 2 ? 'G2+' : 'G2';
  }));
  // Points are equal within 1e-7 where a path closes; handles are collinear within 1e-8.
  return `${reached} within gap=1e-7,angle_radians=1e-8,curvature_percent=1e-4`;
});
