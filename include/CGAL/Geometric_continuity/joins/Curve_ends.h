// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_CURVE_ENDS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_CURVE_ENDS_H

#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/local/internal/jet_of_differences.h>

#include <algorithm>
#include <type_traits>
#include <utility>

/// \file Curve_ends.h
/// Reads the ends of curves for all decisions about joins: as the control points next to the end,
/// where the curve has them as given numbers, and otherwise as jets. Control points are what the
/// fast exact decisions on `double` coordinates read.

namespace CGAL {
namespace Geometric_continuity {

template <class Traits, int Degree> class Bezier_curve;
template <class Traits, int Degree> class Composite_bezier_curve;
template <class Traits> class Bspline_curve;
template <class Shape> class Rational_curve;

/// \ingroup PkgGeometricContinuityContinuity
/// The two ends of a curve.
enum class Curve_end {
  start, ///< where the curve starts: the right curve of a join is read here
  end    ///< where the curve ends: the left curve of a join is read here
};

/// \ingroup PkgGeometricContinuityContinuity
/// Tells how the control points next to the ends of a `Curve` are found. This is the general case:
/// not at all, the curve is read by its jets. It is specialised for `Bezier_curve`,
/// `Composite_bezier_curve` and `Bspline_curve`. A Bézier curve of the user's own, with the members
/// `Traits`, `degree()`, `control_point(i)` and `domain()` of `Bezier_curve`, takes part by
/// \code{.cpp}
/// template <> struct CGAL::Geometric_continuity::Curve_ends<My_curve> : Bezier_ends<My_curve> {};
/// \endcode
/// \tparam Curve a curve
template <class Curve> struct Curve_ends {
  /// There are no control points to be read. Then the other members are not needed.
  static constexpr bool have_polygons = false;
};

/// \ingroup PkgGeometricContinuityContinuity
/// The `Curve_ends` of a curve that is one Bézier curve.
template <class Curve> struct Bezier_ends {
  /// There are control points.
  static constexpr bool have_polygons = true;
  /// Returns whether the control points next to this end are Bézier points: always.
  static std::true_type has_polygon(const Curve&, Curve_end) { return {}; }
  /// Returns the number of the control point at this end. The following ones lie inwards, as many
  /// as the degree.
  static int point_number(const Curve& c, Curve_end end) { return end == Curve_end::end ? c.degree() : 0; }
  /// Returns the domain of the Bézier curve at this end.
  static std::pair<typename Curve::Traits::FT, typename Curve::Traits::FT> domain(const Curve& c, Curve_end) {
    return c.domain();
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a `Bezier_curve`.
template <class Traits, int Degree>
struct Curve_ends<Bezier_curve<Traits, Degree>> : Bezier_ends<Bezier_curve<Traits, Degree>> {};

/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a `Composite_bezier_curve`: those of its first and of its last segment.
template <class Traits, int Degree> struct Curve_ends<Composite_bezier_curve<Traits, Degree>> {
  typedef Composite_bezier_curve<Traits, Degree> Curve; ///< the curve
  typedef typename Traits::FT FT;                       ///< its numbers
  /// There are control points.
  static constexpr bool have_polygons = true;
  /// Returns whether the control points next to this end are Bézier points: always.
  static std::true_type has_polygon(const Curve&, Curve_end) { return {}; }
  /// Returns the number of the control point at this end.
  static int point_number(const Curve& c, Curve_end end) {
    return end == Curve_end::end ? static_cast<int>(c.control_points().size()) - 1 : 0;
  }
  /// Returns the domain of the segment at this end.
  static std::pair<FT, FT> domain(const Curve& c, Curve_end end) {
    const int l = end == Curve_end::end ? c.number_of_segments() - 1 : 0;
    return {c.knots()[l], c.knots()[l + 1]};
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The `Curve_ends` of a B-spline curve: those of the polynomials on its first and last span that
/// is not empty. The control points next to the end are Bézier points if the knots outside of the
/// span are equal, and on its other side as many of them as four points need: at least three, or as
/// many as the degree. Otherwise the Bézier points are combinations of control points, and the end
/// is read by its jet.
template <class Curve> struct Bspline_ends {
  typedef typename Curve::FT FT; ///< the numbers of the curve
  /// There are control points.
  static constexpr bool have_polygons = true;
  /// Returns whether the control points next to this end are Bézier points. \f$ O(\log n + p) \f$
  static bool has_polygon(const Curve& c, Curve_end end) {
    const int p = c.degree(), k = span(c, end), few = (std::min)(p, 3);
    const int before = end == Curve_end::end ? few : p, after = end == Curve_end::end ? p : few;
    for (int i = 1; i < before; ++i)
      if (c.knots()[k - i] != c.knots()[k]) return false;
    for (int i = 1; i < after; ++i)
      // equivalent [+ -> -, 1]: asks for more than is needed: the jet decides then
      // equivalent [1 -> 2, 1]: asks for more than is needed: the jet decides then
      if (c.knots()[k + 1 + i] != c.knots()[k + 1]) return false;
    return true;
  }
  /// Returns the number of the control point at this end, if `has_polygon()`.
  static int point_number(const Curve& c, Curve_end end) {
    return end == Curve_end::end ? span(c, end) : span(c, end) - c.degree();
  }
  /// Returns the span at this end.
  static std::pair<FT, FT> domain(const Curve& c, Curve_end end) {
    const int k = span(c, end);
    return {c.knots()[k], c.knots()[k + 1]};
  }

private:
  static int span(const Curve& c, Curve_end end) {
    return end == Curve_end::end ? c.knots().left_span(c.domain().second) : c.knots().span(c.domain().first);
  }
};

/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a `Bspline_curve`.
template <class Traits> struct Curve_ends<Bspline_curve<Traits>> : Bspline_ends<Bspline_curve<Traits>> {};

namespace internal {

// Decides whether the weights of the four control points next to an end are positive.
template <class Curve> bool weights_are_positive(const Curve& c, Curve_end end) {
  const int first = Curve_ends<Curve>::point_number(c, end), last = (std::min)(c.degree(), 3);
  for (int j = 0; j <= last; ++j)
    if (!(typename Curve::FT(0) < c.weight(end == Curve_end::end ? first - j : first + j))) return false;
  return true;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// The ends of a rational curve: those of the polynomial curve with its control points if all
/// weights are equal. Otherwise control points and weights are read where these are positive, and
/// jets where not.
template <class Shape> struct Curve_ends<Rational_curve<Shape>> {
  typedef Rational_curve<Shape> Curve;   ///< the curve
  typedef typename Shape::Traits::FT FT; ///< its numbers
  /// There are control points.
  static constexpr bool have_polygons = true;
  /// Returns whether the control points next to this end are Bézier points of a polynomial curve.
  static bool has_polygon(const Curve& c, Curve_end end) {
    return c.is_polynomial() && Curve_ends<Shape>::has_polygon(c.unweighted(), end);
  }
  /// Returns the number of the control point at this end.
  static int point_number(const Curve& c, Curve_end end) {
    return Curve_ends<Shape>::point_number(c.unweighted(), end);
  }
  /// Returns the domain of the rational Bézier curve at this end.
  static std::pair<FT, FT> domain(const Curve& c, Curve_end end) {
    return Curve_ends<Shape>::domain(c.unweighted(), end);
  }
  /// There are weights.
  static constexpr bool have_weights = true;
  /// Returns whether the control points next to this end are Bézier points, four of them with
  /// positive weights.
  static bool has_weighted_polygon(const Curve& c, Curve_end end) {
    return Curve_ends<Shape>::has_polygon(c.unweighted(), end) && internal::weights_are_positive(c, end);
  }
};

namespace internal {

template <class Curve, class = void> struct Has_weights : std::false_type {};
template <class Curve> struct Has_weights<Curve, std::enable_if_t<Curve_ends<Curve>::have_weights>> : std::true_type {};

// The control points next to an end of a curve: point 0 is at the join. \pre the curve has them
// there
template <class Curve, Curve_end which> class Curve_end_view {
  typedef Curve_ends<Curve> Ends;
  const Curve& curve_;
  const int first_;

public:
  typedef typename Curve::Traits Traits;
  typedef typename Traits::FT FT;
  static constexpr bool has_weights = Has_weights<Curve>::value;

  explicit Curve_end_view(const Curve& curve) : curve_(curve), first_(Ends::point_number(curve, which)) {}

  int degree() const { return curve_.degree(); }
  int dimension() const { return Traits().compute_dimension_object()(curve_.control_point(first_)); }
  std::pair<FT, FT> domain() const { return Ends::domain(curve_, which); }
  FT coordinate(int j, int i) const {
    return FT(Traits().compute_coordinate_object()(curve_.control_point(number(j)), i));
  }
  FT weight(int j) const {
    if constexpr (has_weights)
      return curve_.weight(number(j));
    else
      return FT(1);
  }

private:
  int number(int j) const { return which == Curve_end::end ? first_ - j : first_ + j; }
};

// The ends that meet at a join.
template <class Curve> Curve_end_view<Curve, Curve_end::end> left_end(const Curve& curve) {
  return Curve_end_view<Curve, Curve_end::end>(curve);
}
template <class Curve> Curve_end_view<Curve, Curve_end::start> right_end(const Curve& curve) {
  return Curve_end_view<Curve, Curve_end::start>(curve);
}

// Tells whether there are control points at the ends of all curves of this type: has_polygon() says
// so by its type.
template <class Curve, class = void> struct Always_has_polygons : std::false_type {};
template <class Curve>
struct Always_has_polygons<Curve, std::enable_if_t<decltype(Curve_ends<Curve>::has_polygon(
                                      std::declval<const Curve&>(), Curve_end::end))::value>> : std::true_type {};

template <class Curve> bool has_polygon(const Curve& curve, Curve_end end) {
  if constexpr (Curve_ends<Curve>::have_polygons)
    return Curve_ends<Curve>::has_polygon(curve, end);
  else
    return false;
}

// Returns whether there are control points with positive weights, all of them 1 where the curve is
// polynomial.
template <class Curve> bool has_weighted_polygon(const Curve& curve, Curve_end end) {
  if constexpr (Has_weights<Curve>::value)
    return Curve_ends<Curve>::has_weighted_polygon(curve, end);
  else
    return has_polygon(curve, end);
}

template <class Curve, class = void> struct Has_jets : std::false_type {};
template <class Curve>
struct Has_jets<
    Curve, std::void_t<decltype(std::declval<const Curve&>().jet(std::declval<const Curve&>().domain().second, 0))>>
    : std::true_type {};

// The jet of order k at an end that is given by control points: m!/(m-j)! / h^j times the j-th
// differences, backwards at an end. The points up to min(k, m) are read.
template <class Field, Curve_end which, class View>
Coordinate_jet<Field, dimension_v<typename View::Traits>> jet_of_polygon(const View& view, int k) {
  const Field h = to_field<Field>(view.domain().second) - to_field<Field>(view.domain().first);
  return jet_of_differences<Field, dimension_v<typename View::Traits>, -1>(
      view.dimension(), view.degree(), k, which == Curve_end::end ? Field(-h) : h,
      [&](int j, int i) { return to_field<Field>(view.coordinate(j, i)); });
}

// The jet at an end of a curve, see end_jet(); of a curve without jets from its control points.
template <class Field, Curve_end which, class Curve>
Coordinate_jet<Field, dimension_v<typename Curve::Traits>> jet_at(const Curve& curve, int k) {
  constexpr bool readable = Has_end_jets_over<Field, Curve>::value || Has_jets<Curve>::value;
  if constexpr (Curve_ends<Curve>::have_polygons && !Has_end_jets_over<Field, Curve>::value)
    return jet_of_polygon<Field, which>(Curve_end_view<Curve, which>(curve), k);
  else {
    static_assert(readable, "the ends of this curve cannot be read: it is no model of ParametricCurve (domain(), "
                            "jet(u, k)), and Curve_ends is not specialised for it; of two surfaces, is_g2_edge(a, b) "
                            "tells");
    if constexpr (readable && which == Curve_end::end)
      return end_jet<Field>(curve, k);
    else if constexpr (readable)
      return start_jet<Field>(curve, k);
  }
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_CURVE_ENDS_H
