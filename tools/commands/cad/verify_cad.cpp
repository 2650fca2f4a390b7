// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/verify_cad.h"

#include "commands/cad/Cad_words.h"
#include "commands/cad/cad_json.h"
#include "commands/cad/decide_cad.h"
#include "formats/cad/entity_lines.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace {

Finding_rule rule(Cad_shape shape) {
  switch (shape) {
  case Cad_shape::gap: return Finding_rule::gap;
  case Cad_shape::corner:
  case Cad_shape::fading_corner: return Finding_rule::corner;
  case Cad_shape::kink:
  case Cad_shape::bent:
  case Cad_shape::fold:
  case Cad_shape::inside_out: return Finding_rule::kink;
  case Cad_shape::smooth: return Finding_rule::curvature;
  case Cad_shape::undecided: break;
  }
  return Finding_rule::undecided;
}

// How large the defect of this rule is.
std::optional<Measure> measure(Finding_rule rule, const Cad_verdict& verdict) {
  if (!verdict.enclosure) {
    if (rule != Finding_rule::gap || !verdict.deviation) return std::nullopt;
    return Measure{"gap", verdict.deviation->value}; // of what is said to be a point
  }
  const GC::Edge_enclosure& e = *verdict.enclosure;
  if (rule == Finding_rule::gap) return Measure{"gap", e.gap.value};
  if ((rule == Finding_rule::corner || rule == Finding_rule::kink) && e.angle)
    return Measure{"angle_degrees", GC::in_degrees(e.angle->value)};
  if (rule == Finding_rule::curvature && e.curvature_jump) return Measure{"curvature_jump", e.curvature_jump->value};
  return std::nullopt;
}

// A face by its entity, or by what it is and its number where the file has no ids.
std::string entity(std::size_t face, const Cad_model& model) {
  if (face >= model.labels.size()) return "face " + std::to_string(face);
  const Cad_label& label = model.labels[face];
  const std::string text = label.id.empty() ? model.faces[face] + ' ' + std::to_string(face) : label.id;
  return model.instances.empty() ? text : text + " of " + model.instances[label.instance];
}

std::string entities(const Cad_edge& edge, const Cad_model& model) {
  std::string text;
  for (const std::size_t face : edge.faces) text += (text.empty() ? "" : " - ") + entity(face, model);
  return text;
}

// Describes an edge, wherever the model is placed and whatever the numbers of its entities are.
std::string shape(const Cad_edge& edge, const Cad_model& model) {
  std::vector<std::string> surfaces;
  for (const std::size_t face : edge.faces) surfaces.push_back(model.faces[face]);
  std::sort(surfaces.begin(), surfaces.end());
  std::string text =
      std::string(name(edge.kind)) + (edge.closed ? ", closed, " : ", ") + rounded(edge.end - edge.begin, 6);
  for (const std::string& surface : surfaces) text += ", " + surface;
  return text;
}

class Cad_report {
  const Cad_demand& demand_;
  Report report_;
  Cad_summary summary_;
  bool names_files_; // in text
  // of the entities of a file, where findings are written
  std::unordered_map<std::string, long long> lines_;

  static Report_subject subject(const Cad_demand& demand) {
    Report_subject s{"edge of two sides", "every edge of two sides and every knot line"};
    s.proof = "proved";
    if (demand.order) {
      s.required = demand.name() + " within the tolerance";
      if (*demand.order > 0 && demand.kind == GC::Continuity_kind::G) s.required += " or a corner";
      s.required_in_json = "\"required\":\"" + demand.name() + '"';
    }
    if (demand.curvature) {
      s.every = "every join of curves"; // there are no faces
      demand_curvature(s, *demand.curvature);
    }
    return s;
  }

  bool is_text() const { return report_.mode().format == Report_format::text; }

  // The line of an entity, by its id or a text that begins with it.
  long long line_of(const std::string& text) const {
    const auto line = lines_.find(text.substr(0, text.find_first_of(" :")));
    return line == lines_.end() ? no_line : line->second;
  }
  long long line_of_face(const Cad_model& model, std::size_t face) const {
    return face < model.labels.size() ? line_of(model.labels[face].id) : no_line;
  }

