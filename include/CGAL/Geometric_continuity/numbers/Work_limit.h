// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

/// \file Work_limit.h
/// How much work a decision in multi-precision may be: the size of exact numbers is that of the input, without a bound.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The work that is allowed for one object: a join, an edge, a knot line, the pieces of a spline. A step is about one
/// multiplication of machine words: a product or a quotient of numbers of `w` words counts as \f$ w^2 \f$ steps, above 512 words
/// as 512 `w`, for fast multiplication; a sum of integers as `w`. The limit is checked in the stages that work in multi-precision only; those of fixed length are short.
class Work_limit {
  std::uint64_t steps_ = default_steps;

public:
  /// The default, which takes some seconds. Ordinary joins and edges need less than its thousandth part.
  static constexpr std::uint64_t default_steps = 4'000'000'000;

  /// Constructs the default.
  constexpr Work_limit() = default;
  /// Constructs a limit of so many steps.
  explicit constexpr Work_limit(std::uint64_t steps) : steps_(steps) {}

  /// Returns the number of steps.
  constexpr std::uint64_t steps() const { return steps_; }
};

namespace internal {

// Counts the steps on one object.
class Work_meter {
  const Work_limit limit_;
  const char* const place_;
  const double allowed_;
  double steps_ = 0, search_steps_ = 0;

public:
  // For `factor` times the limit.
  Work_meter(Work_limit limit, const char* place, double factor = 1)
      : limit_(limit), place_(place), allowed_(static_cast<double>(limit.steps()) * factor) {}

  // Takes note of as many sums or products of numbers of so many words. \throws Error `work_limit`
  void charge_sums(double number, std::size_t words) { charge(number * words); }
  void charge_products(double number, std::size_t words) { charge_products(number, words, words); }
  void charge_products(double number, std::size_t words, std::size_t other_words) {
    charge(number * product_steps(words, other_words));
  }

  static double product_steps(std::size_t words, std::size_t other_words) {
    constexpr std::size_t fast = 512;
    return static_cast<double>((std::max)(words, other_words)) * (std::min)({words, other_words, fast});
  }

  // Whether a search that may be stopped at any time, and has taken `done` steps, may take so many more; then takes note of them.
  // Each may take a quarter of the limit, and all together half of it more than the limit.
  bool allows_search(double done, double steps) {
    if (!(done + steps <= allowed_ / 4 && search_steps_ + steps <= allowed_ / 2)) return false;
    search_steps_ += steps;
    return true;
  }

private:
  void charge(double steps) {
    steps_ += steps;
    if (!(steps_ <= allowed_))
      throw Error(Error_code::work_limit,
                  std::string(place_) + ": more than " + std::to_string(limit_.steps()) + " steps of work");
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H
