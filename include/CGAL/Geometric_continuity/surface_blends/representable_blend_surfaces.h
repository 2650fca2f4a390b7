// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_REPRESENTABLE_BLEND_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_REPRESENTABLE_BLEND_SURFACES_H

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/blend_of_columns.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file representable_blend_surfaces.h
/// Blend surfaces whose control points are floating-point numbers and which are exactly \f$ G^2 \f$
/// along whole edges nevertheless.
///
/// All columns of control points across an edge, `i` = 0, ..., `n`, one below the other, are one
/// column in a space of `3 (n + 1)` dimensions. With numbers \f$ \beta, \delta \f$ for functions,
/// and \f$ \alpha = \alpha_2 = 0 \f$, the points of a blend next to the edge are those of a blend
/// of curves there, so that the numbers with few digits that are found for curves serve all columns
/// together.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A blend surface whose control points are floating-point numbers and which is exactly \f$ G^2 \f$
/// along both edges with the surfaces `first` and `second`. These are the given ones unless
/// `start_join.is_moved()` or `end_join.is_moved()`.
/// \tparam Surface `Bezier_patch` or `Bspline_surface`
template <class Surface> struct Representable_blend_surface {
  typedef typename Surface::FT FT; ///< the number type

  /// the first surface; three layers of control points next to the edge are on a grid
  Surface first;
  /// from the edge of the first surface, at `v = 0`, to that of the second one, at `v = 1`
  Surface blend;
  /// the second surface; three layers of control points next to the edge are on a grid
  Surface second;
  /// The changes that were needed at the edge of the first surface. `grid` has the coordinates of
  /// the first column of control points across the edge, then those of the second one, and so on.
  Representable_join<FT, 0> start_join;
  /// The changes that were needed at the edge of the second surface.
  Representable_join<FT, 0> end_join;
};

namespace internal {

// The control points next to an edge of a surface, as one column for each of three layers.
template <class Surface> class Columns_at_edge {
  typedef typename Surface::Traits Traits;
  typedef typename Surface::FT FT;
  typedef typename Traits::Point Point;
  typedef std::array<Coordinate_vector<FT, 0>, 3> Layers;

  const Surface& s_;
  const Patch_edge edge_;
  const bool opposite_;
  const std::string place_;
  const Knot_vector<FT> along_, across_;

public:
  Columns_at_edge(const Surface& s, Patch_edge edge, Edge_direction direction, const char* surface)
      : s_(s), edge_(edge), opposite_(direction == Edge_direction::opposite),
        place_(std::string("representable_blend: the edge ") + to_string(edge) + " of " + surface),
        along_(knots_of_edge(s, edge)),
        across_(knots_of_edge(s, runs_along_u(edge) ? Patch_edge::u0 : Patch_edge::v0)) {
    check_edge(surface);
  }

  const Knot_vector<FT>& knots() const { return along_; }
  int number_of_columns() const { return along_.number_of_coefficients(); }
  const std::string& place() const { return place_; }

  Layers layers() const {
    Layers x;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < number_of_columns(); ++i) {
        const std::pair<int, int> at = index(i, (std::min)(j, across_.degree()));
        const Coordinates<Traits> c = s_.coordinates(at.first, at.second);
        if (i == 0) x[j] = Coordinate_vector<FT, 0>(number_of_columns() * c.dimension());
        for (int k = 0; k < c.dimension(); ++k) x[j][i * c.dimension() + k] = c[k];
      }
    return x;
  }

  Inward_lengths<FT> lengths() const {
    const int q = across_.degree(), n = across_.number_of_coefficients();
    const auto length = [&](int j) {
      const FT& low = across_[at_upper_end(edge_) ? n - 1 - j : q];
      const FT& high = across_[at_upper_end(edge_) ? n : q + 1 + j];
      const FT x = high - low;
      if (n > q + 1 &&
          // else only their ratio 1 matters
          Exact_rational(x) != Exact_rational(high) - Exact_rational(low))
        refuse("the distance of knots next to it is no floating-point number");
      return x;
    };
    const FT first = length(0);
    return {q, first, q == 1 ? first : length(1)};
  }

  // The point and the first two derivatives across the edge, in the direction of the blend: `sign`
  // is 1 where it starts, -1 where it ends.
  Coordinate_jet<Exact_rational, 0> jet(const Layers& b, int sign) const {
    typedef Exact_rational Q;
    const Inward_lengths<FT> l = lengths();
    Coordinate_jet<Q, 0> jet(b[0].dimension(), 2);
    for (int x = 0; x < b[0].dimension(); ++x) {
      const Q difference = (Q(b[0][x]) - Q(b[1][x])) / Q(l.first), next = (Q(b[1][x]) - Q(b[2][x])) / Q(l.second);
      jet[0][x] = Q(b[0][x]);
      jet[1][x] = Q(sign * l.degree) * difference;
      jet[2][x] = Q(l.degree * (l.degree - 1)) * Q(difference - next) / Q(l.first);
    }
    return jet;
  }

