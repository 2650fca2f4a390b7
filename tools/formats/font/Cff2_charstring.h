// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_CHARSTRING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_CHARSTRING_H

#include "formats/font/Font_bytes.h"
#include "formats/font/Glyph_variations.h"
#include "formats/font/Variable_outline.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The drawing of a glyph in the table 'CFF2'. OpenType specification, "CFF2 CharString Format".

namespace CGAL {
namespace Geometric_continuity {

// An integer of a charstring or a dictionary whose first byte is 28 or at least 32, and less than 255.
inline int read_charstring_integer(Font_bytes& bytes, int first) {
  if (first == 28) return bytes.i16();
  if (first < 247) return first - 139;
  if (first < 251) return (first - 247) * 256 + bytes.u8() + 108;
  if (first < 255) return -(first - 251) * 256 - bytes.u8() - 108;
  bytes.refuse("the byte 255 is no number here");
}

/// Draws a glyph. All numbers are those of the file: integers and multiples of \f$ 2^{-16} \f$, and their sums are exact.
class Cff2_charstring {
  // A number, which moves by `deltas[r]` times the scalar of region r; without deltas it stays.
  struct Value {
    double value = 0;
    std::vector<double> deltas = {};

    Value& operator+=(const Value& x) {
      value += x.value;
      if (deltas.size() < x.deltas.size()) deltas.resize(x.deltas.size(), 0);
      for (std::size_t r = 0; r < x.deltas.size(); ++r) deltas[r] += x.deltas[r];
      return *this;
    }
    Value operator-() const {
      Value x{-value, deltas};
      for (double& delta : x.deltas) delta = -delta;
      return x;
    }
  };
  typedef std::vector<std::string_view> Subroutines;
  typedef std::vector<std::vector<Variation_region>> Regions;

  static constexpr std::size_t max_stack = 513, max_operators = 1 << 18;
  static constexpr int max_depth = 10;
  static constexpr double max_coordinate = 1 << 20;

  const std::string name_;
  const Subroutines &global_, &local_;
  const Regions& regions_;
  std::size_t set_; // of regions
  bool blended_ = false;
  std::vector<Value> stack_;
  std::size_t stems_ = 0, operators_ = 0;
  Value x_, y_;
  std::vector<std::array<Value, 2>> points_;
  Variable_outline outline_{true, {}, {}};

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ": " + reason);
  }

public:
  /// Prepares for one glyph, with the sets of regions and the one to begin with.
  Cff2_charstring(std::string name, const Subroutines& global, const Subroutines& local, const Regions& regions,
                  std::size_t set)
      : name_(std::move(name)), global_(global), local_(local), regions_(regions), set_(set) {}

  /// Returns the outline. \throws Error `malformed_input`, `work_limit`
  Variable_outline outline(std::string_view charstring) {
    run(charstring, 0);
    end_contour();
    if (points_.empty()) return outline_;
    if (set_ < regions_.size()) outline_.regions = regions_[set_];
    typedef Variable_leg::FT FT;
    outline_.shifts.assign(outline_.regions.size(), std::vector<Outline_vector>(points_.size(), {FT(0), FT(0)}));
    for (std::size_t i = 0; i < points_.size(); ++i)
      for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t r = 0; r < points_[i][c].deltas.size(); ++r)
          outline_.shifts[r][i][c] = FT(points_[i][c].deltas[r]);
    return outline_;
  }

