// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ENCLOSED_ARC_H
#define CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ENCLOSED_ARC_H

#include <CGAL/Geometric_continuity/curves/Path_segment.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/numbers/internal/Exact_number.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

/// \file Enclosed_arc.h
/// The directions of arcs of rotated ellipses, which are not rational: they are enclosed by exact
/// numbers, as narrow as is asked for. Two arcs of one ellipse, or of one that is larger, are
/// compared exactly.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// All numbers from one to another one, both exact.
template <class FT> struct Exact_range {
  FT lower, upper;

  explicit Exact_range(const FT& x = FT(0)) : lower(x), upper(x) {}
  Exact_range(const FT& low, const FT& high) : lower(low), upper(high) {}

  bool contains_zero() const { return !(FT(0) < lower) && !(upper < FT(0)); }

  friend Exact_range operator+(const Exact_range& x, const Exact_range& y) {
    return {FT(x.lower + y.lower), FT(x.upper + y.upper)};
  }
  friend Exact_range operator-(const Exact_range& x, const Exact_range& y) {
    return {FT(x.lower - y.upper), FT(x.upper - y.lower)};
  }
  friend Exact_range operator*(const Exact_range& x, const Exact_range& y) {
    const auto [low, high] =
        std::minmax({FT(x.lower * y.lower), FT(x.lower * y.upper), FT(x.upper * y.lower), FT(x.upper * y.upper)});
    return {low, high};
  }
};

// Bounds of the square root of x >= 0 that differ by 2^-bits.
template <class FT> Exact_range<FT> root_range(const FT& x, int bits) {
  typedef typename Exact_number<FT>::type Exact;
  typedef Fraction_traits<Exact> Fraction;
  typedef typename Fraction::Numerator_type Integer;
  if (!(FT(0) < x)) return Exact_range<FT>();
  Integer p;
  typename Fraction::Denominator_type q;
  typename Fraction::Decompose()(Exact_number<FT>::of(x), p, q);
  const Integer unit = CGAL::ipower(Integer(2), bits), scaled = Integer(Integer(p * unit * unit) / Integer(q)),
                root = scaled == Integer(0) ? Integer(0) : integer_square_root_below(scaled);
  return {FT(Exact(Exact(root) / Exact(unit))), FT(Exact(Exact(Integer(root + Integer(1))) / Exact(unit)))};
}

// The cross and the dot product of two directions, of which no one is zero.
template <class FT> struct Enclosed_products {
  Exact_range<FT> cross, dot;

  // Returns whether the directions differ for certain.
  bool differ() const { return !cross.contains_zero() || dot.upper < FT(0); }

  // The size of the cross product and the dot product at the least angle, and at the largest one.
  std::pair<FT, FT> least() const { return {dot.upper < FT(0) ? largest_size() : least_size(), dot.upper}; }
  std::pair<FT, FT> largest() const { return {dot.lower < FT(0) ? least_size() : largest_size(), dot.lower}; }

  // The angle in radians.
  Enclosure angle() const {
    const auto at = [](const std::pair<FT, FT>& x, double otherwise) -> Enclosure {
      if (x.first == FT(0) && x.second == FT(0)) return {otherwise, otherwise};
      return angle_enclosure(FT(x.first * x.first), x.second);
    };
    return {at(least(), 0).lower, at(largest(), at({FT(0), FT(-1)}, 0).upper).upper};
  }

  // Returns whether the angle is larger than the bound, if all of these are, or none.
  std::optional<bool> exceed(const Corner_threshold& bound) const {
    const auto exceeds = [&](const std::pair<FT, FT>& x) { return bound.is_exceeded(x.first, x.second); };
    const std::pair<FT, FT> a = least(), b = largest();
    for (const std::pair<FT, FT>& x : {a, b})
      if (x.first == FT(0) && x.second == FT(0)) return std::nullopt;
    const bool answer = exceeds(a);
    return answer == exceeds(b) ? std::optional<bool>(answer) : std::nullopt;
  }

private:
  FT least_size() const {
    return cross.contains_zero() ? FT(0) : FT(0) < cross.lower ? cross.lower : FT(FT(0) - cross.upper);
  }
  FT largest_size() const { return (std::max)(cross.upper, FT(FT(0) - cross.lower)); }
};

