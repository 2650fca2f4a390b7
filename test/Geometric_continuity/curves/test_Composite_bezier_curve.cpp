// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segmented curves.

#include "support/composite_curves.h"

#include <CGAL/Geometric_continuity/curves/bezier_properties.h>

// --------------------------------------------------------------------------- Hagen, definition 3.1

TEST_FOR_EACH(evaluation_by_the_definition, Traits, All_traits) {
  Random random;
  for (int m = 0; m <= 4; ++m)
    for (int segments = 1; segments <= (m == 0 ? 1 : 4); ++segments) {
      const Composite<Traits> c = random.curve<Traits>(m, segments);
      BOOST_CHECK_EQUAL(c.degree(), m);
      BOOST_CHECK_EQUAL(c.dimension(), test_dimension<Traits>);
      BOOST_CHECK_EQUAL(c.number_of_segments(), segments);
      BOOST_CHECK(c.domain() == std::make_pair(c.knots().front(), c.knots().back()));
      for (int l = 0; l < segments; ++l) {
        const FT t = random.fraction<FT>(), s = FT(1) - t, u = inside<Traits>(c, l, t);
        Column<Traits> sum(c.dimension());
        FT binomial(1); // sum_i b_{ml+i} B_i^m(t)
        for (int i = 0; i <= m; ++i) {
          FT weight = binomial;
          for (int j = 0; j < m; ++j) weight *= j < i ? t : s;
          sum += weight * c.coordinates(m * l + i);
          binomial = FT(binomial * FT(m - i) / FT(i + 1));
        }
        BOOST_CHECK(column<Traits>(c(u)) == sum);
        BOOST_CHECK(c.jet(u, 0)[0] == sum);
        BOOST_CHECK_EQUAL(c.segment_at(u), l);
      }
    }
}

TEST_FOR_EACH(derivatives_on_both_sides_of_a_knot, Traits, All_traits) {
  Random random;
  for (int m = 3; m <= 5; ++m) {
    const Composite<Traits> c = random.curve<Traits>(m, 3);
    for (int l = 0; l < 2; ++l) {
      const auto b = [&](int i) { return c.coordinates(m * (l + 1) + i); };
      const FT x = c.lambda(l), y = c.lambda(l + 1), u = c.knots()[l + 1];
      const FT m1(m), m2(m * (m - 1)), m3(m * (m - 1) * (m - 2));
      const GC::Curve_jet<Traits> left = c.left_jet(u, 3), right = c.right_jet(u, 3);
      BOOST_CHECK(left[0] == b(0));
      BOOST_CHECK(left[1] == FT(m1 / x) * (b(0) - b(-1)));
      BOOST_CHECK(left[2] == FT(m2 / (x * x)) * (b(0) - FT(2) * b(-1) + b(-2)));
      BOOST_CHECK(left[3] == FT(m3 / (x * x * x)) * (b(0) - FT(3) * b(-1) + FT(3) * b(-2) - b(-3)));
      BOOST_CHECK(right[0] == b(0));
      BOOST_CHECK(right[1] == FT(m1 / y) * (b(1) - b(0)));
      BOOST_CHECK(right[2] == FT(m2 / (y * y)) * (b(2) - FT(2) * b(1) + b(0)));
      BOOST_CHECK(right[3] == FT(m3 / (y * y * y)) * (b(3) - FT(3) * b(2) + FT(3) * b(1) - b(0)));
      BOOST_CHECK(c.jet(u, 3) == right);
      BOOST_CHECK(column<Traits>(c(u)) == b(0));
      BOOST_CHECK_EQUAL(c.segment_at(u), l + 1);
      BOOST_CHECK_EQUAL(c.segment_before(u), l);
    }
    // there is one side only at the ends, and the right end belongs to the domain
    const FT first = c.domain().first, last = c.domain().second;
    BOOST_CHECK(c.left_jet(first, 3) == c.segment(0).start_jet(3));
    BOOST_CHECK(c.jet(first, 3) == c.segment(0).start_jet(3));
    BOOST_CHECK(c.jet(last, 3) == c.segment(2).end_jet(3));
    BOOST_CHECK(c.left_jet(last, 3) == c.segment(2).end_jet(3));
    BOOST_CHECK(c.template start_jet_over<FT>(3) == c.jet(first, 3));
    BOOST_CHECK(c.template end_jet_over<FT>(3) == c.jet(last, 3));
  }
}

