// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Hagen 1.7: the curvatures determine a curve up to an isometry, and the remarks after 2.1.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE fundamental_theorem
#include <boost/test/unit_test.hpp>

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/curves/curve_from_curvatures.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/local/congruence.h>
#include <CGAL/Geometric_continuity/local/frenet_equations.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;
typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
typedef GC::Traits_d<CGAL::Cartesian_d<double>> Double_d;
typedef GC::Traits_3<Epick> Epick_3;

template <class Traits> using Jet = GC::Curve_jet<Traits>;
template <class Traits> using Column = GC::Coordinates<Traits>;
template <class Traits> using Composite = GC::Composite_bezier_curve<Traits>;
typedef GC::Continuity_kind Kind;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

template <class Traits> Column<Traits> column(int d, std::initializer_list<int> x) {
  Column<Traits> c(d);
  int i = 0;
  for (int value : x)
    if (i < d) c[i++] = typename Traits::FT(value);
  return c;
}

template <class Traits> Jet<Traits> zero_jet(int d, int k) {
  return Jet<Traits>(GC::Coordinate_jet<typename Traits::FT, GC::dimension_v<Traits>>(d, k));
}

template <class Traits> Jet<Traits> jet(int d, std::initializer_list<std::initializer_list<int>> rows) {
  Jet<Traits> x = zero_jet<Traits>(d, static_cast<int>(rows.size()) - 1);
  int j = 0;
  for (const std::initializer_list<int>& row : rows) x[j++] = column<Traits>(d, row);
  return x;
}

template <class Traits> Jet<Traits> truncated(const Jet<Traits>& x, int k) {
  Jet<Traits> y = zero_jet<Traits>(x.dimension(), k);
  for (int j = 0; j <= k; ++j) y[j] = x[j];
  return y;
}

class Random {
  std::mt19937 engine_{20262};

public:
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Q rational() { return ratio<Q>(integer(-99, 99), integer(1, 99)); }
  template <class Traits> Column<Traits> column(int d) {
    Column<Traits> c(d);
    for (int i = 0; i < d; ++i) c[i] = rational();
    return c;
  }
  // with independent derivatives
  template <class Traits> Jet<Traits> jet(int d, int k) {
    for (;;) {
      Jet<Traits> x = zero_jet<Traits>(d, k);
      for (int j = 0; j <= k; ++j) x[j] = column<Traits>(d);
      if (GC::gram_determinants(x, std::min(k, d)).back() != Q(0)) return x;
    }
  }
  // In space the rotation of a quaternion, otherwise a product of rotations in all coordinate planes; and a translation.
  template <class Traits> GC::Isometry<Traits> isometry(int d) {
    std::vector<Column<Traits>> rows(d, Column<Traits>(d));
    for (int i = 0; i < d; ++i) rows[i][i] = Q(1);
    if (d == 3) {
      const Q a = rational(), b = rational(), c = rational(), e(1);
      const Q n = a * a + b * b + c * c + e * e, two(2);
      const Q entries[3][3] = {
          {Q(1) - two * (b * b + c * c) / n, two * (a * b - c * e) / n, two * (a * c + b * e) / n},
          {two * (a * b + c * e) / n, Q(1) - two * (a * a + c * c) / n, two * (b * c - a * e) / n},
          {two * (a * c - b * e) / n, two * (b * c + a * e) / n, Q(1) - two * (a * a + b * b) / n}};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[i][j] = entries[i][j];
    } else
      for (int i = 0; i < d; ++i)
        for (int j = i + 1; j < d; ++j) {
          const Q t = rational(), n = Q(1) + t * t, c = (Q(1) - t * t) / n, s = Q(2) * t / n;
          const Column<Traits> p = rows[i], q = rows[j];
          rows[i] = c * p - s * q;
          rows[j] = s * p + c * q;
        }
    return GC::Isometry<Traits>(rows, column<Traits>(d));
  }
};

// The last coordinate with the opposite sign.
template <class Traits> Jet<Traits> mirrored(Jet<Traits> x) {
  for (int j = 0; j <= x.order(); ++j) x[j][x.dimension() - 1] *= typename Traits::FT(-1);
  return x;
}

