# SPDX-License-Identifier: CC0-1.0
"""Roads in OpenDRIVE: reference lines of lines, arcs, clothoids and polynomials, which meet within
tolerances; profiles of heights and widths; lanes across sections, roads and junctions. Positions are
computed with 80 digits."""

from decimal import Decimal
from fractions import Fraction as F

from truth import PI, arctangent, decimal, enclosure, exact, name as named, root, root_bounds, text

WITHIN = {"gap": "0.001", "angle_radians": "0.001", "curvature_jump": "0.000001"}
SMALL = Decimal(10) ** -60


def sine_cosine(x):
    x = x - 2 * PI * (x / (2 * PI)).to_integral_value()
    halvings = 0
    while abs(x) > Decimal("0.1"):
        x, halvings = x / 2, halvings + 1
    s, c, term, n = Decimal(0), Decimal(1), Decimal(1), 0
    while abs(term) > Decimal(10) ** -90:
        n += 1
        term = term * x / n
        if n % 2:
            s += term if n % 4 == 1 else -term
        else:
            c += term if n % 4 == 0 else -term
    for _ in range(halvings):
        s, c = 2 * s * c, 2 * c * c - 1
    return s, c


def clothoid(length, begin, end):
    """Where it ends that starts at 0 along x, with the curvature from begin to end: by pieces, as the sum of a power series."""
    n = max(1, int((abs(begin) + abs(end)) * length) + 1)
    h, x, y, heading = length / n, Decimal(0), Decimal(0), Decimal(0)
    for i in range(n):
        k0 = begin + (end - begin) * i / n
        a, b = k0 * h, (end - begin) / n * h
        # exp(i (a w + b w^2 / 2)) has coefficients c_m with m c_m = i (a c_(m-1) + b c_(m-2)).
        previous, current = (Decimal(0), Decimal(0)), (Decimal(1), Decimal(0))
        u, v, m = Decimal(1), Decimal(0), 0
        while m < 4 or max(map(abs, previous + current)) > Decimal(10) ** -80:
            m += 1
            after = (-(a * current[1] + b * previous[1]) / m, (a * current[0] + b * previous[0]) / m)
            previous, current = current, after
            u, v = u + after[0] / (m + 1), v + after[1] / (m + 1)
        s, c = sine_cosine(heading)
        x, y = x + h * (u * c - v * s), y + h * (u * s + v * c)
        heading += a + b / 2
    return x, y


def abscissa(a, length):
    """Where the graph of the polynomial a has that arc length: u' = 1 / sqrt(1 + v'^2) as a power series of the length, by pieces of a metre."""
    u, rest = Decimal(0), length
    while rest > 0:
        h = min(rest, Decimal(1))
        x, n = [u], 60
        slope = [decimal(k * c) for k, c in enumerate(a)][1:]
        # q = 1 + p^2 with p = v'(x(s)); r = q^(-1/2) from q r' = -q' r / 2; x' = r.
        p, q, r = [], [], []
        for k in range(n):
            square = sum(x[i] * x[k - i] for i in range(k + 1))
            p.append((slope[0] if k == 0 else 0) + slope[1] * x[k] + slope[2] * square)
            q.append(sum(p[i] * p[k - i] for i in range(k + 1)) + (1 if k == 0 else 0))
            if k == 0:
                r.append(1 / q[0].sqrt())
            else:
                r.append(-sum((k - i + Decimal(i) / 2) * q[i] * r[k - i] for i in range(1, k + 1)) / (k * q[0]))
            x.append(r[k] / (k + 1))
        assert abs(x[n] * h**n) < Decimal(10) ** -65 and abs(x[n - 1] * h ** (n - 1)) < Decimal(10) ** -65, "a piece that is too long"
        u = sum(c * h**k for k, c in enumerate(x))
        rest -= h
    return u


