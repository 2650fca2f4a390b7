// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Aff_transformation_3.h>

#include <limits>

BOOST_AUTO_TEST_SUITE(bezier_curve)

// In rounded kernels coordinates and parameters are multiples of 1/8 of modulus at most 2 and
// domains have length 2, so that the local parameter (u-a)/(b-a) is a multiple of 1/16 of modulus
// at most 2; up to degree 3 all values and derivatives are doubles without rounding. Elevation and
// energies divide by 3, 5 and 7: at most 200 roundings, of numbers of modulus at most 4 * 6^2 *
// 5^3, the squared second derivatives times their growth outside the domain.
constexpr int max_degree = exact && cancels ? 6 : 3;
template <class T> bool nearly_equal(const T& x, const T& y) { return close(x, y, T(18000), 200); }

template <class Traits> bool nearly_equal_points(const Point<Traits>& p, const Point<Traits>& q) {
  const Column<Traits> x = column<Traits>(p), y = column<Traits>(q);
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), nearly_equal<FT>);
}

template <class Traits> bool same(const Point<Traits>& p, const Point<Traits>& q) {
  return column<Traits>(p) == column<Traits>(q);
}

// A parameter in the domain, or outside of it.
template <class Traits> FT random_parameter(Random& random, const Curve<Traits>& c) {
  return FT(c.domain().first + random.number() * ratio(1, 2) * (c.domain().second - c.domain().first));
}

TEST_WITH_RANDOM_INPUT(values_and_jets) {
  for (int m = 0; m <= max_degree; ++m) {
    const Curve<Traits> c = random_curve<Traits>(random, d, m);
    const FT a = c.domain().first, b = c.domain().second, u = random_parameter(random, c), t = (u - a) / (b - a);
    BOOST_CHECK_EQUAL(c.degree(), m);
    BOOST_CHECK_EQUAL(c.dimension(), d);
    Column<Traits> sum(d);
    for (int i = 0; i <= m; ++i)
      sum += FT(FT(binomial(m, i)) * power(t, i) * power(FT(FT(1) - t), m - i)) * c.coordinates(i);
    BOOST_CHECK(column<Traits>(c(u)) == sum);
    BOOST_CHECK(same<Traits>(c(a), c.control_point(0)));
    BOOST_CHECK(same<Traits>(c(b), c.control_point(m)));
    for (int i = 0; i < d; ++i) BOOST_CHECK(c.coordinate_polynomial(i)(t) == sum[i]);

    for (int k = 0; k <= m + 2; ++k) { // every order, against the hodographs
      const Jet<Traits> at_u = c.jet(u, k), at_a = c.jet(a, k), at_b = c.jet(b, k);
      BOOST_CHECK_EQUAL(at_u.order(), k);
      BOOST_CHECK(c.start_jet(k) == at_a);
      BOOST_CHECK(c.end_jet(k) == at_b);
      Curve<Traits> hodograph = c;
      for (int j = 0; j <= k; ++j, hodograph = hodograph.derivative()) {
        BOOST_CHECK(at_u[j] == column<Traits>(hodograph(u)));
        BOOST_CHECK(at_a[j] == column<Traits>(hodograph(a)));
        BOOST_CHECK(at_b[j] == column<Traits>(hodograph(b)));
      }
    }
    BOOST_CHECK_EQUAL(c.derivative().degree(), std::max(m - 1, 0));
    BOOST_CHECK(c.derivative().domain() == c.domain());
  }
}

