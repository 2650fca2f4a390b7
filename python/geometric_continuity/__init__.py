# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves and surfaces that join smoothly, and a proof that they do.

An array of shape (degree + 1, dimension) is a Bezier curve. Numbers may be int, float, fractions.Fraction and decimal.Decimal; each is
read exactly as it is, and what is decided is decided exactly. Names and members are those of the C++ package. `Bezier_curve` has
weights and a domain, `Spline` knots; those of SciPy are taken, too.

>>> import geometric_continuity as gc
>>> left = [(-3, 0), (-3, 2), (-2, 3), (0, 3)]
>>> right = [(4, 0), (5, -1)]
>>> gamma = gc.blend(left, right)
>>> gc.continuity(left, gamma.points).g_order
2
"""

import difflib
import warnings

from ._native import (Edge_continuity, Enclosure, Join_continuity, Join_deviation, Kink_size, Order_up_to_rounding, Order_within,
                      Visual_class, uses_gmp)
from ._native import version as __version__
from .curve_types import Bezier_curve, Segmented_curve, Spline, pieces
from .curves import (STRATEGIES, Blend, Fair_spline, Fitted_curve, Representable_blend, Rounded_corner, blend, fair, fairness, fit,
                     interpolate, interpolate_fair, representable_blend, round_corner)
from .errors import Error
from .evaluation import curvature, curvature_vector, evaluate
from .joins import (align_handle, align_handles, chain_joins, continuity, deviation, edge_continuity, failing_joins, kink_size,
                    order_within, visual_class)
from .program import file_record, program, verify

__all__ = [
    "Bezier_curve", "Blend", "Edge_continuity", "Enclosure", "Error", "Fair_spline", "Fitted_curve", "Join_continuity", "Join_deviation",
    "Kink_size", "Order_up_to_rounding", "Order_within", "Representable_blend", "Rounded_corner", "STRATEGIES", "Segmented_curve", "Spline",
    "Visual_class", "align_handle", "align_handles", "blend", "chain_joins", "continuity", "curvature", "curvature_vector",
    "deviation", "edge_continuity", "evaluate", "failing_joins", "fair", "fairness", "file_record", "fit", "interpolate", "interpolate_fair",
    "kink_size", "order_within", "pieces", "program", "representable_blend", "round_corner", "uses_gmp", "verify", "visual_class",
]

# What other libraries call it, and the call here.
_GUESSED = {
    "bezier": "an array of control points is a Bezier curve; with weights or a domain Bezier_curve(points, weights, domain)",
    "curve": "an array of control points is a Bezier curve; there are Bezier_curve(points, weights, domain) and Spline(degree, points, knots)",
    "line": "call continuity([(0, 0), (1, 1)], ...): two points are a line",
    "bspline": "call Spline(degree, points, knots), or give a BSpline of SciPy",
    "nurbs": "call Spline(degree, points, knots, weights)",
    "is_smooth": "call continuity(left, right).g_order, or order_within(left, right, gap=..., tangent_angle=...)",
    "point": "call evaluate(curve, parameters)",
    "derivative": "call evaluate(curve, parameters, 1)",
    "tangent": "call evaluate(curve, parameters, 1)",
    "measure": "call deviation(left, right)",
    "check": "call continuity(left, right) for curves, and verify(file) for files",
    "repair": "call program() with 'repair' for files; representable_blend(left, right) and align_handles(left, right) for curves",
}


def __getattr__(name):
    new = {"Join_grade": "Visual_class", "join_grade": "visual_class"}.get(name)  # old names, for one release
    if new is not None:
        warnings.warn(f"{name} is now {new}", DeprecationWarning, stacklevel=2)
        return globals()[new]
    lower = name.lower()
    words = lower.split("_")
    if words[0] == "is" and len(words) > 1 and words[1][:1] in ("c", "g", "f") and words[1][1:].isdigit():
        hint = f"call continuity(left, right).{words[1][0]}_order >= {words[1][1:]}"
    else:
        near = difflib.get_close_matches(lower, [*_GUESSED, *map(str.lower, __all__)], 1, 0.7)
        exact = [n for n in __all__ if near and n.lower() == near[0]]
        hint = f"did you mean {exact[0]}?" if exact else _GUESSED[near[0]] if near else "help(geometric_continuity) lists what there is"
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}: {hint}")
