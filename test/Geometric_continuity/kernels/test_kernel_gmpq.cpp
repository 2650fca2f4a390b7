// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Cartesian_Gmpq

#include <CGAL/Cartesian.h>
#include <CGAL/Cartesian_d.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Gmpq.h>

typedef CGAL::Cartesian<CGAL::Gmpq> Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Cartesian_d<CGAL::Gmpq>> Traits_n;
constexpr bool exact = true;
constexpr bool cancels = true;
constexpr int rounds = 6;

template <class Test> void in_every_space(Test test) {
  test(Traits2(), 2);
  test(Traits3(), 3);
  test(Traits_n(), 4);
  test(Traits_n(), 5);
}

#include "kernels/typed_smoke.h"
