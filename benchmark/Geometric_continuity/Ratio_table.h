// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_RATIO_TABLE_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_RATIO_TABLE_H

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Benchmarks are named "work | method". Besides the usual table, prints for each work the ratio of
// each method to the first one, which is the limit that instructions written by hand reach.
class Ratio_table : public benchmark::ConsoleReporter {
  std::map<std::string, double> first_;
  std::vector<std::pair<std::string, double>> runs_;

  static std::string work(const std::string& name) { return name.substr(0, name.find(" | ")); }

public:
  void ReportRuns(const std::vector<Run>& reports) override {
    benchmark::ConsoleReporter::ReportRuns(reports);
    for (const Run& run : reports) {
      const std::string name = run.run_name.function_name;
      if (name.find(" | ") == std::string::npos || run.error_occurred || run.run_type == Run::RT_Aggregate) continue;
      // for each pass over several items
      const auto items = run.counters.find("items_per_second");
      const double time = items == run.counters.end() ? run.GetAdjustedCPUTime() : 1e9 / items->second.value;
      first_.emplace(work(name), time);
      runs_.emplace_back(name, time);
    }
  }
  void Finalize() override {
    std::string last;
    for (const auto& [name, time] : runs_) {
      if (work(name) != last) std::cout << '\n' << work(name) << '\n';
      last = work(name);
      std::cout << std::fixed << std::setprecision(1) << std::setw(12) << time << " ns" << std::setprecision(2)
                << std::setw(12) << time / first_[last] << " x  " << name.substr(last.size() + 3) << '\n';
    }
  }
};

// Results are compared before anything is timed.
inline void check(bool good, std::string_view what) {
  if (good) return;
  std::cerr << "wrong result: " << what << '\n';
  std::exit(1);
}

// Runs the registered benchmarks, after main() has compared the answers.
inline int run_benchmarks(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  Ratio_table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  return 0;
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_RATIO_TABLE_H
