// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DENOMINATOR_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DENOMINATOR_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Weights> bool all_positive(const Weights& weights) {
  typedef std::decay_t<decltype(*std::begin(weights))> FT;
  return std::all_of(std::begin(weights), std::end(weights), [](const FT& w) { return bool(FT(0) < w); });
}

template <class Weights> void check_finite_weights(const Weights& weights, const char* place) {
  for (const auto& w : weights) check_finite(w, place);
}

// Refuses weights with which the denominator \f$ \sum_i w_i B_i(t) \f$ is not positive for all t in
// [0, 1]. Where not all weights are positive, this is decided exactly.
template <class FT, class Weights> void check_denominator(const Weights& weights, const char* place) {
  check_finite_weights(weights, place);
  if (all_positive(weights)) return;
  const Bernstein_polynomial<FT> w(std::begin(weights), std::end(weights));
  if (sign_pattern(w) != Sign_pattern::positive) throw Error(Error_code::zero_weight, place);
}

// Refuses weights with which the denominator \f$ \sum_i w_i N_i(u) \f$ is not positive in the whole
// domain of the knots, from both sides of each knot.
template <class FT>
void check_denominator(const Knot_vector<FT>& knots, const std::vector<FT>& weights, const char* place) {
  typedef typename Exact_field<FT>::type Field;
  check_finite_weights(weights, place);
  if (all_positive(weights)) return;
  std::vector<Field> u, w;
  for (const FT& x : knots) u.push_back(to_field<Field>(x));
  for (const FT& x : weights) w.push_back(to_field<Field>(x));
  const std::vector<Field> pieces = bspline_bezier<Field>(Knot_vector<Field>(knots.degree(), std::move(u)), w);
  const std::size_t n = knots.degree() + 1;
  for (auto first = pieces.begin(); first != pieces.end(); first += n)
    check_denominator<Field>(std::vector<Field>(first, first + n), place);
}

// Halves a rational curve until all weights are positive. This ends, because the Bernstein
// coefficients of the denominator tend to its values.
template <class Curve> void add_positive_parts(const Curve& curve, int halvings, std::vector<Curve>& parts) {
  if (all_positive(curve.weights())) return parts.push_back(curve);
  if (halvings == 0) throw Error(Error_code::work_limit, "positive_parts: the denominator is too close to zero");
  typedef typename Curve::FT FT;
  const auto halves = curve.split(FT(FT(curve.domain().first + curve.domain().second) / FT(2)));
  add_positive_parts(halves.first, halvings - 1, parts);
  add_positive_parts(halves.second, halvings - 1, parts);
}

// The image of a control point under an affine map of points; that of an infinite one, a direction,
// under its linear part.
template <class Traits, class Map>
typename Traits::Point image_of_control_point(const Map& map, const typename Traits::Point& p,
                                              const typename Traits::FT& weight) {
  if (weight != typename Traits::FT(0)) return map(p);
  const Coordinates<Traits> origin(Traits().compute_dimension_object()(p));
  return to_point<Traits>(
      Geometric_continuity::coordinates<Traits>(typename Traits::Point(map(p))) -
      Geometric_continuity::coordinates<Traits>(typename Traits::Point(map(to_point<Traits>(origin)))));
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DENOMINATOR_H
