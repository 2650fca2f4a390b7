// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The Bernstein coefficients of the spans: from differences of rational numbers, against refinement
// by blossoms; of high degree; and within a limit of the work.

#include "support/limited.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <boost/multiprecision/cpp_int.hpp>

BOOST_AUTO_TEST_SUITE(bspline_pieces)

struct Random : Random_integers<> {
  template <class FT> FT fraction(int size) { return FT(FT(integer(-size, size)) / FT(integer(1, 7))); }
};

// Knots of any multiplicity, clamped at no end, at one or at both.
template <class FT> std::vector<FT> random_knots(Random& random, int degree) {
  std::vector<FT> u;
  FT x(0);
  const auto append = [&](int times) {
    x = FT(x + FT(random.integer(1, 9)) / FT(random.integer(1, 5)));
    u.insert(u.end(), times, x);
  };
  for (int ends = 0; ends < 2; ++ends) {
    if (random.integer(0, 1) == 0)
      append(degree + 1);
    else
      for (int i = 0; i <= degree; ++i) append(1);
    if (ends == 0)
      for (int inner = random.integer(0, 5); inner > 0; --inner)
        append(random.integer(0, 2) == 0 ? random.integer(1, degree + 1) : 1);
  }
  return u;
}

// Long and short numbers, of which neighbours have common factors, and some are equal.
template <class FT> FT mixed_number(Random& random) {
  const int factors = random.integer(0, 9);
  FT x(random.integer(-99, 99)), y(1);
  for (int i = 0; i < factors; ++i) {
    x *= FT(random.integer(1, 1000000));
    y *= FT(random.integer(0, 1) == 0 ? 6 : random.integer(1, 1000000));
  }
  return FT(x / y);
}

// Uniform inner knots, as many as the degree and one more.
template <class FT> GC::Knot_vector<FT> uniform(int degree) {
  std::vector<typename GC::Knot_vector<FT>::Knot> inner;
  for (int i = 1; i <= degree + 1; ++i) inner.push_back({FT(i), 1});
  return GC::Knot_vector<FT>(degree, FT(0), FT(degree + 2), inner);
}

typedef boost::mpl::list<Q, boost::multiprecision::cpp_rational> Rational_numbers;

BOOST_AUTO_TEST_CASE_TEMPLATE(pieces_are_those_of_refinement, FT, Rational_numbers) {
  Random random;
  for (int k = 0; k < 200; ++k) {
    const int p = random.integer(0, 6);
    const GC::Knot_vector<FT> knots(p, random_knots<FT>(random, p));
    std::vector<GC::Coordinate_vector<FT, 2>> c(knots.number_of_coefficients());
    std::vector<double> rounded_knots, rounded;
    double size = 1;
    for (const FT& u : knots) rounded_knots.push_back(CGAL::to_double(u));
    for (auto& x : c) {
      for (int i = 0; i < 2; ++i) x[i] = k % 2 == 0 ? random.fraction<FT>(99) : mixed_number<FT>(random);
      rounded.push_back(CGAL::to_double(x[0]));
      size = (std::max)(size, std::abs(rounded.back()));
    }
    const auto pieces = GC::bspline_bezier(knots, c);
    BOOST_CHECK_MESSAGE(pieces == GC::bspline_refine(knots, c, knots.bezier(p)),
                        "spline " << k << ", seed " << random.seed);
    const std::vector<double> near = GC::bspline_bezier(GC::Knot_vector<double>(p, rounded_knots), rounded);
    BOOST_REQUIRE_EQUAL(near.size(), pieces.size());
    for (std::size_t i = 0; i < near.size(); ++i)
      BOOST_CHECK_SMALL(near[i] - CGAL::to_double(pieces[i][0]), 1e-9 * size);
  }
}

BOOST_AUTO_TEST_CASE(pieces_of_high_degree) {
  Random random;
  const int p = 63;
  const GC::Knot_vector<Q> knots = uniform<Q>(p);
  std::vector<Q> c;
  while (static_cast<int>(c.size()) < knots.number_of_coefficients()) c.push_back(Q(random.integer(-99, 99)));
  const std::vector<Q> pieces = GC::bspline_bezier(knots, c);
  BOOST_REQUIRE_EQUAL(pieces.size(), static_cast<std::size_t>((p + 2) * (p + 1)));
  // C^(p-1): differences of neighbours agree, as the spans are of one length, and only the last
  // does not
  for (int s = 0; s <= p; ++s) {
    std::vector<Q> left(pieces.begin() + s * (p + 1), pieces.begin() + (s + 1) * (p + 1)),
        right(pieces.begin() + (s + 1) * (p + 1), pieces.begin() + (s + 2) * (p + 1));
    for (int j = 0; j <= p; ++j) {
      BOOST_CHECK_EQUAL(left[p - j] == right[0], j < p);
      for (int i = 0; i < p - j; ++i) {
        left[i] = left[i + 1] - left[i];
        right[i] = right[i + 1] - right[i];
      }
    }
  }
  CHECK_ERROR(limited(GC::Work_limit(1), [&] { return GC::bspline_bezier(knots, c); }), work_limit);
  CHECK_ERROR(limited(GC::Work_limit(1000000), [&] { return GC::bspline_bezier(knots, c); }), work_limit);
}

BOOST_AUTO_TEST_SUITE_END()
