# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
from fractions import Fraction
from typing import Any, Dict, Iterator, Optional, Tuple

import numpy

uses_gmp: bool
strategies: Tuple[str, ...]

class Enclosure:
    lower: float
    upper: float
    def __iter__(self) -> Iterator[float]: ...
    def __eq__(self, other: object) -> bool: ...

class Order_up_to_rounding:
    g_order: int
    units: float

class Join_continuity:
    c_order: int
    g_order: int
    f_order: int
    regular: bool
    tangent_equal: Optional[bool]
    curvature_equal: Optional[bool]
    curvature_vector_equal: Optional[bool]
    torsion_equal: Optional[bool]
    betas: Tuple[Fraction, ...]
    up_to_rounding: Optional[Order_up_to_rounding]

class Join_deviation:
    gap: Enclosure
    tangent_angle: Optional[Enclosure]
    curvature_jump: Optional[Enclosure]
    torsion_jump: Optional[Enclosure]

class Join_grade:
    gap: Join_grade
    corner: Join_grade
    kink: Join_grade
    g1: Join_grade
    g2: Join_grade
    name: str
    value: int

class Kink_size:
    angle: Enclosure
    handle_offset: Enclosure
    severity: Enclosure

class Edge_continuity:
    g_order: int
    defect: str
    reversed: bool
    coplanar: bool
    collapsed: bool
    normal_vanishes: bool
    whole_a: bool
    whole_b: bool
    largest_angle: Optional[float]

def continuity(left: Any, right: Any, max_order: int) -> Join_continuity: ...
def deviation(left: Any, right: Any) -> Join_deviation: ...
def join_grade(left: Any, right: Any, kink_angle: Any) -> Optional[Join_grade]: ...
def kink_size(left: Any, right: Any) -> Optional[Kink_size]: ...
def align_handles(
    left: Tuple[int, int], right: Tuple[int, int], max_squared_move: int
) -> Optional[Tuple[Tuple[int, int], Tuple[int, int]]]: ...
def align_handle(handle: Tuple[int, int], direction: Tuple[int, int]) -> Tuple[int, int]: ...
def failing_joins(points: Any, order: str, closed: bool, parallel: bool) -> numpy.ndarray: ...
def edge_continuity(a: Any, edge_a: str, b: Any, edge_b: str) -> Edge_continuity: ...
def blend(left: Any, right: Any, strategy: str, beta: Any, eta: Any, parameters: Any, exact: Optional[bool]) -> Dict[str, Any]: ...
def representable_blend(left: Any, right: Any, strategy: str) -> Dict[str, Any]: ...
def round_corner(left: Any, right: Any, distance: Any, strategy: str, exact: Optional[bool]) -> Dict[str, Any]: ...
def fairness(curve: Any) -> float: ...
def interpolate(
    points: Any, closed: bool, parametrisation: str, parameters: Any, exact: Optional[bool]
) -> Dict[str, Any]: ...
def interpolate_fair(points: Any, closed: bool, exact: Optional[bool]) -> Dict[str, Any]: ...
def fit(
    points: Any, tolerance: Any, order: int, closed: bool, corner_angle: float, exact: Optional[bool]
) -> Dict[str, Any]: ...
