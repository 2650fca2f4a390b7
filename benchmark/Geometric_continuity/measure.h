// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_MEASURE_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_MEASURE_H

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>

// The benchmarks of curves and blends share these functions.

constexpr std::size_t n = 1024; // parameters, jets or blends of a batch

inline bool near(double x, double y) { return std::abs(x - y) <= 1e-9 * (1 + std::abs(x) + std::abs(y)); }

// `work(l)` for one item after the other.
template <class Work> void one_by_one(const char* name, Work work) {
  benchmark::RegisterBenchmark(name, [work](benchmark::State& state) mutable {
    for (auto _ : state)
      for (std::size_t l = 0; l < n; ++l) work(l);
    state.SetItemsProcessed(state.iterations() * n);
  });
}
// `work()` for `items` at a time.
template <class Work> void at_once(const char* name, std::size_t items, Work work) {
  benchmark::RegisterBenchmark(name, [work, items](benchmark::State& state) mutable {
    for (auto _ : state) {
      work();
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * items);
  });
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_MEASURE_H
