// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_PIECES_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_PIECES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

/// \file spline_pieces.h
/// The polynomial pieces of splines that an interval of parameters touches, and their basis functions as Taylor polynomials.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The numbers of a knot vector, checked. \throws Error `not_finite`, `wrong_number_of_points`, `knot_multiplicity`
inline void check_knots(const std::vector<double>& knots, int degree, std::size_t points) {
  if (degree < 1 || degree > 60 || points < static_cast<std::size_t>(degree) + 1 ||
      knots.size() != points + static_cast<std::size_t>(degree) + 1)
    throw Error(Error_code::wrong_number_of_points, "a spline of degree " + std::to_string(degree) + " with " +
                                                        std::to_string(points) + " points and " +
                                                        std::to_string(knots.size()) + " knots");
  for (double k : knots)
    if (!std::isfinite(k)) throw Error(Error_code::not_finite, "a knot of a spline");
  if (!std::is_sorted(knots.begin(), knots.end()))
    throw Error(Error_code::knot_multiplicity, "the knots of a spline decrease");
  if (!(knots[degree] < knots[points])) throw Error(Error_code::empty_domain, "the domain of a spline");
}

// The pieces [knots[s], knots[s + 1]] that an interval of parameters touches in more than an end, by the numbers s. The first and the
// last piece are continued beyond the domain: parameters leave it by rounding. A point on a knot touches the pieces on both sides, or
// the one below (`side` < 0) or above (`side` > 0).
inline std::vector<int> touched_pieces(const std::vector<double>& knots, int degree, const Interval& t, int side) {
  const int points = static_cast<int>(knots.size()) - degree - 1;
  const double first = knots[degree], last = knots[points];
  const double lower = (std::min)((std::max)(t.inf(), first), last),
               upper = (std::max)((std::min)(t.sup(), last), first);
  const auto inner = knots.begin() + degree + 1, end = knots.begin() + points;
  // the span that ends at x or contains it, and the one that starts at x or contains it
  const auto below = [&](double x) { return static_cast<int>(std::lower_bound(inner, end, x) - knots.begin()) - 1; };
  const auto above = [&](double x) { return static_cast<int>(std::upper_bound(inner, end, x) - knots.begin()) - 1; };
  int from = above(lower), to = below(upper);
  if (lower == upper) {
    from = side > 0 ? above(lower) : below(lower);
    to = side < 0 ? below(lower) : above(lower);
  }
  while (from > degree && !(knots[from] < knots[from + 1])) --from; // at the end of the domain
  while (to < points - 1 && !(knots[to] < knots[to + 1])) ++to;
  std::vector<int> spans;
  for (int s = from; s <= (std::max)(from, to); ++s)
    if (knots[s] < knots[s + 1]) spans.push_back(s);
  return spans;
}

// The Taylor coefficients of the degree+1 basis functions that do not vanish on a piece, about a point m: the function of the number
// s - degree + a is the sum of coefficient(a, i) d^i at m + d. By the recurrence of Cox and de Boor on polynomials in d.
class Basis_polynomials {
  int n_;
  std::vector<Interval> c_;

public:
  Basis_polynomials(const std::vector<double>& knots, int degree, int span, const Interval& m)
      : n_(degree + 1), c_(static_cast<std::size_t>(n_) * n_, Interval(0)) {
    (*this)(degree, 0) = 1;
    for (int d = 1; d <= degree; ++d)
      for (int a = degree - d; a <= degree; ++a) { // of degree d, from those of degree d-1 with the numbers a and a+1
        const int j = span - degree + a;
        const bool left = a > degree - d, right = a < degree;
        Interval up, down, u0, d0;
        if (left) {
          up = 1 / (Interval(knots[j + d]) - Interval(knots[j]));
          u0 = (m - Interval(knots[j])) * up;
        }
        if (right) {
          down = 1 / (Interval(knots[j + d + 1]) - Interval(knots[j + 1]));
          d0 = (Interval(knots[j + d + 1]) - m) * down;
        }
        for (int i = d; i >= 0; --i) {
          Interval sum = 0;
          if (left) sum += u0 * (*this)(a, i) + (i > 0 ? up * (*this)(a, i - 1) : Interval(0));
          if (right) sum += d0 * (*this)(a + 1, i) - (i > 0 ? down * (*this)(a + 1, i - 1) : Interval(0));
          (*this)(a, i) = sum;
        }
      }
  }

  Interval& operator()(int a, int i) { return c_[static_cast<std::size_t>(a) * n_ + i]; }
  const Interval& operator()(int a, int i) const { return c_[static_cast<std::size_t>(a) * n_ + i]; }
};

// Replaces the coefficients x(0), ..., x(degree) about a point by those about all points at the distances in d.
template <class Coefficient> void move_centre(int degree, const Interval& d, Coefficient x) {
  for (int i = 0; i < degree; ++i)
    for (int k = degree - 1; k >= i; --k) x(k) += d * x(k + 1);
}

inline double middle(const Interval& t) {
  const double m = t.inf() / 2 + t.sup() / 2;
  return (std::min)((std::max)(m, t.inf()), t.sup());
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_SPLINE_PIECES_H
