// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/internal/decision_numbers.h>
#include <CGAL/Geometric_continuity/local/internal/Scaled_vector.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file bezier_properties.h
/// Properties that the control points show: of a Bézier curve hull, line, variation, and curvature
/// and torsion at the ends; and two tricks with them: points that pull, and polygons that close.
/// Lecture slides, "Bézier curves III", "Bézier curve tricks". Basis_matrix.h has the properties of
/// the Bernstein polynomials from which it follows. Of all curves whether they lie in a plane.
///
/// Hagen 1.13: a curve is planar if and only if its torsion vanishes. This holds for one polynomial
/// or rational piece, and for several only where the curvature does not vanish at their joins:
/// \f$ (t, t^4, 0) \f$ for \f$ t \le 0 \f$ and \f$ (t, 0, t^4) \f$ for \f$ t \ge 0 \f$ have no
/// torsion where it is defined, and no plane in common. So the control points are decided, and not
/// the torsion.

namespace CGAL {
namespace Geometric_continuity {

template <class Traits> class Bspline_curve;
template <class Shape> class Rational_curve;

namespace internal {

// The first phase of the simplex algorithm: w >= 0 with A w = b, for b >= 0. The pivots are those
// of Bland's rule, with which it ends although nearly all of b is zero here.
template <class Field> class Feasible_solution {
  typedef std::vector<Field> Row;
  // [A | b], transformed so that the columns basis_[i] of the chosen w are unit vectors
  std::vector<Row> rows_;
  Row cost_;               // minus the sum of the rows whose w is not chosen yet
  std::vector<int> basis_; // the w of each row; n where there is none yet
  int n_;

public:
  Feasible_solution(std::vector<Row> rows, int n) : rows_(std::move(rows)), cost_(n + 1, Field(0)), n_(n) {
    basis_.assign(rows_.size(), n_);
    for (const Row& row : rows_)
      for (int j = 0; j <= n_; ++j) cost_[j] -= row[j];
  }

  std::optional<Row> operator()() {
    for (int column = entering(); column < n_; column = entering()) pivot(leaving(column), column);
    if (!(cost_[n_] == Field(0))) return std::nullopt;
    Row w(n_, Field(0));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (basis_[i] < n_) w[basis_[i]] = rows_[i][n_];
    return w;
  }

private:
  int entering() const {
    int j = 0;
    while (j < n_ && !(cost_[j] < Field(0))) ++j;
    return j;
  }

  // the row of the least quotient; of several, that of the first w, and those without come last
  int leaving(int column) const {
    int best = -1;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i) {
      if (!(Field(0) < rows_[i][column])) continue;
      if (best >= 0) {
        const Field here = rows_[i][n_] * rows_[best][column], there = rows_[best][n_] * rows_[i][column];
        if (there < here || (here == there && basis_[best] <= basis_[i])) continue;
      }
      best = i;
    }
    return best;
  }

  void pivot(int row, int column) {
    const Field p = rows_[row][column];
    for (Field& x : rows_[row]) x /= p;
    for (int i = 0; i < static_cast<int>(rows_.size()); ++i)
      if (i != row) eliminate(rows_[i], rows_[row], column);
    eliminate(cost_, rows_[row], column);
    basis_[row] = column;
  }

