// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_SURFACE_JET_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_SURFACE_JET_H

#include <CGAL/Geometric_continuity/cad/internal/cad_curve_jet.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>
#include <vector>

/// \file Cad_surface_jet.h
/// The Taylor coefficients of surfaces at all parameters of a rectangle; the pieces and the knots
/// of a surface.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// A rectangle of parameters, and a piece of a surface by the numbers of its spans in u and v.
struct Parameter_box {
  Interval u, v;
  int u_span, v_span;
};

// Numbers with two indices of a sum that is not too large.
template <class Number> class Triangle {
  std::array<Number, (highest_order + 1) * (highest_order + 2) / 2> x_;

public:
  Triangle() {
    if constexpr (std::is_same_v<Number, Interval>) x_.fill(Interval(0)); // vectors start as 0
  }
  Number& operator()(int i, int j) { return x_[(i + j) * (i + j + 1) / 2 + j]; }
  const Number& operator()(int i, int j) const { return x_[(i + j) * (i + j + 1) / 2 + j]; }
};

// Which derivatives are wanted: i times by u and j times by v, i + j at most `sum`.
struct Surface_orders {
  int u, v, sum;

  Surface_orders(int order_u, int order_v, int total) : u(order_u), v(order_v), sum(total) {}
  Surface_orders(int total) : Surface_orders(total, total, total) {}
  bool contains(int i, int j) const { return i <= u && j <= v && i + j <= sum; }
};

// Encloses the derivatives of S by u and v, i and j times, divided by i! j!, at all parameters of a
// box, of one piece of the surface, which is continued beyond its ends.
struct Cad_surface_jet {
  Triangle<Interval_vector<3>> s;
  int u_degree = highest_order, v_degree = highest_order; // those of higher numbers are zero

  // Adds a multiple of a vector.
  void add(int i, int j, const Interval& factor, const Cad_point<3>& v) {
    for (int k = 0; k < 3; ++k) s(i, j)[k] += factor * Interval(v[k]);
  }
};

inline Cad_surface_jet jet_of(const Cad_elementary_surface& surface, const Parameter_box& box,
                              const Surface_orders& order) {
  typedef Cad_elementary_surface::Kind Kind;
  const Cad_frame& f = surface.frame;
  const Interval r = surface.radius, q = surface.other;
  Cad_surface_jet jet;
  jet.add(0, 0, Interval(1), f.origin);
  if (surface.kind == Kind::plane) {
    jet.u_degree = jet.v_degree = 1;
    jet.add(0, 0, box.u, f.x_axis);
    jet.add(0, 0, box.v, f.y_axis);
    jet.add(1, 0, Interval(1), f.x_axis);
    jet.add(0, 1, Interval(1), f.y_axis);
    return jet;
  }
  // rho(v) R(u) + z(v) times the axis, by the coefficients of rho and z
  Interval_vector<highest_order + 1> rho, z;
  if (surface.kind == Kind::cylinder || surface.kind == Kind::cone) {
    // equivalent [1 -> 2, 1]: a bound of the degree: the coefficients beyond it are zero
    jet.v_degree = 1;
    Cosine_and_sine angle{Interval(1), Interval(0)};
    if (surface.kind == Kind::cone) angle = cosine_and_sine(q);
    rho[0] = r + box.v * angle.sine;
    rho[1] = angle.sine;
    z[0] = box.v * angle.cosine;
    z[1] = angle.cosine;
  } else {
    const auto v = circle_jet(box.v);
    const Interval& radius = surface.kind == Kind::sphere ? r : q;
    for (int j = 0; j <= order.v; ++j) {
      rho[j] = radius * v[j].cosine;
      z[j] = radius * v[j].sine;
    }
    if (surface.kind == Kind::torus) rho[0] += r;
  }
  const auto u = circle_jet(box.u);
  for (int i = 0; i <= order.u; ++i)
    for (int j = 0; order.contains(i, j) && j <= jet.v_degree; ++j) {
      jet.add(i, j, rho[j] * u[i].cosine, f.x_axis);
      jet.add(i, j, rho[j] * u[i].sine, f.y_axis);
      if (i == 0) jet.add(0, j, z[j], f.z_axis);
    }
  return jet;
}

