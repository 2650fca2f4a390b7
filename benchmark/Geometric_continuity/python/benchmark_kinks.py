# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Kinks of fonts, by the pen for fontTools, which decides them exactly, and by checks as they are written with floats: a pen of fontTools that compares
angles, and one call of NumPy for all joins; both within a tolerance in degrees, because with floats there is no other way. Usage:
benchmark_kinks.py FONT..., in an environment with the module. A kink is an angle of at most 5 degrees that is not zero, at on-curve points."""

import math
import sys
import time

import numpy
from fontTools.ttLib import TTFont

import geometric_continuity as gc
from geometric_continuity.adapters.fonttools import Join_pen

LARGEST = 5


def directions(join):
    """The legs at a join: to the node and from it, from the nearest control points that differ from it."""
    node = join.left[-1]
    before = next(p for p in reversed(join.left) if tuple(p) != tuple(node))
    behind = next(p for p in join.right if tuple(p) != tuple(node))
    return [float(x) for x in (node[0] - before[0], node[1] - before[1], behind[0] - node[0], behind[1] - node[1])]


def by_angles(joins, tolerance):
    found = set()
    for place, join in joins:
        a, b, c, d = directions(join)
        angle = abs(math.degrees(math.atan2(b, a) - math.atan2(d, c))) % 360
        if tolerance < min(angle, 360 - angle) <= LARGEST:
            found.add(place)
    return found


def by_numpy(joins, tolerance):
    a, b, c, d = numpy.array([directions(join) for _, join in joins]).T
    angle = numpy.degrees(abs(numpy.arctan2(a * d - b * c, a * c + b * d)))
    return {joins[i][0] for i in numpy.flatnonzero((tolerance < angle) & (angle <= LARGEST))}


def exactly(joins):
    return {place for place, join in joins if join.grade(LARGEST) == gc.Visual_class.kink}


def timed(function, *arguments):
    best, result = math.inf, None
    for _ in range(3):
        begin = time.perf_counter()
        result = function(*arguments)
        best = min(best, time.perf_counter() - begin)
    return best, result


def main():
    print("| font | joins | check | kinks | missed | wrong | microseconds a join |")
    print("| :--- | ----: | :---- | ----: | -----: | ----: | ------------------: |")
    for path in sys.argv[1:]:
        glyphs = TTFont(path).getGlyphSet()
        joins = []
        for name in glyphs.keys():
            pen = Join_pen(glyphs, name)
            glyphs[name].draw(pen)
            joins += [((name, number, join.node), join) for number, join in pen.joins()]
        kinks = exactly(joins)
        checks = [("decided exactly", exactly, ())]
        for tolerance in (1e-9, 0.1, 1):
            checks += [(f"angles, tolerance {tolerance:g}", by_angles, (tolerance,)), (f"NumPy, tolerance {tolerance:g}", by_numpy, (tolerance,))]
        font = path.rsplit("/", 1)[-1]
        for name, check, more in checks:
            seconds, found = timed(check, joins, *more)
            print(f"| {font} | {len(joins)} | {name} | {len(found)} | {len(kinks - found)} | {len(found - kinks)} | {seconds / len(joins) * 1e6:.2f} |")


if __name__ == "__main__":
    main()
