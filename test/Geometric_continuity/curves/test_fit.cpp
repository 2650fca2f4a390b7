// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves near polylines. Joins are decided exactly on the control points; distances are compared
// with those of many points.

#include "support/decided_joins.h"
#include "support/exact_splines.h"
#include "support/plain_traits.h"

#include <CGAL/Geometric_continuity/curves/fit.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

BOOST_AUTO_TEST_SUITE(fit)

using GC::Closure;
typedef GC::Traits_3<Exact> Space;
typedef std::vector<Epick_2::Point> Points;
typedef GC::Coordinate_vector<double, 4> Column; // of any dimension up to 4

template <class Point> Column doubles(const Point& p) {
  Column x(4);
  for (int i = 0; i < p.dimension(); ++i) x[i] = CGAL::to_double(p[i]);
  return x;
}
double distance(const Column& x, const Column& p, const Column& q) {
  const double t = dot(x - p, q - p) / dot(q - p, q - p);
  const Column d = x - (p + (std::min)((std::max)(t, 0.), 1.) * (q - p));
  return std::sqrt(dot(d, d));
}
// The point of a Bezier curve, by de Casteljau's algorithm.
Column point_of(std::vector<Column> b, double t) {
  for (std::size_t m = b.size(); m-- > 1;)
    for (std::size_t i = 0; i < m; ++i) b[i] += t * (b[i + 1] - b[i]);
  return b[0];
}
double distance(const Column& x, const std::vector<Column>& polyline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
    if (polyline[k] != polyline[k + 1]) least = (std::min)(least, distance(x, polyline[k], polyline[k + 1]));
  return least;
}

// The joins have the order, but at corners; the distance is at most what is said, and that is at
// most the tolerance. Returns the number of pieces.
template <class Traits, class P>
int check(const GC::Fitted_curve<Traits>& curve, const P& points, double tolerance, Closure closure, int order) {
  typedef typename GC::Composite_bezier_curve<Traits>::Segment Segment;
  const int n = curve.number_of_segments();
  std::vector<Segment> pieces;
  for (const Segment& s : curve.segments()) pieces.push_back(s);
  BOOST_CHECK_EQUAL(curve.degree(), 2 * order + 1);
  BOOST_CHECK_EQUAL(curve.vertices.size(), curve.knots().size());
  const auto is_corner = [&](int k) {
    return std::find(curve.corners.begin(), curve.corners.end(), k) != curve.corners.end();
  };
  for (int k = closure == Closure::closed ? 0 : 1; k < n; ++k) {
    if (is_corner(k)) continue;
    BOOST_TEST_CONTEXT("knot " << k)
    BOOST_CHECK_GE(GC::continuity(pieces[(k + n - 1) % n], pieces[k], order).g_order, order);
  }
  if (closure == Closure::closed) BOOST_CHECK(curve.is_closed());
  BOOST_CHECK_LE(curve.distance, tolerance);

  std::vector<Column> polyline;
  for (const auto& p : points) polyline.push_back(doubles(p));
  if (closure == Closure::closed) polyline.push_back(polyline.front());
  std::vector<std::vector<Column>> polygons, samples; // at i/120
  for (const Segment& s : pieces) {
    polygons.emplace_back();
    for (const auto& b : s) polygons.back().push_back(doubles(b));
    samples.emplace_back();
    for (int i = 0; i <= 120; ++i) samples.back().push_back(point_of(polygons.back(), i / 120.));
  }
  const double bound = curve.distance + 1e-9 + 1e-9 * curve.distance;
  for (const std::vector<Column>& piece : samples)
    for (const Column& x : piece) BOOST_CHECK_LE(distance(x, polyline), bound);
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
    for (const double part : {0., 0.4}) {
      const Column x = polyline[k] + part * (polyline[k + 1] - polyline[k]);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < samples.size() && bound < least; ++j)
        for (int i = 0; i < 120 && bound < least; ++i) {
          const std::vector<Column> chord = {samples[j][i], samples[j][i + 1]};
          if (distance(x, chord) > bound + tolerance) continue;
          std::vector<Column> fine;
          for (int l = 0; l <= 30; ++l) fine.push_back(point_of(polygons[j], (i + l / 30.) / 120));
          least = (std::min)(least, distance(x, fine));
        }
      BOOST_CHECK_LE(least, bound + 1e-3 * tolerance);
    }
  return n;
}

