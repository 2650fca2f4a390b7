// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_OF_COLUMNS_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_OF_COLUMNS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/edges/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Uncertain.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/algebra/internal/Unreduced_vector.h>
#endif

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file blend_of_columns.h
/// The blend of degree 5 of two Bézier patches of one degree along their edges, with numbers for functions: each column of its control
/// points is a sum of multiples of a column of either patch. Rational numbers are computed on unreduced fractions, and each number of the
/// result is reduced once.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The numbers in which sums are made.
#ifdef CGAL_USE_GMP
template <class FT> using Sum_number = std::conditional_t<Rational_parts<FT>::value, Unreduced_fraction<FT>, FT>;
#else
template <class FT> using Sum_number = FT;
#endif

// Refuses an edge without a normal: a single point, or one across which the derivative vanishes.
inline void refuse_edge(bool is_point, bool vanishes, const char* surface) {
  if (is_point) throw Error(Error_code::zero_tangent, std::string("blend: a point is the edge of ") + surface);
  if (vanishes)
    throw Error(Error_code::zero_tangent, std::string("blend: no derivative across the whole edge of ") + surface);
}

// The points b_1 and b_2 next to the point b_0 = p_0 of an edge: b_0 + f d_1 / 5 and b_0 + (g d_1 + h d_2) / 20, with the differences
// d_1 = p_1 - p_0 and d_2 = p_2 - 2 p_1 + p_0 of a column.
template <class Number> struct Column_factors {
  Number f, g, h, fifth, twentieth; // the rounded 1/5 divides exactly what a rounded number can be divided by exactly

  // Of numbers or vectors.
  template <class Value> std::pair<Value, Value> operator()(const Value& p0, const Value& p1, const Value& p2) const {
    Value d1 = p1, d2 = p2;
    d1 -= p0;
    d2 -= p1;
    d2 -= d1;
    d2 *= h;
    Value b1 = d1, b2 = std::move(d1);
    b1 *= f;
    b1 *= fifth;
    b1 += p0;
    b2 *= g;
    b2 += d2;
    b2 *= twentieth;
    b2 += p0;
    return {std::move(b1), std::move(b2)};
  }
};

// One end of a blend of columns.
template <class Traits> class Column_end {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Sum_number<FT> Number;
  static constexpr int N = dimension_v<Traits>;

  const Bezier_patch<Traits>& s_;
  const Patch_edge edge_;
  Column_factors<Number> factors_;

public:
  // `direction` is 1 where the blend starts, -1 where it ends.
  Column_end(const Bezier_patch<Traits>& s, Patch_edge edge, const Edge_reparametrisation<FT>& r, int direction)
      : s_(s), edge_(edge) {
    const int q = s.degree_across(edge);
    const std::pair<FT, FT> across = runs_along_u(edge) ? s.domain_v() : s.domain_u();
    const FT length = across.second - across.first, beta = r.beta[0] / length, delta = r.delta[0] / length;
    // S_v = beta T and S_vv = beta^2 W + delta T, with T = -+ q d_1 and W = q (q-1) d_2
    factors_ = {Number(FT(FT(-q) * beta)), Number(FT(FT(-8 * q) * beta - FT(direction * q) * delta)),
                Number(FT(FT(q * (q - 1)) * beta * beta)), Number(FT(FT(1) / FT(5))), Number(FT(FT(1) / FT(20)))};
  }

  // Writes b_0, b_1 and b_2 of the column i.
  template <class Iterator> void operator()(int i, Iterator to) const {
    const Point &p0 = point(i, 0), &p1 = point(i, 1), &p2 = point(i, s_.degree_across(edge_) > 1 ? 2 : 1); // or any
    to[0] = p0;
    if constexpr (std::is_same_v<Number, FT>) { // coordinate by coordinate, which stays in registers
      Coordinate_vector<FT, N> b1(dimension()), b2(dimension());
      for (int k = 0; k < dimension(); ++k) {
        const std::pair<FT, FT> b = factors_(FT(coordinate(p0, k)), FT(coordinate(p1, k)), FT(coordinate(p2, k)));
        b1[k] = b.first;
        b2[k] = b.second;
      }
      to[1] = to_point<Traits>(b1);
      to[2] = to_point<Traits>(b2);
    } else {
      typedef Coordinate_vector<Number, N> Vector;
      const auto vector = [](const Point& p) { return Vector(Geometric_continuity::coordinates<Traits>(p)); };
      const std::pair<Vector, Vector> b = factors_(vector(p0), vector(p1), vector(p2));
      to[1] = to_point<Traits>(b.first.reduced());
      to[2] = to_point<Traits>(b.second.reduced());
    }
  }

  // Checks the edge, and takes note of the work.
  void check(const char* surface) const {
    const Point& corner = point(0, 0);
    bool is_point = true, vanishes = true;
    for (int i = 0; i <= s_.degree_along(edge_) && (is_point || vanishes); ++i) {
      is_point = is_point && are_equal(point(i, 0), corner);
      vanishes = vanishes && are_equal(point(i, 0), point(i, 1));
    }
    refuse_edge(is_point, vanishes, surface);
    if constexpr (is_rational_v<FT>) {
      std::size_t words = 0;
      for (const Point& p : s_)
        for (int k = 0; k < dimension(); ++k) words = (std::max)(words, number_words(FT(coordinate(p, k))));
      work_meter().charge_fractions(12. * (s_.degree_along(edge_) + 1) * dimension(), 2 * words);
    }
  }

private:
  const Point& point(int i, int j) const { return s_.control_point(edge_, i, j); }
  int dimension() const { return N == 0 ? s_.dimension() : N; } // is known to the compiler where it can be
  static decltype(auto) coordinate(const Point& p, int k) { return Traits().compute_coordinate_object()(p, k); }
  bool are_equal(const Point& p, const Point& q) const {
    for (int k = 0; k < dimension(); ++k)
      if (!CGAL::certainly(coordinate(p, k) == coordinate(q, k))) return false;
    return true;
  }
};

// The blend, if it is one of columns.
template <class Traits>
std::optional<Bezier_patch<Traits>>
blend_of_columns(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b, Patch_edge edge_b,
                 const Surface_blend_shape<typename Traits::FT>& shape, Edge_direction direction) {
  const auto is_of_numbers = [](const auto& r) {
    return is_constant(r.alpha, 0) && is_constant(r.alpha2, 0) && r.beta.is_number() && r.delta.is_number();
  };
  if (!is_of_numbers(shape.start) || !is_of_numbers(shape.end) || a.dimension() != b.dimension() ||
      a.degree_along(edge_a) != b.degree_along(edge_b) || a.degree_across(edge_a) == 0 || b.degree_across(edge_b) == 0)
    return std::nullopt;
  const Column_end<Traits> start(a, edge_a, shape.start, 1), end(b, edge_b, shape.end, -1);
  start.check("the first surface");
  end.check("the second surface");
  const int m = a.degree_along(edge_a);
  std::vector<typename Traits::Point> net(6 * static_cast<std::size_t>(m + 1));
  for (int i = 0; i <= m; ++i) {
    start(i, net.begin() + 6 * i);
    end(direction == Edge_direction::same ? i : m - i, std::make_reverse_iterator(net.begin() + 6 * i + 6));
  }
  return Bezier_patch<Traits>(m, 5, std::move(net), a.domain(edge_a));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_BLEND_OF_COLUMNS_H
