// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CAMERA_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CAMERA_H

#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// \file Svg_camera.h
/// From surfaces to the plane of a picture: a parallel projection, and what hides what.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The vector with length 1, or the zero vector.
inline Svg_point svg_unit(const Svg_point& v) {
  const double length = svg_length(v);
  return length > 0 ? v / length : Svg_point(3);
}

// A parallel projection from the side of the angles azimuth and elevation, in degrees; z points upwards.
class Svg_camera {
  Svg_point right_, up_, toward_; // the viewer
  double scale_ = 1;
  Svg_pixel shift_;

public:
  Svg_camera(double azimuth, double elevation) : shift_(2) {
    const double degree = 3.14159265358979323846 / 180, ca = std::cos(azimuth * degree),
                 sa = std::sin(azimuth * degree);
    const double ce = std::cos(elevation * degree), se = std::sin(elevation * degree);
    toward_ = svg_vector({ca * ce, sa * ce, se});
    right_ = svg_vector({-sa, ca, 0.0});
    up_ = cross_product(toward_, right_);
  }

  // Makes the points fill a given width; returns the height.
  double fit(const std::vector<Svg_point>& points, double width, double margin) {
    Svg_box<2> box;
    for (const Svg_point& p : points) box.add((*this)(p));
    const double x = (std::max)(box.radius(0), 0.1 * box.radius(1)), y = box.radius(1);
    if (!(x > 0)) return width;
    scale_ *= (0.5 * width - margin) / x;
    shift_ = svg_vector({0.5 * width, scale_ * y + margin}) - scale_ * box.centre();
    return 2 * (scale_ * y + margin);
  }

  Svg_pixel operator()(const Svg_point& p) const {
    return scale_ * svg_vector({dot(right_, p), -dot(up_, p)}) + shift_;
  }
  // Greater where it is nearer to the viewer, in pixels.
  double depth(const Svg_point& p) const { return scale_ * dot(toward_, p); }
  const Svg_point& toward() const { return toward_; }
  // A direction given as to the right, upwards and to the viewer.
  Svg_point direction(double right, double up, double toward) const {
    return svg_unit(right * right_ + up * up_ + toward * toward_);
  }
};

// The least distance from the viewer, pixel by pixel.
class Svg_depth_buffer {
  int width_, height_;
  std::vector<double> depth_; // the greatest

public:
  Svg_depth_buffer(double width, double height)
      : width_(1 + static_cast<int>(width)), height_(1 + static_cast<int>(height)),
        depth_(static_cast<std::size_t>(width_) * height_, -(std::numeric_limits<double>::max)()) {}

  // Calls f(place, depth) for each pixel whose centre is in the triangle.
  template <class Function>
  void scan(const std::array<Svg_pixel, 3>& p, const std::array<double, 3>& depth, Function f) {
    const Svg_pixel a = p[1] - p[0], b = p[2] - p[0];
    const double area = a[0] * b[1] - a[1] * b[0];
    if (area == 0) return;
    const auto range = [&](int axis, int size) {
      const double low = (std::min)({p[0][axis], p[1][axis], p[2][axis]}),
                   high = (std::max)({p[0][axis], p[1][axis], p[2][axis]});
      return std::make_pair((std::max)(0, static_cast<int>(std::floor(low))),
                            (std::min)(size - 1, static_cast<int>(std::ceil(high))));
    };
    const auto x = range(0, width_), y = range(1, height_);
    for (int j = y.first; j <= y.second; ++j)
      for (int i = x.first; i <= x.second; ++i) {
        const Svg_pixel d = svg_vector({i + 0.5, j + 0.5}) - p[0];
        const double s = (d[0] * b[1] - d[1] * b[0]) / area, t = (a[0] * d[1] - a[1] * d[0]) / area;
        if (s >= 0 && t >= 0 && s + t <= 1)
          f(depth_[static_cast<std::size_t>(j) * width_ + i],
            depth[0] + s * (depth[1] - depth[0]) + t * (depth[2] - depth[0]));
      }
  }

  // The farthest of what is nearest in the pixels around a place.
  double around(const Svg_pixel& p) const {
    double result = (std::numeric_limits<double>::max)();
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const int x = static_cast<int>(std::floor(p[0])) + i, y = static_cast<int>(std::floor(p[1])) + j;
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return -(std::numeric_limits<double>::max)();
        result = (std::min)(result, depth_[static_cast<std::size_t>(y) * width_ + x]);
      }
    return result;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_CAMERA_H
