// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Bezier patches.

#include "support/nets.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

template <class K> Patch<K> sample_patch() { // degree 3 x 2 on [1, 3] x [-1, 1]
  typedef typename K::FT FT;
  const auto point = [](int i, int j) {
    return typename K::Point_3(FT(4 * i + j * j), FT(8 * j - i * j), FT((i * i * 5 + j * 3) % 7 * 2));
  };
  return Patch<K>(net_of(4, 3, point), {FT(1), FT(3)}, {FT(-1), FT(1)});
}

TEST_FOR_EACH(patch_evaluation, K, All_kernels) {
  const Patch<K> s = sample_patch<K>();
  BOOST_CHECK_EQUAL(s.degree_u(), 3);
  BOOST_CHECK_EQUAL(s.degree_v(), 2);
  BOOST_CHECK_EQUAL(s.dimension(), 3);
  for (const FT& u : {FT(1), FT(2), FT(FT(5) / FT(4)), FT(4)})
    for (const FT& v : {FT(-1), FT(FT(1) / FT(2)), FT(1)}) {
      // S = sum B_i(s) B_j(t) b_ij, and the chain rule for s = (u - 1)/2, t = (v + 1)/2 the k-th
      // derivatives of the basis functions
      const auto basis = [](int n, const FT& t, int k) {
        std::vector<FT> values;
        for (int i = 0; i <= n; ++i) {
          std::vector<FT> unit(n + 1, FT(0));
          unit[i] = FT(1);
          GC::Bernstein_polynomial<FT> p(unit);
          for (int d = 0; d < k; ++d) p = p.derivative();
          values.push_back(FT(p(t) / FT(1 << k)));
        }
        return values;
      };
      const GC::Surface_jet<GC::Traits_3<K>> jet = s.jet(u, v, 4);
      BOOST_CHECK_EQUAL(jet.order(), 4);
      BOOST_CHECK(jet.point() == s(u, v));
      for (int k = 0; k <= 4; ++k)
        for (int l = 0; k + l <= 4; ++l) {
          const std::vector<FT> bu = basis(3, FT((u - FT(1)) / FT(2)), k), bv = basis(2, FT((v + FT(1)) / FT(2)), l);
          for (int x = 0; x < 3; ++x) {
            FT sum(0);
            for (int i = 0; i <= 3; ++i)
              for (int j = 0; j <= 2; ++j) sum += bu[i] * bv[j] * s.coordinates(i, j)[x];
            BOOST_CHECK(jet(k, l)[x] == sum); // dyadic: exact in all kernels
            if (k + l > 0) BOOST_CHECK(jet.partial(k, l)[x] == sum);
            if (k + l > 0) BOOST_CHECK(s.partial(u, v, k, l)[x] == sum);
          }
        }
      const typename K::Vector_3 n = CGAL::cross_product(jet.partial(1, 0), jet.partial(0, 1));
      BOOST_CHECK(s.normal(u, v) == n);
    }
}

