# SPDX-License-Identifier: CC0-1.0
"""Pairs of patches along a whole edge, and models of several patches."""

import json
from fractions import Fraction as F

import brep
import step
from truth import Curve, add, degrees, dot, enclosure, exact, is_decimal, multiply, plus, root, shifted, text, basis


def number_grid(rows):
    return [[[exact(x) for x in p.split(",")] for p in row.split()] for row in rows]


class Patch:
    """Rows of points; the first index is that of u."""

    def __init__(self, points, u=None, v=None, weights=None, degrees=None):
        self.points = number_grid(points) if isinstance(points[0], str) else points
        m, n = len(self.points) - 1, len(self.points[0]) - 1
        self.degrees = degrees or (m, n)
        bezier = lambda d: [F(0)] * (d + 1) + [F(1)] * (d + 1)
        self.u = [exact(t) for t in u.split()] if u else bezier(self.degrees[0])
        self.v = [exact(t) for t in v.split()] if v else bezier(self.degrees[1])
        self.weights = [[exact(w) for w in row.split()] for row in weights] if weights else None

    def homogeneous(self):
        w = self.weights or [[F(1)] * len(row) for row in self.points]
        return [[[x * w[i][j] for x in p] + [w[i][j]] for j, p in enumerate(row)] for i, row in enumerate(self.points)]

    def rows_at(self, knot, from_left):
        """Control points in v of the surface and of its two derivatives by u, at a knot."""
        grid = self.homogeneous()
        result = [[], [], []]
        for j in range(len(grid[0])):
            column = Curve([row[j] for row in grid], self.u, None, self.degrees[0])
            span = next(k for k in column.spans() if column.knots[k + 1 if from_left else k] == knot)
            jet = column.jet(span, from_left, 2)
            for k in range(3):
                result[k].append(jet[k])
        return result

    def polynomials(self, row, span):
        total = [[F(0)] for _ in range(4)]
        for j in range(span - self.degrees[1], span + 1):
            b = basis(self.v, self.degrees[1], span, j)
            total = [add(t, [row[j][c] * x for x in b]) for c, t in enumerate(total)]
        return total

    def swapped(self):
        flip = lambda g: [list(c) for c in zip(*g)]
        result = Patch(flip(self.points), degrees=self.degrees[::-1])
        result.u, result.v, result.weights = self.v, self.u, flip(self.weights) if self.weights else None
        return result

    def reversed_u(self):
        result = Patch(self.points[::-1], degrees=self.degrees)
        result.u, result.v = [self.u[0] + self.u[-1] - t for t in self.u[::-1]], self.v
        result.weights = self.weights[::-1] if self.weights else None
        return result

    def reversed_v(self):
        return self.swapped().reversed_u().swapped()

    def boundary(self, edge):
        """A curve with increasing parameter."""
        which = 0 if edge[1] == "0" else -1
        pick = (lambda g: g[which]) if edge[0] == "u" else (lambda g: [row[which] for row in g])
        knots, degree = (self.v, self.degrees[1]) if edge[0] == "u" else (self.u, self.degrees[0])
        return Curve(pick(self.points), knots, pick(self.weights) if self.weights else None, degree)


# ---- Polynomials in v.
def trimmed(a):
    while a and a[-1] == 0:
        a = a[:-1]
    return a


def minus(a, b):
    return trimmed(add(a, [-x for x in b]))


def differentiated(a):
    return [k * x for k, x in enumerate(a)][1:] or [F(0)]


def determinant4(rows):
    """Returns the determinant of polynomials, by the first row."""
    if len(rows) == 1:
        return rows[0][0]
    total = [F(0)]
    for k, x in enumerate(rows[0]):
        minor = determinant4([r[:k] + r[k + 1 :] for r in rows[1:]])
        total = add(total, [(-1) ** k * c for c in multiply(x, minor)])
    return trimmed(total) or [F(0)]


def normal(p, along, across):
    """The vector normal to the surface times a power of the weight, from homogeneous polynomials."""
    result = []
    for k in range(3):
        rows = [[x for i, x in enumerate(v) if i != k] for v in (p, along, across)]
        result.append([(-1) ** k * c for c in determinant4(rows)])
    return result


def is_zero(a):
    return not trimmed(a)


def value(a, t):
    return sum(c * t**k for k, c in enumerate(a))


