# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Contours as lists of points, as UFO has them, and their kinks: found, and mended on the grid by moving handles only."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Iterator, List, Optional, Sequence, Tuple

from .. import _joins
from .._native import Visual_class


@dataclass
class Point:
    """A point of a contour. `type` is "move", "line", "curve", "qcurve", or None off the curve."""

    x: Any  #: a number: int, float, Fraction, ...
    y: Any
    type: Optional[str]


@dataclass(frozen=True)
class Join:
    """A join of two segments at an on-curve point."""

    node: int  #: the number of the point in its contour
    before: int  #: the number of the control point before it
    behind: int  #: the number of the control point behind it
    left: Sequence  #: the Bezier curve that ends there
    right: Sequence  #: the Bezier curve that starts there

    def grade(self, kink_angle=5) -> Optional[Visual_class]:
        return _joins.visual_class(self.left, self.right, kink_angle)


@dataclass(frozen=True)
class Kink:
    """A kink of a glyph. `point` are the coordinates of the node; `angle` in radians and `handle_offset` are upper bounds."""

    glyph: str
    contour: int
    node: int
    point: Tuple
    angle: float
    handle_offset: float


@dataclass(frozen=True)
class Move:
    """A control point that was moved."""

    glyph: str
    contour: int
    index: int
    before: Tuple[int, int]
    after: Tuple[int, int]


def _beziers(points: List[Point], start: int, inner: List[int], end: int) -> List[List[Tuple]]:
    """The Bezier curves of a segment between two on-curve points; of a qcurve with implied points several."""
    xy: List[Tuple] = [(points[i].x, points[i].y) for i in [start] + inner + [end]]
    if points[end].type != "qcurve" or len(inner) < 2:
        return [xy]
    curves: List[List[Tuple]] = []
    first = xy[0]
    for a, b in zip(inner, inner[1:] + [None]):
        handle = (points[a].x, points[a].y)
        if b is None:
            last = xy[-1]
        else:
            last = tuple((Fraction(p) + Fraction(q)) / 2 for p, q in ((points[a].x, points[b].x), (points[a].y, points[b].y)))
        curves.append([first, handle, last])
        first = last
    return curves


def joins(points: List[Point]) -> Iterator[Join]:
    """Yields the joins of a contour at its on-curve points. Segments of no length are passed over: they have no direction."""
    on = [i for i, p in enumerate(points) if p.type is not None]
    if not on:
        return
    closed = points[0].type != "move"
    n = len(points)
    segments = []
    for k, start in enumerate(on):
        if k + 1 == len(on) and not closed:
            break
        end = on[(k + 1) % len(on)]
        inner = [i % n for i in range(start + 1, end if end > start else end + n)]
        curves = _beziers(points, start, inner, end)
        if any(p != curves[0][0] for c in curves for p in c):
            segments.append((start, inner, end, curves))
    for k, (start, inner, end, curves) in enumerate(segments):
        if k + 1 == len(segments) and not closed:
            break
        following = segments[(k + 1) % len(segments)]
        yield Join(end, inner[-1] if inner else start, following[1][0] if following[1] else following[2], curves[-1], following[3][0])


def kinks(points: List[Point], kink_angle=5, glyph: str = "", contour: int = 0) -> List[Kink]:
    """Returns the kinks of a contour: joins with an angle of at most `kink_angle` degrees that are not smooth, exactly."""
    found = []
    for join in joins(points):
        if join.grade(kink_angle) == Visual_class.kink:
            size = _joins.kink_size(join.left, join.right)
            assert size is not None  # what has a grade has a size
            node = points[join.node]
            found.append(Kink(glyph, contour, join.node, (node.x, node.y), size.angle.upper, size.handle_offset.upper))
    return found


def _whole(point: Point) -> bool:
    return int(point.x) == point.x and int(point.y) == point.y


