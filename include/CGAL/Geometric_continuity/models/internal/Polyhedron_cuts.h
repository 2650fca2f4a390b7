// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_CUTS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_CUTS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/models/internal/Planar_solid.h>
#include <CGAL/Geometric_continuity/models/internal/Rounding_plane.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Polyhedron_cuts.h
/// The cuts of the edges of a polyhedron on the planes of its faces: how many edges are rounded at
/// each vertex, and where the lines at the distances of the cuts meet.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A polyhedron with the cuts of its edges, the distances at which they are cut off in both faces.
// It refuses vertices at which edges cannot be rounded.
template <class FT_> class Polyhedron_cuts {
public:
  typedef FT_ FT;
  typedef Planar_solid<FT> Solid;
  typedef typename Solid::Vector Vector;
  enum class Vertex_kind { sharp, run_out, mitre, corner };
  static constexpr bool in_floating_point = std::is_floating_point_v<FT>;

  // K = V + along x + across y in the face of x, where y = turned(x).
  struct Corner {
    FT size; // the determinant N . (x, y)
    FT along, across;
    bool is_reflex() const { return size < FT(0); }
  };

  const Solid& solid;
  std::vector<Rounding_plane<FT>> planes; // of the faces
  std::vector<Vector> points;             // where planes meet

  // A cut of 0 leaves an edge as it is.
  Polyhedron_cuts(const Solid& s, std::vector<FT> cuts) : solid(s), cuts_(std::move(cuts)) {
    check_vertices();
    find_planes();
    measure_corners();
  }

  bool is_rounded(int halfedge) const { return FT(0) < cuts_[solid.halfedges[halfedge].edge]; }
  Vertex_kind kind(int vertex) const { return kinds_[vertex]; }
  // The corner between an edge that leaves a vertex, and the one turned from it.
  const Corner& corner(int h) const { return corners_[h]; }
  // The cut times |N x direction|.
  const FT& width(int h) const { return widths_[h]; }
  int opposite(int h) const { return solid.halfedges[h].opposite; }
  int source(int h) const { return solid.halfedges[h].source; }
  int turned(int h) const { return solid.turned(h); }
  Vector direction(int h) const { return points[solid.target(h)] - points[source(h)]; }
  int face(int h) const { return solid.halfedges[h].face; }
  FT square(int h) const {
    const Vector x = direction(h);
    return dot(x, x);
  }
  const Vector& normal(int h) const { return solid.faces[face(h)].normal; }
  // K on the face of h, next to its source.
  Vector corner_of_rails(int h) const {
    return points[source(h)] + corners_[h].along * direction(h) + corners_[h].across * direction(turned(h));
  }
  static double number(const FT& x) { return rounded_number(x); }

  [[noreturn]] void refuse(Error_code code, int edge, const std::string& text) const {
    throw Error(code, "round_polyhedron: " + solid.edge_text(edge) + ": " + text);
  }
  [[noreturn]] void refuse_vertex(Error_code code, int vertex, const std::string& text) const {
    throw Error(code, "round_polyhedron: the vertex " + solid.point_text(vertex) + ": " + text);
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

protected:
  std::vector<FT> cuts_;
  std::vector<Vertex_kind> kinds_;
  std::vector<Corner> corners_;

private:
  std::vector<FT> widths_; // of halfedges

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
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POLYHEDRON_CUTS_H
