# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Handles of several masters at one node: smooth at every mixture of the masters, on the grid of whole units. Plain Python without other
modules, since the script that writes fonts consists of this text and its own.

Each handle is a list of shares, a(w) = sum s_i(w) a_i: of the masters of sources, or of the default and the regions of a variable font.
With a(w) from the handle before the node to the node and b(w) from there to the next one, a x b vanishes at all w exactly if
a_i x b_j + a_j x b_i = 0 for all i, j. So it does where b_i = k a_i for all i (one ratio), and where all are multiples of one vector e
(one direction).

With u(w) from the control point before the left handle to the node, v(w) from the node to the one behind the right handle, and curves of
the degrees l and r, the curvatures are (l-1)/l u x a / |a|^3 and (r-1)/r b x v / |b|^3. With one ratio k they agree at all w exactly if
a x s does vanish, s = (l-1) r k^2 u + (r-1) l v; with one direction, a = m e and b = n e, if (l-1) r (u x e) n^2 = (r-1) l (e x v) m^2,
both as identities in the shares."""

import math
from collections import namedtuple
from fractions import Fraction
from functools import reduce
from itertools import combinations_with_replacement, permutations

LARGEST = 16  # numerator, denominator and coordinate of ratios and directions
STEPS = 3  # so far from the lengths that would make curvatures agree others are tried


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def times(k, a):
    return k * a[0], k * a[1]


def length(a):
    return math.hypot(float(a[0]), float(a[1]))


def exact(x):
    """Returns the number as an integer, or as a fraction where it is none."""
    return int(x) if int(x) == x else Fraction(x)


def nearest(x):
    return x if isinstance(x, int) else math.floor(Fraction(x) + Fraction(1, 2))


def primitive(a):
    divisor = math.gcd(int(a[0]), int(a[1]))
    return int(a[0]) // divisor, int(a[1]) // divisor


def sign(x):
    return (x > 0) - (x < 0)


class Masters:
    """The scalars of the shares at the masters."""

    def __init__(self, scalars):
        self.scalars = [[exact(s) for s in row] for row in scalars]
        self._counting = [[(i, s) for i, s in enumerate(row) if s != 0] for row in self.scalars]
        self.order = []  # in which no share counts at the masters before its own
        left = list(range(len(scalars)))
        while left:
            free = [r for r in left if scalars[r][r] == 1 and not any(scalars[r][t] for t in left if t != r)]
            if not free:
                break
            self.order += free[:1]
            left.remove(free[0])

    @classmethod
    def independent(cls, n):
        """Returns masters that are their own shares."""
        return cls([[int(i == k) for k in range(n)] for i in range(n)])

    def has_order(self):
        return len(self.order) == len(self.scalars)

    def at(self, shares):
        """Returns the vectors at the masters."""
        return [tuple(sum(s * shares[i][c] for i, s in row) for c in (0, 1)) for row in self._counting]

    def shares(self, wanted, snap):
        """Returns the shares, each the whole vector which snap() finds, that lead as near as they can to what is wanted at the masters."""
        found = [(0, 0)] * len(self.scalars)
        for r in self.order:
            found[r] = snap(tuple(wanted[r][c] - sum(s * found[i][c] for i, s in self._counting[r]) for c in (0, 1)))
        return found


def is_smooth(a, b):
    """Returns whether the cross product vanishes at all mixtures."""
    n = range(len(a))
    return all(cross(a[i], b[j]) + cross(a[j], b[i]) == 0 for i in n for j in n if i <= j)


def _runs_on(a, b, masters):
    return all(dot(u, v) > 0 for u, v in zip(masters.at(a), masters.at(b)))


def by_ratio(a, b, masters, p, q, both):
    """Returns handles q t and p t with the shares t nearest to both; where only the right one moves, p a / q. None where that is not on the grid."""
    if not both:
        if any((p * c) % q for v in a for c in v):
            return None
        return a, [(p * x // q, p * y // q) for x, y in a]
    # the larger one counts more
    wanted = [tuple(Fraction(q * u[c] + p * v[c]) / (p * p + q * q) for c in (0, 1)) for u, v in zip(masters.at(a), masters.at(b))]
    t = masters.shares(wanted, lambda rest: (nearest(rest[0]), nearest(rest[1])))
    return [times(q, v) for v in t], [times(p, v) for v in t]


def by_direction(a, b, masters, e, both):
    """Returns handles that are multiples of e; where only the right one moves, if the left one has that direction."""

    def along(handle):
        return masters.shares(masters.at(handle), lambda rest: times(nearest(Fraction(dot(rest, e)) / dot(e, e)), e))

    if not both and any(cross(v, e) for v in a):
        return None
    return (along(a) if both else a), along(b)


def _fractions(low, high, *given):
    """Returns short fractions in a range around these numbers."""
    found = {Fraction(p, q) for p in range(1, LARGEST + 1) for q in range(1, LARGEST + 1)}
    found |= {Fraction(x).limit_denominator(LARGEST) for x in given}
    return sorted(f for f in found if f > 0 and low / 1.5 <= f <= high * 1.5)


def _ratios(a, b, masters):
    lengths = [(length(u), length(v)) for u, v in zip(masters.at(a), masters.at(b))]
    return [v / u for u, v in lengths if u > 0 and v > 0]


def candidates(a, b, masters, both):
    """Yields handles in the place of these that may be smooth together; only those on the right move unless both do."""
    ratios = _ratios(a, b, masters)
    if not ratios:
        return
    low, high = min(ratios), max(ratios)
    if both:
        for f in _fractions(low, high, *ratios):
            yield by_ratio(a, b, masters, f.numerator, f.denominator, True)
        directions = set()
        for u, v in zip(masters.at(a), masters.at(b)):
            s = float(u[0] + v[0]), float(u[1] + v[1])
            most = max(abs(s[0]), abs(s[1]))
            for n in range(1, LARGEST + 1) if most > 0 else ():
                e = nearest(s[0] * n / most), nearest(s[1] * n / most)
                if any(e):
                    directions.add(primitive(e))
        for e in sorted(directions):
            yield by_direction(a, b, masters, e, True)
        return
    g = reduce(math.gcd, (int(c) for v in a for c in v))
    if g:
        first, last = math.floor(low * g), math.ceil(high * g)
        for p in range(max(1, first), last + 1) if last - first < 2000 else ():
            yield by_ratio(a, b, masters, p, g, False)
        yield by_direction(a, b, masters, primitive(next(v for v in a if any(v))), False)


def moves(a, b, x, y, masters):
    """Returns how far handles move at the masters."""
    return [length(minus(u, v)) for old, new in ((a, x), (b, y)) for u, v in zip(masters.at(old), masters.at(new))]


def smooth_handles(a, b, masters, free_a, free_b):
    """Returns the handles that are smooth at every mixture with the least moves (the longest, then the sum), and the longest move; None where the
    grid has none."""
    if free_a and not free_b:
        found = smooth_handles(b, a, masters, False, True)
        return found and (found[0], found[2], found[1])
    best = None
    for found in candidates(a, b, masters, free_a and free_b):
        if found is None or not is_smooth(*found) or not _runs_on(*found, masters):
            continue
        shifts = moves(a, b, *found, masters)
        cost = max(shifts), sum(shifts)
        if best is None or cost < best[0]:
            best = cost, found
    return best and (best[0][0], *best[1])


def longest_move(a, b, masters):
    """Returns how far a handle may move unless it is told: eight times what the kink is off at a master or halfway between two, and one unit more."""
    halfway = [[tuple(Fraction(u[c] + v[c]) / 2 for c in (0, 1)) for u in side for v in side] for side in (masters.at(a), masters.at(b))]
    lengths = [(abs(cross(u, v)), min(length(u), length(v))) for u, v in zip(*halfway)]
    return 1 + 8 * max((float(c) / least for c, least in lengths if least > 0), default=0.0)


# Curvatures: the degrees of both curves, and the vectors u and v, as shares.
Curves = namedtuple("Curves", "left right u v")


def _factors(curves):
    return (curves.left - 1) * curves.right, (curves.right - 1) * curves.left


def _direction(a, b):
    """Returns the vector of which all shares are multiples; None where they have not one direction."""
    e = primitive(next(v for v in a + b if any(v)))
    return e if not any(cross(v, e) for v in a + b) else None


def _ratio(a, b):
    """Returns k with b = k a for all shares; None where there is none."""
    c, u, v = next((c, u, v) for u, v in zip(a, b) for c in (0, 1) if u[c])
    k = Fraction(v[c]) / u[c]
    return k if k > 0 and all(times(k, u) == v for u, v in zip(a, b)) else None


def is_g2(a, b, curves):
    """Returns whether handles that are smooth at all mixtures have one curvature at all of them, exactly."""
    p, q = _factors(curves)
    n = range(len(a))
    e = _direction(a, b)
    if e is not None:
        m, k = ([exact(Fraction(dot(v, e)) / dot(e, e)) for v in side] for side in (a, b))
        left, right = [p * cross(u, e) for u in curves.u], [q * cross(e, v) for v in curves.v]
        return all(sum(left[i] * k[j] * k[h] - right[i] * m[j] * m[h] for i, j, h in permutations(t)) == 0
                   for t in combinations_with_replacement(n, 3))
    k = _ratio(a, b)
    if k is None:
        return False
    s = [tuple(p * k * k * u[c] + q * v[c] for c in (0, 1)) for u, v in zip(curves.u, curves.v)]
    return all(cross(a[i], s[j]) + cross(a[j], s[i]) == 0 for i in n for j in n if i <= j)


def _jump(a, b, u, v, curves):
    p, q = _factors(curves)
    left, right = p * float(cross(u, a)) / length(a) ** 3, q * float(cross(b, v)) / length(b) ** 3
    most = max(abs(left), abs(right))
    return abs(left - right) / most if most > 0 else 0.0


def curvature_jump(a, b, curves, masters):
    """Returns the largest relative jump of the curvature at the masters and halfway between two of them; 0 only where it is 0 at all mixtures."""
    if is_g2(a, b, curves):
        return 0.0
    at = [masters.at(x) for x in (a, b, curves.u, curves.v)]
    found = [5e-324]
    for i in range(len(masters.scalars)):
        for j in range(i + 1):
            halfway = [(x[i][0] + x[j][0], x[i][1] + x[j][1]) for x in at]
            if any(halfway[0]) and any(halfway[1]):
                found.append(_jump(*halfway, curves))
    return max(found)


def can_agree(a, b, curves, masters):
    """Returns whether the curvatures have one sign at each master, so that other lengths of handles make them agree."""
    signs = [(sign(cross(u, x)), sign(cross(y, v))) for x, y, u, v in zip(*(masters.at(w) for w in (a, b, curves.u, curves.v)))]
    return all(left == right for left, right in signs) and any(left for left, _ in signs)


def _lengths(m, n, p, q, offsets, free_a, free_b, bound):
    """Returns whole numbers near m and n, beside these offsets, with p n^2 = q m^2 if that is not farther than a bound, otherwise nearly so."""
    if p == 0 or q == 0:
        return (m, n) if p == q else None
    if p * q < 0:
        return None
    rho = math.sqrt(q / p)
    x = m if not free_a else n / rho if not free_b else (m + n) / (1 + rho)

    def best(pairs, cost):
        allowed = [(s, t) for s, t in pairs if s > 0 and t > 0 and (free_a or s == m) and (free_b or t == n)]
        return min(allowed, key=lambda z: (cost(z), abs(z[0] - m) + abs(z[1] - n)), default=None)

    def steps(z):
        return max(abs(z[0] - m), abs(z[1] - n))

    def jump(z):
        left, right = float(abs(p) * z[1] * z[1]), float(abs(q) * z[0] * z[0])
        return abs(left - right) / max(left, right)

    square = Fraction(q) / Fraction(p)
    i, j = math.isqrt(square.denominator), math.isqrt(square.numerator)
    found = None
    if i * i == square.denominator and j * j == square.numerator and i <= 1000:
        start = nearest(x - float(offsets[0]))
        exact = ((offsets[0] + k, (offsets[0] + k) * Fraction(j, i)) for k in range(start - i - STEPS, start + i + STEPS + 1))
        found = best([z for z in exact if Fraction(z[1] - offsets[1]).denominator == 1], steps)
        if found and steps(found) > bound:
            found = None
    if found is None:
        start = nearest(x - float(offsets[0])), nearest(rho * x - float(offsets[1]))
        window = range(-STEPS, STEPS + 1)
        found = best([(offsets[0] + start[0] + k, offsets[1] + start[1] + h) for k in window for h in window] + [(m, n)], jump)
    return found


def _along_direction(a, b, curves, masters, free, e, bound):
    """Returns handles of the direction e whose lengths make the curvatures agree at each master."""
    p, q = _factors(curves)
    square = dot(e, e)
    given = [[exact(Fraction(dot(v, e)) / square) for v in masters.at(side)] for side in (a, b)]
    left, right = [p * cross(u, e) for u in masters.at(curves.u)], [q * cross(e, v) for v in masters.at(curves.v)]
    shares = [[0] * len(a), [0] * len(a)]
    for r in masters.order:
        offsets = [sum(s * x for s, x in zip(masters.scalars[r], side)) for side in shares]
        found = _lengths(given[0][r], given[1][r], left[r], right[r], offsets, *free, bound / math.sqrt(square))
        if found is None:
            return None
        shares[0][r], shares[1][r] = (int(x - o) for x, o in zip(found, offsets))
    x, y = ([times(k, e) for k in side] for side in shares)
    return (x if free[0] else a), (y if free[1] else b)


def _along_ratio(a, b, curves, masters, f):
    """Returns handles of one ratio f that turn to where the curvatures agree: at each master, and at all mixtures."""
    p, q = _factors(curves)
    k, d = f.numerator, f.denominator
    s = [tuple(p * k * k * u[c] + q * d * d * v[c] for c in (0, 1)) for u, v in zip(curves.u, curves.v)]
    at = masters.at(s)
    wanted = []
    for u, v, w in zip(masters.at(a), masters.at(b), at):
        t = tuple(Fraction(d * u[c] + k * v[c]) / (k * k + d * d) for c in (0, 1))
        wanted.append(times(Fraction(dot(t, w)) / dot(w, w), w) if any(w) else t)
    t = masters.shares(wanted, lambda rest: (nearest(rest[0]), nearest(rest[1])))
    yield t
    g = reduce(math.gcd, (int(c) for v in s for c in v))
    if g and all(Fraction(c).denominator == 1 for v in s for c in v):
        size = sum(dot(v, w) for v, w in zip(wanted, at)) / sum(dot(w, w) for w in at) * g
        for n in {math.floor(size), math.ceil(size)} - {0}:
            yield [times(n, (int(x) // g, int(y) // g)) for x, y in s]


def harmonised(a, b, curves, masters, free_a, free_b, bound=None):
    """Finds handles in the place of these, which are smooth at all mixtures and stay so, whose curvatures agree there, or nearly: exactly where
    the grid allows it within the bound, otherwise with the least jump. Returns them with the jump and the longest move; None where nothing is
    better. The bound is a tenth of the shortest handle, at least 1, unless it is given."""
    if bound is None:
        bound = max(1.0, min(length(v) for v in masters.at(a) + masters.at(b)) / 10)
    found = []
    e = _direction(a, b)
    if e is not None:
        found.append(_along_direction(a, b, curves, masters, (free_a, free_b), e, bound))
    elif free_a and free_b:
        ratios = _ratios(a, b, masters)
        for f in _fractions(min(ratios), max(ratios), *ratios):
            for t in _along_ratio(a, b, curves, masters, f):
                found.append(([times(f.denominator, v) for v in t], [times(f.numerator, v) for v in t]))
    best = None
    for pair in found:
        if pair is None or not all(any(v) for side in pair for v in masters.at(side)):
            continue
        if not is_smooth(*pair) or not _runs_on(*pair, masters) or not can_agree(*pair, curves, masters):
            continue
        shifts = moves(a, b, *pair, masters)
        if max(shifts) > bound:
            continue
        cost = curvature_jump(*pair, curves, masters), max(shifts), sum(shifts)
        if best is None or cost < best[0]:
            best = cost, pair
    if best is None or best[0][0] >= curvature_jump(a, b, curves, masters):
        return None
    return (best[0][0], best[0][1], *best[1])
