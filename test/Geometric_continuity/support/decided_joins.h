// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// This declares what joins/join_continuity.h and joins/join_predicates.h define, for tests that ask
// about joins but do not test how they are decided: it is compiled once, for the curves that
// decided_joins.cpp names, in a library that all unit tests link. Such tests need not be compiled
// again when the stages of the decision change.

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

namespace CGAL {
namespace Geometric_continuity {

template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity(const Left& left, const Right& right, int max_order);
template <class Left, class Right>
Join_continuity<Predicate_FT<typename Left::Traits>> continuity(const Left& left, const Right& right);
template <class Traits>
Join_continuity<Predicate_FT<Traits>> continuity(const Curve_jet<Traits>& left, const Curve_jet<Traits>& right);

} // namespace Geometric_continuity
} // namespace CGAL

// The predicates is_g1_join and is_g2_join, which are objects and cannot be declared before.
template <class Left, class Right> bool decide_g1_join(const Left& left, const Right& right);
template <class Left, class Right> bool decide_g2_join(const Left& left, const Right& right);
