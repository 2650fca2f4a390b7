// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_LARGEST_MEASURE_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_LARGEST_MEASURE_H

#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/edges/internal/Edge_normals.h>
#include <CGAL/Geometric_continuity/edges/internal/Integer_angle_maximum.h>
#include <CGAL/Geometric_continuity/numbers/internal/subdivision.h>

#include <optional>
#include <utility>
#include <vector>

/// \file Largest_measure.h
/// Where the angle of two normals along an edge is largest, enclosed by branch and bound in exact
/// arithmetic.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The squared sine s/p of the angle between two normals n1, n2 along an edge, and a polynomial with
// the sign of n1 . n2, but for zeros: p = |n1|^2 |n2|^2 and s = p - (n1 . n2)^2. Zeros that n1 or
// n2 have are split off, so that p is positive on the whole closed interval. \pre neither normal
// vanishes identically
template <class Field> struct Edge_measure {
  typedef Edge_normals<Field> Normals;
  typedef typename Normals::Polynomial Polynomial;
  typedef typename Normals::Vector Vector;

  Polynomial s, p, side;

  // `vanishing` tells whether a normal is zero somewhere on [0, 1]
  Edge_measure(Vector n1, Vector n2, bool vanishing) {
    Polynomial factor = one(); // of the normals
    if (vanishing)
      factor = without_square_factors(counted_product(without_common_factor(n1), without_common_factor(n2)));
    side = sum_of_products<3>(n1, n2);
    p = counted_product(Normals::square(n1), Normals::square(n2));
    s = p - counted_product(side, side);
    if (factor.degree() > 0) side = counted_product(factor, side);
  }

private:
  typedef typename Polynomial::NT Ring;
  typedef typename Normals::Exact Exact;
  typedef Power_polynomial<Exact> Power;

  static Polynomial one() { return Polynomial(std::vector<Ring>(1, Ring(1))); }

  static Power power_form(const Polynomial& p) { return Power(p.template bernstein<Exact>()); }

  // Positive multiples of the polynomials, by one factor, in the ring.
  static std::vector<Polynomial> in_ring(const std::vector<Power>& powers) {
    Common_denominator<Field> denominator;
    std::vector<std::vector<Exact>> b;
    for (const Power& p : powers) {
      b.push_back(p.is_zero() ? std::vector<Exact>(1, Exact(0)) : p.bernstein().coefficients());
      for (const Exact& x : b.back()) denominator.include(Field(x));
    }
    std::vector<Polynomial> result;
    for (const std::vector<Exact>& row : b) {
      std::vector<Ring> c;
      for (const Exact& x : row) c.push_back(denominator.numerator(Field(x)));
      result.push_back(Polynomial::from_bernstein(std::move(c)));
    }
    return result;
  }

  // Divides by the greatest common divisor of the coordinates and returns it, both up to positive
  // factors.
  static Polynomial without_common_factor(Vector& n) {
    std::vector<Power> v;
    for (const Polynomial& x : n) v.push_back(power_form(x));
    const Power factor = greatest_common_divisor(greatest_common_divisor(v[0], v[1]), v[2]);
    for (Power& x : v) {
      Power dividend = x;
      x = dividend.divide(factor);
    }
    const std::vector<Polynomial> quotients = in_ring(v);
    for (int i = 0; i < 3; ++i) n[i] = quotients[i];
    return in_ring({factor})[0];
  }

  // The product of the factors of odd multiplicity, with the same sign as p wherever p is not zero.
  static Polynomial without_square_factors(const Polynomial& p) { return in_ring({odd_factors(power_form(p))})[0]; }

  // With the factors a_i of multiplicity i, g = gcd(p, p') is the product of a_i^(i-1), and p/g
  // that of all a_i, which are the odd ones of p and those of g.
  static Power odd_factors(Power p) {
    if (p.degree() < 1) return p;
    const Power g = greatest_common_divisor(p, p.derivative());
    Power all = p.divide(g);
    return all.divide(odd_factors(g));
  }
};

// Returns whether coefficients prove that an angle is nowhere obtuse, whose cosine has the sign of
// -side.
template <class Polynomial> bool is_acute(const Polynomial& side) {
  const Sign_pattern signs = coefficient_signs(side);
  return signs == Sign_pattern::negative || signs == Sign_pattern::nonpositive || signs == Sign_pattern::zero;
}

