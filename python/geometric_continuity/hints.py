# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Guesses at what was meant by a name that is not there."""

from __future__ import annotations

import difflib
import functools
import inspect
import re
from typing import Any, Callable, Iterable, Optional, TypeVar, cast

import numpy

from .errors import Error

_READ = ("the module returns no curves of a file: verify(file) decides the joins in drawings, fonts, CAD models and .g2, whose plain numbers "
         "make a Spline(degree, points, knots); modules of geometric_continuity.adapters take the objects of other libraries")
_WRITE = ("the module writes no files: results are arrays, which numpy.savetxt(file, points) writes; `geometric_continuity blend` and `repair` "
          "make .g2 of .g2")
_PLOT = "evaluate(curve, numpy.linspace(0, 1, 200)) returns the points that matplotlib draws; curvature(curve, parameters) their curvatures"

_ELSEWHERE = ("that is left to others: what SciPy, geomdl or svgpathtools returns can be given as a curve; the module decides joins and makes curves "
              "that join smoothly")
_CHECK = ("call continuity(left, right) for two curves, chain_joins(spline) for a spline or a list of curves, edge_continuity(a, b) for surfaces, "
          "verify(file) for files")
_REPAIR = "call `geometric_continuity repair` for files; representable_blend(left, right) and align_handles(left, right) for curves"
_SURFACE = ("an array of shape (p + 1, q + 1, 3) is a Bezier surface: edge_continuity(a, b) decides two of them, match(a, b) changes b so that it "
            "continues a")
_SAMPLE = "call evaluate(curve, parameters), e.g. at numpy.linspace(0, 1, 200)"
_DISTANCE = ("deviation(left, right).gap is the gap at a join; the distance of whole curves is not measured, fit(points, tolerance).distance is that "
             "from points")
_FAIR = "call interpolate_fair(points)"
_BEND = "curvature_excess(curve, bound) tells where a curve is bent most, if it exceeds a bound; curvature(curve, parameters) samples it"
_SOLID = "`geometric_continuity round-edges solid.off --set-back R -o rounded.g2` rounds the edges of a solid; program() is its path"
_SPEED = "Bezier_curve(points, domain=(a, b)) changes the speed of a curve; continuity(left, right).betas tells by how much"
_FRAME = ("the tangent is evaluate(curve, parameters, 1) over its length, curvature_vector(curve, parameters) runs along the normal, and their cross "
          "product along the binormal; curvature() and torsion() are the numbers")
_ARC = "an arc is a curve with weights, a quarter of a circle Bezier_curve([(1, 0), (1, 1), (0, 1)], [1, 1, 2])"

