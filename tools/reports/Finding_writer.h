// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_WRITER_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_WRITER_H

#include "reports/Report.h"

#include <memory>
#include <string>

// For reports that do not count by classes.
class Finding_writer {
  std::unique_ptr<Report::Writer> writer_;

public:
  explicit Finding_writer(std::unique_ptr<Report::Writer> writer) : writer_(std::move(writer)) {}
  void add(const Finding& f) { writer_->find(f); }
  void add_passed(const std::string& file, std::size_t n, const std::string&) { writer_->pass(file, n); }
  void print(std::ostream& os, const std::string& summary) {
    const Claims claims;
    const Report_mode mode;
    const Report_subject subject{"join", ""};
    writer_->print(os, summary, Conclusion(claims, mode, subject));
  }
};

inline std::unique_ptr<Finding_writer> finding_writer(Report_format format) {
  return std::make_unique<Finding_writer>(format == Report_format::sarif ? sarif_writer() : junit_writer());
}

// What such a report comes to.
struct Old_conclusion {
  std::size_t decided, failing, unverified;
  bool met(const Report_mode& mode) const {
    return failing == 0 && !(unverified > 0 && !(mode.allow_undecided && mode.allow_uncovered));
  }
  std::string json_met(const Report_mode& mode) const { return decided == 0 ? "null" : met(mode) ? "true" : "false"; }
  int exit_code(const Report_mode& mode, const std::string& what) const {
    Claims claims;
    claims.add({Claim::met, "x"}, decided);
    const Report_subject subject{what, ""};
    const int code = Conclusion(claims, mode, subject).exit_code();
    return code == bad_input || met(mode) ? code : static_cast<int>(requirement_not_met);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINDING_WRITER_H
