// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CLAIMS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CLAIMS_H

#include "commands/roads/alignment_words.h"
#include "commands/roads/file_digits.h"
#include "commands/roads/verify_roads.h"
#include "reports/finding.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// All that is said of one join of a road network, in text, JSON and findings: one class for all
// kinds, so that a report and a page say the same.
struct Road_claim {
  std::string kind;    // "plan", "length", "elevation", ...
  std::string road;    // its id
  std::string place;   // e.g. `road 12, s = 90`
  std::string spot;    // e.g. "plan, s = 90"
  std::string verdict; // in words
  std::string json;    // members of an object
  long long line = 0;
  Given given{Claim::met, "join"};
  Finding_rule rule = Finding_rule::gap;
  std::string fault; // what is not as it must be, in words; empty where all is
  std::optional<Measure> measure = {};
  // how large its defects are, in guaranteed bounds
  std::optional<GC::Enclosure> gap = {}, kink = {}, jump = {};
};

namespace road_words {

// The shortest decimal of the floating-point number that is nearest to a rational one; null beyond
// all of them.
inline std::string decimal(const GC::Road_number& x) {
  const GC::Enclosure e = GC::enclosure(x);
  if (!std::isfinite(e.lower) || !std::isfinite(e.upper)) return "null";
  const bool is_lower = GC::Road_number(x - GC::Road_number(e.lower)) < GC::Road_number(GC::Road_number(e.upper) - x);
  std::ostringstream os;
  GC::write_number(os, is_lower ? e.lower : e.upper);
  return os.str();
}

inline GC::Enclosure absolute(const GC::Road_number& x) { return GC::enclosure(GC::Road_number(CGAL::abs(x))); }

inline const char* end(GC::Road_end end) { return end == GC::Road_end::start ? "start" : "end"; }
inline std::string contact(const GC::Road_contact& c) {
  return "road " + c.road->id + ", " + (c.at ? "s = " + decimal(*c.at) : std::string(end(c.end)));
}

} // namespace road_words

// Makes claims of what road_joins() finds.
class Road_claims {
  const Road_demand& demand_;
  const File_digits digits_;
  const bool with_all_digits_; // what they explain is also told of joins where nothing is wrong

  // The class of a claim that must hold.
  static Given given(GC::Verdict verdict, const char* reason = "the tolerance lies inside of the bounds") {
    switch (verdict) {
    case GC::Verdict::proved: break;
    case GC::Verdict::refuted: return {Claim::not_met, "join"};
    case GC::Verdict::undecided: return {Claim::undecided, "join", reason};
    }
    return {Claim::met, "join"};
  }
  static GC::Verdict verdict(bool holds) { return holds ? GC::Verdict::proved : GC::Verdict::refuted; }

  static void place(Road_claim& claim, const GC::Road& road, const GC::Road_number& s, const std::string& more = {}) {
    const std::string at = "s = " + road_words::decimal(s) + more;
    claim.road = road.id;
    claim.place = "road " + road.id + ", " + at;
    claim.spot = claim.kind + ", " + at;
    claim.json = "\"kind\":\"" + claim.kind + "\",\"road\":" + json_text(road.id) + ",\"s\":" + road_words::decimal(s);
  }
  static void place(Road_claim& claim, const GC::Road_contact& from, const GC::Road_contact& to,
                    const std::string& lane = {}, const std::string& to_lane = {}) {
    claim.road = from.road->id;
    claim.place = road_words::contact(from) + lane + " - " + road_words::contact(to) + to_lane;
    claim.spot = claim.kind + ", " + claim.place;
    claim.json = "\"kind\":\"" + claim.kind + "\",\"road\":" + json_text(from.road->id) + ",\"end\":\"" +
                 road_words::end(from.end) + '"' + (from.at ? ",\"at\":" + road_words::decimal(*from.at) : "") +
                 ",\"to_road\":" + json_text(to.road->id) + ",\"to_end\":\"" + road_words::end(to.end) + '"' +
                 (to.at ? ",\"to_at\":" + road_words::decimal(*to.at) : "");
  }

  static const char* order_name(const GC::Alignment_join& join) {
    static constexpr const char* names[] = {"gap", "G0", "G1", "G2"};
    const std::optional<int> order = join.order();
    return order ? names[*order + 1] : "undecided";
  }

  static void add_join(Road_claim& claim, const GC::Alignment_join& join) {
    claim.json += road_words::members(join) + ",\"order\":\"" + order_name(join) + '"';
    claim.verdict = std::string(order_name(join)) + ", gap " + road_words::size(join.gap, " m") + ", kink " +
                    (join.same_heading ? "none" : road_words::size(join.kink, " rad")) + ", curvature " +
                    (!join.jump            ? "not defined"
                     : join.same_curvature ? "equal"
                                           : "jump " + road_words::size(*join.jump, "/m"));
    claim.gap = join.gap;
    claim.kink = join.kink;
    claim.jump = join.jump;
  }

