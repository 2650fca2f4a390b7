# SPDX-License-Identifier: CC0-1.0
"""SciPy: the derivatives of PPoly.from_spline(BSpline) on both sides of each knot."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import numpy  # noqa: E402
from answers import Unsupported, decide_chain, serve  # noqa: E402
from scipy.interpolate import BSpline, PPoly  # noqa: E402


def derivatives(degree, knots, points, weights):
    if weights:
        raise Unsupported("rational curves")
    inner = knots[degree : len(knots) - degree]
    if any(inner.count(t) > degree for t in inner[1:-1] if inner[0] < t < inner[-1]):
        raise Unsupported("knots as often as the order")
    axes = [PPoly.from_spline(BSpline(numpy.array(knots), numpy.array(points)[:, k], degree)) for k in range(len(points[0]))]
    rows = [[p.derivative(k) if k else p for p in axes] for k in range(4)]
    breaks = axes[0].x
    for i in range(len(breaks) - 1):
        a, b = breaks[i], breaks[i + 1]
        if inner[0] <= a < b <= inner[-1]:
            # The polynomial of this interval, at both of its ends.
            yield [[[float(PPoly(p.c[:, i : i + 1], p.x[i : i + 2])(t)) for p in row] for row in rows] for t in (a, b)]


serve(lambda file, order, within: decide_chain(derivatives, file, order, within))
