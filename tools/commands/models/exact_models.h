// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_EXACT_MODELS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_EXACT_MODELS_H

#include "formats/g2_text/curves.h"
#include "formats/g2_text/surfaces.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/svg_surfaces.h>

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

// Decisions on models over fractions and on doubles, and pictures, which several commands ask for:
// each is compiled once.

typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Exact_space;
typedef GC::Bspline_surface<Exact_space> Exact_surface;
typedef GC::Rational_bspline_surface<Exact_space> Exact_rational_surface;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_space;
typedef GC::Bspline_surface<Double_space> Double_surface;

Surface_model<Exact_space> read_exact_model(const std::vector<std::string>& files);

void draw_surfaces(std::ostream& os, const std::vector<Exact_surface>& surfaces, const GC::Svg_surface_style& style);
void draw_surfaces(std::ostream& os, const std::vector<Exact_rational_surface>& surfaces,
                   const GC::Svg_surface_style& style);

// These are asked by the commands and by functions of the package.
extern template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Exact_surface&, GC::Patch_edge,
                                                                      const Exact_surface&, GC::Patch_edge);
extern template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Exact_rational_surface&, GC::Patch_edge,
                                                                      const Exact_rational_surface&, GC::Patch_edge);
extern template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const Double_surface&, GC::Patch_edge,
                                                                      const Double_surface&, GC::Patch_edge);
extern template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const GC::Spline_edge_rows<Exact, 3>&,
                                                                      const GC::Spline_edge_rows<Exact, 3>&);
extern template GC::Spline_edge_continuity<Exact> GC::edge_continuity(const GC::Spline_edge_rows<Exact, 4>&,
                                                                      const GC::Spline_edge_rows<Exact, 4>&);
extern template bool GC::is_g3_edge(const Exact_surface&, GC::Patch_edge, const Exact_surface&, GC::Patch_edge);
extern template bool GC::is_g3_edge(const Exact_rational_surface&, GC::Patch_edge, const Exact_rational_surface&,
                                    GC::Patch_edge);
extern template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_surface>& surfaces);
extern template GC::Model_continuity<Exact>
GC::model_continuity<CGAL::Sequential_tag>(const std::vector<Exact_rational_surface>& surfaces);
extern template std::optional<GC::Parameter_rectangle<Exact>> GC::possible_fold(const Exact_surface& surface);
extern template std::optional<GC::Parameter_rectangle<Exact>> GC::possible_fold(const Exact_rational_surface& surface);
// Pictures spend two fifths of their time here where these are not optimised.
extern template GC::Surface_jet<Double_space> GC::Bspline_surface<Double_space>::jet(const double&, const double&,
                                                                                     int) const;
extern template GC::Surface_jet<Double_space> GC::Bezier_patch<Double_space>::jet(const double&, const double&,
                                                                                  int) const;

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_EXACT_MODELS_H
