// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"
#include "files/deferred_output.h"

#include <CGAL/Geometric_continuity/IO/printable.h>

#include <algorithm>

namespace {

constexpr std::size_t most_reasons = 10; // for the glyphs of one font

typedef std::vector<std::string> Row;

Row row(const Shown_join& join) {
  const Join_numbers numbers(join);
  Row cells{join.glyph_name + (join.copies == 0 ? "" : " and " + std::to_string(join.copies) + " more"),
            std::to_string(join.contour), std::to_string(join.node), '(' + numbers.x + ", " + numbers.y + ')'};
  if (join.grade == GC::Join_grade::kink) {
    const std::string offset = rounded(numbers.units, 2);
    cells.push_back(rounded(numbers.degrees.upper, 3) + " degrees");
    cells.push_back(offset + (offset == "1" ? " unit" : " units"));
    cells.push_back(rounded(numbers.per_mille, 3));
  } else {
    cells.push_back("none, " + to_string(join.grade));
    cells.insert(cells.end(), 2, "");
  }
  cells.push_back(join.font_name);
  return cells;
}

// The lines of a table. Names the fonts if they are several.
std::string table(const std::vector<Shown_join>& joins, bool names_fonts) {
  if (joins.empty()) return "";
  std::vector<Row> rows{{"glyph", "contour", "node", "at", "kink of", "handle off by", "per mille of the em", "font"}};
  for (const Shown_join& join : joins) rows.push_back(row(join));
  std::vector<std::size_t> widths(rows[0].size() - (names_fonts ? 0 : 1), 0);
  for (Row& cells : rows)
    for (std::size_t i = 0; i < widths.size(); ++i) {
      cells[i] = GC::printable(cells[i]);
      widths[i] = (std::max)(widths[i], cells[i].size());
    }
  std::string text;
  for (const Row& cells : rows) {
    text += "    ";
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += cells[i] + std::string(widths[i] - cells[i].size() + 2, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

// E.g. "3 glyphs, 84 joins: 20 corners, 2 kinks (1 off by more than one unit), 30 G1, 32 G2 or more".
std::string counts_text(const Font_counts& counts) {
  const Join_counts& joins = counts.joins;
  std::string text = counted(counts.glyphs, "glyph");
  if (counts.empty != 0) text += " (" + std::to_string(counts.empty) + " empty)";
  text += ", " + counted(joins.joins(), "join");
  if (joins.joins() == 0) return text;
  text += ": " + counted(joins[GC::Join_grade::corner], "corner") + ", " + counted(joins[GC::Join_grade::kink], "kink");
  if (joins.off_by_more_than_one_unit() != 0)
    text += " (" + std::to_string(joins.off_by_more_than_one_unit()) + " off by more than one unit)";
  return text + ", " + std::to_string(joins[GC::Join_grade::g1]) + " G1, " + std::to_string(joins[GC::Join_grade::g2]) +
         " G2 or more";
}

class Font_text : public Font_report {
  Deferred_output out_;

public:
  using Font_report::Font_report;

  void end_font(const Font_result& font) override {
    const std::string file = font.file + (font.number ? ", font " + std::to_string(*font.number) : "");
    std::string text =
        GC::printable(font.name.empty() ? file : font.name + ", " + file) + "\n  " + counts_text(font.counts) + '\n';
    for (std::size_t i = 0; i < (std::min)(font.unread.size(), most_reasons); ++i)
      text += "  " + GC::printable("glyph " + font.unread[i].name + ": not verified, " + font.unread[i].reason) + '\n';
    if (font.unread.size() > most_reasons)
      text += "  " + counted(font.unread.size() - most_reasons, "more glyph") + " not verified\n";
    for (const std::string& glyph : font.missing) text += "  " + GC::printable("not in this font: " + glyph) + '\n';
    if (!mode_.summary || fails(font.counts.joins)) text += table(font.worst, false);
    out_.write(text);
  }

  void print(std::ostream& os, const Fonts_result& all) override {
    out_.copy_to(os);
    for (const Unread_file& file : all.unread)
      os << GC::printable(file.name + ": not verified, " + file.reason) << '\n';
    if (all.fonts != 1 || !all.unread.empty()) {
      os << counted(all.fonts, "font") << ", " << counts_text(all.counts);
      if (!all.unread.empty()) os << "; " << all.unread.size() << " not verified";
      os << '\n';
      if (!mode_.summary || fails(all.counts.joins)) os << table(all.worst, true);
    }
    const Old_conclusion end = conclusion(all);
    if (end.decided == 0)
      os << "no join, nothing was decided\n";
    else if (required_ && end.failing == 0)
      os << "every join that is no corner is " << *required_ << ", proved exactly\n";
    else if (required_)
      os << end.failing << " of them not " << *required_ << '\n';
    if (!mode_.allow_undecided && end.unverified > 0) os << "not met, because not all was verified\n";
  }
};

} // namespace

std::unique_ptr<Font_report> font_text(const Report_mode& mode, const std::optional<GC::Join_grade>& required) {
  return std::make_unique<Font_text>(mode, required);
}
