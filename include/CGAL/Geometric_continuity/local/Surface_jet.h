// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/internal/Coordinate_row.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/Scaled_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/square_root.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k` of a surface: its point and all partial derivatives
/// \f$ \partial^{i+j} S / \partial u^i \partial v^j \f$, `i + j <= k`, at one pair of parameters.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Surface_jet {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< their coordinates

  /// The zero jet of order `k` in dimension `d`. No memory is allocated up to order 2, provided
  /// that numbers do not.
  /// \throws Error `jet_order_too_low` unless `k >= 0`, `negative_count` unless `d >= 0`
  /// \throws Error `dimension_mismatch` unless `d` is the dimension of the traits class
  Surface_jet(int d, int k) : order_(k) {
    if (k < 0) throw Error(Error_code::jet_order_too_low, "Surface_jet: a jet of negative order");
    internal::check_count(d, "Surface_jet: dimension");
    partials_.resize((k + 1) * (k + 2) / 2, Coordinates(d));
  }

  /// Returns the order `k`.
  int order() const { return order_; }
  /// Returns the dimension.
  int dimension() const { return partials_[0].dimension(); }

  /// Returns the coordinates of the derivative of order `i` in `u` and `j` in `v`; of the point for
  /// `i = j = 0`.
  /// \pre `0 <= i`, `0 <= j`, `i + j <= order()`
  const Coordinates& operator()(int i, int j) const { return partials_[index(i, j)]; }
  /// Gives access to the coordinates of the derivative of order `i` in `u` and `j` in `v`; to those
  /// of the point for `i = j = 0`. \pre `0 <= i`, `0 <= j`, `i + j <= order()`
  Coordinates& operator()(int i, int j) { return partials_[index(i, j)]; }

  /// Returns the point.
  Point point() const { return Geometric_continuity::to_point<Traits>(partials_[0]); }

  /// Returns the derivative of order `i` in `u` and `j` in `v`. \pre `0 <= i`, `0 <= j`,
  /// `0 < i + j <= order()`
  Vector partial(int i, int j) const { return Geometric_continuity::to_vector<Traits>((*this)(i, j)); }

private:
  int order_;
  boost::container::small_vector<Coordinates, 6>
      partials_; // by total order, then by j; without allocation up to order 2

  static int index(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }
};

