// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_FLOATING_POINT_CHARCONV_H
#define GEOMETRIC_CONTINUITY_BROWSER_FLOATING_POINT_CHARCONV_H

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <type_traits>

/// \file floating_point_charconv.h
/// The functions of <charconv> for floating-point numbers, which C++17 has and the library of
/// Emscripten 3.1.6 has not. It is included first by an option of the compiler. The functions of C
/// that do the work round correctly in Emscripten's library and know no locale.

#if defined __EMSCRIPTEN__ && _LIBCPP_VERSION < 14000
_LIBCPP_BEGIN_NAMESPACE_STD

namespace geometric_continuity_charconv {

inline to_chars_result put(char* first, char* last, const char* text, int length) {
  if (last - first < length) return {last, errc::value_too_large};
  return {copy(text, text + length, first), errc()};
}

template <class T> T number(const char* text) {
  if constexpr (is_same_v<T, float>)
    return strtof(text, nullptr);
  else if constexpr (is_same_v<T, double>)
    return strtod(text, nullptr);
  else
    return strtold(text, nullptr);
}

// The digits d1 d2 ... and the exponent e of 0 < x = d1.d2... 10^e, rounded to n digits.
template <class T> string digits_of(T x, int n, int& exponent) {
  char text[64];
  snprintf(text, sizeof text, "%.*Le", n - 1, static_cast<long double>(x));
  exponent = atoi(strchr(text, 'e') + 1);
  string digits(1, text[0]);
  if (n > 1) digits.append(text + 2, static_cast<size_t>(n - 1));
  return digits;
}

// Returns whether the digits, with a last one that is larger by -1, 0 or 1, are read as the number
// x.
template <class T> bool is_read_as(string digits, int exponent, int more, T x, string& result) {
  for (size_t i = digits.size(); more != 0;) {
    if (i == 0) return false; // 99...9 or 10...0, which have fewer digits
    --i;
    if (more > 0 && digits[i] == '9')
      digits[i] = '0';
    else if (more < 0 && digits[i] == '0')
      digits[i] = '9';
    else {
      digits[i] = static_cast<char>(digits[i] + more);
      break;
    }
  }
  if (digits[0] == '0') return false;
  const string text = digits + 'e' + to_string(exponent - static_cast<int>(digits.size()) + 1);
  if (number<T>(text.c_str()) != x) return false;
  result = digits;
  return true;
}

// The fewest digits that are read as x > 0, of these the nearest to x. Where x is a power of two
// the numbers below lie closer, and the nearest number of so many digits may be read as another one
// while its neighbour is not.
template <class T> string shortest_digits(T x, int& exponent) {
  string result;
  for (int n = 1;; ++n) {
    const string digits = digits_of(x, n, exponent);
    for (int more : {0, 1, -1})
      if (is_read_as(digits, exponent, more, x, result)) return result;
  }
}

// The shortest text that is read as x; in a tie the one without an exponent.
template <class T> to_chars_result put_shortest(char* first, char* last, T x) {
  string text(signbit(x) ? "-" : "");
  if (isnan(x) || isinf(x))
    text += isnan(x) ? "nan" : "inf";
  else if (x == 0)
    text += '0';
  else {
    int exponent;
    const string digits = shortest_digits(abs(x), exponent);
    const int n = static_cast<int>(digits.size()), size = std::abs(exponent);
    const int scientific = n + (n > 1) +
                           (size < 100    ? 4
                            : size < 1000 ? 5
                                          : 6),
              fixed = exponent < 0       ? n + 1 - exponent
                      : exponent < n - 1 ? n + 1
                                         : exponent + 1;
    if (scientific < fixed) {
      text += digits[0];
      if (n > 1) text.append(1, '.').append(digits, 1);
      text.append(1, 'e').append(1, exponent < 0 ? '-' : '+').append(size < 10 ? "0" : "") += to_string(size);
    } else if (exponent < 0)
      text.append("0.").append(static_cast<size_t>(-exponent - 1), '0') += digits;
    else if (exponent < n - 1)
      text.append(digits, 0, static_cast<size_t>(exponent + 1))
          .append(1, '.')
          .append(digits, static_cast<size_t>(exponent + 1));
    else { // an integer: all its digits, as they are
      char integer[400];
      text.append(integer,
                  static_cast<size_t>(snprintf(integer, sizeof integer, "%.0Lf", static_cast<long double>(abs(x)))));
    }
  }
  return put(first, last, text.data(), static_cast<int>(text.size()));
}

// The longest beginning of a text that is a decimal number, as from_chars() reads it.
inline const char* end_of_number(const char* p, const char* last) {
  const auto digits = [&](const char* from) { return find_if(from, last, [](char c) { return c < '0' || '9' < c; }); };
  if (p != last && *p == '-') ++p;
  const char *const integer = p, *end = digits(p);
  bool any = end != integer;
  if (end != last && *end == '.') {
    const char* const fraction = digits(end + 1);
    any = any || fraction != end + 1;
    if (any) end = fraction;
  }
  if (!any) return nullptr;
  if (end != last && (*end == 'e' || *end == 'E')) {
    const char* exponent = end + 1;
    if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
    if (digits(exponent) != exponent) end = digits(exponent);
  }
  return end;
}

template <class T> from_chars_result read(const char* first, const char* last, T& value) {
  const char* const end = end_of_number(first, last);
  if (!end) return {first, errc::invalid_argument};
  const string text(first, end);
  const T x = number<T>(text.c_str());
  const auto mantissa_end = find_if(text.begin(), text.end(), [](char c) { return c == 'e' || c == 'E'; });
  const bool zero = all_of(text.begin(), mantissa_end, [](char c) { return c < '1' || '9' < c; });
  if (isinf(x) || (x == 0 && !zero)) return {end, errc::result_out_of_range};
  value = x;
  return {end, errc()};
}

} // namespace geometric_continuity_charconv

inline from_chars_result from_chars(const char* first, const char* last, float& x) {
  return geometric_continuity_charconv::read(first, last, x);
}
inline from_chars_result from_chars(const char* first, const char* last, double& x) {
  return geometric_continuity_charconv::read(first, last, x);
}

inline to_chars_result to_chars(char* first, char* last, float x) {
  return geometric_continuity_charconv::put_shortest(first, last, x);
}
inline to_chars_result to_chars(char* first, char* last, double x) {
  return geometric_continuity_charconv::put_shortest(first, last, x);
}
inline to_chars_result to_chars(char* first, char* last, long double x) {
  return geometric_continuity_charconv::put_shortest(first, last, x);
}
inline to_chars_result to_chars(char* first, char* last, double x, chars_format format, int precision) {
  char text[1200];
  const char* const pattern = format == chars_format::scientific ? "%.*e"
                              : format == chars_format::fixed    ? "%.*f"
                                                                 : "%.*g";
  return geometric_continuity_charconv::put(first, last, text, snprintf(text, sizeof text, pattern, precision, x));
}
// The shortest text with an exponent that is read as x; the other formats are not needed.
inline to_chars_result to_chars(char* first, char* last, double x, chars_format) {
  int exponent;
  const size_t digits = x == 0 ? 1 : geometric_continuity_charconv::shortest_digits(abs(x), exponent).size();
  return to_chars(first, last, x, chars_format::scientific, static_cast<int>(digits) - 1);
}

_LIBCPP_END_NAMESPACE_STD
#endif

#endif // GEOMETRIC_CONTINUITY_BROWSER_FLOATING_POINT_CHARCONV_H
