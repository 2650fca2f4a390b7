// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_SPAN_END_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_SPAN_END_JETS_H

#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_differences.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The jets of order k at the two ends of each span of a spline with rational coefficients. At a knot of multiplicity m, the
// derivatives up to p - m are those on the left of it.
template <class FT, int N>
std::vector<std::pair<Coordinate_jet<FT, N>, Coordinate_jet<FT, N>>>
span_end_jets(const Knot_vector<FT>& knots, const std::vector<Coordinate_vector<FT, N>>& c, int k) {
  typedef Coordinate_jet<FT, N> Jet;
  const int p = knots.degree(), n = c[0].dimension(), last = (std::min)(k, p);
  const std::size_t spans = knots.spans().size();
  std::vector<std::pair<Jet, Jet>> jets(spans, {Jet(n, k), Jet(n, k)});
  const Work_on_object work("derivatives of a spline");
  for (int d = 0; d < n; ++d) {
    std::vector<FT> column;
    for (const Coordinate_vector<FT, N>& x : c) column.push_back(x[d]);
    Difference_spans<FT> polynomials(knots, std::move(column));
    for (std::size_t s = 0; s < spans; ++s) {
      auto& [start, end] = jets[s];
      const int first_new = p + 1 - polynomials.start();
      for (int j = 0; j <= last; ++j)
        start[j][d] = j < first_new ? jets[s - 1].second[j][d] : polynomials.derivative(j);
      polynomials.finish([](int, const auto&, const auto&) {});
      for (int j = 0; j <= last; ++j) end[j][d] = polynomials.derivative(j);
    }
  }
  return jets;
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_SPAN_END_JETS_H
