// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"
#include "ops_local.h"

#include <CGAL/Geometric_continuity/blends/blend_strategies.h>

#include <stdexcept>

template <class Left, class Right>
void report_blend_join(Report& report, const std::string& path, const Left& left, const Right& right, int order) {
  report_orders(report, Source::consequence, path, [&] { return GC::continuity(left, right, order); });
}

template <class Traits, class Strategy>
void run_quintic(const Input<Traits>& in, Report& report, const Strategy& strategy) {
  typedef typename Traits::FT FT;
  const GC::Bezier_curve<Traits> phi = in.curve("phi"), psi = in.curve("psi");
  const GC::Quintic_blend<Traits> gamma = blend(phi, psi, strategy, {in.number("beta"), in.number("eta")});
  report.construction("points", [&] { return coordinate_rows<Traits>(gamma); });
  report.construction("s", [&] { return std::vector<FT>{gamma.parameters.s1, gamma.parameters.s2}; });
  report.consequence("fallback", [&] {
    return std::vector<bool>{gamma.parameters.fallback_start, gamma.parameters.fallback_end};
  });
  report.construction("energy2", [&] { return gamma.energy(2); });
  report.construction("energy3", [&] { return gamma.energy(3); });
  report_blend_join(report, "join_start.", phi, gamma, 2);
  report_blend_join(report, "join_end.", gamma, psi, 2);
  report.construction("kappa_sq_start", [&] { return start_invariants(gamma).curvature_squared; });
  report.construction("kappa_sq_end", [&] { return end_invariants(gamma).curvature_squared; });
}

template <class FT>
void report_end_parameters(Report& report, const std::string& path, const GC::Septic_end_parameters<FT>& p) {
  report.construction(path + ".beta2", [&] { return p.beta2; });
  report.construction(path + ".mu", [&] { return p.mu; });
  report.construction(path + ".beta3", [&] { return p.beta3; });
}

template <class Traits, class Strategy>
void run_septic(const Input<Traits>& in, Report& report, const Strategy& strategy) {
  const GC::Bezier_curve<Traits> phi = in.curve("phi"), psi = in.curve("psi");
  const GC::Septic_blend<Traits> gamma = blend(phi, psi, strategy, {in.number("beta"), in.number("eta")});
  report.construction("points", [&] { return coordinate_rows<Traits>(gamma); });
  report_end_parameters(report, "start", gamma.parameters.start);
  report_end_parameters(report, "end", gamma.parameters.end);
  report.construction("energy3", [&] { return gamma.energy(3); });
  report.construction("energy4", [&] { return gamma.energy(4); });
  report_blend_join(report, "join_start.", phi, gamma, 3);
  report_blend_join(report, "join_end.", gamma, psi, 3);
  report.construction("tau_start", [&] { return torsion_if_defined(gamma.start_jet(3)); });
  report.construction("tau_end", [&] { return torsion_if_defined(gamma.end_jet(3)); });
}

// Topics quintic and septic.
template <class Traits> bool run_blends(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  const Input<Traits> in{c};
  const std::string& strategy = c.text("strategy");
  const auto given = [&](const char* path) {
    return c.has(path + std::string("#")) ? in.numbers(path) : std::vector<FT>(3, FT(0));
  };
  bool known = false;
  if (c.op == "quintic_blend") {
    const std::vector<FT> s = given("s");
    known = with_choice(
        strategy, [&](const auto& chosen) { run_quintic(in, report, chosen); },
        std::pair("c2", GC::Matching_second_derivative()), std::pair("normal", GC::Normal_offset()),
        std::pair("min_second", GC::Minimal_second_derivative()), std::pair("near_line", GC::Near_line()),
        std::pair("energy2", GC::Minimal_energy<2>()), std::pair("energy3", GC::Minimal_energy<3>()),
        std::pair("free", GC::Given_parameters<FT>{s.at(0), s.at(1)}));
  } else if (c.op == "septic_blend") {
    const std::vector<FT> s = given("start"), e = given("end");
    known = with_choice(
        strategy, [&](const auto& chosen) { run_septic(in, report, chosen); },
        std::pair("c3", GC::Matching_third_derivative()), std::pair("seq_g3", GC::Sequential_g3()),
        std::pair("seq_f3", GC::Sequential_f3()), std::pair("joint_g3", GC::Joint_g3()),
        std::pair("energy3_g3", GC::Minimal_energy_g3<3>()), std::pair("energy4_g3", GC::Minimal_energy_g3<4>()),
        std::pair("free", GC::Given_end_parameters<FT>{{s.at(0), s.at(1), s.at(2)}, {e.at(0), e.at(1), e.at(2)}}));
  } else
    return false;
  if (!known) throw std::runtime_error("unknown strategy " + strategy);
  return true;
}
