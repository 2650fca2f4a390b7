// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/roads/verify_roads.h"

#include "commands/roads/Road_claims.h"
#include "commands/roads/road_curvature.h"
#include "files/input.h"
#include "formats/opendrive/read_opendrive.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <cstddef>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace {

// How many joins of a kind there are, and the largest defect of each sort.
struct Kind_summary {
  std::size_t joins = 0, not_met = 0, undecided = 0;
  std::size_t steps = 0, kinks = 0; // of elevations; one join may have both
};

struct Largest_defect {
  GC::Enclosure size{0, 0};
  std::string place, file;
};

class Road_report {
  const Road_demand& demand_;
  Report report_;
  const bool several_;
  std::string file_;
  std::size_t files_ = 0, roads_ = 0, junctions_ = 0, geometries_[5] = {}, lanes_with_height_ = 0;
  std::map<std::string, Kind_summary> kinds_;
  std::size_t plan_[4] = {}; // gaps, G0, G1, G2
  std::size_t same_headings_ = 0, same_curvatures_ = 0, kinks_ = 0, jumps_ = 0, links_apart_ = 0;
  std::size_t notes_ = 0, faults_ = 0;
  Largest_defect worst_gap_, worst_kink_, worst_jump_, worst_lane_, worst_step_;

  static Report_subject subject(const Road_demand& demand) {
    Report_subject s{"join", "every join"};
    s.required = "G" + std::to_string(demand.order) + " within the tolerances";
    s.required_in_json = "\"required\":\"G" + std::to_string(demand.order) + '"';
    s.proof = "proved";
    if (!demand.bound) return s;
    demand_curvature(s, *demand.bound);
    s.noun = "join";
    s.every = "every join and every piece of a reference line";
    return s;
  }

  bool is_text() const { return report_.mode().format == Report_format::text; }

  void keep_worst(Largest_defect& worst, const std::optional<GC::Enclosure>& size, const Road_claim& claim) {
    if (size && worst.size.upper < size->upper) worst = {*size, claim.place, file_};
  }

  std::string prefix() const { return several_ ? file_ + ": " : ""; }
  static std::string line_text(long long line) { return line > 0 ? " (line " + std::to_string(line) + ")" : ""; }

  void add(const Road_claim& claim) {
    Kind_summary& kind = kinds_[claim.kind];
    ++kind.joins;
    kind.not_met += claim.given.claim == Claim::not_met;
    kind.undecided += claim.given.claim == Claim::undecided;
    if (report_.mode().format == Report_format::json) {
      std::string row = ",\n {";
      if (several_) row += "\"file\":" + json_text(file_) + ',';
      row += claim.json + ",\"line\":" + std::to_string(claim.line) + ",\"met\":" +
             (claim.given.claim == Claim::met       ? "true"
              : claim.given.claim == Claim::not_met ? "false"
                                                    : "null") +
             '}';
      report_.row("records", row, claim.given.claim);
    } else if (is_text())
      report_.row("records",
                  GC::printable(prefix() + claim.place + line_text(claim.line) + ": " + claim.kind + ' ' +
                                claim.verdict + (claim.fault.empty() ? "" : " - " + claim.fault)) +
                      '\n',
                  claim.given.claim);
    report_.add(file_, claim.given, false, [&] {
      Finding f;
      f.file = file_;
      f.line = claim.line;
      f.kind = claim.kind;
      f.place = claim.place;
      f.rule = claim.given.claim == Claim::undecided     ? Finding_rule::undecided
               : claim.given.claim == Claim::not_covered ? Finding_rule::not_verified
                                                         : claim.rule;
      f.message = claim.kind + ' ' + claim.verdict + (claim.fault.empty() ? "" : ", " + claim.fault);
      f.properties = claim.json;
      f.object = "road " + claim.road;
      f.spot = claim.spot;
      f.measure = claim.measure;
      return f;
    });
  }

  // Counts the reference lines of a plan join besides.
  void count(const GC::Road_plan_join& x, const Road_claim& claim) {
    if (const std::optional<int> order = x.join.order()) ++plan_[*order + 1];
    same_headings_ += x.join.same_heading;
    same_curvatures_ += x.join.same_curvature;
    kinks_ += x.join.g1 == GC::Verdict::refuted;
    jumps_ += x.join.g2 == GC::Verdict::refuted;
    keep_worst(worst_gap_, x.join.gap, claim);
    keep_worst(worst_kink_, x.join.kink, claim);
    keep_worst(worst_jump_, x.join.jump, claim);
  }
  void count(const GC::Road_link_join& x, const Road_claim&) { links_apart_ += x.join.g0 == GC::Verdict::refuted; }
  void count(const GC::Road_section_join& x, const Road_claim& claim) {
    keep_worst(worst_lane_, road_words::absolute(x.jump()), claim);
  }
  void count(const GC::Road_lane_join& x, const Road_claim& claim) {
    for (const GC::Enclosure& gap : x.gaps) keep_worst(worst_lane_, gap, claim);
    for (const GC::Enclosure& step : x.steps) keep_worst(worst_step_, step, claim);
  }
  void count(const GC::Road_profile_join& x, const Road_claim& claim) {
    if (x.kind != GC::Road_profile_kind::elevation) return;
    kinds_[claim.kind].steps += !x.within[0];
    kinds_[claim.kind].kinks += !x.within[1];
    keep_worst(worst_step_, road_words::absolute(x.jump.value), claim);
  }
  void count(const GC::Road_length_check&, const Road_claim&) {}
  void count(const GC::Road_border_join&, const Road_claim&) {}

