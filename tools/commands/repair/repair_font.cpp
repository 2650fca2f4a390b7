// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_font.h"

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

// Repairs glyph after glyph.
class Font_mender {
  const Repair_options& options_;
  std::ostringstream moves_, unrepaired_;
  std::size_t moved_ = 0, glyphs_ = 0, glyphs_with_kinks_ = 0, repaired_glyphs_ = 0, unread_ = 0, left_ = 0, lost_ = 0;
  GC::Enclosure largest_{0, 0};
  std::string largest_glyph_;
  Grade_counts before_, after_;
  std::string font_;                              // a member of the objects of JSON, where there are several fonts
  std::map<int, std::vector<std::string>> users_; // of components: the glyphs that consist of them
  std::size_t composites_ = 0;
  Claims claims_; // of glyphs that cannot be read

  // A contour of a glyph, and the glyphs in which it is drawn as well. Names of glyphs may occur twice, their numbers do not.
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

  void repair_glyph(int index, const std::string& name, const std::vector<std::string>& users,
                    const Glyph_outline& outline) {
    bool kinks = false, all = true;
    for (std::size_t i = 0; i < outline.contours(); ++i) {
      Grid_contour contour = grid_contour(outline, i);
      const Grade_counts before = grades(contour, options_.bound);
      const bool has_kinks = before.count(GC::Join_grade::kink) != 0;
      add(before_, before);
      if (has_kinks || options_.harmonise) note({index, name, i, users}, contour, ::repair(contour, options_));
      const Grade_counts after = grades(contour, options_.bound);
      add(after_, after);
      kinks = kinks || has_kinks;
      all = all && after.count(GC::Join_grade::kink) == 0;
    }
    glyphs_with_kinks_ += kinks;
    repaired_glyphs_ += kinks && all;
  }

  static void add(Grade_counts& sum, const Grade_counts& counts) {
    for (const auto& [grade, count] : counts) sum[grade] += count;
  }

  void note(const Place& place, const Grid_contour& contour, const Contour_repair& done) {
    std::vector<std::size_t> first{0}; // the number of the first point of each curve among those of the contour
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
    for (const Unrepaired_join& x : done.unrepaired) {
      begin(unrepaired_, left_++, place) << ",\"node\":" << pair(contour, contour.curves[x.join].points.back())
                                         << ",\"reason\":";
      GC::write_json(unrepaired_, x.reason);
      unrepaired_ << '}';
    }
  }

  static std::size_t kinks(const Grade_counts& counts) {
    return counts.count(GC::Join_grade::kink) != 0 ? counts.at(GC::Join_grade::kink) : 0;
  }

public:
  explicit Font_mender(const Repair_options& options) : options_(options) {}

  void repair(const Font_face& font, const std::string& member) {
    font_ = member;
    users_.clear();
    for (int glyph = 0; glyph < font.glyphs(); ++glyph)
      for (const int component : components(font, glyph)) users_[component].push_back(font.glyph_name(glyph));
    Progress progress("glyphs");
    Glyph_outline outline;
    for (int glyph = 0; glyph < font.glyphs(); ++glyph) {
      try {
        font.read(glyph, outline);
        const bool is_composite = !components(font, glyph).empty();
        if (!is_composite && outline.steps() != 2) throw Font_error("fractions of a unit, no grid to move handles on");
        ++glyphs_;
        if (is_composite)
          ++composites_;
        else
          repair_glyph(glyph, font.glyph_name(glyph), users_[glyph], outline);
      } catch (const Font_error& error) {
        ++unread_;
        claims_.add({Claim::not_covered, "glyph", error.what()});
      }
      progress.step(static_cast<std::size_t>(glyph), [&] { return double(glyph) / font.glyphs(); });
    }
  }

  Font_repair result() const {
    std::ostringstream text;
    text << counted(glyphs_, "glyph") << ", " << glyphs_with_kinks_ << " with kinks, of which " << repaired_glyphs_
         << (repaired_glyphs_ == 1 ? " is" : " are") << " repaired as a whole";
    if (composites_ != 0) text << "; " << composites_ << " consist of components, which are decided once";
    text << "\nkinks: " << kinks(before_) << " before, " << kinks(after_)
         << " after the moves\nmoves: " << counted(moved_, "handle");
    if (moved_ != 0) text << ", at most " << units(largest_) << ", in the glyph " << GC::printable(largest_glyph_);
    text << '\n';
    if (lost_ != 0) text << counted(lost_, "join") << (lost_ == 1 ? " falls" : " fall") << " from G2 to G1\n";
    Claims claims = claims_;
    for (const auto& [grade, count] : after_)
      claims.add({grade == GC::Join_grade::kink ? Claim::not_met : Claim::met, "join"}, count);
    return {"{\"moves\":[" + moves_.str() + "],\n \"not_repaired\":[" + unrepaired_.str() + "]}\n", text.str(), claims};
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

Font_repair repair_font(const std::string& bytes, const std::string& name, const Repair_options& options) {
  Font_mender mender(options);
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
