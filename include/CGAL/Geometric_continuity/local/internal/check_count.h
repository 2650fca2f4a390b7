// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_CHECK_COUNT_H
#define CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_CHECK_COUNT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <boost/config.hpp>

#include <string>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

[[noreturn]] BOOST_NOINLINE inline void refuse_count(int n, const char* place) {
  throw Error(Error_code::negative_count, std::string(place) + ": " + std::to_string(n));
}

// Refuses a negative number of derivatives, of elevations, of halvings, ... `place` names the function. The message is put
// together out of line, so that the check is one comparison.
BOOST_FORCEINLINE void check_count(int n, const char* place) {
  if (n < 0) refuse_count(n, place);
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_LOCAL_INTERNAL_CHECK_COUNT_H
