// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_CUT_BACK_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_CUT_BACK_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file cut_back.h
/// A surface without a strip along one of its edges, as it is needed where something else is put in
/// the place of the edge: exactly, or with a proven deviation where a curve crosses the knot lines
/// of a B-spline surface.
///
/// Let such a curve run between \f$ v = a \f$ and \f$ v = b \f$. In this strip, widened by a
/// quarter, the surface is replaced by one that is a single polynomial in `v`: that which
/// interpolates it, with as many derivatives as the degree where the strip begins, so that it is as
/// smooth there as before, and at points up to its end. Then what lies below the curve is a
/// polynomial surface, exactly. How far the two are apart is bounded by the Bernstein coefficients
/// of their difference on all spans.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the surface without the strip of a constant width along an edge: for the edge `v = d` of
/// a surface on [a, b] x [c, d] the part on [a, b] x [c, d - distance], with the same parameters. A
/// Bézier patch is split, knots of a B-spline surface are inserted. Exact with an exact kernel.
/// \param surface a `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance in the parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is positive and less than the
///   length of the domain, with the edge; `not_finite` when floating-point numbers overflow
template <class Surface>
Surface cut_back(const Surface& surface, Patch_edge edge, const typename Surface::FT& distance) {
  typedef typename Surface::FT FT;
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const FT cut = at_upper_end(edge) ? FT(domain.second - distance) : FT(domain.first + distance);
  if (!(domain.first < cut && cut < domain.second))
    throw Error(Error_code::parameter_outside_domain, "cut_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge");
  const auto parts = runs_along_u(edge) ? surface.split_v(cut) : surface.split_u(cut);
  return at_upper_end(edge) ? parts.first : parts.second;
}

namespace internal {

// S(u, c + w(u) (v - c)) with 0 < w < 1 on the domain of u, mapped to [0, 1]: of a surface with one
// span in v, from c on, by the algorithm of de Casteljau, whose parameter is a function of u.
template <class Traits>
Bspline_surface<Traits> part_of_span(const Bspline_surface<Traits>& s,
                                     const Bernstein_polynomial<typename Traits::FT>& w) {
  typedef typename Traits::FT FT;
  typedef Bspline_function<FT, Coordinates<Traits>> Row; // of constant j
  const int q = s.degree_v(), m = w.degree();
  const Knot_vector<FT> knots(m, s.domain_u().first, s.domain_u().second);
  const Bernstein_polynomial<FT> rest = Bernstein_polynomial<FT>{FT(1)} - w;
  const Bspline_function<FT> f(knots, w.coefficients()), g(knots, rest.elevated(m - rest.degree()).coefficients());
  std::vector<Row> row;
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> c;
    for (int i = 0; i < s.knots_u().number_of_coefficients(); ++i) c.push_back(s.coordinates(i, j));
    row.emplace_back(s.knots_u(), std::move(c));
  }
  std::vector<Row> column; // of the result
  for (int r = 0; r <= q; ++r) {
    column.push_back(row[0].elevate((q - r) * m));
    for (int j = 0; j < q - r; ++j) row[j] = g * row[j] + f * row[j + 1];
  }
  const Knot_vector<FT>& u = column[0].knots();
  std::vector<std::vector<typename Traits::Point>> net(u.number_of_coefficients());
  for (int i = 0; i < u.number_of_coefficients(); ++i)
    for (const Row& c : column) net[i].push_back(to_point<Traits>(c[i]));
  return Bspline_surface<Traits>(net, u, s.knots_v());
}

// One surface from two, over the same knots in u, where the second one begins in v where the first
// one ends; `jump` tells whether there the first one does not lead to the second one.
template <class Traits>
Bspline_surface<Traits> joined_in_v(const Bspline_surface<Traits>& a, const Bspline_surface<Traits>& b, bool jump) {
  typedef typename Traits::FT FT;
  const int q = b.degree_v(), first = jump ? 0 : 1; // row of the second surface
  std::vector<FT> v(a.knots_v().begin(), a.knots_v().end() - first);
  v.insert(v.end(), b.knots_v().begin() + q + 1, b.knots_v().end());
  std::vector<std::vector<typename Traits::Point>> net(a.knots_u().number_of_coefficients());
  for (int i = 0; i < a.knots_u().number_of_coefficients(); ++i) {
    for (int j = 0; j < a.knots_v().number_of_coefficients(); ++j) net[i].push_back(a.control_point(i, j));
    for (int j = first; j <= q; ++j) net[i].push_back(b.control_point(i, j));
  }
  return Bspline_surface<Traits>(net, a.knots_u(), Knot_vector<FT>(q, std::move(v)));
}

