// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/splines/internal/check_spline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Knot_vector.h
/// The knots of B-splines, and the knots of other splines that are made of them. De Boor, "A
/// Practical Guide to Splines".

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class FT> struct Distinct_knots;

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The degree `p` and the knots \f$ u_0 \le \dots \le u_{n+p} \f$ of splines with `n` coefficients.
/// Repeated knots are listed as often as they are repeated. The domain is \f$ [u_p, u_n] \f$.
///
/// A knot of multiplicity `m` inside the domain lets splines be \f$ C^{p-m} \f$ there; with
/// `m = p + 1` they may jump. The vector is \em clamped when both ends of the domain have
/// multiplicity `p + 1`; it need not be.
///
/// The vector is a value: operations return new vectors, in \f$ O(n + p) \f$.
/// \tparam FT a field number type
template <class FT_> class Knot_vector {
public:
  typedef FT_ FT;                                                  ///< the number type
  typedef typename std::vector<FT>::const_iterator const_iterator; ///< a random-access iterator

  /// A knot and its multiplicity.
  struct Knot {
    FT value;         ///< the parameter
    int multiplicity; ///< how often it is repeated
  };

private:
  static_assert(std::is_constructible_v<FT, int>,
                "Knot_vector takes the type of its numbers, as in Knot_vector<double>");

  int p_;
  std::vector<FT> u_;

public:
  /// Constructs a vector from the degree `p >= 0` and all knots.
  /// \throws Error `wrong_number_of_points` for a negative degree, and for fewer than `2 p + 2`
  ///   knots
  /// \throws Error `not_finite` for an infinite or undefined floating-point number, and when the
  ///   distance of the first and the last knot overflows
  /// \throws Error `empty_domain` when the knots decrease somewhere, and unless \f$ u_p < u_n \f$
  /// \throws Error `knot_multiplicity` when a knot is repeated more than `p + 1` times
  Knot_vector(int degree, std::vector<FT> knots) : p_(degree), u_(std::move(knots)) { check(); }
  /// Constructs a vector from the degree `p >= 0` and all knots, numbers of another type.
  /// \throws Error as the constructor from knots of type `FT`
  template <class Number> Knot_vector(int degree, const std::vector<Number>& knots) : p_(degree) {
    for (const Number& u : knots) u_.push_back(internal::Convertible_number<FT>(u).value);
    check();
  }
  /// Constructs a vector from the degree `p >= 0` and all knots.
  /// \throws Error as the constructor from a `std::vector`
  Knot_vector(int degree, std::initializer_list<FT> knots) : p_(degree), u_(knots) { check(); }

  /// Constructs the clamped vector on [a, b] with these knots inside, in increasing order.
  /// \throws Error `negative_count` for a negative multiplicity, and as the constructor from all
  ///   knots
  Knot_vector(int degree, const FT& a, const FT& b, const std::vector<Knot>& inner_knots = {}) : p_(degree) {
    internal::check_degree(p_);
    append(a, p_ + 1);
    for (const Knot& knot : inner_knots) append(knot.value, knot.multiplicity);
    append(b, p_ + 1);
    check();
  }

  // Knots without a degree before them, also in braces: one error of the compiler instead of a list
  // of all constructors.
  template <class Knots = std::vector<FT>,
            class = std::enable_if_t<std::is_convertible_v<const Knots&, std::vector<FT>>>, class... After>
  explicit Knot_vector(const Knots&, const After&...) {
    static_assert(!std::is_same_v<Knots, Knots>, "Knot_vector: the degree is missing, which stands before the knots");
  }

  /// Returns the degree `p`.
  int degree() const { return p_; }

  /// \name Knots
  /// @{

  /// Returns the number of knots, `n + p + 1`.
  int size() const { return static_cast<int>(u_.size()); }
  /// Returns the number `n` of coefficients of a spline.
  int number_of_coefficients() const { return size() - p_ - 1; }
  /// Returns \f$ u_i \f$, `0 <= i < size()`.
  const FT& operator[](int i) const { return u_[i]; }
  /// Returns an iterator to the first knot.
  const_iterator begin() const { return u_.begin(); }
  /// Returns the iterator behind the last knot.
  const_iterator end() const { return u_.end(); }
  /// Returns all knots.
  const std::vector<FT>& knots() const { return u_; }

  /// Returns the ends of the domain, \f$ u_p \f$ and \f$ u_n \f$.
  std::pair<FT, FT> domain() const { return {start(), finish()}; }
  /// Decides whether both vectors have the same domain.
  bool has_domain_of(const Knot_vector& other) const { return start() == other.start() && finish() == other.finish(); }
  /// Decides whether both ends of the domain have multiplicity `p + 1`, so that there is no knot
  /// outside.
  bool is_clamped() const { return u_.front() == start() && u_.back() == finish(); }

  /// Returns how often `u` is a knot. \f$ O(\log n + p) \f$
  int multiplicity(const FT& u) const {
    const auto range = std::equal_range(u_.begin(), u_.end(), u);
    return static_cast<int>(range.second - range.first);
  }
  /// Returns the knots of the domain, in increasing order, with their multiplicities in the whole
  /// vector. \f$ O(n + p) \f$
  std::vector<Knot> distinct_knots() const {
    std::vector<Knot> knots;
    for (const FT& u : u_)
      if (contains(u)) {
        if (knots.empty() || knots.back().value != u) knots.push_back({u, 0});
        ++knots.back().multiplicity;
      }
    return knots;
  }
  /// Returns the knots inside the domain, in increasing order, with their multiplicities.
  /// \f$ O(n + p) \f$
  std::vector<Knot> inner_knots() const {
    std::vector<Knot> knots = distinct_knots();
    return std::vector<Knot>(knots.begin() + 1, knots.end() - 1);
  }

  /// Returns the Greville abscissa \f$ (u_{i+1} + \dots + u_{i+p})/p \f$, `0 <= i < n`: the
  /// coefficients of the function `u`. In degree 0 the middle between \f$ u_i \f$ and
  /// \f$ u_{i+1} \f$. \f$ O(p) \f$
  /// \throws Error `parameter_outside_domain` unless `0 <= i < n`
  FT greville_abscissa(int i) const {
    if (i < 0 || number_of_coefficients() <= i)
      throw Error(Error_code::parameter_outside_domain, "greville_abscissa: coefficient " + std::to_string(i));
    const int first = p_ == 0 ? i : i + 1, count = p_ == 0 ? 2 : p_;
    FT sum(0);
    for (int j = 0; j < count; ++j) sum += u_[first + j];
    if (internal::is_finite(sum)) return FT(sum / FT(count));
    FT mean(0); // of numbers whose sum overflows
    for (int j = 0; j < count; ++j) mean += u_[first + j] / FT(count);
    return mean;
  }

  /// @}
  /// \name Spans
  /// The span `k` is the interval \f$ [u_k, u_{k+1}] \f$, where it is not empty and inside the
  /// domain.
  /// @{

  /// Returns all spans, in increasing order. \f$ O(n) \f$
  std::vector<int> spans() const {
    std::vector<int> k;
    for (int i = p_; i < number_of_coefficients(); ++i)
      if (u_[i] < u_[i + 1]) k.push_back(i);
    return k;
  }

  /// Returns the number of spans. \f$ O(n) \f$
  int number_of_spans() const {
    int spans = 0;
    for (int i = p_; i < number_of_coefficients(); ++i) spans += u_[i] < u_[i + 1];
    return spans;
  }

  /// Decides whether `u` is in the domain; an undefined number is not.
  bool contains(const FT& u) const { return (start() < u || start() == u) && (u < finish() || u == finish()); }

  /// Returns the span with \f$ u_k \le u < u_{k+1} \f$, the last one at the end of the domain.
  /// \f$ O(\log n) \f$
  /// \throws Error `parameter_outside_domain`
  int span(const FT& u) const {
    check_parameter(u);
    const auto first = u_.begin() + p_ + 1, last = u_.begin() + number_of_coefficients();
    return static_cast<int>((u < finish() ? std::upper_bound(first, last, u) : std::lower_bound(first, last, u)) -
                            u_.begin()) -
           1;
  }

  /// Returns the span with \f$ u_k < u \le u_{k+1} \f$, the first one at the start of the domain.
  /// \f$ O(\log n) \f$
  /// \throws Error `parameter_outside_domain`
  int left_span(const FT& u) const {
    check_parameter(u);
    const auto first = u_.begin() + p_ + 1, last = u_.begin() + number_of_coefficients();
    return static_cast<int>((start() < u ? std::lower_bound(first, last, u) : std::upper_bound(first, last, u)) -
                            u_.begin()) -
           1;
  }

  /// @}
  /// \name Other Knot Vectors
  /// @{

  /// Returns the vector with `times >= 0` more copies of the knot `u`.
  /// \throws Error `negative_count` when `times` is negative, `parameter_outside_domain`, and
  ///   `knot_multiplicity` when `u` would be repeated too often
  Knot_vector insert(const FT& u, int times = 1) const {
    check_times(times);
    check_parameter(u);
    const const_iterator place = std::upper_bound(begin(), end(), u);
    std::vector<FT> knots;
    knots.reserve(u_.size() + times);
    knots.assign(begin(), place);
    knots.insert(knots.end(), static_cast<std::size_t>(times), u);
    knots.insert(knots.end(), place, end());
    return Knot_vector(p_, std::move(knots));
  }

  /// Returns the vector with `times >= 0` copies less of the knot `u`, which is inside the domain.
  /// \throws Error `negative_count` when `times` is negative, `knot_multiplicity` when there are
  ///   not as many
  Knot_vector remove(const FT& u, int times = 1) const {
    check_times(times);
    std::vector<Knot> knots = inner_knots();
    const auto knot = std::find_if(knots.begin(), knots.end(), [&](const Knot& x) { return x.value == u; });
    if (times > (knot == knots.end() ? 0 : knot->multiplicity))
      throw Error(Error_code::knot_multiplicity, "Knot_vector: an inner knot that is not there is removed");
    if (knot != knots.end()) knot->multiplicity -= times;
    return with_inner_knots(knots);
  }

  /// Returns the vector with other knots inside the domain; the ends and the knots outside stay.
  /// \throws Error as the constructor from inner knots
  Knot_vector with_inner_knots(const std::vector<Knot>& inner_knots) const {
    Knot_vector r = *this;
    r.u_.assign(u_.begin(), std::upper_bound(u_.begin(), u_.end(), start()));
    for (const Knot& knot : inner_knots) r.append(knot.value, knot.multiplicity);
    r.u_.insert(r.u_.end(), std::lower_bound(u_.begin(), u_.end(), finish()), u_.end());
    r.check();
    return r;
  }

  /// Returns the vector without the knots outside the domain, and with its ends repeated `p + 1`
  /// times.
  Knot_vector clamp() const { return Knot_vector(p_, start(), finish(), inner_knots()); }

  /// Returns the clamped vector on [a, b], to which the domain is mapped. \throws Error
  /// `empty_domain` unless `a < b`
  Knot_vector on_domain(const FT& a, const FT& b) const {
    if (a == start() && b == finish()) return clamp();
    const FT factor = FT(FT(b - a) / FT(finish() - start()));
    std::vector<Knot> knots = inner_knots();
    for (Knot& knot : knots) knot.value = FT(a + factor * FT(knot.value - start()));
    return Knot_vector(p_, a, b, knots);
  }

  /// Returns the clamped vector of another degree with every knot of the domain repeated
  /// `degree + 1` times: the coefficients are those of one Bernstein polynomial for each span.
  /// \throws Error `wrong_number_of_points` for a negative degree
  Knot_vector bezier(int degree) const {
    internal::check_degree(degree);
    std::vector<Knot> knots = inner_knots();
    for (Knot& knot : knots) knot.multiplicity = degree + 1;
    return Knot_vector(degree, start(), finish(), knots);
  }

  /// Returns the smallest clamped vector with the inner knots of both.
  /// \throws Error `wrong_number_of_points` when the degrees differ, `parameter_outside_domain`
  ///   when the domains differ
  friend Knot_vector merge(const Knot_vector& x, const Knot_vector& y) {
    if (x.p_ != y.p_) throw Error(Error_code::wrong_number_of_points, "merge: knot vectors of different degrees");
    if (!x.has_domain_of(y)) throw Error(Error_code::parameter_outside_domain, "merge: the domains differ");
    const Knot_vector c = x.clamp(), d = y.clamp();
    std::vector<FT> knots;
    std::set_union(c.begin(), c.end(), d.begin(), d.end(), std::back_inserter(knots));
    return Knot_vector(x.p_, std::move(knots));
  }

  /// Returns the knots of the reversed splines, on the same domain: `u` becomes
  /// \f$ u_p + (u_n - u) \f$. With rounded numbers this rounds all knots but the ends of the
  /// domain.
  /// \throws Error `knot_multiplicity` when too many knots become equal by rounding
  Knot_vector reverse() const {
    std::vector<FT> knots;
    for (int i = size() - 1; i >= 0; --i) knots.push_back(mirrored(u_[i]));
    return Knot_vector(p_, std::move(knots));
  }

  /// @}

  /// Decides whether degree and knots are equal.
  friend bool operator==(const Knot_vector& x, const Knot_vector& y) { return x.p_ == y.p_ && x.u_ == y.u_; }
  /// Decides whether the degree or a knot is different.
  friend bool operator!=(const Knot_vector& x, const Knot_vector& y) { return !(x == y); }

  /// Writes the knots, separated by spaces.
  friend std::ostream& operator<<(std::ostream& os, const Knot_vector& x) {
    for (int i = 0; i < x.size(); ++i) os << (i == 0 ? "" : " ") << x[i];
    return os;
  }

private:
  friend struct internal::Distinct_knots<FT>; // whose knots need no check
  struct Correct_by_construction {};
  Knot_vector(int degree, std::vector<FT> knots, Correct_by_construction) : p_(degree), u_(std::move(knots)) {}

  const FT& start() const { return u_[p_]; }
  const FT& finish() const { return u_[number_of_coefficients()]; }

  void append(const FT& u, int times) {
    check_times(times);
    u_.insert(u_.end(), static_cast<std::size_t>(times), u);
  }

  FT mirrored(const FT& u) const {
    if (u == start()) return finish();
    if (u == finish()) return start();
    const FT r = start() + (finish() - u);
    if (!contains(u)) return r;
    return finish() < r ? finish() : r; // which rounding can pass
  }

  void check_parameter(const FT& u) const {
    if (!contains(u)) throw Error(Error_code::parameter_outside_domain, "B-spline: the parameter");
  }

  static void check_times(int times) {
    if (times < 0) throw Error(Error_code::negative_count, "Knot_vector: a knot " + std::to_string(times) + " times");
  }

  void check() const { internal::check_knots(p_, u_); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H
