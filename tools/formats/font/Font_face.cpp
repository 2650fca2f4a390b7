// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Font_face.h"

#include "files/max_unpacked.h"
#include "formats/font/Cff_outlines.h"
#include "formats/font/True_type_glyphs.h"
#include "formats/font/Type_1_charstring.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_FONT_FORMATS_H
#include FT_MODULE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H
#include FT_TYPE1_TABLES_H

namespace {

// Returns FreeType's text for an error. Its header lists the texts for code that defines these
// macros.
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

// The memory of FreeType, which unpacks fonts in many ways: WOFF, WOFF2, suitcases, pictures packed
// by gzip, bzip2 or compress. What it takes in all is limited, and so is what any of them can
// unpack to.
class Font_memory {
  struct alignas(std::max_align_t) Head {
    std::size_t size;
  };
  std::size_t size_ = 0;
  bool refused_ = false;
  FT_MemoryRec_ functions_{this, &Font_memory::allocate, &Font_memory::release, &Font_memory::resize};

  static Font_memory& self(FT_Memory memory) { return *static_cast<Font_memory*>(memory->user); }

  void* resized(Head* block, std::size_t size) {
    const std::size_t before = block == nullptr ? 0 : block->size;
    refused_ = refused_ || size > max_unpacked - (std::min)(max_unpacked, size_ - before);
    if (refused_) return nullptr;
    Head* const result = static_cast<Head*>(std::realloc(block, sizeof(Head) + size));
    if (result == nullptr) return nullptr;
    size_ += size - before;
    result->size = size;
    return result + 1;
  }
  static void* allocate(FT_Memory memory, long size) {
    return self(memory).resized(nullptr, static_cast<std::size_t>(size));
  }
  static void release(FT_Memory memory, void* block) {
    if (block == nullptr) return;
    Head* const head = static_cast<Head*>(block) - 1;
    self(memory).size_ -= head->size;
    std::free(head);
  }
  static void* resize(FT_Memory memory, long, long size, void* block) {
    return self(memory).resized(block == nullptr ? nullptr : static_cast<Head*>(block) - 1,
                                static_cast<std::size_t>(size));
  }

public:
  FT_Memory functions() { return &functions_; }

  // Returns whether the limit was reached since the last call.
  bool take_refused() { return std::exchange(refused_, false); }
};

Font_memory& font_memory() {
  static Font_memory memory;
  return memory;
}

void check(FT_Error error) {
  const bool refused = font_memory().take_refused();
  if (error == 0) return;
  if (refused) throw Font_error("more than " + std::to_string(max_unpacked >> 20) + " MiB when unpacked");
  throw Font_error(freetype_message(error));
}

// FreeType itself, opened once.
FT_Library library() {
  static const FT_Library opened = [] {
    FT_Library result;
    check(FT_New_Library(font_memory().functions(), &result));
    FT_Add_Default_Modules(result);
    return result;
  }();
  return opened;
}

// A value of the dictionary of a Type 1 font; empty where there is none.
std::string dictionary_value(FT_Face face, PS_Dict_Keys key, int index) {
  const FT_Long size = FT_Get_PS_Font_Value(face, key, static_cast<FT_UInt>(index), nullptr, 0);
  if (size <= 0) return {};
  std::string value(static_cast<std::size_t>(size), '\0');
  FT_Get_PS_Font_Value(face, key, static_cast<FT_UInt>(index), value.data(), size);
  value.pop_back(); // the zero at the end
  return value;
}

template <class Value> Value dictionary_number(FT_Face face, PS_Dict_Keys key, int index = 0) {
  Value value = 0;
  FT_Get_PS_Font_Value(face, key, static_cast<FT_UInt>(index), &value, sizeof value);
  return value;
}

// The subroutines of a Type 1 font.
std::vector<std::string> type_1_subroutines(FT_Face face) {
  const FT_Fixed xx = dictionary_number<FT_Fixed>(face, PS_DICT_FONT_MATRIX, 0);
  for (int i = 1; i < 4; ++i)
    if (dictionary_number<FT_Fixed>(face, PS_DICT_FONT_MATRIX, i) != (i == 3 ? xx : 0))
      throw Font_error("not covered: a matrix of the font that does more than scale");
  std::vector<std::string> result(static_cast<std::size_t>(dictionary_number<FT_Int>(face, PS_DICT_NUM_SUBRS)));
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = dictionary_value(face, PS_DICT_SUBR, static_cast<int>(i));
  return result;
}

} // namespace

