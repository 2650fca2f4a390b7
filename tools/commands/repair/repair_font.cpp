// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_font.h"

#include "commands/fonts/Graded_joins.h"
#include "commands/fonts/font_report.h"
#include "files/progress.h"
#include "formats/font/Font_face.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace {

std::string pair(const Grid_contour& contour, const GC::Grid_vector& p) {
  return '[' + contour.text(p.x) + ',' + contour.text(p.y) + ']';
}

// A segment of a contour that grid_contour() has made.
Glyph_segment glyph_segment(const Grid_contour& contour, std::size_t curve) {
  const std::vector<GC::Grid_vector>& points = contour.curves[curve].points;
  Glyph_segment segment{static_cast<int>(points.size()) - 1, {}};
  for (std::size_t i = 0; i < points.size(); ++i)
    segment.points[i] = contour.decimals == 1 ? Glyph_point{points[i].x / 5, points[i].y / 5}
                                              : Glyph_point{2 * points[i].x, 2 * points[i].y};
  return segment;
}

void add(Glyph_outline& outline, const Grid_contour& contour) {
  for (std::size_t i = 0; i < contour.curves.size(); ++i) outline.add(glyph_segment(contour, i));
  outline.end_contour();
}

// Repairs glyph after glyph.
class Font_mender {
  const Repair_options& options_;
  const Join_rule rule_;
  std::ostringstream moves_, unrepaired_;
  std::size_t moved_ = 0, glyphs_ = 0, glyphs_with_kinks_ = 0, repaired_glyphs_ = 0, left_ = 0, lost_ = 0;
  GC::Enclosure largest_{0, 0};
  std::string largest_glyph_;
  Join_counts before_, after_; // but for those of glyphs that are left alone
  Join_counts left_alone_;     // of glyphs without a grid
  // a member of the objects of JSON, where there are several fonts
  std::string font_;
  std::map<int, std::vector<std::string>> users_; // of components: the glyphs that consist of them
  std::map<int, Glyph_outline> mended_;           // glyphs of which a handle has moved
  std::size_t composites_ = 0;
  Claims claims_; // of glyphs that cannot be read

  // A contour of a glyph, and the glyphs in which it is drawn as well. Names of glyphs may occur
  // twice, their numbers do not.
  struct Place {
    int index;
    std::string glyph;
    std::size_t contour;
    std::vector<std::string> users;
  };

  std::ostream& begin(std::ostringstream& os, std::size_t number, const Place& place) const {
    os << (number == 0 ? "\n {" : ",\n {") << font_ << "\"glyph\":" << json_text(place.glyph)
       << ",\"index\":" << place.index;
    if (!place.users.empty()) {
      std::vector<std::string> names;
      for (const std::string& name : place.users) names.push_back(json_text(name));
      os << ",\"used_by\":" << json_array(names);
    }
    return os << ",\"contour\":" << place.contour;
  }

  // The components of a glyph, each once; none of one that cannot be read.
  static std::set<int> components(const Font_face& font, int glyph) {
    try {
      return font.components(glyph);
    } catch (const Font_error&) {
      return {};
    }
  }

  Join_counts counts(const Glyph_outline& outline) const {
    return grade_joins(outline, rule_, [](auto&&...) {});
  }

  // Counts the joins of a glyph before and after the moves.
  void count(const Glyph_outline& before, const Glyph_outline& after) {
    const Join_counts given = counts(before), result = counts(after);
    before_ += given;
    after_ += result;
    ++glyphs_;
    const bool has_kinks = given[Glyph_grade::kink] != 0;
    glyphs_with_kinks_ += has_kinks;
    repaired_glyphs_ += has_kinks && result[Glyph_grade::kink] == 0;
  }

  void repair_glyph(int index, const std::string& name, const std::vector<std::string>& users,
                    const Glyph_outline& outline) {
    const std::size_t moved = moved_;
    Glyph_outline result;
    for (std::size_t i = 0; i < outline.contours(); ++i) {
      Grid_contour contour = grid_contour(outline, i);
      const bool has_kinks = grades(contour, options_.bound).count(GC::Visual_class::kink) != 0;
      if (has_kinks || options_.harmonise) note({index, name, i, users}, contour, ::repair(contour, options_));
      add(result, contour);
    }
    count(outline, result);
    if (moved_ != moved) mended_[index] = std::move(result);
  }

  // Counts the joins of a glyph without a grid, and names those that would be mended.
  void leave_alone(int index, const std::string& name, const std::vector<std::string>& users,
                   const Glyph_outline& outline) {
    const char* const reason = "fractions of a unit, no grid to move handles on";
    claims_.add({Claim::not_covered, "glyph", reason});
    left_alone_ +=
        grade_joins(outline, rule_,
                    [&](std::size_t contour, std::size_t, Glyph_grade grade, bool, const Glyph_join&,
                        const Glyph_segment& left, const Glyph_segment& right) {
                      if (!is_off(grade)) return;
                      const Join_numbers numbers(
                          {index, outline.part(contour), contour, 0, grade, false, 0, 0, left, right, outline.steps()});
                      note_left({index, name, contour, users}, '[' + numbers.x + ',' + numbers.y + ']', reason);
                    });
  }

  void note_left(const Place& place, const std::string& node, const std::string& reason) {
    begin(unrepaired_, left_++, place) << ",\"node\":" << node << ",\"reason\":" << json_text(reason) << '}';
  }

