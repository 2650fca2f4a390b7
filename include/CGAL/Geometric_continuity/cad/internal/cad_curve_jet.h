// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_CURVE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_CURVE_JET_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/cad/Cad_geometry.h>
#include <CGAL/Geometric_continuity/cad/internal/Taylor_model.h>
#include <CGAL/Geometric_continuity/numbers/internal/interval_functions.h>
#include <CGAL/Geometric_continuity/splines/internal/Spline_weights.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <variant>
#include <vector>

/// \file cad_curve_jet.h
/// The Taylor coefficients of curves at all parameters of an interval; the polynomial pieces of
/// splines that it touches.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The numbers of a knot vector, checked. \throws Error `not_finite`, `wrong_number_of_points`,
// `knot_multiplicity`
inline void check_knots(const std::vector<double>& knots, int degree, std::size_t points) {
  if (degree < 1 || degree > 60 || points < static_cast<std::size_t>(degree) + 1 ||
      knots.size() != points + static_cast<std::size_t>(degree) + 1)
    throw Error(Error_code::wrong_number_of_points, "a spline of degree " + std::to_string(degree) + " with " +
                                                        std::to_string(points) + " points and " +
                                                        std::to_string(knots.size()) + " knots");
  for (double k : knots)
    if (!std::isfinite(k)) throw Error(Error_code::not_finite, "a knot of a spline");
  if (!std::is_sorted(knots.begin(), knots.end()))
    throw Error(Error_code::knot_multiplicity, "the knots of a spline decrease");
  if (!(knots[degree] < knots[points])) throw Error(Error_code::empty_domain, "the domain of a spline");
}

// The pieces [knots[s], knots[s + 1]] that an interval of parameters touches in more than an end,
// by the numbers s; 0 without knots. The first and the last piece are continued beyond the domain:
// parameters leave it by rounding. A point on a knot touches the pieces on both sides, or the one
// below (`side` < 0) or above (`side` > 0).
inline std::vector<int> intersected_pieces(const Spline_parameter& parameter, const Interval& t, int side) {
  if (!parameter) return {0};
  const std::vector<double>& knots = *parameter.knots;
  const int degree = parameter.degree;
  const int points = static_cast<int>(knots.size()) - degree - 1;
  const double first = parameter.first(), last = parameter.last();
  const double lower = (std::min)((std::max)(t.inf(), first), last),
               upper = (std::max)((std::min)(t.sup(), last), first);
  const auto inner = knots.begin() + degree + 1, end = knots.begin() + points;
  // the span that ends at x or contains it, and the one that starts at x or contains it
  const auto below = [&](double x) { return static_cast<int>(std::lower_bound(inner, end, x) - knots.begin()) - 1; };
  const auto above = [&](double x) { return static_cast<int>(std::upper_bound(inner, end, x) - knots.begin()) - 1; };
  int from = above(lower), to = below(upper);
  if (lower == upper) {
    from = side > 0 ? above(lower) : below(lower);
    to = side < 0 ? below(lower) : above(lower);
  }
  while (from > degree && !(knots[from] < knots[from + 1])) --from; // at the end of the domain
  // equivalent [< -> <=, 2]: the last piece before the end of the domain is not empty
  while (to < points - 1 && !(knots[to] < knots[to + 1])) ++to;
  std::vector<int> spans;
  for (int s = from; s <= (std::max)(from, to); ++s)
    if (knots[s] < knots[s + 1]) spans.push_back(s);
  return spans;
}

// The Taylor coefficients of the degree+1 basis functions that do not vanish on a piece, about a
// point m and up to a power: the function of the number s - degree + a is the sum of coefficient(a,
// i) d^i at m + d.
class Basis_polynomials {
  struct Interval_knots {
    const std::vector<double>& u;
    Interval operator[](int i) const { return u[static_cast<std::size_t>(i)]; }
  };
  int n_;
  std::vector<Interval> c_;

public:
  Basis_polynomials(const std::vector<double>& knots, int degree, int span, const Interval& m, int powers)
      : n_(degree + 1), c_(static_cast<std::size_t>(n_) * (powers + 1), Interval(0)) {
    derivative_weights(Interval_knots{knots}, degree, span, m, powers, [&](int i, const Span_weights<Interval>& of) {
      Interval factorial = 1;
      for (int k = 2; k <= i; ++k) factorial *= k;
      for (int a = 0; a <= degree; ++a) c_[static_cast<std::size_t>(i) * n_ + a] = of.w[a] / factorial;
    });
  }

