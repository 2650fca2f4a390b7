// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/exact_models.h"

GC::Spline_edge_continuity<Exact> decided_edge(const Exact_surface& a, GC::Patch_edge edge_a, const Exact_surface& b,
                                               GC::Patch_edge edge_b) {
  return GC::edge_continuity(a, edge_a, b, edge_b);
}
GC::Spline_edge_continuity<Exact> decided_edge(const Exact_rational_surface& a, GC::Patch_edge edge_a,
                                               const Exact_rational_surface& b, GC::Patch_edge edge_b) {
  return GC::edge_continuity(a, edge_a, b, edge_b);
}
bool has_g3_edge(const Exact_surface& a, GC::Patch_edge edge_a, const Exact_surface& b, GC::Patch_edge edge_b) {
  return GC::is_g3_edge(a, edge_a, b, edge_b);
}
bool has_g3_edge(const Exact_rational_surface& a, GC::Patch_edge edge_a, const Exact_rational_surface& b,
                 GC::Patch_edge edge_b) {
  return GC::is_g3_edge(a, edge_a, b, edge_b);
}

template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_surface>& surfaces);
template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_rational_surface>& surfaces);
