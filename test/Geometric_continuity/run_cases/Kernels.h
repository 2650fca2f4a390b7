// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "Case.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/number_utils.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
using CGAL::Exact_rational;

// The traits classes of one kernel family: dimension 2, 3, and d.
template <class K, class Kernel_d> struct Kernels {
  typedef typename K::FT FT;
  typedef GC::Traits_2<K> Traits2;
  typedef GC::Traits_3<K> Traits3;
  typedef GC::Traits_d<Kernel_d> Traitsd;
};

// A number of a case in the field of the kernel: exact, or the nearest double, or an enclosing
// interval.
template <class FT> FT from_rational(const Exact_rational& x) {
  if constexpr (std::is_same_v<FT, CGAL::Interval_nt<>>)
    return FT(CGAL::to_interval(x));
  else if constexpr (std::is_floating_point_v<FT>)
    return CGAL::to_double(x);
  else
    return FT(x);
}

inline Exact_rational denominator(const Exact_rational& x) {
  CGAL::Fraction_traits<Exact_rational>::Numerator_type p;
  CGAL::Fraction_traits<Exact_rational>::Denominator_type q;
  CGAL::Fraction_traits<Exact_rational>::Decompose()(x, p, q);
  return Exact_rational(q);
}

// f(value) for the value of this name. Returns whether there is one.
template <class Function, class... Value>
bool with_choice(const std::string& name, Function f, const std::pair<const char*, Value>&... choice) {
  return ((name == choice.first && (f(choice.second), true)) || ...);
}

// Input of a case in the types of a traits class.
template <class Traits> struct Input {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef GC::Bezier_curve<Traits> Curve;
  typedef GC::Curve_jet<Traits> Jet;

  const Case& c;

  FT number(const std::string& path) const { return from_rational<FT>(c.number(path)); }
  std::vector<FT> numbers(const std::string& path) const { return convert(c.numbers(path)); }

  std::vector<Point> points(const std::string& path) const {
    std::vector<Point> points;
    for (const std::vector<Exact_rational>& row : c.rows(path)) points.push_back(point(convert(row)));
    return points;
  }
  Curve curve(const std::string& path, const FT& a = FT(0), const FT& b = FT(1)) const {
    const std::vector<Point> p = points(path);
    return Curve(p.begin(), p.end(), a, b);
  }
  Jet jet(const std::string& path) const {
    const std::vector<std::vector<Exact_rational>> rows = c.rows(path);
    std::vector<Vector> derivatives;
    for (std::size_t j = 1; j < rows.size(); ++j) {
      const std::vector<FT> x = convert(rows[j]);
      derivatives.push_back(Traits().construct_vector_object()(static_cast<int>(x.size()), x.begin(), x.end()));
    }
    return Jet(point(convert(rows.at(0))), derivatives);
  }

  static std::vector<FT> convert(const std::vector<Exact_rational>& row) {
    std::vector<FT> x;
    for (const Exact_rational& r : row) x.push_back(from_rational<FT>(r));
    return x;
  }
  static Point point(const std::vector<FT>& x) {
    return Traits().construct_point_object()(static_cast<int>(x.size()), x.begin(), x.end());
  }
};

// Coordinates of points and vectors, for the report.
template <class Traits, class Point_or_vector> std::vector<typename Traits::FT> coordinates(const Point_or_vector& p) {
  const Traits traits;
  std::vector<typename Traits::FT> x;
  for (int i = 0; i < traits.compute_dimension_object()(p); ++i) x.push_back(traits.compute_coordinate_object()(p, i));
  return x;
}

template <class Traits, class Range>
std::vector<std::vector<typename Traits::FT>> coordinate_rows(const Range& points) {
  std::vector<std::vector<typename Traits::FT>> rows;
  for (const typename Traits::Point& p : points) rows.push_back(coordinates<Traits>(p));
  return rows;
}

template <class Traits>
std::vector<std::vector<typename Traits::FT>> coordinate_rows(const GC::Curve_jet<Traits>& jet) {
  std::vector<std::vector<typename Traits::FT>> rows(1, coordinates<Traits>(jet.point()));
  for (int j = 1; j <= jet.order(); ++j) rows.push_back(coordinates<Traits>(jet.derivative(j)));
  return rows;
}
