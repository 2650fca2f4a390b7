// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_POLYHEDRON_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_POLYHEDRON_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/models/internal/Planar_solid.h>
#include <CGAL/Geometric_continuity/models/internal/Polyhedron_rounding.h>
#include <CGAL/Geometric_continuity/models/internal/Rounded_shell.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file round_polyhedron.h
/// The edges of a polyhedron are rounded with continuous curvature, and the result is closed.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// A polyhedron with rounded edges: faces in planes, blends, and the edges and vertices that they
/// share. Together they are closed.
///
/// Each blend is a B-spline surface of degree 5 x 5 along a chain of edges, \f$ C^2 \f$ along it:
/// `u` runs along the chain, and `v` across it, from its right to its left side as seen from
/// outside. \f$ S_u \times S_v \f$ points outward.
/// \tparam Traits_ the traits class, in dimension 3
template <class Traits_> struct Rounded_polyhedron {
  typedef Traits_ Traits;                  ///< the traits class
  typedef typename Traits::FT FT;          ///< the field
  typedef typename Traits::Point Point;    ///< the points
  typedef typename Traits::Vector Vector;  ///< the vectors
  typedef Bspline_surface<Traits> Surface; ///< the type of blends
  typedef Bspline_curve<Traits> Curve;     ///< the type of edges

  /// The kinds of edges, by what is on both sides.
  enum class Edge_kind {
    rail,  ///< a blend and a plane, or a blend that ends at another one: \f$ G^2 \f$
    seam,  ///< both ends of one blend, which is \f$ C^2 \f$ there
    mitre, ///< two blends, at the end of an edge that stays sharp
    end,   ///< a blend that runs out, and a plane
    sharp  ///< two planes
  };

  /// An edge.
  struct Edge {
    Curve curve;       ///< its degree is 5, or 1 where the edge is sharp
    std::size_t start; ///< the number of a vertex
    std::size_t end;   ///< the number of a vertex; the same one if the edge is closed
    Edge_kind kind;    ///< what it separates
  };

  /// An edge as a loop passes it.
  struct Use {
    std::size_t edge; ///< its number
    bool reversed;    ///< against its direction
  };

  /// An edge as the loop of a blend passes it.
  struct Blend_use : Use {
    Patch_edge side; ///< the side of the surface
    FT begin;        ///< the parameter along this side where the edge starts
    FT end;          ///< and where it ends; between, it is an affine function of that of the edge
  };

  /// A blend.
  struct Blend {
    Surface surface;                ///< over its whole domain
    bool closed;                    ///< it ends where it starts, and is \f$ C^2 \f$ there
    std::vector<std::size_t> edges; ///< the numbers of the edges of the polyhedron, in their order
    std::vector<Blend_use> loop;    ///< counterclockwise as seen from outside
  };

  /// A plane face, or several that lie in one plane and have edges in common.
  struct Face {
    std::size_t face; ///< the number of (the first of) the faces of the polyhedron
    Point origin;     ///< a point of the plane
    Vector x;         ///< a vector in the plane
    Vector y;         ///< another one; the cross product of both points outward
    /// The outer loop first, counterclockwise as seen from outside, and holes clockwise.
    std::vector<std::vector<Use>> loops;
  };

  std::vector<Point> vertices; ///< the vertices
  std::vector<Edge> edges;     ///< the edges
  std::vector<Blend> blends;   ///< the blends, one for each chain
  std::vector<Face> faces;     ///< the plane faces
};

/// \ingroup PkgGeometricContinuitySurfaces
/// How the edges of a polyhedron are rounded.
struct Polyhedron_rounding_options {
  /// The part `g` of the cut after which the third control point of a profile lies: in (0, 1);
  /// greater numbers are tighter at the edge, and smaller ones rounder. With 0 each chain has one
  /// for which the integral of the square of the derivative of the curvature is least.
  double fullness = 0;
  /// In floating point, points may be so far from the plane of their face, in units of the size of
  /// the polyhedron.
  double tolerance = 1e-6;
  /// How errors name an edge of a number; by default "the edge" and the number.
  std::function<std::string(std::size_t)> edge_name;
};

