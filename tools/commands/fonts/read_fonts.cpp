// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/read_fonts.h"

#include "files/input.h"
#include "files/progress.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace {

class Font_reader {
  Glyph_selection selection_;
  Font_visitor& visitor_;
  Fonts_result all_;
  const std::vector<Font_file> files_;
  Progress progress_{"joins"};
  std::uintmax_t bytes_ = 0, bytes_done_ = 0;
  bool is_alone_; // the only argument is the only font of a file
  Glyph_outline outline_;

  void read_file(const Font_file& file) {
    std::string number; // in messages, where there are several
    try {
      const std::string bytes = read_bytes(file.name);
      for (int i = 0, fonts = 1; i < fonts; ++i) {
        if (i > 0) number = "font " + std::to_string(i) + ": ";
        try {
          const Font_face font(bytes, i);
          fonts = font.fonts_of_file();
          is_alone_ = is_alone_ && fonts == 1;
          read_font(file, font, fonts == 1 ? std::nullopt : std::optional<int>(i));
        } catch (const Font_error& e) {
          refuse(file, number + e.what());
        }
      }
    } catch (const GC::Error& e) {
      if (!file.from_folder) throw;
      all_.unread.push_back({file.name, e.what()});
    }
  }

  void refuse(const Font_file& file, const std::string& reason) {
    if (!file.from_folder) throw GC::Error(GC::Error_code::malformed_input, input_name(file.name) + ": " + reason);
    all_.unread.push_back({file.name, reason});
  }

  void read_font(const Font_file& file, const Font_face& font, std::optional<int> number) {
    if (!font.has_outlines()) throw Font_error("pictures of letters (bitmaps), no outlines");
    Font_result result{input_name(file.name), number, is_alone_, font.name(), font.units_per_em()};
    const std::vector<int> glyphs = selection_.glyphs(font, result.missing);
    visitor_.begin_font(font, result);
    for (const int glyph : glyphs) {
      try {
        font.read(glyph, outline_);
        result.counts += {1, outline_.size() == 0, visitor_.glyph(font, glyph, outline_, result)};
      } catch (const Font_error& e) {
        result.unread.push_back({glyph, font.glyph_name(glyph), e.what()});
      }
      show_progress(file, result, double(glyph) / font.glyphs());
    }
    visitor_.end_font(font, result);
    ++all_.fonts;
    all_.counts += result.counts;
  }

  // `part` is that of the font, from 0 to 1.
  void show_progress(const Font_file& file, const Font_result& result, double part) {
    progress_.step(all_.counts.joins.joins() + result.counts.joins.joins(), [&] {
      return bytes_ == 0 ? 0 : (double(bytes_done_) + part * double(file.bytes)) / double(bytes_);
    });
  }

public:
  Font_reader(const Arguments& arguments, const Glyph_selection& glyphs, Font_visitor& visitor)
      : selection_(glyphs), visitor_(visitor), files_(font_files(arguments, all_.unread)) {
    std::error_code none;
    is_alone_ = arguments.size() == 1 && !std::filesystem::is_directory(arguments[0], none);
    for (const Font_file& file : files_) bytes_ += file.bytes;
  }

  Fonts_result read() {
    for (const Font_file& file : files_) {
      read_file(file);
      bytes_done_ += file.bytes;
    }
    progress_.clear();
    if (all_.fonts != 0) selection_.check_all_found();
    return std::move(all_);
  }
};

} // namespace

Fonts_result read_fonts(const Arguments& arguments, const Glyph_selection& glyphs, Font_visitor& visitor) {
  return Font_reader(arguments, glyphs, visitor).read();
}
