// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/opencascade/write_model.h"

#include "formats/cad/Spline_numbers.h"
#include "formats/cad/opencascade/Distinct_knots.h"
#include "formats/cad/opencascade/write_shape.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
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

gp_Pnt point(const std::array<double, 4>& p) { return gp_Pnt(p[0], p[1], p[2]); }

opencascade::handle<Geom_BSplineCurve> curve(const Spline_numbers& shape) {
  const Distinct_knots u(shape.directions[0].degree, shape.directions[0].knots);
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
  const Spline_numbers::Direction &along_u = shape.directions[0], &along_v = shape.directions[1];
  const Distinct_knots u(along_u.degree, along_u.knots), v(along_v.degree, along_v.knots);
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
  write_shape(model.result(), model_file, false);
}
