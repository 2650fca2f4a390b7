// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Simple_cartesian_cpp_rational

#include "support/test.h"

#include <CGAL/Geometric_continuity.h>
#include <CGAL/boost_mp.h>

typedef CGAL::Simple_cartesian<boost::multiprecision::cpp_rational> Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Cartesian_d<boost::multiprecision::cpp_rational>> Traits_n;
constexpr bool exact = true;
constexpr bool cancels = true;
constexpr int rounds = 1; // by far the slowest of the number types

template <class Test> void in_every_space(Test test) {
  test(Traits2(), 2);
  test(Traits3(), 3);
  test(Traits_n(), 4);
  test(Traits_n(), 5);
}

#include "kernels/typed_smoke.h"
