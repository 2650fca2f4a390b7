// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins of rational curves with double coordinates and weights: every stage is reached and agrees
// with the decision on jets in rational numbers, on joins that hold and on joins that fail by one
// unit in the last place, with short and with long numbers.
//
// Set GEOMETRIC_CONTINUITY_JOINS for the number of joins of each class and
// GEOMETRIC_CONTINUITY_SEED for other numbers.

#include "joins/internal/join_stages.h"

#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>

BOOST_AUTO_TEST_SUITE(rational_joins_on_doubles)

template <int N>
using Traits = std::conditional_t<N == 2, GC::Traits_2<CGAL::Simple_cartesian<double>>, GC::Traits_3<CGAL::Epick>>;
template <int N> using Curve = GC::Rational_bezier_curve<Traits<N>>;

const int joins = static_cast<int>(from_environment("GEOMETRIC_CONTINUITY_JOINS", 40));

Random random_numbers;
int integer(int low, int high) { return random_numbers.integer(low, high); }
double whole(int bits) { return random_numbers.whole(bits); }
double between(double low, double high) { return random_numbers.between(low, high); }

// Points and weights from the join inwards.
template <int N> struct End {
  std::vector<std::array<double, N>> points;
  std::vector<double> weights;
};
template <int N> struct Join { End<N> left, right; };

template <int N> Curve<N> curve(End<N> x, bool left) {
  const std::vector<typename Traits<N>::Point> points = points_along<Traits<N>>(x.points, left);
  if (left) std::reverse(x.weights.begin(), x.weights.end());
  return Curve<N>(points.begin(), points.end(), x.weights.begin(), x.weights.end());
}

// The orders C^k, which are refuted on doubles and otherwise decided on jets.
template <Join_question question, int N>
void check_order_c(const Curve<N>& left, const Curve<N>& right, const GC::Join_continuity<Q>& join, Counter& counter) {
  const Join_answer truth = expected(join, question);
  Stages all{(1u << number_of_stages) - 1};
  BOOST_CHECK_MESSAGE(GC::internal::decide_join<question>(left, right, all) == truth,
                      "C" << highest_difference(question) << ", expected " << static_cast<int>(truth) << "\n"
                          << left << "\n"
                          << right);
  ++counter.answers[static_cast<int>(question)][static_cast<int>(truth)];
  counter.add(question, all);
}

template <int N> void check(const Join<N>& join, Counter& counter) {
  const Curve<N> left = curve<N>(join.left, true), right = curve<N>(join.right, false);
  if (left.is_polynomial() && right.is_polynomial()) return;
  ++counter.joins;
  const GC::Join_continuity<Q> truth =
      GC::internal::Join_decision<Q, N>(left.template end_jet_over<Q>(3), right.template start_jet_over<Q>(3), 3)();
  check_order_c<Join_question::c1, N>(left, right, truth, counter);
  check_order_c<Join_question::c2, N>(left, right, truth, counter);
  check_stages<Join_question::g2, N, true>(left, right, truth, counter);
  check_stages<Join_question::g3, N, true>(left, right, truth, counter);
  check_stages<Join_question::curvature_vector, N, true>(left, right, truth, counter);
  if constexpr (N == 3) {
    check_stages<Join_question::f3, N, true>(left, right, truth, counter);
    check_stages<Join_question::torsion, N, true>(left, right, truth, counter);
  }
}

// Checks the join with a coordinate, and with a weight, changed by one unit in the last place.
template <int N> void check_neighbours(const Join<N>& join, Counter& counter) {
  for (int i = 0; i < 4; ++i) {
    Join<N> other = join;
    End<N>& end = i % 2 ? other.left : other.right;
    const int m = static_cast<int>(end.points.size()) - 1;
    double& x = i / 2 ? end.points[integer((std::min)(m, 1), (std::min)(m, 3))][integer(0, N - 1)]
                      : end.weights[integer(0, (std::min)(m, 3))];
    x = std::nextafter(x, 2 * x + 1);
    check<N>(other, counter);
  }
}

// ---------------------------------------------------------------- joins

template <int N> End<N> random_end(int degree, int bits, int weight_bits) {
  End<N> end;
  for (int j = 0; j <= degree; ++j) {
    end.points.emplace_back();
    for (double& c : end.points.back()) c = whole(bits);
    end.weights.push_back(1 + std::abs(whole(weight_bits)));
  }
  return end;
}

