// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CONTINUITY_NORMAL_DEVIATION_H
#define CGAL_GEOMETRIC_CONTINUITY_CONTINUITY_NORMAL_DEVIATION_H

#include <CGAL/Geometric_continuity/continuity/edge_polynomials.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityContinuity
/// A guaranteed enclosure of the largest angle \f$ \theta \in [0, \pi] \f$ between the normals of two surfaces along their
/// common edge, both turned so that \f$ \theta = 0 \f$ where the surfaces continue each other and \f$ \theta = \pi \f$ where
/// they fold back. Points where a normal vanishes are left out.
///
/// The angle is given without roots by its measure \f$ 1 - \cos\theta\,|\cos\theta| \f$, which grows with it from 0 over 1 for
/// a right angle to 2: it is \f$ \sin^2\theta \f$ up to the right angle and \f$ 2 - \sin^2\theta \f$ beyond.
/// \tparam FT a field number type
template <class FT> struct Normal_deviation {
  FT lower; ///< the measure of an angle that occurs at one of the ends of the interval below, or less
  FT upper; ///< the measure of an angle that is not exceeded anywhere on the edge
  FT begin; ///< the sub-interval of the parameters of the edge
  FT end;   ///< where the angle is largest

  /// A lower bound of the largest angle, in radians. It needs `CGAL::to_interval()`.
  double smallest_angle() const { return angle(lower).first; }

  /// An upper bound of the angle along the whole edge, in radians. It needs `CGAL::to_interval()`.
  double largest_angle() const { return angle(upper).second; }

  /// An enclosure of the angle with the given measure between 0 and 2, in radians. The functions `std::sqrt()` and
  /// `std::asin()` are assumed to err by less than 32 units in the last place each.
  static std::pair<double, double> angle(const FT& measure) {
    constexpr double pi = 3.14159265358979323846, slack = 0x1p-47;
    const bool obtuse = FT(1) < measure;
    const std::pair<double, double> square = CGAL::to_interval(obtuse ? FT(FT(2) - measure) : measure); // sin^2
    const auto arcsine = [](double x) { return std::asin(std::min(1.0, std::sqrt(std::max(0.0, x)))); };
    const double low = arcsine(square.first) * (1 - slack), high = arcsine(square.second) * (1 + slack);
    if (obtuse) return {(pi - high) * (1 - slack), std::min((pi - low) * (1 + slack), pi * (1 + slack))};
    return {low, high};
  }
};

