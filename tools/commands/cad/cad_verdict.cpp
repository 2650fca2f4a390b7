// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/Cad_verdict.h"

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace {

// A step of work is about a multiplication of machine words, see `Work_limit`; a part of an edge
// takes so many.
constexpr std::uint64_t steps_of_box = 4000;

// So many ranges of an edge about which nothing is known are looked at for poles, and an edge is
// taken to pass so many.
constexpr std::size_t most_poles = 16;

// An angle may be smaller than that of a corner by this relative amount, and a curvature larger
// than its bound, because the numbers in files are rounded.
constexpr double rounded_number = 1e-9;

// Returns the precision of enclosures for which the work suffices.
GC::Edge_precision precision_of_work() {
  GC::Edge_precision precision;
  const std::uint64_t boxes = (std::max)(GC::Work_scope::limit_of_each().steps() / steps_of_box, std::uint64_t(1));
  precision.most_boxes = static_cast<int>((std::min)(boxes, std::uint64_t(1'000'000)));
  precision.boxes = (std::min)(precision.boxes, precision.most_boxes);
  return precision;
}

GC::Bound times(const GC::Bound& x, double factor) { return GC::Enclosure{x.lower() * factor, x.upper() * factor}; }

// One edge, with the curves in the parameter planes that it has or that are computed for it.
class Edge_decision {
  const Cad_edge& edge_;
  const Cad_demand& demand_;
  std::array<GC::Edge_side, 2> sides_;
  std::array<bool, 2> is_projected_;
  GC::Edge_precision precision_ = precision_of_work();
  typedef std::vector<std::pair<double, double>> Ranges;
  Ranges parts_; // of the edge, those that belong to no pole

  static GC::Verdict within(const std::optional<GC::Edge_maximum>& x, const GC::Bound& bound,
                            const Ranges& unresolved) {
    return x ? GC::at_most(x->value, bound) && (unresolved.empty() ? GC::Verdict::proved : GC::Verdict::undecided)
             : GC::Verdict::undecided;
  }

  bool has_projections() const { return edge_.space && (is_projected_[0] || is_projected_[1]); }

  // Returns whether a measure of foot points is proved to be larger than a bound at a parameter, or
  // beside it: at knots of surfaces nothing is proved.
  template <class Measure>
  bool exceeds_at_feet(double t, const std::array<bool, 2>& is_projected, const GC::Bound& bound,
                       Measure measure) const {
    for (double distance : {0., 0x1p-12, -0x1p-12, 0x1p-6, -0x1p-6}) {
      const double at = t + distance * (edge_.end - edge_.begin);
      if (!(edge_.begin <= at && at <= edge_.end)) continue;
      const std::optional<GC::Foot_comparison> f =
          GC::compare_at_feet(sides_[0], sides_[1], is_projected, *edge_.space, at, precision_.flat_curvature);
      if (f && measure(*f) > bound.upper()) return true;
    }
    return false;
  }

  // A lower bound that is refuted may be an error of projections, unless it is refuted for the foot
  // points as well.
  void doubt(Cad_verdict& result, std::size_t order, const GC::Edge_maximum& worst, const GC::Bound& bound,
             double GC::Foot_comparison::*measure) const {
    if (result.within[order] != GC::Verdict::refuted || !has_projections()) return;
    const auto measured = [measure](const GC::Foot_comparison& f) { return f.*measure; };
    if (exceeds_at_feet(worst.parameter, is_projected_, bound, measured)) return;
    result.within[order] = GC::Verdict::undecided;
    // otherwise nobody asks
    result.in_doubt = result.in_doubt || static_cast<int>(order) <= demand_.most;
  }

  // Returns whether the distance of the second side is bounded by that of the first one and the gap
  // as well as is needed. Then the bound holds for both.
  bool bounds_second_side(Cad_verdict& result) const {
    if (edge_.kind == Cad_edge_kind::degenerate) return true; // twice the same
    if (has_projections()) return false;                      // it is told
    double& upper = result.deviation->value.upper;
    // whatever the rounding
    const double both = (upper + result.enclosure->gap.value.upper) * (1 + 0x1p-40);
    if (!(both <= demand_.bounds.gap.lower())) return false;
    upper = both;
    return true;
  }

  // Compares the curve in space with both sides.
  void compare_curve(Cad_verdict& result) const {
    GC::Edge_precision precision = precision_;
    if (!has_projections()) precision.gap = (std::max)(precision.gap, demand_.bounds.gap.lower() / 4);
    std::size_t farther = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (i == 1 && bounds_second_side(result)) break;
      const GC::Edge_maximum d = GC::curve_deviation(sides_[i], *edge_.space, edge_.begin, edge_.end, precision);
      if (result.deviation && d.value.upper <= result.deviation->value.upper) continue;
      result.deviation = d;
      farther = i;
    }
    GC::Verdict is_near = GC::at_most(result.deviation->value, demand_.bounds.gap);
    const auto distance = [farther](const GC::Foot_comparison& f) { return f.distances[farther]; };
    if (edge_.kind != Cad_edge_kind::degenerate && is_near == GC::Verdict::refuted &&
        !exceeds_at_feet(result.deviation->parameter, {true, true}, demand_.bounds.gap, distance))
      is_near = GC::Verdict::undecided;
    if (is_near == GC::Verdict::undecided && !std::isfinite(result.deviation->value.upper))
      result.is_exhausted = true;
    else
      result.in_doubt = result.in_doubt || is_near == GC::Verdict::undecided;
    result.within[0] = result.within[0] && is_near;
  }

  void decide_shape(Cad_verdict& result) const {
    const GC::Edge_enclosure& e = *result.enclosure;
    const GC::Verdict is_smooth = result.within[0] == GC::Verdict::proved
                                      ? result.within[1]
                                      : within(e.angle, demand_.bounds.tangent_angle, e.unresolved);
    if (result.within[0] == GC::Verdict::refuted)
      result.shape = Cad_shape::gap;
    else if (edge_.inside_out)
      result.shape = Cad_shape::inside_out;
    else if (is_smooth == GC::Verdict::proved)
      result.shape = Cad_shape::smooth;
    if (result.shape != Cad_shape::undecided || is_smooth != GC::Verdict::refuted || result.in_doubt) return;
    const GC::Bound least = times(demand_.kink, 1 - rounded_number);
    static const GC::Enclosure straight = GC::in_radians(180);
    const GC::Bound folded = GC::Enclosure{straight.lower - demand_.bounds.tangent_angle.upper(),
                                           straight.upper - demand_.bounds.tangent_angle.lower()};
    const GC::Verdict is_open = within(e.angle, folded, e.unresolved), is_kink = within(e.angle, least, e.unresolved);
    result.shape = Cad_shape::bent;
    if (is_open == GC::Verdict::refuted) result.shape = Cad_shape::fold;
    // in a face nothing is meant
    else if (is_kink == GC::Verdict::proved || edge_.kind == Cad_edge_kind::knot_line)
      result.shape = Cad_shape::kink;
    else {
      result.is_corner = GC::Verdict::proved;
      for (const auto& [begin, end] : parts_)
        result.is_corner = result.is_corner && GC::is_sharp_edge(sides_[0], sides_[1], begin, end, least, precision_);
      // undecided when it may be a fold
      if (result.is_corner == GC::Verdict::proved) result.is_corner = is_open;
      if (result.is_corner == GC::Verdict::proved)
        result.shape = Cad_shape::corner;
      else if (result.is_corner == GC::Verdict::refuted && is_kink == GC::Verdict::refuted)
        result.shape = Cad_shape::fading_corner;
    }
  }

  // Decides what depends on normals, of which the enclosure tells. \pre that of the gap is decided
  void decide_normals(Cad_verdict& result) const {
    const GC::Edge_enclosure& e = *result.enclosure;
    result.is_exhausted = result.is_exhausted || e.exhausted;
    result.within[1] = within(e.angle, demand_.bounds.tangent_angle, e.unresolved);
    if (e.angle) doubt(result, 1, *e.angle, demand_.bounds.tangent_angle, &GC::Foot_comparison::angle);
    result.within[2] = within(e.curvature_jump, demand_.bounds.curvature_jump, e.curvature_unresolved);
    if (e.curvature_jump)
      doubt(result, 2, *e.curvature_jump, demand_.bounds.curvature_jump, &GC::Foot_comparison::curvature_jump);
    for (int i = 0; i <= result.exact.value_or(-1); ++i)
      result.within[static_cast<std::size_t>(i)] = GC::Verdict::proved;
    result.within[1] = result.within[0] && result.within[1];
    result.within[2] = result.within[1] && result.within[2];
    if (edge_.inside_out) {
      result.within[1] = result.within[2] = GC::Verdict::refuted;
      if (result.exact) result.exact = (std::min)(*result.exact, 0);
    }
    decide_shape(result);
  }

  // Returns whether nothing that is asked for depends on what is next to a pole.
  bool is_settled(const Cad_verdict& result) const {
    const std::size_t asked = demand_.most > 1 ? 2 : 1;
    return result.within[asked] == GC::Verdict::proved || result.within[0] == GC::Verdict::refuted ||
           edge_.inside_out || (asked == 1 && result.shape == Cad_shape::corner);
  }

  // Adds the ranges that belong to poles: at the ends of the edge, where nothing is known, and
  // where the largest values are. None where half of the edge would be left out: it is a point
  // itself. Whether there are any.
  bool add_poles(const GC::Edge_enclosure& e, Ranges& poles) const {
    std::vector<double> places{edge_.begin, edge_.end};
    for (const std::optional<GC::Edge_maximum>& x : {e.angle, e.curvature_jump})
      if (x) places.insert(places.end(), {x->upper_at, x->parameter});
    for (const Ranges* ranges : {&e.unresolved, &e.curvature_unresolved})
      for (std::size_t i = 0; i < ranges->size() && i < most_poles; ++i)
        places.push_back((*ranges)[i].first / 2 + (*ranges)[i].second / 2);
    bool is_new = false;
    double left_out = 0;
    for (const auto& [from, to] : poles) left_out += to - from;
    for (double t : places) {
      if (std::any_of(poles.begin(), poles.end(), [t](const auto& r) { return r.first <= t && t <= r.second; }))
        continue;
      const auto range = GC::range_at_pole(sides_[0], sides_[1], edge_.begin, edge_.end, t, demand_.bounds.gap);
      if (!range) continue;
      poles.push_back(*range);
      is_new = true;
      left_out += range->second - range->first;
      if (left_out < (edge_.end - edge_.begin) / 2) continue;
      poles.clear();
      return false;
    }
    std::sort(poles.begin(), poles.end());
    return is_new;
  }

  // The enclosure of the rest of the edge, but for that of the gap, which is that of all of it.
  GC::Edge_enclosure rest(const GC::Edge_enclosure& whole, const Cad_verdict& result) {
    parts_.clear();
    double begin = edge_.begin;
    for (const auto& [from, to] : result.poles) {
      if (begin < from) parts_.emplace_back(begin, from);
      begin = (std::max)(begin, to);
    }
    if (begin < edge_.end) parts_.emplace_back(begin, edge_.end);
    GC::Edge_enclosure rest{};
    rest.gap = whole.gap;
    rest.exhausted = result.within[0] == GC::Verdict::undecided && whole.exhausted;
    rest.boxes = whole.boxes;
    const auto include = [](const std::optional<GC::Edge_maximum>& of_part, std::optional<GC::Edge_maximum>& x) {
      if (!x || !of_part) {
        if (of_part) x = of_part;
        return;
      }
      const GC::Edge_maximum other = *x;
      if (other.value.lower < of_part->value.lower) x = of_part;
      x->value.upper = (std::max)(other.value.upper, of_part->value.upper);
      x->upper_at = other.value.upper < of_part->value.upper ? of_part->upper_at : other.upper_at;
    };
    const auto append = [](const Ranges& of_part, Ranges& x) { x.insert(x.end(), of_part.begin(), of_part.end()); };
    for (const auto& [from, to] : parts_) {
      const GC::Edge_enclosure e = GC::edge_enclosure(sides_[0], sides_[1], from, to, precision_);
      include(e.angle, rest.angle);
      include(e.curvature_jump, rest.curvature_jump);
      append(e.singular, rest.singular);
      append(e.unresolved, rest.unresolved);
      append(e.curvature_undefined, rest.curvature_undefined);
      append(e.curvature_unresolved, rest.curvature_unresolved);
      rest.exhausted = rest.exhausted || e.exhausted;
      rest.boxes += e.boxes;
    }
    return rest;
  }

public:
  Edge_decision(const Cad_edge& edge, const Cad_demand& demand)
      : edge_(edge), demand_(demand), sides_(*edge.sides), is_projected_(edge.projections) {
    if (edge.kind != Cad_edge_kind::knot_line) return;
    // There are many of these, and most are smooth up to roundings: what nobody asks for is not
    // computed.
    precision_.with_curvature = demand.most > 1;
    precision_.gap = (std::max)(precision_.gap, demand.bounds.gap.lower() / 4);
    precision_.angle = (std::max)(precision_.angle, demand.bounds.tangent_angle.lower() / 4);
  }

  // Takes the foot points of the curve in space, at so many parameters, in place of the curves that
  // are there.
  void project(int pieces, const std::array<bool, 2>& which) {
    is_projected_ = which;
    for (std::size_t i = 0; i < 2; ++i)
      if (which[i]) sides_[i] = GC::projected_side(sides_[i], *edge_.space, edge_.begin, edge_.end, pieces);
  }

  Cad_verdict decide() {
    Cad_verdict result;
    if (edge_.kind == Cad_edge_kind::degenerate) {
      result.within[0] = GC::Verdict::proved;
      compare_curve(result);
      return result;
    }
    parts_ = {{edge_.begin, edge_.end}};
    result.enclosure = GC::edge_enclosure(sides_[0], sides_[1], edge_.begin, edge_.end, precision_);
    const GC::Edge_enclosure& e = *result.enclosure;
    result.within[0] = GC::at_most(e.gap.value, demand_.bounds.gap);
    doubt(result, 0, e.gap, demand_.bounds.gap, &GC::Foot_comparison::gap);
    if (edge_.space) compare_curve(result);
    if (edge_.kind != Cad_edge_kind::knot_line && !has_projections() && !result.in_doubt &&
        result.within[0] != GC::Verdict::refuted)
      if (const auto exact = GC::edge_continuity(sides_[0], sides_[1], edge_.begin, edge_.end))
        result.exact = exact->g_order;
    const GC::Edge_enclosure whole = e;
    Cad_verdict decided = result;
    decide_normals(decided);
    while (!is_settled(decided) && result.poles.size() < most_poles && add_poles(*decided.enclosure, result.poles)) {
      result.enclosure = rest(whole, result);
      decided = result;
      decide_normals(decided);
    }
    return decided;
  }
};

