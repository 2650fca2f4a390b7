// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Geometric_continuity/numbers/Enclosure.h>

#include <acb.h>
#include <acb_calc.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_poly.h>

#include <array>
#include <vector>

// The tests need this of Arb and FLINT: numbers in balls of 200 bits, polynomials with integers as
// coefficients, and their real roots.

namespace arb {

constexpr slong bits = 200;

class Ball {
  arb_t x_;

public:
  Ball() { arb_init(x_); }
  Ball(double x) : Ball() { arb_set_d(x_, x); }
  Ball(const Ball& b) : Ball() { arb_set(x_, b.x_); }
  Ball& operator=(const Ball& b) {
    arb_set(x_, b.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }
  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

  friend Ball operator+(const Ball& a, const Ball& b) { return of(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return of(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return of(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return of(arb_div, a, b); }
  friend Ball atan2(const Ball& y, const Ball& x) { return of(arb_atan2, y, x); }
  friend Ball max(const Ball& a, const Ball& b) { return of(arb_max, a, b); }
  friend Ball min(const Ball& a, const Ball& b) { return of(arb_min, a, b); }
  friend Ball root(const Ball& a) { // of a number that is not negative
    Ball r;
    arb_sqrtpos(r.x_, a.x_, bits);
    return r;
  }
  friend Ball abs(const Ball& a) {
    Ball r;
    arb_abs(r.x_, a.x_);
    return r;
  }

private:
  static Ball of(void (*f)(arb_t, const arb_t, const arb_t, slong), const Ball& a, const Ball& b) {
    Ball r;
    f(r.x_, a.x_, b.x_, bits);
    return r;
  }
};

// Returns whether the enclosure holds what the ball, which is a small one, holds.
inline bool encloses(const CGAL::Geometric_continuity::Enclosure& e, const Ball& x) {
  const Ball lower(e.lower), upper(e.upper);
  mag_t radius;
  mag_init(radius);
  mag_set_ui_2exp_si(radius, 1, -90);
  const bool is_small = mag_cmp(arb_radref(x.get()), radius) < 0 || arb_rel_accuracy_bits(x.get()) > 90;
  mag_clear(radius);
  return is_small && !arb_lt(x.get(), lower.get()) && !arb_gt(x.get(), upper.get());
}

typedef std::array<Ball, 3> Vector; // in the plane the last coordinate is 0
template <class X> using Coordinates = std::array<X, 3>;

template <class X> X dot(const Coordinates<X>& v, const Coordinates<X>& w) {
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
template <class X> Coordinates<X> cross(const Coordinates<X>& v, const Coordinates<X>& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}
template <class X> Coordinates<X> minus(const Coordinates<X>& v, const Coordinates<X>& w) {
  return {v[0] - w[0], v[1] - w[1], v[2] - w[2]};
}
inline Vector times(const Ball& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
inline Ball length(const Vector& v) { return root(dot(v, v)); }
inline Ball angle(const Vector& v,
                  // with a right side of atan2 that is not negative, which is continuous there
                  const Vector& w) {
  const Ball sine = length(cross(v, w)), cosine = dot(v, w);
  if (!arb_is_negative(cosine.get())) return atan2(sine, cosine);
  Ball pi;
  arb_const_pi(pi.get(), bits);
  return pi - atan2(sine, Ball(0) - cosine);
}

class Polynomial {
  fmpz_poly_t p_;

public:
  Polynomial() { fmpz_poly_init(p_); }
  Polynomial(const Polynomial& q) : Polynomial() { fmpz_poly_set(p_, q.p_); }
  Polynomial& operator=(const Polynomial& q) {
    fmpz_poly_set(p_, q.p_);
    return *this;
  }
  ~Polynomial() { fmpz_poly_clear(p_); }

  // With the Bernstein coefficients a, b, c of a parabola on [0, 1].
  static Polynomial parabola(long a, long b, long c) {
    Polynomial r;
    fmpz_poly_set_coeff_si(r.p_, 0, a);
    fmpz_poly_set_coeff_si(r.p_, 1, 2 * (b - a));
    fmpz_poly_set_coeff_si(r.p_, 2, a - 2 * b + c);
    return r;
  }

  friend Polynomial operator+(const Polynomial& p, const Polynomial& q) { return of(fmpz_poly_add, p, q); }
  friend Polynomial operator-(const Polynomial& p, const Polynomial& q) { return of(fmpz_poly_sub, p, q); }
  friend Polynomial operator*(const Polynomial& p, const Polynomial& q) { return of(fmpz_poly_mul, p, q); }
  Polynomial derivative() const {
    Polynomial r;
    fmpz_poly_derivative(r.p_, p_);
    return r;
  }
  Ball operator()(const Ball& t) const {
    Ball r;
    arb_fmpz_poly_evaluate_arb(r.get(), p_, t.get(), bits);
    return r;
  }

  // Those that may be in [0, 1], and the ends.
  std::vector<Ball> roots_and_ends() const {
    std::vector<Ball> result = {Ball(0), Ball(1)};
    Polynomial common, simple;
    fmpz_poly_gcd(common.p_, p_, derivative().p_);
    if (fmpz_poly_degree(p_) < 1) return result;
    fmpz_poly_div(simple.p_, p_, common.p_);
    const slong degree = fmpz_poly_degree(simple.p_);
    acb_ptr roots = _acb_vec_init(degree);
    arb_fmpz_poly_complex_roots(roots, simple.p_, 0, bits);
    for (slong i = 0; i < degree; ++i) {
      Ball x;
      arb_set(x.get(), acb_realref(roots + i));
      if (arb_is_zero(acb_imagref(roots + i)) && !arb_is_negative(x.get()) && !arb_gt(x.get(), result[1].get()))
        result.push_back(x);
    }
    _acb_vec_clear(roots, degree);
    return result;
  }

  // The integral of p / g^n sqrt(g) over [0, 1].
  static Ball integral(const Polynomial& p, const Polynomial& g, int n) {
    struct Integrand {
      const Polynomial &p, &g;
      int n;
    } integrand{p, g, n};
    const auto value = [](acb_ptr result, const acb_t t, void* parameter, slong is_analytic, slong precision) {
      const Integrand& f = *static_cast<Integrand*>(parameter);
      acb_t square, power;
      acb_init(square);
      acb_init(power);
      arb_fmpz_poly_evaluate_acb(result, f.p.p_, t, precision);
      arb_fmpz_poly_evaluate_acb(square, f.g.p_, t, precision);
      acb_pow_ui(power, square, static_cast<ulong>(f.n), precision);
      acb_div(result, result, power, precision);
      acb_sqrt_analytic(square, square, is_analytic != 0, precision);
      acb_mul(result, result, square, precision);
      acb_clear(square);
      acb_clear(power);
      return 0;
    };
    acb_t result, zero, one;
    for (acb_ptr x : {result, zero, one}) acb_init(x);
    acb_one(one);
    mag_t error;
    mag_init(error);
    acb_calc_integrate(result, value, &integrand, zero, one, 40, error, nullptr, 80);
    Ball r;
    arb_set(r.get(), acb_realref(result));
    mag_clear(error);
    for (acb_ptr x : {result, zero, one}) acb_clear(x);
    return r;
  }

private:
  static Polynomial of(void (*f)(fmpz_poly_t, const fmpz_poly_t, const fmpz_poly_t), const Polynomial& p,
                       const Polynomial& q) {
    Polynomial r;
    f(r.p_, p.p_, q.p_);
    return r;
  }
};

} // namespace arb
