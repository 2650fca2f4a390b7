// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random_surfaces.h"
#include "rational_surfaces.h"

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>

// Two surfaces on which all curves u = const are the same but for a translation, and the blends of
// these curves.
template <class Traits> struct Translated_curves {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point P;

  const Bezier<Traits> first = surface(0, 0, 1), second = surface(9, 4, 7);

  template <class Strategy> auto blend_of_curves(const Strategy& strategy) const {
    return GC::blend(curve(0, 0, 1), curve(9, 4, 7), strategy);
  }
  template <class Strategy> auto shape(const Strategy& strategy) const {
    return automatic_surface_shape(first, v1, second, v0, strategy, Edge_direction::same);
  }
  // Returns the shape if all weights of a surface are equal.
  template <class Strategy> auto rational_shape(const Strategy& strategy) const {
    return automatic_surface_shape(Patch<Traits>(first), v1, with_factor(Patch<Traits>(second), FT(8)), v0, strategy,
                                   Edge_direction::same);
  }

private:
  static Bezier<Traits> surface(int y, int c, int d) {
    return Bezier<Traits>(
        {{P(0, y, c), P(0, y + 2, d), P(0, y + 3, d)}, {P(5, y, c + 1), P(5, y + 2, d + 1), P(5, y + 3, d + 1)}});
  }
  static GC::Bezier_curve<Traits> curve(int y, int c, int d) {
    const P points[] = {P(0, y, c), P(0, y + 2, d), P(0, y + 3, d)};
    return GC::Bezier_curve<Traits>(points, points + 3);
  }
};
