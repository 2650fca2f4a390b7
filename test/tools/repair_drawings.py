#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks on real drawings that `verify` and `repair` agree: repair_drawings.py PROGRAM FILE_OR_FOLDER... [-- OPTIONS OF repair...]

Every .svg and .svgz is repaired, and verified before and after. Of each drawing must hold: `repair` counts what `verify` counts, before and
after; no join is worse than it was; a corner stays a corner; what is repaired again stays as it is; and where exit code 0 says that no
kink is left, `verify` finds none. Prints what does not hold, and the sums."""

import gzip
import json
import os

from repaired_files import main, run

RANK = {"gap": 0, "corner": 1, "kink": 2, "G1": 3, "G2": 4}


def joins(program, file, angle):
    done = run(program, "verify", file, "--json", "--allow-empty", *angle)
    if done.returncode == 2:
        return None, done.stderr
    report = json.loads(done.stdout)
    return [(j["grade"], j["id"], j["left_command"]) for j in report["joins"]], ""


def count(found, grade):
    return sum(g == grade for g, _, _ in found)


def check(program, file, data, folder, options, angle, sums):
    given, repaired, again = (os.path.join(folder, name) for name in ("given.svg", "repaired.svg", "again.svg"))
    with open(given, "wb") as f:
        f.write(gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data)
    before, reason = joins(program, given, angle)
    done = run(program, "repair", given, "-o", repaired, "--json", *options)
    if before is None or done.returncode == 2:
        sums["refused"] += 1
        if before is not None and "UTF-16" not in done.stderr:
            yield "repair refuses what verify reads: " + done.stderr
        return
    if done.returncode not in (0, 1):
        yield "repair ends with %d: %s" % (done.returncode, done.stderr)
        return
    report = json.loads(done.stdout)
    after, reason = joins(program, repaired, angle)
    if after is None:
        yield "verify refuses the result: " + reason
        return
    for name, found, said in (("before", before, report["before"]), ("after", after, report["after"])):
        for grade in RANK:
            key = grade + "s" if grade[0].islower() else grade
            if count(found, grade) != said[key]:
                yield "%s: verify counts %d %s, repair %d" % (name, count(found, grade), key, said[key])
    if len(before) != len(after):
        yield "%d joins before, %d after" % (len(before), len(after))
    for (x, element, command), (y, _, _) in zip(before, after):
        if (x is None) != (y is None) or (x and min(RANK[x], 3) > RANK[y]) or (x == "corner" and y != "corner"):
            yield "element '%s', command %d: %s before, %s after" % (element, command, x, y)
        sums["lost"] += x == "G2" and y == "G1"
    if sums is not None and report["lost"] is not None:
        sums["lost_said"] += len(report["lost"])
    if done.returncode == 0 and count(after, "kink"):
        yield "exit code 0 with %d kinks" % count(after, "kink")
    second = run(program, "repair", repaired, "-o", again, "--json", *options)
    with open(repaired, "rb") as f, open(again, "rb") as g:
        if second.returncode not in (0, 1) or f.read() != g.read():
            yield "repaired again, it changes"
    sums["drawings"] += 1
    sums["joins"] += len(before)
    sums["kinks before"] += count(before, "kink")
    sums["kinks after"] += count(after, "kink")
    sums["moves"] += len(report["moves"])
    sums["largest move"] = max(sums["largest move"], report["largest_move"][1])


if __name__ == "__main__":
    names = ("drawings", "refused", "joins", "kinks before", "kinks after", "moves", "lost", "lost_said", "largest move")
    main(r"\.svgz?$", names, check)
