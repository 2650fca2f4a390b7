// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_PROGRESS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_PROGRESS_H

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <istream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

// Shows, once a second, how much of a long work is done and how fast: "12345 joins, 5678/s, 12 s
// left". Only when standard error is a terminal; what is shown is erased at the end, and before
// anything else is printed when clear() is called.
class Progress {
  typedef std::chrono::steady_clock Clock;

  const std::string things_;
  const bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
  bool shown_ = false;

  // E.g. 12 s, 3 min 20 s, 2 h 5 min.
  static std::string duration(double seconds) {
    const double most = 359999; // 99 h 59 min
    const long s = static_cast<long>(seconds < most ? seconds : most);
    const auto pair = [](long large, const char* unit, long small, const char* small_unit) {
      return std::to_string(large) + unit + std::to_string(small) + small_unit;
    };
    return s < 60     ? std::to_string(s) + " s"
           : s < 3600 ? pair(s / 60, " min ", s % 60, " s")
                      : pair(s / 3600, " h ", s / 60 % 60, " min");
  }

  // E.g. 0.5/s, 12/s.
  static std::string rate(double x) {
    char text[32];
    std::snprintf(text, sizeof text, x < 10 ? "%.1f/s" : "%.0f/s", x);
    return text;
  }

public:
  // `things` are what is counted, in the plural.
  explicit Progress(std::string things) : things_(std::move(things)) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  // Tells that so many things are done. part() says which part of the work that is, from 0 to 1,
  // and 0 when it does not know; it is called only when something is shown.
  template <class Part> void step(std::size_t done, Part part) {
    if (!on_terminal_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    const double seconds = std::chrono::duration<double>(now - start_).count(), share = part();
    std::string text = std::to_string(done) + ' ' + things_ + ", " + rate(double(done) / seconds);
    if (share > 0) text += ", " + duration(seconds * (1 - share) / share) + " left";
    std::cerr << "\r\033[K" << text << std::flush;
    shown_ = true;
  }
  void step(std::size_t done) {
    step(done, [] { return 0.0; });
  }

  // Erases what is shown.
  void clear() {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
    shown_ = false;
  }
};

// How far the reading of several files, one after the other, has come.
class Reading_position {
  // where each file begins, in bytes after the first begin; empty if not known
  std::vector<std::uintmax_t> begins_{0};

public:
  explicit Reading_position(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
      std::error_code error; // of pipes, too
      const std::uintmax_t size = std::filesystem::file_size(file, error);
      if (error) {
        begins_.clear();
        return;
      }
      begins_.push_back(begins_.back() + size);
    }
  }

  // Returns which part of all files has been read, from 0 to 1, and 0 when that is not known: the
  // files before file number `file`, and that one as far as `stream` has read it.
  double part(std::size_t file, std::istream& stream) const {
    if (begins_.size() <= file || begins_.back() == 0) return 0;
    const std::streamoff read = stream.rdbuf()->pubseekoff(0, std::ios::cur, std::ios::in);
    return read < 0 ? 0 : (double(begins_[file]) + double(read)) / double(begins_.back());
  }

  // Reports that `share` of file number `file` has been done, from 0 to 1.
  double part(std::size_t file, double share) const {
    if (begins_.size() <= file + 1 || begins_.back() == 0) return 0;
    const double begin = double(begins_[file]), size = double(begins_[file + 1]) - begin;
    return (begin + share * size) / double(begins_.back());
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_PROGRESS_H
