# SPDX-License-Identifier: CC0-1.0
"""Reads shapes in OpenCASCADE's text format BREP: spline faces, their edges, and where they are placed."""

from fractions import Fraction as F

from joins import cross, inner, need, number


def similarity(columns):
    """The factor of three axes that are perpendicular and of one length, and whether they mirror."""
    need(all(inner(a, b) == 0 for a, b in ((columns[0], columns[1]), (columns[0], columns[2]), (columns[1], columns[2]))), "axes that are not perpendicular")
    square = inner(columns[0], columns[0])
    need(all(inner(c, c) == square for c in columns), "axes of different lengths")
    factor = inner(cross(columns[0], columns[1]), columns[2]) / square
    need(factor * factor == square, "a scale that is not rational")
    return abs(factor), factor < 0


class Shape:
    """`surfaces` are (degrees, knots, points, weights); `faces` are (surface, forward, [(edge, forward, its image in the parameters)])."""

    def __init__(self, data):
        self.words = data.decode("ascii").replace("C0 ", " C0 ").split()
        self.at = 0
        self.expect("DBRep_DrawableShape CASCADE Topology V1, (c) Matra-Datavision Locations")
        placements = []
        for _ in range(self.integer()):
            self.expect("1")
            placements.append([self.numbers(4) for _ in range(3)])
        self.expect("Curve2ds")
        images = [self.curve(2) for _ in range(self.integer())]
        self.expect("Curves")
        curves = [self.curve(3) for _ in range(self.integer())]
        self.expect("Polygon3D 0 PolygonOnTriangulations 0 Surfaces")
        self.surfaces = [self.surface() for _ in range(self.integer())]
        self.expect("Triangulations 0 TShapes")
        shapes = [self.shape() for _ in range(self.integer())]
        root, placed = self.reference()
        need(self.at == len(self.words) and root == (1, True), "something behind the shape")
        find = lambda k, kind: next(s for s in [shapes[len(shapes) - k]] if s[0] == kind)
        self.faces, self.edges = [], {}
        for f, forward in find(root[0], "Sh")[2]:
            face = find(f, "Fa")
            surface = int(face[1][2]) - 1
            loop = []
            for (e, runs) in find(face[2][0][0], "Wi")[2]:
                edge = find(e, "Ed")
                line = next(x for x in edge[1] if x[0] in ("2", "3") and int(x[-4]) - 1 == surface)
                curve = next((curves[int(x[1]) - 1] for x in edge[1] if x[0] == "1"), None)
                image = images[int(line[1 if line[0] == "2" or runs else 2]) - 1]
                self.edges[e] = curve, [find(v, "Ve")[1] for v, _ in edge[2]]
                loop.append((e, runs, image))
            self.faces.append((surface, forward, loop))
        self.placement = placements[placed - 1] if placed else None

    def placed(self, p):
        """Where a point is."""
        if not self.placement:
            return p
        return [inner(row[:3], p) + row[3] for row in self.placement]

    def scale_and_sign(self):
        """Returns both for a placement that is a similarity."""
        columns = list(zip(*(row[:3] for row in self.placement))) if self.placement else [(F(1), F(0), F(0)), (F(0), F(1), F(0)), (F(0), F(0), F(1))]
        return similarity(columns)

    def side(self, surface, flat):
        """The points and weights of a surface along a side, on which a line in its parameters runs."""
        _, _, u, v, points, weights = self.surfaces[surface]
        result = []
        for grid in (points, weights or [[F(1)] * len(row) for row in points]):
            if flat[0][0] == flat[1][0]:
                need(flat[0][0] in (u[0], u[-1]) and sorted(p[1] for p in flat) == [v[0], v[-1]], "an image inside of the surface")
                row = grid[0 if flat[0][0] == u[0] else -1]
                forward = flat[0][1] == v[0]
            else:
                need(flat[0][1] == flat[1][1] in (v[0], v[-1]) and sorted(p[0] for p in flat) == [u[0], u[-1]], "an image inside of the surface")
                row = [r[0 if flat[0][1] == v[0] else -1] for r in grid]
                forward = flat[0][0] == u[0]
            result.append(row if forward else row[::-1])
        return result

    def verify(self, apart=False):
        """Each edge runs from vertex to vertex as its curve, which is the side of the surface on which its image runs; but of the second of two faces
        that are apart. Loops are closed, and run counter-clockwise in the parameters."""
        for surface, _, loop in self.faces:
            area, last = F(0), None
            for e, runs, (degree, knots, flat, _) in loop:
                need(degree == 1 and len(flat) == 2, "an image that is no line")
                ends = flat if runs else flat[::-1]
                need(last is None or ends[0] == last, "a loop that is not closed")
                last = ends[1]
                area += ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]
                curve, vertices = self.edges[e]
                row, weights = self.side(surface, flat)
                if curve:
                    ratio = [a / b for a, b in zip(weights, curve[3] or [F(1)] * len(weights))]
                    need(row == curve[2] and all(r == ratio[0] for r in ratio) or apart and surface == 1, "an edge beside its surface")
                    need(curve[2][0] == vertices[0] and curve[2][-1] == vertices[1] and (curve[1][0], curve[1][-1]) == (knots[0], knots[-1]), "an edge that does not run between its vertices")
                else:
                    need(vertices[0] == vertices[1], "an edge without a curve")
            need(last == (loop[0][2][2] if loop[0][1] else loop[0][2][2][::-1])[0] and area > 0, "a loop that runs the wrong way")

    def next(self):
        self.at += 1
        return self.words[self.at - 1]

    def integer(self):
        return int(self.next())

    def numbers(self, n):
        return [number(self.next()) for _ in range(n)]

    def expect(self, words):
        for word in words.split():
            need(self.next() == word, f"{word} was expected")

    def knots(self, n):
        result = []
        for _ in range(n):
            t, count = number(self.next()), self.integer()
            result += [t] * count
        return result

    def curve(self, size):
        self.expect("7")
        rational, periodic, degree, poles, values = (self.integer() for _ in range(5))
        need(periodic == 0, "a periodic curve")
        rows = [self.numbers(size + rational) for _ in range(poles)]
        return degree, self.knots(values), [r[:size] for r in rows], [r[-1] for r in rows] if rational else None

    def surface(self):
        self.expect("9")
        a = [self.integer() for _ in range(10)]
        need(a[0] == a[1] and a[2] == a[3] == 0, "a periodic surface")
        rows = [[self.numbers(3 + a[0]) for _ in range(a[7])] for _ in range(a[6])]
        u = self.knots(a[8])
        return a[4], a[5], u, self.knots(a[9]), [[p[:3] for p in row] for row in rows], [[p[3] for p in row] for row in rows] if a[0] else None

    def reference(self):
        word = self.next()
        return (int(word[1:]), word[0] == "+"), self.integer()

    def shape(self):
        """The kind, what it has of geometry, and its parts."""
        kind, rest = self.next(), None
        if kind == "Ve":
            need(number(self.next()) > 0, "no tolerance")
            rest = self.numbers(3)
            self.expect("0 0")
        elif kind == "Ed":
            self.numbers(1)
            self.expect("1 1")
            self.integer()
            rest = []
            while (word := self.next()) != "0":
                rest.append([word] + [self.next() for _ in range({"1": 4, "2": 5, "3": 7}[word])])
        elif kind == "Fa":
            rest = [self.next() for _ in range(4)]
        flags = self.next()
        need(len(flags) == 7, "flags")
        parts = []
        while self.words[self.at] != "*":
            part, placed = self.reference()
            need(placed == 0, "a part that is placed")
            parts.append(part)
        self.at += 1
        return kind, rest, parts
