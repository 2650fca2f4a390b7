// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERPOLATE_FAIR_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_joints.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_points.h>
#include <CGAL/Geometric_continuity/blends/internal/Short_jet.h>
#include <CGAL/Geometric_continuity/blends/internal/inflections.h>
#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <array>
#include <optional>
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
