// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tensor product surfaces. With exact numbers all is compared with ==.

#include "support/exact_splines.h"
#include "support/net_of.h"

#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

typedef GC::Bspline_function<Q, Vector> Function;

// Knots of any multiplicity, clamped or not.
Knots any_knots(Random& random, int degree) {
  const Knots knots = random.knots(degree, degree + 1);
  if (degree == 0 || random.coin()) return knots;
  std::vector<Q> u(knots.begin(), knots.end());
  u.front() -= Q(random.integer(1, 5));
  u.back() += ratio(random.integer(1, 5), 3);
  return Knots(degree, u);
}

// A surface and its control net.
struct Net_surface {
  std::vector<std::vector<Vector>> net;
  Surface<Exact> s;

  static Surface<Exact> surface(const std::vector<std::vector<Vector>>& net, const Knots& u, const Knots& v) {
    const int m = static_cast<int>(net.size()), n = static_cast<int>(net[0].size());
    return Surface<Exact>(net_of(m, n, [&](int i, int j) { return point(net[i][j]); }), u, v);
  }
  static std::vector<std::vector<Vector>> random_net(Random& random, int m, int n) {
    std::vector<std::vector<Vector>> net;
    while (m-- > 0) net.push_back(random.vectors(n));
    return net;
  }
  Net_surface(Random& random, const Knots& u, const Knots& v)
      : net(random_net(random, u.number_of_coefficients(), v.number_of_coefficients())), s(surface(net, u, v)) {}

  // The derivative of order i in u and j in v, by the definition as a spline in u whose
  // coefficients are splines in v.
  Vector partial(const Q& u, const Q& v, int i, int j) const {
    std::vector<Vector> column;
    for (const std::vector<Vector>& row : net) column.push_back(Function(s.knots_v(), row).right_derivatives(v, j)[j]);
    return Function(s.knots_u(), column).right_derivatives(u, i)[i];
  }
};

Net_surface random_surface(Random& random) {
  const Knots u = any_knots(random, random.integer(1, 3)), v = any_knots(random, random.integer(0, 3));
  return Net_surface(random, u, v);
}

// Checks that two surfaces are the same map, from the right at its knots.
template <class S> void check_same_surface(const Surface<Exact>& s, const S& t, Random& random) {
  for (const Q& u : parameters(s.knots_u(), random))
    for (const Q& v : parameters(s.knots_v(), random)) BOOST_CHECK(s(u, v) == t(u, v));
}

BOOST_AUTO_TEST_CASE(surfaces_are_evaluated) {
  repeat(8, [](Random& random) {
    const Net_surface x = random_surface(random);
    const Surface<Exact>& s = x.s;
    BOOST_CHECK_EQUAL(s.dimension(), 3);
    BOOST_CHECK(s.domain_u() == s.knots_u().domain() && s.domain_v() == s.knots_v().domain());
    for (int i = 0; i < s.number_of_points_u(); ++i)
      for (int j = 0; j < s.number_of_points_v(); ++j) {
        BOOST_CHECK(s.coordinates(i, j) == x.net[i][j]);
        BOOST_CHECK(*(s.begin() + (i * s.number_of_points_v() + j)) == s.control_point(i, j));
      }
    for (const Q& u : parameters(s.knots_u(), random))
      for (const Q& v : parameters(s.knots_v(), random)) {
        // sum_ij N_i(u) N_j(v) b_ij
        const std::vector<Q> nu = bspline_basis(s.knots_u(), u), nv = bspline_basis(s.knots_v(), v);
        Vector sum(3);
        for (std::size_t i = 0; i < nu.size(); ++i)
          for (std::size_t j = 0; j < nv.size(); ++j) sum += Q(nu[i] * nv[j]) * x.net[i][j];
        BOOST_CHECK(column(s(u, v)) == sum);
        const auto jet = s.jet(u, v, 4);
        BOOST_CHECK(jet.point() == s(u, v));
        for (int i = 0; i <= 4; ++i)
          for (int j = 0; i + j <= 4; ++j) {
            const Vector d = x.partial(u, v, i, j);
            BOOST_CHECK(jet(i, j) == d);
            if (i + j > 0) BOOST_CHECK(column(s.partial(u, v, i, j)) == d);
            if (i > s.degree_u() || j > s.degree_v()) BOOST_CHECK(d == Vector(3));
          }
        BOOST_CHECK(column(s.normal(u, v)) == cross(jet(1, 0), jet(0, 1)));
      }
    const Q below = s.domain_u().first - ratio(1, 1000000), above = s.domain_v().second + ratio(1, 1000000);
    CHECK_ERROR(s(below, s.domain_v().first), parameter_outside_domain);
    CHECK_ERROR(s(s.domain_u().second, above), parameter_outside_domain);
    CHECK_ERROR(s.jet(below, s.domain_v().first, 2), parameter_outside_domain);
    CHECK_ERROR(s.normal(s.domain_u().second, above), parameter_outside_domain);
  });
}

