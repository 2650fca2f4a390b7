// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_REFUSE_FAST_MATH_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_REFUSE_FAST_MATH_H

// The stages of a decision that are made in floating-point arithmetic rest on the rounding of each operation, as IEEE
// 754 defines it, and on the recognition of infinite and undefined numbers. -fno-math-errno and -frounding-math leave
// both alone.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Geometric_continuity: with -ffast-math or -Ofast exact predicates would be wrong; -fno-math-errno is allowed."
#endif

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_REFUSE_FAST_MATH_H
