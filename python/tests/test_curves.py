# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later

import importlib
import inspect
import os
import random
import shutil
import subprocess
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import numpy

import cases
import geometric_continuity as gc
import interruption

LEFT, RIGHT = [(-3, 0), (-3, 2), (-2, 3), (0, 3)], [(4, 0), (5, -1), (6, -1)]
LEFT_3, RIGHT_3 = [(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 1, 1)], [(6, 2, 2), (7, 2, 3), (8, 1, 3), (9, 1, 1)]


class Blends(unittest.TestCase):
    def test_cases(self):
        number = 0
        for topic in ("quintic", "septic"):
            for name, op, given, expected in cases.read(topic):
                if "error" in expected or given.get("strategy") == "free" or "points" not in expected:
                    continue
                with self.subTest(name):
                    blend = gc.blend(given["phi"], given["psi"], given["strategy"], beta=given["beta"], eta=given["eta"])
                    self.assertEqual(blend.points.tolist(), expected["points"])
                    if "fallback" in expected:
                        self.assertEqual([blend.fallback_start, blend.fallback_end], expected["fallback"])
                    number += 1
        self.assertGreater(number, 60)

    def test_every_strategy_is_proved(self):
        for name in gc.STRATEGIES[:-1]:
            for left, right in ((LEFT, RIGHT), (LEFT_3, RIGHT_3)):
                gamma = gc.blend(left, right, name)
                self.assertTrue(all(isinstance(x, Fraction) for x in gamma.points.flat))
                for join in (gc.continuity(left, gamma.points), gc.continuity(gamma.points, right)):
                    septic = len(gamma.points) == 8
                    self.assertGreaterEqual(join.f_order if "f3" in name else join.g_order, 3 if septic and "f3" not in name else 2)
                self.assertEqual(gamma.fairness is not None, name.startswith("fair"))
        self.assertEqual(gc.fair(LEFT, RIGHT).points.tolist(), gc.blend(LEFT, RIGHT, "fair").points.tolist())
        self.assertEqual(gc.continuity(LEFT, gc.fair(LEFT, RIGHT, 3).points).g_order, 3)

    def test_free(self):
        parameters = [Fraction(1, 3), 2]
        gamma = gc.blend(LEFT, RIGHT, "free", parameters=parameters)
        self.assertEqual(gc.continuity(LEFT, gamma.points).g_order, 2)
        self.assertEqual(len(gc.blend(LEFT, RIGHT, "free", parameters=[0] * 6).points), 8)
        for wrong in ([], [1], [1, 2, 3]):
            with self.assertRaises(gc.Error):
                gc.blend(LEFT, RIGHT, "free", parameters=wrong)

    def test_kinds_of_results(self):
        floats = numpy.array(LEFT, dtype=float)
        self.assertEqual(gc.blend(floats, RIGHT).points.dtype, numpy.float64)
        self.assertEqual(gc.blend(LEFT, RIGHT, exact=False).points.dtype, numpy.float64)
        exact = gc.blend(floats, RIGHT, exact=True)
        self.assertEqual(exact.points.tolist(), gc.blend(LEFT, RIGHT).points.tolist())
        self.assertIsInstance(exact.beta, Fraction)
        rounded = gc.blend([(Decimal("0.1"), 0.5), (1, 1)], RIGHT)  # constructed exactly, then rounded
        self.assertEqual(rounded.points.dtype, numpy.float64)
        self.assertEqual(rounded.points.tolist(),
                         gc.blend([(Decimal("0.1"), Fraction(1, 2)), (1, 1)], RIGHT).points.astype(float).tolist())

    def test_refused(self):
        for arguments, options, code in ((([(0, 0), (0, 0)], RIGHT), {}, "zero_tangent"), ((LEFT, RIGHT), {"beta": 0}, "nonpositive_beta"),
                                         ((LEFT, RIGHT, "none"), {}, "parameter_outside_domain"), ((LEFT, RIGHT_3), {}, "dimension_mismatch")):
            with self.assertRaises(gc.Error) as caught:
                gc.blend(*arguments, **options)
            self.assertEqual(caught.exception.code, code)
            self.assertEqual(caught.exception.place, "blend")

    def test_representable(self):
        gamma = gc.representable_blend(LEFT, RIGHT)
        self.assertEqual(gc.continuity(gamma.phi, gamma.points).g_order, 2)
        self.assertEqual(gc.continuity(gamma.points, gamma.psi).g_order, 2)
        with self.assertRaises(gc.Error):
            gc.representable_blend([(Fraction(1, 3), 0), (1, 1)], RIGHT)

    def test_corners(self):
        corner = gc.round_corner([(0, 0), (4, 0)], [(4, 0), (4, 4)], 1.5)
        self.assertEqual(gc.continuity(corner.left, corner.blend).g_order, 2)
        self.assertEqual(gc.continuity(corner.blend, corner.right).g_order, 2)
        self.assertEqual(corner.left_cut, Fraction(5, 8))
        self.assertEqual(gc.round_corner([(0, 0.), (4, 0)], [(4, 0), (4, 4)], 1).blend.dtype, numpy.float64)
        with self.assertRaises(gc.Error) as caught:
            gc.round_corner([(0, 0), (4, 0)], [(4, 0), (4, 4)], 5)
        self.assertIn("5", caught.exception.reason)

    def test_corners_of_radius(self):
        right = gc.round_corner([(0, 0), (4, 0)], [(4, 0), (4, 4)], radius=1.5)
        self.assertEqual((right.left_cut, right.right_cut), (Fraction(5, 8), Fraction(3, 8)))
        # tan(theta / 2) = 1/2 for the turn of cosine 3/5
        half = gc.round_corner([(0, 0), (5, 0)], [(5, 0), (8, 4)], radius=2)
        self.assertEqual((half.left_cut, half.right_cut), (Fraction(4, 5), Fraction(1, 5)))
        general = gc.round_corner([(0., 0), (4, 0)], [(4, 0), (5, 4)], radius=0.5)
        distance = 0.5 * numpy.tan(numpy.arctan2(4, 1) / 2)
        numpy.testing.assert_allclose(4 - general.left[-1, 0], distance, rtol=1e-12)
        for given in ({}, dict(distance=1, radius=1), dict(radius=0), dict(radius=-1)):
            with self.assertRaises(gc.Error) as caught:
                gc.round_corner([(0, 0), (4, 0)], [(4, 0), (4, 4)], **given)
            self.assertEqual(caught.exception.code, "parameter_outside_domain")

    def test_corners_by_cubics(self):
        left, right = [(0, 0), (4, 0)], [(4, 0), (4, 4)]
        for strategy, cubics in (("cubic", 1), ("two_cubics", 2)):
            corner = gc.round_corner(left, right, 1, strategy)
            self.assertEqual(len(corner.blend), cubics)
            chain = [corner.left, *corner.blend, corner.right]
            self.assertTrue(all(join.g_order >= 2 for join in gc.chain_joins(chain)))
        self.assertEqual(gc.round_corner(left, right, 1, "cubic").blend.points.tolist(), [[3, 0], [4, 0], [4, 0], [4, 1]])

    def test_corners_of_polygons(self):
        square = [(0, 0), (4, 0), (4, 3), (0, 3)]
        rounded = gc.round_corners(square, 1, closed=True)
        self.assertEqual([len(c) for c in rounded], [2, 6] * 4)
        self.assertEqual([rounded[0].tolist(), rounded[6].tolist()], [[[1, 0], [3, 0]], [[0, 2], [0, 1]]])
        self.assertEqual([join.g_order for join in gc.chain_joins(rounded, closed=True)], [2] * 8)
        corner = gc.round_corner(square[:2], square[1:3], 1)
        self.assertEqual(gc.continuity(rounded[0], corner.blend).g_order, 2)
        again = gc.round_corners([*square, square[0]], 1)  # ends where it starts
        self.assertEqual([c.tolist() for c in again], [c.tolist() for c in rounded])
        # a quarter remains of each side, and a vertex on a line is no corner
        bent = gc.round_corners([(0, 0), (4, 0), (8, 0), (8, 8)], 100)
        self.assertEqual([c.tolist()[0] for c in bent], [[0, 0], [4, 0], [5, 0], [8, 3]])
        self.assertEqual([c.tolist()[0] for c in gc.round_corners([(0, 0), (8, 0), (8, 8), (0, 8)], 100)], [[0, 0], [5, 0], [8, 3], [8, 5], [5, 8]])
        tips = gc.round_corners([(0, 0), (5, 0), (8, 4)], radius=2)  # tan(theta / 2) = 1/2
        self.assertEqual([tips[0].tolist(), tips[2].tolist()], [[[0, 0], [4, 0]], [[Fraction(28, 5), Fraction(4, 5)], [8, 4]]])
        cubics = gc.round_corners(numpy.array(square, float), 1, True, "cubic")
        self.assertEqual((cubics[1].tolist(), cubics[1].dtype), ([[3, 0], [4, 0], [4, 0], [4, 1]], numpy.float64))
        self.assertEqual(len(gc.round_corners([(0, 0, 0), (1, 0, 0), (1, 1, 1)], 0.25)), 3)
        self.assertEqual(len(gc.round_corners([0, 4, 4 + 3j], 1)), 3)
        for code, text, arguments in (("parameter_outside_domain", "the vertices 1 and 2 are one point", ([(0, 0), (1, 0), (1, 0)], 1)),
                                      ("zero_tangent", "vertex 1: the curves turn back", ([(0, 0), (2, 0), (1, 0)], 1)),
                                      ("parameter_outside_domain", "vertex 1: the distance is not positive", (square, 0)),
                                      ("parameter_outside_domain", "the distance is a number, not [1, 2]", (square, [1, 2])),
                                      ("parameter_outside_domain", "a distance is needed, or a radius", (square,)),
                                      ("parameter_outside_domain", "closed is True or False, not 1", (square, 1, 1)),
                                      ("wrong_number_of_points", "round_corner(left, right, distance)", ([square, square], 1)),
                                      ("wrong_number_of_points", "the vertices of a polyline", ([(0, 0)], 1))):
            with self.assertRaises(gc.Error) as caught:
                gc.round_corners(*arguments)
            self.assertEqual((caught.exception.code, caught.exception.place), (code, "round_corners"))
            self.assertIn(text, caught.exception.reason)

    def test_curvature_excess(self):
        parabola = [(-1, 1), (0, -1), (1, 1)]
        self.assertIsNone(gc.curvature_excess(parabola, 2))
        place = gc.curvature_excess(gc.Bezier_curve(parabola, domain=(3, 5)), Fraction(1999, 1000))
        self.assertEqual((place.piece, *place.parameter, *place.curvature, place.unbounded), (0, 4, 4, 2, 2, False))
        arc = gc.Bezier_curve([(5, 0), (5, 5), (0, 5)], weights=[1, 1, 2])
        self.assertIsNone(gc.curvature_excess(arc, Fraction(1, 5)))
        self.assertIsNotNone(gc.curvature_excess(arc, Fraction(199, 1000)))
        spline = gc.interpolate([(0, 0), (1, 2), (3, 2), (4, 0)])
        place = gc.curvature_excess(spline, Fraction(1, 10))
        self.assertLessEqual(abs(gc.curvature(spline, [place.parameter.lower])[0] - place.curvature.lower), 1e-6)
        self.assertTrue(gc.curvature_excess([(0, 0), (1, 1), (0, 1), (1, 0)], 10**9).unbounded)
        with self.assertRaises(gc.Error) as caught:
            gc.curvature_excess(parabola, -1)
        self.assertEqual(caught.exception.code, "unreachable_tolerance")

    def test_fairness(self):
        self.assertEqual(gc.fairness([(0, 0), (1, 0), (2, 0)]), 0)
        self.assertLess(gc.fairness(gc.fair(LEFT, RIGHT).points), gc.fairness(gc.blend(LEFT, RIGHT).points))


