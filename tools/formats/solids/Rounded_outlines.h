// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_OUTLINES_H

#include "formats/cad/Shell_model.h"
#include "formats/solids/Outlined_solid.h"
#include "formats/solids/Rounded_solid.h"

#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The blends along the outlines of a solid, and with its polyhedron, which may be rounded, the
// closed shell.
class Rounded_outlines {
public:
  typedef Outlined_solid::Vector Vector;
  typedef GC::Rational_bspline_surface<Wall_curve::Traits> Surface;
  static constexpr double smooth_degrees = 0.05; // an outline bends by no more where it is smooth

  struct Blend {
    std::size_t edge, outline;
    Surface surface;
    bool exact_at_wall, exact_in_plane; // G2, decided with the doubles as they are
    double off;                         // how far rows are from wall and plane, if they are
  };

  // Rounds the edges with cuts that are not 0, by their numbers in the file. The planes of the
  // polyhedron are those of its rounded shape. Throws std::runtime_error with the edge or the face,
  // and the bound, where there is not enough room, or an outline has a corner.
  Rounded_outlines(const Outlined_solid& solid, std::vector<double> cuts, double fullness,
                   const Rounded_solid* polyhedron);

  const std::vector<Blend>& blends() const { return blends_; }
  std::size_t outlines() const { return rounded_.size(); } // that are rounded
  std::size_t mitres() const { return mitres_; }
  // How far the set-back on a plane may be wrong, as a part of it.
  double error() const;
  Shell_model shell(const std::vector<std::string>& face_names, const std::vector<std::string>& blend_names) const;

private:
  struct Plane {
    Vector origin, normal;
  };
  typedef std::pair<std::size_t, std::size_t> Level; // of a wall, or of a side of walls: its number, and 0 or 1
  // The directions of a rail at both ends of the curve of its wall.
  typedef std::array<Vector, 2> Directions;
  struct Rail {
    std::size_t blend;
    int side;
    Directions directions;
  };
  // A closed polygon in a plane, with the edge of each side.
  struct Polygon {
    std::vector<std::array<double, 2>> points;
    std::vector<std::size_t> edges;
    bool is_outer;
  };

  const Outlined_solid& solid_;
  std::vector<Wall_curve> curves_;
  std::vector<double> cuts_;
  double fullness_;
  const Rounded_solid* polyhedron_;
  std::map<std::size_t, Plane> planes_; // of the faces with outlines
  std::vector<Blend> blends_;
  std::vector<std::size_t> rounded_;
  std::map<Level, Rail> rails_; // of walls
  std::size_t mitres_ = 0;

  double cut(const Outlined_solid::Rim& rim) const { return cuts_[solid_.edge_of(rim)]; }
  void find_planes();
  void check_sides() const;
  void check_heights() const;
  void add_outline(std::size_t number);
  Vector direction_at(const Outlined_solid::Outline& outline, std::size_t i);
  void check_curve(const Outlined_solid::Rim& rim, int side, const Directions& directions) const;
  void check_rails(std::size_t face) const;
  std::vector<Polygon> polygons(std::size_t face, double factor) const;
  std::optional<std::pair<std::size_t, std::size_t>> meeting_edges(std::size_t face, double factor) const;
  void decide(Blend& blend, const Outlined_solid::Rim& rim) const;
  Vector on_plane(std::size_t face, const Wall_axis& axis, const Vector& flat) const;
  std::vector<Vector> rim_points(const Outlined_solid::Wall& wall, std::size_t number, std::size_t level) const;
  friend class Outline_shell;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_ROUNDED_OUTLINES_H
