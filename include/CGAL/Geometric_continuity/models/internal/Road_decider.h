// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>
#include <CGAL/Geometric_continuity/models/internal/Road_borders.h>
#include <CGAL/Geometric_continuity/models/internal/Road_lanes.h>
#include <CGAL/Geometric_continuity/models/internal/Road_profile.h>
#include <CGAL/Geometric_continuity/models/internal/Road_records.h>
#include <CGAL/Geometric_continuity/models/internal/Single_road_decider.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

/// \file Road_decider.h
/// `road_joins()` takes each road alone, then the links between roads, then junctions.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class Visitor> class Road_decider : Single_road_decider<Visitor> {
  typedef Single_road_decider<Visitor> Base;
  using Base::border_number, Base::decide, Base::decide_border, Base::jet_of_border, Base::no_lane, Base::remark,
      Base::tolerance_, Base::visitor_, Base::with_borders_;
  using typename Base::Kind;

  const Road_network& network_;
  std::unordered_map<std::string, std::size_t> roads_, junctions_; // by their ids
  std::vector<Sorted_road> sorted_;

  // The links and the pairs of lanes that have been decided: the lesser end comes first.
  typedef std::tuple<std::size_t, Road_end, int> Lane_end;
  std::set<std::pair<Lane_end, Lane_end>> decided_;

  bool is_new(const Lane_end& x, const Lane_end& y) { return decided_.insert(std::minmax(x, y)).second; }

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

  // The piece of the reference line that holds at a place inside of a road. \pre it has one
  const Road_geometry& piece_at(const Contact_data& c) const {
    const std::vector<const Road_geometry*>& plan = sorted_[c.road].plan;
    const auto behind = std::partition_point(plan.begin(), plan.end(), [&](const Road_geometry* g) {
      return c.side == Road_side::before ? g->s < c.s : !(c.s < g->s);
    });
    return behind == plan.begin() ? **behind : **(behind - 1);
  }

  Alignment_end contact_end(const Contact_data& c) const {
    const std::vector<const Road_geometry*>& plan = sorted_[c.road].plan;
    if (plan.empty()) throw Error(Error_code::parameter_outside_domain, "a road without geometry");
    if (!c.contact.at)
      return alignment_end(c.contact.end == Road_end::start ? *plan.front() : *plan.back(), c.contact.end);
    const Road_geometry& piece = piece_at(c);
    const Road_number length = Road_number(c.s - piece.s);
    if (CGAL::is_negative(length) || piece.length < length)
      throw Error(Error_code::parameter_outside_domain, "s lies outside of the road");
    if (!is_polynomial(piece)) return clothoid_segment(piece, length).end();
    if (!CGAL::is_zero(length))
      throw Error(Error_code::parameter_outside_domain,
                  "s lies inside of a polynomial, of which only the ends are decided");
    return alignment_end(piece, Road_end::start);
  }

  // The rate of the curvature there.
  std::optional<Road_number> contact_rate(const Contact_data& c) const {
    const std::vector<const Road_geometry*>& plan = sorted_[c.road].plan;
    if (!c.contact.at)
      return curvature_rate(c.contact.end == Road_end::start ? *plan.front() : *plan.back(), c.contact.end);
    return curvature_rate(piece_at(c), Road_end::start);
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

public:
  Road_decider(const Road_network& network, const Alignment_tolerance& tolerance, Visitor& visitor, bool with_borders)
      : Base(tolerance, visitor, with_borders), network_(network) {}

  void operator()() {
    sorted_.reserve(network_.roads.size());
    for (const Road& road : network_.roads) {
      if (!roads_.emplace(road.id, sorted_.size()).second)
        remark(Kind::fault, &road, road.line, "road", "another road has the same id; links lead to that one");
      sorted_.emplace_back(road);
    }
    for (std::size_t i = 0; i < network_.junctions.size(); ++i) junctions_.emplace(network_.junctions[i].id, i);
    for (std::size_t i = 0; i < sorted_.size(); ++i) Base::operator()(network_.roads[i], sorted_[i]);
    for (const Road_junction& junction : network_.junctions)
      for (const Road_connection& connection : junction.connections) find_connected(junction, connection);
    for (std::size_t i = 0; i < sorted_.size(); ++i)
      for (const Road_end end : {Road_end::start, Road_end::end}) decide_link(i, end);
    for (const Road_junction& junction : network_.junctions)
      for (const Road_connection& connection : junction.connections) decide_connection(junction, connection);
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_ROAD_DECIDER_H