Points circle(int n, double radius = 1) {
  Points p;
  for (int i = 0; i < n; ++i) p.emplace_back(radius * std::cos(2 * M_PI * i / n), radius * std::sin(2 * M_PI * i / n));
  return p;
}
Points wave(int n) {
  Points p;
  for (int i = 0; i <= n; ++i) {
    const double t = 10. * i / n;
    p.emplace_back(t + .3 * std::sin(3 * t), 2 * std::sin(t) + .1 * std::cos(7 * t));
  }
  return p;
}
int pieces(const Points& p, double tolerance, Closure closure, int order, double corner_angle = 45) {
  return check(GC::fit<Epick_2>(p.begin(), p.end(), tolerance, closure, order, corner_angle), p, tolerance, closure,
               order);
}

// As few pieces as known constructions have, and perhaps one more at the end: quarters of a circle
// by cubics are wrong by 2.7e-4 of the radius.
BOOST_AUTO_TEST_CASE(smooth_polylines) {
  BOOST_CHECK_LE(pieces(circle(300, 100), 0.1, Closure::closed, 1), 5);
  BOOST_CHECK_LE(pieces(circle(300, 100), 0.1, Closure::closed, 2), 2);
  BOOST_CHECK_LE(pieces(wave(400), 0.01, Closure::open, 1), 13);
  BOOST_CHECK_LE(pieces(wave(400), 0.01, Closure::open, 2), 10);
  BOOST_CHECK_EQUAL(pieces(wave(400), 10, Closure::open, 1), 1);
  // shorter than what the vertices leave out of a circle: a piece for each segment
  BOOST_CHECK_EQUAL(pieces(circle(12), 1e-3, Closure::closed, 1), 12);
  BOOST_CHECK_EQUAL(pieces(circle(12), 1e-3, Closure::closed, 2), 12);
  BOOST_CHECK_EQUAL(pieces(circle(8), 1e-6, Closure::closed, 2), 8);
}

// As few pieces as any curve has, where the longest pieces, one after the other, are one more: the
// last one goes, and the one before it is extended.
BOOST_AUTO_TEST_CASE(least_numbers) {
  Points arc, spiral;
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const double t = i / 499., angle = static_cast<double>(random()) * 0x1p-31 * M_PI, r = .1 + t;
    arc.emplace_back(std::cos(6 * t), std::sin(6 * t));
    spiral.emplace_back(r * std::cos(4 * M_PI * t) + .005 * std::cos(angle),
                        r * std::sin(4 * M_PI * t) + .005 * std::sin(angle));
  }
  for (const auto& [p, tolerance] : {std::pair(arc, 2.5e-5), std::pair(spiral, 0.01)}) {
    const auto curve = GC::fit<Epick_2>(p.begin(), p.end(), tolerance, Closure::open, 2);
    BOOST_REQUIRE_EQUAL(curve.number_of_segments(), 2);
    BOOST_CHECK_LE(curve.distance, tolerance);
    BOOST_CHECK_GE(GC::continuity(curve.segment(0), curve.segment(1), 2).g_order, 2);
  }
}

// Segments that are much shorter than a piece, where the shortest pieces do not succeed: a segment
// leaves out 0.03 and 0.0007 tolerances of the circle. The end of the loop is its start up to
// rounding.
BOOST_AUTO_TEST_CASE(dense_polylines) {
  Points arc, loop;
  for (int i = 0; i < 2000; ++i) arc.emplace_back(std::cos(i / 1999.), std::sin(i / 1999.));
  for (int i = 0; i < 20000; ++i)
    loop.emplace_back(600 * std::cos(2 * M_PI * i / 19999), 600 * std::sin(2 * M_PI * i / 19999));
  const auto fitted = [](const Points& p, double tolerance, Closure closure, int order) {
    const auto curve = GC::fit<Epick_2>(p.begin(), p.end(), tolerance, closure, order);
    BOOST_CHECK_LE(curve.distance, tolerance);
    return curve.number_of_segments();
  };
  for (const int order : {1, 2}) {
    BOOST_CHECK_LE(fitted(arc, 1e-6, Closure::open, order), 2);
    for (const Closure closure : {Closure::open, Closure::closed})
      BOOST_CHECK_LE(fitted(loop, 0.01, closure, order), order == 1 ? 7 : 2);
  }
}

