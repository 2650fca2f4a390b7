// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

// Jets of whole and random numbers, and random isometries.

template <class Traits> using Jet = GC::Curve_jet<Traits>;
template <class Traits> using Column = GC::Coordinates<Traits>;
template <class Traits> using Composite = GC::Composite_bezier_curve<Traits>;
typedef GC::Continuity_kind Kind;

template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

template <class Traits> Column<Traits> column(int d, std::initializer_list<int> x) {
  Column<Traits> c(d);
  int i = 0;
  for (int value : x)
    if (i < d) c[i++] = typename Traits::FT(value);
  return c;
}

template <class Traits> Jet<Traits> zero_jet(int d, int k) {
  return Jet<Traits>(GC::Coordinate_jet<typename Traits::FT, GC::dimension_v<Traits>>(d, k));
}

template <class Traits> Jet<Traits> jet(int d, std::initializer_list<std::initializer_list<int>> rows) {
  Jet<Traits> x = zero_jet<Traits>(d, static_cast<int>(rows.size()) - 1);
  int j = 0;
  for (const std::initializer_list<int>& row : rows) x[j++] = column<Traits>(d, row);
  return x;
}

template <class Traits> Jet<Traits> truncated(const Jet<Traits>& x, int k) {
  Jet<Traits> y = zero_jet<Traits>(x.dimension(), k);
  for (int j = 0; j <= k; ++j) y[j] = x[j];
  return y;
}

class Random : public Random_integers<> {
public:
  Q rational() { return fraction_of<Q>(-99, 99, 1, 99); }
  template <class Traits> Column<Traits> column(int d) {
    Column<Traits> c(d);
    for (int i = 0; i < d; ++i) c[i] = rational();
    return c;
  }
  // with independent derivatives
  template <class Traits> Jet<Traits> jet(int d, int k) {
    for (;;) {
      Jet<Traits> x = zero_jet<Traits>(d, k);
      for (int j = 0; j <= k; ++j) x[j] = column<Traits>(d);
      if (GC::gram_determinants(x, std::min(k, d)).back() != Q(0)) return x;
    }
  }
  // In space the rotation of a quaternion, otherwise a product of rotations in all coordinate
  // planes; and a translation.
  template <class Traits> GC::Isometry<Traits> isometry(int d) {
    std::vector<Column<Traits>> rows(d, Column<Traits>(d));
    for (int i = 0; i < d; ++i) rows[i][i] = Q(1);
    if (d == 3) {
      const Q a = rational(), b = rational(), c = rational(), e(1);
      const Q n = a * a + b * b + c * c + e * e, two(2);
      const Q entries[3][3] = {
          {Q(1) - two * (b * b + c * c) / n, two * (a * b - c * e) / n, two * (a * c + b * e) / n},
          {two * (a * b + c * e) / n, Q(1) - two * (a * a + c * c) / n, two * (b * c - a * e) / n},
          {two * (a * c - b * e) / n, two * (b * c + a * e) / n, Q(1) - two * (a * a + b * b) / n}};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[i][j] = entries[i][j];
    } else
      for (int i = 0; i < d; ++i)
        for (int j = i + 1; j < d; ++j) {
          const Q t = rational(), n = Q(1) + t * t, c = (Q(1) - t * t) / n, s = Q(2) * t / n;
          const Column<Traits> p = rows[i], q = rows[j];
          rows[i] = c * p - s * q;
          rows[j] = s * p + c * q;
        }
    return GC::Isometry<Traits>(rows, column<Traits>(d));
  }
};

// The last coordinate with the opposite sign.
template <class Traits> Jet<Traits> mirrored(Jet<Traits> x) {
  for (int j = 0; j <= x.order(); ++j) x[j][x.dimension() - 1] *= typename Traits::FT(-1);
  return x;
}

template <class Traits> bool same_map(const GC::Isometry<Traits>& f, const GC::Isometry<Traits>& g) {
  for (int i = 0; i < f.dimension(); ++i)
    for (int j = 0; j < f.dimension(); ++j)
      if (f.entry(i, j) != g.entry(i, j)) return false;
  return GC::coordinates<Traits>(f.translation()) == GC::coordinates<Traits>(g.translation());
}

// test(Traits(), d) in all dimensions from 2 to 5, with exact rational numbers
template <class Test> void in_every_exact_space(Test test) {
  test(Exact_2(), 2);
  test(Exact_3(), 3);
  test(Exact_d(), 3);
  test(Exact_d(), 4);
  test(Exact_d(), 5);
}
