# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import random
import signal
import threading
import time
import unittest
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy

import cases
import geometric_continuity as gc
import interruption


def difference(x, y):
    return [a - b for a, b in zip(x, y)]


def scaled(factor, x):
    return [factor * a for a in x]


def total(*vectors):
    return [sum(c) for c in zip(*vectors)]


def derivatives(points, at_end):
    """The derivatives 0 to 3 at an end of a Bezier curve on [0, 1]."""
    sign, points = (-1, points[::-1]) if at_end else (1, points)
    result, factor, m = [], 1, len(points) - 1
    rows = [list(p) for p in points]
    for k in range(4):
        result.append(scaled(sign ** k * factor, rows[0]) if rows else [0] * len(points[0]))
        factor *= max(m - k, 0)
        rows = [difference(q, p) for p, q in zip(rows, rows[1:])]
    return result


def checked_orders(left, right):
    """c_order, g_order and the shape parameters, by the chain rule."""
    x, y = derivatives(left, True), derivatives(right, False)
    c = -1
    while c < 3 and x[c + 1] == y[c + 1]:
        c += 1
    if c < 0:
        return -1, -1, ()
    i = next((i for i, v in enumerate(x[1]) if v != 0), None)
    if i is None:
        return c, 0, ()
    betas = []
    for k in range(1, 4):
        if k == 1:
            rest = y[1]
        elif k == 2:
            rest = difference(y[2], scaled(betas[0] ** 2, x[2]))
        else:
            rest = difference(y[3], total(scaled(3 * betas[0] * betas[1], x[2]), scaled(betas[0] ** 3, x[3])))
        beta = Fraction(rest[i]) / x[1][i]
        if rest != scaled(beta, x[1]) or (k == 1 and beta <= 0):
            break
        betas.append(beta)
    return c, len(betas), tuple(betas)


def random_number(random):
    return Fraction(random.randint(-99, 99), random.choice([1, 1, 2, 3, 7, 10 ** 9 + 7, 3 ** 40]))


def random_join(random):
    """Two curves whose join has a random order."""
    dimension, m, n = random.choice([1, 2, 2, 2, 3, 3, 4]), random.randint(1, 6), random.randint(1, 6)
    m = max(m, 2) if dimension > 3 else m  # a line there is refused: it looks like two rows of coordinates
    left = [[random_number(random) for _ in range(dimension)] for _ in range(m + 1)]
    if random.random() < 0.1:
        left[-2] = left[-1]
    x = derivatives(left, True)
    b1, b2, b3 = random.choice([1, Fraction(random.randint(1, 9), random.randint(1, 9))]), 0, 0
    if random.random() < 0.6:
        b2, b3 = random_number(random), random_number(random)
    y = [x[0], scaled(b1, x[1]), total(scaled(b1 ** 2, x[2]), scaled(b2, x[1])),
         total(scaled(b1 ** 3, x[3]), scaled(3 * b1 * b2, x[2]), scaled(b3, x[1]))]
    wrong = random.randint(0, 5)
    if wrong < 4:
        y[wrong][random.randrange(dimension)] += random.choice([1, Fraction(1, 10 ** 30)])
    degree = max(3, n)
    jet = y + [[random_number(random) for _ in range(dimension)] for _ in range(degree - 3)]
    return left, cases.points_of_start(jet)


