// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_MODULE_REQUEST_H
#define GEOMETRIC_CONTINUITY_BROWSER_MODULE_REQUEST_H

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Simple_cartesian.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef CGAL::Exact_rational Exact;
typedef GC::Traits_d<CGAL::Cartesian_d<Exact>> Module_traits; // for curves of all dimensions
typedef GC::Rational_bezier_curve<Module_traits> Module_curve;
typedef GC::Traits_3<CGAL::Simple_cartesian<Exact>> Patch_traits;
typedef GC::Bezier_patch<Patch_traits> Module_patch;

// The arguments of a function of the module, as words with white space between them: names, numbers
// as people write them, and floating-point numbers as '#' and the 16 hexadecimal digits of their
// bits, which are the numbers that they are.
class Request {
  std::string_view rest_;

  static bool is_space(char c) { return c == ' ' || c == '\n'; }

public:
  explicit Request(std::string_view text) : rest_(text) {}

  std::string_view word() {
    while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
    std::size_t n = 0;
    while (n < rest_.size() && !is_space(rest_[n])) ++n;
    if (n == 0) throw GC::Error(GC::Error_code::malformed_input, "an argument is missing");
    const std::string_view result = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return result;
  }

  // Returns the text after the one character behind the last word.
  std::string text() const { return std::string(rest_.substr(rest_.empty() ? 0 : 1)); }

  int count() {
    const std::string_view digits = word();
    int n = -1;
    const std::from_chars_result end = std::from_chars(digits.data(), digits.data() + digits.size(), n);
    if (end.ec != std::errc() || end.ptr != digits.data() + digits.size() || n < 0)
      throw GC::Error(GC::Error_code::malformed_input, '"' + std::string(digits) + "\" is not a count");
    return n;
  }

  double rounded() {
    const std::string_view number = word();
    return number.front() == '#' ? bits(number) : GC::parse_number<double>(number);
  }

  Exact exact() {
    const std::string_view number = word();
    if (number.front() != '#') return GC::parse_number<Exact>(number);
    const double x = bits(number);
    if (!std::isfinite(x)) throw GC::Error(GC::Error_code::not_finite, "a number of the arguments");
    return Exact(x);
  }

  // A number, or "-" for none.
  std::optional<Exact> optional_exact() {
    const Request before = *this;
    if (word() == "-") return std::nullopt;
    *this = before;
    return exact();
  }

  // Dimension, number of points, whether there are weights, both ends of the domain, and for each
  // point its weight and coordinates; or "first" or "last", the name of the argument, and path data
  // with '~' as white space, of which it is a segment.
  Module_curve curve() {
    const Request before = *this;
    const std::string_view which = word();
    if (which == "first" || which == "last") return segment(which == "last");
    *this = before;
    const int dimension = count(), points = count();
    const bool weighted = count() != 0;
    const Exact begin = exact(), end = exact();
    std::vector<Module_traits::Point> b;
    std::vector<Exact> w;
    for (int j = 0; j < points; ++j) {
      w.push_back(weighted ? exact() : Exact(1));
      std::vector<Exact> x;
      for (int i = 0; i < dimension; ++i) x.push_back(exact());
      b.emplace_back(dimension, x.begin(), x.end());
    }
    return Module_curve(b.begin(), b.end(), w.begin(), w.end(), begin, end);
  }

  // The degrees in u and v, and for each point, those of one u together, three coordinates.
  Module_patch patch() {
    const int p = count(), q = count();
    std::vector<Patch_traits::Point> points;
    for (int i = 0; i < (p + 1) * (q + 1); ++i) {
      const Exact x = exact(), y = exact(), z = exact();
      points.emplace_back(x, y, z);
    }
    return Module_patch(p, q, std::move(points));
  }

  GC::Patch_edge edge() {
    const std::string_view name = word();
    for (GC::Patch_edge e : GC::patch_edges)
      if (GC::to_string(e) == name) return e;
    throw GC::Error(GC::Error_code::malformed_input,
                    "an edge of a patch is u0, u1, v0 or v1, not \"" + std::string(name) + '"');
  }

private:
  Module_curve segment(bool is_last); // of path data

  static double bits(std::string_view number) {
    std::uint64_t b = 0;
    const char *const first = number.data() + 1, *const last = number.data() + number.size();
    if (std::from_chars(first, last, b, 16).ptr != last)
      throw GC::Error(GC::Error_code::malformed_input, "\"" + std::string(number) + "\" is not a number");
    double x;
    std::memcpy(&x, &b, sizeof x);
    return x;
  }
};

#endif // GEOMETRIC_CONTINUITY_BROWSER_MODULE_REQUEST_H
