// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACETS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACETS_H

#include <CGAL/Geometric_continuity/IO/figures/Svg_panel.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_view.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/svg_markup.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_facets.h
/// From surfaces to the plane of a picture: a parallel projection, and what hides what. The faces: small quadrangles, lit, cut along
/// isophotes and painted from back to front.

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

typedef Traits_3<Simple_cartesian<double>> Svg_traits;

inline Svg_point svg_point(const Svg_traits::Point& p) { return svg_vector({p.x(), p.y(), p.z()}); }

// A quadrangle, its corners in turn.
struct Svg_facet {
  std::array<Svg_pixel, 4> corner;
  std::array<double, 4> depth; // in pixels, greater where it is nearer
  std::array<double, 4> angle; // of the normal and the light, from 0 to 1
  double shade = 0;            // from 0 for dark to 1 for bright
  double twist = 0;            // how far in depth it is from flat
  bool partly_hidden = false;

  double nearness() const { return 0.25 * (depth[0] + depth[1] + depth[2] + depth[3]); }

  // The part number i, j of n times n.
  Svg_facet part(int i, int j, int n) const {
    Svg_facet result = *this;
    for (int k = 0; k < 4; ++k) {
      const double x = (i + (k == 1 || k == 2)) / double(n), y = (j + (k >= 2)) / double(n);
      const double weight[] = {(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y};
      result.corner[k] = Svg_pixel(2);
      result.depth[k] = result.angle[k] = 0;
      for (int l = 0; l < 4; ++l) {
        result.corner[k] += weight[l] * corner[l];
        result.depth[k] += weight[l] * depth[l];
        result.angle[k] += weight[l] * angle[l];
      }
    }
    return result;
  }

  // The part where the angle is between two.
  std::vector<Svg_pixel> between(double low, double high) const {
    std::vector<std::pair<Svg_pixel, double>> polygon;
    for (int i = 0; i < 4; ++i) polygon.emplace_back(corner[i], angle[i]);
    for (int sign : {1, -1}) {
      const double limit = sign > 0 ? low : high;
      std::vector<std::pair<Svg_pixel, double>> cut;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double x = sign * (a.second - limit), y = sign * (b.second - limit);
        if (x >= 0) cut.push_back(a);
        if ((x < 0 && y > 0) || (x > 0 && y < 0)) cut.emplace_back(a.first + x / (x - y) * (b.first - a.first), limit);
      }
      polygon = std::move(cut);
    }
    std::vector<Svg_pixel> result;
    for (const auto& p : polygon) result.push_back(p.first);
    return result;
  }
};

class Svg_facets {
  struct Vertex {
    Svg_point point, normal;
  };
  enum Visibility { hidden, partly_visible, visible };

  static constexpr double cell = 15; // pixels
  static constexpr int most_cells = 24, bands = 14, shades = 96, parts = 4;
  static constexpr double pi = 3.14159265358979323846;

  const Svg_camera& camera_;
  Svg_point light_;
  std::vector<Svg_facet> facets_;

public:
  explicit Svg_facets(const Svg_camera& camera) : camera_(camera), light_(camera.direction(-0.55, 0.75, 0.6)) {}

  template <class Patch> void add(const Patch& s) {
    const int m = cells(s, Parameter_line::along_u), n = cells(s, Parameter_line::along_v);
    std::vector<Vertex> vertices;
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j) vertices.push_back(vertex(s, i / double(m), j / double(n)));
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j)
        add_facet({&vertices[i * (n + 1) + j], &vertices[(i + 1) * (n + 1) + j], &vertices[(i + 1) * (n + 1) + j + 1],
                   &vertices[i * (n + 1) + j + 1]});
  }

  // What is nearest. Facets of which no pixel is seen are removed, others that are partly hidden are split.
  Svg_depth_buffer remove_hidden(double width, double height) {
    Svg_depth_buffer buffer(width, height);
    for (const Svg_facet& f : facets_)
      scan(buffer, f, [](double& nearest, double depth) { nearest = (std::max)(nearest, depth); });
    std::vector<Svg_facet> seen;
    for (const Svg_facet& f : facets_) {
      const Visibility v = visibility(buffer, f);
      if (v == visible) seen.push_back(f);
      if (v != partly_visible) continue;
      for (int i = 0; i < parts; ++i)
        for (int j = 0; j < parts; ++j) {
          Svg_facet piece = f.part(i, j, parts);
          const Visibility w = visibility(buffer, piece);
          piece.partly_hidden = w == partly_visible;
          if (w != hidden) seen.push_back(piece);
        }
    }
    facets_.swap(seen);
    return buffer;
  }

  // What is partly hidden from back to front, and then all else by its colour.
  std::string paint(Svg_shading shading) {
    const auto first_whole =
        std::stable_partition(facets_.begin(), facets_.end(), [](const Svg_facet& f) { return f.partly_hidden; });
    std::stable_sort(facets_.begin(), first_whole,
                     [](const Svg_facet& a, const Svg_facet& b) { return a.nearness() < b.nearness(); });
    std::vector<std::pair<std::string, std::string>> paths; // colours and outlines
    std::map<std::string, std::string> whole;
    const auto add = [&](const Svg_facet& f, const std::string& colour, const std::vector<Svg_pixel>& polygon) {
      if (!f.partly_hidden)
        whole[colour] += svg_outline(polygon);
      else if (!paths.empty() && paths.back().first == colour)
        paths.back().second += svg_outline(polygon);
      else
        paths.emplace_back(colour, svg_outline(polygon));
    };
    for (const Svg_facet& f : facets_) {
      const std::vector<Svg_pixel> all(f.corner.begin(), f.corner.end());
      if (shading == Svg_shading::smooth) {
        add(f, shaded(f.shade), all);
        continue;
      }
      const auto range = std::minmax_element(f.angle.begin(), f.angle.end());
      const int first = band(*range.first), last = band(*range.second);
      for (int b = first; b <= last; ++b)
        add(f, strip(b), first == last ? all : f.between(b / double(bands), (b + 1) / double(bands)));
    }
    paths.insert(paths.end(), whole.begin(), whole.end());
    std::string svg = "<g transform=\"scale(.1)\" stroke-width=\"6\" fill=\"currentColor\" stroke=\"currentColor\">\n";
    for (const auto& path : paths)
      if (!path.second.empty()) svg += "<path color=\"" + path.first + "\" d=\"" + path.second + "\"/>\n";
    return svg + "</g>\n";
  }

  // All that is in one strip has one angle, and hence one brightness.
  static std::string strip(int band) {
    const double x = 0.5 + 0.5 * std::cos((band + 0.5) / bands * pi);
    return band % 2 == 0 ? svg_mix({128, 138, 152}, {255, 255, 252}, x) : svg_mix({14, 32, 60}, {92, 148, 200}, x);
  }
  static std::string shaded(double shade) {
    return svg_mix({38, 58, 84}, {236, 242, 248}, std::round(shade * shades) / shades);
  }