BOOST_AUTO_TEST_CASE(edges_of_surfaces) {
  repeat(8, [](Random& random) {
    const Surface<Exact> s = random_surface(random).s;
    for (Patch_edge edge : GC::patch_edges) {
      const bool along_u = GC::runs_along_u(edge), upper = GC::at_upper_end(edge);
      const auto fixed = along_u ? s.domain_v() : s.domain_u();
      const Q at = upper ? fixed.second : fixed.first;
      const Curve<Exact> c = GC::boundary_curve(s, edge);
      BOOST_CHECK(c.knots() == s.knots_along(edge));
      BOOST_CHECK(s.knots_along(edge) == (along_u ? s.knots_u() : s.knots_v()));
      BOOST_CHECK(s.knots_across(edge) == (along_u ? s.knots_v() : s.knots_u()));
      const auto rows = s.rows(edge, 3);
      BOOST_REQUIRE_EQUAL(rows.size(), 4u);
      for (const Q& t : parameters(c.knots(), random)) {
        const Q u = along_u ? t : at, v = along_u ? at : t;
        BOOST_CHECK(c(t) == s(u, v));
        // derivatives with respect to a parameter that grows into the surface
        for (int k = 0; k <= 3; ++k) {
          const Vector d = s.jet(u, v, k)(along_u ? 0 : k, along_u ? k : 0);
          BOOST_CHECK(Function(c.knots(), rows[k])(t) == Q(upper && k % 2 == 1 ? -1 : 1) * d);
        }
      }
    }
  });
}

BOOST_AUTO_TEST_CASE(bezier_patches_of_surfaces) {
  repeat(8, [](Random& random) {
    const Surface<Exact> s = random_surface(random).s;
    const std::vector<int> us = s.knots_u().spans(), vs = s.knots_v().spans();
    const auto patches = s.bezier_patches();
    BOOST_REQUIRE_EQUAL(patches.size(), us.size() * vs.size());
    for (std::size_t i = 0; i < us.size(); ++i)
      for (std::size_t j = 0; j < vs.size(); ++j) {
        const auto& patch = patches[i * vs.size() + j];
        const Q &a = s.knots_u()[us[i]], &b = s.knots_u()[us[i] + 1], &c = s.knots_v()[vs[j]],
                &d = s.knots_v()[vs[j] + 1];
        BOOST_CHECK(patch.domain_u() == std::make_pair(a, b) && patch.domain_v() == std::make_pair(c, d));
        BOOST_CHECK_EQUAL(patch.degree_u(), s.degree_u());
        BOOST_CHECK_EQUAL(patch.degree_v(), s.degree_v());
        for (const auto& [u, v] : {std::make_pair(a, c), {random.between(a, b), random.between(c, d)}}) {
          const auto x = patch.jet(u, v, 3), y = s.jet(u, v, 3);
          for (int k = 0; k <= 3; ++k)
            for (int l = 0; k + l <= 3; ++l) BOOST_CHECK(x(k, l) == y(k, l));
        }
        const Surface<Exact> alone(patch);
        BOOST_CHECK(alone.bezier_patches() == std::vector<GC::Bezier_patch<GC::Traits_3<Exact>>>{patch});
        check_same_surface(alone, patch, random);
      }
  });
}

