// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_CURVE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/Joined_bezier_curves.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Iterator_range.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The closure of a chain of curves, or of a curve through or near many points.
enum class Closure {
  open,  ///< it ends at its last curve, or at the last point or near it
  closed ///< it returns to its first curve or point
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the name of a kind of chain or curve, as spelled in the enumeration.
inline std::string to_string(Closure closure) { return closure == Closure::open ? "open" : "closed"; }

/// \ingroup PkgGeometricContinuityCurves
/// The data of a segmented Bézier curve: its control points \f$ b_0, \dots, b_{m(k+1)} \f$ and its
/// knots \f$ u_0, \dots, u_{k+1} \f$. This base of `Composite_bezier_curve` stores and checks them,
/// and answers what needs no evaluation.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Composite_bezier_polygon {
  static_assert(internal::Checked_traits<Traits_>::value);

public:
  typedef internal::Traits_or_none<Traits_> Traits; ///< the traits class
  typedef typename Traits::FT FT;                   ///< the field
  typedef typename Traits::Point Point;             ///< the points of the kernel
  typedef typename Traits::Vector Vector;           ///< the vectors of the kernel
  /// the coordinates of a point
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  /// iterates over the control points
  typedef typename std::vector<Point>::const_iterator const_iterator;

  /// Returns the degree `m` of the segments.
  int degree() const { return degree_; }
  /// Returns the dimension of the control points.
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// Returns the number of segments, `k + 1`.
  int number_of_segments() const { return static_cast<int>(knots_.size()) - 1; }
  // This refuses a number that could be that of the points or of the segments.
  template <class Given = Traits> std::size_t size() const {
    static_assert(!std::is_same_v<Given, Given>, "number_of_segments() is the number of the Bezier curves, which "
                                                 "segments() returns; control_points() has the points");
    return 0;
  }

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

#ifndef CGAL_NO_DEPRECATED_CODE
  /// \cond SKIP_IN_MANUAL
  [[deprecated("call domain().first")]] FT start_parameter() const { return domain().first; }
  [[deprecated("call domain().second")]] FT end_parameter() const { return domain().second; }
  /// \endcond
#endif

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
        throw Error(Error_code::empty_domain,
                    "Composite_bezier_curve: knot " + std::to_string(l) + " is not greater than the one before it");
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

/// \ingroup PkgGeometricContinuityCurves
/// A segmented Bézier curve of degree `m` over the knots \f$ u_0 < \dots < u_{k+1} \f$. With
/// \f$ \lambda_\ell = u_{\ell+1} - u_\ell \f$, its segments are
/// \f$ x_\ell(u) = \sum_{i=0}^m b_{m\ell+i} B_i^m\left(\frac{u - u_\ell}{\lambda_\ell}\right) \f$
/// on \f$ [u_\ell, u_{\ell+1}] \f$, \f$ \ell = 0, \dots, k \f$; neighbours share the point
/// \f$ b_{m(\ell+1)} \f$. Hagen 3.1, with the indices corrected.
///
/// All derivatives are taken with respect to the global parameter `u`, so that the continuity of a
/// join depends on the ratio of the neighbouring \f$ \lambda_\ell \f$. The curve is a value:
/// operations return new curves. With an exact kernel they are exact.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
/// \cgalModels{ParametricCurve}
template <class Traits_, int Degree = dynamic_degree>
class Composite_bezier_curve : public Composite_bezier_polygon<Traits_> {
  typedef Composite_bezier_polygon<Traits_> Polygon;
  using Polygon::degree_;
  using Polygon::knots_;
  using Polygon::points_;

public:
  using typename Polygon::Traits;         ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  /// a segment, with its part of the domain
  typedef Bezier_curve<Traits, Degree> Segment;
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = Segment::N;
  typedef typename Polygon::const_iterator const_iterator; ///< iterates over the control points

  using Polygon::is_closed;
  using Polygon::lambda;
  using Polygon::number_of_segments;

