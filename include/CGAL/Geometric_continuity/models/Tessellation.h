// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H

#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

/// \file Tessellation.h
/// Triangles that stand for a surface, how they meet, and how far they are from it at most.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// Triangles that stand for a surface: a range of points and a range of triangles that refer to
/// them by their numbers, as the functions for polygon soups of \cgal take them. Seen from the side
/// of \f$ S_u \times S_v \f$ the corners of each triangle run counterclockwise. See `tessellate()`.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
template <class Traits_> struct Tessellation {
  typedef Traits_ Traits;                      ///< the geometric traits
  typedef typename Traits::FT FT;              ///< the number type
  typedef typename Traits::Point Point;        ///< the points
  typedef std::array<std::size_t, 3> Triangle; ///< the numbers of three points

  /// Where a point lies.
  struct Place {
    std::size_t patch; ///< the number of the patch or surface, from 0 on
    FT u;              ///< in its domain
    FT v;              ///< in its domain
  };

  std::vector<Point> points;        ///< each once, also if several patches have it
  std::vector<Triangle> triangles;  ///< numbers of points
  std::vector<std::size_t> patches; ///< for each triangle, the number of its patch or surface
  std::vector<Place> places;        ///< for each point, one place where the surface has it
};

/// \ingroup PkgGeometricContinuitySurfaces
/// The counts of edges at which the triangles of a tessellation meet.
struct Mesh_edges {
  std::size_t inner = 0;    ///< edges of two triangles, which pass them in opposite directions
  std::size_t boundary = 0; ///< edges of one triangle only
  /// edges of more than two triangles, or of two which pass them in one direction
  std::size_t irregular = 0;

  /// Returns the number of all edges.
  std::size_t number_of_edges() const { return inner + boundary + irregular; }

  /// Tells whether each edge has a triangle on both sides.
  bool watertight() const { return boundary == 0 && irregular == 0; }

  /// Writes the counts, e.g. `96 edges, watertight` or `96 edges, 12 on the boundary`.
  friend std::ostream& operator<<(std::ostream& os, const Mesh_edges& e) {
    os << e.number_of_edges() << " edges, ";
    if (e.watertight()) return os << "watertight";
    if (e.boundary > 0) os << e.boundary << " on the boundary";
    if (e.irregular > 0) os << (e.boundary > 0 ? ", " : "") << e.irregular << " irregular";
    return os;
  }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Counts the edges of triangles by how many triangles meet at them. \f$ O(n \log n) \f$ for `n`
/// triangles
/// \tparam TriangleRange a forward range of triples of numbers of points
template <class TriangleRange> Mesh_edges mesh_edges(const TriangleRange& triangles) {
  struct Use {
    std::size_t low, high;
    bool upwards;
    bool same_edge(const Use& other) const { return low == other.low && high == other.high; }
  };
  std::vector<Use> uses;
  uses.reserve(3 * static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles))));
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = t[i], b = t[(i + 1) % 3];
      uses.push_back({(std::min)(a, b), (std::max)(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high); });
  Mesh_edges result;
  for (auto first = uses.begin(), last = first; first != uses.end(); first = last) {
    while (last != uses.end() && first->same_edge(*last)) ++last;
    if (last - first == 1)
      ++result.boundary;
    else
      ++(last - first == 2 && first[0].upwards != first[1].upwards ? result.inner : result.irregular);
  }
  return result;
}

