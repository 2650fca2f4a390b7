// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Enclosures and integrals of the package against an independent library, Arb, which computes in
// balls of 200 bits from the definitions.

#define BOOST_TEST_MODULE arb

#include "support/arb.h"
#include "support/enclosures.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/edges/edge_deviation.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
using arb::Ball;
using enclosures::ulps;

typedef std::array<double, 3> Point;

struct Random : Random_integers<std::mt19937_64> {
  // Returns a random number of the size 1/1000, 1 or 100000.
  double number() {
    const double scale = std::array<double, 3>{1e-3, 1, 1e5}[integer(0u, 2u)];
    return scale * std::ldexp(static_cast<double>(integer<std::int64_t>(-(1LL << 52), 1LL << 52)), -52);
  }
  Point point(bool is_plane = false) {
    Point p{};
    for (int i = 0; i < (is_plane ? 2 : 3); ++i) p[i] = number();
    return p;
  }
  std::vector<Point> cubic(bool is_plane = false) {
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i) points.push_back(point(is_plane));
    return points;
  }
  // A cubic that is made to continue the other one, but for a part of 2^-k.
  std::vector<Point> continuation(const std::vector<Point>& a, bool is_plane = false) {
    std::vector<Point> b = cubic(is_plane);
    const double part = std::ldexp(1., -integer(0, 50)), side = coin() ? 1 : -1;
    for (int i = 0; i < 3; ++i) {
      b[0][i] = a[3][i];
      b[1][i] = a[3][i] + side * (a[3][i] - a[2][i]) + part * b[1][i];
      if (coin()) b[2][i] = a[1][i] + 4 * (a[3][i] - a[2][i]) + part * b[2][i];
    }
    return b;
  }
};

arb::Vector vector(const Point& p) { return {Ball(p[0]), Ball(p[1]), Ball(p[2])}; }

// The derivatives of a cubic at its first point.
std::array<arb::Vector, 4> derivatives(const std::vector<Point>& p, int sign) {
  const arb::Vector a = vector(p[0]), d1 = arb::minus(vector(p[1]), a), d2 = arb::minus(vector(p[2]), vector(p[1])),
                    d3 = arb::minus(vector(p[3]), vector(p[2])), e1 = arb::minus(d2, d1), e2 = arb::minus(d3, d2);
  return {a, arb::times(3 * sign, d1), arb::times(6, e1), arb::times(6 * sign, arb::minus(e2, e1))};
}

arb::Vector curvature_vector(const std::array<arb::Vector, 4>& x) {
  const Ball g = arb::dot(x[1], x[1]);
  return arb::times(Ball(1) / (g * g), arb::cross(arb::cross(x[1], x[2]), x[1]));
}

Ball torsion(const std::array<arb::Vector, 4>& x) {
  const arb::Vector n = arb::cross(x[1], x[2]);
  return arb::dot(n, x[3]) / arb::dot(n, n);
}

GC::Bezier_curve<Space> space_curve(const std::vector<Point>& p) {
  std::vector<Kernel::Point_3> points;
  for (const Point& x : p) points.emplace_back(x[0], x[1], x[2]);
  return GC::Bezier_curve<Space>(points.begin(), points.end());
}

GC::Bezier_curve<Plane> plane_curve(const std::vector<Point>& p) {
  std::vector<Kernel::Point_2> points;
  for (const Point& x : p) points.emplace_back(x[0], x[1]);
  return GC::Bezier_curve<Plane>(points.begin(), points.end());
}

BOOST_AUTO_TEST_CASE(joins) {
  Random random;
  int wrong = 0, wide = 0, small_angles = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const std::vector<Point> a = random.cubic(), b = i % 4 == 0 ? random.cubic() : random.continuation(a);
    const GC::Join_deviation d = GC::deviation(space_curve(a), space_curve(b));
    const auto x = derivatives({a.rbegin(), a.rend()}, -1), y = derivatives(b, 1);
    const arb::Vector k = curvature_vector(x), l = curvature_vector(y);
    BOOST_REQUIRE(d.tangent_angle && d.curvature_jump && d.torsion_jump);
    const Ball jump = arb::length(arb::minus(l, k)) / max(arb::length(k), arb::length(l));
    wrong += !arb::encloses(d.gap, arb::length(arb::minus(y[0], x[0]))) +
             !arb::encloses(*d.tangent_angle, arb::angle(x[1], y[1])) + !arb::encloses(*d.curvature_jump, jump) +
             !arb::encloses(*d.torsion_jump, abs(torsion(y) - torsion(x)));
    wide += ulps(d.gap) > 4 || ulps(*d.tangent_angle) > 4 || ulps(*d.curvature_jump) > 4 || ulps(*d.torsion_jump) > 4;
    small_angles += d.tangent_angle->upper < 1e-6;
  }
  std::cout << count << " joins: gaps, angles, jumps of the curvature and of the torsion\n";
  BOOST_CHECK_EQUAL(wrong, 0);
  BOOST_CHECK_EQUAL(wide, 0);
  BOOST_CHECK_GT(small_angles, count / 100);
}

