# SPDX-License-Identifier: CC0-1.0
"""Reads the paths and shapes of SVG drawings, as far as the suite has them."""

import re
import xml.etree.ElementTree as tree
from fractions import Fraction as F
from math import isqrt

from joins import need, number, spline_sides

NUMBER = re.compile(r"[\s,]*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)")
FLAG = re.compile(r"[\s,]*([01])")
IDENTITY = [F(1), F(0), F(0), F(1), F(0), F(0)]


def product(m, n):
    return [m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
            m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5]]


def transform(text):
    result = IDENTITY
    for name, arguments in re.findall(r"(\w+)\s*\(([^)]*)\)", text.replace("px", "")):
        a = [number(x) for x in re.split(r"[\s,]+", arguments.strip())]
        if name == "matrix":
            m = a
        elif name == "translate":
            m = [F(1), F(0), F(0), F(1), a[0], a[1] if len(a) > 1 else F(0)]
        elif name == "scale":
            m = [a[0], F(0), F(0), a[-1], F(0), F(0)]
        else:
            need(name == "rotate" and len(a) == 1 and a[0] % 90 == 0, f"the transform {name}")
            c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[int(a[0] / 90) % 4]
            m = [F(c), F(s), F(-s), F(c), F(0), F(0)]
        result = product(result, m)
    return result


def applied(m, p):
    return [m[0] * p[0] + m[2] * p[1] + m[4], m[1] * p[0] + m[3] * p[1] + m[5]]


def rational_root(q):
    a, b = isqrt(q.numerator), isqrt(q.denominator)
    need(a * a == q.numerator and b * b == q.denominator, f"the root of {q} is no fraction")
    return F(a, b)


def arc(p, q, rx, ry, large, sweep):
    """The centre, and derivatives by the eccentric angle are those of a circle after a scaling: as a rational quadratic or two."""
    rx, ry = abs(rx), abs(ry)
    if p == q:
        return []
    if rx == 0 or ry == 0:
        return [([p, q], None)]
    a, b = [p[0] / rx, p[1] / ry], [q[0] / rx, q[1] / ry]
    half = [(b[0] - a[0]) / 2, (b[1] - a[1]) / 2]
    square = half[0] ** 2 + half[1] ** 2
    if square > 1:
        grown = rational_root(square)
        return arc(p, q, rx * grown, ry * grown, large, sweep)
    h = rational_root((1 - square) / square)
    if large == sweep:
        h = -h
    c = [(a[0] + b[0]) / 2 - h * half[1], (a[1] + b[1]) / 2 + h * half[0]]
    u, v = [a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]
    turn = 1 if sweep else -1
    cosine, sine = u[0] * v[0] + u[1] * v[1], turn * (u[0] * v[1] - u[1] * v[0])
    steps = []
    # Quarter turns, until what is left is less than one.
    while not (cosine > 0 and sine >= 0) and len(steps) < 4:
        w = [-turn * u[1], turn * u[0]]
        steps.append((u, w, F(0)))
        u = w
        cosine, sine = u[0] * v[0] + u[1] * v[1], turn * (u[0] * v[1] - u[1] * v[0])
    if u != v:
        steps.append((u, v, cosine))
    result = []
    for u, v, cosine in steps:
        # Tangents meet at (u + v) / (1 + cos). The weights 1, cos(half the angle), 1 are rational
        # after a change of the parameter.
        k = 1 / (1 + cosine)
        m = [(u[0] + v[0]) * k, (u[1] + v[1]) * k]
        weights = [F(1), F(1), 2 * k]
        result.append(([[(c[0] + x[0]) * rx, (c[1] + x[1]) * ry] for x in (u, m, v)], weights))
    return result


class Path:
    """The segments of path data, subpath by subpath."""

    def __init__(self, d, filled):
        self.subpaths, self.d, self.at, self.filled = [], d, 0, filled
        self.run()

    def number(self, pattern=NUMBER):
        found = pattern.match(self.d, self.at)
        need(found, f"a number is missing in {self.d!r}")
        self.at = found.end()
        return number(found.group(1))

    def finish(self, segments, closed):
        segments = [s for s in segments if any(p != s[0][0] for p in s[0])]
        if segments:
            closed = closed or (self.filled and segments[0][0][0] == segments[-1][0][-1])
            self.subpaths.append((segments, closed))

    def run(self):
        d, command, segments = self.d, "", []
        current = start = handle = [F(0), F(0)]
        previous = ""
        while True:
            self.at += len(d[self.at :]) - len(d[self.at :].lstrip(" \n\t,"))
            if self.at >= len(d):
                break
            if d[self.at].isalpha():
                command, self.at = d[self.at], self.at + 1
            elif command in "Mm":
                command = "L" if command == "M" else "l"
            kind, relative = command.upper(), command.islower()

            def point():
                p = [self.number(), self.number()]
                return [p[0] + current[0], p[1] + current[1]] if relative else p
            if kind == "Z":
                if current != start:
                    segments.append(([current, start], None))
                self.finish(segments, True)
                segments, current = [], start
            elif kind == "M":
                self.finish(segments, False)
                segments = []
                current = start = point()
            else:
                if kind == "L":
                    points = [point()]
                elif kind == "H":
                    points = [[self.number() + (current[0] if relative else 0), current[1]]]
                elif kind == "V":
                    points = [[current[0], self.number() + (current[1] if relative else 0)]]
                elif kind in "CQ":
                    points = [point() for _ in range(3 if kind == "C" else 2)]
                elif kind in "ST":
                    mirrored = [2 * current[0] - handle[0], 2 * current[1] - handle[1]] if previous in ("CS" if kind == "S" else "QT") and previous else current
                    points = [mirrored] + [point() for _ in range(2 if kind == "S" else 1)]
                else:
                    rx, ry, rotation = self.number(), self.number(), self.number()
                    need(rx == ry or rotation % 180 == 0, "a rotated ellipse")
                    large, sweep = self.number(FLAG), self.number(FLAG)
                    end = point()
                    segments += arc(current, end, rx, ry, large == 1, sweep == 1)
                    current, previous = end, kind
                    continue
                segments.append(([current] + points, None))
                handle, current = points[-2] if len(points) > 1 else points[-1], points[-1]
            previous = kind
        self.finish(segments, False)


