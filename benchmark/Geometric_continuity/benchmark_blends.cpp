// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Quintic blends in double, one at a time and in batches, against instructions written by hand. Results are compared before
// anything is timed.

#include "Ratio_table.h"
#include "by_hand.h"
#include "measure.h"

#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/construction/blend.h>
#include <CGAL/Geometric_continuity/construction/blend_batch.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <random>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Curve_jet<Traits> Jet;

namespace {

// The ends of random curves, in all the forms.
struct Ends {
  std::vector<Jet> single;
  std::vector<by_hand::Jet> hand;
  GC::Jet_arrays<double, 3, 2> arrays;

  explicit Ends(std::mt19937& random) : arrays(n) {
    std::uniform_real_distribution<double> number(-1, 1);
    for (std::size_t l = 0; l < n; ++l) {
      Jet jet(3, 2);
      by_hand::Jet h{};
      h.order = 2;
      for (int j = 0; j <= 2; ++j)
        for (int i = 0; i < 3; ++i) jet[j][i] = h.d[j][i] = number(random);
      single.push_back(jet);
      hand.push_back(h);
      arrays.set(l, jet);
    }
  }
};

} // namespace

int main(int argc, char** argv) {
  std::mt19937 random(2026);
  static const Ends left(random), right(random);
  static GC::Blend_arrays<double, 3> gamma, energy;
  GC::blend(left.arrays, right.arrays, GC::Minimal_second_derivative(), gamma);
  GC::blend(left.arrays, right.arrays, GC::Minimal_energy<3>(), energy);
  for (std::size_t l = 0; l < n; ++l) {
    const by_hand::Checked_blend hand = by_hand::checked_blend(left.hand[l], right.hand[l]);
    const GC::Quintic_blend<Traits> single =
                                        GC::blend(left.single[l], right.single[l], GC::Minimal_second_derivative()),
                                    least = GC::blend(left.single[l], right.single[l]);
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 3; ++i) {
        check(near(hand.curve.points[j][i], single.control_point(j)[i]), "blend");
        check(near(hand.curve.points[j][i], gamma.array(j, i)[l]), "batch of blends");
        check(near(least.control_point(j)[i], energy.array(j, i)[l]), "batch of blends of least energy");
      }
  }

  one_by_one("quintic blends, min_second | by hand, without checks", [](std::size_t l) {
    const by_hand::Blend blend = by_hand::blend(left.hand[l], right.hand[l]);
    benchmark::DoNotOptimize(blend);
  });
  one_by_one("quintic blends, min_second | by hand, with checks", [](std::size_t l) {
    const by_hand::Checked_blend blend = by_hand::checked_blend(left.hand[l], right.hand[l]);
    benchmark::DoNotOptimize(blend);
  });
  one_by_one("quintic blends, min_second | blend()", [](std::size_t l) {
    const GC::Quintic_blend<Traits> blend = GC::blend(left.single[l], right.single[l], GC::Minimal_second_derivative());
    benchmark::DoNotOptimize(blend);
  });
  at_once("quintic blends, min_second | blend(), batch", n,
          [] { GC::blend(left.arrays, right.arrays, GC::Minimal_second_derivative(), gamma); });
  one_by_one("quintic blends, energy3 | blend()", [](std::size_t l) {
    const GC::Quintic_blend<Traits> blend = GC::blend(left.single[l], right.single[l]);
    benchmark::DoNotOptimize(blend);
  });
  at_once("quintic blends, energy3 | blend(), batch", n,
          [] { GC::blend(left.arrays, right.arrays, GC::Minimal_energy<3>(), energy); });
  return run_benchmarks(argc, argv);
}
