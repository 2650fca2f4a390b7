// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_VIEW_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_VIEW_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <Geometric_continuity_figures/Svg_panel.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

/// \file Svg_view.h
/// From curves to the plane of a picture: one view, one scale and one comb for all panels of an
/// `Svg_figure`.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

typedef Coordinate_vector<double, 2> Svg_pixel; // y downwards

template <int N> Coordinate_vector<double, N> svg_vector(const double (&x)[N]) {
  Coordinate_vector<double, N> v(N);
  std::copy(x, x + N, &v[0]);
  return v;
}

template <int N> double svg_length(const Coordinate_vector<double, N>& v) { return std::sqrt(dot(v, v)); }

// The jet of order k at t of the curve with these Bezier points on [0, 1].
template <int N>
Coordinate_jet<double, N> polygon_jet(const std::vector<Coordinate_vector<double, N>>& points, double t, int k) {
  Coordinate_jet<double, N> jet(N, k);
  std::vector<double> c(points.size());
  for (int i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) c[j] = points[j][i];
    bernstein_derivatives(c, static_cast<int>(c.size()) - 1, t, k, [&](int j, double x) { jet[j][i] = x; });
  }
  return jet;
}

// An axis-parallel box, empty at first.
template <int N> struct Svg_box {
  Coordinate_vector<double, N> low, high;

  Svg_box() : low(N), high(N) {
    for (int i = 0; i < N; ++i) {
      low[i] = (std::numeric_limits<double>::max)();
      high[i] = -low[i];
    }
  }
  void add(const Coordinate_vector<double, N>& p) {
    for (int i = 0; i < N; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }
  Coordinate_vector<double, N> centre() const { return 0.5 * low + 0.5 * high; }
  // half the size along the axis i; 0 when empty
  double radius(int i) const { return (std::max)(0.0, 0.5 * high[i] - 0.5 * low[i]); }
};

// The curves that the frame follows: those that may not leave it, or all if there are none.
inline std::vector<Svg_curve*> svg_in_frame(const std::vector<Svg_curve*>& curves) {
  std::vector<Svg_curve*> result;
  std::copy_if(curves.begin(), curves.end(), std::back_inserter(result),
               [](const Svg_curve* c) { return c->style.in_frame; });
  return result.empty() ? curves : result;
}

// Moves and scales all curves alike, without overflow, those that the frame follows into the cube
// [-1, 1]^3. Returns how long its half side was.
inline double svg_normalise(const std::vector<Svg_curve*>& curves) {
  Svg_box<3> box;
  for (const Svg_curve* c : svg_in_frame(curves))
    for (const std::vector<Svg_point>* points : {&c->points, &c->polygon})
      for (const Svg_point& p : *points) box.add(p);
  const Svg_point centre = box.centre();
  const double radius = (std::max)({box.radius(0), box.radius(1), box.radius(2)});
  for (Svg_curve* c : curves)
    for (std::vector<Svg_point>* points : {&c->points, &c->polygon})
      for (Svg_point& p : *points) p = radius > 0 ? (p - centre) / radius : Svg_point(3);
  return radius > 0 ? radius : 1;
}

// 256 samples of each curve, in a figure of up to 256 curves; of more curves fewer, but more of
// those that are longer.
inline void svg_choose_samples(const std::vector<Svg_curve*>& curves) {
  const double most = 256, least = 8, average = most * most / static_cast<double>(curves.size());
  const auto length = [](const Svg_curve& c) { // of the control polygon
    // equivalent [0 -> 1, 1]: how many points are drawn of a curve
    double sum = 0;
    for (std::size_t j = 1; j < c.points.size(); ++j) sum += svg_length(Svg_point(c.points[j] - c.points[j - 1]));
    return sum;
  };
  double total = 0;
  for (const Svg_curve* c : curves) total += length(*c);
  for (Svg_curve* c : curves) {
    const double share = total > 0 ? length(*c) / total : 0;
    c->samples = static_cast<int>((std::min)(most, (std::max)(least, average + most * most * share)));
  }
}

// A tooth of a curvature comb.
struct Svg_tooth {
  Svg_point foot, tip;
  bool whole; // false where it is cut off, or missing because the tangent is zero
};

// The view on normalised curves that is shared by all panels of a figure.
class Svg_view {
  static constexpr double margin = 22; // pixels between the drawing and the edge of its panel

  bool spatial_;
  Svg_box<3> box_; // of the curves
  double size_;    // the diagonal of the box
  double comb_scale_ = 0;
  bool comb_is_cut_ = false;
  double unit_; // of what was given
  double scale_ = 1, width_, height_;
  Svg_pixel centre_;

public:
  // The curves have been divided by `unit`.
  Svg_view(const std::vector<Svg_curve*>& all, double unit, bool spatial, double width)
      : spatial_(spatial), unit_(unit), width_(width) {
    const std::vector<Svg_curve*> curves = svg_in_frame(all);
    for (const Svg_curve* c : curves)
      for (int i = 0; i <= c->samples; ++i) box_.add(polygon_jet(c->points, i / double(c->samples), 0)[0]);
    size_ = 2 * svg_length(svg_vector({box_.radius(0), box_.radius(1), box_.radius(2)}));
    if (!(size_ > 0)) size_ = 1;
    choose_comb_scale(curves);
    fit(curves);
  }

  bool spatial() const { return spatial_; }
  double width() const { return width_; }
  double height() const { return height_; }
  bool comb_is_cut() const { return comb_is_cut_; }

  // The curvature, of what was given, whose tooth has this length in pixels; 0 if there is no comb.
  double curvature_of_tooth(double pixels) const {
    const double factor = comb_scale_ * scale_;
    return factor > 0 ? pixels / factor / unit_ : 0;
  }

  // The picture of a point, in pixels.
  Svg_pixel operator()(const Svg_point& p) const {
    return scale_ * (project(p) - centre_) + svg_vector({0.5 * width_, 0.5 * height_});
  }
  std::vector<Svg_pixel> operator()(const std::vector<Svg_point>& points) const {
    std::vector<Svg_pixel> pixels;
    for (const Svg_point& p : points) pixels.push_back((*this)(p));
    return pixels;
  }

  // The point of the ground plane below p.
  Svg_point ground(Svg_point p) const {
    p[2] = box_.low[2] - 0.12 * size_;
    return p;
  }

  // The ground grid: its cells are squares with this side, numbered from the corner.
  double cell() const { return (std::max)({box_.radius(0), box_.radius(1), 0.2 * size_}) / 3; }
  int cells(int axis) const { return 1 + static_cast<int>(std::ceil(2 * box_.radius(axis) / cell())); }
  Svg_point grid_point(double i, double j) const {
    return ground(box_.centre() + svg_vector({(i - 0.5 * cells(0)) * cell(), (j - 0.5 * cells(1)) * cell(), 0.0}));
  }

  // The teeth of a comb, evenly dense for the eye along curve and envelope, `per_tooth` to each
  // that is to be drawn.
  std::vector<Svg_tooth> comb(const Svg_curve& curve, int per_tooth) const {
    std::vector<double> way(1, 0.0);
    Svg_tooth last = tooth(curve, 0);
    for (int i = 1; i <= curve.samples; ++i) {
      const Svg_tooth next = tooth(curve, i / double(curve.samples));
      way.push_back(way.back() + svg_length(next.foot - last.foot) + svg_length(next.tip - last.tip));
      last = next;
    }
    const double spacing = 10; // pixels of the way
    const int n = per_tooth * static_cast<int>(std::ceil((std::min)(scale_ * way.back() / spacing, 1000.0)));
    std::vector<Svg_tooth> teeth;
    for (int i = 0, j = 0; i <= n && n > 0; ++i) {
      const double w = way.back() * i / n;
      while (j + 1 < curve.samples && way[j + 1] < w) ++j;
      const double step = way[j + 1] - way[j];
      teeth.push_back(tooth(curve, (j + (step > 0 ? (std::min)(1.0, (w - way[j]) / step) : 0.0)) / curve.samples));
    }
    return teeth;
  }

private:
  double comb_limit() const { return 0.18 * size_; }

  // Spatial curves are seen from azimuth -68 and elevation 23 degrees.
  Svg_pixel project(const Svg_point& p) const {
    if (!spatial_) return svg_vector({p[0], -p[1]});
    const double ca = 0.3746066, sa = 0.9271839, se = 0.3907311, ce = 0.9205049;
    return svg_vector({sa * p[0] + ca * p[1], (ca * p[0] - sa * p[1]) * se - ce * p[2]});
  }

  static std::optional<Svg_point> curvature(const Coordinate_jet<double, 3>& jet) {
    if (dot(jet[1], jet[1]) < 1e-12) return std::nullopt; // too slow to be measured
    return curvature_vector(jet);
  }

  Svg_tooth tooth(const Svg_curve& curve, double t) const {
    const Coordinate_jet<double, 3> jet = polygon_jet(curve.points, t, 2);
    const std::optional<Svg_point> k = curvature(jet);
    if (!k) return {jet[0], jet[0], false};
    const double length = comb_scale_ * svg_length(*k);
    const bool whole = length <= 1.02 * comb_limit();
    return {jet[0], jet[0] - (whole ? comb_scale_ : comb_scale_ * comb_limit() / length) * *k, whole};
  }

  // Nine tenths of the combed length have teeth up to half the limit; more when thereby no tooth
  // exceeds the limit.
  void choose_comb_scale(const std::vector<Svg_curve*>& curves) {
    std::vector<std::pair<double, double>> weighted; // curvature, length of arc
    double total = 0;
    for (const Svg_curve* c : curves)
      for (int i = 0; i <= c->samples && c->style.curvature_comb; ++i) {
        const Coordinate_jet<double, 3> jet = polygon_jet(c->points, i / double(c->samples), 2);
        const std::optional<Svg_point> k = curvature(jet);
        if (!k) continue;
        weighted.emplace_back(svg_length(*k), svg_length(jet[1]) / c->samples);
        total += weighted.back().second;
      }
    if (weighted.empty()) return;
    std::sort(weighted.begin(), weighted.end());
    double sum = 0;
    std::size_t i = 0;
    while ((sum += weighted[i].second) < 0.9 * total) ++i;
    // straight for the eye, so that rounding errors are not magnified
    const double flat = 1e-6 / size_;
    const double common = (std::max)(weighted[i].first, flat), most = (std::max)(weighted.back().first, flat);
    comb_scale_ = comb_limit() * (std::max)(1 / most, 0.5 / common);
    comb_is_cut_ = comb_scale_ * most > 1.02 * comb_limit();
  }

  // Curves, whole teeth and the ground are seen entirely; of cut teeth two thirds and the margin,
  // of a control polygon what is near.
  void fit(const std::vector<Svg_curve*>& curves) {
    Svg_box<2> picture;
    for (const Svg_curve* c : curves)
      for (int i = 0; i <= c->samples; ++i) {
        const Svg_tooth t = tooth(*c, i / double(c->samples));
        picture.add(project(t.foot));
        if (c->style.curvature_comb) picture.add(project(t.foot + (t.whole ? 1.0 : 2.0 / 3) * (t.tip - t.foot)));
      }
    if (spatial_)
      for (int i : {0, cells(0)})
        for (int j : {0, cells(1)}) picture.add(project(grid_point(i, j)));
    const Svg_box<2> core = picture;
    for (const Svg_curve* c : curves)
      for (std::size_t j = 0; j < c->polygon.size(); ++j) {
        const Svg_pixel p = project(c->polygon[j]);
        bool touches = true;
        for (int i : {0, 1}) touches = touches && std::abs(p[i] - core.centre()[i]) <= core.radius(i) + 0.1 * size_;
        if (touches) picture.add(p);
      }
    centre_ = picture.centre();
    const double inner = width_ - 2 * margin, x = picture.radius(0), y = picture.radius(1);
    const double inner_height = x > 0 ? inner * (std::min)((std::max)(y / x, 0.35), 1.1) : inner * (y > 0 ? 1.1 : 0.35);
    height_ = inner_height + 2 * margin;
    scale_ = x > 0 || y > 0 ? (std::min)(inner / (std::max)(2 * x, 1e-9), inner_height / (std::max)(2 * y, 1e-9)) : 1;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_VIEW_H
