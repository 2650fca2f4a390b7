// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/curves/internal/bernstein_jet.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Geometric_continuity/internal/disable_loop_warnings.h>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCurves
/// The degree of a curve whose degree is known at run time only.
constexpr int dynamic_degree = -1;

/// \ingroup PkgGeometricContinuityCurves
/// A Bézier curve \f$ \sum_{i=0}^m b_i B_i^m((u-a)/(b-a)) \f$ with control points \f$ b_0, \dots, b_m \f$ on the domain
/// [a, b], by default [0, 1]. All derivatives are taken with respect to the parameter `u` of the domain.
///
/// With a degree fixed at compile time, construction, evaluation, jets up to order 5, derivative, split, elevation by a
/// fixed number, reversal, transformation and bounding box allocate no memory (provided that the numbers and points of the
/// kernel do not).
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Degree the degree `m >= 0`, or `dynamic_degree`
/// \models ParametricCurve
template <class Traits_, int Degree = dynamic_degree> class Bezier_curve {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  static constexpr int N = dimension_v<Traits>;

private:
  template <class T>
  using Per_point = std::conditional_t<Degree == dynamic_degree, std::vector<T>, std::array<T, Degree + 1>>;
  typedef Geometric_continuity::Coordinates<Traits> Coordinates;
  // the numbers of one coordinate; without allocation up to degree 9
  template <class Field>
  using Coefficients = std::conditional_t<Degree == dynamic_degree, boost::container::small_vector<Field, 10>,
                                          std::array<Field, Degree + 1>>;

  Per_point<Point> points_;
  FT a_ = FT(0), b_ = FT(1);

public:
  typedef typename Per_point<Point>::const_iterator const_iterator;

  /// From a range of control points and the domain.
  /// \throws Error `wrong_number_of_points` unless the range has `Degree + 1` points (at least one, if dynamic)
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class InputIterator>
  Bezier_curve(InputIterator first, InputIterator last, const FT& a = FT(0), const FT& b = FT(1)) : a_(a), b_(b) {
    if constexpr (Degree == dynamic_degree)
      points_.assign(first, last);
    else {
      int i = 0;
      for (; first != last && i <= Degree; ++first, ++i) points_[i] = *first;
      if (i <= Degree || first != last) refuse_number_of_points();
    }
    check();
  }

  /// From the coordinates of the control points, and the domain. Errors as above.
  BOOST_FORCEINLINE explicit Bezier_curve(const Per_point<Coordinates>& rows, const FT& a = FT(0), const FT& b = FT(1))
      : points_(points_of(rows)), a_(a), b_(b) {
    check();
  }

  /// From a list of control points, on [0, 1].
  Bezier_curve(std::initializer_list<Point> points) : Bezier_curve(points.begin(), points.end()) {}

  /// The same curve with its degree forgotten, or remembered.
  template <int Other, class = std::enable_if_t<Other != Degree>>
  Bezier_curve(const Bezier_curve<Traits, Other>& c)
      : Bezier_curve(c.begin(), c.end(), c.domain().first, c.domain().second) {
    static_assert(Other == dynamic_degree || Degree == dynamic_degree, "the degrees differ");
  }

  int degree() const { return static_cast<int>(points_.size()) - 1; }
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }

  /// The control points, in order.
  const Per_point<Point>& control_points() const { return points_; }
  const Point& control_point(int i) const { return points_[i]; }
  const_iterator begin() const { return points_.begin(); }
  const_iterator end() const { return points_.end(); }

  /// The domain [a, b].
  std::pair<FT, FT> domain() const { return {a_, b_}; }

  /// The point at `u`, which may lie outside the domain: the polynomial is extended. \f$ O(m^2) \f$
  Point operator()(const FT& u) const {
    Coordinates x(dimension());
    const FT t = local_parameter(u);
    for_each_coordinate([&](int i) {
      Coefficients<FT> c = coefficients(i);
      if constexpr (Degree == dynamic_degree)
        x[i] = bernstein_value(c, degree(), t);
      else
        internal::bernstein_jet<Degree, 0>(c, FT(FT(1) - t), t, &x[i]);
    });
    return Geometric_continuity::to_point<Traits>(x);
  }

  /// The jet of order `k >= 0` at `u`; derivatives beyond the degree are zero. \f$ O(m^2 + k^3) \f$
  Curve_jet<Traits> jet(const FT& u, int k) const {
    if constexpr (Degree == dynamic_degree)
      return jet_of_any_order(u, k);
    else
      switch (k) {
      case 0: return jet<0>(u);
      case 1: return jet<1>(u);
      case 2: return jet<2>(u);
      case 3: return jet<3>(u);
      default: return jet_of_any_order(u, k);
      }
  }

  /// The same with an order that is known at compile time. \f$ O(m^2 + k^3) \f$
  template <int k> Curve_jet<Traits> jet(const FT& u) const {
    static_assert(k >= 0);
    if constexpr (Degree == dynamic_degree)
      return jet_of_any_order(u, k);
    else
      return jet_of_order<k>(u);
  }

  /// The jet of order `k` at the start of the domain, from the first `k + 1` control points.
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }

  /// The jet of order `k` at the end of the domain, from the last `k + 1` control points.
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }

  /// The same in another field, to which the control points and the domain are converted first: this is how an
  /// exact predicate reads a curve with `double` coordinates.
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const { return end_jet_over<Field>(k, false); }
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const { return end_jet_over<Field>(k, true); }

  /// The derivative (hodograph): the curve of degree `m - 1` (0 for a constant) whose point at `u` has the coordinates of
  /// the first derivative.
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

  /// The parts on [a, u] and [u, b]. \throws Error `parameter_outside_domain` unless `a < u < b`
  std::pair<Bezier_curve, Bezier_curve> split(const FT& u) const {
    if (!(a_ < u && u < b_)) throw Error(Error_code::parameter_outside_domain, "Bezier_curve::split");
    const FT t = local_parameter(u);
    Per_point<Coordinates> right = coordinate_rows(), left = right;
    bernstein_split(right, degree(), t, left);
    return {Bezier_curve(left, a_, u), Bezier_curve(right, u, b_)};
  }

  /// The same curve with the degree raised by `times >= 0`.
  Bezier_curve<Traits> elevate(int times = 1) const {
    return elevated<Bezier_curve<Traits>>(std::vector<Coordinates>(degree() + 1 + times, Coordinates(dimension())));
  }

  /// The same curve with a fixed degree raised by `times`, without allocation.
  template <int times> Bezier_curve<Traits, Degree + times> elevate_fixed() const {
    static_assert(Degree != dynamic_degree && times >= 0);
    std::array<Coordinates, Degree + times + 1> rows;
    rows.fill(Coordinates(dimension()));
    return elevated<Bezier_curve<Traits, Degree + times>>(rows);
  }

  /// The curve run through backwards, on the same domain.
  Bezier_curve reverse() const {
    Bezier_curve r = *this;
    std::reverse(r.points_.begin(), r.points_.end());
    return r;
  }

  /// The same points on another domain. \throws Error `empty_domain` unless `a < b`
  Bezier_curve with_domain(const FT& a, const FT& b) const { return Bezier_curve(begin(), end(), a, b); }

  /// The image under an affine map of points, e.g. a `CGAL::Aff_transformation_3`.
  template <class Transformation> Bezier_curve transform(const Transformation& map) const {
    Bezier_curve r = *this;
    for (Point& p : r.points_) p = map(p);
    return r;
  }

  /// Two opposite corners of the bounding box of the control points, which contains the curve.
  std::pair<Point, Point> bounding_box() const {
    Coordinates low = coordinates(0), high = low;
    for (int j = 1; j <= degree(); ++j) {
      const Coordinates p = coordinates(j);
      for (int i = 0; i < p.dimension(); ++i) {
        if (p[i] < low[i]) low[i] = p[i];
        if (high[i] < p[i]) high[i] = p[i];
      }
    }
    return {Geometric_continuity::to_point<Traits>(low), Geometric_continuity::to_point<Traits>(high)};
  }

  /// The bounding box of the control points as `Bbox_2` or `Bbox_3`, rounded outwards. Dimension 2 or 3 only.
  auto bbox() const {
    static_assert(N == 2 || N == 3, "bounding_box() serves the other dimensions");
    const std::pair<Point, Point> box = bounding_box();
    const Coordinates low = Geometric_continuity::coordinates<Traits>(box.first),
                      high = Geometric_continuity::coordinates<Traits>(box.second);
    if constexpr (N == 2)
      return Bbox_2(lower(low[0]), lower(low[1]), upper(high[0]), upper(high[1]));
    else
      return Bbox_3(lower(low[0]), lower(low[1]), lower(low[2]), upper(high[0]), upper(high[1]), upper(high[2]));
  }

  /// \f$ \int_a^b |x^{(k)}(u)|^2 du \f$, exactly. \f$ O(n m^2) \f$ in dimension `n`
  FT energy(int k) const {
    const FT h = FT(b_ - a_);
    FT scale(h), sum(0);
    for (int j = 0; j < k; ++j) scale /= h * h;
    for (int i = 0; i < dimension(); ++i) {
      Bernstein_polynomial<FT> p(coordinate_polynomial(i));
      for (int j = 0; j < k; ++j) p = p.derivative();
      sum += (p * p).integral();
    }
    return FT(scale * sum);
  }

  /// The `i`-th coordinate as a polynomial of the local parameter \f$ t = (u-a)/(b-a) \f$.
  Bernstein_polynomial<FT> coordinate_polynomial(int i) const {
    const Coefficients<FT> c = coefficients(i);
    return Bernstein_polynomial<FT>(c.begin(), c.end());
  }

  /// The coordinates of the `j`-th control point.
  Coordinates coordinates(int j) const { return Geometric_continuity::coordinates<Traits>(points_[j]); }

  /// Equality of control points and domain.
  friend bool operator==(const Bezier_curve& c, const Bezier_curve& d) {
    if (c.a_ != d.a_ || c.b_ != d.b_ || c.degree() != d.degree()) return false;
    for (int j = 0; j <= c.degree(); ++j)
      if (c.coordinates(j) != d.coordinates(j)) return false;
    return true;
  }
  friend bool operator!=(const Bezier_curve& c, const Bezier_curve& d) { return !(c == d); }

  /// Writes the domain and the control points.
  friend std::ostream& operator<<(std::ostream& os, const Bezier_curve& c) {
    os << "Bezier curve of degree " << c.degree() << " on [" << c.a_ << ", " << c.b_ << "]:";
    for (int j = 0; j <= c.degree(); ++j) {
      const Coordinates p = c.coordinates(j);
      os << " (";
      for (int i = 0; i < p.dimension(); ++i) os << (i == 0 ? "" : ", ") << p[i];
      os << ')';
    }
    return os;
  }

