// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_TEXT_H

#include <CGAL/Geometric_continuity/IO/number.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The knots of a spline of some order, kept as the words that were read, which take less memory than rational numbers. As
// numbers, only those are there that the check of the next knot looks at: the first and the last, as many as the order.
template <class FT> class G2_knot_text {
  std::string text_; // each word with a space behind it
  std::size_t order_, size_ = 0, taken_ = 0;
  std::vector<FT> first_, last_; // knot number i is at i % order in `last_`

public:
  explicit G2_knot_text(int order) : order_(static_cast<std::size_t>(order)) {}

  std::size_t size() const { return size_; }
  const FT& front() const { return first_.front(); }
  const FT& back() const { return (*this)[size_ - 1]; }
  // \pre i < order or i + order >= size()
  const FT& operator[](std::size_t i) const { return i + order_ >= size_ ? last_[i % order_] : first_[i]; }

  void append(const FT& knot, const std::string& word) {
    if (size_ < order_) {
      first_.push_back(knot);
      last_.push_back(knot);
    } else
      last_[size_ % order_] = knot;
    ++size_;
    (text_ += word) += ' ';
  }

  // Returns one knot after the other, from the first on. \pre not called more often than there are knots
  FT take() {
    const std::size_t end = text_.find(' ', taken_);
    const std::string word = text_.substr(taken_, end - taken_);
    taken_ = end + 1;
    return number_value<FT>(word);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_KNOT_TEXT_H
