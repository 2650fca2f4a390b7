# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves of all kinds: evaluated, cut into pieces, joined, blended; what is wrong with them is said."""

import importlib.util
import os
import random
import re
import subprocess
import sys
import types
import unittest
from fractions import Fraction

import numpy

import cases
import geometric_continuity as gc

LEFT, RIGHT = [(-3, 0), (-3, 2), (-2, 3), (0, 3)], [(4, 0), (5, -1)]
TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


class B_spline:
    """What the package knows of SciPy's BSpline, and no more."""

    def __init__(self, t, c, k):
        self.t, self.c, self.k = t, c, k


class Cases(unittest.TestCase):
    def check_jet(self, curve, parameter, jet):
        for k, expected in enumerate(jet):
            self.assertEqual(gc.evaluate(curve, parameter, k).tolist(), expected)
            floats = gc.evaluate(curve, numpy.array([[float(parameter)] * 2] * 3), k)
            self.assertEqual((floats.shape, floats.dtype), ((3, 2, len(expected)), numpy.float64))
            numpy.testing.assert_allclose(floats[2, 1], numpy.array(expected, dtype=float), rtol=1e-7, atol=1e-7 * float(max(map(abs, sum(jet, [])))))

    def test_cases(self):
        """The exact cases of C++."""
        seen = dict.fromkeys(("eval_jet", "spline_jet", "bezier_pieces", "classify_join", "invariants"), 0)
        for topic in ("bezier", "bspline", "rational", "invariants"):
            for name, op, given, expected in cases.read(topic):
                with self.subTest(name):
                    weights = given.get("weights")
                    if "error" in expected:
                        continue
                    if op == "eval_jet" and "interval_length" in given:
                        length = given["interval_length"]
                        if not 0 <= given["t"] <= 1:  # where C++ goes on
                            continue
                        curve = gc.Bezier_curve(given.get("P", given.get("points")), weights, (0, length))
                        self.check_jet(curve, given["t"] * length, expected["jet"])
                    elif op in ("eval_jet", "spline_jet"):
                        self.check_jet(gc.Spline(int(given["degree"]), given["points"], given["knots"], weights), given["u"], expected["right"])
                    elif op == "bezier_pieces":
                        found = gc.pieces(gc.Spline(int(given["degree"]), given["points"], given["knots"]))
                        self.assertEqual([(*p.domain, p.points.tolist()) for p in found], [(p["a"], p["b"], p["points"]) for p in expected["pieces"]])
                    elif op == "classify_join":
                        if len({len(given[s]["points"][0]) for s in ("left", "right")}) > 1 or "domain" in str(given):
                            continue
                        left, right = (gc.Bezier_curve(given[s]["points"], given[s]["weights"]) for s in ("left", "right"))
                        join = gc.continuity(left, right, int(given["kmax"]))
                        for member in ("c_order", "g_order", "f_order", "regular", "curvature_equal", "torsion_equal"):
                            self.assertEqual(getattr(join, member), expected[member], member)
                        self.assertEqual(list(join.betas), expected["betas"])
                    elif op == "invariants" and expected.get("curvature_vector"):
                        curve = cases.points_of_start(given["jet"])
                        self.assertEqual(gc.curvature_vector(curve, Fraction(0)).tolist(), expected["curvature_vector"])
                        self.assertAlmostEqual(gc.curvature(curve, 0) ** 2, float(expected["kappa_sq"]))
                    else:
                        continue
                    seen[op] += 1
        self.assertGreater(min(seen.values()), 5, seen)
        self.assertGreater(seen["eval_jet"] + seen["spline_jet"], 50, seen)

    def test_curvature(self):
        quarter = gc.Bezier_curve([(3, 0), (3, 3), (0, 3)], [1, 1, 2], (Fraction(1), Fraction(3)))
        u = numpy.linspace(1, 3, 9)
        numpy.testing.assert_allclose(gc.curvature(quarter, u), 1 / 3)
        numpy.testing.assert_allclose(gc.curvature(quarter.reverse(), u), -1 / 3)
        self.assertEqual(gc.curvature_vector(quarter, 3).tolist(), [0, Fraction(-1, 3)])
        self.assertIsInstance(gc.curvature(quarter, 2), float)
        numpy.testing.assert_allclose(gc.curvature([(0, 0, 0), (1, 1, 1), (2, 0, 0)], 0.5), 2 ** 0.5)
        with self.assertRaisesRegex(gc.Error, "zero_tangent: curvature: .* number 1"):
            gc.curvature([(0, 0), (1, 1), (0, 0)], [0.25, 0.5])


