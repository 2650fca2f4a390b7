// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The largest kink over all instances: known ones, and enclosures against exact samples.

#define BOOST_TEST_MODULE largest_kink
#include "support/test.h"

#include "formats/font/largest_kink.h"

typedef std::vector<Q> Instance;
typedef GC::Variable_vector::Vector Vector;
using GC::Verdict;

namespace {

constexpr unsigned seed = 20261122;
constexpr double degree = 0.017453292519943295;
std::mt19937 engine(seed);

int number(int low, int high) { return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)); }

GC::Corner_threshold degrees(const Q& x) { return GC::Corner_threshold(x); }

// Axes from -1 to 1, of which the first ones are from 0.
std::vector<GC::Variation_range> axes(std::size_t count, std::size_t from_zero = 0) {
  std::vector<GC::Variation_range> axes;
  for (std::size_t k = 0; k < count; ++k) axes.push_back({k < from_zero ? 0. : -1., 1});
  return axes;
}

GC::Variation_region region(const std::vector<double>& peaks) {
  std::vector<GC::Region_axis> axes;
  for (double p : peaks) axes.push_back({(std::min)(p, 0.), p, (std::max)(p, 0.)});
  return GC::Variation_region(axes);
}

struct Legs {
  GC::Variable_join join;
  std::vector<GC::Variation_region> regions;
};

// One axis from 0 to 1, legs that are linear in it.
Legs linear(const Vector& a, const Vector& a_step, const Vector& b, const Vector& b_step) {
  return {{{a, {a_step}}, {b, {b_step}}}, {region({1})}};
}

// Cross and dot product at an instance.
std::pair<Q, Q> products(const Legs& legs, const Instance& instance) {
  return legs.join.products(GC::region_scalars(legs.regions, instance));
}

GC::Enclosure angle(const std::pair<Q, Q>& p) { return GC::angle_enclosure(Q(p.first * p.first), p.second); }

// The answer, which must agree with itself and with the angle at its instance.
GC::Largest_kink checked(const Legs& legs, const std::vector<GC::Variation_range>& axes, const Q& bound,
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
  const GC::Largest_kink sharp = checked(legs, axes(1, 1), 5, {1e-9, 0, GC::Work_limit()});
  BOOST_CHECK_LE(sharp.angle.upper, sharp.angle.lower * (1 + 2e-9));
  const Q low(sharp.angle.lower / degree * (1 - 1e-8)), high(sharp.angle.upper / degree * (1 + 1e-8));
  BOOST_CHECK(checked(legs, axes(1, 1), low).verdict == Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), high).verdict == Verdict::proved);
  BOOST_CHECK(checked(legs, axes(1, 1), high, {0.01, 0, GC::Work_limit(700)}).verdict ==
              Verdict::undecided); // not enough boxes
}

BOOST_AUTO_TEST_CASE(smooth_in_every_instance) {
  // both horizontal
  for (const Legs& legs : {linear({100, 0}, {30, 0}, {7, 0}, {Q(1) / 3, 0}),
                           // of one direction
                           linear({10, 20}, {-1, -2}, {5, 10}, {50, 100}),
                           // multiples of each other
                           linear({3, -4}, {Q(1) / 7, 9}, {6, -8}, {Q(2) / 7, 18})}) {
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
  const Legs circle{{{{-10, 10}, {{20, 0}, {0, 20}, {0, -20}}}, {{10, 0}, {{0, 0}, {0, 0}, {0, 0}}}},
                    {region({1, 0}), region({0, 1}), region({1, 0})}};
  kink = checked(circle, axes(2, 2), 5, {0.01, 1e-5, GC::Work_limit(200000)});
  BOOST_CHECK(kink.verdict != Verdict::proved && std::isfinite(kink.angle.upper));
}

// 45 degrees at the end; the bound itself is not exceeded there
BOOST_AUTO_TEST_CASE(exactly_the_bound) {
  const Legs legs = linear({1, 0}, {0, 0}, {1, 0}, {0, 1});
  BOOST_CHECK(checked(legs, axes(1, 1), 45).verdict != Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), Q(45) - Q(1) / 1000000000).verdict == Verdict::refuted);
  BOOST_CHECK(checked(legs, axes(1, 1), Q(45) + Q(1) / 1000000000).verdict == Verdict::proved);
}

