// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INLINE_INTEGER_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INLINE_INTEGER_H

#include <boost/config.hpp>

#include <gmp.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Numbers of limbs of which 16 need no memory. A small_vector of Boost has many more functions, for
// which programs that make few decisions would wait.
class Inline_limbs {
  static constexpr std::size_t few = 16;
  mp_limb_t* data_ = few_;
  std::size_t size_ = 0, capacity_ = few;
  mp_limb_t few_[few];

public:
  Inline_limbs() {}
  Inline_limbs(const Inline_limbs& x) { assign(x.data_, x.size_); }
  Inline_limbs(Inline_limbs&& x) noexcept { take(x); }
  Inline_limbs& operator=(const Inline_limbs& x) {
    if (this != &x) assign(x.data_, x.size_);
    return *this;
  }
  Inline_limbs& operator=(Inline_limbs&& x) noexcept {
    if (this != &x) {
      release();
      take(x);
    }
    return *this;
  }
  BOOST_NOINLINE ~Inline_limbs() { release(); }

  std::size_t size() const { return size_; }
  mp_limb_t* data() { return data_; }
  const mp_limb_t* data() const { return data_; }

  BOOST_NOINLINE void assign(const mp_limb_t* limbs, std::size_t n) {
    size_ = 0;
    resize(n);
    copy(limbs, n, data_);
  }
  // New limbs are unspecified.
  void resize(std::size_t n) {
    if (n > capacity_) reserve(n);
    size_ = n;
  }

private:
  static void copy(const mp_limb_t* from, std::size_t n, mp_limb_t* to) {
    std::memcpy(to, from, n * sizeof(mp_limb_t));
  }
  BOOST_NOINLINE void reserve(std::size_t n) {
    const std::size_t capacity = (std::max)(n, 2 * capacity_);
    mp_limb_t* const data = new mp_limb_t[capacity];
    copy(data_, size_, data);
    release();
    data_ = data;
    capacity_ = capacity;
  }
  void release() {
    if (data_ != few_) delete[] data_;
  }
  // \pre nothing is to be released
  BOOST_NOINLINE void take(Inline_limbs& x) noexcept {
    size_ = x.size_;
    if (x.data_ == x.few_) {
      data_ = few_;
      capacity_ = few;
      copy(x.few_, size_, few_);
    } else {
      data_ = x.data_;
      capacity_ = x.capacity_;
      x.data_ = x.few_;
      x.capacity_ = few;
    }
    x.size_ = 0;
  }
};

// An integer of any size that allocates no memory up to 16 limbs: an exact construction has many
// short-lived integers. The arithmetic is that of GMP's functions for limbs. A cpp_int of Boost
// with a buffer of that size takes, in instructions of exact blends, 0.93 to 1.03 times as many
// with numbers of one or two limbs, but 1.4 to 1.7 times with fractions of 60 digits and 1.9 to 2
// times with fractions of 360 digits. Nothing of it is inlined: programs that make few decisions
// would wait for the compiler instead.
class Inline_integer {
  Inline_limbs limbs_; // of the absolute value, the least first; the last is not zero
  bool negative_ = false;

public:
  Inline_integer() = default;
  BOOST_NOINLINE explicit Inline_integer(int x) : negative_(x < 0) {
    if (x != 0) push(x < 0 ? -static_cast<mp_limb_t>(x) : static_cast<mp_limb_t>(x));
  }

  std::size_t size() const { return limbs_.size(); }
  bool is_zero() const { return size() == 0; }
  bool is_one() const { return size() == 1 && limb(0) == 1 && !negative_; }
  int sign() const { return is_zero() ? 0 : negative_ ? -1 : 1; }
  void negate() { negative_ = !negative_ && !is_zero(); }

  // Reads and writes size limbs, the least first, of integers of other types.
  template <class Limb> void assign(const Limb* limbs, std::size_t size, bool negative) {
    static_assert(sizeof(Limb) == sizeof(mp_limb_t));
    limbs_.resize(size);
    std::memcpy(limbs_.data(), limbs, size * sizeof(Limb));
    negative_ = negative;
    remove_leading_zeros();
  }
  template <class Limb> void copy_limbs(Limb* to) const {
    static_assert(sizeof(Limb) == sizeof(mp_limb_t));
    std::memcpy(to, limbs_.data(), size() * sizeof(Limb));
  }

  Inline_integer& operator+=(const Inline_integer& y) { return add(y, y.negative_); }
  Inline_integer& operator-=(const Inline_integer& y) { return add(y, !y.negative_); }
  BOOST_NOINLINE Inline_integer& operator*=(const Inline_integer& y) {
    if (y.size() == 1 && !is_zero()) {
      push(mpn_mul_1(limbs_.data(), limbs_.data(), size(), y.limb(0)));
      negative_ = negative_ != y.negative_;
      return *this;
    }
    return *this = *this * y;
  }
  BOOST_NOINLINE Inline_integer& operator<<=(long k) {
    if (is_zero()) return *this;
    const std::size_t n = size(), limbs = k / GMP_NUMB_BITS;
    limbs_.resize(n + limbs);
    mp_limb_t* const x = limbs_.data();
    std::memmove(x + limbs, x, n * sizeof(mp_limb_t));
    std::memset(x, 0, limbs * sizeof(mp_limb_t));
    if (const unsigned bits = static_cast<unsigned>(k % GMP_NUMB_BITS)) push(mpn_lshift(x + limbs, x + limbs, n, bits));
    return *this;
  }