// Contact of the order that is asked for, of ends with whole coordinates and weights: the
// differences and weights of the left end, with x' = D1, x'' = alpha D2 - D1, x''' = gamma D3 along
// the reversed curve, in
//   y' = b x',  y'' = b^2 x'' + c x',  y''' = b^3 x''' + m x'' + d x',  m = 3 b c for G3.
// Nothing if the numbers are too long.
template <int N> std::optional<Join<N>> contact(int order, bool g3) {
  const int m = integer(1, 5), n = integer(0, 2) ? m : integer(1, 5), weight_bits = integer(0, 2) ? 3 : 7;
  Join<N> join{random_end<N>(m, 4, weight_bits), random_end<N>(n, 4, weight_bits)};
  if (m == n && integer(0, 1)) join.right.weights = join.left.weights;
  const auto factors = [](const End<N>& end) { // alpha and gamma
    const int m = static_cast<int>(end.points.size()) - 1;
    std::array<Q, 4> w;
    for (int j = 0; j <= 3; ++j) w[j] = Q(end.weights[(std::min)(j, m)]);
    return std::pair<Q, Q>(Q(Q(m - 1) * w[0] * w[2] / (Q(m) * w[1] * w[1])),
                           Q(Q((m - 1) * (m - 2)) * w[0] * w[0] * w[3] / (Q(m * m) * w[1] * w[1] * w[1])));
  };
  const Q alpha = factors(join.left).first, gamma = factors(join.left).second, beta = factors(join.right).first,
          delta = factors(join.right).second, b = Q(integer(1, 4)) / Q(integer(1, 2)), c = Q(integer(-4, 4)),
          mixed = g3 ? Q(Q(3) * b * c) : Q(integer(-4, 4)), d = Q(integer(-4, 4));
  std::vector<std::array<Q, N>> y(n + 1);
  Q denominator(1);
  for (int i = 0; i < N; ++i) {
    const auto difference = [&](int j) {
      const int l = (std::min)(j, m);
      return Q(Q(join.left.points[l][i]) - Q(join.left.points[0][i]));
    };
    const Q x1 = Q(-difference(1)), x2 = Q(alpha * difference(2) - difference(1)), x3 = Q(-(gamma * difference(3)));
    const std::array<Q, 4> derivative = {Q(0), Q(b * x1), Q(b * b * x2 + c * x1),
                                         Q(b * b * b * x3 + mixed * x2 + d * x1)};
    for (int j = 0; j <= n; ++j) y[j][i] = Q(j == 0 ? join.left.points[0][i] : join.right.points[j][i]);
    y[1][i] = Q(y[0][i] + derivative[1]);
    if (n >= 2 && order >= 2) y[2][i] = Q(y[0][i] + (derivative[2] + derivative[1]) / beta);
    if (n >= 3 && order >= 3) y[3][i] = Q(y[0][i] + derivative[3] / delta);
    for (int j = 0; j <= n; ++j) {
      const Q all = Q(denominator * y[j][i]);
      typename CGAL::Fraction_traits<Q>::Numerator_type p;
      typename CGAL::Fraction_traits<Q>::Denominator_type q;
      CGAL::Fraction_traits<Q>::Decompose()(all, p, q);
      denominator *= Q(q);
    }
  }
  const auto set = [&](double& x, const Q& value) {
    const Q scaled = Q(value * denominator);
    x = CGAL::to_double(scaled);
    return std::abs(x) < 0x1p52 && Q(x) == scaled;
  };
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j <= m; ++j)
      if (!set(join.left.points[j][i], Q(join.left.points[j][i]))) return std::nullopt;
    for (int j = 0; j <= n; ++j)
      if (!set(join.right.points[j][i], y[j][i])) return std::nullopt;
  }
  return join;
}

// One end, and the same turned by pi about its principal normal, which is the axis of y: curvature
// and torsion agree.
template <int N, class Coordinate> Join<N> symmetric(Coordinate coordinate) {
  Join<N> join;
  const int m = integer(2, 5);
  const double y = coordinate();
  for (int j = 0; j <= m; ++j) {
    std::array<double, N> p;
    for (double& c : p) c = coordinate();
    if (j == 0) p[0] = 0;
    if (j <= 1) p[1] = y;
    if constexpr (N == 3)
      if (j <= 2) p[2] = 0;
    join.right.points.push_back(p);
    join.right.weights.push_back(between(1, 2));
    p[0] = -p[0];
    if constexpr (N == 3) p[2] = -p[2];
    join.left.points.push_back(p);
  }
  join.left.weights = join.right.weights;
  return join;
}

// Two halves of a polynomial curve, each in another rational parameter and with another factor of
// 53 bits.
template <int N> Join<N> halves(int bits, int shift) {
  typedef GC::Bezier_curve<Traits<N>> Polynomial;
  const End<N> end = random_end<N>(integer(3, 5), bits, 1);
  const Curve<N> points = curve<N>(end, false);
  const auto parts = Polynomial(points.begin(), points.end()).split(0.5);
  Join<N> join;
  const auto read = [&](const Polynomial& c, bool left) {
    End<N> x;
    const int m = c.degree(), e = integer(-shift, shift);
    const double factor = between(1, 2);
    for (int j = 0; j <= m; ++j) {
      x.points.emplace_back();
      for (int i = 0; i < N; ++i) x.points.back()[i] = c.control_point(left ? m - j : j)[i];
      x.weights.push_back(std::ldexp(factor, j * e));
    }
    return x;
  };
  join.left = read(parts.first, true);
  join.right = read(parts.second, false);
  return join;
}