BOOST_AUTO_TEST_CASE(the_same_surface_by_other_control_nets) {
  repeat(8, [](Random& random) {
    const Surface<Exact> s = random_surface(random).s;
    const Q u = random.between(s.domain_u().first, s.domain_u().second),
            v = random.between(s.domain_v().first, s.domain_v().second);
    const int more_u = s.degree_u() + 1 - s.knots_u().multiplicity(u),
              more_v = s.degree_v() + 1 - s.knots_v().multiplicity(v);
    for (int times = 0; times <= more_u; ++times) {
      const Surface<Exact> t = s.insert_u(u, times);
      BOOST_CHECK(t.knots_u() == s.knots_u().insert(u, times) && t.knots_v() == s.knots_v());
      check_same_surface(s, t, random);
    }
    CHECK_ERROR(s.insert_u(u, more_u + 1), knot_multiplicity);
    CHECK_ERROR(s.insert_v(v, more_v + 1), knot_multiplicity);
    CHECK_ERROR(s.insert_v(Q(s.domain_v().second + Q(1))), parameter_outside_domain);
    const Surface<Exact> both = s.insert_u(u, more_u).insert_v(v, more_v);
    BOOST_CHECK(both == s.insert_v(v, more_v).insert_u(u, more_u));
    BOOST_CHECK(both == s.refine(s.knots_u().insert(u, more_u), s.knots_v().insert(v, more_v)));
    check_same_surface(s, both, random);
    CHECK_ERROR(both.refine(s.knots_u(), s.knots_v()), knot_multiplicity);

    const int i = random.integer(0, 2), j = random.integer(0, 2);
    const Surface<Exact> raised = s.elevate(i, j);
    BOOST_CHECK_EQUAL(raised.degree_u(), s.degree_u() + i);
    BOOST_CHECK_EQUAL(raised.degree_v(), s.degree_v() + j);
    check_same_surface(s, raised, random);
    for (Patch_edge edge : GC::patch_edges) {
      const int times = GC::runs_along_u(edge) ? i : j;
      const Curve<Exact> c = GC::boundary_curve(s, edge);
      BOOST_CHECK(GC::boundary_curve(raised, edge) == (times == 0 ? c : c.elevate(times)));
    }
    BOOST_CHECK(s.elevate(0, 0) == s);
    CHECK_ERROR(s.elevate(-1, 0), negative_count);

    const Surface<Exact> clamped = s.clamp();
    BOOST_CHECK(clamped.knots_u().is_clamped() && clamped.knots_v().is_clamped());
    BOOST_CHECK(clamped.control_point(0, 0) == s(s.domain_u().first, s.domain_v().first));
    check_same_surface(s, clamped, random);

    BOOST_CHECK(s.swap_parameters()(v, u) == s(u, v));
    BOOST_CHECK(s.swap_parameters().swap_parameters() == s);
    const auto mirror = [](const auto& domain, const Q& t) { return Q(domain.first + domain.second - t); };
    if (s.knots_u().multiplicity(u) == 0) BOOST_CHECK(s.reverse_u()(mirror(s.domain_u(), u), v) == s(u, v));
    if (s.knots_v().multiplicity(v) == 0) BOOST_CHECK(s.reverse_v()(u, mirror(s.domain_v(), v)) == s(u, v));
    BOOST_CHECK(s.reverse_u().reverse_u() == s && s.reverse_v().reverse_v() == s);
    const Vector shift = random.vector();
    const auto moved = s.transform([&](const Exact::Point_3& p) { return point(column(p) + shift); });
    BOOST_CHECK(column(moved(u, v)) == column(s(u, v)) + shift);
    BOOST_CHECK(moved != s && moved.knots_u() == s.knots_u());
  });
}

// Values are sums of nonnegative weights times points, with fewer than 50 roundings. Unit normals
// have one division and one root more.
BOOST_AUTO_TEST_CASE_TEMPLATE(rounded_surfaces, K, Rounded_kernels) {
  Random random;
  for (int round = 0; round < 10; ++round) {
    const Knots u(3, Q(0), Q(4), {{Q(1), 1}, {ratio(5, 2), 2}}), v(2, Q(-1), Q(2), {{Q(0), 1}});
    const auto points = net_of(u.number_of_coefficients(), v.number_of_coefficients(), [&](int i, int j) {
      const double x = 3 * i + random.integer(-999, 999) / 1001.0, y = 3 * j + random.integer(-999, 999) / 1001.0;
      return typename K::Point_3(x, y, random.integer(-999, 999) / 101.0);
    });
    const Surface<K> s(points, knots_exactly<double>(u), knots_exactly<double>(v));
    const Surface<Exact> e = surface_exactly<GC::Traits_3<Exact>>(s);
    for (int k = 0; k < 20; ++k) {
      const double a = random.integer(0, 64) / 16.0, b = random.integer(-16, 32) / 16.0;
      const auto jet = s.jet(a, b, 2);
      const auto exact = e.jet(Q(a), Q(b), 2);
      for (int x = 0; x < 3; ++x) // coordinates up to 30, derivatives up to 100 times as large
        for (int i = 0; i <= 2; ++i)
          for (int j = 0; i + j <= 2; ++j)
            BOOST_CHECK_SMALL(jet(i, j)[x] - CGAL::to_double(exact(i, j)[x]),
                              (i + j == 0 ? 1 : 100) * 50 * 30 * 0x1p-53);
      const auto n = s.unit_normal(a, b);
      BOOST_REQUIRE(n);
      BOOST_CHECK_CLOSE(std::sqrt(*n * *n), 1, 1e-13);
      const Vector m = column(e.normal(Q(a), Q(b)));
      const double length = std::sqrt(CGAL::to_double(Q(dot(m, m))));
      for (int x = 0; x < 3; ++x) BOOST_CHECK_SMALL((*n)[x] - CGAL::to_double(m[x]) / length, 1e-10);
    }
  }
  // no normal at a pole, and none of a surface that is a line
  const GC::Knot_vector<double> linear(1, 0, 1);
  typedef typename K::Point_3 P;
  const Surface<K> pole({{P(0, 0, 0), P(0, 0, 0)}, {P(1, 0, 0), P(0, 1, 0)}}, linear, linear);
  BOOST_CHECK(!pole.unit_normal(0, 0.5) && pole.unit_normal(0.5, 0.5));
  BOOST_CHECK(*pole.unit_normal(0.5, 0.5) == typename K::Vector_3(0, 0, 1));
  BOOST_CHECK(pole.normal(0, 0.5) == typename K::Vector_3(0, 0, 0));
  const Surface<K> line({{P(0, 0, 0), P(1, 1, 1)}, {P(2, 2, 2), P(3, 3, 3)}}, linear, linear);
  BOOST_CHECK(!line.unit_normal(0.5, 0.25));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_ERROR((Surface<K>({{P(0, 0, 0), P(0, 0, 0)}, {P(1, 0, 0), P(0, infinity, 0)}}, linear, linear)), not_finite);
}

