// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// The typed tests share this. The including file has defined, for one kernel:
//
//   Traits2, Traits3       traits classes that serve dimension 2 and 3, with one number type FT
//   exact                  constructions are exact, and so are predicates
//   exact_predicates       predicates are exact on the numbers as given; not for kernels/typed_smoke.h
//   cancels                the number type cancels common factors; if not, numbers double their length in each operation
//   rounds                 how many inputs each random test takes
//   in_every_space(test)   calls test(Traits(), d) for each traits class and each dimension d that it serves
//
// Exact kernels compare with ==. A rounded kernel runs the same tests on small whole or dyadic
// numbers where every intermediate result is a double, also with ==; where that is impossible,
// `close` states the bound.

#include "random.h"

#include <CGAL/Geometric_continuity.h>

typedef Traits2::FT FT;
template <class Traits> using Jet = GC::Curve_jet<Traits>;
template <class Traits> using Curve = GC::Bezier_curve<Traits>;
template <class Traits> using Point = typename Traits::Point;
template <class Traits> using Vector = typename Traits::Vector;
template <class Traits> using Column = GC::Coordinate_vector<typename Traits::FT, Curve<Traits>::N>;

// ---------------------------------------------------------------- numbers

inline FT ratio(int p, int q) { return FT(FT(p) / FT(q)); }

inline FT power(const FT& x, int n) {
  FT r(1);
  for (int i = 0; i < n; ++i) r *= x;
  return r;
}

inline int binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

// Another number next to x: the next double, or a rational number that far away in exact kernels.
template <class T> T next_to(const T& x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::nextafter(x, 1e300);
  else
    return T(x + power(ratio(1, 10), 30));
}

// Equality in exact kernels. In rounded ones `roundings` roundings are allowed for, each of a
// number of at most `scale`.
template <class T> bool close(const T& x, const T& y, const T& scale, int roundings) {
  if constexpr (std::is_floating_point_v<T>)
    return std::abs(x - y) <= roundings * 0x1p-53 * scale;
  else
    return x == y;
}

template <class T, class = void> struct Is_streamable : std::false_type {};
template <class T>
struct Is_streamable<T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())>>
    : std::true_type {};

// A number in the field in which predicates are decided.
template <class Field, class T> Field in_field(const T& x) {
  if constexpr (std::is_same_v<Field, T>)
    return x;
  else
    return Field(x);
}

// ---------------------------------------------------------------- random input

class Random : public Random_integers<> {
public:
  // up to 40 bits over 30 bits
  FT rational() {
    if (!cancels) return FT(integer(-9, 9));
    const int high = integer(-999999, 999999), low = integer(0, 999999), denominator = integer(1, 999999);
    return FT((FT(high) * FT(1000000) + FT(low)) / (FT(1000) * FT(denominator)));
  }
  FT positive_rational() { return cancels ? fraction_of<FT>(1, 99999, 1, 99999) : FT(integer(1, 3)); }

  // Rational; in rounded kernels a multiple of 1/8 of modulus at most 2, so that polynomials are
  // evaluated exactly.
  FT number() {
    if constexpr (exact)
      return rational();
    else
      return ratio(integer(-16, 16), 8);
  }
  // Rational; in rounded kernels a small whole number, so that joins are exact and are decided
  // without rounding.
  FT whole() {
    if constexpr (exact)
      return rational();
    else
      return FT(integer(-2, 2));
  }
  FT positive_whole() {
    if constexpr (exact)
      return positive_rational();
    else
      return FT(integer(1, 2));
  }

  std::vector<FT> numbers(int n) {
    std::vector<FT> x;
    for (int i = 0; i < n; ++i) x.push_back(number());
    return x;
  }
};

// test(random) `rounds` times
template <class Test> void repeat(Test test, int times = rounds) {
  Random random;
  for (int i = 0; i < times; ++i) BOOST_TEST_CONTEXT("seed " << random.seed << ", round " << i) test(random);
}

// test(Traits(), d, random) `rounds` times in every space
template <class Test> void with_random_input(Test test, int times = rounds) {
  in_every_space([&](auto traits, int d) {
    BOOST_TEST_CONTEXT("dimension " << d) repeat([&](Random& random) { test(traits, d, random); }, times);
  });
}

