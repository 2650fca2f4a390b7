// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_LANES_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_LANES_H

#include <CGAL/Geometric_continuity/models/internal/Road_profile.h>
#include <CGAL/Geometric_continuity/models/internal/Road_records.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// \file Road_lanes.h
/// The borders of lanes across the road, exactly, and which lanes pass into which.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The place of a border across the road: lanes that take part in the superelevation lie on the
// rolled plane, lanes that are level go on from there.
struct Road_border {
  Road_jet rolled, level;
  Road_number t() const { return Road_number(rolled.value + level.value); }
};

// A lane at a place of the road, with its borders seen in the direction of the road. They are not
// known outside of a number that is missing.
struct Placed_lane {
  const Road_lane* lane;
  Road_border left, right;
  bool is_known;
};

// By their numbers.
typedef std::map<int, Placed_lane> Placed_lanes;

// The sections of a road, by their starts, without those behind its end.
class Road_sections {
  const Road& road_;
  Road_profile offset_;
  std::vector<const Road_section*> sections_;
  std::unordered_map<const Road_lane*, Road_profile> across_; // widths, or borders in place of them
  std::vector<std::size_t> with_left_, with_right_;           // sections that say what lanes there are on this side
  bool is_unsorted_ = false;

  const std::vector<std::size_t>& with_side(int side) const { return side > 0 ? with_left_ : with_right_; }

  // The lanes of one side of a section at a place, from the inside outwards.
  void place_lanes(const Road_section& section, int side, const Road_jet& offset, const Road_number& s, Road_side limit,
                   Placed_lanes& lanes) const {
    const Road_number ds = Road_number(s - section.s);
    std::vector<const Road_lane*> outwards;
    for (const Road_lane& lane : section.lanes)
      if (lane.id * side > 0) outwards.push_back(&lane);
    std::stable_sort(outwards.begin(), outwards.end(),
                     [side](const Road_lane* x, const Road_lane* y) { return x->id * side < y->id * side; });
    Road_border inner{offset, {}};
    int number = 0;
    bool is_known = true;
    for (const Road_lane* const lane : outwards) {
      if (lane->id == number) continue; // a second one of this number
      is_known = is_known && lane->id == number + side;
      number = lane->id;
      Road_jet width;
      if (lane->widths.empty() && !lane->borders.empty()) {
        width = across_.at(lane).at(ds, limit);
        add(width, offset);
        width = width - inner.rolled - inner.level;
      } else {
        width = across_.at(lane).at(ds, limit);
        if (side < 0) width = -width;
      }
      Road_border outer = inner;
      add(lane->is_level ? outer.level : outer.rolled, width);
      lanes[number] = side > 0 ? Placed_lane{lane, outer, inner, is_known} : Placed_lane{lane, inner, outer, is_known};
      inner = outer;
    }
  }

public:
  explicit Road_sections(const Road& road) : road_(road), offset_(road.lane_offset) {
    const auto is_before = [](const Road_section* x, const Road_section* y) { return x->s < y->s; };
    for (const Road_section& section : road.sections)
      if (!(road.length < section.s)) sections_.push_back(&section);
    is_unsorted_ = !std::is_sorted(sections_.begin(), sections_.end(), is_before);
    if (is_unsorted_) std::stable_sort(sections_.begin(), sections_.end(), is_before);
    for (const Road_section* const section : sections_)
      for (const Road_lane& lane : section->lanes)
        across_.emplace(&lane, Road_profile(lane.widths.empty() ? lane.borders : lane.widths));
    for (std::size_t i = 0; i < sections_.size(); ++i)
      for (const int side : {1, -1}) {
        const std::vector<Road_lane>& lanes = sections_[i]->lanes;
        const auto is_there = [side](const Road_lane& lane) { return lane.id * side > 0; };
        if (!sections_[i]->is_single_side || std::any_of(lanes.begin(), lanes.end(), is_there))
          (side > 0 ? with_left_ : with_right_).push_back(i);
      }
  }

  bool is_unsorted() const { return is_unsorted_; }
  std::size_t size() const { return sections_.size(); }
  const Road_section& operator[](std::size_t i) const { return *sections_[i]; }
  const Road_profile& offset() const { return offset_; }

  // Returns whether a section starts at s.
  bool starts_at(const Road_number& s) const {
    const auto found = std::partition_point(sections_.begin(), sections_.end(),
                                            [&](const Road_section* section) { return section->s < s; });
    return found != sections_.end() && (*found)->s == s;
  }

  // Returns whether a section says what lanes there are on a side.
  bool has_side(std::size_t i, int side) const {
    const std::vector<std::size_t>& sections = with_side(side);
    return std::binary_search(sections.begin(), sections.end(), i);
  }

