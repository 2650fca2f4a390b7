// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins of curves in .g2 files: the answers from decimals are those from rational numbers. With an
// argument, that many joins of each class.

#define BOOST_TEST_MODULE G2_span_reader
#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>
#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/Span_join.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

using namespace std::string_literals;

namespace {

std::mt19937 random_bits;

int below(int n) { return static_cast<int>(random_bits() % static_cast<unsigned>(n)); }

// A decimal, as an integer and the number of its digits behind the point.
struct Written_decimal {
  std::int64_t digits;
  int places;
};

Q value(const Written_decimal& d) {
  Q x = GC::parse_number<Q>(std::to_string(d.digits));
  for (int i = 0; i < d.places; ++i) x /= Q(10);
  return x;
}

std::string plain_text(const Q& x) {
  return written_by([&](std::ostream& os) { GC::write_number(os, x); });
}

// A decimal in one of the forms that files have.
std::string text(const Q& x) {
  Q scaled = x;
  int places = 0;
  while (places < 60 && plain_text(scaled).find('/') != std::string::npos) {
    scaled *= Q(10);
    ++places;
  }
  std::string digits = plain_text(scaled);
  if (digits.find('/') != std::string::npos) return plain_text(x);
  const bool negative = digits[0] == '-';
  if (negative) digits.erase(0, 1);
  const std::string sign = negative ? "-" : below(20) == 0 ? "+" : "";
  if (places > 0 && below(4) == 0) return sign + digits + (below(2) == 0 ? "e-" : "E-") + std::to_string(places);
  if (static_cast<int>(digits.size()) <= places)
    digits.insert(0, static_cast<std::size_t>(places) + 1 - digits.size(), '0');
  std::string result = digits.substr(0, digits.size() - static_cast<std::size_t>(places));
  if (places > 0)
    result += '.' + digits.substr(digits.size() - static_cast<std::size_t>(places)) + (below(8) == 0 ? "000" : "");
  return sign + result;
}

enum Join_class { gap, points_only, tangents, curvatures, third_derivatives, frenet, one_unit_off, classes };

// Two cubic curves with this kind of join, in the format .g2. Numbers have up to so many digits.
template <int N> std::string join(Join_class kind, int digits) {
  typedef std::array<Q, N> Vector;
  const auto number = [digits] {
    std::int64_t largest = 1;
    for (int i = 0; i < digits; ++i) largest *= 10;
    const std::int64_t x = static_cast<std::int64_t>((std::uint64_t(random_bits()) << 32 | random_bits()) %
                                                     static_cast<std::uint64_t>(2 * largest - 1)) -
                           largest + 1;
    return value({x, below(6) == 0 ? below(digits + 3) : digits / 2});
  };
  const auto point = [&] {
    Vector x;
    for (Q& c : x) c = number();
    return x;
  };
  const auto combination = [](const Q& r, const Vector& x, const Q& s, const Vector& y) {
    Vector z;
    for (int i = 0; i < N; ++i) z[i] = Q(r * x[i] + s * y[i]);
    return z;
  };
  std::array<Vector, 4> p, q;
  for (Vector& x : p) x = point();
  if (below(10) == 0) p[2] = p[3];
  if (below(10) == 0) p[1] = p[2];
  for (Vector& x : q) x = point();
  const Q factors[] = {Q(1), Q(2), Q(3), value({5, 1}), value({125, 2})}, beta = factors[below(5)],
          second = below(2) == 0 ? Q(0) : factors[below(5)], third = below(2) == 0 ? Q(0) : factors[below(5)];
  // divided by the factors 3, 6 and 6 of the derivatives
  const Vector x1 = combination(Q(1), p[3], Q(-1), p[2]), step = combination(Q(1), p[2], Q(-1), p[1]),
               x2 = combination(Q(1), x1, Q(-1), step),
               x3 = combination(Q(1), x2, Q(-1), combination(Q(1), step, Q(-1), combination(Q(1), p[1], Q(-1), p[0])));
  const Vector y1 = combination(beta, x1, Q(0), x1), y2 = combination(Q(beta * beta), x2, second, x1);
  Vector y3 = combination(Q(beta * beta * beta), x3, Q(Q(6) * beta * second), x2);
  y3 = combination(Q(1), y3, third, x1);
  if (kind == frenet) y3 = combination(Q(1), y3, Q(7), x2);
  if (kind > gap) q[0] = p[3];
  if (kind >= tangents) q[1] = combination(Q(1), q[0], Q(1), y1);
  if (kind >= curvatures) q[2] = combination(Q(1), combination(Q(2), q[1], Q(-1), q[0]), Q(1), y2);
  if (kind >= third_derivatives)
    q[3] = combination(Q(1), combination(Q(3), q[2], Q(-3), q[1]), Q(1), combination(Q(1), q[0], Q(1), y3));
  if (kind == one_unit_off) {
    Q& x = q[below(4)][below(N)];
    x += value({1, digits});
  }
  std::string file;
  for (const auto& points : {p, q}) {
    const Q start = below(2) == 0 ? Q(0) : value({below(1000000000) - 500000000, below(9)}),
            length = below(2) == 0 ? Q(1) : factors[below(5)];
    file += "100 1 0 0 " + std::to_string(N) + " 0\n4 4\n";
    for (int i = 0; i < 4; ++i) file += text(start) + ' ';
    for (int i = 0; i < 4; ++i) file += text(Q(start + length)) + ' ';
    for (const Vector& x : points)
      for (const Q& c : x) file += text(c) + (below(3) == 0 ? "\n" : " ");
    file += '\n';
  }
  return file;
}

template <class Join> std::string answers(const Join& join) {
  const auto flag = [](const std::optional<bool>& b) { return !b ? "-" : *b ? "y" : "n"; };
  return ::text(join, ' ', join.regular, flag(join.tangent_equal), flag(join.curvature_equal),
                flag(join.curvature_vector_equal), flag(join.torsion_equal));
}

template <class Traits, class Number> std::vector<GC::G2_span<Traits, Number>> read_spans(const std::string& text) {
  std::istringstream is(text);
  GC::G2_span_reader<Traits, Number> reader(is, "f.g2", 3);
  std::vector<GC::G2_span<Traits, Number>> spans;
  for (GC::G2_span<Traits, Number> span; reader.next(span);) spans.push_back(std::move(span));
  return spans;
}

// Returns the order of geometric continuity of the join of two spans.
template <class Span> int check_join(const Span& left, const Span& right, const std::string& file) {
  int order = 0;
  for (int max_order : {3, below(3)}) {
    const GC::Span_join<Span> ends(left, right);
    const auto expected = GC::continuity(left.jets(), right.jets(), max_order),
               orders = continuity_orders(left, right, max_order);
    auto completed = ends.orders(max_order);
    ends.complete(completed, max_order);
    for (const auto& join : {completed, continuity(left, right, max_order)})
      BOOST_CHECK_MESSAGE(answers(join) == answers(expected), answers(join) << " is not " << answers(expected) << '\n'
                                                                            << file);
    BOOST_CHECK_MESSAGE(orders.c_order == expected.c_order && orders.g_order == expected.g_order &&
                            orders.f_order == expected.f_order,
                        "orders of " << answers(expected) << '\n'
                                     << file);
    if (max_order == 3) order = expected.g_order;
  }
  return order;
}

// The joins of all spans that follow one another in a file; returns the order of the last one.
template <class Traits, class Number = GC::Decimal> int check_joins(const std::string& file, std::size_t count = 0) {
  const auto spans = read_spans<Traits, Number>(file);
  BOOST_REQUIRE(count == 0 || spans.size() == count);
  int order = 0;
  for (std::size_t j = 1; j < spans.size(); ++j) order = check_join(spans[j - 1], spans[j], file);
  return order;
}
template <class Traits, class Number> int check_roads(const std::string& file) {
  return check_joins<Traits, Number>(file, 2);
}

// A B-spline curve with knots of all multiplicities; every point or knot with a few digits, or
// points or knots with too many for integers of fixed length.
std::string spline(int dimension, bool is_long, bool has_long_knots = false) {
  const int order = 1 + below(6), points = order + below(8), places = below(4);
  std::vector<int> knots(points + order);
  for (int j = 0; j < points + order; ++j) {
    knots[j] = j == 0 ? below(20) - 10 : knots[j - 1] + (below(2) == 0 ? below(5) : 0);
    if (j >= order && knots[j] == knots[j - order]) ++knots[j];
    if (j == points && knots[j] == knots[order - 1]) ++knots[j];
  }
  const std::int64_t units = has_long_knots ? 1 + random_bits() % (below(2) == 0 ? 1000 : 1000000000) : 1;
  std::string file =
      "100 1 0 0 " + std::to_string(dimension) + " 0\n" + std::to_string(points) + ' ' + std::to_string(order) + '\n';
  for (int knot : knots)
    file += text(value({knot * units + (has_long_knots ? std::int64_t(knot) * knot * knot : 0), places})) + ' ';
  const int size = below(5) == 0 ? 3 : 100000;
  const bool is_flat = below(4) == 0, has_repeated = below(4) == 0; // coordinates, points
  std::string point;
  for (int j = 0; j < points; ++j) {
    if (j == 0 || !has_repeated || below(2) == 0) {
      point.clear();
      for (int i = 0; i < dimension; ++i) {
        const std::int64_t digits = i == 2 && is_flat ? 0 : below(size) - size / 2;
        point += '\n' + text(value({is_long ? digits * 10000000000007 : digits, below(7)}));
      }
    }
    file += point;
  }
  return file + '\n';
}

template <int N, class Traits> void check_splines() {
  random_bits.seed(20261123 + N);
  std::size_t spans = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string file = spline(N, i >= 300);
    check_joins<Traits>(file);
    spans += read_spans<Traits, GC::Decimal>(file).size();
  }
  BOOST_CHECK_GT(spans, 700);
  for (int i = 0; i < 200; ++i) {
    const std::string file = spline(N, i % 4 == 0, i % 2 == 0);
    check_joins<Traits>(file);
    check_joins<Traits, double>(file);
  }
}

