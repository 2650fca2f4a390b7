// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SIDE_EVALUATOR_H
#define CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SIDE_EVALUATOR_H

#include <CGAL/Geometric_continuity/cad/internal/Cad_surface_jet.h>
#include <CGAL/Geometric_continuity/cad/internal/Taylor_model.h>

#include <algorithm>
#include <array>
#include <cmath>

/// \file Side_evaluator.h
/// Point, normal and normal curvature of one side of an edge, as Taylor models over a range of the
/// parameter.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A range of the parameter: its points are middle + s half, s in [-1, 1].
struct Edge_range {
  Interval t;
  double middle, half;

  Edge_range(double lower, double upper) : t(lower, upper), middle(internal::middle(t)), half(magnitude(t - middle)) {}
  // Where the parameter x of the range lies in [-1, 1].
  Interval place(double x) const {
    return half == 0 ? Interval(0) : common_part((Interval(x) - Interval(middle)) / Interval(half), symmetric(1));
  }
};

enum class Edge_quantity { gap, angle, curvature };

struct Side_models {
  Taylor_vector point, normal; // the normal of unit length
  // in the direction of the tangent plane that is orthogonal to the edge
  Taylor_model curvature;
  // the edge is a knot line, and on which side of it the face lies is not known
  bool along_knots = false;
};

// Adds a multiple of s^k to a model without that power, or with one that it does not keep.
inline void add_coefficient(Taylor_model& f, int k, const Interval& x) {
  double rest = magnitude(x);
  if (k < Taylor_model::size && rest <= Taylor_model::largest) {
    f.c[k] = middle(x);
    rest = magnitude(x - Interval(f.c[k]));
  }
  f.r = (f.r + rest) * Taylor_model::enlarged;
}

// A curve on a range: one coordinate and its derivative.
struct Coordinate_models {
  Taylor_model value, derivative;
  Interval range; // of the value; a point when the coordinate is constant

  // Makes the model from the Taylor coefficients about the middle, and of the next order on all of
  // the range (Lagrange's form of the remainder). Where the coordinate rises or falls its range is
  // that between its ends, so that it does not reach beyond a knot that it ends on.
  template <int D>
  Coordinate_models(const Cad_curve_jet<D>& about_middle, const Cad_curve_jet<D>& on_range, const Interval& at_ends,
                    int i, double half) {
    constexpr int n = Taylor_model::size;
    bool constant = on_range.c[0][i].is_point();
    for (int k = 1; k <= n + 1; ++k) constant = constant && is_exact_zero(on_range.c[k][i]);
    Interval power = 1;
    for (int k = 0; k <= n; ++k, power *= Interval(half)) {
      const Cad_curve_jet<D>& jet = k < n ? about_middle : on_range;
      add_coefficient(value, k, jet.c[k][i] * power);
      add_coefficient(derivative, k, (k + 1) * jet.c[k + 1][i] * power);
    }
    if (!value.known())
      range = Interval::largest();
    else if (constant)
      range = on_range.c[0][i];
    else if (on_range.c[1][i].inf() > 0 || on_range.c[1][i].sup() < 0)
      range = hull(value.c[0], at_ends);
    else
      range = hull(value.c[0], common_part(value.range(), on_range.c[0][i]));
  }
};

// A placement whose numbers have been checked. \throws Error `not_finite`, `singular_frame`
class Validated_transform {
  const Cad_placement& m_;
  bool identity_ = true, mirror_;

public:
  explicit Validated_transform(const Cad_placement& placement) : m_(placement) {
    std::array<Interval_vector<3>, 3> m;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) {
        check_finite({m_[i][j]}, "a placement");
        if (j < 3) m[i][j] = m_[i][j];
        identity_ = identity_ && m_[i][j] == (i == j ? 1 : 0);
      }
    const Interval determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                 m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    if (!(determinant.inf() > 0) && !(determinant.sup() < 0))
      throw Error(Error_code::singular_frame, "a placement is not invertible");
    mirror_ = determinant.sup() < 0;
  }

  bool is_mirror() const { return mirror_; }

  Interval_vector<3> operator()(const Interval_vector<3>& x, bool is_point) const {
    if (identity_) return x;
    Interval_vector<3> y;
    for (int i = 0; i < 3; ++i) {
      if (is_point) y[i] = m_[i][3];
      for (int j = 0; j < 3; ++j) y[i] += Interval(m_[i][j]) * x[j];
    }
    return y;
  }

  Taylor_vector operator()(const Taylor_vector& x, bool is_point) const {
    if (identity_) return x;
    Taylor_vector y;
    const std::array<double, 3> norm{x[0].norm() * Taylor_model::enlarged, x[1].norm() * Taylor_model::enlarged,
                                     x[2].norm() * Taylor_model::enlarged};
    for (int i = 0; i < 3; ++i) {
      Taylor_sum sum;
      for (int j = 0; j < 3; ++j) sum.add(Interval(m_[i][j]), x[j], norm[j]);
      y[i] = sum.value();
      if (is_point) y[i] = y[i] + Taylor_model(m_[i][3]);
    }
    return y;
  }
};

