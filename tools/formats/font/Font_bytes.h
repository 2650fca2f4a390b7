// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_BYTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_BYTES_H

#include <CGAL/Geometric_continuity/Error.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

/// The bytes of a part of a font, most significant byte first, of which none is read outside of
/// that part.

namespace CGAL {
namespace Geometric_continuity {

// Reads numbers one after the other. What is malformed is an Error `malformed_input` that begins
// with the place.
class Font_bytes {
  std::string_view bytes_;
  std::string place_; // e.g. "table 'gvar', glyph 12"
  std::size_t next_ = 0;

  [[noreturn]] void refuse_end() const { refuse("it ends at byte " + std::to_string(bytes_.size()) + ", too early"); }
  void need(std::size_t size) const {
    if (left() < size) refuse_end();
  }

public:
  Font_bytes(std::string_view bytes, std::string place) : bytes_(bytes), place_(std::move(place)) {}

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, place_ + ": " + reason);
  }

  std::size_t size() const { return bytes_.size(); }
  std::size_t left() const { return bytes_.size() - next_; }

  // Goes to a byte, and over some.
  Font_bytes& seek(std::size_t position) {
    if (bytes_.size() < position) refuse_end();
    next_ = position;
    return *this;
  }
  void skip(std::size_t size) { take(size); }

  // The next bytes.
  std::string_view take(std::size_t size) {
    need(size);
    next_ += size;
    return bytes_.substr(next_ - size, size);
  }

  std::uint32_t unsigned_number(std::size_t size) {
    std::uint32_t x = 0;
    for (char c : take(size)) x = x << 8 | static_cast<unsigned char>(c);
    return x;
  }
  int u8() {
    need(1);
    return static_cast<unsigned char>(bytes_[next_++]);
  }
  int u16() {
    need(2);
    next_ += 2;
    return static_cast<unsigned char>(bytes_[next_ - 2]) << 8 | static_cast<unsigned char>(bytes_[next_ - 1]);
  }
  std::uint32_t u32() { return unsigned_number(4); }
  int i8() { return (u8() ^ 0x80) - 0x80; }
  int i16() { return (u16() ^ 0x8000) - 0x8000; }
  double f2dot14() { return static_cast<double>(i16()) / 0x4000; } // exact
  std::int64_t i32() { return (std::int64_t(u32()) ^ 0x80000000) - 0x80000000; }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_BYTES_H