  const Interval& operator()(int a, int i) const { return c_[static_cast<std::size_t>(i) * n_ + a]; }
};

// Replaces the coefficients x(0), ..., x(degree) about a point by those about all points at the
// distances in d.
template <class Coefficient> void move_centre(int degree, const Interval& d, Coefficient x) {
  for (int i = 0; i < degree; ++i)
    for (int k = degree - 1; k >= i; --k) x(k) += d * x(k + 1);
}

inline double middle(const Interval& t) {
  const double m = t.inf() / 2 + t.sup() / 2;
  return (std::min)((std::max)(m, t.inf()), t.sup());
}

// Bases of offsets need this order; others need one less.
constexpr int highest_order = Taylor_model::size + 3;

// Numbers that start as 0, which those of CGAL do not.
template <int D> struct Interval_vector : std::array<Interval, D> {
  Interval_vector() { this->fill(Interval(0)); }
};

// Encloses the derivatives c^(k)(t) / k!, k <= order, at all t of an interval, of one piece of the
// curve, which is continued beyond its ends.
template <int D> struct Cad_curve_jet { std::array<Interval_vector<D>, highest_order + 1> c; };

template <int D> Cad_curve_jet<D> cad_curve_jet(const Cad_curve<D>& curve, const Interval& t, int order, int span);

template <int D> std::vector<int> intersected_pieces(const Cad_curve<D>& curve, const Interval& t, int side) {
  return intersected_pieces(spline_parameter(curve), t, side);
}

// cos^(k)(t) / k! and sin^(k)(t) / k!.
inline std::array<Cosine_and_sine, highest_order + 1> circle_jet(const Interval& t) {
  std::array<Cosine_and_sine, highest_order + 1> jet;
  jet[0] = cosine_and_sine(t);
  for (int k = 1; k <= highest_order; ++k) jet[k] = {-jet[k - 1].sine / k, jet[k - 1].cosine / k};
  return jet;
}

template <int D> Cad_curve_jet<D> jet_of(const Cad_line<D>& line, const Interval& t, int, int) {
  Cad_curve_jet<D> jet;
  for (int i = 0; i < D; ++i) {
    jet.c[0][i] = Interval(line.origin[i]) + t * Interval(line.direction[i]);
    jet.c[1][i] = line.direction[i];
  }
  return jet;
}

template <int D> Cad_curve_jet<D> jet_of(const Cad_conic<D>& conic, const Interval& t, int order, int) {
  typedef typename Cad_conic<D>::Kind Kind;
  Interval_vector<highest_order + 1> x, y; // coefficients of the axes
  if (conic.kind == Kind::ellipse) {
    const auto circle = circle_jet(t);
    for (int k = 0; k <= order; ++k) {
      x[k] = Interval(conic.a) * circle[k].cosine;
      y[k] = Interval(conic.b) * circle[k].sine;
    }
  } else if (conic.kind == Kind::hyperbola) {
    const Interval e = exponential(t), f = 1 / e;
    Interval even = (e + f) / 2, odd = (e - f) / 2; // cosh and sinh, divided by k!
    for (int k = 0; k <= order; ++k) {
      if (k > 0) even /= k, odd /= k;
      x[k] = Interval(conic.a) * (k % 2 ? odd : even);
      y[k] = Interval(conic.b) * (k % 2 ? even : odd);
    }
  } else {
    const Interval a = 4 * Interval(conic.a);
    x[0] = square(t) / a;
    x[1] = 2 * t / a;
    x[2] = 1 / a;
    y[0] = t;
    y[1] = 1;
  }
  Cad_curve_jet<D> jet;
  for (int k = 0; k <= order; ++k)
    for (int i = 0; i < D; ++i)
      jet.c[k][i] = (k == 0 ? Interval(conic.centre[i]) : Interval(0)) + x[k] * Interval(conic.x_axis[i]) +
                    y[k] * Interval(conic.y_axis[i]);
  return jet;
}

