// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H

#include "formats/font/Charstring_pen.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What the charstrings of some glyphs share.
struct Type_2_context {
  const std::vector<std::string_view>& global; // subroutines
  const std::vector<std::string_view>& local;  // subroutines
  const std::vector<std::size_t>* regions;     // CFF2: how many each set of them has; otherwise null
  std::size_t set = 0;                         // of regions
  bool is_cff2() const { return regions != nullptr; }
};

// A letter and its accent, as `endchar` may draw them: codes of Adobe's standard encoding, and where the accent is.
struct Accented_letter {
  std::int64_t letter, accent;
  Glyph_point at; // in 2^-16 units
};

// Draws a glyph of a table 'CFF ' (Adobe Technical Note 5177), or the default instance of one of a table 'CFF2' (OpenType specification,
// "CFF2 CharString Format"). All numbers are taken as they are, multiples of 2^-16.
class Type_2_charstring {
  static constexpr std::size_t max_stack = 513, max_operators = std::size_t(1) << 20;
  static constexpr int max_depth = 10;
  enum Operator {
    hstem = 1,
    vstem = 3,
    vmove = 4,
    line = 5,
    hline = 6,
    vline = 7,
    curve = 8,
    subroutine = 10,
    back = 11,
    escape = 12,
    end = 14,
    set = 15,
    blending = 16,
    hstems = 18,
    hints = 19,
    counters = 20,
    move = 21,
    hmove = 22,
    vstems = 23,
    curves_line = 24,
    lines_curve = 25,
    vvcurve = 26,
    hhcurve = 27,
    integer = 28,
    global = 29,
    vhcurve = 30,
    hvcurve = 31,
    absolute = 0x0c09,
    sum = 0x0c0a,
    difference = 0x0c0b,
    quotient = 0x0c0c,
    negative = 0x0c0e,
    drop = 0x0c12,
    product = 0x0c18,
    copy = 0x0c1b,
    exchange = 0x0c1c,
    hflex = 0x0c22,
    flex = 0x0c23,
    hflex1 = 0x0c24,
    flex1 = 0x0c25
  };

  const Type_2_context& context_;
  Charstring_pen pen_;
  std::array<std::int64_t, max_stack> stack_; // in 2^-16
  std::size_t size_ = 0, stems_ = 0, operators_ = 0, set_;
  bool has_width_; // it has been read, if there is one
  bool done_ = false;
  std::optional<Accented_letter> accented_;

  typedef const unsigned char* Place;

  [[noreturn]] static void refuse(const char* reason) { throw Font_error(std::string("charstring: ") + reason); }

public:
  Type_2_charstring(const Type_2_context& context, Glyph_outline& outline)
      : context_(context), pen_(outline), set_(context.set), has_width_(context.is_cff2()) {}

  // Appends the outline, in 2^-16 units, from a point on; what is to be drawn besides is returned. Throws Font_error.
  std::optional<Accented_letter> draw(std::string_view charstring, const Glyph_point& origin = {0, 0}) {
    pen_.jump(origin);
    run(charstring, 0);
    pen_.close();
    return accented_;
  }

private:
  void push(std::int64_t x) {
    if (size_ == max_stack) refuse("too many operands");
    stack_[size_++] = x;
  }
  std::int64_t pop() {
    needs(1);
    return stack_[--size_];
  }
  void needs(std::size_t count) const {
    if (size_ < count) refuse("operands are missing");
  }
  std::size_t pop_count() {
    const std::int64_t x = pop();
    if (x < 0 || (x & 0xffff) != 0) refuse("a number is none of its operands");
    return static_cast<std::size_t>(x >> 16);
  }

