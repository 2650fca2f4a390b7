// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "arrays.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/surface_blends/match.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>

namespace {

GC::Patch_edge patch_edge(const std::string& name, const std::string& place) {
  for (const GC::Patch_edge edge : GC::patch_edges)
    if (name == to_string(edge)) return edge;
  throw GC::Error(GC::Error_code::parameter_outside_domain,
                  place + ": the edge '" + name + "' is none of u0, u1, v0, v1");
}

template <class Traits> GC::Bezier_patch<Traits> patch(const Numbers& x, const std::string& place) {
  if (x.shape.size() != 3 || x.shape[0] == 0 || x.shape[1] == 0) refuse_shape(place, "(degree u + 1, degree v + 1, 3)");
  if (x.shape[2] != 3) throw GC::Error(GC::Error_code::dimension_mismatch, place);
  Numbers rows = x;
  rows.shape = {x.shape[0] * x.shape[1], x.shape[2]};
  return GC::Bezier_patch<Traits>(static_cast<int>(x.shape[0]) - 1, static_cast<int>(x.shape[1]) - 1,
                                  points<Traits>(rows, place));
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

typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Exact_space;

// Calls f with the patches over the traits class by which their edges are decided.
template <class Function> Edge_record with_patches(const Numbers& a, const Numbers& b, Function f) {
  typedef GC::Traits_3<CGAL::Exact_predicates_inexact_constructions_kernel> Doubles;
  const std::string place = "edge_continuity";
  if (a.are_doubles() && b.are_doubles()) return f(patch<Doubles>(a, place), patch<Doubles>(b, place));
  return f(patch<Exact_space>(a, place), patch<Exact_space>(b, place));
}

} // namespace

Edge_record edge_continuity(const Numbers& a, const std::string& edge_a, const Numbers& b, const std::string& edge_b) {
  const GC::Patch_edge first = patch_edge(edge_a, "edge_continuity"), second = patch_edge(edge_b, "edge_continuity");
  return with_patches(
      a, b, [&](const auto& s, const auto& t) { return record_of(GC::edge_continuity(s, first, t, second)); });
}

Edge_record edge_continuity(const Numbers& a, const Numbers& b) {
  return with_patches(
      a, b, [&](const auto& s, const auto& t) { return record_of(GC::edge_continuity(s, &a == &b ? s : t)); });
}

Matched_numbers match(const Numbers& a, const std::string& edge_a, const Numbers& b, const std::string& edge_b,
                      int order, const std::vector<std::pair<std::string, Exact>>& shape) {
  const GC::Bezier_patch<Exact_space> s = patch<Exact_space>(a, "match"), t = patch<Exact_space>(b, "match");
  const bool are_given = !edge_a.empty();
  const auto [first, second] =
      are_given ? std::pair(patch_edge(edge_a, "match"), patch_edge(edge_b, "match")) : GC::nearest_edges(s, t);
  const GC::Edge_direction direction = nearer_direction(s, first, t, second);
  GC::Matching_shape<Exact> x = nearest_matching_shape(s, first, t, second, order, direction);
  std::vector<std::pair<std::string, Exact*>> numbers{{"alpha", &x.alpha}, {"beta", &x.beta}};
  if (order > 1) numbers.insert(numbers.end(), {{"alpha2", &x.alpha2}, {"delta", &x.delta}});
  if (order > 2) numbers.insert(numbers.end(), {{"alpha3", &x.alpha3}, {"delta3", &x.delta3}});
  Matched_numbers result;
  result.edges = {to_string(first), to_string(second)};
  for (const auto& [name, value] : shape)
    for (const auto& [known, number] : numbers)
      if (name == known) *number = value;
  for (const auto& [known, number] : numbers) result.shape.emplace_back(known, *number);
  const GC::Bezier_patch<Exact_space> c = match(s, first, t, second, order, x, direction);
  Array_writer<Exact> writer(
      {static_cast<std::size_t>(c.degree_u()) + 1, static_cast<std::size_t>(c.degree_v()) + 1, std::size_t(3)});
  for (int i = 0; i <= c.degree_u(); ++i)
    for (int j = 0; j <= c.degree_v(); ++j)
      for (int k = 0; k < 3; ++k) writer.add(c.coordinates(i, j)[k]);
  result.points = writer.get();
  result.before = record_of(GC::edge_continuity(s, first, t, second));
  result.has_order =
      order == 3 ? GC::is_g3_edge(s, first, c, second) : GC::edge_continuity(s, first, c, second).g_order >= order;
  return result;
}
