# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes a font whose handles have moved, with fontTools; `geometric_continuity repair FONT -o NEW.ttf` calls this:

    python3 write_font.py FONT MOVES.json RESULT       the moves that `geometric_continuity repair FONT -o MOVES.json` has written
    python3 write_font.py FONT --masters [KINK_ANGLE [MAX_MOVE]] RESULT    a variable font: its masters, mended together

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


# Variable fonts: the handles at a node are sums over the default and the regions of gvar,
# a = sum s_r a_r and b = sum s_r b_r. They have one direction at every instance where b_r = k a_r
# for all r, or all a_r and b_r are multiples of one vector.


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def length(a):
    return math.hypot(float(a[0]), float(a[1]))


class Masters:
    """The scalars of the regions at their peaks, and at the default."""

    def __init__(self, variations):
        from fontTools.varLib.models import supportScalar

        peaks = [{}] + [{tag: peak for tag, (_, peak, _) in v.axes.items() if peak != 0} for v in variations]
        self.scalars = [[Fraction(1)] + [Fraction(supportScalar(at, v.axes)) for v in variations] for at in peaks]

    def at(self, shares):
        """The values at the masters of what has these shares of the default and the regions."""
        return [tuple(sum(s * v[c] for s, v in zip(row, shares)) for c in (0, 1)) for row in self.scalars]

    def shares(self, wanted, snap):
        """The shares, each of a form that snap(x, y, r) finds, which lead as near as they can to what is wanted at the masters."""
        found = []
        for r, row in enumerate(self.scalars):
            rest = [wanted[r][c] - sum(s * v[c] for s, v in zip(row, found)) for c in (0, 1)]
            found.append(snap(rest, r))
        return found

    def is_triangular(self):
        return all(row[r] == 1 and not any(row[r + 1 :]) for r, row in enumerate(self.scalars))


def is_smooth(a, b):
    n = len(a)
    return all(cross(a[r], b[t]) + cross(a[t], b[r]) == 0 for r in range(n) for t in range(r, n))


def nearest(x):
    return math.floor(Fraction(x) + Fraction(1, 2))


