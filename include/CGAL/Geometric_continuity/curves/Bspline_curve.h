// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_CURVE_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/Joined_bezier_curves.h>
#include <CGAL/Geometric_continuity/internal/Other_members.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/internal/bspline_differences.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The control points of a B-spline curve as rows of numbers, and back: what the functions of
// bspline_spans.h read and write. A row may be longer than the dimension, to fill the registers of
// the processor.

template <class Traits> struct Rows_of_points {
  typedef typename Traits::FT FT;
  const std::vector<typename Traits::Point>& points;

  void operator()(int i, FT* row) const {
    constexpr int N = dimension_v<Traits>, length = row_length_v<FT, N>;
    const Traits traits;
    const int d = N > 0 ? N : traits.compute_dimension_object()(points[i]);
    for (int x = 0; x < d; ++x) row[x] = traits.compute_coordinate_object()(points[i], x);
    if constexpr (length > N) row[N] = FT(0);
  }
};

template <class Traits> struct Write_points {
  typedef typename Traits::FT FT;
  static constexpr int N = dimension_v<Traits>;
  int dimension;
  typename Traits::Point* next;
  Finite_rows<row_length_v<FT, N>, FT> finite = {};

  CGAL_GC_FORCEINLINE void operator()(const FT* row) {
    *next++ = Traits().construct_point_object()(N > 0 ? N : dimension, row, row + (N > 0 ? N : dimension));
    finite.add(row, dimension);
  }
};

// The jets of order k at the two ends of each span of a spline with rational coefficients. At a
// knot of multiplicity m, the derivatives up to p - m are those on the left of it.
template <class FT, int N>
std::vector<std::pair<Coordinate_jet<FT, N>, Coordinate_jet<FT, N>>>
span_end_jets(const Knot_vector<FT>& knots, const std::vector<Coordinate_vector<FT, N>>& c, int k) {
  typedef Coordinate_jet<FT, N> Jet;
  const int p = knots.degree(), n = c[0].dimension(), last = (std::min)(k, p);
  const std::size_t spans = knots.spans().size();
  std::vector<std::pair<Jet, Jet>> jets(spans, {Jet(n, k), Jet(n, k)});
  const Work_guard work("derivatives of a spline");
  for (int d = 0; d < n; ++d) {
    std::vector<FT> column;
    for (const Coordinate_vector<FT, N>& x : c) column.push_back(x[d]);
    Difference_spans<FT> polynomials(knots, std::move(column));
    for (std::size_t s = 0; s < spans; ++s) {
      auto& [start, end] = jets[s];
      const int first_new = p + 1 - polynomials.start();
      for (int j = 0; j <= last; ++j)
        start[j][d] = j < first_new ? jets[s - 1].second[j][d] : polynomials.derivative(j);
      polynomials.finish([](int, const auto&, const auto&) {});
      for (int j = 0; j <= last; ++j) end[j][d] = polynomials.derivative(j);
    }
  }
  return jets;
}

// Refuses a call of a constructor with arguments in an order that it does not take, by one error of
// the compiler instead of a list of all constructors.
template <class Given> int refused_order() {
  static_assert(!std::is_same_v<Given, Given>,
                "Bspline_curve takes the degree, all knots and the control points, in this order, as in "
                "Bspline_curve<Traits>(2, {0, 0, 0, 1, 1, 1}, {p, q, r}), or the points and a Knot_vector; a "
                "Rational_bspline_curve takes the weights last; interpolate(points) leads a curve through points");
  return 0;
}

template <class FT, class... Given>
constexpr bool has_knot_vector = (std::is_convertible_v<const Given&, Knot_vector<FT>> || ...);

// Tells whether these are other arguments than iterators, or a range of points, and a Knot_vector.
template <class FT, class First, class Second, class... Others>
constexpr bool misses_knots = !has_knot_vector<FT, Second, Others...> &&
                              (sizeof...(Others) == 0 ? !std::is_same_v<First, Second> : !std::is_integral_v<First>);

