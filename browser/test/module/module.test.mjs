// Copyright (c) 2026 The Geometric_continuity developers
// SPDX-License-Identifier: LGPL-3.0-or-later

// The functions of the npm package on curves and patches.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import load, * as named from 'geometric-continuity';

const { GeometricContinuityError } = named;
assert.throws(() => named.continuity(), /^Error: continuity: the module is not loaded yet; call const gc = await load\(\); gc.continuity\(\.\.\.\)$/);
assert.throws(() => load.verifySvg, /^TypeError: verifySvg: .* call const gc = await load\(\); then gc.verifySvg\(\.\.\.\)$/);
assert.throws(() => new named.BezierCurve(), /^TypeError: gc.BezierCurve is not there: .* no class is needed$/);
assert.throws(() => named.isG2(), /^TypeError: gc.isG2 is not there: call continuity\(left, right\).g_order/);
const gc = await load();
const phi = [[-3, 0], [-3, 2], [-2, 3], [0, 3]], psi = [[4, 0], [5, -1]];

const fails = (code, f, text = '') =>
  assert.throws(f, (error) => {
    assert.ok(error instanceof GeometricContinuityError, String(error));
    assert.equal(error.code, code, error.message);
    assert.ok(error.message.startsWith(`${code}: `) && error.message.includes(text), error.message);
    assert.equal(error.message.split(code).length, 2, 'the code stands once');
    return true;
  });

test('the blend of the README and its joins', () => {
  const blend = gc.blend(phi, psi);
  assert.equal(blend.strategy, 'energy3');
  const text = ({ c_order, g_order, f_order, betas }) => `C${c_order} G${g_order} F${f_order}, beta = (${betas.join(', ')})`;
  assert.equal(text(gc.continuity(phi, blend.curve)), 'C0 G2 F2, beta = (213/256, -267691/208896)');
  assert.equal(text(gc.continuity(blend.curve, psi)), 'C0 G2 F2, beta = (32/113, 1364223/24529249)');
  assert.deepEqual(blend.start_join, gc.continuity(phi, blend.curve));
  assert.deepEqual(blend.curve.points[0], phi[3]);
  assert.deepEqual(Object.keys(blend.start_join), ['c_order', 'g_order', 'f_order', 'betas', 'regular', 'tangent_equal',
    'curvature_equal', 'curvature_vector_equal', 'torsion_equal']);
});

test('every strategy keeps its promise, in the plane and in space', () => {
  const left = [[-3, 0, 0], [-3, 2, 1], [-2, 3, 1], [0, 3, 0]], right = [[4, 0, 0], [5, -1, 1], [6, 0, 3], [7, 0, 4]];
  for (const strategy of ['c2', 'normal', 'min_second', 'near_line', 'energy2', 'energy3', 'fair'])
    for (const [a, b] of [[phi, psi], [left, right]]) {
      const blend = gc.blend(a, b, { strategy });
      assert.equal(blend.curve.control_points.length, 6);
      assert.ok(blend.start_join.g_order >= 2 && blend.end_join.g_order >= 2, strategy);
    }
  for (const strategy of ['c3', 'seq_g3', 'seq_f3', 'joint_g3', 'energy3_g3', 'energy4_g3', 'fair_g3', 'fair_f3']) {
    const { curve, start_join, end_join } = gc.blend(left, right, { strategy });
    assert.equal(curve.control_points.length, 8);
    assert.ok(start_join.f_order === 3 && end_join.f_order === 3, strategy);
    if (!strategy.endsWith('f3')) assert.ok(start_join.g_order === 3 && end_join.g_order === 3, strategy);
  }
});

test('given shape parameters and scalars', () => {
  const blend = gc.blend(phi, psi, { strategy: 'free', beta: '3/4', eta: 1, s1: '1/3', s2: 0 });
  assert.deepEqual([blend.shape, blend.parameters], [{ beta: '3/4', eta: '1' }, { s1: '1/3', s2: '0' }]);
  assert.equal(blend.start_join.betas[0], '3/4');
  const zero = { beta2: 0, mu: 0, beta3: 0 };
  assert.deepEqual(gc.blend(phi, psi, { strategy: 'free3', start: zero, end: zero }).curve, gc.blend(phi, psi, { strategy: 'c3' }).curve);
});

