# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points and curves of other libraries, known by the members that they have: no library is imported, and numbers stay as they are."""

from __future__ import annotations

from typing import Any, List, Optional

import numpy

from .curve_types import Bezier_curve, Spline, pieces
from .errors import Error

# The message tells what to call with the other objects of a library, by the beginning of the names
# of its modules.
_CONVERSIONS = {"OCP.": "GeomConvert.CurveToBSplineCurve_s(curve) returns one that is taken",
                "OCC.": "geomconvert.CurveToBSplineCurve(curve) returns one that is taken",
                "svgpathtools.": "path.approximate_arcs_with_cubics() leaves curves that are taken; verify(file) decides arcs exactly",
                "geomdl.": "curves of BSpline and NURBS are taken",
                "ezdxf.entities.": "SPLINE entities are taken; give the control points of others"}


def conversion(module: str) -> Optional[str]:
    """Returns what to call with an object, of a class of a module, that is no curve here."""
    return next((call for name, call in _CONVERSIONS.items() if module.startswith(name)), None)


def curves_of(curve, place: str) -> Optional[List[Any]]:
    """Returns the curves of an object of another library, as arrays of control points, `Bezier_curve` or `Spline`; None of what is none.

    Paths of matplotlib and of svgpathtools are several curves, each other object is one.
    """
    def has(*names: str) -> bool:
        return all(hasattr(curve, name) for name in names)

    if has("continuous_subpaths"):  # a Path of svgpathtools
        return list(curve)
    if has("bpoints"):  # a segment of it
        return [list(curve.bpoints())]
    if has("vertices", "codes"):  # a Path of matplotlib
        contours = path_contours(curve)
        if len(contours) != 1:
            raise Error("wrong_number_of_points", place, f"a path of {len(contours)} subpaths with a length; path_contours(path) of "
                        "geometric_continuity.adapters.drawings returns the curves of each")
        return list(contours[0])
    if has("ctrlpts", "knotvector") and isinstance(curve.degree, int):  # of geomdl
        return [Spline(curve.degree, curve.ctrlpts, curve.knotvector, getattr(curve, "weights", None) or None)]
    if has("nodes", "degree") and numpy.ndim(curve.nodes) == 2 and numpy.shape(curve.nodes)[1] == curve.degree + 1:  # of bezier
        return [Bezier_curve(numpy.transpose(curve.nodes))]
    if has("Pole", "NbPoles", "Degree"):  # of OpenCASCADE
        return [_of_opencascade(curve)]
    if has("BasisCurve", "SetTrim"):  # an offset curve has a basis curve, too
        return _trimmed(curve, place)
    return _of_ezdxf(curve) if type(curve).__module__.startswith("ezdxf.") else None


def _of_ezdxf(entity) -> Optional[List[Any]]:
    """Reads a SPLINE, its construction tool, or a Bezier curve of ezdxf.math."""
    tool = entity.construction_tool() if hasattr(entity, "construction_tool") else entity
    if not hasattr(tool, "control_points"):
        return None
    points = [tuple(p) for p in tool.control_points]
    if not hasattr(tool, "knots"):
        return [Bezier_curve(points)]
    return [Spline(tool.order - 1, points, list(tool.knots()), list(tool.weights()) or None)]


def _of_opencascade(curve):
    """Reads a Geom_BezierCurve or a Geom_BSplineCurve, or one of Geom2d: numbers begin with 1."""
    def point(i):
        p = curve.Pole(i)
        return (p.X(), p.Y(), p.Z()) if hasattr(p, "Z") else (p.X(), p.Y())

    n, degree = curve.NbPoles(), curve.Degree()
    points = [point(i) for i in range(1, n + 1)]
    weights = [curve.Weight(i) for i in range(1, n + 1)] if curve.IsRational() else None
    if not hasattr(curve, "NbKnots"):
        return Bezier_curve(points, weights)
    knots = [curve.Knot(i) for i in range(1, curve.NbKnots() + 1) for _ in range(curve.Multiplicity(i))]
    if curve.IsPeriodic():  # which goes around: knots before and after, and the first poles once more
        first, last, period = curve.Multiplicity(1), curve.Multiplicity(curve.NbKnots()), knots[-1] - knots[0]
        extra = degree + 1 - first
        inner = knots[:-last]
        knots = [inner[i % n] + period * (i // n) for i in range(-extra, 0)] + knots
        knots += [inner[i % n] + period * (i // n) for i in range(n + last, n + last + extra)]
        points, weights = points + points[:extra], None if weights is None else weights + weights[:extra]
    return Spline(degree, points, knots, weights)


def _trimmed(curve, place: str) -> Optional[List[Any]]:
    """Reads the part of a Geom_TrimmedCurve, where its basis curve is one that is taken."""
    basis, low, high = curves_of(curve.BasisCurve(), place), curve.FirstParameter(), curve.LastParameter()
    if basis is None:
        return None
    found = pieces(basis[0], low, high)
    if not found or (found[0].domain[0], found[-1].domain[1]) != (low, high):
        raise Error("parameter_outside_domain", place, f"the trimmed curve from {low} to {high} is not inside of the domain of its basis curve; "
                    f"{_CONVERSIONS['OCP.']}")
    return list(found)


def path_contours(path) -> List[List[numpy.ndarray]]:
    """Returns the subpaths of a `matplotlib.path.Path` as lists of Bezier curves, arrays of shape (degree + 1, 2), with the line that
    closes one. Segments of no length are left out, and so are subpaths without others."""
    vertices = numpy.asarray(path.vertices)
    codes = [1] + [2] * (len(vertices) - 1) if path.codes is None else [int(code) for code in path.codes]
    number_of_points = {1: 1, 2: 1, 3: 2, 4: 3, 79: 1}
    contours: List[List[numpy.ndarray]] = []
    i, start, at = 0, None, None
    while i < len(vertices) and codes[i] != 0:
        code, end = codes[i], i + number_of_points[codes[i]]
        given = vertices[i:end]
        i = end
        if code == 1 or at is None:
            start = at = given[0]
            contours.append([])
            continue
        if code == 79:
            given = start[None]
        curve = numpy.concatenate([at[None], given])
        at = curve[-1]
        if (curve != curve[0]).any():
            contours[-1].append(curve)
        if code == 79 and i < len(vertices):
            contours.append([])
    return [c for c in contours if c]