def mend(points: List[Point], kink_angle=5, max_move: Optional[float] = None, glyph: str = "", contour: int = 0) -> List[Move]:
    """Makes the kinks of a contour exactly smooth, in place, and returns what was moved: handles of cubic curves, on the grid of whole units.
    On-curve points, lines and quadratic curves stay as they are, and so does a kink whose handle would move by more than `max_move` units
    (by default twice what it is off, plus one)."""
    moves = []
    for join in list(joins(points)):
        node, before, behind = points[join.node], points[join.before], points[join.behind]
        if not (_whole(node) and _whole(before) and _whole(behind)):
            continue
        if (before.x, before.y) == (node.x, node.y) or (behind.x, behind.y) == (node.x, node.y):
            continue  # a handle that is retracted
        curves = ([(before.x, before.y), (node.x, node.y)], [(node.x, node.y), (behind.x, behind.y)])
        if _joins.visual_class(*curves, kink_angle) != Visual_class.kink:
            continue
        a = (int(node.x - before.x), int(node.y - before.y))
        b = (int(behind.x - node.x), int(behind.y - node.y))
        size = _joins.kink_size(*curves)
        assert size is not None
        bound = 2 * size.handle_offset.upper + 1 if max_move is None else max_move
        movable = [p.type is None and len(c) == 4 for p, c in ((before, join.left), (behind, join.right))]
        if all(movable):
            handles = _joins.align_handles(a, b, int(bound * bound))
        elif movable[0]:
            handles = (_joins.align_handle(a, b), b)
        elif movable[1]:
            handles = (a, _joins.align_handle(b, a))
        else:
            handles = None
        if handles is None:
            continue
        (p, q), (r, s) = handles
        if max((p - a[0]) ** 2 + (q - a[1]) ** 2, (r - b[0]) ** 2 + (s - b[1]) ** 2) > bound * bound:
            continue
        for index, point, x, y in ((join.before, before, node.x - p, node.y - q), (join.behind, behind, node.x + r, node.y + s)):
            if (point.x, point.y) != (x, y):
                moves.append(Move(glyph, contour, index, (int(point.x), int(point.y)), (int(x), int(y))))
                point.x, point.y = type(point.x)(x), type(point.y)(y)
    return moves


# Masters: the handles of a mixture of masters are the same mixtures of theirs, a = sum c_i a_i and
# b = sum c_i b_i. Their cross product vanishes for all c exactly if a_i x b_j + a_j x b_i = 0 for
# all i, j. So it does where b_i = k a_i for all i (one ratio), and where all handles are multiples
# of one vector (one direction).

_Vector = Tuple[int, int]
_Pair = Tuple[List[_Vector], List[_Vector]]
_LARGEST = 16  # numerator, denominator and coordinate of ratios and directions


def _cross(a: _Vector, b: _Vector) -> int:
    return a[0] * b[1] - a[1] * b[0]


def _dot(a: _Vector, b: _Vector) -> int:
    return a[0] * b[0] + a[1] * b[1]


def _nearest(p: int, q: int) -> int:
    return (2 * p + q) // (2 * q)


def _are_smooth_together(a: List[_Vector], b: List[_Vector]) -> bool:
    n = range(len(a))
    return all(_cross(a[i], b[j]) + _cross(a[j], b[i]) == 0 for i in n for j in n if i <= j) and all(_dot(u, v) > 0 for u, v in zip(a, b))


def _by_ratio(a: List[_Vector], b: List[_Vector], p: int, q: int) -> _Pair:
    """Handles q t and p t with the whole vectors t nearest to both."""
    t = [tuple(_nearest(q * u[c] + p * v[c], p * p + q * q) for c in (0, 1)) for u, v in zip(a, b)]
    return [(q * x, q * y) for x, y in t], [(p * x, p * y) for x, y in t]


def _along(handles: List[_Vector], e: _Vector) -> List[_Vector]:
    steps = [_nearest(_dot(v, e), _dot(e, e)) for v in handles]
    return [(k * e[0], k * e[1]) for k in steps]


def _primitive(v: _Vector) -> _Vector:
    divisor = math.gcd(*v)
    return v[0] // divisor, v[1] // divisor


