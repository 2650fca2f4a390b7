// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Polylines and boxes of curves. That they are near enough, or contain the curve, is checked in
// rational numbers without any square root, on curves with `double` coordinates as well: a double
// is a rational number.

#include "support/random.h"

#include <CGAL/Geometric_continuity/curves/polyline.h>

BOOST_AUTO_TEST_SUITE(polylines)

typedef std::tuple<Exact_2, Exact_3, Exact_d, Double_2, Double_3> All_traits;

template <class Traits> using Curve = GC::Bezier_curve<Traits>;
// always of rational numbers
template <class Traits> using Column = GC::Coordinate_vector<Q, Curve<Traits>::N>;
template <class Traits> constexpr bool is_exact = !std::is_floating_point_v<typename Traits::FT>;
template <class Traits> constexpr int test_dimension = Curve<Traits>::N == 0 ? 4 : Curve<Traits>::N;

template <class Traits> Column<Traits> rational(const typename Traits::Point& p) {
  return GC::coordinates<Traits, Q>(p);
}

template <class Traits> std::vector<Column<Traits>> rational(const std::vector<typename Traits::Point>& points) {
  std::vector<Column<Traits>> result;
  for (const typename Traits::Point& p : points) result.push_back(rational<Traits>(p));
  return result;
}

template <class Traits>
std::vector<typename Traits::Point> points(std::initializer_list<std::initializer_list<double>> rows) {
  std::vector<typename Traits::Point> result;
  for (const std::initializer_list<double>& row : rows) {
    GC::Coordinates<Traits> c(test_dimension<Traits>);
    int i = 0;
    for (double x : row)
      if (i < c.dimension()) c[i++] = typename Traits::FT(x);
    result.push_back(GC::to_point<Traits>(c));
  }
  return result;
}

template <class Traits> Curve<Traits> bezier(std::initializer_list<std::initializer_list<double>> rows) {
  const std::vector<typename Traits::Point> b = points<Traits>(rows);
  return Curve<Traits>(b.begin(), b.end());
}

// The curve itself, in rational numbers: its value at t in [0, 1].
template <class Traits> Column<Traits> exact_value(const Curve<Traits>& c, const Q& t) {
  std::vector<Column<Traits>> rows;
  for (const typename Traits::Point& p : c) rows.push_back(rational<Traits>(p));
  for (int n = c.degree(); n > 0; --n) GC::de_casteljau_step(rows, n, t);
  return rows[0];
}

template <class Column> Q squared_distance(const Column& x, const Column& p, const Column& q) {
  const Column w = q - p;
  const Q ww = dot(w, w);
  Q t = ww == 0 ? Q(0) : Q(dot(Column(x - p), w) / ww);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Column d = x - p - t * w;
  return dot(d, d);
}

template <class Column> Q squared_distance(const Column& x, const std::vector<Column>& polyline) {
  Q least = squared_distance(x, polyline[0], polyline[0]);
  for (std::size_t i = 1; i < polyline.size(); ++i)
    least = (std::min)(least, squared_distance(x, polyline[i - 1], polyline[i]));
  return least;
}

template <class Any_curve>
std::vector<typename Any_curve::Point> chords(const Any_curve& c, const typename Any_curve::FT& tolerance) {
  std::vector<typename Any_curve::Point> result;
  GC::chord_polyline(c, tolerance, std::back_inserter(result));
  return result;
}

