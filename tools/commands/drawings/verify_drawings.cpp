// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/verify_drawings.h"

#include "commands/drawings/drawing_kink.h"
#include "commands/drawings/drawing_remark.h"
#include "commands/work_limit.h"
#include "files/deferred_output.h"
#include "files/input.h"
#include "files/progress.h"
#include "formats/svg/svg_drawing.h"
#include "reports/Finding_writer.h"

#include "formats/svg/svg_continuity.h"
#include "formats/svg/svg_grade.h"
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/printable.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace {

typedef GC::Svg_segment<Drawing_traits> Segment;

const char* const undecided = "a rotated ellipse, whose tangents are not rational";

std::string json_string(const std::string& text) {
  std::ostringstream os;
  GC::write_json(os, text);
  return os.str();
}

std::string json_element(const Drawing_element& element) {
  return "\"file\":" + json_string(element.file) + ",\"element\":" + json_string(element.name) +
         ",\"id\":" + json_string(element.id) + ",\"line\":" + std::to_string(element.line);
}

std::string command(const Segment& segment) { return std::to_string(segment.command) + ' ' + segment.letter; }

// Decides the joins of all subpaths that it receives.
class Drawing_report : public Drawing_handler {
  const int max_order_;
  const GC::Work_limit limit_;
  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  const bool several_; // there are several files, so that each line names its own
  const std::optional<Requirement> required_;
  const Kink_rule kinks_;
  Deferred_output out_;
  const std::unique_ptr<Finding_writer> findings_; // instead of rows
  Progress progress_{"joins"};
  std::function<void()> show_progress_ = [] {};
  std::vector<std::string> not_read_;
  GC::Chain_summary summary_; // of what is decided
  std::map<GC::Join_grade, std::size_t> grades_;
  std::size_t joins_ = 0, undecided_ = 0, failing_ = 0, subpaths_ = 0, segments_ = 0;
  bool has_row_ = false;

  typedef std::optional<GC::Join_continuity<Exact>> Decision;
  typedef std::optional<GC::Join_grade> Grade; // empty where a segment has no length or a join is undecided

  Grade grade(const Segment& left, const Segment& right, const Decision& decision) const {
    if (!decision) return std::nullopt;
    if (decision->regular && *decision->tangent_equal)
      return *decision->curvature_vector_equal ? GC::Join_grade::g2 : GC::Join_grade::g1;
    return GC::join_grade(left, right, kinks_.bound, limit_);
  }

  bool meets(const Decision& decision, const Grade& grade) const {
    if (decision && required_->met(*decision)) return true;
    if (!kinks_.corners_are_meant || !grade) return false;
    // what is drawn, also where a handle is retracted
    const bool drawn =
        *grade == GC::Join_grade::g1 && required_->kind() == GC::Continuity_kind::G && required_->order() <= 1;
    return *grade == GC::Join_grade::corner || drawn;
  }

  static std::string place(int number, const Segment& left, const Segment& right) {
    return ", subpath " + std::to_string(number) + ", commands " + command(left) + " - " + command(right);
  }

  static std::string point(const Segment& right) {
    return " at (" + rounded(CGAL::to_double(right.start().x()), 6) + ", " +
           rounded(CGAL::to_double(right.start().y()), 6) + ')';
  }

  std::string text(const Drawing_kink_words& words, const Segment& left, const Segment& right, const Decision& decision,
                   const Grade& grade) const {
    if (!decision) return std::string("undecided, ") + undecided;
    std::string s = 'G' + std::to_string(decision->g_order);
    if (decision->g_order == max_order_) s += " or more";
    if (decision->regular && !*decision->tangent_equal)
      return s + ", " + words(left, right, *grade) + explanation(*decision, left, right);
    s += ", " + drawing_remark(*decision, left, right) + explanation(*decision, left, right);
    return decision->regular || !grade ? s : s + ", drawn as " + words(left, right, *grade);
  }

  std::string json(std::size_t left_number, std::size_t right_number, const Segment& left, const Segment& right,
                   const Decision& decision, const Grade& grade) const {
    std::ostringstream s;
    if (decision)
      GC::write_json_members(s << '{', *decision, static_cast<int>(left_number), static_cast<int>(right_number));
    else
      s << "{\"left\":" << left_number << ",\"right\":" << right_number
        << ",\"c_order\":null,\"g_order\":null,\"f_order\":null,\"betas\":[],\"undecided\":" << json_string(undecided);
    s << ",\"left_command\":" << left.command << ",\"left_letter\":\"" << left.letter
      << "\",\"right_command\":" << right.command << ",\"right_letter\":\"" << right.letter << '"';
    write_drawing_kink(s, left, right, grade);
    return s.str();
  }

public:
  Drawing_report(int max_order, GC::Work_limit limit, const Report_mode& mode, bool several,
                 const std::optional<Requirement>& required, const Kink_rule& kinks)
      : max_order_(max_order), limit_(limit), mode_(mode), several_(several), required_(required), kinks_(kinks),
        findings_(mode.has_findings() ? finding_writer(mode.format) : nullptr) {
    if (json_) out_.write("{\"joins\":[");
  }

  // Reads drawings, one after the other.
  void read(const Arguments& files) {
    const Reading_position position(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
      Input input(files[i]);
      if (findings_) findings_->add_passed(input_name(files[i]), 0, "joins");
      show_progress_ = [&] { progress_.step(joins_, [&] { return position.part(i, input); }); };
      input.after_each_block(show_progress_); // a path may be large
      read_svg_drawing(input, input_name(files[i]), *this);
      show_progress_ = [] {};
    }
    progress_.clear();
  }

  void subpath(const Drawing_element& element, int number, const Drawing_subpath& path) override {
    const std::size_t n = path.segments.size();
    const Drawing_kink_words words(element);
    for (std::size_t i = 0; i < (path.closed ? n : n - 1); ++i) {
      const Segment &left = path.segments[i], &right = path.segments[(i + 1) % n];
      const Decision decision = within_work_limit(
          [&] { return "commands " + std::to_string(left.command) + " and " + std::to_string(right.command); },
          [&] { return GC::continuity(left, right, max_order_, limit_); });
      if (decision)
        summary_.add(*decision);
      else
        ++undecided_;
      const Grade grade = this->grade(left, right, decision);
      if (grade) ++grades_[*grade];
      const bool fails = required_ && !meets(decision, grade);
      failing_ += fails;
      const bool printed = !findings_ && (!mode_.summary || fails);
      if (findings_)
        add_finding(element, number, left, right, decision, grade, fails, [&](const std::string& required) {
          return std::make_pair(required + text(words, left, right, decision, grade) + point(right),
                                json(segments_ + i, segments_ + (i + 1) % n, left, right, decision, grade).substr(1));
        });
      if (printed && json_)
        out_.write((std::exchange(has_row_, true) ? ",\n " : "\n ") +
                   json(segments_ + i, segments_ + (i + 1) % n, left, right, decision, grade) + ',' +
                   json_element(element) + ",\"subpath\":" + std::to_string(number) + '}');
      else if (printed)
        out_.write(name(element) + place(number, left, right) + point(right) + ": " +
                   text(words, left, right, decision, grade) + '\n');
      ++joins_;
      show_progress_();
    }
    segments_ += n;
    ++subpaths_;
  }

  void not_read(const Drawing_element& element, const std::string& reason) override {
    if (findings_)
      findings_->add({element.file, element.line, "element", element.text(), Finding_rule::not_verified,
                      !mode_.allow_undecided ? Finding_level::error : Finding_level::warning, "not verified, " + reason,
                      "", Claim::not_covered});
    not_read_.push_back(json_ ? '{' + json_element(element) + ",\"reason\":" + json_string(reason) + '}'
                              : name(element) + ": not verified, " + GC::printable(reason));
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    out_.copy_to(os);
    if (findings_)
      findings_->print(os, json_summary());
    else if (json_)
      print_json_summary(os);
    else
      print_summary(os);
    return conclusion().exit_code(mode_, "join");
  }

private:
  static Finding_rule rule(const Decision& decision, const Grade& grade) {
    if (!decision) return Finding_rule::undecided;
    if (grade == GC::Join_grade::corner) return Finding_rule::corner;
    if (grade == GC::Join_grade::kink) return Finding_rule::kink;
    if (!decision->regular) return Finding_rule::tangent;
    return *decision->curvature_vector_equal ? Finding_rule::derivative : Finding_rule::curvature;
  }

  // Adds what fails or is undecided, and kinks where nothing is required. words(begin) returns the message and the properties.
  template <class Words>
  void add_finding(const Drawing_element& element, int number, const Segment& left, const Segment& right,
                   const Decision& decision, const Grade& grade, bool fails, Words words) {
    if (!fails && decision && (required_ || grade != GC::Join_grade::kink)) {
      findings_->add_passed(element.file, 1, "joins");
      return;
    }
    const Finding_level level = fails || (!decision && !mode_.allow_undecided) ? Finding_level::error
                                : decision                                     ? Finding_level::note
                                                                               : Finding_level::warning;
    const auto [message, properties] = words(fails ? "not " + required_->text() + ", " : "");
    findings_->add({element.file, element.line, "join", element.text() + place(number, left, right),
                    rule(decision, grade), level, message, properties, Claim::met});
  }

  // Joins that are undecided fail when an order is asked for.
  Old_conclusion conclusion() const { return {joins_, failing_, not_read_.size() + (required_ ? 0 : undecided_)}; }

  // What the lines of an element begin with: names from outside must not look like lines.
  std::string name(const Drawing_element& element) const {
    return GC::printable((several_ ? element.file + ": " : "") + element.text());
  }

  std::map<int, std::size_t> counts() const { return summary_.counts(GC::Continuity_kind::G); }

  void print_summary(std::ostream& os) const {
    for (const std::string& line : not_read_) os << line << '\n';
    os << counted(joins_, "join") << " in " << counted(subpaths_, "subpath");
    const char* separator = ": ";
    for (const auto& [order, count] : counts()) {
      os << separator << count << " G" << order << (order == max_order_ ? " or more" : "");
      separator = ", ";
    }
    if (undecided_ != 0) os << separator << undecided_ << " undecided";
    const std::string unverified =
        not_read_.empty() ? "" : "; " + counted(not_read_.size(), "element") + " not verified";
    os << unverified << grades() << '\n';
    if (joins_ == 0)
      os << "no join, nothing was decided\n";
    else if (required_ && failing_ == 0)
      os << "every join" << (kinks_.corners_are_meant ? " but the corners" : "") << " is " << required_->text()
         << ", proved exactly" << unverified << '\n';
    else if (required_)
      os << failing_ << " of them not " << (undecided_ == 0 ? "" : "proved to be ") << required_->text() << '\n';
    if (!mode_.allow_undecided && conclusion().unverified > 0) os << "not met, because not all was verified\n";
  }

  std::size_t count(GC::Join_grade grade) const {
    const auto found = grades_.find(grade);
    return found == grades_.end() ? 0 : found->second;
  }

  std::string grades() const {
    if (joins_ == 0) return "";
    return "; drawn as " + counted(count(GC::Join_grade::corner), "corner") + ", " +
           counted(count(GC::Join_grade::kink), "kink") + " of at most " + kinks_.degrees + " degrees, " +
           std::to_string(count(GC::Join_grade::g1)) + " G1, " + std::to_string(count(GC::Join_grade::g2)) +
           " G2 or more";
  }

  void print_json_summary(std::ostream& os) const {
    os << "],\n \"not_verified\":[";
    for (std::size_t i = 0; i < not_read_.size(); ++i) os << (i == 0 ? "\n " : ",\n ") << not_read_[i];
    os << "],\n " << json_summary() << "}\n";
  }

  std::string json_summary() const {
    std::ostringstream os;
    os << "\"summary\":{\"joins\":" << joins_ << ",\"subpaths\":" << subpaths_;
    for (const auto& [order, count] : counts()) os << ",\"G" << order << "\":" << count;
    os << ",\"undecided\":" << undecided_ << ",\"corners\":" << count(GC::Join_grade::corner)
       << ",\"kinks\":" << count(GC::Join_grade::kink) << '}';
    if (required_) os << ",\n \"required\":\"" << required_->text() << "\",\"met\":" << conclusion().json_met(mode_);
    return os.str();
  }
};

} // namespace

int verify_drawings(const Arguments& files, int max_order, GC::Work_limit limit, const Report_mode& mode,
                    const std::optional<Requirement>& required, const Kink_rule& kinks) {
  if (required) required->check_dimension(2);
  Drawing_report report(max_order, limit, mode, files.size() > 1, required, kinks);
  report.read(files);
  return report.print(std::cout);
}
