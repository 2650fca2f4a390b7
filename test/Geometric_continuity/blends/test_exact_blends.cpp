// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Blends of rational numbers are computed on unreduced fractions, blends of lazy numbers as one
// lazy construction: the same numbers as the formulas give with the operators of the number type.

#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Quotient.h>
#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>

#include "support/fractions.h"
#include "support/test.h"

BOOST_AUTO_TEST_SUITE(exact_blends)

typedef CGAL::Exact_rational Exact;
typedef CGAL::Exact_predicates_exact_constructions_kernel Lazy_kernel;
typedef Lazy_kernel::FT Lazy;

std::mt19937_64 engine(20);

template <class FT> FT integer(int bits) { // in (-2^bits, 2^bits)
  FT x(0);
  for (int b = 0; b < bits; b += 15) {
    x *= FT(1 << std::min(15, bits - b));
    x += FT(static_cast<int>(engine() % (1u << std::min(15, bits - b))));
  }
  return engine() % 2 == 0 ? x : FT(-x);
}

enum Numbers { small, mixed, doubles, zeros, huge_and_tiny, long_numbers, number_of_families };

template <class FT> FT number(int family) {
  switch (family) {
  case mixed: return FT(integer<FT>(80) / FT(FT(1) + integer<FT>(30) * integer<FT>(30) * FT(2)));
  case doubles: return FT(std::ldexp(static_cast<double>(static_cast<long>(engine() >> 11)) - 0x1p52, -50));
  case zeros: return FT(static_cast<int>(engine() % 3) - 1);
  case huge_and_tiny:
    return FT(FT(integer<FT>(20) / FT(3)) * power_of_two<FT>(engine() % 2 == 0 ? 150 : -150 - int(engine() % 9)));
  // longer than 1024 bits
  case long_numbers: return FT(integer<FT>(1100) / FT(FT(7) * integer<FT>(200) + FT(1)));
  default: return FT(FT(static_cast<int>(engine() % 2001) - 1000) / FT(1000));
  }
}

template <class Traits> GC::Curve_jet<Traits> jet(int dimension, int order, int family) {
  GC::Curve_jet<Traits> x(dimension, order);
  for (int j = 0; j <= order; ++j)
    for (int i = 0; i < dimension; ++i) x[j][i] = number<typename Traits::FT>(family);
  if (is_zero(x[1])) x[1][0] = typename Traits::FT(1);
  return x;
}

// The formulas with the operators of the number type.
template <class Traits, class Strategy>
auto by_operators(const GC::Curve_jet<Traits>& phi, const GC::Curve_jet<Traits>& psi, const Strategy& strategy,
                  const GC::Shape_parameters<typename Traits::FT>& shape) {
  typedef typename Traits::FT FT;
  constexpr int N = GC::dimension_v<Traits>;
  if constexpr (GC::is_quintic_strategy_v<Strategy, Traits>) {
    const GC::Quintic_ends<FT, N> e(phi, psi, shape);
    const GC::Quintic_parameters<FT> p = strategy(e);
    return GC::Quintic_blend<Traits>({e.a1, e.b1(), e.c1(p.s1), e.c2(p.s2), e.b2(), e.a2}, p, shape);
  } else {
    const GC::Septic_ends<FT, N> e(phi, psi, shape);
    const GC::Septic_parameters<FT> p = strategy(e);
    return GC::Septic_blend<Traits>(e.control_points(p), p, shape);
  }
}

template <class FT> void check_number(const FT& x, const FT& expected) {
  BOOST_CHECK(x == expected);
  if constexpr (std::is_same_v<FT, Lazy_kernel::FT>)
    BOOST_CHECK(is_canonical(x.exact()));
  else if constexpr (!std::is_same_v<FT, CGAL::Quotient<CGAL::Gmpz>>) // which need not be reduced
    BOOST_CHECK(is_canonical(x));
}
template <class FT> void check_parameters(const GC::Quintic_parameters<FT>& p, const GC::Quintic_parameters<FT>& q) {
  check_number(p.s1, q.s1);
  check_number(p.s2, q.s2);
  BOOST_CHECK(p.fallback_start == q.fallback_start && p.fallback_end == q.fallback_end);
}
template <class FT> void check_parameters(const GC::Septic_parameters<FT>& p, const GC::Septic_parameters<FT>& q) {
  for (const auto& [x, y] : {std::make_pair(p.start, q.start), std::make_pair(p.end, q.end)}) {
    check_number(x.beta2, y.beta2);
    check_number(x.mu, y.mu);
    check_number(x.beta3, y.beta3);
  }
  BOOST_CHECK(p.fallback_start == q.fallback_start && p.fallback_end == q.fallback_end);
}

