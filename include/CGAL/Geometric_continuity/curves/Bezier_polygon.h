// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/internal/jet_of_differences.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The degree of a curve whose degree is known at run time only.
constexpr int dynamic_degree = -1;

namespace internal {

template <int N> class Grid_join;

template <class T, class = void> struct Has_traits : std::false_type {};
template <class T> struct Has_traits<T, std::void_t<typename T::Traits>> : std::true_type {};

// Void if the points of a range are those of a curve. A curve is no range: its control points alone
// are not all of it.
template <class Range, class Point>
using Range_of_points = std::enable_if_t<
    std::is_convertible_v<typename std::iterator_traits<decltype(std::begin(std::declval<const Range&>()))>::reference,
                          const Point&> &&
    !Has_traits<Range>::value>;

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// The data of a Bézier curve: its control points \f$ b_0, \dots, b_m \f$ and its domain [a, b].
/// This base of `Bezier_curve` stores and checks them, and answers what needs no evaluation.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
template <class Traits_, int Degree> class Bezier_polygon : public internal::Other_members {
  static_assert(internal::Checked_traits<Traits_>::value);
  template <int> friend class internal::Grid_join; // reads the ends of the domain, and copies none

public:
  typedef internal::Traits_or_none<Traits_> Traits;              ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< the coordinates of a point
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = dimension_v<Traits>;

  /// A container with one entry for each control point: an array when the degree is fixed, a vector
  /// when it is not.
  template <class T>
  using Per_point = std::conditional_t<Degree == dynamic_degree, std::vector<T>, std::array<T, Degree + 1>>;
  /// iterates over the control points
  typedef typename Per_point<Point>::const_iterator const_iterator;

  /// Returns the degree `m`, one less than the number of control points.
  int degree() const { return static_cast<int>(points_.size()) - 1; }
  /// Returns the dimension of the control points.
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// Returns the number of control points, which is `degree() + 1`.
  int number_of_points() const { return static_cast<int>(points_.size()); }

  /// Returns the control points, in order.
  const Per_point<Point>& control_points() const { return points_; }
  /// Returns the `j`-th control point. \pre `0 <= j <= degree()`
  const Point& control_point(int j) const { return points_[j]; }
  /// Returns the coordinates of the `j`-th control point. \pre `0 <= j <= degree()`
  Coordinates coordinates(int j) const { return Geometric_continuity::coordinates<Traits>(points_[j]); }
  /// Returns an iterator to the first control point.
  const_iterator begin() const { return points_.begin(); }
  /// Returns the iterator after the last control point.
  const_iterator end() const { return points_.end(); }

  /// Returns the domain [a, b].
  std::pair<FT, FT> domain() const { return {a_, b_}; }

#ifndef CGAL_NO_DEPRECATED_CODE
  /// \cond SKIP_IN_MANUAL
  [[deprecated("call domain().first")]] FT start_parameter() const { return domain().first; }
  [[deprecated("call domain().second")]] FT end_parameter() const { return domain().second; }
  /// \endcond
#endif

  /// Returns the `i`-th coordinate as a polynomial of degree `m` of the local parameter
  /// \f$ t = (u-a)/(b-a) \f$.
  /// \pre `0 <= i < dimension()`
  Bernstein_polynomial<FT> coordinate_polynomial(int i) const {
    const Coefficients<FT> c = coefficients(i);
    return Bernstein_polynomial<FT>(c.begin(), c.end());
  }

  /// Returns two opposite corners of the bounding box of the control points, which contains the
  /// curve. \f$ O(m) \f$
  std::pair<Point, Point> bounding_box() const { return internal::corners_of_box<Traits>(begin(), end()); }

  /// Returns the bounding box of the control points as `Bbox_2` or `Bbox_3`, rounded outwards.
  /// Dimension 2 or 3 only.
  auto bbox() const { return internal::bbox_of<Traits>(bounding_box()); }

  /// Returns whether control points and domains are equal.
  friend bool operator==(const Bezier_polygon& c, const Bezier_polygon& d) {
    if (c.a_ != d.a_ || c.b_ != d.b_ || c.degree() != d.degree()) return false;
    for (int j = 0; j <= c.degree(); ++j)
      if (c.coordinates(j) != d.coordinates(j)) return false;
    return true;
  }
  /// Returns whether control points or domains differ.
  friend bool operator!=(const Bezier_polygon& c, const Bezier_polygon& d) { return !(c == d); }

  /// Writes the domain and the control points.
  friend std::ostream& operator<<(std::ostream& os, const Bezier_polygon& c) {
    os << "Bezier curve of degree " << c.degree() << " on [" << c.a_ << ", " << c.b_ << "]:";
    for (int j = 0; j <= c.degree(); ++j) os << ' ' << c.coordinates(j);
    return os;
  }

protected:
  template <class T> using Coefficients = internal::Bezier_coefficients<Degree, T>;

  Per_point<Point> points_;
  FT a_, b_;

  Bezier_polygon() = default;
  template <class InputIterator>
  Bezier_polygon(InputIterator first, InputIterator last, const FT& a, const FT& b)
      : points_(points_of(first, last)), a_(a), b_(b) {
    check();
  }
  template <class Rows> // a container of the coordinates of the control points
  CGAL_GC_FORCEINLINE Bezier_polygon(const Rows& rows, const FT& a, const FT& b)
      : points_(points_of(rows)), a_(a), b_(b) {
    check();
  }

  // f(i) for each coordinate number i
  template <class Function> CGAL_GC_FORCEINLINE void for_each_coordinate(const Function& f) const {
    internal::for_each_index<N>(dimension(), f);
  }
  // f(j) for each control point number j
  template <class Function> CGAL_GC_FORCEINLINE void for_each_point(const Function& f) const {
    internal::for_each_index<Degree == dynamic_degree ? 0 : Degree + 1>(degree() + 1, f);
  }
  // the i-th coordinates of all control points
  CGAL_GC_FORCEINLINE Coefficients<FT> coefficients(int i) const {
    const Traits traits;
    Coefficients<FT> c;
    if constexpr (Degree == dynamic_degree) c.resize(points_.size());
    for_each_point([&](int j)
                       CGAL_GC_FORCEINLINE_LAMBDA { c[j] = FT(traits.compute_coordinate_object()(points_[j], i)); });
    return c;
  }
  Coefficients<Coordinates> coordinate_rows() const {
    Coefficients<Coordinates> rows;
    if constexpr (Degree == dynamic_degree) rows.resize(points_.size());
    for (int j = 0; j <= degree(); ++j) rows[j] = coordinates(j);
    return rows;
  }

private:
  BOOST_NOINLINE static void refuse_number_of_points() {
    if constexpr (Degree == dynamic_degree)
      throw Error(Error_code::wrong_number_of_points, "Bezier_curve: at least one control point is needed");
    else
      throw Error(Error_code::wrong_number_of_points, "Bezier_curve: degree " + std::to_string(Degree) + " needs " +
                                                          std::to_string(Degree + 1) + " control points");
  }

  CGAL_GC_FORCEINLINE void check() const {
    if (points_.empty()) refuse_number_of_points();
    if (!(a_ < b_)) throw Error(Error_code::empty_domain, "Bezier_curve");
    if constexpr (N == 0)
      for (int j = 0; j <= degree(); ++j)
        if (Traits().compute_dimension_object()(points_[j]) != dimension())
          throw Error(Error_code::dimension_mismatch, "Bezier_curve: control point " + std::to_string(j));
    if constexpr (std::is_floating_point_v<FT>) {
      const Traits traits;
      FT sum = b_ - a_; // not finite if one of the numbers is not, or the length of the domain
      for_each_point([&](int j) CGAL_GC_FORCEINLINE_LAMBDA {
        FT x = traits.compute_coordinate_object()(points_[j], 0);
        for_each_coordinate([&](int i) CGAL_GC_FORCEINLINE_LAMBDA {
          // equivalent [> -> >=, 1]: a coordinate that is counted twice; where the sum is not
          //   finite each number is checked
          if (i > 0) x += traits.compute_coordinate_object()(points_[j], i);
        });
        sum += x;
      });
      if (!std::isfinite(sum)) check_each_number();
    }
  }
  BOOST_NOINLINE void check_each_number() const {
    internal::check_finite(a_, "Bezier_curve: domain");
    internal::check_finite(b_, "Bezier_curve: domain");
    internal::check_finite(FT(b_ - a_), "Bezier_curve: length of the domain");
    for (int j = 0; j <= degree(); ++j)
      for (int i = 0; i < dimension(); ++i)
        internal::check_finite(FT(Traits().compute_coordinate_object()(points_[j], i)), "Bezier_curve: control points");
  }

  template <class InputIterator> static Per_point<Point> points_of(InputIterator first, InputIterator last) {
    if constexpr (Degree == dynamic_degree)
      return Per_point<Point>(first, last);
    else {
      Per_point<Point> points;
      int i = 0;
      for (; first != last && i <= Degree; ++first, ++i) points[i] = *first;
      if (i <= Degree || first != last) refuse_number_of_points();
      return points;
    }
  }
  template <class Rows> static Per_point<Point> points_of(const Rows& rows) {
    if constexpr (Degree == dynamic_degree) {
      std::vector<Point> points;
      points.reserve(rows.size());
      for (const Coordinates& x : rows) points.push_back(Geometric_continuity::to_point<Traits>(x));
      return points;
    } else
      return points_of(rows, std::make_index_sequence<Degree + 1>());
  }
  template <class Rows, std::size_t... j>
  static Per_point<Point> points_of(const Rows& rows, std::index_sequence<j...>) {
    return {{Geometric_continuity::to_point<Traits>(rows[j])...}};
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_POLYGON_H