// Spans of two curves, of which one could continue the other but for a knot or a coordinate.
template <int N, class Traits> void check_other_curves() {
  const std::string head = "100 1 0 0 " + std::to_string(N) + " 0\n", point = N == 2 ? "1 2 " : "1 2 5 ",
                    other = N == 2 ? "3 1 " : "3 1 0 ", third = N == 2 ? "7 0 " : "7 0 2 ";
  const std::string left = head + "4 4\n0 1 2 3 4 5 6 7\n" + point + other + other + third + '\n';
  for (const std::string& right :
       {"1 2 3 4 5 6 7 8\n" + other + other + third + point, "1 2 3 4 5 7 8 9\n" + other + other + third + point,
        "1 2 3 4 5 6 7 8\n" + other + point + third + point})
    check_joins<Traits>(left + head + "4 4\n" + right + '\n', 2);
  // of another degree
  check_joins<Traits>(left + head + "3 3\n2 3 4 5 6 7\n" + other + third + point + '\n' + left, 3);
  // quintics with Bezier points at the other end only, or nearly
  for (const std::string& knots :
       {"0 0 0 0 0 0 4 4 4 5 6 7\n", "0 0 0 0 0 0 4 4 4 4 5 6\n", "0 0 0 0 0 0 4 5 6 7 8 9\n"})
    for (const std::string& start :
         {"4 4 4 4 4 4 5 5 5 5 5 5\n", "1 2 3 4 4 4 5 5 5 5 5 5\n", "4 4 4 4 4 4 5 6 7 8 9 10\n"})
      check_joins<Traits>(head + "6 6\n" + knots + point + other + other + third + point + third + '\n' + head +
                              "6 6\n" + start + third + point + other + other + third + point + '\n',
                          2);
}

