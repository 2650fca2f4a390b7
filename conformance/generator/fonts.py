# SPDX-License-Identifier: CC0-1.0
"""Fonts whose letter A has a contour with one join in question: all others are G2 by symmetry, or
smooth."""

from fractions import Fraction as F
from itertools import product

from font_files import bounds, compact, true_type
from truth import Curve, degrees, enclosure, exact, text


def outline(contour):
    """The curves of a contour of TrueType: between two points off the curve lies one on it."""
    full = []
    for i, (x, y, on) in enumerate(contour):
        before = contour[i - 1]
        if not on and not before[2]:
            full.append((F(x + before[0]) / 2, F(y + before[1]) / 2, 1))
        full.append((F(x), F(y), on))
    k = next(i for i, p in enumerate(full) if p[2])
    full = full[k:] + full[: k + 1]
    chain, points = [], [full[0]]
    for p in full[1:]:
        points.append(p)
        if p[2]:
            if any(q[:2] != points[0][:2] for q in points):
                chain.append(Curve([q[:2] for q in points]))
            points = [p]
    return chain


def cubics(start, *legs):
    """The curves of relative legs as in a charstring: two numbers are a line, six a cubic."""
    at, chain = [F(start[0]), F(start[1])], []
    for leg in legs:
        points = [list(at)]
        for i in range(0, len(leg), 2):
            at = [at[0] + F(leg[i]), at[1] + F(leg[i + 1])]
            points.append(list(at))
        chain.append(Curve(points))
    return chain


def largest_kink(points, moved, tuples, axes):
    """Where the angle at the second of three points is largest over the unit box of axis values: found by
    a search in steps that become smaller. The checker proves that there is none larger."""
    def weight(t, w):
        total = F(1)
        for p, x, a, b in zip(t[0], w, t[1] or [0] * axes, t[2] or t[0]):
            if p:
                a, b, p = F(a), F(b), F(p)
                total *= 0 if x <= a or (x >= b and b != p) else (x - a) / (p - a) if x <= p else (b - x) / (b - p)
        return total

    def handles(w):
        at = [[F(x), F(y)] for x, y in points]
        for t, moves in zip(tuples, moved):
            k = weight(t, w)
            at = [[a[0] + k * m[0], a[1] + k * m[1]] for a, m in zip(at, moves)]
        return [at[1][0] - at[0][0], at[1][1] - at[0][1]], [at[2][0] - at[1][0], at[2][1] - at[1][1]]

    def size(w):
        u, v = handles(w)
        return abs(u[0] * v[1] - u[1] * v[0]) / (u[0] * v[0] + u[1] * v[1])
    best = max(product([F(i, 8) for i in range(9)], repeat=axes), key=size)
    step = F(1, 16)
    while step > F(1, 2**24):
        near = [w for w in product(*([x - step, x, x + step] for x in best)) if all(0 <= x <= 1 for x in w)]
        better = max(near, key=size)
        if size(better) > size(best):
            best = better
        else:
            step /= 2
    return best, handles(best)


