// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"
#include "ops_bspline.h"

#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>

// Topic ribbon. Rounded kernels take scaled parameters, see Spline_input: this multiplies beta, and
// divides F by the scale and F' by its square.
template <class Traits> bool run_ribbon(const Case& c, Report& report) {
  if constexpr (GC::dimension_v<Traits> == 3) {
    if (c.op != "ribbon") return false;
    typedef typename Traits::FT FT;
    typedef GC::G1_ribbon<Traits> Ribbon;
    typedef typename Ribbon::Field Field;
    typedef typename Ribbon::Polynomial Polynomial;
    const Spline_input<Traits> in(c);
    std::vector<FT> knots;
    for (int i = 0; i < c.length("knots"); ++i) knots.push_back(in.parameter("knots." + std::to_string(i)));
    const auto curve = [&](const char* path) {
      const std::vector<typename Traits::Point> points = Input<Traits>{c}.points(path);
      return GC::Bspline_curve<Traits>(points.begin(), points.end(), GC::Knot_vector<FT>(3, knots));
    };
    const Ribbon ribbon = connect_g1(curve("C"), curve("C1"), curve("C2"));

    const Field scale = from_rational<Field>(in.scale);
    const auto coefficients = [](const Polynomial& p, const Field& factor) {
      std::vector<Field> b;
      for (const Field& x : p.coefficients()) b.push_back(Field(x * factor));
      return b;
    };
    const Field one(1), inverse = one / scale;
    report.construction("alpha", [&] { return coefficients(ribbon.alpha, one); });
    report.construction("beta", [&] { return coefficients(ribbon.beta, inverse); });
    report.construction("alpha2", [&] { return coefficients(ribbon.alpha2, one); });
    report.construction("beta2", [&] { return coefficients(ribbon.beta2, inverse); });
    report.construction("F", [&] {
      const GC::Ribbon_end<Field>&a = ribbon.start, &b = ribbon.end;
      return std::vector<Field>{Field(a.determinant * scale), Field(a.determinant_derivative * scale * scale),
                                Field(b.determinant * scale), Field(b.determinant_derivative * scale * scale)};
    });
    report.predicate("position_coplanar", [&] { return ribbon.position_coplanar(); });
    report.predicate("twist_coplanar", [&] { return ribbon.twist_coplanar(); });
    report.predicate("alpha_sign", [&] { return to_string(ribbon.alpha_signs()); });
    report.predicate("two_minus_alpha_sign", [&] { return to_string(ribbon.two_minus_alpha_signs()); });

    report.construction("surface_knots_u", [&] {
      std::vector<FT> u;
      for (const FT& knot : ribbon.side1.knots_u()) u.push_back(in.unscaled(knot));
      return u;
    });
    const auto row = [](const typename Ribbon::Surface& s, int j) {
      std::vector<std::vector<FT>> rows;
      for (int i = 0; i < s.number_of_points_u(); ++i) rows.push_back(coordinates<Traits>(s.control_point(i, j)));
      return rows;
    };
    report.construction("row0", [&] { return row(ribbon.side1, 0); });
    report.construction("row1_side1", [&] { return row(ribbon.side1, 1); });
    report.construction("row1_side2", [&] { return row(ribbon.side2, 1); });
    const std::vector<GC::Edge_continuity<Field>> spans = ribbon.continuity();
    report.consequence("g1_coplanar_per_span", [&] {
      std::vector<bool> flags;
      for (const GC::Edge_continuity<Field>& span : spans) flags.push_back(span.coplanar);
      return flags;
    });
    report.consequence("side_per_span", [&] {
      std::vector<std::string> sides;
      for (const GC::Edge_continuity<Field>& span : spans) sides.push_back(to_string(span.side));
      return sides;
    });
    return true;
  } else
    return false;
}
