// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace GC = CGAL::Geometric_continuity;

// Returns whether the name of a file stands for standard input.
inline bool is_standard_input(const std::string& name) { return name == "-" || name == "/dev/stdin"; }

// The name of a file in messages.
inline std::string input_name(const std::string& name) { return is_standard_input(name) ? "standard input" : name; }

// Reads a file, and says why it cannot be read. The beginning can be looked at before anything is
// read, also of a pipe.
class Input_buffer : public std::streambuf {
  const std::string name_;
  const int descriptor_;
  std::vector<char> block_ = std::vector<char>(std::size_t(1) << 16);
  off_type before_ = 0; // bytes before the block
  std::function<void()> after_block_;

  [[noreturn]] void refuse() const {
    throw GC::Error(GC::Error_code::cannot_read_file,
                    input_name(name_) + ": " + std::generic_category().message(errno));
  }

  // Reads behind what is in the block, and returns how much.
  std::size_t read_more() {
    char* const end = egptr() == nullptr ? block_.data() : egptr();
    ssize_t n;
    do n = ::read(descriptor_, end, static_cast<std::size_t>(block_.data() + block_.size() - end));
    while (n < 0 && errno == EINTR);
    if (n < 0) refuse();
    setg(block_.data(), gptr() == nullptr ? block_.data() : gptr(), end + n);
    return static_cast<std::size_t>(n);
  }

public:
  explicit Input_buffer(const std::string& name)
      : name_(name),
        descriptor_(is_standard_input(name) ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {
    if (descriptor_ < 0) refuse();
    try {
      read_more(); // a folder can be opened, but not read
    } catch (...) {
      close();
      throw;
    }
  }
  Input_buffer(const Input_buffer&) = delete;
  Input_buffer& operator=(const Input_buffer&) = delete;
  ~Input_buffer() override { close(); }

  // Calls action() whenever a block has been read, instead of what was called before.
  void after_each_block(std::function<void()> action) { after_block_ = std::move(action); }

  // The first bytes, as many as there are up to this number, as long as none has been read.
  std::string_view beginning(std::size_t size) {
    while (static_cast<std::size_t>(egptr() - eback()) < size && read_more() != 0) {
    }
    return std::string_view(eback(), (std::min)(size, static_cast<std::size_t>(egptr() - eback())));
  }

protected:
  int_type underflow() override {
    if (gptr() == egptr()) {
      before_ += egptr() - eback();
      setg(nullptr, nullptr, nullptr);
      if (read_more() == 0) return traits_type::eof();
      if (after_block_) after_block_();
    }
    return traits_type::to_int_type(*gptr());
  }

  // Tells the position; it cannot be changed.
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
    return offset == 0 && from == std::ios_base::cur ? pos_type(before_ + (gptr() - eback())) : pos_type(off_type(-1));
  }

private:
  void close() const {
    if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  }
};

// A file that a command reads; standard input for the name "-", which all inputs of this name
// share. Throws GC::Error `cannot_read_file` with the reason of the system, now or later.
class Input : public std::istream {
  std::shared_ptr<Input_buffer> buffer_;

  static std::shared_ptr<Input_buffer> open(const std::string& name) {
    static std::shared_ptr<Input_buffer> standard_input;
    if (!is_standard_input(name)) return std::make_shared<Input_buffer>(name);
    if (!standard_input) standard_input = std::make_shared<Input_buffer>(name);
    return standard_input;
  }

public:
  explicit Input(const std::string& name) : std::istream(nullptr), buffer_(open(name)) {
    rdbuf(buffer_.get());
    exceptions(std::ios_base::badbit); // lets the reason of a failure pass
  }

  // Calls action() from now on whenever a block has been read, until this input is destroyed.
  void after_each_block(std::function<void()> action) { buffer_->after_each_block(std::move(action)); }
  ~Input() override { after_each_block({}); }

  // The first bytes, as many as there are up to this number, as long as none has been read.
  std::string_view beginning(std::size_t size) { return buffer_->beginning(size); }
};

// Returns the beginning of a file, without a byte order mark and the zeros of UTF-16. The only pipe
// that is examined is standard input, because others cannot be opened twice.
inline std::string beginning_of_text(const std::string& file) {
  std::error_code error;
  if (!is_standard_input(file) && !std::filesystem::is_regular_file(file, error)) return "";
  std::string text(Input(file).beginning(256));
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\0' || (c & 0x80) != 0; }), text.end());
  return text;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H
