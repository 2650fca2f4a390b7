// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_PROFILE_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_PROFILE_H

#include <CGAL/Geometric_continuity/models/internal/Road_records.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// \file Road_profile.h
/// Functions of the length along a road that are cubic polynomials in pieces, exactly: each record
/// holds from its start to the start of the next one.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The two limits at a place: towards smaller and towards larger lengths.
enum class Road_side { before, after };

inline Road_jet operator-(const Road_jet& x, const Road_jet& y) {
  return {Road_number(x.value - y.value), Road_number(x.slope - y.slope), Road_number(x.second - y.second)};
}
inline Road_jet operator-(const Road_jet& x) {
  return {Road_number(-x.value), Road_number(-x.slope), Road_number(-x.second)};
}
inline void add(Road_jet& x, const Road_jet& y) {
  x.value = Road_number(x.value + y.value);
  x.slope = Road_number(x.slope + y.slope);
  x.second = Road_number(x.second + y.second);
}

inline Road_jet jet_of(const Road_cubic& r, const Road_number& u) {
  if (CGAL::is_zero(u)) return {r.a, r.b, Road_number(r.c + r.c)};
  if (CGAL::is_zero(r.d) && CGAL::is_zero(r.c)) {
    if (CGAL::is_zero(r.b)) return {r.a, r.b, r.c};
    return {Road_number(r.a + r.b * u), r.b, r.c};
  }
  const Road_number du = Road_number(r.d * u), c3 = Road_number(r.c + du); // c + d u
  const Road_number second = Road_number(c3 + c3 + du * 4);                // 2 c + 6 d u
  return {Road_number(r.a + (r.b + c3 * u) * u), Road_number(r.b + (c3 + c3 + du) * u), second};
}

// Decides whether a record becomes negative on [0, length], by the coefficients of Bernstein: where
// none is negative, the cubic is not; where an end is negative, it is. Between, the interval is
// halved, and a minimum that is not found within `most_halvings` counts as touching zero.
inline bool becomes_negative(const Road_cubic& r, const Road_number& length) {
  typedef std::array<Road_number, 4> Coefficients;
  constexpr int most_halvings = 40;
  struct Piece {
    Coefficients b;
    int halvings;
  };
  const Road_number bl = Road_number(r.b * length), cl = Road_number(r.c * length * length),
                    dl = Road_number(r.d * length * length * length);
  std::vector<Piece> pieces{
      {{r.a, Road_number(r.a + bl / 3), Road_number(r.a + bl * 2 / 3 + cl / 3), Road_number(r.a + bl + cl + dl)}, 0}};
  while (!pieces.empty()) {
    const Piece piece = pieces.back();
    const Coefficients& b = piece.b;
    pieces.pop_back();
    if (CGAL::is_negative(b[0]) || CGAL::is_negative(b[3])) return true;
    if ((!CGAL::is_negative(b[1]) && !CGAL::is_negative(b[2])) || piece.halvings == most_halvings) continue;
    const auto mean = [](const Road_number& x, const Road_number& y) { return Road_number((x + y) / 2); };
    const Road_number b01 = mean(b[0], b[1]), b12 = mean(b[1], b[2]), b23 = mean(b[2], b[3]), b012 = mean(b01, b12),
                      b123 = mean(b12, b23), middle = mean(b012, b123);
    pieces.push_back({{b[0], b01, b012, middle}, piece.halvings + 1});
    pieces.push_back({{middle, b123, b23, b[3]}, piece.halvings + 1});
  }
  return false;
}

// The records of a profile, by their starts; of two with one start the later one in the file is the
// limit after it. Before the first record the value is 0.
class Road_profile {
  std::vector<const Road_cubic*> records_;
  bool is_unsorted_ = false;

  Road_jet limit(std::size_t behind, const Road_number& s) const {
    if (behind == 0) return {};
    const Road_cubic& r = *records_[behind - 1];
    return jet_of(r, Road_number(s - r.s));
  }

public:
  Road_profile() = default;
  // The records must live as long.
  explicit Road_profile(const std::vector<Road_cubic>& records) {
    const auto is_before = [](const Road_cubic* x, const Road_cubic* y) { return x->s < y->s; };
    for (const Road_cubic& r : records) records_.push_back(&r);
    is_unsorted_ = !std::is_sorted(records_.begin(), records_.end(), is_before);
    if (is_unsorted_) std::stable_sort(records_.begin(), records_.end(), is_before);
  }

  bool is_unsorted() const { return is_unsorted_; }
  const std::vector<const Road_cubic*>& records() const { return records_; }

  // The last record that starts before s, or at s for the limit after it.
  Road_jet at(const Road_number& s, Road_side side) const {
    const auto behind = std::partition_point(records_.begin(), records_.end(), [&](const Road_cubic* r) {
      return side == Road_side::before ? r->s < s : !(s < r->s);
    });
    return limit(static_cast<std::size_t>(behind - records_.begin()), s);
  }

  // Calls join(record, jump) for each start behind 0 up to `length`, where the record is the one
  // that holds after it, and note(record, reason) for what is odd.
  template <class Join, class Note> void for_each_join(const Road_number& length, Join join, Note note) const {
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const Road_cubic& r = *records_[i];
      if (length < r.s) {
        note(r, "starts behind the end, and is ignored");
        continue;
      }
      if (i + 1 < records_.size() && records_[i + 1]->s == r.s) {
        note(r, "starts where the next one starts, which holds from there on");
        continue;
      }
      if (i == 0 && CGAL::is_positive(r.s)) note(r, "is the first one: before it the value is 0");
      if (!CGAL::is_positive(r.s)) continue;
      std::size_t before = i;
      while (before > 0 && records_[before - 1]->s == r.s) --before;
      join(r, Road_jet(jet_of(r, Road_number(0)) - limit(before, r.s)));
    }
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_PROFILE_H
