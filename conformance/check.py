#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Reads each file of the suite and decides it anew, in fractions:  check.py [ID...]

It shares nothing with the generator, neither readers nor formulas: derivatives come from differences of control points, orders from forms
without division, and enclosures are verified by the squares, sines and cosines of their bounds. A record is refused when one file says
something else. With names, only records whose names begin so are checked."""

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


def check(record):
    """The problems of a record."""
    problems = []
    if not record["files"]:
        problems.append("no file")
    for extension, path in record["files"].items():
        data = (HERE / path).read_bytes()
        try:
            if record["subject"] == "road":
                roads.check(record, data)
            elif record["subject"] == "variable font":
                fonts.check_variable(record, data)
                joins.verify_flip(record)
            elif record["subject"] in ("surface", "cad", "model"):
                edges.check(record, extension, data)
            else:
                chains = fonts.read(data) if record["subject"] == "font" else read_chains(extension, data)
                joins.check(record, extension, chains)
        except (joins.Wrong, ArithmeticError, LookupError, TypeError, ValueError) as error:
            problems.append(f"{path}: {error or type(error).__name__}")
    return problems


def main(names):
    count = files = wrong = 0
    version = (HERE / "records/VERSION").read_text().strip()
    for path in sorted((HERE / "records").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            record = json.loads(line)
            if names and not record["id"].startswith(tuple(names)):
                continue
            count += 1
            files += len(record["files"])
            problems = check(record)
            wrong += bool(problems)
            for problem in problems:
                print(f"{record['id']}: {problem}")
    print(f"version {version}: {count - wrong} records confirmed, {wrong} refused, {files} files")
    return 1 if wrong or not count else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