  // Adds what is said of an edge, and its class if it has one: boundaries and points have nothing
  // to decide.
  void add(const Decided_cad_file& file, std::size_t number) {
    const Cad_edge& edge = file.model.edges[number];
    const Cad_verdict& verdict = file.verdicts[number];
    const std::optional<Given> given = claim_of(edge, verdict, demand_);
    add_row(number, edge, verdict, file, given ? given->claim : Claim::met);
    if (!given) return;
    const bool is_noted =
        has_verdict(edge) && !demand_.order && verdict.shape != Cad_shape::smooth && verdict.shape != Cad_shape::corner;
    report_.add(file.file, *given, is_noted, [&] {
      Finding f;
      f.file = file.file;
      f.line = edge.faces.empty() ? no_line : line_of_face(file.model, edge.faces[0]);
      f.kind = "edge";
      f.place = cad_place(number, edge, file.model);
      f.rule = given->claim == Claim::not_covered ? Finding_rule::not_verified
               : given->claim == Claim::undecided ? Finding_rule::undecided
                                                  : rule(verdict.shape);
      f.message = (given->claim == Claim::not_met ? "not " + report_.subject().required + ", " : "") +
                  cad_sentence(edge, verdict, demand_);
      std::ostringstream properties;
      write_members(properties, number, edge, verdict);
      f.properties = properties.str();
      f.object = entities(edge, file.model);
      f.spot = name(edge.kind);
      f.shape = shape(edge, file.model);
      f.measure = measure(f.rule, verdict);
      if (f.rule == Finding_rule::gap && verdict.enclosure && verdict.enclosure->angle)
        f.behind = Measure{"angle_degrees", GC::in_degrees(verdict.enclosure->angle->value)};
      return f;
    });
  }

  // Adds a join of curves without faces.
  void add_join(const Decided_cad_file& file, std::size_t number) {
    const Cad_wires& wires = file.model.wires;
    const Cad_join& join = wires.joins[number];
    const Cad_join_verdict& verdict = file.joins[number];
    const Given given = claim_of(verdict, demand_);
    std::ostringstream os;
    if (is_text())
      os << cad_place(join, wires) << ": " << cad_sentence(verdict, demand_) << '\n';
    else if (report_.mode().format == Report_format::json) {
      GC::write_json(os << ",\n {\"file\":", file.file);
      write_members(os << ',', number, join, verdict);
      os << '}';
    }
    report_.row("joins", os.str(), given.claim);
    const bool is_noted = !demand_.order && verdict.shape != Cad_shape::smooth && verdict.shape != Cad_shape::corner;
    report_.add(file.file, given, is_noted, [&] {
      Finding f;
      f.file = file.file;
      f.line = line_of(wires.curves[join.curves[0]].id);
      f.kind = "join";
      f.place = cad_place(join, wires);
      f.rule = given.claim == Claim::not_covered ? Finding_rule::not_verified
               : given.claim == Claim::undecided ? Finding_rule::undecided
                                                 : rule(verdict.shape);
      if (f.rule == Finding_rule::curvature && demand_.kind == GC::Continuity_kind::C)
        f.rule = Finding_rule::derivative;
      f.message = (given.claim == Claim::not_met ? "not " + report_.subject().required + ", " : "") +
                  cad_sentence(verdict, demand_);
      std::ostringstream properties;
      write_members(properties, number, join, verdict);
      f.properties = properties.str();
      for (const std::size_t curve : join.curves) {
        const Cad_curve_edge& c = wires.curves[curve];
        f.object += (f.object.empty() ? "" : " - ") + (c.id.empty() ? "curve " + std::to_string(curve) : c.id);
        f.shape += (f.shape.empty() ? "" : " - ") + c.kind;
      }
      f.spot = join.is_knot ? "knot" : "join";
      if (!verdict.enclosure) return f;
      const GC::Join_deviation& d = verdict.enclosure->deviation;
      if (f.rule == Finding_rule::gap) f.measure = Measure{"gap", d.gap};
      if ((f.rule == Finding_rule::corner || f.rule == Finding_rule::kink) && d.tangent_angle)
        f.measure = Measure{"angle_degrees", GC::in_degrees(*d.tangent_angle)};
      if (f.rule == Finding_rule::curvature && d.curvature_jump)
        f.measure = Measure{"curvature_jump", *d.curvature_jump};
      if (f.rule == Finding_rule::gap && d.tangent_angle)
        f.behind = Measure{"angle_degrees", GC::in_degrees(*d.tangent_angle)};
      return f;
    });
  }

  // Adds what of curves without faces has no verdict.
  void add_not_covered_curve(const std::string& file, const std::string& place, const Given& given, long long line) {
    if (is_text()) report_.row("not_read", place + ": " + given.reason + '\n');
    report_.add(file, given, true, [&] {
      Finding f;
      f.file = file;
      f.line = line;
      f.kind = given.noun;
      f.place = place;
      f.rule = Finding_rule::not_verified;
      f.message = "not compared, " + given.reason;
      f.shape = given.reason;
      return f;
    });
  }

