// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_H

#include "commands/commands.h"
#include "reports/Claims.h"
#include "reports/Conclusion.h"
#include "reports/Fingerprints.h"
#include "reports/finding.h"

#include <cstddef>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

class Known_findings;

// The decisions about some things, one after the other: a part of a report, which may be made on
// any core.
class Report_part {
  Report_mode mode_;
  Claims claims_;
  std::vector<std::pair<Finding, Given>> findings_;
  // how many things of which file have no finding
  std::vector<std::pair<std::string, std::size_t>> passed_;
  friend class Report;

public:
  // Rows of text, or JSON objects that begin with a comma: of all things, or of what is not met and
  // not decided.
  std::string rows, failing_rows;

  Report_part() = default;
  explicit Report_part(const Report_mode& mode) : mode_(mode) {}

  // Returns whether findings are written, and no rows.
  bool has_findings() const { return mode_.has_findings(); }

  // Counts a thing of a file. make() returns its finding, without class and level, if it is to have
  // one: that is called when findings are written, for all that is not met and not decided, and for
  // what is worth a note.
  template <class Make> void add(const std::string& file, const Given& given, bool is_noted, Make make) {
    claims_.add(given);
    if (!has_findings()) return;
    if (given.claim == Claim::met && !is_noted) return pass(file, 1);
    Finding finding = make();
    finding.claim = given.claim;
    findings_.emplace_back(std::move(finding), given);
  }

  // Counts things of a file that have no finding.
  void add(const std::string& file, const Given& given, std::size_t n = 1) {
    claims_.add(given, n);
    if (has_findings()) pass(file, n);
  }

private:
  void pass(const std::string& file, std::size_t n) {
    if (passed_.empty() || passed_.back().first != file)
      passed_.emplace_back(file, n);
    else
      passed_.back().second += n;
  }
};

// The report of `verify`: it alone counts, says in the end what follows from the counts, and
// returns the exit code. Its content is in rows, which a command makes; of what has no row only
// findings tell, as SARIF and JUnit write them.
class Report {
public:
  // Writes a report when all is decided.
  class Writer {
  public:
    virtual ~Writer() = default;

    // Lines of text, or JSON objects with a comma before each, which belong to an array: all, and
    // those of what is not met and not decided.
    virtual void row(const std::string& array, const std::string& rows, const std::string& failing_rows) = 0;

    // A finding, with its level.
    virtual void find(const Finding& finding) = 0;

    // So many more things of a file have no finding. It is called for each file, also with 0.
    virtual void pass(const std::string& file, std::size_t n) = 0;

    // `summary` is lines of text, or the members of a JSON object, which may begin with more
    // members of the report.
    virtual void print(std::ostream& os, const std::string& summary, const Conclusion& end) = 0;
  };

private:
  const Report_mode mode_;
  Report_subject subject_;
  Claims claims_;
  std::unique_ptr<Writer> writer_;
  Fingerprint_maker fingerprints_;
  std::unique_ptr<Known_findings> known_;            // with a baseline
  std::vector<std::pair<Finding, Given>> unsettled_; // which are not known where they are

  void know(const Finding& finding, const Given& given);
  void settle();

public:
  Report(const Report_mode& mode, Report_subject subject);
  ~Report();

  const Report_mode& mode() const { return mode_; }
  const Report_subject& subject() const { return subject_; }

  // Adds words to what is said of all things in the end.
  void say_of_every(const std::string& words) { subject_.every += words; }

  // Replaces the noun of what is decided, and what is said of all of it in the end.
  void speak_of(const std::string& noun, const std::string& every) {
    subject_.noun = noun;
    subject_.every = every;
  }

  // Names a file, also one without anything to decide.
  void begin_file(const std::string& name) { writer_->pass(name, 0); }

  // Adds what was decided, the rows to this array.
  void add(const Report_part& part, const std::string& array = {});

  // Adds one thing or its finding, see Report_part. Its row, if it has one, is added apart.
  template <class Make> void add(const std::string& file, const Given& given, bool is_noted, Make make) {
    Report_part part(mode_);
    part.add(file, given, is_noted, make);
    add(part);
  }
  void add(const std::string& file, const Given& given, std::size_t n = 1) {
    Report_part part(mode_);
    part.add(file, given, n);
    add(part);
  }

  // Returns whether rows of things of this class are shown: not in a summary of what is met.
  bool shows(Claim claim) const { return !mode_.summary || claim != Claim::met; }

  // Adds rows of things of this class to an array, or names an array which may stay empty.
  void row(const std::string& array, const std::string& text = {}, Claim claim = Claim::not_met) {
    writer_->row(array, text, claim == Claim::met ? std::string() : text);
  }

  // Prints the report and returns the exit code. The summary is lines of text, or members of a JSON
  // object.
  int print(std::ostream& os, const std::string& summary);
};

// The writers of the formats.
std::unique_ptr<Report::Writer> report_writer(const Report_mode& mode);
std::unique_ptr<Report::Writer> sarif_writer(bool is_new = false);
std::unique_ptr<Report::Writer> finding_writer(Report_format format);
std::unique_ptr<Report::Writer> junit_writer();

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_H
