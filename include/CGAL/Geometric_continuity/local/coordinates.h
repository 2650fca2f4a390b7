// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <CGAL/Dimension.h>

#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {

/// \file coordinates.h
/// The border between the points and vectors of a traits class, a model of `GeometricContinuityTraits`, and the columns of
/// numbers (`Coordinate_vector`) on which all formulas are written.

namespace internal {

template <class Dimension> struct Dimension_value : std::integral_constant<int, Dimension::value> {};
template <> struct Dimension_value<Dynamic_dimension_tag> : std::integral_constant<int, 0> {};

template <class Traits, class = void> struct Predicate_field { typedef typename Traits::FT type; };
template <class Traits> struct Predicate_field<Traits, std::void_t<typename Traits::Predicate_FT>> {
  typedef typename Traits::Predicate_FT type;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The dimension of a traits class when it is known at compile time, otherwise 0.
template <class Traits> constexpr int dimension_v = internal::Dimension_value<typename Traits::Dimension>::value;

/// \ingroup PkgGeometricContinuityTraits
/// The coordinates of a point or a vector of the traits class, as a column.
template <class Traits> using Coordinates = Coordinate_vector<typename Traits::FT, dimension_v<Traits>>;

/// \ingroup PkgGeometricContinuityTraits
/// The field in which predicates are decided: `Traits::Predicate_FT` where the traits class has one, otherwise `Traits::FT`.
template <class Traits> using Predicate_FT = typename internal::Predicate_field<Traits>::type;

/// \ingroup PkgGeometricContinuityTraits
/// Returns the coordinates of a point or a vector `p` of the traits class, in its own field or converted to `Field`.
/// \throws Error `not_finite` when a coordinate that is converted is an infinity or not a number
template <class Traits, class Field = typename Traits::FT, class Point_or_vector>
Coordinate_vector<Field, dimension_v<Traits>> coordinates(const Point_or_vector& p) {
  const Traits traits;
  const int d = traits.compute_dimension_object()(p);
  Coordinate_vector<Field, dimension_v<Traits>> c(d);
  for (int i = 0; i < d; ++i)
    c[i] = internal::to_field<Field>(typename Traits::FT(traits.compute_coordinate_object()(p, i)));
  return c;
}

/// \ingroup PkgGeometricContinuityTraits
/// Returns the point with the coordinates `c`.
template <class Traits> typename Traits::Point to_point(const Coordinates<Traits>& c) {
  return Traits().construct_point_object()(c.dimension(), c.begin(), c.end());
}

/// \ingroup PkgGeometricContinuityTraits
/// Returns the vector with the coordinates `c`.
template <class Traits> typename Traits::Vector to_vector(const Coordinates<Traits>& c) {
  return Traits().construct_vector_object()(c.dimension(), c.begin(), c.end());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H
