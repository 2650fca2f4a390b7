// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/read_ifc.h"

#include "files/input.h"
#include "files/output.h"
#include "formats/ifc/File.h"
#include "formats/ifc/Segment.h"
#include "formats/ifc/curve_segment.h"
#include "formats/ifc/design_segment.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ifc {

namespace {

class Reader {
  const File file_;
  Rail_file result_;
  std::size_t plain_curves_ = 0;

  void add_piece(const std::string& kind, const std::string& curve, const Segment& s) {
    Rail_piece piece{kind, curve, hash(s.id), s.line, s.shape, s.bend, s.rounded, s.not_covered};
    if (!s.bend && s.not_covered.empty()) piece.not_covered = "a curvature that does not only rise or only fall";
    result_.pieces.push_back(std::move(piece));
  }

  static void set_rounded(Rail_check& check, const Segment& before, const Segment& next) {
    check.rounded = check.rounded_curvature = before.rounded || next.rounded;
    check.rounded_points = before.rounded_points || next.rounded_points;
  }

  static int order_of(const std::string& claim) {
    if (claim == "CONTINUOUS") return 0;
    if (claim == "CONTSAMEGRADIENT") return 1;
    return claim == "CONTSAMEGRADIENTSAMECURVATURE" ? 2 : -1;
  }

  // ---- curves of segments

  void read_curve(std::uint64_t id, const Entity& curve) {
    const std::vector<Step_value> a = file_.arguments(curve, 2);
    const bool is_cant = curve.type == "IFCSEGMENTEDREFERENCECURVE";
    const std::string kind = is_cant ? "cant" : curve.type == "IFCGRADIENTCURVE" ? "vertical" : "horizontal";
    const std::vector<std::uint64_t> ids = file_.references(a[0], curve);
    bool has_segments = kind != "horizontal"; // other composite curves are no alignments
    for (const std::uint64_t segment : ids)
      has_segments = has_segments || file_.at(segment, curve).type == "IFCCURVESEGMENT";
    if (!has_segments) {
      ++plain_curves_;
      return;
    }
    ++result_.curves;
    std::optional<Segment> before;
    for (const std::uint64_t segment_id : ids) {
      Segment next = read_curve_segment(file_, segment_id, curve, is_cant);
      if (kind == "horizontal") add_piece(kind, curve.type + " " + hash(id), next);
      if (before) {
        Rail_check check;
        check.kind = kind;
        check.curve = curve.type + " " + hash(id);
        check.place = hash(before->id) + " - " + hash(next.id);
        check.line = before->line;
        check.claim = before->claim;
        check.claimed = order_of(before->claim);
        check.length = before->length;
        if (!before->not_covered.empty() || !next.not_covered.empty())
          check.not_covered = !before->not_covered.empty() ? before->not_covered : next.not_covered;
        else {
          check.ends = {*before->end, *next.start};
          if (const auto& place = before->turned_from) // so that both are
            check.ends->right.heading =
                GC::Parametric_cubic::graph(Q(0), Q(0), next.start->heading, place->graph, place->length).end().heading;
        }
        set_rounded(check, *before, next);
        result_.checks.push_back(std::move(check));
      }
      before = std::move(next);
    }
  }

  // ---- the design

