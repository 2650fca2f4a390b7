// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_SPANS_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_SPANS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/number_rows.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <boost/config.hpp>
#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file bspline_spans.h
/// From a spline to the Bernstein coefficients of its spans, one span after the other, and back: on
/// flat arrays of numbers, without a linear system, in convex combinations but for the coefficients
/// that straddle a knot.
///
/// A coefficient is a row of numbers. Where the degree and the number of coordinates are known at
/// compile time, loops have constant bounds; else the degree is -1 and the number 0.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// So many numbers as local variables where that is known at compile time (`Size > 0`), and
// otherwise in a vector.
template <class FT, int Size> using Numbers = std::conditional_t<(Size > 0), std::array<FT, Size>, std::vector<FT>>;

// Goes from the values of the blossom at p successive knots, the first of which are those for a
// span that begins with the knot *u, to the values where u takes the place of the knots before it:
// those of the spline without knots before u.
template <int N, class FT> void without_knots_before(const FT* u, int p, int n, FT* rows) {
  int m = 1;
  while (m < p && u[-m] == *u) ++m;
  for (int r = 1; r <= p - m; ++r)
    for (int i = 0; i <= p - m - r; ++i) {
      const FT &left = u[r + i - p], &right = u[1 + i];
      mix_rows<N>(rows + n * i, rows + n * (i + 1), FT((*u - left) / (right - left)), n, rows + n * i);
    }
}

// The Bernstein coefficients of a spline of degree p on one interval [t, a] after the other. The
// ends of the intervals are the knots of the domain, and others between them.
//
// With the knots r_1 <= r_2 <= ... that follow t, the rows w_j = f[t, ..., t, r_1, ..., r_j], with
// p - j arguments t, are kept. If a is a knot of multiplicity m, the first m + 1 of them are
// Bernstein coefficients on [t, a], and each round that replaces an argument t of the others by a
// gives one more. In the end they are those that the next interval needs.
//
// coefficients(i, row) writes the i-th coefficient of the spline.
template <class FT, int Degree, int Dimension, class Coefficients> class Bernstein_spans {
  static constexpr bool fixed = Degree >= 0 && Dimension > 0;
  static constexpr int N = row_length_v<FT, Dimension>, size = fixed ? (Degree + 1) * N : 0;

  const FT* u_;
  // k_: the knots that follow t start with number k_ + 1; last_: the last coefficient
  int p_, n_, last_, k_;
  FT t_;
  Coefficients coefficients_;
  Numbers<FT, size> w_, b_;
  Numbers<FT, fixed ? Degree + 1 : 0> ratios_;

  int p() const { return Degree >= 0 ? Degree : p_; }
  int n() const { return Dimension > 0 ? N : n_; }
  FT* w(int j) { return w_.data() + n() * j; }
  FT* b(int j) { return b_.data() + n() * j; }

public:
  Bernstein_spans(const Knot_vector<FT>& u, int dimension, const Coefficients& coefficients)
      : u_(u.knots().data()), p_(u.degree()), n_(dimension), last_(u.number_of_coefficients() - 1), k_(p_), t_(u_[p_]),
        coefficients_(coefficients) {
    while (u_[k_ + 1] == t_) ++k_;
    if constexpr (!fixed) {
      w_.resize((p() + 1) * n());
      b_.resize(w_.size());
      ratios_.resize(p() + 1);
    }
    for (int j = 0; j <= p(); ++j) coefficients_(k_ - p() + j, w(j));
    without_knots_before<N>(u_ + k_, p(), n(), w_.data());
  }

  // Goes on to the interval [t, a].
  void next(const FT& a) {
    int m = 0;
    while (m <= p() && u_[k_ + 1 + m] == a) ++m;
    dispatch<0>(a, m);
  }

  // The j-th Bernstein coefficient.
  const FT* operator[](int j) const { return b_.data() + n() * j; }

private:
  // Multiplicities are constants where the degree is one.
  template <int M> void dispatch(const FT& a, int m) {
    if constexpr (!fixed)
      step<0>(a, m);
    else if constexpr (M > Degree)
      step<M>(a, M);
    else if (m == M)
      step<M>(a, M);
    else
      dispatch<M + 1>(a, m);
  }

  template <int M> void step(const FT& a, int m) {
    if constexpr (fixed) m = M;
    const int s = p() - m;
    const FT length(a - t_);
    const FT* const after = u_ + k_ + m + 1;
    for (int i = 0; i < s; ++i) ratios_[i] = FT(length / (after[i] - t_));
    for (int i = 0; i <= m && i <= p(); ++i) copy_row<N>(w(i), n(), b(i));
    for (int i = 0; i <= s; ++i) copy_row<N>(w(m + i), n(), w(i));
    if constexpr (fixed)
      rounds<M>();
    else
      // replaces an argument t of the first rows, which have r arguments a
      for (int r = m; r < p(); ++r) {
        for (int i = 0; i < p() - r; ++i) mix_rows<N>(w(i), w(i + 1), ratios_[i], n(), w(i));
        copy_row<N>(w(0), n(), b(r + 1));
      }
    k_ += m;
    if (k_ <= last_)
      for (int j = s + 1; j <= p(); ++j) coefficients_(k_ - p() + j, w(j));
    t_ = a;
  }

  // The rounds of step(), written out: the first row is number M in b.
  template <int M, int I = 0> CGAL_GC_FORCEINLINE void rounds() {
    if constexpr (I < Degree - M) {
      mix_rows<N>(w(I), w(I + 1), ratios_[I], N, w(I));
      rounds<M, I + 1>();
    } else if constexpr (M < Degree) {
      copy_row<N>(w(0), N, b(M + 1));
      rounds<M + 1>();
    }
  }
};