def is_positive(a, low, high, depth=0):
    """On an interval, by the coefficients of Bernstein and subdivision."""
    s = shifted(a, low)
    h = high - low
    n = len(s) - 1
    scaled = [c * h**k for k, c in enumerate(s)]
    from math import comb
    coefficients = [sum(F(comb(i, k), comb(n, k)) * scaled[k] for k in range(i + 1)) for i in range(n + 1)]
    if min(coefficients) > 0:
        return True
    if coefficients[0] <= 0 or coefficients[-1] <= 0 or depth > 40:
        return False
    middle = (low + high) / 2
    return value(a, middle) > 0 and is_positive(a, low, middle, depth + 1) and is_positive(a, middle, high, depth + 1)


def quotient_jet(p, across, more, t):
    """S, S_v, S_u, S_vv, S_uv, S_uu at a point, from the homogeneous polynomials of P, P_u and P_uu in v."""
    point = lambda a: [value(x, t) for x in a]
    d = lambda a: [differentiated(x) for x in a]
    h = {"": point(p), "v": point(d(p)), "u": point(across), "vv": point(d(d(p))), "uv": point(d(across)), "uu": point(more)}
    w = {k: x[3] for k, x in h.items()}
    s = {"": [x / w[""] for x in h[""][:3]]}
    for a in "vu":
        s[a] = [(x - w[a] * y) / w[""] for x, y in zip(h[a][:3], s[""])]
    for a, b in ("vv", "uv", "uu"):
        s[a + b] = [(x - w[a] * y - w[b] * z - w[a + b] * q) / w[""] for x, y, z, q in zip(h[a + b][:3], s[b], s[a], s[""])]
    return s


def across_curvature(s, n):
    """The normal curvature across the edge, times the length of n."""
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    d = cross(n, s["v"])
    # d = a S_u + b S_v
    m = cross(s["u"], s["v"])
    a, b = dot(cross(d, s["v"]), m) / dot(m, m), dot(cross(s["u"], d), m) / dot(m, m)
    second = plus(plus([a * a * x for x in s["uu"]], s["uv"], 2 * a * b), s["vv"], b * b)
    return dot(second, n) / dot(d, d)


