// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_BLEND_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_BLEND_SURFACES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/local/homogeneous_jets.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Patch_edge.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file blend_surfaces.h
/// The blend from an edge of one surface to an edge of another: a surface of degree 5 across that is \f$ G^2 \f$ with both along the
/// whole edges.
///
/// Let `v` grow from 0, at an edge \f$ C(u) \f$ with the derivatives \f$ T \f$ and \f$ W \f$ across it, to 1. To second order the
/// blend is there the surface \f$ L \f$ itself in other parameters, \f$ S = L \circ \varphi \f$ with
/// \f$ \varphi(u, v) = (u + \alpha v + \frac12 \alpha_2 v^2,\ \beta v + \frac12 \delta v^2) \f$:
///
/// \f[ S_v = \alpha C' + \beta T, \qquad
///     S_{vv} = \alpha^2 C'' + 2 \alpha\beta T' + \beta^2 W + \alpha_2 C' + \delta T, \f]
///
/// with functions \f$ \alpha, \alpha_2, \delta \f$ and \f$ \beta > 0 \f$ of `u`. The rows of control points are
/// \f$ b_0 = C \f$, \f$ b_1 = b_0 + \frac15 S_v \f$, \f$ b_2 = b_0 + \frac25 S_v + \frac1{20} S_{vv} \f$, and at the other end
/// \f$ b_5, b_4, b_3 \f$ with \f$ -S_v \f$ for \f$ S_v \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// How a blend runs out of the parameters of a surface along an edge, or into them:
/// \f$ \varphi(u, v) = (u + \alpha v + \frac12 \alpha_2 v^2,\ \beta v + \frac12 \delta v^2) \f$ to second order, with functions of the
/// parameter along the edge. Each is a polynomial on the domain of the edge, which is mapped to [0, 1].
/// \tparam FT_ a field number type
template <class FT_> struct Edge_reparametrisation {
  typedef FT_ FT;                            ///< the number type
  typedef Bernstein_polynomial<FT> Function; ///< of the parameter along the edge

  Function alpha = Function{FT(0)};  ///< the first derivative along the edge
  Function beta = Function{FT(1)};   ///< the first derivative across the edge, positive
  Function alpha2 = Function{FT(0)}; ///< the second derivative along the edge
  Function delta = Function{FT(0)};  ///< the second derivative across the edge
};

