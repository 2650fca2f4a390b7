// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_NAMED_STRATEGIES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_NAMED_STRATEGIES_H

#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>

#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

// The strategies of a blend that need no numbers, by the names that the program, the module of
// Python and the package for browsers have for them. It includes nothing else of the program.

namespace GC = CGAL::Geometric_continuity;

template <class Strategy_> struct Named_strategy {
  typedef Strategy_ Strategy;
  const char* name;
};

template <class Strategy> constexpr Named_strategy<Strategy> named(const char* name) { return {name}; }

constexpr auto quintic_strategies = std::make_tuple(
    named<GC::Matching_second_derivative>("c2"), named<GC::Normal_offset>("normal"),
    named<GC::Minimal_second_derivative>("min_second"), named<GC::Near_line>("near_line"),
    named<GC::Minimal_energy<2>>("energy2"), named<GC::Minimal_energy<3>>("energy3"), named<GC::Fair>("fair"));

constexpr auto septic_strategies = std::make_tuple(
    named<GC::Matching_third_derivative>("c3"), named<GC::Sequential_g3>("seq_g3"), named<GC::Sequential_f3>("seq_f3"),
    named<GC::Joint_g3>("joint_g3"), named<GC::Minimal_energy_g3<3>>("energy3_g3"),
    named<GC::Minimal_energy_g3<4>>("energy4_g3"), named<GC::Fair_g3>("fair_g3"), named<GC::Fair_f3>("fair_f3"));

// Calls f(strategy) for that of a name. Returns whether there is one.
template <class Table, class Function>
bool with_named_strategy(const Table& strategies, std::string_view name, const Function& f) {
  const auto is_called = [&](const auto& s) {
    if (name != s.name) return false;
    f(typename std::decay_t<decltype(s)>::Strategy());
    return true;
  };
  return std::apply([&](const auto&... s) { return (is_called(s) || ...); }, strategies);
}

template <class Table> std::vector<std::string> names_of(const Table& strategies) {
  return std::apply([](const auto&... s) { return std::vector<std::string>{s.name...}; }, strategies);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_NAMED_STRATEGIES_H
