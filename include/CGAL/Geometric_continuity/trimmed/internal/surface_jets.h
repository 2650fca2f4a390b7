// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_TRIMMED_INTERNAL_SURFACE_JETS_H
#define CGAL_GEOMETRIC_CONTINUITY_TRIMMED_INTERNAL_SURFACE_JETS_H

#include <CGAL/Geometric_continuity/trimmed/internal/Given_surface_jet.h>

#include <algorithm>
#include <variant>
#include <vector>

/// \file surface_jets.h
/// The Taylor coefficients of spline and offset surfaces, and of each surface; the knots of a surface.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

inline Given_surface_jet given_surface_jet(const Given_surface& surface, const Parameter_box& box, int order);

// The coefficients on one piece, times the denominator if rational, relative to one of its points.
class Spline_piece_polynomial {
  int p_, q_;
  std::vector<Interval> c_; // by coordinate, then i, then j

public:
  Interval& operator()(int k, int i, int j) { return c_[(k * (p_ + 1) + i) * (q_ + 1) + j]; }

  Spline_piece_polynomial(const Given_spline_surface& s, const Parameter_box& box) : p_(s.u_degree), q_(s.v_degree) {
    const int coordinates = s.weights.empty() ? 3 : 4, v_points = s.v_points();
    c_.assign(static_cast<std::size_t>(coordinates) * (p_ + 1) * (q_ + 1), Interval(0));
    const Interval &u = box.u, &v = box.v;
    const int u_span = box.u_span, v_span = box.v_span;
    const Basis_polynomials in_u(s.u_knots, p_, u_span, middle(u)), in_v(s.v_knots, q_, v_span, middle(v));
    const Given_point<3>& origin = s.points[u_span * v_points + v_span];
    std::vector<Interval> row(q_ + 1);
    for (int a = 0; a <= p_; ++a)
      for (int k = 0; k < coordinates; ++k) {
        std::fill(row.begin(), row.end(), Interval(0));
        for (int b = 0; b <= q_; ++b) {
          const int index = (u_span - p_ + a) * v_points + v_span - q_ + b;
          Interval x = k == 3 ? Interval(s.weights[index]) : Interval(s.points[index][k]) - Interval(origin[k]);
          if (k < 3 && coordinates == 4) x *= Interval(s.weights[index]);
          if (is_exact_zero(x)) continue;
          for (int j = 0; j <= q_; ++j) row[j] += x * in_v(b, j);
        }
        for (int i = 0; i <= p_; ++i)
          for (int j = 0; j <= q_; ++j) (*this)(k, i, j) += in_u(a, i) * row[j];
      }
    for (int k = 0; k < coordinates; ++k) {
      for (int j = 0; j <= q_ && !u.is_point(); ++j)
        move_centre(p_, u - Interval(middle(u)), [&](int i) -> Interval& { return (*this)(k, i, j); });
      for (int i = 0; i <= p_ && !v.is_point(); ++i)
        move_centre(q_, v - Interval(middle(v)), [&](int j) -> Interval& { return (*this)(k, i, j); });
    }
  }
};

inline Given_surface_jet jet_of(const Given_spline_surface& surface, const Parameter_box& box, int order) {
  const int p = surface.u_degree, q = surface.v_degree;
  const bool rational = !surface.weights.empty();
  Given_surface_jet jet;
  if (!rational) {
    jet.u_degree = (std::min)(p, highest_order);
    jet.v_degree = (std::min)(q, highest_order);
  }
  Spline_piece_polynomial h(surface, box);
  const Given_point<3>& origin = surface.points[box.u_span * surface.v_points() + box.v_span];
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i <= order && i <= jet.u_degree; ++i)
      for (int j = 0; i + j <= order && j <= jet.v_degree; ++j) {
        Interval x = i <= p && j <= q ? h(k, i, j) : Interval(0);
        if (rational) { // the series of a quotient
          for (int a = 0; a <= (std::min)(i, p); ++a)
            for (int b = a == 0 ? 1 : 0; b <= (std::min)(j, q); ++b) x -= h(3, a, b) * jet.s(i - a, j - b)[k];
          x /= h(3, 0, 0);
        }
        jet.s(i, j)[k] = x;
      }
    jet.s(0, 0)[k] += Interval(origin[k]);
  }
  return jet;
}

