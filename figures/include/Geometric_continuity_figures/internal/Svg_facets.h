// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_FACETS_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_FACETS_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_panel.h>
#include <Geometric_continuity_figures/internal/Svg_camera.h>
#include <Geometric_continuity_figures/internal/Svg_contours.h>
#include <Geometric_continuity_figures/internal/Svg_raster.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_facets.h
/// The faces of a picture of surfaces: facets with the normals of the surface at their corners, so
/// small that from one to the next the normal turns by a few degrees; what is seen of them, painted
/// between contours of the brightness; and the silhouettes.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

typedef Traits_3<Simple_cartesian<double>> Svg_traits;

inline Svg_point svg_point(const Svg_traits::Point& p) { return svg_vector({p.x(), p.y(), p.z()}); }

// The angle of two vectors with length 1, or of a zero vector: 0.
inline double svg_angle(const Svg_point& a, const Svg_point& b) {
  return 2 * std::asin((std::min)(1.0, 0.5 * svg_length(Svg_point(b - a))));
}

class Svg_facets {
  struct Vertex {
    Svg_point point, normal;
  };

  static constexpr double pi = 3.14159265358979323846;
  static constexpr double turn = 3 * pi / 180; // of the normal along a facet
  static constexpr int most_cells = 240, bands = 14, shades = 64;

  const Svg_camera& camera_;
  Svg_point light_;
  Svg_shading shading_;
  Svg_raster faces_, shadow_;
  double low_; // of the ground
  std::vector<std::vector<Svg_point>> silhouettes_;

public:
  Svg_facets(const Svg_camera& camera, double width, double height, double low, Svg_shading shading)
      : camera_(camera), light_(camera.direction(-0.55, 0.75, 0.6)), shading_(shading), faces_(width, height),
        shadow_(width, height), low_(low) {}

  template <class Patch> void add(const Patch& s) {
    const int m = cells(s, Parameter_line::along_u), n = cells(s, Parameter_line::along_v);
    std::vector<Vertex> vertices;
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= n; ++j) vertices.push_back(vertex(s, i / double(m), j / double(n)));
    const auto at = [&](int i, int j) -> const Vertex& { return vertices[static_cast<std::size_t>(i) * (n + 1) + j]; };
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < n; ++j) add_facet({&at(i, j), &at(i + 1, j), &at(i + 1, j + 1), &at(i, j + 1)});

    add_silhouettes(s, m, n, vertices);
  }

  // The shadow on the ground and what is seen, once all patches are there.
  std::string paint() {
    faces_.close_cracks();
    shadow_.close_cracks();
    const bool strips = shading_ == Svg_shading::isophotes;
    const int levels = strips ? bands : shades;
    std::string svg =
        "<g transform=\"scale(.1)\" fill-rule=\"evenodd\">\n" + filled("#e4e6e9", shadow_.regions(1, 1)[0]);
    int k = 0;
    for (const std::string& region : faces_.regions(levels, 0.15 / bands)) {
      svg += filled(strips ? strip(k) : shaded(k / double(levels - 1)), region);
      ++k;
    }
    return svg + "</g>\n";
  }

  // Where the surface turns away from the viewer.
  const std::vector<std::vector<Svg_point>>& silhouettes() const { return silhouettes_; }

  // Returns whether a point of the surface is seen.
  bool sees(const Svg_point& p) const {
    constexpr double slack = 3; // pixels
    return camera_.depth(p) >= faces_.depth_around(camera_(p)) - slack;
  }

  // All that is in one strip has one angle, and hence one brightness.
  static std::string strip(int band) {
    const double x = 0.5 + 0.5 * std::cos((band + 0.5) / bands * pi);
    return band % 2 == 0 ? svg_mix({128, 138, 152}, {255, 255, 252}, x) : svg_mix({14, 32, 60}, {92, 148, 200}, x);
  }

