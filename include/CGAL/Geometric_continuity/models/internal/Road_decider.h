// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/Road_network.h>
#include <CGAL/Geometric_continuity/models/internal/Road_borders.h>
#include <CGAL/Geometric_continuity/models/internal/Road_lanes.h>
#include <CGAL/Geometric_continuity/models/internal/Road_profile.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

/// \file Road_decider.h
/// `road_joins()` takes each road alone, then the links between roads, then junctions.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class Visitor> class Road_decider {
  typedef Road_remark::Kind Kind;
  static constexpr const char* no_lane = "it leads to a lane that is not there";

  const Road_network& network_;
  const Alignment_tolerance& tolerance_;
  Visitor& visitor_;
  const bool with_borders_;
  std::unordered_map<std::string, std::size_t> roads_, junctions_; // by their ids

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
  std::vector<Sorted_road> sorted_;

  // The links and the pairs of lanes that have been decided: the lesser end comes first.
  typedef std::tuple<std::size_t, Road_end, int> Lane_end;
  std::set<std::pair<Lane_end, Lane_end>> decided_;

  bool is_new(const Lane_end& x, const Lane_end& y) { return decided_.insert(std::minmax(x, y)).second; }

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

  // -- a road alone

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

  // -- links

  // The data of a road where it meets another one.
  struct Contact_data {
    Road_contact contact;
    std::size_t road;
    Road_number s;
    Road_side side;
    Road_jet z, roll;
  };

  Contact_data contact_data(std::size_t road, Road_end end, const std::optional<Road_number>& at) const {
    const Road& r = network_.roads[road];
    Contact_data data{{&r, end, at},
                      road,
                      at                       ? *at
                      : end == Road_end::start ? Road_number(0)
                                               : r.length,
                      end == Road_end::start ? Road_side::after : Road_side::before,
                      {},
                      {}};
    data.z = sorted_[road].elevation.at(data.s, data.side);
    data.roll = sorted_[road].superelevation.at(data.s, data.side);
    return data;
  }

  // Two ends, the lesser one first, of which a junction connects lanes.
  typedef std::pair<std::pair<std::size_t, Road_end>, std::pair<std::size_t, Road_end>> Ends;
  std::set<Ends> connected_;

  bool is_connected(const Contact_data& x, const Contact_data& y) const {
    return connected_.count(std::minmax(std::pair(x.road, x.contact.end), std::pair(y.road, y.contact.end))) != 0;
  }

  void find_connected(const Road_junction& junction, const Road_connection& connection) {
    const auto from = roads_.find(connection.incoming), to = roads_.find(connection.connecting);
    if (from == roads_.end() || to == roads_.end() || !connection.contact || connection.lanes.empty()) return;
    if (const std::optional<Contact_data> end = incoming(junction, connection, from->second, to->second))
      connected_.insert(
          std::minmax(std::pair(end->road, end->contact.end), std::pair(to->second, *connection.contact)));
  }

  const Placed_lanes& lanes_of(const Contact_data& c, Placed_lanes& inside) {
    Sorted_road& road = sorted_[c.road];
    if (c.contact.at) return inside = road.sections.at(c.s, c.side);
    std::optional<Placed_lanes>& lanes = road.lanes[static_cast<std::size_t>(c.contact.end)];
    if (!lanes) lanes = road.sections.at(c.s, c.side);
    return *lanes;
  }

  Alignment_end contact_end(const Contact_data& c) const {
    const std::vector<const Road_geometry*>& plan = sorted_[c.road].plan;
    if (plan.empty()) throw Error(Error_code::parameter_outside_domain, "a road without geometry");
    if (!c.contact.at)
      return alignment_end(c.contact.end == Road_end::start ? *plan.front() : *plan.back(), c.contact.end);
    std::size_t i = plan.size() - 1;
    while (i > 0 && (c.side == Road_side::before ? !(plan[i]->s < c.s) : c.s < plan[i]->s)) --i;
    const Road_number length = Road_number(c.s - plan[i]->s);
    if (CGAL::is_negative(length) || plan[i]->length < length)
      throw Error(Error_code::parameter_outside_domain, "s lies outside of the road");
    if (is_polynomial(*plan[i]) && !CGAL::is_zero(length))
      throw Error(Error_code::parameter_outside_domain,
                  "s lies inside of a polynomial, of which only the ends are decided");
    return is_polynomial(*plan[i]) ? alignment_end(*plan[i], Road_end::start)
                                   : clothoid_segment(*plan[i], length).end();
  }

  // The rate of the curvature there.
  std::optional<Road_number> contact_rate(const Contact_data& c) const {
    const std::vector<const Road_geometry*>& plan = sorted_[c.road].plan;
    if (!c.contact.at)
      return curvature_rate(c.contact.end == Road_end::start ? *plan.front() : *plan.back(), c.contact.end);
    std::size_t i = plan.size() - 1;
    while (i > 0 && (c.side == Road_side::before ? !(plan[i]->s < c.s) : c.s < plan[i]->s)) --i;
    return curvature_rate(*plan[i], Road_end::start);
  }

  // The other place of a link; nothing, with a remark, where it names none.
  std::optional<Contact_data> target(const Road& road, Road_end end, const Road_link& link) {
    const std::string place = end == Road_end::start ? "predecessor" : "successor";
    const auto refuse = [&](const char* reason, const std::string& name) {
      remark(Kind::fault, &road, link.line, "link", reason, place + name);
      return std::nullopt;
    };
    if (link.target == Road_link::Target::none) return std::nullopt;
    if (link.target == Road_link::Target::other) return refuse("its elementType is neither road nor junction", "");
    if (link.target == Road_link::Target::junction) {
      if (junctions_.count(link.id) == 0)
        return refuse("it leads to a junction that is not in the file", " " + link.id);
      return std::nullopt;
    }
    const auto found = roads_.find(link.id);
    if (found == roads_.end()) return refuse("it leads to a road that is not in the file", ", road " + link.id);
    if (link.at) {
      const Road_end piece = (end == Road_end::start) != link.is_against ? Road_end::end : Road_end::start;
      return contact_data(found->second, piece, link.at);
    }
    if (!link.contact) return refuse("it has no contactPoint", ", road " + link.id);
    return contact_data(found->second, *link.contact, {});
  }

  bool names_back(const Contact_data& from, const Contact_data& to, bool also_junction) const {
    const Road& road = *to.contact.road;
    const Road_link& link = to.contact.end == Road_end::start ? road.predecessor : road.successor;
    if (link.target == Road_link::Target::junction) return also_junction;
    return link.target == Road_link::Target::road && link.id == from.contact.road->id &&
           link.contact == from.contact.end;
  }

  void decide_link(std::size_t number, Road_end end) {
    const Road& road = network_.roads[number];
    const Road_link& link = end == Road_end::start ? road.predecessor : road.successor;
    const std::optional<Contact_data> other = target(road, end, link);
    if (!other) return;
    const Contact_data from = contact_data(number, end, {});
    if (!other->contact.at && !is_new({from.road, from.contact.end, 0}, {other->road, other->contact.end, 0})) return;
    const bool is_returned = other->contact.at || names_back(from, *other, true);
    const std::string place = end == Road_end::start ? "predecessor" : "successor";
    if (!is_returned)
      remark(Kind::note, &road, link.line, "link", "the other road does not name this one there",
             place + ", road " + link.id);
    const bool is_flipped = end == other->contact.end;
    decide(road, link.line, "link", place, [&] {
      const Alignment_end mine = contact_end(from), theirs = contact_end(*other);
      const Road_number step = CGAL::abs(Road_number(from.z.value - other->z.value)),
                        grade = is_flipped ? Road_number(from.z.slope + other->z.slope)
                                           : Road_number(from.z.slope - other->z.slope);
      Placed_lanes inside;
      const Placed_lanes &lanes = lanes_of(from, inside), &their_lanes = lanes_of(*other, inside);
      const Linked_lanes linked(lanes, their_lanes, end, other->contact.end,
                                !other->contact.at && names_back(from, *other, false));
      visitor_(Road_link_join{
          from.contact, other->contact, alignment_join(mine, is_flipped ? theirs.reversed() : theirs, tolerance_), step,
          CGAL::abs(grade), is_returned, !linked.pairs.empty() || is_connected(from, *other), link.line});
      for (const auto& [lane, name] : linked.without_partner)
        remark(Kind::fault, &road, lane->line, "lane link", no_lane,
               place + ", lane " + std::to_string(lane->id) + " to " + std::to_string(name));
      std::set<std::pair<int, int>> borders;
      for (const auto& [pair, is_named_back] : linked.pairs)
        decide_lanes({from, *other, lanes, their_lanes, mine, theirs, is_named_back ? linked.all : linked.named,
                      link.line, borders},
                     pair, false, is_named_back, false);
    });
  }

  // -- junctions

  // The end of the road that leads into a connection.
  std::optional<Contact_data> incoming(const Road_junction& junction, const Road_connection& connection,
                                       std::size_t incoming, std::size_t connecting) {
    const Road& inner = network_.roads[connecting];
    const Road_link& link = *connection.contact == Road_end::start ? inner.predecessor : inner.successor;
    const Road& road = network_.roads[incoming];
    if (link.target == Road_link::Target::road && link.id == road.id && (link.contact || link.at)) {
      if (!link.at) return contact_data(incoming, *link.contact, {});
      const Road_end piece =
          (*connection.contact == Road_end::start) != link.is_against ? Road_end::end : Road_end::start;
      return contact_data(incoming, piece, link.at);
    }
    const auto leads_here = [&](const Road_link& l) {
      return l.target == Road_link::Target::junction && l.id == junction.id;
    };
    const bool at_start = leads_here(road.predecessor), at_end = leads_here(road.successor);
    if (at_start == at_end) return std::nullopt;
    return contact_data(incoming, at_start ? Road_end::start : Road_end::end, {});
  }

  void decide_connection(const Road_junction& junction, const Road_connection& connection) {
    const std::string place = "junction " + junction.id + ", connection " + connection.id;
    const auto refuse = [&](const char* reason, const std::string& road) {
      remark(Kind::fault, nullptr, connection.line, "connection", reason, place + ", road " + road);
    };
    const auto from_road = roads_.find(connection.incoming), to_road = roads_.find(connection.connecting);
    if (from_road == roads_.end()) return refuse("its incoming road is not in the file", connection.incoming);
    if (to_road == roads_.end()) return refuse("its connecting road is not in the file", connection.connecting);
    if (!connection.contact) return refuse("it has no contactPoint", connection.connecting);
    const std::optional<Contact_data> from = incoming(junction, connection, from_road->second, to_road->second);
    if (!from)
      return refuse("end not resolved: not exactly one end of its incoming road leads to the junction, and the "
                    "connecting road names none",
                    connection.incoming);
    const Contact_data to = contact_data(to_road->second, *connection.contact, {});
    const Road& road = *from->contact.road;
    decide(road, connection.line, "connection", place, [&] {
      Placed_lanes inside;
      const Placed_lanes &lanes = lanes_of(*from, inside), &their_lanes = lanes_of(to, inside);
      Lane_pairs pairs;
      for (const auto& [lane, name] : connection.lanes) {
        if (lane == 0 || name == 0) {
          remark(Kind::note, &road, connection.line, "lane link", "it names lane 0, which has no width", place);
          continue;
        }
        if (lanes.count(lane) != 0 && their_lanes.count(name) != 0)
          pairs.add(lane, name);
        else
          remark(Kind::fault, &road, connection.line, "lane link", no_lane,
                 place + ", lane " + std::to_string(lane) + " to " + std::to_string(name));
      }
      if (pairs.pairs().empty()) return;
      const Alignment_end mine = contact_end(*from), theirs = contact_end(to);
      std::set<std::pair<int, int>> borders;
      for (const std::pair<int, int>& pair : pairs.pairs())
        decide_lanes({*from, to, lanes, their_lanes, mine, theirs, pairs, connection.line, borders}, pair, true, false,
                     connection.has_overlap);
    });
  }

  // -- lanes of two roads

  struct Meeting {
    const Contact_data &from, &to;
    const Placed_lanes &lanes, &their_lanes;
    const Alignment_end &end, &their_end;
    const Lane_pairs& bundles;
    long long line;
    std::set<std::pair<int, int>>& borders; // that have been compared as curves, by their numbers
  };

  // Compares the border of a lane with that of a lane of another road, as curves.
  void decide_border(const Meeting& m, const Placed_lane& from, const Placed_lane& to, bool is_left, bool is_flipped) {
    const bool is_their_left = is_left != is_flipped;
    if (!with_borders_ ||
        !m.borders.emplace(border_number(from.lane->id, is_left), border_number(to.lane->id, is_their_left)).second)
      return;
    const auto along = [&](const Alignment_end& end, const Contact_data& c, const Placed_lane& lane, bool left) {
      return border_end({end, contact_rate(c)}, jet_of_border(lane, left));
    };
    const Border_end mine = along(m.end, m.from, from, is_left);
    Border_end theirs = along(m.their_end, m.to, to, is_their_left);
    if (is_flipped && theirs.end) theirs.end = theirs.end->reversed();
    decide(*m.from.contact.road, m.line, "lane border", "lane " + std::to_string(from.lane->id),
           [&] { decide_border(m.from.contact, m.to.contact, from, to, is_left, mine, theirs, m.line); });
  }

  static Border_point point_of(const Alignment_end& end, const Contact_data& c, const Road_border& border) {
    Border_point p(end, border.rolled.value, c.roll.value, c.z.value);
    p.plan = p.plan.moved(end.heading, Road_number(0), border.level.value);
    return p;
  }

  void decide_lanes(const Meeting& m, const std::pair<int, int>& pair, bool is_in_junction, bool is_named_back,
                    bool has_overlap) {
    if (!m.from.contact.at && !m.to.contact.at &&
        !is_new({m.from.road, m.from.contact.end, pair.first}, {m.to.road, m.to.contact.end, pair.second}))
      return;
    const bool is_flipped = m.from.contact.end == m.to.contact.end;
    const Placed_lane &from = m.lanes.at(pair.first), &to = m.their_lanes.at(pair.second);
    Road_lane_join join{m.from.contact, m.to.contact, *from.lane, *to.lane,        is_in_junction,  is_named_back,
                        has_overlap,    {},           {},         Verdict::proved, Verdict::proved, m.line};
    if (!m.from.contact.road->other_heights.empty() || !m.to.contact.road->other_heights.empty())
      join.within_height.reset();
    if (!from.is_known || !to.is_known)
      return remark(Kind::not_covered, m.from.contact.road, m.line, is_in_junction ? "junction lane" : "road lane",
                    "a lane inside of it is missing",
                    "lane " + std::to_string(pair.first) + " to lane " + std::to_string(pair.second) + " of road " +
                        m.to.contact.road->id);
    for (const bool is_left : {true, false}) {
      if (!m.bundles.meets(pair, is_left, is_flipped)) continue;
      const Road_border &x = is_left ? from.left : from.right, &y = is_left != is_flipped ? to.left : to.right;
      const Border_point mine = point_of(m.end, m.from, x), theirs = point_of(m.their_end, m.to, y);
      const Decided_distance gap = point_distance(mine.plan, theirs.plan, tolerance_.gap),
                             step = height_distance(mine, theirs, tolerance_.gap);
      join.gaps.push_back(gap.distance);
      join.steps.push_back(step.distance);
      join.within = join.within && gap.within;
      if (join.within_height) join.within_height = *join.within_height && step.within;
    }
    visitor_(join);
    for (const bool is_left : {true, false})
      if (m.bundles.meets(pair, is_left, is_flipped)) decide_border(m, from, to, is_left, is_flipped);
  }

  static std::string place_text(const Road_number& x) {
    std::string text = std::to_string(CGAL::to_double(x));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }

public:
  Road_decider(const Road_network& network, const Alignment_tolerance& tolerance, Visitor& visitor, bool with_borders)
      : network_(network), tolerance_(tolerance), visitor_(visitor), with_borders_(with_borders) {}

  void operator()() {
    sorted_.reserve(network_.roads.size());
    for (const Road& road : network_.roads) {
      if (!roads_.emplace(road.id, sorted_.size()).second)
        remark(Kind::fault, &road, road.line, "road", "another road has the same id; links lead to that one");
      sorted_.emplace_back(road);
    }
    for (std::size_t i = 0; i < network_.junctions.size(); ++i) junctions_.emplace(network_.junctions[i].id, i);
    for (std::size_t i = 0; i < sorted_.size(); ++i) {
      const Road& road = network_.roads[i];
      decide_plan(road, sorted_[i].plan);
      const Road_number start(0);
      decide_profile(road, sorted_[i].sections, nullptr, Road_profile_kind::elevation, road.elevation, start,
                     road.length);
      decide_profile(road, sorted_[i].sections, nullptr, Road_profile_kind::superelevation, road.superelevation, start,
                     road.length);
      decide_profile(road, sorted_[i].sections, nullptr, Road_profile_kind::lane_offset, road.lane_offset, start,
                     road.length);
      decide_sections(road, sorted_[i].sections);
      if (with_borders_) decide_borders(road, sorted_[i]);
      if (!road.other_heights.empty())
        remark(Kind::not_covered, &road, road.line, "height of lanes", "it depends on " + road.other_heights);
    }
    for (const Road_junction& junction : network_.junctions)
      for (const Road_connection& connection : junction.connections) find_connected(junction, connection);
    for (std::size_t i = 0; i < sorted_.size(); ++i)
      for (const Road_end end : {Road_end::start, Road_end::end}) decide_link(i, end);
    for (const Road_junction& junction : network_.junctions)
      for (const Road_connection& connection : junction.connections) decide_connection(junction, connection);
  }
};

} // namespace internal

template <class Visitor>
void road_joins(const Road_network& network, const Alignment_tolerance& tolerance, Visitor&& visitor,
                bool with_borders) {
  internal::Road_decider<std::remove_reference_t<Visitor>>(network, tolerance, visitor, with_borders)();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H
