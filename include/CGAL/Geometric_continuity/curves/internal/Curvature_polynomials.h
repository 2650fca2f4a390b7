// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVATURE_POLYNOMIALS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVATURE_POLYNOMIALS_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/local/curvatures.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

// The curvature of a Bezier curve as polynomials of the local parameter t in [0, 1], in an exact
// field. With the derivatives d1, d2, the speed g = d1.d1 and the components w_ij = d1_i d2_j -
// d1_j d2_i, i < j, of the area d1 ^ d2,
//
//   kappa^2 = S / g^3,  S = sum of w_ij^2,     in the plane  kappa = w / g^(3/2),  w = w_01.
//
// The derivative of the curvature has the sign of
//
//   2 g w' - 3 g' w  in the plane,             g S' - 3 g' S  in other dimensions, where kappa >= 0,
//
// which for degree m >= 2 are of degree 4m - 7 and 6m - 11: 2 g w' - 3 g' w = 2 (g det(d1, d3) - 3
// (d1.d2) det(d1, d2)). The leading coefficients cancel, so that w is of degree 2m - 4 and S of
// degree 4m - 8.
//
// For a rational curve p / v with the denominator v, the numerator d1 = p' v - p v' of its
// derivative takes the place of the derivative, and d2 = d1'. It is v^2 x', and w is v^4 times the
// determinant of x', x'', so that
//
//   kappa^2 = S v^4 / g^3,  in the plane  kappa = w v^2 / g^(3/2),
//
// and the derivative of the curvature has the sign of 2 g (w' v + 2 w v') - 3 g' w v, or g (S' v +
// 4 S v') - 3 g' S v.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <class NT> class Curvature_polynomials {
  typedef Bernstein_polynomial<NT> Polynomial;

  Polynomial g_{NT(0)};
  std::vector<Polynomial> w_;
  Polynomial s_{NT(0)};
  Polynomial v_{NT(1)};