private:
  static std::string shaded(double shade) { return svg_mix({38, 58, 84}, {236, 242, 248}, shade); }

  static std::string filled(const std::string& colour, const std::string& path) {
    return path.empty() ? path : "<path fill=\"" + colour + "\" d=\"" + path + "\"/>\n";
  }

  // The lines in the grid of vertices where the normal turns from the viewer, each point found by
  // bisection between two vertices.
  template <class Patch> void add_silhouettes(const Patch& s, int m, int n, const std::vector<Vertex>& vertices) {
    const auto faces_viewer = [&](const Vertex& v) { return dot(v.normal, camera_.toward()) >= 0; };
    const std::size_t columns = static_cast<std::size_t>(n) + 1;
    const auto parameters = [&](std::size_t k) {
      return svg_vector({static_cast<double>(k / columns) / m, static_cast<double>(k % columns) / n});
    };
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k + columns + 1 < vertices.size(); ++k)
      if (k % columns + 1 < columns) cells.push_back(k);
    for (const Grid_line& line :
         grid_contours(n + 1, cells, [&](std::size_t k) { return faces_viewer(vertices[k]); })) {
      silhouettes_.emplace_back();
      for (const Grid_crossing& c : line.crossings) {
        Svg_pixel a = parameters(c.first), b = parameters(c.second);
        const bool side = faces_viewer(vertices[c.first]);
        for (int k = 0; k < 12; ++k) {
          const Svg_pixel middle = 0.5 * a + 0.5 * b;
          (faces_viewer(vertex(s, middle[0], middle[1])) == side ? a : b) = middle;
        }
        silhouettes_.back().push_back(vertex(s, a[0], a[1]).point);
      }
      if (line.closed) silhouettes_.back().push_back(silhouettes_.back().front());
    }
  }

  // Enough along a parameter line that normals and tangents turn little along each, and no more
  // than its control polygon has pixels.
  template <class Patch> int cells(const Patch& s, Parameter_line line) const {
    const bool along_u = line == Parameter_line::along_u;
    double pixels = 0;
    const int p = along_u ? s.degree_u() : s.degree_v(), q = along_u ? s.degree_v() : s.degree_u();
    for (int j = 0; j <= q; ++j) {
      double length = 0;
      for (int i = 0; i < p; ++i) {
        const auto &a = along_u ? s.control_point(i, j) : s.control_point(j, i),
                   &b = along_u ? s.control_point(i + 1, j) : s.control_point(j, i + 1);
        length += svg_length(Svg_pixel(camera_(svg_point(b)) - camera_(svg_point(a))));
      }
      pixels = (std::max)(pixels, length);
    }
    const int parts = (std::max)(2, (std::min)(12, static_cast<int>(pixels / 12))), lines = (std::min)(parts, 6);
    double most = 0; // turning along one part
    for (int j = 0; j <= lines; ++j) {
      Svg_point normal(3), tangent(3);
      for (int i = 0; i <= parts; ++i) {
        const double x = i / double(parts), y = j / double(lines);
        const Surface_jet<Svg_traits> jet = along_u ? s.jet(x, y, 1) : s.jet(y, x, 1);
        const Svg_point n = svg_unit(cross_product(jet(1, 0), jet(0, 1))),
                        t = svg_unit(along_u ? jet(1, 0) : jet(0, 1));
        if (i > 0) most = (std::max)({most, svg_angle(normal, n), svg_angle(tangent, t)});
        normal = n;
        tangent = t;
      }
    }
    return static_cast<int>((std::max)(2.0, (std::min)({std::ceil(parts * most / turn), pixels, double(most_cells)})));
  }

  // Where the normal vanishes, that of a point nearby is taken.
  template <class Patch> static Vertex vertex(const Patch& s, double u, double v) {
    const Surface_jet<Svg_traits> jet = s.jet(u, v, 1);
    Svg_point n = svg_unit(cross_product(jet(1, 0), jet(0, 1)));
    if (!(svg_length(cross_product(jet(1, 0), jet(0, 1))) > 1e-9)) {
      const Surface_jet<Svg_traits> inside = s.jet(u + 1e-3 * (0.5 - u), v + 1e-3 * (0.5 - v), 1);
      n = svg_unit(cross_product(inside(1, 0), inside(0, 1)));
    }
    return {jet(0, 0), n};
  }

  // The corners in turn. Both sides of a surface are lit.
  void add_facet(const std::array<const Vertex*, 4>& v) {
    Svg_point sum(3);
    for (const Vertex* x : v) sum += x->normal;
    const double side = dot(sum, camera_.toward()) < 0 ? -1 : 1;
    std::array<Svg_corner, 4> corners, below;
    for (std::size_t i = 0; i < 4; ++i) {
      const double cosine = (std::max)(-1.0, (std::min)(1.0, side * dot(v[i]->normal, light_)));
      const Svg_point& p = v[i]->point;
      corners[i] = {camera_(p), camera_.depth(p),
                    shading_ == Svg_shading::isophotes ? std::acos(cosine) / pi : 0.5 + 0.5 * cosine};
      below[i] = {camera_(svg_vector({p[0], p[1], low_})), 0, 0};
    }
    for (std::size_t i : {1, 2}) {
      faces_.add(corners[0], corners[i], corners[i + 1]);
      shadow_.add(below[0], below[i], below[i + 1]);
    }
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_FACETS_H
