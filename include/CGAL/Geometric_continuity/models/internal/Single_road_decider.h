// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_SINGLE_ROAD_DECIDER_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_SINGLE_ROAD_DECIDER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/internal/Road_borders.h>
#include <CGAL/Geometric_continuity/models/internal/Road_lanes.h>
#include <CGAL/Geometric_continuity/models/internal/Road_profile.h>
#include <CGAL/Geometric_continuity/models/internal/Road_records.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Single_road_decider.h
/// A road by itself: its reference line, its profiles, its lanes from section to section,
/// and their borders as curves.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A road with its records in their order.
struct Sorted_road {
  std::vector<const Road_geometry*> plan;
  Road_sections sections;
  Road_profile elevation, superelevation;
  std::array<std::optional<Placed_lanes>, 2> lanes; // at both ends

  explicit Sorted_road(const Road& road)
      : sections(road), elevation(road.elevation), superelevation(road.superelevation) {
    for (const Road_geometry& g : road.plan) plan.push_back(&g);
  }
};

// Decides what one road says by itself.
template <class Visitor> class Single_road_decider {
protected:
  typedef Road_remark::Kind Kind;
  static constexpr const char* no_lane = "it leads to a lane that is not there";

  const Alignment_tolerance& tolerance_;
  Visitor& visitor_;
  const bool with_borders_;

  void remark(Kind kind, const Road* road, long long line, std::string what, std::string reason,
              std::string place = {}) {
    visitor_(Road_remark{kind, road, line, std::move(what), std::move(reason), std::move(place)});
  }

  // Decides one thing, and says why where that is refused.
  template <class Action>
  void decide(const Road& road, long long line, const char* what, const std::string& place, Action action) {
    try {
      action();
    } catch (const Error& e) {
      const std::size_t code = to_string(e.code()).size() + 2; // of the text, and a colon
      const std::string reason = e.code() == Error_code::not_finite     ? "its numbers are too large"
                                 : e.code() == Error_code::zero_tangent ? "all its points are equal"
                                                                        : std::string(e.what()).substr(code);
      remark(e.code() == Error_code::work_limit ? Kind::undecided : Kind::not_covered, &road, line, what, reason,
             place);
    }
  }

  bool is_within(const Road_number& x, const Road_number& tolerance) const { return !(tolerance < CGAL::abs(x)); }

  static std::string place_text(const Road_number& x) {
    std::string text = std::to_string(CGAL::to_double(x));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }

private:
  void check_length(const Road& road, const Road_geometry& g) {
    decide(road, g.line, "length", "s = " + place_text(g.s), [&] {
      const bool by_length = g.range == Road_parameter_range::arc_length;
      const Parametric_cubic cubic = parametric_cubic(g, by_length);
      const auto [error, within] = cubic.length_error(g.length, tolerance_.gap);
      const bool has_stop = !cubic.start().curvature || !cubic.end().curvature;
      Road_length_check check{road, g, error, within, {}, !has_stop && cubic.is_near_stop(g.length)};
      if (g.range == Road_parameter_range::missing) {
        const auto other = parametric_cubic(g, true).length_error(g.length, tolerance_.gap);
        if (other.second != within) check.other_reading = other;
      }
      visitor_(check);
    });
  }

  void decide_plan(const Road& road, std::vector<const Road_geometry*>& plan) {
    if (plan.empty()) return remark(Kind::fault, &road, road.line, "road", "it has no geometry");
    const auto is_before = [](const Road_geometry* x, const Road_geometry* y) { return x->s < y->s; };
    if (!std::is_sorted(plan.begin(), plan.end(), is_before)) {
      remark(Kind::fault, &road, road.line, "plan view",
             "its geometries are unsorted: the joins are those of the order in the file, the ends those by s");
      std::stable_sort(plan.begin(), plan.end(), is_before);
    }
    for (std::size_t i = 0; i < road.plan.size(); ++i) {
      const Road_geometry& g = road.plan[i];
      if (g.range == Road_parameter_range::missing)
        remark(Kind::note, &road, g.line, "paramPoly3",
               "pRange is missing; it is read as normalized, and by some programs as arcLength",
               "s = " + place_text(g.s));
      if (g.shape == Road_shape::param_poly3) check_length(road, g);
      if (i == 0) continue;
      const Road_geometry& before = road.plan[i - 1];
      decide(road, g.line, "plan", "s = " + place_text(g.s), [&] {
        const Alignment_end start = alignment_end(g, Road_end::start);
        Road_plan_join join{road,
                            before,
                            g,
                            CGAL::abs(Road_number(before.s + before.length - g.s)),
                            alignment_join(alignment_end(before, Road_end::end), start, tolerance_),
                            std::nullopt};
        if (before.range == Road_parameter_range::missing) {
          const Alignment_join other = alignment_join(parametric_cubic(before, true).end(), start, tolerance_);
          if (other.order() != join.join.order()) join.other_reading = other;
        }
        visitor_(join);
      });
    }
    const Road_number rest = Road_number(plan.back()->s + plan.back()->length - road.length);
    if (!is_within(rest, tolerance_.gap))
      remark(Kind::note, &road, road.line, "road", "its length is not that of its geometries",
             "they end at s = " + place_text(Road_number(plan.back()->s + plan.back()->length)) + ", it is " +
                 place_text(road.length));
  }

  void decide_profile(const Road& road, const Road_sections& sections, const Road_lane* lane, Road_profile_kind kind,
                      const std::vector<Road_cubic>& records, const Road_number& start, const Road_number& end) {
    static constexpr const char* names[] = {"elevation", "superelevation", "laneOffset", "width", "border"};
    const char* const name = names[static_cast<int>(kind)];
    const std::string of_lane = lane ? ", lane " + std::to_string(lane->id) : "";
    const auto note = [&](const Road_cubic& r, const std::string& reason) {
      remark(Kind::note, &road, r.line, name, reason, "s = " + place_text(Road_number(start + r.s)) + of_lane);
    };
    const Road_profile profile(records);
    if (profile.is_unsorted()) note(records.front(), "the records are unsorted; they follow each other by their s");
    profile.for_each_join(
        Road_number(end - start),
        [&](const Road_cubic& r, const Road_jet& jump) {
          const Road_number s = Road_number(start + r.s);
          visitor_(Road_profile_join{
              road,
              lane,
              kind,
              s,
              r.line,
              jump,
              {CGAL::is_zero(jump.value), CGAL::is_zero(jump.slope), CGAL::is_zero(jump.second)},
              {is_within(jump.value, kind == Road_profile_kind::superelevation ? tolerance_.kink : tolerance_.gap),
               is_within(jump.slope, tolerance_.kink)},
              kind == Road_profile_kind::lane_offset && sections.starts_at(s)});
        },
        note);
  }

  // Tells where a width becomes negative.
  void check_widths(const Road& road, const Road_lane& lane, const Road_number& start, const Road_number& end) {
    const std::vector<const Road_cubic*> records = Road_profile(lane.widths).records();
    for (std::size_t i = 0; i < records.size(); ++i) {
      const Road_number to = i + 1 < records.size() ? records[i + 1]->s : Road_number(end - start);
      if (records[i]->s < to && becomes_negative(*records[i], Road_number(to - records[i]->s)))
        remark(Kind::note, &road, records[i]->line, "width", "it becomes negative",
               "s = " + place_text(Road_number(start + records[i]->s)) + ", lane " + std::to_string(lane.id));
    }
  }

  // The numbers of the lanes of a section are 1, 2, ... and -1, -2, ....
  void check_numbers(const Road& road, const Road_section& section) {
    std::set<int> numbers{0};
    for (const Road_lane& lane : section.lanes)
      if (lane.id != 0 && !numbers.insert(lane.id).second)
        remark(Kind::fault, &road, lane.line, "lane", "its number stands twice in a section",
               "s = " + place_text(section.s) + ", lane " + std::to_string(lane.id));
    for (const Road_lane& lane : section.lanes)
      if (lane.id != 0 && numbers.count(lane.id > 0 ? lane.id - 1 : lane.id + 1) == 0)
        remark(Kind::fault, &road, lane.line, "lane", "lane numbering: the lane inside of it is missing",
               "s = " + place_text(section.s) + ", lane " + std::to_string(lane.id));
  }

  void decide_sections(const Road& road, const Road_sections& sections) {
    if (sections.is_unsorted())
      remark(Kind::note, &road, road.line, "lanes",
             "the lane sections are unsorted; they follow each other by their s");
    for (const Road_section& section : road.sections)
      if (road.length < section.s)
        remark(Kind::note, &road, section.line, "lane section", "starts behind the end, and is ignored",
               "s = " + place_text(section.s));
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const Road_section& section = sections[i];
      check_numbers(road, section);
      for (const Road_lane& lane : section.lanes) {
        const Road_number end = sections.end(i, lane.id < 0 ? -1 : 1);
        decide_profile(road, sections, &lane, Road_profile_kind::width, lane.widths, section.s, end);
        if (lane.widths.empty())
          decide_profile(road, sections, &lane, Road_profile_kind::border, lane.borders, section.s, end);
        else if (!lane.borders.empty())
          remark(Kind::note, &road, lane.line, "lane", "it has widths and borders; the widths count",
                 "s = " + place_text(section.s) + ", lane " + std::to_string(lane.id));
        check_widths(road, lane, section.s, end);
      }
    }
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
      const std::size_t left = sections.next(i, 1), right = sections.next(i, -1);
      for (const std::size_t j : std::set<std::size_t>{left, right})
        if (j != sections.size()) decide_section_join(road, sections, i, j, j == left, j == right);
    }
  }

  void decide_section_join(const Road& road, const Road_sections& sections, std::size_t i, std::size_t j, bool has_left,
                           bool has_right) {
    const Road_number& s = sections[j].s;
    Placed_lanes before, after;
    for (const int side : {1, -1}) {
      if (side > 0 ? has_left : has_right) sections.place(i, side, s, Road_side::before, before);
      if (sections.has_side(j, side)) sections.place(j, side, s, Road_side::after, after);
    }
    const Linked_lanes lanes(before, after, Road_end::end, Road_end::start, true);
    for (const auto& [from, name] : lanes.without_partner)
      remark(Kind::fault, &road, from->line, "lane link", no_lane,
             "s = " + place_text(s) + ", lane " + std::to_string(from->id) + " to " + std::to_string(name));
    for (const auto& [pair, is_named_back] : lanes.pairs) {
      const Placed_lane &from = before.at(pair.first), &to = after.at(pair.second);
      Road_section_join join{road, *from.lane, *to.lane, s, {}, {}, is_named_back, from.is_known && to.is_known,
                             true, true};
      for (const bool is_left : {true, false}) {
        if (!join.is_known || !lanes.meets(pair, is_named_back, is_left, false)) continue;
        const Road_number jump = Road_number(is_left ? to.left.t() - from.left.t() : to.right.t() - from.right.t());
        join.equal = join.equal && CGAL::is_zero(jump);
        join.within = join.within && is_within(jump, tolerance_.gap);
        (is_left ? join.left : join.right) = jump;
      }
      visitor_(join);
    }
  }