test('numbers are what they are: doubles, decimals, fractions, bigints', () => {
  const join = (a, b, c) => gc.continuity([[0, 0], a], [a, b], c).g_order;
  assert.equal(join([0.1, 0.3], [0.3, 0.9]), 0); // on a line before rounding only
  assert.equal(join(['0.1', '0.3'], ['0.3', '0.9']), 3);
  assert.equal(join(['1/10', '3/10'], ['3e-1', '0.9']), 3);
  assert.equal(join([0.1, 0.2], [0.4, 0.8]), 3); // as rounded on the line y = 2 x
  assert.equal(join([1n, 3n], [10n ** 30n, 3n * 10n ** 30n]), 3);
  assert.equal(join([1, 3], [`${10n ** 30n}`, `${3n * 10n ** 30n + 1n}`]), 0);
  assert.equal(gc.continuity([[0, 0], [5e-324, 0]], [[5e-324, 0], [1e300, 0]]).g_order, 3);
  assert.equal(gc.continuity([[-0, 0], [1, 0]], [[1, 0], [2, 0]], { maxOrder: 1 }).c_order, 1);
});

test('points are objects, and curves are path data', () => {
  const objects = (list) => list.map(([x, y]) => ({ x, y })), expected = gc.blend(phi, psi);
  assert.deepEqual(gc.blend(objects(phi), objects(psi)), expected);
  assert.deepEqual(gc.blend(objects(phi), { points: psi }), expected);
  assert.deepEqual(gc.blend(phi.map(([x, y]) => ({ x, y, z: 0, w: 1 })), 'M4 0L5-1'), expected, 'a DOMPoint');
  assert.deepEqual(gc.blend('M9 9L-3 0C-3 2-2 3 0 3', 'm4 0l1-1l7 7'), expected, 'the last segment, and the first one');
  assert.equal(gc.continuity([{ x: 0, y: 0, z: 0 }, { x: 1, y: 1, z: 1 }], [[1, 1, 1], [2, 2, 2]]).c_order, 3);
  assert.equal(gc.continuity('M0 0 .1 .3', 'M.1,.3\n.3 .9').g_order, 3, 'decimals are exact');
  assert.equal(gc.continuity('M0 0 .1 .3', [[0.1, 0.3], [0.3, 0.9]]).g_order, -1, 'and numbers are doubles');
  assert.equal(gc.joinGrade('M0 0H9', 'M9 0q1 0 2 1').grade, 'G1');
  assert.deepEqual(gc.alignHandles({ x: 10, y: 1 }, { x: 20, y: 1 }), gc.alignHandles([10, 1], [20, 1]));
  assert.deepEqual([...gc.failingJoins([objects(phi), [[0, 3], [1, 3], [2, 3], [3, 0]], [[3, 0], [4, 0], [5, 0], [6, 0]]])], [1]);
  fails('malformed_input', () => gc.continuity('M0 0A5 5 0 0 1 9 1', phi), 'left: the last segment is an arc (A)');
  fails('malformed_input', () => gc.continuity('0 0 1 1', phi), 'left');
  fails('malformed_input', () => gc.continuity('M0 0L1', phi), 'left, character');
  fails('malformed_input', () => gc.continuity(phi, '<path>'), 'right: "<path>" is no path data, such as "M0 0');
  fails('wrong_number_of_points', () => gc.continuity(phi, 'M0 0'), 'right: the path draws nothing');
  fails('malformed_input', () => gc.continuity('M0 0L1 1'), 'verifySvg() decides those inside of a path');
  fails('malformed_input', () => gc.continuity(phi, [0, 3, 1, 1]), 'right[0]: a point is an array [x, y] or an object { x, y }');
  fails('dimension_mismatch', () => gc.failingJoins([phi, phi.map(([x, y]) => [x, y, 0])]), 'curve 1 has 3 coordinates');
  fails('malformed_input', () => gc.blend(phi, psi, { strategy: 'faire' }), "there is no strategy \"faire\"; did you mean 'fair'? There are c2, normal,");
});

