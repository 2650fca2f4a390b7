// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CRASH_GUARD_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CRASH_GUARD_H

#include "commands/commands.h"

#include <CGAL/Geometric_continuity/IO/printable.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <string>
#include <vector>

#include <unistd.h>

// As long as it lives, a crash ends the program with a message and the exit code of bad input: a damaged file can lead a library astray,
// also into a recursion that fills the stack.
class Crash_guard {
  static constexpr std::array<int, 5> signals = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
  static inline std::string message_;

  std::vector<char> stack_ = std::vector<char>(std::size_t(1) << 16);
  stack_t old_stack_;
  std::array<struct sigaction, signals.size()> old_;

  static void end(int) {
    if (::write(STDERR_FILENO, message_.data(), message_.size()) < 0) {
    } // there is nobody else to tell
    ::_exit(bad_input);
  }

public:
  explicit Crash_guard(const std::string& file) {
    message_ = "geometric_continuity: " + CGAL::Geometric_continuity::printable(file) +
               ": the library that reads it crashes: the file is damaged\n";
    stack_t stack{};
    stack.ss_sp = stack_.data();
    stack.ss_size = stack_.size();
    ::sigaltstack(&stack, &old_stack_);
    struct sigaction action {};
    action.sa_handler = end;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &action, &old_[i]);
  }
  Crash_guard(const Crash_guard&) = delete;
  Crash_guard& operator=(const Crash_guard&) = delete;
  ~Crash_guard() {
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &old_[i], nullptr);
    ::sigaltstack(&old_stack_, nullptr);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CRASH_GUARD_H
