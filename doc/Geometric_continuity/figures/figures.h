// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Figures of the manual that need more than one call of the program or an example.

#ifndef GEOMETRIC_CONTINUITY_DOC_FIGURES_H
#define GEOMETRIC_CONTINUITY_DOC_FIGURES_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Simple_cartesian.h>
#include <Geometric_continuity_figures/Svg_figure.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;

const GC::Svg_style given{GC::Svg_role::given}, result{GC::Svg_role::result}, construction{GC::Svg_role::construction};

// The style with this name in the legend.
inline GC::Svg_style named(GC::Svg_style style, const std::string& name) {
  style.name = name;
  return style;
}

// A text beside a point.
template <class Point> void write(GC::Svg_panel& panel, const Point& p, const std::string& text) {
  typedef std::conditional_t<std::is_same_v<Point, Plane::Point>, Plane, Space> Traits;
  panel.add(GC::Bezier_curve<Traits>{p}, construction).label(text);
}

inline void save(const std::string& file, const GC::Svg_figure& figure) {
  std::ofstream os(file);
  if (!(os << figure).flush()) throw std::runtime_error("cannot write " + file);
}

void draw_curve_figures(const std::string& folder);
void draw_surface_figures(const std::string& folder);
void draw_enclosure(const std::string& folder);

#endif
