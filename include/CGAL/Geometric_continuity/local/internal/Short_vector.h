// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SHORT_VECTOR_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SHORT_VECTOR_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A vector of which `few` elements need no memory. Boost's class has many more functions, which
// cost compile time in each program that has a curve.
template <class T, std::size_t few> class Inline_vector {
  std::array<T, few> few_{}; // beyond the size T()
  std::vector<T> many_;      // all elements when there are more
  std::size_t size_ = 0;
  T* data_ = few_.data();

public:
  Inline_vector() {}
  Inline_vector(std::size_t n, const T& x) {
    resize(n);
    std::fill(begin(), end(), x);
  }
  Inline_vector(const Inline_vector& v) { *this = v; }
  Inline_vector& operator=(const Inline_vector& v) {
    size_ = v.size_;
    if (size_ <= few) {
      few_ = v.few_;
      data_ = few_.data();
    } else {
      many_ = v.many_;
      data_ = many_.data();
    }
    return *this;
  }

  // Appends elements T(). \pre n is not less than the size
  void resize(std::size_t n) {
    if (n > few) {
      if (data_ == few_.data()) many_.assign(begin(), end());
      many_.resize(n);
      data_ = many_.data();
    }
    size_ = n;
  }

  std::size_t size() const { return size_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
};

// Elements that have memory of their own are in a std::vector.
template <class T, std::size_t few>
using Short_vector = std::conditional_t<std::is_trivially_destructible_v<T>, Inline_vector<T, few>, std::vector<T>>;

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_SHORT_VECTOR_H
