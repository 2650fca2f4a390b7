// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SURFACES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Fairest_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/blend_of_columns.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file blend_surfaces.h
/// The blend from an edge of one surface to an edge of another: a surface of degree 5 across that
/// is \f$ G^2 \f$ with both along the whole edges, or one of degree 7 that is \f$ G^3 \f$.
///
/// Let `v` grow from 0, at an edge \f$ C(u) \f$ with the derivatives \f$ T \f$ and \f$ W \f$ across
/// it, to 1. To second order the blend is there the surface \f$ L \f$ itself in other parameters,
/// \f$ S = L \circ \varphi \f$ with
/// \f$ \varphi(u, v) = (u + \alpha v + \frac12 \alpha_2 v^2,\ \beta v + \frac12 \delta v^2) \f$:
///
/// \f[ S_v = \alpha C' + \beta T, \qquad
///     S_{vv} = \alpha^2 C'' + 2 \alpha\beta T' + \beta^2 W + \alpha_2 C' + \delta T, \f]
///
/// with functions \f$ \alpha, \alpha_2, \delta \f$ and \f$ \beta > 0 \f$ of `u`. The rows of
/// control points are \f$ b_0 = C \f$, \f$ b_1 = b_0 + \frac15 S_v \f$,
/// \f$ b_2 = b_0 + \frac25 S_v + \frac1{20} S_{vv} \f$, and at the other end \f$ b_5, b_4, b_3 \f$
/// with \f$ -S_v \f$ for \f$ S_v \f$.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

template <class Shape> void check_beta(const Shape& shape) {
  if (!shape.start.beta.is_positive())
    throw Error(Error_code::nonpositive_beta, "blend: beta at the edge of the first surface");
  if (!shape.end.beta.is_positive())
    throw Error(Error_code::nonpositive_beta, "blend: beta at the edge of the second surface");
}

// Refuses an edge without a normal.
template <bool is_rational, class FT, int N> void check_edge(const Blend_end<FT, N>& end, const char* surface) {
  typedef Coordinate_vector<FT, N> Vector;
  const auto are_all = [](const std::vector<Vector>& row, const auto& point, const auto& value) {
    return std::all_of(row.begin(), row.end(), [&](const Vector& x) {
      const auto& y = point(x);
      for (int i = 0; i < y.dimension(); ++i)
        if (!CGAL::certainly(y[i] == value[i])) return false;
      return true;
    });
  };
  const auto itself = [](const Vector& x) -> const Vector& { return x; };
  bool is_point, vanishes;
  if constexpr (is_rational) { // T = (w_T / w) C
    const auto affine = [](const Vector& x) { return affine_point(x); };
    is_point = are_all(end.edge, affine, affine(end.edge[0]));
    const Edge_spline<FT, N> numerator =
        weight_of(end.knots, end.edge) * end.spline(end.cross) - weight_of(end.knots, end.cross) * end.spline(end.edge);
    vanishes = are_all(numerator.coefficients(), itself, Vector(end.edge[0].dimension()));
  } else {
    is_point = are_all(end.edge, itself, end.edge[0]);
    vanishes = are_all(end.cross, itself, Vector(end.edge[0].dimension()));
  }
  refuse_edge(is_point, vanishes, surface);
}

// C, C', C'', T, T' and W are multiplied by these numbers, or functions along the edge, in a sum.
template <class F> struct Row_weights { F c, c1, c2, t, t1, w; };

// Returns the weights of the sums n (b_1 - b_0) = d S_v and n (n-1) (b_2 - b_0) = 2 (n-1) d S_v +
// S_vv, where n is the degree across and d is 1 at the start of the blend, -1 at its end. With
// lambda_1 and lambda_2 the derivatives are S_v = lambda_1 C + D and S_vv = lambda_2 C + 2 lambda_1
// D + E, with D = alpha C' + beta T.
template <class FT, class F>
std::array<Row_weights<F>, 2> row_weights(const F& alpha, const F& beta, const F& alpha2, const F& delta,
                                          const F& lambda1, const F& lambda2, int direction, int n) {
  const F zero{FT(0)}, two{FT(2)}, d{FT(direction)}, e{FT(2 * (n - 1) * direction)};
  return {{{F(d * lambda1), F(d * alpha), zero, F(d * beta), zero, zero},
           {F(e * lambda1 + lambda2), F(e * alpha + two * lambda1 * alpha + alpha2), F(alpha * alpha),
            F(e * beta + two * lambda1 * beta + delta), F(two * alpha * beta), F(beta * beta)}}};
}