BOOST_AUTO_TEST_CASE(kinks) {
  Random random;
  int wrong = 0, wide = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const std::vector<Point> a = random.cubic(true), b = i % 4 == 0 ? random.cubic(true) : random.continuation(a, true);
    const GC::Kink_size kink = *GC::kink_size(plane_curve(a), plane_curve(b));
    const arb::Vector v = arb::minus(vector(a[3]), vector(a[2])), w = arb::minus(vector(b[1]), vector(b[0]));
    const Ball angle = arb::angle(v, w), longer = max(arb::length(v), arb::length(w)),
               shorter = min(arb::length(v), arb::length(w));
    const bool is_obtuse = arb_is_nonpositive(arb::dot(v, w).get());
    wrong += !arb::encloses(kink.angle, angle) + !arb::encloses(kink.severity, angle * shorter) +
             !arb::encloses(kink.handle_offset, is_obtuse ? shorter : arb::length(arb::cross(v, w)) / longer);
    wide += ulps(kink.angle) > 4 || ulps(kink.handle_offset) > 4 || ulps(kink.severity) > 8;
  }
  std::cout << count << " kinks: angles, offsets of handles and severities\n";
  BOOST_CHECK_EQUAL(wrong, 0);
  BOOST_CHECK_EQUAL(wide, 0);
}

// A row of parabolas, with integers as coefficients.
struct Row {
  std::array<std::array<long, 3>, 3> points; // of each coefficient the coordinates

  template <class Source> static Row random(Source& source) {
    Row row;
    for (auto& p : row.points)
      for (long& x : p) x = source.integer(-99, 99);
    return row;
  }
  template <class Source> static Row random_line(Source& source) {
    Row row = random(source);
    for (int i = 0; i < 3; ++i) row.points[2][i] = 2 * row.points[1][i] - row.points[0][i];
    return row;
  }
  GC::Edge_rows<double>::Row row() const {
    GC::Edge_rows<double>::Row r;
    for (const auto& p : points) {
      GC::Coordinate_vector<double, 3> v(3);
      for (int i = 0; i < 3; ++i) v[i] = static_cast<double>(p[i]);
      r.push_back(v);
    }
    return r;
  }
  arb::Coordinates<arb::Polynomial> polynomials() const {
    arb::Coordinates<arb::Polynomial> r;
    for (int i = 0; i < 3; ++i) r[i] = arb::Polynomial::parabola(points[0][i], points[1][i], points[2][i]);
    return r;
  }
  Row reversed() const { return {{points[2], points[1], points[0]}}; }
};

arb::Vector at(const Ball& t, const arb::Coordinates<arb::Polynomial>& p) { return {p[0](t), p[1](t), p[2](t)}; }

Ball largest_distance(const Row& a, const Row& b) {
  const auto d = arb::minus(a.polynomials(), b.polynomials());
  const arb::Polynomial square = arb::dot(d, d);
  Ball largest(0);
  for (const Ball& t : square.derivative().roots_and_ends()) largest = max(largest, root(square(t)));
  return largest;
}

// The angle of m and -n along an edge. It falls with d |d| / (m^2 n^2), where d is the product of
// both.
Ball largest_angle(const arb::Coordinates<arb::Polynomial>& m, const arb::Coordinates<arb::Polynomial>& n) {
  const arb::Polynomial d = arb::dot(m, n), squares = arb::dot(m, m) * arb::dot(n, n),
                        slope = d.derivative() * squares + d.derivative() * squares - d * squares.derivative();
  Ball largest(0);
  for (const Ball& t : slope.roots_and_ends()) {
    const arb::Vector v = at(t, m), w = arb::minus(arb::Vector(), at(t, n));
    largest = max(largest, arb::angle(v, w));
  }
  return largest;
}

