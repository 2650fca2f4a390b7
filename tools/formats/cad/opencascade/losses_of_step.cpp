// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/losses.h"
#include "formats/cad/step_entities.h"

#include <Interface_InterfaceModel.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_UndefinedEntity.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepToGeom.hxx>
#include <XSControl_WorkSession.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <unordered_map>

namespace {

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

// Returns whether a word of a type begins like this: STYLE begins a word of STYLED_ITEM, and
// PRESENTATION none of REPRESENTATION.
bool has_word(const std::string& type, const std::string& word) {
  for (std::size_t at = type.find(word); at != std::string::npos; at = type.find(word, at + 1))
    if (at == 0 || type[at - 1] == '_' || type[at - 1] == ' ') return true;
  return false;
}

bool is_face(const std::string& type) { return type == "ADVANCED_FACE" || contains(type, "FACE_SURFACE"); }
bool is_edge(const std::string& type) { return contains(type, "EDGE_CURVE"); }
bool is_bound(const std::string& type) { return has_word(type, "FACE_BOUND") || has_word(type, "FACE_OUTER_BOUND"); }

// Is a type a remark, which does not affect the shape: a look, a name, an author?
bool is_remark(const std::string& type) {
  for (const char* word :
       {"STYLE", "COLOUR", "PRESENTATION", "DRAUGHTING", "ANNOTATION", "CAMERA", "APPROVAL", "DATE", "PERSON",
        "ORGANIZATION", "SECURITY", "DOCUMENT", "DIMENSION", "TOLERANCE", "DATUM", "CATEGORY", "APPLICATION"})
    if (has_word(type, word)) return !contains(type, "DIMENSIONAL_EXPONENTS"); // those are of units
  return type == "PROPERTY_DEFINITION" || type == "PROPERTY_DEFINITION_REPRESENTATION";
}

// Returns the axis of an operator, or another one where it has none.
gp_Vec axis(bool is_given, const Handle(StepGeom_Direction) & direction, const gp_Vec& otherwise) {
  if (!is_given || direction.IsNull() || direction->NbDirectionRatios() != 3) return otherwise;
  return gp_Vec(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                direction->DirectionRatiosValue(3));
}

class Step_losses {
  XSControl_Reader& reader_;
  const Handle(Interface_InterfaceModel) model_;
  const Parts_of_shape parts_;
  Losses& losses_;
  std::vector<Step_entity> entities_;
  std::unordered_map<std::uint64_t, std::size_t> places_;               // by the id
  std::unordered_map<std::uint64_t, Handle(Standard_Transient)> known_; // as OpenCASCADE has them

  std::set<std::uint64_t> used_; // the edges of faces

  enum Mark : char { open, active, whole, incomplete };
  std::vector<Mark> marks_; // whether something is missing in an entity or in what it refers to

  static std::string id(std::uint64_t number) { return '#' + std::to_string(number); }

  const Step_entity* find(std::uint64_t id) const {
    const auto place = places_.find(id);
    return place == places_.end() ? nullptr : &entities_[place->second];
  }

  TopoDS_Shape shape_of(const Step_entity& entity) const {
    const auto found = known_.find(entity.id);
    return found == known_.end() ? TopoDS_Shape() : ::shape_of(reader_, found->second);
  }

  // Adds each entity that is not there, with one that refers to it.
  void add_missing() {
    for (const Step_entity& entity : entities_) {
      if (is_remark(entity.type)) continue;
      for (const std::uint64_t reference : entity.references)
        if (find(reference) == nullptr)
          losses_.add(id(reference), "", "not in the file, but " + id(entity.id) + ' ' + entity.type + " refers to it");
    }
  }

  // Adds what is of no known type where the shape is described.
  void add_unknown() {
    std::vector<std::size_t> next;
    std::vector<bool> is_seen(entities_.size(), false);
    for (std::size_t i = 0; i < entities_.size(); ++i) {
      const std::string& type = entities_[i].type;
      if (is_remark(type)) continue;
      for (const char* part : {"SHAPE_REPRESENTATION", "BREP", "SHELL", "FACE", "EDGE"})
        if (contains(type, part)) {
          is_seen[i] = true;
          next.push_back(i);
          break;
        }
    }
    while (!next.empty()) {
      const Step_entity& entity = entities_[next.back()];
      next.pop_back();
      const auto known = known_.find(entity.id);
      if (known == known_.end() || known->second->IsKind(STANDARD_TYPE(StepData_UndefinedEntity)))
        losses_.add(id(entity.id), entity.type, "of no known type");
      for (const std::uint64_t reference : entity.references)
        if (const auto place = places_.find(reference); place != places_.end() && !is_seen[place->second]) {
          is_seen[place->second] = true;
          next.push_back(place->second);
        }
    }
  }

  // Returns whether an entity and all to which it refers are there.
  bool is_whole(std::size_t first) {
    std::vector<std::size_t> path{first};
    while (!path.empty()) {
      const std::size_t i = path.back();
      if (marks_[i] == open) {
        marks_[i] = active;
        for (const std::uint64_t reference : entities_[i].references)
          if (const auto place = places_.find(reference); place != places_.end() && marks_[place->second] == open)
            path.push_back(place->second);
        continue;
      }
      path.pop_back();
      if (marks_[i] != active) continue;
      marks_[i] = losses_.has(id(entities_[i].id)) ? incomplete : whole;
      for (const std::uint64_t reference : entities_[i].references) {
        const auto place = places_.find(reference);
        if (place == places_.end() || marks_[place->second] == incomplete) marks_[i] = incomplete;
      }
    }
    return marks_[first] == whole;
  }

