// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/labels.h"

#include "formats/cad/opencascade/wires.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESGraph_Color.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <set>
#include <utility>

namespace {

typedef std::array<double, 3> Colour;

std::string text(const Handle(TCollection_HAsciiString) & s) { return s.IsNull() ? "" : s->ToCString(); }

Colour colour_of(const Quantity_Color& c) {
  Colour result;
  c.Values(result[0], result[1], result[2], Quantity_TOC_sRGB);
  return result;
}

// Names that say something: not what systems write where there is none.
std::string meant(const std::string& name) { return name == "NONE" || name.substr(0, 2) == "=>" ? "" : name; }

class Label_reader {
  const Handle(Interface_InterfaceModel) model_;
  const Handle(XSControl_WorkSession) session_;
  Shape_labels result_;

  // Returns the shape of an entity, or nothing if it is no shape.
  TopoDS_Shape shape_of(const Handle(Standard_Transient) & entity) const {
    const Handle(Transfer_Binder) binder = session_->TransferReader()->TransientProcess()->Find(entity);
    return binder.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(binder);
  }

  void add_entity(const Handle(Standard_Transient) & entity) {
    if (const auto* use = dynamic_cast<const StepRepr_NextAssemblyUsageOccurrence*>(entity.get())) {
      const TopoDS_Shape shape = shape_of(entity);
      if (!shape.IsNull()) result_.parts.emplace_back(shape, name_of(*use));
      return;
    }
    const TopoDS_Shape shape = shape_of(entity);
    if (shape.IsNull()) return;
    // a curve, and not the vertex or the parameter line that lead to the same edge
    if (shape.ShapeType() == TopAbs_EDGE)
      result_.edges.emplace(shape.TShape().get(), text(model_->StringLabel(entity)));
    if (shape.ShapeType() != TopAbs_FACE) return;
    Cad_label& label = result_.faces[shape.TShape().get()];
    label.id = text(model_->StringLabel(entity));
    if (const auto* item = dynamic_cast<const StepRepr_RepresentationItem*>(entity.get()))
      label.name = meant(text(item->Name()));
    if (const auto* iges = dynamic_cast<const IGESData_IGESEntity*>(entity.get())) {
      label.name = text(iges->HasName() ? iges->NameValue() : nullptr);
      label.colour = iges_colour(*iges);
    }
  }

  static std::string name_of(const StepRepr_NextAssemblyUsageOccurrence& use) {
    const std::string name = meant(text(use.Name()));
    if (!name.empty()) return name;
    const Handle(StepBasic_ProductDefinition) part = use.RelatedProductDefinition();
    if (part.IsNull() || part->Formation().IsNull() || part->Formation()->OfProduct().IsNull()) return text(use.Id());
    return text(part->Formation()->OfProduct()->Name()) + ':' + text(use.Id());
  }