private:
  std::size_t region_count() const { return set_ < regions_.size() ? regions_[set_].size() : 0; }

  void push(Value x) {
    if (stack_.size() == max_stack) refuse("it has more than 513 operands");
    stack_.push_back(std::move(x));
  }

  std::size_t pop_count() {
    if (stack_.empty() || !stack_.back().deltas.empty() || !(stack_.back().value >= 0)) refuse("a number is missing");
    const std::size_t n = static_cast<std::size_t>(stack_.back().value);
    stack_.pop_back();
    return n;
  }

  void run(std::string_view charstring, int depth) {
    if (depth > max_depth) refuse("its subroutines call each other more than 10 times");
    Font_bytes bytes(charstring, name_);
    while (bytes.left() != 0) {
      const int byte = bytes.u8();
      if (byte == 255)
        push({static_cast<double>(bytes.i32()) / 65536});
      else if (byte == 28 || byte >= 32)
        push({static_cast<double>(read_charstring_integer(bytes, byte))});
      else
        apply(byte == 12 ? 0x0c00 | bytes.u8() : byte, bytes, depth);
    }
  }

  void call(const Subroutines& subroutines, int depth) {
    const double bias = subroutines.size() < 1240 ? 107 : subroutines.size() < 33900 ? 1131 : 32768;
    if (stack_.empty()) refuse("a number is missing");
    const double number = stack_.back().value + bias;
    stack_.pop_back();
    if (!(0 <= number && number < static_cast<double>(subroutines.size()))) refuse("there is no such subroutine");
    run(subroutines[static_cast<std::size_t>(number)], depth + 1);
  }

  // Of n values, each with a delta for each region behind all of them.
  void blend() {
    const std::size_t n = pop_count(), k = region_count();
    if (stack_.size() / (k + 1) < n) refuse("operands of a blend are missing");
    const std::size_t begin = stack_.size() - n * (k + 1);
    for (std::size_t i = 0; i < n; ++i) {
      Value& x = stack_[begin + i];
      if (!x.deltas.empty()) refuse("a blend of blends");
      for (std::size_t r = 0; r < k; ++r) {
        const Value& delta = stack_[begin + n + i * k + r];
        if (!delta.deltas.empty()) refuse("a blend of blends");
        x.deltas.push_back(delta.value);
      }
    }
    stack_.resize(begin + n);
    blended_ = true;
  }

  void apply(int operation, Font_bytes& bytes, int depth) {
    enum { hstem = 1, vstem = 3, vmove = 4, line = 5, hline = 6, vline = 7, curve = 8, subroutine = 10, set = 15 };
    enum { blending = 16, hstems = 18, hints = 19, counters = 20, move = 21, hmove = 22, vstems = 23 };
    enum { curves_line = 24, lines_curve = 25, vvcurve = 26, hhcurve = 27, global = 29, vhcurve = 30, hvcurve = 31 };
    enum { hflex = 0x0c22, flex = 0x0c23, hflex1 = 0x0c24, flex1 = 0x0c25 };
    if (++operators_ > max_operators)
      throw Error(Error_code::work_limit, name_ + ": more than " + std::to_string(max_operators) + " operators");
    switch (operation) {
    case subroutine: return call(local_, depth);
    case global: return call(global_, depth);
    case blending: return blend();
    case set:
      if (blended_) refuse("its regions change");
      set_ = pop_count();
      if (regions_.size() <= set_) refuse("there is no set " + std::to_string(set_) + " of regions");
      return;
    case hints:
    case counters:
      stems_ += stack_.size() / 2;
      bytes.skip((stems_ + 7) / 8);
      break;
    case hstem:
    case vstem:
    case hstems:
    case vstems: stems_ += stack_.size() / 2; break;
    case move: needs(2), begin_contour(stack_[0], stack_[1]); break;
    case hmove: needs(1), begin_contour(stack_[0], {}); break;
    case vmove: needs(1), begin_contour({}, stack_[0]); break;
    case line: lines(0, stack_.size()); break;
    case hline:
    case vline:
      for (std::size_t i = 0; i < stack_.size(); ++i)
        if ((operation == hline) == (i % 2 == 0))
          add(stack_[i], {}, true);
        else
          add({}, stack_[i], true);
      break;
    case curve: curves(0, stack_.size()); break;
    case curves_line:
      needs(2);
      curves(0, stack_.size() - 2);
      lines(stack_.size() - 2, stack_.size());
      break;
    case lines_curve:
      needs(6);
      lines(0, stack_.size() - 6);
      curves(stack_.size() - 6, stack_.size());
      break;
    case vvcurve:
    case hhcurve: parallel_curves(operation == hhcurve); break;
    case vhcurve:
    case hvcurve: alternating_curves(operation == hvcurve); break;
    case hflex:
      needs(7);
      curve_by({stack_[0], {}, stack_[1], stack_[2], stack_[3], {}});
      curve_by({stack_[4], {}, stack_[5], -stack_[2], stack_[6], {}});
      break;
    case flex: needs(12), curves(0, 12); break;
    case hflex1:
      needs(9);
      curve_by({stack_[0], stack_[1], stack_[2], stack_[3], stack_[4], {}});
      curve_by({stack_[5], {}, stack_[6], stack_[7], stack_[8], -sum({1, 3, 7})});
      break;
    case flex1: flex_to_an_axis(); break;
    default: refuse("the operator " + std::to_string(operation) + " is unknown");
    }
    stack_.clear();
  }

  void needs(std::size_t count) const {
    if (stack_.size() < count) refuse("operands are missing");
  }

  Value sum(std::initializer_list<std::size_t> places) const {
    Value x;
    for (std::size_t i : places) x += stack_[i];
    return x;
  }

  void end_contour() {
    const int end = static_cast<int>(points_.size());
    if (end > (outline_.contour_ends.empty() ? 0 : outline_.contour_ends.back())) outline_.contour_ends.push_back(end);
  }

  void begin_contour(const Value& dx, const Value& dy) {
    end_contour();
    add(dx, dy, true);
  }

  void add(const Value& dx, const Value& dy, bool on_curve) {
    x_ += dx;
    y_ += dy;
    if (!(std::abs(x_.value) <= max_coordinate && std::abs(y_.value) <= max_coordinate))
      refuse("a coordinate beyond 2^20");
    if (Glyph_variations::max_movements / (region_count() + 1) <= points_.size())
      throw Error(Error_code::work_limit,
                  name_ + ": more than " + std::to_string(Glyph_variations::max_movements) + " movements of points");
    points_.push_back({x_, y_});
    outline_.points.push_back({x_.value, y_.value, on_curve});
  }

  void lines(std::size_t begin, std::size_t end) {
    if ((end - begin) % 2 != 0) refuse("operands are missing");
    for (std::size_t i = begin; i < end; i += 2) add(stack_[i], stack_[i + 1], true);
  }

  void curve_by(const std::array<Value, 6>& d) {
    for (std::size_t i = 0; i < 6; i += 2) add(d[i], d[i + 1], i == 4);
  }

  void curves(std::size_t begin, std::size_t end) {
    if ((end - begin) % 6 != 0) refuse("operands are missing");
    for (std::size_t i = begin; i < end; i += 2) add(stack_[i], stack_[i + 1], (i - begin) % 6 == 4);
  }

  // Curves whose ends are both horizontal, or both vertical; the first operand of an odd number is the other coordinate.
  void parallel_curves(bool horizontal) {
    std::size_t i = stack_.size() % 4;
    if (i > 1) refuse("operands are missing");
    Value other = i == 1 ? stack_[0] : Value{};
    for (; i < stack_.size(); i += 4) {
      const Value &a = stack_[i], &b = stack_[i + 1], &c = stack_[i + 2], &d = stack_[i + 3];
      if (horizontal)
        curve_by({a, other, b, c, d, {}});
      else
        curve_by({other, a, b, c, {}, d});
      other = {};
    }
  }

  // Curves from horizontal to vertical and back in turn; the last operand of an odd number is the other coordinate of the end.
  void alternating_curves(bool horizontal) {
    const std::size_t n = stack_.size() / 4 * 4, odd = stack_.size() % 4;
    if (odd > 1) refuse("operands are missing");
    for (std::size_t i = 0; i < n; i += 4, horizontal = !horizontal) {
      const Value &a = stack_[i], &b = stack_[i + 1], &c = stack_[i + 2], &d = stack_[i + 3],
                  last = odd == 1 && i + 4 == n ? stack_.back() : Value{};
      if (horizontal)
        curve_by({a, {}, b, c, last, d});
      else
        curve_by({Value{}, a, b, c, d, last});
    }
  }

  // The end has the x or the y of the start, whichever is nearer.
  void flex_to_an_axis() {
    needs(11);
    const Value dx = sum({0, 2, 4, 6, 8}), dy = sum({1, 3, 5, 7, 9});
    if (!dx.deltas.empty() || !dy.deltas.empty()) refuse("the direction of 'flex1' may depend on the instance");
    curves(0, 6);
    const bool horizontal = std::abs(dx.value) > std::abs(dy.value);
    curve_by(
        {stack_[6], stack_[7], stack_[8], stack_[9], horizontal ? stack_[10] : -dx, horizontal ? -dy : stack_[10]});
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_CFF2_CHARSTRING_H
