// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Font_face.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_FONT_FORMATS_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H

namespace {

constexpr FT_Pos max_coordinate = FT_Pos(1) << 20; // units of the font
constexpr int max_components = 1000;               // of a glyph, those of its components included

// What FreeType says about an error. Its header lists the texts for whoever defines these macros.
std::string freetype_message(FT_Error error) {
  switch (FT_ERROR_BASE(error)) {
#undef FTERRORS_H_
#define FT_ERRORDEF(name, value, text)                                                                                 \
  case value:                                                                                                          \
    return text;
#define FT_ERROR_START_LIST
#define FT_ERROR_END_LIST
#include FT_ERRORS_H
  }
  return "error " + std::to_string(error);
}

void check(FT_Error error) {
  if (error != 0) throw Font_error(freetype_message(error));
}

// FreeType itself, opened once.
FT_Library library() {
  static const FT_Library opened = [] {
    FT_Library result;
    check(FT_Init_FreeType(&result));
    return result;
  }();
  return opened;
}

// Receives the pieces of an outline. Nothing here may throw, because FreeType calls it.
class Outline_receiver {
  Glyph_outline& outline_;
  bool inside_ = false, good_ = true;
  FT_Vector position_{0, 0};

  Glyph_point point(const FT_Vector& p) {
    good_ = good_ && std::labs(p.x) <= 2 * max_coordinate && std::labs(p.y) <= 2 * max_coordinate;
    return good_ ? Glyph_point{static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)} : Glyph_point{0, 0};
  }
  int move(const FT_Vector& to) {
    end_contour();
    position_ = to;
    inside_ = true;
    return 0;
  }
  int add(const Glyph_segment& segment, const FT_Vector& to) {
    outline_.add(segment);
    position_ = to;
    return 0;
  }

public:
  explicit Outline_receiver(Glyph_outline& outline) : outline_(outline) {}

  void end_contour() {
    if (inside_) outline_.end_contour();
  }

  // Whether all coordinates are within the bounds.
  bool good() const { return good_; }

  // The functions that FreeType calls, for coordinates in halves of units.
  static const FT_Outline_Funcs& functions() {
    typedef const FT_Vector* P;
    static const FT_Outline_Funcs table{[](P to, void* self) { return receiver(self).move(*to); },
                                        [](P to, void* self) { return receiver(self).line(*to); },
                                        [](P a, P to, void* self) { return receiver(self).conic(*a, *to); },
                                        [](P a, P b, P to, void* self) { return receiver(self).cubic(*a, *b, *to); },
                                        1,
                                        0}; // all coordinates are multiplied by 2
    return table;
  }

private:
  static Outline_receiver& receiver(void* self) { return *static_cast<Outline_receiver*>(self); }
  int line(const FT_Vector& to) { return add({1, {point(position_), point(to)}}, to); }
  int conic(const FT_Vector& a, const FT_Vector& to) { return add({2, {point(position_), point(a), point(to)}}, to); }
  int cubic(const FT_Vector& a, const FT_Vector& b, const FT_Vector& to) {
    return add({3, {point(position_), point(a), point(b), point(to)}}, to);
  }
};

} // namespace

void Font_face::Close::operator()(FT_FaceRec_* face) const { FT_Done_Face(face); }

Font_face::Font_face(std::string_view bytes, int index) {
  if (bytes.empty()) throw Font_error("no bytes");
  FT_Open_Args arguments{};
  arguments.flags = FT_OPEN_MEMORY;
  arguments.memory_base = reinterpret_cast<const FT_Byte*>(bytes.data());
  arguments.memory_size = static_cast<FT_Long>(bytes.size());
  FT_Face face;
  check(FT_Open_Face(library(), &arguments, index, &face));
  face_.reset(face);
  has_names_ = FT_HAS_GLYPH_NAMES(face);
  const std::string_view format = FT_Get_Font_Format(face);
  const bool is_true_type = format == "TrueType";
  is_simple_.assign(static_cast<std::size_t>(face->num_glyphs), !is_true_type);
  if (!is_true_type && format != "CFF" && format != "Type 1" && format != "CID Type 1")
    throw Font_error("fonts of the format " + std::string(format) + " are not read");
}

int Font_face::fonts_of_file() const { return static_cast<int>(face_->num_faces); }

bool Font_face::has_outlines() const { return FT_IS_SCALABLE(face_.get()); }

