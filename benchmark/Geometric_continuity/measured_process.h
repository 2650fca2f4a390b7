// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_MEASURED_PROCESS_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_MEASURED_PROCESS_H

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

// Work in processes of their own, and what each cost as the system counts it (Linux).

// Seconds that passed, seconds of the processors, and the largest resident memory.
struct Cost {
  double elapsed, processor, mebibytes;
};

// The cheaper of two runs, in each time alone, and the larger memory.
inline Cost best(const Cost& a, const Cost& b) {
  return {(std::min)(a.elapsed, b.elapsed), (std::min)(a.processor, b.processor), (std::max)(a.mebibytes, b.mebibytes)};
}

[[noreturn]] inline void system_failure(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// As long as it lives, Ctrl-C and a request to end let wait() end the process it waits for and
// throw, so that what the benchmark left is removed.
class Interruption {
  inline static volatile std::sig_atomic_t requested_ = 0;

public:
  Interruption() {
    struct sigaction action = {};
    action.sa_handler = [](int) { requested_ = 1; };
    for (int signal : {SIGINT, SIGTERM, SIGHUP})
      if (::sigaction(signal, &action, nullptr) != 0) system_failure("sigaction");
  }
  static bool requested() { return requested_ != 0; }
};

// A process that does work() and ends. What work() throws is printed, and the process then fails.
class Measured_process {
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  ::pid_t id_;

  static double seconds(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }

public:
  template <class Work> explicit Measured_process(Work work) {
    std::cout.flush(); // or both would print what waits
    id_ = ::fork();
    if (id_ < 0) system_failure("fork");
    if (id_ > 0) return;
    int code = EXIT_FAILURE;
    try {
      work();
      std::cout.flush();
      if (std::cout) code = EXIT_SUCCESS;
    } catch (const std::exception& e) {
      std::cerr << e.what() << '\n';
    }
    ::_exit(code);
  }

  // Waits until it ends. \throws std::runtime_error for `name` when it ends with another exit code.
  Cost wait(const std::string& name, int code = 0) const {
    int status;
    rusage usage;
    while (::wait4(id_, &status, 0, &usage) < 0) {
      if (errno != EINTR) system_failure("wait4");
      if (Interruption::requested()) ::kill(id_, SIGKILL);
    }
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (Interruption::requested()) throw std::runtime_error("interrupted");
    if (WIFSIGNALED(status)) throw std::runtime_error(name + ": ended by signal " + std::to_string(WTERMSIG(status)));
    if (WEXITSTATUS(status) != code)
      throw std::runtime_error(name + ": exit code " + std::to_string(WEXITSTATUS(status)));
    return {elapsed.count(), seconds(usage.ru_utime) + seconds(usage.ru_stime),
            static_cast<double>(usage.ru_maxrss) / 1024};
  }
};

// The number of cores that this process may use.
inline int available_cores() {
  cpu_set_t all;
  if (::sched_getaffinity(0, sizeof all, &all) != 0) system_failure("sched_getaffinity");
  return CPU_COUNT(&all);
}

// From now on, this process uses the first ones of the cores alone that it may use.
inline void use_cores(int number) {
  cpu_set_t all, some;
  if (::sched_getaffinity(0, sizeof all, &all) != 0) system_failure("sched_getaffinity");
  CPU_ZERO(&some);
  for (int core = 0; core < CPU_SETSIZE && number > 0; ++core)
    if (CPU_ISSET(core, &all)) {
      CPU_SET(core, &some);
      --number;
    }
  if (::sched_setaffinity(0, sizeof some, &some) != 0) system_failure("sched_setaffinity");
}

// From now on, the file descriptor (1: standard output, 2: messages) of this process writes to the
// file.
inline void write_to(const std::string& path, int descriptor) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::dup2(file, descriptor) < 0) system_failure(path);
  ::close(file);
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_MEASURED_PROCESS_H
