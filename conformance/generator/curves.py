# SPDX-License-Identifier: CC0-1.0
"""Chains of curves in the plane and in space: Bezier curves, rational ones and splines."""

from fractions import Fraction as F

from truth import Curve


def bezier(points, weights=None):
    return Curve(points, weights=weights)


def spline(degree, points, knots, weights=None):
    return Curve(points, knots, weights, degree)


LEFT = "0,0 1,0 2,0 3,0"  # a line along the x axis, as a cubic at constant speed
BOW = "0,1 1,0.2 2,0 3,0"  # ends at (3, 0) to the right, curvature (2/3) 0.2 / 1


def moved(points, factor, dx="0", dy="0"):
    """All coordinates by a factor, and then moved."""
    from truth import exact, text
    d = [exact(dx), exact(dy), F(0)]
    return " ".join(",".join(text(exact(x) * exact(factor) + d[i]) for i, x in enumerate(p.split(","))) for p in points.split())


def cases(suite):
    add = suite.add

    def plane(name, question, why, curves, expect, up_to="G3", **more):
        add("plane/" + name, "curve", question, why, [bezier(c) if isinstance(c, str) else c for c in curves], expect, up_to, **more)

    def space(name, question, why, curves, expect, up_to="F3", **more):
        add("space/" + name, "curve", question, why, [bezier(c) if isinstance(c, str) else c for c in curves], expect, up_to, **more)

    def rational(name, question, why, curves, expect, up_to="G3", **more):
        add("rational/" + name, "curve", question, why, [bezier(*c) if isinstance(c, tuple) else bezier(c) if isinstance(c, str) else c for c in curves],
            expect, up_to, **more)

    def splines(name, question, why, curves, expect, up_to="G3", **more):
        add("spline/" + name, "curve", question, why, [spline(*c) for c in curves], expect, up_to, **more)

    # ---- Position, in the plane.
    plane("meets", "position", "Both curves have the same point at the join, and nothing else in common: a corner of 90 degrees.",
          ["0,0 1,0", "1,0 1,1"], "G0", "G0")
    for gap, seen in (("1", "everyone should see"), ("1e-3", "is the tolerance of many CAD systems"), ("1e-7", "is the confusion of OpenCASCADE"),
                      ("1e-9", "is below most tolerances"), ("1e-12", "is a few thousand times the rounding of a double at 1"),
                      ("1e-16", "no double at 1 can hold"), ("1e-30", "only exact numbers hold")):
        end = F(1) + F(gap)
        plane("gap-" + gap, "position", f"The second curve begins {gap} further on, a gap that {seen}.",
              ["0,0 1,0", Curve([[end, F(0)], [F(3), F(0)]])], "gap", "G0")
    plane("gap-across", "position", "The gap is across the direction of the curves, and not along it.", ["0,0 1,0", "1,1e-6 2,1e-6"], "gap", "G0")
    plane("gap-far", "position", "A gap of 1e-10 at a coordinate of 1000000, where a double has steps of 1.2e-10.",
          ["999999,0 1000000,0", "1000000.0000000001,0 1000001,0"], "gap", "G0")
    plane("gap-tiny-unit", "position", "In units of 1e-9 a gap of 1e-10 is a tenth of the curve, but below every absolute tolerance.",
          ["0,0 1e-9,0", "1.1e-9,0 2e-9,0"], "gap", "G0")
    plane("gap-huge-unit", "position", "In units of 1e9 a gap of 0.001 is smaller than rounding in single precision, and still a gap.",
          ["0,0 1e9,0", "1000000000.001,0 2e9,0"], "gap", "G0")
    plane("gap-decimals", "position", "0.3 and 0.30000000000000004 are two decimals, and two doubles that differ by one step.",
          ["0,0 0.3,0", "0.30000000000000004,0 1,0"], "gap", "G0")
    plane("gap-same-double", "position", "0.1 and 0.1000000000000000055511151231257827 are one double, and two decimals.",
          ["0,0 0.1,0", "0.1000000000000000055511151231257827,0 1,0"], "gap", "G0")
    plane("same-decimal-spelled-twice", "position", "0.5 and 5e-1 are one number.", ["0,0 0.5,0", "5e-1,0 1,0"], "G3")
    plane("reversed-second", "position", "The second curve runs backwards: its end is at the join, its start is not.", ["0,0 1,0", "2,0 1,0"], "gap", "G0")
    plane("closed-gap", "position", "The last curve of a closed chain ends beside the start of the first.", ["0,0 1,0", "1,0 0,1", "0,1 0,1e-8"], "gap", "G0",
          closed=True)
    plane("closed-meets", "position", "A closed triangle: all three joins meet, with corners.", ["0,0 1,0", "1,0 0,1", "0,1 0,0"], "G0", "G2", closed=True)

    # ---- Tangents, in the plane.
    plane("collinear", "tangent", "Two lines that continue each other at equal speed.", ["0,0 1,0", "1,0 2,0"], "G3")
    plane("collinear-speed", "tangent", "Two lines that continue each other; the second is a million times as long, which no G order sees.",
          ["0,0 1,0", "1,0 1000001,0"], "G3")
    plane("corner", "tangent", "A right angle.", ["0,0 1,0", "1,0 1,1"], "G0")
    plane("turned-back", "tangent", "The second line runs back: the tangents are parallel and opposite, a corner of 180 degrees.",
          ["0,0 1,0", "1,0 0.5,0"], "G0")
    plane("cusp", "tangent", "Two curves with a common tangent line and opposite directions: a cusp, on which the product of the tangents is 0.",
          ["0,1 1,0 2,0", "2,0 1,0 0,-1"], "G0")
    plane("near-cusp", "tangent", "The tangents are opposite but for 1e-7.", ["0,1 1,0 2,0", "2,0 1,-1e-7 0,-1"], "G0")
    for k in (1, 2, 3, 4, 6, 8, 10, 12, 15, 16, 20, 30):
        plane(f"kink-1e-{k}", "tangent", f"The second line has the slope 1e-{k}, which is the kink in radians, nearly.",
              ["0,0 1,0", Curve([[F(1), F(0)], [F(2), F(1, 10**k)]])], "G0", "G2")
    for d, why in (("0.0299", "1.7 degrees: smooth for a tolerance of 0.05 radians"), ("0.04995", "2.86 degrees, just below 0.05 radians"),
                   ("0.0501", "2.87 degrees, just above 0.05 radians"), ("0.0174", "0.997 degrees, just below one degree"),
                   ("0.0176", "1.008 degrees, just above one degree"), ("0.0875", "5.0005 degrees, just above 5 degrees"),
                   ("0.0874", "4.995 degrees, just below 5 degrees")):
        plane(f"kink-slope-{d}", "tangent", f"Cubics meet at an angle of {why}.",
              ["0,0 100,0 200,0 300,0", Curve([[F(300), F(0)], [F(400), F(d) * 100], [F(500), F(d) * 200 + 30], [F(600), F(0)]])], "G0", "G2")
    plane("kink-short-handles", "tangent", "Handles of 1e-9 that turn by 45 degrees: absolute tolerances take them for one point.",
          ["0,0 1,0 1.999999999,0 2,0", "2,0 2.000000001,1e-9 3,1 4,1"], "G0", "G2")
    plane("smooth-short-handles", "tangent", "Handles of 1e-9 in one direction: the tangents agree, however short they are.",
          ["0,0 1,0 1.999999999,0 2,0", "2,0 2.000000001,0 3,0 4,1"], "G1", "G1")
    plane("kink-far", "tangent", "A slope of 1e-6 at coordinates of 1e8: differences lose half of the digits of a double.",
          ["99999999,1e8 100000000,1e8", "100000000,1e8 100000001,100000000.000001"], "G0", "G2")
    plane("smooth-far", "tangent", "Lines with the slope 0.1 at coordinates of 1e8: no double holds these decimals, and they are collinear.",
          ["99999999,99999999.9 100000000,1e8", "100000000,1e8 100000001,100000000.1"], "G3")
    plane("smooth-decimals", "tangent", "Handles (0.1, 0.3) and (0.3, 0.9): parallel decimals, whose doubles are not.",
          ["0,0 0.1,0.3", "0.1,0.3 0.4,1.2"], "G3")
    plane("kink-same-doubles", "tangent", "A handle is off by 1e-17: the doubles of both handles are parallel, the decimals are not.",
          ["0,0 1,1", "1,1 2,2.00000000000000001"], "G0", "G2")
    plane("smooth-345", "tangent", "Directions (3, 4) and (6, 8), of different lengths, are one direction.", ["0,0 3,4", "3,4 6,8 7,8"], "G1", "G1")
    plane("zero-handle-right", "tangent", "The second cubic has its first handle in the node: the derivative is 0, the unit tangent is that to the next handle.",
          ["0,0 1,0 2,0 3,0", "3,0 3,0 4,0 5,1"], "G1", "G1")
    plane("zero-handle-left", "tangent", "The first cubic has its last handle in the node.", ["0,1 1,0 3,0 3,0", "3,0 4,0 5,0 6,0"], "G1", "G1")
    plane("zero-handles-both", "tangent", "Both handles lie in the node, and the curve goes straight on.", ["0,1 1,0 3,0 3,0", "3,0 3,0 5,0 6,1"], "G1", "G1")
    plane("zero-handle-kink", "tangent", "A handle lies in the node, and the next one shows a kink of 5.7 degrees.", ["0,0 1,0 2,0 3,0", "3,0 3,0 4,0.1 5,1"], "G0", "G2")
    plane("zero-handle-cusp", "tangent", "Both handles lie in the node, and the curve turns back.", ["0,1 1,0 3,0 3,0", "3,0 3,0 1,0 0,-1"], "G0", "G2")
    plane("c-infinity-cusp", "tangent", "(t^2, t^3) on both sides of 0: all derivatives agree, the first is 0, and the curve turns back.",
          ["1,-1 1/3,0 0,0 0,0", "0,0 0,0 1/3,0 1,1"], "G0", "G2")
    plane("retracted-line", "tangent", "A straight cubic with both handles in its nodes, as editors write a line, goes on in a line.",
          ["0,0 0,0 3,0 3,0", "3,0 6,0"], "G3")
    plane("kink-tiny-unit", "tangent", "A right angle in units of 1e-12.", ["0,0 1e-12,0", "1e-12,0 1e-12,1e-12"], "G0", "G2")
    plane("kink-huge-unit", "tangent", "A kink of 1e-6 in units of 1e12.", ["0,0 1e12,0", "1e12,0 2e12,1e6"], "G0", "G2")
    plane("kink-unequal", "tangent", "The handle before the join is 1e6 long, the one after it 1e-6, and off by 1e-8: 0.57 degrees.",
          ["-1e6,0 0,0", "0,0 1e-6,1e-8"], "G0", "G2")
    plane("closed-kink", "tangent", "A closed chain of smooth joins but for the last one, which kinks by 1e-3.",
          ["0,0 1,0 2,0", "2,0 3,0 3,1", "3,1 3,2 1,2", "1,2 -1,2 -1,1", "-1,1 -1,0.001 0,0"], "G0", "G2", closed=True)

    # ---- Curvature, in the plane.
    plane("line-bow", "curvature", "A line and a parabola, tangents equal: the curvature jumps from 0 to 1/2.", ["0,0 1,0", "1,0 2,0 3,1"], "G1")
    plane("one-parabola", "curvature", "Two parabolas, mirrored in the common vertex, are one: G3.", ["0,1 1,0 2,0", "2,0 3,0 4,1"], "G3")
    plane("inflection", "curvature", "The curvature has the same size on both sides and the other sign: magnitudes agree, the vectors do not.",
          ["0,1 1,0 2,0", "2,0 3,0 4,-1"], "G1")
    plane("scaled-speed", "curvature", "The second parabola is three times as fast and is the same parabola: G3, not C1.", ["0,1 1,0 2,0", "2,0 5,0 8,9"], "G3")
    plane("c1-jump", "curvature", "The derivatives are equal, the curvature jumps from 1/2 to 1.", ["0,1 1,0 2,0", "2,0 3,0 4,2"], "G1")
    plane("c1-g2", "curvature", "C1, and the second derivatives differ along the tangent: G2, not C2.", ["0,1 1,0 2,0", "2,0 3,0 5,1"], "G2")
    for k in (1, 2, 3, 6, 9, 12, 15, 18, 24):
        plane(f"jump-1e-{k}", "curvature", f"The curvature jumps by the part 1e-{k}, nearly; nothing else is wrong.",
              ["0,1 1,0 2,0", Curve([[F(2), F(0)], [F(3), F(0)], [F(4), 1 + F(1, 10**k)]])], "G1")
    plane("jump-tiny-absolute", "curvature", "Curvatures of 1e-12 and 2e-12: below any absolute tolerance, and one is twice the other.",
          ["0,2e-12 1,0 2,0", "2,0 3,0 4,4e-12"], "G1")
    plane("jump-huge-absolute", "curvature", "Curvatures of 1000000 and 1000001: a jump of 1 that is 1e-6 of them.",
          ["0,2 1e-3,0 2e-3,0", "0.002,0 0.003,0 0.004,2.000002"], "G1")
    plane("line-nearly", "curvature", "A line and a curve with the curvature 1e-10, whose relative jump is 100 percent.", ["0,0 1,0", "1,0 2,0 3,2e-10"], "G1")
    plane("flat-ends", "curvature", "A line and a cubic whose first three points are on it: both curvatures are 0.", ["0,0 1,0", "1,0 2,0 3,0 4,1"], "G2")
    plane("flat-inflection", "curvature", "An inflection where the curvature is 0 on both sides: G2, although it bends to the other side.",
          ["0,1 1,0 2,0 3,0", "3,0 4,0 5,0 6,-1"], "G3")
    plane("quintic-line", "curvature", "A quintic whose last three points lie on the line that follows.", ["0,3 1,1 2,1 3,0 4,0 5,0", "5,0 7,0"], "G2")
    plane("degrees-2-3", "curvature", "A parabola and a cubic of equal curvature.", ["0,1 1,0 2,0", "2,0 3,0 4,0.75 6,2"], "G2")
    plane("degrees-3-5", "curvature", "A cubic and a quintic of equal curvature, whose handles have the ratio 5 to 3.", ["0,1 3,2 6,0 9,-4", "9,-4 12,-8 15,-13 20,-20 25,-25 30,-30"],
          "G1")
    plane("degree-raised", "curvature", "A parabola and its own continuation, written as a quartic: one curve, in two degrees.",
          ["0,0 1/2,0 1,1", "1,1 1.25,1.5 1.5,13/6 1.75,3 2,4"], "G3", only="json")
    plane("split-cubic", "curvature", "One cubic, cut in the middle: all orders hold, at equal parameters C3.", ["0,0 1,2 1.5,3 2.125,3", "2.125,3 2.75,3 3.5,2 5,0"], "G3")
    plane("split-uneven", "curvature", "One cubic, cut at 1/4, with both parts on [0, 1]: G3, and not C1.",
          ["0,0 1,2 2,2.5 3,2.375", "3,2.375 6,2 9,-4 12,8"], "G3")
    plane("g2-not-g3", "curvature", "Curvatures agree, their derivatives along the arc do not.", ["0,1 1,0 2,0 3,0", "3,0 4,0 5,0 6,1"], "G2")
    plane("g3", "curvature", "The second cubic has the third derivative that G3 asks for, at another speed.",
          ["0,1 1,0 2,0 3,0", "3,0 5,0 7,0 9,-8"], "G3")
    plane("g2-slow", "curvature", "Curvature equal, the second curve is slower by 1e-6: the second derivative is 1e-12 of that of the first.",
          ["0,1 1,0 2,0", "2,0 2.000001,0 2.0000021,1e-12"], "G2")
    plane("jump-far", "curvature", "A curvature jump of 2 percent at coordinates of 1e7.", ["10000000,10000001 10000001,1e7 10000002,1e7", "10000002,1e7 10000003,1e7 10000004,10000001.02"],
          "G1")
    plane("g2-decimals", "curvature", "Equal curvature in decimals that no double holds.", ["0,0.1 0.1,0 0.2,0", "0.2,0 0.5,0 0.9,0.9"], "G2")
    plane("g2-rotated", "curvature", "Equal curvature in the direction (3, 4), at twice the speed.", ["-10,5 -3,-4 0,0", "0,0 6,8 -16,52"], "G2")
    plane("smooth-corner-handles", "curvature", "A cubic with both handles in the corner between two lines: the curvature is 0 at its ends, and no order is lost up to G2.",
          ["-10,0 -5,0", "-5,0 0,0 0,0 0,5", "0,5 0,10"], "G2")
    plane("huge-degree", "curvature", "A curve of degree 12 whose first three points are on the line before it.",
          ["0,0 1,0", "1,0 2,0 3,0 4,1 5,1 6,1 7,1 8,1 9,1 10,1 11,1 12,1 13,0"], "G2")
    plane("circle-by-cubics", "curvature", "Two quarters of a circle by the usual cubics meet where both are mirrored: G2, although neither is an arc.",
          ["1,0 1,0.5522847498 0.5522847498,1 0,1", "0,1 -0.5522847498,1 -1,0.5522847498 -1,0"], "G2")
    plane("line-circle", "curvature", "A line and a quarter of a circle by a cubic, as a rounded rectangle has them: G1 only.",
          ["0,-2 1,-2 2,-2 3,-2", "3,-2 4.1045695,-2 5,-1.1045695 5,0"], "G1")
    plane("two-radii", "curvature", "Quarters of circles with the radii 1 and 2, by cubics, continue each other with a jump of curvature.",
          ["1,0 1,0.5522847498 0.5522847498,1 0,1", "0,1 -1.1045694996,1 -2,0.1045694996 -2,-1"], "G1")

    # ---- C orders: derivatives of the parametrisation.
    plane("c0", "C orders", "Only the point is common, the directions agree but not the lengths: C0, and G1.", ["0,0 1,0", "1,0 3,0 4,1"], "C0", "C3")
    plane("c1", "C orders", "First derivatives agree, second ones do not.", ["0,1 1,0 2,0", "2,0 3,0 4,2"], "C1", "C3")
    plane("c2", "C orders", "Two derivatives agree, the third one does not.", ["0,1 1,0 2,0 3,0", "3,0 4,0 5,0 6,1"], "C2", "C3")
    plane("c3", "C orders", "One cubic, cut in the middle.", ["0,0 1,2 1.5,3 2.125,3", "2.125,3 2.75,3 3.5,2 5,0"], "C3", "C3")
    plane("c0-g2", "C orders", "G2 at three times the speed: the first derivatives differ.", ["0,1 1,0 2,0", "2,0 5,0 8,9"], "C0", "C3")
    plane("c3-stop", "C orders", "(t^2, t^3) on both sides of 0: all derivatives agree, and the curve has a cusp.", ["1,-1 1/3,0 0,0 0,0", "0,0 0,0 1/3,0 1,1"], "C3", "C3",
          only="json")
    plane("c1-nearly", "C orders", "First derivatives (1, 0) and (1, 1e-12).", ["0,0 1,0", "1,0 2,1e-12"], "C0", "C3")
    plane("c-minus", "C orders", "Equal derivatives, but a gap of 1e-10: no order at all.", ["0,0 1,0", "1.0000000001,0 2.0000000001,0"], "gap", "C3")
    plane("c1-domain", "C orders", "Speeds 2 and 1 on parameters [0, 1] and [1, 2]: equal points, C0.", ["0,0 1,0 2,0", "2,0 2.5,0 3,1"], "C0", "C3")
    add("plane/c3-intervals", "curve", "C orders", "The second half of a parabola is twice as long over an interval that is twice as long: C3.",
        [spline(2, "0,1 1,0 2,0", "0 0 0 1 1 1"), spline(2, "2,0 4,0 6,4", "1 1 1 3 3 3")], "C3", "C3")
    add("plane/c1-intervals", "curve", "C orders", "Over intervals of lengths 1 and 2 the first derivatives agree, the second ones do not.",
        [spline(2, "0,1 1,0 2,0", "0 0 0 1 1 1"), spline(2, "2,0 4,0 6,2", "1 1 1 3 3 3")], "C1", "C3")

    # ---- Tolerances, exactly at the bound and beside it.
    G, A, C = "gap", "angle_degrees", "curvature_percent"
    both = lambda gap="0", angle="0", percent="0": {G: gap, A: angle, C: percent}

    def bound(name, why, curves, expect, within, **more):
        plane(name, "tolerances", why, curves, expect, "G2", within=within, **more)
    bound("gap-at-bound", "The gap is exactly the tolerance, 0.001, which is met.", ["0,0 1,0", "1.001,0 2.001,0"], "G2", both("0.001", "0.1", "2"))
    bound("gap-above-bound", "The gap is larger than the tolerance by 1e-18.", ["0,0 1,0", "1.001000000000000001,0 2,0"], "gap", both("0.001", "0.1", "2"))
    bound("gap-below-bound", "The gap is smaller than the tolerance by 1e-18.", ["0,0 1,0", "1.000999999999999999,0 2,0"], "G2", both("0.001", "0.1", "2"))
    bound("gap-345-bound", "The gap (0.0003, 0.0004) is exactly 0.0005 long.", ["0,0 1,0", "1.0003,0.0004 2.0003,0.0004"], "G2", both("0.0005", "0.1", "2"))
    bound("gap-345-above", "The gap (0.0003, 0.0004) is longer than 0.0004999999999999999.", ["0,0 1,0", "1.0003,0.0004 2.0003,0.0004"], "gap",
          both("0.0004999999999999999", "0.1", "2"))
    bound("gap-root-2", "The gap (0.001, 0.001) is 0.0014142135623730950488 long, and the tolerance has the first 16 digits of it.", ["0,0 1,0", "1.001,0.001 2.001,0.001"], "gap",
          both("0.001414213562373095", "0.1", "2"))
    bound("gap-root-2-above", "The gap (0.001, 0.001), and a tolerance that is larger than it by 5e-19.", ["0,0 1,0", "1.001,0.001 2.001,0.001"], "G2",
          both("0.0014142135623730955", "0.1", "2"))
    bound("gap-axis-each", "Each coordinate is within 0.001, the distance is not.", ["0,0 1,0", "1.0009,0.0009 2.0009,0.0009"], "gap", both("0.001", "0.1", "2"))
    bound("angle-45-bound", "A corner of exactly 45 degrees, which is the tolerance.", ["0,0 1,0", "1,0 2,1"], "G2", both("0", "45", "0"))
    bound("angle-45-above", "A corner of 45 degrees, and a tolerance of 44.999999999999999.", ["0,0 1,0", "1,0 2,1"], "G0", both("0", "44.999999999999999", "0"))
    bound("angle-90-bound", "A corner of exactly 90 degrees, which is the tolerance.", ["0,0 1,0", "1,0 1,1"], "G2", both("0", "90", "0"))
    bound("angle-180-bound", "A line that runs back is within 180 degrees.", ["0,0 1,0", "1,0 0,0"], "G2", both("0", "180", "0"))
    bound("angle-below", "The slope 0.0017 is 0.09740 degrees, less than 0.1.", ["0,0 1,0", "1,0 2,0.0017"], "G2", both("0", "0.1", "0"))
    bound("angle-above", "The slope 0.0018 is 0.10313 degrees, more than 0.1.", ["0,0 1,0", "1,0 2,0.0018"], "G0", both("0", "0.1", "0"))
    bound("angle-digits-below", "The slope 1/1000 is 0.0572957604145010... degrees; the tolerance is larger by 1e-15.", ["0,0 1,0", "1,0 2,0.001"], "G2",
          both("0", "0.057295760414502", "0"))
    bound("angle-digits-above", "The slope 1/1000 is 0.0572957604145006... degrees; the tolerance is smaller by 1e-15.", ["0,0 1,0", "1,0 2,0.001"], "G0",
          both("0", "0.057295760414499", "0"))
    bound("angle-zero-tolerance", "A kink of 1e-20, and no tolerance.", ["0,0 1,0", Curve([[F(1), F(0)], [F(2), F(1, 10**20)]])], "G0", both())
    bound("curvature-at-bound", "Curvatures 0.5 and 0.49: exactly 2 percent.", ["0,1 1,0 2,0", "2,0 3,0 4,0.98"], "G2", both("0", "0", "2"))
    bound("curvature-above-bound", "Curvatures 0.5 and 0.49 - 1e-18: more than 2 percent.", ["0,1 1,0 2,0", "2,0 3,0 4,0.979999999999999998"], "G1", both("0", "0", "2"))
    bound("curvature-of-the-larger", "Curvatures 0.5 and 0.51: 1.96 percent of the larger, 2 of the smaller; the part is that of the larger.", ["0,1 1,0 2,0", "2,0 3,0 4,1.02"],
          "G2", both("0", "0", "1.97"))
    bound("curvature-opposite", "Curvatures of one size and opposite signs differ by 200 percent.", ["0,1 1,0 2,0", "2,0 3,0 4,-1"], "G1", both("0", "0", "199.999"))
    bound("curvature-opposite-bound", "Curvatures of one size and opposite signs differ by exactly 200 percent.", ["0,1 1,0 2,0", "2,0 3,0 4,-1"], "G2", both("0", "0", "200"))
    bound("curvature-of-a-line", "A line beside any curve differs by exactly 100 percent.", ["0,0 1,0", "1,0 2,0 3,1e-9"], "G2", both("0", "0", "100"))
    bound("curvature-both-zero", "Two lines: a jump of 0, and no division by 0.", ["0,0 1,0", "1,0 3,0"], "G2", both())
    bound("ladder", "The gap is within its tolerance, the angle is not, the curvature is: G0.", ["0,1 1,0 2,0", "2.0001,0 3.0001,0.01 4.0001,1.02"], "G0",
          both("0.001", "0.1", "50"))
    bound("three-nearly", "Gap, angle and curvature are all off, and all within their tolerances.", ["0,1 1,0 2,0", "2.0001,0 3.0001,0.0001 4.0001,1.0002"], "G2",
          both("0.001", "0.01", "2"))
    bound("stop-within", "A handle in its node: the angle is within the tolerance, the curvature is infinite.", ["0,0 1,0 2,0 3,0", "3,0 3,0 4,0.0001 5,1"], "G1",
          both("0", "0.01", "100"))

    # ---- Space.
    space("line-corner", "tangent", "Two lines along x and z.", ["0,0,0 1,0,0", "1,0,0 1,0,1"], "G0")
    space("kink-out-of-plane", "tangent", "A kink of 1e-5 that the projections along z and along y do not show alike: in xy it is 0.",
          ["0,0,0 1,0,0", "1,0,0 2,0,1e-5"], "G0")
    space("gap-z", "position", "A gap of 1e-9 in z only.", ["0,0,0 1,0,0", "1,0,1e-9 2,0,1e-9"], "gap", "G0")
    space("diagonal", "tangent", "Collinear along (1, 1, 1) in decimals that no double holds.", ["0,0,0 0.1,0.1,0.1", "0.1,0.1,0.1 0.4,0.4,0.4"], "F3")
    space("planes-turn", "curvature", "(t, t^2, 0) and (t, 0, t^2): curvatures have the same size, their planes are perpendicular.",
          ["-1,1,0 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,0,1"], "G1")
    space("planes-turn-little", "curvature", "The plane of curvature turns by 1e-4, its size is equal to 1e-8.", ["-1,1,0 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,1,1e-4"], "G1")
    space("equal-size-345", "curvature", "Curvature vectors (0, 5, 0) and (0, 3, 4) have exactly one length and different directions.",
          ["-1,5,0 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,3,4"], "G1")
    space("opposite", "curvature", "The curvature vector has the other sign.", ["-1,0,1 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,0,-1"], "G1")
    space("g2-out-of-plane", "curvature", "Equal curvature vectors in the direction (0, 3, 4), at half the speed.", ["-1,3,4 -0.5,0,0 0,0,0", "0,0,0 0.25,0,0 0.5,0.75,1"], "F3")
    for k in (2, 4, 8, 12, 16):
        space(f"vector-jump-1e-{k}", "curvature", f"The curvature vector turns by 1e-{k} about the tangent.",
              ["-1,1,0 -0.5,0,0 0,0,0", Curve([[F(0)] * 3, [F(1, 2), F(0), F(0)], [F(1), F(1), F(1, 10**k)]])], "G1")
    twist = "0,0,0 1,0,0 2,1,0 3,3,1"  # torsion at the start: 1/3 * det / ...
    back = "-3,3,-1 -2,1,0 -1,0,0 0,0,0"
    space("torsion-equal", "torsion", "A twisted cubic, turned half about the normal: frame, curvature and torsion agree.", [back, twist], "F3")
    space("torsion-sign", "torsion", "A twisted cubic and its mirror image: all is equal but for the sign of the torsion.", ["-3,3,1 -2,1,0 -1,0,0 0,0,0", twist], "G2")
    space("torsion-plane", "torsion", "A plane curve goes on as a twisted one with equal curvature.", ["-3,3,0 -2,1,0 -1,0,0 0,0,0", twist], "G2")
    for k in (2, 6, 10, 15):
        space(f"torsion-jump-1e-{k}", "torsion", f"The torsion jumps by the part 1e-{k}.",
              [back, Curve([[F(0)] * 3, [F(1), F(0), F(0)], [F(2), F(1), F(0)], [F(3), F(3), 1 + F(1, 10**k)]])], "G2")
    space("f3-not-g3", "torsion", "Torsion is continuous, the derivative of the curvature is not: F3, not G3.", [back, "0,0,0 1,0,0 2,1,0 3,4,1"], "F3")
    space("g3-space", "torsion", "One twisted cubic, cut in the middle.",
          ["0,0,0 0.5,0,0 1,0.25,0 1.5,0.75,0.125", "1.5,0.75,0.125 2,1.25,0.25 2.5,2,0.5 3,3,1"], "G3", "G3")
    space("f3-asked-g3", "torsion", "Torsion is continuous, the third derivatives do not fit: asked for G3, only G2 holds.", [back, "0,0,0 1,0,0 2,1,0 3,4,1"], "G2", "G3")
    space("torsion-fast", "torsion", "Equal torsion at twice the speed.", [back, "0,0,0 2,0,0 4,4,0 6,12,8"], "F3")
    space("torsion-undefined-left", "torsion", "A line has no torsion; its curvature is 0, and so is that of the cubic that follows.", ["-1,0,0 0,0,0", "0,0,0 1,0,0 2,0,0 3,1,1"],
          "G2")
    space("flat-points-turn", "torsion", "Both curvatures are 0 and the planes turn: (t, t^4, 0) and (t, 0, t^4) are even G3.",
          ["-4,256,0 -3,0,0 -2,0,0 -1,0,0 0,0,0", "0,0,0 1,0,0 2,0,0 3,0,0 4,0,256"], "F3")
    space("zero-handle", "tangent", "A handle in its node, in space.", ["-1,0,0 0,0,0", "0,0,0 0,0,0 1,0,0 2,1,1"], "G1", "G1")
    space("cusp", "tangent", "Tangents opposite in space.", ["-1,1,0 0,0,1 0,0,0", "0,0,0 0,0,1 1,1,0"], "G0")
    space("c2", "C orders", "Two derivatives agree, the third one does not.", [back, "0,0,0 1,0,0 2,1,0 3,4,1"], "C2", "C3")
    space("c1", "C orders", "First derivatives agree, second ones differ in z.", ["-1,1,0 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,1,1e-6"], "C1", "C3")
    space("c3", "C orders", "One twisted cubic, cut in the middle.",
          ["0,0,0 0.5,0,0 1,0.25,0 1.5,0.75,0.125", "1.5,0.75,0.125 2,1.25,0.25 2.5,2,0.5 3,3,1"], "C3", "C3")
    space("tiny-unit", "curvature", "In units of 1e-9, the curvature vector turns by a right angle.", ["-1e-9,1e-9,0 -5e-10,0,0 0,0,0", "0,0,0 5e-10,0,0 1e-9,0,1e-9"], "G1")
    space("huge-unit", "torsion", "In units of 1e9, the torsion has the other sign.", ["-3e9,3e9,1e9 -2e9,1e9,0 -1e9,0,0 0,0,0", "0,0,0 1e9,0,0 2e9,1e9,0 3e9,3e9,1e9"], "G2")
    space("gap-345-bound", "tolerances", "The gap (0, 0.0003, 0.0004) is exactly 0.0005 long.", ["0,0,0 1,0,0", "1,0.0003,0.0004 2,0.0003,0.0004"], "G2", "G2",
          within=both("0.0005", "0.1", "2"))
    space("angle-60-bound", "tolerances", "(1, 1, 0) and (1, 0, 1) include exactly 60 degrees.", ["0,0,0 1,1,0", "1,1,0 2,1,1"], "G0", "G2", within=both("0", "59.9999999999999", "0"))
    space("vector-at-bound", "tolerances", "Curvature vectors (0, 5, 0) and (0, 3, 4) differ by 2 / root 5 of their size, 89.44 percent.",
          ["-1,5,0 -0.5,0,0 0,0,0", "0,0,0 0.5,0,0 1,3,4"], "G1", "G2", within=both("0", "0", "89.4427190999915"))

    # ---- Rational curves.
    quarter = "1,0 1,1 0,1"
    rational("half-circle", "curvature", "Two quarters of a circle as rational quadratics: G3, though first derivatives depend on weights.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "2 1 1")], "G3", only=("json", "g2", "step"))
    rational("quarters-alike", "curvature", "Two quarters of a circle with the same weights: the speeds at the join differ, the circle goes on.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "1 1 2")], "G3")
    rational("quarters-alike-c", "C orders", "The same quarters: speeds 1 and 2 at the join, so that only C0 holds.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "1 1 2")], "C0", "C3")
    rational("common-factor", "C orders", "All weights of the second arc are three times as large, which changes nothing: C3 with the mirrored arc.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "6 3 3")], "C1", "C3")
    rational("line-arc", "curvature", "A line that touches an arc: curvature from 0 to 1.", ["1,-2 1,0", (quarter, "1 1 2")], "G1")
    rational("arc-radius-2", "curvature", "Arcs of radius 1 and 2 that touch from inside.", [(quarter, "1 1 2"), ("0,1 -2,1 -2,-1", "1 1 2")], "G1")
    rational("arc-s", "curvature", "Arcs of radius 1 that touch from outside: equal magnitudes, opposite sides.", [(quarter, "1 1 2"), ("0,1 -1,1 -1,2", "1 1 2")], "G1")
    rational("arc-radius-nearly", "curvature", "Arcs of radius 1 and 1.000000001.", [(quarter, "1 1 2"), ("0,1 -1.000000001,1 -1.000000001,-0.000000001", "1 1 2")], "G1")
    rational("arc-kink", "tangent", "Arcs whose tangents differ by 1e-8.", [(quarter, "1 1 2"), ("0,1 -1,1.00000001 -1,0", "2 1 1")], "G0")
    rational("arc-gap", "position", "Arcs that are apart by 1e-8.", [(quarter, "1 1 2"), ("0,1.00000001 -1,1.00000001 -1,0", "2 1 1")], "gap", "G0")
    rational("weights-geometric", "curvature", "The weights of the second half are multiplied by 1, 2, 4: another parameter of the same arc, so G3.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "2 2 4")], "G3")
    rational("weight-moves-curvature", "curvature", "The middle weight of the second arc is 2 instead of 1: tangents agree, the curvature is another one.",
             [(quarter, "1 1 2"), ("0,1 -1,1 -1,0", "2 2 1")], "G1")
    rational("weight-tiny", "curvature", "Weights 1, 1e-6, 1: the curvature at the ends is 1e12, and it is equal on both sides.",
             [("0,1 1,0 2,0", "1 1e-6 1"), ("2,0 3,0 4,1", "1 1e-6 1")], "G2")
    rational("weight-huge", "curvature", "Weights 1, 1e6, 1: curvatures of 5e-13, which differ by a part of 1e-6.",
             [("0,1 1,0 2,0", "1 1e6 1"), ("2,0 3,0 4,1.000001", "1 1e6 1")], "G1")
    rational("all-weights-equal", "curvature", "A rational curve whose weights are all 2 is the polynomial one.", [("0,1 1,0 2,0", "2 2 2"), "2,0 3,0 4,1"], "G3")
    rational("polynomial-points-rational", "curvature", "Control points as of a G2 join, and one weight that spoils it.", [("0,1 1,0 2,0", "1 1 1"), ("2,0 3,0 4,1", "1 1 3")], "G1")
    rational("points-off-curvature-equal", "curvature", "Control points of different curvature, which the weights make equal.",
             [("0,1 1,0 2,0", "1 1 1"), ("2,0 3,0 4,3", "3 3 1")], "G2")
    rational("parabola-ellipse", "curvature", "A parabola and a quarter of an ellipse, with equal curvature at its vertex.", ["-4,8 -2,0 0,0", ("0,0 2,0 2,1", "2 2 1")], "G1")
    rational("cubic-weights", "curvature", "Rational cubics with equal curvature and different third derivatives.",
             [("0,1 1,0.5 2,0 3,0", "1 2 1 1"), ("3,0 4,0 5,0.5 6,1", "1 1 2 1")], "G2")
    rational("helix-like", "torsion", "Rational cubics in space that are each other's image: torsion agrees.", [("-3,3,-1 -2,1,0 -1,0,0 0,0,0", "2 1 1 1"), ("0,0,0 1,0,0 2,1,0 3,3,1", "1 1 1 2")],
             "F3", "F3")
    rational("torsion-weight", "torsion", "One weight of the last control point makes the torsion another one.", [("-3,3,-1 -2,1,0 -1,0,0 0,0,0", "2 1 1 1"), ("0,0,0 1,0,0 2,1,0 3,3,1", "1 1 1 3")],
             "G2", "F3")
    rational("circle-tolerance", "tolerances", "Arcs of radius 1 and 50/49: exactly 2 percent.", [(quarter, "1 1 2"), ("0,1 -50/49,1 -50/49,-1/49", "1 1 2")], "G2", "G2",
             within=both("0", "0", "2"), only="json")
    rational("circle-tolerance-above", "tolerances", "Arcs of radius 1 and 1.021: 2.06 percent.", [(quarter, "1 1 2"), ("0,1 -1.021,1 -1.021,-0.021", "1 1 2")], "G1", "G2",
             within=both("0", "0", "2"))
    circle = "1,0 1,1 0,1 -1,1 -1,0 -1,-1 0,-1 1,-1 1,0"
    add("rational/closed-circle", "curve", "curvature", "A whole circle as a rational spline with double knots, with weights that are rational: G3 at each knot and where it closes.",
        [spline(2, circle, "0 0 0 1 1 2 2 3 3 4 4 4", "1 1 2 2 4 4 8 8 16")], "G3", "G3", closed=True)
    add("rational/circle-dented", "curve", "curvature", "A circle as a rational spline; one weight is 1 instead of 2, so that the curvature jumps at its knots.",
        [spline(2, circle, "0 0 0 1 1 2 2 3 3 4 4 4", "1 1 2 1 4 4 8 8 16")], "G1", "G3", closed=True)
    add("rational/spline-simple-knot", "curve", "C orders", "A rational quadratic spline with a simple inner knot is C1.", [spline(2, "0,0 1,1 2,0 3,1", "0 0 0 1 2 2 2", "1 2 1 1")], "C1", "C3")

    # ---- Splines with all kinds of knots: the joins are inner knots.
    splines("cubic-simple", "C orders", "A cubic spline with a simple inner knot: C2 by its knots.", [(3, "0,0 1,2 2,-1 3,3 4,0", "0 0 0 0 1 2 2 2 2")], "C2", "C3")
    splines("cubic-double", "C orders", "A double inner knot: C1 by its knots, and no more.", [(3, "0,0 1,2 2,-1 3,3 4,0 5,1", "0 0 0 0 1 1 2 2 2 2")], "C1", "C3")
    splines("cubic-double-c2", "C orders", "A double inner knot, and points for which C2 holds although the knots promise only C1.",
            [(3, "0,0 1,0 2,2 4,3 5,2 6,0", "0 0 0 0 1 1 2 2 2 2")], "C2", "C3")
    splines("cubic-triple", "tangent", "A triple inner knot, whose neighbours make a corner.", [(3, "0,0 1,0 2,0 3,0 3,1 4,2 5,2", "0 0 0 0 1 1 1 2 2 2 2")], "G0")
    splines("cubic-triple-g1", "curvature", "A triple knot with collinear neighbours at different distances: C0, G1.", [(3, "0,1 1,0.5 2,0 3,0 5,0 6,3 7,3", "0 0 0 0 1 1 1 2 2 2 2")],
            "G1")
    splines("cubic-triple-g2", "curvature", "A triple knot that is G2 and not C1.", [(3, "0,4 1,1.5 2,0 4,0 5,0 5.5,0.375 7,1", "0 0 0 0 1 1 1 2 2 2 2")], "G2")
    splines("cubic-triple-c3", "C orders", "A triple knot inside of one cubic: C3, although the knots promise C0.", [(3, "0,0 1,2 1.5,3 2.125,3 2.75,3 3.5,2 5,0", "0 0 0 0 1 1 1 2 2 2 2")], "C3", "C3")
    splines("quadruple", "position", "A knot as often as the order: the spline breaks, here by 1e-9.", [(3, "0,0 1,0 2,0 3,0 3.000000001,0 4,0 5,0 6,0", "0 0 0 0 1 1 1 1 2 2 2 2")], "gap", "G0")
    splines("quadruple-meets", "position", "A knot as often as the order, where both points are equal.", [(3, "0,0 1,0 2,0 3,0 3,0 4,0 5,0 6,0", "0 0 0 0 1 1 1 1 2 2 2 2")], "G3")
    splines("quadratic-simple", "curvature", "A quadratic spline with a simple knot is C1, and its curvature jumps.", [(2, "0,1 1,0 2,0 3,3", "0 0 0 1 2 2 2")], "G1")
    splines("quadratic-one-parabola", "curvature", "A quadratic spline with a knot in the vertex of a parabola: G3.", [(2, "0,1 1,0 3,0 4,1", "0 0 0 1 2 2 2")], "G3")
    splines("linear-collinear", "tangent", "A polyline of three collinear points.", [(1, "0,0 1,1 3,3", "0 0 1 2 2")], "G3")
    splines("linear-kink", "tangent", "A polyline that turns by 1e-9.", [(1, "0,0 1,0 2,1e-9", "0 0 1 2 2")], "G0")
    splines("uneven-knots", "C orders", "Knots 0, 1, 1000: C2 over intervals of lengths 1 and 999.", [(3, "0,0 1,2 2,-1 3,3 4,0", "0 0 0 0 1 1000 1000 1000 1000")], "C2", "C3")
    splines("tiny-span", "curvature", "A span of 1e-9 between knots: its curves are real, and so are their joins.", [(3, "0,0 1,2 2,-1 3,3 4,0 5,2", "0 0 0 0 1 1.000000001 2 2 2 2")], "G2")
    splines("knots-nearly-equal", "tangent", "Two knots that differ by 1e-12 in place of a double one: the corner of the polygon is cut in 1e-12.",
            [(2, "0,0 1,0 2,0 2,1 2,2", "0 0 0 1 1.000000000001 2 2 2")], "G1")
    splines("knots-equal", "tangent", "A double knot of degree 2: the polygon has a corner there, and so has the curve.", [(2, "0,0 1,0 2,0 2,1 2,2", "0 0 0 1 1 2 2 2")], "G0")
    splines("unclamped", "C orders", "Uniform knots without repetition: the domain begins at the fourth, and all joins are C2.", [(3, "0,0 1,2 2,-1 3,3 4,0 5,1", "0 1 2 3 4 5 6 7 8 9")], "C2", "C3")
    splines("decimal-knots", "C orders", "Knots 0.1, 0.2, 0.3, which no double holds: C2 all the same.", [(3, "0,0 1,2 2,-1 3,3 4,0 5,1", "0.1 0.1 0.1 0.1 0.2 0.3 0.4 0.4 0.4 0.4")], "C2", "C3")
    splines("negative-knots", "C orders", "Knots -3, -1, 0.", [(3, "0,0 1,2 2,-1 3,3 4,0", "-3 -3 -3 -3 -1 0 0 0 0")], "C2", "C3")
    splines("quintic-triple", "curvature", "Degree 5 and a triple knot: C2, G2 and no more.", [(5, "0,0 1,0 2,1 3,0 4,2 5,0 6,1 7,3 8,0", "0 0 0 0 0 0 1 1 1 2 2 2 2 2 2")], "G2")
    splines("quintic-quadruple", "curvature", "Degree 5 and a knot of multiplicity 4: C1, and the curvature jumps.", [(5, "0,0 1,0 2,1 3,0 4,2 5,0 6,1 7,3 8,0 9,1", "0 0 0 0 0 0 1 1 1 1 2 2 2 2 2 2")], "G1")
    splines("two-splines", "tangent", "Two splines that meet at their ends with a kink of 0.06 degrees, and are smooth inside.",
            [(3, "0,0 1,2 2,1 3,0 4,0", "0 0 0 0 1 2 2 2 2"), (3, "4,0 5,0.001 6,1 7,3 8,0", "0 0 0 0 1 2 2 2 2")], "G0")
    splines("coincident-points", "tangent", "Two equal control points at a simple knot of degree 2: the curve stops there, and turns by a right angle.", [(2, "0,0 1,0 1,0 1,1", "0 0 0 1 2 2 2")], "G0", "G2")
    splines("space-torsion", "torsion", "A cubic spline in space with a simple knot: C2, and its torsion jumps.", [(3, "0,0,0 1,2,0 2,-1,1 3,3,2 4,0,5", "0 0 0 0 1 2 2 2 2")], "G2", "F3")
    splines("space-quartic", "torsion", "A quartic spline in space with a simple knot is C3: torsion is continuous.", [(4, "0,0,0 1,2,0 2,-1,1 3,3,2 4,0,5 5,1,1", "0 0 0 0 0 1 2 2 2 2 2")], "G3", "G3")
    splines("within-knot", "tolerances", "A kink of 0.0573 degrees at a triple knot, with a tolerance of 0.1.", [(3, "0,1 1,0 2,0 3,0 4,0.001 5,0.001 6,0", "0 0 0 0 1 1 1 2 2 2 2")], "G1", "G2",
            within=both("0", "0.1", "2"))
