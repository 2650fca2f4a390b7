// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TOKEN_READER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <istream>
#include <memory>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

inline bool is_white_space(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }

// A word of a text: where it is in its block, and its value where it is a short decimal.
struct Word {
  Short_decimal decimal;
  std::uint32_t begin, size;
};

// A part of a text that begins and ends between words, with its words.
class Text_block {
  std::vector<char> text_;
  std::vector<Word> words_;
  long long newlines_ = 0;
  std::size_t place_ = 0; // of the first character in the whole text

public:
  // The characters, which are to be replaced before split(), and where they stand.
  std::vector<char>& characters() { return text_; }
  void set_place(std::size_t place) { place_ = place; }

  // Finds the words.
  void split() {
    const char *const begin = text_.data(), *const end = begin + text_.size(), *p = begin;
    long long newlines = 0;
    words_.clear();
    for (;;) {
      for (; p != end && is_white_space(*p); ++p) newlines += *p == '\n';
      if (p == end) break;
      const char* const first = p;
      words_.emplace_back();
      Word& word = words_.back();
      p = read_short_decimal(p, end, word.decimal);
      if (p != end && !is_white_space(*p)) {
        word.decimal = {};
        while (p != end && !is_white_space(*p)) ++p;
      }
      word.begin = static_cast<std::uint32_t>(first - begin);
      word.size = static_cast<std::uint32_t>(p - first);
    }
    newlines_ = newlines;
  }

  const std::vector<Word>& words() const { return words_; }
  std::string_view text(const Word& word) const { return {text_.data() + word.begin, word.size}; }
  std::size_t place(const Word& word) const { return place_ + word.begin; }

  // The number of lines that end in the block, and of those before a word, behind an earlier one if
  // it is given.
  long long newlines() const { return newlines_; }
  long long newlines_before(const Word& word, const Word* behind = nullptr) const {
    return std::count(text_.begin() + (behind == nullptr ? 0 : behind->begin), text_.begin() + word.begin, '\n');
  }
};

// Cuts the text of a stream into blocks between words. It reads the buffer of the stream, so that
// neither the locale nor the flags of the stream matter, and does not wait for more than the buffer
// has at hand.
class Text_source {
  static constexpr std::size_t block_size = std::size_t(1) << 18;

  std::streambuf* buffer_;
  std::vector<char> rest_; // the beginning of a word at the end of the last block
  std::size_t place_ = 0;  // of the next block
  bool begun_ = false, ended_ = false;
  std::exception_ptr error_; // why the text ended

public:
  explicit Text_source(std::istream& is) : buffer_(is.rdbuf()) {}

  // Reads the next block, the first one without a byte order mark; an empty one at the end. Returns
  // where it begins in the whole text, in bytes. Throws what the buffer of the stream throws, after
  // the blocks before.
  std::size_t next(std::vector<char>& text) {
    text.swap(rest_);
    rest_.clear();
    std::size_t end = 0; // of the last complete word
    while (!ended_ && end == 0 && text.size() <= max_number_length) {
      read_more(text);
      end = text.size();
      while (end > 0 && !is_white_space(text[end - 1])) --end;
    }
    if (!begun_) skip_byte_order_mark(text, end);
    if (error_) {
      text.resize(end); // not the half of a word
      // unreachable: needs a stream that delivers characters and throws in one call
      if (text.empty()) std::rethrow_exception(std::exchange(error_, nullptr));
    } else if (!ended_ && end > 0) {
      rest_.assign(text.begin() + static_cast<std::ptrdiff_t>(end), text.end());
      text.resize(end);
    }
    const std::size_t place = place_;
    place_ += text.size();
    return place;
  }

private:
  void skip_byte_order_mark(std::vector<char>& text, std::size_t& end) {
    begun_ = true;
    if (std::string_view(text.data(), text.size()).substr(0, 3) != "\xEF\xBB\xBF") return;
    text.erase(text.begin(), text.begin() + 3);
    end -= (std::min)(end, std::size_t(3));
    place_ = 3;
  }

  void read_more(std::vector<char>& text) {
    try {
      typedef std::streambuf::traits_type Characters;
      if (Characters::eq_int_type(buffer_->sgetc(), Characters::eof())) {
        ended_ = true;
        return;
      }
      const std::size_t before = text.size();
      const std::streamsize at_hand = (std::max)(std::streamsize(1), buffer_->in_avail());
      text.resize(before + (std::min)(static_cast<std::size_t>(at_hand), block_size));
      const std::streamsize n =
          buffer_->sgetn(text.data() + before, static_cast<std::streamsize>(text.size() - before));
      text.resize(before + static_cast<std::size_t>(n));
    } catch (...) {
      error_ = std::current_exception();
      ended_ = true;
    }
  }
};

