// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_conversion.h>
#include <CGAL/assertions.h>

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

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class FT> bool is_finite(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>)
    return std::isfinite(x);
  else
    return true;
}

template <class FT> struct Distinct_knots;

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// The degree `p` and the knots \f$ u_0 \le \dots \le u_{n+p} \f$ of splines with `n` coefficients. Repeated knots are
/// listed as often as they are repeated. The domain is \f$ [u_p, u_n] \f$.
///
/// A knot of multiplicity `m` inside the domain lets splines be \f$ C^{p-m} \f$ there; with `m = p + 1` they may jump.
/// The vector is \em clamped when both ends of the domain have multiplicity `p + 1`; it need not be.
///
/// The vector is a value: operations return new vectors, in \f$ O(n + p) \f$.
/// \tparam FT a field number type
template <class FT_> class Knot_vector {
public:
  typedef FT_ FT;
  typedef typename std::vector<FT>::const_iterator const_iterator;

  /// A knot and its multiplicity.
  struct Knot {
    FT value;         ///< the parameter
    int multiplicity; ///< how often it is repeated
  };

private:
  int p_;
  std::vector<FT> u_;

public:
  /// From the degree `p >= 0` and all knots.
  /// \throws Error `wrong_number_of_points` for a negative degree, and for fewer than `2 p + 2` knots
  /// \throws Error `not_finite` for an infinite or undefined floating-point number
  /// \throws Error `empty_domain` when the knots decrease somewhere, and unless \f$ u_p < u_n \f$
  /// \throws Error `knot_multiplicity` when a knot is repeated more than `p + 1` times
  Knot_vector(int degree, std::vector<FT> knots) : p_(degree), u_(std::move(knots)) { check(); }
  Knot_vector(int degree, std::initializer_list<FT> knots) : p_(degree), u_(knots) { check(); }

  /// The clamped vector on [a, b] with these knots inside, in increasing order. \throws Error as above
  Knot_vector(int degree, const FT& a, const FT& b, const std::vector<Knot>& inner_knots = {}) : p_(degree) {
    check_degree();
    append(a, p_ + 1);
    for (const Knot& knot : inner_knots) append(knot.value, knot.multiplicity);
    append(b, p_ + 1);
    check();
  }

  int degree() const { return p_; }

  /// \name Knots
  /// @{

  /// The number of knots, `n + p + 1`.
  int size() const { return static_cast<int>(u_.size()); }
  /// The number `n` of coefficients of a spline.
  int number_of_coefficients() const { return size() - p_ - 1; }
  const FT& operator[](int i) const { return u_[i]; }
  const_iterator begin() const { return u_.begin(); }
  const_iterator end() const { return u_.end(); }
  const std::vector<FT>& knots() const { return u_; }

  /// \f$ [u_p, u_n] \f$
  std::pair<FT, FT> domain() const { return {start(), finish()}; }
  bool has_domain_of(const Knot_vector& other) const { return start() == other.start() && finish() == other.finish(); }
  /// Both ends of the domain have multiplicity `p + 1`, and there is no knot outside.
  bool is_clamped() const { return u_.front() == start() && u_.back() == finish(); }

  /// How often `u` is a knot. \f$ O(\log n + p) \f$
  int multiplicity(const FT& u) const {
    const auto range = std::equal_range(u_.begin(), u_.end(), u);
    return static_cast<int>(range.second - range.first);
  }
  /// The knots of the domain, in increasing order, with their multiplicities in the whole vector.
  std::vector<Knot> distinct_knots() const {
    std::vector<Knot> knots;
    for (const FT& u : u_)
      if (contains(u)) {
        if (knots.empty() || knots.back().value != u) knots.push_back({u, 0});
        ++knots.back().multiplicity;
      }
    return knots;
  }
  /// The same without the ends of the domain.
  std::vector<Knot> inner_knots() const {
    std::vector<Knot> knots = distinct_knots();
    return std::vector<Knot>(knots.begin() + 1, knots.end() - 1);
  }

  /// The Greville abscissa \f$ (u_{i+1} + \dots + u_{i+p})/p \f$: the coefficients of the function `u`. In degree 0 the
  /// middle of the `i`-th span.
  FT greville_abscissa(int i) const {
    if (p_ == 0) return FT((u_[i] + u_[i + 1]) / FT(2));
    FT sum(0);
    for (int j = 1; j <= p_; ++j) sum += u_[i + j];
    return FT(sum / FT(p_));
  }

  /// @}
  /// \name Spans
  /// The span `k` is the interval \f$ [u_k, u_{k+1}] \f$, where it is not empty and inside the domain.
  /// @{

  /// All spans, in increasing order.
  std::vector<int> spans() const {
    std::vector<int> k;
    for (int i = p_; i < number_of_coefficients(); ++i)
      if (u_[i] < u_[i + 1]) k.push_back(i);
    return k;
  }

  /// How many there are. \f$ O(n) \f$
  int number_of_spans() const {
    int spans = 0;
    for (int i = p_; i < number_of_coefficients(); ++i) spans += u_[i] < u_[i + 1];
    return spans;
  }

  bool contains(const FT& u) const { // false for an undefined number
    return (start() < u || start() == u) && (u < finish() || u == finish());
  }

  /// The span with \f$ u_k \le u < u_{k+1} \f$, the last one at the end of the domain. \f$ O(\log n) \f$
  /// \throws Error `parameter_outside_domain`
  int span(const FT& u) const {
    check_parameter(u);
    const auto first = u_.begin() + p_ + 1, last = u_.begin() + number_of_coefficients();
    return static_cast<int>((u < finish() ? std::upper_bound(first, last, u) : std::lower_bound(first, last, u)) -
                            u_.begin()) -
           1;
  }

  /// The span with \f$ u_k < u \le u_{k+1} \f$, the first one at the start of the domain. \f$ O(\log n) \f$
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

  /// With `times >= 0` more copies of the knot `u`.
  /// \throws Error `parameter_outside_domain`, and `knot_multiplicity` when it would be repeated too often
  Knot_vector insert(const FT& u, int times = 1) const {
    CGAL_precondition(times >= 0);
    check_parameter(u);
    std::vector<FT> knots = u_;
    knots.insert(std::upper_bound(knots.begin(), knots.end(), u), static_cast<std::size_t>(times), u);
    return Knot_vector(p_, std::move(knots));
  }

  /// With `times >= 0` copies less of the knot `u`, which is inside the domain.
  /// \throws Error `knot_multiplicity` when there are not as many
  Knot_vector remove(const FT& u, int times = 1) const {
    std::vector<Knot> knots = inner_knots();
    const auto knot = std::find_if(knots.begin(), knots.end(), [&](const Knot& x) { return x.value == u; });
    if (times < 0 || times > (knot == knots.end() ? 0 : knot->multiplicity))
      throw Error(Error_code::knot_multiplicity, "Knot_vector: an inner knot that is not there is removed");
    if (knot != knots.end()) knot->multiplicity -= times;
    return with_inner_knots(knots);
  }

  /// With other knots inside the domain; the ends and the knots outside stay. \throws Error as the constructor
  Knot_vector with_inner_knots(const std::vector<Knot>& inner_knots) const {
    Knot_vector r = *this;
    r.u_.assign(u_.begin(), std::upper_bound(u_.begin(), u_.end(), start()));
    for (const Knot& knot : inner_knots) r.append(knot.value, knot.multiplicity);
    r.u_.insert(r.u_.end(), std::lower_bound(u_.begin(), u_.end(), finish()), u_.end());
    r.check();
    return r;
  }

  /// Without the knots outside the domain, and with its ends repeated `p + 1` times.
  Knot_vector clamp() const { return Knot_vector(p_, start(), finish(), inner_knots()); }

  /// Of another degree, clamped, with every knot of the domain repeated `degree + 1` times: the coefficients are
  /// those of one Bernstein polynomial for each span.
  Knot_vector bezier(int degree) const {
    std::vector<Knot> knots = inner_knots();
    for (Knot& knot : knots) knot.multiplicity = degree + 1;
    return Knot_vector(degree, start(), finish(), knots);
  }

  /// The smallest clamped vector with the inner knots of both.
  /// \throws Error `wrong_number_of_points` when the degrees differ, `parameter_outside_domain` when the domains differ
  friend Knot_vector merge(const Knot_vector& x, const Knot_vector& y) {
    if (x.p_ != y.p_) throw Error(Error_code::wrong_number_of_points, "merge: knot vectors of different degrees");
    if (!x.has_domain_of(y)) throw Error(Error_code::parameter_outside_domain, "merge: the domains differ");
    const Knot_vector c = x.clamp(), d = y.clamp();
    std::vector<FT> knots;
    std::set_union(c.begin(), c.end(), d.begin(), d.end(), std::back_inserter(knots));
    return Knot_vector(x.p_, std::move(knots));
  }

  /// The vector of the splines run through backwards, on the same domain: `u` becomes \f$ u_p + (u_n - u) \f$. With
  /// rounded numbers this rounds all knots but the ends of the domain.
  /// \throws Error `knot_multiplicity` when too many knots become equal by rounding
  Knot_vector reverse() const {
    std::vector<FT> knots;
    for (int i = size() - 1; i >= 0; --i) knots.push_back(mirrored(u_[i]));
    return Knot_vector(p_, std::move(knots));
  }

  /// @}

  /// Equality of degree and knots.
  friend bool operator==(const Knot_vector& x, const Knot_vector& y) { return x.p_ == y.p_ && x.u_ == y.u_; }
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
    if (times < 0) throw Error(Error_code::knot_multiplicity, "Knot_vector: a negative multiplicity");
    u_.insert(u_.end(), static_cast<std::size_t>(times), u);
  }

  FT mirrored(const FT& u) const {
    if (u == start()) return finish();
    if (u == finish()) return start();
    const FT r = start() + (finish() - u);
    if (!contains(u)) return r;
    return r < start() ? start() : finish() < r ? finish() : r; // which rounding can pass
  }

  void check_parameter(const FT& u) const {
    if (!contains(u)) throw Error(Error_code::parameter_outside_domain, "B-spline: the parameter");
  }

  void check_degree() const {
    if (p_ < 0) throw Error(Error_code::wrong_number_of_points, "Knot_vector: degree " + std::to_string(p_));
  }

  void check() const {
    check_degree();
    if (!is_valid()) throw_reason();
  }

  // Without a branch for each knot. Nothing is less than an undefined number, and what lies between finite ends is finite.
  bool is_valid() const {
    const int n = size(), p = p_;
    if (u_.size() < 2 * (static_cast<std::size_t>(p) + 1)) return false;
    std::ptrdiff_t good = 0;
    for (int i = 1; i < n; ++i) good += u_[i] < u_[i - 1] ? 0 : 1;
    for (int i = p + 1; i < n; ++i) good += u_[i - p - 1] < u_[i] ? 1 : 0;
    return good == 2 * n - p - 2 && start() < finish() && internal::is_finite(u_.front()) &&
           internal::is_finite(u_.back());
  }

  void throw_reason() const {
    const std::string place = "Knot_vector: ";
    if (u_.size() < 2 * (static_cast<std::size_t>(p_) + 1))
      throw Error(Error_code::wrong_number_of_points,
                  place + std::to_string(u_.size()) + " knots are too few for degree " + std::to_string(p_));
    for (const FT& u : u_) internal::check_finite(u, "Knot_vector");
    for (int i = 1; i < size(); ++i)
      if (u_[i] < u_[i - 1])
        throw Error(Error_code::empty_domain, place + "knot " + std::to_string(i) + " is less than the one before it");
    if (!(start() < finish())) throw Error(Error_code::empty_domain, place + "the ends of the domain are equal");
    for (int i = p_ + 1; i < size(); ++i)
      if (u_[i - p_ - 1] == u_[i])
        throw Error(Error_code::knot_multiplicity, place + "knot " + std::to_string(i) + " is repeated more than " +
                                                       std::to_string(p_ + 1) + " times");
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_KNOT_VECTOR_H
