// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Clothoid integrals, and those of other transitions, in intervals and in integers against Arb,
// which integrates e^(i theta) numerically in balls of 200 bits; sines, cosines and angles, too.

#define BOOST_TEST_MODULE arb_integrals

#include "support/arb.h"
#include "support/random.h"

#include <CGAL/Geometric_continuity/numbers/internal/cubic_length.h>
#include <CGAL/Geometric_continuity/numbers/internal/enclosing_arithmetic.h>
#include <CGAL/Geometric_continuity/numbers/internal/oscillating_integral.h>

using GC::internal::Angle_rate;
using GC::internal::Ball_arithmetic;
using GC::internal::Fixed_ball;
typedef CGAL::Interval_nt<false> Interval;
using GC::internal::Interval_arithmetic;
using GC::internal::Rational;

typedef Random_integers<std::mt19937_64> Random;

// A rational number as a ball.
arb::Ball ball(const Rational& x) {
  fmpq_t q;
  fmpq_init(q);
  BOOST_REQUIRE(fmpq_set_str(q, text(x).c_str(), 10) == 0);
  arb::Ball b;
  arb_set_fmpq(b.get(), q, 1400);
  fmpq_clear(q);
  return b;
}

bool encloses(const Interval& i, const arb::Ball& x) { return arb::encloses(GC::Enclosure{i.inf(), i.sup()}, x); }
bool encloses(const Fixed_ball& i, const arb::Ball& x) {
  return !arb_lt(x.get(), ball(i.lower()).get()) && !arb_gt(x.get(), ball(i.upper()).get());
}

struct Complex_ball {
  arb::Ball re, im;
};

// The integral over [0, 1] of e^(i theta) with theta(w) = sum p_j w^(j+1) / (j+1) + c sin(pi w) /
// pi + (s + r / (2 pi)) (1 - cos(2 pi w)) / (2 pi).
Complex_ball integral(const Angle_rate& rate) {
  struct Coefficients {
    std::vector<arb::Ball> polynomial;
    arb::Ball cosine, sine;
  } theta;
  for (std::size_t j = 0; j < rate.polynomial.size(); ++j)
    theta.polynomial.push_back(ball(Rational(rate.polynomial[j] / static_cast<int>(j + 1))));
  arb::Ball pi;
  arb_const_pi(pi.get(), 300);
  theta.cosine = ball(rate.cosine) / pi;
  theta.sine = (ball(rate.sine) + ball(rate.sine_over_turn) / (pi + pi)) / (pi + pi);
  const auto value = [](acb_ptr result, const acb_t w, void* parameter, slong, slong precision) {
    const Coefficients& f = *static_cast<Coefficients*>(parameter);
    acb_t sum, wave;
    acb_init(sum);
    acb_init(wave);
    for (std::size_t j = f.polynomial.size(); j-- > 0;) {
      acb_add_arb(sum, sum, f.polynomial[j].get(), precision);
      acb_mul(sum, sum, w, precision);
    }
    acb_sin_pi(wave, w, precision);
    acb_addmul_arb(sum, wave, f.cosine.get(), precision);
    acb_mul_2exp_si(wave, w, 1);
    acb_cos_pi(wave, wave, precision);
    acb_sub_si(wave, wave, 1, precision);
    acb_neg(wave, wave);
    acb_addmul_arb(sum, wave, f.sine.get(), precision);
    acb_mul_onei(sum, sum);
    acb_exp(result, sum, precision);
    acb_clear(sum);
    acb_clear(wave);
    return 0;
  };
  acb_t result, zero, one;
  for (acb_ptr x : {result, zero, one}) acb_init(x);
  acb_one(one);
  mag_t error;
  mag_init(error);
  mag_set_ui_2exp_si(error, 1, -180);
  acb_calc_integrate(result, value, &theta, zero, one, 180, error, nullptr, arb::bits);
  Complex_ball z;
  arb_set(z.re.get(), acb_realref(result));
  arb_set(z.im.get(), acb_imagref(result));
  mag_clear(error);
  for (acb_ptr x : {result, zero, one}) acb_clear(x);
  return z;
}

Rational decimal(Random& random, std::int64_t size) {
  return Rational(Rational(random.integer(-size * 1000000, size * 1000000)) / Rational(1000000));
}

// How many cases: many, when somebody asks for them.
int number_of_cases(int few) {
  const char* const number = std::getenv("GEOMETRIC_CONTINUITY_INTEGRALS");
  return number == nullptr ? few : std::atoi(number);
}

void check_integral(const Angle_rate& rate, bool with_integers) {
  const Complex_ball z = integral(rate);
  {
    const CGAL::Protect_FPU_rounding<true> upwards;
    const auto i = GC::internal::oscillating_integral(Interval_arithmetic(), rate);
    const double pieces = GC::internal::Oscillating_integral<Interval_arithmetic>::pieces(rate);
    BOOST_CHECK_MESSAGE(encloses(i.re, z.re) && encloses(i.im, z.im), text("interval of ", rate.polynomial[0]));
    BOOST_CHECK(i.re.sup() - i.re.inf() < 4e-14 * (1 + pieces) && i.im.sup() - i.im.inf() < 4e-14 * (1 + pieces));
  }
  if (!with_integers) return;
  const Ball_arithmetic a(160);
  const auto b = GC::internal::oscillating_integral(a, rate);
  BOOST_CHECK_MESSAGE(encloses(b.re, z.re) && encloses(b.im, z.im), text("integers of ", rate.polynomial[0]));
  for (const Fixed_ball* x : {&b.re, &b.im}) BOOST_CHECK(CGAL::to_double(Rational(x->upper() - x->lower())) < 0x1p-120);
}