# Verbs, which count more than what follows them in a name.
_VERBS = {"read": _READ, "load": _READ, "open": _READ, "import": _READ, "parse": _READ, "from": _READ, "svg": _READ, "write": _WRITE, "save": _WRITE,
          "export": _WRITE, "plot": _PLOT, "draw": _PLOT, "show": _PLOT,
          "verify": "chain_joins(curves) and failing_joins(curves, \"G2\") decide the joins of a spline or a list, "
                    "verify(file) those of files",
          "check": _CHECK, "analyze": _CHECK, "analyse": _CHECK, "mend": _REPAIR, "fix": _REPAIR, "repair": _REPAIR}

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
    **dict.fromkeys(("distance", "hausdorff", "within", "max_deviation"), _DISTANCE),
    "fillet": "call round_corner(left, right, distance) for two curves, round_corners(points, distance) for a polyline or a polygon",
    "round": "call round_corners(points, distance) for a polyline or a polygon, round_corner(left, right, distance) for two curves",
    "polygon": "an array of points is a polygon: round_corners(points, distance, closed=True), interpolate(points, closed=True)",
    "path": "a list of curves is a path: chain_joins(curves); paths of svgpathtools and matplotlib are curves, too; verify(file) reads drawings",
    "svg2paths": _READ, "font": _READ, "step": _READ,
    "surface": _SURFACE, "patch": _SURFACE, "face": _SURFACE,
    "join": "continuity(left, right) decides the join of two curves, chain_joins(curves) all joins of a spline or a list",
    "order": "call continuity(left, right).g_order, or order_within(left, right, tolerance)",
    "kink": "failing_joins(curves, \"G1\") tells where a spline or a list of curves has kinks, kink_size(left, right) how large one is",
    "angle": "call deviation(left, right).tangent_angle, in radians", "gap": "call deviation(left, right).gap",
    "curvature_jump": "call deviation(left, right).curvature_jump",
    "tolerance": "decisions are exact; order_within(left, right, tolerance) and failing_joins(curves, \"G1\", tolerance=1e-6) have tolerances",
    **dict.fromkeys(("closest_point", "nearest_point", "project", "projection", "bbox", "translate", "scale", "rotate", "loft", "sweep", "extrude", "revolve",
                     "ruled", "coons", "refine", "knot_insertion", "remove_knot", "insert_knot", "antiderivative", "gaussian_curvature"), _ELSEWHERE),
    **dict.fromkeys(("edge", "boundary", "boundary_curve", "edge_curve", "isocurve", "iso_curve"),
                    "the edges of a patch are rows of its array, patch[0], patch[-1], patch[:, 0] and patch[:, -1], and each is a Bezier curve"),
    **dict.fromkeys(("concatenate", "append", "chain", "composite"), "a list of curves is a chain: chain_joins(curves)"),
    "closed": "continuity(curve, curve) decides how a curve closes, chain_joins(curves, closed=True) how a list does",
    "inflection": "the sign of curvature(curve, parameters) changes at an inflection of a plane curve",
    "prove": "continuity(left, right) is a proof: .g_order is decided exactly", "decide": _CHECK,
    "curvature_comb": _PLOT, "tck": "a Spline has .knots, .points and .degree: scipy.interpolate.BSpline(spline.knots, spline.points, spline.degree)",
    **dict.fromkeys(("harmonize", "harmonise", "tunni"), _REPAIR),
    **dict.fromkeys(("nurbscurve", "bsplinecurve"), "call Spline(degree, points, knots, weights)"),
    **dict.fromkeys(("fair_g3", "fairg3"), "a strategy is a name: blend(left, right, \"fair_g3\")"),
    "g3_blend": "call blend(left, right, \"fair_g3\")", "evalpts": _SAMPLE, "splrep": "call interpolate(points), or give the tuple (t, c, k) of splrep",
    "to_bezier": "call pieces(curve)", "bezier_piece": "call pieces(curve)",
    "split": "call pieces(curve, low, high)", "subdivide": "call pieces(curve, low, high)", "decompose": "call pieces(curve)",
    "elevate": "the module has no elevation of the degree: give the control points of the higher degree",
    "reverse": "points[::-1] is the curve run through backwards, and Bezier_curve(...).reverse()",
    "degree": "a Bezier curve has the degree len(points) - 1", "knot": "call chain_joins(spline), which decides the joins at its .knots",
    "knotvector": "call Spline(degree, points, knots) with all knots", "normal": "call curvature_vector(curve, parameters)",
    "frenet": _FRAME, "frenet_frame": _FRAME, "frame": _FRAME, "binormal": _FRAME,
    "sample": _SAMPLE, "linspace": _SAMPLE, "splev": _SAMPLE, "tessellate": _SAMPLE, "flatten": _SAMPLE, "discretize": _SAMPLE, "discretise": _SAMPLE, "splprep": "call interpolate(points), or give the tuple (t, c, k) of splprep",
    "fair_spline": _FAIR, "fair_interpolation": _FAIR, "fair_interpolate": _FAIR,
    "fair_curve": "call interpolate_fair(points) through points, fair(left, right) between curves",
    "approximate": "call fit(points, tolerance)", "simplify": "call fit(points, tolerance)", "square": "call fit(points, tolerance)",
    "hermite": "call interpolate(points), or give a CubicHermiteSpline of SciPy", "catmull": "call interpolate(points)",
    **dict.fromkeys(("curvature_extrema", "curvature_extremum", "max_curvature", "maximum_curvature", "min_curvature", "min_radius", "extrema", "curvature_bound",
                     "largest_curvature"),
                    _BEND),
    "round_edge": _SOLID, "round_mesh": _SOLID, "fillet_edge": _SOLID, "mesh": _SOLID, "solid": _SOLID, "polyhedron": _SOLID,
    "reparametrize": _SPEED, "reparametrise": _SPEED, "reparametrization": _SPEED, "domain": _SPEED,
    "spiral": "call clothoid_blend(start, end)", "circle": _ARC, "arc": _ARC, "ellipse": _ARC, "version": "it is geometric_continuity.__version__",
    "extend": "call `geometric_continuity extend` for files", "adapter": "import geometric_continuity.adapters.fonttools, and the like",
    **dict.fromkeys(("length", "offset", "intersect", "intersection", "bound", "bounding", "area", "insert", "operation", "transform"),
                    _ELSEWHERE),
}

