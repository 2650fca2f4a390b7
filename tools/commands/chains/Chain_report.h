// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H

#include "commands/chains/Drawn_join.h"
#include "commands/chains/Worst_rows.h"
#include "commands/chains/join_report.h"
#include "commands/chains/verify_chain.h"
#include "reports/Report.h"
#include "reports/certificate.h"
#include "reports/words.h"

#include <atomic>
#include <cstddef>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// The decisions about some joins of a chain, one after the other.
struct Decided_joins {
  Report_part part = {};
  GC::Chain_summary summary = {};
  Drawn_counts drawn = {};
  Worst_rows worst = {};          // of a table
  std::ostringstream stream = {}; // for parts of a row
  std::vector<std::string> certificates = {};
  // gaps that close when a curve is reversed, with the numbers of both curves
  struct Gap {
    std::size_t left, right;
    Closing_reversal reversal;
  };
  std::vector<Gap> gaps = {};
};

// The report on a chain.
class Chain_report {
  const Join_demand& demand_;
  Report report_;
  GC::Chain_summary summary_;
  Drawn_counts drawn_;
  Worst_rows worst_;
  std::atomic<int> worst_end_ = worst_.end();
  Certificate certificate_;
  std::size_t curves_ = 0, bent_ = 0;
  std::vector<std::size_t> backward_;       // curves of which both gaps close when they are reversed
  std::optional<std::size_t> right_closes_; // the curve behind the last gap, if that closes it

  static Report_subject subject(const Join_demand& demand) {
    Report_subject s{"join", "every join"};
    s.table_head = ::table_head();
    if (demand.order) {
      s.required = demand.order->text() + (demand.tolerance ? " within the tolerance" : "");
      s.required_in_json = "\"required\":\"" + demand.order->text() + '"';
    }
    if (demand.curvature) demand_curvature(s, *demand.curvature);
    return s;
  }

public:
  Chain_report(const Report_mode& mode, const Join_demand& demand, const Arguments& files, bool closed)
      : demand_(demand), report_(mode, subject(demand)),
        certificate_(mode.certificate, "chain", files,
                     ",\"max_order\":" + std::to_string(demand.max_order) +
                         ",\"closed\":" + (closed ? "true" : "false")) {
    report_.row("joins");
    if (demand.curvature) report_.row("bent_curves");
    for (const std::string& file : files) report_.begin_file(input_name(file));
  }

  std::size_t joins() const { return summary_.joins(); }

  // Returns an empty part for joins that come later than those that were added. It may be called on
  // any core.
  Decided_joins part() const {
    Decided_joins joins{Report_part(report_.mode())};
    joins.worst = Worst_rows(worst_end_);
    return joins;
  }

  void add(const Decided_joins& joins) {
    summary_ += joins.summary;
    drawn_ += joins.drawn;
    worst_ += joins.worst;
    worst_end_ = worst_.end();
    report_.add(joins.part, "joins");
    for (const std::string& certificate : joins.certificates) certificate_.add(certificate);
    for (const Decided_joins::Gap& gap : joins.gaps) {
      const bool both = gap.reversal.left && right_closes_ == gap.left;
      if (both) backward_.push_back(gap.left);
      right_closes_ = gap.reversal.right && !both ? std::optional<std::size_t>(gap.right) : std::nullopt;
    }
  }

  // Ends the joins, of which a summary has only the worst rows.
  void end_joins() {
    if (report_.mode().format != Report_format::text) return;
    Report_part worst;
    worst.failing_rows = worst_.text();
    if (worst_.omitted() > 0)
      worst.failing_rows +=
          "and " + std::to_string(worst_.omitted()) + " more, which a file or a pipe gets without --summary\n";
    report_.add(worst);
  }

  // Adds a curve: where it exceeds the bound on the curvature, if it does.
  void add(std::size_t number, const std::string& file, long long line,
           const std::optional<GC::Curvature_excess>& excess) {
    ++curves_;
    const std::string place = "curve " + std::to_string(number);
    report_.add(file, {excess ? Claim::not_met : Claim::met, "curve"}, false, [&]() -> Finding {
      Finding f;
      f.file = file;
      f.line = line;
      f.kind = "curve";
      f.place = place;
      f.rule = Finding_rule::bend;
      f.message = "not " + demand_.curvature->words + ": " + to_string(*excess);
      f.properties = members(number, *excess);
      f.object = "curve";
      f.spot = std::to_string(number);
      if (!excess->unbounded) f.measure = Measure{"curvature", size_of(*excess)};
      return f;
    });
    if (!excess) return;
    ++bent_;
    report_.row("bent_curves", report_.mode().format == Report_format::json ? ",\n {" + members(number, *excess) + '}'
                                                                            : place + ": " + to_string(*excess) + '\n');
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    certificate_.finish();
    return report_.print(os, report_.mode().format == Report_format::text ? text_summary() : json_summary());
  }

private:
  static std::string members(std::size_t number, const GC::Curvature_excess& excess) {
    std::ostringstream os;
    write_json_members(os << "\"curve\":" << number << ',', excess);
    return os.str();
  }

  std::map<int, std::size_t> counts() const { return summary_.counts(GC::Continuity_kind::G); }

  std::string json_summary() const {
    std::ostringstream os;
    os << "\"summary\":{\"joins\":" << summary_.joins();
    for (const auto& [order, count] : counts())
      os << ",\"" << (order < 0 ? "gap" : 'G' + std::to_string(order)) << "\":" << count;
    if (summary_.joins() > 0)
      os << ",\"c_order\":" << *summary_.c_order() << ",\"g_order\":" << *summary_.g_order()
         << ",\"f_order\":" << *summary_.f_order();
    if (drawn_.all > 0) os << ",\"zero_tangent\":" << drawn_.all << ",\"drawn_g1\":" << drawn_.smooth;
    if (!backward_.empty()) {
      os << ",\"backward_curves\":[";
      for (std::size_t i = 0; i < backward_.size(); ++i) os << (i == 0 ? "" : ",") << backward_[i];
      os << ']';
    }
    if (demand_.curvature) os << ",\"curves\":" << curves_ << ",\"bent_curves\":" << bent_;
    os << '}';
    return os.str();
  }

  std::string text_summary() const {
    std::ostringstream os;
    os << counted(summary_.joins(), "join");
    const char* separator = ": ";
    for (const auto& [order, count] : counts()) {
      os << separator << count << ' '
         << (order < 0 ? "gap" : 'G' + std::to_string(order) + (order == demand_.max_order ? " or more" : ""));
      separator = ", ";
    }
    if (drawn_.all > 0) os << "; " << drawn_.all << " with a zero tangent, " << drawn_.smooth << " of them drawn as G1";
    if (demand_.curvature) os << "; " << counted(curves_, "curve");
    os << '\n';
    constexpr std::size_t most = 10; // curves that are named
    if (!backward_.empty()) {
      os << (backward_.size() == 1 ? "curve " : "curves ");
      for (std::size_t i = 0; i < backward_.size() && i < most; ++i) os << (i == 0 ? "" : ", ") << backward_[i];
      os << (backward_.size() > most ? ", ... run"
             : backward_.size() > 1  ? " run"
                                     : " runs")
         << " backwards: to reverse " << (backward_.size() == 1 ? "it" : "them")
         << " closes both gaps (repair --reverse)\n";
    }
    return os.str();
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_CHAINS_CHAIN_REPORT_H
