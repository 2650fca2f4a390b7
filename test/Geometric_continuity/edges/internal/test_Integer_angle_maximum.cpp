// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The search for the largest angle in integers of fixed length, against known largest values, and
// against multi-precision.

#include "support/nets.h"

#include <CGAL/Geometric_continuity/edges/internal/Edge_decision.h>
#include <CGAL/Geometric_continuity/edges/internal/Largest_measure.h>

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

typedef GC::internal::Common_denominator<Q>::Ring Ring;
typedef GC::internal::Homogeneous_polynomial<Ring> Whole;
typedef GC::internal::Integer_angle_maximum<Q, Whole> Fixed;

// a t^i (1-t)^j, of degree n
Whole bump(const Ring& a, int i, int j, int n) {
  std::vector<Ring> c(i + j + 1, Ring(0));
  c[i] = a;
  return Whole(c).elevated_to(n);
}

Q power(const Q& x, int n) {
  Q y(1);
  for (; n > 0; --n) y *= x;
  return y;
}

// Its largest value, at i/(i+j).
Q largest_value(const Ring& a, int i, int j) { return Q(Q(a) * power(i, i) * power(j, j) / power(i + j, i + j)); }

// Returns whether the angle is at most four units in the last place wide.
bool is_accurate(const GC::Normal_deviation<Q>& d) {
  const GC::Enclosure angle = d.angle();
  double x = angle.lower;
  for (int i = 0; i < 4; ++i) x = std::nextafter(x, 4);
  return angle.upper <= x;
}

std::optional<GC::Normal_deviation<Q>> search(const Whole& s, const Whole& p, GC::Work_limit limit = GC::Work_limit()) {
  const GC::Work_scope each(limit);
  const GC::internal::Work_guard work("test");
  return Fixed(s, p)();
}

BOOST_AUTO_TEST_CASE(known_largest_values) {
  Random random;
  int found = 0;
  for (int k = 0; k < 300; ++k) {
    const int i = random.integer(0, 8), j = random.integer(i == 0 ? 1 : 0, 8), n = random.integer(i + j, 40);
    Ring a(random.integer(1, 999999)), b(a * Ring(random.integer(2, 99)));
    for (int l = random.integer(0, 30); l > 0; --l) b *= Ring(10); // small angles, too
    for (int l = random.integer(0, 30); l > 0; --l) {
      a *= Ring(7);
      b *= Ring(7);
    }
    const std::optional<GC::Normal_deviation<Q>> d = search(bump(a, i, j, n), bump(b, 0, 0, n));
    if (!d) continue;
    ++found;
    const Q largest = Q(largest_value(a, i, j) / Q(b)), place = Q(i) / Q(i + j);
    BOOST_CHECK(d->lower <= largest && largest <= d->upper);
    BOOST_CHECK(is_accurate(*d));
    BOOST_CHECK(d->begin <= place && place <= d->end && Q(d->end - d->begin) <= Q(1) / Q(32));
    if (i == 0 || j == 0) BOOST_CHECK(d->lower == largest && d->upper == largest);
  }
  BOOST_CHECK_GT(found, 250);
}

