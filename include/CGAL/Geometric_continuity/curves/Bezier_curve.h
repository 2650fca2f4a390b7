// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/bernstein_energy.h>
#include <CGAL/Geometric_continuity/curves/internal/bezier_jet.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/internal/Range_of_points.h>
#include <CGAL/Geometric_continuity/internal/for_each_index.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/jet_of_differences.h>
#include <CGAL/Geometric_continuity/local/internal/points_from_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
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

template <class Shape> struct Curve_shape; // what differs between the shapes of rational curves

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

/// \ingroup PkgGeometricContinuityCurves
/// A Bézier curve \f$ \sum_{i=0}^m b_i B_i^m((u-a)/(b-a)) \f$ with control points
/// \f$ b_0, \dots, b_m \f$ on the domain [a, b], by default [0, 1]. All derivatives are taken with
/// respect to the parameter `u` of the domain.
///
/// The curve is a value: operations return new curves. With an exact kernel they are exact.
///
/// With a degree fixed at compile time, construction, evaluation, jets up to order 5, derivative,
/// split, elevation by a fixed number, reversal, transformation and bounding box allocate no memory
/// (provided that the numbers and points of the kernel do not). With a degree known at run time
/// only and floating-point numbers, points and jets up to order 3 are the same ones and cost about
/// the same; up to degree 9, where the code is unrolled, they allocate no memory either.
///
/// With floating-point numbers, evaluation does not check its results: parameters must be finite,
/// and the derivatives, which grow with \f$ (b-a)^{-k} \f$, must not overflow.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
/// \cgalModels{ParametricCurve}
template <class Traits_, int Degree = dynamic_degree> class Bezier_curve : public Bezier_polygon<Traits_, Degree> {
  typedef Bezier_polygon<Traits_, Degree> Polygon;
  friend internal::Curve_shape<Bezier_curve>;
  using Polygon::a_;
  using Polygon::b_;
  using Polygon::points_;
  using typename Polygon::Coordinates;
  template <class T> using Coefficients = typename Polygon::template Coefficients<T>;

public:
  /// A container with one entry for each control point: an array when the degree is fixed, a vector
  /// when it is not.
  template <class T> using Per_point = typename Polygon::template Per_point<T>;
  using typename Polygon::Traits;         ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel
  using Polygon::N;

  using Polygon::begin;
  using Polygon::coordinates;
  using Polygon::degree;
  using Polygon::dimension;
  using Polygon::end;

  /// Makes a curve without control points, for containers that need one: nothing may be done with
  /// it but to assign another one to it.
  Bezier_curve() = default;

  /// Takes control points and the domain.
  /// \throws Error `wrong_number_of_points` unless the range has `Degree + 1` points (at least one,
  ///   if dynamic)
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point number, and when
  ///   `b - a` overflows
  template <class InputIterator>
  Bezier_curve(InputIterator first, InputIterator last, const FT& a = FT(0), const FT& b = FT(1))
      : Polygon(first, last, a, b) {}

  /// Takes a range of control points, such as a `std::vector`, and the domain. \throws Error as the
  /// constructor from iterators
  template <class Points, class = internal::Range_of_points<Points, Point>>
  explicit Bezier_curve(const Points& points, const FT& a = FT(0), const FT& b = FT(1))
      : Bezier_curve(std::begin(points), std::end(points), a, b) {}

  /// Takes the coordinates of the control points, and the domain.
  /// \throws Error `wrong_number_of_points` without points, `dimension_mismatch`, `empty_domain`,
  ///   `not_finite` as for points
  CGAL_GC_FORCEINLINE explicit Bezier_curve(const Per_point<Coordinates>& rows, const FT& a = FT(0),
                                            const FT& b = FT(1))
      : Polygon(rows, a, b) {}

  /// Takes control points one after the other, on [0, 1].
  /// \throws Error `wrong_number_of_points`, `dimension_mismatch`, `not_finite` as for a range of
  ///   points
  template <class... Points, class = std::enable_if_t<(std::is_same_v<Points, Point> && ...)>>
  Bezier_curve(const Point& first, const Point& second, const Points&... others)
      : Bezier_curve(std::initializer_list<Point>{first, second, others...}) {}

  /// Takes a list of control points, on [0, 1].
  /// \throws Error `wrong_number_of_points`, `dimension_mismatch`, `not_finite` as for a range of
  ///   points
  Bezier_curve(std::initializer_list<Point> points) : Bezier_curve(points.begin(), points.end()) {}

  /// Converts a curve by forgetting its degree, or by remembering it.
  /// \throws Error `wrong_number_of_points` when the curve does not have the degree `Degree`
  template <int Other, class = std::enable_if_t<Other != Degree>>
  Bezier_curve(const Bezier_curve<Traits, Other>& c)
      : Bezier_curve(c.begin(), c.end(), c.domain().first, c.domain().second) {
    static_assert(Other == dynamic_degree || Degree == dynamic_degree, "the degrees differ");
  }

  /// \name Evaluation
  /// @{

  /// Returns the point at `u`, which may lie outside the domain: the polynomial is extended.
  /// \f$ O(m^2) \f$
  Point operator()(const FT& u) const {
    Coordinates x(dimension());
    if constexpr (internal::unrolls_jets<FT, Degree>)
      write_jet<0>(u, 0, &x);
    else {
      const FT t = local_parameter(u);
      this->for_each_coordinate([&](int i) {
        Coefficients<FT> c = this->coefficients(i);
        x[i] = bernstein_value(c, degree(), t);
      });
    }
    return Geometric_continuity::to_point<Traits>(x);
  }

  /// Returns the jet of order `k` at `u`, which may lie outside the domain; derivatives beyond the
  /// degree are zero. \f$ O(m^2 + k^3) \f$ \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> jet(const FT& u, int k) const {
    return internal::with_largest_order<FT, Degree>(
        k, [&](auto order) { return jet_of_order<decltype(order)::value>(u, k); },
        [&] { return jet_of_any_order(u, k); });
  }

  /// Returns the jet of an order `k >= 0` that is known at compile time, at `u`, which may lie
  /// outside the domain; derivatives beyond the degree are zero. \f$ O(m^2 + k^3) \f$
  template <int k> Curve_jet<Traits> jet(const FT& u) const {
    static_assert(k >= 0);
    if constexpr (Degree == dynamic_degree)
      return jet(u, k);
    else
      return jet_of_order<k>(u, k);
  }

  /// Returns the jet of order `k` at the start of the domain, from the first `k + 1` control
  /// points. \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }

  /// Returns the jet of order `k` at the end of the domain, from the last `k + 1` control points.
  /// \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }

  /// Returns the jet of order `k` at the start of the domain in another field, to which the control
  /// points and the domain are converted first: this is how an exact predicate reads a curve with
  /// `double` coordinates. \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return jet_of_differences<Field>(k, length_over<Field>(), [](int j) { return j; });
  }

  /// Returns the jet of order `k` at the end of the domain in another field, to which the control
  /// points and the domain are converted first: this is how an exact predicate reads a curve with
  /// `double` coordinates. \f$ O(k^2) \f$
  /// \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return jet_of_differences<Field>(k, Field(-length_over<Field>()), [m = degree()](int j) { return m - j; });
  }

  /// Returns \f$ \int_a^b |x^{(k)}(u)|^2 du \f$, exactly with an exact kernel. \f$ O(n m^2) \f$ in
  /// dimension `n`
  /// \throws Error `negative_count` unless `k >= 0`, `not_finite` when a floating-point number
  ///   overflows
  FT energy(int k) const {
    internal::check_count(k, "Bezier_curve::energy");
    const Coefficients<Coordinates> rows = this->coordinate_rows();
    const FT energy =
        internal::energy_of_rows<FT, N>(std::vector<Coordinates>(rows.begin(), rows.end()), k, FT(b_ - a_));
    internal::check_finite(energy, "Bezier_curve::energy");
    return energy;
  }

  /// @}
  /// \name Other Curves
  /// @{

  /// \cond SKIP_IN_MANUAL
  using internal::Other_members::derivative; // with arguments
  /// \endcond

  /// Returns the derivative (hodograph): the curve of degree `m - 1` (0 for a constant) whose point
  /// at `u` has the coordinates of the first derivative. \throws Error `not_finite` when a
  /// floating-point coordinate overflows
  Bezier_curve<Traits, (Degree > 0 ? Degree - 1 : Degree)> derivative() const {
    const int m = degree();
    if (m == 0) {
      const Point origin = Geometric_continuity::to_point<Traits>(Coordinates(dimension()));
      return {&origin, &origin + 1, a_, b_};
    }
    const FT factor = FT(FT(m) / (b_ - a_));
    Per_point<Point> d = points_;
    for (int i = 0; i < m; ++i)
      d[i] = Geometric_continuity::to_point<Traits>(factor * (coordinates(i + 1) - coordinates(i)));
    return {d.begin(), d.begin() + m, a_, b_};
  }

  /// Returns the parts on [a, u] and [u, b]. \f$ O(m^2) \f$
  /// \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Bezier_curve, Bezier_curve> split(const FT& u) const {
    if (!(a_ < u && u < b_)) throw Error(Error_code::parameter_outside_domain, "Bezier_curve::split");
    const FT t = local_parameter(u);
    Coefficients<Coordinates> right = this->coordinate_rows(), left = right;
    internal::bezier_split<Degree>(right, degree(), t, left);
    return {Bezier_curve(internal::Unspecified(), left, a_, u), Bezier_curve(internal::Unspecified(), right, u, b_)};
  }

  /// Returns this curve with the degree raised by `times`. \f$ O(times (m + times)) \f$
  /// \throws Error `negative_count` unless `times >= 0`
  Bezier_curve<Traits> elevate(int times = 1) const {
    internal::check_count(times, "Bezier_curve::elevate");
    const std::size_t size = points_.size() + static_cast<std::size_t>(times);
    return elevated<Bezier_curve<Traits>>(std::vector<Coordinates>(size, Coordinates(dimension())));
  }

  /// Returns this curve of fixed degree with the degree raised by `times`, without allocation.
  template <int times> Bezier_curve<Traits, Degree + times> elevate_fixed() const {
    static_assert(Degree != dynamic_degree && times >= 0);
    std::array<Coordinates, Degree + times + 1> rows;
    rows.fill(Coordinates(dimension()));
    return elevated<Bezier_curve<Traits, Degree + times>>(rows);
  }

  /// Returns the curve in the opposite direction, on the same domain: its point at `u` is that of
  /// this curve at `a + b - u`.
  Bezier_curve reverse() const {
    Bezier_curve r = *this;
    std::reverse(r.points_.begin(), r.points_.end());
    return r;
  }

  /// Returns the curve with these control points on another domain.
  /// \throws Error `empty_domain` unless `a < b`, `not_finite` when one of them is not finite or
  ///   `b - a` overflows
  Bezier_curve with_domain(const FT& a, const FT& b) const { return Bezier_curve(begin(), end(), a, b); }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`. The
  /// images are not checked.
  template <class Transformation> Bezier_curve transform(const Transformation& map) const {
    Bezier_curve r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// @}

private:
  CGAL_GC_FORCEINLINE Bezier_curve(internal::Unspecified, const Coefficients<Coordinates>& rows, const FT& a,
                                   const FT& b)
      : Polygon(rows, a, b) {}

  FT local_parameter(const FT& u) const { return FT((u - a_) / (b_ - a_)); }

  template <class Field> Field length_over() const {
    return Field(internal::to_field<Field>(b_) - internal::to_field<Field>(a_));
  }

  CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

  // x[0], ..., x[order], unrolled for the order k or less
  template <int k, class Jet> CGAL_GC_FORCEINLINE void write_jet(const FT& u, int order, Jet&& x) const {
    const Traits traits;
    internal::with_constant_level<Degree, N>(
        dimension(), degree(), u, a_, b_,
        [&](int j, int i) { return FT(traits.compute_coordinate_object()(points_[j], i)); },
        [&](auto level, const auto& coordinate) {
          internal::bezier_jet<level, k, N>(dimension(), degree(), u, a_, b_, coordinate, order, x);
        });
  }
  CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

  // Declared outside of any block, a jet is not copied when it is returned.
  template <int k> Curve_jet<Traits> jet_of_order(const FT& u, int order) const {
    Curve_jet<Traits> jet(dimension(), order, internal::Unspecified());
    write_jet<k>(u, order, jet);
    return jet;
  }

  Curve_jet<Traits> jet_of_any_order(const FT& u, int k) const {
    const Traits traits;
    Curve_jet<Traits> jet(dimension(), k);
    internal::bezier_jet_of_any_order<Degree, N>(
        dimension(), degree(), u, a_, b_, k,
        [&](int j, int i) { return FT(traits.compute_coordinate_object()(points_[j], i)); }, jet);
    return jet;
  }

  // The jet at an end of the domain, from which the control points index(0), index(1), ... are
  // numbered.
  template <class Field, class Index>
  Coordinate_jet<Field, N> jet_of_differences(int k, const Field& step, const Index& index) const {
    const Traits traits;
    return internal::jet_of_differences<Field, N, Degree>(dimension(), degree(), k, step, [&](int j, int i) {
      return internal::to_field<Field>(FT(traits.compute_coordinate_object()(points_[index(j)], i)));
    });
  }

  template <class Curve, class Rows> Curve elevated(Rows rows) const {
    for (int j = 0; j <= degree(); ++j) rows[j] = coordinates(j);
    for (int n = degree(); n + 1 < static_cast<int>(rows.size()); ++n) bernstein_elevate<FT>(rows, n);
    return Curve(rows, a_, b_);
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the first `k + 1` control points of every Bézier curve of degree `m` on a domain of
/// length `h` that has the given jet of order `k` at its start: \f$ b_1 = b_0 + \frac{h}{m} y' \f$,
/// \f$ b_2 = 2 b_1 - b_0 + \frac{h^2}{m(m-1)} y'' \f$, and so on.
/// \throws Error `wrong_number_of_points` when `m < k`, `empty_domain` unless `h > 0`, `not_finite`
///   when `h` or a result is not finite
template <class Traits>
std::vector<typename Traits::Point> start_control_points(const Curve_jet<Traits>& jet, int m,
                                                         const typename Traits::FT& h = typename Traits::FT(1)) {
  if (!(typename Traits::FT(0) < h)) throw Error(Error_code::empty_domain, "start_control_points");
  return internal::to_points<Traits>(internal::finite_points_from_jet(jet, m, h));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the last `k + 1` control points, in the order of the curve, of every Bézier curve of
/// degree `m` on a domain of length `h` that has the given jet of order `k` at its end.
/// \throws Error `wrong_number_of_points` when `m < k`, `empty_domain` unless `h > 0`, `not_finite`
///   when `h` or a result is not finite
template <class Traits>
std::vector<typename Traits::Point> end_control_points(const Curve_jet<Traits>& jet, int m,
                                                       const typename Traits::FT& h = typename Traits::FT(1)) {
  typedef typename Traits::FT FT;
  if (!(FT(0) < h)) throw Error(Error_code::empty_domain, "end_control_points");
  std::vector<typename Traits::Point> points =
      internal::to_points<Traits>(internal::finite_points_from_jet(jet, m, FT(-h)));
  std::reverse(points.begin(), points.end());
  return points;
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the Taylor polynomial of degree `m` of a curve at its end: the Bézier curve on the same
/// domain that has the derivatives of order 0 to `m` of the curve there. Functions that read the
/// end of a polynomial polygon, such as the families of alternatives, can read the end of any curve
/// by it. \f$ O(m^2) \f$, besides the jet
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `m >= 0`, `not_finite` when a result is not finite
template <class Curve> Bezier_curve<typename Curve::Traits> taylor_polynomial_at_end(const Curve& curve, int m) {
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  const std::pair<FT, FT> domain = curve.domain();
  const Curve_jet<Traits> jet(end_jet<FT>(curve, m));
  const std::vector<typename Traits::Point> points = end_control_points(jet, m, FT(domain.second - domain.first));
  return {points.begin(), points.end(), domain.first, domain.second};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H
