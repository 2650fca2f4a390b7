// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ROTATION_FUNCTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ROTATION_FUNCTIONS_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The derivatives of order 0 to k, at v, of the two functions of a rotation by the quaternion (1, v w), with W = w.w:
//   R(v) x = x + f w x x + g w x (w x x),  f = 2v / (1 + v^2 W),  g = 2v^2 / (1 + v^2 W).
// D f = p with the polynomials D = 1 + v^2 W and p, differentiated n times:
//   D f^(n) + n D' f^(n-1) + n(n-1)/2 D'' f^(n-2) = p^(n).
template <class FT> struct Rotation_functions {
  std::vector<FT> f, g;

  Rotation_functions(const FT& v, const FT& W, int k) {
    const FT d0 = FT(1) + v * v * W, d1 = FT(2) * v * W, d2 = FT(2) * W;
    const FT pf[3] = {FT(FT(2) * v), FT(2), FT(0)}, pg[3] = {FT(FT(2) * v * v), FT(FT(4) * v), FT(4)};
    for (int n = 0; n <= k; ++n) {
      f.push_back(next(f, pf, n, d0, d1, d2));
      g.push_back(next(g, pg, n, d0, d1, d2));
    }
  }

private:
  static FT next(const std::vector<FT>& f, const FT* p, int n, const FT& d0, const FT& d1, const FT& d2) {
    FT sum = n < 3 ? p[n] : FT(0);
    if (n > 0) sum -= FT(n) * d1 * f[n - 1];
    if (n > 1) sum -= FT(n) * FT(n - 1) / FT(2) * d2 * f[n - 2];
    sum /= d0;
    check_finite(sum, "Revolution_surface_3: rotation");
    return sum;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_ROTATION_FUNCTIONS_H
