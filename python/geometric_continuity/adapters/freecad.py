# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Edges and wires of FreeCAD (`Part`): their Bezier curves, with the floats that FreeCAD has read exactly as they are, and their joins."""

from __future__ import annotations

from typing import Iterator, List, Tuple

from .._native import Join_continuity, Order_within
from ..curve_types import Bezier_curve, Spline, pieces
from .._joins import continuity, order_within

_CONVERTED = ("Line", "LineSegment", "Circle", "ArcOfCircle", "Ellipse", "ArcOfEllipse", "Hyperbola", "ArcOfHyperbola", "Parabola", "ArcOfParabola")


def edge_pieces(edge) -> List[Bezier_curve]:
    """Returns the Bezier curves of a `Part.Edge` in its direction, with the parameters of its curve as domains. Those of Bezier and B-spline
    curves are exact, also where the edge is a part of its curve; lines and conics are the rational curves as which FreeCAD writes them.

    Raises ValueError for other curves, e.g. offsets.
    """
    curve = edge.Curve
    low, high = edge.ParameterRange
    kind = type(curve).__name__
    if kind in _CONVERTED:
        # curve.toNurbs(low, high) rotates circles, and approximates ellipses and hyperbolas
        curve = edge.toNurbs().Edges[0].Curve
        low = high = None
    if kind == "BezierCurve":
        degree, knots = curve.Degree, [0] * (curve.Degree + 1) + [1] * (curve.Degree + 1)
    elif kind in _CONVERTED or kind == "BSplineCurve":
        degree, knots = curve.Degree, curve.KnotSequence
    else:
        raise ValueError(f"the curve of the edge is a {kind}")
    points = [tuple(p) for p in curve.getPoles()]
    weights = curve.getWeights() if curve.isRational() else [1] * len(points)
    extra = len(knots) - degree - 1 - len(points)  # of a periodic spline, which goes around
    points, weights = points + points[:extra], weights + weights[:extra]
    found = pieces(Spline(degree, points, knots, weights), low, high)
    return [p.reverse() for p in reversed(found)] if edge.Orientation == "Reversed" else found


def _chain(wire) -> List[Tuple[int, Bezier_curve]]:
    return [(number, piece) for number, edge in enumerate(wire.OrderedEdges) for piece in edge_pieces(edge)]


def wire_pieces(wire) -> List[Bezier_curve]:
    """Returns the Bezier curves of a `Part.Wire` in the order of `wire.OrderedEdges`, e.g. for `failing_joins(wire_pieces(wire), "G1",
    wire.isClosed(), tolerance=1e-7)`.

    Raises ValueError as `edge_pieces`.
    """
    return [piece for _, piece in _chain(wire)]


def wire_joins(wire) -> Iterator[Tuple[int, Join_continuity]]:
    """Decides the joins of a `Part.Wire`, those inside of its edges too: yields the number of the edge, in the order of `wire.OrderedEdges`,
    in which the curve before the join ends, and what was decided exactly. Edges that meet within a tolerance only, as most of FreeCAD do,
    have a gap: ask `wire_joins_within`. Derivatives are those with respect to the parameter of the curve of each edge."""
    chain = _chain(wire)
    for (number, left), (_, right) in zip(chain, chain[1:] + (chain[:1] if wire.isClosed() else [])):
        yield number, continuity(left, right)


def wire_joins_within(wire, tolerance=1e-7, *, gap=None, tangent_angle=None, curvature_jump=None) -> Iterator[Tuple[int, Order_within]]:
    """Decides the joins of a `Part.Wire` within tolerances: yields numbers of edges as `wire_joins`, and what `order_within` returns, which
    has the enclosures of gap, angle and curvature jump.

    tolerance: that of each quantity that has none of its own; by default that of FreeCAD.
    gap: in mm; by default `tolerance`, or the tolerance of a vertex of both edges where that is larger.
    tangent_angle: in radians; curvature_jump: relative.
    """
    edges, chain = wire.OrderedEdges, _chain(wire)
    for (number, left), (other, right) in zip(chain, chain[1:] + (chain[:1] if wire.isClosed() else [])):
        allowed = max([tolerance] + [v.Tolerance for i in {number, other} for v in edges[i].Vertexes]) if gap is None else gap
        yield number, order_within(left, right, tolerance, gap=allowed, tangent_angle=tangent_angle, curvature_jump=curvature_jump)