// Tests of a traits class `Traits` in dimension `d`: in every space, and there with `random` input,
// `rounds` times or as often as given, and only of kernels for which a condition holds.
#define TEST_IN_EVERY_SPACE(name)                                                                                      \
  template <class Traits> void name##_in(int d);                                                                       \
  BOOST_AUTO_TEST_CASE(name) {                                                                                         \
    in_every_space([](auto traits, int d) { name##_in<decltype(traits)>(d); });                                        \
  }                                                                                                                    \
  template <class Traits> void name##_in([[maybe_unused]] int d)
#define TEST_WITH_INPUTS_IF(name, times, condition)                                                                    \
  template <class Traits> void name##_in(int d, Random& random);                                                       \
  BOOST_AUTO_TEST_CASE(name, *boost::unit_test::enable_if<condition>()) {                                              \
    with_random_input(                                                                                                 \
        [](auto traits, [[maybe_unused]] int d, [[maybe_unused]] Random& random) {                                     \
          if constexpr (condition) name##_in<decltype(traits)>(d, random);                                             \
        },                                                                                                             \
        times);                                                                                                        \
  }                                                                                                                    \
  template <class Traits> void name##_in([[maybe_unused]] int d, [[maybe_unused]] Random& random)
#define TEST_WITH_INPUTS(name, times) TEST_WITH_INPUTS_IF(name, times, true)
#define TEST_WITH_RANDOM_INPUT(name) TEST_WITH_INPUTS_IF(name, rounds, true)
#define TEST_WITH_RANDOM_INPUT_IF(name, condition) TEST_WITH_INPUTS_IF(name, rounds, condition)

// ---------------------------------------------------------------- points, jets and curves

typedef std::initializer_list<int> Row;

// In dimension d: missing coordinates are 0, and those beyond d are left out.
template <class Traits> Column<Traits> column(int d, Row x) {
  Column<Traits> c(d);
  for (int i = 0; i < std::min(d, static_cast<int>(x.size())); ++i) c[i] = FT(x.begin()[i]);
  return c;
}
template <class Traits> Point<Traits> point(const Column<Traits>& c) {
  return Traits().construct_point_object()(c.dimension(), c.begin(), c.end());
}
template <class Traits> Vector<Traits> vector(const Column<Traits>& c) {
  return Traits().construct_vector_object()(c.dimension(), c.begin(), c.end());
}
template <class Traits> Point<Traits> point(int d, Row x) { return point<Traits>(column<Traits>(d, x)); }
template <class Traits> Vector<Traits> vector(int d, Row x) { return vector<Traits>(column<Traits>(d, x)); }

// The coordinates of a point or vector, read through the traits class.
template <class Traits, class Point_or_vector> Column<Traits> column(const Point_or_vector& p) {
  Column<Traits> c(Traits().compute_dimension_object()(p));
  for (int i = 0; i < c.dimension(); ++i) c[i] = typename Traits::FT(Traits().compute_coordinate_object()(p, i));
  return c;
}

template <class Traits> Jet<Traits> jet(int d, std::initializer_list<Row> rows) {
  Jet<Traits> x(d, static_cast<int>(rows.size()) - 1);
  int j = 0;
  for (const Row& row : rows) x[j++] = column<Traits>(d, row);
  return x;
}

template <class Traits> Curve<Traits> curve(int d, std::initializer_list<Row> rows, int a = 0, int b = 1) {
  std::vector<Point<Traits>> points;
  for (const Row& row : rows) points.push_back(point<Traits>(d, row));
  return Curve<Traits>(points.begin(), points.end(), FT(a), FT(b));
}

template <class Traits> Jet<Traits> truncated(const Jet<Traits>& x, int k) {
  Jet<Traits> y(x.dimension(), k);
  for (int j = 0; j <= k; ++j) y[j] = x[j];
  return y;
}

// Random, with coordinates random.*source(), until no coordinate of x' is zero and the derivatives
// are independent.
template <class Traits> Jet<Traits> random_jet(Random& random, int d, int k, FT (Random::*source)() = &Random::whole) {
  for (;;) {
    Jet<Traits> x(d, k);
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i < d; ++i) x[j][i] = (random.*source)();
    bool generic = !(GC::gram_determinants(x, std::min(k, d)).back() == FT(0));
    for (int i = 0; i < d && k > 0; ++i) generic = generic && !(x[1][i] == FT(0));
    if (generic) return x;
  }
}

template <class Traits>
std::vector<Point<Traits>> random_points(Random& random, int d, int n, FT (Random::*source)() = &Random::number) {
  std::vector<Point<Traits>> points;
  for (int j = 0; j < n; ++j) {
    Column<Traits> c(d);
    for (int i = 0; i < d; ++i) c[i] = (random.*source)();
    points.push_back(point<Traits>(c));
  }
  return points;
}

// On a domain of random ends; in rounded kernels its length is 2.
template <class Traits> Curve<Traits> random_curve(Random& random, int d, int degree) {
  const std::vector<Point<Traits>> points = random_points<Traits>(random, d, degree + 1);
  const FT a = random.number(), h = exact ? random.positive_rational() : FT(2);
  return Curve<Traits>(points.begin(), points.end(), a, FT(a + h));
}

template <class Traits, class C, class D> bool same_points(const C& c, const D& d) {
  return std::equal(c.begin(), c.end(), d.begin(), d.end(), [](const Point<Traits>& p, const Point<Traits>& q) {
    return column<Traits>(p) == column<Traits>(q);
  });
}

// The jet of x(phi(t)) at 0, where phi(0) = 0 and phi^(j)(0) = betas[j-1], by the product rule:
// phi^m has the derivatives that multiply x^(m) / m!. Whole numbers stay whole. Missing betas
// are 0.
template <class Traits> Jet<Traits> reparametrised(const Jet<Traits>& x, std::vector<FT> betas) {
  const int k = x.order();
  betas.resize(k, FT(0));
  std::vector<FT> power(k + 1, FT(0)); // the derivatives of phi^m at 0
  power[0] = FT(1);
  FT factorial(1);
  Jet<Traits> y(x.dimension(), k);
  for (int m = 0; m <= k; ++m) {
    for (int j = 0; j <= k; ++j) y[j] += FT(power[j] / factorial) * x[m];
    std::vector<FT> next(k + 1, FT(0));
    for (int n = 1; n <= k; ++n)
      for (int i = 1; i <= n; ++i) next[n] += FT(binomial(n, i)) * betas[i - 1] * power[n - i];
    power = next;
    factorial *= FT(m + 1);
  }
  return y;
}

template <class Traits> Jet<Traits> reversed(const Jet<Traits>& x) { return reparametrised(x, {FT(-1)}); }

// ---------------------------------------------------------------- maps

// A rotation followed by a scaling and a translation, with rational numbers.
template <class Traits> class Similarity {
  typedef Column<Traits> Vector_type;
  std::vector<Vector_type> rows_;
  Vector_type shift_;

public:
  FT scale;

  // A rotation by (1-t^2, 2t)/(1+t^2) in every coordinate plane; in space, that of a random
  // quaternion. Quarter turns if numbers do not cancel.
  Similarity(Random& random, int d, const FT& scale) : shift_(d), scale(scale) {
    for (int i = 0; i < d; ++i) {
      shift_[i] = random.number();
      rows_.push_back(Vector_type(d));
      rows_[i][i] = FT(1);
    }
    if (d == 3 && cancels) {
      const FT a = random.whole(), b = random.whole(), c = random.whole(), e = FT(1);
      const FT n = a * a + b * b + c * c + e * e;
      const FT two(2);
      rows_[0] =
          row(FT(FT(1) - two * (b * b + c * c) / n), FT(two * (a * b - c * e) / n), FT(two * (a * c + b * e) / n));
      rows_[1] =
          row(FT(two * (a * b + c * e) / n), FT(FT(1) - two * (a * a + c * c) / n), FT(two * (b * c - a * e) / n));
      rows_[2] =
          row(FT(two * (a * c - b * e) / n), FT(two * (b * c + a * e) / n), FT(FT(1) - two * (a * a + b * b) / n));
    } else
      for (int i = 0; i + 1 < d; ++i) {
        const FT t = cancels ? random.fraction_of<FT>(-9, 9, 1, 9) : FT(1), n = FT(1) + t * t;
        const FT c = t == FT(1) ? FT(0) : FT((FT(1) - t * t) / n), s = t == FT(1) ? FT(1) : FT(FT(2) * t / n);
        const Vector_type p = rows_[i], q = rows_[i + 1];
        rows_[i] = c * p - s * q;
        rows_[i + 1] = s * p + c * q;
      }
  }

  Vector_type linear(const Vector_type& v) const {
    Vector_type r(v.dimension());
    for (int i = 0; i < v.dimension(); ++i) r[i] = scale * dot(rows_[i], v);
    return r;
  }
  Point<Traits> operator()(const Point<Traits>& p) const { return point<Traits>(linear(column<Traits>(p)) + shift_); }
  Jet<Traits> operator()(const Jet<Traits>& x) const {
    Jet<Traits> y = x;
    for (int j = 0; j <= x.order(); ++j) y[j] = linear(x[j]);
    y[0] += shift_;
    return y;
  }

private:
  static Vector_type row(const FT& x, const FT& y, const FT& z) {
    Vector_type r(3);
    r[0] = x;
    r[1] = y;
    r[2] = z;
    return r;
  }
};

// ---------------------------------------------------------------- a user's own curve

// The Taylor polynomial of a jet at `a`, on [a, b]. It has only what ParametricCurve asks for.
template <class Traits_> class Taylor_curve {
public:
  typedef Traits_ Traits;

  Taylor_curve(const Jet<Traits>& at_a, const FT& a, const FT& b) : at_a_(at_a), a_(a), b_(b) {}

  std::pair<FT, FT> domain() const { return {a_, b_}; }
  Jet<Traits> jet(const FT& t, int k) const {
    Jet<Traits> x(at_a_.dimension(), k);
    for (int j = 0; j <= k; ++j) {
      FT weight(1); // (t-a)^i / i!
      for (int i = 0; i + j <= at_a_.order(); ++i) {
        x[j] += weight * at_a_[i + j];
        weight *= (t - a_) / FT(i + 1);
      }
    }
    return x;
  }

private:
  Jet<Traits> at_a_;
  FT a_, b_;
};

// ----------------------------------------------------------- the exact result, for rounded kernels

typedef GC::Traits_d<CGAL::Cartesian_d<CGAL::Exact_rational>> Reference;

template <class T> CGAL::Exact_rational rational(const T& x) { return CGAL::Exact_rational(x); }

template <class Column_type> Column<Reference> rational_column(const Column_type& c) {
  Column<Reference> r(c.dimension());
  for (int i = 0; i < c.dimension(); ++i) r[i] = rational(c[i]);
  return r;
}
template <class Traits> Jet<Reference> rational_jet(const Jet<Traits>& x) {
  Jet<Reference> y(x.dimension(), x.order());
  for (int j = 0; j <= x.order(); ++j) y[j] = rational_column(x[j]);
  return y;
}

template <class Column_type> double length(const Column_type& c) { return std::sqrt(CGAL::to_double(dot(c, c))); }

// |x - y| <= bound, where x is rounded and y is exact
template <class Column_type> bool within(const Column_type& x, const Column<Reference>& y, double bound) {
  return length(rational_column(x) - y) <= bound;
}

// ---------------------------------------------------------------- blends

// A blend takes these: two jets and the shape parameters.
template <class Traits> struct Blend_input {
  Jet<Traits> phi, psi;
  GC::Shape_parameters<typename Traits::FT> shape;

  template <class Strategy> auto operator()(const Strategy& strategy) const {
    return GC::blend(phi, psi, strategy, shape);
  }
};

template <class Traits>
Blend_input<Traits> random_blend(Random& random, int d, int order, FT (Random::*source)() = &Random::whole) {
  const Jet<Traits> phi = random_jet<Traits>(random, d, order, source),
                    psi = random_jet<Traits>(random, d, order, source);
  return {phi, psi, {random.positive_rational(), random.positive_rational()}};
}

template <class Traits> Blend_input<Traits> reversed(const Blend_input<Traits>& input) {
  return {reversed(input.psi), reversed(input.phi), {input.shape.eta, input.shape.beta}};
}

// A strategy whose type is forgotten, with the one that makes the same blend backwards.
template <class Traits, class Blend> struct Any_strategy {
  typedef std::function<Blend(const Blend_input<Traits>&)> Function;
  const char* name;
  Function blend, mirrored;
  bool geometric; // it does not see how the given curves are parametrised

  template <class Strategy, class Mirrored>
  Any_strategy(const char* name, const Strategy& strategy, const Mirrored& mirrored, bool geometric)
      : name(name), blend([=](const Blend_input<Traits>& input) { return input(strategy); }),
        mirrored([=](const Blend_input<Traits>& input) { return input(mirrored); }), geometric(geometric) {}
  template <class Strategy>
  Any_strategy(const char* name, const Strategy& strategy) : Any_strategy(name, strategy, strategy, true) {}
};

// A blend is reversed with its curves and moves with them.
template <class Traits, class Blend>
void check_symmetry(const Blend_input<Traits>& input, Random& random, const Any_strategy<Traits, Blend>& strategy) {
  const Blend gamma = strategy.blend(input);
  BOOST_CHECK(same_points<Traits>(gamma.reverse(), strategy.mirrored(reversed(input))));
  const Similarity<Traits> map(random, input.phi.dimension(), random.positive_rational());
  BOOST_CHECK(same_points<Traits>(gamma.transform(map), strategy.blend({map(input.phi), map(input.psi), input.shape})));
  if (!strategy.geometric) return;
  const FT beta = input.shape.beta, eta = input.shape.eta;
  const Jet<Traits> phi = reparametrised(input.phi, {beta, random.whole(), random.whole()}),
                    psi = reparametrised(input.psi, {eta, random.whole(), random.whole()});
  BOOST_CHECK(same_points<Traits>(gamma, strategy.blend({phi, psi, {}})));
}

// The curve from the end of phi to the start of psi does not depend on the type of curve that
// offers the jets.
template <class Traits, class Strategy>
void check_input_types(const Blend_input<Traits>& input, const Strategy& strategy) {
  const auto gamma = input(strategy);
  const FT a(-1), b(3), h = b - a;
  const int k = input.phi.order();
  const std::vector<Point<Traits>> p = GC::end_control_points(input.phi, k, h),
                                   q = GC::start_control_points(input.psi, k, h);
  const Curve<Traits> phi(p.begin(), p.end(), a, b), psi(q.begin(), q.end(), a, b);
  BOOST_CHECK(same_points<Traits>(gamma, GC::blend(phi, psi, strategy, input.shape)));
  const Taylor_curve<Traits> left(phi.jet(a, k), a, b), right(input.psi, a, b);
  BOOST_CHECK(same_points<Traits>(gamma, GC::blend(left, right, strategy, input.shape)));
  BOOST_CHECK(same_points<Traits>(gamma, GC::blend(phi, right, strategy, input.shape)));
}

// Bad input, in the order in which it is refused.
template <class Traits, class Strategy> void check_blend_errors(int d, int order, const Strategy& strategy) {
  Blend_input<Traits> good;
  good.phi = good.psi = truncated(jet<Traits>(d, {{0}, {1, 2}, {3, 4}, {5, 6}}), order);
  BOOST_CHECK_EQUAL(good(strategy).dimension(), d);

  Blend_input<Traits> bad = good;
  bad.psi[1] = Column<Traits>(d);
  CHECK_ERROR(bad(strategy), zero_tangent);
  bad.phi[1] = Column<Traits>(d);
  bad.psi = good.psi;
  CHECK_ERROR(bad(strategy), zero_tangent);
  bad.psi = truncated(good.psi, order - 1);
  CHECK_ERROR(bad(strategy), jet_order_too_low);
  bad.phi = truncated(bad.phi, order - 1);
  bad.psi = good.psi;
  CHECK_ERROR(bad(strategy), jet_order_too_low);
  if constexpr (Curve<Traits>::N == 0) {
    bad.psi = jet<Traits>(d + 1, {{0}, {1}, {0}, {0}});
    CHECK_ERROR(bad(strategy), dimension_mismatch);
  }
  bad.shape.eta = FT(0);
  CHECK_ERROR(bad(strategy), nonpositive_beta);
  bad.shape.eta = FT(1);
  bad.shape.beta = FT(-1);
  CHECK_ERROR(bad(strategy), nonpositive_beta);
}
