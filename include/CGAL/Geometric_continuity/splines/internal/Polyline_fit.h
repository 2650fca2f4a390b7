// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_POLYLINE_FIT_H
#define CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_POLYLINE_FIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/splines/internal/Fit_chain.h>
#include <CGAL/Geometric_continuity/splines/internal/Fit_path.h>
#include <CGAL/Geometric_continuity/splines/internal/Fit_piece.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
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
  typedef Fit_place Place;
  typedef Fit_chain<N, degree> Chain;
  static constexpr int free_points = (degree - 1) / 2, unknowns = 2 * free_points;
  static constexpr int most_samples = 24, most_steps = 12;
  typedef std::array<double, unknowns> Handles;

  struct Span {
    Piece piece;
    Place first, last;
    Joint start, end;
  };

  const Fit_path<N> path_;
  const std::vector<Vector>& p_; // its vertices
  const double tolerance_;
  const double largest_; // coordinate

public:
  Polyline_fit(const std::vector<Vector>& p, const std::vector<char>& stop, double tolerance, bool periodic,
               double largest)
      : path_(p, stop, tolerance, periodic), p_(p), tolerance_(tolerance), largest_(largest) {}

  // Takes the longest piece that is found, again and again, and then fewer of them where that
  // succeeds. Rounds to nearest. Short pieces may fail where long ones succeed: the search goes
  // from long ones to short ones, from all that is left or, in linear time, from some segments.
  std::vector<Span> spans(bool from_all) const {
    const int n = path_.segments();
    std::vector<Span> result;
    std::vector<Joint> first = joints(0, path_.is_periodic() ? Side::both : Side::after);
    if (path_.is_periodic()) first.resize(1);
    std::vector<Joint> starts = first;
    for (int i = 0, steps = 8; i < n;) {
      const int longest = path_.stop_after(i) - i;
      std::optional<Span> best;
      const auto succeeds = [&](int count) {
        Work_meter::pause();
        const int j = i + count;
        const std::vector<Joint> ends = count < longest       ? joints(j, Side::both)
                                        : path_.is_periodic() ? first // without a corner before
                                                              : joints(j, Side::before);
        for (const Joint& start : starts)
          for (const Joint& end : ends) {
            std::optional<Piece> piece = fitted({i, 0}, {j, 0}, start, end);
            if (!piece && count == 1) piece = short_piece(i, start, end);
            if (!piece) continue;
            best = Span{std::move(*piece), {i, 0}, {j, 0}, start, end};
            return true;
          }
        return false;
      };
      int good = 0, bad = longest + 1; // numbers of segments
      const int top = from_all ? longest : (std::min)(8 * steps, longest);
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
      if (i < n) starts = path_.stops(i) ? joints(i, Side::after) : std::vector<Joint>{best->end};
      result.push_back(std::move(*best));
    }
    return shortened(std::move(result));
  }

  // Proves that the pieces are near: with intervals, under the protection of the rounding mode.
  // Every vertex is within `radius` of the given one in each coordinate.
  Result proved(const std::vector<Span>& spans, double radius) const {
    typedef Interval_nt<false> Interval;
    Result result{{}, {}, 0};
    for (const Span& span : spans) result.vertices.push_back(nearest_vertex(span.first));
    result.vertices.push_back(path_.segments());
    // of places between vertices the rounding is less than one
    const Interval all(tolerance_), error(Interval(radius + 1) * Interval(static_cast<double>(p_[0].dimension())));
    const Interval rest = all - error;
    // unreachable: the tolerance has 1024 units or more, and rounding is less than one
    if (!(rest.inf() > 0)) throw Error(Error_code::unreachable_tolerance, "fit: the points are too long");
    const double bound = (rest * rest).inf();
    double worst = 0;
    for (std::size_t k = 0; k < spans.size(); ++k) {
      Work_meter::pause();
      const Piece& piece = spans[k].piece;
      // unreachable: by rounding only: the search has a smaller tolerance
      if (!piece.template is_near<Interval>(bound, worst))
        // unreachable: by rounding only: the search has a smaller tolerance
        throw Error(Error_code::unreachable_tolerance, "fit: near the vertex " + std::to_string(result.vertices[k]));
      result.points.insert(result.points.end(), piece.points.begin() + (k == 0 ? 0 : 1), piece.points.end());
    }
    const Interval distance = CGAL::sqrt(Interval(worst)) + error;
    result.squared_distance = (distance * distance).sup();
    return result;
  }

