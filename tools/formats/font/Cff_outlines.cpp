// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Cff_outlines.h"

#include <cstddef>
#include <utility>

namespace {

namespace GC = CGAL::Geometric_continuity;

GC::Cff_table cff_table(const std::string& bytes) {
  try {
    return GC::Cff_table(bytes);
  } catch (const GC::Error& e) {
    throw Font_error(std::string(e.what()).substr(to_string(e.code()).size() + 2));
  }
}

} // namespace

Cff_outlines::Cff_outlines(std::string bytes) : bytes_(std::move(bytes)), table_(cff_table(bytes_)) {}

std::optional<Accented_letter> Cff_outlines::draw(int glyph, Glyph_outline& outline, const Glyph_point& origin) const {
  const std::size_t i = static_cast<std::size_t>(glyph);
  if (table_.glyph_count() <= i) throw Font_error("there is no charstring");
  const Type_2_context context = table_.context(i);
  Charstring_pen pen(outline);
  pen.jump(origin);
  return Type_2_charstring<Charstring_pen>(context, pen).draw(table_.charstring(i));
}

void Cff_outlines::read(int glyph, Glyph_outline& outline, const std::function<int(std::int64_t)>& glyph_of) const {
  if (const std::optional<Accented_letter> accented = draw(glyph, outline)) {
    const int letter = glyph_of(accented->letter), accent = glyph_of(accented->accent);
    outline.begin_part(letter);
    if (draw(letter, outline)) throw Font_error("an accented letter of accented letters");
    outline.begin_part(accent);
    if (draw(accent, outline, accented->at)) throw Font_error("an accented letter of accented letters");
  }
  outline.set_shift(Charstring_pen::shift);
}