// Points of the curve are near the polyline, and points of the polyline near the curve; no two
// vertices in a row are equal.
template <class Traits>
void check_near(const std::vector<Curve<Traits>>& pieces, const std::vector<typename Traits::Point>& vertices,
                const Q& tolerance) {
  const int samples = 32;
  const std::vector<Column<Traits>> polyline = rational<Traits>(vertices);
  std::vector<Column<Traits>> curve;
  Q step = 0; // the squared distance of neighbouring samples
  for (const Curve<Traits>& c : pieces)
    for (int i = 0; i <= samples; ++i) {
      curve.push_back(exact_value<Traits>(c, Q(Q(i) / samples)));
      BOOST_CHECK(squared_distance(curve.back(), polyline) <= tolerance * tolerance);
      if (curve.size() > 1) {
        const Column<Traits> d = curve.back() - curve[curve.size() - 2];
        step = (std::max)(step, dot(d, d));
      }
    }
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    BOOST_CHECK(polyline[i - 1] != polyline[i]);
    const Column<Traits> middle = (polyline[i - 1] + polyline[i]) / Q(2);
    // the polyline of the samples is itself within one step of the curve: (r + s)^2 <= 2 (r^2 +
    // s^2)
    BOOST_CHECK(squared_distance(middle, curve) <= 2 * (tolerance * tolerance + step));
  }
  BOOST_CHECK(polyline.front() == curve.front());
  if constexpr (is_exact<Traits>) BOOST_CHECK(polyline.back() == curve.back());
}

class Random : public Random_integers<> {
public:
  template <class FT> FT number() { return FT(FT(integer(-99999, 99999)) / FT(integer(4999, 9999))); }
  template <class Traits> Curve<Traits> curve(int degree) {
    std::vector<typename Traits::Point> b;
    for (int j = 0; j <= degree; ++j) {
      GC::Coordinates<Traits> c(test_dimension<Traits>);
      for (int i = 0; i < c.dimension(); ++i) c[i] = number<typename Traits::FT>();
      b.push_back(GC::to_point<Traits>(c));
    }
    return Curve<Traits>(b.begin(), b.end());
  }
};

// ---------------------------------------------------------------- polylines by tolerance

TEST_FOR_EACH(random_curves_are_near_their_polylines, Traits, All_traits) {
  Random random;
  for (int degree = 0; degree <= 6; ++degree)
    for (double tolerance : {8.0, 1.0, 1.0 / 16}) {
      const Curve<Traits> c = random.curve<Traits>(degree);
      check_near<Traits>({c}, chords(c, FT(tolerance)), Q(tolerance));
    }
}

TEST_FOR_EACH(bound_is_sharp_for_a_parabola, Traits, All_traits) {
  // y = 4 x (1 - x): over a parameter interval of length h the chord is h^2 below the curve in the
  // middle
  const Curve<Traits> c = bezier<Traits>({{0, 0}, {0.5, 2}, {1, 0}});
  BOOST_CHECK_EQUAL(chords(c, FT(2)).size(), 2u);
  BOOST_CHECK_EQUAL(chords(c, FT(1.001)).size(), 2u);
  if constexpr (is_exact<Traits>) BOOST_CHECK_EQUAL(chords(c, FT(1)).size(), 2u);
  BOOST_CHECK_EQUAL(chords(c, FT(0.999)).size(), 3u);
  const FT fine = FT(1.001 / 1024); // doubles set a little aside for rounding
  BOOST_CHECK(chords(c, fine).size() <= 33u);
  check_near<Traits>({c}, chords(c, fine), Q(fine));
}