TEST_FOR_EACH(parameters_outside_the_domain, Traits, All_traits) {
  const Composite<Traits> c = composite<Traits>({{0}, {1}, {2}, {3}, {4}}, {1, 2, 4});
  std::vector<FT> bad = {ratio<FT>(999, 1000), ratio<FT>(4001, 1000)};
  if constexpr (!is_exact<Traits>) bad.push_back(std::numeric_limits<double>::quiet_NaN());
  for (const FT& u : bad) {
    CHECK_ERROR(c(u), parameter_outside_domain);
    CHECK_ERROR(c.jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.left_jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.right_jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.segment_at(u), parameter_outside_domain);
    CHECK_ERROR(c.insert_knot(u), parameter_outside_domain);
    CHECK_ERROR(c.split(u), parameter_outside_domain);
  }
  CHECK_ERROR(c.split(FT(1)), parameter_outside_domain);
  CHECK_ERROR(c.split(FT(4)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(0), FT(2)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(2), FT(5)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(2), FT(2)), empty_domain);
  CHECK_ERROR(c.subrange(FT(3), FT(2)), empty_domain);
  CHECK_ERROR(c.segment_range(-1, 1), parameter_outside_domain);
  CHECK_ERROR(c.segment_range(1, 1), parameter_outside_domain);
  CHECK_ERROR(c.segment_range(0, 3), parameter_outside_domain);
}

// ------------------------------------------------------------------------------------ construction

TEST_FOR_EACH(bad_points_and_knots, Traits, All_traits) {
  const std::vector<typename Traits::Point> b = points<Traits>({{0}, {1}, {2}, {3}, {4}, {5}, {6}});
  const auto make = [&](int n, std::initializer_list<int> knots) {
    return Composite<Traits>(b.begin(), b.begin() + n, numbers<FT>(knots));
  };
  BOOST_CHECK_EQUAL(make(7, {0, 1, 2}).degree(), 3);
  BOOST_CHECK_EQUAL(make(7, {0, 1, 2, 3}).degree(), 2);
  BOOST_CHECK_EQUAL(make(1, {0, 1}).degree(), 0);
  CHECK_ERROR(make(6, {0, 1, 2}), wrong_number_of_points);
  CHECK_ERROR(make(0, {0, 1}), wrong_number_of_points);
  CHECK_ERROR(make(7, {0}), empty_domain);
  CHECK_ERROR(make(7, {}), empty_domain);
  CHECK_ERROR(make(7, {0, 1, 1}), empty_domain);
  CHECK_ERROR(make(7, {0, 2, 1}), empty_domain);
  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
  BOOST_CHECK_EQUAL(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2})).degree(), 3);
  CHECK_ERROR(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2, 3})), wrong_number_of_points);
  if constexpr (!is_exact<Traits>) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, 1, inf}), not_finite);
    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, nan, 2}), not_finite);
    Column<Traits> x(test_dimension<Traits>);
    x[1] = inf;
    std::vector<typename Traits::Point> bad = b;
    bad[2] = GC::to_point<Traits>(x);
    CHECK_ERROR(Composite<Traits>(bad.begin(), bad.end(), {0, 1, 2}), not_finite);
  }
}

BOOST_AUTO_TEST_CASE(points_of_different_dimensions) {
  typedef Exact_d::Point Point;
  const std::vector<Q> x(3, Q(0));
  const std::vector<Point> b = {Point(3, x.begin(), x.end()), Point(2, x.begin(), x.begin() + 2)};
  CHECK_ERROR(Composite<Exact_d>(b.begin(), b.end(), numbers<Q>({0, 1})), dimension_mismatch);
  const std::vector<Bezier<Exact_d>> curves = {Bezier<Exact_d>(b.begin(), b.begin() + 1),
                                               Bezier<Exact_d>(b.begin() + 1, b.end())};
  CHECK_ERROR(Composite<Exact_d>(curves.begin(), curves.end()), dimension_mismatch);
}