  // Asks that a join has the order that is demanded.
  void ask_order(Road_claim& claim, const GC::Alignment_join& join) const {
    const GC::Verdict orders[] = {join.g0, join.g0 && join.g1, join.g0 && join.g1 && join.g2};
    claim.given = given(orders[demand_.order],
                        join.jump ? "the tolerance lies inside of the bounds" : "a curvature is not defined");
    if (claim.given.claim != Claim::not_met) return;
    if (join.g0 == GC::Verdict::refuted) {
      claim.rule = Finding_rule::gap;
      claim.measure = Measure{"gap", join.gap};
    } else if (join.g1 == GC::Verdict::refuted) {
      claim.rule = Finding_rule::kink;
      claim.measure = Measure{"angle_degrees", GC::in_degrees(join.kink)};
    } else {
      claim.rule = Finding_rule::curvature;
      claim.measure = Measure{"curvature_difference", *join.jump};
    }
    claim.fault = "not G" + std::to_string(demand_.order);
  }

  // Decides whether a gap and a kink are at most these bounds, which are the tolerances where the
  // enclosures that are known leave it open.
  static std::pair<bool, bool> within(const GC::Road_plan_join& x, const File_digits::Bounds& bounds) {
    if (!std::isfinite(bounds.gap) || !std::isfinite(bounds.kink)) return {false, false};
    const auto is_open = [](const GC::Enclosure& e, double bound) { return e.lower <= bound && bound < e.upper; };
    bool gap = x.join.gap.upper <= bounds.gap, kink = x.join.kink.upper <= bounds.kink;
    if (!is_open(x.join.gap, bounds.gap) && !is_open(x.join.kink, bounds.kink)) return {gap, kink};
    const GC::Alignment_end end = GC::alignment_end(x.before, GC::Road_end::end),
                            start = GC::alignment_end(x.after, GC::Road_end::start);
    if (is_open(x.join.gap, bounds.gap))
      gap = GC::point_distance(end.point, start.point, GC::Road_number(bounds.gap)).within == GC::Verdict::proved;
    if (is_open(x.join.kink, bounds.kink))
      kink = GC::alignment_join(end, start, {0, GC::Road_number(bounds.kink), 0}).g1 == GC::Verdict::proved;
    return {gap, kink};
  }

  // Tells if a gap and a kink behind a line, an arc or a spiral may come from the digits of the
  // file.
  void explain(Road_claim& claim, const GC::Road_plan_join& x) const {
    if (GC::is_polynomial(x.before) || digits_.digits() == 0) return;
    const bool has_gap = x.join.g0 == GC::Verdict::refuted, has_kink = x.join.g1 == GC::Verdict::refuted;
    if (!with_all_digits_ && !has_gap && !has_kink) return;
    const File_digits::Bounds bounds = digits_.bounds(x.before, x.after);
    const auto [gap, kink] = within(x, bounds);
    claim.json +=
        ",\"explained_by_digits\":{\"gap\":" + road_words::flag(gap) + ",\"kink\":" + road_words::flag(kink) + '}';
    if ((has_gap || has_kink) && (gap || !has_gap) && (kink || !has_kink))
      claim.verdict += "; " + std::to_string(digits_.digits()) + " digits explain it";
  }

public:
  explicit Road_claims(const Road_demand& demand, const File_digits& digits = File_digits(),
                       bool with_all_digits = false)
      : demand_(demand), digits_(digits), with_all_digits_(with_all_digits) {}

  const GC::Alignment_tolerance& tolerance() const { return demand_.tolerance; }

  Road_claim operator()(const GC::Road_plan_join& x) const {
    Road_claim claim;
    claim.kind = "plan";
    place(claim, x.road, x.after.s);
    claim.json += ",\"s_error\":" + road_words::decimal(x.s_error);
    claim.line = x.after.line;
    add_join(claim, x.join);
    if (x.other_reading) {
      Road_claim other;
      add_join(other, *x.other_reading);
      claim.json += ",\"other_reading\":{" + other.json.substr(1) + '}';
      claim.verdict += "; if pRange were arcLength: " + other.verdict;
    }
    explain(claim, x);
    ask_order(claim, x.join);
    return claim;
  }