  // The segments of a layer, in the order of their nesting.
  typedef std::map<std::uint64_t, std::vector<std::uint64_t>> Nesting;
  Nesting nesting() const {
    Nesting result;
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type != "IFCRELNESTS") continue;
      const std::vector<Step_value> a = file_.arguments(e, 6);
      std::vector<std::uint64_t>& parts = result[file_.reference(a[4], e)];
      for (const std::uint64_t part : file_.references(a[5], e)) parts.push_back(part);
    }
    return result;
  }

  // The cant: both rails over the distance, which differ by less than a length.
  void add_cant(const Entity& e, const Entity& next, std::uint64_t id, std::uint64_t next_id,
                const std::string& curve) {
    const std::vector<Step_value> a = file_.arguments(e, 9), b = file_.arguments(next, 9);
    const auto number = [&](const std::vector<Step_value>& values, std::size_t i, const Entity& of) {
      return file_.optional_number(values[i], of);
    };
    const auto end_or_start = [&](std::size_t i) { // of the first segment: the start where there is no end
      const std::optional<Q> end = number(a, i, e);
      return end ? *end : number(a, i - 1, e).value_or(Q(0));
    };
    const Q distance = Q(number(a, 2, e).value_or(Q(0)) + number(a, 3, e).value_or(Q(0)));
    for (const auto& [quantity, value] :
         {std::pair("distance", Q(number(b, 2, next).value_or(Q(0)) - distance)),
          std::pair("left cant", Q(number(b, 4, next).value_or(Q(0)) - end_or_start(5))),
          std::pair("right cant", Q(number(b, 6, next).value_or(Q(0)) - end_or_start(7)))}) {
      Rail_check check;
      check.kind = "design cant";
      check.curve = curve;
      check.place = hash(id) + " - " + hash(next_id) + ", " + quantity;
      check.line = e.line;
      check.claimed = 0;
      check.difference = {quantity, value, false, std::nullopt};
      result_.checks.push_back(std::move(check));
    }
  }

  void read_layer(std::uint64_t id, const Entity& layer, const Nesting& nesting) {
    const auto nested = nesting.find(id);
    if (nested == nesting.end()) return;
    const std::string kind = layer.type == "IFCALIGNMENTHORIZONTAL" ? "design horizontal"
                             : layer.type == "IFCALIGNMENTVERTICAL" ? "design vertical"
                                                                    : "design cant";
    const std::string curve = layer.type + " " + hash(id);
    ++result_.curves;
    std::vector<std::pair<std::uint64_t, const Entity*>> designs;
    for (const std::uint64_t part : nested->second) {
      const Entity& segment = file_.at(part, layer);
      if (segment.type != "IFCALIGNMENTSEGMENT") continue;
      const std::vector<Step_value> a = file_.arguments(segment, 8);
      if (a[7].kind == Kind::reference) designs.emplace_back(a[7].reference, &file_.at(a[7].reference, segment));
    }
    std::optional<Segment> before;
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const Entity* const entity_before = i > 0 ? designs[i - 1].second : nullptr;
      const Entity* const entity_after = i + 1 < designs.size() ? designs[i + 1].second : nullptr;
      const Entity& design = *designs[i].second;
      Segment next;
      next.id = designs[i].first;
      next.line = design.line;
      if (design.type != layer.type + "SEGMENT")
        next.not_covered = "a segment that is " + design.type;
      else if (kind != "design cant")
        try {
          if (kind == "design horizontal")
            read_horizontal_design(file_, next, design);
          else
            read_vertical_design(file_, next, design, entity_before, entity_after);
        } catch (const Not_covered& what) {
          next.not_covered = what.reason;
        }
      if (kind == "design horizontal") add_piece(kind, curve, next);
      if (before && kind == "design cant" && next.not_covered.empty() && before->not_covered.empty())
        add_cant(*entity_before, design, before->id, next.id, curve);
      else if (before) {
        Rail_check check;
        check.kind = kind;
        check.curve = curve;
        check.place = hash(before->id) + " - " + hash(next.id);
        check.line = before->line;
        check.claimed = 0;
        check.length = before->length;
        set_rounded(check, *before, next);
        if (before->end && next.start)
          check.ends = {*before->end, *next.start};
        else
          check.not_covered = before->not_covered.empty() ? next.not_covered : before->not_covered;
        result_.checks.push_back(std::move(check));
      }
      before = std::move(next);
    }
  }

public:
  Reader(std::istream& stream, const std::string& name) : file_(stream, name) {
    result_.precision = file_.precision();
    const Nesting nests = nesting();
    for (const std::uint64_t id : file_.ids()) {
      const Entity& e = file_.entity(id);
      if (e.type == "IFCCOMPOSITECURVE" || e.type == "IFCGRADIENTCURVE" || e.type == "IFCSEGMENTEDREFERENCECURVE")
        read_curve(id, e);
      if (e.type == "IFCALIGNMENTHORIZONTAL" || e.type == "IFCALIGNMENTVERTICAL" || e.type == "IFCALIGNMENTCANT")
        read_layer(id, e, nests);
    }
    if (plain_curves_ > 0)
      result_.notes.push_back(std::to_string(plain_curves_) +
                              " composite curves without IfcCurveSegment are no alignments");
  }
  Rail_file result() && { return std::move(result_); }
};

} // namespace

} // namespace ifc

Rail_file read_ifc(std::istream& stream, const std::string& name) { return ifc::Reader(stream, name).result(); }

Rail_file read_ifc(const std::string& file) {
  Input stream(file);
  return read_ifc(stream, input_name(file));
}

bool is_ifc_file(const std::string& file) {
  if (!is_standard_input(file)) {
    const std::string ending = extension(file);
    if (ending == ".ifc") return true;
    if (!ending.empty()) return false;
  }
  return beginning_of_text(file).find("ISO-10303-21") != std::string::npos &&
         begins_as_ifc(Input(file).beginning(8192)); // behind the names of authors and programs
}