BOOST_AUTO_TEST_CASE(refused_surfaces_equality_and_output) {
  typedef Exact::Point_3 P;
  const Knots u(2, Q(0), Q(1)), v(1, Q(0), Q(2), {{Q(1), 1}}), other(1, Q(0), Q(2), {{ratio(1, 2), 1}});
  const std::vector<std::vector<P>> net{
      {P(0, 0, 0), P(0, 1, 0), P(0, 2, 0)}, {P(1, 0, 0), P(1, 1, 2), P(1, 2, 0)}, {P(2, 0, 0), P(2, 1, 0), P(2, 2, 5)}};
  const Surface<Exact> s(net, u, v);
  std::vector<std::vector<P>> less(net.begin(), net.end() - 1), ragged = net, moved = net;
  ragged[1].pop_back();
  moved[1][1] = P(1, 1, 1);
  BOOST_CHECK_EQUAL(error_of([&] { Surface<Exact>(less, u, v); }),
                    "wrong_number_of_points: Bspline_surface: 2 rows where the knots need 3");
  BOOST_CHECK_EQUAL(error_of([&] { Surface<Exact>(ragged, u, v); }),
                    "wrong_number_of_points: Bspline_surface: 2 points in a row where the knots need 3");
  CHECK_ERROR((Surface<Exact>(std::vector<std::vector<P>>(), u, v)), wrong_number_of_points);
  BOOST_CHECK(s == Surface<Exact>(net, u, v) && s != Surface<Exact>(moved, u, v) && s != Surface<Exact>(net, u, other));
  BOOST_CHECK_EQUAL(text(s), "B-spline surface of degree 2 x 1 over 0 0 0 1 1 1 and 0 0 1 2 2:\n"
                             "(0, 0, 0) (0, 1, 0) (0, 2, 0)\n"
                             "(1, 0, 0) (1, 1, 2) (1, 2, 0)\n"
                             "(2, 0, 0) (2, 1, 0) (2, 2, 5)");

  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits_d;
  typedef GC::Bspline_surface<Traits_d> Surface_d;
  const auto p = [](std::vector<int> x) { return Traits_d::Point(static_cast<int>(x.size()), x.begin(), x.end()); };
  const Knots linear(1, Q(0), Q(1));
  CHECK_ERROR((Surface_d({{p({0, 0}), p({0, 1})}, {p({1, 0}), p({1, 1, 0})}}, linear, linear)), dimension_mismatch);
  const Surface_d flat({{p({0, 0}), p({0, 1})}, {p({1, 0}), p({1, 1})}}, linear, linear);
  BOOST_CHECK(flat(Q(1), Q(0)) == p({1, 0}));
  BOOST_CHECK(flat.elevate(1, 2)(ratio(1, 3), Q(0)) == flat(ratio(1, 3), Q(0)));
  CHECK_ERROR(flat.normal(Q(0), Q(0)), dimension_mismatch);
}