template <class Traits> bool same_map(const GC::Isometry<Traits>& f, const GC::Isometry<Traits>& g) {
  for (int i = 0; i < f.dimension(); ++i)
    for (int j = 0; j < f.dimension(); ++j)
      if (f.entry(i, j) != g.entry(i, j)) return false;
  return GC::coordinates<Traits>(f.translation()) == GC::coordinates<Traits>(g.translation());
}

// test(Traits(), d) in all dimensions from 2 to 5, with exact rational numbers
template <class Test> void in_every_exact_space(Test test) {
  test(Exact_2(), 2);
  test(Exact_3(), 3);
  test(Exact_d(), 3);
  test(Exact_d(), 4);
  test(Exact_d(), 5);
}

} // namespace

// --------------------------------------------------------------------------------------------------------- 1.7 (a)

BOOST_AUTO_TEST_CASE(a_moved_jet_gives_back_the_motion) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    for (int k = d; k <= d + 2; ++k)
      for (int round = 0; round < 3; ++round) {
        const Jet<Traits> x = random.template jet<Traits>(d, k);
        const GC::Isometry<Traits> motion = random.template isometry<Traits>(d);
        const std::optional<GC::Isometry<Traits>> found = GC::congruence(x, motion(x));
        BOOST_REQUIRE(found);
        BOOST_CHECK(same_map<Traits>(*found, motion));
        BOOST_CHECK((*found)(x) == motion(x));
        const typename Traits::Point p = GC::to_point<Traits>(random.template column<Traits>(d));
        BOOST_CHECK((*found)(p) == motion(p));
        BOOST_CHECK((*found)(x.derivative(1)) == motion(x).derivative(1));
        // it is the identity on the same jet
        BOOST_CHECK((*GC::congruence(x, x))(p) == p);
      }
  });
}

BOOST_AUTO_TEST_CASE(the_motion_is_orthogonal_with_determinant_1) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    // jets of order n-1 do not see the last curvature, so that mirrored ones are congruent
    const Jet<Traits> x = random.template jet<Traits>(d, d - 1);
    for (const Jet<Traits>& y : {random.template isometry<Traits>(d)(x), mirrored<Traits>(x)}) {
      const std::optional<GC::Isometry<Traits>> b = GC::congruence(x, y);
      BOOST_REQUIRE(b);
      BOOST_CHECK((*b)(x) == y);
      for (int i = 0; i < d; ++i)
        for (int j = 0; j < d; ++j) {
          Q sum(0);
          for (int l = 0; l < d; ++l) sum += b->entry(i, l) * b->entry(j, l);
          BOOST_CHECK_EQUAL(sum, Q(i == j ? 1 : 0));
        }
      BOOST_CHECK_EQUAL(GC::determinant<Q>(d, [&](int i, int j) { return b->entry(i, j); }), Q(1));
    }
  });
}

