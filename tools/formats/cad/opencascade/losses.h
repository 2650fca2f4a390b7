// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LOSSES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LOSSES_H

#include <TopTools_ShapeSet.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <XSControl_Reader.hxx>

#include <set>
#include <string>
#include <vector>

// These functions find the things that a file names and OpenCASCADE leaves out without a word.

// Lists what of a file is lost, each entity once: "#60 EDGE_CURVE: ...".
class Losses {
  std::vector<std::string>& list_;
  std::set<std::string> entities_;

public:
  explicit Losses(std::vector<std::string>& list) : list_(list) {}

  bool has(const std::string& entity) const { return entities_.count(entity) > 0; }
  bool empty() const { return list_.empty(); }
  // An entity is its id and its type, of which only the id need be known.
  void add(const std::string& id, const std::string& type, const std::string& reason) {
    if (!id.empty() && !entities_.insert(id).second) return;
    const std::string entity = id + (id.empty() || type.empty() ? "" : " ") + type;
    list_.push_back((entity.empty() ? "something" : entity) + ": " + reason);
  }
};

// The faces, wires and edges of a shape, wherever they are placed.
class Parts_of_shape {
  std::set<const TopoDS_TShape*> parts_;

public:
  explicit Parts_of_shape(const TopoDS_Shape& shape);

  // Returns whether a shape, or a face or an edge in it, is among them.
  bool has(const TopoDS_Shape& shape) const;
};

// Returns the shape of an entity, or nothing if it is no shape.
TopoDS_Shape shape_of(XSControl_Reader& reader, const Handle(Standard_Transient) & entity);

// Adds what could not be translated as the reader says, and returns what it says of no entity.
std::vector<std::string> add_failures(XSControl_Reader& reader, Losses& losses);

// Adds the entities of a STEP file to which others refer and which are not there or of no known
// type, and its faces and edges that the shape does not have.
void add_losses_of_step(const std::string& file, XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses);

// Adds the entities of an IGES file that are wrong or of no known type, and its faces and edges
// that the shape does not have.
void add_losses_of_iges(XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses);

// Adds the faces, wires and edges of a BREP file that the shape does not have.
void add_losses_of_brep(const TopTools_ShapeSet& file, const TopoDS_Shape& shape, Losses& losses);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_LOSSES_H
