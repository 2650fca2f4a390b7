// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "memory_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace {

struct Contents {
  std::string name, bytes;
  std::size_t read;
};
std::optional<Contents> file;
constexpr int descriptor = 3;

} // namespace

Memory_file::Memory_file(std::string name, std::string bytes) : name_(std::move(name)) {
  file = Contents{name_, std::move(bytes), 0};
}

Memory_file::~Memory_file() { file.reset(); }

// In place of those of the C library, which would ask a system that is not there.
extern "C" {

int open(const char* name, int, ...) {
  if (!file || file->name != name) {
    errno = ENOENT;
    return -1;
  }
  file->read = 0;
  return descriptor;
}

ssize_t read(int from, void* to, std::size_t size) {
  if (from != descriptor || !file) return 0;
  const std::size_t n = (std::min)(size, file->bytes.size() - file->read);
  std::copy_n(file->bytes.data() + file->read, n, static_cast<char*>(to));
  file->read += n;
  return static_cast<ssize_t>(n);
}

int close(int) { return 0; }

int isatty(int) { return 0; }
}
