// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Dimension.h>

#include <array>

// The least traits class over a number type.
template <class Number> struct Plain_traits {
  typedef Number FT;
  typedef CGAL::Dimension_tag<2> Dimension;
  struct Point {
    std::array<FT, 2> x;
  };
  struct Vector {
    std::array<FT, 2> x;
  };
  template <class Result> struct Construct {
    template <class Iterator> Result operator()(int, Iterator x, Iterator) const { return {{x[0], x[1]}}; }
  };
  struct Compute_dimension {
    template <class T> int operator()(const T&) const { return 2; }
  };
  struct Compute_coordinate {
    template <class T> FT operator()(const T& p, int i) const { return p.x[i]; }
  };
  Compute_dimension compute_dimension_object() const { return {}; }
  Compute_coordinate compute_coordinate_object() const { return {}; }
  Construct<Point> construct_point_object() const { return {}; }
  Construct<Vector> construct_vector_object() const { return {}; }
};
