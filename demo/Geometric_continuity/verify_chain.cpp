// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "verify_chain.h"

#include "deferred_output.h"
#include "ordered_batches.h"
#include "progress.h"
#include "work_limit.h"

#include <CGAL/Geometric_continuity/IO/json.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

// What was decided about some joins of a chain, one after the other.
struct Decided_joins {
  GC::Chain_summary summary;
  std::size_t failing = 0, undecided = 0;
  std::string rows;          // of all joins, unless only the summary is wanted
  std::string failing_rows;  // of those that do not meet the requirement
  std::ostringstream stream; // for parts of a row
};

// Decides the joins of spans and writes the rows of a report.
template <class Span> class Join_decider {
  const Join_demand& demand_;
  const bool json_, only_failing_;

public:
  Join_decider(const Report_mode& mode, const Join_demand& demand)
      : demand_(demand), json_(mode.format == Report_format::json), only_failing_(mode.summary) {}

  void operator()(std::size_t left, std::size_t right, const Span& left_span, const Span& right_span,
                  Decided_joins& joins) const {
    std::optional<GC::Order_within> within;
    if (demand_.tolerance)
      within = GC::order_within(left_span.jets(), right_span.jets(), *demand_.tolerance, demand_.limit);
    Join join = only_failing_ ? continuity_orders(left_span, right_span, demand_.max_order, demand_.limit)
                              : continuity(left_span, right_span, demand_.max_order, demand_.limit);
    joins.summary.add(join);
    const bool fails = demand_.order && !demand_.order->met(join) &&
                       !(within && (*within)(demand_.order->order()) == GC::Verdict::proved);
    joins.failing += fails;
    if (!demand_.order && within && // else what is required has been proved
        std::count(within->verdicts.begin(), within->verdicts.end(), GC::Verdict::undecided) > 0)
      ++joins.undecided;
    if (only_failing_ && !fails) return;
    if (only_failing_) join = continuity(left_span, right_span, demand_.max_order, demand_.limit);
    std::string& rows = only_failing_ ? joins.failing_rows : joins.rows;
    const std::size_t begin = rows.size();
    if (json_)
      append_json_row(rows, join, left, right, within, joins.stream);
    else
      append_row(rows, join, left, right, left_span, right_span, within);
    if (fails && !only_failing_) joins.failing_rows.append(rows, begin, std::string::npos);
  }

private:
  static void append_json_row(std::string& rows, const Join& join, std::size_t left, std::size_t right,
                              const std::optional<GC::Order_within>& within, std::ostringstream& s) {
    s.str("");
    s << ",\n {";
    GC::write_json_members(s, join, static_cast<int>(left), static_cast<int>(right));
    if (within) {
      s << ',';
      GC::write_json_members(s, *within);
    }
    s << '}';
    rows += s.str();
  }

  static void append_row(std::string& rows, const Join& join, std::size_t left, std::size_t right,
                         const Span& left_span, const Span& right_span, const std::optional<GC::Order_within>& within) {
    append_table_row(rows, join, left, right, left_span, right_span);
    if (!within) return;
    std::ostringstream s;
    s << "             within the tolerance: order";
    for (int order = 0; order <= 3; ++order) s << (order > 0 ? ", " : " ") << order << ' ' << (*within)(order);
    s << "; " << within->deviation << '\n';
    rows += s.str();
  }
};

// Consecutive spans, with the last one before them, and what is decided about their joins.
template <class Span> struct Span_batch {
  static constexpr std::size_t most_spans = 1024;

  std::vector<Span> spans;
  std::size_t size = 0;                                   // of the spans that count; the others are memory
  std::size_t first = 0;                                  // the number of the first one in the chain
  std::vector<std::pair<std::size_t, std::string>> files; // which one begins at which of these spans
  double part_read = 0;                                   // of all files
  std::exception_ptr error;                               // of reading behind these spans, or of a decision
  Decided_joins joins;

  Span& add() {
    if (size == spans.size()) spans.emplace_back();
    return spans[size++];
  }
  const Span& last() const { return spans[size - 1]; }
  const std::string& file_of(std::size_t span) const {
    std::size_t i = files.size() - 1;
    while (i > 0 && span < files[i].first) --i;
    return files[i].second;
  }
};

// Collects the reports on the joins, and prints them when all are decided.
class Chain_report {
  static constexpr std::size_t most_rows_on_terminal = 5000;

  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  const bool may_be_short_ = !json_ && !mode_.summary && isatty(STDOUT_FILENO) != 0;
  const Join_demand& demand_;
  Deferred_output rows_, failing_rows_;
  bool has_row_ = false;
  GC::Chain_summary summary_;
  std::size_t failing_ = 0, undecided_ = 0;

public:
  Chain_report(const Report_mode& mode, const Join_demand& demand) : mode_(mode), demand_(demand) {}

  std::size_t joins() const { return summary_.joins(); }

