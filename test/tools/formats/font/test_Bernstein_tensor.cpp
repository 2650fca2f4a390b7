// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tensor-product Bernstein polynomials: values, products, parts.

#define BOOST_TEST_MODULE Bernstein_tensor
#include "support/test.h"

#include "formats/font/Bernstein_tensor.h"

typedef GC::Bernstein_tensor<Q> Tensor;

namespace {

constexpr unsigned seed = 20261122;
std::mt19937 engine(seed);

Q number() { return Q(static_cast<int>(engine() % 201) - 100) / Q(static_cast<int>(engine() % 9) + 1); }

std::vector<Q> numbers(std::size_t n) {
  std::vector<Q> x;
  while (x.size() < n) x.push_back(number());
  return x;
}

Tensor tensor(int variables, int degree) {
  std::size_t size = 1;
  for (int k = 0; k < variables; ++k) size *= static_cast<std::size_t>(degree) + 1;
  return Tensor(variables, degree, numbers(size));
}

} // namespace

BOOST_AUTO_TEST_CASE(values_by_the_definition) {
  // 1 B_0 B_0 + 2 B_1 B_0 + 3 B_0 B_1 + 5 B_1 B_1 is 1 + t_0 + 2 t_1 + t_0 t_1
  const Tensor p(2, 1, {1, 2, 3, 5});
  BOOST_CHECK(p({Q(1) / 2, Q(1) / 3}) == Q(1) + Q(1) / 2 + Q(2) / 3 + Q(1) / 6);
  BOOST_CHECK(p({Q(-2), Q(7)}) == Q(1) - 2 + 14 - 14);
  BOOST_CHECK(p[p.corner_index(1)] == 2 && p[p.corner_index(2)] == 3 && p[p.corner_index(3)] == 5);
  // t_0^2 t_2 in degree 2: the coefficients of t^2 are 0, 0, 1, those of t are 0, 1/2, 1
  std::vector<Q> c(27);
  for (std::size_t j = 0; j < 3; ++j) {
    c[2 + 3 * j + 9] = Q(1) / 2;
    c[2 + 3 * j + 18] = 1;
  }
  BOOST_CHECK(Tensor(3, 2, c)({Q(3), Q(11), Q(5)}) == 45);
  BOOST_CHECK(Tensor(0, 4, {Q(7)})({}) == 7);
}

BOOST_AUTO_TEST_CASE(arithmetic_and_parts) {
  std::cout << "seed " << seed << '\n';
  for (int variables = 0; variables <= 3; ++variables)
    for (int degree = 0; degree <= 2; ++degree) {
      const std::size_t m = static_cast<std::size_t>(variables);
      const Tensor p = tensor(variables, degree), q = tensor(variables, 1), r = tensor(variables, degree);
      const std::vector<Q> t = numbers(m);
      const Tensor product = p * q;
      BOOST_CHECK_EQUAL(product.degree(), degree + 1);
      BOOST_CHECK(product(t) == p(t) * q(t));
      BOOST_CHECK((p + r)(t) == p(t) + r(t) && (p - r)(t) == p(t) - r(t));
      for (std::size_t corner = 0; corner < (std::size_t(1) << m); ++corner) {
        std::vector<Q> at;
        for (std::size_t k = 0; k < m; ++k) at.push_back(static_cast<int>(corner >> k & 1));
        BOOST_CHECK(p[p.corner_index(corner)] == p(at));
      }
      for (std::size_t v = 0; v < m; ++v) {
        const Q s = number();
        const auto [left, right] = p.split(static_cast<int>(v), s);
        std::vector<Q> in_left = t, in_right = t;
        in_left[v] = s * t[v];
        in_right[v] = s + (1 - s) * t[v];
        BOOST_CHECK(left(t) == p(in_left) && right(t) == p(in_right));
      }
    }
}

BOOST_AUTO_TEST_CASE(refusals) {
  CHECK_ERROR(Tensor(2, 1, {1, 2, 3}), wrong_number_of_points);
  CHECK_ERROR(Tensor(-1, 1, {1}), negative_count);
  CHECK_ERROR(Tensor(1, -1, {1}), negative_count);
  const Tensor p(1, 1, {1, 2});
  CHECK_ERROR(p({}), dimension_mismatch);
  CHECK_ERROR(p.split(1, Q(1)), parameter_outside_domain);
  CHECK_ERROR(p + Tensor(1, 0, {1}), dimension_mismatch);
  CHECK_ERROR(p * Tensor(2, 0, {1}), dimension_mismatch);
}
