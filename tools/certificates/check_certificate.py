#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks what `geometric_continuity verify FILE... --certificate CERTIFICATE` has written:  check_certificate CERTIFICATE [FILE...]

Without names the files are those of which the certificate tells. The numbers of the certificate must be those of the files, and each claim
must follow from them. All is computed anew, in fractions, from the definitions.

Exit code: 0 accepted; 1 refused; 2 a file cannot be read; 3 accepted, but the files have more joins than are certified, such as those of
arcs with square roots; they are counted."""

import gzip, json, re, sys
from decimal import Decimal
from fractions import Fraction
from functools import reduce
from math import comb, factorial, isqrt
from pathlib import Path
from xml.parsers import expat

class Refused(Exception):
    """The certificate does not hold."""
def need(condition, reason):
    if not condition:
        raise Refused(reason)
def exact(text):
    """An exact number, or a list of them, which may be nested."""
    if isinstance(text, list):
        return [exact(x) for x in text]
    need(isinstance(text, str), f"{text!r} is no exact number")
    return Fraction(text) if "/" in text else Fraction(Decimal(text))
def take(line, name):
    """Removes a member with exact numbers from a line."""
    need(name in line, f"{name} is missing")
    return exact(line.pop(name))
def need_equal(line, members):
    """Removes members that must have these values."""
    for name, value in members.items():
        need(name in line and type(line[name]) is type(value) and line.pop(name) == value, f"{name} is not {value}")
def plus(v, w, factor=1):
    return [x + factor * y for x, y in zip(v, w)]
def dot(v, w):
    return sum(x * y for x, y in zip(v, w))

# ---- Joins of curves: X = x[0], X' = x[1], ... are the derivatives of the left curve at the join,
# Y those of the right one.
def chain_rule(x, betas, j):
    """The j-th derivative of X(s(t)), s = sum beta_i t^i / i!: j! times the coefficient of t^j in sum X^(m) s^m / m!."""
    s = [Fraction(0)] + [b / factorial(i + 1) for i, b in enumerate(betas)] + [Fraction(0)] * j
    total, power = [Fraction(0)] * len(x[0]), [Fraction(1)] + [Fraction(0)] * j
    for m in range(1, j + 1):
        power = [sum(power[i] * s[k - i] for i in range(k + 1)) for k in range(j + 1)]
        total = plus(total, x[m], Fraction(factorial(j), factorial(m)) * power[j])
    return total
def are_independent(vectors):
    """Of each vector: it is no combination of those before it."""
    residuals = []
    for v in vectors:
        residuals.append(reduce(lambda w, b: plus(w, b, -dot(w, b) / (dot(b, b) or 1)), residuals, v))
    return [any(v) for v in residuals]
def check_residuals(line, name, is_refuted, residuals):
    """Orders that hold have no residual; that of the first that does not hold, if there is one, is what the line says."""
    need(not is_refuted or residuals.pop() == take(line, name), f"{name} is not the residual")
    need(not any(any(r) for r in residuals), f"an order before {name} does not hold")
def check_join(line, order, jets):
    """The claims about a join with these derivatives, where no order above `order` was asked for."""
    need((take(line, "x"), take(line, "y")) == jets, "the derivatives are not those of the file")
    (x, y), most = jets, min(order, len(jets[0][0]))
    c, g, f = (line.pop(kind + "_order") for kind in "cgf")
    need(all(type(k) is int and -1 <= k <= order for k in (c, g, f)), "an order is out of range")
    betas, factors = take(line, "betas"), take(line, "f_factors")
    residuals = [plus(y[j], x[j], -1) for j in range(min(c + 1, order) + 1)]
    need(c == order or any(residuals[-1]), "C: the next order holds as well")
    check_residuals(line, "c_residual", c < order, residuals)
    if c < 0 or order == 0 or not any(x[1]) or not any(y[1]):
        return need(g == f == min(c, 0) and not betas + factors, "G, F: not defined here")
    need(g >= 0 and len(betas) == min(g + 1, order) and (g == 0 or betas[0] > 0), "G: wrong betas")
    residuals = [plus(y[j], chain_rule(x, betas, j), -1) for j in range(1, len(betas) + 1)]
    refuted = dot(residuals[-1], x[1]) == 0 and (any(residuals[-1]) or (g == 0 and betas[0] <= 0))
    need(g == order or refuted, "G: the next order is not refuted")
    check_residuals(line, "g_residual", g < order, residuals)
    need((f >= 1) == (g >= 1) and f <= most and len(factors) == (min(f, most - 1) if f >= 1 else 0), "F: not so many factors")
    independent, residuals = are_independent(x[1:]), []
    for j, a in enumerate(factors, 2):
        need(len(a) == j - 1 and all(independent[i] or a[i] == 0 for i in range(j - 1)), "F: wrong factors")
        residuals.append(reduce(lambda v, i: plus(v, x[i], -a[i - 1]), range(1, j), plus(y[j], x[j], -(betas[0] ** j))))
    refuted = 1 <= f < most and any(residuals[-1]) and not any(dot(residuals[-1], x[i]) for i in range(1, f + 1))
    need(refuted or f in (0, most), "F: the next order is not refuted")
    return check_residuals(line, "f_residual", 1 <= f < most, residuals)

# ---- Splines over knots t, of degree p, with control points d.
def blossom(t, p, d, k, arguments):
    """The polar form of the polynomial on the span t[k], t[k + 1]."""
    d = d[k - p : k + 1]
    for r, u in enumerate(arguments, 1):
        for j in range(p, r - 1, -1):
            a = (u - t[k - p + j]) / (t[k + j - r + 1] - t[k - p + j])
            d[j] = plus([(1 - a) * x for x in d[j - 1]], d[j], a)
    return d[p]
def bezier(t, p, d, begin, end):
    """The Bezier points of the part from `begin` to `end`, in any order, within one span."""
    k = max(k for k in range(p, len(t) - p - 1) if t[k] <= min(begin, end) and t[k] < max(begin, end))
    return [blossom(t, p, d, k, [begin] * (p - j) + [end] * j) for j in range(p + 1)]
def breaks(t, p):
    return sorted(set(t[p : len(t) - p]))
def derivatives(b, h, order):
    """Those at the first point of a Bezier curve over an interval of length h."""
    p, result, factor = len(b) - 1, [], Fraction(1)
    for j in range(order + 1):
        result.append([factor * x for x in b[0]] if j <= p else [Fraction(0)] * len(result[0]))
        b = [plus(w, v, -1) for v, w in zip(b, b[1:])]
        factor *= Fraction(p - j) / h
    return result
def divided(jet):
    """The derivatives of x = p / w from those of (p, w): w x = p is differentiated."""
    result = []
    for k, v in enumerate(jet):
        x = v[:-1]
        for j in range(1, k + 1):
            x = plus(x, result[k - j], -comb(k, j) * jet[j][-1])
        result.append([y / jet[0][-1] for y in x])
    return result

# ---- The text format .g2: splines of one parameter, class 100, and of two, class 200; lines, class
# 120. Points are homogeneous.
def splines(data, kind):
    """The parameters (t, p) of each spline of this class, and its points."""
    words = iter(data.decode("utf-8", "replace").split())
    def numbers(n):
        return [exact(next(words)) for _ in range(n)]
    def integers(n):
        return [int(next(words)) for _ in range(n)]
    for word in words:
        version, skipped = integers(2), integers(integers(1)[0])
        (n,) = integers(1)
        if word == "120" and kind == "100":
            start, direction, _, ends = (numbers(k) for k in (n, n, 1, 2))
            yield [(sorted(ends * 2), 1)], [plus(start, direction, u) + [Fraction(1)] for u in ends]
            continue
        if word != kind or version != [1, 0]:
            raise NotImplementedError(f"class {word} of .g2 is not read where {kind} is expected")
        (rational,), parameters, size = integers(1), [], 1
        for _ in range(int(kind) // 100):
            count, order = integers(2)
            parameters.append((numbers(count + order), order - 1))
            size *= count
            need(parameters[-1][0] == sorted(parameters[-1][0]), "knots decrease")
        yield parameters, [numbers(n + rational) + [Fraction(1)] * (1 - rational) for _ in range(size)]
def curve_joins(files, order, closed):
    """What places each join of the chain, and the derivatives on both sides."""
    ends = []
    for data in files:
        for [(t, p)], points in splines(data, "100"):
            for begin, end in zip(breaks(t, p), breaks(t, p)[1:]):
                b = bezier(t, p, points, begin, end)
                ends.append([divided(derivatives(*a, order)) for a in ((b, end - begin), (b[::-1], begin - end))])
    for i in range(len(ends) - (not closed)):
        yield {"left": i, "right": (i + 1) % len(ends)}, (ends[i][1], ends[(i + 1) % len(ends)][0])

# ---- Drawings: a segment of a path is a pair, the derivatives at its start and at its end; empty
# without a length, None if they are not rational.
NUMBER, SPACE = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.compile(r"[ \t\n\f\r]*,?[ \t\n\f\r]*")
UNITS = {"": 1, "px": 1, "in": 96, "cm": Fraction(4800, 127), "mm": Fraction(480, 127), "q": Fraction(120, 127), "pt": Fraction(4, 3), "pc": 16}
NOT_DRAWN = """defs symbol clipPath mask marker pattern style linearGradient radialGradient filter script title desc metadata
    foreignObject flowRoot font text image""".split()
def segment(points, order):
    """A Bezier curve. What editors write for a line, a straight curve with a handle in its node, is the line."""
    chord, handles = plus(points[-1], points[0], -1), [plus(v, points[0], -1) for v in points[1:-1]]
    retracted = any(chord) and (points[1] == points[0] or points[-2] == points[-1])
    inside = all(chord[0] * v[1] == chord[1] * v[0] and 0 <= dot(chord, v) <= dot(chord, chord) for v in handles)
    b = [points[0], points[-1]] if retracted and inside else points
    return (derivatives(b, 1, order), derivatives(b[::-1], -1, order)) if any(v != b[0] for v in b) else ()
def arc(p, q, rx, ry, angle, is_large, is_swept, order):
    """An arc of an ellipse, by its eccentric angle: the second derivative leads to the centre. A quarter turn is linear in v."""
    if p == q or rx * ry == 0:
        return segment([p, q], order)
    rx, ry = abs(rx), abs(ry)
    if rx != ry and angle % 45:
        return None
    cosine, sine = ((1, 0), (0, 1), (-1, 0), (0, -1))[int(angle / 45) % 4 if rx != ry else 0]  # of twice the angle
    a, b = (ry / rx + rx / ry) / 2, (ry / rx - rx / ry) / 2
    def turned(v):
        return [-a * v[1] + b * (cosine * v[1] - sine * v[0]), a * v[0] + b * (cosine * v[0] + sine * v[1])]
    half = [(x - y) / 2 for x, y in zip(p, q)]
    k = turned(half)
    square = max(rx * ry / (half[0] * k[1] - half[1] * k[0]) - 1, 0)  # of the way to the centre; radii that are too small grow
    root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
    way = [x * (root if is_large != is_swept else -root) for x in k]
    def jet(end, r):
        tangent = [x * (1 if is_swept else -1) for x in turned(r)]
        return [end] + [[(-1) ** (j // 2) * x for x in (tangent if j % 2 else r)] for j in range(1, order + 1)]
    return (jet(p, plus(way, half)), jet(q, plus(way, half, -1))) if root * root == square else None
def shape(name, attributes, order):
    """The segments of a basic shape, as SVG draws it. None for lengths in parts of what is not known."""
    def length(name):
        number, unit = re.fullmatch(rf"\s*({NUMBER})([a-z%]*)\s*", attributes.get(name, "0").lower()).groups()
        return exact(number) * UNITS[unit]
    if name == "line":
        return [segment([[length("x1"), length("y1")], [length("x2"), length("y2")]], order)]
    x, y, w, h = (length(k) for k in ("x", "y", "width", "height"))
    given = ["r"] if name == "circle" else [k for k in ("rx", "ry") if attributes.get(k, "auto") != "auto"] or ["none"]
    rx, ry = length(given[0]), length(given[-1])
    if name == "rect":
        rx, ry = (min(rx, w / 2), min(ry, h / 2)) if rx * ry else (Fraction(0), Fraction(0))
    else:
        x, y, w, h = length("cx") - rx, length("cy") - ry, 2 * rx, 2 * ry
    xs, ys = [x, x + rx, x + w - rx, x + w], [y, y + ry, y + h - ry, y + h]
    p = [[xs[i], ys[j]] for i, j in ((1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1), (1, 0))]
    parts = [arc(p[i], p[i + 1], rx, ry, 0, False, True, order) if i % 2 else segment(p[i : i + 2], order) for i in range(8)]
    return [] if w * h == 0 else parts if name == "rect" else parts[3:] + parts[:3]  # an ellipse begins at its largest x
def subpaths(data, order):
    """The segments of each subpath of path data, and whether it is closed. What follows an error is None."""
    data = "" if data.strip() == "none" else data + "M0,0"  # which ends the last one
    at, letter, degree, segments = SPACE.match(data).end(), "", 1, []
    current = start = handle = [Fraction(0)] * 2
    def word(pattern):
        nonlocal at
        found = re.compile(pattern).match(data, at)
        need(found, f"path data: character {at + 1}")
        at = SPACE.match(data, found.end()).end()
        return found.group()
    def point(origin):
        return [o + exact(word(NUMBER)) for o in origin]
    try:
        while at < len(data):
            letter = word("[MmLlHhVvCcSsQqTtAaZz]") if data[at].isalpha() else {"M": "L", "m": "l"}.get(letter, letter)
            origin, kind, points = current if letter.islower() else [Fraction(0)] * 2, letter.upper(), [current]
            last_degree, degree = degree, {"C": 3, "S": 3, "Q": 2, "T": 2}.get(kind, 1)
            if kind in "MZ":
                segments += [segment([current, start], order)] * (kind == "Z")
                yield from [(segments, kind == "Z")] if segments else []
                segments = []
                current = start = point(origin) if kind == "M" else start
            elif kind in "HV":
                points.append([origin[i] + exact(word(NUMBER)) if i == "HV".index(kind) else current[i] for i in range(2)])
            elif kind == "A":
                numbers = [exact(word(x)) for x in (NUMBER, NUMBER, NUMBER, "[01]", "[01]")]
                points = [point(origin)]
                segments.append(arc(current, points[0], *numbers, order))
            else:
                if kind in "ST":
                    points.append(plus([2 * x for x in current], handle, -1) if last_degree == degree else current)
                points += [point(origin) for _ in range(degree + 1 - len(points))]
                handle = points[-2]
            segments += [segment(points, order)] if len(points) > 1 else []
            current = points[-1] if kind not in "MZ" else current
    except Refused:
        yield from ((x, False) for x in (segments, [None] * 2) if x)
def is_singular(transform):
    numbers = [(name, [exact(x) for x in re.findall(NUMBER, text)]) for name, text in re.findall(r"(\w+)\s*\(([^)]*)\)", transform)]
    return any((k == "matrix" and v[0] * v[3] == v[1] * v[2]) or (k == "scale" and v[0] * v[-1] == 0) for k, v in numbers)
def is_filled(attributes, otherwise):
    declared = [value for name, _, value in (d.partition(":") for d in attributes.get("style", "").split(";")) if name.strip().lower() == "fill"]
    value = (declared or [attributes.get("fill", "")])[-1].partition("!")[0].strip()
    return otherwise if value in ("", "inherit") else value not in ("none", "transparent")
def drawing_joins(files, order):
    """As curve_joins(), in the coordinates of each element: no invertible transform changes an order. None for what is not certified."""
    joins = []
    def start(full_name, attributes):
        name = full_name.replace("http://www.w3.org/2000/svg ", "")
        filled.append(is_filled(attributes, filled[-1] or sheets_fill))
        stack.append(stack[-1] and name not in NOT_DRAWN and " " not in name and not is_singular(attributes.get("transform", "")))
        data = attributes.get("d", "") if name == "path" else "M" + attributes.get("points", "") + "Z" * (name == "polygon")
        paths = subpaths(data, order) if name in ("path", "polygon", "polyline") and len(data) > 2 else [([None], True)] * (name == "use")
        try:
            if name in ("circle", "ellipse", "rect", "line"):
                paths = [(shape(name, attributes, order), name != "line")]
        except KeyError:
            paths = [([None], True)]
        for number, (segments, closed) in enumerate(paths if stack[-1] else [], 1):
            kept = [s for s in segments if s != ()]
            closed = closed or ((filled[-1] or sheets_fill) and all(kept[:1] + kept[-1:]) and kept[:1] and kept[0][0][0] == kept[-1][1][0])
            for i in range(len(kept) - (not closed)):
                j = (i + 1) % len(kept)
                place = {"line": parser.CurrentLineNumber, "subpath": number, "left": i, "right": j}
                joins.append((place, (kept[i][1], kept[j][0])) if kept[i] and kept[j] else None)
    for data in files:
        data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
        sheets_fill = any(b"fill" in sheet for sheet in re.findall(rb"<(?:\w+:)?style[\s>].*?</(?:\w+:)?style", data, re.DOTALL))
        parser, stack, filled = expat.ParserCreate(namespace_separator=" "), [True], [True]
        parser.StartElementHandler, parser.EndElementHandler = start, lambda _: (stack.pop(), filled.pop())
        parser.Parse(data, True)
    return joins

# ---- Edges of surfaces. Polynomials are lists of the coefficients of powers, without zeros at the
# end; points are homogeneous.
def trimmed(a):
    return trimmed(a[:-1]) if a and a[-1] == 0 else a
def add(a, b, factor=1):
    n = max(len(a), len(b))
    return trimmed(plus(a + [Fraction(0)] * (n - len(a)), b + [Fraction(0)] * (n - len(b)), factor))
def times(a, b):
    return [sum(a[i] * b[k - i] for i in range(len(a)) if 0 <= k - i < len(b)) for k in range(len(a) + len(b) - 1)] if a and b else []
def derivative(a):
    return [i * x for i, x in enumerate(a)][1:]
def powers(b):
    """The coordinates, as polynomials on [0, 1], of the curve with these Bezier points."""
    taylor = derivatives(b, 1, len(b) - 1)
    return [trimmed([x / factorial(k) for k, x in enumerate(a)]) for a in zip(*taylor)]
def scalar(v, w):
    return reduce(add, map(times, v, w))
def plane(a, b, c):
    """What v is multiplied by in det(v, a, b, c)."""
    def minor(j, k):
        return add(times(b[j], c[k]), times(b[k], c[j]), -1)
    result = []
    for i in range(4):
        j, k, m = (h for h in range(4) if h != i)
        total = add(add(times(a[j], minor(k, m)), times(a[k], minor(j, m)), -1), times(a[m], minor(j, k)))
        result.append([x * (-1) ** i for x in total])
    return result
def is_negative(a):
    """Of a polynomial: on the whole of [0, 1], by Sturm's sequence."""
    sequence, changes = [a, derivative(a)], []
    while sequence[-1]:
        rest, d = sequence[-2], sequence[-1]
        while len(rest) >= len(d):
            rest = add(rest, [Fraction(0)] * (len(rest) - len(d)) + d, -rest[-1] / d[-1])
        sequence.append([-x for x in rest])
    for values in [[p[0] for p in sequence if p], [sum(p) for p in sequence if p]]:
        signs = [x for x in values if x != 0]
        changes.append(sum(x * y < 0 for x, y in zip(signs, signs[1:])))
    return bool(a) and a[0] < 0 and sum(a) < 0 and changes[0] == changes[1]
