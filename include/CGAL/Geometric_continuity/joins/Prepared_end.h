// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/joins/internal/Join_ladder.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Prepared_end.h
/// Ends of curves that are compared with many others, by the predicates of join_predicates.h.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// An end with double coordinates and with what its decisions have in common: the legs on their grid.
template <class Traits_, int N> class Prepared_double_end {
  End_polygon<double, N> points_;
  int degree_;
  std::pair<double, double> domain_;
  Prepared_legs<N> legs_;

public:
  typedef Traits_ Traits;

  template <class Points>
  explicit Prepared_double_end(const Points& end)
      : points_(points_of<3, N>(end)), degree_(end.degree()), domain_(end.domain()), legs_(points_) {}

  int degree() const { return degree_; }
  int dimension() const { return N; }
  const std::pair<double, double>& domain() const { return domain_; }
  double coordinate(int j, int i) const { return points_[j][i]; }

  // On the grids, exact or `unknown`. \pre the ends meet, if the question asks for contact
  template <Join_question question, class Stages>
  static CGAL_GC_FORCEINLINE Join_answer decide(const Prepared_double_end& left, const Prepared_double_end& right,
                                                Stages& stages) {
    if (!left.legs_.grid.valid || !right.legs_.grid.valid || !stages.uses(Join_stage::fixed_integer))
      return Join_answer::unknown;
    return decide_by_rungs(Prepared_join<question, N>(left.legs_, left.degree_, right.legs_, right.degree_), stages);
  }
};

