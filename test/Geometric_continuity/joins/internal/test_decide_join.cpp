// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The predicates of join_predicates.h and continuity() on double coordinates: every stage is
// reached and agrees with the plain decision in rational numbers (Join_decision on jets), on joins
// of every class.
//
// Set GEOMETRIC_CONTINUITY_JOINS for the number of joins of each class and
// GEOMETRIC_CONTINUITY_SEED for other numbers.

#define BOOST_TEST_MODULE filtered_joins

#include "joins/internal/join_stages.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <boost/multiprecision/cpp_int.hpp>

typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Plane;
// the predicates are exact although the kernel's are not
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Space;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_space;
template <class Traits> using Curve = GC::Bezier_curve<Traits>;
template <class Traits> constexpr int dimension = GC::dimension_v<Traits>;

// ---------------------------------------------------------------- the reference

template <class Traits> using Exact_jet = GC::Coordinate_jet<Q, dimension<Traits>>;

template <class Traits>
GC::Join_continuity<Q> reference(const Curve<Traits>& left, const Curve<Traits>& right, int max_order = 3) {
  const Exact_jet<Traits> x = left.template end_jet_over<Q>(3), y = right.template start_jet_over<Q>(3);
  return GC::internal::Join_decision<Q, dimension<Traits>>(x, y, max_order)();
}

bool same(const GC::Join_continuity<Q>& x, const GC::Join_continuity<Q>& y) {
  return x.c_order == y.c_order && x.g_order == y.g_order && x.f_order == y.f_order && x.regular == y.regular &&
         x.tangent_equal == y.tangent_equal && x.curvature_equal == y.curvature_equal &&
         x.curvature_vector_equal == y.curvature_vector_equal && x.torsion_equal == y.torsion_equal &&
         x.betas() == y.betas();
}

// continuity() by jets and by the stages on doubles: every member is the same.
template <class Traits>
void check_all(const Curve<Traits>& left, const Curve<Traits>& right, int max_order, Counter& counter) {
  const GC::Join_continuity<Q> truth = reference(left, right, max_order);
  GC::Join_continuity<Q> join;
  ++counter.joins;
  const GC::internal::Double_ends<dimension<Traits>> ends(GC::internal::left_end(left), GC::internal::right_end(right));
  GC::internal::decide_all_on_doubles(ends, max_order, join, GC::internal::Join_asked::all);
  bool right_answers = same(join, truth);
  if constexpr (std::is_same_v<GC::Predicate_FT<Traits>, Q>)
    right_answers = right_answers && same(GC::continuity(left, right, max_order), truth);
  if (!right_answers && counter.mismatches++ < 5)
    BOOST_ERROR("order " << max_order << ", expected " << truth << ", not " << join << "\n" << left << "\n" << right);
}

template <Join_question... questions, class Function> void for_each_question(const Function& f) {
  (f(std::integral_constant<Join_question, questions>()), ...);
}
template <class Function> void for_all_questions(const Function& f) {
  for_each_question<Join_question::c0, Join_question::c1, Join_question::c2, Join_question::c3, Join_question::g1,
                    Join_question::g2, Join_question::g3, Join_question::f3, Join_question::curvature_vector,
                    Join_question::torsion>(f);
}

template <class Traits> void check(const Curve<Traits>& left, const Curve<Traits>& right, Counter& counter) {
  check_all(left, right, 3, counter);
  check_all(left, right, static_cast<int>(counter.joins / 2 % 3), counter);
  const GC::Join_continuity<Q> join = reference(left, right);
  for_all_questions([&](auto question) {
    check_stages<decltype(question)::value, dimension<Traits>, false>(left, right, join, counter);
  });
}

// ---------------------------------------------------------------- joins

template <int N> using Points = std::vector<std::array<double, N>>; // from the join inwards

template <int N> struct Join {
  Points<N> left, right;
  std::pair<double, double> left_domain{0, 1}, right_domain{0, 1};
};

template <class Traits>
Curve<Traits> curve(const Points<dimension<Traits>>& x, bool left, const std::pair<double, double>& domain) {
  const std::vector<typename Traits::Point> points = points_along<Traits>(x, left);
  return Curve<Traits>(points.begin(), points.end(), domain.first, domain.second);
}

