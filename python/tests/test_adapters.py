# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Adapters with the real libraries, each skipped where its library is missing."""

import contextlib
import importlib.util
import io
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import numpy

import geometric_continuity as gc
from geometric_continuity.adapters import outlines
from geometric_continuity.adapters.outlines import Point


def needs(*names):
    missing = [n for n in names if importlib.util.find_spec(n) is None]
    return unittest.skipIf(missing, "not installed: " + ", ".join(missing))


# A contour like that of a letter o, with a kink at (300, 500), where a cubic meets a cubic, one at
# (100, 0), where a line meets a cubic, and a corner.
CONTOUR = [(100, 0, "line"), (60, 2, None), (0, 100, None), (0, 250, "curve"), (0, 400, None), (150, 498, None), (300, 500, "curve"),
           (450, 504, None), (600, 400, None), (600, 250, "curve"), (600, 100, "line"), (600, 0, "line")]


def contour():
    return [Point(*p) for p in CONTOUR]


class Outlines(unittest.TestCase):
    def test_kinks(self):
        found = outlines.kinks(contour(), glyph="o")
        self.assertEqual([(k.node, k.point) for k in found], [(6, (300, 500)), (0, (100, 0))])
        self.assertEqual([k.node for k in outlines.kinks(contour(), 1)], [6])  # of 0.76 degrees; the other one has 2.9
        bend = [Point(0, 0, "move"), Point(10, 0, "line"), Point(20, 1, "line")]
        self.assertEqual([k.node for k in outlines.kinks(bend, 10)], [1])
        self.assertEqual(outlines.mend(bend, 10), [])  # two lines have no handle

    def test_mend(self):
        points = contour()
        moves = outlines.mend(points, glyph="o")
        self.assertEqual(outlines.kinks(points), [])
        self.assertTrue(moves)
        self.assertEqual({m.index for m in moves} - {1, 5, 7}, set())
        for i, (p, q) in enumerate(zip(points, contour())):
            self.assertEqual(p.type, q.type)
            if p.type is not None or i not in {m.index for m in moves}:
                self.assertEqual((p.x, p.y), (q.x, q.y))
            self.assertIsInstance(p.x, int)
            self.assertLess(abs(p.x - q.x) + abs(p.y - q.y), 12)
        self.assertEqual(outlines.mend(points), [])
        self.assertEqual(outlines.mend(contour(), max_move=0.5), [])
        halves = [Point(p.x + 0.5, p.y, p.type) for p in contour()]
        self.assertEqual(outlines.mend(halves), [])

    def test_masters(self):
        """Smooth masters between which there is a kink, and random ones: mended, no mixture has one, and nodes and far points stay."""

        def master(a, b, node=(0, 0)):
            x, y = node
            return [Point(*p) for p in ((-300, -200, "move"), (-200, -150, None), (x - a[0], y - a[1], None), (x, y, "curve"),
                                        (x + b[0], y + b[1], None), (200, 300, None), (300, 250, "curve"))]

        def mixtures(masters, weights):
            return [sum(w * getattr(m[q], c) - w * getattr(m[p], c) for w, m in zip(weights, masters)) for p, q in ((2, 3), (3, 4)) for c in "xy"]

        masters = [master((40, 30), (80, 60)), master((30, 40), (30, 40), (17, 5))]
        self.assertEqual([outlines.kinks(m) for m in masters], [[], []])
        self.assertEqual(outlines.kinks_between(masters), [3])
        moves = outlines.mend_masters(masters, glyph="a")
        self.assertEqual([[(m.index, m.after) for m in moved] for moved in moves], [[(2, (-36, -30)), (4, (78, 65))], [(2, (-19, -25)), (4, (53, 35))]])
        self.assertEqual(outlines.kinks_between(masters), [])
        self.assertEqual(outlines.mend_masters(masters), [[], []])
        self.assertEqual(outlines.mend_masters([master((40, 30), (80, 60)), master((30, 40), (30, 40))], max_move=5), [[], []])
        random_numbers = numpy.random.default_rng(17)
        print("seed 17")
        mended = 0
        for _ in range(80):
            angle, ratio, masters = random_numbers.uniform(0, 6), random_numbers.uniform(0.3, 3), []
            for _ in range(random_numbers.integers(2, 5)):
                t, length, noise = angle + random_numbers.uniform(-0.4, 0.4), random_numbers.uniform(30, 150), random_numbers.uniform(-0.02, 0.02)
                a, b = ([round(float(size * f(u))) for f in (numpy.cos, numpy.sin)] for size, u in ((length, t), (ratio * length, t + noise)))
                masters.append(master(a, b, random_numbers.integers(-50, 50, 2).tolist()))
            before = [[(p.x, p.y) for p in m] for m in masters]
            between = len(outlines.kinks_between(masters))
            moves = outlines.mend_masters(masters)
            for old, m, moved in zip(before, masters, moves):
                self.assertEqual({i for i, p in enumerate(m) if (p.x, p.y) != old[i]}, {move.index for move in moved})
                self.assertLessEqual({move.index for move in moved}, {2, 4})
            if outlines.kinks_between(masters):
                continue
            mended += between
            for _ in range(4):
                ax, ay, bx, by = mixtures(masters, random_numbers.integers(1, 10, len(masters)).tolist())
                self.assertEqual(ax * by, ay * bx)
                self.assertGreater(ax * bx + ay * by, 0)
        self.assertGreater(mended, 60)

    def test_curvature_of_masters(self):
        """Curvatures made equal: one contour as the program does it, masters with one direction or one ratio of handles, compared with the
        curvatures of mixtures on fractions."""
        harm = [(40, 0, "move"), (40, 180, None), (110, 320, None), (240, 320, "curve"), (330, 320, None), (420, 250, None), (420, 60, "curve")]
        points = [Point(*p) for p in harm]
        self.assertEqual([(m.index, m.after) for m in outlines.mend(points, to="G2")], [(2, (107, 320)), (4, (334, 320))])
        [(node, jump)] = outlines.curvature_jumps([points])
        self.assertEqual(node, 3)
        self.assertAlmostEqual(jump, 0.0009610, 6)
        self.assertEqual(outlines.mend(points, to="G2"), [])
        self.assertEqual(outlines.mend([Point(*p) for p in harm]), [])
        with self.assertRaises(ValueError):
            outlines.mend(points, to="G3")

        def curve(p):  # its node is 0
            return [Point(*p) for p in ((-700, -900, "move"), (*(-c for c in p[0]), None), (*(-c for c in p[1]), None), (0, 0, "curve"),
                                        (*p[2], None), (*p[3], None), (900, -700, "curve"))]

        def jumps_of_mixture(masters, weights):
            u, a, b, v = ([sum(w * (s * getattr(m[i], c)) for w, m in zip(weights, masters)) for c in "xy"]
                          for i, s in ((1, -1), (2, -1), (4, 1), (5, 1)))
            left, right = u[0] * a[1] - u[1] * a[0], b[0] * v[1] - b[1] * v[0]
            self.assertEqual(a[0] * b[1], a[1] * b[0])
            return left * left * (b[0] ** 2 + b[1] ** 2) ** 3 - right * right * (a[0] ** 2 + a[1] ** 2) ** 3

        random_numbers = numpy.random.default_rng(11)
        print("seed 11")
        exact = {"direction": 0, "ratio": 0}
        for trial in range(60):
            kind = ("direction", "ratio")[trial % 2]
            masters = []
            p, q = ((1, 1), (2, 1), (3, 2), (1, 2))[random_numbers.integers(4)]
            c = int(random_numbers.integers(8, 12))
            for _ in range(random_numbers.integers(1, 4)):
                x, y = (int(n) for n in random_numbers.integers((20, 5), (45, 20)))
                if kind == "direction":
                    height, off = int(random_numbers.integers(20, 60)), int(random_numbers.integers(-2, 3))
                    masters.append(curve(((300, q * q * height), (q * x + off, 0), (p * x, 0), (300, -p * p * height))))
                    continue
                # s = k^2 u + v is a multiple of the handle a = q t, so that all mixtures agree
                a, u = (q * x, q * y), (int(random_numbers.integers(100, 140)) * q * q, int(random_numbers.integers(-40, 0)) * q * q)
                v = [c * t - p * p * s // (q * q) for t, s in zip(a, u)]
                masters.append(curve((u, a, (p * x, p * y), v)))
            if kind == "ratio":  # the left handle is off in one of them, and its partner with it
                dx = int(random_numbers.integers(0, 2))
                masters[0][2].x, masters[0][4].x = masters[0][2].x - q * dx, masters[0][4].x + p * dx
            old = outlines.curvature_jumps(masters)
            before = [[(m.x, m.y) for m in points] for points in masters]
            moves = outlines.mend_masters(masters, to="G2")
            new = outlines.curvature_jumps(masters)
            self.assertLessEqual(sum(j for _, j in new), sum(j for _, j in old))
            self.assertEqual([[(m.x, m.y) for i, m in enumerate(points) if i not in (2, 4)] for points in masters],
                             [[p for i, p in enumerate(points) if i not in (2, 4)] for points in before])
            weights = random_numbers.integers(1, 10, len(masters)).tolist()
            self.assertEqual(jumps_of_mixture(masters, weights) == 0, not new)
            self.assertEqual(outlines.mend_masters(masters, to="G2"), [[] for _ in masters])
            exact[kind] += bool(old) and not new
            self.assertEqual(bool(old or any(moves)), bool(old))
        print(exact)
        self.assertGreater(min(exact.values()), 5)

    def test_which_handles_move(self):
        def moved(*points, **options):
            return [(m.index, m.after) for m in outlines.mend([Point(*p) for p in points], **options)]

        start = ((0, 0, "move"), (0, 50, None))
        self.assertEqual(moved(*start, (100, 102, None), (200, 100, "curve"), (300, 100, "line")), [(2, (100, 100))])
        self.assertEqual(moved((0, 0, "move"), (100, 0, "line"), (200, 2, None), (300, 50, None), (300, 90, "curve")), [(2, (200, 0))])
        # 0.3 units off, but on the grid one handle at least moves by more than 0.6
        far = (*start, (-301, -100, None), (0, 0, "curve"), (299, 99, None), (500, 0, None), (600, 0, "curve"))
        self.assertTrue(moved(*far))
        self.assertEqual(moved(*far, max_move=0.6), [])
        # that of a quadratic curve belongs to two nodes
        self.assertEqual(moved((0, 0, "move"), (50, 40, None), (100, 50, "qcurve"), (150, 62, None), (200, 60, "qcurve")), [])

    def test_quadratic_curves_and_small_contours(self):
        circle = [Point(0, 0, "qcurve"), Point(0, 10, None), Point(10, 20, None), Point(30, 20, None), Point(40, 10, None), Point(40, 0, "qcurve"),
                  Point(40, -10, None), Point(0, -10, None)]
        grades = [(j.node, j.grade()) for j in outlines.joins(circle)]
        self.assertEqual(grades, [(5, gc.Visual_class.g1), (0, gc.Visual_class.g1)])
        left = next(iter(outlines.joins(circle))).left
        self.assertEqual(left, [(35, 15), (40, 10), (40, 0)])
        for small in ([], [Point(0, 0, "move")], [Point(0, 0, "line")], [Point(0, 0, "line"), Point(0, 0, "line")],
                      [Point(0, 0, "move"), Point(1, 1, "line")], [Point(0, 0, None), Point(1, 1, None)]):
            self.assertEqual(list(outlines.joins(small)), [])
        self.assertEqual(len(list(outlines.joins([Point(0, 0, "move"), Point(1, 1, "line"), Point(1, 1, "line"), Point(2, 2, "line")]))), 1)


@needs("fontTools")
class Font_tools(unittest.TestCase):
    def test_pen(self):
        from geometric_continuity.adapters.fonttools import Join_pen

        pen = Join_pen(None, "o")
        pen.moveTo((100, 0))
        pen.curveTo((60, 2), (0, 100), (0, 250))
        pen.curveTo((0, 400), (150, 498), (300, 500))
        pen.curveTo((450, 504), (600, 400), (600, 250))
        pen.lineTo((600, 100))
        pen.lineTo((600, 0))
        pen.closePath()
        self.assertEqual(sorted(k.point for k in pen.kinks()), sorted(k.point for k in outlines.kinks(contour())))
        pen = Join_pen()
        pen.moveTo((0, 0))
        pen.qCurveTo((0, 10), (10, 20), (30, 20))
        pen.lineTo((0, 0))
        pen.closePath()
        self.assertEqual(len(pen.contours[0]), 5)
        self.assertEqual(len(list(pen.joins())), 3)
        pen = Join_pen()
        pen.moveTo((0, 0))
        pen.lineTo((10, 0))
        pen.lineTo((20, 1))
        pen.endPath()
        self.assertEqual(len(pen.kinks(10)), 1)

    def test_point_pen(self):
        """Points as they are stored, of nodes, components and a contour of one node, have the joins of what is drawn."""
        from fontTools.pens.pointPen import PointToSegmentPen, SegmentToPointPen
        from geometric_continuity.adapters.fonttools import Join_pen, Join_point_pen

        class Glyph:
            def __init__(self, *contours, component=None):
                self.contours, self.component = contours, component

            def drawPoints(self, pen):
                for points in self.contours:
                    pen.beginPath()
                    for x, y, kind in points:
                        pen.addPoint((x, y), kind)
                    pen.endPath()
                if self.component:
                    pen.addComponent(self.component, (0, 1, -1, 0, 5, 7))  # turned

        drop = [(0, 0, "curve"), (100, 2, None), (-100, 100, None)]  # a corner
        glyphs = {"o": Glyph(CONTOUR, drop), "oo": Glyph(CONTOUR, component="o")}
        pen = Join_point_pen(glyphs, "oo")
        glyphs["oo"].drawPoints(pen)
        self.assertEqual([(k.contour, k.node, k.point) for k in pen.kinks()],
                         [(0, 6, (300, 500)), (0, 0, (100, 0)), (1, 6, (-495, 307)), (1, 0, (5, 107))])
        drawn = Join_pen(glyphs, "o")
        glyphs["o"].drawPoints(PointToSegmentPen(drawn))
        again = Join_point_pen()
        glyphs["o"].drawPoints(PointToSegmentPen(SegmentToPointPen(again)))
        stored = Join_point_pen()
        glyphs["o"].drawPoints(stored)
        for pen in (drawn, again, stored):
            self.assertEqual([(number, str(j.grade())) for number, j in pen.joins() if number == 1], [(1, "Visual_class.corner")])
            self.assertEqual(sorted(k.point for k in pen.kinks()), [(100, 0), (300, 500)])
        path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
        if os.path.exists(path):
            from fontTools.ttLib import TTFont

            glyphs, number = TTFont(path).getGlyphSet(), 0
            for name in ("S", "Aring", "g", "ampersand", "aacute", "three"):
                pens = [Join_pen(glyphs, name), Join_point_pen(glyphs, name)]
                glyphs[name].draw(pens[0])
                glyphs[name].drawPoints(pens[1])
                self.assertEqual(*(sorted((k.contour, k.point) for k in pen.kinks()) for pen in pens), name)
                number += len(pens[1].kinks())
            self.assertGreater(number, 2)

    def test_font(self):
        """The joins of a font are those that the program finds."""
        path = next((p for p in ("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",) if os.path.exists(p)), None)
        if path is None:
            self.skipTest("no font")
        from fontTools.ttLib import TTFont

        from geometric_continuity.adapters.fonttools import Join_pen

        glyphs = TTFont(path).getGlyphSet()
        for name in ("S", "a", "g", "ampersand"):
            pen = Join_pen(glyphs, name)
            glyphs[name].draw(pen)
            record = gc.verify(path, glyphs={"ampersand": "&"}.get(name, name), worst=1000, off_by=0.001)
            # the program counts joins of implied points and bends apart
            self.assertEqual(len(pen.kinks()), record["summary"]["kinks"] + record["summary"].get("bends", 0), name)


def new_ufo(path, family="Test", shift=0):
    import ufoLib2

    font = ufoLib2.Font()
    font.info.familyName, font.info.styleName, font.info.unitsPerEm = family, "Regular" if shift == 0 else "Bold", 1000
    font.info.ascender, font.info.descender, font.info.xHeight, font.info.capHeight = 800, -200, 500, 700
    font.lib["com.example.untouched"] = [1, 2.5, "three"]
    font.kerning[("o", "o")] = -7
    for name in ("o", "n"):
        glyph = font.newGlyph(name)
        glyph.unicode, glyph.width = ord(name), 700
        glyph.note = "a note"
        points = [(x + (shift if name == "o" and x > 200 else 0), y, t) for x, y, t in CONTOUR]
        pen = glyph.getPointPen()
        for contour_points in (points, [(50, 50, "line"), (50, 60, "line"), (70, 60, "line")]):
            pen.beginPath()
            for x, y, t in contour_points:
                pen.addPoint((x, y), t, smooth=t == "curve", name="n" if t == "curve" else None)
            pen.endPath()
    font.newGlyph("composite").components.append(ufoLib2.objects.Component("o", (1, 0, 0, 1, 0, 0)))
    font.save(path)
    return path


def files_of(folder):
    found = {}
    for base, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(base, name), "rb") as file:
                found[os.path.relpath(os.path.join(base, name), folder)] = file.read()
    return found


