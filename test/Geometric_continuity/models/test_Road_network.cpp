// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/test.h"

#include <CGAL/Geometric_continuity/models/Road_network.h>

// Road networks that are made here: each test has what is found of one kind of join.

namespace {

typedef GC::Road_number Number;

Number part(int n, int d) { return Number(Number(n) / Number(d)); }

// All that is found, in the order in which it comes.
struct Found {
  std::shared_ptr<const GC::Road_network> network; // to which the rest refers
  std::vector<GC::Road_plan_join> plan;
  std::vector<GC::Road_length_check> lengths;
  std::vector<GC::Road_profile_join> profiles;
  std::vector<GC::Road_section_join> sections;
  std::vector<GC::Road_link_join> links;
  std::vector<GC::Road_lane_join> lanes;
  std::vector<GC::Road_border_join> borders;
  std::vector<GC::Road_remark> remarks;

  void operator()(const GC::Road_plan_join& x) { plan.push_back(x); }
  void operator()(const GC::Road_length_check& x) { lengths.push_back(x); }
  void operator()(const GC::Road_profile_join& x) { profiles.push_back(x); }
  void operator()(const GC::Road_section_join& x) { sections.push_back(x); }
  void operator()(const GC::Road_link_join& x) { links.push_back(x); }
  void operator()(const GC::Road_lane_join& x) { lanes.push_back(x); }
  void operator()(const GC::Road_border_join& x) { borders.push_back(x); }
  void operator()(const GC::Road_remark& x) { remarks.push_back(x); }
};

Found found(const GC::Road_network& network, bool with_borders = false) {
  Found result;
  result.network = std::make_shared<const GC::Road_network>(network);
  GC::road_joins(*result.network, {}, result, with_borders);
  return result;
}

GC::Road_geometry piece(int s, const Number& x, const Number& y, const Number& heading, int length,
                        const Number& curvature = Number(0)) {
  GC::Road_geometry g;
  g.shape = GC::Road_shape::arc;
  g.s = Number(s);
  g.x = x;
  g.y = y;
  g.heading = heading;
  g.length = Number(length);
  g.parameters = {curvature};
  return g;
}

GC::Road_cubic cubic(const Number& s, const Number& a, const Number& b = Number(0), const Number& c = Number(0),
                     const Number& d = Number(0)) {
  return {s, a, b, c, d};
}

GC::Road_lane lane(int id, const std::vector<GC::Road_cubic>& widths, const std::vector<int>& predecessors,
                   const std::vector<int>& successors) {
  GC::Road_lane l;
  l.id = id;
  l.widths = widths;
  l.predecessors = predecessors;
  l.successors = successors;
  return l;
}

GC::Road road(const std::string& id, const std::vector<GC::Road_geometry>& plan) {
  GC::Road r;
  r.id = id;
  r.plan = plan;
  for (const GC::Road_geometry& g : plan) r.length = Number(r.length + g.length);
  return r;
}

GC::Road_link link(const std::string& id, GC::Road_end contact) {
  GC::Road_link l;
  l.target = GC::Road_link::Target::road;
  l.id = id;
  l.contact = contact;
  return l;
}

} // namespace

// Limits before and behind a start, of records that are not in their order; two at one place; one
// behind the end; a value before the first one.
BOOST_AUTO_TEST_CASE(profiles) {
  GC::Road r = road("1", {piece(0, 0, 0, 0, 40)});
  r.elevation = {cubic(20, 7), cubic(10, 2, 1, 1, 1), cubic(10, 5, 1, 1, 1), cubic(50, 0)};
  const Found f = found({{r}, {}});
  BOOST_REQUIRE_EQUAL(f.profiles.size(), 2u);
  BOOST_CHECK(f.profiles[0].s == Number(10) && f.profiles[0].jump.value == Number(5)); // the later one, from 0
  BOOST_CHECK(f.profiles[1].s == Number(20));
  BOOST_CHECK(f.profiles[1].jump.value == Number(7 - (5 + 10 + 100 + 1000)));
  BOOST_CHECK(f.profiles[1].jump.slope == Number(-(1 + 20 + 300)) && f.profiles[1].jump.second == Number(-(2 + 60)));
  BOOST_CHECK(!f.profiles[1].equal[0] && !f.profiles[1].within[0]);
  BOOST_CHECK_EQUAL(f.remarks.size(), 3u); // unsorted, twice at 10, behind the end
}

