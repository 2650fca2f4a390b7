// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Simple_cartesian_Exact_rational

#include "support/test.h"

#include <CGAL/Geometric_continuity.h>

typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Cartesian_d<CGAL::Exact_rational>> Traits_n;
constexpr bool exact = true, exact_predicates = true;
constexpr bool cancels = true;
constexpr int rounds = 6;

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
