// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The arithmetic of cpp_rational, compiled with optimisation: greatest common divisors of its long
// integers take most of the time of its tests. These are compiled without and linked after this
// file, so that of each function that both instantiate, the linker takes the one from here.

#include <boost/multiprecision/cpp_int.hpp>

typedef boost::multiprecision::cpp_rational Rational;

bool instantiate_arithmetic(Rational& x, const Rational& y) {
  x += y;
  x -= y;
  x *= y;
  x /= y;
  x = x + y;
  x = x - y;
  x = x * y;
  x = x / y;
  x = -y;
  return x < y || x == y;
}
