# SPDX-License-Identifier: CC0-1.0
"""The text format of OpenCASCADE for shapes, BREP: spline faces with their curves in the parameters,
edges that they share, and a placement, which may mirror and scale. The numbers are the exact decimals."""

from truth import text


def words(v):
    return " ".join(map(text, v))


def knots_of(knots):
    return [f"{text(t)} {knots.count(t)}" for t in sorted(set(knots))]


class Brep:
    """Faces that share edges and vertices where their curves and points are equal."""

    def __init__(self, tolerance="1e-07"):
        self.tolerance = tolerance
        self.curves, self.images, self.surfaces = [], [], []
        self.vertices, self.edges, self.faces = {}, {}, []

    def curve(self, c, lines):
        """The number of a spline in a list, in space or in parameters."""
        points = [[*p, c.weights[i]] if c.weights else p for i, p in enumerate(c.points)]
        knots = knots_of(c.knots)
        lines.append(f"7 {int(bool(c.weights))} 0  {c.degree} {len(points)} {len(knots)}  " + "  ".join(map(words, points)) + " \n " + " ".join(knots))
        return len(lines)

    def surface(self, s):
        u, v = knots_of(s.u), knots_of(s.v)
        rational = int(bool(s.weights))
        rows = [[[*p, s.weights[i][j]] if rational else p for j, p in enumerate(row)] for i, row in enumerate(s.points)]
        self.surfaces.append(f"9 {rational} {rational} 0 0 {s.degrees[0]} {s.degrees[1]} {len(rows)} {len(rows[0])} {len(u)} {len(v)} " +
                             "\n".join("  ".join(map(words, row)) for row in rows) + "\n\n" + "\n".join(u) + "\n\n" + "\n".join(v) + "\n")
        return len(self.surfaces)

    def vertex(self, p):
        return self.vertices.setdefault(tuple(p), len(self.vertices))

    def face(self, surface, sides, same_sense=True):
        """`sides` are (curve, is it run forward, its image in the parameters), counter-clockwise in the parameters. A side that is a point has no curve."""
        loop = []
        for c, forward, image in sides:
            key, backwards = c.keys()
            collapsed = all(p == c.points[0] for p in c.points)
            if collapsed:
                key = backwards = (len(self.edges),)
            same = key in self.edges or backwards not in self.edges
            if key not in self.edges and same:
                curve = None if collapsed else self.curve(c, self.curves)
                self.edges[key] = {"number": len(self.edges), "curve": curve, "range": (c.knots[0], c.knots[-1]), "ends": (self.vertex(c.points[0]), self.vertex(c.points[-1])), "images": {}}
            edge = self.edges[key if same else backwards]
            runs = forward == same
            edge["images"].setdefault(surface, {})[runs] = self.curve(image if same else image.reversed(), self.images)
            loop.append((edge["number"], runs))
        self.faces.append((surface, loop, same_sense))

    def write(self, placed=None):
        """`placed` is (axes, origin, scale)."""
        shapes, place = [], {}

        def add(kind, head, flags, parts):
            """Parts are (what, its number, is it forward); shapes are counted from the last one."""
            place[kind, len([p for p in place if p[0] == kind])] = len(shapes)
            shapes.append((kind, head, flags, parts))
        for p in self.vertices:
            add("Ve", f"{self.tolerance}\n{words(p)}\n0 0\n", "0101101", [])
        for e in self.edges.values():
            a, b = map(text, e["range"])
            lines = [f" {self.tolerance} 1 1 {int(e['curve'] is None)}"]
            if e["curve"]:
                lines.append(f"1  {e['curve']} 0 {a} {b}")
            for surface, images in e["images"].items():
                if len(images) == 2:
                    lines.append(f"3  {images[True]} {images[False]}C0 {surface} 0 {a} {b}")
                else:
                    lines.append(f"2  {next(iter(images.values()))} {surface} 0 {a} {b}")
            add("Ed", "\n".join(lines + ["0", ""]), "0101000", [("Ve", e["ends"][0], True), ("Ve", e["ends"][1], False)])
        for i, (surface, loop, _) in enumerate(self.faces):
            add("Wi", "", "0101100", [("Ed", n, runs) for n, runs in loop])
            add("Fa", f"0  {self.tolerance} {surface} 0\n", "0111000", [("Wi", i, True)])
        add("Sh", "", "0101000", [("Fa", i, same) for i, (_, _, same) in enumerate(self.faces)])
        lines = ["DBRep_DrawableShape", "", "CASCADE Topology V1, (c) Matra-Datavision"]
        if placed:
            columns, origin, scale = placed
            rows = [[*(scale * c[k] for c in columns), origin[k]] for k in range(3)]
            lines += ["Locations 1", "1"] + [" ".join(map(text, row)) for row in rows]
        else:
            lines.append("Locations 0")
        lines += [f"Curve2ds {len(self.images)}", *self.images, f"Curves {len(self.curves)}", *self.curves, "Polygon3D 0", "PolygonOnTriangulations 0",
                  f"Surfaces {len(self.surfaces)}", *self.surfaces, "Triangulations 0", "", f"TShapes {len(shapes)}"]
        for kind, head, flags, parts in shapes:
            names = " ".join(f"{'+' if forward else '-'}{len(shapes) - place[what, n]} 0" for what, n, forward in parts)
            lines += [kind, head + "\n" + flags, names + " *" if names else "*"]
        return "\n".join(lines) + f"\n\n+1 {int(bool(placed))} \n"