# Arguments and members here, and what other libraries call them.
_SYNONYMS = {"segments": "curves beziers", "points": "control_points ctrlpts nodes vertices c curve curves",
             "blend": "curves points control_points", "left": "points control_points", "curve": "points", "curves": "points",
             "knots": "t u knotvector", "parameters": "t u", "degree": "k p order", "weights": "w", "derivative": "nu der n order",
             "order": "continuity degree", "g_order": "order", "tolerance": "tol eps epsilon max_error s", "tangent_angle": "angle", "largest_angle": "angle normal_angle max_angle",
             "closed": "periodic per cyclic", "radius": "r", "distance": "d error max_error", "strategy": "method"}

_Function = TypeVar("_Function", bound=Callable[..., Any])


def _synonym(name: str, names: Iterable[str]) -> Optional[str]:
    return next((n for n, others in _SYNONYMS.items() if n in names and name in others.split()), None)


def keywords(**meant: str) -> Callable[[_Function], _Function]:
    """Returns a decorator for a function, or a class, which answers arguments that it does not have by what is meant, and otherwise by
    those that it has."""
    def decorate(function: _Function) -> _Function:
        signature = inspect.signature(function).parameters
        parameters = [name for name in signature if signature[name].kind != inspect.Parameter.VAR_KEYWORD]
        others = len(parameters) < len(signature)
        assert not set(meant) & set(parameters)

        def answer(name: str) -> str:
            best = name if name in meant else _synonym(name, [*meant, *parameters]) or nearest(name, parameters)
            if best in meant:
                return meant[best]
            return f"{f'did you mean {best}? It' if best else 'it'} has {', '.join(parameters)}"

        def checked(called):
            @functools.wraps(called)
            def call(*arguments, **named):
                for name in named:
                    if name in meant or not (others or name in parameters):
                        raise TypeError(f"{function.__name__}() has no argument {name!r}: {answer(name)}")
                    if name in parameters[:len(arguments) - isinstance(function, type)]:  # without self
                        raise TypeError(f"{name!r} is given twice: call {function.__name__}({', '.join(parameters)})")
                return called(*arguments, **named)

            return call

        if isinstance(function, type):
            setattr(function, "__init__", checked(getattr(function, "__init__")))
            return function
        return cast(_Function, checked(function))

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