// Largest values in the middle and at both ends, where the polynomials are small or zero next to
// them.
BOOST_AUTO_TEST_CASE(steep_and_equal_largest_values) {
  // 1 and (2t - 1)^2
  const Whole e = bump(Ring(1), 0, 0, 2), square(std::vector<Ring>{Ring(1), Ring(-2), Ring(1)});
  const auto times = [](const Ring& a, const Whole& f) { return bump(a, 0, 0, 0) * f; };
  const auto power_of_two = [](int n) {
    Ring x(1);
    for (; n > 0; --n) x *= Ring(2);
    return x;
  };
  const auto check_quarter = [](const std::optional<GC::Normal_deviation<Q>>& d) {
    BOOST_REQUIRE(d.has_value());
    const Q quarter = Q(1) / Q(4), half = Q(1) / Q(2);
    BOOST_CHECK(d->lower <= quarter && quarter <= d->upper && is_accurate(*d));
    BOOST_CHECK(d->begin <= half && half <= d->end);
  };
  // ((1 - x)/(1 + x))^2 / 4 where x = k (2t - 1)^2: zero next to the middle
  for (const int k : {256, 1024}) {
    const Whole x = times(Ring(k), square), s = e - x, p = e + x;
    check_quarter(search(s * s, times(Ring(4), p * p)));
  }
  // 1 / (4 (1 + x)): the divisor is much smaller in the middle than elsewhere
  check_quarter(search(e, times(Ring(4), e + times(power_of_two(62), square))));
  // 1 / (1 + x), a right angle on almost no part of the edge
  BOOST_CHECK(!search(e, e + times(power_of_two(60), square)));
  // a divisor at an end of which no digit is left
  BOOST_CHECK(!search(bump(Ring(1), 0, 0, 1), bump(Ring(2), 0, 0, 1) + bump(power_of_two(130), 1, 0, 1)));
  // largest at both ends, or at the second by less than a rounding error: 3/4, or 2^-62 more
  for (const int a : {0, 1}) {
    const Ring three = Ring(3) * power_of_two(60), more = Ring(three + Ring(a));
    const Whole both(std::vector<Ring>{three, Ring(-4) * three, Ring(9) * three, Ring(-4) * three, more});
    const std::optional<GC::Normal_deviation<Q>> d = search(both, bump(power_of_two(62), 0, 0, 4));
    BOOST_REQUIRE(d.has_value());
    const Q largest = Q(Q(more) / Q(power_of_two(62)));
    BOOST_CHECK(d->lower == largest && d->upper == largest);
    BOOST_CHECK(a == 0 ? d->begin == Q(0) : d->end == Q(1));
  }
}

BOOST_AUTO_TEST_CASE(what_fixed_length_leaves_open) {
  const auto one = [](int n) { return bump(Ring(1), 0, 0, n); };
  BOOST_CHECK(!search(one(4), bump(Ring(3), 0, 0, 4)));                     // constant
  BOOST_CHECK(!search(bump(Ring(4), 1, 1, 2), one(2)));                     // a right angle
  BOOST_CHECK(!search(bump(Ring(1), 1, 1, 41), one(41)));                   // the degree
  BOOST_CHECK(!search(bump(Ring(1), 1, 1, 4), one(4), GC::Work_limit(50))); // the work
  BOOST_CHECK(search(bump(Ring(1), 1, 1, 4), one(4)).has_value());
  Ring huge(1);
  for (int i = 0; i < 300; ++i) huge *= Ring(10);
  BOOST_CHECK(!search(bump(Ring(1), 1, 1, 4), bump(huge, 0, 0, 4))); // a unit that is no double
  for (int i = 0; i < 100; ++i) huge *= Ring(10);
  BOOST_CHECK(!search(bump(Ring(1), 1, 1, 4), bump(huge, 0, 0, 4))); // a tiny angle
  // numbers beyond the largest double
  BOOST_CHECK(!search(bump(huge, 1, 1, 4), bump(huge * 2, 0, 0, 4)));
  BOOST_CHECK(!search(Whole(std::vector<Ring>(5, Ring(0))), one(4))); // no angle
}

// If two spans have one defect, the span with the larger angle is worse. A span whose angle is
// unknown is not worse.
BOOST_AUTO_TEST_CASE(worse_spans) {
  GC::Edge_continuity<Q> none, small;
  none.g_order = small.g_order = 0;
  none.defect = small.defect = GC::Edge_defect::crease;
  small.deviation = GC::Normal_deviation<Q>{Q(1) / Q(8), Q(1) / Q(4), Q(0), Q(1)};
  GC::Edge_continuity<Q> large = small;
  large.deviation->upper = Q(1) / Q(2);
  using GC::internal::is_worse;
  BOOST_CHECK(is_worse(small, none) && !is_worse(none, small) && !is_worse(none, none));
  BOOST_CHECK(is_worse(large, small) && !is_worse(small, large));
}

