// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_POLYGON_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_POLYGON_H

#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// What a segmented Bézier curve is given by: its control points \f$ b_0, \dots, b_{m(k+1)} \f$ and its knots
/// \f$ u_0, \dots, u_{k+1} \f$. This base of `Composite_bezier_curve` stores and checks them, and answers what needs no
/// evaluation.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Composite_bezier_polygon {
public:
  typedef Traits_ Traits;                                             ///< the traits class
  typedef typename Traits::FT FT;                                     ///< the field
  typedef typename Traits::Point Point;                               ///< the points of the kernel
  typedef typename Traits::Vector Vector;                             ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;      ///< the coordinates of a point
  typedef typename std::vector<Point>::const_iterator const_iterator; ///< iterates over the control points

  /// Returns the degree `m` of the segments.
  int degree() const { return degree_; }
  /// Returns the dimension of the control points.
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// Returns the number of segments, `k + 1`.
  int number_of_segments() const { return static_cast<int>(knots_.size()) - 1; }

  /// Returns the control points \f$ b_0, \dots, b_{m(k+1)} \f$.
  const std::vector<Point>& control_points() const { return points_; }
  /// Returns the control point \f$ b_i \f$. \pre `0 <= i <= m (k + 1)`
  const Point& control_point(int i) const { return points_[i]; }
  /// Returns an iterator to the first control point.
  const_iterator begin() const { return points_.begin(); }
  /// Returns the iterator after the last control point.
  const_iterator end() const { return points_.end(); }
  /// Returns the coordinates of the control point \f$ b_i \f$. \pre `0 <= i <= m (k + 1)`
  Coordinates coordinates(int i) const { return Geometric_continuity::coordinates<Traits>(points_[i]); }

  /// Returns the knots \f$ u_0, \dots, u_{k+1} \f$.
  const std::vector<FT>& knots() const { return knots_; }

  /// Returns the domain \f$ [u_0, u_{k+1}] \f$.
  std::pair<FT, FT> domain() const { return {knots_.front(), knots_.back()}; }

  /// Returns the length \f$ \lambda_\ell \f$ of the parameter interval of the `l`-th segment.
  /// \pre `0 <= l < number_of_segments()`
  FT lambda(int l) const { return FT(knots_[l + 1] - knots_[l]); }

  /// Returns whether the first and the last control point are equal.
  bool is_closed() const { return coordinates(0) == coordinates(static_cast<int>(points_.size()) - 1); }

  /// Returns whether knots and control points are equal.
  friend bool operator==(const Composite_bezier_polygon& c, const Composite_bezier_polygon& d) {
    return c.knots_ == d.knots_ && c.points_ == d.points_;
  }
  /// Returns whether knots or control points differ.
  friend bool operator!=(const Composite_bezier_polygon& c, const Composite_bezier_polygon& d) { return !(c == d); }

protected:
  int degree_;
  std::vector<FT> knots_;     // u_0, ..., u_{k+1}
  std::vector<Point> points_; // b_0, ..., b_{m(k+1)}

  Composite_bezier_polygon(int degree, std::vector<FT> knots, std::vector<Point> points)
      : degree_(degree), knots_(std::move(knots)), points_(std::move(points)) {}

  void check_knots() const {
    if (knots_.size() < 2) throw Error(Error_code::empty_domain, "Composite_bezier_curve: fewer than two knots");
    for (std::size_t l = 0; l < knots_.size(); ++l) {
      internal::check_finite(knots_[l], "Composite_bezier_curve: knots");
      if (l > 0 && !(knots_[l - 1] < knots_[l]))
        throw Error(Error_code::empty_domain, "Composite_bezier_curve: segment " + std::to_string(l - 1));
    }
    internal::check_finite(FT(knots_.back() - knots_.front()), "Composite_bezier_curve: length of the domain");
  }

  void check_points() const {
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
      const Coordinates p = coordinates(i);
      if (p.dimension() != dimension())
        throw Error(Error_code::dimension_mismatch, "Composite_bezier_curve: control point " + std::to_string(i));
      for (const FT& x : p) internal::check_finite(x, "Composite_bezier_curve: control points");
    }
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_POLYGON_H
