# SPDX-License-Identifier: CC0-1.0
"""Reads the letter A of TrueType and CFF fonts, and decides variable ones over all their
instances."""

import struct
from fractions import Fraction as F

from joins import Wrong, is_zero, need, spline_sides


class Reader:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def take(self, format):
        values = struct.unpack_from(">" + format, self.data, self.at)
        self.at += struct.calcsize(">" + format)
        return values[0] if len(values) == 1 else list(values)


class Font:
    def __init__(self, data):
        count = struct.unpack_from(">H", data, 4)[0]
        self.tables = {}
        for i in range(count):
            name, _, offset, length = struct.unpack_from(">4sIII", data, 12 + 16 * i)
            self.tables[name.decode()] = data[offset : offset + length]
        self.glyph = self.glyph_of(65)

    def glyph_of(self, character):
        r = Reader(self.tables["cmap"], 4)
        r.take("HH")
        r = Reader(self.tables["cmap"], r.take("I"))
        need(r.take("H") == 4, "a cmap of another format")
        r.take("HH")
        n = r.take("H") // 2
        r.take("HHH")
        ends = r.take(f"{n}H")
        r.take("H")
        starts, shifts = r.take(f"{n}H"), r.take(f"{n}h")
        for i in range(n):
            if starts[i] <= character <= ends[i]:
                return (character + shifts[i]) % 65536
        raise Wrong("no letter A")

    def contours(self, glyph):
        """Points (x, y, is on the curve), and the matrix of a component."""
        offsets = struct.unpack(f">{len(self.tables['loca']) // 4}I", self.tables["loca"])
        r = Reader(self.tables["glyf"], offsets[glyph])
        count = r.take("hhhhh")[0]
        if count < 0:
            flags, other, dx, dy = r.take("HHhh")
            need(flags & 0x83 == 0x83 and dx == dy == 0, "a component of another kind")
            m = [F(v, 16384) for v in r.take("hhhh")]
            return [[[m[0] * p[0] + m[2] * p[1], m[1] * p[0] + m[3] * p[1], p[2]] for p in c] for c in self.contours(other)]
        ends = [r.take("H") for _ in range(count)]
        instructions = r.take("H")
        r.at += instructions
        n = ends[-1] + 1
        flags = [r.take("B") for _ in range(n)]
        need(all(f in (0, 1) for f in flags), "flags of another kind")
        points = [[0, 0, f] for f in flags]
        for axis in (0, 1):
            at = 0
            for p in points:
                at += r.take("h")
                p[axis] = F(at)
        return [points[a:b] for a, b in zip([0] + [e + 1 for e in ends], [e + 1 for e in ends])]

    def moves(self, glyph, contours):
        """Each tuple of variations as (peak, begin, end, moves of all points)."""
        r = Reader(self.tables["gvar"])
        _, _, axes, shared, _, count, flags, begin = r.take("HHHHIHHI")
        need(shared == 0 and flags == 1, "variations of another kind")
        offsets = r.take(f"{count + 1}I")
        if offsets[glyph] == offsets[glyph + 1]:
            return axes, []
        start = begin + offsets[glyph]
        r = Reader(self.tables["gvar"], start)
        tuples, data = r.take("HH")
        at, result = start + data, []
        n = sum(map(len, contours))
        for _ in range(tuples):
            size, index = r.take("HH")
            need(index & 0xA000 == 0xA000, "a tuple of another kind")
            read = lambda: [F(r.take("h"), 16384) for _ in range(axes)]
            peak = read()
            low, high = (read(), read()) if index & 0x4000 else ([min(p, F(0)) for p in peak], [max(p, F(0)) for p in peak])
            d = Reader(self.tables["gvar"], at)
            at += size
            k = d.take("B")
            numbers = list(range(n + 4))
            if k:
                numbers, last = [], 0
                while len(numbers) < k:
                    for _ in range(d.take("B") + 1):
                        last += d.take("B")
                        numbers.append(last)
            coordinates = []
            for _ in range(2):
                values = []
                while len(values) < len(numbers):
                    control = d.take("B")
                    need(control & 0xC0 == 0x40, "deltas that are no words")
                    values += [d.take("h") for _ in range((control & 63) + 1)]
                coordinates.append(values)
            given = {i: (F(x), F(y)) for i, x, y in zip(numbers, *coordinates) if i < n}
            result.append((peak, low, high, infer(given, contours)))
        return axes, result