template <int N, class Traits> void check_all_classes() {
  const unsigned seed = 20261122;
  const auto& suite = boost::unit_test::framework::master_test_suite();
  const int repetitions = suite.argc > 1 ? std::stoi(suite.argv[1]) : 300;
  BOOST_TEST_MESSAGE("seed " << seed << ", " << repetitions << " joins of each class");
  random_bits.seed(seed + N);
  std::map<int, int> counts;
  for (int kind = 0; kind < classes; ++kind)
    for (int i = 0; i < repetitions; ++i) {
      const std::string file = join<N>(static_cast<Join_class>(kind), 1 + below(18));
      ++counts[check_roads<Traits, GC::Decimal>(file)];
      if (i % 3 == 0) check_roads<Traits, double>(file);
    }
  // each class occurs
  for (int order = -1; order <= 3; ++order) BOOST_CHECK_GT(counts[order], repetitions / 4);
}

} // namespace

BOOST_AUTO_TEST_CASE(decimals_in_the_plane) { check_all_classes<2, Exact_2>(); }
BOOST_AUTO_TEST_CASE(decimals_in_space) { check_all_classes<3, Exact_3>(); }
BOOST_AUTO_TEST_CASE(inner_knots) {
  check_splines<2, Exact_2>();
  check_splines<3, Exact_3>();
  check_other_curves<2, Exact_2>();
  check_other_curves<3, Exact_3>();
}