// The polynomials of the points, relative to one of them so that what is constant stays exact, and
// of the weights, about the middle, moved to all of the interval; the series of a quotient.
template <int D> Cad_curve_jet<D> jet_of(const Cad_spline_curve<D>& spline, const Interval& t, int order, int span) {
  const int n = spline.degree;
  const bool rational = !spline.weights.empty();
  const double m = middle(t);
  const int powers = t.is_point() ? (std::min)(n, order) : n; // all to move them
  const Basis_polynomials basis(spline.knots, n, span, m, powers);
  const Cad_point<D>& origin = spline.points[span];
  std::vector<Interval_vector<D + 1>> h((std::max)(n, order) + 1);
  for (int a = 0; a <= n; ++a) {
    Interval_vector<D + 1> point;
    point[D] = rational ? spline.weights[span - n + a] : 1;
    for (int i = 0; i < D; ++i) point[i] = (Interval(spline.points[span - n + a][i]) - Interval(origin[i])) * point[D];
    for (int k = 0; k <= powers; ++k)
      for (int i = 0; i < D + rational; ++i) h[k][i] += basis(a, k) * point[i];
  }
  for (int i = 0; i < D + rational && !t.is_point(); ++i)
    move_centre(n, t - Interval(m), [&](int k) -> Interval& { return h[k][i]; });
  if (rational)
    for (int k = 0; k <= order; ++k)
      for (int i = 0; i < D; ++i) {
        for (int j = 1; j <= k; ++j) h[k][i] -= h[j][D] * h[k - j][i];
        h[k][i] /= h[0][D];
      }
  Cad_curve_jet<D> jet;
  for (int k = 0; k <= order; ++k)
    for (int i = 0; i < D; ++i) jet.c[k][i] = k == 0 ? h[k][i] + Interval(origin[i]) : h[k][i];
  return jet;
}

// The series of c + d q / |q| with q = (c'_y, -c'_x) or c' x r.
template <int D> Cad_curve_jet<D> jet_of(const Cad_offset_curve<D>& offset, const Interval& t, int order, int span) {
  Cad_curve_jet<D> jet = cad_curve_jet(*offset.basis, t, (std::min)(order + 1, highest_order), span);
  std::array<Interval_vector<D>, highest_order + 1> q;
  Interval_vector<highest_order + 1> f; // |q|
  if (order + 1 > highest_order) throw Error(Error_code::jet_order_too_low, "an offset of an offset curve");
  for (int k = 0; k <= order; ++k) {
    Interval_vector<D> d;
    for (int i = 0; i < D; ++i) d[i] = (k + 1) * jet.c[k + 1][i];
    if constexpr (D == 2) {
      q[k][0] = d[1];
      q[k][1] = -d[0];
    } else {
      const Cad_point<3>& r = offset.reference;
      for (int i = 0; i < 3; ++i)
        q[k][i] = d[(i + 1) % 3] * Interval(r[(i + 2) % 3]) - d[(i + 2) % 3] * Interval(r[(i + 1) % 3]);
    }
  }
  for (int k = 0; k <= order; ++k) { // f^2 = q . q
    Interval sum = 0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j <= k; ++j) sum += j == k - j ? square(q[j][i]) : q[j][i] * q[k - j][i];
    if (k == 0) {
      f[0] = CGAL::sqrt(sum);
      if (!(f[0].inf() > 0)) f[0] = Interval(0, f[0].sup()); // then quotients are unbounded
    } else {
      for (int j = 1; j < k; ++j) sum -= f[j] * f[k - j];
      f[k] = sum / (2 * f[0]);
    }
  }
  for (int k = 0; k <= order; ++k)
    for (int i = 0; i < D; ++i) {
      for (int j = 1; j <= k; ++j) q[k][i] -= f[j] * q[k - j][i];
      q[k][i] /= f[0];
      jet.c[k][i] += Interval(offset.distance) * q[k][i];
    }
  return jet;
}

