# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Bezier surfaces that are changed to continue others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Optional, Sequence, Tuple, Union

from . import _native
from ._native import Edge_continuity
from .errors import Error
from .hints import check_name, keywords, missing_member
from ._joins import edge_continuity

_EDGES = ("u0", "u1", "v0", "v1")


@dataclass(frozen=True)
class Matched_surface:
    """A Bezier surface that continues another one along an edge."""

    points: Any  #: control points, shape (degree u + 1, degree v + 1, 3)
    edges: Tuple[str, str]  #: along which they match
    shape: Dict[str, Any]  #: the numbers alpha, beta, and for G2 alpha2, delta, for G3 alpha3, delta3
    before: Edge_continuity  #: along the edge before the match
    after: Edge_continuity  #: along the edge after it, of `points` as they are, up to order 2
    proved: bool  #: whether the surface has the order along the whole edge before `points` are rounded

    def __getattr__(self, name):
        missing_member(self, name)


@keywords(strategy="the numbers of a match are those nearest to the surface, or given: match(a, b, beta=1)",
          direction="the edge of b runs so that its ends are near those of a")
def match(a, b, edges: Union[str, Sequence[str], None] = None, order="G2", *, alpha=None, beta=None, alpha2=None, delta=None, alpha3=None,
          delta3=None, exact: Optional[bool] = None) -> Matched_surface:
    """Returns the surface `b`, changed near one of its edges so that it has the edge of `a` and continues it along the whole edge: with one
    tangent plane (G1), one curvature (G2), or G3.

    a, b: arrays of shape (degree u + 1, degree v + 1, 3), as of `edge_continuity`.
    edges: that of `a` and that of `b`, "u0", "u1", "v0" or "v1" each, in a pair or in a text "v1,v0"; by default those whose ends are
        nearest: the common edge where there is one.
    order: "G1", "G2", "G3", or 1, 2, 3. So many rows of control points, and one more, change; the degree across the edge is raised to
        2 order + 1 at least, so that the opposite edge keeps its derivatives.
    alpha, beta, alpha2, delta, alpha3, delta3: the numbers that are free; where they are not given those for which the derivatives across
        the edge change least. With C, T and W the edge and the derivatives of `a` across it
        S_v = alpha C' + beta T, S_vv = alpha^2 C'' + 2 alpha beta T' + beta^2 W + alpha2 C' + delta T.
    exact: fractions where True, floats where False; by default floats where a float is among the input. All is computed exactly, and
        rounded at the end.

    Raises Error: `nonpositive_beta` unless beta > 0, `zero_tangent` where the edge of `a` is a point or has no derivative across it,
    `dimension_mismatch` unless in space, `wrong_number_of_points`, `parameter_outside_domain` for another edge or order, `not_finite`,
    `several_common_edges` where no edges are given and two pairs are equally near.
    """
    names = ["", ""] if edges is None else edges.split(",") if isinstance(edges, str) else list(edges)
    if len(names) != 2:
        raise Error("parameter_outside_domain", "match", f"two edges are needed, as in edges=(\"v1\", \"v0\"), not {edges!r}")
    for edge in names if edges is not None else ():
        check_name("match", "edge", edge, _EDGES)
    orders = {"G1": 1, "G2": 2, "G3": 3, 1: 1, 2: 2, 3: 3}
    if not isinstance(order, (str, int)) or isinstance(order, bool) or order not in orders:
        raise Error("parameter_outside_domain", "match", f"the order is \"G1\", \"G2\" or \"G3\", not {order!r}")
    k = orders[order]
    numbers = dict(alpha=alpha, beta=beta, alpha2=alpha2, delta=delta, alpha3=alpha3, delta3=delta3)
    given = {name: x for name, x in numbers.items() if x is not None}
    for name, least in (("alpha2", 2), ("delta", 2), ("alpha3", 3), ("delta3", 3)):
        if name in given and k < least:
            raise Error("parameter_outside_domain", "match", f"{name} is a number of order G{least}, not of G{k}")
    record = _native.match(a, names[0], b, names[1], k, given, exact)
    points, names = record["points"], record["edges"]
    after = edge_continuity(a, names[0], points, names[1])
    return Matched_surface(points, (names[0], names[1]), record["shape"], record["before"], after, record["has_order"])
