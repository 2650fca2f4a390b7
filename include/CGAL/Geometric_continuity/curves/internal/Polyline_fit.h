// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/curves/internal/Fit_path.h>
#include <CGAL/Geometric_continuity/curves/internal/Fit_piece.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A polyline by few Bezier curves, in floating-point numbers: all coordinates are multiples of one
// unit, which is 1 here. See curves/fit.h.
//
// At a joint there are three vectors of integers: its point A, a short difference D along the
// tangent and the second difference Q that a curve with this difference has. With integers b, f the
// control points
//
//   A,   A + b D,   A + f D + b^2 Q     (the third one for G2 only)
//
// and those of the curve before it, with -b and -f, have one tangent and one curvature vector,
// exactly: no sum or product is rounded.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The degree is 3 for joins that are G1, and 5 for G2.
template <int N, int degree> class Polyline_fit {
public:
  typedef Coordinate_vector<double, N> Vector;
  struct Result {
    std::vector<Vector> points; // control points, of neighbours the last and the first one are one
    std::vector<int> vertices;  // those at which the pieces start and end
    double squared_distance;    // an upper bound
  };

private:
  typedef Fit_joint<N> Joint;
  typedef Fit_piece<N, degree> Piece;
  typedef Fit_side Side;
  static constexpr int free_points = (degree - 1) / 2, unknowns = 2 * free_points;
  static constexpr int most_samples = 24, most_steps = 12;
  typedef std::array<double, unknowns> Handles;

  const Fit_path<N> path_;
  const std::vector<Vector>& p_; // its vertices
  const double tolerance_;
  const double largest_; // coordinate

public:
  Polyline_fit(const std::vector<Vector>& p, const std::vector<char>& stop, double tolerance, bool periodic,
               double largest)
      : path_(p, stop, tolerance, periodic), p_(p), tolerance_(tolerance), largest_(largest) {}

  // Takes the longest piece that is found, again and again. Rounds to nearest. Short pieces may
  // fail where long ones succeed: the search goes from long ones to short ones.
  std::vector<Piece> pieces(std::vector<int>& vertices) const {
    const int n = path_.segments();
    std::vector<Piece> result;
    vertices.assign(1, 0);
    std::vector<Joint> first = joints(0, path_.is_periodic() ? Side::both : Side::after);
    if (path_.is_periodic()) first.resize(1);
    std::vector<Joint> starts = first;
    for (int i = 0, steps = 8; i < n;) {
      const int longest = path_.stop_after(i) - i;
      std::optional<Piece> best;
      Joint best_end;
      const auto succeeds = [&](int count) {
        Work_meter::pause();
        const int j = i + count;
        const std::vector<Joint> ends = count < longest       ? joints(j, Side::both)
                                        : path_.is_periodic() ? first // without a corner before
                                                              : joints(j, Side::before);
        for (const Joint& start : starts)
          for (const Joint& end : ends) {
            std::optional<Piece> piece = fitted(i, j, start, end);
            if (!piece && count == 1) piece = short_piece(i, start, end);
            if (!piece) continue;
            best = std::move(piece);
            best_end = end;
            return true;
          }
        return false;
      };
      int good = 0, bad = longest + 1; // numbers of segments
      const int top = (std::min)(8 * steps, longest);
      for (int count = top; good == 0 && count > 0; count /= 2) (succeeds(count) ? good : bad) = count;
      for (int count = top; good == 0 && count < longest;) { // where all of them fail
        count = (std::min)(2 * count, longest);
        if (!succeeds(count)) continue;
        good = count;
        bad = longest + 1;
      }
      // unreachable: no tolerance that is taken is too small for one segment, but it is not proved
      if (good == 0) throw Error(Error_code::unreachable_tolerance, "fit: near the vertex " + std::to_string(i));
      while (good < longest && bad - good > 1 + good / 64) {
        const int count = bad > longest ? (std::min)(2 * good, longest) : (good + bad) / 2;
        (succeeds(count) ? good : bad) = count;
      }
      steps = good;
      i += good;
      vertices.push_back(i);
      result.push_back(std::move(*best));
      if (i < n) starts = path_.stops(i) ? joints(i, Side::after) : std::vector<Joint>{best_end};
    }
    return result;
  }

  // Proves that the pieces are near: with intervals, under the protection of the rounding mode.
  // Every vertex is within `radius` of the given one in each coordinate.
  Result proved(const std::vector<Piece>& pieces, std::vector<int> vertices, double radius) const {
    typedef Interval_nt<false> Interval;
    Result result{{}, std::move(vertices), 0};
    const Interval all(tolerance_), error(Interval(radius) * Interval(static_cast<double>(p_[0].dimension())));
    const Interval rest = all - error;
    // unreachable: the tolerance has 1024 units or more, and rounding is less than one
    if (!(rest.inf() > 0)) throw Error(Error_code::unreachable_tolerance, "fit: the points are too long");
    const double bound = (rest * rest).inf();
    double worst = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Work_meter::pause();
      // unreachable: by rounding only: the search has a smaller tolerance
      if (!pieces[k].template is_near<Interval>(p_.begin() + result.vertices[k], bound, worst))
        // unreachable: by rounding only: the search has a smaller tolerance
        throw Error(Error_code::unreachable_tolerance, "fit: near the vertex " + std::to_string(result.vertices[k]));
      result.points.insert(result.points.end(), pieces[k].points.begin() + (k == 0 ? 0 : 1), pieces[k].points.end());
    }
    const Interval distance = CGAL::sqrt(Interval(worst)) + error;
    result.squared_distance = (distance * distance).sup();
    return result;
  }

