# SPDX-License-Identifier: CC0-1.0
"""Roads in OpenDRIVE: reference lines of lines, arcs, clothoids and polynomials, which meet within
tolerances. Positions are computed with 80 digits."""

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
        else:
            names = "aU bU cU dU aV bV cV dV".split()
            numbers = "".join(f' {k}="{v}"' for k, v in zip(names, self.rest[1:]))
            shape = f'<paramPoly3 pRange="{self.rest[0]}"{numbers}/>'
        return f'<geometry s="{s}" x="{x}" y="{y}" hdg="{heading}" length="{length}">{shape}</geometry>'

    def end(self, begin=False):
        """Position and heading as decimals, curvature as (sign, square), and the exact heading if it is a fraction."""
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
            fraction = None if v1 else self.heading
            u, v = decimal(u), decimal(v)
            return (x0 + u * c - v * s, y0 + u * s + v * c), decimal(self.heading) + turn, (sign, cross**2 / speed**3), fraction
        k0, k1 = {"line": lambda: (F(0), F(0)), "arc": lambda: (exact(self.rest[0]),) * 2, "spiral": lambda: tuple(map(exact, self.rest))}[self.kind]()
        k = k0 if begin else k1
        curvature = ((k > 0) - (k < 0), k * k)
        if begin:
            return (x0, y0), decimal(self.heading), curvature, self.heading
        u, v = clothoid(decimal(self.length), decimal(k0), decimal(k1))
        heading = self.heading + (k0 + k1) * self.length / 2
        return (x0 + u * c - v * s, y0 + u * s + v * c), decimal(heading), curvature, heading


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
    gap = ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2).sqrt()
    # Numbers with few digits are those of lines along x, exactly.
    is_exact = all(-x.as_tuple().exponent < 40 for x in (*p, *q))
    if fa is not None and fb is not None and abs(fa - fb) < 3:
        angle = enclosure(abs(fa - fb))
    else:
        turn = (a - b) - 2 * PI * ((a - b) / (2 * PI)).to_integral_value()
        angle = bounds(abs(turn))
    if k == j:
        jump = ["0", "0"]
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

    # ---- Heights are polynomials of s: all is exact.
    def heights(name, why, records, expect):
        elevation = "<elevationProfile>" + "".join(f'<elevation s="{s}" a="{a}" b="{b}" c="{c}" d="{d}"/>' for s, a, b, c, d in records) + "</elevationProfile>"
        (s, a, b, c, d), (t, after, *_rest) = ([exact(x) for x in r] for r in records)
        h = t - s
        gap = abs(a + b * h + c * h**2 + d * h**3 - after)
        order = -1 if gap > exact("0.001") else 0
        if named(order) != expect:
            suite.problems.append(f"road/{name}: {expect} expected, {named(order)} computed")
        measures = {"gap": enclosure(gap), "angle_radians": None, "curvature_jump": None}
        suite.record(f"road/{name}", "road", "position", why, expect, "G0", measures, {"xodr": document([road(1, [Geometry("0 0 0 100 line")], elevation=elevation)])},
                     within={"gap": "0.001"}, road="elevation")
    heights("elevation", "A grade of 2 percent goes on in a parabola: heights agree exactly.", [("0", "0", "0.02", "0", "0"), ("50", "1", "0.02", "0.001", "0")], "G0")
    heights("elevation-step", "A step of 52 mm in the height.", [("0", "0", "0.02", "0", "0"), ("50", "1.052", "0.02", "0", "0")], "gap")
    heights("elevation-step-at-bound", "A step of exactly one millimetre in the height.", [("0", "0", "0.02", "0", "0"), ("50", "1.001", "0.02", "0", "0")], "G0")
    heights("elevation-cubic", "A cubic of 30 m ends 1.0000001 mm below the next record.", [("0", "10", "0.01", "-0.001", "0.00002"), ("30", "9.9410000001", "0", "0", "0")], "gap")
