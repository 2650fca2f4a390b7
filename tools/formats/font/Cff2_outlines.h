// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H

#include "formats/font/Cff2_charstring.h"
#include "formats/font/Font_tables.h"
#include "formats/font/Item_variations.h"

#include <charconv>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The outlines of a font with cubic curves that vary. OpenType specification, table 'CFF2'.

namespace CGAL {
namespace Geometric_continuity {

/// The table 'CFF2' of a font. It refers to the bytes of the font.
class Cff2_outlines {
  struct Part { // of the glyphs, a "font" of the table
    std::vector<std::string_view> subroutines;
    std::size_t variation_set = 0;
  };
  typedef std::map<int, std::vector<double>> Dictionary;
  enum { charstrings = 17, private_part = 18, subroutines = 19, variation_set = 22, store = 24 };
  enum { escape = 12, blend = 23, part_array = 0x0c24, part_selection = 0x0c25, matrix = 0x0c07 };

  std::string_view table_;
  int units_per_em_;
  std::vector<std::vector<Variation_region>> regions_;
  std::vector<std::string_view> charstrings_, subroutines_;
  std::vector<Part> parts_;
  std::vector<std::size_t> selection_; // the part of each glyph

public:
  /// Reads what all glyphs have in common. \throws Error `malformed_input`
  Cff2_outlines(const Font_tables& font, std::size_t axes) : table_(font.table("CFF2")) {
    Font_bytes head(font.table("head"), "table 'head'"), bytes(table_, "table 'CFF2'");
    units_per_em_ = head.seek(18).u16();
    if (units_per_em_ == 0) head.refuse("the em has no units");
    if (bytes.u8() != 2) bytes.refuse("its version is not 2");
    const std::size_t header = static_cast<std::size_t>(bytes.seek(2).u8()),
                      size = static_cast<std::size_t>(bytes.u16());
    const Dictionary top = read_dictionary(bytes.seek(header).take(size));
    if (top.count(matrix) != 0) check_matrix(bytes, top.at(matrix));
    subroutines_ = read_index(bytes);
    charstrings_ = read_index(bytes.seek(offset(bytes, top, charstrings)));
    if (charstrings_.size() > 0xffff) bytes.refuse("there are more than 65535 glyphs");
    if (top.count(store) != 0) {
      bytes.seek(offset(bytes, top, store)).skip(2); // its length
      regions_ = read_variation_store(table_.substr(offset(bytes, top, store) + 2), axes);
    }
    for (const std::string_view part : read_index(bytes.seek(offset(bytes, top, part_array))))
      parts_.push_back(read_part(bytes, read_dictionary(part)));
    selection_.assign(charstrings_.size(), 0);
    if (top.count(part_selection) != 0) read_selection(bytes.seek(offset(bytes, top, part_selection)));
    for (std::size_t part : selection_)
      if (parts_.size() <= part) bytes.refuse("there is no part " + std::to_string(part) + " of a glyph");
  }

  /// Returns the number of glyphs.
  int glyph_count() const { return static_cast<int>(charstrings_.size()); }
  /// Returns the number of units of which the em consists.
  int units_per_em() const { return units_per_em_; }

  /// Reads a glyph. \throws Error `malformed_input`, `work_limit`, `parameter_outside_domain` when there is no such glyph
  Variable_outline glyph(int index) const {
    if (index < 0 || glyph_count() <= index)
      throw Error(Error_code::parameter_outside_domain, "there is no glyph " + std::to_string(index));
    const std::size_t i = static_cast<std::size_t>(index);
    const Part& part = parts_[selection_[i]];
    return Cff2_charstring("table 'CFF2', glyph " + std::to_string(index), subroutines_, part.subroutines, regions_,
                           part.variation_set)
        .outline(charstrings_[i]);
  }

private:
  static std::size_t offset(const Font_bytes& bytes, const Dictionary& dictionary, int key, std::size_t number = 0) {
    const auto found = dictionary.find(key);
    if (found == dictionary.end() || found->second.size() <= number)
      bytes.refuse("an entry of a dictionary is missing, number " + std::to_string(key));
    const double x = found->second[number];
    if (!(0 <= x && x < 4294967296.0)) bytes.refuse("an offset is negative");
    return static_cast<std::size_t>(x);
  }