  Surface with(const Layers& x) const {
    std::vector<std::vector<Point>> net = net_of_points();
    for (int j = 0; j <= (std::min)(across_.degree(), 2); ++j)
      for (int i = 0; i < number_of_columns(); ++i) {
        const std::pair<int, int> at = index(i, j);
        net[at.first][at.second] = point(x[j], i);
      }
    if constexpr (Is_patch<Surface>::value)
      return Surface(net, s_.domain_u(), s_.domain_v());
    else
      return Surface(net, s_.knots_u(), s_.knots_v());
  }

  // Over the knots of the edge, from six layers.
  Surface blend(const std::array<Coordinate_vector<FT, 0>, 6>& x) const {
    std::vector<std::vector<Point>> net(number_of_columns());
    for (int i = 0; i < number_of_columns(); ++i)
      for (const Coordinate_vector<FT, 0>& layer : x) net[i].push_back(point(layer, i));
    if constexpr (Is_patch<Surface>::value)
      return Surface(net, along_.domain());
    else
      return Surface(net, along_, Knot_vector<FT>(5, FT(0), FT(1)));
  }

  // Returns whether the knots are those of the other edge, after an affine map.
  bool has_knots_of(const Columns_at_edge& other) const {
    const Knot_vector<FT>&x = along_, &y = other.along_;
    if (x.degree() != y.degree() || x.size() != y.size()) return false;
    // from the start of the edge
    const auto distance = [](const Columns_at_edge& e, int i) -> Exact_rational {
      const Knot_vector<FT>& t = e.along_;
      return e.opposite_ ? Exact_rational(t.domain().second) - Exact_rational(t[t.size() - 1 - i])
                         : Exact_rational(t[i]) - Exact_rational(t.domain().first);
    };
    const int end = x.number_of_coefficients();
    const Exact_rational of_x = distance(*this, end), of_y = distance(other, end);
    for (int i = 0; i < x.size(); ++i)
      if (Exact_rational(distance(*this, i) * of_y) != Exact_rational(distance(other, i) * of_x)) return false;
    return true;
  }

  [[noreturn]] void refuse(const char* reason) const {
    throw Error(Error_code::not_representable, place_ + ": " + reason);
  }

private:
  // Returns the index of the control point number i along the edge in the layer j.
  std::pair<int, int> index(int i, int j) const {
    const int along = opposite_ ? number_of_columns() - 1 - i : i,
              across = at_upper_end(edge_) ? across_.number_of_coefficients() - 1 - j : j;
    return runs_along_u(edge_) ? std::make_pair(along, across) : std::make_pair(across, along);
  }

  std::vector<std::vector<Point>> net_of_points() const {
    const Knot_vector<FT>&u = runs_along_u(edge_) ? along_ : across_, &v = runs_along_u(edge_) ? across_ : along_;
    std::vector<std::vector<Point>> net(u.number_of_coefficients());
    for (int i = 0; i < u.number_of_coefficients(); ++i)
      for (int j = 0; j < v.number_of_coefficients(); ++j) net[i].push_back(s_.control_point(i, j));
    return net;
  }

  Point point(const Coordinate_vector<FT, 0>& layer, int i) const {
    Coordinates<Traits> c(s_.dimension());
    for (int k = 0; k < c.dimension(); ++k) c[k] = layer[i * c.dimension() + k];
    return to_point<Traits>(c);
  }