// C''', T'', W' and X are multiplied by these in addition.
template <class F> struct Third_row_weights : Row_weights<F> { F c3, t2, w1, x; };

// Returns the weights of the sum 210 (b_3 - b_0) = 90 d S_v + 15 S_vv + d S_vvv, which is n (n-1)
// (n-2) (b_3 - b_0) for the degree n = 7, with S_vvv = lambda_3 C + 3 lambda_2 D + 3 lambda_1 E +
// alpha^3 C''' + 3 alpha^2 beta T'' + 3 alpha beta^2 W' + beta^3 X
//   + 3 alpha alpha_2 C'' + 3 (alpha delta + alpha_2 beta) T' + 3 beta delta W + alpha_3 C' +
//     delta_3 T.
template <class FT, class Reparametrisation>
Third_row_weights<Edge_function<FT>> third_row_weights(const Reparametrisation& r,
                                                       const std::array<Edge_function<FT>, 2>& lambda, int direction) {
  typedef Edge_function<FT> F;
  const F &a = r.alpha, &b = r.beta, &a2 = r.alpha2, &delta = r.delta;
  const F d{FT(direction)}, two{FT(2)}, three{FT(3)}, of_first{FT(90 * direction)}, of_second{FT(15)};
  F lambda3{FT(0)}; // of homogeneous points
  if constexpr (std::is_base_of_v<Rational_edge_reparametrisation<FT>, Reparametrisation>) lambda3 = r.lambda3;
  const F of_d = of_first + two * of_second * lambda[0] + three * d * lambda[1],
          of_e = of_second + three * d * lambda[0];
  return {{F(of_first * lambda[0] + of_second * lambda[1] + d * lambda3), F(of_d * a + of_e * a2 + d * r.alpha3),
           F(of_e * a * a + three * d * a * a2), F(of_d * b + of_e * delta + d * r.delta3),
           F(two * of_e * a * b + three * d * (a * delta + a2 * b)), F(of_e * b * b + three * d * b * delta)},
          F(d * a * a * a),
          F(three * d * a * a * b),
          F(three * d * a * b * b),
          F(d * b * b * b)};
}

// b_0 + sum / n
template <class FT, int N>
// with c1 = c2 = t1 = 0
Edge_spline<FT, N> next_row(const Blend_end<FT, N>& end, const Row_weights<FT>& x, int n) {
  std::vector<Coordinate_vector<FT, N>> row = end.cross;
  for (std::size_t i = 0; i < row.size(); ++i) {
    row[i] *= x.t;
    if (x.c != FT(0)) row[i] += x.c * end.edge[i];
    if (x.w != FT(0)) row[i] += x.w * end.second_cross[i];
    row[i] /= FT(n);
    row[i] += end.edge[i];
  }
  return end.spline(std::move(row));
}
template <class FT, int N>
Edge_spline<FT, N> weighted_sum(const Blend_end<FT, N>& end, const Row_weights<Edge_function<FT>>& x) {
  const Edge_spline<FT, N> edge = end.spline(end.edge), cross = end.spline(end.cross);
  Edge_spline<FT, N> sum = product(x.t, cross);
  if (!is_zero(x.c)) sum = sum + product(x.c, edge);
  if (!is_zero(x.w)) sum = sum + product(x.w, end.spline(end.second_cross));
  if (!is_zero(x.c1)) sum = sum + product(x.c1, edge.derivative());
  if (!is_zero(x.c2)) sum = sum + product(x.c2, edge.derivative().derivative());
  if (!is_zero(x.t1)) sum = sum + product(x.t1, cross.derivative());
  return sum;
}
template <class FT, int N>
Edge_spline<FT, N> row_of_sum(const Blend_end<FT, N>& end, const Edge_spline<FT, N>& sum, int n) {
  std::vector<Coordinate_vector<FT, N>> step = sum.coefficients();
  for (Coordinate_vector<FT, N>& v : step) v /= FT(n);
  return end.spline(end.edge) + Edge_spline<FT, N>(sum.knots(), std::move(step));
}
template <class FT, int N>
Edge_spline<FT, N> next_row(const Blend_end<FT, N>& end, const Row_weights<Edge_function<FT>>& x, int n) {
  return row_of_sum(end, weighted_sum(end, x), n);
}
template <class FT, int N>
Edge_spline<FT, N> third_row(const Blend_end<FT, N>& end, const Third_row_weights<Edge_function<FT>>& x) {
  Edge_spline<FT, N> sum = weighted_sum(end, x) + product(x.x, end.spline(end.third_cross));
  if (!is_zero(x.c3)) sum = sum + product(x.c3, end.spline(end.edge).derivative().derivative().derivative());
  if (!is_zero(x.t2)) sum = sum + product(x.t2, end.spline(end.cross).derivative().derivative());
  if (!is_zero(x.w1)) sum = sum + product(x.w1, end.spline(end.second_cross).derivative());
  return row_of_sum(end, sum, 210);
}

