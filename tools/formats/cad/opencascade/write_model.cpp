// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/write_model.h"

#include "formats/cad/Spline_numbers.h"
#include "formats/cad/cad_file.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <array>
#include <cstddef>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

// The different knots, and how often each is repeated.
struct Distinct_knots {
  std::vector<double> values;
  std::vector<int> multiplicities;

  explicit Distinct_knots(const Spline_numbers::Direction& direction) {
    for (const double x : direction.knots) {
      if (!values.empty() && values.back() == x)
        ++multiplicities.back();
      else {
        values.push_back(x);
        multiplicities.push_back(1);
      }
    }
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      if (multiplicities[i] > direction.degree)
        throw std::runtime_error("a CAD model holds no spline that may jump at a knot");
  }
  TColStd_Array1OfReal knots() const {
    return TColStd_Array1OfReal(values.front(), 1, static_cast<int>(values.size()));
  }
  TColStd_Array1OfInteger counts() const {
    return TColStd_Array1OfInteger(multiplicities.front(), 1, static_cast<int>(multiplicities.size()));
  }
};

gp_Pnt point(const std::array<double, 4>& p) { return gp_Pnt(p[0], p[1], p[2]); }

opencascade::handle<Geom_BSplineCurve> curve(const Spline_numbers& shape) {
  const Distinct_knots u(shape.directions[0]);
  const int n = shape.directions[0].points;
  TColgp_Array1OfPnt points(1, n);
  TColStd_Array1OfReal weights(1, n);
  for (int i = 0; i < n; ++i) {
    const std::array<double, 4>& p = shape.points[static_cast<std::size_t>(i)];
    points(i + 1) = point(p);
    weights(i + 1) = p[3];
  }
  return new Geom_BSplineCurve(points, weights, u.knots(), u.counts(), shape.directions[0].degree);
}

opencascade::handle<Geom_BSplineSurface> surface(const Spline_numbers& shape) {
  const Distinct_knots u(shape.directions[0]), v(shape.directions[1]);
  const int m = shape.directions[0].points, n = shape.directions[1].points;
  TColgp_Array2OfPnt points(1, m, 1, n);
  TColStd_Array2OfReal weights(1, m, 1, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const std::array<double, 4>& p =
          shape.points[static_cast<std::size_t>(j) * static_cast<std::size_t>(m) + static_cast<std::size_t>(i)];
      points(i + 1, j + 1) = point(p);
      weights(i + 1, j + 1) = p[3];
    }
  return new Geom_BSplineSurface(points, weights, u.knots(), v.knots(), u.counts(), v.counts(),
                                 shape.directions[0].degree, shape.directions[1].degree);
}

// Collects wires and faces.
class Shape_builder {
  BRep_Builder builder_;
  TopoDS_Compound all_;
  TopoDS_Wire wire_;
  std::optional<gp_Pnt> first_, last_; // of the wire
  TopoDS_Vertex first_vertex_, last_vertex_;

  void finish_wire() {
    if (first_) builder_.Add(all_, wire_);
    first_.reset();
  }

public:
  Shape_builder() { builder_.MakeCompound(all_); }

  void add(const opencascade::handle<Geom_BSplineSurface>& s) {
    builder_.Add(all_, BRepBuilderAPI_MakeFace(s, 1e-7).Face());
  }

  void add(const opencascade::handle<Geom_BSplineCurve>& c) {
    const gp_Pnt start = c->StartPoint(), end = c->EndPoint();
    if (!first_ || !start.IsEqual(*last_, 0)) {
      finish_wire();
      builder_.MakeWire(wire_);
      first_ = start;
      first_vertex_ = last_vertex_ = BRepBuilderAPI_MakeVertex(start);
    }
    const TopoDS_Vertex next = end.IsEqual(*first_, 0) ? first_vertex_ : BRepBuilderAPI_MakeVertex(end).Vertex();
    BRepBuilderAPI_MakeEdge edge(c, last_vertex_, next);
    if (!edge.IsDone()) throw std::runtime_error("OpenCASCADE makes no edge of a curve; has it a length?");
    builder_.Add(wire_, edge.Edge());
    last_ = end;
    last_vertex_ = next;
  }

  TopoDS_Compound result() {
    finish_wire();
    return all_;
  }
};

} // namespace

void write_model(const std::string& shapes_file, const std::string& model_file) {
  std::ifstream is(shapes_file);
  Shape_builder model;
  for (Spline_numbers shape; shape.read(is);) {
    if (shape.directions.size() == 2)
      model.add(surface(shape));
    else
      model.add(curve(shape));
  }
  const TopoDS_Compound result = model.result();
  bool written = false;
  if (cad_format(model_file) == Cad_format::brep)
    written = BRepTools::Write(result, model_file.c_str());
  else {
    STEPControl_Writer writer;
    Interface_Static::SetCVal("write.step.unit", "MM");
    Interface_Static::SetIVal("write.surfacecurve.mode", 0); // no curves in parameter space
    if (writer.Transfer(result, STEPControl_AsIs) == IFSelect_RetDone) {
      StepData_StepWriter text(writer.Model());
      text.FloatWriter().SetFormat("%.16E"); // so that the same doubles are read
      text.SendModel(StepAP214::Protocol());
      std::ofstream os(model_file);
      written = text.Print(os);
    }
  }
  if (!written) throw std::runtime_error("OpenCASCADE cannot write the model");
}
