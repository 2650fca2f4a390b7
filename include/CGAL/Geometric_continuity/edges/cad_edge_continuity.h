// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Spline_edge_continuity.h>
#include <CGAL/Geometric_continuity/edges/internal/Cad_surface_jet.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_bounds.h>
#include <CGAL/Geometric_continuity/edges/internal/exact_analytic_edge.h>
#include <CGAL/Geometric_continuity/edges/internal/exact_spline_edge.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

/// \file cad_edge_continuity.h
/// The edges of CAD models: two faces along curves in their parameter planes. What holds exactly is decided, and how far the faces are
/// from it is enclosed, on whole edges.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides the continuity of two faces along an edge that both have over the range `[first, last]` of their common parameter, exactly, on
/// the whole closed edge, where that is possible: points of both sides at equal parameters are compared, and the oriented normals there. The
/// numbers that describe curves and surfaces are taken as the rational numbers they are, the formulas of `Cad_geometry.h` as they
/// stand: a seam that a system has at `0` and at the floating-point number next to \f$ 2 \pi \f$ has a gap. Gaps and kinks of the size of
/// rounding errors are told as what they are; how large they are `edge_enclosure()` says.
///
/// Decided are
/// - two spline surfaces, rational or not, on each of which the edge is a parameter line, boundary or not, or a part of it, run through
///   linearly: as for whole edges;
/// - two elementary surfaces, extrusions or surfaces of revolution with lines or ellipses as profiles, where the curves in the parameter
///   planes are lines, or splines that are, on planes also ellipses. Then points and derivatives are sums of terms \f$ c\,t^n e^{i (w + f t)} \f$ with rational
///   numbers, and continuity means identities between such sums, which hold if and only if each coefficient agrees (Lindemann and
///   Weierstrass).
///
/// The defect is `fold` where the oriented normals are opposite on the whole edge, `gap` (with the order -1) when any two points differ.
/// `deviation` may be empty where the normals differ. All parameters in the result are those of the edge.
///
/// Returns nothing for an edge of another kind or without a length in the parameter; inside a spline surface, on a knot line, when
/// `Edge_side::face_side` is not known; for analytic surfaces also where a normal vanishes on the edge, and for rational ones when a common
/// factor that is not constant may hide that the edges are the same; and when the work on splines would exceed the limit. Sums of the
/// analytic surfaces have some hundred terms at most and take up to half a second, on ordinary models milliseconds.
/// \throws Error `not_finite`; `empty_domain` when `first` is larger than `last`; `wrong_number_of_points`, `knot_multiplicity` and
///   `empty_domain` for splines whose numbers do not fit; `zero_weight`; `singular_frame` when a placement is not invertible
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
    return internal::exact_analytic_edge(a, b, first, last);
  } catch (const Error& e) {
    if (e.code() != Error_code::work_limit) throw;
    return std::nullopt;
  }
}

/// \ingroup PkgGeometricContinuityCadEdges
/// The largest value of a function along an edge, and where its lower bound is attained.
struct Edge_maximum {
  Enclosure value;    ///< of the largest value
  double parameter;   ///< where the function is at least `value.lower`
  Cad_point<3> point; ///< the point of the first side there, rounded
};

/// \ingroup PkgGeometricContinuityCadEdges
/// How far two faces are from being continuous along an edge: guaranteed enclosures of what is largest on the *whole* edge, where the
/// points of both sides at equal parameters are compared.
struct Edge_enclosure {
  Edge_maximum gap; ///< the largest distance of the points of both sides, in units of the coordinates
  /// The largest angle between the oriented normals, in radians, in \f$ [0, \pi] \f$. Empty when a normal vanishes on the whole edge.
  std::optional<Edge_maximum> angle;
  /// The largest relative jump \f$ |\kappa_1 - \kappa_2| / \max(|\kappa_1|, |\kappa_2|, \varepsilon) \f$, in [0, 2], of the normal curvatures
  /// across the edge; \f$ \varepsilon \f$ is `Edge_precision::flat_curvature`. Empty when not asked for, or undefined on the whole edge.
  std::optional<Edge_maximum> curvature_jump;
  /// Ranges of parameters in which a normal is proved to vanish: apices, poles, collapsed edges; and, less than the
  /// \f$ 2^{-35} \f$-th part of the edge each, those in which the edge crosses a knot line where a surface itself has a fold. The angle
  /// leaves them out. They are not longer than the \f$ 2^{-18} \f$-th part of the edge.
  std::vector<std::pair<double, double>> singular;
  /// Ranges of parameters of which the angle says nothing: those where a normal can be told neither from zero nor to be zero, and those for
  /// which the work did not suffice.
  std::vector<std::pair<double, double>> unresolved;
  /// Ranges of parameters that the curvature jump leaves out: such as before, those where the direction of the edge vanishes, and, less
  /// than the \f$ 2^{-35} \f$-th part of the edge each, those in which the edge crosses a knot line where the curvature of a surface itself
  /// jumps. (What it jumps to is compared on both sides of it.)
  std::vector<std::pair<double, double>> curvature_undefined;
  /// Ranges of parameters of which the curvature jump says nothing.
  std::vector<std::pair<double, double>> curvature_unresolved;
  bool exhausted = false; ///< whether the work did not suffice
  int boxes = 0;          ///< the number of ranges that have been evaluated
};

