// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H

#include <cstdint>
#include <ostream>
#include <string>

/// \file generated_files.h
/// Files of any size for the benchmarks, the same on each machine, written in constant memory.

// A whole number of units of 10^-12 as a decimal.
inline std::string decimal_of_units(std::int64_t units) {
  constexpr std::int64_t one = 1000000000000;
  const std::int64_t size = units < 0 ? -units : units;
  return (units < 0 ? "-" : "") + std::to_string(size / one) + '.' + std::to_string(one + size % one).substr(1);
}

// A uniform bicubic B-spline surface in the form of its Bezier patches, a grid of rows x columns, which are twice continuously
// differentiable but for every 20th, whose point b11 is lifted: its edges u0 and v0 are creases, and u1 and v1 are only G1.
class Patch_grid {
  // A jitter from 0 to 2^bits - 1 for each control point and coordinate.
  static std::int64_t jitter(int i, int j, int coordinate, int bits) {
    std::uint64_t x = (static_cast<std::uint64_t>(i) << 34) + (static_cast<std::uint64_t>(j) << 2) +
                      static_cast<std::uint64_t>(coordinate) + 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9; // as the generator SplitMix64 does
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return static_cast<std::int64_t>((x ^ (x >> 31)) >> (64 - bits));
  }

  // A coordinate of the control point (i, j) of the spline, in units of 36 * 10^-12.
  static std::int64_t spline_coordinate(int i, int j, int coordinate) {
    constexpr std::int64_t one = 1000000000000 / 36;
    const std::int64_t place = coordinate == 0 ? i * one : coordinate == 1 ? j * one : 0;
    return place + jitter(i, j, coordinate, 33); // less than a third of the distance between two of them
  }

public:
  // A coordinate of the control point b_kl of the patch in a row and a column, in units of 10^-12.
  static std::int64_t coordinate(int row, int column, int k, int l, int coordinate) {
    static constexpr int sixths[4][4] = {{1, 4, 1, 0}, {0, 4, 2, 0}, {0, 2, 4, 0}, {0, 1, 4, 1}};
    std::int64_t sum = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (sixths[k][i] * sixths[l][j] != 0)
          sum += sixths[k][i] * sixths[l][j] * spline_coordinate(row + i, column + j, coordinate);
    const bool lifted = (7 * row + column) % 20 == 10 && k == 1 && l == 1 && coordinate == 2;
    return lifted ? sum + 50000000000 : sum;
  }
};

// Writes rows x columns bicubic patches in the format `.g2`, with decimals of at most 15 digits for at most 900 rows and columns.
inline void write_patches(std::ostream& os, int rows, int columns) {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      os << "200 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n4 4\n0 0 0 0 1 1 1 1\n";
      for (int l = 0; l < 4; ++l)
        for (int k = 0; k < 4; ++k)
          for (int x = 0; x < 3; ++x)
            os << decimal_of_units(Patch_grid::coordinate(row, column, k, l, x)) << (x < 2 ? ' ' : '\n');
    }
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H
