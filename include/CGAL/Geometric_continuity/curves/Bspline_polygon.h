// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_POLYGON_H

#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// What a B-spline curve is given by: its control points \f$ b_0, \dots, b_{n-1} \f$ and its knots. This base of
/// `Bspline_curve` stores and checks them, and answers what needs no evaluation.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Bspline_polygon {
public:
  typedef Traits_ Traits;                                        ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< the coordinates of a point
  static constexpr int N = dimension_v<Traits>; ///< the dimension, or 0 when it is known at run time only
  typedef typename std::vector<Point>::const_iterator const_iterator; ///< iterates over the control points
  template <class T> using Per_point = std::vector<T>; ///< a container with one entry for each control point
  typedef Bspline_function<FT, Coordinates> Function;  ///< the coordinates as a function of the parameter

  /// Returns the degree `p`.
  int degree() const { return knots_.degree(); }
  /// Returns the dimension of the control points.
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// Returns the number `n` of control points.
  int number_of_points() const { return static_cast<int>(points_.size()); }
  /// Returns the control points, in order.
  const std::vector<Point>& control_points() const { return points_; }
  /// Returns the `i`-th control point. \pre `0 <= i < number_of_points()`
  const Point& control_point(int i) const { return points_[i]; }
  /// Returns an iterator to the first control point.
  const_iterator begin() const { return points_.begin(); }
  /// Returns the iterator after the last control point.
  const_iterator end() const { return points_.end(); }
  /// Returns the coordinates of the `i`-th control point. \pre `0 <= i < number_of_points()`
  Coordinates coordinates(int i) const { return Geometric_continuity::coordinates<Traits>(points_[i]); }

  /// Returns the knots.
  const Knot_vector<FT>& knots() const { return knots_; }
  /// Returns the domain \f$ [u_p, u_n] \f$.
  std::pair<FT, FT> domain() const { return knots_.domain(); }

  /// Returns the coordinates of the curve as a function of the parameter.
  Function function() const {
    std::vector<Coordinates> rows;
    for (int i = 0; i < number_of_points(); ++i) rows.push_back(coordinates(i));
    return Function(knots_, std::move(rows));
  }

  /// Returns whether knots and control points are equal.
  friend bool operator==(const Bspline_polygon& c, const Bspline_polygon& d) {
    if (c.knots_ != d.knots_) return false;
    for (int j = 0; j < c.number_of_points(); ++j)
      if (c.coordinates(j) != d.coordinates(j)) return false;
    return true;
  }
  /// Returns whether knots or control points differ.
  friend bool operator!=(const Bspline_polygon& c, const Bspline_polygon& d) { return !(c == d); }

  /// Writes the knots and the control points.
  friend std::ostream& operator<<(std::ostream& os, const Bspline_polygon& c) {
    os << "B-spline curve of degree " << c.degree() << " over " << c.knots_ << ':';
    for (int j = 0; j < c.number_of_points(); ++j) {
      const Coordinates p = c.coordinates(j);
      os << " (";
      for (int i = 0; i < p.dimension(); ++i) os << (i == 0 ? "" : ", ") << p[i];
      os << ')';
    }
    return os;
  }

protected:
  Knot_vector<FT> knots_;
  std::vector<Point> points_;

  Bspline_polygon(Knot_vector<FT> knots, std::vector<Point> points)
      : knots_(std::move(knots)), points_(std::move(points)) {}

  void check_points() const {
    for (int i = 0; i < number_of_points(); ++i) {
      const Coordinates x = coordinates(i);
      if (x.dimension() != dimension())
        throw Error(Error_code::dimension_mismatch, "Bspline_curve: control point " + std::to_string(i));
      for (const FT& xi : x) internal::check_finite(xi, "Bspline_curve: control points");
    }
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_POLYGON_H