test('curves of paper.js and of bezier-js, by their members', () => {
  const at = (x, y) => ({ x, y }), segment = (p, handleIn, handleOut) => ({ point: at(...p), handleIn: at(...handleIn), handleOut: at(...handleOut) });
  // 0.7 + 0.1 is rounded, and handles are opposite as they are stored
  const segments = [segment([0, 0], [0, 0], [0, 1]), segment([0.7, 0.7], [-0.1, -0.3], [0.1, 0.3]), segment([2, 0], [0, 0], [0, 0]), segment([3, 0], [0, 0], [0, 0])];
  const path = { segments, closed: false }, rounded = [[[0, 0], [0, 1], [0.7 - 0.1, 0.7 - 0.3], [0.7, 0.7]], [[0.7, 0.7], [0.7 + 0.1, 0.7 + 0.3], [2, 0], [2, 0]]];
  assert.equal(gc.continuity(...rounded).g_order, 0);
  const curves = segments.slice(1).map((s, i) => ({ segment1: segments[i], segment2: s }));
  for (const chain of [path, segments, curves, { curves }]) {
    assert.deepEqual([...gc.failingJoins(chain)], [1], 'a line and a cubic without a handle');
    if (chain === curves) continue; // which are no curve
    assert.equal(gc.continuity(chain, 'M3 0H4').g_order, 3);
    assert.equal(gc.continuity('M0-1V0', chain).g_order, 1);
  }
  assert.deepEqual(gc.continuity(curves[0], curves[1]).betas.slice(0, 1), ['1']);
  const binary = (x) => { // [numerator, denominator], by the digits of the number
    const [, sign, whole, digits = ''] = x.toString(2).match(/^(-?)(\d+)\.?(\d*)$/);
    return [BigInt(`${sign}1`) * BigInt(`0b${whole}${digits}`), 1n << BigInt(digits.length)];
  };
  const exactSum = (x, y) => {
    const [[a, b], [c, d]] = [binary(x), binary(y)];
    return `${a * d + c * b}/${b * d}`;
  };
  for (const [x, h] of [[0.1, 0.7], [2 ** 60, 3e-7], [5e-324, 1], [-0.3, 0.1], [0.5, 0.25], [-1e-310, 3e-310], [-0.7, 1e-17], [7, -1e-40]]) {
    const given = [segment([x, 1], [0, 0], [h, h]), segment([h, 0], [x, -h], [0, 0])];
    const exact = [[x, 1], [exactSum(x, h), exactSum(1, h)], [exactSum(h, x), -h], [h, 0]];
    const blend = (right) => gc.blend([[-3, 0], [-1, 0.5]], right, { strategy: 'c2' }).curve.control_points;
    assert.deepEqual(blend(given), blend(exact), `${x} ${h}`);
  }
  assert.deepEqual([...gc.failingJoins({ ...path, closed: true })], [1, 2, 3]);
  assert.deepEqual([...gc.failingJoins({ ...path, closed: true }, { closed: false })], [1, 2]);
  const bezier = (list) => ({ points: list.map(([x, y]) => ({ x, y })), order: list.length - 1, _linear: false });
  assert.deepEqual([...gc.failingJoins({ curves: [bezier([[0, 0], [1, 0], [2, 1]]), bezier([[2, 1], [3, 2]]), bezier([[3, 2], [4, 2], [5, 2], [6, 3]])] })], [1]);
  assert.deepEqual([...gc.failingJoins([{ points: [[0, 0], [1, 1]], domain: [0, 2] }, [[1, 1], [2, 2]]], { order: 'C1' })], [0]);
  assert.deepEqual([...gc.failingJoins([[['0', '0'], ['0.1', '0.3']], [['0.1', '0.3'], ['0.3', '0.9']]], { order: 'G3' })], [], 'decimals are exact');
  fails('wrong_number_of_points', () => gc.continuity({ segments: [] }, phi), 'left: the path draws nothing');
  fails('malformed_input', () => gc.failingJoins({ children: [path, path], curves }), 'give one of its children');
});

test('rational curves and domains', () => {
  const quarter = (a, b, c) => ({ control_points: [a, b, c], weights: [1, 1, 2] });
  const circle = gc.continuity(quarter([1, 0], [1, 1], [0, 1]), { control_points: [[0, 1], [-1, 1], [-1, 0]], weights: [2, 2, 4] });
  assert.equal(circle.g_order, 3);
  const line = [[0, 0], [1, 1]], next = { points: [[1, 1], [2, 2]], domain: [0, '1/2'] };
  assert.deepEqual(gc.continuity(line, next).betas.slice(0, 1), ['2']);
  assert.deepEqual(gc.continuity(line, { ...next, domain: [1, 2] }).c_order, 3);
});

