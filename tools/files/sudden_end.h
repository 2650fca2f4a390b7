// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_SUDDEN_END_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_SUDDEN_END_H

#include "commands/commands.h"

#include "files/atomic_file.h"
#include <CGAL/Exact_rational.h>

#include <boost/config.hpp>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef CGAL_USE_GMP
#include "files/number_memory.h"
#include <gmp.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

// Signals, and memory that runs out, end the program in good order: temporary files are removed,
// and files that were to be replaced stay as they are.

// Ends the program as the signal does when nothing is done about it, so that the shell sees what
// happened.
extern "C" inline void end_by_signal(int signal) {
  CGAL::Geometric_continuity::remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Lets signals clean up, unless they are ignored. A file that grows beyond the limit of the system
// is an error of writing like others, not the end of the program.
inline void clean_up_at_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU})
    if (std::signal(signal, end_by_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

// Ends the program where no exception could get through: out of GMP, or of a function that is
// noexcept.
[[noreturn]] inline void end_without_memory() {
  CGAL::Geometric_continuity::remove_unfinished_files();
  constexpr char message[] = "geometric_continuity: out of memory\n";
  if (::write(STDERR_FILENO, message, sizeof message - 1) < 0) {
  } // there is nobody else to tell
  ::_exit(bad_input);
}

inline void* memory_or_end(void* memory) {
  if (memory == nullptr) end_without_memory();
  return memory;
}

// Takes the stack that the commands need, of which the arithmetic of GMP has most. Where memory is
// limited, the system would end the program by a signal when the stack cannot grow later.
template <std::size_t size> BOOST_NOINLINE void take_stack_of() { // and gives it back
  [[maybe_unused]] volatile char stack[size];
  for (std::size_t i = 0; i < size; i += 4096) stack[size - 1 - i] = 0;
}
inline void take_stack() {
  rlimit limit{};
  if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < 1024 * 1024)
    take_stack_of<192 * 1024>();
  else
    take_stack_of<512 * 1024>();
}

// Lets all memory that cannot be had end the program with the exit code of bad input.
inline void end_when_memory_runs_out() {
  std::set_new_handler(end_without_memory);
#ifdef CGAL_USE_GMP
  Number_memory::keep_on_this_thread();
  mp_set_memory_functions(
      [](std::size_t size) { return memory_or_end(Number_memory::take(size)); },
      [](void* memory, std::size_t, std::size_t size) { return memory_or_end(Number_memory::resize(memory, size)); },
      Number_memory::give_back);
#endif
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_SUDDEN_END_H