// Two polygons of whole numbers with contact of order `order` after a reparametrisation with
// beta_1 = p/q, and with Y''' = beta_1^3 X''' + (3 beta_1 beta_2 + mu) X'' + beta_3 X'. Everything
// is a multiple of the denominators, so that all points are whole. Derivatives that the degree of
// the right polygon does not allow are left out.
template <int N> Join<N> contact(Random& random, int m, int n, int p, int q, int order, bool g3, int bits) {
  Join<N> join;
  join.left.resize(m + 1);
  join.right.resize(n + 1);
  const double denominator = 6. * q * q * q * std::max(n * (n - 1) * (n - 2), 1) * (n == 2 ? 2 : 1);
  for (auto* x : {&join.left, &join.right})
    for (auto& point : *x)
      for (double& c : point) c = random.whole(bits);
  for (auto& point : join.left)
    for (double& c : point) c *= denominator;
  join.right[0] = join.left[0];
  const Q beta = Q(p) / Q(q), beta2 = Q(random.integer(-9, 9)) / Q(q),
          mu = Q(3) * beta * beta2 + Q(g3 ? 0 : random.integer(-9, 9)), beta3 = Q(random.integer(-9, 9));
  for (int i = 0; i < N; ++i) {
    std::array<Q, 4> x, e{}, d{}, y{}; // points, inward differences, derivatives left and right
    for (int j = 0; j <= std::min(m, 3); ++j) x[j] = Q(join.left[j][i]);
    e = {x[0], Q(x[1] - x[0]), Q(x[2] - 2 * x[1] + x[0]), Q(x[3] - 3 * x[2] + 3 * x[1] - x[0])};
    Q factor(1);
    for (int j = 0; j <= std::min(m, 3); ++j) {
      d[j] = Q(factor * e[j]);
      factor *= Q(j - m);
    }
    y = {d[0], Q(beta * d[1]), Q(beta * beta * d[2] + beta2 * d[1]),
         Q(beta * beta * beta * d[3] + mu * d[2] + beta3 * d[1])};
    std::array<Q, 4> f{};
    factor = Q(1);
    for (int j = 0; j <= std::min({n, 3, order}); ++j) {
      f[j] = Q(y[j] / factor);
      factor *= Q(n - j);
    }
    const std::array<Q, 4> z = {f[0], Q(f[0] + f[1]), Q(f[0] + 2 * f[1] + f[2]), Q(f[0] + 3 * f[1] + 3 * f[2] + f[3])};
    for (int j = 0; j <= std::min({n, 3, order}); ++j) {
      join.right[j][i] = CGAL::to_double(z[j]);
      BOOST_REQUIRE(Q(join.right[j][i]) == z[j]);
    }
  }
  return join;
}

template <int N> double& random_coordinate(Random& random, Join<N>& join) {
  Points<N>& x = random.integer(0, 1) ? join.left : join.right;
  return x[random.integer(0, std::min<int>(3, static_cast<int>(x.size()) - 1))][random.integer(0, N - 1)];
}

template <int N, class Function> void for_each_coordinate(Join<N>& join, Function f) {
  for (auto* x : {&join.left, &join.right})
    for (auto& point : *x)
      for (int i = 0; i < N; ++i) f(point[i], i);
}

template <int N> Join<N> random_contact(Random& random) {
  const int m = random.integer(1, 7), n = random.integer(0, 2) ? m : random.integer(1, 7);
  const bool simple = random.integer(0, 1);
  const int p = simple ? 1 << random.integer(0, 3) : random.integer(1, 7), q = simple ? 1 << random.integer(0, 2) : 3;
  const int r = random.integer(1, 3), s = random.integer(0, 1);
  return contact<N>(random, m, n, p, q, r, s, random.integer(2, 12));
}

template <int N> Join<N> exact(Random& random) { return random_contact<N>(random); }

// With domains: C^k joins, with whole numbers or others as ends.
template <int N> Join<N> parametric(Random& random) {
  const int m = random.integer(1, 7), p = random.integer(1, 3), q = random.integer(1, 3);
  Join<N> join = contact<N>(random, m, random.integer(0, 1) ? m : random.integer(1, 7), p, q, 3, true, 8);
  if (random.integer(0, 1)) { // beta_2 = beta_3 = 0
    for (auto& point : join.right) point = join.left[0];
    Q power(1);
    join.right.resize(m + 1);
    for (int j = 0; j <= std::min(m, 3); ++j)
      for (int i = 0; i < N; ++i) join.right[j][i] = 0;
    for (int i = 0; i < N; ++i) {
      const auto x = [&](int j) { return j <= m ? join.left[j][i] : 0.; };
      const double b = static_cast<double>(p) / q, l1 = x(1) - x(0), l2 = x(2) - x(1), l3 = x(3) - x(2);
      const double d1 = -b * l1, d2 = b * b * (l2 - l1), d3 = -b * b * b * ((l3 - l2) - (l2 - l1));
      const double points[4] = {x(0), x(0) + d1, x(0) + 2 * d1 + d2, x(0) + 3 * d1 + 3 * d2 + d3};
      for (int j = 0; j <= std::min(m, 3); ++j) join.right[j][i] = points[j];
    }
  }
  const double unit = random.integer(0, 2) ? 1 : random.integer(0, 1) ? 0.1 : 0x1p-30, start = random.integer(-3, 3);
  join.left_domain = {start, start + q * unit};
  join.right_domain = {start, start + p * unit};
  return join;
}