  void add(const Decided_joins& joins) {
    summary_ += joins.summary;
    failing_ += joins.failing;
    undecided_ += joins.undecided;
    const std::string& rows = mode_.summary ? joins.failing_rows : joins.rows;
    rows_.write(json_ && !has_row_ && !rows.empty() ? rows.substr(1) : rows); // no comma before the first one
    has_row_ = has_row_ || !rows.empty();
    if (may_be_short_) failing_rows_.write(joins.failing_rows);
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    const std::map<int, std::size_t>& counts = summary_.counts(GC::Continuity_kind::G);
    const std::size_t joins = summary_.joins();
    const Conclusion conclusion{joins, failing_, undecided_};
    const bool is_short = may_be_short_ && joins > most_rows_on_terminal;
    const bool has_table = is_short || mode_.summary ? failing_ > 0 : true;
    os << (json_ ? "{\"joins\":[" : has_table ? table_head() : "");
    (is_short ? failing_rows_ : rows_).copy_to(os);
    if (json_) {
      os << "],\n \"summary\":{\"joins\":" << joins;
      for (const auto& [order, count] : counts)
        os << ",\"" << (order < 0 ? "gap" : 'G' + std::to_string(order)) << "\":" << count;
      if (joins > 0)
        os << ",\"c_order\":" << *summary_.least_order(GC::Continuity_kind::C)
           << ",\"g_order\":" << *summary_.least_order(GC::Continuity_kind::G)
           << ",\"f_order\":" << *summary_.least_order(GC::Continuity_kind::F);
      os << '}';
      if (demand_.order)
        os << ",\n \"required\":\"" << demand_.order->text() << "\",\"met\":" << conclusion.json_met(mode_);
      os << "}\n";
    } else {
      os << counted(joins, "join");
      for (const auto& [order, count] : counts)
        os << (order == counts.begin()->first ? ": " : ", ") << count << ' '
           << (order < 0 ? "gap" : 'G' + std::to_string(order) + (order == demand_.max_order ? " or more" : ""));
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
      if (undecided_ > 0)
        os << counted(undecided_, "join") << " with an order that is undecided within the tolerance\n";
      if (mode_.strict && undecided_ > 0) os << "not met, because not all was verified\n";
      if (is_short) os << "the others are listed when the output is not a terminal\n";
    }
    return conclusion.exit_code(mode_, "join");
  }
};

// Reads the spans of all files in batches, and decides their joins.
template <class Number>
int verify_spans(const Arguments& files, bool closed, const Report_mode& mode, const Join_demand& demand) {
  typedef Program_span<Number> Span;
  typedef Span_batch<Span> Batch;
  Chain_report report(mode, demand);
  const Join_decider<Span> decide(mode, demand);
  Progress progress("joins");
  Curve_stream<GC::G2_span_reader<Program_traits<Exact>, Number, CGAL::Parallel_if_available_tag>> stream(
      files, (std::max)(demand.max_order, 3), demand.limit);
  std::optional<Span> first, last; // of those that have been read
  std::size_t size = 0, file = 0;
  bool ended = false;

  const auto read = [&](Batch& batch) {
    if (ended) return false;
    batch.size = 0;
    batch.first = size - (last ? 1 : 0);
    batch.error = nullptr;
    batch.files.clear();
    if (last) batch.add() = *last;
    try {
      while (batch.size < Batch::most_spans) {
        Span& span = batch.add();
        if (!within_work_limit([&] { return stream.file(); }, [&] { return stream.next(span); })) {
          ended = true;
          --batch.size;
          break;
        }
        if (demand.order && size == 0) demand.order->check_dimension(span.dimension());
        if (size == 0) first = span;
        ++size;
        if (batch.files.empty() || stream.file_number() != file) {
          file = stream.file_number();
          batch.files.emplace_back(batch.size - 1, stream.file());
        }
      }
    } catch (...) {
      batch.error = std::current_exception();
      --batch.size;
      ended = true;
    }
    if (batch.size > 0) last = batch.last();
    batch.part_read = stream.part_read();
    return true;
  };
  const auto work = [&](Batch& batch) {
    batch.joins = {};
    try {
      for (std::size_t i = 1; i < batch.size; ++i) {
        const std::size_t left = batch.first + i - 1;
        within_work_limit(
            [&] { return batch.file_of(i) + ": join " + std::to_string(left) + " -> " + std::to_string(left + 1); },
            [&] { decide(left, left + 1, batch.spans[i - 1], batch.spans[i], batch.joins); });
      }
    } catch (...) {
      batch.error = std::current_exception(); // comes before one of reading
    }
  };
  const auto take = [&](Batch& batch) {
    if (batch.error) std::rethrow_exception(batch.error);
    report.add(batch.joins);
    progress.step(report.joins(), [&] { return batch.part_read; });
  };
  for_batches<Batch>(read, work, take);

  progress.clear();
  if (size == 1 && !closed && !mode.allow_empty)
    throw std::invalid_argument("a single curve has no join; --closed asks for the join of its end and its start");
  if (closed && size > 0) {
    Decided_joins joins;
    within_work_limit([] { return std::string("the join that closes the chain"); },
                      [&] { decide(size - 1, 0, *last, *first, joins); });
    report.add(joins);
  }
  return report.print(std::cout);
}

} // namespace

int verify_chain(const Arguments& files, bool rounded, bool closed, const Report_mode& mode,
                 const Join_demand& demand) {
  return rounded ? verify_spans<double>(files, closed, mode, demand)
                 : verify_spans<GC::Text_number>(files, closed, mode, demand);
}