// The blocks of a text with their words, one after the other; with Parallel_tag some are split
// ahead, on other cores.
template <class Concurrency_tag> class Text_blocks {
  typedef Task<Concurrency_tag> Splitting;
  const std::size_t blocks_ahead_ = Splitting::may_wait() ? 8 : 1;

  struct Ahead {
    Text_block block;
    std::exception_ptr error;
    Splitting splitting; // the last member: what it works on lives longer
  };

  Text_source source_;
  std::deque<std::unique_ptr<Ahead>> ahead_;
  std::unique_ptr<Ahead> spare_; // its memory is used again
  bool ended_ = false;

public:
  explicit Text_blocks(std::istream& is) : source_(is) {}

  // Reads the next block that has words, and adds the lines that are passed over, those of the old
  // block and of empty ones. Returns false at the end of the text, and leaves the old block.
  bool next(Text_block& block, long long& lines) {
    for (long long passed = block.newlines();;) {
      while (!ended_ && ahead_.size() < blocks_ahead_) read_ahead();
      if (ahead_.empty()) return false;
      std::unique_ptr<Ahead> first = std::move(ahead_.front());
      ahead_.pop_front();
      first->splitting.wait();
      if (first->error) std::rethrow_exception(first->error);
      if (first->block.words().empty()) {
        passed += first->block.newlines();
        continue;
      }
      lines += passed;
      std::swap(block, first->block);
      spare_ = std::move(first);
      return true;
    }
  }

private:
  void read_ahead() {
    std::unique_ptr<Ahead> next = spare_ ? std::move(spare_) : std::make_unique<Ahead>();
    Text_block& block = next->block;
    try {
      block.set_place(source_.next(block.characters()));
      ended_ = block.characters().empty();
    } catch (...) {
      next->error = std::current_exception();
      block.characters().clear();
      // equivalent [true -> false, 1]: what is read ahead behind an error is not used: the error
      //   is thrown first
      ended_ = true;
    }
    next->splitting.run([&block] { block.split(); });
    ahead_.push_back(std::move(next));
  }
};

// The words of a text file in UTF-8, one at a time, with the lines in which they begin. With
// Parallel_tag they are found on several cores.
template <class Concurrency_tag = Sequential_tag> class Token_reader {
  Text_blocks<Concurrency_tag> blocks_;
  std::string name_;
  Text_block block_;
  const Word *word_ = nullptr, *next_ = nullptr, *end_ = nullptr; // of the block
  long long line_ = 1;                                            // in which the block begins
  // the last word of the block whose line was asked for
  mutable const Word* counted_ = nullptr;
  mutable long long newlines_ = 0; // before it

public:
  Token_reader(std::istream& is, std::string name) : blocks_(is), name_(std::move(name)) {
    if (!is) throw Error(Error_code::cannot_read_file, name_ + ": the stream cannot be read");
  }
  Token_reader(const Token_reader&) = delete;
  Token_reader& operator=(const Token_reader&) = delete;

  // Moves to the next word. Returns false at the end of the text, and stays at the last word.
  CGAL_GC_FORCEINLINE bool advance() {
    if (next_ == end_ && !next_block()) return false;
    word_ = next_++;
    if (word_->size > max_number_length) refuse_length();
    return true;
  }

  // The current word, and the place of its first character in the text, in bytes.
  std::string_view token() const { return block_.text(*word_); }
  std::size_t place() const { return block_.place(*word_); }

  // The number that the current word is. Throws Number_error.
  template <class FT> CGAL_GC_FORCEINLINE FT number() const {
    if constexpr (std::is_same_v<FT, Decimal>) {
      const Short_decimal& decimal = word_->decimal;
      return decimal.exists() ? FT(decimal.digits, decimal.exponent) : FT(long_number());
    } else
      return number_value<FT>(token());
  }

  // The line of the current word. To find it for one word after the other each character is looked
  // at once.
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
  [[noreturn]] BOOST_NOINLINE void refuse_length() const {
    refuse("more than " + std::to_string(max_number_length) + " characters without a space: " + quoted_token(token()));
  }

  BOOST_NOINLINE Exact_rational long_number() const { return number_value<Exact_rational>(token()); }

  BOOST_NOINLINE bool next_block() {
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

  // The first word tells the encoding.
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