test('enclosures hold', () => {
  const { gap, tangent_angle, angle_degrees, curvature_jump, torsion_jump } = gc.deviation([[0, 0], [1, 0]], [[1, 0], [2, 1]]);
  assert.deepEqual([gap, curvature_jump, torsion_jump], [[0, 0], [0, 0], null]);
  assert.ok(tangent_angle[0] <= Math.PI / 4 && Math.PI / 4 <= tangent_angle[1] && tangent_angle[1] - tangent_angle[0] < 1e-15);
  assert.ok(angle_degrees[0] <= 45 && 45 <= angle_degrees[1]);
});

test('grades', () => {
  const grade = (x, y, options) => gc.joinGrade([[0, 0], [100, 0]], [[100, 0], [100 + x, y]], options);
  assert.equal(grade(100, 0).grade, 'G2');
  assert.deepEqual([grade(100, 1).grade, grade(100, 1).handle_offset[1] < 1.0001], ['kink', true]);
  assert.equal(grade(100, 100).grade, 'corner');
  assert.equal(grade(100, 100, { kinkAngle: 45 }).grade, 'kink'); // the bound itself, decided exactly
  assert.equal(grade(100, 100, { kinkAngle: '44.999999999999999999' }).grade, 'corner');
  assert.equal(gc.joinGrade([[0, 0], [1, 0]], [[2, 0], [3, 0]]).grade, 'gap');
});

test('a rounded corner', () => {
  const corner = gc.roundCorner([[0, 0], [10, 0]], [[10, 0], [10, 10]], 3);
  assert.ok(corner.blend.start_join.g_order >= 2 && corner.blend.end_join.g_order >= 2);
  assert.deepEqual(corner.left.control_points.at(-1), corner.blend.curve.control_points[0]);
  assert.ok(Math.abs(corner.left.points[1][0] - 7) < 0.003);
  assert.ok(gc.roundCorner([[0, 0], [10, 0]], [[10, 0], [10, 10]], 3, { strategy: 'fair_g3' }).blend.start_join.g_order === 3);
});

test('a corner rounded by cubics', () => {
  const round = (strategy) => gc.roundCorner([[0, 0], [10, 0]], [[10, 0], [10, 10]], 3, { strategy }).blend;
  const one = round('cubic'), two = round('two_cubics');
  assert.deepEqual(one.curves.map((c) => c.points), [[[7, 0], [10, 0], [10, 0], [10, 3]]]);
  assert.deepEqual([one.start_join.g_order, one.end_join.g_order, one.inner_join, two.curves.length], [2, 2, undefined, 2]);
  assert.ok(two.start_join.g_order >= 2 && two.inner_join.g_order >= 2 && two.end_join.g_order >= 2 && two.fairness < one.fairness);
});

test('the corners of polygons', () => {
  const square = [[0, 0], [4, 0], [4, 3], [0, 3]], rounded = gc.roundCorners(square, 1, { closed: true });
  assert.deepEqual(rounded.map((c) => c.points.length), [2, 6, 2, 6, 2, 6, 2, 6]);
  assert.deepEqual([rounded[0].control_points, rounded[6].points], [[['1', '0'], ['3', '0']], [[0, 2], [0, 1]]]);
  assert.deepEqual([...gc.failingJoins(rounded, { order: 'G2', closed: true })], []);
  assert.deepEqual(rounded[1], gc.roundCorner([[0, 0], [4, 0]], [[4, 0], [4, 3]], 1).blend.curve);
  assert.deepEqual(gc.roundCorners([...square, square[0]].map(([x, y]) => ({ x, y })), '1'), rounded, 'it ends where it starts');
  // a quarter remains of each side, and a vertex on a line is no corner
  assert.deepEqual(gc.roundCorners([[0, 0], [4, 0], [8, 0], [8, 8]], 100).map((c) => c.points[0]), [[0, 0], [4, 0], [5, 0], [8, 3]]);
  assert.deepEqual(gc.roundCorners([[0, 0], [8, 0], [8, 8], [0, 8]], 100).map((c) => c.points[0]), [[0, 0], [5, 0], [8, 3], [8, 5], [5, 8]]);
  const exact = gc.roundCorners([['1/3', '0.1'], [0.1, 5], [3, '7e0']], 1);
  assert.deepEqual([exact[0].control_points[0], exact[2].control_points[1], exact[0].points[0]], [['1/3', '0.1'], ['3', '7e0'], [1 / 3, 0.1]]);
  assert.deepEqual(gc.roundCorners([[0.1, 0], [1, 0]], 1)[0].control_points[0], ['3602879701896397/36028797018963968', '0']);
  assert.deepEqual([...gc.failingJoins(exact, { order: 'G2' })], []);
  const cubics = gc.roundCorners(square, 1, { closed: true, strategy: 'two_cubics' });
  assert.deepEqual([cubics.length, ...gc.failingJoins(cubics, { order: 'G2', closed: true })], [12]);
  fails('parameter_outside_domain', () => gc.roundCorners([[0, 0], [1, 0], [1, 0]], 1), 'the vertices 1 and 2 are one point');
  fails('zero_tangent', () => gc.roundCorners([[0, 0], [2, 0], [1, 0]], 1), 'vertex 1');
  fails('parameter_outside_domain', () => gc.roundCorners(square, 0), 'vertex 1');
  fails('malformed_input', () => gc.roundCorners(square), 'distance: a number is expected');
  fails('malformed_input', () => gc.roundCorners(square, 1, true), 'the options are an object { closed, strategy,');
  fails('malformed_input', () => gc.roundCorners(square, 1, { radius: 1 }), 'r * Math.tan(turn / 2); there are closed,');
  fails('wrong_number_of_points', () => gc.roundCorners([[1, 1]], 1));
  fails('not_finite', () => gc.roundCorners([[0, 0], [1, NaN]], 1), 'vertices[1]');
});