// Parameters and coordinates that have no common grid of short integers, weights, and high degrees
// and orders: the answers are those of the jets.
BOOST_AUTO_TEST_CASE(spans_off_the_grid) {
  const std::string head = "100 1 0 0 2 0\n4 4\n", points = " 0 0 1 2 3 1 4 0\n", next = " 4 0 5 -1 6 1 8 2\n",
                    usual = "0 0 0 0 1 1 1 1";
  const auto from_to = [](const std::string& a, const std::string& b) {
    return a + ' ' + a + ' ' + a + ' ' + a + ' ' + b + ' ' + b + ' ' + b + ' ' + b;
  };
  std::vector<std::string> files;
  for (const std::string& knots :
       {usual, from_to("0", "1e-40"), from_to("1e-40", "1e40"), from_to("0", "123456789012345678"),
        from_to("0", "123456789012345677"), "1e-30 2e-30 3e-30 1 2 3 4 5"s, "1 2 3 4 5 6e30 7e30 8e30"s})
    for (const std::string& more : {usual, from_to("0", "123456789012345677")}) {
      files.push_back(head + knots + points + head + more + next);
      files.push_back(head + more + points + head + knots + next);
    }
  files.push_back(head + usual + " 0 0 1 2 3 1/1000003 4/1000000007 0\n" + head + usual +
                  " 4/1000000007 0 5 -1/998244353 6 1/1000033 8 2\n");
  files.push_back(head + usual + " 0 0 1 2 3 1/1000003 4 0\n" + head + usual +
                  " 4 0 1234567890123456 -1/1009 6 1 8 2\n");

  const std::string rational = "100 1 0 0 2 1\n3 3\n0 0 0 1 1 1 0 0 1 1 1 2 4 0 1\n";
  files.push_back(head + usual + points + rational);
  files.push_back(rational + head + usual + next);
  std::string high = "100 1 0 0 2 0\n18 18\n";
  for (int end : {0, 1})
    for (int i = 0; i < 18; ++i) high += std::to_string(end) + ' ';
  for (int i = 0; i < 18; ++i)
    high += std::to_string(i + 4) + ' ' + std::to_string(i * i % 5 - (i < 3 ? i * i : 0)) + ' ';
  files.push_back(head + usual + points + high + '\n');
  files.push_back(high + '\n' + head + usual + next);
  for (const std::string& file : files) {
    check_roads<Exact_2, GC::Decimal>(file);
    check_roads<Exact_2, double>(file);
  }

  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Any;
  const auto read = [](const std::string& text) {
    std::istringstream is(text);
    GC::G2_span_reader<Any> reader(is, "f.g2", 5);
    GC::G2_span<Any> span;
    BOOST_REQUIRE(reader.next(span));
    return span;
  };
  const GC::G2_span<Any> left = read(head + usual + points), right = read(head + usual + next),
                         spatial = read("100 1 0 0 3 0\n2 2\n0 0 1 1 0 0 0 1 1 1\n");
  for (int max_order : {0, 3, 4, 5})
    BOOST_CHECK_EQUAL(answers(continuity(left, right, max_order)),
                      answers(GC::continuity(left.jets(), right.jets(), max_order)));
  CHECK_ERROR(continuity(left, right, -1), negative_count);
  CHECK_ERROR(continuity(right, spatial), dimension_mismatch);
  CHECK_ERROR(continuity_orders(right, spatial), dimension_mismatch);
}

