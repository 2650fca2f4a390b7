// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \file coordinates.h
/// The border between the points and vectors of a traits class, a model of `GeometricContinuityTraits`, and the columns of
/// numbers (`Coordinate_vector`) on which all formulas are written.

namespace internal {

template <class Dimension> struct Dimension_value : std::integral_constant<int, Dimension::value> {};
template <> struct Dimension_value<Dynamic_dimension_tag> : std::integral_constant<int, 0> {};

template <class Traits, class = void> struct Is_traits : std::false_type {};
template <class Traits>
struct Is_traits<Traits, std::void_t<typename Traits::Dimension,
                                     decltype(std::declval<const Traits&>().compute_coordinate_object())>>
    : std::true_type {};

// What curves and surfaces ask of their first argument, so that the compiler says at once what is wrong with it.
template <class Traits> struct Checked_traits {
  static_assert(
      Is_traits<Traits>::value,
      "the argument is no traits class: Traits_2<Kernel>, Traits_3<Kernel> and Traits_d<Kernel> are, a kernel is "
      "not; see the concept GeometricContinuityTraits");
  static_assert(
      !std::numeric_limits<typename Traits::FT>::is_integer,
      "the numbers of the kernel must be a field, such as double or Exact_rational: integers cannot be divided");
  static constexpr bool value = true;
};

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

namespace internal {

// Two opposite corners of the bounding box of the points in [first, last). \pre there is one
template <class Traits, class Iterator>
std::pair<typename Traits::Point, typename Traits::Point> corners_of_box(Iterator first, Iterator last) {
  Coordinates<Traits> low = coordinates<Traits>(*first), high = low;
  while (++first != last) {
    const Coordinates<Traits> p = coordinates<Traits>(*first);
    for (int i = 0; i < p.dimension(); ++i) {
      if (p[i] < low[i]) low[i] = p[i];
      if (high[i] < p[i]) high[i] = p[i];
    }
  }
  return {to_point<Traits>(low), to_point<Traits>(high)};
}

// The box with two such corners as `Bbox_2` or `Bbox_3`, rounded outwards.
template <class Traits> auto bbox_of(const std::pair<typename Traits::Point, typename Traits::Point>& corners) {
  constexpr int N = dimension_v<Traits>;
  static_assert(N == 2 || N == 3, "bounding_box() serves the other dimensions");
  const Coordinates<Traits> low = coordinates<Traits>(corners.first), high = coordinates<Traits>(corners.second);
  const auto lower = [&](int i) { return CGAL::to_interval(low[i]).first; };
  const auto upper = [&](int i) { return CGAL::to_interval(high[i]).second; };
  if constexpr (N == 2)
    return Bbox_2(lower(0), lower(1), upper(0), upper(1));
  else
    return Bbox_3(lower(0), lower(1), lower(2), upper(0), upper(1), upper(2));
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_COORDINATES_H
