// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Taylor models enclose what they are computed from: against exact numbers, at parameters of the
// range, in each rounding mode.

#include "support/random.h"

#include <CGAL/Geometric_continuity/cad/internal/Taylor_model.h>
#include <cfenv>

BOOST_AUTO_TEST_SUITE(Taylor_model)

using GC::internal::Interval;
using Model = GC::internal::Taylor_model;

Q exactly(const Model& f, const Q& s) {
  Q y(0);
  for (int k = Model::size - 1; k >= 0; --k) y = y * s + Q(f.c[k]);
  return y;
}
// Returns whether y is a value that the model allows at s.
bool allows(const Model& f, const Q& s, const Q& y) { return CGAL::abs(Q(y - exactly(f, s))) <= Q(f.r); }

template <class Random> Model random_model(Random& random, double decay, double r) {
  std::uniform_real_distribution<double> number(-1, 1);
  Model f;
  double scale = 1;
  for (double& x : f.c) x = scale * number(random), scale *= decay;
  f.r = r;
  return f;
}

BOOST_AUTO_TEST_CASE(operations) {
  const unsigned seed = first_seed();
  std::mt19937 random(seed);
  int wrong = 0, wide = 0;
  for (int round = 0; round < 40; ++round) {
    const double decay = round % 2 ? 1 : 0.3, r = round % 4 < 2 ? 0 : 1e-5;
    const Model f = random_model(random, decay, r), g = random_model(random, decay, r);
    Model low_f = f, low_g = g; // of degree 3: nothing is left out of the product but roundings
    for (int k = 4; k < Model::size; ++k) low_f.c[k] = low_g.c[k] = 0;
    Model positive = random_model(random, 0.2, r);
    positive.c[0] = 1.5;
    for (int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const Model sum = f + g, difference = f - g, product = f * g, low_product = low_f * low_g,
                  reciprocal = GC::internal::reciprocal(positive), root = GC::internal::reciprocal_root(positive);
      std::fesetround(FE_TONEAREST);
      wrong += !reciprocal.known() + !root.known();
      for (int i = -4; i <= 4; ++i) {
        const Q s = Q(i) / Q(4);
        for (int of_f : {-1, 0, 1})
          for (int of_g : {-1, 0, 1}) { // the ends of what is allowed
            const Q x = exactly(f, s) + of_f * Q(f.r), y = exactly(g, s) + of_g * Q(g.r);
            wrong += !allows(sum, s, x + y) + !allows(difference, s, x - y) + !allows(product, s, x * y);
          }
        wrong += r == 0 && !allows(low_product, s, exactly(low_f, s) * exactly(low_g, s));
        for (int of : {-1, 0, 1}) {
          const Q x = exactly(positive, s) + of * Q(positive.r), below = exactly(root, s) - Q(root.r),
                  above = exactly(root, s) + Q(root.r);
          wrong += !allows(reciprocal, s, Q(1) / x);
          wrong += !(below * below * x <= Q(1) && Q(1) <= above * above * x && below > Q(0));
        }
      }
      if (r == 0) wide += !(sum.r < 1e-14) + !(low_product.r < 1e-13) + (decay < 1 && !(product.r < 0.02));
    }
    const CGAL::Protect_FPU_rounding<true> upwards;
    const Interval range = f.range();
    double smallest = f.c[0], largest = f.c[0];
    for (int i = -32; i <= 32; ++i) {
      const Q y = exactly(f, Q(i) / Q(32));
      wrong += !(Q(range.inf()) <= y - Q(f.r) && y + Q(f.r) <= Q(range.sup()));
      const Interval at_point = f(Interval(i * 0x1p-5));
      wrong += !(Q(at_point.inf()) <= y - Q(f.r) && y + Q(f.r) <= Q(at_point.sup()));
      smallest = (std::min)(smallest, CGAL::to_double(y));
      largest = (std::max)(largest, CGAL::to_double(y));
    }
    if (decay < 1) wide += !(range.sup() - range.inf() <= 1.3 * (largest - smallest) + 3 * f.r + 0.02);
  }
  BOOST_TEST_CONTEXT("seed " << seed) {
    BOOST_TEST(wrong == 0);
    BOOST_TEST(wide == 0);
  }
}

BOOST_AUTO_TEST_CASE(what_is_not_known) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  Model crossing(0.5); // zero within the range
  crossing.c[1] = 1;
  BOOST_TEST(!GC::internal::reciprocal(crossing).known());
  BOOST_TEST(!GC::internal::reciprocal_root(crossing).known());
  BOOST_TEST(!GC::internal::reciprocal_root(Model(-1)).known());
  BOOST_TEST(!GC::internal::reciprocal(Model(0)).known());
  const Model huge(1e200);
  BOOST_TEST(!(huge * huge).known());
  BOOST_TEST(!(huge * huge - huge * huge).known());
  BOOST_TEST(!(Model::unknown() * Model(0)).known());
  BOOST_TEST(Model::unknown().range().is_same(Interval::largest()));
  BOOST_TEST(Model::unknown()(Interval(0)).is_same(Interval::largest()));
  Model long_sum(1); // whose coefficients are known, but no bound of their sum
  for (double& x : long_sum.c) x = (std::numeric_limits<double>::max)();
  BOOST_TEST(long_sum.known());
  BOOST_TEST(long_sum.range().is_same(Interval::largest()));
}

BOOST_AUTO_TEST_SUITE_END()
