// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/limits.h>
#include <CGAL/Geometric_continuity/IO/quoted_token.h>

#include <exception>
#include <istream>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The words of a text file in UTF-8, with the lines in which they begin, one at a time. It reads the buffer of the stream,
// so that neither the locale nor the flags of the stream matter.
class Token_reader {
  std::streambuf* buffer_;
  std::string name_, token_;
  long long line_ = 1, token_line_ = 1;
  bool begun_ = false;

  int next_character() {
    try {
      const std::streambuf::int_type c = buffer_->sbumpc();
      return c == std::streambuf::traits_type::eof() ? -1 : static_cast<unsigned char>(c);
    } catch (const Error&) {
      throw;
    } catch (const std::system_error& error) {
      throw Error(Error_code::cannot_read_file, name_ + ": " + error.code().message());
    } catch (const std::exception& error) {
      throw Error(Error_code::cannot_read_file, name_ + ": " + error.what());
    }
  }

  // Reads a byte order mark, if there is one. Returns the first character after it.
  int first_character() {
    int c = next_character();
    if (c == 0xFE || c == 0xFF) refuse_utf16();
    if (c != 0xEF) return c;
    for (const int expected : {0xBB, 0xBF})
      if (next_character() != expected) refuse("the text begins with half a byte order mark");
    return next_character();
  }

  [[noreturn]] void refuse_utf16() const { refuse("the text is UTF-16 where UTF-8 is expected"); }

public:
  Token_reader(std::istream& is, std::string name) : buffer_(is.rdbuf()), name_(std::move(name)) {
    if (!is) throw Error(Error_code::cannot_read_file, name_ + ": the stream cannot be read");
  }

  // Moves to the next word. Returns false at the end of the text.
  bool advance() {
    const auto is_space = [](int c) { return c == ' ' || ('\t' <= c && c <= '\r'); };
    token_.clear();
    const bool first = !begun_;
    int c = first ? first_character() : next_character();
    begun_ = true;
    for (; is_space(c); c = next_character()) line_ += c == '\n';
    if (c == -1) return false;
    token_line_ = line_;
    for (; c != -1 && !is_space(c); c = next_character()) {
      token_ += static_cast<char>(c);
      if (token_.size() > max_number_length)
        refuse("more than " + std::to_string(max_number_length) +
               " characters without a space: " + quoted_token(token_));
    }
    line_ += c == '\n';
    if (first && token_.size() > 1 && (token_[0] == '\0') != (token_[1] == '\0')) refuse_utf16();
    return true;
  }

  // The current word.
  const std::string& token() const { return token_; }

  // Refuses the text because of the current word.
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ":" + std::to_string(token_line_) + ": " + reason);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H
