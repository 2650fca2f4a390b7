// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hagen 1.7 (b): the curvatures determine a curve up to an isometry.

#define BOOST_TEST_MODULE curve_from_curvatures

#include "support/jets.h"

#include <CGAL/Geometric_continuity/curves/curve_from_curvatures.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
const double pi = std::acos(-1.);

// The largest distance of the samples, or of points of the Bezier curve, from the exact curve x(s).
template <class Traits, class Exact> double sample_error(const GC::Integrated_curve<Traits>& curve, Exact x) {
  double worst = 0;
  for (const GC::Framed_point<Traits>& sample : curve.samples) {
    const Column<Traits> d = GC::coordinates<Traits>(sample.point) - x(sample.s);
    worst = std::max(worst, std::sqrt(dot(d, d)));
  }
  return worst;
}
// In the middle of a segment the interpolant is farthest from the curve.
template <class Traits, class Exact> double curve_error(const GC::Integrated_curve<Traits>& curve, Exact x) {
  const GC::Composite_bezier_curve<Traits, 5> bezier = curve.bezier_curve();
  double worst = 0;
  for (int l = 0; l < bezier.number_of_segments(); ++l) {
    const double s = (bezier.knots()[l] + bezier.knots()[l + 1]) / 2;
    const Column<Traits> d = GC::coordinates<Traits>(bezier(s)) - x(s);
    worst = std::max(worst, std::sqrt(dot(d, d)));
  }
  return worst;
}

