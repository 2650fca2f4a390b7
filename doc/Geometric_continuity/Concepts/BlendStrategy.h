// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

/*!
\ingroup PkgGeometricContinuityConcepts
The concept `BlendStrategy` describes a function object that chooses the scalars of a blend.

\cgalConcept

Geometric continuity determines a blend up to a few scalars. There are two kinds of strategies, and
a model has only the operator of its kind:

- a <em>quintic strategy</em> is called with `CGAL::Geometric_continuity::Quintic_ends` and chooses
  the two scalars \f$ s_1, s_2 \f$ of a blend of degree 5. The joins are \f$ G^2 \f$ whatever it
  chooses;
- a <em>septic strategy</em> is called with `CGAL::Geometric_continuity::Septic_ends` and chooses
  the three scalars \f$ \beta_2, \mu, \beta_3 \f$ at each end of a blend of degree 7. The joins are
  \f$ F^3 \f$ whatever it chooses (\f$ F^2 \f$ in the plane, where this is the highest order), and
  \f$ G^3 \f$ if it takes \f$ \mu = 3\beta\beta_2 \f$ (with \f$ \eta \f$ in the place of
  \f$ \beta \f$ at the end).

The kind is found by asking whether the operator can be called; if both can, the strategy is taken
as quintic. An operator whose parameter is an unconstrained template parameter can be called with
everything, so name the type `Quintic_ends` or `Septic_ends` in the signature.

A strategy is called after the input has been checked: both end tangents are nonzero, \f$ \beta \f$
and \f$ \eta \f$ are positive. It should use field operations only, so that it works with every
number type, and should report in `fallback_start` and `fallback_end` where its rule is undefined
and another value was used. The member `parameters` of the blend returns its choice to the caller.
`CGAL::Geometric_continuity::is_quintic_strategy_v` and
`CGAL::Geometric_continuity::is_septic_strategy_v` are true for quintic and for septic strategies.

<h3>Strategies that choose the shape</h3>

Where the caller gives no shape parameters \f$ \beta, \eta \f$, they are those of
`CGAL::Geometric_continuity::automatic_shape()`, unless the strategy has a member function
`choose()`: this is called with both jets and returns a structure with the members

- `shape`: the shape parameters, both positive, with the type
  `CGAL::Geometric_continuity::Shape_parameters<FT>`;
- `strategy`: a quintic or septic strategy for this shape, of the same kind, with which the blend is
  made;
- `report`: anything that the strategy has to say. It becomes the member `report` of the blend,
  which is a `CGAL::Geometric_continuity::Shaped_blend`.

Such a strategy also has the operator, for a shape that the caller gives.
`CGAL::Geometric_continuity::Fair` is one.

<h3>Faster exact blends</h3>

With rational numbers most of the time of a construction goes into greatest common divisors, and
with lazy numbers into the graph of the operations. A strategy that has the type
`Works_in_every_field` with the value `true` is therefore called in other fields than the field of
the traits class: with fractions that are not reduced, and, for lazy numbers, with intervals first
and with fractions when an exact value is asked for. The numbers of the blend are the same. All
strategies of the package except the fair ones allow it. It requires that

- the operator is a template over the number type `FT` of the ends, or at least can be called with
  ends over those fields;
- it uses on these numbers only `+`, `-`, `*`, `/`, comparisons with `<` and `==`, and construction
  from `int`. A number of its own is converted to `FT`. If some types `FT` cannot be made from it,
  the operator does not take part in overload resolution for these types (`std::enable_if_t`), and
  the blend is computed in the field of the traits class;
- it computes a bounded number of operations: the fractions grow with each, because they are not
  reduced;
- a comparison may throw, when an interval does not decide it, and the strategy lets the exception
  pass;
- its answer depends on nothing but its members and the ends, and its members own what they refer
  to: a copy of the strategy is kept by the lazy numbers of a blend, and called later.

A strategy that cannot be changed is allowed by a specialisation of
`CGAL::Geometric_continuity::works_in_every_field_v`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Geometric_continuity::Matching_second_derivative} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Normal_offset} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Minimal_second_derivative} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Near_line} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Minimal_energy} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Given_parameters} (quintic)
\cgalHasModels{CGAL::Geometric_continuity::Fair} (quintic, chooses the shape)
\cgalHasModels{CGAL::Geometric_continuity::Matching_third_derivative} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Sequential_g3} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Sequential_f3} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Joint_g3} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Minimal_energy_g3} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Given_end_parameters} (septic)
\cgalHasModels{CGAL::Geometric_continuity::Fair_g3} (septic, chooses the shape)
\cgalHasModels{CGAL::Geometric_continuity::Fair_f3} (septic, chooses the shape)
\cgalHasModelsEnd

\sa `CGAL::Geometric_continuity::blend()`
*/
class BlendStrategy {
public:
  /// \name Types
  /// @{

  /*!
  Optional: `CGAL::Tag_true` when the strategy may be called in other fields than the field of the
  traits class. Without this type it is only called in that field, as with `CGAL::Tag_false`.
  */
  typedef unspecified_type Works_in_every_field;

  /// @}

  /// \name Operations
  /// A model has one of these two. `FT` is the number type of the traits class, `N` its dimension,
  /// or 0 if the dimension is known at run time only.
  /// @{

  /*!
  Chooses \f$ s_1 \f$ and \f$ s_2 \f$ for the quintic blend with the ends `e`.
  */
  template <class FT, int N>
  CGAL::Geometric_continuity::Quintic_parameters<FT>
  operator()(const CGAL::Geometric_continuity::Quintic_ends<FT, N>& e) const;

  /*!
  Chooses \f$ \beta_2, \mu, \beta_3 \f$ at both ends for the septic blend with the ends `e`.
  */
  template <class FT, int N>
  CGAL::Geometric_continuity::Septic_parameters<FT>
  operator()(const CGAL::Geometric_continuity::Septic_ends<FT, N>& e) const;

  /*!
  Optional: chooses the shape parameters, and a strategy for them, for the end `phi` of the first
  and the start `psi` of the second curve, which have been checked.
  */
  template <class FT, int N>
  unspecified_type choose(const CGAL::Geometric_continuity::Coordinate_jet<FT, N>& phi,
                          const CGAL::Geometric_continuity::Coordinate_jet<FT, N>& psi) const;

  /// @}
};
