// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "reports/Report.h"

#include "files/deferred_output.h"
#include "files/terminal.h"
#include "reports/Baseline.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

// Lines in the order in which they come, then the summary and what follows. On a terminal only
// those of what is not met and not decided, if there are too many to be read. Lines are broken
// where they are longer than the terminal is wide.
class Text_writer : public Report::Writer {
  static constexpr std::size_t most_things_on_terminal = 5000;
  const bool summary_, may_be_short_;
  const std::size_t columns_ = output_columns(); // asked once, not for each line
  Deferred_output rows_, failing_rows_;

public:
  explicit Text_writer(bool summary) : summary_(summary), may_be_short_(!summary && isatty(STDOUT_FILENO) != 0) {}

  void write(Deferred_output& output, const std::string& lines) const {
    if (lines.size() <= columns_)
      output.write(lines);
    else
      output.write(within_columns(lines, columns_));
  }

  void row(const std::string&, const std::string& rows, const std::string& failing_rows) override {
    if (!summary_) write(rows_, rows);
    if (summary_ || may_be_short_) write(failing_rows_, failing_rows);
  }
  void find(const Finding&) override {}
  void pass(const std::string&, std::size_t) override {}
  void print(std::ostream& os, const std::string& summary, const Conclusion& end) override {
    const bool is_short = may_be_short_ && end.claims().given() > most_things_on_terminal;
    const Deferred_output& rows = is_short || summary_ ? failing_rows_ : rows_;
    if (rows.size() > 0) os << end.subject().table_head;
    rows.copy_to(os);
    os << within_columns(summary + end.text(), columns_);
    if (is_short) os << "the others are listed when the output is not a terminal\n";
  }
};

// An object with the arrays, in the order in which they are named, and the members of the summary.
class Json_writer : public Report::Writer {
  struct Array {
    std::string name;
    Deferred_output rows = {};
    bool is_empty = true;
  };
  const bool summary_;
  std::vector<std::unique_ptr<Array>> arrays_;

  Array& array(const std::string& name) {
    for (const std::unique_ptr<Array>& a : arrays_)
      if (a->name == name) return *a;
    arrays_.push_back(std::unique_ptr<Array>(new Array{name}));
    return *arrays_.back();
  }

public:
  explicit Json_writer(bool summary) : summary_(summary) {}

  void row(const std::string& name, const std::string& rows, const std::string& failing_rows) override {
    Array& a = array(name);
    const std::string& text = summary_ ? failing_rows : rows;
    if (!text.empty())
      // no comma before the first one
      a.rows.write(std::exchange(a.is_empty, false) ? text.substr(1) : text);
  }
  void find(const Finding&) override {}
  void pass(const std::string&, std::size_t) override {}
  void print(std::ostream& os, const std::string& summary, const Conclusion& end) override {
    os << '{';
    for (const std::unique_ptr<Array>& a : arrays_) {
      os << '"' << a->name << "\":[";
      a->rows.copy_to(os);
      os << "],\n ";
    }
    os << summary << ",\n " << end.json() << "}\n";
  }
};

Finding_level level(Claim claim, const Report_mode& mode) {
  switch (claim) {
  case Claim::met: return Finding_level::note;
  case Claim::not_met: break;
  case Claim::undecided: return mode.allow_undecided ? Finding_level::warning : Finding_level::error;
  case Claim::not_covered: return mode.allow_uncovered ? Finding_level::warning : Finding_level::error;
  }
  return Finding_level::error;
}

} // namespace

std::unique_ptr<Report::Writer> report_writer(const Report_mode& mode) {
  if (mode.baseline != nullptr && (mode.format == Report_format::text || mode.format == Report_format::json))
    return finding_writer(mode.format);
  switch (mode.format) {
  case Report_format::text: break;
  case Report_format::json: return std::make_unique<Json_writer>(mode.summary);
  case Report_format::sarif: return sarif_writer(mode.baseline != nullptr);
  case Report_format::junit: return junit_writer();
  }
  return std::make_unique<Text_writer>(mode.summary);
}

Report::Report(const Report_mode& mode, Report_subject subject)
    : mode_(mode), subject_(std::move(subject)), writer_(report_writer(mode)) {
  if (mode.baseline != nullptr) known_ = std::make_unique<Known_findings>(*mode.baseline);
}
Report::~Report() = default;

void Report::add(const Report_part& part, const std::string& array) {
  claims_ += part.claims_;
  if (!part.rows.empty() || !part.failing_rows.empty()) writer_->row(array, part.rows, part.failing_rows);
  for (const auto& [found, given] : part.findings_) {
    Finding finding = found;
    finding.level = level(finding.claim, mode_);
    finding.fingerprints = fingerprints_(finding);
    if (!known_)
      writer_->find(finding);
    else if (known_->take_unmoved(finding))
      know(finding, given);
    else
      unsettled_.emplace_back(std::move(finding), given);
  }
  for (const auto& [file, n] : part.passed_) writer_->pass(file, n);
}

void Report::know(const Finding& finding, const Given& given) {
  claims_.know(given);
  writer_->pass(finding.file, 1);
}

// All findings are there: what has moved is known, then what has changed, and all else is new.
void Report::settle() {
  if (!known_) return;
  enum class State { open, known, worse };
  std::vector<State> states(unsettled_.size(), State::open);
  for (std::size_t i = 0; i < states.size(); ++i)
    if (known_->is_worse_there(unsettled_[i].first)) states[i] = State::worse;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] == State::open && known_->take_moved(unsettled_[i].first)) states[i] = State::known;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] == State::open && known_->take_changed(unsettled_[i].first)) states[i] = State::known;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [finding, given] = unsettled_[i];
    if (states[i] == State::known)
      know(finding, given);
    else
      writer_->find(finding);
  }
  unsettled_.clear();
}

int Report::print(std::ostream& os, const std::string& summary) {
  settle();
  const Conclusion end(claims_, mode_, subject_);
  writer_->print(os, summary, end);
  return end.exit_code();
}
