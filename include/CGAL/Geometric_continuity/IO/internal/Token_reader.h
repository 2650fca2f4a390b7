// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/Text_number.h>
#include <CGAL/Geometric_continuity/IO/internal/Text_blocks.h>
#include <CGAL/Geometric_continuity/IO/limits.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/quoted_token.h>

#include <cstddef>
#include <exception>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The words of a text file in UTF-8, one at a time, with the lines in which they begin. With Parallel_tag they are found on several
// cores.
template <class Concurrency_tag = Sequential_tag> class Token_reader {
  Text_blocks<Concurrency_tag> blocks_;
  std::string name_;
  Text_block block_;
  const Word *word_ = nullptr, *next_ = nullptr, *end_ = nullptr; // of the block
  long long line_ = 1;                                            // in which the block begins
  mutable const Word* counted_ = nullptr;                         // the last word of the block whose line was asked for
  mutable long long newlines_ = 0;                                // before it

public:
  Token_reader(std::istream& is, std::string name) : blocks_(is), name_(std::move(name)) {
    if (!is) throw Error(Error_code::cannot_read_file, name_ + ": the stream cannot be read");
  }
  Token_reader(const Token_reader&) = delete;
  Token_reader& operator=(const Token_reader&) = delete;

  // Moves to the next word. Returns false at the end of the text, and stays at the last word.
  bool advance() {
    if (next_ == end_ && !next_block()) return false;
    word_ = next_++;
    if (word_->size > max_number_length)
      refuse("more than " + std::to_string(max_number_length) +
             " characters without a space: " + quoted_token(token()));
    return true;
  }

  // The current word, and the place of its first character in the text, in bytes.
  std::string_view token() const { return block_.text(*word_); }
  std::size_t place() const { return block_.place(*word_); }

  // The number that the current word is. Throws Number_error.
  template <class FT> FT number() const {
    const Short_decimal& decimal = word_->decimal;
    if constexpr (std::is_same_v<FT, Text_number>)
      return decimal.exists() ? FT(decimal.digits, decimal.exponent) : FT(number_value<Exact_rational>(token()));
    else
      return number_value<FT>(token());
  }

  // The line of the current word. To find it for one word after the other each character is looked at once.
  long long line() const {
    if (word_ == nullptr) return line_;
    newlines_ = (counted_ == nullptr ? 0 : newlines_) + block_.newlines_before(*word_, counted_);
    counted_ = word_;
    return line_ + newlines_;
  }

  // Refuses the text because of the current word.
  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ":" + std::to_string(line()) + ": " + reason);
  }

private:
  bool next_block() {
    try {
      if (!blocks_.next(block_, line_)) return false;
    } catch (const Error&) {
      throw;
    } catch (const std::system_error& error) {
      throw Error(Error_code::cannot_read_file, name_ + ": " + error.code().message());
    } catch (const std::exception& error) {
      throw Error(Error_code::cannot_read_file, name_ + ": " + error.what());
    }
    const bool first = word_ == nullptr;
    counted_ = nullptr;
    word_ = next_ = block_.words().data();
    end_ = next_ + block_.words().size();
    if (first) check_encoding();
    return true;
  }

  // By the first word.
  void check_encoding() const {
    const std::string_view text = token();
    if (text[0] == '\xEF') refuse("the text begins with half a byte order mark");
    if (text[0] == '\xFE' || text[0] == '\xFF' || (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0')))
      refuse("the text is UTF-16 where UTF-8 is expected");
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H
