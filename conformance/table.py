#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes the table of results/ as Markdown:  table.py [--check PAGE]

With --check the page must have each of its lines."""

import json
import sys
from pathlib import Path

from run import CATEGORIES, QUESTIONS, badness, records

HERE = Path(__file__).resolve().parent

def rows():
    known = {r["id"]: r for r in records()}
    head = ["System", "Asked"] + list(QUESTIONS) + ["Worst"]
    yield "| " + " | ".join(head) + " |"
    yield "| :--- | ---: |" + " ---: |" * len(QUESTIONS) + " :--- |"
    for path in sorted((HERE / "results").glob("*.json")):
        result = json.loads(path.read_text(encoding="utf-8"))
        cells, worst = [], None
        for question in QUESTIONS:
            answers = [a for a in result["answers"] if known[a["id"]]["question"] == question]
            counts = [sum(a["category"] == c for a in answers) for c in CATEGORIES[:5]]
            cells.append("/".join(map(str, counts)) if answers else "–")
        for a in result["answers"]:
            r = known[a["id"]]
            if a["category"] in ("false smooth", "false kink"):
                size = (a["category"] == "false smooth", *badness({"quantity": (r["flips"] or {}).get("tolerance"), "measure": (r["flips"] or {}).get("at", [None])[0]}))
                if worst is None or size > worst[0]:
                    worst = (size, f"`{a['id']}`: {r['order']}, said {a['answer'].split()[0]}")
        yield f"| {result['system']} {result['version'].split()[-1] if result['version'] else ''}".rstrip() + f" | {len(result['answers'])} | " + " | ".join(cells) + f" | {worst[1] if worst else '–'} |"


def main(arguments):
    lines = list(rows())
    if arguments[:1] == ["--check"]:
        page = Path(arguments[1]).read_text(encoding="utf-8").splitlines()
        missing = [line for line in lines if line not in page]
        print("\n".join(["The page does not have these lines of results/:"] + missing) if missing else "The page has the table of results/.")
        return 1 if missing else 0
    print("\n".join(lines))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
