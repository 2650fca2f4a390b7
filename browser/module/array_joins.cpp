// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "array_joins.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

#include <cmath>
#include <string>
#include <utility>

namespace GC = CGAL::Geometric_continuity;

namespace {

// One of many curves of one degree in an array of doubles: each is read where it stands.
template <class Traits_> class Curve_in_array {
  const double* points_;
  int degree_;

public:
  typedef Traits_ Traits;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  static constexpr int N = GC::dimension_v<Traits>;

  Curve_in_array(const double* points, int degree) : points_(points), degree_(degree) {}
  int degree() const { return degree_; }
  std::pair<FT, FT> domain() const { return {0, 1}; }
  Point control_point(int j) const {
    const double* const x = points_ + N * j;
    if constexpr (N == 2)
      return Point(x[0], x[1]);
    else
      return Point(x[0], x[1], x[2]);
  }
};

enum class Array_question { c0, c1, c2, c3, g1, g2, g3, f3 };

template <class Curve, class Holds>
std::vector<std::uint32_t> failing(const double* points, std::size_t curves, int degree, bool closed, Holds holds) {
  const std::size_t step = static_cast<std::size_t>(degree + 1) * Curve::N;
  std::vector<std::uint32_t> result;
  const std::size_t joins = curves == 0 ? 0 : closed ? curves : curves - 1;
  for (std::size_t i = 0; i < joins; ++i)
    if (!holds(Curve(points + i * step, degree), Curve(points + (i + 1) % curves * step, degree)))
      result.push_back(static_cast<std::uint32_t>(i));
  return result;
}

template <class Traits>
std::vector<std::uint32_t> failing(const double* points, std::size_t curves, int degree, bool closed,
                                   Array_question question) {
  typedef Curve_in_array<Traits> Curve;
  const auto joins = [&](const auto& holds) { return failing<Curve>(points, curves, degree, closed, holds); };
  switch (question) {
  case Array_question::c0: return joins(GC::is_c_join<0>);
  case Array_question::c1: return joins(GC::is_c_join<1>);
  case Array_question::c2: return joins(GC::is_c_join<2>);
  case Array_question::c3: return joins(GC::is_c_join<3>);
  case Array_question::g1: return joins(GC::is_g1_join);
  case Array_question::g2: return joins(GC::is_g2_join);
  case Array_question::g3: return joins(GC::is_g3_join);
  case Array_question::f3: return joins(GC::is_f3_join);
  }
  return {};
}

std::vector<std::uint32_t> result_of_last_call;

} // namespace

template <class Traits>
struct CGAL::Geometric_continuity::Curve_ends<Curve_in_array<Traits>> : Bezier_ends<Curve_in_array<Traits>> {};

const std::vector<std::uint32_t>& failing_joins(const double* points, std::size_t curves, int degree, int dimension,
                                                int question, bool closed) {
  const std::size_t numbers = curves * static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < numbers; ++i)
    if (!std::isfinite(points[i]))
      throw GC::Error(GC::Error_code::not_finite, "failingJoins: number " + std::to_string(i) + " of the array");
  const auto q = static_cast<Array_question>(question);
  result_of_last_call = dimension == 2 ? failing<GC::Traits_2<CGAL::Epick>>(points, curves, degree, closed, q)
                                       : failing<GC::Traits_3<CGAL::Epick>>(points, curves, degree, closed, q);
  return result_of_last_call;
}

const std::vector<std::uint32_t>& last_failing_joins() { return result_of_last_call; }