private:
  BOOST_NOINLINE void refuse_number_of_points() const {
    throw Error(Error_code::wrong_number_of_points,
                "Bezier_curve: " + (Degree == dynamic_degree ? std::string("at least one control point is needed")
                                                             : "degree " + std::to_string(Degree) + " needs " +
                                                                   std::to_string(Degree + 1) + " control points"));
  }

  BOOST_FORCEINLINE void check() const {
    if (points_.empty()) refuse_number_of_points();
    if (!(a_ < b_)) throw Error(Error_code::empty_domain, "Bezier_curve");
    if constexpr (N == 0)
      for (int j = 0; j <= degree(); ++j)
        if (Traits().compute_dimension_object()(points_[j]) != dimension())
          throw Error(Error_code::dimension_mismatch, "Bezier_curve: control point " + std::to_string(j));
    if constexpr (std::is_floating_point_v<FT>) {
      const Traits traits;
      FT sum = a_ + b_; // not finite if one of the numbers is not
      for_each_point([&](int j) {
        FT x = traits.compute_coordinate_object()(points_[j], 0);
        for_each_coordinate([&](int i) {
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
    for (int j = 0; j <= degree(); ++j)
      for (const FT& x : coordinates(j)) internal::check_finite(x, "Bezier_curve: control points");
  }

  FT local_parameter(const FT& u) const { return FT((u - a_) / (b_ - a_)); }

  // f(i) for each coordinate number i
  template <class Function> BOOST_FORCEINLINE void for_each_coordinate(const Function& f) const {
    if constexpr (N == 0)
      for (int i = 0; i < dimension(); ++i) f(i);
    else
      internal::for_each_index<N>(f);
  }

  // f(j) for each control point number j
  template <class Function> BOOST_FORCEINLINE void for_each_point(const Function& f) const {
    if constexpr (Degree == dynamic_degree)
      for (int j = 0; j <= degree(); ++j) f(j);
    else
      internal::for_each_index<Degree + 1>(f);
  }

  // the i-th coordinates of all control points
  BOOST_FORCEINLINE Coefficients<FT> coefficients(int i) const {
    const Traits traits;
    Coefficients<FT> c;
    if constexpr (Degree == dynamic_degree) c.resize(points_.size());
    for_each_point([&](int j) { c[j] = FT(traits.compute_coordinate_object()(points_[j], i)); });
    return c;
  }

  template <int k> Curve_jet<Traits> jet_of_order(const FT& u) const {
    const FT h = FT(b_ - a_), t = FT((u - a_) / h), s = FT(FT(1) - t);
    const std::array<FT, k + 1> factors = internal::derivative_factors<k>(Degree, h);
    const int n = N == 0 ? dimension() : N;
    Curve_jet<Traits> jet(n, k, internal::Unspecified());
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < n; ++i) {
      Coefficients<FT> c = coefficients(i);
      std::array<FT, k + 1> d;
      internal::bernstein_jet<Degree, k>(c, s, t, d.data());
      jet[0][i] = d[0];
      internal::for_each_index<k>([&](int j) { jet[j + 1][i] = FT(factors[j + 1] * d[j + 1]); });
    }
    return jet;
  }

  // All coordinates together where their number is known to the compiler, otherwise one after the other.
  Curve_jet<Traits> jet_of_any_order(const FT& u, int k) const {
    constexpr int width = N == 0 ? 1 : N;
    typedef Coordinate_vector<FT, width> Block;
    const Traits traits;
    Curve_jet<Traits> jet(dimension(), k);
    const FT t = local_parameter(u), inverse = FT(FT(1) / FT(b_ - a_));
    for (int first = 0; first < dimension(); first += width) {
      Coefficients<Block> c;
      if constexpr (Degree == dynamic_degree) c.resize(points_.size());
      for_each_point([&](int j) {
        for (int i = 0; i < width; ++i) c[j][i] = FT(traits.compute_coordinate_object()(points_[j], first + i));
      });
      FT scale(1);
      bernstein_derivatives(c, degree(), t, k, [&](int j, const Block& x) {
        for (int i = 0; i < width; ++i) jet[j][first + i] = scale * x[i];
        scale *= inverse;
      });
    }
    return jet;
  }

  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k, bool at_end) const {
    const Traits traits;
    const int m = degree(), used = std::min(k, m) + 1;
    const Field h = internal::to_field<Field>(b_) - internal::to_field<Field>(a_);
    Coordinate_jet<Field, N> jet(dimension(), k);
    for (int i = 0; i < dimension(); ++i) {
      Coefficients<Field> c;
      if constexpr (Degree == dynamic_degree) c.resize(used);
      for (int j = 0; j < used; ++j)
        c[j] = internal::to_field<Field>(FT(traits.compute_coordinate_object()(points_[at_end ? m - j : j], i)));
      Field scale(1);
      bernstein_end_derivatives<Field>(c, m, k, [&](int j, const Field& x) {
        jet[j][i] = x / scale;
        scale *= h;
        if (at_end) scale = -scale;
      });
    }
    return jet;
  }

  Per_point<Coordinates> coordinate_rows() const {
    Per_point<Coordinates> rows;
    if constexpr (Degree == dynamic_degree) rows.resize(points_.size());
    for (int j = 0; j <= degree(); ++j) rows[j] = coordinates(j);
    return rows;
  }

  static Per_point<Point> points_of(const Per_point<Coordinates>& rows) {
    if constexpr (Degree == dynamic_degree) {
      std::vector<Point> points;
      points.reserve(rows.size());
      for (const Coordinates& x : rows) points.push_back(Geometric_continuity::to_point<Traits>(x));
      return points;
    } else
      return points_of(rows, std::make_index_sequence<Degree + 1>());
  }
  template <std::size_t... j>
  static Per_point<Point> points_of(const Per_point<Coordinates>& rows, std::index_sequence<j...>) {
    return {{Geometric_continuity::to_point<Traits>(rows[j])...}};
  }

  template <class Curve, class Rows> Curve elevated(Rows rows) const {
    for (int j = 0; j <= degree(); ++j) rows[j] = coordinates(j);
    for (int n = degree(); n + 1 < static_cast<int>(rows.size()); ++n) bernstein_elevate<FT>(rows, n);
    return Curve(rows, a_, b_);
  }

  static double lower(const FT& x) { return CGAL::to_interval(x).first; }
  static double upper(const FT& x) { return CGAL::to_interval(x).second; }
};

} // namespace Geometric_continuity
} // namespace CGAL

#include <CGAL/Geometric_continuity/internal/enable_loop_warnings.h>

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_CURVE_H