def rows(surface, across, at, sign):
    """Where a parameter, 0 or 1, is constant: the other one, and the surface and its two derivatives across, to larger parameters or smaller."""
    parameters, points = surface
    (t, p), m = parameters[across], len(parameters[0][0]) - parameters[0][1] - 1
    beyond = min(x * sign for x in t if x * sign > at * sign) * sign
    lines = [points[k::m] for k in range(m)] if across == 1 else [points[k : k + m] for k in range(0, len(points), m)]
    return parameters[1 - across], list(zip(*(derivatives(bezier(t, p, d, at, beyond), abs(beyond - at), 2) for d in lines)))
def check_span(span, a, b):
    """The claims about a span of an edge, from the rows of both surfaces as polynomials on [0, 1]. Returns the order."""
    (p, pv, pvv), (q, qv, qvv), pu, order, claims = a, b, [derivative(x) for x in a[0]], -1, {}
    if p == q:
        normal, other, order = plane(p, pu, pv), plane(p, pu, qv), 0
        claims = {"determinant": scalar(normal, qv), "side": scalar(normal[:3], other[:3])}
        if not claims["determinant"] and is_negative(claims["side"]):
            i = next(i for i in range(4) if normal[i])
            d, m, n = claims["factors"] = [normal[i], plane(p, qv, pv)[i], other[i]]
            rest, twist = times(times(d, d), scalar(normal, qvv)), [derivative(x) for x in pv]
            for f, g, v in ((m, m, [derivative(x) for x in pu]), (m, n, twist), (m, n, twist), (n, n, pvv)):
                rest = add(rest, times(times(f, g), scalar(normal, v)), -1)
            claims["second_order"], order = rest, 1 if rest else 2
    need([take(span, name) for name in claims] == list(claims.values()), "a polynomial is another one")
    need_equal(span, {"order": order})
    return order