TEST_FOR_EACH(patch_operations, K, All_kernels) {
  const Patch<K> s = sample_patch<K>();
  const FT u = FT(FT(3) / FT(2)), v = FT(FT(1) / FT(4));
  BOOST_CHECK(s == s);
  BOOST_CHECK(s.swap_parameters()(v, u) == s(u, v));
  BOOST_CHECK(s.swap_parameters().swap_parameters() == s);
  BOOST_CHECK(s.reverse_u()(FT(FT(4) - u), v) == s(u, v));
  BOOST_CHECK(s.reverse_v()(u, FT(-v)) == s(u, v));
  BOOST_CHECK(s.reverse_u() != s);
  BOOST_CHECK(s.reverse_u().reverse_u() == s);
  if (is_exact<FT>) { // elevation to degree 5 divides by 5
    const Patch<K> e = s.elevate(2, 3);
    BOOST_CHECK_EQUAL(e.degree_u(), 5);
    BOOST_CHECK_EQUAL(e.degree_v(), 5);
    BOOST_CHECK(e(u, v) == s(u, v));
    BOOST_CHECK(e.partial(u, v, 1, 2) == s.partial(u, v, 1, 2));
  }
  BOOST_CHECK(s.elevate(0, 0) == s);
  const std::pair<Patch<K>, Patch<K>> in_u = s.split_u(FT(2)), in_v = s.split_v(FT(0));
  BOOST_CHECK(in_u.first(u, v) == s(u, v));
  BOOST_CHECK(in_u.second(FT(FT(5) / FT(2)), v) == s(FT(FT(5) / FT(2)), v));
  BOOST_CHECK(in_u.first.domain_u() == std::make_pair(FT(1), FT(2)) && in_u.first.domain_v() == s.domain_v());
  BOOST_CHECK(in_u.second.domain_u() == std::make_pair(FT(2), FT(3)));
  BOOST_CHECK(in_v.first(u, FT(-v)) == s(u, FT(-v)));
  BOOST_CHECK(in_v.second(u, v) == s(u, v));
  BOOST_CHECK(in_v.second.domain_v() == std::make_pair(FT(0), FT(1)) && in_v.second.domain_u() == s.domain_u());
  CHECK_ERROR(s.split_u(FT(1)), parameter_outside_domain);
  CHECK_ERROR(s.split_v(FT(1)), parameter_outside_domain);
  const CGAL::Aff_transformation_3<K> shift(CGAL::TRANSLATION, typename K::Vector_3(FT(1), FT(2), FT(3)));
  BOOST_CHECK(s.transform([&](const typename K::Point_3& p) { return shift(p); })(u, v) == shift(s(u, v)));
  BOOST_CHECK(s.with_domain({FT(0), FT(2)}, {FT(0), FT(4)})(FT(u - FT(1)), FT(FT(2) * (v + FT(1)))) == s(u, v));
  BOOST_CHECK(s.bounding_box().first == typename K::Point_3(FT(0), FT(0), FT(0)));
  BOOST_CHECK(s.bounding_box().second == typename K::Point_3(FT(16), FT(16), FT(12)));
  BOOST_CHECK(s.bbox() == CGAL::Bbox_3(0, 0, 0, 16, 16, 12));
  BOOST_CHECK_EQUAL(std::distance(s.begin(), s.end()), 12);
  BOOST_CHECK(*(s.begin() + 1) == s.control_point(0, 1));
  const std::string written = text(s);
  BOOST_CHECK_EQUAL(written.substr(0, written.find('\n')), "Bezier patch of degree 3 x 2 on [1, 3] x [-1, 1]:");
  BOOST_CHECK_EQUAL(written.substr(written.rfind('\n')), "\n(12, 0, 6) (13, 5, 12) (16, 10, 4)");
  BOOST_CHECK_EQUAL(std::count(written.begin(), written.end(), '\n'), 4);
}

TEST_FOR_EACH(patch_edges, K, All_kernels) {
  const Patch<K> s = sample_patch<K>();
  for (Patch_edge e : GC::patch_edges) {
    const GC::Bezier_curve<GC::Traits_3<K>> c = GC::boundary_curve(s, e);
    const std::pair<FT, FT> along = s.domain(e);
    BOOST_CHECK(c.domain() == along);
    for (const FT& t : {along.first, FT((along.first + along.second) / FT(2)), along.second}) {
      const FT u = e == u0 ? FT(1) : e == u1 ? FT(3) : t, v = e == v0 ? FT(-1) : e == v1 ? FT(1) : t;
      BOOST_CHECK(c(t) == s(u, v));
      for (bool backwards : {false, true}) {
        const Patch<K> r = backwards ? s.oriented(e).reverse_u() : s.oriented(e);
        BOOST_CHECK(r.domain_u() == along);
        const FT start = r.domain_v().first, s_along = backwards ? FT(along.first + along.second - t) : t;
        BOOST_CHECK(r(s_along, start) == s(u, v));
        // the first derivative across the edge points into the patch
        const FT h = FT(start + FT(1) / FT(2));
        const FT in_u = e == u0   ? FT(FT(3) / FT(2))
                        : e == u1 ? FT(FT(5) / FT(2))
                                  : t,
                 in_v = e == v0   ? FT(FT(-1) / FT(2))
                        : e == v1 ? FT(FT(1) / FT(2))
                                  : t;
        BOOST_CHECK(r(s_along, h) == s(in_u, in_v));
      }
      // rows: derivatives of the turned patch on the unit square
      const Patch<K> unit = s.oriented(e).with_domain({FT(0), FT(1)}, {FT(0), FT(1)});
      const auto rows = s.rows(e, 4);
      BOOST_CHECK_EQUAL(rows.size(), 5);
      for (int k = 0; k <= 4; ++k)
        for (int x = 0; x < 3; ++x) {
          std::vector<FT> coefficients;
          for (const auto& p : rows[k]) coefficients.push_back(p[x]);
          BOOST_CHECK_EQUAL(coefficients.size(), s.degree_along(e) + 1);
          const FT parameter = FT((t - along.first) / (along.second - along.first));
          BOOST_CHECK(GC::Bernstein_polynomial<FT>(coefficients)(parameter) == unit.jet(parameter, FT(0), k)(0, k)[x]);
        }
    }
  }
}

