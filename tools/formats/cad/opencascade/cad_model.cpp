// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/processor_time.h"
#include "formats/cad/model_bytes.h"
#include "formats/cad/opencascade/cad_surface.h"
#include "formats/cad/opencascade/draw_apart.h"
#include "formats/cad/opencascade/open_boundaries.h"
#include "formats/cad/opencascade/placement.h"
#include "formats/cad/opencascade/read_model.h"
#include "formats/cad/opencascade/spline_numbers.h"
#include "formats/cad/opencascade/wires.h"

#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>

#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <BndLib_Add2dCurve.hxx>
#include <Bnd_Box2d.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Datum3D.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Dir2d.hxx>
#include <gp_Mat.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <unistd.h>

namespace {

// The curve of an edge in the parameter plane of a face.
struct Plane_curve {
  Handle(Geom2d_Curve) curve;
  double begin, end;
  bool projected; // onto a surface that is no plane
};

// An edge in the boundary of a face whose own orientation is not counted.
struct Edge_use {
  std::size_t face;
  TopAbs_Orientation orientation;
  std::optional<Plane_curve> curve;
  std::string reason = "no curve in the parameter plane"; // if there is none
};

// Returns the common beginning of both placements: the placement of the part, and of the parts that
// it belongs to. The list of a placement ends with them.
TopLoc_Location common_placement(const TopLoc_Location& a, const TopLoc_Location& b) {
  const auto list = [](TopLoc_Location location) {
    std::vector<TopLoc_Location> steps;
    for (; !location.IsIdentity(); location = location.NextLocation())
      steps.push_back(TopLoc_Location(location.FirstDatum()).Powered(location.FirstPower()));
    return steps;
  };
  const std::vector<TopLoc_Location> x = list(a), y = list(b);
  TopLoc_Location common;
  for (std::size_t i = 1; i <= (std::min)(x.size(), y.size()); ++i) {
    if (!x[x.size() - i].IsEqual(y[y.size() - i])) break;
    common = common * x[x.size() - i];
  }
  return common;
}

// A placement that mirrors turns the images of normals around. Those of IGES may have a positive
// scale factor all the same.
bool is_mirror(const TopLoc_Location& location) { return location.Transformation().VectorialPart().Determinant() < 0; }

class Model_builder {
  TopTools_IndexedMapOfShape faces_, edges_; // numbered from 1 on
  std::vector<std::vector<Edge_use>> uses_;  // of each edge
  std::vector<std::shared_ptr<const GC::Cad_surface>> surfaces_;
  std::vector<std::string> reasons_;                         // why a surface is not covered
  std::vector<Bnd_Box2d> boxes_;                             // of what the edges of a face use
  std::vector<std::vector<const Plane_curve*>> face_curves_; // those of finite length
  // whether the faces of an edge are, as a shell has them
  std::vector<bool> inside_out_;
  Cad_model model_;
  // These maps hold the geometry that has been read, since a part that is placed again has the
  // same. Surfaces are found by the surface of the file and the used ranges. Curves are found by
  // their numbers, since curves in planes are computed anew for each place.
  typedef std::array<double, 4> Ranges;
  std::map<std::pair<const Standard_Transient*, Ranges>, std::shared_ptr<const GC::Cad_surface>> surfaces_of_file_;
  template <int D> using Curves = std::map<std::string, std::shared_ptr<const GC::Cad_curve<D>>>;
  Curves<2> plane_curves_;
  Curves<3> space_curves_;
  TopLoc_Location place_; // of the part to which the faces of an edge belong

  template <int D> static std::shared_ptr<const GC::Cad_curve<D>> shared(Curves<D>& known, GC::Cad_curve<D> curve) {
    Byte_writer bytes;
    bytes(curve);
    std::shared_ptr<const GC::Cad_curve<D>>& result = known[bytes.bytes()];
    if (!result) result = std::make_shared<const GC::Cad_curve<D>>(std::move(curve));
    return result;
  }

