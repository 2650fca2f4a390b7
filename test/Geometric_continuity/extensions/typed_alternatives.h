// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/typed.h"

#include <CGAL/Geometric_continuity/extensions/alternatives.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

BOOST_AUTO_TEST_SUITE(alternatives)

// Exact kernels whose numbers cancel take rational numbers; the others take whole numbers and
// powers of two, with which all but quotients is exact.
constexpr bool rational_numbers = exact && cancels;

typedef GC::Frenet_order Order;
constexpr Order all_orders[] = {Order::tangent, Order::curvature, Order::torsion};

template <class Traits> using Field = GC::Predicate_FT<Traits>;
template <class Traits> using Points = std::vector<Point<Traits>>;

inline FT value(Random& random) { return rational_numbers ? random.rational() : FT(random.integer(-2, 2)); }
inline FT positive(Random& random) { return rational_numbers ? random.positive_rational() : FT(random.integer(1, 2)); }
inline FT nonzero(Random& random) { return positive(random); }

template <class Traits> Column<Traits> random_column(Random& random, int d) {
  Column<Traits> c(d);
  for (int i = 0; i < d; ++i) c[i] = value(random);
  return c;
}

template <class Traits> Points<Traits> random_polygon(Random& random, int d, int n) {
  Points<Traits> points;
  for (int i = 0; i < n; ++i) points.push_back(point<Traits>(random_column<Traits>(random, d)));
  return points;
}

// The legs at the end of a polygon of degree at least 2, or 3.
template <class Traits> struct Legs {
  Column<Traits> b0, p, r, s;
  explicit Legs(const Curve<Traits>& left) {
    const int m = left.degree();
    b0 = left.coordinates(m);
    p = b0 - left.coordinates(m - 1);
    r = left.coordinates(m - 2) - left.coordinates(m - 1);
    if (m > 2) s = left.coordinates(m - 2) - left.coordinates(m - 3);
  }
};

template <class Traits> bool dependent(const std::vector<Column<Traits>>& v) {
  return GC::gram_determinant(v) == FT(0);
}

template <class Traits> Curve<Traits> curve_on(const Points<Traits>& points, const FT& a, const FT& b) {
  return Curve<Traits>(points.begin(), points.end(), a, b);
}
template <class Traits> Curve<Traits> unit(const Curve<Traits>& c) { return c.with_domain(FT(0), FT(1)); }

// Makes a curve of degree m with a nonzero curvature at its end, on a random domain.
template <class Traits> Curve<Traits> random_left(Random& random, int d, int m) {
  for (;;) {
    const FT a = value(random);
    const auto polygon = random_polygon<Traits>(random, d, m + 1);
    const Curve<Traits> left = curve_on<Traits>(polygon, a, FT(a + positive(random)));
    const Legs<Traits> legs(left);
    if (!dependent<Traits>({legs.p, legs.r})) return left;
  }
}

// The next segment with these first points and random others, on a domain beta times as long as
// that of `left`.
template <class Traits>
Curve<Traits> next(const Curve<Traits>& left, const FT& beta, Points<Traits> first, Random& random) {
  first.insert(first.begin(), left.control_point(left.degree()));
  while (static_cast<int>(first.size()) <= left.degree())
    first.push_back(point<Traits>(random_column<Traits>(random, left.dimension())));
  const std::pair<FT, FT> domain = left.domain();
  return curve_on<Traits>(first, domain.second, FT(domain.second + beta * (domain.second - domain.first)));
}

// Decisions on the small whole numbers of a rounded kernel are not taken in rounded arithmetic.
template <class Traits>
void check_join(const Curve<Traits>& left, const Curve<Traits>& right, int max_order, int c, int g, int f) {
  if (!exact_predicates) return;
  const auto join = GC::continuity(left, right, max_order);
  BOOST_CHECK_EQUAL(join.c_order, c);
  BOOST_CHECK_EQUAL(join.g_order, g);
  BOOST_CHECK_EQUAL(join.f_order, std::min(f, left.dimension()));
}