// Why an edge is undecided.
const char* open_reason(const Cad_verdict& verdict) {
  if (verdict.is_exhausted) return "the work did not suffice, see --max-work";
  if (verdict.in_doubt) return "how far the curve in space is from the faces leaves it open";
  if (!verdict.enclosure->unresolved.empty()) return "a normal can be told neither from zero nor to be zero";
  return "the tolerance lies between the bounds";
}

} // namespace

std::optional<Given> claim_of(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand) {
  if (edge.kind == Cad_edge_kind::non_manifold)
    return Given{Claim::not_covered, "edge", "three faces or more share it"};
  if (is_no_point(edge, verdict))
    return Given{Claim::not_covered, "edge", "it is said to be a point, and is not proved to be one"};
  if (edge.kind == Cad_edge_kind::boundary && !edge.reason.empty())
    return Given{Claim::not_covered, "edge", beside_another};
  if (!has_verdict(edge)) return std::nullopt;
  if (!verdict.enclosure) return Given{Claim::not_covered, "edge", verdict.reason};
  switch (verdict.meets(demand.order.value_or(1))) {
  case GC::Verdict::proved: return Given{Claim::met, "edge"};
  case GC::Verdict::refuted: return Given{demand.order ? Claim::not_met : Claim::met, "edge"};
  case GC::Verdict::undecided: break;
  }
  return Given{Claim::undecided, "edge", open_reason(verdict)};
}

