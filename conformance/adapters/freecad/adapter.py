# SPDX-License-Identifier: CC0-1.0
"""FreeCAD: the derivatives of edges, and the normals of faces at 21 points of the edges they share.
FREECAD_LIB names the folder of its modules."""

import json
import math
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.path.append(os.environ.get("FREECAD_LIB", "/usr/lib/freecad-python3/lib"))
import FreeCAD  # noqa: E402,F401
import Part  # noqa: E402
from answers import Unsupported, claim, least, order_of_derivatives, serve  # noqa: E402

ANGLE = 1e-6  # radians, where a record has no tolerance


def spans(edge):
    """The parts of the curve between its knots, each as the derivatives at both ends: at a knot getD3() takes the span behind it, so the end of a span is
    asked of the reversed curve. Cut pieces would have rounded poles, which tell nothing of the derivatives of short spans."""
    curve, ends = edge.Curve, edge.ParameterRange
    back = curve.copy()
    back.reverse()
    if isinstance(curve, Part.BSplineCurve):
        knots = list(zip(curve.getKnots(), reversed(back.getKnots())))
        knots = [k for k in knots if ends[0] <= k[0] <= ends[1]]
    else:
        knots = [(t, curve.FirstParameter + curve.LastParameter - t) for t in ends]
    jet = lambda c, t: [list(c.getD0(t))] + [list(v) for v in c.getD3(t)[1:]]
    for (a, _), (_, b) in zip(knots, knots[1:]):
        yield jet(curve, a), [[-x for x in v] if k % 2 else v for k, v in enumerate(jet(back, b))]


def decide_curves(shape, file, order, within):
    chain = [s for e in shape.Edges for s in spans(e)]
    beside = Path(file).with_suffix(".json")
    closed = beside.is_file() and json.loads(beside.read_text(encoding="utf-8")).get("closed")
    pairs = list(zip(chain, chain[1:])) + ([(chain[-1], chain[0])] if closed else [])
    if not pairs:
        raise RuntimeError("a chain of one curve")
    reached = least([order_of_derivatives(a[1], b[0], order, within) for a, b in pairs])
    return reached if within else claim(reached)


def decide_faces(shape, order, within):
    if within and "curvature_percent" in within:
        raise Unsupported("tolerances of curvature along edges")
    tolerance = math.radians(float(within["angle_degrees"])) if within else ANGLE
    largest = None
    for edge in shape.Edges:
        faces = [f for f in shape.Faces if any(edge.isSame(e) for e in f.Edges)]
        if len(faces) != 2 or edge.Degenerated:
            continue
        first, last = edge.ParameterRange
        for i in range(21):
            p = edge.valueAt(first + (last - first) * i / 20)
            n, m = (f.normalAt(*f.Surface.parameter(p)) for f in faces)
            # The normals of the surfaces: as the faces are oriented towards each other.
            turn = math.atan2(n.cross(m).Length, n.dot(m))
            largest = max(largest or 0.0, turn)
    if largest is None:
        raise Unsupported("edges of two different faces")
    reached = "G1+" if largest <= tolerance else "G0"
    return reached if within else claim(reached, {"angle_radians": repr(ANGLE)})


def decide(file, order, within):
    shape = Part.Shape()
    shape.read(file)
    return decide_faces(shape, order, within) if shape.Faces else decide_curves(shape, file, order, within)


serve(decide)