  // Adds what of an entity refers to none of the type that is expected there.
  void add_wrong(const Step_entity& entity, const char* names) {
    losses_.add(id(entity.id), entity.type, std::string("it names no ") + names);
  }

  // Returns the edges in the boundary of a face, as often as it uses them, and adds what of its
  // boundary names none.
  std::vector<const Step_entity*> edges_of(const Step_entity& face) {
    std::vector<const Step_entity*> result;
    for (const std::uint64_t b : face.references) {
      const Step_entity* const bound = find(b);
      if (bound == nullptr || !is_bound(bound->type)) continue; // the surface
      const Step_entity* const loop = bound->references.empty() ? nullptr : find(bound->references.back());
      if (loop == nullptr || !contains(loop->type, "LOOP")) {
        add_wrong(*bound, "loop");
        continue;
      }
      if (!contains(loop->type, "EDGE_LOOP")) continue; // a point, or a polygon
      if (loop->references.empty()) add_wrong(*loop, "edge");
      for (const std::uint64_t u : loop->references) {
        const Step_entity* const use = find(u);
        if (use == nullptr) continue; // it is missing
        const Step_entity* const edge = is_edge(use->type)        ? use
                                        : use->references.empty() ? nullptr
                                                                  : find(use->references.back());
        if (edge != nullptr && is_edge(edge->type)) {
          used_.insert(edge->id);
          result.push_back(edge);
        } else if (edge != nullptr || use->references.empty())
          add_wrong(*use, "edge with a curve");
      }
    }
    return result;
  }

  // Adds the faces that the shape does not have, and the edges that a face has lost.
  void add_faces_and_edges() {
    for (std::size_t i = 0; i < entities_.size(); ++i) {
      const Step_entity& face = entities_[i];
      if (!is_face(face.type)) continue;
      const std::vector<const Step_entity*> edges = edges_of(face);
      const TopoDS_Shape shape = shape_of(face);
      if (!parts_.has(shape)) {
        losses_.add(id(face.id), face.type, "no shape has it");
        continue;
      }
      if (!is_whole(i)) continue; // what is missing is told
      const Parts_of_shape parts(shape);
      for (const Step_entity* edge : edges)
        if (is_edge(edge->type) && !parts.has(shape_of(*edge)))
          losses_.add(id(edge->id), edge->type, "the face " + id(face.id) + " has been read without it");
    }
    std::set<std::uint64_t> named; // by others
    for (const Step_entity& entity : entities_) named.insert(entity.references.begin(), entity.references.end());
    for (const Step_entity& entity : entities_) {
      const std::string& type = entity.type;
      if (is_edge(type) && used_.count(entity.id) == 0 && !parts_.has(shape_of(entity)))
        losses_.add(id(entity.id), type, "no face has it");
      else if ((is_bound(type) || contains(type, "LOOP") || contains(type, "ORIENTED_EDGE")) &&
               named.count(entity.id) == 0)
        losses_.add(id(entity.id), type, "nothing refers to it");
    }
  }

  // Adds the placements that mirror or scale what they place, where OpenCASCADE only moves it.
  void add_placements() {
    for (const Step_entity& entity : entities_) {
      if (entity.type != "MAPPED_ITEM" && !contains(entity.type, "RELATIONSHIP_WITH_TRANSFORMATION")) continue;
      for (const std::uint64_t reference : entity.references) {
        const auto known = known_.find(reference);
        if (known == known_.end()) continue;
        const auto placement = Handle(StepGeom_CartesianTransformationOperator3d)::DownCast(known->second);
        gp_Trsf moved;
        if (placement.IsNull() || placement->LocalOrigin().IsNull() ||
            !StepToGeom::MakeTransformation3d(placement, moved))
          continue;
        const double scale = placement->HasScale() ? placement->Scale() : 1;
        const gp_Vec x = axis(placement->HasAxis1(), placement->Axis1(), gp_Vec(1, 0, 0)),
                     y = axis(placement->HasAxis2(), placement->Axis2(), gp_Vec(0, 1, 0)),
                     z = axis(placement->HasAxis3(), placement->Axis3(), gp_Vec(0, 0, 1));
        const bool mirrors = x.DotCross(y, z) < 0;
        if (std::abs(std::abs(moved.ScaleFactor()) - scale) > 1e-12 * scale)
          losses_.add(id(reference), find(reference)->type, "what it places is read without the scale");
        else if (mirrors != moved.IsNegative())
          losses_.add(id(reference), find(reference)->type, "what it places is read without being mirrored");
      }
    }
  }

public:
  Step_losses(const std::string& file, XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses)
      : reader_(reader), model_(reader.WS()->Model()), parts_(shape), losses_(losses) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    entities_ = step_entities(text);
    for (std::size_t i = 0; i < entities_.size(); ++i) places_.emplace(entities_[i].id, i);
    marks_.assign(entities_.size(), open);
    const auto* const model = dynamic_cast<const StepData_StepModel*>(model_.get());
    for (int i = 1; model != nullptr && i <= model->NbEntities(); ++i)
      known_.emplace(static_cast<std::uint64_t>(model->IdentLabel(model->Value(i))), model->Value(i));
  }

  void add() {
    add_missing();
    add_unknown();
    add_faces_and_edges();
    add_placements();
  }
};

} // namespace

void add_losses_of_step(const std::string& file, XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses) {
  Step_losses(file, reader, shape, losses).add();
}
