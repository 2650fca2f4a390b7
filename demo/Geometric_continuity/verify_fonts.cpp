// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "verify_fonts.h"

#include "Font_face.h"
#include "deferred_output.h"
#include "font_files.h"
#include "font_report.h"
#include "input.h"
#include "join_report.h"
#include "progress.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/printable.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_reasons = 10; // that the text gives for the glyphs of one font

std::string json_string(const std::string& text) {
  std::ostringstream os;
  GC::write_json(os, text);
  return os.str();
}

std::string joined(const Arguments& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

// Reads fonts, grades their joins and keeps what the report says.
class Fonts_report {
  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  const std::optional<GC::Join_grade> required_;
  const GC::Kink_bound bound_;
  Glyph_selection selection_;
  std::vector<Font_file> files_;
  std::vector<Unread_file> not_read_; // folders and fonts
  Deferred_output out_;
  Progress progress_{"joins"};
  const std::size_t most_;
  Worst_joins worst_{most_, true}, worst_of_font_{most_, true}, worst_of_glyph_{most_, false};
  Font_counts counts_;
  std::size_t fonts_ = 0, unverified_ = 0;
  std::uintmax_t bytes_ = 0, bytes_done_ = 0;
  bool one_font_; // the only argument is the only font of a file
  Glyph_outline outline_;

  bool fails(const Join_counts& joins) const { return required_ && joins.below(*required_) != 0; }

  void read_file(const Font_file& file) {
    std::string font_number; // in messages, where there are several
    try {
      const std::string bytes = read_bytes(file.name);
      for (int i = 0, fonts = 1; i < fonts; ++i) {
        if (i > 0) font_number = "font " + std::to_string(i) + ": ";
        const Font_face font(bytes, i);
        fonts = font.fonts_of_file();
        one_font_ = one_font_ && fonts == 1;
        try {
          read_font(file, font, fonts == 1 ? std::nullopt : std::optional<int>(i));
        } catch (const Font_error& e) {
          refuse(file, font_number + e.what());
        }
      }
    } catch (const Font_error& e) {
      refuse(file, font_number + e.what());
    } catch (const GC::Error& e) {
      if (!file.from_folder) throw;
      not_read_.push_back({file.name, e.what()});
    }
  }

  void refuse(const Font_file& file, const std::string& reason) {
    if (!file.from_folder) throw GC::Error(GC::Error_code::malformed_input, input_name(file.name) + ": " + reason);
    not_read_.push_back({file.name, reason});
  }

  void read_font(const Font_file& file, const Font_face& font, std::optional<int> index) {
    if (!font.has_outlines()) throw Font_error("pictures of letters (bitmaps), no outlines");
    Font_counts counts;
    Arguments missing, reasons;
    const std::vector<int> glyphs = selection_.glyphs(font, missing);
    const double em = font.units_per_em();
    if (json_) begin_json(file, index);
    bool has_row = false;
    for (const int glyph : glyphs) {
      try {
        font.read(glyph, outline_);
      } catch (const Font_error& e) {
        const std::string name = font.glyph_name(glyph);
        reasons.push_back(json_ ? "{\"index\":" + std::to_string(glyph) + ",\"name\":" + json_string(name) +
                                      ",\"reason\":" + json_string(e.what()) + '}'
                                : "glyph " + name + ": not verified, " + e.what());
        continue;
      }
      Worst_joins& worst = json_ ? worst_of_glyph_ : worst_of_font_;
      const Join_counts joins =
          grade_joins(outline_, bound_, required_.value_or(GC::Join_grade::g1),
                      [&](std::size_t contour, std::size_t node, GC::Join_grade grade, const Glyph_join& join,
                          const Glyph_segment& left, const Glyph_segment& right) {
                        const double severity = grade == GC::Join_grade::kink ? join.severity() / em : 0;
                        worst.add({glyph, contour, node, grade, severity, left, right});
                      });
      ++counts.glyphs;
      counts.empty += outline_.size() == 0;
      counts.joins += joins;
      if (json_ && (!mode_.summary || fails(joins))) {
        out_.write((std::exchange(has_row, true) ? ",\n " : "\n ") + json(font, glyph, joins));
      }
      worst_of_glyph_.clear();
      progress_.step(counts_.joins.joins() + counts.joins.joins(), [&] {
        const double part = static_cast<double>(glyph) / font.glyphs();
        return bytes_ == 0 ? 0
                           : (static_cast<double>(bytes_done_) + part * static_cast<double>(file.bytes)) /
                                 static_cast<double>(bytes_);
      });
    }
    if (json_)
      out_.write("],\n \"not_verified\":[" + joined(reasons, ",\n  ") + "],\"not_found\":" + json_array(missing) +
                 ",\n \"summary\":{" + json_summary(counts) + "},\"name\":" + json_string(font.name()) +
                 ",\"units_per_em\":" + std::to_string(font.units_per_em()) + (one_font_ ? "" : "}"));
    else
      write_text(input_name(file.name) + (index ? ", font " + std::to_string(*index) : ""), font, counts, missing,
                 reasons);
    counts_ += counts;
    unverified_ += reasons.size() + missing.size();
    ++fonts_;
  }

  void begin_json(const Font_file& file, std::optional<int> index) {
    if (one_font_) return out_.write("{\"glyphs\":[");
    out_.write((fonts_ == 0 ? "{\"fonts\":[\n{\"file\":" : ",\n{\"file\":") + json_string(input_name(file.name)) +
               (index ? ",\"font\":" + std::to_string(*index) : "") + ",\"glyphs\":[");
  }

  std::string json(const Font_face& font, int glyph, const Join_counts& joins) {
    return "{\"index\":" + std::to_string(glyph) + ",\"name\":" + json_string(font.glyph_name(glyph)) + ',' +
           counts_json(joins) + ",\"worst\":" + joins_json(worst_of_glyph_.sorted()) + '}';
  }

  static std::string json_array(const Arguments& texts) {
    Arguments values;
    for (const std::string& text : texts) values.push_back(json_string(text));
    return '[' + joined(values, ",") + ']';
  }

  static std::string json_summary(const Font_counts& counts) {
    return "\"glyphs\":" + std::to_string(counts.glyphs) + ",\"empty\":" + std::to_string(counts.empty) + ',' +
           counts_json(counts.joins);
  }

  void write_text(const std::string& place, const Font_face& font, const Font_counts& counts, const Arguments& missing,
                  const Arguments& reasons) {
    const std::string name = font.name();
    std::string text = GC::printable(name.empty() ? place : name + ", " + place) + "\n  " + counts_text(counts) + '\n';
    for (std::size_t i = 0; i < (std::min)(reasons.size(), most_reasons); ++i)
      text += "  " + GC::printable(reasons[i]) + '\n';
    if (reasons.size() > most_reasons)
      text += "  " + counted(reasons.size() - most_reasons, "more glyph") + " not verified\n";
    if (!missing.empty()) text += "  not in this font: " + GC::printable(joined(missing, ", ")) + '\n';
    std::vector<Shown_join> worst = worst_of_font_.sorted();
    for (Shown_join& join : worst) {
      join.glyph_name = font.glyph_name(join.glyph);
      join.font_name = name.empty() ? place : name;
      worst_.add(join);
    }
    if (!mode_.summary || fails(counts.joins)) text += joins_table(worst, "    ", false);
    out_.write(text);
    worst_of_font_.clear();
  }

public:
  Fonts_report(const Arguments& arguments, const Report_mode& mode, const Font_demand& demand)
      : mode_(mode), required_(demand.required), bound_(demand.bound), selection_(demand.glyphs),
        files_(font_files(arguments, not_read_)), most_(demand.worst) {
    std::error_code none;
    one_font_ = files_.size() == 1 && arguments.size() == 1 && !fs::is_directory(arguments[0], none);
    for (const Font_file& file : files_) bytes_ += file.bytes;
  }

  void read() {
    for (const Font_file& file : files_) {
      read_file(file);
      bytes_done_ += file.bytes;
    }
    progress_.clear();
    if (fonts_ != 0) selection_.check_all_found();
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    out_.copy_to(os);
    if (json_)
      print_json_end(os);
    else
      print_summary(os);
    return conclusion().exit_code(mode_, "join");
  }

private:
  Conclusion conclusion() const {
    return {counts_.joins.joins(), required_ ? counts_.joins.below(*required_) : 0, not_read_.size() + unverified_};
  }

  void print_summary(std::ostream& os) {
    for (const Unread_file& file : not_read_) os << GC::printable(file.name + ": not verified, " + file.reason) << '\n';
    if (fonts_ != 1 || !not_read_.empty()) {
      os << counted(fonts_, "font") << ", " << counts_text(counts_);
      if (!not_read_.empty()) os << "; " << not_read_.size() << " not verified";
      os << '\n';
      if (!mode_.summary || fails(counts_.joins)) os << joins_table(worst_.sorted(), "    ", true);
    }
    const Conclusion end = conclusion();
    if (end.decided == 0)
      os << "no join, nothing was decided\n";
    else if (required_ && end.failing == 0)
      os << "every join that is no corner is " << *required_ << ", proved exactly\n";
    else if (required_)
      os << end.failing << " of them not " << *required_ << '\n';
    if (mode_.strict && end.unverified > 0) os << "not met, because not all was verified\n";
  }

  void print_json_end(std::ostream& os) const {
    if (!one_font_) {
      Arguments unread;
      for (const Unread_file& file : not_read_)
        unread.push_back("{\"file\":" + json_string(file.name) + ",\"reason\":" + json_string(file.reason) + '}');
      os << (fonts_ == 0 ? "{\"fonts\":[" : "") << "],\n\"not_verified\":[" << joined(unread, ",\n ")
         << "],\n\"summary\":{\"fonts\":" << fonts_ << ',' << json_summary(counts_) << '}';
    }
    if (required_) os << ",\n\"required\":\"" << *required_ << "\",\"met\":" << conclusion().json_met(mode_);
    os << "}\n";
  }
};

} // namespace

int verify_fonts(const Arguments& files, const Report_mode& mode, const Font_demand& demand) {
  Fonts_report report(files, mode, demand);
  report.read();
  return report.print(std::cout);
}
