// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Segmented curves and the analysis of chains. Rounded kernels run the same tests as exact ones, on dyadic numbers where
// every intermediate result is a double.

#define BOOST_TEST_DYN_LINK
#define BOOST_TEST_MODULE composite
#include <boost/test/unit_test.hpp>

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/Traits_d.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/polygon_invariants.h>
#include <CGAL/Geometric_continuity/extensions/extend.h>
#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;
typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
typedef GC::Traits_d<CGAL::Cartesian_d<double>> Double_d;
typedef GC::Traits_3<Epick> Epick_3;
typedef std::tuple<Exact_2, Exact_3, Exact_d, Double_2, Double_3, Double_d, Epick_3> All_traits;

template <class Traits> using Composite = GC::Composite_bezier_curve<Traits>;
template <class Traits> using Bezier = GC::Bezier_curve<Traits>;
template <class Traits> using Column = GC::Coordinates<Traits>;
typedef GC::Continuity_kind Kind;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

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

class Random {
  std::mt19937 engine_{20261};

public:
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

  // a rational number, or a small multiple of 1/4
  template <class FT> FT number() {
    return std::is_floating_point_v<FT> ? ratio<FT>(integer(-8, 8), 4) : ratio<FT>(integer(-99, 99), integer(1, 99));
  }
  // a rational number in (0, 1), or a multiple of 1/8
  template <class FT> FT fraction() {
    const int q = std::is_floating_point_v<FT> ? 8 : integer(2, 99);
    return ratio<FT>(integer(1, q - 1), q);
  }
  // positive, or a power of 2
  template <class FT> FT length() {
    return std::is_floating_point_v<FT> ? ratio<FT>(1 << integer(0, 3), 4) : ratio<FT>(integer(1, 99), integer(1, 99));
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

template <class T> std::string text(const T& x) {
  std::ostringstream os;
  os << x;
  return os.str();
}

} // namespace

// --------------------------------------------------------------------------------------------- Hagen, definition 3.1

BOOST_AUTO_TEST_CASE_TEMPLATE(evaluation_by_the_definition, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  for (int m = 0; m <= 4; ++m)
    for (int segments = 1; segments <= (m == 0 ? 1 : 4); ++segments) {
      const Composite<Traits> c = random.curve<Traits>(m, segments);
      BOOST_CHECK_EQUAL(c.degree(), m);
      BOOST_CHECK_EQUAL(c.dimension(), test_dimension<Traits>);
      BOOST_CHECK_EQUAL(c.number_of_segments(), segments);
      BOOST_CHECK(c.domain() == std::make_pair(c.knots().front(), c.knots().back()));
      for (int l = 0; l < segments; ++l) {
        const FT t = random.fraction<FT>(), s = FT(1) - t, u = inside<Traits>(c, l, t);
        Column<Traits> sum(c.dimension());
        FT binomial(1); // sum_i b_{ml+i} B_i^m(t)
        for (int i = 0; i <= m; ++i) {
          FT weight = binomial;
          for (int j = 0; j < m; ++j) weight *= j < i ? t : s;
          sum += weight * c.coordinates(m * l + i);
          binomial = FT(binomial * FT(m - i) / FT(i + 1));
        }
        BOOST_CHECK(column<Traits>(c(u)) == sum);
        BOOST_CHECK(c.jet(u, 0)[0] == sum);
        BOOST_CHECK_EQUAL(c.segment_at(u), l);
      }
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_on_both_sides_of_a_knot, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  for (int m = 3; m <= 5; ++m) {
    const Composite<Traits> c = random.curve<Traits>(m, 3);
    for (int l = 0; l < 2; ++l) {
      const auto b = [&](int i) { return c.coordinates(m * (l + 1) + i); };
      const FT x = c.lambda(l), y = c.lambda(l + 1), u = c.knots()[l + 1];
      const FT m1(m), m2(m * (m - 1)), m3(m * (m - 1) * (m - 2));
      const GC::Curve_jet<Traits> left = c.left_jet(u, 3), right = c.right_jet(u, 3);
      BOOST_CHECK(left[0] == b(0));
      BOOST_CHECK(left[1] == FT(m1 / x) * (b(0) - b(-1)));
      BOOST_CHECK(left[2] == FT(m2 / (x * x)) * (b(0) - FT(2) * b(-1) + b(-2)));
      BOOST_CHECK(left[3] == FT(m3 / (x * x * x)) * (b(0) - FT(3) * b(-1) + FT(3) * b(-2) - b(-3)));
      BOOST_CHECK(right[0] == b(0));
      BOOST_CHECK(right[1] == FT(m1 / y) * (b(1) - b(0)));
      BOOST_CHECK(right[2] == FT(m2 / (y * y)) * (b(2) - FT(2) * b(1) + b(0)));
      BOOST_CHECK(right[3] == FT(m3 / (y * y * y)) * (b(3) - FT(3) * b(2) + FT(3) * b(1) - b(0)));
      BOOST_CHECK(c.jet(u, 3) == right);
      BOOST_CHECK(column<Traits>(c(u)) == b(0));
      BOOST_CHECK_EQUAL(c.segment_at(u), l + 1);
      BOOST_CHECK_EQUAL(c.segment_at(u, false), l);
    }
    // there is one side only at the ends, and the right end belongs to the domain
    const FT first = c.domain().first, last = c.domain().second;
    BOOST_CHECK(c.left_jet(first, 3) == c.segment(0).start_jet(3));
    BOOST_CHECK(c.jet(first, 3) == c.segment(0).start_jet(3));
    BOOST_CHECK(c.jet(last, 3) == c.segment(2).end_jet(3));
    BOOST_CHECK(c.left_jet(last, 3) == c.segment(2).end_jet(3));
    BOOST_CHECK(c.template start_jet_over<FT>(3) == c.jet(first, 3));
    BOOST_CHECK(c.template end_jet_over<FT>(3) == c.jet(last, 3));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(parameters_outside_the_domain, Traits, All_traits) {
  typedef typename Traits::FT FT;
  const Composite<Traits> c = composite<Traits>({{0}, {1}, {2}, {3}, {4}}, {1, 2, 4});
  std::vector<FT> bad = {ratio<FT>(999, 1000), ratio<FT>(4001, 1000)};
  if constexpr (!is_exact<Traits>) bad.push_back(std::numeric_limits<double>::quiet_NaN());
  for (const FT& u : bad) {
    CHECK_ERROR(c(u), parameter_outside_domain);
    CHECK_ERROR(c.jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.left_jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.right_jet(u, 2), parameter_outside_domain);
    CHECK_ERROR(c.segment_at(u), parameter_outside_domain);
    CHECK_ERROR(c.insert_knot(u), parameter_outside_domain);
    CHECK_ERROR(c.split(u), parameter_outside_domain);
  }
  CHECK_ERROR(c.split(FT(1)), parameter_outside_domain);
  CHECK_ERROR(c.split(FT(4)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(0), FT(2)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(2), FT(5)), parameter_outside_domain);
  CHECK_ERROR(c.subrange(FT(2), FT(2)), empty_domain);
  CHECK_ERROR(c.subrange(FT(3), FT(2)), empty_domain);
  CHECK_ERROR(c.segment_range(-1, 1), parameter_outside_domain);
  CHECK_ERROR(c.segment_range(1, 1), parameter_outside_domain);
  CHECK_ERROR(c.segment_range(0, 3), parameter_outside_domain);
}

// ------------------------------------------------------------------------------------------------------ construction

BOOST_AUTO_TEST_CASE_TEMPLATE(bad_points_and_knots, Traits, All_traits) {
  typedef typename Traits::FT FT;
  const std::vector<typename Traits::Point> b = points<Traits>({{0}, {1}, {2}, {3}, {4}, {5}, {6}});
  const auto make = [&](int n, std::initializer_list<int> knots) {
    return Composite<Traits>(b.begin(), b.begin() + n, numbers<FT>(knots));
  };
  BOOST_CHECK_EQUAL(make(7, {0, 1, 2}).degree(), 3);
  BOOST_CHECK_EQUAL(make(7, {0, 1, 2, 3}).degree(), 2);
  BOOST_CHECK_EQUAL(make(1, {0, 1}).degree(), 0);
  CHECK_ERROR(make(6, {0, 1, 2}), wrong_number_of_points);
  CHECK_ERROR(make(0, {0, 1}), wrong_number_of_points);
  CHECK_ERROR(make(7, {0}), empty_domain);
  CHECK_ERROR(make(7, {}), empty_domain);
  CHECK_ERROR(make(7, {0, 1, 1}), empty_domain);
  CHECK_ERROR(make(7, {0, 2, 1}), empty_domain);
  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
  BOOST_CHECK_EQUAL(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2})).degree(), 3);
  CHECK_ERROR(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2, 3})), wrong_number_of_points);
  if constexpr (!is_exact<Traits>) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, 1, inf}), not_finite);
    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, nan, 2}), not_finite);
    Column<Traits> x(test_dimension<Traits>);
    x[1] = inf;
    std::vector<typename Traits::Point> bad = b;
    bad[2] = GC::to_point<Traits>(x);
    CHECK_ERROR(Composite<Traits>(bad.begin(), bad.end(), {0, 1, 2}), not_finite);
  }
}