// arctan 1/2 at 1/2, 45 degrees only beyond
BOOST_AUTO_TEST_CASE(axes_that_end_before_their_regions) {
  for (const double side : {-1., 1.}) {
    const Legs legs{{{{1, 0}, {{0, 0}}}, {{1, 0}, {{0, 1}}}}, {region({side})}};
    const std::vector<GC::Variation_range> half{{(std::min)(side / 2, 0.), (std::max)(side / 2, 0.)}};
    const GC::Largest_kink kink = checked(legs, half, 26);
    BOOST_CHECK(kink.verdict == Verdict::refuted && kink.instance[0] == Q(side / 2));
    BOOST_CHECK(26.56 * degree < kink.angle.lower && kink.angle.upper < 26.57 * degree * 1.01);
    BOOST_CHECK(checked(legs, half, 27).verdict == Verdict::proved);
  }
}

// a kink of 45 degrees from 1/2 on, up to 1/2, or there only
BOOST_AUTO_TEST_CASE(regions_that_jump) {
  for (const GC::Region_axis& axis :
       {GC::Region_axis{0.5, 0.5, 1}, {0, 0.5, 0.5}, {0.5, 0.5, 0.5}, {1, 1, 1}, {-1, -1, -1}}) {
    const Legs legs{{{{1, 0}, {{0, 0}}}, {{1, 0}, {{0, 1}}}}, {GC::Variation_region({axis})}};
    const GC::Largest_kink kink = checked(legs, axes(1), 5);
    BOOST_CHECK(kink.verdict == Verdict::refuted);
    BOOST_CHECK(kink.instance[0] == Q(axis.peak));
    BOOST_CHECK(44.9 * degree < kink.angle.lower && kink.angle.upper < 45.1 * degree);
  }
}

BOOST_AUTO_TEST_CASE(random_joins_against_samples) {
  std::cout << "seed " << seed << '\n';
  int proved = 0, refuted = 0, undecided = 0, undecided_of_few_axes = 0;
  for (int round = 0; round < 200; ++round) {
    const std::size_t dimension = static_cast<std::size_t>(round % 8 + 1), from_zero = engine() % (dimension + 1);
    Legs legs{{{{number(50, 400), number(-5, 5)}, {}}, {{number(50, 400), number(-5, 5)}, {}}}, {}};
    for (int r = number(1, 5) + static_cast<int>(dimension) / 2; r > 0; --r) {
      std::vector<GC::Region_axis> region;
      for (std::size_t k = 0; k < dimension; ++k) {
        double x[3];
        for (double& y : x) y = number(0, 8) / 8.;
        std::sort(x, x + 3);
        const bool negative = engine() % 2 == 0;
        if (number(0, static_cast<int>(dimension) + 2) >= 3)
          region.push_back({0, 0, 0});
        else if (number(0, 1) == 0)
          region.push_back(negative ? GC::Region_axis{-1, -1, 0} : GC::Region_axis{0, 1, 1});
        else if (x[0] < x[1] && x[1] < x[2]) // without jumps
          region.push_back(negative ? GC::Region_axis{-x[2], -x[1], -x[0]} : GC::Region_axis{x[0], x[1], x[2]});
        else
          region.push_back({0.125, 0.5, 1});
      }
      legs.regions.emplace_back(region);
      const auto shift = [&] { return Vector{Q(number(-40, 40)) / number(1, 3), Q(number(-9, 9)) / number(1, 3)}; };
      legs.join.incoming.shifts.push_back(shift());
      legs.join.outgoing.shifts.push_back(shift());
    }
    const std::vector<GC::Variation_range> space = axes(dimension, from_zero);
    const Q bound = Q(number(1, 80)) / 10;
    const GC::Largest_kink kink = checked(legs, space, bound);
    (kink.verdict == Verdict::proved ? proved : kink.verdict == Verdict::refuted ? refuted : undecided) += 1;
    undecided_of_few_axes += dimension <= 4 && kink.verdict == Verdict::undecided;
    for (int sample = 0; sample < 60; ++sample) {
      Instance instance;
      for (std::size_t k = 0; k < dimension; ++k) instance.push_back(Q(number(k < from_zero ? 0 : -24, 24)) / 24);
      const std::pair<Q, Q> p = products(legs, instance);
      if (p.first == 0 && p.second == 0) continue;
      BOOST_CHECK_LE(angle(p).lower, kink.angle.upper);
      if (kink.verdict == Verdict::proved) BOOST_CHECK(!degrees(bound).is_exceeded(p.first, p.second));
    }
    if (dimension < 5 && kink.verdict != Verdict::undecided && kink.angle.lower < 1.5)
      BOOST_CHECK_LE(std::tan(kink.angle.upper), 1.011 * std::tan(kink.angle.lower) + 1e-5);
  }
  std::cout << proved << " proved, " << refuted << " refuted, " << undecided << " undecided\n";
  BOOST_CHECK(proved > 50 && refuted > 50);
  BOOST_CHECK_EQUAL(undecided_of_few_axes, 0);
}

