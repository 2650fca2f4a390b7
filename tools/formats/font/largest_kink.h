// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LARGEST_KINK_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LARGEST_KINK_H

#include "formats/font/Kink_boxes.h"
#include "formats/font/Variable_join.h"
#include "formats/font/Variation_cells.h"
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file largest_kink.h
/// The largest angle of a join over all instances of a family of shapes: proved, not sampled.

namespace CGAL {
namespace Geometric_continuity {

/// How long the search for the largest kink is.
struct Kink_search {
  /// the search ends when the bounds of the tangent of the angle agree up to this ratio
  double tolerance = 0.01;
  double floor = 1e-5; ///< angles (radians) below this one are not told apart
  Work_limit limit =
      /// the work, beyond which the search ends as well: about a twentieth of a second
      Work_limit(50'000'000);
};

/// The largest angle of a join over all instances.
struct Largest_kink {
  typedef Variable_join::FT FT; ///< the number type

  /// whether no instance has an angle larger than the bound; undecided after too much work
  Verdict verdict;
  Enclosure angle;          ///< the largest angle, in radians, in \f$ [0, \pi] \f$
  std::vector<FT> instance; ///< the values of an instance with an angle of at least `angle.lower`
  /// A side has no length at an instance that the search has come upon, hence no direction: the
  /// angle there is not counted.
  bool vanishes;
};

/// Encloses the largest angle between the sides of a join over all instances, and decides whether
/// it is larger than a bound.
///
/// Between the numbers at which the scalars of the regions bend, the sides \f$ a \f$ and \f$ b \f$
/// are multi-affine in the axes, so \f$ (a \cdot b, a \times b) \f$ is a polynomial of degree 2 in
/// each axis on which the join depends. It lies in the cone of its Bernstein coefficients; when
/// these have positive first coordinates the largest of their ratios bounds the tangent of the
/// angle, and at the corners of the cell it is attained. The coefficients are computed exactly,
/// then the cells with the largest bound are halved, in intervals. Their number grows like
/// \f$ 3^m \f$; with more than four axes a part of the space has a form of second order around its
/// middle instead, and axes along which the angle rises or falls there count no more: the largest
/// angle lies at one of their ends. The angle at `Largest_kink::instance` is computed exactly. A
/// region whose scalar jumps counts with the limits from both sides. The time is at most that of
/// the work that is allowed
/// \param axes one for each axis of the regions
/// \throws Error `parameter_outside_domain` for a bound that is not less than 90 degrees
inline Largest_kink largest_kink(const Variable_join& join, const std::vector<Variation_region>& regions,
                                 const std::vector<Variation_range>& axes, const Corner_threshold& bound,
                                 const Kink_search& search = Kink_search()) {
  typedef Largest_kink::FT FT;
  if (!(bound.degrees() < 90))
    throw Error(Error_code::parameter_outside_domain, "largest_kink: a bound that is not less than 90 degrees");
  const Variation_cells cells(join, regions, axes);
  Kink_boxes boxes(cells);
  const double limit = static_cast<double>(search.limit.steps());
  std::size_t cell = 0;
  for (; static_cast<double>(cell) < cells.size() && boxes.steps() < limit; ++cell) boxes.push(cell);
  const bool complete = static_cast<double>(cell) == cells.size();
  const auto is_exceeded = [&](double tangent) { return std::isinf(tangent) || bound.is_exceeded(tangent, 1.0); };
  const auto is_done = [&] {
    const double lower = boxes.lower(), upper = boxes.upper();
    const bool narrow = upper <= lower * (1 + search.tolerance) || upper <= search.floor;
    return std::isinf(lower) || (narrow && is_exceeded(lower) == is_exceeded(upper));
  };
  while (complete && !boxes.empty() && boxes.steps() < limit && !is_done()) boxes.split();

  const std::pair<FT, FT> products = cells.products_at(boxes.cell(), boxes.point());
  Largest_kink result{
      Verdict::undecided, {0, Kink_boxes::half_turn}, cells.instance(boxes.cell(), boxes.point()), boxes.vanishes()};
  const double upper = complete ? boxes.upper() : INFINITY;
  if (std::isfinite(upper)) result.angle.upper = angle_enclosure(FT(FT(upper) * FT(upper)), FT(1)).upper;
  // no corner of a cell has an angle
  if (products.first == 0 && products.second == 0) return result;
  result.angle.lower = angle_enclosure(FT(products.first * products.first), products.second).lower;
  if (bound.is_exceeded(products.first, products.second))
    result.verdict = Verdict::refuted;
  else if (!is_exceeded(upper))
    result.verdict = Verdict::proved;
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LARGEST_KINK_H