class Geometry:
    """One record of a plan view, from the words of its line."""

    def __init__(self, words):
        x, y, heading, length, self.kind, *self.rest = words.split()
        self.words = (x, y, heading, length)
        self.x, self.y, self.heading, self.length = map(exact, self.words)

    def xml(self, s):
        x, y, heading, length = self.words
        if self.kind == "line":
            shape = "<line/>"
        elif self.kind == "arc":
            shape = f'<arc curvature="{self.rest[0]}"/>'
        elif self.kind == "spiral":
            shape = f'<spiral curvStart="{self.rest[0]}" curvEnd="{self.rest[1]}"/>'
        elif self.kind == "poly3":
            shape = "<poly3" + "".join(f' {k}="{v}"' for k, v in zip("abcd", self.rest)) + "/>"
        else:
            names = "aU bU cU dU aV bV cV dV".split()
            numbers = "".join(f' {k}="{v}"' for k, v in zip(names, self.rest[1:]))
            shape = f'<paramPoly3 pRange="{self.rest[0]}"{numbers}/>'
            shape = shape.replace(' pRange="-"', "")
        return f'<geometry s="{s}" x="{x}" y="{y}" hdg="{heading}" length="{length}">{shape}</geometry>'

    def end(self, begin=False):
        """Position and heading as decimals, curvature as (sign, square) or decimal, and the direction, exactly: a heading, and a vector in its frame; or
        nothing."""
        x0, y0 = decimal(self.x), decimal(self.y)
        s, c = sine_cosine(decimal(self.heading))
        if self.kind == "paramPoly3":
            a = [exact(v) for v in self.rest[1:]]
            t = F(0) if begin else self.length if self.rest[0] == "arcLength" else F(1)
            at = lambda p: (p[0] + p[1] * t + p[2] * t**2 + p[3] * t**3, p[1] + 2 * p[2] * t + 3 * p[3] * t**2, 2 * p[2] + 6 * p[3] * t)
            (u, u1, u2), (v, v1, v2) = at(a[:4]), at(a[4:])
            cross, speed = u1 * v2 - v1 * u2, u1 * u1 + v1 * v1
            sign = (cross > 0) - (cross < 0)
            turn = arctangent(abs(decimal(v1) / decimal(u1))) if v1 else Decimal(0)
            assert u1 > 0
            turn = turn if v1 >= 0 else -turn
            u, v = decimal(u), decimal(v)
            return (x0 + u * c - v * s, y0 + u * s + v * c), decimal(self.heading) + turn, (sign, cross**2 / speed**3), (self.heading, (u1, v1))
        if self.kind == "poly3":
            a = [exact(v) for v in self.rest]
            # A straight one whose slope belongs to a triangle of integers ends at a fraction.
            hypotenuse = root_bounds(1 + a[1] ** 2)
            if not begin and a[2] == a[3] == 0 and hypotenuse[0] == hypotenuse[1]:
                u = decimal(self.length / hypotenuse[0])
            else:
                u = Decimal(0) if begin else abscissa(a, decimal(self.length))
            d = [decimal(x) for x in a]
            v, v1, v2 = d[0] + u * (d[1] + u * (d[2] + u * d[3])), d[1] + u * (2 * d[2] + 3 * u * d[3]), 2 * d[2] + 6 * u * d[3]
            turn = arctangent(abs(v1)) * (1 if v1 >= 0 else -1)
            square = 1 + v1 * v1
            curvature = (int(v2 > 0) - int(v2 < 0), (2 * a[2]) ** 2 / (1 + a[1] ** 2) ** 3) if begin or a[2] == a[3] == 0 else v2 / (square * square.sqrt())
            return (x0 + u * c - v * s, y0 + u * s + v * c), decimal(self.heading) + turn, curvature, (self.heading, (F(1), a[1])) if begin or a[2] == a[3] == 0 else None
        k0, k1 = {"line": lambda: (F(0), F(0)), "arc": lambda: (exact(self.rest[0]),) * 2, "spiral": lambda: tuple(map(exact, self.rest))}[self.kind]()
        k = k0 if begin else k1
        curvature = ((k > 0) - (k < 0), k * k)
        if begin:
            return (x0, y0), decimal(self.heading), curvature, (self.heading, (F(1), F(0)))
        u, v = clothoid(decimal(self.length), decimal(k0), decimal(k1))
        heading = self.heading + (k0 + k1) * self.length / 2
        return (x0 + u * c - v * s, y0 + u * s + v * c), decimal(heading), curvature, (heading, (F(1), F(0)))


def bounds(value):
    """Around a decimal that is known with 60 digits after the point."""
    if value == 0:
        return ["0", "0"]
    return enclosure(F(max(value - SMALL, Decimal(0))), F(value + SMALL))


def join(left, right, flipped=False):
    """The sizes of a join; exact zeros where they are decided by fractions."""
    (p, a, k, fa), (q, b, j, fb) = left, right
    if flipped:
        b, fb, j = b + PI, None, (-j[0], j[1])
    along = fa and fb and fa[0] == fb[0] and fa[1][0] * fb[1][1] == fa[1][1] * fb[1][0] and fa[1][0] * fb[1][0] > 0
    straight = fa and fb and fa[1][1] == fb[1][1] == 0 and fa[1][0] * fb[1][0] > 0
    gap = ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2).sqrt()
    # Numbers with few digits are those of lines along x, exactly.
    is_exact = all(-x.as_tuple().exponent < 40 for x in (*p, *q))
    if along:
        angle = ["0", "0"]
    elif straight and abs(fa[0] - fb[0]) < 3:
        angle = enclosure(abs(fa[0] - fb[0]))
    else:
        turn = (a - b) - 2 * PI * ((a - b) / (2 * PI)).to_integral_value()
        angle = bounds(abs(turn))
    if k == j and isinstance(k, tuple):
        jump = ["0", "0"]
    elif isinstance(k, Decimal) or isinstance(j, Decimal):
        signed = lambda x: x if isinstance(x, Decimal) else x[0] * decimal(x[1]).sqrt()
        jump = bounds(abs(signed(k) - signed(j)))
    else:
        low, high = root_bounds(k[1]), root_bounds(j[1])
        if low[0] == low[1] and high[0] == high[1]:
            jump = enclosure(abs(k[0] * low[0] - j[0] * high[0]))
        else:
            jump = bounds(abs(k[0] * decimal(k[1]).sqrt() - j[0] * decimal(j[1]).sqrt()))
    if is_exact:
        square = (F(p[0]) - F(q[0])) ** 2 + (F(p[1]) - F(q[1])) ** 2
        gap = root(square)
    else:
        gap = bounds(gap)
    return {"gap": gap, "angle_radians": angle, "curvature_jump": jump}


def reached(measures, within):
    for order, key in enumerate(("gap", "angle_radians", "curvature_jump")):
        if exact(measures[key][0]) > exact(within[key]):
            return order - 1
        assert exact(measures[key][1]) <= exact(within[key]), "a tolerance inside of an enclosure"
    return 2


def after(words, digits):
    """Where a geometry ends, rounded."""
    (x, y), heading, _, _ = Geometry(words).end()
    return f"{x:.{digits}f} {y:.{digits}f} {heading:.{digits}f}"


def document(roads):
    return '<?xml version="1.0"?>\n<OpenDRIVE><header revMajor="1" revMinor="8"/>\n' + "\n".join(roads) + "\n</OpenDRIVE>\n"