private:
  bool stops(const Place& x) const { return x.part == 0 && path_.stops(x.vertex); }
  // The vertex that is next to a place, and no corner unless it is at the place.
  int nearest_vertex(const Place& x) const {
    if (x.part == 0) return x.vertex;
    return path_.stops(x.vertex + 1) || (x.part < 0.5 && !path_.stops(x.vertex)) ? x.vertex : x.vertex + 1;
  }

  // Replaces some pieces in a row by one less, again and again, where all joints between them can
  // move so that this succeeds.
  std::vector<Span> shortened(std::vector<Span> spans) const {
    constexpr std::size_t most = 8; // pieces in a row
    std::vector<Span> result, row;
    int tries = 100; // with other starts, so that time is linear
    for (std::size_t next = 0; next < spans.size() || !row.empty();) {
      const auto is_whole = [&] { return next == spans.size() || stops(row.back().last); };
      while (row.empty() || (row.size() < most && !is_whole())) row.push_back(std::move(spans[next++]));
      if (has_one_less(row, tries)) continue;
      const std::ptrdiff_t done = static_cast<std::ptrdiff_t>(is_whole() || tries <= 0 ? row.size() : most / 2);
      result.insert(result.end(), std::make_move_iterator(row.begin()), std::make_move_iterator(row.begin() + done));
      row.erase(row.begin(), row.begin() + done);
    }
    return result;
  }

  // Tries to do with one piece less. The tangents at both ends move where the polyline stops.
  bool has_one_less(std::vector<Span>& row, int& tries) const {
    const int count = static_cast<int>(row.size()), less = count - 1;
    const Place first = row.front().first, last = row.back().last;
    const auto is_free = [&](const Place& x) { return stops(x) && !path_.is_periodic(); };
    const bool moves_first = is_free(first), moves_last = is_free(last);
    if (last.vertex - first.vertex < 2 * less || less == 0 || (less == 1 && !moves_first && !moves_last)) return false;
    // with one joint less, or with all joints moved evenly
    std::vector<Chain> chains;
    for (int without = 0; without < (tries > 0 ? count : 1); ++without) {
      std::vector<double> places; // arc lengths where joints are at first
      std::vector<typename Chain::Joint> joints_at;
      for (int m = 0; m < less; ++m) {
        const double u = without > 0 ? m + (m < without ? 0 : 1) : m * count / double(less);
        const int k = static_cast<int>(u);
        const double from = path_.arc_length(row[k].first), to = path_.arc_length(row[k].last);
        places.push_back(from + (u - k) * (to - from));
      }
      places.push_back(path_.arc_length(last));
      for (int m = 0; m <= less; ++m) {
        const double before = m > 0 ? (places[m] - places[m - 1]) / degree : 0,
                     after = m < less ? (places[m + 1] - places[m]) / degree : before;
        if (!(after > 0)) return false; // by rounding
        if (m == 0)
          joints_at.push_back(Chain::joint_of(row.front().start, moves_first ? 1 : 3, after, after));
        else if (m == less)
          joints_at.push_back(Chain::joint_of(row.back().end, moves_last ? 1 : 3, before, before));
        else if (without > 0)
          joints_at.push_back(Chain::joint_of(row[m + (m < without ? 0 : 1)].start, 0, before, after));
        else {
          const int v = (std::min)((std::max)(path_.vertex_after(places[m]), first.vertex + 1), last.vertex - 1);
          joints_at.push_back(Chain::joint_of(joints(v, Side::both)[0], 0, before, after));
        }
      }
      chains.emplace_back(path_, first.vertex, last.vertex + (last.part > 0 ? 1 : 0), std::move(joints_at), places);
    }
    std::vector<Span> spans;
    const auto succeeds = [&](const Chain& chain) {
      Work_meter::pause();
      spans.clear();
      for (int m = 0; m < less; ++m) {
        Span span;
        span.first = m == 0 ? first : spans.back().last;
        span.last = m + 1 == less ? last : chain.place(m + 1);
        if (!(span.first < span.last) || (m + 1 < less && !(span.last < last))) return false;
        span.start = m > 0 ? spans.back().end : moves_first ? chain.rounded_joint(0) : row.front().start;
        span.end = m + 1 < less || moves_last ? chain.rounded_joint(m + 1) : row.back().end;
        std::optional<Piece> piece = fitted(span.first, span.last, span.start, span.end, &chain, m);
        if (!piece) return false;
        span.piece = std::move(*piece);
        spans.push_back(std::move(span));
      }
      return true;
    };
    const int patience = tries > 0 ? 4 : 1;
    bool found = false;
    for (std::size_t i = 0; i < chains.size() && !found; ++i)
      found = chains[i].improve(patience, [&] { return succeeds(chains[i]); });
    // where one less counts most: it takes time
    if (!found && tries > 0 && less <= 3) found = has_shorter_chain(row, moves_first, moves_last, succeeds);
    tries -= static_cast<int>(chains.size()) - 1;
    if (found) row = std::move(spans);
    return found;
  }

  // Tries to do without the last piece: extends the one before it step by step, while all joints
  // move.
  template <class Predicate>
  bool has_shorter_chain(const std::vector<Span>& row, bool moves_first, bool moves_last, Predicate succeeds) const {
    const std::size_t less = row.size() - 1;
    std::vector<Piece> pieces;
    std::vector<Place> places = {row[0].first};
    std::vector<Joint> joints = {row[0].start};
    for (std::size_t k = 0; k < less; ++k) {
      pieces.push_back(row[k].piece);
      places.push_back(row[k].last);
      joints.push_back(row[k].end);
    }
    const double end = path_.arc_length(row.back().last);
    std::optional<Chain> chain(std::in_place, path_, pieces, places, joints, moves_first ? 1 : 3);
    double part = 0.4; // of a piece, by which it is extended at once
    for (int step = 0; step < 50 && part >= 0.1; ++step) {
      Work_meter::pause();
      Chain longer = *chain;
      longer.extend(end - longer.end(), part);
      const bool is_whole = !(longer.end() < end * (1 - 1e-9));
      if (is_whole) longer.end_at(row.back().end, moves_last ? 1 : 3);
      if (!longer.improve(4, [&] { return !is_whole || succeeds(longer); }))
        part /= 2;
      else if (is_whole)
        return true;
      else
        chain.emplace(std::move(longer));
    }
    return false;
  }

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

  // A piece from one place to another, if it is near: by least squares, or that of a chain.
  std::optional<Piece> fitted(const Place& first, const Place& last, const Joint& start, const Joint& end,
                              const Chain* chain = nullptr, int number = 0) const {
    const int i = first.vertex, j = last.vertex;
    // equivalent [- -> +, 1]: at how many points a search looks; what it finds is proved
    const int samples = (std::min)((std::max)(4 * (j - i), 8), most_samples);
    const double from = path_.arc_length(first), total = path_.arc_length(last) - from;
    if (!(total > 0)) return std::nullopt; // by rounding
    std::array<Vector, most_samples + 1> x;
    std::array<double, most_samples + 1> u;
    for (int k = 0; k <= samples; ++k) {
      u[k] = k / double(samples);
      x[k] = path_.point_at(from + u[k] * total);
    }
    const std::array<double, 2> lengths = {length(start.difference), length(end.difference)};
    Handles handles; // where the search starts
    for (int k = 0; k < unknowns; ++k) handles[k] = (1 + k % free_points) * total / degree / lengths[k / free_points];
    const Handles natural = handles;
    Piece piece;
    if (chain) {
      for (int k = 0; k < unknowns; ++k) {
        const int side = k / free_points;
        const typename Chain::Joint& joint = chain->joint(number + side);
        handles[k] = (side == 0 ? joint.after : joint.before)[k % free_points] * length(joint.v[1]) / lengths[side];
      }
      set_points(piece, start, end, handles);
      for (int k = 1; k < samples; ++k) u[k] = chain->parameter(from + u[k] * total) - number;
      for (int repetition = 0; repetition < 4; ++repetition) {
        for (int k = 1; k < samples; ++k) u[k] = piece.projected(u[k], x[k]);
        make_monotone(u.begin(), u.begin() + samples + 1);
      }
    } else {
      set_points(piece, start, end, handles);
      double worst = 0;
      for (int repetition = 0; repetition < most_steps; ++repetition) {
        const double last_worst = worst;
        worst = improve(piece, start, end, x, u, samples, natural, handles);
        if (repetition <= 3) continue;
        if (worst > 4 * tolerance_ && worst > last_worst / 2) return std::nullopt;
        if (worst > 0.9 * last_worst) break;
      }
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
    piece.polyline.assign(1, path_.point(first));
    // equivalent [- -> +, 1]: memory only
    t.reserve(j - i + 2);
    piece.polyline.reserve(j - i + 2);
    for (int k = i + 1; k <= j && (k < j || last.part > 0); ++k) {
      const double place = (path_.arc_length(k) - from) / total * samples;
      const int cell = (std::min)(static_cast<int>(place), samples - 1);
      const double guess = u[cell] + (place - cell) * (u[cell + 1] - u[cell]);
      t.push_back(piece.projected(guess, p_[k]));
      piece.polyline.push_back(p_[k]);
    }
    t.push_back(1);
    piece.polyline.push_back(path_.point(last));
    make_monotone(t.begin(), t.end());
    if (!near(piece)) return std::nullopt;
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
      const double t = u[k];
      const std::array<double, degree + 1> b = Piece::bernstein(t);
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
    piece.polyline = {p_[i], p_[i + 1]};
    piece.parameters = {0, 1};
    // unreachable: no tolerance that is taken is too small for one segment, but it is not proved
    if (!is_exact(piece, start, end, handles) || !near(piece)) return std::nullopt;
    return piece;
  }

  bool near(Piece& piece) const {
    double worst = 0, size = 0;
    piece.divisions.clear();
    std::vector<typename Piece::Division> divided;
    for (const Vector& x : piece.points)
      for (const double c : Vector(x - piece.points[0])) size = (std::max)(size, std::abs(c));
    // so that intervals prove it
    const double tolerance = tolerance_ * (1 - 0x1p-20) - size * 0x1p-46;
    // unreachable: the tolerance has 1024 units or more, and rounding is less than that
    if (!(tolerance > 0 && piece.template is_near<double>(tolerance * tolerance, worst, &divided))) return false;
    piece.divisions = std::move(divided);
    return true;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SPLINES_INTERNAL_POLYLINE_FIT_H