// Neither noise of half the tolerance, at vertices that are nearer to each other, nor the steps of
// a curve of pixels are corners, and no piece ends because of them.
BOOST_AUTO_TEST_CASE(noise_and_staircases) {
  repeat(5, [](Random& random) {
    Points p;
    for (int i = 0; i <= 500; ++i) {
      const double t = i / 50., size = 0.01, angle = random.integer(0, 6283) / 1000.;
      p.emplace_back(t + size * std::cos(angle), std::sin(t) + size * std::sin(angle));
    }
    for (const int order : {1, 2}) {
      BOOST_CHECK(GC::fit<Epick_2>(p.begin(), p.end(), 0.02, Closure::open, order).corners.empty());
      BOOST_CHECK_LE(pieces(p, 0.02, Closure::open, order), 8);
    }
  });
  Points pixels;
  for (int i = 0; i < 720; ++i) {
    const Epick_2::Point q(std::round(30 * std::cos(M_PI * i / 360)), std::round(18 * std::sin(M_PI * i / 360)));
    if (!pixels.empty() && pixels.back().x() != q.x() && pixels.back().y() != q.y())
      pixels.emplace_back(q.x(), pixels.back().y());
    if (pixels.empty() || pixels.back() != q) pixels.push_back(q);
  }
  for (const int order : {1, 2}) {
    BOOST_CHECK(GC::fit<Epick_2>(pixels.begin(), pixels.end(), 1, Closure::closed, order).corners.empty());
    BOOST_CHECK_LE(pieces(pixels, 1, Closure::closed, order), 7);
  }
  Points diagonal; // with steps of 45 degrees
  for (int i = 0; i < 720; ++i) {
    const Epick_2::Point q(std::round(30 * std::cos(M_PI * i / 360)), std::round(20 * std::sin(M_PI * i / 360)));
    if (diagonal.empty() || diagonal.back() != q) diagonal.push_back(q);
  }
  for (const double tolerance : {0.6, 0.75, 1.})
    BOOST_CHECK(GC::fit<Epick_2>(diagonal.begin(), diagonal.end(), tolerance, Closure::closed, 1).corners.empty());
  // the outline of the pixels inside of an ellipse, by columns, within half a step
  Points columns;
  const auto height = [](int x) { return std::floor(36 * std::sqrt(1 - (x + 0.5) * (x + 0.5) / 3600)); };
  for (const int side : {1, -1})
    for (int i = -60; i < 60; ++i) {
      const int x = side > 0 ? i : -1 - i;
      for (const int end : {x + (side < 0), x + (side > 0)})
        if (const Epick_2::Point q(end, side * height(x)); columns.empty() || columns.back() != q) columns.push_back(q);
    }
  for (const double tolerance : {0.5, 0.75})
    BOOST_CHECK(GC::fit<Epick_2>(columns.begin(), columns.end(), tolerance, Closure::closed, 1).corners.empty());
  // a line by steps of 1, to its ends; and a square of pixels, turned, which has four corners
  for (const double slope : {1., 0.5, 0.37, 0.1}) {
    Points steps = {Epick_2::Point(0, 0)};
    for (int x = 0; x < 60; ++x) {
      const double y = std::floor((x + 1) * slope);
      steps.emplace_back(x + 1, steps.back().y());
      if (y != steps.back().y()) steps.emplace_back(x + 1, y);
    }
    for (const double tolerance : {0.5, 0.75, 1.})
      BOOST_CHECK(GC::fit<Epick_2>(steps.begin(), steps.end(), tolerance, Closure::open, 1).corners.empty());
  }
  Points square; // of the side (58, 16), each in 60 parts
  int x = 0, y = 0, u = 58, v = 16;
  for (int i = 0; i < 4; ++i) {
    for (int k = 1; k <= 60; ++k) {
      const Epick_2::Point q(x + u * k / 60, y + v * k / 60), p = square.empty() ? Epick_2::Point(0, 0) : square.back();
      if (p.x() != q.x() && p.y() != q.y()) square.emplace_back(i % 2 == 0 ? q.x() : p.x(), i % 2 == 0 ? p.y() : q.y());
      if (p != q) square.push_back(q);
    }
    x += u, y += v;
    std::swap(u, v), u = -u;
  }
  for (const double tolerance : {0.75, 1.})
    BOOST_CHECK_EQUAL(GC::fit<Epick_2>(square.begin(), square.end(), tolerance, Closure::closed, 1).corners.size(), 4u);
}

