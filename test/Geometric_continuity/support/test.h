// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// This is the preamble of the unit tests: Boost.Test, the kernels, names for them, and how errors
// are checked. Most of it is precompiled.

#include "errors.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <iterator>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Q;
typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Exact_3;
typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Exact_d;
typedef GC::Traits_2<CGAL::Simple_cartesian<double>> Double_2;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
typedef GC::Traits_d<CGAL::Cartesian_d<double>> Double_d;
typedef GC::Traits_2<CGAL::Epick> Epick_2;
typedef GC::Traits_3<CGAL::Epick> Epick_3;
typedef GC::Traits_2<CGAL::Epeck> Epeck_2;
typedef GC::Traits_3<CGAL::Epeck> Epeck_3;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A locale in which 1234.5 is 1.234,5.
inline std::locale continental() {
  struct Continental : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  return std::locale(std::locale::classic(), new Continental);
}

// A test for each of these types, which have numbers of a type FT.
#define TEST_FOR_EACH(name, Type, types)                                                                               \
  template <class Type, class FT = typename Type::FT> void name##_for();                                               \
  BOOST_AUTO_TEST_CASE_TEMPLATE(name, Type, types) { name##_for<Type>(); }                                             \
  template <class Type, class FT> void name##_for()

// Returns the text that is written for the parts one after the other.
template <class... T> std::string text(const T&... part) {
  std::ostringstream os;
  (os << ... << part);
  return os.str();
}
// Returns the text that f(os) writes.
template <class F> std::string written_by(F f) {
  std::ostringstream os;
  f(os);
  return os.str();
}
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// An engine with this seed, which is told.
template <class Engine = std::mt19937> Engine seeded(unsigned seed) {
  std::cout << "seed " << seed << '\n';
  return Engine(seed);
}
