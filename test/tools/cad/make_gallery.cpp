// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes three STEP files, with OpenCASCADE, to the current folder: demo/Geometric_continuity/data
// has them. In each of them a plane face and a spline face meet along the edge from (0, 0, 0) to
// (100, 0, 0): z = 0 for y <= 0, and z = y s(x) for y >= 0. So there is no gap, and at x the angle
// of the normals is arctan |s(x)|. The slope s is a quadratic spline, in C1. It vanishes where
// OpenCASCADE takes its 21 samples, at x = 1 + 4.9 i, but not between them.

#include "write_model.h"

namespace {

constexpr double length = 100, width = 10;

// The surface z = y s(x), where s has these knots, which include both ends, and these coefficients:
// one for the mean of each two neighbours among the knots, ends counted twice.
Handle(Geom_BSplineSurface) twisted_strip(const std::vector<double>& knots, const std::vector<double>& slopes) {
  const int n = static_cast<int>(knots.size());
  TColStd_Array1OfReal u(1, n), v(1, 2);
  TColStd_Array1OfInteger u_multiplicities(1, n), v_multiplicities(1, 2);
  TColgp_Array2OfPnt poles(1, n + 1, 1, 2);
  for (int i = 1; i <= n; ++i) {
    u(i) = knots[static_cast<std::size_t>(i - 1)];
    u_multiplicities(i) = i == 1 || i == n ? 3 : 1;
  }
  v(1) = 0;
  v(2) = width;
  v_multiplicities.Init(2);
  for (int i = 1; i <= n + 1; ++i) {
    const double x = i == 1 ? u(1) : i == n + 1 ? u(n) : (u(i - 1) + u(i)) / 2;
    poles(i, 1) = gp_Pnt(x, 0, 0);
    poles(i, 2) = gp_Pnt(x, width, width * slopes[static_cast<std::size_t>(i - 1)]);
  }
  return new Geom_BSplineSurface(poles, u, v, u_multiplicities, v_multiplicities, 2, 1);
}

void write(const std::string& file, const std::vector<double>& knots, const std::vector<double>& slopes) {
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(BRepBuilderAPI_MakeFace(gp_Pln(), 0, length, -width, 0).Face());
  sewing.Add(BRepBuilderAPI_MakeFace(twisted_strip(knots, slopes), 1e-7).Face());
  sewing.Perform();
  require(sewing.NbContigousEdges() == 1, file);
  write(sewing.SewedShape(), file);
}

} // namespace

int main() {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  write("defect_at_end.step", {0, 99.25, length}, {0, 0, 0, 0.05}); // behind the last sample, at 99
  write("defect_between_samples.step", {0, 51, 52, 53, 54, length},
        {0, 0, 0, 0.05, 0, 0, 0}); // between those at 50 and 54.9
  // With coefficients of alternating sign that are proportional to the distances of the knots, s
  // vanishes at the knots: at the samples.
  std::vector<double> knots{0}, slopes{0};
  for (int i = 0; i <= 20; ++i) knots.push_back((10 + 49 * i) / 10.);
  knots.push_back(length);
  for (std::size_t i = 1; i < knots.size(); ++i)
    slopes.push_back((i % 2 == 0 ? 0.01 : -0.01) * (knots[i] - knots[i - 1]));
  slopes.push_back(0);
  write("defect_in_step_with_samples.step", knots, slopes);
}
