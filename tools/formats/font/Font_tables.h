// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_TABLES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_TABLES_H

#include "formats/font/Font_bytes.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

/// The tables of a font file. OpenType specification, "Organization of an OpenType Font".

namespace CGAL {
namespace Geometric_continuity {

/// The table directory of an OpenType or TrueType font, or of one face of a collection. It refers
/// to the bytes, which must outlive it; fonts that are packed (WOFF) are not read.
class Font_tables {
  std::map<std::string, std::string_view, std::less<>> tables_;

  static Font_bytes whole(std::string_view font) { return {font, "font"}; }
  static bool is_collection(std::string_view font) { return font.substr(0, 4) == "ttcf"; }

public:
  /// Returns the number of faces: 1 except for collections. \throws Error `malformed_input`
  static std::size_t face_count(std::string_view font) {
    if (!is_collection(font)) return 1;
    Font_bytes bytes = whole(font).seek(8);
    const std::size_t count = bytes.u32();
    if (bytes.left() / 4 < count) bytes.refuse("it is too short for " + std::to_string(count) + " faces");
    return count;
  }

  /// Reads the directory of a face. \f$ O(k \log k) \f$ for `k` tables
  /// \throws Error `malformed_input` for other bytes, for tables that lie outside of them and for a
  ///   table that is there twice, `parameter_outside_domain` when there is no such face
  explicit Font_tables(std::string_view font, std::size_t face = 0) {
    Font_bytes bytes = whole(font);
    if (face_count(font) <= face)
      throw Error(Error_code::parameter_outside_domain, "Font_tables: there is no face " + std::to_string(face));
    if (is_collection(font)) bytes.seek(bytes.seek(12 + 4 * face).u32());
    const std::string_view version = bytes.take(4);
    if (version != std::string_view("\0\1\0\0", 4) && version != "true" && version != "OTTO")
      bytes.refuse("its first bytes are those of no OpenType or TrueType font");
    const int count = bytes.u16();
    bytes.skip(6);
    for (int i = 0; i < count; ++i) {
      const std::string tag(bytes.take(4));
      bytes.skip(4); // a checksum
      const std::size_t begin = bytes.u32(), size = bytes.u32();
      if (font.size() < begin || font.size() - begin < size) bytes.refuse("its table '" + tag + "' lies outside of it");
      if (!tables_.emplace(tag, font.substr(begin, size)).second)
        bytes.refuse("its table '" + tag + "' is there twice");
    }
  }

  /// Returns whether there is a table, e.g. "gvar".
  bool has(std::string_view tag) const { return tables_.find(tag) != tables_.end(); }

  /// Returns the bytes of a table. \throws Error `malformed_input` when it is missing
  std::string_view table(std::string_view tag) const {
    const auto found = tables_.find(tag);
    if (found == tables_.end())
      throw Error(Error_code::malformed_input, "font: the table '" + std::string(tag) + "' is missing");
    return found->second;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_FONT_TABLES_H
