// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The largest kink over all instances: known ones, and enclosures against exact samples.

#define BOOST_TEST_MODULE largest_kink
#define BOOST_TEST_DYN_LINK
#include <boost/test/unit_test.hpp>

#include "support/errors.h"
#include "tools/formats/font/variable_fonts.h"

#include "formats/font/largest_kink.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Q;
typedef std::vector<Q> Instance;
using GC::Verdict;

namespace {

constexpr unsigned seed = 20261122;
constexpr int one = 0x4000; // 1 in normalised values
constexpr double degree = 0.017453292519943295;
std::mt19937 engine(seed);

int number(int low, int high) { return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)); }

GC::Kink_bound degrees(const Q& x) { return GC::Kink_bound(x); }

// Axes from -1 to 1, of which the first ones are from 0.
std::vector<GC::Variation_axis> axes(std::size_t count, std::size_t from_zero = 0) {
  std::vector<GC::Variation_axis> axes;
  for (std::size_t k = 0; k < count; ++k) axes.push_back({"axis", k < from_zero ? 0 : -1, 0, 1, {}});
  return axes;
}

GC::Variation_region region(const std::vector<int>& peaks) {
  std::vector<GC::Region_axis> axes;
  for (int p : peaks) axes.push_back({(std::min)(p, 0), p, (std::max)(p, 0)});
  return GC::Variation_region(axes);
}

struct Legs {
  GC::Variable_join join;
  std::vector<GC::Variation_region> regions;
};

// One axis from 0 to 1, legs that are linear in it.
Legs linear(const GC::Outline_vector& a, const GC::Outline_vector& a_step, const GC::Outline_vector& b,
            const GC::Outline_vector& b_step) {
  return {{0, 0, {a, {a_step}}, {b, {b_step}}}, {region({one})}};
}

// Cross and dot product at an instance.
std::pair<Q, Q> products(const Legs& legs, const Instance& instance) {
  Instance scalars;
  for (const GC::Variation_region& r : legs.regions) scalars.push_back(r.scalar(instance));
  const GC::Outline_vector a = legs.join.incoming(scalars), b = legs.join.outgoing(scalars);
  return {Q(a[0] * b[1] - a[1] * b[0]), Q(a[0] * b[0] + a[1] * b[1])};
}

GC::Enclosure angle(const std::pair<Q, Q>& p) { return GC::angle_enclosure(Q(p.first * p.first), p.second); }

// The answer, which must agree with itself and with the angle at its instance.
GC::Largest_kink checked(const Legs& legs, const std::vector<GC::Variation_axis>& axes, const Q& bound,
                         const GC::Kink_search& search = GC::Kink_search()) {
  const GC::Largest_kink kink = GC::largest_kink(legs.join, legs.regions, axes, degrees(bound), search);
  BOOST_CHECK_LE(kink.angle.lower, kink.angle.upper);
  const std::pair<Q, Q> p = products(legs, kink.instance);
  if (p.first != 0 || p.second != 0) {
    const GC::Enclosure here = angle(p);
    BOOST_CHECK_LE(kink.angle.lower, here.lower);
    BOOST_CHECK_LE(here.lower, kink.angle.upper);
    if (kink.verdict != Verdict::proved)
      BOOST_CHECK((kink.verdict == Verdict::refuted) == degrees(bound).is_exceeded(p.first, p.second));
  }
  return kink;
}

} // namespace

