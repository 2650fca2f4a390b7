// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRAITS_H
#define CGAL_GEOMETRIC_CONTINUITY_TRAITS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/kernel_access.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Dimension.h>
#include <CGAL/number_utils.h>

#include <limits>
#include <type_traits>
#include <utility>

/// \file Traits.h
/// The names of the types of a kernel: the traits classes for kernels of CGAL, models of
/// `GeometricContinuityTraits`; the border between the points and vectors of a traits class and the
/// columns of numbers (`Coordinate_vector`) on which all formulas are written; and homogeneous
/// points \f$ (p, w) = (w x, w) \f$, of one dimension more: rational curves and surfaces are
/// polynomial ones of such points.

namespace CGAL {

// A type of CGAL that is declared here and not defined, so that Eigen is not needed. It does not
// name its exact field.
template <class Dimension> struct Epick_d;

namespace Geometric_continuity {

namespace internal {

template <class K> struct Predicate_field_d { typedef typename K::FT type; };
template <class Dimension> struct Predicate_field_d<Epick_d<Dimension>> {
  typedef typename Exact_field_of<typename Epick_d<Dimension>::FT>::type type;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves of dimension 2 over a CGAL kernel, with the types and functions of
/// `GeometricContinuityTraits`.
///
/// With `Exact_predicates_inexact_constructions_kernel` predicates are decided in
/// `Exact_field<double>::type` on the coordinates as given; with every other kernel they are
/// decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel`
/// \cgalModels{GeometricContinuityTraits}
template <class K> class Traits_2 : public internal::Kernel_traits<K, typename K::Point_2, typename K::Vector_2, 2> {};

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves of dimension 3 over a CGAL kernel, with the types and functions of
/// `GeometricContinuityTraits`.
///
/// With `Exact_predicates_inexact_constructions_kernel` predicates are decided in
/// `Exact_field<double>::type` on the coordinates as given; with every other kernel they are
/// decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel`
/// \cgalModels{GeometricContinuityTraits}
template <class K> class Traits_3 : public internal::Kernel_traits<K, typename K::Point_3, typename K::Vector_3, 3> {};

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for curves whose dimension is known at run time, over a dD kernel such as
/// `Cartesian_d<FT>`, `Epick_d<Dynamic_dimension_tag>` or `Epeck_d<Dynamic_dimension_tag>` (the
/// last two need Eigen).
///
/// With `Epick_d` predicates are decided in `Exact_field<double>::type` on the coordinates as
/// given; with every other kernel they are decided in the field of the kernel.
///
/// \tparam K a model of the CGAL concept `Kernel_d`
/// \cgalModels{GeometricContinuityTraits}
template <class K> class Traits_d {
public:
  typedef K Kernel;                        ///< the kernel
  typedef typename K::FT FT;               ///< its numbers, in which constructions are made
  typedef typename K::Point_d Point;       ///< its points
  typedef typename K::Vector_d Vector;     ///< its vectors
  typedef Dynamic_dimension_tag Dimension; ///< the dimension of the space
  /// The field in which predicates are decided.
  typedef typename internal::Predicate_field_d<K>::type Predicate_FT;

  /// Returns the number of coordinates of a point or a vector.
  struct Compute_dimension {
    int operator()(const Point& p) const { return static_cast<int>(p.dimension()); }
    int operator()(const Vector& v) const { return static_cast<int>(v.dimension()); }
  };
  /// Returns the coordinate number `i` of a point or a vector.
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return p[i]; }
    FT operator()(const Vector& v, int i) const { return v[i]; }
  };
  /// Constructs a point from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return Point(d, first, last);
    }
  };
  /// Constructs a vector from a range of coordinates.
  struct Construct_vector {
    template <class RandomAccessIterator>
    Vector operator()(int d, RandomAccessIterator first, RandomAccessIterator last) const {
      return Vector(d, first, last);
    }
  };