BOOST_AUTO_TEST_CASE(points_of_different_dimensions) {
  typedef Exact_d::Point Point;
  const std::vector<Q> x(3, Q(0));
  const std::vector<Point> b = {Point(3, x.begin(), x.end()), Point(2, x.begin(), x.begin() + 2)};
  CHECK_ERROR(Composite<Exact_d>(b.begin(), b.end(), numbers<Q>({0, 1})), dimension_mismatch);
  const std::vector<Bezier<Exact_d>> curves = {Bezier<Exact_d>(b.begin(), b.begin() + 1),
                                               Bezier<Exact_d>(b.begin() + 1, b.end())};
  CHECK_ERROR(Composite<Exact_d>(curves.begin(), curves.end()), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(from_curves_that_meet, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  const std::vector<Bezier<Traits>> parts(c.segments().begin(), c.segments().end());
  BOOST_REQUIRE_EQUAL(parts.size(), 4);
  for (int l = 0; l < 4; ++l) BOOST_CHECK(parts[l] == c.segment(l));
  BOOST_CHECK(Composite<Traits>(parts.begin(), parts.end()) == c);

  // the domains keep their lengths and are moved to follow each other
  std::vector<Bezier<Traits>> moved = parts;
  for (int l = 1; l < 4; ++l) moved[l] = parts[l].with_domain(FT(l), FT(FT(l) + c.lambda(l)));
  BOOST_CHECK(Composite<Traits>(moved.begin(), moved.end()) == c);

  // lower degrees are elevated
  std::vector<Bezier<Traits>> mixed = {random.curve<Traits>(1, 1).segment(0), random.curve<Traits>(4, 1).segment(0),
                                       random.curve<Traits>(2, 1).segment(0)};
  for (int l = 1; l < 3; ++l) {
    std::vector<typename Traits::Point> b(mixed[l].begin(), mixed[l].end());
    b.front() = mixed[l - 1].control_points().back();
    const FT a = mixed[l - 1].domain().second;
    mixed[l] = Bezier<Traits>(b.begin(), b.end(), a, FT(a + FT(1)));
  }
  const Composite<Traits> d(mixed.begin(), mixed.end());
  BOOST_CHECK_EQUAL(d.degree(), 4);
  BOOST_CHECK_EQUAL(d.number_of_segments(), 3);
  for (int l = 0; l < 3; ++l) {
    const FT u = inside<Traits>(d, l, ratio<FT>(1, 2));
    if constexpr (is_exact<Traits>)
      BOOST_CHECK(d.jet(u, 4) == mixed[l].jet(u, 4));
    else // elevation divides by 2, 3 and 4; the coordinates are below 2, and few roundings of 2^-53 are made
      for (int i = 0; i < d.dimension(); ++i) BOOST_CHECK_SMALL(d.jet(u, 0)[0][i] - mixed[l].jet(u, 0)[0][i], 1e-14);
  }
  typedef GC::Composite_bezier_curve<Traits, 5> Quintic;
  BOOST_CHECK_EQUAL(Quintic(mixed.begin(), mixed.end()).degree(), 5);
  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
  CHECK_ERROR(Cubic(mixed.begin(), mixed.end()), wrong_number_of_points);
  BOOST_CHECK(Composite<Traits>(Cubic(parts.begin(), parts.end())) == c);
  BOOST_CHECK(Cubic(c).segment(1) == (GC::Bezier_curve<Traits, 3>(parts[1])));
  CHECK_ERROR(Cubic(d), wrong_number_of_points);

  CHECK_ERROR(Composite<Traits>(parts.begin(), parts.begin()), wrong_number_of_points);
  std::vector<Bezier<Traits>> apart = {parts[0], parts[2]};
  CHECK_ERROR(Composite<Traits>(apart.begin(), apart.end()), curves_do_not_meet);
}

BOOST_AUTO_TEST_CASE(adjacent_domains_are_not_rounded) {
  typedef Double_2::Point Point;
  const double a = -0.1, b = 0.2;
  BOOST_REQUIRE(a + (b - a) != b);
  const std::vector<Bezier<Double_2>> curves = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(-1, a),
                                                Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(a, b)};
  BOOST_CHECK(Composite<Double_2>(curves.begin(), curves.end()).knots() == std::vector<double>({-1, a, b}));
  // a length that vanishes beside the knot before it is refused
  const std::vector<Bezier<Double_2>> tiny = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(0, 1),
                                              Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(0, 1e-20)};
  CHECK_ERROR(Composite<Double_2>(tiny.begin(), tiny.end()), empty_domain);
}

