// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_MATCH_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_MATCH_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/blend_surfaces.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file match.h
/// A surface is changed near one of its edges so that it continues another one.
///
/// Let the first surface end in the edge \f$ C(u) \f$ with the derivatives \f$ T, W, X \f$ across
/// it, and let `v` grow from there into the second one. To order `k` the matched surface is the
/// first one in other parameters, as in blend_surfaces.h, with numbers in the place of functions:
///
/// \f[ S_v = \alpha C' + \beta T, \qquad
///     S_{vv} = \alpha^2 C'' + 2 \alpha\beta T' + \beta^2 W + \alpha_2 C' + \delta T, \f]
/// \f[ S_{vvv} = \alpha^3 C''' + 3 \alpha^2\beta T'' + 3 \alpha\beta^2 W' + \beta^3 X
///     + 3 \alpha\alpha_2 C'' + 3 (\alpha\delta + \alpha_2\beta) T' + 3 \beta\delta W
///     + \alpha_3 C' + \delta_3 T. \f]

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The numbers that are free in a match, see match.h. \f$ \beta \f$ is positive.
template <class FT> struct Matching_shape {
  FT alpha = FT(0);  ///< how far the lines across the edge lean along it
  FT beta = FT(1);   ///< the speed across the edge, compared with the first surface
  FT alpha2 = FT(0); ///< for \f$ G^2 \f$ and more
  FT delta = FT(0);  ///< for \f$ G^2 \f$ and more
  FT alpha3 = FT(0); ///< for \f$ G^3 \f$
  FT delta3 = FT(0); ///< for \f$ G^3 \f$
};

