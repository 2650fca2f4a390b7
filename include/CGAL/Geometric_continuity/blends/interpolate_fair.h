// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_joints.h>
#include <CGAL/Geometric_continuity/blends/representable_blend.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file interpolate_fair.h
/// Splines of fair quintic blends through points. At each point both blends have one jet (point,
/// tangent, curvature), so that the joins are exactly \f$ G^2 \f$, whatever tangents and curvatures
/// are chosen.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A \f$ G^2 \f$ spline of fair quintics through points: a segmented curve over the knots 0, 1, 2,
/// ... that meets the points there.
template <class Traits> struct Fair_spline : Composite_bezier_curve<Traits, 5> {
  /// The largest change of a coordinate of a point, which leaves room for exact joins: 0 with an
  /// exact kernel.
  typename Traits::FT moved;
  /// The numbers of the points at which rounding may have broken the join: none with an exact
  /// kernel.
  std::vector<int> rounded;
  /// In the plane the numbers of the pieces that were not proved to have as few inflections as
  /// their side of the polygon: one where the polygon turns to different sides at its ends, or else
  /// none. All others are proved by Descartes' rule and isolated roots. Where a small turn is
  /// between turns to different sides, the inflection may be on either side of its point. Empty in
  /// other dimensions, where nothing is asked.
  std::vector<int> waves;

  /// Takes the curve, the effects of rounding and the pieces with waves.
  Fair_spline(const Composite_bezier_curve<Traits, 5>& curve, const typename Traits::FT& change,
              std::vector<int> rounded_joins, std::vector<int> with_waves = {})
      : Composite_bezier_curve<Traits, 5>(curve), moved(change), rounded(std::move(rounded_joins)),
        waves(std::move(with_waves)) {}
};

