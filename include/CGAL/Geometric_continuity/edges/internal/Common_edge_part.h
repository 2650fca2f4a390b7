// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_COMMON_EDGE_PART_H
#define CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_COMMON_EDGE_PART_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/edges/Edge_rows.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>
#include <CGAL/Geometric_continuity/splines/internal/change_knots.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// \file Common_edge_part.h
/// The rows along an edge of a piecewise polynomial surface, one Bernstein form for each span of
/// the knots; the parts of two piecewise polynomial edges that are the same curve, and the spans on
/// which both are polynomials.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// Takes note of the conversion of a row to powers, and of as many operations again: about n^2 for n
// coefficients, with their common denominator.
template <class Field, class Row> void charge_powers(const Row& row) {
  Common_denominator<Field> denominator;
  for (const auto& p : row)
    for (const Field& x : p) {
      denominator.include(x);
      work_meter().charge_divisors(1, denominator.words(), number_words(x));
    }
  const double n = static_cast<double>(row.size());
  work_meter().charge_products(n * n, denominator.words());
}

// The rows on an interval on which they are polynomials, in Bernstein form.
template <class Field, int N = 3> struct Edge_piece {
  Field begin, end;
  Edge_rows<Field, N> rows;

  Field length() const { return Field(end - begin); }
};

// Returns the rows on each span of the knots, in an exact field. \throws Error
// `wrong_number_of_points`, `not_finite`
template <class Field, class FT, int N>
std::vector<Edge_piece<Field, N>> edge_pieces(const Spline_edge_rows<FT, N>& edge) {
  typedef typename Edge_rows<Field, N>::Row Row;
  const Knot_vector<Field> knots = knots_over<Field>(edge.knots);
  const std::vector<int> spans = knots.spans();
  std::vector<Edge_piece<Field, N>> pieces;
  for (int k : spans) pieces.push_back({knots[k], knots[k + 1], {}});
  const auto add_row = [&](const typename Edge_rows<FT, N>::Row& row, Row Edge_rows<Field, N>::*member) {
    check_number_of_coefficients(knots, row, "edge_pieces");
    const Row b = bernstein_pieces(knots, row_in_space<Field, N>(row));
    const std::size_t n = b.size() / pieces.size();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      (pieces[i].rows.*member).assign(b.begin() + i * n, b.begin() + (i + 1) * n);
  };
  add_row(edge.rows.edge, &Edge_rows<Field, N>::edge);
  add_row(edge.rows.cross, &Edge_rows<Field, N>::cross);
  add_row(edge.rows.second_cross, &Edge_rows<Field, N>::second_cross);
  if (!edge.rows.third_cross.empty()) add_row(edge.rows.third_cross, &Edge_rows<Field, N>::third_cross);
  return pieces;
}

// Lifts points to homogeneous points, with the weight 1.
template <class Field>
typename Edge_rows<Field, 4>::Row lifted(const typename Edge_rows<Field>::Row& row, const Field& weight) {
  typename Edge_rows<Field, 4>::Row result(row.size(), Coordinate_vector<Field, 4>(4));
  for (std::size_t i = 0; i < row.size(); ++i) {
    for (int x = 0; x < 3; ++x) result[i][x] = row[i][x];
    result[i][3] = weight;
  }
  return result;
}
template <class Field> std::vector<Edge_piece<Field, 4>> lifted(const std::vector<Edge_piece<Field>>& pieces) {
  std::vector<Edge_piece<Field, 4>> result;
  for (const Edge_piece<Field>& piece : pieces)
    result.push_back(
        {piece.begin,
         piece.end,
         {lifted<Field>(piece.rows.edge, Field(1)), lifted<Field>(piece.rows.cross, Field(0)),
          lifted<Field>(piece.rows.second_cross, Field(0)), lifted<Field>(piece.rows.third_cross, Field(0))}});
  return result;
}

// Takes an edge of a surface. A patch has one piece, which needs no knots.
template <class Surface>
std::vector<Edge_piece<Edge_field<typename Surface::Traits>, row_dimension<Surface>>>
edge_pieces(const Surface& surface, Patch_edge edge, int order = 2) {
  typedef Edge_field<typename Surface::Traits> Field;
  if constexpr (Is_patch<Surface>::value) {
    const std::pair<Field, Field> domain = edge_domain<Field>(surface, edge);
    return {{domain.first, domain.second, edge_rows(surface, edge, order)}};
  } else
    return edge_pieces<Field>(spline_edge_rows(surface, edge, order));
}

