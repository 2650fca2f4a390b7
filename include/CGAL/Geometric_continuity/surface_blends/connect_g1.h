// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_CONNECT_G1_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_CONNECT_G1_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/edges/edge_continuity.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The requirements on a ribbon at one end of its curve \f$ C \f$, and how well they can be met.
/// With \f$ x = C_1 - C \f$ and \f$ D = \frac12 (C_1 - C_2) \f$, these are the demands (ii)
/// \f$ T_1 = x \f$ and (iii) \f$ T_1' = x' \f$ of *Algebraic G1 connection retaining fixed twist
/// vectors*; the same residuals belong to \f$ C_2 - C \f$ and \f$ T_2 \f$.
/// \tparam FT the field in which it was decided
template <class FT> struct Ribbon_end {
  FT determinant;            ///< \f$ F = \det(C_1 - C,\, C_2 - C,\, C') \f$
  FT determinant_derivative; ///< \f$ F' \f$
  /// the square of the length of \f$ x - T_1 \f$: zero if and only if (ii) holds
  FT position_residual;
  /// the square of the length of \f$ x' - T_1' \f$: zero if and only if (iii) holds
  FT twist_residual;
};

/// \ingroup PkgGeometricContinuitySurfaces
/// A pair of surfaces \f$ S_k(u, v) = C(u) + T_k(u)\,v \f$, `v` in [0, 1], on both sides of a
/// curve, with \f$ T_k = D\,\alpha_k + C'\,\beta_k \f$, and what was decided about them. See
/// `connect_g1()`.
///
/// The numbers that are not control points are exact: they belong to the field in which predicates
/// are decided, and to the given curves without rounding.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 3
template <class Traits_> struct G1_ribbon {
  typedef Traits_ Traits; ///< the traits class of the curves and the surfaces
  /// the field of the numbers that are not control points
  typedef Edge_field<Traits> Field;
  typedef Bernstein_polynomial<Field> Polynomial; ///< the type of \f$ \alpha_k \f$ and \f$ \beta_k \f$
  typedef Bspline_surface<Traits> Surface;        ///< the surface of each side

  Polynomial alpha;        ///< \f$ \alpha_1 \f$, with the domain mapped to [0, 1]
  Polynomial beta;         ///< \f$ \beta_1 \f$, with the domain mapped to [0, 1]
  Polynomial alpha2;       ///< \f$ \alpha_2 = \alpha_1 - 2 \f$
  Polynomial beta2;        ///< \f$ \beta_2 = \beta_1 \f$
  Ribbon_end<Field> start; ///< at the start of the domain
  Ribbon_end<Field> end;   ///< at its end
  Surface side1;           ///< \f$ S_1 \f$; its edge `v0` is \f$ C \f$
  Surface side2;           ///< \f$ S_2 \f$, with the same knots

  /// Returns whether both sides attain the given first derivatives \f$ C_1 - C \f$, \f$ C_2 - C \f$
  /// at both ends.
  bool position_coplanar() const { return start.position_residual == Field(0) && end.position_residual == Field(0); }
  /// Returns whether both sides attain the given twists \f$ C_1' - C' \f$, \f$ C_2' - C' \f$ at
  /// both ends. Together with `position_coplanar()` this is \f$ F = F' = 0 \f$ at both ends.
  bool twist_coplanar() const { return start.twist_residual == Field(0) && end.twist_residual == Field(0); }

  /// Returns the signs of \f$ \alpha_1 \f$ on the closed domain. Where it is not positive, the
  /// first side turns over.
  Sign_pattern alpha_signs() const { return sign_pattern(alpha); }
  /// Returns the signs of \f$ 2 - \alpha_1 = -\alpha_2 \f$ on the closed domain. Where it is not
  /// positive, the second side turns over.
  Sign_pattern two_minus_alpha_signs() const { return sign_pattern(Polynomial{Field(2)} - alpha); }
  /// Returns whether \f$ 0 < \alpha_1 < 2 \f$ fails somewhere on the closed domain: there, both
  /// surfaces lie on one side of the edge.
  bool folds() const {
    return alpha_signs() != Sign_pattern::positive || two_minus_alpha_signs() != Sign_pattern::positive;
  }

  /// Decides the continuity of the surfaces along \f$ C \f$ as they are, one decision for each span
  /// of the knots, see `edge_continuity()`. Control points are taken as they are given; parameters
  /// are those of the domain. When they have been rounded, the surfaces are not exactly
  /// \f$ G^1 \f$, and each decision bounds the angle between the normals.
  std::vector<Edge_continuity<Field>> continuity() const;

  /// Returns whether `continuity()` is \f$ G^1 \f$ or more on all spans: a proof for the whole
  /// edge.
  bool g1() const { return edge_continuity(side1, Patch_edge::v0, side2, Patch_edge::v0).g_order >= 1; }

  /// Writes all but the surfaces, one item to a line.
  friend std::ostream& operator<<(std::ostream& os, const G1_ribbon& r) {
    const auto write_end = [&os](const char* name, const Ribbon_end<Field>& e) {
      os << name << ": F = " << e.determinant << ", F' = " << e.determinant_derivative
         << ", squared residuals: position " << e.position_residual << ", twist " << e.twist_residual << '\n';
    };
    os << "alpha: " << r.alpha << "\nbeta: " << r.beta << '\n';
    write_end("start", r.start);
    write_end("end", r.end);
    os << "first derivatives " << (r.position_coplanar() ? "" : "not ") << "attained, twists "
       << (r.twist_coplanar() ? "" : "not ") << "attained\n";
    return os << "alpha is " << r.alpha_signs() << ", 2 - alpha is " << r.two_minus_alpha_signs() << ": "
              << (r.folds() ? "fold" : "no fold");
  }
};

