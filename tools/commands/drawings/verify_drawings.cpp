// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/verify_drawings.h"

#include "commands/drawings/Subpath_joins.h"
#include "commands/drawings/drawing_kink.h"
#include "commands/drawings/drawing_remark.h"
#include "commands/drawings/read_drawing.h"
#include "commands/drawings/segment_curvature.h"
#include "commands/drawings/segment_joins.h"
#include "commands/work_limit.h"
#include "files/input.h"
#include "files/progress.h"
#include "formats/svg/svg_drawing.h"
#include "reports/Report.h"
#include "reports/certificate.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/joins/path_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

namespace {

typedef GC::Svg_segment<Drawing_traits> Segment;

const char* const too_near = "a rotated ellipse, whose tangent differs by too little to be told, or not at all";

std::string json_element(const Drawing_element& element) {
  return "\"file\":" + json_text(element.file) + ",\"element\":" + json_text(element.name) +
         ",\"id\":" + json_text(element.id) + ",\"line\":" + std::to_string(element.line) +
         (element.repeated_by.empty() ? "" : ",\"repeated_by\":" + json_text(element.repeated_by));
}

// Where a join is, e.g. ", subpath 1, commands 2 c - 3 s".
void append_place(std::string& s, int number, const Segment& left, const Segment& right) {
  append(s, ", subpath ", number, ", ", command_words(left), ' ', command_text(left), " - ", command_text(right));
}

// E.g. " at (1, 2)".
void append_point(std::string& s, const Segment& right) {
  const auto append = [&s](const Drawing_traits::Point& p) {
    ::append(s, " at (", rounded(CGAL::to_double(p.x()), 6), ", ", rounded(CGAL::to_double(p.y()), 6), ')');
  };
  right.bezier() ? append(right.bezier()->control_point(0)) : append(right.start());
}

// Decides the joins of all subpaths that it receives.
class Drawing_report : public Drawing_handler {
  const int max_order_;
  const bool several_; // there are several files, so that each line names its own
  const std::optional<Requirement> required_;
  const Kink_rule kinks_;
  const std::optional<Curvature_bound> bound_;
  Report report_;
  Certificate certificate_;
  Progress progress_{"joins"};
  std::function<void()> show_progress_ = [] {};
  double part_of_drawing_ = 0; // that has been decided
  GC::Chain_summary summary_;  // of what is decided
  std::map<GC::Visual_class, std::size_t> grades_;
  std::size_t joins_ = 0, left_out_ = 0, undecided_ = 0, not_read_ = 0, subpaths_ = 0, segments_ = 0;
  std::size_t bent_ = 0;                          // curves
  std::size_t rounding_ = 0, looked_through_ = 0; // joins and segments, see Subpath_joins

  // A subpath, and what its lines begin with.
  struct Place {
    const Drawing_element& element;
    int number;
    Drawing_kink_words words;
    std::string name;
  };

  typedef std::optional<GC::Join_continuity<Exact>> Decision;
  typedef std::optional<GC::Visual_class> Grade; // empty where a join is undecided

  static Report_subject subject(const std::optional<Requirement>& required,
                                const std::optional<Curvature_bound>& bound) {
    Report_subject s{"join", "every join"};
    if (required) {
      if (leaves_corners(*required)) s.every += " but the corners";
      s.required = required->text();
      s.required_in_json = "\"required\":\"" + required->text() + '"';
    }
    if (bound) demand_curvature(s, *bound);
    return s;
  }

  // Corners are meant: they need not be G1 or more.
  static bool leaves_corners(const Requirement& required) {
    return required.kind() == GC::Continuity_kind::G && required.order() > 0;
  }

  Grade grade(const Drawing_join& join, const Decision& decision) const {
    if (!decision) return std::nullopt;
    if (decision->regular && *decision->tangent_equal)
      return *decision->curvature_vector_equal ? GC::Visual_class::g2 : GC::Visual_class::g1;
    return segment_class(join, kinks_.bound);
  }

  Claim claim(const Decision& decision, const Grade& grade) const {
    if (!decision) return Claim::undecided;
    if (!required_ || required_->met(*decision)) return Claim::met;
    if (!grade || required_->kind() != GC::Continuity_kind::G) return Claim::not_met;
    // what is drawn, also where a handle is retracted
    const bool drawn = *grade >= GC::Visual_class::g1 && required_->order() <= 1;
    return drawn || (*grade == GC::Visual_class::corner && leaves_corners(*required_)) ? Claim::met : Claim::not_met;
  }