// A clamped knot vector with every knot once, in increasing order. Multiplicities are at most
// degree + 1, which they are at the ends.
template <class FT> struct Distinct_knots {
  typedef typename Knot_vector<FT>::Knot Knot;
  int degree;
  int size = 0;   // the sum of the multiplicities
  int number = 0; // of knots that have been appended
  boost::container::small_vector<Knot, 16> knots;

  // Makes room for as many knots.
  Distinct_knots(int n, int capacity) : degree(n) { knots.resize(capacity, boost::container::default_init); }
  CGAL_GC_FORCEINLINE void append(const FT& value, int multiplicity) {
    Knot& knot = knots[number++];
    knot.value = value;
    knot.multiplicity = multiplicity;
    size += multiplicity;
  }

  int number_of_coefficients() const { return size - degree - 1; }

  Knot_vector<FT> knot_vector() const {
    // equivalent [0 -> 1, 1]: every number is written over
    std::vector<FT> u(size, knots[0].value);
    FT* next = u.data();
    for (int i = 0; i < number; ++i)
      for (int copies = knots[i].multiplicity; copies > 0; --copies) *next++ = knots[i].value;
    return Knot_vector<FT>(degree, std::move(u), typename Knot_vector<FT>::Correct_by_construction());
  }
};

// The spans of these knots, with room for the rows of the Bernstein coefficients on them.
template <class FT> struct Bernstein_pieces {
  const typename Knot_vector<FT>::Knot* knots;
  int spans;
  boost::container::small_vector<FT, 256> rows;

  Bernstein_pieces(const Distinct_knots<FT>& t, int n) : knots(t.knots.data()), spans(t.number - 1) {
    rows.resize(static_cast<std::size_t>(spans) * (t.degree + 1) * n, boost::container::default_init);
  }
};

// result_i = (1 - ratio) row_i + ratio row_{i+1} for as many i: one more argument of the blossom,
// which divides the span in this ratio.
template <int N, class FT>
CGAL_GC_FORCEINLINE void blossom_round(const FT* rows, int count, const FT& ratio, int n, FT* result) {
  for (int i = 0; i < count; ++i) mix_rows<N>(rows + n * i, rows + n * (i + 1), ratio, n, result + n * i);
}