TEST_FOR_EACH(from_curves_that_meet, Traits, All_traits) {
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  const std::vector<Bezier<Traits>> parts(c.segments().begin(), c.segments().end());
  BOOST_REQUIRE_EQUAL(parts.size(), 4);
  for (int l = 0; l < 4; ++l) BOOST_CHECK(parts[l] == c.segment(l));
  BOOST_CHECK(Composite<Traits>(parts.begin(), parts.end()) == c);

  // the domains keep their lengths and are moved to follow each other
  std::vector<Bezier<Traits>> moved = parts;
  for (int l = 1; l < 4; ++l) moved[l] = parts[l].with_domain(FT(l), FT(FT(l) + c.lambda(l)));
  BOOST_CHECK(Composite<Traits>(moved.begin(), moved.end()) == c);

  // lower degrees are elevated
  std::vector<Bezier<Traits>> mixed = {random.curve<Traits>(1, 1).segment(0), random.curve<Traits>(4, 1).segment(0),
                                       random.curve<Traits>(2, 1).segment(0)};
  for (int l = 1; l < 3; ++l) {
    std::vector<typename Traits::Point> b(mixed[l].begin(), mixed[l].end());
    b.front() = mixed[l - 1].control_points().back();
    const FT a = mixed[l - 1].domain().second;
    mixed[l] = Bezier<Traits>(b.begin(), b.end(), a, FT(a + FT(1)));
  }
  const Composite<Traits> d(mixed.begin(), mixed.end());
  BOOST_CHECK_EQUAL(d.degree(), 4);
  BOOST_CHECK_EQUAL(d.number_of_segments(), 3);
  for (int l = 0; l < 3; ++l) {
    const FT u = inside<Traits>(d, l, ratio<FT>(1, 2));
    if constexpr (is_exact<Traits>) BOOST_CHECK(d.jet(u, 4) == mixed[l].jet(u, 4));
    // elevation divides by 2, 3 and 4; the coordinates are below 2, and few roundings of 2^-53 are
    // made
    else
      for (int i = 0; i < d.dimension(); ++i) BOOST_CHECK_SMALL(d.jet(u, 0)[0][i] - mixed[l].jet(u, 0)[0][i], 1e-14);
  }
  typedef GC::Composite_bezier_curve<Traits, 5> Quintic;
  BOOST_CHECK_EQUAL(Quintic(mixed.begin(), mixed.end()).degree(), 5);
  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
  CHECK_ERROR(Cubic(mixed.begin(), mixed.end()), wrong_number_of_points);
  BOOST_CHECK(Composite<Traits>(Cubic(parts.begin(), parts.end())) == c);
  BOOST_CHECK(Cubic(c).segment(1) == (GC::Bezier_curve<Traits, 3>(parts[1])));
  CHECK_ERROR(Cubic(d), wrong_number_of_points);

  CHECK_ERROR(Composite<Traits>(parts.begin(), parts.begin()), wrong_number_of_points);
  std::vector<Bezier<Traits>> apart = {parts[0], parts[2]};
  CHECK_ERROR(Composite<Traits>(apart.begin(), apart.end()), curves_do_not_meet);
}

BOOST_AUTO_TEST_CASE(adjacent_domains_are_not_rounded) {
  typedef Double_2::Point Point;
  const double a = -0.1, b = 0.2;
  BOOST_REQUIRE(a + (b - a) != b);
  const std::vector<Bezier<Double_2>> curves = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(-1, a),
                                                Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(a, b)};
  BOOST_CHECK(Composite<Double_2>(curves.begin(), curves.end()).knots() == std::vector<double>({-1, a, b}));
  // a length that vanishes beside the knot before it is refused
  const std::vector<Bezier<Double_2>> tiny = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(0, 1),
                                              Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(0, 1e-20)};
  CHECK_ERROR(Composite<Double_2>(tiny.begin(), tiny.end()), empty_domain);
}

// --------------------------------------------------------------------------------------- iteration

