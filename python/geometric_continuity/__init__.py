# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Curves and surfaces that join smoothly, and a proof that they do.

An array of shape (degree + 1, dimension) is a Bezier curve. Numbers may be int, float, fractions.Fraction and decimal.Decimal; each is
read exactly as it is, and what is decided is decided exactly. Names and members are those of the C++ package. `Bezier_curve` has
weights and a domain, `Spline` knots; those of SciPy and of other libraries are taken, too.

>>> import geometric_continuity as gc
>>> left = [(-3, 0), (-3, 2), (-2, 3), (0, 3)]
>>> right = [(4, 0), (5, -1)]
>>> gamma = gc.blend(left, right)
>>> gc.continuity(left, gamma.points).g_order
2
"""

import dis
import sys
import warnings

from ._native import (Edge_continuity, Enclosure, Join_continuity, Join_deviation, Kink_size, Order_up_to_rounding, Order_within,
                      Visual_class, uses_gmp)
from ._native import version as __version__
from .curve_types import Bezier_curve, Segmented_curve, Spline, pieces
from ._curves import (STRATEGIES, Blend, Clothoid_blend, Curvature_excess, Fair_spline, Fitted_curve, Representable_blend, Rounded_corner,
                     blend, clothoid_blend, curvature_excess, fair, fairness, fit, interpolate, interpolate_fair, representable_blend, round_corner, round_corners)
from .errors import Error
from ._evaluation import curvature, curvature_vector, evaluate, torsion
from .hints import missing_in_module, missing_member, no_truth
from ._joins import (align_handle, align_handles, chain_joins, continuity, deviation, edge_continuity, failing_joins, kink_size,
                    order_within, visual_class)
from .program import file_record, program, verify
from ._surfaces import Matched_surface, match

__all__ = [
    "Bezier_curve", "Blend", "Clothoid_blend", "Curvature_excess", "Edge_continuity", "Enclosure", "Error", "Fair_spline", "Fitted_curve", "Join_continuity",
    "Join_deviation",
    "Kink_size", "Matched_surface", "Order_up_to_rounding", "Order_within", "Representable_blend", "Rounded_corner", "STRATEGIES",
    "Segmented_curve", "Spline",
    "Visual_class", "align_handle", "align_handles", "blend", "chain_joins", "clothoid_blend", "continuity", "curvature", "curvature_excess", "curvature_vector",
    "deviation", "edge_continuity", "evaluate", "failing_joins", "fair", "fairness", "file_record", "fit", "interpolate", "interpolate_fair",
    "kink_size", "match", "order_within", "pieces", "program", "representable_blend", "round_corner", "round_corners", "torsion", "uses_gmp", "verify",
    "visual_class",
]

for _class in (Edge_continuity, Enclosure, Join_continuity, Join_deviation, Kink_size, Order_up_to_rounding, Order_within):
    setattr(_class, "__getattr__", missing_member)
for _class, _member in ((Join_continuity, "g_order"), (Order_within, "proved_order"), (Edge_continuity, "g_order")):
    setattr(_class, "__bool__", no_truth(_member))


def __getattr__(name):
    new = {"Join_grade": "Visual_class", "join_grade": "visual_class"}.get(name)  # old names, for one release
    if new is not None:
        warnings.warn(f"{name} is now {new}", DeprecationWarning, stacklevel=2)
        return globals()[new]
    error = missing_in_module(name, __all__)
    caller = sys._getframe(1)
    if caller.f_code.co_code[caller.f_lasti] == dis.opmap["IMPORT_FROM"]:  # which would replace the text of an AttributeError
        raise ImportError(str(error), name=__name__)
    raise error
