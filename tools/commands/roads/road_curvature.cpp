// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/roads/road_curvature.h"

#include "commands/chains/plane_curvature.h"

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef GC::Road_number FT;
typedef GC::Bezier_curve<GC::Traits_2<CGAL::Simple_cartesian<FT>>> Cubic;

constexpr int parts_of_graph = 64, steps_of_bisection = 40;

// Returns the cubic with the coefficients of u and v, from the parameter 0 to the end of its range.
Cubic cubic(const std::vector<FT>& p, const FT& range) {
  std::vector<Cubic::Point> points;
  const auto control = [&](std::size_t k) -> std::vector<FT> {
    const FT b = p[k + 1] * range / 3, c = p[k + 2] * range * range / 3, d = p[k + 3] * range * range * range;
    return {p[k], FT(p[k] + b), FT(p[k] + 2 * b + c), FT(p[k] + 3 * b + 3 * c + d)};
  };
  const std::vector<FT> u = control(0), v = control(4);
  for (std::size_t i = 0; i < 4; ++i) points.emplace_back(u[i], v[i]);
  return Cubic(points.begin(), points.end(), FT(0), range);
}

// Returns bounds of the arc length of a graph v(u) from 0 to an end: from chords, and from the
// polygons of its parts.
GC::Enclosure length_of_graph(const std::vector<FT>& p, const FT& end) {
  double lower = 0, upper = 0;
  const auto polynomial = [&](const FT& u) -> FT { return p[4] + u * (p[5] + u * (p[6] + u * p[7])); };
  const auto slope = [&](const FT& u) -> FT { return p[5] + u * (2 * p[6] + u * 3 * p[7]); };
  const auto distance = [](const FT& x, const FT& y) { return GC::sqrt_enclosure(FT(x * x + y * y)); };
  const FT h = end / parts_of_graph;
  for (int i = 0; i < parts_of_graph; ++i) {
    const FT u = h * i, next = h * (i + 1), first = polynomial(u), last = polynomial(next), rise = slope(u) * h / 3,
             last_rise = slope(next) * h / 3;
    lower += distance(h, FT(last - first)).lower;
    upper += distance(FT(h / 3), rise).upper + distance(FT(h / 3), FT(last - first - rise - last_rise)).upper +
             distance(FT(h / 3), last_rise).upper;
  }
  constexpr double rounding = 1e-12; // of the sums
  return {lower * (1 - rounding), upper * (1 + rounding)};
}

// Returns bounds of the u where a graph has the length of its piece.
std::pair<FT, FT> end_of_graph(const std::vector<FT>& p, const FT& length) {
  const GC::Enclosure given = GC::enclosure(length);
  FT from = 0, to = length, certain = 0;
  for (int i = 0; i < steps_of_bisection; ++i) { // the largest u at which it is surely not longer
    const FT middle = (from + to) / 2;
    if (length_of_graph(p, middle).upper <= given.lower)
      from = certain = middle;
    else
      to = middle;
  }
  for (from = certain, to = length; to - from > length / 1000000;) { // the least at which it is longer
    const FT middle = (from + to) / 2;
    if (length_of_graph(p, middle).lower >= given.upper)
      to = middle;
    else
      from = middle;
  }
  return {certain, to};
}

} // namespace

Bend bend(const GC::Road_geometry& g, const Curvature_bound& given_bound) {
  const FT bound(given_bound.curvature);
  if (!GC::is_polynomial(g)) {
    const bool is_bent = g.shape != GC::Road_shape::line;
    const FT start = is_bent ? FT(CGAL::abs(g.parameters.front())) : FT(0),
             end = is_bent ? FT(CGAL::abs(g.parameters.back())) : FT(0), &largest = start < end ? end : start;
    return {largest <= bound ? Claim::met : Claim::not_met, GC::enclosure(largest),
            start == end  ? ""
            : start < end ? " at its end"
                          : " at its start"};
  }
  const bool is_graph = g.shape == GC::Road_shape::poly3;
  std::vector<FT> p = g.parameters;
  if (is_graph) p.insert(p.begin(), {FT(0), FT(1), FT(0), FT(0)});
  const FT range = is_graph || g.range == GC::Road_parameter_range::arc_length ? g.length : FT(1);
  if (!(FT(0) < range)) return {};
  std::optional<GC::Curvature_excess> excess = curvature_excess(cubic(p, range), given_bound);
  Claim claim = excess ? Claim::not_met : Claim::met;
  if (is_graph && excess) {
    const auto [certain, possible] = end_of_graph(p, range);
    if (const auto before = curvature_excess(cubic(p, certain), given_bound))
      excess = before;
    else if (const auto behind = curvature_excess(cubic(p, possible), given_bound)) {
      excess = behind;
      claim = Claim::undecided;
    } else
      return {};
  }
  if (!excess) return {};
  const GC::Enclosure& at = excess->parameter;
  return {claim, excess->unbounded ? std::nullopt : std::optional<GC::Enclosure>(size_of(*excess)),
          std::string(" at ") + (is_graph ? "u = " : "p = ") + rounded(at.lower / 2 + at.upper / 2, 6)};
}

std::string Bend::words(const Curvature_bound& bound, const char* unit) const {
  if (curvature) return "curvature " + road_words::size(*curvature, unit) + at;
  return claim == Claim::met ? bound.words : "curvature without a bound, as in a cusp," + at;
}

Road_claim decide_curvature(const GC::Road& road, const GC::Road_geometry& piece, const Curvature_bound& bound) {
  static constexpr const char* shapes[] = {"line", "arc", "spiral", "poly3", "paramPoly3"};
  const std::string shape = shapes[static_cast<int>(piece.shape)];
  const Bend found = bend(piece, bound);
  Road_claim claim;
  claim.kind = "bend";
  claim.road = road.id;
  claim.place = "road " + road.id + ", s = " + road_words::decimal(piece.s);
  claim.spot = "bend, s = " + road_words::decimal(piece.s);
  claim.line = piece.line;
  claim.rule = Finding_rule::bend;
  claim.given = {found.claim, "piece of a reference line",
                 found.claim == Claim::undecided ? "where it ends is not known well enough" : ""};
  claim.verdict = shape + ", " + found.words(bound, "/m");
  if (found.claim == Claim::not_met) {
    claim.fault = "not " + bound.words;
    if (found.curvature) claim.measure = Measure{"curvature", *found.curvature};
  }
  claim.json = "\"kind\":\"bend\",\"road\":" + json_text(road.id) + ",\"s\":" + road_words::decimal(piece.s) +
               ",\"shape\":\"" + shape + "\",\"curvature\":" + json_text(found.curvature);
  return claim;
}
