# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What was meant by a name that is not there."""

from __future__ import annotations

import difflib
from typing import Any, Iterable, Optional

from .errors import Error

# Names that other libraries have, and the call here.
_GUESSED = {
    "bezier": "an array of control points is a Bezier curve; with weights or a domain Bezier_curve(points, weights, domain)",
    "curve": "an array of control points is a Bezier curve; there are Bezier_curve(points, weights, domain) and Spline(degree, points, knots)",
    "line": "two points are a line: continuity([(0, 0), (1, 1)], ...)",
    "bspline": "call Spline(degree, points, knots), or give a BSpline of SciPy",
    "nurbs": "call Spline(degree, points, knots, weights)",
    "smooth": "call blend(left, right) to connect curves smoothly, continuity(left, right) to decide how smoothly they meet",
    "point": "call evaluate(curve, parameters)",
    "derivative": "call evaluate(curve, parameters, 1)",
    "tangent": "call evaluate(curve, parameters, 1)",
    "torsion": "call evaluate(curve, parameters, 3) for derivatives, deviation(left, right).torsion_jump at a join",
    "measure": "call deviation(left, right)",
    "distance": "call deviation(left, right), which has the gap",
    "check": "call continuity(left, right) for curves, verify(file) for files",
    "repair": "call `geometric_continuity repair` for files; representable_blend(left, right) and align_handles(left, right) for curves",
    "fillet": "call round_corner(left, right, distance)",
}


def nearest(name: Any, names: Iterable[str], least: float = 0.5) -> Optional[str]:
    """Returns the name that is spelled most nearly, if it is near."""
    likeness = {n: difflib.SequenceMatcher(None, str(name).casefold(), n.casefold()).ratio() for n in names}
    best = max(likeness, key=lambda n: likeness[n], default=None)
    return best if best is not None and likeness[best] > least else None


def check_name(place: str, what: str, name: Any, names: Iterable[str]) -> None:
    """Refuses a name that is none of the names, and tells these and the nearest one."""
    names = list(names)
    if name in names:
        return
    best = nearest(name, names)
    meant = f"; did you mean '{best}'? It" if best else "; it"
    raise Error("parameter_outside_domain", place, f"there is no {what} '{name}'{meant} is one of {', '.join(names)}")


def missing_in_module(name: str, names: Iterable[str]) -> str:
    """Returns what to call instead of a name that a module does not have."""
    words = name.lower().split("_")
    if words[0] == "is" and len(words) > 1 and words[1][:1] in ("c", "g", "f") and words[1][1:].isdigit():
        return f"call continuity(left, right).{words[1][0]}_order >= {words[1][1:]}"
    if name.lower() in _GUESSED:
        return _GUESSED[name.lower()]
    functions = [n for n in names if n[0].islower() == name[0].islower()]
    parts = [n for n in functions if n.lower() in name.lower()] or [n for n in functions if name.lower() in n.lower()]
    guessed = next((g for word in words for g in _GUESSED if g in word), None)
    if guessed and not parts:
        return _GUESSED[guessed]
    best = max(parts, key=len) if parts else nearest(name, functions, 0.7)
    return f"did you mean {best}?" if best else "help(geometric_continuity) lists what there is"


def missing_member(thing: Any, name: str) -> Any:
    """Stands for `__getattr__` of a class: tells its members, or the function that was meant."""
    import geometric_continuity

    text = f"{type(thing).__name__!r} object has no attribute {name!r}"
    if name.startswith("_"):
        raise AttributeError(text)
    if name in geometric_continuity.__all__:
        raise AttributeError(f"{text}: call {name}(...) of geometric_continuity with it")
    members = sorted(m for m in dir(thing) if not m.startswith("_"))
    best = nearest(name, members)
    raise AttributeError(f"{text}{f': did you mean {best}? It' if best else ': it'} has {', '.join(members)}")
