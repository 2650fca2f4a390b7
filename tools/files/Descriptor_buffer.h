// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_DESCRIPTOR_BUFFER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_DESCRIPTOR_BUFFER_H

#include <cerrno>
#include <cstddef>
#include <functional>
#include <streambuf>
#include <utility>
#include <vector>

#include <unistd.h>

namespace CGAL {
namespace Geometric_continuity {

/// The buffer of an output stream that writes to a file descriptor of the system, and that
/// remembers why writing failed: a `std::ofstream` does not tell. After the first failure nothing
/// more is written. The descriptor is not closed, and what has not been flushed is not written.
class Descriptor_buffer : public std::streambuf {
  std::function<int()> open_;
  int descriptor_ = -1, error_ = 0;
  std::vector<char> block_ = std::vector<char>(std::size_t(1) << 16);

public:
  /// Writes to a descriptor that is open.
  explicit Descriptor_buffer(int descriptor) : Descriptor_buffer([descriptor] { return descriptor; }) {}

  /// Writes to the descriptor that `open` returns. It is called when there is something to write
  /// for the first time; its exceptions are passed on as the stream says.
  explicit Descriptor_buffer(std::function<int()> open) : open_(std::move(open)) { empty(); }

  /// Returns the `errno` of the first failure, 0 when there was none.
  int error() const { return error_; }

protected:
  int_type overflow(int_type c) override {
    if (!write_block()) return traits_type::eof();
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    return sputc(traits_type::to_char_type(c));
  }

  int sync() override { return write_block() ? 0 : -1; }

private:
  void empty() { setp(block_.data(), block_.data() + block_.size()); }

  // Returns whether all is written.
  bool write_block() {
    const char* next = pbase();
    const char* const end = pptr();
    empty();
    if (error_ == 0 && next != end && descriptor_ < 0) descriptor_ = open_();
    while (error_ == 0 && next != end) {
      const ssize_t written = ::write(descriptor_, next, static_cast<std::size_t>(end - next));
      if (written >= 0)
        next += written;
      else if (errno != EINTR)
        error_ = errno;
    }
    return error_ == 0;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_DESCRIPTOR_BUFFER_H