// --------------------------------------------------------------------------------------------------------- iteration

BOOST_AUTO_TEST_CASE_TEMPLATE(segments_and_joins, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  for (bool closed : {false, true})
    for (int segments = 1; segments <= 3; ++segments) {
      const Composite<Traits> c = random.curve<Traits>(2, segments, closed);
      BOOST_CHECK_EQUAL(c.is_closed(), closed);
      int l = 0;
      for (const Bezier<Traits>& s : c.segments()) {
        BOOST_CHECK(s == c.segment(l));
        BOOST_CHECK(s.domain() == std::make_pair(c.knots()[l], c.knots()[l + 1]));
        BOOST_CHECK_EQUAL(c.lambda(l), FT(c.knots()[l + 1] - c.knots()[l]));
        for (int i = 0; i <= 2; ++i) BOOST_CHECK(s.coordinates(i) == c.coordinates(2 * l + i));
        ++l;
      }
      BOOST_CHECK_EQUAL(l, segments);
      int n = 0;
      for (const typename Composite<Traits>::Join& join : c.joins()) {
        BOOST_CHECK_EQUAL(join.left, n);
        BOOST_CHECK_EQUAL(join.right, n + 1 < segments ? n + 1 : 0);
        BOOST_CHECK_EQUAL(c.ratio(join), FT(c.lambda(join.right) / c.lambda(join.left)));
        ++n;
      }
      BOOST_CHECK_EQUAL(n, closed ? segments : segments - 1);
      BOOST_CHECK_EQUAL(c.number_of_joins(), n);
    }
}