  void check_edge(const char* surface) const {
    const int q = across_.degree(), n = across_.number_of_coefficients();
    if (q == 0)
      throw Error(Error_code::wrong_number_of_points, place_ + ": a surface of degree 0 across it has no derivative");
    if (at_upper_end(edge_) ? across_[n] != across_[n + q] : across_[0] != across_[q])
      refuse("the knots across it are not clamped; clamp() makes them so");
    const Layers x = layers();
    const int d = s_.dimension();
    bool is_point = true;
    for (int k = d; k < x[0].dimension(); ++k) is_point = is_point && x[0][k] == x[0][k - d];
    refuse_edge(is_point, x[0] == x[1], surface);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a blend surface of degree 5 across with control points that are floating-point numbers,
/// which is *exactly* \f$ G^2 \f$ along both whole edges, as `edge_continuity()` decides of the
/// numbers as they are: with its members `first` and `second`, which are the given surfaces, or
/// these with three layers of control points next to the edge moved to a grid, as
/// `representable_blend()` moves those of curves. With a surface that was moved as it was given the
/// blend has a gap.
///
/// With the control points \f$ b_0, b_1, b_2 \f$ of a column, from the edge into the surface, and
/// \f$ p = b_0 - b_1 \f$, \f$ q = p - r\,(b_1 - b_2) \f$,
/// \f[ B = b_0 + c\,p, \qquad C = 2B - b_0 + c^2\,\frac{5(m-1)}{4m}\,q + e\,p, \f]
/// with the same numbers `c` and `e` for all columns, so that \f$ S_v = \beta T \f$ and
/// \f$ S_{vv} = \beta^2 W + \delta T \f$ with \f$ \beta = 5ch/m \f$. Here `m` is the degree across,
/// and of a patch `h` is the length of the domain across and `r` = 1; of a B-spline surface `h` and
/// `h/r` are the distances from the edge to the first and to the second knot behind it, where a
/// repeated knot counts as often as it is repeated. `c` and `e` have few digits and are near to
/// what the strategy chooses for all columns together as one curve in many dimensions, as in
/// `automatic_surface_shape()`.
///
/// This is possible with numbers for functions, for polynomial surfaces, and where both edges have
/// the same degree and the same knots after an affine map of the domains: all else (`elevate()` and
/// `refine()` make them so) would need quotients that no floating-point number is.
/// \param strategy a quintic strategy, see `BlendStrategy`; it is called with exact numbers
/// \param direction how the second edge runs in comparison with the first one
/// \tparam Surface `Bezier_patch` or `Bspline_surface`, of a traits class whose `FT` is `float` or
///   `double`
/// \throws Error `not_representable` when the edges have different degrees or knots, when the knots
///   across an edge are not clamped there, and when no grid serves, see `representable_blend()` of
///   curves; the error names the edge
/// \throws Error `zero_tangent` when an edge is a single point, or the derivative across it
///   vanishes on the whole edge; `wrong_number_of_points` for degree 0 across an edge,
///   `dimension_mismatch`, `not_finite` when the strategy gives an infinite number
///
/// Linear in the number of control points along the edge for each grid that is tried, at most
/// about 50.
template <class Surface, class Strategy>
Representable_blend_surface<Surface> representable_blend(const Surface& a, Patch_edge edge_a, const Surface& b,
                                                         Patch_edge edge_b, const Strategy& strategy,
                                                         Edge_direction direction) {
  typedef typename Surface::FT FT;
  typedef internal::Representable_end<FT, 0> End;
  static_assert(std::is_floating_point_v<FT>, "with exact numbers, blend() is exact");
  static_assert(!internal::Is_rational<Surface>::value,
                "points of rational surfaces are quotients, which no grid holds");
  if (a.dimension() != b.dimension())
    throw Error(Error_code::dimension_mismatch, "representable_blend: of the two surfaces");
  const internal::Columns_at_edge<Surface> at_a(a, edge_a, Edge_direction::same, "the first surface"),
      at_b(b, edge_b, direction, "the second surface");
  if (!at_b.has_knots_of(at_a)) at_b.refuse("its degree or its knots are not those of the edge of the first surface");
  const auto given_a = at_a.layers(), given_b = at_b.layers();
  return internal::with_wished_shape<FT>(
      at_a.jet(given_a, 1), at_b.jet(given_b, -1), strategy, [&](const auto& s, const Shape_parameters<FT>& shape) {
        End start(given_a, at_a.lengths(), 1, shape.beta, at_a.place().c_str()),
            end(given_b, at_b.lengths(), -1, shape.eta, at_b.place().c_str());
        internal::choose_points(start, end, s);
        return Representable_blend_surface<Surface>{
            at_a.with(start.points()), at_a.blend(internal::chosen_points(start, end)), at_b.with(end.points()),
            internal::representable_join(start, given_a), internal::representable_join(end, given_b)};
      });
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the representable blend surface next to that of least energy \f$ \int |S_{vvv}|^2 \f$,
/// where the second edge runs in `nearer_direction()`. \throws Error as the function with a
/// strategy
template <class Surface>
Representable_blend_surface<Surface> representable_blend(const Surface& a, Patch_edge edge_a, const Surface& b,
                                                         Patch_edge edge_b) {
  return representable_blend(a, edge_a, b, edge_b, Minimal_energy<3>(), nearer_direction(a, edge_a, b, edge_b));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_REPRESENTABLE_BLEND_SURFACES_H