namespace internal {

template <class Traits> void require_normal(const Surface_jet<Traits>& jet) {
  static_assert(dimension_v<Traits> == 0 || dimension_v<Traits> == 3, "a surface has a normal in dimension 3");
  if (jet.dimension() != 3) throw Error(Error_code::dimension_mismatch, "normal: a surface has one in dimension 3");
  if (jet.order() < 1) throw Error(Error_code::jet_order_too_low, "normal reads the first derivatives");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the normal \f$ S_u \times S_v \f$, not normalised and hence exact with an exact kernel.
/// It is zero where the surface is not regular. Lecture slides, "Normals".
/// \throws Error `dimension_mismatch` unless in dimension 3, `jet_order_too_low` for a jet of order
///   0
/// \throws Error `not_finite` when a floating-point coordinate overflows
template <class Traits> typename Traits::Vector normal(const Surface_jet<Traits>& jet) {
  internal::require_normal(jet);
  const Geometric_continuity::Coordinates<Traits> n = cross_product(jet(1, 0), jet(0, 1));
  for (const typename Traits::FT& x : n) internal::check_finite(x, "normal");
  return Geometric_continuity::to_vector<Traits>(n);
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that have
/// a square root. Derivatives of any floating-point size are scaled, so that no product overflows.
/// \throws Error `dimension_mismatch` unless in dimension 3, `jet_order_too_low` for a jet of order
///   0
/// \throws Error `not_finite` when a floating-point derivative is infinite or undefined
template <class Traits> std::optional<typename Traits::Vector> unit_normal(const Surface_jet<Traits>& jet) {
  typedef typename Traits::FT FT;
  typedef internal::Scaled_vector<FT, dimension_v<Traits>> Scaled;
  internal::require_normal(jet);
  const Scaled u(jet(1, 0), "unit_normal"), v(jet(0, 1), "unit_normal");
  Geometric_continuity::Coordinates<Traits> n = cross_product(*u, *v);
  FT largest(0); // divided by it first, so that no square overflows or vanishes
  for (const FT& x : n) largest = (std::max)(largest, FT(CGAL::abs(x)));
  if (largest == FT(0)) return std::nullopt;
  n /= largest;
  n /= internal::square_root(FT(dot(n, n)));
  return Geometric_continuity::to_vector<Traits>(n);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The types of a surface, and its functions that evaluate jets: the base of patches and B-spline
/// surfaces, rational or not.
/// \tparam Surface the surface, with `jet(u, v, k)`
/// \tparam Traits_ a model of `GeometricContinuityTraits`
template <class Surface, class Traits_> class Surface_evaluation : public internal::Other_surface_members<Surface> {
  static_assert(internal::Checked_traits<Traits_>::value);

public:
  typedef internal::Traits_or_none<Traits_> Traits; ///< the geometric traits
  typedef typename Traits::FT FT;                   ///< the number type
  typedef typename Traits::Point Point;             ///< the points
  typedef typename Traits::Vector Vector;           ///< the vectors
  typedef std::pair<FT, FT> Interval;               ///< the two ends of a parameter interval
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = dimension_v<Traits>;

  /// Returns the derivative of order `i >= 0` in `u` and `j >= 0` in `v`; for `i = j = 0` the
  /// position vector.
  /// \throws Error `negative_count` for a negative order
  Vector partial(const FT& u, const FT& v, int i, int j) const {
    internal::check_count((std::min)(i, j), "order of a partial derivative");
    return surface().jet(u, v, i + j).partial(i, j);
  }

  /// Returns the normal \f$ S_u \times S_v \f$, not normalised; zero where the surface is not
  /// regular.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  Vector normal(const FT& u, const FT& v) const { return Geometric_continuity::normal(surface().jet(u, v, 1)); }

  /// Returns the unit normal, empty where \f$ S_u \times S_v = 0 \f$; only for number types that
  /// have a square root.
  /// \throws Error `dimension_mismatch` unless in dimension 3
  std::optional<Vector> unit_normal(const FT& u, const FT& v) const {
    return Geometric_continuity::unit_normal(surface().jet(u, v, 1));
  }

private:
  const Surface& surface() const { return static_cast<const Surface&>(*this); }
};

namespace internal {

// Refuses a jet that overflows in floating-point arithmetic, where x - x is not 0.
template <class Traits> void check_jet(const Surface_jet<Traits>& jet, const char* place) {
  if constexpr (std::is_floating_point_v<typename Traits::FT>) {
    Coordinates<Traits> zeros(jet.dimension());
    for (int i = 0; i <= jet.order(); ++i)
      for (int j = 0; i + j <= jet.order(); ++j) zeros += jet(i, j) - jet(i, j);
    for (const typename Traits::FT& x : zeros) check_finite(x, place);
  }
}

// 1 / w of the denominator w at a point.
template <class FT> FT inverse_denominator(const FT& w) {
  require_denominator(w, "the denominator of a rational surface");
  check_finite(w, "the denominator of a rational surface");
  return FT(FT(1) / w);
}

// The jet s of order 0, 1 or 2 from that of homogeneous points, see project().
template <int order, class Traits>
void project_short(const Surface_jet<Homogeneous_traits<Traits>>& p, Surface_jet<Traits>& s) {
  typedef typename Traits::FT FT;
  constexpr int M = dimension_v<Homogeneous_traits<Traits>>;
  typedef Coordinate_row<FT, M> Row;
  const int n = s.dimension();
  const auto w = [&](int k, int l) -> const FT& { return p(k, l)[n]; };
  const FT inverse = inverse_denominator(w(0, 0));
  Row zeros = coordinate_row<FT, M>(n + 1, [](int) { return FT(0); }); // see check_jet()
  const auto row = [&](int k, int l) { return coordinate_row<FT, M>(n + 1, [&](int i) { return p(k, l)[i]; }); };
  const auto write = [&](int k, int l, const Row& x) {
    if constexpr (std::is_floating_point_v<FT>) zeros += x - x;
    for (int i = 0; i < n; ++i) s(k, l)[i] = x[i];
  };
  const Row x = inverse * row(0, 0);
  write(0, 0, x);
  if constexpr (order > 0) {
    const Row u = inverse * (row(1, 0) - w(1, 0) * x), v = inverse * (row(0, 1) - w(0, 1) * x);
    write(1, 0, u);
    write(0, 1, v);
    if constexpr (order > 1) {
      const FT two(2);
      write(2, 0, inverse * (row(2, 0) - FT(two * w(1, 0)) * u - w(2, 0) * x));
      write(1, 1, inverse * (row(1, 1) - w(1, 0) * v - w(0, 1) * u - w(1, 1) * x));
      write(0, 2, inverse * (row(0, 2) - FT(two * w(0, 1)) * v - w(0, 2) * x));
    }
  }
  for (int i = 0; i < n; ++i) check_finite(zeros[i], "the jet of a rational surface");
}

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the surface \f$ S = P / w \f$ from that of its homogeneous points
/// \f$ (P, w) \f$:
/// \f$ S_{kl} = (P_{kl} - \sum_{(i,j) \ne (0,0)} \binom{k}{i} \binom{l}{j} w_{ij} S_{k-i,l-j}) / w_{00} \f$.
/// \f$ O(n k^4) \f$ for the order `k`
/// \throws Error `zero_weight` when \f$ w_{00} = 0 \f$, `not_finite` when a floating-point number
///   overflows
template <class Traits> Surface_jet<Traits> project(const Surface_jet<Homogeneous_traits<Traits>>& p) {
  typedef typename Traits::FT FT;
  const int order = p.order();
  Surface_jet<Traits> s(p.dimension() - 1, order);
  switch (order) {
  case 0: internal::project_short<0>(p, s); break;
  case 1: internal::project_short<1>(p, s); break;
  case 2: internal::project_short<2>(p, s); break;
  default: {
    const int n = s.dimension();
    const FT inverse = internal::inverse_denominator(p(0, 0)[n]);
    std::vector<std::vector<FT>> binomials;
    internal::for_each_binomial_row<FT>(
        order, [&](int k, const auto& row) { binomials.emplace_back(row.begin(), row.begin() + k + 1); });
    for (int k = 0; k <= order; ++k)
      for (int l = 0; k + l <= order; ++l)
        for (int x = 0; x < n; ++x) {
          FT sum = p(k, l)[x];
          for (int i = 0; i <= k; ++i)
            for (int j = 0; j <= l; ++j)
              if (i + j > 0) sum -= FT(binomials[k][i] * binomials[l][j]) * p(i, j)[n] * s(k - i, l - j)[x];
          s(k, l)[x] = FT(inverse * sum);
        }
    internal::check_jet(s, "the jet of a rational surface");
  }
  }
  return s;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_SURFACE_JET_H