// By the factor of homogeneous points at the edge.
template <class FT, int N> void scale(Blend_end<FT, N>& end, const FT& lambda, const char* place) {
  if (!(FT(0) < lambda)) throw Error(Error_code::zero_weight, place);
  end.scale(lambda);
}

// The free functions of one end.
template <class FT> std::vector<const Edge_function<FT>*> functions_of(const Edge_reparametrisation<FT>& r) {
  return {&r.alpha, &r.beta, &r.alpha2, &r.delta};
}
template <class FT> std::vector<const Edge_function<FT>*> functions_of(const Rational_edge_reparametrisation<FT>& r) {
  return {&r.alpha, &r.beta, &r.alpha2, &r.delta, &r.lambda1, &r.lambda2};
}
template <class Reparametrisation>
std::vector<const typename Reparametrisation::Function*>
functions_of(const Septic_edge_reparametrisation<Reparametrisation>& r) {
  auto functions = functions_of(static_cast<const Reparametrisation&>(r));
  for (const typename Reparametrisation::Function* f : {&r.alpha3, &r.delta3, &r.lambda3}) functions.push_back(f);
  return functions;
}

// Takes note of the work on one end: sums of at most six products of each row with a polynomial.
template <class FT, int N> void charge_end(const Blend_end<FT, N>& end, const Edge_reparametrisation<FT>& r) {
  double degree = 0; // of the functions, or as many knots
  for (const Edge_function<FT>* f : functions_of(r))
    degree = (std::max)(degree, static_cast<double>(f->number_of_coefficients() - 1));
  const double numbers = static_cast<double>(end.edge.size()) * end.edge[0].dimension();
  work_meter().charge_fractions(12 * numbers * (1 + 2 * degree) * (1 + degree),
                                common_words<FT>(end.edge) + common_words<FT>(end.second_cross));
}

