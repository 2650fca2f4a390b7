# SPDX-License-Identifier: CC0-1.0
"""The common part of all adapters in Python, which answer one file named by arguments, or many by lines of standard input."""

import json
import math
import os
import sys
from fractions import Fraction


class Unsupported(Exception):
    """The system has no answer to such a question."""


def tolerances(text):
    """{quantity: text} of gap=0.001,angle_degrees=0.1"""
    return dict(part.split("=") for part in text.split(",")) if text else None


# Systems without a verdict of their own compare derivatives within these tolerances.
CLOSE = {"gap": "1e-9", "angle_radians": "1e-9", "curvature_percent": "1e-4", "torsion_jump": "1e-6", "derivative_jump": "1e-9"}


def claim(order, within=CLOSE):
    return f"{order} within " + ",".join(f"{k}={v}" for k, v in within.items())


def read_chain(file):
    """The curves of a JSON file, as (degree, knots, points, weights or None) in floats."""
    with open(file, encoding="utf-8") as stream:
        content = json.load(stream)
    if "curves" not in content:
        raise Unsupported("surfaces")
    number = lambda text: float(Fraction(text)) if "/" in text else float(text)
    chain = []
    for c in content["curves"]:
        n = c["degree"] + 1
        knots = [number(t) for t in c["knots"]] if "knots" in c else [0.0] * n + [1.0] * n
        weights = [number(w) for w in c["weights"]] if "weights" in c else None
        chain.append((c["degree"], knots, [[number(x) for x in p] for p in c["points"]], weights))
    return chain, content["closed"]


def length(v):
    return math.sqrt(sum(x * x for x in v))


def order_of_derivatives(left, right, order, within):
    """Answers by the derivatives of a system: positions and three derivatives (or fewer) on both sides, in floats."""
    tolerance = {k: float(Fraction(v)) for k, v in (within or CLOSE).items()}
    most = int(order[1])
    if most >= len(left):
        raise Unsupported("derivatives of that order")
    difference = lambda a, b: [x - y for x, y in zip(a, b)]
    gap = tolerance.get("gap", 0.0)
    if length(difference(left[0], right[0])) > gap:
        return "gap"
    if order[0] == "C":
        reached = 0
        while reached < most and length(difference(left[reached + 1], right[reached + 1])) <= tolerance["derivative_jump"]:
            reached += 1
        return f"C{reached}"
    u, v = left[1], right[1]
    if most == 0:
        return "G0"
    if length(u) == 0 or length(v) == 0:
        raise Unsupported("a tangent where the first derivative is 0")
    dot = sum(x * y for x, y in zip(u, v))
    sine = math.sqrt(max(0.0, sum((u[i] * v[j] - u[j] * v[i]) ** 2 for i in range(len(u)) for j in range(i))))
    angle = tolerance.get("angle_radians", math.radians(tolerance.get("angle_degrees", 0.0)))
    if math.atan2(sine, dot) > angle:
        return "G0"
    if most == 1:
        return "G1"

    def curvature(d):
        g = sum(x * x for x in d[1])
        k = sum(x * y for x, y in zip(d[1], d[2])) / g
        return [(y - k * x) / g for x, y in zip(d[1], d[2])]
    k, j = curvature(left), curvature(right)
    if length(difference(k, j)) * 100 > tolerance.get("curvature_percent", 0.0) * max(length(k), length(j)):
        return "G1"
    if most == 2:
        return "G2"
    if order == "G3" or len(u) == 2:
        # The change of curvature along the arc is not compared: as far as it was asked.
        return "G2+"

    def torsion(d):
        cross = [d[1][1] * d[2][2] - d[1][2] * d[2][1], d[1][2] * d[2][0] - d[1][0] * d[2][2], d[1][0] * d[2][1] - d[1][1] * d[2][0]]
        square = sum(x * x for x in cross)
        return sum(x * y for x, y in zip(cross, d[3])) / square if square else None
    s, t = torsion(left), torsion(right)
    if s is None or t is None:
        return "G2+"
    return "F3" if abs(s - t) <= tolerance.get("torsion_jump", 0.0) else "G2"


def least(orders):
    """The worst of several joins."""
    return min(orders, key=lambda o: -1 if o == "gap" else int(o[1]))


def decide_chain(derivatives, file, order, within):
    """derivatives(curve) returns for each span of a curve those at its start and at its end."""
    chain, closed = read_chain(file)
    spans = [s for c in chain for s in derivatives(*c)]
    pairs = list(zip(spans, spans[1:])) + ([(spans[-1], spans[0])] if closed else [])
    reached = least([order_of_derivatives(a[1], b[0], order, within) for a, b in pairs])
    return reached if within else claim(reached)


def serve(decide):
    """Calls decide(file, order, tolerances or None), which returns what is to be printed."""
    def answer(arguments):
        try:
            return decide(arguments[0], arguments[1], tolerances(arguments[2] if len(arguments) > 2 else ""))
        except Unsupported as reason:
            return f"unsupported {reason}"
        except Exception as error:  # whatever a foreign library throws is a refusal
            return f"refused {type(error).__name__}: {str(error).splitlines()[0] if str(error) else ''}"
    if len(sys.argv) > 1:
        print(answer(sys.argv[1:]))
        return
    # Some libraries write to standard output; the runner takes only lines that begin with "= ".
    for line in sys.stdin:
        words = line.split()
        if words:
            sys.stdout.write(f"\n= {answer(words)}\n")
            sys.stdout.flush()
    os._exit(0)
