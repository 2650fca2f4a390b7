// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_WIDE_INTEGER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_WIDE_INTEGER_H

#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// An integer of less than 2^512 in absolute value, as all results must be. It needs neither GMP nor
// a compiler with 128 bits. An integer of Boost takes the compiler half a second and 80 MB more
// where Boost's numbers are included for nothing else.
class Wide_integer {
  static constexpr int most = 16;
  std::uint32_t limb_[most] = {}; // of the absolute value, the least first; 0 from size_ on
  int size_ = 0;                  // the last limb is not zero
  bool negative_ = false;

public:
  explicit Wide_integer(std::int64_t x = 0) : negative_(x < 0) {
    std::uint64_t size = static_cast<std::uint64_t>(x);
    if (negative_) size = 0 - size;
    for (; size != 0; size >>= 32) limb_[size_++] = static_cast<std::uint32_t>(size);
  }

  bool is_zero() const { return size_ == 0; }
  // How many binary digits the absolute value has.
  int bits() const { return size_ == 0 ? 0 : 32 * size_ + 32 - leading_zero_bits(limb_[size_ - 1]); }

  friend Wide_integer abs(Wide_integer x) {
    x.negative_ = false;
    return x;
  }
  friend Wide_integer operator-(Wide_integer x) {
    x.negative_ = !x.negative_ && !x.is_zero();
    return x;
  }
  friend Wide_integer operator+(Wide_integer x, const Wide_integer& y) { return x.add(y, y.negative_); }
  friend Wide_integer operator-(Wide_integer x, const Wide_integer& y) { return x.add(y, !y.negative_); }
  Wide_integer& operator+=(const Wide_integer& y) { return add(y, y.negative_); }
  Wide_integer& operator-=(const Wide_integer& y) { return add(y, !y.negative_); }

  friend Wide_integer operator*(const Wide_integer& x, const Wide_integer& y) {
    Wide_integer z;
    z.size_ = (std::min)(x.size_ + y.size_, most);
    for (int i = 0; i < x.size_; ++i) {
      std::uint64_t carry = 0;
      for (int j = 0; i + j < z.size_; ++j, carry >>= 32) {
        carry += z.limb_[i + j];
        if (j < y.size_) carry += std::uint64_t(x.limb_[i]) * y.limb_[j];
        z.limb_[i + j] = static_cast<std::uint32_t>(carry);
      }
    }
    z.negative_ = x.negative_ != y.negative_;
    z.remove_leading_zeros();
    return z;
  }
  Wide_integer& operator*=(const Wide_integer& y) { return *this = *this * y; }

  // The quotient, rounded towards 0. \pre 0 < d
  friend Wide_integer operator/(Wide_integer x, std::uint32_t d) {
    std::uint64_t rest = 0;
    for (int i = x.size_ - 1; i >= 0; --i) {
      rest = rest << 32 | x.limb_[i];
      x.limb_[i] = static_cast<std::uint32_t>(rest / d);
      rest %= d;
    }
    x.remove_leading_zeros();
    return x;
  }
  Wide_integer& operator/=(std::uint32_t d) { return *this = *this / d; }

  // The absolute value is shifted, and what falls off at its lower end is lost. \pre 0 <= k
  friend Wide_integer operator<<(const Wide_integer& x, int k) {
    Wide_integer z;
    z.size_ = k / 32;
    std::uint64_t carry = 0;
    for (int i = 0; i < x.size_; ++i, carry >>= 32) {
      carry |= std::uint64_t(x.limb_[i]) << k % 32;
      z.limb_[z.size_++] = static_cast<std::uint32_t>(carry);
    }
    if (carry != 0) z.limb_[z.size_++] = static_cast<std::uint32_t>(carry);
    z.negative_ = x.negative_;
    z.remove_leading_zeros();
    return z;
  }
  friend Wide_integer operator>>(const Wide_integer& x, int k) {
    Wide_integer z;
    for (int i = k / 32; i < x.size_; ++i) {
      const std::uint64_t next = i + 1 < x.size_ ? x.limb_[i + 1] : 0;
      z.limb_[z.size_++] = static_cast<std::uint32_t>((next << 32 | x.limb_[i]) >> k % 32);
    }
    z.negative_ = x.negative_;
    z.remove_leading_zeros();
    return z;
  }
  Wide_integer& operator>>=(int k) { return *this = *this >> k; }

  friend bool operator<(const Wide_integer& x, const Wide_integer& y) {
    if (x.negative_ != y.negative_) return x.negative_;
    return x.negative_ ? compare_absolute(y, x) < 0 : compare_absolute(x, y) < 0;
  }
  friend bool operator<=(const Wide_integer& x, const Wide_integer& y) { return !(y < x); }

private:
  // The order of the absolute values: negative, 0, positive.
  static int compare_absolute(const Wide_integer& x, const Wide_integer& y) {
    if (x.size_ != y.size_) return x.size_ < y.size_ ? -1 : 1;
    for (int i = x.size_ - 1; i >= 0; --i)
      if (x.limb_[i] != y.limb_[i]) return x.limb_[i] < y.limb_[i] ? -1 : 1;
    return 0;
  }

  // Adds y, with the sign that is given.
  Wide_integer& add(const Wide_integer& y, bool negative) {
    if (negative_ == negative) {
      std::uint64_t carry = 0;
      for (int i = 0; i < y.size_ || carry != 0; ++i, carry >>= 32) {
        if (i == size_) ++size_;
        carry += limb_[i];
        if (i < y.size_) carry += y.limb_[i];
        limb_[i] = static_cast<std::uint32_t>(carry);
      }
      return *this;
    }
    const bool turns = compare_absolute(*this, y) < 0;
    const Wide_integer larger = turns ? y : *this, smaller = turns ? *this : y;
    size_ = larger.size_;
    std::uint64_t borrow = 0;
    for (int i = 0; i < size_; ++i) {
      const std::uint64_t d = std::uint64_t(larger.limb_[i]) - (i < smaller.size_ ? smaller.limb_[i] : 0) - borrow;
      limb_[i] = static_cast<std::uint32_t>(d);
      borrow = d >> 63;
    }
    if (turns) negative_ = negative;
    remove_leading_zeros();
    return *this;
  }

  void remove_leading_zeros() {
    while (size_ != 0 && limb_[size_ - 1] == 0) --size_;
    if (size_ == 0) negative_ = false;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_WIDE_INTEGER_H
