// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

// The fuzz targets have this in common. Each is one function of bytes, which libFuzzer or
// replay_main.cpp calls: typed errors are expected, everything else that escapes is a mistake, and
// so is a property that does not hold.

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

inline std::string_view fuzz_text(const std::uint8_t* data, std::size_t size) {
  return std::string_view(reinterpret_cast<const char*>(data), size);
}

// Ends the process unless a property holds.
inline void require(bool property, const char* what) {
  if (property) return;
  std::fprintf(stderr, "not true: %s\n", what);
  std::abort();
}

// Returns whether a text that was written holds a number longer than what is read: exact numbers
// can be.
inline bool has_long_number(const std::string& text) {
  std::istringstream is(text);
  for (std::string word; is >> word;)
    if (word.size() > GC::max_number_length) return true;
  return false;
}

// Calls f and returns whether it ended without a typed error, which must have a text.
template <class Function> bool accepts(Function f) {
  try {
    f();
    return true;
  } catch (const GC::Error& error) {
    require(std::string_view(error.what()).size() > to_string(error.code()).size() + 2, "an error has a reason");
    return false;
  }
}
