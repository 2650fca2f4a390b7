// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tessellation with exact numbers: points are summed as integers and diagonals compared by
// intervals, and neither is seen.

#include "support/net_of.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/boost_mp.h>

BOOST_AUTO_TEST_SUITE(exact_tessellation)

typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Rational_kernel;
typedef std::tuple<Rational_kernel, CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>, CGAL::Epeck> Kernels;

// Fractions whose denominators have common divisors, or none, or are large.
template <class FT> class Random_fractions : public Random_integers<> {
public:
  FT fraction(int least, int most) {
    constexpr int denominators[] = {1, 2, 3, 4, 5, 6, 7, 10, 49, 1000, 1 << 20, 1000003, 1000000007};
    FT x = FT(integer(least, most)) + FT(integer(0, 1 << 20)) / FT(denominators[integer(0, 12)]);
    // more than a word
    if (integer(0, 9) == 0) x = FT(x / FT(denominators[12])) / FT(denominators[11]);
    return x;
  }
};

template <class K> auto random_net(Random_fractions<typename K::FT>& random, int p, int q) {
  return net_of(p + 1, q + 1, [&](int, int) {
    const typename K::FT x = random.fraction(-5, 5), y = random.fraction(-5, 5), z = random.fraction(-5, 5);
    return typename K::Point_3(x, y, z);
  });
}

// Each point is the point of the patch at its place, and no place comes twice.
template <class Patch> void check_points(const Patch& patch, int n) {
  const auto mesh = GC::tessellate(patch, GC::Uniform_grid{n});
  const std::size_t expected = static_cast<std::size_t>(n + 1) * (n + 1);
  BOOST_REQUIRE_GE(mesh.points.size(), expected);
  BOOST_REQUIRE_EQUAL(mesh.points.size(), mesh.places.size());
  std::set<std::pair<typename Patch::FT, typename Patch::FT>> places;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    BOOST_CHECK(mesh.points[i] == patch(mesh.places[i].u, mesh.places[i].v));
    places.emplace(mesh.places[i].u, mesh.places[i].v);
  }
  BOOST_CHECK_EQUAL(places.size(), mesh.points.size());
  BOOST_CHECK_EQUAL(mesh.triangles.size(), 2u * n * n);
}

TEST_FOR_EACH(points_of_patches, K, Kernels) {
  Random_fractions<FT> random;
  for (int n = 1; n <= 7; ++n) BOOST_TEST_CONTEXT("seed " << first_seed() << ", " << n << " cells") {
      const int p = random.integer(1, 4), q = random.integer(1, 4);
      const FT a = random.fraction(-2, 0), b = random.fraction(0, 0);
      const GC::Bezier_patch<GC::Traits_3<K>> patch(random_net<K>(random, p, q), {a, FT(a + FT(2) / FT(3))},
                                                    {b, FT(b + FT(5) / FT(7))});
      check_points(patch, n);
    }
}

TEST_FOR_EACH(points_of_rational_patches, K, Kernels) {
  Random_fractions<FT> random;
  for (int n = 1; n <= 7; ++n) BOOST_TEST_CONTEXT("seed " << first_seed() << ", " << n << " cells") {
      const int p = random.integer(1, 3), q = random.integer(1, 3);
      const auto weights = net_of(p + 1, q + 1, [&](int, int) { return random.fraction(1, 3); });
      check_points(GC::Rational_bezier_patch<GC::Traits_3<K>>(random_net<K>(random, p, q), weights), n);
    }
  // the denominator is positive although a weight is not
  const std::vector<std::vector<FT>> weights{{FT(1), FT(2)}, {FT(-1) / FT(3), FT(1)}, {FT(1), FT(1)}};
  check_points(GC::Rational_bezier_patch<GC::Traits_3<K>>(random_net<K>(random, 2, 1), weights), 4);
}

// The triangles of a cell have its shorter diagonal in common; if both are equal, that from the
// corner where the parameters are least. Floating-point numbers do not tell which it is.
TEST_FOR_EACH(shorter_diagonals, K, Kernels) {
  typedef typename K::Point_3 Point;
  FT tiny(1);
  for (int i = 0; i < 100; ++i) tiny = FT(tiny / FT(2));
  const FT third = FT(FT(1) / FT(3));
  for (const FT& e : {FT(-1), FT(-tiny), FT(0), FT(tiny), FT(1)})
    for (int n : {1, 3}) {
      // an affine image of the square, so that all cells are alike
      const Point a(third, 0, third), b(third + FT(6), e, third), c(third + e, 6, third),
          d(third + FT(6) + e, 6 + e, third);
      const GC::Bezier_patch<GC::Traits_3<K>> patch{{a, c}, {b, d}};
      const auto mesh = GC::tessellate(patch, GC::Uniform_grid{n});
      const bool rising = !(FT(0) < e); // the diagonal from a towards d
      std::size_t corner_cells = 0;
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        // of a triangle, the two corners of which both parameters are different
        int diagonals = 0;
        for (int k = 0; k < 3; ++k) {
          const auto &p = mesh.places[mesh.triangles[i][k]], &q = mesh.places[mesh.triangles[i][(k + 1) % 3]];
          if (p.u == q.u || p.v == q.v) continue;
          ++diagonals;
          if (n == 1) BOOST_CHECK_EQUAL((p.u < q.u) == (p.v < q.v), rising);
          // inside of the patch; at its corners the triangles stay off its edges
          const auto inside = [](const FT& x) { return FT(1) / FT(3) <= x && x <= FT(2) / FT(3); };
          if (n == 3 && inside(p.u) && inside(p.v) && inside(q.u) && inside(q.v)) {
            BOOST_CHECK_EQUAL((p.u < q.u) == (p.v < q.v), rising);
            ++corner_cells;
          }
        }
        BOOST_CHECK_EQUAL(diagonals, 1);
      }
      BOOST_CHECK_EQUAL(corner_cells, n == 3 ? 2u : 0u);
    }
}

// Numbers that are exact as floating-point numbers, too: the triangles do not depend on the number
// type.
BOOST_AUTO_TEST_CASE(triangles_of_all_numbers) {
  typedef CGAL::Simple_cartesian<double> Double;
  Random_fractions<double> random;
  std::vector<GC::Bezier_patch<GC::Traits_3<Double>>> rounded;
  std::vector<GC::Bezier_patch<GC::Traits_3<Rational_kernel>>> exact;
  for (int i = 0; i < 10; ++i) {
    rounded.emplace_back(net_of(4, 4, [&](int, int) {
      const int x = random.integer(-9, 9), y = random.integer(-9, 9), z = random.integer(-9, 9);
      return Double::Point_3(x, y, z);
    }));
    exact.push_back(surface_exactly<GC::Traits_3<Rational_kernel>>(rounded.back()));
  }
  for (double tolerance : {1.0, 0.1, 0.01}) {
    const auto a = GC::tessellate(rounded, GC::Chord_tolerance{tolerance});
    const auto b = GC::tessellate(exact, GC::Chord_tolerance{tolerance});
    BOOST_CHECK(a.triangles == b.triangles);
    BOOST_REQUIRE_EQUAL(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i)
      BOOST_CHECK(b.points[i] == point_exactly<GC::Traits_3<Rational_kernel>>(a.points[i]));
  }
}

BOOST_AUTO_TEST_SUITE_END()
