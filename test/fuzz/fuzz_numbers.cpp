// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers: what is read and written reads back equal, and floating-point numbers are next to the
// exact ones.

#include "fuzz_target.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <limits>

namespace {

template <class FT> std::string written(const FT& x) {
  std::ostringstream os;
  GC::write_number(os, x);
  return os.str();
}

// Reads a number and reads back what is written of it, unless that is longer than what can be read.
template <class FT> bool round_trip(std::string_view text, FT& x) {
  if (!accepts([&] { x = GC::parse_number<FT>(text); })) return false;
  const std::string again = written(x);
  if (again.size() <= GC::max_number_length)
    require(GC::parse_number<FT>(again) == x, "a number that is written reads back equal");
  return true;
}

template <class FT> void is_nearest(FT rounded, const CGAL::Exact_rational& x) {
  typedef CGAL::Exact_rational Exact;
  const FT infinity = std::numeric_limits<FT>::infinity();
  const Exact error = CGAL::abs(Exact(Exact(rounded) - x));
  for (const FT towards : {-infinity, infinity}) {
    const FT neighbour = std::nextafter(rounded, towards);
    if (std::isfinite(neighbour))
      require(error <= CGAL::abs(Exact(Exact(neighbour) - x)), "a floating-point number is the nearest one");
  }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz_text(data, size);
  CGAL::Exact_rational exact;
  CGAL::Exact_predicates_exact_constructions_kernel::FT lazy;
  double d;
  float f;
  const bool is_number = round_trip(text, exact);
  require(round_trip(text, lazy) == is_number, "all exact kernels read the same numbers");
  if (is_number) require(lazy.exact() == exact, "all exact kernels read the same number");
  if (round_trip(text, d)) {
    require(is_number, "what double reads is a number");
    is_nearest(d, exact);
  }
  if (round_trip(text, f)) {
    require(is_number, "what float reads is a number");
    is_nearest(f, exact);
  }
  return 0;
}