// Returns the pieces with N coordinates, 3 or 4, and the third derivatives for the order 3.
template <int N, class Surface>
std::vector<Edge_piece<Edge_field<typename Surface::Traits>, N>> edge_pieces_in(const Surface& surface, Patch_edge edge,
                                                                                int order = 2) {
  if constexpr (N == row_dimension<Surface>)
    return edge_pieces(surface, edge, order);
  else
    return lifted(edge_pieces(surface, edge, order));
}

// The coefficients on [x, y], x < y and 0 < y, of a polynomial with Bernstein coefficients on [0,
// 1], which need not contain x and y; none of none.
template <class Field, class Row> Row restricted(Row row, const Field& x, const Field& y) {
  if (row.empty()) return row;
  const int n = static_cast<int>(row.size()) - 1;
  Row part = row;
  if (y != Field(1)) { // to [0, y]
    bernstein_split(row, n, y, part);
    row.swap(part);
  }
  if (x != Field(0)) bernstein_split(row, n, Field(x / y), part);
  return row;
}

// The rows on a part [begin, end] of a piece.
template <class Field, int N>
Edge_rows<Field, N> rows_on(const Edge_piece<Field, N>& piece, const Field& begin, const Field& end) {
  const Field length = piece.length(), x = Field(begin - piece.begin) / length, y = Field(end - piece.begin) / length;
  return {restricted(piece.rows.edge, x, y), restricted(piece.rows.cross, x, y),
          restricted(piece.rows.second_cross, x, y), restricted(piece.rows.third_cross, x, y)};
}

// The rows of two homogeneous edges, the second divided by a factor so that their first points have
// equal weights: then edges that are the same curve have the same coefficients. Rows of points stay
// as they are.
template <class Field, int N>
std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>> with_equal_weights(Edge_rows<Field, N> a, Edge_rows<Field, N> b) {
  if constexpr (N == 4) {
    for (const Edge_rows<Field, N>* rows : {&a, &b}) require_denominator(rows->edge[0][3], "edge_continuity");
    const Field factor = Field(a.edge[0][3] / b.edge[0][3]);
    if (factor != Field(1))
      for (auto* row : {&b.edge, &b.cross, &b.second_cross, &b.third_cross})
        for (Coordinate_vector<Field, N>& x : *row) x *= factor;
  }
  return {std::move(a), std::move(b)};
}

// t -> scale t + shift, scale != 0: from the parameters of one edge to those of another.
template <class Field> struct Affine_parameter_map {
  Field scale, shift;

  Field operator()(const Field& t) const { return Field(scale * t + shift); }
  Field inverse(const Field& s) const { return Field(Field(s - shift) / scale); }
  bool reverses() const { return scale < Field(0); }
};

