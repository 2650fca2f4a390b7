// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_CHILD_PROCESS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_CHILD_PROCESS_H

#include "files/processor_time.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// Both ends of a pipe, which no other program inherits.
class Pipe {
  std::array<int, 2> ends_;

public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
  int operator[](std::size_t i) const { return ends_[i]; }
  void close(std::size_t i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
};

// A process that waits for what does not come, or gets hardly a share of a processor, may last so
// many times as long as it may compute.
constexpr double most_waiting = 10;

// The limits of a process.
struct Process_limits {
  double seconds;                           // of processor time, see processor_seconds()
  std::uint64_t output;                     // bytes
  std::optional<std::uint64_t> memory = {}; // bytes of addresses, if they are limited from outside
};

// How a process has ended, and what it has written.
struct Process_end {
  std::string output, errors;
  // as waitpid() tells
  int status = 0;
  // then it was ended
  bool computed_too_long = false, waited_too_long = false, wrote_too_much = false;

  bool took_too_long() const { return computed_too_long || waited_too_long; }

  // Returns which limit of time was reached, e.g. "within 60 seconds of processor time, the limit
  // of --time-limit".
  std::string time_words(double seconds) const {
    std::ostringstream os;
    if (computed_too_long)
      os << "within " << seconds << " seconds of processor time, the limit of --time-limit";
    else
      os << "within " << most_waiting * seconds << " seconds, " << most_waiting
         << " times the limit of --time-limit, of which it computed for a part only";
    return os.str();
  }
};

// A process with another program. It ends at the latest with this object. Its standard input is a
// pipe from which nothing comes, and which ends with this program, however that ends.
class Child_process {
  Pipe life_, output_, errors_;
  pid_t process_ = -1;
  const Process_limits limits_;
  typedef std::chrono::steady_clock Clock;
  const Clock::time_point begin_ = Clock::now();
  Clock::time_point next_look_ = begin_;

  // Returns how it has ended; nothing if it goes on.
  std::optional<int> end(int options) {
    int status = 0;
    pid_t ended;
    while ((ended = ::waitpid(process_, &status, options)) < 0 && errno == EINTR) {
    }
    if (ended == 0) return std::nullopt;
    process_ = -1;
    return status;
  }

public:
  // The command is the path of a program and its arguments. Without `keeps_errors` nobody reads its
  // messages.
  Child_process(std::vector<std::string> command, const Process_limits& limits, bool keeps_errors) : limits_(limits) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, life_[0], STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output_[1], STDOUT_FILENO);
    if (keeps_errors)
      ::posix_spawn_file_actions_adddup2(&actions, errors_[1], STDERR_FILENO);
    else
      ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = ::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      process_ = -1;
      throw std::system_error(error, std::generic_category(), command[0]);
    }
    if (limits.memory) {
      const rlimit bound{static_cast<rlim_t>(*limits.memory), static_cast<rlim_t>(*limits.memory)};
      ::prlimit(process_, RLIMIT_AS, &bound, nullptr);
    }
    life_.close(0);
    output_.close(1);
    errors_.close(1);
  }
  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;
  ~Child_process() {
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    end(0);
  }

  // Waits until it ends, or until a limit is reached.
  Process_end wait() {
    Process_end result;
    std::vector<char> buffer(std::size_t(1) << 16);
    std::array<pollfd, 2> waiting{pollfd{output_[0], POLLIN, 0}, pollfd{errors_[0], POLLIN, 0}};
    const std::array<std::string*, 2> texts{&result.output, &result.errors};
    while (waiting[0].fd >= 0 || waiting[1].fd >= 0) {
      const double seconds = until_next_look(result);
      if (result.took_too_long()) return result;
      if (::poll(waiting.data(), waiting.size(), static_cast<int>(std::ceil(1000 * seconds))) <= 0) continue;
      for (std::size_t i = 0; i < 2; ++i) {
        if (waiting[i].fd < 0 || waiting[i].revents == 0) continue;
        const ssize_t n = ::read(waiting[i].fd, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) {
          waiting[i].fd = -1;
          continue;
        }
        texts[i]->append(buffer.data(), static_cast<std::size_t>(n));
        if (texts[i]->size() > limits_.output) {
          result.wrote_too_much = true;
          return result;
        }
      }
    }
    std::optional<int> status;
    while (!(status = end(WNOHANG))) {
      const double seconds = until_next_look(result);
      if (result.took_too_long()) return result;
      std::this_thread::sleep_for(std::chrono::duration<double>((std::min)(seconds, 1e-3)));
    }
    result.status = *status;
    return result;
  }

private:
  // Looks at the time that it has taken: tells in the result when that is too much, and returns in
  // how many seconds it is looked at again.
  double until_next_look(Process_end& result) {
    if (const Clock::time_point now = Clock::now(); next_look_ <= now) {
      const double computing = limits_.seconds - processor_seconds(process_),
                   waiting = most_waiting * limits_.seconds - std::chrono::duration<double>(now - begin_).count();
      result.computed_too_long = !(computing > 0);
      result.waited_too_long = !result.computed_too_long && !(waiting > 0);
      constexpr double least = 1e-3, most = 0.1;
      next_look_ = now + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>((std::max)(least, (std::min)({computing, waiting, most}))));
    }
    return (std::max)(0., std::chrono::duration<double>(next_look_ - Clock::now()).count());
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_CHILD_PROCESS_H