  static void eliminate(Row& x, const Row& row, int column) {
    const Field factor = x[column];
    if (factor == Field(0)) return;
    for (std::size_t j = 0; j < x.size(); ++j) x[j] -= factor * row[j];
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Computes weights \f$ w_i \ge 0 \f$ with \f$ \sum_i w_i = 1 \f$ and \f$ \sum_i w_i q_i = p \f$:
/// they prove that `p` is in the convex hull of the points `q`. At most one more of them than the
/// dimension is not zero. Empty if and only if `p` is outside. Exact in any dimension:
/// floating-point coordinates are taken as the rational numbers they are. By the simplex algorithm
/// with Bland's rule; fast in practice.
/// \throws Error `dimension_mismatch` when the points differ in dimension
/// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
template <class FT, int N>
std::optional<std::vector<typename Exact_field<FT>::type>>
convex_weights(const std::vector<Coordinate_vector<FT, N>>& q, const Coordinate_vector<FT, N>& p) {
  typedef typename Exact_field<FT>::type Field;
  const int n = static_cast<int>(q.size()), d = p.dimension();
  std::vector<std::vector<Field>> rows(d + 1, std::vector<Field>(n + 1, Field(0)));
  for (int j = 0; j < n; ++j) {
    if (q[j].dimension() != d)
      throw Error(Error_code::dimension_mismatch, "convex_weights: point " + std::to_string(j));
    for (int i = 0; i < d; ++i) rows[i][j] = internal::to_field<Field>(q[j][i]) - internal::to_field<Field>(p[i]);
    rows[d][j] = Field(1);
  }
  rows[d][n] = Field(1);
  return internal::Feasible_solution<Field>(rows, n)();
}

namespace internal {

template <class Traits, class Field, int Degree>
std::vector<Coordinate_vector<Field, dimension_v<Traits>>> control_columns(const Bezier_curve<Traits, Degree>& curve) {
  std::vector<Coordinate_vector<Field, dimension_v<Traits>>> columns;
  for (const typename Traits::Point& p : curve) columns.push_back(Geometric_continuity::coordinates<Traits, Field>(p));
  return columns;
}

template <class Traits> typename Traits::Vector direction(const Coordinates<Traits>& v, const char* place) {
  for (const typename Traits::FT& x : v) check_finite(x, place);
  return to_vector<Traits>(v);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns weights \f$ w_i \ge 0 \f$ with \f$ \sum_i w_i = 1 \f$ and \f$ \sum_i w_i b_i = p \f$ for
/// the control points, which prove that `p` is in their convex hull; empty if and only if it is
/// outside. Exact with every kernel for the coordinates as given, in any dimension. See
/// `convex_weights()`.
/// \throws Error `dimension_mismatch` when `p` has another dimension
/// \throws Error `not_finite` when `p` has an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
std::optional<std::vector<internal::Decision_FT<Traits>>> convex_hull_weights(const Bezier_curve<Traits, Degree>& curve,
                                                                              const typename Traits::Point& p) {
  typedef internal::Decision_FT<Traits> Field;
  return convex_weights(internal::control_columns<Traits, Field>(curve),
                        Geometric_continuity::coordinates<Traits, Field>(p));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns whether `p` is in the convex hull of the control points, or on its boundary. Every point
/// of the curve is, for parameters in the domain: its weights are the values of the Bernstein
/// polynomials there. (With rounded numbers the point that the curve returns may be just outside.)
/// Exact with every kernel for the coordinates as given. See `convex_hull_weights()`.
/// \throws Error `dimension_mismatch` when `p` has another dimension
/// \throws Error `not_finite` when `p` has an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
bool is_in_convex_hull(const Bezier_curve<Traits, Degree>& curve, const typename Traits::Point& p) {
  return bool(convex_hull_weights(curve, p));
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the direction in which the curve starts: the first \f$ b_j - b_0 \f$ that is not zero.
/// It is a positive multiple of the first derivative that does not vanish, so it is that of the
/// side \f$ b_1 - b_0 \f$ in general. Empty when all control points are equal. \f$ O(m) \f$ \throws
/// Error `not_finite` when a floating-point coordinate overflows
template <class Traits, int Degree>
std::optional<typename Traits::Vector> start_tangent(const Bezier_curve<Traits, Degree>& curve) {
  for (int j = 1; j <= curve.degree(); ++j)
    if (curve.coordinates(j) != curve.coordinates(0))
      return internal::direction<Traits>(curve.coordinates(j) - curve.coordinates(0), "start_tangent");
  return std::nullopt;
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the direction in which the curve ends: the last \f$ b_m - b_j \f$ that is not zero, in
/// general the side \f$ b_m - b_{m-1} \f$. Empty when all control points are equal. \f$ O(m) \f$
/// \throws Error `not_finite` when a floating-point coordinate overflows
template <class Traits, int Degree>
std::optional<typename Traits::Vector> end_tangent(const Bezier_curve<Traits, Degree>& curve) {
  const int m = curve.degree();
  for (int j = m - 1; j >= 0; --j)
    if (curve.coordinates(j) != curve.coordinates(m))
      return internal::direction<Traits>(curve.coordinates(m) - curve.coordinates(j), "end_tangent");
  return std::nullopt;
}

/// \ingroup PkgGeometricContinuityCurves
/// The numbers of times that a curve and its control polygon meet a line in the plane, a plane in
/// space, or a hyperplane.
struct Crossings {
  /// changes of side from control point to control point, those on the hyperplane left out
  int polygon = 0;
  int curve = 0;    ///< changes of side of the curve
  int contacts = 0; ///< common points other than the end points, each as often as its multiplicity
  /// Returns whether the curve does not cross more often than its polygon. So it is for every curve
  /// and hyperplane.
  bool diminished() const { return curve <= contacts && contacts <= polygon; }
};

/// \ingroup PkgGeometricContinuityCurves
/// Counts the crossings with the hyperplane through `origin` that is orthogonal to `normal`. Exact
/// with every kernel for the coordinates as given: the signed distances \f$ (b_i - q) \cdot n \f$
/// are the coefficients of a Bernstein polynomial, the roots of which are counted. Empty when the
/// whole curve is in the hyperplane.
/// \throws Error `zero_direction` when the normal is zero
/// \throws Error `dimension_mismatch` when the dimensions differ
/// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
template <class Traits, int Degree>
std::optional<Crossings> count_crossings(const Bezier_curve<Traits, Degree>& curve,
                                         const typename Traits::Point& origin, const typename Traits::Vector& normal) {
  typedef internal::Decision_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Traits>> Column;
  const Column q = Geometric_continuity::coordinates<Traits, Field>(origin),
               n = Geometric_continuity::coordinates<Traits, Field>(normal);
  if (q.dimension() != curve.dimension() || n.dimension() != curve.dimension())
    throw Error(Error_code::dimension_mismatch, "count_crossings");
  if (is_zero(n)) throw Error(Error_code::zero_direction, "count_crossings: normal");
  std::vector<Field> distances;
  for (const Column& b : internal::control_columns<Traits, Field>(curve)) distances.push_back(dot(b - q, n));
  const Bernstein_polynomial<Field> distance(distances);
  if (sign_pattern(distance) == Sign_pattern::zero) return std::nullopt;
  Crossings count;
  count.polygon = internal::sign_variations(internal::whole_multiple(distance));
  for (const Isolated_root<Field>& root : isolate_roots(distance, Field(1))) {
    if (root.end == Field(0) || root.begin == Field(1)) continue; // an end point of the curve
    count.contacts += root.multiplicity;
    count.curve += root.multiplicity % 2;
  }
  return count;
}

/// \ingroup PkgGeometricContinuityCurves
/// Curvature and torsion at one end of a Bézier curve. They do not depend on the length of the
/// domain.
template <class FT> struct End_invariants {
  std::optional<FT> curvature_squared; ///< empty where the end side is zero
  std::optional<FT> torsion;           ///< empty unless in space with nonzero curvature
};

namespace internal {

// From the vectors p = b0 - b1, r = b2 - b1, s = b2 - b3 of a polygon of degree m, numbered from
// its end inwards. Scaled, so that no product of floating-point numbers overflows.
template <class FT, int N>
End_invariants<FT> invariants_from_differences(int m, const std::vector<Coordinate_vector<FT, N>>& b) {
  typedef Coordinate_vector<FT, N> Coordinates;
  constexpr const char* place = "end_invariants";
  End_invariants<FT> result;
  if (m < 1) return result;
  const Coordinates first = b[0] - b[1];
  const Scaled_vector<FT, N> p(first, place);
  const FT pp = dot(*p, *p);
  if (pp == FT(0)) return result;
  if (m < 2) {
    result.curvature_squared = FT(0);
    return result;
  }
  const Coordinates second = b[2] - b[1];
  const Scaled_vector<FT, N> r(second, place);
  const FT pxr = gram_determinant(std::vector<Coordinates>{*p, *r}); // |p x r|^2
  const FT c = FT(m - 1) / FT(m);
  result.curvature_squared =
      times_power_of_two(FT(c * c * pxr / (pp * pp * pp)), 2 * r.exponent() - 4 * p.exponent(), place);
  if (first.dimension() != 3 || pxr == FT(0)) return result;
  if (m < 3) {
    result.torsion = FT(0);
    return result;
  }
  const Coordinates third = b[2] - b[3];
  const Scaled_vector<FT, N> s(third, place);
  const Coordinates* differences[] = {&*p, &*r, &*s};
  const FT det = determinant<FT>(3, [&](int row, int column) -> const FT& { return (*differences[row])[column]; });
  result.torsion =
      times_power_of_two(FT(FT(m - 2) / FT(m) * det / pxr), s.exponent() - p.exponent() - r.exponent(), place);
  return result;
}

// index(0), index(1), ... are the numbers of the control points from the end inwards.
template <class Traits, int Degree, class Index>
End_invariants<typename Traits::FT> invariants_at(const Bezier_curve<Traits, Degree>& curve, const Index& index) {
  const int m = curve.degree();
  std::vector<Coordinates<Traits>> b;
  for (int j = 0; j <= (std::min)(m, 3); ++j) b.push_back(curve.coordinates(index(j)));
  return invariants_from_differences<typename Traits::FT, dimension_v<Traits>>(m, b);
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns \f$ \kappa^2 \f$ and \f$ \tau \f$ at the end of a Bézier curve of degree `m`, read off
/// the last three sides \f$ p = b_0 - b_{-1},\ r = b_{-2} - b_{-1},\ s = b_{-2} - b_{-3} \f$
/// without differentiation:
/// \f$ \kappa^2 = \left(\frac{m-1}{m}\right)^2 \frac{|p \times r|^2}{|p|^6} \f$,
/// \f$ \tau = \frac{m-2}{m} \frac{\det(p,r,s)}{|p \times r|^2} \f$. Hagen (1.11), (1.12) at the
/// ends of (3.1).
/// \throws Error `not_finite` when a floating-point result overflows
template <class Traits, int Degree>
End_invariants<typename Traits::FT> end_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::invariants_at(curve, [m = curve.degree()](int j) { return m - j; });
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns \f$ \kappa^2 \f$ and \f$ \tau \f$ at the start of a Bézier curve of degree `m`, read off
/// the first three sides as `end_invariants()` reads the last ones: in the opposite direction, a
/// curve has the same curvature and torsion.
/// \throws Error `not_finite` when a floating-point result overflows
template <class Traits, int Degree>
End_invariants<typename Traits::FT> start_invariants(const Bezier_curve<Traits, Degree>& curve) {
  return internal::invariants_at(curve, [](int j) { return j; });
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the curve whose control polygon has `times` more copies of the `i`-th control point: it
/// is pulled towards this point, whose weight at `t` grows from \f$ B_i^m(t) \f$ to
/// \f$ B_i^{m+1}(t) + B_{i+1}^{m+1}(t) \f$ when doubled. The degree rises by `times`. Lecture
/// slides, "Bézier curve tricks I".
/// \f$ O(m + times) \f$
/// \throws Error `wrong_number_of_points` unless `0 <= i <= m`, `negative_count` unless
///   `times >= 0`
template <class Traits, int Degree>
Bezier_curve<Traits> repeat_control_point(const Bezier_curve<Traits, Degree>& curve, int i, int times = 1) {
  internal::check_count(times, "repeat_control_point");
  if (i < 0 || i > curve.degree())
    throw Error(Error_code::wrong_number_of_points, "repeat_control_point: point " + std::to_string(i) +
                                                        " in a curve of degree " + std::to_string(curve.degree()));
  std::vector<typename Traits::Point> points(curve.begin(), curve.end());
  points.insert(points.begin() + i, times, curve.control_point(i));
  return Bezier_curve<Traits>(points.begin(), points.end(), curve.domain().first, curve.domain().second);
}

/// \ingroup PkgGeometricContinuityCurves
/// The ways in which a single Bézier curve closes up.
enum class Closing {
  open,   ///< the end points differ
  smooth, ///< the tangents at the closing point have one direction
  cusp,   ///< they are opposite
  corner, ///< they are not parallel
  /// the first or the last side of the polygon is zero, so that it does not give the tangent
  singular
};

/// \ingroup PkgGeometricContinuityCurves
/// Returns the name of a way to close, as spelled in the enumeration.
inline std::string to_string(Closing closing) {
  // unreachable: every value has a case
  switch (closing) {
  case Closing::open: return "open";
  case Closing::smooth: return "smooth";
  case Closing::cusp: return "cusp";
  case Closing::corner: return "corner";
  case Closing::singular: return "singular";
  }
  // unreachable: every value has a case
  return "unknown";
}

/// \ingroup PkgGeometricContinuityCurves
/// Decides how a curve closes, exactly with exact kernels and with
/// `Exact_predicates_inexact_constructions_kernel`: smooth if and only if \f$ b_1 - b_0 \f$ and
/// \f$ b_m - b_{m-1} \f$ are nonzero \em positive multiples. Lecture slides, "Bézier curve tricks
/// II", corrected: collinear is not enough. \f$ O(1) \f$
template <class Traits, int Degree> Closing closing(const Bezier_curve<Traits, Degree>& curve) {
  typedef Predicate_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Traits>> Coordinates;
  const int m = curve.degree();
  const auto point = [&](int i) { return Geometric_continuity::coordinates<Traits, Field>(curve.control_point(i)); };
  if (point(0) != point(m)) return Closing::open;
  if (m == 0) return Closing::singular;
  const Coordinates first = point(1) - point(0), last = point(m) - point(m - 1);
  if (is_zero(first) || is_zero(last)) return Closing::singular;
  const Field a = dot(first, last);
  if (dot(first, first) * last != a * first) return Closing::corner;
  return Field(0) < a ? Closing::smooth : Closing::cusp;
}

namespace internal {

// The control points that a curve depends on, from the first to the one behind the last: of a
// spline those of the basis functions that do not vanish on the whole domain.
template <class Curve> std::pair<int, int> points_in_use(const Curve& curve) {
  return {0, static_cast<int>(curve.control_points().size())};
}
template <class FT> std::pair<int, int> coefficients_in_use(const Knot_vector<FT>& u) {
  const std::pair<FT, FT> domain = u.domain();
  std::pair<int, int> used(0, u.number_of_coefficients());
  while (!(domain.first < u[used.first + u.degree() + 1])) ++used.first;
  while (!(u[used.second - 1] < domain.second)) --used.second;
  return used;
}
template <class Traits> std::pair<int, int> points_in_use(const Bspline_curve<Traits>& curve) {
  return coefficients_in_use(curve.knots());
}
template <class Traits> std::pair<int, int> points_in_use(const Rational_curve<Bspline_curve<Traits>>& curve) {
  return coefficients_in_use(curve.knots());
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Decides whether a curve lies in a plane, in any dimension: the homogeneous control points
/// \f$ (w_i b_i, w_i) \f$ that it depends on span three dimensions at most. Exact with every kernel
/// for the coordinates and weights as given. A line and a point are planar. \f$ O(n) \f$ for `n`
/// control points. Hagen 1.13.
/// \tparam Curve a Bézier, segmented or B-spline curve, or a rational one
template <class Curve> bool is_planar(const Curve& curve) {
  typedef typename Curve::Traits Traits;
  typedef internal::Decision_FT<Traits> Field;
  typedef Coordinate_vector<Field, dimension_v<Homogeneous_traits<Traits>>> Row;
  std::vector<Row> span; // orthogonal
  const std::pair<int, int> used = internal::points_in_use(curve);
  for (int i = used.first; i < used.second; ++i) {
    Field weight(1);
    if constexpr (internal::Is_rational<Curve>::value) weight = internal::to_field<Field>(curve.weight(i));
    const Row row = orthogonal_component(homogeneous_point(Geometric_continuity::coordinates<Traits, Field>(
                                                               curve.control_points()[static_cast<std::size_t>(i)]),
                                                           weight),
                                         span);
    if (is_zero(row)) continue;
    span.push_back(row);
    if (span.size() > 3) return false;
  }
  return true;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_BEZIER_PROPERTIES_H