test('names that are not there are answered by the call that is meant', async () => {
  const answers = (name, text) => assert.throws(() => gc[name], (error) => error instanceof TypeError && error.message.startsWith(`gc.${name} is not there: `) && error.message.includes(text), name);
  for (const [name, text] of [['analyzePath', 'call verifySvg(d)'], ['smoothPath', 'call repairSvg(d)'], ['isG1', 'call continuity(left, right).g_order >= 1'], ['is_g2', 'g_order >= 1'],
    ['failing_joins', 'did you mean failingJoins(...)?'], ['chainJoins', 'call failingJoins(curves'], ['visual_class', 'call joinGrade('], ['surfaceContinuity', 'call edgeContinuity(patchA'],
    ['joinContinuity', 'did you mean continuity(...)?'], ['fillet', 'call roundCorner('], ['Bezier', 'arrays of control points or path data'], ['evaluate', 'evaluate(), interpolate() or fit() of the Python module'],
    ['load', 'the module is loaded'], ['loadFont', 'call verifyFont(bytes)'], ['blendCurves', 'did you mean blend(...)?'], ['xyzzy', 'there are continuity, deviation,']]) answers(name, text);
  for (const name of ['then', 'toJSON', '$$typeof', '__v_isRef', Symbol.iterator, Symbol.toStringTag]) assert.equal(gc[name], undefined);
  assert.equal(await gc, gc);
  assert.ok(!('analyzePath' in gc) && 'blend' in gc && gc.constructor === Object);
  assert.equal(named.load, load);
  for (const name of Object.keys(gc)) assert.equal(typeof named[name], 'function', name);
  assert.deepEqual(named.continuity(phi, psi), gc.continuity(phi, psi));
});