def infer(given, contours):
    """The moves of points that have none: between their neighbours on the contour, or as the nearer one."""
    result, first = [], 0
    for c in contours:
        known = [i for i in range(len(c)) if first + i in given]
        for i in range(len(c)):
            if first + i in given:
                result.append(given[first + i])
            elif not known:
                result.append((F(0), F(0)))
            else:
                before = max((k for k in known if k < i), default=known[-1])
                after = min((k for k in known if k > i), default=known[0])
                move = []
                for axis in (0, 1):
                    a, b, x = c[before][axis], c[after][axis], c[i][axis]
                    da, db = given[first + before][axis], given[first + after][axis]
                    if a > b:
                        a, b, da, db = b, a, db, da
                    move.append(da if a == b and da == db else F(0) if a == b else da if x <= a else db if x >= b else da + (x - a) / (b - a) * (db - da))
                result.append(tuple(move))
        first += len(c)
    return result


def quadratic_segments(contour):
    """Triples and pairs of points. Points are (x, y, is on the curve), of any numbers."""
    n, full = len(contour), []
    for i in range(n):
        p, q = contour[i], contour[(i + 1) % n]
        full.append(p)
        if not p[2] and not q[2]:
            full.append([(p[0] + q[0]) * F(1, 2), (p[1] + q[1]) * F(1, 2), 1])
    while not full[0][2]:
        full.append(full.pop(0))
    segments, at = [], 0
    full.append(full[0])
    while at < len(full) - 1:
        step = 1 if full[at + 1][2] else 2
        segments.append([p[:2] for p in full[at : at + step + 1]])
        at += step
    return segments


def sides(segments):
    chain = []
    for points in segments:
        if any(p != points[0] for p in points):
            degree = len(points) - 1
            chain += spline_sides(degree, [F(0)] * (degree + 1) + [F(1)] * (degree + 1), points, None)
    return chain, True


# ---- CFF
def indexed(data, at):
    count = struct.unpack_from(">H", data, at)[0]
    if not count:
        return [], at + 2
    size = data[at + 2]
    offsets = [int.from_bytes(data[at + 3 + size * i : at + 3 + size * (i + 1)], "big") for i in range(count + 1)]
    base = at + 2 + size * (count + 1)
    return [data[base + a : base + b] for a, b in zip(offsets, offsets[1:])], base + offsets[-1]


def dictionary(data):
    result, stack, at = {}, [], 0
    while at < len(data):
        if data[at] == 29:
            stack.append(struct.unpack_from(">i", data, at + 1)[0])
            at += 5
        else:
            need(data[at] < 22, "a number of another form")
            result[data[at]], stack = stack, []
            at += 1
    return result


def charstring_segments(code, subroutines):
    """Cubics and lines of one contour."""
    at, segments, start, stack = [F(0), F(0)], [], None, []

    def go(dx, dy):
        nonlocal at
        at = [at[0] + dx, at[1] + dy]
        return at

    def curve(*d):
        segments.append([at] + [go(*d[i : i + 2]) for i in (0, 2, 4)])

    def run(code):
        nonlocal start, stack
        i = 0
        while i < len(code):
            b = code[i]
            i += 1
            if b == 28:
                stack.append(F(struct.unpack_from(">h", code, i)[0]))
                i += 2
            elif b == 255:
                stack.append(F(struct.unpack_from(">i", code, i)[0], 65536))
                i += 4
            elif b == 10:
                run(subroutines[int(stack.pop()) + 107])
            elif b == 11:
                return
            elif b == 21:
                start, stack = go(*stack), []
            elif b == 5:
                for k in range(0, len(stack), 2):
                    segments.append([at, go(*stack[k : k + 2])])
                stack = []
            elif b == 8:
                for k in range(0, len(stack), 6):
                    curve(*stack[k : k + 6])
                stack = []
            elif b == 31:
                horizontal = True
                while stack:
                    a, x, y, c = stack[:4]
                    extra = stack[4] if len(stack) == 5 else F(0)
                    curve(*((a, 0, x, y, extra, c) if horizontal else (0, a, x, y, c, extra)))
                    stack, horizontal = stack[4:] if len(stack) > 5 else [], not horizontal
            elif b == 12 and code[i] == 35:
                i += 1
                curve(*stack[:6])
                curve(*stack[6:12])
                stack = []
            else:
                need(b == 14, f"the operator {b}")
        return
    run(code)
    if at != start:
        segments.append([at, start])
    return segments