// A width that becomes negative only inside of its record: (u - 1)^2 - 1/100.
BOOST_AUTO_TEST_CASE(negative_widths) {
  GC::Road r = road("1", {piece(0, 0, 0, 0, 2)});
  for (const Number& a : {part(99, 100), Number(1)}) {
    r.sections = {{Number(0), {lane(1, {cubic(0, a, -2, 1)}, {}, {})}}};
    const Found f = found({{r}, {}});
    BOOST_CHECK_EQUAL(f.remarks.size(), a == Number(1) ? 0u : 1u);
  }
}

// Three lanes pass into two: those at the rims meet at the rims; a lane that is named by the second
// one only; sections of one side that start elsewhere.
BOOST_AUTO_TEST_CASE(lanes_across_sections) {
  GC::Road r = road("1", {piece(0, 0, 0, 0, 40)});
  const auto width = [](int w) { return std::vector<GC::Road_cubic>{cubic(0, w)}; };
  r.sections = {{Number(0),
                 {lane(1, width(3), {}, {1}), lane(2, width(3), {}, {1}), lane(3, width(4), {}, {2}),
                  lane(-1, width(2), {}, {})}},
                {Number(20), {lane(1, width(6), {}, {}), lane(2, width(5), {}, {}), lane(-1, width(3), {-1}, {})}}};
  const Found f = found({{r}, {}});
  BOOST_REQUIRE_EQUAL(f.sections.size(), 4u);
  BOOST_CHECK(f.sections[0].lane.id == 1 && !f.sections[0].left && f.sections[0].right && f.sections[0].equal);
  BOOST_CHECK(f.sections[1].lane.id == 2 && f.sections[1].left && !f.sections[1].right && f.sections[1].equal);
  BOOST_CHECK(f.sections[2].lane.id == 3 && f.sections[2].jump() == Number(1) && !f.sections[2].within);
  BOOST_CHECK(f.sections[3].lane.id == -1 && f.sections[3].is_named_back && *f.sections[3].right == Number(-1));

  r.sections = {{Number(0), {lane(1, width(3), {}, {1})}, true},
                {Number(0), {lane(-1, width(2), {}, {-1})}, true},
                {Number(10), {lane(-1, {cubic(0, 2)}, {-1}, {})}, true},
                {Number(30), {lane(1, {cubic(0, 4)}, {1}, {})}, true}};
  const Found sides = found({{r}, {}});
  BOOST_REQUIRE_EQUAL(sides.sections.size(), 2u);
  BOOST_CHECK(sides.sections[0].s == Number(30) && sides.sections[0].jump() == Number(1));
  BOOST_CHECK(sides.sections[1].s == Number(10) && sides.sections[1].equal);
}

// Borders that are given in place of widths, and level lanes outside of a banked one.
BOOST_AUTO_TEST_CASE(borders_and_level_lanes) {
  GC::Road a = road("a", {piece(0, 0, 0, 0, 10)}), b = road("b", {piece(0, 10, 0, 0, 10)});
  GC::Road_lane border = lane(1, {}, {}, {1}), level = lane(2, {cubic(0, 2)}, {}, {2});
  border.borders = {cubic(0, 3)};
  level.is_level = true;
  a.lane_offset = {cubic(0, 1)};
  a.superelevation = {cubic(0, part(1, 5))};
  a.sections = {{Number(0), {border, level}}};
  a.successor = link("b", GC::Road_end::start);
  b.predecessor = link("a", GC::Road_end::end);
  b.superelevation = a.superelevation;
  b.sections = {{Number(0), {lane(1, {cubic(0, 4)}, {1}, {}), lane(2, {cubic(0, 2)}, {2}, {})}}};
  const Found f = found({{a, b}, {}});
  BOOST_REQUIRE(f.links.size() == 1 && f.lanes.size() == 2);
  BOOST_CHECK(f.links[0].is_returned && f.links[0].has_lanes && f.links[0].join.same_point);
  // offset 1 and border 3 are 4 to the left, as the width 4 of b without an offset; inside it is 1
  // and 0
  BOOST_CHECK(f.lanes[0].gaps[0].upper < 1e-12 && f.lanes[0].within == GC::Verdict::refuted);
  // 2 (1 - cos 0.2) in the plane and 2 sin 0.2 in height, where b is not level
  BOOST_CHECK(f.lanes[1].gaps[0].lower <= 0.039866844317516 && 0.039866844317516 <= f.lanes[1].gaps[0].upper + 1e-15);
  BOOST_CHECK(f.lanes[1].steps[0].lower <= 0.397338661590122 + 1e-15 &&
              0.397338661590122 <= f.lanes[1].steps[0].upper + 1e-15);
  BOOST_CHECK(*f.lanes[1].within_height == GC::Verdict::refuted);
}

