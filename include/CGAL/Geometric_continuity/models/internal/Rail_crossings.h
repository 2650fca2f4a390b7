// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_RAIL_CROSSINGS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_RAIL_CROSSINGS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// \file Rail_crossings.h
/// The rails between which the rest of a face lies when its edges are rounded do not cross each
/// other.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Refuses cuts of a rounding whose rails cross on a face. `Rounding` is a Polyhedron_rounding.
template <class Rounding> class Rail_crossings {
  typedef typename Rounding::Solid Solid;
  typedef typename Rounding::Vector Vector;
  typedef typename Rounding::Column Column;
  typedef typename Rounding::Vertex_kind Vertex_kind;
  typedef typename Rounding::FT FT;

  const Rounding& r_;

public:
  explicit Rail_crossings(const Rounding& rounding) : r_(rounding) {}

  // Convex faces have no rails that cross each other where those of each edge have room.
  void check(int f) const {
    const typename Solid::Face& face = r_.solid.faces[f];
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
        is_convex = is_convex && FT(0) < dot(face.normal, cross_product(r_.direction(h), r_.direction(r_.turned(h))));
        const auto from = [&](int x) { return r_.is_rounded(x) ? r_.end(x).at[5] : r_.sharp_end(x); };
        const auto to = [&](int x) {
          return r_.is_rounded(x) ? r_.end(r_.opposite(x)).at[0] : r_.sharp_end(r_.opposite(x));
        };
        const Vector start = from(h), before = to(r_.solid.halfedges[h].previous);
        edges[i].push_back(flat(r_.points[r_.source(h)]));
        if (const int rounded = r_.turned(r_.turned(h)); ends_at_face(h)) {
          const std::vector<Vector> curve = points_of_end(r_.end(rounded).at);
          for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
            add(h, true, curve[k], curve[k + 1]);
            outlines[i].push_back(flat(curve[k]));
          }
        } else
          outlines[i].push_back(flat(before));
        outlines[i].push_back(flat(start));
        add(h, false, start, to(h));
        if (r_.kind(r_.source(h)) == Vertex_kind::corner && h == r_.turned(r_.stem(r_.source(h)))) {
          const Vector tip = r_.corner_of_rails(h);
          add(h, true, before, start);
          add(h, true, before, tip);
          add(h, true, tip, start);
        }
        h = r_.solid.halfedges[h].next;
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
        r_.refuse(Error_code::parameter_outside_domain, r_.solid.halfedges[face.loops[i]].edge,
                  "a cut of this face reaches beyond the boundary to which it belongs; take smaller set-backs");
    }
  }

private:
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

  static double number(const FT& x) { return Rounding::number(x); }

  // Tells whether the rounding of the third edge at the source of an edge ends at the face of this
  // one.
  bool ends_at_face(int h) const {
    return r_.kind(r_.source(h)) == Vertex_kind::run_out && !r_.is_rounded(h) && !r_.is_rounded(r_.turned(h));
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
    const auto next = [&](int h) { return r_.solid.halfedges[h].next; };
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
        r_.refuse(Error_code::parameter_outside_domain, r_.solid.halfedges[r_.turned(r_.turned(end.h))].edge,
                  "the face where its rounding ends has no room for it at " +
                      r_.solid.edge_text(r_.solid.halfedges[other.h].edge) + "; take a smaller set-back");
    const int g = x.h, h = y.h;
    std::optional<FT> bound;
    const auto approach = [&](int corner, int line) {
      const Vector across = cross_product(r_.normal(line), r_.direction(line)),
                   k = r_.corner_of_rails(corner) - r_.points[r_.source(corner)];
      const FT speed = r_.width(line) - dot(k, across),
               way = dot(r_.points[r_.source(corner)] - r_.points[r_.source(line)], across);
      if (!(FT(0) < speed) || !(FT(0) < way)) return;
      const FT factor = way / speed;
      if (factor <= FT(1) && (!bound || factor < *bound)) bound = factor;
    };
    for (const auto& [of, line] : {std::make_pair(g, h), std::make_pair(h, g)}) {
      approach(of, line);
      approach(r_.solid.halfedges[of].next, line);
    }
    const std::string reason =
        "its cut meets that of " + r_.solid.edge_text(r_.solid.halfedges[h].edge) + " on the face between them";
    if (bound) r_.refuse_cuts(r_.solid.halfedges[g].edge, *bound, reason);
    r_.refuse(Error_code::parameter_outside_domain, r_.solid.halfedges[g].edge, reason + "; take smaller set-backs");
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_RAIL_CROSSINGS_H