namespace internal {

// Chooses tangents and curvatures, in the plane and in space the fair ones, and returns the handles
// of the pieces there.
template <int N> std::vector<Fair_handles> choose_fair_joints(std::vector<Fair_joint<N>>& joints, bool closed) {
  std::vector<Fair_handles> handles;
  const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
  const auto in_dimension = [&](auto dimension) {
    constexpr int M = decltype(dimension)::value;
    const auto column = [](const auto& x) {
      Coordinate_vector<double, M> y(M);
      for (int i = 0; i < M; ++i) y[i] = x[i];
      return y;
    };
    std::vector<Fair_joint<M>> chosen;
    for (const Fair_joint<N>& j : joints)
      chosen.push_back({column(j.point), column(j.tangent), column(j.curvature), j.given});
    handles = Fair_joints<M>(chosen, closed).minimise();
    for (std::size_t k = 0; k < joints.size(); ++k)
      for (int i = 0; i < M; ++i) {
        joints[k].tangent[i] = chosen[k].tangent[i];
        joints[k].curvature[i] = chosen[k].curvature[i];
      }
  };
  take_circles<N>(joints, closed);
  if (joints[0].point.dimension() == 2)
    in_dimension(std::integral_constant<int, 2>());
  else if (joints[0].point.dimension() == 3)
    in_dimension(std::integral_constant<int, 3>());
  return handles;
}

// The coordinates of the point number i, or of the tangent there, rounded to doubles.
template <class Traits>
Coordinate_vector<double, dimension_v<Traits>> rounded_column(const Coordinates<Traits>& x, int dimension, int i) {
  if (x.dimension() != dimension)
    throw Error(Error_code::dimension_mismatch, "interpolate_fair: at the point " + std::to_string(i));
  Coordinate_vector<double, dimension_v<Traits>> y(dimension);
  for (int k = 0; k < dimension; ++k) {
    check_finite(x[k], "interpolate_fair: a coordinate");
    y[k] = rounded_number(x[k]);
    check_finite(y[k], "interpolate_fair: a coordinate");
  }
  return y;
}

// The points through which a fair spline leads, with the tangents that are given. They are in an
// order that does not depend on the direction of the given ones: an open curve starts at the lesser
// of its ends, a closed one at the least of its points and towards the lesser of the next ones. So
// reversed points get the reversed curve, whatever is rounded.
template <class Traits> struct Fair_points {
  std::vector<Coordinates<Traits>> points;
  std::vector<std::optional<Coordinates<Traits>>> tangents;
  bool closed;
  int start = 0; // the number of the first one, of those that are given
  bool is_reversed = false;
  double size = 0;   // the largest coordinate
  double extent = 0; // that seen from the first point

  int exponent() const { return extent > 0 ? std::ilogb(extent) : 0; }
  Coordinates<Traits> from_first(int i) const { return points[i] - points[0]; }
  int number() const { return static_cast<int>(points.size()); }
  int next(int i) const { return (i + 1) % number(); }
  int pieces() const { return closed ? number() : number() - 1; }
  // The numbers of a point and of a piece among those that are given.
  int given(int i) const { return (is_reversed ? start - i + number() : start + i) % number(); }
  int given_piece(int i) const { return is_reversed ? given(next(i)) : given(i); }

  void order() {
    const int n = number();
    const auto is_less = [](const Coordinates<Traits>& a, const Coordinates<Traits>& b) {
      for (int k = 0; k < a.dimension(); ++k) {
        if (a[k] < b[k]) return true;
        if (b[k] < a[k]) return false;
      }
      return false;
    };
    if (closed) {
      start = static_cast<int>(std::min_element(points.begin(), points.end(), is_less) - points.begin());
      is_reversed = is_less(points[(start + n - 1) % n], points[next(start)]);
    } else {
      is_reversed = is_less(points.back(), points.front());
      start = is_reversed ? n - 1 : 0;
    }
    std::vector<Coordinates<Traits>> ordered;
    std::vector<std::optional<Coordinates<Traits>>> ordered_tangents;
    for (int i = 0; i < n; ++i) {
      ordered.push_back(points[given(i)]);
      if (tangents.empty()) continue;
      ordered_tangents.push_back(tangents[given(i)]);
      if (is_reversed && ordered_tangents.back())
        *ordered_tangents.back() = typename Traits::FT(-1) * *ordered_tangents.back();
    }
    points = std::move(ordered);
    tangents = std::move(ordered_tangents);
  }
};

template <class Traits, class InputIterator>
Fair_points<Traits> points_of_fair_spline(InputIterator first, InputIterator last, Closure closure,
                                          const std::vector<std::optional<typename Traits::Vector>>& tangents) {
  Fair_points<Traits> p{{}, {}, closure == Closure::closed};
  for (; first != last; ++first) p.points.push_back(Geometric_continuity::coordinates<Traits>(*first));
  if (p.number() < (p.closed ? 3 : 2))
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(p.number()) + " points");
  if (!tangents.empty() && tangents.size() != p.points.size())
    throw Error(Error_code::wrong_number_of_points, "interpolate_fair: " + std::to_string(tangents.size()) +
                                                        " tangents for " + std::to_string(p.number()) + " points");
  for (const std::optional<typename Traits::Vector>& t : tangents) {
    p.tangents.emplace_back();
    if (t) p.tangents.back() = Geometric_continuity::coordinates<Traits>(*t);
  }
  const int dimension = p.points[0].dimension();
  for (int i = 0; i < p.number(); ++i)
    for (const double x : rounded_column<Traits>(p.points[i], dimension, i)) p.size = (std::max)(p.size, std::abs(x));
  for (int i = 0; i < p.pieces(); ++i)
    if (p.points[i] == p.points[p.next(i)])
      throw Error(Error_code::empty_domain, "interpolate_fair: the points " + std::to_string(i) + " and " +
                                                std::to_string(p.next(i)) + " coincide");
  p.order();
  for (int i = 0; i < p.number(); ++i)
    for (const double x : rounded_column<Traits>(p.from_first(i), dimension, p.given(i)))
      p.extent = (std::max)(p.extent, std::abs(x));
  return p;
}

// The multiple of 2^n nearest to x.
inline double multiple_of_power(double x, int n) { return std::ldexp(std::nearbyint(std::ldexp(x, -n)), n); }

