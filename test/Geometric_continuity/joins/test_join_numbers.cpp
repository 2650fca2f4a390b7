// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// continuity() where numbers are tiny or huge, in high dimensions, and without memory from the
// heap.

#define BOOST_TEST_MODULE join_numbers

#include "support/allocations.h"
#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>

// ---------------------------------------------------------------- tiny and huge numbers

// The two halves of a cubic, which join with C3, G3 and F3, at another scale and on other domains.
template <class Traits> struct Halves {
  GC::Bezier_curve<Traits> left, right;

  Halves(double scale, double first, double second)
      : left(curve({{0, 0, 0}, {4, 0, 0}, {6, 2, 0}, {7, 4, 1}}, scale, first)),
        right(curve({{7, 4, 1}, {8, 6, 2}, {8, 8, 4}, {8, 8, 8}}, scale, second)) {}

  static GC::Bezier_curve<Traits> curve(const std::vector<std::vector<double>>& rows, double scale, double length) {
    std::vector<typename Traits::Point> points;
    for (const std::vector<double>& x : rows) points.emplace_back(x[0] * scale, x[1] * scale, x[2] * scale);
    return GC::Bezier_curve<Traits>(points.begin(), points.end(), 0, length);
  }
};

// Powers of two change nothing but what they must.
BOOST_AUTO_TEST_CASE(powers_of_two) {
  for (const int e : {-500, -254, -100, 0, 100, 254, 500}) {
    const Halves<Double_3> same(std::ldexp(1, e), 1, 1);
    const GC::Join_continuity<double> join = GC::continuity(same.left, same.right);
    BOOST_CHECK_EQUAL(join.c_order, 3);
    BOOST_CHECK_EQUAL(join.g_order, 3);
    BOOST_CHECK_EQUAL(join.f_order, 3);
    BOOST_CHECK(join.betas() == (std::vector<double>{1, 0, 0}));
    BOOST_CHECK(join.regular && *join.tangent_equal && *join.curvature_equal && *join.curvature_vector_equal &&
                *join.torsion_equal);
    for (const int f : {-100, -40, 40, 100}) {
      const Halves<Double_3> slow(std::ldexp(1, e), 1, std::ldexp(1, f));
      const GC::Join_continuity<double> other = GC::continuity(slow.left, slow.right);
      BOOST_CHECK_EQUAL(other.c_order, 0);
      BOOST_CHECK_EQUAL(other.g_order, 3);
      BOOST_CHECK_EQUAL(other.f_order, 3);
      BOOST_CHECK(other.betas() == (std::vector<double>{std::ldexp(1, -f), 0, 0}));
    }
    // a curvature that differs is seen at every scale
    Halves<Double_3> bent(std::ldexp(1, e), 1, 1);
    std::vector<Double_3::Point> p(bent.right.begin(), bent.right.end());
    p[2] = Double_3::Point(p[2].x(), p[2].y(), p[2].z() * 2);
    const GC::Join_continuity<double> broken =
        GC::continuity(bent.left, GC::Bezier_curve<Double_3>(p.begin(), p.end()));
    BOOST_CHECK_EQUAL(broken.c_order, 1);
    BOOST_CHECK_EQUAL(broken.g_order, 1);
    BOOST_CHECK(!*broken.curvature_equal && !*broken.torsion_equal);
  }
}

// Decimal scales round the points: whatever is decided, no number is undefined.
BOOST_AUTO_TEST_CASE(powers_of_ten) {
  for (const double scale : {1e-300, 1e-150, 1e-80, 1e80, 1e150, 1e300}) {
    const Halves<Double_3> halves(scale, 1, 1);
    const GC::Join_continuity<double> join = GC::continuity(halves.left, halves.right);
    BOOST_CHECK(join.regular && join.curvature_equal && join.curvature_vector_equal && join.torsion_equal);
    for (const double beta : join.betas()) BOOST_CHECK(std::isfinite(beta));
    // straight lines, which are exact: G3
    const Double_3::Point a(0, 0, 0), b(scale, 0, 0), c(2 * scale, 0, 0);
    const GC::Join_continuity<double> line =
        GC::continuity(GC::Bezier_curve<Double_3>{a, b}, GC::Bezier_curve<Double_3>{b, c});
    BOOST_CHECK_EQUAL(line.g_order, 3);
    BOOST_CHECK(line.betas() == (std::vector<double>{1, 0, 0}));
    const Halves<Epick_3> exact(scale, 1, 1);
    BOOST_CHECK(GC::continuity(exact.left, exact.right).regular);
  }
}

