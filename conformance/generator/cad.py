# SPDX-License-Identifier: CC0-1.0
"""Models for CAD: profiles that are extruded or rotated, so that the section tells what their edges
are; spheres with poles, closed surfaces with seams."""

from fractions import Fraction as F

import surfaces
from step import Arc, Shell, real
from truth import Curve, PI, determinant, enclosure, exact, dot, is_decimal, ladder, name as named, plus, text
from chains import chain_join


class Piece:
    """A part of a profile: a line, an arc with a centre, or a spline."""

    def __init__(self, points, centre=None, counter=True):
        self.centre = [exact(x) for x in centre.split(",")] if centre else None
        self.counter = counter
        if isinstance(points, Curve):
            self.curve, self.kind = points, "spline"
            return
        ends = [[exact(x) for x in p.split(",")] for p in points.split()]
        self.kind = "arc" if centre else "line" if len(ends) == 2 else "spline"
        if centre:
            u, v = (plus(p, self.centre, -1) for p in ends)
            cosine = dot(u, v) / dot(u, u)
            assert dot(u, u) == dot(v, v)
            middle = plus(self.centre, [(a + b) / (1 + cosine) for a, b in zip(u, v)])
            self.curve = Curve([ends[0], middle, ends[1]], weights=[F(1), F(1), 2 / (1 + cosine)])
            self.squared_radius = dot(u, u)
        else:
            self.curve = Curve(ends)

    def start(self):
        return self.curve.points[0]

    def end(self):
        return self.curve.points[-1]

    def radius(self):
        return next(F(n, 100) for n in range(1, 10**6) if F(n, 100) ** 2 == self.squared_radius)

    def edge(self, lift, lift_direction):
        """As a curve in space."""
        if self.kind == "arc":
            axis = lift_direction if self.counter else [-x for x in lift_direction]
            return Arc(lift(self.centre), axis, self.radius(), lift(self.start()), lift(self.end()))
        return Curve([lift(p) for p in self.curve.points], self.curve.knots, self.curve.weights, self.curve.degree)


def extruded(file, pieces, height=F(10), split=None):
    """Along z. The profile lies in the plane z = 0."""
    shell = Shell(*file)
    for piece in pieces:
        at = lambda z: (lambda p: [p[0], p[1], z])
        low, high = piece.edge(at(F(0)), [0, 0, 1]), piece.edge(at(height), [0, 0, 1])
        same = True
        p, q = piece.start(), piece.end()
        if piece.kind == "line":
            d = plus(q, p, -1)
            surface = shell.add(f"PLANE('',{shell.placement([*p, 0], [d[1], -d[0], 0], [*d, 0])})")
        elif piece.kind == "arc":
            surface = shell.add(f"CYLINDRICAL_SURFACE('',{shell.placement([*piece.centre, 0], [0, 0, 1], [1, 0, 0])},{real(piece.radius())})")
            same = piece.counter
        else:
            profile = shell.spline(low)
            vector = shell.add(f"VECTOR('',{shell.direction([0, 0, 1])},1.)")
            surface = shell.add(f"SURFACE_OF_LINEAR_EXTRUSION('',{profile},{vector})")
        rise = lambda r: Curve([[*r, F(0)], [*r, height]])
        shell.face(surface, [(low, True, None), (rise(q), True, None), (high, False, None), (rise(p), False, None)], same, piece.kind == "spline")
    return shell


