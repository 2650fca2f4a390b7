// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Types and arguments that are refused by one message of the compiler. Each macro is a program that
// must not compile; a test builds it.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Simple_cartesian.h>

namespace GC = CGAL::Geometric_continuity;

#if defined(KERNEL_AS_TRAITS)
typedef CGAL::Simple_cartesian<double> Kernel;
GC::Bezier_curve<Kernel> curve{Kernel::Point_3(), Kernel::Point_3(1, 0, 0)};
auto point() { return curve(0.5); }
#elif defined(INTEGERS)
GC::Bezier_curve<GC::Traits_3<CGAL::Simple_cartesian<int>>> curve{CGAL::Simple_cartesian<int>::Point_3(0, 0, 0)};
#elif defined(KNOTS_WITHOUT_DEGREE)
GC::Knot_vector<double> knots({0, 0, 0, 1, 1, 1});
#elif defined(KNOTS_BEFORE_DEGREE)
GC::Knot_vector<double> knots({0, 0, 0, 1, 1, 1}, 2);
#elif defined(TRAITS_AS_NUMBERS)
GC::Knot_vector<GC::Traits_2<CGAL::Simple_cartesian<double>>> knots(2, {0, 0, 0, 1, 1, 1});
#elif defined(DEGREES)
typedef CGAL::Simple_cartesian<double>::Point_2 Point;
auto arc = GC::circular_arc(Point(0, 0), Point(1, 0), 90);
#elif defined(DEGREES_IN_SPACE)
typedef CGAL::Simple_cartesian<double> Kernel;
auto arc = GC::circular_arc<GC::Traits_3<Kernel>>(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0),
                                                  Kernel::Vector_3(0, 0, 1), 90);
#elif defined(SPLINE_ORDER)
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Traits;
typedef Traits::Point Point;
const std::vector<double> knots{0, 0, 1, 1}, weights{1, 2};
const std::vector<Point> points{Point(0, 0), Point(1, 1)};
GC::SPLINE_ORDER;
#elif defined(SURFACE)
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
const Traits::Point p(0, 0, 0);
const std::vector<Traits::Point> points(4, p);
const std::vector<double> knots{0, 0, 1, 1};
const std::vector<std::vector<Traits::Point>> net;
GC::SURFACE;
#elif defined(NUMBER_AS_STRATEGY)
typedef GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<double>>> Curve;
void round(const Curve& a, const Curve& b) { GC::blend(a, b, 3); }
#elif defined(RADIUS_AND_ANGLES)
auto arc = GC::circular_arc(CGAL::Simple_cartesian<double>::Point_2(0, 0), 1.0, 0.0, 1.5);
#else // ROOTS_OF_RATIONALS
typedef GC::Traits_3<CGAL::Simple_cartesian<CGAL::Exact_rational>> Traits;
auto unit(const GC::Frenet_frame<Traits>& frame) { return frame.normalized(); }
#endif
