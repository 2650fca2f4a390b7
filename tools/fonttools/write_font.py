# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes a font whose handles have moved, with fontTools; `geometric_continuity repair FONT -o NEW.ttf` calls this:

    python3 write_font.py FONT MOVES.json RESULT       the moves that `geometric_continuity repair FONT -o MOVES.json` has written
    python3 write_font.py FONT --masters [G1|G2 [KINK_ANGLE [MAX_MOVE]]] RESULT   a variable font: its masters, mended together

RESULT is a .ttf, .otf, .woff or .woff2, of a collection .ttc or .otc; standard output for -.ttf etc. Each handle is found by its contour, its node and its position, so that
nothing moves where the font is not the one that was repaired. Only the outlines of glyphs whose handles move are written anew, with their
bounds where these grow; every other table keeps its bytes."""

import io
import json
import logging
import math
import os
import sys
from fractions import Fraction

WITHOUT_FONTTOOLS = 3  # the exit code that tells the program to look for another Python

try:
    from fontTools.ttLib import TTCollection, TTFont
except ImportError:
    sys.stderr.write("write_font.py: this Python has no fontTools\n")
    sys.exit(WITHOUT_FONTTOOLS)


# masters.py is part of this text where the program calls it; otherwise it lies beside this file, or
# in the tree of the project here:
sys.path.append(os.path.join(os.path.dirname(os.path.abspath(sys.argv[0])), "..", "..", "python", "geometric_continuity", "adapters"))
from masters import (  # noqa: E402
    Curves,
    Masters,
    can_agree,
    cross,
    curvature_jump,
    dot,
    harmonised,
    is_smooth,
    longest_move,
    minus,
    nearest,
    smooth_handles,
    times,
)

logging.disable(logging.WARNING)  # such as those about dates in a font


def refuse(text):
    sys.stderr.write("write_font.py: %s\n" % text)
    sys.exit(1)


# Contours are lists of points (x, y, is on the curve, what tells where to write it).


def nodes_beside(contour, k):
    beside = contour[k - 1], contour[(k + 1) % len(contour)]
    return [[p[0], p[1]] for p in beside if p[2]]


def find_handle(contours, move, taken):
    """The handle with this position at its node; of several that are left the one nearest to its number."""
    if move["contour"] >= len(contours):
        return None
    contour = contours[move["contour"]]
    found = [
        (abs(k - move["point"]), k)
        for k, p in enumerate(contour)
        if not p[2] and [p[0], p[1]] == move["from"] and move["node"] in nodes_beside(contour, k) and p[3] not in taken
    ]
    return contour[min(found)[1]][3] if found else None


def find_handles(contours, moves):
    drawn = [c for c in contours if len({p[:2] for p in c}) > 1]  # as they are counted, without those that are a single point
    found = []
    for move in moves:
        place = find_handle(drawn, move, found)
        if place is None:
            refuse("glyph %(glyph)s, contour %(contour)d: there is no handle at %(from)s of the node %(node)s" % move)
        found.append(place)
    return found


# TrueType


def contours_of_glyf(glyph):
    contours, begin = [], 0
    for end in glyph.endPtsOfContours:
        contours.append([(*glyph.coordinates[i], bool(glyph.flags[i] & 1), i) for i in range(begin, end + 1)])
        begin = end + 1
    return contours


def grow(font, name, bounds):
    """Lets the box of a glyph reach as far as these bounds. A glyph is drawn by its left side bearing, which moves with the box."""
    glyph = font["glyf"][name]
    old = glyph.xMin, glyph.yMin, glyph.xMax, glyph.yMax
    glyph.xMin, glyph.yMin = min(old[0], bounds[0]), min(old[1], bounds[1])
    glyph.xMax, glyph.yMax = max(old[2], bounds[2]), max(old[3], bounds[3])
    head = font["head"]
    head.xMin, head.yMin = min(head.xMin, glyph.xMin), min(head.yMin, glyph.yMin)
    head.xMax, head.yMax = max(head.xMax, glyph.xMax), max(head.yMax, glyph.yMax)
    if glyph.xMin != old[0]:
        advance, bearing = font["hmtx"][name]
        font["hmtx"][name] = advance, bearing + glyph.xMin - old[0]
        font["hhea"].minLeftSideBearing = min(font["hhea"].minLeftSideBearing, bearing + glyph.xMin - old[0])


def box(points):
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


def move_in_glyf(font, by_glyph):
    glyf, order = font["glyf"], font.getGlyphOrder()
    for index, moves in by_glyph.items():
        name = order[index]
        glyph = glyf[name]
        places = find_handles(contours_of_glyf(glyph), moves)  # before any of them moves
        for i, move in zip(places, moves):
            glyph.coordinates[i] = tuple(move["to"])
        moved = box([move["to"] for move in moves])
        if moved[0] < glyph.xMin or moved[1] < glyph.yMin or moved[2] > glyph.xMax or moved[3] > glyph.yMax:
            grow(font, name, moved)


# CFF: the operators of a charstring, without subroutines; what is no path, such as hints, stays


def inlined(charstring, local, general):
    """The program of a charstring with its subroutines in it."""
    result = []
    for token in charstring.program:
        subroutines = {"callsubr": local, "callgsubr": general}.get(token)
        if subroutines is None:
            result.append(token)
            continue
        number = result.pop()
        if not isinstance(number, int):
            raise ValueError("the number of a subroutine is computed")
        count = len(subroutines)
        bias = 107 if count < 1240 else 1131 if count < 33900 else 32768
        called = inlined(subroutines[number + bias], local, general)
        result += called[:-1] if called and called[-1] == "return" else called
    return result


def contours_of_cff(commands):
    contours, x, y = [], 0, 0
    for number, (operator, args) in enumerate(commands):
        if operator == "rmoveto":
            x, y = x + args[0], y + args[1]
            contours.append([(x, y, True, None)])
        elif operator in ("rlineto", "rrcurveto"):
            for i in range(0, len(args), 2):
                x, y = x + args[i], y + args[i + 1]
                contours[-1].append((x, y, i + 2 == len(args), (number, i)))
    for contour in contours:
        if len(contour) > 1 and contour[0][:2] == contour[-1][:2]:
            contour[0] = contour.pop()
    return contours


def move_in_cff(font, by_glyph):
    from fontTools.cffLib import specializer
    from fontTools.misc.psCharStrings import SimpleT2Decompiler

    top = font["CFF "].cff.topDictIndex[0]
    strings = top.CharStrings
    for index, moves in by_glyph.items():
        name = font.getGlyphOrder()[index]
        string = strings[name]
        local = getattr(string.private, "Subrs", [])
        SimpleT2Decompiler(local, string.globalSubrs, string.private).execute(string)  # reads the subroutines, too
        program = inlined(string, local, string.globalSubrs)
        commands = specializer.generalizeCommands(specializer.programToCommands(program))
        places = find_handles(contours_of_cff(commands), moves)
        for (number, i), move in zip(places, moves):
            args = commands[number][1]
            for c in (0, 1):
                shift = move["to"][c] - move["from"][c]
                args[i + c] += shift
                args[i + 2 + c] -= shift  # what follows a handle in its curve is relative to it
        # not specialised again, which leaves out segments without length
        string.setProgram(specializer.commandsToProgram(commands))


# Variable fonts. The handles at a node are sums over the default and the regions of gvar or CFF2.


class Region_masters(Masters):
    """The default and regions, each by the start, the peak and the end of its axes."""

    def __init__(self, regions):
        from fontTools.varLib.models import supportScalar

        peaks = [{}] + [{tag: peak for tag, (_, peak, _) in axes.items() if peak != 0} for axes in regions]
        super().__init__([[Fraction(1)] + [Fraction(supportScalar(at, axes)) for axes in regions] for at in peaks])


class Variable_outline:
    """Points of contours, of which each row has the shares of the default or of a region; each contour is a list of their numbers."""

    def shares(self, i):
        return [row[i] for row in self.rows]

    def set(self, i, shares):
        for row, share in zip(self.rows, shares):
            row[i] = tuple(int(c) for c in share)

    def is_whole(self, i):
        return all(int(c) == c for row in self.rows for c in row[i])

    def joins(self):
        """The number of the contour and three points: before a node, the node, behind it."""
        for number, contour in enumerate(self.contours):
            for k, i in enumerate(contour):
                if self.is_node(i) and len(contour) > 2:
                    yield number, contour[k - 1], i, contour[(k + 1) % len(contour)]

    def sides(self, before, node, behind):
        n = self.shares(node)
        a = [minus(p, q) for p, q in zip(n, self.shares(before))]
        b = [minus(p, q) for p, q in zip(self.shares(behind), n)]
        return a, b

    def beyond(self, handle, node):
        """The point of the contour on the other side of a handle."""
        contour = next(c for c in self.contours if handle in c)
        k = contour.index(handle)
        beside = contour[k - 1], contour[(k + 1) % len(contour)]
        return beside[0] if beside[1] == node else beside[1]

    def curves(self, before, node, behind):
        """The curves beside a node; None where one of them is a line."""
        if self.is_node(before) or self.is_node(behind):
            return None
        n = self.shares(node)
        u, v = self.second(before, node), self.second(behind, node)
        return Curves(self.degree, self.degree, [minus(p, q) for p, q in zip(n, u)], [minus(q, p) for p, q in zip(n, v)])

    def is_corner(self, join, tangent):
        """Whether the join is a corner at all masters; None where it is one at some of them, or a handle has no length."""
        a, b = self.sides(*join[1:])
        found = set()
        for u, v in zip(self.masters.at(a), self.masters.at(b)):
            if not any(u) or not any(v):
                return None
            found.add(dot(u, v) <= 0 or abs(cross(u, v)) > tangent * float(dot(u, v)))
        return found.pop() if len(found) == 1 else None


class Glyf_outline(Variable_outline):
    """A glyph of glyf and gvar; its points have integers for the default and for each region, inferred ones rounded."""

    degree = 2

    def __init__(self, font, name):
        from fontTools.varLib.iup import iup_delta

        self.font, self.name = font, name
        self.glyph, self.variations = font["glyf"][name], font["gvar"].variations[name]
        self.masters = Region_masters([v.axes for v in self.variations])
        points = [tuple(p) for p in self.glyph.coordinates]
        ends = self.glyph.endPtsOfContours
        phantoms = [(0, 0)] * 4
        self.rows = [[tuple(p) for p in points]]
        self.phantoms = []
        for v in self.variations:
            deltas = v.coordinates
            self.phantoms.append(deltas[len(points) :])
            if None in deltas:
                # phantom points are alone, each a contour of one point
                deltas = iup_delta(deltas, points + phantoms, list(ends)) if len(deltas) != len(points) else deltas
            self.rows.append([(nearest(x), nearest(y)) for x, y in deltas[: len(points)]])
        self.contours, begin = [], 0
        for end in ends:
            self.contours.append(list(range(begin, end + 1)))
            begin = end + 1

    def is_node(self, i):
        return bool(self.glyph.flags[i] & 1)

    def is_free(self, handle, node, corners):
        """Whether a handle may move: it does not belong to another node, unless that is a corner."""
        if self.is_node(handle):
            return False
        other = self.beyond(handle, node)
        return other != handle and (not self.is_node(other) or other in corners)

    def second(self, handle, node):
        other = self.beyond(handle, node)
        if self.is_node(other):
            return self.shares(other)
        return [times(Fraction(1, 2), (p[0] + q[0], p[1] + q[1])) for p, q in zip(self.shares(handle), self.shares(other))]

    def write(self):
        from fontTools.varLib.iup import iup_delta_optimize

        before = [tuple(p) for p in self.glyph.coordinates]
        for i, p in enumerate(self.rows[0]):
            if before[i] != p:
                self.glyph.coordinates[i] = p
        ends = list(self.glyph.endPtsOfContours)
        points = [tuple(p) for p in self.glyph.coordinates]
        for v, row, phantoms in zip(self.variations, self.rows[1:], self.phantoms):
            deltas = list(row) + [p for p in phantoms]
            if any(p is None for p in v.coordinates):
                inner = iup_delta_optimize(list(row) + [(0, 0)] * 4, points + [(0, 0)] * 4, ends, tolerance=0)[: len(row)]
                deltas = inner + [p for p in phantoms]
                if all(d is None for d in deltas):
                    deltas = list(row) + [p for p in phantoms]
            v.coordinates = deltas
        reach, record = box(self.glyph.coordinates), self.glyph
        if reach[0] < record.xMin or reach[1] < record.yMin or reach[2] > record.xMax or reach[3] > record.yMax:
            grow(self.font, self.name, reach)


class Cff2_outline(Variable_outline):
    """A glyph of CFF2, whose operands are blended."""

    degree = 3

    def __init__(self, font, name):
        from fontTools.cffLib import specializer
        from fontTools.misc.psCharStrings import SimpleT2Decompiler

        top = font["CFF2"].cff.topDictIndex[0]
        self.string = string = top.CharStrings[name]
        local = getattr(string.private, "Subrs", [])
        SimpleT2Decompiler(local, string.globalSubrs, string.private).execute(string)  # reads the subroutines, too
        program = inlined(string, local, string.globalSubrs)
        self.commands = specializer.generalizeCommands(specializer.programToCommands(program, string.private.getNumRegions))
        index = next((args[0] for operator, args in self.commands if operator == "vsindex"), getattr(string.private, "vsindex", 0))
        store = top.VarStore.otVarStore if hasattr(top, "VarStore") else None
        regions = []
        for number in store.VarData[index].VarRegionIndex if store else ():
            axes = zip(font["fvar"].axes, store.VarRegionList.Region[number].VarRegionAxis)
            regions.append({axis.axisTag: (a.StartCoord, a.PeakCoord, a.EndCoord) for axis, a in axes if a.PeakCoord != 0})
        self.masters = Region_masters(regions)
        self.rows = [[] for _ in self.masters.scalars]
        self.contours, self.places, self.nodes = [], [], set()
        at = [(0, 0)] * len(self.rows)
        for number, (operator, args) in enumerate(self.commands):
            if operator not in ("rmoveto", "rlineto", "rrcurveto"):
                continue
            for i in range(0, len(args), 2):
                at = [(p[0] + x, p[1] + y) for p, x, y in zip(at, self.operand(args[i]), self.operand(args[i + 1]))]
                self.add(at, i + 2 == len(args), (number, i), operator == "rmoveto")
        for contour in self.contours:
            if len(contour) > 1 and self.shares(contour[0]) == self.shares(contour[-1]):
                contour[0] = contour.pop()

    def operand(self, value):
        """The shares of an operand."""
        shares = list(value[:-1]) if isinstance(value, list) else [value]
        return [int(x) if int(x) == x else Fraction(x) for x in shares + [0] * (len(self.rows) - len(shares))]

    def add(self, shares, is_node, place, begins):
        number = len(self.places)
        for row, p in zip(self.rows, shares):
            row.append(p)
        self.places.append(place)
        if is_node:
            self.nodes.add(number)
        if begins:
            self.contours.append([])
        self.contours[-1].append(number)

    def is_node(self, i):
        return i in self.nodes

    def is_free(self, handle, node, corners):
        """Whether a handle may move: the one at the other end of its curve has a length, so that the tangent there does not depend on it."""
        if self.is_node(handle):
            return False
        other = self.beyond(handle, node)
        end = self.beyond(other, handle)
        return all(p != q for p, q in zip(self.masters.at(self.shares(other)), self.masters.at(self.shares(end))))

    def second(self, handle, node):
        return self.shares(self.beyond(handle, node))

    def set(self, i, shares):
        shifts = [minus(p, q) for p, q in zip(shares, self.shares(i))]
        super().set(i, shares)
        number, k = self.places[i]
        args = self.commands[number][1]
        for c in (0, 1):
            for place, sign in ((k + c, 1), (k + 2 + c, -1)):  # what follows a handle in its curve is relative to it
                value = [int(x + sign * s[c]) for x, s in zip(self.operand(args[place]), shifts)]
                args[place] = value + [1] if any(value[1:]) else value[0]

    def write(self):
        from fontTools.cffLib import specializer

        # not specialised again, which leaves out segments without length
        self.string.setProgram(specializer.commandsToProgram(self.commands))


def outlines(font):
    """Yields the name of each glyph that varies, and a function that reads it."""
    if "CFF2" in font:
        for name in font.getGlyphOrder():
            yield name, Cff2_outline
        return
    if "gvar" not in font or "glyf" not in font:
        refuse("a variable font without gvar and CFF2: its outlines do not vary")
    for name in font.getGlyphOrder():
        record = font["glyf"][name]
        if not record.isComposite() and record.numberOfContours > 0 and font["gvar"].variations.get(name):
            yield name, Glyf_outline


def mend_node(glyph, join, corners, bound):
    """Mends the handles at a node. Returns the largest move, or the reason why it is not mended."""
    _, before, node, behind = join
    a, b = glyph.sides(before, node, behind)
    free_a, free_b = glyph.is_free(before, node, corners), glyph.is_free(behind, node, corners)
    if not free_a and not free_b:
        return "no handle can move: each is the end of a line or belongs to another smooth node"
    best = smooth_handles(a, b, glyph.masters, free_a, free_b)
    if best is None:
        return "neither one ratio nor one direction is on the grid for all masters"
    if best[0] > (longest_move(a, b, glyph.masters) if bound is None else bound):
        return "a handle would move by %.4g units" % best[0]
    set_handles(glyph, join, *best[1:])
    return best[0]


def set_handles(glyph, join, a, b):
    _, before, node, behind = join
    n = glyph.shares(node)
    for i, shares in ((before, [minus(p, v) for p, v in zip(n, a)]), (behind, [(p[0] + v[0], p[1] + v[1]) for p, v in zip(n, b)])):
        if glyph.shares(i) != shares:
            glyph.set(i, shares)


PASSES = 16  # over the joins to be harmonised: each changes the curvatures next to it


class Harmoniser:
    """Makes the curvatures at the smooth nodes of a glyph agree."""

    def __init__(self, glyph, joins, corners, bound):
        self.glyph, self.joins, self.corners, self.bound = glyph, joins, corners, bound
        self.tried = {}  # the states of joins in which nothing was better

    def state(self, join):
        a, b = self.glyph.sides(*join[1:])
        return a, b, self.glyph.curves(*join[1:])

    def jump(self, state):
        """The jump of the curvature; None where no lengths of handles make it smaller."""
        a, b, curves = state
        masters = self.glyph.masters
        if curves is None or not all(any(v) for side in (a, b) for v in masters.at(side)):
            return None
        if not is_smooth(a, b) or not can_agree(a, b, curves, masters):
            return None
        return curvature_jump(a, b, curves, masters)

    def jumps(self):
        return [x for x in (self.jump(self.state(join)) for join in self.joins) if x]

    def harmonise(self, join):
        """Whether the curvatures at a node agree better than before, and none next to it is worse by more than that."""
        glyph = self.glyph
        a, b, curves = self.state(join)
        if self.tried.get(join) == (a, b, curves) or not self.jump((a, b, curves)):
            return False
        free = [glyph.is_free(handle, join[2], self.corners) for handle in (join[1], join[3])]
        for free_a, free_b in ((True, True), (True, False), (False, True)):  # a handle may be needed at its other node as it is
            free_a, free_b = free_a and free[0], free_b and free[1]
            best = harmonised(a, b, curves, glyph.masters, free_a, free_b, self.bound) if free_a or free_b else None
            if best is None:
                continue
            before = [self.state(j) for j in self.joins]
            set_handles(glyph, join, *best[2:])
            after = [self.state(j) for j in self.joins]
            changed = [(self.jump(x), self.jump(y)) for x, y in zip(before, after) if x != y]
            lost = any(old is not None and (new is None or old == 0 < new) for old, new in changed)
            if not lost and sum(new or 0 for _, new in changed) < sum(old or 0 for old, _ in changed):
                return True
            set_handles(glyph, join, a, b)
        self.tried[join] = a, b, curves
        return False

    def run(self):
        """Whether handles have moved."""
        rows, moved = [list(row) for row in self.glyph.rows], False
        for _ in range(PASSES):
            is_new = not self.tried
            if any([self.harmonise(join) for join in self.joins]):
                moved = True
            elif is_new:
                return moved
            else:
                self.tried.clear()  # what is next to them may have changed
        for i, shares in enumerate(zip(*rows)):  # the handles find no rest
            if self.glyph.shares(i) != list(shares):
                self.glyph.set(i, list(shares))
        return False


class Font_mender:
    def __init__(self, angle, bound, to):
        self.tangent, self.bound, self.to = math.tan(math.radians(angle)), bound, to
        self.mended, self.largest, self.left = 0, 0.0, []
        self.jumps_before, self.jumps_after = [], []

    def mend(self, name, glyph):
        corner = {join: glyph.is_corner(join, self.tangent) for join in glyph.joins()}
        corners = {join[2]: join for join in corner if corner[join]}
        smooth = [join for join in corner if corner[join] is False]
        kinks = [join for join in smooth if not is_smooth(*glyph.sides(*join[1:]))]
        if not kinks and self.to == "G1":
            return
        place = lambda join: "glyph %s, contour %d, node (%s, %s)" % (name, join[0], *map(float_text, glyph.rows[0][join[2]]))  # noqa: E731
        if not glyph.masters.has_order():
            self.left += ["%s: the regions overlap at their peaks" % place(join) for join in kinks]
            return
        moved = False
        for join in kinks:
            if not all(map(glyph.is_whole, join[1:])):
                self.left.append("%s: fractions of a unit, no grid to move handles on" % place(join))
                continue
            shares = {i: glyph.shares(i) for i in join[1:]}
            done = mend_node(glyph, join, corners, self.bound)
            if not isinstance(done, str) and not all(glyph.is_corner(c, self.tangent) for c in corners.values()):
                for i, old in shares.items():
                    if glyph.shares(i) != old:
                        glyph.set(i, old)
                done = "a corner would be none any more"
            if isinstance(done, str):
                self.left.append("%s: %s" % (place(join), done))
                continue
            moved, self.mended, self.largest = True, self.mended + 1, max(self.largest, done)
        if self.to == "G2":
            harmoniser = Harmoniser(glyph, [join for join in smooth if all(map(glyph.is_whole, join[1:]))], corners, self.bound)
            self.jumps_before += harmoniser.jumps()
            moved = harmoniser.run() or moved
            self.jumps_after += harmoniser.jumps()
        if moved:
            glyph.write()

    def report(self):
        for line in self.left:
            sys.stderr.write("not mended: %s\n" % line)
        text = "%d %s mended for all masters together" % (self.mended, "join is" if self.mended == 1 else "joins are")
        sys.stderr.write(text + (", with moves of at most %.4g units\n" % self.largest if self.mended else "\n"))
        if self.to == "G2":
            sys.stderr.write("curvatures: %s before, %s after\n" % (jumps_text(self.jumps_before), jumps_text(self.jumps_after)))


def float_text(x):
    return "%.10g" % x


def jumps_text(jumps):
    if not jumps:
        return "no jump"
    return "%d %s of up to %.3g %%" % (len(jumps), "jump" if len(jumps) == 1 else "jumps", 100 * max(jumps))


def mend_masters(font, angle, bound, to):
    mender = Font_mender(angle, bound, to)
    for name, read in outlines(font):
        mender.mend(name, read(font, name))
    mender.report()


def apply_moves(font, moves):
    if "gvar" in font or "CFF2" in font:
        refuse("a variable font: its masters are mended together, by --masters")
    by_glyph = {}
    for move in moves:
        by_glyph.setdefault(move["index"], []).append(move)
    if by_glyph:
        (move_in_glyf if "glyf" in font else move_in_cff)(font, by_glyph)


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    source, what, result = sys.argv[1], sys.argv[2], sys.argv[-1]
    kept = {"recalcBBoxes": False, "recalcTimestamp": False, "lazy": True}
    with open(source, "rb") as file:
        is_collection = file.read(4) == b"ttcf"
    font = TTCollection(source, **kept) if is_collection else TTFont(source, **kept)
    if what == "--masters":
        if is_collection:
            refuse("a collection of fonts; extract the variable fonts first")
        options = sys.argv[3:-1]
        to = options.pop(0) if options else "G1"
        if to not in ("G1", "G2"):
            sys.exit(__doc__)
        mend_masters(font, *([float(Fraction(x)) for x in options] + [5.0, None][len(options) :]), to)
    else:
        with open(what, encoding="utf-8") as file:
            moves = json.load(file)["moves"]
        for number, one in enumerate(font.fonts if is_collection else [font]):
            apply_moves(one, [move for move in moves if move.get("font", 0) == number])
    ending = os.path.splitext(result)[1].lower() if result[:2] != "-." else result[1:].lower()
    if is_collection != (ending in (".ttc", ".otc")):
        refuse("a collection of fonts is written as .ttc or .otc" if is_collection else "a single font is written as .ttf or .otf")
    written = io.BytesIO()
    if is_collection:
        font.save(written)
    else:
        font.flavor = ending[1:] if ending in (".woff", ".woff2") else None
        font.save(written, reorderTables=False)
    if result[:2] == "-.":
        sys.stdout.buffer.write(written.getvalue())
        return
    with open(result, "wb") as file:
        file.write(written.getvalue())


main()
