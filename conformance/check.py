#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Reads each file of the suite and decides it anew, in fractions:  check.py [ID...]

It shares nothing with the generator, neither readers nor formulas: derivatives come from differences of control points, orders from forms
without division, and enclosures are verified by the squares, sines and cosines of their bounds. A record is refused when one file says
something else, or when it is not the file of records/SHA256SUMS. With names, only records whose names begin so are checked."""

import hashlib
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent / "checker"))

import edges  # noqa: E402
import fonts  # noqa: E402
import joins  # noqa: E402
import roads  # noqa: E402
from read_curves import read_chains  # noqa: E402

HERE = Path(__file__).parent


def sums():
    """{file: its sum}"""
    lines = (HERE / "records/SHA256SUMS").read_text().splitlines()
    return {path: digest for digest, _, path in (line.partition("  ") for line in lines)}


def same_curves(formats):
    """All files of a chain have the same derivatives at all ends; formats are {extension: chains}."""
    jets = {e: [(a.jet, b.jet) for chain, _ in chains for a, b in chain] for e, chains in formats.items()}
    first = next(iter(jets))
    for extension, found in jets.items():
        joins.need(found == jets[first], f"other curves than in {first}: {extension}")


SUBJECTS = {"plane": ["curve"], "space": ["curve"], "rational": ["curve"], "spline": ["curve"], "drawing": ["drawing"], "font": ["font", "variable font"],
            "surface": ["surface"], "model": ["surface"], "cad": ["cad", "surface"], "road": ["road"]}


def check(record, digests=None, contents=None):
    """The problems of a record. `contents` are those of files that are not read; without `digests` they are not compared."""
    problems, formats = [], {}
    if not record["files"]:
        problems.append("no file")
    if record["subject"] not in SUBJECTS[record["id"].split("/")[0]]:
        problems.append("another subject")
    read = lambda path: (contents or {}).get(path) or (HERE / path).read_bytes()
    for extension, path in record["files"].items():
        data = read(path)
        if digests is not None and hashlib.sha256(data).hexdigest() != digests.get(path):
            problems.append(f"{path}: not the file of records/SHA256SUMS")
        try:
            if record["subject"] == "road":
                roads.check(record, data)
            elif record["subject"] == "variable font":
                fonts.check_variable(record, data)
                joins.verify_flip(record)
            elif record["subject"] in ("surface", "cad", "model"):
                edges.check(record, extension, data, read(record["files"]["json"]) if "json" in record["files"] else None)
            else:
                chains = fonts.read(data) if record["subject"] == "font" else read_chains(extension, data)
                joins.check(record, extension, chains)
                if record["subject"] == "curve":
                    formats[extension] = chains
                    same_curves(formats)
        except Exception as error:  # a damaged file or record, whatever it leads to
            problems.append(f"{path}: {error or type(error).__name__}")
    return problems


def main(names):
    count = files = wrong = 0
    digests = sums()
    version = (HERE / "records/VERSION").read_text().strip()
    for path in sorted((HERE / "records").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            record = json.loads(line)
            if names and not record["id"].startswith(tuple(names)):
                continue
            count += 1
            files += len(record["files"])
            problems = check(record, digests)
            wrong += bool(problems)
            for problem in problems:
                print(f"{record['id']}: {problem}")
    print(f"version {version}: {count - wrong} records confirmed, {wrong} refused, {files} files")
    return 1 if wrong or not count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
