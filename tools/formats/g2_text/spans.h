// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SPANS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SPANS_H

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>

// The spans of curves with their numbers as they are written. Who only reads curves includes
// curves.h, which knows no decisions.
template <class Number> using Program_span = GC::G2_span<Program_traits<Exact>, Number>;

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SPANS_H
