// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE Exact_predicates_exact_constructions_kernel

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Geometric_continuity.h>

typedef CGAL::Exact_predicates_exact_constructions_kernel Kernel;
typedef CGAL::Geometric_continuity::Traits_2<Kernel> Traits2;
typedef CGAL::Geometric_continuity::Traits_3<Kernel> Traits3;
constexpr bool exact = true;
constexpr bool cancels = true;
constexpr int rounds = 4;

template <class Test> void in_every_space(Test test) {
  test(Traits2(), 2);
  test(Traits3(), 3);
}

#include "kernels/typed_smoke.h"