private:
  std::vector<Joint> joints(int k, Side side) const { return path_.joints(k, side, degree); }

  static double length(const Vector& v) { return Fit_path<N>::length(v); }

  // The control points for multiples of the differences, b f at the start and at the end.
  void set_points(Piece& piece, const Joint& start, const Joint& end, const Handles& x) const {
    const double b = x[0], a = x[free_points];
    piece.points[0] = start.point;
    piece.points[1] = start.point + b * start.difference;
    piece.points[degree] = end.point;
    piece.points[degree - 1] = end.point - a * end.difference;
    if constexpr (free_points == 2) {
      piece.points[2] = start.point + x[1] * start.difference + (b * b) * start.second_difference;
      piece.points[3] = end.point - x[3] * end.difference + (a * a) * end.second_difference;
    }
  }
  // Returns whether nothing in that was rounded, for integers.
  bool is_exact(const Piece& piece, const Joint& start, const Joint& end, const Handles& x) const {
    const auto is_small = [&](double factor, const Vector& v) {
      return std::all_of(v.begin(), v.end(), [&](double c) { return std::abs(factor * c) < largest_; });
    };
    for (const Vector& b : piece.points)
      if (!is_small(1, b)) return false;
    for (int k = 0; k < unknowns; ++k) {
      const Joint& joint = k < free_points ? start : end;
      // equivalent [false -> true, 1]: such a product is small where the control points are,
      //   which are asked before
      if (!is_small(x[k], joint.difference)) return false;
      if (free_points == 2 && k % 2 == 0 && !is_zero(joint.second_difference) &&
          // unreachable: handles so long are beyond the largest control point before
          !(x[k] * x[k] < largest_ && is_small(x[k] * x[k], joint.second_difference)))
        return false;
    }
    return true;
  }

  // A piece from the vertex i to the vertex j by least squares, if it is near.
  std::optional<Piece> fitted(int i, int j, const Joint& start, const Joint& end) const {
    // equivalent [- -> +, 1]: at how many points a search looks; what it finds is proved
    const int samples = (std::min)((std::max)(4 * (j - i), 8), most_samples);
    const double total = path_.arc_length(j) - path_.arc_length(i);
    if (!(total > 0)) return std::nullopt; // by rounding
    std::array<Vector, most_samples + 1> x;
    std::array<double, most_samples + 1> u;
    for (int k = 0; k <= samples; ++k) {
      u[k] = k / double(samples);
      x[k] = path_.point_at(path_.arc_length(i) + u[k] * total);
    }
    const std::array<double, 2> lengths = {length(start.difference), length(end.difference)};
    Handles handles; // where the search starts
    for (int k = 0; k < unknowns; ++k) handles[k] = (1 + k % free_points) * total / degree / lengths[k / free_points];
    const Handles natural = handles;
    Piece piece;
    set_points(piece, start, end, handles);
    double worst = 0;
    for (int repetition = 0; repetition < most_steps; ++repetition) {
      const double last = worst;
      worst = improve(piece, start, end, x, u, samples, natural, handles);
      if (repetition <= 3) continue;
      if (worst > 4 * tolerance_ && worst > last / 2) return std::nullopt;
      if (worst > 0.9 * last) break;
    }
    for (int k = 0; k < unknowns; ++k) {
      handles[k] = std::nearbyint(handles[k]);
      if (k % free_points == 0) handles[k] = (std::max)(handles[k], 1.);
    }
    set_points(piece, start, end, handles);
    for (int k = 1; k < samples; ++k) {
      const Vector d = piece.offset(u[k], x[k])[0];
      if (!(dot(d, d) <= tolerance_ * tolerance_)) return std::nullopt;
    }
    if (!is_exact(piece, start, end, handles)) return std::nullopt;
    std::vector<double>& t = piece.parameters;
    t.assign(1, 0);
    // equivalent [- -> +, 1]: memory only
    t.reserve(j - i + 1);
    for (int k = i + 1; k < j; ++k) {
      const double place = (path_.arc_length(k) - path_.arc_length(i)) / total * samples;
      const int cell = (std::min)(static_cast<int>(place), samples - 1);
      const double guess = u[cell] + (place - cell) * (u[cell + 1] - u[cell]);
      t.push_back(piece.projected(guess, p_[k]));
    }
    t.push_back(1);
    make_monotone(t.begin(), t.end());
    if (!near(piece, i)) return std::nullopt;
    return piece;
  }

  // Makes numbers from 0 to 1 increase: the mean of the largest one before and the least one after.
  template <class Iterator> static void make_monotone(Iterator first, Iterator last) {
    std::vector<double> largest;
    largest.reserve(last - first);
    for (Iterator t = first; t != last; ++t)
      largest.push_back((std::max)((std::min)(*t, 1.), largest.empty() ? 0. : largest.back()));
    double least = 1;
    for (Iterator t = last; t != first; largest.pop_back()) {
      --t;
      least = (std::min)((std::max)(*t, 0.), least);
      *t = (least + largest.back()) / 2;
    }
  }

  // Makes one step of Gauss and Newton for the distances from the points x, orthogonal to the
  // curve: first of the multiples of the differences, then of the parameters u of these points.
  // Returns the largest distance.
  double improve(Piece& piece, const Joint& start, const Joint& end, const std::array<Vector, most_samples + 1>& x,
                 std::array<double, most_samples + 1>& u, int samples, const Handles& natural, Handles& handles) const {
    std::array<Handles, unknowns> a{};
    Handles r{};
    for (int k = 1; k < samples; ++k) {
      const double t = u[k], s = 1 - t;
      std::array<double, degree + 1> b; // Bernstein polynomials
      if constexpr (degree == 3)
        b = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
      else
        b = {s * s * s * s * s,      5 * s * s * s * s * t, 10 * s * s * s * t * t,
             10 * s * s * t * t * t, 5 * s * t * t * t * t, t * t * t * t * t};
      const std::array<Vector, 2> offset = piece.offset(t, x[k]);
      const double square = dot(offset[1], offset[1]);
      const auto across = [&](const Vector& v) -> Vector {
        // unreachable: protects a division: a piece stops by chance only
        return square > 0 ? v - (dot(v, offset[1]) / square) * offset[1] : v;
      };
      std::array<Vector, unknowns> derivative;
      for (int i = 0; i < free_points; ++i) {
        derivative[i] = b[1 + i] * start.difference;
        derivative[free_points + i] = -b[degree - 1 - i] * end.difference;
      }
      if constexpr (free_points == 2) {
        derivative[0] += (2 * b[2] * handles[0]) * start.second_difference;
        derivative[2] += (2 * b[3] * handles[2]) * end.second_difference;
      }
      const Vector rest = across(offset[0]);
      for (Vector& v : derivative) v = across(v);
      for (int i = 0; i < unknowns; ++i) {
        r[i] -= dot(derivative[i], rest);
        for (int j = 0; j <= i; ++j) a[i][j] += dot(derivative[i], derivative[j]);
      }
    }
    // a little towards the natural ones: then it is never singular
    double size = 0;
    for (int i = 0; i < unknowns; ++i) size = (std::max)(size, a[i][i] * natural[i] * natural[i]);
    for (int i = 0; i < unknowns; ++i) {
      for (int j = 0; j < i; ++j) a[j][i] = a[i][j];
      const double weight = (1e-6 * size + 1e-4 * tolerance_ * tolerance_) / (natural[i] * natural[i]);
      a[i][i] += weight;
      r[i] += weight * (natural[i] - handles[i]);
    }
    const Handles step = solve_positive_definite(a, r);
    for (int i = 0; i < unknowns; ++i) {
      const double change = (std::min)((std::max)(step[i], -natural[i]), natural[i]);
      handles[i] += change;
      if (i % free_points == 0)
        handles[i] = (std::min)((std::max)(handles[i], natural[i] / 8), 4 * degree * natural[i]);
    }
    set_points(piece, start, end, handles);
    for (int k = 1; k < samples; ++k) u[k] = piece.projected(u[k], x[k]);
    make_monotone(u.begin(), u.begin() + samples + 1);
    double worst = 0;
    for (int k = 1; k < samples; ++k) {
      const Vector d = piece.offset(u[k], x[k])[0];
      worst = (std::max)(worst, dot(d, d));
    }
    return std::sqrt(worst);
  }

  // A piece along one segment, with handles that are so short that it is near.
  std::optional<Piece> short_piece(int i, const Joint& start, const Joint& end) const {
    const Vector chord = p_[i + 1] - p_[i];
    const double total = length(chord);
    const auto multiple = [&](const Joint& j) {
      const double difference = length(j.difference), cosine = dot(j.difference, chord) / (difference * total),
                   sine = cosine < 0 ? 1 : std::sqrt((std::max)(1 - cosine * cosine, 0.)),
                   bend = std::sqrt(length(j.second_difference));
      double h = total / degree / difference;
      if (sine > 0) h = (std::min)(h, tolerance_ / 4 / (sine * difference));
      // equivalent [8 -> 9, 1]: handles that are short enough, a little shorter
      if (bend > 0) h = (std::min)(h, std::sqrt(tolerance_ / 8) / bend);
      return (std::max)(std::floor(h / free_points), 1.);
    };
    Handles handles;
    for (int k = 0; k < unknowns; ++k) handles[k] = (1 + k % free_points) * multiple(k < free_points ? start : end);
    Piece piece;
    set_points(piece, start, end, handles);
    piece.parameters = {0, 1};
    // unreachable: no tolerance that is taken is too small for one segment, but it is not proved
    if (!is_exact(piece, start, end, handles) || !near(piece, i)) return std::nullopt;
    return piece;
  }

  bool near(const Piece& piece, int first) const {
    double worst = 0, size = 0;
    for (const Vector& x : piece.points)
      for (const double c : Vector(x - piece.points[0])) size = (std::max)(size, std::abs(c));
    // so that intervals prove it
    const double tolerance = tolerance_ * (1 - 0x1p-20) - size * 0x1p-46;
    // unreachable: the tolerance has 1024 units or more, and rounding is less than that
    return tolerance > 0 && piece.template is_near<double>(p_.begin() + first, tolerance * tolerance, worst);
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H