/// \ingroup PkgGeometricContinuitySurfaces
/// The numbers of cells into which a patch is cut in the direction of `u` and of `v`.
struct Patch_cells {
  int u; ///< positive
  int v; ///< positive
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Bounds for the second derivatives of a Bézier patch that is taken on the unit square, and what
/// follows for its distance from triangles: `tessellate()` chooses by them how many cells a patch
/// needs. By the convex hull property the lengths of the derivatives are nowhere greater than
/// \f[ M_{uu} = p(p-1) \max |b_{i+2,j} - 2b_{i+1,j} + b_{ij}|, \quad
///   M_{uv} = pq \max |b_{i+1,j+1} - b_{i+1,j} - b_{i,j+1} + b_{ij}|, \quad
///   M_{vv} = q(q-1) \max |b_{i,j+2} - 2b_{i,j+1} + b_{ij}|. \f]
///
/// <b>Claim.</b> Let the corners \f$ p_k \f$ of a triangle in the unit square differ by at most
/// \f$ h_u \f$ in `u` and \f$ h_v \f$ in `v`, and let \f$ x = \sum \lambda_k p_k \f$ be in the
/// triangle. Then
/// \f[ \left| S(x) - \sum \lambda_k S(p_k) \right| \le \frac{1}{8} (M_{uu} h_u^2 + 2 M_{uv} h_u h_v + M_{vv} h_v^2). \f]
/// <b>Proof.</b> Let \f$ p_k - x = (\delta_k, \epsilon_k) \f$, and let \f$ f \f$ be the component
/// of \f$ S \f$ in a direction of length 1. The segments from \f$ x \f$ to \f$ p_k \f$ lie in the
/// square, hence by Taylor's formula \f$ f(p_k) \f$ differs from \f$ f(x) + Df(x)(p_k - x) \f$ by
/// at most
/// \f$ \frac{1}{2} (M_{uu} \delta_k^2 + 2 M_{uv} |\delta_k \epsilon_k| + M_{vv} \epsilon_k^2) \f$.
/// In the sum with the weights \f$ \lambda_k \f$ the linear terms cancel. The remaining part in
/// \f$ u \f$ is the variance \f$ \sum \lambda_k \delta_k^2 \f$ of numbers in an interval of length
/// \f$ h_u \f$, which is at most \f$ h_u^2 / 4 \f$; the same holds for \f$ v \f$; and by the
/// inequality of Cauchy and Schwarz \f$ \sum \lambda_k |\delta_k \epsilon_k| \le h_u h_v / 4 \f$.
/// \f$ \Box \f$
///
/// For a rational patch \f$ S = P/w \f$ the claim holds with bounds of its derivatives. Let `c` be
/// a control point, \f$ Q = P - c w \f$, \f$ R = \max |b_{ij} - c| \f$, `m` the least weight, and
/// let bars denote the bounds above for \f$ Q \f$ and \f$ w \f$, of the first derivatives as well.
/// From \f$ Q = w (S - c) \f$ by the product rule
/// \f[ |S_u| \le (\bar Q_u + \bar w_u R) / m, \quad
///   |S_{uu}| \le (\bar Q_{uu} + 2 \bar w_u |S_u| + \bar w_{uu} R) / m, \quad
///   |S_{uv}| \le (\bar Q_{uv} + \bar w_u |S_v| + \bar w_v |S_u| + \bar w_{uv} R) / m. \f]
/// This is done for each of its `positive_parts()`, or for up to 64 parts of each of these where
/// the weights differ much.
///
/// The bounds are floating-point numbers, rounded upwards when the field is exact. With
/// floating-point control points the claim holds up to the rounding of differences and of evaluated
/// points.
class Patch_flatness {
  double uu_ = 0, uv_ = 0, vv_ = 0;

public:
  /// Computes the bounds of a patch; they are infinite when second differences overflow. Linear in
  /// the number of control points. It needs `CGAL::to_interval()`.
  template <class Traits> explicit Patch_flatness(const Bezier_patch<Traits>& s) {
    const Derivatives d = derivatives<2>(s.degree_u(), s.degree_v(), columns(s));
    uu_ = upwards(d.uu);
    uv_ = upwards(d.uv);
    vv_ = upwards(d.vv);
  }

  /// Computes the bounds of a rational patch; they are infinite when a difference overflows.
  /// \throws Error `work_limit` as `Rational_bezier_patch::positive_parts()`
  template <class Traits> explicit Patch_flatness(const Rational_bezier_patch<Traits>& s) {
    // how many of them there are, or a bit more
    const auto parts_of = [](const auto& whole, const auto& part) {
      const std::pair<double, double> n =
          CGAL::to_interval(typename Traits::FT((whole.second - whole.first) / (part.second - part.first)));
      return n.second;
    };
    for (const Rational_bezier_patch<Traits>& part : s.positive_parts())
      include_parts(part, parts_of(s.domain_u(), part.domain_u()), parts_of(s.domain_v(), part.domain_v()), 3);
  }

