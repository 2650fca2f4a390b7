// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"
#include "files/deferred_output.h"

#include <CGAL/Geometric_continuity/IO/json.h>

#include <sstream>
#include <utility>

std::string json_string(const std::string& text) {
  std::ostringstream os;
  GC::write_json(os, text);
  return os.str();
}

std::string json_members(const Join_counts& counts) {
  const auto number = [](std::size_t n) { return std::to_string(n); };
  return "\"joins\":" + number(counts.joins()) + ",\"corners\":" + number(counts[GC::Join_grade::corner]) +
         ",\"kinks\":" + number(counts[GC::Join_grade::kink]) +
         ",\"kinks_off_by_more_than_one_unit\":" + number(counts.off_by_more_than_one_unit()) +
         ",\"G1\":" + number(counts[GC::Join_grade::g1]) + ",\"G2\":" + number(counts[GC::Join_grade::g2]);
}

std::string json_members(const Font_counts& counts) {
  return "\"glyphs\":" + std::to_string(counts.glyphs) + ",\"empty\":" + std::to_string(counts.empty) + ',' +
         json_members(counts.joins);
}

std::string json_members(const Shown_join& join) {
  const Join_numbers numbers(join);
  std::ostringstream os;
  os << "\"contour\":" << join.contour << ",\"node\":" << join.node << ",\"point\":[" << numbers.x << ',' << numbers.y
     << "],\"grade\":\"" << join.grade << "\",\"angle_degrees\":";
  GC::write_json(os, std::optional<GC::Enclosure>(numbers.degrees));
  os << ",\"units\":" << rounded(numbers.units, 6) << ",\"per_mille\":" << rounded(numbers.per_mille, 6);
  return os.str();
}

namespace {

// Returns an array of what text(item) is for each item.
template <class Items, class Text> std::string array(const Items& items, Text text) {
  std::string result = "[";
  for (const auto& item : items) result += (result.size() == 1 ? "" : ",") + text(item);
  return result + ']';
}

class Font_json : public Font_report {
  Deferred_output out_;
  bool has_font_ = false, has_glyph_ = false, is_alone_ = false;

public:
  using Font_report::Font_report;

  bool is_by_glyph() const override { return true; }

  void begin_font(const Font_result& font) override {
    is_alone_ = font.is_alone;
    has_glyph_ = false;
    if (is_alone_) return out_.write("{\"glyphs\":[");
    out_.write((std::exchange(has_font_, true) ? ",\n{\"file\":" : "{\"fonts\":[\n{\"file\":") +
               json_string(font.file) + (font.number ? ",\"font\":" + std::to_string(*font.number) : "") +
               ",\"glyphs\":[");
  }

  void glyph(int index, const std::string& name, const Join_counts& joins,
             const std::vector<Shown_join>& worst) override {
    if (mode_.summary && !fails(joins)) return;
    out_.write((std::exchange(has_glyph_, true) ? ",\n {\"index\":" : "\n {\"index\":") + std::to_string(index) +
               ",\"name\":" + json_string(name) + ',' + json_members(joins) + ",\"worst\":" +
               array(worst, [](const Shown_join& join) { return '{' + json_members(join) + '}'; }) + '}');
  }

  void end_font(const Font_result& font) override {
    out_.write("],\n \"not_verified\":" +
               array(font.unread,
                     [](const Unread_glyph& glyph) {
                       return "\n  {\"index\":" + std::to_string(glyph.index) + ",\"name\":" + json_string(glyph.name) +
                              ",\"reason\":" + json_string(glyph.reason) + '}';
                     }) +
               ",\"not_found\":" + array(font.missing, json_string) + ",\n \"summary\":{" + json_members(font.counts) +
               "},\"name\":" + json_string(font.name) + ",\"units_per_em\":" + std::to_string(font.units_per_em) +
               (is_alone_ ? "" : "}"));
  }

  void print(std::ostream& os, const Fonts_result& all) override {
    out_.copy_to(os);
    if (!is_alone_)
      os << (has_font_ ? "" : "{\"fonts\":[") << "],\n\"not_verified\":"
         << array(all.unread,
                  [](const Unread_file& file) {
                    return "\n {\"file\":" + json_string(file.name) + ",\"reason\":" + json_string(file.reason) + '}';
                  })
         << ",\n\"summary\":{\"fonts\":" << all.fonts << ',' << json_members(all.counts) << '}';
    if (required_) os << ",\n\"required\":\"" << *required_ << "\",\"met\":" << conclusion(all).json_met(mode_);
    os << "}\n";
  }
};

} // namespace

std::unique_ptr<Font_report> font_json(const Report_mode& mode, const std::optional<GC::Join_grade>& required) {
  return std::make_unique<Font_json>(mode, required);
}
