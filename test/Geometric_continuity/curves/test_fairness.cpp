// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The variation of curvature and the bending energy, against closed formulas and independent sums.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/bezier_properties.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>

BOOST_AUTO_TEST_SUITE(fairness)

typedef std::tuple<Exact_2, Epeck_2, Epick_2, Double_2, Exact_d, Double_d> Planar_traits;
typedef std::vector<std::vector<double>> Rows;

constexpr unsigned seed = 2026;

template <class Traits> GC::Bezier_curve<Traits> bezier(const Rows& rows, double factor = 1, double b = 1) {
  std::vector<typename Traits::Point> p;
  for (const std::vector<double>& row : rows) {
    GC::Coordinates<Traits> x(static_cast<int>(row.size()));
    for (int i = 0; i < x.dimension(); ++i)
      x[i] = typename Traits::FT(typename Traits::FT(factor) * typename Traits::FT(row[i]));
    p.push_back(GC::to_point<Traits>(x));
  }
  return GC::Bezier_curve<Traits>(p.begin(), p.end(), typename Traits::FT(0), typename Traits::FT(b));
}

bool near(double x, double y, double precision = 1e-8) { return std::abs(x - y) <= precision * std::abs(y); }

// An arc of the circle of radius r by its angle: no polynomial, so that its jets are read.
struct Arc {
  typedef Double_2 Traits;
  double r, angle;
  std::pair<double, double> domain() const { return {1, 1 + angle}; }
  GC::Curve_jet<Traits> jet(double u, int k) const {
    GC::Curve_jet<Traits> jet(2, k);
    for (int j = 0; j <= k; ++j) {
      jet[j][0] = r * std::cos(u + j * std::acos(0.));
      jet[j][1] = r * std::sin(u + j * std::acos(0.));
    }
    return jet;
  }
};

// L, the integrals of the squared curvature and of what E integrates, by the trapezoidal rule in
// the curvature and the torsion, which are taken from jets of the curve.
std::array<double, 2> summed(const GC::Bezier_curve<Double_d>& curve) {
  constexpr int n = 2000;
  double length = 0, bending = 0, variation = 0;
  const auto curvature = [&](double t) { return std::sqrt(*GC::curvature_squared(curve.jet(t, 2))); };
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n, h = 1e-5;
    const GC::Curve_jet<Double_d> jet = curve.jet(t, 3);
    const double speed = std::sqrt(dot(jet[1], jet[1])) / n, kappa = curvature(t),
                 slope = (curvature(t + h) - curvature(t - h)) / (2 * h) / (n * speed),
                 tau = curve.dimension() == 3 ? *GC::torsion(jet) : 0;
    length += speed;
    bending += kappa * kappa * speed;
    variation += (slope * slope + kappa * kappa * tau * tau) * speed;
  }
  return {length * length * length * variation, length * bending};
}

Rows random_rows(std::mt19937& engine, int degree, int dimension) {
  Rows rows;
  for (int i = 0; i <= degree; ++i) {
    rows.emplace_back();
    for (int k = 0; k < dimension; ++k)
      rows.back().push_back((static_cast<int>(engine() % 2001) - 1000) / 2048. + (k == 0 ? i : 0));
  }
  return rows;
}

