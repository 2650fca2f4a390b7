// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/verify_cad.h"

#include "commands/cad/Cad_words.h"
#include "commands/cad/cad_json.h"
#include "commands/cad/decide_cad.h"
#include "commands/chains/join_report.h"
#include "reports/Finding_writer.h"

#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

bool has_verdict(const Cad_edge& edge) { return edge.kind == Cad_edge_kind::inner || edge.kind == Cad_edge_kind::seam; }

class Cad_report {
  const Report_mode mode_;
  const Cad_demand& demand_;
  std::vector<Decided_cad_file> files_;
  Cad_summary summary_;

  Old_conclusion conclusion() const { return {summary_.decided(), summary_.failing, summary_.unverified(demand_)}; }

  std::string required() const { return "G" + std::to_string(*demand_.order) + " within the tolerance"; }

  bool is_printed(const Cad_edge& edge, const Cad_verdict& verdict) const {
    return !mode_.summary || (has_verdict(edge) && verdict.fails(demand_));
  }

  void print_text() const {
    for (const Decided_cad_file& file : files_) {
      if (files_.size() > 1) std::cout << file.file << ":\n";
      for (std::size_t i = 0; i < file.verdicts.size(); ++i) {
        const Cad_edge& edge = file.model.edges[i];
        const Cad_verdict& verdict = file.verdicts[i];
        if (!is_printed(edge, verdict)) continue;
        std::cout << cad_place(i, edge, file.model) << ' ' << cad_kind(edge);
        if (has_verdict(edge)) std::cout << ": " << cad_order(verdict) << "; " << cad_numbers(verdict, demand_);
        std::cout << '\n';
      }
      for (const std::string& lost : file.model.lost) std::cout << "not read: " << lost << '\n';
    }
    print_summary();
  }

  void print_summary() const {
    const Cad_summary& s = summary_;
    std::cout << counted(s.faces, "face") << "; edges: " << s.inner << " inner, " << counted(s.seams, "seam") << ", "
              << s.boundary << " boundary, " << s.degenerate << " degenerate, " << s.non_manifold << " non-manifold\n";
    if (s.sewn > 0) std::cout << sewn_words(s.sewn) << '\n';
    if (s.decided() == 0)
      std::cout << "no edge of two sides, nothing was decided"
                << (s.boundary > 0 ? "; --sew DISTANCE joins boundary edges that coincide\n" : "\n");
    if (s.decided() > 0)
      std::cout << "within " << demand_.tolerance << " (lengths in mm): " << s.g2 << " G2, " << s.g1 << " G1, " << s.g0
                << " G0, " << counted(s.gaps, "gap") << ", " << s.undecided << " undecided; "
                << counted(s.corners, "corner") << ", " << counted(s.fading_corners, "fading corner") << ", "
                << counted(s.kinks, "kink") << '\n';
    if (s.projected > 0)
      std::cout << counted(s.projected, "edge") << " with curves in parameter planes that are not in the file, but"
                << " projections of those in space\n";
    if (s.not_compared > 0)
      std::cout << counted(s.not_compared, "edge") << " that cannot be compared, hence undecided\n";
    if (demand_.order && s.decided() > 0) {
      if (s.failing == 0)
        std::cout << "every edge of two sides is " << required() << " or a corner, proved\n";
      else
        std::cout << s.failing << " of them not " << required() << '\n';
    }
    if (!demand_.order && s.open > 0) std::cout << "undecided within the tolerance: " << s.open << '\n';
    if (!mode_.allow_undecided && summary_.unverified(demand_) > 0)
      std::cout << "not met, because not all was verified\n";
  }

  void write_summary(std::ostream& os) const {
    write_json(os << "\"summary\":", summary_);
    GC::write_json(os << ",\n \"tolerance\":", demand_.tolerance);
    if (demand_.order) os << ",\n \"required\":\"G" << *demand_.order << "\",\"met\":" << conclusion().json_met(mode_);
  }

