# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Marks in headers, which say why no test can reach a line, and which alterations of a line change no answer:

    // unreachable: REASON
    // equivalent [ALTERATION, N]: REASON

A mark stands above its line, and goes on in lines that begin with three spaces."""

import re


def marks(lines, kind):
    """The marks of this kind: the number of the line that each is about, and what stands in its brackets."""
    found, waiting = [], []
    for number, line in enumerate(lines, 1):
        comment = re.match(r"\s*//( +)(.*)", line)
        if comment and len(comment[1]) == 1 and re.match(r"(unreachable|equivalent)\b", comment[2]):
            waiting.append(comment[2])
        elif comment and len(comment[1]) == 3 and waiting:
            waiting[-1] += " " + comment[2]
        elif waiting:
            for text in waiting:
                mark = re.fullmatch(r"(\w+)(?: \[(.*, \d+)\])?: .+", text)
                if not mark:
                    raise ValueError(f"line {number}: not a mark: {text}")
                if mark[1] == kind:
                    found.append((number, mark[2]))
            waiting = []
    return found
