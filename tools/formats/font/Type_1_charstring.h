// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_1_CHARSTRING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_1_CHARSTRING_H

#include "formats/font/Charstring_pen.h"
#include "formats/font/charstring_operators.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Draws a glyph of a Type 1 font (Adobe Type 1 Font Format, 1990), with quotients that are
// multiples of 2^-16. Where another quotient moves a point, which depends on the reader, the glyph
// is not covered.
class Type_1_charstring {
  struct Number {
    std::int64_t value; // in 2^-16
    bool exact = true;
  };
  static constexpr std::size_t max_stack = 256, max_operators = std::size_t(1) << 20;
  static constexpr int max_depth = 16;
  const std::vector<std::string>& subroutines_;
  Charstring_pen pen_;
  Glyph_point origin_{0, 0};
  std::vector<Number> stack_, results_; // of other subroutines
  std::size_t operators_ = 0;
  bool done_ = false, in_flex_ = false;
  Glyph_point flex_at_{0, 0};
  std::vector<Glyph_point> flex_;
  std::int64_t left_bearing_ = 0;
  std::optional<Accented_letter> accented_;

public:
  Type_1_charstring(const std::vector<std::string>& subroutines, Glyph_outline& outline)
      : subroutines_(subroutines), pen_(outline) {}

  // Appends the outline, in 2^-16 units, as seen from a point; what is to be drawn instead is
  // returned. Throws Font_error.
  std::optional<Accented_letter> draw(std::string_view charstring, const Glyph_point& origin = {0, 0}) {
    origin_ = origin;
    pen_.jump(origin);
    run(charstring, 0);
    pen_.close();
    return accented_;
  }

private:
  void needs(std::size_t count) const {
    if (stack_.size() < count) charstring::refuse("operands are missing");
  }
  // An operand, which has to be what the font says.
  std::int64_t operator[](std::size_t i) const {
    if (!stack_[i].exact) throw Font_error("not covered: its charstring rounds a quotient");
    return stack_[i].value;
  }
  std::size_t pop_count() {
    needs(1);
    const Number x = stack_.back();
    stack_.pop_back();
    if (!x.exact || x.value < 0 || (x.value & 0xffff) != 0) charstring::refuse("a number is none of its operands");
    return static_cast<std::size_t>(x.value >> 16);
  }

  void run(std::string_view charstring, int depth) {
    if (depth > max_depth) charstring::refuse("subroutines call each other more than 16 times");
    std::size_t i = 0;
    const auto next = [&]() -> std::int64_t {
      if (i == charstring.size()) charstring::refuse("it ends too early");
      return static_cast<unsigned char>(charstring[i++]);
    };
    while (i != charstring.size() && !done_) {
      const std::int64_t byte = next();
      if (byte < 32) {
        if (byte == charstring::back) return;
        apply(static_cast<int>(byte == charstring::escape ? 0x0c00 | next() : byte), depth);
        continue;
      }
      std::int64_t x = 0;
      if (byte < 255)
        x = charstring::short_integer(static_cast<int>(byte), byte < charstring::first_of_two ? 0 : next());
      else {
        std::uint32_t bits = 0;
        for (int k = 0; k < 4; ++k) bits = bits << 8 | static_cast<std::uint32_t>(next());
        x = static_cast<std::int32_t>(bits);
      }
      if (stack_.size() == max_stack) charstring::refuse("too many operands");
      stack_.push_back({x * 0x10000});
    }
  }

