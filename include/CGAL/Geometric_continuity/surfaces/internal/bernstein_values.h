// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BERNSTEIN_VALUES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BERNSTEIN_VALUES_H

#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// B_j^m = s B_j^(m-1) + t B_(j-1)^(m-1): replaces the values of degree m - 1, in b[1], ..., b[m], by those of degree m, in
// b[1], ..., b[m+1]. In front, and in b[m+1] before, is a zero. The values are those at t if s + t = 1, otherwise those at
// t / (s + t) multiplied by (s + t)^m.
template <class FT> void raise_bernstein_values(std::vector<FT>& b, int m, const FT& s, const FT& t) {
  for (int j = m + 1; j > 0; --j) b[j] = FT(s * b[j] + t * b[j - 1]);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BERNSTEIN_VALUES_H
