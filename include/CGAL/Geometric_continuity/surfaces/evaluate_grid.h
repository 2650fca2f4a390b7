// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>
#include <CGAL/Geometric_continuity/internal/parallel.h>
#include <CGAL/Geometric_continuity/surfaces/Bspline_surface.h>
#include <CGAL/Geometric_continuity/surfaces/Rational_surface.h>
#include <CGAL/Geometric_continuity/surfaces/internal/patch_sums.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

/// \file evaluate_grid.h
/// Many points and normals of a surface at once: for each parameter `u` the control points of a
/// curve in `v`, and then all points on that line of the grid, in loops that a compiler vectorises.

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

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_EVALUATE_GRID_H