template <class Traits, class Strategy>
void check_blend(const GC::Curve_jet<Traits>& phi, const GC::Curve_jet<Traits>& psi, const Strategy& strategy,
                 const GC::Shape_parameters<typename Traits::FT>& shape) {
  const auto gamma = GC::blend(phi, psi, strategy, shape), expected = by_operators(phi, psi, strategy, shape);
  for (int j = 0; j <= gamma.degree(); ++j)
    for (int i = 0; i < phi.dimension(); ++i) check_number(gamma.coordinates(j)[i], expected.coordinates(j)[i]);
  check_parameters(gamma.parameters, expected.parameters);
}

template <class FT> struct Every_strategy {
  template <class Test> static void quintic(const Test& test) {
    test(GC::Matching_second_derivative());
    test(GC::Normal_offset());
    test(GC::Minimal_second_derivative());
    test(GC::Near_line());
    test(GC::Minimal_energy<2>());
    test(GC::Minimal_energy<3>());
    test(GC::Given_parameters<FT>{number<FT>(mixed), number<FT>(zeros)});
  }
  template <class Test> static void septic(const Test& test) {
    test(GC::Matching_third_derivative());
    test(GC::Sequential_g3());
    test(GC::Sequential_f3());
    test(GC::Joint_g3());
    test(GC::Given_end_parameters<FT>{{number<FT>(mixed), FT(0), FT(-1)}, {FT(0), number<FT>(mixed), FT(2)}});
  }
};

template <class Traits, class FT = typename Traits::FT> void check_every_strategy(int dimension) {
  // what the operators of cpp_rational take minutes for
  constexpr bool slow = std::is_same_v<FT, boost::multiprecision::cpp_rational>;
  for (int family = 0; family < number_of_families; ++family) {
    if (slow && dimension > 2 && (family == huge_and_tiny || family == long_numbers)) continue;
    BOOST_TEST_CONTEXT("dimension " << dimension << ", family " << family) {
      const GC::Curve_jet<Traits> phi = jet<Traits>(dimension, 3, family), psi = jet<Traits>(dimension, 3, family);
      const GC::Shape_parameters<FT> shape = family % 2 == 0
                                                 ? GC::Shape_parameters<FT>()
                                                 : GC::Shape_parameters<FT>{FT(FT(3) / FT(7)), FT(FT(22) / FT(5))};
      const auto test = [&](const auto& strategy) { check_blend(phi, psi, strategy, shape); };
      Every_strategy<FT>::quintic(test);
      Every_strategy<FT>::septic(test);
      if (slow ? family == zeros
               // elsewhere operators take seconds
               : family != long_numbers && family != huge_and_tiny) {
        test(GC::Minimal_energy_g3<3>());
        test(GC::Minimal_energy_g3<4>());
      }
    }
  }
}

template <class FT> void check_in_every_space() {
  check_every_strategy<GC::Traits_2<CGAL::Simple_cartesian<FT>>>(2);
  check_every_strategy<GC::Traits_3<CGAL::Simple_cartesian<FT>>>(3);
  check_every_strategy<GC::Traits_d<CGAL::Cartesian_d<FT>>>(4);
}

BOOST_AUTO_TEST_CASE(exact_rational) { check_in_every_space<Exact>(); }
BOOST_AUTO_TEST_CASE(gmpq) { check_in_every_space<CGAL::Gmpq>(); }
BOOST_AUTO_TEST_CASE(cpp_rational) {
  typedef boost::multiprecision::cpp_rational FT;
  check_in_every_space<FT>();
}
BOOST_AUTO_TEST_CASE(mpq_rational) {
  typedef boost::multiprecision::mpq_rational FT;
  check_every_strategy<GC::Traits_3<CGAL::Simple_cartesian<FT>>>(3);
}

// A strategy of the user that knows one number type only.
template <class FT, int N> struct Product_of_tangents {
  GC::Quintic_parameters<FT> operator()(const GC::Quintic_ends<FT, N>& e) const {
    return {FT(dot(e.u, e.v) / FT(7)), FT(e.a1[0] - e.a2[0])};
  }
};
// Templates of the user may rely on the number type of the kernel.
template <class Exact_FT> struct Own_septic {
  template <class FT, int N> GC::Septic_parameters<FT> operator()(const GC::Septic_ends<FT, N>& e) const {
    static_assert(std::is_same_v<FT, Exact_FT>);
    return {{dot(e.start.d1, e.end.d1), FT(1), FT(2)}, {FT(0), FT(3), e.end.beta}};
  }
};

