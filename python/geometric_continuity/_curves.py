# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves that are made: blends, rounded corners, splines through points and near them.

Results are arrays of float64; with `exact=True` arrays of `fractions.Fraction` (dtype object), for which the joins hold exactly. Unless
it is given, results are exact where no floating-point number is among the input.

All release the lock of the interpreter, and Ctrl-C ends them within a second.
"""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence

import numpy

from . import _native
from ._native import Enclosure
from .curve_types import Curve, Segmented_curve, Spline, bezier_points, fractions_of, have_floats, pieces, points_of, sides
from .errors import Error
from .hints import check_flag, check_name, keywords, missing_member

STRATEGIES = _native.strategies
"""The names of the strategies of `blend`: to "fair" of degree 5, from "c3" on of degree 7."""

_G3 = [name for name in STRATEGIES if name == "c3" or name.endswith("_g3")]
_BLEND_ORDERS = f"G2 is the default; strategies of G3 are {', '.join(_G3)}"
_DEGREES = "the degree is always 3; interpolate_fair(points) has the degree 5"
_FAIR_DEGREE = "the degree is always 5; interpolate(points) has the degree 3"
_FIT_DEGREES = "order=1 has cubics with G1 joins, order=2 quintics with G2 joins"
_ENDS = "the spline is a natural one, or closed=True; scipy.interpolate.CubicSpline has others, and is taken as a curve"


@dataclass(frozen=True)
class Blend(Curve):
    """A blend: a Bezier curve on [0, 1], and what its strategy chose."""

    points: numpy.ndarray  #: control points, shape (6, dimension) or (8, dimension)
    beta: object  #: the shape parameter at the end of the first curve: a float, or a Fraction
    eta: object  #: the shape parameter at the start of the second curve
    fallback_start: bool  #: whether the strategy is undefined at the start and chose by another rule
    fallback_end: bool  #: whether the strategy is undefined at the end and chose by another rule
    automatic_fairness: Optional[float]  #: of fair strategies: the variation of curvature where the search started
    fairness: Optional[float]  #: of fair strategies: the variation of curvature of the result
    converged: bool  #: whether the search ended in a local minimum


@dataclass(frozen=True)
class Representable_blend(Curve):
    """A blend with float64 control points whose joins with `phi` and `psi` are exactly G2."""

    points: numpy.ndarray  #: control points, shape (6, dimension)
    phi: numpy.ndarray  #: the first curve, whose last three control points may have been moved to a grid
    psi: numpy.ndarray  #: the second curve, whose first three control points may have been moved
    moved: float  #: the largest change of a coordinate; 0 when nothing was moved


@dataclass(frozen=True)
class Clothoid_blend:
    """Three clothoids with continuous curvature between two ends."""

    segments: numpy.ndarray  #: shape (3, 6): x, y and heading at the start, curvature at the start and at the end, length
    gaps: tuple  #: of the four joins: with the start, with each other, with the end; an `Enclosure` for each
    kinks: tuple  #: the angles between the directions there, in radians
    jumps: tuple  #: the differences of the curvatures there, all exactly 0

    def __getattr__(self, name):
        missing_member(self, name)


@dataclass(frozen=True)
class Rounded_corner:
    """Two curves that are cut near their corner, and the blend between them."""

    left: numpy.ndarray  #: control points of the left curve from its start to the cut
    blend: Any  #: control points of the blend, an array; of cubics a `Segmented_curve`
    right: numpy.ndarray  #: control points of the right curve from the cut to its end
    left_cut: object  #: the parameter where the left curve is cut
    right_cut: object  #: the parameter where the right curve is cut

    def __getattr__(self, name):
        missing_member(self, name)


@dataclass(frozen=True)
class Fair_spline(Segmented_curve):
    """A G2 spline of fair quintics through points."""

    moved: object  #: the largest change of a coordinate of a point, which leaves room for exact joins; 0 where it is exact
    rounded: List[int]  #: the points at which rounding may have broken the join


@dataclass(frozen=True)
class Fitted_curve(Segmented_curve):
    """Few Bezier curves near a polyline, whose joins hold exactly."""

    vertices: List[int]  #: the numbers of the vertices at which segments meet
    corners: List[int]  #: the numbers of the vertices that are corners
    distance: float  #: a proved bound of the distance of curve and polyline, both ways


@keywords()
def clothoid_blend(start, end, *, exact: bool = False) -> Clothoid_blend:
    """Returns three clothoids from `start` to `end` with continuous curvature, also at both ends. Each starts where the one before ends,
    rounded to a decimal of 17 digits; what that leaves is enclosed.

    start, end: (x, y, heading, curvature), the heading in radians from the x-axis, counter-clockwise; the curvature is positive to
        the left. Numbers are read exactly, as by `continuity`.
    exact: whether the numbers of the segments are fractions, the very decimals for which gaps and kinks are enclosed; float64 are
        the nearest to them, and read back as the same decimals.

    Raises Error: `zero_direction` when both points are equal, `not_representable` when no such clothoids are found,
    `wrong_number_of_points` for other shapes, `not_finite`, `work_limit`.
    """
    check_flag("clothoid_blend", "exact", exact, "the joins are enclosed either way")
    return Clothoid_blend(**_native.clothoid_blend(start, end, exact))


@keywords(order=_BLEND_ORDERS, G=_BLEND_ORDERS)
def blend(left, right, strategy: str = "energy3", *, beta=None, eta=None, parameters: Sequence = (),
          exact: Optional[bool] = None) -> Blend:
    """Returns the blend from the end of `left` to the start of `right`: a Bezier curve on [0, 1] of degree 5 with G2 joins, or of degree
    7 with G3 or F3 joins, by the strategy.

    left, right: arrays of shape (degree + 1, dimension), or curves with weights and splines, as of `continuity`: the blend depends on
        their derivatives at the join.
    strategy: one of STRATEGIES; "energy3" has the least energy of the third derivative, "fair" varies the curvature least.
    beta, eta: shape parameters, positive; automatic unless they are given.
    parameters: of the strategy "free": (s1, s2) of degree 5, or (beta2, mu, beta3) at the start and at the end of degree 7.
    exact: whether results are fractions, with joins that hold exactly; float64 rounds the joins.

    Raises Error: `zero_tangent`, `nonpositive_beta`, `dimension_mismatch`, `wrong_number_of_points`, `not_finite`,
    `parameter_outside_domain` for another strategy.
    """
    if str(strategy).lower() in ("g1", "g2", "g3", "1", "2", "3"):
        raise Error("parameter_outside_domain", "blend", f"{strategy!r} is no strategy: {_BLEND_ORDERS}")
    check_name("blend", "strategy", strategy, STRATEGIES)
    a, b = sides(left, right, "blend")
    return Blend(**_native.blend(a.points, b.points, strategy, beta, eta, tuple(parameters), a.exact(b.exact(exact))))


@keywords()
def fair(left, right, order: int = 2, *, exact: Optional[bool] = None) -> Blend:
    """Returns the blend whose curvature varies least: that of `blend` with the strategy "fair", of degree 5 with G2 joins, or with
    `order=3` "fair_g3", of degree 7 with G3 joins.

    Raises Error as `blend`, and `parameter_outside_domain` for another order.
    """
    if order not in (2, 3):
        raise Error("parameter_outside_domain", "fair", f"the order {order} is not 2 or 3")
    return blend(left, right, "fair" if order == 2 else "fair_g3", exact=exact)


@keywords()
def representable_blend(left, right, strategy: str = "fair") -> Representable_blend:
    """Returns a blend of degree 5 whose control points are float64 and whose joins are exactly G2 nevertheless.

    left, right: arrays of shape (degree + 1, dimension), of float64 numbers.
    strategy: "fair" or "energy3".

    Raises Error: `not_representable` where there are no such numbers, and as `blend`.
    """
    check_name("representable_blend", "strategy", strategy, ("fair", "energy3"))
    left, right = (bezier_points(curve, "representable_blend") for curve in (left, right))
    return Representable_blend(**_native.representable_blend(left, right, strategy))


def _check_size(place: str, distance, radius) -> None:
    if (distance is None) == (radius is None):
        raise Error("parameter_outside_domain", place, "a distance is needed, or a radius, and not both")
    name, size = ("distance", distance) if radius is None else ("radius", radius)
    if not isinstance(size, numbers.Number):
        raise Error("parameter_outside_domain", place, f"the {name} is a number, not {size!r}")


@keywords()
def round_corner(left, right, distance=None, strategy: str = "fair", *, radius=None, exact: Optional[bool] = None) -> Rounded_corner:
    """Rounds the corner in which `left` ends and `right` starts: cuts off what is nearer to it than `distance` along the curves, and puts
    a blend there.

    left, right: arrays of shape (degree + 1, dimension).
    distance: positive, in units of the coordinates, less than the length of each curve.
    radius: in place of the distance: that at which a circle of this radius touches both tangents. The blend is bent more in its middle:
      `curvature_excess(curve, 1 / R)` decides whether its radius is less than R somewhere.
    strategy: "fair", "energy3" (G2), "fair_g3" (G3), or cubics with G2 joins: "cubic", one with both handles in the corner between lines
        and two, in the plane, elsewhere; "two_cubics" always takes two, which are fuller.

    Raises Error: `curves_do_not_meet`, `parameter_outside_domain`, `zero_tangent`, `zero_direction`, `dimension_mismatch`, `not_finite`,
    `not_representable` when no two cubics are found.
    """
    check_name("round_corner", "strategy", strategy, ("fair", "energy3", "fair_g3", "cubic", "two_cubics"))
    left, right = (bezier_points(curve, "round_corner") for curve in (left, right))
    _check_size("round_corner", distance, radius)
    record = _native.round_corner(left, right, distance if radius is None else radius, radius is not None, strategy, exact)
    knots = record.pop("knots")
    if knots is not None:
        record["blend"] = Segmented_curve(3, record["blend"], knots)
    return Rounded_corner(**record)


@keywords()
def round_corners(points, distance=None, closed: bool = False, strategy: str = "fair", *, radius=None, exact: Optional[bool] = None
                  ) -> List[numpy.ndarray]:
    """Rounds all corners of the polyline or the polygon with these vertices, each as `round_corner` does. Returns the curves in their
    order, arrays of control points: what remains of the sides, and the blends between them. `chain_joins` decides their joins.

    points: the vertices, an array of shape (n, dimension).
    distance, radius: as of `round_corner`; corners of short sides are cut nearer, so that a quarter of each side remains.
    closed: whether the last vertex has a side to the first one; it is so too where both are one point.

    Raises Error: `wrong_number_of_points`, `parameter_outside_domain` also for a side of no length, and as `round_corner`.
    """
    check_flag("round_corners", "closed", closed, "call round_corners(points, distance, closed=True)")
    given = numpy.array(points_of(points, "round_corners"), dtype=object)
    if given.ndim != 2 or len(given) < 2 or any(hasattr(x, "__len__") for x in given.flat):
        raise Error("wrong_number_of_points", "round_corners", "the vertices of a polyline are needed, an array of shape (n, dimension), n > 1; "
                    "round_corner(left, right, distance) rounds the corner of two curves")
    _check_size("round_corners", distance, radius)
    exact = not have_floats(points) if exact is None else exact
    vertices = fractions_of(given)
    if len(vertices) > 2 and (vertices[0] == vertices[-1]).all():
        closed, vertices, given = True, vertices[:-1], given[:-1]
    n = len(vertices)
    sides = [(i, (i + 1) % n) for i in range(n if closed else n - 1)]
    steps = [vertices[b] - vertices[a] for a, b in sides]
    for (a, b), step in zip(sides, steps):
        if not step.any():
            raise Error("parameter_outside_domain", "round_corners", f"the vertices {a} and {b} are one point")
    squares = [(v * v).sum() for v in steps]

    def distance_at(i: int):
        """Returns the distance of both cuts from the vertex at the end of a side; None where the next side goes straight on."""
        a, b = steps[i], steps[(i + 1) % len(steps)]
        along, square = (a * b).sum(), squares[i] * squares[(i + 1) % len(steps)]
        if along > 0 and along * along == square:
            return None
        cosine, sine = (math.copysign(math.sqrt(x / square), along) for x in (along * along, square - along * along))
        return distance if radius is None else float(radius) * math.tan(math.atan2(abs(sine), cosine) / 2)

    distances = [distance_at(i) for i in range(len(steps) if closed else len(steps) - 1)] + [None] * (not closed)
    longest = [math.hypot(*map(float, v)) * (0.375 if None not in (distances[i], distances[i - 1]) else 0.75) for i, v in enumerate(steps)]
    corners = vertices if exact else vertices.astype(float)
    ends = [[corners[a], corners[b]] for a, b in sides]
    blends: List[List[numpy.ndarray]] = [[] for _ in sides]
    for i, d in enumerate(distances):
        if d is None:
            continue
        following = (i + 1) % len(sides)
        limit = min(longest[i], longest[following])
        size = dict(distance=limit) if limit < d else dict(distance=distance, radius=radius)
        try:
            corner = round_corner(given[list(sides[i])], given[list(sides[following])], strategy=strategy, exact=exact, **size)
        except Error as error:
            raise Error(error.code, "round_corners", f"vertex {sides[i][1]}: {error.reason}") from None
        ends[i][1], ends[following][0] = corner.left[-1], corner.right[0]
        blends[i] = list(corner.blend) if isinstance(corner.blend, Segmented_curve) else [corner.blend]
    return [curve for side, blend in zip(ends, blends) for curve in (numpy.array(side), *blend)]


@keywords()
def fairness(curve) -> float:
    """Returns the variation of curvature of a Bezier curve, L^3 times the integral of the squared derivative of the curvature vector
    with respect to arc length, without its tangential part. It does not depend on the size; the smaller, the fairer; inf at a cusp.

    curve: an array of shape (degree + 1, dimension).

    Raises Error: `work_limit`, `not_finite`, `wrong_number_of_points`.
    """
    return _native.fairness(bezier_points(curve, "fairness"))


@dataclass(frozen=True)
class Curvature_excess:
    """The place where a curve is bent most, of one whose curvature exceeds a bound."""

    piece: int  #: the number of the Bezier curve, from 0 on
    parameter: Enclosure  #: in the domain of the curve
    curvature: Enclosure  #: in the plane with a sign, positive in a left turn
    unbounded: bool  #: whether the curvature has no bound there: a cusp, or a curve that turns back


@keywords()
def curvature_excess(curve, bound) -> Optional[Curvature_excess]:
    """Decides exactly whether the curvature of a curve is nowhere larger than a bound, in the plane its absolute value. Returns None if
    so, also where it reaches the bound, and otherwise the place where the curve is bent most.

    curve: any curve; angles at the joins of its pieces are not asked for.
    bound: a number, not negative; 1/R, exactly `Fraction(1) / R`, where no radius of curvature may be less than R.

    Raises Error: `unreachable_tolerance` for a negative bound, `not_finite`, `work_limit`, `wrong_number_of_points`, `dimension_mismatch`.
    """
    worst: Optional[Curvature_excess] = None

    def size(place: Curvature_excess) -> float:
        return max(-place.curvature.lower, place.curvature.upper)

    for number, piece in enumerate(pieces(curve)):
        found = _native.curvature_excess(piece.points, () if piece.weights is None else piece.weights, piece.domain, bound)
        if found is not None:
            place = Curvature_excess(number, *found)
            worst = place if worst is None or size(worst) < size(place) else worst
    return worst


@keywords(**dict.fromkeys(("degree", "k", "p"), _DEGREES), bc_type=_ENDS)
def interpolate(points, closed: bool = False, parametrisation: str = "chordal", parameters: Sequence = (), *,
                exact: Optional[bool] = None) -> Spline:
    """Returns the cubic spline through points, C2 inside: a natural one, or a closed one over periodic knots. Its parameter runs over the
    chord length, from 0 to the sum of the distances between the points, and not over [0, 1]: `spline.domain` tells.

    points: an array of shape (n, dimension), at least 2 points, or 3 if closed.
    closed: a bool; whether the curve goes back to the first point.
    parametrisation: "chordal", "uniform" (the points have the parameters 0, 1, 2, ...) or "centripetal" (square roots of distances); those
        of distances round these to floats, exactly reproducible.
    parameters: one for each point, increasing, for a closed curve one more; then the parametrisation does not matter.

    Raises Error: `wrong_number_of_points`, `empty_domain` unless parameters increase, `dimension_mismatch`, `not_finite`, `work_limit`,
    `parameter_outside_domain` where `closed` is no bool.
    """
    given = points_of(points, "interpolate")
    check_flag("interpolate", "closed", closed, _DEGREES)
    check_name("interpolate", "parametrisation", parametrisation, ("uniform", "chordal", "centripetal"))
    return Spline(**_native.interpolate(given, closed, parametrisation, tuple(parameters), exact))


@keywords(**dict.fromkeys(("degree", "k", "p"), _FAIR_DEGREE))
def interpolate_fair(points, closed: bool = False, *, exact: Optional[bool] = None) -> Fair_spline:
    """Returns a spline of fair quintics through points, whose joins are exactly G2, with float64 too (but at the points in `rounded`).

    points: an array of shape (n, dimension), at least 2 points, or 3 if closed.

    Raises Error: `wrong_number_of_points`, `empty_domain` where consecutive points coincide, `not_finite`,
    `parameter_outside_domain` where `closed` is no bool.
    """
    check_flag("interpolate_fair", "closed", closed, _FAIR_DEGREE)
    return Fair_spline(**_native.interpolate_fair(points_of(points, "interpolate_fair"), closed, exact))


@keywords(**dict.fromkeys(("degree", "k", "p"), _FIT_DEGREES))
def fit(points, tolerance, order: int = 1, closed: bool = False, corner_angle: float = 45, *,
        exact: Optional[bool] = None) -> Fitted_curve:
    """Returns few Bezier curves near a polyline, at most `tolerance` away from it, which is proved, and joined exactly.

    points: the vertices, an array of shape (n, dimension).
    tolerance: positive, in units of the coordinates.
    order: 1 for cubics with G1 joins, 2 for quintics with G2 joins.
    corner_angle: degrees; where the polyline turns by more it has a corner, which is kept.

    Raises Error: `wrong_number_of_points`, `parameter_outside_domain`, `unreachable_tolerance`, `not_finite`.
    """
    if not isinstance(order, (int, numpy.integer)):
        raise Error("parameter_outside_domain", "fit", f"the order is 1 or 2, not {order!r}: {_FIT_DEGREES}")
    check_flag("fit", "closed", closed, "call fit(points, tolerance, order=1, closed=False, corner_angle=45)")
    return Fitted_curve(**_native.fit(points_of(points, "fit"), tolerance, order, closed, corner_angle, exact))