// The knots along the edges of a blend, counted before anything is computed: those of both edges,
// once more for each degree by which they are raised, and those of the functions in the degree of
// the blend.
template <class FT> class Knots_of_blend {
  int degree_ = 0, dimension_ = 0;
  std::array<int, 2> degrees_{}, spans_{};
  std::array<double, 2> inner_{}; // knots of the edges
  double of_functions_ = 0;

public:
  // `order` is that of the blend.
  template <int N, class Shape>
  Knots_of_blend(const Blend_end<FT, N>& a, const Blend_end<FT, N>& b, const Shape& shape, int order)
      : dimension_(a.edge[0].dimension()) {
    const auto take = [&](int e, const Blend_end<FT, N>& end, const auto& functions) {
      int degree = 0;
      for (const Edge_function<FT>* f : functions) {
        degree = (std::max)(degree, f->degree());
        of_functions_ += f->knots().number_of_spans() - 1;
      }
      degrees_[e] = end.knots.degree();
      spans_[e] = end.knots.number_of_spans();
      inner_[e] = end.knots.number_of_coefficients() - degrees_[e] - 1;
      degree_ = (std::max)(degree_, degrees_[e] + order * degree);
    };
    take(0, a, functions_of(shape.start));
    take(1, b, functions_of(shape.end));
  }

  void check(Patch_edge edge_a, Patch_edge edge_b) const {
    double most = of_functions_ * degree_;
    for (int e : {0, 1}) most += inner_[e] + (spans_[e] - 1.) * (degree_ - degrees_[e]);
    if (most == 0) return;
    const double each = is_rational_v<FT> ? 450 : 1, // the work on one number, see `Work_limit`
        steps = 6. * dimension_ * (degree_ + 1.) * (degree_ + 1.) * each * (most + degree_ + 1);
    const double allowed = static_cast<double>(Work_scope::limit_of_each().steps());
    if (steps <= allowed) return;
    const auto text = [](double x) { return std::to_string(static_cast<long long>(x)); };
    throw Error(Error_code::too_many_knots,
                "blend: " + text(inner_[0]) + " inner knots along the edge " + to_string(edge_a) +
                    " of the first surface, " + text(inner_[1]) + " along the edge " + to_string(edge_b) +
                    " of the second one and " + text(of_functions_) + " of the functions are up to " + text(most) +
                    " in degree " + std::to_string(degree_) + ", " + text(steps) + " steps of work, and " +
                    text(allowed) + " are allowed: a Work_scope raises the limit");
  }
};

// The three rows of control points from an edge inwards.
template <class FT, int N, class F>
std::array<Edge_spline<FT, N>, 3> rows_of_end(const Blend_end<FT, N>& end, const std::array<Row_weights<F>, 2>& w,
                                              int n) {
  return {end.spline(end.edge), next_row(end, w[0], n), next_row(end, w[1], n * (n - 1))};
}

// lambda_1 and lambda_2.
template <class FT> std::array<Edge_function<FT>, 2> factor_of(const Rational_edge_reparametrisation<FT>& r) {
  return {r.lambda1, r.lambda2};
}
template <class FT> std::array<Edge_function<FT>, 2> factor_of(const Edge_reparametrisation<FT>&) {
  return {Edge_function<FT>{FT(0)}, Edge_function<FT>{FT(0)}};
}

template <class FT, int N, class Reparametrisation>
std::array<Edge_spline<FT, N>, 3> rows_of_end(const Blend_end<FT, N>& end, const Reparametrisation& r, int direction,
                                              int n) {
  const std::array<Edge_function<FT>, 2> lambda = factor_of(r);
  const auto are_numbers = [](const auto&... f) { return (... && f.is_number()); };
  if (is_constant(r.alpha, 0) && is_constant(r.alpha2, 0) && are_numbers(r.beta, r.delta, lambda[0], lambda[1]))
    return rows_of_end(
        end, row_weights<FT, FT>(FT(0), r.beta[0], FT(0), r.delta[0], lambda[0][0], lambda[1][0], direction, n), n);
  return rows_of_end(end, row_weights<FT>(r.alpha, r.beta, r.alpha2, r.delta, lambda[0], lambda[1], direction, n), n);
}

// Where a derivative along an edge jumps that the functions multiply, the rows would have knots of
// the multiplicity degree + 1.
template <class FT> void check_not_torn(const Knot_vector<FT>& knots) {
  for (const typename Knot_vector<FT>::Knot& knot : knots.inner_knots())
    if (knot.multiplicity > knots.degree())
      throw Error(Error_code::knot_multiplicity, "blend: it would be torn at the knot " +
                                                     std::to_string(CGAL::to_double(knot.value)) + " along an edge");
}

// The six rows of control points across a blend.
template <class FT, int N, class Shape>
std::array<Edge_spline<FT, N>, 6> rows_of_blend(const Blend_end<FT, N>& start, const Blend_end<FT, N>& end,
                                                const Shape& shape) {
  std::array<Edge_spline<FT, N>, 3> s = rows_of_end(start, shape.start, 1, 5), e = rows_of_end(end, shape.end, -1, 5);
  std::array<Edge_spline<FT, N>, 6> rows = {std::move(s[0]), std::move(s[1]), std::move(s[2]),
                                            std::move(e[2]), std::move(e[1]), std::move(e[0])};
  unite(rows);
  // equivalent [0 -> 1, 1]: united rows have the same knots
  check_not_torn(rows[0].knots());
  return rows;
}

