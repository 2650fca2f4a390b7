// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_KNOT_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_KNOT_CONTINUITY_H

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A curve cut at a parameter: the part on the left ends there, the part on the right starts there.
template <class Curve> struct Cut_curve {
  typedef typename Curve::Traits Traits;
  const Curve& curve;
  const typename Traits::FT& u;

  template <class Field> Coordinate_jet<Field, Curve::N> end_jet_over(int k) const {
    return curve.template left_jet_over<Field>(u, k);
  }
  template <class Field> Coordinate_jet<Field, Curve::N> start_jet_over(int k) const {
    return curve.template right_jet_over<Field>(u, k);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// What was decided about a curve at one of its inner knots.
template <class Traits> struct Knot_continuity {
  typename Traits::FT knot;                   ///< the parameter
  int multiplicity;                           ///< how often it is repeated
  Join_continuity<Predicate_FT<Traits>> join; ///< of the pieces on both sides
};

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of a B-spline curve at a parameter inside its domain, up to order `max_order`, from its jets on both
/// sides. At a knot of multiplicity `m` the curve is at least \f$ C^{p-m} \f$.
///
/// With `Exact_predicates_inexact_constructions_kernel` the control points, the knots and the parameter are taken over to an
/// exact field before anything is derived from them, so that the answer is exact for the curve as given.
/// \tparam Curve `Bspline_curve` or `Rational_bspline_curve`
/// \throws Error `parameter_outside_domain` also at the ends of the domain, `negative_count` for a negative order
template <class Curve>
Join_continuity<Predicate_FT<typename Curve::Traits>>
knot_continuity(const Curve& curve, const typename Curve::FT& knot, int max_order = 3) {
  if (knot == curve.domain().first || knot == curve.domain().second)
    throw Error(Error_code::parameter_outside_domain, "knot_continuity: an end of the domain has one side only");
  const internal::Cut_curve<Curve> cut{curve, knot};
  return continuity(cut, cut, max_order);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Decides the continuity of a B-spline curve at all its inner knots, up to order `max_order`, and returns it in increasing
/// order of the knots. One call of `knot_continuity()` for each of them.
/// \tparam Curve `Bspline_curve` or `Rational_bspline_curve`
/// \throws Error `negative_count` for a negative order
template <class Curve>
std::vector<Knot_continuity<typename Curve::Traits>> knot_continuities(const Curve& curve, int max_order = 3) {
  std::vector<Knot_continuity<typename Curve::Traits>> result;
  for (const typename Knot_vector<typename Curve::FT>::Knot& knot : curve.knots().inner_knots())
    result.push_back({knot.value, knot.multiplicity, knot_continuity(curve, knot.value, max_order)});
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_KNOT_CONTINUITY_H
