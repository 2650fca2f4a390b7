// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/roads/rails.h"

#include "commands/roads/alignment_words.h"
#include "commands/roads/road_curvature.h"
#include "files/input.h"
#include "formats/ifc/read_ifc.h"
#include "formats/landxml/read_landxml.h"
#include "formats/rails/Rail_check.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Q;

// Position, direction and curvature, as a file claims them.
struct Claimed {
  std::size_t claims = 0, refuted = 0, undecided = 0;
};

struct Worst_claim {
  GC::Enclosure size{0, 0};
  std::string place;
};

const char* const words_of_claims[] = {"position", "direction", "curvature"};

// The decision about one check.
struct Decided {
  std::array<GC::Verdict, 3> verdicts = {GC::Verdict::undecided, GC::Verdict::undecided, GC::Verdict::undecided};
  std::optional<GC::Alignment_join> join = {};
  std::optional<GC::Decided_distance> difference = {};
  std::string failure; // why nothing could be decided
};

class Rail_report {
  const Rail_demand& demand_;
  Report report_;
  const bool several_;
  std::string file_;
  std::size_t files_ = 0, curves_ = 0, bent_ = 0; // pieces that are bent too much
  std::map<std::string, std::size_t> kinds_;
  std::map<std::string, std::array<Claimed, 3>> claims_; // of the kinds
  std::set<std::string> values_;                         // the kinds that are numbers, and no joins
  std::array<Worst_claim, 3> worst_;

  static Report_subject subject(const Rail_demand& demand) {
    Report_subject s{"join", "every join"};
    s.required = demand.order ? "what is claimed up to G" + std::to_string(*demand.order) : "what is claimed";
    s.required_in_json =
        "\"required\":" + (demand.order ? "\"G" + std::to_string(*demand.order) + '"' : std::string("null"));
    s.proof = "proved";
    if (demand.bound) {
      demand_curvature(s, *demand.bound);
      s.noun = "join";
      s.every = "every join and every piece of the plan";
    }
    return s;
  }
  bool is_text() const { return report_.mode().format == Report_format::text; }