namespace internal {

template <class Traits, class Cut>
Rounded_polyhedron<Traits> round_polygons(std::vector<Coordinate_vector<typename Traits::FT, 3>> points,
                                          const std::vector<std::vector<std::vector<int>>>& faces,
                                          const std::map<std::pair<int, int>, int>& edges, const Cut& cut,
                                          const Polyhedron_rounding_options& options) {
  typedef typename Traits::FT FT;
  if (!(0 <= options.fullness && options.fullness < 1))
    throw Error(Error_code::parameter_outside_domain,
                "round_polyhedron: the fullness " + std::to_string(options.fullness) + " is not between 0 and 1");
  const Planar_solid<FT> solid(
      std::move(points), faces, [&](int i, int j) { return edges.at(std::minmax(i, j)); },
      [&](int e) {
        return options.edge_name ? options.edge_name(static_cast<std::size_t>(e)) : "the edge " + std::to_string(e);
      },
      options.tolerance);
  std::vector<FT> cuts;
  for (const std::vector<int>& given : solid.given_edges) {
    cuts.push_back(FT(cut(given[0])));
    for (int e : given)
      if (FT(cut(e)) != cuts.back())
        throw Error(Error_code::parameter_outside_domain, "round_polyhedron: " + solid.edge_text(int(cuts.size()) - 1) +
                                                              " consists of parts with different set-backs");
  }
  const Polyhedron_rounding<FT> rounding(solid, std::move(cuts), options.fullness);
  Rounded_polyhedron<Traits> result;
  Rounded_shell<Rounded_polyhedron<Traits>>(rounding, result);
  return result;
}

// A function of edges, or one number for all.
template <class Cut, class Edge, class = void> struct Is_cut_of_edges : std::false_type {};
template <class Cut, class Edge>
struct Is_cut_of_edges<Cut, Edge, std::void_t<decltype(std::declval<const Cut&>()(std::declval<Edge>()))>>
    : std::true_type {};

template <class FT, class Edge, class Cut> FT cut_of_edge(const Cut& cut, const Edge& e) {
  if constexpr (Is_cut_of_edges<Cut, Edge>::value)
    return FT(cut(e));
  else
    return FT(cut);
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Rounds the edges of a polyhedron: each is cut off in both its faces at a given distance, and
/// blends of degree 5 take the places of the edges and vertices. The result is closed, and
/// \f$ G^2 \f$ along all its rails: exactly with an exact kernel, and in floating point for the
/// numbers as they are, see `edge_orders()`.
///
/// Where three rounded edges meet, two go on as one chain, and the third ends at it; at vertices
/// with convex and concave edges it is the one that is different. A matching of the edges chooses
/// the ends so that chains are closed as far as possible: those of a prism are its base and its
/// top. A chain has one blend, \f$ C^2 \f$ along it.
///
/// Faces may have any number of edges, and be triangulated: those that lie in one plane and have
/// an edge in common are united, and a cut of an edge between them is not used.
///
/// With a floating-point kernel, faces have the planes of a fine grid next to them, and all control
/// points are on the grid, see `Polyhedron_rounding_options::tolerance`; where a plane has not a
/// short normal, it is turned by about \f$ 10^{-9} \f$. With an exact kernel the cuts are exact
/// where lengths are rational, and otherwise up to about \f$ 10^{-7} \f$ of them.
/// \param graph a closed polyhedron
/// \param points the points of its vertices
/// \param cut the distance of the rails from the edges: a number, or a function object that takes
///   an edge, `boost::graph_traits<FaceGraph>::edge_descriptor`, and returns a number, where 0
///   leaves the edge sharp. A chain ends at a face where the two other edges of a vertex are sharp,
///   and breaks in a mitre where the third one is.
/// \param options how they are rounded
/// \tparam FaceGraph a model of the concept `FaceListGraph` of \cgal
/// \tparam PointMap a property map of vertices, with points of a kernel in dimension 3
/// \throws Error `parameter_outside_domain` where cuts are longer than an edge or a face allows,
///   with the edge and the bound, for negative cuts, and for the options;
///   `not_a_manifold` where the surface is not closed, and where not three edges meet at a vertex
///   with a cut; `singular_frame` for a face that is not plane, has no area, or is covered by
///   another one; `zero_tangent` for an edge of length 0; `incompatible_corner` where a chain would
///   end at an angle of more than 180 degrees; `not_finite`
///
/// Linear in the number of edges, but for the search for a matching, and for faces that are not
/// convex.
template <class FaceGraph, class PointMap, class Cut>
auto round_polyhedron(const FaceGraph& graph, const PointMap& points, const Cut& cut,
                      const Polyhedron_rounding_options& options) {
  typedef boost::graph_traits<FaceGraph> Graph;
  typedef Traits_of<typename boost::property_traits<PointMap>::value_type> Traits;
  typedef typename Traits::FT FT;
  std::map<typename Graph::vertex_descriptor, int> number;
  std::vector<Coordinate_vector<FT, 3>> coordinates;
  for (auto [v, end] = vertices(graph); v != end; ++v) {
    number[*v] = static_cast<int>(coordinates.size());
    coordinates.push_back(Geometric_continuity::coordinates<Traits>(get(points, *v)));
  }
  std::map<std::pair<int, int>, int> edge_number;
  std::vector<FT> cuts;
  for (auto [e, end] = edges(graph); e != end; ++e) {
    edge_number[std::minmax(number.at(source(*e, graph)), number.at(target(*e, graph)))] =
        static_cast<int>(cuts.size());
    cuts.push_back(internal::cut_of_edge<FT>(cut, *e));
  }
  std::vector<std::vector<std::vector<int>>> polygons;
  for (auto [f, end] = faces(graph); f != end; ++f) {
    std::vector<int> loop;
    const auto first = halfedge(*f, graph);
    auto h = first;
    do loop.push_back(number.at(source(h, graph))), h = next(h, graph);
    while (h != first);
    polygons.push_back({std::move(loop)});
  }
  return internal::round_polygons<Traits>(
      std::move(coordinates), polygons, edge_number, [&](int e) { return cuts[static_cast<std::size_t>(e)]; }, options);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Rounds the edges of a polyhedron whose points are its internal ones, `CGAL::vertex_point`.
/// \throws Error as the function with a property map
template <class FaceGraph, class Cut>
auto round_polyhedron(const FaceGraph& graph, const Cut& cut,
                      const Polyhedron_rounding_options& options = Polyhedron_rounding_options()) {
  return round_polyhedron(graph, get(CGAL::vertex_point, graph), cut, options);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Rounds the edges of a polyhedron that is given by polygons, whose faces may have holes.
/// \param points the points
/// \param faces the loops of each face, as numbers of points: counterclockwise as seen from
///   outside, and holes clockwise
/// \param cut the distance of the rails from the edges: a number, or a function object that takes
///   the number of an edge, where 0 leaves it sharp. Edges are numbered from 0 on in the order in
///   which the loops come to them.
/// \param options how they are rounded
/// \throws Error as the function for graphs; `parameter_outside_domain` for the number of a point
///   that is not there
template <class Point, class Cut>
auto round_polyhedron(const std::vector<Point>& points, const std::vector<std::vector<std::vector<int>>>& faces,
                      const Cut& cut, const Polyhedron_rounding_options& options = Polyhedron_rounding_options()) {
  typedef Traits_of<Point> Traits;
  typedef typename Traits::FT FT;
  std::vector<Coordinate_vector<FT, 3>> coordinates;
  for (const Point& p : points) coordinates.push_back(Geometric_continuity::coordinates<Traits>(p));
  std::map<std::pair<int, int>, int> number;
  for (const auto& loops : faces)
    for (const std::vector<int>& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int source = loop[i], target = loop[(i + 1) % loop.size()];
        if (source < 0 || !(static_cast<std::size_t>(source) < points.size()))
          throw Error(Error_code::parameter_outside_domain,
                      "round_polyhedron: there is no point number " + std::to_string(source));
        number.emplace(std::minmax(source, target), static_cast<int>(number.size()));
      }
  return internal::round_polygons<Traits>(
      std::move(coordinates), faces, number,
      [&](int e) { return internal::cut_of_edge<FT>(cut, static_cast<std::size_t>(e)); }, options);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the blend along an outline of a plane face, where walls meet the plane at right angles:
/// planes, cylinders and other surfaces \f$ c(u) + t z \f$.
///
/// With the directions \f$ n(u) \f$ from the outline to the rail and the vector \f$ w \f$ along
/// the wall it is \f$ S(u, v) = c(u) + a(v)\,w + b(v)\,n(u) \f$, of degree 5 in `v`, where
/// `a` leads from 1 to 0, and `b` from 0 to 1, with \f$ b' = b'' = 0 \f$ at the wall, `v` = 0,
/// and \f$ a' = a'' = 0 \f$ in the plane, `v` = 1. So \f$ S_v, S_{vv} \f$ lie along the wall there
/// and in the plane here, and the blend is \f$ G^2 \f$ with both, whatever the outline and the rail
/// are. Blends of two outlines that meet have one boundary there if their rails meet, too, and are
/// as smooth as outline and rail.
/// \param outline the edge of the plane
/// \param rail the new edge in the plane, which has the knots and the weights of the outline: with
///   a unit normal \f$ n \f$ it is \f$ c + D n \f$, for a circle one with the same centre
/// \param wall the vector from the outline to the new edge on the wall
/// \param fullness the part of both cuts after which the third control point lies: in (0, 1).
///   With 11/16 the integral of the square of the derivative of the curvature is about least.
/// \throws Error `wrong_number_of_points` for a rail with other knots or weights,
///   `parameter_outside_domain` for the fullness, `dimension_mismatch` unless the dimension is 3
template <class Traits>
Rational_bspline_surface<Traits>
outline_blend(const Rational_bspline_curve<Traits>& outline, const Rational_bspline_curve<Traits>& rail,
              const typename Traits::Vector& wall, const typename Traits::FT& fullness) {
  typedef typename Traits::FT FT;
  typedef Coordinate_vector<FT, 3> Vector;
  if (outline.dimension() != 3) throw Error(Error_code::dimension_mismatch, "outline_blend: in dimension 3 only");
  if (!(FT(0) < fullness && fullness < FT(1)))
    throw Error(Error_code::parameter_outside_domain, "outline_blend: the fullness is not between 0 and 1");
  if (!(outline.knots() == rail.knots()) || !(outline.weights() == rail.weights()))
    throw Error(Error_code::wrong_number_of_points, "outline_blend: outline and rail have different knots or weights");
  const FT parts[3] = {FT(0), FT(fullness / FT(2)), fullness};
  const Vector down = coordinates<Traits>(wall);
  std::vector<std::vector<typename Traits::Point>> net;
  std::vector<std::vector<FT>> weights;
  for (int i = 0; i < outline.number_of_points(); ++i) {
    const Vector c = coordinates<Traits>(outline.control_point(i)),
                 on_plane = coordinates<Traits>(rail.control_point(i)), on_wall = c + down;
    net.emplace_back();
    for (int j = 0; j < 3; ++j) net.back().push_back(to_point<Traits>(on_wall - parts[j] * down));
    for (int j = 2; j >= 0; --j) net.back().push_back(to_point<Traits>(on_plane + parts[j] * (c - on_plane)));
    weights.emplace_back(6, outline.weight(i));
  }
  return {net, weights, outline.knots(), Knot_vector<FT>(5, FT(0), FT(1))};
}

namespace internal {

// Decides about the edges of a rounded polyhedron, in an exact field.
template <class Traits> class Rounded_edge_decision {
  typedef Rounded_polyhedron<Traits> Polyhedron;
  typedef typename Polyhedron::Blend Blend;
  typedef typename Polyhedron::Blend_use Blend_use;
  typedef Edge_field<Traits> Field;
  typedef Coordinate_vector<Field, 3> Vector;

  struct Side {
    const Blend* blend;
    const Blend_use* use;
  };
  const Polyhedron& polyhedron_;
  std::vector<std::vector<Side>> blends_; // of each edge
  std::vector<std::vector<const typename Polyhedron::Face*>> faces_;

public:
  explicit Rounded_edge_decision(const Polyhedron& polyhedron)
      : polyhedron_(polyhedron), blends_(polyhedron.edges.size()), faces_(polyhedron.edges.size()) {
    for (const Blend& blend : polyhedron.blends)
      for (const Blend_use& use : blend.loop) blends_[use.edge].push_back({&blend, &use});
    for (const auto& face : polyhedron.faces)
      for (const auto& loop : face.loops)
        for (const auto& use : loop) faces_[use.edge].push_back(&face);
  }

  int order(std::size_t edge) const {
    const std::vector<Side>& sides = blends_[edge];
    if (sides.size() == 2) {
      const auto verdict = edge_continuity(part(sides[0]), sides[0].use->side, part(sides[1]), sides[1].use->side);
      return verdict.whole_a && verdict.whole_b ? verdict.g_order : -1;
    }
    if (sides.size() == 1 && faces_[edge].size() == 1)
      return polyhedron_.edges[edge].kind == Polyhedron::Edge_kind::rail ? order(sides[0], *faces_[edge][0]) : 0;
    return 0;
  }

private:
  // The spans of a surface that have an edge, with the knots and control points as they are.
  static typename Polyhedron::Surface part(const Side& side) {
    const auto& s = side.blend->surface;
    const Knot_vector<typename Traits::FT>& knots = s.knots_u();
    const int p = knots.degree();
    const bool along = side.use->side == Patch_edge::v0 || side.use->side == Patch_edge::v1,
               at_start = side.use->side == Patch_edge::u0;
    const int first = along      ? knots.span(side.use->begin)
                      : at_start ? knots.spans().front()
                                 : knots.spans().back(),
              last = along ? knots.left_span(side.use->end) : first;
    std::vector<std::vector<typename Traits::Point>> net;
    for (int i = first - p; i <= last; ++i) {
      net.emplace_back();
      for (int j = 0; j < s.number_of_points_v(); ++j) net.back().push_back(s.control_point(i, j));
    }
    return {net,
            Knot_vector<typename Traits::FT>(
                p, std::vector<typename Traits::FT>(knots.begin() + first - p, knots.begin() + last + p + 2)),
            s.knots_v()};
  }

  static Vector vector(const typename Traits::Point& p) { return coordinates<Traits, Field>(p); }

  // Where all control points of three rows are in the plane, so are S, S_v and S_vv: the curvatures
  // along the edge are 0. The normals have one direction if they have it at one point.
  static int order(const Side& side, const typename Polyhedron::Face& face) {
    const auto& s = side.blend->surface;
    const Vector normal = cross_product(coordinates<Traits, Field>(face.x), coordinates<Traits, Field>(face.y)),
                 origin = vector(face.origin);
    const int p = s.degree_u(), first = s.knots_u().span(side.use->begin) - p,
              last = s.knots_u().left_span(side.use->end);
    int order = 2;
    for (int j = 0; j <= 2; ++j)
      for (int i = first; i <= last; ++i) {
        const int row = side.use->side == Patch_edge::v0 ? j : 5 - j;
        if (dot(normal, Vector(vector(s.control_point(i, row)) - origin)) != Field(0)) order = (std::min)(order, j - 1);
      }
    if (order < 1) return order;
    const typename Traits::FT middle((side.use->begin + side.use->end) / typename Traits::FT(2));
    const auto jet = s.jet(middle, typename Traits::FT(side.use->side == Patch_edge::v0 ? 0 : 1), 1);
    double product = 0; // of a normal that is parallel to the other one
    const auto of_blend = cross_product(jet(1, 0), jet(0, 1));
    for (int k = 0; k < 3; ++k) product += CGAL::to_double(normal[k]) * CGAL::to_double(of_blend[k]);
    return 0 < product ? order : 0;
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Decides exactly, with every kernel, the order of continuity along each edge of a rounded
/// polyhedron as a whole: 2 along all rails and seams, unless numbers were changed afterwards, and
/// 0 where edges are sharp. It is -1 where faces do not meet.
///
/// A blend is \f$ G^2 \f$ with a plane along an edge where three rows of its control points lie in
/// it; two blends are decided as by `edge_continuity()`. That the normals of a blend do not vanish
/// is decided by `possible_fold()`.
/// \throws Error `work_limit`
template <class Traits> std::vector<int> edge_orders(const Rounded_polyhedron<Traits>& polyhedron) {
  const internal::Rounded_edge_decision<Traits> decision(polyhedron);
  std::vector<int> orders;
  for (std::size_t e = 0; e < polyhedron.edges.size(); ++e) orders.push_back(decision.order(e));
  return orders;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_ROUND_POLYHEDRON_H