test('options and shapes that are something else', () => {
  fails('malformed_input', () => gc.blend(phi, psi, 'fair'), 'blend: the options are an object { strategy, beta,');
  fails('malformed_input', () => gc.blend(phi, psi, { stratgy: 'fair' }), "there is no option 'stratgy'; did you mean 'strategy'? There are strategy, beta,");
  fails('malformed_input', () => gc.blend(phi, psi, { order: 3 }), "'fair' G2, 'fair_g3' G3");
  fails('malformed_input', () => gc.continuity(phi, psi, 'G2'), 'continuity: the options are an object { maxOrder }');
  fails('malformed_input', () => gc.continuity(phi, psi, { tolerance: 1 }), 'deviation(left, right) encloses');
  fails('malformed_input', () => gc.joinGrade(phi, psi, 5), 'options');
  fails('malformed_input', () => gc.failingJoins([phi, psi], 'G2'), 'options');
  const patch = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]];
  fails('malformed_input', () => gc.continuity(patch, patch), "edgeContinuity(patchA, 'u1', patchB, 'u0') decides two patches; failingJoins(curves)");
  fails('malformed_input', () => gc.edgeContinuity(patch, patch), 'each patch stands before its edge');
  // of three.js, opentype.js and the DOM
  const at = ([x, y]) => ({ x, y, isVector2: true }), [v0, v1, v2, v3] = phi.map(at);
  const cubic = { type: 'CubicBezierCurve', v0, v1, v2, v3 }, line = { type: 'LineCurve', v1: v3, v2: at([1, 3]) };
  assert.deepEqual(gc.continuity(cubic, line), gc.continuity(phi, [[0, 3], [1, 3]]));
  assert.deepEqual([...gc.failingJoins({ type: 'CurvePath', curves: [cubic, line, { v0: at([1, 3]), v1: at([1, 4]), v2: at([0, 5]) }] })], [1]);
  assert.equal(gc.continuity({ getAttribute: (name) => (name === 'd' ? 'M0 0H3' : null) }, 'M3 0H4').g_order, 3);
  fails('malformed_input', () => gc.continuity({ type: 'SplineCurve', points: [v0, v1] }, psi), 'SplineCurve of three.js is no Bézier curve');
  fails('malformed_input', () => gc.continuity({ commands: [] }, psi), 'path.toPathData(17)');
});

test('a bound on the curvature', () => {
  const parabola = [[-1, 1], [0, -1], [1, 1]];
  assert.equal(gc.curvatureExcess(parabola, 2), null);
  assert.deepEqual(gc.curvatureExcess(parabola, '1.9999'), { parameter: [0.5, 0.5], curvature: [2, 2] });
  assert.equal(gc.curvatureExcess([[0, 0], [1, 1], [0, 1], [1, 0]], 1e9).curvature, null);
  fails('unreachable_tolerance', () => gc.curvatureExcess(parabola, -1));
});

test('edges of patches', () => {
  const a = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]];
  const b = (x, z) => [[[1, 0, 0], [1, 1, 0]], [[x, 0, 0], [x, 1, z]]];
  const flat = gc.edgeContinuity(a, 'u1', b(2, 0), 'u0');
  assert.deepEqual([flat.g_order, flat.is_g3, flat.largest_angle_degrees], [2, true, 0]);
  const crease = gc.edgeContinuity(a, 'u1', b(2, 1), 'u0');
  assert.deepEqual([crease.g_order, crease.defect], [0, 'crease']);
  assert.ok(45 <= crease.largest_angle_degrees && crease.largest_angle_degrees < 45.001);
  assert.equal(gc.edgeContinuity(a, 'u0', b(2, 1), 'u1').g_order, -1);
});

test('handles on a grid', () => {
  const { left, right } = gc.alignHandles([100, 3], [50, 2]);
  assert.equal(left[0] * right[1] - left[1] * right[0], 0);
  assert.equal(gc.alignHandles([100, 3], [50, 2], 0), null);
});

test('failing joins of an array, as continuity() decides them one by one', () => {
  let seed = 32;
  const random = (n) => ((seed = (seed * 1103515245 + 12345) % 2147483648), Math.floor((seed / 2147483648) * n));
  for (const [degree, dimension] of [[1, 2], [2, 2], [3, 2], [3, 3], [5, 3]])
    for (const closed of [false, true]) {
      const curves = [], n = 40, random_point = () => Array.from({ length: dimension }, () => random(5) * (random(8) ? 1 : 0.1));
      for (let i = 0; i < n; ++i) {
        const c = Array.from({ length: degree + 1 }, random_point);
        if (i > 0 && random(8)) { // mostly smooth: the legs of the curve before, in one length
          const before = curves[i - 1];
          c[0] = before[degree];
          if (random(8)) c[1] = c[0].map((x, k) => 2 * x - before[degree - 1][k]);
          if (degree > 1 && random(3)) c[2] = c[1].map((x, k) => 2 * x - 2 * c[0][k] + before[degree - 2][k] - x + c[1][k]);
        }
        curves.push(c);
      }
      const array = new Float64Array(curves.flat(2));
      for (const order of ['C0', 'C1', 'C2', 'C3', 'G1', 'G2', 'G3'].concat(dimension === 3 ? ['F3'] : [])) {
        const expected = [];
        for (let i = 0; i < n - (closed ? 0 : 1); ++i)
          if (gc.continuity(curves[i], curves[(i + 1) % n])[`${order[0].toLowerCase()}_order`] < Number(order[1])) expected.push(i);
        assert.deepEqual([...gc.failingJoins(array, { degree, dimension, order, closed })], expected, `${order} ${degree} ${dimension}`);
      }
    }
  assert.equal(gc.failingJoins([]).length, 0);
  assert.ok(gc.failingJoins([0, 0, 1, 1, 2, 2, 3, 3]) instanceof Uint32Array);
});

