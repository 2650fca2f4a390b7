// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Defines a traits class for points of your own, here plain arrays with one dimension for time.
// Curves in space-time are blended without conversion to points of a CGAL kernel.

#include <CGAL/Dimension.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace GC = CGAL::Geometric_continuity;

struct Event {
  std::array<CGAL::Exact_rational, 4> x; // x, y, z, time
};
struct Displacement {
  std::array<CGAL::Exact_rational, 4> x;
};

struct Space_time_traits {
  typedef CGAL::Exact_rational FT;
  typedef Event Point;
  typedef Displacement Vector;
  typedef CGAL::Dimension_tag<4> Dimension;

  struct Compute_dimension {
    int operator()(const Point&) const { return 4; }
    int operator()(const Vector&) const { return 4; }
  };
  struct Compute_coordinate {
    FT operator()(const Point& p, int i) const { return p.x[i]; }
    FT operator()(const Vector& v, int i) const { return v.x[i]; }
  };
  template <class T> struct Construct {
    template <class Iterator> T operator()(int, Iterator first, Iterator last) const {
      T t;
      std::copy(first, last, t.x.begin());
      return t;
    }
  };
  typedef Construct<Point> Construct_point;
  typedef Construct<Vector> Construct_vector;

  Compute_dimension compute_dimension_object() const { return {}; }
  Compute_coordinate compute_coordinate_object() const { return {}; }
  Construct_point construct_point_object() const { return {}; }
  Construct_vector construct_vector_object() const { return {}; }
};

int main() {
  typedef GC::Bezier_curve<Space_time_traits> Curve;
  const Curve phi{Event{{0, 0, 0, 0}}, Event{{1, 0, 0, 1}}, Event{{2, 1, 0, 2}}, Event{{3, 1, 1, 3}}};
  const Curve psi{Event{{6, 2, 1, 6}}, Event{{7, 2, 0, 7}}, Event{{8, 3, 0, 8}}};
  const GC::Quintic_blend<Space_time_traits> gamma = GC::blend(phi, psi);
  const auto start = GC::continuity(phi, gamma), end = GC::continuity(gamma, psi);
  std::cout << gamma << '\n' << "start: " << start << "\nend:   " << end << '\n';
  return start.g_order >= 2 && end.g_order >= 2 ? 0 : 1;
}
