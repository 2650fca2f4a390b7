// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACETS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_FACETS_H

#include <CGAL/Geometric_continuity/IO/figures/Svg_surface_style.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_camera.h>
#include <CGAL/Geometric_continuity/IO/figures/internal/svg_markup.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// \file Svg_facets.h
/// The faces of a picture of surfaces: small quadrangles, lit, cut along isophotes and painted from back to front.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

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
