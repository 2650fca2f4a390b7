// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BEZIER_NET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BEZIER_NET_H

#include <CGAL/Geometric_continuity/algebra/bernstein.h>
#include <CGAL/Geometric_continuity/local/Surface_jet.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/surfaces/internal/Control_net.h>
#include <CGAL/Geometric_continuity/surfaces/internal/tensor_product_jet.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file bezier_net.h
/// The algorithms of `Bezier_patch`: those of Bernstein polynomials, applied to the columns of a control net.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The parameter u as a fraction of the interval: 0 at its lower end, 1 at its upper end.
template <class FT> FT local_parameter(const FT& u, const std::pair<FT, FT>& interval) {
  return FT((u - interval.first) / (interval.second - interval.first));
}

// The knots of a Bezier curve of degree p.
template <class FT> struct Bezier_knots {
  int p;
  const std::pair<FT, FT>& domain;
  const FT& operator[](int i) const { return i <= p ? domain.first : domain.second; }
};

// The jet of order k at (u, v) of the patch of degree p x q on the rectangle `domain_u` x `domain_v`: first the derivatives in v
// of the control points of all rows, then those in u. coordinate(i, j, x) is the coordinate number x < d of a control point.
// Inside of the domain, floating-point code takes the weights of a spline.
template <class Traits, class Coordinate>
Surface_jet<Traits> bezier_jet(int p, int q, int d, const std::pair<typename Traits::FT, typename Traits::FT>& domain_u,
                               const std::pair<typename Traits::FT, typename Traits::FT>& domain_v,
                               const typename Traits::FT& u, const typename Traits::FT& v, int k,
                               Coordinate coordinate) {
  typedef typename Traits::FT FT;
  constexpr int N = dimension_v<Traits>,
                width = N == 0 ? 1 : N; // all coordinates together where the compiler knows how many
  typedef Coordinate_vector<FT, width> Block;
  typedef boost::container::small_vector<Block, 6> Blocks;
  Surface_jet<Traits> jet(d, k);
  if constexpr (std::is_floating_point_v<FT>)
    if (domain_u.first < u && u < domain_u.second && domain_v.first < v && v < domain_v.second) {
      const Derivative_table<FT> weights_u(Bezier_knots<FT>{p, domain_u}, p, p, u, k),
          weights_v(Bezier_knots<FT>{q, domain_v}, q, q, v, k);
      const auto point = [&](int i, int j) {
        Coordinates<Traits> b(d);
        for (int x = 0; x < d; ++x) b[x] = coordinate(i, j, x);
        return b;
      };
      write_derivatives(weights_u, weights_v, point, jet);
      check_jet(jet, "Bezier_patch: jet");
      return jet;
    }
  const FT s = local_parameter(u, domain_u), t = local_parameter(v, domain_v);
  const FT hu = FT(domain_u.second - domain_u.first), hv = FT(domain_v.second - domain_v.first);
  Blocks row(q + 1), column(p + 1), rows(static_cast<std::size_t>(k + 1) * (p + 1)); // derivatives with respect to v
  for (int x = 0; x < d; x += width) {
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= q; ++j)
        for (int l = 0; l < width; ++l) row[j][l] = coordinate(i, j, x + l);
      bernstein_derivatives(
          row, q, t, k, [&](int j, const Block& value) { rows[static_cast<std::size_t>(j) * (p + 1) + i] = value; });
    }
    FT scale_v(1);
    for (int j = 0; j <= k; ++j) {
      FT scale = scale_v;
      for (int i = 0; i <= p; ++i) column[i] = rows[static_cast<std::size_t>(j) * (p + 1) + i];
      bernstein_derivatives(column, p, s, k - j, [&](int i, const Block& value) {
        for (int l = 0; l < width; ++l) jet(i, j)[x + l] = value[l] / scale;
        scale *= hu;
      });
      scale_v *= hv;
    }
  }
  check_jet(jet, "Bezier_patch: jet");
  return jet;
}

// The rows 0 to k at an edge of degree m of a patch of degree n across it, see `Bezier_patch::rows()`. point(i, j) is the control
// point number i along the edge in the layer j, in `Field`, with d coordinates.
template <class Field, int N, class Point>
std::vector<std::vector<Coordinate_vector<Field, N>>> bezier_rows(int m, int n, int d, int k, Point point) {
  typedef Coordinate_vector<Field, N> Vector;
  check_count(k, "Bezier_patch: rows");
  const int last = (std::min)(k, n);
  std::vector<std::vector<Vector>> rows(k + 1, std::vector<Vector>(m + 1, Vector(d)));
  for (int i = 0; i <= m; ++i) {
    std::vector<Vector> layers;
    for (int j = 0; j <= last; ++j) layers.push_back(point(i, j));
    Field factor(1);
    for (int r = 0; r <= last; ++r) {
      rows[r][i] = factor * layers[0];
      difference_step(layers, last - r);
      factor *= Field(n - r);
    }
  }
  return rows;
}

// The net of the degree in u raised by `times`.
template <class Traits> Control_net<Traits> elevate_rows(const Control_net<Traits>& net, int times) {
  const int p = net.rows() - 1, q = net.columns() - 1;
  std::vector<typename Traits::Point> points(static_cast<std::size_t>(p + times + 1) * (q + 1), net(0, 0));
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> c = net.column(j);
    c.resize(p + times + 1, Coordinates<Traits>(net.dimension()));
    for (int n = p; n < p + times; ++n) bernstein_elevate<typename Traits::FT>(c, n);
    for (int i = 0; i <= p + times; ++i) points[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(c[i]);
  }
  return Control_net<Traits>(p + times + 1, q + 1, std::move(points), "Bezier_patch");
}

// The nets of the two parts, of which the first takes the fraction t of the interval of u.
template <class Traits>
std::pair<Control_net<Traits>, Control_net<Traits>> split_rows(const Control_net<Traits>& net,
                                                               const typename Traits::FT& t) {
  const int p = net.rows() - 1, q = net.columns() - 1;
  std::vector<typename Traits::Point> left(net.begin(), net.end()), right(left);
  for (int j = 0; j <= q; ++j) {
    std::vector<Coordinates<Traits>> r = net.column(j), l(r);
    bernstein_split(r, p, t, l);
    for (int i = 0; i <= p; ++i) {
      left[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(l[i]);
      right[static_cast<std::size_t>(i) * (q + 1) + j] = to_point<Traits>(r[i]);
    }
  }
  return {Control_net<Traits>(p + 1, q + 1, std::move(left), "Bezier_patch"),
          Control_net<Traits>(p + 1, q + 1, std::move(right), "Bezier_patch")};
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_BEZIER_NET_H
