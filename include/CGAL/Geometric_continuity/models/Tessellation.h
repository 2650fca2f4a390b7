// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Triangles that stand for a surface: a range of points and a range of triangles that refer to them by their numbers, as
/// the functions for polygon soups of \cgal take them. Seen from the side of \f$ S_u \times S_v \f$ the corners of each
/// triangle run counterclockwise. See `tessellate()`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> struct Tessellation {
  typedef Traits_ Traits;                      ///< the geometric traits
  typedef typename Traits::FT FT;              ///< the number type
  typedef typename Traits::Point Point;        ///< the points
  typedef std::array<std::size_t, 3> Triangle; ///< the numbers of three points

  /// Where a point lies.
  struct Place {
    std::size_t patch; ///< the number of the patch or surface, from 0 on
    FT u;              ///< in its domain
    FT v;              ///< in its domain
  };

  std::vector<Point> points;        ///< each once, also if several patches have it
  std::vector<Triangle> triangles;  ///< numbers of points
  std::vector<std::size_t> patches; ///< for each triangle, the number of its patch or surface
  std::vector<Place> places;        ///< for each point, one place where the surface has it
};

/// \ingroup PkgGeometricContinuitySurfaces
/// How the triangles of a tessellation meet.
struct Mesh_edges {
  std::size_t inner = 0;     ///< edges of two triangles, which pass them in opposite directions
  std::size_t boundary = 0;  ///< edges of one triangle only
  std::size_t irregular = 0; ///< edges of more than two triangles, or of two which pass them in one direction

  /// Returns the number of all edges.
  std::size_t number_of_edges() const { return inner + boundary + irregular; }

  /// Tells whether each edge has a triangle on both sides.
  bool watertight() const { return boundary == 0 && irregular == 0; }

  /// Writes the counts, e.g. `96 edges, watertight` or `96 edges, 12 on the boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Mesh_edges& e) {
    os << e.number_of_edges() << " edges, ";
    if (e.watertight()) return os << "watertight";
    if (e.boundary > 0) os << e.boundary << " on the boundary";
    if (e.irregular > 0) os << (e.boundary > 0 ? ", " : "") << e.irregular << " irregular";
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Counts the edges of triangles by how many triangles meet at them. \f$ O(n \log n) \f$ for `n` triangles
/// \tparam TriangleRange a forward range of triples of numbers of points
template <class TriangleRange> Mesh_edges mesh_edges(const TriangleRange& triangles) {
  struct Use {
    std::size_t low, high;
    bool upwards;
    bool same_edge(const Use& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Use> uses;
  uses.reserve(3 * static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      uses.push_back({(std::min)(a, b), (std::max)(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high); });
  Mesh_edges result;
  for (auto first = uses.begin(), last = first; first != uses.end(); first = last) {
    while (last != uses.end() && first->same_edge(*last)) ++last;
    if (last - first == 1)
      ++result.boundary;
    else
      ++(last - first == 2 && first[0].upwards != first[1].upwards ? result.inner : result.irregular);
  }
  return result;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H
