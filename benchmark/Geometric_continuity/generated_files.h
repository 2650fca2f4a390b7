// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

/// \file generated_files.h
/// Files of any size for the benchmarks, the same on each machine, written in constant memory.

// A random number from 0 to 2^bits - 1 for each key: the finisher of the generator SplitMix64.
inline std::int64_t random_bits(std::uint64_t key, int bits) {
  std::uint64_t x = key + 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return static_cast<std::int64_t>((x ^ (x >> 31)) >> (64 - bits));
}

// Gathers text and writes it in large blocks.
class Block_writer {
  static constexpr std::size_t block = 1 << 16;
  std::ostream& os_;
  std::string text_;

public:
  explicit Block_writer(std::ostream& os) : os_(os) {}
  Block_writer(const Block_writer&) = delete;
  Block_writer& operator=(const Block_writer&) = delete;
  ~Block_writer() { os_.write(text_.data(), static_cast<std::streamsize>(text_.size())); }

  template <class Text> Block_writer& operator<<(const Text& text) {
    text_ += text;
    if (text_.size() < block) return *this;
    os_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
    return *this;
  }
  // A whole number of units of 10^-digits as a decimal.
  Block_writer& decimal(std::int64_t units, int digits) {
    std::int64_t one = 1;
    for (int k = 0; k < digits; ++k) one *= 10;
    const std::int64_t size = units < 0 ? -units : units;
    char figures[24];
    if (units < 0) text_ += '-';
    text_.append(figures, std::to_chars(figures, figures + sizeof figures, size / one).ptr);
    char* const end = std::to_chars(figures, figures + sizeof figures, one + size % one).ptr;
    figures[0] = '.'; // instead of the 1 that keeps the zeros
    text_.append(figures, end);
    return *this;
  }
};

// A uniform bicubic B-spline surface in the form of its Bezier patches, a grid of rows x columns,
// which are twice continuously differentiable but for every 20th, whose point b11 is lifted: its
// edges u0 and v0 are creases, and u1 and v1 are only G1.
class Patch_grid {
  // A jitter from 0 to 2^bits - 1 for each control point and coordinate.
  static std::int64_t jitter(int i, int j, int coordinate, int bits) {
    return random_bits((static_cast<std::uint64_t>(i) << 34) + (static_cast<std::uint64_t>(j) << 2) +
                           static_cast<std::uint64_t>(coordinate),
                       bits);
  }