template <int N> Join<N> off_by_one_ulp(Random& random) {
  Join<N> join = random_contact<N>(random);
  double& x = random_coordinate(random, join);
  x = std::nextafter(x, random.integer(0, 1) ? 1e300 : -1e300);
  return join;
}

template <int N> Join<N> off_by_one_unit(Random& random) {
  Join<N> join = random_contact<N>(random);
  random_coordinate(random, join) += random.integer(0, 1) ? 1 : -1;
  return join;
}

template <int N> Join<N> grossly_off(Random& random) {
  Join<N> join = random_contact<N>(random);
  random_coordinate(random, join) += random.any(20, 40);
  return join;
}

// Curvatures of one magnitude and opposite senses: the right polygon is the left one, turned by
// half a turn about the join. Of one end in two a point of the other one is not.
template <int N> Join<N> half_turn(Random& random) {
  Join<N> join;
  join.left.resize(random.integer(1, 5) + 1);
  for (auto& point : join.left)
    for (double& x : point) x = random.integer(0, 1) ? random.whole(20) : random.any(-40, 40);
  join.left[0].fill(0);
  join.right = join.left;
  for (auto& point : join.right)
    for (double& x : point) x = -x;
  if (random.integer(0, 1)) random_coordinate(random, join) += 1;
  return join;
}

template <int N> Join<N> scaled_by(Random& random, Join<N> join, int low, int high) {
  const int e = random.integer(low, high);
  for_each_coordinate(join, [&](double& x, int) { x = std::ldexp(x, e); });
  return join;
}
template <int N> Join<N> almost(Random& random) {
  return random.integer(0, 1) ? random_contact<N>(random) : off_by_one_ulp<N>(random);
}
template <int N> Join<N> tiny(Random& random) { return scaled_by<N>(random, almost<N>(random), -700, -100); }
template <int N> Join<N> huge(Random& random) { return scaled_by<N>(random, almost<N>(random), 50, 960); }
// down to 2^-1074, and below: then coordinates are rounded, and the joins are what they become
template <int N> Join<N> subnormal(Random& random) { return scaled_by<N>(random, almost<N>(random), -1090, -1030); }

// Another scale for each coordinate keeps the order of contact.
template <int N> Join<N> mixed_exponents(Random& random) {
  Join<N> join = almost<N>(random);
  const int range = random.integer(0, 1) ? 12 : 600;
  std::array<int, N> e;
  for (int& x : e) x = random.integer(-range, range);
  for_each_coordinate(join, [&](double& x, int i) { x = std::ldexp(x, e[i]); });
  return join;
}

template <int N> Join<N> anything(Random& random) {
  Join<N> join;
  join.left.resize(random.integer(1, 8));
  join.right.resize(random.integer(1, 8));
  const int low = random.integer(-1000, 900), high = low + random.integer(0, 100);
  for_each_coordinate(join, [&](double& x, int) { x = random.integer(0, 9) ? random.any(low, high) : 0; });
  join.right[0] = join.left[0];
  return join;
}

