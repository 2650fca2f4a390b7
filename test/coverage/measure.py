#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Tells which lines and branches of the headers the unit tests and the exact cases reach, by clang's source-based coverage:

    measure.py [--build FOLDER] [--jobs N] [--tests PATTERN] [--list FILE] [--manual]

It builds the unit tests, those of the program's readers among them, with clang++, runs them, and prints a table of the modules; FILE receives what is
not reached and not explained. A line or a side of a branch is reached if it is so in any instance of its template. Conditions that the compiler knows are no branches. What no test instantiates
has neither lines nor branches, and is not seen. It takes an hour or so on two cores: call it by nice. With a regular expression only the programs are built and
run in whose names it is found. FOLDER keeps what each has reached: it is not run again before it changes. --manual puts the table into the manual.

A mark above a line, `// unreachable: REASON`, explains what no test reaches: the sides of the
branches on this line, and the line itself and those after it as far as none of them is reached.
Where all tests have run, a mark at a line that is reached is an error."""

import argparse
import collections
import concurrent.futures
import json
import os
import pickle
import re
import shlex
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from marks import marks  # noqa: E402

root = Path(__file__).resolve().parents[2]
manual = root / "doc/Geometric_continuity/What_the_program_promises.txt"
prefix = str(root / "include" / "CGAL" / "Geometric_continuity") + os.sep
CODE, BRANCH = 0, 4  # kinds of regions


def build(folder, jobs, pattern):
    """Builds the programs in whose names the pattern is found; returns the names of the tests and their commands."""
    # atomic: tests on several cores would lose counts, and a side that is the difference of two
    # counts would seem to be reached
    flags = "-fprofile-instr-generate -fprofile-update=atomic -fcoverage-mapping"  # which clang does not apply to what comes from precompiled headers
    options = ["-DCMAKE_CXX_COMPILER=clang++", f"-DCMAKE_CXX_FLAGS={flags}", "-DGEOMETRIC_CONTINUITY_PRECOMPILE_PACKAGE=OFF"]
    subprocess.run(["cmake", "-G", "Unix Makefiles", "-S", root, "-B", folder, *options], check=True, stdout=subprocess.DEVNULL)
    folders = [folder / "test" / "Geometric_continuity", folder / "test" / "tools"]
    listed = "".join((tests / "CTestTestfile.cmake").read_text() for tests in folders)  # CTest itself tells the commands of what is built only
    known = re.findall(r"^add_test\((?:\[=+\[)?([^\]\s]+)(?:\]=+\])? (.*)\)$", listed, re.M)
    chosen = [(name, shlex.split(command)) for name, command in known if re.search(pattern, name)]
    chosen = [(name, command) for name, command in chosen if Path(command[0]).parent in folders]
    subprocess.run(["make", "-C", folder, f"-j{jobs}", *{Path(command[0]).name for _, command in chosen}], check=True, stdout=subprocess.DEVNULL)
    return chosen


def line_counts(name, segments):
    """How often each line with code is reached, from the segments of a file: [line, column, count, has a count, begins a region, is a gap]."""
    code = [re.match(r"\s*(//|#|$)", text) is None for text in Path(name).read_text().splitlines()]
    starts = collections.defaultdict(list)
    for segment in segments:
        starts[segment[0]].append(segment)
    wrapping, counts = None, {}
    for line in range(segments[0][0], segments[-1][0] + 1):
        here = starts[line]
        begun = [s[2] for s in here if s[3] and s[4] and not s[5]]
        skipped = here and not here[0][3] and here[0][4]
        wrapped = wrapping[2] if wrapping and wrapping[3] else None
        if code[line - 1] and not skipped and (begun or wrapped is not None):
            counts[line] = max([wrapped or 0, *begun])
        wrapping = here[-1] if here else wrapping
    return counts


def lines_of_instances(functions, lines):
    """Which of the lines that are not reached, by the file, are reached in an instance of a template: the regions of one hide those of another."""
    open_lines = collections.defaultdict(list)
    for name, line in (place for place, is_reached in lines.items() if not is_reached):
        open_lines[name].append(line)
    texts = {name: Path(name).read_text().splitlines() for name in open_lines}
    found = set()
    for function in functions:
        name = function["filenames"][0]
        regions = [r for r in function["regions"] if r[7] == CODE and r[5] == 0]
        if name not in open_lines or not regions or function["count"] == 0:
            continue
        first, last = regions[0][0], regions[0][2]
        for line in open_lines[name]:
            if first <= line <= last:
                text = texts[name][line - 1]
                place = [line, len(text) - len(text.lstrip()) + 1]
                around = [r for r in regions if r[:2] <= place < r[2:4]]
                begun = [r[4] for r in regions if r[0] == line]
                if (around and max(around, key=lambda r: r[:2])[4] > 0) or any(begun):
                    found.add((name, line))
    return found


def sides(function):
    """For each branch of an instance of a function in the headers: its place, and whether it was true and false. None for known conditions."""
    regions = [r for r in function["regions"] if r[7] == CODE]
    for branch in function["branches"]:
        begin, end, name = branch[:2], branch[2:4], function["filenames"][branch[6]]
        if not name.startswith(prefix):
            continue
        around = [r for r in regions if r[5] == branch[6] and r[:2] <= begin and end <= r[2:4]]
        is_reached = max(around, key=lambda r: r[:2])[4] > 0 if around else False
        if not (is_reached and branch[4] == branch[5] == 0):
            yield (name, *begin), branch[4] > 0, branch[5] > 0


def run(name, command, folder):
    """Runs a test; returns which lines it reaches, and which sides of branches."""
    raw, merged, kept = (folder / f"{name}.{end}" for end in ("profraw", "profdata", "reached"))
    if kept.exists() and kept.stat().st_mtime > Path(command[0]).stat().st_mtime:
        return pickle.loads(kept.read_bytes())
    result = subprocess.run(command, cwd=folder, env={**os.environ, "LLVM_PROFILE_FILE": str(raw)}, capture_output=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"{name} fails:\n{result.stdout.decode()}{result.stderr.decode()}")
    subprocess.run(["llvm-profdata", "merge", "-sparse", raw, "-o", merged], check=True)
    export = ["llvm-cov", "export", "-instr-profile", merged, command[0]]
    found = json.loads(subprocess.run(export, check=True, capture_output=True).stdout)["data"][0]
    lines, branches = {}, {}
    for file in found["files"]:
        if file["filename"].startswith(prefix) and file["segments"]:
            for line, count in line_counts(file["filename"], file["segments"]).items():
                lines[file["filename"], line] = count > 0
    lines.update(dict.fromkeys(lines_of_instances(found["functions"], lines), True))
    for function in found["functions"]:
        for place, is_true, is_false in sides(function):
            old = branches.get(place, (False, False))
            branches[place] = (old[0] or is_true, old[1] or is_false)
    raw.unlink()
    merged.unlink()
    kept.write_bytes(pickle.dumps((lines, branches)))
    return lines, branches


def explained(lines, branches, complete):
    """The lines and the sides of branches that marks are about: (name, line), and (name, line, column)."""
    comments = collections.defaultdict(set)
    left_lines, left_branches, wrong = set(), set(), []
    open_branches = collections.defaultdict(list)
    for (name, line, column), both in branches.items():
        if lines.get((name, line), True) and not all(both):
            open_branches[name, line].append((name, line, column))
    headers = {name for name, *_ in [*lines, *branches]}
    for header in headers:
        for number, text in enumerate(Path(header).read_text().splitlines(), 1):
            if text.lstrip().startswith("//"):
                comments[header].add(number)
    for name in headers:
        for line, _ in marks(Path(name).read_text().splitlines(), "unreachable"):
            here_open = set(open_branches[name, line])
            run = line
            while lines.get((name, run)) is False or (run > line and run in comments[name]):
                left_lines.add((name, run))
                run += 1
            left_branches |= here_open
            if complete and run == line and not here_open:
                wrong.append(f"{name}:{line}")
    if wrong:
        sys.exit("\n".join(["marked as unreachable, but reached:", *wrong]))
    return left_lines, left_branches


def write_manual(rows):
    text = manual.read_text()
    head = re.search(r"^\| Module \| Lines .*\n\|.*\n", text, re.M)
    rest = re.compile(r"(?:\|.*\n)*").match(text, head.end())
    manual.write_text(text[: head.end()] + "\n".join(rows) + "\n" + text[rest.end() :])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, default=root / "build" / "coverage")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--tests", default="", help="only those in whose names this regular expression is found")
    parser.add_argument("--list", type=Path, help="write what is neither reached nor explained to this file")
    parser.add_argument("--manual", action="store_true")
    options = parser.parse_args()
    folder = options.build.resolve()
    tests = build(folder, options.jobs, options.tests)
    lines, branches = {}, {}
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for reached, seen in pool.map(lambda test: run(*test, folder), tests):
            for place, is_reached in reached.items():
                lines[place] = lines.get(place, False) or is_reached
            for place, (is_true, is_false) in seen.items():
                old = branches.get(place, (False, False))
                branches[place] = (old[0] or is_true, old[1] or is_false)

    of_lines, of_branches = explained(lines, branches, not options.tests)
    modules = collections.defaultdict(lambda: [0] * 6)  # lines: all, reached, explained; sides
    for place, is_reached in lines.items():
        for module in (place[0][len(prefix) :].split(os.sep)[0], "all"):
            for k, x in enumerate((1, is_reached, place in of_lines)):
                modules[module][k] += x
    left = [(*place, "not reached") for place, is_reached in lines.items() if not is_reached and place not in of_lines]
    for place, both in branches.items():
        name, line, column = place
        is_line_reached = lines.get((name, line), True)
        is_explained = place in of_branches or (name, line) in of_lines
        for module in (name[len(prefix) :].split(os.sep)[0], "all"):
            for k, x in enumerate((2, sum(both), (2 - sum(both)) * is_explained)):
                modules[module][3 + k] += x
        if is_line_reached and not all(both) and not is_explained:
            left.append((name, line, f"column {column} never {' nor '.join(w for w, seen in zip(('true', 'false'), both) if not seen)}"))
    rows = []
    print(f"{'module':12}{'lines':>8}{'reached':>9}{'explained':>11}{'open':>6}{'sides':>8}{'reached':>9}{'explained':>11}{'open':>6}")
    for module, counts in sorted(modules.items(), key=lambda r: (r[0] == "all", r[0])):
        row, cells = f"{module:12}", [module if module == "all" else f"`{module}`"]
        for known, reached, reasons in (counts[:3], counts[3:]):
            percent = f"{100 * reached / max(known, 1):.2f} %" if known else "-"
            row += f"{known:8}{percent:>9}{reasons:11}{known - reached - reasons:6}"
            cells += [str(known), percent, str(reasons), str(known - reached - reasons)]
        print(row)
        rows.append(f"| {' | '.join(cells)} |")
    if options.list:
        options.list.write_text("".join(f"{name[len(prefix) :]}:{line}: {text}\n" for name, line, text in sorted(left)))
    if options.manual:
        write_manual(rows)
    return 1 if left else 0


sys.exit(main())