TEST_WITH_RANDOM_INPUT(split_and_reverse) {
  for (int m = 0; m <= max_degree; ++m) {
    const Curve<Traits> c = random_curve<Traits>(random, d, m);
    const FT a = c.domain().first, b = c.domain().second, h = b - a;
    const FT u = a + ratio(random.integer(1, 3), 4) * h;
    const std::pair<Curve<Traits>, Curve<Traits>> parts = c.split(u);
    BOOST_CHECK(parts.first.domain() == std::make_pair(a, u));
    BOOST_CHECK(parts.second.domain() == std::make_pair(u, b));
    BOOST_CHECK(parts.first.end_jet(m) == parts.second.start_jet(m));
    BOOST_CHECK(parts.first.start_jet(m) == c.start_jet(m));
    BOOST_CHECK(parts.second.end_jet(m) == c.end_jet(m));
    const FT v = random_parameter(random, c);
    BOOST_CHECK(nearly_equal_points<Traits>(parts.first(v), c(v)));
    BOOST_CHECK(nearly_equal_points<Traits>(parts.second(v), c(v)));
    for (const FT& outside : {a, b, FT(a - h), FT(b + h)}) CHECK_ERROR(c.split(outside), parameter_outside_domain);

    const Curve<Traits> r = c.reverse();
    BOOST_CHECK(r.domain() == c.domain());
    BOOST_CHECK(same<Traits>(r(FT(a + b - v)), c(v)));
    BOOST_CHECK(same_points<Traits>(r.reverse(), c));
    BOOST_CHECK(r.start_jet(m) == reversed(c.end_jet(m)));

    const Curve<Traits> moved = c.with_domain(FT(a + h), FT(a + FT(3) * h)); // twice as slow
    BOOST_CHECK(moved.start_jet(m) == reparametrised(c.start_jet(m), {ratio(1, 2)}));
    CHECK_ERROR(c.with_domain(b, a), empty_domain);
  }
}

TEST_WITH_RANDOM_INPUT(elevation) {
  for (int m = 0; m <= max_degree; ++m) {
    const Curve<Traits> c = random_curve<Traits>(random, d, m);
    const FT u = random_parameter(random, c);
    for (int times = 0; times <= 3; ++times) {
      const Curve<Traits> e = c.elevate(times);
      BOOST_CHECK_EQUAL(e.degree(), m + times);
      BOOST_CHECK(e.domain() == c.domain());
      BOOST_CHECK(nearly_equal_points<Traits>(e(u), c(u)));
      if constexpr (exact) BOOST_CHECK(e.jet(u, m + 1) == c.jet(u, m + 1));
      for (int k : {0, 2}) BOOST_CHECK(nearly_equal(e.energy(k), c.energy(k)));
    }
    BOOST_CHECK(same_points<Traits>(c.elevate(0), c));
  }
  const GC::Bezier_curve<Traits, 3> fixed = random_curve<Traits>(random, d, 3);
  const GC::Bezier_curve<Traits, 5> elevated = fixed.template elevate_fixed<2>();
  BOOST_CHECK(same_points<Traits>(elevated, fixed.elevate(2)));
  BOOST_CHECK(same_points<Traits>(fixed.template elevate_fixed<0>(), fixed));
  BOOST_CHECK(elevated.domain() == fixed.domain());
}

// A degree known at compile time changes nothing but the storage.
TEST_WITH_RANDOM_INPUT(fixed_degree) {
  typedef GC::Bezier_curve<Traits, 3> Cubic;
  const Curve<Traits> c = random_curve<Traits>(random, d, 3);
  const Cubic f = c;
  const FT a = c.domain().first, b = c.domain().second, u = (a + b) / FT(2), v = random_parameter(random, c);
  BOOST_CHECK(f.domain() == c.domain() && f.degree() == 3 && f.dimension() == d);
  BOOST_CHECK(same_points<Traits>(f, c));
  BOOST_CHECK(same_points<Traits>(Curve<Traits>(f), c));
  BOOST_CHECK(same<Traits>(f(v), c(v)));
  for (int k = 0; k <= 7; ++k) {
    BOOST_CHECK(f.jet(v, k) == c.jet(v, k));
    BOOST_CHECK(f.start_jet(k) == c.start_jet(k));
    BOOST_CHECK(f.end_jet(k) == c.end_jet(k));
  }
  BOOST_CHECK(same_points<Traits>(f.derivative(), c.derivative()));
  BOOST_CHECK(same_points<Traits>(f.derivative().derivative().derivative().derivative(),
                                  c.derivative().derivative().derivative().derivative()));
  BOOST_CHECK(same_points<Traits>(f.split(u).first, c.split(u).first));
  BOOST_CHECK(same_points<Traits>(f.split(u).second, c.split(u).second));
  BOOST_CHECK(f.split(u).first.domain() == c.split(u).first.domain());
  BOOST_CHECK(same_points<Traits>(f.reverse(), c.reverse()));
  BOOST_CHECK(f.energy(2) == c.energy(2));
  BOOST_CHECK(same<Traits>(f.bounding_box().first, c.bounding_box().first));
  BOOST_CHECK(same_points<Traits>(f.with_domain(FT(0), FT(1)), c));
}