template <int D> Cad_curve_jet<D> cad_curve_jet(const Cad_curve<D>& curve, const Interval& t, int order, int span) {
  return std::visit([&](const auto& c) { return jet_of(c, t, order, span); }, curve);
}
// Returns the jet on the first piece that the interval touches.
template <int D> Cad_curve_jet<D> cad_curve_jet(const Cad_curve<D>& curve, const Interval& t, int order) {
  return cad_curve_jet(curve, t, order, intersected_pieces(curve, t, 1).front());
}

inline void check_finite(std::initializer_list<double> numbers, const char* place) {
  for (double x : numbers)
    if (!std::isfinite(x)) throw Error(Error_code::not_finite, place);
}
template <int D> void check_finite(const Cad_point<D>& p, const char* place) {
  for (double x : p) check_finite({x}, place);
}
inline void check_weights(const std::vector<double>& weights, std::size_t points) {
  if (!weights.empty() && weights.size() != points)
    throw Error(Error_code::wrong_number_of_points, "the weights of a spline");
  for (double w : weights) {
    check_finite({w}, "a weight of a spline");
    if (!(w > 0)) throw Error(Error_code::zero_weight, "a weight of a spline is not positive");
  }
}

// \throws Error when the numbers of a curve do not fit or are not finite
template <int D> struct Check_cad_curve {
  void operator()(const Cad_line<D>& c) const {
    check_finite<D>(c.origin, "a line");
    check_finite<D>(c.direction, "a line");
  }
  void operator()(const Cad_conic<D>& c) const {
    for (const Cad_point<D>* p : {&c.centre, &c.x_axis, &c.y_axis}) check_finite<D>(*p, "a conic");
    check_finite({c.a, c.b}, "a conic");
    if (c.kind == Cad_conic<D>::Kind::parabola && c.a == 0)
      throw Error(Error_code::zero_direction, "the focal length of a parabola");
  }
  void operator()(const Cad_spline_curve<D>& c) const {
    check_knots(c.knots, c.degree, c.points.size());
    check_weights(c.weights, c.points.size());
    for (const Cad_point<D>& p : c.points) check_finite<D>(p, "a point of a spline");
  }
  void operator()(const Cad_offset_curve<D>& c) const {
    check_finite({c.distance}, "an offset curve");
    check_finite<D>(c.reference, "an offset curve");
    std::visit(*this, *c.basis);
  }
};

// \throws Error `not_finite`, `empty_domain` when the ends of the range of an edge are not two
//   numbers in order
inline void check_range(double first, double last, const char* place) {
  check_finite({first, last}, place);
  if (!(first <= last)) throw Error(Error_code::empty_domain, place);
}

// A domain of parameters. \throws Error `parameter_outside_domain` for a number that lies outside
// by more than rounding
struct Cad_domain {
  double first = -(std::numeric_limits<double>::infinity)(), last = -first;

  void check(double t, const char* place) const {
    const double margin = (last - first) * 1e-4;
    if (t < first - margin || last + margin < t)
      throw Error(Error_code::parameter_outside_domain, std::string(place) + ": " + std::to_string(t) + " in [" +
                                                            std::to_string(first) + ", " + std::to_string(last) + ']');
  }
};
inline Cad_domain cad_domain(const Spline_parameter& parameter) {
  return parameter ? Cad_domain{parameter.first(), parameter.last()} : Cad_domain();
}
template <int D> Cad_domain cad_domain(const Cad_curve<D>& curve) { return cad_domain(spline_parameter(curve)); }

// Returns the inner knots, each once.
inline std::vector<double> inner_knots(const Spline_parameter& parameter) {
  std::vector<double> knots;
  parameter.for_each_inner_knot([&](double knot, int) { knots.push_back(knot); });
  return knots;
}
template <int D> std::vector<double> inner_knots(const Cad_curve<D>& curve) {
  return inner_knots(spline_parameter(curve));
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_CURVE_JET_H
