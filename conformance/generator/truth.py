# SPDX-License-Identifier: CC0-1.0
"""The true orders and sizes of a join, from exact derivatives on both sides. The numbers are fractions; enclosures are decimals of 25 digits,
rounded outward."""

from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal, getcontext
from fractions import Fraction as F
from math import factorial, isqrt

getcontext().prec = 80
DIGITS = 25
# Angles may be computed with this relative error: the 80 digits give far less.
MARGIN = Decimal(10) ** -50


def exact(text):
    """The number that a text or an integer says."""
    if isinstance(text, (int, F)):
        return F(text)
    return F(text) if "/" in text else F(Decimal(text))


def is_decimal(q):
    """It has finitely many digits."""
    d = q.denominator
    for p in (2, 5):
        while d % p == 0:
            d //= p
    return d == 1


def text(q):
    """The decimal that is exactly q, or the fraction."""
    if not is_decimal(q):
        return f"{q.numerator}/{q.denominator}"
    d = Context(prec=2000).divide(Decimal(q.numerator), Decimal(q.denominator))
    digits = d.as_tuple().digits
    plain = f"{d:f}"
    if len(plain) <= 24:
        return plain.rstrip("0").rstrip(".") if "." in plain else plain
    e = d.adjusted()
    sign, rest = ("-" if d < 0 else ""), "".join(map(str, digits)).rstrip("0")
    return f"{sign}{rest[0]}{'.' + rest[1:] if rest[1:] else ''}e{e}"


def rounded(q, mode):
    d = Context(prec=DIGITS, rounding=mode).divide(Decimal(q.numerator), Decimal(q.denominator))
    return text(F(d))


def enclosure(low, high=None):
    """Two decimals, the largest below and the smallest above."""
    return [rounded(low, ROUND_FLOOR), rounded(low if high is None else high, ROUND_CEILING)]


def root_bounds(q):
    """Fractions around the square root."""
    shift = 10 ** (2 * max(0, 60 + (len(str(q.denominator)) - len(str(q.numerator))) // 2))
    n = q.numerator * shift // q.denominator
    r = isqrt(n)
    scale = isqrt(shift)
    if r * r * q.denominator == q.numerator * shift:
        return F(r, scale), F(r, scale)
    return F(r, scale), F(r + 1, scale)


def root(q):
    return enclosure(*root_bounds(q))


def decimal(q):
    return Decimal(q.numerator) / Decimal(q.denominator)


def arctangent(x):
    """For x >= 0, by halving the angle and the power series."""
    halvings = 0
    while x > Decimal("0.05"):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    total, power, n = Decimal(0), x, 1
    while power and abs(power) > abs(total) * Decimal(10) ** -75:
        total += power / n * (1 if n % 4 == 1 else -1)
        power *= x * x
        n += 2
    return total * 2**halvings


PI = 4 * (4 * arctangent(Decimal(1) / 5) - arctangent(Decimal(1) / 239))


def angle(sine_squared, cosine_sign, cosine_squared):
    """In radians, as a Decimal, of a vector with these components, up to a common factor."""
    if sine_squared == 0:
        return Decimal(0) if cosine_sign > 0 else PI
    if cosine_squared == 0:
        return PI / 2
    a = arctangent((decimal(sine_squared) / decimal(cosine_squared)).sqrt())
    return a if cosine_sign > 0 else PI - a


def degrees(u, v):
    """An enclosure of the angle of two vectors."""
    d, uu, vv = dot(u, v), dot(u, u), dot(v, v)
    sine = uu * vv - d * d
    if sine == 0 or d == 0:
        return enclosure(F(90) if d == 0 else F(0) if d > 0 else F(180))
    if sine == d * d:
        return enclosure(F(45 if d > 0 else 135))
    a = angle(sine, 1 if d > 0 else -1, d * d) * 180 / PI
    return enclosure(F(a * (1 - MARGIN)), F(a * (1 + MARGIN)))


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def plus(u, v, k=1):
    return [a + k * b for a, b in zip(u, v)]


def times(k, u):
    return [k * a for a in u]


def across(u, v):
    """The square of the length of the product of two vectors."""
    return dot(u, u) * dot(v, v) - dot(u, v) ** 2


def determinant(u, v, w):
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]))


# ---- Polynomials, lists of coefficients.
def multiply(a, b):
    result = [F(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def add(a, b):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else 0) + (b[i] if i < len(b) else 0) for i in range(n)]


def shifted(a, t):
    """The coefficients at t."""
    result = []
    for k in range(len(a)):
        result.append(sum(a[i] * F(factorial(i), factorial(k) * factorial(i - k)) * t ** (i - k) for i in range(k, len(a))))
    return result