// Noise of half the tolerance at vertices that are 500 times closer to each other can be fitted,
// too. Near one of these vertices, rounding decides how a slow piece is divided.
BOOST_AUTO_TEST_CASE(dense_noise) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  constexpr int n = 100000;
  Points p;
  for (int i = 0; i < n; ++i) {
    const double x = 10 * (i / double(n - 1)), y = std::sin(x) * 2 + 0.05 * noise(random);
    if (i >= n - 4000) p.emplace_back(x, y);
  }
  std::reverse(p.begin(), p.end());
  for (const int order : {1, 2})
    BOOST_CHECK_LT(GC::fit<Epick_2>(p.begin(), p.end(), 0.1, Closure::open, order).number_of_segments(), 400);
}

// A short polyline has as many pieces when it is run through backwards.
BOOST_AUTO_TEST_CASE(short_polylines_backwards) {
  repeat(5, [](Random& random) {
    Points line, wave;
    for (int i = 0; i <= 500; ++i) {
      line.emplace_back(i / 50., random.integer(-500, 500) / 10000.);
      wave.emplace_back(i / 50., 2 * std::sin(i / 25.) + random.integer(-100, 100) / 10000.);
    }
    for (const Points& p : {line, wave})
      for (const int order : {1, 2})
        BOOST_CHECK_EQUAL(GC::fit<Epick_2>(p.begin(), p.end(), 0.1, Closure::open, order).number_of_segments(),
                          GC::fit<Epick_2>(p.rbegin(), p.rend(), 0.1, Closure::open, order).number_of_segments());
  });
}

BOOST_AUTO_TEST_CASE(corners) {
  for (const int order : {1, 2}) {
    const Points rectangle = {Epick_2::Point(2, 0), Epick_2::Point(4, 0), Epick_2::Point(4, 3), Epick_2::Point(0, 3),
                              Epick_2::Point(0, 0)};
    const auto curve = GC::fit<Epick_2>(rectangle.begin(), rectangle.end(), 0.01, Closure::closed, order);
    BOOST_CHECK_EQUAL(check(curve, rectangle, 0.01, Closure::closed, order), 4); // from a corner on
    BOOST_CHECK(curve.vertices == std::vector<int>({1, 2, 3, 4, 1}));
    BOOST_CHECK(curve.corners == std::vector<int>({0, 1, 2, 3}));
    for (int k = 0; k < 4; ++k) {
      BOOST_CHECK(curve.segment(k).control_point(0) == rectangle[k + 1]);
      BOOST_CHECK_EQUAL(GC::continuity(curve.segment((k + 3) % 4), curve.segment(k), 2).g_order, 0);
    }
    BOOST_CHECK_LT(curve.distance, 1e-4);         // lines
    for (const double tolerance : {1e-2, 1e-6}) { // rounded where there must be no corner
      BOOST_CHECK_EQUAL(pieces(rectangle, tolerance, Closure::closed, order, 91), 5);
      Points half = circle(100);
      half.resize(50);
      const auto d = GC::fit<Epick_2>(half.begin(), half.end(), tolerance, Closure::closed, order);
      check(d, half, tolerance, Closure::closed, order);
      BOOST_CHECK_EQUAL(d.corners.size(), 2u);
    }
  }
}

// Zigzags that are narrower than the tolerance, where they start and end as well, and a square that
// is smaller than it.
BOOST_AUTO_TEST_CASE(polylines_within_the_tolerance) {
  typedef Epick_2::Point P;
  Points zigzag, square = {P(5, 5), P(6, 5), P(6, 6), P(5, 6)};
  for (int i = 0; i < 60; ++i) zigzag.emplace_back(i % 2, 0.001 * i);
  for (const int order : {1, 2}) {
    pieces(zigzag, 2, Closure::open, order, 180);
    pieces(zigzag, 2, Closure::open, order);
    pieces(square, 10, Closure::closed, order);
  }
}

