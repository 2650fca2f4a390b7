// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Knot vectors.

#include "support/splines.h"

#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <cfenv>

TEST_FOR_EACH(knot_vectors, K, Kernels) {
  typedef GC::Knot_vector<FT> Knots;
  const Knots u(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(4), FT(6), FT(7)});
  BOOST_CHECK_EQUAL(u.degree(), 2);
  BOOST_CHECK_EQUAL(u.size(), 8);
  BOOST_CHECK_EQUAL(u.number_of_coefficients(), 5);
  BOOST_CHECK(u.domain() == std::make_pair(FT(0), FT(4)));
  BOOST_CHECK(!u.is_clamped());
  BOOST_CHECK((u.spans() == std::vector<int>{2, 4}));
  for (int i = -1; i <= 8; ++i)
    BOOST_CHECK_EQUAL(u.multiplicity(FT(i)), (i == 0 || i == 1) ? 2 : (i == -1 || i == 4 || i == 6 || i == 7) ? 1 : 0);
  BOOST_REQUIRE_EQUAL(u.distinct_knots().size(), 3u);
  BOOST_CHECK(u.distinct_knots()[0].value == FT(0) && u.distinct_knots()[0].multiplicity == 2);
  BOOST_CHECK(u.distinct_knots()[2].value == FT(4) && u.distinct_knots()[2].multiplicity == 1);
  BOOST_REQUIRE_EQUAL(u.inner_knots().size(), 1u);
  BOOST_CHECK(u.inner_knots()[0].value == FT(1) && u.inner_knots()[0].multiplicity == 2);

  // right-continuous, the right end closed
  BOOST_CHECK_EQUAL(u.span(FT(0)), 2);
  BOOST_CHECK_EQUAL(u.span(ratio<FT>(1, 2)), 2);
  BOOST_CHECK_EQUAL(u.span(FT(1)), 4);
  BOOST_CHECK_EQUAL(u.span(FT(4)), 4);
  BOOST_CHECK_EQUAL(u.left_span(FT(0)), 2);
  BOOST_CHECK_EQUAL(u.left_span(FT(1)), 2);
  BOOST_CHECK_EQUAL(u.left_span(ratio<FT>(3, 2)), 4);
  BOOST_CHECK_EQUAL(u.left_span(FT(4)), 4);
  for (const FT& outside : {FT(-1), ratio<FT>(-1, 1000), ratio<FT>(4001, 1000), FT(7)}) {
    BOOST_CHECK(!u.contains(outside));
    CHECK_ERROR(u.span(outside), parameter_outside_domain);
    CHECK_ERROR(u.left_span(outside), parameter_outside_domain);
    CHECK_ERROR(u.insert(outside), parameter_outside_domain);
  }

  BOOST_CHECK(u.greville_abscissa(0) == FT(0));
  BOOST_CHECK(u.greville_abscissa(1) == ratio<FT>(1, 2));
  BOOST_CHECK(u.greville_abscissa(4) == FT(5));
  BOOST_CHECK(Knots(0, {FT(0), FT(1), FT(4)}).greville_abscissa(1) == ratio<FT>(5, 2));

  BOOST_CHECK(u.insert(FT(1)) == Knots(2, {FT(-1), FT(0), FT(0), FT(1), FT(1), FT(1), FT(4), FT(6), FT(7)}));
  BOOST_CHECK(u.insert(FT(3), 2).inner_knots()[1].multiplicity == 2);
  BOOST_CHECK(u.insert(FT(3), 0) == u);
  BOOST_CHECK(u.insert(FT(0)).domain() == u.domain());
  BOOST_CHECK(u.insert(FT(4), 2).domain() == u.domain());
  CHECK_ERROR(u.insert(FT(1), 2), knot_multiplicity);
  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3), 2) == u);
  BOOST_CHECK(u.insert(FT(3), 2).remove(FT(3)) == u.insert(FT(3)));
  CHECK_ERROR(u.remove(FT(3)), knot_multiplicity);
  CHECK_ERROR(u.remove(FT(0)), knot_multiplicity);
  const Knots before = u;
  CHECK_ERROR(u.insert(FT(1), -1), negative_count);
  CHECK_ERROR(u.remove(FT(1), -1), negative_count);
  CHECK_ERROR(u.bezier(-1), wrong_number_of_points);
  CHECK_ERROR(u.greville_abscissa(-1), parameter_outside_domain);
  CHECK_ERROR(u.greville_abscissa(5), parameter_outside_domain);
  BOOST_CHECK(u == before);
  BOOST_CHECK(u.with_inner_knots({}) == Knots(2, {FT(-1), FT(0), FT(0), FT(4), FT(6), FT(7)}));
  const Knots clamped(2, {FT(0), FT(0), FT(0), FT(1), FT(1), FT(4), FT(4), FT(4)});
  BOOST_CHECK(u.clamp() == clamped);
  BOOST_CHECK(clamped.is_clamped());
  BOOST_CHECK(Knots(2, FT(0), FT(4), {{FT(1), 2}}) == clamped);
  BOOST_CHECK(u.bezier(1) == Knots(1, {FT(0), FT(0), FT(1), FT(1), FT(4), FT(4)}));
  BOOST_CHECK(merge(u, Knots(2, FT(0), FT(4), {{FT(1), 1}, {FT(2), 3}})) ==
              Knots(2, FT(0), FT(4), {{FT(1), 2}, {FT(2), 3}}));
  CHECK_ERROR(merge(u, Knots(2, FT(0), FT(5))), parameter_outside_domain);
  CHECK_ERROR(merge(u, Knots(3, FT(0), FT(4))), wrong_number_of_points);
  BOOST_CHECK(u.reverse() == Knots(2, {FT(-3), FT(-2), FT(0), FT(3), FT(3), FT(4), FT(4), FT(5)}));
  BOOST_CHECK(u.reverse().reverse() == u);
  BOOST_CHECK(u != clamped);
  BOOST_CHECK(Knots(1, FT(0), FT(1)) != Knots(0, {FT(0), FT(1)}));
  BOOST_CHECK_EQUAL(text(clamped), "0 0 0 1 1 4 4 4");
}

