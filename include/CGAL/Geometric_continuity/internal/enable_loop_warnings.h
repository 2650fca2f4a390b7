// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// No include guard: see disable_loop_warnings.h.
#ifdef CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_DISABLED
#undef CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_DISABLED
#pragma clang diagnostic pop
#endif
