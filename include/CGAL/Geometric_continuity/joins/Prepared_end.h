// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H

#include <CGAL/Geometric_continuity/joins/internal/decide_join.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// The end of a curve, ready to be compared with many others: the four control points next to it, the degree and the domain.
/// With `double` coordinates in the plane or in space the legs of the polygon are kept as integers as well, which saves the
/// predicates of join_predicates.h the conversion.
///
/// The points run from the end inwards. A start is an end in this sense, too: in a predicate the left curve runs towards the
/// join and the right one away from it.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Prepared_end {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

private:
  static constexpr int N = dimension_v<Traits>;
  static constexpr bool on_grid = internal::is_double<FT> && (N == 2 || N == 3);
  // doubles with their legs on a grid, other numbers as they are
  typedef std::conditional_t<on_grid, internal::Prepared_double_end<Traits, on_grid ? N : 2>,
                             internal::Stored_end<Traits>>
      End;

  End end_;

public:
  /// From the control points of a curve of degree `degree`, those next to the end first, and its domain [a, b]. At most four
  /// points are read.
  /// \throws Error `wrong_number_of_points` when there are fewer than four points and fewer than `degree + 1`, or `degree < 0`
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class InputIterator>
  Prepared_end(int degree, InputIterator first, InputIterator last, const FT& a = FT(0), const FT& b = FT(1))
      : end_(checked(degree, first, last, a, b)) {}

  /// The end of a curve. \tparam Curve see join_predicates.h
  template <class Curve> static Prepared_end at_end(const Curve& curve) { return of(curve, true); }

  /// The start of a curve.
  template <class Curve> static Prepared_end at_start(const Curve& curve) { return of(curve, false); }

  /// The degree of the curve.
  int degree() const { return end_.degree(); }
  /// The dimension of the points.
  int dimension() const { return end_.dimension(); }
  /// The domain of the curve.
  std::pair<FT, FT> domain() const { return end_.domain(); }
  /// The `i`-th coordinate of the `j`-th point from the end, for `j <= 3` and `j <= degree()`.
  FT coordinate(int j, int i) const { return end_.coordinate(j, i); }

  /// \cond
  template <internal::Join_question question, class Stages>
  static internal::Join_answer decide(const Prepared_end& left, const Prepared_end& right, Stages& stages) {
    if constexpr (on_grid && !internal::planar_by_definition<question, N>) {
      const internal::Join_answer answer = End::template decide<question>(left.end_, right.end_, stages);
      if (answer != internal::Join_answer::unknown) return answer;
    }
    return internal::decide_exactly<question>(left.end_, right.end_, stages);
  }
  /// \endcond

private:
  template <class Curve> static Prepared_end of(const Curve& curve, bool at_end) {
    const int m = curve.degree();
    std::vector<Point> points;
    for (int j = 0; j <= std::min(m, 3); ++j) points.push_back(curve.control_point(at_end ? m - j : j));
    return Prepared_end(m, points.begin(), points.end(), curve.domain().first, curve.domain().second);
  }

  template <class InputIterator>
  static internal::Stored_end<Traits> checked(int degree, InputIterator first, InputIterator last, const FT& a,
                                              const FT& b) {
    internal::Stored_end<Traits> end(degree, a, b);
    int points = 0;
    for (; first != last && points <= std::min(degree, 3); ++first, ++points)
      end.push_back(Geometric_continuity::coordinates<Traits>(*first));
    if (points <= std::min(degree, 3) || points == 0)
      throw Error(Error_code::wrong_number_of_points,
                  "Prepared_end: degree " + std::to_string(degree) + ", " + std::to_string(points) + " points");
    if (!(a < b)) throw Error(Error_code::empty_domain, "Prepared_end");
    internal::check_finite(a, "Prepared_end: domain");
    internal::check_finite(b, "Prepared_end: domain");
    for (const Geometric_continuity::Coordinates<Traits>& p : end.points()) {
      if (p.dimension() != end.dimension()) throw Error(Error_code::dimension_mismatch, "Prepared_end");
      for (const FT& x : p) internal::check_finite(x, "Prepared_end: control points");
    }
    return end;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H
