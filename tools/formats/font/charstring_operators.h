// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_OPERATORS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_OPERATORS_H

#include "formats/font/Font_error.h"

#include <cstdint>
#include <string>

// The meaning of the bytes of charstrings: in Type 1 fonts (Adobe Type 1 Font Format, 1990), in
// tables 'CFF ' (Adobe Technical Note 5177) and 'CFF2' (OpenType specification, "CFF2 CharString
// Format").
namespace charstring {

// Behind the byte `escape` they begin at 0x0c00.
enum Operator {
  hstem = 1,
  vstem = 3,
  vmove = 4,
  line = 5,
  hline = 6,
  vline = 7,
  curve = 8,
  close = 9,
  subroutine = 10,
  back = 11,
  escape = 12,
  bearing = 13,
  end = 14,
  set = 15,
  blending = 16,
  hstems = 18,
  hints = 19,
  counters = 20,
  move = 21,
  hmove = 22,
  vstems = 23,
  curves_line = 24,
  lines_curve = 25,
  vvcurve = 26,
  hhcurve = 27,
  integer = 28,
  global = 29,
  vhcurve = 30,
  hvcurve = 31,
  dot = 0x0c00,
  vstem3 = 0x0c01,
  hstem3 = 0x0c02,
  accented = 0x0c06,
  bearings = 0x0c07,
  absolute = 0x0c09,
  sum = 0x0c0a,
  difference = 0x0c0b,
  quotient = 0x0c0c,
  negative = 0x0c0e,
  other_subroutine = 0x0c10,
  pop = 0x0c11,
  drop = 0x0c12,
  product = 0x0c18,
  copy = 0x0c1b,
  exchange = 0x0c1c,
  set_point = 0x0c21,
  hflex = 0x0c22,
  flex = 0x0c23,
  hflex1 = 0x0c24,
  flex1 = 0x0c25
};

// An integer, also of a dictionary, whose first byte is from 32 to 254. From this one on there is a
// second byte.
constexpr int first_of_two = 247;
inline std::int64_t short_integer(int first, std::int64_t second) {
  if (first < first_of_two) return first - 139;
  if (first < 251) return (first - 247) * 256 + second + 108;
  return -(first - 251) * 256 - second - 108;
}

[[noreturn]] inline void refuse(const std::string& reason) { throw Font_error("charstring: " + reason); }

[[noreturn]] inline void refuse_operator(int operation) {
  throw Font_error("not covered: the operator " + std::to_string(operation & 0xff) +
                   (operation > 0xff ? " behind 12" : "") + " of its charstring");
}

} // namespace charstring

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CHARSTRING_OPERATORS_H