BOOST_AUTO_TEST_CASE(edges) {
  Random random;
  int wrong = 0, wide = 0;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) {
    const Row c = Row::random(random), p = Row::random_line(random), w = Row::random(random);
    Row e = c, q = Row::random_line(random);
    const bool has_gap = i % 3 != 0;
    if (has_gap) e = Row::random(random);
    if (i % 2 == 1) // the surfaces almost continue each other
      for (int j = 0; j < 9; ++j) q.points[j / 3][j % 3] = -p.points[j / 3][j % 3] + (q.points[j / 3][j % 3] > 90);
    const GC::Edge_deviation d = GC::deviation(GC::Edge_rows<double>{c.row(), p.row(), w.row()},
                                               GC::Edge_rows<double>{e.row(), q.row(), w.row()});
    if (has_gap) {
      const Ball gap = min(largest_distance(c, e), largest_distance(c, e.reversed()));
      wrong += !arb::encloses(d.gap, gap);
    } else {
      BOOST_REQUIRE(d.gap.upper == 0 && !d.reversed && d.normal_angle);
      const auto x = c.polynomials();
      const arb::Coordinates<arb::Polynomial> u{x[0].derivative(), x[1].derivative(), x[2].derivative()};
      wrong += !arb::encloses(*d.normal_angle,
                              largest_angle(arb::cross(u, p.polynomials()), arb::cross(u, q.polynomials())));
      wide += ulps(*d.normal_angle) > 4;
    }
    wide += ulps(d.gap) > 4;
  }
  std::cout << count << " edges: largest gaps and largest angles of the normals\n";
  BOOST_CHECK_EQUAL(wrong, 0);
  BOOST_CHECK_EQUAL(wide, 0);
}

// The length of a curve and the integrals over its arc length, as the energies have them.
BOOST_AUTO_TEST_CASE(arc_lengths) {
  Random random;
  int wrong = 0, inaccurate = 0;
  constexpr int count = 100;
  for (int i = 0; i < count; ++i) {
    std::array<std::array<long, 2>, 4> points;
    std::vector<Kernel::Point_2> control_points;
    for (auto& p : points) {
      // without cusps, near which Arb takes long
      const long first = 40 * static_cast<long>(control_points.size());
      p[0] = first + random.integer(-15, 15);
      p[1] = random.integer(-40, 40);
      control_points.emplace_back(p[0], p[1]);
    }
    std::array<std::array<arb::Polynomial, 2>, 4> d; // the derivatives
    for (int k = 0; k < 2; ++k) {
      const auto leg = [&](int j) { return 3 * (points[j + 1][k] - points[j][k]); };
      d[1][k] = arb::Polynomial::parabola(leg(0), leg(1), leg(2));
      for (int j = 2; j < 4; ++j) d[j][k] = d[j - 1][k].derivative();
    }
    const auto dot = [&](int j, int k) { return d[j][0] * d[k][0] + d[j][1] * d[k][1]; };
    const auto determinant = [&](int j, int k) { return d[j][0] * d[k][1] - d[j][1] * d[k][0]; };
    const arb::Polynomial g = dot(1, 1), bend = determinant(1, 2), three = arb::Polynomial::parabola(3, 3, 3),
                          change = g * determinant(1, 3) - three * dot(1, 2) * bend;
    const Ball length = arb::Polynomial::integral(arb::Polynomial::parabola(1, 1, 1), g, 0),
               energy = length * arb::Polynomial::integral(bend * bend, g, 3),
               variation = length * length * length * arb::Polynomial::integral(change * change, g, 6);
    const GC::Bezier_curve<Plane> curve(control_points.begin(), control_points.end());
    for (const auto& [computed, value] :
         {std::pair(GC::bending_energy(curve), energy), std::pair(GC::fairness(curve), variation)}) {
      inaccurate += arb_rel_accuracy_bits(value.get()) < 30;
      // 1e-8 of each of the four factors
      const Ball error = abs(Ball(computed) / value - Ball(1)), promised(4e-8);
      wrong += arb_gt(error.get(), promised.get());
    }
  }
  std::cout << count << " curves: integrals over the arc length\n";
  BOOST_CHECK_EQUAL(wrong, 0);
  BOOST_CHECK_EQUAL(inaccurate, 0);
}
