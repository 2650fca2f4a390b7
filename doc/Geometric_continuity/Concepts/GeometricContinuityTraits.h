// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgGeometricContinuityConcepts
The concept `GeometricContinuityTraits` gives the numbers, points and vectors of a kernel to the
package, under names that do not depend on the dimension.

\cgalConcept

A traits class has no state: the package constructs one wherever it needs one.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geometric_continuity::Traits_2}
\cgalHasModels{CGAL::Geometric_continuity::Traits_3}
\cgalHasModels{CGAL::Geometric_continuity::Traits_d}
\cgalHasModelsEnd

\sa `ParametricCurve`
*/
class GeometricContinuityTraits {
public:
  /// \name Types
  /// @{

  /*!
  A field number type. It must be default constructible, copyable and constructible from `int`, and
  provide the operators `+`, `-`, `*`, `/`, `+=`, `-=`, `*=`, `/=`, the unary `-`, and the
  comparisons `==`, `!=` and `<`.

  Nothing else is needed for jets, curves, splines, joins, edges, blends, including fair ones, and
  the signs and roots of polynomials. Only functions that report numbers require more: boxes and the
  guaranteed enclosures of deviations, roots and angles call `CGAL::to_interval()` (an exact number
  that is evaluated on demand gives its exact value by a member `exact()`), unit vectors and lengths
  such as `CGAL::Geometric_continuity::Frenet_frame::normalized()` call `CGAL::sqrt()`, and the
  output operators write numbers with `<<`.

  The decisions of the package are exact if the operations of the number type in which they are made
  are exact (see `Predicate_FT`). `float`, `double` and `long double` are recognised: infinities and
  undefined values are then refused with the reason `not_finite`.
  */
  typedef unspecified_type FT;

  /*!
  A point. It must be default constructible and copyable; curves can be compared if points can be
  compared with `==`.
  */
  typedef unspecified_type Point;

  /*!
  A vector. It must be copyable.
  */
  typedef unspecified_type Vector;

  /*!
  The dimension: `CGAL::Dimension_tag<n>` with `n` >= 2, or `CGAL::Dynamic_dimension_tag` if it is
  known at run time only.
  */
  typedef unspecified_type Dimension;

  /*!
  Optional. The number type in which predicates are decided; `FT` if the traits class does not have
  this type. It must fulfil the requirements of `FT` and, if it is another type, be constructible
  from `FT` without rounding.

  A traits class over rounded numbers whose predicates shall be exact sets it to an exact field such
  as `CGAL::Geometric_continuity::Exact_field<FT>::type`, as the three models do for kernels with
  exact predicates and inexact constructions.
  */
  typedef unspecified_type Predicate_FT;

  /*!
  A function object with the two operators

  - `int operator()(const Point& p) const`
  - `int operator()(const Vector& v) const`

  which return the number of coordinates.
  */
  typedef unspecified_type Compute_dimension;

  /*!
  A function object with the two operators

  - `FT operator()(const Point& p, int i) const`
  - `FT operator()(const Vector& v, int i) const`

  which return the `i`-th %Cartesian coordinate, `0 <= i < n`, by value or by constant reference.
  */
  typedef unspecified_type Compute_coordinate;

  /*!
  A function object with the operator

  - `template <class RandomAccessIterator>`<br>
    `Point operator()(int n, RandomAccessIterator first, RandomAccessIterator last) const`

  which returns the point with the `n` coordinates in the range [`first`, `last`), whose value type
  is `FT`.
  */
  typedef unspecified_type Construct_point;

  /*!
  A function object with the operator

  - `template <class RandomAccessIterator>`<br>
    `Vector operator()(int n, RandomAccessIterator first, RandomAccessIterator last) const`

  which returns the vector with the `n` coordinates in the range [`first`, `last`), whose value type
  is `FT`.
  */
  typedef unspecified_type Construct_vector;

  /// @}

  /// \name Creation
  /// @{

  /// The default constructor. A constant object must also be constructible without an initializer.
  GeometricContinuityTraits();

  /// @}

  /// \name Operations
  /// The package does not use the names of the four types of function objects, but only these
  /// functions.
  /// @{

  /// The function object that counts coordinates.
  Compute_dimension compute_dimension_object() const;

  /// The function object that reads coordinates.
  Compute_coordinate compute_coordinate_object() const;

  /// The function object that constructs points.
  Construct_point construct_point_object() const;

  /// The function object that constructs vectors.
  Construct_vector construct_vector_object() const;

  /// @}
};
