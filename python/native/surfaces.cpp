// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "arrays.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>

namespace {

GC::Patch_edge patch_edge(const std::string& name) {
  for (const GC::Patch_edge edge : GC::patch_edges)
    if (name == to_string(edge)) return edge;
  throw GC::Error(GC::Error_code::parameter_outside_domain,
                  "edge_continuity: the edge '" + name + "' is none of u0, u1, v0, v1");
}

template <class Traits> GC::Bezier_patch<Traits> patch(const Numbers& x) {
  if (x.shape.size() != 3 || x.shape[0] == 0 || x.shape[1] == 0)
    refuse_shape("edge_continuity", "(degree u + 1, degree v + 1, 3)");
  if (x.shape[2] != 3) throw GC::Error(GC::Error_code::dimension_mismatch, "edge_continuity");
  Numbers rows = x;
  rows.shape = {x.shape[0] * x.shape[1], x.shape[2]};
  return GC::Bezier_patch<Traits>(static_cast<int>(x.shape[0]) - 1, static_cast<int>(x.shape[1]) - 1,
                                  points<Traits>(rows, "edge_continuity"));
}

template <class Edge> Edge_record record_of(const Edge& edge) {
  std::ostringstream text, defect;
  text << edge;
  defect << edge.defect;
  Edge_record record{edge.g_order,   defect.str(),         text.str(),   edge.reversed, edge.coplanar,
                     edge.collapsed, edge.normal_vanishes, edge.whole_a, edge.whole_b,  {}};
  if (edge.deviation) record.largest_angle = edge.deviation->largest_angle();
  return record;
}

// Calls f with the patches over the traits class by which their edges are decided.
template <class Function> Edge_record with_patches(const Numbers& a, const Numbers& b, Function f) {
  typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Doubles;
  typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Exact_space;
  if (a.are_doubles() && b.are_doubles()) return f(patch<Doubles>(a), patch<Doubles>(b));
  return f(patch<Exact_space>(a), patch<Exact_space>(b));
}

} // namespace

Edge_record edge_continuity(const Numbers& a, const std::string& edge_a, const Numbers& b, const std::string& edge_b) {
  const GC::Patch_edge first = patch_edge(edge_a), second = patch_edge(edge_b);
  return with_patches(
      a, b, [&](const auto& s, const auto& t) { return record_of(GC::edge_continuity(s, first, t, second)); });
}

Edge_record edge_continuity(const Numbers& a, const Numbers& b) {
  return with_patches(
      a, b, [&](const auto& s, const auto& t) { return record_of(GC::edge_continuity(s, &a == &b ? s : t)); });
}