// The shape parameters of the join in unit intervals.
template <class Traits>
void check_betas(const Curve<Traits>& left, const Curve<Traits>& right, const std::vector<FT>& expected) {
  if (!exact_predicates) return;
  const auto join = GC::continuity(unit(left), unit(right), static_cast<int>(expected.size()));
  BOOST_REQUIRE(join.betas().size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    BOOST_CHECK(join.betas()[i] == in_field<Field<Traits>>(expected[i]));
}

// ---------------------------------------------------------------- scalars

BOOST_AUTO_TEST_CASE(scalars) {
  const GC::Alternative_parameters<FT> one = GC::ck_parameters<FT>(FT(1)), two = GC::ck_parameters<FT>(FT(2));
  BOOST_CHECK(one.c0 == FT(4) && one.c1 == FT(7) && one.c2 == FT(5));
  BOOST_CHECK(two.c0 == FT(12) && two.c1 == FT(26) && two.c2 == FT(28));
  BOOST_CHECK(GC::g3_c2<FT>(4, FT(1), FT(9)) == ratio(55, 2));
  CHECK_ERROR(GC::g3_c2<FT>(2, FT(1), FT(4)), wrong_number_of_points);
  CHECK_ERROR(GC::connection_c1<FT>(2, FT(1), FT(4), FT(5), FT(0)), wrong_number_of_points);
}

// ---------------------------------------------------------------- the point, the line, the plane

TEST_WITH_RANDOM_INPUT(tangent_point) {
  for (int m = 1; m <= 4; ++m) {
    const Curve<Traits> left = curve_on<Traits>(random_polygon<Traits>(random, d, m + 1), FT(0), FT(2));
    if (left.coordinates(m) == left.coordinates(m - 1)) continue;
    const FT beta = positive(random);
    const GC::Tangent_alternative<Traits> family = GC::tangent_alternative(left, beta);
    const Curve<Traits> right = next(left, beta, {family.point()}, random);
    BOOST_CHECK_EQUAL(family.degree(), m);
    BOOST_CHECK(family.beta() == beta);
    if (exact_predicates) BOOST_CHECK(GC::continuity(left, right, 1).c_order == 1);
    check_betas(left, right, {beta});
    BOOST_CHECK(family.ratio_of(family.point()) == in_field<Field<Traits>>(beta));
    BOOST_CHECK(!family.ratio_of(left.control_point(m)));     // beta = 0
    BOOST_CHECK(!family.ratio_of(left.control_point(m - 1))); // beta = -1
    BOOST_CHECK(column<Traits>(GC::tangent_alternative(left).point()) ==
                FT(2) * left.coordinates(m) - left.coordinates(m - 1));
  }
}

TEST_WITH_RANDOM_INPUT(line_of_third_points) {
  for (int m = 2; m <= 4; ++m) {
    const Curve<Traits> left = random_left<Traits>(random, d, m);
    const Legs<Traits> legs(left);
    const FT beta = positive(random), ck = GC::ck_parameters<FT>(beta).c0, c0 = FT(ck + nonzero(random));
    const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left, beta);
    const Point<Traits> b1 = GC::tangent_alternative(left, beta).point(), b2 = line.point_at(c0);
    BOOST_CHECK(column<Traits>(line.base_point()) == column<Traits>(line.point_at(FT(0))));
    BOOST_CHECK(column<Traits>(line.direction()) == legs.p);
    BOOST_CHECK(line.ck_parameter() == ck);

    const Curve<Traits> right = next(left, beta, {b1, b2}, random);
    check_join(left, right, 2, 1, 2, 2);
    check_betas(left, right, {beta, line.beta2(c0)});
    const Curve<Traits> smooth = next(left, beta, {b1, line.point_at(ck)}, random);
    check_join(left, smooth, 2, 2, 2, 2);
    BOOST_CHECK(line.beta2(ck) == FT(0));

    BOOST_CHECK(line.parameter_of(b2) == in_field<Field<Traits>>(c0));
    const Point<Traits> beside = point<Traits>(column<Traits>(b2) + legs.r);
    BOOST_CHECK(!line.parameter_of(beside));
    check_join(left, next(left, beta, {b1, beside}, random), 2, 1, 1, 1);
  }
}

TEST_WITH_RANDOM_INPUT(plane_of_fourth_points) {
  for (int m = 3; m <= 5; ++m) {
    const Curve<Traits> left = random_left<Traits>(random, d, m);
    const Legs<Traits> legs(left);
    const FT beta = positive(random), c0 = value(random), ck = GC::ck_parameters<FT>(beta).c0;
    const GC::Torsion_parameters<FT> c{value(random), value(random)};
    const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, c0, beta);
    const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left, beta);
    const Point<Traits> b1 = GC::tangent_alternative(left, beta).point(), b2 = line.point_at(c0),
                        b3 = plane.point_at(c);
    BOOST_CHECK(plane.c0() == c0);
    BOOST_CHECK(!plane.is_line());
    BOOST_CHECK(column<Traits>(plane.base_point()) == column<Traits>(plane.point_at({FT(0), FT(0)})));
    BOOST_CHECK(column<Traits>(plane.directions().first) == legs.p);
    BOOST_CHECK(column<Traits>(plane.directions().second) == legs.r);

    // the derivatives in unit intervals are connected as predicted
    const Curve<Traits> right = next(left, beta, {b1, b2, b3}, random);
    const Jet<Traits> x = unit(left).end_jet(3), y = unit(right).start_jet(3);
    const GC::Connection_coefficients<FT> k = plane.connection(c);
    BOOST_CHECK(y[1] == k.beta1 * x[1]);
    BOOST_CHECK(y[2] == FT(beta * beta) * x[2] + k.beta2 * x[1]);
    BOOST_CHECK(y[3] == power(beta, 3) * x[3] + k.mu * x[2] + k.delta * x[1]);
    const bool g3 = k.mu == FT(FT(3) * k.beta1 * k.beta2);
    check_join(left, right, 3, c0 == ck ? 2 : 1, g3 ? 3 : 2, 3);

    BOOST_CHECK(plane.contains(b3));
    const std::optional<GC::Torsion_parameters<Field<Traits>>> found = plane.parameters_of(b3);
    BOOST_REQUIRE(found);
    BOOST_CHECK(found->c1 == in_field<Field<Traits>>(c.c1) && found->c2 == in_field<Field<Traits>>(c.c2));
    for (int i = 0; i < d && d > 2; ++i) { // off the plane along an axis
      Column<Traits> axis(d);
      axis[i] = FT(1);
      if (dependent<Traits>({legs.p, legs.r, axis})) continue;
      const Point<Traits> beside = point<Traits>(column<Traits>(b3) + axis);
      BOOST_CHECK(!plane.contains(beside));
      BOOST_CHECK(!plane.parameters_of(beside));
      if (exact_predicates)
        BOOST_CHECK_EQUAL(GC::continuity(left, next(left, beta, {b1, b2, beside}, random), 3).f_order, 2);
    }

    // the G3 members, where their scalars are not rounded
    if (!exact) continue;
    const FT beta3 = value(random);
    const GC::Torsion_parameters<FT> g = plane.g3_parameters(beta3);
    const Curve<Traits> third = next(left, beta, {b1, b2, plane.point_at(g)}, random);
    BOOST_CHECK_GE(GC::continuity(left, third, 3).g_order, 3);
    check_betas(left, third, {beta, line.beta2(c0), beta3});
    BOOST_CHECK(plane.connection(g).delta == beta3);
    const Curve<Traits> other = next(left, beta, {b1, b2, plane.point_at({g.c1, FT(g.c2 + FT(1))})}, random);
    check_join(left, other, 3, c0 == ck ? 2 : 1, 2, 3);
  }
}

