// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>
#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>

// Sides of edges of CAD models.

typedef GC::Cad_elementary_surface Elementary;
typedef Elementary::Kind Kind;
typedef GC::Cad_point<3> P3;
typedef GC::Cad_point<2> P2;

const double pi = 3.141592653589793;
const GC::Cad_placement unmoved{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
    mirrored{{{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
const GC::Cad_frame standard{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

template <class Surface, class Curve>
GC::Edge_side side(const Surface& surface, const Curve& curve, bool reversed = false,
                   const GC::Cad_placement& placement = unmoved) {
  return {std::make_shared<GC::Cad_surface>(surface), std::make_shared<GC::Cad_curve<2>>(curve), placement, reversed};
}
template <class Surface, class Curve>
GC::Edge_side side(const Surface& surface, const Curve& curve, const GC::Cad_placement& placement) {
  return side(surface, curve, false, placement);
}
inline GC::Cad_line<2> line(double u, double v, double du, double dv) { return {{u, v}, {du, dv}}; }
inline Elementary plane(const GC::Cad_frame& frame = standard) { return {Kind::plane, frame}; }

// Knots on [0, 1].
inline std::vector<double> clamped(int degree, const std::vector<double>& inner = {}) {
  std::vector<double> k(degree + 1, 0.);
  k.insert(k.end(), inner.begin(), inner.end());
  k.insert(k.end(), degree + 1, 1.);
  return k;
}
