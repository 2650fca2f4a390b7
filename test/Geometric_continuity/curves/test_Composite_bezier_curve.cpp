include <CGAL/Geometric_continuity/extensions/extend.h>// Copyright (c) 2026 The Geometric_continuity developers
include <CGAL/Geometric_continuity/extensions/extend.h>//
include <CGAL/Geometric_continuity/extensions/extend.h>// SPDX-License-Identifier: LGPL-3.0-or-later
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Segmented curves and the analysis of chains. Rounded kernels run the same tests as exact ones, on dyadic numbers where
include <CGAL/Geometric_continuity/extensions/extend.h>// every intermediate result is a double.
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#define BOOST_TEST_DYN_LINK
include <CGAL/Geometric_continuity/extensions/extend.h>#define BOOST_TEST_MODULE composite
include <CGAL/Geometric_continuity/extensions/extend.h>#include <boost/test/unit_test.hpp>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Cartesian_d.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Exact_rational.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_2.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_3.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/Traits_d.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/curves/polygon_invariants.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Geometric_continuity/joins/chain_continuity.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <CGAL/Simple_cartesian.h>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <algorithm>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <initializer_list>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <limits>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <map>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <optional>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <random>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <sstream>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <stdexcept>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <string>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <tuple>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <type_traits>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <utility>
include <CGAL/Geometric_continuity/extensions/extend.h>#include <vector>
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>namespace GC = CGAL::Geometric_continuity;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>typedef CGAL::Exact_rational Q;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_2;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double_2;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_d<CGAL::Cartesian_d<double>> Double_d;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Traits_3<Epick> Epick_3;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef std::tuple<Exact_2, Exact_3, Exact_d, Double_2, Double_3, Double_d, Epick_3> All_traits;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> using Composite = GC::Composite_bezier_curve<Traits>;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> using Bezier = GC::Bezier_curve<Traits>;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> using Column = GC::Coordinates<Traits>;
include <CGAL/Geometric_continuity/extensions/extend.h>typedef GC::Continuity_kind Kind;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>#define CHECK_ERROR(expression, expected)                                                                              \
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
include <CGAL/Geometric_continuity/extensions/extend.h>                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>namespace {
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> constexpr int test_dimension = Bezier<Traits>::N == 0 ? 4 : Bezier<Traits>::N;
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> constexpr bool is_exact = !std::is_floating_point_v<typename Traits::FT>;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> typename Traits::Point point(std::initializer_list<int> x) {
include <CGAL/Geometric_continuity/extensions/extend.h>  Column<Traits> c(test_dimension<Traits>);
include <CGAL/Geometric_continuity/extensions/extend.h>  int i = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int value : x)
include <CGAL/Geometric_continuity/extensions/extend.h>    if (i < c.dimension()) c[i++] = typename Traits::FT(value);
include <CGAL/Geometric_continuity/extensions/extend.h>  return GC::to_point<Traits>(c);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits>
include <CGAL/Geometric_continuity/extensions/extend.h>std::vector<typename Traits::Point> points(std::initializer_list<std::initializer_list<int>> rows) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<typename Traits::Point> result;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const std::initializer_list<int>& row : rows) result.push_back(point<Traits>(row));
include <CGAL/Geometric_continuity/extensions/extend.h>  return result;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class FT> std::vector<FT> numbers(std::initializer_list<int> x) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> result;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int value : x) result.push_back(FT(value));
include <CGAL/Geometric_continuity/extensions/extend.h>  return result;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits>
include <CGAL/Geometric_continuity/extensions/extend.h>Composite<Traits> composite(std::initializer_list<std::initializer_list<int>> rows, std::initializer_list<int> knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<typename Traits::Point> b = points<Traits>(rows);
include <CGAL/Geometric_continuity/extensions/extend.h>  return Composite<Traits>(b.begin(), b.end(), numbers<typename Traits::FT>(knots));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>class Random {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::mt19937 engine_{20261};
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>public:
include <CGAL/Geometric_continuity/extensions/extend.h>  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // a rational number, or a small multiple of 1/4
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class FT> FT number() {
include <CGAL/Geometric_continuity/extensions/extend.h>    return std::is_floating_point_v<FT> ? ratio<FT>(integer(-8, 8), 4) : ratio<FT>(integer(-99, 99), integer(1, 99));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  // a rational number in (0, 1), or a multiple of 1/8
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class FT> FT fraction() {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int q = std::is_floating_point_v<FT> ? 8 : integer(2, 99);
include <CGAL/Geometric_continuity/extensions/extend.h>    return ratio<FT>(integer(1, q - 1), q);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  // positive, or a power of 2
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class FT> FT length() {
include <CGAL/Geometric_continuity/extensions/extend.h>    return std::is_floating_point_v<FT> ? ratio<FT>(1 << integer(0, 3), 4) : ratio<FT>(integer(1, 99), integer(1, 99));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class Traits> Column<Traits> column() {
include <CGAL/Geometric_continuity/extensions/extend.h>    Column<Traits> c(test_dimension<Traits>);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < c.dimension(); ++i) c[i] = number<typename Traits::FT>();
include <CGAL/Geometric_continuity/extensions/extend.h>    return c;
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  template <class Traits> Composite<Traits> curve(int degree, int segments, bool closed = false) {
include <CGAL/Geometric_continuity/extensions/extend.h>    typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<typename Traits::Point> b;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i <= degree * segments; ++i) b.push_back(GC::to_point<Traits>(column<Traits>()));
include <CGAL/Geometric_continuity/extensions/extend.h>    if (closed) b.back() = b.front();
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<FT> knots(1, number<FT>());
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int l = 0; l < segments; ++l) knots.push_back(FT(knots.back() + length<FT>()));
include <CGAL/Geometric_continuity/extensions/extend.h>    return Composite<Traits>(b.begin(), b.end(), knots);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>};
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> Column<Traits> column(const typename Traits::Point& p) { return GC::coordinates<Traits>(p); }
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// a parameter of the l-th segment
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> typename Traits::FT inside(const Composite<Traits>& c, int l, const typename Traits::FT& t) {
include <CGAL/Geometric_continuity/extensions/extend.h>  return typename Traits::FT(c.knots()[l] + t * c.lambda(l));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// both are the same function on the segments of c
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> bool same_function(const Composite<Traits>& c, const Composite<Traits>& d, Random& random) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 0; l < c.number_of_segments(); ++l)
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < 3; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT u = inside<Traits>(c, l, random.fraction<FT>());
include <CGAL/Geometric_continuity/extensions/extend.h>      if (c.jet(u, 3) != d.jet(u, 3)) return false;
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  return true;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class T> std::string text(const T& x) {
include <CGAL/Geometric_continuity/extensions/extend.h>  std::ostringstream os;
include <CGAL/Geometric_continuity/extensions/extend.h>  os << x;
include <CGAL/Geometric_continuity/extensions/extend.h>  return os.str();
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>} // namespace
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// --------------------------------------------------------------------------------------------- Hagen, definition 3.1
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(evaluation_by_the_definition, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int m = 0; m <= 4; ++m)
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int segments = 1; segments <= (m == 0 ? 1 : 4); ++segments) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> c = random.curve<Traits>(m, segments);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.degree(), m);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.dimension(), test_dimension<Traits>);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.number_of_segments(), segments);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(c.domain() == std::make_pair(c.knots().front(), c.knots().back()));
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int l = 0; l < segments; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT t = random.fraction<FT>(), s = FT(1) - t, u = inside<Traits>(c, l, t);
include <CGAL/Geometric_continuity/extensions/extend.h>        Column<Traits> sum(c.dimension());
include <CGAL/Geometric_continuity/extensions/extend.h>        FT binomial(1); // sum_i b_{ml+i} B_i^m(t)
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i <= m; ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>          FT weight = binomial;
include <CGAL/Geometric_continuity/extensions/extend.h>          for (int j = 0; j < m; ++j) weight *= j < i ? t : s;
include <CGAL/Geometric_continuity/extensions/extend.h>          sum += weight * c.coordinates(m * l + i);
include <CGAL/Geometric_continuity/extensions/extend.h>          binomial = FT(binomial * FT(m - i) / FT(i + 1));
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(column<Traits>(c(u)) == sum);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(c.jet(u, 0)[0] == sum);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(c.segment_at(u), l);
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(derivatives_on_both_sides_of_a_knot, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int m = 3; m <= 5; ++m) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite<Traits> c = random.curve<Traits>(m, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int l = 0; l < 2; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const auto b = [&](int i) { return c.coordinates(m * (l + 1) + i); };
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT x = c.lambda(l), y = c.lambda(l + 1), u = c.knots()[l + 1];
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT m1(m), m2(m * (m - 1)), m3(m * (m - 1) * (m - 2));
include <CGAL/Geometric_continuity/extensions/extend.h>      const GC::Curve_jet<Traits> left = c.left_jet(u, 3), right = c.right_jet(u, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(left[0] == b(0));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(left[1] == FT(m1 / x) * (b(0) - b(-1)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(left[2] == FT(m2 / (x * x)) * (b(0) - FT(2) * b(-1) + b(-2)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(left[3] == FT(m3 / (x * x * x)) * (b(0) - FT(3) * b(-1) + FT(3) * b(-2) - b(-3)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(right[0] == b(0));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(right[1] == FT(m1 / y) * (b(1) - b(0)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(right[2] == FT(m2 / (y * y)) * (b(2) - FT(2) * b(1) + b(0)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(right[3] == FT(m3 / (y * y * y)) * (b(3) - FT(3) * b(2) + FT(3) * b(1) - b(0)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(c.jet(u, 3) == right);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(column<Traits>(c(u)) == b(0));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.segment_at(u), l + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.segment_at(u, false), l);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>    // there is one side only at the ends, and the right end belongs to the domain
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT first = c.domain().first, last = c.domain().second;
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.left_jet(first, 3) == c.segment(0).start_jet(3));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.jet(first, 3) == c.segment(0).start_jet(3));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.jet(last, 3) == c.segment(2).end_jet(3));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.left_jet(last, 3) == c.segment(2).end_jet(3));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.template start_jet_over<FT>(3) == c.jet(first, 3));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(c.template end_jet_over<FT>(3) == c.jet(last, 3));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(parameters_outside_the_domain, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = composite<Traits>({{0}, {1}, {2}, {3}, {4}}, {1, 2, 4});
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> bad = {ratio<FT>(999, 1000), ratio<FT>(4001, 1000)};
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!is_exact<Traits>) bad.push_back(std::numeric_limits<double>::quiet_NaN());
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& u : bad) {
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c(u), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.jet(u, 2), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.left_jet(u, 2), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.right_jet(u, 2), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.segment_at(u), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.insert_knot(u), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(c.split(u), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.split(FT(1)), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.split(FT(4)), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.subrange(FT(0), FT(2)), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.subrange(FT(2), FT(5)), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.subrange(FT(2), FT(2)), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.subrange(FT(3), FT(2)), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.segment_range(-1, 1), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.segment_range(1, 1), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(c.segment_range(0, 3), parameter_outside_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ------------------------------------------------------------------------------------------------------ construction
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(bad_points_and_knots, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<typename Traits::Point> b = points<Traits>({{0}, {1}, {2}, {3}, {4}, {5}, {6}});
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto make = [&](int n, std::initializer_list<int> knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return Composite<Traits>(b.begin(), b.begin() + n, numbers<FT>(knots));
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(make(7, {0, 1, 2}).degree(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(make(7, {0, 1, 2, 3}).degree(), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(make(1, {0, 1}).degree(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(6, {0, 1, 2}), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(0, {0, 1}), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(7, {0}), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(7, {}), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(7, {0, 1, 1}), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(make(7, {0, 2, 1}), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2})).degree(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Cubic(b.begin(), b.end(), numbers<FT>({0, 1, 2, 3})), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  if constexpr (!is_exact<Traits>) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, 1, inf}), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Composite<Traits>(b.begin(), b.end(), {0, nan, 2}), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>    Column<Traits> x(test_dimension<Traits>);
include <CGAL/Geometric_continuity/extensions/extend.h>    x[1] = inf;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<typename Traits::Point> bad = b;
include <CGAL/Geometric_continuity/extensions/extend.h>    bad[2] = GC::to_point<Traits>(x);
include <CGAL/Geometric_continuity/extensions/extend.h>    CHECK_ERROR(Composite<Traits>(bad.begin(), bad.end(), {0, 1, 2}), not_finite);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(points_of_different_dimensions) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Exact_d::Point Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Q> x(3, Q(0));
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Point> b = {Point(3, x.begin(), x.end()), Point(2, x.begin(), x.begin() + 2)};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Exact_d>(b.begin(), b.end(), numbers<Q>({0, 1})), dimension_mismatch);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier<Exact_d>> curves = {Bezier<Exact_d>(b.begin(), b.begin() + 1),
include <CGAL/Geometric_continuity/extensions/extend.h>                                               Bezier<Exact_d>(b.begin() + 1, b.end())};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Exact_d>(curves.begin(), curves.end()), dimension_mismatch);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(from_curves_that_meet, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = random.curve<Traits>(3, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier<Traits>> parts(c.segments().begin(), c.segments().end());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE_EQUAL(parts.size(), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 0; l < 4; ++l) BOOST_CHECK(parts[l] == c.segment(l));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Composite<Traits>(parts.begin(), parts.end()) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // the domains keep their lengths and are moved to follow each other
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Bezier<Traits>> moved = parts;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 1; l < 4; ++l) moved[l] = parts[l].with_domain(FT(l), FT(FT(l) + c.lambda(l)));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Composite<Traits>(moved.begin(), moved.end()) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // lower degrees are elevated
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Bezier<Traits>> mixed = {random.curve<Traits>(1, 1).segment(0), random.curve<Traits>(4, 1).segment(0),
include <CGAL/Geometric_continuity/extensions/extend.h>                                       random.curve<Traits>(2, 1).segment(0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 1; l < 3; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<typename Traits::Point> b(mixed[l].begin(), mixed[l].end());
include <CGAL/Geometric_continuity/extensions/extend.h>    b.front() = mixed[l - 1].control_points().back();
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT a = mixed[l - 1].domain().second;
include <CGAL/Geometric_continuity/extensions/extend.h>    mixed[l] = Bezier<Traits>(b.begin(), b.end(), a, FT(a + FT(1)));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> d(mixed.begin(), mixed.end());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(d.degree(), 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(d.number_of_segments(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 0; l < 3; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT u = inside<Traits>(d, l, ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>    if constexpr (is_exact<Traits>)
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(d.jet(u, 4) == mixed[l].jet(u, 4));
include <CGAL/Geometric_continuity/extensions/extend.h>    else // elevation divides by 2, 3 and 4; the coordinates are below 2, and few roundings of 2^-53 are made
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int i = 0; i < d.dimension(); ++i) BOOST_CHECK_SMALL(d.jet(u, 0)[0][i] - mixed[l].jet(u, 0)[0][i], 1e-14);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Composite_bezier_curve<Traits, 5> Quintic;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(Quintic(mixed.begin(), mixed.end()).degree(), 5);
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Composite_bezier_curve<Traits, 3> Cubic;
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Cubic(mixed.begin(), mixed.end()), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Composite<Traits>(Cubic(parts.begin(), parts.end())) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Cubic(c).segment(1) == (GC::Bezier_curve<Traits, 3>(parts[1])));
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Cubic(d), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Traits>(parts.begin(), parts.begin()), wrong_number_of_points);
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Bezier<Traits>> apart = {parts[0], parts[2]};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Traits>(apart.begin(), apart.end()), curves_do_not_meet);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(adjacent_domains_are_not_rounded) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Double_2::Point Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  const double a = -0.1, b = 0.2;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE(a + (b - a) != b);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier<Double_2>> curves = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(-1, a),
include <CGAL/Geometric_continuity/extensions/extend.h>                                                Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(a, b)};
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Composite<Double_2>(curves.begin(), curves.end()).knots() == std::vector<double>({-1, a, b}));
include <CGAL/Geometric_continuity/extensions/extend.h>  // a length that vanishes beside the knot before it is refused
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier<Double_2>> tiny = {Bezier<Double_2>{Point(0, 0), Point(1, 0)}.with_domain(0, 1),
include <CGAL/Geometric_continuity/extensions/extend.h>                                              Bezier<Double_2>{Point(1, 0), Point(1, 1)}.with_domain(0, 1e-20)};
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Double_2>(tiny.begin(), tiny.end()), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// --------------------------------------------------------------------------------------------------------- iteration
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(segments_and_joins, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (bool closed : {false, true})
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int segments = 1; segments <= 3; ++segments) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> c = random.curve<Traits>(2, segments, closed);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.is_closed(), closed);
include <CGAL/Geometric_continuity/extensions/extend.h>      int l = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const Bezier<Traits>& s : c.segments()) {
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(s == c.segment(l));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(s.domain() == std::make_pair(c.knots()[l], c.knots()[l + 1]));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(c.lambda(l), FT(c.knots()[l + 1] - c.knots()[l]));
include <CGAL/Geometric_continuity/extensions/extend.h>        for (int i = 0; i <= 2; ++i) BOOST_CHECK(s.coordinates(i) == c.coordinates(2 * l + i));
include <CGAL/Geometric_continuity/extensions/extend.h>        ++l;
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(l, segments);
include <CGAL/Geometric_continuity/extensions/extend.h>      int n = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>      for (const typename Composite<Traits>::Join& join : c.joins()) {
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(join.left, n);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(join.right, n + 1 < segments ? n + 1 : 0);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(c.ratio(join), FT(c.lambda(join.right) / c.lambda(join.left)));
include <CGAL/Geometric_continuity/extensions/extend.h>        ++n;
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(n, closed ? segments : segments - 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(c.number_of_joins(), n);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ------------------------------------------------------------------------------------------------------ other curves
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(a_knot_is_inserted, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int m = 0; m <= 3; ++m) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int segments = m == 0 ? 1 : 3;
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite<Traits> c = random.curve<Traits>(m, segments);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const FT& u : c.knots()) BOOST_CHECK(c.insert_knot(u) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int l = 0; l < segments; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT u = inside<Traits>(c, l, is_exact<Traits> ? random.fraction<FT>() : ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> d = c.insert_knot(u);
include <CGAL/Geometric_continuity/extensions/extend.h>      std::vector<FT> knots = c.knots();
include <CGAL/Geometric_continuity/extensions/extend.h>      knots.insert(knots.begin() + l + 1, u);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(d.knots() == knots);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(d.degree(), m);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(column<Traits>(d(u)) == column<Traits>(c(u)));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(d.left_jet(u, m) == d.right_jet(u, m));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(same_function<Traits>(c, d, random));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(parts, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = random.curve<Traits>(3, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < 4; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int j = i + 1; j <= 4; ++j) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> part = c.segment_range(i, j);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i);
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int l = i; l < j; ++l) BOOST_CHECK(part.segment(l - i) == c.segment(l));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(part == c.subrange(c.knots()[i], c.knots()[j]));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int i = 0; i < 4; ++i)
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int j = i; j < 4; ++j) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const FT u = inside<Traits>(c, i, ratio<FT>(1, 2)),
include <CGAL/Geometric_continuity/extensions/extend.h>               v = inside<Traits>(c, j, i == j ? ratio<FT>(3, 4) : ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> part = c.subrange(u, v);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(part.number_of_segments(), j - i + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(part.domain() == std::make_pair(u, v));
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(part.left_jet(v, 3) == c.left_jet(v, 3));
include <CGAL/Geometric_continuity/extensions/extend.h>      for (int l = 0; l <= j - i; ++l) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const FT w = inside<Traits>(part, l, ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(part.jet(w, 3) == c.jet(w, 3));
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT u = inside<Traits>(c, 2, ratio<FT>(1, 4));
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(u);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(halves.first == c.subrange(c.domain().first, u));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(halves.second == c.subrange(u, c.domain().second));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Bezier<Traits>> all(halves.first.segments().begin(), halves.first.segments().end());
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const Bezier<Traits>& s : halves.second.segments()) all.push_back(s);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(Composite<Traits>(all.begin(), all.end()) == c.insert_knot(u));
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::pair<Composite<Traits>, Composite<Traits>> at_knot = c.split(c.knots()[1]);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(at_knot.first == c.segment_range(0, 1) && at_knot.second == c.segment_range(1, 4));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(run_through_backwards, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = random.curve<Traits>(3, 3), r = c.reverse();
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(r.domain() == c.domain());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(r.reverse() == c);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (int l = 0; l < 3; ++l) BOOST_CHECK_EQUAL(r.lambda(l), c.lambda(2 - l));
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT sum = c.domain().first + c.domain().second;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const FT& u : {inside<Traits>(c, 1, ratio<FT>(1, 4)), c.knots()[1], c.knots()[0], c.knots()[3]}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Curve_jet<Traits> x = c.right_jet(u, 3), y = r.left_jet(FT(sum - u), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int j = 0; j <= 3; ++j) BOOST_CHECK(y[j] == FT(j % 2 == 0 ? 1 : -1) * x[j]);
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(reversal_of_rounded_knots) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Double_2::Point Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Point> b = {Point(0, 0), Point(1, 0), Point(1, 1)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const double x = -0.1, y = 0.2;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE(x + (y - x) != y);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (double u : {-0.05, 0.03, 0.07, 0.19}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite<Double_2> r = Composite<Double_2>(b.begin(), b.end(), {x, u, y}).reverse();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(r.domain() == std::make_pair(x, y));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_SMALL(r.knots()[1] - (x + y - u), 1e-15); // at most four roundings of numbers below 1
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(Composite<Double_2>(b.begin(), b.end(), {0, 1e-20, 1}).reverse(), empty_domain);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(values, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = random.curve<Traits>(2, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  Composite<Traits> d = c;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c == d);
include <CGAL/Geometric_continuity/extensions/extend.h>  d = c.insert_knot(inside<Traits>(c, 0, ratio<FT>(1, 2)));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c != d);
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<FT> knots = c.knots();
include <CGAL/Geometric_continuity/extensions/extend.h>  knots.back() += FT(1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c != Composite<Traits>(c.begin(), c.end(), knots));
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<typename Traits::Point> b(c.begin(), c.end());
include <CGAL/Geometric_continuity/extensions/extend.h>  std::swap(b[1], b[3]);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(c != Composite<Traits>(b.begin(), b.end(), c.knots()));
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  const Column<Traits> shift = random.column<Traits>();
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto map = [&](const typename Traits::Point& p) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return GC::to_point<Traits>(FT(2) * column<Traits>(p) + shift);
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> image = c.transform(map);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(image.knots() == c.knots());
include <CGAL/Geometric_continuity/extensions/extend.h>  const FT u = inside<Traits>(c, 1, ratio<FT>(1, 2));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(column<Traits>(image(u)) == FT(2) * column<Traits>(c(u)) + shift);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(output) {
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Exact_2> c = composite<Exact_2>({{0, 0}, {1, 2}, {3, 4}}, {0, 1, 3});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(text(c), "Bezier curve of degree 1 on [0, 1]: (0, 0) (1, 2)\n"
include <CGAL/Geometric_continuity/extensions/extend.h>                             "Bezier curve of degree 1 on [1, 3]: (1, 2) (3, 4)\n");
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::Chain_summary summary;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(text(summary), "0 joins");
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::Join_continuity<Q> join;
include <CGAL/Geometric_continuity/extensions/extend.h>  join.c_order = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>  join.g_order = 3;
include <CGAL/Geometric_continuity/extensions/extend.h>  join.f_order = 2;
include <CGAL/Geometric_continuity/extensions/extend.h>  summary.add(join);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(text(summary), "1 join, C0 G3 F2 or more");
include <CGAL/Geometric_continuity/extensions/extend.h>  join.c_order = join.g_order = join.f_order = -1;
include <CGAL/Geometric_continuity/extensions/extend.h>  summary.add(join);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(text(summary), "2 joins, 1 with a gap");
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(a_segmented_curve_is_a_parametric_curve, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = random.curve<Traits>(3, 4);
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::pair<Composite<Traits>, Composite<Traits>> halves = c.split(inside<Traits>(c, 1, ratio<FT>(1, 2)));
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto join = GC::continuity(halves.first, halves.second);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(join.c_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(GC::continuity(c, c).c_order, -1);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ------------------------------------------------------------------------------------------------------------ chains
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>namespace {
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// Curves of which each starts where the one before it ends but for some gaps, with joins of all kinds.
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Traits> std::vector<Bezier<Traits>> random_chain(Random& random, int n) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  std::vector<Bezier<Traits>> chain(1, random.curve<Traits>(3, 1).segment(0));
include <CGAL/Geometric_continuity/extensions/extend.h>  while (static_cast<int>(chain.size()) < n) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const Bezier<Traits>& last = chain.back();
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<Column<Traits>> b;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < 4; ++i) b.push_back(random.column<Traits>());
include <CGAL/Geometric_continuity/extensions/extend.h>    const int order = random.integer(-1, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    const FT beta(random.integer(1, 2)), c0(random.integer(0, 9));
include <CGAL/Geometric_continuity/extensions/extend.h>    const Column<Traits> p = last.coordinates(3) - last.coordinates(2);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (order >= 0) b[0] = last.coordinates(3);
include <CGAL/Geometric_continuity/extensions/extend.h>    if (order >= 1) b[1] = b[0] + beta * p;
include <CGAL/Geometric_continuity/extensions/extend.h>    if (order >= 2) b[2] = b[0] + FT(beta * beta) * (last.coordinates(1) - b[0]) + c0 * p;
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<typename Traits::Point> points;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const Column<Traits>& x : b) points.push_back(GC::to_point<Traits>(x));
include <CGAL/Geometric_continuity/extensions/extend.h>    chain.push_back(Bezier<Traits>(points.begin(), points.end()));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  return chain;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>template <class Join> bool same_join(const Join& x, const Join& y) {
include <CGAL/Geometric_continuity/extensions/extend.h>  return x.c_order == y.c_order && x.g_order == y.g_order && x.f_order == y.f_order && x.betas == y.betas &&
include <CGAL/Geometric_continuity/extensions/extend.h>         x.curvature_equal == y.curvature_equal && x.torsion_equal == y.torsion_equal;
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// A curve that counts its copies.
include <CGAL/Geometric_continuity/extensions/extend.h>struct Counted_curve : Bezier<Double_2> {
include <CGAL/Geometric_continuity/extensions/extend.h>  static int alive, most;
include <CGAL/Geometric_continuity/extensions/extend.h>  static void count(int n) { most = std::max(most, alive += n); }
include <CGAL/Geometric_continuity/extensions/extend.h>  explicit Counted_curve(const Bezier<Double_2>& c) : Bezier<Double_2>(c) { count(1); }
include <CGAL/Geometric_continuity/extensions/extend.h>  Counted_curve(const Counted_curve& c) : Bezier<Double_2>(c) { count(1); }
include <CGAL/Geometric_continuity/extensions/extend.h>  Counted_curve& operator=(const Counted_curve&) = default;
include <CGAL/Geometric_continuity/extensions/extend.h>  ~Counted_curve() { count(-1); }
include <CGAL/Geometric_continuity/extensions/extend.h>};
include <CGAL/Geometric_continuity/extensions/extend.h>int Counted_curve::alive = 0, Counted_curve::most = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>} // namespace
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(a_chain_is_its_joins, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Chain_join<Bezier<Traits>> Chain_join;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (bool closed : {false, true})
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int max_order : {0, 2, 4}) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const std::vector<Bezier<Traits>> chain = random_chain<Traits>(random, 30);
include <CGAL/Geometric_continuity/extensions/extend.h>      std::size_t n = 0;
include <CGAL/Geometric_continuity/extensions/extend.h>      std::map<int, std::size_t> c, g, f;
include <CGAL/Geometric_continuity/extensions/extend.h>      const GC::Chain_summary summary =
include <CGAL/Geometric_continuity/extensions/extend.h>          GC::chain_continuity(chain.begin(), chain.end(), max_order, closed, [&](const Chain_join& join) {
include <CGAL/Geometric_continuity/extensions/extend.h>            BOOST_CHECK_EQUAL(join.left, n);
include <CGAL/Geometric_continuity/extensions/extend.h>            BOOST_CHECK_EQUAL(join.right, n == 29 ? 0 : n + 1);
include <CGAL/Geometric_continuity/extensions/extend.h>            BOOST_CHECK(join.left_curve == chain[join.left]);
include <CGAL/Geometric_continuity/extensions/extend.h>            BOOST_CHECK(join.right_curve == chain[join.right]);
include <CGAL/Geometric_continuity/extensions/extend.h>            const auto expected = GC::continuity(chain[join.left], chain[join.right], max_order);
include <CGAL/Geometric_continuity/extensions/extend.h>            BOOST_CHECK(same_join(join.continuity, expected));
include <CGAL/Geometric_continuity/extensions/extend.h>            ++c[expected.c_order];
include <CGAL/Geometric_continuity/extensions/extend.h>            ++g[expected.g_order];
include <CGAL/Geometric_continuity/extensions/extend.h>            ++f[expected.f_order];
include <CGAL/Geometric_continuity/extensions/extend.h>            ++n;
include <CGAL/Geometric_continuity/extensions/extend.h>          });
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(n, closed ? 30 : 29);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(summary.joins(), n);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(summary.counts(Kind::C) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(summary.counts(Kind::G) == g);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(summary.counts(Kind::F) == f);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(max_order == 0 || g.size() > 2); // the test sees joins of several orders
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(*summary.least_order(Kind::G), g.begin()->first);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(summary.failing(Kind::C, 1), c[-1] + c[0]);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(summary.failing(Kind::F, 0), f[-1]);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(GC::chain_continuity(chain.begin(), chain.end(), max_order, closed).counts(Kind::C) == c);
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(short_chains) {
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Bezier<Exact_3>> chain = random_chain<Exact_3>(random, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto joins = [&](int n, bool closed) {
include <CGAL/Geometric_continuity/extensions/extend.h>    return GC::chain_continuity(chain.begin(), chain.begin() + n, 3, closed);
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(0, false).joins(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(0, true).joins(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(1, false).joins(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(1, true).joins(), 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(2, false).joins(), 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(2, true).joins(), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(!joins(1, false).least_order(Kind::C));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(joins(0, true).failing(Kind::C, 3), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(memory_does_not_grow_with_a_chain) {
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  const Counted_curve curve(random.curve<Double_2>(3, 1).segment(0));
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto most = [&](int n) {
include <CGAL/Geometric_continuity/extensions/extend.h>    GC::Chain_analysis<Counted_curve> chain(2);
include <CGAL/Geometric_continuity/extensions/extend.h>    Counted_curve::most = Counted_curve::alive;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int i = 0; i < n; ++i) chain.add(curve);
include <CGAL/Geometric_continuity/extensions/extend.h>    chain.close();
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(chain.size(), n);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(chain.summary().joins(), n);
include <CGAL/Geometric_continuity/extensions/extend.h>    return Counted_curve::most;
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(most(1000), most(3));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(Counted_curve::alive, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(a_refused_curve_does_not_change_the_chain) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Exact_d::Point Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Q> x = {Q(0), Q(1), Q(2)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const Point p(2, x.begin(), x.begin() + 2), q(3, x.begin(), x.end());
include <CGAL/Geometric_continuity/extensions/extend.h>  const Bezier<Exact_d> plane{p, p}, space{q, q};
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Chain_join<Bezier<Exact_d>> Chain_join;
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::Chain_analysis<Bezier<Exact_d>> chain;
include <CGAL/Geometric_continuity/extensions/extend.h>  chain.add(plane);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(chain.add(space), dimension_mismatch);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_THROW(chain.add(plane, [](const Chain_join&) { throw std::runtime_error("report"); }),
include <CGAL/Geometric_continuity/extensions/extend.h>                    std::runtime_error);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(chain.size(), 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(chain.summary().joins(), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  chain.add(plane);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(chain.summary().joins(), 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  GC::Chain_analysis<Bezier<Exact_d>> no_order(-1);
include <CGAL/Geometric_continuity/extensions/extend.h>  no_order.add(plane);
include <CGAL/Geometric_continuity/extensions/extend.h>  CHECK_ERROR(no_order.add(plane), jet_order_too_low);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// ------------------------------------------------------------------------------------- analysis of a segmented curve
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(continuity_in_the_global_parameter, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef typename Traits::FT FT;
include <CGAL/Geometric_continuity/extensions/extend.h>  const int n = test_dimension<Traits>;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Predicate_FT<Traits> Field;
include <CGAL/Geometric_continuity/extensions/extend.h>  // one cubic over the knots 0, 1, 2, 4
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> cubic = composite<Traits>({{0}, {4, 0, 0, 8}, {8, 8, 4}, {8, 12, 16, 4}}, {0, 4});
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c = cubic.insert_knot(FT(2)).insert_knot(FT(1));
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE_EQUAL(whole.joins.size(), 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  for (const GC::Composite_join<Traits>& join : whole.joins) {
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(join.continuity.c_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(join.continuity.g_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(join.continuity.f_order, std::min(3, n));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(join.continuity.betas == numbers<Field>({1, 0, 0}));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(whole.joins[1].left, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(whole.joins[1].right, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(whole.joins[1].knot, FT(2));
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>  // the same points over other knots: the last segment, of length 2, is run through in 1/2
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<FT> knots = {FT(0), FT(1), FT(2), ratio<FT>(5, 2)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto other = GC::chain_continuity(Composite<Traits>(c.begin(), c.end(), knots)).joins[1].continuity;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(other.c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(other.g_order, 3);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(other.betas == numbers<Field>({4, 0, 0}));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(every_join_is_that_of_two_curves, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Predicate_FT<Traits> Field;
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (bool closed : {false, true})
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int max_order : {1, 3, 4}) {
include <CGAL/Geometric_continuity/extensions/extend.h>      const Composite<Traits> c = random.curve<Traits>(4, 3, closed);
include <CGAL/Geometric_continuity/extensions/extend.h>      const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c, max_order);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_REQUIRE_EQUAL(whole.joins.size(), closed ? 3 : 2);
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK_EQUAL(whole.summary.joins(), whole.joins.size());
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::Chain_summary summary;
include <CGAL/Geometric_continuity/extensions/extend.h>      for (std::size_t i = 0; i < whole.joins.size(); ++i) {
include <CGAL/Geometric_continuity/extensions/extend.h>        const GC::Composite_join<Traits>& join = whole.joins[i];
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(join.left, i);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(join.right, (i + 1) % 3);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK_EQUAL(join.knot, c.knots()[i + 1]);
include <CGAL/Geometric_continuity/extensions/extend.h>        const Bezier<Traits> left = c.segment(join.left), right = c.segment(join.right);
include <CGAL/Geometric_continuity/extensions/extend.h>        const auto expected = GC::continuity(left, right, max_order);
include <CGAL/Geometric_continuity/extensions/extend.h>        BOOST_CHECK(same_join(join.continuity, expected));
include <CGAL/Geometric_continuity/extensions/extend.h>        summary.add(expected);
include <CGAL/Geometric_continuity/extensions/extend.h>        const auto x = left.template end_jet_over<Field>(3), y = right.template start_jet_over<Field>(3);
include <CGAL/Geometric_continuity/extensions/extend.h>        if constexpr (test_dimension<Traits> == 2) {
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.curvature == GC::signed_curvature(x));
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.right_side.curvature == GC::signed_curvature(y));
include <CGAL/Geometric_continuity/extensions/extend.h>        } else {
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.curvature->square == *GC::curvature_squared(x));
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.right_side.curvature->square == *GC::curvature_squared(y));
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.curvature->sign == 1 && join.right_side.curvature->sign == 1);
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>        if constexpr (is_exact<Traits>) { // from the legs of the polygon
include <CGAL/Geometric_continuity/extensions/extend.h>          const auto before = GC::end_invariants(left), after = GC::start_invariants(right);
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.curvature->square == *before.curvature_squared);
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.right_side.curvature->square == *after.curvature_squared);
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.torsion == before.torsion);
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.right_side.torsion == after.torsion);
include <CGAL/Geometric_continuity/extensions/extend.h>        }
include <CGAL/Geometric_continuity/extensions/extend.h>        if constexpr (test_dimension<Traits> == 3) {
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.left_side.torsion == GC::torsion(x));
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(join.right_side.torsion == GC::torsion(y));
include <CGAL/Geometric_continuity/extensions/extend.h>        } else
include <CGAL/Geometric_continuity/extensions/extend.h>          BOOST_CHECK(!join.left_side.torsion && !join.right_side.torsion);
include <CGAL/Geometric_continuity/extensions/extend.h>      }
include <CGAL/Geometric_continuity/extensions/extend.h>      for (Kind kind : {Kind::C, Kind::G, Kind::F}) BOOST_CHECK(whole.summary.counts(kind) == summary.counts(kind));
include <CGAL/Geometric_continuity/extensions/extend.h>    }
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(sides_of_a_join, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Predicate_FT<Traits> Field;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Signed_square<Field> Signed;
include <CGAL/Geometric_continuity/extensions/extend.h>  // a left turn before the join and a right turn after it; at the ends of parabolas kappa = |p x r| / (2 |p|^3)
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto whole = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 2}, {2, 4}, {8, 4}}, {0, 1, 2}));
include <CGAL/Geometric_continuity/extensions/extend.h>  const bool plane = test_dimension<Traits> == 2;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(whole.joins[0].left_side.curvature == (Signed{1, Field(Field(1) / Field(16))}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(whole.joins[0].right_side.curvature == (Signed{plane ? -1 : 1, Field(Field(9) / Field(16))}));
include <CGAL/Geometric_continuity/extensions/extend.h>  // a zero leg has no curvature, a straight one the curvature 0 and no torsion
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto zero = GC::chain_continuity(composite<Traits>({{0, 0}, {2, 0}, {2, 0}, {2, 4}, {2, 8}}, {0, 1, 2}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(!zero.joins[0].left_side.curvature && !zero.joins[0].left_side.torsion);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(zero.joins[0].right_side.curvature == (Signed{0, Field(0)}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(!zero.joins[0].right_side.torsion);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE_TEMPLATE(joins_that_fail, Traits, All_traits) {
include <CGAL/Geometric_continuity/extensions/extend.h>  // four segments of a closed polygon: smooth, corner, smooth in direction only, closing corner
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Traits> c =
include <CGAL/Geometric_continuity/extensions/extend.h>      composite<Traits>({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {2, 4}, {2, 6}, {-1, 6}, {0, 0}}, {0, 1, 2, 3, 4});
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_REQUIRE(c.is_closed());
include <CGAL/Geometric_continuity/extensions/extend.h>  const GC::Composite_continuity<Traits> whole = GC::chain_continuity(c);
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto failing = [&](Kind kind, int order) {
include <CGAL/Geometric_continuity/extensions/extend.h>    std::vector<int> left;
include <CGAL/Geometric_continuity/extensions/extend.h>    for (const GC::Composite_join<Traits>& join : whole.failing(kind, order)) left.push_back(join.left);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_EQUAL(left.size(), whole.summary.failing(kind, order));
include <CGAL/Geometric_continuity/extensions/extend.h>    return left;
include <CGAL/Geometric_continuity/extensions/extend.h>  };
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(failing(Kind::C, 0) == std::vector<int>());
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(failing(Kind::C, 1) == std::vector<int>({0, 1, 2, 3}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(failing(Kind::G, 1) == std::vector<int>({0, 2, 3}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(failing(Kind::F, 1) == std::vector<int>({0, 2, 3}));
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(*whole.summary.least_order(Kind::G), 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(whole.joins[1].continuity.betas.size() >= 1 &&
include <CGAL/Geometric_continuity/extensions/extend.h>              whole.joins[1].continuity.betas[0] == GC::Predicate_FT<Traits>(2));
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(exact_predicates_read_points_and_knots_as_given) {
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Epick_3::Point Point;
include <CGAL/Geometric_continuity/extensions/extend.h>  // legs of length 1 + 1e-17 and 1: rounded subtraction makes them equal
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Point> b = {Point(-1, 0, 0), Point(1e-17, 0, 0), Point(1, 0, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  const Composite<Epick_3> c(b.begin(), b.end(), {0, 1, 2});
include <CGAL/Geometric_continuity/extensions/extend.h>  const auto exact = GC::chain_continuity(c, 1).joins[0].continuity;
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(exact.c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(exact.g_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK(exact.betas[0] < 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef Double_3::Point Rounded;
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Rounded> r = {Rounded(-1, 0, 0), Rounded(1e-17, 0, 0), Rounded(1, 0, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::chain_continuity(Composite<Double_3>(r.begin(), r.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>  // the same with knots: intervals of length 1 + 1e-17 and 1
include <CGAL/Geometric_continuity/extensions/extend.h>  const std::vector<Point> p = {Point(-1, 0, 0), Point(0, 0, 0), Point(1, 0, 0)};
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {-1e-17, 1, 2}), 1).joins[0].continuity.c_order, 0);
include <CGAL/Geometric_continuity/extensions/extend.h>  BOOST_CHECK_EQUAL(
include <CGAL/Geometric_continuity/extensions/extend.h>      GC::chain_continuity(Composite<Epick_3>(p.begin(), p.end(), {0, 1, 2}), 1).joins[0].continuity.c_order, 1);
include <CGAL/Geometric_continuity/extensions/extend.h>}
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>// A curve keeps its segments when it is extended or closed, and the new joins have the order that was asked for.
include <CGAL/Geometric_continuity/extensions/extend.h>BOOST_AUTO_TEST_CASE(extended_and_closed) {
include <CGAL/Geometric_continuity/extensions/extend.h>  Random random;
include <CGAL/Geometric_continuity/extensions/extend.h>  typedef GC::Composite_bezier_curve<Exact_3> Composite;
include <CGAL/Geometric_continuity/extensions/extend.h>  for (GC::Frenet_order order : {GC::Frenet_order::tangent, GC::Frenet_order::curvature, GC::Frenet_order::torsion}) {
include <CGAL/Geometric_continuity/extensions/extend.h>    const int f_order = static_cast<int>(order);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite curve = random.curve<Exact_3>(4, 2);
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite longer = GC::extend(curve, order, {Q(1, 3), Q(2), Q(5), Q(-1)});
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(longer.number_of_segments(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(longer.segment_range(0, 2) == curve);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(longer.lambda(2) == longer.lambda(1) / 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_GE(GC::chain_continuity(longer).joins[1].continuity.f_order, f_order);
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>    const Exact_3::Point wished(Q(7), Q(-3, 5), Q(11));
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite toward = GC::extend_toward(curve, order, wished, Q(2));
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(toward.number_of_segments(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(toward.segment_range(0, 2) == curve);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK(toward.segment(2) == GC::extend_toward(curve.segment(1), order, wished, Q(2)));
include <CGAL/Geometric_continuity/extensions/extend.h>
include <CGAL/Geometric_continuity/extensions/extend.h>    const Composite closed = GC::close(curve, order);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE_EQUAL(closed.number_of_segments(), 3);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_REQUIRE(closed.is_closed());
include <CGAL/Geometric_continuity/extensions/extend.h>    const GC::Composite_continuity<Exact_3> report = GC::chain_continuity(closed);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_GE(report.joins[1].continuity.f_order, f_order);
include <CGAL/Geometric_continuity/extensions/extend.h>    BOOST_CHECK_GE(report.joins[2].continuity.f_order, f_order);
include <CGAL/Geometric_continuity/extensions/extend.h>    for (int l = 0; l < 2; ++l)
include <CGAL/Geometric_continuity/extensions/extend.h>      BOOST_CHECK(closed.segment(l) == curve.segment(l).elevate(closed.degree() - curve.degree()));
include <CGAL/Geometric_continuity/extensions/extend.h>  }
include <CGAL/Geometric_continuity/extensions/extend.h>}
