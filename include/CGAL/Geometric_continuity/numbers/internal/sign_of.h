// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SIGN_OF_H
#define CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SIGN_OF_H

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// By comparisons only, which is all that the concept asks of a field.
template <class FT> int sign_of(const FT& x) { return FT(0) < x ? 1 : x < FT(0) ? -1 : 0; }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_NUMBERS_INTERNAL_SIGN_OF_H