// Where the surfaces continue each other, or numbers are not exact, there is no crease to find.
BOOST_AUTO_TEST_CASE(no_crease) {
  const auto layers = [](double y) {
    GC::internal::Edge_layers x;
    x.along = x.across = 1;
    x.layers = 2;
    for (int i = 0; i < 2; ++i) {
      x.p[0][i] = {1. * i, 0, 0};
      x.p[1][i] = {1. * i, y, i * y};
    }
    return x;
  };
  const GC::internal::Edge_layers a = layers(1), b = layers(-1), c = layers(2);
  const GC::internal::Work_guard work("test");
  GC::internal::Edge_ladder smooth(a, b), fold(a, c);
  BOOST_CHECK(!GC::internal::crease_on_grid<Q>(smooth));
  BOOST_CHECK(!GC::internal::crease_on_grid<Q>(fold));
  BOOST_CHECK(!GC::internal::crease_on_grid<double>(smooth));
}

// Two patches of degree n along their edge with random points, whose angles are less than 90
// degrees for small `steep`.
BOOST_AUTO_TEST_CASE(creases_in_fixed_length_and_multiprecision) {
  Random random;
  int decided = 0;
  for (int k = 0; k < 120; ++k) {
    const int n = random.integer(1, 5), size = k % 3 == 0 ? 9 : 9999, steep = k % 7 == 0 ? size : size / 9;
    Net a(n + 1, std::vector<Column>(2)), b = a;
    for (int i = 0; i <= n; ++i) {
      a[i][0] = {Q(10 * size * i + random.integer(0, size)), Q(random.integer(0, size)), Q(random.integer(0, size))};
      b[i][0] = a[i][0];
      a[i][1] = {Q(a[i][0][0] + random.integer(0, size)), Q(a[i][0][1] - 10 * size),
                 Q(a[i][0][2] + random.integer(-steep, steep))};
      b[i][1] = {Q(a[i][0][0] + random.integer(0, size)), Q(a[i][0][1] + 10 * size),
                 Q(a[i][0][2] + random.integer(-steep, steep))};
    }
    typedef CGAL::Simple_cartesian<Q> K;
    const std::vector<Patch<K>> both = patches<K>({a, b});
    const Patch<K>&p = both[0], &q = both[1];
    const GC::Edge_rows<Q> rows = GC::edge_rows(p, v0), other = GC::edge_rows(q, v0);
    GC::internal::Edge_layers x, y;
    BOOST_REQUIRE((GC::internal::edge_layers(p, v0, q, v0, 2, x, y)));
    const GC::internal::Work_guard work("test");
    GC::internal::Edge_ladder ladder(x, y);
    const std::optional<GC::Edge_continuity<Q>> found = GC::internal::crease_on_grid<Q>(ladder);
    const GC::Edge_continuity<Q> expected = GC::internal::decide_rough_edge(rows, other);
    if (!found) continue;
    ++decided;
    BOOST_CHECK(found->g_order == expected.g_order && found->defect == expected.defect &&
                found->coplanar == expected.coplanar && found->side == expected.side &&
                found->collapsed == expected.collapsed && found->normal_vanishes == expected.normal_vanishes &&
                found->vanishing == expected.vanishing);
    BOOST_REQUIRE(found->deviation && expected.deviation);
    BOOST_CHECK(
        found->deviation->lower == expected.deviation->lower && found->deviation->upper == expected.deviation->upper &&
        found->deviation->begin == expected.deviation->begin && found->deviation->end == expected.deviation->end);
    // the search in multi-precision
    const GC::internal::Edge_sides<Q> sides(rows, other);
    const GC::internal::Edge_normals<Q> normals(sides);
    GC::internal::Edge_measure<Q> m(normals.n1, normals.n2, false);
    const GC::Normal_deviation<Q> d = GC::internal::Largest_measure<Q>(m.s, m.p, m.side)();
    BOOST_CHECK(d.lower <= found->deviation->upper && found->deviation->lower <= d.upper);
    BOOST_CHECK(is_accurate(d) && is_accurate(*found->deviation));
    BOOST_CHECK(d.begin <= found->deviation->end && found->deviation->begin <= d.end);
  }
  BOOST_CHECK_GT(decided, 80);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
