// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CHAIN_ENDS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CHAIN_ENDS_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/models/internal/Polyhedron_cuts.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file Chain_ends.h
/// The choice of the one of three rounded edges at a vertex that ends at the chain of the two
/// others.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The edge opposite to a reflex angle of a face ends at the chain of the two others. Elsewhere
// edges are chosen that end at both their vertices, as far as possible: a matching, so that chains
// are closed. Where the edges of one direction are one, as in prisms, it is taken.
template <class FT> class Chain_ends {
  typedef Polyhedron_cuts<FT> Cuts;
  typedef typename Cuts::Vector Vector;

  const Cuts& cuts_;
  const typename Cuts::Solid& solid_;
  std::vector<int> stems_;

public:
  explicit Chain_ends(const Cuts& cuts) : cuts_(cuts), solid_(cuts.solid), stems_(cuts.solid.points.size(), -1) {
    std::vector<int> corners, number_of(solid_.points.size(), -1);
    for (int v = 0; v < static_cast<int>(stems_.size()); ++v)
      if (is_corner(v)) corners.push_back(v);
    const auto may_end = [&](int h) { // at its source
      int x = solid_.leaving[source(h)];
      for (int i = 0; i < 3; ++i, x = turned(x))
        if (cuts_.corner(x).is_reflex()) return turned(turned(x)) == h;
      return true;
    };
    const auto joins_corners = [&](int h) { // that have no such edge yet
      return cuts_.is_rounded(h) && number_of[source(h)] >= 0 && number_of[source(opposite(h))] >= 0;
    };
    const auto match = [&](int h) {
      stems_[source(h)] = h;
      stems_[source(opposite(h))] = opposite(h);
    };
    // edges that do not lead to another corner
    for (int v : corners) {
      int h = solid_.leaving[v];
      for (int k = 0; k < 3; ++k, h = turned(h))
        if (stems_[v] < 0 && may_end(h) && !is_corner(source(opposite(h)))) stems_[v] = h;
    }
    corners.erase(std::remove_if(corners.begin(), corners.end(), [&](int v) { return stems_[v] >= 0; }), corners.end());
    if (corners.empty()) return;
    for (std::size_t i = 0; i < corners.size(); ++i) number_of[corners[i]] = static_cast<int>(i);
    if (!match_one_direction(corners, joins_corners, may_end, match)) {
      typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> Graph;
      Graph graph(corners.size());
      std::vector<std::pair<double, int>> candidates;
      for (std::size_t i = 0; i < solid_.halfedges.size(); i += 2) {
        const int h = static_cast<int>(i), o = opposite(h);
        if (joins_corners(h) && may_end(h) && may_end(o))
          candidates.emplace_back(-(std::min)(least_sine(h), least_sine(o)), h);
      }
      std::sort(candidates.begin(), candidates.end());
      for (const auto& candidate : candidates)
        add_edge(number_of[source(candidate.second)], number_of[source(opposite(candidate.second))], graph);
      std::vector<boost::graph_traits<Graph>::vertex_descriptor> mates(corners.size());
      // from the matching that takes the best edges first
      boost::matching<Graph, boost::graph_traits<Graph>::vertex_descriptor*,
                      boost::property_map<Graph, boost::vertex_index_t>::const_type,
                      boost::edmonds_augmenting_path_finder, boost::greedy_matching, boost::no_matching_verifier>(
          graph, mates.data(), get(boost::vertex_index, graph));
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (mates[i] == boost::graph_traits<Graph>::null_vertex()) continue;
        int h = solid_.leaving[corners[i]]; // of two edges with the same ends, one that may
        for (int k = 0; k < 3; ++k, h = turned(h))
          if (source(opposite(h)) == corners[mates[i]] && joins_corners(h) && may_end(h) && may_end(opposite(h)) &&
              stems_[corners[i]] < 0)
            match(h);
      }
    }
    for (int v : corners) {
      if (stems_[v] >= 0) continue;
      int h = solid_.leaving[v];
      for (int k = 0; k < 3; ++k, h = turned(h))
        if (may_end(h) && (stems_[v] < 0 || least_sine(stems_[v]) < least_sine(h))) stems_[v] = h;
    }
  }

  // Returns for each corner the edge that ends at the chain of the two others, as it leaves; -1 at
  // other vertices.
  const std::vector<int>& stems() const { return stems_; }

private:
  int opposite(int h) const { return cuts_.opposite(h); }
  int source(int h) const { return cuts_.source(h); }
  int turned(int h) const { return cuts_.turned(h); }
  static double number(const FT& x) { return Cuts::number(x); }
  bool is_corner(int v) const { return cuts_.kind(v) == Cuts::Vertex_kind::corner; }

  // The smaller sine of the angles between an edge that leaves a vertex and the two others: where
  // it is small, an edge that ends there at the chain of these takes much room.
  double least_sine(int h) const {
    const auto sine = [&](int x) {
      const FT n = dot(cuts_.normal(x), cuts_.normal(x));
      return std::abs(number(cuts_.corner(x).size)) /
             std::sqrt(number(n) * number(cuts_.square(x)) * number(cuts_.square(turned(x))));
    };
    return (std::min)(sine(h), sine(turned(turned(h))));
  }

  template <class Joins, class May_end, class Match>
  bool match_one_direction(const std::vector<int>& corners, const Joins& joins, const May_end& may_end,
                           const Match& match) const {
    int first = solid_.leaving[corners[0]];
    for (int k = 0; k < 3; ++k, first = turned(first)) {
      const Vector d = solid_.direction(first);
      const auto chosen = [&](int h) {
        if (!joins(h) || !may_end(h) || !may_end(opposite(h))) return false;
        const Vector e = solid_.direction(h), x = cross_product(d, e);
        if constexpr (Cuts::in_floating_point)
          return dot(x, x) <= 1e-16 * dot(d, d) * dot(e, e);
        else
          return is_zero(x);
      };
      std::size_t count = 0;
      for (std::size_t h = 0; h < solid_.halfedges.size(); ++h) count += chosen(static_cast<int>(h));
      if (count != corners.size()) continue; // two such edges at one vertex are impossible
      for (std::size_t h = 0; h < solid_.halfedges.size(); h += 2)
        if (chosen(static_cast<int>(h))) match(static_cast<int>(h));
      return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_CHAIN_ENDS_H
