// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H

#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/internal/force_inline.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_grid.h>
#include <CGAL/Geometric_continuity/numbers/internal/Fixed_integer.h>
#include <CGAL/Geometric_continuity/numbers/internal/zero_bits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <vector>

/// \file Edge_input.h
/// The input of the stages of Edge_ladder.h: the control points next to an edge of each of two
/// patches, or of rows, in numbers of fixed length; and those of B-spline surfaces over inner
/// knots, for all spans at once.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The layers of the control net of a Bezier patch next to an edge: p[j][i] is the control point
// number i along the edge in the layer number j, of which there are min(k, across) + 1 for the
// order k.
template <class T, int N = 3> struct Edge_points {
  static constexpr int dimension = N;
  // the degrees that are decided in numbers of fixed length
  static constexpr int most_along = 7, most_across = 8;
  static constexpr int factor_bits = 10; // of factors 2 n q^2, see Edge_factors
  static_assert(2 * most_along * most_across * most_across < 1 << factor_bits);

  int along, across, layers;
  // equivalent [1 -> 2, 1]: room that nothing uses
  std::array<T, N> p[3][most_along + 1];

  // Returns whether numbers of fixed length decide edges of these degrees.
  static bool fits(int degree_along, int degree_across) {
    return degree_along <= most_along && 1 <= degree_across && degree_across <= most_across;
  }

  void reverse() {
    for (int j = 0; j < layers; ++j) std::reverse(p[j], p[j] + along + 1);
  }
};

// Calls f(x, k) for all coordinates x, each with its number k.
template <class Layers, class Function> void for_each_number(Layers& s, Function f) {
  for (int j = 0; j < s.layers; ++j)
    for (int i = 0; i <= s.along; ++i)
      for (int k = 0; k < s.dimension; ++k) f(s.p[j][i][k], k);
}

typedef Edge_points<double> Edge_layers;
typedef Edge_points<std::int64_t> Grid_layers;
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
typedef Edge_points<Signed_128, 4> Homogeneous_layers; // whole numbers of at most 2^106
#endif

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
// Returns whether a b = c d, for numbers of any length.
inline bool equal_products(Signed_128 a, Signed_128 b, Signed_128 c, Signed_128 d) {
  return is_zero(from_128_bits<2>(a) * from_128_bits<2>(b) - from_128_bits<2>(c) * from_128_bits<2>(d));
}
#endif

