// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Series of CAD curves and surfaces over ranges of parameters enclose those at each point, which
// are the derivatives of the same splines in exact numbers; and the pieces that a range touches.

#include "support/test.h"

#include <CGAL/Geometric_continuity/cad/internal/Cad_surface_jet.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

BOOST_AUTO_TEST_SUITE(cad_jets)

using GC::internal::Interval;
typedef GC::Cad_elementary_surface Elementary;
typedef Elementary::Kind Kind;

constexpr unsigned seed = 20261127;
std::mt19937 random_bits(seed);

double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_bits); }
int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_bits); }

// Clamped at neither, one or both ends, with inner knots of all multiplicities up to the degree.
std::vector<double> knots(int degree) {
  std::vector<double> result;
  double at = -1;
  const auto append = [&](int copies) {
    for (int i = 0; i < copies; ++i) result.push_back(at);
    at += whole(1, 8) / 4.;
  };
  if (whole(0, 2) == 0)
    for (int i = 0; i <= degree; ++i) append(1);
  else
    append(degree + 1);
  for (int i = whole(0, 3); i > 0; --i) append(whole(1, degree));
  if (whole(0, 2) == 0)
    for (int i = 0; i <= degree; ++i) append(1);
  else
    append(degree + 1);
  return result;
}
std::vector<double> weights(std::size_t n, bool rational) {
  std::vector<double> w(rational ? n : 0);
  for (double& x : w) x = between(0.5, 2);
  return w;
}
std::vector<GC::Cad_point<3>> points(std::size_t n) {
  std::vector<GC::Cad_point<3>> p(n);
  for (GC::Cad_point<3>& x : p) x = {between(-2, 2), between(-2, 2), between(-2, 2)};
  return p;
}
GC::Cad_spline_curve<3> spline(int degree, bool rational) {
  const std::vector<double> u = knots(degree);
  const std::size_t n = u.size() - degree - 1;
  return {degree, u, points(n), weights(n, rational)};
}
GC::Rational_bspline_curve<Exact_3> exact(const GC::Cad_spline_curve<3>& c) {
  std::vector<Exact_3::Point> p;
  for (const GC::Cad_point<3>& x : c.points) p.emplace_back(Q(x[0]), Q(x[1]), Q(x[2]));
  std::vector<Q> w(c.weights.begin(), c.weights.end());
  const std::vector<Q> u(c.knots.begin(), c.knots.end());
  if (w.empty()) w.assign(p.size(), Q(1));
  return GC::Rational_bspline_curve<Exact_3>(p, w, GC::Knot_vector<Q>(c.degree, u));
}

template <class Parameter_range> std::pair<double, double> part_of(const Parameter_range& range) {
  const double length = range.second - range.first, a = between(0, 1),
               b = whole(0, 1) ? between(0, 1) : a + between(0, 1e-3);
  return std::minmax({range.first + (std::min)(a, 1.) * length, range.first + (std::min)(b, 1.) * length});
}
double within(const std::pair<double, double>& range) {
  return (std::min)((std::max)(between(range.first, range.second), range.first), range.second);
}

bool contains(const Interval& x, const Q& y) { return Q(x.inf()) <= y && y <= Q(x.sup()); }

BOOST_AUTO_TEST_CASE(series_of_splines) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const CGAL::Protect_FPU_rounding<true> upwards;
  for (int round = 0; round < 200; ++round) {
    const int degree = whole(1, 4);
    const GC::Cad_spline_curve<3> c = spline(degree, whole(0, 1));
    const GC::Rational_bspline_curve<Exact_3> truth = exact(c);
    for (std::size_t s = degree; s + degree + 1 < c.knots.size(); ++s) {
      if (!(c.knots[s] < c.knots[s + 1])) continue;
      const std::pair<double, double> range = part_of(std::make_pair(c.knots[s], c.knots[s + 1]));
      const auto on_range =
          GC::internal::cad_curve_jet<3>(c, Interval(range.first, range.second), 2, static_cast<int>(s));
      for (const double t : {range.first, within(range), within(range), range.second}) {
        if (t == c.knots[s] || t == c.knots[s + 1]) continue; // the other piece may count there
        const auto at_point = GC::internal::cad_curve_jet<3>(c, Interval(t), 2, static_cast<int>(s));
        const auto jet = truth.jet(Q(t), 2);
        for (int k = 0; k <= 2; ++k)
          for (int i = 0; i < 3; ++i) {
            const Q x = k == 0 ? jet.point()[i] : jet.derivative(k)[i] / Q(k);
            BOOST_CHECK(contains(at_point.c[k][i], x) && contains(on_range.c[k][i], x));
          }
      }
    }
  }
}

