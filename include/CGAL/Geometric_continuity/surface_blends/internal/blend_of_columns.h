// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_OF_COLUMNS_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_OF_COLUMNS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Uncertain.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/algebra/internal/Unreduced_vector.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file blend_of_columns.h
/// The blend of degree 5 of two Bézier patches of one degree along their edges, with numbers for
/// functions: each column of its control points is a sum of multiples of a column of either patch.
/// Rational numbers are computed in machine words over one denominator where they are short,
/// otherwise on unreduced fractions, and each number of the result is reduced once.

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

// The points b_1 and b_2 next to the point b_0 = p_0 of an edge: b_0 + f d_1 / 5 and b_0 + (g d_1 +
// h d_2) / 20, with the differences d_1 = p_1 - p_0 and d_2 = p_2 - 2 p_1 + p_0 of a column.
template <class Number> struct Column_factors {
  // the rounded 1/5 divides exactly what a rounded number can be divided by exactly
  Number f, g, h, fifth, twentieth;

  // Takes numbers or vectors.
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

// Computes with rational numbers in machine words, where all are short over one denominator d: (e_1
// n_0 + f (n_1 - n_0)) / (e_1 d) and (e_2 n_0 + g (n_1 - n_0) + h (n_2 - 2 n_1 + n_0)) / (e_2 d).
template <class FT> class Short_column_factors {
  typedef Rational_parts<FT> Parts;
  std::int64_t d_ = 1, f_ = 0, e1_ = 1, g_ = 0, h_ = 0, e2_ = 1;
  double largest_ = 0; // of the numbers
  bool fits_ = true;

public:
  void include(const FT& x) {
    std::int64_t n, d;
    fits_ = fits_ && Parts::short_parts(x, n, d) && include_denominator(d, d_);
    if (fits_) largest_ = (std::max)(largest_, std::abs(static_cast<double>(n)) / static_cast<double>(d));
  }
  // The numbers by which the differences are multiplied. Returns whether all that is computed is
  // short.
  bool set(const FT& f, const FT& g, const FT& h) {
    std::int64_t d = 1, other = 1;
    fits_ = fits_ && Parts::short_parts(f, f_, e1_) && Parts::short_parts(g, g_, d) && Parts::short_parts(h, h_, other);
    e2_ = d;
    if (!fits_ || !include_denominator(other, e2_)) return false;
    const auto size = [](std::int64_t x) { return std::abs(static_cast<double>(x)); };
    const double g_size = size(g_) * size(e2_ / d), h_size = size(h_) * size(e2_ / other);
    const double most = (std::max)(1., largest_) * size(d_), limit = 0x1p60;
    if (!(most * (size(e1_) + 2 * size(f_)) < limit && most * (size(e2_) + 2 * g_size + 4 * h_size) < limit))
      return false;
    g_ *= e2_ / d;
    h_ *= e2_ / other;
    return true;
  }

  std::pair<FT, FT> operator()(const FT& p0, const FT& p1, const FT& p2) const {
    const std::int64_t n0 = numerator(p0), d1 = numerator(p1) - n0, d2 = numerator(p2) - n0 - 2 * d1;
    return {Parts::make_short(e1_ * n0 + f_ * d1, e1_ * d_), Parts::make_short(e2_ * n0 + g_ * d1 + h_ * d2, e2_ * d_)};
  }

private:
  static constexpr std::int64_t most_denominator = std::int64_t(1) << 40;

  // Makes `common` a multiple of d.
  static bool include_denominator(std::int64_t d, std::int64_t& common) {
    if (common % d == 0) return true;
    const std::int64_t factor = d / std::gcd(common, d);
    if (factor > most_denominator / common) return false;
    common *= factor;
    return true;
  }
  std::int64_t numerator(const FT& x) const {
    std::int64_t n, d;
    Parts::short_parts(x, n, d);
    return n * (d_ / d);
  }
};

// One end of a blend of columns.
template <class Traits> class Column_end {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef Sum_number<FT> Number;
  static constexpr int N = dimension_v<Traits>;
  static constexpr bool is_exact = !std::is_same_v<Number, FT>;

  const Point* const corner_;
  const int degree_, dimension_;
  std::ptrdiff_t along_, second_, third_; // from a point of the net to others
  Column_factors<Number> factors_;
  std::conditional_t<is_exact, Short_column_factors<FT>, bool> short_{};
  bool is_short_ = false;

public:
  // `direction` is 1 where the blend starts, -1 where it ends.
  Column_end(const Bezier_patch<Traits>& s, Patch_edge edge, const Edge_reparametrisation<FT>& r, int direction,
             const char* surface)
      : corner_(&s.control_point(edge, 0, 0)), degree_(s.degree_along(edge)), dimension_(s.dimension()) {
    const int q = s.degree_across(edge), row = s.degree_v() + 1;
    along_ = runs_along_u(edge) ? row : 1;
    second_ = runs_along_u(edge) ? 1 : row;
    if (at_upper_end(edge)) second_ = -second_;
    third_ = q > 1 ? 2 * second_ : second_; // or any
    check(surface);
    const std::pair<FT, FT> across = runs_along_u(edge) ? s.domain_v() : s.domain_u();
    const FT length = across.second - across.first;
    const bool is_unit = length == FT(1);
    const FT beta = is_unit ? r.beta[0] : FT(r.beta[0] / length),
             delta = is_unit ? r.delta[0] : FT(r.delta[0] / length);
    // S_v = beta T and S_vv = beta^2 W + delta T, with T = -+ q d_1 and W = q (q-1) d_2
    const FT f = FT(-q) * beta, g = FT(FT(-8 * q) * beta) - FT(FT(direction * q) * delta),
             h = FT(FT(q * (q - 1)) * beta) * beta;
    if constexpr (is_exact) {
      is_short_ = short_.set(FT(f / FT(5)), FT(g / FT(20)), FT(h / FT(20)));
    }
    if (!is_short_)
      factors_ = {Number(f), Number(g), Number(h), Number(fraction<FT, 1, 5>()), Number(fraction<FT, 1, 20>())};
  }

  // Takes note of the work.
  void charge() const {
    if (is_short_) return;
    std::size_t words = 0;
    for_each_number([&](const FT& x) { words = (std::max)(words, number_words(x)); });
    work_meter().charge_fractions(12. * (degree_ + 1) * dimension(), 2 * words);
  }

  // Writes b_0, b_1 and b_2 of the column i at to[0], to[step] and to[2 * step]. Adds the products
  // of the numbers of b_1 and b_2 to `sum`, if they are of floating-point type: where the sum is
  // finite, so are they.
  void write(int i, Point* to, int step, Coordinate_vector<FT, N>& sum) const {
    const Point &p0 = corner_[i * along_], &p1 = (&p0)[second_], &p2 = (&p0)[third_];
    to[0] = p0;
    const auto by_numbers = [&](const auto& factors) {
      Coordinate_vector<FT, N> b1(dimension()), b2(dimension());
      for_each_index<N>(dimension(), [&](int k) CGAL_GC_FORCEINLINE_LAMBDA {
        std::tie(b1[k], b2[k]) = factors(FT(coordinate(p0, k)), FT(coordinate(p1, k)), FT(coordinate(p2, k)));
        if constexpr (std::is_floating_point_v<FT>) sum[k] += b1[k] * b2[k];
      });
      to[step] = to_point<Traits>(b1);
      to[2 * step] = to_point<Traits>(b2);
    };
    if constexpr (is_exact) {
      if (is_short_) return by_numbers(short_);
      const auto vector = [](const Point& p) {
        return Coordinate_vector<Number, N>(Geometric_continuity::coordinates<Traits>(p));
      };
      const auto b = factors_(vector(p0), vector(p1), vector(p2));
      to[step] = to_point<Traits>(b.first.reduced());
      to[2 * step] = to_point<Traits>(b.second.reduced());
    } else {
      by_numbers(factors_);
    }
  }

private:
  // is known to the compiler where it can be
  int dimension() const { return N == 0 ? dimension_ : N; }
  static decltype(auto) coordinate(const Point& p, int k) { return Traits().compute_coordinate_object()(p, k); }
  static bool are_equal(const Point& p, const Point& q, int dimension) {
    for (int k = 0; k < dimension; ++k)
      if (!CGAL::certainly(coordinate(p, k) == coordinate(q, k))) return false;
    return true;
  }

  // Checks the edge.
  void check(const char* surface) {
    bool is_point = true, vanishes = true;
    for (int i = 1; i <= degree_ && is_point; ++i) is_point = are_equal(corner_[i * along_], *corner_, dimension());
    for (int i = 0; i <= degree_ && vanishes; ++i)
      vanishes = are_equal(corner_[i * along_], corner_[i * along_ + second_], dimension());
    if (is_point || vanishes) refuse_edge(is_point, vanishes, surface);
    if constexpr (is_exact) for_each_number([&](const FT& x) { short_.include(x); });
  }
  template <class Function> void for_each_number(const Function& f) const {
    for (int i = 0; i <= degree_; ++i)
      for (std::ptrdiff_t j : {std::ptrdiff_t(0), second_, third_})
        for (int k = 0; k < dimension(); ++k) f(FT(coordinate(corner_[i * along_ + j], k)));
  }
};

// Returns whether the blend is one of columns.
template <class Traits>
bool is_blend_of_columns(const Bezier_patch<Traits>& a, Patch_edge edge_a, const Bezier_patch<Traits>& b,
                         Patch_edge edge_b, const Surface_blend_shape<typename Traits::FT>& shape) {
  const auto is_of_numbers = [](const auto& r) {
    return is_constant(r.alpha, 0) && is_constant(r.alpha2, 0) && r.beta.is_number() && r.delta.is_number();
  };
  return is_of_numbers(shape.start) && is_of_numbers(shape.end) && a.dimension() == b.dimension() &&
         a.degree_along(edge_a) == b.degree_along(edge_b) && a.degree_across(edge_a) > 0 && b.degree_across(edge_b) > 0;
}

// The blend.
template <class Traits> class Blended_columns {
  typedef Bezier_patch<Traits> Patch;
  typedef typename Patch::FT FT;

public:
  static Patch blend(const Patch& a, Patch_edge edge_a, const Patch& b, Patch_edge edge_b,
                     const Surface_blend_shape<FT>& shape, Edge_direction direction) {
    const Column_end<Traits> start(a, edge_a, shape.start, 1, "the first surface"),
        end(b, edge_b, shape.end, -1, "the second surface");
    if constexpr (is_rational_v<FT>) {
      const Work_guard work("blend");
      start.charge();
      end.charge();
    }
    const int m = a.degree_along(edge_a);
    std::vector<typename Traits::Point> net(6 * static_cast<std::size_t>(m + 1));
    // of two: one need not wait for the other
    Coordinates<Traits> sum(a.dimension()), sum_at_end(a.dimension());
    const bool same = direction == Edge_direction::same;
    for (int i = 0; i <= m; ++i) start.write(i, &net[6 * i], 1, sum);
    for (int i = 0; i <= m; ++i) end.write(same ? i : m - i, &net[6 * i + 5], -1, sum_at_end);
    const typename Patch::Interval across = Patch::unit_interval();
    sum += sum_at_end;
    FT of_all(0);
    for (const FT& x : sum) of_all += x;
    if (!internal::is_finite(of_all))
      // checks one point after the other
      return Patch(m, 5, std::move(net), a.domain(edge_a), across);
    return Patch(typename Patch::Net(m + 1, 6, std::move(net)), a.domain(edge_a), across,
                 typename Patch::Correct_by_construction());
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_BLEND_OF_COLUMNS_H
