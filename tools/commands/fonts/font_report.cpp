// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <sstream>

namespace {

Report_subject subject(const Font_requirement& required, const std::optional<Curvature_bound>& bound) {
  Report_subject subject{"join", "every join but corners, bends of two lines and what is off by at most " +
                                     required.off_by + (required.off_by == "1" ? " unit" : " units")};
  subject.required = required.text;
  subject.required_in_json = required.json;
  if (bound) demand_curvature(subject, *bound);
  return subject;
}

Finding finding(const std::string& file, const std::string& place, Finding_rule rule, const std::string& message,
                const std::string& properties) {
  Finding f{};
  f.file = file;
  f.kind = "glyph";
  f.place = place;
  f.rule = rule;
  f.message = message;
  f.properties = properties;
  return f;
}

std::string message(const Shown_join& join, const Join_numbers& numbers) {
  const std::string at = " at (" + numbers.x + ", " + numbers.y + ")",
                    more = join.copies == 0 ? "" : "; and " + std::to_string(join.copies) + " more like this";
  if (join.grade == Glyph_grade::g1) return to_string(join.grade) + at + ", the curvature jumps" + more;
  const bool is_kink = join.grade == Glyph_grade::kink;
  return (is_kink ? "kink of " : "bend of two lines of ") + rounded(numbers.degrees.upper, 3) + " degrees" + at +
         (is_kink ? ", a handle is off by " : ", off by ") + rounded(numbers.units, 2) + " units, " +
         rounded(numbers.per_mille, 3) + " per mille of the em" + more;
}

// Describes the defect in units of the font relative to the node: a kink by both handles, and a
// jump of the curvature by both segments.
std::string shape(const Shown_join& join) {
  const double steps = static_cast<double>(join.steps);
  std::string text;
  const auto add = [&](std::int64_t x, std::int64_t y) {
    text += ' ' + rounded(static_cast<double>(x) / steps, 17) + ',' + rounded(static_cast<double>(y) / steps, 17);
  };
  if (join.grade != Glyph_grade::g1) {
    const Glyph_join glyph_join(join.left, join.right, join.steps);
    const auto &incoming = glyph_join.on_grid().incoming(), &outgoing = glyph_join.on_grid().outgoing();
    add(-incoming[0], -incoming[1]);
    add(outgoing[0], outgoing[1]);
    return text;
  }
  for (const Glyph_segment* segment : {&join.left, &join.right}) {
    text += ';';
    for (std::size_t i = 0; i <= static_cast<std::size_t>(segment->degree); ++i)
      add(segment->points[i].x - join.right.start().x, segment->points[i].y - join.right.start().y);
  }
  return text;
}

std::optional<Measure> measure(const Shown_join& join, const Join_numbers& numbers) {
  if (join.grade != Glyph_grade::g1) return Measure{"angle_degrees", numbers.degrees};
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Kernel;
  const auto curve = [](const Glyph_segment& segment) {
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(segment.degree); ++i)
      points.emplace_back(static_cast<double>(segment.points[i].x), static_cast<double>(segment.points[i].y));
    return GC::Bezier_curve<GC::Traits_2<Kernel>>(points);
  };
  const std::optional<GC::Enclosure> jump = GC::deviation(curve(join.left), curve(join.right)).curvature_jump;
  return jump ? std::optional<Measure>(Measure{"curvature_jump", *jump}) : std::nullopt;
}

} // namespace

Given not_covered(const char* noun, const std::string& reason) {
  const std::string prefix = "not covered: ";
  return {Claim::not_covered, noun, reason.rfind(prefix, 0) == 0 ? reason.substr(prefix.size()) : reason};
}

Join_numbers::Join_numbers(const Shown_join& join)
    : x(rounded(static_cast<double>(join.right.start().x) / static_cast<double>(join.steps), 10)),
      y(rounded(static_cast<double>(join.right.start().y) / static_cast<double>(join.steps), 10)) {
  const GC::Kink_size size = Glyph_join(join.left, join.right, join.steps).on_grid().kink_size();
  degrees = GC::in_degrees(size.angle);
  units = size.handle_offset.upper / static_cast<double>(join.steps);
  per_mille = 1000 * join.severity;
}

Font_report::Font_report(const Report_mode& mode, const Font_requirement& required,
                         const std::optional<Curvature_bound>& bound)
    : is_json_(mode.format == Report_format::json), is_short_(mode.summary), required_(required.text),
      report_(mode, subject(required, bound)), bound_(bound) {
  if (bound && is_json_) report_.row("bent_curves");
}

