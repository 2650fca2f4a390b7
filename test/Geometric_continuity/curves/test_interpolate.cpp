// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Cubic splines through points. With exact numbers all is compared with ==.

#include "support/decided_joins.h"
#include "support/exact_splines.h"

#include <CGAL/Geometric_continuity/curves/interpolate.h>

BOOST_AUTO_TEST_SUITE(interpolation)

using GC::Closure;
using GC::Parametrisation;
typedef GC::Traits_3<Exact> Traits;
typedef std::vector<Exact::Point_3> Points;
constexpr Parametrisation all_parametrisations[] = {Parametrisation::uniform, Parametrisation::chordal,
                                                    Parametrisation::centripetal};

Points random_points(Random& random, int n) {
  Points p;
  while (n-- > 0) p.push_back(point(random.vector()));
  return p;
}
// Very uneven.
std::vector<Q> random_parameters(Random& random, int n) {
  std::vector<Q> u(1, random.number());
  while (--n > 0) {
    const int numerator = random.integer(1, 999);
    u.push_back(u.back() + ratio(numerator, random.coin() ? 7 : 70000));
  }
  return u;
}

template <class C> void check_points(const C& curve, const std::vector<Q>& u, const Points& p) {
  for (std::size_t i = 0; i < u.size(); ++i) BOOST_CHECK(curve(u[i]) == p[i % p.size()]);
}
// The pieces are joined with the order 2, decided exactly.
void check_joins(const Curve<Exact>& curve, bool closed) {
  const auto pieces = curve.bezier_pieces();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
    BOOST_CHECK_GE(continuity(pieces[i], pieces[i + 1], 2).c_order, 2);
  if (closed) BOOST_CHECK_GE(continuity(pieces.back(), pieces.front(), 2).c_order, 2);
}

BOOST_AUTO_TEST_CASE(natural_splines) {
  repeat(12, [](Random& random) {
    const int n = random.integer(2, 9);
    const Points p = random_points(random, n);
    const std::vector<Q> u = random_parameters(random, n);
    const Curve<Exact> c = GC::interpolate<Traits>(p.begin(), p.end(), u);
    BOOST_CHECK_EQUAL(c.number_of_points(), n + 2);
    BOOST_CHECK(c.domain() == std::make_pair(u.front(), u.back()));
    check_points(c, u, p);
    check_joins(c, false);
    BOOST_CHECK(GC::interpolate<Traits>(p, u) == c);
    BOOST_CHECK(is_zero(c.start_jet(2)[2]) && is_zero(c.end_jet(2)[2]));
  });
}

BOOST_AUTO_TEST_CASE(clamped_splines) {
  repeat(12, [](Random& random) {
    const int n = random.integer(2, 9);
    const Points p = random_points(random, n);
    const std::vector<Q> u = random_parameters(random, n);
    const Vector a = random.vector(), b = random.vector();
    const Curve<Exact> c =
        GC::interpolate<Traits>(p.begin(), p.end(), u, GC::to_vector<Traits>(a), GC::to_vector<Traits>(b));
    BOOST_CHECK(GC::interpolate<Traits>(p, u, GC::to_vector<Traits>(a), GC::to_vector<Traits>(b)) == c);
    check_points(c, u, p);
    check_joins(c, false);
    BOOST_CHECK(c.start_jet(1)[1] == a && c.end_jet(1)[1] == b);
  });
}

BOOST_AUTO_TEST_CASE(closed_splines) {
  repeat(12, [](Random& random) {
    const int n = random.integer(3, 9);
    const Points p = random_points(random, n);
    const std::vector<Q> u = random_parameters(random, n + 1);
    const Curve<Exact> c = GC::interpolate<Traits>(p.begin(), p.end(), u, Closure::closed);
    check_points(c, u, p);
    check_joins(c, true);
    // from another point on, it is the same curve
    Points q(p.begin() + 1, p.end());
    q.push_back(p[0]);
    std::vector<Q> v(u.begin() + 1, u.end());
    v.push_back(u.back() + (u[1] - u[0]));
    const Curve<Exact> d = GC::interpolate<Traits>(q.begin(), q.end(), v, Closure::closed);
    for (int i = 1; i <= 20; ++i) {
      const Q t = u[1] + ratio(i, 20) * (u.back() - u[1]);
      BOOST_CHECK(c(t) == d(t));
    }
  });
}

