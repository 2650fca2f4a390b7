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
    """The positions of the nodes beside a handle, also of those that FontForge leaves out between two handles."""
    handle = contour[k]
    return [
        [p.x, p.y] if p.on_curve else [(p.x + handle.x) / 2, (p.y + handle.y) / 2]
        for p in (contour[k - 1], contour[(k + 1) % len(contour)])
    ]


def handle(layer, move, shift):
    """The handle with this position at its node: in the contour with this number, or the only one of the glyph."""
    node = [move["node"][0] + shift, move["node"][1]]
    found = [
        (i != move["contour"], abs(k - move["point"]), i, k)
        for i, contour in enumerate(layer)
        for k, point in enumerate(contour)
        if not point.on_curve
        and [point.x - shift, point.y] == move["from"]
        and node in nodes_beside(contour, k)
    ]
    if not found or (min(found)[0] and len(found) > 1):
        return None
    return min(found)[2:]


def handles(layer, moves):
    """The handles of a glyph, and how far it is from where it is drawn: by its left side bearing, whatever its points say."""
    shifts = {point.x - moves[0]["from"][0] for contour in layer for point in contour}
    for shift in sorted(shifts | {0}, key=abs):
        places = [handle(layer, move, shift) for move in moves]
        if None not in places:
            return places, shift
    missing = [move for move in moves if handle(layer, move, 0) is None][0]
    place = "glyph %(glyph)s, contour %(contour)d: there is no handle at %(from)s of the node %(node)s"
    sys.exit("apply_moves.py: " + place % missing)


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
        places, shift = handles(layer, of_glyph)  # before any of them moves
        for (i, k), move in zip(places, of_glyph):
            contour = layer[i]
            contour[k].x, contour[k].y = move["to"][0] + shift, move["to"][1]
            layer[i] = contour
        glyph.foreground = layer
    if sys.argv[3].endswith(".sfd"):
        font.save(sys.argv[3])
    else:
        font.generate(sys.argv[3], flags=("opentype",))
    print("%d handles of %d glyphs are moved" % (len(moves), len(by_glyph)))


main()
