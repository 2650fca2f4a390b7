// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H

#include <CGAL/Geometric_continuity/edges/internal/Edge_equations.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_input.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_on_grid.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>
#include <CGAL/Geometric_continuity/numbers/internal/Stage.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

/// \file Edge_ladder.h
/// The stages by which the order along an edge is found on the control points next to it
/// (Edge_input.h), from the cheapest to the one that is left: control points are compared, rounded
/// numbers refute at the ends, integers of fixed length decide, with a short ratio of the tangent
/// planes or without. Numbers of any length decide everything that they leave open, and why an edge
/// is not smooth (Edge_decision.h).

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Tells whether the lower orders are told apart when an edge has not the highest one that is asked
// for.
enum class Lower_orders { as_one, told_apart };

// The ladder for two patches along whole edges that are the same curve in one direction.
class Edge_ladder {
public:
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  typedef Edge_on_grid<3, 53> On_grid;

private:
  Grid_layers x_, y_;
  std::optional<On_grid> on_grid_;
  bool tried_ = false;
#endif
  const Edge_layers &a_, &b_;

public:
  // \pre the edges are the same, in one direction
  Edge_ladder(const Edge_layers& a, const Edge_layers& b) : a_(a), b_(b) {}
  Edge_ladder(const Edge_ladder&) = delete;

  int degree() const { return a_.along; }
  bool is_collapsed() const { return internal::is_collapsed(a_); }

  // The order, up to the highest one that is asked for; as_one: or a higher one that is less than
  // that. Empty if numbers of fixed length do not find it.
  template <int highest, class Stages> std::optional<int> order(Lower_orders lower, Stages& stages) {
    static_assert(1 <= highest && highest <= 2);
    const auto decided = [&](Stage stage, int found) {
      stages.decided(stage, found == highest);
      return std::optional<int>(found);
    };
    if (is_collapsed()) return stages.uses(Stage::comparison) ? decided(Stage::comparison, 0) : std::nullopt;
    int most = highest;
    if (stages.uses(Stage::floating_point)) {
      most = not_refuted<highest>(lower);
      if (most == 0 || (most < highest && lower == Lower_orders::as_one)) return decided(Stage::floating_point, most);
    }
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
    const On_grid* const edge = on_grid();
    if (!edge) return std::nullopt;
    if (stages.uses(Stage::simple_ratio))
      if (const std::optional<int> found = edge->order_by_ratio(most)) return decided(Stage::simple_ratio, *found);
    if (stages.uses(Stage::fixed_integer))
      if (const std::optional<int> found = edge->order(most)) return decided(Stage::fixed_integer, *found);
#endif
    return std::nullopt;
  }

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  // Returns the edge in integers of fixed length; nothing unless all coordinates lie on one grid.
  const On_grid* on_grid() {
    if (!tried_) {
      tried_ = true;
      const double size = (std::max)(size_of(a_), size_of(b_));
      if (!std::isfinite(size)) return nullptr;
      Grid grid(size);
      if (!grid.valid()) return nullptr;
      convert(a_, grid, x_);
      convert(b_, grid, y_);
      if (grid.valid()) on_grid_.emplace(x_, y_);
    }
    return on_grid_ ? &*on_grid_ : nullptr;
  }
#endif

private:
  // The highest order that rounded numbers do not refute at the ends.
  template <int highest> int not_refuted(Lower_orders lower) const {
    const int most = not_refuted_at<highest>(false, highest);
    return most == 0 || (most < highest && lower == Lower_orders::as_one) ? most : not_refuted_at<highest>(true, most);
  }
  template <int highest> int not_refuted_at(bool at_end, int most) const {
    const Rounded_edge_end end(a_, b_, at_end);
    if (!end.in_range()) return most;
    if (end.tangent_planes_differ()) return 0;
    return highest > 1 && most > 1 && end.curvatures_differ() ? 1 : most;
  }
};

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Decides surfaces of homogeneous points, along whole edges that are the same curve in one
// direction up to a factor. The numbers are exact already, and there are no rounded ones.
class Homogeneous_ladder {
  const Homogeneous_layers &a_, &b_;
  std::array<std::int64_t, 2> scale_; // of the homogeneous points of the edges

public:
  Homogeneous_ladder(const Homogeneous_layers& a, const Homogeneous_layers& b)
      : a_(a), b_(b), scale_(common_scale(a, b, Edge_direction::same).value()) {}

  bool is_collapsed() const { return internal::is_collapsed(a_); }