// A polynomial curve sum_k a_k (t - centre)^k of degree n with a_{n-1} . a_n = 0, which is a normal
// form: curves that differ by an affine map of the parameter have the a_k in common, up to the
// factor scale^k; curves of homogeneous points, N = 4, up to one more factor. (With a factor that
// is not constant they are the same curve, too, which is not recognised unless they are a point.)
template <class Field, int N> class Centred_curve {
  typedef Coordinate_vector<Field, N> Vector;

  std::vector<Vector> a_;
  Field centre_;

public:
  Centred_curve(const Edge_piece<Field, N>& piece) {
    charge_powers<Field>(piece.rows.edge);
    if (is_point(piece.rows.edge))
      a_.assign(1, piece.rows.edge[0]);
    else
      a_ = powers_from_bernstein<Field>(piece.rows.edge);
    const int n = degree();
    if (n == 0) return; // a point
    const Field x = Field(-dot(a_[n - 1], a_[n])) / Field(Field(n) * dot(a_[n], a_[n]));
    for (int i = 0; i < n; ++i) // Horner's rule: powers of the distance from x
      for (int k = n - 1; k >= i; --k) a_[k] += x * a_[k + 1];
    centre_ = Field(piece.begin + x * piece.length());
    Field power(1);
    for (int k = 1; k <= n; ++k) {
      power = Field(power / piece.length());
      a_[k] *= power;
    }
  }

  int degree() const { return static_cast<int>(a_.size()) - 1; }

  // Returns whether b(map(t)) = a(t) for all t.
  friend bool agree(const Centred_curve& a, const Centred_curve& b, const Affine_parameter_map<Field>& map) {
    if (a.degree() != b.degree()) return false;
    if (a.degree() > 0 && map(a.centre_) != b.centre_) return false;
    Field power(1);
    if constexpr (N == 4) { // the factor of all coefficients, from the last
      power = ratio(a.a_.back(), b.a_.back());
      for (int k = 0; k < a.degree(); ++k) power = Field(power / map.scale);
    }
    for (int k = 0; k <= a.degree(); ++k) {
      if (a.a_[k] != power * b.a_[k]) return false;
      power = Field(power * map.scale);
    }
    return true;
  }

  // The map with b(map(t)) = a(t), if there is only one and it is found without roots: the
  // exponents k > 0 that occur have no common divisor. Then scale = scale^gcd is a product of
  // powers of the factors a_k / b_k = scale^k, by Euclid's algorithm. For homogeneous points these
  // are (a_n / b_n) / (a_{n-k} / b_{n-k}).
  friend std::optional<Affine_parameter_map<Field>> unique_map(const Centred_curve& a, const Centred_curve& b) {
    if (a.degree() != b.degree()) return std::nullopt;
    int gcd = 0;
    // equivalent [1 -> 2, 1]: the first factor takes its place
    Field scale(1); // to the power of gcd
    for (int k = 1; k <= a.degree(); ++k) {
      const int i = N == 4 ? a.degree() - k : k;
      if (is_zero(a.a_[i]) != is_zero(b.a_[i])) return std::nullopt;
      if (is_zero(a.a_[i])) continue;
      int next = k;
      Field factor = ratio(a.a_[i], b.a_[i]);
      if (factor == Field(0)) return std::nullopt;
      if constexpr (N == 4) factor = Field(ratio(a.a_.back(), b.a_.back()) / factor);
      if (factor == Field(0)) return std::nullopt;
      while (next > 0) {
        for (; gcd >= next; gcd -= next) scale = Field(scale / factor);
        std::swap(gcd, next);
        std::swap(scale, factor);
      }
    }
    if (gcd != 1) return std::nullopt;
    const Affine_parameter_map<Field> map{scale, Field(b.centre_ - scale * a.centre_)};
    return agree(a, b, map) ? std::optional<Affine_parameter_map<Field>>(map) : std::nullopt;
  }

private:
  // Returns the ratio of two parallel vectors.
  static Field ratio(const Vector& x, const Vector& y) { return Field(dot(x, y) / dot(y, y)); }

  // Returns whether all homogeneous points are multiples of the first, which is not infinite.
  static bool is_point(const std::vector<Vector>& p) {
    return N == 4 && std::all_of(p.begin(), p.end(), [&](const Vector& x) {
             for (int i = 0; i < 3; ++i)
               if (x[i] * p[0][N - 1] != p[0][i] * x[N - 1]) return false;
             return true;
           });
  }
};

// A span of the common refinement of two edges, in the parameters of the first, and the pieces that
// contain it.
template <class Field> struct Common_span {
  Field begin, end;
  std::size_t a, b;
};

// The common spans on which two edges are the same curve under a map.
template <class Field> struct Edge_match {
  Affine_parameter_map<Field> map;
  std::vector<Common_span<Field>> spans;
};

// All spans of the common domain of two edges under a map.
template <class Field, int N>
std::vector<Common_span<Field>> common_spans(const std::vector<Edge_piece<Field, N>>& a,
                                             const std::vector<Edge_piece<Field, N>>& b,
                                             const Affine_parameter_map<Field>& map) {
  // the pieces of the second edge in the parameters of the first
  std::vector<Common_span<Field>> mapped;
  for (std::size_t j = 0; j < b.size(); ++j) mapped.push_back({map.inverse(b[j].begin), map.inverse(b[j].end), 0, j});
  if (map.reverses()) {
    std::reverse(mapped.begin(), mapped.end());
    for (auto& x : mapped) std::swap(x.begin, x.end);
  }
  std::vector<Common_span<Field>> spans;
  for (std::size_t i = 0, j = 0; i < a.size() && j < mapped.size();) {
    const Field &begin = (std::max)(a[i].begin, mapped[j].begin), &end = (std::min)(a[i].end, mapped[j].end);
    if (begin < end) spans.push_back({begin, end, i, mapped[j].b});
    const bool next_a = !(mapped[j].end < a[i].end), next_b = !(a[i].end < mapped[j].end);
    i += next_a;
    j += next_b;
  }
  return spans;
}

// Returns the map from the whole of one edge to the whole of another.
template <class Field, int N>
Affine_parameter_map<Field> whole_map(const std::vector<Edge_piece<Field, N>>& a,
                                      const std::vector<Edge_piece<Field, N>>& b, Edge_direction direction) {
  const bool backwards = direction == Edge_direction::opposite;
  const Field begin = backwards ? b.back().end : b.front().begin, end = backwards ? b.front().begin : b.back().end;
  const Field scale = Field(end - begin) / Field(a.back().end - a.front().begin);
  return {scale, Field(begin - scale * a.front().begin)};
}