protected:
  // -- borders of lanes as curves

  // A border is known by the number of the lane inside of it: 0 is that in the middle.
  static int border_number(int lane, bool is_left) {
    return lane > 0 ? (is_left ? lane : lane - 1) : (is_left ? lane + 1 : lane);
  }
  static Road_jet jet_of_border(const Placed_lane& lane, bool is_left) {
    const Road_border& border = is_left ? lane.left : lane.right;
    Road_jet t = border.rolled;
    add(t, border.level);
    return t;
  }

  // Compares a border before a place with one after it, both in the direction of travel.
  void decide_border(const Road_contact& from, const Road_contact& to, const Placed_lane& lane,
                     const Placed_lane& to_lane, bool is_left, const Border_end& before, const Border_end& after,
                     long long line) {
    if constexpr (std::is_invocable_v<Visitor&, const Road_border_join&>) {
      const std::string place = (from.at                       ? "s = " + place_text(*from.at)
                                 : from.end == Road_end::start ? "start"
                                                               : "end") +
                                std::string(", lane ") + std::to_string(lane.lane->id) +
                                (is_left ? ", left border" : ", right border");
      if (before.folds || after.folds)
        return remark(Kind::fault, from.road, line, "lane border",
                      "the lane folds: its border reaches the centre of the curve", place);
      if (!before.end || !after.end)
        return remark(Kind::not_covered, from.road, line, "lane border",
                      "the curvature of the reference line is not known there as a rational number", place);
      visitor_(Road_border_join{from, to, *lane.lane, *to_lane.lane, is_left,
                                alignment_join(*before.end, *after.end, tolerance_), line});
    }
  }

