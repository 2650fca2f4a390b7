# SPDX-License-Identifier: CC0-1.0
"""Decides CAD models of faces that are extruded along z or rotated about z: in the section of the
common edge each face is a line, a circle or a spline."""

from fractions import Fraction as F

import part21
from joins import PI, SCALE, Decided, Side, combine, curvature, inner, is_zero, need, number, order_within, spline_sides, verify_flip, verify_measures


class Section:
    """How points and vectors in space are seen."""

    def __init__(self, rotated):
        self.rotated = rotated

    def point(self, p):
        if not self.rotated:
            return p[:2]
        need(p[0] == 0 or p[1] == 0, "a point beside the planes x = 0 and y = 0")
        return [abs(p[0] + p[1]), p[2]]


class Face:
    def __init__(self, model, entity, section):
        self.model, self.section = model, section
        _, bounds, self.surface, same_sense = entity
        _, loop, as_it_is = model.get(bounds[0], "FACE_OUTER_BOUND")
        uses = [model.get(e, "ORIENTED_EDGE") for e in model.get(loop, "EDGE_LOOP")[1]]
        self.edges = [use[3] for use in uses]
        self.forward = {use[3]: (use[4] == ".T.") == (as_it_is == ".T.") for use in uses}
        self.same_sense = same_sense == ".T."

    def vertices(self):
        for e in self.edges:
            for v in self.model.get(e, "EDGE_CURVE")[1:3]:
                yield self.model.point(self.model.get(v, "VERTEX_POINT")[1])

    def placement(self, reference):
        _, origin, axis, _ = self.model.get(reference, "AXIS2_PLACEMENT_3D")
        return self.model.point(origin), self.model.point(axis)

    def normal(self, p):
        """Returns the normal of the face, in the section."""
        model, (kind, a) = self.model, self.model.entities[self.surface]
        rotated = self.section.rotated
        if kind == "PLANE":
            axis = self.placement(a[1])[1]
            n = [F(0), axis[2]] if rotated else axis[:2]
        elif kind in ("SURFACE_OF_LINEAR_EXTRUSION", "SURFACE_OF_REVOLUTION"):
            along = self.curve(p)[0]
            first, last = (self.section.point(model.spline_curve(a[1])[2][k]) for k in (0, -1))
            if p == last:  # the vector points into the face, against the profile
                along = combine((-1, along))
            need(p in (first, last), "an edge inside of a profile")
            if rotated:
                turn = model.point(model.get(a[2], "AXIS1_PLACEMENT")[2])[2]
                n = [turn * along[1], -turn * along[0]]
            else:
                length = model.point(model.get(a[2], "VECTOR")[1])[2]
                n = [length * along[1], -length * along[0]]
        else:
            toward = self.curve(p)[1]
            n = combine((-1, toward)) if not is_zero(toward) else [F(1), F(0)]
        return n if self.same_sense else combine((-1, n))

    def verify_orientation(self, p, edge, up):
        """Its boundary runs counter-clockwise, seen from its normal. `up` is 1 if the edge runs along the axis, or counter-clockwise about it."""
        n, u = self.normal(p), self.curve(p)[0]
        turn = n[1] * u[0] - n[0] * u[1] if not self.section.rotated else n[0] * u[1] - n[1] * u[0]
        need(turn * up * (1 if self.forward[edge] else -1) > 0, "a face whose boundary runs the wrong way")

    def curve(self, p):
        """From the point p of the edge into the face: a vector along it and the vector of curvature."""
        model, (kind, a) = self.model, self.model.entities[self.surface]
        others = [q for q in map(self.section.point, self.vertices()) if q != p]
        need(others, "a face of one point")
        q = max(others, key=lambda q: inner(combine((1, q), (-1, p)), combine((1, q), (-1, p))))
        toward = combine((1, q), (-1, p))
        rotated = self.section.rotated
        if kind == "PLANE":
            origin, normal = self.placement(a[1])
            if rotated:
                need(normal[:2] == [0, 0] and p[1] == q[1] == origin[2], "a plane that is not across the axis")
            else:
                need(normal[2] == 0, "a plane that is not along z")
                need(all(inner(normal[:2], combine((1, x), (-1, origin[:2]))) == 0 for x in (p, q)), "a vertex beside the plane")
            return toward, [F(0), F(0)]
        if kind in ("CYLINDRICAL_SURFACE", "SPHERICAL_SURFACE", "TOROIDAL_SURFACE"):
            origin, axis = self.placement(a[1])
            need(axis[:2] == [0, 0] and (not rotated or origin[:2] == [0, 0]), "another axis")
            if rotated and kind == "CYLINDRICAL_SURFACE":
                need(p[0] == q[0] == a[2], "a vertex beside the cylinder")
                return toward, [F(0), F(0)]
            centre = origin[:2] if not rotated else [a[2] if kind == "TOROIDAL_SURFACE" else F(0), origin[2]]
            radius = a[-1]
            to_centre = combine((1, centre), (-1, p))
            need(all(inner(d, d) == radius**2 for d in (to_centre, combine((1, centre), (-1, q)))), "a vertex beside the circle")
            along = [-to_centre[1], to_centre[0]]
            need(inner(along, toward) != 0, "half a circle")
            return along if inner(along, toward) > 0 else combine((-1, along)), combine((1 / radius**2, to_centre))
        if kind in ("SURFACE_OF_LINEAR_EXTRUSION", "SURFACE_OF_REVOLUTION"):
            degree, knots, points, weights = model.spline_curve(a[1])
            if rotated:
                axis = model.get(a[2], "AXIS1_PLACEMENT")
                need(model.point(axis[1])[:2] == [0, 0] and model.point(axis[2])[:2] == [0, 0] and all(x[1] == 0 for x in points), "another axis")
            else:
                need(model.point(model.get(a[2], "VECTOR")[1])[:2] == [0, 0], "another direction")
            flat = [self.section.point(x) for x in points]
            sides = spline_sides(degree, knots, flat, weights)
            for side, sign in ((sides[0][0], 1), (sides[-1][1], -1)):
                if side.jet[0] == p:
                    return combine((sign, side.jet[1])), curvature(side.jet)
        raise ValueError(f"{kind} is not read here")