TEST_FOR_EACH(refused_knot_vectors, K, Kernels) {
  const auto error = [](int p, std::initializer_list<int> knots) {
    return error_of([&] { GC::Knot_vector<FT>(p, std::vector<FT>(knots.begin(), knots.end())); });
  };
  BOOST_CHECK_EQUAL(error(-1, {0, 1, 2}), "wrong_number_of_points: Knot_vector: degree -1");
  BOOST_CHECK_EQUAL(error(2, {0, 0, 0, 1, 1}), "wrong_number_of_points: Knot_vector: 5 knots are too few for degree 2");
  BOOST_CHECK_EQUAL(error(0, {}), "wrong_number_of_points: Knot_vector: 0 knots are too few for degree 0");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 2, 1, 3, 3}), "empty_domain: Knot_vector: knot 3 is less than the one before it");
  BOOST_CHECK_EQUAL(error(1, {0, 1, 1, 2}), "empty_domain: Knot_vector: the ends of the domain are equal");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 1, 2, 2}),
                    "knot_multiplicity: Knot_vector: knot 4 is repeated more than 2 times");
  BOOST_CHECK_EQUAL(error(0, {0, 1, 1, 2}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 1 times");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 0, 1, 1}), "knot_multiplicity: Knot_vector: knot 2 is repeated more than 2 times");
  BOOST_CHECK_EQUAL(error(1, {0, 0, 1, 1, 2, 2}), "no error");
  CHECK_ERROR(GC::Knot_vector<FT>(-2, FT(0), FT(1)), wrong_number_of_points);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(1), FT(1)), empty_domain);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(5), 1}}), empty_domain);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), 4}}), knot_multiplicity);
  CHECK_ERROR(GC::Knot_vector<FT>(2, FT(0), FT(4), {{FT(1), -1}}), negative_count);
  if constexpr (!exact_v<FT>) {
    const FT infinity = std::numeric_limits<FT>::infinity(), nan = std::numeric_limits<FT>::quiet_NaN();
    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, 0, 1, infinity})), not_finite);
    CHECK_ERROR((GC::Knot_vector<FT>(1, {0, nan, 1, 1})), not_finite);
    BOOST_CHECK(!GC::Knot_vector<FT>(1, 0, 1).contains(nan));
    const FT large = (std::numeric_limits<FT>::max)();
    BOOST_CHECK_EQUAL(error_of([&] { GC::Knot_vector<FT>(1, -large, large); }),
                      "not_finite: Knot_vector: the distance of the first and the last knot overflows");
    CHECK_ERROR((GC::Knot_vector<FT>(1, {-large, 0, 1, large})), not_finite);
    const GC::Knot_vector<FT> long_domain(2, -large, FT(0), {{FT(-large / 2), 1}});
    BOOST_CHECK_EQUAL(long_domain.greville_abscissa(1), FT(-0.75 * large)); // whose sum overflows
    BOOST_CHECK_EQUAL(long_domain.greville_abscissa(3), FT(0));
    CHECK_ERROR(GC::Knot_vector<FT>(1, 0, 1).span(nan), parameter_outside_domain);
  }
}

BOOST_AUTO_TEST_CASE(domains_of_knots) {
  const GC::Knot_vector<double> u(1, {0., 0., 1., 1.});
  for (const auto& knots : {std::vector<double>{0, 0, 2, 2}, {-1, -1, 1, 1}, {-1, -1, 2, 2}})
    BOOST_CHECK(!u.has_domain_of(GC::Knot_vector<double>(1, knots)));
  BOOST_CHECK(u.has_domain_of(GC::Knot_vector<double>(2, {-1., -1., 0., 1., 3., 4.})));
}

// Knots that are mirrored stay within the domain, also where a sum is rounded upwards.
BOOST_AUTO_TEST_CASE(mirrored_knots_are_rounded) {
  std::mt19937_64 random(2026);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::ldexp(static_cast<double>(random() >> 11), -60),
                 b = 1 + std::ldexp(static_cast<double>(random() >> 11), -53);
    const double x = a + std::ldexp(a, -52 + static_cast<int>(random() % 3));
    if (!(a < x)) continue;
    const GC::Knot_vector<double> u(1, {-1., a, x, b, 9.});
    std::fesetround(FE_UPWARD);
    const GC::Knot_vector<double> v = u.reverse();
    std::fesetround(FE_TONEAREST);
    BOOST_CHECK(v.domain() == u.domain());
    BOOST_REQUIRE(a <= v[2] && v[2] <= b);
  }
}
