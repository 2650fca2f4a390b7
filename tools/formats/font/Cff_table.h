// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_TABLE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_TABLE_H

#include "formats/font/Font_bytes.h"
#include "formats/font/Item_variations.h"
#include "formats/font/Type_2_charstring.h"

#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The charstrings of a font with cubic curves, and what they refer to.

namespace CGAL {
namespace Geometric_continuity {

/// A table 'CFF ' (Adobe Technical Note 5176) or 'CFF2' (OpenType specification). It refers to the
/// bytes of the table.
class Cff_table {
public:
  typedef std::vector<std::string_view> Index;
  typedef std::vector<std::vector<Variation_region>> Regions;

private:
  struct Part { // of the glyphs, a "font" of the table
    Index subroutines = {};
    std::size_t variation_set = 0;
  };
  typedef std::map<int, std::vector<double>> Dictionary;
  enum Key {
    escape = 12,
    charstrings = 17,
    private_part = 18,
    subroutines = 19,
    variation_set = 22,
    blend = 23,
    store = 24,
    charstring_type = 0x0c06,
    matrix = 0x0c07,
    part_array = 0x0c24,
    part_selection = 0x0c25
  };

  std::string_view table_;
  bool is_cff2_;
  Index charstrings_, subroutines_;
  std::vector<Part> parts_;
  std::vector<std::size_t> selection_; // the part of each glyph
  Regions regions_;
  std::vector<std::size_t> region_counts_; // of each set

public:
  /// Reads what all glyphs have in common. `axes` are those of the font, if it is known how many
  /// they are. \throws Error `malformed_input`
  explicit Cff_table(std::string_view table, std::optional<std::size_t> axes = std::nullopt)
      : table_(table), is_cff2_(table.substr(0, 1) == "\2") {
    Font_bytes bytes = whole();
    const std::size_t header = static_cast<std::size_t>(bytes.seek(2).u8());
    Dictionary top;
    if (is_cff2_) {
      const std::size_t size = static_cast<std::size_t>(bytes.u16());
      top = read_dictionary(bytes.seek(header).take(size));
    } else {
      read_index(bytes.seek(header)); // names
      const Index tops = read_index(bytes);
      if (tops.size() != 1) not_covered("a table 'CFF' of several fonts");
      top = read_dictionary(tops[0]);
      read_index(bytes); // texts
    }
    if (top.count(charstring_type) != 0 && offset(top, charstring_type) != 2)
      not_covered("charstrings of type " + std::to_string(offset(top, charstring_type)) + " in a table 'CFF'");
    scale(top);
    subroutines_ = read_index(bytes);
    charstrings_ = read_index(bytes.seek(offset(top, charstrings)));
    if (charstrings_.size() > 0xffff) bytes.refuse("there are more than 65535 glyphs");
    if (is_cff2_ && top.count(store) != 0) {
      const std::size_t begin = offset(top, store);
      bytes.seek(begin).skip(2); // its length
      regions_ = read_variation_store(table_.substr(begin + 2), axes);
      for (const auto& set : regions_) region_counts_.push_back(set.size());
    }
    read_parts(top);
  }

  bool is_cff2() const { return is_cff2_; }
  std::size_t glyph_count() const { return charstrings_.size(); }

  /// Returns the charstring of a glyph, and what it refers to, which this object owns.
  std::string_view charstring(std::size_t glyph) const { return charstrings_[glyph]; }
  Type_2_context context(std::size_t glyph) const {
    const Part& part = parts_[selection_[glyph]];
    return {subroutines_, part.subroutines, is_cff2_ ? &region_counts_ : nullptr, part.variation_set};
  }

  /// Returns the sets of regions in which numbers vary.
  const Regions& regions() const { return regions_; }

private:
  Font_bytes whole() const { return {table_, is_cff2_ ? "table 'CFF2'" : "table 'CFF'"}; }

  [[noreturn]] static void not_covered(const std::string& what) {
    throw Error(Error_code::malformed_input, "not covered: " + what);
  }