// The length across the edge without the distance from it, which must lie between both everywhere.
template <class Surface>
Bernstein_polynomial<typename Surface::FT>
height_below_curve(const Surface& surface, Patch_edge edge,
                   const Bernstein_polynomial<typename Surface::FT>& distance) {
  typedef typename Surface::FT FT;
  const typename Surface::Interval domain = runs_along_u(edge) ? surface.domain_v() : surface.domain_u();
  const Bernstein_polynomial<FT> rest = Bernstein_polynomial<FT>{FT(domain.second - domain.first)} - distance;
  if (sign_pattern(distance) != Sign_pattern::positive || sign_pattern(rest) != Sign_pattern::positive)
    throw Error(Error_code::parameter_outside_domain, "cut_back: the distance from the edge " + to_string(edge) +
                                                          " does not lie between 0 and the other edge everywhere");
  return rest;
}

// The surface f(s) in its own parameters, where s is the surface in those in which the edge is v1.
template <class Surface, class Function>
Surface turned_to_v1(const Surface& surface, Patch_edge edge, const Function& f) {
  const auto turn = [&](const Surface& s) { return at_upper_end(edge) ? s : s.reverse_v(); };
  const Surface turned = turn(f(turn(runs_along_u(edge) ? surface : surface.swap_parameters())));
  return runs_along_u(edge) ? turned : turned.swap_parameters();
}