def cases(suite):
    add = suite.add

    def true(name, question, why, contours, expect, component=None, of=0, **more):
        """`of` is the contour in question."""
        m = component or (1, 0, 0, 1)
        turned = [(m[0] * F(x) + m[2] * F(y), m[1] * F(x) + m[3] * F(y), on) for x, y, on in contours[of]]
        add("font/" + name, "font", question, why, outline(turned), expect, "G2", closed=True, files={"ttf": true_type(contours, component=component, **more)})

    def cubic(name, question, why, start, legs, expect, words=None, **more):
        chain = cubics(start, *legs)
        if words is None:
            words = list(start) + ["rmoveto"]
            for leg in legs:
                words += list(leg) + ["rlineto" if len(leg) == 2 else "rrcurveto"]
            words.append("endchar")
        points = [[(int(x), int(y)) for x, y in c.points] for c in chain]
        add("font/" + name, "font", question, why, chain, expect, "G2", closed=True, files={"otf": compact(words, bounds(points), **more)})

    rest = [(400, 0, 0), (400, 400, 0), (0, 400, 0)]

    def blob(x, y, begin=(0, 0, 0)):
        """A round form of parabolas, and one point on its curve that may be off."""
        return [[begin, (x, y, 1)] + rest]
    true("implied", "curvature", "All points on the curve are implied: mirrored parabolas, G2.", [[(0, 0, 0)] + rest], "G2")
    true("in-the-middle", "curvature", "A point on the curve in the middle of its handles, as if it were implied.", blob(200, 0), "G2")
    true("off-the-middle", "curvature", "A point on the curve between its handles, but not in the middle: the curvature jumps.", blob(150, 0), "G1")
    true("one-unit", "tangent", "A point that is off by one unit: a kink of 0.57 degrees.", blob(200, 1), "G0")
    true("one-unit-far", "tangent", "One unit of 16384: a kink of 0.014 degrees.", [[(0, 0, 0), (8000, 1, 1), (16000, 0, 0), (16000, 16000, 0), (0, 16000, 0)]], "G0", em=16384)
    true("kink-1.7", "tangent", "A kink of 1.72 degrees: smooth for a tolerance of 0.05 radians.", blob(200, 3), "G0")
    true("kink-2.9", "tangent", "A kink of 2.86 degrees: 0.04999 radians.", blob(200, 5), "G0")
    true("kink-3.4", "tangent", "A kink of 3.44 degrees: 0.06 radians.", blob(200, 6), "G0")
    true("kink-dented", "tangent", "The point lies outside, so that the contour is dented by 0.57 degrees.", blob(200, -1), "G0")
    true("corner", "tangent", "A meant corner of 90 degrees.", [[(0, 0, 1)] + rest], "G0")
    true("cusp", "tangent", "Both handles on one side of the point: a cusp.", [[(300, 0, 0), (200, 0, 1), (400, 0, 0), (400, 400, 0), (0, 400, 0)]], "G0")
    true("line-touches", "curvature", "A line that goes on in a curve without a kink.", [[(0, 200, 0), (0, 0, 1), (0, -100, 1), (0, -300, 0), (400, -300, 0), (400, 400, 0), (0, 400, 0)]], "G1")
    true("line-kinks", "tangent", "A line that meets a curve at an angle of 0.57 degrees.",
         [[(1, 200, 0), (0, 100, 1), (0, -100, 1), (0, -300, 0), (400, -300, 0), (400, 400, 0), (1, 400, 0)]], "G0")
    true("point-on-a-line", "tangent", "A point inside of a straight line.", [[(0, 200, 0), (0, 0, 1), (0, -50, 1), (0, -100, 1), (0, -300, 0), (400, -300, 0), (400, 400, 0), (0, 400, 0)]], "G1")
    true("bend", "tangent", "Two lines that bend by one unit.", [[(0, 200, 0), (0, 0, 1), (1, -50, 1), (2, -101, 1), (2, -300, 0), (400, -300, 0), (400, 400, 0), (0, 400, 0)]], "G0")
    true("two-equal-points", "tangent", "A point twice: what lies between is left out.", [[(0, 0, 0), (200, 0, 1), (200, 0, 1)] + rest], "G2")
    true("inflection", "curvature", "The curvature has one size and changes its sign.",
         [[(0, 0, 1), (100, 100, 0), (200, 0, 1), (300, -100, 0), (400, 0, 1), (500, 100, 0), (500, 400, 0), (-100, 400, 0), (-100, -100, 0)]], "G1")
    true("component", "tangent", "A component that is flattened to an eighth: a kink of 4.58 degrees becomes one of 0.57.", blob(200, 8), "G0", component=(1, 0, 0, F(1, 8)))
    true("component-mirrored", "curvature", "A mirrored component: G2 as before.", blob(200, 0), "G2", component=(-1, 0, 0, 1))
    true("second-contour", "tangent", "The kink is in the second contour.", [[(0, 0, 0)] + rest, [(100, 100, 0), (200, 101, 1), (300, 100, 0), (300, 300, 0), (100, 300, 0)]], "G0", of=1)
    true("starts-off-the-curve", "tangent", "The contour begins with a point off the curve; the kink is at the last point.", [rest[:2] + [(0, 400, 0), (0, 0, 0), (200, 2, 1)]], "G0")

    k = 100
    oval = [(k, 0, k, k, 0, k), (0, k, -k, k, -k, 0), (-k, 0, -k, -k, 0, -k), (0, -k, k, -k, k, 0)]

    def changed(first, last=oval[3]):
        return [first] + oval[1:3] + [last]
    cubic("cubic-round", "curvature", "Mirrored cubics: G2.", (200, 0), oval, "G2")
    cubic("cubic-handle-longer", "curvature", "One handle is longer: the curvature jumps.", (200, 0), changed((120, 0, 80, 100, 0, 100)), "G1")
    cubic("cubic-one-unit", "tangent", "One handle is off by one unit: a kink of 0.57 degrees.", (200, 0), changed((100, 1, 100, 99, 0, 100)), "G0")
    cubic("cubic-kink-1.7", "tangent", "A handle that is off by three units: 1.72 degrees.", (200, 0), changed((100, 3, 100, 97, 0, 100)), "G0")
    cubic("cubic-one-65536th", "tangent", "A handle that is off by the smallest fraction of a charstring: 8.7e-6 degrees.", (200, 0),
          changed((100, F(1, 65536), 100, 100 - F(1, 65536), 0, 100)), "G0")
    cubic("cubic-zero-handle", "tangent", "A handle in its node; the next one shows the tangent.", (200, 0), changed((0, 0, 200, 0, 0, 200)), "G1")
    cubic("cubic-closing-line", "tangent", "The charstring ends before its start: the line that closes it continues the last curve.", (200, 0), oval[:3] + [(0, -k, k, -k, k - 10, 0), (10, 0)], "G1",
          words=[200, 0, "rmoveto"] + [x for leg in oval[:3] for x in leg] + [0, -k, k, -k, k - 10, 0, "rrcurveto", "endchar"])
    alternating = [200, 0, "rmoveto", k, k, k, k, k, -k, k, -k, -k, -k, -k, -k, -k, k, -k, k, "hvcurveto", "endchar"]
    cubic("cubic-alternating", "curvature", "hvcurveto writes curves that begin and end along the axes alternately.", (200, 0), oval, "G2", words=alternating)
    cubic("cubic-subroutine", "tangent", "The curve with the kink is in a subroutine.", (200, 0), changed((100, 1, 100, 99, 0, 100)), "G0",
          words=[200, 0, "rmoveto", -107, "callsubr"] + [x for leg in oval[1:] for x in leg] + ["rrcurveto", "endchar"], subroutine=[100, 1, 100, 99, 0, 100, "rrcurveto", "return"])
    bump = [30, 0, 20, 1, 50, 1, 50, -1, 20, -1, 30, 0]
    cubic("cubic-flex", "tangent", "flex joins two cubics, here with a kink of 2.29 degrees where they meet.", (200, 0),
          [bump[:6], bump[6:], (k, 0, k, k, 0, k), (0, k, -k, k, -k, 0), (-60, 0, -80, 0, -60, 0), (-k, 0, -k, -k, 0, -k), (0, -k, k, -k, k, 0)], "G0",
          words=[200, 0, "rmoveto"] + bump + [50, "flex", k, 0, k, k, 0, k, 0, k, -k, k, -k, 0, -60, 0, -80, 0, -60, 0, -k, 0, -k, -k, 0, -k,
                 0, -k, k, -k, k, 0, "rrcurveto", "endchar"])

    # ---- Variable fonts: the order that holds at every instance.
    def variable(name, why, points, tuples, expect, axes=("wght",), written=None):
        """Three points are in question: a handle, its node, the other handle. Each tuple has a peak, begin and end or None, and their
        three moves; `written` are the moves in the file, if points without a move are to be inferred."""
        contour = [(*points[0], 0), (*points[1], 1), (*points[2], 0), (400, 400, 0), (0, 400, 0)]
        in_file = [(*t[:3], written or list(t[3]) + [(0, 0), (0, 0)]) for t in tuples]
        at, (u, v) = largest_kink(points, [t[3] for t in tuples], tuples, len(axes))
        kink = degrees(u, v)
        if exact(kink[1]):
            kink = enclosure(exact(kink[0]), exact(kink[1]) * (1 + F(1, 2 * 10**9)))
        reached = "G0" if exact(kink[1]) else "G1"
        if reached != expect:
            suite.problems.append(f"font/{name}: {expect} expected, {reached} computed, {kink} at {at}")
        measures = {"gap": ["0", "0"], "angle_degrees": kink, "curvature_jump": None, "curvature_percent": None, "torsion_jump": None}
        suite.record("font/variable-" + name, "variable font", "tangent", why, reached, "G1", measures,
                     {"ttf": true_type([contour], axes=axes, tuples=in_file)}, at={a: text(x) for a, x in zip(axes, at)})

    one = ((1,), None, None)
    flat = [(0, 0), (200, 0), (300, 0)]
    variable("longer", "Handles become longer and keep their direction: smooth at every instance.", flat, [(*one, [(-100, 0), (0, 0), (100, 0)])], "G1")
    variable("between", "Both masters are smooth, with ratios of 1/2 and 2 and another direction: the instances between them kink.", flat,
             [(*one, [(100, -100), (0, 0), (100, 200)])], "G0")
    variable("one-ratio", "The direction changes, the ratio of the handles does not: smooth at every instance.", flat, [(*one, [(100, -100), (0, 0), (-50, 50)])], "G1")
    variable("one-direction", "The ratio changes, the direction does not: smooth at every instance.", flat, [(*one, [(50, 0), (0, 0), (99, 0)])], "G1")
    variable("between-little", "Both masters are smooth, and turn by so little that the instances kink by 0.0004 degrees.",
             [(0, 0), (2000, 0), (4001, 0)], [(*one, [(0, -2), (0, 0), (0, 2)])], "G0")
    variable("master", "The default is smooth, the other master is off by one unit.", flat, [(*one, [(0, 0), (0, 0), (0, 1)])], "G0")
    variable("default", "The default kinks by 0.57 degrees, the other master is smooth.", [(0, 0), (200, 0), (300, 1)], [(*one, [(0, 0), (0, 0), (0, -1)])], "G0")
    variable("middle", "Both ends of the axis are smooth; a master in the middle moves the node by two units.", [(0, 0), (200, 0), (400, 0)],
             [((F(1, 2),), (0,), (1,), [(0, 0), (0, 2), (0, 0)])], "G0")
    variable("two-axes", "Each axis alone keeps the node smooth, both together do not: the kink is largest where both end.", [(0, 0), (200, 0), (400, 0)],
             [((1, 0), None, None, [(0, 0), (0, 0), (100, 0)]), ((0, 1), None, None, [(0, -50), (0, 0), (0, 50)])], "G0", axes=("wght", "wdth"))
    variable("two-axes-mended", "The same two axes, with a master where both end: smooth at every instance.", [(0, 0), (200, 0), (400, 0)],
             [((1, 0), None, None, [(0, 0), (0, 0), (100, 0)]), ((0, 1), None, None, [(0, -50), (0, 0), (0, 50)]), ((1, 1), None, None, [(0, 0), (0, 0), (0, 25)])], "G1",
             axes=("wght", "wdth"))
    variable("two-axes-inside", "Smooth where each axis ends and where both end, and whenever one axis is at an end; only inside it kinks.", [(0, 0), (200, 0), (500, 0)],
             [((1, 0), None, None, [(0, 0), (0, 0), (-200, 0)]), ((0, 1), None, None, [(0, 0), (0, 0), (-200, 0)]), ((1, 1), None, None, [(0, -200), (0, 0), (200, 100)])], "G0",
             axes=("wght", "wdth"))
    variable("inferred", "Only the node has a move; that of the others is inferred from it: the whole contour is moved.", flat,
             [(*one, [(0, 10), (0, 10), (0, 10)])], "G1", written={1: (0, 10)})
