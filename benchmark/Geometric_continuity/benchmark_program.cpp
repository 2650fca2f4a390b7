// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Measures the cost of the built program on large files, against a reading limit: a process that
// maps the same file and calls std::from_chars on every number. Both run on one core, in turns,
// several times; the least times count. Ratios compare times of the processor, which depend less on
// the load of the machine. Only on two cores wall-clock times are compared.
//   benchmark_program PROGRAM [SCALE] [--long] [--json FILE]
// SCALE makes the files smaller for a quick look; the goals are those of 1. --long adds ten million
// curves through a pipe.

#include "Program_benchmark.h"
#include "generated_files.h"
#include "measured_process.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

typedef std::vector<std::string> Words;

struct Options {
  std::string program, json;
  double scale = 1;
  bool long_runs = false;

  explicit Options(const Words& words) {
    bool scaled = false;
    for (std::size_t k = 0; k < words.size(); ++k)
      if (words[k] == "--long")
        long_runs = true;
      else if (words[k] == "--json" && k + 1 < words.size())
        json = words[++k];
      else if (program.empty() && words[k][0] != '-')
        program = words[k];
      else if (!scaled)
        scaled = true, scale = parsed_scale(words[k]);
      else
        throw std::invalid_argument("unexpected argument " + words[k]);
    if (program.empty()) throw std::invalid_argument("usage: benchmark_program PROGRAM [SCALE] [--long] [--json FILE]");
  }
  static double parsed_scale(const std::string& word) {
    double x = 0;
    const char* const end = word.data() + word.size();
    const std::from_chars_result read = std::from_chars(word.data(), end, x);
    if (read.ec != std::errc() || read.ptr != end || !(x > 0 && x <= 100))
      throw std::invalid_argument("the scale " + word + " is no number greater than 0 and at most 100");
    return x;
  }
  // At least two of what there are usually so many of.
  int scaled(double usual) const { return (std::max)(2, static_cast<int>(std::lround(scale * usual))); }
};

void measure(const Options& options) {
  if (options.scale != 1) std::cout << "sizes times " << options.scale << ": the goals are those of 1\n";
  Program_benchmark benchmark(options.program);
  const int cubics = options.scaled(1000000), rows = options.scaled(100), paths = options.scaled(1000);
  const std::string joins = std::to_string(cubics - 1);

  std::vector<Command> commands = {{{"verify", "--require", "G2", "--summary"}, 3},
                                   {{"verify", "--require", "G2"}, 6},
                                   {{"verify", "--require", "G2", "--json"}, 12}};
  if (available_cores() > 1) commands.push_back({{"verify", "--require", "G2", "--summary"}, 1.6, 2});
  benchmark.measure(
      "cubics.g2",
      [&](std::ostream& os) {
        write_cubics(os, cubics);
        return std::int64_t(28) * cubics;
      },
      commands, joins + " joins: " + joins + " G2");
  const int bent = options.scaled(300000);
  benchmark.measure(
      "bent.g2",
      [&](std::ostream& os) {
        write_bent_cubics(os, bent);
        return std::int64_t(28) * bent;
      },
      {{{"verify", "--summary"}, 3}, {{"verify"}, 6}, {{"verify", "--summary", "--require", "G2"}, 4, 1, 1}},
      std::to_string(bent - 1) + " joins: " + std::to_string(bent - 1) + " G1");
  benchmark.measure(
      "patches.g2",
      [&](std::ostream& os) {
        write_patches(os, rows, 100);
        return std::int64_t(74) * rows * 100;
      },
      {{{"verify", "--surfaces", "--summary"}, 20}}, std::to_string(100 * rows) + " patches: ");
  benchmark.measure(
      "drawing.svg", [&](std::ostream& os) { return write_drawing(os, paths); }, {{{"verify"}, 40}},
      std::to_string(99 * paths) + " joins in " + std::to_string(paths) + " subpaths: ");
  if (options.long_runs) benchmark.measure_memory(options.scaled(10000000));

  if (options.json.empty()) return;
  std::ofstream json(options.json);
  benchmark.write_json(json);
  json.close();
  if (!json) throw std::runtime_error(options.json + ": cannot be written");
}

int main(int argc, char** argv) {
  try {
    const Interruption interruption;
    measure(Options(Words(argv + 1, argv + argc)));
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "benchmark_program: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
