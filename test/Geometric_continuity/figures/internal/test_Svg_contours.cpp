// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Contours on grids, regions of what is nearest, and what is seen of a sphere: compared with
// circles.

#include "support/test.h"

#include <Geometric_continuity_figures/internal/Svg_facets.h>

BOOST_AUTO_TEST_SUITE(Svg_contours)

using GC::internal::grid_contours;
using GC::internal::Grid_line;
using GC::internal::Svg_pixel;
using GC::internal::Svg_raster;
using GC::internal::svg_simplified;
using GC::internal::svg_vector;

namespace {

// The points of an outline in tenths of a pixel, in pixels: "Mx yldx dy ...z" for each line.
std::vector<std::vector<Svg_pixel>> outlines(std::string path) {
  std::vector<std::vector<Svg_pixel>> result;
  std::string spaced;
  for (char c : path) spaced += c == 'M' ? "M " : c == 'l' || c == 'z' ? " " : c == '-' ? " -" : std::string(1, c);
  std::istringstream is(spaced);
  Svg_pixel p(2);
  for (std::string word; is >> word;) {
    double x, y;
    if (word == "M") {
      is >> x >> y;
      result.emplace_back();
      p = svg_vector({0.1 * x, 0.1 * y});
    } else {
      x = std::stod(word);
      is >> y;
      p += svg_vector({0.1 * x, 0.1 * y});
    }
    result.back().push_back(p);
  }
  return result;
}

// How far points, and the middles of the chords between them, are from a circle.
double distance_from_circle(const std::vector<Svg_pixel>& points, const Svg_pixel& centre, double radius) {
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Svg_pixel middle = 0.5 * points[i] + 0.5 * points[(i + 1) % points.size()];
    for (const Svg_pixel& p : {points[i], middle})
      most = (std::max)(most, std::abs(GC::internal::svg_length(Svg_pixel(p - centre)) - radius));
  }
  return most;
}

} // namespace

BOOST_AUTO_TEST_CASE(lines_through_grids) {
  // nodes that touch at a corner, and are joined, a hole, and lines that end at the border
  const std::vector<std::string> grid = {".......#", ".###...#", ".#.#....", ".###....", "....#...", "......##"};
  const auto is_inside = [&](std::size_t k) { return grid[k / 8][k % 8] == '#'; };
  std::vector<std::size_t> cells;
  for (std::size_t k = 0; k < 5 * 8; ++k)
    if (k % 8 < 7) cells.push_back(k);
  const std::vector<Grid_line> lines = grid_contours(8, cells, is_inside);
  std::size_t closed = 0, crossings = 0;
  for (const Grid_line& line : lines) {
    closed += line.closed;
    crossings += line.crossings.size();
    for (const auto& c : line.crossings) {
      BOOST_CHECK(is_inside(c.first) != is_inside(c.second));
      BOOST_CHECK(c.second == c.first + 1 || c.second == c.first + 8);
    }
  }
  BOOST_CHECK_EQUAL(lines.size(), 4);
  BOOST_CHECK_EQUAL(closed, 2);
  BOOST_CHECK_EQUAL(crossings, 12 + 4 + 4 + 3 + 3);
  BOOST_CHECK(grid_contours(8, cells, [](std::size_t) { return true; }).empty());
}

BOOST_AUTO_TEST_CASE(lines_with_fewer_points) {
  std::vector<Svg_pixel> corner;
  for (int i = 0; i <= 20; ++i) corner.push_back(svg_vector({double(i), i < 10 ? 0.01 * (i % 2) : 2.0 * (i - 10)}));
  const std::vector<double> tolerances(corner.size(), 0.05);
  const std::vector<Svg_pixel> open = svg_simplified(corner, tolerances, false);
  BOOST_CHECK_EQUAL(open.size(), 3); // a kink stays
  BOOST_CHECK(open[1] == corner[10]);
  BOOST_CHECK_EQUAL(svg_simplified(corner, tolerances, true).size(), 3);
  BOOST_CHECK_EQUAL(svg_simplified(corner, std::vector<double>(corner.size(), 1e-4), false).size(), 12);
  BOOST_CHECK_EQUAL(svg_simplified({corner[0], corner[0], corner[0]}, {1, 1, 1}, true).size(), 1);
}

