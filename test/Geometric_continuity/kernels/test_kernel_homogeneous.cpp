// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Homogeneous_Gmpz

#include <CGAL/Cartesian_d.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Homogeneous.h>

typedef CGAL::Homogeneous<CGAL::Gmpz> Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
typedef CGAL::Geometric_continuity::Traits_d<CGAL::Cartesian_d<Kernel::FT>> Traits_n;
constexpr bool exact = true;
constexpr bool cancels = false;
constexpr int rounds = 1;

template <class Test> void in_every_space(Test test) {
  test(Traits2(), 2);
  test(Traits3(), 3);
  test(Traits_n(), 4);
}

#include "kernels/typed_smoke.h"
