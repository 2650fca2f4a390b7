# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves as they are given: arrays of control points, curves with weights and domains, splines, and what other libraries hold.

Every function of a curve takes: an array of shape (degree + 1, dimension), or in the plane of complex numbers; lists of objects with x and
y; `Bezier_curve`, `Spline`, and results such as `Blend`; the splines of SciPy, `BSpline`, `PPoly`, `CubicSpline` and tuples (t, c, k) of
`splprep`; and what `foreign` knows: paths of matplotlib and svgpathtools, curves of geomdl, OpenCASCADE and ezdxf.
"""

from __future__ import annotations

import numbers
from dataclasses import dataclass
from fractions import Fraction
from math import comb, factorial
from types import SimpleNamespace
from typing import Any, Iterator, List, Optional, Tuple

import numpy

from .errors import Error
from .hints import keywords, missing_member

# The functions that read the objects of other libraries, by the first name of their module.
_ADAPTERS = {"svgelements": "drawings.svg_contours(path)", "Part": "freecad.edge_pieces(edge)",
             "fontTools": "fonttools.Join_pen(glyph_set)", "ufoLib2": "sources.ufo_kinks(font)", "glyphsLib": "sources.glyphs_kinks(font)"}


def _fraction(x) -> Fraction:
    try:
        return Fraction(x)
    except TypeError:  # a number of NumPy
        return Fraction(*x.as_integer_ratio())
    except (ValueError, OverflowError):
        raise Error("not_finite", "array", f"the number {x}") from None


def fractions_of(numbers) -> numpy.ndarray:
    """Returns the numbers as fractions.Fraction, exactly."""
    given = numpy.asarray(numbers, dtype=object)
    return numpy.array([_fraction(x) for x in given.flat], dtype=object).reshape(given.shape)


def have_floats(*arrays) -> bool:
    """Returns whether a floating-point number is among the numbers of arrays."""
    def has(x) -> bool:
        kind = x.dtype.kind if isinstance(x, numpy.ndarray) else "O"
        if kind == "O":
            return any(isinstance(y, (float, complex, numpy.inexact)) for y in numpy.array(x, dtype=object).flat)
        return kind in "fc"

    return any(has(x) for x in arrays if x is not None)


def _coordinates(point) -> Optional[Tuple]:
    """Returns the coordinates of an object or a dict with x and y, in space with z, which may be functions, or X(), Y(), Z(); None of anything else."""
    if isinstance(point, (list, tuple, numpy.ndarray)):
        return None
    if isinstance(point, dict):
        point = SimpleNamespace(**point)
    for names in ("xyz", "XYZ"):
        if all(hasattr(point, name) for name in names[:2]):
            in_space = getattr(point, "has_z", True) and hasattr(point, names[2])  # shapely has z where there is none
            found = [getattr(point, name) for name in names[:3 if in_space else 2]]
            return tuple(c() if callable(c) else c for c in found)
    return None


def _is_complex(x) -> bool:
    return isinstance(x, (complex, numpy.complexfloating))


def points_of(points, place: Optional[str] = None):
    """Returns an array of points; that of complex numbers as points of the plane, that of objects with x and y as their coordinates,
    everything else as it is. With the name of a function it refuses two rows of coordinates, and what is no array."""
    if hasattr(points, "__next__"):  # e.g. zip(x, y)
        points = list(points)
    if isinstance(points, numpy.ndarray):
        is_complex = points.dtype.kind == "c"
    else:
        is_list = isinstance(points, (list, tuple)) and len(points) > 0
        if is_list and _coordinates(points[0]) is not None:
            return [_coordinates(p) or p for p in points]
        is_complex = is_list and not hasattr(points[0], "__len__") and any(map(_is_complex, points))
    if is_complex:
        z = numpy.asarray(points, dtype=complex)
        return numpy.stack([z.real, z.imag], axis=-1)
    if place is not None:
        if isinstance(points, str) or not (hasattr(points, "__len__") or hasattr(points, "__array__")):
            of_shapely = "; give its .coords" if hasattr(points, "coords") else ""
            raise Error("wrong_number_of_points", place, f"a {type(points).__name__} is no array of points{of_shapely}")
        refuse_rows(points, place, are_curve=False)
    return points


def refuse_rows(points, place: str, are_curve: bool = True) -> None:
    """Refuses an array of shape (2, n), n > 3, which has a row for each coordinate, and for a curve one of three indices."""
    arrays = (list, tuple, numpy.ndarray)
    is_list = isinstance(points, arrays) and len(points) > 0
    if is_list and all(isinstance(p, numbers.Real) for p in points):
        raise Error("wrong_number_of_points", place, f"{len(points)} numbers are no points: give [(x, y), ...], as numpy.column_stack([x, y]) "
                    "or numpy.reshape(numbers, (-1, 2))")
    if are_curve and is_list and isinstance(points[0], arrays) and len(points[0]) > 0 and isinstance(points[0][0], arrays):
        raise Error("wrong_number_of_points", place, "the points of a point are a patch or curves: edge_continuity(a, b) decides two patches, "
                    "chain_joins(curves) the joins of curves")
    if is_list and len(points) == 2 and numpy.ndim(points[0]) == 1 and len(points[0]) > 3:
        n = len(points[0])
        hint = f"; a line in the space of {n} coordinates is Bezier_curve(points)" if are_curve else ""
        raise Error("wrong_number_of_points", place, f"an array of shape (2, {n}) has a row for each coordinate, and not for each point: "
                    f"call {place} with points.T, of shape ({n}, 2), or numpy.transpose(points){hint}")


class Curve:
    """The base of all curves: a curve can be called with a parameter, or with an array of them, as `evaluate`."""

    points: Any

    def __call__(self, parameters):
        from ._evaluation import evaluate

        return evaluate(self, parameters)

    def __getattr__(self, name):
        missing_member(self, name)


@keywords()
@dataclass(frozen=True)
class Bezier_curve(Curve):
    """A Bezier curve, rational where it has weights."""

    points: Any  #: control points, shape (degree + 1, dimension)
    weights: Any = None  #: shape (degree + 1,), positive; None where all are equal
    domain: Tuple[Any, Any] = (Fraction(0), Fraction(1))  #: the parameters of its ends: C orders depend on its length

    def __post_init__(self):
        _take_arrays(self)
        if len(self.points) == 0:
            raise Error("wrong_number_of_points", "Bezier_curve", "no points")
        if not self.domain[0] < self.domain[1]:
            raise Error("empty_domain", "Bezier_curve", f"[{self.domain[0]}, {self.domain[1]}]")

    @property
    def degree(self) -> int:
        return len(self.points) - 1

    def reverse(self) -> Bezier_curve:
        """Returns the same curve on the same domain, run through backwards."""
        return Bezier_curve(self.points[::-1], None if self.weights is None else self.weights[::-1], self.domain)

    def osculating_curve(self, order: int = 3) -> numpy.ndarray:
        """Returns the curve of this degree on [0, 1] without weights that starts with the same derivatives up to this order, with respect
        to the parameter of the domain: what a join of at most that order knows of the curve. It consists of fractions."""
        weights = fractions_of([1] * (self.degree + 1) if self.weights is None else self.weights)
        rows = numpy.concatenate([fractions_of(self.points).T * weights, [weights]])
        length = _fraction(self.domain[1]) - _fraction(self.domain[0])
        jet: List[numpy.ndarray] = []
        factor = Fraction(1)
        for k in range(order + 1):
            jet.append(factor * rows[:, :1] if k <= self.degree else 0 * jet[0])
            factor *= (self.degree - k) / length
            rows = rows[:, 1:] - rows[:, :-1]
        jet = _quotients(jet)
        factors = [Fraction(factorial(order - k), factorial(order)) for k in range(order + 1)]
        rows = [sum(comb(j, k) * factors[k] * jet[k][:, 0] for k in range(j + 1)) for j in range(order + 1)]
        return numpy.array(rows, dtype=object)


@keywords()
@dataclass(frozen=True)
class Spline(Curve):
    """A B-spline curve, rational where it has weights, in the form of `scipy.interpolate.BSpline`."""

    degree: int
    points: Any  #: control points, shape (n, dimension)
    knots: Any  #: all with their multiplicities, n + degree + 1
    weights: Any = None  #: shape (n,), positive; None where all are equal

    def __post_init__(self):
        if not isinstance(self.degree, (int, numpy.integer)):
            raise Error("parameter_outside_domain", "Spline", "the degree comes first: call Spline(degree, points, knots)")
        _take_arrays(self)
        knots = self.knots if isinstance(self.knots, numpy.ndarray) else numpy.array(self.knots, dtype=object)
        object.__setattr__(self, "knots", knots)
        if knots.ndim != 1:
            raise Error("wrong_number_of_points", "Spline", "the knots are an array of one index, all knots with their multiplicities")
        n = len(self.points)
        if self.degree < 0 or n <= self.degree or len(knots) != n + self.degree + 1:
            raise Error("wrong_number_of_points", "Spline", f"{n} points and {len(knots)} knots; the degree {self.degree} needs "
                        f"at least {self.degree + 1} points, and {self.degree + 1} knots more than there are points")
        if (knots[1:] < knots[:-1]).any() or not knots[self.degree] < knots[n]:
            raise Error("empty_domain", "Spline", "the knots do not increase")

    @property
    def domain(self) -> Tuple[Any, Any]:
        """The parameters of the ends."""
        return self.knots[self.degree], self.knots[len(self.points)]


def _take_arrays(curve) -> None:
    points = points_of(curve.points)
    points = points if isinstance(points, numpy.ndarray) else numpy.array(points, dtype=object)
    place, weights = type(curve).__name__, curve.weights
    if points.ndim != 2 or points.shape[1] == 0:
        order = "; the order of arguments is Spline(degree, points, knots)" if isinstance(curve, Spline) else ""
        raise Error("wrong_number_of_points", place, f"an array of shape (points, dimension) is needed{order}")
    object.__setattr__(curve, "points", points)
    if weights is None:
        return
    weights = weights if isinstance(weights, numpy.ndarray) else numpy.array(weights, dtype=object)
    if weights.shape != (len(points),):
        raise Error("wrong_number_of_points", place, f"{weights.size} weights of {len(points)} points")
    if not (weights > 0).all():
        raise Error("zero_weight", place, "a weight is not positive")
    object.__setattr__(curve, "weights", weights)


@dataclass(frozen=True)
class Segmented_curve(Curve):
    """Bezier curves of one degree m, each of which starts where the one before it ends: points of shape (m k + 1, dimension) of k
    curves, and k + 1 knots. Its length, its items and its iteration are those of `segments`."""

    degree: int
    points: numpy.ndarray
    knots: numpy.ndarray

    def __len__(self) -> int:
        return len(self.segments)

    def __iter__(self) -> Iterator[numpy.ndarray]:
        return iter(self.segments)

    def __getitem__(self, number) -> numpy.ndarray:
        return self.segments[number]

    @property
    def domain(self) -> Tuple[Any, Any]:
        """The parameters of the ends."""
        return self.knots[0], self.knots[-1]

    @property
    def segments(self) -> numpy.ndarray:
        """The control points of the Bezier curves, shape (k, m + 1, dimension). A view where the array is one of floats."""
        m, (n, dimension) = self.degree, self.points.shape
        row, column = self.points.strides
        shape = ((n - 1) // m, m + 1, dimension)
        return numpy.lib.stride_tricks.as_strided(self.points, shape, (m * row, row, column), writeable=False)


def _is_tck(x) -> bool:
    """Returns whether a list is (t, c, k): knots, coefficients and the degree."""
    return len(x) == 3 and isinstance(x[2], (int, numpy.integer)) and hasattr(x[0], "__len__")


def is_array(curve) -> bool:
    """Returns whether a curve is an array of control points, as the module takes it."""
    if isinstance(curve, numpy.ndarray):
        return curve.dtype.kind != "c"
    if type(curve) not in (list, tuple) or _is_tck(curve):
        return False
    return len(curve) == 0 or (hasattr(curve[0], "__len__") and _coordinates(curve[0]) is None)


def _foreign(curve, place: str) -> Optional[List[Any]]:
    """Returns the curves of an object of another library, or None."""
    from .foreign import curves_of

    if isinstance(curve, (Curve, list, tuple, numpy.ndarray)):
        return None
    try:
        return curves_of(curve, place)
    except Error as error:
        raise Error(error.code, place, error.reason) from None


def spline_of(curve, place: str) -> Spline:
    """Returns any curve as a B-spline."""
    if isinstance(curve, Spline):
        return curve
    if isinstance(curve, Bezier_curve):
        a, b = curve.domain
        return Spline(curve.degree, curve.points, [a] * (curve.degree + 1) + [b] * (curve.degree + 1), curve.weights)
    if isinstance(curve, Segmented_curve):
        m, knots = curve.degree, curve.knots
        return Spline(m, curve.points, numpy.concatenate([knots[:1], numpy.repeat(knots, m), knots[-1:]]))
    if isinstance(curve, Curve):  # e.g. a blend
        return spline_of(Bezier_curve(curve.points), place)
    if all(hasattr(curve, name) for name in "tck"):
        return _of_scipy(curve.t, curve.c, curve.k, place)
    if all(hasattr(curve, name) for name in "cx"):
        return _of_polynomials(curve, place)
    if isinstance(curve, (list, tuple)) and _is_tck(curve):
        return _of_scipy(curve[0], numpy.transpose(curve[1]), curve[2], place)
    foreign = _foreign(curve, place)
    if foreign is not None:
        if len(foreign) != 1:
            raise Error("wrong_number_of_points", place, f"a {type(curve).__name__} of {len(foreign)} curves: give one of them; "
                        "chain_joins(path) decides the joins between them")
        return spline_of(foreign[0], place)
    points = points_of(curve)
    kind = type(curve)
    library = kind.__module__.split(".")[0]
    if library in _ADAPTERS:
        module = _ADAPTERS[library].split(".")[0]
        raise Error("wrong_number_of_points", place, f"a {kind.__name__} of {library}: call {_ADAPTERS[library]} "
                    f"of geometric_continuity.adapters.{module}, and give the curves that it returns")
    from .foreign import conversion

    call = conversion(kind.__module__)
    if call is not None:
        raise Error("wrong_number_of_points", place, f"the {kind.__name__} of {library} is none of the curves that are taken: {call}")
    if numpy.array(points, dtype=object).ndim == 0 or isinstance(points, str):
        if isinstance(points, str) and points.lstrip()[:1] in ("M", "m"):
            raise Error("wrong_number_of_points", place, "path data is no curve here: give svgpathtools.parse_path(d), or call verify(file) for a drawing")
        raise Error("wrong_number_of_points", place, f"a {kind.__name__} is no curve: give an array of control points of shape "
                    "(degree + 1, dimension), a Bezier_curve, a Spline or a BSpline of SciPy")
    refuse_rows(points, place)
    try:
        bezier = Bezier_curve(points)
    except Error as error:
        raise Error(error.code, place, error.reason) from None
    return spline_of(bezier, place)


def _of_scipy(t, c, k, place: str) -> Spline:
    c = numpy.asarray(c)
    if c.ndim != 2:
        raise Error("dimension_mismatch", place, f"the coefficients of the B-spline have the shape {c.shape}; those of a curve are points: "
                    "shape (n, dimension)")
    return Spline(int(k), c[:len(t) - int(k) - 1], numpy.asarray(t))


def _of_polynomials(curve, place: str) -> Spline:
    """Returns the curve of a PPoly of SciPy, such as a CubicSpline, whose coefficients c[m - i] are those of powers (u - x)^i, exactly; or
    of a BPoly, whose c are control points."""
    c, x = numpy.asarray(curve.c), numpy.asarray(curve.x)
    if c.ndim != 3:
        raise Error("dimension_mismatch", place, f"the coefficients of the {type(curve).__name__} have the shape {c.shape}; those of a "
                    "curve have a third index, for the dimension")
    m = len(c) - 1
    if all(kind.__name__ != "BPoly" for kind in type(curve).__mro__):
        h, powers = numpy.diff(fractions_of(x))[:, None], fractions_of(c[::-1])
        c = numpy.array([sum(powers[i] * h**i * Fraction(comb(j, i), comb(m, i)) for i in range(j + 1)) for j in range(m + 1)])
    return Spline(m, c.transpose(1, 0, 2).reshape(-1, c.shape[2]), numpy.repeat(x, m + 1))


def derivatives(spline: Spline, parameters: numpy.ndarray, order: int) -> List[numpy.ndarray]:
    """Returns the derivatives 0 to `order` at parameters of the domain, arrays of shape (dimension, parameters), by the algorithm of
    de Boor in the numbers of the arrays: with control points :math:`P_j` over the knots :math:`t` those of the derivative are
    :math:`p (P_{j+1} - P_j) / (t_{j+p+1} - t_{j+1})`. At a knot it is the curve on the right, at the end that on the left."""
    p, knots, points = spline.degree, spline.knots, spline.points.T
    if spline.weights is not None:
        points = numpy.concatenate([points * spline.weights, [spline.weights]])
    last = numpy.searchsorted(knots, knots[points.shape[1]], side="left") - 1
    span = numpy.clip(numpy.searchsorted(knots, parameters, side="right") - 1, p, last)
    rows, around = [points[:, span + j] for j in range(-p, 1)], [knots[span + j] for j in range(1 - p, p + 1)]
    jet: List[numpy.ndarray] = []
    for _ in range(order + 1):
        jet.append(_de_boor(rows, around, parameters) if rows else 0 * jet[0])
        p = len(rows) - 1
        rows = [p * (rows[j + 1] - rows[j]) / (around[p + j] - around[j]) for j in range(p)]
        around = around[1:-1]
    return jet if spline.weights is None else _quotients(jet)


def _quotients(jet: List[numpy.ndarray]) -> List[numpy.ndarray]:
    """Returns the derivatives of x / w, for those of x and, in the last row, of w."""
    result: List[numpy.ndarray] = []
    for k, x in enumerate(jet):
        numerator = x[:-1]
        for i in range(1, k + 1):
            numerator = numerator - comb(k, i) * jet[i][-1] * result[k - i]
        result.append(numerator / jet[0][-1])
    return result


def _de_boor(rows, around, u):
    p = len(rows) - 1
    for r in range(1, p + 1):
        new = []
        for j in range(p - r + 1):
            a = (u - around[r + j - 1]) / (around[p + j] - around[r + j - 1])
            new.append((1 - a) * rows[j] + a * rows[j + 1])
        rows = new
    return rows[0]


@keywords()
def pieces(curve, low=None, high=None) -> List[Bezier_curve]:
    """Returns the Bezier curves of a spline, or of its part between the parameters low and high, each with its span as domain: in
    fractions, nothing is rounded.

    Raises Error `wrong_number_of_points`, `dimension_mismatch`, `empty_domain`, `zero_weight`, `not_finite`.
    """
    spline = spline_of(curve, "pieces")
    return [_piece(spline, span, low, high) for span in _spans(spline, low, high)]


def _spans(spline: Spline, low=None, high=None) -> List[int]:
    """Returns the numbers of the knots at which a part of the curve with a length starts."""
    u = spline.knots
    p, n = spline.degree, len(spline.points)
    spans = [int(i) + p for i in numpy.flatnonzero(u[p:n] < u[p + 1:n + 1])]
    return [i for i in spans if (low is None or low < u[i + 1]) and (high is None or u[i] < high)]


def _piece(spline: Spline, span: int, low=None, high=None) -> Bezier_curve:
    p = spline.degree
    u = [_fraction(x) for x in spline.knots[span - p + 1:span + p + 1]]
    points = fractions_of(spline.points[span - p:span + 1])
    weights = fractions_of([1] * (p + 1) if spline.weights is None else spline.weights[span - p:span + 1])
    rows = [[*(w * x), w] for w, x in zip(weights, points)]
    a, b = u[p - 1] if p > 0 else _fraction(spline.knots[span]), u[p] if p > 0 else _fraction(spline.knots[span + 1])
    a, b = (a if low is None else max(a, _fraction(low))), (b if high is None else min(b, _fraction(high)))

    def blossom(arguments):
        row = rows
        for r, x in enumerate(arguments, 1):
            new = []
            for j in range(len(row) - 1):
                t = (x - u[r + j - 1]) / (u[p + j] - u[r + j - 1])
                new.append([(1 - t) * c + t * d for c, d in zip(row[j], row[j + 1])])
            row = new
        return row[0]

    bezier = [blossom([a] * (p - k) + [b] * k) for k in range(p + 1)]
    w = numpy.array([x[-1] for x in bezier], dtype=object)
    points = numpy.array([[c / x[-1] for c in x[:-1]] for x in bezier], dtype=object)
    return Bezier_curve(points, None if (w == w[0]).all() else w, (a, b))


@dataclass(frozen=True)
class Side:
    """A curve at a join, as the module takes it."""

    points: Any  #: an array of control points, whose end at the join is that of the curve
    rounded: bool = False  #: whether the curve is given with floats, and these points are fractions

    def exact(self, wish: Optional[bool]) -> Optional[bool]:
        return False if wish is None and self.rounded else wish


def side(curve, place: str, at_end: bool, order: int = 3, ignore_domain: bool = False) -> Side:
    """Returns an array with the derivatives of a curve up to the order at the end, or at the start, where a join is."""
    if is_array(curve):
        refuse_rows(curve, place)
        return Side(curve)
    foreign = _foreign(curve, place)
    if foreign is not None:
        return side(foreign[-1 if at_end else 0], place, at_end, order, ignore_domain)
    spline = spline_of(curve, place)
    rounded = have_floats(spline.points, spline.knots, spline.weights)
    piece = _piece(spline, _spans(spline)[-1 if at_end else 0])
    if piece.weights is None and (ignore_domain or piece.domain == (0, 1)):
        return Side(piece.points, rounded)
    order = max(order, 3)
    return Side(piece.reverse().osculating_curve(order)[::-1] if at_end else piece.osculating_curve(order), rounded)


def sides(left, right, place: str, order: int = 3, ignore_domain: bool = False) -> Tuple[Side, Side]:
    return side(left, place, True, order, ignore_domain), side(right, place, False, order, ignore_domain)


def bezier_points(curve, place: str) -> Any:
    """Returns the control points of what is one Bezier curve without weights; refuses everything else."""
    if is_array(curve):
        refuse_rows(curve, place)
        return curve
    spline = spline_of(curve, place)
    n = spline.degree + 1
    if len(spline.points) != n or spline.weights is not None:
        raise Error("wrong_number_of_points", place, "one Bezier curve without weights is needed; pieces(curve) has those of a spline")
    clamped = (spline.knots[:n] == spline.knots[0]).all() and (spline.knots[n:] == spline.knots[-1]).all()
    return spline.points if clamped else _piece(spline, spline.degree).points


def chain(curves, place: str) -> List:
    """Returns the curves of a chain: those of an array or of a list of curves, and the pieces of splines and paths."""
    if isinstance(curves, numpy.ndarray) and (curves.ndim == 3 or (curves.ndim == 2 and curves.dtype.kind == "c")):
        return [c for given in curves for c in _curves(points_of(given), place)]
    if isinstance(curves, (list, tuple)) and not _is_tck(curves):
        return [c for given in curves for c in _curves(given, place)]
    return _curves(curves, place)


def _curves(curve, place: str) -> List:
    if is_array(curve):
        refuse_rows(curve, place)
        return [curve]
    foreign = _foreign(curve, place)
    if foreign is not None:
        return [c for given in foreign for c in _curves(given, place)]
    return _pieces_of(curve, place)


def _pieces_of(curve, place: str) -> List[Bezier_curve]:
    spline = spline_of(curve, place)
    return [_piece(spline, span) for span in _spans(spline)]
