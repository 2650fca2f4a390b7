# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Points, derivatives and curvatures of curves, at one parameter and at many."""

from __future__ import annotations

from typing import Any, List, Optional, Tuple, Union

import numpy

from .curve_types import Spline, derivatives, fractions_of, have_floats, spline_of
from .errors import Error
from .hints import keywords


def _doubles(numbers) -> numpy.ndarray:
    x = numpy.asarray(numbers).astype(float)
    if not numpy.isfinite(x).all():
        raise Error("not_finite", "array", "a number is infinite or undefined")
    return x


def _jet(curve, parameters, order: int, exact: Optional[bool], place: str) -> Tuple[List[numpy.ndarray], Tuple[int, ...]]:
    """Returns the derivatives up to an order in the numbers of the results, of shape (dimension, parameters), and the shape of the parameters."""
    s, u = spline_of(curve, place), numpy.asarray(parameters)
    if u.dtype.kind not in "biufO":
        raise Error("parameter_outside_domain", place, f"parameters are real numbers, not {u.dtype}")
    if exact is None:
        exact = not have_floats(s.points, s.knots, s.weights, u)
    converted = fractions_of if exact else _doubles
    flat, knots = converted(u).ravel(), converted(s.knots)
    low, high = knots[s.degree], knots[len(s.points)]
    outside = ~((low <= flat) & (flat <= high)).astype(bool)
    if outside.any():
        raise Error("parameter_outside_domain", place, f"the parameter {flat[outside.argmax()]} is not in the domain [{low}, {high}]")
    numbers = Spline(s.degree, converted(s.points), knots, None if s.weights is None else converted(s.weights))
    parts = [derivatives(numbers, flat[i:i + 4096], order) for i in range(0, max(flat.size, 1), 4096)]  # which stay in the cache
    return [numpy.concatenate(rows, axis=1) for rows in zip(*parts)], u.shape


@keywords()
def evaluate(curve, parameters, derivative: int = 0, *, exact: Optional[bool] = None) -> numpy.ndarray:
    """Returns the points of a curve at parameters, or its derivatives of an order: an array of shape (dimension,) at one parameter, and
    of the shape of the parameters and (dimension,) at an array of them. At a knot it is the derivative on the right, at the end of the
    domain that on the left.

    curve: an array of shape (degree + 1, dimension), on [0, 1], a `Bezier_curve`, a `Spline`, a BSpline of SciPy, or e.g. a `Blend`.
    derivative: the order of the derivative; 0 for points.
    exact: whether results are fractions; otherwise they are computed in float64.

    >>> evaluate([(0, 0), (1, 2), (2, 0)], 0.5)
    array([1., 1.])

    Raises Error `parameter_outside_domain`, `negative_count`, `wrong_number_of_points`, `dimension_mismatch`, `not_finite`.
    """
    if derivative < 0:
        raise Error("negative_count", "evaluate", "the order of the derivative")
    jet, shape = _jet(curve, parameters, derivative, exact, "evaluate")
    return jet[derivative].T.reshape((*shape, len(jet[0])))


def _first_two(curve, parameters, exact, place):
    """Returns the first and the second derivative and the square of the first one, and the shape of the parameters."""
    (_, a, b), shape = _jet(curve, parameters, 2, exact, place)
    square = (a * a).sum(axis=0)
    zero = square == 0
    if zero.any():
        raise Error("zero_tangent", place, f"the first derivative is zero at the parameter number {zero.argmax()}")
    return a, b, square, shape


@keywords()
def curvature_vector(curve, parameters, *, exact: Optional[bool] = None) -> numpy.ndarray:
    """Returns the second derivative of a curve with respect to arc length, :math:`(x'' - (x' x'' / x' x') x') / x' x'`: arrays as of
    `evaluate`, which takes the same arguments.

    Raises Error `zero_tangent` where the first derivative is zero, and as `evaluate`.
    """
    a, b, square, shape = _first_two(curve, parameters, exact, "curvature_vector")
    along = (a * b).sum(axis=0) / square
    return ((b - along * a) / square).T.reshape((*shape, len(a)))


@keywords()
def curvature(curve, parameters) -> Union[float, numpy.ndarray]:
    """Returns the curvature of a curve at parameters, in 1/length: in the plane with its sign, which is positive where the curve turns
    to the left (in C++ `signed_curvature()`). It is a float at one parameter, and an array of float64 at an array of them. Arguments are
    those of `evaluate`.

    Raises Error `zero_tangent` where the first derivative is zero, and as `evaluate`.
    """
    a, b, square, shape = _first_two(curve, parameters, None, "curvature")
    if len(a) == 2:
        kappa = (a[0] * b[1] - a[1] * b[0]).astype(float) / square.astype(float) ** 1.5
    else:
        along = (a * b).sum(axis=0) / square
        normal = b - along * a
        kappa = numpy.sqrt((normal * normal).sum(axis=0).astype(float)) / square.astype(float)
    return float(kappa[0]) if shape == () else kappa.reshape(shape)


@keywords()
def torsion(curve, parameters, *, exact: Optional[bool] = None) -> Any:
    """Returns the torsion of a space curve at parameters, the determinant of the first three derivatives divided by the square of the
    cross product of the first two, in 1/length: positive where the curve winds like a right-handed screw. It is a number at one
    parameter, and an array at an array of them. Arguments are those of `evaluate`; no root is needed, so that results are fractions where
    the input is exact.

    Raises Error `nonpositive_curvature` where the curvature is zero or undefined, `dimension_mismatch` unless in space, and as `evaluate`.
    """
    (_, a, b, c), shape = _jet(curve, parameters, 3, exact, "torsion")
    if len(a) != 3:
        raise Error("dimension_mismatch", "torsion", f"curves in space have torsion; this one has {len(a)} coordinates")
    normal = numpy.array([a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)])
    square = (normal * normal).sum(axis=0)
    zero = square == 0
    if zero.any():
        raise Error("nonpositive_curvature", "torsion", f"the curvature is zero at the parameter number {zero.argmax()}")
    tau = (normal * c).sum(axis=0) / square
    return tau[0] if shape == () else tau.reshape(shape)