// A cone seen from above, of triangles that are thin sectors: its levels are circles within a tenth
// of a pixel, also where another triangle hides a part.
BOOST_AUTO_TEST_CASE(regions) {
  const Svg_pixel centre = svg_vector({50.0, 40.0});
  const double pi = 3.14159265358979323846, radius = 35;
  Svg_raster raster(100, 80);
  const int n = 200;
  for (int i = 0; i < n; ++i) {
    const auto rim = [&](int k) {
      const double a = 2 * pi * k / n;
      return GC::internal::Svg_corner{centre + radius * svg_vector({std::cos(a), std::sin(a)}), 0, 0};
    };
    raster.add({centre, 10, 1}, rim(i), rim(i + 1));
  }
  raster.close_cracks();
  for (int k : {1, 2, 4}) {
    const double level = k / 5.0;
    const auto circle = outlines(raster.regions(5, 0.5)[static_cast<std::size_t>(k)]);
    BOOST_REQUIRE_EQUAL(circle.size(), 1);
    BOOST_CHECK_LT(distance_from_circle(circle[0], centre, (1 - level) * radius), 0.2);
    BOOST_CHECK_LT(circle[0].size(), 80);
  }
  const auto all = outlines(raster.regions(1, 0.5)[0]);
  BOOST_REQUIRE_EQUAL(all.size(), 1);
  BOOST_CHECK_LT(distance_from_circle(all[0], centre, radius), 0.7);
  // hidden on the right
  raster.add({svg_vector({50.0, 0.0}), 20, 0}, {svg_vector({200.0, -100.0}), 20, 0},
             {svg_vector({50.0, 400.0}), 20, 0});
  for (const auto& half : outlines(raster.regions(2, 0.2)[1]))
    for (const Svg_pixel& p : half) BOOST_CHECK_LT(p[0], 50.3);
  BOOST_CHECK_EQUAL(raster.depth_around(svg_vector({70.0, 40.0})), 20);
  BOOST_CHECK_LT(raster.depth_around(svg_vector({-5.0, 40.0})), -1e300);
}

// An ellipsoid in one patch that is none: a bump. Its silhouette is where the normal is orthogonal
// to the view.
BOOST_AUTO_TEST_CASE(silhouettes) {
  typedef GC::internal::Svg_traits::Point Q;
  const GC::Bezier_patch<GC::internal::Svg_traits> bump{{Q(-1, -1, 0), Q(-1, 0, 0), Q(-1, 1, 0)},
                                                        {Q(0, -1, 0), Q(0, 0, 6), Q(0, 1, 0)},
                                                        {Q(1, -1, 0), Q(1, 0, 0), Q(1, 1, 0)}};
  GC::internal::Svg_camera camera(-90, 20);
  const double height =
      camera.fit({svg_vector({-1.0, -1.0, 0.0}), svg_vector({1.0, 1.0, 0.0}), svg_vector({0.0, 0.0, 1.5})}, 200, 8);
  GC::internal::Svg_facets facets(camera, 200, height, 0, GC::Svg_shading::isophotes);
  facets.add(bump);
  BOOST_CHECK(!facets.paint().empty());
  BOOST_REQUIRE_GE(facets.silhouettes().size(), 1);
  std::size_t points = 0;
  for (const auto& line : facets.silhouettes())
    for (const auto& p : line) {
      // x = 2u - 1, y = 2v - 1, z = 24 u (1 - u) v (1 - v)
      const double u = 0.5 * (p[0] + 1), v = 0.5 * (p[1] + 1), z_u = 24 * (1 - 2 * u) * v * (1 - v),
                   z_v = 24 * u * (1 - u) * (1 - 2 * v);
      BOOST_CHECK_SMALL(dot(svg_vector({-0.5 * z_u, -0.5 * z_v, 1.0}), camera.toward()), 1e-3);
      ++points;
    }
  BOOST_CHECK_GT(points, 20);
  BOOST_CHECK(facets.sees(svg_vector({0.0, 0.0, 1.5})));
  BOOST_CHECK(facets.sees(svg_vector({0.0, -1.0, 0.0})));
  BOOST_CHECK(!facets.sees(svg_vector({0.0, 0.9, 0.25 * 6 * 0.19}))); // behind the bump
}

