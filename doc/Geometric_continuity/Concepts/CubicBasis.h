// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgGeometricContinuityConcepts
The concept `CubicBasis` describes a basis of cubic curves \f$ Q(t) = G\,M\,[t^3\ t^2\ t\ 1]^T \f$:
the meaning of the four columns of the geometry \f$ G \f$, and the matrix \f$ M \f$.

\cgalConcept

A model is a copyable function object without references to anything. For a matrix of your own that
acts on four points, `CGAL::Geometric_continuity::Matrix_basis` is enough.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geometric_continuity::Hermite_basis}
\cgalHasModels{CGAL::Geometric_continuity::Bezier_basis}
\cgalHasModels{CGAL::Geometric_continuity::Catmull_rom_basis}
\cgalHasModels{CGAL::Geometric_continuity::Cardinal_basis}
\cgalHasModels{CGAL::Geometric_continuity::Uniform_bspline_basis}
\cgalHasModels{CGAL::Geometric_continuity::Matrix_basis}
\cgalHasModelsEnd

\sa `CGAL::Geometric_continuity::Cubic_blended_curve`
*/
class CubicBasis {
public:
  /// \name Types
  /// @{

  /*!
  The geometry: `std::array<Traits::Point, 4>` or
  `CGAL::Geometric_continuity::Hermite_geometry<Traits>`.
  */
  template <class Traits> using Geometry = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /*!
  The matrix, in every field that curves and predicates use. Numbers such as 1/6 must be computed in
  `FT`, so that they are exact where `FT` is.
  */
  template <class FT> CGAL::Geometric_continuity::Basis_matrix<FT> matrix() const;

  /// @}
};
