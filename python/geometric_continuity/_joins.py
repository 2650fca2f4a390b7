# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Joins of curves and edges of surfaces: decided exactly, measured with guaranteed bounds."""

from __future__ import annotations

import warnings
from typing import List, Optional, Tuple

import numpy

from . import _native
from ._native import Edge_continuity, Join_continuity, Join_deviation, Kink_size, Order_within, Visual_class
from .curve_types import Segmented_curve, chain, is_array, points_of, refuse_rows, side, sides
from .errors import Error
from .hints import check_flag, check_name, keywords

_ORDERS = [kind + number for kind in "CGF" for number in "0123"]


@keywords(order="max_order=3 is the highest order that is decided; the result has .g_order", tolerance="order_within(left, right, tolerance) "
          "decides within tolerances; continuity decides exactly")
def continuity(left, right=None, max_order: int = 3) -> Join_continuity:
    """Decides the continuity of the join between the end of `left` and the start of `right`, up to `max_order`, exactly on the
    numbers as given.

    left, right: Bezier curves on [0, 1], arrays of shape (degree + 1, dimension); degrees may differ. Numbers may be int, float,
        fractions.Fraction and decimal.Decimal, each read as it is. `Bezier_curve`, `Spline` and BSplines of SciPy, with weights
        and domains, are taken, too: C orders and shape parameters are those with respect to their parameters.

    Raises Error: `negative_count`, `dimension_mismatch`, `wrong_number_of_points` for other shapes, `not_finite`, `work_limit`.
    """
    if right is None:
        raise Error("wrong_number_of_points", "continuity", "a join has two curves: continuity(left, right); "
                    "chain_joins(curve) decides those inside of a spline or between the curves of a list")
    if not isinstance(max_order, (int, numpy.integer)) or isinstance(max_order, bool):
        raise Error("parameter_outside_domain", "continuity", f"max_order is the highest order that is decided, such as 3, not {max_order!r}; "
                    "the result has .g_order, and order_within(left, right, tolerance) decides within tolerances")
    a, b = sides(left, right, "continuity", max_order)
    return _native.continuity(a.points, b.points, max_order)


@keywords()
def chain_joins(curves, closed: bool = False) -> List[Join_continuity]:
    """Decides the joins of consecutive curves as `continuity` does: those inside of a spline at its knots, or between the curves of a
    list, whose splines have joins, too.

    curves: a `Spline`, a BSpline of SciPy, a result such as `Fair_spline`, or a list of curves; or an array of shape
        (n, degree + 1, dimension).
    closed: whether the last curve and the first one have a join, which is the last of the result.

    Raises Error: as `continuity`, and `parameter_outside_domain` where `closed` is no bool.
    """
    check_flag("chain_joins", "closed", closed, "every join is decided up to order 3: chain_joins(curves)[0].g_order; "
               "two curves are a list: chain_joins([left, right])")
    found = chain(curves, "chain_joins")
    return [continuity(a, b) for a, b in zip(found, found[1:] + (found[:1] if closed else []))]


def _lie_side_by_side(left, right, gap: float) -> bool:
    """Tells whether both the starts and the ends of two curves are nearer to each other than the end of the first to the start of the
    second, and they are not one curve."""
    def ends(curve):
        points = [side(curve, "deviation", at_end, ignore_domain=True).points for at_end in (False, True)]
        return [numpy.array(points_of(p), dtype=float)[-at_end] for p, at_end in zip(points, (0, 1))]

    distances = [numpy.linalg.norm(x - y) for x, y in zip(ends(left), ends(right))]
    return 0 < max(distances) < gap


@keywords()
def deviation(left, right) -> Join_deviation:
    """Returns how far the join between the end of `left` and the start of `right` is from being continuous: guaranteed enclosures
    of the gap (units of the coordinates), the angle of the tangents (radians), the relative jump of the curvature vector and the
    jump of the torsion (1/length). The distance of whole curves is not measured: a UserWarning says so where two curves lie side by side,
    their starts and their ends nearer to each other than the ends at the join.

    left, right: curves as of `continuity`.

    Raises Error: `dimension_mismatch`, `wrong_number_of_points`, `not_finite`, `work_limit`.
    """
    a, b = sides(left, right, "deviation", ignore_domain=True)
    found = _native.deviation(a.points, b.points)
    if found.gap.lower > 0 and _lie_side_by_side(left, right, found.gap.lower):
        warnings.warn("deviation(left, right) measures the join, from the end of left to the start of right, and these curves lie side by "
                      "side; the distance of whole curves is not measured", stacklevel=3)
    return found


