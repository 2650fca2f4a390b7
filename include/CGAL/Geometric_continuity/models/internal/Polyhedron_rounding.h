// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_ROUNDING_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_ROUNDING_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/models/internal/Planar_solid.h>
#include <CGAL/Geometric_continuity/models/internal/Rounding_plane.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Polyhedron_rounding.h
/// The rounded edges of a polyhedron, as control points.
///
/// Rounded edges form chains. Where three of them meet at a vertex V, two go on as one chain and
/// the third one, m, ends at it. Let A and B be the faces beside m, C the third one, and a, b the
/// edges of the chain between A and C, and between C and B. Lines at the distance of the cuts meet
/// in the corners
///
///   K_A = V + t_A m + s_A a,  K_B = V + s_B b + t_B m,  K_C = V + x a + y b.
///
/// On the side of m the rail of the chain runs along the line through K_A, by a quintic curve on
/// the rounded edge m from K_A to K_B, and along the line through K_B. The rounded edge m is, in
/// the direction of m, the curve with the control points
///
///   V + s_A a (1, 1 - g/2, 1 - g), V + s_B b (1 - g, 1 - g/2, 1),
///
/// whose second derivative is zero at both ends, and which is C2 with the lines beside it. On the
/// plane C the rail turns by a curve of the same kind. The derivatives across the chain, T, have
/// directions in the planes; they are multiples of m along the edge m. They are constant to second
/// order where these curves begin and end, so that everything is C2 along the chain.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT> class Polyhedron_rounding {
public:
  typedef Planar_solid<FT> Solid;
  typedef typename Solid::Vector Vector;
  typedef std::array<Vector, 6> Column; // from the right side, 0, to the left one, 5
  enum class Vertex_kind { sharp, run_out, mitre, corner };

  // A rounded edge where it leaves a vertex.
  struct End {
    Column at;
    Column inward; // derivatives, where the chain is smooth or ends at another one
    bool is_smooth = false;
  };
  // Derivatives with respect to u.
  struct Seam {
    Column at, along;
  };
  struct Chain {
    std::vector<int> halfedges; // one after the other
    bool closed;
    double fullness = 0;
    // At both ends of each edge, in this order; the first one again at the end when it is closed.
    // From one to the next are the spans: of edges, and of the corners between these.
    std::vector<Seam> seams;
    std::vector<double> knots; // at the seams
    int number_of_spans() const { return static_cast<int>(seams.size()) - 1; }
  };

  const Solid& solid;
  std::vector<Rounding_plane<FT>> planes; // of the faces
  std::vector<Vector> points;             // where planes meet
  std::vector<Chain> chains;

  // A cut of 0 leaves an edge as it is. A fullness of 0 is chosen for each chain.
  Polyhedron_rounding(const Solid& s, std::vector<FT> cuts, double fullness) : solid(s), cuts_(std::move(cuts)) {
    check_vertices();
    find_planes();
    measure_corners();
    choose_ends_of_chains();
    find_chains(fullness);
    find_positions();
    check_room();
    choose_turns();
    make_ends();
    for (Chain& chain : chains) make_seams(chain);
    for (std::size_t f = 0; f < solid.faces.size(); ++f) check_rails(static_cast<int>(f));
  }

  bool is_rounded(int halfedge) const { return FT(0) < cuts_[solid.halfedges[halfedge].edge]; }
  Vertex_kind kind(int vertex) const { return kinds_[vertex]; }
  // At a corner, the edge that ends at the chain of the two others, as it leaves.
  int stem(int vertex) const { return stems_[vertex]; }
  const End& end(int halfedge) const { return ends_[halfedge]; }
  int opposite(int h) const { return solid.halfedges[h].opposite; }
  int source(int h) const { return solid.halfedges[h].source; }
  int turned(int h) const { return solid.turned(h); }
  // Where an edge that stays sharp begins.
  Vector sharp_end(int h) const { return points[source(h)] + shortening_[h] * direction(h); }