// A cubic polynomial comes back from its points and end derivatives, a line from its points.
BOOST_AUTO_TEST_CASE(polynomials) {
  repeat(8, [](Random& random) {
    const std::vector<Vector> a = random.vectors(4);
    const auto cubic = [&](const Q& t) { return point(a[0] + t * (a[1] + t * (a[2] + t * a[3]))); };
    const auto derivative = [&](const Q& t) {
      return GC::to_vector<Traits>(a[1] + Q(2) * t * a[2] + Q(3) * t * t * a[3]);
    };
    const std::vector<Q> u = random_parameters(random, random.integer(2, 8));
    Points p, line;
    for (const Q& t : u) {
      p.push_back(cubic(t));
      line.push_back(point(a[0] + t * a[1]));
    }
    const Curve<Exact> c = GC::interpolate<Traits>(p.begin(), p.end(), u, derivative(u.front()), derivative(u.back()));
    BOOST_CHECK_EQUAL(c.function().remove_superfluous_knots().knots().number_of_spans(), 1);
    for (int i = 0; i <= 10; ++i) {
      const Q t = u.front() + ratio(i, 10) * (u.back() - u.front());
      BOOST_CHECK(c(t) == cubic(t));
      BOOST_CHECK(GC::interpolate<Traits>(line.begin(), line.end(), u)(t) == point(a[0] + t * a[1]));
    }
  });
}

BOOST_AUTO_TEST_CASE(parameters) {
  Points p = {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}, {3, 4, 13}};
  typedef std::vector<Q> Numbers;
  const auto parameters = [&](Parametrisation q, Closure closure = Closure::open) {
    return GC::interpolation_parameters<Traits>(p.begin(), p.end(), q, closure);
  };
  BOOST_CHECK(parameters(Parametrisation::uniform) == Numbers({0, 1, 2, 3}));
  BOOST_CHECK(parameters(Parametrisation::uniform, Closure::closed) == Numbers({0, 1, 2, 3, 4}));
  BOOST_CHECK(parameters(Parametrisation::chordal) == Numbers({0, 5, 17, 18}));
  const Numbers closed = parameters(Parametrisation::chordal, Closure::closed);
  BOOST_CHECK_SMALL(CGAL::to_double(closed[4] - closed[3]) - std::sqrt(194.), 0.01);
  const Numbers roots = parameters(Parametrisation::centripetal);
  BOOST_CHECK_SMALL(CGAL::to_double(roots[1]) - std::sqrt(5.), 0.003);
  BOOST_CHECK_EQUAL(roots[3] - roots[2], 1);
  for (Parametrisation q : all_parametrisations) {
    const Curve<Exact> c = GC::interpolate<Traits>(p.begin(), p.end(), q);
    check_points(c, parameters(q), p);
    const Curve<Exact> d = GC::interpolate<Traits>(p.begin(), p.end(), q, Closure::closed);
    if (q == GC::Parametrisation::chordal) BOOST_CHECK(GC::interpolate<Traits>(p.begin(), p.end()) == c);
    BOOST_CHECK(GC::interpolate<Traits>(p, q) == c && GC::interpolate<Traits>(p, q, Closure::closed) == d);
    check_points(d, parameters(q, Closure::closed), p);
    check_joins(d, true);
  }
  // points that coincide
  p[2] = p[1];
  BOOST_CHECK_EQUAL(error_of([&] { parameters(Parametrisation::chordal); }),
                    "empty_domain: interpolation_parameters: the points 1 and 2 coincide");
  CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.end(), Parametrisation::centripetal), empty_domain);
  check_points(GC::interpolate<Traits>(p.begin(), p.end(), Parametrisation::uniform), {0, 1, 2, 3}, p);
  p[3] = p[0];
  p[2] = {1, 1, 1};
  check_points(GC::interpolate<Traits>(p.begin(), p.end(), Parametrisation::chordal),
               parameters(Parametrisation::chordal), p);
  BOOST_CHECK_EQUAL(error_of([&] { parameters(Parametrisation::chordal, Closure::closed); }),
                    "empty_domain: interpolation_parameters: the points 3 and 0 coincide");
  p.clear();
  BOOST_CHECK_EQUAL(parameters(Parametrisation::chordal).size(), 1u);
  // a distance below all floating-point numbers
  Q tiny(1);
  for (int i = 0; i < 6; ++i) tiny *= Q(1) / Q(1e100);
  p = {{0, 0, 0}, {tiny, 0, 0}};
  CHECK_ERROR(parameters(Parametrisation::chordal), empty_domain);
}

