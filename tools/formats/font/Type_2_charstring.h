// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H

#include "formats/font/Charstring_pen.h"
#include "formats/font/charstring_operators.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The charstrings of some glyphs share this.
struct Type_2_context {
  const std::vector<std::string_view>& global; // subroutines
  const std::vector<std::string_view>& local;  // subroutines
  // CFF2: how many each set of them has; otherwise null
  const std::vector<std::size_t>* regions;
  std::size_t set = 0; // of regions
  bool is_cff2() const { return regions != nullptr; }
};

// Draws a glyph of a table 'CFF ' or 'CFF2'. All numbers are taken as they are, multiples of 2^-16:
// those of the pen, which knows whether they vary. A pen has the functions of Charstring_pen from
// `Number` to `blend`, and move(), line(), curve() and close().
template <class Pen> class Type_2_charstring {
  static constexpr std::size_t max_stack = 513, max_operators = std::size_t(1) << 20;
  static constexpr int max_depth = 10;
  typedef typename Pen::Number Number;

  const Type_2_context& context_;
  Pen& pen_;
  std::array<Number, max_stack> stack_;
  std::size_t size_ = 0, stems_ = 0, operators_ = 0, set_;
  bool has_width_; // it has been read, if there is one
  bool done_ = false, blended_ = false;
  std::optional<Accented_letter> accented_;

  typedef const unsigned char* Place;

public:
  Type_2_charstring(const Type_2_context& context, Pen& pen)
      : context_(context), pen_(pen), set_(context.set), has_width_(context.is_cff2()) {}

  // Draws a glyph; what is to be drawn besides is returned. Throws Font_error.
  std::optional<Accented_letter> draw(std::string_view charstring) {
    run(charstring, 0);
    pen_.close();
    return accented_;
  }

  // The regions in which its numbers vary.
  std::size_t set() const { return set_; }

private:
  void push(const Number& x) {
    if (size_ == max_stack) charstring::refuse("more than 513 operands");
    stack_[size_++] = x;
  }
  void push_value(std::int64_t x) { push(Pen::number(x)); }
  std::int64_t pop() {
    needs(1);
    return Pen::value(stack_[--size_]);
  }
  void needs(std::size_t count) const {
    if (size_ < count) charstring::refuse("operands are missing");
  }
  std::size_t pop_count() {
    const std::int64_t x = pop();
    if (x < 0 || (x & 0xffff) != 0) charstring::refuse("a number is none of its operands");
    return static_cast<std::size_t>(x >> 16);
  }

  void run(std::string_view charstring, int depth) {
    if (depth > max_depth) charstring::refuse("subroutines call each other more than 10 times");
    Place at = reinterpret_cast<Place>(charstring.data());
    const Place last = at + charstring.size();
    const auto next = [&]() -> std::int64_t {
      if (at == last) charstring::refuse("it ends too early");
      return *at++;
    };
    while (at != last && !done_) {
      const int byte = *at++;
      if (byte >= 32 && byte < 255)
        push_value(charstring::short_integer(byte, byte < charstring::first_of_two ? 0 : next()) * 0x10000);
      else if (byte == 255 || byte == charstring::integer) {
        std::uint32_t x = 0;
        const int bytes = byte == 255 ? 4 : 2;
        for (int i = 0; i < bytes; ++i) x = x << 8 | static_cast<std::uint32_t>(next());
        push_value(byte == 255 ? static_cast<std::int32_t>(x) : std::int64_t(static_cast<std::int16_t>(x)) * 0x10000);
      } else if (byte == charstring::back && !context_.is_cff2())
        return;
      else if (byte == charstring::subroutine || byte == charstring::global)
        call(byte == charstring::global ? context_.global : context_.local, depth);
      else if (byte == charstring::hints || byte == charstring::counters) {
        stems();
        const std::size_t mask = (stems_ + 7) / 8;
        if (static_cast<std::size_t>(last - at) < mask) charstring::refuse("it ends too early");
        at += mask;
      } else
        apply(byte == charstring::escape ? static_cast<int>(0x0c00 | next()) : byte);
    }
  }

  void call(const std::vector<std::string_view>& subroutines, int depth) {
    if (++operators_ > max_operators) charstring::refuse("more operators than any letter needs");
    const std::int64_t bias = subroutines.size() < 1240    ? 107
                              : subroutines.size() < 33900 ? 1131
                                                           : 32768,
                       number = (pop() >> 16) + bias;
    if (number < 0 || static_cast<std::int64_t>(subroutines.size()) <= number)
      charstring::refuse("there is no such subroutine");
    run(subroutines[static_cast<std::size_t>(number)], depth + 1);
  }

  // Takes the width away, which may come before the operands of the first operator that clears the
  // stack.
  void take_width(bool is_there) {
    if (has_width_) return;
    has_width_ = true;
    if (!is_there) return;
    for (std::size_t i = 1; i < size_; ++i) stack_[i - 1] = stack_[i];
    --size_;
  }

  void stems() {
    if (++operators_ > max_operators) charstring::refuse("more operators than any letter needs");
    take_width(size_ % 2 != 0);
    stems_ += size_ / 2;
    size_ = 0;
  }

  void begin_contour(std::size_t operands) {
    take_width(size_ > operands);
    needs(operands);
  }

  // Blends n numbers, which are followed by all their variations.
  void blend() {
    if (!context_.is_cff2() || context_.regions->size() <= set_) charstring::refuse("a blend without regions");
    const std::size_t n = pop_count(), k = (*context_.regions)[set_];
    if (n > max_stack || size_ < n * (k + 1)) charstring::refuse("operands of a blend are missing");
    const std::size_t begin = size_ - n * (k + 1);
    for (std::size_t i = 0; i < n; ++i) Pen::blend(stack_[begin + i], &stack_[begin + n] + i * k, k);
    size_ -= n * k;
    blended_ = true;
  }

  void take_set() {
    if (blended_) charstring::refuse("its regions change");
    set_ = pop_count();
    if (!context_.is_cff2() || context_.regions->size() <= set_)
      charstring::refuse("there is no set " + std::to_string(set_) + " of regions");
  }

  void apply(int operation) {
    if (++operators_ > max_operators) charstring::refuse("more operators than any letter needs");
    const auto& s = stack_;
    const Number zero = Number();
    switch (operation) {
    case charstring::blending: return blend();
    case charstring::set: return take_set();
    case charstring::absolute:
    case charstring::negative:
    case charstring::drop:
    case charstring::copy:
    case charstring::exchange:
    case charstring::sum:
    case charstring::difference:
    case charstring::quotient:
    case charstring::product: return calculate(operation);
    case charstring::hstem:
    case charstring::vstem:
    case charstring::hstems:
    case charstring::vstems: return stems();
    case charstring::move: begin_contour(2), pen_.move(s[0], s[1]); break;
    case charstring::hmove: begin_contour(1), pen_.move(s[0], zero); break;
    case charstring::vmove: begin_contour(1), pen_.move(zero, s[0]); break;
    case charstring::line: lines(0, size_); break;
    case charstring::hline:
    case charstring::vline:
      for (std::size_t i = 0; i < size_; ++i)
        if ((operation == charstring::hline) == (i % 2 == 0))
          pen_.line(s[i], zero);
        else
          pen_.line(zero, s[i]);
      break;
    case charstring::curve: curves(0, size_); break;
    case charstring::curves_line: needs(2), curves(0, size_ - 2), lines(size_ - 2, size_); break;
    case charstring::lines_curve: needs(6), lines(0, size_ - 6), curves(size_ - 6, size_); break;
    case charstring::vvcurve:
    case charstring::hhcurve: parallel_curves(operation == charstring::hhcurve); break;
    case charstring::vhcurve:
    case charstring::hvcurve: alternating_curves(operation == charstring::hvcurve); break;
    case charstring::hflex:
      needs(7);
      pen_.curve(s[0], zero, s[1], s[2], s[3], zero);
      pen_.curve(s[4], zero, s[5], -s[2], s[6], zero);
      break;
    case charstring::flex: needs(12), curves(0, 12); break;
    case charstring::hflex1:
      needs(9);
      pen_.curve(s[0], s[1], s[2], s[3], s[4], zero);
      pen_.curve(s[5], zero, s[6], s[7], s[8], -sum({1, 3, 7}));
      break;
    case charstring::flex1: flex_to_an_axis(); break;
    case charstring::end:
      if (context_.is_cff2()) charstring::refuse_operator(operation);
      take_width(size_ == 1 || size_ == 5);
      if (size_ >= 4)
        accented_ = {Pen::value(s[2]) >> 16, Pen::value(s[3]) >> 16, {Pen::value(s[0]), Pen::value(s[1])}};
      done_ = true;
      break;
    default: charstring::refuse_operator(operation);
    }
    size_ = 0;
  }

  Number sum(std::initializer_list<std::size_t> places) const {
    Number x = Number();
    for (const std::size_t i : places) x += stack_[i];
    return x;
  }

  // Results that are no multiples of 2^-16 depend on the reader.
  void calculate(int operation) {
    __extension__ typedef __int128 Long;
    const bool one = operation == charstring::absolute || operation == charstring::negative ||
                     operation == charstring::drop || operation == charstring::copy;
    needs(one ? 1 : 2);
    const std::int64_t b = pop(), a = one ? 0 : pop();
    const auto exact = [](Long numerator, Long denominator) {
      if (denominator == 0 || numerator % denominator != 0)
        throw Font_error("not covered: its charstring rounds a product or a quotient");
      const Long x = numerator / denominator;
      if (x > (Long(1) << 40) || x < -(Long(1) << 40)) charstring::refuse("a number is too large");
      return static_cast<std::int64_t>(x);
    };
    switch (operation) {
    case charstring::absolute: push_value(std::abs(b)); break;
    case charstring::negative: push_value(-b); break;
    case charstring::drop: break;
    case charstring::copy: push_value(b), push_value(b); break;
    case charstring::exchange: push_value(b), push_value(a); break;
    case charstring::sum: push_value(exact(Long(a) + b, 1)); break;
    case charstring::difference: push_value(exact(Long(a) - b, 1)); break;
    case charstring::product: push_value(exact(Long(a) * b, 0x10000)); break;
    default: push_value(exact(Long(a) * 0x10000, b)); break;
    }
  }

  void lines(std::size_t i, std::size_t behind) {
    if ((behind - i) % 2 != 0) charstring::refuse("operands are missing");
    for (; i < behind; i += 2) pen_.line(stack_[i], stack_[i + 1]);
  }

  void curves(std::size_t i, std::size_t behind) {
    if ((behind - i) % 6 != 0) charstring::refuse("operands are missing");
    const auto& s = stack_;
    for (; i < behind; i += 6) pen_.curve(s[i], s[i + 1], s[i + 2], s[i + 3], s[i + 4], s[i + 5]);
  }

  // Curves whose ends are both horizontal, or both vertical; the first operand of an odd number is
  // the other coordinate.
  void parallel_curves(bool horizontal) {
    std::size_t i = size_ % 4;
    if (i > 1) charstring::refuse("operands are missing");
    const auto& s = stack_;
    const Number zero = Number();
    Number other = i == 1 ? s[0] : zero;
    for (; i < size_; i += 4, other = zero)
      if (horizontal)
        pen_.curve(s[i], other, s[i + 1], s[i + 2], s[i + 3], zero);
      else
        pen_.curve(other, s[i], s[i + 1], s[i + 2], zero, s[i + 3]);
  }

  // Curves from horizontal to vertical and back in turn; the last operand of an odd number is the
  // other coordinate of the end.
  void alternating_curves(bool horizontal) {
    const std::size_t n = size_ / 4 * 4, odd = size_ % 4;
    if (odd > 1) charstring::refuse("operands are missing");
    const auto& s = stack_;
    const Number zero = Number();
    for (std::size_t i = 0; i < n; i += 4, horizontal = !horizontal) {
      const Number last = odd == 1 && i + 4 == n ? s[n] : zero;
      if (horizontal)
        pen_.curve(s[i], zero, s[i + 1], s[i + 2], last, s[i + 3]);
      else
        pen_.curve(zero, s[i], s[i + 1], s[i + 2], s[i + 3], last);
    }
  }

  // The end has the x or the y of the start, whichever is nearer.
  void flex_to_an_axis() {
    needs(11);
    const auto& s = stack_;
    const Number dx = sum({0, 2, 4, 6, 8}), dy = sum({1, 3, 5, 7, 9});
    const bool horizontal = std::abs(Pen::value(dx)) > std::abs(Pen::value(dy));
    curves(0, 6);
    if (horizontal)
      pen_.curve(s[6], s[7], s[8], s[9], s[10], -dy);
    else
      pen_.curve(s[6], s[7], s[8], s[9], -dx, s[10]);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_2_CHARSTRING_H