TEST_FOR_EACH(straight_lines_have_two_vertices, Traits, All_traits) {
  const FT tolerance = FT(FT(1) / FT(1 << 20));
  BOOST_CHECK_EQUAL(chords(bezier<Traits>({{1, 2, 3}, {5, 4, 7}}), tolerance).size(), 2u);
  // at any speed, with stops
  BOOST_CHECK_EQUAL(
      chords(bezier<Traits>({{0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {7, 14, 21}, {8, 16, 24}}), tolerance).size(), 2u);
  BOOST_CHECK_EQUAL(chords(bezier<Traits>({{0, 0, 0}, {8, 8, 8}, {0, 0, 0}, {8, 8, 8}}), tolerance).size(), 2u);
  // beyond its ends and back: the turning points are vertices up to the tolerance
  const Curve<Traits> back = bezier<Traits>({{0, 0, 0}, {-3, -3, -3}, {0, 0, 0}});
  check_near<Traits>({back}, chords(back, tolerance), Q(Q(1) / (1 << 20)));
  BOOST_CHECK_EQUAL(chords(back, tolerance).size(), 3u);
}

TEST_FOR_EACH(degenerate_curves, Traits, All_traits) {
  const FT tolerance = FT(FT(1) / FT(64));
  const Q exact_tolerance = Q(Q(1) / 64);
  const auto check = [&](const Curve<Traits>& c) { check_near<Traits>({c}, chords(c, tolerance), exact_tolerance); };
  // constant: one vertex
  BOOST_CHECK_EQUAL(chords(bezier<Traits>({{1, 2, 3}}), tolerance).size(), 1u);
  BOOST_CHECK_EQUAL(chords(bezier<Traits>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), tolerance).size(), 1u);
  BOOST_CHECK_EQUAL(chords(bezier<Traits>({{0, 0, 0}, {0, 0, 0}}), tolerance).size(), 1u);
  check(bezier<Traits>({{0, 0}, {1, 1}, {0, 1}, {1, 0}})); // cusp
  // zero derivatives at the start
  check(bezier<Traits>({{0, 0}, {0, 0}, {0, 0}, {3, 1}, {4, 0}}));
  check(bezier<Traits>({{0, 0}, {9, 9}, {-9, 9}, {0, 0}})); // closed: its chord is a point
  // through its start again half way
  check(bezier<Traits>({{0, 0}, {8, 8}, {0, 0}, {-8, -8}, {0, 0}}));
  check(bezier<Traits>({{0, 0}, {3, 0}, {-3, 0}, {0, 0}})); // closed and straight
  const std::vector<typename Traits::Point> loop = chords(bezier<Traits>({{0, 0}, {9, 9}, {-9, 9}, {0, 0}}), tolerance);
  BOOST_CHECK(rational<Traits>(loop.front()) == rational<Traits>(loop.back()));
  BOOST_CHECK(loop.size() > 10);
}

TEST_FOR_EACH(composite_curves, Traits, All_traits) {
  // closed, with a constant segment and a straight one
  const std::vector<typename Traits::Point> b = points<Traits>(
      {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {4, 0}, {4, 0}, {4, 0}, {5, 0}, {6, 0}, {8, 0}, {6, -3}, {1, -4}, {0, 0}});
  const GC::Composite_bezier_curve<Traits> c(b.begin(), b.end(), {FT(0), FT(1), FT(2), FT(5), FT(6)});
  const std::vector<typename Traits::Point> vertices = chords(c, FT(FT(1) / FT(128)));
  std::vector<Curve<Traits>> pieces(c.segments().begin(), c.segments().end());
  check_near<Traits>(pieces, vertices, Q(Q(1) / 128));
  BOOST_CHECK(rational<Traits>(vertices.front()) == rational<Traits>(vertices.back()));
  int on_line = 0;
  for (const Column<Traits>& x : rational<Traits>(vertices)) on_line += x[1] == 0 && x[0] >= 4;
  BOOST_CHECK_EQUAL(on_line, 2);
}