BOOST_AUTO_TEST_CASE(errors) {
  typedef std::vector<Q> Numbers;
  const Points p = {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}};
  const Exact::Vector_3 v(1, 0, 0);
  const auto natural = [&](int n, const Numbers& u) { return GC::interpolate<Traits>(p.begin(), p.begin() + n, u); };
  const auto closed = [&](int n, const Numbers& u) {
    return GC::interpolate<Traits>(p.begin(), p.begin() + n, u, Closure::closed);
  };
  CHECK_ERROR(natural(0, {}), wrong_number_of_points);
  CHECK_ERROR(natural(1, {0}), wrong_number_of_points);
  CHECK_ERROR(natural(2, {0}), wrong_number_of_points);
  CHECK_ERROR(natural(2, {0, 1, 2}), wrong_number_of_points);
  CHECK_ERROR(natural(2, {0, 0}), empty_domain);
  CHECK_ERROR(natural(3, {0, 2, 1}), empty_domain);
  CHECK_ERROR(closed(2, {0, 1, 2}), wrong_number_of_points);
  CHECK_ERROR(closed(3, {0, 1, 2}), wrong_number_of_points);
  CHECK_ERROR(closed(3, {0, 1, 2, 2}), empty_domain);
  CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.begin() + 1, Numbers{0}, v, v), wrong_number_of_points);
  for (Parametrisation q : all_parametrisations) {
    CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.begin(), q), wrong_number_of_points);
    CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.begin() + 1, q), wrong_number_of_points);
    CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.begin() + 2, q, Closure::closed), wrong_number_of_points);
    const auto three = GC::interpolate<Traits>(p.begin(), p.begin() + 3, q, Closure::closed);
    BOOST_CHECK(three(three.domain().first) == p[0] && three(three.domain().second) == p[0]);
  }
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Any;
  const Q c[] = {1, 2, 3, 4};
  const std::vector<Any::Point> mixed = {Any::Point(2, c, c + 2), Any::Point(3, c, c + 3)}, plane(3, mixed[0]);
  CHECK_ERROR(GC::interpolate<Any>(mixed.begin(), mixed.end(), Numbers{0, 1}), dimension_mismatch);
  CHECK_ERROR(GC::interpolate<Any>(mixed.begin(), mixed.end(), Parametrisation::chordal), dimension_mismatch);
  const Any::Vector space(3, c, c + 3), flat(2, c, c + 2);
  CHECK_ERROR(GC::interpolate<Any>(plane.begin(), plane.end(), Numbers{0, 1, 2}, flat, space), dimension_mismatch);
  const auto any = GC::interpolate<Any>(plane.begin(), plane.end(), Numbers{0, 1, 2}, flat, flat);
  BOOST_CHECK(any(Q(2)) == plane[0] && any.dimension() == 2);
}

// Many points on doubles, with very uneven parameters: near the exact curve.
BOOST_AUTO_TEST_CASE_TEMPLATE(floating_point, K, Rounded_kernels) {
  typedef GC::Traits_3<K> Traits;
  Random random;
  const int n = 200;
  std::vector<typename K::Point_3> p;
  Points exact;
  std::vector<double> u(1, 0);
  std::vector<Q> v(1, Q(0));
  for (int i = 0; i < n; ++i) {
    const std::array<int, 3> x = {random.integer(-99, 99), random.integer(-99, 99), random.integer(-99, 99)};
    p.emplace_back(x[0], x[1], x[2]);
    exact.emplace_back(x[0], x[1], x[2]);
    u.push_back(u.back() + (random.coin() ? 1 : 0.015625));
    v.emplace_back(u.back());
  }
  const auto closed = GC::interpolate<Traits>(p.begin(), p.end(), u, Closure::closed);
  for (int i = 0; i <= n; ++i)
    for (int x = 0; x < 3; ++x) BOOST_CHECK_SMALL(closed(u[i])[x] - p[i % n][x], 1e-8);
  u.pop_back();
  v.pop_back();
  const GC::Work_scope each(GC::Work_limit(1)); // the work on rounded numbers is not counted
  const auto open = GC::interpolate<Traits>(p.begin(), p.end(), u);
  CHECK_ERROR(GC::interpolate<GC::Traits_3<Exact>>(exact.begin(), exact.begin() + 40,
                                                   std::vector<Q>(v.begin(), v.begin() + 40)),
              work_limit);
  const GC::Work_scope again((GC::Work_limit()));
  const auto reference = GC::interpolate<GC::Traits_3<Exact>>(exact.begin(), exact.begin() + 40,
                                                              std::vector<Q>(v.begin(), v.begin() + 40));
  const auto part = GC::interpolate<Traits>(p.begin(), p.begin() + 40, std::vector<double>(u.begin(), u.begin() + 40));
  for (int i = 0; i < n; ++i)
    for (int x = 0; x < 3; ++x) BOOST_CHECK_SMALL(open(u[i])[x] - p[i][x], 1e-8);
  for (int i = 0; i < 42; ++i)
    for (int x = 0; x < 3; ++x)
      BOOST_CHECK_SMALL(CGAL::to_double(reference.coordinates(i)[x]) - part.coordinates(i)[x], 1e-7);
  u[7] = std::numeric_limits<double>::quiet_NaN();
  CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.end(), u), not_finite);
  p[3] = typename K::Point_3(0, infinity, 0);
  CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.end(), Parametrisation::uniform), not_finite);
  CHECK_ERROR(GC::interpolate<Traits>(p.begin(), p.end(), Parametrisation::chordal), not_finite);
}

BOOST_AUTO_TEST_SUITE_END()