  void print_json() const {
    std::cout << "{\"edges\":[";
    const char* separator = "\n ";
    for (const Decided_cad_file& file : files_)
      for (std::size_t i = 0; i < file.verdicts.size(); ++i) {
        if (!is_printed(file.model.edges[i], file.verdicts[i])) continue;
        GC::write_json(std::cout << separator << "{\"file\":", file.file);
        write_members(std::cout << ',', i, file.model.edges[i], file.verdicts[i]);
        std::cout << '}';
        separator = ",\n ";
      }
    std::cout << "],\n \"not_read\":[";
    separator = "";
    for (const Decided_cad_file& file : files_)
      for (const std::string& lost : file.model.lost) {
        GC::write_json(std::cout << separator, file.file + ": " + lost);
        separator = ",";
      }
    std::cout << "],\n ";
    write_summary(std::cout);
    std::cout << "}\n";
  }

  static Finding_rule rule(const Cad_verdict& verdict) {
    switch (verdict.shape) {
    case Cad_shape::gap: return Finding_rule::gap;
    case Cad_shape::corner:
    case Cad_shape::fading_corner: return Finding_rule::corner;
    case Cad_shape::kink: return Finding_rule::kink;
    case Cad_shape::smooth: return Finding_rule::curvature;
    case Cad_shape::undecided: break;
    }
    return Finding_rule::undecided;
  }

  // Adds what a tool should show of an edge.
  void add(Finding_writer& writer, const Decided_cad_file& file, std::size_t number) const {
    const Cad_edge& edge = file.model.edges[number];
    const Cad_verdict& verdict = file.verdicts[number];
    const bool is_compared = has_verdict(edge), fails = is_compared && verdict.fails(demand_),
               is_open = is_compared && verdict.is_undecided(demand_),
               is_noted = is_compared && !demand_.order &&
                          (verdict.shape == Cad_shape::gap || verdict.shape == Cad_shape::kink ||
                           verdict.shape == Cad_shape::fading_corner),
               is_unverified = edge.kind == Cad_edge_kind::non_manifold || (is_compared && !verdict.enclosure);
    if (!fails && !is_open && !is_noted && !is_unverified) {
      if (is_compared) writer.add_passed(file.file, 1, "edges");
      return;
    }
    Finding f;
    f.file = file.file;
    f.kind = "edge";
    f.place = cad_place(number, edge, file.model);
    f.rule = is_unverified ? Finding_rule::not_verified : is_open ? Finding_rule::undecided : rule(verdict);
    f.level = fails || (!mode_.allow_undecided && (is_open || is_unverified)) ? Finding_level::error
              : is_open || is_unverified                                      ? Finding_level::warning
                                                                              : Finding_level::note;
    f.message = (fails ? "not " + required() + ", " : "") + cad_kind(edge) +
                (is_compared ? ": " + cad_order(verdict) + "; " + cad_numbers(verdict, demand_) : "");
    std::ostringstream properties;
    write_members(properties, number, edge, verdict);
    f.properties = properties.str();
    writer.add(f);
  }

  void print_findings() const {
    const std::unique_ptr<Finding_writer> writer = finding_writer(mode_.format);
    for (const Decided_cad_file& file : files_) {
      writer->add_passed(file.file, 0, "edges");
      for (std::size_t i = 0; i < file.verdicts.size(); ++i) add(*writer, file, i);
      for (const std::string& lost : file.model.lost) {
        Finding f;
        f.file = file.file;
        f.kind = "element";
        f.place = lost.substr(0, lost.find(':'));
        f.rule = Finding_rule::not_verified;
        f.level = !mode_.allow_undecided ? Finding_level::error : Finding_level::warning;
        f.message = "not read: " + lost;
        writer->add(f);
      }
    }
    std::ostringstream summary;
    write_summary(summary);
    writer->print(std::cout, summary.str());
  }

public:
  Cad_report(const Arguments& files, const Report_mode& mode, const Cad_demand& demand, const Cad_reading& reading)
      : mode_(mode), demand_(demand) {
    for (const std::string& file : files) {
      files_.push_back(decide_cad(file, demand, reading));
      summary_.add(files_.back(), demand);
      for (Cad_edge& edge : files_.back().model.edges) edge.sides.reset(); // to save memory
    }
  }

  // Prints the report and returns the exit code.
  int print() const {
    if (mode_.has_findings())
      print_findings();
    else if (mode_.format == Report_format::json)
      print_json();
    else
      print_text();
    return conclusion().exit_code(mode_, "edge of two sides");
  }
};

} // namespace

int verify_cad(const Arguments& files, const Report_mode& mode, const Cad_demand& demand,
               std::optional<double> sewing) {
  return Cad_report(files, mode, demand, {Cad_drawing::none, sewing}).print();
}
