// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_OUTLINED_SOLID_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_OUTLINED_SOLID_H

#include "formats/cad/Cad_solid.h"
#include "formats/solids/Solid.h"
#include "formats/solids/Wall_curve.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

// A solid of planes and walls at right angles to planes: plates with rounded outlines, holes,
// bosses. What is left without the walls is a polyhedron, or several, or nothing.
struct Outlined_solid {
  typedef Wall_axis::Vector Vector;

  // Four edges bound a wall: two rims, which are one curve at two heights, and two sides, along the
  // axis. A wall that is closed has one side, twice.
  struct Wall {
    std::size_t face;
    Wall_axis axis;
    std::array<std::size_t, 2> rims;  // below and above, along the axis
    std::array<bool, 2> along;        // whether these edges run as the curve does
    std::array<std::size_t, 2> sides; // where the curve begins and ends
    Wall_curve curve;
    std::array<std::size_t, 2> planes; // the faces at the rims
    std::array<double, 2> heights;
  };
  // A rim as the loop of its plane face passes it: along the curve of the wall, or against it.
  struct Rim {
    std::size_t wall, level; // 0 below and 1 above
    bool along;
  };
  struct Outline {
    std::size_t face;
    std::vector<Rim> rims; // the face is on the left, as seen from outside
    bool is_outer;
    int sign; // 1 where the face points along the axis, -1 against it
    bool is_convex;
  };

  Cad_solid given;
  std::vector<Wall> walls;
  std::vector<Outline> outlines;
  std::vector<std::size_t> caps; // faces with outlines only
  Solid polyhedron;              // the other plane faces, without outlines
  std::vector<std::size_t> faces_of_polyhedron;
  double size = 0;

  // Throws std::runtime_error with the face and the edge for a solid of another kind.
  explicit Outlined_solid(Cad_solid solid);

  Vector vertex(std::size_t v) const;
  std::string face_name(std::size_t face) const;
  const Wall& wall_at(const Rim& rim) const { return walls[rim.wall]; }
  std::size_t edge_of(const Rim& rim) const { return walls[rim.wall].rims[rim.level]; }
  // The side where the loop comes to the rim, or leaves it.
  std::size_t first_side(const Rim& rim) const { return walls[rim.wall].sides[rim.along ? 0 : 1]; }
  // The unit tangents of an outline where two rims follow each other: at the end of the first one,
  // and at the start of the second one.
  std::array<Vector, 2> tangents(const Rim& rim, const Rim& next) const;

private:
  struct Pass {
    std::size_t face;
    bool reversed;
  };
  std::vector<std::vector<Pass>> passes_; // of each edge
  std::map<std::size_t, std::size_t> wall_of_face_;
  std::vector<int> is_wall_; // of each face
  std::vector<Vector> axes_; // of each face that is a wall
  double tolerance_ = 0;

  void check_shell() const;
  bool is_inside_out() const;
  void turn_inside_out();
  void find_walls();
  void add_wall(std::size_t face);
  void add_plane(std::size_t face);
  bool is_along(std::size_t edge, const Vector& axis) const;
  bool curves_agree(std::size_t wall_edge, std::size_t other, bool reversed, const Wall_axis& axis) const;
  double area(const Cad_solid::Loop& loop, const Vector& normal) const;
  [[noreturn]] void refuse(std::size_t face, const std::string& reason) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_OUTLINED_SOLID_H