// The product of two series.
inline Interval product_coefficient(const Triangle<Interval>& x, const Triangle<Interval>& y, int i, int j) {
  Interval sum = 0;
  for (int a = 0; a <= i; ++a)
    for (int b = 0; b <= j; ++b)
      sum += a == i - a && b == j - b && &x == &y ? square(x(a, b)) : x(a, b) * y(i - a, j - b);
  return sum;
}

// The series of S + d N / |N|: f with f^2 = N . N, and the quotients by f.
inline Given_surface_jet jet_of(const Given_offset_surface& offset, const Parameter_box& box, int order) {
  if (order + 1 > highest_order) throw Error(Error_code::jet_order_too_low, "an offset of an offset surface");
  Given_surface_jet jet = given_surface_jet(*offset.basis, box, order + 1);
  std::array<Triangle<Interval>, 3> su, sv, n;
  Triangle<Interval> f;
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j)
      for (int k = 0; k < 3; ++k) {
        su[k](i, j) = (i + 1) * jet.s(i + 1, j)[k];
        sv[k](i, j) = (j + 1) * jet.s(i, j + 1)[k];
      }
  for (int sum = 0; sum <= order; ++sum)
    for (int j = 0; j <= sum; ++j) {
      const int i = sum - j;
      for (int k = 0; k < 3; ++k)
        n[k](i, j) = product_coefficient(su[(k + 1) % 3], sv[(k + 2) % 3], i, j) -
                     product_coefficient(su[(k + 2) % 3], sv[(k + 1) % 3], i, j);
      Interval square = 0;
      for (int k = 0; k < 3; ++k) square += product_coefficient(n[k], n[k], i, j);
      if (sum == 0) {
        f(0, 0) = CGAL::sqrt(square);
        continue;
      }
      for (int a = 0; a <= i; ++a)
        for (int b = 0; b <= j; ++b)
          if (0 < a + b && a + b < sum) square -= f(a, b) * f(i - a, j - b);
      f(i, j) = square / (2 * f(0, 0));
    }
  for (int k = 0; k < 3; ++k)
    for (int sum = 0; sum <= order; ++sum)
      for (int j = 0; j <= sum; ++j) {
        const int i = sum - j;
        Interval& x = n[k](i, j); // becomes the coefficient of N / |N|
        for (int a = 0; a <= i; ++a)
          for (int b = 0; b <= j; ++b)
            if (0 < a + b) x -= f(a, b) * n[k](i - a, j - b);
        x /= f(0, 0);
        jet.s(i, j)[k] += Interval(offset.distance) * x;
      }
  jet.u_degree = jet.v_degree = highest_order;
  return jet;
}

inline Given_surface_jet given_surface_jet(const Given_surface& surface, const Parameter_box& box, int order) {
  return std::visit([&](const auto& s) { return jet_of(s, box, order); }, surface);
}

// The pieces of a surface that ranges of parameters touch, by their spans in u and v; sides of knots as for curves.
inline std::array<std::vector<int>, 2> touched_pieces(const Given_surface& surface, const Interval& u,
                                                      const Interval& v, int u_side, int v_side) {
  std::array<std::vector<int>, 2> spans{{{0}, {0}}};
  if (const auto* offset = std::get_if<Given_offset_surface>(&surface))
    return touched_pieces(*offset->basis, u, v, u_side, v_side);
  if (const auto* s = std::get_if<Given_spline_surface>(&surface)) {
    spans[0] = touched_pieces(s->u_knots, s->u_degree, u, u_side);
    spans[1] = touched_pieces(s->v_knots, s->v_degree, v, v_side);
  }
  if (const auto* extrusion = std::get_if<Given_extrusion>(&surface))
    spans[0] = touched_pieces(extrusion->profile, u, u_side);
  if (const auto* revolution = std::get_if<Given_revolution>(&surface))
    spans[1] = touched_pieces(revolution->profile, v, v_side);
  return spans;
}

