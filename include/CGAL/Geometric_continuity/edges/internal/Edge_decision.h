// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_DECISION_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_DECISION_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_ladder.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/edges/internal/Integer_angle_maximum.h>
#include <CGAL/Geometric_continuity/edges/internal/Largest_measure.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Edge_decision.h
/// The order of two surfaces along an edge on which both are polynomials, the reason why it is not
/// higher, and the place: by the stages of Edge_ladder.h where the edge is smooth, otherwise in
/// multi-precision. And the verdict on several spans.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The verdict on [0, 1] along two edges that are the same curve in one direction, where the tangent
// planes differ somewhere but nowhere by a right angle or more, so that no normal vanishes. Empty
// if numbers of fixed length do not prove that, or the meter does not allow to look for the largest
// angle. See Edge_measure for the polynomials p and s.
template <class Field>
std::optional<Edge_continuity<Field>> crease_on_grid(Edge_ladder& ladder,
                                                     Crease_angles angles = Crease_angles::enclosed) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  constexpr int most_along = 5;
  if constexpr (Common_denominator<Field>::clears) {
    if (ladder.degree() > most_along || ladder.is_collapsed()) return std::nullopt;
    const Edge_ladder::On_grid* const edge = ladder.on_grid();
    if (!edge) return std::nullopt;
    const auto n1 = edge->normal(), n2 = edge->second_normal();
    const auto side = sum_of_products<3>(n1, n2);
    if (side.strict_sign() >= 0) return std::nullopt;
    const auto p = sum_of_products<3>(n1, n1) * sum_of_products<3>(n2, n2);
    const auto s = p - side * side;
    if (s.vanishes()) return std::nullopt;
    Edge_continuity<Field> e;
    if (angles == Crease_angles::enclosed) {
      e.deviation = Integer_angle_maximum<Field, std::decay_t<decltype(s)>, std::decay_t<decltype(p)>>(s, p)();
      if (!e.deviation) return std::nullopt;
    }
    e.g_order = 0;
    e.defect = Edge_defect::crease;
    e.side = Sign_pattern::negative;
    return e;
  }
#endif
  return std::nullopt;
}

// Decides in multi-precision, for edges that are the same curve in one direction. `Sides` is
// Edge_sides or what has its derivatives.
template <class Field, int N = 3> class Edge_decision {
  typedef Edge_normals<Field, N> Normals;
  typedef typename Normals::Polynomial Polynomial;

  Edge_continuity<Field> edge_;

public:
  template <class Sides> Edge_continuity<Field> operator()(const Sides& sides) {
    edge_.g_order = 0;
    const Normals normals(sides);
    edge_.collapsed = sides.collapsed();
    edge_.coplanar = normals.coplanar();
    edge_.side = normals.side_signs();
    edge_.normal_vanishes = normals.normal_vanishes(edge_.side);
    edge_.defect = edge_.collapsed ? Edge_defect::collapsed : first_order_defect();
    if (edge_.collapsed) return edge_;
    if (edge_.defect == Edge_defect::curvature) {
      edge_.g_order = 1;
      if (normals.second_order(sides)) {
        edge_.g_order = 2;
        edge_.defect = Edge_defect::none;
      }
    }
    locate(normals);
    return edge_;
  }

private:
  Edge_defect first_order_defect() const {
    if (!edge_.coplanar) return Edge_defect::crease;
    switch (edge_.side) {
    // until second order has been decided
    case Sign_pattern::negative: return Edge_defect::curvature;
    case Sign_pattern::nonpositive:
    case Sign_pattern::zero: return Edge_defect::vanishing_normal;
    default: return Edge_defect::fold;
    }
  }

  void locate(const Normals& n) {
    if (edge_.normal_vanishes) {
      if (Edge_sides<Field, N>::is_zero(n.n1) || Edge_sides<Field, N>::is_zero(n.n2)) {
        edge_.vanishing = std::pair<Field, Field>(Field(0), Field(1));
        return;
      }
      edge_.vanishing =
          zero_interval<Field>(edge_.coplanar ? n.side : counted_product(Normals::square(n.n1), Normals::square(n.n2)));
    }
    if (edge_.defect == Edge_defect::crease || edge_.defect == Edge_defect::fold)
      edge_.deviation = largest_angle<Field>(normal_part<typename Normals::Ring>(n.n1),
                                             normal_part<typename Normals::Ring>(n.n2), edge_.normal_vanishes);
    else
      edge_.deviation = Normal_deviation<Field>{Field(0), Field(0), Field(0), Field(1)};
  }
};