def rectangle(a):
    x, y, w, h = (number(a.get(k, "0")) for k in ("x", "y", "width", "height"))
    rx, ry = a.get("rx"), a.get("ry")
    rx, ry = number(rx or ry or "0"), number(ry or rx or "0")
    rx, ry = min(rx, w / 2), min(ry, h / 2)
    if rx * ry == 0:
        return [([[x, y], [x + w, y]], None), ([[x + w, y], [x + w, y + h]], None), ([[x + w, y + h], [x, y + h]], None), ([[x, y + h], [x, y]], None)]
    result = []
    corners = [((x + w - rx, y), (x + w, y), (x + w, y + ry)), ((x + w, y + h - ry), (x + w, y + h), (x + w - rx, y + h)),
               ((x + rx, y + h), (x, y + h), (x, y + h - ry)), ((x, y + ry), (x, y), (x + rx, y))]
    at = [x + rx, y]
    for begin, corner, end in corners:
        if list(begin) != at:
            result.append(([at, list(begin)], None))
        result.append(([list(begin), list(corner), list(end)], [F(1), F(1), F(2)]))
        at = list(end)
    return result + ([([at, [x + rx, y]], None)] if at != [x + rx, y] else [])


def shapes(element, m, filled, chains):
    """In the coordinates of the outermost element."""
    name, a = element.tag.rpartition("}")[2], element.attrib
    style = dict(part.split(":", 1) for part in a.get("style", "").split(";") if ":" in part)
    m = product(m, transform(style.get("transform") or a.get("transform", "")))
    fill = (style.get("fill") or a.get("fill") or "").strip()
    filled = filled if not fill else fill != "none"
    subpaths = []
    if name in ("defs", "clipPath", "symbol"):
        return
    if name == "svg" and "viewBox" in a:
        x, y, w, h = map(number, re.split(r"[\s,]+", a["viewBox"].strip()))
        width, height = number(a["width"]), number(a["height"])
        need(a.get("preserveAspectRatio") == "none" or width * h == height * w, "the aspect ratio of a viewport")
        m = product(m, [width / w, F(0), F(0), height / h, number(a.get("x", "0")) - x * width / w, number(a.get("y", "0")) - y * height / h])
    if name == "path":
        subpaths = Path(a.get("d", ""), filled).subpaths
    elif name in ("polygon", "polyline"):
        subpaths = Path("M" + a["points"] + ("Z" if name == "polygon" else ""), filled).subpaths
    elif name == "line":
        subpaths = [([([[number(a["x1"]), number(a["y1"])], [number(a["x2"]), number(a["y2"])]], None)], False)]
    elif name == "rect":
        subpaths = [(rectangle(a), True)]
    elif name in ("circle", "ellipse"):
        rx, ry = (number(a["r"]),) * 2 if name == "circle" else (number(a["rx"]), number(a["ry"]))
        x, y = number(a.get("cx", "0")), number(a.get("cy", "0"))
        ends = [[x + rx, y], [x, y + ry], [x - rx, y], [x, y - ry]]
        pieces = [s for p, q in zip(ends, ends[1:] + ends[:1]) for s in arc(p, q, rx, ry, False, True)]
        subpaths = [(pieces, True)]
    elif name == "use":
        target = a.get("href") or a["{http://www.w3.org/1999/xlink}href"]
        shifted = product(m, [F(1), F(0), F(0), F(1), number(a.get("x", "0")), number(a.get("y", "0"))])
        shapes(shapes.named[target[1:]], shifted, filled, chains)
    for segments, closed in subpaths:
        chain = []
        for points, weights in segments:
            degree = len(points) - 1
            knots = [F(0)] * (degree + 1) + [F(1)] * (degree + 1)
            chain += spline_sides(degree, knots, [applied(m, p) for p in points], weights)
        chains.append((chain, closed))
    for child in element:
        shapes(child, m, filled, chains)


def read(data):
    """The subpaths, each with a mark whether it is closed."""
    root = tree.fromstring(data)
    shapes.named = {e.attrib["id"]: e for e in root.iter() if "id" in e.attrib}
    chains = []
    shapes(root, IDENTITY, True, chains)
    return chains