def _pairs(a: List[_Vector], b: List[_Vector], both: bool) -> Iterator[_Pair]:
    """Handles in the place of these that may be smooth together; only those of b move unless both do."""
    ratios = [math.hypot(*v) / math.hypot(*u) for u, v in zip(a, b)]
    if not both:
        divisor = math.gcd(*(c for v in a for c in v))
        for p in range(max(1, math.floor(min(ratios) * divisor)), math.ceil(max(ratios) * divisor) + 1):
            yield a, [(p * x // divisor, p * y // divisor) for x, y in a]
        if all(_cross(a[0], v) == 0 for v in a):
            yield a, _along(b, _primitive(a[0]))
        return
    fractions = {Fraction(p, q) for p in range(1, _LARGEST + 1) for q in range(1, _LARGEST + 1)}
    for f in sorted(fractions | {Fraction(r).limit_denominator(_LARGEST) for r in ratios}):
        if f > 0 and min(ratios) / 1.5 <= f <= max(ratios) * 1.5:
            yield _by_ratio(a, b, f.numerator, f.denominator)
    directions = set()
    for u, v in zip(a, b):
        x, y = u[0] + v[0], u[1] + v[1]
        largest = max(abs(x), abs(y))
        if largest:
            directions |= {_primitive((_nearest(x * n, largest), _nearest(y * n, largest))) for n in range(1, _LARGEST + 1)}
    for e in sorted(directions):
        yield _along(a, e), _along(b, e)


@dataclass(frozen=True)
class _Master_join:
    """A join at the same points of all masters, with the handles a and b of each."""

    at: Join
    a: List[_Vector]
    b: List[_Vector]


def _master_joins(masters: Sequence[List[Point]], kink_angle) -> Iterator[_Master_join]:
    """Yields the joins of compatible contours that are a corner in none of them, on the grid."""
    found = [{(j.before, j.node, j.behind): j for j in joins(points)} for points in masters]
    for key, at in found[0].items():
        if not all(key in others for others in found) or not all(_whole(points[i]) for points in masters for i in key):
            continue
        before, node, behind = ([(int(points[i].x), int(points[i].y)) for points in masters] for i in key)
        a = [(n[0] - p[0], n[1] - p[1]) for n, p in zip(node, before)]
        b = [(p[0] - n[0], p[1] - n[1]) for n, p in zip(node, behind)]
        if any(v == (0, 0) for v in a + b):
            continue  # a handle that is retracted
        grades = [_joins.visual_class([p, n], [n, q], kink_angle) for p, n, q in zip(before, node, behind)]
        if all(g in (Visual_class.kink, Visual_class.g1, Visual_class.g2) for g in grades):
            yield _Master_join(at, a, b)


def are_compatible(masters: Sequence[List[Point]]) -> bool:
    """Returns whether contours have the same numbers and types of points, so that they can be interpolated."""
    return len({tuple(p.type for p in points) for points in masters}) == 1


def kinks_between(masters: Sequence[List[Point]], kink_angle=5) -> List[int]:
    """Returns the numbers of the nodes of compatible contours at which some mixture of the masters has a kink, exactly: neither one ratio nor
    one direction of handles nor anything else keeps it smooth. Corners, also of one master, are left out."""
    return [j.at.node for j in _master_joins(masters, kink_angle) if not _are_smooth_together(j.a, j.b)]


def mend_masters(masters: Sequence[List[Point]], kink_angle=5, max_move: Optional[float] = None, glyph: str = "", contour: int = 0
                 ) -> List[List[Move]]:
    """Makes compatible contours, one of each master, smooth together, in place: the handles at a node get one ratio or one direction in all of
    them, so that no mixture has a kink, by the least moves on the grid of whole units (the longest first, then the sum). Returns what was
    moved in each master. A move is at most `max_move` units, by default eight times what the kink is off at a master or halfway between two,
    and one unit more. Kinks that cannot be mended together are mended in each master alone, see `mend()`."""
    moves: List[List[Move]] = [[] for _ in masters]
    for join in list(_master_joins(masters, kink_angle)):
        a, b = join.a, join.b
        if _are_smooth_together(a, b):
            continue
        first = masters[0]
        free_a = first[join.at.before].type is None and len(join.at.left) == 4
        free_b = first[join.at.behind].type is None and len(join.at.right) == 4
        if not free_a and not free_b:
            continue
        sides = (a, b) if free_b else (b, a)
        best = None
        for x, y in _pairs(*sides, free_a and free_b):
            if not _are_smooth_together(x, y):
                continue
            shifts = [math.dist(u, v) for old, new in zip(sides, (x, y)) for u, v in zip(old, new)]
            cost = max(shifts), sum(shifts)
            if best is None or cost < best[0]:
                best = cost, x, y
        if best is None or best[0][0] > (_longest_move(a, b) if max_move is None else max_move):
            continue
        (_, x, y) = best
        x, y = (x, y) if free_b else (y, x)
        for points, moved, u, v in zip(masters, moves, x, y):
            node = points[join.at.node]
            for index, to in ((join.at.before, (int(node.x) - u[0], int(node.y) - u[1])), (join.at.behind, (int(node.x) + v[0], int(node.y) + v[1]))):
                point = points[index]
                if (point.x, point.y) != to:
                    moved.append(Move(glyph, contour, index, (int(point.x), int(point.y)), to))
                    point.x, point.y = type(point.x)(to[0]), type(point.y)(to[1])
    for points, moved in zip(masters, moves):
        moved += mend(points, kink_angle, max_move, glyph, contour)
    return moves


def _longest_move(a: List[_Vector], b: List[_Vector]) -> float:
    halves = [[(u[0] + v[0], u[1] + v[1]) for u in side for v in side] for side in (a, b)]  # twice the handles halfway between two
    lengths = [(abs(_cross(u, v)), min(math.hypot(*u), math.hypot(*v))) for u, v in zip(*halves)]
    return 1 + 8 * max((off / least / 2 for off, least in lengths if least > 0), default=0.0)