TEST_FOR_EACH(segments_and_joins, Traits, All_traits) {
  Random random;
  for (bool closed : {false, true})
    for (int segments = 1; segments <= 3; ++segments) {
      const Composite<Traits> c = random.curve<Traits>(2, segments, closed);
      BOOST_CHECK_EQUAL(c.is_closed(), closed);
      int l = 0;
      for (const Bezier<Traits>& s : c.segments()) {
        BOOST_CHECK(s == c.segment(l));
        BOOST_CHECK(s.domain() == std::make_pair(c.knots()[l], c.knots()[l + 1]));
        BOOST_CHECK_EQUAL(c.lambda(l), FT(c.knots()[l + 1] - c.knots()[l]));
        for (int i = 0; i <= 2; ++i) BOOST_CHECK(s.coordinates(i) == c.coordinates(2 * l + i));
        ++l;
      }
      BOOST_CHECK_EQUAL(l, segments);
      int n = 0;
      for (const typename Composite<Traits>::Join& join : c.joins()) {
        BOOST_CHECK_EQUAL(join.left, n);
        BOOST_CHECK_EQUAL(join.right, n + 1 < segments ? n + 1 : 0);
        BOOST_CHECK_EQUAL(c.ratio(join), FT(c.lambda(join.right) / c.lambda(join.left)));
        ++n;
      }
      BOOST_CHECK_EQUAL(n, closed ? segments : segments - 1);
      BOOST_CHECK_EQUAL(c.number_of_joins(), n);
    }
}

// ------------------------------------------------------------------------------------ other curves

TEST_FOR_EACH(a_knot_is_inserted, Traits, All_traits) {
  Random random;
  for (int m = 0; m <= 3; ++m) {
    const int segments = m == 0 ? 1 : 3;
    const Composite<Traits> c = random.curve<Traits>(m, segments);
    for (const FT& u : c.knots()) BOOST_CHECK(c.insert_knot(u) == c);
    for (int l = 0; l < segments; ++l) {
      const FT u = inside<Traits>(c, l, is_exact<Traits> ? random.fraction<FT>() : ratio<FT>(1, 2));
      const Composite<Traits> d = c.insert_knot(u);
      std::vector<FT> knots = c.knots();
      knots.insert(knots.begin() + l + 1, u);
      BOOST_CHECK(d.knots() == knots);
      BOOST_CHECK_EQUAL(d.degree(), m);
      BOOST_CHECK(column<Traits>(d(u)) == column<Traits>(c(u)));
      BOOST_CHECK(d.left_jet(u, m) == d.right_jet(u, m));
      BOOST_CHECK(same_function<Traits>(c, d, random));
    }
  }
}

TEST_FOR_EACH(parts, Traits, All_traits) {
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j <= 4; ++j) {
      const Composite<Traits> part = c.segment_range(i, j);
      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i);
      for (int l = i; l < j; ++l) BOOST_CHECK(part.segment(l - i) == c.segment(l));
      BOOST_CHECK(part == c.subrange(c.knots()[i], c.knots()[j]));
    }
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j) {
      const FT u = inside<Traits>(c, i, ratio<FT>(1, 2)),
               v = inside<Traits>(c, j, i == j ? ratio<FT>(3, 4) : ratio<FT>(1, 2));
      const Composite<Traits> part = c.subrange(u, v);
      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i + 1);
      BOOST_CHECK(part.domain() == std::make_pair(u, v));
      BOOST_CHECK(part.left_jet(v, 3) == c.left_jet(v, 3));
      for (int l = 0; l <= j - i; ++l) {
        const FT w = inside<Traits>(part, l, ratio<FT>(1, 2));
        BOOST_CHECK(part.jet(w, 3) == c.jet(w, 3));
      }
    }
  const FT u = inside<Traits>(c, 2, ratio<FT>(1, 4));
  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(u);
  BOOST_CHECK(halves.first == c.subrange(c.domain().first, u));
  BOOST_CHECK(halves.second == c.subrange(u, c.domain().second));
  std::vector<Bezier<Traits>> all(halves.first.segments().begin(), halves.first.segments().end());
  for (const Bezier<Traits>& s : halves.second.segments()) all.push_back(s);
  BOOST_CHECK(Composite<Traits>(all.begin(), all.end()) == c.insert_knot(u));
  const std::pair<Composite<Traits>, Composite<Traits>> at_knot = c.split(c.knots()[1]);
  BOOST_CHECK(at_knot.first == c.segment_range(0, 1) && at_knot.second == c.segment_range(1, 4));
}