  // A rigid motion that both faces of an edge have in common changes nothing of how they meet.
  void set_place(const std::vector<Edge_use>& uses, Cad_edge& e) {
    const auto location = [&](const Edge_use& use) { return faces_(static_cast<int>(use.face) + 1).Location(); };
    place_ = location(uses[0]);
    for (const Edge_use& use : uses) place_ = common_placement(place_, location(use));
    if (!(std::abs(place_.Transformation().ScaleFactor() - 1) < 1e-12)) // 1 up to rounding in files
      place_ = TopLoc_Location();
    e.place = placement(place_);
  }
  TopLoc_Location in_part(const TopLoc_Location& location) const { return location.Predivided(place_); }

  TopoDS_Face face(std::size_t i) const {
    return TopoDS::Face(faces_(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD));
  }
  TopoDS_Edge edge(std::size_t i) const {
    return TopoDS::Edge(edges_(static_cast<int>(i) + 1).Oriented(TopAbs_FORWARD));
  }

  void add_uses() {
    uses_.resize(static_cast<std::size_t>(edges_.Extent()));
    for (std::size_t f = 0; f < static_cast<std::size_t>(faces_.Extent()); ++f)
      for (TopExp_Explorer i(face(f), TopAbs_EDGE); i.More(); i.Next()) {
        std::vector<Edge_use>& uses = uses_[static_cast<std::size_t>(edges_.FindIndex(i.Current()) - 1)];
        const TopAbs_Orientation orientation = i.Current().Orientation();
        if (orientation == TopAbs_FORWARD || orientation == TopAbs_REVERSED)
          uses.push_back({f, orientation, std::nullopt});
        else { // inside of the face
          uses.push_back({f, TopAbs_FORWARD, std::nullopt});
          uses.push_back({f, TopAbs_REVERSED, std::nullopt});
        }
      }
  }

