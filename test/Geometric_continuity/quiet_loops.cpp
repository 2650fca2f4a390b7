// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// An optimising compiler does not warn of loops that it cannot vectorise, with no option asked.

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Simple_cartesian.h>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Simple_cartesian<double> Kernel;

GC::Curve_jet<GC::Traits_2<Kernel>> jet(const GC::Bezier_curve<GC::Traits_2<Kernel>>& curve) {
  return curve.jet(0.5, 2);
}
GC::Curve_jet<GC::Traits_3<Kernel>> jet(const GC::Bezier_curve<GC::Traits_3<Kernel>, 3>& curve) {
  return curve.jet(0.5, 3);
}
std::size_t torsion(const GC::Jet_arrays<double, 3, 3>& jets, double* curvature, double* torsion) {
  return GC::curvature_and_torsion(jets, curvature, torsion);
}