// The exponent of a unit of all coordinates so that `digits` of those of the largest one are left
// for the points of the blends; below all exponents where no number is rounded.
template <class FT> int unit_with_room(double size, int digits) {
  if constexpr (std::is_floating_point_v<FT>)
    if (size > 0) return std::ilogb(size) + digits - std::numeric_limits<FT>::digits;
  return -1000;
}

// Leaves 7 digits for that, with floating-point numbers. Returns the largest change of a
// coordinate.
template <class Traits> typename Traits::FT round_points(Fair_points<Traits>& p) {
  typedef typename Traits::FT FT;
  FT moved(0);
  if constexpr (std::is_floating_point_v<FT>)
    for (Coordinates<Traits>& x : p.points)
      for (int k = 0; k < x.dimension(); ++k) {
        const FT given = x[k];
        // equivalent [7 -> 8, 1]: one digit more of room
        x[k] = FT(multiple_of_power(given, unit_with_room<FT>(p.size, 7)));
        moved = (std::max)(moved, FT(std::abs(x[k] - given)));
      }
  return moved;
}

// The points, in units of the power of two below the largest coordinate, with the tangents that are
// given.
template <class Traits> std::vector<Fair_joint<dimension_v<Traits>>> joints_of(const Fair_points<Traits>& p) {
  typedef Coordinate_vector<double, dimension_v<Traits>> Column;
  const int dimension = p.points[0].dimension();
  std::vector<Fair_joint<dimension_v<Traits>>> joints;
  for (int i = 0; i < p.number(); ++i) {
    Work_meter::pause();
    Column point = rounded_column<Traits>(p.from_first(i), dimension, p.given(i));
    for (int k = 0; k < dimension; ++k) point[k] = std::ldexp(point[k], -p.exponent());
    joints.push_back({point, Column(dimension), Column(dimension), false});
    if (p.tangents.empty() || !p.tangents[i]) continue;
    Column& tangent = joints.back().tangent;
    tangent = rounded_column<Traits>(*p.tangents[i], dimension, p.given(i));
    const double size = length(tangent);
    if (!(size > 0))
      throw Error(Error_code::zero_tangent, "interpolate_fair: at the point " + std::to_string(p.given(i)));
    tangent /= size;
    joints.back().given = true;
  }
  return joints;
}

// The lengths of the chords from each point to the next one, in the same units.
template <class Traits>
std::vector<double> chord_lengths(const Fair_points<Traits>& p,
                                  const std::vector<Fair_joint<dimension_v<Traits>>>& joints) {
  std::vector<double> lengths;
  for (int i = 0; i < p.pieces(); ++i) {
    lengths.push_back(length<dimension_v<Traits>>(joints[p.next(i)].point - joints[i].point));
    if (!(lengths.back() > 0))
      throw Error(Error_code::empty_domain, "interpolate_fair: the points " + std::to_string(p.given_piece(i)) +
                                                " and " + std::to_string((p.given_piece(i) + 1) % p.number()) +
                                                " coincide when they are rounded, to leave room for exact joins: "
                                                "subtract what all points have in common, or use exact numbers");
  }
  return lengths;
}

// The jet at a point: the tangent as long as the shorter chord h, or as its speed, and its square
// times the curvature, both of short numbers, from which all is constructed in the field.
template <class Traits> struct Short_jet {
  Coordinate_jet<typename Traits::FT, dimension_v<Traits>> jet;
  double speed;
  int digits; // binary ones that are left for handles
};