template <class T, class = void> constexpr bool is_range = false;
template <class T> constexpr bool is_range<T, std::void_t<decltype(std::begin(std::declval<const T&>()))>> = true;

// Tells whether these are points, weights and knots, with the degree or without it, and not the
// arguments of a constructor with a Knot_vector at the end.
template <class FT, class First, class Second, class Third, class... Fourth>
constexpr bool misses_order = !has_knot_vector<FT, Third> &&
                              (int(is_range<First> + is_range<Second> + is_range<Third>) + ... + is_range<Fourth>) == 3;

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// The data of a B-spline curve: its control points \f$ b_0, \dots, b_{n-1} \f$ and its knots. This
/// base of `Bspline_curve` stores and checks them, and answers what needs no evaluation.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Bspline_polygon : public internal::Other_members {
  static_assert(internal::Checked_traits<Traits_>::value);

public:
  typedef internal::Traits_or_none<Traits_> Traits;              ///< the traits class
  typedef typename Traits::FT FT;                                ///< the field
  typedef typename Traits::Point Point;                          ///< the points of the kernel
  typedef typename Traits::Vector Vector;                        ///< the vectors of the kernel
  typedef Geometric_continuity::Coordinates<Traits> Coordinates; ///< the coordinates of a point
  /// the dimension, or 0 when it is known at run time only
  static constexpr int N = dimension_v<Traits>;
  /// iterates over the control points
  typedef typename std::vector<Point>::const_iterator const_iterator;
  /// a container with one entry for each control point
  template <class T> using Per_point = std::vector<T>;
  /// the coordinates as a function of the parameter
  typedef Bspline_function<FT, Coordinates> Function;

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

#ifndef CGAL_NO_DEPRECATED_CODE
  /// \cond SKIP_IN_MANUAL
  [[deprecated("call domain().first")]] FT start_parameter() const { return domain().first; }
  [[deprecated("call domain().second")]] FT end_parameter() const { return domain().second; }
  /// \endcond
#endif

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
    for (int j = 0; j < c.number_of_points(); ++j) os << ' ' << c.coordinates(j);
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