BOOST_AUTO_TEST_CASE(degenerate_polylines) {
  typedef Epick_2::Point P;
  for (const int order : {1, 2}) {
    BOOST_CHECK_EQUAL(pieces({P(1, 1), P(3, 2)}, 0.01, Closure::open, order), 1);
    BOOST_CHECK_EQUAL(pieces({P(0, 0), P(1, 1), P(2, 2), P(5, 5), P(6, 6)}, 0.01, Closure::open, order), 1);
    BOOST_CHECK_EQUAL(pieces({P(0, 0), P(0, 0), P(1, 1), P(1, 1), P(1, 1), P(2, 2)}, 0.01, Closure::open, order), 1);
    // back on itself, which is a corner at every angle
    for (const double angle : {45., 180.}) {
      const Points back = {P(0, 0), P(4, 0), P(2, 0), P(7, 0)}, there_and_back = {P(0, 0), P(4, 0), P(2, 0)};
      BOOST_CHECK_EQUAL(pieces(back, 0.01, Closure::open, order, angle), 3);
      pieces(there_and_back, 0.01, Closure::closed, order, angle);
      pieces(back, 3, Closure::open, order, angle); // where it is not seen
    }
    // a short way back, which is no corner: the tangent there is opposite to that of a long segment
    BOOST_CHECK_LE(pieces({P(-20, -8), P(0, 0), P(-0.05, 0), P(40, 0)}, 0.1, Closure::open, order), 3);
    // within a tolerance that is larger than all, curvatures have multiples that are not exact
    Points heptagon;
    for (int i = 0; i < 7; ++i) heptagon.emplace_back(std::cos(i * 6.28 / 7), std::sin(i * 6.28 / 7));
    pieces(heptagon, 2, Closure::closed, order, 180);
    // a closed polyline may end with its first vertex
    Points p = circle(50);
    const int n = pieces(p, 0.01, Closure::closed, order);
    p.push_back(p.front());
    BOOST_CHECK_EQUAL(pieces(p, 0.01, Closure::closed, order), n);
    // a loop, and one that is open
    BOOST_CHECK_LE(pieces(p, 0.01, Closure::open, order), n + 1);
    Points zigzag;
    for (int i = 0; i < 30; ++i) zigzag.emplace_back(i, i % 2);
    for (const double tolerance : {1e-5, 1e-2, 0.6, 2.}) pieces(zigzag, tolerance, Closure::open, order, 180);
    BOOST_CHECK_EQUAL(pieces(zigzag, 0.01, Closure::open, order), 29);
  }
}

// Parameters are found as closely as small tolerances need, also where the middle of a segment is
// that of the curve.
BOOST_AUTO_TEST_CASE(small_tolerances, *boost::unit_test::label("long")) {
  const Points regular = circle(5), p = {{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}};
  const auto fits = [](const Points& pentagon, double tolerance, int order) {
    for (const double corner : {45., 90.}) {
      const auto curve = GC::fit<Epick_2>(pentagon.begin(), pentagon.end(), tolerance, Closure::closed, order, corner);
      BOOST_CHECK_EQUAL(check(curve, pentagon, tolerance, Closure::closed, order), 5);
      BOOST_CHECK_EQUAL(curve.corners.size(), corner < 72 ? 5u : 0u);
      for (int k = 0; k < 5; ++k) { // at each vertex the curve goes on as both segments do
        if (corner < 72) continue;
        const auto piece = curve.segment(k);
        const int v = curve.vertices[k];
        const auto tangent = piece.control_point(1) - piece.control_point(0);
        BOOST_CHECK_GT(tangent * (pentagon[(v + 1) % 5] - pentagon[v % 5]), 0);
        BOOST_CHECK_GT(tangent * (pentagon[v % 5] - pentagon[(v + 4) % 5]), 0);
      }
    }
  };
  for (const Points& pentagon : {regular, p})
    for (const int order : {1, 2}) fits(pentagon, 1e-6, order);
  fits(regular, 1e-9, 1); // smaller ones take minutes without optimisation
}