TEST_IN_EVERY_SPACE(refused_curves) {
  typedef GC::Bezier_curve<Traits, 2> Parabola;
  const std::vector<Point<Traits>> p(4, point<Traits>(d, {1, 2}));
  CHECK_ERROR(Curve<Traits>(p.begin(), p.begin()), wrong_number_of_points);
  CHECK_ERROR(Curve<Traits>({}), wrong_number_of_points);
  for (int n : {0, 2, 4}) CHECK_ERROR(Parabola(p.begin(), p.begin() + n), wrong_number_of_points);
  CHECK_ERROR((Parabola{p[0], p[1]}), wrong_number_of_points);
  CHECK_ERROR(Parabola(Curve<Traits>(p.begin(), p.end())), wrong_number_of_points);
  BOOST_CHECK_NO_THROW(Parabola(p.begin(), p.begin() + 3));
  CHECK_ERROR(Curve<Traits>(p.begin(), p.end(), FT(1), FT(1)), empty_domain);
  CHECK_ERROR(Parabola(p.begin(), p.begin() + 3, FT(1), FT(0)), empty_domain);
  if constexpr (Curve<Traits>::N == 0) {
    CHECK_ERROR((Curve<Traits>{p[0], point<Traits>(d + 1, {1}), p[1]}), dimension_mismatch);
    CHECK_ERROR((Parabola{p[0], p[1], point<Traits>(d - 1, {1})}), dimension_mismatch);
  }
  if constexpr (std::is_floating_point_v<typename Traits::FT>)
    for (const FT& bad : {std::numeric_limits<FT>::infinity(), std::numeric_limits<FT>::quiet_NaN()}) {
      Column<Traits> c(d);
      c[d - 1] = bad;
      CHECK_ERROR((Curve<Traits>{p[0], point<Traits>(c)}), not_finite);
      CHECK_ERROR((Parabola{p[0], point<Traits>(c), p[0]}), not_finite);
      BOOST_CHECK_THROW(Parabola(p.begin(), p.begin() + 3, FT(0), bad), GC::Error);
      Column<Traits> opposite = c;
      opposite *= FT(-1);
      CHECK_ERROR((Parabola{point<Traits>(c), p[0], point<Traits>(opposite)}), not_finite);
      c[d - 1] = std::numeric_limits<FT>::max(); // finite, though their sum is not
      BOOST_CHECK_NO_THROW((Parabola{point<Traits>(c), point<Traits>(c), point<Traits>(c)}));
    }
}

TEST_IN_EVERY_SPACE(degree_0_and_1) {
  const GC::Bezier_curve<Traits, 0> constant = curve<Traits>(d, {{3, 4}}, 1, 3);
  BOOST_CHECK(column<Traits>(constant(FT(7))) == column<Traits>(d, {3, 4}));
  BOOST_CHECK((constant.jet(FT(2), 2) == jet<Traits>(d, {{3, 4}, {0}, {0}})));
  BOOST_CHECK((constant.end_jet(1) == jet<Traits>(d, {{3, 4}, {0}})));
  BOOST_CHECK(column<Traits>(constant.derivative()(FT(2))) == Column<Traits>(d));
  BOOST_CHECK(same_points<Traits>(constant.split(FT(2)).first, constant));
  BOOST_CHECK(constant.energy(0) == FT(50) && constant.energy(1) == FT(0));
  BOOST_CHECK_EQUAL(constant.elevate(2).degree(), 2);
  const Curve<Traits> segment = curve<Traits>(d, {{3, 4}, {5, 0}}, 1, 3);
  BOOST_CHECK((segment.jet(FT(2), 2) == jet<Traits>(d, {{4, 2}, {1, -2}, {0}})));
  BOOST_CHECK(segment.energy(1) == FT(10));
}