class Joins(unittest.TestCase):
    def test_cases(self):
        number = 0
        for topic in ("joins", "errata"):
            for name, op, given, expected in cases.read(topic):
                if op != "classify_join" or "weights" in str(given.keys()) or isinstance(given["left"], dict):
                    continue
                with self.subTest(name):
                    left, right = cases.points_of_end(given["left"]), cases.points_of_start(given["right"])
                    join = gc.continuity(left, right, int(given["kmax"]))
                    for member in ("c_order", "g_order", "f_order", "regular"):
                        self.assertEqual(getattr(join, member), expected[member], member)
                    self.assertEqual(list(join.betas), expected["betas"])
                    if len(given["left"]) > 3 and len(given["right"]) > 3:
                        self.assertEqual(join.tangent_equal, expected["tangent_continuous"])
                        for member in ("curvature_equal", "curvature_vector_equal", "torsion_equal"):
                            self.assertEqual(getattr(join, member), expected[member], member)
                    number += 1
        self.assertGreater(number, 50)

    def test_random_joins(self):
        rng = random.Random(33)
        seen = set()
        for i in range(600):
            left, right = random_join(rng)
            c, g, betas = checked_orders(left, right)
            join = gc.continuity(left, right)
            self.assertEqual((join.c_order, join.g_order, join.betas), (c, g, betas), (i, left, right))
            for order in range(4):
                self.assertEqual(len(gc.failing_joins([left, right], f"G{order}")) == 0, g >= order) if len(left) == len(right) else None
            seen.add(g)
        self.assertEqual(seen, {-1, 0, 1, 2, 3})

    def test_random_joins_of_floats(self):
        rng = random.Random(34)
        for dimension in (2, 3):
            for _ in range(300):
                left = [[rng.randint(-9, 9) / 4 for _ in range(dimension)] for _ in range(4)]
                right = [left[-1], total(left[-1], scaled(rng.choice([0.5, 1, 2]), difference(left[-1], left[-2])))]
                right += [[rng.randint(-9, 9) / 4 for _ in range(dimension)] for _ in range(2)]
                if rng.random() < 0.5:  # C2
                    right[1] = difference(scaled(2, left[-1]), left[-2])
                    right[2] = total(scaled(4, left[-1]), scaled(-4, left[-2]), left[-3])
                if rng.random() < 0.2:
                    right[2] = [right[2][0] + 2 ** -40] + right[2][1:]
                exact = [[[Fraction(x) for x in p] for p in c] for c in (left, right)]
                c, g, betas = checked_orders(*exact)
                join = gc.continuity(numpy.array(left), numpy.array(right))
                self.assertEqual((join.c_order, join.g_order, join.betas), (c, g, betas))

    def test_numbers_are_read_as_they_are(self):
        third = Fraction(1, 3)
        self.assertEqual(gc.continuity([[0, 0], [third, 1]], [[third, 1], [2 * third, 2]]).g_order, 3)
        self.assertEqual(gc.continuity([[0, 0], [1 / 3, 1]], [[third, 1], [1, 1]]).g_order, -1)
        tenth = Decimal("0.1")
        self.assertEqual(gc.continuity([[0, 0], [tenth, 1]], [[Fraction(1, 10), 1], [1, 1]]).c_order, 0)
        self.assertEqual(gc.continuity([[0, 0], [0.1, 1]], [[Fraction(1, 10), 1], [1, 1]]).c_order, -1)
        big = 2 ** 64 + 1
        self.assertEqual(gc.continuity([[0, 0], [big, 1]], [[float(big), 1], [1, 1]]).c_order, -1)
        self.assertEqual(gc.continuity(numpy.array([[0, 0], [2 ** 62 + 1, 1]]), [[2 ** 62 + 1, 1], [1, 1]]).c_order, 0)
        self.assertEqual(gc.continuity(numpy.array([[0, 0], [2 ** 62 + 1, 1]]), [[2 ** 62, 1], [1, 1]]).c_order, -1)
        self.assertEqual(gc.continuity(numpy.float32([[0, 0], [0.1, 1]]), [[numpy.float32(0.1), 1], [1, 1]]).c_order, 0)
        huge = 10 ** (6000 if gc.uses_gmp else 500)  # without GMP, greatest common divisors of longer numbers take long
        join = gc.continuity([[0, 0], [huge, 1]], [[huge, 1], [huge + huge * huge, 1 + huge]])
        self.assertEqual(join.betas[0], huge)
        join = gc.continuity([[0, 0], [-Fraction(1, huge), 1]], [[-Fraction(1, huge), 1], [-Fraction(3, huge), 3]])
        self.assertEqual(join.betas[0], 2)
        self.assertTrue(all(isinstance(b, Fraction) for b in join.betas))

    def test_refused(self):
        line = [[0, 0], [1, 1]]
        for wrong, code in (([[0, 0], [1, float("nan")]], "not_finite"), ([[0, 0], [1, Decimal("inf")]], "not_finite"),
                            (numpy.array([[0, 0], [1, numpy.inf]]), "not_finite"), ([[0, 0, 0]], "dimension_mismatch"),
                            ([1, 2], "wrong_number_of_points"), ([], "wrong_number_of_points")):
            for pair in ((wrong, line), (line, wrong)):
                with self.assertRaises(gc.Error) as caught:
                    gc.continuity(*pair)
                self.assertEqual(caught.exception.code, code)
        with self.assertRaises(gc.Error) as caught:
            gc.visual_class([[0, 0, 0], [1, 1, 1]], [[1, 1, 1], [2, 2, 2]])
        self.assertEqual((caught.exception.code, caught.exception.place), ("dimension_mismatch", "visual_class"))
        with self.assertRaises(gc.Error) as caught:
            gc.continuity(line, line, -1)
        self.assertEqual((caught.exception.code, caught.exception.place), ("negative_count", "continuity"))
        self.assertEqual(caught.exception.reason, "order")
        for no_number in ("1", None, 1j, [2]):
            with self.assertRaises((TypeError, ValueError)):
                gc.continuity([[0, 0], [1, no_number]], line)

    def test_grades(self):
        line = [[0, 0], [1, 0]]
        grades = [gc.visual_class(line, [[1, 0], [2, y]]) for y in (0, Decimal("0.05"), 1)]
        self.assertEqual(grades, [gc.Visual_class.g2, gc.Visual_class.kink, gc.Visual_class.corner])
        self.assertEqual(gc.visual_class(line, [[1, 0], [2, 1]], 45), gc.Visual_class.kink)
        self.assertEqual(gc.visual_class(line, [[1, 0], [2, 1]], Decimal("44.999")), gc.Visual_class.corner)
        self.assertIsNone(gc.visual_class(line, [[1, 0], [1, 0]]))
        with self.assertWarns(DeprecationWarning):
            self.assertIs(gc.join_grade, gc.visual_class)
        size = gc.kink_size(line, [[1, 0], [2, 1]])
        self.assertTrue(size.angle.lower <= numpy.pi / 4 <= size.angle.upper)

    def test_deviation(self):
        d = gc.deviation([[0, 0], [1, 0]], [[1, 1], [2, 2]])
        self.assertEqual(d.gap, gc.deviation([[0, 0], [1, 0]], [[1, 1], [3, 2]]).gap)
        low, high = d.tangent_angle
        self.assertTrue(low <= numpy.pi / 4 <= high and high - low < 1e-15)
        self.assertEqual(list(d.gap), [1, 1])
        self.assertIsNone(d.torsion_jump)

    def test_deviation_of_curves_side_by_side(self):
        curve = [(0, 0), (1, 2), (3, 3), (5, 2)]
        spline = gc.interpolate(curve)
        for left, right in ((curve, [(x, y + 1) for x, y in curve]), (spline, gc.interpolate([(x, y + 1) for x, y in curve])),
                            (spline, numpy.array([0.5j, 1 + 1.5j, 5 + 2.5j]))):
            with self.assertWarnsRegex(UserWarning, "the distance of whole curves is not measured") as caught:
                gc.deviation(left, right)
            self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            gc.deviation(curve, curve)  # how a curve closes
            gc.deviation(curve, [(5, 3), (6, 3)])
            gc.deviation(curve, [(5, 2), (4, 0), (0, 1)])

    def test_edges(self):
        patch = numpy.zeros((2, 2, 3))
        patch[1, :, 0] = 1
        patch[:, 1, 1] = 1
        other = patch + [1, 0, 0]
        self.assertEqual(gc.edge_continuity(patch, "u1", other, "u0").g_order, 2)
        other[1, 1, 2] = 1e-9
        edge = gc.edge_continuity(patch, "u1", other, "u0")
        self.assertEqual(edge.g_order, 0)
        self.assertTrue(0.9e-9 < edge.largest_angle < 1.1e-9)
        self.assertEqual(gc.edge_continuity(patch.astype(int).tolist(), "u0", other, "u1").g_order, -1)
        with self.assertRaises(gc.Error):
            gc.edge_continuity(patch, "w", other, "u0")

    def test_common_edges(self):
        """Of a strip with heights, on floats and on fractions, every edge of one patch to every edge of the other, in both directions."""
        def refused(code, text, *patches):
            with self.assertRaises(gc.Error) as caught:
                gc.edge_continuity(*patches)
            self.assertEqual((caught.exception.code, caught.exception.place), (code, "edge_continuity"))
            self.assertIn(text, caught.exception.reason)

        a = numpy.array([[(u, v, u * v * (v - 1)) for v in range(3)] for u in range(3)], float)
        b = numpy.array([[(u + 2, v, (2 + 2 * u * u) * v * (v - 1)) for v in range(3)] for u in range(3)], float)
        turned = [(x, edges) for x, edges in ((b, "u0"), (b[::-1], "u1"), (b.swapaxes(0, 1), "v0"), (b[:, ::-1], "u0"), (b.swapaxes(0, 1)[::-1, ::-1], "v1"))]
        for patch, edge in turned:
            for number in (float, Fraction):
                s, t = (numpy.vectorize(number, otypes=[object if number is Fraction else float])(x) for x in (a, patch))
                found, named = gc.edge_continuity(s, t), gc.edge_continuity(s, "u1", t, edge)
                self.assertEqual((str(found), found.whole_a, found.largest_angle), (str(named), True, named.largest_angle))
                self.assertEqual(found.g_order, 0)
        flat = numpy.array([[(u, v, 0) for v in (0, 2)] for u in (0, 2)])
        part = gc.edge_continuity(flat, numpy.array([[(2 + u, v, 0) for v in (0, 1)] for u in (0, 1)]))
        self.assertEqual((part.whole_a, part.whole_b), (False, True))
        refused("curves_do_not_meet", "no edge of one surface is an edge of the other", a, b + [0, 0, 1])
        refused("several_common_edges", 'u0 and u0, u1 and u1, v0 and v0, v1 and v1; name one pair, as in edge_continuity(a, "u1", b, "u0")', a, a.copy())
        tube = numpy.array([[(*p, v) for v in (0, 1)] for p in ((1, 0), (1, 2), (-1, 2), (-1, -2), (1, -2), (1, 0))])
        self.assertEqual(gc.edge_continuity(tube, tube).g_order, 2)  # it is symmetric
        refused("wrong_number_of_points", "two surfaces are needed", a)
        refused("parameter_outside_domain", "there is no edge 'None'", a, "u1", b)


