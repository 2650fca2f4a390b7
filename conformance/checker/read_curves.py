# SPDX-License-Identifier: CC0-1.0
"""Reads chains of curves: control points in JSON, .g2, paths of SVG, curves of STEP."""

import json
from fractions import Fraction as F

import part21
import svg
from joins import need, number, spline_sides


def bezier_knots(degree):
    return [F(0)] * (degree + 1) + [F(1)] * (degree + 1)


def read_json(data):
    content = json.loads(data)
    chain = []
    for c in content["curves"]:
        points = [[number(x) for x in p] for p in c["points"]]
        knots = [number(t) for t in c["knots"]] if "knots" in c else bezier_knots(c["degree"])
        chain += spline_sides(c["degree"], knots, points, [number(w) for w in c["weights"]] if "weights" in c else None)
    return [(chain, content.get("closed", False))]


def read_g2(data):
    words = data.decode().split()
    at, chain = 0, []
    while at < len(words):
        need(words[at : at + 4] == ["100", "1", "0", "0"], "the class is not 100")
        n, rational, count, order = map(int, words[at + 4 : at + 8])
        at += 8
        knots = [number(t) for t in words[at : at + count + order]]
        at += count + order
        points, weights = [], [] if rational else None
        for _ in range(count):
            row = [number(x) for x in words[at : at + n + rational]]
            at += n + rational
            if rational:
                weights.append(row[-1])
                row = [x / row[-1] for x in row[:-1]]
            points.append(row)
        chain += spline_sides(order - 1, knots, points, weights)
    return [(chain, False)]


def read_step(data):
    model = part21.Model(data)
    curves = [model.spline_curve(c) for c in model.all("GEOMETRIC_CURVE_SET")[0][1]]
    is_plane = all(p[2] == 0 for c in curves for p in c[2])
    chain = []
    for degree, knots, points, weights in curves:
        chain += spline_sides(degree, knots, [p[:2] for p in points] if is_plane else points, weights)
    return [(chain, False)]


def read_chains(extension, data):
    """Lists of sides, each with a mark whether it is closed."""
    return {"json": read_json, "g2": read_g2, "step": read_step, "svg": svg.read}[extension](data)
