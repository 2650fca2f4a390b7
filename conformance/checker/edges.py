# SPDX-License-Identifier: CC0-1.0
"""Decides surfaces along whole edges by points: what is a polynomial along the edge is 0 if it is 0 at
more points than its degree, and positive by its interpolation and the coefficients of Bernstein."""

import json
from fractions import Fraction as F

import brep
import models
import part21
from fonts import Polynomial, proved_positive
from joins import EXACT_ANGLES, Wrong, combine, cross, fixed_sine_cosine, inner, is_zero, local_derivatives, need, number, order_within, verify_flip


class Surface:
    def __init__(self, p, q, u, v, points, weights):
        self.p, self.q, self.u, self.v = p, q, u, v
        self.rational = weights is not None
        w = weights or [[F(1)] * len(row) for row in points]
        self.grid = [[[x * w[i][j] for x in a] + [w[i][j]] for j, a in enumerate(row)] for i, row in enumerate(points)]
        self.columns, self.other = {}, None

    def transposed(self):
        """The surface with u and v exchanged."""
        if self.other is None:
            t = Surface.__new__(Surface)
            t.p, t.q, t.u, t.v, t.rational, t.grid = self.q, self.p, self.v, self.u, self.rational, [list(column) for column in zip(*self.grid)]
            t.columns, t.other, self.other = {}, self, t
        return self.other

    def same(self, other):
        return (self.p, self.q, self.u, self.v, self.grid) == (other.p, other.q, other.u, other.v, other.grid)

    @staticmethod
    def derivatives(points, knots, p, t, upper):
        """Up to the second, of one span: that which ends at t if `upper`, else that which begins there or contains it."""
        spans = [k for k in range(p, len(knots) - p - 1) if knots[k] < knots[k + 1] and (knots[k] < t <= knots[k + 1] if upper else knots[k] <= t < knots[k + 1])]
        k = spans[0]
        return local_derivatives(points[k - p : k + 1], knots[k - p + 1 : k + p + 1], p, t)[:3]

    def jet(self, u, v, upper_u, upper_v):
        """S, S_u, S_v, S_uu, S_uv, S_vv and the weight."""
        if (u, upper_u) not in self.columns:  # along an edge they stay the same
            self.columns[u, upper_u] = [self.derivatives(column, self.u, self.p, u, upper_u) for column in zip(*self.grid)]
        columns = self.columns[u, upper_u]
        rows = [self.derivatives([c[k] for c in columns], self.v, self.q, v, upper_v) for k in range(3)]
        h = {(i, j): rows[i][j] for i in range(3) for j in range(3) if i + j <= 2}
        w = {k: x[3] for k, x in h.items()}
        s = {(0, 0): [x / w[0, 0] for x in h[0, 0][:3]]}
        for k in ((1, 0), (0, 1)):
            s[k] = combine((1 / w[0, 0], h[k][:3]), (-w[k] / w[0, 0], s[0, 0]))
        for k, a, b in (((2, 0), (1, 0), (1, 0)), ((1, 1), (1, 0), (0, 1)), ((0, 2), (0, 1), (0, 1))):
            s[k] = combine((1 / w[0, 0], h[k][:3]), (-w[a] / w[0, 0], s[b]), (-w[b] / w[0, 0], s[a]), (-w[k] / w[0, 0], s[0, 0]))
        return s, w[0, 0]


def read(extension, data):
    if extension == "json":
        return [Surface(*s["degrees"], [number(t) for t in s["u_knots"]], [number(t) for t in s["v_knots"]], [[[number(x) for x in p] for p in row] for row in s["points"]],
                        [[number(w) for w in row] for row in s["weights"]] if "weights" in s else None) for s in json.loads(data)["surfaces"]]
    words, result = data.decode().split(), []
    while words:
        need(words[:5] == ["200", "1", "0", "0", "3"], "the class is not 200")
        rational = int(words[5])
        words = words[6:]
        parameters = []
        for _ in range(2):
            n, order = int(words[0]), int(words[1])
            parameters.append((n, order - 1, [number(t) for t in words[2 : 2 + n + order]]))
            words = words[2 + n + order :]
        (m, p, u), (n, q, v) = parameters
        size = 3 + rational
        rows = [[[number(x) for x in words[size * (i + j * m) : size * (i + j * m + 1)]] for j in range(n)] for i in range(m)]
        words = words[size * m * n :]
        weights = [[x[3] for x in row] for row in rows] if rational else None
        points = [[[y / x[3] for y in x[:3]] for x in row] for row in rows] if rational else rows
        result.append(Surface(p, q, u, v, points, weights))
    return result


