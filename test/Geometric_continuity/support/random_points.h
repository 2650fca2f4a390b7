// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "test.h"

// Random points, of doubles and of exact numbers.

typedef CGAL::Exact_rational Exact;
template <class FT> using Traits = GC::Traits_3<CGAL::Simple_cartesian<FT>>;
template <class FT> using Point = typename Traits<FT>::Point;

std::mt19937 engine(2026);

template <class FT> FT number() { // in [-1, 1]
  const int x = static_cast<int>(engine() % 2001) - 1000;
  return FT(FT(x) / FT(1000));
}
template <class FT> Point<FT> point() {
  const FT x = number<FT>(), y = number<FT>(), z = number<FT>();
  return Point<FT>(x, y, z);
}
template <class FT> std::vector<Point<FT>> points(int n) {
  std::vector<Point<FT>> p;
  for (int i = 0; i < n; ++i) p.push_back(point<FT>());
  return p;
}

// Equal for exact numbers. The doubles of these tests come from sums of a few hundred products of
// numbers up to `size`.
template <class FT> bool same(const FT& x, const FT& y, double size) {
  if constexpr (std::is_same_v<FT, double>)
    return std::abs(x - y) <= 0x1p-44 * size;
  else
    return x == y;
}