// The eight rows of control points across a blend of degree 7.
template <class FT, int N, class Shape>
std::array<Edge_spline<FT, N>, 8> rows_of_septic_blend(const Blend_end<FT, N>& start, const Blend_end<FT, N>& end,
                                                       const Shape& shape) {
  std::array<Edge_spline<FT, N>, 3> s = rows_of_end(start, shape.start, 1, 7), e = rows_of_end(end, shape.end, -1, 7);
  std::array<Edge_spline<FT, N>, 8> rows = {
      std::move(s[0]),
      std::move(s[1]),
      std::move(s[2]),
      third_row(start, third_row_weights<FT>(shape.start, factor_of(shape.start), 1)),
      third_row(end, third_row_weights<FT>(shape.end, factor_of(shape.end), -1)),
      std::move(e[2]),
      std::move(e[1]),
      std::move(e[0])};
  unite(rows);
  check_not_torn(rows[0].knots());
  return rows;
}

// The ends of a blend with a shape that is given, both checked but for beta.
template <class Kind, class A, class B, class Shape>
auto checked_ends(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, const Shape& shape,
                  Edge_direction direction, int order) {
  auto ends = Kind::ends(a, edge_a, b, edge_b, direction, order);
  Knots_of_blend<typename Kind::FT>(ends.first, ends.second, shape, order).check(edge_a, edge_b);
  charge_end(ends.first, shape.start);
  charge_end(ends.second, shape.end);
  check_edge<Kind::is_rational>(ends.first, "the first surface");
  check_edge<Kind::is_rational>(ends.second, "the second surface");
  if constexpr (Kind::is_rational) {
    scale(ends.first, shape.start.lambda, "blend: lambda at the edge of the first surface");
    scale(ends.second, shape.end.lambda, "blend: lambda at the edge of the second surface");
  }
  return ends;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the surface \f$ S(u, v) \f$ of degree 5 in `v`, on [0, 1], that leads from an edge of
/// one surface, at `v = 0`, to an edge of another one, at `v = 1`, and is \f$ G^2 \f$ with both
/// along the whole edges, wherever the normals of the surfaces do not vanish there. Along `u` it
/// has the domain and the direction of the first edge. With an exact kernel it is exact, as
/// `edge_continuity()` proves.
///
/// The second edge is mapped affinely to the domain of the first one, degrees are raised and knots
/// are united where they differ. Constants in the place of functions leave the degree along the
/// edges as it is, functions of degree `q` raise it by up to `2 q`, and knots of splines become
/// knots of the blend, which is as smooth across them as they are. Where \f$ \alpha \f$,
/// \f$ \alpha_2 \f$ and \f$ \delta \f$ are 0 and \f$ \beta \f$ is constant, each curve `u` = const
/// is a blend of the curves of the two surfaces, see `Quintic_ends`. The side edges are what the
/// side edges of the surfaces make of them: between two closed edges they are one curve where the
/// surfaces close smoothly, and where only one edge is closed they meet at one end.
///
/// The dimension is any. Linear in the number of knots.
/// \param shape the functions that are free, in the parameter of the first edge; derivatives are
///   those with respect to the parameters of the surfaces
/// \param direction how the second edge runs in comparison with the first one
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `nonpositive_beta` unless both functions \f$ \beta \f$ are positive on the closed
///   domain (decided exactly, checked first)
/// \throws Error `zero_tangent` when an edge is a single point, or when the derivative across it
///   vanishes on the whole edge
/// \throws Error `knot_multiplicity` when a derivative along an edge jumps that is multiplied by
///   \f$ \alpha \f$ or \f$ \alpha_2 \f$, when a function jumps, and for functions with knots on two
///   patches
/// \throws Error `too_many_knots`, before anything is computed, when the knots of both edges and of
///   the functions together need more work than `Work_limit` allows: its control points take about
///   \f$ 6\,d\,(p+1)^2 \f$ steps for each knot of multiplicity one, in degree `p` and dimension
///   `d`, and 450 times as many with rational numbers
/// \throws Error `dimension_mismatch`; `zero_weight` when the denominator of a rational blend is
///   not positive; `not_finite` when floating-point numbers overflow; `work_limit`
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          const Blend_surface_shape<Surface_a, Surface_b>& shape,
                                          Edge_direction direction = Edge_direction::same) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  internal::check_beta(shape);
  if constexpr (Kind::is_patch && !Kind::is_rational)
    if (internal::is_blend_of_columns(a, edge_a, b, edge_b, shape))
      return internal::Blended_columns<typename Kind::Traits>::blend(a, edge_a, b, edge_b, shape, direction);
  const internal::Work_guard work("blend");
  const auto ends = internal::checked_ends<Kind>(a, edge_a, b, edge_b, shape, direction, 2);
  return Kind::surface(internal::rows_of_blend(ends.first, ends.second, shape));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the surface of degree 7 in `v`, on [0, 1], that leads from an edge of one surface to an