  void add_remark(const GC::Road_remark& x) {
    static constexpr const char* kinds[] = {"note", "fault", "not covered", "undecided"};
    const char* const kind = kinds[static_cast<int>(x.kind)];
    const std::string place = remark_place(x);
    ++(x.kind == GC::Road_remark::Kind::note ? notes_ : faults_);
    const Claim claim = x.kind == GC::Road_remark::Kind::note        ? Claim::met
                        : x.kind == GC::Road_remark::Kind::undecided ? Claim::undecided
                                                                     : Claim::not_covered;
    if (is_text())
      report_.row("remarks",
                  GC::printable(prefix() + place + line_text(x.line) + ": " + kind + ", " + x.what + ": " + x.reason) +
                      '\n',
                  claim);
    else
      report_.row("remarks",
                  ",\n {" + (several_ ? "\"file\":" + json_text(file_) + ',' : "") + "\"kind\":\"" + kind +
                      "\",\"road\":" + (x.road == nullptr ? "null" : json_text(x.road->id)) +
                      ",\"line\":" + std::to_string(x.line) + ",\"what\":" + json_text(x.what) +
                      ",\"place\":" + json_text(x.place) + ",\"reason\":" + json_text(x.reason) + '}',
                  claim);
    if (x.kind == GC::Road_remark::Kind::note) return;
    report_.add(file_, {claim, nouns_.insert(x.what).first->c_str(), x.reason}, true, [&] {
      Finding f;
      f.file = file_;
      f.line = x.line;
      f.kind = x.what;
      f.place = place;
      f.rule = claim == Claim::undecided ? Finding_rule::undecided : Finding_rule::not_verified;
      f.message = x.what + ": " + x.reason;
      f.object = x.road == nullptr ? place : "road " + x.road->id;
      f.spot = x.what + ", " + x.place;
      return f;
    });
  }
  std::set<std::string> nouns_; // which claims refer to

  struct Visitor {
    Road_report& report;
    const Road_claims claims;
    void operator()(const GC::Road_remark& x) const { report.add_remark(x); }
    template <class Join> void operator()(const Join& x) const {
      const Road_claim claim = claims(x);
      report.add(claim);
      report.count(x, claim);
    }
  };

  void read(const std::string& file) {
    file_ = input_name(file);
    report_.begin_file(file_);
    const Opendrive_file opendrive = read_opendrive(file);
    if (opendrive.root != "OpenDRIVE")
      add_remark({GC::Road_remark::Kind::fault, nullptr, 0, "file", "its root element is not OpenDRIVE",
                  "root element " + opendrive.root});
    for (const auto& [attribute, value] : opendrive.odd_revision)
      add_remark({GC::Road_remark::Kind::note, nullptr, opendrive.header_line, "header",
                  GC::quoted_token(value) + " is not a number; no decision depends on the revision", attribute});
    ++files_;
    roads_ += opendrive.network.roads.size();
    junctions_ += opendrive.network.junctions.size();
    for (const GC::Road& road : opendrive.network.roads) {
      for (const GC::Road_geometry& g : road.plan) ++geometries_[static_cast<int>(g.shape)];
      for (const GC::Road_section& section : road.sections)
        for (const GC::Road_lane& lane : section.lanes) lanes_with_height_ += lane.has_height;
    }
    if (demand_.bound)
      for (const GC::Road& road : opendrive.network.roads)
        for (const GC::Road_geometry& piece : road.plan) add(decide_curvature(road, piece, *demand_.bound));
    const bool shows_all = report_.mode().format == Report_format::json && !report_.mode().summary;
    GC::road_joins(opendrive.network, demand_.tolerance,
                   Visitor{*this, Road_claims(demand_, File_digits(opendrive.digits), shows_all)}, demand_.borders);
  }

  const Kind_summary& kind(const char* name) { return kinds_[name]; }

  std::string worst_text(const char* what, const Largest_defect& worst, const char* unit) const {
    if (worst.place.empty()) return "";
    return std::string("largest ") + what + ": " + road_words::size(worst.size, unit) + ", " +
           (several_ ? worst.file + ": " : "") + worst.place + '\n';
  }