  // Appends the words about skipped segments.
  static void append_rounding(std::string& s, std::size_t looked_through) {
    if (looked_through == 0) return;
    append(s, ", rounding: ", counted(looked_through, "segment"), looked_through == 1 ? " is" : " are",
           " looked through, no longer than one unit of the last decimal");
  }

  void append_text(std::string& s, const Drawing_kink_words& words, const Drawing_join& join, const Segment& left,
                   const Segment& right, const Decision& decision, const Grade& grade) const {
    if (!decision) {
      append(s, "undecided, ", too_near);
      const std::optional<GC::Enclosure> angle = angle_bounds(left, right);
      if (angle) append(s, ": by ", rounded(angle->upper, 4), " degrees at most");
      return;
    }
    append(s, 'G', decision->g_order, decision->g_order == max_order_ ? " or more, " : ", ");
    const bool is_kink = decision->regular && !*decision->tangent_equal;
    append(s, is_kink ? words(join, *grade) : drawing_remark(*decision, join), explanation(*decision, left, right));
    if (!decision->regular && grade) append(s, ", drawn as ", words(join, *grade));
  }

  std::string json(std::size_t left_number, std::size_t right_number, std::size_t looked_through, const Segment& left,
                   const Segment& right, const Decision& decision, const Grade& grade) const {
    std::ostringstream s;
    if (decision)
      GC::write_json_members(s, *decision, static_cast<int>(left_number), static_cast<int>(right_number));
    else
      s << "\"left\":" << left_number << ",\"right\":" << right_number
        << ",\"c_order\":null,\"g_order\":null,\"f_order\":null,\"betas\":[],\"undecided\":" << json_text(too_near);
    s << ",\"left_command\":" << left.command << ",\"left_letter\":\"" << letter_text(left)
      << "\",\"right_command\":" << right.command << ",\"right_letter\":\"" << letter_text(right) << '"';
    if (looked_through != 0) s << ",\"looked_through\":" << looked_through;
    write_drawing_kink(s, left, right, grade);
    return s.str();
  }

public:
  Drawing_report(int max_order, const Report_mode& mode, const Arguments& files,
                 const std::optional<Requirement>& required, const Kink_rule& kinks,
                 const std::optional<Curvature_bound>& bound)
      : max_order_(max_order), several_(files.size() > 1), required_(required), kinks_(kinks), bound_(bound),
        report_(mode, subject(required, bound)),
        certificate_(mode.certificate, "drawings", files, ",\"max_order\":" + std::to_string(max_order)) {
    report_.row("joins");
    if (bound) report_.row("bent_curves");
    report_.row("not_verified");
  }

  // Reads drawings, one after the other.
  void read(const Arguments& files) {
    const Reading_position position(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
      const bool is_toolpath = is_toolpath_file(files[i]);
      Input input(files[i]);
      report_.begin_file(input_name(files[i]));
      part_of_drawing_ = 0;
      show_progress_ = [&] { progress_.step(joins_, [&] { return position.part(i, part_of_drawing_); }); };
      input.after_each_block(show_progress_); // a path may be large
      read_drawing(files[i], is_toolpath, input, *this);
      show_progress_ = [] {};
    }
    progress_.clear();
  }

  void progress(double part) override { part_of_drawing_ = part; }

  void subpath(const Drawing_element& element, int number, const Drawing_subpath& path) override {
    const Place place{element, number, Drawing_kink_words(element), name(element)};
    const Subpath_joins joins(element, path);
    const bool has_rounding = joins.rounding() != 0;
    const bool is_certified = certificate_ && !element.has_percentages && element.repeated_by.empty();
    if (is_certified && has_rounding) certify_all(place, path);
    joins.for_each([&](std::size_t i, std::size_t j, std::size_t looked_through, const Segment& right) {
      const Segment& left = path.segments[i];
      const Drawing_join join(left, right);
      const Decision decision = decide(join);
      if (is_certified && !has_rounding) certify(place, i, j, join, decision);
      report(place, i, j, looked_through, join, decision);
    });
    if (bound_)
      for (const Segment& segment : path.segments) report_curvature(place, segment);
    segments_ += path.segments.size();
    left_out_ += path.left_out;
    looked_through_ += joins.rounding();
    ++subpaths_;
  }

