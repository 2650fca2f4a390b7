// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_STRATEGIES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_STRATEGIES_H

#include "commands/blends/named_strategies.h"
#include "commands/chains/join_report.h"
#include "commands/command_line.h"
#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/blends/representable_blend.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The result of one strategy.
template <class FT> struct Blend_result {
  std::string strategy;
  Program_curve<FT> curve;
  GC::Shape_parameters<FT> shape;
  std::string parameters, fallback;
  std::optional<GC::Fair_report> report = {};
  // of a representable blend: both given curves as they now are
  std::vector<Program_curve<FT>> neighbours = {};
};

inline std::string fallback_text(bool start, bool end) {
  return !start && !end ? ""
                        : std::string(" fallback at ") + (start && end ? "both ends"
                                                          : start      ? "the start"
                                                                       : "the end");
}

// Numbers for a table.
template <class FT> std::string short_text(const FT& x) { return rounded(CGAL::to_double(x), 6); }
template <class FT> std::string short_text(const GC::Shape_parameters<FT>& shape) {
  return "beta = " + short_text(shape.beta) + ", eta = " + short_text(shape.eta);
}
template <class FT> std::string short_text(const GC::Quintic_parameters<FT>& p) {
  return "s = (" + short_text(p.s1) + ", " + short_text(p.s2) + ')';
}
template <class FT> std::string short_text(const GC::Septic_end_parameters<FT>& p) {
  return '(' + short_text(p.beta2) + ", " + short_text(p.mu) + ", " + short_text(p.beta3) + ')';
}
template <class FT> std::string short_text(const GC::Septic_parameters<FT>& p) {
  return "(beta2, mu, beta3) = " + short_text(p.start) + ", " + short_text(p.end);
}
inline std::string short_text(const GC::Fair_report& report) {
  return ", " + std::to_string(report.iterations) + (report.iterations == 1 ? " iteration" : " iterations") +
         ", fairness " + short_text(report.automatic_fairness) + " -> " + short_text(report.fairness) +
         (report.converged ? "" : " (not converged)");
}

// Returns the three numbers of --start or --end.
template <class FT> GC::Septic_end_parameters<FT> end_parameters(const Command_line& line, const std::string& option) {
  const std::vector<FT> x = line.numbers<FT>(option);
  if (x.size() != 3) throw std::invalid_argument("--" + option + ": three numbers beta2,mu,beta3 are needed");
  return {x[0], x[1], x[2]};
}

// Blends two curves by strategies that are given by name.
template <class FT> class Blender {
  typedef Program_traits<FT> Traits;
  const Command_line& line_;
  const Program_curve<FT>&phi_, &psi_;
  std::optional<GC::Shape_parameters<FT>> shape_; // if --beta or --eta is given

  template <class Blend> static Blend_result<FT> result(const std::string& name, const Blend& gamma) {
    return {name, gamma, gamma.shape, short_text(gamma.shape) + ", " + short_text(gamma.parameters),
            fallback_text(gamma.parameters.fallback_start, gamma.parameters.fallback_end)};
  }
  template <class Blend, class Report>
  static Blend_result<FT> result(const std::string& name, const GC::Shaped_blend<Blend, Report>& gamma) {
    const Blend& blend = gamma;
    Blend_result<FT> r = result(name, blend);
    r.report = gamma.report;
    r.parameters += short_text(gamma.report);
    return r;
  }

  // A strategy as a function of the ends: what is made by one is compiled once for all of them.
  template <class NT>
  using Quintic_function = std::function<GC::Quintic_parameters<NT>(const GC::Quintic_ends<NT, 0>&)>;
  typedef std::function<GC::Septic_parameters<FT>(const GC::Septic_ends<FT, 0>&)> Septic_function;
  template <class Strategy>
  using Function =
      std::conditional_t<GC::is_quintic_strategy_v<Strategy, Traits>, Quintic_function<FT>, Septic_function>;

  template <class Strategy>
  static constexpr bool chooses_shape_v = std::is_same_v<Strategy, GC::Fair> || std::is_same_v<Strategy, GC::Fair_g3> ||
                                          std::is_same_v<Strategy, GC::Fair_f3>;

  template <class Strategy> Blend_result<FT> blend(const std::string& name, const Strategy& strategy) const {
    if constexpr (std::is_same_v<FT, double> && GC::is_quintic_strategy_v<Strategy, Traits>)
      if (line_.has("representable")) {
        if constexpr (chooses_shape_v<Strategy>)
          return representable(name, strategy, shape_ ? *shape_ : GC::blend(phi_, psi_, strategy).shape);
        else
          return representable(name, strategy,
                               shape_ ? *shape_ : GC::blend(phi_, psi_, Function<Strategy>(strategy)).shape);
      }
    if constexpr (chooses_shape_v<Strategy>)
      if (!shape_) return result(name, GC::blend(phi_, psi_, strategy));
    return by_function(name, Function<Strategy>(strategy));
  }

  template <class Function> Blend_result<FT> by_function(const std::string& name, const Function& strategy) const {
    if (shape_) return result(name, GC::blend(phi_, psi_, strategy, *shape_));
    return result(name, GC::blend(phi_, psi_, strategy));
  }

  Blend_result<FT> representable(const std::string& name, const Quintic_function<Exact>& strategy,
                                 const GC::Shape_parameters<FT>& shape) const {
    const GC::Representable_blend<Traits> gamma = GC::representable_blend(
        polynomial(phi_, "--representable"), polynomial(psi_, "--representable"), strategy, shape);
    const GC::Shape_parameters<FT> chosen(gamma.start_join.beta, gamma.end_join.beta);
    const double moved = (std::max)(gamma.start_join.moved, gamma.end_join.moved);
    return {name,
            gamma,
            chosen,
            short_text(chosen) +
                (moved == 0 ? ", nothing was moved" : ", coordinates were moved by at most " + short_text(moved)),
            "",
            {},
            {gamma.phi, gamma.psi}};
  }

public:
  Blender(const Command_line& line, const Program_curve<FT>& phi, const Program_curve<FT>& psi)
      : line_(line), phi_(phi), psi_(psi) {
    if (!line.has("beta") && !line.has("eta")) return;
    shape_ = line.has("beta") && line.has("eta") ? GC::Shape_parameters<FT>()
                                                 : GC::automatic_shape(phi.end_jet(1), psi.start_jet(1));
    shape_->beta = line.number("beta", shape_->beta);
    shape_->eta = line.number("eta", shape_->eta);
  }

  Blend_result<FT> quintic(const std::string& name) const {
    std::optional<Blend_result<FT>> r;
    if (with_named_strategy(quintic_strategies, name, [&](const auto& chosen) { r = blend(name, chosen); })) return *r;
    if (!line_.has("s1") || !line_.has("s2")) throw std::invalid_argument("--strategy free needs --s1 and --s2");
    return blend(name, GC::Given_parameters<FT>{line_.number("s1", FT(0)), line_.number("s2", FT(0))});
  }

  Blend_result<FT> septic(const std::string& name) const {
    std::optional<Blend_result<FT>> r;
    if (with_named_strategy(septic_strategies, name, [&](const auto& chosen) { r = blend(name, chosen); })) return *r;
    return blend(name,
                 GC::Given_end_parameters<FT>{end_parameters<FT>(line_, "start"), end_parameters<FT>(line_, "end")});
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_BLEND_STRATEGIES_H