  static std::optional<Colour> iges_colour(const IGESData_IGESEntity& entity) {
    if (const auto* given = dynamic_cast<const IGESGraph_Color*>(entity.Color().get())) {
      Colour c; // in percent
      given->RGBIntensity(c[0], c[1], c[2]);
      for (double& x : c) x /= 100;
      return c;
    }
    static const Colour colours[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                     {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const int rank = entity.RankColor();
    return 1 <= rank && rank <= 8 ? std::optional<Colour>(colours[rank - 1]) : std::nullopt;
  }

  // A style of a solid or a shell holds for those of its faces that have none.
  void add_colours() {
    STEPConstruct_Styles styles(session_);
    if (!styles.LoadStyles()) return;
    std::set<const TopoDS_TShape*> own;
    for (int i = 1; i <= styles.NbStyles(); ++i) {
      const Handle(StepVisual_StyledItem) style = styles.Style(i);
      Handle(StepVisual_Colour) surface, boundary, curve, render;
      double transparency;
      bool is_component;
      Quantity_Color colour;
      if (!styles.GetColors(style, surface, boundary, curve, render, transparency, is_component) || surface.IsNull() ||
          !STEPConstruct_Styles::DecodeColor(surface, colour))
        continue;
      const TopoDS_Shape shape = shape_of(style->Item());
      if (shape.IsNull()) continue;
      const bool is_own = shape.ShapeType() == TopAbs_FACE;
      for (TopExp_Explorer f(shape, TopAbs_FACE); f.More(); f.Next()) {
        const TopoDS_TShape* const face = f.Current().TShape().get();
        if (is_own ? own.insert(face).second : own.count(face) == 0) result_.faces[face].colour = colour_of(colour);
      }
    }
  }

public:
  explicit Label_reader(XSControl_Reader& reader) : model_(reader.WS()->Model()), session_(reader.WS()) {}

  Shape_labels read() {
    for (int i = 1; i <= model_->NbEntities(); ++i) add_entity(model_->Value(i));
    if (dynamic_cast<const StepData_StepModel*>(model_.get()) != nullptr) add_colours();
    return std::move(result_);
  }
};

// The parts of which a shape is composed, and what they are called.
class Part_finder {
  const Shape_labels& labels_;
  TopTools_IndexedMapOfShape names_; // the labelled parts, numbered from 1 on
  std::vector<std::pair<TopoDS_Shape, std::string>> parts_;
  std::map<const TopoDS_TShape*, std::size_t> numbers_; // how often each comes

  std::string name_of(const TopoDS_Shape& shape) const {
    const int i = names_.FindIndex(shape);
    return i == 0 ? "" : labels_.parts[static_cast<std::size_t>(i - 1)].second;
  }

  void add(const TopoDS_Shape& shape, const TopLoc_Location& place, const std::string& path, int depth) {
    for (TopoDS_Iterator i(shape, false, false); i.More(); i.Next()) {
      const std::string name = name_of(i.Value()), separator = path.empty() || name.empty() ? "" : "/";
      const TopLoc_Location inner = place * i.Value().Location();
      if (i.Value().ShapeType() == TopAbs_COMPOUND && depth < 100)
        add(i.Value(), inner, path + separator + name, depth + 1);
      else {
        parts_.emplace_back(i.Value().Located(inner), path + separator + name);
        ++numbers_[i.Value().TShape().get()];
      }
    }
  }

public:
  explicit Part_finder(const Shape_labels& labels) : labels_(labels) {
    for (const auto& [shape, name] : labels.parts) names_.Add(shape);
  }

  void label(const TopoDS_Shape& shape, const TopTools_IndexedMapOfShape& faces, Cad_model& model) {
    if (shape.ShapeType() != TopAbs_COMPOUND) return;
    add(shape, shape.Location(), "", 0);
    const bool is_repeated =
        std::any_of(numbers_.begin(), numbers_.end(), [](const auto& number) { return number.second > 1; });
    if (parts_.size() < 2 || (!is_repeated && labels_.parts.empty())) return;
    model.shapes = numbers_.size();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& [part, name] = parts_[i];
      model.instances.push_back(name.empty() ? "part " + std::to_string(i) : name);
      for (TopExp_Explorer f(part, TopAbs_FACE); f.More(); f.Next())
        if (const int number = faces.FindIndex(f.Current()); number > 0)
          model.labels[static_cast<std::size_t>(number - 1)].instance = i;
    }
  }
};

} // namespace

Shape_labels read_labels(XSControl_Reader& reader) { return Label_reader(reader).read(); }

void add_labels(const TopoDS_Shape& shape, const Shape_labels& labels, Cad_model& model) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const auto label = labels.faces.find(faces(i).TShape().get());
    model.labels.push_back(label == labels.faces.end() ? Cad_label() : label->second);
  }
  Part_finder(labels).label(shape, faces, model);
  const std::vector<TopoDS_Edge> edges = edges_without_face(shape);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (const auto id = labels.edges.find(edges[i].TShape().get()); id != labels.edges.end())
      model.wires.curves[i].id = id->second;
}