// The end of a curve with the coordinates of its points from the end inwards.
template <class Traits_> class Stored_end {
public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;

  Stored_end(int m, const FT& a, const FT& b) : degree_(m), domain_(a, b) {}
  void push_back(const Coordinates<Traits>& x) { points_.push_back(x); }

  const std::vector<Coordinates<Traits>>& points() const { return points_; }
  int degree() const { return degree_; }
  int dimension() const { return points_[0].dimension(); }
  const std::pair<FT, FT>& domain() const { return domain_; }
  const FT& coordinate(int j, int i) const { return points_[j][i]; }

private:
  int degree_;
  std::pair<FT, FT> domain_;
  std::vector<Coordinates<Traits>> points_;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The end of a curve, ready to be compared with many others: the four control points next to it, the degree and the domain.
/// With `double` coordinates in the plane or in space the sides of the polygon are kept as integers as well, which saves the
/// predicates the conversion.
///
/// The points run from the end inwards. A start is an end in this sense, too: in a predicate the left curve runs towards the
/// join and the right one away from it.
///
/// Where a B-spline curve, or a curve of the user's own, has no control points next to its end (see `Curve_ends`), the jet of
/// order 3 in an exact field is kept instead and decides; the points are then those of a curve with this jet.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Prepared_end {
public:
  typedef Traits_ Traits;               ///< the traits class
  typedef typename Traits::FT FT;       ///< the numbers of the points
  typedef typename Traits::Point Point; ///< the points

private:
  static constexpr int N = dimension_v<Traits>;
  static constexpr bool on_grid = internal::is_double<FT> && (N == 2 || N == 3);
  // doubles with their legs on a grid, other numbers as they are
  typedef std::conditional_t<on_grid, internal::Prepared_double_end<Traits, on_grid ? N : 2>,
                             internal::Stored_end<Traits>>
      End;

  typedef typename Exact_field<Predicate_FT<Traits>>::type Field;
  typedef Coordinate_jet<Field, N> Jet;

  End end_;
  std::shared_ptr<const Jet> jet_; // counts instead of the points, if given

public:
  /// Prepares an end from the control points of a curve of degree `degree`, those next to the end first, and its domain [a, b]. At most four
  /// points are read.
  /// \throws Error `wrong_number_of_points` when there are fewer than four points and fewer than `degree + 1`, or `degree < 0`
  /// \throws Error `dimension_mismatch` when the points differ in dimension
  /// \throws Error `empty_domain` unless `a < b`
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class InputIterator>
  Prepared_end(int degree, InputIterator first, InputIterator last, const FT& a = FT(0), const FT& b = FT(1))
      : end_(checked(degree, first, last, a, b)) {}

  /// Returns the end of a curve.
  /// \tparam Curve a model of `ParametricCurve`, or a type for which `Curve_ends` is specialised
  template <class Curve> static Prepared_end at_end(const Curve& curve) { return of<Curve_end::end>(curve); }

  /// Returns the start of a curve.
  /// \tparam Curve a model of `ParametricCurve`, or a type for which `Curve_ends` is specialised
  template <class Curve> static Prepared_end at_start(const Curve& curve) { return of<Curve_end::start>(curve); }

  /// Returns the degree of the curve, or 3 if its jet is kept.
  int degree() const { return end_.degree(); }
  /// Returns the dimension of the points.
  int dimension() const { return end_.dimension(); }
  /// Returns the domain of the curve, or [0, 1] if its jet is kept.
  std::pair<FT, FT> domain() const { return end_.domain(); }
  /// Returns the `i`-th coordinate of the `j`-th point from the end; rounded if the jet of a curve with `double` coordinates is
  /// kept.
  /// \throws Error `wrong_number_of_points` unless `0 <= j <= 3` and `j <= degree()`, `dimension_mismatch` unless
  ///   `0 <= i < dimension()`
  FT coordinate(int j, int i) const {
    if (j < 0 || (std::min)(degree(), 3) < j) throw Error(Error_code::wrong_number_of_points, "Prepared_end: point");
    if (i < 0 || dimension() <= i) throw Error(Error_code::dimension_mismatch, "Prepared_end: coordinate");
    return end_.coordinate(j, i);
  }

  /// \cond
  template <internal::Join_question question, class Stages>
  static internal::Join_answer decide(const Prepared_end& left, const Prepared_end& right, Stages& stages) {
    if (left.jet_ || right.jet_) {
      const internal::Join_answer answer = internal::decide_on_jets<question>(left.template jet<Curve_end::end>(),
                                                                              right.template jet<Curve_end::start>());
      stages.decided(internal::Join_stage::multiprecision, answer);
      return answer;
    }
    if constexpr (on_grid && !internal::is_parametric(question) && !internal::planar_by_definition<question, N>)
      if (!internal::asks_for_contact(question) || internal::ends_meet(left.end_, right.end_)) {
        const internal::Join_answer answer = End::template decide<question>(left.end_, right.end_, stages);
        if (answer != internal::Join_answer::unknown) return answer;
      }
    return internal::decide_polygons<question, false>(left.end_, right.end_, stages);
  }
  /// \endcond

private:
  Prepared_end(End end, std::shared_ptr<const Jet> jet) : end_(std::move(end)), jet_(std::move(jet)) {}

  template <Curve_end which> Jet jet() const { return jet_ ? *jet_ : internal::jet_of_polygon<Field, which>(end_, 3); }

  template <Curve_end which, class Curve> static Prepared_end of(const Curve& curve) {
    std::vector<Point> points;
    if constexpr (Curve_ends<Curve>::have_polygons)
      if (internal::has_polygon(curve, which)) {
        typedef Curve_ends<Curve> Ends;
        const int m = curve.degree(), first = Ends::point_number(curve, which);
        for (int j = 0; j <= (std::min)(m, 3); ++j)
          points.push_back(curve.control_point(which == Curve_end::end ? first - j : first + j));
        const std::pair<FT, FT> domain = Ends::domain(curve, which);
        return Prepared_end(m, points.begin(), points.end(), domain.first, domain.second);
      }
    constexpr bool at_end = which == Curve_end::end;
    const Jet jet = internal::jet_at<Field, which>(curve, 3);
    for (const Coordinate_vector<Field, N>& x : internal::points_from_jet(jet, 3, Field(at_end ? -1 : 1))) {
      Coordinates<Traits> c(x.dimension());
      for (int i = 0; i < x.dimension(); ++i)
        if constexpr (std::is_same_v<FT, Field>)
          c[i] = x[i];
        else
          c[i] = FT(CGAL::to_double(x[i]));
      points.push_back(to_point<Traits>(c));
    }
    return Prepared_end(End(checked(3, points.begin(), points.end(), FT(0), FT(1))), std::make_shared<const Jet>(jet));
  }

  template <class InputIterator>
  static internal::Stored_end<Traits> checked(int degree, InputIterator first, InputIterator last, const FT& a,
                                              const FT& b) {
    internal::Stored_end<Traits> end(degree, a, b);
    int points = 0;
    for (; first != last && points <= (std::min)(degree, 3); ++first, ++points)
      end.push_back(Geometric_continuity::coordinates<Traits>(*first));
    if (points <= (std::min)(degree, 3) || points == 0)
      throw Error(Error_code::wrong_number_of_points,
                  "Prepared_end: degree " + std::to_string(degree) + ", " + std::to_string(points) + " points");
    if (!(a < b)) throw Error(Error_code::empty_domain, "Prepared_end");
    internal::check_finite(a, "Prepared_end: domain");
    internal::check_finite(b, "Prepared_end: domain");
    for (const Coordinates<Traits>& p : end.points()) {
      if (p.dimension() != end.dimension()) throw Error(Error_code::dimension_mismatch, "Prepared_end");
      for (const FT& x : p) internal::check_finite(x, "Prepared_end: control points");
    }
    return end;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_PREPARED_END_H