// (t^2, t) on [0, 1], and with domains [0, 2] and [1, 3]
TEST_IN_EVERY_SPACE(energies) {
  const Curve<Traits> doubled = curve<Traits>(d, {{0, 0}, {0, 1}, {2, 2}}); // (2t^2, 2t)
  BOOST_CHECK(nearly_equal(doubled.energy(0), ratio(32, 15)));              // 4/5 + 4/3
  BOOST_CHECK(nearly_equal(doubled.energy(1), ratio(28, 3)));               // 16/3 + 4
  BOOST_CHECK(doubled.energy(2) == FT(16));
  BOOST_CHECK(doubled.energy(3) == FT(0));
  for (int a : {0, 1}) {
    const Curve<Traits> slow = doubled.with_domain(FT(a), FT(a + 2));
    BOOST_CHECK(nearly_equal(slow.energy(0), ratio(64, 15)));
    BOOST_CHECK(nearly_equal(slow.energy(1), ratio(14, 3)));
    BOOST_CHECK(slow.energy(2) == FT(2));
  }
}

// -------------------------------------------------------------- what only the kernels of CGAL have

// The transformations of homogeneous kernels are not function objects.
template <class C, class Map> C transformed(const C& c, const Map& map) {
  if constexpr (std::is_invocable_v<const Map&, const typename C::Point&>)
    return c.transform(map);
  else
    return c.transform([&](const typename C::Point& p) { return map.transform(p); });
}

template <class Traits> void check_transform(const Traits&) {}
template <class K> void check_transform(const GC::Traits_2<K>&) {
  typedef GC::Traits_2<K> Traits;
  const CGAL::Aff_transformation_2<K> map(typename K::RT(2), typename K::RT(1), typename K::RT(5), typename K::RT(0),
                                          typename K::RT(-1), typename K::RT(3));
  const Curve<Traits> c = curve<Traits>(2, {{0, 0}, {1, 2}, {3, 0}}, 2, 4), image = transformed(c, map);
  BOOST_CHECK((image == curve<Traits>(2, {{5, 3}, {9, 1}, {11, 3}}, 2, 4)));
  BOOST_CHECK(same<Traits>(image(ratio(5, 2)), map.transform(c(ratio(5, 2)))));
  BOOST_CHECK(same_points<Traits>(transformed(GC::Bezier_curve<Traits, 2>(c), map), image));
}
template <class K> void check_transform(const GC::Traits_3<K>&) {
  typedef GC::Traits_3<K> Traits;
  const CGAL::Aff_transformation_3<K> map(CGAL::TRANSLATION, typename K::Vector_3(1, -2, 3));
  const Curve<Traits> c = curve<Traits>(3, {{0, 0, 1}, {1, 2, 0}, {3, 0, 5}}, 2, 4), image = transformed(c, map);
  BOOST_CHECK((image == curve<Traits>(3, {{1, -2, 4}, {2, 0, 3}, {4, -2, 8}}, 2, 4)));
}

template <class Traits> void check_bbox(const Traits&) {}
template <class K> void check_bbox(const GC::Traits_2<K>&) {
  typedef GC::Traits_2<K> Traits;
  BOOST_CHECK(curve<Traits>(2, {{0, 5}, {-1, 2}, {3, 0}}).bbox() == CGAL::Bbox_2(-1, 0, 3, 5));
  const Curve<Traits> thirds = curve<Traits>(2, {{0, 0}, {1, 1}}).transform([](const Point<Traits>& p) {
    return point<Traits>(FT(ratio(1, 3)) * column<Traits>(p));
  });
  BOOST_CHECK(thirds.bbox().xmax() >= 1. / 3 && thirds.bbox().xmax() <= std::nextafter(1. / 3, 1) + 0x1p-53);
}
template <class K> void check_bbox(const GC::Traits_3<K>&) {
  BOOST_CHECK(curve<GC::Traits_3<K>>(3, {{0, 5, 7}, {-1, 2, 7}, {3, 0, 8}}).bbox() == CGAL::Bbox_3(-1, 0, 7, 3, 5, 8));
}

