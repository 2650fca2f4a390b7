// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_INFLECTIONS_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_INFLECTIONS_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_turns.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

/// \file inflections.h
/// The inflections of the pieces of a plane fair spline, decided exactly, and the pieces that have
/// more of them than the polygon of the points asks for.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The inflections of a piece in the plane, and the signs of its curvature beside its ends.
struct Inflections {
  int number, first, last;
};

// Returns them by the signs of d1 x d2: of its coefficients where these are as few as are wanted,
// or else of itself, between its roots.
template <class Traits, int Degree> Inflections inflections_of(const Bezier_curve<Traits, Degree>& piece, int wanted) {
  typedef typename Traits::FT FT;
  typedef std::conditional_t<std::is_floating_point_v<FT>, typename Exact_field<FT>::type, FT> Exact;
  std::array<std::array<Exact, 5>, 2> first;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 5; ++i) first[k][i] = Exact(piece.coordinates(i + 1)[k]) - Exact(piece.coordinates(i)[k]);
  const auto changes_of = [](const auto& bend) {
    Inflections changes{0, 0, 0};
    for (int i = 0; i <= bend.degree(); ++i) {
      const int sign = 0 < bend[i] ? 1 : bend[i] < 0 ? -1 : 0;
      if (sign == 0) continue;
      if (changes.last == -sign) ++changes.number;
      if (changes.first == 0) changes.first = sign;
      changes.last = sign;
    }
    return changes;
  };
  const auto bend_of = [](const auto& x, const auto& y) { // x y' - y x'
    typedef std::decay_t<decltype(x[0])> NT;
    const auto slope = [](const auto& z) {
      std::vector<NT> d;
      for (std::size_t i = 0; i + 1 < z.size(); ++i) d.push_back(NT(z[i + 1] - z[i]));
      return Bernstein_polynomial<NT>(std::move(d));
    };
    const Bernstein_polynomial<NT> p(x.begin(), x.end()), q(y.begin(), y.end());
    return Bernstein_polynomial<NT>(p * slope(y) - q * slope(x));
  };
  // in floating-point numbers, where no coefficient is near 0
  std::array<std::array<double, 5>, 2> rounded;
  double largest = 0;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 5; ++i) {
      rounded[k][i] = rounded_number(first[k][i]);
      largest = (std::max)(largest, std::abs(rounded[k][i]));
    }
  const Bernstein_polynomial<double> near = bend_of(rounded[0], rounded[1]);
  bool is_sure = true;
  for (int i = 0; i <= near.degree(); ++i) is_sure = is_sure && std::abs(near[i]) > 1e-13 * largest * largest;
  if (is_sure)
    if (const Inflections changes = changes_of(near); changes.number <= wanted) return changes;
  const Bernstein_polynomial<Exact> bend = bend_of(first[0], first[1]);
  Inflections changes = changes_of(bend);
  if (changes.number <= wanted) return changes;
  changes.number = 0;
  for (const auto& root : isolate_roots(bend)) {
    const bool at_an_end = root.begin == root.end && (root.begin == 0 || root.end == 1);
    if (!at_an_end && root.multiplicity % 2 == 1) ++changes.number;
  }
  return changes;
}

// The numbers of the pieces with more inflections than the polygon asks for. The inflection of a
// point between turns to different sides may be on a piece beside it.
inline std::vector<int> pieces_with_waves(const Fair_turns& turns, const std::vector<Inflections>& pieces) {
  const int n = static_cast<int>(pieces.size());
  const auto is_moved = [&](int point, int piece, int other) {
    const Inflections &a = pieces[piece], &b = pieces[other];
    return turns.is_inflection(point) && a.number == 1 && turns.inflections(piece) == 0 && b.number == 0 &&
           (piece == point ? a.first * b.last : a.last * b.first) > 0;
  };
  std::vector<int> waves;
  for (int i = 0; i < n; ++i)
    if (pieces[i].number > turns.inflections(i) && !is_moved(i, i, (i + n - 1) % n) &&
        !is_moved(turns.after(i), i, (i + 1) % n))
      waves.push_back(i);
  return waves;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_INFLECTIONS_H
