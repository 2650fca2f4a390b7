// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_REPORT_H

#include "commands/repair/repair_contour.h"
#include "reports/Conclusion.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Returns the subject of the reports of `repair`.
inline Report_subject repair_subject(bool has_gaps = false) {
  return {"join",
          "every join",
          has_gaps ? "free of kinks and gaps" : "free of kinks",
          {},
          "proved exactly on what is written",
          {}};
}

// Reports the repairs of a file, for people and for machines.
class Repair_report {
  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  std::vector<std::string> grids_, reversed_, closed_, arcs_, moves_, unrepaired_, jumps_,
      lost_; // lines, or JSON objects
  Grade_counts before_, after_, defined_before_, defined_after_;
  std::map<std::string, std::size_t> undecided_;
  Claims claims_;               // but for the joins that have grades
  bool is_beside_grid_ = false; // something that was not repaired
  std::size_t curvatures_ = 0, harmonised_ = 0, exact_ = 0;
  GC::Enclosure largest_{0, 0}, largest_jump_{0, 0};
  std::string largest_place_, largest_unit_;

  static std::string json_text(const GC::Enclosure& x) { return ::json_text(std::optional<GC::Enclosure>(x)); }
  static std::string json_text(const std::string& x) { return ::json_text(x); }
  static std::size_t kinks(const Grade_counts& counts) {
    const auto found = counts.find(GC::Visual_class::kink);
    return found == counts.end() ? 0 : found->second;
  }
  static std::string json_texts(const std::vector<std::string>& texts) {
    std::vector<std::string> quoted;
    for (const std::string& text : texts) quoted.push_back(json_text(text));
    return json_array(quoted);
  }
  static std::string tuple(const std::vector<std::string>& numbers) {
    return numbers.size() == 1 ? numbers[0] : '(' + numbers[0] + ", " + numbers[1] + ')';
  }
  static std::string offer_object(const Arc_offer& o) {
    return "{\"curve\":" + std::to_string(o.curve) +
           (o.moves_start ? ",\"start\":"
            : o.moves_end ? ",\"end\":"
                          : ",\"radii\":") +
           json_texts(o.numbers) + ",\"is_decimal\":" + (o.is_decimal ? "true}" : "false}");
  }
  static std::string percent(const GC::Enclosure& x) { return rounded_up(x.upper * 100 * (1 + 1e-15)) + " %"; }
  static GC::Enclosure in_percent(const GC::Enclosure& x) {
    return {x.lower * 100 * (1 - 1e-15), x.upper * 100 * (1 + 1e-15)};
  }

  static void write_counts(std::ostream& os, const Grade_counts& counts, bool json) {
    std::size_t all = 0;
    for (const auto& [grade, count] : counts) all += count;
    const auto count = [&](GC::Visual_class grade) { return counts.count(grade) != 0 ? counts.at(grade) : 0; };
    const std::pair<const char*, GC::Visual_class> names[] = {{"gaps", GC::Visual_class::gap},
                                                              {"corners", GC::Visual_class::corner},
                                                              {"kinks", GC::Visual_class::kink},
                                                              {"G1", GC::Visual_class::g1},
                                                              {"G2", GC::Visual_class::g2}};
    if (json) os << "{\"joins\":" << all;
    const char* separator = "";
    for (const auto& [name, grade] : names)
      if (json)
        os << ",\"" << name << "\":" << count(grade);
      else if (grade != GC::Visual_class::gap || count(grade) != 0) {
        os << separator << count(grade) << ' '
           << (count(grade) == 1 && name[0] >= 'a' ? std::string(name, std::char_traits<char>::length(name) - 1)
                                                   : name);
        separator = ", ";
      }
    if (json) os << '}';
  }

  static void write_array(std::ostream& os, const char* name, const std::vector<std::string>& objects) {
    os << '"' << name << "\":[";
    for (std::size_t i = 0; i < objects.size(); ++i) os << (i == 0 ? "\n " : ",\n ") << objects[i];
    os << "],\n ";
  }

public:
  explicit Repair_report(const Report_mode& mode) : mode_(mode) {}

  // The joins before and after, as they are read.
  void add_grades(const Grade_counts& before, const Grade_counts& after) {
    for (const auto& [grade, count] : before) before_[grade] += count;
    for (const auto& [grade, count] : after) after_[grade] += count;
  }