@needs("ufoLib2", "fontTools")
class Sources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_ufo(self):
        import ufoLib2

        from geometric_continuity.adapters import sources

        path = new_ufo(self.path("a.ufo"))
        font = ufoLib2.Font.open(path)
        self.assertEqual(len(sources.ufo_kinks(font)), 4)
        glif = os.path.join(path, "glyphs", "n.glif")
        with open(glif, "rb") as file:
            text = file.read()
        odd = text.replace(b"<contour>", b"<contour><!-- <contour><point x='1' y='2'/> -->", 1).replace(b'x="60" y="2"', b"y = '2'  x=\"60\"")
        self.assertNotEqual(odd, text)
        with open(glif, "wb") as file:
            file.write(odd)
        before = files_of(path)
        moves = sources.mend_ufo(path, self.path("b.ufo"))
        self.assertEqual(files_of(path), before)
        after = files_of(self.path("b.ufo"))
        self.assertEqual(set(after), set(before))
        self.assertEqual({n for n in before if before[n] != after[n]}, {"glyphs/o.glif", "glyphs/n.glif"})
        for name in ("glyphs/o.glif", "glyphs/n.glif"):
            old, new = before[name].split(b"\n"), after[name].split(b"\n")
            self.assertEqual(len(old), len(new))
            self.assertEqual(sum(a != b for a, b in zip(old, new)), len({(m.index) for m in moves if m.glyph == name[7]}))
        mended = ufoLib2.Font.open(self.path("b.ufo"))
        self.assertEqual(sources.ufo_kinks(mended), [])
        for m in moves:
            point = mended[m.glyph][m.contour].points[m.index]
            self.assertEqual((point.x, point.y), m.after)
        again = sources.mend_ufo(self.path("b.ufo"))
        self.assertEqual(again, [])
        in_memory = sources.mend_ufo_font(font)
        self.assertEqual({(m.glyph, m.index, m.after) for m in in_memory}, {(m.glyph, m.index, m.after) for m in moves})
        self.assertEqual(sources.ufo_kinks(font), [])

    def test_designspace(self):
        import ufoLib2
        from fontTools.designspaceLib import AxisDescriptor, DesignSpaceDocument, SourceDescriptor

        from geometric_continuity.adapters import sources

        document = DesignSpaceDocument()
        document.addAxis(AxisDescriptor(name="Weight", tag="wght", minimum=0, default=0, maximum=100))
        for i, name in enumerate(("light.ufo", "bold.ufo")):
            document.addSource(SourceDescriptor(path=new_ufo(self.path(name), shift=37 * i), location={"Weight": 100 * i}))
        document.write(self.path("test.designspace"))
        fonts = [ufoLib2.Font.open(self.path(n)) for n in ("light.ufo", "bold.ufo")]
        self.assertEqual(sources.incompatible(fonts), [])
        moves = sources.mend_designspace(self.path("test.designspace"))
        self.assertEqual(sorted(os.path.basename(p) for p in moves), ["bold.ufo", "light.ufo"])
        fonts = [ufoLib2.Font.open(self.path(n)) for n in ("light.ufo", "bold.ufo")]
        self.assertEqual(sources.incompatible(fonts), [])
        self.assertTrue(all(moves.values()))
        for font in fonts:
            self.assertEqual(sources.ufo_kinks(font), [])
        self.assertEqual(sources.between_masters(self.path("test.designspace")), 0)
        # two smooth masters with one ratio of the handles, and with two

        def set_handles(font, left, right):
            p, q, r = font["o"].contours[0].points[5:8]
            p.x, p.y, r.x, r.y = q.x - left[0], q.y - left[1], q.x + right[0], q.y + right[1]
            font.save()

        set_handles(fonts[0], (60, 20), (60, 20))
        set_handles(fonts[1], (120, 80), (120, 80))
        self.assertEqual([sources.ufo_kinks(font) for font in fonts], [[], []])
        self.assertEqual(sources.between_masters(self.path("test.designspace")), 0)
        set_handles(fonts[0], (60, 20), (30, 10))
        self.assertEqual(sources.ufo_kinks(fonts[0]), [])
        self.assertEqual(sources.between_masters(self.path("test.designspace")), 1)
        with contextlib.redirect_stdout(io.StringIO()) as output:
            self.assertEqual(sources.main(["repair", self.path("test.designspace"), self.path("test.designspace")]), 0)
        self.assertIn("nodes with a kink between masters: 1 before, 0 after", output.getvalue())
        fonts = [ufoLib2.Font.open(self.path(n)) for n in ("light.ufo", "bold.ufo")]
        del fonts[0]["o"].contours[0].points[-1]
        self.assertEqual(sources.incompatible(fonts), ["o"])

    @needs("glyphsLib")
    def test_glyphs(self):
        import glyphsLib

        from geometric_continuity.adapters import sources

        import ufoLib2

        font = glyphsLib.to_glyphs([ufoLib2.Font.open(new_ufo(self.path("a.ufo")))])
        font.save(self.path("a.glyphs"))
        font = glyphsLib.GSFont(self.path("a.glyphs"))
        self.assertEqual(len(sources.glyphs_kinks(font)), 4)
        moves = sources.mend_glyphs(font)
        font.save(self.path("b.glyphs"))
        mended = glyphsLib.GSFont(self.path("b.glyphs"))
        self.assertEqual(sources.glyphs_kinks(mended), [])
        with open(self.path("a.glyphs")) as a, open(self.path("b.glyphs")) as b:
            changed = [(x, y) for x, y in zip(a, b) if x != y]
        self.assertEqual(len(changed), len(moves))
        self.assertTrue(all("OFFCURVE" in x and "OFFCURVE" in y for x, y in changed))

    @needs("ufoLib2", "fontTools")
    def test_verify_and_mend_sources(self):
        """What the program calls for sources: exit codes, counts, copies of a designspace with its masters, and nothing written over."""
        from fontTools.designspaceLib import DesignSpaceDocument

        from geometric_continuity.adapters import sources

        def run(*arguments):
            with contextlib.redirect_stdout(io.StringIO()) as output:
                return sources.main(list(arguments)), output.getvalue()

        new_ufo(self.path("a.ufo"))
        new_ufo(self.path("b.ufo"), shift=20)
        document = DesignSpaceDocument()
        document.addAxisDescriptor(name="weight", tag="wght", minimum=0, default=0, maximum=1)
        for name, weight in (("a", 0), ("b", 1)):
            document.addSourceDescriptor(path=self.path(name + ".ufo"), location={"weight": weight})
        document.write(self.path("ab.designspace"))
        os.mkdir(self.path("mended"))
        given, result = self.path("ab.designspace"), self.path("mended/ab.designspace")
        self.assertEqual(run("verify", given)[0], 0)
        code, text = run("verify", "--json", "--require", "G1", given)
        record = json.loads(text)["sources"][0]
        self.assertEqual((code, record["met"], record["summary"]["kink"], len(record["kinks"])), (1, False, 8, 8))
        code, text = run("repair", given, result)
        self.assertEqual(code, 0, text)
        self.assertIn("0 kinks", text)
        self.assertEqual(run("verify", "--require", "G1", result)[0], 0)
        self.assertEqual(run("verify", "--require", "G1", given)[0], 1)
        self.assertEqual(run("verify", "--require", "G2", self.path("mended/a.ufo"))[0], 1)
        with self.assertRaises(FileExistsError):
            sources.mend_source(given, result)
        self.assertEqual(run("repair", self.path("a.ufo"), self.path("a.ufo"))[0], 0)
        self.assertEqual(run("verify", "--require", "G1", self.path("a.ufo"))[0], 0)
        code, text = run("repair", "--to", "G2", result, result)
        self.assertEqual(code, 0, text)
        self.assertIn("curvatures: ", text)
        self.assertNotIn("moves: 0 ", text)
        self.assertIn("moves: 0 ", run("repair", "--to", "G2", result, result)[1])
        self.assertEqual(sources.between_masters(result), 0)
        jumps = sources.source_jumps(result)
        self.assertLess(sum(jumps), sum(sources.source_jumps(self.path("a.ufo"))))

    @needs("fontmake")
    def test_compiled_font(self):
        """A UFO with kinks is mended, compiled by fontmake, and the program proves that the font has none."""
        from geometric_continuity.adapters import sources

        new_ufo(self.path("a.ufo"))
        sources.mend_ufo(self.path("a.ufo"), self.path("b.ufo"))
        met = []
        for name in ("a", "b"):
            done = subprocess.run([sys.executable, "-m", "fontmake", "-u", self.path(name + ".ufo"), "-o", "otf", "--output-path",
                                   self.path(name + ".otf"), "--keep-overlaps"],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=self.folder)
            self.assertEqual(done.returncode, 0, done.stdout.decode()[-2000:])
            record = gc.verify(self.path(name + ".otf"), require="G1", off_by=0.001)
            met.append((record["met"], record["summary"]["kinks"]))
        self.assertEqual(met[0][0], False)
        self.assertGreater(met[0][1], 0)
        self.assertEqual(met[1], (True, 0))


