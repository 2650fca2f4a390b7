// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LARGEST_KINK_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_LARGEST_KINK_H

#include "formats/font/Kink_boxes.h"
#include "formats/font/Variation_cells.h"
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Verdict.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// The largest angle of a join over all instances of a variable font: proved, not sampled.

namespace CGAL {
namespace Geometric_continuity {

/// How long the search for the largest kink is.
struct Kink_search {
  double tolerance = 0.01;      ///< the search ends when the bounds of the tangent of the angle agree up to this ratio
  double floor = 1e-5;          ///< angles (radians) below this one are not told apart
  std::size_t max_boxes = 4096; ///< how many parts of the space may be looked at; with many regions they count more
};

/// The largest angle of a join over all instances.
struct Largest_kink {
  typedef CGAL::Exact_rational FT; ///< the number type

  Verdict verdict;          ///< whether no instance has an angle larger than the bound; undecided after too much work
  Enclosure angle;          ///< the largest angle, in radians, in \f$ [0, \pi] \f$
  std::vector<FT> instance; ///< the normalised values of an instance with an angle of at least `angle.lower`
  /// A leg has no length at an instance that the search has come upon, hence no direction: the angle there is not counted.
  bool vanishes;
};

/// The largest number of axes on which a join may depend in `largest_kink()`.
constexpr int max_variable_axes = 3;

/// Returns on how many axes of the font a join depends.
inline int axes_of(const Variable_join& join, const std::vector<Variation_region>& regions,
                   const std::vector<Variation_axis>& axes) {
  return internal::Variation_cells(join, regions, axes).variables();
}

/// Encloses the largest angle between the legs of a join over all instances of a font, and decides whether it is larger than a
/// bound.
///
/// Between the numbers at which the scalars of the regions bend, the legs \f$ a \f$ and \f$ b \f$ are multi-affine in the axes, so
/// \f$ (a \cdot b, a \times b) \f$ is a polynomial curve, surface or solid of degree 2 in each axis. It lies in the cone of
/// its Bernstein coefficients; when these have positive first coordinates the largest of their ratios bounds the tangent of
/// the angle, and at the corners of the cell it is attained. The coefficients are computed exactly, then the cells with the
/// largest bound are halved, in intervals. The angle at `Largest_kink::instance` is computed exactly. A region whose scalar jumps
/// counts with the limits from both sides. `O(b)` for `b` boxes
/// \throws Error `parameter_outside_domain` for a bound that is not less than 90 degrees, `work_limit` for a join that depends on
///   more than `max_variable_axes`
inline Largest_kink largest_kink(const Variable_join& join, const std::vector<Variation_region>& regions,
                                 const std::vector<Variation_axis>& axes, const Kink_bound& bound,
                                 const Kink_search& search = Kink_search()) {
  typedef Largest_kink::FT FT;
  if (!(bound.degrees() < 90))
    throw Error(Error_code::parameter_outside_domain, "largest_kink: a bound that is not less than 90 degrees");
  const internal::Variation_cells cells(join, regions, axes);
  if (cells.variables() > max_variable_axes)
    throw Error(Error_code::work_limit,
                "largest_kink: a join that depends on " + std::to_string(cells.variables()) + " axes");
  if (cells.work() > static_cast<double>(search.max_boxes))
    return {Verdict::undecided, {0, internal::Kink_boxes::half_turn}, std::vector<FT>(axes.size(), FT(0)), false};
  internal::Kink_boxes boxes(cells.variables());
  for (std::size_t cell = 0; static_cast<double>(cell) < cells.size(); ++cell) {
    const internal::Variation_cells::Products products = cells.products(cell);
    boxes.push(cell, products.cross, products.dot);
  }
  const auto is_exceeded = [&](double tangent) { return std::isinf(tangent) || bound.is_exceeded(tangent, 1.0); };
  const auto is_done = [&] {
    const double lower = boxes.lower(), upper = boxes.upper();
    const bool near = upper <= lower * (1 + search.tolerance) || upper <= search.floor;
    return std::isinf(lower) || (near && is_exceeded(lower) == is_exceeded(upper));
  };
  while (boxes.size() < search.max_boxes && !is_done()) boxes.split();

  std::vector<FT> t; // in the unit cube of the cell
  for (double x : boxes.place()) t.push_back(FT(x));
  const std::pair<FT, FT> products = cells.products_at(boxes.cell(), t);
  Largest_kink result{
      Verdict::undecided, {0, internal::Kink_boxes::half_turn}, cells.instance(boxes.cell(), t), boxes.vanishes()};
  const double upper = boxes.upper();
  if (std::isfinite(upper)) result.angle.upper = angle_enclosure(FT(FT(upper) * FT(upper)), FT(1)).upper;
  if (products.first == 0 && products.second == 0) return result; // no corner of a cell has an angle
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