namespace internal {

// Branch and bound for the largest measure. With S = (det |C'|)^2 and P = |n1|^2 |n2|^2, sin^2 = S/P; the cosine has the
// sign of -n1.n2. S and P have one degree and P >= 0, so that S/P lies between the least and the largest S_k/P_k where
// all P_k > 0; factors t and 1-t that both have are split off before. All arithmetic is that of a ring.
template <class Field> class Largest_deviation {
  typedef Edge_normals<Field> Normals;
  typedef typename Normals::Polynomial Polynomial;
  typedef typename Polynomial::NT Ring;

  struct Fraction { // with a positive denominator
    Ring numerator, denominator;
    friend bool operator<(const Fraction& x, const Fraction& y) {
      return Ring(x.numerator * y.denominator) < Ring(y.numerator * x.denominator);
    }
  };
  struct Piece { // of length 2^-level, from `begin` on
    Polynomial s, p, side;
    int level;
    Field begin, length;
    Fraction upper;
    bool operator<(const Piece& other) const { return upper < other.upper; }
  };

  static constexpr int least_level = 5;   // the place is known to 1/32 of the edge
  static constexpr int most_pieces = 400; // the bound stays guaranteed when it is reached
  static constexpr int precision = 1024;  // relative, of the measure

  std::vector<Piece> pieces_; // a heap: the first may have the largest angle
  Fraction lower_{Ring(0), Ring(1)};

public:
  explicit Largest_deviation(const Normals& n) {
    Polynomial s = n.det * n.det * Normals::square(n.d), p = Normals::square(n.n1) * Normals::square(n.n2);
    const int k = std::min(s.order_at_0(), p.order_at_0());
    s = s.without_end_factors(k, 0);
    p = p.without_end_factors(k, 0);
    const int l = std::min(s.order_at_1(), p.order_at_1());
    add({s.without_end_factors(0, l), p.without_end_factors(0, l), n.side, 0, Field(0), Field(1), {}});
  }

  // \pre neither normal vanishes identically
  Normal_deviation<Field> operator()() {
    for (int i = 0; i < most_pieces && !accurate(); ++i) {
      std::pop_heap(pieces_.begin(), pieces_.end());
      const Piece piece = std::move(pieces_.back());
      pieces_.pop_back();
      const std::pair<Polynomial, Polynomial> s = piece.s.halves(), p = piece.p.halves(), side = piece.side.halves();
      const Field length = piece.length / Field(2);
      add({s.first, p.first, side.first, piece.level + 1, piece.begin, length, {}});
      add({s.second, p.second, side.second, piece.level + 1, Field(piece.begin + length), length, {}});
    }
    const Piece& worst = pieces_.front();
    return {field(lower_), field(worst.upper), worst.begin, Field(worst.begin + worst.length)};
  }

private:
  bool accurate() const {
    const Piece& worst = pieces_.front();
    return worst.level >= least_level && !(Fraction{Ring(Ring(precision + 1) * lower_.numerator),
                                                    Ring(Ring(precision) * lower_.denominator)} < worst.upper);
  }

  void add(Piece piece) {
    piece.upper = upper_bound(piece);
    raise_lower_bound(piece.s, piece.p, piece.side);
    raise_lower_bound(piece.s.reversed(), piece.p.reversed(), piece.side.reversed());
    pieces_.push_back(std::move(piece));
    std::push_heap(pieces_.begin(), pieces_.end());
  }

  static Fraction upper_bound(const Piece& piece) {
    const Sign_pattern side = piece.side.coefficient_signs();
    const bool acute =
        side == Sign_pattern::negative || side == Sign_pattern::nonpositive || side == Sign_pattern::zero;
    const Fraction right_angle{Ring(1), Ring(1)}, straight_angle{Ring(2), Ring(1)};
    const Fraction most = acute ? right_angle : straight_angle;
    Fraction bound = acute ? Fraction{Ring(0), Ring(1)} : right_angle;
    for (int k = 0; k <= piece.p.degree(); ++k) {
      if (!(Ring(0) < piece.p[k])) return most;
      const Fraction sine{piece.s[k], piece.p[k]};
      const Fraction measure = acute ? sine : Fraction{Ring(Ring(2) * piece.p[k] - piece.s[k]), piece.p[k]};
      if (bound < measure) bound = measure;
    }
    return most < bound ? most : bound;
  }

  // by the measure at t = 0
  void raise_lower_bound(const Polynomial& s, const Polynomial& p, const Polynomial& side) {
    if (!(Ring(0) < p[0])) return;
    const int order = side.order_at_0(); // the sign of the cosine near 0; exactly there, sin^2 = 1 if it is zero
    const bool acute = order > side.degree() || side[order] < Ring(0);
    const Fraction measure{acute ? s[0] : Ring(Ring(2) * p[0] - s[0]), p[0]};
    if (lower_ < measure) lower_ = measure;
  }

  static Field field(const Fraction& x) {
    typedef typename Normals::Exact Exact;
    return Field(Exact(Exact(x.numerator) / Exact(x.denominator)));
  }
};

// A sub-interval in which the polynomial has a zero or comes close to one: a point if it is zero at an end, otherwise of
// length 1/1024. \pre it has a zero in [0, 1]
template <class Field, class Polynomial> std::pair<Field, Field> zero_interval(const Polynomial& polynomial) {
  typedef typename Polynomial::NT Ring;
  struct Piece {
    Polynomial p;
    int level;
    Field begin, end;
  };
  constexpr int last_level = 10;
  std::vector<Piece> stack(1, Piece{polynomial, 0, Field(0), Field(1)});
  while (!stack.empty()) {
    const Piece piece = std::move(stack.back());
    stack.pop_back();
    if (piece.p[0] == Ring(0)) return {piece.begin, piece.begin};
    if (piece.p[piece.p.degree()] == Ring(0)) return {piece.end, piece.end};
    const Sign_pattern signs = piece.p.coefficient_signs();
    if (signs == Sign_pattern::positive || signs == Sign_pattern::negative) continue;
    if (piece.level == last_level) return {piece.begin, piece.end};
    const std::pair<Polynomial, Polynomial> halves = piece.p.halves();
    const Field middle = Field(Field(piece.begin + piece.end) / Field(2));
    stack.push_back(Piece{halves.second, piece.level + 1, middle, piece.end});
    stack.push_back(Piece{halves.first, piece.level + 1, piece.begin, middle});
  }
  return {Field(0), Field(1)};
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CONTINUITY_NORMAL_DEVIATION_H
