// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/deferred_output.h"
#include "files/terminal.h"
#include "reports/Fingerprints.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <cstddef>
#include <utility>

// Reports of what is new only, with a baseline: a line for each finding, as compilers write them,
// or an array of findings as JSON.

namespace {

class Finding_lines : public Report::Writer {
  const std::size_t columns_ = output_columns();
  Deferred_output lines_;

public:
  void row(const std::string&, const std::string&, const std::string&) override {}
  void find(const Finding& f) override {
    lines_.write(
        within_columns(CGAL::Geometric_continuity::printable(f.file + (f.line > 0 ? ':' + std::to_string(f.line) : "") +
                                                             ": " + level_name(f.level) + ": " + f.place + ": " +
                                                             f.message + " [" + rule_id(f.rule) + ']') +
                           '\n',
                       columns_));
  }
  void pass(const std::string&, std::size_t) override {}
  void print(std::ostream& os, const std::string& summary, const Conclusion& end) override {
    lines_.copy_to(os);
    os << within_columns(summary + end.text(), columns_);
  }
};

class Finding_objects : public Report::Writer {
  Deferred_output objects_;

public:
  void row(const std::string&, const std::string&, const std::string&) override {}
  void find(const Finding& f) override {
    const std::string properties = json_properties(f);
    objects_.write((objects_.size() == 0 ? "\n  {\"rule\":\"" : ",\n  {\"rule\":\"") + std::string(rule_id(f.rule)) +
                   "\",\"level\":\"" + level_name(f.level) + "\",\"file\":" + json_text(f.file) +
                   ",\"line\":" + (f.line > 0 ? std::to_string(f.line) : "null") + ",\"place\":" + json_text(f.place) +
                   ",\"message\":" + json_text(f.message) + ",\"fingerprint\":\"" + f.fingerprints.place +
                   "\",\"defect_fingerprint\":\"" + f.fingerprints.defect + '"' +
                   (properties.empty() ? "" : ",\"properties\":{" + properties + '}') + '}');
  }
  void pass(const std::string&, std::size_t) override {}
  void print(std::ostream& os, const std::string& summary, const Conclusion& end) override {
    os << "{\"findings\":[";
    objects_.copy_to(os);
    os << "],\n " << summary << ",\n " << end.json() << "}\n";
  }
};

} // namespace

std::unique_ptr<Report::Writer> finding_writer(Report_format format) {
  if (format == Report_format::json) return std::make_unique<Finding_objects>();
  return std::make_unique<Finding_lines>();
}
