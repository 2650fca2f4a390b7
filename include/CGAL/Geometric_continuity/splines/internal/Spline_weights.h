// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H

#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <vector>

/// \file Spline_weights.h
/// The weights with which the coefficients of a spline enter its values, derivatives and blossoms:
/// de Boor's triangle.

namespace CGAL {

template <bool> class Interval_nt;

namespace Geometric_continuity {
namespace internal {

// Holds as many values as belong to one span, without allocation up to degree 7.
template <class T> using Span_vector = boost::container::small_vector<T, 8>;

// Holds as many numbers as the degree needs, where that is known at compile time, or so many.
template <class FT, int Degree, int Size, int Inline> class Weight_numbers {
  std::conditional_t<(Degree < 0), boost::container::small_vector<FT, Inline>, std::array<FT, Size>> x_;

public:
  CGAL_GC_FORCEINLINE explicit Weight_numbers([[maybe_unused]] int size) {
    if constexpr (Degree < 0) x_.resize(size);
  }
  CGAL_GC_FORCEINLINE FT* data() { return x_.data(); }
};

// The combination sum_i w_i c_{first+i} of p + 1 consecutive coefficients. The degree p is Degree,
// if that is not negative.
template <class FT, int Degree = -1> struct Span_weights {
  int first, p;
  const FT* w;

  template <class Coefficients> CGAL_GC_FORCEINLINE auto operator()(const Coefficients& c) const {
    std::decay_t<decltype(c[0])> sum = w[0] * c[first];
    for (int i = 1; i <= (Degree < 0 ? p : Degree); ++i) sum += w[i] * c[first + i];
    return sum;
  }
};

// A combination sum_i w_i c_{first+i} of consecutive coefficients.
template <class FT> struct Spline_weights {
  int first = 0;
  Span_vector<FT> w;

  template <class Coefficients> typename Coefficients::value_type operator()(const Coefficients& c) const {
    return Span_weights<FT>{first, static_cast<int>(w.size()) - 1, w.data()}(c);
  }
};

// Returns the rest of a weight w when q takes x of it. An enclosure does not know that x is a part
// of w: there the difference is wider.
template <class FT> CGAL_GC_FORCEINLINE FT weight_left(const FT& w, const FT& x, const FT&) { return FT(w - x); }
template <bool is_protected>
Interval_nt<is_protected> weight_left(const Interval_nt<is_protected>& w, const Interval_nt<is_protected>&,
                                      const Interval_nt<is_protected>& q) {
  return w * (1 - q);
}

// De Boor's triangle, transposed: it starts with the weight 1 and leads to the weights of the
// coefficients. The level with n weights gives n + 1; its i-th quotient is (t - a) / (b - a) of an
// argument t and two knots.
template <class FT> CGAL_GC_FORCEINLINE void add_argument(FT* w, int n, const FT* quotients) {
  FT carry(0);
  for (int i = 0; i < n; ++i) {
    const FT x = w[i] * quotients[i];
    w[i] = carry + weight_left(w[i], x, quotients[i]);
    carry = x;
  }
  w[n] = carry;
}

// The level of the triangle that stands for one differentiation. The i-th length is b - a,
// divide(x, length) the quotient.
template <class FT, class Divide>
CGAL_GC_FORCEINLINE void add_differentiation(FT* w, int n, const FT* lengths, const Divide& divide) {
  FT carry(0);
  for (int i = 0; i < n; ++i) {
    const FT x = divide(FT(FT(n) * w[i]), lengths[i]);
    w[i] = carry - x;
    carry = x;
  }
  w[n] = carry;
}

// The weights of the derivatives of order 0 to p at t, not beyond `order`, of a spline of degree p
// on the span k, for the coefficients k-p, ..., k: output(j, weights) is called for each. Only the
// knots k-p+1, ..., k+p are read. The degree is Degree, unless that is negative. If it is not,
// everything is unrolled by templates, and each difference of knots is inverted once: for
// floating-point numbers inside of the span, since at its ends the weights of the point are to be
// exact.
template <int Degree, class FT, class Knots> class Derivative_weights {
  static constexpr int fixed = Degree < 0 ? 0 : Degree;

  const Knots& u_;
  const FT& t_;
  int p_, k_, last_;
  // of the level with m + 1 weights, with the knots k - m + i and k + 1 + i, from m (m + 1) / 2 on
  Weight_numbers<FT, Degree, fixed*(fixed + 1) / 2 + 1, 28> lengths_, quotients_;
  Weight_numbers<FT, Degree, fixed + 1, 8> basis_, weights_; // the basis of degree m

  struct Divide {
    CGAL_GC_FORCEINLINE FT operator()(const FT& x, const FT& length) const {
      return Degree < 0 ? FT(x / length) : FT(x * length);
    }
  };

  CGAL_GC_FORCEINLINE void read_level(int m) {
    FT *const b = lengths_.data() + m * (m + 1) / 2, *const q = quotients_.data() + m * (m + 1) / 2;
    for (int i = 0; i <= m; ++i) {
      b[i] = u_[k_ + 1 + i] - u_[k_ - m + i];
      if constexpr (Degree >= 0) b[i] = FT(1) / b[i];
      q[i] = Divide()(FT(t_ - u_[k_ - m + i]), b[i]);
    }
  }
  template <int m> CGAL_GC_FORCEINLINE void read_levels_from() {
    if constexpr (m < Degree) {
      read_level(m);
      read_levels_from<m + 1>();
    }
  }
  CGAL_GC_FORCEINLINE void differentiate(int l) {
    add_differentiation(weights_.data(), l + 1, lengths_.data() + l * (l + 1) / 2, Divide());
  }
  template <int l> CGAL_GC_FORCEINLINE void differentiate_from() {
    if constexpr (l < Degree) {
      differentiate(l);
      differentiate_from<l + 1>();
    }
  }
  template <int m, class Output> CGAL_GC_FORCEINLINE void from_level(const Output& output) {
    if constexpr (m < Degree) {
      if (Degree - m <= last_) {
        for (int i = 0; i <= m; ++i) weights_.data()[i] = basis_.data()[i];
        differentiate_from<m>();
        output(Degree - m, Span_weights<FT, Degree>{k_ - Degree, Degree, weights_.data()});
      }
      add_argument(basis_.data(), m + 1, quotients_.data() + m * (m + 1) / 2);
      from_level<m + 1>(output);
    }
  }

public:
  CGAL_GC_FORCEINLINE Derivative_weights(const Knots& u, int p, int k, const FT& t, int order)
      : u_(u), t_(t), p_(p), k_(k), last_((std::min)(order, p)), lengths_(p * (p + 1) / 2), quotients_(p * (p + 1) / 2),
        basis_(p + 1), weights_(p + 1) {}

  template <class Output> CGAL_GC_FORCEINLINE void write(const Output& output) {
    basis_.data()[0] = FT(1);
    if constexpr (Degree >= 0) {
      read_levels_from<0>();
      from_level<0>(output);
    } else {
      for (int m = 0; m < p_; ++m) read_level(m);
      for (int m = 0; m < p_; ++m) {
        if (p_ - m <= last_) {
          std::copy_n(basis_.data(), m + 1, weights_.data());
          for (int l = m; l < p_; ++l) differentiate(l);
          output(p_ - m, Span_weights<FT, Degree>{k_ - p_, p_, weights_.data()});
        }
        add_argument(basis_.data(), m + 1, quotients_.data() + m * (m + 1) / 2);
      }
    }
    output(0, Span_weights<FT, Degree>{k_ - p_, p_, basis_.data()});
  }
};
template <int Degree = -1, class FT, class Knots, class Output>
CGAL_GC_FORCEINLINE void derivative_weights(const Knots& u, int degree, int k, const FT& t, int order,
                                            const Output& output) {
  Derivative_weights<Degree, FT, Knots>(u, Degree < 0 ? degree : Degree, k, t, order).write(output);
}

// Calls f with the degree as a constant where floating-point code has one, see
// derivative_weights(), and with -1 otherwise.
template <class Knots, class FT, class Function>
CGAL_GC_FORCEINLINE void with_degree_inside_span(const Knots& knots, int p, int k, const FT& u, const Function& f) {
  if constexpr (std::is_floating_point_v<FT>)
    // equivalent [+ -> -, 2]: the code for any degree computes the same
    if (knots[k] < u && u < knots[k + 1] && (std::numeric_limits<FT>::min)() < knots[k + 1] - knots[k]) switch (p) {
      case 1: return f(std::integral_constant<int, 1>());
      case 2: return f(std::integral_constant<int, 2>());
      case 3: return f(std::integral_constant<int, 3>());
      case 4: return f(std::integral_constant<int, 4>());
      case 5: return f(std::integral_constant<int, 5>());
      default: break;
      }
  f(std::integral_constant<int, -1>());
}

// The derivatives of order 0 to `order` at t of the polynomial on the span k.
template <class FT, class Coefficients>
std::vector<typename Coefficients::value_type> derivatives_on_span(const Knot_vector<FT>& u, const Coefficients& c,
                                                                   int k, const FT& t, int order) {
  typedef typename Coefficients::value_type Value;
  std::vector<Value> derivatives(order + 1, Value(FT(0) * c[0]));
  with_degree_inside_span(u, u.degree(), k, t, [&](auto degree) {
    derivative_weights<degree>(u, u.degree(), k, t, order,
                               [&](int j, const auto& weights) { derivatives[j] = weights(c); });
  });
  return derivatives;
}

// The weights of the blossom f_k[t_1, ..., t_p] at increasing arguments. Arguments that are knots
// next to the span are not computed with but select the coefficients, so that as few levels as
// possible remain. When every knot between the arguments is one of them, all weights are
// nonnegative.
template <class FT> class Blossom_weights : public Spline_weights<FT> {
  std::vector<int> other_; // the arguments that are not selected

public:
  template <class Knots, class Arguments> void assign(const Knots& u, int p, int k, const Arguments& t) {
    int middle = 0, left = 0, right = 0; // t_0, ..., t_{middle-1} <= u_k
    while (middle < p && !(u[k] < t[middle])) ++middle;
    other_.clear();
    for (int i = middle - 1; i >= 0; --i)
      if (t[i] == u[k - left])
        ++left;
      else
        other_.push_back(i);
    for (int i = middle; i < p; ++i)
      if (t[i] == u[k + 1 + right])
        ++right;
      else
        other_.push_back(i);
    const int levels = static_cast<int>(other_.size());
    this->w.assign(levels + 1, FT(1));
    Span_vector<FT> quotients(levels);
    for (int m = 0; m < levels; ++m) {
      for (int i = 0; i <= m; ++i) {
        const FT& a = u[k - left - m + i];
        quotients[i] = FT(t[other_[m]] - a) / FT(u[k + 1 + right + i] - a);
      }
      add_argument(this->w.data(), m + 1, quotients.data());
    }
    this->first = k - p + right;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_SPLINE_WEIGHTS_H
