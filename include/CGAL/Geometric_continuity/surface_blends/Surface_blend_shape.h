// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/blend_ends.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Side_corner.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Surface_blend_shape.h
/// The functions along its edges that \f$ G^2 \f$ leaves free of a blend surface, the types of such
/// surfaces, and the shape for which the side curves at `u = 0` and `u = 1` are given, and the
/// derivatives across them.
///
/// Where an edge ends, \f$ S_v = \alpha C' + \beta T \f$ and
/// \f$ S_{vv} = \alpha^2 C'' + 2\alpha\beta T' + \beta^2 W + \alpha_2 C' + \delta T \f$ are the
/// first two derivatives of the side curve. So it must start in the tangent plane of the surface,
/// and with the curvature of the surface in its direction; then the values of the functions are the
/// coordinates with respect to \f$ C', T \f$ of what it leaves. Derivatives with respect to `u` of
/// these equations give the slopes of the functions, where \f$ S_u \f$ is given along the side.
/// Both ends together determine a side curve and a derivative of degree 5 as a whole. Homogeneous
/// points have the vectors \f$ C', T, C \f$ and the functions \f$ \lambda_1, \lambda_2 \f$ as well.
/// For a blend of degree 7 the side curve must have the third derivative of the surface, too, and
/// the same follows for \f$ \alpha_3, \delta_3, \lambda_3 \f$.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// The way in which a blend leaves the parameters of a surface along an edge, or enters them:
/// \f$ \varphi(u, v) = (u + \alpha v + \frac12 \alpha_2 v^2,\ \beta v + \frac12 \delta v^2) \f$ to
/// second order, with functions of the parameter along the edge: numbers, polynomials or splines on
/// the domain of the edge, which is mapped to [0, 1].
/// \tparam FT_ a field number type
template <class FT_> struct Edge_reparametrisation {
  typedef FT_ FT;                     ///< the number type
  typedef Edge_function<FT> Function; ///< a function of the parameter along the edge

  Function alpha = Function{FT(0)};  ///< the first derivative along the edge
  Function beta = Function{FT(1)};   ///< the first derivative across the edge, positive
  Function alpha2 = Function{FT(0)}; ///< the second derivative along the edge
  Function delta = Function{FT(0)};  ///< the second derivative across the edge
};

