#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Decides whether what `blend --surfaces` writes for random pairs of surfaces is G2, or G3, with both along whole edges:
check_surface_blends.py PROGRAM [PAIRS [SEED [ORDER]]]

Nothing of the package is used. The files of .g2 are read and evaluated in fractions, and with the edge C and the derivatives T, W, X across it
    S_v = a C' + b T,   S_vv = a^2 C'' + 2 a b T' + b^2 W + c C' + d T,   b > 0,
    S_vvv = a^3 C''' + 3 a^2 b T'' + 3 a b^2 W' + b^3 X + 3 a c C'' + 3 (a d + b c) T' + 3 b d W + e C' + f T
is checked at more parameters of each span than polynomials that do not vanish can have zeros. With a coordinate of the layer of control
points that matters last changed by 1/1000 it must not hold."""

import math
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

EDGES = ["u0", "u1", "v0", "v1"]


class Surface:
    """A B-spline surface of homogeneous points."""

    def __init__(self, degrees, knots, net):  # net[i][j]
        self.degrees, self.knots, self.net = degrees, knots, net

    @staticmethod
    def read(path):
        words = iter(path.read_text().split())
        if [next(words) for _ in range(4)] != ["200", "1", "0", "0"]:
            raise ValueError("not a surface")
        dimension, rational = int(next(words)), int(next(words))
        sizes, degrees, knots = [], [], []
        for _ in range(2):
            sizes.append(int(next(words)))
            degrees.append(int(next(words)) - 1)
            knots.append([Fraction(next(words)) for _ in range(sizes[-1] + degrees[-1] + 1)])
        net = [[None] * sizes[1] for _ in range(sizes[0])]
        for j in range(sizes[1]):
            for i in range(sizes[0]):
                x = [Fraction(next(words)) for _ in range(dimension + rational)]
                net[i][j] = x if rational else x + [Fraction(1)]
        return Surface(degrees, knots, net)

    def write(self, path):
        lines = ["200 1 0 0", "3 1"]
        for n, degree, knots in zip((len(self.net), len(self.net[0])), self.degrees, self.knots):
            lines += [f"{n} {degree + 1}", " ".join(map(str, knots))]
        lines += [" ".join(map(str, self.net[i][j])) for j in range(len(self.net[0])) for i in range(len(self.net))]
        path.write_text("\n".join(lines) + "\n")

    def domain(self, direction):
        p, t = self.degrees[direction], self.knots[direction]
        return t[p], t[-1 - p]

    def turned(self, edge):
        """With the edge v = its lower or upper end, and which of them."""
        if edge[0] == "v":
            return self, edge[1] == "1"
        swapped = Surface(self.degrees[::-1], self.knots[::-1], [list(row) for row in zip(*self.net)])
        return swapped, edge[1] == "1"


def derivative(degree, knots, c):
    """Coefficients, of degree one less over the knots but the first and the last."""
    if degree == 0:
        return 0, knots, [[Fraction(0)] * len(x) for x in c]
    d = []
    for i in range(len(c) - 1):
        length = knots[i + degree + 1] - knots[i + 1]
        d.append([degree * (y - x) / length if length else Fraction(0) for x, y in zip(c[i], c[i + 1])])
    return degree - 1, knots[1:-1], d


def value(degree, knots, c, span, u):
    """At u, of the polynomial on [knots[span], knots[span + 1]]: de Boor's algorithm."""
    d = [list(c[span - degree + i]) for i in range(degree + 1)]
    for r in range(1, degree + 1):
        for i in range(degree, r - 1, -1):
            low, high = knots[span - degree + i], knots[span + 1 + i - r]
            t = (u - low) / (high - low)
            d[i] = [(1 - t) * x + t * y for x, y in zip(d[i - 1], d[i])]
    return d[degree]


def spans(degree, knots):
    return [i for i in range(degree, len(knots) - degree - 1) if knots[i] < knots[i + 1]]


def along(surface, upper, n):
    """The splines in u that are the homogeneous derivatives (k, l), k + l <= n, at the end of v."""
    splines = {}
    for l in range(n + 1):
        row = []
        for points in surface.net:
            degree, knots, c = surface.degrees[1], surface.knots[1], points
            for _ in range(l):
                degree, knots, c = derivative(degree, knots, c)
            span = spans(degree, knots)[-1 if upper else 0]
            row.append(value(degree, knots, c, span, knots[span + 1] if upper else knots[span]))
        spline = surface.degrees[0], surface.knots[0], row
        for k in range(n + 1 - l):
            splines[k, l] = spline
            spline = derivative(*spline)
    return splines


def jet(splines, u, n):
    """The derivatives (k, l), k + l <= n, in space at u."""
    homogeneous = {}
    for kl, (degree, knots, c) in splines.items():
        span = next(i for i in spans(degree, knots) if knots[i] <= u <= knots[i + 1])
        homogeneous[kl] = value(degree, knots, c, span, u)
    result = {}
    for order in range(n + 1):
        for k in range(order + 1):
            l = order - k
            x = list(homogeneous[k, l][:3])
            for i in range(k + 1):
                for j in range(l + 1):
                    if i + j > 0:
                        f = math.comb(k, i) * math.comb(l, j) * homogeneous[i, j][3]
                        x = [a - f * b for a, b in zip(x, result[k - i, l - j])]
            result[k, l] = [a / homogeneous[0, 0][3] for a in x]
    return result


def cross(x, y):
    return [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def has_order(order, given, edge, outwards, blend, upper, backwards):
    """Whether the blend continues the given surface, or the other way round, along a whole edge."""
    s, at_end = given.turned(edge)
    a, b = blend.domain(0)
    c, d = s.domain(0)
    to_given = lambda u: d - (u - a) * (d - c) / (b - a) if backwards else c + (u - a) * (d - c) / (b - a)
    breaks = {a, b} | {t for t in blend.knots[0] if a < t < b}
    for t in s.knots[0]:
        if c < t < d:
            breaks.add(b - (t - c) * (b - a) / (d - c) if backwards else a + (t - c) * (b - a) / (d - c))
    breaks = sorted(breaks)
    # the numerators have at most this degree: each derivative of order k is of degree (k + 1) times
    # that along the edge, over weights
    number = (12 if order == 2 else 36) * (blend.degrees[0] + s.degrees[0]) + 1
    sign = 1 if at_end == outwards else -1
    given_splines, blend_splines = along(s, at_end, order), along(blend, upper, order)
    for low, high in zip(breaks, breaks[1:]):
        for i in range(1, number + 1):
            u = low + (high - low) * Fraction(i, number + 1)
            x, y = jet(given_splines, to_given(u), order), jet(blend_splines, u, order)
            if x[0, 0] != y[0, 0]:
                return False
            g = {(k, l): [sign**l * z for z in x[k, l]] for k, l in x}
            n = cross(g[1, 0], g[0, 1])
            square = dot(n, n)

            def coordinates(z, terms=()):
                """Of what the terms leave of z, in C' and T, or nothing."""
                z = [e - sum(factor * g[kl][i] for factor, kl in terms) for i, e in enumerate(z)]
                if dot(z, n) != 0:
                    return None
                return dot(cross(z, g[0, 1]), n) / square, dot(cross(g[1, 0], z), n) / square

            first = coordinates(y[0, 1]) if square != 0 else None
            if first is None or first[1] <= 0:
                return False
            alpha, beta = first
            second = coordinates(y[0, 2], [(alpha**2, (2, 0)), (2 * alpha * beta, (1, 1)), (beta**2, (0, 2))])
            if second is None:
                return False
            if order == 2:
                continue
            alpha2, delta = second
            terms = [(alpha**3, (3, 0)), (3 * alpha**2 * beta, (2, 1)), (3 * alpha * beta**2, (1, 2)), (beta**3, (0, 3))]
            terms += [(3 * alpha * alpha2, (2, 0)), (3 * (alpha * delta + alpha2 * beta), (1, 1)), (3 * beta * delta, (0, 2))]
            if coordinates(y[0, 3], terms) is None:
                return False
    return True


def random_surface(shift):
    degrees = [random.randint(1, 3), random.randint(1, 3)]
    knots = []
    for p in degrees:
        a = Fraction(random.randint(-9, 9), random.randint(1, 9))
        length = Fraction(random.randint(1, 9), random.randint(1, 9))
        inner = [a + length * Fraction(random.randint(1, 8), 9)] if p == 3 and random.random() < 0.5 else []
        knots.append([a] * (p + 1) + inner + [a + length] * (p + 1))
    number = lambda: Fraction(random.randint(-(10**9), 10**9), 4 * 10**9)
    rational = random.random() < 0.5
    sizes = [len(t) - p - 1 for t, p in zip(knots, degrees)]
    net = []
    for i in range(sizes[0]):
        net.append([])
        for j in range(sizes[1]):
            w = Fraction(random.randint(100, 110), 100) if rational else Fraction(1)
            net[i].append([w * (3 * i + number()), w * (3 * j + shift + number()), w * number(), w])
    return Surface(degrees, knots, net)


def corners(surface, edge):
    s, upper = surface.turned(edge)
    return [jet(along(s, upper, 0), u, 0)[0, 0] for u in s.domain(0)]


def main():
    program, pairs = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    random.seed(int(sys.argv[3]) if len(sys.argv) > 3 else 2026)
    order = int(sys.argv[4]) if len(sys.argv) > 4 else 2
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        a_file, b_file, blend_file = (Path(folder) / name for name in ("a.g2", "b.g2", "blend.g2"))
        for pair in range(pairs):
            a, b = random_surface(0), random_surface(25)
            a.write(a_file)
            b.write(b_file)
            edges = random.choice(EDGES), random.choice(EDGES)
            command = [program, "blend", "--surfaces", a_file, b_file, "--edges", ",".join(edges), "--order", str(order)]
            subprocess.run(command + ["-o", blend_file], check=True, stdout=subprocess.DEVNULL)
            s = Surface.read(blend_file)
            # how the second edge runs, from its ends
            backwards = jet(along(s, True, 0), s.domain(0)[0], 0)[0, 0] != corners(b, edges[1])[0]
            layers = len(s.net[0])

            def verdicts():
                at_a = has_order(order, a, edges[0], True, s, False, False)
                return [at_a, has_order(order, b, edges[1], False, s, True, backwards)]

            good = verdicts() == [True, True]
            for layer, expected in ((order, [False, True]), (layers - 1 - order, [True, False])):
                s.net[1][layer][2] += Fraction(1, 1000)
                good = good and verdicts() == expected
                s.net[1][layer][2] -= Fraction(1, 1000)
            if not good:
                failed += 1
                print(f"pair {pair}, edges {edges}: wrong")
    print(f"{pairs} pairs, {failed} wrong")
    return 1 if failed else 0


sys.exit(main())
