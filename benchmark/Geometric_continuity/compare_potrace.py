#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Outlines of a bitmap, by potrace and by `fit`: compare_potrace.py PROGRAM [SIZE]

The bitmap shows a shape whose outline is known: a smooth curve, or a rectangle with a half circle, whose corners and tangents are true
features. potrace reads the bitmap, `fit` the middles of the edges between its black and white pixels. Prints for each how many curves it
takes, how far these are from the true outline (in pixels, at many points), how many joins are kinks or corners, as `verify` decides
exactly, and how long the process takes."""

import json
import math
import os
import re
import resource
import subprocess
import sys
import tempfile


def wave(t):
    a = 2 * math.pi * t
    r = 0.3 + 0.07 * math.cos(3 * a) + 0.02 * math.sin(7 * a)
    return 0.5 + r * math.cos(a), 0.5 + r * math.sin(a)


def arch(t):
    """A rectangle from (.2, .2) to (.8, .5) below a half circle, counterclockwise from the left lower corner."""
    sides = [0.6, 0.3, 0.3 * math.pi, 0.3]
    s = t * sum(sides)
    if s < sides[0]:
        return 0.2 + s, 0.2
    s -= sides[0]
    if s < sides[1]:
        return 0.8, 0.2 + s
    s -= sides[1]
    if s < sides[2]:
        return 0.5 + 0.3 * math.cos(s / 0.3), 0.5 + 0.3 * math.sin(s / 0.3)
    return 0.2, 0.5 - (s - sides[2])


def bitmap(polygon, size):
    """Rows from the lowest one up: whether the middle of a pixel is inside of the polygon."""
    rows = []
    for j in range(size):
        y, crossings = j + 0.5, []
        for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
            if (y0 <= y) != (y1 <= y):
                crossings.append(x0 + (y - y0) / (y1 - y0) * (x1 - x0))
        crossings.sort()
        row = bytearray(size)
        for a, b in zip(crossings[::2], crossings[1::2]):
            for i in range(max(0, math.ceil(a - 0.5)), min(size, math.ceil(b - 0.5))):
                row[i] = 1
        rows.append(row)
    return rows


def outline(rows, size):
    """The middles of the edges between black and white, once around counterclockwise."""
    black = lambda i, j: 0 <= i < size and 0 <= j < size and rows[j][i]
    j = next(j for j in range(size) if any(rows[j]))
    start = (rows[j].index(1), j, 1, 0)  # along the lower edge of the lowest pixel, black on the left
    x, y, dx, dy = start
    points = []
    while True:
        points.append((x + dx / 2, y + dy / 2))
        x, y = x + dx, y + dy
        left = black(x + (dx - dy - 1) // 2, y + (dy + dx - 1) // 2)
        right = black(x + (dx + dy - 1) // 2, y + (dy - dx - 1) // 2)
        if right:
            dx, dy = dy, -dx
        elif not left:
            dx, dy = -dy, dx
        if (x, y, dx, dy) == start:
            return points


def run(*arguments):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(arguments, capture_output=True, encoding="utf-8")
    return done, 1000 * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)


def curves_of_g2(file):
    words, curves = open(file).read().split(), []
    number = lambda w: float(w) if "/" not in w else int(w.split("/")[0]) / int(w.split("/")[1])
    while words:
        n, degree = int(words[6]), int(words[7]) - 1
        x = [number(w) for w in words[8 + n + degree + 1 : 8 + n + degree + 1 + 2 * n]]
        curves.append([(x[2 * i], x[2 * i + 1]) for i in range(n)])
        words = words[8 + n + degree + 1 + 2 * n :]
    return curves


def curves_of_svg(text):
    """The curves of potrace's paths: relative commands m, c, l and z, in tenths of a pixel, from the lower left corner."""
    curves = []
    for data in re.findall(r' d="([^"]*)"', text):
        x = y = 0
        for letter, numbers in re.findall(r"([MmcCLlz])([^MmcCLlz]*)", data):
            v = [float(n) for n in numbers.replace(",", " ").split()]
            if letter in "Mm":
                x, y = (v[0], v[1]) if letter == "M" else (x + v[0], y + v[1])
                v, letter = v[2:], "L" if letter == "M" else "l"
            step = 6 if letter in "cC" else 2
            for k in range(0, len(v), step):
                p = [(x, y)] + [(v[k + i] + x * letter.islower(), v[k + i + 1] + y * letter.islower()) for i in range(0, step, 2)]
                curves.append([(a / 10, b / 10) for a, b in p])
                x, y = p[-1]
    return curves


def point(b, t):
    while len(b) > 1:
        b = [((1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]) for p, q in zip(b, b[1:])]
    return b[0]


def distance(curves, polygon):
    """The largest distance of points of the curves from the polygon, whose vertices are dense."""
    cells = {}
    for p in polygon:
        cells.setdefault((int(p[0]) // 4, int(p[1]) // 4), []).append(p)
    worst = 0
    for b in curves:
        for k in range(20):
            x, y = point(b, k / 20)
            i, j = int(x) // 4, int(y) // 4
            near = [p for a in (i - 1, i, i + 1) for c in (j - 1, j, j + 1) for p in cells.get((a, c), [])]
            worst = max(worst, min((math.hypot(x - p[0], y - p[1]) for p in near), default=math.inf))
    return worst


def grades(program, *arguments):
    report = json.loads(run(program, "verify", *arguments, "--json")[0].stdout)
    return report["joins"]


def compare(program, name, shape, size, folder):
    polygon = [(size * x, size * y) for x, y in (shape(k / 40000) for k in range(40000))]
    rows = bitmap(polygon[::20], size)
    pbm, svg, txt, g2 = (os.path.join(folder, "outline." + e) for e in ("pbm", "svg", "txt", "g2"))
    with open(pbm, "w") as f:
        f.write("P1 %d %d\n" % (size, size))
        f.writelines("".join(map(str, row)) + "\n" for row in reversed(rows))
    with open(txt, "w") as f:
        f.writelines("%r %r\n" % p for p in outline(rows, size))
    print("%s, %d x %d pixels" % (name, size, size))
    line = "  %-28s %4d curves, within %.2f pixels, %3d kinks, %d corners, %5.0f ms"
    milliseconds = run("potrace", "-s", pbm, "-o", svg)[1]
    curves = curves_of_svg(open(svg).read())
    joins = [j["grade"] for j in grades(program, svg)]
    print(line % ("potrace", len(curves), distance(curves, polygon), joins.count("kink"), joins.count("corner"), milliseconds))
    for order in ("G1", "G2"):
        done, milliseconds = run(program, "fit", txt, "--closed", "--tolerance", "1", "--order", order, "-o", g2)
        if done.returncode != 0:
            sys.exit(done.stderr)
        curves = curves_of_g2(g2)
        broken = sum(j["g_order"] < int(order[1]) for j in grades(program, g2, "--closed"))
        corners = int(re.search(r"(\d+) corner", done.stdout).group(1))
        print(line % ("fit, %s joins" % order, len(curves), distance(curves, polygon), broken - corners, corners, milliseconds))


def main():
    program, size = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    with tempfile.TemporaryDirectory() as folder:
        compare(program, "a smooth curve", wave, size, folder)
        compare(program, "a rectangle with a half circle", arch, size, folder)


if __name__ == "__main__":
    main()