  template <int highest, class Stages> std::optional<int> order(Lower_orders, Stages& stages) const {
    const auto decided = [&](Stage stage, int found) {
      stages.decided(stage, found == highest);
      return std::optional<int>(found);
    };
    if (is_collapsed()) return stages.uses(Stage::comparison) ? decided(Stage::comparison, 0) : std::nullopt;
    if (!stages.uses(Stage::fixed_integer)) return std::nullopt;
    typedef Edge_on_grid<4, 53, 53> Short;
    typedef Edge_on_grid<4, 106, 53> Long;
    typename Short::Layers x, y;
    const std::optional<int> found =
        shorten(a_, x) && shorten(b_, y) ? Short(x, y, scale_).order(highest) : Long(a_, b_, scale_).order(highest);
    return found ? decided(Stage::fixed_integer, *found) : std::nullopt;
  }

private:
  // Returns whether all numbers are at most 2^53.
  static bool shorten(const Homogeneous_layers& a, Edge_points<std::int64_t, 4>& x) {
    constexpr Signed_128 most = Signed_128(1) << 53;
    x.along = a.along;
    x.across = a.across;
    x.layers = a.layers;
    for (int j = 0; j < a.layers; ++j)
      for (int i = 0; i <= a.along; ++i)
        for (int k = 0; k < 4; ++k) {
          if (a.p[j][i][k] < -most || most < a.p[j][i][k]) return false;
          x.p[j][i][k] = static_cast<std::int64_t>(a.p[j][i][k]);
        }
    return true;
  }
};

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The order 1 or 2, if numbers of fixed length prove it. Otherwise the edge may be anything.
template <class Ladder> std::optional<int> smooth_order(Ladder& ladder) {
  const All_stages stages;
  const std::optional<int> found = ladder.template order<2>(Lower_orders::told_apart, stages);
  return found.value_or(0) > 0 ? found : std::nullopt;
}

// The layers that the stages of fixed length read of edges of points with N coordinates, and their
// ladder.
template <int N> struct Fixed_length_stages {
  typedef Edge_layers Layers;
  typedef Edge_ladder Ladder;
  static constexpr bool exist = N == 3;
};
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
template <> struct Fixed_length_stages<4> {
  typedef Homogeneous_layers Layers;
  typedef Homogeneous_ladder Ladder;
  static constexpr bool exist = true;
};
#endif

// Returns whether two patches have the order G^k along whole edges that are the same curve in one
// direction; or empty if numbers of fixed length do not decide it.
template <int order, class T, int N, class Stages>
std::optional<bool> decide_on_same_edge(const Edge_points<T, N>& a, const Edge_points<T, N>& b, Stages& stages) {
  if constexpr (order == 0) { // infinite coordinates are refused elsewhere
    if (!is_finite(a) || !is_finite(b) || !stages.uses(Stage::comparison)) return std::nullopt;
    stages.decided(Stage::comparison, true);
    return true;
  } else {
    typename Fixed_length_stages<N>::Ladder ladder(a, b);
    const std::optional<int> found = ladder.template order<order>(Lower_orders::as_one, stages);
    return found ? std::optional<bool>(*found == order) : std::nullopt;
  }
}

