// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_PREPARED_DOUBLE_END_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_PREPARED_DOUBLE_END_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/join_on_doubles.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An end with double coordinates, with what its decisions have in common: the legs on its grid.
template <class Traits_, int N> class Prepared_double_end {
  End_polygon<double, N> points_;
  int degree_;
  std::pair<double, double> domain_;
  Grid_legs<N> grid_;
  int pivot_; // the largest coordinate of the first leg

public:
  typedef Traits_ Traits;

  template <class Points>
  explicit Prepared_double_end(const Points& end)
      : points_(points_of<3, N>(end)), degree_(end.degree()), domain_(end.domain()), grid_(grid_legs_of<3>(points_)),
        pivot_(grid_.valid ? largest_coordinate(grid_.legs[0]) : 0) {}

  int degree() const { return degree_; }
  int dimension() const { return N; }
  std::pair<double, double> domain() const { return domain_; }
  double coordinate(int j, int i) const { return points_[j][i]; }

  // Exact or `unknown`. \pre the ends meet, if the question asks for contact
  template <Join_question question, class Stages>
  static CGAL_GC_FORCEINLINE Join_answer decide(const Prepared_double_end& left, const Prepared_double_end& right,
                                                Stages& stages) {
    if constexpr (is_parametric(question))
      return decide_on_doubles<question, N>(left, right, stages);
    else {
      const Grid_legs<N>&x = left.grid_, &y = right.grid_;
      const int m = left.degree(), n = right.degree(), pivot = left.pivot_;
      if (!x.valid || !y.valid || (std::max)(m, n) > 1000 || !stages.uses(Join_stage::fixed_integer))
        return decide_on_doubles<question, N>(left, right, stages);
      const auto decided = [&](Join_answer answer) {
        stages.decided(Join_stage::comparison, answer);
        return answer;
      };
      const std::int64_t first = x.legs[0][pivot], second = y.legs[0][pivot];
      if constexpr (is_geometric(question)) {
        if (!((first < 0 && 0 < second) || (0 < first && second < 0))) return decided(Join_answer::no);
      } else if (first == 0 || y.legs[0][right.pivot_] == 0)
        return decided(Join_answer::undefined);
      return decide_on_grid_legs<question, N>(x, m, y, n, pivot,
                                              Join_weights<std::int64_t>::template geometric<question>(m, n), stages);
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_PREPARED_DOUBLE_END_H