class Side:
    """An edge of a surface, along which a parameter runs from 0 to 1; or a knot line, from one of its sides."""

    def __init__(self, surface, edge, backwards=False, knot=None, upper=None):
        self.surface, self.backwards = surface if edge[0] == "u" else surface.transposed(), backwards
        self.along, self.degree, across = self.surface.v, self.surface.q, self.surface.u
        self.upper = edge[1] == "1" if upper is None else upper
        self.at = knot if knot is not None else across[-1] if self.upper else across[0]
        self.sign = 1 if self.upper else -1

    def breaks(self):
        a, b = self.along[0], self.along[-1]
        t = sorted({(x - a) / (b - a) for x in self.along})
        return sorted(1 - x for x in t) if self.backwards else t

    def point(self, t, upper):
        """Position, derivative along, derivative outwards, second derivatives (along, mixed, outwards), the weight."""
        if self.backwards:
            t, upper = 1 - t, not upper
        x = self.along[0] + t * (self.along[-1] - self.along[0])
        turn = -1 if self.backwards else 1
        s, w = self.surface.jet(self.at, x, self.upper, upper)
        o = self.sign
        return s[0, 0], combine((turn, s[0, 1])), combine((o, s[1, 0])), s[0, 2], combine((o * turn, s[1, 1])), s[2, 0], w


def interpolated(values, low, high):
    """The polynomial over [low, high], made [0, 1], through values at equally spaced points of the open interval."""
    n = len(values)
    nodes = [F(i + 1, n + 1) for i in range(n)]
    table, coefficients = list(values), []
    for k in range(n):
        coefficients.append(table[0])
        table = [(b - a) / (nodes[i + k + 1] - nodes[i]) for i, (a, b) in enumerate(zip(table, table[1:]))]
    result = [F(0)]
    for k in reversed(range(n)):
        result = [(result[i - 1] if i else F(0)) - (nodes[k] * result[i] if i < len(result) else F(0)) for i in range(len(result) + 1)]
        result[0] += coefficients[k]
    return Polynomial({(i,): c for i, c in enumerate(result) if c})


def facts(a, b, t, upper):
    """The two sides at one parameter, and their normals: outwards of b is inwards of a."""
    x, y = a.point(t, upper), b.point(t, upper)
    return x, y, cross(x[1], x[2]), cross(y[1], combine((-1, y[2])))


def second_form(side, n):
    """Returns the second fundamental form in the direction perpendicular to the edge and to n, times the length of n, over d squared."""
    position, along, out, aa, ao, oo, w = side
    d = cross(along, n)
    normal = cross(along, out)
    square = inner(normal, normal)
    # d = p * along + q * out
    q = inner(cross(along, d), normal) / square
    p = inner(cross(d, out), normal) / square
    need(is_zero(combine((1, d), (-p, along), (-q, out))), "a direction that is not in the tangent plane")
    return inner(n, combine((p * p, aa), (2 * p * q, ao), (q * q, oo))) / inner(d, d)


def decide(a, b):
    """The order of an edge of two sides, and its points span by span."""
    cuts = sorted(set(a.breaks()) | set(b.breaks()))
    rational = a.surface.rational or b.surface.rational
    d = max(a.degree, b.degree, 1)
    count = (24 if rational else 12) * d + 5
    order, spans = 2, []
    for low, high in zip(cuts, cuts[1:]):
        points = []
        for i in range(count):
            t = low + (high - low) * F(i + 1, count + 1)
            points.append((t, facts(a, b, t, False)))
        spans.append((low, high, points))
        if any(x[0] != y[0] for _, (x, y, n, m) in points):
            return -1, spans
    for low, high, points in spans:
        if not all(is_zero(cross(n, m)) for _, (x, y, n, m) in points):
            order = 0
            continue
        sides = [inner(n, m) * x[6] ** 3 * y[6] ** 3 for _, (x, y, n, m) in points]
        need(all(x[6] > 0 and y[6] > 0 for _, (x, y, n, m) in points), "a weight that is not positive")
        if not proved_positive(interpolated(sides, low, high), False):
            order = min(order, 0)
            continue
        for _, (x, y, n, m) in points:
            if second_form(x, n) != second_form(y, n):
                order = min(order, 1)
                break
    return order, spans