class Edge:
    """Two sides of one line v: the left one ends at a knot in u, the right one begins."""

    def __init__(self, left, left_knot, right, right_knot):
        self.order, self.spans = 2, []
        rows = left.rows_at(left_knot, True), right.rows_at(right_knot, False)
        curve = Curve(rows[0][0], left.v, None, left.degrees[1])
        for k in curve.spans():
            a = [left.polynomials(r, k) for r in rows[0]]
            b = [right.polynomials(r, k) for r in rows[1]]
            low, high = left.v[k], left.v[k + 1]
            self.spans.append((a, b, low, high))
            self.order = min(self.order, self.decide(a, b, low, high))

    @staticmethod
    def decide(a, b, low, high):
        (p, pu, puu), (q, qu, quu) = a, b
        if any(not is_zero(minus(multiply(p[i], q[3]), multiply(q[i], p[3]))) for i in range(3)):
            return -1
        f = value(p[3], low) / value(q[3], low)
        if not is_zero(minus(p[3], [f * x for x in q[3]])):
            raise AssertionError("weights along the edge that are not proportional")
        q, qu, quu = ([[f * x for x in c] for c in r] for r in (q, qu, quu))
        pv = [differentiated(c) for c in p]
        if not is_zero(determinant4([p, pv, pu, qu])):
            return 0
        n, m = normal(p, pv, pu), normal(p, pv, qu)
        side = [F(0)]
        for x, y in zip(n, m):
            side = add(side, multiply(x, y))
        if not is_positive(side, low, high):
            return 0
        # Q_u = b P_v + c P_u + ..., without division by D, for a coordinate direction e.
        for e in ([F(1) if i == k else F(0) for i in range(4)] for k in range(4)):
            unit = [[x] for x in e]
            d = determinant4([p, pv, pu, unit])
            if is_zero(d):
                continue
            nb, nc = determinant4([p, qu, pu, unit]), determinant4([p, pv, qu, unit])
            det = lambda v: determinant4([p, pv, pu, v])
            puv, pvv = [differentiated(c) for c in pu], [differentiated(c) for c in pv]
            total = multiply(multiply(d, d), det(quu))
            for factor, v in ((multiply(nb, nb), pvv), (multiply(multiply([F(2)], nb), nc), puv), (multiply(nc, nc), puu)):
                total = minus(total, multiply(factor, det(v)))
            return 2 if is_zero(total) else 1
        raise AssertionError("an edge without normals")

    def measures(self):
        """The largest values along the edge: bounds that the checker proves. Curvatures only where they are the same all along."""
        samples = [(a, b, low + (high - low) * F(i, 24)) for a, b, low, high in self.spans for i in range(25)]
        point = lambda r, t: [value(c, t) / value(r[0][3], t) for c in r[0][:3]]
        gap = max(dot(d, d) for a, b, t in samples for d in [plus(point(a, t), point(b, t), -1)])
        result = {"gap": root(gap), "angle_degrees": None, "curvature_jump": None, "curvature_percent": None, "torsion_jump": None}
        if self.order < 0:
            assert all(dot(d, d) == gap for a, b, t in samples for d in [plus(point(a, t), point(b, t), -1)]), "a gap that is not the same all along"
            return result

        def normals(a, b, t):
            at = lambda r: [[x] for x in (value(c, t) for c in r)]
            p, pv = at(a[0]), [[value(differentiated(c), t)] for c in a[0]]
            q, qv = at(b[0]), [[value(differentiated(c), t)] for c in b[0]]
            return [x[0] for x in normal(p, pv, at(a[1]))], [x[0] for x in normal(q, qv, at(b[1]))]

        def turned(sample):
            u, v = normals(*sample)
            if not any(u) or not any(v):
                return F(-2)
            c = dot(u, v)
            square = 1 - c * c / (dot(u, u) * dot(v, v))
            return square if c > 0 else 2 - square
        sizes = [turned(s) for s in samples]
        most = max(sizes)
        best = samples[sizes.index(most)]
        constant = min(sizes) == most
        width = F(0) if constant or best is samples[0] or best is samples[-1] else (self.spans[0][3] - self.spans[0][2]) / 32
        while width > F(1, 2**22):
            a, b, t = best
            low, high = next((lo, hi) for x, _, lo, hi in self.spans if x is a)
            for s in ((a, b, max(t - width, low)), (a, b, min(t + width, high))):
                size = turned(s)
                if size > most:
                    best, most = s, size
                    break
            else:
                width /= 2
        angle = degrees(*normals(*best))
        self.at = best[2]
        if not constant and exact(angle[1]) and angle[0] != angle[1]:
            angle = enclosure(exact(angle[0]), exact(angle[1]) * (1 + F(1, 2 * 10**9)))
        result["angle_degrees"] = angle
        if self.order >= 1:
            found = []
            for a, b, t in samples[1:-1:5]:
                n = normals(a, b, t)[0]
                k = [across_curvature(quotient_jet(r[0], r[1], r[2], t), n) for r in (a, b)]
                most = max(map(abs, k))
                found.append(((k[0] - k[1]) ** 2 / dot(n, n), (k[0] - k[1]) ** 2 / most**2 if most else F(0)))
            if all(x[1] == found[0][1] for x in found):
                result["curvature_percent"] = root(found[0][1] * 10000)
            if all(x[0] == found[0][0] for x in found):
                result["curvature_jump"] = root(found[0][0])
        return result


def as_g2(patches):
    lines = []
    for s in patches:
        grid = s.homogeneous() if s.weights else s.points
        lines += ["200 1 0 0", f"3 {1 if s.weights else 0}"]
        for count, degree, knots in ((len(grid), s.degrees[0], s.u), (len(grid[0]), s.degrees[1], s.v)):
            lines += [f"{count} {degree + 1}", " ".join(map(text, knots))]
        lines += [" ".join(map(text, grid[i][j])) for j in range(len(grid[0])) for i in range(len(grid))]
    return "\n".join(lines) + "\n"


def as_json(patches):
    lines = []
    for s in patches:
        line = {"degrees": list(s.degrees), "u_knots": [text(t) for t in s.u], "v_knots": [text(t) for t in s.v],
                "points": [[[text(x) for x in p] for p in row] for row in s.points]}
        if s.weights:
            line["weights"] = [[text(w) for w in row] for row in s.weights]
        lines.append("  " + json.dumps(line))
    return '{"surfaces": [\n' + ",\n".join(lines) + "\n ]}\n"


