// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_WALL_CURVE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_WALL_CURVE_H

#include "formats/cad/Cad_solid.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The coordinates of a point, and the length of a vector.
template <class P = std::array<double, 3>> GC::Coordinate_vector<double, 3> wall_vector(const P& p) {
  GC::Coordinate_vector<double, 3> v(3);
  for (int k = 0; k < 3; ++k) v[k] = p[k];
  return v;
}
inline double wall_norm(const GC::Coordinate_vector<double, 3>& v) { return std::sqrt(dot(v, v)); }

// The direction of walls, and heights along it: exact ones along an axis of the coordinates.
class Wall_axis {
public:
  typedef GC::Coordinate_vector<double, 3> Vector;

  explicit Wall_axis(const Vector& direction);
  const Vector& direction() const { return direction_; }
  bool is_coordinate_axis() const { return number_ >= 0; }
  double height(const Vector& p) const { return number_ >= 0 ? p[number_] : dot(p, direction_); }
  // The point at the height 0.
  Vector flat(Vector p) const {
    if (number_ < 0) return p - dot(p, direction_) * direction_;
    p[number_] = 0;
    return p;
  }
  Vector at(Vector flat, double height) const {
    if (number_ < 0) return flat + height * direction_;
    flat[number_] = height;
    return flat;
  }

private:
  int number_ = -1;
  Vector direction_;
};

// The curve of a wall at the height 0, and the rails beside it.
class Wall_curve {
public:
  typedef Wall_axis::Vector Vector;
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
  typedef GC::Rational_bspline_curve<Traits> Spline;
  enum class Kind { line, circle, spline };

  // The curve of an edge, from one end to the other, which are at the height 0.
  Wall_curve(const Cad_solid::Edge& edge, const Wall_axis& axis, const Vector& from, const Vector& to);

  Kind kind() const { return kind_; }
  const Spline& spline() const { return *spline_; }
  // The unit tangents at both ends.
  std::array<Vector, 2> end_tangents() const { return {tangent(domain().first), tangent(domain().second)}; }
  // Gives a spline more knots until distances of rails are right to a thousandth.
  void refine();
  // The control points of the rail at a distance from the curve: on its left side, as seen from the
  // tip of the axis, or where side is -1 on its right. Its ends lie along these vectors.
  std::vector<Vector> rail(double distance, int side, const std::array<Vector, 2>& directions) const;
  // How far distances of rails may be wrong, as a part of them, after refine().
  double error() const { return error_; }
  // The least radius of the curve on this side, at a place; nothing if it does not bend to it.
  struct Radius {
    double radius;
    Vector place;
  };
  std::optional<Radius> least_radius(int side) const;
  // An angle of the tangents at an inner knot of more than this, in degrees, and its place.
  struct Kink {
    double degrees;
    Vector place;
  };
  std::optional<Kink> kink(double degrees) const;
  std::vector<double> samples(int of_each_span) const;
  Vector point(double u) const;
  Vector tangent(double u) const; // of length 1
  Vector normal(double u) const { return cross_product(axis_.direction(), tangent(u)); }
  std::pair<double, double> domain() const { return spline_->domain(); }

private:
  Wall_axis axis_;
  Kind kind_;
  double radius_ = 0, error_ = 0;
  Vector centre_;
  bool left_turn_ = true;
  std::optional<Spline> spline_;

  void make_arc(const Vector& from, const Vector& to, double angle);
  void set(int degree, std::vector<double> knots, const std::vector<Vector>& points, std::vector<double> weights);
  std::vector<Vector> normals() const; // the coefficients of the field of normals
  double largest_error(const std::vector<Vector>& directions) const;
};

// The spline with the knots and the weights of a curve and with these control points.
Wall_curve::Spline spline_like(const Wall_curve::Spline& curve, const std::vector<Wall_curve::Vector>& points);

// Two orthogonal unit vectors in the plane with this normal of length 1.
std::array<Wall_curve::Vector, 2> vectors_in_plane(const Wall_curve::Vector& normal);

// The point of an edge after this part of its parameters.
std::array<double, 3> point_of_edge(const Cad_solid& solid, const Cad_solid::Edge& edge, double part);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SOLIDS_WALL_CURVE_H