namespace internal {

// A surface with an edge as the start of v, and back.
template <class Surface> Surface with_edge_at_start(const Surface& s, Patch_edge edge) {
  switch (edge) {
  case Patch_edge::v0: return s;
  case Patch_edge::v1: return s.reverse_v();
  case Patch_edge::u0: return s.swap_parameters();
  default: return s.reverse_u().swap_parameters();
  }
}
template <class Surface> Surface with_start_at_edge(const Surface& s, Patch_edge edge) {
  switch (edge) {
  case Patch_edge::v0: return s;
  case Patch_edge::v1: return s.reverse_v();
  case Patch_edge::u0: return s.swap_parameters();
  default: return s.swap_parameters().reverse_u();
  }
}

// Matches surfaces as homogeneous or affine B-splines.
template <class A, class B> class Surface_match {
  typedef Blended_surfaces<A, B> Kind;
  typedef typename Kind::FT FT;
  typedef typename Kind::Row_traits Row_traits;
  static constexpr int N = Kind::N;
  typedef Bspline_surface<Row_traits> Spline;
  typedef Edge_spline<FT, N> Row;
  typedef Matching_shape<FT> Shape;
  static constexpr int most_order = 3;

  const int order_;
  Blend_end<FT, N> end_; // of the first surface
  Spline b_;             // the second one, with the edge at the start of v

  static Spline spline_of(const B& b) {
    if constexpr (Kind::is_rational) {
      if constexpr (Is_rational<B>::value)
        return Spline(b.homogeneous());
      else
        return Spline(Rational_surface<B>(b).homogeneous());
    } else
      return Spline(b);
  }

  static Blend_end<FT, N> end_of(const A& a, Patch_edge edge, int order) {
    // the second derivatives are always read
    const int rows = (std::max)(order, 2);
    if constexpr (Kind::is_rational && !Is_rational<A>::value)
      return {Rational_surface<A>(a), edge, 1, rows};
    else
      return {a, edge, 1, rows};
  }

  Row row(int j) const {
    std::vector<Coordinate_vector<FT, N>> c;
    for (int i = 0; i < b_.number_of_points_u(); ++i) c.push_back(b_.coordinates(i, j));
    return {b_.knots_u(), std::move(c)};
  }

  static Row times(const FT& x, const Row& r) {
    std::vector<Coordinate_vector<FT, N>> c = r.coefficients();
    for (Coordinate_vector<FT, N>& v : c) v *= x;
    return {r.knots(), std::move(c)};
  }

  // Adds a multiple, if it is not zero: derivatives along the edge would bring their knots.
  static void add(Row& sum, const FT& x, const Row& r) {
    if (x != FT(0)) sum = sum + times(x, r);
  }

  // The step of the control points over the derivative of order j + 1: with the differences
  // d^{j+1} c_i = (q - j) (d^j c_{i+1} - d^j c_i) / (v_{i+q+1} - v_{i+j+1}).
  FT step(int j, int i) const {
    const Knot_vector<FT>& v = b_.knots_v();
    const int q = v.degree();
    return FT((v[i + q + 1] - v[i + j + 1]) / FT(q - j));
  }

  // The derivatives of the second surface across the edge, up to the order.
  std::vector<Row> own_derivatives() const {
    std::vector<Row> c;
    for (int j = 0; j <= order_; ++j) c.push_back(row(j));
    for (int j = 0; j < order_; ++j)
      for (int i = order_; i > j; --i) c[i] = times(FT(1) / step(j, i - j - 1), c[i] + times(FT(-1), c[i - 1]));
    return c;
  }

  // The rows of control points with these derivatives at the edge.
  std::vector<Row> rows_of_derivatives(std::vector<Row> d) const {
    for (int j = order_ - 1; j >= 0; --j)
      for (int i = j + 1; i <= order_; ++i) d[i] = d[i - 1] + times(step(j, i - j - 1), d[i]);
    return d;
  }

  Row edge() const { return end_.spline(end_.edge); }
  Row cross() const { return end_.spline(end_.cross); }
  Row second() const { return end_.spline(end_.second_cross); }

  static Row derivative(Row r, int k) {
    for (; k > 0; --k) r = r.derivative();
    return r;
  }

  // Returns what the numbers of lower orders give to the derivative k of the matched surface.
  Row given(int k, const Shape& s) const {
    const FT &a = s.alpha, &b = s.beta;
    if (k == 1) return times(FT(0), edge());
    Row sum = k == 2 ? times(FT(b * b), second()) : times(FT(b * b * b), end_.spline(end_.third_cross));
    if (k == 2) {
      add(sum, FT(a * a), derivative(edge(), 2));
      add(sum, FT(2 * a * b), derivative(cross(), 1));
      return sum;
    }
    add(sum, FT(a * a * a), derivative(edge(), 3));
    add(sum, FT(3 * a * a * b), derivative(cross(), 2));
    add(sum, FT(3 * a * b * b), derivative(second(), 1));
    add(sum, FT(3 * a * s.alpha2), derivative(edge(), 2));
    add(sum, FT(3 * (a * s.delta + s.alpha2 * b)), derivative(cross(), 1));
    add(sum, FT(3 * b * s.delta), second());
    return sum;
  }

  static std::array<FT*, 2> free_numbers(Shape& s, int k) {
    if (k == 1) return {&s.alpha, &s.beta};
    if (k == 2) return {&s.alpha2, &s.delta};
    return {&s.alpha3, &s.delta3};
  }

  std::vector<Row> derivatives(Shape s) const {
    std::vector<Row> d{edge()};
    for (int k = 1; k <= order_; ++k) {
      const std::array<FT*, 2> x = free_numbers(s, k);
      d.push_back(given(k, s));
      add(d.back(), *x[0], derivative(edge(), 1));
      add(d.back(), *x[1], cross());
    }
    return d;
  }

  // Returns whether derivatives along the edge up to the order, and one more, are continuous at its
  // knots.
  bool is_smooth_along() const {
    const auto knots = end_.knots.inner_knots();
    return std::all_of(knots.begin(), knots.end(),
                       [&](const auto& knot) { return end_.knots.degree() - knot.multiplicity > order_; });
  }

  // A point or a vector at a parameter, rounded; of homogeneous rows without the division.
  static std::vector<double> rounded(const Row& r, const FT& u) {
    std::vector<double> x;
    const Coordinate_vector<FT, N> value = r(u);
    for (int i = 0; i < value.dimension(); ++i) x.push_back(CGAL::to_double(value[i]));
    return x;
  }

  // A number with few digits near a rounded one.
  static FT short_number(double x) {
    if (!std::isfinite(x) || x == 0) return FT(0);
    int e = 0;
    const double m = std::frexp(x, &e);
    return FT(std::ldexp(std::round(std::ldexp(m, 12)), e - 12));
  }

public:
  Surface_match(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, int order, Edge_direction direction)
      : order_(order), end_(end_of(a, edge_a, order)), b_(with_edge_at_start(spline_of(b), edge_b)) {
    if (a.dimension() != b.dimension()) throw Error(Error_code::dimension_mismatch, "match: of the two surfaces");
    if (order < 1 || most_order < order)
      throw Error(Error_code::negative_count, "match: the order is from 1 to 3, not " + std::to_string(order));
    end_.run_along(b_.knots_u().domain(), direction);
    b_ = b_.clamp();
    // as many rows stay as change, so that the surface continues its neighbour at the other end
    const int least = 2 * order + 1;
    if (b_.degree_v() < least) b_ = b_.elevate(0, least - b_.degree_v());
    if constexpr (Kind::is_rational) // with the weight of the second surface
      end_.scale(FT(b_.coordinates(0, 0)[N - 1] / end_.edge[0][N - 1]));
    for (const auto* r : {&end_.cross, &end_.edge})
      if (std::all_of(r->begin(), r->end(), [&](const auto& x) { return x == (*r)[0]; }) &&
          (r == &end_.edge || is_zero((*r)[0])))
        throw Error(Error_code::zero_tangent, r == &end_.edge ? "match: the edge of the first surface is a point"
                                                              : "match: the derivative across the edge of the first "
                                                                "surface vanishes");
  }

  // Returns numbers for which the derivatives across the edge change little: one order after the
  // other, those of least squares at points of the edge, in short numbers.
  Shape nearest_shape() const {
    Shape s;
    const std::vector<Row> own = own_derivatives();
    const std::pair<FT, FT> domain = end_.knots.domain();
    const bool leans = is_smooth_along();
    constexpr int samples = 16;
    for (int k = 1; k <= order_; ++k) {
      const Row rest = given(k, s), along = derivative(edge(), 1), across = cross();
      double aa = 0, ab = 0, bb = 0, ax = 0, bx = 0, xx = 0;
      for (int i = 0; i <= samples; ++i) {
        const FT u = FT(domain.first + (domain.second - domain.first) * FT(i) / FT(samples));
        const std::vector<double> x = rounded(own[k], u), g = rounded(rest, u), c = rounded(along, u),
                                  t = rounded(across, u);
        for (std::size_t d = 0; d < x.size(); ++d) {
          const double y = x[d] - g[d];
          aa += c[d] * c[d];
          ab += c[d] * t[d];
          bb += t[d] * t[d];
          ax += c[d] * y;
          bx += t[d] * y;
          xx += y * y;
        }
      }
      const double det = aa * bb - ab * ab;
      const bool both = leans && det > 1e-12 * aa * bb;
      double first = both ? (ax * bb - bx * ab) / det : 0, second = both ? (bx * aa - ax * ab) / det : bx / bb;
      if (k == 1 && !(second > 1e-3 * std::sqrt(xx / bb))) { // the second surface turns back
        first = 0;
        second = xx > 0 ? std::sqrt(xx / bb) : 1;
      }
      const std::array<FT*, 2> x = free_numbers(s, k);
      *x[0] = short_number(first);
      *x[1] = short_number(second);
    }
    return s;
  }

  typename Kind::Surface operator()(const Shape& shape, Patch_edge edge_b) const {
    if (!(FT(0) < shape.beta)) throw Error(Error_code::nonpositive_beta, "match: beta");
    std::vector<Row> rows = rows_of_derivatives(derivatives(shape));
    for (int j = order_ + 1; j < b_.number_of_points_v(); ++j) rows.push_back(row(j));
    unite(rows);
    const Knot_vector<FT>& u = rows[0].knots();
    check_not_torn(u);
    std::vector<std::vector<typename Row_traits::Point>> net(static_cast<std::size_t>(u.number_of_coefficients()));
    for (int i = 0; i < u.number_of_coefficients(); ++i)
      for (const Row& r : rows) net[static_cast<std::size_t>(i)].push_back(to_point<Row_traits>(r[i]));
    const Spline matched = with_start_at_edge(Spline(net, u, b_.knots_v()), edge_b);
    if constexpr (Kind::is_patch) {
      typedef Bezier_patch<Row_traits> Patch;
      std::vector<std::vector<typename Row_traits::Point>> points(
          static_cast<std::size_t>(matched.number_of_points_u()));
      for (int i = 0; i < matched.number_of_points_u(); ++i)
        for (int j = 0; j < matched.number_of_points_v(); ++j)
          points[static_cast<std::size_t>(i)].push_back(matched.control_point(i, j));
      return typename Kind::Surface(Patch(points, matched.domain_u(), matched.domain_v()));
    } else
      return typename Kind::Surface(matched);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the edges of two surfaces whose ends are nearest to each other, by the sum of the
/// squares of both distances: the common edge where there is one.
/// \throws Error `several_common_edges` with the names of two pairs when these are equally near;
///   `dimension_mismatch`
template <class Surface_a, class Surface_b>
std::pair<Patch_edge, Patch_edge> nearest_edges(const Surface_a& a, const Surface_b& b) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  typedef typename Kind::FT FT;
  std::pair<Patch_edge, Patch_edge> nearest, other;
  std::optional<FT> least;
  bool is_tie = false;
  const auto point = [](const auto& x) {
    if constexpr (Kind::is_rational)
      return affine_point(x);
    else
      return x;
  };
  for (const Patch_edge edge_a : patch_edges)
    for (const Patch_edge edge_b : patch_edges) {
      const auto ends = Kind::ends(a, edge_a, b, edge_b, Edge_direction::same);
      const auto square = [](const auto& x) -> FT { return dot(x, x); };
      const auto p = point(ends.first.edge.front()), q = point(ends.first.edge.back()),
                 r = point(ends.second.edge.front()), s = point(ends.second.edge.back());
      const FT distance = (std::min)(FT(square(p - r) + square(q - s)), FT(square(p - s) + square(q - r)));
      if (least && *least < distance) continue;
      is_tie = least && *least == distance;
      if (is_tie)
        other = {edge_a, edge_b};
      else
        nearest = {edge_a, edge_b};
      least = distance;
    }
  const auto names = [](const std::pair<Patch_edge, Patch_edge>& pair) {
    return to_string(pair.first) + ',' + to_string(pair.second);
  };
  if (is_tie)
    throw Error(Error_code::several_common_edges,
                "match: the edges " + names(nearest) + " and " + names(other) + " are equally near; name them");
  return nearest;
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape of a match of which the derivatives across the edge differ little from those
/// of the second surface: one order after the other by least squares at 17 points of the edge,
/// rounded to 12 binary digits. Where the second surface turns back, \f$ \beta \f$ is the quotient
/// of the speeds, and \f$ \alpha = 0 \f$. Where the derivative of order `order + 1` along the edge
/// of the first surface jumps, all \f$ \alpha \f$ are 0, so that the surface is as smooth there.
/// \throws Error as `match()` does
template <class Surface_a, class Surface_b>
Matching_shape<typename Surface_b::FT> nearest_matching_shape(const Surface_a& a, Patch_edge edge_a, const Surface_b& b,
                                                              Patch_edge edge_b, int order, Edge_direction direction) {
  return internal::Surface_match<Surface_a, Surface_b>(a, edge_a, b, edge_b, order, direction).nearest_shape();
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the second surface with its edge on that of the first one and, along the whole edge,
/// \f$ G^1 \f$, \f$ G^2 \f$ or \f$ G^3 \f$ with it, wherever the normals of the first surface do not
/// vanish there. With an exact kernel that is exact, as `edge_continuity()` proves.
///
/// Only the `order + 1` rows of control points next to the edge change. The degree across the edge
/// is raised to at least `2 order + 1` before, so that at the opposite edge the surface keeps its
/// derivatives up to the order; along the edge degrees are raised and knots united where they
/// differ. The edge of the first surface is mapped affinely to the domain of that of the second
/// one. With rational surfaces homogeneous rows are matched; the weights next to the edge become
/// those of the first surface, times a number. The result is a patch when both surfaces are.
///
/// \param order 1, 2 or 3
/// \param shape the numbers that are free, of which those up to the order are read
/// \param direction how the second edge runs in comparison with the first one
/// \tparam Surface_a, Surface_b `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`, with one traits class
/// \throws Error `nonpositive_beta` unless \f$ \beta > 0 \f$; `zero_tangent` when the edge of the
///   first surface is a point, or the derivative across it vanishes; `knot_multiplicity` when a
///   derivative along it jumps that \f$ \alpha \f$ multiplies; `negative_count` for another order; `dimension_mismatch`; `zero_weight` when a weight is not positive; `not_finite` when
///   floating-point numbers overflow
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> match(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          int order, const Matching_shape<typename Surface_b::FT>& shape,
                                          Edge_direction direction) {
  return internal::Surface_match<Surface_a, Surface_b>(a, edge_a, b, edge_b, order, direction)(shape, edge_b);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the second surface matched to the first one with `nearest_matching_shape()`, where its
/// edge runs in `nearer_direction()`.
/// \throws Error as the function with a shape
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> match(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                                          int order = 2) {
  const internal::Surface_match<Surface_a, Surface_b> match(a, edge_a, b, edge_b, order,
                                                            nearer_direction(a, edge_a, b, edge_b));
  return match(match.nearest_shape(), edge_b);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the second surface matched to the first one along their `nearest_edges()`.
/// \throws Error as the function with edges, and `several_common_edges`
template <class Surface_a, class Surface_b>
Blend_surface<Surface_a, Surface_b> match(const Surface_a& a, const Surface_b& b, int order = 2) {
  const auto [edge_a, edge_b] = nearest_edges(a, b);
  return match(a, edge_a, b, edge_b, order);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_MATCH_H
