// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>
#include <CGAL/Geometric_continuity/cad/internal/Cad_surface_jet.h>
#include <CGAL/Geometric_continuity/cad/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/cad/internal/Foot_finder.h>
#include <CGAL/Geometric_continuity/cad/internal/Surface_pole.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_analytic_edge.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_plane_edge.h>
#include <CGAL/Geometric_continuity/cad/internal/exact_spline_edge.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// \file cad_edge_continuity.h
/// The edges of CAD models: two faces along curves in their parameter planes. The exact order is
/// decided, and the distance of the faces from it is enclosed, on whole edges. The joins of edges
/// that no face has, those of wires, are enclosed, too.
///
/// Where a file gives an edge in space only, its curve in the parameter plane of a face is that of
/// its foot points: the points of the surface that are next to it. One that a system has computed
/// is close to it at best.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides the continuity of two faces along an edge that both have over the range `[first, last]`
/// of their common parameter, exactly, on the whole closed edge, where that is possible: points of
/// both sides at equal parameters are compared, and the oriented normals there. The numbers that
/// describe curves and surfaces are taken as the rational numbers they are, the formulas of
/// `Cad_geometry.h` as they stand: a seam that a system has at `0` and at the floating-point number
/// next to \f$ 2 \pi \f$ has a gap. Gaps and kinks of the size of rounding errors are reported as
/// such; `edge_enclosure()` tells how large they are.
/// The following pairs are decided:
/// - two spline surfaces, rational or not, on each of which the edge is a parameter line, boundary
///   or not, or a part of it, run through linearly: as for whole edges;
/// - a plane, or a spline surface that is a parallelogram, in which the edge is a spline, and a
///   polynomial spline surface on which it is a parameter line, where they are \f$ G^2 \f$;
/// - two elementary surfaces, extrusions or surfaces of revolution with lines or ellipses as
///   profiles, where the curves in the parameter planes are lines, or splines that are, on planes
///   also ellipses. Then points and derivatives are sums of terms \f$ c\,t^n e^{i (w + f t)} \f$
///   with rational numbers, and continuity means identities between such sums, which hold if and
///   only if each coefficient agrees (Lindemann and Weierstrass).
///
/// The defect is `fold` where the oriented normals are opposite on the whole edge, `gap` (with the
/// order -1) when any two points differ. `deviation` may be empty where the normals differ. All
/// parameters in the result are those of the edge.
///
/// Returns nothing for an edge of another kind or without a length in the parameter; inside a
/// spline surface, on a knot line, when `Edge_side::face_side` is not known; for analytic surfaces
/// also where a normal vanishes on the edge, and for rational ones when a common factor that is not
/// constant may hide that the edges are the same; and when the work on splines would exceed the
/// limit. Sums of the analytic surfaces have some hundred terms at most.
/// \throws Error `not_finite`; `empty_domain` when `first` is larger than `last`;
///   `wrong_number_of_points`, `knot_multiplicity` and `empty_domain` for splines whose numbers do
///   not fit; `zero_weight`; `singular_frame` when a placement is not invertible
inline std::optional<Edge_continuity<Exact_field<double>::type>> edge_continuity(const Edge_side& a, const Edge_side& b,
                                                                                 double first, double last) {
  internal::check_range(first, last, "edge_continuity: the range");
  for (const Edge_side* side : {&a, &b}) {
    std::visit(internal::Check_cad_surface(), *side->surface);
    std::visit(internal::Check_cad_curve<2>(), *side->curve);
    for (const auto& row : side->placement)
      for (double x : row) internal::check_finite({x}, "a placement");
  }
  try {
    if (const auto verdict = internal::exact_spline_edge(a, b, first, last)) return verdict;
    if (const auto verdict = internal::exact_plane_edge(a, b, first, last)) return verdict;
    if (const auto verdict = internal::exact_plane_edge(b, a, first, last)) return verdict;
    return internal::exact_analytic_edge(a, b, first, last);
  } catch (const Error& e) {
    if (e.code() != Error_code::work_limit) throw;
    return std::nullopt;
  }
}