@keywords()
def order_within(left, right, tolerance=0, *, gap=None, tangent_angle=None, curvature_jump=None, torsion_jump=None,
                 curvature_derivative=None) -> Order_within:
    """Decides which order the join between the end of `left` and the start of `right` has within tolerances: each of the orders 0 to 3
    is proved, refuted, or undecided where a tolerance lies inside of an enclosure of `deviation`.

    left, right: curves as of `continuity`.
    tolerance: the tolerance of each quantity that has none of its own; by default these must hold exactly.
    gap: in units of the coordinates; tangent_angle: in radians; curvature_jump: relative; torsion_jump: in space, in 1/length;
        curvature_derivative: in the plane, in 1/length^2.

    Raises Error: `unreachable_tolerance` for a negative tolerance, and as `deviation`.
    """
    a, b = sides(left, right, "order_within", ignore_domain=True)
    bounds = [tolerance if x is None else x for x in (tangent_angle, curvature_jump, torsion_jump, gap, curvature_derivative)]
    return _native.order_within(a.points, b.points, *bounds)


@keywords()
def visual_class(left, right, kink_angle=5) -> Optional[Visual_class]:
    """Returns what a join of two plane curves looks like: gap, corner, kink, g1 or g2; None where a curve has no length.

    left, right: curves in the plane, as of `continuity`.
    kink_angle: degrees; the largest angle that is a kink and no corner, read exactly as it is.

    Raises Error: `dimension_mismatch` unless in the plane, `parameter_outside_domain` unless 0 <= kink_angle < 180, `not_finite`.
    """
    a, b = sides(left, right, "visual_class", ignore_domain=True)
    return _native.visual_class(a.points, b.points, kink_angle)


@keywords()
def kink_size(left, right) -> Optional[Kink_size]:
    """Returns how large the angle at a join of two plane curves is: enclosures of the angle (radians), of how far a handle is off and
    of the severity (units of the coordinates); None where a curve has no length.

    left, right: curves in the plane, as of `continuity`; handles are those of Bezier curves without weights, of a curve with
        weights a third of its derivative.

    Raises Error: `dimension_mismatch` unless in the plane, `not_finite`.
    """
    a, b = sides(left, right, "kink_size", ignore_domain=True)
    return _native.kink_size(a.points, b.points)


@keywords()
def align_handles(left: Tuple[int, int], right: Tuple[int, int], max_squared_move: int
                  ) -> Optional[Tuple[Tuple[int, int], Tuple[int, int]]]:
    """Returns handles of one direction, as whole vectors, as near as possible to those given, which is proved; None where they form an angle
    of more than 45 degrees, or a handle would have to move farther than the bound.

    left, right: whole vectors in units of a grid, from the handle on the left to the node and from the node to the handle on the right.
    max_squared_move: the square of the largest move.

    Raises Error: `zero_tangent` for a handle of no length, `work_limit` for one of more than 2^28 units.
    """
    return _native.align_handles(left, right, max_squared_move)


@keywords()
def align_handle(handle: Tuple[int, int], direction: Tuple[int, int]) -> Tuple[int, int]:
    """Returns the whole vector nearest to a handle that has a direction, e.g. that of a line.

    Raises Error: `zero_tangent` for a vector of no length, `work_limit` for one of more than 2^28 units.
    """
    return _native.align_handle(handle, direction)


