#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""The program geometric_continuity: an order from its JSON. GEOMETRIC_CONTINUITY names it, if it is not in the PATH."""

import json
import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from answers import Unsupported, serve  # noqa: E402

PROGRAM = os.environ.get("GEOMETRIC_CONTINUITY", "geometric_continuity")
# CAD models are decided within tolerances only: asked for an exact order, these are named.
SMALL = {"gap": "0.0000001", "angle_degrees": "0.00001", "curvature_percent": "0.02"}


def call(arguments):
    done = subprocess.run([PROGRAM, "verify", "--json"] + arguments, capture_output=True, text=True)
    if done.returncode not in (0, 1) or not done.stdout:
        raise RuntimeError(done.stderr.strip().replace("geometric_continuity: ", "") or f"exit code {done.returncode}")
    return json.loads(done.stdout)


def option(within):
    return ["--within", f"{within.get('gap', '0')},{within.get('angle_degrees', '0')}deg,{within.get('curvature_percent', '0')}%"]


def verdict(within, most):
    """The order that the verdicts on the orders 0, 1 and 2 prove, as far as it was asked for."""
    order = -1
    for v in within[: int(most[1]) + 1]:
        if v == "undecided":
            return "undecided"
        if v == "refuted":
            break
        order += 1
    return "gap" if order < 0 else f"G{order}"


def least(orders):
    if not orders:
        raise RuntimeError("no join")
    if any(o.startswith("undecided") for o in orders):
        return "undecided"
    return min(orders, key=lambda o: -1 if o.startswith("gap") else int(o[1]))


def of_chain(join, letter):
    order = join[{"C": "c_order", "G": "g_order", "F": "f_order"}[letter]]
    if letter != "C" and join["c_order"] >= 0 and not join["regular"]:
        # A first derivative is 0: what the unit tangents say, which is no more than G1.
        return "G1+" if join.get("drawn") == "G1" else "G0"
    return "gap" if order < 0 else f"{letter if letter == 'C' else 'F' if order == 3 and letter == 'F' else 'G'}{order}"


def grade(join):
    return {"corner": "G0", "kink": "G0", "bend": "G0", "rounding": "G0", "G1": "G1", "G2": "G2", "undecided": "undecided"}[join]


def chain(file, order, within):
    closed = ["--closed"] if closed_of(file) else []
    found = call([file] + closed + (option(within) if within else []))
    if within:
        return least([verdict(drawn(j, within), order) for j in found["joins"]])
    return least([of_chain(j, order[0]) for j in found["joins"]])


def closed_of(file):
    """A .g2 file does not say that its chain is closed; the JSON beside it does."""
    beside = Path(file).with_suffix(".json")
    return beside.is_file() and json.loads(beside.read_text(encoding="utf-8")).get("closed", False)


def drawing(file, order, within):
    if within:
        raise Unsupported("tolerances in drawings")
    found = call([file])
    reached = least([grade(j["grade"]) for j in found["joins"]])
    return reached + "+" if reached == "G2" else reached


def font(file, order, within):
    if within:
        raise Unsupported("tolerances in fonts")
    if b"fvar" in Path(file).read_bytes()[:400]:
        # Over all instances: a kink of any size is refuted, --max-kink 0.
        found = call(["--all-instances", "--glyphs", "A", "--kink-angle", "90", "--max-kink", "0", file])["summary"]
        return "undecided" if found["undecided"] else "G0" if found["refuted"] or found["corners"] else "G1"
    found = call(["--glyphs", "A", file])
    counts = found["summary"]
    first = next((g for g in ("corners", "kinks", "bends", "rounding", "G1", "G2") if counts.get(g)), None)
    reached = {"G1": "G1", "G2": "G2"}.get(first, "G0")
    return reached + "+" if reached == "G2" else reached


def drawn(join, within):
    """Where a first derivative is 0, the unit tangents have an angle, and the curvature is infinite."""
    if join["regular"] or join["within"][0] != "proved":
        return join["within"]
    angle, tolerance = join["drawn_angle_degrees"], float(within.get("angle_degrees", "0"))
    return ["proved", "proved" if angle[1] <= tolerance else "refuted" if angle[0] > tolerance else "undecided", "refuted"]


def patches(file, order, within):
    found = call(["--surfaces", "--allow-empty", file] + (["--within", f"{within.get('gap', '0')},{within.get('angle_degrees', '0')}deg"] if within else []))
    if within:
        return least([verdict(e["within"], order) for e in found["edges"]])
    lines = found["edges"] + found["knot_lines"]
    if not lines:
        # Patches without a common edge are apart; one without a knot line of low order is smooth.
        return "gap" if any(e["patch"] for e in found["boundary_edges"]) else "G2+"
    return least([e["order"] for e in lines])


def model(file, order, within):
    if file.endswith(".step") and "ADVANCED_FACE" not in Path(file).read_text(encoding="ascii"):
        raise Unsupported("curves in STEP, whose decimals become doubles")
    found = call(["--allow-empty", file] + option(within or SMALL))
    if found["not_read"]:
        raise RuntimeError("not read: " + found["not_read"][0].partition(": ")[2])
    decided = [verdict(e["within"], order) for e in found["edges"] if e["order"]]
    reached = least(decided) if decided else "G2+" if found["summary"]["faces"] == 1 else "gap"
    return reached if within or not decided else reached + " within " + ",".join(f"{k}={v}" for k, v in SMALL.items())


def profile(join, within):
    """Values, slopes and second derivatives of two records, as far as they have tolerances."""
    reached = "gap"
    for k, (name, jump) in enumerate((("gap", "jump"), ("slope_jump", "slope_jump"), ("second_jump", "second_jump"))):
        holds = join["within"][k] if k < 2 else abs(float(join[jump])) <= float(within.get(name, "0"))
        if name not in within or not holds:
            break
        reached = f"G{k}"
    return reached


def roads(file, order, within):
    names = {"gap": "--gap", "angle_radians": "--kink", "slope_jump": "--kink", "curvature_jump": "--curvature"}
    try:
        found = call(["--require", "G0", "--allow-empty", file] + [w for k, v in within.items() if k in names for w in (names[k], v)])
    except RuntimeError as error:
        if "unrecognised option" in str(error):
            raise Unsupported("roads by this version") from error
        raise
    orders = []
    for join in found["records"]:
        # Reference lines need not meet where lanes do.
        if join["kind"] == "plan" or join["kind"] == "link" and not join["lanes"]:
            orders.append(join["order"] or "undecided")
        elif join["kind"] in ("elevation", "width", "laneOffset") and not join.get("at_section"):
            orders.append(profile(join, within))
        elif "lane" in join["kind"]:
            orders.append({True: "G0", False: "gap", None: "undecided"}[join["met"]])
    return least(orders)


def decide(file, order, within):
    if file.endswith(".xodr"):
        return roads(file, order, within)
    if file.endswith(".svg"):
        return drawing(file, order, within)
    if file.endswith((".ttf", ".otf")):
        return font(file, order, within)
    if file.endswith((".step", ".brep")):
        return model(file, order, within)
    if file.endswith(".g2"):
        is_model = Path(file).read_text(encoding="utf-8").startswith("200")
        return patches(file, order, within) if is_model else chain(file, order, within)
    raise Unsupported("this format")


serve(decide)
