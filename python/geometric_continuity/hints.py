# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What was meant by a name that is not there."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from typing import Any, Callable, Iterable, Optional, TypeVar, cast

import numpy

from .errors import Error

_READ = "verify(file) reads drawings, fonts and CAD models; modules of geometric_continuity.adapters take the objects of other libraries"
_WRITE = "the module writes no files: results are arrays, which numpy.savetxt(file, curve.points) writes"
_PLOT = "evaluate(curve, numpy.linspace(0, 1, 200)) returns the points that matplotlib draws; curvature(curve, parameters) their curvatures"

# Verbs, which count more than what follows them in a name.
_VERBS = {"read": _READ, "load": _READ, "open": _READ, "import": _READ, "parse": _READ, "svg": _READ, "write": _WRITE, "save": _WRITE,
          "export": _WRITE, "plot": _PLOT, "draw": _PLOT, "show": _PLOT,
          "verify": "chain_joins(curves) and failing_joins(curves, \"G2\") decide the joins of a spline or a list, "
                    "verify(file) those of files",
          "check": "call continuity(left, right) for two curves, chain_joins(spline) for a spline or a list of curves, verify(file) for files"}

# Names that other libraries have, and the call here.
_GUESSED = {
    "bezier": "an array of control points is a Bezier curve; with weights or a domain Bezier_curve(points, weights, domain)",
    "curve": "an array of control points is a Bezier curve; there are Bezier_curve(points, weights, domain) and Spline(degree, points, knots)",
    "line": "two points are a line: continuity([(0, 0), (1, 1)], ...)",
    "polyline": "an array of points is a polyline: fit(points, tolerance) leads curves near it, interpolate(points) through its vertices",
    "spline": "call interpolate(points) for the spline through points, fit(points, tolerance) for curves near them, "
              "Spline(degree, points, knots) for one that is known",
    "cubic_spline": "call interpolate(points) for the cubic spline through points, Spline(3, points, knots) for one that is known",
    "bspline": "call Spline(degree, points, knots), or give a BSpline of SciPy",
    "nurbs": "call Spline(degree, points, knots, weights)",
    "smooth": "call blend(left, right) to connect curves smoothly, continuity(left, right) to decide how smoothly they meet",
    "connect": "call blend(left, right)",
    "bridge": "call blend(left, right)",
    "continuous": "call continuity(left, right).g_order >= 1, order_within(left, right, tolerance) with a tolerance, "
                  "chain_joins(spline) for the joins inside of a spline",
    "knot_continuity": "call chain_joins(spline), which decides the joins at its knots",
    "curvature_continuous": "call continuity(left, right).g_order >= 2, chain_joins(spline) for the joins inside of a spline",
    "control_point": "a curve has .points, e.g. blend(left, right).points",
    "point": "call evaluate(curve, parameters)",
    "derivative": "call evaluate(curve, parameters, 1)",
    "tangent": "call evaluate(curve, parameters, 1)",
    "measure": "call deviation(left, right)",
    "distance": "call deviation(left, right), which has the gap",
    "repair": "call `geometric_continuity repair` for files; representable_blend(left, right) and align_handles(left, right) for curves",
    "fillet": "call round_corner(left, right, distance)",
    "round_corner": "round_corner(left, right, distance) rounds one corner; call it for each pair of neighbours",
}

# Members that other libraries have, and those here.
_MEMBERS = {"curves": "segments", "beziers": "segments", "control_points": "points", "order": "g_order"}

_Function = TypeVar("_Function", bound=Callable[..., Any])


def keywords(**meant: str) -> Callable[[_Function], _Function]:
    """Returns a decorator for a function, which answers arguments that it does not have by what is meant."""
    def decorate(function: _Function) -> _Function:
        assert not set(meant) & set(inspect.signature(function).parameters)

        @functools.wraps(function)
        def call(*arguments, **named):
            for name in named:
                if name in meant:
                    raise TypeError(f"{function.__name__}() has no argument {name!r}: {meant[name]}")
            return function(*arguments, **named)

        return cast(_Function, call)

    return decorate


def check_flag(place: str, name: str, value: Any, meant: str) -> None:
    """Refuses a flag that is no bool, and tells what may have been meant by it."""
    if not isinstance(value, (bool, numpy.bool_)):
        raise Error("parameter_outside_domain", place, f"{name} is True or False, not {value!r}; {meant}")


def no_truth(member: str) -> Callable[[Any], bool]:
    """Returns the `__bool__` of a class with an order: a join of no order would be true."""
    def refuse(self) -> bool:
        raise TypeError(f"{type(self).__name__!r} object is neither true nor false: ask `.{member} >= 1`")

    return refuse


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
    words = [word.lower() for word in re.findall("[A-Z]*[a-z0-9]+|[A-Z]+", name)] or [""]
    if words[0] == "is" and len(words) > 1 and words[1][:1] in ("c", "g", "f") and words[1][1:].isdigit():
        return f"call continuity(left, right).{words[1][0]}_order >= {words[1][1:]}"
    if words[0] in _VERBS:
        return _VERBS[words[0]]
    stems = {*words, *(re.sub("(s|ness|ly)$", "", word) for word in words), "".join(words)}
    guessed = sorted((g for g in _GUESSED if stems.issuperset(g.split("_"))), key=len)
    if guessed and ("_" in guessed[-1] or guessed[-1] == "".join(words)):
        return _GUESSED[guessed[-1]]
    functions = [n for n in names if n[0].islower() == name[0].islower()]
    parts = [n for n in functions if n.lower() in name.lower()] or [n for n in functions if name.lower() in n.lower()]
    if guessed and not parts:
        return _GUESSED[guessed[-1]]
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
    best = _MEMBERS[name] if _MEMBERS.get(name) in members else nearest(name, members)
    raise AttributeError(f"{text}{f': did you mean {best}? It' if best else ': it'} has {', '.join(members)}")
