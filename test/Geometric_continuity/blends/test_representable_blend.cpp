// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends whose control points are floating-point numbers and whose joins are exactly G2.

#include <CGAL/Geometric_continuity.h>

#include "support/rounding_modes.h"
#include "support/test.h"

BOOST_AUTO_TEST_SUITE(representable_blend)

typedef GC::Traits_2<CGAL::Epick> Plane;
typedef GC::Traits_3<CGAL::Epick> Space;
typedef GC::Bezier_curve<Space> Curve;
typedef GC::Representable_blend<Space> Blend;

std::mt19937_64 random_engine(2026);

// a multiple of 2^-36 in (-8, 8)
double on_grid() { return std::ldexp(static_cast<double>(random_engine() >> 24), -36) - 8; }
// 53 random digits
double full() { return std::ldexp(static_cast<double>(random_engine() >> 11), -52) - 1; }

template <class Number> Curve random_curve(int degree, Number number) {
  std::vector<Space::Point> points;
  for (int i = 0; i <= degree; ++i) {
    const double x = number(), y = number(), z = number();
    points.emplace_back(x, y, z);
  }
  return Curve(points.begin(), points.end());
}

bool exactly_g2(const Blend& b) {
  return GC::continuity(b.phi, b).g_order >= 2 && GC::continuity(b, b.psi).g_order >= 2;
}

// The exact shape parameter that the decision finds is the one that is reported.
bool beta_is(const CGAL::Exact_rational& found, double reported, int degree) {
  return std::abs(CGAL::to_double(found) - reported) <= 1e-15 * degree;
}

// With beta = eta = 1.
Blend unit_blend(const Curve& phi, const Curve& psi) {
  return GC::representable_blend(phi, psi, GC::Minimal_energy<3>(), {1, 1});
}

double length(const Space::Vector& v) { return std::sqrt(v.squared_length()); }

BOOST_AUTO_TEST_CASE(points_with_digits_to_spare_stay) {
  for (int m = 1; m <= 9; ++m)
    for (int n = 1; n <= 9; ++n)
      for (int i = 0; i < 5; ++i) {
        const Curve phi = random_curve(m, on_grid), psi = random_curve(n, on_grid);
        const Blend b = unit_blend(phi, psi);
        BOOST_CHECK(exactly_g2(b));
        BOOST_CHECK(!b.start_join.is_moved() && !b.end_join.is_moved() && b.phi == phi && b.psi == psi);
        BOOST_CHECK(std::abs(b.start_join.beta - 1) <= 1.0 / 8 && std::abs(b.end_join.beta - 1) <= 1.0 / 8);
        BOOST_CHECK(beta_is(GC::continuity(phi, b).betas()[0], b.start_join.beta, m));
        BOOST_CHECK(beta_is(CGAL::Exact_rational(1) / GC::continuity(b, psi).betas()[0], b.end_join.beta, n));
      }
}

// The shape parameters belong to the parameter of the curves, also on other domains than [0, 1].
BOOST_AUTO_TEST_CASE(domains) {
  for (int m = 1; m <= 5; ++m) {
    const Curve phi = random_curve(m, on_grid), psi = random_curve(3, on_grid), wide = phi.with_domain(0, 4),
                third = psi.with_domain(1, 4);
    const auto strategy = GC::Minimal_energy<3>();
    BOOST_CHECK(GC::representable_blend(wide, psi, strategy, {1, 1}) ==
                GC::representable_blend(phi, psi, strategy, {0.25, 1}));
    const Blend b = GC::representable_blend(wide, third, strategy, {1, 1});
    BOOST_CHECK(exactly_g2(b));
    BOOST_CHECK(std::abs(b.start_join.beta - 1) <= 1.0 / 8 && std::abs(b.end_join.beta - 1) <= 1.0 / 8);
    BOOST_CHECK(beta_is(GC::continuity(wide, b).betas()[0], b.start_join.beta, m));
    BOOST_CHECK(beta_is(CGAL::Exact_rational(1) / GC::continuity(b, third).betas()[0], b.end_join.beta, 3));
  }
}

