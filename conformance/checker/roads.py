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
    """Returns sine and cosine of a fixed number."""
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


def arc_length(slope, u):
    """Returns the length of a graph from 0 to u, by the binomial series of the root; `slope` has the coefficients of its derivative, as fixed numbers."""
    scaled = [c * u ** k // ONE**k for k, c in enumerate(slope)]
    square = [sum(product(scaled[i], scaled[k - i]) for i in range(len(scaled)) if 0 <= k - i < len(scaled)) for k in range(2 * len(scaled) - 1)]
    power, factor, total, k = [ONE], ONE, 0, 0
    while k < 400 and (k == 0 or any(abs(c) > 10 for c in power)):
        total += sum(product(factor, c) // (i + 1) for i, c in enumerate(power))
        factor = factor * (1 - 2 * k) // (2 * (k + 1))
        power = [sum(product(square[i], power[n - i]) for i in range(len(square)) if 0 <= n - i < len(power)) for n in range(len(power) + len(square) - 1)]
        while len(power) > 1 and abs(power[-1]) < 2:
            power.pop()
        k += 1
    need(k < 400, "a graph that is too steep")
    return product(total, u)


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
        """Position, heading and a vector in its frame if they are fractions, direction, and curvature as sign and square."""
        begin = fixed(self.x), fixed(self.y)
        heading = fixed(self.heading)
        if self.kind == "poly3":
            a = [number(self.shape.attrib[k]) for k in "abcd"]
            u, straight = 0, a[2] == a[3] == 0
            if not at_start:
                length = fixed(self.length)
                slope = [fixed(a[1]), fixed(2 * a[2]), fixed(3 * a[3])]
                u = length
                for _ in range(12):  # Newton
                    p = slope[0] + product(u, slope[1] + product(u, slope[2]))
                    step = (arc_length(slope, u) - length) * ONE // isqrt(ONE * ONE + p * p)
                    u -= step
                    if abs(step) < 10**15:
                        break
                need(abs(arc_length(slope, u) - length) < 10**20, "an end that is not found")
            t = F(u, ONE)
            v, v1, v2 = a[0] + t * (a[1] + t * (a[2] + t * a[3])), a[1] + t * (2 * a[2] + 3 * t * a[3]), 2 * a[2] + 6 * t * a[3]
            shift = turned((u, fixed(v)), heading)
            exact = (self.heading, (F(1), a[1])) if at_start or straight else None
            return (begin[0] + shift[0], begin[1] + shift[1]), exact, turned((ONE, fixed(v1)), heading), ((v2 > 0) - (v2 < 0), v2**2 / (1 + v1**2) ** 3)
        if self.kind == "paramPoly3":
            a = {k: number(v) for k, v in self.shape.attrib.items() if k != "pRange"}
            t = F(0) if at_start else self.length if self.shape.attrib.get("pRange") == "arcLength" else F(1)
            rows = []
            for order in range(3):
                rows.append([sum(F(factorial(k), factorial(k - order)) * a[f"{'abcd'[k]}{c}"] * t ** (k - order) for k in range(order, 4)) for c in "UV"])
            (u, v), (u1, v1), (u2, v2) = rows
            shift = turned((fixed(u), fixed(v)), heading)
            turn, speed = u1 * v2 - u2 * v1, u1**2 + v1**2
            direction = turned((fixed(u1), fixed(v1)), heading)
            return (begin[0] + shift[0], begin[1] + shift[1]), (self.heading, (u1, v1)), direction, ((turn > 0) - (turn < 0), turn**2 / speed**3)
        k0, k1 = self.curvatures()
        k = k0 if at_start else k1
        curvature = ((k > 0) - (k < 0), k * k)
        if at_start:
            return begin, (self.heading, (F(1), F(0))), turned((ONE, 0), heading), curvature
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
        return (x, y), (angle, (F(1), F(0))), turned((ONE, 0), fixed(angle)), curvature


def verify(record, left, right, flipped):
    (p, a, d, k), (q, b, e, j) = left, right
    if flipped:
        e, b, j = (-e[0], -e[1]), None, (-j[0], j[1])
    low, high = (fixed(number(x)) for x in record["gap"])
    gap = isqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2)
    need(low - SLACK <= gap <= high + SLACK, "the gap is another one")
    low, high = map(number, record["angle_radians"])
    if low == high == 0:
        need(a and b and a[0] == b[0], "the headings are not equal")
        need(a[1][0] * b[1][1] == a[1][1] * b[1][0] and a[1][0] * b[1][0] + a[1][1] * b[1][1] > 0, "the directions are not equal")
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
    """Returns the order of a join that is far from each tolerance."""
    (p, _, d, k), (q, _, e, j) = left, right
    gap, angle, jump = (fixed(number(record["within"][n])) for n in ("gap", "angle_radians", "curvature_jump"))
    if isqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) > gap:
        return -1
    turn, along = abs(product(d[0], e[1]) - product(d[1], e[0])), product(d[0], e[0]) + product(d[1], e[1])
    if along <= 0 or turn > product(along, angle):
        return 0
    root = lambda r: isqrt(r.numerator * ONE * ONE // r.denominator)
    return 2 if abs(k[0] * root(k[1]) - j[0] * root(j[1])) <= jump else 1


PROFILES = ("elevation", "width", "laneOffset")


def order_of(record):
    reached = "gap"
    keys = ("gap", "slope_jump", "second_jump") if record["road"] in PROFILES else ("gap", "angle_radians", "curvature_jump")
    for key in keys[: int(record["up_to"][1]) + 1]:
        if number(record[key][0]) > number(record["within"][key]):
            return reached
        need(number(record[key][1]) <= number(record["within"][key]), "a tolerance inside of an enclosure")
        reached = f"G{keys.index(key)}"
    return reached


def taylor(a, s):
    """Value and two derivatives of a record at s."""
    h = s - a["s" if "s" in a else "sOffset"]
    return [a["a"] + h * (a["b"] + h * (a["c"] + h * a["d"])), a["b"] + h * (2 * a["c"] + 3 * h * a["d"]), 2 * a["c"] + 6 * h * a["d"]]


def cubics(elements):
    return [{k: number(v) for k, v in e.attrib.items()} for e in elements]


def check_profile(record, road):
    paths = {"elevation": "elevationProfile/elevation", "width": "lanes/laneSection/right/lane/width", "laneOffset": "lanes/laneOffset"}
    before, after = cubics(road.findall(paths[record["road"]]))
    s = after["s" if "s" in after else "sOffset"]
    for key, x, y in zip(("gap", "slope_jump", "second_jump"), taylor(before, s), taylor(after, s)):
        low, high = map(number, record[key])
        need(low <= abs(x - y) <= high and (high - low) * 10**18 <= high, f"{key} is another one")


# ---- Lanes: each border is a distance to the left of the reference line.
class Road:
    def __init__(self, element):
        self.element = element
        self.plan = [Geometry(g) for g in element.find("planView")]
        self.length = number(element.attrib["length"])
        self.offsets = cubics(element.findall("lanes/laneOffset"))
        self.sections = element.findall("lanes/laneSection")
        self.starts = [number(x.attrib["s"]) for x in self.sections] + [self.length]
        self.lanes = [{int(x.attrib["id"]): x for x in section.findall("*/lane")} for section in self.sections]

    def border(self, section, lane, at_end):
        """The outer border of a lane, or the line between the sides, as lane 0."""
        s = self.starts[section + at_end]
        if lane == 0:
            valid = [o for o in self.offsets if o["s"] < s or o["s"] == s and not at_end]
            return taylor(valid[-1], s)[0] if valid else F(0)
        s -= self.starts[section]
        widths = [w for w in cubics(self.lanes[section][lane].findall("width")) if w["sOffset"] <= s]
        if widths:
            inner_side = self.border(section, lane - (1 if lane > 0 else -1), at_end)
            return inner_side + taylor(widths[-1], s)[0] * (1 if lane > 0 else -1)
        return taylor([w for w in cubics(self.lanes[section][lane].findall("border")) if w["sOffset"] <= s][-1], s)[0]

    def place(self, at_end, offset):
        """A border in the plane and its height, as fixed numbers."""
        (x, y), _, direction, _ = self.plan[-1 if at_end else 0].end(not at_end)
        size = isqrt(direction[0] ** 2 + direction[1] ** 2)
        bank = self.element.find("lateralProfile/superelevation")
        rise, along = sine_cosine(fixed(number(bank.attrib["a"]))) if bank is not None else (0, ONE)
        height = self.element.find("elevationProfile/elevation")
        z = fixed(number(height.attrib["a"])) if height is not None else 0
        t = fixed(offset)
        across = product(t, along)
        return x - across * direction[1] // size, y + across * direction[0] // size, z + product(t, rise)


def lane_links(network, roads):
    """((road, section, lane, at its end), the same of the next one), as often as a lane is named."""
    for road in roads.values():
        for k, lanes in enumerate(road.lanes):
            for lane, element in lanes.items():
                for word, at_end in (("predecessor", False), ("successor", True)):
                    for named in element.findall("link/" + word):
                        other = int(named.attrib["id"])
                        here = (road, k, lane, at_end)
                        if k + at_end in range(1, len(road.sections)):
                            yield here, (road, k + (1 if at_end else -1), other, not at_end)
                            continue
                        link = road.element.find("link/" + word)
                        if link is not None and link.attrib["elementType"] == "road":
                            target = roads[link.attrib["elementId"]]
                            end = link.attrib["contactPoint"] == "end"
                            yield here, (target, len(target.sections) - 1 if end else 0, other, end)
    for connection in network.findall("junction/connection"):
        a, b = roads[connection.attrib["incomingRoad"]], roads[connection.attrib["connectingRoad"]]
        end = connection.attrib["contactPoint"] == "end"
        leads = a.element.find("link/successor") is not None
        for pair in connection.findall("laneLink"):
            yield (a, len(a.sections) - 1 if leads else 0, int(pair.attrib["from"]), leads), (b, len(b.sections) - 1 if end else 0, int(pair.attrib["to"]), end)


def check_lanes(record, network):
    roads = {r.attrib["id"]: Road(r) for r in network.findall("road")}
    links = {}
    for pair in lane_links(network, roads):
        # The end comes first; both directions of one link are one.
        pair = sorted(pair, key=lambda x: (int(x[0].element.attrib["id"]), not x[3], x[1]))
        links[tuple((p[0].element.attrib["id"], *p[1:]) for p in pair)] = pair
    need(links, "no lanes are linked")
    worst = 0
    for key, (a, b) in links.items():
        turned_around = a[3] == b[3]
        # A lane that continues in several ones shares its outer borders with those at the rims.
        mates = ([k[0][2] for k in links if k[1] == key[1]], [k[1][2] for k in links if k[0] == key[0]])
        for leftmost in (True, False):
            first, second = max(mates[0]) if leftmost else min(mates[0]), max(mates[1]) if leftmost != turned_around else min(mates[1])
            if a[2] != first or b[2] != second:
                continue
            offsets = []
            for (road, section, lane, at_end), left in ((a, leftmost), (b, leftmost != turned_around)):
                number_of = lane if (lane > 0) == left else lane - (1 if lane > 0 else -1)
                offsets.append(road.border(section, number_of, at_end))
            if a[0] is b[0]:
                worst = max(worst, fixed(abs(offsets[0] - offsets[1])))
                continue
            p, q = a[0].place(a[3], offsets[0]), b[0].place(b[3], offsets[1])
            worst = max(worst, isqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2), abs(p[2] - q[2]))
    low, high = map(number, record["gap"])
    need(fixed(low) - SLACK <= worst <= fixed(high) + SLACK and (high - low) * 10**18 <= high, "the gap of the lanes is another one")
    need(record["angle_radians"] is None and record["curvature_jump"] is None, "a size that is not asked for")


def check(record, data):
    network = tree.fromstring(data)
    roads = network.findall("road")
    lines = [[Geometry(g) for g in r.find("planView")] for r in roads]
    if record["road"] in PROFILES:
        check_profile(record, roads[0])
    elif record["road"] == "lanes":
        check_lanes(record, network)
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
