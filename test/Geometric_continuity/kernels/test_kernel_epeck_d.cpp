// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Epeck_d

#include <CGAL/Epeck_d.h>
#include <CGAL/Geometric_continuity.h>

// Every test runs on the one traits class, with dimensions known at run time only.
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>> Traits_n;
typedef Traits_n Traits2, Traits3;
constexpr bool exact = true;
constexpr bool cancels = true;
constexpr int rounds = 3;

template <class Test> void in_every_space(Test test) {
  test(Traits_n(), 2);
  test(Traits_n(), 3);
  test(Traits_n(), 4);
  test(Traits_n(), 5);
}

#include "kernels/typed_smoke.h"