// Short decimals are decided on integers, without the work on jets: legs beyond those of doubles,
// and domains of any lengths.
BOOST_AUTO_TEST_CASE(decided_on_integers) {
  const std::string head = "100 1 0 0 2 0\n4 4\n";
  const auto order = [&](const std::string& ends, const std::string& unit, bool is_smooth) {
    std::string file = head + "0 0 0 0 1 1 1 1\n";
    for (const int x : {0, 0, 1, 2, 3, 2, 4, 1}) file += std::to_string(x) + unit + ' ';
    file += '\n' + head + ends;
    for (const int x : {4, 1, is_smooth ? 5 : 7, 0, 6, 3, 8, 2}) file += std::to_string(x) + unit + ' ';
    const auto spans = read_spans<Exact_2, GC::Decimal>(file);
    const GC::Work_scope none(GC::Work_limit(1));
    return continuity_orders(spans[0], spans[1]).g_order;
  };
  for (const std::string& unit : {""s, "e-6"s, "3456789012345"s, "34567890123456701"s}) {
    BOOST_CHECK_EQUAL(order("0 0 0 0 1 1 1 1\n", unit, false), 0);
    BOOST_CHECK_EQUAL(order("0 0 0 0 2 2 2 2\n", unit, true), 1);
    BOOST_CHECK_EQUAL(order("0 0 0 0 1.234567 1.234567 1.234567 1.234567\n", unit, true), 1);
  }
}

// Enclosures of the jets at a join of two spans, with respect to parameters of [0, 1], contain the
// exact ones, and are narrow. Returns whether there are some.
template <class Span>
bool has_enclosures(const Span& left, const Span& right, const Q& left_length, const Q& right_length) {
  const auto check = [&](const auto& enclosed, const auto& exact, const Q& length) {
    Q power(1), largest(0);
    for (int k = 0; k <= 3; ++k, power *= length)
      for (int i = 0; i < left.dimension(); ++i) {
        const Q x = exact[k][i] * power, lower(enclosed[k][i].inf()), upper(enclosed[k][i].sup());
        largest = (std::max)(largest, Q(abs(x)));
        BOOST_CHECK(lower <= x && x <= upper && upper - lower <= largest / Q(1e14));
      }
  };
  const auto check_both = [&](const auto& x, const auto& y) {
    check(x, left.jets().template end_jet_over<Q>(3), left_length);
    check(y, right.jets().template start_jet_over<Q>(3), right_length);
  };
  return Span::visit_enclosures(left, right, check_both);
}