// The value of the blossom at the d arguments that start with `copies` of the knot s and go beyond
// the knot s + 1. It is extrapolated from the longest of the spans between them, which keeps
// rounding errors small, and left in `local`.
template <int N, class FT>
BOOST_NOINLINE void straddling_coefficient(const Bernstein_pieces<FT>& pieces, int d, int n, int s, int copies,
                                           FT* local) {
  const auto* const knots = pieces.knots;
  int longest = s, end = s + 1, rest = d - copies; // copies of the last argument
  for (; rest > knots[end].multiplicity; ++end) {
    rest -= knots[end].multiplicity;
    if (FT(knots[longest + 1].value - knots[longest].value) < FT(knots[end + 1].value - knots[end].value))
      longest = end;
  }
  const auto count = [&](int k) { return k == s ? copies : k == end ? rest : knots[k].multiplicity; };
  const FT &a = knots[longest].value, &b = knots[longest + 1].value;
  const int first = count(longest + 1);
  int rounds = d - count(longest) - first; // as many arguments are not a or b
  std::copy_n(pieces.rows.data() + (static_cast<std::size_t>(longest) * (d + 1) + first) * n, (rounds + 1) * n, local);
  for (int k = s; k <= end; ++k) {
    if (k == longest || k == longest + 1) continue;
    const FT ratio((knots[k].value - a) / (b - a));
    for (int i = count(k); i > 0; --i, --rounds) blossom_round<N>(local, rounds, ratio, n, local);
  }
}

// The value of the blossom from the spans on the left and on the right of a knot, with `rest`
// copies of the knot after it, which is the usual case of the function above. `piece` are the rows
// of the first span.
template <int N, class FT>
CGAL_GC_FORCEINLINE void straddling_coefficient(const typename Knot_vector<FT>::Knot* knots, const FT* piece, int d,
                                                int n, int copies, int rest, FT* local) {
  const FT &u = knots[0].value, &a = knots[1].value, &v = knots[2].value;
  const FT left(a - u), right(v - a);
  const bool on_right = left < right;
  const FT* const rows = piece + (on_right ? d + 1 + rest : knots[1].multiplicity) * n;
  const FT ratio(on_right ? FT(-left / right) : FT(FT(v - u) / left));
  int rounds = on_right ? copies : rest;
  blossom_round<N>(rows, rounds, ratio, n, local);
  while (--rounds > 0) blossom_round<N>(local, rounds, ratio, n, local);
}

// The coefficients of a spline of degree d over its clamped knots, from its pieces, one after the
// other: output(row), by a small object that is copied.
//
// A coefficient is a value of the blossom at d successive knots. If they are no more than the two
// ends of a span, it is a Bernstein coefficient. \pre the pieces join as smoothly as the
// multiplicities say
template <int Degree, int Dimension, class FT, class Output>
void coefficients_from_pieces(const Bernstein_pieces<FT>& pieces, int degree, int dimension, Output& result) {
  constexpr int N = row_length_v<FT, Dimension>;
  constexpr bool fixed = Degree >= 0 && Dimension > 0;
  const int d = Degree >= 0 ? Degree : degree, n = row_length<FT, Dimension>(dimension);
  Numbers<FT, fixed ? (Degree + 1) * N : 0> local;
  if constexpr (!fixed) local.resize((d + 1) * n);
  Output output = result; // in registers
  const FT* piece = pieces.rows.data();
  for (int s = 0; s < pieces.spans; ++s, piece += (d + 1) * n) {
    const int right = pieces.knots[s + 1].multiplicity;
    int copies = (std::min)(pieces.knots[s].multiplicity, d); // of the knot on the left
    const FT* const end = piece + (right < d ? right + 1 : right) * n;
    for (const FT* row = piece + (d - copies) * n; row < end; row += n) output(row);
    for (copies = (std::min)(copies, d - right - 1); copies > 0; --copies) {
      const int rest = d - copies - right; // arguments beyond the knot on the right
      if (rest <= pieces.knots[s + 2].multiplicity)
        straddling_coefficient<N>(pieces.knots + s, piece, d, n, copies, rest, local.data());
      else
        straddling_coefficient<N>(pieces, d, n, s, copies, local.data());
      output(static_cast<const FT*>(local.data()));
    }
  }
  result = output;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_BSPLINE_SPANS_H