// Two roads that start at one point in opposite directions: the headings differ by pi, the
// curvatures by their sign, and the left of the one is the right of the other.
BOOST_AUTO_TEST_CASE(start_to_start) {
  GC::Road a = road("a", {piece(0, 0, 0, 0, 10, part(1, 50))}),
           b = road("b", {piece(0, 0, 0, GC::Road_number(part(355, 113)), 10, part(-1, 50))});
  const std::vector<GC::Road_cubic> width{cubic(0, 3)};
  a.sections = {{Number(0), {lane(1, width, {-1}, {}), lane(2, width, {-1}, {})}}};
  b.sections = {{Number(0), {lane(-1, {cubic(0, 6)}, {1, 2}, {})}}};
  a.predecessor = link("b", GC::Road_end::start);
  b.predecessor = link("a", GC::Road_end::start);
  const Found f = found({{a, b}, {}}, true);
  BOOST_REQUIRE(f.links.size() == 1 && f.lanes.size() == 2 && f.borders.size() == 2);
  for (const GC::Road_border_join& x : f.borders) // seen in the direction of a: 0 and 6 to the left
    BOOST_CHECK(x.join.same_curvature && *x.join.order() == 2);
  BOOST_CHECK(f.links[0].join.same_curvature && f.links[0].join.order() == 2);
  BOOST_CHECK(f.links[0].join.kink.lower < 2.667642e-7 && 2.667641e-7 < f.links[0].join.kink.upper); // 355/113 - pi
  for (const GC::Road_lane_join& x : f.lanes) {
    BOOST_CHECK_EQUAL(x.gaps.size(), 1u);
    BOOST_CHECK(x.within == GC::Verdict::proved);
  }
}

// Asks if an enclosure has a number in it.
bool has(const GC::Enclosure& x, double y) {
  return x.lower <= y * (1 + 1e-14) && y * (1 - 1e-14) <= x.upper && x.upper - x.lower < 1e-12;
}

// Asks if a border is the reference line.
bool border_at_centre(const GC::Road_border_join& x) { return x.lane.id > 0 ? !x.is_left : x.is_left; }