// Strategies of the user for every field. What each was called with is counted, to tell whether it
// was.
template <class Number> std::size_t& calls() {
  static std::size_t n = 0;
  return n;
}
template <bool allowed> struct Slide_of_the_user {
  typedef CGAL::Boolean_tag<allowed> Works_in_every_field;
  int factor;

  template <class FT, int N> GC::Quintic_parameters<FT> operator()(const GC::Quintic_ends<FT, N>& e) const {
    ++calls<FT>();
    const FT uv = dot(e.u, e.v), length = dot(e.u, e.u) + dot(e.v, e.v);
    GC::Quintic_parameters<FT> p;
    p.fallback_start = uv < FT(0);
    p.s1 = p.fallback_start ? FT(-uv / length) : FT(FT(factor) * uv / length);
    p.s2 = FT(p.s1 * p.s1 - e.tangential2 / FT(3));
    return p;
  }
};
struct Septic_of_the_user {
  typedef CGAL::Tag_true Works_in_every_field;
  template <class FT, int N> GC::Septic_parameters<FT> operator()(const GC::Septic_ends<FT, N>& e) const {
    ++calls<FT>();
    GC::Septic_parameters<FT> p;
    p.start.beta2 = FT(dot(e.start.d1, e.end.d1) / dot(e.start.d1, e.start.d1));
    p.end.mu = FT(e.end.beta / FT(7));
    return p;
  }
};
// A strategy that cannot be changed: the user allows it from outside.
struct Foreign_strategy : Slide_of_the_user<false> {};

BOOST_AUTO_TEST_SUITE_END()

template <> constexpr bool CGAL::Geometric_continuity::works_in_every_field_v<exact_blends::Foreign_strategy> = true;

BOOST_AUTO_TEST_SUITE(exact_blends)

template <class Traits, class FT = typename Traits::FT> void check_strategies_in_every_field(int dimension) {
  const GC::Shape_parameters<FT> shape{FT(FT(2) / FT(3)), 2};
  for (int family : {small, mixed, doubles, zeros}) {
    const GC::Curve_jet<Traits> phi = jet<Traits>(dimension, 3, family), psi = jet<Traits>(dimension, 3, family);
    check_blend(phi, psi, Slide_of_the_user<true>{3}, shape);
    check_blend(phi, psi, Slide_of_the_user<false>{3}, shape);
    check_blend(phi, psi, Foreign_strategy{{5}}, shape);
    check_blend(phi, psi, Septic_of_the_user(), shape);
    // in the field of the traits class when it is not allowed in others, and elsewhere when it is
    const auto calls_of = [&](const auto& strategy) {
      const std::size_t before = calls<FT>();
      GC::blend(phi, psi, strategy, shape);
      return calls<FT>() - before;
    };
    BOOST_CHECK_EQUAL(calls_of(Slide_of_the_user<false>{3}), 1);
    BOOST_CHECK_EQUAL(calls_of(Septic_of_the_user()), 0);
    // intervals may not tell the sign of u.v
    if (std::is_same_v<FT, Lazy> && family == zeros) continue;
    BOOST_CHECK_EQUAL(calls_of(Slide_of_the_user<true>{3}), 0);
    BOOST_CHECK_EQUAL(calls_of(Foreign_strategy{{3}}), 0);
  }
}

template <class Traits, class FT = typename Traits::FT> void check_strategies_of_the_user(int dimension) {
  const GC::Curve_jet<Traits> phi = jet<Traits>(dimension, 3, mixed), psi = jet<Traits>(dimension, 3, doubles);
  const GC::Shape_parameters<FT> shape{FT(FT(1) / FT(3)), FT(2)};
  check_blend(phi, psi, Product_of_tangents<FT, GC::dimension_v<Traits>>(), shape);
  check_blend(phi, psi, Own_septic<FT>(), shape);
  const auto generic = [](const auto& e) { return GC::Quintic_parameters<FT>{FT(e.u[0]), FT(e.b2()[0])}; };
  check_blend(phi, psi, generic, shape);
}

