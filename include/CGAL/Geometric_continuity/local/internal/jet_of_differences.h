// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_JET_OF_DIFFERENCES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_JET_OF_DIFFERENCES_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/Short_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// One number or row for each control point of a curve of this degree, without allocation up to
// degree 9.
template <int Degree, class T>
using Bezier_coefficients = std::conditional_t<(Degree < 0), Short_vector<T, 10>, std::array<T, Degree + 1>>;

// The jet of order k at an end of a Bezier curve of degree m: m!/(m-j)! / h^j times the j-th
// differences of its control points, which coordinate(j, i) reads from that end on, the points up
// to min(k, m). The step h is the length of the domain, negative at the end of the curve. Degree is
// m, or -1 when it is known at run time only.
template <class Field, int N, int Degree, class Coordinate>
Coordinate_jet<Field, N> jet_of_differences(int dimension, int m, int k, const Field& h, const Coordinate& coordinate) {
  const int used = (std::min)(k, m) + 1;
  Coordinate_jet<Field, N> jet(dimension, k);
  for (int i = 0; i < dimension; ++i) {
    Bezier_coefficients<Degree, Field> c;
    if constexpr (Degree < 0) c.resize(used);
    for (int j = 0; j < used; ++j) c[j] = coordinate(j, i);
    if (Work_meter* const work = scope_of<Field>()) {
      std::size_t words = 0; // of the last difference
      for (int j = 0; j < used; ++j) words += number_words(c[j]);
      work->charge_fractions(used * used / 4., words, words / used + number_words(h));
    }
    Field scale(1);
    bernstein_end_derivatives<Field>(c, m, k, [&](int j, const Field& x) {
      jet[j][i] = x / scale;
      scale *= h;
    });
  }
  return jet;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_JET_OF_DIFFERENCES_H
