// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_MAP_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_MAP_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/edges/Cad_geometry.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A placement by the rational numbers that its floating-point numbers are. \throws Error `singular_frame`
class Cad_map {
  typedef Exact_field<double>::type Number;
  std::array<Coordinate_vector<Number, 3>, 3> columns_;
  Coordinate_vector<Number, 3> shift_;
  bool mirror_;

public:
  explicit Cad_map(const Cad_placement& placement) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) columns_[j][i] = Number(placement[i][j]);
      shift_[i] = Number(placement[i][3]);
    }
    const Number determinant = dot(columns_[0], cross_product(columns_[1], columns_[2]));
    if (determinant == Number(0)) throw Error(Error_code::singular_frame, "a placement is not invertible");
    mirror_ = determinant < Number(0);
  }

  const Number& operator()(int i, int j) const { return columns_[j][i]; }
  const Number& shift(int i) const { return shift_[i]; }
  bool is_mirror() const { return mirror_; }
};

// Whether the normal of a face is that of the placed surface times -1: of a mirrored surface the image of the normal is opposite to that
// of the images of the derivatives.
inline bool is_flipped(const Edge_side& side) { return side.reversed != Cad_map(side.placement).is_mirror(); }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_CAD_MAP_H
