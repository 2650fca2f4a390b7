// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Patches, B-spline surfaces, swept surfaces and grids refuse bad input with the reason.

#include "support/swept_surfaces.h"

#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>

typedef std::tuple<Double, Exact> All_traits;
using GC::Patch_edge;

constexpr int largest = (std::numeric_limits<int>::max)(), smallest = (std::numeric_limits<int>::min)();

// Degree 2 in u and 1 in v.
template <class Traits> GC::Bezier_patch<Traits> patch() {
  typedef typename Traits::Point P;
  return GC::Bezier_patch<Traits>{{P(0, 0, 0), P(0, 4, 1)}, {P(4, 0, 8), P(4, 4, 0)}, {P(8, 0, 0), P(8, 4, 2)}};
}

// The patch on the unit square with a knot 1/2 in u.
template <class Traits, class FT = typename Traits::FT> GC::Bspline_surface<Traits> surface() {
  return GC::Bspline_surface<Traits>(patch<Traits>()).insert_u(FT(FT(1) / FT(2)), 2);
}

TEST_FOR_EACH(counts_of_surfaces, Traits, All_traits) {
  const auto s = patch<Traits>();
  const auto t = surface<Traits>();
  const FT half = FT(FT(1) / FT(2));
  for (int negative : {-1, -2, smallest}) {
    CHECK_ERROR(s.elevate(negative, 0), negative_count);
    CHECK_ERROR(s.elevate(0, negative), negative_count);
    CHECK_ERROR(s.elevate(2, negative), negative_count);
    CHECK_ERROR(t.elevate(negative, 0), negative_count);
    CHECK_ERROR(t.elevate(0, negative), negative_count);
    CHECK_ERROR(t.insert_u(half, negative), negative_count);
    CHECK_ERROR(t.insert_v(half, negative), negative_count);
    for (Patch_edge edge : GC::patch_edges) {
      CHECK_ERROR(s.rows(edge, negative), negative_count);
      CHECK_ERROR(t.rows(edge, negative), negative_count);
    }
    CHECK_ERROR(t.rows_at(GC::Parameter_line::along_v, half, GC::Line_side::larger_parameters, negative),
                negative_count);
    CHECK_ERROR(s.partial(half, half, negative, 1), negative_count);
    CHECK_ERROR(s.partial(half, half, 2, negative), negative_count);
    CHECK_ERROR(t.partial(half, half, negative, 1), negative_count);
    CHECK_ERROR(t.partial(half, half, 2, negative), negative_count);
  }
  for (int huge : {4095, 1 << 20, largest}) {
    CHECK_ERROR(s.elevate(huge, 0), work_limit);
    CHECK_ERROR(t.elevate(huge, 0), work_limit);
    CHECK_ERROR(t.insert_u(half, huge), knot_multiplicity);
  }
  for (int huge : {4096, largest}) {
    CHECK_ERROR(s.elevate(0, huge), work_limit);
    CHECK_ERROR(t.elevate(0, huge), work_limit);
    CHECK_ERROR(t.insert_v(half, huge), knot_multiplicity);
  }
  BOOST_CHECK(s.elevate(0, 0) == s && t.elevate(0, 0) == t && t.insert_u(half, 0) == t);
  BOOST_CHECK(s.elevate(0, 1)(half, half) == s(half, half) && s.elevate(1, 0).degree_u() == 3);
  BOOST_CHECK(s.partial(half, half, 0, 0) == s(half, half) - CGAL::ORIGIN);
  for (const FT& outside : {FT(-1), FT(0), FT(1), FT(2)}) {
    CHECK_ERROR(t.split_u(outside), parameter_outside_domain);
    CHECK_ERROR(t.split_v(outside), parameter_outside_domain);
  }
}

TEST_FOR_EACH(nets_of_surfaces, Traits, All_traits) {
  typedef typename Traits::Point P;
  typedef GC::Bezier_patch<Traits> Patch;
  typedef std::vector<std::vector<P>> Net;
  const P o(0, 0, 0);
  for (const Net& net : {Net(), Net(1), Net(3), Net{{o, o}, {o}}, Net{{o}, {o, o}}})
    CHECK_ERROR(Patch(net), wrong_number_of_points);
  const GC::Knot_vector<FT> linear(1, FT(0), FT(1));
  typedef GC::Bspline_surface<Traits> Surface;
  for (const Net& net : {Net(), Net{{o, o}}, Net{{o}, {o}}, Net{{o, o}, {o}}, Net{{o, o}, {o, o}, {o, o}}})
    CHECK_ERROR(Surface(net, linear, linear), wrong_number_of_points);
  BOOST_CHECK_EQUAL(Surface(Net{{o, o}, {o, o}}, linear, linear).number_of_points_u(), 2);
  for (const auto& [p, q] : {std::pair{-1, 1}, std::pair{1, -1}, std::pair{1, 2}, std::pair{-1, -5}})
    CHECK_ERROR(Patch(p, q, std::vector<P>(4, o)), wrong_number_of_points);
  BOOST_CHECK(Patch(1, 1, std::vector<P>(4, o)) == Patch(Net{{o, o}, {o, o}}));
}

