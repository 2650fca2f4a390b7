// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_PROCESSOR_TIME_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_PROCESSOR_TIME_H

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include <sys/types.h>
#include <unistd.h>

// The seconds that a clock of processor time shows.
inline double seconds_of(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The seconds of processor time that the ended children of a process have taken for which it has
// waited, from /proc.
inline double seconds_of_ended_children(const std::string& folder) {
  std::ifstream stream(folder + "/stat");
  std::string text;
  std::getline(stream, text);
  // behind a name of any letters
  std::istringstream fields(text.substr((std::min)(text.rfind(')') + 1, text.size())));
  std::string skipped;
  constexpr int fields_before = 13;
  for (int i = 0; i < fields_before; ++i) fields >> skipped;
  double user = 0, system = 0; // in ticks
  fields >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

// The seconds of processor time that a process has taken, with all its threads and with the
// processes that it has started.
inline double processor_seconds(pid_t process) {
  const std::string folder = "/proc/" + std::to_string(process);
  double seconds = seconds_of_ended_children(folder);
  if (clockid_t clock; ::clock_getcpuclockid(process, &clock) == 0) seconds += seconds_of(clock);
  std::error_code error;
  for (std::filesystem::directory_iterator i(folder + "/task", error), end; !error && i != end; i.increment(error)) {
    std::ifstream children(i->path() / "children");
    for (pid_t child; children >> child;) seconds += processor_seconds(child);
  }
  return seconds;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_PROCESSOR_TIME_H
