// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_SVG_SURFACES_H
#define GEOMETRIC_CONTINUITY_FIGURES_SVG_SURFACES_H

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <Geometric_continuity_figures/Svg_panel.h>
#include <Geometric_continuity_figures/internal/Svg_facets.h>
#include <Geometric_continuity_figures/internal/svg_text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file svg_surfaces.h
/// Pictures of surfaces: faces, edges and knot lines by their order of continuity, a shadow and a
/// legend.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The lines of a picture by what they are.
enum Svg_edge { svg_edge_g2, svg_edge_g1, svg_edge_vanishing, svg_edge_g0, svg_edge_boundary };
constexpr std::array<Stroke_style, 5> edge_stroke_styles = {
    {{"#2c9a5b", 0.9, ""}, {"#e69f00", 1.6, ""}, {"#b04a94", 1.8, "5 3"}, {"#e3211c", 3, ""}, {"#1b1b1b", 1.6, ""}}};
constexpr Stroke_style silhouette_stroke{"#1b1b1b", 0.9, ""};
constexpr std::array<const char*, 5> svg_edge_names = {"edge, G2", "edge, G1", "edge, G1 but where a normal vanishes",
                                                       "edge, only G0: a crease", "boundary"};

// `Surface` is `Bspline_surface<Svg_traits>`, or the rational one.
template <class Surface> class Svg_surface_picture {
  typedef std::decay_t<decltype(std::declval<const Surface&>().bezier_patches().front())> Svg_patch;
  static constexpr bool rational = std::is_same_v<Surface, Rational_bspline_surface<Svg_traits>>;
  static constexpr double edge = 24; // pixels

  std::vector<Surface> surfaces_; // normalised
  std::vector<std::pair<Svg_edge, std::vector<Svg_point>>> lines_;
  Svg_surface_style style_;

public:
  template <class SurfaceRange>
  Svg_surface_picture(const SurfaceRange& surfaces, const Svg_surface_style& style) : style_(style) {
    check_finite(style.azimuth, "svg_surfaces: azimuth");
    check_finite(style.elevation, "svg_surfaces: elevation");
    check_finite(style.width, "svg_surfaces: width");
    if (!(100 <= style.width)) throw Error(Error_code::empty_domain, "svg_surfaces: less than 100 pixels");
    Svg_box<3> box;
    for_each_numbered(surfaces, [&](const auto& s) {
      std::size_t k = 0;
      for (const auto& p : s) {
        const Svg_point x = in_doubles<std::decay_t<decltype(s)>>(p);
        if (!is_infinite(s, k++)) box.add(x);
      }
    });
    for_each_numbered(surfaces, [&](const auto& s) { surfaces_.push_back(normalised(s, box)); });
    const auto model = model_continuity(surfaces);
    for (const auto& e : model.edges)
      if (e.kind != Model_edge_kind::collapsed) {
        const auto c = boundary_curve(surfaces_[e.patch_a], e.edge_a);
        add_line(e.kind == Model_edge_kind::boundary ? svg_edge_boundary : kind(e.continuity), c.domain(), c);
      }
    for (const auto& l : model.knot_lines) {
      const Surface& s = surfaces_[l.patch];
      const double t = CGAL::to_double(l.line.knot);
      const bool u = l.line.constant_u;
      add_line(kind(l.line.continuity), u ? s.domain_v() : s.domain_u(),
               [&](double x) { return u ? s(t, x) : s(x, t); });
    }
  }

  std::string operator()() const {
    std::vector<Svg_patch> patches;
    std::vector<Svg_point> points;
    for (const Surface& s : surfaces_)
      for (const Svg_patch& patch : s.bezier_patches()) {
        patches.push_back(patch.with_domain({0, 1}, {0, 1}));
        for (int i = 0; i <= 8; ++i)
          for (int j = 0; j <= 8; ++j) points.push_back(svg_point(patches.back()(i / 8.0, j / 8.0)));
      }
    double low = 0;
    for (const Svg_point& p : points) low = (std::min)(low, p[2]);
    const std::vector<Svg_point> seen = points;
    for (const Svg_point& p : seen) points.push_back(svg_vector({p[0], p[1], low}));
    Svg_camera camera(style_.azimuth, style_.elevation);
    const double height = camera.fit(points, style_.width, 16);
    Svg_facets facets(camera, style_.width, height, low, style_.shading);
    for (const Svg_patch& patch : patches) facets.add(patch);

    double y = edge;
    const std::string title = svg_title(style_.title, edge, style_.width + 2 * edge, y);
    std::string picture = "<g transform=\"translate(" + svg_number(edge) + ' ' + svg_number(y) + ")\">\n" +
                          facets.paint() + lines(camera, facets) + "</g>\n";
    y += height + 12;
    const std::string names = legend(y);
    y += edge - 8;
    return svg_document(style_.title, style_.width + 2 * edge, y, title + picture + names);
  }

private:
  // Calls f(surface); an error names the surface.
  template <class SurfaceRange, class Function>
  static void for_each_numbered(const SurfaceRange& surfaces, Function f) {
    std::size_t number = 0;
    for (const auto& s : surfaces) {
      try {
        f(s);
      } catch (const Error& error) {
        const std::string reason = error.code() == Error_code::dimension_mismatch ? "it is not in dimension 3"
                                   : error.code() == Error_code::not_finite       ? "a number is too large"
                                                                                  : "knots become equal by rounding";
        throw Error(error.code(), "svg_surfaces: surface " + std::to_string(number) + " cannot be drawn: " + reason);
      }
      ++number;
    }
  }

  template <class Source, class Point> static Svg_point in_doubles(const Point& point) {
    const auto x = Geometric_continuity::coordinates<typename Source::Traits>(point);
    if (x.dimension() != 3) throw Error(Error_code::dimension_mismatch, "svg_surfaces");
    Svg_point y(3);
    for (int i = 0; i < 3; ++i) check_finite(y[i] = CGAL::to_double(x[i]), "svg_surfaces");
    return y;
  }

  // Returns whether the control point number k has the weight 0, so that it is a direction.
  template <class Given> static bool is_infinite(const Given& s, std::size_t k) {
    if constexpr (rational)
      return s.weights()[k] == typename Given::FT(0);
    else
      return false;
  }

  template <class Traits> static Surface normalised(const Bezier_patch<Traits>& patch, const Svg_box<3>& box) {
    return normalised(Bspline_surface<Traits>(patch), box);
  }
  template <class Traits> static Surface normalised(const Rational_bezier_patch<Traits>& patch, const Svg_box<3>& box) {
    return normalised(Rational_bspline_surface<Traits>(patch), box);
  }
  template <class Given> static Surface normalised(const Given& s, const Svg_box<3>& box) {
    const double radius = (std::max)({box.radius(0), box.radius(1), box.radius(2)});
    typedef Coordinate_vector<double, rational ? 4 : 3> Row;
    std::vector<std::vector<Row>> net(s.number_of_points_u());
    std::size_t k = 0;
    for (int i = 0; i < s.number_of_points_u(); ++i)
      for (int j = 0; j < s.number_of_points_v(); ++j, ++k) {
        const Svg_point x = in_doubles<Given>(s.control_point(i, j)), p = is_infinite(s, k) ? x : x - box.centre(),
                        q = radius > 0 ? p / radius : Svg_point(3);
        if constexpr (rational)
          net[i].push_back(homogeneous_point(q, CGAL::to_double(s.weight(i, j))));
        else
          net[i].push_back(q);
      }
    const auto knots = [](const Knot_vector<typename Given::FT>& exact) {
      std::vector<double> numbers;
      for (const auto& x : exact) numbers.push_back(CGAL::to_double(x));
      return Knot_vector<double>(exact.degree(), std::move(numbers));
    };
    if constexpr (rational)
      return Surface(typename Surface::Homogeneous(net, knots(s.knots_u()), knots(s.knots_v())));
    else {
      std::vector<std::vector<Svg_traits::Point>> points;
      for (const std::vector<Row>& row : net) {
        points.emplace_back();
        for (const Row& q : row) points.back().emplace_back(q[0], q[1], q[2]);
      }
      return Surface(points, knots(s.knots_u()), knots(s.knots_v()));
    }
  }

  template <class Continuity> static Svg_edge kind(const Continuity& c) {
    if (c.g_order >= 1) return c.g_order == 1 ? svg_edge_g1 : svg_edge_g2;
    return c.defect == Edge_defect::vanishing_normal ? svg_edge_vanishing : svg_edge_g0;
  }

  template <class Curve> void add_line(Svg_edge kind, const std::pair<double, double>& domain, const Curve& curve) {
    constexpr int pieces = 360;
    std::vector<Svg_point> points;
    for (int i = 0; i <= pieces; ++i)
      points.push_back(
          svg_point(curve(i == pieces ? domain.second : domain.first + i * (domain.second - domain.first) / pieces)));
    lines_.emplace_back(kind, std::move(points));
  }

  // The silhouettes and the lines, where they are not hidden; the more important ones above the
  // others.
  std::string lines(const Svg_camera& camera, const Svg_facets& facets) const {
    std::string silhouettes;
    for (const std::vector<Svg_point>& line : facets.silhouettes()) silhouettes += seen_parts(line, camera, facets);
    std::string svg = svg_stroke(silhouette_stroke, silhouettes);
    for (const Svg_edge kind : {svg_edge_g2, svg_edge_g1, svg_edge_boundary, svg_edge_vanishing, svg_edge_g0}) {
      std::string path;
      for (const auto& line : lines_)
        if (line.first == kind) path += seen_parts(line.second, camera, facets);
      svg += svg_stroke(edge_stroke_styles[kind], path);
    }
    return svg;
  }

  // They end where what hides them begins, to a tenth of a pixel.
  static std::string seen_parts(const std::vector<Svg_point>& line, const Svg_camera& camera,
                                const Svg_facets& facets) {
    std::string path;
    std::vector<Svg_pixel> run;
    const auto end_of_part = [&](Svg_point seen, Svg_point hidden) {
      for (int k = 0; k < 8; ++k) {
        const Svg_point middle = 0.5 * seen + 0.5 * hidden;
        (facets.sees(middle) ? seen : hidden) = middle;
      }
      run.push_back(camera(seen));
    };
    const auto end_run = [&] {
      if (run.size() > 1) path += svg_polyline(svg_simplified(run, std::vector<double>(run.size(), 0.08), false));
      run.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool seen = facets.sees(line[i]);
      if (i > 0 && seen && run.empty()) end_of_part(line[i], line[i - 1]);
      if (seen) run.push_back(camera(line[i]));
      if (!seen && !run.empty()) {
        end_of_part(line[i - 1], line[i]);
        end_run();
      }
    }
    end_run();
    return path;
  }

  std::string legend(double& y) const {
    Svg_legend items;
    if (style_.shading == Svg_shading::isophotes)
      items.add("isophotes: kinked where only G1, broken where only G0",
                "<path fill=\"" + Svg_facets::strip(5) + "\" d=\"M0 -6H9V6H0ZM18 -6H26V6H18Z\"/>\n<path fill=\"" +
                    Svg_facets::strip(4) + "\" d=\"M9 -6H18V6H9Z\"/>\n");
    for (std::size_t k = 0; k < edge_stroke_styles.size(); ++k)
      if (std::any_of(lines_.begin(), lines_.end(),
                      [&](const auto& line) { return line.first == static_cast<Svg_edge>(k); }))
        items.add(svg_edge_names[k], svg_stroke(edge_stroke_styles[k], "M0 0L26 0"));
    return items.lines(style_.width + 2 * edge, edge, y);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Draws surfaces as an SVG document in UTF-8: in a parallel projection with hidden parts removed,
/// painted between contours of the exact normal field, with silhouettes and their shadow on the
/// ground. Common edges, and the knot lines inside B-spline surfaces, are coloured by their order,
/// which `model_continuity()` decides exactly; then everything is rounded to `double` for the
/// drawing. Both sides of a surface are lit.
///
/// \tparam SurfaceRange a forward range of `Bezier_patch`, of `Bspline_surface`, or of the rational
///   ones
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite` for coordinates beyond
///   the range of `double` and for angles of the view and a width that are infinite or not a
///   number, `empty_domain` for a width below 100
template <class SurfaceRange>
void write_svg_surfaces(std::ostream& os, const SurfaceRange& surfaces,
                        const Svg_surface_style& style = Svg_surface_style()) {
  typedef std::decay_t<decltype(*std::begin(surfaces))> Given;
  typedef internal::Svg_traits Traits;
  typedef std::conditional_t<internal::Is_rational<Given>::value, Rational_bspline_surface<Traits>,
                             Bspline_surface<Traits>>
      Surface;
  const std::string document = internal::Svg_surface_picture<Surface>(surfaces, style)();
  os.write(document.data(), static_cast<std::streamsize>(document.size()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_SVG_SURFACES_H