  // Adds the repair of a contour. `place` is its place in words, and `members` is the same as
  // members of JSON objects; `curve_name(i)` is the name of a curve, e.g. "command 3".
  template <class Name>
  void add(const std::string& place, const std::string& members, const Grid_contour& contour,
           const Contour_repair& done, Name curve_name) {
    const auto behind = [&](std::size_t join) {
      const std::vector<GC::Grid_vector>& points = contour.curves[join].points;
      return place + ", behind " + curve_name(join) +
             (points.empty() ? ""
                             : " at " + contour.text(points.back(), offset(contour.curves[join], points.size() - 1)));
    };
    const auto object = [&](std::size_t curve, const std::string& more) {
      return '{' + members + ",\"curve\":" + std::to_string(curve) + ',' + more + '}';
    };
    for (const Closed_gap& x : done.closed)
      closed_.push_back(json_ ? object(x.join, "\"gap\":" + json_text(x.width))
                              : behind(x.join) + ": the ends were " + rounded(x.width.upper, 4) + " apart");
    for (const Handle_move& m : done.moves) {
      const std::string where = place + ", " + curve_name(m.curve) + ", point " + std::to_string(m.point);
      const GC::Enclosure distance = m.distance();
      if (distance.upper > largest_.upper) {
        largest_ = distance;
        largest_place_ = where;
        largest_unit_ = contour.is_beside_grid ? "of the grid " + contour.unit() : "of the last decimal";
      }
      const std::string from = contour.text(m.from, m.offset_from), to = contour.text(m.to, m.offset_to);
      const auto pair = [](std::string point) { // (x, y)
        point.replace(point.find(", "), 2, "\",\"");
        return "[\"" + point.substr(1, point.size() - 2) + "\"]";
      };
      moves_.push_back(json_ ? object(m.curve, "\"point\":" + std::to_string(m.point) + ",\"from\":" + pair(from) +
                                                   ",\"to\":" + pair(to) + ",\"units\":" + json_text(distance))
                             : where + ": " + from + " -> " + to + ", " + units(distance));
    }
    for (const Arc_change& x : done.arcs)
      arcs_.push_back(
          json_ ? object(x.curve,
                         "\"what\":\"" + x.what + "\",\"from\":" + json_texts(x.from) + ",\"to\":" + json_texts(x.to))
                : place + ", " + curve_name(x.curve) + ", " + x.what + ": " + tuple(x.from) + " -> " + tuple(x.to));
    for (const auto& [reason, count] : done.undecided) undecided_[reason] += count;
    for (const Unrepaired_join& x : done.unrepaired) {
      is_beside_grid_ = is_beside_grid_ || x.reason.find("on this grid") != std::string::npos;
      std::string offers;
      for (const Arc_offer& o : x.offers)
        offers += json_ ? (offers.empty() ? "" : ",") + offer_object(o)
                        : (offers.empty() ? "; smooth with " : ", or with ") + o.text() + " of " + curve_name(o.curve) +
                              (o.is_decimal ? "" : ", which is no short decimal");
      const bool can = std::any_of(x.offers.begin(), x.offers.end(), [](const Arc_offer& o) { return o.is_decimal; });
      unrepaired_.push_back(json_
                                ? object(x.join, "\"reason\":" + json_text(x.reason) +
                                                     (offers.empty() ? "" : ",\"smooth_with\":[" + offers + ']'))
                                : behind(x.join) + ": " + x.reason + offers + (can ? "; --arcs takes the first" : ""));
    }
    for (const std::size_t join : done.lost)
      lost_.push_back(json_ ? object(join, "\"before\":\"G2\",\"after\":\"G1\"")
                            : behind(join) + ": G2 before, now G1");
    for (const Curvature_jump& x : done.jumps) {
      ++curvatures_;
      exact_ += x.after.upper == 0;
      harmonised_ += x.reason.empty();
      if (x.reason.empty() && x.after.upper > largest_jump_.upper) largest_jump_ = x.after;
      jumps_.push_back(json_ ? object(x.join, "\"before_percent\":" + json_text(in_percent(x.before)) +
                                                  ",\"after_percent\":" + json_text(in_percent(x.after)) +
                                                  ",\"reason\":" + (x.reason.empty() ? "null" : json_text(x.reason)))
                             : behind(x.join) + ": the curvature jumps by " +
                                   (x.after.upper == 0 ? "nothing, G2" : percent(x.after)) + " instead of " +
                                   percent(x.before) + (x.reason.empty() ? "" : "; " + x.reason));
    }
  }

  // Adds that another grid than that of the file is taken, and why unless it was asked for.
  void add_grid(const std::string& place, const std::string& members, const std::string& unit,
                const std::string& reason) {
    if (json_)
      grids_.push_back('{' + members + ",\"unit\":\"" + unit +
                       "\",\"reason\":" + (reason.empty() ? "null" : json_text(reason)) + '}');
    else if (!reason.empty())
      grids_.push_back("grid: " + place + ": units of " + unit + " from node to handle, because " + reason +
                       "; --grid takes another one");
  }

