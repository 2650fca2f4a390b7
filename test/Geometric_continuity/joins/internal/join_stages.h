// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
#define CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H

#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <array>

// The stages of the decision of a join, switched on one by one, and how many answers each gave.

using CGAL::Geometric_continuity::internal::Join_answer;
using CGAL::Geometric_continuity::internal::Join_stage;

constexpr int number_of_stages = 7;
struct Stages {
  unsigned used;
  std::array<long, number_of_stages> count{};
  bool uses(Join_stage s) const { return (used >> static_cast<int>(s)) & 1; }
  void decided(Join_stage s, Join_answer) { ++count[static_cast<int>(s)]; }
};
constexpr unsigned stage(Join_stage s) { return 1u << static_cast<int>(s); }

#endif // CGAL_GEOMETRIC_CONTINUITY_TEST_JOINS_INTERNAL_JOIN_STAGES_H