/// \ingroup PkgGeometricContinuityCadEdges
/// The largest value of a function along an edge, and where its lower bound is attained.
struct Edge_maximum {
  Enclosure value;    ///< an enclosure of the largest value
  double parameter;   ///< where the function is at least `value.lower`
  Cad_point<3> point; ///< the point of the first side there, rounded
  /// In the middle of the part of the edge that has the largest upper bound.
  double upper_at = parameter;
};

/// \ingroup PkgGeometricContinuityCadEdges
/// The distance of two faces from being continuous along an edge, as guaranteed enclosures of the
/// maxima on the *whole* edge, where the points of both sides at equal parameters are compared.
struct Edge_enclosure {
  /// the largest distance of the points of both sides, in units of the coordinates
  Edge_maximum gap;
  /// The largest angle between the oriented normals, in radians, in \f$ [0, \pi] \f$. Empty when a
  /// normal vanishes on the whole edge.
  std::optional<Edge_maximum> angle;
  /// The largest relative jump
  /// \f$ |\kappa_1 - \kappa_2| / \max(|\kappa_1|, |\kappa_2|, \varepsilon) \f$, in [0, 2], of the
  /// normal curvatures across the edge; \f$ \varepsilon \f$ is `Edge_precision::flat_curvature`.
  /// Empty when not asked for, or undefined on the whole edge.
  std::optional<Edge_maximum> curvature_jump;
  /// Ranges of parameters in which a normal is proved to vanish: apices, poles, collapsed edges;
  /// and, less than the \f$ 2^{-35} \f$-th part of the edge each, those in which the edge crosses a
  /// knot line where a surface itself has a fold. The angle leaves them out. They are not longer
  /// than the \f$ 2^{-18} \f$-th part of the edge.
  std::vector<std::pair<double, double>> singular;
  /// Ranges of parameters of which the angle says nothing: those where a normal is proved neither
  /// to be zero nor not to be, and those for which the work did not suffice.
  std::vector<std::pair<double, double>> unresolved;
  /// Ranges of parameters that the curvature jump leaves out: such as before, those where the
  /// direction of the edge vanishes, and, less than the \f$ 2^{-35} \f$-th part of the edge each,
  /// those in which the edge crosses a knot line where the curvature of a surface itself jumps.
  /// (What it jumps to is compared on both sides of it.)
  std::vector<std::pair<double, double>> curvature_undefined;
  /// Ranges of parameters of which the curvature jump says nothing.
  std::vector<std::pair<double, double>> curvature_unresolved;
  bool exhausted = false; ///< whether the work did not suffice
  int boxes = 0;          ///< the number of ranges that have been evaluated
};

/// \ingroup PkgGeometricContinuityCadEdges
/// When an enclosure of a largest value is narrow enough: when its width is at most `relative`
/// times its upper end, or when its upper end is at most the minimum of its kind. Where the work
/// does not suffice it is wider, and still guaranteed.
struct Edge_precision {
  double relative = 0.01;
  double gap = 1e-9;            ///< minimum of gaps, in units of the coordinates
  double angle = 1e-8;          ///< minimum of angles, in radians
  double curvature_jump = 1e-4; ///< minimum of relative jumps
  double flat_curvature = 1e-6; ///< normal curvatures below it count as flat, in units of 1/length
  /// how many ranges are evaluated at most for each of the three numbers, plus 8 for each piece
  int boxes = 4000;
  int most_boxes = 1'000'000; ///< the largest number of ranges, whatever the number of pieces
  bool with_curvature = true; ///< whether the curvature jump is wanted
};