BOOST_AUTO_TEST_CASE(full_doubles_move_by_half_a_unit) {
  for (int m = 1; m <= 9; ++m)
    for (int i = 0; i < 20; ++i) {
      const Curve phi = random_curve(m, full), psi = random_curve(3, full);
      const Blend b = unit_blend(phi, psi);
      BOOST_CHECK(exactly_g2(b));
      BOOST_CHECK(b.start_join.is_moved() && b.end_join.is_moved());
      for (int x = 0; x < 3; ++x) {
        BOOST_CHECK_LE(b.start_join.grid[x], 0x1p-36); // of 53 digits at least 36 remain
        double moved = 0;
        for (int k = 0; k <= m; ++k) {
          const double change = std::abs(b.phi.control_point(k)[x] - phi.control_point(k)[x]);
          if (k < m - 2) BOOST_CHECK_EQUAL(change, 0);
          moved = std::max(moved, change);
        }
        BOOST_CHECK_LE(moved, b.start_join.grid[x] / 2);
        BOOST_CHECK_LE(moved, b.start_join.moved);
      }
    }
}

// Each strategy, also with other shape parameters: the points are near those of blend().
BOOST_AUTO_TEST_CASE(strategies) {
  const auto check = [](const Curve& phi, const Curve& psi, const auto& strategy, double beta, double eta) {
    const Blend b = GC::representable_blend(phi, psi, strategy, {beta, eta});
    BOOST_CHECK(exactly_g2(b));
    BOOST_CHECK(std::abs(b.start_join.beta / beta - 1) <= 1.0 / 8 && std::abs(b.end_join.beta / eta - 1) <= 1.0 / 8);
    // the blend with the shape parameters that were found differs by the rounding of e only: a 32nd
    // of the legs
    const auto near = GC::blend(phi, psi, strategy, {b.start_join.beta, b.end_join.beta});
    const int m = phi.degree();
    const double leg[2] = {length(phi.control_point(m) - phi.control_point(m - 1)),
                           length(psi.control_point(1) - psi.control_point(0))};
    for (int k = 0; k <= 5; ++k)
      BOOST_CHECK_LE(length(near.control_point(k) - b.control_point(k)), leg[k / 3] / 32 + 1e-12);
  };
  for (int i = 0; i < 20; ++i) {
    const Curve phi = random_curve(1 + i % 7, on_grid), psi = random_curve(2 + i % 5, on_grid);
    check(phi, psi, GC::Matching_second_derivative(), 1, 1);
    check(phi, psi, GC::Normal_offset(), 1.3, 0.7);
    check(phi, psi, GC::Minimal_second_derivative(), 0.01, 100);
    check(phi, psi, GC::Near_line(), 1, 1);
    check(phi, psi, GC::Minimal_energy<2>(), 1, 2);
    check(phi, psi, GC::Minimal_energy<3>(), 3, 1);
    check(phi, psi, GC::Given_parameters<double>{0.25, -0.125}, 1, 1);
  }
}

