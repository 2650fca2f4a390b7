// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Exact_rational.h>

#include <array>

// The coefficients of 1, v, v^2, v^3.
typedef std::array<CGAL::Exact_rational, 4> Series;

inline Series product(const Series& a, const Series& b) {
  Series c;
  c.fill(CGAL::Exact_rational(0));
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j) c[i + j] += a[i] * b[j];
  return c;
}
