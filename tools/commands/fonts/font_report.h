// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H

#include "commands/chains/curvature_bound.h"
#include "commands/commands.h"
#include "commands/fonts/read_fonts.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// The requirement on the joins of fonts, in words.
struct Font_requirement {
  std::string text, json; // e.g. "G1", `"required":"G1"`; empty when nothing is required
  std::string off_by;     // as it was given: up to so many units it is rounding
};

// A glyph or a font that could not be read.
Given not_covered(const char* noun, const std::string& reason);

// A segment that exceeds the bound on the curvature.
struct Bent_segment {
  std::string glyph, component; // the latter empty for what the glyph draws itself
  std::size_t contour, node;    // at which it starts
  GC::Curvature_excess excess;
};

// The report about fonts. Where many joins are equal, one row tells of all.
class Font_report {
  const bool is_json_, is_short_;
  bool is_alone_ = false;
  const std::string required_;
  Report report_;
  std::string glyphs_; // in JSON, the rows of a font among several
  std::string alone_;  // the members of the only font
  bool has_glyph_ = false;
  const std::optional<Curvature_bound> bound_;
  std::size_t curves_ = 0, bent_ = 0, all_curves_ = 0, all_bent_ = 0; // of the font, of all
  std::string bent_rows_;                                             // of the font, in text

public:
  Font_report(const Report_mode& mode, const Font_requirement& required, const std::optional<Curvature_bound>& bound);

  // Returns whether glyph() wants the worst joins of each glyph; otherwise end_font() wants those
  // of the font.
  bool is_by_glyph() const { return is_json_ && !has_findings(); }

  // Returns whether each join has a finding of its own, also where several are equal.
  bool has_findings() const { return report_.mode().has_findings(); }

  void begin_font(const Font_result& font);
  void glyph(int index, const std::string& name, const Join_counts& joins, const std::vector<Shown_join>& worst);
  // A segment meets the bound on the curvature, or exceeds it.
  void bounded_curve(const Font_result& font);
  void bent_curve(const Font_result& font, const Bent_segment& segment);
  void end_font(const Font_result& font);

  // Prints the report and returns the exit code.
  int print(std::ostream& os, const Fonts_result& all);

private:
  void add_findings(const Font_result& font, const std::string& place);
  void add_rows(const Font_result& font);
  std::string curves_text(std::size_t curves, std::size_t bent) const;
  std::string curves_json(std::size_t curves, std::size_t bent) const;
};

// The numbers of a join in a report: coordinates and offset in units of the font.
struct Join_numbers {
  std::string x, y;
  GC::Enclosure degrees;
  double units, per_mille;

  explicit Join_numbers(const Shown_join& join);
};

// Returns the members of a JSON object about what was found, e.g.
// "glyphs":5,"empty":1,"joins":84,"corners":20,...
std::string json_members(const Join_counts& counts);
std::string json_members(const Font_counts& counts);
std::string json_members(const Shown_join& join);

// Returns the members of the object of a font behind its glyphs, with the arrays of what could not
// be verified, if it is one among several.
std::string json_unread(const std::vector<Unread_glyph>& glyphs);
// `more` follows the members of the summary.
std::string json_members(const Font_result& font, const std::string& more);

// Returns lines for people: about joins, about a font, and the table of the worst joins, which
// names fonts if they are several.
std::string counts_text(const Join_counts& joins);
std::string counts_text(const Font_counts& counts);
std::string counts_text(const Fonts_result& all);
std::string joins_table(const std::vector<Shown_join>& joins, bool names_fonts);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H