// On grids: short decimals, decimals of more than 22 places, integers that no double has, and
// fractions; not beyond them.
template <class Number> void check_enclosures() {
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Any;
  constexpr bool rounded = std::is_floating_point_v<Number>;
  const auto is_enclosed = [](const std::string& left, const std::string& right, int left_length, int right_length) {
    const auto x = read_spans<Any, Number>(left), y = read_spans<Any, Number>(right);
    BOOST_REQUIRE(x.size() == 1 && y.size() == 1);
    return has_enclosures(x[0], y[0], Q(left_length), Q(right_length));
  };
  const std::string unit = "0 0 0 0 1 1 1 1\n", four = "2 2 2 2 6 6 6 6\n";
  for (const std::string& end : {""s, "e-30"s, "3456789012345677"s}) {
    const auto curve = [&](int dimension, const std::string& knots, const std::vector<int>& numbers) {
      std::string file = "100 1 0 0 " + std::to_string(dimension) + " 0\n4 4\n" + knots;
      for (const int x : numbers) file += std::to_string(x) + end + ' ';
      return file + '\n';
    };
    const std::string planar = curve(2, four, {12, 5, -7, 3, 9, 9, 31, -8}),
                      next = curve(2, unit, {31, -8, 17, 4, -5, 23, 6, 11}),
                      spatial = curve(3, unit, {12, 5, -7, 3, 9, 19, 31, -8, 4, -17, 2, 13}),
                      of_four = curve(4, unit, {1, 2, 3, 4, 5, 6, 7, 8, 9, 8, 7, 6, 5, 4, 3, 2});
    BOOST_CHECK(is_enclosed(planar, next, 4, 1) && is_enclosed(next, planar, 1, 4));
    BOOST_CHECK(is_enclosed(spatial, spatial, 1, 1));
    BOOST_CHECK(!is_enclosed(of_four, of_four, 1, 1) && !is_enclosed(planar, spatial, 4, 1));
    // has Bezier points with denominators
    const std::string inner = curve(2, "0 1 2 3 7 9 10 12\n", {12, 5, -7, 3, 9, 9, 31, -8});
    BOOST_CHECK_EQUAL(is_enclosed(inner, next, 4, 1), !rounded && end.size() < 5);
    const std::string weighted = "100 1 0 0 2 1\n2 2\n0 0 1 1 0 0 1 1 1 2\n";
    BOOST_CHECK(!is_enclosed(weighted, next, 1, 1) && !is_enclosed(next, weighted, 1, 1));
  }
  const std::string head = "100 1 0 0 2 0\n2 2\n0 0 1 1\n";
  BOOST_CHECK_EQUAL(is_enclosed(head + "0.5 0.25 1e-40 2e20\n", head + "1 2 3 4\n", 1, 1), rounded);
}

BOOST_AUTO_TEST_CASE(enclosed_jets) {
  check_enclosures<GC::Decimal>();
  check_enclosures<double>();
}

// Coordinates that are no doubles, with legs that are multiples of 2^32: the form for G2 is a
// multiple of 2^128, so that short residues of it are 0, and smaller than the rounding errors, but
// not always 0.
BOOST_AUTO_TEST_CASE(residues_that_vanish) {
  random_bits.seed(20261124);
  const std::int64_t offset = (std::int64_t(1) << 58) - 1, unit = std::int64_t(1) << 32;
  for (int i = 0; i < 50; ++i) {
    const std::int64_t a = 4096 + below(4096), b = 4096 + below(4096);
    if (a == b || std::gcd(a, b) != 1) continue;
    // a^2 x - b^2 y = 1, by Euclid's algorithm
    std::int64_t r = a * a, s = b * b, x = 1, next = 0;
    while (s != 0) {
      const std::int64_t q = r / s;
      std::tie(r, s) = std::make_pair(s, r - q * s);
      std::tie(x, next) = std::make_pair(next, x - q * next);
    }
    if (x < 0) x += b * b;
    for (const bool holds : {false, true}) {
      const std::int64_t right = holds ? b * b : x, left = holds ? a * a : (a * a * x - 1) / (b * b);
      BOOST_REQUIRE_EQUAL(a * a * right - b * b * left, holds ? 0 : 1);
      const std::int64_t points[2][4][2] = {{{-3 * a, 7}, {-2 * a, left}, {-a, 0}, {0, 0}},
                                            {{0, 0}, {b, 0}, {2 * b, right}, {3 * b, 5}}};
      std::string file;
      for (const auto& curve : points) {
        file += "100 1 0 0 2 0\n4 4\n0 0 0 0 1 1 1 1\n";
        for (const auto& point : curve)
          for (const std::int64_t coordinate : point) file += std::to_string(offset + unit * coordinate) + ' ';
        file += '\n';
      }
      BOOST_CHECK_EQUAL((check_roads<Exact_2, GC::Decimal>(file)) >= 2, holds);
    }
  }
}
