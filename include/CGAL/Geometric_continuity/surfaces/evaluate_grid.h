// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/internal/patch_sums.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file evaluate_grid.h
/// Many points and normals of a surface at once: for each parameter `u` the control points of a
/// curve in `v`, and then all points on that line of the grid, in loops that a compiler vectorises.
/// How many cells of a grid a patch needs, so that triangles between its points are nowhere farther
/// from the patch than a tolerance.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuitySurfaces
/// The points and normals of a surface at the vertices of a grid of parameters, as a structure of
/// arrays: for each coordinate one array with the numbers of all vertices, where the vertex of the
/// `i`-th parameter `u` and the `j`-th parameter `v` has the index \f$ i\,n_v + j \f$.
template <class FT> class Surface_grid {
  std::size_t size_u_ = 0, size_v_ = 0;
  std::vector<FT> numbers_;

public:
  /// Changes the numbers of parameters. The numbers of the vertices are unspecified afterwards; no
  /// memory is allocated when there is enough.
  /// \throws Error `work_limit` when the numbers of the vertices would be more than a `std::size_t`
  ///   counts
  void resize(std::size_t size_u, std::size_t size_v) {
    if (size_v > 0 && size_u > (std::numeric_limits<std::size_t>::max)() / 6 / size_v)
      throw Error(Error_code::work_limit, "Surface_grid: too many vertices");
    numbers_.resize(6 * size_u * size_v);
    size_u_ = size_u;
    size_v_ = size_v;
  }
  std::size_t size_u() const { return size_u_; } ///< Returns the number of parameters `u`.
  /// Returns the number \f$ n_v \f$ of parameters `v`.
  std::size_t size_v() const { return size_v_; }
  std::size_t size() const { return size_u_ * size_v_; } ///< Returns the number of vertices.

  /// Returns the array of the coordinates number `i` of all points. \pre `0 <= i < 3`
  FT* points(int i) { return numbers_.data() + i * size(); }
  /// Returns the array of the coordinates number `i` of all points. \pre `0 <= i < 3`
  const FT* points(int i) const { return numbers_.data() + i * size(); }
  /// Returns the array of the coordinates number `i` of all normals. \pre `0 <= i < 3`
  FT* normals(int i) { return numbers_.data() + (3 + i) * size(); }
  /// Returns the array of the coordinates number `i` of all normals. \pre `0 <= i < 3`
  const FT* normals(int i) const { return numbers_.data() + (3 + i) * size(); }
};