BOOST_AUTO_TEST_CASE(between_the_masters) {
  // parallel at 0 and 1; in between a x b = 4000 t (1 - t)
  const Legs legs = linear({100, 0}, {0, 20}, {100, 0}, {200, 60});
  double largest = 0;
  for (int i = 0; i <= 1000; ++i) largest = (std::max)(largest, angle(products(legs, {Q(i) / 1000})).lower);
  BOOST_CHECK(products(legs, {Q(0)}).first == 0 && products(legs, {Q(1)}).first == 0);
  const GC::Largest_kink kink = checked(legs, axes(1, 1), 5);
  BOOST_CHECK(kink.verdict == Verdict::proved);
  BOOST_CHECK_LE(largest, kink.angle.upper);
  BOOST_CHECK_LE(kink.angle.upper, 1.0101 * kink.angle.lower);
  BOOST_CHECK(2.8 * degree < kink.angle.lower && kink.angle.upper < 3.2 * degree);
  BOOST_CHECK(!kink.vanishes);
  // bounds very near to the largest angle are decided
  const GC::Largest_kink sharp = checked(legs, axes(1, 1), 5, {1e-9, 0, 100000});
  BOOST_CHECK_LE(sharp.angle.upper, sharp.angle.lower * (1 + 2e-9));
  const Q low(sharp.angle.lower / degree * (1 - 1e-8)), high(sharp.angle.upper / degree * (1 + 1e-8));
  BOOST_CHECK(checked(legs, axes(1, 1), low).verdict == Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), high).verdict == Verdict::proved);
  BOOST_CHECK(checked(legs, axes(1, 1), high, {0.01, 0, 2}).verdict == Verdict::undecided); // not enough boxes
}

BOOST_AUTO_TEST_CASE(smooth_in_every_instance) {
  for (const Legs& legs : {linear({100, 0}, {30, 0}, {7, 0}, {Q(1) / 3, 0}),           // both horizontal
                           linear({10, 20}, {-1, -2}, {5, 10}, {50, 100}),             // of one direction
                           linear({3, -4}, {Q(1) / 7, 9}, {6, -8}, {Q(2) / 7, 18})}) { // multiples of each other
    const GC::Largest_kink kink = checked(legs, axes(1, 1), Q(1) / 1000);
    BOOST_CHECK(kink.verdict == Verdict::proved);
    BOOST_CHECK(kink.angle == (GC::Enclosure{0, 0}));
  }
}

BOOST_AUTO_TEST_CASE(large_angles_and_legs_without_length) {
  // a right angle, and a reversal
  GC::Largest_kink kink = checked(linear({1, 0}, {0, 0}, {1, 0}, {-1, 1}), axes(1, 1), 5);
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  BOOST_CHECK_GE(kink.angle.lower, 89.999 * degree);
  kink = checked(linear({1, 0}, {0, 0}, {2, 0}, {-3, 0}), axes(1, 1), 89);
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  BOOST_CHECK(kink.angle.lower > 179.9 * degree && std::isfinite(kink.angle.upper));
  // a handle that is retracted at the end keeps its direction until there
  kink = checked(linear({100, 1}, {-100, -1}, {50, 0}, {20, 0}), axes(1, 1), 5);
  BOOST_CHECK(kink.verdict == Verdict::proved && kink.vanishes);
  BOOST_CHECK(0.57 * degree < kink.angle.lower && kink.angle.upper < 0.58 * degree);
  // one that is zero in the middle turns round there
  kink = checked(linear({100, 0}, {-200, 0}, {50, 0}, {20, 0}), axes(1, 1), 5);
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  // one that is zero at one place inside of the space: undecided, after the work that is allowed
  const Legs circle{{0, 0, {{-10, 10}, {{20, 0}, {0, 20}, {0, -20}}}, {{10, 0}, {{0, 0}, {0, 0}, {0, 0}}}},
                    {region({one, 0}), region({0, one}), region({one, 0})}};
  kink = checked(circle, axes(2, 2), 5, {0.01, 1e-5, 300});
  BOOST_CHECK(kink.verdict != Verdict::proved && std::isfinite(kink.angle.upper));
}

BOOST_AUTO_TEST_CASE(exactly_the_bound) { // 45 degrees at the end; the bound itself is not exceeded there
  const Legs legs = linear({1, 0}, {0, 0}, {1, 0}, {0, 1});
  BOOST_CHECK(checked(legs, axes(1, 1), 45).verdict != Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), Q(45) - Q(1) / 1000000000).verdict == Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), Q(45) + Q(1) / 1000000000).verdict == Verdict::proved);
}