  /// The join between the end of the segment `left` and the start of the segment `right`.
  struct Join {
    int left;  ///< the number of the segment that ends
    int right; ///< the number of the segment that starts
  };

private:
  struct Segment_at {
    const Composite_bezier_curve* curve;
    Segment operator()(int l) const { return curve->segment(l); }
  };
  struct Join_at {
    int segments;
    Join operator()(int l) const { return {l, (l + 1) % segments}; }
  };

public:
  /// Takes the `m (k + 1) + 1` control points and the `k + 2` knots; the degree follows from their
  /// numbers.
  /// \throws Error `empty_domain` with fewer than 2 knots, and unless they increase strictly
  /// \throws Error `wrong_number_of_points` when the number of points is not of this form, or not
  ///   for `m == Degree`
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point number, and when the
  ///   length of the domain overflows
  template <class InputIterator>
  Composite_bezier_curve(InputIterator first, InputIterator last, std::vector<FT> knots)
      : Polygon(0, std::move(knots), std::vector<Point>(first, last)) {
    this->check_knots();
    const int points = static_cast<int>(points_.size()), k1 = number_of_segments();
    if (points == 0 || (points - 1) % k1 != 0 || (Degree != dynamic_degree && (points - 1) / k1 != Degree))
      throw Error(Error_code::wrong_number_of_points, "Composite_bezier_curve: " + std::to_string(points) +
                                                          " points for " + std::to_string(k1) + " segments" +
                                                          (Degree == dynamic_degree ? "" : " of the fixed degree"));
    degree_ = (points - 1) / k1;
    this->check_points();
  }

  /// Takes a range of control points, such as a `std::vector`, and the knots. \throws Error as the
  /// constructor from iterators
  template <class Points, class = internal::Range_of_points<Points, Point>>
  Composite_bezier_curve(const Points& points, std::vector<FT> knots)
      : Composite_bezier_curve(std::begin(points), std::end(points), std::move(knots)) {}

  /// Takes a range of Bézier curves, each of which starts exactly where the one before it ends. Its
  /// degree is the highest of theirs, or `Degree`; the others are elevated. The segments keep the
  /// lengths of their domains: \f$ u_0 \f$ is the start of the first domain, and domains that
  /// continue each other are taken over as they are.
  /// \throws Error `curves_do_not_meet`, `dimension_mismatch` when two neighbours do not fit
  /// \throws Error `wrong_number_of_points` for an empty range, and for a degree above `Degree`
  /// \throws Error `empty_domain`, `not_finite` when knots become equal or overflow by rounding
  template <class ForwardIterator, class = typename std::iterator_traits<ForwardIterator>::value_type>
  Composite_bezier_curve(ForwardIterator first, ForwardIterator last)
      : Composite_bezier_curve(
            internal::Joined_bezier_curves<Traits>(first, last, (std::max)(Degree, 0), "Composite_bezier_curve")) {}

  /// Converts a curve by forgetting its degree, or by remembering it.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <int Other, class = std::enable_if_t<Other != Degree>>
  Composite_bezier_curve(const Composite_bezier_curve<Traits, Other>& c)
      : Composite_bezier_curve(c.begin(), c.end(), c.knots()) {
    static_assert(Other == dynamic_degree || Degree == dynamic_degree, "the degrees differ");
  }

  /// \name Segments and Joins
  /// @{

  /// Returns \f$ \lambda_{right} / \lambda_{left} \f$: the \f$ \beta_1 \f$ with which, seen from
  /// unit intervals, a join is \f$ C^1 \f$. \pre the numbers of the segments are between 0 and
  /// `number_of_segments() - 1`
  FT ratio(const Join& join) const { return FT(lambda(join.right) / lambda(join.left)); }

  /// Returns the `l`-th segment with its domain \f$ [u_\ell, u_{\ell+1}] \f$. \pre
  /// `0 <= l < number_of_segments()`
  Segment segment(int l) const {
    const const_iterator first = points_.begin() + degree_ * l;
    return Segment(first, first + degree_ + 1, knots_[l], knots_[l + 1]);
  }

