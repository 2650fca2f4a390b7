// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H

#include "commands/chains/join_report.h"
#include "commands/chains/verify_chain.h"
#include "files/deferred_output.h"
#include "reports/finding.h"

#include <cstddef>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

// What was decided about some joins of a chain, one after the other.
struct Decided_joins {
  GC::Chain_summary summary;
  std::size_t failing = 0, undecided = 0;
  std::string rows;                                        // of all joins, unless only the summary is wanted
  std::string failing_rows;                                // of those that do not meet the requirement
  std::ostringstream stream;                               // for parts of a row
  std::vector<Finding> findings;                           // instead of rows
  std::vector<std::pair<std::string, std::size_t>> passed; // how many joins of which file have no finding
};

// Collects the reports on the joins, and prints them when all are decided.
class Chain_report {
  static constexpr std::size_t most_rows_on_terminal = 5000;

  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  const bool may_be_short_ = mode_.format == Report_format::text && !mode_.summary && isatty(STDOUT_FILENO) != 0;
  const Join_demand& demand_;
  Deferred_output rows_, failing_rows_;
  std::unique_ptr<Finding_writer> findings_;
  bool has_row_ = false;
  GC::Chain_summary summary_;
  std::size_t failing_ = 0, undecided_ = 0;

public:
  Chain_report(const Report_mode& mode, const Join_demand& demand, const Arguments& files)
      : mode_(mode), demand_(demand) {
    if (!mode.has_findings()) return;
    findings_ = finding_writer(mode.format);
    for (const std::string& file : files) findings_->add_passed(input_name(file), 0, "joins");
  }

  std::size_t joins() const { return summary_.joins(); }

  void add(const Decided_joins& joins) {
    summary_ += joins.summary;
    failing_ += joins.failing;
    undecided_ += joins.undecided;
    const std::string& rows = mode_.summary ? joins.failing_rows : joins.rows;
    rows_.write(json_ && !has_row_ && !rows.empty() ? rows.substr(1) : rows); // no comma before the first one
    has_row_ = has_row_ || !rows.empty();
    if (may_be_short_) failing_rows_.write(joins.failing_rows);
    for (const Finding& finding : joins.findings) findings_->add(finding);
    for (const auto& [file, number] : joins.passed) findings_->add_passed(file, number, "joins");
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    if (findings_)
      findings_->print(os, json_summary());
    else if (json_) {
      os << "{\"joins\":[";
      rows_.copy_to(os);
      os << "],\n " << json_summary() << "}\n";
    } else
      print_text(os);
    return conclusion().exit_code(mode_, "join");
  }

private:
  Conclusion conclusion() const { return {summary_.joins(), failing_, undecided_}; }
  std::map<int, std::size_t> counts() const { return summary_.counts(GC::Continuity_kind::G); }

  std::string json_summary() const {
    std::ostringstream os;
    os << "\"summary\":{\"joins\":" << summary_.joins();
    for (const auto& [order, count] : counts())
      os << ",\"" << (order < 0 ? "gap" : 'G' + std::to_string(order)) << "\":" << count;
    if (summary_.joins() > 0)
      os << ",\"c_order\":" << *summary_.least_order(GC::Continuity_kind::C)
         << ",\"g_order\":" << *summary_.least_order(GC::Continuity_kind::G)
         << ",\"f_order\":" << *summary_.least_order(GC::Continuity_kind::F);
    os << '}';
    if (demand_.order)
      os << ",\n \"required\":\"" << demand_.order->text() << "\",\"met\":" << conclusion().json_met(mode_);
    return os.str();
  }

  void print_text(std::ostream& os) {
    const std::size_t joins = summary_.joins();
    const bool is_short = may_be_short_ && joins > most_rows_on_terminal;
    const bool has_table = is_short || mode_.summary ? failing_ > 0 : true;
    if (has_table) os << table_head();
    (is_short ? failing_rows_ : rows_).copy_to(os);
    os << counted(joins, "join");
    const char* separator = ": ";
    for (const auto& [order, count] : counts()) {
      os << separator << count << ' '
         << (order < 0 ? "gap" : 'G' + std::to_string(order) + (order == demand_.max_order ? " or more" : ""));
      separator = ", ";
    }
    os << '\n';
    if (joins == 0)
      os << "no join, nothing was decided\n";
    else if (demand_.order) {
      const std::string order = demand_.order->text() + (demand_.tolerance ? " within the tolerance" : "");
      if (failing_ == 0)
        os << "every join is " << order << ", proved exactly\n";
      else
        os << failing_ << " of them not " << order << '\n';
    }
    if (undecided_ > 0) os << counted(undecided_, "join") << " with an order that is undecided within the tolerance\n";
    if (mode_.strict && undecided_ > 0) os << "not met, because not all was verified\n";
    if (is_short) os << "the others are listed when the output is not a terminal\n";
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H