void Font_report::begin_font(const Font_result& font) {
  is_alone_ = font.is_alone;
  has_glyph_ = false;
  glyphs_.clear();
  bent_rows_.clear();
  curves_ = bent_ = 0;
  report_.begin_file(font.file);
  if (is_json_) report_.row(is_alone_ ? "glyphs" : "fonts");
}

void Font_report::glyph(int index, const std::string& name, const Join_counts& joins,
                        const std::vector<Shown_join>& worst) {
  if (is_short_ && joins.failing() == 0) return;
  std::vector<std::string> objects;
  for (const Shown_join& join : worst) objects.push_back('{' + json_members(join) + '}');
  const std::string row = "{\"index\":" + std::to_string(index) + ",\"name\":" + json_text(name) + ',' +
                          json_members(joins) + ",\"worst\":" + json_array(objects) + '}';
  if (is_alone_)
    report_.row("glyphs", ",\n " + row);
  else
    glyphs_ += (std::exchange(has_glyph_, true) ? ",\n " : "\n ") + row;
}

void Font_report::bounded_curve(const Font_result& font) {
  ++curves_;
  report_.add(font.file, {Claim::met, "curve"});
}

void Font_report::bent_curve(const Font_result& font, const Bent_segment& segment) {
  ++curves_;
  ++bent_;
  const std::string place = (font.number ? "font " + std::to_string(*font.number) + ", " : "") +
                            join_place(segment.glyph, segment.component, segment.contour, segment.node),
                    words = "the segment from there on has " + to_string(segment.excess);
  const auto members = [&] {
    std::ostringstream os;
    os << "\"glyph\":" << json_text(segment.glyph);
    if (!segment.component.empty()) os << ",\"component\":" << json_text(segment.component);
    os << ",\"contour\":" << segment.contour << ",\"node\":" << segment.node << ',';
    write_json_members(os, segment.excess);
    return os.str();
  };
  report_.add(font.file, {Claim::not_met, "curve"}, false, [&] {
    Finding f = finding(font.file, place, Finding_rule::bend, "not " + bound_->words + ": " + words, members());
    f.shape = to_string(segment.excess);
    if (!segment.excess.unbounded) f.measure = Measure{"curvature", size_of(segment.excess)};
    return f;
  });
  if (is_json_)
    report_.row("bent_curves", ",\n {\"file\":" + json_text(font.file) +
                                   (font.number ? ",\"font\":" + std::to_string(*font.number) : "") + ',' + members() +
                                   '}');
  else
    bent_rows_ += "  " + GC::printable(place) + ": " + words + '\n';
}

std::string Font_report::curves_text(std::size_t curves, std::size_t bent) const {
  return bound_ ? "; " + counted(curves, "curve") + ", " + std::to_string(bent) + " not " + bound_->words : "";
}
std::string Font_report::curves_json(std::size_t curves, std::size_t bent) const {
  return bound_ ? ",\"curves\":" + std::to_string(curves) + ",\"bent_curves\":" + std::to_string(bent) : "";
}

void Font_report::end_font(const Font_result& font) {
  all_curves_ += curves_;
  all_bent_ += bent_;
  const Join_counts& joins = font.counts.joins;
  if (report_.mode().has_findings())
    add_findings(font, font.number ? "font " + std::to_string(*font.number) + ", " : "");
  else {
    report_.add(font.file, {Claim::met, "join"}, joins.joins() - joins.failing());
    report_.add(font.file, {Claim::not_met, "join"}, joins.failing());
    for (const Unread_glyph& glyph : font.unread) report_.add(font.file, not_covered("glyph", glyph.reason));
    for (std::size_t i = 0; i < font.missing.size(); ++i)
      report_.add(font.file, not_covered("glyph", "not in this font"));
    add_rows(font);
  }
}