// Surfaces are equal when domains, degrees and control points are.
TEST_FOR_EACH(equal_surfaces, Traits, All_traits) {
  typedef typename Traits::Point P;
  const auto s = patch<Traits>();
  const std::pair<FT, FT> unit(FT(0), FT(1)), longer(FT(0), FT(2));
  BOOST_CHECK(s.with_domain(unit, unit) == s);
  BOOST_CHECK(s.with_domain(longer, unit) != s && s.with_domain(unit, longer) != s);
  BOOST_CHECK(s.elevate(1, 0) != s && s.elevate(0, 1) != s);
  BOOST_CHECK(s.transform([](const P& p) { return P(p.x(), p.y(), FT(p.z() + 1)); }) != s);
}

BOOST_AUTO_TEST_CASE(surfaces_of_numbers_that_are_not_finite) {
  typedef Double::Point P;
  typedef GC::Bezier_patch<Double> Patch;
  const GC::Knot_vector<double> linear(1, 0., 1.);
  for (double x : {infinity, -infinity, std::nan("")}) {
    const std::vector<std::vector<P>> net{{P(0, 0, 0), P(0, 1, 0)}, {P(1, 0, 0), P(1, 1, x)}};
    CHECK_ERROR(Patch(net), not_finite);
    CHECK_ERROR(GC::Bspline_surface<Double>(net, linear, linear), not_finite);
    const auto moved = [&](const P& p) { return P(p.x(), x, p.z()); };
    CHECK_ERROR(patch<Double>().transform(moved), not_finite);
    CHECK_ERROR(surface<Double>().transform(moved), not_finite);
    CHECK_ERROR(patch<Double>()(x, 0.5), not_finite);
    GC::Surface_grid<double> grid;
    GC::evaluate_grid(patch<Double>(), std::vector<double>{0, 1}, std::vector<double>{0.5}, grid);
    CHECK_ERROR(GC::evaluate_grid(patch<Double>(), std::vector<double>{0, x}, std::vector<double>{0, 1}, grid),
                not_finite);
    CHECK_ERROR(GC::evaluate_grid(surface<Double>(), std::vector<double>{0, 1}, std::vector<double>{x}, grid),
                not_finite);
    BOOST_CHECK(grid.size_u() == 2 && grid.size_v() == 1); // not changed
  }
}

// The length of a domain must be a number, too.
BOOST_AUTO_TEST_CASE(domains_of_surfaces) {
  typedef std::pair<double, double> Interval;
  const double nan = std::nan("");
  const Interval unit(0, 1);
  const auto s = patch<Double>();
  const GC::Bezier_curve<Double> profile{Double::Point(1, 0, 0), Double::Point(2, 0, 1)};
  const auto extrude = [&](const Interval& v) {
    return GC::Extrusion_surface_3<GC::Bezier_curve<Double>>(profile, Double::Vector(0, 1, 0), v);
  };
  const auto revolve = [&](const Interval& v) {
    return GC::Revolution_surface_3<GC::Bezier_curve<Double>>(profile, Double::Point(0, 0, 0), Double::Vector(0, 0, 1),
                                                              v);
  };
  for (const Interval& bad :
       {Interval(-1.7e308, 1.7e308), Interval(-1e308, 1e308), Interval(0, infinity), Interval(-infinity, 0),
        Interval(nan, 1), Interval(0, nan), Interval(-infinity, infinity)}) {
    CHECK_ERROR(s.with_domain(bad, unit), not_finite);
    CHECK_ERROR(s.with_domain(unit, bad), not_finite);
    CHECK_ERROR(extrude(bad), not_finite);
    CHECK_ERROR(revolve(bad), not_finite);
  }
  for (const Interval& empty : {Interval(0, 0), Interval(1, -1), Interval(1e308, -1e308)}) {
    CHECK_ERROR(s.with_domain(empty, unit), empty_domain);
    CHECK_ERROR(s.with_domain(unit, empty), empty_domain);
    CHECK_ERROR(extrude(empty), empty_domain);
    CHECK_ERROR(revolve(empty), empty_domain);
  }
  const auto wide = s.with_domain(Interval(-0x1p1022, 0x1p1022), unit);
  BOOST_CHECK(wide(-0x1p1022, 0) == s(0, 0) && wide(0, 1) == s(0.5, 1) && wide(0x1p1022, 1) == s(1, 1));
  BOOST_CHECK(wide.split_u(0).first.domain_u() == Interval(-0x1p1022, 0));
}