TEST_WITH_RANDOM_INPUT(third_derivative) {
  const Curve<Traits> left = random_left<Traits>(random, d, 3);
  const FT beta = positive(random), c0 = GC::ck_parameters<FT>(beta).c0;
  const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, c0, beta);
  const GC::Torsion_parameters<FT> c = plane.ck_parameters();
  BOOST_CHECK(c == plane.g3_parameters());
  BOOST_CHECK(plane.connection(c).mu == FT(0) && plane.connection(c).delta == FT(0));
  const Point<Traits> b1 = GC::tangent_alternative(left, beta).point(),
                      b2 = GC::curvature_alternatives(left, beta).point_at(c0);
  check_join(left, next(left, beta, {b1, b2, plane.point_at(c)}, random), 3, 3, 3, 3);
  check_join(left, next(left, beta, {b1, b2, plane.point_at({FT(c.c1 + FT(1)), c.c2})}, random), 3, 2, 3, 3);
}

// ----------------------------------------------------- the nearest member and that of least energy

// x.y = 0; in rounded kernels the terms are below 1000 and have gone through at most 100 roundings
template <class Traits> bool orthogonal(const Column<Traits>& x, const Column<Traits>& y) {
  return close(FT(dot(x, y)), FT(0), FT(1000), 100);
}

TEST_WITH_RANDOM_INPUT(nearest_member) {
  const Curve<Traits> left = random_left<Traits>(random, d, 4);
  const Legs<Traits> legs(left);
  const FT beta = positive(random);
  const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left, beta);
  const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, value(random), beta);
  const Point<Traits> wished = point<Traits>(random_column<Traits>(random, d));
  const Column<Traits> x = column<Traits>(wished);
  const Column<Traits> to_line = x - column<Traits>(line.point_at(line.nearest_parameter(wished))),
                       to_plane = x - column<Traits>(plane.point_at(plane.nearest_parameters(wished)));
  BOOST_CHECK(orthogonal<Traits>(to_line, legs.p));
  BOOST_CHECK(orthogonal<Traits>(to_plane, legs.p));
  BOOST_CHECK(orthogonal<Traits>(to_plane, legs.r));
  if (!exact) return;
  const FT c0 = value(random);
  const GC::Torsion_parameters<FT> c{value(random), value(random)};
  BOOST_CHECK(line.nearest_parameter(line.point_at(c0)) == c0);
  BOOST_CHECK(plane.nearest_parameters(plane.point_at(c)) == c);
}

// The energy of the polygon has its least value: it is larger, and equally large, when a point is
// moved either way.
template <class Traits> void check_stationary(const Curve<Traits>& c, int index, const Column<Traits>& direction) {
  const auto energy = [&](int sign) {
    Points<Traits> points(c.begin(), c.end());
    points[index] = point<Traits>(c.coordinates(index) + FT(sign) * direction);
    return curve_on<Traits>(points, FT(0), FT(1)).energy(2);
  };
  const FT forwards = energy(1), backwards = energy(-1);
  BOOST_CHECK(forwards == backwards);
  BOOST_CHECK(energy(0) < forwards);
}

