#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Writes the files and records of the suite from exact data:  generate.py [FOLDER]

Every verdict that stands beside a case in curves.py, drawings.py, ... is compared with what truth.py computes. With --check nothing is
written, and the files of the folder must be the same."""

import hashlib
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))

import cad  # noqa: E402
import curves  # noqa: E402
import drawings  # noqa: E402
import fonts  # noqa: E402
import roads  # noqa: E402
import step  # noqa: E402
import surfaces  # noqa: E402
from chains import chain_joins  # noqa: E402
from truth import exact, is_decimal, ladder, name, text  # noqa: E402

VERSION = 2
QUANTITIES = ("gap", "angle_degrees", "curvature_percent", "torsion_jump")


def worst(joins, letter):
    return min(joins, key=lambda j: {"C": j.c, "G": j.traced, "F": j.f}[letter])


def numbers_of(chain):
    return [x for c in chain for x in [y for p in c.points for y in p] + c.knots + (c.weights or [])]


def as_json(chain, closed):
    """Curves by their control points."""
    lines = []
    for c in chain:
        line = {"degree": c.degree, "points": [[text(x) for x in p] for p in c.points]}
        if not c.is_bezier:
            line["knots"] = [text(t) for t in c.knots]
        if c.weights:
            line["weights"] = [text(w) for w in c.weights]
        lines.append("  " + json.dumps(line))
    return '{"curves": [\n' + ",\n".join(lines) + f'\n ], "closed": {json.dumps(closed)}' + "}\n"


def as_g2(chain):
    """The text format of SINTEF, class 100."""
    lines = []
    for c in chain:
        lines += ["100 1 0 0", f"{len(c.points[0])} {1 if c.weights else 0}", f"{len(c.points)} {c.degree + 1}", " ".join(map(text, c.knots))]
        for i, p in enumerate(c.points):
            w = c.weights[i] if c.weights else None
            lines.append(" ".join(text(x) for x in ([x * w for x in p] + [w] if w else p)))
    return "\n".join(lines) + "\n"


def as_svg(chain, closed):
    """One path. None if it cannot hold the curves."""
    if any(len(c.points[0]) != 2 or c.weights or c.degree > 3 or not c.is_bezier for c in chain):
        return None
    at, d = chain[0].points[0], "M" + ",".join(map(text, chain[0].points[0]))
    for c in chain:
        if c.points[0] != at:
            return None
        at = c.points[-1]
        d += " " + "LQC"[c.degree - 1] + " ".join(",".join(map(text, p)) for p in c.points[1:])
    if closed and at != chain[0].points[0]:
        return None
    return f'<svg xmlns="http://www.w3.org/2000/svg"><path fill="none" d="{d}{"Z" if closed else ""}"/></svg>\n'


class Suite:
    def __init__(self):
        self.records, self.files, self.problems = [], {}, []

    def write(self, record, extension, content):
        path = f"data/{record['id']}.{extension}"
        assert path not in self.files, path
        self.files[path] = content.encode() if isinstance(content, str) else content
        record["files"][extension] = path

    def add(self, id, subject, question, why, chain, expect, up_to, within=None, closed=False, only=None, files=None):
        """A chain of curves. `files` are those of another format that hold the same curves, by their extension."""
        joins = chain_joins(chain, closed)
        join = worst(joins, up_to[0])
        measures = join.measures()
        record = {"id": id, "subject": subject, "question": question, "up_to": up_to}
        if within:
            reached = ladder({k: self.largest(joins, k) for k in measures}, within)
            reached = None if reached is None else name(min(reached, 2))
        else:
            most = int(up_to[1])
            reached = name(min({"C": join.c, "G": join.traced, "F": join.f}[up_to[0]], most))
            if reached != "gap":
                reached = ("F" if reached == "G3" and up_to == "F3" else "C" if up_to[0] == "C" else "G") + reached[1]
        if reached != ("G3" if expect == "F3" and up_to != "F3" else expect):
            self.problems.append(f"{id}: {expect} expected, {reached} computed; {measures}")
        record["order"] = reached
        if within:
            record["within"] = within
        record.update({"g_order": join.traced, "f_order": join.f})
        if subject == "curve":  # what is drawn has no parameters
            record.update({"c_order": join.c, "betas": [text(b) for b in join.betas]})
        if join.stops:
            record["stops"] = True
        record.update(measures)
        if up_to[0] == "C":
            record["derivative_jumps"] = join.derivative_jumps()
        self.finish(record, why, within, measures if not within else {k: self.largest(joins, k) for k in measures}, closed)
        decimals = all(map(is_decimal, numbers_of(chain)))
        formats = (only,) if isinstance(only, str) else only or ("json", "g2", "svg", "step")
        if files:
            for extension, content in files.items():
                self.write(record, extension, content)
            return
        if "json" in formats:
            self.write(record, "json", as_json(chain, closed))
        if "g2" in formats and decimals:
            self.write(record, "g2", as_g2(chain))
        if "svg" in formats and decimals and question != "C orders" and not within and (svg := as_svg(chain, closed)):
            self.write(record, "svg", svg)
        if "step" in formats and decimals:
            self.write(record, "step", step.curves(id, chain))

    def record(self, id, subject, question, why, order, up_to, measures, files, **more):
        """A record whose order and sizes come from its own module."""
        record = {"id": id, "subject": subject, "question": question, "up_to": up_to, "order": order}
        record.update(more)
        record.update(measures)
        self.finish(record, why, more.get("within"), measures)
        for extension, content in files.items():
            self.write(record, extension, content)

    @staticmethod
    def largest(joins, key):
        values = [j.measures()[key] for j in joins]
        if any(v is None for v in values):
            return None
        return max(values, key=lambda v: exact(v[0]))

    def finish(self, record, why, within, measures, closed=False):
        """Writes down what flips the answer, and why it is as it is."""
        order = record["order"]
        level = -1 if order == "gap" else int(order[1])
        flips = None
        if within:
            given = [(k, v) for k, v in within.items() if exact(v) or level < 2]
            names = (("gap",), ("angle_degrees", "angle_radians", "slope_jump"), ("curvature_percent", "curvature_jump", "second_jump"))
            if level < 2 and level < int(record["up_to"][1]):
                key = next((k for k in names[level + 1] if k in within), names[level + 1][0])
                flips = key if measures.get(key) else None
            elif given:
                ratio = lambda kv: exact(measures[kv[0]][1]) / exact(kv[1]) if exact(kv[1]) else 0
                flips = max(given, key=ratio)[0]
        elif record["up_to"][0] != "C" and level < 3 and f"{level}" != record["up_to"][1]:
            flips = QUANTITIES[level + 1]
            if level == 2 and not measures.get("torsion_jump") or level < 2 and not measures.get(flips):
                flips = None
        if flips and measures.get(flips) and (within or exact(measures[flips][1])):
            record["flips"] = {"tolerance": flips, "at": measures[flips]}
        else:
            record["flips"] = None
        if closed:
            record["closed"] = True
        record["why"] = why
        record["files"] = {}
        self.records.append(record)


def main(arguments):
    check = "--check" in arguments
    folder = Path(next((a for a in arguments if a != "--check"), Path(__file__).parent.parent))
    suite = Suite()
    for module in (curves, drawings, fonts, surfaces, cad, roads):
        module.cases(suite)
    if suite.problems:
        print("\n".join(suite.problems))
        return 1
    groups = {}
    for r in suite.records:
        groups.setdefault(r["id"].split("/")[0], []).append(json.dumps(r))
    for group, lines in groups.items():
        suite.files[f"records/{group}.jsonl"] = ("\n".join(lines) + "\n").encode()
    suite.files["records/SHA256SUMS"] = "".join(f"{hashlib.sha256(c).hexdigest()}  {p}\n" for p, c in sorted(suite.files.items()) if p.startswith("data/")).encode()
    suite.files["records/VERSION"] = f"{VERSION}\n".encode()
    present = {str(p.relative_to(folder)) for top in ("data", "records") for p in (folder / top).rglob("*") if p.is_file()}
    wrong = sorted(present - set(suite.files))
    for path, content in suite.files.items():
        target = folder / path
        if not target.is_file() or target.read_bytes() != content:
            wrong.append(path)
            if not check:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
    if not check:
        for path in present - set(suite.files):
            (folder / path).unlink()
    print(f"{len(suite.records)} records, {len(suite.files) - len(groups) - 2} files, {sum(map(len, suite.files.values())) // 1024} KiB" +
          ("".join(f"\ndiffers: {p}" for p in wrong) if check else ""))
    return 1 if check and wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