class Splines(unittest.TestCase):
    points = [(0, 0), (1, 2), (3, 2), (4, 0), (2, -2)]

    def test_interpolate(self):
        spline = gc.interpolate(self.points, parameters=[0, 1, 2, 3, 4])
        self.assertEqual((spline.degree, len(spline.points), len(spline.knots)), (3, 7, 11))
        self.assertEqual(spline.points[0].tolist(), [0, 0])
        floats = gc.interpolate(numpy.array(self.points, float), parameters=[0, 1, 2, 3, 4])
        self.assertEqual(floats.points.dtype, numpy.float64)
        numpy.testing.assert_allclose(floats.points, spline.points.astype(float), atol=1e-12)
        # at the simple knot 1, by de Boor: the point is met exactly
        t, p, u = spline.knots, spline.points, Fraction(1)
        k = max(i for i in range(len(t)) if t[i] <= u < t[i + 1] or i == 3)
        d = [p[j] for j in range(k - 3, k + 1)]
        for r in range(1, 4):
            for j in range(3, r - 1, -1):
                a = (u - t[j + k - 3]) / (t[j + 1 + k - r] - t[j + k - 3])
                d[j] = (1 - a) * d[j - 1] + a * d[j]
        self.assertEqual(d[3].tolist(), [1, 2])
        lengths = [((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5 for p, q in zip(self.points, self.points[1:])]
        knots = gc.interpolate(numpy.array(self.points, float)).knots[3:-3]  # chordal, as in C++ and in the program
        numpy.testing.assert_allclose(numpy.diff(knots), lengths, rtol=1e-2)
        self.assertEqual(len(gc.interpolate(self.points, closed=True, parametrisation="uniform").points), 8)
        with self.assertRaises(gc.Error):
            gc.interpolate(self.points, parametrisation="none")

    def test_interpolate_fair(self):
        for points in (self.points, numpy.array(self.points, float)):
            for closed in (False, True):
                curve = gc.interpolate_fair(points, closed)
                self.assertEqual(curve.segments.shape, (5 if closed else 4, 6, 2))
                self.assertEqual(curve.rounded, [])
                self.assertEqual(gc.failing_joins(curve.segments, closed=closed).tolist(), [])
                numpy.testing.assert_allclose(curve.segments[:, 0].astype(float), self.points[:len(curve.segments)], atol=1e-9)
                self.assertTrue(numpy.array_equal(curve.segments[1], curve.points[5:11]))

    def test_fit(self):
        t = numpy.linspace(0, 6, 200)
        polyline = numpy.column_stack([t, numpy.sin(t)])
        for order in (1, 2):
            curve = gc.fit(polyline, 1e-3, order)
            self.assertLess(len(curve.segments), 20)
            self.assertLessEqual(curve.distance, 1e-3)
            self.assertEqual(gc.failing_joins(curve.segments, f"G{order}").tolist(), [])
        self.assertEqual(gc.fit([(0, 0), (1, 0), (1, 1)], 1e-3).corners, [1])
        with self.assertRaises(gc.Error) as caught:
            gc.fit(polyline, 0)
        self.assertEqual(caught.exception.code, "unreachable_tolerance")


class Interruption(unittest.TestCase):
    def test_constructions(self):
        """Each of these would take minutes, and ends within a second of Ctrl-C."""
        t = numpy.linspace(0, 1000, 200000)
        wave = numpy.column_stack([t, numpy.sin(t)])
        rng = random.Random(33)

        def long_curve(bits):
            return [[Fraction(rng.getrandbits(bits), rng.getrandbits(bits) | 1) for _ in range(2)] for _ in range(6)]

        bits = 200000 if gc.uses_gmp else 20000
        left, right = long_curve(bits), long_curve(bits)
        points = [[Fraction(rng.randrange(10 ** 30), 10 ** 30) for _ in range(2)] for _ in range(2000)]
        for call in (lambda: gc.fit(wave, 1e-9), lambda: gc.fit(wave, 1e-6, 2), lambda: gc.interpolate_fair(wave),
                     lambda: gc.interpolate(points), lambda: gc.interpolate_fair(points), lambda: gc.fair(left, right),
                     lambda: gc.blend(left, right)):
            self.assertLess(interruption.seconds_until(call), 1 if gc.uses_gmp else 10)


class Documentation(unittest.TestCase):
    def test_all_is_documented_and_typed(self):
        for name in gc.__all__:
            thing = getattr(gc, name)
            if callable(thing):
                self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isfunction(thing) and name not in ("program",):
                self.assertNotEqual(inspect.signature(thing).return_annotation, inspect.Signature.empty, name)
                self.assertIn("Raises", thing.__doc__, name)

    def test_stubs_name_what_there_is(self):
        import ast

        folder = os.path.dirname(gc.__file__)
        with open(os.path.join(folder, "_native.pyi"), encoding="utf-8") as file:
            stub = ast.parse(file.read())
        functions = {n.name for n in stub.body if isinstance(n, ast.FunctionDef)}
        classes = {n.name: n for n in stub.body if isinstance(n, ast.ClassDef)}
        native = gc._native
        public = {n for n in dir(native) if not n.startswith("_")}
        self.assertEqual(functions | set(classes) | {"strategies", "uses_gmp", "version"}, public)
        for name, node in classes.items():
            members = {m.target.id for m in node.body if isinstance(m, ast.AnnAssign) and not m.target.id.startswith("_")}
            members |= {m.name for m in node.body if isinstance(m, ast.FunctionDef) and not m.name.startswith("_")}
            there = {n for n in dir(getattr(native, name)) if not n.startswith("_")}
            self.assertEqual(members, there, name)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))

    @unittest.skipUnless(shutil.which("stubtest"), "not installed: mypy")
    def test_types(self):
        """What mypy says of the package and of its stubs."""
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "mypy.ini"), "w") as file:
                file.write("[mypy]\nignore_missing_imports = True\n")
            classes = "|".join(name for name, thing in vars(gc._native).items() if isinstance(thing, type))
            with open(os.path.join(folder, "allowed"), "w") as file:  # every class of pybind11 has a metaclass, and some can be called
                file.write(rf"geometric_continuity\._native\.({classes})(\.__init__)?" + "\n")
            done = subprocess.run(["stubtest", "--concise", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed", "--ignore-unused-allowlist",
                                   "geometric_continuity._native"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  env=dict(os.environ, PYTHONPATH=os.path.dirname(os.path.dirname(os.path.abspath(gc.__file__)))))
            self.assertEqual(done.returncode, 0, done.stdout.decode())

    def test_examples_of_docstrings(self):
        import doctest

        for module in (gc, importlib.import_module("geometric_continuity._evaluation")):
            self.assertEqual(doctest.testmod(module).failed, 0)


class Clothoids(unittest.TestCase):
    def test_three_clothoids(self):
        blend = gc.clothoid_blend((0, 0, Decimal("0.3"), 0), (100, 20, Decimal("-0.2"), Fraction(1, 80)))
        self.assertEqual(blend.segments.shape, (3, 6))
        self.assertTrue((blend.segments[:2, 4] == blend.segments[1:, 3]).all())
        self.assertEqual([tuple(jump) for jump in blend.jumps], [(0, 0)] * 4)
        for gap, kink in zip(blend.gaps, blend.kinks):
            self.assertLess(gap.upper, 5e-14)
            self.assertLess(kink.upper, 5.2e-16)
        exact = gc.clothoid_blend((0, 0, Decimal("0.3"), 0), (100, 20, Decimal("-0.2"), Fraction(1, 80)), exact=True)
        self.assertEqual(exact.segments.astype(float).tolist(), blend.segments.tolist())
        self.assertEqual(exact.segments[0, 2], Fraction(3, 10))

    def test_refused(self):
        for end, code in (((0, 0, 1, 0), "zero_direction"), ((1, 0, 1), "wrong_number_of_points"), ((1, 0, float("nan"), 0), "not_finite")):
            with self.assertRaises(gc.Error) as caught:
                gc.clothoid_blend((0, 0, 0, 0), end)
            self.assertEqual(caught.exception.code, code)


if __name__ == "__main__":
    unittest.main()
