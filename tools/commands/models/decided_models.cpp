// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/models/exact_models.h"

template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Exact_surface&, GC::Patch_edge,
                                                               const Exact_surface&, GC::Patch_edge);
template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Exact_rational_surface&, GC::Patch_edge,
                                                               const Exact_rational_surface&, GC::Patch_edge);
template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Double_surface&, GC::Patch_edge,
                                                               const Double_surface&, GC::Patch_edge);
template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const GC::Spline_edge_rows<Exact, 3>&,
                                                               const GC::Spline_edge_rows<Exact, 3>&);
template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const GC::Spline_edge_rows<Exact, 4>&,
                                                               const GC::Spline_edge_rows<Exact, 4>&);
template bool GC::is_g3_edge(const Exact_surface&, GC::Patch_edge, const Exact_surface&, GC::Patch_edge);
template bool GC::is_g3_edge(const Exact_rational_surface&, GC::Patch_edge, const Exact_rational_surface&,
                             GC::Patch_edge);
template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_surface>& surfaces);
template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_rational_surface>& surfaces);
template GC::Surface_jet<Double_space> GC::Bspline_surface<Double_space>::jet(const double&, const double&, int) const;
template GC::Surface_jet<Double_space> GC::Bezier_patch<Double_space>::jet(const double&, const double&, int) const;
