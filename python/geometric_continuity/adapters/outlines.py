# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Contours as lists of points, as UFO has them, and their kinks: found, and mended on the grid by moving handles only."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple

from .. import _joins
from .._native import Visual_class
from .masters import (Curves, Masters, can_agree, curvature_jump, dot, harmonised, is_smooth, longest_move, minus, smooth_handles)


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
    """Returns the Bezier curves of a segment between two on-curve points; a qcurve with implied points has several."""
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


def mend(points: List[Point], kink_angle=5, max_move: Optional[float] = None, glyph: str = "", contour: int = 0, to: str = "G1") -> List[Move]:
    """Makes the kinks of a contour exactly smooth, in place, and returns what was moved: handles of cubic curves, on the grid of whole units.
    On-curve points, lines and quadratic curves stay as they are, and so does a kink whose handle would move by more than `max_move` units
    (by default twice what it is off, plus one). With `to="G2"` the curvatures at nodes are made to agree as well, see `mend_masters()`."""
    return mend_masters([points], kink_angle, max_move, glyph, contour, to)[0]


def _mend_kinks(points: List[Point], kink_angle, max_move: Optional[float]) -> None:
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
        _set_handles([points], join, [(p, q)], [(r, s)])


@dataclass(frozen=True)
class _Master_join:
    """A join at the same points of all masters, with the handles a and b of each, and the curves beside it."""

    at: Join
    a: List[Tuple]
    b: List[Tuple]
    curves: Optional[Curves]  # None where one of them is a line
    free_a: bool  # whether the handle belongs to this node alone
    free_b: bool


def _xy(points: List[Point], index: int) -> Tuple:
    return points[index].x, points[index].y


def _exact(v: Tuple) -> Tuple:
    return tuple(int(c) if int(c) == c else Fraction(c) for c in v)


def _all_joins(masters: Sequence[List[Point]]) -> Iterator[_Master_join]:
    """Yields the joins of compatible contours on the grid, those without handles at the node."""
    found = [{(j.before, j.node, j.behind): j for j in joins(points)} for points in masters]
    for key, at in found[0].items():
        if not all(key in others for others in found) or not all(_whole(points[i]) for points in masters for i in key):
            continue
        before, node, behind = ([_exact(_xy(points, i)) for points in masters] for i in key)
        a, b = list(map(minus, node, before)), list(map(minus, behind, node))
        if any(v == (0, 0) for v in a + b):
            continue  # a handle that is retracted
        here = [others[key] for others in found]
        free_a = masters[0][at.before].type is None and all(len(j.left) == 4 and j.left[0] != j.left[1] for j in here)
        free_b = masters[0][at.behind].type is None and all(len(j.right) == 4 and j.right[2] != j.right[3] for j in here)
        curves = None
        if len(at.left) > 2 and len(at.right) > 2:
            seconds = [(minus(j.left[-1], j.left[-3]), minus(j.right[2], j.right[0])) for j in here]
            curves = Curves(len(at.left) - 1, len(at.right) - 1, [_exact(u) for u, _ in seconds], [_exact(v) for _, v in seconds])
        yield _Master_join(at, a, b, curves, free_a, free_b)


def _master_joins(masters: Sequence[List[Point]], kink_angle) -> Iterator[_Master_join]:
    """Yields those of the joins that are a corner in no master."""
    for join in _all_joins(masters):
        grades = [_joins.visual_class([minus((0, 0), u), (0, 0)], [(0, 0), v], kink_angle) for u, v in zip(join.a, join.b)]
        if all(g in (Visual_class.kink, Visual_class.g1, Visual_class.g2) for g in grades):
            yield join


def are_compatible(masters: Sequence[List[Point]]) -> bool:
    """Returns whether contours have the same numbers and types of points, so that they can be interpolated."""
    return len({tuple(p.type for p in points) for points in masters}) == 1


def kinks_between(masters: Sequence[List[Point]], kink_angle=5) -> List[int]:
    """Returns the numbers of the nodes of compatible contours at which some mixture of the masters has a kink, exactly: neither one ratio nor
    one direction of handles nor anything else keeps it smooth. Corners, also of one master, are left out."""
    return [j.at.node for j in _master_joins(masters, kink_angle) if not _is_smooth(j)]


def curvature_jumps(masters: Sequence[List[Point]], kink_angle=5) -> List[Tuple[int, float]]:
    """Returns the numbers of the nodes of compatible contours, or of a single one, where curves meet that are smooth at all mixtures of the
    masters, but not G2 at all of them, exactly, and whose curvatures have one sign at each master, so that other lengths of handles can make
    them agree; and the largest relative jump of the curvature at a master or halfway between two."""
    all_masters = Masters.independent(len(masters))
    return [(j.at.node, jump) for j in _master_joins(masters, kink_angle)
            if _can_agree(j, all_masters) and (jump := curvature_jump(j.a, j.b, j.curves, all_masters)) > 0]


def _is_smooth(join: _Master_join) -> bool:
    return is_smooth(join.a, join.b) and all(dot(u, v) > 0 for u, v in zip(join.a, join.b))


