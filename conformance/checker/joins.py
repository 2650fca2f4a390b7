# SPDX-License-Identifier: CC0-1.0
"""Decides joins of curves by forms without division, and verifies what a record says of them."""

from decimal import Decimal
from fractions import Fraction as F
from math import comb, isqrt


class Wrong(Exception):
    """A record does not hold."""


def need(condition, reason):
    if not condition:
        raise Wrong(reason)


def number(word):
    """Decimals and fractions, exactly."""
    word = str(word)
    return F(word) if "/" in word else F(Decimal(word))


def inner(u, v):
    total = F(0)
    for i in range(len(u)):
        total += u[i] * v[i]
    return total


def combine(*terms):
    """The sum of (factor, vector)."""
    (k, first), *rest = terms
    total = [k * x for x in first]
    for k, v in rest:
        total = [total[i] + k * v[i] for i in range(len(first))]
    return total


def is_zero(v):
    return all(x == 0 for x in v)


# ---- Verified enclosures.
SCALE = 10**120


def fixed_root(q):
    """Integers around SCALE times the root of q."""
    n = q.numerator * SCALE * SCALE // q.denominator
    return isqrt(n), isqrt(n) + 1


def fixed_pi():
    """By the formula of Gauss; the error is less than 100 units."""
    def cotangent(n):
        total, power, k = 0, SCALE // n, 1
        while power:
            total += (power // k) * (1 if k % 4 == 1 else -1)
            power //= n * n
            k += 2
        return total
    return 4 * (12 * cotangent(18) + 8 * cotangent(57) - 5 * cotangent(239))


PI = fixed_pi()


def fixed_sine_cosine(degrees):
    """SCALE times sine and cosine of 0 <= degrees <= 180; the error is less than SCALE / 10^100."""
    if degrees > 90:
        s, c = fixed_sine_cosine(180 - degrees)
        return s, -c
    if degrees > 45:
        s, c = fixed_sine_cosine(90 - degrees)
        return c, s
    x = degrees.numerator * PI // (180 * degrees.denominator)
    result = []
    for first, k in ((x, 1), (SCALE, 0)):
        total = 0
        while first:
            total += first
            first = -first * x // SCALE * x // SCALE // ((k + 1) * (k + 2))
            if abs(first) < 2:
                break
            k += 2
        result.append(total)
    return tuple(result)


EXACT_ANGLES = {0: lambda s, c: s == 0 and c > 0, 180: lambda s, c: s == 0 and c < 0, 90: lambda s, c: c == 0, 45: lambda s, c: s == c * c and c > 0,
                135: lambda s, c: s == c * c and c < 0}


def need_tight(pair, what):
    low, high = map(number, pair)
    need(0 <= low <= high and (high - low) * 10**22 <= high, f"the enclosure of the {what} is wide")
    return low, high


def need_angle(pair, u, v):
    low, high = need_tight(pair, "angle")
    c = inner(u, v)
    square = inner(u, u) * inner(v, v) - c * c
    scale = max(abs(c), F(isqrt(int(square)) or 0), max(map(abs, u)) * max(map(abs, v)))
    square, c = square / scale**2, c / scale
    if low == high or any(test(square, c) for test in EXACT_ANGLES.values()):
        need(low == high and low in EXACT_ANGLES and EXACT_ANGLES[int(low)](square, c), f"the angle is not {pair[0]}")
        return
    below, above = fixed_root(square)
    slack = SCALE // 10**60
    fixed = c.numerator * SCALE // c.denominator
    s, t = fixed_sine_cosine(low)
    need(max(below * t, above * t) - fixed * s >= -slack * SCALE, f"the angle is less than {pair[0]}")
    s, t = fixed_sine_cosine(high)
    need(min(below * t, above * t) - fixed * s <= slack * SCALE, f"the angle is more than {pair[1]}")


def need_square(pair, square, what):
    low, high = need_tight(pair, what)
    need(low * low <= square <= high * high, f"the {what} is not within {pair}")


# ---- The orders of two sets of derivatives.
def c_order(x, y):
    order = -1
    while order < 3 and x[order + 1] == y[order + 1]:
        order += 1
    return order


def g_order(x, y):
    """With the shape parameters, where the points agree and no first derivative is 0."""
    g, a = inner(x[1], x[1]), inner(x[1], y[1])
    if combine((g, y[1]), (-a, x[1])) != [0] * len(x[0]) or a <= 0:
        return 0, []
    v = combine((g * g, y[2]), (-a * a, x[2]))
    b = inner(v, x[1])
    if not is_zero(combine((g, v), (-b, x[1]))):
        return 1, [a / g]
    w = combine((g**4, y[3]), (-(a**3) * g, x[3]), (-3 * a * b, x[2]))
    c = inner(w, x[1])
    if not is_zero(combine((g, w), (-c, x[1]))):
        return 2, [a / g, b / g**3]
    return 3, [a / g, b / g**3, c / g**5]


def f_order(x, y, g):
    """Frenet's frame: the third derivative may be off within the plane of the first two."""
    if g < 2 or len(x[0]) == 2:
        return min(g, 2)
    beta = inner(x[1], y[1]) / inner(x[1], x[1])
    rest = combine((1, y[3]), (-(beta**3), x[3]))
    rows = [x[1], x[2], rest]
    n = len(rest)
    if n != 3:
        raise Wrong("not in space")
    if is_zero(cross(x[1], x[2])):
        return 3 if is_zero(cross(x[1], rest)) else 2
    return 3 if inner(cross(rows[0], rows[1]), rest) == 0 else 2


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def curvature(d):
    g = inner(d[1], d[1])
    return combine((1 / g, d[2]), (-inner(d[1], d[2]) / (g * g), d[1]))


def torsion(d):
    normal = cross(d[1], d[2])
    return inner(normal, d[3]) / inner(normal, normal)


class Side:
    """One end of a curve, at a join."""

    def __init__(self, jet, at_end, chord):
        self.jet = jet
        self.stops = is_zero(jet[1])
        first = next(k for k in (1, 2, 3) if not is_zero(jet[k]))
        self.direction = [-x for x in jet[first]] if at_end and first == 2 else jet[first]
        self.traced = jet
        if self.stops:
            zero = [F(0)] * len(jet[0])
            self.traced = [jet[0], chord, zero, zero] if chord else None


class Decided:
    def __init__(self, left, right):
        x, y = left.jet, right.jet
        self.c = c_order(x, y)
        self.stops = left.stops or right.stops
        self.left, self.right = left, right
        self.gap = inner(combine((1, y[0]), (-1, x[0])), combine((1, y[0]), (-1, x[0])))
        self.betas, self.k, self.t = [], None, None
        if left.traced and right.traced:
            g, betas = g_order(left.traced, right.traced)
            f = f_order(left.traced, right.traced, g)
            self.k = curvature(left.traced), curvature(right.traced)
            if len(x[0]) == 3 and not is_zero(self.k[0]) and not is_zero(self.k[1]):
                self.t = torsion(left.traced), torsion(right.traced)
        else:
            u, v = left.direction, right.direction
            g = f = 1 if inner(u, v) > 0 and inner(u, v) ** 2 == inner(u, u) * inner(v, v) else 0
            betas = []
        self.g, self.f = (g, f) if self.c >= 0 else (-1, -1)
        self.betas = betas if self.c >= 0 and not self.stops else []

    def jump(self):
        d = combine((1, self.k[0]), (-1, self.k[1]))
        return inner(d, d)

    def relative(self):
        most = max(inner(k, k) for k in self.k)
        return self.jump() / most * 10000 if most else F(0)


def verify_measures(record, join):
    need_square(record["gap"], join.gap, "gap")
    need_angle(record["angle_degrees"], join.left.direction, join.right.direction)
    for name, value in (("curvature_jump", Decided.jump), ("curvature_percent", Decided.relative)):
        need((record[name] is None) == (join.k is None), f"{name} is not defined")
        if join.k:
            need_square(record[name], value(join), name)
    need(len(record.get("derivative_jumps", [])) == (4 if record["up_to"][0] == "C" else 0), "another number of derivatives")
    for k, pair in enumerate(record.get("derivative_jumps", [])):
        d = combine((1, join.right.jet[k]), (-1, join.left.jet[k]))
        need_square(pair, inner(d, d), f"jump of derivative {k}")
    need((record["torsion_jump"] is None) == (join.t is None), "torsion_jump is not defined")
    if join.t:
        low, high = need_tight(record["torsion_jump"], "jump of torsion")
        need(low <= abs(join.t[0] - join.t[1]) <= high, "the jump of torsion is another one")


def verify_any(record, candidates):
    """Checks the sizes in a record, which are those of one of several joins of the worst order."""
    problem = None
    for join in candidates:
        try:
            return verify_measures(record, join)
        except Wrong as error:
            problem = problem or error
    raise problem


def order_within(record, gap, angle, curvature_percent):
    """From enclosures that have been verified."""
    for level, (key, value) in enumerate((("gap", gap), ("angle_degrees", angle), ("curvature_percent", curvature_percent))):
        tolerance = number(record["within"].get(key, "0"))
        if value is None or number(value[0]) > tolerance:
            return "gap" if level == 0 else f"G{level - 1}"
        need(number(value[1]) <= tolerance, f"the tolerance of {key} lies inside of the enclosure")
    return "G2"


def decide_all(chain, closed):
    sides = chain
    pairs = list(zip(sides, sides[1:])) + ([(sides[-1], sides[0])] if closed else [])
    return [Decided(a[1], b[0]) for a, b in pairs]


def check(record, extension, chains):
    """`chains` are lists of curves (start, end), each with a mark whether it is closed."""
    decided = [j for chain, closed in chains for j in decide_all(chain, closed or (extension in ("g2", "step") and record.get("closed", False)))]
    need(decided, "no join")
    letter, most = record["up_to"][0], int(record["up_to"][1])
    key = {"C": lambda j: j.c, "G": lambda j: j.g, "F": lambda j: j.f}[letter]
    join = min(decided, key=key)
    exact = extension in ("json", "g2") or record["subject"] != "curve"
    if "within" in record:
        need(len(decided) == 1, "one join was expected")
        verify_measures(record, join)
        reached = order_within(record, record["gap"], record["angle_degrees"], record["curvature_percent"])
        need(record["order"] == reached, f"the order within the tolerance is {reached}")
    else:
        k = min(key(join), most)
        reached = "gap" if k < 0 else ("F3" if k == 3 and letter == "F" else f"C{k}" if letter == "C" else f"G{k}")
        need(record["order"] == reached, f"the order is {reached}")
    if exact or not record.get("stops"):
        need((record["g_order"], record["f_order"]) == (join.g, join.f), f"G{join.g} F{join.f} hold")
    is_drawn = record["subject"] != "curve"
    if extension == "json" or is_drawn:
        need(record.get("closed", False) == any(closed for _, closed in chains), "it is closed, or not")
    if is_drawn:
        need("c_order" not in record and "betas" not in record, "what is drawn has no parameters")
        need(record.get("stops", False) in [j.stops for j in decided if key(j) == key(join)], "a first derivative is 0")
    if extension in ("json", "g2"):
        need(record["c_order"] == join.c, f"C{join.c} holds")
        need([number(b) for b in record["betas"]] == join.betas, f"the shape parameters are {join.betas}")
        need(record.get("stops", False) == join.stops, "a first derivative is 0")
    if "within" not in record and (is_drawn or extension != "svg" or not join.stops):
        verify_any(record, [j for j in decided if key(j) == key(join)])
    verify_flip(record)


STEPS = (("gap",), ("angle_degrees", "angle_radians", "slope_jump"), ("curvature_percent", "curvature_jump", "second_jump"), ("torsion_jump",))


def verify_flip(record):
    """The tolerance named must be the quantity that decides, and none where none does."""
    flip, order, up_to = record["flips"], record["order"], record["up_to"]
    level, most = -1 if order == "gap" else int(order[1]), int(up_to[1])
    need(level <= most, "the order is higher than what is asked for")
    within = record.get("within")
    # The sizes that decide are those of the next order, if that was asked for.
    names = () if level >= min(most, 2 if within else 3) or up_to[0] == "C" else STEPS[level + 1]
    if within and not names:
        # All hold: the one that is nearest to its bound.
        parts = {k: number(record[k][1]) / number(t) for k, t in within.items() if number(t) and record.get(k)}
        need(flip is not None or not parts, "a tolerance flips the answer")
        if flip:
            need(flip["at"] == record.get(flip["tolerance"]) and flip["tolerance"] in within, "what flips the answer is another number")
            need(not parts or parts.get(flip["tolerance"], 0) == max(parts.values()), "another tolerance is nearer to its bound")
        return
    sizes = [n for n in names if record.get(n) and (not within or n in within or n == names[0]) and (within or number(record[n][1]) > 0)]
    if not sizes:
        need(flip is None, "no tolerance flips the answer")
        return
    need(flip is not None and flip["tolerance"] == next((n for n in sizes if n in (within or sizes)), sizes[0]), "another tolerance flips the answer")
    need(flip["at"] == record[flip["tolerance"]], "what flips the answer is another number")


# ---- Curves: control points of a span, to derivatives at both of its ends.
def local_derivatives(points, knots, degree, t):
    """Returns the derivatives on the span between knots[degree - 1] and knots[degree]: `knots` are the 2 * degree that it depends on."""
    result = []
    p, d, around = degree, points, knots
    for _ in range(4):
        result.append(evaluate(d, around, p, t) if p >= 0 else [F(0)] * len(points[0]))
        if p <= 0:
            p = -1
            continue
        d = [combine((p / (around[j + p] - around[j]), d[j + 1]), (-p / (around[j + p] - around[j]), d[j])) for j in range(p)]
        around = around[1:-1]
        p -= 1
    return result


def evaluate(d, knots, p, t):
    d = list(d)
    for r in range(p):
        q = p - r
        for j in range(q):
            a, b = knots[j + r], knots[j + p]
            d[j] = combine(((b - t) / (b - a), d[j]), ((t - a) / (b - a), d[j + 1]))
    return d[0]


def without_weight(jet):
    """The quotient rule for (w x, w)."""
    result = []
    for k, row in enumerate(jet):
        terms = [(1, row[:-1])] + [(-comb(k, j) * jet[j][-1], result[k - j]) for j in range(1, k + 1)]
        result.append([v / jet[0][-1] for v in combine(*terms)])
    return result


def spline_sides(degree, knots, points, weights):
    """Each span as a pair of sides."""
    w = weights or [F(1)] * len(points)
    homogeneous = [[x * w[i] for x in p] + [w[i]] for i, p in enumerate(points)]
    result = []
    for k in range(degree, len(knots) - degree - 1):
        a, b = knots[k], knots[k + 1]
        if a == b:
            continue
        d, around = homogeneous[k - degree : k + 1], knots[k - degree + 1 : k + degree + 1]
        jets = [without_weight(local_derivatives(d, around, degree, t)) for t in (a, b)]
        chord = None
        if not weights and (is_zero(jets[0][1]) or is_zero(jets[1][1])):
            chord = straight_chord([p[:-1] for p in d], degree)
        result.append((Side(jets[0], False, chord), Side(jets[1], True, chord)))
    return result


def straight_chord(points, degree):
    """The chord, if the control points of a Bezier curve run along a line in one direction."""
    chord = combine((1, points[-1]), (-1, points[0]))
    steps = [combine((1, b), (-1, a)) for a, b in zip(points, points[1:])]
    for s in steps:
        if inner(s, s) * inner(chord, chord) != inner(s, chord) ** 2 or inner(s, chord) < 0:
            return None
    return None if is_zero(chord) else chord
