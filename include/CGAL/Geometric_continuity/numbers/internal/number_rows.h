// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_ROWS_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_ROWS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>

#include <cstring>
#include <type_traits>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A row is what belongs to one coefficient in an array of numbers: its coordinates, and after three
// coordinates in float or double a 0, so that one instruction works on the row. The length is known
// at compile time, or it is N = 0.

template <class FT> constexpr bool fits_vector_registers_v = std::is_same_v<FT, double> || std::is_same_v<FT, float>;

template <class FT, int Dimension>
constexpr int row_length_v = (Dimension == 3 && fits_vector_registers_v<FT>) ? 4 : Dimension;
template <class FT, int Dimension> int row_length(int dimension) {
  return Dimension > 0 ? row_length_v<FT, Dimension> : dimension;
}

#if defined(__GNUC__)
template <class FT, int N> constexpr bool row_is_vector_v = N == 4 && fits_vector_registers_v<FT>;

// A row in a register. It is never passed by value.
template <class FT> struct Row_vector {
  typedef FT Vector __attribute__((vector_size(4 * sizeof(FT))));
  Vector v;

  Row_vector() = default;
  CGAL_GC_FORCEINLINE explicit Row_vector(const FT* row) { std::memcpy(&v, row, sizeof(v)); }
  CGAL_GC_FORCEINLINE void store(FT* row) const { std::memcpy(row, &v, sizeof(v)); }

  CGAL_GC_FORCEINLINE FT operator[](int i) const { return v[i]; }
  CGAL_GC_FORCEINLINE Row_vector& operator+=(const Row_vector& x) { return v += x.v, *this; }
  CGAL_GC_FORCEINLINE Row_vector& operator-=(const Row_vector& x) { return v -= x.v, *this; }
  CGAL_GC_FORCEINLINE Row_vector& operator*=(const FT& a) { return v *= a, *this; }
  CGAL_GC_FORCEINLINE friend Row_vector operator+(const Row_vector& x, const Row_vector& y) { return of(x.v + y.v); }
  CGAL_GC_FORCEINLINE friend Row_vector operator-(const Row_vector& x, const Row_vector& y) { return of(x.v - y.v); }
  CGAL_GC_FORCEINLINE friend Row_vector operator*(const FT& a, const Row_vector& x) { return of(a * x.v); }

private:
  CGAL_GC_FORCEINLINE static Row_vector of(const Vector& v) {
    Row_vector r;
    r.v = v;
    return r;
  }
};
#else
template <class FT, int N> constexpr bool row_is_vector_v = false;
template <class FT> struct Row_vector;
#endif

template <int N, class FT> CGAL_GC_FORCEINLINE void copy_row(const FT* x, int n, FT* result) {
  if constexpr (row_is_vector_v<FT, N>)
    Row_vector<FT>(x).store(result);
  else
    for (int i = 0; i < (N > 0 ? N : n); ++i) result[i] = x[i];
}

// result = (1 - ratio) x + ratio y
template <int N, class FT>
CGAL_GC_FORCEINLINE void mix_rows(const FT* x, const FT* y, const FT& ratio, int n, FT* result) {
  const FT rest(FT(1) - ratio);
  if constexpr (row_is_vector_v<FT, N>) {
    Row_vector<FT> a(x);
    const Row_vector<FT> b(y);
    a.v = rest * a.v + ratio * b.v;
    a.store(result);
  } else
    for (int i = 0; i < (N > 0 ? N : n); ++i) result[i] = FT(rest * x[i] + ratio * y[i]);
}

// result = a x, or result += a x
enum class Row_update { assign, add };
template <int N, Row_update update, class FT>
CGAL_GC_FORCEINLINE void multiply_row(const FT& a, const FT* x, int n, FT* result) {
  if constexpr (row_is_vector_v<FT, N>) {
    Row_vector<FT> product(x);
    product.v = a * product.v;
    if constexpr (update == Row_update::add) product.v += Row_vector<FT>(result).v;
    product.store(result);
  } else
    for (int i = 0; i < (N > 0 ? N : n); ++i)
      if constexpr (update == Row_update::add)
        result[i] += a * x[i];
      else
        result[i] = a * x[i];
}

// Rows whose numbers are all finite are told from others by the sum of 0 x over all numbers x,
// without a branch for each.
template <int N, class FT> class Finite_rows {
  std::conditional_t<std::is_floating_point_v<FT>, FT, bool> zero_[N > 0 ? N : 1] = {};

public:
  CGAL_GC_FORCEINLINE void add(const FT* row, int n) {
    if constexpr (row_is_vector_v<FT, N>)
      multiply_row<N, Row_update::add>(FT(0), row, n, zero_);
    else if constexpr (std::is_floating_point_v<FT>)
      for (int i = 0; i < (N > 0 ? N : n); ++i) zero_[N > 0 ? i : 0] += 0 * row[i];
  }
  explicit operator bool() const {
    bool finite = true;
    if constexpr (std::is_floating_point_v<FT>)
      for (const FT& zero : zero_) finite &= zero == 0;
    return finite;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_NUMBER_ROWS_H
