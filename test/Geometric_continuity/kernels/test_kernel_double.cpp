// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Simple_cartesian_double

#include "support/test.h"

#include <CGAL/Geometric_continuity.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Cartesian_d<double>> Traits_n;
constexpr bool exact = false, exact_predicates = false;
constexpr bool cancels = true;
constexpr int rounds = 20;

template <class Test> void in_every_space(Test test) {
  test(Traits2(), 2);
  test(Traits3(), 3);
  test(Traits_n(), 4);
  test(Traits_n(), 5);
}

#include "algebra/typed_Bernstein_polynomial.h"
#include "algebra/typed_Plane_coordinates.h"
#include "blends/typed_quintic_blend.h"
#include "blends/typed_septic_blend.h"
#include "curves/typed_Bezier_curve.h"
#include "curves/typed_Cubic_blended_curve.h"
#include "curves/typed_is_planar.h"
#include "extensions/typed_alternatives.h"
#include "joins/typed_join_continuity.h"
#include "local/typed_Curve_jet.h"
#include "support/allocations.h"

// ---------------------------------------------------------------- memory

// A curve of fixed degree does not ask the heap for memory; one of dynamic degree does.
template <class Traits, class C> std::size_t count_allocations(const C& c) {
  const std::size_t before = allocations;
  const C copy(c.begin(), c.end(), 0., 2.);
  double sum = column<Traits>(copy(0.5))[0];
  for (int k = 0; k <= 5; ++k) sum += copy.jet(0.5, k)[0][0] + copy.start_jet(k)[k][0] + copy.end_jet(k)[k][1];
  sum += copy.derivative().coordinates(0)[0] + copy.split(1.).second.coordinates(0)[0];
  sum += copy.reverse().with_domain(1., 2.).coordinates(0)[0];
  sum += copy.transform([](const Point<Traits>& p) { return p; }).coordinates(0)[0];
  sum += column<Traits>(copy.bounding_box().first)[0] + copy.bbox().xmax() + (copy == c);
  if constexpr (!std::is_same_v<C, Curve<Traits>>) sum += copy.template elevate_fixed<2>().coordinates(0)[0];
  BOOST_TEST_REQUIRE(std::isfinite(sum));
  return allocations - before;
}

BOOST_AUTO_TEST_CASE(no_memory_from_the_heap) {
  const Curve<Traits2> flat = curve<Traits2>(2, {{0, 1}, {2, 3}, {5, 4}, {6, 0}, {7, 1}, {8, 8}});
  const Curve<Traits3> c = curve<Traits3>(3, {{0, 1, 1}, {2, 3, 0}, {5, 4, 1}, {6, 0, 2}, {7, 1, 0}, {8, 8, 0}});
  BOOST_CHECK_EQUAL((count_allocations<Traits2>(GC::Bezier_curve<Traits2, 5>(flat))), 0u);
  BOOST_CHECK_EQUAL((count_allocations<Traits3>(GC::Bezier_curve<Traits3, 5>(c))), 0u);
  BOOST_CHECK_GT((count_allocations<Traits3>(c)), 0u);
}