  /// Returns a bound for the distance of the patch from its triangles, when it is cut into equal
  /// cells and each triangle lies in a cell; infinite when it overflows.
  /// \throws Error `negative_count` for a negative number of cells, `wrong_number_of_points` for no
  ///   cells
  double distance(const Patch_cells& cells) const {
    check_cells((std::min)(cells.u, cells.v));
    return bound(cells.u, cells.v);
  }

  /// Returns the least number of cells whose numbers in `u` and in `v` are powers of two between
  /// `least` and `most` and whose distance is not greater than `tolerance`; empty when there are
  /// none. \f$ O(\log (most / least)) \f$
  /// \throws Error `unreachable_tolerance` unless the tolerance is positive, `not_finite` when it
  ///   is infinite or not a number, `negative_count` for a negative number of cells,
  ///   `wrong_number_of_points` for no cells
  std::optional<Patch_cells> cells(double tolerance, int least, int most) const {
    check_tolerance(tolerance);
    check_cells((std::min)(least, most));
    long long low = 1, high = 1;
    while (low < least) low *= 2;
    while (2 * high <= most) high *= 2;
    std::optional<Patch_cells> best;
    long long v = high;
    for (long long u = low; u <= high; u *= 2) { // more cells in u need fewer in v
      if (!(bound(u, v) <= tolerance)) continue;
      while (v / 2 >= low && bound(u, v / 2) <= tolerance) v /= 2;
      if (!best || u * v < static_cast<long long>(best->u) * best->v)
        best = Patch_cells{static_cast<int>(u), static_cast<int>(v)};
    }
    return best;
  }

  /// Returns a number of cells below which, by the bounds, no choice of their numbers in `u` and in
  /// `v` reaches the tolerance:
  /// \f$ \max(1, \sqrt{M_{uu} / 8t}, \sqrt{M_{vv} / 8t}, (\sqrt{M_{uu} M_{vv}} + M_{uv}) / 4t) \f$,
  /// by the inequality between arithmetic and geometric mean. It is infinite when it overflows.
  /// \throws Error `unreachable_tolerance` unless the tolerance is positive, `not_finite` when it
  ///   is infinite or not a number
  double least_cells(double tolerance) const {
    check_tolerance(tolerance);
    const double root = std::sqrt(8 * tolerance), factor = 1 - 0x1p-40; // rounded downwards
    return (std::max)({1.0, factor * (std::sqrt(uu_) / root), factor * (std::sqrt(vv_) / root),
                       factor * ((0.25 * std::sqrt(uu_) * std::sqrt(vv_) + 0.25 * uv_) / tolerance)});
  }

private:
  // Bounds of the derivatives of a polynomial patch, up to the second.
  struct Derivatives {
    double u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  };

  // The control points.
  template <class Patch> static std::vector<Coordinates<typename Patch::Traits>> columns(const Patch& s) {
    std::vector<Coordinates<typename Patch::Traits>> net;
    net.reserve(static_cast<std::size_t>(s.degree_u() + 1) * (s.degree_v() + 1));
    for (int i = 0; i <= s.degree_u(); ++i)
      for (int j = 0; j <= s.degree_v(); ++j) net.push_back(s.coordinates(i, j));
    return net;
  }

  // From the order `first` on, 1 or 2, of a polynomial with these coefficients.
  template <int first, class Column> static Derivatives derivatives(int p, int q, const std::vector<Column>& net) {
    Derivatives d;
    const auto point = [&](int i, int j) -> const Column& { return net[static_cast<std::size_t>(i) * (q + 1) + j]; };
    const auto raise = [](double& bound, double factor, const auto& difference) {
      bound = (std::max)(bound, factor * length(difference));
    };
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j) {
        if (first == 1 && i < p) raise(d.u, p, point(i + 1, j) - point(i, j));
        if (first == 1 && j < q) raise(d.v, q, point(i, j + 1) - point(i, j));
        if (i + 2 <= p)
          raise(d.uu, double(p) * (p - 1), point(i + 2, j) - point(i + 1, j) + point(i, j) - point(i + 1, j));
        if (j + 2 <= q)
          raise(d.vv, double(q) * (q - 1), point(i, j + 2) - point(i, j + 1) + point(i, j) - point(i, j + 1));
        if (i < p && j < q)
          raise(d.uv, double(p) * q, point(i + 1, j + 1) - point(i + 1, j) + point(i, j) - point(i, j + 1));
      }
    return d;
  }

