// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DISTINCT_KNOTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DISTINCT_KNOTS_H

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>

#include <cstddef>
#include <stdexcept>
#include <vector>

// The different knots, and how often each is repeated.
struct Distinct_knots {
  std::vector<double> values;
  std::vector<int> multiplicities;

  Distinct_knots(int degree, const std::vector<double>& all) {
    for (const double x : all) {
      if (!values.empty() && values.back() == x)
        ++multiplicities.back();
      else {
        values.push_back(x);
        multiplicities.push_back(1);
      }
    }
    for (std::size_t i = 1; i + 1 < values.size(); ++i)
      if (multiplicities[i] > degree) throw std::runtime_error("a CAD model holds no spline that may jump at a knot");
  }
  TColStd_Array1OfReal knots() const {
    return TColStd_Array1OfReal(values.front(), 1, static_cast<int>(values.size()));
  }
  TColStd_Array1OfInteger counts() const {
    return TColStd_Array1OfInteger(multiplicities.front(), 1, static_cast<int>(multiplicities.size()));
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_DISTINCT_KNOTS_H
