# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Joins of what other libraries hold: outlines of fontTools, ufoLib2 and glyphsLib, paths of svgelements, splines of ezdxf. Each module
imports the library that it is for, and no other."""