  // Adds a curve that runs the other way, by its number.
  void add_reversed(std::size_t curve) {
    reversed_.push_back(json_ ? std::to_string(curve) : "reversed: curve " + std::to_string(curve));
  }

  // Adds a hint, for people.
  void add_hint(const std::string& text) {
    if (!json_) unrepaired_.push_back(text);
  }

  // The joins of what is defined and not drawn.
  void add_definitions(const Grade_counts& before, const Grade_counts& after) {
    defined_before_ = before;
    defined_after_ = after;
  }

  // The joins with a rotated ellipse.
  void add_undecided(std::size_t joins) {
    if (joins != 0)
      undecided_["an arc of a rotated ellipse, whose tangent differs by too little to be told, or not at all"] += joins;
  }

  // Adds a part that could not be read as a whole.
  void add_unread(const std::string& place, const std::string& members, const std::string& reason) {
    unrepaired_.push_back(json_ ? '{' + members + ",\"reason\":" + json_text(reason) + '}' : place + ": " + reason);
  }

  // An element that is not covered, with a reason.
  void add_uncovered(const std::string& place, const std::string& members, const std::string& reason) {
    add_unread(place, members, reason);
    claims_.add({Claim::not_covered, "element", reason});
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os, const std::string& file) const {
    Claims claims = claims_;
    const auto is_left = [](GC::Visual_class grade) {
      return grade == GC::Visual_class::kink || grade == GC::Visual_class::gap;
    };
    for (const Grade_counts* counts : {&after_, &defined_after_})
      for (const auto& [grade, count] : *counts)
        claims.add({is_left(grade) ? Claim::not_met : Claim::met, "join"}, count);
    for (const auto& [reason, count] : undecided_) claims.add({Claim::undecided, "join", reason}, count);
    const Report_subject subject = repair_subject(after_.count(GC::Visual_class::gap) != 0);
    const Conclusion end(claims, mode_, subject);
    print(os, file, end);
    return end.exit_code();
  }

private:
  void print(std::ostream& os, const std::string& file, const Conclusion& end) const {
    if (json_) {
      os << "{\"file\":" << json_text(file) << ",\n ";
      write_array(os, "grids", grids_);
      write_array(os, "reversed", reversed_);
      write_array(os, "closed", closed_);
      write_array(os, "arcs", arcs_);
      write_array(os, "moves", moves_);
      write_array(os, "curvatures", jumps_);
      write_array(os, "lost", lost_);
      write_array(os, "not_repaired", unrepaired_);
      os << "\"largest_move\":" << json_text(largest_) << ",\n \"before\":";
      write_counts(os, before_, true);
      os << ",\n \"after\":";
      write_counts(os, after_, true);
      os << ",\n \"not_drawn\":{\"before\":";
      write_counts(os, defined_before_, true);
      os << ",\"after\":";
      write_counts(os, defined_after_, true);
      os << "},\n " << end.json() << "}\n";
      return;
    }
    for (const std::string& line : grids_) os << GC::printable(line) << '\n';
    for (const std::string& line : reversed_) os << line << '\n';
    for (const std::string& line : closed_) os << "closed: " << GC::printable(line) << '\n';
    for (const std::string& line : arcs_) os << "changed: " << GC::printable(line) << '\n';
    for (const std::string& line : moves_) os << "moved: " << GC::printable(line) << '\n';
    for (const std::string& line : lost_) os << GC::printable(line) << '\n';
    for (const std::string& line : jumps_) os << GC::printable(line) << '\n';
    for (const std::string& line : unrepaired_) os << "not repaired: " << GC::printable(line) << '\n';
    if (is_beside_grid_) os << "--grid with a smaller unit has nearer positions for what is not on this grid\n";
    if (moves_.empty() && reversed_.empty() && arcs_.empty()) os << "nothing is changed: no handle moves\n";
    os << "before: ";
    write_counts(os, before_, false);
    os << "\nafter:  ";
    write_counts(os, after_, false);
    os << '\n';
    if (kinks(defined_before_) + kinks(defined_after_) != 0)
      os << "defined and not drawn: " << kinks(defined_before_) << " kinks before, " << kinks(defined_after_)
         << " after\n";
    if (!moves_.empty())
      os << "largest move: " << units(largest_) << ' ' << largest_unit_ << ", " << GC::printable(largest_place_)
         << '\n';
    if (curvatures_ != 0)
      os << "curvatures: of " << curvatures_ << " joins that were not G2, " << harmonised_ << " are harmonised, "
         << exact_ << " of them exactly; the largest jump of these is " << percent(largest_jump_) << '\n';
    os << end.text();
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_REPAIR_REPORT_H