BOOST_AUTO_TEST_CASE(regions_that_jump) { // a kink of 45 degrees from 1/2 on, up to 1/2, or there only
  for (const GC::Region_axis& axis : {GC::Region_axis{one / 2, one / 2, one},
                                      {0, one / 2, one / 2},
                                      {one / 2, one / 2, one / 2},
                                      {one, one, one},
                                      {-one, -one, -one}}) {
    const Legs legs{{0, 0, {{1, 0}, {{0, 0}}}, {{1, 0}, {{0, 1}}}}, {GC::Variation_region({axis})}};
    const GC::Largest_kink kink = checked(legs, axes(1), 5);
    BOOST_CHECK(kink.verdict == Verdict::refuted);
    BOOST_CHECK(kink.instance[0] == GC::Variation_region::value(axis.peak));
    BOOST_CHECK(44.9 * degree < kink.angle.lower && kink.angle.upper < 45.1 * degree);
  }
}

BOOST_AUTO_TEST_CASE(random_joins_against_samples) {
  std::cout << "seed " << seed << '\n';
  int proved = 0, refuted = 0, undecided = 0;
  for (int round = 0; round < 120; ++round) {
    const std::size_t dimension = static_cast<std::size_t>(round % 3 + 1), from_zero = engine() % (dimension + 1);
    Legs legs{{0, 0, {{number(50, 400), number(-5, 5)}, {}}, {{number(50, 400), number(-5, 5)}, {}}}, {}};
    for (int r = number(1, 5); r > 0; --r) {
      std::vector<GC::Region_axis> region;
      for (std::size_t k = 0; k < dimension; ++k) {
        int x[3];
        for (int& y : x) y = number(0, 8) * (one / 8);
        std::sort(x, x + 3);
        const bool negative = engine() % 2 == 0;
        if (number(0, 3) == 0)
          region.push_back({0, 0, 0});
        else if (number(0, 1) == 0)
          region.push_back(negative ? GC::Region_axis{-one, -one, 0} : GC::Region_axis{0, one, one});
        else if (x[0] < x[1] && x[1] < x[2]) // without jumps
          region.push_back(negative ? GC::Region_axis{-x[2], -x[1], -x[0]} : GC::Region_axis{x[0], x[1], x[2]});
        else
          region.push_back({one / 8, one / 2, one});
      }
      legs.regions.emplace_back(region);
      const auto shift = [&] {
        return GC::Outline_vector{Q(number(-40, 40)) / number(1, 3), Q(number(-9, 9)) / number(1, 3)};
      };
      legs.join.incoming.shifts.push_back(shift());
      legs.join.outgoing.shifts.push_back(shift());
    }
    const std::vector<GC::Variation_axis> space = axes(dimension, from_zero);
    const Q bound = Q(number(1, 80)) / 10;
    const GC::Largest_kink kink = checked(legs, space, bound);
    (kink.verdict == Verdict::proved ? proved : kink.verdict == Verdict::refuted ? refuted : undecided) += 1;
    for (int sample = 0; sample < 60; ++sample) {
      Instance instance;
      for (std::size_t k = 0; k < dimension; ++k) instance.push_back(Q(number(k < from_zero ? 0 : -24, 24)) / 24);
      const std::pair<Q, Q> p = products(legs, instance);
      if (p.first == 0 && p.second == 0) continue;
      BOOST_CHECK_LE(angle(p).lower, kink.angle.upper);
      if (kink.verdict == Verdict::proved) BOOST_CHECK(!degrees(bound).is_exceeded(p.first, p.second));
    }
    if (kink.verdict != Verdict::undecided && kink.angle.lower < 1.5)
      BOOST_CHECK_LE(std::tan(kink.angle.upper), 1.011 * std::tan(kink.angle.lower) + 1e-5);
  }
  std::cout << proved << " proved, " << refuted << " refuted, " << undecided << " undecided\n";
  BOOST_CHECK(proved > 20 && refuted > 20 && undecided < 10);
}

