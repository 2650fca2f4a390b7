# SPDX-License-Identifier: CC0-1.0
"""Reads OpenDRIVE and verifies what a record says of its worst join, in integers with 90 digits after
the point."""

import xml.etree.ElementTree as tree
from fractions import Fraction as F
from math import comb, factorial, isqrt

from joins import PI as PI_120
from joins import need, number, verify_flip

ONE = 10**90
PI = PI_120 // 10**30
SLACK = 10**35  # units of the last digit: all that is computed here is closer


def fixed(q):
    return q.numerator * ONE // q.denominator


def product(a, b):
    return a * b // ONE


def sine_cosine(angle):
    """Of a fixed number."""
    angle %= 2 * PI
    quarter = angle // (PI // 2)
    x = angle - quarter * (PI // 2)
    s, c, term, n = 0, ONE, ONE, 0
    while term:
        n += 1
        term = product(term, x) // n
        if n % 2:
            s += term if n % 4 == 1 else -term
        else:
            c += term if n % 4 == 0 else -term
    return [(s, c), (c, -s), (-s, -c), (-c, s)][quarter % 4]


def piece(a, b):
    """The integral of exp(i (a w + b w^2)) over [0, 1]: the exponential series, each power of the exponent integrated exactly."""
    powers = [[ONE], [ONE]]
    for row, x in zip(powers, (a, b)):
        for _ in range(63):
            row.append(product(row[-1], x))
    real = imaginary = 0
    for n in range(64):
        total = sum(comb(n, j) * product(powers[0][n - j], powers[1][j]) // (n + j + 1) for j in range(n + 1)) // factorial(n)
        if n % 2:
            imaginary += total if n % 4 == 1 else -total
        else:
            real += total if n % 4 == 0 else -total
    return real, imaginary


def turned(vector, heading):
    s, c = sine_cosine(heading)
    return product(vector[0], c) - product(vector[1], s), product(vector[0], s) + product(vector[1], c)


class Geometry:
    def __init__(self, element):
        a = element.attrib
        self.x, self.y, self.heading, self.length = (number(a[k]) for k in ("x", "y", "hdg", "length"))
        self.shape = next(iter(element))
        self.kind = self.shape.tag

    def curvatures(self):
        a = self.shape.attrib
        if self.kind == "line":
            return F(0), F(0)
        if self.kind == "arc":
            return number(a["curvature"]), number(a["curvature"])
        return number(a["curvStart"]), number(a["curvEnd"])

    def end(self, at_start):
        """Position, heading if it is a fraction, direction, and curvature as sign and square."""
        begin = fixed(self.x), fixed(self.y)
        heading = fixed(self.heading)
        if self.kind == "paramPoly3":
            a = {k: number(v) for k, v in self.shape.attrib.items() if k != "pRange"}
            t = F(0) if at_start else self.length if self.shape.attrib["pRange"] == "arcLength" else F(1)
            rows = []
            for order in range(3):
                rows.append([sum(F(factorial(k), factorial(k - order)) * a[f"{'abcd'[k]}{c}"] * t ** (k - order) for k in range(order, 4)) for c in "UV"])
            (u, v), (u1, v1), (u2, v2) = rows
            shift = turned((fixed(u), fixed(v)), heading)
            turn, speed = u1 * v2 - u2 * v1, u1**2 + v1**2
            direction = turned((fixed(u1), fixed(v1)), heading)
            return (begin[0] + shift[0], begin[1] + shift[1]), self.heading if v1 == 0 and u1 > 0 else None, direction, ((turn > 0) - (turn < 0), turn**2 / speed**3)
        k0, k1 = self.curvatures()
        k = k0 if at_start else k1
        curvature = ((k > 0) - (k < 0), k * k)
        if at_start:
            return begin, self.heading, turned((ONE, 0), heading), curvature
        x, y = begin
        parts = int(2 * (abs(k0) + abs(k1)) * self.length) + 1
        h, angle = self.length / parts, self.heading
        for i in range(parts):
            low = k0 + (k1 - k0) * F(i, parts)
            a, b = low * h, (k1 - k0) / parts * h / 2
            u, v = piece(fixed(a), fixed(b)) if a or b else (ONE, 0)
            u, v = turned((u, v), fixed(angle))
            x, y = x + u * h.numerator // h.denominator, y + v * h.numerator // h.denominator
            angle += a + b
        return (x, y), angle, turned((ONE, 0), fixed(angle)), curvature


def verify(record, left, right, flipped):
    (p, a, d, k), (q, b, e, j) = left, right
    if flipped:
        e, b, j = (-e[0], -e[1]), None, (-j[0], j[1])
    low, high = (fixed(number(x)) for x in record["gap"])
    gap = isqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2)
    need(low - SLACK <= gap <= high + SLACK, "the gap is another one")
    low, high = map(number, record["angle_radians"])
    if low == high == 0:
        need(a is not None and a == b, "the headings are not equal")
    else:
        turn, along = abs(product(d[0], e[1]) - product(d[1], e[0])), product(d[0], e[0]) + product(d[1], e[1])
        s, c = sine_cosine(fixed(low))
        need(product(turn, c) - product(along, s) >= -SLACK, "the kink is less")
        s, c = sine_cosine(fixed(high))
        need(product(turn, c) - product(along, s) <= SLACK, "the kink is more")
    low, high = map(number, record["curvature_jump"])
    root = lambda r: isqrt(r.numerator * ONE * ONE // r.denominator)
    jump = abs(k[0] * root(k[1]) - j[0] * root(j[1]))
    need((low == high == 0) == (k == j), "curvatures are equal, or not")
    need(fixed(low) - SLACK <= jump <= fixed(high) + SLACK, "the jump of curvature is another one")
    for key in ("gap", "angle_radians", "curvature_jump"):
        low, high = map(number, record[key])
        need((high - low) * 10**18 <= high, f"the enclosure of {key} is wide")


def level(order):
    return -1 if order == "gap" else int(order[1])


def clear_order(record, left, right):
    """Of a join that is far from each tolerance."""
    (p, _, d, k), (q, _, e, j) = left, right
    gap, angle, jump = (fixed(number(record["within"][n])) for n in ("gap", "angle_radians", "curvature_jump"))
    if isqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) > gap:
        return -1
    turn, along = abs(product(d[0], e[1]) - product(d[1], e[0])), product(d[0], e[0]) + product(d[1], e[1])
    if along <= 0 or turn > product(along, angle):
        return 0
    root = lambda r: isqrt(r.numerator * ONE * ONE // r.denominator)
    return 2 if abs(k[0] * root(k[1]) - j[0] * root(j[1])) <= jump else 1


def order_of(record):
    for order, key in enumerate(("gap", "angle_radians", "curvature_jump")):
        if record[key] is None:
            return f"G{order - 1}"
        tolerance = number(record["within"].get(key, "0"))
        if number(record[key][0]) > tolerance:
            return f"G{order - 1}" if order else "gap"
        need(number(record[key][1]) <= tolerance, "a tolerance inside of an enclosure")
    return "G2"


def check(record, data):
    roads = tree.fromstring(data).findall("road")
    lines = [[Geometry(g) for g in r.find("planView")] for r in roads]
    if record["road"] == "elevation":
        records = [{k: number(v) for k, v in e.attrib.items()} for e in roads[0].find("elevationProfile")]
        before, after = records
        h = after["s"] - before["s"]
        gap = abs(before["a"] + h * (before["b"] + h * (before["c"] + h * before["d"])) - after["a"])
        need(number(record["gap"][0]) <= gap <= number(record["gap"][1]), "the step is another one")
    elif record["road"] == "link":
        contact = roads[0].find("link/successor").attrib["contactPoint"]
        flipped = contact == "end"
        verify(record, lines[0][-1].end(False), lines[1][-1 if flipped else 0].end(not flipped), flipped)
    else:
        joins = [(a.end(False), b.end(True)) for a, b in zip(lines[0], lines[0][1:])]
        problems = []
        # The record tells of one of the joins; the others must not be worse.
        for left, right in joins:
            try:
                verify(record, left, right, False)
                break
            except Exception as error:
                problems.append(error)
        else:
            raise problems[0]
        need(all((left, right) == join or clear_order(record, *join) >= level(record["order"]) for join in joins), "another join is worse")
    need(record["order"] == order_of(record), f"the order is {order_of(record)}")
    verify_flip(record)
