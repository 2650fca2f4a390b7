// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_EDGES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surfaces/cut_back.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file round_edges.h
/// Edges are rounded: two surfaces that meet in an edge are cut back from it, and a blend is put in
/// its place; and so are all sharp edges of a model.

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

// Checks that an edge has normals: where it has, the surface and its mirror image S(u, -v), with
// the rows C, -T, W, continue each other.
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

// Returns how the second edge runs, if the edges are the same as a whole and not smooth.
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
/// With every kernel it is decided exactly whether the surfaces have the edge in common, and are
/// not \f$ G^2 \f$ there. An edge with \f$ G^1 \f$ is rounded as well. The blend may be folded
/// where it has not enough room; `Rounded_edge::fold` is nothing where that is disproved.
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

/// \ingroup PkgGeometricContinuitySurfaces
/// The edges of a model that are rounded, and how.
struct Rounding_of_edges {
  /// the distance of the new edges from the old ones, see `set_back_parameter()`
  double set_back;
  /// in degrees: edges stay where the largest angle between the normals is smaller
  double least_angle = 5;
  /// in degrees: edges stay, as they are meant, where the largest angle is greater
  double greatest_angle = 180;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A surface in the place of a sharp edge of a model.
/// \tparam Surface the type of the surfaces
template <class Surface> struct Rounding_blend {
  typedef typename Surface::FT FT;                    ///< the field
  typedef Edge_field<typename Surface::Traits> Field; ///< in which is decided

  std::size_t patch_a; ///< the number of the first surface, from 0 on
  Patch_edge edge_a;   ///< its edge, at `v = 0` of the blend
  std::size_t patch_b; ///< the number of the second surface
  Patch_edge edge_b;   ///< its edge, at `v = 1` of the blend
  /// the largest angle that there was between the normals, in degrees
  Enclosure angle;
  Surface surface;                      ///< the blend
  Spline_edge_continuity<Field> with_a; ///< along the new edge of the first surface
  Spline_edge_continuity<Field> with_b; ///< along the new edge of the second surface
  /// Where the blend may be folded, see `possible_fold()`.
  std::optional<Parameter_rectangle<FT>> fold;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A corner of a model at which rounding leaves a hole: a rounded edge ends there, and more than
/// two surfaces meet; but not where the edge goes on, and the blends meet.
/// \tparam Traits the traits class of the surfaces
template <class Traits> struct Open_corner {
  typename Traits::Point point;     ///< where the corner was
  std::vector<std::size_t> patches; ///< the numbers of the surfaces that had it
  std::vector<std::size_t> blends;  ///< the numbers of the blends that end there
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A model with rounded edges.
/// \tparam Surface the type of the surfaces
template <class Surface> struct Rounded_model {
  /// those of the model, trimmed back, in their order
  std::vector<Surface> surfaces;
  /// in the order of `Model_continuity::edges`
  std::vector<Rounding_blend<Surface>> blends;
  std::vector<Open_corner<typename Surface::Traits>> corners; ///< left open
  std::size_t meant = 0; ///< sharp edges that stay because their angle is too great
  /// edges that are not smooth and stay because their angle is too small
  std::size_t slight = 0;
  /// edges with other defects: normals that vanish, or more than two surfaces
  std::size_t not_rounded = 0;

  /// Returns whether all blends are \f$ G^2 \f$ along both edges.
  bool is_g2() const {
    return std::all_of(blends.begin(), blends.end(),
                       [](const Rounding_blend<Surface>& b) { return b.with_a.g_order >= 2 && b.with_b.g_order >= 2; });
  }
};

namespace internal {

template <class Surface> class Model_rounding {
  typedef typename Surface::Traits Traits;
  typedef typename Surface::FT FT;
  typedef Edge_field<Traits> Field;
  typedef Model_edge<Field> Row;
  typedef Coordinates<Traits> Corner;
  typedef Side_of_blend<Surface, Surface> Side;

  struct Less {
    bool operator()(const Corner& x, const Corner& y) const { return compare_coordinates(x, y) < 0; }
    bool operator()(const std::pair<Corner, Corner>& x, const std::pair<Corner, Corner>& y) const {
      const int first = compare_coordinates(x.first, y.first);
      return first < 0 || (first == 0 && compare_coordinates(x.second, y.second) < 0);
    }
  };

  const std::vector<Surface>& given_;
  const Rounding_of_edges& rounding_;
  Rounded_model<Surface> result_;
  std::vector<const Row*> rounded_;
  // the sides of blends, by where they start and end
  std::map<std::pair<Corner, Corner>, std::pair<std::size_t, Patch_edge>, Less> sides_;
  // blends: the second one was given a side of the first one
  std::vector<std::pair<std::size_t, std::size_t>> meeting_;

public:
  Model_rounding(const std::vector<Surface>& given, const Rounding_of_edges& rounding)
      : given_(given), rounding_(rounding) {
    result_.surfaces = given;
  }

  template <class Strategy> Rounded_model<Surface> operator()(const Strategy& strategy) {
    const Model_continuity<Field> model = model_continuity(given_);
    for (const Row& row : model.edges)
      if (row.kind == Model_edge_kind::shared && row.continuity.g_order < 2 && is_to_be_rounded(row))
        rounded_.push_back(&row);
    for (const Row* row : rounded_) {
      trim(row->patch_a, row->edge_a);
      trim(*row->patch_b, *row->edge_b);
    }
    for (const Row* row : rounded_) add_blend(*row, strategy);
    find_open_corners();
    return std::move(result_);
  }

private:
  bool is_to_be_rounded(const Row& row) {
    if (row.non_manifold || !row.continuity.deviation || row.continuity.normal_vanishes) {
      ++result_.not_rounded;
      return false;
    }
    const Enclosure angle = in_degrees(row.continuity.deviation->angle());
    if (angle.upper < rounding_.least_angle) {
      ++result_.slight;
      return false;
    }
    if (rounding_.greatest_angle < angle.lower) {
      ++result_.meant;
      return false;
    }
    return true;
  }

  // Calls f(), and names the edge in its errors.
  template <class Function> static void for_edge(std::size_t patch, Patch_edge edge, const Function& f) {
    try {
      f();
    } catch (const Error& error) {
      const std::string text = error.what(), code = to_string(error.code()) + ": ";
      throw Error(error.code(), edge_name(patch, edge) + ": " + text.substr(code.size()));
    }
  }

  void trim(std::size_t patch, Patch_edge edge) {
    Surface& s = result_.surfaces[patch];
    for_edge(patch, edge, [&] { s = cut_back(s, edge, set_back_parameter(given_[patch], edge, rounding_.set_back)); });
  }

  template <class Strategy> void add_blend(const Row& row, const Strategy& strategy) {
    const Surface &a = result_.surfaces[row.patch_a], &b = result_.surfaces[*row.patch_b];
    for_edge(row.patch_a, row.edge_a, [&] {
      check_normals(a, row.edge_a, "round_edges: at the new edge");
      check_normals(b, *row.edge_b, "round_edges: at the new edge of " + edge_name(*row.patch_b, *row.edge_b));
      Surface s = blend_with_sides(row, strategy);
      auto with_a = edge_continuity(a, row.edge_a, s, Patch_edge::v0),
           with_b = edge_continuity(s, Patch_edge::v1, b, *row.edge_b);
      auto fold = possible_fold(s);
      result_.blends.push_back({row.patch_a, row.edge_a, *row.patch_b, *row.edge_b,
                                in_degrees(row.continuity.deviation->angle()), std::move(s), std::move(with_a),
                                std::move(with_b), std::move(fold)});
    });
  }

  // The blend continues blends that end where it starts, if it can: with their derivatives across
  // the side, or only with the same curve.
  template <class Strategy> Surface blend_with_sides(const Row& row, const Strategy& strategy) {
    const Surface &a = result_.surfaces[row.patch_a], &b = result_.surfaces[*row.patch_b];
    const bool reversed = row.continuity.reversed;
    const Edge_direction direction = reversed ? Edge_direction::opposite : Edge_direction::same;
    const auto shape = automatic_surface_shape(a, row.edge_a, b, *row.edge_b, strategy, direction);
    std::array<std::optional<Side>, 2> sides;
    std::vector<std::size_t> neighbours; // blends
    std::array<std::pair<Corner, Corner>, 2> ends;
    for (const bool upper : {false, true}) {
      const Corner x = end_of_edge(a, row.edge_a, upper), y = end_of_edge(b, *row.edge_b, upper != reversed);
      ends[upper] = {x, y};
      for (const bool swapped : {false, true}) {
        const auto found = sides_.find(swapped ? std::make_pair(y, x) : ends[upper]);
        if (found == sides_.end()) continue;
        neighbours.push_back(found->second.first);
        sides[upper].emplace(result_.blends[found->second.first].surface, found->second.second,
                             swapped ? Edge_direction::opposite : Edge_direction::same);
      }
    }
    sides_.emplace(ends[0], std::make_pair(result_.blends.size(), Patch_edge::u0));
    sides_.emplace(ends[1], std::make_pair(result_.blends.size(), Patch_edge::u1));
    if constexpr (is_quintic_surface_strategy_v<Strategy>)
      // unreachable: for curves that do not fit: blends begin along lines across the edge, which
      //   both halves have at a corner
      for (int attempt = 0; attempt < 2 && (sides[0] || sides[1]); ++attempt) {
        try {
          Surface s = blend(
              a, row.edge_a, b, *row.edge_b,
              surface_shape_with_sides(a, row.edge_a, b, *row.edge_b, direction, shape, sides[0], sides[1]), direction);
          for (const std::size_t other : neighbours) meeting_.emplace_back(other, result_.blends.size());
          return s;
        } catch (const Error& error) {
          // unreachable: for work or numbers that exceed their limits with given sides only
          if (error.code() == Error_code::work_limit || error.code() == Error_code::not_finite) throw;
        }
        for (std::optional<Side>& side : sides)
          if (side) side = side->curve_only();
      }
    return blend(a, row.edge_a, b, *row.edge_b, shape, direction);
  }

  // The point at an end of an edge.
  static Coordinates<Traits> end_of_edge(const Surface& s, Patch_edge edge, bool upper) {
    const auto u = s.domain_u(), v = s.domain_v();
    const bool upper_u = runs_along_u(edge) ? upper : at_upper_end(edge),
               upper_v = runs_along_u(edge) ? at_upper_end(edge) : upper;
    return Geometric_continuity::coordinates<Traits>(s(upper_u ? u.second : u.first, upper_v ? v.second : v.first));
  }

  void find_open_corners() {
    std::map<Coordinates<Traits>, std::size_t, Less> numbers; // of corners where rounded edges end
    auto& corners = result_.corners;
    for (std::size_t i = 0; i < rounded_.size(); ++i)
      for (bool upper : {false, true}) {
        const Coordinates<Traits> x = end_of_edge(given_[rounded_[i]->patch_a], rounded_[i]->edge_a, upper);
        const auto place = numbers.emplace(x, corners.size());
        if (place.second) corners.push_back({to_point<Traits>(x), {}, {}});
        corners[place.first->second].blends.push_back(i);
      }
    for (std::size_t patch = 0; patch < given_.size(); ++patch)
      for (Patch_edge edge : {Patch_edge::v0, Patch_edge::v1})
        for (bool upper : {false, true}) {
          const auto place = numbers.find(end_of_edge(given_[patch], edge, upper));
          if (place == numbers.end()) continue;
          std::vector<std::size_t>& patches = corners[place->second].patches;
          if (patches.empty() || patches.back() != patch) patches.push_back(patch);
        }
    const auto is_closed = [&](const auto& c) {
      if (c.patches.size() <= 2) return true;
      return c.patches.size() == 4 && c.blends.size() == 2 &&
             std::find(meeting_.begin(), meeting_.end(), std::make_pair(c.blends[0], c.blends[1])) != meeting_.end();
    };
    corners.erase(std::remove_if(corners.begin(), corners.end(), is_closed), corners.end());
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Rounds the sharp edges of a model: all surfaces are trimmed back from those of their edges that
/// are rounded, and for each such edge a blend leads from the one new edge to the other, see
/// `round_edge()`. With an exact kernel each blend is exactly \f$ G^2 \f$ with both surfaces along
/// the whole new edges, which is decided for the result as it is.
///
/// Edges are rounded that two surfaces share, see `model_continuity()`, along which they are not
/// \f$ G^2 \f$, and where the largest angle between the normals is in the given interval. Where
/// more than two surfaces meet at the end of a rounded edge, a hole is left open. Where an edge
/// goes on, and both surfaces were trimmed back to one point, the next blend of degree 5 is given
/// the side of the last one, see `surface_shape_with_sides()`, if this fits both surfaces: then
/// they meet, with \f$ G^1 \f$ where that is possible.
/// \param surfaces a range of `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`
/// \param rounding the edges that are rounded
/// \param strategy chooses the shapes, see `automatic_surface_shape()`
/// \throws Error `parameter_outside_domain` where a surface has no room for the distance;
///   `singular_frame`, and others of `round_edge()`, with the number of the surface and the edge;
///   those of `model_continuity()`
template <class Surface, class Strategy = Minimal_energy<3>>
Rounded_model<Surface> round_edges(const std::vector<Surface>& surfaces, const Rounding_of_edges& rounding,
                                   const Strategy& strategy = Strategy()) {
  return internal::Model_rounding<Surface>(surfaces, rounding)(strategy);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_EDGES_H