def random_spline(rng, numbers=Fraction):
    degree = rng.randint(2, 5)
    inner = sorted(Fraction(rng.randint(1, 9), 4) for _ in range(rng.randint(0, 4)))
    knots = [0] * (degree + 1) + inner + [3] * (degree + 1)
    points = [(numbers(rng.randint(-9, 9)), numbers(rng.randint(-9, 9))) for _ in range(len(knots) - degree - 1)]
    weights = [numbers(rng.randint(1, 5)) for _ in points] if rng.random() < 0.5 else None
    return gc.Spline(degree, points, knots, weights)


class Joins(unittest.TestCase):
    def test_splines(self):
        """A spline has the orders that the multiplicities of its knots promise, its blends are proved, and those of its last piece."""
        rng, seen = random.Random(57), set()
        for i in range(40):
            left, right = random_spline(rng), random_spline(rng)
            found = gc.pieces(left)
            for piece, join in zip(found, gc.chain_joins(left)):
                multiplicity = list(left.knots).count(piece.domain[1])
                self.assertGreaterEqual(join.c_order, min(3, left.degree - multiplicity), i)
                seen.add(multiplicity)
                self.assertEqual(gc.evaluate(left, piece.domain[0], 1).tolist(), gc.evaluate(piece, piece.domain[0], 1).tolist())
            failing = [k for k, join in enumerate(gc.chain_joins(left)) if join.g_order < 2]
            self.assertEqual(gc.failing_joins(left, "G2").tolist(), failing)
            self.assertEqual(gc.failing_joins(found, "G2").tolist(), failing)
            self.assertEqual(gc.failing_joins([*found, found[0].points], "G2").tolist()[:-1], failing)
            for strategy, order in (("energy3", 2), ("fair_g3" if i < 5 else "c3", 3)):
                try:
                    gamma = gc.blend(left, right, strategy)
                except gc.Error as error:
                    self.assertEqual(error.code, "zero_tangent")
                    continue
                self.assertTrue(all(isinstance(x, Fraction) for x in gamma.points.flat))
                self.assertEqual(gamma.points.tolist(), gc.blend(found[-1], gc.pieces(right)[0], strategy).points.tolist())
                self.assertGreaterEqual(min(gc.continuity(left, gamma).g_order, gc.continuity(gamma, right).g_order), order)
        self.assertGreaterEqual(len(seen), 2)
        floats = random_spline(rng, float)
        self.assertEqual(gc.blend(floats, RIGHT).points.dtype, numpy.float64)
        self.assertEqual(gc.continuity(floats, gc.blend(floats, RIGHT, exact=True)).g_order, 2)

    def test_what_is_a_curve(self):
        """The same curve in every form has the same joins and points."""
        gamma = gc.blend(LEFT, RIGHT)
        expected = gc.continuity(LEFT, gamma.points)
        knots = [0] * 6 + [1] * 6
        forms = [gamma, gc.Bezier_curve(gamma.points), gc.Spline(5, gamma.points, knots), B_spline(numpy.array(knots), gamma.points, 5),
                 (knots, gamma.points.T, 5), [tuple(p) for p in gamma.points]]
        self.assertEqual(gamma(Fraction(1, 3)).tolist(), gc.evaluate(gamma.points, Fraction(1, 3)).tolist())
        for form in forms:
            join = gc.continuity(LEFT, form)
            self.assertEqual((str(join), join.betas), (str(expected), expected.betas))
            self.assertEqual(gc.evaluate(form, Fraction(1, 3)).tolist(), gc.evaluate(gamma.points, Fraction(1, 3)).tolist())
            self.assertEqual(gc.deviation(LEFT, form).curvature_jump, gc.deviation(LEFT, gamma.points).curvature_jump)
            self.assertEqual(gc.visual_class(LEFT, form), gc.Visual_class.g2)
            self.assertEqual(gc.fairness(form), gc.fairness(gamma.points))
        z = numpy.array([0, 1 + 2j, 3 + 2j, 4], complex)
        plane = numpy.array([(0, 0), (1, 2), (3, 2), (4, 0)], float)
        for form in (z, z.tolist()):
            self.assertEqual(gc.continuity(form, plane[::-1]).betas, gc.continuity(plane, plane[::-1]).betas)
            self.assertEqual(gc.fit(form, 0.1).points.tolist(), gc.fit(plane, 0.1).points.tolist())
        self.assertEqual(gc.failing_joins(numpy.array([z, z + 4]), "C0").tolist(), [])
        fair = gc.interpolate_fair(plane)
        self.assertEqual([gc.failing_joins(fair, order).tolist() for order in ("G2", "C2")], [[], gc.failing_joins(gc.pieces(fair), "C2").tolist()])
        mixed = [[(0, 0), (1, 1)], gc.Spline(1, [(1, 1), (2, 2), (3, 1)], [0, 0, 1, 2, 2]), [(3, 1), (4, 0), (5, 0)]]
        self.assertEqual([join.g_order for join in gc.chain_joins(mixed)], [3, 0, 1])
        self.assertEqual(gc.failing_joins(mixed, "G1", closed=True).tolist(), [1, 3])

    @unittest.skipIf(importlib.util.find_spec("scipy") is None, "not installed: scipy")
    def test_scipy(self):
        from scipy.interpolate import BPoly, BSpline, CubicSpline, make_interp_spline, splprep

        t = numpy.linspace(0, 3, 9)
        points = numpy.column_stack([numpy.cos(t), numpy.sin(2 * t), t])
        for degree in (2, 3, 5):
            spline = make_interp_spline(t, points, degree)
            u = numpy.linspace(0, 3, 31)
            for k in range(degree):
                numpy.testing.assert_allclose(gc.evaluate(spline, u, k), spline(u, nu=k), rtol=1e-9, atol=1e-9)
            self.assertGreaterEqual(min(join.c_order for join in gc.chain_joins(spline)), min(3, degree - 1))
        cubic = CubicSpline(t, points)
        for form in (cubic, BPoly.from_power_basis(cubic)):
            numpy.testing.assert_allclose(gc.evaluate(form, u, 1), cubic(u, nu=1), rtol=1e-9, atol=1e-9)
        self.assertEqual(gc.evaluate(cubic, 3.0).dtype, numpy.float64)
        self.assertEqual(gc.pieces(cubic)[4].points[0].tolist(), points[4].tolist())
        self.assertTrue(all(gc.order_within(p, q, 1e-9).proved_order >= 2 for p, q in zip(gc.pieces(cubic), gc.pieces(cubic)[1:])))
        tck, _ = splprep(points.T, s=0)
        self.assertEqual(gc.failing_joins(tck, "C2").tolist(), [])
        self.assertEqual(gc.failing_joins(spline, "C3").tolist(), [])
        gamma = gc.blend(spline, tck, "fair", exact=True)
        self.assertEqual((gc.continuity(spline, gamma).g_order, gc.continuity(gamma, tck).g_order), (2, 2))
        with self.assertRaisesRegex(gc.Error, r"dimension_mismatch: continuity: .* shape \(2,\); those of a curve are points"):
            gc.continuity(BSpline([0, 0, 1, 1], [1, 2], 1), points)

    def test_order_within(self):
        line = [(0, 0), (1, 0)]
        within = gc.order_within(line, [(1, 0), (2, Fraction(1, 1000))], tangent_angle=0.001)
        self.assertEqual((within.verdicts, within.proved_order), (("proved", "proved", "proved", "proved"), 3))
        self.assertEqual(gc.order_within(line, [(1, 0), (2, Fraction(1, 1000))], tangent_angle=0.0009).verdicts[:2], ("proved", "refuted"))
        low, high = within.deviation.tangent_angle
        self.assertEqual(gc.order_within(line, [(1, 0), (2, Fraction(1, 1000))], tangent_angle=(low + high) / 2).verdicts[1],
                         "undecided" if low < (low + high) / 2 < high else "proved")
        self.assertEqual(gc.order_within(line, [(1, Fraction(1, 8)), (2, 0)], gap=Fraction(1, 8)).verdicts[0], "proved")
        self.assertEqual(gc.order_within(line, [(1 + 1e-10, 0), (2, 1e-10)], 1e-9).verdicts, ("proved",) * 4)
        self.assertEqual(gc.order_within(line, [(1 + 1e-10, 0), (2, 1e-10)], 1e-9, gap=0).verdicts, ("refuted",) * 4)
        with self.assertRaises(gc.Error):
            gc.order_within(line, line, gap=-1)