// Zero tangents, zero curvature, cusps, planes in space, coordinate axes, coincident points.
template <int N> Join<N> degenerate(Random& random) {
  Join<N> join = almost<N>(random);
  const int what = random.integer(0, 7);
  const auto both = [&](int j, auto f) {
    for (auto* x : {&join.left, &join.right})
      if (j < static_cast<int>(x->size())) f((*x)[j], (*x)[0]);
  };
  switch (what) {
  case 0: // zero tangent, on one side or both
    if (random.integer(0, 1)) join.left[1] = join.left[0];
    if (random.integer(0, 1)) join.right[1] = join.right[0];
    break;
  case 1: // zero curvature: the polygon starts straight
    for (auto* x : {&join.left, &join.right})
      for (int j = 2; j < static_cast<int>(x->size()) && j < random.integer(3, 4); ++j)
        for (int i = 0; i < N; ++i) (*x)[j][i] = (*x)[0][i] + j * ((*x)[1][i] - (*x)[0][i]);
    break;
  case 2: // cusp
    join.right = join.left;
    break;
  case 3: // one coordinate is constant
    for_each_coordinate(join, [&](double& x, int i) {
      if (i == N - 1) x = 7;
    });
    break;
  case 4: // tangent along an axis
    both(1, [](auto& x, const auto& origin) {
      for (int i = 1; i < N; ++i) x[i] = origin[i];
    });
    break;
  case 5: // all points of a side coincide, or all
    for (auto& x : join.left) x = join.left[0];
    if (random.integer(0, 1))
      for (auto& x : join.right) x = join.left[0];
    break;
  case 6: // the same curve on both sides, continued as it is
    join.right = join.left;
    for (auto& point : join.right)
      for (int i = 0; i < N; ++i) point[i] = 2 * join.left[0][i] - point[i];
    break;
  default: // on one line
    for_each_coordinate(join, [&](double& x, int i) {
      if (i > 0) x = 0;
    });
  }
  return join;
}

// Curvature vectors and torsions that agree although the tangents differ.
template <int N> Join<N> invariants_only(Random& random) {
  Join<N> join = random_contact<N>(random);
  if (random.integer(0, 1)) { // the coordinates permuted on the right: the torsion stays
    for (auto& point : join.right) std::rotate(point.begin(), point.begin() + 1, point.end());
  } else { // curvature vectors along the last axis
    const int m = static_cast<int>(join.left.size()) - 1, n = static_cast<int>(join.right.size()) - 1;
    const double s = random.integer(1, 99), t = random.integer(0, 3) ? s : -s;
    const auto set = [&](Points<N>& x, double other) {
      double g = 0;
      for (int i = 0; i < N; ++i) x[0][i] = 0;
      for (int i = 0; i < N; ++i) {
        const double a = i + 1 < N ? random.integer(1, 99) : 0;
        g += a * a;
        if (x.size() > 1) x[1][i] = a;
        if (x.size() > 2) x[2][i] = 2 * a;
      }
      if (x.size() > 2) x[2][N - 1] = other * g;
    };
    set(join.left, m * (n - 1) * s);
    set(join.right, n * (m - 1) * t);
  }
  return join;
}

// ---------------------------------------------------------------- the tests

long joins_per_class() { return from_environment("GEOMETRIC_CONTINUITY_JOINS", 2000); }

const char* const kind_names[] = {"C0", "C1", "C2", "C3", "G1", "G2", "G3", "F3", "curvature vector", "torsion"};

template <class Traits> Counter run(const char* name, Join<dimension<Traits>> (*make)(Random&), long joins) {
  Random random;
  Counter counter;
  for (long k = 0; k < joins; ++k) {
    const Join<dimension<Traits>> join = make(random);
    const Curve<Traits> left = curve<Traits>(join.left, true, join.left_domain),
                        right = curve<Traits>(join.right, false, join.right_domain);
    check(left, right, counter);
  }
  BOOST_CHECK_MESSAGE(counter.mismatches == 0, name << " in dimension " << dimension<Traits> << ": "
                                                    << counter.mismatches << " mismatches, seed " << random.seed);
  if (std::getenv("GEOMETRIC_CONTINUITY_JOINS"))
    for (int kind = 0; kind < 10; ++kind) {
      std::cout << name << ' ' << dimension<Traits> << "D, " << kind_names[kind] << ": no/yes/undefined";
      for (int i = 0; i < 3; ++i) std::cout << ' ' << counter.answers[kind][i];
      std::cout << "; stages";
      for (long n : counter.stages[kind]) std::cout << ' ' << n;
      std::cout << '\n';
    }
  return counter;
}