TEST_WITH_RANDOM_INPUT(least_energy) {
  for (int m = 2; m <= 5; ++m) {
    const Curve<Traits> left = random_left<Traits>(random, d, m);
    const Legs<Traits> legs(left);
    const FT beta = positive(random), c0 = value(random);
    const Points<Traits> rest = random_polygon<Traits>(random, d, m);
    const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left, beta);
    const Point<Traits> b1 = GC::tangent_alternative(left, beta).point();
    CHECK_ERROR(line.least_energy_parameter(rest.begin() + 1, rest.end()), wrong_number_of_points);
    if (rational_numbers) {
      Points<Traits> b{b1, line.point_at(line.least_energy_parameter(rest.begin() + 2, rest.end()))};
      b.insert(b.end(), rest.begin() + 2, rest.end());
      check_stationary(next(left, beta, b, random), 2, legs.p);
    }
    if (m == 2) continue;
    const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, c0, beta);
    CHECK_ERROR(plane.least_energy_parameters(rest.begin() + 2, rest.end()), wrong_number_of_points);
    if (rational_numbers) {
      const GC::Torsion_parameters<FT> c = plane.least_energy_parameters(rest.begin() + 3, rest.end());
      Points<Traits> b{b1, line.point_at(c0), plane.point_at(c)};
      b.insert(b.end(), rest.begin() + 3, rest.end());
      check_stationary(next(left, beta, b, random), 3, legs.p);
      check_stationary(next(left, beta, b, random), 3, legs.r);
    }
  }
}

// ---------------------------------------------------------------- degenerate and refused input

TEST_IN_EVERY_SPACE(refused) {
  const Row rows[] = {{0, 1}, {0, 0}, {1, 0}, {3, 1}};
  std::vector<Curve<Traits>> lefts; // of degree 0, 1, 2, 3
  for (int m = 0; m <= 3; ++m) {
    Points<Traits> points;
    for (int i = 0; i <= m; ++i) points.push_back(point<Traits>(d, rows[i]));
    lefts.push_back(curve_on<Traits>(points, FT(0), FT(1)));
  }
  CHECK_ERROR(GC::tangent_alternative(lefts[0]), wrong_number_of_points);
  CHECK_ERROR(GC::curvature_alternatives(lefts[1]), wrong_number_of_points);
  CHECK_ERROR(GC::torsion_alternatives(lefts[2], FT(4)), wrong_number_of_points);
  for (int m = 0; m <= 3; ++m)
    for (Order order : all_orders)
      if (m < static_cast<int>(order)) {
        CHECK_ERROR(GC::extend(lefts[m], order), wrong_number_of_points);
        CHECK_ERROR(GC::extend_toward(lefts[m], order, point<Traits>(d, {5, 5})), wrong_number_of_points);
      } else
        BOOST_CHECK_EQUAL(GC::extend(lefts[m], order).degree(), m);
  // the last points of a polygon of lower degree than they are
  typedef GC::Curvature_alternatives<Traits> Line;
  const Point<Traits> a = point<Traits>(d, {0, 1}), b = point<Traits>(d, {0, 0}), c = point<Traits>(d, {1, 0});
  BOOST_CHECK(Line({a, b, c}, 7).degree() == 7);
  CHECK_ERROR(Line({a, b, c}, 1), wrong_number_of_points);

  for (int beta : {0, -1}) {
    CHECK_ERROR(GC::tangent_alternative(lefts[3], FT(beta)), nonpositive_beta);
    CHECK_ERROR(GC::curvature_alternatives(lefts[3], FT(beta)), nonpositive_beta);
    CHECK_ERROR(GC::torsion_alternatives(lefts[3], FT(4), FT(beta)), nonpositive_beta);
    for (Order order : all_orders) CHECK_ERROR(GC::extend(lefts[3], order, {FT(beta), {}, {}, {}}), nonpositive_beta);
  }
  const Curve<Traits> stopped = curve<Traits>(d, {{0, 1}, {0, 0}, {1, 0}, {1, 0}});
  CHECK_ERROR(GC::tangent_alternative(stopped), zero_tangent);
  CHECK_ERROR(GC::curvature_alternatives(stopped), zero_tangent);
  CHECK_ERROR(GC::torsion_alternatives(stopped, FT(4)), zero_tangent);
  for (Order order : all_orders) {
    CHECK_ERROR(GC::extend(stopped, order), zero_tangent);
    CHECK_ERROR(GC::extend_toward(stopped, order, a), zero_tangent);
    CHECK_ERROR(GC::close(stopped, lefts[3], order), zero_tangent);
  }
  if constexpr (Curve<Traits>::N == 0) {
    const Point<Traits> other = point<Traits>(d + 1, {1});
    CHECK_ERROR(Line({a, other, c}, 3), dimension_mismatch);
    CHECK_ERROR(GC::tangent_alternative(lefts[3]).ratio_of(other), dimension_mismatch);
    CHECK_ERROR(GC::curvature_alternatives(lefts[3]).nearest_parameter(other), dimension_mismatch);
    CHECK_ERROR(GC::torsion_alternatives(lefts[3], FT(4)).contains(other), dimension_mismatch);
    CHECK_ERROR(GC::extend_toward(lefts[3], Order::tangent, other), dimension_mismatch);
    CHECK_ERROR(GC::reflection<Traits>(a, other), dimension_mismatch);
    const Curve<Traits> elsewhere = curve<Traits>(d + 1, {{0, 1}, {0, 0}, {1, 0}, {3, 1}});
    CHECK_ERROR(GC::is_tangent_continuous(lefts[3], elsewhere), dimension_mismatch);
  }
  if constexpr (std::is_floating_point_v<typename Traits::FT>) {
    CHECK_ERROR(GC::curvature_alternatives(lefts[3]).point_at(FT(1e308) * FT(10)), not_finite);
    CHECK_ERROR(GC::torsion_alternatives(lefts[3], FT(4), FT(1e200)).base_point(), not_finite);
    CHECK_ERROR(GC::extend(lefts[3], Order::curvature, {FT(1e200), {}, {}, {}}), not_finite);
  }
}