// ------------------------------------------------------------------------------------------------------ other curves

BOOST_AUTO_TEST_CASE_TEMPLATE(a_knot_is_inserted, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  for (int m = 0; m <= 3; ++m) {
    const int segments = m == 0 ? 1 : 3;
    const Composite<Traits> c = random.curve<Traits>(m, segments);
    for (const FT& u : c.knots()) BOOST_CHECK(c.insert_knot(u) == c);
    for (int l = 0; l < segments; ++l) {
      const FT u = inside<Traits>(c, l, is_exact<Traits> ? random.fraction<FT>() : ratio<FT>(1, 2));
      const Composite<Traits> d = c.insert_knot(u);
      std::vector<FT> knots = c.knots();
      knots.insert(knots.begin() + l + 1, u);
      BOOST_CHECK(d.knots() == knots);
      BOOST_CHECK_EQUAL(d.degree(), m);
      BOOST_CHECK(column<Traits>(d(u)) == column<Traits>(c(u)));
      BOOST_CHECK(d.left_jet(u, m) == d.right_jet(u, m));
      BOOST_CHECK(same_function<Traits>(c, d, random));
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(parts, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j <= 4; ++j) {
      const Composite<Traits> part = c.segment_range(i, j);
      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i);
      for (int l = i; l < j; ++l) BOOST_CHECK(part.segment(l - i) == c.segment(l));
      BOOST_CHECK(part == c.subrange(c.knots()[i], c.knots()[j]));
    }
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j) {
      const FT u = inside<Traits>(c, i, ratio<FT>(1, 2)),
               v = inside<Traits>(c, j, i == j ? ratio<FT>(3, 4) : ratio<FT>(1, 2));
      const Composite<Traits> part = c.subrange(u, v);
      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i + 1);
      BOOST_CHECK(part.domain() == std::make_pair(u, v));
      BOOST_CHECK(part.left_jet(v, 3) == c.left_jet(v, 3));
      for (int l = 0; l <= j - i; ++l) {
        const FT w = inside<Traits>(part, l, ratio<FT>(1, 2));
        BOOST_CHECK(part.jet(w, 3) == c.jet(w, 3));
      }
    }
  const FT u = inside<Traits>(c, 2, ratio<FT>(1, 4));
  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(u);
  BOOST_CHECK(halves.first == c.subrange(c.domain().first, u));
  BOOST_CHECK(halves.second == c.subrange(u, c.domain().second));
  std::vector<Bezier<Traits>> all(halves.first.segments().begin(), halves.first.segments().end());
  for (const Bezier<Traits>& s : halves.second.segments()) all.push_back(s);
  BOOST_CHECK(Composite<Traits>(all.begin(), all.end()) == c.insert_knot(u));
  const std::pair<Composite<Traits>, Composite<Traits>> at_knot = c.split(c.knots()[1]);
  BOOST_CHECK(at_knot.first == c.segment_range(0, 1) && at_knot.second == c.segment_range(1, 4));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(run_through_backwards, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 3), r = c.reverse();
  BOOST_CHECK(r.domain() == c.domain());
  BOOST_CHECK(r.reverse() == c);
  for (int l = 0; l < 3; ++l) BOOST_CHECK_EQUAL(r.lambda(l), c.lambda(2 - l));
  const FT sum = c.domain().first + c.domain().second;
  for (const FT& u : {inside<Traits>(c, 1, ratio<FT>(1, 4)), c.knots()[1], c.knots()[0], c.knots()[3]}) {
    const GC::Curve_jet<Traits> x = c.right_jet(u, 3), y = r.left_jet(FT(sum - u), 3);
    for (int j = 0; j <= 3; ++j) BOOST_CHECK(y[j] == FT(j % 2 == 0 ? 1 : -1) * x[j]);
  }
}

