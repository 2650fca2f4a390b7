// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Grids of points and normals: the same numbers as one by one.

#include "support/random_points.h"

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>

template <class FT> void check_grid(int p, int q) {
  std::vector<std::vector<Point<FT>>> net;
  for (int i = 0; i <= p; ++i) net.push_back(points<FT>(q + 1));
  const GC::Bezier_patch<Traits<FT>> patch(net, {FT(-1), FT(1)}, {FT(2), FT(5)});
  std::vector<FT> u, v;
  for (int i = 0; i < 5; ++i) u.push_back(number<FT>());
  for (int i = 0; i < 9; ++i) v.push_back(FT(FT(3) + number<FT>()));
  GC::Surface_grid<FT> grid;
  GC::evaluate_grid<GC::Grid_normals::unnormalised, CGAL::Parallel_if_available_tag>(patch, u, v, grid);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const Point<FT> x = patch(u[i], v[j]);
      const auto normal = patch.normal(u[i], v[j]);
      for (int k = 0; k < 3; ++k) {
        BOOST_CHECK(same(grid.points(k)[i * v.size() + j], x[k], 1));
        BOOST_CHECK(same(grid.normals(k)[i * v.size() + j], normal[k], 8 * (p + 1) * (q + 1)));
      }
    }
}

BOOST_AUTO_TEST_CASE(grids) {
  for (int p : {0, 1, 3, 6})
    for (int q : {0, 1, 2, 4, 7}) {
      check_grid<double>(p, q);
      check_grid<Exact>(p, q);
    }
}

BOOST_AUTO_TEST_CASE(unit_normals) {
  // a cone: the normal vanishes at its apex, v = 0
  const GC::Bezier_patch<Traits<double>> cone{{{0, 0, 0}, {1, 0, 1}}, {{0, 0, 0}, {0, 1, 1}}};
  const std::vector<double> u{0, 0.25, 1}, v{0, 0.5, 1};
  GC::Surface_grid<double> grid;
  GC::evaluate_grid(cone, u, v, grid);
  for (std::size_t l = 0; l < 9; ++l) {
    const double x = grid.normals(0)[l], y = grid.normals(1)[l], z = grid.normals(2)[l];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (l % 3 == 0)
      BOOST_CHECK_EQUAL(length, 0);
    else
      BOOST_CHECK_CLOSE_FRACTION(length, 1, 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(spline_grids) {
  const GC::Knot_vector<Exact> knots_u(2, {0, 0, 0, 1, 2, 2, 3, 3, 3}), knots_v(1, {0, 0, 2, 3, 3});
  std::vector<std::vector<Point<Exact>>> net;
  for (int i = 0; i < knots_u.number_of_coefficients(); ++i)
    net.push_back(points<Exact>(knots_v.number_of_coefficients()));
  const GC::Bspline_surface<Traits<Exact>> surface(net, knots_u, knots_v);
  const std::vector<Exact> u{0, Exact(1) / 3, 1, Exact(3) / 2, 2, Exact(5) / 2, 3}, v{0, 1, 2, Exact(8) / 3, 3};
  GC::Surface_grid<Exact> grid;
  GC::evaluate_grid<GC::Grid_normals::unnormalised>(surface, u, v, grid);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const auto normal = surface.normal(u[i], v[j]);
      for (int k = 0; k < 3; ++k) {
        BOOST_CHECK_EQUAL(grid.points(k)[i * v.size() + j], surface(u[i], v[j])[k]);
        BOOST_CHECK_EQUAL(grid.normals(k)[i * v.size() + j], normal[k]);
      }
    }
}