  // Only scaled by the units of the em.
  static void check_matrix(const Font_bytes& bytes, const std::vector<double>& m) {
    if (m.size() != 6 || m[0] != m[3] || m[1] != 0 || m[2] != 0 || m[4] != 0 || m[5] != 0)
      bytes.refuse("its matrix does more than scale");
  }

  static std::vector<std::string_view> read_index(Font_bytes& bytes) {
    const std::size_t count = bytes.u32();
    std::vector<std::string_view> entries;
    if (count == 0) return entries;
    const std::size_t size = static_cast<std::size_t>(bytes.u8());
    if (size < 1 || 4 < size || bytes.left() / size <= count) bytes.refuse("an index is longer than the table");
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i <= count; ++i) {
      places.push_back(bytes.unsigned_number(size));
      if (places.back() < (i == 0 ? 1 : places[i - 1])) bytes.refuse("the entries of an index do not ascend");
    }
    bytes.skip(places[0] - 1);
    for (std::size_t i = 0; i < count; ++i) entries.push_back(bytes.take(places[i + 1] - places[i]));
    return entries;
  }

  // A number with decimals, in half bytes.
  static double read_real(Font_bytes& bytes) {
    std::string text;
    for (;;) {
      const int byte = bytes.u8();
      for (const int half : {byte >> 4, byte & 15}) {
        if (half == 15) {
          double x = 0; // of what is no number, too
          std::from_chars(text.data(), text.data() + text.size(), x);
          return x;
        }
        static const char* const texts[] = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", ".", "e", "e-", "", "-"};
        text += texts[half];
      }
    }
  }

  // The operands of each operator; the values that vary are of no use here.
  static Dictionary read_dictionary(std::string_view dictionary) {
    Font_bytes bytes(dictionary, "table 'CFF2', a dictionary");
    Dictionary result;
    std::vector<double> operands;
    while (bytes.left() != 0) {
      const int byte = bytes.u8();
      if (byte == 30)
        operands.push_back(read_real(bytes));
      else if (byte == 29)
        operands.push_back(static_cast<double>(bytes.i32()));
      else if (byte == 28 || byte >= 32)
        operands.push_back(read_charstring_integer(bytes, byte));
      else if (byte != blend) {
        result[byte == escape ? escape << 8 | bytes.u8() : byte] = std::move(operands);
        operands.clear();
      }
    }
    return result;
  }

  Part read_part(const Font_bytes& bytes, const Dictionary& dictionary) const {
    Part part;
    if (dictionary.count(private_part) == 0) return part;
    const std::size_t size = offset(bytes, dictionary, private_part, 0),
                      begin = offset(bytes, dictionary, private_part, 1);
    Font_bytes place = bytes;
    const Dictionary values = read_dictionary(place.seek(begin).take(size));
    if (values.count(variation_set) != 0) part.variation_set = offset(bytes, values, variation_set);
    if (values.count(subroutines) != 0)
      part.subroutines = read_index(place.seek(begin + offset(bytes, values, subroutines)));
    return part;
  }

  void read_selection(Font_bytes& bytes) {
    const int format = bytes.u8();
    if (format == 0) {
      for (std::size_t& part : selection_) part = static_cast<std::size_t>(bytes.u8());
      return;
    }
    if (format != 3 && format != 4) bytes.refuse("its selection of parts is of an unknown format");
    const std::size_t long_size = format == 3 ? 2 : 4, short_size = format == 3 ? 1 : 2,
                      count = bytes.unsigned_number(long_size);
    std::size_t first = bytes.unsigned_number(long_size);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t part = bytes.unsigned_number(short_size), next = bytes.unsigned_number(long_size);
      if (next < first || selection_.size() < next) bytes.refuse("its selection of parts does not ascend");
      for (; first < next; ++first) selection_[first] = part;
    }
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_OUTLINES_H
