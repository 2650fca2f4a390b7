# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes plates with rounded outlines, holes and bosses as NAME.step to the current folder, by
FreeCAD, and prints a line for each: its name, a set-back, bounds of the volume when all edges are
rounded, the number of edges that are rounded, and that of G1 edges between arcs and lines in the
result. The exit code is 77 without FreeCAD."""
import math
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
try:
    import FreeCAD
    import Part
except ImportError:
    sys.exit(77)

V = FreeCAD.Vector


def rectangle(x, y, r):
    """With rounded corners, from (0, 0) to (x, y)."""
    k = r * (1 - math.sqrt(0.5))
    ends = [(r, 0), (x - r, 0), (x, r), (x, y - r), (x - r, y), (r, y), (0, y - r), (0, r)]
    middles = [(x - k, k), (x - k, y - k), (k, y - k), (k, k)]
    ends = [V(a, b, 0) for a, b in ends]
    edges = []
    for i, (a, b) in enumerate(middles):
        edges.append(Part.LineSegment(ends[2 * i], ends[2 * i + 1]).toShape())
        edges.append(Part.Arc(ends[2 * i + 1], V(a, b, 0), ends[(2 * i + 2) % 8]).toShape())
    return Part.Wire(edges)


def slot(a, b, y, r):
    return Part.Wire([Part.LineSegment(V(a, y - r, 0), V(b, y - r, 0)).toShape(),
                      Part.Arc(V(b, y - r, 0), V(b + r, y, 0), V(b, y + r, 0)).toShape(),
                      Part.LineSegment(V(b, y + r, 0), V(a, y + r, 0)).toShape(),
                      Part.Arc(V(a, y + r, 0), V(a - r, y, 0), V(a, y - r, 0)).toShape()])


def extruded(wire, height):
    return Part.Face(wire).extrude(V(0, 0, height))


def hole(x, y, r):
    return Part.makeCylinder(r, 8, V(x, y, 0))


def turned(shape):
    shape = shape.copy()
    shape.rotate(V(1, 2, 3), V(1, 1, 0.3), 37)
    return shape



box = Part.makeBox(40, 30, 8)
plate = extruded(rectangle(40, 30, 6), 8)
spline = Part.BSplineCurve()
spline.interpolate([V(20, 0, 0), V(12, 14, 0), V(-3, 12, 0), V(-18, 6, 0), V(-15, -8, 0), V(2, -12, 0)], PeriodicFlag=True)
boss = Part.makeCylinder(6, 10, V(20, 15, 8))
outline = rectangle(40, 30, 6)
slotted = slot(14, 26, 15, 4)
closed_spline, ellipse = Part.Wire(spline.toShape()), Part.Wire(Part.Ellipse(V(0, 0, 0), 20, 10).toShape())


def circle(r):
    return 2 * math.pi * r


def polygon_area(curve):
    first, last, n = curve.FirstParameter, curve.LastParameter, 20000
    points = [curve.value(first + (last - first) * i / n) for i in range(n)]
    return abs(sum(p.x * q.y - p.y * q.x for p, q in zip(points, points[1:] + points[:1]))) / 2


def removed(length, d, turn):
    """The volume between the corner and the blend along a closed outline, which is longer by 2 pi x at
    a distance x in the plane with turn 1, and shorter with -1."""
    g = 0.6875
    a, b = (1, 1 - g / 2, 1 - g, 0, 0, 0), (0, 0, 0, 1 - g, 1 - g / 2, 1)

    def bernstein(c, v):
        return sum(math.comb(5, i) * v**i * (1 - v) ** (5 - i) * c[i] for i in range(6))

    area = moment = 0
    n = 4000
    for k in range(n):
        x, depth = bernstein(b, (k + 0.5) / n), bernstein(a, (k + 0.5) / n)
        dx = bernstein(b, (k + 1) / n) - bernstein(b, k / n)
        area += depth * dx
        moment += depth * x * dx
    return d**2 * area * length + turn * 2 * math.pi * d**3 * moment


# with the rims: their lengths, the sign of the turn, 1 for convex and -1 for concave ones
solids = [
    ("disc", Part.makeCylinder(10, 5), 1.5, 2, 0, 2 * [(circle(10), -1, 1)]),
    ("plate", plate, 2, 16, 24, 2 * [(outline.Length, -1, 1)]),
    ("plate_holes", plate.cut(hole(12, 15, 5)).cut(hole(28, 15, 4)), 1, 20, 24,
     2 * [(outline.Length, -1, 1), (circle(5), 1, 1), (circle(4), 1, 1)]),
    ("plate_slot", plate.cut(extruded(slotted, 8)), 1.25, 24, 36, 2 * [(outline.Length, -1, 1), (slotted.Length, 1, 1)]),
    ("spline", extruded(closed_spline, 8), 1.5, 2, 3, 2 * [(closed_spline.Length, -1, 1)]),
    ("ellipse", extruded(ellipse, 8), 1.5, 2, 0, 2 * [(ellipse.Length, -1, 1)]),
    ("plate_boss", plate.fuse(boss).removeSplitter(), 1.5, 18, 24,
     2 * [(outline.Length, -1, 1)] + [(circle(6), -1, 1), (circle(6), 1, -1)]),
    ("box_holes", box.cut(hole(12, 15, 5)).cut(hole(28, 15, 4)), 1, 16, 0, None),
    ("box_boss", box.fuse(boss).removeSplitter(), 1.5, 14, 0, None),
    ("box_pocket", box.cut(Part.makeCylinder(6, 4, V(20, 15, 4))), 1, 14, 0, None),
]
solids += [("turned_" + solid[0], turned(solid[1])) + solid[2:] for solid in solids if solid[0] in ("plate_slot", "box_boss")]
# two corners are round, and two are sharp
k = 6 * (1 - math.sqrt(0.5))
half = [Part.LineSegment(V(0, 0, 0), V(40, 0, 0)), Part.LineSegment(V(40, 0, 0), V(40, 24, 0)),
        Part.Arc(V(40, 24, 0), V(40 - k, 30 - k, 0), V(34, 30, 0)), Part.LineSegment(V(34, 30, 0), V(6, 30, 0)),
        Part.Arc(V(6, 30, 0), V(k, 30 - k, 0), V(0, 24, 0)), Part.LineSegment(V(0, 24, 0), V(0, 0, 0))]
extruded(Part.Wire([e.toShape() for e in half]), 8).exportStep("half_plate.step")
for name, shape, d, edges, g1, rims in solids:
    shape.exportStep(name + ".step")
    if rims is None:  # at an edge of the length L lies a triangle of the area d d / 2
        cut = sum(e.Length + 2 * math.pi * d for e in shape.Edges) * d * d / 2
        volumes = shape.Volume - cut, shape.Volume + (0 if name == "box_holes" else cut)
    else:
        # FreeCAD finds 0.2 % too little for the plate of a spline
        volume = 8 * polygon_area(spline) if name == "spline" else shape.Volume
        volume -= sum(sign * removed(length, d, turn) for length, turn, sign in rims)
        volumes = volume * (1 - 5e-5), volume * (1 + 5e-5)
    print(name, d, *volumes, edges, g1)