def side(surfaces, line, name):
    """The rows along an edge."""
    number, edge = line.pop("patch_" + name), line.pop("edge_" + name)
    need(type(number) is int and 0 <= number < len(surfaces) and edge in ("u0", "u1", "v0", "v1"), "no such edge")
    across, upper = "uv".index(edge[0]), edge[1] == "1"
    return rows(surfaces[number], across, breaks(*surfaces[number][0][across])[-upper], -1 if upper else 1)
def check_edge(line, surfaces):
    """The claims about an edge of two surfaces, or about a knot line in one."""
    if "knot" in line:
        number, across, knot, backwards = line.pop("patch"), "uv".index(line.pop("line")), take(line, "knot"), False
        need(type(number) is int and 0 <= number < len(surfaces) and knot in surfaces[number][0][across][0], "no such line")
        (a, a_rows), (b, b_rows) = (rows(surfaces[number], across, knot, sign) for sign in (-1, 1))
    else:
        (a, a_rows), (b, b_rows), backwards = side(surfaces, line, "a"), side(surfaces, line, "b"), line.pop("reversed")
    u, v = breaks(*a), breaks(*b)[:: -1 if backwards else 1]
    scale = (v[-1] - v[0]) / (u[-1] - u[0])
    cuts, orders = sorted(set(u + [u[0] + (x - v[0]) / scale for x in v])), []
    need(len(line["spans"]) == len(cuts) - 1, "there are not so many spans")
    for span, begin, end in zip(line["spans"], cuts, cuts[1:]):
        need((take(span, "begin"), take(span, "end")) == (begin, end), "a span has other ends")
        x = [bezier(*a, list(row), begin, end) for row in a_rows]
        y = [bezier(*b, list(row), *(v[0] + (t - u[0]) * scale for t in (begin, end))) for row in b_rows]
        factor = x[0][0][3] / y[0][0][3]
        y = [[[factor * z for z in point] for point in row] for row in y]
        need((take(span, "a"), take(span, "b")) == (x, y), "the rows are not those of the file")
        orders.append(check_span(span, *([powers(row) for row in rows] for rows in (x, y))))
    need_equal(line, {"order": min(orders), "spans": [{}] * len(orders)})