def freecad_part():
    """The module Part of FreeCAD, whose folder is not on the path of Python."""
    for folder in ("/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"):
        if os.path.exists(os.path.join(folder, "Part.so")):
            sys.path.append(folder)
    try:
        import FreeCAD  # noqa: F401
        import Part

        return Part
    except ImportError:
        return None


class Free_cad(unittest.TestCase):
    def setUp(self):
        self.part = freecad_part()
        if self.part is None:
            self.skipTest("not installed: FreeCAD")
        from geometric_continuity.adapters import freecad

        self.adapter = freecad

    def spline(self, poles, multiplicities, knots, periodic=False, weights=None):
        from FreeCAD import Vector

        curve = self.part.BSplineCurve()
        curve.buildFromPolesMultsKnots([Vector(*p) for p in poles], multiplicities, knots, periodic, 3, *([weights] if weights else []))
        return curve

    def check(self, edge, degree, number, rational):
        """The pieces lie on the curve, in its direction, and join with each other as the knots say."""
        pieces = self.adapter.edge_pieces(edge)
        self.assertEqual([p.points.shape for p in pieces], [(degree + 1, 3)] * number)
        self.assertEqual([p.weights is not None for p in pieces], [rational] * number)
        low, high = edge.ParameterRange
        ends = [edge.Curve.value(low), edge.Curve.value(high)]
        if edge.Orientation == "Reversed":
            ends.reverse()
        for point, piece, i in zip(ends, (pieces[0], pieces[-1]), (0, -1)):
            numpy.testing.assert_allclose(piece.points[i].astype(float), tuple(point), atol=1e-12)
        for piece in pieces:
            w = numpy.ones(degree + 1) if piece.weights is None else piece.weights.astype(float)
            rows = numpy.column_stack([piece.points.astype(float) * w[:, None], w])
            while len(rows) > 1:
                rows = (rows[1:] + rows[:-1]) / 2
            from FreeCAD import Vector

            self.assertLess(edge.distToShape(self.part.Vertex(Vector(*(rows[0, :3] / rows[0, 3]))))[0], 1e-7)
        return pieces

    def test_edges(self):
        from FreeCAD import Vector

        part = self.part
        line = self.check(part.makeLine(Vector(0, 0.1, 0), Vector(1, 2, 3)), 1, 1, False)
        self.assertEqual(line[0].points[0].tolist(), [0, Fraction(0.1), 0])
        half = self.check(part.Arc(Vector(1, 0, 0), Vector(0, 1, 0), Vector(-1, 0, 0)).toShape(), 2, 2, True)
        self.assertGreaterEqual(gc.order_within(*half, 1e-13).proved_order, 2)
        for curve in (part.Circle(Vector(1, 2, 3), Vector(3, 1, -1), 4), part.Ellipse(Vector(5, 0, 1), Vector(0, 2, 2), Vector(0, 0, 1)),
                      part.Hyperbola(Vector(5, 0, 1), Vector(0, 2, 2), Vector(0, 0, 1))):
            self.check(curve.toShape(0.7, 1.6), 2, 1, True)
        self.check(part.Parabola(Vector(1, 0, 0), Vector(2, 1, 0), Vector(0, 0, 1)).toShape(0.7, 1.6), 2, 1, False)
        circle = self.check(part.makeCircle(2), 2, 3, True)
        self.assertTrue(all(gc.order_within(p, q, 1e-13).proved_order >= 2 for p, q in zip(circle, circle[1:] + circle[:1])))
        bezier = part.BezierCurve()
        bezier.setPoles([Vector(0, 0, 0), Vector(1, 1, 0), Vector(2, 0, 0)])
        self.check(bezier.toShape(), 2, 1, False)
        self.check(bezier.toShape(0.25, 0.5), 2, 1, False)
        bezier.setWeight(2, 2.0)
        self.check(bezier.toShape(0.25, 0.5), 2, 1, True)
        poles = [(0, 0, 0), (1, 2, 0), (3, 2, 1), (4, 0.3, 0), (6, 1, 0), (7, 0, 0)]
        for weights in (None, [1, 2, 1, 1, 0.3, 1]):
            spline = self.spline(poles, (4, 1, 1, 4), (0, 1, 2.5, 3), weights=weights)
            pieces = self.check(spline.toShape(), 3, 3, weights is not None)
            self.assertEqual([gc.continuity(p, q).g_order for p, q in zip(pieces, pieces[1:])], [2, 2])
            self.assertEqual([gc.continuity(p, q).c_order for p, q in zip(pieces, pieces[1:])], [2, 2])
            self.assertEqual([p.domain for p in pieces], [(0, 1), (1, 2.5), (2.5, 3)])
            self.check(spline.toShape(0.5, 2.75), 3, 3, weights is not None)
            reversed_edge = spline.toShape()
            reversed_edge.reverse()
            pieces = self.check(reversed_edge, 3, 3, weights is not None)
            self.assertEqual([gc.continuity(p, q).g_order for p, q in zip(pieces, pieces[1:])], [2, 2])
        around = self.spline(poles, (1, 1, 1, 1, 1, 1, 1), (0, 1, 2, 3.5, 4, 5, 6), periodic=True)
        pieces = self.check(around.toShape(), 3, 6, False)
        self.assertEqual([gc.continuity(p, q).g_order for p, q in zip(pieces, pieces[1:] + pieces[:1])], [2] * 6)
        offset = part.OffsetCurve(part.Circle(), 0.5, Vector(0, 0, 1)) if hasattr(part, "OffsetCurve") else None
        if offset is not None:
            with self.assertRaises(ValueError):
                self.adapter.edge_pieces(offset.toShape())

    def test_wires(self):
        from FreeCAD import Vector

        part = self.part
        tangent = self.spline([(1, 0, 0), (2, 0, 0), (3, 0.5, 0), (3, 2, 0)], (4, 4), (0, 1)).toShape()
        second = part.makeLine(Vector(3, 4, 0), Vector(3, 2, 0))  # runs backwards
        last = part.makeLine(Vector(3, 4, 0), Vector(3, 4, 5))
        wire = part.Wire([part.makeLine(Vector(0, 0, 0), Vector(1, 0, 0)), tangent, second, last])
        joins = list(self.adapter.wire_joins(wire))
        self.assertEqual([number for number, _ in joins], [0, 1, 2])
        self.assertEqual([join.g_order for _, join in joins], [1, 1, 0])
        square = part.makePolygon([Vector(0, 0, 0), Vector(1, 0, 0), Vector(2, 0, 0), Vector(2, 1, 0), Vector(0, 0, 0)])
        self.assertEqual([join.g_order for _, join in self.adapter.wire_joins(square)], [3, 0, 0, 0])

    def test_tangent_wires(self):
        """Arcs, ellipses and splines that start where a line ends, in general directions: what FreeCAD rounds is within its tolerance."""
        import random

        from FreeCAD import Rotation, Vector

        part = self.part
        seed = 187
        random.seed(seed)
        exact = proved = 0
        for i in range(40):
            turned = Rotation(Vector(*(random.uniform(-1, 1) for _ in range(3))), random.uniform(0, 360))
            p, t, n = (turned.multVec(Vector(*v)) for v in ((50, 20, 9), (1, 0, 0), (0, 1, 0)))
            kink = 0.001 if i % 4 == 3 else 0  # degrees
            line = part.LineSegment(p - t * random.uniform(1, 50), p).toShape()
            bent, up = Rotation(t.cross(n), kink).multVec(t), n
            r = random.uniform(5, 50)
            curve = part.Circle(p + up * r, t.cross(n), r) if i % 2 else part.Ellipse(p, p + up * (r + 5) + t * r, p + up * (r + 5))
            if kink:
                curve = part.Circle(p + Rotation(t.cross(n), kink).multVec(up) * r, t.cross(n), r)
            u = curve.parameter(p)
            wire = part.Wire([line, part.Arc(curve, u, u + 1).toShape()])
            (_, join), = self.adapter.wire_joins(wire)
            exact += join.g_order >= 1
            (number, within), = self.adapter.wire_joins_within(wire)
            angle = within.deviation.tangent_angle
            with self.subTest(seed=seed, i=i, bent=tuple(bent)):
                self.assertEqual(number, 0)
                self.assertEqual(within.verdicts[:2], ("proved", "refuted" if kink else "proved"))
                self.assertTrue(angle.lower - 1e-12 <= math.radians(kink) <= angle.upper + 1e-12)
                self.assertEqual(within.verdicts[2], "refuted")  # from a line
            (_, wide), = self.adapter.wire_joins_within(wire, gap=1e-6, tangent_angle=1e-3)
            self.assertEqual(wide.proved_order, 1)
            self.assertEqual(next(self.adapter.wire_joins_within(wire, 0, gap=0))[1].verdicts[0], "proved" if join.c_order >= 0 else "refuted")
            chain = self.adapter.wire_pieces(wire)
            self.assertEqual(list(gc.failing_joins(chain, "G1", tolerance=1e-7)), [0] if kink else [])
            proved += within.verdicts[1] == "proved"
        self.assertEqual(proved, 30)
        self.assertLess(exact, 10)  # most have a gap of the size of rounding


