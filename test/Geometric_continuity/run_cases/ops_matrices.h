// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Kernels.h"
#include "Report.h"

#include <array>

// f(basis) for the basis of this name
template <class Function> bool with_basis(const std::string& name, Function f) {
  return with_choice(name, f, std::pair("hermite", GC::Hermite_basis()), std::pair("bezier", GC::Bezier_basis()),
                     std::pair("catmull_rom", GC::Catmull_rom_basis()),
                     std::pair("bspline", GC::Uniform_bspline_basis()));
}

template <class Traits> void read_geometry(const Input<Traits>& in, std::array<typename Traits::Point, 4>& geometry) {
  const std::vector<typename Traits::Point> p = in.points("G");
  std::copy_n(p.begin(), 4, geometry.begin());
}
template <class Traits> void read_geometry(const Input<Traits>& in, GC::Hermite_geometry<Traits>& geometry) {
  const GC::Curve_jet<Traits> columns = in.jet("G"); // vectors but for the first
  const std::vector<typename Traits::Point> points = in.points("G");
  geometry = {points.at(0), points.at(1), columns.derivative(2), columns.derivative(3)};
}

template <class Traits>
std::vector<std::vector<typename Traits::FT>> geometry_rows(const std::array<typename Traits::Point, 4>& geometry) {
  return coordinate_rows<Traits>(geometry);
}
template <class Traits>
std::vector<std::vector<typename Traits::FT>> geometry_rows(const GC::Hermite_geometry<Traits>& geometry) {
  return {coordinates<Traits>(geometry.p1), coordinates<Traits>(geometry.p4), coordinates<Traits>(geometry.r1),
          coordinates<Traits>(geometry.r4)};
}

template <class Traits, class Basis> GC::Cubic_blended_curve<Traits, Basis> blended_curve(const Input<Traits>& in) {
  typename Basis::template Geometry<Traits> geometry;
  read_geometry(in, geometry);
  return GC::Cubic_blended_curve<Traits, Basis>(geometry);
}

// Topic matrices.
template <class Traits> bool run_matrices(const Case& c, Report& report) {
  const Input<Traits> in{c};
  if (c.op == "eval")
    return with_basis(c.text("basis"), [&](const auto& basis) {
      typedef std::decay_t<decltype(basis)> Basis;
      const int k = c.integer("k");
      report.construction("value", [&] {
        const GC::Curve_jet<Traits> jet = blended_curve<Traits, Basis>(in).jet(in.number("t"), k);
        return k == 0 ? coordinates<Traits>(jet.point()) : coordinates<Traits>(jet.derivative(k));
      });
    });
  if (c.op == "convert")
    return with_basis(c.text("from"), [&](const auto& from) {
      typedef std::decay_t<decltype(from)> From;
      with_basis(c.text("to"), [&](const auto& to) {
        report.construction(
            "G", [&] { return geometry_rows<Traits>(blended_curve<Traits, From>(in).in_basis(to).geometry()); });
      });
    });
  return false;
}

// The operation of the topic that has no dimension.
template <class FT> bool run_basis_matrix(const Case& c, Report& report) {
  if (c.op != "matrix") return false;
  const auto put = [&](const GC::Basis_matrix<FT>& m) {
    report.construction("M", [&] {
      std::vector<std::vector<FT>> rows(4);
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) rows[i].push_back(m(i, j));
      return rows;
    });
  };
  if (c.text("basis") == "hermite_from_bezier") {
    put(GC::hermite_from_bezier_matrix<FT>());
    return true;
  }
  return with_basis(c.text("basis"), [&](const auto& basis) { put(basis.template matrix<FT>()); });
}
