# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The exact cases of the package, as the tests of C++ read them."""

import os
from fractions import Fraction

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "test", "Geometric_continuity", "cases")


def _value(text):
    """A leaf, or an array "[1/2 [0 3] 4]" as a list."""
    if not text.startswith("["):
        return _leaf(text)
    arrays = [[]]
    for word in text.replace("[", " [ ").replace("]", " ] ").split():
        if word == "[":
            arrays.append([])
        elif word == "]":
            array = arrays.pop()
            arrays[-1].append(array)
        else:
            arrays[-1].append(_leaf(word))
    return arrays[0][0]


def _leaf(word):
    if word in ("true", "false", "null"):
        return {"true": True, "false": False, "null": None}[word]
    try:
        return Fraction(word)
    except ValueError:
        return word


def _tree(flat):
    """{"a#": 2, "a.0": x, "a.1": y} becomes {"a": [x, y]}."""

    def build(prefix):
        if prefix + "#" in flat:
            return [build(f"{prefix}.{i}") for i in range(int(flat[prefix + "#"]))]
        if prefix not in flat:
            return _tree({key[len(prefix) + 1:]: value for key, value in flat.items() if key.startswith(prefix + ".")})
        return flat[prefix]

    names = {key.split("#")[0].split(".")[0] for key in flat}
    inner = {name: {} for name in names if name not in flat and name + "#" not in flat}
    for key, value in flat.items():
        head, _, rest = key.partition(".")
        if head in inner:
            inner[head][rest] = value
    return {name: _tree(inner[name]) if name in inner else build(name) for name in names}


def read(topic):
    """Yields name, operation, input and output of each case."""
    with open(os.path.join(FOLDER, topic + ".txt"), encoding="utf-8") as file:
        for block in file.read().split("\n\n"):
            words = dict(line.split(" ", 1) for line in block.splitlines() if " " in line and not line.startswith("#"))
            if "case" not in words:
                continue
            yield (words["case"], words["op"],
                   _tree({k[3:]: _value(v) for k, v in words.items() if k.startswith("in.")}),
                   _tree({k[4:]: _value(v) for k, v in words.items() if k.startswith("out.")}))


def points_of_start(jet):
    """The Bezier curve on [0, 1] that starts with the derivatives jet[0], jet[1], ..."""
    m = len(jet) - 1
    differences, factor = [], Fraction(1)
    for k, x in enumerate(jet):
        differences.append([Fraction(c) / factor for c in x])
        factor *= m - k
    points = []
    while differences:
        points.append(differences[0])
        differences = [[a + b for a, b in zip(p, q)] for p, q in zip(differences, differences[1:])]
    return points


def points_of_end(jet):
    """The Bezier curve on [0, 1] that ends with the derivatives jet[0], jet[1], ..."""
    return points_of_start([[-c if k % 2 else c for c in x] for k, x in enumerate(jet)])[::-1]
