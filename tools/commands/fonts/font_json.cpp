// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"

std::string json_members(const Join_counts& counts) {
  const auto number = [](std::size_t n) { return std::to_string(n); };
  return "\"joins\":" + number(counts.joins()) + ",\"corners\":" + number(counts[Glyph_grade::corner]) +
         ",\"kinks\":" + number(counts[Glyph_grade::kink]) +
         ",\"kinks_off_by_more_than_one_unit\":" + number(counts.off_by_more_than_one_unit()) +
         ",\"bends\":" + number(counts[Glyph_grade::bend]) + ",\"rounding\":" + number(counts[Glyph_grade::rounding]) +
         ",\"G1\":" + number(counts[Glyph_grade::g1]) + ",\"G2\":" + number(counts[Glyph_grade::g2]);
}

std::string json_members(const Font_counts& counts) {
  return "\"glyphs\":" + std::to_string(counts.glyphs) + ",\"empty\":" + std::to_string(counts.empty) + ',' +
         json_members(counts.joins);
}

std::string json_members(const Shown_join& join) {
  const Join_numbers numbers(join);
  std::string text = "\"contour\":" + std::to_string(join.contour) + ",\"node\":" + std::to_string(join.node) +
                     ",\"point\":[" + numbers.x + ',' + numbers.y + "],\"grade\":\"" + to_string(join.grade) +
                     "\",\"angle_degrees\":" + json_text(std::optional<GC::Enclosure>(numbers.degrees)) +
                     ",\"units\":" + rounded(numbers.units, 6) + ",\"per_mille\":" + rounded(numbers.per_mille, 6);
  if (!join.part_name.empty()) text += ",\"component\":" + json_text(join.part_name);
  return text;
}

std::string json_unread(const std::vector<Unread_glyph>& glyphs) {
  std::string text;
  for (const Unread_glyph& glyph : glyphs)
    text += (text.empty() ? "\n  {\"index\":" : ",\n  {\"index\":") + std::to_string(glyph.index) +
            ",\"name\":" + json_text(glyph.name) + ",\"reason\":" + json_text(glyph.reason) + '}';
  return text;
}

std::string json_members(const Font_result& font, const std::string& more) {
  return "\"summary\":{" + json_members(font.counts) + more + "},\"name\":" + json_text(font.name) +
         ",\"units_per_em\":" + std::to_string(font.units_per_em);
}