  void apply(int operation, int depth) {
    if (++operators_ > max_operators) charstring::refuse("more operators than any letter needs");
    const Type_1_charstring& s = *this;
    switch (operation) {
    case charstring::subroutine: {
      const std::size_t number = pop_count();
      if (subroutines_.size() <= number) charstring::refuse("there is no such subroutine");
      return run(subroutines_[number], depth + 1);
    }
    case charstring::other_subroutine: return call_other();
    case charstring::pop:
      if (results_.empty()) charstring::refuse("there is no result");
      stack_.push_back(results_.back());
      results_.pop_back();
      return;
    case charstring::quotient: return divide();
    case charstring::hstem:
    case charstring::vstem:
    case charstring::hstem3:
    case charstring::vstem3:
    case charstring::dot: break;
    // a quotient here moves the glyph as a whole
    case charstring::bearing: needs(2), begin(stack_[0].value, 0); break;
    case charstring::bearings: needs(4), begin(stack_[0].value, stack_[1].value); break;
    case charstring::move: needs(2), move_by(s[0], s[1]); break;
    case charstring::hmove: needs(1), move_by(s[0], 0); break;
    case charstring::vmove: needs(1), move_by(0, s[0]); break;
    case charstring::line: needs(2), pen_.line(s[0], s[1]); break;
    case charstring::hline: needs(1), pen_.line(s[0], 0); break;
    case charstring::vline: needs(1), pen_.line(0, s[0]); break;
    case charstring::curve: needs(6), pen_.curve(s[0], s[1], s[2], s[3], s[4], s[5]); break;
    case charstring::vhcurve: needs(4), pen_.curve(0, s[0], s[1], s[2], s[3], 0); break;
    case charstring::hvcurve: needs(4), pen_.curve(s[0], 0, s[1], s[2], 0, s[3]); break;
    case charstring::close: pen_.close(); break;
    case charstring::set_point: break; // where the curves of a flex end
    case charstring::accented:
      needs(5);
      accented_ = {s[3] >> 16, s[4] >> 16, {left_bearing_ + s[1] - s[0], s[2]}};
      done_ = true;
      break;
    case charstring::end: done_ = true; break;
    default: charstring::refuse_operator(operation);
    }
    stack_.clear();
  }

  void begin(std::int64_t x, std::int64_t y) {
    left_bearing_ = x;
    pen_.jump({origin_.x + x, origin_.y + y});
  }

  void move_by(std::int64_t dx, std::int64_t dy) {
    if (!in_flex_) return pen_.move(dx, dy);
    flex_at_ = {flex_at_.x + dx, flex_at_.y + dy};
  }

  void divide() {
    needs(2);
    const Number b = stack_.back(), a = stack_[stack_.size() - 2];
    if (b.value == 0) charstring::refuse("a division by zero");
    stack_.pop_back();
    __extension__ typedef __int128 Long;
    const Long numerator = Long(a.value) * 0x10000, x = numerator / b.value;
    if (x < -(Long(1) << 48) || (Long(1) << 48) < x) charstring::refuse("a number is too large");
    stack_.back() = {static_cast<std::int64_t>(x), a.exact && b.exact && numerator % b.value == 0};
  }

  // The subroutines that all fonts have: 0 to 2 draw flat curves of seven points, the first of
  // which is none of them, 3 changes hints, 12 and 13 are hints as well.
  void call_other() {
    const std::size_t number = pop_count(), operands = pop_count();
    needs(operands);
    results_.clear();
    if (number == 1) {
      in_flex_ = true;
      flex_.clear();
      flex_at_ = pen_.position();
    } else if (number == 2 && in_flex_) {
      if (flex_.size() == 7) charstring::refuse("a flex of more than seven points");
      flex_.push_back(flex_at_);
    } else if (number == 0 && in_flex_) {
      if (flex_.size() != 7) charstring::refuse("a flex of less than seven points");
      in_flex_ = false;
      Glyph_point from = pen_.position();
      std::array<Glyph_point, 6> d;
      for (std::size_t i = 0; i < 6; ++i) {
        d[i] = {flex_[i + 1].x - from.x, flex_[i + 1].y - from.y};
        from = flex_[i + 1];
      }
      for (std::size_t i : {0u, 3u}) pen_.curve(d[i].x, d[i].y, d[i + 1].x, d[i + 1].y, d[i + 2].x, d[i + 2].y);
      results_.assign(2, {0});
    } else if (number == 3 && operands == 1)
      results_.push_back(stack_.back());
    else if (number != 12 && number != 13)
      throw Font_error("not covered: the subroutine " + std::to_string(number) + " of PostScript");
    stack_.resize(stack_.size() - operands);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TYPE_1_CHARSTRING_H