inline Cad_surface_jet jet_of(const Cad_extrusion& surface, const Parameter_box& box, const Surface_orders& order) {
  const Cad_curve_jet<3> c = cad_curve_jet(surface.profile, box.u, order.u, box.u_span);
  Cad_surface_jet jet;
  jet.v_degree = 1;
  for (int i = 0; i <= order.u; ++i) jet.s(i, 0) = c.c[i];
  jet.add(0, 0, box.v, surface.direction);
  jet.add(0, 1, Interval(1), surface.direction);
  return jet;
}

inline Cad_surface_jet jet_of(const Cad_revolution& surface, const Parameter_box& box, const Surface_orders& order) {
  const Cad_curve_jet<3> c = cad_curve_jet(surface.profile, box.v, order.v, box.v_span);
  const auto u = circle_jet(box.u);
  const Cad_point<3>& d = surface.direction;
  Cad_surface_jet jet;
  for (int j = 0; j <= order.v; ++j) {
    Interval_vector<3> w = c.c[j], along, across;
    if (j == 0)
      for (int k = 0; k < 3; ++k) w[k] -= Interval(surface.origin[k]);
    const Interval height = w[0] * Interval(d[0]) + w[1] * Interval(d[1]) + w[2] * Interval(d[2]);
    for (int k = 0; k < 3; ++k) {
      along[k] = height * Interval(d[k]);
      across[k] = Interval(d[(k + 1) % 3]) * w[(k + 2) % 3] - Interval(d[(k + 2) % 3]) * w[(k + 1) % 3];
    }
    for (int i = 0; order.contains(i, j); ++i)
      for (int k = 0; k < 3; ++k)
        jet.s(i, j)[k] = u[i].cosine * (w[k] - along[k]) + u[i].sine * across[k] + (i == 0 ? along[k] : Interval(0));
    if (j == 0)
      for (int k = 0; k < 3; ++k) jet.s(0, 0)[k] += Interval(surface.origin[k]);
  }
  return jet;
}

inline Cad_surface_jet cad_surface_jet(const Cad_surface& surface, const Parameter_box& box,
                                       const Surface_orders& order);

// The coefficients on one piece about a point, times the denominator if rational, relative to one
// of its control points.
class Spline_piece_polynomial {
  int p_, q_; // the highest powers that are kept
  int coordinates_;
  std::array<int, 2> degree_;
  const Cad_point<3>& origin_;
  std::vector<Interval> c_; // by coordinate, then i, then j

  Interval& operator()(int k, int i, int j) { return c_[(k * (p_ + 1) + i) * (q_ + 1) + j]; }
  const Interval& operator()(int k, int i, int j) const { return c_[(k * (p_ + 1) + i) * (q_ + 1) + j]; }

public:
  // All coefficients up to the powers that are asked for.
  Spline_piece_polynomial(const Cad_spline_surface& s, int u_span, int v_span, double u, double v, int u_powers,
                          int v_powers)
      : p_((std::min)(s.u_degree, u_powers)), q_((std::min)(s.v_degree, v_powers)),
        coordinates_(s.weights.empty() ? 3 : 4), degree_{s.u_degree, s.v_degree},
        origin_(s.points[u_span * s.v_points() + v_span]),
        c_(static_cast<std::size_t>(coordinates_) * (p_ + 1) * (q_ + 1), Interval(0)) {
    const int v_points = s.v_points();
    const Basis_polynomials in_u(s.u_knots, s.u_degree, u_span, u, p_), in_v(s.v_knots, s.v_degree, v_span, v, q_);
    std::vector<Interval> row((std::max)(p_, q_) + 1);
    const auto coordinate = [&](int k, int a, int b) {
      const int index = (u_span - s.u_degree + a) * v_points + v_span - s.v_degree + b;
      Interval x = k == 3 ? Interval(s.weights[index]) : Interval(s.points[index][k]) - Interval(origin_[k]);
      if (k < 3 && coordinates_ == 4) x *= Interval(s.weights[index]);
      return x;
    };
    // The sum over the control points in the direction of which fewer powers are kept comes first.
    const bool u_first = p_ < q_;
    const int outer = u_first ? s.v_degree : s.u_degree, inner = u_first ? s.u_degree : s.v_degree;
    const int inner_powers = u_first ? p_ : q_, outer_powers = u_first ? q_ : p_;
    const Basis_polynomials &of_inner = u_first ? in_u : in_v, &of_outer = u_first ? in_v : in_u;
    for (int k = 0; k < coordinates_; ++k)
      for (int a = 0; a <= outer; ++a) {
        std::fill(row.begin(), row.end(), Interval(0));
        for (int b = 0; b <= inner; ++b) {
          const Interval x = u_first ? coordinate(k, b, a) : coordinate(k, a, b);
          if (is_exact_zero(x)) continue;
          for (int j = 0; j <= inner_powers; ++j) row[j] += x * of_inner(b, j);
        }
        for (int i = 0; i <= outer_powers; ++i)
          for (int j = 0; j <= inner_powers; ++j)
            (u_first ? (*this)(k, j, i) : (*this)(k, i, j)) += of_outer(a, i) * row[j];
      }
  }

