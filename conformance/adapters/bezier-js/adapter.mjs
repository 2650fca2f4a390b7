// SPDX-License-Identifier: CC0-1.0

// bezier-js: the derivative and the curvature of curves at their ends.
import { Bezier } from 'bezier-js';
import { Unsupported, claim, close, least, level, number, pairs, readChain, serve, tolerances } from '../answers.mjs';

function bezier(curve) {
  if (curve.weights || curve.knots || curve.degree < 1 || curve.degree > 3) throw new Unsupported('such a curve');
  const points = curve.points.map(p => ({ x: number(p[0]), y: number(p[1]), ...(p.length === 3 ? { z: number(p[2]) } : {}) }));
  if (curve.degree === 1) throw new Unsupported('lines'); // its curves are quadratic or cubic
  return new Bezier(points);
}

function join(left, right, order, within) {
  const { gap, angle, percent } = within ?? close;
  const a = bezier(left), b = bezier(right);
  const p = a.get(1), q = b.get(0), u = a.derivative(1), v = b.derivative(0);
  if (Math.hypot(p.x - q.x, p.y - q.y, (p.z ?? 0) - (q.z ?? 0)) > gap) return 'gap';
  if (order[0] === 'C') throw new Unsupported('C orders');
  if (level(order) === 0) return 'G0';
  const z = [u.z ?? 0, v.z ?? 0];
  const cross = Math.hypot(u.x * v.y - u.y * v.x, u.y * z[1] - z[0] * v.y, z[0] * v.x - u.x * z[1]), dot = u.x * v.x + u.y * v.y + z[0] * z[1];
  if ((u.x === 0 && u.y === 0 && z[0] === 0) || (v.x === 0 && v.y === 0 && z[1] === 0)) throw new Unsupported('a tangent where the first derivative is 0');
  if (Math.atan2(cross, dot) > angle) return 'G0';
  if (level(order) === 1) return 'G1';
  if (left.points[0].length === 3) return 'G1+'; // its curvature in space is a number without direction
  const k = a.curvature(1).k, l = b.curvature(0).k;
  if (Math.abs(k - l) * 100 > percent * Math.max(Math.abs(k), Math.abs(l))) return 'G1';
  return level(order) > 2 ? 'G2+' : 'G2';
}

serve((file, order, text) => {
  const within = tolerances(text);
  const reached = least(pairs(readChain(file)).map(([a, b]) => join(a, b, order, within)));
  return within ? reached : claim(reached);
});
