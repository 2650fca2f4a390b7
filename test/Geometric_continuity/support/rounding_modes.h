// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <cfenv>
#include <vector>

// A rounding mode of floating-point numbers, until the end of the scope.
class Rounding_mode {
  const int before_ = std::fegetround();

public:
  explicit Rounding_mode(int mode) { std::fesetround(mode); }
  Rounding_mode(const Rounding_mode&) = delete;
  Rounding_mode& operator=(const Rounding_mode&) = delete;
  ~Rounding_mode() { std::fesetround(before_); }
};

// The modes that there are, the nearest first: WebAssembly has no other.
inline const std::vector<int>& rounding_modes() {
  static const std::vector<int> modes = [] {
    std::vector<int> found;
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      const Rounding_mode rounding(mode);
      if (std::fegetround() == mode) found.push_back(mode);
    }
    return found;
  }();
  return modes;
}
// One of them, for a number that counts up.
inline int rounding_mode(int i) { return rounding_modes()[i % static_cast<int>(rounding_modes().size())]; }

// f() in a mode.
template <class Function> auto in_rounding_mode(int mode, const Function& f) {
  const Rounding_mode rounding(mode);
  return f();
}