// Given tangents that are not rounded stay as they are.
template <class Traits>
Short_jet<Traits> short_jet(const Fair_points<Traits>& p, const std::vector<Fair_joint<dimension_v<Traits>>>& joints,
                            const std::vector<double>& lengths, int i) {
  typedef typename Traits::FT FT;
  constexpr bool rounds = std::is_floating_point_v<FT>;
  constexpr int most_digits = rounds ? (std::min)(20, std::numeric_limits<FT>::digits / 3) : 20,
                fewest_digits = 4; // so that no tangent is lost next to points that are far away
  const int n = p.exponent(), dimension = p.points[0].dimension();
  const double before = i > 0 ? lengths[i - 1] : lengths.back(), after = i < p.pieces() ? lengths[i] : before,
               h = (std::min)(p.closed || i > 0 ? before : after, after);
  // the binary digits below h that are left, and those of handles; the products of them and of
  // the jets need room
  const int room = rounds ? std::numeric_limits<FT>::digits - 4 + std::ilogb(h) + n - std::ilogb(p.size) : 80,
            digits = (std::min)(13, (room - 4) / 3);
  int unit = std::ilogb(h) - (digits >= 5 ? 20 : most_digits), unit_of_second = unit;
  if (digits >= 5) {
    unit = (std::max)(unit, std::ilogb(h) - room + digits);
    unit_of_second = (std::max)(unit, std::ilogb(h) - room + 2 * digits + 2);
  } else
    unit_of_second = unit = (std::max)(
        unit, (std::min)(std::ilogb(p.size) - n + 9 - std::numeric_limits<FT>::digits, std::ilogb(h) - fewest_digits));
  const bool is_kept = !rounds && joints[i].given;
  Short_jet<Traits> result{Coordinate_jet<FT, dimension_v<Traits>>(dimension, 2), h, digits};
  auto& jet = result.jet;
  jet[0] = p.points[i];
  double speed = h;
  if (is_kept) {
    jet[1] = *p.tangents[i];
    const Coordinate_vector<double, dimension_v<Traits>> t = rounded_column<Traits>(jet[1], dimension, p.given(i));
    speed = length(t);
    result.speed = std::ldexp(speed, -n);
  }
  const int unit_of_bend = is_kept ? unit + 2 * (std::ilogb(speed) - std::ilogb(h)) : unit_of_second;
  for (int k = 0; k < dimension; ++k) {
    if (!is_kept) jet[1][k] = short_number_in<FT>(std::ldexp(multiple_of_power(h * joints[i].tangent[k], unit), n));
    const double bend = multiple_of_power(speed * speed * joints[i].curvature[k], unit_of_bend),
                 second = std::ldexp(bend, is_kept ? -n : n);
    check_finite(second, "interpolate_fair: a second derivative");
    jet[2][k] = short_number_in<FT>(second);
  }
  return result;
}

// The end and the start of curves with a jet at their join: parabolas with these control points.
template <class Traits>
Bezier_curve<Traits> parabola(const Coordinate_jet<typename Traits::FT, dimension_v<Traits>>& jet, bool ends) {
  typedef typename Traits::FT FT;
  const FT half = FT(FT(1) / FT(2));
  const Coordinates<Traits> difference = half * jet[1], middle = ends ? jet[0] - difference : jet[0] + difference,
                            far = (ends ? middle - difference : middle + difference) + half * jet[2];
  const typename Traits::Point p[] = {to_point<Traits>(ends ? far : jet[0]), to_point<Traits>(middle),
                                      to_point<Traits>(ends ? jet[0] : far)};
  return Bezier_curve<Traits>(p, p + 3);
}

// Returns whether an end of a quintic has exactly the tangent and the curvature of a jet: b_1 - b_0
// is a positive multiple r of the tangent, and b_2 - b_0 - 5/4 r^2 of the second derivative is a
// multiple of it, too.
template <class Traits, class Jet> bool has_jet(const Bezier_curve<Traits, 5>& curve, const Jet& jet, bool at_end) {
  typedef typename Exact_field<typename Traits::FT>::type Exact;
  const int dimension = jet[0].dimension();
  const auto step = [&](int i, int k) {
    return Exact(Exact(curve.coordinates(at_end ? 5 - i : i)[k]) - Exact(jet[0][k]));
  };
  int large = 0;
  for (int k = 1; k < dimension; ++k)
    if (std::abs(jet[1][large]) < std::abs(jet[1][k])) large = k;
  const Exact tangent(jet[1][large]), r(step(1, large) / tangent);
  const auto rest = [&](int k) { return Exact(step(2, k) - r * r * Exact(jet[2][k]) * Exact(5) / Exact(4)); };
  if (!(at_end ? r < Exact(0) : Exact(0) < r)) return false;
  for (int k = 0; k < dimension; ++k)
    if (step(1, k) != r * Exact(jet[1][k]) || rest(k) * tangent != rest(large) * Exact(jet[1][k])) return false;
  return true;
}

