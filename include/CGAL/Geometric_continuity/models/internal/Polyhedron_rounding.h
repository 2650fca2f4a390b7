// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_ROUNDING_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_ROUNDING_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/models/internal/Chain_ends.h>
#include <CGAL/Geometric_continuity/models/internal/Polyhedron_cuts.h>
#include <CGAL/Geometric_continuity/models/internal/Rail_crossings.h>
#include <CGAL/Geometric_continuity/models/internal/Rounding_plane.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
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

// The cuts of a polyhedron with the chains of rounded edges, and their control points.
template <class FT> class Polyhedron_rounding : public Polyhedron_cuts<FT> {
  typedef Polyhedron_cuts<FT> Cuts;
  using Cuts::corners_;
  using Cuts::cuts_;
  using Cuts::in_floating_point;
  using Cuts::kinds_;
  using typename Cuts::Corner;

public:
  using typename Cuts::Solid;
  using typename Cuts::Vector;
  using typename Cuts::Vertex_kind;
  typedef std::array<Vector, 6> Column; // from the right side, 0, to the left one, 5

  // The control points of a rounded edge where it leaves a vertex.
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

  using Cuts::corner_of_rails;
  using Cuts::direction;
  using Cuts::face;
  using Cuts::is_rounded;
  using Cuts::kind;
  using Cuts::normal;
  using Cuts::number;
  using Cuts::opposite;
  using Cuts::planes;
  using Cuts::points;
  using Cuts::refuse;
  using Cuts::refuse_cuts;
  using Cuts::solid;
  using Cuts::source;
  using Cuts::square;
  using Cuts::turned;
  std::vector<Chain> chains;

  // A cut of 0 leaves an edge as it is. A fullness of 0 is chosen for each chain.
  Polyhedron_rounding(const Solid& s, std::vector<FT> cuts, double fullness)
      : Cuts(s, std::move(cuts)), stems_(Chain_ends<FT>(*this).stems()) {
    find_chains(fullness);
    find_positions();
    check_room();
    choose_turns();
    make_ends();
    for (Chain& chain : chains) make_seams(chain);
    const Rail_crossings<Polyhedron_rounding> crossings(*this);
    for (std::size_t f = 0; f < solid.faces.size(); ++f) crossings.check(static_cast<int>(f));
  }

  // Returns at a corner the edge that ends at the chain of the two others, as it leaves.
  int stem(int vertex) const { return stems_[vertex]; }
  const End& end(int halfedge) const { return ends_[halfedge]; }
  // Where an edge that stays sharp begins.
  Vector sharp_end(int h) const { return points[source(h)] + shortening_[h] * direction(h); }

private:
  static constexpr int most_halvings = in_floating_point ? 6 : 24; // see Rounding_plane

  std::vector<int> stems_;
  std::vector<int> chain_of_;                                    // of edges
  std::vector<FT> shortening_;                                   // of edges that stay sharp, where they leave
  std::vector<std::array<FT, 2>> rail_position_, edge_position_; // right and left, along the halfedge
  std::vector<double> turns_; // of corners: the size of the turn on the plane C, as a part of the greatest one
  std::vector<End> ends_;

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
    const Vertex_kind end = kinds_[source(h)];
    const int y = turned(h);
    if (!corners_[h].is_reflex() || end == Vertex_kind::corner) return;
    if (end == Vertex_kind::mitre && is_rounded(h) && is_rounded(y)) return;
    if (end == Vertex_kind::run_out && !is_rounded(h) && !is_rounded(y)) return;
    const int edge = solid.halfedges[is_rounded(h) ? h : y].edge;
    refuse(Error_code::incompatible_corner, edge,
           "its rounding cannot end at the vertex " + solid.point_text(source(h)) +
               ", where a face has an angle of more than 180 degrees; round " +
               solid.edge_text(solid.halfedges[is_rounded(h) ? y : h].edge) + " as well");
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
