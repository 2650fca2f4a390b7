// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Products and elevations of splines in floating-point numbers, as an optimising compiler makes
// them, against the same in rational numbers. The only test that is compiled with optimisation:
// rows of numbers are kept in vector registers there.

#define BOOST_TEST_MODULE optimised_splines

#include "support/random.h"

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>

struct Random : Random_integers<> {
  // on [0, 20], with up to 5 inner knots of any multiplicity
  std::vector<int> knots(int degree) {
    std::vector<int> k(degree + 1, 0);
    int knot = 0;
    for (int inner = integer(0, 5); inner > 0; --inner) {
      knot += integer(1, 3);
      k.insert(k.end(), integer(0, 2) == 0 ? integer(1, degree) : 1, knot);
    }
    k.insert(k.end(), degree + 1, 20);
    return k;
  }
  std::vector<int> numbers(std::size_t n) {
    std::vector<int> v(n);
    for (int& x : v) x = integer(-8, 8);
    return v;
  }
};

struct Splines {
  int p, q, times;
  std::vector<int> f_knots, g_knots, f, g; // g: 3 numbers a control point

  explicit Splines(Random& random)
      : p(random.integer(1, 4)), q(random.integer(1, 4)), times(random.integer(0, 3)), f_knots(random.knots(p)),
        g_knots(random.knots(q)), f(random.numbers(f_knots.size() - p - 1)),
        g(random.numbers(3 * (g_knots.size() - q - 1))) {}

  // The coordinates of the control points of f g and of g elevated.
  template <class Traits> std::vector<double> results() const {
    typedef typename Traits::FT FT;
    const Traits traits;
    std::vector<typename Traits::Point> points;
    for (std::size_t i = 0; i < g.size(); i += 3) {
      const std::vector<FT> x(g.begin() + i, g.begin() + i + 3);
      points.push_back(
          traits.construct_point_object()(Traits::Dimension::value, x.begin(), x.begin() + Traits::Dimension::value));
    }
    const auto knots = [](int degree, const std::vector<int>& u) {
      return GC::Knot_vector<FT>(degree, std::vector<FT>(u.begin(), u.end()));
    };
    const GC::Bspline_function<FT> factor(knots(p, f_knots), std::vector<FT>(f.begin(), f.end()));
    const GC::Bspline_curve<Traits> curve(points.begin(), points.end(), knots(q, g_knots));
    std::vector<double> all;
    for (const GC::Bspline_curve<Traits>& c : {curve.multiply(factor), curve.elevate(times)})
      for (const typename Traits::Point& x : c.control_points())
        for (int i = 0; i < Traits::Dimension::value; ++i)
          all.push_back(CGAL::to_double(FT(traits.compute_coordinate_object()(x, i))));
    return all;
  }
};

// Coefficients that straddle a knot are extrapolated from the longest of at most 8 spans, at most 8
// times: a relative error 2^-53 of numbers of at most 64 may grow, but stays far below what a wrong
// coefficient is off by, about 1.
constexpr double bound = 1e-9;

template <class Rounded, class Exact> void compare(const Splines& s) {
  const std::vector<double> rounded = s.results<Rounded>(), exact = s.results<Exact>();
  BOOST_REQUIRE_EQUAL(rounded.size(), exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) BOOST_REQUIRE_LE(std::abs(rounded[i] - exact[i]), bound);
}

BOOST_AUTO_TEST_CASE(products_and_elevations) {
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Exact;
  Random random;
  for (int k = 0; k < 300; ++k) {
    const Splines s(random);
    BOOST_TEST_CONTEXT("seed " << random.seed << ", splines number " << k << ", degrees " << s.p << " and " << s.q) {
      compare<GC::Traits_3<CGAL::Simple_cartesian<double>>, GC::Traits_3<Exact>>(s);
      compare<GC::Traits_2<CGAL::Simple_cartesian<double>>, GC::Traits_2<Exact>>(s);
      compare<GC::Traits_3<CGAL::Simple_cartesian<long double>>, GC::Traits_3<Exact>>(s);
    }
  }
}