  void not_read(const Drawing_element& element, const std::string& reason) override {
    ++not_read_;
    report_.add(element.file, {Claim::not_covered, "element", reason}, false, [&]() -> Finding {
      Finding f;
      f.file = element.file;
      f.line = element.line;
      f.kind = "element";
      f.place = element.text();
      f.rule = Finding_rule::not_verified;
      f.message = "not verified, " + reason;
      f.object = element.path();
      f.shape = element.name + ' ' + element.id + ' ' + reason;
      return f;
    });
    if (report_.mode().format == Report_format::json)
      report_.row("not_verified", ",\n {" + json_element(element) + ",\"reason\":" + json_text(reason) + '}');
    if (report_.mode().format == Report_format::text)
      report_.row("not_verified", name(element) + ": not verified, " + GC::printable(reason) + '\n');
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    certificate_.finish();
    if (looked_through_ != 0) report_.say_of_every(", with rounding looked through,");
    return report_.print(os, report_.mode().format == Report_format::text ? text_summary() : json_summary());
  }

private:
  // Reports how far a segment is bent.
  void report_curvature(const Place& place, const Segment& segment) {
    static const char* const irrational = "an arc of an ellipse, whose curvature is known for rational numbers only";
    const Drawing_element& element = place.element;
    std::optional<GC::Curvature_excess> excess;
    const bool is_decided = within_work_limit([&] { return "command " + std::to_string(segment.command); },
                                              [&] { return decide_curvature(segment, *bound_, excess); });
    const Claim claim = !is_decided ? Claim::not_covered : excess ? Claim::not_met : Claim::met;
    std::string where = ", subpath " + std::to_string(place.number) + ", command ";
    append(where, segment.command, ' ', segment.letter);
    const auto members = [&] {
      std::ostringstream os;
      os << json_element(element) << ",\"subpath\":" << place.number << ",\"command\":" << segment.command
         << ",\"letter\":\"" << segment.letter << "\",";
      write_json_members(os, *excess);
      return os.str();
    };
    report_.add(element.file, {claim, is_decided ? "curve" : "arc", irrational}, false, [&]() -> Finding {
      Finding f;
      f.file = element.file;
      f.line = element.line_of(segment);
      f.kind = "curve";
      f.place = element.text() + where;
      f.rule = is_decided ? Finding_rule::bend : Finding_rule::not_verified;
      f.message = is_decided ? "not " + bound_->words + ": " + to_string(*excess) : irrational;
      if (excess) f.properties = members();
      f.object = element.path();
      append(f.spot, place.number, ' ', segment.command);
      if (excess && !excess->unbounded) f.measure = Measure{"curvature", size_of(*excess)};
      return f;
    });
    if (!excess) return;
    ++bent_;
    report_.row("bent_curves", report_.mode().format == Report_format::json
                                   ? ",\n {" + members() + '}'
                                   : place.name + where + ": " + to_string(*excess) + '\n');
  }

  Decision decide(const Drawing_join& join) const {
    return within_work_limit(
        [&] {
          return std::string(command_words(segment(join.left()))) + ' ' + command_text(segment(join.left())) + " and " +
                 command_text(segment(join.right()));
        },
        [&] { return segment_continuity(join, max_order_); });
  }

