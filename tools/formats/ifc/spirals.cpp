// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/spirals.h"

#include "formats/rails/Rail_check.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace ifc {

namespace {

// Adds c cos(pi frequency (a + w direction)), or c times the sine, as a polynomial of w in [0, 1]:
// the series of Taylor around 1/2, with an error below 10^-60 c.
void add_wave(std::vector<Q>& p, const Q& c, bool is_sine, int frequency, const Q& a, int direction) {
  if (c == 0) return;
  constexpr int terms = 74; // pi^terms / terms! < 10^-70
  Q turn = Q(frequency * (a + Q(direction) / 2) - (is_sine ? Q(1) / 2 : Q(0)));
  const double size = CGAL::to_double(turn);
  if (!(-1e15 < size && size < 1e15)) throw Not_covered{"a wave that begins beyond 10^15 of its lengths"};
  turn = Q(turn - 2 * Q(std::floor((size + 1) / 2)));
  const Q angle = shortened(Q(long_pi() * turn)), square = Q(angle * angle);
  Q cosine(1), sine = angle, even(1), odd = angle;
  for (int k = 2; k <= terms; k += 2) {
    even = shortened(Q(-even * square / ((k - 1) * k)));
    odd = shortened(Q(-odd * square / (k * (k + 1))));
    cosine = Q(cosine + even);
    sine = Q(sine + odd);
  }
  const Q derivatives[] = {cosine, Q(-sine), Q(-cosine), sine};
  const Q rate = Q(frequency * direction * long_pi());
  std::vector<Q> wave;
  Q factor = c;
  for (int j = 0; j < terms; ++j) {
    wave.push_back(shortened(Q(factor * derivatives[j % 4])));
    factor = shortened(Q(factor * rate / (j + 1)));
  }
  wave = along(std::move(wave), Q(Q(-1) / 2), Q(1));
  if (p.size() < wave.size()) p.resize(wave.size(), Q(0));
  for (std::size_t j = 0; j < wave.size(); ++j) p[j] = Q(p[j] + wave[j]);
}

// Adds the term sign(A) s^m / |A|^(m + 1) of a spiral with the constant A.
void add_term(std::vector<Q>& p, std::size_t m, const std::optional<Q>& a) {
  if (!a) return;
  if (*a == 0) throw Not_covered{"a spiral with a constant of zero"};
  const int n = static_cast<int>(m) + 1;
  Q term = Q(1 / power(absolute(*a), n));
  if (*a < 0) term = Q(-term);
  if (p.size() <= m) p.resize(m + 1, Q(0));
  p[m] = Q(p[m] + term);
}

} // namespace

Q power(const Q& x, int n) {
  Q result(1);
  for (; n > 0; --n) result = Q(result * x);
  return result;
}

Q absolute(const Q& x) { return x < 0 ? Q(-x) : x; }

std::vector<Q> along(std::vector<Q> p, const Q& a, const Q& l) {
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (std::size_t j = p.size() - 1; j-- > i;) p[j] = Q(p[j] + a * p[j + 1]);
  Q factor(1);
  for (Q& x : p) {
    x = Q(x * factor);
    factor = Q(factor * l);
  }
  return p;
}

std::vector<Q> Parent_curvature::part(const Q& start, const Q& length) const {
  std::vector<Q> p = along(polynomial, start, length);
  if (!has_waves() || start == 0) return p;
  if (length == 0) throw Not_covered{"a cosine or sine spiral without a length"};
  const Q a = Q(start / absolute(length));
  add_wave(p, cosine, false, 1, a, length < 0 ? -1 : 1);
  add_wave(p, sine, true, 2, a, length < 0 ? -1 : 1);
  return p;
}

std::optional<Parent_curvature> spiral(const File& file, const Entity& curve) {
  std::vector<std::pair<std::size_t, std::size_t>> terms; // of the argument, the power
  if (curve.type == "IFCCLOTHOID") terms = {{1, 1}};
  if (curve.type == "IFCSECONDORDERPOLYNOMIALSPIRAL") terms = {{1, 2}, {2, 1}, {3, 0}};
  if (curve.type == "IFCTHIRDORDERPOLYNOMIALSPIRAL") terms = {{1, 3}, {2, 2}, {3, 1}, {4, 0}};
  if (curve.type == "IFCSEVENTHORDERPOLYNOMIALSPIRAL")
    terms = {{1, 7}, {2, 6}, {3, 5}, {4, 4}, {5, 3}, {6, 2}, {7, 1}, {8, 0}};
  if (curve.type == "IFCCOSINESPIRAL") terms = {{2, 0}};
  if (curve.type == "IFCSINESPIRAL") terms = {{2, 1}, {3, 0}};
  if (terms.empty()) return std::nullopt;
  const std::vector<Step_value> a = file.arguments(curve, terms.back().first + 1);
  Parent_curvature k;
  for (const auto& [argument, m] : terms) add_term(k.polynomial, m, file.optional_number(a[argument], curve));
  const bool is_cosine = curve.type == "IFCCOSINESPIRAL";
  if (is_cosine || curve.type == "IFCSINESPIRAL") {
    const Q term = file.number(a[1], curve);
    if (term == 0) throw Not_covered{"a spiral with a constant of zero"};
    (is_cosine ? k.cosine : k.sine) = Q(1 / term);
  }
  return k;
}

GC::Curvature_law law(const Parent_curvature& k, const Q& start, const Q& length) {
  const Q sign(length < 0 ? -1 : 1);
  GC::Curvature_law law;
  law.polynomial = k.part(start, length);
  for (Q& p : law.polynomial) p = Q(p * sign);
  if (start == 0) {
    law.cosine = Q(k.cosine * sign);
    law.sine = k.sine; // the sine changes its sign as well
  }
  return law;
}

bool only_rises_or_falls(const GC::Curvature_law& law) {
  const std::size_t n = law.polynomial.empty() ? 0 : law.polynomial.size() - 1;
  if (law.cosine != 0) return n == 0 && law.sine == 0 && law.sine_over_turn == 0;
  const Q wave = Q(2 * long_pi() * law.sine + law.sine_over_turn);
  if (wave != 0) return n == 1 && absolute(wave) <= absolute(law.polynomial[1]);
  bool rises = true, falls = true;
  for (std::size_t i = 0; i < n; ++i) { // b_i = sum of C(i, j) / C(n - 1, j) (j + 1) p_(j + 1)
    Q b(0), ratio(1);
    for (std::size_t j = 0; j <= i; ++j) {
      b = Q(b + ratio * static_cast<int>(j + 1) * law.polynomial[j + 1]);
      if (j < i) ratio = Q(ratio * static_cast<int>(i - j) / static_cast<int>(n - 1 - j));
    }
    rises = rises && !(b < 0);
    falls = falls && !(b > 0);
  }
  return rises || falls;
}

} // namespace ifc
