// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "random.h"

#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

// Segmented curves of whole and random numbers. Rounded kernels run the same tests as exact ones,
// on dyadic numbers where every intermediate result is a double.

typedef std::tuple<Exact_2, Exact_3, Exact_d, Double_2, Double_3, Double_d, Epick_3> All_traits;

template <class Traits> using Composite = GC::Composite_bezier_curve<Traits>;
template <class Traits> using Bezier = GC::Bezier_curve<Traits>;
template <class Traits> using Column = GC::Coordinates<Traits>;
typedef GC::Continuity_kind Kind;

template <class Traits> constexpr int test_dimension = Bezier<Traits>::N == 0 ? 4 : Bezier<Traits>::N;
template <class Traits> constexpr bool is_exact = !std::is_floating_point_v<typename Traits::FT>;

template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

template <class Traits> typename Traits::Point point(std::initializer_list<int> x) {
  Column<Traits> c(test_dimension<Traits>);
  int i = 0;
  for (int value : x)
    if (i < c.dimension()) c[i++] = typename Traits::FT(value);
  return GC::to_point<Traits>(c);
}

template <class Traits>
std::vector<typename Traits::Point> points(std::initializer_list<std::initializer_list<int>> rows) {
  std::vector<typename Traits::Point> result;
  for (const std::initializer_list<int>& row : rows) result.push_back(point<Traits>(row));
  return result;
}

template <class FT> std::vector<FT> numbers(std::initializer_list<int> x) {
  std::vector<FT> result;
  for (int value : x) result.push_back(FT(value));
  return result;
}

template <class Traits>
Composite<Traits> composite(std::initializer_list<std::initializer_list<int>> rows, std::initializer_list<int> knots) {
  const std::vector<typename Traits::Point> b = points<Traits>(rows);
  return Composite<Traits>(b.begin(), b.end(), numbers<typename Traits::FT>(knots));
}

class Random : public Random_integers<> {
public:
  // a rational number, or a small multiple of 1/4
  template <class FT> FT number() {
    return std::is_floating_point_v<FT> ? ratio<FT>(integer(-8, 8), 4) : fraction_of<FT>(-99, 99, 1, 99);
  }
  // a rational number in (0, 1), or a multiple of 1/8
  template <class FT> FT fraction() {
    const int q = std::is_floating_point_v<FT> ? 8 : integer(2, 99);
    return ratio<FT>(integer(1, q - 1), q);
  }
  // positive, or a power of 2
  template <class FT> FT length() {
    return std::is_floating_point_v<FT> ? ratio<FT>(1 << integer(0, 3), 4) : fraction_of<FT>(1, 99, 1, 99);
  }
  template <class Traits> Column<Traits> column() {
    Column<Traits> c(test_dimension<Traits>);
    for (int i = 0; i < c.dimension(); ++i) c[i] = number<typename Traits::FT>();
    return c;
  }
  template <class Traits> Composite<Traits> curve(int degree, int segments, bool closed = false) {
    typedef typename Traits::FT FT;
    std::vector<typename Traits::Point> b;
    for (int i = 0; i <= degree * segments; ++i) b.push_back(GC::to_point<Traits>(column<Traits>()));
    if (closed) b.back() = b.front();
    std::vector<FT> knots(1, number<FT>());
    for (int l = 0; l < segments; ++l) knots.push_back(FT(knots.back() + length<FT>()));
    return Composite<Traits>(b.begin(), b.end(), knots);
  }
};

template <class Traits> Column<Traits> column(const typename Traits::Point& p) { return GC::coordinates<Traits>(p); }

// a parameter of the l-th segment
template <class Traits> typename Traits::FT inside(const Composite<Traits>& c, int l, const typename Traits::FT& t) {
  return typename Traits::FT(c.knots()[l] + t * c.lambda(l));
}

// both are the same function on the segments of c
template <class Traits> bool same_function(const Composite<Traits>& c, const Composite<Traits>& d, Random& random) {
  typedef typename Traits::FT FT;
  for (int l = 0; l < c.number_of_segments(); ++l)
    for (int i = 0; i < 3; ++i) {
      const FT u = inside<Traits>(c, l, random.fraction<FT>());
      if (c.jet(u, 3) != d.jet(u, 3)) return false;
    }
  return true;
}
