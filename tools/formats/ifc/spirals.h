// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SPIRALS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SPIRALS_H

#include "formats/ifc/File.h"

#include <CGAL/Geometric_continuity/curves/Clothoid_segment.h>

#include <optional>
#include <vector>

namespace ifc {

Q power(const Q& x, int n);
Q absolute(const Q& x);

// p(a + l w) as a polynomial of w.
std::vector<Q> along(std::vector<Q> p, const Q& a, const Q& l);

// The curvature of a parent curve as a function of its length: a polynomial, and waves over the
// whole length of a segment.
struct Parent_curvature {
  std::vector<Q> polynomial;
  Q cosine = 0, sine = 0; // of pi w and 2 pi w

  bool has_waves() const { return cosine != 0 || sine != 0; }

  // From `start` over `length`, as a polynomial of the part of it, but for waves that begin there.
  std::vector<Q> part(const Q& start, const Q& length) const;
};

// The curvature of a spiral; nothing for other curves.
std::optional<Parent_curvature> spiral(const File& file, const Entity& curve);

// The law of the curvature of a segment from `start` over `length`, in the direction of travel.
GC::Curvature_law law(const Parent_curvature& k, const Q& start, const Q& length);

// Returns whether a curvature only rises or only falls, by the signs of the coefficients of its
// derivative in Bernstein's form, and by the wave in it.
bool only_rises_or_falls(const GC::Curvature_law& law);

} // namespace ifc

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_SPIRALS_H
