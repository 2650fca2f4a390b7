// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ALIGNMENT_NUMBERS_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ALIGNMENT_NUMBERS_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Enclosure.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/cubic_length.h>
#include <CGAL/Geometric_continuity/numbers/internal/enclosing_arithmetic.h>
#include <CGAL/Geometric_continuity/numbers/internal/oscillating_integral.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// \file alignment_numbers.h
/// How the directions, curvatures and points of alignments are kept, so that each of them can be
/// enclosed in every arithmetic: exact rational data, and what is done with them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The end of a graph v(u) that is given by its arc length.
struct Graph_end {
  Cubic graph;
  Rational length;
};

template <class Number> struct Graph_end_numbers { Number u, v, slope, second; };
template <class Arithmetic>
Graph_end_numbers<typename Arithmetic::Number> graph_end(const Arithmetic& a, const Graph_end& end) {
  typedef typename Arithmetic::Number Number;
  const Number t = parameter_of_length(a, end.graph, end.length);
  const std::array<Number, 4> c = {a(end.graph[0]), a(end.graph[1]), a(end.graph[2]), a(end.graph[3])};
  return {t, c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (c[2] * 2 + t * c[3] * 3), c[2] * 2 + t * c[3] * 6};
}

// The direction angle + atan2(y, x), to which the angle of a graph at its end may be added.
struct Direction {
  Rational angle = 0, x = 1, y = 0;
  std::shared_ptr<const Graph_end> end = nullptr;

  bool is_along_axis() const { return angle == 0 && !end && y == 0 && x > 0; }
  void turn(const Rational& u, const Rational& v) {
    const Rational before = x;
    x = Rational(before * u - y * v);
    y = Rational(y * u + before * v);
  }
};

// A vector with the angle atan2(y, x) of the direction.
template <class Arithmetic>
Complex_number<typename Arithmetic::Number> vector_part(const Arithmetic& a, const Direction& d) {
  typedef Complex_number<typename Arithmetic::Number> Complex;
  const Complex rational{a(d.x), a(d.y)};
  return d.end ? rational * Complex{a(1), graph_end(a, *d.end).slope} : rational;
}

// The unit vector.
template <class Arithmetic>
Complex_number<typename Arithmetic::Number> unit_vector(const Arithmetic& a, const Direction& d) {
  typedef typename Arithmetic::Number Number;
  typedef Complex_number<Number> Complex;
  Complex unit{a(1), a(0)};
  if (d.angle != 0) unit = unit_number(a, a(d.angle));
  if (d.end || d.y != 0) {
    const Complex v = vector_part(a, d);
    const Number length = a.square_root(v.re * v.re + v.im * v.im);
    unit = unit * Complex{v.re / length, v.im / length};
  } else if (d.x < 0)
    unit = {-unit.re, -unit.im};
  return unit;
}

// A rational number, or sign sqrt(square), or the curvature of a graph at its end, times the sign.
struct Curvature {
  int sign = 0;
  Rational square = 0;
  std::optional<Rational> rational = Rational(0);
  std::shared_ptr<const Graph_end> end = nullptr;
};

template <class Arithmetic> typename Arithmetic::Number curvature_number(const Arithmetic& a, const Curvature& k) {
  typedef typename Arithmetic::Number Number;
  if (k.end) {
    const Graph_end_numbers<Number> n = graph_end(a, *k.end);
    const Number speed = a(1) + n.slope * n.slope;
    return k.sign * (n.second / (speed * a.square_root(speed)));
  }
  if (k.rational) return a(*k.rational);
  return k.sign * a.square_root(a(k.square));
}

// The vector (u, v), turned into a direction, times cos(roll).
struct Turned_vector {
  Rational u, v, roll;
  Direction by;
};

// The place to which a curve leads whose angle has a rate, from the start of a direction.
struct Curved_way {
  Rational length;
  Direction from;
  Angle_rate rate;
};

// The point origin + the sum of turned vectors + a way along a curve.
struct Point_sum {
  Rational x = 0, y = 0;
  std::vector<Turned_vector> vectors;
  std::vector<Curved_way> ways;
  std::vector<std::pair<Direction, std::shared_ptr<const Graph_end>>> graphs; // in the frame of a direction

  bool is_rational() const { return vectors.empty() && ways.empty() && graphs.empty(); }

  void add(const Turned_vector& t) {
    if (t.u == 0 && t.v == 0) return;
    if (t.by.angle == 0 && !t.by.end && t.roll == 0) {
      const Direction& d = t.by;
      const std::optional<Rational> length =
          d.y == 0 ? Rational(d.x < 0 ? Rational(-d.x) : d.x) : rational_square_root(Rational(d.x * d.x + d.y * d.y));
      if (length) {
        x = Rational(x + (d.x * t.u - d.y * t.v) / *length);
        y = Rational(y + (d.y * t.u + d.x * t.v) / *length);
        return;
      }
    }
    vectors.push_back(t);
  }

  void add(const Point_sum& p) {
    x = Rational(x + p.x);
    y = Rational(y + p.y);
    vectors.insert(vectors.end(), p.vectors.begin(), p.vectors.end());
    ways.insert(ways.end(), p.ways.begin(), p.ways.end());
    graphs.insert(graphs.end(), p.graphs.begin(), p.graphs.end());
  }

  // Adds the sum of all but the origin, or subtracts it.
  template <class Arithmetic>
  void add_to(const Arithmetic& a, int sign, Complex_number<typename Arithmetic::Number>& sum) const {
    typedef typename Arithmetic::Number Number;
    typedef Complex_number<Number> Complex;
    const auto add = [&](const Complex& z) { sum = sign > 0 ? sum + z : Complex{sum.re - z.re, sum.im - z.im}; };
    for (const Turned_vector& t : vectors) {
      Complex z = Complex{a(t.u), a(t.v)} * unit_vector(a, t.by);
      if (t.roll != 0) {
        const Number cosine = a.cosine_and_sine(a(t.roll)).cosine;
        z = {z.re * cosine, z.im * cosine};
      }
      add(z);
    }
    for (const Curved_way& way : ways) {
      const Complex z = unit_vector(a, way.from) * oscillating_integral(a, way.rate);
      const Number length = a(way.length);
      add({z.re * length, z.im * length});
    }
    for (const auto& graph : graphs) {
      const Graph_end_numbers<Number> n = graph_end(a, *graph.second);
      add(unit_vector(a, graph.first) * Complex{n.u, n.v});
    }
  }
};

// The precisions, in bits, that are tried after intervals of floating-point numbers.
constexpr int ball_precisions[] = {160, 320, 640, 1280};

// Encloses a number, or decides about it: calls f(arithmetic) with intervals, and with integers of
// more and more bits, until it returns true.
template <class F> void with_more_and_more_bits(const char* place, F f) {
  {
    const Protect_FPU_rounding<true> upwards;
    if (f(Interval_arithmetic())) return;
  }
  const Work_guard work(place);
  for (const int bits : ball_precisions)
    if (f(Ball_arithmetic(bits))) return;
}

// Returns whether an enclosure tells nearly as much as floating-point numbers can.
inline bool is_narrow(const Enclosure& x) { return x.upper - x.lower <= 0x1p-41 + 0x1p-49 * std::fabs(x.upper); }

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_ALIGNMENT_NUMBERS_H