def verify(record, a, order, spans, at=None):
    """The sizes in a record. Returns where the largest angle is to be, and the square of its sine."""
    gap = [inner(d, d) for _, _, points in spans for _, (x, y, n, m) in points for d in [combine((1, y[0]), (-1, x[0]))]]
    low, high = map(number, record["gap"])
    need(all(low * low <= g <= high * high for g in gap) and (high - low) * 10**20 <= high, "the gap is another one")
    need(record["torsion_jump"] is None, "a torsion of surfaces")
    if order < 1 and at is None:
        need(record["curvature_percent"] is None and record["curvature_jump"] is None, "curvatures where tangent planes differ")
    if order < 0:
        need(record["angle_degrees"] is None, "an angle at a gap")
        return
    low, high = map(number, record["angle_degrees"])
    need(0 <= low <= high and (high - low) * 10**9 <= high, "the enclosure of the angle is wide")
    if order >= 1:
        need(low == high == 0, "the angle is 0")
        squares = {"curvature_percent": [], "curvature_jump": []}
        for _, _, points in spans:
            for _, (x, y, n, m) in points:
                k, j = second_form(x, n), second_form(y, n)
                most = max(abs(k), abs(j))
                squares["curvature_jump"].append((k - j) ** 2 / inner(n, n))
                squares["curvature_percent"].append(10000 * (k - j) ** 2 / most**2 if most else F(0))
        for kind, found in squares.items():
            is_constant = all(x == found[0] for x in found)
            need((record[kind] is not None) == is_constant, f"{kind} is the same all along, or not")
            if is_constant:
                low, high = map(number, record[kind])
                need(low**2 <= found[0] <= high**2 and (high - low) * 10**20 <= high, f"{kind} is another one")
        return
    def parts(n, m):
        c = inner(n, m)
        return inner(n, n) * inner(m, m) - c * c, c
    values = [parts(n, m) for _, _, points in spans for _, (x, y, n, m) in points]
    if low == high:
        need(low in EXACT_ANGLES and all(EXACT_ANGLES[int(low)](*v) for v in values) or any(EXACT_ANGLES[int(low)](*v) for v in values) and low == 180, "the angle is another one")
        return
    need(high < 90, "an angle that is not enclosed here")
    sine, cosine = fixed_sine_cosine(high)
    square = F(sine * sine, sine * sine + cosine * cosine)
    for begin, end, points in spans:
        need(all(inner(n, m) > 0 for _, (x, y, n, m) in points), "the surfaces turn back")
        proof = interpolated([(square * inner(n, n) * inner(m, m) - parts(n, m)[0]) * x[6] ** 6 * y[6] ** 6 for _, (x, y, n, m) in points], begin, end)
        need(proved_positive(proof, True), f"the angle is more than {record['angle_degrees'][1]}")
    sine, cosine = fixed_sine_cosine(low)
    square = F(sine * sine, sine * sine + cosine * cosine)
    t = at if at is not None else (number(record["at"]) - a.along[0]) / (a.along[-1] - a.along[0])
    return t, square


def edge_pairs(surfaces):
    """The edges that meet; of two surfaces those that are nearest, if none do."""
    if len(surfaces) > 2:
        return [p[2:] for i, a in enumerate(surfaces) for b in surfaces[i + 1 :] for p in distances(a, b) if p[0] == 0]
    if len(surfaces) == 1:
        s = surfaces[0]
        lines = [(Side(s, "u1", knot=t, upper=True), Side(s, "u0", knot=t, upper=False)) for t in sorted(set(s.u[s.p + 1 : len(s.u) - s.p - 1]))]
        return ([(Side(s, "u1"), Side(s, "u0"))] if s.grid[0] == s.grid[-1] else []) + lines
    return [min(distances(*surfaces), key=lambda p: p[:2])[2:]]


def distances(first, second):
    """Each edge of one surface with each of the other, and the square of how far they are apart."""
    def sampled(side):
        return side, [side.point(t, False)[0] for t in (F(1, 7), F(1, 2), F(6, 7))]
    others = [sampled(Side(second, f, backwards)) for f in ("u0", "u1", "v0", "v1") for backwards in (False, True)]
    pairs = []
    for a, points in [sampled(Side(first, e)) for e in ("u1", "u0", "v0", "v1")]:
        for b, places in others:
            steps = [combine((1, x), (-1, y)) for x, y in zip(points, places)]
            pairs.append((max(inner(step, step) for step in steps), len(pairs), a, b))
    return pairs


def read_brep(data, apart=False):
    """The surfaces where they are placed, the shape, and how many edges two faces share."""
    shape = brep.Shape(data)
    shape.verify(apart)
    uses = [(e, runs) for _, forward, loop in shape.faces for e, runs, _ in loop for runs in [runs == forward]]
    names = [e for e, _ in uses]
    for e in set(names):
        need(names.count(e) == 1 or uses.count((e, True)) == uses.count((e, False)) == 1, "an edge that is used twice in one direction")
    return [Surface(*s[:4], [[shape.placed(p) for p in row] for row in s[4]], s[5]) for s in shape.surfaces], shape, sum(names.count(e) == 2 for e in set(names))