private:
  static constexpr bool in_floating_point = std::is_floating_point_v<FT>;
  static constexpr int most_halvings = in_floating_point ? 6 : 24; // see Rounding_plane

  // K = V + along x + across y in the face of x, where y = turned(x).
  struct Corner {
    FT size; // the determinant N . (x, y)
    FT along, across;
    bool is_reflex() const { return size < FT(0); }
  };

  std::vector<FT> cuts_;
  std::vector<Vertex_kind> kinds_;
  std::vector<int> stems_;
  std::vector<FT> widths_; // of halfedges: the cut times |N x direction|
  std::vector<Corner> corners_;
  std::vector<int> chain_of_;                                    // of edges
  std::vector<FT> shortening_;                                   // of edges that stay sharp, where they leave
  std::vector<std::array<FT, 2>> rail_position_, edge_position_; // right and left, along the halfedge
  std::vector<double> turns_; // of corners: the size of the turn on the plane C, as a part of the greatest one
  std::vector<End> ends_;

  static double number(const FT& x) { return rounded_number(x); }
  Vector direction(int h) const { return points[solid.target(h)] - points[source(h)]; }
  int face(int h) const { return solid.halfedges[h].face; }
  FT square(int h) const {
    const Vector x = direction(h);
    return dot(x, x);
  }

  [[noreturn]] void refuse(Error_code code, int edge, const std::string& text) const {
    throw Error(code, "round_polyhedron: " + solid.edge_text(edge) + ": " + text);
  }
  [[noreturn]] void refuse_vertex(Error_code code, int vertex, const std::string& text) const {
    throw Error(code, "round_polyhedron: the vertex " + solid.point_text(vertex) + ": " + text);
  }

  void check_vertices() {
    for (std::size_t e = 0; e < cuts_.size(); ++e)
      if (!(FT(0) < cuts_[e]) && cuts_[e] != FT(0))
        refuse(Error_code::parameter_outside_domain, static_cast<int>(e), "its set-back is negative");
    kinds_.assign(solid.points.size(), Vertex_kind::sharp);
    for (std::size_t v = 0; v < kinds_.size(); ++v) {
      if (solid.leaving[v] < 0) continue;
      int h = solid.leaving[v], rounded = 0;
      do rounded += is_rounded(h), h = turned(h);
      while (h != solid.leaving[v]);
      const int vertex = static_cast<int>(v), degree = solid.degree(vertex);
      if (rounded > 0 && degree != 3)
        refuse_vertex(Error_code::not_a_manifold, vertex,
                      std::to_string(degree) + " edges meet there; edges are rounded where three meet, so leave all " +
                          std::to_string(degree) + " sharp");
      kinds_[v] = static_cast<Vertex_kind>(rounded);
    }
  }

  // In floating point, points are where the short planes meet.
  void find_planes() {
    double largest = 0;
    for (const Vector& p : solid.points)
      for (const FT& x : p) largest = (std::max)(largest, std::abs(number(x)));
    FT unit(1);
    if constexpr (in_floating_point) unit = grid_unit(largest);
    points = solid.points;
    for (const typename Solid::Face& f : solid.faces) {
      const int first = f.loops[0];
      Vector origin = points[source(first)];
      if constexpr (in_floating_point) {
        FT height(0);
        int count = 0;
        for (int loop : f.loops) {
          int h = loop;
          do height += dot(f.normal, points[source(h)] - origin), ++count, h = solid.halfedges[h].next;
          while (h != loop);
        }
        origin += height / (count * dot(f.normal, f.normal)) * f.normal;
      }
      planes.emplace_back(origin, f.normal, solid.direction(first), unit);
    }
    if constexpr (in_floating_point)
      for (std::size_t v = 0; v < points.size(); ++v)
        if (kinds_[v] != Vertex_kind::sharp) meet(static_cast<int>(v));
  }

  // Moves a point to where its three planes meet.
  void meet(int v) {
    const int h[3] = {solid.leaving[v], turned(solid.leaving[v]), turned(turned(solid.leaving[v]))};
    Vector n[3], move(3);
    FT height[3];
    for (int i = 0; i < 3; ++i) {
      const Rounding_plane<FT>& plane = planes[face(h[i])];
      n[i] = FT(1) / CGAL::sqrt(dot(plane.normal(), plane.normal())) * plane.normal();
      height[i] = dot(n[i], plane.origin() - points[v]);
    }
    const FT volume = dot(n[0], cross_product(n[1], n[2]));
    for (int i = 0; i < 3; ++i) move += height[i] / volume * cross_product(n[(i + 1) % 3], n[(i + 2) % 3]);
    if (!(dot(move, move) <= 100 * solid.tolerance() * solid.tolerance()))
      refuse_vertex(Error_code::singular_frame, v, "the planes of its faces do not meet near to it");
    points[v] += move;
  }

  // The length of a vector; if it is not rational, a short number next to it.
  static FT length(const Vector& x) {
    const FT squared = dot(x, x);
    if constexpr (in_floating_point)
      return std::sqrt(squared);
    else {
      if constexpr (has_rational_roots<FT>())
        if (const std::optional<FT> root = rational_square_root(squared)) return *root;
      return short_number_in<FT>(short_double<24>(std::sqrt(number(squared))));
    }
  }

  const Vector& normal(int h) const { return solid.faces[face(h)].normal; }

  void measure_corners() {
    const std::size_t n = solid.halfedges.size();
    for (std::size_t i = 0; i < n; ++i) {
      const int h = static_cast<int>(i);
      widths_.push_back(is_rounded(h) ? FT(cuts_[i / 2] * length(cross_product(normal(h), direction(h)))) : FT(0));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const int x = static_cast<int>(i), y = turned(x);
      Corner c{FT(0), FT(0), FT(0)};
      if (kinds_[source(x)] != Vertex_kind::sharp) {
        const Vector across = cross_product(direction(x), direction(y));
        c.size = dot(normal(x), across);
        if (std::abs(number(c.size)) <= 1e-9 * std::sqrt(number(square(x)) * number(square(y))))
          refuse_vertex(Error_code::singular_frame, source(x), "two edges of one face go on in a straight line there");
        c.along = widths_[opposite(y)] / c.size;
        c.across = widths_[x] / c.size;
      }
      corners_.push_back(c);
    }
  }

  // The edge opposite to a reflex angle of a face ends at the chain of the two others. Elsewhere
  // edges are chosen that end at both their vertices, as far as possible: a matching, so that
  // chains are closed. Where the edges of one direction are one, as in prisms, it is taken.
  void choose_ends_of_chains() {
    stems_.assign(solid.points.size(), -1);
    std::vector<int> corners, number_of(solid.points.size(), -1);
    for (std::size_t v = 0; v < kinds_.size(); ++v)
      if (kinds_[v] == Vertex_kind::corner) corners.push_back(static_cast<int>(v));
    const auto may_end = [&](int h) { // at its source
      int x = solid.leaving[source(h)];
      for (int i = 0; i < 3; ++i, x = turned(x))
        if (corners_[x].is_reflex()) return turned(turned(x)) == h;
      return true;
    };
    const auto joins_corners = [&](int h) { // that have no such edge yet
      return is_rounded(h) && number_of[source(h)] >= 0 && number_of[source(opposite(h))] >= 0;
    };
    const auto match = [&](int h) {
      stems_[source(h)] = h;
      stems_[source(opposite(h))] = opposite(h);
    };
    // edges that do not lead to another corner
    for (int v : corners) {
      int h = solid.leaving[v];
      for (int k = 0; k < 3; ++k, h = turned(h))
        if (stems_[v] < 0 && may_end(h) && kinds_[source(opposite(h))] != Vertex_kind::corner) stems_[v] = h;
    }
    corners.erase(std::remove_if(corners.begin(), corners.end(), [&](int v) { return stems_[v] >= 0; }), corners.end());
    if (corners.empty()) return;
    for (std::size_t i = 0; i < corners.size(); ++i) number_of[corners[i]] = static_cast<int>(i);
    if (!match_one_direction(corners, joins_corners, may_end, match)) {
      typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> Graph;
      Graph graph(corners.size());
      std::vector<std::pair<double, int>> candidates;
      for (std::size_t i = 0; i < solid.halfedges.size(); i += 2) {
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
        int h = solid.leaving[corners[i]]; // of two edges with the same ends, one that may
        for (int k = 0; k < 3; ++k, h = turned(h))
          if (source(opposite(h)) == corners[mates[i]] && joins_corners(h) && may_end(h) && may_end(opposite(h)) &&
              stems_[corners[i]] < 0)
            match(h);
      }
    }
    for (int v : corners) {
      if (stems_[v] >= 0) continue;
      int h = solid.leaving[v];
      for (int k = 0; k < 3; ++k, h = turned(h))
        if (may_end(h) && (stems_[v] < 0 || least_sine(stems_[v]) < least_sine(h))) stems_[v] = h;
    }
  }

  // The smaller sine of the angles between an edge that leaves a vertex and the two others: where
  // it is small, an edge that ends there at the chain of these takes much room.
  double least_sine(int h) const {
    const auto sine = [&](int x) {
      const FT n = dot(normal(x), normal(x));
      return std::abs(number(corners_[x].size)) / std::sqrt(number(n) * number(square(x)) * number(square(turned(x))));
    };
    return (std::min)(sine(h), sine(turned(turned(h))));
  }

  template <class Joins, class May_end, class Match>
  bool match_one_direction(const std::vector<int>& corners, const Joins& joins, const May_end& may_end,
                           const Match& match) const {
    int first = solid.leaving[corners[0]];
    for (int k = 0; k < 3; ++k, first = turned(first)) {
      const Vector d = solid.direction(first);
      const auto chosen = [&](int h) {
        if (!joins(h) || !may_end(h) || !may_end(opposite(h))) return false;
        const Vector e = solid.direction(h), x = cross_product(d, e);
        if constexpr (in_floating_point)
          return dot(x, x) <= 1e-16 * dot(d, d) * dot(e, e);
        else
          return is_zero(x);
      };
      std::size_t count = 0;
      for (std::size_t h = 0; h < solid.halfedges.size(); ++h) count += chosen(static_cast<int>(h));
      if (count != corners.size()) continue; // two such edges at one vertex are impossible
      for (std::size_t h = 0; h < solid.halfedges.size(); h += 2)
        if (chosen(static_cast<int>(h))) match(static_cast<int>(h));
      return true;
    }
    return false;
  }

  // The next edge of the chain of an edge that leaves a vertex, as it leaves; or -1.
  int beyond(int h) const {
    if (kinds_[source(h)] != Vertex_kind::corner) return -1;
    const int m = stems_[source(h)], a = turned(m), b = turned(a);
    return h == a ? b : h == b ? a : -1;
  }

  void find_chains(double fullness) {
    chain_of_.assign(cuts_.size(), -1);
    const auto follow = [&](int first, bool closed) {
      Chain chain{{}, closed, 0, {}, {}};
      for (int h = first; h >= 0 && chain_of_[solid.halfedges[h].edge] < 0; h = beyond(opposite(h))) {
        chain.halfedges.push_back(h);
        chain_of_[solid.halfedges[h].edge] = static_cast<int>(chains.size());
      }
      chain.fullness = fullness > 0 ? short_double<8>(fullness) : fair_fullness(chain.halfedges);
      chains.push_back(std::move(chain));
    };
    for (bool closed : {false, true})
      for (std::size_t i = 0; i < solid.halfedges.size(); ++i) {
        const int h = static_cast<int>(i);
        if (is_rounded(h) && chain_of_[i / 2] < 0 && (closed || beyond(h) < 0)) follow(h, closed);
      }
  }

  // With g the control points are the parts 1, 1 - g/2 and 1 - g of the cuts. That with the least
  // integral of the square of the derivative of the curvature is, up to one per cent,
  //
  //   g = 4/5 (1 - y / (5.45 - 3.6 y)),  y = (1 + cos t) / 2,
  //
  // where t is the angle between the cuts, 180 degrees in a plane; on the mean of all edges.
  double fair_fullness(const std::vector<int>& halfedges) const {
    double sum = 0;
    for (int h : halfedges) {
      const Vector &n = normal(h), &m = normal(opposite(h));
      const double cosine = number(dot(n, m)) / std::sqrt(number(dot(n, n)) * number(dot(m, m)));
      sum += (1 - cosine) / 2;
    }
    const double y = sum / static_cast<double>(halfedges.size());
    return std::round(128 * 0.8 * (1 - y / (5.45 - 3.6 * y))) / 128;
  }

  // The points of rails and of edges at both ends of each edge, as scalar products with it.
  void find_positions() {
    const std::size_t n = solid.halfedges.size();
    shortening_.assign(n, FT(0));
    rail_position_.assign(n, {FT(0), FT(0)});
    edge_position_.assign(n, {FT(0), FT(0)});
    for (std::size_t v = 0; v < kinds_.size(); ++v) {
      if (kinds_[v] == Vertex_kind::sharp) continue;
      int h = solid.leaving[v];
      for (int k = 0; k < 3; ++k, h = turned(h)) check_corner(h);
      for (int k = 0; k < 3; ++k, h = turned(h)) {
        const int left = turned(h), right = turned(left); // right, h and left follow each other
        const Corner &at_left = corners_[h], &at_right = corners_[right];
        if (!is_rounded(h)) {
          shortening_[h] = kinds_[v] == Vertex_kind::mitre ? FT(FT(at_left.along + at_right.across) / FT(2))
                           : is_rounded(left)              ? at_left.along
                                                           : at_right.across;
          continue;
        }
        const Vector x = direction(h);
        rail_position_[h] = {dot(at_right.along * direction(right) + at_right.across * x, x),
                             dot(at_left.along * x + at_left.across * direction(left), x)};
        if (kinds_[v] != Vertex_kind::corner) continue;
        const int m = stems_[v], a = turned(m), b = turned(a);
        const FT xx = dot(x, x);
        if (h == m)
          edge_position_[h] = {FT(corners_[b].across * xx), FT(corners_[m].along * xx)};
        else {
          const FT s = h == a ? corners_[m].across : corners_[b].along;
          edge_position_[h] = {FT(s * xx), FT(s * xx)};
        }
      }
    }
  }

  // Edges end at faces, and edges that stay sharp at rounded ones, only where angles are less than
  // 180 degrees.
  void check_corner(int h) const {
    const Vertex_kind kind = kinds_[source(h)];
    const int y = turned(h);
    if (!corners_[h].is_reflex() || kind == Vertex_kind::corner) return;
    if (kind == Vertex_kind::mitre && is_rounded(h) && is_rounded(y)) return;
    if (kind == Vertex_kind::run_out && !is_rounded(h) && !is_rounded(y)) return;
    const int edge = solid.halfedges[is_rounded(h) ? h : y].edge;
    refuse(Error_code::incompatible_corner, edge,
           "its rounding cannot end at the vertex " + solid.point_text(source(h)) +
               ", where a face has an angle of more than 180 degrees; round " +
               solid.edge_text(solid.halfedges[is_rounded(h) ? y : h].edge) + " as well");
  }

  std::string text(const FT& x) const {
    std::ostringstream os;
    os << number(x);
    if constexpr (!in_floating_point) {
      std::ostringstream exact;
      exact << x;
      if (exact.str() != os.str() && exact.str().size() <= 40) os << " (exactly " << exact.str() << ')';
    }
    return os.str();
  }

  // All cuts must be smaller than `factor` times what they are.
  [[noreturn]] void refuse_cuts(int edge, const FT& factor, const std::string& reason) const {
    FT least(0), greatest(0);
    for (const FT& x : cuts_)
      if (FT(0) < x) {
        if (least == FT(0) || x < least) least = x;
        if (greatest < x) greatest = x;
      }
    refuse(Error_code::parameter_outside_domain, edge,
           reason + (least == greatest
                         ? "; the set-back " + text(least) + " must be less than " + text(FT(factor * least))
                         : "; all set-backs together must be less than " + text(factor) + " times as large"));
  }

  void check_room() const {
    // by the least of all bounds
    std::optional<FT> bound;
    int worst = 0;
    const char* reason = "";
    const auto demand = [&](int h, const FT& used, const FT& available, const char* what) {
      if (!(FT(0) < used) || used < available) return;
      const FT factor = available / used;
      if (bound && !(factor < *bound)) return;
      bound = factor;
      worst = h / 2;
      reason = what;
    };
    for (std::size_t i = 0; i < solid.halfedges.size(); i += 2) {
      const int h = static_cast<int>(i), o = opposite(h);
      if (!is_rounded(h)) {
        demand(h, FT(shortening_[h] + shortening_[o]), FT(1), "the roundings at its ends meet on it");
        continue;
      }
      const FT g = short_number_in<FT>(chains[chain_of_[i / 2]].fullness), xx = square(h);
      for (int side : {0, 1}) {
        const FT rail = rail_position_[h][side] + rail_position_[o][1 - side],
                 edge = edge_position_[h][side] + edge_position_[o][1 - side];
        demand(h, rail, xx, "the cuts at its ends meet on a face beside it");
        demand(h, FT(FT(1) - g) * rail + g * edge, xx, "the roundings at its ends meet");
      }
    }
    if (bound) refuse_cuts(worst, *bound, reason);
  }

  // The turn on the plane C, as a multiple of s_A a and s_B b, or where C has a reflex angle, of
  // (s_A - x) a and (s_B - y) b, which go straight across from the other rail.
  std::array<FT, 2> greatest_turn(int v) const {
    const int m = stems_[v], a = turned(m), b = turned(a);
    const Corner& c = corners_[a];
    std::array<FT, 2> turn{corners_[m].across, corners_[b].along};
    if (c.is_reflex()) {
      turn[0] = FT(turn[0] - c.along);
      turn[1] = FT(turn[1] - c.across);
    }
    return turn;
  }

  // The part of the greatest turn for which there is room on both edges beside it.
  void choose_turns() {
    turns_.assign(kinds_.size(), 1);
    const auto turn_of = [&](int h, int side) { // how much it takes of the edge that leaves
      const int v = source(h);
      if (kinds_[v] != Vertex_kind::corner) return 0.;
      const int a = turned(stems_[v]), b = turned(a);
      if (h == a && side == 1) return number(greatest_turn(v)[0]);
      if (h == b && side == 0) return number(greatest_turn(v)[1]);
      return 0.;
    };
    for (std::size_t i = 0; i < solid.halfedges.size(); ++i) {
      const int h = static_cast<int>(i), o = opposite(h);
      if (!is_rounded(h)) continue;
      for (int side : {0, 1}) {
        const double here = turn_of(h, side), there = turn_of(o, 1 - side);
        if (here == 0) continue;
        const double room =
            number(FT(square(h) - rail_position_[h][side] - rail_position_[o][1 - side])) / number(square(h));
        double& turn = turns_[source(h)];
        turn = (std::min)(turn, 0.75 * room / (here + there));
      }
    }
    for (double& x : turns_)
      if (x > 0 && x < 1) { // rounded down to six binary digits
        int exponent;
        const double mantissa = std::frexp(x, &exponent);
        x = std::ldexp(std::floor(64 * mantissa) / 64, exponent);
      }
  }

  const Rounding_plane<FT>& plane(int h) const { return planes[face(h)]; }

  // Sets the points of one side of an end, from the rail at p towards the edge at e.
  void set_side(End& end, int side, const Rounding_plane<FT>& plane, const Vector& p, const Vector& e,
                const Vector& inward, double fullness) const {
    const Vector rail = plane.point(p), across = plane.vector(e - rail), along = plane.vector(inward);
    const FT g = short_number_in<FT>(fullness);
    const FT parts[3] = {FT(0), FT(g / FT(2)), g};
    for (int j = 0; j < 3; ++j) {
      const std::size_t row = static_cast<std::size_t>(side == 0 ? j : 5 - j);
      end.at[row] = rail + parts[j] * across;
      end.inward[row] = along;
    }
  }

  double fullness(int h) const { return chains[chain_of_[solid.halfedges[h].edge]].fullness; }

  void make_ends() {
    ends_.resize(solid.halfedges.size());
    for (std::size_t v = 0; v < kinds_.size(); ++v) {
      const int vertex = static_cast<int>(v);
      if (kinds_[v] == Vertex_kind::corner)
        make_corner(vertex);
      else if (kinds_[v] != Vertex_kind::sharp) {
        int h = solid.leaving[v];
        for (int k = 0; k < 3; ++k, h = turned(h))
          if (is_rounded(h)) make_sharp_end(h);
      }
    }
  }

  void make_corner(int v) {
    const Vector& p = points[v];
    const int m = stems_[v], a = turned(m), b = turned(a);
    const Vector to_m = direction(m), to_a = direction(a), to_b = direction(b);
    const Corner &in_a = corners_[m], &in_c = corners_[a], &in_b = corners_[b];
    const FT turn = short_number_in<FT>(turns_[v]), of_m = short_number_in<FT>(fullness(m));
    const std::array<FT, 2> greatest = greatest_turn(v);
    const FT turn_a = turn * greatest[0], turn_b = turn * greatest[1];
    const Vector edge_a = p + in_a.across * to_a, edge_b = p + in_b.along * to_b;

    End &end_a = ends_[a], &end_b = ends_[b], &end_m = ends_[m];
    const double g = fullness(a);
    set_side(end_a, 1, plane(a), p + FT(in_c.along + turn_a) * to_a + in_c.across * to_b, edge_a,
             FT(of_m * turn_a) * to_a, g);
    set_side(end_a, 0, plane(m), edge_a + in_a.along * to_m, edge_a, FT(of_m * in_a.across) * to_a, g);
    set_side(end_b, 1, plane(b), edge_b + in_b.across * to_m, edge_b, FT(of_m * in_b.along) * to_b, g);
    set_side(end_b, 0, plane(a), p + in_c.along * to_a + FT(in_c.across + turn_b) * to_b, edge_b,
             FT(of_m * turn_b) * to_b, g);
    end_a.is_smooth = end_b.is_smooth = end_m.is_smooth = true;

    // the chain of m ends with the rail of the other one, and with its derivatives across
    const auto take = [&](std::size_t rail, const Vector& at, const Vector& along, const Vector& across) {
      const FT half = FT(1) / FT(2);
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t row = rail == 0 ? j : 5 - j;
        end_m.at[row] = at - FT(FT(static_cast<int>(j)) * half) * along;
        end_m.inward[row] = FT(-1) * across;
      }
    };
    take(5, end_a.at[0], end_a.inward[0], plane(m).vector(edge_a - end_a.at[0]));
    take(0, end_b.at[5], end_b.inward[5], plane(b).vector(edge_b - end_b.at[5]));
  }

  // Where a chain runs out, or breaks at an edge that stays sharp.
  void make_sharp_end(int h) {
    const Vector& p = points[source(h)];
    const int left = turned(h), right = turned(left);
    set_side(ends_[h], 1, plane(h), is_rounded(left) ? corner_of_rails(h) : sharp_end(left), p, Vector(3), fullness(h));
    set_side(ends_[h], 0, plane(right), is_rounded(right) ? corner_of_rails(right) : sharp_end(right), p, Vector(3),
             fullness(h));
  }
  // K on the face of h, next to its source.
  Vector corner_of_rails(int h) const {
    return points[source(h)] + corners_[h].along * direction(h) + corners_[h].across * direction(turned(h));
  }

  // A part of what bounds a face: along the edge h, or at its source, where rails turn or the
  // rounding of another edge ends.
  typedef std::array<FT, 2> Flat_point;
  struct Rail {
    int h;
    bool turns;
    Flat_point start, end;
    std::array<double, 2> lower, upper;
  };

  // The points at the parameters 0, 1/8, 2/8, ..., 1 of the curve in which a rounding ends.
  static std::vector<Vector> points_of_end(const Column& control_points) {
    std::vector<Vector> result;
    for (int k = 0; k <= 8; ++k) {
      const FT t = FT(FT(k) / FT(8));
      Column c = control_points;
      for (std::size_t n = 5; n > 0; --n)
        for (std::size_t i = 0; i < n; ++i) c[i] += t * (c[i + 1] - c[i]);
      result.push_back(c[0]);
    }
    return result;
  }

  // Convex faces have no rails that cross each other where those of each edge have room.
  void check_rails(int f) const {
    const typename Solid::Face& face = solid.faces[f];
    bool is_convex = face.loops.size() == 1;
    std::vector<Rail> rails;
    std::vector<std::vector<Flat_point>> edges(face.loops.size()), outlines(face.loops.size()); // without cuts and with
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(number(face.normal[axis])) < std::abs(number(face.normal[k]))) axis = k;
    const auto flat = [&](const Vector& p) { return Flat_point{p[(axis + 1) % 3], p[(axis + 2) % 3]}; };
    const auto add = [&](int h, bool turns, const Vector& start, const Vector& end) {
      Rail r{h, turns, flat(start), flat(end), {}, {}};
      for (std::size_t k = 0; k < 2; ++k)
        std::tie(r.lower[k], r.upper[k]) = std::minmax({number(r.start[k]), number(r.end[k])});
      rails.push_back(r);
    };
    for (std::size_t i = 0; i < face.loops.size(); ++i) {
      int h = face.loops[i];
      do {
        is_convex = is_convex && FT(0) < dot(face.normal, cross_product(direction(h), direction(turned(h))));
        const auto from = [&](int x) { return is_rounded(x) ? ends_[x].at[5] : sharp_end(x); };
        const auto to = [&](int x) { return is_rounded(x) ? ends_[opposite(x)].at[0] : sharp_end(opposite(x)); };
        const Vector start = from(h), before = to(solid.halfedges[h].previous);
        edges[i].push_back(flat(points[source(h)]));
        if (const int rounded = turned(turned(h)); ends_at_face(h)) {
          const std::vector<Vector> curve = points_of_end(ends_[rounded].at);
          for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
            add(h, true, curve[k], curve[k + 1]);
            outlines[i].push_back(flat(curve[k]));
          }
        } else
          outlines[i].push_back(flat(before));
        outlines[i].push_back(flat(start));
        add(h, false, start, to(h));
        if (kinds_[source(h)] == Vertex_kind::corner && h == turned(stems_[source(h)])) {
          const Vector tip = corner_of_rails(h);
          add(h, true, before, start);
          add(h, true, before, tip);
          add(h, true, tip, start);
        }
        h = solid.halfedges[h].next;
      } while (h != face.loops[i]);
    }
    if (is_convex) return;
    std::sort(rails.begin(), rails.end(), [](const Rail& x, const Rail& y) { return x.lower[0] < y.lower[0]; });
    for (std::size_t i = 0; i < rails.size(); ++i)
      for (std::size_t j = i + 1; j < rails.size() && rails[j].lower[0] <= rails[i].upper[0]; ++j)
        if (!are_neighbours(rails[i], rails[j]) && rails[j].lower[1] <= rails[i].upper[1] &&
            rails[i].lower[1] <= rails[j].upper[1] && meet(rails[i], rails[j]))
          refuse_crossing(rails[i], rails[j]);
    // what does not cross may still have passed a hole
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      int before = 0, after = 0;
      for (std::size_t j = 0; j < outlines.size(); ++j)
        if (j != i) {
          before += winding_number(edges[j], edges[i][0]);
          after += winding_number(outlines[j], outlines[i][0]);
        }
      if (before != after)
        refuse(Error_code::parameter_outside_domain, solid.halfedges[face.loops[i]].edge,
               "a cut of this face reaches beyond the boundary to which it belongs; take smaller set-backs");
    }
  }

  // Tells whether the rounding of the third edge at the source of an edge ends at the face of this
  // one.
  bool ends_at_face(int h) const {
    return kinds_[source(h)] == Vertex_kind::run_out && !is_rounded(h) && !is_rounded(turned(h));
  }

  // How often a polygon goes around a point that does not lie on it.
  static int winding_number(const std::vector<Flat_point>& polygon, const Flat_point& p) {
    int result = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Flat_point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const bool rises = a[1] <= p[1] && p[1] < b[1], falls = b[1] <= p[1] && p[1] < a[1];
      if (!rises && !falls) continue;
      const FT side = FT(b[0] - a[0]) * FT(p[1] - a[1]) - FT(b[1] - a[1]) * FT(p[0] - a[0]);
      if (rises && FT(0) < side) ++result;
      if (falls && side < FT(0)) --result;
    }
    return result;
  }

  bool are_neighbours(const Rail& x, const Rail& y) const {
    const auto next = [&](int h) { return solid.halfedges[h].next; };
    if (x.h == y.h) return true;
    if (x.turns && y.turns) return false;
    if (x.turns) return next(y.h) == x.h;
    if (y.turns) return next(x.h) == y.h;
    return next(x.h) == y.h || next(y.h) == x.h;
  }
  static bool meet(const Rail& x, const Rail& y) {
    const auto side = [](const Rail& r, const Flat_point& p) {
      const FT d =
          FT(r.end[0] - r.start[0]) * FT(p[1] - r.start[1]) - FT(r.end[1] - r.start[1]) * FT(p[0] - r.start[0]);
      return d < FT(0) ? -1 : FT(0) < d ? 1 : 0;
    };
    return side(x, y.start) * side(x, y.end) <= 0 && side(y, x.start) * side(y, x.end) <= 0;
  }
  // The corner of rails V + c k and the line at the distance c w from another edge meet for one
  // factor c of all cuts.
  [[noreturn]] void refuse_crossing(const Rail& x, const Rail& y) const {
    for (const auto& [end, other] : {std::make_pair(x, y), std::make_pair(y, x)})
      if (end.turns && ends_at_face(end.h))
        refuse(Error_code::parameter_outside_domain, solid.halfedges[turned(turned(end.h))].edge,
               "the face where its rounding ends has no room for it at " +
                   solid.edge_text(solid.halfedges[other.h].edge) + "; take a smaller set-back");
    const int g = x.h, h = y.h;
    std::optional<FT> bound;
    const auto approach = [&](int corner, int line) {
      const Vector across = cross_product(normal(line), direction(line)),
                   k = corner_of_rails(corner) - points[source(corner)];
      const FT speed = widths_[line] - dot(k, across), way = dot(points[source(corner)] - points[source(line)], across);
      if (!(FT(0) < speed) || !(FT(0) < way)) return;
      const FT factor = way / speed;
      if (factor <= FT(1) && (!bound || factor < *bound)) bound = factor;
    };
    for (const auto& [of, line] : {std::make_pair(g, h), std::make_pair(h, g)}) {
      approach(of, line);
      approach(solid.halfedges[of].next, line);
    }
    const std::string reason =
        "its cut meets that of " + solid.edge_text(solid.halfedges[h].edge) + " on the face between them";
    if (bound) refuse_cuts(solid.halfedges[g].edge, *bound, reason);
    refuse(Error_code::parameter_outside_domain, solid.halfedges[g].edge, reason + "; take smaller set-backs");
  }

  static Column mirrored(Column c) {
    std::reverse(c.begin(), c.end());
    return c;
  }

  void make_seams(Chain& chain) const {
    double knot = 0;
    for (std::size_t k = 0; k < chain.halfedges.size(); ++k) {
      const int h = chain.halfedges[k], o = opposite(h);
      const double length = length_of_span(h);
      const End &from = ends_[h], &to = ends_[o];
      Seam first{from.at, from.inward}, second{mirrored(to.at), mirrored(to.inward)};
      for (std::size_t j = 0; j < 6; ++j) second.along[j] *= FT(-1);
      // ends without a derivative have one for which control points are evenly spaced
      const FT part = short_number_in<FT>(0.375 / length);
      for (std::size_t j = 0; j < 6; ++j) {
        const Vector along = plane(j < 3 ? o : h).vector(part * (second.at[j] - first.at[j]));
        if (!from.is_smooth) first.along[j] = along;
        if (!to.is_smooth) second.along[j] = along;
      }
      chain.seams.push_back(std::move(first));
      chain.knots.push_back(knot);
      chain.seams.push_back(std::move(second));
      chain.knots.push_back(knot += length);
      knot += 1; // of the turn
    }
    if (!chain.closed) return;
    const Seam again = chain.seams.front();
    chain.seams.push_back(again);
    chain.knots.push_back(knot);
  }

  // A power of two for which the control points of an edge do not pass each other; for long edges
  // one for which the speed along them is about that of the turns.
  double length_of_span(int h) const {
    const End &from = ends_[h], &to = ends_[opposite(h)];
    const Vector x = direction(h);
    double most = 1024;
    for (std::size_t j = 0; j < 6; ++j) {
      const double room = number(dot(to.at[5 - j] - from.at[j], x)) * (from.is_smooth && to.is_smooth ? 1 : 0.625),
                   used = (from.is_smooth ? number(dot(from.inward[j], x)) : 0) -
                          (to.is_smooth ? number(dot(to.inward[5 - j], x)) : 0);
      most = (std::min)(most, used > 0 ? room / used : 1);
    }
    double length = 1;
    while (2 * length <= 0.85 * most) length *= 2;
    for (int k = 0; k < most_halvings && length > most * (1 + 1e-9); ++k) length /= 2;
    if (length > most * (1 + 1e-9))
      refuse(Error_code::parameter_outside_domain, solid.halfedges[h].edge,
             "the roundings at its ends nearly meet; take smaller set-backs");
    return length;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_ROUNDING_H
