// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/local/internal/divide_derivatives.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Curve_jet.h
/// The point and the first derivatives of a curve at one parameter, and those at the two ends of
/// any curve, in any field: all that joins and blends read of a curve. A curve that offers
/// `end_jet_over` and `start_jet_over` derives them in that field from its control points as they
/// are, so that a predicate on curves with `double` coordinates is exact. For any other model of
/// `ParametricCurve`, the jet that it returns is converted. And the jets of homogeneous points
/// \f$ (p, w) = (w x, w) \f$: from their derivatives to those of \f$ x = p / w \f$, and back.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {
// Asks for numbers that are not initialised, for those who set them all.
struct Unspecified {};
} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k` in coordinates: the point and the first `k` derivatives of a curve at one
/// parameter. All functions that read a jet are written on this type; `Curve_jet` adds the types of
/// a kernel.
///
/// The coordinates can be written, and are not checked: a function that needs finite numbers looks
/// at them itself.
///
/// \tparam FT a field number type
/// \tparam N the dimension, or 0 when it is known at run time only
template <class FT_, int N> class Coordinate_jet {
public:
  typedef FT_ FT;                               ///< the field
  typedef Coordinate_vector<FT, N> Vector_type; ///< the point and the derivatives

  /// The empty jet, of order -1.
  Coordinate_jet() = default;

  /// The zero jet of order `k` in dimension `d`. No memory is allocated up to order 5.
  /// \throws Error `negative_count` unless `k >= 0` and `d >= 0`, `dimension_mismatch` unless
  ///   `d == N` or `N == 0`
  Coordinate_jet(int d, int k) : order_(k) {
    check(d, k);
    for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  // The jet with numbers that are not initialised when N > 0.
  Coordinate_jet(int d, int k, internal::Unspecified) : order_(k) {
    check(d, k);
    if constexpr (N == 0)
      for (int j = 0; j <= k && j < inlined; ++j) inlined_[j] = Vector_type(d);
    if (k >= inlined) more_.assign(k + 1 - inlined, Vector_type(d));
  }

  /// Returns the number of derivatives; -1 for an empty jet.
  int order() const { return order_; }
  /// Returns the dimension; 0 for an empty jet.
  int dimension() const { return order_ < 0 ? 0 : inlined_[0].dimension(); }

  /// Returns the `j`-th derivative; the point for `j == 0`. \pre `0 <= j <= order()`
  const Vector_type& operator[](int j) const { return j < inlined ? inlined_[j] : more_[j - inlined]; }
  /// Gives access to the `j`-th derivative; to the point for `j == 0`. \pre `0 <= j <= order()`
  Vector_type& operator[](int j) { return j < inlined ? inlined_[j] : more_[j - inlined]; }

  /// Returns whether the orders and all coordinates are equal.
  friend bool operator==(const Coordinate_jet& x, const Coordinate_jet& y) {
    if (x.order() != y.order()) return false;
    for (int j = 0; j <= x.order(); ++j)
      if (x[j] != y[j]) return false;
    return true;
  }
  /// Returns whether the orders or some coordinates differ.
  friend bool operator!=(const Coordinate_jet& x, const Coordinate_jet& y) { return !(x == y); }

private:
  static constexpr int inlined = 6;
  int order_ = -1;
  std::array<Vector_type, inlined> inlined_;
  std::vector<Vector_type> more_;

  CGAL_GC_FORCEINLINE static void check(int d, int k) {
    internal::check_count(k, "jet: order");
    internal::check_count(d, "jet: dimension");
  }
};

/// \ingroup PkgGeometricContinuityLocal
/// A jet of order `k`: the point \f$ x \f$ and the derivatives \f$ x', \dots, x^{(k)} \f$ of a
/// curve at one parameter. Blends and continuity tests read nothing else of a curve.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> class Curve_jet : public Coordinate_jet<typename Traits_::FT, dimension_v<Traits_>> {
  typedef Coordinate_jet<typename Traits_::FT, dimension_v<Traits_>> Base;

public:
  typedef Traits_ Traits;                 ///< the traits class
  typedef typename Traits::FT FT;         ///< the field
  typedef typename Traits::Point Point;   ///< the points of the kernel
  typedef typename Traits::Vector Vector; ///< the vectors of the kernel

  /// The empty jet, of order -1.
  Curve_jet() = default;

  /// Takes a jet in coordinates, which are not checked.
  explicit Curve_jet(Base jet) : Base(std::move(jet)) {}

  /// The zero jet of order `k` in dimension `d`.
  /// \throws Error `negative_count` unless `k >= 0` and `d >= 0`, `dimension_mismatch` unless `d`
  ///   is the dimension of the traits class
  Curve_jet(int d, int k) : Base(d, k) {}

  // The jet with numbers that are not initialised when the dimension is known at compile time.
  Curve_jet(int d, int k, internal::Unspecified unspecified) : Base(d, k, unspecified) {}

  /// Takes the point and the range of the derivatives, lowest order first.
  /// \throws Error `dimension_mismatch` when they do not have one dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  template <class ForwardRange>
  Curve_jet(const Point& point, const ForwardRange& derivatives)
      : Base(Traits().compute_dimension_object()(point),
             static_cast<int>(std::distance(std::begin(derivatives), std::end(derivatives)))) {
    set(0, Geometric_continuity::coordinates<Traits>(point));
    int j = 0;
    for (const Vector& v : derivatives) set(++j, Geometric_continuity::coordinates<Traits>(v));
  }
  /// Takes the point and a list of the derivatives, lowest order first.
  /// \throws Error `dimension_mismatch` when they do not have one dimension
  /// \throws Error `not_finite` for an infinite or undefined floating-point coordinate
  Curve_jet(const Point& point, std::initializer_list<Vector> derivatives)
      : Curve_jet(point, std::vector<Vector>(derivatives)) {}

  /// Returns the point. \pre the jet is not empty
  Point point() const { return Geometric_continuity::to_point<Traits>((*this)[0]); }

  /// Returns the `j`-th derivative. \pre `1 <= j <= order()`
  Vector derivative(int j) const { return Geometric_continuity::to_vector<Traits>((*this)[j]); }

  /// Writes the point and the derivatives, one to a line.
  friend std::ostream& operator<<(std::ostream& os, const Curve_jet& jet) {
    for (int j = 0; j <= jet.order(); ++j) {
      for (int i = 0; i < jet.dimension(); ++i) os << (i == 0 ? "" : " ") << jet[j][i];
      os << '\n';
    }
    return os;
  }

private:
  void set(int j, const Geometric_continuity::Coordinates<Traits>& c) {
    if (c.dimension() != this->dimension())
      throw Error(Error_code::dimension_mismatch, "jet: derivative " + std::to_string(j));
    for (const FT& x : c) internal::check_finite(x, "jet");
    (*this)[j] = c;
  }
};

namespace internal {

// The jet with its coordinates taken over to another field.
template <class Field, class FT, int N> Coordinate_jet<Field, N> convert_jet(const Coordinate_jet<FT, N>& jet) {
  if (jet.order() < 0) return Coordinate_jet<Field, N>();
  Coordinate_jet<Field, N> r(jet.dimension(), jet.order());
  for (int j = 0; j <= jet.order(); ++j)
    for (int i = 0; i < jet.dimension(); ++i) r[j][i] = to_field<Field>(jet[j][i]);
  return r;
}

template <class Field, class Curve, class = void> struct Has_end_jets_over : std::false_type {};
template <class Field, class Curve>
struct Has_end_jets_over<Field, Curve,
                         std::void_t<decltype(std::declval<const Curve&>().template end_jet_over<Field>(0)),
                                     decltype(std::declval<const Curve&>().template start_jet_over<Field>(0))>>
    : std::true_type {};

// Recognises types with two parameters, so that a surface in the place of a curve is refused by one
// sentence.
template <class T, class = void> constexpr bool is_surface = false;
template <class T> constexpr bool is_surface<T, std::void_t<decltype(std::declval<const T&>().domain_v())>> = true;

} // namespace internal

/// \ingroup PkgGeometricContinuityLocal
/// Returns the point and the first `order` derivatives of a curve at the end of its domain, as
/// numbers of `Field`.
///
/// Exact in an exact field when the curve offers `end_jet_over<Field>(order)` (see
/// `ParametricCurve`), as all curves of this package do; otherwise `curve.jet()` at the end of the
/// domain, converted.
///
/// \tparam Field a field number type into which the numbers of the curve can be converted
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `order >= 0`
template <class Field, class Curve>
Coordinate_jet<Field, dimension_v<typename Curve::Traits>> end_jet(const Curve& curve, int order) {
  internal::check_count(order, "end_jet: order");
  if constexpr (internal::Has_end_jets_over<Field, Curve>::value)
    return curve.template end_jet_over<Field>(order);
  else
    return internal::convert_jet<Field>(curve.jet(curve.domain().second, order));
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the point and the first `order` derivatives of a curve at the start of its domain, as
/// numbers of `Field`.
///
/// Exact in an exact field when the curve offers `start_jet_over<Field>(order)` (see
/// `ParametricCurve`), as all curves of this package do; otherwise `curve.jet()` at the start of
/// the domain, converted.
///
/// \tparam Field a field number type into which the numbers of the curve can be converted
/// \tparam Curve a model of `ParametricCurve`
/// \throws Error `negative_count` unless `order >= 0`
template <class Field, class Curve>
Coordinate_jet<Field, dimension_v<typename Curve::Traits>> start_jet(const Curve& curve, int order) {
  internal::check_count(order, "start_jet: order");
  if constexpr (internal::Has_end_jets_over<Field, Curve>::value)
    return curve.template start_jet_over<Field>(order);
  else
    return internal::convert_jet<Field>(curve.jet(curve.domain().first, order));
}

/// \ingroup PkgGeometricContinuityLocal
/// The jets at the two ends of a curve, in place of the curve: all that decisions about joins read.
/// `continuity()`, `deviation()`, `order_within()` and `Chain_accumulator` take it like a curve, up
/// to the order of the jets.
///
/// \tparam Traits_ a model of `GeometricContinuityTraits`
template <class Traits_> class Curve_end_jets {
  static constexpr int N = dimension_v<Traits_>;
  typedef Coordinate_jet<typename Traits_::FT, N> Jet;

public:
  typedef Traits_ Traits;         ///< the traits class
  typedef typename Traits::FT FT; ///< the field

  /// Takes the jets at the start and the end, of one order.
  /// \throws Error `dimension_mismatch`, `jet_order_too_low` when the orders differ or the jets are
  ///   empty
  Curve_end_jets(Jet start, Jet end) : start_(std::move(start)), end_(std::move(end)) {
    if (start_.dimension() != end_.dimension()) throw Error(Error_code::dimension_mismatch, "Curve_end_jets");
    if (start_.order() != end_.order() || end_.order() < 0)
      throw Error(Error_code::jet_order_too_low,
                  "Curve_end_jets: " + std::to_string(start_.order()) + " and " + std::to_string(end_.order()));
  }
  /// Takes the jets of order `k` of a curve. \throws Error `negative_count` unless `k >= 0`
  template <class Curve>
  Curve_end_jets(const Curve& curve, int k) : Curve_end_jets(Jet(curve.start_jet(k)), Jet(curve.end_jet(k))) {}

  /// Returns the dimension of the space.
  int dimension() const { return end_.dimension(); }
  /// Returns the order of the jets.
  int order() const { return end_.order(); }

  /// Returns the jet of order `k` at the start. \throws Error `negative_count`, `jet_order_too_low`
  /// unless `0 <= k <= order()`
  Curve_jet<Traits> start_jet(int k) const { return Curve_jet<Traits>(start_jet_over<FT>(k)); }
  /// Returns the jet of order `k` at the end. \throws Error `negative_count`, `jet_order_too_low`
  /// unless `0 <= k <= order()`
  Curve_jet<Traits> end_jet(int k) const { return Curve_jet<Traits>(end_jet_over<FT>(k)); }
  /// Returns the jet of order `k` at the start in another field.
  /// \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  template <class Field> Coordinate_jet<Field, N> start_jet_over(int k) const { return part<Field>(start_, k); }
  /// Returns the jet of order `k` at the end in another field.
  /// \throws Error `negative_count`, `jet_order_too_low` unless `0 <= k <= order()`
  template <class Field> Coordinate_jet<Field, N> end_jet_over(int k) const { return part<Field>(end_, k); }

private:
  Jet start_, end_;

  template <class Field> static Coordinate_jet<Field, N> part(const Jet& jet, int k) {
    internal::check_count(k, "Curve_end_jets: order");
    if (k > jet.order())
      throw Error(Error_code::jet_order_too_low, "Curve_end_jets: " + std::to_string(k) + " is asked for, " +
                                                     std::to_string(jet.order()) + " is there");
    Coordinate_jet<Field, N> r(jet.dimension(), k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < jet.dimension(); ++i) r[j][i] = internal::to_field<Field>(jet[j][i]);
    return r;
  }
};

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the curve \f$ x = p / w \f$ from that of its homogeneous points
/// \f$ (p, w) \f$: \f$ x_k = (p_k - \sum_{j=1}^k \binom{k}{j} w_j x_{k-j}) / w_0 \f$.
/// \f$ O(n k^2) \f$
/// \tparam M one more than the dimension of \f$ x \f$, or 0
/// \throws Error `zero_weight` when \f$ w_0 = 0 \f$, `jet_order_too_low` for an empty jet
template <class FT, int M> Coordinate_jet<FT, (M == 0 ? 0 : M - 1)> project(const Coordinate_jet<FT, M>& p) {
  if (p.order() < 0) throw Error(Error_code::jet_order_too_low, "project");
  const int n = p.dimension() - 1;
  Coordinate_jet<FT, (M == 0 ? 0 : M - 1)> x(n, p.order(), internal::Unspecified());
  internal::Work_meter* const work = internal::scope_of<FT>();
  std::size_t words = 1; // of the denominators
  if (work) {
    for (int k = 0; k <= p.order(); ++k) words = (std::max)(words, internal::number_words(p[k][n]));
    work->charge_fractions(n * (p.order() + 1.), words); // the first of each of the sums
  }
  if (internal::project_short<FT>(p, n, p.order(), x)) return x;
  internal::require_denominator(p[0][n], "the denominator of a rational curve");
  const FT inverse = FT(FT(1) / p[0][n]);
  internal::for_each_binomial_row<FT>(p.order(), [&](int k, const auto& binomial) {
    for (int i = 0; i < n; ++i) {
      if (work && k > 0) work->charge_fractions(k / 2., internal::number_words(x[k - 1][i]), words);
      FT sum = p[k][i];
      for (int j = 1; j <= k; ++j) sum -= binomial[j] * p[j][n] * x[k - j][i];
      x[k][i] = FT(sum * inverse);
    }
  });
  return x;
}

/// \ingroup PkgGeometricContinuityLocal
/// Returns the jet of the homogeneous points \f$ (p, w) \f$ of a curve from that of
/// \f$ x = p / w \f$ and the derivatives \f$ w_0, w_1, \dots \f$ of the denominator, which may be
/// chosen freely:
/// \f$ p_k = \sum_{j=0}^k \binom{k}{j} w_j x_{k-j} \f$. Derivatives of the denominator that are not
/// given are zero. \f$ O(n k^2) \f$
/// \param x the jet
/// \param weights a container of numbers
/// \throws Error `zero_weight` when \f$ w_0 \f$ is zero or missing, `jet_order_too_low` for an
///   empty jet
template <class FT, int N, class Weights>
Coordinate_jet<FT, (N == 0 ? 0 : N + 1)> lift(const Coordinate_jet<FT, N>& x, const Weights& weights) {
  if (x.order() < 0) throw Error(Error_code::jet_order_too_low, "lift");
  const int n = x.dimension();
  Coordinate_jet<FT, (N == 0 ? 0 : N + 1)> p(n + 1, x.order());
  int given = 0;
  for (const FT& w : weights)
    if (given <= x.order()) p[given++][n] = w;
  internal::require_denominator(p[0][n], "the denominator of a rational curve");
  internal::for_each_binomial_row<FT>(x.order(), [&](int k, const auto& binomial) {
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < n; ++i) p[k][i] += binomial[j] * p[j][n] * x[k - j][i];
  });
  return p;
}

/// \ingroup PkgGeometricContinuityLocal
/// Many jets of order `k` in dimension `N` as a structure of arrays: for each derivative and each
/// coordinate one array with the numbers of all jets. This is the layout in which a processor
/// computes several jets at a time.
/// \tparam FT a field number type, usually `double`
template <class FT_, int N, int k> class Jet_arrays {
  static_assert(N > 0 && k >= 0);
  std::size_t size_ = 0, stride_ = 0;
  std::vector<FT_> numbers_;

public:
  typedef FT_ FT; ///< the field

  /// No jets.
  Jet_arrays() = default;
  /// `n` jets with unspecified numbers.
  explicit Jet_arrays(std::size_t n) { resize(n); }

  /// Changes the number of jets. The numbers are unspecified afterwards; no memory is allocated
  /// when there is enough.
  void resize(std::size_t n) {
    size_ = n;
    // An odd number of cache lines lies between two arrays: else their numbers would compete for a
    // few lines of the cache.
    constexpr std::size_t line = 8;
    stride_ = line * ((n + line - 1) / line | 1);
    numbers_.resize(stride_ * (k + 1) * N);
  }
  /// Returns the number of jets.
  std::size_t size() const { return size_; }

  /// Gives access to the coordinates number `i` of the derivatives of order `j` of all jets, an
  /// array of `size()` numbers.
  /// \pre `0 <= j <= k`, `0 <= i < N`
  FT* array(int j, int i) { return numbers_.data() + (j * N + i) * stride_; }
  /// Returns the coordinates number `i` of the derivatives of order `j` of all jets, an array of
  /// `size()` numbers.
  /// \pre `0 <= j <= k`, `0 <= i < N`
  const FT* array(int j, int i) const { return numbers_.data() + (j * N + i) * stride_; }

  /// Returns the jet number `at`. \pre `at < size()`
  Coordinate_jet<FT, N> jet(std::size_t at) const {
    Coordinate_jet<FT, N> r(N, k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < N; ++i) r[j][i] = array(j, i)[at];
    return r;
  }

  /// Replaces the jet number `at`. \pre `at < size()`
  /// \throws Error `jet_order_too_low` unless the jet has at least the order `k`
  /// \throws Error `dimension_mismatch` unless it has the dimension `N`
  template <int M> void set(std::size_t at, const Coordinate_jet<FT, M>& jet) {
    if (jet.order() < k) throw Error(Error_code::jet_order_too_low, "Jet_arrays::set");
    if (jet.dimension() != N) throw Error(Error_code::dimension_mismatch, "Jet_arrays::set");
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < N; ++i) array(j, i)[at] = jet[j][i];
  }
};

/// \ingroup PkgGeometricContinuityAlgebra
/// The partial Bell polynomials \f$ B_{k,m}(x_1, x_2, \dots) \f$, the coefficients of Faà di
/// Bruno's formula:
/// \f$ (X \circ \varphi)^{(k)} = \sum_m B_{k,m}(\varphi', \varphi'', \dots)\, X^{(m)} \f$.
///
/// The variables are appended one after the other, as a chain of joins determines them; each append
/// of the `k`-th variable costs \f$ O(k^2) \f$ products.
template <class FT> class Bell_polynomials {
  std::vector<FT> x_; // x_[j-1] = j-th variable
  // rows_[k][m-2] = B_{k,m} for m >= 2
  std::vector<std::vector<FT>> rows_ = std::vector<std::vector<FT>>(1);
  // row k-1 of Pascal's triangle
  std::vector<FT> binomials_{FT(1)};

public:
  /// Returns \f$ B_{k,m} \f$ for `2 <= m <= k`. It depends on the first `k - m + 1` variables only,
  /// so it is known as soon as the first `k - 1` variables have been appended; that they have been,
  /// and the range of `m`, is the caller's duty.
  const FT& operator()(int k, int m) const { return rows_[k - 1][m - 2]; }

  /// Appends the next variable, \f$ x_{k-1} \f$, and so makes the row \f$ B_{k,\cdot} \f$ known.
  void append(const FT& x) {
    x_.push_back(x);
    const int k = static_cast<int>(x_.size()) + 1;
    binomials_.push_back(FT(1));
    for (int i = k - 2; i > 0; --i) binomials_[i] += binomials_[i - 1];
    std::vector<FT> row;
    for (int m = 2; m <= k; ++m) {
      FT sum(0);
      for (int i = 1; i <= k - m + 1; ++i)
        sum += binomials_[i - 1] * x_[i - 1] * (m == 2 ? x_[k - i - 1] : rows_[k - i - 1][m - 3]);
      row.push_back(sum);
    }
    rows_.push_back(row);
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_CURVE_JET_H