template <class Traits> auto G1_ribbon<Traits>::continuity() const -> std::vector<Edge_continuity<Field>> {
  std::vector<Edge_continuity<Field>> result;
  Spline_edge_continuity<Field> edge = edge_continuity(side1, Patch_edge::v0, side2, Patch_edge::v0);
  for (Edge_span<Field>& span : edge.spans) result.push_back(std::move(span.continuity));
  return result;
}

namespace internal {

// One end of a ribbon: values and derivatives of alpha and beta for both sides, and the report.
template <class FT, int N> struct Ribbon_end_conditions {
  typedef Coordinate_vector<FT, N> Vector;
  typedef Coordinate_jet<FT, N> Jet;

  std::pair<FT, FT> value[2], derivative[2]; // (alpha, beta)
  Ribbon_end<FT> report;

  // From jets of order 2, 1, 1.
  Ribbon_end_conditions(const Jet& c, const Jet& c1, const Jet& c2, const char* place) {
    const Vector d = (c1[0] - c2[0]) / FT(2), d_derivative = (c1[1] - c2[1]) / FT(2);
    const Plane_coordinates<FT, N> frame(d, c[1], place);
    const Vector x[2] = {c1[0] - c[0], c2[0] - c[0]}, x_derivative[2] = {c1[1] - c[1], c2[1] - c[1]};
    for (int side = 0; side < 2; ++side) {
      value[side] = frame.nearest(x[side]);
      const Vector rest = x_derivative[side] - value[side].first * d_derivative - value[side].second * c[2];
      derivative[side] = frame.nearest(rest);
      if (side > 0) continue; // the residuals of both sides are the same
      const Vector position = x[0] - value[0].first * d - value[0].second * c[1],
                   twist = rest - derivative[0].first * d - derivative[0].second * c[1];
      report.position_residual = dot(position, position);
      report.twist_residual = dot(twist, twist);
    }
    report.determinant = det(x[0], x[1], c[1]);
    report.determinant_derivative =
        det(x_derivative[0], x[1], c[1]) + det(x[0], x_derivative[1], c[1]) + det(x[0], x[1], c[2]);
  }

private:
  static FT det(const Vector& x, const Vector& y, const Vector& z) {
    const Vector* columns[] = {&x, &y, &z};
    return Geometric_continuity::determinant<FT>(3, [&](int i, int j) -> const FT& { return (*columns[j])[i]; });
  }
};

// The cubic with these values and derivatives at the ends of an interval: P1 = P0 + L/3 P0', with
// the length L.
template <class FT>
Bernstein_polynomial<FT> hermite_cubic(const FT& p0, const FT& d0, const FT& p3, const FT& d3, const FT& length) {
  return {p0, FT(p0 + length * d0 / FT(3)), FT(p3 - length * d3 / FT(3)), p3};
}

// A number of the predicates, rounded where the constructions are.
template <class FT, class Field> FT from_field(const Field& x) {
  if constexpr (std::is_same_v<FT, Field>)
    return x;
  else if constexpr (std::is_floating_point_v<FT>)
    return FT(CGAL::to_double(x));
  else
    return FT(x);
}

template <class FT, class Field>
Bspline_function<FT> scalar_function(const Bernstein_polynomial<Field>& p, const std::pair<FT, FT>& domain) {
  std::vector<FT> c;
  for (const Field& x : p.coefficients()) c.push_back(from_field<FT>(x));
  return Bspline_function<FT>(Knot_vector<FT>(p.degree(), domain.first, domain.second), std::move(c));
}

template <class Traits>
void check_ribbon_input(const Bspline_curve<Traits>& c, const Bspline_curve<Traits>& c1,
                        const Bspline_curve<Traits>& c2) {
  static_assert(dimension_v<Traits> == 0 || dimension_v<Traits> == 3, "a ribbon is a surface in dimension 3");
  for (const Bspline_curve<Traits>* curve : {&c, &c1, &c2}) {
    if (curve->dimension() != 3)
      throw Error(Error_code::dimension_mismatch, "connect_g1: a ribbon is a surface in dimension 3");
    if (curve->degree() != 3)
      throw Error(Error_code::wrong_number_of_points,
                  "connect_g1: the curves must be cubic, not of degree " + std::to_string(curve->degree()));
    if (!curve->knots().has_domain_of(c.knots()))
      throw Error(Error_code::parameter_outside_domain, "connect_g1: the domains of the curves differ");
    if (curve->knots() != c.knots())
      throw Error(Error_code::knot_multiplicity, "connect_g1: the curves must have the same knots");
  }
  for (const auto& knot : c.knots().inner_knots())
    if (knot.multiplicity > 2)
      throw Error(Error_code::knot_multiplicity,
                  "connect_g1: an inner knot is repeated " + std::to_string(knot.multiplicity) + " times, more than 2");
}

} // namespace internal

