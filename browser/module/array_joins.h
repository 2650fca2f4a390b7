// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_MODULE_ARRAY_JOINS_H
#define GEOMETRIC_CONTINUITY_BROWSER_MODULE_ARRAY_JOINS_H

#include <cstddef>
#include <cstdint>
#include <vector>

// Returns the joins of a chain of Bezier curves at which an order does not hold, decided exactly:
// numbers i for the join between the curves i and i + 1. The control points stand one after the
// other in an array. `question` is the number of C0, C1, C2, C3, G1, G2, G3 or F3 in this list. The
// result is valid until the next call. Throws Error `not_finite`. Precondition: the dimension is 2
// or 3.
const std::vector<std::uint32_t>& failing_joins(const double* points, std::size_t curves, int degree, int dimension,
                                                int question, bool closed);

// Returns the result of the last call.
const std::vector<std::uint32_t>& last_failing_joins();

#endif // GEOMETRIC_CONTINUITY_BROWSER_MODULE_ARRAY_JOINS_H
