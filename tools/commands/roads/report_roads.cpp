// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/report_inputs.h"
#include "commands/roads/Road_claims.h"
#include "files/input.h"
#include "formats/opendrive/read_opendrive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

// The records of a profile in floating-point numbers.
class Drawn_profile {
  std::vector<std::array<double, 5>> records_;

public:
  explicit Drawn_profile(const std::vector<GC::Road_cubic>& records) {
    for (const GC::Road_cubic& r : records)
      records_.push_back({CGAL::to_double(r.s), CGAL::to_double(r.a), CGAL::to_double(r.b), CGAL::to_double(r.c),
                          CGAL::to_double(r.d)});
    std::stable_sort(records_.begin(), records_.end(), [](const auto& x, const auto& y) { return x[0] < y[0]; });
  }
  bool empty() const { return records_.empty(); }

  // The value at s, or the limit before it.
  double operator()(double s, bool before) const {
    const std::array<double, 5>* record = nullptr;
    for (const auto& r : records_)
      if (before ? r[0] < s || &r == &records_.front() : r[0] <= s) record = &r;
    if (record == nullptr || s < (*record)[0]) return 0;
    const double u = s - (*record)[0];
    return (*record)[1] + u * ((*record)[2] + u * ((*record)[3] + u * (*record)[4]));
  }
};

// Points along a reference line.
class Road_line {
  Report_roads::Road& road_;
  double x_ = 0, y_ = 0, heading_ = 0;

  void add(double s, double curvature) {
    // the s of a piece may lie before the end of the one before
    road_.s.push_back(road_.s.empty() ? s : (std::max)(s, road_.s.back()));
    road_.x.push_back(x_);
    road_.y.push_back(y_);
    road_.heading.push_back(heading_);
    road_.curvature.push_back(curvature);
  }

  // Goes on by a short way, by Simpson's rule.
  void go(double k0, double k1, double length) {
    const double middle = heading_ + length * (3 * k0 + k1) / 8, end = heading_ + length * (k0 + k1) / 2;
    x_ += length / 6 * (std::cos(heading_) + 4 * std::cos(middle) + std::cos(end));
    y_ += length / 6 * (std::sin(heading_) + 4 * std::sin(middle) + std::sin(end));
    heading_ = end;
  }

  void add_clothoid(const GC::Road_geometry& g, double s, double length, double spacing) {
    const bool is_bent = g.shape != GC::Road_shape::line;
    const double k0 = is_bent ? CGAL::to_double(g.parameters.front()) : 0,
                 k1 = is_bent ? CGAL::to_double(g.parameters.back()) : 0,
                 turn = (std::fabs(k0) + std::fabs(k1)) * length;
    const int n = pieces((std::max)(length / spacing, turn / 0.15));
    add(s, k0);
    for (int i = 0; i < n; ++i) {
      const auto curvature = [&](int j) { return k0 + (k1 - k0) * j / n; };
      go(curvature(i), curvature(i + 1), length / n);
      add(s + length * (i + 1) / n, curvature(i + 1));
    }
  }

  void add_polynomial(const GC::Road_geometry& g, double s, double length, double spacing) {
    const bool is_graph = g.shape == GC::Road_shape::poly3;
    std::array<double, 8> p{0, 1, 0, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < g.parameters.size(); ++i) p[is_graph ? i + 4 : i] = CGAL::to_double(g.parameters[i]);
    const double range = is_graph || g.range == GC::Road_parameter_range::arc_length ? length : 1, x = x_, y = y_,
                 heading = heading_, c = std::cos(heading), d = std::sin(heading);
    const int n = pieces((std::max)(length / spacing, 8.));
    for (int i = 0; i <= n; ++i) {
      const double t = range * i / n;
      const auto value = [&](std::size_t k) { return p[k] + t * (p[k + 1] + t * (p[k + 2] + t * p[k + 3])); };
      const auto first = [&](std::size_t k) { return p[k + 1] + t * (2 * p[k + 2] + t * 3 * p[k + 3]); };
      const auto second = [&](std::size_t k) { return 2 * p[k + 2] + t * 6 * p[k + 3]; };
      const double du = first(0), dv = first(4), speed = std::hypot(du, dv);
      x_ = x + value(0) * c - value(4) * d;
      y_ = y + value(0) * d + value(4) * c;
      heading_ = heading + (speed > 0 ? std::atan2(dv, du) : 0);
      add(s + length * i / n, speed > 0 ? (du * second(4) - dv * second(0)) / (speed * speed * speed) : 0);
    }
  }

  static int pieces(double n) {
    constexpr double most = 2000;
    return static_cast<int>(std::ceil((std::min)((std::max)(n, 1.), most)));
  }

public:
  Road_line(Report_roads::Road& road, const GC::Road& source, double spacing, double x, double y) : road_(road) {
    for (const GC::Road_geometry& g : source.plan) {
      x_ = CGAL::to_double(g.x) - x;
      y_ = CGAL::to_double(g.y) - y;
      heading_ = CGAL::to_double(g.heading);
      const double s = CGAL::to_double(g.s), length = CGAL::to_double(g.length);
      if (GC::is_polynomial(g))
        add_polynomial(g, s, length, spacing);
      else
        add_clothoid(g, s, length, spacing);
    }
  }
};