LANES = '<lanes><laneSection s="0"><center><lane id="0" type="none"/></center></laneSection></lanes>'


def road(number, geometries, link="", elevation="", lanes=LANES):
    s, lines = F(0), []
    for g in geometries:
        lines.append(g.xml(text(s)))
        s += g.length
    return (f'<road id="{number}" length="{text(s)}" junction="-1">{link}\n<planView>\n' + "\n".join(lines) +
            f"\n</planView>{elevation}{lanes}</road>")


def cases(suite):
    def plan(name, question, why, lines, expect, within=WITHIN, up_to="G2"):
        geometries = [Geometry(w) for w in lines]
        joins = [join(a.end(), b.end(begin=True)) for a, b in zip(geometries, geometries[1:])]
        order = min(reached(j, within) for j in joins)
        worst = min(joins, key=lambda j: reached(j, within))
        if named(order) != expect:
            suite.problems.append(f"road/{name}: {expect} expected, {named(order)} computed, {joins}")
        suite.record(f"road/{name}", "road", question, why, expect, up_to, worst, {"xodr": document([road(1, geometries)])}, within=within, road="plan")

    line = "0 0 0 10 line"
    plan("lines", "position", "Two lines on the x axis: the only way to a gap of exactly 0.", [line, "10 0 0 10 line"], "G2")
    plan("gap-half", "tolerances", "A gap of half a millimetre, and a tolerance of one.", [line, "10.0005 0 0 10 line"], "G2")
    plan("gap-at-bound", "tolerances", "A gap of exactly one millimetre is within one millimetre.", [line, "10.001 0 0 10 line"], "G2")
    plan("gap-above-bound", "tolerances", "A gap of a millimetre and a picometre.", [line, "10.001000000001 0 0 10 line"], "gap")
    plan("gap-345", "tolerances", "A gap (0.0006, 0.0008) is exactly one millimetre.", [line, "10.0006 0.0008 0 10 line"], "G2")
    plan("gap-across", "position", "A gap of 5 mm across the road.", [line, "10 0.005 0 10 line"], "gap")
    plan("kink-below", "tolerances", "A kink of 0.0009 radians.", [line, "10 0 0.0009 10 line"], "G2")
    plan("kink-at-bound", "tolerances", "A kink of exactly 0.001 radians.", [line, "10 0 0.001 10 line"], "G2")
    plan("kink-above-bound", "tolerances", "A kink of 0.001 radians and 1e-15.", [line, "10 0 0.001000000000001 10 line"], "G0")
    plan("kink", "tangent", "A kink of one degree.", [line, "10 0 0.01745329252 10 line"], "G0")
    plan("heading-wraps", "tangent", "Headings 0 and 6.283185307179586 are one direction, but for 2.4e-16.", [line, "10 0 6.283185307179586 10 line"], "G2")
    plan("heading-wraps-twice", "tangent", "Headings -6.283185307179586 and 6.283185307179586.", ["0 0 -6.283185307179586 10 line", "10 0 6.283185307179586 10 line"], "G2")
    plan("heading-at-pi", "tangent", "Headings of pi and minus pi, to 16 digits: no jump.", ["0 0 3.141592653589793 10 line", "-10 0 -3.141592653589793 10 line"], "G2")
    plan("heading-reversed", "tangent", "The second line runs back over the first.", [line, "10 0 3.141592653589793 5 line"], "G0")
    plan("line-arc", "curvature", "A line goes on in an arc of radius 100: the curvature jumps.", [line, "10 0 0 10 arc 0.01"], "G1")
    plan("line-arc-flat", "curvature", "A line goes on in an arc of radius 1000 km: the jump is exactly the tolerance.", [line, "10 0 0 10 arc 0.000001"], "G2")
    plan("line-arc-above", "curvature", "A line goes on in an arc whose curvature is larger than the tolerance by 1e-15.", [line, "10 0 0 10 arc 0.000001000000001"], "G1")
    arc_end = "9.98334166468281523068 0.49958347219742339044 0.1"
    plan("arc-arc", "curvature", "An arc goes on in itself; the second one is written with another number of zeros.", ["0 0 0 10 arc 0.01", f"{arc_end} 10 arc 1.00e-2"], "G2")
    plan("arc-arc-s", "curvature", "An arc goes on in one that bends to the other side.", ["0 0 0 10 arc 0.01", f"{arc_end} 10 arc -0.01"], "G1")
    plan("arc-end-rounded", "position", "The end of an arc with a radius of 100, rounded to centimetres: off by 3.4 mm.", ["0 0 0 10 arc 0.01", "9.98 0.5 0.1 10 arc 0.01"], "gap")
    plan("arc-kink", "tangent", "An arc whose end heading is taken from its chord.", ["0 0 0 10 arc 0.01", "9.983341664683 0.499583472197 0.05 10 line"], "G0")
    plan("line-spiral", "curvature", "A clothoid begins with the curvature of the line before it.", [line, "10 0 0 50 spiral 0 0.02"], "G2")
    plan("spiral-starts-bent", "curvature", "A clothoid that begins with a curvature of 0.001.", [line, "10 0 0 50 spiral 0.001 0.02"], "G1")
    plan("spiral-arc", "curvature", "A line, a clothoid and an arc of radius 50; the end of the clothoid is rounded to 12 digits.",
         [line, "10 0 0 50 spiral 0 0.02", f"{after('10 0 0 50 spiral 0 0.02', 12)} 20 arc 0.02"], "G2")
    plan("spiral-arc-gap", "position", "The end of the clothoid as of a parabola, L^3 / 6 / R / L: off by decimetres.", [line, "10 0 0 50 spiral 0 0.02", "60 8.3333333333 0.5 20 arc 0.02"], "gap")
    plan("spiral-arc-radius", "curvature", "The arc has a radius of 50.01.", [line, "10 0 0 50 spiral 0 0.02", f"{after('10 0 0 50 spiral 0 0.02', 12)} 20 arc 0.019996"], "G1")
    plan("many-turns", "position", "A clothoid that turns by 30 radians: series without cuts lose all digits.", ["0 0 0 100 spiral 0 0.6", f"{after('0 0 0 100 spiral 0 0.6', 9)} 100 spiral 0.6 0"], "G2")
    plan("spiral-s", "curvature", "A clothoid through its point without curvature: the heading ends as it began.", ["0 0 1 40 spiral 0.02 -0.02", f"{after('0 0 1 40 spiral 0.02 -0.02', 10)} 20 arc -0.02"], "G2")
    plan("map-coordinates", "position", "Coordinates of a map with 9 digits: rounding alone opens a gap of 4.7 mm.", ["500000.12 4649776.22 1.1 80 line", "500036.41 4649847.52 1.1 80 line"], "gap")
    poly = "paramPoly3"
    plan("poly-start", "curvature", "A parabola begins with the curvature of the arc before it: 2/100.", ["0 0 0 0 arc 0.02", f"0 0 0 10.0663 {poly} normalized 0 10 0 0 0 0 1 0"], "G2")
    plan("poly-end", "curvature", "A parabola ends with the heading atan(0.4) and the curvature 0.032; a line goes on.", [f"0 0 0 10.2606 {poly} normalized 0 10 0 0 0 0 2 0", "10 2 0.3805063771 10 line"], "G1")
    plan("poly-kink", "tangent", "The line after the parabola has the heading of its chord.", [f"0 0 0 10.2606 {poly} normalized 0 10 0 0 0 0 2 0", "10 2 0.1973955598 10 line"], "G0")
    plan("poly-arc-length", "position", "The same numbers by arc length: the parameter runs to 10, and the end is (100, 200).",
         [f"0 0 0 10 {poly} arcLength 0 1 0 0 0 0 0.02 0", "10 2 0.3805063771 10 line"], "G1")
    plan("poly-range", "position", "pRange is normalized where the numbers are meant by arc length: the curve ends after 1 m.",
         [f"0 0 0 10 {poly} normalized 0 1 0 0 0 0 0.02 0", "10 2 0.3805063771 10 line"], "gap")
    plan("poly-rotated", "tangent", "A cubic in a frame that is turned by one radian, written with 9 digits.",
         [f"3 4 1 21 {poly} normalized 0 20 0 0 0 0 3 -2", after(f"3 4 1 21 {poly} normalized 0 20 0 0 0 0 3 -2", 9) + " 10 line"], "G1")

    def linked(name, question, why, first, second, link, flipped, expect):
        a, b = Geometry(first), Geometry(second)
        measures = join(a.end(), b.end(begin=link == "start") if not flipped else b.end(), flipped)
        order = reached(measures, WITHIN)
        if named(order) != expect:
            suite.problems.append(f"road/{name}: {expect} expected, {named(order)} computed, {measures}")
        one = road(1, [a], f'<link><successor elementType="road" elementId="2" contactPoint="{link}"/></link>')
        back = "successor" if link == "end" else "predecessor"
        two = road(2, [b], f'<link><{back} elementType="road" elementId="1" contactPoint="end"/></link>')
        suite.record(f"road/{name}", "road", question, why, expect, "G2", measures, {"xodr": document([one, two])}, within=WITHIN, road="link")
    linked("link-start", "curvature", "A line passes into an arc of another road.", line, "10 0 0 10 arc 0.01", "start", False, "G1")
    linked("link-start-gap", "position", "The next road begins 5 cm beside the end.", line, "10 0.05 0 10 line", "start", False, "gap")
    linked("link-end", "tangent", "The next road is linked by its end: its heading is turned by pi.", line, "20 0 3.14159265358979324 10 line", "end", True, "G2")
    linked("link-end-kink", "tangent", "The next road is linked by its end, and comes at an angle of 0.01 radians.", line, "19.9995000041666 0.0999983333416666 3.15159265358979 10 line", "end", True, "G0")

    # ---- Other polynomials. The one of a graph ends where its arc length is the length.
    plan("poly-no-range", "position", "Without pRange the parameter runs from 0 to 1.", [f"0 0 0 10.2606 {poly} - 0 10 0 0 0 0 2 0", "10 2 0.3805063771 10 line"], "G1")
    plan("poly-halves", "curvature", "Two pieces of one cubic in one frame: position, direction and curvature are fractions, and equal.",
         [f"0 0 0.5 5.05 {poly} normalized 0 5 0 0 0 0 1 -0.25", f"0 0 0.5 5.15 {poly} normalized 5 5 0 0 0.75 1.25 0.25 -0.25"], "G2")
    plan("poly-speed", "curvature", "One parabola at the speeds 10 and 20: directions and curvatures agree at its vertex.",
         [f"0 0 0 10.0663 {poly} normalized -10 10 0 0 1 -2 1 0", f"0 0 0 20.5212 {poly} normalized 0 20 0 0 0 0 4 0"], "G2")
    plan("poly-inflection", "curvature", "A cubic begins without curvature after a line.", [line, f"10 0 0 20.4 {poly} normalized 0 20 0 0 0 0 0 2"], "G2")
    plan("poly3-straight", "position", "The graph v = 0.75 u with a length of 5 m ends at (4, 3).", ["0 0 0 5 poly3 0 0.75 0 0", "4 3 0.6435011087932844 10 line"], "G2")
    plan("poly3-parabola", "curvature", "The graph of a parabola, whose end follows from its arc length; the next start has 12 digits.",
         ["0 0 0 20 poly3 0 0 0.01 0", after("0 0 0 20 poly3 0 0 0.01 0", 12) + " 10 line"], "G1")
    plan("poly3-length-along-u", "position", "The next line starts where u is the length: off by half a metre.", ["0 0 0 20 poly3 0 0 0.01 0", "20 4 0.3805063771 10 line"], "gap")
    plan("poly3-cubic", "curvature", "The graph of a cubic in a frame that is turned, between lines: its curvature is 0 at its start only.",
         ["-3 -4 0.927295218 5 line", "0 0 0.927295218 15 poly3 0 0 0 0.0004", after("0 0 0.927295218 15 poly3 0 0 0 0.0004", 10) + " 10 line"], "G1")
    plan("poly3-offset", "position", "The graph begins 5 cm beside its frame: a = 0.05.", [line, "10 0 0 10 poly3 0.05 0 0 0"], "gap")
    plan("poly3-slope", "tangent", "The graph begins with the slope 0.01 in its frame.", [line, "10 0 0 10 poly3 0 0.01 0 0"], "G0")

    # ---- Profiles are polynomials of s: all is exact.
    limits = {"gap": "0.001", "slope_jump": "0.001", "second_jump": "0.000001"}

    def profile(name, question, why, kind, records, expect, up_to="G0"):
        attributes = lambda r: "".join(f' {k}="{v}"' for k, v in zip(("sOffset" if kind == "width" else "s", *"abcd"), r))
        lines = "".join(f"<{kind}{attributes(r)}/>" for r in records)
        (s, a, b, c, d), (t, *later) = ([exact(x) for x in r] for r in records)
        h = t - s
        jet = (a + b * h + c * h**2 + d * h**3, b + 2 * c * h + 3 * d * h**2, 2 * c + 6 * d * h)
        measures = {k: enclosure(abs(x - y)) for k, x, y in zip(limits, jet, (later[0], later[1], 2 * later[2]))}
        most = int(up_to[1])
        within = dict(list(limits.items())[: most + 1])
        order = next((i - 1 for i, k in enumerate(within) if exact(measures[k][0]) > exact(within[k])), most)
        if named(order) != expect:
            suite.problems.append(f"road/{name}: {expect} expected, {named(order)} computed")
        elevation, lanes = "", LANES
        if kind == "elevation":
            elevation = f"<elevationProfile>{lines}</elevationProfile>"
        elif kind == "laneOffset":
            lanes = LANES.replace("<lanes>", "<lanes>" + lines)
        else:
            lanes = LANES.replace("</center>", f'</center><right><lane id="-1" type="driving">{lines}</lane></right>')
        suite.record(f"road/{name}", "road", question, why, expect, up_to, measures, {"xodr": document([road(1, [Geometry("0 0 0 100 line")], elevation=elevation, lanes=lanes)])},
                     within=within, road=kind)
    flat = ("0", "0", "0.02", "0", "0")
    profile("elevation", "position", "A grade of 2 percent goes on in a parabola: heights agree exactly.", "elevation", [flat, ("50", "1", "0.02", "0.001", "0")], "G0")
    profile("elevation-step", "position", "A step of 52 mm in the height.", "elevation", [flat, ("50", "1.052", "0.02", "0", "0")], "gap")
    profile("elevation-step-at-bound", "tolerances", "A step of exactly one millimetre in the height.", "elevation", [flat, ("50", "1.001", "0.02", "0", "0")], "G0")
    profile("elevation-cubic", "position", "A cubic of 30 m ends 1.0000001 mm below the next record.", "elevation",
            [("0", "10", "0.01", "-0.001", "0.00002"), ("30", "9.9410000001", "0", "0", "0")], "gap")
    profile("elevation-grade", "tangent", "Heights agree, and the grade changes from 2 to 3 percent: a crest without rounding.", "elevation", [flat, ("50", "1", "0.03", "0", "0")], "G0", "G1")
    profile("elevation-grade-at-bound", "tolerances", "The grade changes by exactly 0.001.", "elevation", [flat, ("50", "1", "0.021", "0", "0")], "G1", "G1")
    profile("elevation-grade-above", "tolerances", "The grade changes by 0.001 and 1e-12.", "elevation", [flat, ("50", "1", "0.021000000001", "0", "0")], "G0", "G1")
    profile("elevation-parabola", "tangent", "A parabola of 50 m ends with the grade of the next record.", "elevation", [("0", "0", "0.02", "-0.0002", "0"), ("50", "0.5", "0", "0", "0")], "G1", "G1")
    profile("elevation-rounded", "curvature", "A grade goes on in a parabola: heights and grades agree, second derivatives do not.", "elevation", [flat, ("50", "1", "0.02", "0.001", "0")], "G1", "G2")
    profile("elevation-one-cubic", "curvature", "Two records of one cubic: all three agree.", "elevation", [("0", "0", "0", "0.003", "-0.00002"), ("50", "5", "0.15", "0", "-0.00002")], "G2", "G2")
    profile("width-steady", "position", "The width of a lane grows from 3 to 3.5 m by a cubic, and stays.", "width", [("0", "3", "0", "0.0006", "-0.000008"), ("50", "3.5", "0", "0", "0")], "G0")
    profile("width-step", "position", "The width of a lane jumps by 10 cm within its section.", "width", [("0", "3", "0", "0", "0"), ("50", "3.1", "0", "0", "0")], "gap")
    profile("width-smooth", "tangent", "The border of the lane that widens has no kink where it ends.", "width", [("0", "3", "0", "0.0006", "-0.000008"), ("50", "3.5", "0", "0", "0")], "G1", "G1")
    profile("width-taper", "tangent", "A lane widens by a line, as most tapers are drawn: the border kinks.", "width", [("0", "3", "0.01", "0", "0"), ("50", "3.5", "0", "0", "0")], "G0", "G1")
    profile("offset-steady", "position", "The lane offset goes from 0 to 1.5 m by a cubic.", "laneOffset", [("0", "0", "0", "0.0018", "-0.000024"), ("50", "1.5", "0", "0", "0")], "G0")
    profile("offset-step", "position", "The lane offset jumps by 2 mm.", "laneOffset", [("0", "1.5", "0", "0", "0"), ("50", "1.502", "0", "0", "0")], "gap")
    lane_cases(suite)


