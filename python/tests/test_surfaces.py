# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import math
import random
import unittest
from fractions import Fraction

import numpy

import geometric_continuity as gc

A = [[(0, 0, 0), (0, 1, 1), (0, 3, 0)], [(4, 0, 0), (4, Fraction(1, 3), 0), (4, 3, 1)]]
B = [[(0, 3, 0), (0, 5, 1), (0, 6, 0)], [(4, 3, 1), (4, 4, 0), (4, 7, 1)]]


def derivatives(points, edge, order):
    """The derivatives across an edge, the last of the rows of control points, as Bernstein coefficients, by differences."""
    net = numpy.array(points, dtype=object)
    net = {"v0": net.transpose(1, 0, 2)[::-1], "v1": net.transpose(1, 0, 2), "u0": net[::-1], "u1": net}[edge]
    rows, found = list(net), []
    for k in range(order + 1):
        found.append(rows[-1])
        rows = [(len(rows) - 1) * (b - a) for a, b in zip(rows, rows[1:])] or [0 * found[0]]
    return found


class Matches(unittest.TestCase):
    def test_orders(self):
        for order in ("G1", "G2", "G3"):
            k = int(order[1])
            m = gc.match(A, B, order=order)
            self.assertEqual((m.before.g_order, m.before.defect), (0, "crease"))
            self.assertEqual((m.after.g_order, m.proved), (min(k, 2), True))
            self.assertEqual(len(m.shape), 2 * k)
            self.assertTrue(all(isinstance(x, Fraction) for x in m.points.flat))
            # the opposite edge keeps its derivatives
            for x, y in zip(derivatives(m.points, "v1", k), derivatives(B, "v1", k)):
                self.assertEqual(x.tolist(), y.tolist())
            # the same on floats, up to rounding
            f = gc.match(numpy.array(A, float), numpy.array(B, float), order=order)
            self.assertEqual(f.points.dtype, float)
            numpy.testing.assert_allclose(f.points, m.points.astype(float), atol=1e-14)
            self.assertTrue(f.proved)
            self.assertLess(f.after.largest_angle, 1e-12)
            self.assertGreater(f.before.largest_angle, 0.5)

    def test_formula(self):
        """The derivatives across the edge are those of the numbers: S_v = alpha C' + beta T and so on, on every pair of edges."""
        seed = 24
        random.seed(seed)
        net = lambda p, q: [[[Fraction(random.randint(-9, 9)) for _ in range(3)] for _ in range(q + 1)] for _ in range(p + 1)]
        for edge_a in ("u0", "u1", "v0", "v1"):
            for edge_b in ("u0", "u1", "v0", "v1"):
                with self.subTest(seed=seed, edges=(edge_a, edge_b)):
                    a, b = net(2, 2), net(2, 3)
                    m = gc.match(a, b, (edge_a, edge_b), 2, alpha=Fraction(1, 5), beta=3, alpha2=Fraction(-1, 2), delta=2)
                    self.assertEqual(list(m.shape.values()), [Fraction(1, 5), 3, Fraction(-1, 2), 2])
                    c, t, w = derivatives(a, edge_a, 2)
                    s = derivatives(m.points, edge_b, 2)  # outwards, at the end of the second surface
                    n = len(s[0]) - 1
                    along = m.after.reversed
                    at = lambda rows, u: sum(math.comb(len(rows) - 1, i) * u**i * (1 - u)**(len(rows) - 1 - i) * r for i, r in enumerate(rows))
                    slope = lambda rows: [(len(rows) - 1) * (y - x) for x, y in zip(rows, rows[1:])] or [0 * rows[0]]
                    for u in (Fraction(0), Fraction(1, 3), Fraction(1)):
                        v, sign = (1 - u, -1) if along else (u, 1)
                        cc, tt = at(slope(c), v), at(slope(t), v)
                        first = Fraction(1, 5) * sign * cc * sign + 3 * at(t, v)
                        second = (Fraction(1, 25) * at(slope(slope(c)), v) + Fraction(6, 5) * tt + 9 * at(w, v)
                                  - Fraction(1, 2) * cc + 2 * at(t, v))
                        if not along:
                            self.assertEqual((-at(s[1], u)).tolist(), first.tolist())
                            self.assertEqual(at(s[2], u).tolist(), second.tolist())
                    self.assertTrue(m.proved or m.after.normal_vanishes)
                    self.assertGreaterEqual(n, 2)

    def test_edges(self):
        """Without names the edges are those that are nearest, and the common one where there is one."""
        self.assertEqual(gc.match(A, B).edges, ("v1", "v0"))
        turned = numpy.array(B, dtype=object).transpose(1, 0, 2)[::-1]
        m = gc.match(A, turned, order="G1")
        self.assertEqual((m.edges, m.before.g_order, m.after.g_order), (("v1", "u1"), 0, 1))
        shifted = numpy.array(B, dtype=object) + [0, Fraction(1, 10), 0]
        m = gc.match(A, shifted)
        self.assertEqual((m.edges, m.before.g_order, m.after.g_order), (("v1", "v0"), -1, 2))
        square = [[(x, y, 0) for y in (0, 1)] for x in (0, 1)]
        with self.assertRaises(gc.Error) as caught:
            gc.match(square, [[(x, y, 1) for y in (0, 1)] for x in (0, 1)])
        self.assertEqual(caught.exception.code, "several_common_edges")

    def test_errors(self):
        for call, code in ((lambda: gc.match(A, B, "v1"), "parameter_outside_domain"),
                           (lambda: gc.match(A, B, ("v1", "x")), "parameter_outside_domain"),
                           (lambda: gc.match(A, B, order="G4"), "parameter_outside_domain"),
                           (lambda: gc.match(A, B, order=True), "parameter_outside_domain"),
                           (lambda: gc.match(A, B, beta=0), "nonpositive_beta"),
                           (lambda: gc.match(A, B, order=1, delta=2), "parameter_outside_domain"),
                           (lambda: gc.match([(0, 0, 0)], B), "wrong_number_of_points"),
                           (lambda: gc.match(numpy.zeros((2, 2, 3)), B, ("v1", "v0")), "zero_tangent"),
                           (lambda: gc.match(A, numpy.full((2, 2, 3), numpy.nan)), "not_finite")):
            with self.assertRaises(gc.Error) as caught:
                call()
            self.assertEqual(caught.exception.code, code)
        with self.assertRaises(TypeError):
            gc.match(A, B, strategy="fair")


if __name__ == "__main__":
    unittest.main()
