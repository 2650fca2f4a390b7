// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_FINDINGS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_FINDINGS_H

#include "commands/chains/join_report.h"
#include "commands/commands.h"
#include "commands/fonts/Instance_kinks.h"
#include "reports/Finding_writer.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// The kinks of variable fonts as findings: those of the worst joins that are not proved to stay within the bound; how many
// more there are, one finding tells.
class Instance_findings {
  const std::unique_ptr<Finding_writer> writer_;
  const Finding_level unverified_, level_;

public:
  Instance_findings(const Report_mode& mode, bool required)
      : writer_(finding_writer(mode.format)),
        unverified_(!mode.allow_undecided ? Finding_level::error : Finding_level::warning),
        level_(required ? Finding_level::error : Finding_level::note) {}

  // What is in a font; `place` begins the places in it, e.g. "font 1, ".
  void add_font(const std::string& file, const std::string& place, const Instance_counts& counts,
                const std::vector<Instance_kink>& worst, const std::vector<GC::Variation_axis>& axes) {
    std::size_t wanted = counts.refuted + counts.undecided;
    writer_->add_passed(file, counts.proved + counts.corners, "joins");
    for (const Instance_kink& kink : worst) {
      if (kink.kink.verdict == GC::Verdict::proved) continue;
      const bool refuted = kink.kink.verdict == GC::Verdict::refuted;
      writer_->add({file, 0, "glyph",
                    place + "glyph " + kink.glyph_name + ", contour " + std::to_string(kink.contour) + ", point " +
                        std::to_string(kink.point),
                    refuted ? Finding_rule::kink : Finding_rule::undecided, level_, kink_text(kink),
                    kink_json(kink, axes)});
      --wanted;
    }
    if (wanted != 0)
      writer_->add({file, 0, "font", place + "all glyphs", Finding_rule::kink, level_,
                    counted(wanted, "more join") + " not proved to stay within the bound; --worst N tells N of them",
                    "\"joins\":" + std::to_string(wanted)});
    if (counts.unverified() != 0)
      not_verified(file, "font", place + "all glyphs",
                   counted(counts.unverified(), "join") + " of no direction or not covered");
  }

  // What could not be verified, and why.
  void not_verified(const std::string& file, const std::string& kind, const std::string& place,
                    const std::string& reason) {
    writer_->add({file, 0, kind, place, Finding_rule::not_verified, unverified_, "not verified, " + reason, ""});
  }

  // Writes the report with the members of a JSON object.
  void print(std::ostream& os, const std::string& summary) { writer_->print(os, summary); }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_FINDINGS_H
