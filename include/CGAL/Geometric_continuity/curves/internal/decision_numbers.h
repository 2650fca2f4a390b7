// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DECISION_NUMBERS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DECISION_NUMBERS_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The exact field for the numbers of a kernel, that of its predicates and never a rounded one; and
// the type of its values.
template <class Traits> using Decision_FT = typename Exact_field<Predicate_FT<Traits>>::type;
template <class Traits> using Decision_number = typename Exact_number<Decision_FT<Traits>>::type;

// A number of a kernel as a value of that type.
template <class Traits, class FT> Decision_number<Traits> decision_number(const FT& x) {
  typedef Decision_FT<Traits> Field;
  return Exact_number<Field>::of(to_field<Field>(x));
}

// The coordinates of points as such values.
template <class Traits, class Points>
std::vector<Coordinate_vector<Decision_number<Traits>, dimension_v<Traits>>> decision_rows(const Points& points) {
  std::vector<Coordinate_vector<Decision_number<Traits>, dimension_v<Traits>>> rows;
  for (const typename Traits::Point& p : points) {
    const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(p);
    rows.emplace_back(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) rows.back()[i] = decision_number<Traits>(x[i]);
  }
  return rows;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_DECISION_NUMBERS_H
