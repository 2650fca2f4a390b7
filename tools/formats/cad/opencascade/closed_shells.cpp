// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/closed_shells.h"

#include "formats/cad/opencascade/losses.h"

#include <BRep_Tool.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_OrientedFace.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <XSControl_WorkSession.hxx>

#include <cstddef>
#include <set>

namespace {

std::vector<Handle(Standard_Transient)> faces_of_closed_shell(const Handle(Standard_Transient) & entity) {
  std::vector<Handle(Standard_Transient)> result;
  if (const auto* shell = dynamic_cast<const StepShape_ClosedShell*>(entity.get());
      shell != nullptr && !shell->CfsFaces().IsNull())
    for (int i = 1; i <= shell->NbCfsFaces(); ++i) {
      Handle(StepShape_Face) face = shell->CfsFacesValue(i);
      if (const auto* oriented = dynamic_cast<const StepShape_OrientedFace*>(face.get()))
        face = oriented->FaceElement();
      result.push_back(face);
    }
  return result;
}

} // namespace

Shell_names closed_shell_names(XSControl_Reader& reader) {
  Shell_names result;
  const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) shell = model->Value(i);
    for (const Handle(Standard_Transient) & face : faces_of_closed_shell(shell)) {
      if (face.IsNull()) continue;
      const TopoDS_Shape shape = shape_of(reader, face);
      if (shape.IsNull()) continue;
      const Handle(TCollection_HAsciiString) label = model->StringLabel(shell);
      for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next())
        result[f.Current().TShape().get()] =
            (label.IsNull() ? "" : label->ToCString()) + std::string(" ") + model->TypeName(shell, false);
    }
  }
  return result;
}

std::vector<Closed_shell> closed_shells(const TopoDS_Shape& shape, const Shell_names& names, bool with_marked) {
  std::vector<Closed_shell> result;
  std::set<const TopoDS_TShape*> of_solids, known;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next())
      of_solids.insert(shell.Current().TShape().get());
  std::map<std::string, std::size_t> numbers; // a shell that is not connected has become several
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
    if (!known.insert(shell.Current().TShape().get()).second) continue;
    std::vector<TopoDS_Shape> faces;
    std::string name;
    for (TopExp_Explorer face(shell.Current(), TopAbs_FACE); face.More(); face.Next()) {
      faces.push_back(face.Current());
      const auto found = names.find(face.Current().TShape().get());
      if (found != names.end()) name = found->second;
    }
    if (name.empty() && of_solids.count(shell.Current().TShape().get()) == 0 &&
        !(with_marked && shell.Current().Closed()))
      continue;
    if (name.empty()) name = "shell " + std::to_string(known.size() - 1);
    const auto [number, is_new] = numbers.emplace(name, result.size());
    if (is_new) result.push_back({name, {}});
    std::vector<TopoDS_Shape>& all = result[number->second].faces;
    all.insert(all.end(), faces.begin(), faces.end());
  }
  return result;
}

std::vector<std::string> open_shells(const std::vector<Closed_shell>& shells) {
  std::vector<std::string> result;
  for (const Closed_shell& shell : shells) {
    TopTools_IndexedMapOfShape edges;
    std::vector<int> uses;
    for (const TopoDS_Shape& face : shell.faces)
      for (TopExp_Explorer i(face, TopAbs_EDGE); i.More(); i.Next()) {
        const TopAbs_Orientation orientation = i.Current().Orientation();
        if (BRep_Tool::Degenerated(TopoDS::Edge(i.Current()))) continue;
        const auto edge = static_cast<std::size_t>(edges.Add(i.Current()) - 1);
        uses.resize(static_cast<std::size_t>(edges.Extent()), 0);
        // 2 inside of a face
        uses[edge] += orientation == TopAbs_FORWARD || orientation == TopAbs_REVERSED ? 1 : 2;
      }
    std::size_t free = 0;
    for (const int n : uses) free += n == 1;
    if (free > 0)
      result.push_back(shell.name + ": said to be closed, but has " + std::to_string(free) +
                       (free == 1 ? " free edge" : " free edges"));
  }
  return result;
}