// Integrates with several tolerances and compares with the exact curve. `sixth` bounds |x^(6)|.
template <class Traits, class Curvatures, class Exact>
void check_integration(const Curvatures& kappa, const Jet<Traits>& start, double length, double sixth, Exact x) {
  const int n = start.dimension();
  const GC::Frenet_frame<Traits> frame = *GC::frenet_frame(start);
  double previous = 0;
  for (double tolerance : {1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    const GC::Integrated_curve<Traits> curve =
        GC::curve_from_curvatures(kappa, start.point(), frame, length, tolerance);
    const int steps = static_cast<int>(curve.samples.size()) - 1;
    // In each step, some 20 roundings of numbers of the size of the coordinates.
    const double rounding = 20 * unit * steps * (length + std::sqrt(dot(start[0], start[0])));
    const double error = sample_error<Traits>(curve, x);
    BOOST_TEST_MESSAGE("  dimension " << n << ", tolerance " << tolerance << ": " << steps << " steps, error " << error
                                      << ", bound " << curve.error_bound);
    BOOST_CHECK_LE(error, curve.error_bound + rounding);
    BOOST_CHECK_CLOSE(curve.error_bound, steps * tolerance * (std::sqrt(n) + std::sqrt(2) * n * length), 1e-10);
    // The estimates are those of a method of order 4, the result has order 5: the error is far
    // below one tolerance a step.
    BOOST_CHECK_LE(error, steps * tolerance / 4 + rounding);
    // The fifth order of the method divides the error by about 100^(5/6) = 46 with the tolerance,
    // when rounding and the upper limit of the step are out of sight.
    if (previous > 0 && steps > 32 && error > rounding) BOOST_CHECK_LE(error, previous / 10);
    previous = error;

    BOOST_CHECK_EQUAL(curve.samples.front().s, 0);
    BOOST_CHECK_EQUAL(curve.samples.back().s, length);
    double h = 0;
    for (int i = 1; i <= steps; ++i) h = std::max(h, curve.samples[i].s - curve.samples[i - 1].s);
    BOOST_CHECK_LE(h, length / 16 * (1 + 4 * unit));
    // The frames add an error of the size of that of the points.
    BOOST_CHECK_LE(curve_error<Traits>(curve, x), 2 * error + std::pow(h, 6) / 46080 * sixth + rounding);

    // orthonormal, whatever the tolerance
    for (const GC::Framed_point<Traits>& sample : curve.samples)
      for (int i = 1; i <= n; ++i)
        for (int j = 1; j <= i; ++j)
          BOOST_CHECK_SMALL(dot(sample.frame.coordinates(i), sample.frame.coordinates(j)) - (i == j), 32 * n * unit);
  }
}

// Points of a curve with given coordinate functions.
template <class Traits, class... Function> auto coordinate_functions(Function... f) {
  return [=](double s) {
    Column<Traits> x(static_cast<int>(sizeof...(f)));
    int i = 0;
    ((x[i++] = f(s)), ...);
    return x;
  };
}

typedef std::vector<std::function<double(double)>> Functions;

// int_0^s exp(i (u^2/2 + b u)) du by its Taylor series with 50 digits: Fresnel's integrals.
std::pair<double, double> fresnel(double s, double b) {
  typedef boost::multiprecision::cpp_bin_float_50 Real;
  // The k-th derivative f_k of f(u) = exp(i (u^2/2 + b u)) at 0: f' = i (u + b) f gives f_{k+1} = i
  // (b f_k + k f_{k-1}).
  Real re(1), im(0), re_before(0), im_before(0), term(s), x(0), y(0);
  for (int k = 0; abs(term) * (abs(re) + abs(im) + abs(re_before) + abs(im_before)) > 1e-20; ++k) {
    x += re * term; // s^{k+1} / (k+1)!
    y += im * term;
    const Real re_next = -(Real(b) * im + k * im_before), im_next = Real(b) * re + k * re_before;
    re_before = re;
    im_before = im;
    re = re_next;
    im = im_next;
    term *= Real(s) / (k + 2);
  }
  return {static_cast<double>(x), static_cast<double>(y)};
}

BOOST_AUTO_TEST_CASE(circle) {
  const double r = 2;
  const auto kappa = [=](double) { return 1 / r; };
  check_integration<Double_2>(kappa, jet<Double_2>(2, {{2, 0}, {0, 1}}), 2 * pi * r, 1 / std::pow(r, 5),
                              coordinate_functions<Double_2>([=](double s) { return r * std::cos(s / r); },
                                                             [=](double s) { return r * std::sin(s / r); }));
  // in a plane of space, with no torsion
  const Functions kappas = {kappa, [](double) { return 0.; }};
  check_integration<Double_3>(kappas, jet<Double_3>(3, {{2, 0, 7}, {0, 1}, {-1}}), 2 * pi * r, 1 / std::pow(r, 5),
                              coordinate_functions<Double_3>([=](double s) { return r * std::cos(s / r); },
                                                             [=](double s) { return r * std::sin(s / r); },
                                                             [](double) { return 7.; }));
}

BOOST_AUTO_TEST_CASE(line) {
  const GC::Integrated_curve<Double_2> curve = GC::curve_from_curvatures<Double_2>([](double) { return 0.; }, 3.);
  for (const GC::Framed_point<Double_2>& sample : curve.samples) {
    BOOST_CHECK_SMALL(sample.point.x() - sample.s, 1e-14); // some 16 roundings of numbers up to 3
    BOOST_CHECK_EQUAL(sample.point.y(), 0);
  }
}

BOOST_AUTO_TEST_CASE(helix) {
  for (double b : {1., -1.}) { // of both hands
    const double a = 2, c = std::sqrt(a * a + b * b);
    const auto kappas = [=](double) { return std::array<double, 2>{a / (c * c), b / (c * c)}; };
    Jet<Double_3> start = jet<Double_3>(3, {{2, 0, 0}, {0, 2, 0}, {-2, 0, 0}});
    start[1][2] = b;
    check_integration<Double_3>(kappas, start, 20, a / std::pow(c, 6),
                                coordinate_functions<Double_3>([=](double s) { return a * std::cos(s / c); },
                                                               [=](double s) { return a * std::sin(s / c); },
                                                               [=](double s) { return b * s / c; }));
  }
}

BOOST_AUTO_TEST_CASE(clothoid) {
  // kappa = s + b, from an S with a point of inflection to an arc; |x^(6)| <= kappa^5 + 10
  // kappa^3 + 15 kappa (Faa di Bruno)
  for (double b : {0., -2., 1.}) {
    const double most = std::max(5 + b, -b), sixth = std::pow(most, 5) + 10 * std::pow(most, 3) + 15 * most;
    check_integration<Double_2>([=](double s) { return s + b; }, jet<Double_2>(2, {{0}, {1, 0}}), 5, sixth,
                                coordinate_functions<Double_2>([=](double s) { return fresnel(s, b).first; },
                                                               [=](double s) { return fresnel(s, b).second; }));
  }
}

BOOST_AUTO_TEST_CASE(slope_curve_over_a_clothoid) {
  // It rises with the constant slope sin a = 4/5: kappa = 3/5 (s + 1), tau = 4/5 (s + 1); |x^(6)|
  // as before, with s + 1 <= 4.
  const Functions kappas = {[](double s) { return 0.6 * (s + 1); }, [](double s) { return 0.8 * (s + 1); }};
  check_integration<Double_3>(kappas, jet<Double_3>(3, {{0, 0, 0}, {3, 0, 4}, {0, 1, 0}}), 3, 0.6 * 1724,
                              coordinate_functions<Double_3>([](double s) { return 0.6 * fresnel(s, 1).first; },
                                                             [](double s) { return 0.6 * fresnel(s, 1).second; },
                                                             [](double s) { return 0.8 * s; }));
}

// (a cos s, a sin s, b cos 2s, b sin 2s, c s) with a^2 + 4 b^2 + c^2 = 1 has unit speed and
// constant curvatures.
BOOST_AUTO_TEST_CASE(two_circles_in_four_dimensions_and_a_line_in_five) {
  for (const int n : {4, 5}) {
    const double a = n == 4 ? 0.6 : 0.48, b = n == 4 ? 0.4 : 0.32;
    const auto at = [&](double s, int k) {
      Jet<Double_d> x = zero_jet<Double_d>(n, k);
      for (int j = 0; j <= k; ++j) {
        const double c[] = {std::cos(s + j * pi / 2), std::sin(s + j * pi / 2), std::cos(2 * s + j * pi / 2),
                            std::sin(2 * s + j * pi / 2)};
        for (int i = 0; i < 4; ++i) x[j][i] = (i < 2 ? a : b * std::pow(2, j)) * c[i];
        if (n == 5) x[j][4] = j == 0 ? 0.6 * s : j == 1 ? 0.6 : 0;
      }
      return x;
    };
    const Jet<Double_d> start = at(0, n);
    std::vector<double> kappa;
    for (const auto& k : GC::frenet_curvatures(start)) kappa.push_back(k->sign * std::sqrt(k->square));
    BOOST_CHECK_SMALL(kappa[0] - std::sqrt(a * a + 16 * b * b), 1e-14); // |x''|, with a few roundings
    check_integration<Double_d>([&](double) { return kappa; }, start, n == 4 ? 7 : 5, a + 64 * b,
                                [&](double s) { return at(s, 0)[0]; });
  }
}

BOOST_AUTO_TEST_CASE(joins_of_the_bezier_curve) {
  const Functions kappas = {[](double s) { return 1.5 + std::sin(s); }, [](double s) { return std::cos(2 * s); }};
  for (double tolerance : {1e-6, 1e-10}) {
    const GC::Integrated_curve<Double_3> curve = GC::curve_from_curvatures<Double_3>(kappas, 8., tolerance);
    const GC::Composite_bezier_curve<Double_3, 5> bezier = curve.bezier_curve();
    BOOST_REQUIRE_EQUAL(bezier.number_of_segments(), static_cast<int>(curve.samples.size()) - 1);
    for (int i = 0; i <= bezier.number_of_segments(); ++i) {
      const GC::Framed_point<Double_3>& sample = curve.samples[i];
      BOOST_CHECK_EQUAL(bezier.knots()[i], sample.s);
      BOOST_CHECK_EQUAL(sample.curvatures[0], kappas[0](sample.s));
      BOOST_CHECK_EQUAL(sample.curvatures[1], kappas[1](sample.s));
      double h = 8; // of the shorter neighbour
      if (i > 0) h = std::min(h, bezier.lambda(i - 1));
      if (i < bezier.number_of_segments()) h = std::min(h, bezier.lambda(i));
      // Control points of modulus at most 8 carry 8 roundings each; 20 (b2 - 2 b1 + b0) / h^2
      // multiplies them by 80 / h^2.
      const double bound = 80 / (h * h) * 8 * 8 * unit;
      for (const Jet<Double_3>& x : {bezier.left_jet(sample.s, 2), bezier.right_jet(sample.s, 2)})
        for (int j = 0; j <= 2; ++j)
          for (int l = 0; l < 3; ++l) BOOST_CHECK_SMALL(x[j][l] - sample.jet()[j][l], j == 0 ? 1e-300 : bound);
      // kappa e_2 = x'' up to the tangential part, for a unit tangent
      const Column<Double_3> k = GC::coordinates<Double_3>(*GC::curvature_vector(bezier.right_jet(sample.s, 2)));
      BOOST_CHECK_SMALL(std::sqrt(dot(k, k)) - sample.curvatures[0], 8 * bound);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_curve_has_the_given_curvatures) {
  // Between the samples the second derivative of the interpolant is in error by h^4/1920 |x^(6)|,
  // the third by h^3/120.
  const Functions kappas = {[](double s) { return 1.5 + std::sin(s); }, [](double s) { return std::cos(2 * s); }};
  const auto errors = [&](double tolerance) {
    const auto bezier = GC::curve_from_curvatures<Double_3>(kappas, 8., tolerance).bezier_curve();
    std::pair<double, double> worst(0, 0);
    for (int l = 0; l < bezier.number_of_segments(); ++l) {
      const double s = (bezier.knots()[l] + bezier.knots()[l + 1]) / 2;
      const Jet<Double_3> x = bezier.jet(s, 3);
      worst.first = std::max(worst.first, std::abs(std::sqrt(*GC::curvature_squared(x)) - kappas[0](s)));
      worst.second = std::max(worst.second, std::abs(*GC::torsion(x) - kappas[1](s)));
    }
    BOOST_TEST_MESSAGE("  tolerance " << tolerance << ": curvature " << worst.first << ", torsion " << worst.second);
    return worst;
  };
  const std::pair<double, double> coarse = errors(1e-6), fine = errors(1e-10);
  // h shrinks by 10^(4/6) or more, its fourth power by 464 and its third by 100
  BOOST_CHECK_LE(fine.first, coarse.first / 100);
  BOOST_CHECK_LE(fine.second, coarse.second / 20);
  BOOST_CHECK_LE(fine.first, 1e-5);
  BOOST_CHECK_LE(fine.second, 1e-3);
}

BOOST_AUTO_TEST_CASE(equal_curvatures_give_congruent_curves) {
  const Functions kappas = {[](double s) { return 1 + s * s; }, [](double s) { return 1 - s; }};
  const Jet<Double_3> x = jet<Double_3>(3, {{0}, {1}, {0, 1}}),
                      y = jet<Double_3>(3, {{1, 2, 3}, {2, 1, -2}, {1, 5, 0}});
  const GC::Frenet_frame<Double_3> e = GC::frenet_frame(x)->normalized(), f = GC::frenet_frame(y)->normalized();
  std::vector<Column<Double_3>> rows(3, Column<Double_3>(3)); // sum f_i e_i^T
  for (int i = 1; i <= 3; ++i)
    for (int j = 0; j < 3; ++j) rows[j] += f.coordinates(i)[j] * e.coordinates(i);
  const GC::Isometry<Double_3> map(rows, y[0]);
  const GC::Integrated_curve<Double_3> first = GC::curve_from_curvatures(kappas, x.point(), *GC::frenet_frame(x), 2.),
                                       second = GC::curve_from_curvatures(kappas, y.point(), *GC::frenet_frame(y), 2.);
  const Column<Double_3> d = GC::coordinates<Double_3>(map(first.samples.back().point)) -
                             GC::coordinates<Double_3>(second.samples.back().point);
  BOOST_CHECK_LE(std::sqrt(dot(d, d)), first.error_bound + second.error_bound);
  // the opposite torsion gives the mirrored curve
  const Functions opposite = {kappas[0], [](double s) { return s - 1; }};
  const GC::Integrated_curve<Double_3> third = GC::curve_from_curvatures(opposite, x.point(), *GC::frenet_frame(x), 2.);
  const Double_3::Point p = first.samples.back().point, q = third.samples.back().point;
  BOOST_CHECK_LE(std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() + q.z()), 2 * first.error_bound);
  BOOST_CHECK_GT(std::abs(p.z()), 0.1);
}

BOOST_AUTO_TEST_CASE(initial_frames) {
  const Functions kappas = {[](double) { return 1.; }, [](double) { return 1.; }};
  // only the order and the directions of the first n-1 vectors count
  const std::vector<Column<Double_3>> e = {column<Double_3>(3, {0, 0, 2}), column<Double_3>(3, {5, 0, 1}),
                                           column<Double_3>(3, {0, -1, 0})};
  const Double_3::Point origin(0, 0, 0);
  const GC::Frenet_frame<Double_3> frame =
      GC::curve_from_curvatures(kappas, origin, GC::Frenet_frame<Double_3>(e), 1.).samples[0].frame;
  BOOST_CHECK(frame.coordinates(1) == column<Double_3>(3, {0, 0, 1}));
  BOOST_CHECK(frame.coordinates(2) == column<Double_3>(3, {1, 0, 0}));
  BOOST_CHECK(frame.coordinates(3) == column<Double_3>(3, {0, 1, 0}));
  const std::vector<Column<Double_3>> singular = {e[0], e[0], e[2]};
  CHECK_ERROR(GC::curve_from_curvatures(kappas, origin, GC::Frenet_frame<Double_3>(singular), 1.), singular_frame);
}

BOOST_AUTO_TEST_CASE(curvatures_that_are_refused) {
  const auto plane = [](auto kappa, double length = 1, double tolerance = 1e-8) {
    return GC::curve_from_curvatures<Double_2>(kappa, length, tolerance).samples.size();
  };
  const auto space = [](std::function<double(double)> kappa, std::function<double(double)> tau) {
    return GC::curve_from_curvatures<Double_3>(Functions{kappa, tau}, 1.).samples.size();
  };
  const auto one = [](double) { return 1.; };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

  // in the plane any sign, in space kappa > 0 and any torsion
  BOOST_CHECK_GT(plane([](double s) { return 0.5 - s; }), 16);
  BOOST_CHECK_GT(space(one, [](double s) { return 0.5 - s; }), 16);
  CHECK_ERROR(space([](double s) { return 0.5 - s; }, one), nonpositive_curvature);
  CHECK_ERROR(space([](double s) { return s; }, one), nonpositive_curvature);
  CHECK_ERROR(GC::curve_from_curvatures<Double_d>(Functions{one, [](double s) { return 0.5 - s; }, one}, 1.),
              nonpositive_curvature);
  CHECK_ERROR(plane([=](double s) { return s > 0.5 ? nan : 1; }), not_finite);
  CHECK_ERROR(space(one, [=](double s) { return s > 0.5 ? inf : 1; }), not_finite);
  CHECK_ERROR(space([=](double) { return nan; }, one), not_finite);

  CHECK_ERROR(GC::curve_from_curvatures<Double_3>(one, 1.), dimension_mismatch);
  CHECK_ERROR(GC::curve_from_curvatures<Double_d>(Functions(), 1.), dimension_mismatch);
  int calls = 0;
  CHECK_ERROR(
      GC::curve_from_curvatures<Double_3>([&](double) { return std::vector<double>(++calls > 9 ? 3 : 2, 1.); }, 1.),
      dimension_mismatch);
  const GC::Frenet_frame<Double_d> frame = *GC::frenet_frame(jet<Double_d>(2, {{0}, {1}}));
  CHECK_ERROR(GC::curve_from_curvatures(one, jet<Double_d>(3, {{0}}).point(), frame, 1.), dimension_mismatch);

  for (double length : {0., -1.}) CHECK_ERROR(plane(one, length), empty_domain);
  for (double length : {nan, inf}) CHECK_ERROR(plane(one, length), not_finite);
  CHECK_ERROR(plane(one, 1, std::numeric_limits<double>::infinity()), not_finite);
  for (double tolerance : {0., -1., nan, 1e-17}) CHECK_ERROR(plane(one, 1, tolerance), unreachable_tolerance);
  BOOST_CHECK_GT(plane(one, 1, 2.3e-16), 16);
  // a jump of the curvature is passed, where it becomes infinite no step is small enough
  BOOST_CHECK_GT(plane([](double s) { return s < 0.3 ? 1. : -1.; }), 16);
  CHECK_ERROR(plane([](double s) { return 1 / (0.3 - s); }), unreachable_tolerance);
  // more than the largest number of steps
  CHECK_ERROR(plane([](double) { return 1e6; }), unreachable_tolerance);
}

BOOST_AUTO_TEST_CASE(samples_that_are_no_curve) {
  GC::Integrated_curve<Double_d> curve{{}, 0};
  CHECK_ERROR(curve.bezier_curve(), wrong_number_of_points);
  const auto one = [](double) { return 1.; };
  const GC::Integrated_curve<Double_d> arc = GC::curve_from_curvatures<Double_d>(Functions{one}, 1.);
  curve.samples.push_back(arc.samples[0]);
  CHECK_ERROR(curve.bezier_curve(), wrong_number_of_points);
  curve.samples.push_back(arc.samples[0]);
  CHECK_ERROR(curve.bezier_curve(), empty_domain);
  curve.samples[1] = arc.samples[1];
  BOOST_CHECK_EQUAL(curve.bezier_curve().number_of_segments(), 1);
  curve.samples[1].curvatures.clear();
  CHECK_ERROR(curve.samples[1].jet(), dimension_mismatch);
  CHECK_ERROR(curve.bezier_curve(), dimension_mismatch);
  const GC::Framed_point<Double_d> on_line{
      0, arc.samples[0].point, GC::Frenet_frame<Double_d>({column<Double_d>(1, {1})}), {1.}};
  CHECK_ERROR(on_line.jet(), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(arguments_stay_in_the_domain) {
  const double length = 0.7;
  double low = 1, high = 0;
  GC::curve_from_curvatures<Double_2>(
      [&](double s) {
        low = std::min(low, s);
        high = std::max(high, s);
        return 1 + s;
      },
      length, 1e-12);
  BOOST_CHECK_EQUAL(low, 0);
  BOOST_CHECK_EQUAL(high, length);
}
