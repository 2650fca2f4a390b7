// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H

#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <initializer_list>
#include <iterator>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k`: the point \f$ x \f$ and the derivatives \f$ x', \dots, x^{(k)} \f$ of a curve at one
/// parameter. Blends and continuity tests read nothing else of a curve.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Curve_jet : public Coordinate_jet<typename Traits_::FT, dimension_v<Traits_>> {
  typedef Coordinate_jet<typename Traits_::FT, dimension_v<Traits_>> Base;

public:
  typedef Traits_ Traits;                 ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel

  /// The empty jet, of order -1.
  Curve_jet() = default;

  /// Takes a jet in coordinates, which are not checked.
  explicit Curve_jet(Base jet) : Base(std::move(jet)) {}

  /// The zero jet of order `k` in dimension `d`.
  /// \throws Error `negative_count` unless `k >= 0` and `d >= 0`, `dimension_mismatch` unless `d` is the dimension of the
  ///   traits class
  Curve_jet(int d, int k) : Base(d, k) {}

  // The jet with numbers that are not initialised when the dimension is known at compile time.
  Curve_jet(int d, int k, internal::Unspecified unspecified) : Base(d, k, unspecified) {}

  /// Takes the point and the range of the derivatives, lowest order first.
  /// \throws Error `dimension_mismatch` when they do not have one dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class ForwardRange>
  Curve_jet(const Point& point, const ForwardRange& derivatives)
      : Base(Traits().compute_dimension_object()(point),
             static_cast<int>(std::distance(std::begin(derivatives), std::end(derivatives)))) {
    set(0, Geometric_continuity::coordinates<Traits>(point));
    int j = 0;
    for (const Vector& v : derivatives) set(++j, Geometric_continuity::coordinates<Traits>(v));
  }
  /// Takes the point and a list of the derivatives, lowest order first.
  /// \throws Error `dimension_mismatch` when they do not have one dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  Curve_jet(const Point& point, std::initializer_list<Vector> derivatives)
      : Curve_jet(point, std::vector<Vector>(derivatives)) {}

  /// Returns the point. \pre the jet is not empty
  Point point() const { return Geometric_continuity::to_point<Traits>((*this)[0]); }

  /// Returns the `j`-th derivative. \pre `1 <= j <= order()`
  Vector derivative(int j) const { return Geometric_continuity::to_vector<Traits>((*this)[j]); }

  /// Writes the point and the derivatives, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Curve_jet& jet) {
    for (int j = 0; j <= jet.order(); ++j) {
      for (int i = 0; i < jet.dimension(); ++i) os << (i == 0 ? "" : " ") << jet[j][i];
      os << '\n';
    }
    return os;
  }

private:
  void set(int j, const Geometric_continuity::Coordinates<Traits>& c) {
    if (c.dimension() != this->dimension())
      throw Error(Error_code::dimension_mismatch, "jet: derivative " + std::to_string(j));
    for (const FT& x : c) internal::check_finite(x, "jet");
    (*this)[j] = c;
  }
};

namespace internal {

// The jet with its coordinates taken over to another field.
template <class Field, class FT, int N> Coordinate_jet<Field, N> convert_jet(const Coordinate_jet<FT, N>& jet) {
  if (jet.order() < 0) return Coordinate_jet<Field, N>();
  Coordinate_jet<Field, N> r(jet.dimension(), jet.order());
  for (int j = 0; j <= jet.order(); ++j)
    for (int i = 0; i < jet.dimension(); ++i) r[j][i] = to_field<Field>(jet[j][i]);
  return r;
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H