def check(certificate, names):
    """Returns how many lines were checked, and how many joins of the files have none."""
    lines = iter(Path(certificate).read_text(encoding="utf-8").splitlines())
    header = json.loads(next(lines))
    kind, given, order, closed = (header.pop(name, None) for name in ("certificate", "files", "max_order", "closed"))
    need(kind in ("chain", "drawings", "model") and header == {"version": 1} and type(closed) in (bool, type(None)) and len(names or given) == len(given), "the first line")
    files, count = [Path(name).read_bytes() for name in names or given], 0
    surfaces = [surface for data in files for surface in splines(data, "200")] if kind == "model" else []
    joins = [] if kind == "model" else list(curve_joins(files, order, closed) if kind == "chain" else drawing_joins(files, order))
    certified, passed = iter([join for join in joins if join]), 0
    for line in map(json.loads, lines):
        if "lines" in line:
            need_equal(line, {"lines": count})
            passed += len(list(certified))
            need(not line and not next(lines, None) and (kind == "drawings" or not passed), "the certificate has another length")
            return count, joins.count(None) + passed
        try:
            if kind == "model":
                check_edge(line, surfaces)
            else:
                place, jets = next(certified)
                while kind == "drawings" and not (line.items() >= place.items() and exact([line["x"], line["y"]]) == list(jets)):
                    (place, jets), passed = next(certified), passed + 1  # a join that was not covered
                need_equal(line, place)
                check_join(line, order, jets)
            need(not line, f"{', '.join(line)}: not checked")
        except Refused as error:
            raise Refused(f"line {count + 2}: {error}") from error
        count += 1
    raise Refused("the last line is missing")

def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help"):
        return print(__doc__) or (0 if arguments else 2)
    try:
        checked, missing = check(arguments[0], arguments[1:])
    except (OSError, NotImplementedError) as error:
        return print(f"check_certificate: {error}", file=sys.stderr) or 2
    except (Refused, ArithmeticError, LookupError, TypeError, ValueError, StopIteration, RuntimeError, AttributeError, expat.ExpatError) as error:
        return print(f"refused: {error or 'wrong numbers'}") or 1
    print(f"accepted: {checked} certified" + (f"; not checked: {missing} that are not certified" if missing else ""))
    return 3 if missing else 0

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
