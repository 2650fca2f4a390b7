// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/internal/double_derivatives.h>

#include <boost/math/quadrature/gauss.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

/// \file fairness.h
/// How fair a curve is, as numbers that depend neither on its scale nor on its parameter: the variation of its curvature, which the
/// strategy `Fair` makes small, and its bending energy. Moreton and Séquin.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Two integrals over a curve, of functions that are not negative: its length and another one. By Gauss's quadrature on
// intervals that are halved until the halves say the same as the whole. An integrand returns both functions for a parameter in [0, 1]; an infinite value is allowed.
template <class Integrand> class Adaptive_quadrature {
  typedef std::array<double, 2> Values;

  struct Part {
    std::size_t piece;
    double a, b;
    Values left, right; // the integrals over both halves
    Values error;       // how far they are from that over the whole
  };

  static constexpr double precision = 1e-8; // relative, of both integrals
  static constexpr double least = 1e-24;    // the second integral is not distinguished from 0 below this
  static constexpr double shortest_part =
      0x1p-20; // where it is still in doubt on such a part of a piece, it is infinite
  static constexpr std::size_t most_parts = 1000; // and twice as many as there are pieces

  const std::vector<Integrand>& pieces_;
  std::vector<Part> parts_;

public:
  explicit Adaptive_quadrature(const std::vector<Integrand>& pieces) : pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) add(parts_, i, 0, 1, gauss(i, 0, 1));
  }

  // The second integral may be infinite. Throws Error `work_limit` when too many parts are needed.
  Values operator()() {
    for (;;) {
      const Values total = sums(), share = {precision * total[0] / static_cast<double>(parts_.size()),
                                            precision * total[1] / static_cast<double>(parts_.size()) + least};
      std::vector<Part> finer;
      for (const Part& part : parts_) {
        if (part.error[0] <= share[0] && part.error[1] <= share[1]) {
          finer.push_back(part);
          continue;
        }
        if (part.b - part.a < shortest_part) return {total[0], std::numeric_limits<double>::infinity()};
        const double middle = (part.a + part.b) / 2;
        add(finer, part.piece, part.a, middle, part.left);
        add(finer, part.piece, middle, part.b, part.right);
      }
      if (finer.size() == parts_.size()) return total;
      if (finer.size() > most_parts + 2 * pieces_.size()) throw Error(Error_code::work_limit, "fairness of a curve");
      parts_ = std::move(finer);
    }
  }

private:
  Values sums() const {
    Values sum{};
    for (const Part& part : parts_)
      for (int k = 0; k < 2; ++k) sum[k] += part.left[k] + part.right[k];
    return sum;
  }

  void add(std::vector<Part>& parts, std::size_t piece, double a, double b, const Values& whole) const {
    const double middle = (a + b) / 2;
    Part part{piece, a, b, gauss(piece, a, middle), gauss(piece, middle, b), {}};
    for (int k = 0; k < 2; ++k) {
      part.error[k] = std::abs(part.left[k] + part.right[k] - whole[k]);
      if (std::isnan(part.error[k])) part.error[k] = std::numeric_limits<double>::infinity();
    }
    parts.push_back(part);
  }

  Values gauss(std::size_t piece, double a, double b) const {
    typedef boost::math::quadrature::gauss<double, 10> Rule; // its nodes on one side of 0, in [-1, 1]
    const double middle = (a + b) / 2, half = (b - a) / 2;
    Values sum{};
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (double x : {-Rule::abscissa()[i], Rule::abscissa()[i]}) {
        const Values values = pieces_[piece](middle + half * x);
        for (int k = 0; k < 2; ++k) sum[k] += half * Rule::weights()[i] * values[k];
      }
    return sum;
  }
};

// Functions of the first three derivatives of a curve: the speed |d1|, and what is integrated. Without a tangent it is infinite.

// |(dK/ds)_perp|^2 |d1|, where (dK/ds)_perp = (d3_perp - 3 a d2_perp) / |d1|^3 and a = d1.d2 / d1.d1. The same formula for the
// blends of one family, at fixed nodes and with its derivatives, is in blends/internal/Fairness_quadrature.h.
struct Curvature_variation {
  template <int N> std::array<double, 2> operator()(const Double_derivatives<N>& d) const {
    const double g = dot(d[0], d[0]), speed = std::sqrt(g);
    if (!(g > 0)) return {0, std::numeric_limits<double>::infinity()};
    const double a = dot(d[0], d[1]) / g;
    const Coordinate_vector<double, N> second = d[1] - a * d[0], third = d[2] - (dot(d[0], d[2]) / g) * d[0],
                                       m = third - (3 * a) * second;
    return {speed, dot(m, m) / (g * g * speed)};
  }
};