def evaluated_ends(curve):
    return [gc.evaluate(curve, u).tolist() for u in curve.domain]


class Torsion(unittest.TestCase):
    def test_torsion(self):
        """That of a helix, which turns like a screw, and of the cubic (t, t^2, t^3), 3 / (1 + 9 t^2 + 9 t^4), exactly."""
        twisted = [(0, 0, 0), (Fraction(1, 3), 0, 0), (Fraction(2, 3), Fraction(1, 3), 0), (1, 1, 1)]
        for t in (0, Fraction(1, 2), 1):
            expected = 3 / Fraction(1 + 9 * t ** 2 + 9 * t ** 4)
            found = gc.torsion(twisted, t)
            self.assertEqual((found, type(found)), (expected, Fraction))
            self.assertEqual(gc.torsion([(x, y, -z) for x, y, z in twisted], t), -expected)
            self.assertAlmostEqual(gc.torsion(twisted, float(t)), float(expected), 14)
        moebius = gc.Bezier_curve(twisted, [1, 2, 4, 8])  # the same curve at another speed
        for u in (0, Fraction(1, 2), 1):
            self.assertEqual(gc.torsion(moebius, u), gc.torsion(twisted, 2 * u / Fraction(1 + u)))
        t = numpy.linspace(0, 6, 200)
        helix = gc.interpolate(numpy.column_stack([2 * numpy.cos(t), 2 * numpy.sin(t), t]), parameters=t)
        inner = numpy.linspace(1, 5, 9).reshape(3, 3)
        numpy.testing.assert_allclose(gc.torsion(helix, inner), numpy.full((3, 3), 0.2), atol=0.02)
        with self.assertRaisesRegex(gc.Error, "nonpositive_curvature: torsion: the curvature is zero at the parameter number 1"):
            gc.torsion([(0, 0, 0), (1, 1, 1), (2, 2, 2), (4, 3, 1)], [1, 0])
        with self.assertRaisesRegex(gc.Error, "dimension_mismatch: torsion: curves in space have torsion; this one has 2"):
            gc.torsion(LEFT, 0)


