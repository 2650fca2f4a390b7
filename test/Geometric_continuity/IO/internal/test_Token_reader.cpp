// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The words of a text, their lines and numbers: the same however the stream cuts it, on one core
// and on several.

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/internal/Token_reader.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/tags.h>
#include <cerrno>
#include <istream>
#include <streambuf>
#include <system_error>

using namespace std::string_literals;

BOOST_AUTO_TEST_SUITE(token_reader)

constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();

// Delivers a text in parts of a size, and then ends, or throws. Of size 0: one character at a time
// without a buffer.
class Parts : public std::streambuf {
  std::string text_;
  const std::size_t size_;
  const std::function<void()> end_;
  std::size_t next_ = 0;

  std::size_t take() {
    setg(nullptr, nullptr, nullptr);
    if (next_ == text_.size() && end_) end_();
    const std::size_t n = (std::min)(size_, text_.size() - next_);
    setg(text_.data() + next_, text_.data() + next_, text_.data() + next_ + n);
    next_ += n;
    return n;
  }
  int_type current() const { return traits_type::to_int_type(text_[next_]); }
  bool ended() const {
    if (next_ < text_.size()) return false;
    if (end_) end_();
    return true;
  }

public:
  Parts(std::string text, std::size_t size, std::function<void()> end = {})
      : text_(std::move(text)), size_(size), end_(std::move(end)) {}

protected:
  int_type underflow() override {
    if (size_ == 0) return ended() ? traits_type::eof() : current();
    return take() == 0 ? traits_type::eof() : traits_type::to_int_type(*gptr());
  }
  int_type uflow() override {
    if (size_ > 0) return std::streambuf::uflow();
    if (ended()) return traits_type::eof();
    const int_type c = current();
    ++next_;
    return c;
  }
};

// The words of a text with the lines in which they begin, and the error that ended it.
struct Words {
  std::vector<std::pair<std::string, long long>> words;
  std::string error = "no error";

  friend bool operator==(const Words& a, const Words& b) { return a.words == b.words && a.error == b.error; }
  friend std::ostream& operator<<(std::ostream& os, const Words& w) {
    os << w.words.size() << " words, " << w.error;
    for (std::size_t i = 0; i < w.words.size() && i < 10; ++i)
      os << " | " << w.words[i].second << ": " << w.words[i].first.substr(0, 20);
    return os;
  }
};

// The words one character after the other.
Words expected_words(const std::string& text) {
  Words result;
  long long line = 1;
  bool inside = false;
  for (const char c : text) {
    const bool space = std::string_view(" \t\n\v\f\r").find(c) != std::string_view::npos;
    if (!space && !inside) result.words.emplace_back("", line);
    if (!space) result.words.back().first += c;
    inside = !space;
    line += c == '\n';
  }
  return result;
}

template <class Reader> long long line_of(const Reader& reader) {
  const std::string error = error_of([&] { reader.refuse("here"); }),
                    before = "malformed_input: f.g2:", after = ": here";
  BOOST_REQUIRE_EQUAL(error.substr(0, before.size()), before);
  BOOST_REQUIRE_EQUAL(error.substr(error.size() - after.size()), after);
  return std::stoll(error.substr(before.size()));
}

// With the lines of some words only, if there are many.
template <class Concurrency_tag>
Words read_words(const std::string& text, std::size_t size, const std::function<void()>& end = {},
                 std::size_t lines = 1) {
  Parts parts(text, size, end);
  std::istream is(&parts);
  Words result;
  result.error = error_of([&] {
    GC::internal::Token_reader<Concurrency_tag> reader(is, "f.g2");
    while (reader.advance()) {
      const bool has_line = result.words.size() % lines == 0;
      result.words.emplace_back(reader.token(), has_line ? line_of(reader) : 0);
    }
    BOOST_CHECK(!reader.advance());
    // stays there
    if (!result.words.empty()) BOOST_CHECK_EQUAL(std::string(reader.token()), result.words.back().first);
  });
  return result;
}

const std::vector<std::size_t> sizes = {0, 1, 2, 3, 7, 4096, whole};

void check_words(const std::string& text, const Words& expected, const std::function<void()>& end = {}) {
  const std::vector<std::size_t> few = {7, 4096, whole}; // for what would take long
  for (std::size_t size : text.size() < 1000 ? sizes : few) {
    BOOST_TEST_CONTEXT("parts of " << size << " of " << GC::quoted_token(text)) {
      BOOST_CHECK_EQUAL(read_words<CGAL::Sequential_tag>(text, size, end), expected);
      BOOST_CHECK_EQUAL(read_words<CGAL::Parallel_if_available_tag>(text, size, end), expected);
    }
  }
}
void check_words(const std::string& text) { check_words(text, expected_words(text)); }
void check_refused(const std::string& text, const std::string& error, Words expected = {}) {
  expected.error = "malformed_input: f.g2:" + error;
  check_words(text, expected);
}