// The borders of lanes as curves: behind a line with t = 2, t' = 1/10 an arc, a clothoid and a
// cubic with their curvatures k and rates k', where P' = (1 - k t, t') and the curvature is
// ((1 - k t) (k (1 - k t)) + t' (k' t + 2 k t')) / |P'|^3.
BOOST_AUTO_TEST_CASE(borders_as_curves) {
  GC::Road_geometry arc = piece(10, 10, 0, 0, 10, part(1, 10)), spiral = arc, cubic3 = arc;
  spiral.shape = GC::Road_shape::spiral;
  spiral.parameters = {Number(0), part(1, 10)};
  cubic3.shape = GC::Road_shape::param_poly3;
  cubic3.parameters = {0, 10, 1, 0, 0, 0, 1, 1};
  const struct {
    GC::Road_geometry next;
    double kink, jump;
  } rows[] = {{arc, std::atan(0.125) - std::atan(0.1), (0.8 * 0.08 + 0.1 * 0.02) / std::pow(0.65, 1.5)},
              {spiral, 0, 0.1 * 0.02 / std::pow(1.01, 1.5)},
              {cubic3, std::atan(0.1 / 0.96) - std::atan(0.1),
               (0.96 * 0.02 * 0.96 + 0.1 * (0.0048 * 2 + 2 * 0.02 * 0.1)) / std::pow(0.9316, 1.5)}};
  for (const auto& row : rows) {
    GC::Road r = road("1", {piece(0, 0, 0, 0, 10), row.next});
    r.sections = {{Number(0), {lane(1, {cubic(0, 1, part(1, 10))}, {}, {})}}};
    BOOST_CHECK(found({{r}, {}}).borders.empty());
    const Found f = found({{r}, {}}, true);
    BOOST_REQUIRE_EQUAL(f.borders.size(), 2u); // the outer one, and the reference line
    BOOST_CHECK(f.borders[0].is_left && !f.borders[1].is_left && f.remarks.empty());
    BOOST_CHECK(f.borders[0].join.same_point && f.borders[0].join.g0 == GC::Verdict::proved);
    BOOST_CHECK(has(f.borders[0].join.kink, row.kink) && has(*f.borders[0].join.jump, row.jump));
    BOOST_CHECK(f.borders[0].join.same_heading == (row.kink == 0) && f.borders[1].join.same_heading);
    r.sections[0].lanes[0].widths = {cubic(0, 10)}; // as far away as the centre of the arc
    const Found folded = found({{r}, {}}, true);
    BOOST_CHECK_EQUAL(folded.remarks.size(), row.next.shape == GC::Road_shape::arc ? 1u : 0u);
    BOOST_CHECK_EQUAL(folded.borders.size(), row.next.shape == GC::Road_shape::arc ? 1u : 2u);
  }
}

// Inside of an arc and of a cubic: a width that starts to grow is a kink of both sides of the lane
// that lies outside of it, and of no other border; lanes that pass into others; a curvature that is
// a root.
BOOST_AUTO_TEST_CASE(borders_of_several_lanes) {
  GC::Road r = road("1", {piece(0, 0, 0, 0, 40, part(1, 100))});
  r.sections = {{Number(0),
                 {lane(1, {cubic(0, 3), cubic(10, 3, part(1, 4))}, {}, {2}), lane(2, {cubic(0, 4)}, {}, {3}),
                  lane(-1, {cubic(0, 3)}, {}, {-1})}},
                {Number(20),
                 {lane(1, {cubic(0, 1)}, {}, {}), lane(2, {cubic(0, part(9, 2), part(1, 4))}, {1}, {}),
                  lane(3, {cubic(0, 4)}, {2}, {}), lane(-1, {cubic(0, 3, 0, part(1, 10))}, {-1}, {})}}};
  const Found f = found({{r}, {}}, true);
  BOOST_REQUIRE_EQUAL(f.borders.size(), 2u + 1u + 1u);
  for (int i : {0, 1}) {
    BOOST_CHECK(f.borders[i].from.at == Number(10) && f.borders[i].lane.id == i + 1 && f.borders[i].is_left);
    BOOST_CHECK(has(f.borders[i].join.kink, std::atan(0.25 / (i == 0 ? 0.97 : 0.93))) &&
                *f.borders[i].join.order() == 0);
  }
  // those of lane 1 are 0 and 5.5 to the left at 20, those of lane 2 behind it 1 and 5.5, as smooth
  BOOST_CHECK(f.borders[3].lane.id == 1 && f.borders[3].to_lane.id == 2 && !f.borders[3].is_left);
  BOOST_CHECK(has(f.borders[3].join.gap, 1) && f.borders[3].join.g0 == GC::Verdict::refuted);
  BOOST_CHECK(f.borders[2].lane.id == -1 && *f.borders[2].join.order() == 1 && f.borders[2].join.same_heading);
  BOOST_CHECK(has(*f.borders[2].join.jump, 0.2 / (1.03 * 1.03)));

  // at the end of a cubic whose curvature is a root there, with t' = 0: a direction, no curvature
  GC::Road_geometry bow = piece(0, 0, 0, 0, 10), after = piece(10, 10, 1, 0, 10);
  bow.shape = GC::Road_shape::param_poly3;
  bow.parameters = {0, 10, 0, 0, 0, 0, 1, 0};
  GC::Road root = road("2", {bow, after});
  root.sections = {{Number(0), {lane(1, {cubic(0, 3)}, {}, {}), lane(-1, {cubic(0, 1000)}, {}, {})}}};
  const Found at_root = found({{root}, {}}, true);
  BOOST_REQUIRE_EQUAL(at_root.borders.size(), 3u);
  for (const GC::Road_border_join& x : at_root.borders)
    BOOST_CHECK(has(x.join.kink, std::atan(0.2)) && x.join.jump.has_value() == (border_at_centre(x)));
  root.sections[0].lanes[0].widths = {cubic(0, 60)}; // 1 / k = 53.03
  BOOST_CHECK_EQUAL(found({{root}, {}}, true).borders.size(), 2u);

  r.plan[0].shape = GC::Road_shape::param_poly3;
  r.plan[0].parameters = {0, 40, 0, 0, 0, 0, 1, 0};
  const Found cubic_road = found({{r}, {}}, true);
  std::size_t open = 0;
  for (const GC::Road_remark& x : cubic_road.remarks) open += x.kind == GC::Road_remark::Kind::not_covered;
  BOOST_CHECK(cubic_road.borders.empty() && open == 4);
}