  void note(const Place& place, const Grid_contour& contour, const Contour_repair& done) {
    // the number of the first point of each curve among those of the contour
    std::vector<std::size_t> first{0};
    for (const Grid_curve& curve : contour.curves) first.push_back(first.back() + curve.points.size() - 1);
    for (const Handle_move& m : done.moves) {
      const std::vector<GC::Grid_vector>& points = contour.curves[m.curve].points;
      begin(moves_, moved_++, place) << ",\"point\":" << first[m.curve] + m.point
                                     << ",\"node\":" << pair(contour, m.point == 1 ? points.front() : points.back())
                                     << ",\"from\":" << pair(contour, m.from) << ",\"to\":" << pair(contour, m.to)
                                     << '}';
      if (largest_.upper < m.distance().upper) {
        largest_ = m.distance();
        largest_glyph_ = place.glyph;
      }
    }
    lost_ += done.lost.size();
    for (const Unrepaired_join& x : done.unrepaired)
      note_left(place, pair(contour, contour.curves[x.join].points.back()), x.reason);
  }

  // Counts the joins of glyphs that consist of components, some of which have changed.
  void count_composites(const Font_face& font, const std::vector<int>& composites) {
    Glyph_outline before, after;
    for (const int glyph : composites) {
      font.read(glyph, before);
      font.read(glyph, after, &mended_);
      count(before, after);
    }
    composites_ += composites.size();
  }

public:
  Font_mender(const Repair_options& options, const Handle_rounding& rounding)
      : options_(options), rule_{options.bound, rounding} {}

  void repair(const Font_face& font, const std::string& member) {
    font_ = member;
    users_.clear();
    mended_.clear();
    for (int glyph = 0; glyph < font.glyphs(); ++glyph)
      for (const int component : components(font, glyph)) users_[component].push_back(font.glyph_name(glyph));
    Progress progress("glyphs");
    Glyph_outline outline;
    std::vector<int> composites;
    for (int glyph = 0; glyph < font.glyphs(); ++glyph) {
      try {
        font.read(glyph, outline);
        if (!components(font, glyph).empty())
          composites.push_back(glyph);
        else if (outline.steps() != 2)
          leave_alone(glyph, font.glyph_name(glyph), users_[glyph], outline);
        else
          repair_glyph(glyph, font.glyph_name(glyph), users_[glyph], outline);
      } catch (const Font_error& error) {
        claims_.add({Claim::not_covered, "glyph", error.what()});
      }
      progress.step(static_cast<std::size_t>(glyph), [&] { return double(glyph) / font.glyphs(); });
    }
    count_composites(font, composites);
  }

  Font_repair result() const {
    Join_counts before = before_, after = after_;
    before += left_alone_;
    after += left_alone_;
    std::ostringstream text;
    text << counted(glyphs_, "glyph") << ", " << glyphs_with_kinks_ << " with kinks, of which " << repaired_glyphs_
         << (repaired_glyphs_ == 1 ? " is" : " are") << " repaired as a whole";
    if (composites_ != 0) text << "; " << composites_ << " consist of components, whose handles move once";
    text << "\nkinks: " << before[Glyph_grade::kink] << " before, " << after[Glyph_grade::kink]
         << " after the moves\nbefore: " << counts_text(before) << "\nafter:  " << counts_text(after)
         << "\nmoves: " << counted(moved_, "handle");
    if (moved_ != 0) text << ", at most " << units(largest_) << ", in the glyph " << GC::printable(largest_glyph_);
    text << '\n';
    if (lost_ != 0) text << counted(lost_, "join") << (lost_ == 1 ? " falls" : " fall") << " from G2 to G1\n";
    Claims claims = claims_;
    claims.add({Claim::not_met, "join"}, after_[Glyph_grade::kink]);
    claims.add({Claim::met, "join"}, after_.joins() - after_[Glyph_grade::kink]);
    return {"{\"moves\":[" + moves_.str() + "],\n \"not_repaired\":[" + unrepaired_.str() + "],\n \"before\":{" +
                json_members(before) + "},\n \"after\":{" + json_members(after) + "}}\n",
            text.str(), json_members(before), json_members(after), claims};
  }
};

} // namespace

Grid_contour grid_contour(const Glyph_outline& outline, std::size_t contour) {
  const Glyph_segment *const begin = outline.begin(contour), *const end = outline.end(contour);
  const auto is_odd = [](const Glyph_point& p) { return p.x % 2 != 0 || p.y % 2 != 0; };
  const bool halves = std::any_of(begin, end, [&](const Glyph_segment& s) {
    return std::any_of(s.points.begin(), s.points.begin() + s.degree + 1, is_odd);
  });
  Grid_contour result;
  result.closed = true;
  result.may_leave_nodes_out = true;
  result.decimals = halves ? 1 : 0;
  for (const Glyph_segment* s = begin; s != end; ++s) {
    Grid_curve curve;
    for (int i = 0; i <= s->degree; ++i) {
      const Glyph_point& p = s->points[static_cast<std::size_t>(i)];
      curve.points.push_back(halves ? GC::Grid_vector{5 * p.x, 5 * p.y} : GC::Grid_vector{p.x / 2, p.y / 2});
    }
    curve.fixed = halves;
    result.curves.push_back(curve);
  }
  return result;
}

Font_repair repair_font(const std::string& bytes, const std::string& name, const Repair_options& options,
                        const Handle_rounding& rounding) {
  Font_mender mender(options, rounding);
  try {
    for (int i = 0, fonts = 1; i < fonts; ++i) {
      const Font_face font(bytes, i);
      fonts = font.fonts_of_file();
      if (!font.has_outlines()) throw Font_error("pictures of letters (bitmaps), no outlines");
      mender.repair(font, fonts == 1 ? "" : "\"font\":" + std::to_string(i) + ',');
    }
  } catch (const Font_error& error) {
    throw GC::Error(GC::Error_code::malformed_input, name + ": " + error.what());
  }
  return mender.result();
}