Font_face::~Font_face() = default;

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
  if (format == "TrueType")
    true_type_ = std::make_unique<const True_type_glyphs>(face);
  else if (format == "CFF" && FT_IS_SCALABLE(face)) {
    std::string table(bytes);
    if (FT_IS_SFNT(face)) {
      FT_ULong size = 0;
      const FT_ULong tag = FT_Load_Sfnt_Table(face, TTAG_CFF2, 0, nullptr, &size) == 0 ? TTAG_CFF2 : TTAG_CFF;
      check(FT_Load_Sfnt_Table(face, tag, 0, nullptr, &(size = 0)));
      table.resize(size);
      check(FT_Load_Sfnt_Table(face, tag, 0, reinterpret_cast<FT_Byte*>(table.data()), &size));
    }
    cff_ = std::make_unique<const Cff_outlines>(std::move(table));
  } else if (format == "Type 1")
    type_1_ = std::make_unique<std::vector<std::string>>(type_1_subroutines(face));
  else if (format != "CFF")
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

std::set<int> Font_face::components(int glyph) const {
  std::set<int> result;
  if (!true_type_) return result; // only TrueType glyphs have components
  for (const Glyph_part& part : true_type_->parts(glyph)) result.insert(part.glyph);
  return result;
}

std::string Font_face::charstring(int glyph) const { return dictionary_value(face_.get(), PS_DICT_CHAR_STRING, glyph); }

int Font_face::glyph_of_code(std::int64_t code) const {
  static const char* const accents[] = {"grave", "acute", "circumflex", "tilde", "macron", "breve", "dotaccent",
                                        "dieresis", "", "ring",
                                        // from 193 on
                                        "cedilla", "", "hungarumlaut", "ogonek", "caron"};
  char letter[] = "?";
  letter[0] = static_cast<char>(code);
  const bool is_letter = ('A' <= code && code <= 'Z') || ('a' <= code && code <= 'z');
  const char* name = is_letter                   ? letter
                     : code == 245               ? "dotlessi"
                     : 193 <= code && code < 208 ? accents[code - 193]
                                                 : "";
  const FT_UInt glyph = *name == '\0' ? 0 : FT_Get_Name_Index(face_.get(), const_cast<char*>(name));
  if (glyph == 0) throw Font_error("not covered: a part of an accented letter, code " + std::to_string(code));
  return static_cast<int>(glyph);
}

void Font_face::read_type_1(int glyph, Glyph_outline& outline) const {
  const std::string own = charstring(glyph);
  if (const auto accented = Type_1_charstring(*type_1_, outline).draw(own)) {
    for (const std::int64_t code : {accented->letter, accented->accent}) {
      const int part = glyph_of_code(code);
      outline.begin_part(part);
      if (Type_1_charstring(*type_1_, outline)
              .draw(charstring(part), code == accented->accent ? accented->at : Glyph_point{0, 0}))
        throw Font_error("an accented letter of accented letters");
    }
  }
  outline.set_shift(Charstring_pen::shift);
}

void Font_face::read(int glyph, Glyph_outline& outline, const Changed_glyphs* changed) const {
  outline.clear();
  try {
    if (cff_)
      cff_->read(glyph, outline, [this](std::int64_t code) { return glyph_of_code(code); });
    else if (type_1_)
      read_type_1(glyph, outline);
    else if (true_type_)
      true_type_->read(glyph, outline, changed);
  } catch (const Font_error&) {
    outline.clear();
    throw;
  }
}