def sides_of(s):
    """The boundary of a patch, counter-clockwise: curves, whether they run forward, and their images in the parameters."""
    first, last = (s.u[0], s.u[-1]), (s.v[0], s.v[-1])
    for edge, forward in (("v0", True), ("u1", True), ("v1", False), ("u0", False)):
        c = s.boundary(edge)
        if edge[0] == "v":
            flat = [[first[0], last[int(edge[1])]], [first[1], last[int(edge[1])]]]
        else:
            flat = [[first[int(edge[1])], last[0]], [first[int(edge[1])], last[1]]]
        yield c, forward, Curve(flat, [c.knots[0]] * 2 + [c.knots[-1]] * 2, None, 1)


def as_step(name, patches, unit="mm", pcurves=False, frame=None, inward=()):
    shell = step.Shell(name, unit, frame=frame)
    for s in patches:
        surface = shell.spline_surface(s)
        sides = [(c, forward, image if pcurves else None) for c, forward, image in sides_of(s) if any(p != c.points[0] for p in c.points)]
        shell.face(surface, sides, turns=True, inward=s in inward)
    return shell.close()


def as_brep(patches, placed=None, inward=(), tolerance="1e-07", share=None):
    """The normals of patches that look inward point to the other side. `share` replaces a side by a curve that another face has."""
    shell = brep.Brep(tolerance)
    for s in patches:
        sides = [((share or {}).get(c.keys()[0], c), forward, image) for c, forward, image in sides_of(s)]
        shell.face(shell.surface(s), sides, s not in inward)
    return shell.write(placed)