private:
  static int band(double angle) { return (std::min)(bands - 1, static_cast<int>(angle * bands)); }

  // Enough that a cell has the size of a few pixels.
  template <class Patch> int cells(const Patch& s, Parameter_line line) const {
    const bool along_u = line == Parameter_line::along_u;
    double most = 0;
    const int p = along_u ? s.degree_u() : s.degree_v(), q = along_u ? s.degree_v() : s.degree_u();
    for (int j = 0; j <= q; ++j) {
      double length = 0;
      for (int i = 0; i < p; ++i) {
        const auto &a = along_u ? s.control_point(i, j) : s.control_point(j, i),
                   &b = along_u ? s.control_point(i + 1, j) : s.control_point(j, i + 1);
        length += svg_length(Svg_pixel(camera_(svg_point(b)) - camera_(svg_point(a))));
      }
      most = (std::max)(most, length);
    }
    return (std::max)(3, (std::min)(most_cells, static_cast<int>(std::ceil(most / cell))));
  }

  // Where the normal vanishes, that of a point nearby is taken.
  template <class Patch> static Vertex vertex(const Patch& s, double u, double v) {
    const Surface_jet<Svg_traits> jet = s.jet(u, v, 1);
    Svg_point n = svg_unit(cross_product(jet(1, 0), jet(0, 1)));
    if (!(svg_length(cross_product(jet(1, 0), jet(0, 1))) > 1e-9)) {
      const Surface_jet<Svg_traits> near = s.jet(u + 1e-3 * (0.5 - u), v + 1e-3 * (0.5 - v), 1);
      n = svg_unit(cross_product(near(1, 0), near(0, 1)));
    }
    return {jet(0, 0), n};
  }

  void add_facet(const std::array<const Vertex*, 4>& v) {
    Svg_facet f;
    Svg_point sum(3);
    for (const Vertex* x : v) sum += x->normal;
    const double side = dot(sum, camera_.toward()) < 0 ? -1 : 1; // both sides are lit
    for (int i = 0; i < 4; ++i) {
      const double cosine = (std::max)(-1.0, (std::min)(1.0, side * dot(v[i]->normal, light_)));
      f.corner[i] = camera_(v[i]->point);
      f.depth[i] = camera_.depth(v[i]->point);
      f.angle[i] = std::acos(cosine) / pi;
      f.shade += 0.25 * (0.5 + 0.5 * cosine);
    }
    f.twist = std::abs(f.depth[0] - f.depth[1] + f.depth[2] - f.depth[3]);
    facets_.push_back(f);
  }

  template <class Function> static void scan(Svg_depth_buffer& buffer, const Svg_facet& f, Function function) {
    buffer.scan({f.corner[0], f.corner[1], f.corner[2]}, {f.depth[0], f.depth[1], f.depth[2]}, function);
    buffer.scan({f.corner[0], f.corner[2], f.corner[3]}, {f.depth[0], f.depth[2], f.depth[3]}, function);
  }

  static Visibility visibility(Svg_depth_buffer& buffer, const Svg_facet& f) {
    const auto range = std::minmax_element(f.depth.begin(), f.depth.end());
    const double slack = 2 + f.twist + 0.5 * (*range.second - *range.first);
    int before = 0, behind = 0;
    scan(buffer, f, [&](double nearest, double depth) { ++(depth >= nearest - slack ? before : behind); });
    if (before + behind == 0) return f.nearness() >= buffer.around(f.corner[0]) - 2 * slack ? visible : hidden;
    return behind == 0 ? visible : before == 0 ? hidden : partly_visible;
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACETS_H
