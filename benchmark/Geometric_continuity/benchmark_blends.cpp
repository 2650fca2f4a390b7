// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Quintic blends in double, one at a time and in batches, against instructions written by hand, and
// against what SISL (G1 only) and OpenCASCADE (in the plane, by iteration) offer for the purpose.
// Results are compared before anything is timed.

#include "Ratio_table.h"
#include "by_hand.h"
#include "measure.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Simple_cartesian.h>

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
#include <FairCurve_AnalysisCode.hxx>
#include <FairCurve_MinimalVariation.hxx>
#include <gp_Pnt2d.hxx>
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
#include <sisl.h>
#endif

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

#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
// Angles and curvatures at the ends are given; true when it has converged.
bool occt_blend() {
  FairCurve_MinimalVariation curve(gp_Pnt2d(0, 0), gp_Pnt2d(4, 0), 1);
  curve.SetConstraintOrder1(2);
  curve.SetConstraintOrder2(2);
  curve.SetAngle1(0.3);
  curve.SetAngle2(0.3);
  curve.SetCurvature1(0.2);
  curve.SetCurvature2(0.1);
  FairCurve_AnalysisCode code;
  return curve.Compute(code) && code == FairCurve_OK;
}
#endif

#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
// Between the end of one cubic and the start of another.
bool sisl_blend() {
  static double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, left[] = {-3, 0, 0, -2, 1, 0, -1, 1, 1, 0, 0, 0},
                right[] = {4, 0, 0, 5, 1, 0, 6, 1, 1, 7, 0, 0};
  static SISLCurve *const phi = newCurve(4, 4, knots, left, 1, 3, 1), *const psi =
                                                                          newCurve(4, 4, knots, right, 1, 3, 1);
  SISLCurve* gamma = nullptr;
  int status = -1;
  s1607(phi, psi, 1e-6, 0, 1, 1, 0, 2, 3, 6, &gamma, &status);
  const bool joined = status >= 0 && gamma && near(gamma->ecoef[0], 0) && near(gamma->ecoef[3 * gamma->in - 3], 4);
  if (gamma) freeCurve(gamma);
  return joined;
}
#endif

} // namespace

int main(int argc, char** argv) {
  std::mt19937 random(2026);
  static const Ends left(random), right(random);
  static GC::Blend_arrays<double, 3> gamma, energy;
  GC::blend(left.arrays, right.arrays, GC::Minimal_second_derivative(), {1, 1}, gamma);
  GC::blend(left.arrays, right.arrays, GC::Minimal_energy<3>(), {1, 1}, energy);
  for (std::size_t l = 0; l < n; ++l) {
    const by_hand::Checked_blend hand = by_hand::checked_blend(left.hand[l], right.hand[l]);
    const GC::Quintic_blend<Traits> single = GC::blend(left.single[l], right.single[l], GC::Minimal_second_derivative(),
                                                       {1, 1}),
                                    least = GC::blend(left.single[l], right.single[l], GC::Minimal_energy<3>(), {1, 1});
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
    const GC::Quintic_blend<Traits> blend =
        GC::blend(left.single[l], right.single[l], GC::Minimal_second_derivative(), {1, 1});
    benchmark::DoNotOptimize(blend);
  });
  at_once("quintic blends, min_second | blend(), batch", n, [] {
    GC::blend(left.arrays, right.arrays, GC::Minimal_second_derivative(), {1, 1}, gamma);
  });
#ifdef GEOMETRIC_CONTINUITY_WITH_SISL
  check(sisl_blend(), "SISL, blend");
  at_once("quintic blends, min_second | SISL, s1607, G1 only", 1, [] { sisl_blend(); });
#endif
#ifdef GEOMETRIC_CONTINUITY_WITH_OCCT
  check(occt_blend(), "OpenCASCADE, blend");
  at_once("quintic blends, min_second | OpenCASCADE, FairCurve, in the plane", 1, [] { occt_blend(); });
#endif
  one_by_one("quintic blends, energy3 | blend()", [](std::size_t l) {
    const GC::Quintic_blend<Traits> blend = GC::blend(left.single[l], right.single[l], GC::Minimal_energy<3>(), {1, 1});
    benchmark::DoNotOptimize(blend);
  });
  at_once("quintic blends, energy3 | blend(), batch", n, [] {
    GC::blend(left.arrays, right.arrays, GC::Minimal_energy<3>(), {1, 1}, energy);
  });
  one_by_one("quintic blends, energy3 | blend(), automatic shape", [](std::size_t l) {
    const GC::Quintic_blend<Traits> blend = GC::blend(left.single[l], right.single[l]);
    benchmark::DoNotOptimize(blend);
  });
  one_by_one("quintic blends, fair | blend()", [](std::size_t l) {
    const GC::Quintic_blend<Traits> blend = GC::blend(left.single[l], right.single[l], GC::Fair());
    benchmark::DoNotOptimize(blend);
  });
  return run_benchmarks(argc, argv);
}