def cases(suite):
    def pair(name, question, why, left, right, expect, up_to="G2", turn="", within=None, only=None, unit="mm", family="surface", others=(), pcurves=False):
        """`turn` are changes of the second patch after the truth is known: s swaps its parameters, u and v reverse them."""
        left, right = (x if isinstance(x, Patch) else Patch(x) for x in (left, right))
        edges = [Edge(left, left.u[-1], right, right.u[0])] if right is not left else []
        for s in {id(s): s for s in (left, right)}.values():
            p = s.degrees[0]
            edges += [Edge(s, t, s, t) for t in sorted(set(s.u[p + 1 : len(s.u) - p - 1])) if right is left]
        edge = min(edges, key=lambda e: e.order)
        reached = "gap" if edge.order < 0 else f"G{min(edge.order, int(up_to[1]))}"
        measures = edge.measures()
        if within:
            from truth import ladder, name as named
            reached = ladder(measures, within)
            reached = named(reached) if reached is not None else "undecided"
        if reached != expect:
            suite.problems.append(f"{family}/{name}: {expect} expected, {reached} computed, {measures}")
        for letter in turn:
            right = {"s": Patch.swapped, "u": Patch.reversed_u, "v": Patch.reversed_v}[letter](right)
        patches = [left] + ([right] if right is not left else [])
        decimals = all(is_decimal(x) for s in patches for x in s.u + s.v + [y for row in s.points for p in row for y in p] + [w for row in s.weights or [] for w in row])
        files = {"json": as_json(patches)}
        if decimals:
            files["g2"] = as_g2(patches)
            if edge.order >= 0:
                inward = [right] if len(turn) % 2 else []
                files["step"] = as_step(f"{family}/{name}", patches, pcurves=pcurves, inward=inward)
                files["brep"] = as_brep(patches, inward=inward)
        more = {"within": within} if within else {"exact": True}
        if measures["angle_degrees"] and edge.order == 0:
            more["at"] = text(edge.at)
        suite.record(f"{family}/{name}", "surface", question, why, reached, up_to, measures, {k: f for k, f in files.items() if not only or k in only}, **more)

    flat = ["0,0,0 0,1,0", "1,0,0 1,1,0"]

    # ---- Position.
    pair("meets", "position", "Two planes share an edge, at a right angle.", flat, ["1,0,0 1,1,0", "1,0,1 1,1,1"], "G0", "G0")
    for gap in ("1e-3", "1e-7", "1e-10"):
        pair("gap-" + gap, "position", f"The second plane begins {gap} further on.", flat, Patch(number_grid([f"1,0,{gap} 1,1,{gap}", f"2,0,{gap} 2,1,{gap}"])), "gap", "G0")

    # ---- Tangent planes.
    pair("coplanar", "tangent", "Two squares of one plane.", flat, ["1,0,0 1,1,0", "2,0,0 2,1,0"], "G2")
    pair("coplanar-skew", "tangent", "Two quadrilaterals of one plane, whose lines across the edge do not continue each other.", flat, ["1,0,0 1,1,0", "2,1,0 3,5,0"], "G2")
    pair("turned-back", "tangent", "The second square lies under the first: normals opposite, a fold of 180 degrees.", flat, ["1,0,0 1,1,0", "0.5,0,0 0.5,1,0"], "G0")
    for k in (1, 2, 3, 4, 6, 9, 12, 15, 20):
        z = f"1e-{k}"
        pair(f"kink-{z}", "tangent", f"Planes that include an angle of {z}, nearly, all along the edge.", flat, [f"1,0,0 1,1,0", f"2,0,{z} 2,1,{z}"], "G0")
    pair("kink-at-one-end", "tangent", "The angle grows from 0 at one end of the edge to 0.57 degrees at the other.", flat, ["1,0,0 1,1,0", "2,0,0 2,1,0.01"], "G0")
    three = ["0,0,0 0,1,0 0,2,0", "1,0,0 1,1,0 1,2,0"]
    pair("kink-in-the-middle", "tangent", "The angle is 0 at both ends of the edge and 0.29 degrees in the middle.", three, ["1,0,0 1,1,0 1,2,0", "2,0,0 2,1,0.01 2,2,0"], "G0")
    four = ["0,0,0 0,1,0 0,2,0 0,3,0", "1,0,0 1,1,0 1,2,0 1,3,0"]
    pair("kink-between-three", "tangent", "The angle is 0 at both ends and in the middle of the edge, and up to 0.17 degrees between: three samples see nothing.", four,
         ["1,0,0 1,1,0 1,2,0 1,3,0", "2,0,0 2,1,0.01 2,2,-0.01 2,3,0"], "G0")
    six = ["0,0,0 0,1,0 0,2,0 0,3,0 0,4,0 0,5,0", "1,0,0 1,1,0 1,2,0 1,3,0 1,4,0 1,5,0"]
    # 3 v (1 - v) (1 - 2 v) (1 - 4 v) (3 - 4 v) is 0 at all quarters.
    quarters = multiply(multiply(multiply([F(0), F(3)], [F(1), F(-1)]), [F(1), F(-2)]), multiply([F(1), F(-4)], [F(3), F(-4)]))
    from math import comb
    heights = [sum(F(comb(j, k), comb(5, k)) * quarters[k] for k in range(j + 1)) / 10 for j in range(6)]
    pair("kink-between-five", "tangent", "The angle is 0 at all quarters of the edge, and up to some degrees between: five samples see nothing.", six,
         Patch([[[F(1), F(j), F(0)] for j in range(6)], [[F(2), F(j), heights[j]] for j in range(6)]]), "G0")
    pair("fold-in-the-middle", "tangent", "The second patch runs forward at one end of the edge and backward at the other.", three, ["1,0,0 1,1,0 1,2,0", "2,0,0 1,1,0 0.5,2,0"], "G0")
    pair("edge-reversed", "tangent", "The second patch runs along the edge the other way.", flat, ["1,0,0 1,1,0", "2,0,0.001 2,1,0.001"], "G0", turn="v")
    pair("edge-swapped", "tangent", "The edge is that of v = 0 of the second patch.", flat, ["1,0,0 1,1,0", "2,0,0.001 2,1,0.001"], "G0", turn="s")
    pair("edge-other-end", "tangent", "The edge is that of u = 1 of both patches.", flat, ["1,0,0 1,1,0", "2,0,0.001 2,1,0.001"], "G0", turn="u")
    pair("tiny-unit", "tangent", "A right angle in units of 1e-6.", ["0,0,0 0,1e-6,0", "1e-6,0,0 1e-6,1e-6,0"], ["1e-6,0,0 1e-6,1e-6,0", "1e-6,0,1e-6 1e-6,1e-6,1e-6"], "G0", only=("json", "g2"))
    pair("huge-unit", "tangent", "A kink of 1e-7 in units of 1e6.", ["0,0,0 0,1e6,0", "1e6,0,0 1e6,1e6,0"], ["1e6,0,0 1e6,1e6,0", "2e6,0,0.1 2e6,1e6,0.1"], "G0")
    pair("decimals", "tangent", "Coplanar along (1, 0.1, 0.3), in decimals that no double holds.", ["0,0,0 0,1,0", "0.1,0.01,0.03 0.1,1.01,0.03"],
         ["0.1,0.01,0.03 0.1,1.01,0.03", "0.4,0.04,0.12 0.4,1.04,0.12"], "G2")
    pair("collapsed-neighbour", "tangent", "The second patch is a triangle: its far edge is one point.", flat, ["1,0,0 1,1,0", "2,0.5,0 2,0.5,0"], "G2", only=("json", "g2"))

    # ---- Curvature.
    def extruded(*profile):
        """Profiles of points x, z, along y from 0 to 2."""
        return [Patch([[[exact(x), F(j), exact(z)] for j in (0, 2)] for x, z in (p.split(",") for p in c.split())]) for c in profile]
    pair("plane-parabola", "curvature", "A plane goes on in an extruded parabola: the curvature jumps from 0.", *extruded("0,0 1,0", "1,0 2,0 3,1"), "G1")
    pair("one-parabola", "curvature", "Two halves of an extruded parabola.", *extruded("0,1 1,0 2,0", "2,0 3,0 4,1"), "G2")
    pair("inflection", "curvature", "Extruded parabolas that bend to different sides, equally.", *extruded("0,1 1,0 2,0", "2,0 3,0 4,-1"), "G1")
    for k in (2, 4, 6, 9, 12, 15):
        one = text(1 + F(1, 10**k))
        pair(f"jump-1e-{k}", "curvature", f"Extruded parabolas whose curvatures differ by the part 1e-{k}.", *extruded("0,1 1,0 2,0", f"2,0 3,0 4,{one}"), "G1")
    pair("scaled-speed", "curvature", "The second parabola is three times as fast.", *extruded("0,1 1,0 2,0", "2,0 5,0 8,9"), "G2")
    pair("flat-ends", "curvature", "A plane and an extruded cubic whose first three points lie in it.", *extruded("0,0 1,0", "1,0 2,0 3,0 4,1"), "G2")
    bend = ["0,0,1 0,1,1 0,2,1", "1,0,0 1,1,0 1,2,0", "2,0,0 2,1,0 2,2,0"]
    pair("jump-in-the-middle", "curvature", "Curvatures agree at both ends of the edge, and differ in the middle.", bend, ["2,0,0 2,1,0 2,2,0", "3,0,0 3,1,0 3,2,0", "4,0,1 4,1,1.1 4,2,1"], "G1")
    pair("jump-at-one-end", "curvature", "Curvatures differ more and more towards one end of the edge.", bend, ["2,0,0 2,1,0 2,2,0", "3,0,0 3,1,0 3,2,0", "4,0,1 4,1,1 4,2,1.2"], "G1")

    def continued(left, alpha, beta, alpha2, delta):
        """A patch that continues another one with G2 across its edge u = 1: S_u = alpha C' + beta T, and the second derivative by the chain rule;
        the numbers are constants. Degrees along are those of the left patch."""
        n = left.degrees[1]
        c, t, w = left.rows_at(left.u[-1], True)
        c, t, w = ([p[:3] for p in r] for r in (c, t, w))
        # Derivatives along the edge, raised to the degree n.
        def along(row):
            d = [[n * (b - a) for a, b in zip(p, q)] for p, q in zip(row, row[1:])]
            m = len(d) - 1
            return [plus([F(j, n) * x for x in (d[j - 1] if j else d[0])], d[j] if j <= m else d[m], 1 - F(j, n)) for j in range(n + 1)]
        c1 = along(c)
        c2, t1 = along(c1), along(t)
        first = [plus([alpha * x for x in c1[j]], t[j], beta) for j in range(n + 1)]
        second = [plus(plus(plus(plus([alpha**2 * x for x in c2[j]], t1[j], 2 * alpha * beta), w[j], beta**2), c1[j], alpha2), t[j], delta) for j in range(n + 1)]
        rows = [c, [plus(c[j], first[j], F(1, 3)) for j in range(n + 1)]]
        rows.append([plus(plus(c[j], first[j], F(2, 3)), second[j], F(1, 6)) for j in range(n + 1)])
        rows.append([plus(rows[2][j], [F(3), F(0), F(j % 2)], 1) for j in range(n + 1)])
        return Patch(rows)
    wavy = Patch(["0,0,2 0,4,1 0,8,4", "2,0,0 2,4,3 2,8,1", "4,0,1 4,4,0 4,8,2"])
    nice = continued(wavy, F(0), F(1), F(0), F(0))
    pair("general", "curvature", "A saddle goes on with equal first and second derivatives across the edge.", wavy, nice, "G2")
    slanted = continued(wavy, F(1, 4), F(3, 2), F(1, 2), F(3, 4))
    pair("general-slanted", "curvature", "The same saddle; lines across the edge turn and are faster, second derivatives follow the chain rule.", wavy, slanted, "G2", only=("json", "g2", "step"))
    spoiled = continued(wavy, F(1, 4), F(3, 2), F(1, 2), F(3, 4))
    spoiled.points[2][1] = plus(spoiled.points[2][1], [F(0), F(0), F(1, 1000)])
    pair("general-spoiled", "curvature", "One point of the third row is off by 0.001: tangent planes agree, curvatures do not.", wavy, spoiled, "G1")
    bent = continued(wavy, F(1, 4), F(3, 2), F(1, 2), F(3, 4))
    bent.points[1][1] = plus(bent.points[1][1], [F(0), F(0), F(1, 10**6)])
    pair("general-kinked", "tangent", "One point of the second row is off by 1e-6.", wavy, bent, "G0")
    pair("general-reversed", "curvature", "The continued saddle, with its edge the other way and its parameters swapped.", wavy, slanted, "G2", turn="vs")

    # ---- Rational patches.
    def cylinder(profile, weights):
        points = [[[exact(x), F(j), exact(z)] for j in (0, 2)] for x, z in (p.split(",") for p in profile.split())]
        return Patch(points, weights=[f"{w} {w}" for w in weights.split()])
    quarter = cylinder("4,0 4,4 0,4", "1 1 2")
    pair("cylinder-halves", "curvature", "Two quarters of a cylinder as rational patches.", quarter, cylinder("0,4 -4,4 -4,0", "2 1 1"), "G2")
    pair("cylinder-weights", "curvature", "Two quarters of a cylinder with weights 1, 1, 2 both: derivatives differ, the cylinder goes on.", quarter, cylinder("0,4 -4,4 -4,0", "1 1 2"), "G2")
    pair("cylinder-plane", "curvature", "A cylinder and the plane that touches it.", quarter, Patch(["0,0,4 0,2,4", "-4,0,4 -4,2,4"]), "G1")
    pair("cylinder-radius", "curvature", "Cylinders of radius 4 and 5 that touch from inside.", quarter, cylinder("0,4 -5,4 -5,-1", "1 1 2"), "G1")
    pair("cylinder-radius-nearly", "curvature", "Cylinders of radius 4 and 4.00000004.", quarter, cylinder("0,4 -4.00000004,4 -4.00000004,-0.00000004", "1 1 2"), "G1")
    pair("cylinder-other-side", "curvature", "Cylinders of radius 4 that touch from outside.", quarter, cylinder("0,4 -4,4 -4,8", "1 1 2"), "G1")
    pair("cylinder-kink", "tangent", "Cylinders that kink by 0.57 degrees.", quarter, cylinder("0,4 -4,4.04 -4,0", "2 1 1"), "G0")

    # ---- Knot lines inside of one surface.
    grid = ["0,0,0 0,1,0", "1,0,0 1,1,0", "2,0,0 2,1,0", "3,0,1 3,1,1", "4,0,0 4,1,0"]

    def inside(name, question, why, points, degree, knots, expect):
        s = Patch(points, u=knots, degrees=(degree, len(points[0].split()) - 1))
        pair(name, question, why, s, s, expect)
    inside("knot-simple", "curvature", "A cubic spline surface with a simple knot: G2 across its line.", grid, 3, "0 0 0 0 1 2 2 2 2", "G2")
    inside("knot-quadratic", "curvature", "A quadratic spline surface with a simple knot: G1 across its line.", grid[:4], 2, "0 0 0 1 2 2 2", "G1")
    inside("knot-double", "tangent", "A quadratic spline surface with a double knot: a crease across its line.", ["0,0,0 0,1,0", "1,0,1 1,1,1", "2,0,1 2,1,1", "3,0,0 3,1,0", "4,0,0 4,1,0"], 2, "0 0 0 1 1 2 2 2", "G0")
    inside("knot-double-smooth", "tangent", "A double knot of degree 2 whose rows are collinear: no crease, although the knots allow one.",
           ["0,0,1 0,1,1", "1,0,0 1,1,0", "2,0,0 2,1,0", "4,0,0 4,1,0", "5,0,3 5,1,3"], 2, "0 0 0 1 1 2 2 2", "G1")
    along = "0 0 0 1 2 2 2"
    left = Patch(["0,0,0 0,1,0 0,2,0 0,3,0", "1,0,0 1,1,0 1,2,0 1,3,0"], v=along, degrees=(1, 2))
    right = Patch(["1,0,0 1,1,0 1,2,0 1,3,0", "2,0,0 2,1,0 2,2,0 2,3,0.02"], v=along, degrees=(1, 2))
    pair("second-span", "tangent", "Splines along the edge: the first span is smooth, the second one kinks.", left, right, "G0")

    # ---- Tolerances.
    G, A = "gap", "angle_degrees"
    pair("angle-45-bound", "tolerances", "Planes at exactly 45 degrees, which is the tolerance.", flat, ["1,0,0 1,1,0", "2,0,1 2,1,1"], "G1", "G1", within={G: "0.000001", A: "45"})
    pair("angle-45-above", "tolerances", "Planes at 45 degrees, and a tolerance of 44.9999999.", flat, ["1,0,0 1,1,0", "2,0,1 2,1,1"], "G0", "G1", within={G: "0.000001", A: "44.9999999"})
    pair("angle-middle-above", "tolerances", "0.2865 degrees in the middle of the edge, and a tolerance of 0.28.", three, ["1,0,0 1,1,0 1,2,0", "2,0,0 2,1,0.01 2,2,0"], "G0", "G1",
         within={G: "0.000001", A: "0.28"})
    pair("angle-middle-below", "tolerances", "0.2865 degrees in the middle of the edge, and a tolerance of 0.29.", three, ["1,0,0 1,1,0 1,2,0", "2,0,0 2,1,0.01 2,2,0"], "G1", "G1",
         within={G: "0.000001", A: "0.29"})

    # ---- Models: rows of patches, each beside the next; one edge is the worst.
    def row(name, question, why, patches, expect, closed=False):
        pairs = list(zip(patches, patches[1:])) + ([(patches[-1], patches[0])] if closed else [])
        edges = [Edge(a, a.u[-1], b, b.u[0]) for a, b in pairs]
        edge = min(edges, key=lambda e: e.order)
        if f"G{edge.order}" != expect:
            suite.problems.append(f"model/{name}: {expect} expected, G{edge.order} computed")
        measures = edge.measures()
        more = {"at": text(edge.at)} if edge.order == 0 else {}
        files = {"json": as_json(patches), "g2": as_g2(patches), "step": as_step(f"model/{name}", patches), "brep": as_brep(patches)}
        suite.record(f"model/{name}", "surface", question, why, expect, "G2", measures, files, edges=len(edges), **more)
    ring = ("4,0 4,4 0,4", "0,4 -4,4 -4,0", "-4,0 -4,-4 0,-4", "0,-4 4,-4 4,0")
    tube = [cylinder(p, "1 1 2") for p in ring]
    row("tube", "curvature", "A tube of four quarters of a cylinder: all four edges are G2.", tube, "G2", closed=True)
    row("tube-dented", "curvature", "In a tube of four patches one has another weight: tangent planes agree, the curvature jumps at two edges.",
        tube[:2] + [cylinder(ring[2], "2 1 4")] + tube[3:], "G1", closed=True)
    row("tube-kinked", "tangent", "In a tube of four patches one middle row is off, so that two edges kink by 0.14 degrees.", tube[:2] + [cylinder("-4,0 -4.01,-4 0,-4", "1 1 2")] + tube[3:],
        "G0", closed=True)
    row("strip-jump", "curvature", "Five pieces of parabolas in a row; only at the third edge the curvature jumps, by the part 0.001.",
        extruded("-2,4 -1.5,2 -1,1", "-1,1 -0.5,0 0,0", "0,0 0.5,0 1,1", "1,1 1.5,2 2,4.001", "2,4.001 2.5,6.002 3,9.004"), "G1")
    row("strip-kink", "tangent", "Four planes in a row; only at the second edge they include an angle of 1e-6.",
        extruded("0,0 1,0", "1,0 2,0", "2,0 3,0.000001", "3,0.000001 4,0.000002"), "G0")