  Index read_index(Font_bytes& bytes) const {
    const std::size_t count = bytes.unsigned_number(is_cff2_ ? 4 : 2);
    Index entries;
    if (count == 0) return entries;
    const std::size_t size = static_cast<std::size_t>(bytes.u8());
    if (size < 1 || 4 < size || bytes.left() / size <= count) bytes.refuse("an index is longer than the table");
    Font_bytes places = bytes;
    bytes.skip((count + 1) * size);
    std::size_t last = places.unsigned_number(size);
    if (last < 1) bytes.refuse("the entries of an index do not ascend");
    bytes.skip(last - 1);
    entries.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = places.unsigned_number(size);
      if (next < last) bytes.refuse("the entries of an index do not ascend");
      entries.push_back(bytes.take(next - last));
      last = next;
    }
    return entries;
  }

  // A number with decimals, in half bytes.
  static double read_real(Font_bytes& bytes) {
    static const char* const texts[] = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", ".", "e", "e-", "", "-"};
    for (std::string text;;) {
      const int byte = bytes.u8();
      for (const int half : {byte >> 4, byte & 15}) {
        if (half == 15) {
          double x = 0; // of what is no number, too
          std::from_chars(text.data(), text.data() + text.size(), x);
          return x;
        }
        text += texts[half];
      }
    }
  }

  // The operands of each operator; what varies is of no use here.
  static Dictionary read_dictionary(std::string_view dictionary) {
    Font_bytes bytes(dictionary, "table 'CFF', a dictionary");
    Dictionary result;
    std::vector<double> operands;
    while (bytes.left() != 0) {
      const int byte = bytes.u8();
      if (byte == 30)
        operands.push_back(read_real(bytes));
      else if (byte == 29)
        operands.push_back(static_cast<double>(bytes.i32()));
      else if (byte == 28)
        operands.push_back(bytes.i16());
      else if (byte >= 32 && byte < 255)
        operands.push_back(
            static_cast<double>(charstring::short_integer(byte, byte < charstring::first_of_two ? 0 : bytes.u8())));
      else if (byte != blend && byte != 255) {
        result[byte == escape ? escape << 8 | bytes.u8() : byte] = std::move(operands);
        operands.clear();
      }
    }
    return result;
  }

  std::size_t offset(const Dictionary& dictionary, int key, std::size_t number = 0) const {
    const auto found = dictionary.find(key);
    if (found == dictionary.end() || found->second.size() <= number)
      whole().refuse("an entry of a dictionary is missing, number " + std::to_string(key));
    const double x = found->second[number];
    if (!(0 <= x && x < 4294967296.0)) whole().refuse("an offset is negative");
    return static_cast<std::size_t>(x);
  }

  // The factor of a matrix, which has to scale all glyphs and to do no more.
  static double scale(const Dictionary& dictionary) {
    const auto m = dictionary.find(matrix);
    if (m == dictionary.end()) return 1;
    const std::vector<double>& x = m->second;
    if (x.size() != 6 || x[0] != x[3] || !(0 < x[0]) || x[1] != 0 || x[2] != 0 || x[4] != 0 || x[5] != 0)
      not_covered("a matrix of the font that does more than scale");
    return x[0];
  }

  Part read_part(const Dictionary& dictionary) const {
    Part part;
    if (dictionary.count(private_part) == 0) return part;
    Font_bytes bytes = whole();
    const std::size_t size = offset(dictionary, private_part, 0), begin = offset(dictionary, private_part, 1);
    const Dictionary values = read_dictionary(bytes.seek(begin).take(size));
    if (values.count(variation_set) != 0) part.variation_set = offset(values, variation_set);
    if (values.count(subroutines) != 0) part.subroutines = read_index(bytes.seek(begin + offset(values, subroutines)));
    return part;
  }

  void read_parts(const Dictionary& top) {
    selection_.assign(charstrings_.size(), 0);
    if (top.count(part_array) == 0) {
      parts_.push_back(read_part(top));
      return;
    }
    Font_bytes bytes = whole();
    double first = 0;
    for (const std::string_view text : read_index(bytes.seek(offset(top, part_array)))) {
      const Dictionary dictionary = read_dictionary(text);
      const double own = scale(dictionary);
      if (!parts_.empty() && own != first) not_covered("parts of the font that are scaled differently");
      first = own;
      parts_.push_back(read_part(dictionary));
    }
    if (top.count(part_selection) != 0) read_selection(bytes.seek(offset(top, part_selection)));
    for (const std::size_t part : selection_)
      if (parts_.size() <= part) bytes.refuse("there is no part " + std::to_string(part) + " of a glyph");
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

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF_TABLE_H
