# SPDX-License-Identifier: CC0-1.0
"""FontForge: the types of points that it finds when it opens a font."""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(sys.argv[0] if sys.argv[0].endswith(".py") else "adapter.py")), ".."))
import fontforge  # noqa: E402
from answers import Unsupported, serve  # noqa: E402


def decide(file, order, within):
    if within:
        raise Unsupported("tolerances")
    with open(file, "rb") as stream:
        if b"fvar" in stream.read(400):
            raise Unsupported("all instances of a variable font")
    font = fontforge.open(file)
    try:
        glyph = font["A"]
        glyph.unlinkRef()
        points = [p for contour in glyph.foreground for p in contour if p.on_curve]
        if not points:
            raise RuntimeError("no points")
        corner = any(p.type == fontforge.splineCorner for p in points)
    finally:
        font.close()
    return "G0" if corner else "G1+"


sys.argv = sys.argv[:1]
serve(decide)