/// \ingroup PkgGeometricContinuitySurfaces
/// Which normals `evaluate_grid()` computes.
enum class Grid_normals {
  unnormalised, ///< \f$ S_u \times S_v \f$, without roots
  unit          ///< normals of length 1, or zero where \f$ S_u \times S_v = 0 \f$
};

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace internal {

// The Bernstein polynomials of degree n and their derivatives with respect to a parameter on [a,
// a+h], at many parameters: array j holds the values of number j.
template <class FT> struct Basis_arrays {
  int n;
  std::size_t size;
  std::vector<FT> values, derivatives;

  Basis_arrays(int degree, const std::pair<FT, FT>& domain, const FT* parameters, std::size_t number)
      : n(degree), size(number), values((n + 1) * size), derivatives((n + 1) * size) {
    const FT h = FT(domain.second - domain.first);
    std::vector<FT> b(n + 2), lower(n + 2); // degrees n and n-1, with a zero in front
    for (std::size_t l = 0; l < size; ++l) {
      const FT t = FT((parameters[l] - domain.first) / h), s = FT(FT(1) - t);
      std::fill(b.begin(), b.end(), FT(0));
      std::fill(lower.begin(), lower.end(), FT(0));
      b[1] = FT(1);
      for (int m = 1; m <= n; ++m) {
        lower = b;
        raise_bernstein_values(b, m, s, t);
      }
      for (int j = 0; j <= n; ++j) {
        values[j * size + l] = b[j + 1];
        derivatives[j * size + l] = n == 0 ? FT(0) : FT(FT(n) * (lower[j] - lower[j + 1]) / h);
      }
    }
  }
};

// One line of the grid, u constant: the coefficients in v of S and S_u are c and d, of M
// coordinates: 3, or 4 for homogeneous points (p, w), where S = p/w and S_u = (p_u - w_u S)/w. The
// degree is q, or v.n if q is -1.
template <int q, int M, Grid_normals kind, class FT>
void evaluate_grid_line(const std::vector<FT>& c, const std::vector<FT>& d, const Basis_arrays<FT>& v,
                        const std::array<FT*, 3>& points, const std::array<FT*, 3>& normals) {
  constexpr bool fixed = q >= 0;
  const int n = fixed ? q : v.n;
  std::conditional_t<fixed, std::array<FT, M*(q + 1) + !fixed>, std::vector<FT>> cc, dd;
  std::conditional_t<fixed, std::array<const FT*, q + 1 + !fixed>, std::vector<const FT*>> w, dw;
  if constexpr (!fixed) {
    cc.resize(M * (n + 1));
    dd.resize(M * (n + 1));
    w.resize(n + 1);
    dw.resize(n + 1);
  }
  std::copy_n(c.begin(), cc.size(), cc.begin());
  std::copy_n(d.begin(), dd.size(), dd.begin());
  for (int j = 0; j <= n; ++j) {
    w[j] = v.values.data() + j * v.size;
    dw[j] = v.derivatives.data() + j * v.size;
  }
  CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
  for (std::size_t l = 0; l < v.size; ++l) {
    FT p[M], pu[M], pv[M];
    for (int i = 0; i < M; ++i) {
      p[i] = cc[i] * w[0][l];
      pu[i] = dd[i] * w[0][l];
      pv[i] = cc[i] * dw[0][l];
      for (int j = 1; j <= n; ++j) {
        p[i] += cc[M * j + i] * w[j][l];
        pu[i] += dd[M * j + i] * w[j][l];
        pv[i] += cc[M * j + i] * dw[j][l];
      }
    }
    if constexpr (M == 4) {
      const FT inverse = FT(1) / p[3];
      for (int i = 0; i < 3; ++i) {
        p[i] *= inverse;
        pu[i] = (pu[i] - pu[3] * p[i]) * inverse;
        pv[i] = (pv[i] - pv[3] * p[i]) * inverse;
      }
    }
    FT x = pu[1] * pv[2] - pu[2] * pv[1], y = pu[2] * pv[0] - pu[0] * pv[2], z = pu[0] * pv[1] - pu[1] * pv[0];
    if constexpr (kind == Grid_normals::unit) {
      const FT square = x * x + y * y + z * z;
      const FT scale = FT(1) / std::sqrt(square > FT(0) ? square : FT(1));
      x *= scale;
      y *= scale;
      z *= scale;
    }
    for (int i = 0; i < 3; ++i) points[i][l] = p[i];
    normals[0][l] = x;
    normals[1][l] = y;
    normals[2][l] = z;
  }
}

template <int q, int M, Grid_normals kind, class FT>
void evaluate_grid_line_of_degree(const std::vector<FT>& c, const std::vector<FT>& d, const Basis_arrays<FT>& v,
                                  const std::array<FT*, 3>& points, const std::array<FT*, 3>& normals) {
  constexpr int most_unrolled = 5;
  if constexpr (q > most_unrolled)
    evaluate_grid_line<-1, M, kind>(c, d, v, points, normals);
  else if (v.n == q)
    evaluate_grid_line<q, M, kind>(c, d, v, points, normals);
  else
    evaluate_grid_line_of_degree<q + 1, M, kind>(c, d, v, points, normals);
}

// The vertices of a patch: the rows from `row` on, and in each of them the numbers from `column`
// on.
template <int M, class Concurrency_tag, Grid_normals kind, class Patch>
void evaluate_patch(const Patch& patch, const typename Patch::FT* u, std::size_t size_u, const typename Patch::FT* v,
                    std::size_t size_v, std::size_t row, std::size_t column, Surface_grid<typename Patch::FT>& grid) {
  typedef typename Patch::FT FT;
  const Basis_arrays<FT> basis_u(patch.degree_u(), patch.domain_u(), u, size_u),
      basis_v(patch.degree_v(), patch.domain_v(), v, size_v);
  for_each_block<Concurrency_tag>(size_u, [&](std::size_t begin, std::size_t end) {
    std::vector<FT> c(M * (patch.degree_v() + 1)), d(c.size());
    for (std::size_t l = begin; l < end; ++l) {
      std::fill(c.begin(), c.end(), FT(0));
      std::fill(d.begin(), d.end(), FT(0));
      for (int i = 0; i <= patch.degree_u(); ++i) {
        const FT w = basis_u.values[i * size_u + l], dw = basis_u.derivatives[i * size_u + l];
        for (int j = 0; j <= patch.degree_v(); ++j) {
          const auto& b = summand(patch, i, j);
          for (int x = 0; x < M; ++x) {
            c[M * j + x] += w * b[x];
            d[M * j + x] += dw * b[x];
          }
        }
      }
      const std::size_t at = (row + l) * grid.size_v() + column;
      const std::array<FT*, 3> points{grid.points(0) + at, grid.points(1) + at, grid.points(2) + at},
          normals{grid.normals(0) + at, grid.normals(1) + at, grid.normals(2) + at};
      evaluate_grid_line_of_degree<0, M, kind>(c, d, basis_v, points, normals);
    }
  });
}

template <class Surface, class Range> void check_grid(const Surface& surface, const Range& u, const Range& v) {
  if (surface.dimension() != 3)
    throw Error(Error_code::dimension_mismatch, "evaluate_grid: a normal needs dimension 3");
  for (const Range* parameters : {&u, &v})
    for (std::size_t l = 0; l < parameters->size(); ++l)
      check_finite(parameters->data()[l], "evaluate_grid: parameters");
}

// Where the parameters of each span begin, and at last where those of the last span end.
template <class FT, class Range>
std::vector<std::size_t> parameters_of_spans(const Knot_vector<FT>& knots, const Range& parameters) {
  if (!std::is_sorted(parameters.begin(), parameters.end()))
    throw Error(Error_code::wrong_number_of_points, "evaluate_grid: the parameters are not sorted");
  const std::pair<FT, FT> domain = knots.domain();
  if (parameters.size() > 0 && (parameters.front() < domain.first || domain.second < parameters.back()))
    throw Error(Error_code::parameter_outside_domain, "evaluate_grid");
  std::vector<std::size_t> starts;
  for (int k : knots.spans())
    starts.push_back(std::lower_bound(parameters.begin(), parameters.end(), knots[k]) - parameters.begin());
  starts.push_back(parameters.size());
  return starts;
}

// The vertices of a surface, from those of its patches.
template <int M, class Concurrency_tag, Grid_normals kind, class Surface, class Range>
void evaluate_spline(const Surface& surface, const Range& u, const Range& v, Surface_grid<typename Surface::FT>& grid) {
  check_grid(surface, u, v);
  const std::vector<std::size_t> rows = parameters_of_spans(surface.knots_u(), u),
                                 columns = parameters_of_spans(surface.knots_v(), v);
  grid.resize(u.size(), v.size());
  const auto patches = surface.bezier_patches();
  std::size_t patch = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    for (std::size_t j = 0; j + 1 < columns.size(); ++j, ++patch)
      evaluate_patch<M, Concurrency_tag, kind>(patches[patch], u.data() + rows[i], rows[i + 1] - rows[i],
                                               v.data() + columns[j], columns[j + 1] - columns[j], rows[i], columns[j],
                                               grid);
}

} // namespace internal

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

