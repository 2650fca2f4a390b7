// SPDX-License-Identifier: CC0-1.0

// OpenCASCADE: LocalAnalysis_CurveContinuity for curves, BRepLib::ContinuityOfFaces for edges.
// Reads lines "FILE ORDER [TOLERANCES]" of STEP or BREP files, and answers by lines "= ANSWER".
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAbs_Shape.hxx>
#include <Geom_BSplineCurve.hxx>
#include <LocalAnalysis_CurveContinuity.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using Tolerances = std::map<std::string, double>;

double tolerance(const Tolerances& given, const std::string& name, double otherwise) {
  const Tolerances::const_iterator found = given.find(name);
  return found == given.end() ? otherwise : found->second;
}

std::string in_words(int order) { return order < 0 ? "gap" : "G" + std::to_string(order); }

// A curve between two knots.
struct Span {
  Handle(Geom_Curve) curve;
  double begin, end;
};

// STEP does not say that a chain is closed; the JSON beside the file does.
bool is_closed(const std::string& file) {
  std::ifstream beside(file.substr(0, file.rfind('.')) + ".json");
  return std::string(std::istreambuf_iterator<char>(beside), {}).find("\"closed\": true") != std::string::npos;
}

std::string decide_curves(const TopoDS_Shape& shape, bool closed, const std::string& order, const Tolerances& given,
                          bool has_tolerances) {
  std::vector<Span> spans;
  for (TopExp_Explorer e(shape, TopAbs_EDGE); e.More(); e.Next()) {
    double a, b;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(e.Current()), a, b);
    const Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(curve);
    if (spline.IsNull() || spline->NbKnots() == 2) {
      spans.push_back({curve, a, b});
      continue;
    }
    for (int k = spline->FirstUKnotIndex(); k < spline->LastUKnotIndex(); ++k) {
      const Handle(Geom_BSplineCurve) piece = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
      piece->Segment(spline->Knot(k), spline->Knot(k + 1));
      spans.push_back({Handle(Geom_Curve)(piece), piece->FirstParameter(), piece->LastParameter()});
    }
  }
  if (spans.size() < 2) return "refused a chain of one curve";
  const double gap = tolerance(given, "gap", has_tolerances ? 0 : 0.001);
  const double angle = tolerance(given, "angle_degrees", has_tolerances ? 0 : 0.001 * 180 / M_PI) * M_PI / 180;
  const double percent = tolerance(given, "curvature_percent", has_tolerances ? 0 : 1) / 100;
  const bool is_c = order[0] == 'C';
  const GeomAbs_Shape shapes[] = {GeomAbs_C0, is_c ? GeomAbs_C1 : GeomAbs_G1, is_c ? GeomAbs_C2 : GeomAbs_G2};
  int least = 3, most = 3; // the order of the worst join, and up to which all joins were decided
  for (std::size_t i = 0; i + 1 < spans.size() + closed; ++i) {
    const Span &left = spans[i], &right = spans[(i + 1) % spans.size()];
    // An order that it cannot decide, such as G2 where a curvature is 0, is not asked for again.
    int asked = std::min(order[1] - '0', 2), reached = -1;
    for (; asked >= 0; --asked) {
      try {
        const LocalAnalysis_CurveContinuity join(left.curve, left.end, right.curve, right.begin, shapes[asked], 0.001,
                                                 gap, 0.001, 0.001, angle, has_tolerances ? angle : 0.001, percent);
        if (!join.IsDone()) continue;
        if (!join.IsC0()) break;
        reached = 0;
        if (asked >= 1 && (is_c ? join.IsC1() : join.IsG1()))
          reached = asked >= 2 && (is_c ? join.IsC2() : join.IsG2()) ? 2 : 1;
        if (asked == 2 && reached >= 1 && has_tolerances && percent > 0)
          return "unsupported its percent of curvature is another size";
        break;
      } catch (const Standard_Failure&) { // where it finds no normal
      }
    }
    if (asked < 0) return "refused no order is decided";
    if (reached == asked) most = std::min(most, asked);
    least = std::min(least, reached);
  }
  std::string answer = in_words(least);
  if (is_c && least >= 0) answer[0] = 'C';
  if (least == most && least < order[1] - '0') answer += "+";
  if (has_tolerances) return answer;
  return answer + (is_c ? " within gap=0.001,derivative_jump=0.001"
                        : " within gap=0.001,angle_radians=0.001,curvature_percent=1");
}

std::string decide_faces(const TopoDS_Shape& shape, const std::string& order, const Tolerances& given,
                         bool has_tolerances) {
  // The default of EncodeRegularity(), which healing and modelling call, is 1e-10 radians.
  const double angle = has_tolerances ? tolerance(given, "angle_degrees", 0) * M_PI / 180 : 1e-10;
  if (has_tolerances && given.count("curvature_percent")) return "unsupported tolerances of gap and curvature";
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndUniqueAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces);
  int least = 3;
  for (int i = 1; i <= faces.Extent(); ++i) {
    if (faces(i).IsEmpty()) continue;
    const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(i));
    const TopoDS_Face a = TopoDS::Face(faces(i).First()), b = TopoDS::Face(faces(i).Last());
    if (BRep_Tool::Degenerated(edge) ||
        (faces(i).Extent() != 2 && !(faces(i).Extent() == 1 && BRep_Tool::IsClosed(edge, a))))
      continue;
    const GeomAbs_Shape continuity = BRepLib::ContinuityOfFaces(edge, a, b, angle);
    least = std::min(least, continuity == GeomAbs_C0                               ? 0
                            : continuity == GeomAbs_G1 || continuity == GeomAbs_C1 ? 1
                                                                                   : 2);
  }
  if (least == 3) return "unsupported faces without a common edge";
  const std::string answer = in_words(std::min(least, order[1] - '0'));
  return has_tolerances ? answer : answer + " within gap=0.0000001,angle_radians=1e-10,curvature_percent=0.0000001";
}

std::string decide(const std::string& line) {
  std::istringstream words(line);
  std::string file, order, text;
  words >> file >> order >> text;
  Tolerances given;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');)
    given[part.substr(0, part.find('='))] = std::stod(part.substr(part.find('=') + 1));
  try {
    TopoDS_Shape shape;
    if (file.substr(file.rfind('.')) == ".brep") {
      if (!BRepTools::Read(shape, file.c_str(), BRep_Builder())) return "refused it is not read";
    } else {
      STEPControl_Reader reader;
      if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) return "refused it is not read";
      if (reader.TransferRoots() == 0) return "refused no shape";
      shape = reader.OneShape();
    }
    const bool has_faces = TopExp_Explorer(shape, TopAbs_FACE).More();
    return has_faces ? decide_faces(shape, order, given, !text.empty())
                     : decide_curves(shape, is_closed(file), order, given, !text.empty());
  } catch (const Standard_Failure& failure) {
    return std::string("refused ") + failure.DynamicType()->Name() + " " + failure.GetMessageString();
  }
}

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << "\n= " << decide(line) << std::endl;
}
