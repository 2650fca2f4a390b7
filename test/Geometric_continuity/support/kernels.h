// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TEST_SUPPORT_KERNELS_H
#define CGAL_GEOMETRIC_CONTINUITY_TEST_SUPPORT_KERNELS_H

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>

// The kernels for which tests of curves are compiled.

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;
typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
typedef GC::Traits_d<CGAL::Cartesian_d<double>> Double_d;
typedef GC::Traits_3<Epick> Epick_3;

#endif // CGAL_GEOMETRIC_CONTINUITY_TEST_SUPPORT_KERNELS_H
