// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_EXACT_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_EXACT_BLEND_H

#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/algebra/internal/Unreduced_vector.h>
#endif

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

// Exact blends by a strategy that works in every field: on rational numbers the formulas are
// computed with unreduced fractions, and each number of the result is reduced once; on lazy numbers
// with intervals, and with fractions when an exact value is asked for. A template Ends is
// Quintic_ends or Septic_ends, whose formulas these are.

namespace CGAL {

// Types of CGAL that are declared here and not defined: who has such numbers has included their
// header.
template <class ET> class Lazy_exact_nt;
template <class ET> struct Lazy_exact_nt_rep;

namespace Geometric_continuity {
namespace internal {

// The exact values of lazy numbers that one function computes together, when the first of them is
// asked for.
template <class ET, class Function> class Joint_evaluation {
  std::mutex mutex_;
  std::optional<Function> function_;
  std::vector<ET> values_;

public:
  explicit Joint_evaluation(Function function) : function_(std::move(function)) {}

  const ET& value(std::size_t i) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (function_) {
      values_ = (*function_)();
      function_.reset(); // with the lazy numbers that it reads
    }
    return values_[i];
  }
};

// One of these numbers: CGAL asks for its exact value at most once.
template <class ET, class Function> class Jointly_lazy final : public Lazy_exact_nt_rep<ET> {
  typedef Joint_evaluation<ET, Function> Evaluation;
  mutable std::shared_ptr<Evaluation> evaluation_;
  std::size_t i_;

public:
  Jointly_lazy(const Interval_nt<false>& enclosure, std::shared_ptr<Evaluation> evaluation, std::size_t i)
      : Lazy_exact_nt_rep<ET>(enclosure), evaluation_(std::move(evaluation)), i_(i) {}

  void update_exact() const override {
    // owned by the base class
    auto* exact = new typename Lazy_exact_nt_rep<ET>::Indirect(evaluation_->value(i_));
    this->set_at(exact);
    this->set_ptr(exact);
    evaluation_.reset();
  }
};

// The numbers of the vector that function() returns as lazy numbers, given intervals that contain
// them.
template <class ET, class Function>
std::vector<Lazy_exact_nt<ET>> jointly_lazy(const std::vector<Interval_nt<false>>& enclosures, Function function) {
  const auto evaluation = std::make_shared<Joint_evaluation<ET, Function>>(std::move(function));
  std::vector<Lazy_exact_nt<ET>> numbers;
  numbers.reserve(enclosures.size());
  for (std::size_t i = 0; i < enclosures.size(); ++i)
    // owned by the handle
    numbers.emplace_back(new Jointly_lazy<ET, Function>(enclosures[i], evaluation, i));
  return numbers;
}

// The control points of a blend, and what its strategy chose.
template <template <class, int> class Ends, class FT, int N> struct Exact_blend {
  std::array<Coordinate_vector<FT, N>, Ends<FT, N>::degree + 1> points;
  typename Ends<FT, N>::Parameters parameters;
};

// The point and the derivatives that Ends reads.
template <template <class, int> class Ends, class FT, int N>
using Derivatives = std::array<Coordinate_vector<FT, N>, Ends<FT, N>::order + 1>;

#ifdef CGAL_USE_GMP

// unreachable: computed by the compiler
template <template <class, int> class Ends, class FT, int N, class Strategy> constexpr bool is_blended_on_fractions() {
  if constexpr (Rational_parts<FT>::value && works_in_every_field_v<Strategy>)
    return std::is_invocable_v<const Strategy&, const Ends<Unreduced_fraction<FT>, N>&>;
  else
    return false;
}

// The first point, the reduced inner points, and the last point.
template <class FT, int N, std::size_t inner, std::size_t... i>
std::array<Coordinate_vector<FT, N>, inner + 2>
reduced_points(const Coordinate_vector<FT, N>& first,
               const std::array<Coordinate_vector<Unreduced_fraction<FT>, N>, inner>& b,
               const Coordinate_vector<FT, N>& last, std::index_sequence<i...>) {
  return {first, b[i].reduced()..., last};
}

// A blend of jets of rational numbers, which have been checked. Each vector of the jets gets one
// denominator.
template <template <class, int> class Ends, class FT, int N, class Strategy>
Exact_blend<Ends, FT, N> blend_on_fractions(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi,
                                            const Strategy& strategy, const Shape_parameters<FT>& shape) {
  typedef Unreduced_fraction<FT> Fraction;
  typedef Coordinate_vector<Fraction, N> Vector;
  Derivatives<Ends, Fraction, N> x, y;
  for (int j = 0; j <= Ends<FT, N>::order; ++j) {
    x[j] = Vector(phi[j]);
    y[j] = Vector(psi[j]);
  }
  const Ends<Fraction, N> e(x, y, {Fraction(shape.beta), Fraction(shape.eta)});
  const typename Ends<FT, N>::Parameters p =
      strategy(e).template transform<FT>([](const Fraction& s) { return s.reduced(); });
  const auto b = e.inner_points(p.template transform<Fraction>([](const FT& s) { return Fraction(s); }));
  return {reduced_points<FT, N>(phi[0], b, psi[0], std::make_index_sequence<Ends<FT, N>::degree - 1>()), p};
}

#else

// unreachable: computed by the compiler
template <template <class, int> class Ends, class FT, int N, class Strategy> constexpr bool is_blended_on_fractions() {
  return false;
}

// Named where it is not called.
template <template <class, int> class Ends, class FT, int N, class Strategy>
Exact_blend<Ends, FT, N> blend_on_fractions(const Coordinate_jet<FT, N>& phi, const Coordinate_jet<FT, N>& psi,
                                            const Strategy& strategy, const Shape_parameters<FT>& shape);

#endif // CGAL_USE_GMP

// The exact numbers behind the lazy ones, void for other number types.
template <class FT> struct Behind_lazy { typedef void type; };
template <class ET> struct Behind_lazy<Lazy_exact_nt<ET>> { typedef ET type; };

// unreachable: computed by the compiler
template <template <class, int> class Ends, class FT, int N, class Strategy> constexpr bool is_blended_lazily() {
  typedef typename Behind_lazy<FT>::type ET;
  if constexpr (std::is_void_v<ET>)
    return false;
  else if constexpr (is_blended_on_fractions<Ends, ET, N, Strategy>())
    return std::is_invocable_v<const Strategy&, const Ends<Interval_nt<false>, N>&>;
  else
    return false;
}

// The function that blend_lazily() leaves for later: the inner control points and the parameters,
// one after the other.
template <template <class, int> class Ends, class ET, int N, class Strategy> struct Exact_numbers_of_blend {
  Derivatives<Ends, Lazy_exact_nt<ET>, N> phi, psi;
  Strategy strategy;
  Shape_parameters<Lazy_exact_nt<ET>> shape;

  std::vector<ET> operator()() const {
    const int dimension = phi[0].dimension(), order = Ends<ET, N>::order;
    Coordinate_jet<ET, N> x(dimension, order), y(dimension, order);
    for (int j = 0; j <= order; ++j)
      for (int i = 0; i < dimension; ++i) {
        x[j][i] = phi[j][i].exact();
        y[j][i] = psi[j][i].exact();
      }
    const Exact_blend<Ends, ET, N> r =
        blend_on_fractions<Ends>(x, y, strategy, Shape_parameters<ET>{shape.beta.exact(), shape.eta.exact()});
    std::vector<ET> numbers;
    for (std::size_t j = 1; j + 1 < r.points.size(); ++j)
      numbers.insert(numbers.end(), r.points[j].begin(), r.points[j].end());
    r.parameters.template transform<ET>([&](const ET& s) { return numbers.push_back(s), s; });
    return numbers;
  }
};

// A blend of jets of lazy numbers as one lazy construction: intervals at once, the numbers on
// fractions when the exact value of one of them is asked for. Nothing where the intervals do not
// tell which case of its definition the strategy is in.
template <template <class, int> class Ends, class ET, int N, class Strategy>
std::optional<Exact_blend<Ends, Lazy_exact_nt<ET>, N>>
blend_lazily(const Coordinate_jet<Lazy_exact_nt<ET>, N>& phi, const Coordinate_jet<Lazy_exact_nt<ET>, N>& psi,
             const Strategy& strategy, const Shape_parameters<Lazy_exact_nt<ET>>& shape) {
  typedef Lazy_exact_nt<ET> FT;
  typedef Interval_nt<false> Interval;
  const int dimension = phi.dimension();

  Exact_numbers_of_blend<Ends, ET, N, Strategy> exact{{}, {}, strategy, shape};
  typename Ends<Interval, N>::Parameters chosen;
  std::vector<Interval> enclosures;
  try {
    const typename Interval::Protector protector;
    Derivatives<Ends, Interval, N> x, y;
    for (std::size_t j = 0; j < x.size(); ++j) {
      exact.phi[j] = phi[static_cast<int>(j)];
      exact.psi[j] = psi[static_cast<int>(j)];
      x[j] = y[j] = Coordinate_vector<Interval, N>(dimension);
      for (int i = 0; i < dimension; ++i) {
        x[j][i] = exact.phi[j][i].approx();
        y[j][i] = exact.psi[j][i].approx();
      }
    }
    const Ends<Interval, N> e(x, y, {shape.beta.approx(), shape.eta.approx()});
    chosen = strategy(e);
    for (const Coordinate_vector<Interval, N>& b : e.inner_points(chosen))
      enclosures.insert(enclosures.end(), b.begin(), b.end());
    chosen.template transform<Interval>([&](const Interval& s) { return enclosures.push_back(s), s; });
  } catch (const Uncertain_conversion_exception&) {
    return std::nullopt;
  }

  const std::vector<FT> numbers = jointly_lazy<ET>(enclosures, std::move(exact));
  typename std::vector<FT>::const_iterator next = numbers.begin();
  Exact_blend<Ends, FT, N> r;
  r.points.front() = phi[0];
  for (std::size_t j = 1; j + 1 < r.points.size(); ++j) {
    r.points[j] = Coordinate_vector<FT, N>(dimension);
    for (int i = 0; i < dimension; ++i) r.points[j][i] = *next++;
  }
  r.points.back() = psi[0];
  r.parameters = chosen.template transform<FT>([&](const Interval&) { return *next++; });
  return r;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_EXACT_BLEND_H