BOOST_AUTO_TEST_CASE(words_and_lines) {
  for (const char* text : {"", " ", "\n", "\n\n \t\n", "a", "a\n", "\na", " a b ", "a\nb\n\nc", "a\r\nb\r\n", "a\vb\fc",
                           "abcdefg hijklmn", "abcdef\nghijkl\nm", "abc abc abc abc", "1 2 3 4 5 6 7 8 9\n10 11 12\n13",
                           "\n\n\n\n\n\n\n\n\n\n\na", "\xC2\xA0 \xC2\x85 \xFE", "a \xFE\xFF b", "a \xEF\xBB\xBF b"})
    check_words(text);
}

// Random words, many of them numbers, with blank parts that are longer than what is delivered at
// once.
BOOST_AUTO_TEST_CASE(random_texts) {
  std::mt19937 random = seeded(20261122);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int i = 0; i < 40; ++i) {
    std::string text;
    for (int n = below(150); n > 0; --n) {
      for (int k = below(9); k >= 0; --k) text += "0123456789.-e/x"[below(15)];
      for (int k = below(20) == 0 ? below(30) : below(2); k >= 0; --k) text += " \n\t\r"[below(4)];
    }
    check_words(text);
  }
  // so long that many blocks are read ahead
  std::string text;
  while (text.size() < 1000000) {
    text += std::to_string(below(1000000));
    text += below(5) == 0 ? '\n' : ' ';
    if (below(50000) == 0) text.append(300000, below(2) == 0 ? ' ' : '\n');
  }
  constexpr std::size_t lines = 997;
  Words expected = expected_words(text);
  for (std::size_t i = 0; i < expected.words.size(); ++i)
    if (i % lines != 0) expected.words[i].second = 0;
  for (std::size_t size : {std::size_t(4096), std::size_t(100003), whole}) {
    BOOST_CHECK(read_words<CGAL::Sequential_tag>(text, size, {}, lines) == expected);
    BOOST_CHECK(read_words<CGAL::Parallel_if_available_tag>(text, size, {}, lines) == expected);
  }
}

// Digits end at the first other character, whatever it is and whatever is behind it.
BOOST_AUTO_TEST_CASE(ends_of_digits) {
  const std::string seven = "7.", figures = "12345678987654321";
  for (std::size_t n = 0; n <= figures.size(); ++n)
    for (int c = 0; c < 256; ++c) {
      const char other = static_cast<char>(c);
      if (('0' <= other && other <= '9') || other == 'e' || other == 'E') continue;
      for (const char* rest : {"", "5", "12345678", "/:/:/:/:/:/:"}) {
        const std::string number = seven + figures.substr(0, n), text = number + other + rest;
        GC::internal::Short_decimal decimal;
        const char* const end = GC::internal::read_short_decimal(text.data(), text.data() + text.size(), decimal);
        BOOST_REQUIRE_EQUAL(end - text.data(), number.size());
        BOOST_REQUIRE_EQUAL(decimal.digits, std::stoll("7" + figures.substr(0, n)));
        BOOST_REQUIRE_EQUAL(decimal.exponent, -static_cast<int>(n));
      }
    }
}

// The numbers are those of the words, also where a block ends.
BOOST_AUTO_TEST_CASE(numbers) {
  const std::vector<std::string> words = {
      "1",     "-2.50",  "+.5",   "3.",     "1e3",  "-1.25E-2",           "1/3",
      "0.1e1", "000123", "1e400", "-0.0e5", "22/7", "123456789012345678", "1234567890123456789"};
  std::string text;
  for (const std::string& word : words) text += word + (word.size() % 2 == 0 ? " " : "\n");
  for (std::size_t size : sizes) {
    Parts parts(text, size);
    std::istream is(&parts);
    GC::internal::Token_reader<CGAL::Parallel_if_available_tag> reader(is, "f.g2");
    for (const std::string& word : words) {
      BOOST_REQUIRE(reader.advance());
      BOOST_CHECK_EQUAL(reader.number<GC::Decimal>().value(), GC::parse_number<Q>(word));
      BOOST_CHECK_EQUAL(reader.number<GC::Decimal>().is_decimal(), GC::Decimal(word).is_decimal());
      BOOST_CHECK_EQUAL(reader.number<Q>(), GC::parse_number<Q>(word));
      if (word != "1e400") BOOST_CHECK_EQUAL(reader.number<double>(), GC::parse_number<double>(word));
    }
    BOOST_CHECK(!reader.advance());
  }
  for (const char* word : {"x", "1x", "1e", "1e4097", "1/0", "-", "."}) {
    Parts parts(std::string("7 ") + word + " 8", 3);
    std::istream is(&parts);
    GC::internal::Token_reader<> reader(is, "f.g2");
    BOOST_REQUIRE(reader.advance() && reader.advance());
    BOOST_CHECK_THROW(reader.number<GC::Decimal>(), GC::internal::Number_error);
    BOOST_CHECK_THROW(reader.number<Q>(), GC::internal::Number_error);
  }
}