BOOST_AUTO_TEST_CASE(joins_of_a_font) {
  // 0 on, 1 control, 2 on with a kink between the masters, 3 control, 4 on; 5 and 6 coincide with 4 and 0
  Font_writer w;
  w.axes = {{"wght", 100, 100, 900}};
  Font_writer::Glyph glyph{{{{0, -50}, {0, 0, false}, {100, 0}, {200, 0, false}, {200, -50}, {200, -50, false}}}};
  Font_writer::Tuple tuple{{one}, {0, 0, 0, 200, 0, 0, 0, 0, 0, 0}, {0, -20, 0, 60, 0, 0, 0, 0, 0, 0}};
  glyph.tuples = {tuple};
  w.glyphs = {glyph};
  const std::string bytes = w.font();
  const GC::Variable_font font{GC::Font_tables(bytes)};
  const GC::Variable_outline outline = font.glyph(0);
  const std::vector<GC::Variable_join> joins = GC::variable_joins(outline);
  BOOST_REQUIRE_EQUAL(joins.size(), 3u); // at 0, 2 and 5, which is 4
  BOOST_CHECK(joins[0].point == 0 && joins[1].point == 2 && joins[2].point == 5);
  const std::vector<Q> initial{Q(0)};
  BOOST_CHECK(*GC::is_corner(joins[0], initial, GC::Kink_bound()));
  BOOST_CHECK(!*GC::is_corner(joins[1], initial, GC::Kink_bound()));
  const Legs expected = linear({100, 0}, {0, 20}, {100, 0}, {200, 60}); // as in between_the_masters
  for (int i = 0; i <= 4; ++i)
    BOOST_CHECK(products({joins[1], outline.regions}, {Q(i) / 4}) == products(expected, {Q(i) / 4}));
  const GC::Largest_kink kink = GC::largest_kink(joins[1], outline.regions, font.axes(), GC::Kink_bound(1));
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  BOOST_CHECK(kink.instance[0] > 0 && kink.instance[0] < 1);
  const Q weight = font.axes()[0].user_value(kink.instance[0]);
  BOOST_CHECK(weight > 300 && weight < 700);
  // two control points that coincide across the end of the contour are a point on the curve
  w.glyphs[0] = {{{{0, 0, false}, {100, 0}, {100, 100}, {0, 0, false}}}};
  const std::string round = w.font();
  const GC::Variable_outline closed = GC::Variable_font(GC::Font_tables(round)).glyph(0);
  BOOST_REQUIRE_EQUAL(GC::variable_joins(closed).size(), 3u);
  BOOST_CHECK(*GC::is_corner(GC::variable_joins(closed)[0], {}, GC::Kink_bound()));
  // a leg without length at one instance only
  GC::Variable_join join = joins[1];
  join.incoming.constant = {0, 0};
  BOOST_CHECK(!GC::is_corner(join, initial, GC::Kink_bound()));
  BOOST_CHECK(GC::is_corner(join, {Q(1)}, GC::Kink_bound()).has_value());
}

BOOST_AUTO_TEST_CASE(refusals) {
  const Legs legs = linear({1, 0}, {0, 0}, {1, 0}, {0, 1});
  CHECK_ERROR(GC::largest_kink(legs.join, legs.regions, axes(1), degrees(90)), parameter_outside_domain);
  Legs four{legs.join, {region({one, one, one, one})}};
  BOOST_CHECK_EQUAL(GC::axes_of(four.join, four.regions, axes(4)), 4);
  CHECK_ERROR(GC::largest_kink(four.join, four.regions, axes(4), degrees(5)), work_limit);
  // of four axes only those count on which the join depends, and which vary
  std::vector<GC::Variation_axis> three = axes(4);
  three[2].minimum = three[2].maximum = 0;
  BOOST_CHECK_EQUAL(GC::axes_of(four.join, four.regions, three), 3);
  four.regions = {region({one, 0, one, 0})};
  BOOST_CHECK_EQUAL(GC::axes_of(four.join, four.regions, axes(4)), 2);
  BOOST_CHECK(checked(four, axes(4), 44).verdict == Verdict::refuted);
}