def read(data):
    font = Font(data)
    if data[:4] == b"OTTO":
        cff = font.tables["CFF "]
        _, at = indexed(cff, cff[2])
        tops, at = indexed(cff, at)
        top = dictionary(tops[0])
        strings, _ = indexed(cff, top[17][0])
        size, begin = top[18]
        private = dictionary(cff[begin : begin + size])
        subroutines = indexed(cff, begin + private[19][0])[0] if 19 in private else []
        return [sides(charstring_segments(strings[font.glyph], subroutines))]
    return [sides(quadratic_segments(c)) for c in font.contours(font.glyph)]


# ---- All instances: coordinates are polynomials of the axis values, as {exponents: coefficient}.
class Polynomial:
    def __init__(self, terms):
        self.terms = {e: c for e, c in terms.items() if c}

    def __add__(self, other):
        result = dict(self.terms)
        for e, c in other.terms.items():
            result[e] = result.get(e, 0) + c
        return Polynomial(result)

    def __mul__(self, other):
        if not isinstance(other, Polynomial):
            return Polynomial({e: c * other for e, c in self.terms.items()})
        result = {}
        for e, c in self.terms.items():
            for f, d in other.terms.items():
                g = tuple(map(sum, zip(e, f)))
                result[g] = result.get(g, 0) + c * d
        return Polynomial(result)

    def __sub__(self, other):
        return self + other * F(-1)

    def bernstein(self):
        """Coefficients over the unit box, as a list with the degrees."""
        from math import comb
        axes = len(next(iter(self.terms))) if self.terms else 1
        degrees = [max((e[i] for e in self.terms), default=0) for i in range(axes)]
        rows = {(): {(): F(0)}}
        result = {}
        from itertools import product
        for index in product(*(range(d + 1) for d in degrees)):
            total = F(0)
            for e, c in self.terms.items():
                if all(a <= b for a, b in zip(e, index)):
                    factor = c
                    for a, b, d in zip(e, index, degrees):
                        factor = factor * comb(b, a) / comb(d, a)
                    total += factor
            result[index] = total
        del rows
        return result

    def on(self, low, high):
        """With the box [low, high] made the unit box."""
        result = Polynomial({})
        for e, c in self.terms.items():
            term = Polynomial({(0,) * len(e): c})
            for i, k in enumerate(e):
                unit = tuple(1 if j == i else 0 for j in range(len(e)))
                line = Polynomial({(0,) * len(e): low[i], unit: high[i] - low[i]})
                for _ in range(k):
                    term = term * line
            result = result + term
        return result

    def at(self, w):
        total = F(0)
        for e, c in self.terms.items():
            for x, k in zip(w, e):
                c = c * x**k
            total += c
        return total


def proved_positive(p, allow_zero, depth=0):
    """On the unit box, by subdivision."""
    values = p.bernstein()
    if all(v > 0 or (allow_zero and v == 0) for v in values.values()):
        return True
    axes = len(next(iter(p.terms))) if p.terms else 1
    if depth > 60 or not p.terms:
        return False
    i = depth % axes
    half = [F(0)] * axes, [F(1)] * axes
    low, high = list(half[0]), list(half[1])
    high[i] = F(1, 2)
    if not proved_positive(p.on(low, high), allow_zero, depth + 1):
        return False
    low[i], high[i] = F(1, 2), F(1)
    return proved_positive(p.on(low, high), allow_zero, depth + 1)


