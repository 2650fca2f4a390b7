# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Sources of type designers: UFO (ufoLib2), designspaces of them, and .glyphs (glyphsLib). Kinks are found, and mended on the grid of whole
units by moving handles of cubic curves. Nothing else changes: points keep their numbers and types, so that masters stay compatible."""

from __future__ import annotations

import argparse
import json
import math
import os
import plistlib
import re
import shutil
import sys
from fractions import Fraction
from typing import Dict, List, Optional

from .outlines import Kink, Move, Point, are_compatible, curvature_jumps, joins, kinks, kinks_between, mend, mend_masters


def _ufo_points(contour) -> List[Point]:
    return [Point(p.x, p.y, p.type) for p in contour.points]


def ufo_kinks(font, kink_angle=5) -> List[Kink]:
    """Returns the kinks of the outlines of a `ufoLib2.Font` (or of any object with such glyphs, contours and points), without components."""
    return [k for glyph in font for number, contour in enumerate(glyph)
            for k in kinks(_ufo_points(contour), kink_angle, glyph.name, number)]


def mend_ufo_font(font, kink_angle=5, max_move: Optional[float] = None, to: str = "G1") -> List[Move]:
    """Mends the kinks of the outlines of a `ufoLib2.Font` in memory, with `to="G2"` also the curvatures, see `outlines.mend()`; returns what
    was moved."""
    return _mend_ufo_contours(font, set(), kink_angle, max_move, to)


def _mend_ufo_contours(font, done, kink_angle, max_move: Optional[float], to: str) -> List[Move]:
    """Mends all contours but those that are done, given by the name of the glyph and their number."""
    moves = []
    for glyph in font:
        for number, contour in enumerate(glyph):
            if (glyph.name, number) in done:
                continue
            points = _ufo_points(contour)
            moved = mend(points, kink_angle, max_move, glyph.name or "", number, to)
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


def mend_ufo(path, output=None, kink_angle=5, max_move: Optional[float] = None, to: str = "G1") -> List[Move]:
    """Mends the kinks of the UFO in the folder `path`, or of a copy of it in the new folder `output`, with `to="G2"` also the curvatures, and
    returns what was moved. In the files of glyphs the coordinates of moved points are written anew, and every other byte stays as it is.

    Raises FileExistsError where `output` exists, and what ufoLib2 raises for a bad UFO.
    """
    import ufoLib2

    font = ufoLib2.Font.open(path)
    if output is not None:
        shutil.copytree(path, output)
    moves = mend_ufo_font(font, kink_angle, max_move, to)
    _write_ufo(os.fspath(path if output is None else output), font, moves)
    return moves


def _write_ufo(folder: str, font, moves: List[Move]) -> None:
    """Writes moved points into the files of the glyphs of a UFO."""
    layers = os.path.join(folder, "layercontents.plist")
    glyphs = os.path.join(folder, "glyphs")
    if os.path.exists(layers):
        with open(layers, "rb") as file:
            glyphs = os.path.join(folder, dict(plistlib.load(file))[font.layers.defaultLayer.name])
    with open(os.path.join(glyphs, "contents.plist"), "rb") as file:
        names = plistlib.load(file)
    by_glyph: Dict[str, List[Move]] = {}
    for m in moves:
        by_glyph.setdefault(m.glyph, []).append(m)
    for name, moved in by_glyph.items():
        _write_points(os.path.join(glyphs, names[name]), moved)


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


def _ufo_masters(fonts):
    """Returns the points of the contours of each glyph that are compatible in all masters that have the glyph, by name and number of the contour:
    (name, number, the numbers of these masters, their points)."""
    found = []
    for name in dict.fromkeys(glyph.name for font in fonts for glyph in font):
        numbers = [i for i, font in enumerate(fonts) if name in font]
        outlines = [[_ufo_points(contour) for contour in fonts[i][name]] for i in numbers]
        if len(numbers) > 1 and len({len(o) for o in outlines}) == 1 and all(are_compatible(masters) for masters in zip(*outlines)):
            found += [(name, k, numbers, list(masters)) for k, masters in enumerate(zip(*outlines))]
    return found


def mend_designspace(path, kink_angle=5, max_move: Optional[float] = None, to: str = "G1") -> Dict[str, List[Move]]:
    """Mends the masters of a designspace where they are, and returns what was moved in each. Where the contours of a glyph are compatible the
    masters are mended together, so that no instance has a kink, and with `to="G2"` the curvatures agree in all of them, see
    `outlines.mend_masters()`; other glyphs in each master alone. Points keep their numbers and types, so that masters that were compatible are."""
    import ufoLib2

    paths = designspace_sources(path)
    fonts = [ufoLib2.Font.open(source) for source in paths]
    moves: List[List[Move]] = [[] for _ in paths]
    done = set()
    for name, number, numbers, masters in _ufo_masters(fonts):
        done.add((name, number))
        for i, points, moved in zip(numbers, masters, mend_masters(masters, kink_angle, max_move, name, number, to)):
            for m in moved:
                point = fonts[i][name][number].points[m.index]
                point.x, point.y = points[m.index].x, points[m.index].y
            moves[i] += moved
    for source, font, moved in zip(paths, fonts, moves):
        moved += _mend_ufo_contours(font, done, kink_angle, max_move, to)
        _write_ufo(source, font, moved)
    return dict(zip(paths, moves))


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


def _glyphs_masters(font):
    """Returns the paths of each glyph of a `glyphsLib.GSFont` that are compatible in the layers of all masters: (name, number, paths, their points)."""
    found = []
    for glyph in font.glyphs:
        layers = [layer for layer in glyph.layers if layer.layerId == layer.associatedMasterId]
        if len(layers) < 2 or len({len(layer.paths) for layer in layers}) != 1:
            continue
        paths = list(zip(*(layer.paths for layer in layers)))
        points = [[_glyphs_points(p) for p in masters] for masters in paths]
        if all(are_compatible(masters) for masters in points):
            found += [(glyph.name, k, p, q) for k, (p, q) in enumerate(zip(paths, points))]
    return found


def _move_nodes(path, points: List[Point], moved: List[Move]) -> None:
    for m in moved:
        node = path.nodes[m.index]
        node.position = type(node.position)(points[m.index].x, points[m.index].y)


def mend_glyphs(font, kink_angle=5, max_move: Optional[float] = None, to: str = "G1") -> List[Move]:
    """Mends the kinks of all layers of a `glyphsLib.GSFont` in memory, and returns what was moved: of masters with compatible paths together,
    so that no instance has a kink, and with `to="G2"` the curvatures agree in all of them, see `outlines.mend_masters()`; of other layers each
    alone."""
    moves, done = [], set()
    for name, number, paths, masters in _glyphs_masters(font):
        for path, points, moved in zip(paths, masters, mend_masters(masters, kink_angle, max_move, name, number, to)):
            _move_nodes(path, points, moved)
            moves += moved
            done.add(id(path))
    for name, number, path in _glyphs_paths(font):
        if id(path) in done:
            continue
        points = _glyphs_points(path)
        moved = mend(points, kink_angle, max_move, name, number, to)
        _move_nodes(path, points, moved)
        moves += moved
    return moves


def _contours(path):
    """Yields the name of each glyph of a source, the number of the contour and its points; of a designspace, of its UFOs."""
    kind = os.path.splitext(os.fspath(path).rstrip("/"))[1].lower()
    if kind == ".glyphs":
        import glyphsLib

        for name, number, contour in _glyphs_paths(glyphsLib.GSFont(path)):
            yield name, number, _glyphs_points(contour)
        return
    import ufoLib2

    masters = designspace_sources(path) if kind == ".designspace" else [path]
    for master in masters:
        for glyph in ufoLib2.Font.open(master):
            for number, contour in enumerate(glyph):
                name = glyph.name if len(masters) == 1 else f"{glyph.name} ({os.path.basename(master.rstrip('/'))})"
                yield name, number, _ufo_points(contour)


def verify_source(path, kink_angle=5, require: Optional[str] = None) -> Dict:
    """Decides all joins of a source, a UFO, a .glyphs or the UFOs of a designspace, exactly, and returns how many have each grade, and the
    kinks. Components are not looked into: no affine map makes a smooth join of the glyph that it repeats a kink.

    require: "G1" or "G2": then `met` tells whether all joins but corners have this order.
    """
    counts = dict.fromkeys(("joins", "corner", "kink", "g1", "g2", "undecided"), 0)
    found: List[Kink] = []
    for name, number, points in _contours(path):
        for join in joins(points):
            grade = join.grade(kink_angle)
            counts["joins"] += 1
            counts["undecided" if grade is None else grade.name] += 1
        found += kinks(points, kink_angle, name, number)
    failing = counts["kink"] + counts["undecided"] + (counts["g1"] if require == "G2" else 0)
    return {"file": os.fspath(path), "met": counts["joins"] > 0 and (require is None or failing == 0), "summary": counts, "kinks": found}


def _all_masters(path):
    """Yields the points of each contour in all masters: of those that are compatible together, otherwise of one master alone."""
    kind = os.path.splitext(os.fspath(path).rstrip("/"))[1].lower()
    if kind == ".glyphs":
        import glyphsLib

        font = glyphsLib.GSFont(path)
        together = _glyphs_masters(font)
        done = {id(p) for _, _, paths, _ in together for p in paths}
        yield from (masters for *_, masters in together)
        yield from ([_glyphs_points(p)] for _, _, p in _glyphs_paths(font) if id(p) not in done)
        return
    import ufoLib2

    fonts = [ufoLib2.Font.open(source) for source in (designspace_sources(path) if kind == ".designspace" else [path])]
    found = _ufo_masters(fonts)
    done = {(name, number) for name, number, *_ in found}
    yield from (masters for *_, masters in found)
    yield from ([_ufo_points(contour)] for font in fonts for glyph in font for number, contour in enumerate(glyph) if (glyph.name, number) not in done)


def between_masters(path, kink_angle=5) -> int:
    """Returns at how many nodes of a designspace, or of a .glyphs, some mixture of its masters has a kink, where no master has a corner."""
    return sum(len(kinks_between(masters, kink_angle)) for masters in _all_masters(path) if len(masters) > 1)


def source_jumps(path, kink_angle=5) -> List[float]:
    """Returns the largest relative jump of the curvature at each node of a source that other lengths of handles would lessen, in all masters
    together where these are compatible, see `outlines.curvature_jumps()`."""
    return [jump for masters in _all_masters(path) for _, jump in curvature_jumps(masters, kink_angle)]


def mend_source(path, output, kink_angle=5, max_move: Optional[float] = None, to: str = "G1") -> List[Move]:
    """Mends the kinks of a source, with `to="G2"` also the curvatures, and writes it to `output`, which may be `path`; a designspace is written with its UFOs, which have the
    same places beside it. Returns what was moved.

    Raises FileExistsError where another UFO is there already, ValueError for UFOs that are not in the folder of their designspace.
    """
    same = os.path.exists(output) and os.path.samefile(path, output)
    kind = os.path.splitext(os.fspath(path).rstrip("/"))[1].lower()
    if kind == ".glyphs":
        import glyphsLib

        font = glyphsLib.GSFont(path)
        moves = mend_glyphs(font, kink_angle, max_move, to)
        font.save(output)
        return moves
    if kind != ".designspace":
        return mend_ufo(path, None if same else output, kink_angle, max_move, to)
    folder, copies = os.path.dirname(os.path.abspath(path)), os.path.dirname(os.path.abspath(output))
    if not same:
        for source in designspace_sources(path):
            place = os.path.relpath(source, folder)
            if place.startswith(os.pardir):
                raise ValueError(f"{place}: not in the folder of the designspace; write the result over the designspace")
            shutil.copytree(source, os.path.join(copies, place))
        shutil.copyfile(path, output)
    return [m for moved in mend_designspace(output, kink_angle, max_move, to).values() for m in moved]


def _counts_text(counts: Dict) -> str:
    words = {"corner": "corners", "kink": "kinks", "g1": "G1", "g2": "G2 or more", "undecided": "undecided"}
    return f"{counts['joins']} joins: " + ", ".join(f"{counts[k]} {word}" for k, word in words.items() if counts[k] or k != "undecided")


def _jumps_text(jumps: List[float]) -> str:
    return "no jump" if not jumps else f"{len(jumps)} {'jump' if len(jumps) == 1 else 'jumps'} of up to {100 * max(jumps):.3g} %"


def _print_record(record: Dict, require: Optional[str]) -> None:
    print(f"{record['file']}: {_counts_text(record['summary'])}")
    for kink in sorted(record["kinks"], key=lambda k: -k.handle_offset)[:20]:
        print(f"    {kink.glyph}, contour {kink.contour}, node {kink.node} at ({kink.point[0]}, {kink.point[1]}): "
              f"{math.degrees(kink.angle):.3g} degrees, off by {kink.handle_offset:.3g} units")
    if not record["summary"]["joins"]:
        print("no join, nothing was decided")
    elif require:
        print(f"every join but corners is {require}, proved exactly" if record["met"] else f"not every join but corners is {require}")


def main(arguments: List[str]) -> int:
    """Verifies or repairs sources as the commands `verify` and `repair` of the program do, which call this."""
    parser = argparse.ArgumentParser(prog="geometric_continuity")
    commands = parser.add_subparsers(dest="command", required=True)
    verify, repair = commands.add_parser("verify"), commands.add_parser("repair")
    for command in (verify, repair):
        command.add_argument("--kink-angle", type=Fraction, default=Fraction(5))
    verify.add_argument("--require", choices=("G1", "G2"))
    verify.add_argument("--json", action="store_true")
    verify.add_argument("files", nargs="+")
    repair.add_argument("--max-move", type=Fraction)
    repair.add_argument("--to", choices=("G1", "G2"), default="G1")
    repair.add_argument("file")
    repair.add_argument("output")
    given = parser.parse_args(arguments)
    try:
        if given.command == "repair":
            before, between = verify_source(given.file, given.kink_angle), between_masters(given.file, given.kink_angle)
            jumps = source_jumps(given.file, given.kink_angle) if given.to == "G2" else []
            moves = mend_source(given.file, given.output, given.kink_angle, given.max_move, given.to)
            record = verify_source(given.output, given.kink_angle, "G1")
            print(f"moves: {len(moves)} handles\nbefore: {_counts_text(before['summary'])}")
            if between:
                print(f"nodes with a kink between masters: {between} before, {between_masters(given.output, given.kink_angle)} after")
            if given.to == "G2":
                print(f"curvatures: {_jumps_text(jumps)} before, {_jumps_text(source_jumps(given.output, given.kink_angle))} after")
            _print_record(record, "G1")
            return 0 if record["met"] else 1
        records = [verify_source(file, given.kink_angle, given.require) for file in given.files]
    except ModuleNotFoundError as error:
        if error.name not in ("ufoLib2", "glyphsLib", "fontTools"):
            raise
        print(f"{error.name} is not installed, which reads this source: pip install {error.name}", file=sys.stderr)
        return 2
    if given.json:
        for record in records:
            record["kinks"] = [{"glyph": k.glyph, "contour": k.contour, "node": k.node, "point": [float(c) for c in k.point],
                                "angle_degrees": math.degrees(k.angle), "handle_offset": k.handle_offset} for k in record["kinks"]]
        print(json.dumps({"sources": records, "met": all(r["met"] for r in records)}, indent=1))
    else:
        for record in records:
            _print_record(record, given.require)
    return 0 if all(r["met"] for r in records) else 1