  // A coordinate of the control point (i, j) of the spline, in units of 36 * 10^-12.
  static std::int64_t spline_coordinate(int i, int j, int coordinate) {
    constexpr std::int64_t one = 1000000000000 / 36;
    const std::int64_t place = coordinate == 0 ? i * one : coordinate == 1 ? j * one : 0;
    // less than a third of the distance between two of them
    return place + jitter(i, j, coordinate, 33);
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

// Writes rows x columns bicubic patches in the format `.g2`, with decimals of at most 15 digits for
// at most 900 rows and columns.
inline void write_patches(std::ostream& os, int rows, int columns) {
  Block_writer out(os);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      out << "200 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n4 4\n0 0 0 0 1 1 1 1\n";
      for (int l = 0; l < 4; ++l)
        for (int k = 0; k < 4; ++k)
          for (int x = 0; x < 3; ++x)
            out.decimal(Patch_grid::coordinate(row, column, k, l, x), 12) << (x < 2 ? ' ' : '\n');
    }
}

// Writes the Bezier curves of a uniform cubic B-spline curve in space, which are twice continuously
// differentiable, in the format `.g2`, with decimals of at most 15 digits, 13 of them after the
// point. From random points a, b, c, e of the spline they are (a + 4b + c) / 6, (4b + 2c) / 6,
// (2b + 4c) / 6, (b + 4c + e) / 6.
inline void write_cubics(std::ostream& os, int count) {
  typedef std::array<std::int64_t, 3> Point; // in units of 10^-13 / 6
  const auto spline_point = [](int i) {
    Point p;
    for (int x = 0; x < 3; ++x) p[x] = random_bits((std::uint64_t(i) << 2) + x, 48) - (std::int64_t(1) << 47);
    return p;
  };
  Block_writer out(os);
  Point a = spline_point(0), b = spline_point(1), c = spline_point(2);
  for (int i = 0; i < count; ++i) {
    const Point e = spline_point(i + 3);
    out << "100 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n";
    const auto write = [&out](int wa, const Point& a, int wb, const Point& b, int wc, const Point& c) {
      for (int x = 0; x < 3; ++x) out.decimal(wa * a[x] + wb * b[x] + wc * c[x], 13) << (x < 2 ? ' ' : '\n');
    };
    write(1, a, 4, b, 1, c);
    write(0, a, 4, b, 2, c);
    write(0, a, 2, b, 4, c);
    write(1, b, 4, c, 1, e);
    a = b, b = c, c = e;
  }
}

// Writes cubics in space with six decimals. Each goes on in the direction of the one before,
// exactly, and with another curvature.
inline void write_bent_cubics(std::ostream& os, int count) {
  typedef std::array<std::int64_t, 3> Point; // in millionths
  Block_writer out(os);
  Point x{0, 0, 0}, leg{1000000, 300000, 200000};
  for (int i = 0; i < count; ++i) {
    std::array<Point, 4> p;
    const Point last = leg;
    for (int c = 0; c < 3; ++c) {
      const auto jitter = [&](int k) { return random_bits((std::uint64_t(i) << 3) + 2 * c + k, 19) - (1 << 18); };
      leg[c] = (c == 0 ? 1000000 : c == 1 ? 300000 : 200000) + jitter(0);
      p[0][c] = x[c];
      p[1][c] = x[c] + last[c];
      p[3][c] = x[c] + 3 * last[c] + jitter(1) / 4;
      p[2][c] = p[3][c] - leg[c];
    }
    out << "100 1 0 0\n3 0\n4 4\n0 0 0 0 1 1 1 1\n";
    for (const Point& point : p)
      for (int c = 0; c < 3; ++c) out.decimal(point[c], 6) << (c < 2 ? ' ' : '\n');
    x = p[3];
  }
}

// Writes an SVG drawing of `paths` paths of 100 segments as editors do, in relative coordinates
// with two decimals: curves that go on in the direction of the segment before as far as the
// decimals allow, or exactly (`s`), and every fifth segment is a line. Returns the number of
// coordinates.
inline std::int64_t write_drawing(std::ostream& os, int paths) {
  constexpr int segments = 100;
  Block_writer out(os);
  std::int64_t coordinates = 0;
  std::uint64_t key = 0;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 1000\">\n";
  for (int path = 0; path < paths; ++path) {
    const auto number = [&out, &coordinates](std::int64_t hundredths, const char* separator) {
      if (hundredths >= 0) out << separator; // a sign separates as well
      out.decimal(hundredths, 2);
      ++coordinates;
    };
    const auto point = [&number](std::int64_t x, std::int64_t y, const char* separator) {
      number(x, separator);
      number(y, ",");
    };
    const auto random = [&key](int bits) { return random_bits(++key, bits) - (std::int64_t(1) << (bits - 1)); };
    out << "<path fill=\"none\" stroke=\"#000\" d=\"M";
    point(50000 + random(16), 50000 + random(16), "");
    std::int64_t tangent_x = random(11), tangent_y = random(11);
    for (int k = 0; k < segments; ++k) {
      const std::int64_t x = random(13), y = random(13);
      if (k % 5 == 4) {
        out << 'l';
        tangent_x = x, tangent_y = y;
      } else {
        const bool smooth = k % 5 % 2 == 1;
        out << (smooth ? 's' : 'c');
        if (!smooth) point(5 * tangent_x / 8, 5 * tangent_y / 8, "");
        tangent_x = random(11), tangent_y = random(11);
        point(x - tangent_x, y - tangent_y, smooth ? "" : ",");
      }
      point(x, y, k % 5 == 4 ? "" : ",");
    }
    out << "\"/>\n";
  }
  out << "</svg>\n";
  return coordinates;
}

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_GENERATED_FILES_H
