// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/losses.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESData_UndefinedEntity.hxx>
#include <IGESGeom_CompositeCurve.hxx>
#include <IGESGeom_CurveOnSurface.hxx>
#include <IGESSolid_Loop.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Protocol.hxx>
#include <Interface_ShareTool.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cstddef>

namespace {

constexpr int group_type = 402;

// Curves, surfaces and what is made of them.
bool is_geometry(int type) { return (100 <= type && type < 200) || (500 <= type && type < 520); }
bool is_curve(int type) {
  for (const int t : {100, 102, 104, 110, 112, 126, 130})
    if (type == t) return true;
  return false;
}
bool is_surface(int type) {
  for (const int t : {114, 118, 120, 122, 128, 140, 190, 192, 194, 196, 198})
    if (type == t) return true;
  return false;
}
bool is_face(int type) { return type == 143 || type == 144 || type == 510; }

class Iges_losses {
  XSControl_Reader& reader_;
  const Handle(Interface_InterfaceModel) model_;
  const Interface_ShareTool sharing_;
  const Parts_of_shape parts_;
  Losses& losses_;

  void add(const Handle(Standard_Transient) & entity, const std::string& reason) {
    const Handle(TCollection_HAsciiString) label = model_->StringLabel(entity);
    losses_.add(label.IsNull() ? "" : label->ToCString(), model_->TypeName(entity, false), reason);
  }

  // Returns whether a curve, a surface or the like refers to an entity.
  bool is_part_of_geometry(const Handle(Standard_Transient) & entity) const {
    Interface_EntityIterator users = sharing_.Sharings(entity);
    for (users.Start(); users.More(); users.Next())
      if (const auto* user = dynamic_cast<const IGESData_IGESEntity*>(users.Value().get());
          user != nullptr && is_geometry(user->TypeNumber()))
        return true;
    return false;
  }
  // Returns whether only groups refer to an entity.
  bool is_root(const Handle(Standard_Transient) & entity) const {
    Interface_EntityIterator users = sharing_.Sharings(entity);
    for (users.Start(); users.More(); users.Next())
      if (const auto* user = dynamic_cast<const IGESData_IGESEntity*>(users.Value().get());
          user == nullptr || user->TypeNumber() != group_type)
        return false;
    return true;
  }

  // Returns whether a curve or a surface is said to be a part of another entity, and none refers to
  // it but those that say nothing. Faces and shells are not asked: OpenCASCADE writes single ones
  // as parts.
  bool is_orphan(const IGESData_IGESEntity& entity) const {
    const int type = entity.TypeNumber();
    if (!is_geometry(type) || type >= 500 || is_face(type)) return false;
    if (entity.SubordinateStatus() != 1 && entity.SubordinateStatus() != 3) return false;
    Interface_EntityIterator users = sharing_.Sharings(&entity);
    for (users.Start(); users.More(); users.Next())
      if (const auto* user = dynamic_cast<const IGESData_IGESEntity*>(users.Value().get());
          user == nullptr || user->TypeNumber() != 0)
        return false;
    return true;
  }

  // Adds what is of no known type, or damaged.
  void add_damaged(int number, const Handle(Standard_Transient) & entity, int type) {
    const bool is_unknown = entity->IsKind(STANDARD_TYPE(IGESData_UndefinedEntity));
    if (is_unknown && (is_geometry(type) || is_part_of_geometry(entity)))
      add(entity, "of no known type (" + std::to_string(type) + ')');
    if (is_unknown || !is_geometry(type)) return;
    const Handle(Interface_Check) check = model_->Check(number, true);
    if (check->HasFailed()) add(entity, check->CFail(1));
    for (int i = 1; i <= check->NbWarnings(); ++i) { // what would be placed elsewhere, or left out
      const std::string warning = check->CWarning(i);
      if (warning.find("Transformation Matrix") != std::string::npos ||
          warning.find("null or negative") != std::string::npos)
        add(entity, warning);
    }
  }

  static std::size_t number_of_edges(const TopoDS_Shape& shape) {
    std::size_t result = 0;
    if (!shape.IsNull())
      for (TopExp_Explorer i(shape, TopAbs_EDGE); i.More(); i.Next()) ++result;
    return result;
  }

  static std::size_t number_of_curves(const Handle(IGESData_IGESEntity) & curve) {
    const auto* const composite = dynamic_cast<const IGESGeom_CompositeCurve*>(curve.get());
    if (composite == nullptr) return curve.IsNull() ? 0 : 1;
    std::size_t result = 0;
    for (int i = 1; i <= composite->NbCurves(); ++i) result += number_of_curves(composite->Curve(i));
    return result;
  }

  // The edges that a part of a boundary has at least.
  static std::size_t number_of_named(const Handle(Standard_Transient) & entity) {
    if (const auto* loop = dynamic_cast<const IGESSolid_Loop*>(entity.get())) {
      std::size_t result = 0;
      for (int i = 1; i <= loop->NbEdges(); ++i) result += loop->EdgeType(i) == 0;
      return result;
    }
    const auto* const curve = dynamic_cast<const IGESGeom_CurveOnSurface*>(entity.get());
    if (curve == nullptr) return 0;
    const std::size_t in_plane = number_of_curves(curve->CurveUV()), in_space = number_of_curves(curve->Curve3D());
    return in_plane == 0 || in_space == 0 ? (std::max)(in_plane, in_space) : (std::min)(in_plane, in_space);
  }

  void add_lost(const Handle(Standard_Transient) & entity, int type) {
    const TopoDS_Shape shape = shape_of(reader_, entity);
    if (is_face(type) || ((is_curve(type) || is_surface(type)) && is_root(entity))) {
      if (!parts_.has(shape)) add(entity, "no shape has it");
      return;
    }
    const std::size_t named = number_of_named(entity), read = number_of_edges(shape);
    if (read < named)
      add(entity, std::to_string(named - read) + " of its " + std::to_string(named) + " edges cannot be read");
  }

public:
  Iges_losses(XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses)
      : reader_(reader), model_(reader.WS()->Model()), sharing_(model_, reader.WS()->Protocol()), parts_(shape),
        losses_(losses) {}

  void add() {
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const Handle(Standard_Transient) entity = model_->Value(i);
      const auto* const iges = dynamic_cast<const IGESData_IGESEntity*>(entity.get());
      if (iges == nullptr) continue;
      if (is_orphan(*iges)) add(entity, "a part of another entity, to which none refers");
      add_damaged(i, entity, iges->TypeNumber());
      add_lost(entity, iges->TypeNumber());
    }
  }
};

} // namespace

void add_losses_of_iges(XSControl_Reader& reader, const TopoDS_Shape& shape, Losses& losses) {
  Iges_losses(reader, shape, losses).add();
}
