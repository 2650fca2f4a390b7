// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Font_face.h"

#include "files/max_unpacked.h"
#include "formats/font/Cff_outlines.h"
#include "formats/font/Glyph_origins.h"
#include "formats/font/Type_1_charstring.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_FONT_FORMATS_H
#include FT_MODULE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H
#include FT_TYPE1_TABLES_H

namespace {

constexpr FT_Pos max_coordinate = Glyph_outline::max_coordinate;

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

// The memory of FreeType, which unpacks fonts in many ways: WOFF, WOFF2, suitcases, pictures packed by gzip, bzip2 or compress. What
// it takes in all is limited, and so is what any of them can unpack to.
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

// Receives the pieces of an outline. Nothing here may throw, because FreeType calls it.
class Outline_receiver {
  Glyph_outline& outline_;
  const std::vector<std::pair<int, int>>* parts_; // glyphs, and before which contour each ends; or null
  std::size_t part_ = 0;
  int contour_ = -1;
  bool inside_ = false, good_ = true;
  FT_Vector position_{0, 0};

  Glyph_point point(const FT_Vector& p) {
    good_ = good_ && std::labs(p.x) <= 2 * max_coordinate && std::labs(p.y) <= 2 * max_coordinate;
    return good_ ? Glyph_point{p.x, p.y} : Glyph_point{0, 0};
  }
  int move(const FT_Vector& to) {
    end_contour();
    ++contour_;
    while (parts_ != nullptr && part_ < parts_->size() && (*parts_)[part_].second <= contour_) ++part_;
    if (parts_ != nullptr && part_ < parts_->size()) outline_.begin_part((*parts_)[part_].first);
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
  explicit Outline_receiver(Glyph_outline& outline, const std::vector<std::pair<int, int>>* parts = nullptr)
      : outline_(outline), parts_(parts) {}

  void end_contour() {
    if (inside_) outline_.end_contour();
  }

  // Returns whether all coordinates are within the bounds.
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

// Reads the outline that has been loaded.
void receive(FT_GlyphSlot slot, Glyph_outline& outline, const std::vector<std::pair<int, int>>* parts = nullptr) {
  if (slot->format != FT_GLYPH_FORMAT_OUTLINE) throw Font_error("a picture without an outline");
  Outline_receiver receiver(outline, parts);
  check(FT_Outline_Decompose(&slot->outline, &Outline_receiver::functions(), &receiver));
  receiver.end_contour();
  if (!receiver.good())
    throw Font_error("a coordinate beyond " + std::to_string(max_coordinate) + " units of the font");
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
  if (format == "TrueType") {
    origins_ = std::make_unique<const Glyph_origins>(face);
    simple_.assign(static_cast<std::size_t>(face->num_glyphs), -1);
    placing_.resize(simple_.size());
    std::iota(placing_.begin(), placing_.end(), 0);
  } else if (format == "CFF" && FT_IS_SCALABLE(face)) {
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

void Font_face::load(int glyph, int flags, int placing) const {
  check(FT_Load_Glyph(face_.get(), static_cast<FT_UInt>(glyph), flags));
  if (face_->glyph->format == FT_GLYPH_FORMAT_OUTLINE)
    FT_Outline_Translate(&face_->glyph->outline, origins_->x(placing), 0);
}

std::optional<std::vector<Glyph_part>> Font_face::parts_of(int glyph) const {
  if (simple_[static_cast<std::size_t>(glyph)] >= 0) return std::nullopt;
  load(glyph, FT_LOAD_NO_RECURSE, glyph);
  if (face_->glyph->format != FT_GLYPH_FORMAT_COMPOSITE) {
    simple_[static_cast<std::size_t>(glyph)] = face_->glyph->outline.n_contours;
    return std::nullopt;
  }
  std::vector<Glyph_part> parts((std::min<std::size_t>)(face_->glyph->num_subglyphs, max_glyph_parts + 1));
  for (std::size_t i = 0; i < parts.size(); ++i) { // glyphs of the font, or FreeType would have refused the list
    constexpr FT_UInt scaled_offset = 0x800;
    FT_Int x, y;
    FT_UInt flags;
    FT_Matrix m; // multiples of 2^-14 in 2^-16
    check(FT_Get_SubGlyph_Info(face_->glyph, static_cast<FT_UInt>(i), &parts[i].glyph, &flags, &x, &y, &m));
    if ((flags & (FT_SUBGLYPH_FLAG_SCALE | FT_SUBGLYPH_FLAG_XY_SCALE | FT_SUBGLYPH_FLAG_2X2)) != 0)
      parts[i].matrix = Part_matrix{m.xx, m.xy, m.yx, m.yy, 16}.reduced();
    const Part_matrix& scale = parts[i].matrix;
    const bool is_scaled = (flags & scaled_offset) != 0, is_plain = scale.is_diagonal() && scale.xx > 0 && scale.yy > 0;
    if ((flags & FT_SUBGLYPH_FLAG_ARGS_ARE_XY_VALUES) != 0 && (!is_scaled || is_plain))
      parts[i].offset = is_scaled ? Part_offset{x * scale.xx, y * scale.yy, scale.shift} : Part_offset{x, y};
    if ((flags & FT_SUBGLYPH_FLAG_USE_MY_METRICS) != 0) placing_[static_cast<std::size_t>(glyph)] = parts[i].glyph;
  }
  return parts;
}

std::vector<Glyph_part> Font_face::leaves(const std::vector<Glyph_part>& parts) const {
  return leaf_parts(parts, [this](int glyph) { return parts_of(glyph); });
}

std::set<int> Font_face::components(int glyph) const {
  std::set<int> result;
  if (simple_.empty()) return result; // only TrueType glyphs have components
  if (const auto parts = parts_of(glyph))
    for (const Glyph_part& leaf : leaves(*parts)) result.insert(leaf.glyph);
  return result;
}

void Font_face::read_true_type(int glyph, Glyph_outline& outline, const Changed_glyphs* changed) const {
  std::vector<Glyph_part> leaves;
  if (simple_[static_cast<std::size_t>(glyph)] < 0) {
    const auto own = parts_of(glyph);
    if (!own) return receive(face_->glyph, outline); // it has been loaded
    leaves = this->leaves(*own);
  }
  int placing = glyph; // of a component whose metrics are those of the whole
  while (placing != placing_[static_cast<std::size_t>(placing)]) placing = placing_[static_cast<std::size_t>(placing)];
  load(glyph, FT_LOAD_NO_SCALE | FT_LOAD_IGNORE_TRANSFORM, placing);
  if (leaves.empty()) return receive(face_->glyph, outline);
  const auto is_not_as_read = [&](const Glyph_part& leaf) {
    return !leaf.matrix.is_identity() || (changed != nullptr && changed->count(leaf.glyph) != 0);
  };
  if (std::any_of(leaves.begin(), leaves.end(), is_not_as_read)) return transform(leaves, outline, changed);
  std::vector<std::pair<int, int>> parts;
  int contours = 0;
  for (const Glyph_part& leaf : leaves)
    parts.emplace_back(leaf.glyph, contours += simple_[static_cast<std::size_t>(leaf.glyph)]);
  receive(face_->glyph, outline, &parts);
}

void Font_face::transform(const std::vector<Glyph_part>& leaves, Glyph_outline& outline,
                          const Changed_glyphs* changed) const {
  const FT_Outline& all = face_->glyph->outline;
  const std::vector<FT_Vector> rounded(all.points, all.points + all.n_points);
  int shift = 1;
  for (const Glyph_part& leaf : leaves)
    shift = (std::max)({shift, leaf.matrix.shift + 1, leaf.offset ? leaf.offset->shift : 0});
  const auto in_steps = [shift](const FT_Vector& p) {
    return Glyph_point{p.x * (std::int64_t(1) << shift), p.y * (std::int64_t(1) << shift)};
  };
  Glyph_outline part;
  std::size_t points = 0;
  for (const Glyph_part& leaf : leaves) {
    part.clear();
    load(leaf.glyph, FT_LOAD_NO_RECURSE, leaf.glyph);
    receive(face_->glyph, part);
    const FT_Outline& own = face_->glyph->outline;
    if (own.n_points == 0) continue;
    if (rounded.size() < points + static_cast<std::size_t>(own.n_points)) throw Font_error("components that change");
    const Part_matrix& m = leaf.matrix;
    Glyph_point offset;
    if (leaf.offset) {
      const std::int64_t unit = std::int64_t(1) << (shift - leaf.offset->shift);
      offset = {unit * leaf.offset->x, unit * leaf.offset->y};
    } else { // it is placed as by FreeType
      FT_Vector first = own.points[0];
      const auto fixed = [&m](std::int64_t x) { return FT_Fixed(x * 0x10000 / (std::int64_t(1) << m.shift)); };
      const FT_Matrix matrix{fixed(m.xx), fixed(m.xy), fixed(m.yx), fixed(m.yy)};
      FT_Vector_Transform(&first, &matrix);
      offset = in_steps({rounded[points].x - first.x, rounded[points].y - first.y});
    }
    const std::int64_t factor = std::int64_t(1) << (shift - 1 - m.shift); // the part is in halves of a unit
    points += static_cast<std::size_t>(own.n_points);
    outline.begin_part(leaf.glyph);
    if (changed != nullptr && changed->count(leaf.glyph) != 0) part = changed->at(leaf.glyph);
    outline.append(part, [&](const Glyph_point& p) {
      const Glyph_point q = m(p);
      return Glyph_point{factor * q.x + offset.x, factor * q.y + offset.y};
    });
  }
  if (points != rounded.size()) throw Font_error("components that change");
  outline.set_shift(shift);
}

std::string Font_face::charstring(int glyph) const { return dictionary_value(face_.get(), PS_DICT_CHAR_STRING, glyph); }

int Font_face::glyph_of_code(std::int64_t code) const {
  static const char* const accents[] = {"grave",   "acute",     "circumflex",   "tilde",  "macron",
                                        "breve",   "dotaccent", "dieresis",     "",       "ring",
                                        "cedilla", "",          "hungarumlaut", "ogonek", "caron"}; // from 193 on
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
    else
      read_true_type(glyph, outline, changed);
  } catch (const Font_error&) {
    outline.clear();
    throw;
  }
}