class Lanes:
    """A road with lanes: its plan, its lane sections, and profiles. A section is (s, {lane: (widths, predecessors, successors)}); widths are texts of
    "sOffset a b c d" with commas between them, or "border" and such texts."""

    def __init__(self, number, plan, sections, offset=(), elevation="0", bank="0", link="", junction="-1"):
        self.number, self.plan, self.sections = number, [Geometry(g) for g in plan], sections
        self.offset, self.elevation, self.bank, self.link, self.junction = [o.split() for o in offset], elevation, bank, link, junction
        self.length = sum(g.length for g in self.plan)

    @staticmethod
    def cubics(words):
        return [w.split() for w in words.replace("border", "").split(",")]

    def xml(self):
        lanes = "<lanes>" + "".join(f'<laneOffset s="{o[0]}"' + "".join(f' {k}="{v}"' for k, v in zip("abcd", o[1:])) + "/>" for o in self.offset)
        for s, rows in self.sections:
            lanes += f'\n<laneSection s="{s}">'
            for side, ids in (("left", sorted((i for i in rows if i > 0), reverse=True)), ("center", [0]), ("right", sorted((i for i in rows if i < 0), reverse=True))):
                if not ids:
                    continue
                lanes += f"<{side}>"
                for i in ids:
                    if i == 0:
                        lanes += '<lane id="0" type="none"/>'
                        continue
                    widths, before, after = rows[i]
                    names = "".join(f'<predecessor id="{k}"/>' for k in before) + "".join(f'<successor id="{k}"/>' for k in after)
                    kind = "border" if widths.startswith("border") else "width"
                    records = "".join(f'<{kind} sOffset="{w[0]}"' + "".join(f' {k}="{v}"' for k, v in zip("abcd", w[1:])) + "/>" for w in self.cubics(widths))
                    lanes += f'<lane id="{i}" type="driving"><link>{names}</link>{records}</lane>'
                lanes += f"</{side}>"
            lanes += "</laneSection>"
        elevation = ""
        if self.elevation != "0":
            elevation += f'<elevationProfile><elevation s="0" a="{self.elevation}" b="0" c="0" d="0"/></elevationProfile>'
        if self.bank != "0":
            elevation += f'<lateralProfile><superelevation s="0" a="{self.bank}" b="0" c="0" d="0"/></lateralProfile>'
        return road(self.number, self.plan, self.link, elevation, lanes + "\n</lanes>").replace('junction="-1"', f'junction="{self.junction}"')

    @staticmethod
    def value(records, s):
        """Returns the value of the last record before s, or at it."""
        record = next((r for r in reversed(records) if exact(r[0]) <= s), None)
        if record is None:
            return F(0)
        start, a, b, c, d = map(exact, record)
        return a + b * (s - start) + c * (s - start) ** 2 + d * (s - start) ** 3

    def borders(self, which, lane, at_end):
        """The left and the right border of a lane at an end of its section: distances to the left of the reference line."""
        begin, rows = self.sections[which]
        begin = exact(begin)
        end = exact(self.sections[which + 1][0]) if which + 1 < len(self.sections) else self.length
        s = end if at_end else begin
        # The offset before s where the section ends, and at s where it begins.
        offsets = [o for o in self.offset if exact(o[0]) < s or not at_end]
        side = 1 if lane > 0 else -1
        edges = [self.value(offsets, s)]
        for k in range(side, lane + side, side):
            widths = rows[k][0]
            width = self.value(self.cubics(widths), s - begin)
            edges.append(width if widths.startswith("border") else edges[-1] + side * width)
        return (edges[-1], edges[-2]) if side > 0 else (edges[-2], edges[-1])


