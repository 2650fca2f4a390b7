# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Applies the moves that `geometric_continuity repair FONT -o moves.json` has written to a font, with FontForge:

    fontforge -script apply_moves.py FONT moves.json RESULT

RESULT is a font (.ttf, .otf, ...), or a project of FontForge (.sfd). Each handle is found by its contour and its position, so that nothing
moves where the font is not the one that was repaired. Glyphs with components follow their components."""

import json
import re
import sys

import fontforge


def glyph_of(font, name):
    if name in font:
        return font[name]
    number = re.fullmatch(r"glyph(\d+)", name)  # of a font without names
    if number:
        for glyph in font.glyphs():
            if glyph.originalgid == int(number.group(1)):
                return glyph
    sys.exit("apply_moves.py: the font has no glyph %s" % name)


def nodes_beside(contour, k):
    """The positions of the nodes beside a point."""
    return [[p.x, p.y] for p in (contour[k - 1], contour[(k + 1) % len(contour)]) if p.on_curve]


def handle(layer, move):
    """The handle with this position at its node: in the contour with this number, or the only one of the glyph."""
    found = [
        (i != move["contour"], abs(k - move["point"]), i, k)
        for i, contour in enumerate(layer)
        for k, point in enumerate(contour)
        if not point.on_curve and [point.x, point.y] == move["from"] and move["node"] in nodes_beside(contour, k)
    ]
    if not found or (min(found)[0] and len(found) > 1):
        place = "glyph %(glyph)s, contour %(contour)d: there is no handle at %(from)s of the node %(node)s"
        sys.exit("apply_moves.py: " + place % move)
    return min(found)[2:]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    with open(sys.argv[2], encoding="utf-8") as f:
        moves = json.load(f)["moves"]
    if any("font" in move for move in moves):
        sys.exit("apply_moves.py: a collection of fonts; extract them first")
    font = fontforge.open(sys.argv[1])
    by_glyph = {}
    for move in moves:
        by_glyph.setdefault(move["glyph"], []).append(move)
    for name, of_glyph in by_glyph.items():
        glyph = glyph_of(font, name)
        layer = glyph.foreground
        places = [(handle(layer, move), move["to"]) for move in of_glyph]  # before any of them moves
        for (i, k), to in places:
            contour = layer[i]
            contour[k].x, contour[k].y = to
            layer[i] = contour
        glyph.foreground = layer
    if sys.argv[3].endswith(".sfd"):
        font.save(sys.argv[3])
    else:
        font.generate(sys.argv[3], flags=("opentype",))
    print("%d handles of %d glyphs are moved" % (len(moves), len(by_glyph)))


main()