#define TEST_CLASS(name)                                                                                               \
  BOOST_AUTO_TEST_CASE(joins_##name) {                                                                                 \
    run<Space>(#name, name<3>, joins_per_class());                                                                     \
    run<Plane>(#name, name<2>, joins_per_class() / 4);                                                                 \
  }
TEST_CLASS(exact)
TEST_CLASS(parametric)
TEST_CLASS(off_by_one_ulp)
TEST_CLASS(off_by_one_unit)
TEST_CLASS(grossly_off)
TEST_CLASS(half_turn)
TEST_CLASS(tiny)
TEST_CLASS(huge)
TEST_CLASS(subnormal)
TEST_CLASS(mixed_exponents)
TEST_CLASS(anything)
TEST_CLASS(degenerate)
TEST_CLASS(invariants_only)

// The form for F3 is 2^255 z: for z = 2 it is 0 modulo 2^256, and it is smaller than its rounding
// error.
BOOST_AUTO_TEST_CASE(residue_of_a_number_that_is_not_zero) {
  const double s = 0x1p51;
  for (const double z : {0., 1., 2., 4., 6.}) {
    const Points<3> p = {{1, 0, 0}, {1 - s, 0, 0}, {1 - s, s, 0}, {1, s, 0}},
                    q = {{1, 0, 0}, {1 + s, 0, 0}, {1 + s, s, 0}, {1, s, z}};
    const Curve<Space> left = curve<Space>(p, true, {0, 1}), right = curve<Space>(q, false, {0, 1});
    BOOST_CHECK(GC::is_g2_join(left, right));
    BOOST_CHECK_EQUAL(GC::is_f3_join(left, right), z == 0);
    Counter counter;
    check(left, right, counter);
    BOOST_CHECK_EQUAL(counter.mismatches, 0);
  }
}

// The third difference 2^54 - 1 on the left becomes 2^54 in floating-point arithmetic, and so 8^3
// times the one on the right.
BOOST_AUTO_TEST_CASE(differences_that_are_rounded) {
  const double s = 0x1p51;
  for (const double off : {0., 1.}) {
    const Points<3> p = {{0, 0, s}, {0, 0, -s}, {0, 0, s}, {0, 0, off - s}},
                    q = {{0, 0, s}, {0, 0, 1.25 * s}, {0, 0, 1.5625 * s}, {0, 0, 1.953125 * s}};
    const Curve<Space> left = curve<Space>(p, true, {0, 8}), right = curve<Space>(q, false, {0, 1});
    BOOST_CHECK(GC::is_c_join<2>(left, right));
    BOOST_CHECK_EQUAL(GC::is_c_join<3>(left, right), off == 0);
  }
}

// Without curvature the normal is 0, and the form for F3 as well.
BOOST_AUTO_TEST_CASE(joins_without_curvature) {
  for (const double off : {0., 1.}) {
    const Points<3> p = {{0, 0, 0}, {-1, 0, 0}, {-2, 0, 0}, {-3, 0, 0}},
                    q = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, off}};
    const Curve<Space> left = curve<Space>(p, true, {0, 1}), right = curve<Space>(q, false, {0, 1});
    BOOST_CHECK(GC::is_g2_join(left, right));
    BOOST_CHECK_EQUAL(GC::is_f3_join(left, right), off == 0);
  }
}

// Tangents along one axis are parallel, whatever their lengths and wherever they are: no product
// has to be computed.
BOOST_AUTO_TEST_CASE(tangents_along_an_axis) {
  for (const bool holds : {true, false}) {
    const Points<3> p = {{1 / 3., 0.1, 1e-30}, {1 / 3., 0.1, -1 / 7.}, {1, 2, 3}, {4, 5, 6}},
                    q = {{1 / 3., 0.1, 1e-30},
                         {1 / 3., holds ? 0.1 : std::nextafter(0.1, 1), 1e9 / 3},
                         {1, 2, 3},
                         {4, 5, 6}};
    const Curve<Space> left = curve<Space>(p, true, {0, 1}), right = curve<Space>(q, false, {0, 1});
    Stages stages{(1u << number_of_stages) - 1};
    const Join_answer g1 = GC::internal::decide_join<Join_question::g1>(left, right, stages);
    BOOST_CHECK(g1 == answer(holds));
    BOOST_CHECK_EQUAL(stages.count[static_cast<int>(Stage::comparison)], holds);
    Counter counter;
    check(left, right, counter);
    BOOST_CHECK_EQUAL(counter.mismatches, 0);
  }
}

// Degrees and domains for which no factor is exact: then the jets decide.
BOOST_AUTO_TEST_CASE(high_degrees_and_short_domains) {
  Points<3> p = {{0, 0, 0}, {-1, 0, 0}, {-2, 1, 0}, {-3, 5, 2}}, q = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 5, -2}};
  for (const double off : {0., 0x1p-40}) {
    q[1][1] = off;
    for (const std::size_t points : {std::size_t(4), std::size_t(1002)})
      for (const double length : {1., 0x1p-600}) {
        Points<3> high = q;
        while (high.size() < points) high.push_back({1, 2, 3});
        const Curve<Space> left = curve<Space>(p, true, {0, length}), right = curve<Space>(high, false, {0, length});
        Counter counter;
        check(left, right, counter);
        check(curve<Space>(high, true, {0, length}), curve<Space>(p, false, {0, length}), counter);
        BOOST_CHECK_EQUAL(counter.mismatches, 0);
        BOOST_CHECK_EQUAL(GC::is_g1_join(left, right), off == 0);
      }
  }
}