  void run(std::string_view charstring, int depth) {
    if (depth > max_depth) refuse("subroutines call each other more than 10 times");
    Place at = reinterpret_cast<Place>(charstring.data());
    const Place last = at + charstring.size();
    const auto next = [&]() -> std::int64_t {
      if (at == last) refuse("it ends too early");
      return *at++;
    };
    while (at != last && !done_) {
      const int byte = *at++;
      if (byte >= 32 && byte < 247)
        push(std::int64_t(byte - 139) * 0x10000);
      else if (byte >= 247 && byte < 251)
        push(((byte - 247) * 256 + next() + 108) * 0x10000);
      else if (byte >= 251 && byte < 255)
        push((-(byte - 251) * 256 - next() - 108) * 0x10000);
      else if (byte == 255 || byte == integer) {
        std::uint32_t x = 0;
        const int bytes = byte == 255 ? 4 : 2;
        for (int i = 0; i < bytes; ++i) x = x << 8 | static_cast<std::uint32_t>(next());
        push(byte == 255 ? static_cast<std::int32_t>(x) : std::int64_t(static_cast<std::int16_t>(x)) * 0x10000);
      } else if (byte == back)
        return;
      else if (byte == subroutine || byte == global)
        call(byte == global ? context_.global : context_.local, depth);
      else if (byte == hints || byte == counters) {
        stems();
        const std::size_t mask = (stems_ + 7) / 8;
        if (static_cast<std::size_t>(last - at) < mask) refuse("it ends too early");
        at += mask;
      } else
        apply(byte == escape ? static_cast<int>(0x0c00 | next()) : byte);
    }
  }

  void call(const std::vector<std::string_view>& subroutines, int depth) {
    if (++operators_ > max_operators) refuse("more operators than any letter needs");
    const std::int64_t bias = subroutines.size() < 1240    ? 107
                              : subroutines.size() < 33900 ? 1131
                                                           : 32768,
                       number = (pop() >> 16) + bias;
    if (number < 0 || static_cast<std::int64_t>(subroutines.size()) <= number) refuse("there is no such subroutine");
    run(subroutines[static_cast<std::size_t>(number)], depth + 1);
  }

  // Takes the width away, which may come before the operands of the first operator that clears the stack.
  void take_width(bool is_there) {
    if (has_width_) return;
    has_width_ = true;
    if (!is_there) return;
    for (std::size_t i = 1; i < size_; ++i) stack_[i - 1] = stack_[i];
    --size_;
  }

  void stems() {
    if (++operators_ > max_operators) refuse("more operators than any letter needs");
    take_width(size_ % 2 != 0);
    stems_ += size_ / 2;
    size_ = 0;
  }

  void begin_contour(std::size_t operands) {
    take_width(size_ > operands);
    needs(operands);
  }

  // The numbers at the default instance stay, those by which they vary go.
  void blend() {
    if (!context_.is_cff2() || context_.regions->size() <= set_) refuse("a blend without regions");
    const std::size_t n = pop_count(), all = n * ((*context_.regions)[set_] + 1);
    if (n > max_stack || size_ < all) refuse("operands are missing");
    size_ -= all - n;
  }

  void apply(int operation) {
    if (++operators_ > max_operators) refuse("more operators than any letter needs");
    const auto& s = stack_;
    switch (operation) {
    case blending: return blend();
    case set: set_ = pop_count(); return;
    case absolute:
    case negative:
    case drop:
    case copy:
    case exchange:
    case sum:
    case difference:
    case quotient:
    case product: return calculate(operation);
    case hstem:
    case vstem:
    case hstems:
    case vstems: return stems();
    case move: begin_contour(2), pen_.move(s[0], s[1]); break;
    case hmove: begin_contour(1), pen_.move(s[0], 0); break;
    case vmove: begin_contour(1), pen_.move(0, s[0]); break;
    case line: lines(0, size_); break;
    case hline:
    case vline:
      for (std::size_t i = 0; i < size_; ++i) {
        const bool horizontal = (operation == hline) == (i % 2 == 0);
        pen_.line(horizontal ? s[i] : 0, horizontal ? 0 : s[i]);
      }
      break;
    case curve: curves(0, size_); break;
    case curves_line: needs(2), curves(0, size_ - 2), lines(size_ - 2, size_); break;
    case lines_curve: needs(6), lines(0, size_ - 6), curves(size_ - 6, size_); break;
    case vvcurve:
    case hhcurve: parallel_curves(operation == hhcurve); break;
    case vhcurve:
    case hvcurve: alternating_curves(operation == hvcurve); break;
    case hflex:
      needs(7);
      pen_.curve(s[0], 0, s[1], s[2], s[3], 0);
      pen_.curve(s[4], 0, s[5], -s[2], s[6], 0);
      break;
    case flex: needs(12), curves(0, 12); break;
    case hflex1:
      needs(9);
      pen_.curve(s[0], s[1], s[2], s[3], s[4], 0);
      pen_.curve(s[5], 0, s[6], s[7], s[8], -(s[1] + s[3] + s[7]));
      break;
    case flex1: flex_to_an_axis(); break;
    case end:
      take_width(size_ == 1 || size_ == 5);
      if (size_ >= 4) accented_ = {s[2] >> 16, s[3] >> 16, {s[0], s[1]}};
      done_ = true;
      break;
    default:
      throw Font_error("not covered: the operator " + std::to_string(operation & 0xff) +
                       (operation > 0xff ? " behind 12" : "") + " of its charstring");
    }
    size_ = 0;
  }

