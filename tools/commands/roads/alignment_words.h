// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ALIGNMENT_WORDS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ALIGNMENT_WORDS_H

#include "reports/words.h"

#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <cmath>
#include <optional>
#include <string>

namespace GC = CGAL::Geometric_continuity;

// Words and JSON for what is decided of the joins of roads and rails.
namespace road_words {

inline std::string flag(bool x) { return x ? "true" : "false"; }
inline std::string flag(GC::Verdict v) {
  return v == GC::Verdict::proved ? "true" : v == GC::Verdict::refuted ? "false" : "null";
}
inline std::string json(const GC::Enclosure& x) { return json_text(std::optional<GC::Enclosure>(x)); }

// A size in words, short, with its unit; an upper bound where the bounds differ by much.
inline std::string size(const GC::Enclosure& x, const char* unit) {
  if (x.upper == 0) return std::string("0") + unit;
  if (std::isinf(x.upper)) return "more than " + rounded(x.lower, 4) + unit;
  if (x.upper <= 1.0001 * x.lower) return rounded(x.lower / 2 + x.upper / 2, 4) + unit;
  return "at most " + rounded(x.upper * 1.001, 4) + unit; // also when it is rounded
}

// The members of a join.
inline std::string members(const GC::Alignment_join& join) {
  return ",\"gap\":" + json(join.gap) + ",\"kink\":" + json(join.kink) + ",\"jump\":" + json_text(join.jump) +
         ",\"g0\":" + flag(join.g0) + ",\"g1\":" + flag(join.g1) + ",\"g2\":" + flag(join.g2) +
         ",\"same_point\":" + flag(join.same_point) + ",\"same_heading\":" + flag(join.same_heading) +
         ",\"same_curvature\":" + (join.jump ? flag(join.same_curvature) : "null");
}

} // namespace road_words

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_ROADS_ALIGNMENT_WORDS_H
