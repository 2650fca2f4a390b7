// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/Glyph_selection.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <unordered_map>

namespace {

constexpr char32_t last_character = 0x10FFFF;

[[noreturn]] void refuse(const std::string& text, const char* reason) {
  throw std::invalid_argument("--glyphs: '" + text + "' " + reason);
}

// The number that a text is, without anything before or behind it.
std::optional<char32_t> number(std::string_view text, int base) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const std::from_chars_result read = std::from_chars(text.data(), end, value, base);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return static_cast<char32_t>(value);
}

// The character at the begin of a text, which is taken away: as it is, or as U+XXXX.
std::optional<char32_t> take_character(std::string_view& text) {
  if (text.substr(0, 2) == "U+" && text.size() > 2) {
    const std::size_t end = (std::min)(text.find('-', 2), text.size());
    const std::optional<char32_t> code = number(text.substr(2, end - 2), 16);
    text.remove_prefix(end);
    return code && *code <= last_character ? code : std::nullopt;
  }
  const unsigned lead = text.empty() ? 0xFF : static_cast<unsigned char>(text[0]);
  // bytes of UTF-8
  const std::size_t more = lead < 0x80 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
  if (text.size() <= more || (0x80 <= lead && lead < 0xC2) || 0xF4 < lead) return std::nullopt;
  char32_t code = more == 0 ? lead : lead & (0x3Fu >> more);
  for (std::size_t i = 1; i <= more; ++i) {
    const unsigned byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xC0) != 0x80) return std::nullopt;
    code = code << 6 | (byte & 0x3F);
  }
  text.remove_prefix(more + 1);
  return code;
}

} // namespace

Glyph_selection::Item Glyph_selection::parsed(const std::string& text) {
  std::string_view rest = text;
  if (text.empty()) refuse(text, "is no glyph; the comma is U+002C");
  if (text[0] == '#' && text.size() > 1) {
    const std::size_t dash = (std::min)(text.find('-'), text.size());
    const std::optional<char32_t> first = number(rest.substr(1, dash - 1), 10);
    std::optional<char32_t> last = first;
    if (dash < text.size()) last = rest.substr(dash, 2) == "-#" ? number(rest.substr(dash + 2), 10) : std::nullopt;
    if (!first || !last || *last < *first)
      refuse(text, "is no number of a glyph, such as #12, nor a range such as #12-#20");
    return {text, Kind::numbers, *first, *last};
  }
  const bool is_code = rest.substr(0, 2) == "U+";
  const std::optional<char32_t> first = take_character(rest);
  if (first && rest.empty()) return {text, Kind::characters, *first, *first};
  if (first && rest.size() > 1 && rest[0] == '-') {
    rest.remove_prefix(1);
    const std::optional<char32_t> last = take_character(rest);
    if (last && rest.empty()) {
      if (*last < *first) refuse(text, "is a range that ends before it begins");
      return {text, Kind::characters, *first, *last};
    }
  }
  if (is_code) refuse(text, "is no character, such as U+00E9, nor a range such as U+0041-U+005A");
  return {text, Kind::name, 0, 0};
}

Glyph_selection::Glyph_selection(const std::string& text) {
  for (std::size_t begin = 0, end; begin <= text.size(); begin = end + 1) {
    end = (std::min)(text.find(',', begin), text.size());
    items_.push_back(parsed(text.substr(begin, end - begin)));
  }
}

std::vector<int> Glyph_selection::glyphs(const Font_face& font, std::vector<std::string>& missing) {
  std::vector<int> result;
  if (is_all()) {
    result.resize(static_cast<std::size_t>(font.glyphs()));
    std::iota(result.begin(), result.end(), 0);
    return result;
  }
  std::unordered_multimap<std::string, int> names;
  if (std::any_of(items_.begin(), items_.end(), [](const Item& item) { return item.kind == Kind::name; }))
    for (int glyph = 0; glyph < font.glyphs(); ++glyph) names.emplace(font.glyph_name(glyph), glyph);
  for (Item& item : items_) {
    const std::size_t before = result.size();
    if (item.kind == Kind::characters)
      font.for_characters(item.first, item.last, [&](char32_t, int glyph) { result.push_back(glyph); });
    else if (item.kind == Kind::numbers)
      for (char32_t i = item.first; i <= item.last && i < static_cast<char32_t>(font.glyphs()); ++i)
        result.push_back(static_cast<int>(i));
    else
      for (auto [i, end] = names.equal_range(item.text); i != end; ++i) result.push_back(i->second);
    if (result.size() == before)
      missing.push_back(item.text);
    else
      item.found = true;
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void Glyph_selection::check_all_found() const {
  std::string missing;
  for (const Item& item : items_)
    if (!item.found) missing += (missing.empty() ? "'" : ", '") + item.text + '\'';
  if (!missing.empty()) throw std::invalid_argument("--glyphs: no font has " + missing);
}