def check_brep(record, data):
    """A CAD model of two spline faces, which are decided as such."""
    surfaces, shape, shared = read_brep(data, record["section"] == "apart")
    need(len(surfaces) == 2 and shared == 1, "two faces with a common edge were expected")
    scale, mirrored = shape.scale_and_sign()
    if shape.placement:
        need(scale == number(record["scale"]) and mirrored == record["mirrored"], "another placement")
    else:
        need("placed" not in record, "no placement")
        need(all(forward != record.get("mirrored", False) for _, forward, _ in shape.faces), "faces of a mirrored model point to the other side")
    (a, b), = edge_pairs(surfaces)
    order, spans = decide(a, b)
    if record["section"] == "apart":
        low, high = map(number, record["gap"])
        steps = [inner(d, d) for _, _, points in spans for _, (x, y, n, m) in points for d in [combine((1, y[0]), (-1, x[0]))]]
        need(all(low * low <= g <= high * high for g in steps) and all(is_zero(cross(n, m)) for _, _, points in spans for _, (x, y, n, m) in points), "the gap is another one")
    else:
        rest = verify(record, a, order, spans, F(1, 2))
        if rest:
            x, y, n, m = facts(a, b, rest[0], False)
            c = inner(n, m)
            need(inner(n, n) * inner(m, m) - c * c >= rest[1] * inner(n, n) * inner(m, m), "the angle is not reached")
        if order >= 1:
            # The curvature in the section, of which the record tells, is that across the edge.
            need(record["curvature_percent"] is not None, "a size that is the same all along")
    if "within" not in record:
        need(record["order"] == f"G{min(order, int(record['up_to'][1]))}", f"the order is G{order}")


def check(record, extension, data, control_points):
    if record["subject"] != "surface" and extension == "brep":
        return check_brep(record, data)
    if record["subject"] != "surface":
        return models.check(record, extension, data)
    if extension != "json":
        if extension == "brep":
            found, shape, shared_edges = read_brep(data)
        elif extension == "step":
            model = part21.Model(data)
            found = [Surface(*model.spline_surface(k)) for k, e in model.entities.items() if "B_SPLINE_SURFACE_WITH_KNOTS" in model.kind(k)]
        else:
            found = read(extension, data)
        given = read("json", control_points)
        need(len(found) == len(given) and all(a.same(b) for a, b in zip(found, given)), "the surfaces are not those of the JSON, which is decided")
        if extension not in ("step", "brep"):
            return
        is_closed = any(s.grid[0] == s.grid[-1] for s in found)
        shared = record.get("edges", len(found) - 1 + is_closed)
        if extension == "step":
            uses = []
            for bound in model.all("FACE_OUTER_BOUND"):
                uses += [((use := model.get(e, "ORIENTED_EDGE"))[3], use[4] == bound[2]) for e in model.get(bound[1], "EDGE_LOOP")[1]]
            used = [e for e, _ in uses]
            need(all(used.count(e) == 1 or uses.count((e, True)) == uses.count((e, False)) == 1 for e in used), "an edge that is used twice in one direction")
            shared_edges = sum(used.count(e) == 2 for e in set(used))
        need(shared_edges == shared, "the faces share another number of edges")
        return
    decided = []
    for a, b in edge_pairs(read(extension, data)):
        order, spans = decide(a, b)
        decided.append((order, a, b, spans))
    need(len(decided) == record.get("edges", len(decided)), "another number of edges")
    order = min(d[0] for d in decided)
    problem = None
    for _, a, b, spans in [d for d in decided if d[0] == order]:
        # The record tells the sizes of one of several edges of the worst order.
        try:
            rest = verify(record, a, order, spans)
            if rest:
                t, square = rest
                x, y, n, m = facts(a, b, t, t == 1)
                c = inner(n, m)
                need(inner(n, n) * inner(m, m) - c * c >= square * inner(n, n) * inner(m, m), "the angle is not reached there")
            break
        except Wrong as error:
            problem = problem or error
    else:
        raise problem
    if "within" in record:
        reached = order_within(record, record["gap"], record["angle_degrees"], None)
        need(record["order"] == reached, f"the order within the tolerance is {reached}")
    else:
        k = min(order, int(record["up_to"][1]))
        need(record["order"] == ("gap" if k < 0 else f"G{k}"), f"the order is {order}")
    verify_flip(record)
