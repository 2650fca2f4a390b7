// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_CAD_GEOMETRY_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_CAD_GEOMETRY_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <variant>
#include <vector>

/// \file exact_cad_geometry.h
/// Placements, knots and straight curves of CAD models, by the rational numbers that their
/// floating-point numbers are.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// the numbers of a model, and what is computed from them
typedef Exact_field<double>::type Model_number;

// The function w + f t.
struct Linear_function {
  Model_number constant, slope;
};

// A placement by the rational numbers that its floating-point numbers are. \throws Error
// `singular_frame`
class Cad_map {
  typedef Model_number Number;
  std::array<Coordinate_vector<Number, 3>, 3> columns_;
  Coordinate_vector<Number, 3> shift_;
  bool mirror_;

public:
  explicit Cad_map(const Cad_placement& placement) {
    for (int i = 0; i < 3; ++i) {
      // equivalent [3 -> 4, 1]: writes what is written again after it
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

// Returns whether the normal of a face is that of the placed surface times -1: of a mirrored
// surface the image of the normal is opposite to that of the images of the derivatives.
inline bool is_flipped(const Edge_side& side) { return side.reversed != Cad_map(side.placement).is_mirror(); }

inline bool are_equal(const std::vector<double>& weights) {
  return std::adjacent_find(weights.begin(), weights.end(), std::not_equal_to<double>()) == weights.end();
}
inline Knot_vector<Model_number> given_knots(int degree, const std::vector<double>& knots) {
  return knots_over<Model_number>(Knot_vector<double>(degree, knots));
}

// The two coordinates of a curve in the parameter plane, if both are linear functions. \pre its
// numbers have been checked
inline std::optional<std::array<Linear_function, 2>> straight_line(const Cad_curve<2>& curve) {
  std::array<Linear_function, 2> r;
  if (const auto* line = std::get_if<Cad_line<2>>(&curve)) {
    for (int i = 0; i < 2; ++i) r[i] = {Model_number(line->origin[i]), Model_number(line->direction[i])};
    return r;
  }
  const auto* spline = std::get_if<Cad_spline_curve<2>>(&curve);
  if (!spline || !are_equal(spline->weights)) return std::nullopt;
  const Knot_vector<Model_number> knots = given_knots(spline->degree, spline->knots);
  const int last = knots.number_of_coefficients() - 1;
  // a spline is linear when its coefficients are its values at the Greville abscissae
  const Model_number start = knots.greville_abscissa(0), length = Model_number(knots.greville_abscissa(last) - start);
  for (int i = 0; i < 2; ++i) {
    const Model_number x0(spline->points.front()[i]);
    r[i].slope = Model_number(Model_number(Model_number(spline->points.back()[i]) - x0) / length);
    r[i].constant = Model_number(x0 - r[i].slope * start);
    for (int j = 1; j < last; ++j)
      if (Model_number(spline->points[j][i]) != Model_number(r[i].constant + r[i].slope * knots.greville_abscissa(j)))
        return std::nullopt;
  }
  return r;
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_EXACT_CAD_GEOMETRY_H
