#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Deletes every entity of CAD models in turn: `verify` must not say that all is proved unless what is left is whole.

delete_entities.py PROGRAM MODEL...

Models whose names end in _apart are sewn. Whole is a model with as many faces and edges of each kind as before, of which all was proved before.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

KINDS = ("faces", "inner", "seam", "boundary", "non_manifold", "degenerate", "knot_lines")


def verify(program, model):
    """Returns the exit code, and how many faces and edges of each kind there are."""
    command = [program, "verify", model, "--require", "G1", "--json", "--time-limit", "20"]
    if "_apart" in model:
        command += ["--sew", "0.001"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        return run.returncode, None
    summary = json.loads(run.stdout)["summary"]
    return run.returncode, [summary[kind] for kind in KINDS]


def of_step(text):
    """Yields for each entity what it is, and the text without it."""
    for match in re.finditer(r"^#\d+ *=[^;]*;\n", text, re.MULTILINE):
        yield match.group().split("(")[0], text[: match.start()] + text[match.end() :]


def of_iges(text):
    """An entity becomes one of no type or of an unknown one, or its lines are deleted."""
    lines = text.splitlines(keepends=True)
    section = lambda letter: [i for i, line in enumerate(lines) if len(line) > 72 and line[72] == letter]
    directory, parameters = section("D"), section("P")
    for first, second in zip(directory[::2], directory[1::2]):
        number = lines[first][73:80].strip()
        own = [i for i in parameters if lines[i][64:72].strip() == number]
        name = "D" + number + " of type " + lines[first][:8].strip()
        for new_type in ("0", "999"):
            changed = list(lines)
            for i in (first, second):
                changed[i] = new_type.rjust(8) + lines[i][8:]
            kept = lines[own[0]][:64]
            end = min(i for i in (kept.find(","), kept.find(";"), len(kept)) if i >= 0)
            changed[own[0]] = (new_type + kept[end:]).ljust(64)[:64] + lines[own[0]][64:]
            yield name + " as " + new_type, "".join(changed)
        gone = {first, second, *own}
        yield name, "".join(line for i, line in enumerate(lines) if i not in gone)


def of_brep(text):
    """Deletes each curve, surface and shape, with and without its number in the count, and each place where a shape is used."""
    lines = text.splitlines(keepends=True)
    heads = [i for i, line in enumerate(lines) if re.fullmatch(r"(Curve2ds|Curves|Surfaces|TShapes) \d+\n", line)]
    for head in heads:
        word, count = lines[head].split()
        end = next(
            (i for i in range(head + 1, len(lines)) if re.match(r"[A-Z][A-Za-z0-9]+ \d+$|^\+\d+ \d+ *$", lines[i])),
            len(lines),
        )
        if word == "TShapes":
            ends = [i + 1 for i in range(head, end) if lines[i].rstrip().endswith("*")]
            begins = [head + 1] + ends[:-1]
        else:
            begins = list(range(head + 1, end))
            ends = [i + 1 for i in begins]
        for number, (begin, stop) in enumerate(zip(begins, ends)):
            rest = lines[:begin] + lines[stop:]
            yield f"{word} {number}", "".join(rest)
            rest[head] = f"{word} {int(count) - 1}\n"
            yield f"{word} {number} and its number", "".join(rest)
            if word != "TShapes":
                continue
            uses = list(re.finditer(r"[+-]\d+ \d+ ", lines[stop - 1]))
            for use in uses:
                changed = list(lines)
                changed[stop - 1] = lines[stop - 1][: use.start()] + lines[stop - 1][use.end() :]
                yield f"{use.group()}of {word} {number}", "".join(changed)


def check(program, model):
    with open(model, encoding="latin-1", newline="") as file:
        text = file.read()
    suffix = os.path.splitext(model)[1]
    variants = {".step": of_step, ".igs": of_iges, ".brep": of_brep}[suffix](text)
    code, counts = verify(program, model)
    failures = []
    with tempfile.TemporaryDirectory() as folder:

        def run(numbered):
            number, (name, changed) = numbered
            file = os.path.join(folder, f"{number}{'_apart' if '_apart' in model else ''}{suffix}")
            with open(file, "w", encoding="latin-1", newline="") as out:
                out.write(changed)
            result = verify(program, file)
            os.remove(file)
            return name, result

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            results = list(pool.map(run, enumerate(variants)))
    for name, (new_code, new_counts) in results:
        if new_code not in (0, 1, 2):
            failures.append(f"{model} without {name}: exit code {new_code}")
        elif new_code == 0 and (code != 0 or new_counts != counts):
            failures.append(f"{model} without {name}: all is said to be proved, of {new_counts} instead of {counts}")
    proved = sum(new_code == 0 for _, (new_code, _) in results)
    print(f"{model}: {len(results)} deletions, {proved} that leave it whole, {len(failures)} wrong")
    return failures


def main():
    failures = [failure for model in sys.argv[2:] for failure in check(sys.argv[1], model)]
    print("\n".join(failures))
    sys.exit(1 if failures or len(sys.argv) < 3 else 0)


if __name__ == "__main__":
    main()