  /// Returns the range of all segments, which are made one at a time. It refers to this curve,
  /// which must live on; so that it is not for temporary curves.
  auto segments() const& {
    return CGAL::make_range(
        boost::make_transform_iterator(boost::make_counting_iterator(0), Segment_at{this}),
        boost::make_transform_iterator(boost::make_counting_iterator(number_of_segments()), Segment_at{this}));
  }
  void segments() const&& = delete;

  /// Returns the number of joins: that of the inner knots, and one more when the curve is closed.
  int number_of_joins() const { return number_of_segments() - (is_closed() ? 0 : 1); }

  /// Returns the range of all joins from left to right; that of a closed curve ends with the one
  /// between its end and its start.
  auto joins() const {
    return CGAL::make_range(
        boost::make_transform_iterator(boost::make_counting_iterator(0), Join_at{number_of_segments()}),
        boost::make_transform_iterator(boost::make_counting_iterator(number_of_joins()),
                                       Join_at{number_of_segments()}));
  }

  /// Returns the number of the segment that is evaluated at `u`: at an inner knot the one to the
  /// right. \f$ O(\log k) \f$
  /// \throws Error `parameter_outside_domain`
  int segment_at(const FT& u) const {
    check_parameter(u);
    const auto inner = knots_.begin() + 1, end = knots_.end() - 1;
    return static_cast<int>(std::upper_bound(inner, end, u) - inner);
  }

  /// Returns the number of the segment that leads to `u`: at an inner knot the one to the left.
  /// \f$ O(\log k) \f$
  /// \throws Error `parameter_outside_domain`
  int segment_before(const FT& u) const {
    check_parameter(u);
    const auto inner = knots_.begin() + 1, end = knots_.end() - 1;
    return static_cast<int>(std::lower_bound(inner, end, u) - inner);
  }

  /// @}
  /// \name Evaluation
  /// At an end of the domain, the jets of both sides are the jet of the only side that there is.
  /// With floating-point numbers, derivatives that overflow are not refused.
  /// @{

  /// Returns the point at `u`. \f$ O(\log k + m^2) \f$
  /// \throws Error `parameter_outside_domain` unless \f$ u_0 \le u \le u_{k+1} \f$
  Point operator()(const FT& u) const { return segment(segment_at(u))(u); }

  /// Returns the jet of order `k` at `u`, from the right at the inner knots. \f$ O(m^2 + k^3) \f$
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> jet(const FT& u, int k) const { return right_jet(u, k); }

  /// Returns the jet of order `k` at `u`, from the left at the inner knots. \f$ O(m^2 + k^3) \f$
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> left_jet(const FT& u, int k) const { return segment(segment_before(u)).jet(u, k); }
  /// Returns the jet of order `k` at `u`, from the right at the inner knots. \f$ O(m^2 + k^3) \f$
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> right_jet(const FT& u, int k) const { return segment(segment_at(u)).jet(u, k); }