  // Makes this number odd; returns the exponent of the power of two that was taken away. 0 stays.
  BOOST_NOINLINE long remove_twos() {
    if (is_zero() || (limb(0) & 1) != 0) return 0;
    const long twos = static_cast<long>(mpn_scan1(limbs_.data(), 0));
    const std::size_t zeros = static_cast<std::size_t>(twos / GMP_NUMB_BITS);
    std::memmove(limbs_.data(), limbs_.data() + zeros, (size() - zeros) * sizeof(mp_limb_t));
    limbs_.resize(size() - zeros);
    if (const unsigned bits = static_cast<unsigned>(twos % GMP_NUMB_BITS))
      mpn_rshift(limbs_.data(), limbs_.data(), size(), bits);
    remove_leading_zeros();
    return twos;
  }

  BOOST_NOINLINE friend Inline_integer operator*(const Inline_integer& x, const Inline_integer& y) {
    Inline_integer z;
    if (x.is_zero() || y.is_zero()) return z;
    const Inline_integer &a = x.size() < y.size() ? y : x, &b = x.size() < y.size() ? x : y;
    z.limbs_.resize(a.size() + b.size());
    mpn_mul(z.limbs_.data(), a.limbs_.data(), a.size(), b.limbs_.data(), b.size());
    z.negative_ = x.negative_ != y.negative_;
    z.remove_leading_zeros();
    return z;
  }
  BOOST_NOINLINE friend Inline_integer operator+(const Inline_integer& x, const Inline_integer& y) {
    Inline_integer z(x);
    z += y;
    return z;
  }
  BOOST_NOINLINE friend Inline_integer operator-(const Inline_integer& x, const Inline_integer& y) {
    Inline_integer z(x);
    z -= y;
    return z;
  }
  BOOST_NOINLINE friend bool operator==(const Inline_integer& x, const Inline_integer& y) {
    return x.negative_ == y.negative_ && compare_absolute(x, y) == 0;
  }
  friend bool operator!=(const Inline_integer& x, const Inline_integer& y) { return !(x == y); }

  BOOST_NOINLINE friend bool operator<(const Inline_integer& x, const Inline_integer& y) {
    if (x.sign() != y.sign()) return x.sign() < y.sign();
    const int order = compare_absolute(x, y);
    return x.negative_ ? order > 0 : order < 0;
  }

  // The order of the absolute values: negative, 0, positive.
  friend int compare_absolute(const Inline_integer& x, const Inline_integer& y) {
    if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
    return x.is_zero() ? 0 : mpn_cmp(x.limbs_.data(), y.limbs_.data(), x.size());
  }

  // Returns whether d > 0 divides x; if so, q = x / d.
  BOOST_NOINLINE friend bool divides(const Inline_integer& d, const Inline_integer& x, Inline_integer& q) {
    if (x.is_zero() || d.is_one()) {
      q = x;
      return true;
    }
    if (x.size() < d.size()) return false;
    Inline_limbs quotient, remainder;
    quotient.resize(x.size() - d.size() + 1);
    remainder.resize(d.size());
    mpn_tdiv_qr(quotient.data(), remainder.data(), 0, x.limbs_.data(), x.size(), d.limbs_.data(), d.size());
    if (!mpn_zero_p(remainder.data(), static_cast<mp_size_t>(d.size()))) return false;
    q.limbs_ = std::move(quotient);
    q.negative_ = x.negative_;
    q.remove_leading_zeros();
    return true;
  }

  // The greatest common divisor of two positive odd numbers.
  BOOST_NOINLINE friend Inline_integer gcd_of_odd(Inline_integer x, Inline_integer y) {
    if (x.size() < y.size()) std::swap(x, y);
    Inline_integer g;
    g.limbs_.resize(y.size());
    g.limbs_.resize(mpn_gcd(g.limbs_.data(), x.limbs_.data(), x.size(), y.limbs_.data(), y.size()));
    return g;
  }

private:
  // Adds y, with the sign that is given.
  BOOST_NOINLINE Inline_integer& add(const Inline_integer& y, bool negative) {
    const std::size_t n = y.size();
    if (n == 0) return *this;
    if (is_zero()) {
      limbs_ = y.limbs_;
      negative_ = negative;
      return *this;
    }
    if (size() < n) {
      const std::size_t old = size();
      limbs_.resize(n);
      std::memset(limbs_.data() + old, 0, (n - old) * sizeof(mp_limb_t));
    }
    mp_limb_t* const x = limbs_.data();
    if (negative_ == negative) {
      push(mpn_add(x, x, size(), y.limbs_.data(), n));
      return *this;
    }
    if (size() > n || mpn_cmp(x, y.limbs_.data(), n) >= 0)
      mpn_sub(x, x, size(), y.limbs_.data(), n);
    else {
      mpn_sub_n(x, y.limbs_.data(), x, n);
      negative_ = negative;
    }
    remove_leading_zeros();
    return *this;
  }
  mp_limb_t limb(std::size_t i) const { return limbs_.data()[i]; }
  void push(mp_limb_t carry) {
    if (carry == 0) return;
    const std::size_t n = size();
    limbs_.resize(n + 1);
    limbs_.data()[n] = carry;
  }
  void remove_leading_zeros() {
    std::size_t n = size();
    while (n != 0 && limb(n - 1) == 0) --n;
    limbs_.resize(n);
    if (n == 0) negative_ = false;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_INLINE_INTEGER_H