def lane_cases(suite):
    within = {"gap": "0.001"}

    def add(name, question, why, roads, pairs, expect, junction=""):
        """`pairs` are (road, section, lane, at its end) twice, and which borders meet: left, right or both."""
        gaps = []
        for a, b, which in pairs:
            first, second = (roads[x[0] - 1].borders(*x[1:]) for x in (a, b))
            flipped = a[0] != b[0] and a[3] == b[3]
            if flipped:
                second = second[::-1]
            for i in (0, 1):
                if which in ("both", ("left", "right")[i]):
                    gaps += distances(roads, a, b, first[i], second[i])
        worst = max(gaps, key=lambda g: exact(g[0]))
        order = named(-1 if exact(worst[0]) > exact(within["gap"]) else 0)
        assert order == "gap" or exact(worst[1]) <= exact(within["gap"])
        if order != expect:
            suite.problems.append(f"road/{name}: {expect} expected, {order} computed, {gaps}")
        measures = {"gap": worst, "angle_radians": None, "curvature_jump": None}
        suite.record(f"road/{name}", "road", question, why, expect, "G0", measures, {"xodr": document([r.xml() for r in roads] + ([junction] if junction else []))}, within=within, road="lanes")

    def distances(roads, a, b, t, u):
        """In the plane, and in height."""
        if a[0] == b[0]:
            return [enclosure(abs(t - u))]
        found = []
        for (number, _, _, at_end), offset in ((a, t), (b, u)):
            r = roads[number - 1]
            (x, y), heading, _, exactly = r.plan[-1 if at_end else 0].end(begin=not at_end)
            s, c = sine_cosine(heading) if exactly[0] else (Decimal(0), Decimal(1))
            s2, c2 = sine_cosine(decimal(exact(r.bank)))
            d = decimal(offset)
            found.append((x - d * c2 * s, y + d * c2 * c, decimal(exact(r.elevation)) + d * s2))
        (x, y, z), (p, q, w) = found
        square = (x - p) ** 2 + (y - q) ** 2
        result = []
        for value, squared in ((square, True), (abs(z - w), False)):
            if -value.as_tuple().exponent < 40 or not value:
                result.append(root(F(value)) if squared else enclosure(F(value)))
            else:
                result.append(bounds(value.sqrt() if squared else value))
        return result

    def steady(width):
        return f"0 {width} 0 0 0"

    def sections(name, why, first, second, links, expect, question="position", offset=()):
        """Two sections of one road, the second from 50 m on. `links` are (lane, next lane, borders that meet)."""
        rows = [{i: [w, [], []] for i, w in x.items()} for x in (first, second)]
        for a, b, _ in links:
            rows[0][a][2].append(b)
            rows[1][b][1].append(a)
        r = Lanes(1, ["0 0 0 100 line"], [("0", rows[0]), ("50", rows[1])], offset)
        add(name, question, why, [r], [((1, 0, a, True), (1, 1, b, False), which) for a, b, which in links], expect)
    w = steady
    sections("lanes", "A lane of 3.5 m passes into the next section.", {-1: w("3.5")}, {-1: w("3.5")}, [(-1, -1, "both")], "G0")
    sections("lanes-width-step", "The next section has 10 cm more of the lane.", {-1: w("3.5")}, {-1: w("3.6")}, [(-1, -1, "both")], "gap")
    sections("lanes-width-at-bound", "The width grows by exactly one millimetre.", {-1: w("3.5")}, {-1: w("3.501")}, [(-1, -1, "both")], "G0", "tolerances")
    sections("lanes-width-above", "The width grows by a millimetre and 1e-10.", {-1: w("3.5")}, {-1: w("3.5010000001")}, [(-1, -1, "both")], "gap", "tolerances")
    sections("lanes-cubic", "The lane widens from 3 to 3.5 m by a cubic up to the next section.", {-1: "0 3 0 0.0006 -0.000008"}, {-1: w("3.5")}, [(-1, -1, "both")], "G0")
    sections("lanes-second-record", "Of two records of the width the later one holds at the end of the section.", {-1: "0 3 0 0 0,20 3 0.02 0 0"}, {-1: w("3.6")}, [(-1, -1, "both")], "G0")
    sections("lanes-first-record", "The next section goes on with the width of the first record, which ended before.", {-1: "0 3 0 0 0,20 3 0.02 0 0"}, {-1: w("3")}, [(-1, -1, "both")], "gap")
    sections("lanes-left", "Lanes on both sides of the line; the left one widens by 5 cm.", {1: w("3"), -1: w("3.5")}, {1: w("3.05"), -1: w("3.5")}, [(1, 1, "both"), (-1, -1, "both")], "gap")
    sections("lanes-renumbered", "A new lane begins with no width inside, and lane -1 becomes lane -2.", {-1: w("3.5")}, {-1: "0 0 0.07 0 0", -2: w("3.5")}, [(-1, -2, "both")], "G0")
    sections("lanes-renumbered-shifted", "A new lane begins at once with 3.5 m inside: lane -2 goes on 3.5 m beside lane -1.", {-1: w("3.5")}, {-1: w("3.5"), -2: w("3.5")}, [(-1, -2, "both")], "gap")
    sections("lanes-inner", "Lane -2 keeps its width, but lane -1 inside of it becomes narrower by 10 cm.", {-1: w("3.5"), -2: w("3")}, {-1: w("3.4"), -2: w("3")}, [(-2, -2, "both")], "gap")
    sections("lanes-end", "The outer lane ends with no width, and has no successor.", {-1: w("3.5"), -2: "0 3 -0.06 0 0"}, {-1: w("3.5")}, [(-1, -1, "both")], "G0")
    sections("lanes-merge", "Two lanes of 3 m become one of 6 m.", {-1: w("3"), -2: w("3")}, {-1: w("6")}, [(-1, -1, "left"), (-2, -1, "right")], "G0")
    sections("lanes-merge-narrow", "Two lanes of 3 m become one of 5.9 m.", {-1: w("3"), -2: w("3")}, {-1: w("5.9")}, [(-1, -1, "left"), (-2, -1, "right")], "gap")
    sections("lanes-split", "A lane of 6 m becomes two.", {-1: w("6")}, {-1: w("2.5"), -2: w("3.5")}, [(-1, -1, "left"), (-1, -2, "right")], "G0")
    sections("lanes-offset", "The lane offset jumps by the width of a lane, and the lanes are numbered anew: lane 1 passes into lane -1, and no border moves.",
             {1: w("3.5"), -1: w("3.5")}, {-1: w("3.5"), -2: w("3.5")}, [(1, -1, "both"), (-1, -2, "both")], "G0", offset=("0 0 0 0 0", "50 3.5 0 0 0"))
    sections("lanes-offset-step", "The lane offset jumps by 5 cm where the section begins: all borders do.", {-1: w("3.5")}, {-1: w("3.5")}, [(-1, -1, "both")], "gap",
             offset=("0 0 0 0 0", "50 0.05 0 0 0"))
    sections("lanes-border", "A lane with a width passes into one with a border at -3.5 m.", {-1: w("3.5")}, {-1: "border0 -3.5 0 0 0"}, [(-1, -1, "both")], "G0")
    sections("lanes-border-step", "A lane with a width passes into one with a border at -3.48 m.", {-1: w("3.5")}, {-1: "border0 -3.48 0 0 0"}, [(-1, -1, "both")], "gap")

    def linked(name, why, first, second, expect, to=-1, contact="start", question="position", offset=(), widths=("3.5", "3.5"), **profiles):
        """Lane -1 at the end of road 1 passes into a lane of road 2."""
        a = Lanes(1, first, [("0", {-1: (w(widths[0]), [], [to])})], link=f'<link><successor elementType="road" elementId="2" contactPoint="{contact}"/></link>',
                  **{k: v[0] for k, v in profiles.items()})
        back = "predecessor" if contact == "start" else "successor"
        rows = {to: (w(widths[1]), [-1] if contact == "start" else [], [] if contact == "start" else [-1])}
        b = Lanes(2, second, [("0", rows)], offset, link=f'<link><{back} elementType="road" elementId="1" contactPoint="end"/></link>', **{k: v[1] for k, v in profiles.items()})
        add(name, question, why, [a, b], [((1, 0, -1, True), (2, 0, to, contact == "end"), "both")], expect)
    line, on = ["0 0 0 10 line"], ["10 0 0 10 line"]
    linked("roads", "A lane passes into one of another road.", line, on, "G0")
    linked("roads-width", "The lane of the next road is 4 mm wider.", line, on, "gap", widths=("3.5", "3.504"))
    linked("roads-gap", "The next road begins 5 cm beside the end, and so do its lanes.", line, ["10 0.05 0 10 line"], "gap")
    linked("roads-other-line", "The reference line of the next road lies 2 m to the left, its lane offset is -2 m: the lines do not meet, and the lanes do.", line, ["10 2 0 10 line"], "G0",
           offset=("0 -2 0 0 0",))
    linked("roads-other-line-off", "The reference line of the next road lies 2 m to the left, and its lane offset is -1.99 m.", line, ["10 2 0 10 line"], "gap", offset=("0 -1.99 0 0 0",))
    linked("roads-by-end", "The next road is linked by its end: its lane 1 lies on the same side.", line, ["20 0 3.14159265358979324 10 line"], "G0", to=1, contact="end")
    linked("roads-by-end-other-side", "The next road is linked by its end, and its lane -1 lies on the other side.", line, ["20 0 3.14159265358979324 10 line"], "gap", contact="end")
    linked("roads-kink", "The reference lines meet with a kink of 0.002 radians: the outer borders are 7 mm apart.", line, ["10 0 0.002 10 line"], "gap")
    linked("roads-kink-small", "The reference lines meet with a kink of 0.0002 radians: the outer borders are 0.7 mm apart.", line, ["10 0 0.0002 10 line"], "G0")
    linked("roads-arc", "A lane along an arc passes into one along a line; the end of the arc has 12 digits.", ["0 0 1 40 arc 0.02"], [after("0 0 1 40 arc 0.02", 12) + " 10 line"], "G0")
    linked("roads-arc-chord", "The line after the arc has the heading of its chord: borders are apart by metres.", ["0 0 0 40 arc 0.02"],
           [" ".join(after("0 0 0 40 arc 0.02", 12).split()[:2]) + " 0.4 10 line"], "gap")
    linked("roads-height", "The next road lies 5 cm higher.", line, on, "gap", elevation=("1", "1.05"))
    linked("roads-height-at-bound", "The next road lies exactly a millimetre higher.", line, on, "G0", question="tolerances", elevation=("1", "1.001"))
    linked("roads-banked", "Both roads are banked by 0.05 radians.", line, on, "G0", bank=("0.05", "0.05"))
    linked("roads-banked-step", "Only the first road is banked by 0.05 radians: its outer border lies 17 cm lower.", line, on, "gap", bank=("0.05", "0"))

    def junction(name, why, second, expect, to=-1):
        a = Lanes(1, line, [("0", {-1: (w("3.5"), [], [])})], link='<link><successor elementType="junction" elementId="9"/></link>')
        b = Lanes(2, second, [("0", {to: (w("3.5"), [-1], [])})], link='<link><predecessor elementType="road" elementId="1" contactPoint="end"/></link>', junction="9")
        text = f'<junction id="9" name=""><connection id="0" incomingRoad="1" connectingRoad="2" contactPoint="start"><laneLink from="-1" to="{to}"/></connection></junction>'
        add(name, "position", why, [a, b], [((1, 0, -1, True), (2, 0, to, False), "both")], expect, text)
    junction("junction", "A lane passes into a connecting road of a junction, which turns.", ["10 0 0 12 arc -0.1"], "G0")
    junction("junction-gap", "The connecting road of a junction begins 10 cm further on.", ["10.1 0 0 12 arc -0.1"], "gap")
    junction("junction-heading", "The connecting road begins with a heading that is off by 0.01 radians.", ["10 0 0.01 12 arc -0.1"], "gap")