TEST_FOR_EACH(bspline_curves, Traits, All_traits) {
  const std::vector<typename Traits::Point> b =
      points<Traits>({{0, 0, 1}, {1, 5, 2}, {4, 4, 0}, {3, -1, 3}, {8, 2, 1}, {6, 6, 2}, {7, 1, 1}});
  // not clamped, with a double knot
  const GC::Knot_vector<FT> knots(3, {FT(0), FT(1), FT(2), FT(3), FT(4), FT(4), FT(6), FT(7), FT(8), FT(9), FT(10)});
  const GC::Bspline_curve<Traits> c(b.begin(), b.end(), knots);
  check_near<Traits>(c.bezier_pieces(), chords(c, FT(FT(1) / FT(64))), Q(Q(1) / 64));

  // a knot of multiplicity p + 1 is allowed where the curve does not jump
  std::vector<typename Traits::Point> halves = points<Traits>({{0, 0}, {1, 3}, {2, 0}, {2, 0}, {3, -3}, {4, 0}});
  const GC::Knot_vector<FT> triple(2, {FT(0), FT(0), FT(0), FT(1), FT(1), FT(1), FT(2), FT(2), FT(2)});
  const GC::Bspline_curve<Traits> meets(halves.begin(), halves.end(), triple);
  check_near<Traits>(meets.bezier_pieces(), chords(meets, FT(FT(1) / FT(64))), Q(Q(1) / 64));
  halves[3] = points<Traits>({{2, 1}})[0];
  const GC::Bspline_curve<Traits> jumps(halves.begin(), halves.end(), triple);
  CHECK_ERROR(chords(jumps, FT(1)), curves_do_not_meet);
}

BOOST_AUTO_TEST_CASE(doubles_keep_the_tolerance_with_all_roundings) {
  // far from the origin, with the smallest tolerance that is accepted: (m + 1) 2^-42 times the
  // largest coordinate
  Random random;
  for (int degree : {2, 3, 7, 12}) {
    const Double_2::FT far = 1 << 20;
    std::vector<Double_2::Point> b;
    for (int j = 0; j <= degree; ++j)
      b.push_back({far + random.integer(-99, 99) / 1e6, far + random.integer(-99, 99) / 1e6});
    const Curve<Double_2> c(b.begin(), b.end());
    const double least = (degree + 1) * 0x1p-42 * (far + 1);
    check_near<Double_2>({c}, chords(c, least), Q(least));
    CHECK_ERROR(chords(c, 0.5 * least), unreachable_tolerance);
  }
  // squares of these lengths are not doubles
  for (double scale : {1e-200, 1e200}) {
    const Curve<Double_2> c = bezier<Double_2>({{0, 0}, {scale, 2 * scale}, {3 * scale, 2 * scale}, {4 * scale, 0}});
    const std::vector<Double_2::Point> vertices = chords(c, scale / 64);
    BOOST_CHECK_EQUAL(vertices.size(), chords(bezier<Double_2>({{0, 0}, {1, 2}, {3, 2}, {4, 0}}), 1.0 / 64).size());
    check_near<Double_2>({c}, vertices, Q(scale / 64));
  }
  const double huge = (std::numeric_limits<double>::max)();
  const Curve<Double_2> c = bezier<Double_2>({{-huge, 0}, {huge, huge}, {-huge, huge}, {huge, 0}});
  check_near<Double_2>({c}, chords(c, huge / 16), Q(huge / 16));
}

TEST_FOR_EACH(tolerances_that_are_refused, Traits, All_traits) {
  const Curve<Traits> c = bezier<Traits>({{0, 0}, {1, 2}, {3, 2}});
  CHECK_ERROR(chords(c, FT(0)), unreachable_tolerance);
  CHECK_ERROR(chords(c, FT(-1)), unreachable_tolerance);
  std::vector<typename Traits::Point> out;
  CHECK_ERROR(GC::chord_polyline(c, FT(1), FT(0), std::back_inserter(out)), unreachable_tolerance);
  CHECK_ERROR(GC::chord_polyline(c, FT(-1), FT(1), std::back_inserter(out)), unreachable_tolerance);
  CHECK_ERROR(GC::chord_polyline(c, FT(1e30), FT(1e-30), std::back_inserter(out)), unreachable_tolerance);
  CHECK_ERROR(GC::uniform_polyline(c, 0, std::back_inserter(out)), wrong_number_of_points);
  if constexpr (!is_exact<Traits>) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_ERROR(chords(c, infinity), not_finite);
    CHECK_ERROR(chords(c, nan), not_finite);
    CHECK_ERROR(chords(c, 1e-20), unreachable_tolerance);
    CHECK_ERROR(GC::chord_polyline(c, nan, 1.0, std::back_inserter(out)), not_finite);
    CHECK_ERROR(GC::chord_polyline(c, 1.0, infinity, std::back_inserter(out)), not_finite);
  }
  BOOST_CHECK(out.empty());
}

