// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_COORDINATE_ROW_H
#define CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_COORDINATE_ROW_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_rows.h>

#include <type_traits>

/// \file Coordinate_row.h
/// The coordinates of a point as local variables of arithmetic: where they fill a register of the
/// processor, one instruction works on all of them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT, int N> constexpr bool is_register_row_v = N > 0 && row_is_vector_v<FT, row_length_v<FT, N>>;

template <class FT, int N>
using Coordinate_row = std::conditional_t<is_register_row_v<FT, N>, Row_vector<FT>, Coordinate_vector<FT, N>>;

// Returns the row of coordinate(i) for i < n, which is N unless that is 0.
template <class FT, int N, class Coordinate>
CGAL_GC_FORCEINLINE Coordinate_row<FT, N> coordinate_row(int n, const Coordinate& coordinate) {
  if constexpr (is_register_row_v<FT, N>) {
    Row_vector<FT> x;
    for_each_index<4>([&](int i) CGAL_GC_FORCEINLINE_LAMBDA { x.v[i] = i < N ? coordinate(i) : FT(0); });
    return x;
  } else {
    Coordinate_vector<FT, N> x(n);
    for (int i = 0; i < n; ++i) x[i] = coordinate(i);
    return x;
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_ALGEBRA_INTERNAL_COORDINATE_ROW_H