// Decides whole edges that may differ, or run in opposite directions; then the second one is
// reversed.
template <int order, class T, int N, class Stages>
CGAL_GC_FORCEINLINE std::optional<bool> decide_on_layers(const Edge_points<T, N>& a, Edge_points<T, N>& b,
                                                         Stages& stages) {
  if (a.along != b.along) return std::nullopt;
  const std::optional<Edge_direction> direction = common_direction(a, b);
  if (!direction) {
    // perhaps one point with other weights
    if (N == 4 && is_collapsed(a) && is_collapsed(b)) return std::nullopt;
    if (!stages.uses(Stage::comparison)) return std::nullopt;
    stages.decided(Stage::comparison, false);
    return false;
  }
  if (*direction == Edge_direction::opposite) b.reverse();
  return decide_on_same_edge<order>(a, b, stages);
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The stage for edges of B-spline surfaces as a whole: whether they continue each other twice
// continuously differentiably along a whole edge, but for the speed of the parameter across it, as
// the parts of one surface do. Decided by the control points, in integers of fixed length: T2 = -k
// T1 and W2 = k^2 W1 for a number k > 0. \pre the edges are the same curve in one direction
template <class Field> class Spline_edge_on_grid {
  typedef Spline_side<Field> Side;
  typedef typename Side::Point Point;

  const Side &s1_, &s2_;
  const int n_; // the degree along

public:
  Spline_edge_on_grid(const Side& s1, const Side& s2, int degree_along) : s1_(s1), s2_(s2), n_(degree_along) {}

  bool is_smooth() const {
    if (!normal_is_nowhere_zero()) return false;
    // a2 = -l a1, by the coordinate x of the first difference, which is not zero
    const Point first = s1_.a(0), second = s2_.a(0);
    // equivalent [1 -> 2, 1]: where that coordinate is zero the next stage decides
    int x = std::abs(first[0]) < std::abs(first[1]) ? 1 : 0;
    if (std::abs(first[x]) < std::abs(first[2])) x = 2;
    // equivalent [0 -> 1, 2]: of whole numbers that are not zero
    if (second[x] == 0 || (second[x] < 0) == (first[x] < 0)) return false;
    for (std::size_t i = 0; i < s1_.size(); ++i) {
      const Point a1 = s1_.a(i), a2 = s2_.a(i);
      for (int y = 0; y < 3; ++y)
        if (Signed_128(a2[y]) * first[x] != Signed_128(a1[y]) * second[x]) return false;
    }
    return second_order(Field(Field(static_cast<double>(-second[x])) / Field(static_cast<double>(first[x]))));
  }

private:
  // Decides by one coordinate of all products of first differences d of the edge and first
  // differences a whose basis functions overlap.
  bool normal_is_nowhere_zero() const {
    const std::size_t m = s1_.size(), n = static_cast<std::size_t>(n_);
    for (int x = 0; x < 3; ++x) {
      const int y = (x + 1) % 3, z = (x + 2) % 3;
      int signs[3] = {0, 0, 0};
      for (std::size_t i = 0; i + 1 < m; ++i) {
        const Point d = Side::difference(s1_.p[0][i + 1], s1_.p[0][i]);
        for (std::size_t j = i < n ? 0 : i - n; j <= (std::min)(m - 1, i + n); ++j) {
          const Point a = s1_.a(j);
          const Signed_128 product = Signed_128(d[y]) * a[z] - Signed_128(d[z]) * a[y];
          ++signs[product < 0 ? 0 : product == 0 ? 1 : 2];
        }
      }
      if (signs[1] == 0 && (signs[0] == 0 || signs[2] == 0)) return true;
    }
    return false;
  }

  // W2 = k^2 W1 with a2 = -l a1, hence k = l q2 h1/(q1 h1'), is f c2 = g c1 + e a1 with the numbers
  // f, g, e below.
  bool second_order(const Field& l) const {
    const Field q1(s1_.q), q2(s2_.q), k = Field(Field(l * q2 * s1_.h1) / Field(q1 * s2_.h1)), square = Field(k * k),
                                      w1 = Field(q1 * (q1 - Field(1))), w2 = Field(q2 * (q2 - Field(1)));
    const Field numbers[3] = {
        Field(w2 / Field(s2_.h1 * s2_.h2)), Field(Field(square * w1) / Field(s1_.h1 * s1_.h2)),
        Field(-Field(Field(square * w1) / Field(s1_.h1 * s1_.h1)) - Field(Field(w2 * l) / Field(s2_.h1 * s2_.h1)))};
    Common_denominator<Field> denominator;
    for (const Field& x : numbers) denominator.include(x);
    std::int64_t factors[3];
    for (int i = 0; i < 3; ++i) {
      const double x = CGAL::to_double(denominator.numerator(numbers[i]));
      if (!(std::abs(x) <= 0x1p50)) return false; // below that it is exact
      factors[i] = static_cast<std::int64_t>(x);
    }
    for (std::size_t i = 0; i < s1_.size(); ++i) {
      const Point a1 = s1_.a(i), c1 = s1_.c(i), c2 = s2_.c(i);
      for (int y = 0; y < 3; ++y)
        if (Signed_128(factors[0]) * c2[y] != Signed_128(factors[1]) * c1[y] + Signed_128(factors[2]) * a1[y])
          return false;
    }
    return true;
  }
};

// The direction of the second edge, if the edges are the same curve and the surfaces continue each
// other as above. Empty where that is not proved.
template <class Traits>
std::optional<Edge_direction> smooth_spline_edge(const Bspline_surface<Traits>& a, Patch_edge edge_a,
                                                 const Bspline_surface<Traits>& b, Patch_edge edge_b) {
  typedef Edge_field<Traits> Field;
  const int n = a.knots_along(edge_a).degree();
  if (b.knots_along(edge_b).degree() != n) return std::nullopt;
  Spline_side<Field> s1, s2;
  if (!s1.take(a, edge_a) || !s2.take(b, edge_b) || s1.knots.size() != s2.knots.size()) return std::nullopt;
  // it may be closed, and the same backwards
  if (s1.given[0].front() == s1.given[0].back()) return std::nullopt;
  Edge_direction direction = Edge_direction::same;
  if (s1.given[0] != s2.given[0]) {
    direction = Edge_direction::opposite;
    s2.reverse();
    if (s1.given[0] != s2.given[0]) return std::nullopt;
  }
  const Field length1 = Field(s1.knots.back() - s1.knots.front()), length2 = Field(s2.knots.back() - s2.knots.front());
  const std::size_t last = s1.knots.size() - 1;
  for (std::size_t i = 1; i < last; ++i) // the affine map of the domains maps the knots
    // equivalent [0 -> 1, 2]: leaves the edge to the next stage
    if (Field(length2 * Field(s1.knots[i] - s1.knots[0])) != Field(length1 * Field(s2.knots[i] - s2.knots[0])))
      return std::nullopt;
  for (const auto& knot : a.knots_along(edge_a).inner_knots())
    if (knot.multiplicity > n) return std::nullopt; // the edge may have a gap there
  double size = 0;
  for (const Spline_side<Field>* s : {&s1, &s2})
    for (const auto& row : s->given)
      for (const auto& x : row) size = (std::max)(size, largest(x));
  Grid grid(size);
  if (!grid.valid()) return std::nullopt;
  for (Spline_side<Field>* s : {&s1, &s2})
    for (int j = 0; j < 3; ++j)
      for (const auto& x : s->given[j]) s->p[j].push_back(grid(x));
  if (!grid.valid() || !Spline_edge_on_grid<Field>(s1, s2, n).is_smooth()) return std::nullopt;
  return direction;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_LADDER_H