/// \ingroup PkgGeometricContinuitySurfaces
/// Computes the points and normals of a Bézier patch at all pairs of a parameter `u` and a
/// parameter `v`, several at a time with floating-point numbers. The parameters may lie outside of
/// the domain.
///
/// \param patch the patch, of dimension 3
/// \param u,v the parameters, each in a range with `data()` and `size()`
/// \param grid the result; it is resized. A grid that is used again allocates no memory
/// \tparam kind with or without roots; compile with `-fno-math-errno`, or the root is not
///   vectorised
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite` for a parameter that is
///   infinite or not a number. Results that overflow are not refused, but infinite or NaN
///
/// \f$ O(n_u n_v q + n_u p q + n_u p^2 + n_v q^2) \f$ for the degree \f$ p \times q \f$
template <Grid_normals kind = Grid_normals::unit, class Concurrency_tag = Sequential_tag, class Traits, class Range>
void evaluate_grid(const Bezier_patch<Traits>& patch, const Range& u, const Range& v,
                   Surface_grid<typename Traits::FT>& grid) {
  internal::check_grid(patch, u, v);
  grid.resize(u.size(), v.size());
  internal::evaluate_patch<3, Concurrency_tag, kind>(patch, u.data(), u.size(), v.data(), v.size(), 0, 0, grid);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Computes the points and normals of a rational Bézier patch at all pairs of a parameter `u` and a
/// parameter `v`, see the function for `Bezier_patch`. Where the denominator is zero, outside of
/// the domain, they are infinite or NaN.
/// \throws Error `dimension_mismatch` unless in dimension 3, `not_finite` for a parameter that is
///   infinite or not a number
template <Grid_normals kind = Grid_normals::unit, class Concurrency_tag = Sequential_tag, class Traits, class Range>
void evaluate_grid(const Rational_bezier_patch<Traits>& patch, const Range& u, const Range& v,
                   Surface_grid<typename Traits::FT>& grid) {
  internal::check_grid(patch, u, v);
  grid.resize(u.size(), v.size());
  internal::evaluate_patch<4, Concurrency_tag, kind>(patch, u.data(), u.size(), v.data(), v.size(), 0, 0, grid);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Computes the points and normals of a B-spline surface at all pairs of a parameter `u` and a
/// parameter `v`, from its Bézier patches: at a knot that of the span to the right is taken.
///
/// \param surface the surface, of dimension 3
/// \param u,v the parameters in ascending order, each in a range with `data()`, `size()`,
///   `begin()`, `end()`, `front()` and `back()`
/// \param grid the result; it is resized. A grid that is used again allocates no memory for the
///   vertices
/// \tparam kind with or without roots; compile with `-fno-math-errno`, or the root is not
///   vectorised
/// \tparam Concurrency_tag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
/// \throws Error `parameter_outside_domain` for a parameter outside the domain,
///   `dimension_mismatch` unless in dimension 3, `wrong_number_of_points` unless the parameters are
///   sorted in ascending order, `not_finite` for a parameter that is infinite or not a number.
///   Results that overflow are not refused, but infinite or NaN
///
/// \f$ O(n_u n_v q) \f$ for the vertices, and the cost of the Bézier patches and, for each, of its
/// Bernstein polynomials
template <Grid_normals kind = Grid_normals::unit, class Concurrency_tag = Sequential_tag, class Traits, class Range>
void evaluate_grid(const Bspline_surface<Traits>& surface, const Range& u, const Range& v,
                   Surface_grid<typename Traits::FT>& grid) {
  internal::evaluate_spline<3, Concurrency_tag, kind>(surface, u, v, grid);
}

/// \ingroup PkgGeometricContinuitySurfaces
/// Computes the points and normals of a rational B-spline surface at all pairs of a parameter `u`
/// and a parameter `v`, see the function for `Bspline_surface`.
/// \throws Error as the function for `Bspline_surface`
template <Grid_normals kind = Grid_normals::unit, class Concurrency_tag = Sequential_tag, class Traits, class Range>
void evaluate_grid(const Rational_bspline_surface<Traits>& surface, const Range& u, const Range& v,
                   Surface_grid<typename Traits::FT>& grid) {
  internal::evaluate_spline<4, Concurrency_tag, kind>(surface, u, v, grid);
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

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H