// \throws Error when the numbers of a surface do not fit or are not finite
struct Check_given_surface {
  void operator()(const Given_elementary_surface& s) const {
    for (const Given_point<3>* p : {&s.frame.origin, &s.frame.x_axis, &s.frame.y_axis, &s.frame.z_axis})
      check_finite<3>(*p, "an elementary surface");
    check_finite({s.radius, s.other}, "an elementary surface");
  }
  void operator()(const Given_spline_surface& s) const {
    const std::size_t rows = s.u_knots.size() - (std::min)(s.u_knots.size(), std::size_t(s.u_degree + 1)),
                      columns = s.v_knots.size() - (std::min)(s.v_knots.size(), std::size_t(s.v_degree + 1));
    check_knots(s.u_knots, s.u_degree, rows);
    check_knots(s.v_knots, s.v_degree, columns);
    if (s.points.size() != rows * columns)
      throw Error(Error_code::wrong_number_of_points, "the points of a spline surface");
    check_weights(s.weights, s.points.size());
    for (const Given_point<3>& p : s.points) check_finite<3>(p, "a point of a spline surface");
  }
  void operator()(const Given_extrusion& s) const {
    check_finite<3>(s.direction, "an extrusion");
    std::visit(Check_given_curve<3>(), s.profile);
  }
  void operator()(const Given_revolution& s) const {
    check_finite<3>(s.origin, "a surface of revolution");
    check_finite<3>(s.direction, "a surface of revolution");
    std::visit(Check_given_curve<3>(), s.profile);
  }
  void operator()(const Given_offset_surface& s) const {
    check_finite({s.distance}, "an offset surface");
    std::visit(*this, *s.basis);
  }
};

// The domain of a surface in u and v.
inline std::array<Given_domain, 2> given_domain(const Given_surface& surface) {
  if (const auto* offset = std::get_if<Given_offset_surface>(&surface)) return given_domain(*offset->basis);
  std::array<Given_domain, 2> domain;
  if (const auto* extrusion = std::get_if<Given_extrusion>(&surface)) domain[0] = given_domain(extrusion->profile);
  if (const auto* revolution = std::get_if<Given_revolution>(&surface)) domain[1] = given_domain(revolution->profile);
  if (const auto* s = std::get_if<Given_spline_surface>(&surface))
    domain = {Given_domain{s->u_knots[s->u_degree], s->u_knots[s->u_knots.size() - s->u_degree - 1]},
              Given_domain{s->v_knots[s->v_degree], s->v_knots[s->v_knots.size() - s->v_degree - 1]}};
  return domain;
}

// The inner knots of a surface in u and v.
inline std::array<std::vector<double>, 2> inner_knots(const Given_surface& surface) {
  if (const auto* offset = std::get_if<Given_offset_surface>(&surface)) return inner_knots(*offset->basis);
  std::array<std::vector<double>, 2> knots;
  if (const auto* extrusion = std::get_if<Given_extrusion>(&surface)) knots[0] = inner_knots(extrusion->profile);
  if (const auto* revolution = std::get_if<Given_revolution>(&surface)) knots[1] = inner_knots(revolution->profile);
  if (const auto* s = std::get_if<Given_spline_surface>(&surface)) {
    knots[0].assign(s->u_knots.begin() + s->u_degree + 1, s->u_knots.end() - s->u_degree - 1);
    knots[1].assign(s->v_knots.begin() + s->v_degree + 1, s->v_knots.end() - s->v_degree - 1);
    for (std::vector<double>& k : knots) k.erase(std::unique(k.begin(), k.end()), k.end());
  }
  return knots;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_TRIMMED_INTERNAL_SURFACE_JETS_H