// r = 2p, no curvature at the end: the plane is a line, and every member is G3.
TEST_IN_EVERY_SPACE(no_curvature) {
  const Curve<Traits> left = curve<Traits>(d, {{4, -1, 2}, {3, 3, 0}, {1, 1, 0}, {2, 2, 0}});
  const FT beta(2);
  const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left, beta);
  const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, FT(3), beta);
  const Point<Traits> b1 = GC::tangent_alternative(left, beta).point(), b2 = line.point_at(FT(3)),
                      b3 = plane.point_at({FT(5), FT(-2)});
  BOOST_CHECK(line.parameter_of(b2) == in_field<Field<Traits>>(FT(3)));
  BOOST_CHECK(plane.is_line());
  BOOST_CHECK(plane.contains(b3));
  CHECK_ERROR(plane.parameters_of(b3), singular_frame);
  Random random;
  check_join(left, next(left, beta, {b1, b2, b3}, random), 3, 1, 3, 3);
  const Column<Traits> axis = column<Traits>(d, {1});
  const Point<Traits> beside = point<Traits>(column<Traits>(b3) + axis);
  BOOST_CHECK(!plane.contains(beside));
  CHECK_ERROR(plane.parameters_of(beside), singular_frame);
  check_join(left, next(left, beta, {b1, b2, beside}, random), 3, 1, 2, 2);

  const GC::Torsion_parameters<FT> nearest = plane.nearest_parameters(beside);
  BOOST_CHECK(nearest.c2 == plane.g3_parameters().c2);
  BOOST_CHECK(
      orthogonal<Traits>(column<Traits>(beside) - column<Traits>(plane.point_at(nearest)), Legs<Traits>(left).p));
  if (rational_numbers)
    for (int m : {3, 4, 5}) {
      const Curve<Traits> toward = GC::extend_toward(left.elevate(m - 3), Order::torsion, beside, beta);
      BOOST_CHECK_GE(GC::continuity(left, toward).g_order, 3);
      if (m > 3) BOOST_CHECK(toward.coordinates(m) == column<Traits>(beside));
    }
}

// The plane of a planar curve in space is the plane of the curve.
BOOST_AUTO_TEST_CASE(planar_curve_in_space) {
  const Curve<Traits3> left = curve<Traits3>(3, {{0, 1, 5}, {0, 0, 5}, {1, 0, 5}, {3, 1, 5}});
  const GC::Torsion_alternatives<Traits3> plane = GC::torsion_alternatives(left, FT(3));
  BOOST_CHECK(!plane.is_line());
  const Point<Traits3> inside = point<Traits3>(3, {7, -8, 5}), outside = point<Traits3>(3, {7, -8, 6});
  BOOST_CHECK(plane.contains(inside) && plane.parameters_of(inside));
  BOOST_CHECK(!plane.contains(outside) && !plane.parameters_of(outside));
  BOOST_CHECK(column<Traits3>(plane.point_at({FT(2), FT(-1)}))[2] == FT(5));
  BOOST_CHECK(GC::extend(left, Order::torsion, {FT(1), FT(3), FT(2), FT(-1)}).coordinates(3)[2] == FT(5));
}

// The families move with the curve.
BOOST_AUTO_TEST_CASE(similarity) {
  if (!rational_numbers) return;
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const Curve<Traits> left = random_left<Traits>(random, d, 4);
    const Similarity<Traits> map(random, d, positive(random));
    const Point<Traits> wished = point<Traits>(random_column<Traits>(random, d));
    const GC::Extension_parameters<FT> x{positive(random), value(random), value(random), value(random)};
    for (Order order : all_orders) {
      BOOST_CHECK(
          same_points<Traits>(GC::extend(left.transform(map), order, x), GC::extend(left, order, x).transform(map)));
      BOOST_CHECK(same_points<Traits>(GC::extend_toward(left.transform(map), order, map(wished), x.beta),
                                      GC::extend_toward(left, order, wished, x.beta).transform(map)));
    }
  });
}