  /// Returns the function object `Compute_dimension`.
  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  /// Returns the function object `Compute_coordinate`.
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  /// Returns the function object `Construct_point`.
  Construct_point construct_point_object() const { return Construct_point(); }
  /// Returns the function object `Construct_vector`.
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

namespace internal {

template <class Dimension> struct Dimension_value : std::integral_constant<int, Dimension::value> {};
template <> struct Dimension_value<Dynamic_dimension_tag> : std::integral_constant<int, 0> {};

template <class Traits, class = void> struct Is_traits : std::false_type {};
template <class Traits>
struct Is_traits<Traits, std::void_t<typename Traits::Dimension,
                                     decltype(std::declval<const Traits&>().compute_coordinate_object())>>
    : std::true_type {};

// Replaces an argument that is no traits class. It models all requirements on one, so that the
// compiler has nothing else to complain about.
struct No_traits {
  typedef double FT;
  struct Point {
    template <class... Anything> Point(Anything&&...) {}
    // unreachable: of an archetype, which is only compiled
    friend bool operator==(const Point&, const Point&) { return true; }
  };
  typedef Point Vector;
  typedef Dimension_tag<2> Dimension;
  // unreachable: of an archetype, which is only compiled
  auto compute_dimension_object() const {
    return [](const Point&) { return 2; };
  }
  auto compute_coordinate_object() const {
    return [](const Point&, int) -> FT { return 0; };
  }
  auto construct_point_object() const {
    return [](int, auto, auto) { return Point(); };
  }
  auto construct_vector_object() const { return construct_point_object(); }
};

// Curves and surfaces check their first argument with this class, so that the compiler reports at
// once what is wrong with it, and continue with its member.
template <class T> struct Checked_traits {
  static_assert(
      Is_traits<T>::value,
      "the argument is no traits class: Traits_2<Kernel>, Traits_3<Kernel> and Traits_d<Kernel> are, a kernel is "
      "not; write e.g. Bezier_curve<Traits_2<Kernel>>");
  static_assert(
      !std::numeric_limits<typename T::FT>::is_integer,
      "the numbers of the kernel must be a field, such as double or Exact_rational: integers cannot be divided");
  static constexpr bool value = true;
};
template <class T> using Traits_or_none = std::conditional_t<Is_traits<T>::value, T, No_traits>;

template <class Traits, class = void> struct Predicate_field { typedef typename Traits::FT type; };
template <class Traits> struct Predicate_field<Traits, std::void_t<typename Traits::Predicate_FT>> {
  typedef typename Traits::Predicate_FT type;
};

template <class Point, class = void> struct Traits_of_point {};
template <class Point> struct Traits_of_point<Point, std::enable_if_t<Point::Ambient_dimension::value == 2>> {
  typedef Traits_2<typename Point::R> type;
};
template <class Point> struct Traits_of_point<Point, std::enable_if_t<Point::Ambient_dimension::value == 3>> {
  typedef Traits_3<typename Point::R> type;
};

// In the place of a traits class: that of the points.
struct Of_points;
template <class Given, class Point> struct Traits_given { typedef Given type; };
template <class Point> struct Traits_given<Of_points, Point> : Traits_of_point<Point> {};

} // namespace internal

/// \ingroup PkgGeometricContinuityTraits
/// The traits class of points of a \cgal kernel, of type `Point_2` or `Point_3`: functions that
/// take such points need not be told.
template <class Point> using Traits_of = typename internal::Traits_of_point<Point>::type;

/// \ingroup PkgGeometricContinuityTraits
/// The traits class `Given`, or `Traits_of<Point>` where a function is called without template
/// arguments.
template <class Given, class Point> using Traits_or_of = typename internal::Traits_given<Given, Point>::type;

/// \ingroup PkgGeometricContinuityTraits
/// The dimension of a traits class when it is known at compile time, otherwise 0.
template <class Traits> constexpr int dimension_v = internal::Dimension_value<typename Traits::Dimension>::value;

/// \ingroup PkgGeometricContinuityTraits
/// The coordinates of a point or a vector of the traits class, as a column.
template <class Traits> using Coordinates = Coordinate_vector<typename Traits::FT, dimension_v<Traits>>;

/// \ingroup PkgGeometricContinuityTraits
/// The field in which predicates are decided: `Traits::Predicate_FT` where the traits class has
/// one, otherwise `Traits::FT`.
template <class Traits> using Predicate_FT = typename internal::Predicate_field<Traits>::type;

/// \ingroup PkgGeometricContinuityTraits
/// Returns the coordinates of a point or a vector `p` of the traits class, in its own field or
/// converted to `Field`.
/// \throws Error `not_finite` when a coordinate that is converted is an infinity or not a number
template <class Traits, class Field = typename Traits::FT, class Point_or_vector>
Coordinate_vector<Field, dimension_v<Traits>> coordinates(const Point_or_vector& p) {
  const Traits traits;
  const int d = traits.compute_dimension_object()(p);
  Coordinate_vector<Field, dimension_v<Traits>> c(d);
  for (int i = 0; i < d; ++i)
    if constexpr (std::is_same_v<Field, typename Traits::FT>)
      c[i] = traits.compute_coordinate_object()(p, i);
    else
      c[i] = internal::to_field<Field>(typename Traits::FT(traits.compute_coordinate_object()(p, i)));
  return c;
}

namespace internal {

// Returns the coordinates of a point or vector, or of an object that converts to one.
template <class Traits> Coordinates<Traits> point_column(const typename Traits::Point& p) {
  return Geometric_continuity::coordinates<Traits>(p);
}
template <class Traits> Coordinates<Traits> vector_column(const typename Traits::Vector& v) {
  return Geometric_continuity::coordinates<Traits>(v);
}

} // namespace internal

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

/// \ingroup PkgGeometricContinuityTraits
/// The traits class for the homogeneous points of another one: columns
/// \f$ (w x_1, \dots, w x_n, w) \f$. A polynomial curve or surface over it is the numerator and the
/// denominator of a rational one over `Traits`, and so every algorithm for polynomials serves both.
///
/// \tparam Traits_ a model of `GeometricContinuityTraits`
/// \cgalModels{GeometricContinuityTraits}
template <class Traits_> class Homogeneous_traits {
  static constexpr int N = dimension_v<Traits_>;

public:
  /// the traits class of the points \f$ x \f$
  typedef Traits_ Affine_traits;
  typedef typename Traits_::FT FT;                           ///< its numbers
  typedef Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> Point; ///< a homogeneous point
  /// a difference or a derivative of such points
  typedef Point Vector;
  /// One dimension more than that of the points \f$ x \f$.
  typedef std::conditional_t<N == 0, Dynamic_dimension_tag, Dimension_tag<N + 1>> Dimension;
  /// The field in which predicates are decided.
  typedef Geometric_continuity::Predicate_FT<Traits_> Predicate_FT;

  /// Returns the number of coordinates.
  struct Compute_dimension {
    int operator()(const Point& p) const { return p.dimension(); }
  };
  /// Returns the coordinate number `i`.
  struct Compute_coordinate {
    const FT& operator()(const Point& p, int i) const { return p[i]; }
  };
  /// Constructs a column from a range of coordinates.
  struct Construct_point {
    template <class RandomAccessIterator>
    Point operator()(int d, RandomAccessIterator first, RandomAccessIterator) const {
      Point p(d);
      for (int i = 0; i < d; ++i) p[i] = first[i];
      return p;
    }
  };
  typedef Construct_point Construct_vector; ///< constructs a column, too

  /// Returns the function object `Compute_dimension`.
  Compute_dimension compute_dimension_object() const { return Compute_dimension(); }
  /// Returns the function object `Compute_coordinate`.
  Compute_coordinate compute_coordinate_object() const { return Compute_coordinate(); }
  /// Returns the function object `Construct_point`.
  Construct_point construct_point_object() const { return Construct_point(); }
  /// Returns the function object `Construct_vector`.
  Construct_vector construct_vector_object() const { return Construct_vector(); }
};

/// \ingroup PkgGeometricContinuityTraits
/// Returns the homogeneous point \f$ (w x, w) \f$, or \f$ (x, 0) \f$ for the weight 0: the infinite
/// point in the direction \f$ x \f$. \tparam N the dimension of `x`, or 0
template <class FT, int N>
Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> homogeneous_point(const Coordinate_vector<FT, N>& x, const FT& w) {
  const int n = x.dimension();
  Coordinate_vector<FT, (N == 0 ? 0 : N + 1)> p(n + 1);
  const bool infinite = w == FT(0);
  for (int i = 0; i < n; ++i) p[i] = infinite ? x[i] : FT(w * x[i]);
  p[n] = w;
  return p;
}

/// \ingroup PkgGeometricContinuityTraits
/// Returns \f$ x \f$ of a homogeneous point \f$ (w x, w) \f$, or of an infinite point
/// \f$ (x, 0) \f$; the weight is its last coordinate. \tparam M the dimension of `p`, one more than
/// that of `x`, or 0
template <class FT, int M> Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> affine_point(const Coordinate_vector<FT, M>& p) {
  const int n = p.dimension() - 1;
  Coordinate_vector<FT, (M == 0 ? 0 : M - 1)> x(n);
  const bool as_it_is = p[n] == FT(0) || p[n] == FT(1);
  for (int i = 0; i < n; ++i) x[i] = as_it_is ? p[i] : FT(p[i] / p[n]);
  return x;
}

namespace internal {

// Tells whether a curve or a surface has weights.
template <class Shape, class = void> struct Is_rational : std::false_type {};
template <class Shape> struct Is_rational<Shape, std::void_t<typename Shape::Homogeneous>> : std::true_type {};

// Two opposite corners of the bounding box of the points in [first, last). \pre there is one
template <class Traits, class Iterator>
std::pair<typename Traits::Point, typename Traits::Point> corners_of_box(Iterator first, Iterator last) {
  Coordinates<Traits> low = Geometric_continuity::coordinates<Traits>(*first), high = low;
  while (++first != last) {
    const Coordinates<Traits> p = Geometric_continuity::coordinates<Traits>(*first);
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
  const Coordinates<Traits> low = Geometric_continuity::coordinates<Traits>(corners.first),
                            high = Geometric_continuity::coordinates<Traits>(corners.second);
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

#endif // CGAL_GEOMETRIC_CONTINUITY_TRAITS_H