TEST_FOR_EACH(run_through_backwards, Traits, All_traits) {
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 3), r = c.reverse();
  BOOST_CHECK(r.domain() == c.domain());
  BOOST_CHECK(r.reverse() == c);
  for (int l = 0; l < 3; ++l) BOOST_CHECK_EQUAL(r.lambda(l), c.lambda(2 - l));
  const FT sum = c.domain().first + c.domain().second;
  for (const FT& u : {inside<Traits>(c, 1, ratio<FT>(1, 4)), c.knots()[1], c.knots()[0], c.knots()[3]}) {
    const GC::Curve_jet<Traits> x = c.right_jet(u, 3), y = r.left_jet(FT(sum - u), 3);
    for (int j = 0; j <= 3; ++j) BOOST_CHECK(y[j] == FT(j % 2 == 0 ? 1 : -1) * x[j]);
  }
}

BOOST_AUTO_TEST_CASE(reversal_of_rounded_knots) {
  typedef Double_2::Point Point;
  const std::vector<Point> b = {Point(0, 0), Point(1, 0), Point(1, 1)};
  const double x = -0.1, y = 0.2;
  BOOST_REQUIRE(x + (y - x) != y);
  for (double u : {-0.05, 0.03, 0.07, 0.19}) {
    const Composite<Double_2> r = Composite<Double_2>(b.begin(), b.end(), {x, u, y}).reverse();
    BOOST_CHECK(r.domain() == std::make_pair(x, y));
    // at most four roundings of numbers below 1
    BOOST_CHECK_SMALL(r.knots()[1] - (x + y - u), 1e-15);
  }
  CHECK_ERROR(Composite<Double_2>(b.begin(), b.end(), {0, 1e-20, 1}).reverse(), empty_domain);
}

TEST_FOR_EACH(values, Traits, All_traits) {
  Random random;
  const Composite<Traits> c = random.curve<Traits>(2, 3);
  Composite<Traits> d = c;
  BOOST_CHECK(c == d);
  d = c.insert_knot(inside<Traits>(c, 0, ratio<FT>(1, 2)));
  BOOST_CHECK(c != d);
  std::vector<FT> knots = c.knots();
  knots.back() += FT(1);
  BOOST_CHECK(c != Composite<Traits>(c.begin(), c.end(), knots));
  std::vector<typename Traits::Point> b(c.begin(), c.end());
  std::swap(b[1], b[3]);
  BOOST_CHECK(c != Composite<Traits>(b.begin(), b.end(), c.knots()));

  const Column<Traits> shift = random.column<Traits>();
  const auto map = [&](const typename Traits::Point& p) {
    return GC::to_point<Traits>(FT(2) * column<Traits>(p) + shift);
  };
  const Composite<Traits> image = c.transform(map);
  BOOST_CHECK(image.knots() == c.knots());
  const FT u = inside<Traits>(c, 1, ratio<FT>(1, 2));
  BOOST_CHECK(column<Traits>(image(u)) == FT(2) * column<Traits>(c(u)) + shift);
}

BOOST_AUTO_TEST_CASE(output) {
  const Composite<Exact_2> c = composite<Exact_2>({{0, 0}, {1, 2}, {3, 4}}, {0, 1, 3});
  BOOST_CHECK_EQUAL(text(c), "Bezier curve of degree 1 on [0, 1]: (0, 0) (1, 2)\n"
                             "Bezier curve of degree 1 on [1, 3]: (1, 2) (3, 4)\n");
  GC::Chain_summary summary;
  BOOST_CHECK_EQUAL(text(summary), "0 joins");
  GC::Join_continuity<Q> join;
  join.c_order = 0;
  join.g_order = 3;
  join.f_order = 2;
  summary.add(join);
  BOOST_CHECK_EQUAL(text(summary), "1 join, C0 G3 F2 or more");
  join.c_order = join.g_order = join.f_order = -1;
  summary.add(join);
  BOOST_CHECK_EQUAL(text(summary), "2 joins, 1 with a gap");
}

TEST_FOR_EACH(a_segmented_curve_is_a_parametric_curve, Traits, All_traits) {
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(inside<Traits>(c, 1, ratio<FT>(1, 2)));
  const auto join = GC::continuity(halves.first, halves.second);
  BOOST_CHECK_EQUAL(join.c_order, 3);
  BOOST_CHECK_EQUAL(GC::continuity(c, c).c_order, -1);
}
