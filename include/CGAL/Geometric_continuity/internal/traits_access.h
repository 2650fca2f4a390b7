// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TRAITS_ACCESS_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TRAITS_ACCESS_H

#include <CGAL/Dimension.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/to_field.h>

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The dimension of a traits class at compile time, 0 when known at run time only.
template <class Dimension> struct Dimension_value : std::integral_constant<int, Dimension::value> {};
template <> struct Dimension_value<Dynamic_dimension_tag> : std::integral_constant<int, 0> {};
template <class Traits> constexpr int dimension_v = Dimension_value<typename Traits::Dimension>::value;

template <class Traits> using Coordinates = Coordinate_vector<typename Traits::FT, dimension_v<Traits>>;

// The field in which predicates are decided: Traits::Predicate_FT where the traits class has one.
template <class Traits, class = void> struct Predicate_field { typedef typename Traits::FT type; };
template <class Traits> struct Predicate_field<Traits, std::void_t<typename Traits::Predicate_FT>> {
  typedef typename Traits::Predicate_FT type;
};
template <class Traits> using Predicate_FT = typename Predicate_field<Traits>::type;

// Coordinates of a point or a vector of the traits class, in its own field or in `Field`.
template <class Traits, class Field = typename Traits::FT, class Point_or_vector>
Coordinate_vector<Field, dimension_v<Traits>> coordinates(const Point_or_vector& p) {
  const Traits traits;
  const int d = traits.compute_dimension_object()(p);
  Coordinate_vector<Field, dimension_v<Traits>> c(d);
  for (int i = 0; i < d; ++i) c[i] = to_field<Field>(typename Traits::FT(traits.compute_coordinate_object()(p, i)));
  return c;
}

template <class Traits> typename Traits::Point to_point(const Coordinates<Traits>& c) {
  return Traits().construct_point_object()(c.dimension(), c.begin(), c.end());
}

template <class Traits> typename Traits::Vector to_vector(const Coordinates<Traits>& c) {
  return Traits().construct_vector_object()(c.dimension(), c.begin(), c.end());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_TRAITS_ACCESS_H