// Two pieces of one straight line: Near_line, Sequential_f3 and Joint_g3 are not defined.
template <class Traits, class FT = typename Traits::FT> void check_fallbacks(int dimension) {
  GC::Curve_jet<Traits> phi(dimension, 3), psi(dimension, 3);
  for (int i = 0; i < dimension; ++i) {
    const FT a = number<FT>(small), d = number<FT>(mixed);
    for (int j = 0; j <= 3; ++j) {
      phi[j][i] = FT(d * FT(FT(j + 1) / FT(3)));
      psi[j][i] = FT(d * FT(FT(5) / FT(j + 7)));
    }
    phi[0][i] += a;
    psi[0][i] += a;
  }
  const GC::Shape_parameters<FT> shape;
  BOOST_CHECK(GC::blend(phi, psi, GC::Near_line()).parameters.fallback_start);
  BOOST_CHECK(GC::blend(phi, psi, GC::Joint_g3()).parameters.fallback_end);
  check_blend(phi, psi, GC::Near_line(), shape);
  check_blend(phi, psi, GC::Sequential_f3(), shape);
  check_blend(phi, psi, GC::Joint_g3(), shape);
}

template <class Traits, class FT = typename Traits::FT> void check_errors(int dimension) {
  const GC::Curve_jet<Traits> phi = jet<Traits>(dimension, 3, mixed);
  GC::Curve_jet<Traits> standing = phi;
  // 0, not only near it
  for (int i = 0; i < dimension; ++i) standing[1][i] = FT(FT(FT(1) / FT(3)) * FT(3) - FT(1));
  CHECK_ERROR(GC::blend(standing, phi), zero_tangent);
  CHECK_ERROR(GC::blend(phi, standing, GC::Near_line()), zero_tangent);
  CHECK_ERROR(GC::blend(phi, standing, GC::Sequential_g3()), zero_tangent);
}

template <class Traits> void check_all_but_strategies(int dimension) {
  check_strategies_of_the_user<Traits>(dimension);
  check_fallbacks<Traits>(dimension);
  check_errors<Traits>(dimension);
}

typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Exact_traits;
typedef GC::Traits_d<CGAL::Cartesian_d<Exact>> Exact_traits_d;
typedef GC::Traits_3<Lazy_kernel> Lazy_traits;