BOOST_AUTO_TEST_CASE(clothoids) {
  Random random;
  const GC::internal::Work_guard work("test", 1e9);
  const int cases = number_of_cases(1000);
  for (int i = 0; i < cases; ++i) {
    const std::int64_t size = std::array<std::int64_t, 4>{1, 3, 30, 300}[static_cast<std::size_t>(i % 64 ? i % 3 : 3)];
    check_integral({{decimal(random, size), decimal(random, size)}, 0, 0, 0}, i % 4 == 0);
  }
}

BOOST_AUTO_TEST_CASE(other_transitions) {
  Random random;
  const GC::internal::Work_guard work("test", 1e9);
  const int cases = number_of_cases(1000) / 10;
  for (int i = 0; i < cases; ++i) {
    Angle_rate rate;
    for (int j = random.integer(0, 7); j >= 0; --j) rate.polynomial.push_back(decimal(random, 4));
    if (random.coin()) rate.cosine = decimal(random, 3);
    if (random.coin()) rate.sine = decimal(random, 3);
    if (random.coin()) rate.sine_over_turn = decimal(random, 3);
    check_integral(rate, i % 4 == 0);
  }
}

template <class Arithmetic>
void check_angles(const Arithmetic& a, const Rational& x, const Rational& y, const Rational& error) {
  constexpr slong bits = 1500;
  arb::Ball cosine, sine, angle;
  arb_sin_cos(sine.get(), cosine.get(), ball(x).get(), bits);
  const auto c = a.cosine_and_sine(a(x));
  BOOST_CHECK_MESSAGE(encloses(c.cosine, cosine) && encloses(c.sine, sine), text("cosine and sine of ", x));
  if (x == 0 && y == 0) return;
  arb_atan2(angle.get(), ball(y).get(), ball(x).get(), bits);
  const auto enclosed = GC::internal::angle_of_vector(a, a(x), a(y));
  BOOST_CHECK_MESSAGE(encloses(enclosed, angle), text("angle of ", x, ", ", y));
  for (const auto& z : {c.cosine, c.sine, enclosed}) // it is narrow
    BOOST_CHECK(a.at_most(a.absolute_value(z - a(a.exact_middle(z))), error) == GC::Verdict::proved);
}

BOOST_AUTO_TEST_CASE(sines_and_angles) {
  Random random;
  const GC::internal::Work_guard work("test", 1e9);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t size = std::array<std::int64_t, 4>{1, 7, 1000, 500000}[static_cast<std::size_t>(i % 4)];
    const Rational x = i % 50 == 0 ? Rational(i % 3) : decimal(random, size),
                   y = i % 60 == 0 ? Rational(0) : decimal(random, size);
    {
      const CGAL::Protect_FPU_rounding<true> upwards;
      check_angles(Interval_arithmetic(), x, y, Rational(size < 500000 ? 4e-13 : 2e-10));
    }
    if (i % 10 == 0)
      for (const int bits : {160, 320, 640, 1280})
        check_angles(Ball_arithmetic(bits), x, y, Fixed_ball::symmetric(24 - bits, bits).upper());
  }
}

BOOST_AUTO_TEST_CASE(lengths_of_cubics) {
  Random random;
  const GC::internal::Work_guard work("test", 1e9);
  for (int i = 0; i < 6; ++i) {
    std::array<GC::internal::Cubic, 2> cubic;
    arb::Polynomial square;
    for (int k = 0; k < 2; ++k) {
      // the derivative has the Bernstein coefficients a, b, c; cusps are not near
      const long a = k == 0 ? random.integer(5, 20) : random.integer(-20, 20), b = random.integer(-4, 9),
                 c = k == 0 ? random.integer(5, 20) : random.integer(-20, 20);
      cubic[static_cast<std::size_t>(k)] = {Rational(7), Rational(a), Rational(b - a),
                                            Rational(Rational(a - 2 * b + c) / 3)};
      const arb::Polynomial d = arb::Polynomial::parabola(a, b, c);
      square = square + d * d;
    }
    const arb::Ball length = arb::Polynomial::integral(arb::Polynomial::parabola(1, 1, 1), square, 0);
    const Ball_arithmetic a(160);
    const Fixed_ball enclosed = GC::internal::Cubic_length<Ball_arithmetic>(a, cubic[0], cubic[1])(0, 1);
    BOOST_CHECK(encloses(enclosed, length) && enclosed.upper() - enclosed.lower() < Rational(1e-30));
    {
      const CGAL::Protect_FPU_rounding<true> upwards;
      const Interval i =
          GC::internal::Cubic_length<Interval_arithmetic>(Interval_arithmetic(), cubic[0], cubic[1])(0, 1);
      BOOST_CHECK(Rational(i.inf()) <= enclosed.upper() && enclosed.lower() <= Rational(i.sup()) &&
                  i.sup() - i.inf() < 1e-10);
    }
    // the graph has this length at the parameter that is found
    const GC::internal::Cubic& graph = cubic[1];
    const Fixed_ball t = GC::internal::parameter_of_length(a, graph, Rational(12));
    GC::internal::Cubic_length<Ball_arithmetic> length_to(a, {Rational(0), Rational(1), Rational(0), Rational(0)},
                                                          graph);
    BOOST_CHECK(length_to(0, t.lower()).lower() <= 12 && 12 <= length_to(0, t.upper()).upper());
    BOOST_CHECK(t.upper() - t.lower() < Rational(1e-25));
  }
}