// Takes two edges that are the same as a whole.
template <class Field, int N>
Edge_match<Field> whole_match(const std::vector<Edge_piece<Field, N>>& a, const std::vector<Edge_piece<Field, N>>& b,
                              Edge_direction direction) {
  const Affine_parameter_map<Field> map = whole_map(a, b, direction);
  return {map, common_spans(a, b, map)};
}

// The rows of both edges on a common span, in the direction of the first, with equal weights where
// it begins.
template <class Field, int N>
std::pair<Edge_rows<Field, N>, Edge_rows<Field, N>>
rows_on(const std::vector<Edge_piece<Field, N>>& a, const std::vector<Edge_piece<Field, N>>& b,
        const Common_span<Field>& span, const Affine_parameter_map<Field>& map) {
  const bool reversed = map.reverses();
  const Edge_rows<Field, N> rows =
      rows_on(b[span.b], map(reversed ? span.end : span.begin), map(reversed ? span.begin : span.end));
  return with_equal_weights(rows_on(a[span.a], span.begin, span.end), reversed ? rows.reversed() : rows);
}

// Finds the part that two edges have in common. The test for whole edges is also made, faster, by
// Edge_sides::align() for two polynomials, by same_edge() in Edge_input.h for control points, and
// by Edge_key for all edges of a model.
template <class Field, int N = 3> class Common_edge_part {
  typedef std::vector<Edge_piece<Field, N>> Pieces;
  typedef Affine_parameter_map<Field> Map;
  typedef std::vector<Common_span<Field>> Spans;

  const Pieces &a_, &b_;
  std::vector<Centred_curve<Field, N>> curves_a_, curves_b_;

public:
  Common_edge_part(const Pieces& a, const Pieces& b) : a_(a), b_(b) {
    for (const Edge_piece<Field, N>& piece : a) curves_a_.emplace_back(piece);
    for (const Edge_piece<Field, N>& piece : b) curves_b_.emplace_back(piece);
  }

  // The whole edges if they are the same, forwards or else backwards.
  std::optional<Edge_match<Field>> whole() const {
    for (Edge_direction direction : {Edge_direction::same, Edge_direction::opposite}) {
      Edge_match<Field> match = whole_match(a_, b_, direction);
      if (std::all_of(match.spans.begin(), match.spans.end(), [&](const auto& span) { return same(span, match.map); }))
        return match;
    }
    return std::nullopt;
  }

  // The whole edges if they are the same; otherwise the longest common part that contains an end
  // piece of one of them. No spans if there is none.
  Edge_match<Field> operator()() const {
    if (std::optional<Edge_match<Field>> match = whole()) return *std::move(match);
    Edge_match<Field> best{whole_map(a_, b_, Edge_direction::same), {}};
    const std::size_t m = a_.size(), n = b_.size();
    for (std::size_t i = 0; i < m; ++i) {
      propose(i, 0, best);
      if (n > 1) propose(i, n - 1, best);
    }
    for (std::size_t j = 1; j + 1 < n; ++j) {
      propose(0, j, best);
      if (m > 1) propose(m - 1, j, best);
    }
    return best;
  }

private:
  bool same(const Common_span<Field>& span, const Map& map) const {
    return agree(curves_a_[span.a], curves_b_[span.b], map);
  }

  // The longest run of common spans under the map that is found from two pieces, if it is longer
  // than the best one.
  void propose(std::size_t i, std::size_t j, Edge_match<Field>& best) const {
    const std::optional<Map> map = unique_map(curves_a_[i], curves_b_[j]);
    if (!map) return;
    const Spans spans = common_spans(a_, b_, *map);
    for (auto first = spans.begin(), last = first; first != spans.end(); first = last) {
      if (!same(*first, *map)) {
        last = first + 1;
        continue;
      }
      while (last != spans.end() && same(*last, *map)) ++last;
      if (length(best.spans) < Field((last - 1)->end - first->begin)) best = {*map, Spans(first, last)};
    }
  }

  static Field length(const Spans& spans) {
    return spans.empty() ? Field(0) : Field(spans.back().end - spans.front().begin);
  }
};

template <class Field, int N>
Edge_match<Field> common_edge_part(const std::vector<Edge_piece<Field, N>>& a,
                                   const std::vector<Edge_piece<Field, N>>& b) {
  return Common_edge_part<Field, N>(a, b)();
}

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EDGES_INTERNAL_COMMON_EDGE_PART_H