/// \ingroup PkgGeometricContinuityConstruction
/// How a blend runs out of the parameters of a rational surface: \f$ S = \lambda \cdot L \circ \varphi \f$ in homogeneous points, to
/// second order, with the factor \f$ \lambda = 1 + \lambda_1 v + \frac12 \lambda_2 v^2 \f$.
/// \tparam FT a field number type
template <class FT> struct Rational_edge_reparametrisation : Edge_reparametrisation<FT> {
  typedef typename Edge_reparametrisation<FT>::Function Function; ///< of the parameter along the edge

  Function lambda1 = Function{FT(0)}; ///< the first derivative of the factor across the edge
  Function lambda2 = Function{FT(0)}; ///< its second derivative

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Rational_edge_reparametrisation() = default;
  /// With the factor 1.
  Rational_edge_reparametrisation(const Edge_reparametrisation<FT>& r) : Edge_reparametrisation<FT>(r) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Surface_blend_shape {
  Edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Edge_reparametrisation<FT> end;   ///< at the edge of the second surface
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a rational blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Rational_surface_blend_shape {
  Rational_edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Rational_edge_reparametrisation<FT> end;   ///< at the edge of the second surface

  /// Sets all functions \f$ \beta \f$ to 1 and all others to 0.
  Rational_surface_blend_shape() = default;
  /// Takes what is given at both ends.
  Rational_surface_blend_shape(const Rational_edge_reparametrisation<FT>& start,
                               const Rational_edge_reparametrisation<FT>& end)
      : start(start), end(end) {}
  /// With the factor 1 at both ends.
  Rational_surface_blend_shape(const Surface_blend_shape<FT>& shape) : start(shape.start), end(shape.end) {}
};

namespace internal {

// What the blend of two surfaces is.
template <class A, class B> struct Blended_surfaces {
  static_assert(std::is_same_v<typename A::Traits, typename B::Traits>,
                "both surfaces must have the same traits class");
  typedef typename A::Traits Traits;
  typedef typename Traits::FT FT;
  static constexpr bool is_rational = Is_rational_surface<A>::value || Is_rational_surface<B>::value,
                        is_patch = Is_patch<A>::value && Is_patch<B>::value;
  template <class T> using Shape_over = std::conditional_t<is_patch, Bezier_patch<T>, Bspline_surface<T>>;

  typedef std::conditional_t<is_rational, Homogeneous_traits<Traits>, Traits> Row_traits; // of the points in the rows
  static constexpr int N = dimension_v<Row_traits>;
  typedef std::conditional_t<is_rational, Rational_surface<Shape_over<Traits>>, Shape_over<Traits>> Surface;
  typedef std::conditional_t<is_rational, Rational_surface_blend_shape<FT>, Surface_blend_shape<FT>> Shape;

  template <class S> static Blend_end<FT, N> end(const S& surface, Patch_edge edge, int direction) {
    if constexpr (is_rational && !Is_rational_surface<S>::value)
      return blend_end<N>(Rational_surface<S>(surface), edge, direction);
    else
      return blend_end<N>(surface, edge, direction);
  }

  // With the rows of control points across the blend.
  static Surface surface(const std::array<Edge_spline<FT, N>, 6>& rows) {
    typedef Shape_over<Row_traits> Polynomial;
    const Knot_vector<FT>& knots = rows[0].knots();
    std::vector<std::vector<typename Row_traits::Point>> net(knots.number_of_coefficients());
    for (int i = 0; i < knots.number_of_coefficients(); ++i)
      for (const Edge_spline<FT, N>& row : rows) net[i].push_back(to_point<Row_traits>(row[i]));
    if constexpr (is_patch)
      return Surface(Polynomial(net, knots.domain()));
    else
      return Surface(Polynomial(net, knots, Knot_vector<FT>(5, FT(0), FT(1))));
  }
};

template <class FT> void check_reparametrisation(const Edge_reparametrisation<FT>& r, const char* place) {
  if (sign_pattern(r.beta) != Sign_pattern::positive) throw Error(Error_code::nonpositive_beta, place);
}

// Refuses an edge without a normal: a single point, or one across which the derivative vanishes.
template <bool is_rational, class FT, int N> void check_edge(const Blend_end<FT, N>& end, const std::string& surface) {
  const auto are_all = [](const std::vector<Coordinate_vector<FT, N>>& row, const auto& point, const auto& value) {
    return std::all_of(row.begin(), row.end(), [&](const Coordinate_vector<FT, N>& x) {
      const auto y = point(x);
      for (int i = 0; i < y.dimension(); ++i)
        if (!CGAL::certainly(y[i] == value[i])) return false;
      return true;
    });
  };
  const auto itself = [](const Coordinate_vector<FT, N>& x) -> const Coordinate_vector<FT, N>& { return x; };
  const auto& edge = end.edge.coefficients();
  bool is_point, vanishes;
  if constexpr (is_rational) {
    const auto affine = [](const Coordinate_vector<FT, N>& x) { return affine_point(x); };
    is_point = are_all(edge, affine, affine(edge[0]));
    const Edge_spline<FT, N> numerator = weight_of(end.edge) * end.cross - weight_of(end.cross) * end.edge;
    vanishes = are_all(numerator.coefficients(), itself, Coordinate_vector<FT, N>(edge[0].dimension()));
  } else {
    is_point = are_all(edge, itself, edge[0]);
    vanishes = are_all(end.cross.coefficients(), itself, Coordinate_vector<FT, N>(edge[0].dimension()));
  }
  if (is_point) throw Error(Error_code::zero_tangent, "blend: the edge of " + surface + " is a point");
  if (vanishes)
    throw Error(Error_code::zero_tangent,
                "blend: the derivative across the edge of " + surface + " vanishes on all of it");
}

// The three rows of control points from an edge inwards.
template <class FT, int N, class Reparametrisation>
std::array<Edge_spline<FT, N>, 3> rows_of_end(const Blend_end<FT, N>& end, const Reparametrisation& r, int direction) {
  typedef Edge_spline<FT, N> Row;
  typedef Bernstein_polynomial<FT> Function;
  const Function &alpha = r.alpha, &beta = r.beta, two{FT(2)};
  Row first = product(beta, end.cross), second = product(beta * beta, end.second_cross); // S_v and S_vv
  if (!is_constant(alpha, 0)) {
    const Row derivative = end.edge.derivative();
    first = first + product(alpha, derivative);
    second =
        second + product(alpha * alpha, derivative.derivative()) + product(two * alpha * beta, end.cross.derivative());
  }
  if (!is_constant(r.alpha2, 0)) second = second + product(r.alpha2, end.edge.derivative());
  if (!is_constant(r.delta, 0)) second = second + product(r.delta, end.cross);
  if constexpr (std::is_same_v<Reparametrisation, Rational_edge_reparametrisation<FT>>) {
    if (!is_constant(r.lambda1, 0)) {
      second = second + product(two * r.lambda1, first);
      first = first + product(r.lambda1, end.edge);
    }
    if (!is_constant(r.lambda2, 0)) second = second + product(r.lambda2, end.edge);
  }
  const Row step = product(Function{FT(FT(direction) / FT(5))}, first);
  return {end.edge, end.edge + step, end.edge + step + step + product(Function{FT(FT(1) / FT(20))}, second)};
}

// Where a derivative along an edge jumps that the functions multiply, the rows would have knots of the multiplicity degree + 1.
template <class FT> void check_not_torn(const Knot_vector<FT>& knots) {
  for (const typename Knot_vector<FT>::Knot& knot : knots.inner_knots())
    if (knot.multiplicity > knots.degree())
      throw Error(Error_code::knot_multiplicity, "blend: it would be torn at the knot " +
                                                     std::to_string(CGAL::to_double(knot.value)) + " along an edge");
}

// The six rows of control points across a blend.
template <class FT, int N, class Shape>
std::array<Edge_spline<FT, N>, 6> rows_of_blend(const Blend_end<FT, N>& start, const Blend_end<FT, N>& end,
                                                const Shape& shape) {
  const std::array<Edge_spline<FT, N>, 3> s = rows_of_end(start, shape.start, 1), e = rows_of_end(end, shape.end, -1);
  std::array<Edge_spline<FT, N>, 6> rows = {s[0], s[1], s[2], e[2], e[1], e[0]};
  unite(rows);
  check_not_torn(rows[0].knots());
  return rows;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the blend of two surfaces: `Bezier_patch` or `Rational_bezier_patch` of two patches, otherwise `Bspline_surface` or
/// `Rational_bspline_surface`; rational if one of them is.
template <class Surface_a, class Surface_b>
using Blend_surface = typename internal::Blended_surfaces<Surface_a, Surface_b>::Surface;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape of the blend of two surfaces: `Rational_surface_blend_shape` if one of them is rational, otherwise
/// `Surface_blend_shape`.
template <class Surface_a, class Surface_b>
using Blend_surface_shape = typename internal::Blended_surfaces<Surface_a, Surface_b>::Shape;

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the surface \f$ S(u, v) \f$ of degree 5 in `v`, on [0, 1], that leads from an edge of one surface, at `v = 0`, to an edge of
/// another one, at `v = 1`, and is \f$ G^2 \f$ with both along the whole edges, wherever the normals of the surfaces do not vanish there.
/// Along `u` it has the domain and the direction of the first edge. With an exact kernel it is exact, as `edge_continuity()` proves.
///
/// The second edge is mapped affinely to the domain of the first one, degrees are raised and knots are united where they differ. Constants
/// in the place of functions leave the degree along the edges as it is, functions of degree `q` raise it by up to `2 q`. Where
/// \f$ \alpha \f$, \f$ \alpha_2 \f$ and \f$ \delta \f$ are 0 and \f$ \beta \f$ is constant, each curve `u` = const is a blend of the
/// curves of the two surfaces, see `Quintic_ends`. The side edges are what the side edges of the surfaces make of them.
///
/// The dimension is any. Linear in the number of knots.
/// \param shape the functions that are free, in the parameter of the first edge; derivatives are those with respect to the parameters of the
///   surfaces
/// \param direction how the second edge runs in comparison with the first one
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or `Rational_bspline_surface`, with one
///   traits class
/// \throws Error `nonpositive_beta` unless both functions \f$ \beta \f$ are positive on the closed domain (decided exactly, checked first)
/// \throws Error `zero_tangent` when an edge is a single point, or when the derivative across it vanishes on the whole edge
/// \throws Error `knot_multiplicity` when a derivative along an edge jumps that is multiplied by \f$ \alpha \f$ or \f$ \alpha_2 \f$
/// \throws Error `dimension_mismatch`; `zero_weight` when the denominator of a rational blend is not positive; `not_finite` when
///   floating-point numbers overflow; `work_limit`
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          const Blend_surface_shape<Surface_a, Surface_b>& shape,
                                          Edge_direction direction = Edge_direction::same) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  typedef internal::Blend_end<typename Kind::FT, Kind::N> End;
  internal::check_reparametrisation(shape.start, "blend: beta at the edge of the first surface");
  internal::check_reparametrisation(shape.end, "blend: beta at the edge of the second surface");
  if (a.dimension() != b.dimension()) throw Error(Error_code::dimension_mismatch, "blend: of the two surfaces");
  const End start = Kind::end(a, edge_a, 1), end = Kind::end(b, edge_b, -1).along(start.edge.domain(), direction);
  internal::check_edge<Kind::is_rational>(start, "the first surface");
  internal::check_edge<Kind::is_rational>(end, "the second surface");
  return Kind::surface(internal::rows_of_blend(start, end, shape));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_BLEND_SURFACES_H
