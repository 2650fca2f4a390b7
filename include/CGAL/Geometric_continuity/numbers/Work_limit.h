// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/Per_object_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_words.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>

/// \file Work_limit.h
/// Limits of the work of a decision or a construction in multi-precision, because the size of exact
/// numbers depends on the input, without a bound.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityAlgebra
/// The work that is allowed for one object: a join, an edge, a knot line, the pieces of a spline. A
/// step is about a nanosecond, the time of one or two multiplications of machine words. With
/// integers of `w` words, a sum counts as \f$ 4 + w \f$ steps and a product as \f$ 8 + w^2 \f$;
/// with fractions, a product and a sum as \f$ 450 w + 5 w^2 \f$, most of it for greatest common
/// divisors; above 512 words \f$ 512 w \f$ stands for \f$ w^2 \f$, for fast multiplication. The
/// limit is only checked in the stages that work in multi-precision; stages of fixed length are
/// short. A `Work_scope` sets it.
class Work_limit {
  std::uint64_t steps_ = default_steps;

public:
  /// The default, which takes some seconds. Ordinary joins and edges need less than its thousandth
  /// part.
  static constexpr std::uint64_t default_steps = internal::Per_object_limit::default_steps;

  /// Constructs the default.
  constexpr Work_limit() = default;
  /// Constructs a limit of so many steps.
  explicit constexpr Work_limit(std::uint64_t steps) : steps_(steps) {}

  /// Returns the number of steps.
  constexpr std::uint64_t steps() const { return steps_; }
};

namespace internal {

// Counts the steps on one object, and all of them for the scope in which it is constructed.
class Work_meter {
  const Work_limit limit_;
  const char* const place_;
  const double allowed_;
  Work_meter* const scope_ = scope();
  const std::function<void()>* pause_ = nullptr;
  double steps_ = 0, search_steps_ = 0;

public:
  // For `factor` times the limit.
  Work_meter(Work_limit limit, const char* place, double factor = 1)
      : limit_(limit), place_(place), allowed_(static_cast<double>(limit.steps()) * factor) {}
  // Makes a meter that calls pause(), which must live as long.
  Work_meter(Work_limit limit, const char* place, const std::function<void()>& pause) : Work_meter(limit, place) {
    pause_ = &pause;
  }

  // Returns the meter of the innermost Work_scope of this thread with a place, or the meter of the
  // current object: null if there is none.
  static Work_meter*& scope() {
    static thread_local Work_meter* meter = nullptr;
    return meter;
  }
  static Work_meter*& object() {
    static thread_local Work_meter* meter = nullptr;
    return meter;
  }

  // Takes note of as many sums, products or greatest common divisors of integers of so many words,
  // or of as many products with sums of fractions.
  // \throws Error `work_limit`
  void charge_sums(double number, std::size_t words) { charge(number * sum_steps(words)); }
  void charge_products(double number, std::size_t words) { charge_products(number, words, words); }
  void charge_products(double number, std::size_t words, std::size_t other_words) {
    charge(number * product_steps(words, other_words));
  }
  void charge_divisors(double number, std::size_t words, std::size_t other_words) {
    const double shorter = static_cast<double>((std::min)(words, other_words));
    charge(number * (120 * shorter + 1.6 * product_steps(words, other_words)));
  }
  void charge_fractions(double number, std::size_t words) { charge_fractions(number, words, words); }
  void charge_fractions(double number, std::size_t words, std::size_t other_words) {
    charge(number * (225 * static_cast<double>(words + other_words) + 5 * product_steps(words, other_words)));
  }

  static double sum_steps(std::size_t words) { return 4 + static_cast<double>(words); }
  static double product_steps(std::size_t words, std::size_t other_words) {
    constexpr std::size_t fast = 512;
    if (words == 0 || other_words == 0) return 0; // numbers whose work is not counted
    return 8 + static_cast<double>((std::max)(words, other_words)) *
                   static_cast<double>((std::min)({words, other_words, fast}));
  }

  // Returns whether a search that may be stopped at any time, and has taken `done` steps, may take
  // so many more; then takes note of them. Each may take a quarter of the limit, and all together
  // half of it more than the limit.
  bool allows_search(double done, double steps) {
    if (!(done + steps <= allowed_ / 4 && search_steps_ + steps <= allowed_ / 2)) return false;
    if (scope_ && !scope_->allows_search(done, steps)) return false;
    search_steps_ += steps;
    return true;
  }