  // Results that are no multiples of 2^-16 depend on the reader.
  void calculate(int operation) {
    __extension__ typedef __int128 Long;
    const bool one = operation == absolute || operation == negative || operation == drop || operation == copy;
    needs(one ? 1 : 2);
    const std::int64_t b = pop(), a = one ? 0 : pop();
    const auto exact = [](Long numerator, Long denominator) {
      if (denominator == 0 || numerator % denominator != 0)
        throw Font_error("not covered: its charstring rounds a product or a quotient");
      const Long x = numerator / denominator;
      if (x > (Long(1) << 40) || x < -(Long(1) << 40)) refuse("a number is too large");
      return static_cast<std::int64_t>(x);
    };
    switch (operation) {
    case absolute: push(std::abs(b)); break;
    case negative: push(-b); break;
    case drop: break;
    case copy: push(b), push(b); break;
    case exchange: push(b), push(a); break;
    case sum: push(exact(Long(a) + b, 1)); break;
    case difference: push(exact(Long(a) - b, 1)); break;
    case product: push(exact(Long(a) * b, 0x10000)); break;
    default: push(exact(Long(a) * 0x10000, b)); break;
    }
  }

  void lines(std::size_t i, std::size_t behind) {
    if ((behind - i) % 2 != 0) refuse("operands are missing");
    for (; i < behind; i += 2) pen_.line(stack_[i], stack_[i + 1]);
  }

  void curves(std::size_t i, std::size_t behind) {
    if ((behind - i) % 6 != 0) refuse("operands are missing");
    const auto& s = stack_;
    for (; i < behind; i += 6) pen_.curve(s[i], s[i + 1], s[i + 2], s[i + 3], s[i + 4], s[i + 5]);
  }

  // Curves whose ends are both horizontal, or both vertical; the first operand of an odd number is the other coordinate.
  void parallel_curves(bool horizontal) {
    std::size_t i = size_ % 4;
    if (i > 1) refuse("operands are missing");
    const auto& s = stack_;
    std::int64_t other = i == 1 ? s[0] : 0;
    for (; i < size_; i += 4, other = 0)
      if (horizontal)
        pen_.curve(s[i], other, s[i + 1], s[i + 2], s[i + 3], 0);
      else
        pen_.curve(other, s[i], s[i + 1], s[i + 2], 0, s[i + 3]);
  }

  // Curves from horizontal to vertical and back in turn; the last operand of an odd number is the other coordinate of the end.
  void alternating_curves(bool horizontal) {
    const std::size_t n = size_ / 4 * 4, odd = size_ % 4;
    if (odd > 1) refuse("operands are missing");
    const auto& s = stack_;
    for (std::size_t i = 0; i < n; i += 4, horizontal = !horizontal) {
      const std::int64_t last = odd == 1 && i + 4 == n ? s[n] : 0;
      if (horizontal)
        pen_.curve(s[i], 0, s[i + 1], s[i + 2], last, s[i + 3]);
      else
        pen_.curve(0, s[i], s[i + 1], s[i + 2], s[i + 3], last);
    }
  }

  // The end has the x or the y of the start, whichever is nearer.
  void flex_to_an_axis() {
    needs(11);
    const auto& s = stack_;
    const std::int64_t dx = s[0] + s[2] + s[4] + s[6] + s[8], dy = s[1] + s[3] + s[5] + s[7] + s[9];
    const bool horizontal = std::abs(dx) > std::abs(dy);
    curves(0, 6);
    pen_.curve(s[6], s[7], s[8], s[9], horizontal ? s[10] : -dx, horizontal ? -dy : s[10]);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H