BOOST_AUTO_TEST_CASE(reversal_of_rounded_knots) {
  typedef Double_2::Point Point;
  const std::vector<Point> b = {Point(0, 0), Point(1, 0), Point(1, 1)};
  const double x = -0.1, y = 0.2;
  BOOST_REQUIRE(x + (y - x) != y);
  for (double u : {-0.05, 0.03, 0.07, 0.19}) {
    const Composite<Double_2> r = Composite<Double_2>(b.begin(), b.end(), {x, u, y}).reverse();
    BOOST_CHECK(r.domain() == std::make_pair(x, y));
    BOOST_CHECK_SMALL(r.knots()[1] - (x + y - u), 1e-15); // at most four roundings of numbers below 1
  }
  CHECK_ERROR(Composite<Double_2>(b.begin(), b.end(), {0, 1e-20, 1}).reverse(), empty_domain);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(values, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  const Composite<Traits> c = random.curve<Traits>(2, 3);
  Composite<Traits> d = c;
  BOOST_CHECK(c == d);
  d = c.insert_knot(inside<Traits>(c, 0, ratio<FT>(1, 2)));
  BOOST_CHECK(c != d);
  std::vector<FT> knots = c.knots();
  knots.back() += FT(1);
  BOOST_CHECK(c != Composite<Traits>(c.begin(), c.end(), knots));
  std::vector<typename Traits::Point> b(c.begin(), c.end());
  std::swap(b[1], b[3]);
  BOOST_CHECK(c != Composite<Traits>(b.begin(), b.end(), c.knots()));

  const Column<Traits> shift = random.column<Traits>();
  const auto map = [&](const typename Traits::Point& p) {
    return GC::to_point<Traits>(FT(2) * column<Traits>(p) + shift);
  };
  const Composite<Traits> image = c.transform(map);
  BOOST_CHECK(image.knots() == c.knots());
  const FT u = inside<Traits>(c, 1, ratio<FT>(1, 2));
  BOOST_CHECK(column<Traits>(image(u)) == FT(2) * column<Traits>(c(u)) + shift);
}

BOOST_AUTO_TEST_CASE(output) {
  const Composite<Exact_2> c = composite<Exact_2>({{0, 0}, {1, 2}, {3, 4}}, {0, 1, 3});
  BOOST_CHECK_EQUAL(text(c), "Bezier curve of degree 1 on [0, 1]: (0, 0) (1, 2)\n"
                             "Bezier curve of degree 1 on [1, 3]: (1, 2) (3, 4)\n");
  GC::Chain_summary summary;
  BOOST_CHECK_EQUAL(text(summary), "0 joins");
  GC::Join_continuity<Q> join;
  join.c_order = 0;
  join.g_order = 3;
  join.f_order = 2;
  summary.add(join);
  BOOST_CHECK_EQUAL(text(summary), "1 join, C0 G3 F2 or more");
  join.c_order = join.g_order = join.f_order = -1;
  summary.add(join);
  BOOST_CHECK_EQUAL(text(summary), "2 joins, 1 with a gap");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_segmented_curve_is_a_parametric_curve, Traits, All_traits) {
  typedef typename Traits::FT FT;
  Random random;
  const Composite<Traits> c = random.curve<Traits>(3, 4);
  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(inside<Traits>(c, 1, ratio<FT>(1, 2)));
  const auto join = GC::continuity(halves.first, halves.second);
  BOOST_CHECK_EQUAL(join.c_order, 3);
  BOOST_CHECK_EQUAL(GC::continuity(c, c).c_order, -1);
}

// ------------------------------------------------------------------------------------------------------------ chains

namespace {

// Curves of which each starts where the one before it ends but for some gaps, with joins of all kinds.
template <class Traits> std::vector<Bezier<Traits>> random_chain(Random& random, int n) {
  typedef typename Traits::FT FT;
  std::vector<Bezier<Traits>> chain(1, random.curve<Traits>(3, 1).segment(0));
  while (static_cast<int>(chain.size()) < n) {
    const Bezier<Traits>& last = chain.back();
    std::vector<Column<Traits>> b;
    for (int i = 0; i < 4; ++i) b.push_back(random.column<Traits>());
    const int order = random.integer(-1, 3);
    const FT beta(random.integer(1, 2)), c0(random.integer(0, 9));
    const Column<Traits> p = last.coordinates(3) - last.coordinates(2);
    if (order >= 0) b[0] = last.coordinates(3);
    if (order >= 1) b[1] = b[0] + beta * p;
    if (order >= 2) b[2] = b[0] + FT(beta * beta) * (last.coordinates(1) - b[0]) + c0 * p;
    std::vector<typename Traits::Point> points;
    for (const Column<Traits>& x : b) points.push_back(GC::to_point<Traits>(x));
    chain.push_back(Bezier<Traits>(points.begin(), points.end()));
  }
  return chain;
}

template <class Join> bool same_join(const Join& x, const Join& y) {
  return x.c_order == y.c_order && x.g_order == y.g_order && x.f_order == y.f_order && x.betas == y.betas &&
         x.curvature_equal == y.curvature_equal && x.torsion_equal == y.torsion_equal;
}

// A curve that counts its copies.
struct Counted_curve : Bezier<Double_2> {
  static int alive, most;
  static void count(int n) { most = std::max(most, alive += n); }
  explicit Counted_curve(const Bezier<Double_2>& c) : Bezier<Double_2>(c) { count(1); }
  Counted_curve(const Counted_curve& c) : Bezier<Double_2>(c) { count(1); }
  Counted_curve& operator=(const Counted_curve&) = default;
  ~Counted_curve() { count(-1); }
};
int Counted_curve::alive = 0, Counted_curve::most = 0;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_chain_is_its_joins, Traits, All_traits) {
  typedef GC::Chain_join<Bezier<Traits>> Chain_join;
  Random random;
  for (bool closed : {false, true})
    for (int max_order : {0, 2, 4}) {
      const std::vector<Bezier<Traits>> chain = random_chain<Traits>(random, 30);
      std::size_t n = 0;
      std::map<int, std::size_t> c, g, f;
      const GC::Chain_summary summary =
          GC::chain_continuity(chain.begin(), chain.end(), max_order, closed, [&](const Chain_join& join) {
            BOOST_CHECK_EQUAL(join.left, n);
            BOOST_CHECK_EQUAL(join.right, n == 29 ? 0 : n + 1);
            BOOST_CHECK(join.left_curve == chain[join.left]);
            BOOST_CHECK(join.right_curve == chain[join.right]);
            const auto expected = GC::continuity(chain[join.left], chain[join.right], max_order);
            BOOST_CHECK(same_join(join.continuity, expected));
            ++c[expected.c_order];
            ++g[expected.g_order];
            ++f[expected.f_order];
            ++n;
          });
      BOOST_CHECK_EQUAL(n, closed ? 30 : 29);
      BOOST_CHECK_EQUAL(summary.joins(), n);
      BOOST_CHECK(summary.counts(Kind::C) == c);
      BOOST_CHECK(summary.counts(Kind::G) == g);
      BOOST_CHECK(summary.counts(Kind::F) == f);
      BOOST_CHECK(max_order == 0 || g.size() > 2); // the test sees joins of several orders
      BOOST_CHECK_EQUAL(*summary.least_order(Kind::G), g.begin()->first);
      BOOST_CHECK_EQUAL(summary.failing(Kind::C, 1), c[-1] + c[0]);
      BOOST_CHECK_EQUAL(summary.failing(Kind::F, 0), f[-1]);
      BOOST_CHECK(GC::chain_continuity(chain.begin(), chain.end(), max_order, closed).counts(Kind::C) == c);
    }
}

BOOST_AUTO_TEST_CASE(short_chains) {
  Random random;
  const std::vector<Bezier<Exact_3>> chain = random_chain<Exact_3>(random, 2);
  const auto joins = [&](int n, bool closed) {
    return GC::chain_continuity(chain.begin(), chain.begin() + n, 3, closed);
  };
  BOOST_CHECK_EQUAL(joins(0, false).joins(), 0);
  BOOST_CHECK_EQUAL(joins(0, true).joins(), 0);
  BOOST_CHECK_EQUAL(joins(1, false).joins(), 0);
  BOOST_CHECK_EQUAL(joins(1, true).joins(), 1);
  BOOST_CHECK_EQUAL(joins(2, false).joins(), 1);
  BOOST_CHECK_EQUAL(joins(2, true).joins(), 2);
  BOOST_CHECK(!joins(1, false).least_order(Kind::C));
  BOOST_CHECK_EQUAL(joins(0, true).failing(Kind::C, 3), 0);
}

BOOST_AUTO_TEST_CASE(memory_does_not_grow_with_a_chain) {
  Random random;
  const Counted_curve curve(random.curve<Double_2>(3, 1).segment(0));
  const auto most = [&](int n) {
    GC::Chain_analysis<Counted_curve> chain(2);
    Counted_curve::most = Counted_curve::alive;
    for (int i = 0; i < n; ++i) chain.add(curve);
    chain.close();
    BOOST_CHECK_EQUAL(chain.size(), n);
    BOOST_CHECK_EQUAL(chain.summary().joins(), n);
    return Counted_curve::most;
  };
  BOOST_CHECK_EQUAL(most(1000), most(3));
  BOOST_CHECK_EQUAL(Counted_curve::alive, 1);
}

BOOST_AUTO_TEST_CASE(a_refused_curve_does_not_change_the_chain) {
  typedef Exact_d::Point Point;
  const std::vector<Q> x = {Q(0), Q(1), Q(2)};
  const Point p(2, x.begin(), x.begin() + 2), q(3, x.begin(), x.end());
  const Bezier<Exact_d> plane{p, p}, space{q, q};
  typedef GC::Chain_join<Bezier<Exact_d>> Chain_join;
  GC::Chain_analysis<Bezier<Exact_d>> chain;
  chain.add(plane);
  CHECK_ERROR(chain.add(space), dimension_mismatch);
  BOOST_CHECK_THROW(chain.add(plane, [](const Chain_join&) { throw std::runtime_error("report"); }),
                    std::runtime_error);
  BOOST_CHECK_EQUAL(chain.size(), 1);
  BOOST_CHECK_EQUAL(chain.summary().joins(), 0);
  chain.add(plane);
  BOOST_CHECK_EQUAL(chain.summary().joins(), 1);
  GC::Chain_analysis<Bezier<Exact_d>> no_order(-1);
  no_order.add(plane);
  CHECK_ERROR(no_order.add(plane), jet_order_too_low);
}

// ------------------------------------------------------------------------------------- analysis of a segmented curve

BOOST_AUTO_TEST_CASE_TEMPLATE(continuity_in_the_global_parameter, Traits, All_traits) {
  typedef typename Traits::FT FT;
  const int n = test_dimension<Traits>;
  typedef GC::Predicate_FT<Traits> Field;
  // one cubic over the knots 0, 1, 2, 4
  const Composite<Traits> cubic = composite<Traits>({{0}, {4, 0, 0, 8}, {8, 8, 4}, {8, 12, 16, 4}}, {0, 4});
  const Composite<Traits> c = cubic.insert_knot(FT(2)).insert_knot(FT(1));
  const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c);
  BOOST_REQUIRE_EQUAL(whole.joins.size(), 2);
  for (const GC::Composite_join<Traits>& join : whole.joins) {
    BOOST_CHECK_EQUAL(join.continuity.c_order, 3);
    BOOST_CHECK_EQUAL(join.continuity.g_order, 3);
    BOOST_CHECK_EQUAL(join.continuity.f_order, std::min(3, n));
    BOOST_CHECK(join.continuity.betas == numbers<Field>({1, 0, 0}));
  }
  BOOST_CHECK_EQUAL(whole.joins[1].left, 1);
  BOOST_CHECK_EQUAL(whole.joins[1].right, 2);
  BOOST_CHECK_EQUAL(whole.joins[1].knot, FT(2));

  // the same points over other knots: the last segment, of length 2, is run through in 1/2
  const std::vector<FT> knots = {FT(0), FT(1), FT(2), ratio<FT>(5, 2)};
  const auto other = GC::chain_continuity(Composite<Traits>(c.begin(), c.end(), knots)).joins[1].continuity;
  BOOST_CHECK_EQUAL(other.c_order, 0);
  BOOST_CHECK_EQUAL(other.g_order, 3);
  BOOST_CHECK(other.betas == numbers<Field>({4, 0, 0}));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(every_join_is_that_of_two_curves, Traits, All_traits) {
  typedef GC::Predicate_FT<Traits> Field;
  Random random;
  for (bool closed : {false, true})
    for (int max_order : {1, 3, 4}) {
      const Composite<Traits> c = random.curve<Traits>(4, 3, closed);
      const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c, max_order);
      BOOST_REQUIRE_EQUAL(whole.joins.size(), closed ? 3 : 2);
      BOOST_CHECK_EQUAL(whole.summary.joins(), whole.joins.size());
      GC::Chain_summary summary;
      for (std::size_t i = 0; i < whole.joins.size(); ++i) {
        const GC::Composite_join<Traits>& join = whole.joins[i];
        BOOST_CHECK_EQUAL(join.left, i);
        BOOST_CHECK_EQUAL(join.right, (i + 1) % 3);
        BOOST_CHECK_EQUAL(join.knot, c.knots()[i + 1]);
        const Bezier<Traits> left = c.segment(join.left), right = c.segment(join.right);
        const auto expected = GC::continuity(left, right, max_order);
        BOOST_CHECK(same_join(join.continuity, expected));
        summary.add(expected);
        const auto x = left.template end_jet_over<Field>(3), y = right.template start_jet_over<Field>(3);
        if constexpr (test_dimension<Traits> == 2) {
          BOOST_CHECK(join.left_side.curvature == GC::signed_curvature(x));
          BOOST_CHECK(join.right_side.curvature == GC::signed_curvature(y));
        } else {
          BOOST_CHECK(join.left_side.curvature->square == *GC::curvature_squared(x));
          BOOST_CHECK(join.right_side.curvature->square == *GC::curvature_squared(y));
          BOOST_CHECK(join.left_side.curvature->sign == 1 && join.right_side.curvature->sign == 1);
        }
        if constexpr (is_exact<Traits>) { // from the legs of the polygon
          const auto before = GC::end_invariants(left), after = GC::start_invariants(right);
          BOOST_CHECK(join.left_side.curvature->square == *before.curvature_squared);
          BOOST_CHECK(join.right_side.curvature->square == *after.curvature_squared);
          BOOST_CHECK(join.left_side.torsion == before.torsion);
          BOOST_CHECK(join.right_side.torsion == after.torsion);
        }
        if constexpr (test_dimension<Traits> == 3) {
          BOOST_CHECK(join.left_side.torsion == GC::torsion(x));
          BOOST_CHECK(join.right_side.torsion == GC::torsion(y));
        } else
          BOOST_CHECK(!join.left_side.torsion && !join.right_side.torsion);
      }
      for (Kind kind : {Kind::C, Kind::G, Kind::F}) BOOST_CHECK(whole.summary.counts(kind) == summary.counts(kind));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(sides_of_a_join, Traits, All_traits) {
  typedef GC::Predicate_FT<Traits> Field;
  typedef GC::Signed_square<Field> Signed;
  // a left turn before the join and a right turn after it; at the ends of parabolas kappa = |p x r| / (2 |p|^3)
  const auto whole = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 2}, {2, 4}, {8, 4}}, {0, 1, 2}));
  const bool plane = test_dimension<Traits> == 2;
  BOOST_CHECK(whole.joins[0].left_side.curvature == (Signed{1, Field(Field(1) / Field(16))}));
  BOOST_CHECK(whole.joins[0].right_side.curvature == (Signed{plane ? -1 : 1, Field(Field(9) / Field(16))}));
  // a zero leg has no curvature, a straight one the curvature 0 and no torsion
  const auto zero = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 0}, {2, 4}, {2, 8}}, {0, 1, 2}));
  BOOST_CHECK(!zero.joins[0].left_side.curvature && !zero.joins[0].left_side.torsion);
  BOOST_CHECK(zero.joins[0].right_side.curvature == (Signed{0, Field(0)}));
  BOOST_CHECK(!zero.joins[0].right_side.torsion);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(joins_that_fail, Traits, All_traits) {
  // four segments of a closed polygon: smooth, corner, smooth in direction only, closing corner
  const Composite<Traits> c =
      composite<Traits>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {2, 4}, {2, 6}, {-1, 6}, {0, 0}}, {0, 1, 2, 3, 4});
  BOOST_REQUIRE(c.is_closed());
  const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c);
  const auto failing = [&](Kind kind, int order) {
    std::vector<int> left;
    for (const GC::Composite_join<Traits>& join : whole.failing(kind, order)) left.push_back(join.left);
    BOOST_CHECK_EQUAL(left.size(), whole.summary.failing(kind, order));
    return left;
  };
  BOOST_CHECK(failing(Kind::C, 0) == std::vector<int>());
  BOOST_CHECK(failing(Kind::C, 1) == std::vector<int>({0, 1, 2, 3}));
  BOOST_CHECK(failing(Kind::G, 1) == std::vector<int>({0, 2, 3}));
  BOOST_CHECK(failing(Kind::F, 1) == std::vector<int>({0, 2, 3}));
  BOOST_CHECK_EQUAL(*whole.summary.least_order(Kind::G), 0);
  BOOST_CHECK(whole.joins[1].continuity.betas.size() >= 1 &&
              whole.joins[1].continuity.betas[0] == GC::Predicate_FT<Traits>(2));
}