/// \ingroup PkgGeometricContinuityConstruction
/// The way in which a blend leaves the parameters of a rational surface:
/// \f$ S = \lambda \cdot L \circ \varphi \f$ in homogeneous points, to second order, with the
/// factors \f$ \lambda_0 \f$ and \f$ 1 + \lambda_1 v + \frac12 \lambda_2 v^2 \f$.
/// \tparam FT a field number type
template <class FT> struct Rational_edge_reparametrisation : Edge_reparametrisation<FT> {
  /// a function of the parameter along the edge
  typedef typename Edge_reparametrisation<FT>::Function Function;

  FT lambda = FT(1);                  ///< the factor at the edge, positive
  Function lambda1 = Function{FT(0)}; ///< the first derivative of the other factor across the edge
  Function lambda2 = Function{FT(0)}; ///< its second derivative

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Rational_edge_reparametrisation() = default;
  /// Takes a polynomial reparametrisation, with the factor 1.
  Rational_edge_reparametrisation(const Edge_reparametrisation<FT>& r) : Edge_reparametrisation<FT>(r) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Surface_blend_shape {
  Edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Edge_reparametrisation<FT> end;   ///< at the edge of the second surface
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a rational blend surface: all that \f$ G^2 \f$ leaves free at its two edges.
/// \tparam FT a field number type
template <class FT> struct Rational_surface_blend_shape {
  Rational_edge_reparametrisation<FT> start; ///< at the edge of the first surface
  Rational_edge_reparametrisation<FT> end;   ///< at the edge of the second surface

  /// Sets all functions \f$ \beta \f$ to 1 and all others to 0.
  Rational_surface_blend_shape() = default;
  /// Takes the reparametrisations of both ends.
  Rational_surface_blend_shape(const Rational_edge_reparametrisation<FT>& given_start,
                               const Rational_edge_reparametrisation<FT>& given_end)
      : start(given_start), end(given_end) {}
  /// Takes a polynomial shape, with the factor 1 at both ends.
  Rational_surface_blend_shape(const Surface_blend_shape<FT>& shape) : start(shape.start), end(shape.end) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The functions that \f$ G^3 \f$ leaves free at an edge of a blend surface, in addition to a
/// reparametrisation of order 2: the third derivatives of \f$ \varphi \f$, which are
/// \f$ (\alpha_3, \delta_3) \f$, and that of the factor of homogeneous points.
/// \tparam Reparametrisation `Edge_reparametrisation` or `Rational_edge_reparametrisation`
template <class Reparametrisation> struct Septic_edge_reparametrisation : Reparametrisation {
  typedef typename Reparametrisation::FT FT;             ///< the number type
  typedef typename Reparametrisation::Function Function; ///< a function of the parameter along the edge

  Function alpha3 = Function{FT(0)}; ///< the third derivative along the edge
  Function delta3 = Function{FT(0)}; ///< the third derivative across the edge
  // the third derivative of the factor of a rational surface across the edge; not used for others
  Function lambda3 = Function{FT(0)};

  /// Sets \f$ \beta \f$ to 1 and all others to 0.
  Septic_edge_reparametrisation() = default;
  /// Takes numbers up to order 2; the third derivatives are 0.
  Septic_edge_reparametrisation(const Reparametrisation& r) : Reparametrisation(r) {}
};

/// \ingroup PkgGeometricContinuityConstruction
/// The shape of a blend surface of degree 7 across: all that \f$ G^3 \f$ leaves free at its two
/// edges.
/// \tparam Shape `Surface_blend_shape` or `Rational_surface_blend_shape`
template <class Shape> struct Septic_surface_blend_shape {
  typedef Septic_edge_reparametrisation<decltype(Shape::start)> Reparametrisation; ///< at one edge

  Reparametrisation start; ///< at the edge of the first surface
  Reparametrisation end;   ///< at the edge of the second surface

  /// Sets all functions \f$ \beta \f$ to 1 and all others to 0.
  Septic_surface_blend_shape() = default;
  /// Takes numbers up to order 2; the third derivatives are 0.
  Septic_surface_blend_shape(const Shape& shape) : start(shape.start), end(shape.end) {}
};

namespace internal {

template <class A, class B> struct Blended_shape {
  typedef typename A::FT FT;
  typedef std::conditional_t<Blended_surfaces<A, B>::is_rational, Rational_surface_blend_shape<FT>,
                             Surface_blend_shape<FT>>
      type;
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the blend of two surfaces: `Bezier_patch` or `Rational_bezier_patch` of two patches,
/// otherwise `Bspline_surface` or `Rational_bspline_surface`; rational if one of them is.
template <class Surface_a, class Surface_b>
using Blend_surface = typename internal::Blended_surfaces<Surface_a, Surface_b>::Surface;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape of the blend of two surfaces: `Rational_surface_blend_shape` if one of
/// them is rational, otherwise `Surface_blend_shape`.
template <class Surface_a, class Surface_b>
using Blend_surface_shape = typename internal::Blended_shape<Surface_a, Surface_b>::type;

/// \ingroup PkgGeometricContinuityStrategies
/// Chooses the fairest blend of two surfaces among those with constants for functions that have no
/// fold: the least mean of the variations of curvature of the curves `u` = const, see
/// `mean_fairness()`. Of surfaces only.
///
/// It starts from the shapes of `Matching_second_derivative`, `Minimal_energy<2>`,
/// `Minimal_energy<3>` and `Fair`, and from a grid of \f$ \beta \f$ and \f$ \delta \f$ at both
/// ends. From the four fairest of these starts it goes down by the method of Levenberg and
/// Marquardt, where \f$ \beta \f$ stays within a factor of 16 of the automatic shape. Where
/// `possible_fold()` does not prove that the fairest blend found so has no fold, it also goes down
/// from four starts that have none: no step leads into a fold, and at last one number is changed at
/// a time. The fairest blend without a fold is taken. So it is never less fair than the blends of
/// those four strategies that have no fold, and there is nearly always one without a fold where any
/// constants give one. Where all that is found has folds, it is the fairest of this, as it is in
/// other dimensions than 3. The order of the two surfaces makes no difference but for rounding.
struct Fairest {};

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces of degree 5: `Fairest`, or one that
/// can be called with `Quintic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_quintic_surface_strategy_v =
    std::disjunction_v<std::is_same<Strategy, Fairest>,
                       std::is_invocable<const Strategy&, const Quintic_ends<double, 0>&>>;

/// \ingroup PkgGeometricContinuityStrategies
/// True for a strategy that chooses the shape of blend surfaces, of degree 5 or else of degree 7:
/// `Fairest`, or one that can be called with `Quintic_ends<double, 0>` or `Septic_ends<double, 0>`.
template <class Strategy>
constexpr bool is_surface_blend_strategy_v =
    std::disjunction_v<std::is_same<Strategy, Fairest>,
                       std::is_invocable<const Strategy&, const Quintic_ends<double, 0>&>,
                       std::is_invocable<const Strategy&, const Septic_ends<double, 0>&>>;

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the shape that a strategy chooses for the blend of two surfaces:
/// `Blend_surface_shape`, or the `Septic_surface_blend_shape` of it.
template <class Surface_a, class Surface_b, class Strategy>
using Chosen_surface_shape =
    std::conditional_t<is_quintic_surface_strategy_v<Strategy>, Blend_surface_shape<Surface_a, Surface_b>,
                       Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>>;

/// \ingroup PkgGeometricContinuityConstruction
/// Returns how the second of two edges runs when its ends are nearer to those of the first one: in
/// the same direction unless the lines between the ends of the edges point in opposite directions.
/// \throws Error `dimension_mismatch`
template <class Surface_a, class Surface_b>
Edge_direction nearer_direction(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b) {
  typedef internal::Blended_surfaces<Surface_a, Surface_b> Kind;
  typedef typename Kind::FT FT;
  const auto ends = Kind::ends(a, edge_a, b, edge_b, Edge_direction::same);
  const auto chord = [](const auto& row) {
    if constexpr (Kind::is_rational)
      return affine_point(row.back()) - affine_point(row.front());
    else
      return row.back() - row.front();
  };
  return dot(chord(ends.first.edge), chord(ends.second.edge)) < FT(0) ? Edge_direction::opposite : Edge_direction::same;
}

/// \ingroup PkgGeometricContinuityConstruction
/// The required side edge of a blend surface of degree 5 or 7, from the first surface to the
/// second.
/// \tparam Traits_ the traits class of the points; for a blend with a rational surface
///   `Homogeneous_traits` of it
template <class Traits_> struct Blend_side {
  typedef Traits_ Traits;                       ///< the traits class of the points
  typedef typename Traits::FT FT;               ///< the field
  typedef std::vector<Coordinates<Traits>> Row; ///< Bernstein coefficients, at most 6 or 8

  Row curve; ///< the side curve on [0, 1]
  /// the derivative across it, out of the blend, up to a positive factor that is linear along the
  /// side; or none
  Row cross;

  /// Takes coefficients.
  explicit Blend_side(Row given_curve, Row given_cross = {})
      : curve(std::move(given_curve)), cross(std::move(given_cross)) {}

  /// Takes a curve, on whatever domain.
  template <int Degree> Blend_side(const Bezier_curve<Traits, Degree>& c) {
    for (int i = 0; i <= c.degree(); ++i) curve.push_back(coordinates<Traits>(c.control_point(i)));
  }

  /// Takes an edge of a neighbour of the blend, and the derivative across it: with them, the blend
  /// is \f$ G^1 \f$ with the neighbour.
  /// \param direction `same` if the edge runs from the first surface to the second
  /// \throws Error `knot_multiplicity` when the edge has inner knots
  template <class Surface, class = std::enable_if_t<std::is_same_v<
                               Traits, typename internal::Blended_surfaces<Surface, Surface>::Row_traits>>>
  Blend_side(const Surface& neighbour, Patch_edge edge, Edge_direction direction = Edge_direction::same) {
    internal::Blend_end<FT, dimension_v<Traits>> end(neighbour, edge, -1, 2);
    if (static_cast<int>(end.edge.size()) > end.knots.degree() + 1)
      throw Error(Error_code::knot_multiplicity, "Blend_side: the edge " + to_string(edge) + " has inner knots");
    end.run_along(end.knots.domain(), direction);
    curve = std::move(end.edge);
    cross = std::move(end.cross);
  }

  /// Takes a side of points as one of homogeneous points, with the weight 1.
  template <class Of_points, class = std::enable_if_t<std::is_same_v<Traits, Homogeneous_traits<Of_points>>>>
  Blend_side(const Blend_side<Of_points>& side) {
    const auto lift = [](const auto& row, Row& to, int weight) {
      for (const auto& x : row) {
        to.emplace_back(x.dimension() + 1);
        for (int i = 0; i < x.dimension(); ++i) to.back()[i] = x[i];
        to.back()[x.dimension()] = FT(weight);
      }
    };
    lift(side.curve, curve, 1);
    lift(side.cross, cross, 0);
  }

  /// Returns the side without a derivative across it.
  Blend_side curve_only() const { return Blend_side(curve); }
};

/// \ingroup PkgGeometricContinuityConstruction
/// The type of the sides of the blend of two surfaces.
template <class Surface_a, class Surface_b>
using Side_of_blend = Blend_side<typename internal::Blended_surfaces<Surface_a, Surface_b>::Row_traits>;

namespace internal {

// The shape with sides, one after the other. `order` is that of the blend.
template <class A, class B, int order> class Shape_with_sides {
  typedef Blended_surfaces<A, B> Kind;
  typedef typename Kind::FT FT;
  static constexpr int N = Kind::N, degree = 2 * order + 1;
  typedef Coordinate_vector<FT, N> Vector;
  typedef Number_and_slope<FT> Number;
  typedef typename Side_of_blend<A, B>::Row Row;
  typedef Side_corner<Kind::is_rational, FT, N, order> Corner;
  typedef std::conditional_t<order == 2, Blend_surface_shape<A, B>,
                             Septic_surface_blend_shape<Blend_surface_shape<A, B>>>
      Shape;

  const std::pair<typename Kind::End, typename Kind::End> ends_;
  const std::array<std::string, 2> edges_; // their names
  FT length_;                              // of the domain
  Shape shape_;
  // of each edge, at the start and at the end
  std::array<std::array<std::optional<Corner>, 2>, 2> corners_;

public:
  Shape_with_sides(const A& a, Patch_edge edge_a, const B& b, Patch_edge edge_b, Edge_direction direction,
                   const Shape& shape)
      : ends_(Kind::ends(a, edge_a, b, edge_b, direction, order)), edges_{"the edge " + to_string(edge_a) +
                                                                              " of the first surface",
                                                                          "the edge " + to_string(edge_b) +
                                                                              " of the second surface"},
        shape_(shape) {
    const std::pair<FT, FT> domain = ends_.first.knots.domain();
    length_ = FT(domain.second - domain.first);
  }

  void take(const Side_of_blend<A, B>& side, bool upper) {
    const std::string place = std::string("u = ") + (upper ? "1" : "0") + ", ";
    corners_[0][upper].emplace(ends_.first, upper, place + edges_[0]);
    corners_[1][upper].emplace(ends_.second, upper, place + edges_[1]);
    Corner &start = *corners_[0][upper], &end = *corners_[1][upper];
    Row curve = side.curve, cross = side.cross;
    if constexpr (Kind::is_rational) take_factor(curve, cross, start, end, upper);
    elevate(curve, place + "the curve");
    start.take_curve(derivatives(curve, 0));
    // equivalent [1 -> 2, 1]: any number but 0 is the other end
    end.take_curve(derivatives(curve, 1));
    if (cross.empty()) return;
    if (!upper)
      for (Vector& x : cross) x *= FT(-1);
    const FT at_start = start.ratio(cross.front()), at_end = end.ratio(cross.back());
    multiply(cross, at_start, at_end);
    elevate(cross, place + "the derivative across it");
    start.take_cross(derivatives(cross, 0));
    end.take_cross(derivatives(cross, 1));
  }

  Shape shape() {
    assemble(shape_.start, corners_[0]);
    assemble(shape_.end, corners_[1]);
    return shape_;
  }

private:
  // The side is multiplied by a number so that it fits the first surface; then the second one is.
  void take_factor(Row& curve, Row& cross, const Corner& start, Corner& end, bool upper) {
    const FT factor = dot(start.point(), curve.front()) / dot(curve.front(), curve.front());
    for (Row* row : {&curve, &cross})
      for (Vector& x : *row) x *= factor;
    const FT lambda = dot(curve.back(), end.point()) / dot(end.point(), end.point());
    end.scale(lambda);
    end.check_point(curve.back());
    if (upper && corners_[1][0] && lambda != shape_.end.lambda)
      end.refuse(Error_code::incompatible_corner,
                 "the weights of the side curve, after those of the one at u = 0, belong to another factor");
    shape_.start.lambda = FT(1);
    shape_.end.lambda = lambda;
  }

  // By the linear function with the values f and g.
  static void multiply(Row& row, const FT& f, const FT& g) {
    if (f == g) {
      for (Vector& x : row) x *= f;
      return;
    }
    const int n = static_cast<int>(row.size());
    Row product;
    for (int i = 0; i <= n; ++i) {
      product.emplace_back(row[0].dimension());
      if (i < n) product.back() += FT(FT(n - i) / FT(n) * f) * row[i];
      if (i > 0) product.back() += FT(FT(i) / FT(n) * g) * row[i - 1];
    }
    row = std::move(product);
  }

  static void elevate(Row& row, const std::string& place) {
    const int n = static_cast<int>(row.size()) - 1;
    if (n < 0 || n > degree)
      throw Error(Error_code::wrong_number_of_points, "blend sides: " + place + ": the degree must be at most " +
                                                          std::to_string(degree) + ", it is " + std::to_string(n));
    row.resize(degree + 1, row[0]);
    for (int i = n; i < degree; ++i) bernstein_elevate<FT>(row, i);
  }

  // At v = 0 or 1.
  static std::array<Vector, order + 1> derivatives(Row b, int v) {
    if (v == 1) std::reverse(b.begin(), b.end());
    std::array<Vector, order + 1> d;
    int factor = 1;
    for (int n = 0; n <= order; ++n) {
      d[n] = FT(factor) * b[0];
      for (int i = 0; i < order - n; ++i) b[i] = b[i + 1] - b[i]; // differences
      factor *= (v == 0 ? 1 : -1) * (degree - n);
    }
    return d;
  }

  template <class Reparametrisation>
  void assemble(Reparametrisation& r, const std::array<std::optional<Corner>, 2>& corners) const {
    if (!corners[0] && !corners[1]) return;
    typedef typename Reparametrisation::Function Function;
    // those that belong to C', T and C in the derivatives across the edge
    std::array<std::array<Function*, 3>, order> functions{{{&r.alpha, &r.beta}, {&r.alpha2, &r.delta}}};
    if constexpr (Kind::is_rational) {
      functions[0][2] = &r.lambda1;
      functions[1][2] = &r.lambda2;
    }
    if constexpr (order == 3) {
      functions[2] = {&r.alpha3, &r.delta3};
      if constexpr (Kind::is_rational) functions[2][2] = &r.lambda3;
    }
    typedef std::array<std::array<Edge_end_value<FT>, 3>, order> Values;
    const auto values = [&](int upper) {
      Values v;
      const std::optional<Corner>& c = corners[upper];
      for (int n = 0; n < order; ++n)
        for (std::size_t i = 0; i < 3; ++i) {
          if (!functions[n][i]) continue;
          if (!c) {
            v[n][i].value = (*functions[n][i])(FT(upper));
            continue;
          }
          // without what lambda_1 and lambda_2 contribute: S = (1 + lambda_1 v + ...) P
          Number x = c->free(n + 1, i);
          if (i < 2 && n == 1) x = x - 2 * c->free(1, 2) * c->free(1, i);
          if (i < 2 && n == 2) {
            const Number second = c->free(2, i) - 2 * c->free(1, 2) * c->free(1, i);
            x = x - 3 * (c->free(1, 2) * second + c->free(2, 2) * c->free(1, i));
          }
          v[n][i].value = x.value;
          if (c->has_slopes) v[n][i].slope = FT(x.slope * length_);
        }
      if (!c && !(FT(0) < v[0][1].value))
        throw Error(Error_code::nonpositive_beta,
                    "blend sides: u = " + std::to_string(upper) + ", where no side is given: the shape");
      return v;
    };
    const Values start = values(0), end = values(1);
    for (int n = 0; n < order; ++n)
      for (std::size_t i = 0; i < 3; ++i)
        if (functions[n][i])
          *functions[n][i] = interpolating_function(start[n][i], end[n][i], functions[n][i] == &r.beta);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape of a blend of degree 5 whose side edges at `u = 0` and `u = 1`, where the
/// edges of both surfaces start and end, are given curves, and whose derivatives across them are,
/// if they are given. The blend `blend(a, edge_a, b, edge_b, shape, direction)` has them exactly,
/// with an exact kernel, and is \f$ G^2 \f$ with both surfaces as any other.
///
/// The functions of the shape are the polynomials of least degree along the edges that have the
/// values and slopes which follow at the corners: linear for curves, cubic with derivatives across
/// them. Where a cubic \f$ \beta \f$ is not positive, it is a cubic spline that is; then the
/// surfaces must be B-spline surfaces. A side that is not given has the values of `shape` there.
///
/// Blends of consecutive edges meet, if the next one is given
/// `Blend_side(previous, Patch_edge::u1).curve_only()` at `u = 0`: where two surfaces join with
/// \f$ G^2 \f$, a side curve that fits the one at a corner fits the other. With the derivative they
/// join with \f$ G^1 \f$, if the surfaces go on to the third order, as parts of one surface do.
/// \param shape what is not given follows from it, e.g. that of `automatic_surface_shape()`
/// \param at_start, at_end the sides at `u = 0` and `u = 1` of the blend
/// \throws Error `curves_do_not_meet` where a side curve does not end at the corner of a surface;
///   `incompatible_corner` where what is given contradicts a surface at a corner: the error names
///   the side, the surface and the derivative, \f$ S_v, S_{vv}, S_u, S_{uv} \f$ or \f$ S_{uvv} \f$,
///   and for rational blends the weights. With floating-point numbers all this is decided up to
///   rounding
/// \throws Error `nonpositive_beta` where a side curve leads to the wrong side of an edge, or
///   `shape` does where no side is given; `not_finite` where floating-point numbers overflow,
///   `singular_frame` where the normal of a surface vanishes at a corner, `wrong_number_of_points`
///   for a degree of more than 5, `dimension_mismatch`
template <class Surface_a, class Surface_b>
Blend_surface_shape<Surface_a, Surface_b>
surface_shape_with_sides(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                         Edge_direction direction, const Blend_surface_shape<Surface_a, Surface_b>& shape,
                         const std::optional<Side_of_blend<Surface_a, Surface_b>>& at_start,
                         const std::optional<Side_of_blend<Surface_a, Surface_b>>& at_end) {
  internal::Shape_with_sides<Surface_a, Surface_b, 2> r(a, edge_a, b, edge_b, direction, shape);
  if (at_start) r.take(*at_start, false);
  if (at_end) r.take(*at_end, true);
  return r.shape();
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns the shape of a blend of degree 7 with given sides, as for degree 5: it is \f$ G^3 \f$
/// with both surfaces. A side curve has up to 8 coefficients, and the third derivative of a surface
/// where it ends; with a derivative across it, also \f$ S_{uvvv} \f$ is determined at the corners,
/// and the error `incompatible_corner` names \f$ S_{vvv} \f$ or \f$ S_{uvvv} \f$ where it
/// contradicts.
/// \throws Error as for degree 5; `wrong_number_of_points` for a degree of more than 7
template <class Surface_a, class Surface_b>
Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>
surface_shape_with_sides(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b,
                         Edge_direction direction,
                         const Septic_surface_blend_shape<Blend_surface_shape<Surface_a, Surface_b>>& shape,
                         const std::optional<Side_of_blend<Surface_a, Surface_b>>& at_start,
                         const std::optional<Side_of_blend<Surface_a, Surface_b>>& at_end) {
  internal::Shape_with_sides<Surface_a, Surface_b, 3> r(a, edge_a, b, edge_b, direction, shape);
  if (at_start) r.take(*at_start, false);
  if (at_end) r.take(*at_end, true);
  return r.shape();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_SURFACE_BLEND_SHAPE_H