def length_factor(model):
    """Millimetres in the unit of the file."""
    for e in model.entities.values():
        parts = dict(e) if isinstance(e, list) else {}
        if "CONVERSION_BASED_UNIT" in parts:
            return F("25.4")
        if "LENGTH_UNIT" in parts and "SI_UNIT" in parts:
            factor = {".MILLI.": F(1), "$": F(1000), ".CENTI.": F(10), ".MICRO.": F(1, 1000)}[parts["SI_UNIT"][0]]
    return factor


def verify_placement(record, mapping):
    """The placement that a file has, and whether what is read here is mirrored."""
    if mapping:
        need((record["placed"], number(record["scale"]), record["mirrored"]) == mapping, "another placement")
    else:
        need("placed" not in record and "scale" not in record, "no placement")


def check(record, extension, data):
    need(extension == "step", "another format")
    model = part21.Model(data)
    need(length_factor(model) == {"mm": 1, "m": 1000, "cm": 10, "inch": F("25.4"), "um": F(1, 1000)}[record["unit"]], "another unit")
    section = Section(record["section"] in ("rotated", "full", "cone"))
    faces = [Face(model, a, section) for a in model.all("ADVANCED_FACE")]
    shared = [e for e in faces[0].edges if e in faces[1].edges]
    need(len(faces) == 2 and len(shared) == 1, "two faces with a common edge were expected")
    begin, _, geometry = model.get(shared[0], "EDGE_CURVE")[1:4]
    p = section.point(model.point(model.get(begin, "VERTEX_POINT")[1]))
    kind = model.kind(geometry)
    need(kind == ("CIRCLE" if section.rotated else "LINE"), "another edge")
    need(faces[0].forward[shared[0]] != faces[1].forward[shared[0]], "both faces run along the edge in one direction")
    verify_placement(record, model.mapping())
    scale = number(record.get("scale", "1"))
    if record["section"] == "apart":
        heights = [f.placement(model.get(f.surface, "PLANE")[1])[0][2] * length_factor(model) for f in faces]
        need(number(record["gap"][0]) == number(record["gap"][1]) == abs(heights[0] - heights[1]) * scale, "the gap is another one")
        need(record["order"] == order_within(record, record["gap"], record["angle_degrees"], record["curvature_percent"]), "another order")
        return verify_flip(record)
    if record["section"] == "cone":
        cylinder, cone = (model.get(f.surface) for f in faces)
        need(cone[2] == cylinder[2] and faces[1].placement(cone[1])[0][2] == p[1], "the cone does not meet the cylinder there")
        need(record["gap"] == ["0", "0"] and record["curvature_percent"] is None, "a size that is not asked for")
        low, high = (number(x) * PI / SCALE for x in record["angle_degrees"])
        need(low <= cone[3] * 180 <= high and (high - low) * 10**20 < high and record["order"] == "G0", "the angle is another one")
        return verify_flip(record)
    (u, k), (v, j) = (f.curve(p) for f in faces)
    axis = model.point(model.get(model.get(geometry, "CIRCLE")[1], "AXIS2_PLACEMENT_3D")[2] if section.rotated else model.get(model.get(geometry, "LINE")[2], "VECTOR")[1])
    for f in faces:
        f.verify_orientation(p, shared[0], axis[2])
    # As large as it is placed: curvatures become smaller.
    k, j = (combine((1 / scale, x)) for x in (k, j))
    p = combine((scale, p))
    zero = [F(0), F(0)]
    left = Side([p, combine((-1, u)), combine((inner(u, u), k)), zero], True, None)
    right = Side([p, v, combine((inner(v, v), j)), zero], False, None)
    join = Decided(left, right)
    need(not is_zero(u) and not is_zero(v), "a face without a direction")
    verify_measures(record, join)
    if "within" in record:
        reached = order_within(record, record["gap"], record["angle_degrees"], record["curvature_percent"])
    else:
        reached = f"G{min(join.g, int(record['up_to'][1]))}"
    need(record["order"] == reached, f"the order is {reached}")
    return verify_flip(record)
