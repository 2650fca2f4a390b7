// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_LAZILY_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_LAZILY_H

#include <CGAL/Geometric_continuity/blends/internal/blend_on_fractions.h>
#include <CGAL/Geometric_continuity/numbers/internal/Jointly_lazy.h>
#include <CGAL/Uncertain.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class FT, class Strategy> constexpr bool is_blended_lazily = false;
template <class ET, class Strategy>
constexpr bool is_blended_lazily<Lazy_exact_nt<ET>, Strategy> = is_blended_on_fractions<ET, Strategy>;

// given parameters may be lazy numbers themselves; there is little to compute
template <class ET, class FT> constexpr bool is_blended_lazily<Lazy_exact_nt<ET>, Given_parameters<FT>> = false;
template <class ET, class FT> constexpr bool is_blended_lazily<Lazy_exact_nt<ET>, Given_end_parameters<FT>> = false;

// The function that blend_lazily() leaves for later: the inner control points and the parameters, one after the other.
template <class Form, class ET, int N, class Strategy> struct Exact_numbers_of_blend {
  typename Form::template Jet<Lazy_exact_nt<ET>, N> phi, psi;
  Strategy strategy;
  Shape_parameters<Lazy_exact_nt<ET>> shape;

  std::vector<ET> operator()() const {
    const int dimension = phi[0].dimension();
    Coordinate_jet<ET, N> x(dimension, Form::order), y(dimension, Form::order);
    for (int j = 0; j <= Form::order; ++j)
      for (int i = 0; i < dimension; ++i) {
        x[j][i] = phi[j][i].exact();
        y[j][i] = psi[j][i].exact();
      }
    const Control_points_of_blend<Form, ET, N> r =
        blend_on_fractions<Form>(x, y, strategy, Shape_parameters<ET>{shape.beta.exact(), shape.eta.exact()});
    std::vector<ET> numbers;
    for (std::size_t j = 1; j <= Form::inner; ++j)
      numbers.insert(numbers.end(), r.points[j].begin(), r.points[j].end());
    Form::template transform<ET>(r.parameters, [&](const ET& s) { return numbers.push_back(s), s; });
    return numbers;
  }
};

// A blend of jets of lazy numbers as one lazy construction: intervals at once, the numbers on fractions when the exact value
// of one of them is asked for. Nothing where the intervals do not tell which case of its definition the strategy is in.
template <class Form, class ET, int N, class Strategy>
std::optional<Control_points_of_blend<Form, Lazy_exact_nt<ET>, N>>
blend_lazily(const Coordinate_jet<Lazy_exact_nt<ET>, N>& phi, const Coordinate_jet<Lazy_exact_nt<ET>, N>& psi,
             const Strategy& strategy, const Shape_parameters<Lazy_exact_nt<ET>>& shape) {
  typedef Lazy_exact_nt<ET> FT;
  typedef Interval_nt<false> Interval;
  const int dimension = phi.dimension();

  Exact_numbers_of_blend<Form, ET, N, Strategy> exact{{}, {}, strategy, shape};
  typename Form::template Parameters<Interval> chosen;
  std::vector<Interval> enclosures;
  try {
    const typename Interval::Protector protector;
    typename Form::template Jet<Interval, N> x, y;
    for (int j = 0; j <= Form::order; ++j) {
      exact.phi[j] = phi[j];
      exact.psi[j] = psi[j];
      x[j] = y[j] = Coordinate_vector<Interval, N>(dimension);
      for (int i = 0; i < dimension; ++i) {
        x[j][i] = phi[j][i].approx();
        y[j][i] = psi[j][i].approx();
      }
    }
    const auto e = Form::template ends<Interval, N>(x, y, {shape.beta.approx(), shape.eta.approx()});
    chosen = strategy(e);
    for (const Coordinate_vector<Interval, N>& b : Form::inner_points(e, chosen))
      enclosures.insert(enclosures.end(), b.begin(), b.end());
    Form::template transform<Interval>(chosen, [&](const Interval& s) { return enclosures.push_back(s), s; });
  } catch (const Uncertain_conversion_exception&) {
    return std::nullopt;
  }

  const std::vector<FT> numbers = jointly_lazy<ET>(enclosures, std::move(exact));
  typename std::vector<FT>::const_iterator next = numbers.begin();
  Control_points_of_blend<Form, FT, N> r;
  r.points.front() = phi[0];
  for (std::size_t j = 1; j <= Form::inner; ++j) {
    r.points[j] = Coordinate_vector<FT, N>(dimension);
    for (int i = 0; i < dimension; ++i) r.points[j][i] = *next++;
  }
  r.points.back() = psi[0];
  r.parameters = Form::template transform<FT>(chosen, [&](const Interval&) { return *next++; });
  return r;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_BLEND_LAZILY_H
