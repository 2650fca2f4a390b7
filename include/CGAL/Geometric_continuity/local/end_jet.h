// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_END_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_END_JET_H

#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <type_traits>
#include <utility>

/// \file end_jet.h
/// The jets at the two ends of any curve, in any field: all that joins and blends read of a curve. A curve that offers
/// `end_jet_over` and `start_jet_over` derives them in that field from its control points as they are, so that a predicate
/// on curves with `double` coordinates is exact. Of any other model of `ParametricCurve`, the jet that it returns is
/// converted.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Field, class Curve, class = void> struct Has_end_jets_over : std::false_type {};
template <class Field, class Curve>
struct Has_end_jets_over<Field, Curve,
                         std::void_t<decltype(std::declval<const Curve&>().template end_jet_over<Field>(0)),
                                     decltype(std::declval<const Curve&>().template start_jet_over<Field>(0))>>
    : std::true_type {};

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the point and the first `order` derivatives of a curve at the end of its domain, as numbers of `Field`.
///
/// Exact in an exact field when the curve offers `end_jet_over<Field>(order)` (see `ParametricCurve`), as all curves of this
/// package do; otherwise `curve.jet()` at the end of the domain, converted.
///
/// \tparam Field a field number type into which the numbers of the curve can be converted
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `order >= 0`
template <class Field, class Curve>
Coordinate_jet<Field, dimension_v<typename Curve::Traits>> end_jet(const Curve& curve, int order) {
  internal::check_count(order, "end_jet: order");
  if constexpr (internal::Has_end_jets_over<Field, Curve>::value)
    return curve.template end_jet_over<Field>(order);
  else
    return internal::convert_jet<Field>(curve.jet(curve.domain().second, order));
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the point and the first `order` derivatives of a curve at the start of its domain, as numbers of `Field`.
///
/// Exact in an exact field when the curve offers `start_jet_over<Field>(order)` (see `ParametricCurve`), as all curves of this
/// package do; otherwise `curve.jet()` at the start of the domain, converted.
///
/// \tparam Field a field number type into which the numbers of the curve can be converted
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `order >= 0`
template <class Field, class Curve>
Coordinate_jet<Field, dimension_v<typename Curve::Traits>> start_jet(const Curve& curve, int order) {
  internal::check_count(order, "start_jet: order");
  if constexpr (internal::Has_end_jets_over<Field, Curve>::value)
    return curve.template start_jet_over<Field>(order);
  else
    return internal::convert_jet<Field>(curve.jet(curve.domain().first, order));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_END_JET_H