BOOST_AUTO_TEST_CASE(random_polylines) {
  repeat(2, [](Random& random) {
    Points p;
    double x = 0, y = 0;
    for (int i = 0; i < 40; ++i) {
      x += random.integer(-9999, 9999) / 1e4;
      y += random.integer(-9999, 9999) / 1e4 * (random.coin() ? 1 : 1e-5);
      p.emplace_back(x, y);
    }
    for (const double tolerance : {1e-4, 0.03, 0.5})
      for (const Closure closure : {Closure::open, Closure::closed})
        for (const int order : {1, 2}) pieces(p, tolerance, closure, order, random.integer(0, 180));
  });
}

// On exact numbers in space and in any dimension: control points have few digits, and the vertices
// are not rounded in vain.
BOOST_AUTO_TEST_CASE(exact_numbers) {
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Any;
  std::vector<Space::Point> p;
  std::vector<Any::Point> same, four;
  for (int i = 0; i <= 60; ++i) { // a helix
    const Q t = ratio(i, 10), s = Q(2) * t / (Q(1) + t * t), c = (Q(1) - t * t) / (Q(1) + t * t);
    const Q x[] = {c, s, t / Q(3), Q(1) / Q(3)};
    p.emplace_back(x[0], x[1], x[2]);
    same.emplace_back(3, x, x + 3);
    four.emplace_back(4, x, x + 4);
  }
  const Q tolerance = ratio(1, 50);
  for (const int order : {1, 2}) {
    const auto curve = GC::fit<Space>(p.begin(), p.end(), tolerance, Closure::open, order);
    BOOST_CHECK_LE(check(curve, p, 0.02, Closure::open, order), 6);
    const auto any = GC::fit<Any>(same.begin(), same.end(), tolerance, Closure::open, order);
    BOOST_REQUIRE_EQUAL(any.control_points().size(), curve.control_points().size());
    for (std::size_t i = 0; i < curve.control_points().size(); ++i)
      for (int x = 0; x < 3; ++x) BOOST_CHECK_EQUAL(any.control_point(i)[x], curve.control_point(i)[x]);
    check(GC::fit<Any>(four.begin(), four.end(), tolerance, Closure::open, order), four, 0.02, Closure::open, order);
  }
  // so far away that doubles are too coarse: the same curve at any place
  std::vector<std::vector<Space::Point>> far(2);
  for (const int k : {0, 1})
    for (const auto& x : p) far[k].emplace_back(x.x() + Q(k == 0 ? 1e15 : 1e18), x.y(), x.z());
  const auto curve = GC::fit<Space>(far[0].begin(), far[0].end(), tolerance),
             same_curve = GC::fit<Space>(far[1].begin(), far[1].end(), tolerance);
  BOOST_CHECK_LE(curve.number_of_segments(), 6);
  BOOST_REQUIRE_EQUAL(curve.control_points().size(), same_curve.control_points().size());
  for (std::size_t i = 0; i < curve.control_points().size(); ++i)
    BOOST_CHECK(same_curve.control_point(i).x() - curve.control_point(i).x() == Q(1e18) - Q(1e15));
  // vertices that are one double
  const Q tiny = Q(1e-30);
  const std::vector<Space::Point> two = {{1, 1, 1}, {Q(1) + tiny, 1, 1}, {2, 1, 1}};
  BOOST_CHECK_EQUAL(check(GC::fit<Space>(two.begin(), two.end(), tolerance), two, 0.02, Closure::open, 1), 1);
}

BOOST_AUTO_TEST_CASE(single_precision) {
  typedef GC::Traits_2<CGAL::Simple_cartesian<float>> Float;
  std::vector<Float::Point> p;
  for (const auto& x : wave(200)) p.emplace_back(float(x.x()), float(x.y()));
  for (const int order : {1, 2}) {
    const auto curve = GC::fit<Float>(p.begin(), p.end(), 0.02f, Closure::open, order);
    std::vector<GC::Bezier_curve<Epick_2>> pieces;
    for (const auto& s : curve.segments()) {
      Points points;
      for (const auto& x : s) points.emplace_back(x.x(), x.y());
      pieces.emplace_back(points.begin(), points.end());
    }
    for (std::size_t k = 0; k + 1 < pieces.size(); ++k)
      BOOST_CHECK_GE(GC::continuity(pieces[k], pieces[k + 1], order).g_order, order);
    BOOST_CHECK_LE(curve.distance, 0.02);
  }
  CHECK_ERROR(GC::fit<Float>(p.begin(), p.end(), 1e-4f), unreachable_tolerance);
}

