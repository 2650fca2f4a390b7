// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CAMERA_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CAMERA_H

#include <Geometric_continuity_figures/internal/Svg_view.h>

#include <algorithm>
#include <cmath>
#include <vector>

/// \file Svg_camera.h
/// From space to the plane of a picture of surfaces: a parallel projection.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The vector with length 1, or the zero vector.
inline Svg_point svg_unit(const Svg_point& v) {
  const double length = svg_length(v);
  return length > 0 ? v / length : Svg_point(3);
}

// A parallel projection from the side of the angles azimuth and elevation, in degrees; z points
// upwards.
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_CAMERA_H