// A result that overflows is refused: neither infinite numbers nor NaN are returned.
BOOST_AUTO_TEST_CASE(surface_jets_that_overflow) {
  typedef Double::Point P;
  const GC::Bezier_patch<Double> narrow = patch<Double>().with_domain({0, 0x1p-600}, {0, 1});
  BOOST_CHECK(narrow(0x1p-601, 0.5) == patch<Double>()(0.5, 0.5));
  BOOST_CHECK_EQUAL(narrow.jet(0, 0, 1)(1, 0)[2], 0x1p604);
  // 0 / 0 for the coordinates without a second derivative
  CHECK_ERROR(narrow.jet(0, 0, 2), not_finite);
  CHECK_ERROR(GC::Bspline_surface<Double>(narrow).jet(0, 0, 2), not_finite);
  const double most = (std::numeric_limits<double>::max)();
  const GC::Bezier_patch<Double> steep{{P(0, 0, most), P(0, 1, -most)}, {P(1, 0, -most), P(1, 1, most)}};
  CHECK_ERROR(steep.jet(0.5, 0.5, 2), not_finite);
  CHECK_ERROR(GC::Bspline_surface<Double>(steep).jet(0.5, 0.5, 2), not_finite);
  const GC::Bezier_curve<Double> profile{P(1, 0, 0), P(2, 0, most)};
  CHECK_ERROR((GC::Extrusion_surface_3<GC::Bezier_curve<Double>>(profile, Double::Vector(0, 1, most))(0.5, 2)),
              not_finite);
  CHECK_ERROR((GC::Revolution_surface_3<GC::Bezier_curve<Double>>(GC::Bezier_curve<Double>{P(most, 0, 0), P(2, 0, 1)},
                                                                  P(-most, 0, 0), Double::Vector(0, 0, 1))(0, 1)),
              not_finite);
}

BOOST_AUTO_TEST_CASE(grids_that_are_too_large) {
  GC::Surface_grid<double> grid;
  grid.resize(2, 3);
  for (const auto& sizes : {std::make_pair(std::size_t(1) << 32, std::size_t(1) << 32),
                            std::make_pair((std::numeric_limits<std::size_t>::max)(), std::size_t(1)),
                            std::make_pair(std::size_t(1) << 62, std::size_t(6))})
    CHECK_ERROR(grid.resize(sizes.first, sizes.second), work_limit);
  BOOST_CHECK(grid.size_u() == 2 && grid.size_v() == 3 && grid.size() == 6);
  grid.resize(0, 5);
  BOOST_CHECK_EQUAL(grid.size(), 0);
  grid.resize(5, 0);
  BOOST_CHECK(grid.size() == 0 && grid.size_u() == 5);
}

// A grid may be empty; the parameters of a B-spline surface must lie in its domain.
BOOST_AUTO_TEST_CASE(parameters_of_grids) {
  typedef std::vector<double> Numbers;
  GC::Surface_grid<double> grid;
  const auto s = surface<Double>();
  GC::evaluate_grid(s, Numbers(), Numbers{0.5}, grid);
  BOOST_CHECK(grid.size_u() == 0 && grid.size_v() == 1);
  GC::evaluate_grid(s, Numbers{0, 0.5, 1}, Numbers{0, 1}, grid);
  BOOST_CHECK_EQUAL(grid.size(), 6);
  for (const Numbers& outside : {Numbers{-0.25, 0.5}, Numbers{0.5, 1.25}}) {
    CHECK_ERROR(GC::evaluate_grid(s, outside, Numbers{0.5}, grid), parameter_outside_domain);
    CHECK_ERROR(GC::evaluate_grid(s, Numbers{0.5}, outside, grid), parameter_outside_domain);
  }
  CHECK_ERROR(GC::evaluate_grid(s, Numbers{1, 0}, Numbers{0.5}, grid), wrong_number_of_points);
}

BOOST_AUTO_TEST_CASE(names_of_edges) {
  BOOST_CHECK_EQUAL(GC::to_string(Patch_edge::u0) + to_string(Patch_edge::u1) + to_string(Patch_edge::v0) +
                        to_string(Patch_edge::v1),
                    "u0u1v0v1");
}
