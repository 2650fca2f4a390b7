// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A program that must not compile with -ffast-math; its target is not part of a build, a test
// builds it.

#include <CGAL/Geometric_continuity/Error.h>

int main() { return 0; }