// An `Edge_curve` whose numbers have been checked.
class Placed_curve {
  const Edge_curve& given_;
  Validated_transform placed_;

public:
  explicit Placed_curve(const Edge_curve& given) : given_(given), placed_(given.placement) {
    std::visit(Check_cad_curve<3>(), *given.curve);
  }

  // The point on a range, or its derivative of order m. \pre the range lies between the knots
  Taylor_vector models(const Edge_range& range, int m = 0) const {
    constexpr int n = Taylor_model::size;
    const Cad_curve<3>& curve = *given_.curve;
    const int span = intersected_pieces(curve, range.t, 1).front();
    const Cad_curve_jet<3> about_middle = cad_curve_jet(curve, Interval(range.middle), n + m - 1, span),
                           on_range = cad_curve_jet(curve, range.t, n + m, span);
    Taylor_vector result;
    Interval power = 1;
    for (int k = 0; k <= n; ++k, power *= Interval(range.half)) {
      double factor = 1; // (k + m)! / k!
      for (int j = 1; j <= m; ++j) factor *= k + j;
      for (int i = 0; i < 3; ++i)
        add_coefficient(result[i], k, factor * (k < n ? about_middle : on_range).c[k + m][i] * power);
    }
    return placed_(result, m == 0);
  }

  // The point and the derivative at a parameter.
  std::array<Interval_vector<3>, 2> jet(double t) const {
    const Cad_curve_jet<3> jet = cad_curve_jet(*given_.curve, Interval(t), 1);
    return {placed_(jet.c[0], true), placed_(jet.c[1], false)};
  }

  // The point at a parameter, rounded.
  Cad_point<3> point(double t) const {
    const Interval_vector<3> p = jet(t)[0];
    return {middle(p[0]), middle(p[1]), middle(p[2])};
  }

  // The point and two derivatives at a parameter, at a knot those below (`side` < 0) or above
  // (`side` > 0). \throws Error `parameter_outside_domain`
  std::array<Interval_vector<3>, 3> jet(double t, int side) const {
    const Cad_curve<3>& curve = *given_.curve;
    cad_domain(curve).check(t, "the end of an edge");
    const Interval at(t);
    const Cad_curve_jet<3> jet = cad_curve_jet(curve, at, 2, intersected_pieces(curve, at, side).front());
    Interval_vector<3> second = jet.c[2];
    for (Interval& x : second) x *= 2;
    return {placed_(jet.c[0], true), placed_(jet.c[1], false), placed_(second, false)};
  }
};

// An `Edge_side` whose numbers have been checked.
class Side_evaluator {
  const Edge_side& side_;
  Validated_transform placed_;
  bool flipped_; // whether the normal is that of the placed surface times -1

public:
  explicit Side_evaluator(const Edge_side& side)
      : side_(side), placed_(side.placement), flipped_(side.reversed != placed_.is_mirror()) {
    std::visit(Check_cad_surface(), *side.surface);
    std::visit(Check_cad_curve<2>(), *side.curve);
  }

  const Edge_side& given() const { return side_; }
  const Validated_transform& placed() const { return placed_; }
  bool is_flipped() const { return flipped_; }