// Rounded numbers that CGAL knows nothing of give the same curve as those of type double that they
// are.
BOOST_AUTO_TEST_CASE(floating_point_numbers_of_boost) {
  typedef boost::multiprecision::cpp_bin_float_100 Number;
  typedef Plain_traits<Number> Plain;
  const Points p = wave(60);
  std::vector<Plain::Point> same;
  for (const auto& x : p) same.push_back({{Number(x.x()), Number(x.y())}});
  for (const int order : {1, 2}) {
    const double rounded = 0.02 * (1 - 0x1p-40); // the tolerance, whose rounding is not known
    const auto curve = GC::fit<Epick_2>(p.begin(), p.end(), rounded, Closure::open, order);
    const auto plain = GC::fit<Plain>(same.begin(), same.end(), Number(0.02), Closure::open, order);
    BOOST_REQUIRE_EQUAL(plain.control_points().size(), curve.control_points().size());
    for (std::size_t i = 0; i < curve.control_points().size(); ++i)
      for (int x = 0; x < 2; ++x) BOOST_CHECK(plain.control_point(i).x[x] == Number(curve.control_point(i)[x]));
  }
}

BOOST_AUTO_TEST_CASE(errors) {
  typedef Epick_2::Point P;
  const Points p = circle(10);
  const auto points_of = [](const Points& q, Closure closure = Closure::open) {
    GC::fit<Epick_2>(q.begin(), q.end(), 0.01, closure);
  };
  CHECK_ERROR(points_of({}), wrong_number_of_points);
  CHECK_ERROR(points_of({P(1, 1)}), wrong_number_of_points);
  CHECK_ERROR(points_of({P(1, 1), P(1, 1)}), wrong_number_of_points);
  CHECK_ERROR(points_of({P(1, 1), P(2, 1), P(1, 1)}, Closure::closed), wrong_number_of_points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EQUAL(error_of([&] { points_of({P(1, 1), P(2, nan), P(3, 3)}); }), "not_finite: fit: the point 1");
  CHECK_ERROR(points_of({P(1, 1), P(infinity, 1)}), not_finite);
  const auto with = [&](double tolerance, int order = 1, double angle = 45) {
    GC::fit<Epick_2>(p.begin(), p.end(), tolerance, Closure::open, order, angle);
  };
  for (const double tolerance : {0., -1., 1e-14}) CHECK_ERROR(with(tolerance), unreachable_tolerance);
  for (const double tolerance : {nan, infinity}) CHECK_ERROR(with(tolerance), not_finite);
  for (const int order : {-1, 0, 3}) CHECK_ERROR(with(0.1, order), parameter_outside_domain);
  for (const double angle : {-1., 181., nan}) CHECK_ERROR(with(0.1, 1, angle), parameter_outside_domain);
  const Points huge = {P(1e308, 0), P(0, 1e308), P(-1e308, 0)}, tiny = {P(1e-308, 0), P(0, 1e-308)};
  BOOST_CHECK_LE(GC::fit<Epick_2>(huge.begin(), huge.end(), 1e300).distance, 1e300);
  CHECK_ERROR(GC::fit<Epick_2>(tiny.begin(), tiny.end(), 1e-310), unreachable_tolerance);
  const Points zeros(3, P(0, 0));
  for (const Closure closure : {Closure::open, Closure::closed})
    CHECK_ERROR(GC::fit<Epick_2>(zeros.begin(), zeros.end(), 0.1, closure), wrong_number_of_points);
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Any;
  const Q c[] = {1, 2, 3};
  const std::vector<Any::Point> planar = {Any::Point(2, c, c + 2), Any::Point(2, c + 1, c + 3)};
  BOOST_CHECK_EQUAL(GC::fit<Any>(planar.begin(), planar.end(), Q(1)).number_of_segments(), 1);
  const std::vector<Any::Point> mixed = {Any::Point(2, c, c + 2), Any::Point(3, c, c + 3)};
  CHECK_ERROR(GC::fit<Any>(mixed.begin(), mixed.end(), Q(1)), dimension_mismatch);
}

BOOST_AUTO_TEST_SUITE_END()