def by_ratio(a, b, masters, p, q, both):
    """One ratio p : q."""
    if not both:  # only b moves
        if any((p * c) % q for v in a for c in v):
            return None
        return a, [tuple(p * c // q for c in v) for v in a]
    wanted_a, wanted_b = masters.at(a), masters.at(b)
    # t is nearest to a / q and b / p, the larger one counting more
    wanted = [tuple(Fraction(q * u[c] + p * v[c], p * p + q * q) for c in (0, 1)) for u, v in zip(wanted_a, wanted_b)]
    t = masters.shares(wanted, lambda rest, r: tuple(nearest(c) for c in rest))
    return [(q * x, q * y) for x, y in t], [(p * x, p * y) for x, y in t]


def by_direction(a, b, masters, e, both):
    """One direction e."""

    def along(shares):
        square = dot(e, e)
        multiples = masters.shares(masters.at(shares), lambda rest, r: tuple(nearest(Fraction(dot(rest, e), square)) * c for c in e))
        return multiples

    if not both and any(cross(v, e) for v in a):
        return None
    return (along(a) if both else a), along(b)


def candidates(a, b, masters, both):
    """Pairs of handles that are smooth at every instance."""
    at_a, at_b = masters.at(a), masters.at(b)
    lengths = [(length(u), length(v)) for u, v in zip(at_a, at_b)]
    ratios = [v / u for u, v in lengths if u > 0 and v > 0]
    if not ratios:
        return
    low, high = min(ratios), max(ratios)
    if both:
        pairs = {(Fraction(p, q).numerator, Fraction(p, q).denominator) for p in range(1, 17) for q in range(1, 17)}
        pairs |= {(f.numerator, f.denominator) for x in ratios for f in [Fraction(x).limit_denominator(16)] if f > 0}
        for p, q in sorted(pairs):
            if low / 1.5 <= p / q <= high * 1.5:
                yield by_ratio(a, b, masters, p, q, True)
        directions = set()
        for u, v in zip(at_a, at_b):
            s = (float(u[0] + v[0]), float(u[1] + v[1]))
            most = max(abs(s[0]), abs(s[1]))
            if most == 0:
                continue
            for n in range(1, 17):
                e = nearest(s[0] * n / most), nearest(s[1] * n / most)
                g = math.gcd(*e)
                if g:
                    directions.add((e[0] // g, e[1] // g))
        for e in sorted(directions):
            yield by_direction(a, b, masters, e, True)
    else:
        g = math.gcd(*[abs(int(c)) for v in a for c in v])
        if g:
            first, last = math.floor(low * g), math.ceil(high * g)
            for p in range(max(1, first), last + 1) if last - first < 2000 else ():
                yield by_ratio(a, b, masters, p, g, False)
            e = next((v for v in a if any(v)))
            d = math.gcd(*[abs(int(c)) for c in e])
            yield by_direction(a, b, masters, (e[0] // d, e[1] // d), False)


class Variable_glyph:
    """A glyph of glyf and gvar; its points have integers for the default and for each region, inferred ones rounded."""

    def __init__(self, font, name):
        from fontTools.varLib.iup import iup_delta

        self.glyph, self.variations = font["glyf"][name], font["gvar"].variations[name]
        self.masters = Masters(self.variations)
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

    def shares(self, i):
        return [row[i] for row in self.rows]

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

    def is_corner(self, join, tangent):
        """Whether the join is a corner at all masters; None where it is one at some of them, or a handle has no length."""
        a, b = self.sides(*join[1:])
        found = set()
        for u, v in zip(self.masters.at(a), self.masters.at(b)):
            if not any(u) or not any(v):
                return None
            found.add(dot(u, v) <= 0 or abs(cross(u, v)) > tangent * float(dot(u, v)))
        return found.pop() if len(found) == 1 else None

    def is_free(self, handle, node, corners):
        """Whether a handle may move: it does not belong to another node, unless that is a corner."""
        if self.is_node(handle):
            return False
        contour = next(c for c in self.contours if handle in c)
        k = contour.index(handle)
        other = [i for i in (contour[k - 1], contour[(k + 1) % len(contour)]) if i != node]
        return len(other) == 1 and (not self.is_node(other[0]) or other[0] in corners)

    def set(self, i, shares):
        for row, share in zip(self.rows, shares):
            row[i] = share

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


def longest_move(a, b):
    """How far a handle may move unless it is told: eight times what the kink is off at a master or halfway between two, and one unit more."""
    halfway = [[tuple((u[c] + v[c]) / 2 for c in (0, 1)) for u in side for v in side] for side in (a, b)]
    lengths = [(abs(cross(u, v)), min(length(u), length(v))) for u, v in zip(*halfway)]
    return 1 + 8 * max(float(c) / least for c, least in lengths if least > 0)


def mend_node(glyph, join, corners, bound):
    """Mends the handles at a node. Returns the largest move, or the reason why it is not mended."""
    number, before, node, behind = join
    a, b = glyph.sides(before, node, behind)
    free_a, free_b = glyph.is_free(before, node, corners), glyph.is_free(behind, node, corners)
    if not free_a and not free_b:
        return "no handle can move: each is the end of a line or belongs to another smooth node"
    turned = free_a and not free_b
    if turned:
        a, b = b, a
    masters, best = glyph.masters, None
    for found in candidates(a, b, masters, free_a and free_b):
        if found is None:
            continue
        x, y = found
        if not is_smooth(x, y) or any(dot(u, v) <= 0 for u, v in zip(masters.at(x), masters.at(y))):
            continue
        moves = [length(minus(u, v)) for old, new in ((a, x), (b, y)) for u, v in zip(masters.at(old), masters.at(new))]
        cost = max(moves), sum(moves)
        if best is None or cost < best[0]:
            best = cost, x, y
    if best is None:
        return "neither one ratio nor one direction is on the grid for all masters"
    cost, x, y = best
    if cost[0] > (longest_move(masters.at(a), masters.at(b)) if bound is None else bound):
        return "a handle would move by %.4g units" % cost[0]
    if turned:
        x, y = y, x
    n = glyph.shares(node)
    if free_a:
        glyph.set(before, [minus(p, v) for p, v in zip(n, x)])
    if free_b:
        glyph.set(behind, [(p[0] + v[0], p[1] + v[1]) for p, v in zip(n, y)])
    return cost[0]


def mend_masters(font, angle, bound):
    if "gvar" not in font or "glyf" not in font:
        refuse("the masters of this variable font are in CFF2, whose handles are not moved; mend its sources with the Python module")
    tangent = math.tan(math.radians(angle))
    mended, largest, left = 0, 0.0, []
    for name in font.getGlyphOrder():
        record = font["glyf"][name]
        if record.isComposite() or record.numberOfContours <= 0 or not font["gvar"].variations.get(name):
            continue
        glyph = Variable_glyph(font, name)
        corner = {join: glyph.is_corner(join, tangent) for join in glyph.joins()}
        kinks = [join for join in corner if corner[join] is False and not is_smooth(*glyph.sides(*join[1:]))]
        if not kinks:
            continue
        corners = {join[2]: join for join in corner if corner[join]}
        place = lambda join: "glyph %s, contour %d, node (%d, %d)" % (name, join[0], *glyph.rows[0][join[2]])  # noqa: E731
        if not glyph.masters.is_triangular():
            left += ["%s: the regions overlap at their peaks" % place(join) for join in kinks]
            continue
        moved = False
        for join in kinks:
            rows = [list(row) for row in glyph.rows]
            done = mend_node(glyph, join, corners, bound)
            if not all(glyph.is_corner(c, tangent) for c in corners.values()):
                glyph.rows, done = rows, "a corner would be none any more"
            if isinstance(done, str):
                left.append("%s: %s" % (place(join), done))
                continue
            moved, mended, largest = True, mended + 1, max(largest, done)
        if moved:
            glyph.write()
            record = glyph.glyph
            reach = box(record.coordinates)
            if reach[0] < record.xMin or reach[1] < record.yMin or reach[2] > record.xMax or reach[3] > record.yMax:
                grow(font, name, reach)
    for line in left:
        sys.stderr.write("not mended: %s\n" % line)
    text = "%d %s mended for all masters together" % (mended, "join is" if mended == 1 else "joins are")
    sys.stderr.write(text + (", with moves of at most %.4g units\n" % largest if mended else "\n"))


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
        options = [float(x) for x in sys.argv[3:-1]]
        mend_masters(font, options[0] if options else 5.0, options[1] if len(options) > 1 else None)
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
