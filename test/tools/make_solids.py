# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes solids as NAME.off to the current folder, and prints a line for each: its name, a distance
by which its edges can be set back, the volume that is left if each edge is cut off by a plane, and
the whole volume."""
import math

GOLDEN = (1 + math.sqrt(5)) / 2


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def prism(outline, width):
    n = len(outline)
    points = [(x, 0, z) for x, z in outline] + [(x, width, z) for x, z in outline]
    faces = [[i, i + n, (i + 1) % n + n, (i + 1) % n] for i in range(n)]
    return points, faces + [list(range(n)), list(range(2 * n - 1, n - 1, -1))]


def convex(points, normals):
    """The faces are in the planes with these normals that hold points."""
    faces = []
    for n in normals:
        highest = max(dot(n, p) for p in points)
        face = [i for i, p in enumerate(points) if dot(n, p) > highest - 1e-9]
        middle = tuple(sum(points[i][k] for i in face) / len(face) for k in range(3))
        x = minus(points[face[0]], middle)
        y = cross(n, x)
        faces.append(sorted(face, key=lambda i: math.atan2(dot(minus(points[i], middle), y) / math.sqrt(dot(n, n)), dot(minus(points[i], middle), x))))
    return points, faces


def signs(*values):
    return [(a, b) for a in (-values[0], values[0]) for b in (-values[1], values[1])]


def dodecahedron():
    points = [(10 * a, 10 * b, 10 * c) for a, b in signs(1, 1) for c in (-1, 1)]
    for a, b in signs(10 / GOLDEN, 10 * GOLDEN):
        points += [(0, a, b), (a, b, 0), (b, 0, a)]
    normals = [n for a, b in signs(GOLDEN, 1) for n in ((0, a, b), (a, b, 0), (b, 0, a))]
    return convex(points, normals)


def turned(solid):
    """Turned about an axis, so that coordinates are rounded."""
    c, s = math.cos(0.7), math.sin(0.7)
    points = [(c * x - s * y, s * x + c * y, z) for x, y, z in solid[0]]
    return [(x + 5, c * y - s * z, s * y + c * z) for x, y, z in points], solid[1]


def volumes(solid, distance):
    points, faces = solid
    volume = sum(dot(points[f[0]], cross(points[f[i]], points[f[i + 1]])) for f in faces for i in range(1, len(f) - 1)) / 6
    normals, sides = [], {}
    for f in faces:
        n = (0, 0, 0)
        for i in range(1, len(f) - 1):
            n = tuple(x + y for x, y in zip(n, cross(minus(points[f[i]], points[f[0]]), minus(points[f[i + 1]], points[f[0]]))))
        normals.append(tuple(x / math.sqrt(dot(n, n)) for x in n))
        for i in range(len(f)):
            sides.setdefault(frozenset((f[i], f[i - 1])), []).append(n)
    # At an edge lies a triangle with two sides of this distance.
    cut = 0
    for (a, b), (m, n) in ((tuple(edge), pair) for edge, pair in sides.items()):
        c = cross(m, n)
        cut += math.dist(points[a], points[b]) * distance**2 / 2 * math.sqrt(dot(c, c) / (dot(m, m) * dot(n, n)))
    return volume - cut, volume


bracket = prism([(0, 0), (40, 0), (40, 8), (8, 8), (8, 30), (0, 30)], 20)
for name, solid, distance in (
    ("box", prism([(0, 0), (30, 0), (30, 10), (0, 10)], 20), 2),
    ("prism", prism([(10 * math.cos(math.pi * k / 3), 10 * math.sin(math.pi * k / 3)) for k in range(6)], 8), 1),
    ("bracket", bracket, 1.5),
    ("turned_bracket", turned(bracket), 1.5),
    ("tetrahedron", convex([(10, 10, 10), (10, -10, -10), (-10, 10, -10), (-10, -10, 10)], [(-1, -1, -1), (-1, 1, 1), (1, -1, 1), (1, 1, -1)]), 2),
    ("dodecahedron", dodecahedron(), 1.5),
):
    least, most = volumes(solid, distance)
    with open(name + ".off", "w") as file:
        print("OFF\n%d %d 0" % (len(solid[0]), len(solid[1])), file=file)
        for p in solid[0]:
            print(*("%r" % x for x in p), file=file)
        for f in solid[1]:
            print(len(f), *f, file=file)
    print(name, distance, least, most)
