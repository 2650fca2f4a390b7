#!/usr/bin/env python3
# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Checks with FreeCAD that files are closed solids: check_solids.py FILE [LEAST MOST]..., between
these volumes. The exit code is 77 without FreeCAD."""
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
try:
    import FreeCAD
    import Part
except ImportError:
    sys.exit(77)

arguments = sys.argv[1:]
failed = not arguments
while arguments:
    file, least, most = arguments[0], float(arguments[1]), float(arguments[2])
    arguments = arguments[3:]
    shape = Part.Shape()
    shape.read(file)
    solids = shape.Solids
    good = len(solids) == 1 and len(shape.Shells) == 1 and shape.isValid() and shape.Shells[0].isClosed() and least < solids[0].Volume < most
    if not good:
        failed = True
        print(file, "solids:", len(solids), "shells:", len(shape.Shells), "valid:", shape.isValid(), "volume:",
              [s.Volume for s in solids], "not between", least, "and", most)
sys.exit(1 if failed else 0)