def instance_boxes(axes, tuples):
    """The boxes between the peaks and ends of all tuples, where each scalar is a polynomial."""
    from itertools import product
    cuts = []
    for i in range(axes):
        values = {F(0), F(1)}
        for peak, low, high, _ in tuples:
            values |= {v for v in (peak[i], low[i], high[i]) if 0 <= v <= 1}
        cuts.append(sorted(values))
    for box in product(*(list(zip(c, c[1:])) for c in cuts)):
        yield [b[0] for b in box], [b[1] for b in box]


def scalar(axes, peak, low, high, box):
    """The weight of a tuple in a box, as a polynomial of the axis values."""
    result = Polynomial({(0,) * axes: F(1)})
    for i in range(axes):
        p, a, b = peak[i], low[i], high[i]
        if p == 0:
            continue
        unit = tuple(1 if j == i else 0 for j in range(axes))
        x0, x1 = box[0][i], box[1][i]
        if x1 <= a or x0 >= b and b != p:
            return Polynomial({})
        if x1 <= p:
            line = {unit: 1 / (p - a), (0,) * axes: -a / (p - a)}
        else:
            line = {unit: -1 / (b - p), (0,) * axes: b / (b - p)}
        result = result * Polynomial(line)
    return result


def joins_of_instances(data):
    """For each box of instances and each join, the handles before and after it as polynomials, in the unit box."""
    font = Font(data)
    contours = font.contours(font.glyph)
    axes, tuples = font.moves(font.glyph, contours)
    zero = (0,) * axes
    for low, high in instance_boxes(axes, tuples):
        weights = [scalar(axes, *t[:3], (low, high)) for t in tuples]
        first = 0
        for c in contours:
            moved = []
            for i, p in enumerate(c):
                point = [Polynomial({zero: p[0]}), Polynomial({zero: p[1]}), p[2]]
                for w, t in zip(weights, tuples):
                    move = t[3][first + i]
                    point = [point[0] + w * move[0], point[1] + w * move[1], p[2]]
                moved.append(point)
            first += len(c)
            segments = quadratic_segments(moved)
            for a, b in zip(segments, segments[1:] + segments[:1]):
                u = [a[-1][k] - a[-2][k] for k in (0, 1)]
                v = [b[1][k] - b[0][k] for k in (0, 1)]
                yield low, high, [x.on(low, high) for x in u], [x.on(low, high) for x in v]


def check_variable(record, data):
    """The largest angle over all instances, proved by subdivision."""
    from joins import EXACT_ANGLES, fixed_sine_cosine, need_angle, need_tight, number
    del EXACT_ANGLES, need_tight
    need(record["gap"] == ["0", "0"] and all(record[k] is None for k in ("curvature_percent", "curvature_jump", "torsion_jump")), "a size that is not asked for")
    low, high = map(number, record["angle_degrees"])
    need(0 <= low <= high and (high - low) * 10**9 <= high and high < 90, "the enclosure of the angle is wide")
    at = [number(record["at"][k]) for k in record["at"]] if record.get("at") else None
    found = False
    sine, cosine = fixed_sine_cosine(high)
    tangent = F(sine, cosine)
    for begin, end, u, v in joins_of_instances(data):
        turn, along = u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]
        need(proved_positive(along, False), "a corner, or a handle of no length")
        if high == 0:
            need(not turn.terms, "a kink where there is none")
            continue
        if turn.terms:
            for sign in (1, -1):
                need(proved_positive(along * tangent - turn * F(sign), True), f"the angle is more than {record['angle_degrees'][1]}")
            if all(a <= x <= b for a, x, b in zip(begin, at, end)):
                w = [(x - a) / (b - a) for a, x, b in zip(begin, at, end)]
                a, b = [p.at(w) for p in u], [p.at(w) for p in v]
                if not is_zero([a[0] * b[1] - a[1] * b[0]]):
                    sine_low, cosine_low = fixed_sine_cosine(low)
                    t = abs(a[0] * b[1] - a[1] * b[0]) / (a[0] * b[0] + a[1] * b[1])
                    found = found or t * cosine_low >= sine_low
    need(high == 0 or found, "the largest angle is not at that instance")
    need(record["order"] == ("G1" if high == 0 else "G0"), "the order is another one")
