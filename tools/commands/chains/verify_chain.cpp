// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/verify_chain.h"

#include "commands/chains/Chain_report.h"
#include "commands/chains/Join_decider.h"
#include "commands/chains/ordered_batches.h"
#include "commands/work_limit.h"
#include "files/progress.h"
#include "formats/g2_text/spans.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace {

// Where a span ends.
struct Span_end {
  std::size_t file;    // its number, from 0 on
  long long line;      // 0 where it is not needed
  std::size_t in_file; // the number of the span in it, from 0 on
};

// Consecutive spans, with the last one before them, and what is decided about their joins.
template <class Span> struct Span_batch {
  static constexpr std::size_t most_spans = 256;

  std::vector<Span> spans;
  std::vector<Span_end> ends;
  std::size_t size = 0;     // of the spans that count; the others are memory
  std::size_t first = 0;    // the number of the first one in the chain
  double part_read = 0;     // of all files
  std::exception_ptr error; // of reading behind these spans, or of a decision
  Decided_joins joins;

  Span& add() {
    if (size == spans.size()) spans.emplace_back();
    return spans[size++];
  }
  const Span& last() const { return spans[size - 1]; }
};

// Reads the curves of all files again, in numbers of this type, and decides how far they are bent.
// `lines` are those where they end, or nothing.
template <class FT>
void decide_curvatures(const Arguments& files, const Curvature_bound& bound, const std::vector<long long>& lines,
                       Chain_report& report) {
  Progress progress("curves");
  Curve_stream<GC::G2_piece_reader<Program_traits<FT>>> stream(files);
  std::size_t number = 0;
  for (std::optional<Program_curve<FT>> curve; stream.next(curve); ++number) {
    const std::optional<GC::Curvature_excess> excess =
        within_work_limit([&] { return stream.file() + ": curve " + std::to_string(number); },
                          [&] { return curvature_excess(exact(*curve), bound); });
    report.add(number, stream.file(), lines.empty() ? 0 : lines[number], excess);
    progress.step(number, [&] { return stream.part_read(); });
  }
  progress.clear();
}

// Reads the spans of all files in batches, and decides their joins.
template <class Number>
int verify_spans(const Arguments& files, bool closed, const Report_mode& mode, const Join_demand& demand) {
  typedef Program_span<Number> Span;
  typedef Span_batch<Span> Batch;
  Chain_report report(mode, demand, files, closed);
  const Join_decider<Span> decide(mode, demand);
  Progress progress("joins");
  Curve_stream<GC::G2_span_reader<Program_traits<Exact>, Number, CGAL::Parallel_if_available_tag>> stream(
      files, (std::max)(demand.max_order, 3));
  std::vector<std::string> names;
  for (const std::string& file : files) names.push_back(input_name(file));
  std::optional<Span> first, last; // of those that have been read
  Span_end last_end{0, 0, 0};
  std::vector<long long> lines; // of curves, for findings
  std::size_t size = 0;
  bool ended = false;

  const auto read = [&](Batch& batch) {
    if (ended) return false;
    batch.size = 0;
    batch.first = size - (last ? 1 : 0);
    batch.error = nullptr;
    batch.ends.clear();
    if (last) {
      batch.add() = *last;
      batch.ends.push_back(last_end);
    }
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
        const std::size_t file = stream.file_number() - 1;
        last_end = {file, mode.has_findings() ? stream.line() : 0,
                    size > 1 && last_end.file == file ? last_end.in_file + 1 : 0};
        batch.ends.push_back(last_end);
        if (demand.curvature && mode.has_findings()) lines.push_back(last_end.line);
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
    batch.joins = report.part();
    try {
      for (std::size_t i = 1; i < batch.size; ++i) {
        const std::size_t left = batch.first + i - 1;
        within_work_limit(
            [&] {
              return names[batch.ends[i].file] + ": join " + std::to_string(left) + " -> " + std::to_string(left + 1);
            },
            [&] {
              const Span_end& end = batch.ends[i - 1];
              decide({left, left + 1, names[end.file], end.line, end.in_file}, batch.spans[i - 1], batch.spans[i],
                     batch.joins);
            });
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
  if (size == 1 && !closed && !mode.allow_empty && !demand.curvature) throw std::invalid_argument(no_join);
  if (closed && size > 0) {
    Decided_joins joins = report.part();
    within_work_limit(
        [] { return std::string("the join that closes the chain"); },
        [&] {
          decide({size - 1, 0, names[last_end.file], last_end.line, last_end.in_file}, *last, *first, joins);
        });
    report.add(joins);
  }
  report.end_joins();
  if (demand.curvature)
    decide_curvatures<std::conditional_t<std::is_same_v<Number, double>, double, Exact>>(files, *demand.curvature,
                                                                                         lines, report);
  return report.print(std::cout);
}

} // namespace

int verify_chain(const Arguments& files, bool rounded, bool closed, const Report_mode& mode,
                 const Join_demand& demand) {
  return rounded ? verify_spans<double>(files, closed, mode, demand)
                 : verify_spans<GC::Decimal>(files, closed, mode, demand);
}
