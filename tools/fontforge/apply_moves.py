# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Applies the moves that `geometric_continuity repair FONT -o moves.json` has written to a font, with FontForge:

    fontforge -script apply_moves.py FONT [moves.json] RESULT

Without moves.json it calls the program itself, which is on the path or GEOMETRIC_CONTINUITY_PROGRAM. RESULT is a font (.ttf, .otf, ...), or a project of FontForge (.sfd). Each handle is found by its contour and its position, so that nothing
moves where the font is not the one that was repaired. Glyphs with components follow their components."""

import json
import os
import subprocess
import sys
import tempfile

import fontforge


def nodes_beside(contour, k):
    """The positions of the nodes beside a handle. Where a node is left out between two handles, these do not move."""
    beside = contour[k - 1], contour[(k + 1) % len(contour)]
    return [[p.x, p.y] for p in beside if p.on_curve]


def drawn(layer):
    """The contours as they are counted, without those that are a single point."""
    return [i for i, contour in enumerate(layer) if len({(p.x, p.y) for p in contour}) > 1]


def handle(layer, move, shift, taken):
    """The handle with this position at its node in the contour with this number; of several that are left the one nearest to its number."""
    contours = drawn(layer)
    if move["contour"] >= len(contours):
        return None
    i = contours[move["contour"]]
    node = [move["node"][0] + shift, move["node"][1]]
    found = [
        (abs(k - move["point"]), k)
        for k, point in enumerate(layer[i])
        if not point.on_curve
        and [point.x - shift, point.y] == move["from"]
        and node in nodes_beside(layer[i], k)
        and (i, k) not in taken
    ]
    return (i, min(found)[1]) if found else None


def places(layer, moves, shift):
    """A handle for each of the moves."""
    found = []
    for move in moves:
        found.append(handle(layer, move, shift, found))
    return found


def handles(layer, moves):
    """The handles of a glyph, and how far it is from where it is drawn: by its left side bearing, whatever its points say."""
    shifts = {point.x - moves[0]["from"][0] for contour in layer for point in contour}
    for shift in sorted(shifts | {0}, key=abs):
        found = places(layer, moves, shift)
        if None not in found:
            return found, shift
    missing = moves[places(layer, moves, 0).index(None)]
    place = "glyph %(glyph)s, contour %(contour)d: there is no handle at %(from)s of the node %(node)s"
    sys.exit("apply_moves.py: " + place % missing)


def read_moves(path):
    with open(path, encoding="utf-8") as f:
        return json.load(f)["moves"]


def moves_of(font):
    """What the program would move."""
    program = os.environ.get("GEOMETRIC_CONTINUITY_PROGRAM", "geometric_continuity")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "moves.json")
        done = subprocess.run([program, "repair", font, "-o", path], stdout=subprocess.DEVNULL)
        if done.returncode not in (0, 1):  # 1: kinks are left that no handle on the grid can mend
            sys.exit("apply_moves.py: geometric_continuity refuses the font")
        return read_moves(path)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    name, result = sys.argv[1], sys.argv[-1]
    moves = read_moves(sys.argv[2]) if len(sys.argv) == 4 else moves_of(name)
    if any("font" in move for move in moves):
        sys.exit("apply_moves.py: a collection of fonts; extract them first")
    font = fontforge.open(name)
    named, numbered = {}, {}
    for glyph in font.glyphs():
        named.setdefault(glyph.glyphname, []).append(glyph)
        numbered[glyph.originalgid] = glyph
    by_glyph = {}
    for move in moves:
        by_glyph.setdefault((move["glyph"], move["index"]), []).append(move)
    for (name, index), of_glyph in by_glyph.items():
        same_name = named.get(name, [])  # none in fonts without names, and sometimes several
        glyph = same_name[0] if len(same_name) == 1 else numbered.get(index)
        if glyph is None:
            sys.exit("apply_moves.py: the font has no glyph %s" % name)
        layer = glyph.foreground
        found, shift = handles(layer, of_glyph)  # before any of them moves
        for (i, k), move in zip(found, of_glyph):
            contour = layer[i]
            contour[k].x, contour[k].y = move["to"][0] + shift, move["to"][1]
            layer[i] = contour
        glyph.foreground = layer
    if result.endswith(".sfd"):
        font.save(result)
    else:
        font.generate(result, flags=("opentype",))
    print("%d handles of %d glyphs are moved" % (len(moves), len(by_glyph)))


main()
