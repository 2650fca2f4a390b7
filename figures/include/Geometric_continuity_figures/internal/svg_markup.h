// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_MARKUP_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_MARKUP_H

#include <Geometric_continuity_figures/internal/Svg_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

/// \file svg_markup.h
/// Numbers, colours, lines and paths of SVG, in pixels.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// At most two decimals, whatever the locale, and always finite.
inline std::string svg_number(double x) {
  const double most = 1e6;
  if (!(x < most)) x = std::isnan(x) ? 0 : most;
  if (x < -most) x = -most;
  const long n = std::lround(100 * x), fraction = std::labs(n) % 100;
  std::string s = (n < 0 ? "-" : "") + std::to_string(std::labs(n) / 100);
  if (fraction != 0) s += (fraction < 10 ? ".0" : ".") + std::to_string(fraction % 10 == 0 ? fraction / 10 : fraction);
  return s;
}

// A step of an axis: digit * 10^power, where the digit is 1, 2 or 5.
struct Round_step {
  int digit, power;

  double value() const { return digit * std::pow(10.0, power); }

  // n steps as a decimal number, whatever the locale.
  std::string text(int n) const {
    std::string digits = std::to_string(std::abs(n) * digit), end;
    if (n == 0) return "0";
    if (power < -4 || power > 4)
      end = "e" + std::to_string(power);
    else if (power >= 0)
      digits.append(static_cast<std::size_t>(power), '0');
    else {
      const std::size_t after = static_cast<std::size_t>(-power);
      if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
      digits.insert(digits.size() - after, ".");
      digits.erase(digits.find_last_not_of('0') + 1);
      if (digits.back() == '.') digits.pop_back();
    }
    return (n < 0 ? "\xe2\x88\x92" : "") + digits + end; // a minus sign
  }
};

// The greatest one that is not greater than x > 0.
inline Round_step round_step(double x) {
  Round_step step{1, static_cast<int>(std::floor(std::log10(x)))};
  if (step.value() > x) --step.power; // by rounding
  for (int digit : {2, 5})
    if (Round_step{digit, step.power}.value() <= x) step.digit = digit;
  return step;
}

inline std::string svg_pair(const Svg_pixel& p) { return svg_number(p[0]) + ' ' + svg_number(p[1]); }

// The colours differ in lightness and stay distinct for the colour-blind

struct Stroke_style {
  const char* colour;
  double width;
  const char* dashes;
};
constexpr Stroke_style given_stroke{"#2f4058", 2, ""}, result_stroke{"#d55e00", 2.6, ""},
    polygon_stroke{"#8c8c8c", 0.9, ""}, teeth_stroke{"#a6cbe6", 0.7, ""}, cut_teeth_stroke{"#d3e5f2", 0.7, ""},
    envelope_stroke{"#3787c0", 1.1, ""}, ring_stroke{"#222222", 1.4, ""}, grid_stroke{"#e3e3e3", 0.8, ""},
    shadow_stroke{"#cdcdcd", 2.4, ""}, plumb_stroke{"#b4b4b4", 0.8, "2 3"}, axes_stroke{"#8c8c8c", 1, ""},
    construction_stroke{"#008060", 1.1, "5 4"};

inline const Stroke_style& stroke_of(Svg_role role) {
  return role == Svg_role::given ? given_stroke : role == Svg_role::result ? result_stroke : construction_stroke;
}

inline std::string svg_stroke(const Stroke_style& line, const std::string& path) {
  if (path.empty()) return path;
  const std::string dashes = line.dashes;
  return std::string("<path fill=\"none\" stroke=\"") + line.colour + "\" stroke-width=\"" + svg_number(line.width) +
         (dashes.empty() ? dashes : "\" stroke-dasharray=\"" + dashes) + "\" d=\"" + path + "\"/>\n";
}

// A white disk with a rim.
inline std::string svg_disk(const Svg_pixel& p, double radius, const Stroke_style& rim) {
  return "<circle cx=\"" + svg_number(p[0]) + "\" cy=\"" + svg_number(p[1]) + "\" r=\"" + svg_number(radius) +
         "\" fill=\"#ffffff\" stroke=\"" + rim.colour + "\" stroke-width=\"" + svg_number(rim.width) + "\"/>\n";
}