  // In a shell an edge of two faces is run through in both directions.
  void compare_orientations(const TopoDS_Shape& shape) {
    inside_out_.assign(uses_.size(), false);
    for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next()) {
      // forward, reversed, otherwise
      std::vector<std::array<int, 3>> found(uses_.size(), {0, 0, 0});
      for (TopExp_Explorer i(shell.Current(), TopAbs_EDGE); i.More(); i.Next()) {
        const TopAbs_Orientation orientation = i.Current().Orientation();
        ++found[static_cast<std::size_t>(edges_.FindIndex(i.Current()) - 1)][orientation == TopAbs_FORWARD    ? 0
                                                                             : orientation == TopAbs_REVERSED ? 1
                                                                                                              : 2];
      }
      for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i][2] == 0 && (found[i][0] == 2) != (found[i][1] == 2) && found[i][0] + found[i][1] == 2)
          inside_out_[i] = true;
    }
  }

  // The curve of an edge in the parameter plane of a face, if there is one. Where it is missing it
  // is computed; that on a plane is never in a file. Throws Not_covered for numbers that are not
  // finite, with which the computation would not end. Both are brought to where the face is not
  // placed: curves that are computed are then the same for each place.
  static std::optional<Plane_curve> plane_curve(TopoDS_Edge edge, TopoDS_Face face, bool is_seam) {
    edge.Location(edge.Location().Predivided(face.Location()), false);
    face.Location(TopLoc_Location(), false);
    Plane_curve result{nullptr, 0, 0, false};
    double begin, end;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end);
    const bool has_curve = !curve.IsNull();
    if (has_curve && !is_finite(begin, end)) return std::nullopt;
    const auto look = [&] { result.curve = BRep_Tool::CurveOnSurface(edge, face, result.begin, result.end); };
    look();
    if (result.curve.IsNull()) {
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
      if (!has_curve || surface.IsNull()) return std::nullopt;
      cad_curve(curve, {begin, end});
      cad_surface(surface, {0, 0}, {0, 0});
      result.projected = true;
      ShapeFix_Edge().FixAddPCurve(edge, face, is_seam, Precision::Confusion());
      look();
    }
    if (result.curve.IsNull()) return std::nullopt;
    return result;
  }

  void add_curves() {
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      std::vector<Edge_use>& uses = uses_[i];
      const bool is_seam = uses.size() == 2 && uses[0].face == uses[1].face;
      for (Edge_use& use : uses) {
        try {
          use.curve = plane_curve(TopoDS::Edge(edge(i).Oriented(use.orientation)), face(use.face), is_seam);
        } catch (const Not_covered& e) {
          use.reason = e.what();
        } catch (const Standard_Failure&) { // none can be computed
        }
        if (!use.curve) continue;
        const Plane_curve& c = *use.curve;
        if (!is_finite(c.begin, c.end)) continue;
        BndLib_Add2dCurve::Add(Geom2dAdaptor_Curve(c.curve), c.begin, c.end, 0, boxes_[use.face]);
        if (c.begin < c.end) face_curves_[use.face].push_back(&c);
      }
    }
  }

  // Reads the surface of a face for the parameters that its edges use.
  void add_face(std::size_t number) {
    surfaces_.emplace_back();
    reasons_.emplace_back();
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face(number), location);
    model_.faces.push_back(surface.IsNull() ? "triangles" : surface_name(surface));
    Used_range u{0, 0}, v{0, 0};
    if (!boxes_[number].IsVoid()) boxes_[number].Get(u.begin, v.begin, u.end, v.end);
    try {
      if (surface.IsNull()) throw Not_covered("a face of triangles");
      std::shared_ptr<const GC::Cad_surface>& result =
          surfaces_of_file_[{surface.get(), {u.begin, u.end, v.begin, v.end}}];
      if (!result) result = std::make_shared<const GC::Cad_surface>(cad_surface(surface, u, v));
      surfaces_.back() = result;
    } catch (const Not_covered& e) {
      reasons_.back() = e.what();
      model_.not_covered.emplace_back(number, e.what());
      return;
    }
    if (is_boundary_open(face(number))) model_.not_covered.emplace_back(number, "its boundary does not close");
  }

  Cad_edge_kind kind(const TopoDS_Edge& edge, const std::vector<Edge_use>& uses) const {
    if (BRep_Tool::Degenerated(edge)) return Cad_edge_kind::degenerate;
    if (uses.size() == 1) return Cad_edge_kind::boundary;
    if (uses.size() > 2) return Cad_edge_kind::non_manifold;
    return uses[0].face == uses[1].face ? Cad_edge_kind::seam : Cad_edge_kind::inner;
  }

  GC::Edge_side side(const Edge_use& use, bool is_second) {
    TopLoc_Location location;
    BRep_Tool::Surface(face(use.face), location);
    location = in_part(location);
    const bool is_left = use.orientation == TopAbs_FORWARD; // the face lies left of the curve
    const Used_range range{use.curve->begin, use.curve->end};
    // The faces continue each other when one lies left of the edge and the other one right, as seen
    // on the same side of both.
    return {surfaces_[use.face], shared(plane_curves_, cad_curve(use.curve->curve, range)), placement(location),
            (is_left == is_second) != is_mirror(location), is_left ? 1 : -1};
  }

  // Adds the curve in space, if there is one: of a degenerate edge its first point.
  void add_space_curve(Cad_edge& e, const TopoDS_Edge& edge, const Edge_use& use) {
    if (e.kind == Cad_edge_kind::degenerate) {
      const gp_Pnt2d at = use.curve->curve->Value(e.begin);
      const gp_Pnt p = BRep_Tool::Surface(face(use.face))->Value(at.X(), at.Y());
      const GC::Cad_line<3> point{checked(p.XYZ()), {0, 0, 0}};
      e.space = {std::make_shared<const GC::Cad_curve<3>>(point), placement(TopLoc_Location())};
      return;
    }
    TopLoc_Location location;
    double begin, end;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, begin, end);
    if (curve.IsNull()) return;
    if (begin != e.begin || end != e.end) throw Not_covered("curves of different parameters");
    e.space = {shared(space_curves_, cad_curve(curve, {begin, end})), placement(in_part(location))};
  }

  // Adds the sides of an edge. Throws Not_covered with the reason why they cannot be compared.
  void add_sides(Cad_edge& e, const TopoDS_Edge& edge, const std::vector<Edge_use>& uses) {
    for (std::size_t i = 0; i < uses.size() && i < 2; ++i) {
      const Edge_use& use = uses[i];
      const std::string face = "face " + std::to_string(use.face) + ": ";
      if (!surfaces_[use.face]) throw Not_covered(face + reasons_[use.face]);
      if (!use.curve) throw Not_covered(face + use.reason);
      e.projections[i] = use.curve->projected;
      e.projected = e.projected || use.curve->projected;
    }
    const Plane_curve &a = *uses[0].curve, &b = *uses[uses.size() > 1 ? 1 : 0].curve;
    if (!BRep_Tool::SameParameter(edge) || !BRep_Tool::SameRange(edge) || a.begin != b.begin || a.end != b.end)
      throw Not_covered("curves of different parameters");
    if (!is_finite(a.begin, a.end) || !(a.begin < a.end)) throw Not_covered("an empty or infinite range of parameters");
    e.begin = a.begin;
    e.end = a.end;
    if (e.kind == Cad_edge_kind::degenerate)
      place_ = TopLoc_Location();
    else
      set_place(uses, e);
    add_space_curve(e, edge, uses[0]);
    e.sides = {side(uses[0], false), side(uses[uses.size() > 1 ? 1 : 0], true)};
  }

  void add_edge(std::size_t number) {
    const TopoDS_Edge edge = this->edge(number);
    const std::vector<Edge_use>& uses = uses_[number];
    if (uses.empty()) return; // one of a wire
    TopoDS_Vertex first, last;
    TopExp::Vertices(edge, first, last);
    Cad_edge e;
    e.kind = kind(edge, uses);
    e.closed = !first.IsNull() && first.IsSame(last);
    e.tolerance = BRep_Tool::Tolerance(edge);
    for (const Edge_use& use : uses)
      if (e.faces.empty() || e.faces.back() != use.face) e.faces.push_back(use.face);
    e.inside_out = inside_out_[number];
    try {
      if (e.kind != Cad_edge_kind::boundary && e.kind != Cad_edge_kind::non_manifold) add_sides(e, edge, uses);
    } catch (const Not_covered& reason) {
      e.reason = reason.what();
    }
    model_.edges.push_back(std::move(e));
  }

  // Marks the boundary edges that lie beside others: what they join is not compared.
  void mark_neighbours(double gap) {
    std::vector<Boundary_edge> boundaries;
    std::vector<std::size_t> numbers; // of their edges in the model
    std::size_t next = 0;
    for (std::size_t i = 0; i < uses_.size(); ++i) {
      if (uses_[i].empty()) continue;
      if (model_.edges[next].kind == Cad_edge_kind::boundary) {
        boundaries.push_back({edge(i), face(uses_[i][0].face)});
        numbers.push_back(next);
      }
      ++next;
    }
    const std::vector<std::optional<std::size_t>> beside = edges_beside(boundaries, gap);
    for (std::size_t i = 0; i < beside.size(); ++i)
      if (beside[i])
        model_.edges[numbers[i]].reason = "lies beside edge " + std::to_string(numbers[*beside[i]]) + " of face " +
                                          std::to_string(model_.edges[numbers[*beside[i]]].faces[0]) +
                                          ", not compared: see --sew";
  }

  // Adds the lines inside of a face where the formula of its surface changes, without those parts
  // that lie outside.
  void add_knot_lines(std::size_t number, const Cad_reading& reading) {
    if (!surfaces_[number] || boxes_[number].IsVoid()) return;
    const TopoDS_Face face = this->face(number);
    double low[2], high[2];
    boxes_[number].Get(low[0], low[1], high[0], high[1]);
    for (const GC::Surface_knot_line& line : GC::surface_knot_lines(*surfaces_[number], reading.order)) {
      const int across = line.constant_u ? 0 : 1, along = 1 - across;
      const double margin = 1e-9 * (high[across] - low[across]); // on it the line is a boundary
      if (!(low[across] + margin < line.knot && line.knot < high[across] - margin)) continue;
      const std::vector<double> ends = parts_of_line(number, line, low[along], high[along]);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = ends[i] / 2 + ends[i + 1] / 2;
        if (!(ends[i + 1] - ends[i] > 1e-9 * (high[along] - low[along]))) continue;
        const gp_Pnt2d point = line.constant_u ? gp_Pnt2d(line.knot, middle) : gp_Pnt2d(middle, line.knot);
        if (BRepClass_FaceClassifier(face, point, Precision::PConfusion()).State() != TopAbs_IN) continue;
        add_knot_line(number, line, ends[i], ends[i + 1], reading.drawing);
      }
    }
  }

  // Where a knot line of a face can enter or leave it, in order.
  std::vector<double> parts_of_line(std::size_t number, const GC::Surface_knot_line& line, double begin,
                                    double end) const {
    std::vector<double> ends{begin, end};
    const gp_Pnt2d origin = line.constant_u ? gp_Pnt2d(line.knot, 0) : gp_Pnt2d(0, line.knot);
    const Handle(Geom2d_Curve) straight =
        new Geom2d_TrimmedCurve(new Geom2d_Line(origin, line.constant_u ? gp_Dir2d(0, 1) : gp_Dir2d(1, 0)), begin, end);
    for (const Plane_curve* c : face_curves_[number]) {
      const Geom2dAPI_InterCurveCurve meeting(straight, new Geom2d_TrimmedCurve(c->curve, c->begin, c->end));
      const auto add = [&](const gp_Pnt2d& p) { ends.push_back(line.constant_u ? p.Y() : p.X()); };
      for (int i = 1; i <= meeting.NbPoints(); ++i) add(meeting.Point(i));
      for (double t : {c->begin, c->end}) add(c->curve->Value(t)); // it can end on the line
    }
    ends.erase(std::remove_if(ends.begin(), ends.end(), [=](double t) { return !(begin <= t && t <= end); }),
               ends.end());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  void add_knot_line(std::size_t number, const GC::Surface_knot_line& line, double begin, double end,
                     Cad_drawing drawing) {
    Cad_edge e;
    set_place({{number, TopAbs_FORWARD, std::nullopt}}, e);
    TopLoc_Location location;
    BRep_Tool::Surface(face(number), location);
    const GC::Cad_line<2> straight =
        line.constant_u ? GC::Cad_line<2>{{line.knot, 0}, {0, 1}} : GC::Cad_line<2>{{0, line.knot}, {1, 0}};
    const GC::Edge_side left{surfaces_[number], shared(plane_curves_, GC::Cad_curve<2>(straight)),
                             placement(in_part(location)), false, 1};
    GC::Edge_side right = left;
    right.face_side = -1;
    e.kind = Cad_edge_kind::knot_line;
    e.closed = false;
    e.faces = {number};
    e.tolerance = 0;
    e.begin = begin;
    e.end = end;
    e.sides = {left, right};
    if (drawing == Cad_drawing::faces_and_edges) {
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(face(number));
      constexpr int steps = 32;
      for (int i = 0; i <= steps; ++i) {
        const double t = begin + (end - begin) * i / steps;
        const gp_Pnt p = line.constant_u ? surface->Value(line.knot, t) : surface->Value(t, line.knot);
        e.points.push_back({p.X(), p.Y(), p.Z()});
      }
    }
    model_.edges.push_back(std::move(e));
  }

  // Faces and edges with uses, in the order of the model. All else has been read; most of the time
  // that is left is for the drawing.
  void draw(const Cad_reading& reading) {
    std::vector<TopoDS_Face> faces;
    for (std::size_t i = 0; i < boxes_.size(); ++i) faces.push_back(face(i));
    const double left = reading.time_limit - processor_seconds(::getpid());
    Model_drawing drawing = draw_apart(faces, edges_, {reading.time_limit / 10, 0.75 * left});
    model_.meshes = std::move(drawing.meshes);
    std::size_t next = 0;
    for (std::size_t i = 0; i < uses_.size(); ++i)
      if (!uses_[i].empty()) model_.edges[next++].points = std::move(drawing.edges[i]);
  }

public:
  explicit Model_builder(const TopoDS_Shape& shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    boxes_.resize(static_cast<std::size_t>(faces_.Extent()));
    face_curves_.resize(boxes_.size());
    add_uses();
    compare_orientations(shape);
  }

  Cad_model build(const Cad_reading& reading) {
    add_curves();
    for (std::size_t i = 0; i < boxes_.size(); ++i) add_face(i);
    for (std::size_t i = 0; i < uses_.size(); ++i) add_edge(i);
    mark_neighbours(reading.gap);
    for (std::size_t i = 0; i < boxes_.size(); ++i) add_knot_lines(i, reading);
    if (reading.drawing == Cad_drawing::faces_and_edges) draw(reading);
    return std::move(model_);
  }
};

} // namespace

Cad_model cad_model(const TopoDS_Shape& shape, const Cad_reading& reading) {
  Cad_model model = Model_builder(shape).build(reading);
  model.wires = wires(edges_without_face(shape), reading.gap, reading.order);
  return model;
}