BOOST_AUTO_TEST_CASE(other_jets_are_not_congruent) {
  Random random;
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    for (int k = d; k <= d + 2; ++k) {
      const Jet<Traits> x = random.template jet<Traits>(d, k), y = random.template isometry<Traits>(d)(x);
      // the last curvature of a mirrored curve is the opposite: Hagen's "unique isometry" preserves orientation
      BOOST_CHECK(!GC::congruence(x, mirrored<Traits>(y)));
      BOOST_CHECK(GC::congruence(x, truncated<Traits>(mirrored<Traits>(y), d - 1)));
      for (int j = 1; j <= k; ++j)
        for (int i = 0; i < d; ++i) {
          Jet<Traits> z = y;
          z[j][i] += ratio<Q>(1, 1000000007);
          BOOST_CHECK(!GC::congruence(x, z));
          if (j >= d) BOOST_CHECK(GC::congruence(x, truncated<Traits>(z, j - 1)));
        }
      for (int j = d; j <= k; ++j) { // with the same determinants, but other dot products
        Jet<Traits> z = y;
        z[j] += y[1];
        BOOST_CHECK(!GC::congruence(x, z));
      }
      const Column<Traits> normal = GC::frenet_frame(y)->coordinates(d);
      for (int j = d; j <= k; ++j) { // with the same dot products, but another determinant
        Jet<Traits> z = y;
        z[j] -= Q(2 * dot(y[j], normal) / dot(normal, normal)) * normal;
        BOOST_CHECK(!GC::congruence(x, z));
      }
      // equal invariants with another speed
      Jet<Traits> fast = y;
      Q factor(1);
      for (int j = 0; j <= k; ++j) {
        fast[j] *= factor;
        factor *= Q(2);
      }
      BOOST_CHECK(!GC::congruence(x, fast));
    }
    if (d > 2) { // derivatives of equal lengths at other angles
      const Jet<Traits> x = random.template jet<Traits>(d, d - 1);
      Jet<Traits> y = x;
      y[2] = random.template isometry<Traits>(d)(x)[2];
      BOOST_CHECK(!GC::congruence(x, y));
    }
    // a mirrored curve in a hyperplane is congruent: its last curvature is 0
    Jet<Traits> flat = random.template jet<Traits>(d, d - 1);
    for (int j = 0; j < d; ++j) flat[j][d - 1] = Q(0);
    if (GC::gram_determinants(flat, d - 1).back() != Q(0)) {
      Jet<Traits> x = zero_jet<Traits>(d, d);
      for (int j = 0; j < d; ++j) x[j] = flat[j];
      x[d] = flat[1];
      Jet<Traits> y = x;
      for (int j = 0; j <= d; ++j) y[j][0] *= Q(-1);
      BOOST_CHECK((*GC::congruence(x, y))(x) == y);
    }
  });
}

