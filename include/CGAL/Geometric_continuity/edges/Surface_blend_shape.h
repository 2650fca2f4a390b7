// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_BLEND_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_BLEND_SHAPE_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/edges/internal/Blend_end.h>

#include <type_traits>

/// \file Surface_blend_shape.h
/// The functions along its edges that \f$ G^2 \f$ leaves free of a blend surface, and the types of such surfaces.

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
/// second order, with the factors \f$ \lambda_0 \f$ and \f$ 1 + \lambda_1 v + \frac12 \lambda_2 v^2 \f$.
/// \tparam FT a field number type
template <class FT> struct Rational_edge_reparametrisation : Edge_reparametrisation<FT> {
  typedef typename Edge_reparametrisation<FT>::Function Function; ///< of the parameter along the edge

  FT lambda = FT(1);                  ///< the factor at the edge, positive
  Function lambda1 = Function{FT(0)}; ///< the first derivative of the other factor across the edge
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
  Rational_surface_blend_shape(const Rational_edge_reparametrisation<FT>& given_start,
                               const Rational_edge_reparametrisation<FT>& given_end)
      : start(given_start), end(given_end) {}
  /// With the factor 1 at both ends.
  Rational_surface_blend_shape(const Surface_blend_shape<FT>& shape) : start(shape.start), end(shape.end) {}
};

namespace internal {

template <class A, class B> struct Blended_shape {
  typedef typename A::FT FT;
  typedef std::conditional_t<Blended_surfaces<A, B>::is_rational, Rational_surface_blend_shape<FT>,
                             Surface_blend_shape<FT>>
      type;
};

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
using Blend_surface_shape = typename internal::Blended_shape<Surface_a, Surface_b>::type;

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_SURFACE_BLEND_SHAPE_H
