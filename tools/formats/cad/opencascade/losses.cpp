// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/losses.h"

#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace {

// Is a shape a loss by itself, and not together with its parts?
bool is_counted(const TopoDS_Shape& shape) {
  return shape.ShapeType() == TopAbs_FACE || shape.ShapeType() == TopAbs_WIRE || shape.ShapeType() == TopAbs_EDGE;
}

const char* type_name(const TopoDS_Shape& shape) {
  switch (shape.ShapeType()) {
  case TopAbs_FACE: return "face";
  case TopAbs_WIRE: return "wire";
  default: break;
  }
  return "edge";
}

} // namespace

Parts_of_shape::Parts_of_shape(const TopoDS_Shape& shape) {
  if (shape.IsNull()) return;
  for (const TopAbs_ShapeEnum type : {TopAbs_FACE, TopAbs_WIRE, TopAbs_EDGE})
    for (TopExp_Explorer i(shape, type); i.More(); i.Next()) parts_.insert(i.Current().TShape().get());
}

bool Parts_of_shape::has(const TopoDS_Shape& shape) const {
  if (shape.IsNull()) return false;
  if (parts_.count(shape.TShape().get()) > 0) return true;
  if (is_counted(shape)) return false;
  for (TopoDS_Iterator i(shape); i.More(); i.Next())
    if (has(i.Value())) return true;
  return false;
}

TopoDS_Shape shape_of(XSControl_Reader& reader, const Handle(Standard_Transient) & entity) {
  const Handle(Transfer_Binder) binder = reader.WS()->TransferReader()->TransientProcess()->Find(entity);
  return binder.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(binder);
}

std::vector<std::string> add_failures(XSControl_Reader& reader, Losses& losses) {
  std::vector<std::string> others;
  const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  // of the translation
  Interface_CheckIterator checks = reader.WS()->TransferReader()->LastCheckList();
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check) check = checks.Value();
    if (!check->HasFailed()) continue;
    const bool has_entity = 1 <= checks.Number() && checks.Number() <= model->NbEntities();
    const Handle(Standard_Transient) entity = has_entity ? model->Value(checks.Number()) : nullptr;
    const Handle(Transfer_Binder) binder = has_entity ? process->Find(entity) : nullptr;
    if (binder.IsNull() || !binder->Check()->HasFailed()) { // the number is that of something else
      others.emplace_back(check->CFail(1));
      continue;
    }
    const Handle(TCollection_HAsciiString) label = model->StringLabel(entity);
    losses.add(label.IsNull() ? "" : label->ToCString(), model->TypeName(entity, false), check->CFail(1));
  }
  return others;
}

void add_losses_of_brep(const TopTools_ShapeSet& file, const TopoDS_Shape& shape, Losses& losses) {
  const Parts_of_shape parts(shape);
  std::set<const TopoDS_TShape*> inner; // what is lost with something that has it
  const auto is_lost = [&](const TopoDS_Shape& s) { return is_counted(s) && !parts.has(s); };
  for (int i = 1; i <= file.NbShapes(); ++i)
    if (is_lost(file.Shape(i)))
      for (TopoDS_Iterator part(file.Shape(i)); part.More(); part.Next()) inner.insert(part.Value().TShape().get());
  for (int i = 1; i <= file.NbShapes(); ++i)
    if (is_lost(file.Shape(i)) && inner.count(file.Shape(i).TShape().get()) == 0)
      losses.add("shape " + std::to_string(i), type_name(file.Shape(i)), "nothing in the model has it");
}
