# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Contours as lists of points, as UFO has them, and their kinks: found, and mended on the grid by moving handles only."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Iterator, List, Optional, Sequence, Tuple

from .. import joins as _joins
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