Given claim_of(const Cad_join_verdict& verdict, const Cad_demand& demand) {
  if (!verdict.enclosure) return {Claim::not_covered, "join", verdict.reason};
  switch (verdict.meets(demand.kind, demand.order.value_or(1))) {
  case GC::Verdict::proved: return {Claim::met, "join"};
  case GC::Verdict::refuted: return {demand.order ? Claim::not_met : Claim::met, "join"};
  case GC::Verdict::undecided: break;
  }
  return {Claim::undecided, "join",
          verdict.enclosure->deviation.tangent_angle ? "the tolerance lies between the bounds"
                                                     : "a tangent cannot be told from zero"};
}

Cad_join_verdict cad_verdict(const Cad_join& join, const Cad_demand& demand) {
  Cad_join_verdict result;
  try {
    result.enclosure = GC::wire_enclosure(join.ends[0], join.ends[1]);
  } catch (const GC::Error& e) {
    result.reason = e.what();
    return result;
  }
  const GC::Join_deviation& d = result.enclosure->deviation;
  const auto within = [](const std::optional<GC::Enclosure>& x, const GC::Bound& bound) {
    return x ? GC::at_most(*x, bound) : GC::Verdict::undecided;
  };
  const GC::Verdict is_smooth = within(d.tangent_angle, demand.bounds.tangent_angle),
                    is_kink = within(d.tangent_angle, times(demand.kink, 1 - rounded_number));
  result.within[0] = GC::at_most(d.gap, demand.bounds.gap);
  result.within[1] = result.within[0] && is_smooth;
  result.within[2] = result.within[1] && within(d.curvature_jump, demand.bounds.curvature_jump);
  result.c_within[0] = result.within[0];
  const auto& [first, second] = result.enclosure->derivative_jumps;
  result.c_within[1] = result.within[0] && GC::at_most(first, demand.bounds.tangent_angle);
  result.c_within[2] = result.c_within[1] && GC::at_most(second, demand.bounds.curvature_jump);
  result.shape = result.within[0] == GC::Verdict::refuted ? Cad_shape::gap
                 : is_smooth == GC::Verdict::proved       ? Cad_shape::smooth
                 : is_smooth == GC::Verdict::undecided    ? Cad_shape::undecided
                 : is_kink == GC::Verdict::proved         ? Cad_shape::kink
                 : is_kink == GC::Verdict::refuted        ? Cad_shape::corner
                                                          : Cad_shape::bent;
  return result;
}

