// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_MODEL_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_MODEL_H

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// These types hold the contents of a CAD file, and do not depend on the library that reads it.

namespace GC = CGAL::Geometric_continuity;

// Where an edge of a model lies.
enum class Cad_edge_kind {
  inner,        // two faces share it
  seam,         // both sides are the same face
  boundary,     // one face has it
  non_manifold, // three faces or more share it
  degenerate,   // it is said to be a point, such as an apex or a pole
  // none of the file: a line inside of a face where the formula of its surface changes and need not
  // be smooth
  knot_line
};

inline const char* name(Cad_edge_kind kind) {
  switch (kind) {
  case Cad_edge_kind::inner: return "inner";
  case Cad_edge_kind::seam: return "seam";
  case Cad_edge_kind::boundary: return "boundary";
  case Cad_edge_kind::non_manifold: return "non-manifold";
  case Cad_edge_kind::degenerate: return "degenerate";
  case Cad_edge_kind::knot_line: break;
  }
  return "knot line";
}

// Numbers of edges and faces count from 0, in the order of the file; knot lines come last.
struct Cad_edge {
  Cad_edge_kind kind;
  bool closed; // it begins where it ends
  // a curve in a parameter plane is not in the file, but the projection of one in space
  bool projected = false;
  std::vector<std::size_t> faces; // which have it, in order; both sides of a seam are one face
  double tolerance;               // how far its curves may be apart, as the file says
  double begin = 0, end = 0;      // the common parameters
  // if they can be compared; of a degenerate edge twice the same
  std::optional<std::array<GC::Edge_side, 2>> sides;
  // why they cannot be compared, if there are two; of a boundary: beside which edge it lies
  std::string reason;
  std::vector<GC::Cad_point<3>> points; // on the edge, if it is to be drawn and can be; rounded
  std::array<bool, 2> projections{};    // which of the sides have curves that are projections
  // the curve in space, if there is one; of a degenerate edge its first point
  std::optional<GC::Edge_curve> space;
  bool inside_out = false; // the faces are oriented as if one were turned inside out
  // Where the sides, and the curve in space, are placed in the model: a part has the same ones
  // wherever it is placed.
  GC::Cad_placement place = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

// The label that a file gives a face.
struct Cad_label {
  std::string id;                              // of its entity, e.g. "#123"
  std::string name;                            // empty if it has none
  std::optional<std::array<double, 3>> colour; // red, green and blue from 0 to 1
  std::size_t instance = 0;                    // the number of the placed part that has it
};

// A face as it is drawn: rounded points, and triangles by their numbers. Empty if it cannot be
// drawn.
struct Cad_mesh {
  std::vector<GC::Cad_point<3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  // If the boundary of a face has been healed, and so differs from the one that is decided: how far
  // the edges are from the triangles, rounded.
  std::optional<double> healed;
  std::string reason = {}; // why it cannot be drawn; empty if it can
};

// A curve of no face, such as an edge of a wire.
struct Cad_curve_edge {
  std::string kind = {};                     // what it is, e.g. "circle"
  std::string id = {};                       // of its entity, e.g. "#123"; empty if it has none
  std::string reason = {};                   // why its joins cannot be decided; empty if they can
  std::vector<GC::Cad_point<3>> points = {}; // on it, in its direction; rounded
  std::optional<GC::Edge_curve> space = {};  // the curve itself, if it can be decided
  double begin = 0, end = 0;                 // its parameters
};

// A place where two curves of no face meet, or one comes back to its start, or may bend at a knot.
struct Cad_join {
  std::array<std::size_t, 2> curves; // by their numbers
  std::array<GC::Edge_end, 2> ends;  // the first one ends there, and the second one starts
  bool is_knot = false;
};

// The curves of no face, in the order of the file.
struct Cad_wires {
  std::vector<Cad_curve_edge> curves;
  std::vector<Cad_join> joins;                      // in the order of their first curves
  std::vector<GC::Cad_point<3>> free_ends;          // where no other curve is
  std::vector<std::vector<std::size_t>> branchings; // of curves of which three ends or more meet
};

struct Cad_model {
  std::vector<std::string> faces; // what their surfaces are, e.g. "cylinder"
  std::vector<Cad_edge> edges;
  // of the faces, if they are to be drawn
  std::vector<Cad_mesh> meshes;
  // what of the file could not be read, with the reason
  std::vector<std::string> lost;
  std::vector<std::string> open_shells; // that are said to be closed
  std::size_t sewn = 0;                 // edges that sewing made of two
  // faces whose surfaces could not be read, and why
  std::vector<std::pair<std::size_t, std::string>> not_covered;
  std::vector<Cad_label> labels; // of the faces
  // the names of the placed parts, if there are several and a part is placed again or has a
  // name
  std::vector<std::string> instances;
  std::size_t shapes = 0; // the different parts among them
  Cad_wires wires;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_MODEL_H