// Joins that exceed the range of the numbers are refused.
BOOST_AUTO_TEST_CASE(overflow) {
  const Halves<Double_3> fast(1, 1, 0x1p-400);
  CHECK_ERROR(GC::continuity(fast.left, fast.right), not_finite); // the third derivative
  const GC::Bezier_curve<Double_3> left = Halves<Double_3>::curve({{0, 0, 0}, {1, 0, 0}}, 0x1p-600, 1),
                                   right = Halves<Double_3>::curve({{0x1p-600, 0, 0}, {0x1p600, 0, 0}}, 1, 1);
  const GC::Join_continuity<double> join = GC::continuity(left, right);
  BOOST_CHECK_EQUAL(join.g_order, 3);
  CHECK_ERROR(join.betas(), not_finite);
}

BOOST_AUTO_TEST_CASE(negative_orders) {
  const Halves<Double_3> rounded(1, 1, 1);
  const Halves<Epick_3> filtered(1, 1, 1);
  CHECK_ERROR(GC::continuity(rounded.left, rounded.right, -1), negative_count);
  CHECK_ERROR(GC::continuity(filtered.left, filtered.right, -1), negative_count);
  CHECK_ERROR(GC::continuity(filtered.left.end_jet(2), filtered.right.start_jet(2), -1), negative_count);
  CHECK_ERROR(GC::Chain_accumulator<GC::Bezier_curve<Epick_3>>(-1), negative_count);
}

// ---------------------------------------------------------------- exact joins of doubles

BOOST_AUTO_TEST_CASE(no_memory_from_the_heap) {
  const Halves<Epick_3> halves(0.125, 1, 1), slow(3, 1, 2);
  const std::size_t before = allocations;
  const GC::Join_continuity<Q> join = GC::continuity(halves.left, halves.right),
                               other = GC::continuity(slow.left, slow.right);
  const std::size_t needed = allocations - before;
  BOOST_CHECK_EQUAL(needed, 0u);
  BOOST_CHECK_EQUAL(join.c_order, 3);
  BOOST_CHECK_EQUAL(other.g_order, 3);
  BOOST_CHECK(join.betas() == (std::vector<Q>{1, 0, 0}));
  BOOST_CHECK(other.betas() == (std::vector<Q>{Q(1) / 2, 0, 0}));
}

// ---------------------------------------------------------------- dimension n

// Jets whose derivatives are independent: F^n unless a derivative leaves the span of the lower
// ones.
BOOST_AUTO_TEST_CASE(frenet_order_in_high_dimensions) {
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  typedef GC::Curve_jet<Traits> Jet;
  std::mt19937 engine = seeded(2026);
  const auto small = [&]() { return Q(static_cast<int>(engine() % 7) - 3); };
  for (const int n : {5, 19, 40}) {
    Jet x(n, n);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i < n; ++i) x[j][i] = i >= j ? Q(i == j - 1) : small(); // independent
    for (int j = 1; j <= n; ++j) x[j][j - 1] = Q(1);
    Jet y = x; // with multiples of lower derivatives: F^n, not G^2
    for (int j = 2; j <= n; ++j)
      for (int l = 1; l < j; ++l) y[j] += small() * x[l];
    y[3] += Q(5) * x[2];
    BOOST_CHECK_EQUAL(GC::continuity(x, y).f_order, n);
    for (const int broken : {2, n / 2, n}) {
      Jet z = y;
      z[broken] += Q(1) * x[broken]; // independent of the lower ones
      BOOST_CHECK_EQUAL(GC::continuity(x, z).f_order, broken - 1);
    }
    // derivatives that vanish or depend on lower ones do not enlarge the span
    Jet flat = x, same = x;
    flat[3] = same[3] = x[1] - x[2];
    same[4] += x[3];
    BOOST_CHECK_EQUAL(GC::continuity(flat, same).f_order, 3);
  }
}

// With doubles, where whole numbers stay exact.
BOOST_AUTO_TEST_CASE(frenet_order_of_doubles) {
  typedef GC::Traits_d<CGAL::Cartesian_d<double>> Traits;
  typedef GC::Curve_jet<Traits> Jet;
  for (const int n : {4, 19, 40}) {
    Jet x(n, n);
    for (int j = 1; j <= n; ++j) x[j][n - j] = 1;
    Jet y = x;
    for (int j = 2; j <= n; ++j) y[j] += 3. * x[j - 1];
    BOOST_CHECK_EQUAL(GC::continuity(x, y).f_order, n);
    y[n][0] = 2;
    BOOST_CHECK_EQUAL(GC::continuity(x, y).f_order, n - 1);
  }
}
