// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_ON_FRACTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_ON_FRACTIONS_H

#include <CGAL/Geometric_continuity/blends/internal/blend_forms.h>
#include <CGAL/Geometric_continuity/local/Coordinate_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/algebra/internal/Unreduced_vector.h>
#endif

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT, class Strategy>
constexpr bool is_blended_on_fractions = Rational_parts<FT>::value&& works_in_every_field<Strategy>;

// A blend of jets of rational numbers: each vector of the jets gets one denominator, all is computed with unreduced
// fractions, and the numbers that are returned are reduced, each once. The input has been checked.
template <class Form, class FT, int N, class Strategy>
Control_points_of_blend<Form, FT, N> blend_on_fractions(const Coordinate_jet<FT, N>& phi,
                                                        const Coordinate_jet<FT, N>& psi, const Strategy& strategy,
                                                        const Shape_parameters<FT>& shape);

#ifdef CGAL_USE_GMP

// The reduced first, inner and last points.
template <class FT, int N, std::size_t inner, std::size_t... i>
std::array<Coordinate_vector<FT, N>, inner + 2>
reduced_points(const Coordinate_vector<FT, N>& first,
               const std::array<Coordinate_vector<Unreduced_fraction<FT>, N>, inner>& b,
               const Coordinate_vector<FT, N>& last, std::index_sequence<i...>) {
  return {first, b[i].reduced()..., last};
}

template <class Form, class FT, int N, class Strategy>
Control_points_of_blend<Form, FT, N> blend_on_fractions(const Coordinate_jet<FT, N>& phi,
                                                        const Coordinate_jet<FT, N>& psi, const Strategy& strategy,
                                                        const Shape_parameters<FT>& shape) {
  typedef Unreduced_fraction<FT> Fraction;
  typedef Coordinate_vector<Fraction, N> Vector;
  typename Form::template Jet<Fraction, N> x, y;
  for (int j = 0; j <= Form::order; ++j) {
    x[j] = Vector(phi[j]);
    y[j] = Vector(psi[j]);
  }
  const auto e = Form::template ends<Fraction, N>(x, y, {Fraction(shape.beta), Fraction(shape.eta)});
  const auto reduced = [](const Fraction& s) { return s.reduced(); };
  const auto unreduced = [](const FT& s) { return Fraction(s); };
  const typename Form::template Parameters<FT> p = Form::template transform<FT>(strategy(e), reduced);
  return {reduced_points<FT, N>(phi[0], Form::inner_points(e, Form::template transform<Fraction>(p, unreduced)), psi[0],
                                std::make_index_sequence<Form::inner>()),
          p};
}

#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_ON_FRACTIONS_H
