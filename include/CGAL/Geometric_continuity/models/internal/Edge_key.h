// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H
#define CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H

#include <CGAL/Geometric_continuity/edges/internal/Edge_piece.h>
#include <CGAL/Geometric_continuity/numbers/internal/Common_denominator.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Numbers that two edges have in common if and only if they are the same curve after affine maps of both domains to [0, 1],
// in either direction, whatever their degrees and knots. For each interval on which the curve is one polynomial: its start and
// the coefficients of the powers of the parameter of the whole, up to the last that is not zero; in the direction that makes
// them smaller. Homogeneous points, N = 4, have them in common up to a factor, see normalise(). For sorting many edges; two edges
// are compared by Common_edge_part and Edge_sides::align().
template <class Traits, int N = 3> class Edge_key {
  typedef Edge_field<Traits> Field;
  typedef typename Exact_number<Field>::type Exact; // compared often, evaluated once
  typedef typename Edge_rows<Field, N>::Row Row;
  struct Piece {
    Field begin, end;
    Row row; // the polynomial on [0, 1]
  };

  std::vector<std::vector<Exact>> numbers_;
  bool turned_ = false;

public:
  template <class Surface> Edge_key(const Surface& surface, Patch_edge edge) {
    const Work_on_object work("model_continuity");
    std::vector<Piece> pieces = unit_pieces(surface, edge);
    for (const Piece& piece : pieces) charge_powers<Field>(piece.row);
    numbers_ = numbers(pieces);
    std::reverse(pieces.begin(), pieces.end());
    for (Piece& piece : pieces) {
      std::reverse(piece.row.begin(), piece.row.end());
      piece.begin = Field(Field(1) - piece.end);
    }
    std::vector<std::vector<Exact>> backwards = numbers(pieces);
    turned_ = backwards < numbers_;
    if (turned_) numbers_.swap(backwards);
  }

  bool single_point() const { return numbers_.size() == 1 && numbers_[0].size() == N + 1; }

  // Whether the numbers are those of the reversed edge. Of two edges with equal keys that differ in this, one is
  // the other backwards. (An edge that is the same backwards is not turned.)
  bool turned() const { return turned_; }

  // Negative, zero or positive.
  int compare(const Edge_key& other) const {
    return numbers_ < other.numbers_ ? -1 : other.numbers_ < numbers_ ? 1 : 0;
  }

private:
  // Homogeneous points are divided by the first number of the last coefficient; but those of a single point become this point.
  static void normalise(Row& powers) {
    if constexpr (N == 4) {
      const auto& last = powers.back();
      const auto is_multiple = [&](const auto& x) {
        for (int i = 0; i < 3; ++i)
          if (x[i] * last[3] != last[i] * x[3]) return false;
        return true;
      };
      int i = 0;
      while (last[i] == Field(0)) ++i;
      if (last[3] != Field(0) && std::all_of(powers.begin(), powers.end(), is_multiple)) {
        const typename Row::value_type point = last;
        powers.assign(1, point);
        i = 3;
      }
      const Field factor = powers.back()[i];
      for (auto& x : powers) x /= factor;
    }
  }

  template <class Surface> static std::vector<Piece> unit_pieces(const Surface& surface, Patch_edge edge) {
    if constexpr (Is_patch<Surface>::value) // row 0 is that of the only piece; no division is needed
      return {{Field(0), Field(1), row_in_space<Field, N>(surface.template rows<Field>(edge, 0)[0])}};
    else
      return pieces_of_spline(surface, edge);
  }

  template <class Surface> static std::vector<Piece> pieces_of_spline(const Surface& surface, Patch_edge edge) {
    const Knot_vector<Field> knots = knots_over<Field>(surface.knots_along(edge));
    const Row rows = bernstein_pieces(knots, row_in_space<Field, N>(surface.template rows<Field>(edge, 0)[0]));
    const std::pair<Field, Field> domain = knots.domain();
    const Field length = domain.second - domain.first;
    std::vector<Piece> pieces;
    auto row = rows.begin();
    for (int k : knots.spans()) {
      const Field span = knots[k + 1] - knots[k];
      const auto end = row + (knots.degree() + 1);
      pieces.push_back({Field(Field(knots[k] - domain.first) / length),
                        Field(Field(knots[k + 1] - domain.first) / length),
                        restricted(Row(row, end), Field(Field(domain.first - knots[k]) / span),
                                   Field(Field(domain.second - knots[k]) / span))});
      row = end;
    }
    return pieces;
  }

  static std::vector<std::vector<Exact>> numbers(const std::vector<Piece>& pieces) {
    std::vector<std::vector<Exact>> result;
    Row last;
    for (const Piece& piece : pieces) {
      Row powers = powers_from_bernstein<Field>(piece.row);
      normalise(powers);
      if (powers == last) continue; // the same polynomial goes on
      result.emplace_back(1, Exact_number<Field>::of(piece.begin));
      for (const auto& a : powers)
        for (const Field& x : a) result.back().push_back(Exact_number<Field>::of(x));
      last.swap(powers);
    }
    return result;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_MODELS_INTERNAL_EDGE_KEY_H