/// \ingroup PkgGeometricContinuitySurfaces
/// Constructs two surfaces of degree 6 x 1 that meet along \f$ C \f$ with \f$ G^1 \f$ continuity,
/// with given cross derivatives \f$ C_k - C \f$ and twists \f$ C_k' - C' \f$, `k = 1, 2`, at both
/// ends of \f$ C \f$. *Algebraic G1 connection retaining fixed twist vectors*, with the corrections
/// below.
///
/// With \f$ D = \frac12 (C_1 - C_2) \f$ they are \f$ S_k(u, v) = C(u) + T_k(u)\,v \f$ with
/// \f$ T_k = D\,\alpha_k + C'\,\beta_k \f$ (1). All tangents along the edge lie in the plane of
/// \f$ D \f$ and \f$ C' \f$, so that \f$ \det(C', T_1, T_2) = 0 \f$. On the domain `[a, b]` of
/// length `L`, \f$ \alpha_k \f$ and \f$ \beta_k \f$ are single cubic polynomials. At an end,
/// - \f$ (\alpha_k, \beta_k) \f$ are the coordinates of \f$ C_k - C \f$ in \f$ (D, C') \f$,
/// - \f$ (\alpha_k', \beta_k') \f$ are those of \f$ C_k' - C' - D'\alpha_k - C''\beta_k \f$ (5),
///
/// both by the normal equations (11); and \f$ P_1 = P_0 + \frac{L}{3} P_0' \f$ (6). The source
/// assumes \f$ L = 1 \f$; its (2) has `P` for \f$ C \f$.
///
/// It follows that \f$ \alpha_1 - \alpha_2 = 2 \f$, \f$ \beta_1 = \beta_2 \f$ and
/// \f$ T_1 - T_2 = C_1 - C_2 \f$. Two things are not automatic, and reported: the demands are met
/// only if the given vectors lie in the plane of \f$ D \f$ and \f$ C' \f$ (otherwise in the sense
/// of least squares); and the surfaces lie on different sides of the edge only where
/// \f$ 0 < \alpha_1 < 2 \f$.
///
/// The knots in `u` are clamped, with `m + 4` for an inner knot of multiplicity `m`; those in `v`
/// are 0, 0, 1, 1. With rounded constructions \f$ \alpha_k \f$ and \f$ \beta_k \f$ are computed
/// exactly and rounded once.
///
/// \f$ O(n) \f$ for `n` control points.
/// \param C the common edge, a cubic curve; inner knots have at most the multiplicity 2
/// \param C1,C2 cubic curves with the knots of `C`, which give the first derivatives and the twists
/// \param bulge a freedom that the demands leave: \f$ \beta_k \f$ is a quartic with
///   \f$ bulge\,B_2^4 \f$ added unless it is 0
/// \throws Error `wrong_number_of_points` unless the curves are cubic, `parameter_outside_domain`
///   when their domains differ, `knot_multiplicity` when their knots differ, or for an inner knot
///   of multiplicity 3 or more, where \f$ C' \f$ may jump
/// \throws Error `singular_frame` when at an end \f$ D \f$ and \f$ C' \f$ are linearly dependent,
///   e.g. \f$ C_1 = C_2 \f$
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite` also when rounded numbers
///   overflow, `work_limit` when exact numbers are so long that the limit does not suffice
template <class Traits>
G1_ribbon<Traits> connect_g1(const Bspline_curve<Traits>& C, const Bspline_curve<Traits>& C1,
                             const Bspline_curve<Traits>& C2,
                             const typename Traits::FT& bulge = typename Traits::FT(0)) {
  typedef typename Traits::FT FT;
  typedef Edge_field<Traits> Field;
  typedef typename Bspline_curve<Traits>::Function Function;
  typedef Bernstein_polynomial<Field> Polynomial;
  typedef typename Traits::Point Point;
  internal::check_ribbon_input(C, C1, C2);
  const internal::Work_guard work("connect_g1");
  for (const Bspline_curve<Traits>* curve : {&C, &C1, &C2}) {
    const std::size_t words = internal::common_words<FT>(curve->function().coefficients()) +
                              internal::common_words<FT>(std::array<const Knot_vector<FT>, 1>{curve->knots()});
    // alpha and beta at the ends, of about this degree
    internal::work_meter().charge_fractions(100, 8 * words);
    internal::work_meter().charge_fractions(60. * curve->number_of_points(), 4 * words);
  }

  const internal::Ribbon_end_conditions<Field, dimension_v<Traits>> start(
      C.template start_jet_over<Field>(2), C1.template start_jet_over<Field>(1), C2.template start_jet_over<Field>(1),
      "connect_g1: D and C' at the start"),
      end(C.template end_jet_over<Field>(2), C1.template end_jet_over<Field>(1), C2.template end_jet_over<Field>(1),
          "connect_g1: D and C' at the end");
  const std::pair<FT, FT> domain = C.domain();
  const Field length = internal::to_field<Field>(domain.second) - internal::to_field<Field>(domain.first);
  const auto alpha = [&](int side) {
    return internal::hermite_cubic<Field>(start.value[side].first, start.derivative[side].first, end.value[side].first,
                                          end.derivative[side].first, length);
  };
  const auto beta = [&](int side) {
    const Polynomial cubic =
        internal::hermite_cubic<Field>(start.value[side].second, start.derivative[side].second, end.value[side].second,
                                       end.derivative[side].second, length);
    if (bulge == FT(0)) return cubic;
    return cubic + Polynomial{Field(0), Field(0), internal::to_field<Field>(bulge), Field(0), Field(0)};
  };

  const Function c = C.function(), c_derivative = c.derivative();
  std::vector<typename Function::Value> difference; // D
  for (int i = 0; i < C.number_of_points(); ++i) difference.push_back((C1.coordinates(i) - C2.coordinates(i)) / FT(2));
  const Function d(C.knots(), std::move(difference));
  const auto surface = [&](const Polynomial& of_difference, const Polynomial& of_derivative) {
    const Function row1 = c + (internal::scalar_function<FT>(of_difference, domain) * d +
                               internal::scalar_function<FT>(of_derivative, domain) * c_derivative),
                   row0 = c.elevate(3).refine(row1.knots());
    std::vector<std::vector<Point>> net;
    for (int i = 0; i < row0.knots().number_of_coefficients(); ++i)
      net.push_back({Geometric_continuity::to_point<Traits>(row0[i]), Geometric_continuity::to_point<Traits>(row1[i])});
    return Bspline_surface<Traits>(net, row0.knots(), Knot_vector<FT>(1, FT(0), FT(1)));
  };
  const Polynomial alpha1 = alpha(0), beta1 = beta(0), alpha2 = alpha(1), beta2 = beta(1);
  return {alpha1, beta1, alpha2, beta2, start.report, end.report, surface(alpha1, beta1), surface(alpha2, beta2)};
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_CONNECT_G1_H