test('bad input is refused with the code of the package', () => {
  fails('malformed_input', () => gc.continuity(3, phi), 'left');
  fails('malformed_input', () => gc.continuity(phi, [[0, 3], 'abc']), 'right[1]');
  fails('malformed_input', () => gc.continuity(phi, [[0, 3], ['1 2', 0]]), 'right[1][0]');
  fails('malformed_input', () => gc.continuity(phi, [['1/0', 3], [1, 1]]), 'zero denominator');
  fails('malformed_input', () => gc.continuity(phi, [[undefined, 3], [1, 1]]));
  fails('malformed_input', () => gc.continuity(phi, psi, { maxOrder: 33 }));
  fails('not_finite', () => gc.continuity(phi, [[0, NaN], [1, 1]]), 'right[0][1]');
  fails('not_finite', () => gc.failingJoins([0, 0, 1, 1, 2, 2, Infinity, 3]), 'number 6');
  fails('dimension_mismatch', () => gc.continuity(phi, [[0, 0, 0], [1, 1, 1]]));
  fails('dimension_mismatch', () => gc.continuity(phi, [[0, 0], [1]]));
  fails('dimension_mismatch', () => gc.failingJoins([], { order: 'F3' }));
  fails('dimension_mismatch', () => gc.joinGrade([[0, 0, 0], [1, 1, 1]], [[1, 1, 1], [2, 2, 2]]));
  fails('wrong_number_of_points', () => gc.continuity([], phi));
  fails('wrong_number_of_points', () => gc.failingJoins([1, 2, 3]));
  fails('wrong_number_of_points', () => gc.continuity({ points: phi, weights: [1, 1] }, phi));
  fails('zero_weight', () => gc.continuity({ points: psi, weights: [1, -1] }, phi));
  fails('empty_domain', () => gc.continuity({ points: psi, domain: [1, 1] }, phi));
  fails('zero_tangent', () => gc.blend([[1, 1], [1, 1]], psi));
  fails('nonpositive_beta', () => gc.blend(phi, psi, { beta: -1 }));
  fails('malformed_input', () => gc.blend(phi, psi, { strategy: 'fairest' }), 'fairest');
  fails('malformed_input', () => gc.blend(phi, psi, { strategy: 'fair', s1: 1, s2: 2 }));
  fails('malformed_input', () => gc.blend(phi, psi, { strategy: 'free' }));
  fails('curves_do_not_meet', () => gc.roundCorner(phi, psi, 1));
  fails('parameter_outside_domain', () => gc.roundCorner(psi, [[5, -1], [9, 9]], 100));
  fails('malformed_input', () => gc.edgeContinuity([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]], 'w0', [[[0, 0, 0]]], 'u0'), 'w0');
  fails('malformed_input', () => gc.alignHandles([0.5, 1], [1, 1]));
  fails('zero_tangent', () => gc.alignHandles([0, 0], [1, 1]));
  assert.equal(gc.continuity(phi, psi).c_order, -1, 'and the module works on');
});

test('fast enough: the first verdict, and a million joins', async () => {
  const begin = performance.now(), again = await load();
  again.continuity(phi, psi);
  const first = performance.now() - begin;
  const n = 100000, array = new Float64Array(8 * n);
  for (let i = 0; i < n; ++i) array.set([0, i % 2, 1, 0, 2, 0, 3, i % 2].map((c, k) => (k % 2 ? c : c + 3 * i)), 8 * i); // valleys and hills of one curvature
  for (let i = 1; i < n; i += 2) for (const k of [1, 3, 5, 7]) array[8 * i + k] = 2 - array[8 * (i - 1) + k];
  const start = performance.now();
  again.failingJoins(array, { order: 'G1' });
  const rate = n / (performance.now() - start) * 1000;
  console.log(`# first verdict after ${first.toFixed(1)} ms; ${(rate / 1e6).toFixed(1)} million joins a second`);
  assert.ok(first < 1000 && rate > 1e5, 'far from what is usual');
});