public:
  // Takes the control points of the curve, or the homogeneous ones of a rational curve.
  template <int N> Curvature_polynomials(const std::vector<Coordinate_vector<NT, N>>& rows, bool rational) {
    const int dimension = rows.front().dimension() - (rational ? 1 : 0);
    const Work_guard work("the curvature of a curve");
    // S is of degree 4 in the points, and the degree below 4n; with a denominator both are twice as
    // high
    const double n = static_cast<double>(rows.size()) * (rational ? 2 : 1);
    work_meter().charge_products(16 * n * n * dimension * dimension, (rational ? 8 : 4) * common_words<NT>(rows));
    const auto coordinate = [&](int i) -> Polynomial {
      std::vector<NT> c;
      for (const Coordinate_vector<NT, N>& row : rows) c.push_back(row[i]);
      return Polynomial(std::move(c));
    };
    if (rational) v_ = coordinate(dimension);
    std::vector<Polynomial> d1, d2;
    for (int i = 0; i < dimension; ++i) {
      const Polynomial x = coordinate(i);
      d1.push_back(rational ? x.derivative() * v_ - x * v_.derivative() : x.derivative());
      d2.push_back(d1.back().derivative());
      g_ = g_ + d1[i] * d1[i];
      for (int j = 0; j < i; ++j) {
        w_.push_back(d1[j] * d2[i] - d1[i] * d2[j]);
        s_ = s_ + w_.back() * w_.back();
      }
    }
  }

  // Returns whether the curve has a tangent everywhere.
  bool is_regular() const { return sign_pattern(g_) == Sign_pattern::positive; }

  // Returns whether the curvature is zero everywhere.
  bool is_straight() const { return Power_polynomial<NT>(s_).is_zero(); }

  bool is_planar() const { return w_.size() == 1; }

  // The places where the derivative of the curvature is zero.
  std::vector<Isolated_root<NT>> flat_places(const NT& width) const {
    return isolate_roots(slope(), width, default_bisections);
  }

  // A polynomial with the sign of the derivative of the curvature.
  Polynomial slope() const {
    const NT two(2), three(3);
    const auto times_v = [&](const Polynomial& p) -> Polynomial { return v_.degree() == 0 ? p : p * v_; };
    // of p v^k, divided by v^(k-1)
    const auto derivative = [&](const Polynomial& p, int k) -> Polynomial {
      return v_.degree() == 0 ? p.derivative() : p.derivative() * v_ + Polynomial{NT(k)} * p * v_.derivative();
    };
    if (is_planar())
      return Polynomial{two} * g_ * derivative(w_[0], 2) - Polynomial{three} * g_.derivative() * times_v(w_[0]);
    return g_ * derivative(s_, 4) - Polynomial{three} * g_.derivative() * times_v(s_);
  }

  // The zeros of the curvature. At an inflection d1 ^ d2 changes its direction: it is (t - t0)^k
  // times what is not zero, with an odd k.
  std::vector<Isolated_root<NT>> inflections(const NT& width) const {
    std::vector<Isolated_root<NT>> roots = isolate_roots(is_planar() ? w_[0] : s_, width, default_bisections);
    const int even = is_planar() ? 1 : 2; // the multiplicity is k times this
    roots.erase(std::remove_if(roots.begin(), roots.end(),
                               [even](const Isolated_root<NT>& r) { return r.multiplicity / even % 2 == 0; }),
                roots.end());
    return roots;
  }

  // A polynomial with the sign of bound^2 - kappa^2 where the curve has a tangent.
  Polynomial rest(const NT& bound) const {
    charge_cubes();
    const Polynomial v2 = v_ * v_;
    return Polynomial{NT(bound * bound)} * g_ * g_ * g_ - s_ * v2 * v2;
  }

  // The first place where the curvature has no bound: what divides S and g^3 is cancelled; and
  // where the curve turns back, because d1 is an odd power of t - t0 times what is not zero.
  std::optional<Isolated_root<NT>> cusp(const NT& width) const {
    charge_cubes();
    Power_polynomial<NT> cube(g_ * g_ * g_);
    const Power_polynomial<NT> common = greatest_common_divisor(cube, Power_polynomial<NT>(s_));
    std::vector<Isolated_root<NT>> places;
    if (!cube.is_zero()) places = isolate_roots(cube.divide(common).bernstein(), width, default_bisections);
    for (const Isolated_root<NT>& r : isolate_roots(g_, width, default_bisections))
      if (r.multiplicity % 4 == 2 && !(r.end == NT(0) || r.begin == NT(1))) places.push_back(r);
    const auto first = std::min_element(places.begin(), places.end(),
                                        [](const auto& x, const auto& y) { return bool(x.end < y.end); });
    return first == places.end() ? std::nullopt : std::optional<Isolated_root<NT>>(*first);
  }

  // The curvature at an end of the curve.
  Signed_square<NT> start_curvature() const { return end_curvature(false); }
  Signed_square<NT> end_curvature() const { return end_curvature(true); }

  // A positive multiple of d1 ^ d2 near an end: as the Bernstein polynomials fall off one by one,
  // its first coefficient that is not zero. \pre the curve is not straight
  std::vector<NT> start_area() const { return area(false); }
  std::vector<NT> end_area() const { return area(true); }

  // The values of the curvature on [from, to], signed in the plane. Empty unless the speed is
  // proved to be positive there.
  std::optional<Enclosure> curvature(const NT& from, const NT& to) const {
    const std::pair<NT, NT> g = range(g_, from, to), s = range(s_, from, to);
    if (!(NT(0) < g.first)) return std::nullopt;
    const std::pair<NT, NT> v = range(v_, from, to);
    // unreachable: where the denominator is small so is the numerator of the derivative, which is
    //   asked before
    if (!(NT(0) < v.first)) return std::nullopt;
    const NT least = s.first < NT(0) ? NT(0) : NT(s.first * fourth_power(v.first) / (g.second * g.second * g.second)),
             greatest = s.second * fourth_power(v.second) / (g.first * g.first * g.first);
    const double low = sqrt_enclosure(least).lower, high = sqrt_enclosure(greatest).upper;
    if (std::isinf(high)) throw Error(Error_code::not_finite, "curvature_extrema: a curvature is too large");
    if (!is_planar()) return Enclosure{low, high};
    const std::pair<NT, NT> w = range(w_[0], from, to);
    const int first = sign_of(w.first), last = sign_of(w.second);
    // equivalent [< -> <=, 2]: where the greatest value is 0 the curvature is at most -low as
    //   well
    return Enclosure{first > 0 ? low : first < 0 ? -high : 0, last < 0 ? -low : last > 0 ? high : 0};
  }

private:
  // Charges what products of degree 6n or, with a denominator, 12n, take.
  void charge_cubes() const {
    const Work_guard work("the curvature of a curve");
    const double n = g_.degree() + 1;
    work_meter().charge_products(8 * n * n, 3 * number_words(g_[0]));
  }

  // The least and the greatest coefficient on an interval.
  static std::pair<NT, NT> range(const Polynomial& p, const NT& from, const NT& to) {
    const Polynomial part = p.restricted(from, to);
    const auto ends = std::minmax_element(part.coefficients().begin(), part.coefficients().end());
    return {*ends.first, *ends.second};
  }

  Signed_square<NT> end_curvature(bool end) const {
    const auto at = [end](const Polynomial& p) { return p[end ? p.degree() : 0]; };
    const NT g = at(g_), s = at(s_);
    return {is_planar() ? sign_of(at(w_[0])) : sign_of(s), NT(s * fourth_power(at(v_)) / (g * g * g))};
  }
  static NT fourth_power(const NT& x) { return NT(NT(x * x) * NT(x * x)); }

  std::vector<NT> area(bool end) const {
    std::vector<NT> a(w_.size(), NT(0));
    for (int k = 0;; ++k) {
      bool zero = true;
      for (std::size_t i = 0; i < w_.size(); ++i) {
        a[i] = w_[i][end ? w_[i].degree() - k : k];
        zero = zero && a[i] == NT(0);
      }
      if (!zero) break;
    }
    return a;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_CURVATURE_POLYNOMIALS_H
