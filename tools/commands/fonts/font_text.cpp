// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>

namespace {

typedef std::vector<std::string> Row;

Row row(const Shown_join& join) {
  const Join_numbers numbers(join);
  Row cells{join.glyph_name + (join.part_name.empty() ? "" : ", component " + join.part_name) +
                (join.copies == 0 ? "" : " and " + std::to_string(join.copies) + " more"),
            std::to_string(join.contour), std::to_string(join.node), '(' + numbers.x + ", " + numbers.y + ')'};
  if (join.grade != Glyph_grade::g1) {
    const std::string offset = rounded(numbers.units, 2);
    cells.push_back(rounded(numbers.degrees.upper, 3) + " degrees" +
                    (join.grade == Glyph_grade::bend ? ", of two lines" : ""));
    cells.push_back(offset + (offset == "1" ? " unit" : " units"));
    cells.push_back(rounded(numbers.per_mille, 3));
  } else {
    cells.push_back("none, " + to_string(join.grade));
    cells.insert(cells.end(), 2, "");
  }
  cells.push_back(join.font_name);
  return cells;
}

} // namespace

std::string joins_table(const std::vector<Shown_join>& joins, bool names_fonts) {
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

// E.g. "84 joins: 20 corners, 2 kinks (1 off by more than one unit), 1 bend of two lines, 9 off by
// rounding, 20 G1, 32 G2 or more"
std::string counts_text(const Join_counts& joins) {
  std::string text = counted(joins.joins(), "join");
  if (joins.joins() == 0) return text;
  text += ": " + counted(joins[Glyph_grade::corner], "corner") + ", " + counted(joins[Glyph_grade::kink], "kink");
  const std::size_t off = joins.off_by_more_than_one_unit();
  if (off != 0 && off != joins[Glyph_grade::kink] + joins[Glyph_grade::bend])
    text += " (" + std::to_string(off) + " off by more than one unit)";
  if (joins[Glyph_grade::bend] != 0) text += ", " + counted(joins[Glyph_grade::bend], "bend") + " of two lines";
  if (joins[Glyph_grade::rounding] != 0)
    text += ", " + std::to_string(joins[Glyph_grade::rounding]) + " off by rounding";
  return text + ", " + std::to_string(joins[Glyph_grade::g1]) + " G1, " + std::to_string(joins[Glyph_grade::g2]) +
         " G2 or more";
}

std::string counts_text(const Font_counts& counts) {
  return counted(counts.glyphs, "glyph") + (counts.empty != 0 ? " (" + std::to_string(counts.empty) + " empty)" : "") +
         ", " + counts_text(counts.joins);
}

std::string counts_text(const Fonts_result& all) {
  return counted(all.fonts, "font") + ", " + counts_text(all.counts) +
         (all.unread.empty() ? "" : "; " + std::to_string(all.unread.size()) + " not verified");
}
