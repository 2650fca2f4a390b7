// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_QUOTED_TOKEN_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_QUOTED_TOKEN_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Returns a text as messages show it: in single quotes, cut after 40 characters, and with bytes that cannot be printed
/// as `\xHH`.
inline std::string quoted_token(std::string_view text) {
  constexpr std::size_t longest = 40;
  constexpr char hex[] = "0123456789ABCDEF";
  std::string result = "'";
  for (char c : text.substr(0, longest)) {
    const unsigned char byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F)
      result += c;
    else
      result += {'\\', 'x', hex[byte / 16], hex[byte % 16]};
  }
  return result + (text.size() > longest ? "...'" : "'");
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_QUOTED_TOKEN_H