BOOST_AUTO_TEST_CASE(unlike_sizes) {
  // coordinates of very different sizes, one grid for each
  const Curve phi{Space::Point(1e300, 1e-300, 0), Space::Point(1.1e300, 3e-300, 0), Space::Point(1.3e300, 2e-300, 0)},
      psi{Space::Point(5e299, 1e-300, 1), Space::Point(4e299, 3e-300, 2), Space::Point(7e299, 4e-300, 0.1)};
  const Blend b = unit_blend(phi, psi);
  BOOST_CHECK(exactly_g2(b));
  BOOST_CHECK(b.start_join.grid[0] > 1e280 && b.start_join.grid[0] < 1e287 && b.start_join.grid[1] < 1e-308);
  // subnormal numbers: the grid cannot be finer than they are
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto small = [&](int x) { return std::ldexp(x, 40) * tiny; };
  const Curve left{Space::Point(0, 0, 0), Space::Point(small(3), small(5), 0), Space::Point(small(9), small(4), 0)};
  const Curve right{Space::Point(small(20), 0, 0), Space::Point(small(33), small(5), small(1))};
  BOOST_CHECK(exactly_g2(unit_blend(left, right)));
  // a tangent of one unit in the last place has no digits for a blend
  const Curve stiff{Space::Point(1, 0, 0), Space::Point(std::nextafter(1.0, 2), 0, 0)};
  CHECK_ERROR(unit_blend(stiff, right), not_representable);
  CHECK_ERROR(unit_blend(right, stiff), not_representable);
  const double huge = std::numeric_limits<double>::max();
  const Curve wide{Space::Point(-huge, 0, 0), Space::Point(huge, 0, 0)};
  CHECK_ERROR(unit_blend(wide, right), not_representable);
  CHECK_ERROR(GC::representable_blend(phi, psi, GC::Given_parameters<double>{1e308, 0}), not_representable);
}

// Each moved coordinate stays within half a unit of its grid, and is a multiple of that.
template <class Join> void check_moves(const Curve& given, const Curve& moved, const Join& join) {
  for (int k = 0; k <= given.degree(); ++k)
    for (int x = 0; x < 3; ++x) {
      const CGAL::Exact_rational before(given.control_point(k)[x]), after(moved.control_point(k)[x]),
          unit(join.grid[x]), change = CGAL::abs(CGAL::Exact_rational(after - before));
      BOOST_CHECK(change <= unit / 2 && change <= CGAL::Exact_rational(join.moved));
    }
}

// Positive shape parameters of every size: a blend with exact joins, or the promised error, and
// soon.
BOOST_AUTO_TEST_CASE(tiny_and_huge_shape_parameters) {
  const double least = std::numeric_limits<double>::denorm_min(), most = (std::numeric_limits<double>::max)();
  const Curve phi = random_curve(3, on_grid), psi = random_curve(4, on_grid);
  // straight lines whose legs start in the origin, of a size that makes up for the parameter
  const auto line = [](double size, bool at_end) {
    const Space::Point origin(0, 0, 0), other(size, -3 * size, 2 * size);
    return at_end ? Curve{other, origin} : Curve{origin, other};
  };
  for (const int mode : rounding_modes())
    for (const double beta : {least, 3 * least, 1e-310, 1e-300, 1e300, most / 2, most}) {
      BOOST_TEST_CONTEXT("rounding mode " << mode << ", parameter " << beta) {
        const auto blend = [mode](const Curve& left, const Curve& right, double b, double e) {
          return in_rounding_mode(mode, [&] {
            return GC::representable_blend(left, right, GC::Minimal_second_derivative(), {b, e});
          });
        };
        CHECK_ERROR(blend(phi, psi, beta, 1), not_representable);
        CHECK_ERROR(blend(phi, psi, 1, beta), not_representable);
        const double size = beta < 1 ? 1e300 : 1e-300;
        const Blend b = blend(line(size, true), line(1, false), beta, 1);
        BOOST_CHECK(exactly_g2(b));
        BOOST_CHECK(b.start_join.beta > 0 && std::isfinite(b.start_join.beta));
        BOOST_CHECK(std::abs(b.start_join.beta / beta - 1) <= 1.0 / 8);
        BOOST_CHECK(exactly_g2(blend(line(1, true), line(size, false), 1, beta)));
      }
    }
}