// |K|^2 |d1|, where K = d2_perp / |d1|^2.
struct Squared_curvature {
  template <int N> std::array<double, 2> operator()(const Double_derivatives<N>& d) const {
    const double g = dot(d[0], d[0]), speed = std::sqrt(g);
    if (!(g > 0)) return {0, std::numeric_limits<double>::infinity()};
    const Coordinate_vector<double, N> second = d[1] - (dot(d[0], d[1]) / g) * d[0];
    return {speed, dot(second, second) / (g * speed)};
  }
};

// A formula along a piece of a curve.
template <class Formula, class Derivatives> struct Integrand {
  Derivatives derivatives;
  std::array<double, 2> operator()(double t) const { return Formula()(derivatives(t)); }
};

// The length of a curve, in a unit that fits it, and the integral of a formula.
template <class Formula, class Curve> std::array<double, 2> curve_integrals(const Curve& curve) {
  const auto pieces = derivatives_of_pieces(curve);
  typedef Integrand<Formula, typename std::decay_t<decltype(pieces)>::value_type> Piece;
  std::vector<Piece> integrands;
  for (const auto& piece : pieces) integrands.push_back(Piece{piece});
  return Adaptive_quadrature<Piece>(integrands)();
}

} // namespace internal

/// \ingroup PkgGeometricContinuityCurves
/// Returns the variation of curvature \f$ E = L^3 \int_0^L |(dK/ds)^\perp|^2\,ds \f$ of a curve of length `L` in any dimension, with
/// \f$ (dK/ds)^\perp = (d_3^\perp - 3 \tfrac{d_1\cdot d_2}{d_1\cdot d_1}\, d_2^\perp) / |d_1|^3 \f$: in the plane
/// \f$ L^3\int\kappa'^2 \f$, in space \f$ L^3\int\kappa'^2+\kappa^2\tau^2 \f$. It is zero for straight lines and circles, and the
/// same for a curve of any size and in any direction. The smaller, the fairer.
///
/// In floating-point numbers with every kernel, whose points may be of any size, to a relative precision of \f$ 10^{-8} \f$: the
/// length and the integral by Gauss's quadrature with ten nodes on intervals that are halved until both halves say the same as the
/// whole. There are at most 1000 intervals and two for each piece. Values below about \f$ 10^{-21} \f$ may be rounding.
///
/// Infinite when the first derivative vanishes in the domain, as in a cusp, also when that only seems so on a millionth of a
/// piece. (Where it vanishes on a straight line the value has no meaning.) A curve of several pieces has the sum of their
/// integrals; what the curvature jumps between them does not count.
///
/// \param curve a model of `ParametricCurve`. Of a `Bezier_curve`, a `Composite_bezier_curve`, a `Bspline_curve`, what is
///        derived from them, and the rational ones the pieces are known; other curves are asked for jets of order 3 inside of the domain, which are
///        expected to be smooth there.
/// \throws Error `work_limit` when more intervals are needed, `jet_order_too_low` when the curve has jets of a lower order
/// \throws Error `not_finite` when differences of floating-point coordinates overflow
template <class Curve> double fairness(const Curve& curve) {
  const std::array<double, 2> r = internal::curve_integrals<internal::Curvature_variation>(curve);
  return std::isinf(r[1]) ? r[1] : r[0] * r[0] * r[0] * r[1];
}

/// \ingroup PkgGeometricContinuityCurves
/// Returns the bending energy \f$ L \int_0^L |K|^2\,ds \f$ of a curve of length `L` in any dimension, with the curvature vector
/// \f$ K = d_2^\perp / |d_1|^2 \f$. It is the same for a curve of any size; that of an arc of a circle is the square of its angle.
/// All else as for `fairness()`.
/// \throws Error as `fairness()`
template <class Curve> double bending_energy(const Curve& curve) {
  const std::array<double, 2> r = internal::curve_integrals<internal::Squared_curvature>(curve);
  return std::isinf(r[1]) ? r[1] : r[0] * r[1];
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_FAIRNESS_H