  // Returns on each range the quantity asked for and those before it, by the formula of each piece
  // of the surface that the edge may touch there, continued to all of the range: at each parameter
  // one of these is the surface. None when nothing is known, or when there are too many. \pre the
  // range lies between the knots of the curve
  std::vector<Side_models> models(const Edge_range& range, Edge_quantity quantity) const {
    constexpr int n = Taylor_model::size;
    const Cad_curve<2>& curve = *side_.curve;
    const int span = intersected_pieces(curve, range.t, 1).front();
    const Cad_curve_jet<2> about_middle = cad_curve_jet(curve, Interval(range.middle), n, span),
                           on_range = cad_curve_jet(curve, range.t, n + 1, span),
                           first = cad_curve_jet(curve, Interval(range.t.inf()), 0, span),
                           last = cad_curve_jet(curve, Interval(range.t.sup()), 0, span);
    const Coordinate_models u(about_middle, on_range, hull(first.c[0][0], last.c[0][0]), 0, range.half),
        v(about_middle, on_range, hull(first.c[0][1], last.c[0][1]), 1, range.half);
    std::vector<Side_models> result;
    if (!(magnitude(u.range) <= Taylor_model::largest && magnitude(v.range) <= Taylor_model::largest)) return result;
    // the face lies towards face_side (-v', u'): for curves along a knot line
    const auto sign = [](const Interval& x) { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; };
    const std::array<std::vector<int>, 2> spans =
        intersected_pieces(*side_.surface, u.range, v.range, -sign(on_range.c[1][1]) * side_.face_side,
                           sign(on_range.c[1][0]) * side_.face_side);
    if (spans[0].size() * spans[1].size() > 6) return result;
    for (int u_span : spans[0])
      for (int v_span : spans[1]) {
        result.push_back(piece_models(u, v, u_span, v_span, quantity));
        result.back().along_knots =
            (u.range.is_point() && spans[0].size() > 1) || (v.range.is_point() && spans[1].size() > 1);
      }
    return result;
  }

private:
  Side_models piece_models(const Coordinate_models& u, const Coordinate_models& v, int u_span, int v_span,
                           Edge_quantity quantity) const {
    Taylor_model du = u.value, dv = v.value;
    du.c[0] = dv.c[0] = 0;
    const int derivatives = static_cast<int>(quantity), order = Taylor_model::size + derivatives;
    const Surface_orders orders(is_zero(du) ? derivatives : order, is_zero(dv) ? derivatives : order, order);
    const Surface_jets jets =
        surface_jets(*side_.surface, u.value.c[0], v.value.c[0], {u.range, v.range, u_span, v_span}, orders);
    const Composition compose{jets, powers(du, jets.on_box.u_degree), powers(dv, jets.on_box.v_degree)};
    Side_models m;
    m.point = placed_(compose(0, 0), true);
    if (quantity == Edge_quantity::gap) return m;
    const Taylor_vector sv = placed_(compose(0, 1), false);
    Taylor_vector su = placed_(compose(1, 0), false);
    // On spheres and cones S_u = rho(v) R'(u), and rho is zero at poles and apices, where R' x S_v
    // is still a normal.
    const auto* elementary = std::get_if<Cad_elementary_surface>(&*side_.surface);
    const int sign = elementary ? sign_of_rho(*elementary, v.range) : 0;
    const bool sphere = sign != 0 && elementary->kind == Cad_elementary_surface::Kind::sphere;
    Taylor_vector in_u = su; // or R'
    if (sign != 0) {
      // equivalent [0 -> 1, 1]: a cylinder has no second number
      const Cad_elementary_surface cylinder{Cad_elementary_surface::Kind::cylinder, elementary->frame, 1, 0};
      const Surface_jets of_cylinder =
          surface_jets(cylinder, u.value.c[0], v.value.c[0], {u.range, v.range, 0, 0}, orders);
      in_u = placed_(Composition{of_cylinder, compose.u, compose.v}(1, 0), false);
    }
    const Unit_normal normal(in_u, sv, flipped_ != (sign < 0));
    m.normal = normal.vector;
    if (quantity == Edge_quantity::angle) return m;
    Taylor_model u_derivative = u.derivative;
    if (sphere) {
      u_derivative = u.derivative * dot(su, in_u) * reciprocal(dot(in_u, in_u)); // rho u'
      su = in_u;
    }
    const Unit_normal of_forms = sign != 0 && !sphere ? Unit_normal(su, sv, flipped_) : normal;
    // The second fundamental form, with its first two numbers over rho^2 and rho for a sphere of
    // the axes x, y, z: there R'' . (R' x S_v) / rho = -(x, y, z) and R' . (R' x S_v) = 0.
    Taylor_model l, m_, n = dot(of_forms.vector, placed_(compose(0, 2), false));
    if (sphere)
      l = -frame_determinant(*elementary) * of_forms.factor;
    else
      l = dot(of_forms.vector, placed_(compose(2, 0), false)), m_ = dot(of_forms.vector, placed_(compose(1, 1), false));
    // With the first fundamental form (e, f; f, g) the direction a S_u + b S_v is orthogonal to the
    // edge's S_u u' + S_v v', and its square is (e g - f^2) times that of the edge's, with e g -
    // f^2 = |N|^2.
    const Taylor_model e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
    const Taylor_model b = e * u_derivative + f * v.derivative, a = -(f * u_derivative + g * v.derivative);
    const Taylor_model square = b * u_derivative - a * v.derivative;
    m.curvature = (l * a * a + Taylor_model(2) * (m_ * a * b) + n * b * b) * (of_forms.factor * of_forms.factor) *
                  reciprocal(square);
    return m;
  }

  // The cross product of two vectors, or the opposite one, divided by its length.
  struct Unit_normal {
    Taylor_model factor; // with its sign
    Taylor_vector vector;

