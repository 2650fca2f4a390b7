// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Measures the cost of the built program on fonts, against a process that only reads them: a
// process in which FreeType loads the same glyphs, and the same code takes them apart into
// segments. Both run on one core, in turns, several times; the least times of the processor count.
//   benchmark_fonts PROGRAM FONT_OR_FOLDER...

#include "measured_process.h"

#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <stdlib.h>
#include <unistd.h>

typedef std::vector<std::string> Words;

constexpr int runs = 5;

// Reads all glyphs that can be read, and returns how many segments, hence joins, they have.
std::int64_t read_fonts(const Words& names) {
  std::int64_t segments = 0;
  std::vector<Unread_file> not_read;
  Glyph_outline outline;
  for (const Font_file& file : font_files(names, not_read)) {
    const std::string bytes = read_bytes(file.name);
    for (int i = 0, fonts = 1; i < fonts; ++i) try {
        const Font_face font(bytes, i);
        fonts = font.fonts_of_file();
        for (int glyph = 0; glyph < font.glyphs(); ++glyph) try {
            font.read(glyph, outline);
            segments += static_cast<std::int64_t>(outline.size());
          } catch (const Font_error&) {
          }
      } catch (const Font_error&) {
      }
  }
  return segments;
}

// The number before " joins" in the last line that has one.
std::int64_t joins_of_report(const std::string& file) {
  std::ifstream report(file);
  std::int64_t joins = -1;
  for (std::string line; std::getline(report, line);) {
    const std::size_t end = line.find(" joins");
    if (end == std::string::npos) continue;
    const std::size_t begin = line.find_last_of(' ', end - 1) + 1;
    joins = std::atoll(line.substr(begin, end - begin).c_str());
  }
  return joins;
}

// A file for what the program prints, removed at the end.
class Report_file {
  std::string name_ = (std::filesystem::temp_directory_path() / "benchmark_fonts_XXXXXX").string();

public:
  Report_file() {
    const int file = ::mkstemp(name_.data());
    if (file < 0) system_failure(name_);
    ::close(file);
  }
  Report_file(const Report_file&) = delete;
  Report_file& operator=(const Report_file&) = delete;
  ~Report_file() { ::unlink(name_.c_str()); }
  const std::string& name() const { return name_; }
};

class Font_benchmark {
  const std::string program_;
  const Words fonts_;
  const Report_file report_;

  Cost read() const {
    const Measured_process process([&] {
      use_cores(1);
      read_fonts(fonts_);
    });
    return process.wait("reading");
  }

  Cost verify(const Words& options, const std::string& output) const {
    Words words{program_, "verify"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), fonts_.begin(), fonts_.end());
    const Measured_process process([&] {
      use_cores(1);
      write_to(output, STDOUT_FILENO);
      std::vector<char*> arguments;
      for (std::string& word : words) arguments.push_back(word.data());
      arguments.push_back(nullptr);
      ::execv(program_.c_str(), arguments.data());
      system_failure(program_);
    });
    return process.wait(program_);
  }

  static void print(const std::string& name, const Cost& cost, const Cost& limit, std::int64_t joins, double goal) {
    const double ratio = cost.processor / limit.processor, rate = static_cast<double>(joins) / cost.processor;
    std::cout << std::fixed << std::setprecision(3) << std::setw(8) << cost.processor << " s" << std::setprecision(1)
              << std::setw(10) << cost.mebibytes << " MiB" << std::setw(10) << 1e-6 * rate << " million joins/s"
              << std::setprecision(2) << std::setw(8) << ratio << " x  " << name;
    if (goal > 0) std::cout << ", goal " << goal << " x: " << (ratio <= goal && rate >= 1e6 ? "met" : "NOT MET");
    std::cout << std::endl;
  }

public:
  Font_benchmark(const std::string& program, const Words& fonts) : program_(program), fonts_(fonts) {}

  void run() const {
    const std::int64_t joins = read_fonts(fonts_);
    verify({"--summary"}, report_.name());
    if (joins_of_report(report_.name()) != joins)
      throw std::runtime_error("wrong result: the program finds " + std::to_string(joins_of_report(report_.name())) +
                               " joins, and there are " + std::to_string(joins));
    std::cout << joins << " joins\n";
    const std::vector<Words> options{{"--summary"}, {}, {"--json"}};
    std::vector<Cost> costs; // of reading, then with the options
    for (int i = 0; i < runs; ++i) {
      std::vector<Cost> now{read()};
      for (const Words& o : options) now.push_back(verify(o, "/dev/null"));
      if (i == 0) costs = now;
      for (std::size_t k = 0; k < now.size(); ++k) costs[k] = best(costs[k], now[k]);
    }
    print("reading alone", costs[0], costs[0], joins, 0);
    print("verify --summary", costs[1], costs[0], joins, 3);
    print("verify", costs[2], costs[0], joins, 3);
    print("verify --json", costs[3], costs[0], joins, 0);
  }
};

int main(int argc, char** argv) {
  try {
    const Interruption interruption;
    const Words words(argv + 1, argv + argc);
    if (words.empty()) throw std::invalid_argument("usage: benchmark_fonts PROGRAM FONT_OR_FOLDER...");
    if (words.size() == 1)
      std::cout << "skipped: no font is given\n";
    else
      Font_benchmark(words[0], Words(words.begin() + 1, words.end())).run();
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "benchmark_fonts: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
