// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_MAX_UNPACKED_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_MAX_UNPACKED_H

#include <cstddef>

// How many bytes a packed file may unpack to, a drawing or a font: a few packed ones can become a
// thousand.
constexpr std::size_t max_unpacked = std::size_t(256) << 20;

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_MAX_UNPACKED_H