BOOST_AUTO_TEST_CASE(many_axes) {
  // a = (100, 0) and b = (100, sum y_k t_k): the largest angle is at two opposite corners, where
  // the sum of the |y_k| is attained
  for (std::size_t n : {4, 5, 9, 11}) {
    Legs legs{{{{100, 0}, {}}, {{100, 0}, {}}}, {}};
    Q sum(0);
    for (std::size_t k = 0; k < n; ++k)
      for (int side : {-1, 1}) {
        std::vector<double> peaks(n, 0.0);
        peaks[k] = side;
        legs.regions.push_back(region(peaks));
        legs.join.incoming.shifts.push_back({0, 0});
        legs.join.outgoing.shifts.push_back({0, Q(k % 2 == 0 ? side : -side) / 10});
      }
    sum = Q(static_cast<int>(n)) / 10;
    const GC::Largest_kink kink = checked(legs, axes(n), 2);
    BOOST_CHECK(kink.verdict == Verdict::proved);
    const GC::Enclosure exact = angle({Q(sum * 100), Q(10000)});
    BOOST_CHECK(kink.angle.lower == exact.lower && exact.upper <= kink.angle.upper);
    BOOST_CHECK_LE(kink.angle.upper, 1.0101 * kink.angle.lower);
    const Q degrees_of_it(exact.upper / degree);
    BOOST_CHECK(checked(legs, axes(n), degrees_of_it * Q(1001) / 1000).verdict == Verdict::proved);
    BOOST_CHECK(checked(legs, axes(n), degrees_of_it * Q(999) / 1000).verdict == Verdict::refuted);
  }
}