// Two planar projections with different C0 fit together where the tangent is orthogonal to the axis
// that they share, and give a join in space that is not curvature-continuous; with the same C0 it
// is.
BOOST_AUTO_TEST_CASE(two_projections) {
  const auto project = [](const Curve<Traits3>& c, int axis) {
    Points<Traits2> points;
    for (int i = 0; i <= c.degree(); ++i) {
      Column<Traits2> x(2);
      x[0] = c.coordinates(i)[0];
      x[1] = c.coordinates(i)[axis];
      points.push_back(point<Traits2>(x));
    }
    return curve_on<Traits2>(points, FT(0), FT(1));
  };
  // the third point from its two projections, empty where they do not fit together
  const auto third_point = [&](const Curve<Traits3>& left, const FT& c0_y,
                               const FT& c0_z) -> std::optional<Point<Traits3>> {
    const Column<Traits2> y = column<Traits2>(GC::midpoint_construction(project(left, 1)).b2(c0_y)),
                          z = column<Traits2>(GC::midpoint_construction(project(left, 2)).b2(c0_z));
    if (y[0] != z[0]) return std::nullopt;
    Column<Traits3> x(3);
    x[0] = y[0];
    x[1] = y[1];
    x[2] = z[1];
    return point<Traits3>(x);
  };
  const auto right = [](const Curve<Traits3>& left, const Point<Traits3>& b2) {
    return Curve<Traits3>{left.control_point(2), GC::tangent_alternative(left).point(), b2};
  };
  const Curve<Traits3> across = curve<Traits3>(3, {{1, 2, 0}, {0, -1, -1}, {0, 0, 0}}),
                       along = curve<Traits3>(3, {{1, 2, 0}, {-1, -1, -1}, {0, 0, 0}});
  const std::optional<Point<Traits3>> different = third_point(across, FT(4), FT(2));
  BOOST_REQUIRE(different);
  BOOST_CHECK(column<Traits3>(*different) == column<Traits3>(3, {1, 6, 2}));
  const Curve<Traits3> wrong = right(across, *different);
  for (int axis : {1, 2}) check_join(project(across, axis), project(wrong, axis), 2, axis == 1 ? 2 : 1, 2, 2);
  BOOST_CHECK(!GC::is_curvature_continuous(across, wrong));
  check_join(across, wrong, 2, 1, 1, 1);

  BOOST_CHECK(!third_point(along, FT(4), FT(2)));
  for (const Curve<Traits3>& left : {across, along}) {
    const std::optional<Point<Traits3>> same = third_point(left, FT(3), FT(3));
    BOOST_REQUIRE(same);
    BOOST_CHECK(GC::is_curvature_continuous(left, right(left, *same)));
  }
}

// ---------------------------------------------------------------- polygon tests

template <class Traits> void check_polygon_tests(const Curve<Traits>& left, const Curve<Traits>& right) {
  const int f = GC::continuity(left, right).f_order;
  BOOST_CHECK_EQUAL(GC::is_tangent_continuous(left, right), f >= 1);
  BOOST_CHECK_EQUAL(GC::is_curvature_continuous(left, right), f >= 2);
  if (left.dimension() > 2)
    BOOST_CHECK_EQUAL(GC::is_torsion_continuous(left, right), f >= 3);
  else
    CHECK_ERROR(GC::is_torsion_continuous(left, right), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(polygon_tests) {
  if (!exact_predicates) return;
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const auto small = [&] { // often zero, so that legs vanish and are parallel
      Column<Traits> c(d);
      for (int i = 0; i < d; ++i) c[i] = FT(random.integer(-1, 1) * random.integer(0, 1));
      return c;
    };
    for (int i = 0; i < 40; ++i) {
      const int m = random.integer(1, 5), stop = random.integer(0, 4);
      Points<Traits> points;
      for (int j = 0; j <= m; ++j) points.push_back(point<Traits>(small()));
      const Curve<Traits> left = curve_on<Traits>(points, FT(0), FT(1));
      // the right polygon follows the families up to some point, and is small and random from there
      // on
      const int sign = random.integer(0, 4) == 0 ? -1 : 1;
      const FT beta(sign * random.integer(1, 2));
      std::vector<Column<Traits>> b{left.coordinates(m)};
      const auto leg = [&](int j) { return left.coordinates(std::max(m - j, 0)); };
      const Column<Traits> p = leg(0) - leg(1), r = leg(2) - leg(1), s = leg(2) - leg(3);
      b.push_back(b[0] + beta * p);
      b.push_back(b[0] + power(beta, 2) * (r - p) + FT(random.integer(-2, 2)) * p);
      b.push_back(b[0] + power(beta, 3) * s + FT(random.integer(-2, 2)) * p + FT(random.integer(-2, 2)) * r);
      for (int j = 0; j < stop && j <= 3; ++j) b[3 - j] += small();
      while (static_cast<int>(b.size()) <= m) b.push_back(small());
      points.clear();
      for (int j = 0; j <= m; ++j) points.push_back(point<Traits>(b[j]));
      check_polygon_tests(left, curve_on<Traits>(points, FT(0), FT(1)));
      check_polygon_tests(left, curve_on<Traits>(points, FT(1), FT(4)));
    }
    const Curve<Traits> left = random_left<Traits>(random, d, 3);
    CHECK_ERROR(GC::is_tangent_continuous(left, left.elevate()), wrong_number_of_points);
    const Curve<Traits> right = GC::extend(left, Order::torsion, {FT(2), FT(1), FT(3), FT(-2)});
    check_polygon_tests(left, right);
    BOOST_CHECK(GC::is_curvature_continuous(left, right));
    if (d > 2) BOOST_CHECK(GC::is_torsion_continuous(left, right));
  });
}

