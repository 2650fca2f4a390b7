# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points and curves of other libraries, taken as they are: of SciPy, matplotlib, ezdxf and fontTools where they are installed, and stand-ins
with the members of svgpathtools, geomdl, bezier and OpenCASCADE, which Debian does not have for Python."""

import importlib.util
import unittest
from collections import namedtuple
from fractions import Fraction
from types import SimpleNamespace

import numpy

import geometric_continuity as gc
from test_adapters import freecad_part, needs

CUBIC = [(0, 0), (1, 2), (3, 2), (4, 0.3)]
CUBIC_IN_SPACE = [(*p, 0) for p in CUBIC]


def has_points(curve, evaluate, parameters, **tolerance):
    """Compares with how a library evaluates its own curve."""
    numpy.testing.assert_allclose(gc.evaluate(curve, parameters), [evaluate(u) for u in parameters], **{"atol": 1e-12, **tolerance})


class Segment:
    """A segment of svgpathtools: its control points are complex numbers."""

    def __init__(self, *points):
        self.points = points

    def bpoints(self):
        return self.points


class Svg_path:
    """A Path of svgpathtools, which is a sequence and no list."""

    def __init__(self, segments):
        self.segments = segments

    def __getitem__(self, i):
        return self.segments[i]

    def __len__(self):
        return len(self.segments)

    def continuous_subpaths(self):
        raise NotImplementedError


Pole = namedtuple("Pole", "a b c")
Pole.X, Pole.Y, Pole.Z = (lambda p: p.a), (lambda p: p.b), (lambda p: p.c)


class Geom_BSplineCurve:
    """What Geom_BSplineCurve of OpenCASCADE answers, whose numbers begin with 1."""

    def __init__(self, degree, poles, knots, multiplicities, weights=None, periodic=False):
        self.degree, self.poles, self.knots, self.multiplicities, self.weights = degree, poles, knots, multiplicities, weights
        self.periodic = periodic

    def Degree(self):
        return self.degree

    def NbPoles(self):
        return len(self.poles)

    def Pole(self, i):
        assert 1 <= i <= len(self.poles)
        return Pole(*self.poles[i - 1])

    def IsRational(self):
        return self.weights is not None

    def Weight(self, i):
        assert i >= 1
        return self.weights[i - 1]

    def NbKnots(self):
        return len(self.knots)

    def Knot(self, i):
        assert 1 <= i <= len(self.knots)
        return self.knots[i - 1]

    def Multiplicity(self, i):
        assert i >= 1
        return self.multiplicities[i - 1]

    def IsPeriodic(self):
        return self.periodic


def trimmed_curve(curve, low, high):
    """What a Geom_TrimmedCurve answers."""
    return SimpleNamespace(BasisCurve=lambda: curve, FirstParameter=lambda: low, LastParameter=lambda: high, SetTrim=None)


class Objects(unittest.TestCase):
    def test_points(self):
        """Complex numbers and objects with x and y are points wherever points and curves are taken."""
        plane = numpy.array(CUBIC)
        forms = [[complex(*p) for p in CUBIC], [0, *(complex(*p) for p in CUBIC[1:])], [SimpleNamespace(x=x, y=y) for x, y in CUBIC],
                 [SimpleNamespace(x=lambda x=x: x, y=lambda y=y: y) for x, y in CUBIC],
                 [SimpleNamespace(X=lambda x=x: x, Y=lambda y=y: y) for x, y in CUBIC],
                 [SimpleNamespace(x=x, y=y, has_z=False, z=None) for x, y in CUBIC]]
        for form in forms:
            self.assertEqual(gc.evaluate(form, 0.25).tolist(), gc.evaluate(plane, 0.25).tolist())
            self.assertEqual(gc.continuity(form, plane[::-1]).betas, gc.continuity(plane, plane[::-1]).betas)
            self.assertEqual(gc.blend(form, plane).points.tolist(), gc.blend(plane, plane).points.tolist())
            self.assertEqual(gc.fit(form, 0.1).points.tolist(), gc.fit(plane, 0.1).points.tolist())
            self.assertEqual(gc.failing_joins([form, plane[::-1], form], "C0", closed=True).tolist(), [2])
        space = [SimpleNamespace(x=Fraction(k, 3), y=k ** 2, z=k ** 3) for k in range(4)]
        self.assertEqual(gc.interpolate(space, parameters=range(4)).points[-1].tolist(), [1, 9, 27])

    def test_rows(self):
        """Rows of coordinates are refused by the transposed call."""
        rows = numpy.array(CUBIC).T
        calls = {"continuity": lambda: gc.continuity(CUBIC, rows), "evaluate": lambda: gc.evaluate(rows, 0), "fit": lambda: gc.fit(rows, 1),
                 "interpolate": lambda: gc.interpolate(rows.tolist()), "interpolate_fair": lambda: gc.interpolate_fair(rows),
                 "chain_joins": lambda: gc.chain_joins([rows, rows]), "failing_joins": lambda: gc.failing_joins(numpy.array([rows, rows])),
                 "round_corner": lambda: gc.round_corner(tuple(map(tuple, rows)), CUBIC, 1)}
        for name, call in calls.items():
            with self.assertRaises(gc.Error) as caught:
                call()
            self.assertIn(f"{name}: an array of shape (2, 4) has a row for each coordinate, and not for each point: call {name} with points.T",
                          str(caught.exception))
        line = gc.Bezier_curve(rows)
        self.assertEqual(gc.continuity(line, line.reverse()).g_order, 0)

    def test_svgpathtools(self):
        path = Svg_path([Segment(0, 1 + 1j, 2 + 1j, 3 + 0j), Segment(3 + 0j, 4 - 1j, 6 + 0j), Segment(6 + 0j, 7 + 0.5j), Segment(7 + 0.5j, 0)])
        self.assertEqual([join.g_order for join in gc.chain_joins(path)], [1, 1, 0])
        self.assertEqual(gc.failing_joins(path, "G1", closed=True).tolist(), [2, 3])
        self.assertEqual((gc.continuity([(-1, -1), (0, 0)], path).g_order, gc.continuity(path, [(0, 0), (-7, -0.5)]).g_order), (1, 3))
        self.assertEqual(gc.evaluate(path[0], Fraction(1, 2)).tolist(), [1.5, 0.75])
        with self.assertRaisesRegex(gc.Error, "a Svg_path of 4 curves: give one of them"):
            gc.curvature(path, 0)
        arc = type("Arc", (), {"__module__": "svgpathtools.path"})()
        with self.assertRaisesRegex(gc.Error, r"continuity: the Arc of svgpathtools .*: path.approximate_arcs_with_cubics\(\)"):
            gc.continuity(CUBIC, Svg_path([arc]))

    def test_nurbs(self):
        """geomdl and OpenCASCADE, against splines whose knots are written out."""
        points, knots = [(0, 0, 0), (1, 2, 0), (3, 2, 1), (4, 0.25, 0), (6, 1, 0)], [0, 0, 0, 1, 2.5, 3, 3, 3]
        for weights in (None, [1, 2, 1, 0.5, 1]):
            expected = gc.Spline(2, points, knots, weights)
            geomdl = SimpleNamespace(degree=2, ctrlpts=[list(p) for p in points], knotvector=knots, weights=weights)
            for curve in (geomdl, Geom_BSplineCurve(2, points, [0, 1, 2.5, 3], [3, 1, 1, 3], weights)):
                u = numpy.linspace(0, 3, 9)
                self.assertEqual(gc.evaluate(curve, u, 1).tolist(), gc.evaluate(expected, u, 1).tolist())
                self.assertEqual([j.betas for j in gc.chain_joins(curve)], [j.betas for j in gc.chain_joins(expected)])
                self.assertEqual(gc.blend(curve, curve).points.tolist(), gc.blend(expected, expected).points.tolist())
                trimmed = trimmed_curve(curve, 0.5, 2)
                self.assertEqual([p.domain for p in gc.pieces(curve, 0.5, 2)], [(0.5, 1), (1, 2)])
                self.assertEqual([j.c_order for j in gc.chain_joins(trimmed)], [1])
                self.assertEqual(gc.deviation(trimmed, CUBIC_IN_SPACE).gap, gc.deviation(gc.pieces(expected, 0.5, 2)[-1], CUBIC_IN_SPACE).gap)
        with self.assertRaisesRegex(gc.Error, "parameter_outside_domain: chain_joins: the trimmed curve from 2 to 4"):
            gc.chain_joins(trimmed_curve(curve, 2, 4))
        offset = type("Geom_OffsetCurve", (), {"__module__": "OCP.Geom", "BasisCurve": lambda self: curve, "FirstParameter": lambda self: 0,
                                               "LastParameter": lambda self: 3})()
        with self.assertRaisesRegex(gc.Error, "the Geom_OffsetCurve of OCP is none of the curves that are taken"):
            gc.chain_joins(offset)
        nodes = SimpleNamespace(nodes=numpy.asfortranarray(numpy.array(CUBIC).T), degree=3)  # of bezier
        self.assertEqual(gc.evaluate(nodes, 0.25).tolist(), gc.evaluate(numpy.array(CUBIC), 0.25).tolist())
        for module, text in (("OCP.Geom", "GeomConvert.CurveToBSplineCurve_s"), ("OCC.Core.Geom", "geomconvert.CurveToBSplineCurve")):
            with self.assertRaisesRegex(gc.Error, text):
                gc.evaluate(type("Geom_Circle", (), {"__module__": module})(), 0)


class Libraries(unittest.TestCase):
    def test_opencascade(self):
        """Periodic splines, whose knots go around: as OpenCASCADE evaluates those of FreeCAD."""
        part = freecad_part()
        if part is None:
            self.skipTest("not installed: FreeCAD")
        from FreeCAD import Vector

        for first in (1, 2, 3):
            poles = [(k, k * k % 5, k % 3) for k in range(5 + first)]
            knots, multiplicities = [0, 1, 2, 3.5, 4, 5, 6], [first, 1, 1, 1, 1, 1, first]
            for weights in (None, [1 + k / 4 for k in range(len(poles))]):
                theirs = part.BSplineCurve()
                theirs.buildFromPolesMultsKnots([Vector(*p) for p in poles], multiplicities, knots, True, 3, *([weights] if weights else []))
                curve = Geom_BSplineCurve(3, poles, knots, multiplicities, weights, True)
                has_points(curve, lambda u: tuple(theirs.value(u)), numpy.linspace(0, 6, 25))
                self.assertEqual([j.g_order for j in gc.chain_joins([curve], closed=True)], [2] * 5 + [3 - first])

    @needs("matplotlib")
    def test_matplotlib(self):
        from matplotlib.path import Path

        from geometric_continuity.adapters.drawings import path_contours

        circle = Path.unit_circle()
        self.assertEqual(len(gc.chain_joins(circle, closed=True)), 8)
        self.assertEqual([gc.failing_joins(circle, order, closed=True).tolist() for order in ("G2", "G3")], [[], list(range(8))])
        self.assertEqual(gc.failing_joins(Path.unit_rectangle(), closed=True).tolist(), [0, 1, 2, 3])
        self.assertEqual([j.g_order for j in gc.chain_joins(Path([(0, 0), (1, 0), (1, 0), (2, 0), (2, 1)]))], [3, 0])
        mixed = Path([(0, 0), (1, 0), (2, 0), (3, 1), (4, 1), (5, 1), (6, 2), (8, 8), (1, 1), (9, 9), (10, 10), (10, 11)],
                     [1, 2, 3, 3, 4, 4, 4, 79, 2, 1, 2, 2])
        contours = path_contours(mixed)
        self.assertEqual([[len(c) for c in contour] for contour in contours], [[2, 3, 4, 2], [2], [2, 2]])
        for curve, vertices in zip(contours[0], ([(0, 0), (1, 0)], [(1, 0), (2, 0), (3, 1)], [(3, 1), (4, 1), (5, 1), (6, 2)], [(6, 2), (0, 0)])):
            self.assertEqual(curve.tolist(), [list(p) for p in vertices])
        self.assertEqual(contours[1][0].tolist(), [[0, 0], [1, 1]])  # a subpath that starts where one was closed
        with self.assertRaisesRegex(gc.Error, "continuity: a path of 3 subpaths .* path_contours"):
            gc.continuity(mixed, CUBIC)

    @needs("scipy")
    def test_scipy(self):
        from scipy.interpolate import Akima1DInterpolator, BPoly, CubicSpline, PchipInterpolator, PPoly, make_interp_spline

        t = numpy.array([0, 0.5, 2, 3, 3.25, 5])
        points = numpy.column_stack([numpy.cos(t), numpy.sin(2 * t)])
        u = numpy.linspace(0, 5, 41)
        for spline, order in ((CubicSpline(t, points), 2), (PchipInterpolator(t, points), 0), (Akima1DInterpolator(t, points), 1),
                              (make_interp_spline(t, points, 5), 3), (BPoly.from_power_basis(CubicSpline(t, points)), 2)):
            has_points(spline, spline, u)
            self.assertEqual(gc.failing_joins(spline, f"G{order}", tolerance=1e-9).tolist(), [], type(spline))
        parabolas = PPoly(numpy.array([[[1, 0.5], [0, 1]], [[0, 1], [4, 3]], [[0, 1], [4, 5]]]), [0, 2, 3])
        has_points(parabolas, parabolas, [0, 1, 2, 2.5, 3])
        self.assertEqual([str(j) for j in gc.chain_joins(parabolas)], ["C1 G1 F1, beta = (1)"])

    @needs("ezdxf")
    def test_ezdxf(self):
        import ezdxf
        from ezdxf.math import Bezier4P, Vec2

        model = ezdxf.new().modelspace()
        points = [(*p, 1) for p in CUBIC] + [(6, 1, 0), (7, 0, 0)]
        for spline in (model.add_open_spline(points), model.add_rational_spline(points, [1, 2, 1, 1, 0.3, 1])):
            tool = spline.construction_tool()
            for curve in (spline, tool):
                has_points(curve, lambda u: tuple(tool.point(u)), numpy.linspace(0, tool.max_t, 9))
                self.assertEqual([j.c_order for j in gc.chain_joins(curve)], [2, 2])
        cubic = Bezier4P(CUBIC)
        has_points(cubic, lambda u: tuple(cubic.point(u)), [0, 0.3, 1])
        self.assertEqual(gc.fit([Vec2(p) for p in CUBIC], 0.1).points.tolist(), gc.fit(numpy.array(CUBIC), 0.1).points.tolist())
        with self.assertRaisesRegex(gc.Error, "evaluate: the LWPolyline of ezdxf is none of the curves"):
            gc.evaluate(model.add_lwpolyline(CUBIC), 0)


if __name__ == "__main__":
    unittest.main()
