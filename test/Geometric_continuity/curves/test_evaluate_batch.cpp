// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Many jets at once: the same numbers as one by one, exactly with rational numbers, and within
// rounding with doubles.

#include "support/random_points.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>

// Returns the same curve with exact numbers.
template <class Curve> GC::Bezier_curve<Traits<Exact>> exact_curve(const Curve& curve) {
  std::vector<Point<Exact>> p;
  for (const auto& x : curve) p.emplace_back(Exact(x.x()), Exact(x.y()), Exact(x.z()));
  return {p.begin(), p.end(), Exact(curve.domain().first), Exact(curve.domain().second)};
}

// The bounds of the errors of jets, in space, for a curve whose numbers are taken as they are.
struct Bounds {
  int m;
  double a, h;
  double points[3], differences[3]; // the largest of each coordinate

  template <class Curve>
  explicit Bounds(const Curve& curve)
      : m(curve.degree()), a(CGAL::to_double(curve.domain().first)),
        h(CGAL::to_double(curve.domain().second) - CGAL::to_double(curve.domain().first)) {
    for (int i = 0; i < 3; ++i) {
      points[i] = differences[i] = 0;
      for (int j = 0; j <= m; ++j) {
        const double x = CGAL::to_double(curve.coordinates(j)[i]);
        points[i] = std::max(points[i], std::abs(x));
        if (j > 0)
          differences[i] = std::max(differences[i], std::abs(x - CGAL::to_double(curve.coordinates(j - 1)[i])));
      }
    }
  }
  double factor(int j) const { // m!/(m-j)! / h^j
    double f = 1;
    for (int l = 0; l < j; ++l) f *= (m - l) / h;
    return f;
  }
  // what Jet_polynomials promises
  double prepared(double u, int j, int i) const {
    const double x = std::max(1.0, std::abs(2 * (u - a) / h - 1));
    return 8 * (m + 1) * std::ldexp(1, m - 53) * factor(j) * (j == 0 ? points[i] : differences[i]) *
           std::pow(x, std::max(m - j, 0));
  }
  // In the domain each level of de Casteljau's algorithm adds an error of at most 5 roundings of
  // the largest point R, a difference of order j multiplies it by 2^j; the parameter is off by 3
  // roundings, and the derivative of the j-th one is at most 2^(j+1) m R; the factor has at most 3j
  // roundings.
  double single(int j, int i) const { return 16 * (m + 1) * std::ldexp(1, j - 53) * factor(j) * points[i]; }
};

// The jets of order 4, in batches and one by one from the prepared curve.
template <class FT, class Curve, class Prepared> void check_jets(const Curve& curve, const Prepared& prepared) {
  std::vector<FT> parameters{curve.domain().first, curve.domain().second};
  for (int i = 0; i < 35; ++i) parameters.push_back(FT(curve.domain().first + number<FT>()));
  GC::Jet_arrays<FT, 3, 4> jets;
  GC::evaluate<CGAL::Parallel_if_available_tag>(curve, parameters.data(), parameters.size(), jets);
  BOOST_REQUIRE_EQUAL(jets.size(), parameters.size());
  const Bounds bounds(curve);
  const GC::Bezier_curve<Traits<Exact>> exactly = exact_curve(curve);
  for (std::size_t l = 0; l < parameters.size(); ++l) {
    const GC::Curve_jet<Traits<FT>> jet = curve.jet(parameters[l], 4);
    const GC::Curve_jet<Traits<Exact>> exact_jet = exactly.jet(Exact(parameters[l]), 4);
    const GC::Coordinate_jet<FT, 3> one = prepared(parameters[l]);
    for (int j = 0; j <= 4; ++j)
      for (int i = 0; i < 3; ++i) {
        const FT x = jets.jet(l)[j][i];
        // beyond, evaluate() takes the way of jet()
        if (std::is_same_v<FT, Exact> || curve.degree() > 9)
          BOOST_CHECK_EQUAL(x, jet[j][i]);
        else {
          const double bound = bounds.prepared(CGAL::to_double(parameters[l]), j, i);
          BOOST_CHECK_LE(CGAL::to_double(abs(Exact(Exact(x) - exact_jet[j][i]))), bound);
          BOOST_CHECK_LE(CGAL::to_double(abs(Exact(Exact(one[j][i]) - exact_jet[j][i]))), bound);
        }
        if (std::is_same_v<FT, Exact>) BOOST_CHECK_EQUAL(one[j][i], jet[j][i]);
      }
  }
}