  // The next section that has a side, or size().
  std::size_t next(std::size_t i, int side) const {
    const std::vector<std::size_t>& sections = with_side(side);
    const auto found = std::upper_bound(sections.begin(), sections.end(), i);
    return found == sections.end() ? size() : *found;
  }

  // The end of a section for a side.
  Road_number end(std::size_t i, int side) const {
    const std::size_t j = next(i, side);
    return j == size() ? road_.length : sections_[j]->s;
  }

  // The lanes of one side of a section at s. A section without length has no limit before its
  // start, and takes that after it.
  void place(std::size_t i, int side, const Road_number& s, Road_side limit, Placed_lanes& lanes) const {
    const Road_side own = s == sections_[i]->s ? Road_side::after : limit;
    place_lanes(*sections_[i], side, offset_.at(s, limit), s, own, lanes);
  }

  // The lanes of both sides at a place: of the section that ends or begins there, or that holds
  // there.
  Placed_lanes at(const Road_number& s, Road_side limit) const {
    Placed_lanes lanes;
    if (sections_.empty()) return lanes;
    for (const int side : {1, -1}) {
      const auto behind = std::partition_point(sections_.begin(), sections_.end(), [&](const Road_section* section) {
        return limit == Road_side::before ? section->s < s : !(s < section->s);
      });
      const std::vector<std::size_t>& own = with_side(side);
      if (own.empty()) continue;
      const auto found = std::lower_bound(own.begin(), own.end(), static_cast<std::size_t>(behind - sections_.begin()));
      place(found == own.begin() ? *found : *(found - 1), side, s, limit,
            lanes); // the first one holds before its start
    }
    return lanes;
  }
};

// The pairs of lanes that pass into each other, from lanes of one place to those of another one.
class Lane_pairs {
  typedef std::pair<int, int> Pair;
  std::vector<Pair> pairs_;
  std::set<Pair> known_;
  std::map<int, Pair> most_of_from_, most_of_to_; // the least and the largest number beside a lane

  static void widen(std::map<int, Pair>& most, int lane, int other) {
    const auto [entry, is_new] = most.emplace(lane, Pair(other, other));
    if (is_new) return;
    entry->second.first = (std::min)(entry->second.first, other);
    entry->second.second = (std::max)(entry->second.second, other);
  }

public:
  const std::vector<Pair>& pairs() const { return pairs_; }

  // Adds a pair, and returns whether it is new.
  bool add(int from, int to) {
    if (!known_.emplace(from, to).second) return false;
    pairs_.emplace_back(from, to);
    widen(most_of_from_, from, to);
    widen(most_of_to_, to, from);
    return true;
  }

  // Returns whether the borders on the left, or on the right, of both meet: those of bundles do at
  // their rims. With `is_flipped` the left of the second place is its right.
  bool meets(const Pair& pair, bool is_left, bool is_flipped) const {
    const Pair &to = most_of_from_.at(pair.first), &from = most_of_to_.at(pair.second);
    return pair.second == (is_left != is_flipped ? to.second : to.first) &&
           pair.first == (is_left ? from.second : from.first);
  }
};

// The pairs of lanes that pass into each other at two places, as the lanes name them.
struct Linked_lanes {
  Lane_pairs named, all;                                   // as the first ones name them, and as both do
  std::vector<std::pair<std::pair<int, int>, bool>> pairs; // and whether only the second one names the first
  std::vector<std::pair<const Road_lane*, int>> without_partner;

  Linked_lanes(const Placed_lanes& from, const Placed_lanes& to, Road_end from_end, Road_end to_end,
               bool is_named_back) {
    add(from, to, from_end, false);
    if (is_named_back) add(to, from, to_end, true);
  }

  void add(const Placed_lanes& from, const Placed_lanes& to, Road_end end, bool is_back) {
    for (const auto& [id, lane] : from)
      for (const int name : end == Road_end::end ? lane.lane->successors : lane.lane->predecessors) {
        if (name == 0) continue;
        if (to.count(name) == 0) {
          without_partner.emplace_back(lane.lane, name);
          continue;
        }
        const std::pair<int, int> pair = is_back ? std::pair(name, id) : std::pair(id, name);
        if (!is_back) named.add(pair.first, pair.second);
        if (all.add(pair.first, pair.second)) pairs.emplace_back(pair, is_back);
      }
  }

  bool meets(const std::pair<int, int>& pair, bool is_named_back, bool is_left, bool is_flipped) const {
    return (is_named_back ? all : named).meets(pair, is_left, is_flipped);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_LANES_H
