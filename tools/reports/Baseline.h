// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H

#include "files/input.h"
#include "reports/Json_view.h"

#include <iterator>
#include <string>
#include <unordered_set>

// The name of fingerprints in SARIF: they are made of the rule, the file and the place.
constexpr const char* fingerprint_name = "ruleFilePlace/v1";

// The findings that are known: the fingerprints of a report that `--format sarif` has written.
class Baseline {
  std::unordered_set<std::string> known_;

public:
  // Reads the report. Throws Error `malformed_input` for anything else, also for a part of one.
  explicit Baseline(const std::string& file) {
    namespace GC = CGAL::Geometric_continuity;
    Input input(file);
    const std::string text{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
    const auto refuse = [&] {
      throw GC::Error(GC::Error_code::malformed_input,
                      input_name(file) + ": no report in the format SARIF, as --format sarif writes it");
    };
    try {
      const std::optional<Json_view> runs = Json_view::of(text).member("runs");
      if (!runs) refuse();
      runs->for_elements([&](const Json_view& run) {
        const std::optional<Json_view> results = run.member("results");
        if (!results) return;
        results->for_elements([&](const Json_view& result) {
          if (const auto prints = result.member("partialFingerprints"))
            if (const auto print = prints->member(fingerprint_name))
              if (const auto hash = print->string()) known_.emplace(*hash);
        });
      });
    } catch (const GC::Error& e) {
      if (e.code() != GC::Error_code::malformed_input) throw;
      refuse();
    }
  }

  bool knows(const std::string& fingerprint) const { return known_.count(fingerprint) != 0; }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_BASELINE_H