def basis(knots, degree, span, i):
    """The B-spline i as a polynomial on [knots[span], knots[span + 1]], by the recursion of Cox and de Boor."""
    if degree == 0:
        return [F(1 if i == span else 0)]
    result = [F(0)]
    for j, rising in ((i, True), (i + 1, False)):
        width = knots[j + degree] - knots[j]
        if width:
            factor = [-knots[j] / width, 1 / width] if rising else [knots[j + degree] / width, -1 / width]
            result = add(result, multiply(factor, basis(knots, degree - 1, span, j)))
    return result


class Curve:
    """A spline. Without knots, a Bezier curve on [0, 1]. In `weights` are those of rational curves; points are not multiplied."""

    def __init__(self, points, knots=None, weights=None, degree=None):
        if isinstance(points, str):
            points = [p.split(",") for p in points.split()]
        self.points = [[exact(x) for x in p] for p in points]
        self.degree = degree or len(points) - 1
        n = self.degree + 1
        if isinstance(knots, str):
            knots = knots.split()
        self.knots = [exact(t) for t in knots] if knots else [F(0)] * n + [F(1)] * n
        if isinstance(weights, str):
            weights = weights.split()
        self.weights = [exact(w) for w in weights] if weights else None
        assert len(self.knots) == len(self.points) + n, (self.points, self.knots)
        self.is_bezier = len(self.points) == n and not knots
        self.cache = {}

    def keys(self):
        """Returns what tells it from other curves, and what tells its reverse."""
        key = tuple(map(tuple, self.points))
        return key, key[::-1]

    def reversed(self):
        knots = [self.knots[0] + self.knots[-1] - t for t in self.knots[::-1]]
        return Curve(self.points[::-1], knots, self.weights and self.weights[::-1], self.degree)

    def spans(self):
        p = self.degree
        return [k for k in range(p, len(self.knots) - p - 1) if self.knots[k] < self.knots[k + 1]]

    def polynomials(self, span):
        """The homogeneous coordinates on a span."""
        if span not in self.cache:
            p, n = self.degree, len(self.points[0])
            w = self.weights or [F(1)] * len(self.points)
            result = [[F(0)] for _ in range(n + 1)]
            for i in range(span - p, span + 1):
                b = basis(self.knots, p, span, i)
                for c in range(n + 1):
                    factor = w[i] * (self.points[i][c] if c < n else 1)
                    result[c] = add(result[c], [factor * x for x in b])
            self.cache[span] = result
        return self.cache[span]

    def jet(self, span, at_end, order=3):
        t = self.knots[span + 1] if at_end else self.knots[span]
        series = [shifted(a, t) for a in self.polynomials(span)]
        series = [a + [F(0)] * (order + 1 - len(a)) for a in series]
        quotients = []
        for a in series[:-1]:
            q = []
            for k in range(order + 1):
                q.append((a[k] - sum(series[-1][j] * q[k - j] for j in range(1, k + 1))) / series[-1][0])
            quotients.append(q)
        return [[q[k] * factorial(k) for q in quotients] for k in range(order + 1)]

    def is_straight(self, span):
        """A line that runs in one direction, as editors write it with a handle in its node."""
        a = [shifted(q, self.knots[span])[1:] for q in self.polynomials(span)[:-1]]
        if self.weights:
            return False
        rows = [[q[k] if k < len(q) else F(0) for q in a] for k in range(max(map(len, a)))]
        first = next((r for r in rows if any(r)), None)
        if first is None or any(across(first, r) for r in rows):
            return False
        h = self.knots[span + 1] - self.knots[span]
        pieces = [self.jet(span, False, 5), self.jet(span, True, 5)]
        chord = plus(pieces[1][0], pieces[0][0], -1)
        # The derivative along the chord has no sign change if its Bernstein coefficients have none.
        d = [dot(r, chord) * h**k * (k + 1) for k, r in enumerate(rows)]
        n = len(d) - 1
        b = [sum(d[k] * F(factorial(j), factorial(k) * factorial(j - k)) / F(factorial(n), factorial(k) * factorial(n - k)) for k in range(j + 1))
             for j in range(n + 1)]
        return any(chord) and all(x >= 0 for x in b)