inline std::string svg_polyline(const std::vector<Svg_pixel>& points) {
  std::string path;
  for (const Svg_pixel& p : points) path += (path.empty() ? 'M' : 'L') + svg_pair(p);
  return path;
}

inline std::string svg_cubic(const Svg_pixel& b1, const Svg_pixel& b2, const Svg_pixel& b3) {
  return 'C' + svg_pair(b1) + ' ' + svg_pair(b2) + ' ' + svg_pair(b3);
}

// A curve through points that lie close together, with the tangents of Catmull and Rom.
inline std::string svg_smooth_path(const std::vector<Svg_pixel>& p) {
  if (p.size() < 2) return std::string();
  std::string path = 'M' + svg_pair(p[0]);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const Svg_pixel d0 = p[i + 1] - p[i == 0 ? 0 : i - 1], d1 = p[(std::min)(i + 2, p.size() - 1)] - p[i];
    path += svg_cubic(p[i] + d0 / 6.0, p[i + 1] - d1 / 6.0, p[i + 1]);
  }
  return path;
}

// The Bezier curve with these points: one cubic up to degree 3, else Hermite pieces, whose error is
// at most h^4/384 max |x''''| and is kept below 1/50.
inline std::string svg_curve_path(std::vector<Svg_pixel> b) {
  const int m = static_cast<int>(b.size()) - 1;
  std::string path = 'M' + svg_pair(b[0]);
  if (m <= 3) {
    b.resize(4);
    for (int n = m; n < 3; ++n) bernstein_elevate<double>(b, n);
    if (b[0] == b[3]) { // in two parts, for some viewers lose a cubic with a chord of length 0
      std::vector<Svg_pixel> left = b;
      bernstein_split(b, 3, 0.5, left);
      path += svg_cubic(left[1], left[2], left[3]);
    }
    return path + svg_cubic(b[1], b[2], b[3]);
  }
  std::vector<Svg_pixel> d = b;
  for (int j = 0; j < 4; ++j) difference_step(d, m - j);
  double most = 0;
  for (int j = 0; j <= m - 4; ++j) most = (std::max)(most, double(m) * (m - 1) * (m - 2) * (m - 3) * svg_length(d[j]));
  const int pieces = 1 + static_cast<int>((std::min)(200.0, std::pow(most / (384 * 0.02), 0.25)));
  for (int i = 0; i < pieces; ++i) {
    const Coordinate_jet<double, 2> start = polygon_jet(b, i / double(pieces), 1),
                                    end = polygon_jet(b, (i + 1) / double(pieces), 1);
    path += svg_cubic(start[0] + start[1] / (3.0 * pieces), end[0] - end[1] / (3.0 * pieces), end[0]);
  }
  return path;
}

// A colour between two, x from 0 to 1, as #rrggbb.
inline std::string svg_mix(const std::array<int, 3>& from, const std::array<int, 3>& to, double x) {
  char text[8];
  std::array<int, 3> c;
  for (int i = 0; i < 3; ++i)
    c[i] = static_cast<int>(std::lround(from[i] + (std::min)(1.0, (std::max)(0.0, x)) * (to[i] - from[i])));
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0], c[1], c[2]);
  return text;
}

// In tenths of a pixel: the first point, then steps. \pre there is a point
inline std::string svg_outline(const std::vector<Svg_pixel>& polygon) {
  std::string path;
  long x = 0, y = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const long i = std::lround(10 * polygon[k][0]), j = std::lround(10 * polygon[k][1]);
    if (k > 0 && i == x && j == y) continue;
    const char* separator = path.empty() ? "M" : path.find('l') == std::string::npos ? "l" : i < x ? "" : " ";
    path += separator + std::to_string(i - x) + (j < y ? "" : " ") + std::to_string(j - y);
    x = i;
    y = j;
  }
  return path + 'z';
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_MARKUP_H
