// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H
#define CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H

#include <boost/config.hpp>

// Functions are inlined by force only where a compiler optimises: otherwise nothing becomes faster but the same code is
// compiled many times.
#if defined(__GNUC__) && !defined(__OPTIMIZE__)
#define CGAL_GC_FORCEINLINE inline
#else
#define CGAL_GC_FORCEINLINE BOOST_FORCEINLINE
#endif

#endif // CGAL_GEOMETRIC_CONTINUITY_INTERNAL_FORCE_INLINE_H
