// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "test.h"

// Random integers, the same in each run. A test derives its own class from them, with what it makes
// of them.

inline unsigned from_environment(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// Set GEOMETRIC_CONTINUITY_SEED to try other numbers.
inline unsigned first_seed() { return from_environment("GEOMETRIC_CONTINUITY_SEED", 2026); }

struct Report_seed {
  Report_seed() { std::cout << "random seed " << first_seed() << std::endl; }
};
BOOST_TEST_GLOBAL_FIXTURE(Report_seed);

template <class Engine = std::mt19937> class Random_integers {
protected:
  Engine engine_;

public:
  unsigned seed;
  explicit Random_integers(unsigned given = first_seed()) : engine_(given), seed(given) {}

  template <class Int> Int integer(Int low, std::common_type_t<Int> high) {
    typedef std::make_unsigned_t<Int> Number;
    static_assert(Number(-1) <= Engine::max(), "an engine with more bits is expected");
    return low + static_cast<Int>(engine_() % static_cast<Number>(high - low + 1));
  }
  bool coin() { return integer(0, 1) == 1; }

  // A numerator in this range over a denominator in that one, drawn in this order.
  template <class FT> FT fraction_of(int low, int high, int least, int most) {
    const int numerator = integer(low, high), denominator = integer(least, most);
    return FT(FT(numerator) / FT(denominator));
  }
};