def rotated(file, pieces, full=False):
    """About z. The profile has coordinates (distance from the axis, z)."""
    shell = Shell(*file)
    for piece in pieces:
        p, q = piece.start(), piece.end()
        at = lambda x, y: (lambda r: [r[0] * x, r[0] * y, r[1]])
        same = True
        if piece.kind == "line" and p[0] == q[0]:
            surface = shell.add(f"CYLINDRICAL_SURFACE('',{shell.placement([0, 0, p[1]], [0, 0, 1], [1, 0, 0])},{real(p[0])})")
            same = q[1] > p[1]
        elif piece.kind == "line" and p[1] == q[1]:
            same = q[0] < p[0]
            surface = shell.add(f"PLANE('',{shell.placement([0, 0, p[1]], [0, 0, 1], [1, 0, 0])})")
        elif piece.kind == "arc" and piece.centre[0] == 0:
            surface = shell.add(f"SPHERICAL_SURFACE('',{shell.placement([0, 0, piece.centre[1]], [0, 0, 1], [1, 0, 0])},{real(piece.radius())})")
            same = piece.counter
        elif piece.kind == "arc":
            surface = shell.add(f"TOROIDAL_SURFACE('',{shell.placement([0, 0, piece.centre[1]], [0, 0, 1], [1, 0, 0])},{real(piece.centre[0])},{real(piece.radius())})")
            same = piece.counter
        else:
            assert piece.kind == "spline", "a cone"
            profile = shell.spline(piece.edge(at(1, 0), [0, -1, 0]))
            axis = shell.add(f"AXIS1_PLACEMENT('',{shell.point([0, 0, 0])},{shell.direction([0, 0, 1])})")
            surface = shell.add(f"SURFACE_OF_REVOLUTION('',{profile},{axis})")
        circle = lambda r: Arc([F(0), F(0), r[1]], [0, 0, 1], r[0], [r[0], F(0), r[1]], [r[0], F(0), r[1]] if full else [F(0), r[0], r[1]])
        sides = [(circle(p), True, None)] if p[0] else []
        sides.append((piece.edge(at(1, 0), [0, -1, 0]) if full else piece.edge(at(0, 1), [1, 0, 0]), True, None))
        sides += [(circle(q), False, None)] if q[0] else []
        sides.append((piece.edge(at(1, 0), [0, -1, 0]), False, None))
        # The normal of a revolution follows its axis, which a mirror leaves as it is.
        shell.face(surface, sides, same)
    return shell


UNIT = [[F(1), F(0), F(0)], [F(0), F(1), F(0)], [F(0), F(0), F(1)]]
MIRROR = ([[F(-1), F(0), F(0)], [F(0), F(1), F(0)], [F(0), F(0), F(1)]], [F(0), F(0), F(0)])
def patches_of(pieces, how, height=F(10)):
    """Returns the same faces as splines, which BREP can hold exactly: extruded profiles, or a quarter turn of them. None of a full turn, whose parts
    are no single polynomials."""
    def patch(c):
        if how == "extruded":
            points, factors = [[[*p, F(0)], [*p, height]] for p in c.points], [F(1), F(1)]
        else:
            points, factors = [[[r, F(0), z], [r, r, z], [F(0), r, z]] for r, z in c.points], [F(1), F(1), F(2)]
        result = surfaces.Patch(points, degrees=(c.degree, len(factors) - 1))
        result.u = c.knots
        if c.weights or how != "extruded":
            result.weights = [[w * f for f in factors] for w in c.weights or [F(1)] * len(c.points)]
        return result
    return None if how == "full" else [patch(p.curve) for p in pieces]


def framed(patches, frame):
    """Points in a frame that is turned or mirrored."""
    for s in patches:
        s.points = [[[dot(row, p) + d for row, d in zip(*frame)] for p in line] for line in s.points]
    return patches


PLACED = ([[F(3, 5), F(-4, 5), F(0)], [F(4, 5), F(3, 5), F(0)], [F(0), F(0), F(1)]], [F(100), F(-20), F("0.1")])