BOOST_AUTO_TEST_CASE(between_the_masters_of_many_axes) {
  // as in between_the_masters along the first axis, while the other ones make the legs longer and
  // shorter, or turn both
  for (std::size_t n : {4, 5, 6, 8}) {
    Legs legs = linear({100, 0}, {0, 20}, {100, 0}, {200, 60});
    std::vector<double> peaks(n, 0.0);
    peaks[0] = 1;
    legs.regions = {region(peaks)};
    for (std::size_t k = 1; k < n; ++k) {
      peaks.assign(n, 0.0);
      peaks[k] = 1;
      legs.regions.push_back(region(peaks));
      legs.join.incoming.shifts.push_back({static_cast<int>(k), 0});
      legs.join.outgoing.shifts.push_back({-static_cast<int>(k), 0});
    }
    const GC::Largest_kink kink = checked(legs, axes(n, n), 10);
    BOOST_CHECK(kink.verdict == Verdict::proved);
    BOOST_CHECK_LE(kink.angle.upper, 1.0101 * kink.angle.lower);
    // it is the largest one where the other axes are at their ends
    const int sum = static_cast<int>(n * (n - 1) / 2);
    const GC::Largest_kink end = checked(linear({100 + sum, 0}, {0, 20}, {100 - sum, 0}, {200, 60}), axes(1, 1), 10);
    BOOST_CHECK(kink.angle.lower <= end.angle.upper && end.angle.lower <= kink.angle.upper);
    // nothing is done beyond the work that is allowed, and what was reached is true
    const GC::Largest_kink few =
        checked(legs, axes(n, n), Q(kink.angle.upper / degree), {0.01, 1e-5, GC::Work_limit(1)});
    BOOST_CHECK(few.verdict == Verdict::undecided);
    BOOST_CHECK(few.angle.lower <= kink.angle.upper && kink.angle.lower <= few.angle.upper);
  }
}

// both along (3, 4), by fractions that no double has
BOOST_AUTO_TEST_CASE(parallel_in_all_of_many_axes) {
  Legs legs{{{{30, 40}, {}}, {{Q(3) / 7, Q(4) / 7}, {}}}, {}};
  for (std::size_t k = 0; k < 7; ++k) {
    std::vector<double> peaks(7, 0.0);
    peaks[k] = 1;
    peaks[(k + 3) % 7] = 0.375;
    legs.regions.push_back(region(peaks));
    legs.join.incoming.shifts.push_back({Q(1) / 3, Q(4) / 9});
    legs.join.outgoing.shifts.push_back({Q(3) / 11, Q(4) / 11});
  }
  const GC::Largest_kink kink = checked(legs, axes(7, 7), Q(1) / 1000);
  BOOST_CHECK(kink.verdict == Verdict::proved && kink.angle == (GC::Enclosure{0, 0}));
}

BOOST_AUTO_TEST_CASE(more_cells_than_can_be_looked_at) { // 2^40 of them
  Legs legs{{{{100, 0}, {}}, {{100, 0}, {}}}, {}};
  for (std::size_t k = 0; k < 40; ++k)
    for (int side : {-1, 1}) {
      std::vector<double> peaks(40, 0.0);
      peaks[k] = side;
      legs.regions.push_back(region(peaks));
      legs.join.incoming.shifts.push_back({0, 0});
      legs.join.outgoing.shifts.push_back({side, 2});
    }
  const GC::Largest_kink kink = checked(legs, axes(40), 89);
  BOOST_CHECK(kink.verdict == Verdict::undecided);
  BOOST_CHECK(kink.angle.lower > 30 * degree && kink.angle.upper > 180 * degree);
  BOOST_CHECK(checked(legs, axes(40), 30).verdict == Verdict::refuted);
}

