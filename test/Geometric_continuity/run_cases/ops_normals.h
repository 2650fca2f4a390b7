// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <CGAL/Geometric_continuity/surfaces/swept_surfaces.h>

// Topic normals: swept surfaces of a Bezier curve.
template <class Traits> bool run_normals(const Case& c, Report& report) {
  if constexpr (GC::dimension_v<Traits> == 3) {
    typedef typename Traits::FT FT;
    typedef typename Input<Traits>::Curve Curve;
    const Input<Traits> in{c};
    const auto vector = [&](const std::string& path) {
      const std::vector<FT> x = in.numbers(path);
      return Traits().construct_vector_object()(static_cast<int>(x.size()), x.begin(), x.end());
    };
    if (c.op == "revolve") {
      const GC::Revolution_surface_3<Curve> s(in.curve("P"), in.point(in.numbers("axis_point")), vector("axis"));
      const FT t = in.number("t"), rot = in.number("rot");
      report.construction("point", [&] { return coordinates<Traits>(s(t, rot)); });
      report.construction("S_t", [&] { return coordinates<Traits>(s.jet(t, rot, 1).partial(1, 0)); });
      report.construction("S_theta", [&] { return coordinates<Traits>(s.angular_derivative(t, rot)); });
      report.construction("normal", [&] { return coordinates<Traits>(s.normal(t, rot)); });
      return true;
    }
    if (c.op == "extrude") {
      const GC::Extrusion_surface_3<Curve> surface(in.curve("P"), vector("direction"));
      const FT t = in.number("t"), s = in.number("s");
      report.construction("point", [&] { return coordinates<Traits>(surface(t, s)); });
      report.construction("S_t", [&] { return coordinates<Traits>(surface.jet(t, s, 1).partial(1, 0)); });
      report.construction("S_s", [&] { return coordinates<Traits>(surface.jet(t, s, 1).partial(0, 1)); });
      report.construction("normal", [&] { return coordinates<Traits>(surface.normal(t, s)); });
      return true;
    }
  }
  return false;
}
