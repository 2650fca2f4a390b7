// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "arrays.h"
#include "commands/blends/named_strategies.h"

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/clothoid_blend.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>

#include <algorithm>

namespace {

template <class Blend> void add_report(const Blend&, Blend_numbers&) {}
template <class Blend, class Report>
void add_report(const GC::Shaped_blend<Blend, Report>& gamma, Blend_numbers& numbers) {
  numbers.fairness = {gamma.report.automatic_fairness, gamma.report.fairness};
  numbers.converged = gamma.report.converged;
}

template <class Traits, class Blend> Blend_numbers numbers_of(const Blend& gamma) {
  Blend_numbers r;
  r.points = array_of<Traits>(gamma);
  r.beta = Exact(gamma.shape.beta);
  r.eta = Exact(gamma.shape.eta);
  r.fallback_start = gamma.parameters.fallback_start;
  r.fallback_end = gamma.parameters.fallback_end;
  add_report(gamma, r);
  return r;
}

template <class FT> FT converted(const Exact& x) {
  if constexpr (std::is_same_v<FT, double>)
    return nearest_double(x);
  else
    return x;
}

template <class FT>
Blend_numbers blend_in(const Numbers& left, const Numbers& right, const std::string& strategy,
                       const std::optional<Exact>& beta, const std::optional<Exact>& eta, const Numbers& parameters) {
  typedef Array_traits<FT> Traits;
  const GC::Bezier_curve<Traits> phi = curve<Traits>(left, "blend"), psi = curve<Traits>(right, "blend");
  const auto blend = [&](const auto& chosen) {
    if (!beta && !eta) return numbers_of<Traits>(GC::blend(phi, psi, chosen));
    GC::Shape_parameters<FT> shape;
    if (!beta || !eta) shape = GC::automatic_shape(phi.end_jet(1), psi.start_jet(1));
    if (beta) shape.beta = converted<FT>(*beta);
    if (eta) shape.eta = converted<FT>(*eta);
    return numbers_of<Traits>(GC::blend(phi, psi, chosen, shape));
  };
  if (strategy != "free") {
    Blend_numbers r;
    const auto keep = [&](const auto& chosen) { r = blend(chosen); };
    if (!with_named_strategy(quintic_strategies, strategy, keep) &&
        !with_named_strategy(septic_strategies, strategy, keep))
      throw GC::Error(GC::Error_code::parameter_outside_domain, "blend: there is no strategy '" + strategy + "'");
    return r;
  }
  const auto x = [&](std::size_t i) { return number<FT>(parameters, i); };
  if (parameters.size() == 2) return blend(GC::Given_parameters<FT>{x(0), x(1)});
  if (parameters.size() == 6) return blend(GC::Given_end_parameters<FT>{{x(0), x(1), x(2)}, {x(3), x(4), x(5)}});
  throw GC::Error(GC::Error_code::wrong_number_of_points,
                  "blend: the strategy 'free' needs two parameters (s1, s2), or six: beta2, mu, beta3 at both ends");
}

template <class Traits> Numbers knots_of(const GC::Composite_bezier_curve<Traits>& blend) {
  return array_of_numbers(blend.knots());
}
template <class Blend> Numbers knots_of(const Blend&) { return {}; }

template <class FT>
Corner_numbers round_in(const Numbers& left, const Numbers& right, double size, bool is_radius,
                        const std::string& strategy) {
  typedef Array_traits<FT> Traits;
  const GC::Bezier_curve<Traits> phi = curve<Traits>(left, "round_corner"), psi = curve<Traits>(right, "round_corner");
  const FT distance = is_radius ? GC::corner_distance(phi, psi, size) : FT(size);
  const auto round = [&](const auto& chosen) {
    const auto corner = GC::round_corner(phi, psi, distance, chosen);
    return Corner_numbers{array_of<Traits>(corner.left),  array_of<Traits>(corner.blend), knots_of(corner.blend),
                          array_of<Traits>(corner.right), Exact(corner.left_cut),         Exact(corner.right_cut)};
  };
  if (strategy == "fair") return round(GC::Fair());
  if (strategy == "fair_g3") return round(GC::Fair_g3());
  if (strategy == "energy3") return round(GC::Minimal_energy<3>());
  if (strategy == "cubic") return round(GC::Cubics());
  if (strategy == "two_cubics") return round(GC::Cubics{false});
  throw GC::Error(GC::Error_code::parameter_outside_domain,
                  "round_corner: the strategy '" + strategy + "' is none of fair, fair_g3, energy3, cubic, two_cubics");
}

} // namespace