// Nine axes along which the legs turn so far that they may be at right angles, or may not have a
// length.
BOOST_AUTO_TEST_CASE(large_turns_over_many_axes) {
  const std::size_t n = 9;
  Legs legs{{{{100, 0}, {}}, {{100, 0}, {}}}, {}};
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> peaks(n, 0.0);
    peaks[k] = 1;
    legs.regions.push_back(region(peaks));
    legs.join.incoming.shifts.push_back({0, 0});
    legs.join.outgoing.shifts.push_back({-30, k % 2 == 0 ? 20 : -5});
  }
  const GC::Largest_kink kink = checked(legs, axes(n, n), 30);
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  BOOST_CHECK_GE(kink.angle.lower, 89 * degree);
  const GC::Largest_kink bounded = checked(legs, axes(n, n), 89, {0.01, 1, GC::Work_limit(100000)});
  BOOST_CHECK(bounded.verdict != Verdict::proved);
  // both legs become short, so that the bounds do not tell that their product stays positive
  for (std::size_t k = 0; k < n; ++k) {
    legs.join.incoming.shifts[k] = {-11, 0};
    legs.join.outgoing.shifts[k] = {-11, k % 2 == 0 ? Q(1) / 10 : Q(-1) / 20};
  }
  const GC::Largest_kink loose = checked(legs, axes(n, n), 5, {0.01, 0, GC::Work_limit(3000000)});
  BOOST_CHECK_GE(loose.angle.lower, 10 * degree);
  // parallel, and turned back at the end
  for (std::size_t k = 0; k < n; ++k) {
    legs.join.incoming.shifts[k] = {0, 0};
    legs.join.outgoing.shifts[k] = {-30, 0};
  }
  BOOST_CHECK_GT(checked(legs, axes(n, n), 30).angle.lower, 179 * degree);
  // a floor: angles below it are not told apart
  const Legs small = linear({1000000, 0}, {0, 1}, {1000000, 0}, {0, 0});
  BOOST_CHECK(checked(small, axes(1, 1), 5, {0, 1e-3, GC::Work_limit()}).verdict == Verdict::proved);
}

// Regions of one place, within an axis and beyond its ends, and legs that are zero at the only
// corners.
BOOST_AUTO_TEST_CASE(regions_of_one_place) {
  for (const double place : {-3., 3., 0.5}) {
    const Legs legs{{{{1, 0}, {{0, 0}}}, {{1, 0}, {{0, 1}}}}, {GC::Variation_region({{place, place, place}})}};
    const GC::Largest_kink kink = checked(legs, axes(1), 5);
    BOOST_CHECK((kink.verdict == Verdict::refuted) == (place == 0.5));
  }
  const Legs zero = linear({0, 0}, {0, 0}, {1, 0}, {1, 0});
  const GC::Largest_kink none = GC::largest_kink(zero.join, zero.regions, axes(1, 1), degrees(5));
  BOOST_CHECK(none.verdict == Verdict::undecided && none.vanishes);
}

// A constant kink whose tangent, 1/3, no double has: its bounds at the only place differ, and the
// search ends.
BOOST_AUTO_TEST_CASE(one_place_without_a_tolerance) {
  const Legs legs = linear({3, 0}, {0, 0}, {3, 1}, {0, 0});
  const GC::Enclosure exact = angle({Q(3), Q(9)});
  for (const Q& bound : {Q(18), Q(19)}) {
    const GC::Largest_kink kink = checked(legs, axes(1, 1), bound, {0, 0, GC::Work_limit()});
    BOOST_CHECK(kink.verdict == (bound == 18 ? Verdict::refuted : Verdict::proved));
    BOOST_CHECK(kink.angle.lower == exact.lower && exact.upper <= kink.angle.upper);
    BOOST_CHECK_LE(kink.angle.upper, exact.upper * (1 + 1e-15));
  }
}

BOOST_AUTO_TEST_CASE(axes_that_do_not_count) {
  const Legs legs = linear({1, 0}, {0, 0}, {1, 0}, {0, 1});
  CHECK_ERROR(GC::largest_kink(legs.join, legs.regions, axes(1), degrees(90)), parameter_outside_domain);
  // only those count on which the join depends, and which vary: the others stay at the default
  Legs four{legs.join, {region({1, 0, 1, 0})}};
  GC::Largest_kink kink = checked(four, axes(4), 44);
  BOOST_CHECK(kink.verdict == Verdict::refuted);
  BOOST_CHECK(kink.instance == Instance({1, 0, 1, 0}));
  std::vector<GC::Variation_range> three = axes(4);
  three[2] = {0, 0};
  kink = checked(four, three, 1);
  BOOST_CHECK(kink.verdict == Verdict::proved && kink.angle == (GC::Enclosure{0, 0}));
}