class Sentences(unittest.TestCase):
    """What fails says the call that works."""

    def says(self, text, call, kind=gc.Error):
        with self.assertRaises(kind) as caught:
            call()
        self.assertIn(text, str(caught.exception))

    def test_names(self):
        self.says("blend: there is no strategy 'fare'; did you mean 'fair'? It is one of c2, normal,", lambda: gc.blend(LEFT, RIGHT, "fare"))
        self.says("round_corner: there is no strategy 'fair_g2'; did you mean 'fair_g3'?", lambda: gc.round_corner(LEFT, RIGHT, 1, "fair_g2"))
        self.says("'zzz'; it is one of fair, energy3", lambda: gc.representable_blend(LEFT, RIGHT, "zzz"))
        self.says("did you mean 'chordal'?", lambda: gc.interpolate(LEFT, parametrisation="chord"))
        self.says("did you mean 'G2'?", lambda: gc.failing_joins([LEFT], "g2"))
        self.says("did you mean 'u1'?", lambda: gc.edge_continuity([[(0, 0, 0)]], "u_1", [[(0, 0, 0)]], "u0"))
        self.says("or continuity(left, right).g_order >= 2", lambda: gc.is_g2, AttributeError)
        self.says('call failing_joins(curves, "G2")', lambda: gc.is_chain_g2, AttributeError)
        self.says("round-edges solid.off", lambda: gc.round_edges, AttributeError)
        self.says("curvature_excess(curve, bound)", lambda: gc.curvature_extrema, AttributeError)
        self.says("call interpolate_fair(points)", lambda: gc.fair_interpolation, AttributeError)
        self.says("Bezier_curve(points, weights, domain)", lambda: gc.Bezier, AttributeError)
        self.says("Spline(degree, points, knots)", lambda: gc.BSpline, AttributeError)
        self.says("did you mean interpolate(points)?", lambda: gc.interpolation, AttributeError)
        self.says("call continuity(left, right) for two curves", lambda: gc.check_continuity, AttributeError)
        self.says("call evaluate(curve, parameters, 1)", lambda: gc.tangent_vector, AttributeError)
        self.says("call curvature(...) of geometric_continuity with it", lambda: gc.blend(LEFT, RIGHT).curvature, AttributeError)
        self.says("call interpolate(points) for the spline through points", lambda: gc.spline, AttributeError)
        self.says("Spline(degree, points, knots) for one that is known", lambda: gc.spline_curve, AttributeError)
        self.says("call interpolate(points) for the cubic spline", lambda: gc.cubic_spline, AttributeError)
        self.says("fit(points, tolerance) leads curves near it", lambda: gc.Polyline, AttributeError)
        self.says("help(geometric_continuity) lists", lambda: gc.outline, AttributeError)  # no line
        self.says("chain_joins(curves) and failing_joins", lambda: gc.verify_chain, AttributeError)
        for name in ("knot_continuity", "is_curvature_continuous", "continuous", "check_spline", "check_chain"):
            self.says("chain_joins(spline)", lambda: getattr(gc, name), AttributeError)
        self.says("a curve has .points", lambda: gc.control_points, AttributeError)
        for name in ("connect", "bridge_curves"):
            self.says("call blend(left, right)", lambda: getattr(gc, name), AttributeError)
        for name in ("read", "read_g2", "read_curve", "load", "open", "from_file"):
            self.says("the module returns no curves of a file: verify(file) decides the joins in drawings, fonts, CAD models and .g2, whose "
                      "plain numbers make a Spline(degree, points, knots)", lambda: getattr(gc, name), AttributeError)
        for name in ("write", "write_g2", "save_g2"):
            self.says("`geometric_continuity blend` and `repair` make .g2 of .g2", lambda: getattr(gc, name), AttributeError)
        for name in ("bounding_box", "bbox", "closest_point", "project", "intersections", "offset_curve", "insert_knot", "knot_insertion", "loft"):
            self.says("that is left to others: what SciPy,", lambda: getattr(gc, name), AttributeError)
        for name, call in (("edge", "patch[0], patch[-1]"), ("boundary_curve", "each is a Bezier curve"), ("concatenate", "chain_joins(curves)"),
                           ("is_closed", "chain_joins(curves, closed=True)"), ("inflections", "changes at an inflection"),
                           ("prove_g2", ".g_order is decided exactly"), ("curvature_comb", "matplotlib"), ("harmonize", "align_handles(left, right)"),
                           ("NURBSCurve", "Spline(degree, points, knots, weights)"), ("Fair_g3", "blend(left, right, \"fair_g3\")"),
                           ("g3_blend", "blend(left, right, \"fair_g3\")"), ("splrep", "the tuple (t, c, k) of splrep"), ("to_bezier", "pieces(curve)"),
                           ("bezier_pieces", "pieces(curve)"), ("decide", "continuity(left, right) for two curves")):
            self.says(call, lambda: getattr(gc, name), AttributeError)
        self.says("numpy.savetxt", lambda: gc.save, AttributeError)
        self.says("largest_angle", lambda: gc.normal_angle, AttributeError)
        self.says("did you mean largest_angle?", lambda: gc.edge_continuity(numpy.zeros((2, 2, 3)), "u1", numpy.zeros((2, 2, 3)), "u0").angle, AttributeError)
        self.says("runs along the normal", lambda: gc.frenet_frame, AttributeError)
        with self.assertRaisesRegex(ImportError, r"edge_continuity\(a, b\) decides two of them"):
            exec("from geometric_continuity import surface_continuity", {})
        self.says("matplotlib", lambda: gc.plot_curvature, AttributeError)
        for name in ("surface_continuity", "surfaces", "Patch", "match_surfaces"):
            self.says("edge_continuity(a, b) decides two of them, match(a, b)", lambda: getattr(gc, name), AttributeError)
        for name, call in (("joins", "chain_joins(curves)"), ("curves", "Spline(degree, points, knots)"), ("evaluation", "did you mean evaluate(curve, parameters)?"),
                           ("g1_continuous", "continuity(left, right).g_order >= 1"), ("C2", "continuity(left, right).c_order >= 2"),
                           ("find_kinks", "failing_joins(curves, \"G1\")"), ("splev", "evaluate(curve, parameters)"), ("fix_kinks", "repair"),
                           ("knotvector", "Spline(degree, points, knots)"), ("split_curve", "pieces(curve, low, high)"), ("parse_path", "verify(file)"),
                           ("kink_angle", "deviation(left, right).tangent_angle"), ("simplify", "fit(points, tolerance)"), ("arc", "Bezier_curve([("),
                           ("arc_length", "what SciPy, geomdl or svgpathtools returns"), ("round", "round_corners(points, distance)"),
                           ("tolerance", "order_within(left, right, tolerance)"), ("analyze_svg", "verify(file) for files"), ("version", "__version__")):
            self.says(call, lambda: getattr(gc, name), AttributeError)
        join, spline = gc.continuity(LEFT, RIGHT), gc.interpolate(LEFT)
        for name, order in (("G", "g_order >= 1"), ("is_g2", "g_order >= 2"), ("c1", "c_order >= 1")):
            self.says(f"ask .{order}", lambda: getattr(join, name), AttributeError)
        for name, text in (("ctrlpts", "did you mean points?"), ("t", "did you mean knots?"), ("k", "did you mean degree?"), ("joins", "chain_joins(curves)"),
                           ("point", "curve(0.5)"), ("evaluate_single", "curve(0.5)"), ("tck", "scipy.interpolate.BSpline(spline.knots,"),
                           ("evalpts", "call evaluate(curve, parameters)"), ("bbox", "that is left to others"),
                           ("derivative", "evaluate(curve, parameters, 1); it has degree,"), ("split", "pieces(curve, low, high); it has")):
            self.says(text, lambda: getattr(spline, name), AttributeError)
        self.says("chain_joins(spline), which decides the joins at its knots", lambda: spline.continuity, AttributeError)
        for code in ("gc.surface_continuity", "gc.fite", "gc.continuity([(0, 0)], [(0, 0)]).g_ordr"):  # to which the interpreter adds nothing
            done = subprocess.run([sys.executable, "-c", f"import geometric_continuity as gc; {code}"], stderr=subprocess.PIPE, text=True, check=False)
            self.assertIn("AttributeError: ", done.stderr)
            self.assertNotIn("Did you mean", done.stderr)
        self.says("did you mean segments?", lambda: gc.fit(LEFT, 0.1).curves, AttributeError)
        self.says("did you mean tangent_angle? It has curvature_jump, gap,", lambda: gc.deviation(LEFT, RIGHT).angle, AttributeError)
        self.says("did you mean blend? It has blend, left, left_cut, right, right_cut", lambda: gc.round_corner([(0, 0), (4, 0)], [(4, 0), (4, 4)], 1).points, AttributeError)

    def test_curves(self):
        path = type("CubicBezier", (), {"__module__": "svgelements.svgelements"})()
        self.says("continuity: a CubicBezier of svgelements: call drawings.svg_contours(path) of geometric_continuity.adapters.drawings",
                  lambda: gc.continuity(path, LEFT))
        self.says("a SimpleNamespace is no curve: give an array of control points", lambda: gc.evaluate(types.SimpleNamespace(), 0))
        self.says("chain_joins(curve) decides those inside of a spline", lambda: gc.continuity(gc.interpolate(LEFT)))
        spline = gc.interpolate([*LEFT, (3, 3), (5, 1)])
        self.says("pieces(curve) has those of a spline", lambda: gc.round_corner(spline, RIGHT, 1))
        self.says("the parameter 2 is not in the domain [0, 1]", lambda: gc.evaluate(LEFT, 2))
        self.says("zero_weight: Bezier_curve", lambda: gc.Bezier_curve(LEFT, [1, 0, 1, 1]))
        self.says("the degree 3 needs at least 4 points, and 4 knots more than there are points", lambda: gc.Spline(3, LEFT, [0, 1]))
        self.says("not_finite", lambda: gc.evaluate([(0, 0), (1, float("inf"))], 0.5))
        patch = numpy.zeros((4, 4, 3))
        for call in (lambda: gc.continuity(patch, patch), lambda: gc.blend(patch.tolist(), patch), lambda: gc.evaluate(patch, 0)):
            self.says("edge_continuity(a, b) decides two patches, chain_joins(curves) the joins of curves", call)
        for flat in ([0, 0, 1, 1], numpy.arange(8.)):
            self.says(f"{len(flat)} numbers are no points: give [(x, y), ...], as numpy.column_stack([x, y])", lambda: gc.continuity(flat, RIGHT))
            self.says("numpy.column_stack([x, y])", lambda: gc.interpolate(flat, flat))
        self.says("call verify(file) for a drawing", lambda: gc.continuity("M0 0L1 1", RIGHT))
        dicts = [{"x": x, "y": y} for x, y in RIGHT]
        self.assertEqual(gc.continuity(LEFT, dicts).g_order, gc.continuity(LEFT, RIGHT).g_order)
        self.assertEqual(gc.evaluate(dicts, 0).tolist(), list(RIGHT[0]))
        self.assertEqual(str(gc.continuity(RIGHT, zip(*zip(*RIGHT[::-1])))), str(gc.continuity(RIGHT, RIGHT[::-1])))
        self.assertEqual(gc.interpolate(zip(*zip(*LEFT))).points.tolist(), gc.interpolate(LEFT).points.tolist())
        self.says("a SimpleNamespace is no array of points; give its .coords", lambda: gc.fit(types.SimpleNamespace(coords=LEFT), 0.1))
        self.says("a str is no array of points", lambda: gc.interpolate("0,0 1,1"))
        self.says("two curves are a list: chain_joins([left, right])", lambda: gc.chain_joins(LEFT, RIGHT))
        self.says("the order is 1 or 2, not 'G2'", lambda: gc.fit(LEFT, 0.1, "G2"))
        self.says("the knots are an array", lambda: gc.Spline(1, LEFT, None))

    def test_arguments(self):
        spline = gc.interpolate(LEFT)
        self.says("interpolate: closed is True or False, not 3; the degree is always 3", lambda: gc.interpolate(LEFT, 3))
        self.says("interpolate_fair: closed is True or False, not 0;", lambda: gc.interpolate_fair(LEFT, 0))
        self.says("fit: closed is True or False, not 45; call fit(points, tolerance, order=1,", lambda: gc.fit(LEFT, 0.1, 1, 45))
        self.says("chain_joins: closed is True or False, not 2; every join is decided", lambda: gc.chain_joins(spline, 2))
        self.says("failing_joins: closed is True or False, not 1;", lambda: gc.failing_joins([LEFT], "G2", 1))
        self.says("failing_joins: parallel is True or False, not 2;", lambda: gc.failing_joins([LEFT], "G2", True, 2))
        self.says("verify: closed is True or False, not 2;", lambda: gc.verify("x.g2", closed=2))
        self.assertEqual(gc.chain_joins([LEFT, RIGHT], numpy.True_)[1].g_order, -1)

        default = "G2 is the default; strategies of G3 are c3, seq_g3, joint_g3,"
        for strategy in ("G2", "g3", 2):
            self.says(f"blend: {strategy!r} is no strategy: {default}", lambda: gc.blend(LEFT, RIGHT, strategy))
        self.says(f"blend() has no argument 'order': {default}", lambda: gc.blend(LEFT, RIGHT, order=2), TypeError)
        try:
            gc.blend(LEFT, RIGHT, 3)
        except gc.Error as error:
            for strategy in error.reason.partition("of G3 are ")[2].split(", "):
                gamma = gc.blend(LEFT, RIGHT, strategy)
                self.assertEqual([gc.continuity(LEFT, gamma).g_order, gc.continuity(gamma, RIGHT).g_order], [3, 3], strategy)
        self.says("max_order=3", lambda: gc.continuity(LEFT, RIGHT, order=2), TypeError)
        self.says("order_within(left, right, tolerance)", lambda: gc.continuity(LEFT, RIGHT, tolerance=1e-3), TypeError)
        self.says("blend() has no argument 'colour': it has left, right, strategy, beta,", lambda: gc.blend(LEFT, RIGHT, colour=2), TypeError)
        for call in (lambda: gc.interpolate(LEFT, degree=3), lambda: gc.interpolate(LEFT, k=3)):
            self.says("the degree is always 3; interpolate_fair(points) has the degree 5", call, TypeError)
        self.says("the degree is always 5", lambda: gc.interpolate_fair(LEFT, degree=3), TypeError)
        self.says("order=1 has cubics with G1 joins", lambda: gc.fit(LEFT, 0.1, degree=3), TypeError)
        self.says("strategies of G3 are c3", lambda: gc.blend(LEFT, RIGHT, continuity=3), TypeError)
        self.says("order_within(left, right, tolerance)", lambda: gc.continuity(LEFT, RIGHT, eps=1e-6), TypeError)
        for meant, call in (("tolerance", lambda: gc.fit(LEFT, tol=0.1)), ("closed", lambda: gc.interpolate(LEFT, periodic=True)),
                            ("derivative", lambda: gc.evaluate(LEFT, 0, nu=1)), ("parameters", lambda: gc.curvature(LEFT, t=0)),
                            ("points", lambda: gc.Spline(1, control_points=LEFT)), ("points", lambda: gc.Bezier_curve(ctrlpts=LEFT)),
                            ("radius", lambda: gc.round_corners(LEFT, r=1)), ("order", lambda: gc.match(LEFT, LEFT, continuity=2))):
            self.says(f"did you mean {meant}? It has ", call, TypeError)
        self.says("'edge_a' is given twice: call edge_continuity(a, edge_a, b, edge_b)", lambda: gc.edge_continuity(1, 2, edge_a="u1"), TypeError)
        self.says("max_order is the highest order that is decided, such as 3, not 'G2'", lambda: gc.continuity(LEFT, RIGHT, "G2"))
        self.says("call edge_continuity(a, \"u1\", b, \"u0\")", lambda: gc.edge_continuity(LEFT, RIGHT, "u1", "u0"))
        self.says("the degree comes first: call Spline(degree, points, knots)", lambda: gc.Spline([0, 0, 1, 1], LEFT, 1))
        self.says("the order of arguments is Spline(degree, points, knots)", lambda: gc.Spline(1, [0, 0, 1, 1], LEFT))
        for function in (gc.verify, gc.file_record):
            self.says('require="G1"', lambda: function("x.g2", order=1), TypeError)
            self.says('within="', lambda: function("x.g2", tolerance=0.1), TypeError)
            for thing in (spline, [LEFT, RIGHT], LEFT):
                self.says("verify() takes files; chain_joins(curve) decides the joins", lambda: function(thing), TypeError)

    def test_results(self):
        """What has an order is neither true nor false; the segments of a curve are its items; splines tell their domain."""
        self.says("ask `.g_order >= 1`", lambda: bool(gc.continuity(LEFT, RIGHT)), TypeError)
        self.says("ask `.g_order >= 1`", lambda: any(gc.chain_joins([LEFT, RIGHT])), TypeError)
        self.says("ask `.proved_order >= 1`", lambda: not gc.order_within(LEFT, RIGHT, 1), TypeError)
        net = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
        self.says("ask `.g_order >= 1`", lambda: bool(gc.edge_continuity(net, "u1", net, "u0")), TypeError)
        for curve in (gc.fit([(0, 0), (1, 2), (2, 0), (5, 5)], 0.1), gc.interpolate_fair(LEFT)):
            self.assertEqual(len(curve), 3)
            self.assertEqual([c.tolist() for c in curve], curve.segments.tolist())
            self.assertEqual((curve[-1].tolist(), curve[1:].tolist()), (curve.segments[2].tolist(), curve.segments[1:].tolist()))
            self.assertEqual(evaluated_ends(curve), [curve[0][0].tolist(), curve[-1][-1].tolist()])
            with self.assertRaises(IndexError):
                curve[3]
        corner = [(0, 0), (3, 4), (3, 9)]
        self.assertEqual(gc.interpolate(corner).domain, (0, 10))  # chord length
        self.assertEqual(gc.interpolate(corner[:2] + [(6, 0)], closed=True).domain, (0, 16))
        self.assertEqual(evaluated_ends(gc.interpolate(corner)), [[0, 0], [3, 9]])

    def test_version(self):
        with open(os.path.join(TOP, "CMakeLists.txt"), encoding="utf-8") as file:
            self.assertEqual(gc.__version__, re.search(r"project\(Geometric_continuity VERSION ([0-9.]+)", file.read()).group(1))

    def test_old_names(self):
        from geometric_continuity.adapters import splines

        with self.assertWarns(DeprecationWarning):
            left, right = splines.pieces(1, [0, 0, 1, 2, 2], [(0, 0), (1, 1), (2, 2)])
        with self.assertWarns(DeprecationWarning):
            self.assertEqual(splines.continuity(left, right).c_order, 3)


if __name__ == "__main__":
    unittest.main()
