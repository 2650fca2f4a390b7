// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rational curves and surfaces of doubles: jets, one at a time and in batches, and knot insertion,
// against OpenCASCADE and SISL where they were found, and the price of exact decisions against
// those on polynomials. Results are compared before anything is timed.

#include "Ratio_table.h"
#include "measure.h"
#include "peers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <GeomAdaptor_Curve.hxx>
#include <GeomAdaptor_Surface.hxx>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
template <int Degree> using Bezier = GC::Rational_bezier_curve<Traits, Degree>;
typedef GC::Rational_bspline_curve<Traits> Curve;
typedef GC::Rational_bspline_surface<Traits> Surface;
typedef GC::Curve_jet<Traits> Jet;

namespace {

std::mt19937 engine(2026);

double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
Point random_point() {
  const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
  return Point(x, y, z);
}
GC::Knot_vector<double> knots(int degree, int spans) {
  std::vector<GC::Knot_vector<double>::Knot> inner;
  for (int i = 1; i < spans; ++i) inner.push_back({(i + between(-0.3, 0.3)) / spans, 1});
  return GC::Knot_vector<double>(degree, 0, 1, inner);
}
Curve random_curve(int degree, int spans) {
  std::vector<Point> points;
  std::vector<double> weights;
  for (int i = 0; i < degree + spans; ++i) {
    points.push_back(random_point());
    weights.push_back(between(0.25, 4));
  }
  return Curve(points.begin(), points.end(), weights.begin(), weights.end(), knots(degree, spans));
}
Surface random_surface(int degree, int spans) {
  std::vector<std::vector<Point>> net(degree + spans);
  std::vector<std::vector<double>> weights(net.size());
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net.size(); ++j) {
      net[i].push_back(random_point());
      weights[i].push_back(between(0.25, 4));
    }
  return Surface(net, weights, knots(degree, spans), knots(degree, spans));
}

// In random order, inside of the domain.
const std::vector<double>& parameters() {
  static const std::vector<double> u = [] {
    std::vector<double> u;
    for (std::size_t l = 0; l < n; ++l) u.push_back(between(0, 1));
    return u;
  }();
  return u;
}

void check_jet(const Jet& x, const Jet& y, const std::string& what) {
  for (int j = 0; j <= x.order(); ++j)
    for (int i = 0; i < 3; ++i) check(near(x[j][i], y[j][i]), what.c_str());
}

// jet(u) for one parameter after the other.
template <class Function> void time_jets(const std::string& name, Function jet) {
  one_by_one(name.c_str(), [jet](std::size_t l) mutable {
    const auto x = jet(parameters()[l]);
    benchmark::DoNotOptimize(x);
  });
}

// ---------------------------------------------------------------- jets of curves by the peers

