# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Old names of what the package itself has, for one release."""

import warnings

from .. import _joins, curve_types
from ..curve_types import Bezier_curve as Piece  # noqa: F401


def pieces(degree, knots, points, weights=None, low=None, high=None):
    """Returns `geometric_continuity.pieces(Spline(degree, points, knots, weights), low, high)`."""
    warnings.warn("adapters.splines.pieces is now pieces", DeprecationWarning, stacklevel=2)
    return curve_types.pieces(curve_types.Spline(degree, points, knots, weights), low, high)


def continuity(left, right):
    """Returns `geometric_continuity.continuity(left, right)`."""
    warnings.warn("adapters.splines.continuity is now continuity", DeprecationWarning, stacklevel=2)
    return _joins.continuity(left, right)
