// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_EDGES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_EDGES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/internal/Edge_groups.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_sides.h>
#include <CGAL/Geometric_continuity/surface_blends/round_edge.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file round_edges.h
/// All sharp edges of a model are rounded.

namespace CGAL {
namespace Geometric_continuity {

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

  // Which goes on from blends that end where it does, if it can: with their derivatives across the
  // side, or only with the same curve.
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
      for (int attempt = 0; attempt < 2 && (sides[0] || sides[1]); ++attempt) {
        try {
          Surface s = blend(
              a, row.edge_a, b, *row.edge_b,
              surface_shape_with_sides(a, row.edge_a, b, *row.edge_b, direction, shape, sides[0], sides[1]), direction);
          for (const std::size_t other : neighbours) meeting_.emplace_back(other, result_.blends.size());
          return s;
        } catch (const Error& error) {
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