// Without the strip beyond v = c + height(u), inside of the domain [c, d].
template <class Surface>
Surface part_below(const Surface& s, const Bernstein_polynomial<typename Surface::FT>& height, Patch_edge edge) {
  typedef typename Surface::FT FT;
  typedef Bernstein_polynomial<FT> Polynomial;
  if constexpr (Is_rational<Surface>::value)
    return Surface(part_below(s.homogeneous(), height, edge));
  else if constexpr (!Surface_shape<Surface>::is_spline) {
    const auto t = part_below(Bspline_surface<typename Surface::Traits>(s), height, edge);
    return Surface(t.degree_u(), t.degree_v(), std::vector<typename Surface::Traits::Point>(t.begin(), t.end()),
                   s.domain_u(), s.domain_v());
  } else {
    const Surface clamped = s.clamp();
    const Knot_vector<FT>& v = clamped.knots_v();
    const FT& knot = v[v.number_of_coefficients() - 1];
    const auto part = [&](const Surface& of, const Polynomial& h) {
      return part_of_span(of, Polynomial{FT(FT(1) / (v.domain().second - knot))} * h);
    };
    if (knot == v.domain().first) return part(clamped, height);
    const Polynomial beyond = height - Polynomial{FT(knot - v.domain().first)};
    if (sign_pattern(beyond) != Sign_pattern::positive)
      throw Error(Error_code::parameter_outside_domain, "cut_back: the curve is not everywhere between the edge " +
                                                            to_string(edge) + " and the knot line next to it");
    const std::pair<Surface, Surface> parts = clamped.split_v(knot);
    const Surface strip = part(parts.second, beyond);
    return joined_in_v(parts.first.elevate(strip.degree_u() - s.degree_u(), 0), strip,
                       v.multiplicity(knot) > s.degree_v());
  }
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the part of a surface between the opposite edge and a curve in the parameter plane: for
/// the edge `v = d` of a surface on [a, b] x [c, d] the part with \f$ c \le v \le d - f(u) \f$. The
/// new edge has the parameter of the old one; along each line of constant `u` the other parameter
/// runs in proportion, of a B-spline surface from the knot line on that is next to the edge, where
/// the knot gets the multiplicity of the degree: up to there it keeps its parameters. Exact with an
/// exact kernel, for straight lines and all other polynomials `f`: the degree along the edge grows
/// by the product of the degree of `f` and the degree across.
///
/// The curve may not cross a knot line of constant `v`: no surface over a rectangle of knots is the
/// part beyond it. Where it would, `cut_back_within()` is near it, or `bezier_patches()` are
/// trimmed one by one.
/// \param surface a `Bezier_patch`, `Bspline_surface`, `Rational_bezier_patch` or
///   `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance \f$ f \f$, on the domain of the edge, which is mapped to [0, 1], in the
///   parameter that is constant on the edge
/// \throws Error `parameter_outside_domain` unless the distance is everywhere positive and less
///   than the length of the domain, of a B-spline surface less than the distance of the next knot
///   line (decided exactly), with the edge; `not_finite` when floating-point numbers overflow
template <class Surface>
Surface cut_back(const Surface& surface, Patch_edge edge, const Bernstein_polynomial<typename Surface::FT>& distance) {
  const auto height = internal::height_below_curve(surface, edge, distance);
  return internal::turned_to_v1(surface, edge, [&](const Surface& s) { return internal::part_below(s, height, edge); });
}

/// \ingroup PkgGeometricContinuitySurfaces
/// A surface that was trimmed back, and how far it is from the part that it stands for.
/// \tparam Surface the type of the surface
template <class Surface> struct Trimmed_surface {
  Surface surface; ///< the part
  /// The square of a bound of the distance of points at the same parameters; 0 where the part is
  /// exact.
  typename Surface::FT squared_deviation;
};

namespace internal {

// The spline f on [0, 1], of degree q, by a polynomial of degree n >= q that has its derivatives of
// order less than q at 0, and its values at other points up to 1: the Bernstein coefficients.
template <class FT, class Value> class Spline_interpolation {
  int q_, n_;
  std::vector<FT> nodes_;
  std::vector<std::vector<FT>> newton_; // 1, t - t_0, (t - t_0) (t - t_1), ...

public:
  Spline_interpolation(int q, int n) : q_(q), n_(n), nodes_(static_cast<std::size_t>(q), FT(0)) {
    const int m = n - q + 1; // denser at the ends, in 256ths
    for (int j = 1; j <= m; ++j)
      nodes_.push_back(FT(std::round(256 * std::pow(std::sin(std::acos(0.) * j / m), 2)) / 256));
    Bernstein_polynomial<FT> product{FT(1)};
    for (int k = 0; k <= n; ++k) {
      newton_.push_back(product.elevated(n - k).coefficients());
      if (k < n) product = product * Bernstein_polynomial<FT>{FT(-nodes_[k]), FT(FT(1) - nodes_[k])};
    }
  }

  std::vector<Value> operator()(const Bspline_function<FT, Value>& f) const {
    const std::vector<Value> at_start = f.right_derivatives(FT(0), q_);
    std::vector<Value> d;
    for (const FT& t : nodes_) d.push_back(f(t));
    FT factorial(1);
    for (int k = 1; k <= n_; ++k) { // divided differences
      factorial *= FT(k);
      for (int i = n_; i >= k; --i) {
        const FT step = nodes_[i] - nodes_[i - k];
        if (step == FT(0)) {
          d[i] = at_start[k];
          d[i] /= factorial;
        } else {
          d[i] -= d[i - 1];
          d[i] /= step;
        }
      }
    }
    std::vector<Value> c(static_cast<std::size_t>(n_ + 1), Value(d[0].dimension()));
    for (int k = 0; k <= n_; ++k)
      for (int j = 0; j <= n_; ++j) c[j] += newton_[k][j] * d[k];
    return c;
  }
};

// The square of a bound of the distances between two surfaces at the same parameters, from the
// Bernstein coefficients, on all spans, of one of them and of the differences; none where the
// denominator of a rational surface is not proved to be positive.
template <bool is_rational, class FT, int N>
std::optional<FT> squared_deviation(const std::vector<Coordinate_vector<FT, N>>& points,
                                    const std::vector<Coordinate_vector<FT, N>>& differences) {
  FT largest(0);
  if constexpr (!is_rational) {
    for (const Coordinate_vector<FT, N>& x : differences) largest = (std::max)(largest, FT(dot(x, x)));
    return largest;
  } else {
    // of x / w and (x + e) / (w + f): (e - f x / w) / (w + f), with the origin in the mean of the
    // points
    const int d = points[0].dimension() - 1;
    FT least = points[0][d], farthest(0), of_weight(0);
    Coordinate_vector<FT, N> sum = points[0];
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (k > 0) sum += points[k];
      least = (std::min)({least, points[k][d], FT(points[k][d] + differences[k][d])});
    }
    if (!(FT(0) < least)) return std::nullopt;
    const auto affine_square = [&](const Coordinate_vector<FT, N>& x, const FT& divisor) {
      FT square(0);
      for (int i = 0; i < d; ++i) {
        const FT y = (x[i] - x[d] * sum[i] / sum[d]) / divisor;
        square += y * y;
      }
      return square;
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
      farthest = (std::max)(farthest, affine_square(points[k], points[k][d]));
      largest = (std::max)(largest, affine_square(differences[k], FT(1)));
      of_weight = (std::max)(of_weight, FT(differences[k][d] * differences[k][d]));
    }
    // |x + y|^2 <= 2 |x|^2 + 2 |y|^2
    return FT(FT(2) * (largest + farthest * of_weight) / (least * least));
  }
}

// A surface over the same knots in u that is a polynomial of degree n in v, with another domain
// there, and the square of a bound of its deviation.
template <bool is_rational, class Traits>
std::pair<Bspline_surface<Traits>, std::optional<typename Traits::FT>>
polynomial_across(const Bspline_surface<Traits>& s, int n,
                  const std::pair<typename Traits::FT, typename Traits::FT>& domain) {
  typedef typename Traits::FT FT;
  typedef Coordinates<Traits> Vector;
  const int rows = s.number_of_points_u();
  const Knot_vector<FT> spline = s.knots_v().on_domain(FT(0), FT(1)), whole(n, FT(0), FT(1));
  const Spline_interpolation<FT, Vector> interpolation(s.degree_v(), n);
  std::vector<std::vector<typename Traits::Point>> net(static_cast<std::size_t>(rows));
  std::vector<Vector> points, differences;
  for (int i = 0; i < rows; ++i) {
    std::vector<Vector> c;
    for (int j = 0; j < s.number_of_points_v(); ++j) c.push_back(s.coordinates(i, j));
    const Bspline_function<FT, Vector> given(spline, std::move(c)), f(whole, interpolation(given));
    for (const Vector& x : f.coefficients()) net[i].push_back(to_point<Traits>(x));
    const Bspline_function<FT, Vector> elevated = given.elevate(n - given.degree()), difference = f - elevated;
    for (const Vector& x : bspline_bezier<FT>(difference.knots(), difference.coefficients())) differences.push_back(x);
    for (const Vector& x : bspline_bezier<FT>(elevated.knots(), elevated.coefficients())) points.push_back(x);
  }
  return {Bspline_surface<Traits>(net, s.knots_u(), whole.on_domain(domain.first, domain.second)),
          squared_deviation<is_rational>(points, differences)};
}

// As part_below(), with the square of a bound of the deviation.
template <bool is_rational, class Traits>
std::pair<Bspline_surface<Traits>, typename Traits::FT>
part_below_within(const Bspline_surface<Traits>& s, const Bernstein_polynomial<typename Traits::FT>& height,
                  Patch_edge edge, const typename Traits::FT& tolerance) {
  typedef typename Traits::FT FT;
  typedef Bernstein_polynomial<FT> Polynomial;
  const Bspline_surface<Traits> clamped = s.clamp();
  const Knot_vector<FT>& v = clamped.knots_v();
  const auto [c, d] = v.domain();
  const auto range = std::minmax_element(height.coefficients().begin(), height.coefficients().end());
  const Polynomial beyond = height - Polynomial{FT(v[v.number_of_coefficients() - 1] - c)};
  if (sign_pattern(beyond) == Sign_pattern::positive) return {part_below(s, height, edge), FT(0)};
  const FT low = c + *range.first, high = (std::min)(d, FT(c + *range.second));
  FT start = low - (low < high ? FT(high - low) : FT(low - c)) / FT(4);
  if (!(c < start)) start = c;
  for (const auto& knot : v.inner_knots())
    if (start < knot.value && knot.value < low) start = knot.value;
  Bspline_surface<Traits> strip = start == c ? clamped : clamped.split_v(start).second;
  if (high < d) strip = strip.split_v(high).first;
  const int q = s.degree_v(), most = q + 8;
  for (int n = q; n <= most; ++n) {
    const auto flat = polynomial_across<is_rational>(strip, n, std::pair<FT, FT>(start, d));
    if (!flat.second || tolerance * tolerance < *flat.second) continue;
    const Bspline_surface<Traits> part =
        part_of_span(flat.first, Polynomial{FT(FT(1) / (high - start))} * (height - Polynomial{FT(start - c)}));
    if (start == c) return {part, *flat.second};
    const Bspline_surface<Traits> below = clamped.split_v(start).first.elevate(part.degree_u() - s.degree_u(), n - q);
    return {joined_in_v(below, part, v.multiplicity(start) > q), *flat.second};
  }
  throw Error(Error_code::unreachable_tolerance, "cut_back_within: at the edge " + to_string(edge) +
                                                     ", by polynomials of degree up to " + std::to_string(most) +
                                                     " across the strip");
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Returns the part of a B-spline surface between the opposite edge and a curve in the parameter
/// plane that crosses knot lines, up to a tolerance. Where `cut_back()` is exact the result is that
/// of `cut_back()`. Elsewhere the surface is replaced by one without knots, in a strip that
/// contains the curve, and the part of this one is exact: its degree across is the least with which
/// the deviation is proved to be within the tolerance. The surface below the strip stays exactly as
/// it is, and is continued with the same derivatives.
///
/// For the edge `v = d` of a surface on [a, b] x [c, d] the strip begins at a parameter
/// \f$ v_0 \f$, the last knot of the result, and the points of the result at (u, v) and of the
/// surface at \f$ (u, v_0 + (v - v_0)\, (d - f(u) - v_0) / (d - v_0)) \f$ are compared, from
/// \f$ v_0 \f$ on. Up to there parameters are the same. With an exact kernel the bound is proved;
/// with floating-point numbers it is rounded.
/// \param surface a `Bspline_surface` or `Rational_bspline_surface`
/// \param edge the edge that is cut off
/// \param distance \f$ f \f$, on the domain of the edge, which is mapped to [0, 1], in the
///   parameter that is constant on the edge
/// \param tolerance the allowed distance of points at the same parameters
/// \throws Error `parameter_outside_domain` unless the distance is everywhere positive and less
///   than the length of the domain (decided exactly)
/// \throws Error `unreachable_tolerance` for a tolerance that is not positive, or when polynomials
///   whose degree across is that of the surface and eight more are not within it: a spline of
///   degree `q` with simple knots is approached as the power `-q` of the degree, one with a kink
///   slowly, one that jumps never
/// \throws Error `not_finite` when floating-point numbers overflow
template <class Surface>
Trimmed_surface<Surface> cut_back_within(const Surface& surface, Patch_edge edge,
                                         const Bernstein_polynomial<typename Surface::FT>& distance,
                                         const typename Surface::FT& tolerance) {
  typedef typename Surface::FT FT;
  typedef typename Surface::Traits Traits;
  static_assert(std::is_same_v<Surface, Bspline_surface<Traits>> ||
                    std::is_same_v<Surface, Rational_bspline_surface<Traits>>,
                "cut_back_within: patches have no knot lines, and cut_back() is exact");
  if (!(FT(0) < tolerance)) throw Error(Error_code::unreachable_tolerance, "cut_back_within: it is not positive");
  const auto height = internal::height_below_curve(surface, edge, distance);
  FT deviation(0);
  Surface part = internal::turned_to_v1(surface, edge, [&](const Surface& s) {
    if constexpr (internal::Is_rational<Surface>::value) {
      auto r = internal::part_below_within<true>(s.homogeneous(), height, edge, tolerance);
      deviation = std::move(r.second);
      return Surface(std::move(r.first));
    } else {
      auto r = internal::part_below_within<false>(s, height, edge, tolerance);
      deviation = std::move(r.second);
      return std::move(r.first);
    }
  });
  return {std::move(part), std::move(deviation)};
}

#ifndef CGAL_NO_DEPRECATED_CODE
// Old names, for one release.
template <class Surface, class... A> CGAL_DEPRECATED Surface trim_back(const Surface& surface, const A&... arguments) {
  return cut_back(surface, arguments...);
}
template <class Surface, class... A>
CGAL_DEPRECATED auto trim_back_within(const Surface& surface, const A&... arguments) {
  return cut_back_within(surface, arguments...);
}
#endif

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_CUT_BACK_H