class Drawings(unittest.TestCase):
    @needs("svgelements")
    def test_svg(self):
        import svgelements

        from geometric_continuity.adapters.drawings import svg_contours

        path = svgelements.Path("M0 0 C1 1 2 1 3 0 S5 -1 6 0 Q7 1 8 0 L9 0 A1 1 0 0 1 10 1 Z M20 20 h5 h0 h5")
        contours = svg_contours(path)
        self.assertEqual([len(c) for c in contours][1], 2)
        self.assertEqual([len(c) for c in contours[0]][:4], [4, 4, 3, 2])
        self.assertEqual(gc.continuity(contours[0][0], contours[0][1]).c_order, 1)
        self.assertEqual(gc.continuity(contours[1][0], contours[1][1]).g_order, 3)
        self.assertEqual(gc.visual_class(contours[0][2], contours[0][3]), gc.Visual_class.corner)

    @needs("ezdxf")
    def test_splines(self):
        import ezdxf

        from geometric_continuity.adapters.drawings import spline_pieces

        document = ezdxf.new()
        points = [(0, 0), (1, 2), (3, 2), (4, 0.3), (6, 1), (7, 0)]
        spline = document.modelspace().add_open_spline(points, degree=3)
        pieces = spline_pieces(spline)
        self.assertEqual([p.points.shape for p in pieces], [(4, 3)] * 3)
        self.assertEqual([gc.continuity(p, q).c_order for p, q in zip(pieces, pieces[1:])], [2, 2])
        # the knots are uniform
        self.assertEqual(gc.failing_joins(numpy.array([p.points for p in pieces]), "G2").tolist(), [])
        tool = spline.construction_tool()
        for piece, u in zip(pieces, (0, 1, 2)):
            numpy.testing.assert_allclose(piece.points[0].astype(float), tool.point(u * tool.max_t / 3), atol=1e-12)
        rational = spline_pieces(document.modelspace().add_rational_spline(points, weights=[1, 2, 1, 1, 1, 1]))
        self.assertEqual([gc.continuity(p, q).c_order for p, q in zip(rational, rational[1:])], [2, 2])
        unequal = document.modelspace().add_spline()
        unequal.dxf.degree, unequal.control_points, unequal.knots = 3, [(*p, 0) for p in points], [0, 0, 0, 0, 1, 2.5, 3, 3, 3, 3]
        pieces = spline_pieces(unequal)
        self.assertEqual([p.domain for p in pieces], [(0, 1), (1, 2.5), (2.5, 3)])
        self.assertEqual([gc.continuity(p, q).c_order for p, q in zip(pieces, pieces[1:])], [2, 2])


