// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgGeometricContinuityConcepts
The concept `ParametricSurface` describes a surface over a rectangle of parameters that can give its
points and derivatives.

\cgalConcept

What needs nothing but points and derivatives, such as a normal, is written for this concept. How
two surfaces continue each other along a whole edge cannot be decided from single points; this is
decided for Bézier patches, B-spline surfaces and their rational kinds, from their control points,
see `CGAL::Geometric_continuity::edge_continuity()`.

\cgalHasModelsBegin \cgalHasModels{CGAL::Geometric_continuity::Bezier_patch}
\cgalHasModels{CGAL::Geometric_continuity::Bspline_surface}
\cgalHasModels{CGAL::Geometric_continuity::Rational_surface}: `Rational_bezier_patch`,
`Rational_bspline_surface` \cgalHasModels{CGAL::Geometric_continuity::Extrusion_surface_3}
\cgalHasModels{CGAL::Geometric_continuity::Revolution_surface_3} \cgalHasModelsEnd

\sa `GeometricContinuityTraits`
\sa `ParametricCurve`
*/
class ParametricSurface {
public:
  /// \name Types
  /// @{

  /*!
  A model of `GeometricContinuityTraits`. Normals exist in dimension 3.
  */
  typedef unspecified_type Traits;

  /// @}

  /// \name Operations
  /// @{

  /*!
  Returns the first and the last value of the parameter `u`.
  */
  std::pair<Traits::FT, Traits::FT> domain_u() const;

  /*!
  Returns the first and the last value of the parameter `v`.
  */
  std::pair<Traits::FT, Traits::FT> domain_v() const;

  /*!
  Returns the point of the surface at the parameters (`u`, `v`) of its domain, and all partial
  derivatives \f$ \partial^{i+j} S / \partial u^i \partial v^j \f$ with `i + j <= k`, for `k >= 0`.
  Derivatives that vanish, such as those beyond the degree of a polynomial surface, must be given as
  zero vectors.

  `CGAL::Geometric_continuity::normal()` of the result with `k == 1` is the normal
  \f$ S_u \times S_v \f$.
  */
  CGAL::Geometric_continuity::Surface_jet<Traits> jet(const Traits::FT& u, const Traits::FT& v, int k) const;

  /*!
  Returns the point at (`u`, `v`).
  */
  Traits::Point operator()(const Traits::FT& u, const Traits::FT& v) const;

  /// @}
};
