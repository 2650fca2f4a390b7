// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_READING_LIMIT_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_READING_LIMIT_H

#include "measured_process.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>

// Does the least that any program does to read a file of numbers: maps it and calls std::from_chars
// on every number. There must be at least `numbers`, or the limit has missed some. The process ends
// soon, so that nothing is unmapped.
inline void read_numbers(const std::string& path, std::int64_t numbers) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0) system_failure(path);
  const std::size_t size = std::filesystem::file_size(path);
  void* const bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (bytes == MAP_FAILED) system_failure(path);
  const char *p = static_cast<const char*>(bytes), *const end = p + size;
  double sum = 0;
  while (p != end) {
    if ((*p >= '0' && *p <= '9') || *p == '-' || *p == '.') {
      double x;
      const std::from_chars_result read = std::from_chars(p, end, x);
      if (read.ec == std::errc()) {
        sum += x;
        --numbers;
        p = read.ptr;
        continue;
      }
    }
    ++p;
  }
  if (numbers > 0 || !std::isfinite(sum)) throw std::runtime_error(path + ": the limit misses numbers");
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_READING_LIMIT_H