def random_chain(n, dimension, seed=1):
    rng = numpy.random.default_rng(seed)
    chain = rng.integers(-9, 9, (n, 4, dimension)).astype(float)
    chain[1:, 0] = chain[:-1, 3]
    smooth = rng.random(n - 1) < 0.7
    chain[1:, 1][smooth] = (2 * chain[1:, 0] - chain[:-1, 2])[smooth]
    second = 4 * chain[:-1, 3] - 4 * chain[:-1, 2] + chain[:-1, 1]
    chain[1:, 2][smooth] = second[smooth]
    return chain


class Many_joins(unittest.TestCase):
    def expected(self, chain, order):
        pairs = zip(chain, chain[1:])
        kind = {"C": "c_order", "G": "g_order", "F": "f_order"}[order[0]]
        return [i for i, (p, q) in enumerate(pairs) if getattr(gc.continuity(p, q), kind) < int(order[1])]

    def test_orders(self):
        for dimension in (2, 3, 4):
            chain = random_chain(200, dimension)
            for order in ("C0", "C1", "C2", "C3", "G0", "G1", "G2", "G3", "F0", "F1", "F2", "F3"):
                expected = self.expected(chain, order)
                self.assertEqual(gc.failing_joins(chain, order).tolist(), expected, (dimension, order))
                self.assertEqual(gc.failing_joins(chain, order, parallel=True).tolist(), expected)
                self.assertEqual(gc.failing_joins(chain.astype(object), order).tolist(), expected)

    def test_tolerances(self):
        """The joins that hold within tolerances, by order_within of each."""
        for dimension in (2, 3):
            chain = random_chain(300, dimension)
            chain[::3, 1] += 1e-7
            chain[::50, 0] += 1e-4
            exactly = {order: gc.failing_joins(chain, order).tolist() for order in ("G0", "G1", "G2", "G3")}
            for bounds in ({"tolerance": 1e-3}, {"tangent_angle": 1e-6, "gap": 1e-3}, {"gap": Fraction(1, 5000)}, {"tolerance": 1e-3, "curvature_jump": 0}):
                within = [gc.order_within(p, q, **bounds).verdicts for p, q in zip(chain, numpy.roll(chain, -1, axis=0))]
                for k, order in enumerate(exactly):
                    expected = [i for i, verdicts in enumerate(within) if verdicts[k] != "proved"]
                    self.assertEqual(gc.failing_joins(chain, order, closed=True, **bounds).tolist(), expected, (dimension, order, bounds))
                    self.assertEqual(gc.failing_joins(list(chain), order, **bounds).tolist(), [i for i in expected if i < 299])
                    self.assertTrue(set(expected) <= {*exactly[order], 299})
            self.assertLess(len(gc.failing_joins(chain, "G1", tolerance=1e-3)), len(exactly["G1"]))
        bend = [[(0, 0), (1, 0)], [(1, 0), (2, Fraction(1, 1000))]]
        low, high = map(Fraction, gc.deviation(*bend).tangent_angle)
        self.assertEqual(gc.order_within(*bend, tangent_angle=(low + high) / 2).verdicts[1], "undecided")
        self.assertEqual([gc.failing_joins(bend, "G1", tangent_angle=a).tolist() for a in (low, (low + high) / 2, high)], [[0], [0], []])
        # the relative jumps of derivatives: 1/1000 of the first, 1/500 of the second ones
        left, right = [(0, 0), (1, 0), (2, 1)], [(2, 1), (3, 2 + Fraction(1, 1000)), (4, 3 + Fraction(4, 1000))]
        self.assertEqual([gc.failing_joins([left, right], order).tolist() for order in ("C0", "C1", "C2")], [[], [0], [0]])
        self.assertEqual([gc.failing_joins([left, right], "C1", tangent_angle=a).tolist() for a in (1e-3, 7e-4)], [[], [0]])
        domains = [gc.Bezier_curve(left), gc.Bezier_curve(right, None, (0, 2))]  # at half the speed
        self.assertEqual([gc.failing_joins(domains, "C1", tangent_angle=a).tolist() for a in (0.6, 0.4)], [[], [0]])
        flat = [[(0, 0), (1, 1), (2, 0)], [(2, 0), (3, -1), (4, Fraction(-4001, 1000))]]
        self.assertEqual([gc.failing_joins(flat, "C2", tangent_angle=1e-3, curvature_jump=a).tolist() for a in (0.002, 1e-4)], [[], [0]])
        for order in ("C3", "F1"):
            with self.assertRaisesRegex(gc.Error, "parameter_outside_domain: failing_joins: tolerances are those of orders G0 to G3 and C0 to C2, not of " + order):
                gc.failing_joins(chain, order, tolerance=1e-3)

    def test_strides(self):
        chain = random_chain(500, 2)
        expected = gc.failing_joins(chain).tolist()
        self.assertTrue(0 < len(expected) < 499)
        wide = numpy.full((500, 8, 5), numpy.nan)
        wide[:, ::2, 1:4:2] = chain
        self.assertEqual(gc.failing_joins(wide[:, ::2, 1:4:2]).tolist(), expected)
        self.assertEqual(gc.failing_joins(numpy.asfortranarray(chain)).tolist(), expected)
        self.assertEqual(gc.failing_joins(chain[::-1, ::-1]).tolist(), [498 - i for i in expected[::-1]])
        packed = numpy.zeros(500, dtype=[("flag", "u1"), ("points", "f8", (4, 2))])  # numbers are not aligned
        packed["points"] = chain
        self.assertEqual(gc.failing_joins(packed["points"]).tolist(), expected)
        self.assertEqual(gc.failing_joins(chain.astype(numpy.float32)).tolist(), expected)
        self.assertEqual(gc.failing_joins(chain.astype(">f8")).tolist(), expected)
        self.assertEqual(gc.failing_joins(chain.astype(numpy.int32)).tolist(), expected)
        self.assertEqual(gc.failing_joins(chain.tolist()).tolist(), expected)

    def test_ends_of_parts(self):
        n = 3 * 2 ** 13 + 2
        chain = numpy.zeros((n, 4, 2))
        chain[:, :, 0] = numpy.arange(n)[:, None] + numpy.arange(4) / 4
        chain[:, 3, 0] = numpy.arange(n) + 1
        expected = [0, 2 ** 13 - 1, 2 ** 13, 2 ** 14, n - 2]
        for i in expected:
            chain[i + 1:, :, 1] += 1
        self.assertEqual(gc.failing_joins(chain, "C0").tolist(), expected)
        self.assertEqual(gc.failing_joins(chain, "C0", closed=True).tolist(), expected + [n - 1])
        for i in (0, 2 ** 13, n - 1):
            wrong = chain.copy()
            wrong[i, 2, 1] = numpy.nan
            with self.assertRaises(gc.Error) as caught:
                gc.failing_joins(wrong, "C0")
            self.assertEqual(caught.exception.reason, f"curve {i}")

    def test_small_and_refused(self):
        self.assertEqual(gc.failing_joins(numpy.zeros((0, 4, 2))).tolist(), [])
        self.assertEqual(gc.failing_joins(numpy.zeros((1, 4, 2)), "G1").tolist(), [])
        self.assertEqual(gc.failing_joins(numpy.zeros((1, 4, 2)), "G1", closed=True).tolist(), [0])
        for wrong in (numpy.zeros((4, 2)), numpy.zeros((2, 0, 2)), numpy.zeros((2, 4, 0)), [1]):
            with self.assertRaises(gc.Error):
                gc.failing_joins(wrong)
        with self.assertRaises(gc.Error):
            gc.failing_joins(numpy.zeros((2, 4, 2)), "G4")

    def test_other_threads_run_meanwhile(self):
        chain = numpy.tile(random_chain(1000, 3), (300, 1, 1))
        seen, done = [], threading.Event()

        def decide():
            gc.failing_joins(chain, "F3")
            done.set()

        thread = threading.Thread(target=decide)
        thread.start()
        while not done.is_set():
            seen.append(None)
            time.sleep(0)
        thread.join()
        self.assertGreater(len(seen), 10)

    @unittest.skipUnless(hasattr(signal, "setitimer"), "no timers")
    def test_interruption(self):
        one = random_chain(2, 3)
        chain = numpy.lib.stride_tricks.as_strided(one, (2 ** 33, 4, 3), (0,) + one.strides[1:])  # many hours of work
        self.assertLess(interruption.seconds_until(lambda: gc.failing_joins(chain, "C0")), 10)


if __name__ == "__main__":
    unittest.main()