// The surface z = f(x) + y^2 / 2 of two patches with f = 0 for x < 0, and x^2 / 2 or x^3 / 2 behind
// the edge: G1 or G2 there. Where an outline of a strip crosses the edge, it turns by a large angle
// or by none.
BOOST_AUTO_TEST_CASE(isophotes_at_an_edge) {
  typedef GC::internal::Svg_traits::Point Q;
  typedef GC::Bezier_patch<GC::internal::Svg_traits> Patch;
  const auto largest_turn = [](int power) {
    // cubic in x, quadratic in y, both on [-1, 1]
    const auto patch = [](double x, const std::array<double, 4>& f) {
      std::vector<std::vector<Q>> net;
      for (int i = 0; i < 4; ++i) {
        net.emplace_back();
        for (int j = 0; j < 3; ++j)
          net.back().emplace_back(x + i / 3.0, j - 1, f[static_cast<std::size_t>(i)] + (j == 1 ? -0.5 : 0.5));
      }
      return Patch(net);
    };
    GC::internal::Svg_camera camera(-100, 50);
    std::vector<GC::internal::Svg_point> corners;
    for (double x : {-1.0, 1.0})
      for (double y : {-1.0, 1.0}) corners.push_back(svg_vector({x, y, x > 0 ? 1 : 0.5}));
    const double height = camera.fit(corners, 500, 20);
    GC::internal::Svg_facets facets(camera, 500, height, -1, GC::Svg_shading::isophotes);
    facets.add(patch(-1, {0, 0, 0, 0}));
    facets.add(power == 2 ? patch(0, {0, 0, 1 / 6.0, 0.5}) : patch(0, {0, 0, 0, 0.5}));
    const std::string svg = facets.paint();
    double most = 0;
    int crossings = 0;
    for (std::size_t begin = svg.find("d=\""); begin != std::string::npos; begin = svg.find("d=\"", begin + 1)) {
      const std::string path = svg.substr(begin + 3, svg.find('"', begin + 3) - begin - 3);
      for (const auto& line : outlines(path))
        for (std::size_t i = 0; i < line.size(); ++i) {
          const auto away = [&](std::size_t step) { // the next point that is 5 pixels away
            std::size_t j = i;
            for (std::size_t n = 0; n < line.size() && GC::internal::svg_length(Svg_pixel(line[j] - line[i])) < 5; ++n)
              j = (j + step) % line.size();
            return line[j];
          };
          const Svg_pixel d = line[i] - away(line.size() - 1), e = away(1) - line[i];
          double distance = 1e9; // from the edge, but for its ends
          for (double y = -0.95; y < 0.95; y += 4e-3)
            distance = (std::min)(
                distance, GC::internal::svg_length(Svg_pixel(camera(svg_vector({0.0, y, 0.5 * y * y})) - line[i])));
          if (distance > 1.5) continue;
          most = (std::max)(most, std::abs(std::atan2(d[0] * e[1] - d[1] * e[0], dot(d, e))));
          ++crossings;
        }
    }
    BOOST_TEST_MESSAGE("power " << power << ": " << crossings << " points, at most " << most);
    return most;
  };
  BOOST_CHECK_GT(largest_turn(2), 0.4);
  BOOST_CHECK_LT(largest_turn(3), 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