// ---------------------------------------------------------------- constructions

BOOST_AUTO_TEST_CASE(midpoints) {
  with_random_input([](auto traits, int d, Random& random) {
    typedef decltype(traits) Traits;
    const Curve<Traits> left = random_left<Traits>(random, d, 3);
    const GC::Midpoint_construction<Traits> m = GC::midpoint_construction(left);
    const GC::Curvature_alternatives<Traits> line = GC::curvature_alternatives(left);
    const auto is_midpoint = [](const Point<Traits>& c, const Point<Traits>& x, const Point<Traits>& y) {
      return FT(2) * column<Traits>(c) == column<Traits>(x) + column<Traits>(y);
    };
    BOOST_CHECK(is_midpoint(left.control_point(3), left.control_point(2), m.b1));
    BOOST_CHECK(is_midpoint(left.control_point(2), left.control_point(1), m.d0));
    BOOST_CHECK(is_midpoint(m.b1, m.d0, m.b2_tilde));
    BOOST_CHECK(is_midpoint(left.control_point(3), m.d0, m.b2_bar));
    BOOST_CHECK(column<Traits>(m.b1) == column<Traits>(GC::tangent_alternative(left).point()));
    BOOST_CHECK(column<Traits>(m.b2_tilde) == column<Traits>(line.point_at(FT(4))));
    BOOST_CHECK(column<Traits>(m.b2_bar) == column<Traits>(line.point_at(FT(2))));
    const FT c0 = value(random);
    BOOST_CHECK(column<Traits>(m.b2(c0)) == column<Traits>(line.point_at(c0)));
  });
  in_every_space([](auto traits, int d) {
    typedef decltype(traits) Traits;
    CHECK_ERROR(GC::midpoint_construction(curve<Traits>(d, {{0}, {1}})), wrong_number_of_points);
    const GC::Midpoint_construction<Traits> m = GC::midpoint_construction(curve<Traits>(d, {{1, 2}, {3, 4}, {3, 4}}));
    BOOST_CHECK(column<Traits>(m.b2(FT(9))) == column<Traits>(m.b2_bar)); // the line is a point
  });
}

// A curve is split and its first part extended: the second part comes back.
TEST_WITH_RANDOM_INPUT(extend_a_part) {
  for (int m = 1; m <= 5; ++m) {
    const Curve<Traits> whole = curve_on<Traits>(random_polygon<Traits>(random, d, m + 1), FT(0), FT(2));
    const FT u = rational_numbers ? FT(FT(2) * positive(random) / FT(100000)) : FT(1);
    const std::pair<Curve<Traits>, Curve<Traits>> parts = whole.split(u);
    if (parts.first.coordinates(m) == parts.first.coordinates(m - 1)) continue;
    for (Order order : all_orders) {
      if (m < static_cast<int>(order)) continue;
      const Curve<Traits> next = GC::extend(parts.first, order, {FT((FT(2) - u) / u), {}, {}, {}});
      BOOST_CHECK(same_points<Traits>(next, parts.second));
      BOOST_CHECK(next.domain() == parts.second.domain());
    }
  }
}

TEST_WITH_RANDOM_INPUT(extend_by_choice) {
  for (int m = 3; m <= 5; ++m) {
    const Curve<Traits> left = random_left<Traits>(random, d, m);
    const FT beta = positive(random), ck = GC::ck_parameters<FT>(beta).c0, c0 = FT(ck + nonzero(random)), c1(-1), c2(3);
    const GC::Torsion_alternatives<Traits> plane = GC::torsion_alternatives(left, c0, beta);
    const Column<Traits> b2 = column<Traits>(GC::curvature_alternatives(left, beta).point_at(c0)),
                         b3 = column<Traits>(plane.point_at({c1, c2}));
    const Curve<Traits> curvature = GC::extend(left, Order::curvature, {beta, c0, c1, c2}),
                        torsion = GC::extend(left, Order::torsion, {beta, c0, c1, c2}),
                        third = GC::extend(left, Order::torsion, {beta, c0, {}, {}});
    BOOST_CHECK(curvature.coordinates(2) == b2);
    BOOST_CHECK(torsion.coordinates(2) == b2);
    BOOST_CHECK(torsion.coordinates(3) == b3);
    check_join(left, curvature, 2, 1, 2, 2);
    if (exact_predicates) BOOST_CHECK_EQUAL(GC::continuity(left, torsion).f_order, std::min(3, d));
    if constexpr (exact) { // C1 and C2 that are not given
      check_join(left, third, 3, 1, 3, 3);
      check_betas(left, third, {beta, FT(FT(m - 1) * (c0 - ck)), FT(0)});
      const Curve<Traits> only_c2 = GC::extend(left, Order::torsion, {beta, c0, {}, c2});
      const auto c = plane.parameters_of(only_c2.control_point(3));
      BOOST_REQUIRE(c);
      BOOST_CHECK(c->c2 == in_field<Field<Traits>>(c2));
      BOOST_CHECK(plane.connection({FT(c->c1), FT(c->c2)}).delta == FT(0));
    }
    // the derivatives beyond the order are those of the given curve
    const Jet<Traits> x = left.end_jet(m), y = curvature.start_jet(m), z = torsion.start_jet(m);
    for (int j = 3; j <= m; ++j) BOOST_CHECK(y[j] == x[j]);
    for (int j = 4; j <= m; ++j) BOOST_CHECK(z[j] == x[j]);
  }
  // the degree stays a constant of the type
  const GC::Bezier_curve<Traits, 3> cubic = random_left<Traits>(random, d, 3);
  const GC::Bezier_curve<Traits, 3> next = GC::extend(cubic, Order::curvature);
  BOOST_CHECK(same_points<Traits>(next, GC::extend(Curve<Traits>(cubic), Order::curvature)));
}

