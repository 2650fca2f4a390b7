#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks on real fonts that `verify` and `repair` agree: repair_fonts.py PROGRAM FILE_OR_FOLDER... [-- OPTIONS OF repair...]

Every font is verified and repaired; FontForge applies the moves, and as a control none, because it changes fonts by itself, above all
fractions. Of each font must hold: `repair` counts the joins of each grade that `verify` counts, and the nodes that it leaves are kinks,
bends or rounding to `verify`; afterwards the kinks of a glyph are those that were left, composed ones have as many as their components, no kink is
off by more, all other glyphs are those of the control, joins and corners are as they were, and there is nothing left to move. Kinks of
glyphs are those with bends and rounding here. Prints what does not hold, and the sums."""

import collections
import json
import os

from repaired_files import main, run

APPLY = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/fontforge/apply_moves.py")
GRADES = ("joins", "corners", "kinks", "bends", "G1", "G2")
CLASSES = ("joins", "corners", "kinks", "bends", "rounding", "G1", "G2")


class Glyph:
    """The counts of a glyph, and its kinks: how often each node is one, in which components, and how far the worst is off."""

    def __init__(self, report):
        self.counts = [report[grade] for grade in GRADES]
        kinks = [join for join in report["worst"] if join["grade"] in ("kink", "bend")]
        self.nodes = collections.Counter(tuple(join["point"]) for join in kinks)
        self.parts = collections.Counter(join["component"] for join in kinks if "component" in join)
        self.units = max((join["units"] for join in kinks), default=0)

    def moved_to(self, other):
        """How far to the right the other one is, where it is the same besides; else nothing."""
        shift = min(other.nodes)[0] - min(self.nodes)[0] if self.nodes and other.nodes else 0
        return shift if self.counts == other.counts and shifted(self.nodes, shift) == other.nodes else None


def shifted(nodes, shift):
    return collections.Counter({(x + shift, y): n for (x, y), n in nodes.items()})


def verified(program, file, angle):
    """The glyphs by name, and which of those with this name; nothing where the font is refused."""
    done = run(program, "verify", file, "--json", "--off-by", "0", "--worst", "1000000", "--allow-empty", *angle)
    if done.returncode == 2:
        return None
    glyphs, seen = {}, collections.Counter()
    for glyph in json.loads(done.stdout)["glyphs"]:
        glyphs[glyph["name"], seen[glyph["name"]]] = glyph["index"], Glyph(glyph)
        seen[glyph["name"]] += 1
    return glyphs


def check_given(program, file, angle, glyphs, moved, left, report, sums):
    done = run(program, "verify", file, "--json", "--summary", "--allow-empty", *angle)
    summary = json.loads(done.stdout)["summary"]
    for name in CLASSES:
        if summary[name] != report["before"][name]:
            yield "verify counts %d %s, repair %d" % (summary[name], name, report["before"][name])
    own = {index: glyph for index, glyph in glyphs.values() if not glyph.parts}
    for index, nodes in left.items():
        if nodes - own[index].nodes or (index not in moved and nodes != own[index].nodes):
            yield "glyph %d: repair leaves %s, the kinks of verify are %s" % (index, nodes, own[index].nodes)
    sums["kinks before"] += report["before"]["kinks"]
    sums["kinks after"] += report["after"]["kinks"]


def check_repaired(glyphs, control, repaired, moved, left, sums):
    counts = {}  # of kinks in a component, before and after
    for (name, _), (index, glyph) in glyphs.items():
        if index in moved or index in left:
            counts[name] = sum(glyph.nodes.values()), sum(left.get(index, {}).values())
    for key, (index, glyph) in glyphs.items():
        if key not in control or key not in repaired:
            yield "glyph %s is missing" % key[0]
            continue
        (_, same), (_, result) = control[key], repaired[key]
        shift = glyph.moved_to(same)
        sums["glyphs"] += 1
        sums["changed by FontForge"] += shift is None
        if shift is None or not (index in moved or index in left or glyph.parts):
            if result.counts != same.counts or result.nodes != same.nodes:
                yield "glyph %s is not that of the control" % key[0]
            continue
        if glyph.parts:
            kinks = sum(n // counts[part][0] * counts[part][1] if part in counts else n for part, n in glyph.parts.items())
            if sum(result.nodes.values()) != kinks:
                yield "glyph %s: %s instead of %d kinks" % (key[0], result.nodes, kinks)
        elif result.nodes != shifted(left.get(index, {}), shift):
            yield "glyph %s: kinks at %s instead of %s" % (key[0], result.nodes, left.get(index))
        if result.counts[:2] != glyph.counts[:2]:
            yield "glyph %s: other joins or corners than before" % key[0]
        if result.units > max(glyph.units, same.units):
            yield "glyph %s: off by %g units, before by %g" % (key[0], result.units, glyph.units)


def check(program, file, data, folder, options, angle, sums):
    moves, none, again = (os.path.join(folder, name) for name in ("moves.json", "none.json", "again.json"))
    kind = data[4:8] if data[:3] == b"wOF" else data[:4]
    extension = ".ttf" if kind in (b"\0\1\0\0", b"true") else ".otf"
    glyphs = verified(program, file, angle)
    done = run(program, "repair", file, "-o", moves, *options)
    if glyphs is None or done.returncode == 2:
        sums["refused"] += 1
        if (glyphs is None) != (done.returncode == 2):
            yield "only one of verify and repair refuses it: " + done.stderr
        return
    with open(moves, encoding="utf-8") as f:
        report = json.load(f)
    sums["fonts"] += 1
    sums["moves"] += len(report["moves"])
    if any("font" in x for name in ("moves", "not_repaired") for x in report[name]):
        return  # a collection
    moved = {move["index"] for move in report["moves"]}
    left = {}
    for join in report["not_repaired"]:
        left.setdefault(join["index"], collections.Counter())[tuple(join["node"])] += 1
    yield from check_given(program, file, angle, glyphs, moved, left, report, sums)
    if not moved:
        return
    with open(none, "w", encoding="utf-8") as f:
        f.write('{"moves":[]}')
    results = []
    for list_of_moves, name in (none, "control"), (moves, "repaired"):
        result = os.path.join(folder, name + extension)
        done = run("fontforge", "-script", APPLY, file, list_of_moves, result)
        if done.returncode != 0:
            yield "not applied: " + (done.stdout + done.stderr)[-200:]
            return
        results.append(verified(program, result, angle))
    sums["by FontForge"] += 1
    yield from check_repaired(glyphs, results[0], results[1], moved, left, sums)
    run(program, "repair", result, "-o", again, *options)
    with open(again, encoding="utf-8") as f:
        if json.load(f)["moves"]:
            yield "repaired again, it changes"


if __name__ == "__main__":
    names = ("fonts", "refused", "kinks before", "kinks after", "moves", "by FontForge", "glyphs", "changed by FontForge")
    main(r"\.(ttf|otf|ttc|otc|pf[ab]|woff2?)$", names, check)
