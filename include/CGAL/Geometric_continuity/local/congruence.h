// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H

#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file congruence.h
/// The isometry that takes one jet to another, decided by dot products and a determinant. Hagen 1.7
/// (a).

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A map \f$ x \mapsto B x + t \f$ of points of \f$ E^n \f$ with an orthogonal matrix `B` of
/// determinant 1. Vectors are mapped by `B`, jets as a whole. Floating-point images are rounded,
/// and not checked for overflow.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Isometry {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< their coordinates

  /// Takes the `n` rows of `B`, whose orthogonality is not checked, and `t`.
  /// \throws Error `dimension_mismatch` unless all rows and `t` have the dimension `n`
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  Isometry(std::vector<Coordinates> rows, const Coordinates& t) : rows_(std::move(rows)), t_(t) {
    check(t_);
    for (const Coordinates& row : rows_) check(row);
  }

  /// Returns the dimension `n`.
  int dimension() const { return static_cast<int>(rows_.size()); }

  /// Returns the entry of `B` in row `i` and column `j`. \pre `0 <= i < dimension()`,
  /// `0 <= j < dimension()`
  const FT& entry(int i, int j) const { return rows_[i][j]; }

  /// Returns the vector `t`.
  Vector translation() const { return Geometric_continuity::to_vector<Traits>(t_); }

  /// Returns the image \f$ B p + t \f$ of a point. \f$ O(n^2) \f$ \throws Error
  /// `dimension_mismatch`
  Point operator()(const Point& p) const {
    return Geometric_continuity::to_point<Traits>(linear(Geometric_continuity::coordinates<Traits>(p)) + t_);
  }
  /// Returns the image \f$ B v \f$ of a vector. \f$ O(n^2) \f$ \throws Error `dimension_mismatch`
  Vector operator()(const Vector& v) const {
    return Geometric_continuity::to_vector<Traits>(linear(Geometric_continuity::coordinates<Traits>(v)));
  }
  /// Returns the jet of the moved curve. \f$ O(n^2 k) \f$ for order `k` \throws Error
  /// `dimension_mismatch`
  Curve_jet<Traits> operator()(const Curve_jet<Traits>& x) const {
    Curve_jet<Traits> y = x;
    for (int j = 0; j <= x.order(); ++j) y[j] = linear(x[j]);
    if (x.order() >= 0) y[0] += t_;
    return y;
  }

  /// Writes the rows of `(B | t)`, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Isometry& map) {
    for (int i = 0; i < map.dimension(); ++i) {
      for (const FT& x : map.rows_[i]) os << x << ' ';
      os << map.t_[i] << '\n';
    }
    return os;
  }

private:
  std::vector<Coordinates> rows_;
  Coordinates t_;

  void check_dimension(const Coordinates& v) const {
    if (v.dimension() != dimension())
      throw Error(Error_code::dimension_mismatch, "Isometry of dimension " + std::to_string(dimension()));
  }
  void check(const Coordinates& v) const {
    check_dimension(v);
    for (const FT& x : v) internal::check_finite(x, "Isometry");
  }

  Coordinates linear(const Coordinates& v) const {
    check_dimension(v);
    Coordinates r(dimension());
    for (int i = 0; i < dimension(); ++i) r[i] = dot(rows_[i], v);
    return r;
  }
};

