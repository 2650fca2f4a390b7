// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_PYTHON_ARRAYS_H
#define GEOMETRIC_CONTINUITY_PYTHON_ARRAYS_H

#include "geometry.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <string>
#include <type_traits>
#include <vector>

// Arrays as points and curves, and back.

// One instantiation for each number type serves all dimensions.
template <class FT> using Array_traits = GC::Traits_d<CGAL::Cartesian_d<FT>>;

// The number number i in a field.
template <class FT> FT number(const Numbers& x, std::size_t i) {
  if constexpr (std::is_same_v<FT, double>)
    return x.are_doubles() ? x.doubles[i] : nearest_double(x.exact[i]);
  else
    return x.are_doubles() ? FT(x.doubles[i]) : FT(x.exact[i]);
}

[[noreturn]] inline void refuse_shape(const std::string& place, const std::string& expected) {
  throw GC::Error(GC::Error_code::wrong_number_of_points, place + ": an array of shape " + expected + " is needed");
}

// The rows of an array of shape (number, dimension).
template <class Traits> std::vector<typename Traits::Point> points(const Numbers& x, const std::string& place) {
  typedef typename Traits::FT FT;
  if (x.shape.size() != 2 || x.shape[1] == 0) refuse_shape(place, "(points, dimension)");
  const int d = static_cast<int>(x.shape[1]);
  if (GC::dimension_v<Traits> != 0 && GC::dimension_v<Traits> != d)
    throw GC::Error(GC::Error_code::dimension_mismatch, place);
  std::vector<typename Traits::Point> result;
  for (std::size_t j = 0; j < x.shape[0]; ++j) {
    GC::Work_scope::pause();
    GC::Coordinates<Traits> c(d);
    for (int i = 0; i < d; ++i) c[i] = number<FT>(x, j * d + i);
    result.push_back(GC::to_point<Traits>(c));
  }
  return result;
}

template <class Traits> GC::Bezier_curve<Traits> curve(const Numbers& x, const std::string& place) {
  return GC::Bezier_curve<Traits>(points<Traits>(x, place));
}

// Numbers of a field as an array.
template <class FT> class Array_writer {
  Numbers numbers_;

public:
  explicit Array_writer(std::vector<std::size_t> shape) {
    numbers_.shape = std::move(shape);
    numbers_.rounded = std::is_same_v<FT, double>;
  }
  void add(const FT& x) {
    if constexpr (std::is_same_v<FT, double>)
      numbers_.doubles.push_back(x);
    else
      numbers_.exact.push_back(x);
  }
  Numbers get() { return std::move(numbers_); }
};

// The control points of a curve, of a range of points.
template <class Traits, class Curve> Numbers array_of(const Curve& curve) {
  Array_writer<typename Traits::FT> writer({static_cast<std::size_t>(std::distance(curve.begin(), curve.end())),
                                            static_cast<std::size_t>(curve.dimension())});
  for (const auto& p : curve)
    for (const auto& x : GC::coordinates<Traits>(p)) writer.add(x);
  return writer.get();
}

template <class Range, class FT = std::decay_t<decltype(*std::declval<Range>().begin())>>
Numbers array_of_numbers(const Range& numbers) {
  Array_writer<FT> writer({numbers.size()});
  for (const FT& x : numbers) writer.add(x);
  return writer.get();
}

#endif // GEOMETRIC_CONTINUITY_PYTHON_ARRAYS_H