// An arc, whose parts are read here, by its derivatives with respect to the eccentric angle.
template <class Traits> class Enclosed_arc {
  typedef typename Traits::FT FT;
  typedef Exact_range<FT> Range;
  typedef Coordinate_jet<FT, 2> Jet;
  const Elliptical_arc<Traits>& arc_;

public:
  explicit Enclosed_arc(const Elliptical_arc<Traits>& arc) : arc_(arc) {}

  // The tangent at an end, with bounds that differ by about 2^-bits times the numbers of the arc;
  // nothing where that is too little.
  std::optional<std::array<Range, 2>> tangent(Curve_end which, int bits) const {
    std::array<Range, 2> k{Range(arc_.k_[0]), Range(arc_.k_[1])};
    Range d(arc_.radicand_);
    if (!arc_.is_known()) {
      const auto [cosine, sine] = cosine_and_sine(bits);
      for (std::size_t i = 0; i < 2; ++i) k[i] = turned(ellipse().k[i], cosine, sine);
      const Range lambda = turned(ellipse().lambda, cosine, sine);
      if (!(FT(0) < lambda.lower)) return std::nullopt;
      d = {radicand(lambda.upper), radicand(lambda.lower)};
    }
    const Range root(root_range(d.lower, bits).lower, root_range(d.upper, bits).upper), zero;
    const Range s = arc_.same_flags_ ? zero - root : root;
    const Coordinates<Traits> c = arc_.half_chord();
    std::array<Range, 2> tangent;
    for (int i = 0; i < 2; ++i) {
      const std::size_t j = static_cast<std::size_t>(i);
      tangent[j] = (which == Curve_end::end ? zero - k[j] : k[j]) - s * Range(c[i]);
      if (!arc_.sweep_) tangent[j] = zero - tangent[j];
    }
    return tangent;
  }

  // The jets at the end of this arc and at the start of another one in coordinates in which they
  // are rational, if both are halves of ellipses, or are parts of equal angle on different sides of
  // their chords, and the chords are parallel: then the derivatives of one are multiples of those
  // of the other one. Here x - c, the way from the centre, and its quarter turn are the unit
  // vectors.
  std::optional<std::pair<Jet, Jet>> common_jets(const Enclosed_arc& next, int order) const {
    if (arc_.is_known() || next.arc_.is_known() || ellipse().degrees != next.ellipse().degrees) return std::nullopt;
    const Coordinates<Traits> h = arc_.half_chord(), g = next.arc_.half_chord();
    const int large = h[0] != FT(0) ? 0 : 1;
    const FT ratio = FT(g[large] / h[large]);
    if (ratio == FT(0) || g != ratio * h) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (next.ellipse().k[i][j] != FT(ratio * ellipse().k[i][j])) return std::nullopt;
    const bool opposite = arc_.same_flags_ != next.arc_.same_flags_ && ellipse().lambda == next.ellipse().lambda;
    if (!opposite && !(is_half() && next.is_half())) return std::nullopt;
    const bool meet = arc_.end_ == next.arc_.start_;
    return std::pair<Jet, Jet>(unit_jet(FT(1), FT(0), order),
                               next.unit_jet(FT(FT(0) - ratio), meet ? FT(0) : FT(1), order));
  }

private:
  const Rotated_ellipse<FT>& ellipse() const { return arc_.rotated_.front(); }

  static FT radicand(const FT& lambda) { return lambda < FT(1) ? FT(FT(FT(1) - lambda) / lambda) : FT(0); }

  std::pair<Range, Range> cosine_and_sine(int bits) const {
    typedef Numerator<typename Exact_number<FT>::type> Integer;
    const Rotation_bounds<Integer> r(long_fraction(Exact_number<FT>::of(ellipse().degrees)), bits);
    const FT unit = from_long_integer<FT>(Integer(Integer(1) << bits));
    const auto range = [&](const Integer& x) -> Range {
      return {FT(from_long_integer<FT>(Integer(x - r.error)) / unit),
              FT(from_long_integer<FT>(Integer(x + r.error)) / unit)};
    };
    return {range(r.cosine), range(r.sine)};
  }

  // Returns whether the radii are too small, or just large enough, for certain.
  bool is_half() const {
    const auto [cosine, sine] = cosine_and_sine(256);
    return !(turned(ellipse().lambda, cosine, sine).lower < FT(1));
  }

  // The derivatives where x - c is `size` times the first unit vector.
  Jet unit_jet(const FT& size, const FT& position, int order) const {
    Jet jet(2, order);
    jet[0][0] = position;
    for (int j = 1; j <= order; ++j) {
      const bool odd = j % 2 == 1, negative = (j % 4 == 2 || j % 4 == 3) != (odd && !arc_.sweep_);
      jet[j][odd ? 1 : 0] = negative ? FT(FT(0) - size) : size;
    }
    return jet;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_JOINS_INTERNAL_ENCLOSED_ARC_H