  Road_claim operator()(const GC::Road_border_join& x) const {
    Road_claim claim;
    claim.kind = "lane border";
    const std::string lane = ", lane " + std::to_string(x.lane.id);
    if (x.from.road == x.to.road && x.from.at)
      place(claim, *x.from.road, *x.from.at,
            lane + (x.lane.id == x.to_lane.id ? "" : " to " + std::to_string(x.to_lane.id)));
    else
      place(claim, x.from, x.to, lane, ", lane " + std::to_string(x.to_lane.id));
    const char* const side = x.is_left ? "left" : "right";
    claim.place += std::string(", ") + side;
    claim.spot += std::string(", ") + side;
    claim.line = x.line;
    claim.json += ",\"lane\":" + std::to_string(x.lane.id) + ",\"to\":" + std::to_string(x.to_lane.id) +
                  ",\"side\":\"" + side + '"';
    add_join(claim, x.join);
    ask_order(claim, x.join);
    return claim;
  }

  Road_claim operator()(const GC::Road_length_check& x) const {
    Road_claim claim;
    claim.kind = "length";
    place(claim, x.road, x.geometry.s);
    claim.line = x.geometry.line;
    std::vector<std::string> notes;
    if (x.geometry.range == GC::Road_parameter_range::missing) notes.push_back(json_text("pRange missing"));
    if (x.is_near_stop) notes.push_back(json_text("near stop"));
    claim.json += ",\"error\":" + road_words::json(x.error) + ",\"within\":" + road_words::flag(x.within) +
                  ",\"note\":" + json_array(notes);
    claim.verdict = "arc length differs by " + road_words::size(x.error, " m") + " from the length that is declared";
    if (x.other_reading) {
      claim.json += ",\"other_reading\":{\"error\":" + road_words::json(x.other_reading->first) +
                    ",\"within\":" + road_words::flag(x.other_reading->second) + '}';
      claim.verdict += "; by " + road_words::size(x.other_reading->first, " m") + " if pRange were arcLength";
    }
    if (x.is_near_stop) claim.verdict += "; the speed at an end is nearly 0, so that its direction may be noise";
    claim.given = given(x.within);
    claim.rule = Finding_rule::length;
    claim.measure = Measure{"length_difference", x.error};
    if (x.within == GC::Verdict::refuted) claim.fault = "a wrong length";
    claim.gap = x.error;
    return claim;
  }

  Road_claim operator()(const GC::Road_profile_join& x) const {
    static constexpr const char* names[] = {"elevation", "superelevation", "laneOffset", "width", "border"};
    Road_claim claim;
    claim.kind = names[static_cast<int>(x.kind)];
    place(claim, x.road, x.s, x.lane == nullptr ? "" : ", lane " + std::to_string(x.lane->id));
    if (x.lane != nullptr) claim.json += ",\"lane\":" + std::to_string(x.lane->id);
    claim.line = x.line;
    const auto list = [](const auto& flags) {
      std::vector<std::string> texts;
      for (const bool f : flags) texts.push_back(road_words::flag(f));
      return json_array(texts);
    };
    claim.json += ",\"jump\":" + road_words::decimal(x.jump.value) +
                  ",\"slope_jump\":" + road_words::decimal(x.jump.slope) +
                  ",\"second_jump\":" + road_words::decimal(x.jump.second) + ",\"equal\":" + list(x.equal) +
                  ",\"within\":" + list(x.within) + (x.is_compensated ? ",\"at_section\":true" : "");
    const bool is_angle = x.kind == GC::Road_profile_kind::superelevation;
    const GC::Enclosure step = road_words::absolute(x.jump.value), slope = road_words::absolute(x.jump.slope);
    claim.verdict = (x.equal[0] ? std::string("no step") : "step " + road_words::size(step, is_angle ? " rad" : " m")) +
                    (x.equal[1] ? ", no kink" : ", slope jump " + road_words::size(slope, is_angle ? "/m" : "")) +
                    (x.is_compensated ? ", where a lane section starts" : "");
    claim.gap = step;
    // linear changes of widths and of the superelevation are meant
    const bool asks_slope = x.kind == GC::Road_profile_kind::elevation && demand_.order > 0;
    const bool is_smooth = !asks_slope || x.within[1];
    if (x.kind == GC::Road_profile_kind::elevation) claim.kink = slope;
    claim.given = given(verdict(x.is_compensated || (x.within[0] && is_smooth)));
    if (claim.given.claim == Claim::met) return claim;
    claim.rule = x.within[0] ? Finding_rule::kink : Finding_rule::gap;
    claim.fault = x.within[0] ? "a kink" : "a step";
    claim.measure = x.within[0] ? Measure{"slope_jump", slope} : Measure{"step", step};
    return claim;
  }

