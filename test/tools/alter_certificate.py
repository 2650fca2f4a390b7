#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks that no number of a certificate, nor of the file that it is about, can be another one without being noticed:

    alter_certificate.py CHECK_CERTIFICATE CERTIFICATE FILE

The certificate must be accepted as it is, and refused with each of its numbers changed, with each order, flag and line changed or left out,
and for each file with another number."""

import contextlib
import importlib.util
import io
import json
import re
import sys
from fractions import Fraction
from pathlib import Path

spec = importlib.util.spec_from_file_location("check_certificate", sys.argv[1])
checker = importlib.util.module_from_spec(spec)
spec.loader.exec_module(checker)


def code(certificate, file):
    with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(io.StringIO()):
        return checker.main([str(certificate), str(file)]), out.getvalue()


def alterations(value):
    """The value with one number, flag or word in it changed, or a member left out or added, in turn."""
    if isinstance(value, dict):
        for key, member in value.items():
            for other in alterations(member):
                yield {**value, key: other}
            yield {k: v for k, v in value.items() if k != key}
        yield {**value, "more": "1"}
    elif isinstance(value, list):
        for i, member in enumerate(value):
            for other in alterations(member):
                yield value[:i] + [other] + value[i + 1 :]
            yield value[:i] + value[i + 1 :]
        yield value + value[-1:] if value else ["1"]
    elif isinstance(value, bool):
        yield not value
    elif isinstance(value, int):
        yield from (value + 1, value - 1)
    elif re.fullmatch(r"-?\d+(/\d+)?", value):
        yield str(Fraction(value) + 1)
    elif re.fullmatch("[uv][01]?", value):
        yield from (x for x in ("u", "v", "u0", "u1", "v0", "v1") if x != value and len(x) == len(value))


def main(certificate, file):
    lines = certificate.read_text().splitlines()
    altered, failures, number = Path("altered.cert"), [], 0
    if code(certificate, file)[0] != 0:
        failures.append("not accepted: " + code(certificate, file)[1])

    def refuse(text, name):
        nonlocal number
        number += 1
        altered.write_text("\n".join(text) + "\n")
        result = code(altered, file)
        if result[0] != 1:
            failures.append(f"{name}: {result}")

    for i, line in enumerate(lines):
        refuse(lines[:i] + lines[i + 1 :], f"without line {i + 1}")
        refuse(lines[: i + 1] + lines[i:], f"line {i + 1} twice")
        members = json.loads(line)
        members.pop("files", None)
        for other in alterations(members):
            if i == 0:
                other["files"] = [str(file)]
            refuse(lines[:i] + [json.dumps(other)] + lines[i + 1 :], f"line {i + 1}: {json.dumps(other)}")

    text = file.read_text()
    places = [m.span() for m in re.finditer(r"(?<![\w.#])-?\d+(\.\d+)?", text)]
    if file.suffix == ".svg":
        places = [(b, e) for b, e in places if re.search(r'\b(d|points|c?[xy]|r[xy]?|width|height)="[^"]*$', text[:b])]
    other = Path("altered" + file.suffix)
    for begin, end in places:
        number += 1
        codes = set()
        for change in (1, -1):  # a knot at the end may be any one that is not within the domain
            if not codes & {1, 2}:
                other.write_text(text[:begin] + str(Fraction(text[begin:end]) + change) + text[end:])
                codes.add(code(certificate, other)[0])
        if not codes & {1, 2}:
            failures.append(f"{file}: another number at {begin}: {text[begin:end]}")
    print(f"{number} alterations, {len(failures)} not noticed")
    print("\n".join(failures[:20]))
    return 1 if failures or number < 50 else 0


sys.exit(main(Path(sys.argv[2]), Path(sys.argv[3])))