// A road that branches off from each place of another one, in its direction: the piece before this
// place, and of each side the section that holds there.
BOOST_AUTO_TEST_CASE(places_inside_of_a_road) {
  GC::Road a = road("a", {piece(0, 0, 0, 0, 10), piece(10, 10, 0, 0, 10, part(1, 100)), piece(20, 0, 0, 0, 10, 2)});
  const auto width = [](int w) { return std::vector<GC::Road_cubic>{cubic(0, w)}; };
  a.sections = {{Number(0), {lane(1, width(3), {}, {})}, true},
                {Number(10), {lane(-1, width(2), {}, {})}, true},
                {Number(20), {lane(1, width(5), {}, {})}, true}};
  GC::Road b = road("b", {piece(0, 0, 0, 0, 10)});
  b.sections = {{Number(0), {lane(1, width(4), {1}, {}), lane(-1, width(2), {-1}, {})}}};
  b.predecessor = link("a", GC::Road_end::end);
  const struct {
    int at;
    double curvature, left; // the width of the lane on the left
  } rows[] = {{5, 0, 3}, {10, 0, 3}, {15, 0.01, 3}, {20, 0.01, 3}, {25, 2, 5}, {30, 2, 5}};
  for (const auto& row : rows) {
    b.predecessor.at = Number(row.at);
    const Found f = found({{a, b}, {}});
    BOOST_REQUIRE(f.links.size() == 1 && f.lanes.size() == 2);
    BOOST_CHECK(has(*f.links[0].join.jump, row.curvature));
    BOOST_CHECK(*f.links[0].to.at == Number(row.at) && f.lanes[1].to_lane.widths[0].a == Number(row.left));
  }
}

// Links and connections that lead nowhere are named, each once.
BOOST_AUTO_TEST_CASE(faults) {
  GC::Road a = road("a", {piece(0, 0, 0, 0, 10)});
  a.successor = link("x", GC::Road_end::start);
  a.predecessor.target = GC::Road_link::Target::junction;
  a.predecessor.id = "none";
  GC::Road_junction j;
  j.id = "j";
  j.connections.resize(3);
  j.connections[0].incoming = "x";
  j.connections[1].incoming = j.connections[1].connecting = j.connections[2].incoming = j.connections[2].connecting =
      "a";
  j.connections[2].contact = GC::Road_end::start;
  const Found f = found({{a, road("b", {}), a}, {j}});
  std::size_t faults = 0;
  for (const GC::Road_remark& x : f.remarks) faults += x.kind == GC::Road_remark::Kind::fault;
  BOOST_CHECK_EQUAL(faults, 2u * 2 + 1 + 1 + 3); // links of both a, no geometry, an id twice, connections
  BOOST_CHECK(f.links.empty() && f.lanes.empty());
}