BOOST_AUTO_TEST_CASE(transformation_and_bounding_box) {
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    check_transform(traits);
    check_bbox(traits);
    const Curve<Traits> c = random_curve<Traits>(random, d, 3);
    const Curve<Traits> twice =
        c.transform([](const Point<Traits>& p) { return point<Traits>(FT(2) * column<Traits>(p)); });
    const FT v = random_parameter(random, c);
    BOOST_CHECK(column<Traits>(twice(v)) == FT(2) * column<Traits>(c(v)));
    const Column<Traits> low = column<Traits>(c.bounding_box().first), high = column<Traits>(c.bounding_box().second);
    for (int i = 0; i < d; ++i) {
      int at_low = 0, at_high = 0;
      for (int j = 0; j <= 3; ++j) {
        at_low += c.coordinates(j)[i] == low[i];
        at_high += c.coordinates(j)[i] == high[i];
        BOOST_CHECK(!(c.coordinates(j)[i] < low[i]) && !(high[i] < c.coordinates(j)[i]));
      }
      BOOST_CHECK(at_low > 0 && at_high > 0);
      for (int k = 0; k <= 8; ++k) {
        const FT u = c.domain().first + ratio(k, 8) * (c.domain().second - c.domain().first);
        const FT x = column<Traits>(c(u))[i];
        BOOST_CHECK(!(x < low[i]) && !(high[i] < x));
      }
    }
  });
}

TEST_IN_EVERY_SPACE(equality_and_output) {
  const Curve<Traits> c = curve<Traits>(d, {{0, 1}, {2, 3}});
  BOOST_CHECK((c == curve<Traits>(d, {{0, 1}, {2, 3}})));
  BOOST_CHECK((c == Curve<Traits>{point<Traits>(d, {0, 1}), point<Traits>(d, {2, 3})}));
  BOOST_CHECK((c != curve<Traits>(d, {{0, 1}, {2, 4}})));
  BOOST_CHECK((c != curve<Traits>(d, {{0, 1}, {2, 3}, {2, 3}})));
  BOOST_CHECK((c != curve<Traits>(d, {{0, 1}, {2, 3}}, 0, 2)));
  BOOST_CHECK((c != curve<Traits>(d, {{0, 1}, {2, 3}}, -1, 1)));
  if constexpr (Curve<Traits>::N == 0) BOOST_CHECK((c != curve<Traits>(d + 1, {{0, 1}, {2, 3}})));
  BOOST_CHECK_EQUAL(static_cast<int>(c.control_points().size()), 2);
  if constexpr (Is_streamable<typename Traits::FT>::value)
    if (d == 2)
      BOOST_CHECK_EQUAL(text(c), text("Bezier curve of degree 1 on [", FT(0), ", ", FT(1), "]: (", FT(0), ", ", FT(1),
                                      ") (", FT(2), ", ", FT(3), ")"));
}

// ---------------------------------------------------------------- polygon and jet

// The invariants of the last and the first legs are those of the jets. In rounded kernels this
// needs whole numbers, for which the determinants agree without rounding, so that quotients are off
// by a few roundings of their own size.
BOOST_AUTO_TEST_CASE(polygon_invariants) {
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const auto agree = [](const std::optional<FT>& x, const std::optional<FT>& y) {
      return bool(x) == bool(y) && (!x || close(*x, *y, FT(*y < FT(0) ? FT(-*y) : *y), 60));
    };
    for (int m = 1; m <= 6; ++m) {
      const std::vector<Point<Traits>> p = random_points<Traits>(random, d, m + 1, &Random::whole);
      const Curve<Traits> c(p.begin(), p.end(), FT(1), FT(3));
      for (bool at_end : {false, true}) {
        const GC::End_invariants<FT> i = at_end ? GC::end_invariants(c) : GC::start_invariants(c),
                                     r = at_end ? GC::start_invariants(c.reverse()) : GC::end_invariants(c.reverse());
        const Jet<Traits> x = at_end ? c.end_jet(3) : c.start_jet(3);
        if constexpr (exact)
          BOOST_CHECK(i.curvature_squared == GC::curvature_squared(x));
        else { // G_2 / G_1^3 has only whole numbers in it
          const std::vector<FT> g = GC::gram_determinants(x, 2);
          BOOST_CHECK(agree(i.curvature_squared,
                            g[1] == FT(0) ? std::nullopt : std::optional<FT>(FT(g[2] / (g[1] * g[1] * g[1])))));
        }
        BOOST_CHECK(i.curvature_squared == r.curvature_squared && i.torsion == r.torsion);
        if constexpr (Curve<Traits>::N == 0 || Curve<Traits>::N == 3)
          if (d == 3) BOOST_CHECK(agree(i.torsion, GC::torsion(x)));
        if (d != 3) BOOST_CHECK(!i.torsion);
      }
    }
  });
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    BOOST_CHECK(!GC::end_invariants(curve<Traits>(d, {{1, 2}})).curvature_squared);
    BOOST_CHECK(GC::end_invariants(curve<Traits>(d, {{1, 2}, {3, 4}})).curvature_squared == FT(0));
    BOOST_CHECK(!GC::end_invariants(curve<Traits>(d, {{1, 2}, {3, 4}})).torsion);
    // the last leg is zero
    const Curve<Traits> doubled = curve<Traits>(d, {{0, 0}, {1, 1}, {3, 0}, {3, 0}});
    BOOST_CHECK(!GC::end_invariants(doubled).curvature_squared && !GC::end_invariants(doubled).torsion);
    BOOST_CHECK(GC::start_invariants(doubled).curvature_squared == ratio(4 * 9, 9 * 8));
    const Curve<Traits> straight = curve<Traits>(d, {{0, 0}, {1, 1}, {3, 3}, {3, 0}});
    BOOST_CHECK(GC::start_invariants(straight).curvature_squared == FT(0));
    BOOST_CHECK(!GC::start_invariants(straight).torsion);
    const GC::Bezier_curve<Traits, 2> parabola = curve<Traits>(d, {{0, 0}, {1, 0}, {1, 1}});
    BOOST_CHECK(GC::start_invariants(parabola).curvature_squared == ratio(1, 4));
    BOOST_CHECK_EQUAL(bool(GC::start_invariants(parabola).torsion), d == 3);
    if (d == 3) BOOST_CHECK(GC::start_invariants(parabola).torsion == FT(0));
  });
}