BOOST_AUTO_TEST_CASE(strategies_of_the_user_fallbacks_and_errors) {
  check_all_but_strategies<Exact_traits>(3);
  check_all_but_strategies<Exact_traits_d>(4);
  check_all_but_strategies<Lazy_traits>(3);
  CHECK_ERROR(GC::blend(jet<Exact_traits_d>(4, 3, small), jet<Exact_traits_d>(5, 3, small)), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(strategies_of_the_user_in_every_field) {
  static_assert(GC::works_in_every_field_v<GC::Near_line> && GC::works_in_every_field_v<GC::Minimal_energy_g3<4>>);
  static_assert(GC::works_in_every_field_v<Slide_of_the_user<true>>);
  static_assert(!GC::works_in_every_field_v<Slide_of_the_user<false>> &&
                !GC::works_in_every_field_v<Own_septic<Exact>>);
  static_assert(GC::is_quintic_strategy_v<Foreign_strategy, Exact_traits>);
  static_assert(!GC::is_septic_strategy_v<Foreign_strategy, Exact_traits>);
  static_assert(GC::is_septic_strategy_v<Septic_of_the_user, Lazy_traits>);
  check_strategies_in_every_field<Exact_traits>(3);
  check_strategies_in_every_field<Exact_traits_d>(4);
  check_strategies_in_every_field<Lazy_traits>(3);
}

// Given parameters of other number types.
BOOST_AUTO_TEST_CASE(given_parameters) {
  const GC::Curve_jet<Exact_traits> phi = jet<Exact_traits>(3, 3, mixed), psi = jet<Exact_traits>(3, 3, mixed);
  check_blend(phi, psi, GC::Given_parameters<double>{0.125, -3}, {});
  check_blend(phi, psi, GC::Given_parameters<int>{7, 0}, {});
  check_blend(phi, psi, GC::Given_end_parameters<double>{{0.5, 0, 1}, {0, -0.25, 0}}, {});
  const GC::Curve_jet<Lazy_traits> x = jet<Lazy_traits>(3, 3, mixed), y = jet<Lazy_traits>(3, 3, mixed);
  check_blend(x, y, GC::Given_parameters<double>{0.125, -3}, {});
  check_blend(x, y, GC::Given_parameters<Exact>{Exact(1) / Exact(3), -3}, {});
  check_blend(x, y, GC::Given_parameters<Lazy>{Lazy(1) / Lazy(3), 2.5}, {});
}

// An infinity or a NaN that enters as a double is refused where it enters; GMP would stop the
// program.
template <class FT, class Traits> void check_not_finite() {
  const GC::Curve_jet<Traits> phi = jet<Traits>(3, 3, small), psi = jet<Traits>(3, 3, small);
  typedef GC::Shape_parameters<FT> Shape;
  typedef GC::Given_parameters<double> Given;
  typedef GC::Given_end_parameters<double> Given_ends;
  for (const double x : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_ERROR((Shape{x, 1}), not_finite);
    CHECK_ERROR((Shape{FT(1), x}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, GC::Normal_offset(), {1, x}), not_finite);
    CHECK_ERROR((GC::Given_parameters<FT>{x, 0}), not_finite);
    CHECK_ERROR((GC::Septic_end_parameters<FT>{0, x, 1}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, Given{x, 0}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, Given{0, x}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, Given_ends{{0, x, 0}, {}}), not_finite);
    CHECK_ERROR(GC::blend(phi, psi, Given_ends{{}, {0, 0, x}}), not_finite);
  }
}
BOOST_AUTO_TEST_CASE(not_finite) {
  check_not_finite<Exact, Exact_traits>();
  check_not_finite<Lazy, Lazy_traits>();
  typedef boost::multiprecision::cpp_rational Cpp;
  check_not_finite<Cpp, GC::Traits_3<CGAL::Simple_cartesian<Cpp>>>();
}

// With floating-point numbers a jet that is not finite is found in the blend.
BOOST_AUTO_TEST_CASE(jets_that_are_not_finite) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
  const GC::Curve_jet<Traits> phi = jet<Traits>(3, 3, small), psi = jet<Traits>(3, 3, small);
  for (const double number : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    for (int j = 0; j <= 3; ++j)
      for (int i = 0; i < 3; ++i) {
        GC::Curve_jet<Traits> x = phi;
        x[j][i] = number;
        const auto quintic = [&](const auto& strategy) {
          if (j == 3) return; // is not read
          CHECK_ERROR(GC::blend(x, psi, strategy), not_finite);
          CHECK_ERROR(GC::blend(psi, x, strategy), not_finite);
        };
        const auto septic = [&](const auto& strategy) {
          CHECK_ERROR(GC::blend(x, psi, strategy), not_finite);
          CHECK_ERROR(GC::blend(psi, x, strategy), not_finite);
        };
        Every_strategy<double>::quintic(quintic);
        Every_strategy<double>::septic(septic);
      }
}

// Number types that are not known by their numerators and denominators: the operators.
BOOST_AUTO_TEST_CASE(quotients) {
  typedef CGAL::Quotient<CGAL::Gmpz> FT;
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
  const GC::Curve_jet<Traits> phi = jet<Traits>(3, 2, small), psi = jet<Traits>(3, 2, small);
  check_blend(phi, psi, GC::Minimal_energy<3>(), {});
}

BOOST_AUTO_TEST_CASE(lazy_numbers) { check_every_strategy<Lazy_traits>(3); }

// All numbers of a blend stay intervals until one of them is needed. These contain the exact
// values.
BOOST_AUTO_TEST_CASE(laziness) {
  const GC::Curve_jet<Lazy_traits> phi = jet<Lazy_traits>(3, 3, mixed), psi = jet<Lazy_traits>(3, 3, mixed);
  GC::Quintic_parameters<Lazy> p = GC::blend(phi, psi, GC::Near_line()).parameters;
  const CGAL::Interval_nt<false> before = p.s1.approx();
  BOOST_CHECK(!before.is_point() && before.sup() - before.inf() < 1e-6 * std::abs(before.sup()));
  // the curve is gone
  GC::Quintic_parameters<Exact> exact{p.s1.exact(), p.s2.exact(), false, false};
  const CGAL::Interval_nt<false> after = p.s1.approx();
  BOOST_CHECK(before.inf() <= after.inf() && after.sup() <= before.sup() && after.sup() - after.inf() <= 1e-15);
  check_number(p.s1.exact(), exact.s1);
  BOOST_CHECK(Exact(before.inf()) <= exact.s1 && exact.s1 <= Exact(before.sup()));
}

BOOST_AUTO_TEST_SUITE_END()