  // Adds how far a curve without faces is bent.
  void add_bend(const Decided_cad_file& file, std::size_t number, const Cad_bend& bend) {
    const Cad_wires& wires = file.model.wires;
    const auto members = [&] {
      std::ostringstream os;
      write_members(os, number, bend);
      return os.str();
    };
    report_.add(file.file, bend.given, false, [&] {
      Finding f;
      f.file = file.file;
      f.line = line_of(wires.curves[number].id);
      f.kind = "curve";
      f.place = cad_place(number, wires);
      f.rule = bend.given.claim == Claim::not_covered ? Finding_rule::not_verified
               : bend.given.claim == Claim::undecided ? Finding_rule::undecided
                                                      : Finding_rule::bend;
      f.message =
          (bend.given.claim == Claim::not_met ? "not " + demand_.curvature->words + ": " : "") + cad_sentence(bend);
      f.properties = members();
      f.object = wires.curves[number].id.empty() ? "curve " + std::to_string(number) : wires.curves[number].id;
      f.shape = wires.curves[number].kind;
      if (bend.given.claim == Claim::not_met) f.measure = Measure{"curvature", bend.curvature.value};
      return f;
    });
    if (bend.given.claim == Claim::met) return;
    if (is_text())
      report_.row("bent_curves", cad_place(number, wires) + ": " + cad_sentence(bend) + '\n', bend.given.claim);
    else if (bend.given.claim != Claim::not_covered)
      report_.row("bent_curves", ",\n {\"file\":" + json_text(file.file) + ',' + members() + '}', bend.given.claim);
  }

  void add_wires(const Decided_cad_file& file) {
    const Cad_wires& wires = file.model.wires;
    for (std::size_t i = 0; i < wires.joins.size(); ++i) add_join(file, i);
    for (const auto& [number, bend] : file.bends) add_bend(file, number, bend);
    for (std::size_t i = 0; i < wires.curves.size(); ++i)
      if (const Cad_curve_edge& c = wires.curves[i]; !c.reason.empty())
        add_not_covered_curve(file.file, "curve " + std::to_string(i) + " (" + c.kind + ')',
                              {Claim::not_covered, "curve", c.reason}, line_of(c.id));
    for (const std::vector<std::size_t>& branching : wires.branchings) {
      std::string place = "ends of curves";
      for (const std::size_t curve : branching)
        place += (curve == branching.front() ? " " : ", ") + std::to_string(curve);
      add_not_covered_curve(file.file, place, {Claim::not_covered, "place", branching_of_curves},
                            line_of(wires.curves[branching[0]].id));
    }
  }

  void add_row(std::size_t number, const Cad_edge& edge, const Cad_verdict& verdict, const Decided_cad_file& file,
               Claim claim) {
    std::ostringstream os;
    if (is_text())
      os << cad_place(number, edge, file.model) << ' ' << cad_sentence(edge, verdict, demand_) << '\n';
    else if (report_.mode().format == Report_format::json) {
      GC::write_json(os << ",\n {\"file\":", file.file);
      write_members(os << ',', number, edge, verdict);
      os << '}';
    }
    report_.row("edges", os.str(), claim);
  }

  // Adds what could not be read, or is not as the file says. The text begins with its id.
  void add_not_covered(const std::string& file, const char* kind, const std::string& text, const Given& given,
                       long long line, const std::string& words = "not read: ") {
    if (is_text())
      report_.row("not_read", words + text + '\n');
    else
      report_.row("not_read", ',' + json_text(file + ": " + text));
    report_.add(file, given, true, [&] {
      Finding f;
      f.file = file;
      f.shape = text.substr((std::min)(text.find(':'), text.size())); // without its number
      f.line = line;
      f.kind = kind;
      f.place = text.substr(0, text.find(':'));
      f.rule = Finding_rule::not_verified;
      f.message = words + text;
      return f;
    });
  }