template <int k> void register_peers([[maybe_unused]] const std::string& work, [[maybe_unused]] const Curve& curve) {
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const Handle(Geom_BSplineCurve) occt = peers::occt_curve(curve);
  const auto adaptor = std::make_shared<GeomAdaptor_Curve>(occt);
  const auto jet_by = [](const auto& c, double u) {
    std::array<gp_Vec, 4> d;
    gp_Pnt p;
    if constexpr (k == 2)
      c.D2(u, p, d[1], d[2]);
    else
      c.D3(u, p, d[1], d[2], d[3]);
    d[0] = gp_Vec(p.XYZ());
    return d;
  };
  for (double u : parameters()) {
    const Jet x = curve.jet(u, k);
    const std::array<gp_Vec, 4> by_adaptor = jet_by(*adaptor, u), by_curve = jet_by(*occt, u);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < 3; ++i)
        check(near(x[j][i], by_adaptor[j].Coord(i + 1)) && near(x[j][i], by_curve[j].Coord(i + 1)), "OpenCASCADE");
  }
  time_jets(work + "OpenCASCADE, adaptor (prepared)", [=](double u) { return jet_by(*adaptor, u); });
  time_jets(work + "OpenCASCADE, Geom_BSplineCurve", [=](double u) { return jet_by(*occt, u); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  const std::shared_ptr<SISLCurve> sisl = peers::sisl_curve(curve);
  const auto jet = [sisl, left = 0](double u) mutable {
    std::array<double, 3 * (k + 1)> out;
    int status = 0;
    s1221(sisl.get(), k, u, &left, out.data(), &status);
    return out;
  };
  auto once = jet;
  for (double u : parameters()) {
    const Jet x = curve.jet(u, k);
    const std::array<double, 3 * (k + 1)> out = once(u);
    for (int i = 0; i < 3 * (k + 1); ++i) check(near(x[i / 3][i % 3], out[i]), "SISL");
  }
  time_jets(work + "SISL", jet);
#endif
}

// ---------------------------------------------------------------- curves

template <int Degree, int k> void register_bezier() {
  const std::string title =
      "jets of order " + std::to_string(k) + ", rational Bezier, degree " + std::to_string(Degree) + " | ";
  const Curve spline = random_curve(Degree, 1);
  const GC::Rational_bezier_curve<Traits> dynamic = spline.bezier_pieces()[0];
  const Bezier<Degree> fixed(dynamic);
  for (double u : parameters()) {
    check_jet(fixed.jet(u, k), dynamic.jet(u, k), title + "dynamic");
    check_jet(fixed.jet(u, k), spline.jet(u, k), title + "B-spline");
  }
  time_jets(title + "Rational_bezier_curve<Traits, m>", [=](double u) { return fixed.jet(u, k); });
  const auto batch = std::make_shared<GC::Jet_arrays<double, 3, k>>(n);
  GC::evaluate(fixed, parameters().data(), n, *batch);
  for (std::size_t l = 0; l < n; ++l) check_jet(fixed.jet(parameters()[l], k), Jet(batch->jet(l)), title + "batch");
  at_once((title + "evaluate(), batch").c_str(), n, [=] { GC::evaluate(fixed, parameters().data(), n, *batch); });
  time_jets(title + "Rational_bezier_curve<Traits>", [=](double u) { return dynamic.jet(u, k); });
  time_jets(title + "Rational_bspline_curve", [=](double u) { return spline.jet(u, k); });
  register_peers<k>(title, spline);
}

template <int k> void register_bspline(int degree, int spans) {
  const std::string title = "jets of order " + std::to_string(k) + ", rational B-spline, degree " +
                            std::to_string(degree) + ", " + std::to_string(spans) + " spans | ";
  const Curve curve = random_curve(degree, spans);
  time_jets(title + "Rational_bspline_curve", [=](double u) { return curve.jet(u, k); });
  register_peers<k>(title, curve);
}

// ---------------------------------------------------------------- surfaces

void register_surface(int degree, int spans) {
  const std::string title = "jets of order 2, rational surface, degree " + std::to_string(degree) + " x " +
                            std::to_string(degree) + ", " + std::to_string(spans) + " x " + std::to_string(spans) +
                            " spans | ";
  const Surface surface = random_surface(degree, spans);
  const auto v_of = [](double u) { return 1 - u; };
  time_jets(title + "Rational_bspline_surface", [=](double u) { return surface.jet(u, v_of(u), 2); });
  if (spans == 1) {
    const GC::Rational_bezier_patch<Traits> patch = surface.bezier_patches()[0];
    for (double u : parameters()) {
      const GC::Surface_jet<Traits> x = surface.jet(u, v_of(u), 2), y = patch.jet(u, v_of(u), 2);
      for (int i = 0; i <= 2; ++i)
        for (int j = 0; i + j <= 2; ++j)
          for (int l = 0; l < 3; ++l) check(near(x(i, j)[l], y(i, j)[l]), "patch");
    }
    time_jets(title + "Rational_bezier_patch", [=](double u) { return patch.jet(u, v_of(u), 2); });
  }
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const Handle(Geom_BSplineSurface) occt = peers::occt_surface(surface);
  const auto adaptor = std::make_shared<GeomAdaptor_Surface>(occt);
  const auto by_occt = [v_of](const auto& s, double u) {
    std::array<gp_Vec, 6> d; // S, S_u, S_v, S_uu, S_uv, S_vv
    gp_Pnt p;
    s.D2(u, v_of(u), p, d[1], d[2], d[3], d[5], d[4]);
    d[0] = gp_Vec(p.XYZ());
    return d;
  };
  time_jets(title + "OpenCASCADE, adaptor (prepared)", [=](double u) { return by_occt(*adaptor, u); });
  time_jets(title + "OpenCASCADE, Geom_BSplineSurface", [=](double u) { return by_occt(*occt, u); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  const std::shared_ptr<SISLSurf> sisl = peers::sisl_surface(surface);
  const auto by_sisl = [sisl, v_of, left = std::array<int, 2>{}](double u) mutable {
    double at[2] = {u, v_of(u)}, normal[3];
    std::array<double, 18> d;
    int status = 0;
    s1421(sisl.get(), 2, at, &left[0], &left[1], d.data(), normal, &status);
    return d;
  };
  auto once = by_sisl;
  time_jets(title + "SISL", by_sisl);
#endif
  for (double u : parameters()) {
    const GC::Surface_jet<Traits> x = surface.jet(u, v_of(u), 2);
    int at = 0;
    for (int order = 0; order <= 2; ++order)
      for (int j = 0; j <= order; ++j, ++at)
        for (int l = 0; l < 3; ++l) {
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
          check(near(x(order - j, j)[l], by_occt(*adaptor, u)[at].Coord(l + 1)), "OpenCASCADE: surface");
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
          check(near(x(order - j, j)[l], once(u)[3 * at + l]), "SISL: surface");
#endif
        }
  }
}

// ---------------------------------------------------------------- knot insertion

void register_insertion(int degree, int spans) {
  const std::string title =
      "insertion of a knot, degree " + std::to_string(degree) + ", " + std::to_string(spans) + " spans, new curve | ";
  const Curve curve = random_curve(degree, spans);
  const Curve finer = curve.insert(0.4321);
  at_once((title + "Rational_bspline_curve").c_str(), 1, [=] {
    const Curve r = curve.insert(0.4321);
    benchmark::DoNotOptimize(r);
  });
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  const Handle(Geom_BSplineCurve) occt = peers::occt_curve(curve);
  const auto by_occt = [occt] {
    const Handle(Geom_BSplineCurve) r = Handle(Geom_BSplineCurve)::DownCast(occt->Copy());
    r->InsertKnot(0.4321, 1, 0);
    return r;
  };
  const Handle(Geom_BSplineCurve) occt_finer = by_occt();
  for (int i = 0; i < finer.number_of_points(); ++i)
    for (int l = 0; l < 3; ++l)
      check(near(finer.control_point(i)[l], occt_finer->Pole(i + 1).Coord(l + 1)), "OpenCASCADE: insertion");
  at_once((title + "OpenCASCADE").c_str(), 1, [=] { benchmark::DoNotOptimize(by_occt()); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  const std::shared_ptr<SISLCurve> sisl = peers::sisl_curve(curve);
  const auto by_sisl = [sisl] {
    double u = 0.4321;
    SISLCurve* r = nullptr;
    int status = 0;
    s1018(sisl.get(), &u, 1, &r, &status);
    return peers::Sisl_curve(r);
  };
  const peers::Sisl_curve sisl_finer = by_sisl();
  for (int i = 0; i < finer.number_of_points(); ++i)
    for (int l = 0; l < 3; ++l) check(near(finer.control_point(i)[l], sisl_finer->ecoef[3 * i + l]), "SISL: insertion");
  at_once((title + "SISL").c_str(), 1, [=] { benchmark::DoNotOptimize(by_sisl()); });
#endif
}

// ---------------------------------------------------------------- the price of exact decisions

typedef GC::Traits_3<CGAL::Epick> Filtered;

// Multiples of 1/64, so that halving is exact.
Filtered::Point grid_point() {
  const auto number = [] { return std::floor(between(-1024, 1024)) / 64; };
  const double x = number(), y = number(), z = number();
  return Filtered::Point(x, y, z);
}

// is_join(left, right) of polynomial curves, and of the same points in another rational
// parametrisation.
template <class Predicate> void register_join(const std::string& name, Predicate is_join) {
  typedef GC::Bezier_curve<Filtered, 5> Quintic;
  typedef GC::Rational_bezier_curve<Filtered, 5> Rational;
  std::array<Filtered::Point, 6> points;
  for (Filtered::Point& p : points) p = grid_point();
  const std::pair<Quintic, Quintic> halves = Quintic(points.begin(), points.end()).split(0.5);
  std::copy(halves.second.begin(), halves.second.end(), points.begin());
  points[1] = Filtered::Point(points[1].x() + 1, points[1].y(), points[1].z());
  const Quintic other(points.begin(), points.end());
  points[1] = halves.second.control_point(1);
  points[2] = Filtered::Point(points[2].x() + 1, points[2].y(), points[2].z());
  const Quintic touching(points.begin(), points.end());
  const auto time = [&](const std::string& title, const Quintic& left, const Quintic& right,
                        const Rational& rational_left, const Rational& rational_right, bool holds) {
    check(is_join(left, right) == holds && is_join(rational_left, rational_right) == holds, name.c_str());
    at_once((title + "polynomial").c_str(), 1, [=] { benchmark::DoNotOptimize(is_join(left, right)); });
    at_once((title + "rational").c_str(), 1, [=] { benchmark::DoNotOptimize(is_join(rational_left, rational_right)); });
    if (is_join(rational_left, right) == holds)
      at_once((title + "rational and polynomial").c_str(), 1,
              [=] { benchmark::DoNotOptimize(is_join(rational_left, right)); });
  };
  const Quintic left = halves.first;
  for (const Quintic& right : {halves.second, other, touching}) {
    const bool holds = is_join(left, right);
    const std::string title = name + (holds                          ? ", holds | "
                                      : !GC::is_g1_join(left, right) ? ", no common tangent | "
                                                                     : ", common tangent, does not hold | ");
    time(title, left, right, Rational(left).reparametrised(2), Rational(right).reparametrised(4), holds);
  }
  // With weights of 53 bits: one half, and the same turned by pi about an axis in its osculating
  // plane, normal to its tangent.
  std::array<double, 6> weights;
  for (double& w : weights) w = between(1, 2);
  for (Filtered::Point& p : points) p = grid_point();
  points[0] = Filtered::Point(0, points[0].y(), 0);
  points[1] = Filtered::Point(points[1].x(), points[0].y(), 0);
  points[2] = Filtered::Point(points[2].x(), points[2].y(), 0);
  std::array<Filtered::Point, 6> turned;
  for (int j = 0; j < 6; ++j) turned[5 - j] = Filtered::Point(-points[j].x(), points[j].y(), -points[j].z());
  const Quintic half(points.begin(), points.end()), turned_half(turned.begin(), turned.end());
  const Rational long_half(points.begin(), points.end(), weights.begin(), weights.end()),
      long_turned_half(turned.begin(), turned.end(), weights.rbegin(), weights.rend());
  const bool holds = is_join(turned_half, half);
  if (holds)
    time(name + ", symmetric, weights of 53 bits, holds | ", turned_half, half, long_turned_half, long_half, holds);
}

// is_g2_join of ends whose weights are short and do not cancel: w_0 w_2/w_1^2 is 3 on the left and
// 3/4 on the right. The differences D_2 of both ends obey V_2 = 4 (3 W_2)/(3/4) up to a multiple of
// D_1, and V_2 = 4 W_2 for polynomials.
void register_g2_join_of_other_weights() {
  typedef GC::Bezier_curve<Filtered, 5> Quintic;
  typedef GC::Rational_bezier_curve<Filtered, 5> Rational;
  const std::array<double, 6> left_weights = {1, 2, 5, 3, 1, 1}, right_weights = {3, 2, 1, 1, 1, 1};
  std::array<Filtered::Point, 6> left, right;
  for (Filtered::Point& p : left) p = grid_point();
  for (Filtered::Point& p : right) p = grid_point();
  const Filtered::Point& end = left[5];
  const Filtered::Vector first = left[4] - end, second = left[3] - end;
  right[0] = end;
  right[1] = end - 2 * first;
  const auto is_join = [](const auto& x, const auto& y) { return GC::is_g2_join(x, y); };
  const std::string title = "is_g2_join, weights that do not cancel, holds | ";
  const Quintic curve(left.begin(), left.end());
  right[2] = end + 4 * second + 3 * first;
  const Quintic other(right.begin(), right.end());
  right[2] = end + 16 * second + 3 * first;
  const Rational rational(left.begin(), left.end(), left_weights.begin(), left_weights.end()),
      rational_other(right.begin(), right.end(), right_weights.begin(), right_weights.end());
  check(is_join(curve, other) && is_join(rational, rational_other), "is_g2_join, other weights");
  at_once((title + "polynomial").c_str(), 1, [=] { benchmark::DoNotOptimize(is_join(curve, other)); });
  at_once((title + "rational").c_str(), 1, [=] { benchmark::DoNotOptimize(is_join(rational, rational_other)); });
}

void register_edge() {
  typedef GC::Bezier_patch<Filtered> Patch;
  typedef GC::Rational_bezier_patch<Filtered> Rational;
  std::vector<std::vector<Filtered::Point>> net(4);
  for (std::vector<Filtered::Point>& row : net)
    for (int j = 0; j < 4; ++j) row.push_back(grid_point());
  const std::pair<Patch, Patch> halves = Patch(net).split_v(0.5);
  const auto rational = [](const Patch& s, double c) {
    std::vector<std::vector<Filtered::Point>> net(4);
    std::vector<std::vector<double>> weights(4);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        net[i].push_back(s.control_point(i, j));
        weights[i].push_back(std::pow(c, j));
      }
    return Rational(net, weights);
  };
  const Patch a = halves.first, b = halves.second;
  const Rational c = rational(a, 2), d = rational(b, 4);
  const auto order = [](const auto& s, const auto& t) {
    return GC::edge_continuity(s, GC::Patch_edge::v1, t, GC::Patch_edge::v0).g_order;
  };
  check(order(a, b) == 2 && order(c, d) == 2 && order(c, b) == 2, "edge_continuity");
  const std::string title = "edge_continuity, degree 3 x 3, G2 | ";
  at_once((title + "polynomial").c_str(), 1, [=] { benchmark::DoNotOptimize(order(a, b)); });
  at_once((title + "rational").c_str(), 1, [=] { benchmark::DoNotOptimize(order(c, d)); });
  at_once((title + "rational and polynomial").c_str(), 1, [=] { benchmark::DoNotOptimize(order(c, b)); });
}

} // namespace

int main(int argc, char** argv) {
  register_bezier<2, 2>();
  register_bezier<3, 2>();
  register_bezier<4, 2>();
  register_bezier<5, 2>();
  register_bezier<2, 3>();
  register_bezier<3, 3>();
  register_bezier<4, 3>();
  register_bezier<5, 3>();
  for (int degree : {3, 5}) {
    register_bspline<2>(degree, 16);
    register_bspline<3>(degree, 16);
  }
  for (int spans : {1, 8}) register_surface(3, spans);
  register_insertion(3, 16);
  register_join("is_g1_join", [](const auto& x, const auto& y) { return GC::is_g1_join(x, y); });
  register_join("is_g2_join", [](const auto& x, const auto& y) { return GC::is_g2_join(x, y); });
  register_join("is_g3_join", [](const auto& x, const auto& y) { return GC::is_g3_join(x, y); });
  register_join("is_f3_join", [](const auto& x, const auto& y) { return GC::is_f3_join(x, y); });
  register_edge();
  register_g2_join_of_other_weights();
  return run_benchmarks(argc, argv);
}