    Unit_normal(const Taylor_vector& u, const Taylor_vector& v, bool flipped) : vector(cross(u, v)) {
      factor = reciprocal_root(dot(vector, vector));
      if (flipped) factor = -factor;
      vector = vector * factor;
    }
  };

  // The sign of rho where it has one in a range of v, but for roundings at a pole or an apex; 0 for
  // other surfaces.
  static int sign_of_rho(const Cad_elementary_surface& surface, const Interval& v) {
    typedef Cad_elementary_surface::Kind Kind;
    if (surface.kind == Kind::sphere)
      return magnitude(v) <= 1.57079633 /* pi/2, and 1e-8 more */ && surface.radius != 0 ? (surface.radius > 0 ? 1 : -1)
                                                                                         : 0;
    if (surface.kind != Kind::cone) return 0;
    const Interval rho = Interval(surface.radius) + v * cosine_and_sine(Interval(surface.other)).sine;
    const double rounding = 1e-12 * (std::fabs(surface.radius) + magnitude(rho));
    // equivalent [> -> >=, 1]: a limit without meaning to the last digit
    // equivalent [>= -> >, 1]: a limit without meaning to the last digit
    return rho.sup() > rounding && rho.inf() >= -rounding ? 1 : rho.inf() < -rounding && rho.sup() <= rounding ? -1 : 0;
  }
  // Returns the determinant of the placed axes of a frame.
  Taylor_model frame_determinant(const Cad_elementary_surface& surface) const {
    const Cad_frame& f = surface.frame;
    Taylor_vector axes[3];
    for (int i = 0; i < 3; ++i) {
      axes[0][i] = f.x_axis[i];
      axes[1][i] = f.y_axis[i];
      axes[2][i] = f.z_axis[i];
    }
    return dot(cross(placed_(axes[0], false), placed_(axes[1], false)), placed_(axes[2], false));
  }

  static bool is_zero(const Taylor_model& f) { return f.norm() == 0 && f.r == 0; }
  struct Powers {
    std::vector<Taylor_model> f;
    std::vector<double> norm;
  };
  static Powers powers(const Taylor_model& f, int degree) {
    Powers p{{Taylor_model(1)}, {1}};
    if (is_zero(f)) return p;
    for (int i = 1; i <= (std::min)(degree, Taylor_model::size); ++i) {
      p.f.push_back(i == 1 ? f : p.f.back() * f);
      p.norm.push_back(p.f.back().norm() * Taylor_model::enlarged);
    }
    return p;
  }

  // A derivative of S by u and v along the curve: its Taylor polynomial about the point in the
  // middle, where the coefficients of the last order are those of all points of the box.
  struct Composition {
    const Surface_jets& jets;
    const Powers u, v;

    Taylor_vector operator()(int by_u, int by_v) const {
      constexpr int order = Taylor_model::size;
      std::array<Taylor_sum, 3> sums;
      Taylor_vector first{};
      for (int i = 0; i <= order && i < static_cast<int>(u.f.size()) && i + by_u <= jets.on_box.u_degree; ++i)
        for (int j = 0; i + j <= order && j < static_cast<int>(v.f.size()) && j + by_v <= jets.on_box.v_degree; ++j) {
          const Interval_vector<3>& x = (i + j < order ? jets.about_point : jets.on_box).s(i + by_u, j + by_v);
          const double factor = (by_u == 2   ? (i + 2) * (i + 1)
                                 : by_u == 1 ? i + 1
                                             : 1) *
                                (by_v == 2   ? (j + 2) * (j + 1)
                                 : by_v == 1 ? j + 1
                                             : 1);
          if (i + j == 0) {
            for (int k = 0; k < 3; ++k) {
              const Interval constant = Interval(factor) * x[k];
              if (!(magnitude(constant) <= Taylor_model::largest)) {
                first[k] = Taylor_model::unknown();
                continue;
              }
              first[k].c[0] = constant.inf() / 2 + constant.sup() / 2;
              first[k].r = magnitude(constant - Interval(first[k].c[0]));
            }
            continue;
          }
          if (is_exact_zero(x[0]) && is_exact_zero(x[1]) && is_exact_zero(x[2])) continue;
          const bool both = i > 0 && j > 0;
          const Taylor_model f = both ? u.f[i] * v.f[j] : i > 0 ? u.f[i] : v.f[j];
          const double norm = both ? f.norm() * Taylor_model::enlarged : i > 0 ? u.norm[i] : v.norm[j];
          for (int k = 0; k < 3; ++k) sums[k].add(Interval(factor) * x[k], f, norm, i + j);
        }
      for (int k = 0; k < 3; ++k) first[k] = sums[k].value() + first[k];
      return first;
    }
  };
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CAD_INTERNAL_SIDE_EVALUATOR_H