def _guess(name: str, names: Iterable[str] = ()) -> Optional[str]:
    """Returns what to call instead of a name that other libraries have; names are those that are there."""
    words = [word.lower() for word in re.findall("[A-Z]*[a-z0-9]+|[A-Z]+", name)] or [""]
    stems = {*words, *(re.sub("(s|ness|ly|ed)$", "", word) for word in words), "".join(words)}
    order = next((word for word in words if re.fullmatch("[cgf][0-9]", word)), None)
    if order and (words[0] == "is" or len(words) == 1 or {"continuous", "continuity"} & stems):
        return (f'call failing_joins(curves, "{order.upper()}"), which is empty if no join fails' if "chain" in stems else
                f"call order_within(left, right, tolerance) for floats, or continuity(left, right).{order[0]}_order >= {order[1]}, which allows no rounding")
    if stems & {"surface", "patch", "face"}:
        return _SURFACE
    if "normal" in stems and "angle" in stems:
        return "call edge_continuity(a, b).largest_angle"
    if words == ["chain", "continuity"]:
        return _VERBS["verify"]
    if words == ["savefig"] or words[0] in ("write", "save", "export", "to") and stems & {"svg", "png", "pdf", "figure", "picture"}:
        return _PLOT
    if words[0] in _VERBS:
        return _VERBS[words[0]]
    guessed = sorted((g for g in _GUESSED if stems.issuperset(g.split("_"))), key=len)
    if guessed and ("_" in guessed[-1] or len(words) == 1 or not any(n.lower() in name.lower() or name.lower() in n.lower() for n in names)):
        return _GUESSED[guessed[-1]]
    return None


def missing_in_module(name: str, names: Iterable[str]) -> AttributeError:
    """Returns the error of a module that does not have a name, which tells what to call instead."""
    functions = [n for n in names if n[0].islower() == name[0].islower()]
    text = _guess(name, functions)
    if text is None:
        parts = [n for n in functions if n.lower() in name.lower()] or [n for n in functions if name.lower() in n.lower()]
        best = max(parts, key=len) if parts else nearest(name, functions, 0.7)
        text = f"did you mean {best}{_required(best)}?" if best else "help(geometric_continuity) lists what there is"
    return _attribute_error(f"module 'geometric_continuity' has no attribute {name!r}: {text}", name)


def _required(name: str) -> str:
    """Returns the arguments that a name of the module cannot do without."""
    import geometric_continuity

    try:
        parameters = inspect.signature(getattr(geometric_continuity, name)).parameters.values()
    except (TypeError, ValueError):
        return ""
    names = [p.name for p in parameters if p.default is p.empty or p.default is None and p.kind == p.POSITIONAL_OR_KEYWORD]
    return f"({', '.join(names)})"


def _attribute_error(text: str, name: str) -> AttributeError:
    error = AttributeError(text)
    setattr(error, "name", name)  # with a name, and without an object, the interpreter adds no suggestion of its own
    return error


def missing_member(thing: Any, name: str) -> Any:
    """Stands for `__getattr__` of a class: tells its members, or the function that was meant."""
    import geometric_continuity

    text = f"{type(thing).__name__!r} object has no attribute {name!r}"
    if name.startswith("_"):
        raise AttributeError(text)
    if name == "continuity" and isinstance(thing, geometric_continuity.Spline):
        raise _attribute_error(f"{text}: call chain_joins(spline), which decides the joins at its knots", name)
    if name in geometric_continuity.__all__:
        raise _attribute_error(f"{text}: call {name}(...) of geometric_continuity with it", name)
    if callable(thing) and name in ("point", "position", "value", "at", "eval", "evaluate_single", "evaluate_list"):
        raise _attribute_error(f"{text}: a curve is called with a parameter or an array of them, curve(0.5)", name)
    members = sorted(m for m in dir(thing) if not m.startswith("_"))
    order = re.fullmatch("(is_?)?([cgf])([0-9]?)", name.lower())
    if order and f"{order[2]}_order" in members:
        raise _attribute_error(f"{text}: ask .{order[2]}_order >= {order[3] or 1}", name)
    best = _synonym(name, members) or nearest(name, members, 0.75)
    meant = f"did you mean {best}? It" if best else f"{_guess(name)}; it" if _guess(name) else "it"
    raise _attribute_error(f"{text}: {meant} has {', '.join(members)}", name)