BOOST_AUTO_TEST_CASE(exact_predicates_read_points_and_knots_as_given) {
  typedef Epick_3::Point Point;
  // legs of length 1 + 1e-17 and 1: rounded subtraction makes them equal
  const std::vector<Point> b = {Point(-1, 0, 0), Point(1e-17, 0, 0), Point(1, 0, 0)};
  const Composite<Epick_3> c(b.begin(), b.end(), {0, 1, 2});
  const auto exact = GC::chain_continuity(c, 1).joins[0].continuity;
  BOOST_CHECK_EQUAL(exact.c_order, 0);
  BOOST_CHECK_EQUAL(exact.g_order, 1);
  BOOST_CHECK(exact.betas[0] < 1);
  typedef Double_3::Point Rounded;
  const std::vector<Rounded> r = {Rounded(-1, 0, 0), Rounded(1e-17, 0, 0), Rounded(1, 0, 0)};
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Double_3>(r.begin(), r.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
  // the same with knots: intervals of length 1 + 1e-17 and 1
  const std::vector<Point> p = {Point(-1, 0, 0), Point(0, 0, 0), Point(1, 0, 0)};
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {-1e-17, 1, 2}), 1).joins[0].continuity.c_order, 0);
  BOOST_CHECK_EQUAL(
      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
}