// Each join has a finding; with --worst another one tells how many more there are.
void Font_report::add_findings(const Font_result& font, const std::string& place) {
  const Join_counts& joins = font.counts.joins;
  std::size_t told = 0, told_failing = 0;
  for (const Shown_join& join : font.worst) {
    const Join_numbers numbers(join);
    const Given given{join.fails ? Claim::not_met : Claim::met, "join"};
    report_.add(font.file, given, true, [&] {
      Finding f = finding(font.file, place + join_place(join.glyph_name, join.part_name, join.contour, join.node),
                          join.grade == Glyph_grade::g1 ? Finding_rule::curvature : Finding_rule::kink,
                          message(join, numbers), json_members(join));
      f.shape = shape(join);
      f.measure = measure(join, numbers);
      return f;
    });
    ++told;
    told_failing += join.fails;
  }
  const std::size_t more = joins.failing() - told_failing;
  if (more > 0) {
    report_.add(font.file, {Claim::not_met, "join"}, true, [&] {
      return finding(font.file, place + font.name, Finding_rule::kink,
                     counted(more, "more join") + " not " + required_ + "; --worst N tells N of them",
                     "\"joins\":" + std::to_string(more));
    });
    report_.add(font.file, {Claim::not_met, "join"}, more - 1);
  }
  report_.add(font.file, {Claim::met, "join"}, joins.joins() - told - more);
  const auto not_verified = [&](const std::string& glyph, const std::string& reason) {
    report_.add(font.file, not_covered("glyph", reason), true, [&] {
      Finding f =
          finding(font.file, place + "glyph " + glyph, Finding_rule::not_verified, "not verified, " + reason, "");
      f.shape = reason;
      return f;
    });
  };
  for (const Unread_glyph& glyph : font.unread) not_verified(glyph.name, glyph.reason);
  for (const std::string& glyph : font.missing) not_verified(glyph, "not in this font");
}

void Font_report::add_rows(const Font_result& font) {
  if (is_json_ && is_alone_) {
    report_.row("not_verified", font.unread.empty() ? "" : ',' + json_unread(font.unread));
    std::string missing;
    for (const std::string& name : font.missing) missing += ',' + json_text(name);
    report_.row("not_found", missing);
    alone_ = json_members(font, curves_json(curves_, bent_));
    return;
  }
  if (is_json_) {
    std::vector<std::string> missing;
    for (const std::string& name : font.missing) missing.push_back(json_text(name));
    report_.row("fonts", ",\n{\"file\":" + json_text(font.file) +
                             (font.number ? ",\"font\":" + std::to_string(*font.number) : "") + ",\"glyphs\":[" +
                             glyphs_ + "],\n \"not_verified\":[" + json_unread(font.unread) + "],\"not_found\":" +
                             json_array(missing) + ",\n " + json_members(font, curves_json(curves_, bent_)) + '}');
    return;
  }
  constexpr std::size_t most_reasons = 10; // for the glyphs of one font
  const std::string file = font.file + (font.number ? ", font " + std::to_string(*font.number) : "");
  std::string text = GC::printable(font.name.empty() ? file : font.name + ", " + file) + "\n  " +
                     counts_text(font.counts) + curves_text(curves_, bent_) + '\n';
  for (std::size_t i = 0; i < (std::min)(font.unread.size(), most_reasons); ++i)
    text += "  " + GC::printable("glyph " + font.unread[i].name + ": not verified, " + font.unread[i].reason) + '\n';
  if (font.unread.size() > most_reasons)
    text += "  " + counted(font.unread.size() - most_reasons, "more glyph") + " not verified\n";
  for (const std::string& glyph : font.missing) text += "  " + GC::printable("not in this font: " + glyph) + '\n';
  if (!is_short_ || font.counts.joins.failing() != 0) text += joins_table(font.worst, false);
  report_.row("", text + bent_rows_);
}

int Font_report::print(std::ostream& os, const Fonts_result& all) {
  for (const Unread_file& file : all.unread)
    report_.add(file.name, not_covered("font", file.reason), true, [&] {
      Finding f = finding(file.name, "font", Finding_rule::not_verified, "not verified, " + file.reason, "");
      f.kind = "font";
      return f;
    });
  std::string summary;
  if (is_json_ && is_alone_ && !report_.mode().has_findings())
    summary = alone_;
  else if (report_.mode().format != Report_format::text) {
    if (is_json_) {
      report_.row("fonts");
      report_.row("not_verified");
      for (const Unread_file& file : all.unread)
        report_.row("not_verified",
                    ",\n {\"file\":" + json_text(file.name) + ",\"reason\":" + json_text(file.reason) + '}');
    }
    summary = "\"summary\":{\"fonts\":" + std::to_string(all.fonts) + ',' + json_members(all.counts) +
              curves_json(all_curves_, all_bent_) + '}';
  } else {
    for (const Unread_file& file : all.unread)
      summary += GC::printable(file.name + ": not verified, " + file.reason) + '\n';
    if (all.fonts != 1 || !all.unread.empty()) {
      summary += counts_text(all) + curves_text(all_curves_, all_bent_) + '\n';
      if (!is_short_ || all.counts.joins.failing() != 0) summary += joins_table(all.worst, true);
    }
  }
  return report_.print(os, summary);
}
