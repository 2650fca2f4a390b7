# SPDX-License-Identifier: CC0-1.0
"""The module geometric_continuity of Python: continuity() and order_within() on fractions."""

import json
import math
import sys
from fractions import Fraction
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import geometric_continuity as gc  # noqa: E402
from answers import Unsupported, serve  # noqa: E402


def exact(text):
    return Fraction(text)


def curves(content):
    result = []
    for c in content["curves"]:
        points = [[exact(x) for x in p] for p in c["points"]]
        weights = [exact(w) for w in c["weights"]] if "weights" in c else None
        if "knots" in c:
            result += gc.pieces(gc.Spline(c["degree"], points, [exact(t) for t in c["knots"]], weights))
        else:
            result.append(gc.Bezier_curve(points, weights) if weights else points)
    return result


def level(order):
    return -1 if order == "gap" else int(order[1])


def of_join(left, right, order, within):
    if within:
        names = {"gap": "gap", "angle_degrees": "tangent_angle", "curvature_percent": "curvature_jump"}
        given = {names[k]: float(v) for k, v in within.items()}
        # Angles are in radians there, and curvatures a part of one: rounded, as a caller would.
        given["tangent_angle"] = math.radians(given.get("tangent_angle", 0))
        given["curvature_jump"] = given.get("curvature_jump", 0) / 100
        if not gc.continuity(left, right).regular:
            raise Unsupported("G orders where a first derivative is 0")
        verdicts = gc.order_within(left, right, **given).verdicts[: int(order[1]) + 1]
        if "undecided" in verdicts:
            return "undecided"
        proved = verdicts.index("refuted") if "refuted" in verdicts else len(verdicts)
        return "gap" if proved == 0 else f"G{proved - 1}"
    join = gc.continuity(left, right)
    if order[0] == "C":
        return "gap" if join.c_order < 0 else f"C{join.c_order}"
    if join.c_order < 0:
        return "gap"
    if not join.regular:
        raise Unsupported("G orders where a first derivative is 0")
    reached = join.f_order if order[0] == "F" else join.g_order
    return "F3" if order == "F3" and reached == 3 else f"G{reached}"


def decide(file, order, within):
    content = json.loads(Path(file).read_text(encoding="utf-8"))
    if "surfaces" in content:
        raise Unsupported("surfaces by this adapter")
    chain = curves(content)
    pairs = list(zip(chain, chain[1:])) + ([(chain[-1], chain[0])] if content["closed"] else [])
    orders = [of_join(a, b, order, within) for a, b in pairs]
    return "undecided" if "undecided" in orders else min(orders, key=level)


serve(decide)