// Branch and bound for the largest measure of the quotients s/p of two polynomials, 0 <= s <= p and
// 0 < p on [0, 1], with s/p = sin^2 and a cosine that has the sign of -side. As s and p have one
// degree, s/p lies between the least and the largest s_k/p_k where all p_k > 0. All arithmetic on
// pieces is that of a ring.
//
// Where the numbers are all about 1, it ends soon: let M be the supremum and q = M p - s, or
// (M - 2) p + s where obtuse, so that q >= 0. On a piece of length h at a zero of q of order m the
// coefficients of q are O(h^m), and so are the errors of both bounds; at a distance of some h from
// the zeros q is positive, and so are its coefficients. So on each level a bounded number of pieces
// is left, about two for each zero, and 27 to 55 levels are needed. Where the angle varies on an
// interval of length 2^-k only, they are about k more; so the search stops when the meter does not
// allow more, and the bounds are what has been proved until then.
template <class Field> class Largest_measure {
  typedef typename Edge_sides<Field>::Polynomial Polynomial;
  typedef typename Polynomial::NT Ring;
  typedef typename Edge_normals<Field>::Exact Exact;

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

  static constexpr int least_level = 5;    // the place is known to 1/32 of the edge
  static constexpr int most_pieces = 5000; // the bound stays guaranteed when it is reached

  const Exact epsilon_ = power_of_half(53), tiny_ = power_of_half(110);
  Largest_first<Piece> pieces_; // the next one may have the largest angle
  Fraction lower_{Ring(0), Ring(1)};
  double steps_ = 0; // taken so far

public:
  Largest_measure(Polynomial s, Polynomial p, Polynomial side) {
    add({std::move(s), std::move(p), std::move(side), 0, Field(0), Field(1), {}});
  }

  Normal_deviation<Field> operator()() {
    int divided = 0;
    const auto examine = [&](const Piece& worst) {
      // unreachable: ends a search that the accuracy or the limit of the work ends earlier
      return divided++ < most_pieces && may_go_on(worst) && !accurate(worst) ? After_part::divide : After_part::stop;
    };
    subdivide(pieces_, examine, [&](const Piece& piece) {
      const std::pair<Polynomial, Polynomial> s = piece.s.halves(), p = piece.p.halves(), side = piece.side.halves();
      const Field length = piece.length / Field(2);
      add({s.first, p.first, side.first, piece.level + 1, piece.begin, length, {}});
      add({s.second, p.second, side.second, piece.level + 1, Field(piece.begin + length), length, {}});
    });
    const Piece& worst = pieces_.next();
    return {Field(exact(lower_)), Field(exact(worst.upper)), worst.begin, Field(worst.begin + worst.length)};
  }

private:
  // Returns whether the meter allows to divide the next piece. The bounds take a product for each
  // coefficient and comparison.
  bool may_go_on(const Piece& worst) {
    const double n = worst.p.degree() + 1;
    const std::size_t words = number_words(worst.p[worst.p.degree() / 2]);
    const double steps = bisection_steps(worst.s) + bisection_steps(worst.p) + bisection_steps(worst.side) +
                         8 * n * Work_meter::product_steps(words, words);
    if (!work_meter().allows_search(steps_, steps)) return false;
    steps_ += steps;
    return true;
  }

  // Returns whether the bounds x <= y of the measure determine the angle up to its 2^-54-th part.
  // With s = sin^2 and c = cos^2 the measure changes by 2 sqrt(s c) times the change of the angle.
  // Where y - x <= 2^-53 s c for the least s c in between, which is at one of the bounds, the angle
  // therefore changes by at most 2^-54 sqrt(s c), and sqrt(s c) <= sin is at most the angle.
  // If |1 - x| and |1 - y|, both c, are at most 2^-110, or the s near the straight angle, then cos
  // or sin is at most 2^-55 at both ends, and the angle changes by 2^-54 at most.
  bool accurate(const Piece& worst) const {
    if (worst.level < least_level) return false;
    const Ring factor(1 << 20); // soon tells that they are far from it
    if (Ring(Ring(factor + Ring(1)) * Ring(lower_.numerator * worst.upper.denominator)) <
        Ring(factor * Ring(worst.upper.numerator * lower_.denominator)))
      return false;
    const Exact x = exact(lower_), y = exact(worst.upper), difference = Exact(y - x);
    if (!(x < y)) return true;
    for (int corner : {1, 2})
      if (is_tiny(Exact(x - Exact(corner))) && is_tiny(Exact(y - Exact(corner)))) return true;
    if (x < Exact(1) && Exact(1) < y) return false;
    return !(Exact(epsilon_ * sine_cosine_squared(x)) < difference) &&
           // unreachable: for a width within the 2^-53-th part of the one that is asked for only
           !(Exact(epsilon_ * sine_cosine_squared(y)) < difference);
  }

  bool is_tiny(const Exact& x) const { return !(tiny_ < x) && !(x < Exact(-tiny_)); }

  static Exact sine_cosine_squared(const Exact& measure) {
    const Exact cosine_squared = measure < Exact(1) ? Exact(Exact(1) - measure) : Exact(measure - Exact(1));
    return Exact(cosine_squared * Exact(Exact(1) - cosine_squared));
  }

  static Exact power_of_half(int n) {
    Exact x(1);
    for (; n > 0; --n) x = Exact(x / Exact(2));
    return x;
  }

  void add(Piece piece) {
    piece.upper = upper_bound(piece);
    const int n = piece.p.degree(), before = piece.side.order_at_0(), after = piece.side.order_at_1();
    raise_lower_bound(piece.s[0], piece.p[0], piece.side, before);
    raise_lower_bound(piece.s[n], piece.p[n], piece.side, piece.side.degree() - after);
    pieces_.add(std::move(piece));
  }

  static Fraction upper_bound(const Piece& piece) {
    const bool acute = is_acute(piece.side);
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

  // Raises the bound by the measure at an end, as the limit from inside of the piece: the cosine
  // has the sign of the first coefficient that is not zero. Where it is zero, sin^2 = 1.
  void raise_lower_bound(const Ring& s, const Ring& p, const Polynomial& side, int k) {
    const bool acute = k < 0 || k > side.degree() || side[k] < Ring(0);
    const Fraction measure{acute ? s : Ring(Ring(2) * p - s), p};
    if (lower_ < measure) lower_ = measure;
  }

  static Exact exact(const Fraction& x) { return Exact(Exact(x.numerator) / Exact(x.denominator)); }
};

// Returns the largest measure, in integers of fixed length where they suffice.
template <class Field, class Polynomial>
Normal_deviation<Field> largest_measure(Polynomial s, Polynomial p, Polynomial side) {
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
  if constexpr (Common_denominator<Field>::clears)
    if (is_acute(side))
      if (const std::optional<Normal_deviation<Field>> found = Integer_angle_maximum<Field, Polynomial>(s, p)())
        return *found;
#endif
  return Largest_measure<Field>(std::move(s), std::move(p), std::move(side))();
}

// The largest angle between two normals along an edge. \pre neither vanishes identically
template <class Field>
Normal_deviation<Field> largest_angle(const Homogeneous_vector<typename Edge_sides<Field>::Ring>& n1,
                                      const Homogeneous_vector<typename Edge_sides<Field>::Ring>& n2, bool vanishing) {
  Edge_measure<Field> m(n1, n2, vanishing);
  return largest_measure<Field>(std::move(m.s), std::move(m.p), std::move(m.side));
}

// A sub-interval in which the polynomial has a zero or comes close to one: a point if it is zero at
// an end, otherwise of length 1/1024. \pre it has a zero in [0, 1]
template <class Field, class Polynomial> std::pair<Field, Field> zero_interval(const Polynomial& polynomial) {
  typedef typename Polynomial::NT Ring;
  struct Piece {
    Polynomial p;
    int level;
    Field begin, end;
  };
  constexpr int last_level = 10;
  Newest_first<Piece> pieces;
  pieces.add({polynomial, 0, Field(0), Field(1)});
  std::pair<Field, Field> found(Field(0), Field(1));
  const auto is_in = [&](const Field& begin, const Field& end) {
    found = {begin, end};
    return After_part::stop;
  };
  const auto examine = [&](const Piece& piece) {
    if (piece.p[0] == Ring(0)) return is_in(piece.begin, piece.begin);
    if (piece.p[piece.p.degree()] == Ring(0)) return is_in(piece.end, piece.end);
    const Sign_pattern signs = coefficient_signs(piece.p);
    if (signs == Sign_pattern::positive || signs == Sign_pattern::negative) return After_part::drop;
    return piece.level == last_level ? is_in(piece.begin, piece.end) : After_part::divide;
  };
  subdivide(pieces, examine, [&](const Piece& piece) {
    charge_bisection(piece.p);
    const std::pair<Polynomial, Polynomial> halves = piece.p.halves();
    const Field middle = Field(Field(piece.begin + piece.end) / Field(2));
    pieces.add({halves.second, piece.level + 1, middle, piece.end});
    pieces.add({halves.first, piece.level + 1, piece.begin, middle});
  });
  return found;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_LARGEST_MEASURE_H
