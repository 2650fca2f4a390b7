// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define GEOMETRIC_CONTINUITY_INSTANTIATE template
#include "instantiated_once.h"