  // Takes the coefficients about all points at the distances in du and dv. \pre of directions in
  // which one is not zero all powers are kept
  const Spline_piece_polynomial& move(const Interval& du, const Interval& dv) {
    for (int k = 0; k < coordinates_; ++k) {
      for (int j = 0; j <= q_ && !is_exact_zero(du); ++j)
        move_centre(p_, du, [&](int i) -> Interval& { return (*this)(k, i, j); });
      for (int i = 0; i <= p_ && !is_exact_zero(dv); ++i)
        move_centre(q_, dv, [&](int j) -> Interval& { return (*this)(k, i, j); });
    }
    return *this;
  }

  // \pre all powers are kept that the order asks for
  Cad_surface_jet jet(const Surface_orders& order) const {
    const bool rational = coordinates_ == 4;
    Cad_surface_jet jet;
    if (!rational) {
      jet.u_degree = (std::min)(degree_[0], highest_order);
      jet.v_degree = (std::min)(degree_[1], highest_order);
    }
    for (int i = 0; i <= order.u && i <= jet.u_degree; ++i)
      for (int j = 0; order.contains(i, j) && j <= jet.v_degree; ++j) {
        Interval_vector<3>& x = jet.s(i, j);
        for (int k = 0; k < 3 && i <= p_ && j <= q_; ++k) x[k] = (*this)(k, i, j);
        if (!rational) continue;
        for (int a = 0; a <= (std::min)(i, p_); ++a) // the series of a quotient
          for (int b = a == 0 ? 1 : 0; b <= (std::min)(j, q_); ++b) {
            const Interval& weight = (*this)(3, a, b);
            const Interval_vector<3>& y = jet.s(i - a, j - b);
            for (int k = 0; k < 3; ++k) x[k] -= weight * y[k];
          }
        for (int k = 0; k < 3; ++k) x[k] /= (*this)(3, 0, 0);
      }
    for (int k = 0; k < 3; ++k) jet.s(0, 0)[k] += Interval(origin_[k]);
    return jet;
  }
};

// Returns the polynomial about a point, with the powers that are needed to move it, and for the
// derivatives that are wanted.
inline Spline_piece_polynomial spline_polynomial(const Cad_spline_surface& s, const Parameter_box& box, double u,
                                                 double v, const Interval& du, const Interval& dv,
                                                 const Surface_orders& order) {
  return Spline_piece_polynomial(s, box.u_span, box.v_span, u, v, is_exact_zero(du) ? order.u : s.u_degree,
                                 is_exact_zero(dv) ? order.v : s.v_degree);
}

