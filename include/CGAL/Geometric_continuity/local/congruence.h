// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H

#include <CGAL/Geometric_continuity/local/Frenet_frame.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A map \f$ x \mapsto B x + t \f$ of points of \f$ E^n \f$ with an orthogonal matrix `B` of determinant 1. Vectors are
/// mapped by `B`, jets as a whole.
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Isometry {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;

  /// From the `n` rows of `B`, whose orthogonality is not checked, and `t`.
  Isometry(std::vector<Coordinates> rows, const Coordinates& t) : rows_(std::move(rows)), t_(t) {}

  int dimension() const { return static_cast<int>(rows_.size()); }

  /// The entry of `B` in row `i` and column `j`, from 0 on.
  const FT& entry(int i, int j) const { return rows_[i][j]; }

  /// The vector `t`.
  Vector translation() const { return Geometric_continuity::to_vector<Traits>(t_); }

  Point operator()(const Point& p) const {
    return Geometric_continuity::to_point<Traits>(linear(Geometric_continuity::coordinates<Traits>(p)) + t_);
  }
  Vector operator()(const Vector& v) const {
    return Geometric_continuity::to_vector<Traits>(linear(Geometric_continuity::coordinates<Traits>(v)));
  }
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

  Coordinates linear(const Coordinates& v) const {
    Coordinates r(dimension());
    for (int i = 0; i < dimension(); ++i) r[i] = dot(rows_[i], v);
    return r;
  }
};

namespace internal {

// det(x', ..., x^(n-1), x^(j)) in dimension n
template <class FT, int N> FT determinant_with(const Coordinate_jet<FT, N>& x, int j) {
  const int n = x.dimension();
  return determinant<FT>(
      n, [&](int row, int column) -> const FT& { return row < n - 1 ? x[row + 1][column] : x[j][column]; });
}

// Decides up to order k whether an isometry that preserves orientation takes the derivatives of x to those of y. The
// first n-1 are independent. The others are then given by their dot products with these and by a determinant.
template <class FT, int N>
bool has_equal_invariants(const Coordinate_jet<FT, N>& x, const Coordinate_jet<FT, N>& y, int k) {
  const int n = x.dimension();
  for (int b = 1; b <= k; ++b)
    for (int a = 1; a <= std::min(b, n - 1); ++a)
      if (dot(x[a], x[b]) != dot(y[a], y[b])) return false;
  for (int j = n; j <= k; ++j)
    if (determinant_with(x, j) != determinant_with(y, j)) return false;
  return true;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// The isometry `B` that preserves orientation and takes the jet `x` to the jet `y`, up to the order that both have;
/// empty when there is none. With the Frenet frames \f$ e_i \f$ and \f$ f_i \f$ of the jets as orthogonal vectors,
/// \f$ |e_i| = |f_i| \f$ and \f$ B v = \sum_i \frac{e_i \cdot v}{e_i \cdot e_i} f_i \f$, so that no root is needed.
/// Hagen 1.7 (a), where "unique" needs "that preserves orientation": a mirrored curve has the opposite last curvature.
///
/// If two curves have equal speed and equal curvatures in an interval, their jets at each parameter are congruent, by one
/// and the same map. Jets of order `n - 1` in \f$ E^n \f$ do not see the last curvature.
///
/// The decision is exact with every exact kernel and with `Exact_predicates_inexact_constructions_kernel`, with which the
/// numbers of the map are rounded; it is plain floating point with `Simple_cartesian<double>`, where rounding makes
/// most pairs of congruent jets differ. \f$ O(n^2 k + k n 2^n) \f$ field operations for jets of order `k`.
///
/// \throws Error `dimension_mismatch` when the dimensions differ, `jet_order_too_low` with fewer than `n - 1` derivatives,
///   `singular_frame` when the first `n - 1` derivatives of one of the jets are linearly dependent (lines, and in space points
///   without curvature)
template <class Traits>
std::optional<Isometry<Traits>> congruence(const Curve_jet<Traits>& x, const Curve_jet<Traits>& y) {
  typedef typename Traits::FT FT;
  typedef Predicate_FT<Traits> Field;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  constexpr int N = dimension_v<Traits>;
  const int n = x.dimension(), k = std::min(x.order(), y.order());
  if (n != y.dimension()) throw Error(Error_code::dimension_mismatch, "congruence of two jets");
  if (k < std::max(n - 1, 0)) throw Error(Error_code::jet_order_too_low, "congruence of two jets");
  const Coordinate_jet<Field, N> exact_x = internal::convert_jet<Field>(x), exact_y = internal::convert_jet<Field>(y);
  const std::optional<Frenet_frame<Traits>> e = frenet_frame(x), f = frenet_frame(y);
  if (!e || !f || internal::gram_of_derivatives(exact_x, n - 1) == Field(0) ||
      internal::gram_of_derivatives(exact_y, n - 1) == Field(0))
    throw Error(Error_code::singular_frame, "congruence: the first n-1 derivatives are linearly dependent");
  if (!internal::has_equal_invariants(exact_x, exact_y, k)) return std::nullopt;

  std::vector<Coordinates> rows(n, Coordinates(n));
  for (int i = 1; i <= n; ++i) {
    const Coordinates dual = e->coordinates(i) / FT(dot(e->coordinates(i), e->coordinates(i)));
    for (int row = 0; row < n; ++row) rows[row] += f->coordinates(i)[row] * dual;
  }
  Coordinates t = y[0];
  for (int row = 0; row < n; ++row) t[row] -= dot(rows[row], x[0]);
  return Isometry<Traits>(std::move(rows), t);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CONGRUENCE_H