  // Quarters of a part as long as the weights differ by more than a quarter: the bounds are the
  // closer the less they differ.
  template <class Traits> void include_parts(const Rational_bezier_patch<Traits>& s, double u, double v, int halvings) {
    typedef typename Traits::FT FT;
    const auto ends = std::minmax_element(s.weights().begin(), s.weights().end());
    if (halvings == 0 || !(FT(5) * *ends.first < FT(4) * *ends.second)) return include(s, u, v);
    const auto middle = [](const auto& domain) -> FT { return FT(FT(domain.first + domain.second) / FT(2)); };
    const auto halves = s.split_u(middle(s.domain_u()));
    for (const Rational_bezier_patch<Traits>& half : {halves.first, halves.second}) {
      const auto quarters = half.split_v(middle(s.domain_v()));
      include_parts(quarters.first, 2 * u, 2 * v, halvings - 1);
      include_parts(quarters.second, 2 * u, 2 * v, halvings - 1);
    }
  }

  // A part that is a `u`-th by a `v`-th of the patch. \pre all weights are positive
  template <class Traits> void include(const Rational_bezier_patch<Traits>& s, double u, double v) {
    typedef Coordinate_vector<typename Traits::FT, 1> Number;
    const int p = s.degree_u(), q = s.degree_v();
    std::vector<Coordinates<Traits>> net = columns(s);
    const Coordinates<Traits> c = s.coordinates(p / 2, q / 2);
    std::vector<Number> weights;
    double R = 0, m = std::numeric_limits<double>::infinity();
    auto weight = s.weights().begin();
    for (Coordinates<Traits>& x : net) { // becomes Q
      x -= c;
      R = (std::max)(R, length(x));
      m = (std::min)(m, CGAL::to_interval(*weight).first);
      x *= *weight;
      weights.emplace_back(1);
      weights.back()[0] = *weight++;
    }
    const Derivatives Q = derivatives<1>(p, q, net), w = derivatives<1>(p, q, weights);
    const double su = (Q.u + w.u * R) / m, sv = (Q.v + w.v * R) / m;
    const auto raise = [](double& bound, double x) {
      bound = (std::max)(bound, std::isfinite(x) ? upwards(x) : std::numeric_limits<double>::infinity());
    };
    raise(uu_, u * u * ((Q.uu + 2 * w.u * su + w.uu * R) / m));
    raise(uv_, u * v * ((Q.uv + w.u * sv + w.v * su + w.uv * R) / m));
    raise(vv_, v * v * ((Q.vv + 2 * w.v * sv + w.vv * R) / m));
  }

  static void check_tolerance(double tolerance) {
    internal::check_finite(tolerance, "Patch_flatness: the tolerance");
    if (!(tolerance > 0))
      throw Error(Error_code::unreachable_tolerance, "Patch_flatness: the tolerance must be positive");
  }

  static void check_cells(int least) {
    internal::check_count(least, "Patch_flatness: number of cells");
    if (least == 0) throw Error(Error_code::wrong_number_of_points, "Patch_flatness: no cells");
  }

  double bound(long long u, long long v) const {
    const double hu = 1.0 / static_cast<double>(u), hv = 1.0 / static_cast<double>(v);
    return upwards(0.125 * (uu_ * hu * hu + 2 * uv_ * hu * hv + vv_ * hv * hv));
  }

  // The few roundings of the formulas here change a number by less than this.
  static double upwards(double x) {
    return x > 0 ? (std::max)(x * (1 + 0x1p-46), (std::numeric_limits<double>::min)()) : x;
  }

  template <class Column> static double length(const Column& x) {
    double result = 0;
    for (const auto& c : x) {
      const std::pair<double, double> interval = CGAL::to_interval(c);
      result = std::hypot(result, (std::max)(-interval.first, interval.second));
    }
    return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_TESSELLATION_H