// The blend of two jets by `Fair`, with joins that rounding does not move; nothing if there is
// none.
template <class Traits, class Jet>
std::optional<Bezier_curve<Traits, 5>> unmoved_blend(const Jet& start, const Jet& end) {
  try {
    const Representable_blend<Traits> blend =
        representable_blend(parabola<Traits>(start, true), parabola<Traits>(end, false), Fair());
    if (has_jet<Traits>(blend, start, false) && has_jet<Traits>(blend, end, true)) return blend;
  } catch (const Error& e) {
    if (e.code() != Error_code::not_representable) throw;
  }
  return std::nullopt;
}

// The quintic with these jets and handles; nothing where rounding would move its joins. Handles are
// told in the lengths of the tangents, with so many binary digits behind the point that all is
// exact.
template <class Traits, class Jet>
std::optional<Bezier_curve<Traits, 5>> quintic_with_handles(const Jet& start, const Jet& end, Fair_handles handles,
                                                            const std::array<double, 2>& speeds, int digits,
                                                            double size) {
  typedef typename Traits::FT FT;
  typedef Coordinates<Traits> Column;
  constexpr bool rounds = std::is_floating_point_v<FT>;
  if (rounds && digits < 5) return std::nullopt;
  const FT part = FT(FT(5) / FT(4));
  const auto short_handle = [&](double x) {
    return short_number_in<FT>(rounds ? multiple_of_power(x, -digits) : short_double<20>(x));
  };
  const auto inward = [&](int k) { // from the end: the next two points
    const Jet& jet = k == 0 ? start : end;
    const double least = rounds ? std::ldexp(1., -digits) : 0;
    const FT first = short_handle((std::max)(handles.first[k] / speeds[k], least)),
             second = short_handle(handles.second[k] / speeds[k]), sign = FT(k == 0 ? 1 : -1);
    return std::array<Column, 2>{FT(sign * first) * jet[1],
                                 FT(sign * second) * jet[1] + FT(part * FT(first * first)) * jet[2]};
  };
  const std::array<Column, 2> s = inward(0), e = inward(1);
  const std::array<Column, 6> b = {start[0], start[0] + s[0], start[0] + s[1], end[0] + e[1], end[0] + e[0], end[0]};
  std::vector<typename Traits::Point> points;
  for (const Column& x : b) {
    if constexpr (rounds)
      for (const FT& c : x)
        if (!(std::abs(c) < 8 * size)) return std::nullopt;
    points.push_back(to_point<Traits>(x));
  }
  return Bezier_curve<Traits, 5>(points.begin(), points.end());
}

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