// The error names the number that is beyond the range.
BOOST_AUTO_TEST_CASE(beyond_the_range) {
  typedef GC::Bezier_curve<Plane> Curve_2;
  typedef Plane::Point P;
  const double most = (std::numeric_limits<double>::max)();
  const Curve_2 left = {P(-1, 0), P(0, 0)}, right = {P(2, 1), P(3, 0)}, tiny = {P(-0x1p-1000, 0), P(0, 0)},
                down = {P(1, -2.0364492459650562e+307), P(1, 1)},
                back = {P(5.8460138077065547e+307, 1), P(1, 3.6515641801890792e+307)};
  BOOST_CHECK_EQUAL(error_of([&] {
                      GC::representable_blend(tiny, right, GC::Minimal_second_derivative(), {most, 1});
                    }),
                    "not_representable: representable_blend: end of the first curve: the shape parameter overflows");
  const GC::Given_parameters<CGAL::Exact_rational> far = {CGAL::Exact_rational(1e306), CGAL::Exact_rational(0)};
  BOOST_CHECK_EQUAL(error_of([&] {
                      GC::representable_blend(left, right, far, {1, 1});
                    }),
                    "not_representable: representable_blend: end of the first curve: the strategy chooses a point that "
                    "is too far away");
  BOOST_CHECK_EQUAL(error_of([&] {
                      GC::representable_blend(down, back, GC::Minimal_energy<3>(), {1, 1e-89});
                    }),
                    "not_representable: representable_blend: start of the second curve: no grid leaves room below the "
                    "largest number");
}

BOOST_AUTO_TEST_CASE(near_overflow) {
  const double most = (std::numeric_limits<double>::max)();
  std::mt19937_64 random(7);
  BOOST_TEST_MESSAGE("seed 7");
  int refused = 0, made = 0;
  for (const int mode : rounding_modes())
    for (int i = 0; i < 60; ++i) {
      const auto huge = [&random, most] { // near the largest number, some of them far from it
        const double x = most / 4 * (std::ldexp(static_cast<double>(random() >> 11), -53) * 4);
        const double with_sign = random() % 2 == 0 ? x : -x;
        return std::ldexp(with_sign, -static_cast<int>(random() % 4 == 0 ? random() % 60 : 0));
      };
      const auto curve = [&] {
        std::vector<Space::Point> p;
        for (int k = 0; k < 3; ++k) {
          const double x = huge(), y = huge(), z = huge();
          p.emplace_back(x, y, z);
        }
        return Curve(p.begin(), p.end());
      };
      const Curve phi = curve(), psi = curve();
      try {
        const Blend b = in_rounding_mode(mode, [&] { return unit_blend(phi, psi); });
        ++made;
        BOOST_CHECK(exactly_g2(b));
        for (int x = 0; x < 3; ++x)
          BOOST_CHECK(std::isfinite(b.start_join.grid[x]) && std::isfinite(b.end_join.grid[x]));
        check_moves(phi, b.phi, b.start_join);
        check_moves(psi, b.psi, b.end_join);
      } catch (const GC::Error& e) {
        ++refused;
        BOOST_CHECK(e.code() == GC::Error_code::not_representable);
      }
    }
  BOOST_CHECK(made > 0 && refused > 0);
  // the coordinate x cannot leave the largest numbers: B would lie beyond them
  const Curve wide{Space::Point(-most / 4, 1, 0), Space::Point(most / 4, 3, 0)}, right = random_curve(2, on_grid);
  for (const int mode : rounding_modes())
    CHECK_ERROR(in_rounding_mode(mode,
                                 [&] {
                                   return GC::representable_blend(wide, right, GC::Normal_offset(), {100, 1});
                                 }),
                not_representable);
}

// The rounding of points does not depend on the rounding mode.
BOOST_AUTO_TEST_CASE(rounding) {
  for (int i = 0; i < 30; ++i) {
    const Curve phi = random_curve(1 + i % 5, full), psi = random_curve(3, full);
    const Blend nearest = GC::representable_blend(phi, psi);
    for (const int mode : rounding_modes()) {
      const Blend b = in_rounding_mode(mode, [&] { return GC::representable_blend(phi, psi); });
      BOOST_CHECK(exactly_g2(b));
      check_moves(phi, b.phi, b.start_join);
      check_moves(psi, b.psi, b.end_join);
      BOOST_CHECK(b == nearest && b.phi == nearest.phi && b.psi == nearest.psi);
    }
  }
}

