// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_DEFERRED_OUTPUT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_DEFERRED_OUTPUT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <ostream>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

// Collects output until all input has been read and found good: in memory, or, what is longer than
// a few megabytes, in a temporary file of the folder TMPDIR, which has no name any more as soon as
// it exists.
class Deferred_output {
  static constexpr std::size_t max_in_memory = std::size_t(4) << 20, block_of_file = std::size_t(1) << 16;
  std::string text_; // behind what is in the file
  std::size_t size_in_file_ = 0;
  std::string path_ = folder() + "/geometric_continuity_XXXXXX";
  int file_ = -1;

  static std::string folder() {
    const char* const name = std::getenv("TMPDIR");
    return name == nullptr || *name == '\0' ? "/tmp" : name;
  }

  [[noreturn]] void refuse(CGAL::Geometric_continuity::Error_code code) const {
    const int error = errno;
    throw CGAL::Geometric_continuity::Error(code,
                                            "temporary file " + path_ + ": " + std::generic_category().message(error));
  }

  void create() {
    sigset_t all, old;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, &old); // until the name is gone
    file_ = ::mkostemp(path_.data(), O_CLOEXEC);
    const int error = errno;
    if (file_ >= 0) ::unlink(path_.c_str());
    sigprocmask(SIG_SETMASK, &old, nullptr);
    errno = error;
    if (file_ < 0) refuse(CGAL::Geometric_continuity::Error_code::cannot_write_file);
  }

  void move_to_file() {
    if (file_ < 0) create();
    for (std::size_t done = 0; done < text_.size();) {
      const ssize_t n = ::write(file_, text_.data() + done, text_.size() - done);
      if (n < 0) refuse(CGAL::Geometric_continuity::Error_code::cannot_write_file);
      done += static_cast<std::size_t>(n);
    }
    size_in_file_ += text_.size();
    text_.clear();
  }

public:
  Deferred_output() = default;
  Deferred_output(const Deferred_output&) = delete;
  Deferred_output& operator=(const Deferred_output&) = delete;
  ~Deferred_output() {
    if (file_ >= 0) ::close(file_);
  }

  void write(const std::string& text) {
    text_ += text;
    if (text_.size() > (file_ < 0 ? max_in_memory : block_of_file)) move_to_file();
  }

  // How much was written.
  std::size_t size() const { return size_in_file_ + text_.size(); }

  // Copies everything that was written.
  void copy_to(std::ostream& os) const { copy_to(os, 0, size()); }

  // Copies what was written from one size to another.
  void copy_to(std::ostream& os, std::size_t begin, std::size_t end) const {
    std::string block((std::min)(std::size_t(1) << 16, size_in_file_), '\0');
    while (begin < (std::min)(end, size_in_file_)) {
      const std::size_t wanted = (std::min)(block.size(), (std::min)(end, size_in_file_) - begin);
      const ssize_t n = ::pread(file_, block.data(), wanted, static_cast<off_t>(begin));
      if (n <= 0) refuse(CGAL::Geometric_continuity::Error_code::cannot_read_file);
      os.write(block.data(), n);
      begin += static_cast<std::size_t>(n);
    }
    if (begin < end) os.write(text_.data() + (begin - size_in_file_), static_cast<std::streamsize>(end - begin));
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_DEFERRED_OUTPUT_H