// The pieces between jets, in the order of the points; in the plane those with waves are mended.
template <class Traits> class Fair_pieces {
  typedef typename Traits::FT FT;
  typedef Bezier_curve<Traits, 5> Piece;

  const Fair_points<Traits>& p_;
  const std::vector<double>& lengths_; // of the chords
  std::vector<Fair_joint<dimension_v<Traits>>> joints_;
  std::vector<Short_jet<Traits>> jets_;
  std::vector<Piece> pieces_;
  std::vector<char> is_rounded_; // points
  std::optional<Fair_turns> turns_;
  std::vector<Inflections> inflections_;

public:
  Fair_pieces(const Fair_points<Traits>& p, const std::vector<double>& lengths,
              std::vector<Fair_joint<dimension_v<Traits>>> joints, const std::vector<Fair_handles>& handles)
      : p_(p), lengths_(lengths), joints_(std::move(joints)), is_rounded_(p.number(), 0) {
    if (p.points[0].dimension() == 2) turns_.emplace(joints_, p.closed);
    for (int i = 0; i < p.number(); ++i) {
      Work_meter::pause();
      jets_.push_back(short_jet(p, joints_, lengths_, i));
    }
    for (int i = 0; i < p.pieces(); ++i) {
      Work_meter::pause();
      std::optional<Piece> piece;
      if (!handles.empty()) piece = with_handles(i, handles[i]);
      pieces_.push_back(piece ? std::move(*piece) : blended(i));
      if (turns_) inflections_.push_back(inflections_of(pieces_[i], turns_->inflections(i)));
    }
    if (turns_) mend_waves();
  }

  Fair_spline<Traits> spline(const FT& moved) const {
    std::vector<typename Traits::Point> points(5 * p_.pieces() + 1);
    std::vector<FT> knots(1, FT(0));
    for (int i = 0; i < p_.pieces(); ++i) {
      const auto place = points.begin() + 5 * p_.given_piece(i);
      if (p_.is_reversed)
        std::reverse_copy(pieces_[i].begin(), pieces_[i].end(), place);
      else
        std::copy(pieces_[i].begin(), pieces_[i].end(), place);
      knots.push_back(FT(i + 1));
    }
    std::vector<int> waves, rounded;
    if (turns_)
      for (const int i : pieces_with_waves(*turns_, inflections_)) waves.push_back(p_.given_piece(i));
    std::sort(waves.begin(), waves.end());
    for (int i = p_.closed ? 0 : 1; i < p_.pieces(); ++i)
      if (is_rounded_[i]) rounded.push_back(i);
    return Fair_spline<Traits>(Composite_bezier_curve<Traits, 5>(points, std::move(knots)), moved, std::move(rounded),
                               std::move(waves));
  }

private:
  std::optional<Piece> with_handles(int i, const Fair_handles& h) const {
    const Short_jet<Traits>&a = jets_[i], &b = jets_[p_.next(i)];
    return quintic_with_handles<Traits>(a.jet, b.jet, h, {a.speed, b.speed}, (std::min)(a.digits, b.digits), p_.size);
  }

  // By `Fair`; it notes joints that rounding breaks.
  Piece blended(int i) {
    const auto &start = jets_[i].jet, &end = jets_[p_.next(i)].jet;
    if constexpr (std::is_floating_point_v<FT>) {
      if (const std::optional<Piece> piece = unmoved_blend<Traits>(start, end)) return *piece;
      is_rounded_[p_.given(i)] = is_rounded_[p_.given(p_.next(i))] = 1;
    }
    return blend(Curve_jet<Traits>(start), Curve_jet<Traits>(end), Fair());
  }

  // Gives a piece short handles without waves; returns whether there are some.
  bool shorten_handles(int i) {
    for (double part = longest_part; part > shortest_part; part *= 0.8) {
      const std::optional<Piece> piece =
          with_handles(i, short_handles(joints_[i], joints_[p_.next(i)], turns_->bend(i), part));
      if (!piece) return false;
      const Inflections now = inflections_of(*piece, turns_->inflections(i));
      if (now.number > turns_->inflections(i)) continue;
      inflections_[i] = now;
      pieces_[i] = *piece;
      return true;
    }
    return false;
  }

  // A piece with waves gets short handles. Where this does not suffice, the tangents at its ends
  // move away from the chords, further and further, and the pieces beside get short handles, too.
  void mend_waves() {
    for (const int i : pieces_with_waves(*turns_, inflections_)) shorten_handles(i);
    if (p_.pieces() < 3) return;
    for (const double part : {0.05, 0.1, 0.2, 0.3})
      for (const int i : pieces_with_waves(*turns_, inflections_)) {
        Work_meter::pause();
        const int before = (i + p_.pieces() - 1) % p_.pieces(), after = (i + 1) % p_.pieces();
        const auto kept = std::array{joints_[i], joints_[p_.next(i)]};
        const auto kept_pieces = std::array{pieces_[before], pieces_[i], pieces_[after]};
        const auto kept_inflections = std::array{inflections_[before], inflections_[i], inflections_[after]};
        const auto put_jets = [&] {
          for (const int k : {i, p_.next(i)}) jets_[k] = short_jet(p_, joints_, lengths_, k);
        };
        for (const int k : {i, p_.next(i)}) turns_->confine(joints_, k, part);
        put_jets();
        bool is_mended = true;
        for (const int k : {before, i, after})
          if (k == i || p_.closed || (k == before ? i > 0 : i + 1 < p_.pieces()))
            is_mended = shorten_handles(k) && is_mended;
        if (is_mended) continue;
        joints_[i] = kept[0];
        joints_[p_.next(i)] = kept[1];
        put_jets();
        for (const int k : {0, 1, 2}) {
          pieces_[std::array{before, i, after}[k]] = kept_pieces[k];
          inflections_[std::array{before, i, after}[k]] = kept_inflections[k];
        }
      }
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a spline of fair quintic blends through points, with joins that are exactly \f$ G^2 \f$.
/// Tangents, curvatures and the handles of the pieces are found in floating-point numbers, in the
/// plane and in space: from the circles through three points on, such that the variation of
/// curvature \f$ \int |(dK/ds)^\perp|^2 ds \f$ is least, all together, so that what is symmetric
/// stays so, up to the rounding of these numbers. Reversed points give exactly the reversed curve.
/// In other dimensions they are those of the circles, and pieces are blends by `Fair`. Points of a
/// circle, at equal distances, give nearly that circle.
///
/// In the plane the curve has no more inflections than the polygon of the points, but at the pieces
/// in `Fair_spline::waves`: where the polygon turns to one side at both ends of a piece, this has
/// no inflection, and one where the sides differ; exactly decided for the returned control points.
/// A piece with waves gets shorter handles, or tangents farther from the chords, if there are some
/// without. Points on a line with both neighbours, which do not turn to different sides, give
/// lines.
///
/// With an exact kernel the points are met exactly, and the joins are \f$ G^2 \f$ whatever was
/// found. With floating-point numbers, so few digits are taken that nothing is rounded, or
/// `representable_blend()` makes the piece: then the joins are exactly \f$ G^2 \f$, too, but at the
/// points in `Fair_spline::rounded`, of which there are few or none unless the points are far from
/// the origin for their distances; and points with more binary digits than leave room for that are
/// rounded, see `Fair_spline::moved`.
///
/// \f$ O(n) \f$, at most 16 steps on all points.
/// \param first, last the points
/// \param closure whether the curve returns to the first point, \f$ G^2 \f$ there, too
/// \param tangents the tangents at the points, of any length, where they are given; empty: all are
///   free. With floating-point numbers directions are rounded to about 17 binary digits, 8 with
///   `float`
/// \tparam Traits a model of `GeometricContinuityTraits` \tparam InputIterator its value type is
///   `Traits::Point`
/// \throws Error `wrong_number_of_points` for fewer than 2 points, or 3 if closed, and for another
///   number of tangents; `empty_domain` when two consecutive points coincide, also by rounding;
///   `zero_tangent` for a tangent that is zero; `dimension_mismatch`; `not_finite` also when
///   floating-point numbers overflow
template <class Traits, class InputIterator>
Fair_spline<Traits> interpolate_fair(InputIterator first, InputIterator last, Closure closure = Closure::open,
                                     const std::vector<std::optional<typename Traits::Vector>>& tangents = {}) {
  internal::Fair_points<Traits> p = internal::points_of_fair_spline<Traits>(first, last, closure, tangents);
  const typename Traits::FT moved = internal::round_points(p);
  std::vector<internal::Fair_joint<dimension_v<Traits>>> joints = internal::joints_of(p);
  const std::vector<double> lengths = internal::chord_lengths(p, joints);
  const std::vector<internal::Fair_handles> handles = internal::choose_fair_joints(joints, p.closed);
  return internal::Fair_pieces<Traits>(p, lengths, std::move(joints), handles).spline(moved);
}

/// \ingroup PkgGeometricContinuityConstruction
/// Returns a spline of fair quintic blends through points of a \cgal kernel, over whose traits
/// class (`Traits_of`) it is.
/// \throws Error as for the points between two iterators
template <class Point>
Fair_spline<Traits_of<Point>>
interpolate_fair(const std::vector<Point>& points, Closure closure = Closure::open,
                 const std::vector<std::optional<typename Traits_of<Point>::Vector>>& tangents = {}) {
  return interpolate_fair<Traits_of<Point>>(points.begin(), points.end(), closure, tangents);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H