  std::string text_summary() {
    std::ostringstream os;
    if (several_) os << counted(files_, "file") << ", ";
    os << counted(roads_, "road") << ", " << counted(junctions_, "junction") << "; geometries: " << geometries_[0]
       << " line, " << geometries_[1] << " arc, " << geometries_[2] << " spiral, " << geometries_[3] << " poly3, "
       << geometries_[4] << " paramPoly3\n";
    os << counted(kind("plan").joins, "plan join") << ": " << plan_[3] << " G2, " << plan_[2] << " G1, " << plan_[1]
       << " G0, " << counted(plan_[0], "gap") << "; within " << demand_.gap << " m, " << demand_.kink << " rad, "
       << demand_.curvature << "/m\n";
    std::string separator;
    for (const auto& [name, words] :
         {std::pair("length", "wrong"), std::pair("elevation", ""), std::pair("superelevation", "with a step"),
          std::pair("laneOffset", "with a step"), std::pair("width", "with a step"), std::pair("border", "with a step"),
          std::pair("section lane", "apart"), std::pair("section lane back", "apart"), std::pair("road lane", "apart"),
          std::pair("road lane back", "apart"), std::pair("junction lane", "apart"),
          std::pair("lane border", "not smooth enough"), std::pair("bend", "bent too much")}) {
      const Kind_summary& k = kind(name);
      if (k.joins == 0) continue;
      os << separator << k.joins << ' ' << name;
      if (k.steps + k.kinks > 0)
        os << " (" << k.steps << " with a step, " << k.kinks << " with a kink)";
      else if (k.not_met > 0)
        os << " (" << k.not_met << ' ' << words << ')';
      separator = ", ";
    }
    if (!separator.empty()) os << '\n';
    if (kind("link").joins > 0)
      os << counted(kind("link").joins, "link") << "; the reference lines of " << links_apart_
         << " do not meet, which they need not: lanes do\n";
    os << worst_text("gap", worst_gap_, " m") << worst_text("kink", worst_kink_, " rad")
       << worst_text("curvature jump", worst_jump_, "/m") << worst_text("gap of lanes", worst_lane_, " m")
       << worst_text("step", worst_step_, " m");
    if (lanes_with_height_ > 0)
      os << counted(lanes_with_height_, "lane") << " above the road by heights of their own, which are not compared\n";
    if (notes_ > 0) os << counted(notes_, "note") << '\n';
    return os.str();
  }

  static std::string json_worst(const char* name, const Largest_defect& worst) {
    if (worst.place.empty()) return "";
    return std::string(",\"") + name + "\":{\"size\":" + road_words::json(worst.size) +
           ",\"file\":" + json_text(worst.file) + ",\"place\":" + json_text(worst.place) + '}';
  }

  std::string json_summary() {
    std::ostringstream os;
    os << "\"summary\":{\"files\":" << files_ << ",\"roads\":" << roads_ << ",\"junctions\":" << junctions_
       << ",\"geometries\":{\"line\":" << geometries_[0] << ",\"arc\":" << geometries_[1]
       << ",\"spiral\":" << geometries_[2] << ",\"poly3\":" << geometries_[3] << ",\"paramPoly3\":" << geometries_[4]
       << "},\"joins\":" << kind("plan").joins << ",\"gaps\":" << plan_[0] << ",\"kinks\":" << kinks_
       << ",\"curvature_jumps\":" << jumps_ << ",\"same_heading\":" << same_headings_
       << ",\"same_curvature\":" << same_curvatures_ << ",\"links\":" << kind("link").joins
       << ",\"links_apart\":" << links_apart_ << ",\"kinds\":{";
    std::size_t undecided = 0;
    const char* separator = "";
    for (const auto& [name, k] : kinds_) {
      undecided += k.undecided;
      if (k.joins == 0) continue;
      os << separator << json_text(name) << ":{\"joins\":" << k.joins << ",\"not_met\":" << k.not_met;
      if (name == "elevation") os << ",\"steps\":" << k.steps << ",\"kinks\":" << k.kinks;
      os << '}';
      separator = ",";
    }
    os << "},\"undecided\":" << undecided << ",\"notes\":" << notes_ << ",\"faults\":" << faults_
       << ",\"lanes_with_height\":" << lanes_with_height_ << ",\"worst\":{\"gap_tolerance\":" << json_text(demand_.gap)
       << json_worst("gap", worst_gap_) << json_worst("kink", worst_kink_) << json_worst("curvature_jump", worst_jump_)
       << json_worst("lane_gap", worst_lane_) << json_worst("step", worst_step_)
       << "}},\n \"tolerances\":{\"gap\":" << json_text(demand_.gap) << ",\"kink\":" << json_text(demand_.kink)
       << ",\"curvature\":" << json_text(demand_.curvature) << '}';
    return os.str();
  }

public:
  Road_report(const Arguments& files, const Report_mode& mode, const Road_demand& demand)
      : demand_(demand), report_(mode, subject(demand)), several_(files.size() > 1) {
    report_.row("records");
    report_.row("remarks");
    for (const std::string& file : files) read(file);
  }

  // Prints the report and returns the exit code.
  int print() { return report_.print(std::cout, is_text() ? text_summary() : json_summary()); }
};

} // namespace

int verify_roads(const Arguments& files, const Report_mode& mode, const Road_demand& demand) {
  return Road_report(files, mode, demand).print();
}