/// \ingroup PkgGeometricContinuityCurves
/// A B-spline curve \f$ \sum_{i=0}^{n-1} b_i N_i^p(u) \f$ with control points
/// \f$ b_0, \dots, b_{n-1} \f$ over a `Knot_vector` on the domain \f$ [u_p, u_n] \f$. The knots may
/// have any multiplicity up to `p + 1`, and need not be clamped.
///
/// The curve is a value: operations return new curves. With an exact kernel they are exact. With
/// rounded numbers, insertion, refinement and Bézier pieces take convex combinations only.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \cgalModels{ParametricCurve}
template <class Traits_> class Bspline_curve : public Bspline_polygon<Traits_> {
  typedef Bspline_polygon<Traits_> Polygon;
  using Polygon::knots_;
  using Polygon::points_;
  using typename Polygon::Coordinates;

public:
  using typename Polygon::Traits;              ///< the traits class
  typedef typename Traits::FT FT;              ///< the field
  typedef typename Traits::Point Point;        ///< the points of the kernel
  typedef typename Traits::Vector Vector;      ///< the vectors of the kernel
  typedef typename Polygon::Function Function; ///< the coordinates as a function of the parameter
  using Polygon::N;

  using Polygon::degree;
  using Polygon::dimension;
  using Polygon::domain;
  using Polygon::function;

  /// Makes a curve without control points, for containers that need one: nothing may be done with
  /// it but to assign another one to it.
  Bspline_curve() : Polygon(Knot_vector<FT>(0, {FT(0), FT(1)}), {}) {}

  /// Takes control points and the knots.
  /// \throws Error `wrong_number_of_points` unless there are `n` points
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class InputIterator>
  Bspline_curve(InputIterator first, InputIterator last, Knot_vector<FT> knots)
      : Bspline_curve(std::vector<Point>(first, last), std::move(knots)) {}

  /// Takes a range of control points, such as a `std::vector`, and the knots. \throws Error as the
  /// constructor from iterators
  template <class Points, class = internal::Range_of_points<Points, Point>>
  Bspline_curve(const Points& points, Knot_vector<FT> knots)
      : Bspline_curve(std::begin(points), std::end(points), std::move(knots)) {}

  /// Takes a vector of control points that is not needed any more, and the knots. \throws Error as
  /// the constructor from iterators
  Bspline_curve(std::vector<Point>&& points, Knot_vector<FT> knots) : Polygon(std::move(knots), std::move(points)) {
    internal::check_number_of_coefficients(knots_, points_, "Bspline_curve");
    this->check_points();
  }

  /// Takes the degree, all knots and the control points, also in braces, as in
  /// `Bspline_curve<Traits>(2, {0, 0, 0, 1, 1, 1}, {p, q, r})`.
  /// \throws Error as the constructor from iterators, and as that of `Knot_vector`
  template <class Number = FT>
  Bspline_curve(int given_degree, const std::vector<Number>& knots, std::vector<Point> points)
      : Bspline_curve(std::move(points), Knot_vector<FT>(given_degree, knots)) {}

  // These refuse other orders of the arguments, and calls without knots or the degree.
  template <class Number = FT>
  Bspline_curve(int, const std::vector<Point>& points, const std::vector<Number>& knots)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  Bspline_curve(const std::vector<Point>& points, const std::vector<Number>& knots, int)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  Bspline_curve(const std::vector<Point>& points, int, const std::vector<Number>& knots)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  Bspline_curve(const std::vector<Number>& knots, const std::vector<Point>& points, int)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  Bspline_curve(const std::vector<Number>& knots, int, const std::vector<Point>& points)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  Bspline_curve(const std::vector<Number>& knots, const std::vector<Point>& points)
      : Bspline_curve(internal::refused_order<Number>(), knots, points) {}
  template <class Number = FT>
  explicit Bspline_curve(const std::vector<Point>& points)
      : Bspline_curve(internal::refused_order<Number>(), std::vector<FT>(), points) {}
  template <class Given, class Number, class = std::enable_if_t<std::is_same_v<Given, Point>>>
  Bspline_curve(std::initializer_list<Given> points, const std::vector<Number>&)
      : Bspline_curve(internal::refused_order<Number>(), std::vector<FT>(), std::vector<Point>(points)) {}
  template <int Degree>
  explicit Bspline_curve(const std::vector<Bezier_curve<Traits, Degree>>& curves)
      : Bspline_curve(curves.begin(), curves.end()) {
    static_assert(Degree != Degree,
                  "Bspline_curve<Traits>(curves.begin(), curves.end()) joins Bezier curves that meet");
  }
  template <class First, class Second, class... Others,
            class = std::enable_if_t<internal::misses_knots<FT, First, Second, Others...>>>
  Bspline_curve(const First&, const Second&, const Others&...)
      : Bspline_curve(internal::refused_order<First>(), std::vector<FT>(), std::vector<Point>()) {}

  /// Takes the coordinates as a function.
  /// \throws Error `dimension_mismatch` when the coefficients differ in dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  explicit Bspline_curve(const Function& f) : Polygon(f.knots(), {}) {
    for (const Coordinates& x : f.coefficients()) points_.push_back(Geometric_continuity::to_point<Traits>(x));
    this->check_points();
  }

  /// Converts a Bézier curve; the B-spline curve has no inner knots.
  template <int Degree>
  explicit Bspline_curve(const Bezier_curve<Traits, Degree>& c)
      : Polygon(Knot_vector<FT>(c.degree(), c.domain().first, c.domain().second),
                std::vector<Point>(c.begin(), c.end())) {}

  /// Takes a range of Bézier curves, each of which starts exactly where the one before it ends. The
  /// degree `p` is the highest of theirs; the others are elevated. The inner knots have
  /// multiplicity `p`; `remove_superfluous_knots()` leaves those that are needed. The pieces keep
  /// the lengths of their domains: \f$ u_p \f$ is the start of the first domain, and domains that
  /// continue each other are taken over as they are.
  /// \throws Error `wrong_number_of_points` for an empty range
  /// \throws Error `curves_do_not_meet`, `dimension_mismatch` when two neighbours do not fit
  /// \throws Error `empty_domain`, `not_finite` when knots become equal or overflow by rounding
  template <class ForwardIterator, class = typename std::iterator_traits<ForwardIterator>::value_type>
  Bspline_curve(ForwardIterator first, ForwardIterator last)
      : Bspline_curve(internal::Joined_bezier_curves<Traits>(first, last, 0, "Bspline_curve")) {}

  /// \name Evaluation
  /// At an end of the domain, the jets of both sides are the jet of the only side that there is.
  /// With floating-point numbers, derivatives that overflow are not refused.
  /// @{

  /// Returns the point at `u`, from the right where the curve jumps. \f$ O(\log n + p^2) \f$
  /// \throws Error `parameter_outside_domain` outside the domain, whose right end is included
  Point operator()(const FT& u) const {
    return Geometric_continuity::to_point<Traits>(jet_over<FT>(u, knots_.span(u), 0)[0]);
  }

  /// Returns the jet of order `k` at `u`, from the right at a knot; derivatives beyond the degree
  /// are zero. \f$ O(\log n + p^2 + p k^2) \f$
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> jet(const FT& u, int k) const { return right_jet(u, k); }

  /// Returns the jet of order `k` at `u`, from the left at a knot.
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> left_jet(const FT& u, int k) const { return Curve_jet<Traits>(left_jet_over<FT>(u, k)); }
  /// Returns the jet of order `k` at `u`, from the right at a knot.
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  Curve_jet<Traits> right_jet(const FT& u, int k) const { return Curve_jet<Traits>(right_jet_over<FT>(u, k)); }

  /// Returns the jet of order `k` at the start of the domain. \throws Error `negative_count` unless
  /// `k >= 0`
  Curve_jet<Traits> start_jet(int k) const { return right_jet(domain().first, k); }
  /// Returns the jet of order `k` at the end of the domain. \throws Error `negative_count` unless
  /// `k >= 0`
  Curve_jet<Traits> end_jet(int k) const { return left_jet(domain().second, k); }

  /// Returns the jet of order `k` at `u`, from the left at a knot, in another field, to which
  /// control points, knots and parameter are converted first: this is how an exact predicate reads
  /// a curve with `double` coordinates.
  /// \throws Error `parameter_outside_domain`, `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> left_jet_over(const FT& u, int k) const {
    return jet_over<Field>(u, knots_.left_span(u), k);
  }
  /// Returns the jet of order `k` at `u`, from the right at a knot, in another field, to which
  /// control points, knots and parameter are converted first. \throws Error
  /// `parameter_outside_domain`, `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> right_jet_over(const FT& u, int k) const {
    return jet_over<Field>(u, knots_.span(u), k);
  }
  /// Returns the jet of order `k` at the start of the domain in another field, to which control
  /// points and knots are converted first. \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const {
    return right_jet_over<Field>(domain().first, k);
  }
  /// Returns the jet of order `k` at the end of the domain in another field, to which control
  /// points and knots are converted first. \throws Error `negative_count` unless `k >= 0`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const {
    return left_jet_over<Field>(domain().second, k);
  }

  /// @}
  /// \name Other Curves
  /// @{

  /// \cond SKIP_IN_MANUAL
  using internal::Other_members::derivative; // with arguments
  /// \endcond

  /// Returns the derivative (hodograph): the curve of degree `p - 1` (0 for degree 0) whose point
  /// at `u` has the coordinates of the first derivative. Jumps are not differentiated. \f$ O(n) \f$
  /// \throws Error `not_finite` when a floating-point coordinate overflows
  Bspline_curve derivative() const { return Bspline_curve(function().derivative()); }

  /// Returns this curve over the knots with `times` more copies of `u`. \f$ O(n + p\,times) \f$
  /// \throws Error `parameter_outside_domain`, and `knot_multiplicity` when it would be repeated
  ///   more than `p + 1` times
  /// \throws Error `negative_count` unless `times >= 0`
  Bspline_curve insert(const FT& u, int times = 1) const {
    Knot_vector<FT> finer = knots_.insert(u, times);
    const internal::Knot_insertion<FT> insertion(knots_, u, times);
    const std::vector<Coordinates> changed =
        insertion.template new_coefficients<Coordinates>([&](int j) { return this->coordinates(j); });
    const auto point = [&](int i) { return Geometric_continuity::to_point<Traits>(changed[i]); };
    return Bspline_curve(internal::Unspecified(), std::move(finer), insertion.replaced(points_, point));
  }

  /// Returns this curve over finer knots, see `bspline_refine()`. \f$ O(n p^2) \f$
  /// \throws Error `wrong_number_of_points` when the degrees differ, `parameter_outside_domain`
  ///   when the domains differ, `knot_multiplicity` when a knot is missing
  Bspline_curve refine(const Knot_vector<FT>& finer) const { return Bspline_curve(function().refine(finer)); }

  /// Returns this curve without the knots outside the domain, and with control points at its ends.
  /// \f$ O(n p^2) \f$
  Bspline_curve clamp() const { return Bspline_curve(function().clamp()); }

  /// Returns this curve over the knots with `times` copies of the inner knot `u` less, or nothing
  /// when the curve needs them. Decided exactly, see `bspline_smoothness()`. \f$ O(n + p^3) \f$
  /// \throws Error `parameter_outside_domain` also at the ends of the domain
  /// \throws Error `knot_multiplicity` when there are not as many, `negative_count` unless
  ///   `times >= 0`
  std::optional<Bspline_curve> remove(const FT& u, int times = 1) const {
    internal::check_count(times, "Bspline_curve::remove");
    const std::optional<Function> f = function().remove(u, times);
    if (!f) return std::nullopt;
    return Bspline_curve(*f);
  }

  /// Returns this curve without the inner knots that it does not need, decided exactly.
  /// \f$ O(n p^3) \f$
  Bspline_curve remove_superfluous_knots() const { return Bspline_curve(function().remove_superfluous_knots()); }

  /// Returns this curve with the degree raised by `times`, clamped. The multiplicities of the inner
  /// knots rise as much. \f$ O(d^3) \f$ for each span, in the new degree `d`
  /// \throws Error `negative_count` unless `times >= 0`
  Bspline_curve elevate(int times = 1) const {
    internal::check_count(times, "Bspline_curve::elevate");
    const internal::Distinct_knots<FT> knots = internal::distinct_elevated_knots(knots_, times);
    return written(knots, [&](Write_points& output) {
      internal::elevate_spline<N>(knots, knots_, Rows_of_points{points_}, dimension(), output);
    });
  }

  /// Returns the curve with the coordinates of this one multiplied by the spline function `f`, see
  /// `bspline_product()`. \f$ O((p+q)^2) \f$ field operations for each span and coordinate, without
  /// a linear system.
  /// \throws Error `parameter_outside_domain` when the domains differ, `not_finite` when a
  ///   floating-point number overflows
  Bspline_curve multiply(const Bspline_function<FT>& f) const {
    const internal::Distinct_knots<FT> knots = internal::distinct_product_knots(f.knots(), knots_);
    return written(knots, [&](Write_points& output) {
      internal::multiply_splines<N>(knots, f.knots(), internal::Rows_of_coefficients<std::vector<FT>>{f.coefficients()},
                                    knots_, Rows_of_points{points_}, dimension(), output);
    });
  }

  /// Returns the curve in the opposite direction, on the same domain, see `Knot_vector::reverse()`.
  Bspline_curve reverse() const { return Bspline_curve(points_.rbegin(), points_.rend(), knots_.reverse()); }

  /// Returns the image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`. The
  /// images are not checked.
  template <class Transformation> Bspline_curve transform(const Transformation& map) const {
    Bspline_curve r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// Returns the Bézier curves on the spans, each with its span as domain, see `bspline_bezier()`.
  /// \f$ O(p^2) \f$ for each
  /// \throws Error `work_limit` when the points have common denominators that are too long
  std::vector<Bezier_curve<Traits>> bezier_pieces() const {
    const std::vector<Coordinates> rows = bspline_bezier<FT>(knots_, function().coefficients());
    std::vector<Point> points;
    for (const Coordinates& x : rows) points.push_back(Geometric_continuity::to_point<Traits>(x));
    std::vector<Bezier_curve<Traits>> pieces;
    auto first = points.begin();
    for (int k : knots_.spans()) {
      pieces.emplace_back(first, first + degree() + 1, knots_[k], knots_[k + 1]);
      first += degree() + 1;
    }
    return pieces;
  }

  /// Returns the jets of order `k` at both ends of each span: those of `bezier_pieces()`, of which
  /// with rational numbers and several spans only these are computed. \f$ O(p^2) \f$ for each,
  /// additions of integers
  /// \throws Error `negative_count` unless `k >= 0`, `work_limit` as `bezier_pieces()` does
  std::vector<Curve_end_jets<Traits>> span_end_jets(int k) const {
    internal::check_count(k, "Bspline_curve::span_end_jets");
    std::vector<Curve_end_jets<Traits>> result;
    const Work_scope scope(Work_scope::limit_of_each(), "derivatives of a spline");
    if constexpr (internal::is_rational_v<FT>)
      if (knots_.spans().size() > 1) {
        for (auto& [start, end] : internal::span_end_jets(knots_, function().coefficients(), k))
          result.emplace_back(std::move(start), std::move(end));
        return result;
      }
    for (const Bezier_curve<Traits>& piece : bezier_pieces()) result.emplace_back(piece, k);
    return result;
  }

  /// @}

private:
  Bspline_curve(internal::Unspecified, Knot_vector<FT> knots, std::vector<Point> points)
      : Polygon(std::move(knots), std::move(points)) {}

  typedef internal::Rows_of_points<Traits> Rows_of_points;
  typedef internal::Write_points<Traits> Write_points;

  // The inner knots have the multiplicity of the degree.
  explicit Bspline_curve(const internal::Joined_bezier_curves<Traits>& curves)
      : Bspline_curve(curves.points.begin(), curves.points.end(), knots_of(curves)) {}
  static Knot_vector<FT> knots_of(const internal::Joined_bezier_curves<Traits>& curves) {
    std::vector<typename Knot_vector<FT>::Knot> inner;
    for (std::size_t l = 1; l + 1 < curves.knots.size(); ++l) inner.push_back({curves.knots[l], curves.degree});
    return Knot_vector<FT>(curves.degree, curves.knots.front(), curves.knots.back(), inner);
  }

  // The curve over these knots with the points that work(output) writes.
  template <class Work> Bspline_curve written(const internal::Distinct_knots<FT>& knots, Work work) const {
    std::vector<Point> points(knots.number_of_coefficients());
    Write_points output{dimension(), points.data()};
    work(output);
    if (!output.finite) throw Error(Error_code::not_finite, "Bspline_curve: control points");
    return Bspline_curve(internal::Unspecified(), knots.knot_vector(), std::move(points));
  }

  template <class Field> Coordinate_jet<Field, N> jet_over(const FT& u, int span, int k) const {
    Coordinate_jet<Field, N> jet(dimension(), k);
    internal::derivatives_over<Field>(
        knots_, span, u, k, [&](int i) { return Geometric_continuity::coordinates<Traits, Field>(points_[i]); },
        [&](int j, const Coordinate_vector<Field, N>& x) { jet[j] = x; });
    return jet;
  }
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the curve with the coordinates of `c` multiplied by the spline function `f`,
/// `c.multiply(f)`.
/// \throws Error `parameter_outside_domain` when the domains differ, `not_finite` when a
///   floating-point number overflows
template <class Traits>
Bspline_curve<Traits> product(const Bspline_function<typename Traits::FT>& f, const Bspline_curve<Traits>& c) {
  return c.multiply(f);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BSPLINE_CURVE_H