namespace internal {

// The derivatives of a jet, each divided by a power of two when their numbers are rounded.
template <class FT, int N> struct Scaled_derivatives {
  std::vector<Coordinate_vector<FT, N>> vectors; // from the first derivative on
  std::vector<int> exponents;

  Scaled_derivatives(const Coordinate_jet<FT, N>& jet, int k) {
    for (int j = 1; j <= k; ++j) {
      const Scaled_vector<FT, N> x(jet[j], "congruence");
      vectors.push_back(*x);
      exponents.push_back(x.exponent());
    }
  }

  // The frame of the first n-1.
  std::vector<Coordinate_vector<FT, N>> frame(int n) const {
    const std::optional<std::vector<Coordinate_vector<FT, N>>> e =
        frenet_vectors(std::vector<Coordinate_vector<FT, N>>(vectors.begin(), vectors.begin() + (n - 1)));
    if (!e) throw Error(Error_code::singular_frame, "congruence: the first n-1 derivatives are linearly dependent");
    return *e;
  }
};

// Scales the derivatives y and their frame f by the powers of two by which x is scaled. The largest
// coordinates of vectors of equal length differ by a factor of sqrt(n) at most: false when they
// differ by much more.
template <class FT, int N>
bool adopt_scale(const Scaled_derivatives<FT, N>& x, Scaled_derivatives<FT, N>& y,
                 std::vector<Coordinate_vector<FT, N>>& f) {
  int sum = 0;
  for (std::size_t j = 0; j < y.vectors.size(); ++j) {
    const int shift = y.exponents[j] - x.exponents[j];
    if (shift < -32 || 32 < shift) return false;
    y.vectors[j] = times_power_of_two(y.vectors[j], shift, "congruence");
    if (j + 1 >= f.size()) continue;
    f[j] = times_power_of_two(f[j], shift, "congruence");
    sum += shift;
  }
  f.back() = times_power_of_two(f.back(), sum, "congruence");
  return true;
}

// Decides whether an isometry that preserves orientation takes the vectors x to the vectors y, the
// first n-1 of which are independent. The others are then given by their dot products with these,
// and by their determinant with these, which is their dot product with the last vector of the
// frame.
template <class FT, int N>
bool has_equal_invariants(const std::vector<Coordinate_vector<FT, N>>& x,
                          const std::vector<Coordinate_vector<FT, N>>& y, const Coordinate_vector<FT, N>& last_x,
                          const Coordinate_vector<FT, N>& last_y) {
  const int n = last_x.dimension(), k = static_cast<int>(x.size());
  for (int b = 0; b < k; ++b)
    for (int a = 0; a <= b && a < n - 1; ++a)
      if (dot(x[a], x[b]) != dot(y[a], y[b])) return false;
  for (int j = n - 1; j < k; ++j)
    if (dot(last_x, x[j]) != dot(last_y, y[j])) return false;
  return true;
}

// A number of the predicates, rounded where the constructions are.
template <class FT, class Field> FT rounded_entry(const Field& x) {
  if constexpr (std::is_same_v<FT, Field>)
    return x;
  else
    return FT(CGAL::to_double(x));
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the isometry that preserves orientation and takes the jet `x` to the jet `y`, up to the
/// order that both have; empty when there is none. With the Frenet frames \f$ e_i \f$ and
/// \f$ f_i \f$ of the jets as orthogonal vectors, \f$ |e_i| = |f_i| \f$ and
/// \f$ B v = \sum_i \frac{e_i \cdot v}{e_i \cdot e_i} f_i \f$, so that no root is needed. Hagen 1.7
/// (a), where "unique" needs "that preserves orientation": a mirrored curve has the opposite last
/// curvature.
///
/// If two curves have equal speed and equal curvatures in an interval, their jets at each parameter
/// are congruent, by one and the same map. Jets of order `n - 1` in \f$ E^n \f$ do not see the last
/// curvature.
///
/// The decision is exact with every exact kernel and with
/// `Exact_predicates_inexact_constructions_kernel`, with which the map is computed exactly and its
/// numbers are rounded; it is plain floating point with `Simple_cartesian<double>`, where rounding
/// makes most pairs of congruent jets differ. \f$ O(n^2 k + n^4) \f$ field operations for jets of
/// order `k`.
///
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` with fewer
///   than `n - 1` derivatives
/// \throws Error `singular_frame` when the first `n - 1` derivatives of one of the jets are
///   linearly dependent (lines, and in space points without curvature)
/// \throws Error `not_finite` when a floating-point number of a jet or of the translation is
///   infinite or undefined
template <class Traits>
std::optional<Isometry<Traits>> congruence(const Curve_jet<Traits>& x, const Curve_jet<Traits>& y) {
  typedef typename Traits::FT FT;
  typedef Predicate_FT<Traits> Field;
  constexpr int N = dimension_v<Traits>;
  const int n = x.dimension(), k = (std::min)(x.order(), y.order());
  if (n != y.dimension()) throw Error(Error_code::dimension_mismatch, "congruence of two jets");
  if (k < (std::max)(n - 1, 0)) throw Error(Error_code::jet_order_too_low, "congruence of two jets");
  const Coordinate_jet<Field, N> jet_x = internal::convert_jet<Field>(x), jet_y = internal::convert_jet<Field>(y);
  const internal::Scaled_derivatives<Field, N> u(jet_x, k);
  internal::Scaled_derivatives<Field, N> v(jet_y, k);
  const std::vector<Coordinate_vector<Field, N>> e = u.frame(n);
  std::vector<Coordinate_vector<Field, N>> f = v.frame(n);
  if (!internal::adopt_scale(u, v, f) || !internal::has_equal_invariants(u.vectors, v.vectors, e.back(), f.back()))
    return std::nullopt;

  std::vector<Coordinate_vector<Field, N>> rows(n, Coordinate_vector<Field, N>(n));
  for (int i = 0; i < n; ++i) {
    const Coordinate_vector<Field, N> dual = e[i] / Field(dot(e[i], e[i]));
    for (int row = 0; row < n; ++row) rows[row] += f[i][row] * dual;
  }
  std::vector<Geometric_continuity::Coordinates<Traits>> entries(n, Geometric_continuity::Coordinates<Traits>(n));
  Geometric_continuity::Coordinates<Traits> t(n);
  for (int row = 0; row < n; ++row) {
    for (int i = 0; i < n; ++i) entries[row][i] = internal::rounded_entry<FT>(rows[row][i]);
    t[row] = internal::rounded_entry<FT>(Field(jet_y[0][row] - dot(rows[row], jet_x[0])));
  }
  return Isometry<Traits>(std::move(entries), t);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H