BOOST_AUTO_TEST_CASE(circles_and_lines) {
  for (double r : {1e-3, 1., 1e5})
    for (double angle : {0.1, 1., 6.}) {
      BOOST_CHECK(near(GC::bending_energy(Arc{r, angle}), angle * angle));
      BOOST_CHECK(GC::fairness(Arc{r, angle}) < 1e-18);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_parabola, Traits, Planar_traits) {
  // y = x^2 from -1 to 1: kappa = 2 / (1 + 4x^2)^(3/2), dkappa/ds = -24 x / (1 + 4x^2)^3
  const auto curve = bezier<Traits>({{-1, 1}, {0, -1}, {1, 1}});
  const double length = std::sqrt(5.) + std::asinh(2.) / 2, atan2 = std::atan(2.);
  constexpr int n = 100000;
  double variation = 0, bending = 0;
  for (int i = 0; i < n; ++i) {
    const double x = -1 + (i + 0.5) * 2 / n, w = 1 + 4 * x * x;
    variation += 576 * x * x / std::pow(w, 5.5) * 2 / n;
    bending += 4 / std::pow(w, 2.5) * 2 / n;
  }
  BOOST_CHECK(atan2 > 1);
  BOOST_CHECK(near(GC::fairness(curve), std::pow(length, 3) * variation));
  BOOST_CHECK(near(GC::bending_energy(curve), length * bending));
  // neither the scale nor the domain matters
  BOOST_CHECK(near(GC::fairness(bezier<Traits>({{-1, 1}, {0, -1}, {1, 1}}, 1024, 7)), GC::fairness(curve), 1e-12));
  // lines, also with points at unequal distances; cusps and points
  BOOST_CHECK(GC::fairness(bezier<Traits>({{0, 0}, {1, 1}, {4, 4}})) < 1e-20);
  BOOST_CHECK(GC::bending_energy(bezier<Traits>({{0, 0}, {1, 1}, {4, 4}})) < 1e-20);
  BOOST_CHECK_EQUAL(GC::fairness(bezier<Traits>({{0, 0}, {1, 1}})), 0);
  for (const Rows& rows : {Rows{{0, 0}, {1, 1}, {0, 1}, {1, 0}}, Rows{{0, 0}, {0, 0}, {1, 3}, {2, 5}}, Rows{{1, 1}}}) {
    BOOST_CHECK(std::isinf(GC::fairness(bezier<Traits>(rows))));
    BOOST_CHECK(std::isinf(GC::bending_energy(bezier<Traits>(rows))));
  }
}

BOOST_AUTO_TEST_CASE(random_curves_against_sums) {
  std::mt19937 engine(seed);
  BOOST_TEST_MESSAGE("seed " << seed);
  for (int run = 0; run < 12; ++run) {
    const Rows rows = random_rows(engine, 3 + run % 4, 2 + run % 2);
    const GC::Bezier_curve<Double_d> curve = bezier<Double_d>(rows);
    const std::array<double, 2> sum = summed(curve);
    BOOST_TEST_CONTEXT("run " << run) {
      if (run % 2 == 1)
        // |kappa| has a kink where it is 0 in the plane
        BOOST_CHECK(near(GC::fairness(curve), sum[0], 1e-4));
      BOOST_CHECK(near(GC::bending_energy(curve), sum[1], 1e-4));
    }
    BOOST_CHECK(near(GC::fairness(curve.reverse()), GC::fairness(curve), 1e-10));
    BOOST_CHECK(near(GC::fairness(bezier<Exact_d>(rows)), GC::fairness(curve), 1e-10));
    Rows higher = rows;
    for (std::vector<double>& row : higher) row.insert(row.begin() + 1, 0.25);
    BOOST_CHECK(near(GC::fairness(bezier<Double_d>(higher)), GC::fairness(curve), 1e-10));
  }
}

BOOST_AUTO_TEST_CASE(curves_of_several_pieces) {
  std::mt19937 engine(seed + 1);
  for (int run = 0; run < 6; ++run) {
    const GC::Bezier_curve<Exact_d> whole = bezier<Exact_d>(random_rows(engine, 5, 2 + run % 3));
    const auto parts = whole.split(Q(0.25));
    const std::vector<GC::Bezier_curve<Exact_d>> pieces = {parts.first, parts.second};
    const GC::Composite_bezier_curve<Exact_d> composite(pieces.begin(), pieces.end());
    const GC::Bspline_curve<Exact_d> spline(pieces.begin(), pieces.end());
    BOOST_CHECK(near(GC::fairness(composite), GC::fairness(whole)));
    BOOST_CHECK(near(GC::fairness(spline), GC::fairness(whole)));
    BOOST_CHECK(near(GC::bending_energy(composite), GC::bending_energy(whole)));
  }
}

// Coordinates outside of the range of `double`.
BOOST_AUTO_TEST_CASE(numbers_of_any_size) {
  Q factor(1);
  for (int i = 0; i < 400; ++i) factor *= Q(10);
  const Rows rows = {{0, 0}, {1, 2}, {2, -1}, {4, 1}};
  const GC::Bezier_curve<Exact_d> curve = bezier<Exact_d>(rows);
  for (const Q& size : {factor, Q(Q(1) / factor)}) {
    std::vector<Exact_d::Point> p;
    for (const std::vector<double>& row : rows) {
      const std::array<Q, 2> x = {Q(size * Q(row[0])), Q(size * Q(row[1]))};
      p.push_back(Exact_d::Point(2, x.begin(), x.end()));
    }
    BOOST_CHECK(near(GC::fairness(GC::Bezier_curve<Exact_d>(p.begin(), p.end())), GC::fairness(curve), 1e-12));
  }
  BOOST_CHECK(near(GC::fairness(bezier<Double_2>(rows, 1e300)), GC::fairness(curve), 1e-12));
  BOOST_CHECK(near(GC::fairness(bezier<Double_2>(rows, 1e-300)), GC::fairness(curve), 1e-12));
  CHECK_ERROR(GC::fairness(bezier<Double_2>({{-1, 0}, {0, 1}, {1, 0}}, 1.5e308)), not_finite);
}

// Tight bends cost more intervals, until they count as cusps.
BOOST_AUTO_TEST_CASE(nearly_cusps) {
  double last = 0;
  for (double d : {0.1, 0.01, 0.001, 0.0001}) {
    const double e = GC::fairness(bezier<Double_2>({{0, 0}, {1 + d, 1}, {-d, 1}, {1, 0}}));
    BOOST_CHECK(last < e && std::isfinite(e));
    last = e;
  }
}

// More changes of side than common points, or more common points than the polygon has changes,
// contradict each other.
BOOST_AUTO_TEST_CASE(crossings_of_polygons) {
  BOOST_CHECK((GC::Crossings{3, 1, 3}.diminished()));
  BOOST_CHECK((!GC::Crossings{3, 2, 1}.diminished()) && (!GC::Crossings{1, 1, 2}.diminished()));
}

// (t, a sin(w t) / w), of jets up to a certain order; and (s^2, s^3) with s = t - 1/2, a cusp.
struct Wave {
  typedef Double_2 Traits;
  double w;
  int order = 3;
  bool has_cusp = false;

  std::pair<double, double> domain() const { return {0, 1}; }
  GC::Curve_jet<Double_2> jet(double t, int k) const {
    k = (std::min)(k, order);
    typedef Double_2::Vector V;
    const double s = t - 0.5;
    const std::vector<V> d =
        has_cusp ? std::vector<V>{V(2 * s, 3 * s * s), V(2, 6 * s), V(0, 6)}
                 : std::vector<V>{V(1, std::cos(w * t)), V(0, -w * std::sin(w * t)), V(0, -w * w * std::cos(w * t))};
    return GC::Curve_jet<Double_2>(Double_2::Point(t, 0), std::vector<V>(d.begin(), d.begin() + k));
  }
};

// A curve that is no spline is asked for its jets: it may turn too often, stop in the middle, or
// have too few derivatives.
BOOST_AUTO_TEST_CASE(curves_by_their_jets) {
  BOOST_CHECK(std::isfinite(GC::fairness(Wave{20})));
  CHECK_ERROR(GC::fairness(Wave{1e5}), work_limit);
  CHECK_ERROR(GC::bending_energy(Wave{1e5}), work_limit);
  CHECK_ERROR(GC::fairness(Wave{20, 2}), jet_order_too_low);
  BOOST_CHECK(std::isinf(GC::fairness(Wave{0, 3, true})));
}

BOOST_AUTO_TEST_SUITE_END()