class Splines(unittest.TestCase):
    def test_derivatives(self):
        """C orders and shape parameters are those with respect to the knots, from both ends, with weights too."""
        knots = [0, 0, 0, 0, 1, 2.5, Fraction(8, 3), Fraction(8, 3), 4, 4, 4, 4]
        points = [(0, 0), (1, 2), (3, 2), (4, 0.3), (6, 1), (7, 0), (8, 3), (9, 1)]
        for weights in (None, [1, 2, 1, 1, 0.3, 1, 2, 5]):
            found = gc.pieces(gc.Spline(3, points, knots, weights))
            self.assertEqual([p.domain for p in found], [(0, 1), (1, 2.5), (2.5, Fraction(8, 3)), (Fraction(8, 3), 4)])
            joins = [gc.continuity(p, q) for p, q in zip(found, found[1:])]
            self.assertEqual([(j.c_order, j.betas) for j in joins], [(2, (1, 0)), (2, (1, 0)), (1, (1,))])
            back = [p.reverse() for p in reversed(found)]
            self.assertEqual([gc.continuity(p, q).c_order for p, q in zip(back, back[1:])], [1, 2, 2])
        left, right = (gc.Bezier_curve([[x] * 2 for x in row], None, domain)
                       for row, domain in (((0, 1), (0, 1)), ((1, 4), (1, 3))))
        join = gc.continuity(left, right)  # at speeds 1 and 3/2
        self.assertEqual((join.c_order, join.g_order, join.betas[0]), (0, 3, Fraction(3, 2)))


if __name__ == "__main__":
    unittest.main()
