// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POINT_SUMS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POINT_SUMS_H

#include <CGAL/Geometric_continuity/numbers/internal/Rational_parts.h>
#include <CGAL/Geometric_continuity/surfaces/internal/patch_sums.h>

#ifdef CGAL_USE_GMP
#include <CGAL/Geometric_continuity/algebra/internal/Unreduced_vector.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Point_sums.h
/// The points of a patch or an edge at equidistant parameters, as sums of its control points.
/// Rational numbers are summed as integers over one denominator, and a coordinate is reduced once,
/// when the sum is complete.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The values of the Bernstein polynomials of a degree at s / (s + t), multiplied by (s + t)^degree.
template <class Number> std::vector<Number> bernstein_weights(int degree, const Number& s, const Number& t) {
  std::vector<Number> b(degree + 2, Number(0)); // with a zero in front
  b[1] = Number(1);
  for (int m = 1; m <= degree; ++m) raise_bernstein_values(b, m, s, t);
  b.erase(b.begin());
  return b;
}

// The sum of the points `net[first]`, `net[first + 1]`, ... with weights.
template <class Number, class Vector>
Vector weighted_sum(const std::vector<Number>& weights, const std::vector<Vector>& net, std::size_t first = 0) {
  Vector sum = weights[0] * net[first];
  for (std::size_t i = 1; i < weights.size(); ++i) sum += weights[i] * net[first + i];
  return sum;
}

// The control points, homogeneous ones of a rational patch, are those of the patch, or of an edge
// of it.
template <class Patch, bool rational = Rational_parts<typename Patch::FT>::value> class Point_sums {
  typedef typename Patch::FT FT;
  typedef std::decay_t<decltype(summand(std::declval<const Patch&>(), 0, 0))> Summand;

  const Patch& patch_;
  std::vector<Summand> net_;

public:
  typedef FT Number;
  typedef Summand Vector;

  Point_sums(const Patch& patch, std::vector<Summand> net) : patch_(patch), net_(std::move(net)) {}

  const std::vector<Vector>& net() const { return net_; }

  // Returns for each k from 0 to n the Bernstein polynomials at k/n. A point is a sum with the
  // weights of each call.
  std::vector<std::vector<Number>> weights(int degree, std::size_t n) {
    std::vector<std::vector<Number>> w;
    for (std::size_t k = 0; k <= n; ++k) {
      const FT t = FT(FT(static_cast<int>(k)) / FT(static_cast<int>(n)));
      w.push_back(bernstein_weights(degree, FT(FT(1) - t), t));
    }
    return w;
  }

  typename Patch::Point point(const Vector& sum) const { return point_of_sum(patch_, sum); }

  // Takes note of as many products of weights and control points.
  void charge(double) const {}
};

#ifdef CGAL_USE_GMP

template <class Vector> struct With_integers;
template <class FT, int M> struct With_integers<Coordinate_vector<FT, M>> {
  typedef Coordinate_vector<Inline_integer, M> type;
};

template <class Patch> class Point_sums<Patch, true> {
  typedef typename Patch::FT FT;
  typedef typename Patch::Traits Traits;
  typedef std::decay_t<decltype(summand(std::declval<const Patch&>(), 0, 0))> Summand;

public:
  typedef Inline_integer Number;
  typedef typename With_integers<Summand>::type Vector;

private:
  int dimension_;           // of the points; homogeneous ones have a coordinate more
  std::vector<Vector> net_; // the numerators
  Unreduced_denominator denominator_;
  std::size_t words_ = 1, weight_words_ = 1; // of the longest numerator and weight

public:
  Point_sums(const Patch& patch, const std::vector<Summand>& net) : dimension_(patch.dimension()) {
    const int m = net[0].dimension();
    Coordinate_vector<FT, 0> all(static_cast<int>(net.size()) * m);
    for (std::size_t i = 0; i < net.size(); ++i)
      for (int x = 0; x < m; ++x) all[static_cast<int>(i) * m + x] = net[i][x];
    const Coordinate_vector<Unreduced_fraction<FT>, 0> cleared(all);
    for (std::size_t i = 0; i < net.size(); ++i) {
      net_.emplace_back(m);
      for (int x = 0; x < m; ++x) net_[i][x] = cleared[static_cast<int>(i) * m + x].numerator();
      for (const Number& x : net_[i]) words_ = (std::max)(words_, x.size());
    }
    denominator_ = cleared[0].denominator();
  }

  const std::vector<Vector>& net() const { return net_; }

  std::vector<std::vector<Number>> weights(int degree, std::size_t n) {
    std::vector<std::vector<Number>> w;
    std::size_t words = 1; // all weights for a k have the sum n^degree
    for (std::size_t i = n; i > 1; i /= 2) words += static_cast<std::size_t>(degree);
    words = 1 + words / 64;
    weight_words_ += words;
    for (std::size_t k = 0; k <= n; ++k) {
      if (Work_meter* const work = Work_meter::scope()) {
        work->charge_products(degree * (degree + 1.), words, 1);
        work->charge_sums(16. * degree, words); // memory
      }
      w.push_back(bernstein_weights(degree, Number(static_cast<int>(n - k)), Number(static_cast<int>(k))));
    }
    Unreduced_denominator d{Number(static_cast<int>(n)), 0};
    d.k = d.d.remove_twos();
    for (int i = 0; i < degree; ++i) denominator_ *= d;
    return w;
  }

  typename Patch::Point point(const Vector& sum) const {
    Coordinates<Traits> x(dimension_);
    // the last coordinate is positive, the denominator cancels
    const bool homogeneous = sum.dimension() > dimension_;
    for (int i = 0; i < dimension_; ++i)
      x[i] = homogeneous ? Rational_parts<FT>::make(sum[i], sum[dimension_], 0)
                         : Rational_parts<FT>::make(sum[i], denominator_.d, denominator_.k);
    return to_point<Traits>(x);
  }

  void charge(double number) const {
    if (Work_meter* const work = Work_meter::scope())
      work->charge_products(number * net_[0].dimension(), words_, weight_words_);
  }
};

#endif // CGAL_USE_GMP

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_POINT_SUMS_H
