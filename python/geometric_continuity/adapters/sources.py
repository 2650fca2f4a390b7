# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Sources of type designers: UFO (ufoLib2), designspaces of them, and .glyphs (glyphsLib). Kinks are found, and mended on the grid of whole
units by moving handles of cubic curves. Nothing else changes: points keep their numbers and types, so that masters stay compatible."""

from __future__ import annotations

import os
import plistlib
import re
import shutil
from typing import Dict, List, Optional

from .outlines import Kink, Move, Point, kinks, mend


def _ufo_points(contour) -> List[Point]:
    return [Point(p.x, p.y, p.type) for p in contour.points]


def ufo_kinks(font, kink_angle=5) -> List[Kink]:
    """Returns the kinks of the outlines of a `ufoLib2.Font` (or of any object with such glyphs, contours and points), without components."""
    return [k for glyph in font for number, contour in enumerate(glyph)
            for k in kinks(_ufo_points(contour), kink_angle, glyph.name, number)]


def mend_ufo_font(font, kink_angle=5, max_move: Optional[float] = None) -> List[Move]:
    """Mends the kinks of the outlines of a `ufoLib2.Font` in memory, and returns what was moved."""
    moves = []
    for glyph in font:
        for number, contour in enumerate(glyph):
            points = _ufo_points(contour)
            moved = mend(points, kink_angle, max_move, glyph.name or "", number)
            for m in moved:
                contour.points[m.index].x, contour.points[m.index].y = points[m.index].x, points[m.index].y
            moves += moved
    return moves


def _write_points(path: str, moves: List[Move]) -> None:
    """Writes coordinates of points into the text of a .glif file, and leaves every other byte as it is."""
    with open(path, "rb") as file:
        text = file.read().decode("utf-8")
    wanted: Dict = {}
    for m in moves:
        wanted.setdefault((m.contour, m.index), m)
        wanted[(m.contour, m.index)] = m  # the last one counts
    contour, index = -1, -1

    def write(match):
        nonlocal contour, index
        tag = match.group(0)
        if tag.startswith("<!--") or tag.startswith("<contour"):
            if tag.startswith("<contour"):
                contour, index = contour + 1, -1
            return tag
        index += 1
        move = wanted.get((contour, index))
        if move is None:
            return tag
        for name, value in zip("xy", move.after):
            tag = re.sub(rf"(\s{name}\s*=\s*)([\"'])[^\"']*\2", rf"\g<1>\g<2>{value}\g<2>", tag, count=1)
        return tag

    text = re.sub(r"<!--.*?-->|<contour\b[^>]*>|<point\b[^>]*>", write, text, flags=re.DOTALL)
    with open(path, "wb") as output:
        output.write(text.encode("utf-8"))


def mend_ufo(path, output=None, kink_angle=5, max_move: Optional[float] = None) -> List[Move]:
    """Mends the kinks of the UFO in the folder `path`, or of a copy of it in the new folder `output`, and returns what was moved. In the
    files of glyphs the coordinates of moved points are written anew, and every other byte stays as it is.

    Raises FileExistsError where `output` exists, and what ufoLib2 raises for a bad UFO.
    """
    import ufoLib2

    font = ufoLib2.Font.open(path)
    moves = []
    if output is not None:
        shutil.copytree(path, output)
    folder = os.fspath(path if output is None else output)
    layers = os.path.join(folder, "layercontents.plist")
    glyphs = os.path.join(folder, "glyphs")
    if os.path.exists(layers):
        with open(layers, "rb") as file:
            glyphs = os.path.join(folder, dict(plistlib.load(file))[font.layers.defaultLayer.name])
    with open(os.path.join(glyphs, "contents.plist"), "rb") as file:
        names = plistlib.load(file)
    for glyph in font:
        moved = []
        for number, contour in enumerate(glyph):
            moved += mend(_ufo_points(contour), kink_angle, max_move, glyph.name or "", number)
        if moved:
            _write_points(os.path.join(glyphs, names[glyph.name]), moved)
        moves += moved
    return moves


def designspace_sources(path) -> List[str]:
    """Returns the folders of the UFOs of a designspace, each once."""
    from fontTools.designspaceLib import DesignSpaceDocument

    paths = [source.path for source in DesignSpaceDocument.fromfile(path).sources if source.layerName is None]
    return list(dict.fromkeys(paths))


def incompatible(fonts) -> List[str]:
    """Returns the names of the glyphs whose contours do not have the same numbers and types of points in all `ufoLib2.Font`s that have the
    glyph: these cannot be interpolated."""
    structures: Dict[str, set] = {}
    for font in fonts:
        for glyph in font:
            structures.setdefault(glyph.name, set()).add(tuple(tuple(p.type for p in contour.points) for contour in glyph))
    return sorted(name for name, kinds in structures.items() if len(kinds) > 1)


def mend_designspace(path, kink_angle=5, max_move: Optional[float] = None) -> Dict[str, List[Move]]:
    """Mends the masters of a designspace where they are, and returns what was moved in each. Points keep their numbers and types, so that
    masters that were compatible are."""
    return {source: mend_ufo(source, None, kink_angle, max_move) for source in designspace_sources(path)}


def _glyphs_points(path) -> List[Point]:
    types = {"offcurve": None}
    points = [Point(n.position.x, n.position.y, types.get(n.type, n.type)) for n in path.nodes]
    if not path.closed and points:
        points[0].type = "move"
    return points


def _glyphs_paths(font):
    for glyph in font.glyphs:
        for layer in glyph.layers:
            for number, path in enumerate(layer.paths):
                yield f"{glyph.name} ({layer.name})", number, path


def glyphs_kinks(font, kink_angle=5) -> List[Kink]:
    """Returns the kinks of all layers of a `glyphsLib.GSFont`."""
    return [k for name, number, path in _glyphs_paths(font) for k in kinks(_glyphs_points(path), kink_angle, name, number)]


def mend_glyphs(font, kink_angle=5, max_move: Optional[float] = None) -> List[Move]:
    """Mends the kinks of all layers of a `glyphsLib.GSFont` in memory, so of all masters, and returns what was moved."""
    moves = []
    for name, number, path in _glyphs_paths(font):
        points = _glyphs_points(path)
        moved = mend(points, kink_angle, max_move, name, number)
        for m in moved:
            node = path.nodes[m.index]
            node.position = type(node.position)(points[m.index].x, points[m.index].y)
        moves += moved
    return moves