BOOST_AUTO_TEST_CASE(jets_that_are_refused) {
  in_every_exact_space([&](auto traits, int d) {
    typedef decltype(traits) Traits;
    Random random;
    const Jet<Traits> x = random.template jet<Traits>(d, d);
    Jet<Traits> line = x;
    for (int j = 2; j <= d; ++j) line[j] = Q(j) * x[1];
    Jet<Traits> point = x;
    point[1] = Column<Traits>(d);
    if (d > 2) { // in the plane the tangent alone is the frame
      CHECK_ERROR(GC::congruence(line, line), singular_frame);
      CHECK_ERROR(GC::congruence(x, line), singular_frame);
      CHECK_ERROR(GC::congruence(line, x), singular_frame);
    } else
      BOOST_CHECK(GC::congruence(line, line));
    CHECK_ERROR(GC::congruence(point, x), singular_frame);
    CHECK_ERROR(GC::congruence(x, point), singular_frame);
    CHECK_ERROR(GC::congruence(x, truncated<Traits>(x, d - 2)), jet_order_too_low);
    CHECK_ERROR(GC::congruence(truncated<Traits>(x, d - 2), x), jet_order_too_low);
    CHECK_ERROR(GC::congruence(Jet<Traits>(), Jet<Traits>()), jet_order_too_low);
  });
  CHECK_ERROR(GC::congruence(jet<Exact_d>(3, {{0}, {1}, {0, 1}}), jet<Exact_d>(2, {{0}, {1}, {0, 1}})),
              dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(one_jet_moves_the_whole_curve) {
  Random random;
  std::vector<Exact_3::Point> b;
  for (int i = 0; i <= 4; ++i) b.push_back(GC::to_point<Exact_3>(random.column<Exact_3>(3)));
  const Composite<Exact_3> curve(b.begin(), b.end(), {Q(0), Q(1)});
  const GC::Isometry<Exact_3> motion = random.isometry<Exact_3>(3);
  const Composite<Exact_3> moved = curve.transform(motion);
  for (int i = 0; i <= 4; ++i) {
    const Q u = ratio<Q>(i, 4);
    const std::optional<GC::Isometry<Exact_3>> found = GC::congruence(curve.jet(u, 4), moved.jet(u, 4));
    BOOST_REQUIRE(found);
    BOOST_CHECK(curve.transform(*found) == moved);
  }
  BOOST_CHECK(!GC::congruence(curve.jet(Q(0), 4), moved.jet(Q(1), 4)));
}

BOOST_AUTO_TEST_CASE(congruence_of_rounded_jets) {
  // a rotation that permutes coordinates commutes with rounding
  const auto turned = [](auto x) {
    for (int j = 0; j <= x.order(); ++j) {
      const double c = x[j][0];
      x[j][0] = x[j][1];
      x[j][1] = x[j][2];
      x[j][2] = c;
    }
    return x;
  };
  const Jet<Double_3> whole = jet<Double_3>(3, {{1, 2, 3}, {2, 0, 0}, {1, 3, 0}, {1, 0, 2}});
  const std::optional<GC::Isometry<Double_3>> map = GC::congruence(whole, turned(whole));
  BOOST_REQUIRE(map);
  BOOST_CHECK((*map)(Double_3::Point(1, 2, 4)) == Double_3::Point(2, 4, 1)); // small whole numbers throughout

  // decided exactly on the doubles as given, where dot products round
  Jet<Epick_3> x = jet<Epick_3>(3, {{0}, {0}, {0}, {0}});
  for (int j = 0; j <= 3; ++j)
    for (int i = 0; i < 3; ++i) x[j][i] = std::sin(1. + 3 * j + i);
  Jet<Epick_3> y = turned(x);
  BOOST_CHECK(GC::congruence(x, y));
  y[3][0] = std::nextafter(y[3][0], 2.);
  BOOST_CHECK(!GC::congruence(x, y));
  BOOST_CHECK(GC::congruence(x, truncated<Epick_3>(y, 2)));
}

BOOST_AUTO_TEST_CASE(output_of_an_isometry) {
  std::ostringstream os;
  os << *GC::congruence(jet<Exact_2>(2, {{0, 0}, {1, 0}}), jet<Exact_2>(2, {{3, 5}, {0, 1}}));
  BOOST_CHECK_EQUAL(os.str(), "0 -1 3\n1 0 5\n");
}

// -------------------------------------------------------------------------------------------------- Frenet equations

namespace {

// (t, t^2, t^3, ..., t^n) at t
template <class Traits> Jet<Traits> moment_curve(int n, double t, int k) {
  Jet<Traits> x = zero_jet<Traits>(n, k);
  for (int j = 0; j <= k; ++j)
    for (int i = 0; i < n; ++i) {
      double c = 1;
      for (int l = 0; l < j; ++l) c *= i + 1 - l;
      x[j][i] = j > i + 1 ? 0 : c * std::pow(t, i + 1 - j);
    }
  return x;
}

// The largest difference between the frame's derivatives and its central differences of step h.
template <class Traits> double frame_derivative_error(int n, double h) {
  const double t = 0.5;
  const std::vector<typename Traits::Vector> d = *GC::frenet_frame_derivatives(moment_curve<Traits>(n, t, n));
  const GC::Frenet_frame<Traits> before = GC::frenet_frame(moment_curve<Traits>(n, t - h, n))->normalized(),
                                 after = GC::frenet_frame(moment_curve<Traits>(n, t + h, n))->normalized();
  double error = 0;
  for (int i = 1; i <= n; ++i) {
    const Column<Traits> difference = 1 / (2 * h) * (after.coordinates(i) - before.coordinates(i)),
                         exact = GC::coordinates<Traits>(d[i - 1]);
    for (int j = 0; j < n; ++j) error = std::max(error, std::abs(difference[j] - exact[j]));
  }
  return error;
}

} // namespace

BOOST_AUTO_TEST_CASE(derivatives_of_the_frame) {
  // Central differences have errors in h^2 times third derivatives, and 2^-53 / h by rounding: a tenth of h divides the error
  // by 100 as long as rounding is smaller.
  const auto check = [](double coarse, double fine) {
    BOOST_CHECK_LE(fine, 0.012 * coarse);
    BOOST_CHECK_LE(fine, 1e-3);
  };
  check(frame_derivative_error<Double_2>(2, 1e-2), frame_derivative_error<Double_2>(2, 1e-3));
  check(frame_derivative_error<Double_3>(3, 1e-2), frame_derivative_error<Double_3>(3, 1e-3));
  check(frame_derivative_error<Double_d>(4, 1e-2), frame_derivative_error<Double_d>(4, 1e-3));
  check(frame_derivative_error<Double_d>(5, 1e-2), frame_derivative_error<Double_d>(5, 1e-3));
}

BOOST_AUTO_TEST_CASE(frenet_matrix_of_a_helix) {
  // (3 cos t, 3 sin t, 4 t): |X'| = 5, kappa = 3/25, tau = 4/25
  const Jet<Double_3> x = jet<Double_3>(3, {{3, 0, 0}, {0, 3, 4}, {-3, 0, 0}, {0, -3, 0}});
  const GC::Frenet_matrix<double> w = *GC::frenet_matrix(x);
  const double expected[3][3] = {{0, 0.6, 0}, {-0.6, 0, 0.8}, {0, -0.8, 0}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) BOOST_CHECK_SMALL(w(i + 1, j + 1) - expected[i][j], 1e-15); // a few roundings
  std::ostringstream os;
  os << GC::Frenet_matrix<double>(2, {0.5, -1.5});
  BOOST_CHECK_EQUAL(os.str(), "0 1 0\n-1 0 -3\n0 3 0\n");
  // a right turn in the plane, and points without a frame
  BOOST_CHECK_EQUAL((*GC::frenet_matrix(jet<Double_2>(2, {{0}, {2, 0}, {0, -4}})))(1, 2), -2);
  BOOST_CHECK(!GC::frenet_matrix(jet<Double_2>(2, {{0}, {0}, {0, 1}})));
  BOOST_CHECK(!GC::frenet_matrix(jet<Double_3>(3, {{0}, {1}, {2}, {0, 1}})));
  BOOST_CHECK(!GC::frenet_frame_derivatives(jet<Double_3>(3, {{0}, {1}, {2}, {0, 1}})));
  CHECK_ERROR(GC::frenet_matrix(jet<Double_3>(3, {{0}, {1}, {0, 1}})), jet_order_too_low);
}

// --------------------------------------------------------------------------------------------------------- 1.7 (b)

namespace {

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
    // The estimates are those of a method of order 4, the result has order 5: the error is far below one tolerance a step.
    BOOST_CHECK_LE(error, steps * tolerance / 4 + rounding);
    // The fifth order of the method divides the error by about 100^(5/6) = 46 with the tolerance, when rounding and the
    // upper limit of the step are out of sight.
    if (previous > 0 && steps > 32 && error > rounding) BOOST_CHECK_LE(error, previous / 10);
    previous = error;

    BOOST_CHECK_EQUAL(curve.samples.front().s, 0);
    BOOST_CHECK_EQUAL(curve.samples.back().s, length);
    double h = 0;
    for (int i = 1; i <= steps; ++i) h = std::max(h, curve.samples[i].s - curve.samples[i - 1].s);
    BOOST_CHECK_LE(h, length / 16 * (1 + 4 * unit));
    // The frames add an error of the size of that of the points.
    BOOST_CHECK_LE(curve_error<Traits>(curve, x), 2 * error + std::pow(h, 6) / 46080 * sixth + rounding);

    for (const GC::Framed_point<Traits>& sample : curve.samples) // orthonormal, whatever the tolerance
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
  // The k-th derivative f_k of f(u) = exp(i (u^2/2 + b u)) at 0: f' = i (u + b) f gives f_{k+1} = i (b f_k + k f_{k-1}).
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

} // namespace

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
  // kappa = s + b, from an S with a point of inflection to an arc; |x^(6)| <= kappa^5 + 10 kappa^3 + 15 kappa (Faa di Bruno)
  for (double b : {0., -2., 1.}) {
    const double most = std::max(5 + b, -b), sixth = std::pow(most, 5) + 10 * std::pow(most, 3) + 15 * most;
    check_integration<Double_2>([=](double s) { return s + b; }, jet<Double_2>(2, {{0}, {1, 0}}), 5, sixth,
                                coordinate_functions<Double_2>([=](double s) { return fresnel(s, b).first; },
                                                               [=](double s) { return fresnel(s, b).second; }));
  }
}

BOOST_AUTO_TEST_CASE(slope_curve_over_a_clothoid) {
  // It rises with the constant slope sin a = 4/5: kappa = 3/5 (s + 1), tau = 4/5 (s + 1); |x^(6)| as before, with s + 1 <= 4.
  const Functions kappas = {[](double s) { return 0.6 * (s + 1); }, [](double s) { return 0.8 * (s + 1); }};
  check_integration<Double_3>(kappas, jet<Double_3>(3, {{0, 0, 0}, {3, 0, 4}, {0, 1, 0}}), 3, 0.6 * 1724,
                              coordinate_functions<Double_3>([](double s) { return 0.6 * fresnel(s, 1).first; },
                                                             [](double s) { return 0.6 * fresnel(s, 1).second; },
                                                             [](double s) { return 0.8 * s; }));
}

BOOST_AUTO_TEST_CASE(two_circles_in_four_dimensions) {
  // (a cos s, a sin s, b cos 2s, b sin 2s) with a = 3/5, 2b = 4/5 has unit speed and constant curvatures
  const auto at = [](double s, int n, int k) {
    Jet<Double_d> x = zero_jet<Double_d>(n, k);
    for (int j = 0; j <= k; ++j) {
      const double c[] = {std::cos(s + j * pi / 2), std::sin(s + j * pi / 2), std::cos(2 * s + j * pi / 2),
                          std::sin(2 * s + j * pi / 2)};
      for (int i = 0; i < 4; ++i) x[j][i] = (i < 2 ? 0.6 : 0.4 * std::pow(2, j)) * c[i];
    }
    return x;
  };
  const Jet<Double_d> start = at(0, 4, 4);
  std::vector<double> kappa;
  for (const auto& k : GC::frenet_curvatures(start)) kappa.push_back(k->sign * std::sqrt(k->square));
  BOOST_CHECK_SMALL(kappa[0] - std::sqrt(0.36 + 16 * 0.16), 1e-14); // |x''|, with a few roundings
  check_integration<Double_d>([&](double) { return kappa; }, start, 7, 0.6 + 0.4 * 64,
                              [&](double s) { return at(s, 4, 0)[0]; });
}

BOOST_AUTO_TEST_CASE(two_circles_and_a_line_in_five_dimensions) {
  // the same with 0.48, 0.64 / 2 and the slope 0.6
  const auto at = [](double s, int k) {
    Jet<Double_d> x = zero_jet<Double_d>(5, k);
    for (int j = 0; j <= k; ++j) {
      const double c[] = {std::cos(s + j * pi / 2), std::sin(s + j * pi / 2), std::cos(2 * s + j * pi / 2),
                          std::sin(2 * s + j * pi / 2)};
      for (int i = 0; i < 4; ++i) x[j][i] = (i < 2 ? 0.48 : 0.32 * std::pow(2, j)) * c[i];
      x[j][4] = j == 0 ? 0.6 * s : j == 1 ? 0.6 : 0;
    }
    return x;
  };
  const Jet<Double_d> start = at(0, 5);
  std::vector<double> kappa;
  for (const auto& k : GC::frenet_curvatures(start)) kappa.push_back(k->sign * std::sqrt(k->square));
  check_integration<Double_d>([&](double) { return kappa; }, start, 5, 0.48 + 0.32 * 64,
                              [&](double s) { return at(s, 0)[0]; });
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
      // Control points of modulus at most 8 carry 8 roundings each; 20 (b2 - 2 b1 + b0) / h^2 multiplies them by 80 / h^2.
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
  // Between the samples the second derivative of the interpolant is in error by h^4/1920 |x^(6)|, the third by h^3/120.
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
  for (double tolerance : {0., -1., nan, 1e-17}) CHECK_ERROR(plane(one, 1, tolerance), unreachable_tolerance);
  BOOST_CHECK_GT(plane(one, 1, 2.3e-16), 16);
  // a jump of the curvature is passed, where it becomes infinite no step is small enough
  BOOST_CHECK_GT(plane([](double s) { return s < 0.3 ? 1. : -1.; }), 16);
  CHECK_ERROR(plane([](double s) { return 1 / (0.3 - s); }), unreachable_tolerance);
  CHECK_ERROR(plane([](double) { return 1e6; }), unreachable_tolerance); // more than the largest number of steps
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

// ------------------------------------------------------------------------------------- the remarks of Hagen after 2.1

typedef std::tuple<Exact_3, Double_3, Epick_3> Spaces;

namespace {

// Two cubics over the knots 0, 1, 1 + ratio. The second continues the first by b1 = b0 + beta p,
// b2 = b0 + beta^2 (b_{-2} - b0) + c0 p, b3 = b0 + beta^3 (b_{-2} - b_{-3}) + c1 p + c2 r.
template <class Traits> struct Two_cubics {
  typedef typename Traits::FT FT;
  FT beta, c0, c1, c2;

  Composite<Traits> operator()(const FT& lambda) const {
    std::vector<Column<Traits>> b = {column<Traits>(3, {1, 2, 0}), column<Traits>(3, {0, -1, 2}),
                                     column<Traits>(3, {2, 1, 1}), column<Traits>(3, {3, 3, 2})};
    const Column<Traits> p = b[3] - b[2], r = b[1] - b[2], s = b[1] - b[0], origin = b[3];
    b.push_back(origin + beta * p);
    b.push_back(origin + FT(beta * beta) * (b[1] - origin) + c0 * p);
    b.push_back(origin + FT(beta * beta * beta) * s + c1 * p + c2 * r);
    std::vector<typename Traits::Point> points;
    for (const Column<Traits>& x : b) points.push_back(GC::to_point<Traits>(x));
    return Composite<Traits>(points.begin(), points.end(), {FT(0), FT(1), FT(FT(1) + lambda)});
  }
};

// The C^3 member for a ratio of the intervals.
template <class Traits> Two_cubics<Traits> c3_member(const typename Traits::FT& beta) {
  typedef typename Traits::FT FT;
  const FT b2 = beta * beta, b3 = b2 * beta;
  return {beta, FT(FT(2) * b2 + FT(2) * beta), FT(b3 + FT(3) * b2 + FT(3) * beta), FT(FT(2) * b3 + FT(3) * b2)};
}

template <class Traits> GC::Join_continuity<GC::Predicate_FT<Traits>> join_of(const Composite<Traits>& c) {
  return GC::chain_continuity(c).joins.at(0).continuity;
}

template <class FT> std::vector<FT> dyadic_ratios() { return {ratio<FT>(1, 2), FT(1), FT(2), FT(4)}; }

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(parametric_continuity_implies_that_of_the_invariants, Traits, Spaces) {
  typedef typename Traits::FT FT;
  for (const FT& beta : dyadic_ratios<FT>()) {
    Two_cubics<Traits> cubics = c3_member<Traits>(beta);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 3);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    BOOST_CHECK(*join_of<Traits>(cubics(beta)).torsion_equal);
    // C3 => torsion continuity: the converse is false, and so is torsion continuity => G3
    cubics.c1 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 3);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    cubics.c2 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).f_order, 3);
    // C2 => curvature continuity: the converse is false
    cubics.c0 += FT(1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).c_order, 1);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(beta)).g_order, 2);
    BOOST_CHECK_GE(join_of<Traits>(cubics(beta)).f_order, 2);
    BOOST_CHECK(*join_of<Traits>(cubics(beta)).curvature_vector_equal);
    // over other knots not even C1
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).c_order, 0);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).g_order, 2);
    BOOST_CHECK_EQUAL(join_of<Traits>(cubics(FT(FT(2) * beta))).betas()[0], ratio<FT>(1, 2));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(natural_spline_condition_of_cubics, Traits, Spaces) {
  typedef typename Traits::FT FT;
  // A C1 join of cubics is C2 if and only if the legs before and after it, prolonged in the ratio of the intervals, meet
  // in one point: the natural splines (Boehm). They are one member of the line of curvature continuous alternatives.
  for (const FT& beta : dyadic_ratios<FT>())
    for (int i = -3; i <= 3; ++i) {
      Two_cubics<Traits> cubics = c3_member<Traits>(beta);
      cubics.c0 += FT(i);
      const Composite<Traits> c = cubics(beta);
      const auto b = [&](int j) { return c.coordinates(3 + j); };
      const Column<Traits> before = b(-1) + beta * (b(-1) - b(-2)), after = b(1) + FT(FT(1) / beta) * (b(1) - b(2));
      const auto join = join_of<Traits>(c);
      BOOST_CHECK_EQUAL(join.c_order >= 2, i == 0);
      BOOST_CHECK_EQUAL(before == after, i == 0);
      BOOST_CHECK_GE(join.f_order, 2);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(arc_length_and_torsion_continuity, Traits, Spaces) {
  // With respect to arc length x' = e1, x'' = k e2, x''' = -k^2 e1 + k' e2 + k t e3. Continuous curvature then implies C2.
  // Continuous torsion does not imply C3, as Hagen's remark 4 has it, because k' may jump.
  const auto at = [](int k, int dk, int t) { return jet<Traits>(3, {{0}, {1}, {0, k}, {-k * k, dk, k * t}}); };
  for (int k : {1, 2})
    for (int t : {-3, 0, 2})
      for (int dk : {-1, 0, 4}) {
        const auto join = GC::continuity(at(k, 0, t), at(k, dk, t));
        BOOST_CHECK_EQUAL(join.f_order, 3);
        BOOST_CHECK(*join.torsion_equal);
        BOOST_CHECK_EQUAL(join.c_order, dk == 0 ? 3 : 2);
        BOOST_CHECK_EQUAL(join.g_order, dk == 0 ? 3 : 2);
        const auto other = GC::continuity(at(k, dk, t), at(k, dk, t + 1));
        BOOST_CHECK_EQUAL(other.f_order, 2);
        BOOST_CHECK_EQUAL(other.c_order, 2);
      }
  BOOST_CHECK_EQUAL(GC::continuity(at(1, 0, 0), at(2, 0, 0)).c_order, 1);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(curvature_vector_of_barsky_and_beatty, Traits, Spaces) {
  typedef typename Traits::FT FT;
  typedef GC::Predicate_FT<Traits> Field;
  // second-degree geometric continuity is the continuity of K = kappa e_2, and of the tangent
  for (const FT& beta : dyadic_ratios<FT>()) {
    Two_cubics<Traits> cubics = c3_member<Traits>(beta);
    cubics.c0 += FT(3);
    const Composite<Traits> c = cubics(FT(1));
    const auto x = c.segment(0).template end_jet_over<Field>(2), y = c.segment(1).template start_jet_over<Field>(2);
    const auto kx = *GC::internal::curvature_vector(x), ky = *GC::internal::curvature_vector(y);
    if constexpr (std::is_same_v<Field, Q>)
      BOOST_CHECK(kx == ky);
    else
      for (int i = 0; i < 3; ++i) BOOST_CHECK_SMALL(kx[i] - ky[i], 1e-15); // division by |x'|^2, few roundings below 1
    BOOST_CHECK_EQUAL(dot(kx, x[1]), 0);
    BOOST_CHECK_EQUAL(join_of<Traits>(c).g_order, 2);
  }
  // (t, t^2, 0) | (t, 0, t^2): the tangent and the number kappa are continuous, the vector is not
  std::vector<typename Traits::Point> points;
  for (const Column<Traits>& p : {column<Traits>(3, {-2, 4, 0}), column<Traits>(3, {-1, 0, 0}), column<Traits>(3, {0}),
                                  column<Traits>(3, {1, 0, 0}), column<Traits>(3, {2, 0, 4})})
    points.push_back(GC::to_point<Traits>(p));
  const auto join =
      GC::chain_continuity(Composite<Traits>(points.begin(), points.end(), {FT(-2), FT(0), FT(2)})).joins[0];
  BOOST_CHECK(*join.continuity.tangent_equal);
  BOOST_CHECK(join.left_side.curvature == join.right_side.curvature);
  BOOST_CHECK_EQUAL(join.left_side.curvature->square, Field(4));
  BOOST_CHECK(join.left_side.torsion == join.right_side.torsion);
  BOOST_CHECK(!*join.continuity.curvature_vector_equal);
  BOOST_CHECK_EQUAL(join.continuity.g_order, 1);
  BOOST_CHECK_EQUAL(join.continuity.f_order, 1);
}