def _can_agree(join: _Master_join, masters: Masters) -> bool:
    return join.curves is not None and _is_smooth(join) and can_agree(join.a, join.b, join.curves, masters)


def _set_handles(masters: Sequence[List[Point]], join: Join, a, b) -> None:
    for points, u, v in zip(masters, a, b):
        node = points[join.node]
        for index, to in ((join.before, minus(_xy(points, join.node), u)), (join.behind, (node.x + v[0], node.y + v[1]))):
            point = points[index]
            if (point.x, point.y) != to:
                point.x, point.y = type(point.x)(to[0]), type(point.y)(to[1])


def mend_masters(masters: Sequence[List[Point]], kink_angle=5, max_move: Optional[float] = None, glyph: str = "", contour: int = 0,
                 to: str = "G1") -> List[List[Move]]:
    """Makes compatible contours, one of each master, smooth together, in place: the handles at a node get one ratio or one direction in all of
    them, so that no mixture has a kink, by the least moves on the grid of whole units (the longest first, then the sum). Returns what was
    moved in each master. A move is at most `max_move` units, by default eight times what the kink is off at a master or halfway between two,
    and one unit more. Kinks that cannot be mended together are mended in each master alone, see `mend()`.

    to: with "G2" the curvatures of both curves at a node are made to agree as well, in all masters and mixtures of them, where they have one
    sign: exactly where the grid allows it, otherwise as nearly as it does, see `curvature_jumps()` for what is left. Handles of one direction
    get other lengths, those of one ratio turn. Each moves by at most `max_move`, by default a tenth of the shortest handle at the node,
    or one unit. No move makes the jumps at the other ends of its curves larger by more than it gains. To repeat it changes nothing."""
    given = [[(p.x, p.y) for p in points] for points in masters]
    if to not in ("G1", "G2"):
        raise ValueError(f"to={to!r}: \"G1\" or \"G2\"")
    all_masters = Masters.independent(len(masters))
    for join in list(_master_joins(masters, kink_angle)) if len(masters) > 1 else ():
        if _is_smooth(join) or not (join.free_a or join.free_b):
            continue
        best = smooth_handles(join.a, join.b, all_masters, join.free_a, join.free_b)
        if best is not None and best[0] <= (longest_move(join.a, join.b, all_masters) if max_move is None else max_move):
            _set_handles(masters, join.at, *best[1:])
    for points in masters:
        _mend_kinks(points, kink_angle, max_move)
    if to == "G2":
        _harmonise(masters, kink_angle, max_move, all_masters)
    return [_moves(points, before, glyph, contour) for points, before in zip(masters, given)]


_PASSES = 16  # over the joins to be harmonised: each changes the curvatures next to it


def _harmonise(masters: Sequence[List[Point]], kink_angle, max_move: Optional[float], all_masters: Masters) -> None:
    given = [[_xy(points, i) for i in range(len(points))] for points in masters]
    nodes = [j.at.node for j in _master_joins(masters, kink_angle)]

    def current() -> Dict[int, _Master_join]:
        return {j.at.node: j for j in _all_joins(masters) if j.at.node in nodes}

    def jump(join: _Master_join) -> Optional[float]:
        return curvature_jump(join.a, join.b, join.curves, all_masters) if _can_agree(join, all_masters) else None

    state = current()
    tried: Dict[int, Tuple] = {}
    for _ in range(_PASSES):
        moved, is_new = False, not tried
        for node in nodes:
            join = state[node]
            if tried.get(node) == (join.a, join.b, join.curves) or not _can_agree(join, all_masters):
                continue
            for free in ((True, True), (True, False), (False, True)):  # a handle may be needed at its other node as it is
                free_a, free_b = free[0] and join.free_a, free[1] and join.free_b
                best = harmonised(join.a, join.b, join.curves, all_masters, free_a, free_b, max_move) if free_a or free_b else None
                if best is None:
                    continue
                _set_handles(masters, join.at, *best[2:])
                after = current()
                changed = [(jump(state[n]), jump(after[n])) for n in nodes
                           if (state[n].a, state[n].b, state[n].curves) != (after[n].a, after[n].b, after[n].curves)]
                lost = any(old is not None and (new is None or old == 0 < new) for old, new in changed)
                if not lost and sum(new or 0 for _, new in changed) < sum(old or 0 for old, _ in changed):
                    state, moved = after, True
                    break
                _set_handles(masters, join.at, join.a, join.b)
            else:
                tried[node] = join.a, join.b, join.curves
        if not moved and is_new:
            return
        if not moved:
            tried.clear()  # what is next to them may have changed
    for points, old in zip(masters, given):  # the handles find no rest
        for point, (x, y) in zip(points, old):
            point.x, point.y = x, y


def _moves(points: List[Point], before: Sequence[Tuple], glyph: str, contour: int) -> List[Move]:
    return [Move(glyph, contour, i, (int(old[0]), int(old[1])), (int(p.x), int(p.y)))
            for i, (p, old) in enumerate(zip(points, before)) if (p.x, p.y) != old]