// Returns a bound of the absolute value of a number.
struct Magnitude {
  boost::multiprecision::cpp_int value;
  Magnitude(boost::multiprecision::cpp_int x = 0) : value(std::move(x)) {}
  explicit Magnitude(int x) : value(x) {}
  friend Magnitude operator+(const Magnitude& x, const Magnitude& y) { return {x.value + y.value}; }
  friend Magnitude operator-(const Magnitude& x, const Magnitude& y) { return {x.value + y.value}; }
  friend Magnitude operator*(const Magnitude& x, const Magnitude& y) { return {x.value * y.value}; }
};
Magnitude below(int bits) { return {(boost::multiprecision::cpp_int(1) << bits) - 1}; }

// Records the largest form; for F3 that of a straight end, if exact, or that of another.
template <bool straight> struct Largest_form {
  static constexpr bool exact = straight;
  boost::multiprecision::cpp_int value = 0;
  bool operator()(Join_question, const Magnitude& x) {
    if (value < x.value) value = x.value;
    return true;
  }
};

// The bits of the largest form, for ends of these bits.
template <Join_question question, bool weighted>
int largest_form(int coordinates, int degrees, int first_numbers, int second_numbers) {
  const Magnitude x = below(coordinates), y(Magnitude(2) * x), z(Magnitude(4) * x), u(Magnitude(8) * x);
  const GC::internal::Differences<Magnitude, 3> d{{{y, y, y}, {z, z, z}, {u, u, u}}};
  const int m = static_cast<int>((1u << degrees) - 1), n = m - 1;
  Largest_form<true> straight;
  Largest_form<false> curved;
  const auto record_in = [&](const auto& w, auto& largest) {
    const GC::internal::Join_equations<Magnitude, 3, std::decay_t<decltype(w)>, std::decay_t<decltype(largest)>>
        equations(d, d, w, largest);
    (void)GC::internal::all_hold<question>(equations);
    if constexpr (question == Join_question::torsion) (void)equations.both_have_curvature();
  };
  const auto record = [&](const auto& w) {
    record_in(w, straight);
    record_in(w, curved);
  };
  if constexpr (GC::internal::is_parametric(question)) {
    const Magnitude length = below(first_numbers) + below(first_numbers);
    record(GC::internal::Parametric_degree_factors<Magnitude>::of(m, n, length, length));
  } else if constexpr (weighted) {
    const auto weights = [](int bits) {
      return std::array<Magnitude, 4>{below(bits), below(bits), below(bits), below(bits)};
    };
    for (const auto& [i, j] : {std::pair<int, int>{m, n}, {n, m}, {m, m}}) {
      const auto w = GC::internal::Weighted_degree_factors<question, Magnitude>::of(weights(first_numbers), i,
                                                                                    weights(second_numbers), j);
      record(
          GC::internal::Weighted_degree_factors<Join_question::g3, Magnitude>{w.a2, w.b2, w.first, w.a3, w.b3, w.mix});
    }
  } else
    for (const auto& [i, j] : {std::pair<int, int>{m, n}, {n, m}, {m, m}})
      record(GC::internal::Degree_factors<Magnitude>::geometric<question>(i, j));
  const auto& largest = (std::max)(straight.value, curved.value);
  return largest == 0 ? 0 : static_cast<int>(msb(largest)) + 1;
}

template <Join_question question, bool weighted> void check_bits_of_form() {
  for (const int coordinates : {1, 8, 60, 2098})
    for (const int degrees : {1, 2, 3, 10, 31})
      for (const int first : {1, 20, 2098})
        for (const int second : {1, 50, 2098}) {
          const int bits = GC::internal::bits_of_form<question, weighted>(GC::internal::form_degree(question),
                                                                          coordinates, degrees, first, second);
          const int largest = largest_form<question, weighted>(coordinates, degrees, first, second);
          BOOST_TEST_CONTEXT("question " << static_cast<int>(question) << ", bits " << coordinates << ' ' << degrees
                                         << ' ' << first << ' ' << second) {
            BOOST_TEST(largest <= bits);
            BOOST_TEST(bits < 440 * 64);                         // of the moduli
            if (degrees >= 3) BOOST_TEST(bits <= largest + 160); // not many more than needed
          }
        }
}

