// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GRADED_JOINS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GRADED_JOINS_H

#include "commands/fonts/Glyph_join.h"
#include "formats/font/Glyph_outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The demands on joins, and the bounds of their grades.
struct Join_rule {
  GC::Corner_threshold corner = GC::Corner_threshold(); // between kinks and corners
  Handle_rounding rounding = Handle_rounding();         // between kinks and rounding
  // g1 or g2, of all joins but corners, bends and rounding
  std::optional<GC::Visual_class> required = {};
  std::optional<GC::Corner_threshold> max_kink = {}; // which no kink may exceed

  bool requires_something() const { return required || max_kink; }
};

// How many joins of a glyph or of a font there are of each grade.
class Join_counts {
  std::array<std::size_t, 6> of_grade_{};
  std::size_t off_ = 0, failing_ = 0;

public:
  void add(Glyph_grade grade, bool is_off_by_more_than_one_unit, bool fails) {
    ++of_grade_[static_cast<std::size_t>(grade)];
    off_ += is_off_by_more_than_one_unit;
    failing_ += fails;
  }
  std::size_t operator[](Glyph_grade grade) const { return of_grade_[static_cast<std::size_t>(grade)]; }
  std::size_t joins() const { return std::accumulate(of_grade_.begin(), of_grade_.end(), std::size_t(0)); }

  // The kinks and bends where a handle or a line is off by more than one unit of the font.
  std::size_t off_by_more_than_one_unit() const { return off_; }

  // Those that are not what is required.
  std::size_t failing() const { return failing_; }

  Join_counts& operator+=(const Join_counts& x) {
    for (std::size_t i = 0; i < of_grade_.size(); ++i) of_grade_[i] += x.of_grade_[i];
    off_ += x.off_;
    failing_ += x.failing_;
    return *this;
  }
};

// A join that a report shows.
struct Shown_join {
  int glyph, part; // the glyph, and the component whose contour it is
  std::size_t contour, node;
  Glyph_grade grade;
  bool fails;
  double units_off, severity; // in units, and in parts of an em
  Glyph_segment left, right;
  std::int64_t steps;     // of their points
  std::size_t copies = 0; // of the same two segments, moved
  std::string glyph_name = {}, part_name = {}, font_name = {};
};

// The worst joins of a glyph, of a font or of all fonts: kinks and then bends by how far they are
// off, then those that are G1, in the order in which they were added. Copies of a kink, as letters
// with accents have them, are counted once if that is wanted.
class Worst_joins {
  std::size_t most_;
  bool unites_copies_;
  // more than there may be, so that they need not be sorted each time
  std::vector<Shown_join> joins_;

  // The coordinates of both segments from the node on.
  static std::array<std::int64_t, 16> shape(const Shown_join& join) {
    std::array<std::int64_t, 16> result{};
    std::size_t i = 0;
    for (const Glyph_segment* segment : {&join.left, &join.right})
      for (std::size_t k = 0; k < 4; ++k, i += 2)
        if (k <= static_cast<std::size_t>(segment->degree)) {
          result[i] = segment->points[k].x - join.right.start().x;
          result[i + 1] = segment->points[k].y - join.right.start().y;
        }
    return result;
  }
  static bool is_worse(const Shown_join& x, const Shown_join& y) {
    return x.grade != y.grade ? x.grade < y.grade : x.units_off > y.units_off;
  }
  bool are_copies(const Shown_join& x, const Shown_join& y) const {
    return x.grade != Glyph_grade::g1 && y.grade == x.grade && x.units_off == y.units_off && x.steps == y.steps &&
           x.font_name == y.font_name && x.left.degree == y.left.degree && x.right.degree == y.right.degree &&
           shape(x) == shape(y);
  }

  void sort() {
    std::stable_sort(joins_.begin(), joins_.end(), is_worse);
    if (unites_copies_) unite_copies();
    if (joins_.size() > most_) joins_.resize(most_);
  }
  void unite_copies() {
    std::size_t size = 0;
    for (Shown_join& join : joins_) {
      std::size_t i = size; // looks back among those that are as bad, but not for ever
      while (i > 0 && size - i < 100 && !is_worse(joins_[i - 1], join) && !are_copies(joins_[i - 1], join)) --i;
      if (i > 0 && size - i < 100 && are_copies(joins_[i - 1], join))
        joins_[i - 1].copies += 1 + join.copies;
      else if (&joins_[size++] != &join)
        joins_[size - 1] = std::move(join);
    }
    joins_.resize(size);
  }

public:
  static constexpr std::size_t all = (std::numeric_limits<std::size_t>::max)() / 4;

  Worst_joins(std::size_t most, bool unites_copies) : most_(most), unites_copies_(unites_copies) {}

  void add(const Shown_join& join) {
    if (most_ == 0) return;
    joins_.push_back(join);
    if (joins_.size() >= 2 * most_ + 64) sort();
  }

  void clear() { joins_.clear(); }

  // Returns them, the worst one first.
  const std::vector<Shown_join>& sorted() {
    sort();
    return joins_;
  }
};

// Where a join is, e.g. "glyph eacute, in its component acute, contour 1, node 0".
inline std::string join_place(const std::string& glyph, const std::string& component, std::size_t contour,
                              std::size_t node) {
  return "glyph " + glyph + (component.empty() ? "" : ", in its component " + component) + ", contour " +
         std::to_string(contour) + ", node " + std::to_string(node);
}

// Grades the joins of a glyph, and calls visit(contour, node, grade, fails, join, left, right) for
// each of them.
template <class Visit> Join_counts grade_joins(const Glyph_outline& outline, const Join_rule& rule, Visit visit) {
  static const Handle_rounding one_unit;
  const bool wants_g2 = rule.required == GC::Visual_class::g2;
  Join_counts counts;
  for (std::size_t contour = 0; contour < outline.contours(); ++contour) {
    const Glyph_segment *const begin = outline.begin(contour), *const end = outline.end(contour), *left = end - 1;
    for (const Glyph_segment* right = begin; right != end; left = right++) {
      const Glyph_join join(*left, *right, outline.steps());
      const Glyph_grade grade = join.grade(rule.corner, rule.rounding);
      const bool is_kink = grade == Glyph_grade::kink;
      const bool fails = (is_kink && (rule.required || (rule.max_kink && join.exceeds(*rule.max_kink)))) ||
                         (wants_g2 && grade == Glyph_grade::g1);
      counts.add(grade, is_defect(grade) && join.is_off_by_more_than(one_unit), fails);
      visit(contour, static_cast<std::size_t>(right - begin), grade, fails, join, *left, *right);
    }
  }
  return counts;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_GRADED_JOINS_H
