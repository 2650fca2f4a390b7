// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H

#include "commands/chains/join_report.h"
#include "commands/commands.h"
#include "commands/fonts/Graded_joins.h"
#include "formats/font/font_files.h"
#include "reports/Finding_writer.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// How much was found in a font, or in several.
struct Font_counts {
  std::size_t glyphs = 0; // that were read
  std::size_t empty = 0;  // those of them that draw nothing, such as the space
  Join_counts joins;

  Font_counts& operator+=(const Font_counts& x) {
    glyphs += x.glyphs;
    empty += x.empty;
    joins += x.joins;
    return *this;
  }
};

// A glyph that could not be read.
struct Unread_glyph {
  int index;
  std::string name, reason;
};

// A font, and what was found in it.
struct Font_result {
  std::string file;          // as messages name it
  std::optional<int> number; // among several of the file
  bool is_alone;             // nothing else was to be read
  std::string name;          // of family and style
  int units_per_em;
  Font_counts counts = {};
  std::vector<Unread_glyph> unread = {};
  Arguments missing = {}; // glyphs that were asked for
  std::vector<Shown_join> worst = {};
};

// What was found in all fonts.
struct Fonts_result {
  std::size_t fonts = 0, unread_glyphs = 0, missing = 0;
  Font_counts counts = {};
  std::vector<Unread_file> unread = {};
  std::vector<Shown_join> worst = {};
};

// Writes what was found, in one of the formats of reports, when all fonts have been read.
class Font_report {
protected:
  const Report_mode mode_;
  const std::optional<GC::Join_grade> required_;

  bool fails(const Join_counts& joins) const { return required_ && joins.below(*required_) != 0; }

public:
  Font_report(const Report_mode& mode, const std::optional<GC::Join_grade>& required)
      : mode_(mode), required_(required) {}
  virtual ~Font_report() = default;

  Old_conclusion conclusion(const Fonts_result& all) const {
    return {all.counts.joins.joins(), required_ ? all.counts.joins.below(*required_) : 0,
            all.unread.size() + all.unread_glyphs + all.missing};
  }

  // Whether glyph() wants the worst joins of each glyph; otherwise end_font() wants those of the font.
  virtual bool is_by_glyph() const { return false; }

  virtual void begin_font(const Font_result&) {}
  virtual void glyph(int /*index*/, const std::string& /*name*/, const Join_counts&,
                     const std::vector<Shown_join>& /*worst*/) {}
  virtual void end_font(const Font_result&) = 0;
  virtual void print(std::ostream& os, const Fonts_result& all) = 0;
};

// Returns the report in the format of the mode.
std::unique_ptr<Font_report> font_report(const Report_mode& mode, const std::optional<GC::Join_grade>& required);

// The reports of the formats.
std::unique_ptr<Font_report> font_text(const Report_mode& mode, const std::optional<GC::Join_grade>& required);
std::unique_ptr<Font_report> font_json(const Report_mode& mode, const std::optional<GC::Join_grade>& required);
std::unique_ptr<Font_report> font_findings(const Report_mode& mode, const std::optional<GC::Join_grade>& required);

// What the numbers of a join are in a report: coordinates and offset in units of the font.
struct Join_numbers {
  std::string x, y;
  GC::Enclosure degrees;
  double units, per_mille;

  explicit Join_numbers(const Shown_join& join);
};

// Returns the members of a JSON object about what was found, e.g. "glyphs":5,"empty":1,"joins":84,"corners":20,...
std::string json_members(const Join_counts& counts);
std::string json_members(const Font_counts& counts);
std::string json_members(const Shown_join& join);

std::string json_string(const std::string& text);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_FONT_REPORT_H
