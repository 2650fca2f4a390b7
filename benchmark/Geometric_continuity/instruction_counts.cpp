// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Each operation a thousand times, in a function of its own: callgrind counts its instructions, see
// instruction_counts.cmake.

#include "by_hand.h"
#include "surface_blends_by_hand.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Bezier_curve<Traits, 5> Quintic;
typedef GC::Curve_jet<Traits> Jet;

BOOST_NOINLINE by_hand::Jet jet_by_hand(const by_hand::Quintic& c, double u) { return by_hand::jet(c, u); }
BOOST_NOINLINE Jet jet_generic(const Quintic& c, double u) { return c.jet<3>(u); }

BOOST_NOINLINE by_hand::Jet prepared_jet_by_hand(const by_hand::Powers& c, double u) { return c(u); }
BOOST_NOINLINE GC::Coordinate_jet<double, 3> prepared_jet_generic(const GC::Jet_polynomials<double, 3, 5, 3>& c,
                                                                  double u) {
  return c.jet(u);
}

BOOST_NOINLINE by_hand::Checked_blend blend_by_hand(const by_hand::Jet& x, const by_hand::Jet& y) {
  return by_hand::checked_blend(x, y);
}
BOOST_NOINLINE by_hand::Blend blend_by_hand_unchecked(const by_hand::Jet& x, const by_hand::Jet& y) {
  return by_hand::blend(x, y);
}
BOOST_NOINLINE GC::Quintic_blend<Traits> blend_generic(const Jet& x, const Jet& y) {
  return GC::blend(x, y, GC::Minimal_second_derivative(), {1, 1});
}

BOOST_NOINLINE void surface_blend_by_hand(by_hand::Surface_blend& x) { x(); }
BOOST_NOINLINE auto surface_blend_generic(const by_hand::Surface_blend_input<double>& x) { return x(); }
#ifdef CGAL_USE_GMPXX
BOOST_NOINLINE void exact_surface_blend_by_hand(by_hand::Exact_surface_blend& x) { x(); }
BOOST_NOINLINE auto exact_surface_blend_generic(const by_hand::Surface_blend_input<CGAL::Exact_rational>& x) {
  return x();
}
#endif

// The points of both are compared by f.
template <class Surface, class By_hand, class Function>
void for_each_number(const Surface& s, const By_hand& hand, const Function& f) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 6; ++j)
      for (int k = 0; k < 3; ++k) f(s.control_point(i, j)[k], hand.b[i][j][k]);
}

int main() {
  std::array<Traits::Point, 6> p;
  for (int j = 0; j < 6; ++j) p[j] = Traits::Point(j, (5 * j) % 7, (3 * j) % 5);
  const Quintic curve(p.begin(), p.end());
  const by_hand::Quintic hand_curve(p, 0, 1);
  const GC::Jet_polynomials<double, 3, 5, 3> polynomials(curve);
  const by_hand::Powers powers(hand_curve);
  double error = 0; // the results are used, and they are the same
  const auto compare = [&error](double x, double y) { error = std::fmax(error, std::abs(x - y) / (1 + std::abs(x))); };
  const by_hand::Surface_blend_input<double> patches;
  by_hand::Surface_blend hand_patches(patches);
#ifdef CGAL_USE_GMPXX
  const by_hand::Surface_blend_input<CGAL::Exact_rational> exact_patches;
  by_hand::Exact_surface_blend exact_hand_patches{exact_patches, {}, {}, {}, {}, {}};
#endif
  for (int l = 0; l < 1000; ++l) {
    const auto surface = surface_blend_generic(patches);
    surface_blend_by_hand(hand_patches);
    for_each_number(surface, hand_patches, compare);
#ifdef CGAL_USE_GMPXX
    const auto exact_surface = exact_surface_blend_generic(exact_patches);
    exact_surface_blend_by_hand(exact_hand_patches);
    for_each_number(exact_surface, exact_hand_patches, [&](const auto& x, const auto& y) { compare(x == y, 1); });
#endif
    const double u = l / 1000.0;
    const Jet x = jet_generic(curve, u), y = curve.jet(1 - u, 3);
    const by_hand::Jet hand_x = jet_by_hand(hand_curve, u), hand_y = by_hand::jet(hand_curve, 1 - u);
    const by_hand::Jet hand_prepared = prepared_jet_by_hand(powers, u);
    const GC::Coordinate_jet<double, 3> prepared = prepared_jet_generic(polynomials, u);
    const GC::Quintic_blend<Traits> blend = blend_generic(x, y);
    const by_hand::Checked_blend hand_blend = blend_by_hand(hand_x, hand_y);
    const by_hand::Blend unchecked = blend_by_hand_unchecked(hand_x, hand_y);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) {
        compare(x[j][i], hand_x.d[j][i]);
        compare(x[j][i], hand_prepared.d[j][i]);
        compare(x[j][i], prepared[j][i]);
      }
      for (int j = 0; j < 6; ++j) {
        compare(blend.control_point(j)[i], hand_blend.curve.points[j][i]);
        compare(blend.control_point(j)[i], unchecked.points[j][i]);
      }
    }
  }
  if (error < 1e-12) return EXIT_SUCCESS;
  std::cerr << "the results differ by " << error << '\n';
  return EXIT_FAILURE;
}