  // The join of two segments of a subpath, of these numbers, with so many between them that are
  // looked through.
  void report(const Place& place, std::size_t i, std::size_t j, std::size_t looked_through, const Drawing_join& join,
              const Decision& decision) {
    const Drawing_element& element = place.element;
    const Segment &left = segment(join.left()), &right = segment(join.right());
    if (decision)
      summary_.add(*decision);
    else
      ++undecided_;
    const Grade grade = this->grade(join, decision);
    if (grade) ++grades_[*grade];
    if (looked_through != 0) ++rounding_;
    const Claim claim = this->claim(decision, grade);
    const auto members = [&] {
      return json(segments_ + i, segments_ + j, looked_through, left, right, decision, grade);
    };
    const bool is_noted = looked_through != 0 || (!required_ && grade == GC::Visual_class::kink);
    report_.add(element.file, {claim, "join", too_near}, is_noted, [&]() -> Finding {
      Finding f;
      f.file = element.file;
      f.line = element.line_of(right);
      f.kind = "join";
      f.place = element.text();
      append_place(f.place, place.number, left, right);
      f.rule = looked_through != 0 && claim == Claim::met ? Finding_rule::rounding : rule(decision, grade);
      if (claim == Claim::not_met) f.message = "not " + required_->text() + ", ";
      append_text(f.message, place.words, join, left, right, decision, grade);
      append_rounding(f.message, looked_through);
      append_point(f.message, right);
      f.properties = members();
      f.object = element.path();
      append(f.spot, place.number, ' ', left.command, ' ', right.command);
      f.shape = shape(f.rule, left, right);
      f.measure = measure(f.rule, left, right);
      return f;
    });
    add_row(claim, [&]() -> std::string {
      if (report_.mode().format == Report_format::json)
        return ",\n {" + members() + ',' + json_element(element) + ",\"subpath\":" + std::to_string(place.number) + '}';
      std::string row;
      row.reserve(256);
      row = place.name;
      append_place(row, place.number, left, right);
      append_point(row, right);
      row += ": ";
      append_text(row, place.words, join, left, right, decision, grade);
      append_rounding(row, looked_through);
      row += '\n';
      return row;
    });
    ++joins_;
    show_progress_();
  }

  // Joins are made of segments with commands.
  static const Segment& segment(const GC::Path_segment<Drawing_traits>& s) { return static_cast<const Segment&>(s); }

  // The root in the derivatives of a segment, if it is rational.
  static std::optional<Exact> root(const Segment& segment) {
    return segment.is_known() ? GC::rational_square_root(segment.radicand()) : std::nullopt;
  }

  // Adds what certifies the orders of a join of two segments of these numbers, unless there are
  // roots in their derivatives. It is in the coordinates of the element: the orders are the same
  // before and after its transform, which is invertible.
  void certify(const Place& place, std::size_t i, std::size_t j, const Drawing_join& join, const Decision& decision) {
    const Segment &left = segment(join.left()), &right = segment(join.right());
    const std::optional<Exact> left_root = root(left), right_root = root(right);
    if (!left_root || !right_root) return;
    const GC::Svg_transform<Drawing_traits> inverse = place.element.transform.inverse();
    certificate_.add("\"line\":" + std::to_string(place.element.line) + ",\"subpath\":" + std::to_string(place.number) +
                     ",\"left\":" + std::to_string(i) + ",\"right\":" + std::to_string(j) + ',' +
                     certificate_members(
                         GC::join_certificate(left.transform(inverse).end_jet_over<Exact>(max_order_, *left_root),
                                              right.transform(inverse).start_jet_over<Exact>(max_order_, *right_root),
                                              *decision, max_order_)));
  }

  // Certifies the joins of all segments of a subpath, also of those that are looked through.
  void certify_all(const Place& place, const Drawing_subpath& path) {
    for (std::size_t i = 0; i < path.joins(); ++i) {
      const std::size_t j = (i + 1) % path.segments.size();
      const Drawing_join join(path.segments[i], path.segments[j]);
      certify(place, i, j, join, decide(join));
    }
  }

  // Adds a row of a join unless only findings are written, or what is not met.
  template <class Row> void add_row(Claim claim, Row row) {
    if (report_.mode().has_findings() || (report_.mode().summary && claim == Claim::met)) return;
    report_.row("joins", row(), claim);
  }

  static Finding_rule rule(const Decision& decision, const Grade& grade) {
    if (!decision) return Finding_rule::undecided;
    if (grade == GC::Visual_class::corner) return Finding_rule::corner;
    if (grade == GC::Visual_class::kink || (decision->regular && !*decision->tangent_equal)) return Finding_rule::kink;
    if (!decision->regular) return Finding_rule::tangent;
    return *decision->curvature_vector_equal ? Finding_rule::derivative : Finding_rule::curvature;
  }

