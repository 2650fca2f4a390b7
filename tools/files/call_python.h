// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_CALL_PYTHON_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_CALL_PYTHON_H

#include "files/Child_process.h"

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

// How a script ends that misses a module in its Python.
constexpr int module_is_missing = 3;

// Runs a script, given as a text, with arguments: in the Python that GEOMETRIC_CONTINUITY_PYTHON
// names, otherwise in the first one of python3 and Debian's that has the modules which the script
// needs. Returns nothing where there is none.
inline std::optional<Process_end> call_python(const std::string& script, const std::vector<std::string>& arguments) {
  constexpr double seconds = 3600;
  constexpr std::uint64_t most_output = std::uint64_t(1) << 31;
  const char* const given = std::getenv("GEOMETRIC_CONTINUITY_PYTHON");
  std::vector<std::string> interpreters{"python3", "/usr/bin/python3"};
  if (given != nullptr && *given != '\0') interpreters = {given};
  for (const std::string& python : interpreters) {
    std::vector<std::string> command{"/usr/bin/env", python, "-c", script};
    command.insert(command.end(), arguments.begin(), arguments.end());
    Process_end end = Child_process(command, {seconds, most_output, {}}, true).wait();
    const int code = WIFEXITED(end.status) ? WEXITSTATUS(end.status) : 0;
    // the latter two are those of env, where it finds no such program
    if (code != module_is_missing && code != 126 && code != 127) return end;
  }
  return std::nullopt;
}

// Returns whether a process has ended by itself with this exit code.
inline bool has_ended_with(const Process_end& end, int code) {
  return !end.took_too_long() && !end.wrote_too_much && WIFEXITED(end.status) && WEXITSTATUS(end.status) == code;
}

// Returns the last line of the messages of a script, e.g. that of an exception.
inline std::string last_message(const Process_end& end) {
  std::string text = end.errors;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text.erase(0, text.find_last_of('\n') + 1);
  return text.empty() ? "it ended without a word" : text;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_CALL_PYTHON_H