template <int N> void all_classes(Counter& counter) {
  for (int i = 0; i < joins; ++i) {
    for (int order = 1; order <= 3; ++order)
      if (const std::optional<Join<N>> join = contact<N>(order, i % 2)) {
        check<N>(*join, counter);
        check_neighbours<N>(*join, counter);
      }
    const auto small = [] { return whole(12); };
    const auto large = [] { return whole(50); };
    const auto any = [] { return std::ldexp(between(-1, 1), integer(-6, 6)); };
    for (const Join<N>& join : {symmetric<N>(small), symmetric<N>(large), symmetric<N>(any), halves<N>(10, 2),
                                halves<N>(40, 3), halves<N>(10, 60)}) {
      check<N>(join, counter);
      check_neighbours<N>(join, counter);
    }
    // forms that are multiples of 2^256 and not 0: differences with many zeros at the end, and
    // weights of which only that of the end point has none
    Join<N> join = symmetric<N>([] { return whole(8) * 0x1p30; });
    for (End<N>* end : {&join.left, &join.right}) {
      for (auto& p : end->points) p[1] += 1;
      std::fill(end->weights.begin(), end->weights.end(), 1);
      end->weights[0] += 0x1p-52;
    }
    check<N>(join, counter);
    check_neighbours<N>(join, counter);
    // long coordinates, and weights that are the same but for a factor that is no power of two:
    // tangents of four times the length
    join = symmetric<N>([] { return whole(46); });
    const int bits = integer(4, 9);
    for (std::size_t j = 0; j < join.left.weights.size(); ++j) {
      join.left.weights[j] = 1 + std::abs(whole(bits));
      join.right.weights[j] = 3 * join.left.weights[j];
    }
    const double y = join.right.points[0][1];
    join.right.points[1][0] *= 4;
    join.right.points[2][1] = y + 16 * (join.right.points[2][1] - y);
    check<N>(join, counter);
    check_neighbours<N>(join, counter);
    // no tangent, lines, and ends of other sizes
    join = symmetric<N>(small);
    join.right.points[1] = join.right.points[0];
    check<N>(join, counter);
    join.left.points[1] = join.left.points[0];
    check<N>(join, counter);
    join = halves<N>(12, 1);
    for (double& w : join.right.weights) w *= 0x1p-700;
    for (double& w : join.left.weights) w *= 0x1p700;
    check<N>(join, counter);
    for (auto* points : {&join.left.points, &join.right.points})
      for (auto& p : *points)
        for (double& c : p) c = std::ldexp(c, i % 2 ? 120 : -150);
    check<N>(join, counter);
    check_neighbours<N>(join, counter);
  }
}

// Each stage decides, and each answer occurs.
template <int N> void check_counts(const Counter& counter) {
  const auto at_least = [&](Join_question q, Stage s, long n) {
    BOOST_CHECK_MESSAGE(counter.stages[static_cast<int>(q)][static_cast<int>(s)] >= n,
                        "question " << static_cast<int>(q) << ", stage " << static_cast<int>(s) << ": "
                                    << counter.stages[static_cast<int>(q)][static_cast<int>(s)]);
  };
  BOOST_CHECK(counter.answers[static_cast<int>(Join_question::c1)][static_cast<int>(Join_answer::yes)] >= 4 * joins);
  at_least(Join_question::c1, Stage::floating_point, joins);
  at_least(Join_question::c1, Stage::multiprecision, 4 * joins);
  for (Join_question q : {Join_question::g2, Join_question::g3, Join_question::f3, Join_question::curvature_vector,
                          Join_question::torsion}) {
    if (N == 2 && (q == Join_question::f3 || q == Join_question::torsion)) continue;
    const std::array<long, 4>& answers = counter.answers[static_cast<int>(q)];
    BOOST_CHECK(answers[static_cast<int>(Join_answer::yes)] >= 4 * joins);
    BOOST_CHECK(answers[static_cast<int>(Join_answer::no)] >= 4 * joins);
    at_least(q, Stage::floating_point, joins);
    at_least(q, Stage::fixed_integer, 4 * joins);
    at_least(q, Stage::residue, 4 * joins);
    at_least(q, Stage::multiprecision, 4 * joins);
    if (!is_geometric(q)) BOOST_CHECK(answers[static_cast<int>(Join_answer::undefined)] >= joins);
  }
}

BOOST_AUTO_TEST_CASE(plane) {
  Counter counter;
  all_classes<2>(counter);
  check_counts<2>(counter);
}

BOOST_AUTO_TEST_CASE(space) {
  Counter counter;
  all_classes<3>(counter);
  check_counts<3>(counter);
}

BOOST_AUTO_TEST_SUITE_END()