  // Describes the defect relative to the join, wherever that is: by both segments, or by the
  // handles of curves with a kink or a corner.
  static std::string shape(Finding_rule rule, const Segment& left, const Segment& right) {
    const bool is_of_tangents = rule == Finding_rule::kink || rule == Finding_rule::corner;
    std::ostringstream os;
    const Drawing_traits::Point origin = right.start();
    const auto write = [&](const Drawing_traits::Point& p) {
      os << ' ' << Exact(p.x() - origin.x()) << ',' << Exact(p.y() - origin.y());
    };
    for (const Segment* segment : {&left, &right}) {
      if (segment->bezier()) {
        const auto& curve = *segment->bezier();
        const bool is_end = segment == &left;
        for (int i = 1; i <= curve.degree(); ++i) {
          const auto& point = curve.control_point(is_end ? curve.degree() - i : i);
          write(point);
          if (is_of_tangents && point != origin) break;
        }
      } else {
        os << " arc";
        write(segment->start());
        write(segment->end());
        if (segment->is_known()) os << ' ' << segment->radicand();
      }
      os << ';';
    }
    return os.str();
  }

  static std::optional<Measure> measure(Finding_rule rule, const Segment& left, const Segment& right) {
    if (rule == Finding_rule::curvature) {
      if (!left.bezier() || !right.bezier()) return std::nullopt;
      const std::optional<GC::Enclosure> jump = segment_curvature_jump(*left.bezier(), *right.bezier());
      return jump ? std::optional<Measure>(Measure{"curvature_jump", *jump}) : std::nullopt;
    }
    if (rule == Finding_rule::derivative) return std::nullopt;
    const std::optional<GC::Enclosure> angle = angle_bounds(left, right);
    return angle ? std::optional<Measure>(Measure{"angle_degrees", *angle}) : std::nullopt;
  }

  // The lines of an element begin with this name; names from outside must not look like lines.
  std::string name(const Drawing_element& element) const {
    return GC::printable((several_ ? element.file + ": " : "") + element.text());
  }

  std::map<int, std::size_t> counts() const { return summary_.counts(GC::Continuity_kind::G); }

  std::size_t count(GC::Visual_class grade) const {
    const auto found = grades_.find(grade);
    return found == grades_.end() ? 0 : found->second;
  }

  std::string text_summary() const {
    std::ostringstream os;
    os << counted(joins_, "join") << " in " << counted(subpaths_, "subpath");
    const char* separator = ": ";
    for (const auto& [order, count] : counts()) {
      os << separator << count << " G" << order << (order == max_order_ ? " or more" : "");
      separator = ", ";
    }
    if (undecided_ != 0) os << separator << undecided_ << " undecided";
    if (not_read_ != 0) os << "; " << counted(not_read_, "element") << " not verified";
    if (joins_ != 0)
      os << "; drawn as " << counted(count(GC::Visual_class::corner), "corner") << ", "
         << counted(count(GC::Visual_class::kink), "kink") << " of at most " << kinks_.degrees << " degrees, "
         << count(GC::Visual_class::g1) << " G1, " << count(GC::Visual_class::g2) << " G2 or more";
    if (bound_) os << "; " << counted(segments_, "curve");
    if (left_out_ != 0) os << "; " << counted(left_out_, "segment") << " without length left out";
    if (rounding_ != 0)
      os << "; rounding at " << counted(rounding_, "join") << ": " << counted(looked_through_, "segment")
         << " looked through";
    os << '\n';
    return os.str();
  }

  std::string json_summary() const {
    std::ostringstream os;
    os << "\"summary\":{\"joins\":" << joins_ << ",\"subpaths\":" << subpaths_;
    for (const auto& [order, count] : counts()) os << ",\"G" << order << "\":" << count;
    os << ",\"undecided\":" << undecided_ << ",\"corners\":" << count(GC::Visual_class::corner)
       << ",\"kinks\":" << count(GC::Visual_class::kink) << ",\"left_out\":" << left_out_
       << ",\"rounding\":" << rounding_ << ",\"looked_through\":" << looked_through_;
    if (bound_) os << ",\"curves\":" << segments_ << ",\"bent_curves\":" << bent_;
    os << '}';
    return os.str();
  }
};

} // namespace

int verify_drawings(const Arguments& files, int max_order, const Report_mode& mode,
                    const std::optional<Requirement>& required, const Kink_rule& kinks,
                    const std::optional<Curvature_bound>& bound) {
  if (required) required->check_dimension(2);
  Drawing_report report(max_order, mode, files, required, kinks, bound);
  report.read(files);
  return report.print(std::cout);
}