void add_lanes(Report_roads::Road& road, const GC::Road& source) {
  const Drawn_profile offset(source.lane_offset);
  for (std::size_t i = 0; i < source.sections.size(); ++i) {
    const GC::Road_section& section = source.sections[i];
    for (const int side : {1, -1}) {
      std::vector<const GC::Road_lane*> lanes;
      for (const GC::Road_lane& lane : section.lanes)
        if (lane.id * side > 0) lanes.push_back(&lane);
      if (lanes.empty()) continue;
      std::size_t next = i + 1;
      const auto has_side = [side](const GC::Road_section& s) {
        return !s.is_single_side || std::any_of(s.lanes.begin(), s.lanes.end(),
                                                [side](const GC::Road_lane& lane) { return lane.id * side > 0; });
      };
      while (next < source.sections.size() && !has_side(source.sections[next])) ++next;
      const double begin = CGAL::to_double(section.s),
                   end = CGAL::to_double(next < source.sections.size() ? source.sections[next].s : source.length);
      const std::size_t first =
          static_cast<std::size_t>(std::lower_bound(road.s.begin(), road.s.end(), begin - 1e-6) - road.s.begin());
      std::size_t last = first;
      while (last < road.s.size() && road.s[last] <= end + 1e-6) ++last;
      std::stable_sort(lanes.begin(), lanes.end(),
                       [side](const GC::Road_lane* x, const GC::Road_lane* y) { return x->id * side < y->id * side; });
      std::vector<double> inner;
      for (std::size_t k = first; k < last; ++k) inner.push_back(offset(road.s[k], road.s[k] > begin + 1e-6));
      for (const GC::Road_lane* const lane : lanes) {
        const bool is_border = lane->widths.empty() && !lane->borders.empty();
        const Drawn_profile profile(is_border ? lane->borders : lane->widths);
        std::vector<double> outer;
        for (std::size_t k = first; k < last; ++k) {
          const double t = profile((std::max)(0., road.s[k] - begin), road.s[k] > begin + 1e-6);
          outer.push_back(is_border ? t + offset(road.s[k], true) : inner[k - first] + side * t);
        }
        if (last - first > 1)
          road.lanes.push_back({lane->type == "driving" || lane->type.empty(), first, side > 0 ? outer : inner,
                                side > 0 ? inner : outer});
        inner = std::move(outer);
      }
    }
  }
}

// Adds places where lane sections start, so that lanes end there.
void add_places(Report_roads::Road& road, const GC::Road& source) {
  for (const GC::Road_section& section : source.sections) {
    const double s = CGAL::to_double(section.s);
    const auto found = std::lower_bound(road.s.begin(), road.s.end(), s);
    if (found == road.s.begin() || found == road.s.end() || *found - s < 1e-6) continue;
    const std::ptrdiff_t i = found - road.s.begin();
    const std::size_t n = static_cast<std::size_t>(i);
    const double part = (s - road.s[n - 1]) / (road.s[n] - road.s[n - 1]);
    if (!(part > 0 && part < 1)) continue;
    for (std::vector<double>* const values : {&road.x, &road.y, &road.heading, &road.curvature})
      values->insert(values->begin() + i, (*values)[n - 1] + part * ((*values)[n] - (*values)[n - 1]));
    road.s.insert(road.s.begin() + i, s);
  }
}

class Roads_page {
  const Road_claims claims_;
  Report_page& page_;
  const bool several_;
  std::string file_;
  std::size_t first_road_ = 0, met_ = 0, files_ = 0;
  const GC::Road_network* network_ = nullptr;

  Report_roads& roads() { return *page_.roads; }

  void draw(const GC::Road_network& network) {
    double length = 0;
    for (const GC::Road& road : network.roads) length += CGAL::to_double(road.length);
    const double spacing = (std::max)(5., length / 20000);
    for (const GC::Road& source : network.roads) {
      if (roads().roads.empty() && !source.plan.empty() && roads().x == 0 && roads().y == 0) {
        roads().x = std::nearbyint(CGAL::to_double(source.plan[0].x));
        roads().y = std::nearbyint(CGAL::to_double(source.plan[0].y));
      }
      roads().roads.push_back({source.id, {}, {}, {}, {}, {}, {}, {}});
      Report_roads::Road& road = roads().roads.back();
      Road_line(road, source, spacing, roads().x, roads().y);
      add_places(road, source);
      add_lanes(road, source);
      const Drawn_profile elevation(source.elevation);
      for (const double s : road.s) road.elevation.push_back(elevation(s, false));
      for (std::size_t i = 0; i < road.x.size(); ++i) page_.include({road.x[i], road.y[i]});
    }
  }