BOOST_AUTO_TEST_CASE(extend_to_a_point) {
  if (!rational_numbers) return;
  with_random_input(
      [](auto traits, int d, Random& random) {
        typedef decltype(traits) Traits;
        for (int m = 1; m <= 5; ++m)
          for (Order order : all_orders) {
            const int k = static_cast<int>(order);
            if (m < k) continue;
            const Curve<Traits> left = m == 1 ? Curve<Traits>{point<Traits>(d, {0}), point<Traits>(d, {2, 1})}
                                              : random_left<Traits>(random, d, m);
            const FT beta = positive(random);
            const Point<Traits> wished = point<Traits>(random_column<Traits>(random, d));
            const Curve<Traits> next = GC::extend_toward(left, order, wished, beta);
            BOOST_CHECK_EQUAL(next.degree(), m);
            BOOST_CHECK(next.domain().second - next.domain().first ==
                        beta * (left.domain().second - left.domain().first));
            const auto join = GC::continuity(left, next, 3);
            BOOST_CHECK_GE(join.f_order, std::min(k, d));
            BOOST_CHECK_GE(join.c_order, 1);
            if (m == 1) continue;
            const Legs<Traits> legs(left);
            const Column<Traits> missing = column<Traits>(wished) - next.coordinates(m);
            if (m > k)
              BOOST_CHECK(is_zero(missing));
            else {
              BOOST_CHECK(orthogonal<Traits>(missing, legs.p));
              if (k == 3) BOOST_CHECK(orthogonal<Traits>(missing, legs.r));
            }
            if (k >= 2 && m > 2) check_stationary(next, 2, legs.p);
            if (k >= 3 && m > 3) check_stationary(next, 3, legs.p);
            if (k >= 3 && m > 3) check_stationary(next, 3, legs.r);
            for (int j = k + 1; j < m; ++j)
              for (int i = 0; i < d; ++i) {
                Column<Traits> axis(d);
                axis[i] = FT(1);
                check_stationary(next, j, axis);
              }
          }
      },
      2);
}

TEST_IN_EVERY_SPACE(close_a_chain) {
  const Curve<Traits> first = curve<Traits>(d, {{0, 0, 1}, {3, 0, -1, 2}, {6, 3, 2}, {6, 6, 1, 1, 3}}, 2, 3),
                      last = curve<Traits>(d, {{6, 6, 1, 1, 3}, {3, 7, 2}, {-3, 5}}, -1, 0);
  const GC::Shape_parameters<FT> shape{FT(2), FT(3)};
  for (const Curve<Traits>& start : {first, last}) // the chain of both curves, and one curve alone
    for (Order order : all_orders) {
      const int k = static_cast<int>(order);
      if (!cancels && order == Order::torsion) continue;
      const Curve<Traits> closing = GC::close(last, start, order, shape);
      BOOST_CHECK_EQUAL(closing.degree(), 2 * k + 1);
      BOOST_CHECK(closing.coordinates(0) == last.coordinates(2));
      BOOST_CHECK(closing.coordinates(2 * k + 1) == start.coordinates(0));
      if (!exact) continue;
      BOOST_CHECK_GE(GC::continuity(last, closing, 3).g_order, k);
      BOOST_CHECK_GE(GC::continuity(closing, start, 3).g_order, k);
      BOOST_CHECK(closing.start_jet(1)[1] == FT(2) * last.end_jet(1)[1]);
      BOOST_CHECK(closing.end_jet(1)[1] == FT(3) * start.start_jet(1)[1]);
    }
  CHECK_ERROR(GC::close(last, first, Order::tangent, {FT(0), FT(1)}), nonpositive_beta);
  if (!rational_numbers) return;
  BOOST_CHECK(same_points<Traits>(GC::close(last, first, Order::curvature),
                                  GC::blend(last, first, GC::Minimal_energy<3>(), {})));
  BOOST_CHECK(same_points<Traits>(GC::close(last, first, Order::torsion),
                                  GC::blend(last, first, GC::Minimal_energy_g3<4>(), {})));
}

BOOST_AUTO_TEST_SUITE_END()
