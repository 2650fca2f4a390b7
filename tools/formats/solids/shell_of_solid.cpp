// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/shell_of_solid.h"

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace GC = CGAL::Geometric_continuity;

namespace {

typedef GC::Coordinate_vector<double, 3> Plane_vector;

template <class P> std::array<double, 3> doubles_of(const P& p) { return {p.x(), p.y(), p.z()}; }
template <class P> Plane_vector plane_vector(const P& p) {
  Plane_vector c;
  for (int k = 0; k < 3; ++k) c[k] = p[k];
  return c;
}

Shell_model::Spline_curve curve_of(const Rounded_solid::Curve& c) {
  Shell_model::Spline_curve curve{c.degree(), c.knots().knots(), {}};
  for (const auto& p : c) curve.points.push_back(doubles_of(p));
  return curve;
}

// The parameters of a plane: multiples of x and y, which are parallel to axes, or short vectors of
// a grid.
class Plane_parameters {
  const Rounded_solid::Face& face_;
  Plane_vector x_, y_;
  bool along_axes_;

  static bool is_along_axis(const Plane_vector& x) { return std::count(x.begin(), x.end(), 0.) == 2; }

public:
  explicit Plane_parameters(const Rounded_solid::Face& face)
      : face_(face), x_(plane_vector(face.x)), y_(plane_vector(face.y)),
        along_axes_(is_along_axis(x_) && is_along_axis(y_)) {
    if (!along_axes_) return;
    for (Plane_vector* x : {&x_, &y_})
      for (int k = 0; k < 3; ++k) (*x)[k] = (*x)[k] > 0 ? 1 : (*x)[k] < 0 ? -1 : 0;
  }
  bool along_axes() const { return along_axes_; }

  // Exactly, for points on the grid: then the parameters are integers.
  std::array<double, 2> operator()(const std::array<double, 3>& p) const {
    Plane_vector d(3);
    const std::array<double, 3> origin = doubles_of(face_.origin);
    for (int k = 0; k < 3; ++k) d[k] = p[static_cast<std::size_t>(k)] - origin[static_cast<std::size_t>(k)];
    if (along_axes_) return {dot(d, x_), dot(d, y_)};
    // scaled by a power of two, in which products do not underflow
    int exponent;
    std::frexp((std::max)({std::abs(x_[0]), std::abs(x_[1]), std::abs(x_[2])}), &exponent);
    const double unit = std::ldexp(1, -exponent);
    const Plane_vector x = unit * x_, y = unit * y_;
    const std::pair<double, double> c = GC::Plane_coordinates<double, 3>(x, y).nearest(unit * d);
    const double a = std::nearbyint(c.first), b = std::nearbyint(c.second);
    if (a * x_ + b * y_ == d) return {a, b};
    return {c.first, c.second};
  }

  // Where these are the least and greatest parameters.
  Shell_model::Surface surface(std::array<double, 2> lower, std::array<double, 2> upper) const {
    Shell_model::Surface s{};
    s.origin = doubles_of(face_.origin);
    s.plane = along_axes_;
    if (along_axes_) {
      for (std::size_t k = 0; k < 3; ++k) {
        s.x[k] = x_[static_cast<int>(k)];
        s.y[k] = y_[static_cast<int>(k)];
      }
      return s;
    }
    s.degree_u = s.degree_v = 1;
    for (std::size_t i = 0; i < 2; ++i) { // multiples of 16, so that corners outside of the solid are exact, too
      lower[i] = 16 * std::floor(lower[i] / 16 - 1);
      upper[i] = 16 * std::ceil(upper[i] / 16 + 1);
    }
    s.knots_u = {lower[0], lower[0], upper[0], upper[0]};
    s.knots_v = {lower[1], lower[1], upper[1], upper[1]};
    for (const double a : {lower[0], upper[0]}) {
      s.points.emplace_back();
      for (const double b : {lower[1], upper[1]}) {
        const Plane_vector d = a * x_ + b * y_;
        s.points.back().push_back({s.origin[0] + d[0], s.origin[1] + d[1], s.origin[2] + d[2]});
      }
    }
    return s;
  }
};

Shell_model::Face plane_face(const Rounded_solid::Face& face, const Shell_model& model, const std::string& name) {
  const Plane_parameters parameters(face);
  Shell_model::Face result;
  result.name = name;
  std::array<double, 2> lower{}, upper{};
  bool first = true;
  for (const auto& loop : face.loops) {
    result.loops.emplace_back();
    for (const Rounded_solid::Use& use : loop) {
      const Shell_model::Spline_curve& c = model.edges[use.edge].curve;
      Shell_model::Spline_curve_2 curve{c.degree, c.knots, {}, c.weights};
      for (const std::array<double, 3>& p : c.points) {
        curve.points.push_back(parameters(p));
        for (std::size_t k = 0; k < 2; ++k) {
          lower[k] = first ? curve.points.back()[k] : (std::min)(lower[k], curve.points.back()[k]);
          upper[k] = first ? curve.points.back()[k] : (std::max)(upper[k], curve.points.back()[k]);
        }
        first = false;
      }
      result.loops.back().push_back({static_cast<int>(use.edge), use.reversed, std::move(curve)});
    }
  }
  result.surface = parameters.surface(lower, upper);
  return result;
}

Shell_model::Face blend_face(const Rounded_solid::Blend& blend, const Shell_model& model, const std::string& name) {
  Shell_model::Face result;
  result.name = name;
  const Rounded_solid::Surface& s = blend.surface;
  result.surface.degree_u = s.degree_u();
  result.surface.degree_v = s.degree_v();
  result.surface.knots_u = s.knots_u().knots();
  result.surface.knots_v = s.knots_v().knots();
  for (int i = 0; i < s.number_of_points_u(); ++i) {
    result.surface.points.emplace_back();
    for (int j = 0; j < s.number_of_points_v(); ++j)
      result.surface.points.back().push_back(doubles_of(s.control_point(i, j)));
  }
  result.loops.emplace_back();
  for (const Rounded_solid::Blend_use& use : blend.loop) {
    const Shell_model::Spline_curve& c = model.edges[use.edge].curve;
    const auto at = [&](double t) -> std::array<double, 2> {
      switch (use.side) {
      case GC::Patch_edge::u0: return {s.domain_u().first, t};
      case GC::Patch_edge::u1: return {s.domain_u().second, t};
      case GC::Patch_edge::v0: return {t, s.domain_v().first};
      default: return {t, s.domain_v().second};
      }
    };
    result.loops.back().push_back(
        {static_cast<int>(use.edge),
         use.reversed,
         {1, {c.knots.front(), c.knots.front(), c.knots.back(), c.knots.back()}, {at(use.begin), at(use.end)}}});
  }
  return result;
}

} // namespace

void add_edges_of_solid(const Rounded_solid& solid, Shell_model& model) {
  for (const auto& p : solid.vertices) model.vertices.push_back(doubles_of(p));
  for (const Rounded_solid::Edge& e : solid.edges)
    model.edges.push_back({curve_of(e.curve), static_cast<int>(e.start), static_cast<int>(e.end)});
}

void add_faces_of_solid(const Rounded_solid& solid, const std::vector<std::string>& face_names,
                        const std::vector<std::string>& blend_names, Shell_model& model) {
  for (std::size_t i = 0; i < solid.faces.size(); ++i)
    model.faces.push_back(plane_face(solid.faces[i], model, face_names[i]));
  for (std::size_t i = 0; i < solid.blends.size(); ++i)
    model.faces.push_back(blend_face(solid.blends[i], model, blend_names[i]));
}