// ------------------------------------------------------------- polylines by number, and by a bound

TEST_FOR_EACH(equal_parts, Traits, All_traits) {
  const Curve<Traits> c = bezier<Traits>({{0, 0, 0}, {1, 2, 4}, {4, 0, 8}}).with_domain(FT(2), FT(4));
  std::vector<typename Traits::Point> out;
  GC::uniform_polyline(c, 4, std::back_inserter(out));
  BOOST_REQUIRE_EQUAL(out.size(), 5u);
  for (int i = 0; i <= 4; ++i) BOOST_CHECK(out[i] == c(FT(FT(2) + FT(i) / FT(2))));
  out.clear();
  GC::uniform_polyline(bezier<Traits>({{1, 1}, {1, 1}}), 7, std::back_inserter(out));
  BOOST_CHECK_EQUAL(out.size(), 1u);
}

TEST_FOR_EACH(bounded_second_derivative, Traits, All_traits) {
  // |x''| = 8 in the parameter of [0, 1], 8/9 in that of [0, 3]
  const Curve<Traits> c = bezier<Traits>({{0, 0}, {0.5, 2}, {1, 0}}).with_domain(FT(0), FT(3));
  for (int n : {1, 2, 3, 7, 100}) {
    const FT tolerance = FT(FT(1) / FT(n * n)), enough = FT(tolerance * FT(1 + 1e-9)),
             little = FT(tolerance * FT(1 - 1e-9));
    std::vector<typename Traits::Point> out;
    GC::chord_polyline(c, FT(FT(8) / FT(9)), enough, std::back_inserter(out));
    BOOST_CHECK_EQUAL(out.size(), n + 1u);
    check_near<Traits>({c}, out, Q(enough));
    out.clear();
    GC::chord_polyline(c, FT(FT(8) / FT(9)), little, std::back_inserter(out));
    BOOST_CHECK_EQUAL(out.size(), n + 2u);
  }
  std::vector<typename Traits::Point> out; // a straight line
  GC::chord_polyline(bezier<Traits>({{0, 0}, {1, 1}}), FT(0), FT(1), std::back_inserter(out));
  BOOST_CHECK_EQUAL(out.size(), 2u);
}

// ---------------------------------------------------------------- boxes

template <class Traits, class Any_curve>
void check_boxes(const Any_curve& c, const std::vector<Curve<Traits>>& pieces, int k) {
  typedef typename Traits::FT FT;
  typedef GC::Curve_piece_box<Traits, int> Box;
  std::vector<Box> boxes;
  GC::bounding_boxes(c, k, 42, std::back_inserter(boxes));
  BOOST_REQUIRE_EQUAL(boxes.size(), pieces.size() << k);
  BOOST_CHECK(boxes.front().interval().first == c.domain().first &&
              boxes.back().interval().second == c.domain().second);
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Box& box = boxes[b];
    BOOST_CHECK(box.handle() == 42 && box.id() == typename Box::ID(42, static_cast<int>(b)));
    if (b > 0) BOOST_CHECK(boxes[b - 1].interval().second == box.interval().first);
    const Curve<Traits>& piece = pieces[b >> k];
    const std::pair<FT, FT> domain = piece.domain();
    const Q first = Q(Q(box.interval().first - domain.first) / Q(domain.second - domain.first)),
            last = Q(Q(box.interval().second - domain.first) / Q(domain.second - domain.first));
    BOOST_CHECK(Q(last - first) == Q(Q(1) / (1 << k)));
    for (int i = 0; i <= 8; ++i) {
      const Column<Traits> x = exact_value<Traits>(piece, Q(first + (last - first) * i / 8));
      for (int j = 0; j < Box::dimension(); ++j) {
        BOOST_CHECK(Q(box.min_coord(j)) <= x[j] && x[j] <= Q(box.max_coord(j)));
        BOOST_CHECK(box.bbox().min(j) == box.min_coord(j) && box.bbox().max(j) == box.max_coord(j));
      }
    }
  }
}