  // Between two steps of something long that is not charged: calls pause() of the scopes that have
  // it.
  static void pause() {
    for (const Work_meter* meter = scope(); meter; meter = meter->scope_)
      if (meter->pause_) (*meter->pause_)();
  }

private:
  void charge(double steps) {
    if (pause_) (*pause_)();
    steps_ += steps;
    if (!(steps_ <= allowed_))
      throw Error(Error_code::work_limit,
                  std::string(place_) + ": more than " + std::to_string(limit_.steps()) + " steps of work");
    if (scope_) scope_->charge(steps);
  }
};

// The work on one object, from here to the end of the block: work_meter() counts it.
class Work_guard {
  Work_meter meter_;
  Work_meter* const before_;

public:
  // The place is named by the errors; the limit is `factor` times that of each object.
  explicit Work_guard(const char* place, double factor = 1)
      : meter_(Work_limit(Per_object_limit::steps()), place, factor),
        before_(std::exchange(Work_meter::object(), &meter_)) {}
  Work_guard(const Work_guard&) = delete;
  Work_guard& operator=(const Work_guard&) = delete;
  ~Work_guard() { Work_meter::object() = before_; }
};

// The work on an object, if this thread is not yet at work on one of which this is a part.
class Work_on_part {
  Work_meter meter_;
  Work_meter* const before_;

public:
  explicit Work_on_part(const char* place)
      : meter_(Work_limit(Per_object_limit::steps()), place), before_(Work_meter::object()) {
    if (!before_) Work_meter::object() = &meter_;
  }
  Work_on_part(const Work_on_part&) = delete;
  Work_on_part& operator=(const Work_on_part&) = delete;
  ~Work_on_part() { Work_meter::object() = before_; }
};

// The meter of the object that is at work. There must be one.
inline Work_meter& work_meter() {
  CGAL_assertion(Work_meter::object());
  return *Work_meter::object();
}

} // namespace internal

/// \ingroup PkgGeometricContinuityAlgebra
/// Limits the work of this thread, and of the threads that work for it on several cores, while an
/// object of this class lives. It limits either the work on *each* object (a join, an edge, a knot
/// line, a spline) or, with a place, *all* work, in addition to the limit of each object. The
/// latter also bounds work on other things: jets of rational curves, blends, energies, segments
/// that lead to a point, triangles; it holds for this thread only. A scope with a function also
/// calls the function again and again during long work, on numbers of any kind, so that the work
/// can be interrupted: an exception of the function ends the work.
/// \code{.cpp}
/// const GC::Work_scope each(GC::Work_limit(1000000));             // for each join
/// const auto join = GC::continuity(phi, psi);                     // may throw Error_code::work_limit, "continuity: more than ..."
///
/// const GC::Work_scope all(GC::Work_limit(1000000), "my blend");  // for the whole block
/// const auto gamma = GC::blend(phi, psi);                         // may throw Error_code::work_limit, "my blend: more than ..."
/// \endcode
class Work_scope {
  std::function<void()> pause_;
  internal::Per_object_limit each_;
  internal::Work_meter all_; // which counts when it is the scope
  internal::Work_meter* const before_ = internal::Work_meter::scope();

public:
  /// Limits the work on each object.
  explicit Work_scope(Work_limit each) : each_(each.steps()), all_(each, "") {}
  /// Starts to count all work. The place is named by the errors and must live as long as the
  /// object.
  Work_scope(Work_limit all, const char* place) : each_(internal::Per_object_limit::steps()), all_(all, place) {
    internal::Work_meter::scope() = &all_;
  }
  /// Counts without a limit, and calls `pause()` about as often as every millisecond or more often,
  /// from this thread.
  Work_scope(const char* place, std::function<void()> pause)
      : pause_(std::move(pause)), each_(internal::Per_object_limit::steps()),
        all_(Work_limit((std::numeric_limits<std::uint64_t>::max)()), place, pause_) {
    internal::Work_meter::scope() = &all_;
  }
  Work_scope(const Work_scope&) = delete;
  Work_scope& operator=(const Work_scope&) = delete;
  /// Goes back to the scope before.
  ~Work_scope() { internal::Work_meter::scope() = before_; }

  /// Calls the functions of the scopes of this thread that have one, between two steps of long work
  /// that is not of this package.
  static void pause() { internal::Work_meter::pause(); }

  /// Returns the limit of each object that holds at present.
  static Work_limit limit_of_each() { return Work_limit(internal::Per_object_limit::steps()); }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_WORK_LIMIT_H