  Road_claim operator()(const GC::Road_section_join& x) const {
    Road_claim claim;
    claim.kind = x.is_named_back ? "section lane back" : "section lane";
    place(claim, x.road, x.s, ", lane " + std::to_string(x.lane.id) + " to " + std::to_string(x.to.id));
    claim.line = x.to.line;
    const GC::Road_number jump = x.jump();
    claim.json += ",\"lane\":" + std::to_string(x.lane.id) + ",\"to\":" + std::to_string(x.to.id) +
                  ",\"borders\":" + std::to_string((x.left ? 1 : 0) + (x.right ? 1 : 0)) +
                  ",\"jump\":" + (x.is_known ? road_words::decimal(jump) : "null") +
                  ",\"equal\":" + (x.is_known ? road_words::flag(x.equal) : "null") +
                  ",\"within\":" + (x.is_known ? road_words::flag(x.within) : "null");
    if (!x.is_known) {
      claim.verdict = "not decided, a lane inside of it is missing";
      claim.given = {Claim::not_covered, "section lane", "a lane inside of it is missing"};
      return claim;
    }
    claim.gap = road_words::absolute(jump);
    claim.verdict = x.equal ? "borders equal" : "borders apart by " + road_words::size(*claim.gap, " m");
    claim.given = given(verdict(x.within));
    claim.measure = Measure{"gap", *claim.gap};
    if (!x.within) claim.fault = "lanes apart";
    return claim;
  }

  Road_claim operator()(const GC::Road_link_join& x) const {
    Road_claim claim;
    claim.kind = "link";
    place(claim, x.from, x.to);
    claim.line = x.line;
    add_join(claim, x.join);
    if (!x.has_lanes && x.join.g0 == GC::Verdict::refuted)
      claim.given = {Claim::not_covered, "link", "no lanes are linked, and the reference lines do not meet"};
    claim.json += ",\"lanes\":" + road_words::flag(x.has_lanes) + ",\"step\":" + road_words::decimal(x.step) +
                  ",\"grade_jump\":" + road_words::decimal(x.grade_jump) +
                  ",\"returned\":" + road_words::flag(x.is_returned);
    claim.verdict = "reference lines " + claim.verdict;
    if (!CGAL::is_zero(x.step)) claim.verdict += ", step " + road_words::size(road_words::absolute(x.step), " m");
    if (!x.is_returned) claim.verdict += ", not returned";
    if (claim.given.claim == Claim::not_covered) claim.verdict += ", no lanes are linked";
    return claim;
  }

  Road_claim operator()(const GC::Road_lane_join& x) const {
    Road_claim claim;
    claim.kind = x.is_in_junction ? "junction lane" : x.is_named_back ? "road lane back" : "road lane";
    place(claim, x.from, x.to, ", lane " + std::to_string(x.lane.id), ", lane " + std::to_string(x.to_lane.id));
    claim.line = x.line;
    const auto list = [](const std::vector<GC::Enclosure>& sizes) {
      std::vector<std::string> texts;
      for (const GC::Enclosure& e : sizes) texts.push_back(road_words::json(e));
      return json_array(texts);
    };
    claim.json += ",\"lane\":" + std::to_string(x.lane.id) + ",\"to\":" + std::to_string(x.to_lane.id) +
                  ",\"gaps\":" + list(x.gaps) + ",\"steps\":" + list(x.steps) +
                  ",\"within\":" + road_words::flag(x.within) +
                  ",\"within_z\":" + (x.within_height ? road_words::flag(*x.within_height) : "null") +
                  (x.has_overlap ? ",\"overlap\":true" : "");
    const auto largest = [](const std::vector<GC::Enclosure>& sizes) {
      GC::Enclosure most{0, 0};
      for (const GC::Enclosure& e : sizes) most = {(std::max)(most.lower, e.lower), (std::max)(most.upper, e.upper)};
      return most;
    };
    const GC::Enclosure gap = largest(x.gaps), step = largest(x.steps);
    claim.gap = gap;
    claim.verdict = "borders apart by " + road_words::size(gap, " m") +
                    (!x.within_height  ? ", heights not decided"
                     : step.upper == 0 ? ""
                                       : ", in height by " + road_words::size(step, " m"));
    if (x.has_overlap) claim.verdict += ", lanes overlap there";
    claim.given = given(x.within_height ? x.within && *x.within_height : x.within);
    if (claim.given.claim != Claim::not_met) return claim;
    claim.fault = x.within == GC::Verdict::refuted ? "lanes apart" : "a step";
    claim.measure = x.within == GC::Verdict::refuted ? Measure{"gap", gap} : Measure{"step", step};
    if (x.within != GC::Verdict::refuted) claim.gap = step;
    return claim;
  }
};

// The place of a remark, e.g. `road 12, successor`.
inline std::string remark_place(const GC::Road_remark& x) {
  std::string text = x.road == nullptr ? "" : "road " + x.road->id;
  if (!x.place.empty()) text += (text.empty() ? "" : ", ") + x.place;
  return text;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ROAD_CLAIMS_H
