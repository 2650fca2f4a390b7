// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_SURFACES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_SURFACES_H

#include "commands/models/exact_models.h"
#include "commands/models/model_json.h"

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <variant>
#include <vector>

// The surfaces of a model, which are read once and about which everything is decided exactly: on a
// grid of doubles where they are polynomial and their numbers allow it, else over fractions. What
// the commands ask is compiled here once for each of the three types of surface.
class Model_surfaces {
  std::variant<std::vector<Double_surface>, std::vector<Exact_surface>, std::vector<Exact_rational_surface>> surfaces_;
  std::vector<Surface_place> places_;
  Exact parameter_unit_ = Exact(1);

public:
  // Which coordinates are wanted: those of the files, or any multiple of them, which is faster and
  // changes neither orders nor angles.
  enum class Units { of_the_files, any };

  Model_surfaces(const std::vector<std::string>& files, Units units);

  std::size_t size() const;
  // Where they stand.
  const std::vector<Surface_place>& places() const { return places_; }
  // The parameters of the files are those of the surfaces times this.
  const Exact& parameter_unit() const { return parameter_unit_; }

  // Shows the progress.
  GC::Model_continuity<Exact> continuity(GC::Crease_angles angles) const;

  // These three are asked in the units of the files only.
  Within order_within(const Line& line, const GC::Edge_tolerance& tolerance) const;
  std::vector<GC::Nearly_coincident_edges> nearly_coincident_edges(const GC::Model_continuity<Exact>& model,
                                                                   const GC::Edge_tolerance& tolerance) const;
  void write_certificate(std::ostream& os, const std::vector<std::string>& files,
                         const GC::Model_continuity<Exact>& model) const;

  // The control points of a surface, from the first one.
  std::vector<std::array<double, 3>> net(std::size_t surface) const;

  // For a drawing: (m + 1)(n + 1) points at equal distances of both parameters, row by row; and at
  // most 401 points of an edge and of a knot line. Three numbers a point.
  std::array<std::size_t, 2> spans(std::size_t surface) const;
  std::vector<double> grid(std::size_t surface, int m, int n) const;
  std::vector<double> edge(std::size_t surface, GC::Patch_edge edge) const;
  std::vector<double> knot_line(const Line& line) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_SURFACES_H