namespace internal {

// The angle of two unit vectors whose difference has the square e in [0, 4]: the square of the
// tangent of its half is e / (4 - e).
inline Enclosure angle_of_chord_square(double e) {
  const Interval exact = (std::min)((std::max)(e, 0.), 4.), rest = 4 - exact;
  const bool steep = exact.inf() > 2;
  const Interval square = steep ? rest / exact : exact / rest;
  const Angle_of_square::Function function = steep ? Angle_of_square::cotangent : Angle_of_square::tangent;
  const double x = Angle_of_square{function, false, steep ? square.sup() : square.inf()}.below(),
               y = Angle_of_square{function, false, steep ? square.inf() : square.sup()}.above();
  return {2 * x, (std::min)(2 * y, 3.1415926535897936)};
}

inline double square_root_of(double x) { return std::sqrt(x); }

// Encloses the largest value of a function along an edge as closely as `precision` asks for.
template <class Evaluate, class Is_undefined>
Maximum_enclosure maximum_enclosure(const std::vector<double>& ends, const Edge_precision& precision, double floor,
                                    double (*measure)(double), const Evaluate& evaluate,
                                    const Is_undefined& is_undefined) {
  return {ends, {precision.relative, floor, measure, precision.boxes, precision.most_boxes}, evaluate, is_undefined};
}

// Returns the maximum with its point: bounds.point(t) is the point of the edge at the parameter t.
template <class Bounds>
Edge_maximum edge_maximum(const Bounds& bounds, const Maximum_enclosure& l, const Enclosure& value) {
  return {value, l.parameter, bounds.point(l.parameter), l.upper_at};
}
// Returns the largest value of a function that is not negative, whose square is enclosed. Its upper
// end is infinite where the square is not bounded.
template <class Bounds> Edge_maximum largest_root(const Bounds& bounds, const Maximum_enclosure& square) {
  // unreachable: by rounding only, of squares next to the largest number
  const bool bounded = square.undefined.empty() && square.unresolved.empty() && std::isfinite(square.upper);
  return edge_maximum(bounds, square,
                      {square.defined ? root_below(square.lower) : 0,
                       bounded ? root_above(square.upper) : (std::numeric_limits<double>::infinity)()});
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses how far two faces are from being continuous along the edge that both have over the
/// range `[first, last]` of their common parameter. The numbers that describe curves and surfaces
/// are taken exactly.
///
/// On parts of the range both sides become Taylor models: polynomials of degree 7 with a bound of
/// what they leave out, roundings included (K. Makino, M. Berz: Taylor models and other validated
/// functional inclusion methods, 2003). In their difference what agrees cancels, so that its bounds
/// are as narrow as the difference is small. The part with the largest upper bound is halved until
/// that and the largest value found at a parameter are close. Points where a normal is proved to
/// vanish are left out, except for the poles of spheres and the apices of cones on the edge: there
/// the normal is the limit along the edge. Splines are continued beyond their domain by their first
/// and last pieces, which rounded curves need.
///
/// The cost is linear in the number of parts, each of which takes some ten microseconds. Smooth
/// edges take a few, others some hundred.
/// \throws Error `empty_domain` when `first > last`; `not_finite`; `wrong_number_of_points` and
///   `knot_multiplicity` for splines whose numbers do not fit; `zero_weight`;
///   `parameter_outside_domain` when a curve leaves the domain of a spline by more than rounding;
///   `singular_frame` when a placement is not invertible
inline Edge_enclosure edge_enclosure(const Edge_side& a, const Edge_side& b, double first, double last,
                                     const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "edge_enclosure: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(a, b, first, last,
                           precision.with_curvature ? Edge_quantity::curvature : Edge_quantity::angle);
  Edge_enclosure result{};
  const auto largest = [&](Edge_quantity quantity, double floor, double (*measure)(double)) {
    Maximum_enclosure l = maximum_enclosure(
        bounds.ends(), precision, floor, measure,
        [&](double lower, double upper) { return bounds(lower, upper, quantity, precision.flat_curvature); },
        [&](double lower, double upper) { return bounds.is_undefined(lower, upper, quantity); });
    result.boxes += l.evaluated;
    result.exhausted = result.exhausted || l.exhausted;
    return l;
  };

  result.gap = largest_root(bounds, largest(Edge_quantity::gap, precision.gap, square_root_of));
  const Maximum_enclosure angle = largest(Edge_quantity::angle, precision.angle,
                                          [](double x) { return 2 * std::asin((std::min)(1., std::sqrt(x) / 2)); });
  if (angle.defined)
    result.angle = edge_maximum(bounds, angle,
                                {angle_of_chord_square(angle.lower).lower, angle_of_chord_square(angle.upper).upper});
  if (precision.with_curvature) {
    const Maximum_enclosure jump =
        largest(Edge_quantity::curvature, precision.curvature_jump, [](double x) { return x; });
    if (jump.defined) result.curvature_jump = edge_maximum(bounds, jump, {jump.lower, (std::min)(jump.upper, 2.)});
    result.curvature_undefined = jump.undefined;
    result.curvature_unresolved = jump.unresolved;
  }
  result.singular = angle.undefined;
  result.unresolved = angle.unresolved;
  return result;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides whether the angle between the oriented normals of two faces is larger than `bound`, in
/// radians, on the *whole* edge, as it is along an edge that is meant to be sharp: proved, refuted
/// when it is not on some part, or undecided. Points where a normal is proved to vanish are left
/// out, as by `edge_enclosure()`; so many parts of the range are evaluated at most as for one of
/// its three numbers.
/// \throws Error as `edge_enclosure()`
inline Verdict is_sharp_edge(const Edge_side& a, const Edge_side& b, double first, double last, const Bound& bound,
                             const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "is_sharp_edge: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(a, b, first, last, Edge_quantity::angle);
  const std::vector<double>& ends = bounds.ends();
  Oldest_first<Range> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) parts.add({ends[i], ends[i + 1]});
  if (ends.size() == 1) parts.add({first, last});
  const double ranges =
      (std::min)(double(precision.most_boxes), precision.boxes + 8 * static_cast<double>(ends.size()));
  bool defined = false, settled = true, small = false;
  int undefined_halvings = 0;
  double evaluated = 0;
  const bool finished = subdivide(parts, [&](const Range& part) {
    if (evaluated++ >= ranges) return After_part::stop;
    const Bounds_on_range square = bounds(part.lower, part.upper, Edge_quantity::angle, 0);
    if (square.defined) {
      const Verdict is_small =
          at_most({angle_of_chord_square(square.least).lower, angle_of_chord_square(square.upper).upper}, bound);
      small = is_small == Verdict::proved;
      if (small) return After_part::stop;
      defined = true;
      if (is_small == Verdict::refuted) return After_part::drop;
    }
    if (!square.defined && (!part.is_divisible() || part.length() <= (last - first) * 0x1p-20) &&
        bounds.is_undefined(part.lower, part.upper, Edge_quantity::angle))
      return After_part::drop; // without a normal
    if (!part.is_divisible() || part.length() <= (last - first) * (square.defined ? 0x1p-32 : 0x1p-48)) {
      settled = settled && square.defined && square.knots; // on a fold of a surface itself
      return After_part::drop;
    }
    return !square.defined && ++undefined_halvings > ranges / 8 ? After_part::stop : After_part::divide;
  });
  if (small) return Verdict::refuted;
  return finished && defined && settled ? Verdict::proved : Verdict::undecided;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses the largest distance \f$ |S(c(t)) - C(t)| \f$ of a side of an edge and the edge as a
/// curve in space, at equal parameters over the range `[first, last]`, as `edge_enclosure()`
/// encloses gaps. The upper end is infinite where the work does not suffice.
/// \throws Error as `edge_enclosure()`
inline Edge_maximum curve_deviation(const Edge_side& side, const Edge_curve& curve, double first, double last,
                                    const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "curve_deviation: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Distance_bounds bounds(side, curve, first, last);
  return largest_root(bounds, maximum_enclosure(bounds.ends(), precision, precision.gap, square_root_of, bounds,
                                                [](double, double) { return false; }));
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the range of parameters around `t` that belongs to a pole of one of the faces: on all of
/// it both sides are proved to lie within the distance `bound` of one point, and a whole parameter
/// line of a surface does, too. Such points are the points of an arc on the axis about which it is
/// rotated, the poles of spheres, the apices of cones, and sides of spline surfaces that are
/// points. There is no normal there, or the computed normal depends on rounding.
///
/// The parameter line of a surface that is rotated is within a sixteenth of the distance; that of a
/// spline surface is a point up to rounding, because its normal may turn along a side that only
/// nearly is one. The range reaches as far as that is proved, up to a per cent or so, but not
/// farther than a quarter of `[first, last]` on each side of `t`. Returns nothing where there is no
/// pole.
/// \throws Error as `edge_enclosure()`
inline std::optional<std::pair<double, double>> range_at_pole(const Edge_side& a, const Edge_side& b, double first,
                                                              double last, double t, const Bound& bound) {
  using namespace internal;
  check_range(first, last, "range_at_pole: the range");
  check_range(first, t, "range_at_pole: the parameter");
  check_range(t, last, "range_at_pole: the parameter");
  Edge_precision precision;
  precision.gap = bound.lower() / 16;
  precision.boxes = 64;
  std::vector<Cad_point<3>> poles;
  {
    const Protect_FPU_rounding<true> rounding_upwards;
    for (const Edge_side* side : {&a, &b}) {
      const Side_evaluator placed(*side);
      const std::vector<Cad_point<3>> of_side = Surface_pole(placed).next_to(t, bound.lower() / 16);
      poles.insert(poles.end(), of_side.begin(), of_side.end());
    }
  }
  for (const Cad_point<3>& pole : poles) {
    const Edge_curve point{std::make_shared<const Cad_curve<3>>(Cad_line<3>{pole, {0, 0, 0}}),
                           {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}};
    const auto belongs = [&](double from, double to) {
      return at_most(curve_deviation(a, point, from, to, precision).value, bound) == Verdict::proved &&
             at_most(curve_deviation(b, point, from, to, precision).value, bound) == Verdict::proved;
    };
    if (!belongs(t, t)) continue;
    // The largest number from 0 to a quarter of the length that is proved.
    const auto reach = [&](double end, const auto& is_proved) {
      double outside = (std::min)(end, (last - first) / 4), inside = 0;
      if (is_proved(outside)) return outside;
      for (int halvings = 0; halvings < 50 && inside == 0; ++halvings)
        (is_proved(outside / 2) ? inside : outside) = outside / 2;
      for (int halvings = 0; halvings < 6 && inside > 0; ++halvings) {
        const double middle = inside / 2 + outside / 2;
        (is_proved(middle) ? inside : outside) = middle;
      }
      return inside;
    };
    const auto before = [&](double d) { return d < t - first ? t - d : first; };
    const auto behind = [&](double d) { return d < last - t ? t + d : last; };
    const double from = before(reach(t - first, [&](double d) { return belongs(before(d), t); })),
                 to = behind(reach(last - t, [&](double d) { return belongs(t, behind(d)); }));
    if (from < to) return std::pair(from, to);
  }
  return std::nullopt;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Returns the side with another curve in its parameter plane: a cubic spline, continuously
/// differentiable, through the foot points of the curve in space at the ends of `pieces` equal
/// parts of `[first, last]` and at the knots of that curve. They are computed in rounded numbers by
/// Newton's method, which starts at the curve of the side; `curve_deviation()` tells how good the
/// result is.
/// \throws Error as `edge_enclosure()`
inline Edge_side projected_side(const Edge_side& side, const Edge_curve& curve, double first, double last, int pieces) {
  using namespace internal;
  check_range(first, last, "projected_side: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Side_evaluator placed(side);
  const Placed_curve in_space(curve);
  const Foot_finder finder(placed, in_space);
  std::vector<double> t = inner_knots(*curve.curve);
  t.erase(std::remove_if(t.begin(), t.end(), [=](double x) { return !(first < x && x < last); }), t.end());
  for (int i = 0; i <= pieces; ++i) t.push_back(i == pieces ? last : first + i * ((last - first) / pieces));
  std::sort(t.begin(), t.end());
  const double shortest = (last - first) * 1e-6;
  std::vector<double> ends{first}; // without parts that are very short
  for (double x : t)
    if (x - ends.back() > shortest && last - x > shortest) ends.push_back(x);
  ends.push_back(last);
  Cad_spline_curve<2> result{3, {}, {}, {}};
  std::vector<Foot_finder::Foot> feet;
  const double step = (last - first) * 0x1p-8;
  for (double x : ends)
    feet.push_back(x == first  ? finder.near_end(first, step)
                   : x == last ? finder.near_end(last, -step)
                               : finder.near_curve(x));
  const auto point = [](const Foot_finder::Foot& f, double factor) {
    return Cad_point<2>{f.point[0] + factor * f.derivative[0], f.point[1] + factor * f.derivative[1]};
  };
  result.points.push_back(feet.front().point);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double third = (ends[i + 1] - ends[i]) / 3;
    result.points.push_back(point(feet[i], third));
    result.points.push_back(point(feet[i + 1], -third));
  }
  result.points.push_back(feet.back().point);
  for (std::size_t i = 0; i < ends.size(); ++i)
    result.knots.insert(result.knots.end(), i == 0 || i + 1 == ends.size() ? 4 : 2, ends[i]);
  Edge_side projected = side;
  projected.curve = std::make_shared<const Cad_curve<2>>(std::move(result));
  return projected;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Facts about one parameter of an edge that is a curve in space, whatever curves in parameter
/// planes have been computed: lower bounds.
struct Foot_comparison {
  /// of the point of the curve and its foot points on both sides, in units of the coordinates
  std::array<double, 2> distances;
  double gap;            ///< the distance of the foot points
  double angle;          ///< the angle of the oriented normals there, in radians
  double curvature_jump; ///< relative, see `Edge_enclosure::curvature_jump`
};

/// \ingroup PkgGeometricContinuityCadEdges
/// Compares two faces at the foot points of a curve in space at the parameter `t`: those for which
/// it is proved, by interval arithmetic and Krawczyk's test, that they exist and are the only ones
/// near the curves of the sides. A side for which `is_projected` is false is compared at the point
/// of its own curve. Returns nothing when it cannot be proved, e.g. where a surface is singular, or
/// on a knot line.
/// \throws Error as `edge_enclosure()`
inline std::optional<Foot_comparison> compare_at_feet(const Edge_side& a, const Edge_side& b,
                                                      const std::array<bool, 2>& is_projected, const Edge_curve& curve,
                                                      double t,
                                                      double flat_curvature = Edge_precision().flat_curvature) {
  using namespace internal;
  const Protect_FPU_rounding<true> rounding_upwards;
  const Placed_curve in_space(curve);
  const auto at = in_space.jet(t);
  std::array<std::optional<Foot_finder::Enclosed>, 2> feet;
  std::array<double, 2> distances{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Side_evaluator side(i == 0 ? a : b);
    const Foot_finder finder(side, in_space);
    feet[i] = finder.enclosed(t, is_projected[i]);
    if (!feet[i]) return std::nullopt;
    distances[i] = length_below(feet[i]->point, at[0]);
  }
  const Foot_finder::Enclosed &x = *feet[0], &y = *feet[1];
  Interval chord = 0;
  for (int k = 0; k < 3; ++k) chord += square(x.normal[k] - y.normal[k]);
  const double angle = angle_of_chord_square(chord.inf()).lower;
  const Interval difference = x.curvature - y.curvature;
  const double least = (std::max)({0., difference.inf(), -difference.sup()}),
               largest = (std::max)({magnitude(x.curvature), magnitude(y.curvature), flat_curvature});
  const double jump = least > 0 ? (Interval(least) / Interval(largest)).inf() : 0;
  return Foot_comparison{distances, length_below(x.point, y.point), angle, jump};
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses the largest curvature \f$ |c' \times c''| / |c'|^3 \f$ of an edge as a curve in space
/// over the range `[first, last]`, on both sides of each knot. The enclosure is narrow enough where
/// its width is at most `Edge_precision::relative` times its upper end, or its upper end at most
/// `Edge_precision::flat_curvature`. The upper end is infinite where a tangent cannot be told from
/// zero, as in a cusp, and where the work does not suffice.
/// \throws Error as `wire_enclosure()`, and `empty_domain` when `first > last`
inline Edge_maximum largest_curvature(const Edge_curve& curve, double first, double last,
                                      const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "largest_curvature: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Curvature_bounds bounds(curve, first, last);
  const Maximum_enclosure square = maximum_enclosure(bounds.ends(), precision, precision.flat_curvature, square_root_of,
                                                     bounds, [](double, double) { return false; });
  return largest_root(bounds, square);
}

/// \ingroup PkgGeometricContinuityCadEdges
/// How far the join of two edges of a wire is from being continuous: guaranteed enclosures.
struct Wire_enclosure {
  /// Gap, angle and jump of the curvature vector, without the torsion. The angle and the jump are
  /// empty where a tangent cannot be told from zero. A curvature below
  /// `Edge_precision::flat_curvature` counts as flat.
  Join_deviation deviation;
  /// The relative jumps \f$ |y - x| / \max(|x|, |y|) \f$ of the first and of the second
  /// derivative with respect to the parameters of the curves, in [0, 2]; 0 when both are zero. A
  /// second derivative also counts as at least \f$ \varepsilon |c'|^2 \f$, with
  /// \f$ \varepsilon \f$ for the curvature that is flat.
  std::array<Enclosure, 2> derivative_jumps;
  Cad_point<3> point; ///< where the first edge ends, rounded
};

namespace internal {

inline Enclosure root_of(const Interval& square) {
  return {root_below((std::max)(0., square.inf())), root_above((std::max)(0., square.sup()))};
}

inline Interval square_of_distance(const Interval_vector<3>& x, const Interval_vector<3>& y) {
  Interval sum = 0;
  for (int i = 0; i < 3; ++i) sum += square(x[i] - y[i]);
  return sum;
}

// The length of a vector.
inline Interval length(const Interval_vector<3>& x) { return CGAL::sqrt(square_of_distance(x, Interval_vector<3>())); }

// |y - x| / max(|x|, |y|, least).
inline Enclosure relative_jump(const Interval_vector<3>& x, const Interval_vector<3>& y, const Interval& least) {
  const Interval difference = CGAL::sqrt(square_of_distance(x, y)), a = length(x), b = length(y),
                 divisor((std::max)({a.inf(), b.inf(), least.inf()}), (std::max)({a.sup(), b.sup(), least.sup()}));
  if (difference.sup() == 0) return {0, 0};
  if (!(divisor.inf() > 0)) return {0, 2};
  const Interval jump = difference / divisor;
  return {(std::min)((std::max)(0., jump.inf()), 2.), (std::min)(jump.sup(), 2.)};
}

// The tangent and the curvature vector of a curve from its derivatives; nothing where the first one
// cannot be told from zero.
inline std::optional<std::array<Interval_vector<3>, 2>>
tangent_and_curvature(const std::array<Interval_vector<3>, 3>& jet) {
  const Interval speed = length(jet[1]);
  if (!(speed.inf() > 0)) return std::nullopt;
  std::array<Interval_vector<3>, 2> result;
  Interval along = 0;
  for (int i = 0; i < 3; ++i) {
    result[0][i] = jet[1][i] / speed;
    along += jet[2][i] * result[0][i];
  }
  for (int i = 0; i < 3; ++i) result[1][i] = (jet[2][i] - along * result[0][i]) / square(speed);
  return result;
}

// The point and two derivatives in the direction in which an edge runs, where it ends or starts.
inline std::array<Interval_vector<3>, 3> jet_at(const Edge_end& end, bool is_end) {
  auto jet = Placed_curve(end.curve).jet(end.parameter, is_end != end.reversed ? -1 : 1);
  if (end.reversed)
    for (Interval& x : jet[1]) x = -x;
  return jet;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses how far the join of two edges in space is from being continuous, where `left` ends and
/// `right` starts. The numbers that describe the curves are taken exactly; all is computed by
/// interval arithmetic. At a knot of a spline each edge is the piece on its side.
/// \throws Error `not_finite`, `wrong_number_of_points`, `knot_multiplicity`, `zero_weight`,
///   `singular_frame` for numbers that do not fit; `parameter_outside_domain` for an end outside of
///   the domain of a spline
inline Wire_enclosure wire_enclosure(const Edge_end& left, const Edge_end& right,
                                     double flat_curvature = Edge_precision().flat_curvature) {
  using namespace internal;
  for (const Edge_end* end : {&left, &right}) check_finite({end->parameter}, "the end of an edge");
  const Protect_FPU_rounding<true> rounding_upwards;
  const auto x = jet_at(left, true), y = jet_at(right, false);
  Wire_enclosure result{{root_of(square_of_distance(x[0], y[0])), {}, {}, {}}, {}, {}};
  const Interval flat(flat_curvature), a = length(x[1]), b = length(y[1]),
                                       speed((std::max)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
  result.derivative_jumps = {relative_jump(x[1], y[1], Interval(0)), relative_jump(x[2], y[2], flat * square(speed))};
  for (std::size_t i = 0; i < 3; ++i) result.point[i] = middle(x[0][i]);
  const auto of_left = tangent_and_curvature(x), of_right = tangent_and_curvature(y);
  if (!of_left || !of_right) return result;
  const Interval chord = square_of_distance((*of_left)[0], (*of_right)[0]);
  result.deviation.tangent_angle =
      Enclosure{angle_of_chord_square(chord.inf()).lower, angle_of_chord_square(chord.sup()).upper};
  result.deviation.curvature_jump = relative_jump((*of_left)[1], (*of_right)[1], flat);
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_CAD_EDGE_CONTINUITY_H