// A curve keeps its segments when it is extended or closed, and the new joins have the order that was asked for.
BOOST_AUTO_TEST_CASE(extended_and_closed) {
  Random random;
  typedef GC::Composite_bezier_curve<Exact_3> Composite;
  for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion}) {
    const int f_order = static_cast<int>(order);
    const Composite curve = random.curve<Exact_3>(4, 2);
    const Composite longer = GC::extend(curve, order, {Q(1, 3), Q(2), Q(5), Q(-1)});
    BOOST_REQUIRE_EQUAL(longer.number_of_segments(), 3);
    BOOST_CHECK(longer.segment_range(0, 2) == curve);
    BOOST_CHECK(longer.lambda(2) == longer.lambda(1) / 3);
    BOOST_CHECK_GE(GC::chain_continuity(longer).joins[1].continuity.f_order, f_order);

    const Exact_3::Point wished(Q(7), Q(-3, 5), Q(11));
    const Composite toward = GC::extend_toward(curve, order, wished, Q(2));
    BOOST_REQUIRE_EQUAL(toward.number_of_segments(), 3);
    BOOST_CHECK(toward.segment_range(0, 2) == curve);
    BOOST_CHECK(toward.segment(2) == GC::extend_toward(curve.segment(1), order, wished, Q(2)));

    const Composite closed = GC::close(curve, order);
    BOOST_REQUIRE_EQUAL(closed.number_of_segments(), 3);
    BOOST_REQUIRE(closed.is_closed());
    const GC::Composite_continuity<Exact_3> report = GC::chain_continuity(closed);
    BOOST_CHECK_GE(report.joins[1].continuity.f_order, f_order);
    BOOST_CHECK_GE(report.joins[2].continuity.f_order, f_order);
    for (int l = 0; l < 2; ++l)
      BOOST_CHECK(closed.segment(l) == curve.segment(l).elevate(closed.degree() - curve.degree()));
  }
}