class Join:
    """The truth about two jets: the left one ends, the right one starts."""

    def __init__(self, x, y, straight=(False, False)):
        self.x, self.y = x, y
        n = len(x[0])
        self.gap_squared = dot(plus(y[0], x[0], -1), plus(y[0], x[0], -1))
        self.c = next((k - 1 for k in range(4) if x[k] != y[k]), 3)
        self.u, self.v = self.tangent(x, True), self.tangent(y, False)
        self.infinite = False
        self.stops = not any(x[1]) or not any(y[1])
        jets = []
        for jet, direction, is_straight in ((x, self.u, straight[0]), (y, self.v, straight[1])):
            if any(jet[1]):
                jets.append(jet)
            elif is_straight:
                jets.append([jet[0], direction, [F(0)] * n, [F(0)] * n])
            else:
                assert any(across(direction, d) for d in jet[2:]), "a stop whose curvature is not infinite"
                self.infinite = True
        self.betas, self.f = [], 0
        if self.infinite:
            self.traced = 1 if self.c >= 0 and across(self.u, self.v) == 0 and dot(self.u, self.v) > 0 else min(self.c, 0)
            self.curvatures = self.torsions = None
            self.f = self.traced
        else:
            self.decide(*jets)
        # The orders of the parametrisation as it is: none where a derivative vanishes.
        self.g = -1 if self.c < 0 else 0 if self.stops else self.traced

    @staticmethod
    def tangent(jet, at_end):
        for k in range(1, len(jet)):
            if any(jet[k]):
                return times(F(-1 if at_end and k % 2 == 0 else 1), jet[k])
        raise AssertionError("a curve that does not move")

    def decide(self, x, y):
        n = len(x[0])
        g = dot(x[1], x[1])
        self.traced = 0
        betas = []
        for k in (1, 2, 3):
            if k == 1:
                rest = y[1]
            elif k == 2:
                rest = plus(y[2], x[2], -betas[0] ** 2)
            else:
                rest = plus(plus(y[3], x[3], -betas[0] ** 3), x[2], -3 * betas[0] * betas[1])
            b = dot(rest, x[1]) / g
            if any(plus(rest, x[1], -b)) or (k == 1 and b <= 0):
                break
            betas.append(b)
            self.traced = k
        curvature = lambda d: times(1 / dot(d[1], d[1]), plus(d[2], d[1], -dot(d[2], d[1]) / dot(d[1], d[1])))
        self.curvatures = curvature(x), curvature(y)
        self.torsions = None
        if n == 3 and any(self.curvatures[0]) and any(self.curvatures[1]):
            self.torsions = [determinant(*d[1:4]) / across(d[1], d[2]) for d in (x, y)]
        self.f = min(self.traced, 2)
        if self.traced >= 2:
            if n == 2:
                self.f = 2
            else:
                # X''' may be met up to a combination of X' and X''.
                r = plus(y[3], x[3], -betas[0] ** 3)
                e = plus(x[2], x[1], -dot(x[2], x[1]) / g)
                r = plus(r, x[1], -dot(r, x[1]) / g)
                if any(e):
                    r = plus(r, e, -dot(r, e) / dot(e, e))
                self.f = 3 if not any(r) else 2
        if self.c < 0:
            self.traced, self.f = -1, -1
        self.betas = betas if self.c >= 0 and not self.stops else []

    def derivative_jumps(self):
        """The lengths by which the derivatives differ, from that of order 0 on."""
        return [root(dot(d, d)) for d in (plus(b, a, -1) for a, b in zip(self.x, self.y))]

    # Squares of sizes.
    def jump_squared(self):
        if self.curvatures is None:
            return None
        d = plus(*self.curvatures, -1)
        return dot(d, d)

    def relative_squared(self):
        if self.curvatures is None:
            return None
        most = max(dot(k, k) for k in self.curvatures)
        return self.jump_squared() / most if most else F(0)

    def measures(self):
        jump, relative = self.jump_squared(), self.relative_squared()
        return {"gap": root(self.gap_squared), "angle_degrees": degrees(self.u, self.v),
                "curvature_jump": None if jump is None else root(jump),
                "curvature_percent": None if relative is None else root(relative * 10000),
                "torsion_jump": enclosure(abs(self.torsions[0] - self.torsions[1])) if self.torsions else None}


def ladder(measures, within):
    """The order within tolerances, from enclosures: what has no tolerance must be 0. None if a tolerance lies inside an enclosure."""
    steps = [("gap",), ("angle_degrees", "angle_radians"), ("curvature_percent", "curvature_jump")]
    for order, names in enumerate(steps):
        name = next((n for n in names if n in within), names[0])
        value = measures.get(name)
        if value is None:
            return order - 1 if order else None
        low, high, tolerance = exact(value[0]), exact(value[1]), exact(within.get(name, "0"))
        if low > tolerance:
            return order - 1
        if high > tolerance:
            return None
    return 2


def name(order):
    return "gap" if order < 0 else f"G{order}"