/// edge of another one and is \f$ G^3 \f$ with both along the whole edges, wherever the normals of
/// the surfaces do not vanish there: to third order it is each surface in the parameters
/// \f$ u + \alpha v + \frac12 \alpha_2 v^2 + \frac16 \alpha_3 v^3 \f$ and
/// \f$ \beta v + \frac12 \delta v^2 + \frac16 \delta_3 v^3 \f$. All else is as for the blend of
/// degree 5; functions of degree `q` raise the degree along the edges by up to `3 q`.
/// \param shape the functions that are free; a shape of order 2 can be converted to one
/// \throws Error as the function of degree 5
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b>
blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
      const Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>& shape,
      Edge_direction direction = Edge_direction::same) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  const internal::Work_guard work("blend");
  internal::check_beta(shape);
  const auto ends = internal::checked_ends<Kind>(a, edge_a, b, edge_b, shape, direction, 3);
  return Kind::surface(internal::rows_of_septic_blend(ends.first, ends.second, shape));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the mean of the variations of curvature \f$ E = L^3 \int |(dK/ds)^\perp|^2 ds \f$ of the
/// curves `u` = const of a blend, see `fairness()`: at nine parameters in equal distances, those of
/// both side edges among them, and four more for each further span along the edges, at most 65.
/// The smaller, the fairer; the size of the blend does not matter. `Fairest` makes it small.
///
/// In floating-point numbers, by Gauss's quadrature with 64 nodes on each curve. It is large or
/// infinite where a curve has a cusp or almost has one.
/// \pre the degree in `v` is at most 7, and there is one span in `v`
template <class Surface> double mean_fairness(const Surface& blend) {
  CGAL_precondition(blend.degree_v() <= 7);
  if constexpr (internal::Is_rational<Surface>::value)
    return internal::mean_variation<true>(blend.homogeneous());
  else
    return internal::mean_variation<false>(blend);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape of a blend from an edge of one surface to an edge of another one that
/// `Fairest` or a strategy for blends of curves chooses: of degree 5, or of degree 7 by a septic
/// strategy. All functions are constants, and those of the parameter along the edge,
/// \f$ \alpha \f$, \f$ \alpha_2 \f$ and \f$ \alpha_3 \f$, are 0.
///
/// The curves `u` = const at the Greville abscissae of the edge with more of them are taken as one
/// curve in a space of many dimensions. A strategy that chooses its own shape parameters, as `Fair`
/// does, chooses \f$ \beta \f$ at both ends; otherwise they make the tangents as long as the chords
/// in the mean square, see `automatic_shape()`. The scalars \f$ s_1, s_2 \f$ of the strategy give
/// \f$ \delta \f$: with `Matching_second_derivative` it is 0, `Minimal_energy<3>` has the least sum
/// of \f$ \int |S_{vvv}|^2 dv \f$, `Fair` the least variation of the curvature of the curve in many
/// dimensions. A septic strategy gives \f$ \delta = \beta_2 \f$ and \f$ \delta_3 = \beta_3 \f$; for
/// \f$ G^3 \f$, \f$ \mu \f$ is \f$ 3\beta\beta_2 \f$, whatever it chooses. Where `possible_fold()`
/// does not prove that the blend of `Fair`, `Fair_g3` or `Fair_f3` has no fold, one half, a quarter
/// or an eighth of the way from the shape of least energy to theirs is gone, or none of it, as far
/// as it is proved there.
///
/// For rational surfaces, the factors of the homogeneous points keep the denominator of the blend
/// as constant as constants can, and at both edges they make the weights of its control points at
/// least a quarter of those of the edge, wherever all those are positive. So surfaces with positive
/// weights always have a blend.
///
/// All this is computed in floating-point numbers and rounded to 8 binary digits, so that exact
/// numbers stay short. The blend is exact, whatever the shape is. Linear in the number of knots.
/// \tparam Strategy `Fairest`, or a model of `BlendStrategy`, called with `Quintic_ends<double, 0>`
///   or, if it cannot be, `Septic_ends<double, 0>`
/// \throws Error `zero_tangent` where a derivative across an edge vanishes at all these parameters,
///   `dimension_mismatch`, `not_finite` for numbers so large or small that their squares are not in
///   the range of floating-point numbers
template <class Surface_a, class Surface_b, class Strategy>
Chosen_surface_shape<Surface_a, Surface_b, Strategy>
automatic_surface_shape(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                        const Strategy& strategy, Edge_direction direction) {
  static_assert(is_surface_blend_strategy_v<Strategy>, "the strategy is one for blends in every field");
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  typedef Chosen_surface_shape<Surface_a, Surface_b, Strategy> Shape;
  constexpr int order = is_quintic_surface_strategy_v<Strategy> ? 2 : 3;
  const auto make = [&](const Shape& shape) { return blend(a, edge_a, b, edge_b, shape, direction); };
  const internal::Shape_search<Kind, Shape, decltype(make)> search(Kind::ends(a, edge_a, b, edge_b, direction, order),
                                                                   order, make);
  if constexpr (std::is_same_v<Strategy, Fairest>)
    return search.fairest();
  else if constexpr (std::is_void_v<typename internal::Unfair<Strategy>::type>)
    return search.chosen(strategy);
  else
    return search.unfolded(strategy);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two surfaces with the shape that `automatic_surface_shape()` finds by a
/// strategy: of degree 5 and \f$ G^2 \f$, or by a septic strategy of degree 7 and \f$ G^3 \f$.
/// \tparam Strategy `Fairest`, or a model of `BlendStrategy`, called with `Quintic_ends<double, 0>`
///   or, if it cannot be, `Septic_ends<double, 0>`
/// \throws Error as the function with a shape, and as `automatic_surface_shape()`
template <class Surface_a, class Surface_b, class Strategy,
          class = std::enable_if_t<is_surface_blend_strategy_v<Strategy>>>
Blend_surface<Surface_a, Surface_b> blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          const Strategy& strategy, Edge_direction direction) {
  return blend(a, edge_a, b, edge_b, automatic_surface_shape(a, edge_a, b, edge_b, strategy, direction), direction);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the blend of two surfaces with a shape by a strategy, where the second edge runs in
/// `nearer_direction()`.
/// \throws Error as the function with a direction
template <class Surface_a, class Surface_b, class Strategy,
          class = std::enable_if_t<is_surface_blend_strategy_v<Strategy>>>
Blend_surface<Surface_a, Surface_b> blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          const Strategy& strategy) {
  return blend(a, edge_a, b, edge_b, strategy, nearer_direction(a, edge_a, b, edge_b));
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the fairest blend of two surfaces, see `Fairest`, where the second edge runs in
/// `nearer_direction()`.
/// \throws Error as the function with a strategy
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> blend(const Surface_a& a, Patch_edge edge_a, const Surface_b& b,
                                          Patch_edge edge_b) {
  return blend(a, edge_a, b, edge_b, Fairest());
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_BLEND_SURFACES_H