@keywords()
def failing_joins(points, order: str = "G2", closed: bool = False, parallel: bool = False, tolerance=0, *, gap=None, tangent_angle=None,
                  curvature_jump=None, torsion_jump=None, curvature_derivative=None) -> numpy.ndarray:
    """Returns the joins of consecutive curves that do not have an order, exactly, or within tolerances: numbers i in increasing order, for
    the join of the curves i and i + 1, as an array of integers.

    points: n Bezier curves of one degree, an array of shape (n, degree + 1, dimension). In the plane and in space an array of
        float64 is read where it is, with any strides; nothing is copied. Or a spline, or a list of curves, as of `chain_joins`.
    order: "C0" to "C3", "G0" to "G3", "F0" to "F3".
    closed: whether the last curve and the first one have a join, the number n - 1, too.
    parallel: on several cores, where the module was built with TBB.
    tolerance, gap, tangent_angle, curvature_jump, torsion_jump, curvature_derivative: as of `order_within`, for orders G: a join fails
        unless its order is proved within them. For C1 and C2 the relative jump of the first derivative is at most the angle, that of the
        second one at most `curvature_jump`.

    The lock of the interpreter is released meanwhile, and signals such as that of Ctrl-C are seen.

    Raises Error: `wrong_number_of_points` for another shape, `parameter_outside_domain` for another order
        and flags that are no bool, `not_finite`.
    """
    check_name("failing_joins", "order", order, _ORDERS)
    for name, flag in (("closed", closed), ("parallel", parallel)):
        check_flag("failing_joins", name, flag, "call failing_joins(points, \"G2\", closed=True, parallel=True)")
    tolerances = dict(gap=gap, tangent_angle=tangent_angle, curvature_jump=curvature_jump, torsion_jump=torsion_jump,
                      curvature_derivative=curvature_derivative)
    if tolerance != 0 or any(x is not None for x in tolerances.values()):
        if order[0] == "F" or order == "C3":
            raise Error("parameter_outside_domain", "failing_joins", f"tolerances are those of orders G0 to G3 and C0 to C2, not of {order}")
        exactly = failing_joins(points, order, closed, parallel)  # what holds exactly holds within all tolerances
        found = chain(points, "failing_joins")
        if order[0] == "C":
            bounds = [tolerance if x is None else x for x in (tangent_angle, curvature_jump, gap)]

            def fails(i) -> bool:
                a, b = sides(found[i], found[(i + 1) % len(found)], "failing_joins", int(order[1]))
                return _native.is_c_within(a.points, b.points, int(order[1]), *bounds) != "proved"

            return numpy.array([i for i in exactly if fails(i)], dtype=numpy.intp)
        return numpy.array([i for i in exactly if order_within(found[i], found[(i + 1) % len(found)], tolerance, **tolerances)
                            .verdicts[int(order[1])] != "proved"], dtype=numpy.intp)
    if isinstance(points, Segmented_curve) and order[0] != "C":
        points = points.segments
    points = points_of(points)
    in_one_array = is_array(points) and (isinstance(points, numpy.ndarray) or all(is_array(c) and len(c) == len(points[0]) for c in points))
    if in_one_array and len(points) > 0:
        refuse_rows(points[0], "failing_joins")
    if not in_one_array:
        found = chain(points, "failing_joins")
        arrays = [getattr(c, "points", c) for c in found if getattr(c, "weights", None) is None]
        if order[0] == "C" or len(arrays) < len(found) or len({numpy.shape(a) for a in arrays}) > 1:
            kind = {"C": "c_order", "G": "g_order", "F": "f_order"}[order[0]]
            return numpy.array([i for i, join in enumerate(chain_joins(found, closed)) if getattr(join, kind) < int(order[1])], dtype=numpy.intp)
        points = numpy.array(arrays)  # for orders G and F domains do not matter
    return _native.failing_joins(points, order, closed, parallel)


@keywords()
def edge_continuity(a, edge_a=None, b=None, edge_b=None) -> Edge_continuity:
    """Decides the continuity of two Bezier surfaces along an edge of each, exactly, on the whole closed edge: `edge_continuity(a, "u1", b,
    "u0")`, or along the edge that they have in common, `edge_continuity(a, b)`. The edge of `b` may run backwards.

    a, b: arrays of shape (degree u + 1, degree v + 1, 3): b[i, j] is the control point of the basis functions i in u, j in v.
    edge_a, edge_b: "u0", "u1" (u = 0, u = 1), "v0" or "v1". Without them the common edge is looked for among all pairs: first one that is
        the same as a whole, then one of which a part is. Edges that are a point do not count. Where `a` and `b` are one object, two of its
        edges are the common one.

    Raises Error: `dimension_mismatch` unless in space, `wrong_number_of_points`, `parameter_outside_domain` for another edge,
    `not_finite`, `work_limit`; without edges `curves_do_not_meet` where there is no common one, `several_common_edges` with their names.
    """
    if b is None and edge_b is None:
        b, edge_a = edge_a, None
    if b is None:
        raise Error("wrong_number_of_points", "edge_continuity", "two surfaces are needed: call edge_continuity(a, b), or "
                    "edge_continuity(a, \"u1\", b, \"u0\")")
    if edge_a is None and edge_b is None:
        try:
            return _native.edge_continuity(a, b)
        except Error as error:
            hint = {"several_common_edges": "; name one pair, as in edge_continuity(a, \"u1\", b, \"u0\")"}.get(error.code, "")
            raise Error(error.code, error.place, error.reason.partition(";")[0] + hint) from None
    if not isinstance(edge_a, str):
        raise Error("parameter_outside_domain", "edge_continuity", "each surface stands before its edge: call edge_continuity(a, \"u1\", b, \"u0\"), or "
                    "edge_continuity(a, b)")
    for edge in (edge_a, edge_b):
        check_name("edge_continuity", "edge", edge, ("u0", "u1", "v0", "v1"))
    return _native.edge_continuity(a, edge_a, b, edge_b)
