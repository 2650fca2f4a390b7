// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POINT_ROWS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POINT_ROWS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The control points of a B-spline curve as rows of numbers, and back: what the functions of bspline_spans.h read and write. A
// row may be longer than the dimension, to fill the registers of the processor.

template <class Traits> struct Rows_of_points {
  typedef typename Traits::FT FT;
  const std::vector<typename Traits::Point>& points;

  void operator()(int i, FT* row) const {
    constexpr int N = dimension_v<Traits>, length = row_length_v<FT, N>;
    const Traits traits;
    const int d = N > 0 ? N : traits.compute_dimension_object()(points[i]);
    for (int x = 0; x < d; ++x) row[x] = traits.compute_coordinate_object()(points[i], x);
    if constexpr (length > N) row[N] = FT(0);
  }
};

template <class Traits> struct Write_points {
  typedef typename Traits::FT FT;
  static constexpr int N = dimension_v<Traits>;
  int dimension;
  typename Traits::Point* next;
  Finite_rows<row_length_v<FT, N>, FT> finite = {};

  CGAL_GC_FORCEINLINE void operator()(const FT* row) {
    *next++ = Traits().construct_point_object()(N > 0 ? N : dimension, row, row + (N > 0 ? N : dimension));
    finite.add(row, dimension);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POINT_ROWS_H
