// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H

#include <boost/config.hpp>

// Functions are inlined by force only where a compiler optimises: otherwise nothing becomes faster
// but the same code is compiled many times.
//
// CGAL_GC_FORCEINLINE_LAMBDA stands behind the parameters of a lambda. Without it a compiler leaves
// some of those that are called for each element of a loop where they are, once a translation unit
// has grown by more than it allows, and the loop is not vectorised any more.
#if defined(__GNUC__) && !defined(__OPTIMIZE__)
#define CGAL_GC_FORCEINLINE inline
#else
#define CGAL_GC_FORCEINLINE BOOST_FORCEINLINE
#endif
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define CGAL_GC_FORCEINLINE_LAMBDA __attribute__((always_inline))
#else
#define CGAL_GC_FORCEINLINE_LAMBDA
#endif

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H
