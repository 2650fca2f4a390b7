// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Cff_outlines.h"

#include "formats/font/Font_bytes.h"

#include <charconv>
#include <utility>

namespace {

typedef CGAL::Geometric_continuity::Font_bytes Font_bytes;
typedef std::vector<std::string_view> Index;
typedef std::map<int, std::vector<double>> Dictionary;

enum Key {
  charstrings = 17,
  private_part = 18,
  subroutines = 19,
  variation_set = 22,
  blend = 23,
  store = 24,
  escape = 12,
  charstring_type = 0x0c06,
  matrix = 0x0c07,
  part_array = 0x0c24,
  part_selection = 0x0c25
};

Index read_index(Font_bytes& bytes, std::size_t count_bytes) {
  const std::size_t count = bytes.unsigned_number(count_bytes);
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
double read_real(Font_bytes& bytes) {
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
Dictionary read_dictionary(std::string_view dictionary) {
  Font_bytes bytes(dictionary, "table 'CFF', a dictionary");
  Dictionary result;
  std::vector<double> operands;
  while (bytes.left() != 0) {
    const int byte = bytes.u8();
    if (byte == 30)
      operands.push_back(read_real(bytes));
    else if (byte == 29)
      operands.push_back(static_cast<double>(static_cast<std::int32_t>(bytes.u32())));
    else if (byte == 28)
      operands.push_back(bytes.i16());
    else if (byte >= 32 && byte < 247)
      operands.push_back(byte - 139);
    else if (byte >= 247 && byte < 255)
      operands.push_back(byte < 251 ? (byte - 247) * 256 + bytes.u8() + 108 : -(byte - 251) * 256 - bytes.u8() - 108);
    else if (byte != blend && byte != 255) {
      result[byte == escape ? escape << 8 | bytes.u8() : byte] = std::move(operands);
      operands.clear();
    }
  }
  return result;
}

std::size_t offset(const Font_bytes& bytes, const Dictionary& dictionary, int key, std::size_t number = 0) {
  const auto found = dictionary.find(key);
  if (found == dictionary.end() || found->second.size() <= number)
    bytes.refuse("an entry of a dictionary is missing, number " + std::to_string(key));
  const double x = found->second[number];
  if (!(0 <= x && x < 4294967296.0)) bytes.refuse("an offset is negative");
  return static_cast<std::size_t>(x);
}

// A matrix that only scales does so with all glyphs.
void check_matrix(const Dictionary& dictionary) {
  const auto m = dictionary.find(matrix);
  if (m == dictionary.end()) return;
  const std::vector<double>& x = m->second;
  if (x.size() != 6 || x[0] != x[3] || !(0 < x[0]) || x[1] != 0 || x[2] != 0 || x[4] != 0 || x[5] != 0)
    throw Font_error("not covered: a matrix of the font that does more than scale");
}

} // namespace

Cff_outlines::Cff_outlines(std::string table) : bytes_(std::move(table)), is_cff2_(bytes_.substr(0, 1) == "\2") {
  try {
    Font_bytes bytes(bytes_, is_cff2_ ? "table 'CFF2'" : "table 'CFF'");
    const std::size_t header = static_cast<std::size_t>(bytes.seek(2).u8()), count_bytes = is_cff2_ ? 4 : 2;
    Dictionary top;
    if (is_cff2_) {
      const std::size_t size = static_cast<std::size_t>(bytes.u16());
      top = read_dictionary(bytes.seek(header).take(size));
    } else {
      read_index(bytes.seek(header), count_bytes); // names
      const Index tops = read_index(bytes, count_bytes);
      if (tops.size() != 1) throw Font_error("not covered: a table 'CFF' of several fonts");
      top = read_dictionary(tops[0]);
      read_index(bytes, count_bytes); // texts
    }
    if (top.count(charstring_type) != 0 && offset(bytes, top, charstring_type) != 2)
      throw Font_error("not covered: charstrings of type " + std::to_string(offset(bytes, top, charstring_type)) +
                       " in a table 'CFF'");
    check_matrix(top);
    subroutines_ = read_index(bytes, count_bytes);
    charstrings_ = read_index(bytes.seek(offset(bytes, top, charstrings)), count_bytes);
    if (is_cff2_ && top.count(store) != 0) read_regions(offset(bytes, top, store) + 2); // behind its length
    read_parts(top);
  } catch (const CGAL::Geometric_continuity::Error& e) {
    throw Font_error(std::string(e.what()).substr(to_string(e.code()).size() + 2));
  }
}

void Cff_outlines::read_parts(const Dictionary& top) {
  Font_bytes bytes(bytes_, "table 'CFF'");
  const std::size_t count_bytes = is_cff2_ ? 4 : 2;
  const auto read_part = [&](const Dictionary& dictionary) {
    Part part;
    if (dictionary.count(private_part) == 0) return part;
    const std::size_t size = offset(bytes, dictionary, private_part, 0),
                      begin = offset(bytes, dictionary, private_part, 1);
    const Dictionary values = read_dictionary(bytes.seek(begin).take(size));
    if (values.count(variation_set) != 0) part.variation_set = offset(bytes, values, variation_set);
    if (values.count(subroutines) != 0)
      part.subroutines = read_index(bytes.seek(begin + offset(bytes, values, subroutines)), count_bytes);
    return part;
  };
  selection_.assign(charstrings_.size(), 0);
  if (top.count(part_array) == 0) {
    parts_.push_back(read_part(top));
    return;
  }
  double scale = 0;
  for (const std::string_view text : read_index(bytes.seek(offset(bytes, top, part_array)), count_bytes)) {
    const Dictionary dictionary = read_dictionary(text);
    check_matrix(dictionary);
    const double own = dictionary.count(matrix) == 0 ? 1 : dictionary.at(matrix)[0];
    if (!parts_.empty() && own != scale) throw Font_error("not covered: parts of the font that are scaled differently");
    scale = own;
    parts_.push_back(read_part(dictionary));
  }
  if (top.count(part_selection) != 0) {
    bytes.seek(offset(bytes, top, part_selection));
    const int format = bytes.u8();
    if (format == 0)
      for (std::size_t& part : selection_) part = static_cast<std::size_t>(bytes.u8());
    else if (format == 3 || format == 4) {
      const std::size_t long_size = format == 3 ? 2 : 4, short_size = format == 3 ? 1 : 2,
                        count = bytes.unsigned_number(long_size);
      std::size_t first = bytes.unsigned_number(long_size);
      for (std::size_t i = 0; i < count; ++i) {
        const std::size_t part = bytes.unsigned_number(short_size), next = bytes.unsigned_number(long_size);
        if (next < first || selection_.size() < next) bytes.refuse("its selection of parts does not ascend");
        for (; first < next; ++first) selection_[first] = part;
      }
    } else
      bytes.refuse("its selection of parts is of an unknown format");
  }
  for (const std::size_t part : selection_)
    if (parts_.size() <= part) bytes.refuse("there is no part " + std::to_string(part) + " of a glyph");
}

// Only how many regions a set has is of use: the numbers at the default instance come first.
void Cff_outlines::read_regions(std::size_t begin) {
  Font_bytes bytes(bytes_, "table 'CFF2'");
  const int sets = bytes.seek(begin + 6).u16();
  for (int i = 0; i < sets; ++i) {
    const std::size_t place = bytes.seek(begin + 8 + 4 * static_cast<std::size_t>(i)).u32();
    regions_.push_back(static_cast<std::size_t>(bytes.seek(begin + place + 4).u16()));
  }
}

std::optional<Accented_letter> Cff_outlines::draw(int glyph, Glyph_outline& outline, const Glyph_point& origin) const {
  const std::size_t i = static_cast<std::size_t>(glyph);
  if (charstrings_.size() <= i) throw Font_error("there is no charstring");
  const Part& part = parts_[selection_[i]];
  const Type_2_context context{subroutines_, part.subroutines, is_cff2_ ? &regions_ : nullptr, part.variation_set};
  return Type_2_charstring(context, outline).draw(charstrings_[i], origin);
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
