# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Paths of svgelements and matplotlib and splines of ezdxf as Bezier curves. Their coordinates are floats, which are read exactly as these libraries
round them; for the exact decimals of a drawing take `geometric_continuity.verify`."""

from __future__ import annotations

from typing import List

import numpy

from ..curve_types import Bezier_curve, pieces
from ..foreign import path_contours

__all__ = ["path_contours", "spline_pieces", "svg_contours"]


def svg_contours(path) -> List[List[numpy.ndarray]]:
    """Returns the subpaths of a `svgelements.Path` as lists of Bezier curves, arrays of shape (degree + 1, 2). Arcs become cubic curves, as
    svgelements makes them; segments of no length are left out."""
    import svgelements

    contours: List[List[numpy.ndarray]] = []
    for segment in path:
        if isinstance(segment, svgelements.Move):
            contours.append([])
            continue
        parts = segment.as_cubic_curves() if isinstance(segment, svgelements.Arc) else [segment]
        for part in parts:
            if isinstance(part, svgelements.CubicBezier):
                points = [part.start, part.control1, part.control2, part.end]
            elif isinstance(part, svgelements.QuadraticBezier):
                points = [part.start, part.control, part.end]
            else:
                points = [part.start, part.end]
            curve = numpy.array([(p.x, p.y) for p in points])
            if (curve != curve[0]).any():
                contours[-1].append(curve)
    return [c for c in contours if c]


def spline_pieces(spline) -> List[Bezier_curve]:
    """Returns the Bezier curves of a SPLINE of ezdxf, or of its construction tool, in space, each with its span as domain. They are exact, for
    the knots, control points and weights of the spline as they are."""
    return pieces(spline)