/// \ingroup PkgGeometricContinuityCadEdges
/// When an enclosure of a largest value is narrow enough: when its width is at most `relative` times its upper end, or when its upper end
/// is at most the floor of its kind. Where the work does not suffice it is wider, and still guaranteed.
struct Edge_precision {
  double relative = 0.01;
  double gap = 1e-9;            ///< floor of gaps, in units of the coordinates
  double angle = 1e-8;          ///< floor of angles, in radians
  double curvature_jump = 1e-4; ///< floor of relative jumps
  double flat_curvature = 1e-6; ///< normal curvatures below it count as flat, in units of 1/length
  int boxes = 4000;             ///< so many ranges are evaluated at most for each of the three, and 8 for each piece
  int most_boxes = 1'000'000;   ///< but not more than these, whatever the number of pieces
  bool with_curvature = true;   ///< whether the curvature jump is wanted
};

namespace internal {

// The angle of two unit vectors whose difference has the square e in [0, 4]: the square of the tangent of its half is e / (4 - e).
inline Enclosure angle_of_chord_square(double e) {
  const Interval exact = (std::min)((std::max)(e, 0.), 4.), rest = 4 - exact;
  const bool steep = exact.inf() > 2;
  const Interval square = steep ? rest / exact : exact / rest;
  const Angle_of_square::Function function = steep ? Angle_of_square::cotangent : Angle_of_square::tangent;
  const double x = Angle_of_square{function, false, steep ? square.sup() : square.inf()}.below(),
               y = Angle_of_square{function, false, steep ? square.inf() : square.sup()}.above();
  return {2 * x, (std::min)(2 * y, 3.1415926535897936)};
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCadEdges
/// Encloses how far two faces are from being continuous along the edge that both have over the range `[first, last]` of their common
/// parameter. The numbers that describe curves and surfaces are taken exactly.
///
/// On parts of the range both sides become Taylor models: polynomials of degree 7 with a bound of what they leave out, roundings included
/// (K. Makino, M. Berz: Taylor models and other validated functional inclusion methods, 2003). In their difference what agrees cancels, so
/// that its bounds are as narrow as the difference is small. The part with the largest upper bound is halved until that and the
/// largest value found at a parameter are close. Points where a normal is proved to vanish are left out, except for the poles of
/// spheres and the apices of cones on the edge: there the normal is the limit along the edge. Splines are continued beyond their domain by
/// their first and last pieces, which rounded curves need.
///
/// The cost is linear in the number of parts, each of which takes some ten microseconds. Smooth edges take a few, others some hundred.
/// \throws Error `empty_domain` when `first > last`; `not_finite`; `wrong_number_of_points` and `knot_multiplicity` for splines whose
///   numbers do not fit; `zero_weight`; `parameter_outside_domain` when a curve leaves the domain of a spline by more than rounding;
///   `singular_frame` when a placement is not invertible
inline Edge_enclosure edge_enclosure(const Edge_side& a, const Edge_side& b, double first, double last,
                                     const Edge_precision& precision = Edge_precision()) {
  using namespace internal;
  check_range(first, last, "edge_enclosure: the range");
  const Protect_FPU_rounding<true> rounding_upwards;
  const Edge_bounds bounds(a, b, first, last,
                           precision.with_curvature ? Edge_quantity::curvature : Edge_quantity::angle);
  const std::vector<double>& ends = bounds.ends();
  Edge_enclosure result{};
  const auto largest = [&](Edge_quantity quantity, double floor, double (*measure)(double)) {
    Largest_on_ranges l(
        ends, {precision.relative, floor, measure, precision.boxes, precision.most_boxes},
        [&](double lower, double upper) { return bounds(lower, upper, quantity, precision.flat_curvature); },
        [&](double lower, double upper) { return bounds.is_undefined(lower, upper, quantity); });
    result.boxes += l.evaluated;
    result.exhausted = result.exhausted || l.exhausted;
    return l;
  };
  const auto maximum = [&](const Largest_on_ranges& l, const Enclosure& value) {
    return Edge_maximum{value, l.parameter, bounds.point(l.parameter)};
  };

  const Largest_on_ranges gap = largest(Edge_quantity::gap, precision.gap, [](double x) { return std::sqrt(x); });
  const bool bounded = gap.undefined.empty() && gap.unresolved.empty() && std::isfinite(gap.upper);
  result.gap = maximum(gap, {gap.defined ? root_below(gap.lower) : 0,
                             bounded ? root_above(gap.upper) : (std::numeric_limits<double>::infinity)()});
  const Largest_on_ranges angle = largest(Edge_quantity::angle, precision.angle,
                                          [](double x) { return 2 * std::asin((std::min)(1., std::sqrt(x) / 2)); });
  if (angle.defined)
    result.angle = maximum(angle, {angle_of_chord_square(angle.lower).lower, angle_of_chord_square(angle.upper).upper});
  if (precision.with_curvature) {
    const Largest_on_ranges jump =
        largest(Edge_quantity::curvature, precision.curvature_jump, [](double x) { return x; });
    if (jump.defined) result.curvature_jump = maximum(jump, {jump.lower, (std::min)(jump.upper, 2.)});
    result.curvature_undefined = jump.undefined;
    result.curvature_unresolved = jump.unresolved;
  }
  result.singular = angle.undefined;
  result.unresolved = angle.unresolved;
  return result;
}

/// \ingroup PkgGeometricContinuityCadEdges
/// Decides whether the angle between the oriented normals of two faces is larger than `bound`, in radians, on the *whole* edge, as it is
/// along an edge that is meant to be sharp: proved, refuted when it is not on some part, or undecided. Points where a normal is proved to
/// vanish are left out, as by `edge_enclosure()`; so many parts of the range are evaluated at most as for one of its
/// three numbers.
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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_CAD_EDGE_CONTINUITY_H
