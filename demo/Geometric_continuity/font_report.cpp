// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "font_report.h"

#include "join_report.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/printable.h>

#include <algorithm>
#include <optional>
#include <sstream>

namespace {

// A coordinate in units of the font, from halves of units.
std::string coordinate(std::int32_t x) { return rounded(x / 2.0, 10); }

typedef std::vector<std::string> Row;

Row row(const Shown_join& join) {
  const Glyph_point& node = join.right.start();
  Row cells{join.glyph_name + (join.copies == 0 ? "" : " and " + std::to_string(join.copies) + " more"),
            std::to_string(join.contour), std::to_string(join.node),
            '(' + coordinate(node.x) + ", " + coordinate(node.y) + ')'};
  if (join.grade == GC::Join_grade::kink) {
    const GC::Kink_size size = Glyph_join(join.left, join.right).size();
    cells.push_back(rounded(GC::in_degrees(size.angle).upper, 3) + " degrees");
    const std::string offset = rounded(size.handle_offset.upper / 2, 2);
    cells.push_back(offset + (offset == "1" ? " unit" : " units"));
    cells.push_back(rounded(1000 * join.severity, 3));
  } else {
    cells.push_back("none, " + to_string(join.grade));
    cells.insert(cells.end(), 2, "");
  }
  cells.push_back(join.font_name);
  return cells;
}

} // namespace

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

std::string counts_json(const Join_counts& counts) {
  return "\"joins\":" + std::to_string(counts.joins()) +
         ",\"corners\":" + std::to_string(counts[GC::Join_grade::corner]) +
         ",\"kinks\":" + std::to_string(counts[GC::Join_grade::kink]) +
         ",\"kinks_off_by_more_than_one_unit\":" + std::to_string(counts.off_by_more_than_one_unit()) +
         ",\"G1\":" + std::to_string(counts[GC::Join_grade::g1]) +
         ",\"G2\":" + std::to_string(counts[GC::Join_grade::g2]);
}

std::string joins_table(const std::vector<Shown_join>& joins, const std::string& indentation, bool names_fonts) {
  if (joins.empty()) return "";
  std::vector<Row> rows{{"glyph", "contour", "node", "at", "kink of", "handle off by", "per mille of the em", "font"}};
  for (const Shown_join& join : joins) rows.push_back(row(join));
  const std::size_t columns = rows[0].size() - (names_fonts ? 0 : 1);
  std::string text;
  std::vector<std::size_t> widths(columns, 0);
  for (Row& cells : rows)
    for (std::size_t i = 0; i < columns; ++i) {
      cells[i] = GC::printable(cells[i]);
      widths[i] = (std::max)(widths[i], cells[i].size());
    }
  for (const Row& cells : rows) {
    text += indentation;
    for (std::size_t i = 0; i < columns; ++i) text += cells[i] + std::string(widths[i] - cells[i].size() + 2, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string joins_json(const std::vector<Shown_join>& joins) {
  std::ostringstream os;
  os << '[';
  for (std::size_t i = 0; i < joins.size(); ++i) {
    const Shown_join& join = joins[i];
    const Glyph_point& node = join.right.start();
    const GC::Kink_size size = Glyph_join(join.left, join.right).size();
    os << (i == 0 ? "" : ",") << "{\"contour\":" << join.contour << ",\"node\":" << join.node << ",\"point\":["
       << coordinate(node.x) << ',' << coordinate(node.y) << "],\"grade\":\"" << join.grade << "\",\"angle_degrees\":";
    GC::write_json(os, std::optional<GC::Enclosure>(GC::in_degrees(size.angle)));
    os << ",\"units\":" << rounded(size.handle_offset.upper / 2, 6)
       << ",\"per_mille\":" << rounded(1000 * join.severity, 6) << '}';
  }
  os << ']';
  return os.str();
}
