// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_FAILING_JOINS_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_FAILING_JOINS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <utility>
#include <vector>

/// \file failing_joins.h
/// One question about each of many joins, on several cores if wanted, is answered by
/// `failing_joins()`. The question is a predicate, or any function of two curves that returns a
/// `bool`:
///
/// \code{.cpp}
/// const auto is_g2 = [](const Curve& left, const Curve& right) { return is_g2_join(left, right); };
/// for (std::size_t i : failing_joins<CGAL::Parallel_if_available_tag>(chain, is_g2))
///   std::cout << "curves " << i << " and " << i + 1 << '\n';
/// \endcode
///
/// The curves are read once, in order and where they are. Predicates are called concurrently unless
/// the tag is `Sequential_tag`: those of join_predicates.h may be, on number types that may be
/// copied concurrently, like the number types of all kernels with floating-point numbers and
/// rational numbers. An exception that a predicate throws leaves the function.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The numbers 0 <= i < n with !holds(i), in increasing order.
template <class Concurrency_tag, class Predicate>
std::vector<std::size_t> failing_indices(std::size_t n, const Predicate& holds) {
  typedef std::vector<std::size_t> Indices;
  std::vector<Indices> found; // those of one block each, in the order in which blocks are done
  std::mutex mutex;
  for_each_block<Concurrency_tag>(n, [&](std::size_t begin, std::size_t end) {
    Indices failing;
    for (std::size_t i = begin; i < end; ++i)
      if (!holds(i)) failing.push_back(i);
    if (failing.empty()) return;
    const std::lock_guard<std::mutex> lock(mutex);
    found.push_back(std::move(failing));
  });
  std::sort(found.begin(), found.end(), [](const Indices& x, const Indices& y) { return x[0] < y[0]; });
  Indices all;
  for (const Indices& failing : found) all.insert(all.end(), failing.begin(), failing.end());
  return all;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of a chain of curves at which `holds` is false: numbers \f$ i \f$ in
/// increasing order, for the join between the curves \f$ i \f$ and \f$ i + 1 \f$, counted from 0
/// on. Empty for a chain without joins, i.e. of at most one curve.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam RandomAccessIterator over curves, or whatever `holds` takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is
///   `Sequential_tag`
///
/// One call of `holds` for each join; memory is allocated for the joins that fail only.
template <class Concurrency_tag = Sequential_tag, class RandomAccessIterator, class Predicate>
std::vector<std::size_t> failing_joins(RandomAccessIterator first, RandomAccessIterator last, const Predicate& holds) {
  typedef typename std::iterator_traits<RandomAccessIterator>::difference_type Difference;
  const Difference n = last - first;
  return internal::failing_indices<Concurrency_tag>(n < 2 ? 0 : static_cast<std::size_t>(n - 1), [&](std::size_t i) {
    const RandomAccessIterator left = first + static_cast<Difference>(i);
    return bool(holds(left[0], left[1]));
  });
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of the curves of a range, such as a `std::vector`, at which `holds` is false.
template <class Concurrency_tag = Sequential_tag, class Range, class Predicate>
std::vector<std::size_t> failing_joins(const Range& chain, const Predicate& holds) {
  return failing_joins<Concurrency_tag>(std::begin(chain), std::end(chain), holds);
}

/// \ingroup PkgGeometricContinuityContinuity
/// Returns the joins of many pairs of curves at which `holds` is false: numbers \f$ i \f$ in
/// increasing order, for the join between the left curve \f$ i \f$ and the right curve \f$ i \f$,
/// counted from 0 on.
///
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \tparam Left_iterator, Right_iterator random access iterators over curves, or whatever `holds`
///   takes
/// \tparam Predicate called as `holds(left, right)`, concurrently unless the tag is
///   `Sequential_tag`
///
/// One call of `holds` for each join; memory is allocated for the joins that fail only.
/// \throws Error `wrong_number_of_points` when there are not as many right curves as left ones
template <class Concurrency_tag = Sequential_tag, class Left_iterator, class Right_iterator, class Predicate>
std::vector<std::size_t> failing_joins(Left_iterator left, Left_iterator left_end, Right_iterator right,
                                       Right_iterator right_end, const Predicate& holds) {
  typedef typename std::iterator_traits<Left_iterator>::difference_type Left_difference;
  typedef typename std::iterator_traits<Right_iterator>::difference_type Right_difference;
  const std::size_t n = static_cast<std::size_t>(left_end - left);
  if (static_cast<std::size_t>(right_end - right) != n)
    throw Error(Error_code::wrong_number_of_points, "failing_joins: the numbers of left and right curves differ");
  return internal::failing_indices<Concurrency_tag>(n, [&](std::size_t i) {
    return bool(holds(left[static_cast<Left_difference>(i)], right[static_cast<Right_difference>(i)]));
  });
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_FAILING_JOINS_H