// The lengths of forms that the last stage supposes are those of the equations, for doubles of all
// sizes and all degrees.
BOOST_AUTO_TEST_CASE(bits_of_forms) {
  check_bits_of_form<Join_question::c1, false>();
  check_bits_of_form<Join_question::c2, false>();
  check_bits_of_form<Join_question::c3, false>();
  check_bits_of_form<Join_question::g1, false>();
  check_bits_of_form<Join_question::g2, false>();
  check_bits_of_form<Join_question::g3, false>();
  check_bits_of_form<Join_question::f3, false>();
  check_bits_of_form<Join_question::curvature_vector, false>();
  check_bits_of_form<Join_question::torsion, false>();
  check_bits_of_form<Join_question::g2, true>();
  check_bits_of_form<Join_question::g3, true>();
  check_bits_of_form<Join_question::f3, true>();
  check_bits_of_form<Join_question::curvature_vector, true>();
  check_bits_of_form<Join_question::torsion, true>();
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// The first derivatives differ by the product of the first n moduli of the last stage: one more
// decides.
BOOST_AUTO_TEST_CASE(forms_that_are_multiples_of_several_moduli) {
  typedef Plane::Point Point;
  const double r = 0x1p64;
  struct Example {
    double before, joint, after;
    bool holds;
  };
  for (const Example& x : {Example{r, r, 0, false}, Example{r * r, r * r, r, false},
                           Example{4 * r * r, r * r * (r / 2), -3 * r, false}, Example{0, r, 2 * r, true}}) {
    const Curve<Plane> left{Point(x.before, 1), Point(x.joint, 1)}, right{Point(x.joint, 1), Point(x.after, 1)};
    Stages none{0};
    BOOST_CHECK((decide_all_the_way<Join_question::c1, 2, false>(
                     GC::internal::left_end(left), GC::internal::right_end(right), none) == answer(x.holds)));
  }
}

#endif

// Where the decisions are made: no stage is idle.
BOOST_AUTO_TEST_CASE(every_stage_decides) {
  std::array<std::array<long, number_of_stages>, 10> counts{};
  for (auto make : {&exact<3>, &off_by_one_unit<3>, &grossly_off<3>, &mixed_exponents<3>}) {
    const Counter counter = run<Space>("every stage", make, 200);
    for (int kind = 0; kind < 10; ++kind)
      for (int s = 0; s < number_of_stages; ++s) counts[kind][s] += counter.stages[kind][s];
  }
  for (const Join_question kind :
       {Join_question::c1, Join_question::c2, Join_question::c3, Join_question::g1, Join_question::g2,
        Join_question::g3, Join_question::f3, Join_question::curvature_vector, Join_question::torsion})
    for (const Stage s :
         {Stage::comparison, Stage::floating_point, Stage::fixed_integer, Stage::residue, Stage::multiprecision}) {
      if (s == Stage::comparison && !(kind <= Join_question::f3)) continue;
      BOOST_CHECK_MESSAGE(counts[static_cast<int>(kind)][static_cast<int>(s)] > 0,
                          kind_names[static_cast<int>(kind)] << ": stage " << static_cast<int>(s));
    }
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

template <int n, int most = GC::internal::unlimited> using Fixed = GC::internal::Fixed_integer<n, most>;

template <int n, int most> Q value(const Fixed<n, most>& x) {
  Q v(static_cast<double>(x.top() >> 32)), half(0x1p32);
  v = Q(v * half + Q(static_cast<double>(x.top() & 0xffffffff)));
  for (int k = n - 2; k >= 0; --k)
    for (int shift : {32, 0}) v = Q(v * half + Q(static_cast<double>((x.limb[k] >> shift) & 0xffffffff)));
  return v;
}

// Limbs that are often 0, all ones, or the smallest negative number.
template <int n, int most = GC::internal::unlimited> Fixed<n, most> random_fixed(Random& random) {
  Fixed<n, most> x(0);
  for (int k = 0; k < n; ++k) {
    const std::uint64_t any = static_cast<std::uint64_t>(random.whole(53)) * 0x9e3779b97f4a7c15u;
    const std::uint64_t limbs[] = {0, ~std::uint64_t(0), std::uint64_t(1) << 63, 1, any, any, any};
    x.limb[k] = limbs[random.integer(0, 6)];
  }
  return x;
}

template <int m, int n> void check_products(Random& random) {
  for (int i = 0; i < 2000; ++i) {
    const Fixed<m> x = random_fixed<m>(random);
    const Fixed<n> y = random_fixed<n>(random);
    BOOST_REQUIRE(value(x * y) == Q(value(x) * value(y)));
    BOOST_REQUIRE(is_zero(x) == (value(x) == Q(0)));
  }
}

// With fewer limbs than the product has: the same ones as those of the whole product.
template <int m, int n, int most> void check_products_modulo(Random& random) {
  for (int i = 0; i < 2000; ++i) {
    const Fixed<m, most> x = random_fixed<m, most>(random);
    const Fixed<n, most> y = random_fixed<n, most>(random);
    Fixed<m> all_of_x;
    Fixed<n> all_of_y;
    std::copy_n(x.limb, m, all_of_x.limb);
    std::copy_n(y.limb, n, all_of_y.limb);
    const auto product = x * y;
    const auto whole = all_of_x * all_of_y;
    static_assert(std::is_same_v<decltype(product), const Fixed<most, most>>, "the length of the product");
    BOOST_REQUIRE(std::equal(product.limb, product.limb + most, whole.limb));
  }
}

BOOST_AUTO_TEST_CASE(fixed_integers) {
  Random random;
  BOOST_TEST_MESSAGE("seed " << random.seed);
  check_products<1, 1>(random);
  check_products<2, 1>(random);
  check_products<3, 1>(random);
  check_products<5, 1>(random);
  check_products<2, 2>(random);
  check_products<3, 3>(random);
  check_products<3, 4>(random);
  check_products<1, 3>(random);
  check_products_modulo<3, 1, 3>(random);
  check_products_modulo<2, 2, 3>(random);
  check_products_modulo<3, 3, 4>(random);
  check_products_modulo<4, 3, 4>(random);
  check_products_modulo<2, 4, 4>(random);
  for (int i = 0; i < 2000; ++i) { // sums and multiples that fit
    Fixed<3> x = random_fixed<3>(random), y = random_fixed<3>(random);
    x.limb[2] = static_cast<std::uint64_t>(x.top() >> 20);
    y.limb[2] = static_cast<std::uint64_t>(y.top() >> 20);
    const std::int64_t w = random.integer(0, 1 << 16);
    BOOST_REQUIRE(value(x + y) == Q(value(x) + value(y)));
    BOOST_REQUIRE(value(x - y) == Q(value(x) - value(y)));
    BOOST_REQUIRE(value(scaled(x, w)) == Q(value(x) * Q(static_cast<int>(w))));
  }
}

#endif

// The functions themselves, in an exact kernel.
BOOST_AUTO_TEST_CASE(exact_kernel) {
  Random random;
  BOOST_TEST_MESSAGE("seed " << random.seed);
  for (int i = 0; i < 200; ++i) {
    const Join<3> join = i % 2 ? almost<3>(random) : degenerate<3>(random);
    std::vector<Exact_space::Point> p, q;
    const auto third = [](double x) { return Q(Q(x) / 3); };
    for (const auto& x : join.left) p.emplace_back(third(x[0]), third(x[1]), third(x[2]));
    for (const auto& x : join.right) q.emplace_back(third(x[0]), third(x[1]), third(x[2]));
    const Curve<Exact_space> x(p.rbegin(), p.rend()), y(q.begin(), q.end());
    const GC::Join_continuity<Q> truth = GC::continuity(x, y, 3);
    const auto same = [&](const auto& l, const auto& r) {
      return GC::is_c_join<0>(l, r) == (truth.c_order >= 0) && GC::is_c_join<1>(l, r) == (truth.c_order >= 1) &&
             GC::is_c_join<2>(l, r) == (truth.c_order >= 2) && GC::is_c_join<3>(l, r) == (truth.c_order >= 3) &&
             GC::is_g1_join(l, r) == (truth.g_order >= 1) && GC::is_g2_join(l, r) == (truth.g_order >= 2) &&
             GC::is_g3_join(l, r) == (truth.g_order >= 3) && GC::is_f3_join(l, r) == (truth.f_order >= 3) &&
             GC::has_equal_curvature_vector(l, r) == truth.curvature_vector_equal &&
             GC::has_equal_torsion(l, r) == truth.torsion_equal;
    };
    BOOST_CHECK(same(x, y));
  }
}
