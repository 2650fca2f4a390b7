// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_ROUND_EDGE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_ROUND_EDGE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/cut_back.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file round_edge.h
/// Two surfaces that meet in an edge are trimmed back from it, and a blend is put in its place.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A rounded edge: three surfaces, one after the other.
/// \tparam Surface_a, Surface_b the types of the given surfaces
template <class Surface_a, class Surface_b> struct Rounded_edge {
  typedef typename Surface_a::FT FT; ///< the field

  Surface_a first; ///< the first surface without a strip along the edge
  Blend_surface<Surface_a, Surface_b>
      /// from the new edge of the first surface, `v = 0`, to that of the second one
      blend;
  Surface_b second; ///< the second surface without a strip along the edge
  /// how the edge of the second surface runs in comparison with that of the first
  Edge_direction direction;
  /// Where the blend may be folded; nothing is a proof that it is not, see `possible_fold()`.
  std::optional<Parameter_rectangle<FT>> fold;
};

namespace internal {

// Checks that an edge has normals: the surface and its mirror image S(u, -v), with the rows C, -T,
// W, continue each other wherever it has.
template <class Surface> void check_normals(const Surface& surface, Patch_edge edge, const std::string& place) {
  const auto rows = spline_edge_rows(surface, edge);
  auto mirrored = rows;
  for (auto& x : mirrored.rows.cross) x = -1 * x;
  const auto verdict = edge_continuity(rows, mirrored);
  if (verdict.g_order >= 1) return;
  std::string where = "everywhere";
  if (verdict.vanishing) where = "near the parameter " + std::to_string(CGAL::to_double(verdict.vanishing->first));
  throw Error(Error_code::singular_frame, place + ": the normal vanishes " + where);
}

// Along two edges that are the same as a whole and not smooth.
template <class Surface_a, class Surface_b>
Edge_direction direction_of_sharp_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  const auto edge = edge_continuity(a, edge_a, b, edge_b);
  const std::string place = "round_edge: the edge " + to_string(edge_a) + " of the first surface and the edge " +
                            to_string(edge_b) + " of the second one";
  if (edge.spans.empty()) throw Error(Error_code::curves_do_not_meet, place + " are different curves");
  if (!edge.whole_a || !edge.whole_b)
    throw Error(Error_code::curves_do_not_meet,
                place + " have only a part in common, from " + std::to_string(CGAL::to_double(edge.part_a.first)) +
                    " to " + std::to_string(CGAL::to_double(edge.part_a.second)) + " of the first one");
  if (edge.collapsed) throw Error(Error_code::zero_tangent, place + " are a single point");
  if (edge.g_order >= 2) throw Error(Error_code::already_smooth, place + " are G2 along each other");
  return edge.reversed ? Edge_direction::opposite : Edge_direction::same;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Rounds the edge in which two surfaces meet: both are trimmed back from it, see `cut_back()`, and
/// a blend leads from the one new edge to the other. With an exact kernel all three surfaces
/// together are exactly \f$ G^2 \f$ along the whole new edges.
///
/// Every kernel decides exactly that the surfaces have the edge in common and are not \f$ G^2 \f$
/// there. An edge with \f$ G^1 \f$ is rounded as well. The blend may be folded where it does not
/// have enough room; `Rounded_edge::fold` is empty where that is disproved.
/// \param set_back_a the width of the strip of the first surface, in its parameter
/// \param set_back_b the width of the strip of the second surface, in its parameter; for widths of
///   a given length see `set_back_parameter()`
/// \param strategy chooses the shape, see `automatic_surface_shape()`
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \tparam Strategy a model of `BlendStrategy`; by a septic one the blend has degree 7 and is
///   \f$ G^3 \f$
/// \throws Error `curves_do_not_meet` unless the whole edges are one curve, see
///   `edge_continuity()`; `already_smooth` when the surfaces are \f$ G^2 \f$ along it;
///   `zero_tangent` when it is a single point
/// \throws Error `parameter_outside_domain` unless the widths are positive and less than the
///   lengths of the domains
/// \throws Error `singular_frame` where a normal vanishes at a new edge
/// \throws Error `dimension_mismatch` unless in dimension 3; as `blend()` with a strategy;
///   `work_limit`
template <class Surface_a, class Surface_b, class Strategy = Minimal_energy<3>>
Rounded_edge<Surface_a, Surface_b> round_edge(const Surface_a& a, Patch_edge edge_a, const Surface_b& b,
                                              Patch_edge edge_b, const typename Surface_a::FT& set_back_a,
                                              const typename Surface_b::FT& set_back_b,
                                              const Strategy& strategy = Strategy()) {
  const Edge_direction direction = internal::direction_of_sharp_edge(a, edge_a, b, edge_b);
  Surface_a first = cut_back(a, edge_a, set_back_a);
  Surface_b second = cut_back(b, edge_b, set_back_b);
  internal::check_normals(first, edge_a, "round_edge: at the new edge " + to_string(edge_a) + " of the first surface");
  internal::check_normals(second, edge_b,
                          "round_edge: at the new edge " + to_string(edge_b) + " of the second surface");
  auto surface = blend(first, edge_a, second, edge_b, strategy, direction);
  auto fold = possible_fold(surface);
  return {std::move(first), std::move(surface), std::move(second), direction, std::move(fold)};
}

namespace internal {

// The exact width for set_back_parameter(), where the surface is linear across the edge and the
// mean square of the lengths across has a rational root.
template <class Surface>
std::optional<typename Surface::FT> set_back_of_ruled(const Surface& surface, Patch_edge edge,
                                                      const typename Surface::FT& distance) {
  typedef typename Surface::FT FT;
  if constexpr (Is_rational<Surface>::value || !has_rational_roots<FT>())
    return std::nullopt;
  else {
    if ((runs_along_u(edge) ? surface.degree_v() : surface.degree_u()) != 1) return std::nullopt;
    if constexpr (Surface_shape<Surface>::is_spline)
      if ((runs_along_u(edge) ? surface.number_of_points_v() : surface.number_of_points_u()) != 2) return std::nullopt;
    const auto knots = knots_of_edge(surface, edge);
    const typename Surface::Interval across = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
    FT squares(0);
    for (int k = 0; k < knots.number_of_coefficients(); ++k) {
      const FT u = knots.greville_abscissa(k);
      const auto point = [&](const FT& v) {
        return runs_along_u(edge) ? surface.jet(u, v, 0)(0, 0) : surface.jet(v, u, 0)(0, 0);
      };
      const auto ruling = point(across.second) - point(across.first);
      squares = FT(squares + dot(ruling, ruling));
    }
    const std::optional<FT> length = rational_square_root(FT(squares / FT(knots.number_of_coefficients())));
    if (!length) return std::nullopt;
    return FT(FT(distance / *length) * FT(across.second - across.first));
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a width in the parameter for `cut_back()` and `round_edge()` with which the new edge is
/// at about a given distance from the old one: the mean square of the distances of their points at
/// the same parameters, at the Greville abscissae, is that of the distance up to one per cent. The
/// width is a fraction of the domain of few binary digits, so that exact numbers stay short. A
/// polynomial surface that is linear across the edge has the distance exactly, with an exact
/// kernel, where that needs no irrational root: a plane face, for instance.
/// \throws Error `parameter_outside_domain` unless the distance is positive and less than that of
///   the opposite edge; `not_finite`
template <class Surface>
typename Surface::FT set_back_parameter(const Surface& surface, Patch_edge edge, double distance) {
  typedef typename Surface::FT FT;
  const std::string place =
      "set_back_parameter: the distance " + std::to_string(distance) + " from the edge " + to_string(edge);
  if (!(0 < distance)) throw Error(Error_code::parameter_outside_domain, place + " is not positive");
  const auto knots = internal::knots_of_edge(surface, edge);
  const typename Surface::Interval across = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const FT length = across.second - across.first;
  const auto point = [&](int k, double part) {
    const FT u = knots.greville_abscissa(k), step = FT(FT(part) * length),
             v = at_upper_end(edge) ? FT(across.second - step) : FT(across.first + step);
    const auto x = runs_along_u(edge) ? surface.jet(u, v, 0)(0, 0) : surface.jet(v, u, 0)(0, 0);
    std::vector<double> c;
    for (int i = 0; i < x.dimension(); ++i) c.push_back(CGAL::to_double(x[i]));
    return c;
  };
  const auto reaches = [&](double part) {
    double squares = 0;
    for (int k = 0; k < knots.number_of_coefficients(); ++k) {
      const std::vector<double> x = point(k, 0), y = point(k, part);
      for (std::size_t i = 0; i < x.size(); ++i) squares += (y[i] - x[i]) * (y[i] - x[i]);
    }
    internal::check_finite(squares, "set_back_parameter");
    return distance <= std::sqrt(squares / knots.number_of_coefficients());
  };
  if (!reaches(1))
    throw Error(Error_code::parameter_outside_domain, place + " is not less than that of the opposite edge");
  if (const std::optional<FT> exact = internal::set_back_of_ruled(surface, edge, FT(distance))) return *exact;
  double low = 0, high = 1;
  while (high - low > high / 256) (reaches(low / 2 + high / 2) ? high : low) = low / 2 + high / 2;
  return FT(FT(high) * length);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_ROUND_EDGE_H