BOOST_AUTO_TEST_CASE(control_points_from_jets) {
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    for (int m = 0; m <= 6; ++m)
      for (int k = 0; k <= m; ++k) {
        Jet<Traits> x(d, k);
        for (int j = 0; j <= k; ++j)
          for (int i = 0; i < d; ++i) x[j][i] = random.number();
        const FT a = random.number(), h = exact ? random.positive_rational() : FT(2), b = a + h;
        std::vector<Point<Traits>> first = GC::start_control_points(x, m, h), last = GC::end_control_points(x, m, h);
        BOOST_REQUIRE_EQUAL(static_cast<int>(first.size()), k + 1);
        BOOST_REQUIRE_EQUAL(static_cast<int>(last.size()), k + 1);
        const std::vector<Point<Traits>> others = random_points<Traits>(random, d, m - k);
        first.insert(first.end(), others.begin(), others.end());
        last.insert(last.begin(), others.begin(), others.end());
        const Jet<Traits> start = Curve<Traits>(first.begin(), first.end(), a, b).start_jet(k),
                          end = Curve<Traits>(last.begin(), last.end(), a, b).end_jet(k);
        // control points are below 2^7, and the 6th difference times 6!/2^6 multiplies their errors
        // by at most 2^10
        for (int j = 0; j <= k; ++j)
          for (int i = 0; i < d; ++i) {
            BOOST_CHECK(close(start[j][i], x[j][i], FT(1 << 17), 100));
            BOOST_CHECK(close(end[j][i], x[j][i], FT(1 << 17), 100));
          }
      }
  });
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    const Jet<Traits> x = jet<Traits>(d, {{1, 2}, {2, 4}, {2, -2}});
    BOOST_CHECK(same_points<Traits>(GC::start_control_points(x, 2), curve<Traits>(d, {{1, 2}, {2, 4}, {4, 5}})));
    BOOST_CHECK(same_points<Traits>(GC::end_control_points(x, 2), curve<Traits>(d, {{0, -3}, {0, 0}, {1, 2}})));
    CHECK_ERROR(GC::start_control_points(x, 1), wrong_number_of_points);
    CHECK_ERROR(GC::end_control_points(x, 1), wrong_number_of_points);
    CHECK_ERROR(GC::start_control_points(Jet<Traits>(), 1), wrong_number_of_points);
    CHECK_ERROR(GC::start_control_points(x, 2, FT(0)), empty_domain);
    CHECK_ERROR(GC::end_control_points(x, 2, FT(-1)), empty_domain);
  });
}

BOOST_AUTO_TEST_SUITE_END()
