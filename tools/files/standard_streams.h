// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_STANDARD_STREAMS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_STANDARD_STREAMS_H

#include "commands/commands.h"

#include "files/Descriptor_buffer.h"

#include <iostream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

// Occupies the descriptors of standard streams that are closed, so that no file which is opened
// later takes the place of one: reading and writing fail there, as they do on a closed descriptor.
inline void occupy_standard_descriptors() {
  const int flags[] = {O_WRONLY, O_RDONLY, O_RDONLY}; // the wrong ones
  for (int descriptor = 0; descriptor <= STDERR_FILENO; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) == -1 && ::open("/dev/null", flags[descriptor]) != descriptor) ::_exit(bad_input);
}

// Lets std::cout write to standard output in blocks, and tells why writing failed.
class Standard_output {
  CGAL::Geometric_continuity::Descriptor_buffer buffer_{STDOUT_FILENO};
  std::streambuf* const old_ = std::cout.rdbuf(&buffer_);

public:
  Standard_output() = default;
  Standard_output(const Standard_output&) = delete;
  Standard_output& operator=(const Standard_output&) = delete;
  ~Standard_output() { std::cout.rdbuf(old_); }

  // Writes the rest. Returns the exit code of the program: that of the command, unless not
  // everything has been written.
  int finish(int exit_code) {
    std::cout.flush();
    if (buffer_.error() == 0) return exit_code;
    std::cerr << "geometric_continuity: cannot_write_file: standard output: "
              << std::generic_category().message(buffer_.error()) << '\n';
    return bad_input;
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_STANDARD_STREAMS_H