std::string Font_face::name() const {
  const std::string family = face_->family_name == nullptr ? "" : face_->family_name,
                    style = face_->style_name == nullptr ? "" : face_->style_name;
  return family + (family.empty() || style.empty() ? "" : " ") + style;
}

std::string Font_face::unpacked() const {
  FT_ULong size = 0;
  check(FT_Load_Sfnt_Table(face_.get(), 0, 0, nullptr, &size));
  std::string bytes(size, '\0');
  check(FT_Load_Sfnt_Table(face_.get(), 0, 0, reinterpret_cast<FT_Byte*>(bytes.data()), &size));
  return bytes;
}

int Font_face::units_per_em() const { return face_->units_per_EM; }

int Font_face::glyphs() const { return static_cast<int>(face_->num_glyphs); }

std::string Font_face::glyph_name(int glyph) const {
  char name[128] = "";
  const FT_UInt index = static_cast<FT_UInt>(glyph);
  if (!has_names_ || FT_Get_Glyph_Name(face_.get(), index, name, sizeof name) != 0 || name[0] == '\0')
    std::snprintf(name, sizeof name, "glyph%05d", glyph);
  return name;
}

int Font_face::glyph_from(char32_t& character) const {
  FT_UInt glyph = character == 0 ? 0 : FT_Get_Char_Index(face_.get(), character);
  if (glyph == 0) character = static_cast<char32_t>(FT_Get_Next_Char(face_.get(), character, &glyph));
  return static_cast<int>(glyph);
}

bool Font_face::load_components(int glyph) const {
  check(FT_Load_Glyph(face_.get(), static_cast<FT_UInt>(glyph), FT_LOAD_NO_RECURSE));
  const bool has_components = face_->glyph->format == FT_GLYPH_FORMAT_COMPOSITE;
  if (!has_components) is_simple_[static_cast<std::size_t>(glyph)] = true;
  return has_components;
}

void Font_face::count_components(int& number) const {
  std::vector<FT_Int> components((std::min)(face_->glyph->num_subglyphs, FT_UInt{max_components} + 1));
  for (std::size_t i = 0; i < components.size(); ++i) {
    FT_Int x, y;
    FT_UInt flags;
    FT_Matrix scale;
    check(FT_Get_SubGlyph_Info(face_->glyph, static_cast<FT_UInt>(i), &components[i], &flags, &x, &y, &scale));
  }
  for (const int component : components) { // a glyph of the font, or FreeType would have refused the list
    if (++number > max_components) throw Font_error("more components than any letter needs");
    if (!is_simple_[static_cast<std::size_t>(component)] && load_components(component)) count_components(number);
  }
}

std::set<int> Font_face::components(int glyph) const {
  std::set<int> leaves, open{glyph}, known;
  while (!open.empty()) {
    const int next = *open.begin();
    open.erase(open.begin());
    if (!known.insert(next).second) continue;
    if (known.size() > std::size_t{max_components}) throw Font_error("more components than any letter needs");
    if (!load_components(next)) {
      if (next != glyph) leaves.insert(next);
      continue;
    }
    for (FT_UInt i = 0; i < face_->glyph->num_subglyphs; ++i) {
      FT_Int component, x, y;
      FT_UInt flags;
      FT_Matrix scale;
      check(FT_Get_SubGlyph_Info(face_->glyph, i, &component, &flags, &x, &y, &scale));
      open.insert(component);
    }
  }
  return leaves;
}

void Font_face::load(int glyph) const {
  if (!is_simple_[static_cast<std::size_t>(glyph)]) {
    if (!load_components(glyph)) return;
    int number = 0;
    count_components(number);
  }
  check(FT_Load_Glyph(face_.get(), static_cast<FT_UInt>(glyph), FT_LOAD_NO_SCALE | FT_LOAD_IGNORE_TRANSFORM));
}

void Font_face::read(int glyph, Glyph_outline& outline) const {
  outline.clear();
  load(glyph);
  FT_GlyphSlot slot = face_->glyph;
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) throw Font_error("a picture without an outline");
  Outline_receiver receiver(outline);
  check(FT_Outline_Decompose(&slot->outline, &Outline_receiver::functions(), &receiver));
  receiver.end_contour();
  if (receiver.good()) return;
  outline.clear();
  throw Font_error("a coordinate beyond " + std::to_string(max_coordinate) + " units of the font");
}
