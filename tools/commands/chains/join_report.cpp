// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/join_report.h"

#include "commands/chains/remark_numbers.h"
#include "formats/g2_text/spans.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace {

// Ends a column of a table, which is the text from `begin` on.
void end_column(std::string& table, std::size_t begin, std::size_t width) {
  const std::size_t size = table.size() - begin;
  table.append(size < width ? width - size + 1 : 1, ' ');
}

void append_orders(std::string& text, const Join& join) {
  if (join.c_order < 0)
    text += "gap";
  else
    append(text, 'C', join.c_order, " G", join.g_order, " F", join.f_order);
}

// "name jumps from x to y", or the size of the jump when it does not show in the rounded numbers.
template <class Size> std::string jump(const char* name, const std::string& from, const std::string& to, Size size) {
  std::string text;
  text.reserve(64);
  if (from != to)
    append(text, name, " jumps from ", from, " to ", to);
  else
    append(text, name, " jumps by ", size(), " at ", from);
  return text;
}

// An angle of tangents is called by its name without a bound of kinks.
template <class Numbers>
std::string remark_of(const Join& join, const Numbers& numbers, const GC::Corner_threshold* bound) {
  if (join.c_order < 0) return "the ends are " + numbers.gap() + " apart";
  if (!join.regular) {
    const bool left_zero = numbers.left_is_zero(), right_zero = numbers.right_is_zero();
    return std::string("zero tangent ") + (left_zero && right_zero ? "on both sides"
                                           : left_zero             ? "at the end of the left curve"
                                                                   : "at the start of the right curve");
  }
  if (!*join.tangent_equal)
    return numbers.is_cusp() ? "cusp: the curve turns back"
                             : (!bound                      ? "an angle of "
                                : numbers.is_corner(*bound) ? "corner of "
                                                            : "kink of ") +
                                   numbers.angle() + " degrees";
  if (!*join.curvature_vector_equal) {
    if (*join.curvature_equal)
      return "equal curvature " + numbers.left_curvature() + ", but the curve bends another way";
    return jump("curvature", numbers.left_curvature(), numbers.right_curvature(),
                [&] { return numbers.curvature_jump(); });
  }
  if (join.torsion_equal && !*join.torsion_equal)
    return jump("torsion", numbers.left_torsion(), numbers.right_torsion(), [&] { return numbers.torsion_jump(); });
  return "smooth";
}

template <class Numbers>
Join_words words_of(const Join& join, int dimension, const Numbers& numbers, const GC::Corner_threshold& bound) {
  Join_words words{{}, remark_of(join, numbers, &bound)};
  words.point.reserve(64);
  for (int i = 0; i < dimension; ++i) append(words.point, i == 0 ? "(" : ", ", numbers.coordinate(i));
  words.point += ')';
  return words;
}

} // namespace

Requirement::Requirement(const std::string& text) : order_(-1) {
  const std::size_t kind = std::string("CGF").find(text.substr(0, 1));
  const std::string digits = text.substr((std::min<std::size_t>)(1, text.size()));
  if (!text.empty() && kind != std::string::npos && !digits.empty() && digits.size() <= 2 &&
      digits.find_first_not_of("0123456789") == std::string::npos) {
    kind_ = static_cast<GC::Continuity_kind>(kind);
    order_ = std::stoi(digits);
  }
  if (order_ < 0 || order_ > 32)
    throw std::invalid_argument("--require: '" + text + "' is not C, G or F with an order from 0 to 32, such as G2");
}

void Requirement::check_dimension(int dimension) const {
  if (kind_ == GC::Continuity_kind::F && order_ > dimension)
    throw std::invalid_argument("--require " + text() + ": the F order is at most the dimension, which is " +
                                std::to_string(dimension));
}

std::string Requirement::text() const { return "CGF"[static_cast<int>(kind_)] + std::to_string(order_); }

std::string orders(const Join& join) {
  std::string text;
  append_orders(text, join);
  return text;
}

std::string remark(const Join& join, const Jet& left, const Jet& right) {
  return remark_of(join, Exact_numbers(left, right), nullptr);
}

std::optional<std::string> remark(const Join& join, const GC::Coordinate_jet<Interval, 2>& left,
                                  const GC::Coordinate_jet<Interval, 2>& right) {
  const Enclosed_numbers<2> numbers(left, right);
  const std::string text = remark_of(join, numbers, nullptr);
  return numbers.certain() ? std::optional<std::string>(text) : std::nullopt;
}

template <class Span> Closing_reversal closing_reversal(const GC::Span_join<Span>& ends) {
  const auto point = [](const Span& span, bool at_end) {
    return at_end ? span.jets().end_jet(0)[0] : span.jets().start_jet(0)[0];
  };
  return {point(ends.left(), false) == point(ends.right(), false),
          point(ends.left(), true) == point(ends.right(), true)};
}

template <class Span>
Join_words join_words(const Join& join, const GC::Span_join<Span>& ends, const GC::Corner_threshold& bound) {
  Join_words words;
  const Closing_reversal reversal = join.c_order < 0 ? closing_reversal(ends) : Closing_reversal();
  bool certain = false;
  ends.visit_enclosures([&](const auto& x, const auto& y) {
    const Enclosed_numbers numbers(x, y);
    words = words_of(join, x.dimension(), numbers, bound);
    certain = numbers.certain();
  });
  if (!certain) {
    const Jet x = ends.left().jets().end_jet(3), y = ends.right().jets().start_jet(3);
    words = words_of(join, x.dimension(), Exact_numbers(x, y), bound);
  }
  if (reversal.left || reversal.right)
    append(words.remark, "; it closes when the ", reversal.right ? "right" : "left", " curve is reversed");
  return words;
}

std::string table_head() { return "join         orders      point                     remark\n"; }

void append_table_row(std::string& table, const Join& join, std::size_t left, std::size_t right,
                      const Join_words& words) {
  std::size_t begin = table.size();
  append(table, left, " -> ", right);
  end_column(table, begin, 12);
  begin = table.size();
  append_orders(table, join);
  end_column(table, begin, 11);
  begin = table.size();
  table += words.point;
  end_column(table, begin, 25);
  append(table, words.remark, '\n');
}

template Closing_reversal closing_reversal(const GC::Span_join<Program_span<GC::Decimal>>&);
template Closing_reversal closing_reversal(const GC::Span_join<Program_span<double>>&);
template Join_words join_words(const Join&, const GC::Span_join<Program_span<GC::Decimal>>&,
                               const GC::Corner_threshold&);
template Join_words join_words(const Join&, const GC::Span_join<Program_span<double>>&, const GC::Corner_threshold&);