// All kinds of surfaces: what is said of a range holds at its points.
BOOST_AUTO_TEST_CASE(series_of_surfaces) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  const GC::Cad_frame frame{{1, 2, 3}, {0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}};
  for (int round = 0; round < 100; ++round) {
    const int p = whole(1, 3), q = whole(1, 3);
    const std::vector<double> u = knots(p), v = knots(q);
    const std::size_t n = (u.size() - p - 1) * (v.size() - q - 1);
    const GC::Cad_spline_surface s{p, q, u, v, points(n), weights(n, whole(0, 1))};
    std::vector<GC::Cad_surface> surfaces{
        s, GC::Cad_extrusion{spline(p, true), {1, 2, 3}}, GC::Cad_revolution{spline(p, false), {0, 0, 5}, {0, 0, 1}},
        GC::Cad_offset_surface{std::make_shared<GC::Cad_surface>(Elementary{Kind::torus, frame, 5, 2}), 0.5}};
    for (const Kind kind : {Kind::plane, Kind::cylinder, Kind::cone, Kind::sphere, Kind::torus})
      surfaces.push_back(Elementary{kind, frame, 5, kind == Kind::torus ? 2 : 0.5});
    const auto whole_domain = GC::internal::cad_domain(surfaces[0]);
    BOOST_CHECK(whole_domain[0].first == u[p] && whole_domain[0].last == u[u.size() - p - 1]);
    BOOST_CHECK(whole_domain[1].first == v[q] && whole_domain[1].last == v[v.size() - q - 1]);
    for (const GC::Cad_surface& surface : surfaces) {
      const auto domain = GC::internal::cad_domain(surface);
      std::pair<double, double> range[2];
      for (int i : {0, 1}) {
        const double first = (std::max)(domain[i].first, -1.), last = (std::min)(domain[i].last, 6.);
        range[i] = part_of(std::make_pair(first, last));
      }
      const Interval a(range[0].first, range[0].second), b(range[1].first, range[1].second);
      const auto spans = GC::internal::intersected_pieces(surface, a, b, 0, 0);
      for (const int i : spans[0])
        for (const int j : spans[1]) {
          const auto on_box = GC::internal::cad_surface_jet(surface, {a, b, i, j}, 2);
          const double x = within(range[0]), y = within(range[1]);
          const auto at_point = GC::internal::cad_surface_jet(surface, {Interval(x), Interval(y), i, j}, 2);
          for (int k = 0; k <= 2; ++k)
            for (int l = 0; k + l <= 2; ++l)
              for (int m = 0; m < 3; ++m) BOOST_CHECK(on_box.s(k, l)[m].do_overlap(at_point.s(k, l)[m]));
        }
    }
  }
}

BOOST_AUTO_TEST_CASE(pieces_that_a_range_touches) {
  for (int round = 0; round < 300; ++round) {
    const int degree = whole(1, 4);
    const GC::Cad_curve<3> curve = spline(degree, false);
    const std::vector<double>& u = std::get<GC::Cad_spline_curve<3>>(curve).knots;
    const int points = static_cast<int>(u.size()) - degree - 1;
    const double first = u[degree], last = u[points];
    for (int i = 0; i < 20; ++i) {
      const auto parameter = [&] { return whole(0, 1) ? u[whole(degree, points)] : between(first, last); };
      double a = parameter(), b = whole(0, 1) ? a : parameter();
      if (b < a) std::swap(a, b);
      const int side = whole(-1, 1);
      std::vector<int> expected;
      for (int s = degree; s < points; ++s) {
        if (!(u[s] < u[s + 1])) continue;
        const bool is_below_end = a < u[s + 1] || (side <= 0 && a == u[s + 1]) || (a == last && u[s + 1] == last),
                   is_above_start = u[s] < a || (side >= 0 && a == u[s]) || (a == first && u[s] == first);
        if (a < b ? (std::max)(a, u[s]) < (std::min)(b, u[s + 1]) : is_below_end && is_above_start)
          expected.push_back(s);
      }
      const std::vector<int> found = GC::internal::intersected_pieces(curve, Interval(a, b), side);
      BOOST_CHECK_EQUAL_COLLECTIONS(found.begin(), found.end(), expected.begin(), expected.end());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
