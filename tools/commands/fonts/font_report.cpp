// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/font_report.h"

Join_numbers::Join_numbers(const Shown_join& join)
    : x(rounded(join.right.start().x / 2.0, 10)), y(rounded(join.right.start().y / 2.0, 10)) {
  const GC::Kink_size size = Glyph_join(join.left, join.right).size();
  degrees = GC::in_degrees(size.angle);
  units = size.handle_offset.upper / 2;
  per_mille = 1000 * join.severity;
}

std::unique_ptr<Font_report> font_report(const Report_mode& mode, const std::optional<GC::Join_grade>& required) {
  return mode.has_findings()                  ? font_findings(mode, required)
         : mode.format == Report_format::json ? font_json(mode, required)
                                              : font_text(mode, required);
}
