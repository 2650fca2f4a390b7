// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_END_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_END_JETS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <string>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityLocal
/// The jets at the two ends of a curve, in place of the curve: all that decisions about joins read. `continuity()`, `deviation()`,
/// `order_within()` and `Chain_analysis` take it like a curve, up to the order of the jets.
///
/// \tparam Traits_ a model of `GeometricContinuityTraits`
template <class Traits_> class Curve_end_jets {
  static constexpr int N = dimension_v<Traits_>;
  typedef Coordinate_jet<typename Traits_::FT, N> Jet;

public:
  typedef Traits_ Traits;         ///< the traits class
  typedef typename Traits::FT FT; ///< the field

  /// Takes the jets at the start and the end, of one order.
  /// \throws Error `dimension_mismatch`, `jet_order_too_low` when the orders differ or the jets are empty
  Curve_end_jets(Jet start, Jet end) : start_(std::move(start)), end_(std::move(end)) {
    if (start_.dimension() != end_.dimension()) throw Error(Error_code::dimension_mismatch, "Curve_end_jets");
    if (start_.order() != end_.order() || end_.order() < 0)
      throw Error(Error_code::jet_order_too_low,
                  "Curve_end_jets: " + std::to_string(start_.order()) + " and " + std::to_string(end_.order()));
  }
  /// Takes the jets of order `k` of a curve. \throws Error `negative_count` unless `k >= 0`
  template <class Curve>
  Curve_end_jets(const Curve& curve, int k) : Curve_end_jets(Jet(curve.start_jet(k)), Jet(curve.end_jet(k))) {}

  /// Returns the dimension of the space.
  int dimension() const { return end_.dimension(); }
  /// Returns the order of the jets.
  int order() const { return end_.order(); }

  /// Returns the jet of order `k` at the start. \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }
  /// Returns the jet of order `k` at the end. \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }
  /// Returns the jet of order `k` at the start in another field.
  /// \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const { return part<Field>(start_, k); }
  /// Returns the jet of order `k` at the end in another field.
  /// \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const { return part<Field>(end_, k); }

private:
  Jet start_, end_;

  template <class Field> static Coordinate_jet<Field, N> part(const Jet& jet, int k) {
    internal::check_count(k, "Curve_end_jets: order");
    if (k > jet.order())
      throw Error(Error_code::jet_order_too_low, "Curve_end_jets: " + std::to_string(k) + " is asked for, " +
                                                     std::to_string(jet.order()) + " is there");
    Coordinate_jet<Field, N> r(jet.dimension(), k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < jet.dimension(); ++i) r[j][i] = internal::to_field<Field>(jet[j][i]);
    return r;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_END_JETS_H
