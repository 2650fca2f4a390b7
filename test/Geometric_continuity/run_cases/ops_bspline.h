// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>

// Splines of a case. Rounded kernels take all parameters times a common denominator: whole numbers,
// which they represent and compare without rounding.
template <class Traits> struct Spline_input {
  typedef typename Traits::FT FT;
  typedef GC::Bspline_curve<Traits> Curve;

  const Case& c;
  Exact_rational scale = Exact_rational(1);

  explicit Spline_input(const Case& c) : c(c) {
    if constexpr (std::is_floating_point_v<FT> || std::is_same_v<FT, CGAL::Interval_nt<>>)
      for (const auto& [path, value] : c.in)
        if (path == "u" || path.find("knots.") != std::string::npos) {
          const Exact_rational scaled = c.number(path) * scale;
          scale *= denominator(scaled);
        }
  }

  FT parameter(const std::string& path) const { return from_rational<FT>(Exact_rational(c.number(path) * scale)); }
  FT unscaled(const FT& u) const { return FT(u / from_rational<FT>(scale)); }
  std::vector<FT> unscaled(const GC::Knot_vector<FT>& knots) const {
    std::vector<FT> unscaled_knots;
    for (const FT& u : knots) unscaled_knots.push_back(unscaled(u));
    return unscaled_knots;
  }
  // with respect to the given parameter
  std::vector<std::vector<FT>> rows(const GC::Curve_jet<Traits>& jet) const {
    std::vector<std::vector<FT>> rows = coordinate_rows(jet);
    FT power(1);
    for (std::vector<FT>& row : rows) {
      for (FT& x : row) x *= power;
      power *= from_rational<FT>(scale);
    }
    return rows;
  }

  Curve curve(const std::string& path = "") const {
    std::vector<FT> knots;
    for (int i = 0; i < c.length(path + "knots"); ++i) knots.push_back(parameter(path + "knots." + std::to_string(i)));
    const std::vector<typename Traits::Point> points = Input<Traits>{c}.points(path + "points");
    return Curve(points.begin(), points.end(), GC::Knot_vector<FT>(c.integer(path + "degree"), knots));
  }
  // from points with one coordinate
  GC::Bspline_function<FT> function(const std::string& path) const {
    const Curve curve = this->curve(path);
    std::vector<FT> coefficients;
    for (int i = 0; i < curve.number_of_points(); ++i) coefficients.push_back(curve.coordinates(i)[0]);
    return GC::Bspline_function<FT>(curve.knots(), coefficients);
  }
};

template <class Traits>
void report_spline(Report& report, const Spline_input<Traits>& in, const GC::Bspline_curve<Traits>& curve,
                   const typename Traits::FT& factor = typename Traits::FT(1)) {
  typedef typename Traits::FT FT;
  report.construction("degree", [&] { return curve.degree(); });
  report.construction("knots", [&] { return in.unscaled(curve.knots()); });
  report.construction("points", [&] {
    std::vector<std::vector<FT>> rows = coordinate_rows<Traits>(curve);
    for (std::vector<FT>& row : rows)
      for (FT& x : row) x *= factor;
    return rows;
  });
}

// Topic bspline.
template <class Traits> bool run_bspline(const Case& c, Report& report) {
  typedef typename Traits::FT FT;
  const Spline_input<Traits> in(c);
  // of a derivative with respect to the given parameter
  const FT factor = from_rational<FT>(in.scale);

  if (c.op == "product" && c.has("f.knots#")) {
    report_spline(report, in, product(in.function("f."), in.curve("g.")));
    return true;
  }
  if (!c.has("knots#") || !c.has("degree")) return false;
  if (c.op == "eval_jet") {
    const GC::Bspline_curve<Traits> curve = in.curve();
    const FT u = in.parameter("u");
    const GC::Curve_jet<Traits> right = curve.jet(u, c.integer("k")), left = curve.left_jet(u, c.integer("k"));
    report.construction("right", [&] { return in.rows(right); });
    report.construction("left", [&] { return in.rows(left); });
    report.construction("basis", [&] { return GC::bspline_basis(curve.knots(), u); });
  } else if (c.op == "bezier_pieces") {
    const std::vector<GC::Bezier_curve<Traits>> pieces = in.curve().bezier_pieces();
    report.construction("pieces#", [&] { return static_cast<int>(pieces.size()); });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const std::string path = "pieces." + std::to_string(i);
      report.construction(path + ".a", [&] { return in.unscaled(pieces[i].domain().first); });
      report.construction(path + ".b", [&] { return in.unscaled(pieces[i].domain().second); });
      report.construction(path + ".points", [&] { return coordinate_rows<Traits>(pieces[i]); });
    }
  } else if (c.op == "insert")
    report_spline(report, in, in.curve().insert(in.parameter("u")));
  else if (c.op == "derivative")
    report_spline(report, in, in.curve().derivative(), factor);
  else if (c.op == "elevate")
    report_spline(report, in, in.curve().elevate(c.integer("times")));
  else
    return false;
  return true;
}