private:
  // The places of a road where a border may have a kink.
  static std::set<Road_number> places(const Road& road) {
    std::set<Road_number> result;
    for (const Road_geometry& g : road.plan) result.insert(g.s);
    for (const Road_cubic& r : road.lane_offset) result.insert(r.s);
    for (const Road_section& section : road.sections) {
      result.insert(section.s);
      for (const Road_lane& lane : section.lanes)
        for (const std::vector<Road_cubic>* const records : {&lane.widths, &lane.borders})
          for (const Road_cubic& r : *records) result.insert(Road_number(section.s + r.s));
    }
    result.erase(result.begin(), result.upper_bound(Road_number(0)));
    result.erase(result.lower_bound(road.length), result.end());
    return result;
  }

  void decide_borders(const Road& road, const Sorted_road& sorted) {
    const std::vector<const Road_geometry*>& plan = sorted.plan;
    if (plan.empty() || sorted.sections.size() == 0) return;
    std::size_t piece = 0; // that holds before a place
    for (const Road_number& s : places(road)) {
      while (piece + 1 < plan.size() && plan[piece + 1]->s < s) ++piece;
      std::size_t next = piece; // after it
      while (next + 1 < plan.size() && !(s < plan[next + 1]->s)) ++next;
      const bool is_plan_join = next != piece;
      std::optional<Reference_place> line, line_after; // which are enclosed where they are asked for
      const Placed_lanes before = sorted.sections.at(s, Road_side::before),
                         after = sorted.sections.at(s, Road_side::after);
      std::set<std::pair<int, int>> done; // numbers of borders
      const auto decide_side = [&](const Placed_lane& from, const Placed_lane& to, bool is_left) {
        if (!from.is_known || !to.is_known) return;
        if (!done.emplace(border_number(from.lane->id, is_left), border_number(to.lane->id, is_left)).second) return;
        const Road_jet t = jet_of_border(from, is_left), t_after = jet_of_border(to, is_left), jump = t_after - t;
        if (!is_plan_join && CGAL::is_zero(jump.value) && CGAL::is_zero(jump.slope) && CGAL::is_zero(jump.second))
          return;
        const long long number = is_plan_join ? plan[next]->line : to.lane->line;
        decide(road, number, "lane border", "s = " + place_text(s), [&] {
          if (!line) {
            line = is_plan_join ? reference_end(*plan[piece], Road_end::end)
                                : reference_inside(*plan[piece], Road_number(s - plan[piece]->s));
            line_after = is_plan_join ? reference_end(*plan[next], Road_end::start) : line;
          }
          decide_border({&road, Road_end::end, s}, {&road, Road_end::start, s}, from, to, is_left, border_end(*line, t),
                        border_end(*line_after, t_after), number);
        });
      };
      const auto goes_on = [&](int id, const Placed_lane& lane) {
        const auto found = after.find(id);
        return found != after.end() && found->second.lane == lane.lane;
      };
      Placed_lanes ending, beginning = after;
      for (const auto& [id, lane] : before)
        if (!goes_on(id, lane)) ending.emplace(id, lane);
      for (const auto& [id, lane] : before)
        if (goes_on(id, lane)) {
          beginning.erase(id);
          for (const bool is_left : {true, false}) decide_side(lane, after.at(id), is_left);
        }
      const Linked_lanes linked(ending, beginning, Road_end::end, Road_end::start, true);
      for (const auto& [pair, is_named_back] : linked.pairs)
        for (const bool is_left : {true, false})
          if (linked.meets(pair, is_named_back, is_left, false))
            decide_side(ending.at(pair.first), beginning.at(pair.second), is_left);
    }
  }

public:
  Single_road_decider(const Alignment_tolerance& tolerance, Visitor& visitor, bool with_borders)
      : tolerance_(tolerance), visitor_(visitor), with_borders_(with_borders) {}

  // Decides a road, and sorts its pieces.
  void operator()(const Road& road, Sorted_road& sorted) {
    decide_plan(road, sorted.plan);
    const Road_number start(0);
    decide_profile(road, sorted.sections, nullptr, Road_profile_kind::elevation, road.elevation, start, road.length);
    decide_profile(road, sorted.sections, nullptr, Road_profile_kind::superelevation, road.superelevation, start,
                   road.length);
    decide_profile(road, sorted.sections, nullptr, Road_profile_kind::lane_offset, road.lane_offset, start,
                   road.length);
    decide_sections(road, sorted.sections);
    if (with_borders_) decide_borders(road, sorted);
    if (!road.other_heights.empty())
      remark(Kind::not_covered, &road, road.line, "height of lanes", "it depends on " + road.other_heights);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_SINGLE_ROAD_DECIDER_H
