# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves and surfaces that join smoothly, and a proof that they do.

An array of shape (degree + 1, dimension) is a Bezier curve. Numbers may be int, float, fractions.Fraction and decimal.Decimal; each is
read exactly as it is, and what is decided is decided exactly. Names and members are those of the C++ package.

>>> import geometric_continuity as gc
>>> left = [(-3, 0), (-3, 2), (-2, 3), (0, 3)]
>>> right = [(4, 0), (5, -1)]
>>> gamma = gc.blend(left, right)
>>> gc.continuity(left, gamma.points).g_order
2
"""

import warnings

from ._native import (Edge_continuity, Enclosure, Join_continuity, Join_deviation, Kink_size, Order_up_to_rounding, Visual_class,
                      uses_gmp)
from .curves import (STRATEGIES, Blend, Fair_spline, Fitted_curve, Representable_blend, Rounded_corner, Segmented_curve, Spline, blend,
                     fair, fairness, fit, interpolate, interpolate_fair, representable_blend, round_corner)
from .errors import Error
from .joins import align_handle, align_handles, continuity, deviation, edge_continuity, failing_joins, kink_size, visual_class
from .program import file_record, program, verify

__all__ = [
    "Blend", "Edge_continuity", "Enclosure", "Error", "Fair_spline", "Fitted_curve", "Join_continuity", "Join_deviation", "Visual_class",
    "Kink_size", "Order_up_to_rounding", "Representable_blend", "Rounded_corner", "STRATEGIES", "Segmented_curve", "Spline", "blend",
    "continuity", "deviation", "edge_continuity", "failing_joins", "fair", "fairness", "file_record", "fit", "interpolate", "interpolate_fair",
    "visual_class", "kink_size", "program", "representable_blend", "round_corner", "align_handle", "align_handles", "uses_gmp", "verify",
]


def __getattr__(name):
    new = {"Join_grade": "Visual_class", "join_grade": "visual_class"}.get(name)  # old names, for one release
    if new is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    warnings.warn(f"{name} is now {new}", DeprecationWarning, stacklevel=2)
    return globals()[new]