BOOST_AUTO_TEST_CASE(other_spaces) {
  typedef GC::Bezier_curve<Plane, 3> Cubic;
  const Cubic phi{Plane::Point(0, 0), Plane::Point(0.1, 0.7), Plane::Point(0.4, 0.9), Plane::Point(0.9, 1)},
      psi{Plane::Point(2, 0.3), Plane::Point(2.2, 0.1), Plane::Point(2.4, 0.2), Plane::Point(2.9, 0.3)};
  const GC::Representable_blend<Plane> b = GC::representable_blend(phi, psi);
  BOOST_CHECK(GC::continuity(b.phi, b).g_order >= 2 && GC::continuity(b, b.psi).g_order >= 2);
  typedef GC::Traits_2<CGAL::Simple_cartesian<float>> Short;
  const GC::Bezier_curve<Short> left{Short::Point(0, 0), Short::Point(1, 2), Short::Point(3, 3)},
      right{Short::Point(5, 1), Short::Point(6, -1)};
  const GC::Representable_blend<Short> c = GC::representable_blend(left, right);
  typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Rational;
  const auto exact = [](const auto& curve) {
    std::vector<Rational::Point> points;
    for (const Short::Point& p : curve) points.emplace_back(p.x(), p.y());
    return GC::Bezier_curve<Rational>(points.begin(), points.end());
  };
  BOOST_CHECK(GC::continuity(exact(c.phi), exact(c)).g_order >= 2);
  BOOST_CHECK(GC::continuity(exact(c), exact(c.psi)).g_order >= 2);
}

BOOST_AUTO_TEST_CASE(errors) {
  const Curve good = random_curve(3, on_grid), point{Space::Point(1, 2, 3)},
              cusp{Space::Point(0, 0, 0), Space::Point(1, 0, 0), Space::Point(1, 0, 0)};
  CHECK_ERROR(GC::representable_blend(good, good, GC::Normal_offset(), {0, 1}), nonpositive_beta);
  CHECK_ERROR(GC::representable_blend(cusp, good, GC::Normal_offset(), {1, -1}), nonpositive_beta);
  CHECK_ERROR(GC::representable_blend(cusp, good), zero_tangent);
  CHECK_ERROR(GC::representable_blend(good, cusp.reverse()), zero_tangent);
  CHECK_ERROR(GC::representable_blend(point, good), wrong_number_of_points);
  CHECK_ERROR(GC::representable_blend(good, point), wrong_number_of_points);
  CHECK_ERROR(GC::representable_blend(good, good, GC::Normal_offset(), {infinity, 1}), not_finite);
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_ERROR(GC::representable_blend(good, good, GC::Given_parameters<double>{x, 0}), not_finite);
    CHECK_ERROR(GC::representable_blend(good, good, GC::Given_parameters<double>{0, x}), not_finite);
  }
}

// The default is the automatic shape.
BOOST_AUTO_TEST_CASE(automatic_shape) {
  for (int m = 1; m <= 9; ++m)
    for (int i = 0; i < 10; ++i) {
      const Curve phi = random_curve(m, on_grid), psi = random_curve(3, on_grid);
      const Blend b = GC::representable_blend(phi, psi);
      BOOST_CHECK(exactly_g2(b));
      const GC::Shape_parameters<double> shape = GC::automatic_shape(phi.end_jet(1), psi.start_jet(1));
      BOOST_CHECK(std::abs(b.start_join.beta / shape.beta - 1) <= 1.0 / 8);
      BOOST_CHECK(std::abs(b.end_join.beta / shape.eta - 1) <= 1.0 / 8);
    }
}

BOOST_AUTO_TEST_SUITE_END()