BOOST_AUTO_TEST_CASE(byte_order_marks) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const char* text : {"", "\n", "1", "1 2\n3", "\n1", "\n\n\n\n\n1", " "})
    check_words(mark + text, expected_words(text));
  const std::string half = "1: the text begins with half a byte order mark";
  for (const char* text : {"\xEF", "\xEF\n1", "\xEF\xBB", "\xEF\xBB 1", "\xEF\xBB\61", "\xEF\xBB\xBB\61", "\xEF\141bc"})
    check_refused(text, half);
  check_refused(mark + mark + "1", half);
  check_refused("\n\n" + mark + "1", "3" + half.substr(1));
  const auto utf_16 = [](const std::string& text, bool big, bool has_mark) {
    std::string result;
    for (const char c : (has_mark ? std::string("\xFF") : std::string()) + text) {
      const bool is_mark = c == '\xFF';
      const char other = is_mark ? '\xFE' : '\0';
      result += big ? other : c;
      result += big ? c : other;
    }
    return result;
  };
  for (bool big : {false, true})
    for (bool has_mark : {false, true})
      for (const char* text : {"1", "100 1 0 0\n", "12"})
        check_refused(utf_16(text, big, has_mark), "1: the text is UTF-16 where UTF-8 is expected");
}

BOOST_AUTO_TEST_CASE(nul_bytes) {
  for (const std::string& text :
       {"1 \0 2"s, "abc\0def\0 \0"s, "100\0 1"s, "a b\0\nc"s, "\0\0 1"s, "\0"s, "\0 a"s, "\n\0"s})
    check_words(text);
}

BOOST_AUTO_TEST_CASE(long_words) {
  const std::size_t longest = GC::max_number_length;
  const auto refused = [](int line, char c) {
    return std::to_string(line) + ": more than 4096 characters without a space: '" + std::string(40, c) + "...'";
  };
  const Words before = expected_words("a\nb");
  for (const char* end : {"", " ", "\nc"}) {
    check_words(std::string(longest, '7') + end);
    check_words("a\nb " + std::string(longest, '7') + end);
    check_words("a\nb " + std::string(longest - 1, 'x') + end);
    for (std::size_t size : {longest + 1, longest + 2, std::size_t(300000)}) {
      check_refused(std::string(size, '7') + end, refused(1, '7'));
      check_refused("a\nb\n" + std::string(size, 'x') + end, refused(3, 'x'), before);
      check_refused("a\nb\n\n" + std::string(size, 'x') + end, refused(4, 'x'), before);
    }
  }
  // where a block of the largest size ends
  for (int shift = -2; shift <= 2; ++shift) {
    const std::string blank(static_cast<std::size_t>((1 << 18) - static_cast<int>(longest) + shift), '\n');
    for (std::size_t size : {longest, longest + 1}) {
      const std::string text = blank + std::string(size, 'x') + "\ny";
      Words expected = expected_words(text);
      if (size > longest) {
        expected.words.clear();
        expected.error = "malformed_input: f.g2:" + refused(static_cast<int>(blank.size()) + 1, 'x');
      }
      BOOST_CHECK_EQUAL(read_words<CGAL::Sequential_tag>(text, whole), expected);
      BOOST_CHECK_EQUAL(read_words<CGAL::Parallel_if_available_tag>(text, whole), expected);
    }
  }
}

// Complete words that were read before the failure count; the failure is never taken for the end.
BOOST_AUTO_TEST_CASE(failing_streams) {
  const std::string reason = std::generic_category().message(EIO);
  const std::function<void()> system = [] { throw std::system_error(EIO, std::generic_category(), "read"); },
                              other = [] { throw std::runtime_error("out of paper"); },
                              own = [] { throw GC::Error(GC::Error_code::cannot_read_file, "from the stream"); };
  const std::pair<std::function<void()>, std::string> failures[] = {{system, "cannot_read_file: f.g2: " + reason},
                                                                    {other, "cannot_read_file: f.g2: out of paper"},
                                                                    {own, "cannot_read_file: from the stream"}};
  for (const auto& [failure, error] : failures)
    for (const std::string& text :
         {""s, " "s, "1"s, "1 "s, "12345"s, "1 2\n3 4"s, "1 2\n3 "s, "1 2 345"s, "123456 1234567 12345678"s,
          "\xEF\xBB\xBF"s, "\xEF\xBB\xBF\61\62"s, "1 " + std::string(4000, 'x'), "1\n" + std::string(10000, '\n'),
          std::string(5000, '\n') + "1 2"}) {
      const bool has_mark = text[0] == '\xEF';
      Words expected = expected_words(has_mark ? text.substr(3) : text);
      const char last = text.empty() ? ' ' : text.back();
      // perhaps half a word
      if (last != ' ' && last != '\n' && !expected.words.empty()) expected.words.pop_back();
      expected.error = error;
      check_words(text, expected, failure);
    }
  std::istringstream bad("1 2");
  bad.setstate(std::ios_base::badbit);
  CHECK_ERROR(GC::internal::Token_reader<>(bad, "f.g2"), cannot_read_file);
}

BOOST_AUTO_TEST_SUITE_END()