BOOST_AUTO_TEST_CASE(patch_unit_normal_and_errors) {
  typedef CGAL::Epick K;
  typedef K::Point_3 P;
  const Patch<K> tiny({{P(0, 0, 0), P(0, 1e-200, 0)}, {P(1e-200, 0, 0), P(1e-200, 1e-200, 0)}});
  BOOST_REQUIRE(Patch<K>({{P(0, 0, 0), P(0, 3, 4)}, {P(2, 0, 0), P(2, 3, 4)}}).unit_normal(0.5, 0.5));
  BOOST_CHECK(*Patch<K>({{P(0, 0, 0), P(0, 3, 4)}, {P(2, 0, 0), P(2, 3, 4)}}).unit_normal(0.5, 0.5) ==
              K::Vector_3(0, -0.8, 0.6));
  BOOST_CHECK(!tiny.transform([](const P& p) { return P(p.x(), p.x(), p.x()); }).unit_normal(0.5, 0.5));
  const Patch<K> small({{P(0, 0, 0), P(0, 1e-150, 0)}, {P(1e-150, 0, 0), P(1e-150, 1e-150, 0)}});
  BOOST_CHECK(*small.unit_normal(0.5, 0.5) == K::Vector_3(0, 0, 1)); // its square underflows
  const std::vector<P> row = {P(0, 0, 0), P(0, 1, 0), P(1, 0, 0), P(1, 1, 0), P(2, 0, 0), P(2, 1, 1)};
  BOOST_CHECK(Patch<K>(2, 1, row) == Patch<K>({{row[0], row[1]}, {row[2], row[3]}, {row[4], row[5]}}));
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {1, 1}), empty_domain);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {0, 1}, {1, 0}), empty_domain);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}, {0, std::numeric_limits<double>::infinity()}), not_finite);
  CHECK_ERROR(Patch<K>({{P(0, 0, 0)}}).jet(0, 0, -1), jet_order_too_low);
  CHECK_ERROR(GC::normal(tiny.jet(0, 0, 0)), jet_order_too_low);

  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  const auto point = [](std::vector<int> x) { return Traits::Point(static_cast<int>(x.size()), x.begin(), x.end()); };
  typedef GC::Bezier_patch<Traits> Patch_d;
  CHECK_ERROR(Patch_d({{point({0, 0, 0}), point({0, 1})}}), dimension_mismatch);
  const Patch_d space({{point({0, 0, 0}), point({0, 1, 0})}, {point({1, 0, 0}), point({1, 1, 0})}}),
      flat({{point({0, 0}), point({0, 1})}, {point({1, 0}), point({1, 1})}});
  BOOST_CHECK(flat(Q(1), Q(0)) == point({1, 0}));
  CHECK_ERROR(flat.normal(Q(0), Q(0)), dimension_mismatch);
  CHECK_ERROR(GC::edge_continuity(space, v0, flat, v0), dimension_mismatch);
  CHECK_ERROR(GC::model_continuity(std::vector<Patch_d>{flat}), dimension_mismatch);
  BOOST_CHECK_EQUAL(GC::edge_continuity(space, v0, space, v0).defect, Edge_defect::fold);
  BOOST_CHECK_EQUAL(GC::edge_continuity(space, u0, space, v0).defect, Edge_defect::gap);
}
