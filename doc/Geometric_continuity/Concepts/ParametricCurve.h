// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgGeometricContinuityConcepts
The concept `ParametricCurve` describes a curve that can be blended and whose joins can be decided.

\cgalConcept

The curve must be able to give its derivatives at both ends of its domain, and nothing more:
`CGAL::Geometric_continuity::blend()` and `CGAL::Geometric_continuity::continuity()` read it by
`CGAL::Geometric_continuity::end_jet()` and `CGAL::Geometric_continuity::start_jet()` only.

The left curve of a join is read at the end of its domain, and the right curve at the start.

\cgalHasModelsBegin \cgalHasModels{CGAL::Geometric_continuity::Bezier_curve}
\cgalHasModels{CGAL::Geometric_continuity::Composite_bezier_curve}
\cgalHasModels{CGAL::Geometric_continuity::Bspline_curve}
\cgalHasModels{CGAL::Geometric_continuity::Cubic_blended_curve}
\cgalHasModels{CGAL::Geometric_continuity::Rational_curve}: `Rational_bezier_curve`,
`Rational_bspline_curve` \cgalHasModels{CGAL::Geometric_continuity::Quintic_blend}
\cgalHasModels{CGAL::Geometric_continuity::Septic_blend} \cgalHasModelsEnd

\sa `GeometricContinuityTraits`
*/
class ParametricCurve {
public:
  /// \name Types
  /// @{

  /*!
  A model of `GeometricContinuityTraits`. Two curves that are blended or whose join is decided must
  have the same traits class.
  */
  typedef unspecified_type Traits;

  /// @}

  /// \name Operations
  /// @{

  /*!
  Returns the parameters at which the curve starts and ends.
  */
  std::pair<Traits::FT, Traits::FT> domain() const;

  /*!
  Returns the point of the curve and its first `k` derivatives with respect to the parameter, at the
  parameter `u`.

  It is called with `k >= 0` at the two ends of the domain; by swept surfaces and
  `uniform_polyline()`, with the parameters at which they are evaluated, and by
  `CGAL::Geometric_continuity::fairness()` and `CGAL::Geometric_continuity::bending_energy()`, with
  those of a quadrature and `k == 3`. A quintic blend asks for `k == 2`, a septic one for `k == 3`;
  `CGAL::Geometric_continuity::continuity()` asks for the larger of 3 and the order that its caller
  wants to know. Derivatives that vanish, such as those beyond the degree of a polynomial curve,
  must be given as zero vectors. A jet of lower order is refused by blends with the reason
  `jet_order_too_low`, and limits the order that is reported for a join.
  */
  CGAL::Geometric_continuity::Curve_jet<Traits> jet(const Traits::FT& u, int k) const;

  /// @}

  /// \name Optional Operations
  /// A curve may have both of these functions or none; `CGAL::Geometric_continuity::end_jet()`
  /// looks for them. They let a predicate read the curve in the field in which it decides
  /// (`GeometricContinuityTraits::Predicate_FT`), before anything has been rounded. If a curve does
  /// not have them, the result of `jet()` is converted: the decision is then exact for the
  /// derivatives as `jet()` returns them.
  /// @{

  /*!
  Returns the jet of order `k >= 0` at the start of the domain, in coordinates of type `Field`. `N`
  is the dimension, or 0 if it is known at run time only.
  */
  template <class Field> CGAL::Geometric_continuity::Coordinate_jet<Field, N> start_jet_over(int k) const;

  /*!
  Returns the jet of order `k >= 0` at the end of the domain, in coordinates of type `Field`.
  */
  template <class Field> CGAL::Geometric_continuity::Coordinate_jet<Field, N> end_jet_over(int k) const;

  /// @}
};