Cad_bend cad_bend(const Cad_curve_edge& curve, const Curvature_bound& bound) {
  GC::Edge_precision precision = precision_of_work();
  precision.relative = rounded_number;
  precision.flat_curvature = GC::enclosure(bound.curvature).lower; // it is met when that is proved
  Cad_bend result{{Claim::undecided, "curve", "its largest curvature is not known well enough"}, {}};
  try {
    result.curvature = GC::largest_curvature(*curve.space, curve.begin, curve.end, precision);
  } catch (const GC::Error& e) {
    result.given = {Claim::not_covered, "curve", e.what()};
    return result;
  }
  const GC::Bound allowed = times(GC::enclosure(bound.curvature), 1 + rounded_number);
  const GC::Verdict verdict = GC::at_most(result.curvature.value, allowed);
  if (verdict != GC::Verdict::undecided)
    result.given = {verdict == GC::Verdict::proved ? Claim::met : Claim::not_met, "curve"};
  return result;
}

Cad_verdict cad_verdict(const Cad_edge& edge, const Cad_demand& demand) {
  Cad_verdict result;
  if (!edge.sides) {
    result.reason = edge.reason;
    return result;
  }
  try {
    Edge_decision decision(edge, demand);
    result = decision.decide();
    const bool is_far =
        result.deviation && GC::at_most(result.deviation->value, demand.bounds.gap) != GC::Verdict::proved;
    // A projection that is wrong or undecided is measured with a better one.
    const bool is_wrong = edge.projected && result.within[1] != GC::Verdict::proved;
    for (int pieces : {32, 256}) {
      if (!edge.space || !(result.in_doubt || (is_wrong && !result.computed))) break;
      const bool was_computed = result.computed;
      const double before = result.deviation ? result.deviation->value.lower : 0;
      decision.project(pieces, is_far ? std::array<bool, 2>{true, true} : edge.projections);
      Cad_verdict better = decision.decide();
      better.computed = true;
      const bool is_stuck = was_computed && better.deviation && better.deviation->value.upper > before / 2;
      result = std::move(better);
      if (is_stuck) break; // more foot points bring the curves no nearer
    }
  } catch (const GC::Error& e) {
    result = Cad_verdict();
    result.reason = e.what();
  }
  return result;
}