// Edge_decision answers this for the orders 1 and 2, which have no other reasons and places.
template <class Field> Edge_continuity<Field> smooth_continuity(int order, const std::pair<Field, Field>& domain) {
  Edge_continuity<Field> e;
  e.g_order = order;
  e.defect = order == 2 ? Edge_defect::none : Edge_defect::curvature;
  e.coplanar = true;
  e.side = Sign_pattern::negative;
  e.deviation = Normal_deviation<Field>{Field(0), Field(0), domain.first, domain.second};
  return e;
}

// The multi-precision stage alone.
template <class Field, int N>
Edge_continuity<Field> decide_rough_edge(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b) {
  return Edge_decision<Field, N>()(Edge_sides<Field, N>(a, b));
}

// The decision on rows with the same edge, in one direction.
template <class Field, int N>
Edge_continuity<Field> decide_edge(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b) {
  if constexpr (Fixed_length_stages<N>::exist) {
    typename Fixed_length_stages<N>::Layers x, y;
    if (edge_layers(a, b, x, y)) {
      typename Fixed_length_stages<N>::Ladder ladder(x, y);
      if (const std::optional<int> order = smooth_order(ladder))
        return smooth_continuity<Field>(*order, {Field(0), Field(1)});
      if constexpr (N == 3)
        if (std::optional<Edge_continuity<Field>> crease = crease_on_grid<Field>(ladder)) return *std::move(crease);
    }
  }
  return decide_rough_edge(a, b);
}

// The verdict on an interval [begin, end] of an edge from that on [0, 1].
template <class Field> Edge_span<Field> on_interval(const Field& begin, const Field& end, Edge_continuity<Field> e) {
  const Field length = end - begin;
  const auto map = [&](Field& t) { t = Field(begin + t * length); };
  if (e.vanishing) {
    map(e.vanishing->first);
    map(e.vanishing->second);
  }
  if (e.deviation) {
    map(e.deviation->begin);
    map(e.deviation->end);
  }
  return {begin, end, std::move(e)};
}

template <class FT> bool is_worse(const Edge_continuity<FT>& x, const Edge_continuity<FT>& y) {
  if (x.defect != y.defect) return severity(y.defect) < severity(x.defect);
  return x.deviation && (!y.deviation || y.deviation->upper < x.deviation->upper);
}

// The verdict on all spans from those on each.
template <class FT> void summarise(Spline_edge_continuity<FT>& edge) {
  std::size_t i = 0;
  for (const Edge_span<FT>& span : edge.spans) {
    const Edge_continuity<FT>& s = span.continuity;
    if (i == 0) {
      static_cast<Edge_continuity<FT>&>(edge) = s;
      ++i;
      continue;
    }
    if (is_worse(s, edge.spans[edge.worst].continuity)) edge.worst = i;
    edge.coplanar = edge.coplanar && s.coplanar;
    edge.side = joint_pattern(edge.side, s.side);
    edge.collapsed = edge.collapsed && s.collapsed;
    edge.normal_vanishes = edge.normal_vanishes || s.normal_vanishes;
    if (!edge.vanishing) edge.vanishing = s.vanishing;
    if (s.deviation) {
      if (!edge.deviation) edge.deviation = s.deviation;
      const FT lower = (std::max)(edge.deviation->lower, s.deviation->lower);
      if (edge.deviation->upper < s.deviation->upper) edge.deviation = s.deviation;
      edge.deviation->lower = lower;
    }
    ++i;
  }
  edge.g_order = edge.spans[edge.worst].continuity.g_order;
  edge.defect = edge.spans[edge.worst].continuity.defect;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_DECISION_H
