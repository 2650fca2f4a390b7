// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_JOINTLY_LAZY_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_JOINTLY_LAZY_H

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {

// Types of CGAL that are declared here and not defined: who has such numbers has included their header.
template <class ET> class Lazy_exact_nt;
template <class ET> struct Lazy_exact_nt_rep;

namespace Geometric_continuity {
namespace internal {

// The exact values of lazy numbers that one function computes together, when the first of them is asked for.
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
    auto* exact = new typename Lazy_exact_nt_rep<ET>::Indirect(evaluation_->value(i_)); // owned by the base class
    this->set_at(exact);
    this->set_ptr(exact);
    evaluation_.reset();
  }
};

// The numbers of the vector that function() returns as lazy numbers, given intervals that contain them.
template <class ET, class Function>
std::vector<Lazy_exact_nt<ET>> jointly_lazy(const std::vector<Interval_nt<false>>& enclosures, Function function) {
  const auto evaluation = std::make_shared<Joint_evaluation<ET, Function>>(std::move(function));
  std::vector<Lazy_exact_nt<ET>> numbers;
  numbers.reserve(enclosures.size());
  for (std::size_t i = 0; i < enclosures.size(); ++i)
    numbers.emplace_back(new Jointly_lazy<ET, Function>(enclosures[i], evaluation, i)); // owned by the handle
  return numbers;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_JOINTLY_LAZY_H