  Report_road_place place(const GC::Road& road, double s) const {
    const std::size_t number = first_road_ + static_cast<std::size_t>(&road - network_->roads.data());
    const Report_roads::Road& drawn = page_.roads->roads[number];
    if (drawn.s.empty()) return {number, s, 0, 0};
    std::size_t i = static_cast<std::size_t>(std::lower_bound(drawn.s.begin(), drawn.s.end(), s) - drawn.s.begin());
    i = (std::min)(i, drawn.s.size() - 1);
    if (i == 0 || !(drawn.s[i] > drawn.s[i - 1])) return {number, s, drawn.x[i], drawn.y[i]};
    const double part = (std::max)(0., (std::min)(1., (s - drawn.s[i - 1]) / (drawn.s[i] - drawn.s[i - 1])));
    return {number, s, drawn.x[i - 1] + part * (drawn.x[i] - drawn.x[i - 1]),
            drawn.y[i - 1] + part * (drawn.y[i] - drawn.y[i - 1])};
  }

  template <class Join> Report_road_place place_of(const Join& x) const {
    if constexpr (std::is_same_v<Join, GC::Road_plan_join>)
      return place(x.road, CGAL::to_double(x.after.s));
    else if constexpr (std::is_same_v<Join, GC::Road_length_check>)
      return place(x.road, CGAL::to_double(x.geometry.s));
    else if constexpr (std::is_same_v<Join, GC::Road_profile_join> || std::is_same_v<Join, GC::Road_section_join>)
      return place(x.road, CGAL::to_double(x.s));
    else {
      const GC::Road& road = *x.from.road;
      if (x.from.at) return place(road, CGAL::to_double(*x.from.at));
      return place(road, x.from.end == GC::Road_end::start ? 0 : CGAL::to_double(road.length));
    }
  }

  static Report_grade grade(const Road_claim& claim, bool is_plan) {
    if (claim.given.claim == Claim::undecided) return Report_grade::undecided;
    if (claim.given.claim == Claim::not_met)
      return claim.rule == Finding_rule::kink ? Report_grade::kink : Report_grade::gap;
    return is_plan && claim.verdict.compare(0, 2, "G1") == 0 ? Report_grade::g1 : Report_grade::g2;
  }

public:
  Roads_page(const Report_demand& demand, Report_page& page, bool several)
      : claims_(demand.roads), page_(page), several_(several) {
    page_.roads.emplace(Report_roads{0, 0, {}});
  }

  void read(const std::string& file) {
    file_ = input_name(file);
    const Opendrive_file opendrive = read_opendrive(file);
    network_ = &opendrive.network;
    first_road_ = roads().roads.size();
    ++files_;
    draw(opendrive.network);
    GC::road_joins(opendrive.network, claims_.tolerance(), *this);
  }

  void operator()(const GC::Road_remark& x) {
    if (x.kind == GC::Road_remark::Kind::note) return;
    page_.leave_out(x.what.c_str(), x.reason, (several_ ? file_ + ": " : "") + remark_place(x) + ": " + x.reason);
  }

  template <class Join> void operator()(const Join& x) {
    constexpr bool is_plan = std::is_same_v<Join, GC::Road_plan_join>;
    const Road_claim claim = claims_(x);
    const std::string place = (several_ ? file_ + ": " : "") + claim.place;
    if (claim.given.claim == Claim::not_covered)
      return page_.leave_out(claim.given.noun, claim.given.reason, place + ": " + claim.verdict);
    if (!is_plan && claim.given.claim == Claim::met) {
      ++met_;
      return;
    }
    Report_item item;
    item.grade = grade(claim, is_plan);
    const auto upper = [](const std::optional<GC::Enclosure>& e) { return e ? e->upper : 0; };
    item.severity = item.grade == Report_grade::gap    ? upper(claim.gap)
                    : item.grade == Report_grade::kink ? upper(claim.kink)
                                                       : upper(claim.jump);
    if (!page_.count(item.grade, item.severity, claim.given.reason)) return;
    item.number = page_.total();
    item.place = place;
    item.verdict = claim.kind + ' ' + claim.verdict;
    if (claim.line > 0) item.marks.push_back("line " + std::to_string(claim.line));
    item.gap = claim.gap;
    if (claim.kink) item.angle = GC::in_degrees(*claim.kink);
    item.road_place = place_of(x);
    page_.add(std::move(item));
  }

  void finish() {
    page_.summary = counted(page_.total(), "join") + " shown of " + counted(roads().roads.size(), "road") + "; " +
                    counted(met_, "join") + " of profiles, lanes and links are as demanded";
    page_.empty = "There is no join of reference lines, and nothing is wrong with lanes and profiles.";
    page_.finish();
  }
};

} // namespace

void report_roads(const Arguments& files, const Report_demand& demand, Report_page& page) {
  Roads_page roads(demand, page, files.size() > 1);
  for (const std::string& file : files) roads.read(file);
  roads.finish();
}