  void add(const Decided_cad_file& file) {
    if (demand_.curvature && !file.model.faces.empty())
      throw std::invalid_argument(
          "--max-curvature, --min-radius: of CAD models curves without faces are bounded, and " + file.file +
          " has faces");
    if (demand_.kind == GC::Continuity_kind::C && !file.model.faces.empty())
      throw std::invalid_argument("--require " + demand_.name() +
                                  ": of CAD models G0, G1 and G2 are decided, and C orders only of curves without "
                                  "faces; " +
                                  file.file + " has faces");
    report_.begin_file(file.file);
    lines_.clear();
    if (report_.mode().has_findings()) lines_ = entity_lines(file.file);
    if (is_text() && names_files_) report_.row("edges", file.file + ":\n");
    for (std::size_t i = 0; i < file.verdicts.size(); ++i) add(file, i);
    for (const std::string& lost : file.model.lost)
      add_not_covered(file.file, "element", lost, {Claim::not_covered, "element", "it cannot be read"}, line_of(lost));
    for (const std::string& shell : file.model.open_shells)
      add_not_covered(file.file, "shell", shell, {Claim::not_covered, "shell", "it is said to be closed, and is not"},
                      line_of(shell), "not closed: ");
    for (const auto& [face, reason] : file.model.not_covered)
      add_not_covered(file.file, "face", "face " + std::to_string(face) + ": " + reason,
                      {Claim::not_covered, "face", reason}, line_of_face(file.model, face));
    add_wires(file);
    summary_.add(file, demand_);
  }

  std::string text_summary() const {
    const Cad_summary& s = summary_;
    std::ostringstream os;
    if (s.beside > 0) os << beside_words(s.beside) << '\n';
    if (s.curves > 0) {
      os << counted(s.curves, "curve") << " without a face; " << counted(s.joins, "join") << ", "
         << counted(s.free_ends, "free end");
      if (s.branchings > 0) os << ", " << counted(s.branchings, "place") << " where three curves or more meet";
      os << '\n';
    }
    if (s.faces > 0 || s.curves == 0)
      os << counted(s.faces, "face") << "; edges: " << s.inner << " inner, " << counted(s.seams, "seam") << ", "
         << s.boundary << " boundary, " << s.degenerate << " degenerate, " << s.non_manifold << " non-manifold";
    if (s.knot_lines > 0) os << "; " << counted(s.knot_lines, "knot line") << " inside of faces";
    if (s.faces > 0 || s.curves == 0) os << '\n';
    if (s.instances > 0) os << parts_words(s.instances, s.shapes) << '\n';
    if (s.sewn > 0) os << sewn_words(s.sewn) << '\n';
    if (s.decided() == 0 && s.beside == 0 && !demand_.curvature && !s.hint().empty()) os << s.hint() << '\n';
    if (s.decided() > 0) {
      os << "within " << demand_.tolerance << " (lengths in mm): " << s.g2 << " G2, " << s.g1 << " G1, " << s.g0
         << " G0, " << counted(s.gaps, "gap") << ", " << s.undecided << " undecided"
         << (s.not_compared == 0 ? "" : ", " + std::to_string(s.not_compared) + " not compared") << "; "
         << counted(s.corners, "corner") << ", " << counted(s.fading_corners, "fading corner") << ", "
         << counted(s.kinks, "kink");
      if (s.bent > 0) os << ", " << s.bent << " kink or corner";
      if (s.folds > 0) os << ", " << counted(s.folds, "fold");
      if (s.inside_out > 0) os << ", " << s.inside_out << " inside out";
      os << '\n';
    }
    if (s.projected > 0)
      os << counted(s.projected, "edge") << " with curves in parameter planes that are not in the file, but"
         << " projections of those in space\n";
    return os.str();
  }

  std::string json_summary() const {
    std::ostringstream os;
    write_json(os << "\"summary\":", summary_);
    GC::write_json(os << ",\n \"tolerance\":", demand_.tolerance);
    return os.str();
  }

public:
  Cad_report(const Arguments& files, const Report_mode& mode, const Cad_demand& demand, const Cad_reading& reading)
      : demand_(demand), report_(mode, subject(demand)), names_files_(files.size() > 1) {
    report_.row("edges");
    report_.row("joins");
    if (demand.curvature) report_.row("bent_curves");
    report_.row("not_read");
    decide_cad_files(files, demand, reading, [this](const Decided_cad_file& file) { add(file); });
    if (demand.curvature) return; // it speaks of curves already
    if (summary_.faces == 0 && summary_.joins > 0)
      report_.speak_of("join of curves", "every join of curves");
    else if (summary_.joins > 0)
      report_.say_of_every(" and every join of curves");
  }

  // Prints the report and returns the exit code.
  int print() { return report_.print(std::cout, is_text() ? text_summary() : json_summary()); }
};

} // namespace

int verify_cad(const Arguments& files, const Report_mode& mode, const Cad_demand& demand, const Cad_reading& reading) {
  return Cad_report(files, mode, demand, reading).print();
}
