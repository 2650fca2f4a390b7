# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The Bezier curves of B-splines with and without weights, in fractions: nothing is rounded. What adapters of libraries with splines share."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import comb
from typing import List, Optional, Sequence, Tuple

import numpy

from .. import joins as _joins
from .._native import Join_continuity


@dataclass(frozen=True)
class Piece:
    """A Bezier curve, rational where it has weights."""

    points: numpy.ndarray  #: control points, shape (degree + 1, dimension), of fractions.Fraction
    weights: Optional[numpy.ndarray] = None  #: shape (degree + 1,), of fractions.Fraction; None where all are equal
    domain: Tuple[Fraction, Fraction] = (Fraction(0), Fraction(1))  #: the parameters of its ends: C orders depend on its length

    def reverse(self) -> Piece:
        """Returns the same curve on the same domain, run through backwards."""
        return Piece(self.points[::-1], None if self.weights is None else self.weights[::-1], self.domain)

    def osculating_cubic(self) -> numpy.ndarray:
        """Returns the cubic curve on [0, 1] without weights that starts with the same derivatives up to order 3, with respect to the
        parameter of the domain: what a join of at most that order knows of the curve."""
        weights = [Fraction(1)] * len(self.points) if self.weights is None else list(self.weights)
        rows = [[w * x for x in p] + [w] for p, w in zip(self.points.tolist(), weights)]
        derivatives: List[List[Fraction]] = []
        jet: List[List[Fraction]] = []
        factor = 1
        for k in range(4):
            derivatives.append([factor * x for x in rows[0]] if rows else [Fraction(0)] * (self.points.shape[1] + 1))
            factor *= max(len(self.points) - 1 - k, 0)
            rows = [[b - a for a, b in zip(p, q)] for p, q in zip(rows, rows[1:])]
            *x, _ = derivatives[k]
            for i in range(1, k + 1):
                x = [a - comb(k, i) * derivatives[i][-1] * b for a, b in zip(x, jet[k - i])]
            jet.append([a / derivatives[0][-1] for a in x])
        length = self.domain[1] - self.domain[0]
        jet = [[x / length**k for x in row] for k, row in enumerate(jet)]
        return numpy.array([[sum((comb(j, k) * d / (1, 3, 6, 6)[k] for k, d in enumerate(c)), Fraction(0)) for c in zip(*jet)] for j in range(4)],
                           dtype=object)


def pieces(degree: int, knots: Sequence, points: Sequence, weights: Optional[Sequence] = None, low=None, high=None) -> List[Piece]:
    """Returns the Bezier curves of a B-spline, or of its part between the parameters low and high, each with its span as domain.

    knots: all with their multiplicities, as many as points plus degree + 1.
    points: an array of shape (n, dimension); weights: n positive numbers.
    """
    u = [Fraction(k) for k in knots]
    given = [Fraction(1)] * len(points) if weights is None else [Fraction(w) for w in weights]
    homogeneous = [[w * Fraction(x) for x in p] + [w] for p, w in zip(points, given)]
    start = u[degree] if low is None else Fraction(low)
    end = u[len(points)] if high is None else Fraction(high)

    def blossom(span, arguments):
        row = homogeneous[span - degree:span + 1]
        for r, x in enumerate(arguments, 1):
            new = []
            for j in range(len(row) - 1):
                a, b = u[span - degree + r + j], u[span + 1 + j]
                t = (x - a) / (b - a)
                new.append([(1 - t) * p + t * q for p, q in zip(row[j], row[j + 1])])
            row = new
        return row[0]

    result = []
    for span in range(degree, len(points)):
        a, b = max(u[span], start), min(u[span + 1], end)
        if not a < b:
            continue
        row = [blossom(span, [a] * (degree - k) + [b] * k) for k in range(degree + 1)]
        w = numpy.array([p[-1] for p in row], dtype=object)
        result.append(Piece(numpy.array([[x / p[-1] for x in p[:-1]] for p in row], dtype=object), None if (w == w[0]).all() else w, (a, b)))
    return result


def continuity(left: Piece, right: Piece) -> Join_continuity:
    """Decides the continuity of the join between the end of `left` and the start of `right`, up to order 3, exactly, with weights too."""
    return _joins.continuity(left.reverse().osculating_cubic()[::-1], right.osculating_cubic())