// Edges of equal degree are the same if and only if their control points are, see also
// Edge_sides::align().
inline bool same_edge(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1, b.p[0]);
}
inline bool same_edge_reversed(const Edge_layers& a, const Edge_layers& b) {
  return std::equal(a.p[0], a.p[0] + a.along + 1,
                    std::reverse_iterator<const std::array<double, 3>*>(b.p[0] + b.along + 1));
}
inline std::optional<Edge_direction> common_direction(const Edge_layers& a, const Edge_layers& b) {
  if (a.along != b.along) return std::nullopt;
  if (same_edge(a, b)) return Edge_direction::same;
  return same_edge_reversed(a, b) ? std::optional<Edge_direction>(Edge_direction::opposite) : std::nullopt;
}
inline bool is_collapsed(const Edge_layers& a) {
  return std::all_of(a.p[0], a.p[0] + a.along + 1, [&](const std::array<double, 3>& x) { return x == a.p[0][0]; });
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

inline bool is_collapsed(const Homogeneous_layers& a) {
  const std::array<Signed_128, 4>& first = a.p[0][0];
  return std::all_of(a.p[0], a.p[0] + a.along + 1, [&](const std::array<Signed_128, 4>& x) {
    // equivalent [3 -> 4, 1]: the products of the weights are the same
    for (int k = 0; k < 3; ++k)
      if (!equal_products(x[k], first[3], first[k], x[3])) return false;
    return true;
  });
}

// The numbers s, without a common factor, for which the edge of a times s[1] is that of b, in the
// direction that is given, times s[0]. Nothing if they are not the same.
inline std::optional<std::array<std::int64_t, 2>> common_scale(const Homogeneous_layers& a, const Homogeneous_layers& b,
                                                               Edge_direction direction) {
  if (a.along != b.along) return std::nullopt;
  const auto point = [&](int i) { return b.p[0][direction == Edge_direction::same ? i : b.along - i]; };
  const std::int64_t x = static_cast<std::int64_t>(a.p[0][0][3]), y = static_cast<std::int64_t>(point(0)[3]),
                     common = std::gcd(x, y);
  for (int i = 0; i <= a.along; ++i)
    for (int k = 0; k < 4; ++k)
      if (!equal_products(a.p[0][i][k], y / common, point(i)[k], x / common)) return std::nullopt;
  return std::array<std::int64_t, 2>{x / common, y / common};
}
inline std::optional<Edge_direction> common_direction(const Homogeneous_layers& a, const Homogeneous_layers& b) {
  for (const Edge_direction direction : {Edge_direction::same, Edge_direction::opposite})
    if (common_scale(a, b, direction)) return direction;
  return std::nullopt;
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Returns infinity if a coordinate is infinite or not a number, otherwise a bound of all
// coordinates.
inline double size_of(const Edge_layers& a) {
  double size[3] = {0, 0, 0}, test[3] = {0, 0, 0}; // 0, or not a number
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i)
      for (int x = 0; x < 3; ++x) {
        size[x] = (std::max)(size[x], std::abs(a.p[j][i][x]));
        test[x] += a.p[j][i][x] - a.p[j][i][x];
      }
  if (test[0] + test[1] + test[2] != 0) return std::numeric_limits<double>::infinity();
  return (std::max)({size[0], size[1], size[2]});
}

inline bool is_finite(const Edge_layers& a) { return std::isfinite(size_of(a)); }
template <class T> bool is_finite(const Edge_points<T, 4>&) { return true; }

// Converts to units of the grid, which is invalid afterwards unless all coordinates lie on it.
inline void convert(const Edge_layers& a, Grid& grid, Grid_layers& g) {
  g.along = a.along;
  g.across = a.across;
  g.layers = a.layers;
  for (int j = 0; j < a.layers; ++j)
    for (int i = 0; i <= a.along; ++i) g.p[j][i] = grid(a.p[j][i]);
}

// Returns whether the control points of a surface are those of one Bezier patch.
template <class Traits> bool is_one_patch(const Bezier_patch<Traits>&) { return true; }
template <class Traits> bool is_one_patch(const Bspline_surface<Traits>& s) {
  const auto one_span = [](const auto& knots) {
    return knots.number_of_coefficients() == knots.degree() + 1 && knots.is_clamped();
  };
  return one_span(s.knots_u()) && one_span(s.knots_v());
}
template <class Shape> bool is_one_patch(const Rational_surface<Shape>& s) { return is_one_patch(s.unweighted()); }

// Calls f(x, p) for all numbers x of the control points that count for an order, and their places
// p: those of the point number i along the edge in each layer j, which are numbers(k, l) for the
// control point (k, l). Returns whether the degrees are among those that are decided in numbers of
// fixed length. Most edges that are not smooth are refused soon after this: it is written out where
// it is called.
template <class Surface, class T, int N, class Numbers, class Function>
CGAL_GC_FORCEINLINE bool for_each_layer(const Surface& s, Patch_edge edge, int order, Edge_points<T, N>& layers,
                                        Numbers numbers, Function f) {
  const bool along_u = runs_along_u(edge);
  const int along = along_u ? s.degree_u() : s.degree_v(), across = along_u ? s.degree_v() : s.degree_u();
  layers.along = along;
  layers.across = across;
  layers.layers = (std::min)(order, across) + 1;
  if (!is_one_patch(s) || !layers.fits(along, across)) return false;
  const int first = at_upper_end(edge) ? across : 0, step = at_upper_end(edge) ? -1 : 1;
  for (int j = 0; j <= (std::min)(order, across); ++j)
    for (int i = 0; i <= along; ++i) {
      const int inward = first + step * j;
      const auto x = numbers(along_u ? i : inward, along_u ? inward : i);
      for (int k = 0; k < N; ++k) f(x[k], layers.p[j][i][k]);
    }
  return true;
}

// x, if its absolute value is at most 2^53, or another number up to that which is given.
template <class Ring> bool take_integer(const Ring& x, double& result, double most = 0x1p53) {
  result = CGAL::to_double(x);
  return std::abs(result) <= most;
}
#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER
template <class Ring> bool take_integer(const Ring& x, Signed_128& result, double most = 0x1p105) {
  const double high = CGAL::to_double(x);
  if (!(std::abs(high) <= most)) return false;
  result = static_cast<Signed_128>(high) + static_cast<Signed_128>(CGAL::to_double(Ring(x - Ring(high))));
  return true;
}
#endif

// The layers x and y of both edges that count for an order, of rational numbers multiplied by their
// common denominator. Returns whether numbers of fixed length may decide: for low degrees, and
// short numerators.
template <class Field, class Surface_a, class Surface_b, class T, int N, class Numbers_a, class Numbers_b>
bool common_layers(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, int order,
                   Numbers_a of_a, Numbers_b of_b, Edge_points<T, N>& x, Edge_points<T, N>& y) {
  if constexpr (Common_denominator<Field>::clears) {
    Common_denominator<Field> denominator;
    const auto include = [&](const Field& number, T&) { denominator.include(number); };
    if (!for_each_layer(a, edge_a, order, x, of_a, include) || !for_each_layer(b, edge_b, order, y, of_b, include))
      return false;
    bool all_short = true;
    const auto scale = [&](const Field& number, T& place) {
      all_short = all_short && take_integer(denominator.numerator(number), place);
    };
    for_each_layer(a, edge_a, order, x, of_a, scale);
    for_each_layer(b, edge_b, order, y, of_b, scale);
    return all_short;
  } else
    return false;
}

// Takes the control points of surfaces without weights, as they are given if they are doubles.
template <class Surface_a, class Surface_b>
bool edge_layers(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, int order,
                 Edge_layers& x, Edge_layers& y) {
  typedef typename Surface_a::Traits Traits;
  constexpr bool given = std::is_same_v<typename Traits::FT, double>;
  typedef std::conditional_t<given, double, Edge_field<Traits>> Field;
  const auto of_a = [&](int i, int j) {
    return Geometric_continuity::coordinates<Traits, Field>(a.control_point(i, j));
  };
  const auto of_b = [&](int i, int j) {
    return Geometric_continuity::coordinates<Traits, Field>(b.control_point(i, j));
  };
  if constexpr (given) {
    const auto copy = [](double number, double& place) { place = number; };
    return for_each_layer(a, edge_a, order, x, of_a, copy) && for_each_layer(b, edge_b, order, y, of_b, copy);
  } else
    return common_layers<Field>(a, edge_a, b, edge_b, order, of_a, of_b, x, y);
}

#ifdef CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

inline int trailing_zeros(Unsigned_128 x) { // of x > 0
  const std::uint64_t low = static_cast<std::uint64_t>(x);
  // equivalent [+ -> -, 1]: a smaller power of two leaves more to the next stage
  return low != 0 ? trailing_zero_bits(low) : 64 + trailing_zero_bits(static_cast<std::uint64_t>(x >> 64));
}

// Divides the first coordinates by a power of two, and the weights by one. Returns whether the
// weights at the ends of the edges are positive and at most 2^53, as common_scale() needs them.
inline bool reduce(Homogeneous_layers& a, Homogeneous_layers& b) {
  Unsigned_128 bits[2] = {0, 0};
  for (const Homogeneous_layers* s : {&a, &b})
    for_each_number(*s, [&](Signed_128 x, int k) { bits[k == 3] |= static_cast<Unsigned_128>(x); });
  int zeros[2] = {0, 0};
  for (int k : {0, 1})
    if (bits[k] != 0) zeros[k] = trailing_zeros(bits[k]);
  for (Homogeneous_layers* s : {&a, &b}) for_each_number(*s, [&](Signed_128& x, int k) { x >>= zeros[k == 3]; });
  for (const Homogeneous_layers* s : {&a, &b})
    for (int i : {0, s->along})
      if (s->p[0][i][3] <= 0 || Signed_128(1) << 53 < s->p[0][i][3]) return false;
  return true;
}

// The weight of a control point.
template <class Field, class Surface> Field weight_of(const Surface& s, int i, int j) {
  if constexpr (Is_rational<Surface>::value)
    return to_field<Field>(s.weight(i, j));
  else
    return (void)s, (void)i, (void)j, Field(1);
}

// The homogeneous points of surfaces one of which has weights: whole numbers times a unit, which
// that of the weights need not be.
template <class Surface_a, class Surface_b>
bool edge_layers(const Surface_a& a, Patch_edge edge_a, const Surface_b& b, Patch_edge edge_b, int order,
                 Homogeneous_layers& x, Homogeneous_layers& y) {
  typedef typename Surface_a::Traits Traits;
  if constexpr (std::is_same_v<typename Traits::FT, double>) {
    double size[2] = {0, 0}; // of points and weights
    const auto numbers_of = [](const auto& s) {
      return [&s](int i, int j) {
        const Coordinate_vector<double, 3> p = Geometric_continuity::coordinates<Traits, double>(s.control_point(i, j));
        return std::array<double, 4>{p[0], p[1], p[2], weight_of<double>(s, i, j)};
      };
    };
    Edge_points<double, 4> given[2];
    const auto copy = [&](double number, double& place) { place = number; };
    if (!for_each_layer(a, edge_a, order, given[0], numbers_of(a), copy) ||
        !for_each_layer(b, edge_b, order, given[1], numbers_of(b), copy))
      return false;
    for (const Edge_points<double, 4>& s : given)
      for_each_number(s, [&](double number, int k) { size[k == 3] = (std::max)(size[k == 3], std::abs(number)); });
    Grid grid(size[0]), weight_grid(size[1]);
    if (!grid.valid() || !weight_grid.valid()) return false;
    int side = 0;
    for (Homogeneous_layers* s : {&x, &y}) {
      const Edge_points<double, 4>& p = given[side++];
      s->along = p.along;
      s->across = p.across;
      s->layers = p.layers;
      for (int j = 0; j < p.layers; ++j)
        for (int i = 0; i <= p.along; ++i) {
          const std::int64_t w = weight_grid(p.p[j][i][3]);
          for (int k = 0; k < 3; ++k) s->p[j][i][k] = static_cast<Signed_128>(grid(p.p[j][i][k])) * w;
          s->p[j][i][3] = w;
        }
    }
    if (!grid.valid() || !weight_grid.valid()) return false;
  } else {
    typedef Edge_field<Traits> Field;
    const auto numbers_of = [](const auto& s) {
      return [&s](int i, int j) {
        const Coordinate_vector<Field, 3> p = Geometric_continuity::coordinates<Traits, Field>(s.control_point(i, j));
        const Field w = weight_of<Field>(s, i, j);
        return std::array<Field, 4>{Field(w * p[0]), Field(w * p[1]), Field(w * p[2]), w};
      };
    };
    if (!common_layers<Field>(a, edge_a, b, edge_b, order, numbers_of(a), numbers_of(b), x, y)) return false;
  }
  return reduce(x, y);
}

#endif // CGAL_GEOMETRIC_CONTINUITY_HAS_FIXED_INTEGER

// Takes rows of one degree, with the same edge. The surfaces C + T v + W v^2/2 have the same order
// along the edge; their control points are C, C + T/2 and C + T + W/2, here times two and the
// common denominator. Returns whether numbers of fixed length may decide.
template <class Field, int N, class T>
bool edge_layers(const Edge_rows<Field, N>& a, const Edge_rows<Field, N>& b, Edge_points<T, N>& x,
                 Edge_points<T, N>& y) {
  if constexpr (Common_denominator<Field>::clears) {
    const std::size_t n = a.edge.size();
    for (const auto* row : {&a.edge, &a.cross, &a.second_cross, &b.edge, &b.cross, &b.second_cross})
      if (row->size() != n) return false;
    if (!Edge_layers::fits(static_cast<int>(n) - 1, 2)) return false;
    Common_denominator<Field> denominator;
    for (const auto* row : {&a.edge, &a.cross, &a.second_cross, &b.cross, &b.second_cross})
      for (const Coordinate_vector<Field, N>& v : *row)
        for (const Field& number : v) denominator.include(number);
    bool all_short = true;
    const auto scaled = [&](const Field& number) { // so short that the sums are exact
      T result(0);
      all_short = all_short && take_integer(denominator.numerator(number), result, N == 3 ? 0x1p50 : 0x1p102);
      return result;
    };
    const auto take = [&](const Edge_rows<Field, N>& rows, Edge_points<T, N>& s) {
      s.along = static_cast<int>(n) - 1;
      s.across = 2;
      s.layers = 3;
      for (std::size_t i = 0; i < n && all_short; ++i)
        for (int k = 0; k < N; ++k) {
          const T c = 2 * scaled(a.edge[i][k]), t = scaled(rows.cross[i][k]), w = scaled(rows.second_cross[i][k]);
          s.p[0][i][k] = c;
          s.p[1][i][k] = c + t;
          s.p[2][i][k] = c + 2 * t + w;
        }
    };
    take(a, x);
    take(b, y);
    if constexpr (N == 4) return all_short && reduce(x, y);
    return all_short;
  } else
    return false;
}

// The control points next to an edge over clamped knots, and the knots across it. With the
// distances h1 and h2 of the first two that follow the edge, from there on, and the first
// differences a = P1 - P0 and c = P2 - P1, the rows of the derivatives across are
//   T = q a/h1,  W = q (q-1)/h1 (c/h2 - a/h1),
// coefficient by coefficient, over the knots along the edge.
template <class Field> struct Spline_side {
  typedef std::array<std::int64_t, 3> Point;

  int q;
  Field h1, h2;
  std::vector<Field> knots; // along the edge
  std::vector<std::array<double, 3>> given[3];
  std::vector<Point> p[3];

  // Returns whether the surface has such an edge, of a degree of at least 2 across it.
  template <class Traits> bool take(const Bspline_surface<Traits>& s, Patch_edge edge) {
    const Knot_vector<double>&along = s.knots_along(edge), &across = s.knots_across(edge);
    q = across.degree();
    if (q < 2 || along.degree() < 1 || !along.is_clamped() || !across.is_clamped()) return false;
    const int last = across.size() - 1, m = across.number_of_coefficients();
    const bool upper = at_upper_end(edge);
    const auto knot = [&](int i) { return Field(upper ? -across[last - i] : across[i]); };
    h1 = Field(knot(q + 1) - knot(q));
    h2 = Field(knot(q + 2) - knot(q));
    for (double u : along) knots.emplace_back(u);
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < along.number_of_coefficients(); ++i) {
        const int side = upper ? m - 1 - j : j;
        const Coordinates<Traits> x = Geometric_continuity::coordinates<Traits>(
            runs_along_u(edge) ? s.control_point(i, side) : s.control_point(side, i));
        given[j].push_back({x[0], x[1], x[2]});
      }
    return true;
  }

  void reverse() {
    std::reverse(knots.begin(), knots.end());
    for (Field& u : knots) u = Field(-u);
    for (auto& row : given) std::reverse(row.begin(), row.end());
  }

  static Point difference(const Point& x, const Point& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
  std::size_t size() const { return p[0].size(); }
  Point a(std::size_t i) const { return difference(p[1][i], p[0][i]); }
  Point c(std::size_t i) const { return difference(p[2][i], p[1][i]); }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_EDGE_INPUT_H