  // Bounds of a number of which others are known that differ by much less than this.
  static GC::Enclosure widened(const GC::Enclosure& x) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto more = [](double y) { return std::fabs(y) * 1e-15 + 1e-30; };
    return {std::nextafter(x.lower - more(x.lower), -infinity), std::nextafter(x.upper + more(x.upper), infinity)};
  }

  // The tolerance of angles is that of the file: atan2(precision, length).
  static GC::Verdict within_precision(const GC::Alignment_join& join, const Q& precision, const Q& length) {
    const GC::Enclosure bound = GC::Heading(Q(0), length, precision).enclosure();
    return GC::at_most(join.kink, GC::Bound(bound));
  }

  Decided decide(const Rail_check& check, const Q& precision) const {
    Decided d;
    try {
      const Q gap = demand_.gap.value_or(precision);
      if (check.difference) {
        const Q x = check.difference->value, size = x < 0 ? Q(-x) : x,
                tolerance = check.difference->is_angle ? demand_.kink.value_or(precision) : gap;
        d.difference = {GC::enclosure(size), size == 0, size <= tolerance ? GC::Verdict::proved : GC::Verdict::refuted};
        if (check.difference->enclosed || check.rounded) {
          const GC::Enclosure e = check.difference->enclosed.value_or(GC::enclosure(x));
          const GC::Enclosure wide = check.rounded ? widened(e) : e;
          d.difference->distance = {(std::max)({0., wide.lower, -wide.upper}), (std::max)(wide.upper, -wide.lower)};
          d.difference->is_zero = false;
          d.difference->within = GC::at_most(d.difference->distance, GC::Bound(GC::enclosure(tolerance)));
        }
        d.verdicts[0] = d.difference->within;
        return d;
      }
      if (!check.ends) return d;
      const GC::Alignment_tolerance tolerance{gap, demand_.kink.value_or(precision), demand_.curvature};
      d.join = GC::alignment_join(check.ends->left, check.ends->right, tolerance);
      if (check.rounded) {
        const auto widen = [](GC::Enclosure& x, GC::Verdict& verdict, const Q& bound) {
          x = widened(x);
          x.lower = (std::max)(x.lower, 0.);
          verdict = GC::at_most(x, GC::Bound(GC::enclosure(bound)));
        };
        const bool exact_points = check.ends->left.point.rational() && check.ends->right.point.rational();
        if (check.rounded_points) d.join->same_point = false;
        if (!exact_points || check.rounded_points) widen(d.join->gap, d.join->g0, tolerance.gap);
        if (!d.join->same_heading) widen(d.join->kink, d.join->g1, tolerance.kink); // whatever the unit is
        if (check.rounded_curvature && !d.join->same_curvature) widen(*d.join->jump, d.join->g2, tolerance.curvature);
      }
      if (!demand_.kink && check.length) d.join->g1 = within_precision(*d.join, precision, *check.length);
      d.verdicts = {d.join->g0, d.join->g1, d.join->g2};
    } catch (const GC::Error& e) {
      if (e.code() == GC::Error_code::not_finite)
        d.failure = "a number beyond those of floating-point numbers";
      else if (e.code() == GC::Error_code::parameter_outside_domain || e.code() == GC::Error_code::work_limit)
        d.failure = e.what();
      else
        throw;
    }
    return d;
  }

  // The order that must hold. Without a claim, in a design, it is what is asked, at least one
  // position.
  int required(const Rail_check& check) const {
    if (check.claim.empty()) return check.difference ? 0 : demand_.order.value_or((std::max)(0, check.claimed));
    return (std::min)(check.claimed, demand_.order.value_or(2));
  }

  std::string words(const Rail_check& check, const Decided& d) const {
    if (check.difference) return check.difference->quantity + " off by " + road_words::size(d.difference->distance, "");
    std::string text = "gap " + road_words::size(d.join->gap, "") + ", kink " + road_words::size(d.join->kink, " rad");
    text += d.join->jump ? ", curvature jump " + road_words::size(*d.join->jump, "") : ", no curvature";
    return text;
  }

  std::string json(const Rail_check& check, const Decided& d) const {
    std::string text = "\"kind\":\"" + check.kind + "\",\"curve\":" + json_text(check.curve) +
                       ",\"place\":" + json_text(check.place) +
                       ",\"claim\":" + (check.claim.empty() ? "null" : json_text(check.claim));
    if (d.join) text += road_words::members(*d.join);
    if (d.difference)
      text += ",\"quantity\":" + json_text(check.difference->quantity) +
              ",\"difference\":" + road_words::json(d.difference->distance) +
              ",\"equal\":" + road_words::flag(d.difference->is_zero) +
              ",\"within\":" + road_words::flag(d.difference->within);
    return text;
  }

  // The decision about a check or a piece, in words, as members of a JSON object, and as a claim.
  struct Told {
    std::string kind, curve, place;
    long long line;
    std::string words, fault, json;
    Given given;
    Finding_rule rule;
    std::optional<Measure> measure;
  };

  void tell(const Told& t) {
    const Claim claim = t.given.claim;
    if (is_text())
      report_.row("records",
                  GC::printable((several_ ? file_ + ": " : "") + t.curve + ", " + t.place +
                                (t.line > 0 ? " (line " + std::to_string(t.line) + ")" : "") + ": " + t.words +
                                (t.fault.empty() ? "" : " - " + t.fault)) +
                      '\n',
                  claim);
    else
      report_.row("records",
                  ",\n {" + (several_ ? "\"file\":" + json_text(file_) + ',' : "") + t.json +
                      ",\"line\":" + std::to_string(t.line) + ",\"met\":" +
                      (claim == Claim::met       ? "true"
                       : claim == Claim::not_met ? "false"
                                                 : "null") +
                      '}',
                  claim);
    report_.add(file_, t.given, false, [&] {
      Finding f;
      f.file = file_;
      f.line = t.line;
      f.kind = t.kind;
      f.place = t.curve + ", " + t.place;
      f.rule = claim == Claim::undecided     ? Finding_rule::undecided
               : claim == Claim::not_covered ? Finding_rule::not_verified
                                             : t.rule;
      f.message = t.words + (t.fault.empty() ? "" : ", " + t.fault);
      f.properties = t.json;
      f.object = t.curve;
      f.spot = t.kind + ", " + t.place;
      f.measure = t.measure;
      return f;
    });
  }

  void add(const Rail_check& check, const Q& precision) {
    ++kinds_[check.kind];
    if (check.difference) values_.insert(check.kind);
    Decided d = decide(check, precision);
    const std::string reason = !check.not_covered.empty() ? check.not_covered : d.failure;
    Given given{Claim::met, "join"};
    std::string fault;
    Finding_rule rule = Finding_rule::gap;
    const int order = required(check);
    if (!reason.empty())
      given = order < 0 ? given : Given{Claim::not_covered, "join", reason};
    else
      for (int i = 0; i <= order; ++i) {
        const GC::Verdict v = d.verdicts[static_cast<std::size_t>(i)];
        const bool claimed = i <= check.claimed;
        Claimed& count = claims_[check.kind][static_cast<std::size_t>(i)];
        if (claimed) ++count.claims;
        if (v == GC::Verdict::proved) continue;
        if (v == GC::Verdict::undecided) {
          if (claimed) ++count.undecided;
          if (given.claim == Claim::met)
            given = {Claim::undecided, "join",
                     i == 2 && !d.join->jump ? "a curvature is not defined"
                                             : "the tolerance lies inside of the bounds"};
          continue;
        }
        if (claimed) ++count.refuted;
        given.claim = Claim::not_met;
        given.reason.clear();
        if (fault.empty()) rule = i == 0 ? Finding_rule::gap : i == 1 ? Finding_rule::kink : Finding_rule::curvature;
        fault += (fault.empty() ? "" : ", ") + std::string("not one ") +
                 (check.difference ? check.difference->quantity.c_str() : words_of_claims[i]);
      }
    const std::string verdict = !reason.empty() ? "not covered: " + reason : words(check, d);
    keep_worst(check, d);
    std::optional<Measure> size;
    if (d.join && rule == Finding_rule::gap) size = Measure{"gap", d.join->gap};
    if (d.join && rule == Finding_rule::curvature && d.join->jump) size = Measure{"curvature_jump", *d.join->jump};
    tell({check.kind, check.curve, check.place, check.line,
          check.kind + (check.claim.empty() ? "" : ' ' + check.claim) + ", " + verdict, fault,
          json(check, d) + (reason.empty() ? "" : ",\"reason\":" + json_text(reason)), given, rule, size});
  }

  // Decides the bound on the curvature of a piece.
  void add(const Rail_piece& piece) {
    ++kinds_["bend"];
    Given given{Claim::met, "piece of a plan"};
    Bend found;
    if (!piece.not_covered.empty())
      given = {Claim::not_covered, given.noun, piece.not_covered};
    else {
      found = bend(*piece.geometry, *demand_.bound);
      given.claim = found.claim;
      bent_ += found.claim == Claim::not_met;
      if (found.claim == Claim::undecided) given.reason = "where it ends is not known well enough";
      const double bound = CGAL::to_double(demand_.bound->curvature);
      if (piece.rounded && found.curvature && found.curvature->lower <= bound && bound <= found.curvature->upper)
        given = {Claim::undecided, given.noun, "the bound lies inside of the bounds"};
    }
    const std::string verdict =
        piece.not_covered.empty() ? found.words(*demand_.bound, "") : "not covered: " + given.reason;
    std::optional<Measure> size;
    if (given.claim == Claim::not_met && found.curvature) size = Measure{"curvature", *found.curvature};
    tell({"bend", piece.curve, piece.place, piece.line, "bend " + piece.shape + ", " + verdict,
          given.claim == Claim::not_met ? "not " + demand_.bound->words : "",
          "\"kind\":\"bend\",\"curve\":" + json_text(piece.curve) + ",\"place\":" + json_text(piece.place) +
              ",\"claim\":null" + ",\"shape\":" + json_text(piece.shape) + ",\"curvature\":" +
              json_text(found.curvature) + (given.reason.empty() ? "" : ",\"reason\":" + json_text(given.reason)),
          given, Finding_rule::bend, size});
  }

  void keep_worst(const Rail_check& check, const Decided& d) {
    if (!d.join || (check.claimed < 0 && !check.claim.empty())) return;
    const std::optional<GC::Enclosure> sizes[] = {d.join->gap, d.join->kink, d.join->jump};
    for (std::size_t i = 0; i < 3; ++i)
      if (sizes[i] && worst_[i].size.upper < sizes[i]->upper)
        worst_[i] = {*sizes[i], (several_ ? file_ + ": " : "") + check.curve + ", " + check.place};
  }

  void read(const std::string& file) {
    file_ = input_name(file);
    report_.begin_file(file_);
    const Rail_file rails = is_ifc_file(file) ? read_ifc(file) : read_landxml(file);
    ++files_;
    curves_ += rails.curves;
    const Q precision = rails.precision.value_or(Q(Q(1) / 100000));
    for (const Rail_check& check : rails.checks) add(check, precision);
    if (demand_.bound)
      for (const Rail_piece& piece : rails.pieces) add(piece);
    for (const std::string& note : rails.notes)
      if (is_text())
        report_.row("notes", GC::printable((several_ ? file_ + ": " : "") + "note: " + note) + '\n', Claim::met);
      else
        report_.row("notes",
                    ",\n {" + (several_ ? "\"file\":" + json_text(file_) + ',' : "") + "\"note\":" + json_text(note) +
                        '}',
                    Claim::met);
    if (rails.checks.empty()) {
      const Given nothing{Claim::not_covered, "file", "it has no alignment of two pieces"};
      report_.add(file_, nothing, true, [&] {
        Finding f;
        f.file = file_;
        f.kind = "file";
        f.place = file_;
        f.rule = Finding_rule::not_verified;
        f.message = nothing.reason;
        return f;
      });
    }
  }

  const char* word_of_claim(const std::string& kind, std::size_t i) const {
    return values_.count(kind) != 0 ? "value" : words_of_claims[i];
  }

  std::string text_summary() const {
    std::ostringstream os;
    if (several_) os << counted(files_, "file") << ", ";
    os << counted(curves_, "curve");
    const char* separator = ": ";
    for (const auto& [kind, n] : kinds_) {
      os << separator << n << ' ' << kind;
      if (kind == "bend" && bent_ > 0) os << " (" << bent_ << " bent too much)";
      separator = ", ";
    }
    os << '\n';
    for (const auto& [kind, of] : claims_) {
      separator = "";
      for (std::size_t i = 0; i < 3; ++i) {
        if (of[i].claims == 0) continue;
        if (*separator == '\0') os << kind << " claims: ";
        os << separator << of[i].claims << " of one " << word_of_claim(kind, i) << ", " << of[i].refuted << " false";
        if (of[i].undecided > 0) os << ", " << of[i].undecided << " undecided";
        separator = "; ";
      }
      if (*separator != '\0') os << '\n';
    }
    const char* const names[] = {"gap", "kink", "curvature jump"};
    const char* const units[] = {"", " rad", ""};
    for (std::size_t i = 0; i < 3; ++i)
      if (!worst_[i].place.empty())
        os << "largest " << names[i] << ": " << road_words::size(worst_[i].size, units[i]) << ", " << worst_[i].place
           << '\n';
    return os.str();
  }

  std::string json_summary() const {
    std::ostringstream os;
    os << "\"summary\":{\"files\":" << files_ << ",\"curves\":" << curves_ << ",\"kinds\":{";
    const char* separator = "";
    for (const auto& [kind, n] : kinds_) {
      os << separator << json_text(kind) << ':' << n;
      separator = ",";
    }
    os << "},\"claims\":{";
    separator = "";
    for (const auto& [kind, of] : claims_) {
      os << separator << json_text(kind) << ":{";
      for (std::size_t i = 0; i < (values_.count(kind) != 0 ? 1u : 3u); ++i)
        os << (i == 0 ? "" : ",") << '"' << word_of_claim(kind, i) << "\":{\"claims\":" << of[i].claims
           << ",\"false\":" << of[i].refuted << ",\"undecided\":" << of[i].undecided << '}';
      os << '}';
      separator = ",";
    }
    os << "},\"worst\":{";
    const char* const names[] = {"gap", "kink", "curvature_jump"};
    separator = "";
    for (std::size_t i = 0; i < 3; ++i)
      if (!worst_[i].place.empty()) {
        os << separator << '"' << names[i] << "\":{\"size\":" << road_words::json(worst_[i].size)
           << ",\"place\":" << json_text(worst_[i].place) << '}';
        separator = ",";
      }
    os << "}}";
    return os.str();
  }

public:
  Rail_report(const Arguments& files, const Report_mode& mode, const Rail_demand& demand)
      : demand_(demand), report_(mode, subject(demand)), several_(files.size() > 1) {
    report_.row("records");
    report_.row("notes");
    for (const std::string& file : files) read(file);
  }

  int print() { return report_.print(std::cout, is_text() ? text_summary() : json_summary()); }
};

} // namespace

bool is_rail_file(const std::string& file) { return is_ifc_file(file) || is_landxml_file(file); }

int verify_rails(const Arguments& files, const Report_mode& mode, const Rail_demand& demand) {
  return Rail_report(files, mode, demand).print();
}
