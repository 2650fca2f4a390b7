#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Alters records and files at random, one thing at a time, and asks check.py about each:  test_check.py [SEED [COUNT]]

An altered record must be refused. What is not checked is `question` and `why`, and in `up_to` and `within` what leaves the answer as it is:
another question about the same file, whose answer is as true. COUNT is how many records are altered for each sort of key and group of records."""

import json
import random
import re
import sys
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True

import check  # noqa: E402

HERE = Path(__file__).parent
SIZES = ("gap", "angle_degrees", "angle_radians", "curvature_jump", "curvature_percent", "torsion_jump", "slope_jump", "second_jump")
LEVELS = (("gap",), ("angle_degrees", "angle_radians", "slope_jump"), ("curvature_percent", "curvature_jump", "second_jump"))


def number(text):
    return Fraction(text) if "/" in text else Fraction(Decimal(text))


def scaled(text, factor):
    return str(Decimal(text) * Decimal(factor)) if "/" not in text else str(Fraction(text) * Fraction(factor))


def other_orders(record):
    names = ["gap"] + [record["up_to"][0] + str(k) for k in range(4)] + ["F3", "G3"]
    return [n for n in dict.fromkeys(names) if n != record["order"]]


def alterations(record):
    """{sort: function of a random source that returns an altered record}"""
    def with_value(**values):
        return {**record, **values}
    found = {"order": lambda r: with_value(order=r.choice(other_orders(record)))}
    for key in ("c_order", "g_order", "f_order"):
        if key in record:
            found[key] = lambda r, key=key: with_value(**{key: r.choice([k for k in range(-1, 4) if k != record[key]])})
    if record.get("betas"):
        def beta(r):
            betas = list(record["betas"])
            k = r.randrange(len(betas))
            betas[k] = str(number(betas[k]) + Fraction(1, 10 ** r.randrange(1, 30)))
            return with_value(betas=betas)
        found["a shape parameter"] = beta
        found["fewer shape parameters"] = lambda r: with_value(betas=record["betas"][:-1])
    if "betas" in record:
        found["more shape parameters"] = lambda r: with_value(betas=record["betas"] + ["0"])
        found["stops"] = lambda r: {**{k: v for k, v in record.items() if k != "stops"}, **({} if record.get("stops") else {"stops": True})}
    for key in SIZES:
        pair = record.get(key)
        if key in record:
            found[key + ", defined"] = lambda r, key=key, pair=pair: with_value(**{key: ["0", "0"] if pair is None else None})
        if pair:
            zero = number(pair[1]) == 0
            found[key + ", too large"] = lambda r, key=key, pair=pair, zero=zero: with_value(**{key: ["1e-30", "1e-29"] if zero else [scaled(x, 1 + 10 ** -Decimal(r.randrange(1, 8))) for x in pair]})
            if not zero:
                found[key + ", too small"] = lambda r, key=key, pair=pair: with_value(**{key: [scaled(x, 1 - 10 ** -Decimal(r.randrange(1, 8))) for x in pair]})
                found[key + ", zero"] = lambda r, key=key: with_value(**{key: ["0", "0"]})
            found[key + ", wide"] = lambda r, key=key, pair=pair, zero=zero: with_value(**{key: ["0", "0.1"] if zero else [scaled(pair[0], "0.9"), scaled(pair[1], "1.1")]})
            if not zero:
                found[key + ", the bounds exchanged"] = lambda r, key=key, pair=pair: with_value(**{key: [scaled(pair[1], "1.1"), pair[0]]})
    if "derivative_jumps" in record:
        def derivative(r):
            jumps = [list(p) for p in record["derivative_jumps"]]
            k = r.randrange(len(jumps))
            jumps[k] = ["0", "0"] if number(jumps[k][1]) else ["0.5", "0.5"]
            return with_value(derivative_jumps=jumps)
        found["derivative_jumps"] = derivative
        found["fewer derivative_jumps"] = lambda r: with_value(derivative_jumps=record["derivative_jumps"][:-1])
    flips = record["flips"]
    if flips:
        found["flips, nothing"] = lambda r: with_value(flips=None)
        found["flips, another size"] = lambda r: with_value(flips={**flips, "at": ["0.123", "0.123"]})
        found["flips, another tolerance"] = lambda r: with_value(flips={**flips, "tolerance": r.choice([k for k in SIZES if k != flips["tolerance"]])})
    else:
        found["flips, something"] = lambda r: with_value(flips={"tolerance": "gap", "at": record["gap"]})
    if "within" in record:
        # The tolerance that decides, moved to the other side of the size.
        level = -1 if record["order"] == "gap" else int(record["order"][1])

        def tolerance(r):
            within = dict(record["within"])
            choices = []
            for k, names in enumerate(LEVELS):
                key = next((n for n in names if n in within), None)
                if key and record.get(key) and k <= level and number(record[key][0]) > 0:
                    choices.append((key, scaled(record[key][0], "0.999")))  # it held
                elif key and record.get(key) and k == level + 1:
                    choices.append((key, scaled(record[key][1], "1.001")))  # it failed
            if not choices:
                return None
            key, value = r.choice(choices)
            within[key] = value
            return with_value(within=within)
        found["within"] = tolerance
    if int(record["up_to"][1]) > 0 and record["order"] != "gap" and int(record["order"][1]) > 0:
        found["up_to, below the order"] = lambda r: with_value(up_to=record["up_to"][0] + str(int(record["order"][1]) - 1))
    if "edges" in record:
        found["edges"] = lambda r: with_value(edges=record["edges"] + 1)
    if "closed" in record:
        found["closed"] = lambda r: {k: v for k, v in record.items() if k != "closed"}
    for key, values in (("subject", ("curve", "drawing", "font", "variable font", "surface", "cad", "road")), ("section", ("extruded", "rotated", "full", "cone", "apart")),
                        ("road", ("plan", "link", "lanes", "elevation", "width", "laneOffset")), ("unit", ("mm", "m", "cm", "inch", "um")), ("placed", ("mapped", "part", "placement"))):
        if key in record:
            found[key] = lambda r, key=key, values=values: with_value(**{key: r.choice([v for v in values if v != record[key]])})
    if "mirrored" in record:
        found["mirrored"] = lambda r: with_value(mirrored=not record["mirrored"])
    if "scale" in record:
        found["scale"] = lambda r: with_value(scale=str(number(record["scale"]) * 2))
    found["files, none"] = lambda r: with_value(files={})
    return found


def altered_file(record, source, formats):
    """One digit of one number in a file: the file and its bytes."""
    extension = source.choice(formats)
    path = record["files"][extension]
    data = (HERE / path).read_bytes()
    if extension in ("ttf", "otf"):
        at = source.randrange(len(data))
        return path, data[:at] + bytes([data[at] ^ (1 << source.randrange(8))]) + data[at + 1 :]
    # In JSON a number that counts: no digit of an exponent's zero, and no zero behind the point.
    at = source.choice([m.start() for m in re.finditer(rb"[1-9]", data)])
    digit = source.choice([d for d in b"0123456789" if d != data[at]])
    return path, data[:at] + bytes([digit]) + data[at + 1 :]


def main(arguments):
    seed = int(arguments[0]) if arguments else 62
    count = int(arguments[1]) if len(arguments) > 1 else 1
    print(f"seed {seed}")
    source = random.Random(seed)
    sorts = {}
    for path in sorted((HERE / "records").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            record = json.loads(line)
            for sort in alterations(record):
                sorts.setdefault((path.stem, sort), []).append(record)
            sorts.setdefault((path.stem, "a file"), []).append(record)
            if "json" in record["files"] and len(record["files"]) > 1:
                sorts.setdefault((path.stem, "control points"), []).append(record)
    digests, asked, accepted = check.sums(), 0, 0
    for (group, sort), records in sorts.items():
        for record in source.sample(records, min(count, len(records))):
            contents, compared = None, digests
            if sort in ("a file", "control points"):
                # Control points are found without the sums: the files of a record tell the same.
                formats = sorted(record["files"]) if sort == "a file" else ["json"]
                name, content = altered_file(record, source, formats)
                contents, altered = {name: content}, record
                compared = digests if sort == "a file" else None
            else:
                altered = alterations(record)[sort](source)
            if altered is None:
                continue
            asked += 1
            if not check.check(altered, compared, contents):
                accepted += 1
                print(f"accepted: {record['id']}, {sort}: " + json.dumps({k: v for k, v in altered.items() if record.get(k) != v}))
    print(f"{asked} alterations, {accepted} accepted")
    return 1 if accepted or not asked else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
