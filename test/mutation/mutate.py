#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Alters one token of a header at a time, and lists the alterations that no test notices:

    mutate.py [--sample N] [--seed S] [--tests M] [--compiler "clang++ -O0 ..."] [PART_OF_A_PATH...]

An alteration is noticed when a test fails, does not end, or does not compile. For each, the M shortest unit tests are built that include the
header, by themselves before through others, one after the other until one notices it. Without paths all headers take part. It takes a
minute or so for each alteration: call it by nice."""

import argparse
import collections
import random
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(__file__).resolve().parents[2]
tests = root / "test" / "Geometric_continuity"
prefix = root / "include" / "CGAL" / "Geometric_continuity"

OTHERS = {"+": "-", "-": "+", "*": "+", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&"}
OTHERS |= {"+=": "-=", "-=": "+=", "*=": "+=", "min": "max", "max": "min", "true": "false", "false": "true", "!": "", "begin": "end", "lower": "upper"}
TOKEN = re.compile(
    r'(?P<skipped>//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|static_assert\s*\([^;]*;|template\s*<[^;{]*>)'
    r"|(?P<word>[A-Za-z_]\w*)|(?P<number>\d[\w.+]*)|(?P<operator>[-+*<>=!&|/]+)",
    re.M | re.S,
)


def alterations(text):
    """The places of tokens and what takes their places. Operators have spaces around them, as clang-format sets them: others are no operators of arithmetic."""
    for token in TOKEN.finditer(text):
        begin, end = token.span()
        if token["number"] and re.fullmatch(r"\d+", token.group()):
            yield begin, end, str(int(token.group()) + 1)
        elif token["word"] in OTHERS:
            yield begin, end, OTHERS[token.group()]
        elif token["operator"] in OTHERS:
            spaced = text[begin - 1 : begin].isspace() and text[end : end + 1].isspace()
            if spaced != (token.group() == "!"):
                yield begin, end, OTHERS[token.group()]


def includes(path):
    return re.findall(r'#include [<"](?:CGAL/Geometric_continuity/)?([\w/]+\.h)[>"]', path.read_text())


def tests_of_headers():
    """For each header the tests that include it, those that name it first, then the shorter ones."""
    direct = {str(h.relative_to(prefix)): [i for i in includes(h) if (prefix / i).exists()] for h in prefix.rglob("*.h")}
    support = {str(h.relative_to(tests)): includes(h) for h in (tests / "support").glob("*.h")}
    known = collections.defaultdict(list)
    for source in tests.glob("*/**/test_*.cpp"):
        named = set(includes(source))
        reached, open_ = set(), list(named)
        while open_:
            header = open_.pop()
            if header not in reached:
                reached.add(header)
                open_ += direct.get(header, []) + support.get(header, [])
        for header in reached & set(direct):
            known[header].append((header not in named, source.stat().st_size, source))
    return {header: [source for _, _, source in sorted(found)] for header, found in known.items()}


def notices(test, folder, compiler):
    """Tells how a test notices the header that lies in the folder; None if it does not."""
    program = folder / "program"
    main = folder / "main.cpp"
    main.write_text(f'#define BOOST_TEST_MODULE mutation\n#include <boost/test/included/unit_test.hpp>\n#include "{test}"\n')
    paths = [f"-I{folder}", f"-I{root / 'include'}", f"-I{tests}", f"-I{root / 'test'}"]
    command = [*shlex.split(compiler), *paths, str(main), "-o", str(program), "-lgmpxx", "-lmpfr", "-lgmp"]
    if subprocess.run(command, capture_output=True, check=False).returncode != 0:
        return "does not compile"
    try:
        code = subprocess.run([program], capture_output=True, timeout=300, check=False, cwd=folder).returncode
    except subprocess.TimeoutExpired:
        return "does not end"
    return None if code == 0 else "fails"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tests", type=int, default=2)
    parser.add_argument("--compiler", default="clang++ -std=c++17 -O0 -w -DCGAL_USE_GMPXX=1")
    parser.add_argument("paths", nargs="*")
    given = parser.parse_args()
    tests_of = tests_of_headers()
    mutants = []
    for header, sources in sorted(tests_of.items()):
        if not given.paths or any(part in header for part in given.paths):
            text = (prefix / header).read_text()
            mutants += [(header, *alteration, sources[: given.tests]) for alteration in alterations(text)]
    if not mutants:
        sys.exit("no header with these paths has anything to alter")
    random.Random(given.seed).shuffle(mutants)
    print(f"{min(given.sample, len(mutants))} of {len(mutants)} alterations", flush=True)
    for test in sorted({test for *_, sources in mutants[: given.sample] for test in sources}):
        with tempfile.TemporaryDirectory() as name:
            how = notices(test, Path(name), given.compiler)
        if how:
            sys.exit(f"{test} {how} without any alteration")
    counts, survivors = collections.Counter(), []
    for header, begin, end, other, sources in mutants[: given.sample]:
        text = (prefix / header).read_text()
        line = text.count("\n", 0, begin) + 1
        place = f"{header}:{line}: {text.splitlines()[line - 1].strip()}    [{text[begin:end]} -> {other or 'nothing'}]"
        with tempfile.TemporaryDirectory() as name:
            altered = Path(name) / "CGAL" / "Geometric_continuity" / header
            altered.parent.mkdir(parents=True)
            altered.write_text(text[:begin] + other + text[end:])
            how = next((found for found in (notices(test, Path(name), given.compiler) for test in sources) if found), None)
        counts[how or "lives"] += 1
        survivors += [] if how else [place]
        print(f"{how or 'LIVES'}: {place}", flush=True)
    print(", ".join(f"{count} {how}" for how, count in counts.most_common()))
    return 1 if survivors else 0


sys.exit(main())