  /// Returns the jet of order `k` at the start of the domain in another field, see
  /// `Bezier_curve::start_jet_over()`.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return segment(0).template start_jet_over<Field>(k);
  }
  /// Returns the jet of order `k` at the end of the domain in another field, see
  /// `Bezier_curve::end_jet_over()`.
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return segment(number_of_segments() - 1).template end_jet_over<Field>(k);
  }

  /// @}
  /// \name Other Curves
  /// @{

  /// Returns this curve with `u` as a further knot. Nothing changes when it is a knot already.
  /// \f$ O(m k + m^2) \f$
  /// \throws Error `parameter_outside_domain`
  Composite_bezier_curve insert_knot(const FT& u) const {
    const int l = segment_at(u), m = degree_;
    if (u == knots_[l] || u == knots_.back()) return *this;
    const std::pair<Segment, Segment> parts = segment(l).split(u);
    Composite_bezier_curve r = *this;
    r.knots_.insert(r.knots_.begin() + l + 1, u);
    r.points_.assign(points_.begin(), points_.begin() + m * l);
    r.points_.insert(r.points_.end(), parts.first.begin(), parts.first.end());
    r.points_.insert(r.points_.end(), parts.second.begin() + 1, parts.second.end());
    r.points_.insert(r.points_.end(), points_.begin() + m * (l + 1) + 1, points_.end());
    return r;
  }

  /// Returns the part on [u, v], on its own part of the domain.
  /// \throws Error `parameter_outside_domain`, `empty_domain` unless `u < v`
  Composite_bezier_curve subrange(const FT& u, const FT& v) const {
    if (!(u < v)) throw Error(Error_code::empty_domain, "Composite_bezier_curve::subrange");
    const Composite_bezier_curve c = insert_knot(u).insert_knot(v);
    return c.segment_range(c.segment_at(u), c.segment_before(v) + 1);
  }

  /// Returns the part of the segments `first`, ..., `last - 1`.
  /// \throws Error `parameter_outside_domain` unless `0 <= first < last <= number_of_segments()`
  Composite_bezier_curve segment_range(int first, int last) const {
    if (!(0 <= first && first < last && last <= number_of_segments()))
      throw Error(Error_code::parameter_outside_domain, "Composite_bezier_curve::segment_range");
    return Composite_bezier_curve(points_.begin() + degree_ * first, points_.begin() + degree_ * last + 1,
                                  std::vector<FT>(knots_.begin() + first, knots_.begin() + last + 1));
  }

  /// Returns the parts on both sides of `u`. \throws Error `parameter_outside_domain` unless
  /// \f$ u_0 < u < u_{k+1} \f$
  std::pair<Composite_bezier_curve, Composite_bezier_curve> split(const FT& u) const {
    if (!(knots_.front() < u && u < knots_.back()))
      throw Error(Error_code::parameter_outside_domain, "Composite_bezier_curve::split");
    return {subrange(knots_.front(), u), subrange(u, knots_.back())};
  }

  /// Returns the curve in the opposite direction, on the same domain: `u` becomes
  /// \f$ u_0 + u_{k+1} - u \f$. With rounded numbers this rounds the inner knots, but no
  /// point. \throws Error `empty_domain` when that makes two knots equal
  Composite_bezier_curve reverse() const {
    Composite_bezier_curve r = *this;
    std::reverse(r.points_.begin(), r.points_.end());
    std::reverse(r.knots_.begin(), r.knots_.end());
    for (FT& u : r.knots_) u = FT(knots_.front() + (knots_.back() - u));
    r.knots_.back() = knots_.back();
    r.check_knots();
    return r;
  }

  /// Returns the image under an affine map of points, e.g. an `Isometry`. The images are not
  /// checked.
  template <class Transformation> Composite_bezier_curve transform(const Transformation& map) const {
    Composite_bezier_curve r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// @}

  /// Writes the segments, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Composite_bezier_curve& c) {
    for (const Segment& s : c.segments()) os << s << '\n';
    return os;
  }

private:
  explicit Composite_bezier_curve(internal::Joined_bezier_curves<Traits> curves)
      : Polygon(curves.degree, std::move(curves.knots), std::move(curves.points)) {
    if (Degree != dynamic_degree && degree_ > Degree)
      throw Error(Error_code::wrong_number_of_points, "Composite_bezier_curve: a segment of degree " +
                                                          std::to_string(degree_) + " where it is at most " +
                                                          std::to_string(Degree));
    this->check_knots();
    this->check_points();
  }

  void check_parameter(const FT& u) const {
    const FT &a = knots_.front(), &b = knots_.back();
    if (!(a < u || a == u) || !(u < b || u == b)) // an undefined number is refused, too
      throw Error(Error_code::parameter_outside_domain, "Composite_bezier_curve");
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_COMPOSITE_BEZIER_CURVE_H
