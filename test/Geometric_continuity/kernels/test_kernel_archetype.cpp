// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Archetype

#include "support/archetype.h"

#include <CGAL/Dimension.h>

typedef archetype::Traits<CGAL::Dimension_tag<2>> Traits2;
typedef archetype::Traits<CGAL::Dimension_tag<3>> Traits3;
typedef archetype::Traits<CGAL::Dynamic_dimension_tag> Traits_n;
constexpr bool exact = true, exact_predicates = true;
constexpr bool cancels = true;
constexpr int rounds = 3;

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
