// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_FLATNESS_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_FLATNESS_H

#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The numbers of cells into which a patch is cut in the direction of `u` and of `v`.
struct Patch_cells {
  int u, v;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Bounds for the second derivatives of a Bézier patch that is taken on the unit square, and what follows for its
/// distance from triangles. By the convex hull property the lengths of the derivatives are nowhere greater than
/// \f[ M_{uu} = p(p-1) \max |b_{i+2,j} - 2b_{i+1,j} + b_{ij}|, \quad
///   M_{uv} = pq \max |b_{i+1,j+1} - b_{i+1,j} - b_{i,j+1} + b_{ij}|, \quad
///   M_{vv} = q(q-1) \max |b_{i,j+2} - 2b_{i,j+1} + b_{ij}|. \f]
///
/// <b>Claim.</b> Let the corners \f$ p_k \f$ of a triangle in the unit square differ by at most \f$ h_u \f$ in `u` and
/// \f$ h_v \f$ in `v`, and let \f$ x = \sum \lambda_k p_k \f$ be in the triangle. Then
/// \f[ \left| S(x) - \sum \lambda_k S(p_k) \right| \le \frac{1}{8} (M_{uu} h_u^2 + 2 M_{uv} h_u h_v + M_{vv} h_v^2). \f]
/// <b>Proof.</b> Let \f$ p_k - x = (\delta_k, \epsilon_k) \f$, and let \f$ f \f$ be the component of \f$ S \f$ in a direction of
/// length 1. The segments from \f$ x \f$ to \f$ p_k \f$ lie in the square, hence by Taylor's formula \f$ f(p_k) \f$ differs from
/// \f$ f(x) + Df(x)(p_k - x) \f$ by at most \f$ \frac{1}{2} (M_{uu} \delta_k^2 + 2 M_{uv} |\delta_k \epsilon_k| + M_{vv}
/// \epsilon_k^2) \f$. In the sum with the weights \f$ \lambda_k \f$ the linear terms cancel. What remains of \f$ u \f$ is the
/// variance \f$ \sum \lambda_k \delta_k^2 \f$ of numbers in an interval of length \f$ h_u \f$, which is at most
/// \f$ h_u^2 / 4 \f$; the same holds for \f$ v \f$; and by the inequality of Cauchy and Schwarz
/// \f$ \sum \lambda_k |\delta_k \epsilon_k| \le h_u h_v / 4 \f$. \f$ \Box \f$
///
/// The bounds are floating-point numbers, rounded upwards when the field is exact. With floating-point control points the
/// claim holds up to the rounding of differences and of evaluated points.
class Patch_flatness {
  double uu_ = 0, uv_ = 0, vv_ = 0;

public:
  /// The bounds of a patch. Linear in the number of control points. It needs `CGAL::to_interval()`.
  template <class Traits> explicit Patch_flatness(const Bezier_patch<Traits>& s) {
    typedef Geometric_continuity::Coordinates<Traits> Coordinates;
    const int p = s.degree_u(), q = s.degree_v();
    const auto raise = [](double& bound, int factor, const Coordinates& difference) {
      bound = (std::max)(bound, upwards(factor * length(difference)));
    };
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        const Coordinates b = s.coordinates(i, j);
        if (i + 2 <= p)
          raise(uu_, p * (p - 1), s.coordinates(i + 2, j) - s.coordinates(i + 1, j) + b - s.coordinates(i + 1, j));
        if (j + 2 <= q)
          raise(vv_, q * (q - 1), s.coordinates(i, j + 2) - s.coordinates(i, j + 1) + b - s.coordinates(i, j + 1));
        if (i < p && j < q)
          raise(uv_, p * q, s.coordinates(i + 1, j + 1) - s.coordinates(i + 1, j) + b - s.coordinates(i, j + 1));
      }
  }

  /// A bound for the distance of the patch from its triangles, when it is cut into equal cells and each triangle lies in
  /// a cell.
  double distance(const Patch_cells& cells) const {
    const double hu = 1.0 / cells.u, hv = 1.0 / cells.v;
    return upwards(0.125 * (uu_ * hu * hu + 2 * uv_ * hu * hv + vv_ * hv * hv));
  }

  /// The least number of cells whose numbers in `u` and in `v` are powers of two between `least` and `most` and whose
  /// distance is not greater than `tolerance`; empty when even the most cells do not suffice.
  std::optional<Patch_cells> cells(double tolerance, int least, int most) const {
    std::optional<Patch_cells> best;
    int v = most;
    for (int u = least; u <= most; u *= 2) { // more cells in u need fewer in v
      if (!(distance({u, v}) <= tolerance)) continue;
      while (v / 2 >= least && distance({u, v / 2}) <= tolerance) v /= 2;
      if (!best || double(u) * v < double(best->u) * best->v) best = Patch_cells{u, v};
    }
    return best;
  }

private:
  // The few roundings of the formulas here change a number by less than this.
  static double upwards(double x) {
    return x > 0 ? (std::max)(x * (1 + 0x1p-46), (std::numeric_limits<double>::min)()) : x;
  }

  template <class Coordinates> static double length(const Coordinates& x) {
    double result = 0;
    for (const auto& c : x) {
      const std::pair<double, double> interval = CGAL::to_interval(c);
      result = std::hypot(result, (std::max)(-interval.first, interval.second));
    }
    return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_PATCH_FLATNESS_H