// A curve of a degree known at compile time, the same with its degree forgotten, and prepared.
template <class FT, int degree> void check_fixed_degree(const FT& a, const FT& b) {
  const std::vector<Point<FT>> p = points<FT>(degree + 1);
  const GC::Bezier_curve<Traits<FT>, degree> curve(p.begin(), p.end(), a, b);
  const GC::Bezier_curve<Traits<FT>> dynamic(curve);
  const GC::Jet_polynomials<FT, 3, degree, 4> polynomials(curve);
  check_jets<FT>(curve, [&](const FT& u) { return polynomials.jet(u); });
  check_jets<FT>(dynamic, [&](const FT& u) { return polynomials.jet(u); });

  BOOST_CHECK_EQUAL(curve(a), p[0]); // exactly, also with doubles
  BOOST_CHECK_EQUAL(curve(b), p[degree]);
  BOOST_CHECK_EQUAL(curve.jet(b, 3).point(), p[degree]);
  const Bounds bounds(curve);
  const GC::Bezier_curve<Traits<Exact>> exactly = exact_curve(curve);
  for (int l = 0; l <= 20; ++l) {
    const FT u = FT(a + FT(l) / FT(20) * (b - a));
    BOOST_CHECK(curve.template jet<2>(u) == curve.jet(u, 2));
    BOOST_CHECK(dynamic.template jet<2>(u) == dynamic.jet(u, 2));
    for (int k : {0, 1, 2, 3, 4, 7}) {
      const GC::Curve_jet<Traits<FT>> jet = curve.jet(u, k);
      const GC::Curve_jet<Traits<Exact>> exact_jet = exactly.jet(Exact(u), k);
      BOOST_REQUIRE_EQUAL(jet.order(), k);
      for (int j = 0; j <= k; ++j)
        for (int i = 0; i < 3; ++i) {
          const Exact error = Exact(Exact(jet[j][i]) - exact_jet[j][i]);
          const double bound = std::is_same_v<FT, Exact> ? 0 : bounds.single(j, i);
          BOOST_CHECK_LE(CGAL::to_double(abs(error)), bound);
        }
      if (k == 0) BOOST_CHECK_EQUAL(curve(u), jet.point());
    }
  }
}

BOOST_AUTO_TEST_CASE(jets) {
  for (int degree : {0, 3, 4, 9, 10, 11}) {
    const auto b = points<double>(degree + 1);
    const GC::Bezier_curve<Traits<double>> rounded(b.begin(), b.end(), 2, 3);
    check_jets<double>(rounded, [&](double u) { return rounded.jet(u, 4); });
    const auto c = points<Exact>(degree + 1);
    const GC::Bezier_curve<Traits<Exact>> exact(c.begin(), c.end(), Exact(1) / 3, 2);
    check_jets<Exact>(exact, [&](const Exact& u) { return exact.jet(u, 4); });
  }
  check_fixed_degree<Exact, 0>(0, 1);
  check_fixed_degree<Exact, 1>(Exact(-1) / 7, 5);
  check_fixed_degree<Exact, 5>(Exact(1) / 3, 2);
  check_fixed_degree<double, 1>(0, 1);
  check_fixed_degree<double, 2>(0.1, 0.7);
  check_fixed_degree<double, 5>(-3, 46); // 49 * (1 / 49) is not 1 in double
  GC::Jet_arrays<double, 2, 1> plane;
  typedef GC::Traits_d<CGAL::Cartesian_d<double>> Any;
  const double x[] = {1, 2, 3};
  const Any::Point p(3, x, x + 3);
  CHECK_ERROR(GC::evaluate(GC::Bezier_curve<Any>{p, p}, x, 3, plane), dimension_mismatch);
}

// Against the jets one by one: exactly, and with doubles up to roundings that grow with 2^m as
// Jet_polynomials says.
typedef std::tuple<double, Exact> Field_types;
BOOST_AUTO_TEST_CASE_TEMPLATE(rational_curves_one_by_one_or_together, FT, Field_types) {
  typedef GC::Rational_bezier_curve<Traits<FT>> Curve;
  for (int m = 0; m <= 11; ++m) {
    const std::vector<Point<FT>> p = points<FT>(m + 1);
    std::vector<FT> weights;
    for (int j = 0; j <= m; ++j) weights.push_back(FT(number<FT>() + FT(2)));
    const Curve curve = Curve(p.begin(), p.end(), weights.begin(), weights.end()).with_domain(FT(1), FT(3));
    std::vector<FT> parameters;
    for (int l = 0; l < 300; ++l) parameters.push_back(FT(FT(1) + FT(FT(2 * l) / FT(299))));
    GC::Jet_arrays<FT, 3, 3> jets;
    GC::evaluate(curve, parameters.data(), parameters.size(), jets);
    BOOST_REQUIRE_EQUAL(jets.size(), parameters.size());
    for (std::size_t l = 0; l < parameters.size(); l += 7) {
      const GC::Curve_jet<Traits<FT>> one = curve.jet(parameters[l], 3);
      const GC::Coordinate_jet<FT, 3> many = jets.jet(l);
      for (int j = 0; j <= 3; ++j)
        for (int i = 0; i < 3; ++i) BOOST_CHECK(same(one[j][i], many[j][i], std::pow(2 * m + 2, j) * std::ldexp(1, m)));
    }
  }
  // the denominator 2 - u is zero at a parameter outside of the domain
  const GC::Rational_bezier_curve<Traits<FT>, 1> line({Point<FT>(0, 0, 0), Point<FT>(1, 0, 0)}, {FT(2), FT(1)});
  const FT outside[] = {FT(0), FT(2)};
  GC::Jet_arrays<FT, 3, 1> jets;
  CHECK_ERROR(GC::evaluate(line, outside, 2, jets), zero_weight);
}