def cases(suite):
    def scaled(measures, scale):
        by = lambda pair, k: pair and enclosure(exact(pair[0]) * k, exact(pair[1]) * k)
        return {**measures, "gap": by(measures["gap"], scale), "curvature_jump": by(measures["curvature_jump"], 1 / scale)}

    def model(name, question, why, how, pieces, expect, unit="mm", within=None, frame=None, up_to="G2", placed=None):
        pieces = [p if isinstance(p, Piece) else Piece(p) for p in pieces]
        join = chain_join(pieces[0].curve, pieces[1].curve)
        measures = join.measures()
        order = ladder(measures, within) if within else min(join.traced, int(up_to[1]))
        if named(order) != expect:
            suite.problems.append(f"cad/{name}: {expect} expected, {named(order)} computed")
        file = (f"cad/{name}", unit, "0.000001", frame)
        shell = extruded(file, pieces) if how == "extruded" else rotated(file, pieces, how == "full")
        more = {"within": within} if within else {}
        measures["torsion_jump"] = None
        if placed:
            measures = scaled(measures, placed[3])
            more.update(placed=placed[0], mirrored=determinant(*placed[1]) < 0, scale=text(placed[3]))
        elif frame:
            more["mirrored"] = shell.mirrored
        files = {"step": shell.close(placed)}
        patches = patches_of(pieces, how)
        if patches and unit == "mm":
            patches = framed(patches, frame) if frame else patches
            if all(is_decimal(x) for s in patches for row in s.points + (s.weights or []) for p in row for x in (p if isinstance(p, list) else [p])):
                files["brep"] = surfaces.as_brep(patches, placed and placed[1:], patches if shell.mirrored else ())
        suite.record(f"cad/{name}", "cad", question, why, expect, up_to, measures, files, section=how, unit=unit, **more)

    E, Q, W = "extruded", "rotated", "full"
    # ---- Extruded profiles: planes, cylinders, extrusions.
    model("planes-corner", "position", "Two planes at a right angle.", E, ["0,0 4,0", "4,0 4,4"], "G0", up_to="G0")
    model("planes-coplanar", "tangent", "Two faces of one plane.", E, ["0,0 4,0", "4,0 9,0"], "G2")
    for slope in ("0.1", "0.01", "0.001", "0.0001", "0.000001", "0.00000001"):
        model(f"planes-kink-{slope}", "tangent", f"Two planes that include an angle of {slope}, nearly.", E, ["0,0 4,0", f"4,0 8,{text(4 * F(slope))}"], "G0")
    model("planes-turned-back", "tangent", "A face that turns back over the other one.", E, ["0,0 4,0", "4,0 1,0"], "G0")
    quarter = Piece("4,0 8,4", "4,4")
    model("plane-cylinder", "curvature", "A plane touches a cylinder, as a fillet of constant radius does.", E, ["0,0 4,0", quarter], "G1")
    model("cylinder-cylinder", "curvature", "Two faces of one cylinder.", E, [quarter, Piece("8,4 4,8", "4,4")], "G2")
    model("cylinder-radius", "curvature", "Cylinders of radius 4 and 2 that touch from inside.", E, [quarter, Piece("8,4 6,6", "6,4")], "G1")
    model("cylinder-radius-nearly", "curvature", "Cylinders of radius 4 and 4.01 that touch from inside.", E, [quarter, Piece("8,4 3.99,8.01", "3.99,4")], "G1")
    model("cylinder-other-side", "curvature", "Cylinders of one radius that touch from outside.", E, [quarter, Piece("8,4 12,8", "12,4", False)], "G1")
    model("cylinder-kink", "tangent", "A plane that leaves a cylinder at an angle of 0.573 degrees.", E, [quarter, "8,4 8.1,14"], "G0")
    model("extrusion-flat-end", "curvature", "A plane goes on in an extruded cubic whose first three points lie in it.", E, ["0,0 4,0", "4,0 8,0 12,0 16,8"], "G2")
    model("extrusion-jump", "curvature", "A plane goes on in an extruded cubic with curvature.", E, ["0,0 4,0", "4,0 8,0 12,1 16,8"], "G1")
    model("extrusion-osculates", "curvature", "An extruded cubic with the curvature of the cylinder before it, 1/4.", E, [quarter, "8,4 8,7 4.625,10 1,12"], "G2")
    model("extrusion-quadratic", "curvature", "An extruded quadratic with the curvature of the cylinder before it, 1/4.", E, [quarter, "8,4 8,8 0,14"], "G2")
    model("extrusion-kink", "tangent", "An extruded cubic that leaves a plane at 0.057 degrees.", E, ["0,0 4,0", "4,0 8,0.004 12,0 16,8"], "G0")
    model("placed", "tangent", "A kink of 0.1 percent in a frame that is rotated by the angle of (3, 4).", E, ["0,0 4,0", "4,0 8,0.004"], "G0", frame=PLACED)
    model("placed-smooth", "curvature", "A plane touches a cylinder, in a frame that is rotated by the angle of (3, 4).", E, ["0,0 4,0", quarter], "G1", frame=PLACED)

    # ---- A quarter turn of profiles: cylinders, planes, spheres, tori, surfaces of revolution.
    model("cylinder-disc", "position", "A cylinder and the plane that closes it.", Q, ["5,0 5,8", "5,8 1,8"], "G0", up_to="G0")
    model("cylinder-torus", "curvature", "A cylinder and the torus of a fillet.", Q, ["5,0 5,8", Piece("5,8 4,9", "4,8")], "G1")
    model("torus-disc", "curvature", "The torus of a fillet and a plane.", Q, [Piece("5,8 4,9", "4,8"), "4,9 1,9"], "G1")
    model("torus-torus", "curvature", "Two faces of one torus.", Q, [Piece("6,0 5,1", "5,0"), Piece("5,1 4,0", "5,0")], "G2")
    model("torus-torus-radius", "curvature", "Tori that touch, with tubes of radius 1 and 2.", Q, [Piece("6,0 5,1", "5,0"), Piece("5,1 3,-1", "5,-1")], "G1")
    model("cylinder-sphere", "curvature", "A cylinder and a sphere of its radius, as the end of a capsule.", Q, ["5,0 5,8", Piece("5,8 3,12", "0,8")], "G1")
    model("sphere-sphere", "curvature", "Two faces of one sphere, above each other.", Q, [Piece("5,0 4,3", "0,0"), Piece("4,3 3,4", "0,0")], "G2")
    model("sphere-torus", "curvature", "A sphere of radius 5 and a torus with a tube of radius 2.5 that touch.", Q, [Piece("5,0 4,3", "0,0"), Piece("4,3 2,4", "2,1.5")], "G1")
    model("sphere-kink", "tangent", "A rotated parabola leaves a sphere at the equator at an angle of 0.286 degrees.", Q,
          [Piece("3,-4 5,0", "0,0"), Piece("5,0 5.01,2 5,4")], "G0")
    model("sphere-cylinder-corner", "tangent", "A sphere and a cylinder of radius 4 meet at a corner of 36.87 degrees.", Q, [Piece("5,0 4,3", "0,0"), "4,3 4,9"], "G0")
    model("revolution-flat-end", "curvature", "A cylinder goes on in a rotated cubic whose first three points lie on it.", Q, ["5,0 5,4", "5,4 5,6 5,8 3,10"], "G2")
    model("revolution-jump", "curvature", "A cylinder goes on in a rotated cubic with curvature.", Q, ["5,0 5,4", "5,4 5,6 4.9,8 3,10"], "G1")
    model("revolution-kink", "tangent", "A rotated cubic leaves a cylinder at 0.029 degrees.", Q, ["5,0 5,4", "5,4 5.001,6 5,8 3,10"], "G0")
    model("revolution-smooth", "curvature", "Two halves of one parabola, rotated.", Q, ["6,0 5,2 5,4", "5,4 5,6 6,8"], "G2")

    # ---- Full turns: each face has a seam, and spheres have poles.
    model("ring", "curvature", "A whole cylinder and a whole torus: seams, and an edge that is a whole circle.", W, ["5,0 5,8", Piece("5,8 4,9", "4,8")], "G1")
    model("ring-smooth", "curvature", "Two cylinders above each other, each with its seam: all is one cylinder.", W, ["5,0 5,8", "5,8 5,12"], "G2")
    model("ring-corner", "tangent", "A whole cylinder and a plane ring.", W, ["5,0 5,8", "5,8 2,8"], "G0")
    model("capsule", "curvature", "A cylinder and a half sphere, up to its pole.", W, ["5,0 5,8", Piece("5,8 0,13", "0,8")], "G1")
    model("two-half-spheres", "curvature", "Two half spheres, from pole to pole: one sphere.", W, [Piece("0,-5 5,0", "0,0"), Piece("5,0 0,5", "0,0")], "G2")
    model("cap-with-pole", "curvature", "A rotated parabola that reaches the axis at a right angle, and the cylinder below it.", W, ["5,0 5,4", "5,4 5,9 0,9"], "G1")
    model("cap-with-tip", "tangent", "A rotated parabola that reaches the axis with a tip, and meets a cylinder at an angle of 0.573 degrees.", W, ["5,0 5,4", "5,4 4.95,9 0,14"], "G0")

    # ---- Mirrors: circles run the other way, products of derivatives point to the other side.
    osculating = Piece("8,4 8,7 4.625,10 1,12")
    half_parabolas = ["6,0 5,2 5,4", "5,4 5,6 6,8"]
    model("mirror-kink", "tangent", "Planes with a kink of 0.0573 degrees, mirrored at the plane x = 0.", E, ["0,0 4,0", "4,0 8,0.004"], "G0", frame=MIRROR)
    model("mirror-fillet", "curvature", "A plane touches a cylinder, all mirrored.", E, ["0,0 4,0", quarter], "G1", frame=MIRROR)
    model("mirror-cylinders", "curvature", "Two faces of one cylinder, mirrored.", E, [quarter, Piece("8,4 4,8", "4,4")], "G2", frame=MIRROR)
    model("mirror-extrusion", "curvature", "A cylinder goes on in an extruded cubic with its curvature, mirrored: the normal of the extrusion points to the other side.", E,
          [quarter, osculating], "G2", frame=MIRROR)
    model("mirror-revolution", "curvature", "Two halves of one parabola, rotated and mirrored.", Q, half_parabolas, "G2", frame=MIRROR)
    model("mirror-capsule", "curvature", "A cylinder and a half sphere up to its pole, mirrored: seams and a pole.", W, ["5,0 5,8", Piece("5,8 0,13", "0,8")], "G1", frame=MIRROR)

    # ---- Placed models: an item is mapped into its product, or a part is placed in an assembly.
    flipped = [[F(1), F(0), F(0)], [F(0), F(-1), F(0)], [F(0), F(0), F(1)]]
    turned = [list(row) for row in zip(*PLACED[0])]
    away, once, thrice = [F(10), F(20), F(30)], F(1), F(3)
    kink, fillet = ["0,0 4,0", "4,0 8,0.004"], ["0,0 4,0", quarter]
    model("mapped-turned", "curvature", "A plane touches a cylinder in an item that is mapped, turned by the angle of (3, 4).", E, fillet, "G1", placed=("mapped", turned, away, once))
    model("mapped-mirror-kink", "tangent", "A kink of 0.0573 degrees in an item whose map mirrors it.", E, kink, "G0", placed=("mapped", flipped, away, once))
    model("mapped-mirror-fillet", "curvature", "A plane touches a cylinder in an item whose map mirrors it.", E, fillet, "G1", placed=("mapped", flipped, away, once))
    model("mapped-mirror-smooth", "curvature", "A cylinder and an extruded cubic with its curvature, in an item whose map mirrors it.", E, [quarter, osculating], "G2",
          placed=("mapped", flipped, away, once))
    model("mapped-mirror-capsule", "curvature", "A capsule with seams and a pole in an item whose map mirrors it.", W, ["5,0 5,8", Piece("5,8 0,13", "0,8")], "G1",
          placed=("mapped", flipped, away, once))
    model("mapped-scaled", "curvature", "A plane touches a cylinder in an item that is three times as large: the jump of the curvature is 1/12.", E, fillet, "G1",
          placed=("mapped", UNIT, away, thrice))
    model("mapped-mirror-scaled", "curvature", "Two faces of one cylinder in an item that is mirrored and three times as large.", E, [quarter, Piece("8,4 4,8", "4,4")], "G2",
          placed=("mapped", flipped, away, thrice))
    model("part-turned", "tangent", "A kink of 0.0573 degrees in a part that an assembly places, turned by the angle of (3, 4).", E, kink, "G0", placed=("placement", turned, away, once))
    model("part-turned-fillet", "curvature", "A plane touches a cylinder in a part that an assembly places, turned by the angle of (3, 4).", E, fillet, "G1",
          placed=("placement", turned, away, once))
    model("part-mirror-kink", "tangent", "A kink of 0.0573 degrees in a part that an assembly mirrors.", E, kink, "G0", placed=("part", flipped, away, once))
    model("part-mirror-fillet", "curvature", "A plane touches a cylinder in a part that an assembly mirrors.", E, fillet, "G1", placed=("part", flipped, away, once))
    model("part-mirror-smooth", "curvature", "Two halves of one parabola, rotated, in a part that an assembly mirrors.", Q, half_parabolas, "G2", placed=("part", flipped, away, once))

    # ---- Units.
    for unit in ("m", "cm", "inch", "um"):
        model(f"unit-{unit}-kink", "tangent", f"Planes with a kink of 0.0573 degrees; lengths are in {unit}.", E, ["0,0 4,0", "4,0 8,0.004"], "G0", unit=unit)
        model(f"unit-{unit}-fillet", "curvature", f"A plane touches a cylinder; lengths are in {unit}.", E, ["0,0 4,0", quarter], "G1", unit=unit)

    # ---- Tolerances.
    A, C = "angle_degrees", "curvature_percent"
    model("within-angle", "tolerances", "A kink of 0.0573 degrees, and a tolerance of 0.1.", E, ["0,0 4,0", "4,0 8,0.004"], "G2", within={"gap": "0.001", A: "0.1", C: "2"})
    model("within-angle-above", "tolerances", "A kink of 0.0573 degrees, and a tolerance of 0.05.", E, ["0,0 4,0", "4,0 8,0.004"], "G0", within={"gap": "0.001", A: "0.05", C: "2"})
    model("within-curvature", "tolerances", "Radii of 4 and 4.01: 0.249 percent, and a tolerance of 0.25.", E, [quarter, Piece("8,4 3.99,8.01", "3.99,4")], "G2", within={"gap": "0.001", A: "0.1", C: "0.25"})
    model("within-curvature-above", "tolerances", "Radii of 4 and 4.01: 0.249 percent, and a tolerance of 0.249.", E, [quarter, Piece("8,4 3.99,8.01", "3.99,4")], "G1",
          within={"gap": "0.001", A: "0.1", C: "0.249"})

    # ---- Cones: their angle is a decimal, so that the kink is that number of radians.
    def cone(name, angle, why):
        shell = Shell(f"cad/{name}", "mm")
        cylinder = shell.add(f"CYLINDRICAL_SURFACE('',{shell.placement([0, 0, 0], [0, 0, 1], [1, 0, 0])},5.)")
        conical = shell.add(f"CONICAL_SURFACE('',{shell.placement([0, 0, 8], [0, 0, 1], [1, 0, 0])},5.,{real(angle)})")
        # The far end, where nothing is asked, has a radius of 17 digits.
        sine, cosine, term = F(0), F(1), F(1)
        for k in range(1, 40):
            term = term * F(angle) / k
            if k % 2:
                sine += term if k % 4 == 1 else -term
            else:
                cosine += term if k % 4 == 0 else -term
        top = 5 + 4 * F(round(sine / cosine * 10**17), 10**17)
        at = lambda r, z: ([r, F(0), F(z)], [F(0), r, F(z)])
        circle = lambda r, z: Arc([F(0), F(0), F(z)], [0, 0, 1], r, *at(r, z))
        rise = lambda i, r, z, s, w: Curve([at(r, z)[i], at(s, w)[i]])
        r = F(5)
        shell.face(cylinder, [(circle(r, 0), True, None), (rise(1, r, 0, r, 8), True, None), (circle(r, 8), False, None), (rise(0, r, 0, r, 8), False, None)])
        shell.face(conical, [(circle(r, 8), True, None), (rise(1, r, 8, top, 12), True, None), (circle(top, 12), False, None), (rise(0, r, 8, top, 12), False, None)])
        a = F(angle)
        kink = enclosure(a * 180 / F(PI) * (1 - F(1, 10**50)), a * 180 / F(PI) * (1 + F(1, 10**50)))
        measures = {"gap": ["0", "0"], "angle_degrees": kink, "curvature_jump": None, "curvature_percent": None, "torsion_jump": None}
        suite.record(f"cad/{name}", "cad", "tangent", why, "G0", "G2", measures, {"step": shell.close()}, section="cone", unit="mm")
    cone("cone-0.01", "0.01", "A cylinder and a cone with a half angle of exactly 0.01 radians.")
    cone("cone-0.0001", "0.0001", "A cylinder and a cone with a half angle of exactly 0.0001 radians.")
    cone("cone-0.5", "0.5", "A cylinder and a cone with a half angle of exactly half a radian: a corner.")

    # ---- Faces of one shell that are apart although they share an edge.
    def apart(name, gap, unit, within, expect, why, placed=None):
        shell = Shell(f"cad/{name}", unit, "0.1")
        e = lambda *p: Curve([[F(x) for x in q] for q in p])
        left = shell.add(f"PLANE('',{shell.placement([0, 0, 0], [0, 0, 1], [1, 0, 0])})")
        right = shell.add(f"PLANE('',{shell.placement([0, 0, exact(gap)], [0, 0, 1], [1, 0, 0])})")
        shared = e((4, 0, 0), (4, 4, 0))
        shell.face(left, [(e((0, 0, 0), (4, 0, 0)), True, None), (shared, True, None), (e((0, 4, 0), (4, 4, 0)), False, None), (e((0, 0, 0), (0, 4, 0)), False, None)])
        shell.face(right, [(e((4, 0, 0), (8, 0, 0)), True, None), (e((8, 0, 0), (8, 4, 0)), True, None), (e((4, 4, 0), (8, 4, 0)), False, None), (shared, False, None)])
        measures = {"gap": enclosure(exact(gap)), "angle_degrees": ["0", "0"], "curvature_jump": ["0", "0"], "curvature_percent": ["0", "0"], "torsion_jump": None}
        millimetres = exact(gap) * (F("25.4") if unit == "inch" else 1) * (placed[3] if placed else 1)
        reached = named(ladder({**measures, "gap": enclosure(millimetres)}, within))
        if reached != expect:
            suite.problems.append(f"cad/{name}: {expect} expected, {reached} computed")
        measures["gap"] = enclosure(millimetres)
        more = {"placed": placed[0], "mirrored": determinant(*placed[1]) < 0, "scale": text(placed[3])} if placed else {}
        files = {"step": shell.close(placed)}
        if unit == "mm":
            square = lambda x, z: surfaces.Patch([[[F(x + i), F(j), z] for j in (0, 4)] for i in (0, 4)])
            low, high = square(0, F(0)), square(4, exact(gap))
            # The right face has the edge of the left one in place of its own.
            share = {high.boundary("u0").keys()[0]: low.boundary("u1")}
            files["brep"] = surfaces.as_brep([low, high], placed and placed[1:], tolerance="0.1", share=share)
        suite.record(f"cad/{name}", "cad", "tolerances", why, expect, "G2", measures, files, section="apart", unit=unit, within=within, **more)
    loose = {"gap": "0.02", A: "0.1", C: "2"}
    apart("apart-within", "0.01", "mm", loose, "G2", "Two faces share an edge, and their planes are 0.01 mm apart: within 0.02 mm.")
    apart("apart-above", "0.03", "mm", loose, "gap", "Two faces share an edge, and their planes are 0.03 mm apart: not within 0.02 mm.")
    apart("apart-inch", "0.001", "inch", loose, "gap", "The planes are 0.001 inches apart, which is 0.0254 mm: not within 0.02 mm.")

    apart("apart-mapped-scaled", "0.01", "mm", loose, "gap", "The planes are 0.01 mm apart in an item that is three times as large: 0.03 mm, and not within 0.02 mm.",
          placed=("mapped", UNIT, away, thrice))
    apart("apart-mapped-smaller", "0.03", "mm", loose, "G2", "The planes are 0.03 mm apart in an item that is half as large: 0.015 mm, within 0.02 mm.",
          placed=("mapped", UNIT, away, F(1, 2)))
    apart("apart-part-scaled", "0.01", "mm", loose, "gap", "The planes are 0.01 mm apart in a part that an assembly makes three times as large: not within 0.02 mm.",
          placed=("part", UNIT, away, thrice))

    # ---- B-spline faces with their curves in the parameters, and seams.
    def splines(name, question, why, patches, edge, expect, mirrored=False):
        measures = edge.measures()
        reached = named(edge.order)
        if reached != expect:
            suite.problems.append(f"cad/{name}: {expect} expected, {reached} computed")
        more = {"at": text(edge.at)} if edge.order == 0 else {}
        step = surfaces.as_step(f"cad/{name}", patches, pcurves=True, frame=MIRROR if mirrored else None)
        if mirrored:
            framed(patches, MIRROR)
        suite.record(f"cad/{name}", "surface", question, why, expect, "G2", measures,
                     {"json": surfaces.as_json(patches), "step": step, "brep": surfaces.as_brep(patches, inward=patches if mirrored else ())}, **more)
    P = surfaces.Patch
    for name, question, why, second, expect in (
            ("parameters-kink", "tangent", "B-spline faces with curves in their parameters; the angle is 0 at both ends of the edge and 0.29 degrees in the middle.",
             P(["10,0,0 10,5,0 10,10,0", "20,0,0 20,5,0.1 20,10,0"]), "G0"),
            ("parameters-smooth", "curvature", "B-spline faces with curves in their parameters: a plane and a cubic whose first rows lie in it.",
             P(["10,0,0 10,5,0 10,10,0", "13,0,0 13,5,0 13,10,0", "16,0,0 16,5,0 16,10,0", "20,0,3 20,5,5 20,10,4"]), "G2"),
            ("parameters-jump", "curvature", "B-spline faces with curves in their parameters: the curvature jumps in the middle of the edge.",
             P(["10,0,0 10,5,0 10,10,0", "15,0,0 15,5,0 15,10,0", "20,0,0 20,5,1 20,10,0"]), "G1")):
        first = P(["0,0,0 0,5,0 0,10,0", "10,0,0 10,5,0 10,10,0"])
        splines(name, question, why, [first, second], surfaces.Edge(first, F(1), second, F(0)), expect)
        splines("mirror-" + name, question, why[:-1] + "; all is mirrored, and normals point to the other side.", [first, second], surfaces.Edge(first, F(1), second, F(0)), expect, True)

    def tube(profile, knots):
        points = [[[exact(x), exact(y), F(z)] for z in (0, 10)] for x, y in (p.split(",") for p in profile.split())]
        return P(points, u=knots, degrees=(3, 1))
    for name, question, why, profile, expect in (
            ("seam-smooth", "curvature", "A closed B-spline tube whose seam is G2: the points beside it are mirrored.",
             "0,0 4,0 8,2 8,8 -8,8 -8,2 -4,0 0,0", "G2"),
            ("seam-kink", "tangent", "A closed B-spline tube with a kink of 0.57 degrees at its seam.", "0,0 4,0.04 8,2 8,8 -8,8 -8,2 -4,0 0,0", "G0"),
            ("seam-jump", "curvature", "A closed B-spline tube whose curvature jumps at its seam.", "0,0 4,0 8,3 8,8 -8,8 -8,2 -4,0 0,0", "G1")):
        s = tube(profile, "0 0 0 0 1 2 3 4 5 5 5 5")
        splines(name, question, why, [s], surfaces.Edge(s, s.u[-1], s, s.u[0]), expect)
        splines("mirror-" + name, question, why[:-1] + "; all is mirrored, and normals point to the other side.", [s], surfaces.Edge(s, s.u[-1], s, s.u[0]), expect, True)