typedef std::tuple<Exact_2, Exact_3, Double_2, Double_3> Traits_with_boxes;

TEST_FOR_EACH(boxes_contain_their_pieces, Traits, Traits_with_boxes) {
  Random random;
  for (int degree = 0; degree <= 5; ++degree)
    for (int k : {0, 1, 3}) {
      const Curve<Traits> c = random.curve<Traits>(degree);
      check_boxes<Traits>(c, {c}, k);
    }
  const std::vector<typename Traits::Point> b =
      points<Traits>({{0, 0}, {1, 2}, {3, 2}, {4, 0}, {4, 0}, {4, 0}, {0, 0}});
  const GC::Composite_bezier_curve<Traits> c(b.begin(), b.end(), {FT(0), FT(1), FT(5)});
  check_boxes<Traits>(c, std::vector<Curve<Traits>>(c.segments().begin(), c.segments().end()), 2);
  const GC::Bspline_curve<Traits> spline(
      b.begin(), b.end() - 1, GC::Knot_vector<FT>(2, {FT(0), FT(1), FT(2), FT(4), FT(5), FT(6), FT(7), FT(7), FT(9)}));
  check_boxes<Traits>(spline, spline.bezier_pieces(), 2);
}

BOOST_AUTO_TEST_CASE(boxes_are_tight) {
  // its highest point is (1/2, 1)
  const Curve<Exact_2> parabola = bezier<Exact_2>({{0, 0}, {0.5, 2}, {1, 0}});
  for (int k = 1; k <= 8; ++k) {
    std::vector<GC::Curve_piece_box<Exact_2, const Curve<Exact_2>*>> boxes;
    GC::bounding_boxes(parabola, k, &parabola, std::back_inserter(boxes));
    CGAL::Bbox_2 all;
    double area = 0;
    for (const auto& box : boxes) {
      all += box.bbox();
      area += (box.max_coord(0) - box.min_coord(0)) * (box.max_coord(1) - box.min_coord(1));
    }
    BOOST_CHECK(all == CGAL::Bbox_2(0, 0, 1, 1));
    BOOST_CHECK_EQUAL(area, 2.0 / (1 << k)); // 2^k boxes of width 2^-k whose heights sum to 2
  }
  // numbers that are not doubles are rounded outwards
  const Exact_2::Point third(Q(1) / 3, Q(-1) / 3);
  std::vector<GC::Curve_piece_box<Exact_2, int>> boxes;
  GC::bounding_boxes(Curve<Exact_2>{third}, 0, 0, std::back_inserter(boxes));
  BOOST_CHECK(Q(boxes[0].min_coord(0)) < third.x() && third.x() < Q(boxes[0].max_coord(0)));
  BOOST_CHECK(Q(boxes[0].min_coord(1)) < third.y() && third.y() < Q(boxes[0].max_coord(1)));
  BOOST_CHECK(std::nextafter(boxes[0].min_coord(0), 1) == boxes[0].max_coord(0));
}

BOOST_AUTO_TEST_CASE(numbers_of_halvings_that_are_refused) {
  std::vector<GC::Curve_piece_box<Exact_2, int>> boxes;
  const Curve<Exact_2> c = bezier<Exact_2>({{0, 0}, {1, 1}});
  CHECK_ERROR(GC::bounding_boxes(c, -1, 0, std::back_inserter(boxes)), negative_count);
  CHECK_ERROR(GC::bounding_boxes(c, 21, 0, std::back_inserter(boxes)), work_limit);
  BOOST_CHECK(boxes.empty());
}

BOOST_AUTO_TEST_SUITE_END()