inline Cad_surface_jet jet_of(const Cad_spline_surface& surface, const Parameter_box& box,
                              const Surface_orders& order) {
  const double u = middle(box.u), v = middle(box.v);
  const Interval du = box.u - Interval(u), dv = box.v - Interval(v);
  Spline_piece_polynomial polynomial = spline_polynomial(surface, box, u, v, du, dv, order);
  return polynomial.move(du, dv).jet(order);
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
inline Cad_surface_jet jet_of(const Cad_offset_surface& offset, const Parameter_box& box, const Surface_orders& order) {
  if (order.sum + 1 > highest_order) throw Error(Error_code::jet_order_too_low, "an offset of an offset surface");
  Cad_surface_jet jet = cad_surface_jet(*offset.basis, box, {order.u + 1, order.v + 1, order.sum + 1});
  std::array<Triangle<Interval>, 3> su, sv, n;
  Triangle<Interval> f;
  for (int i = 0; i <= order.u; ++i)
    for (int j = 0; order.contains(i, j); ++j)
      for (int k = 0; k < 3; ++k) {
        su[k](i, j) = (i + 1) * jet.s(i + 1, j)[k];
        sv[k](i, j) = (j + 1) * jet.s(i, j + 1)[k];
      }
  for (int sum = 0; sum <= order.sum; ++sum)
    for (int j = 0; j <= sum; ++j) {
      const int i = sum - j;
      if (!order.contains(i, j)) continue;
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
    for (int sum = 0; sum <= order.sum; ++sum)
      for (int j = 0; j <= sum; ++j) {
        const int i = sum - j;
        if (!order.contains(i, j)) continue;
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

inline Cad_surface_jet cad_surface_jet(const Cad_surface& surface, const Parameter_box& box,
                                       const Surface_orders& order) {
  return std::visit([&](const auto& s) { return jet_of(s, box, order); }, surface);
}

// The coefficients about a point of a box, and those about all of its points.
struct Surface_jets {
  Cad_surface_jet about_point, on_box;
};
inline Surface_jets surface_jets(const Cad_surface& surface, double u, double v, const Parameter_box& box,
                                 const Surface_orders& order) {
  if (const auto* spline = std::get_if<Cad_spline_surface>(&surface)) { // its polynomial once
    const Interval du = box.u - Interval(u), dv = box.v - Interval(v);
    Spline_piece_polynomial polynomial = spline_polynomial(*spline, box, u, v, du, dv, order);
    return {polynomial.jet(order), polynomial.move(du, dv).jet(order)};
  }
  return {cad_surface_jet(surface, {u, v, box.u_span, box.v_span}, order), cad_surface_jet(surface, box, order)};
}

// The pieces of a surface that ranges of parameters touch, by their spans in u and v; sides of
// knots as for curves.
inline std::array<std::vector<int>, 2> intersected_pieces(const Cad_surface& surface, const Interval& u,
                                                          const Interval& v, int u_side, int v_side) {
  const std::array<Spline_parameter, 2> parameters = spline_parameters(surface);
  return {intersected_pieces(parameters[0], u, u_side), intersected_pieces(parameters[1], v, v_side)};
}

// \throws Error when the numbers of a surface do not fit or are not finite
struct Check_cad_surface {
  void operator()(const Cad_elementary_surface& s) const {
    for (const Cad_point<3>* p : {&s.frame.origin, &s.frame.x_axis, &s.frame.y_axis, &s.frame.z_axis})
      check_finite<3>(*p, "an elementary surface");
    check_finite({s.radius, s.other}, "an elementary surface");
  }
  void operator()(const Cad_spline_surface& s) const {
    const std::size_t rows = s.u_knots.size() - (std::min)(s.u_knots.size(), std::size_t(s.u_degree + 1)),
                      columns = s.v_knots.size() - (std::min)(s.v_knots.size(), std::size_t(s.v_degree + 1));
    check_knots(s.u_knots, s.u_degree, rows);
    check_knots(s.v_knots, s.v_degree, columns);
    if (s.points.size() != rows * columns)
      throw Error(Error_code::wrong_number_of_points, "the points of a spline surface");
    check_weights(s.weights, s.points.size());
    for (const Cad_point<3>& p : s.points) check_finite<3>(p, "a point of a spline surface");
  }
  void operator()(const Cad_extrusion& s) const {
    check_finite<3>(s.direction, "an extrusion");
    std::visit(Check_cad_curve<3>(), s.profile);
  }
  void operator()(const Cad_revolution& s) const {
    check_finite<3>(s.origin, "a surface of revolution");
    check_finite<3>(s.direction, "a surface of revolution");
    std::visit(Check_cad_curve<3>(), s.profile);
  }
  void operator()(const Cad_offset_surface& s) const {
    check_finite({s.distance}, "an offset surface");
    std::visit(*this, *s.basis);
  }
};

// Returns the domain in u and v.
inline std::array<Cad_domain, 2> cad_domain(const Cad_surface& surface) {
  const std::array<Spline_parameter, 2> parameters = spline_parameters(surface);
  return {cad_domain(parameters[0]), cad_domain(parameters[1])};
}
inline std::array<std::vector<double>, 2> inner_knots(const Cad_surface& surface) {
  const std::array<Spline_parameter, 2> parameters = spline_parameters(surface);
  return {inner_knots(parameters[0]), inner_knots(parameters[1])};
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_CAD_SURFACE_JET_H