std::vector<std::string> strategy_names() {
  std::vector<std::string> names = names_of(quintic_strategies);
  for (const std::string& name : names_of(septic_strategies)) names.push_back(name);
  names.push_back("free");
  return names;
}

Blend_numbers blend(const Numbers& left, const Numbers& right, const std::string& strategy,
                    const std::optional<Exact>& beta, const std::optional<Exact>& eta, const Numbers& parameters,
                    Field_of_results field) {
  return field == Field_of_results::exact ? blend_in<Exact>(left, right, strategy, beta, eta, parameters)
                                          : blend_in<double>(left, right, strategy, beta, eta, parameters);
}

Representable_numbers representable_blend(const Numbers& left, const Numbers& right, const std::string& strategy) {
  typedef Array_traits<double> Traits;
  const GC::Bezier_curve<Traits> phi = curve<Traits>(left, "representable_blend"),
                                 psi = curve<Traits>(right, "representable_blend");
  const auto blend = [&](const auto& chosen) {
    const GC::Representable_blend<Traits> gamma = GC::representable_blend(phi, psi, chosen);
    return Representable_numbers{array_of<Traits>(gamma.phi), array_of<Traits>(gamma), array_of<Traits>(gamma.psi),
                                 (std::max)(gamma.start_join.moved, gamma.end_join.moved)};
  };
  if (strategy == "fair") return blend(GC::Fair());
  if (strategy == "energy3") return blend(GC::Minimal_energy<3>());
  throw GC::Error(GC::Error_code::parameter_outside_domain,
                  "representable_blend: the strategy '" + strategy + "' is none of fair, energy3");
}

Clothoid_numbers clothoid_blend(const Numbers& start, const Numbers& end) {
  const auto end_of = [](const Numbers& x) {
    if (x.shape.size() != 1 || x.size() != 4)
      throw GC::Error(GC::Error_code::wrong_number_of_points,
                      "clothoid_blend: an end has four numbers, x, y, heading and curvature");
    const auto at = [&](std::size_t i) { return number<Exact>(x, i); };
    return GC::Alignment_end{GC::Enclosed_point(at(0), at(1)), GC::Heading(at(2)), GC::End_curvature(at(3))};
  };
  const GC::Clothoid_blend blend = GC::clothoid_blend(end_of(start), end_of(end));
  Clothoid_numbers r;
  r.segments.shape = {3, 6};
  for (const GC::Clothoid_segment& s : blend.segments) {
    const auto place = s.start_point().rational();
    for (const Exact& x :
         {place->first, place->second, s.start_heading().angle(), s.start_curvature(), s.end_curvature(), s.length()})
      r.segments.exact.push_back(x);
  }
  for (const GC::Alignment_join& join : blend.joins) {
    r.gaps.push_back(join.gap);
    r.kinks.push_back(join.kink);
    r.jumps.push_back(*join.jump);
  }
  return r;
}

Corner_numbers round_corner(const Numbers& left, const Numbers& right, double size, bool is_radius,
                            const std::string& strategy, Field_of_results field) {
  return field == Field_of_results::exact ? round_in<Exact>(left, right, size, is_radius, strategy)
                                          : round_in<double>(left, right, size, is_radius, strategy);
}
