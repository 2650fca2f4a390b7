// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Interval_nt.h>

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

// A polyline by few Bezier curves, in floating-point numbers: all coordinates are multiples of one unit, which is 1 here. See curves/fit.h.
//
// At a joint there are three vectors of integers: its point A, a short leg D along the tangent and the second difference Q that a
// curve with this leg has. With integers b, f the control points
//
//   A,   A + b D,   A + f D + b^2 Q     (the third one for G2 only)
//
// and those of the curve before it, with -b and -f, have one tangent and one curvature vector, exactly: no sum or product is rounded.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

template <int N> struct Fit_joint { Coordinate_vector<double, N> point, leg, second_difference; };

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
  static constexpr int free_points = (degree - 1) / 2, unknowns = 2 * free_points;
  static constexpr int most_samples = 24, most_halvings = 40;

  // A curve and the parameters of the vertices from `first` on.
  struct Piece {
    std::array<Vector, degree + 1> points;
    std::vector<double> parameters;
  };
  enum class Side { both, before, after };

  const std::vector<Vector>& p_;  // no two neighbours are equal
  const std::vector<char>& stop_; // whether there is a corner or an end
  const double tolerance_;
  const bool periodic_;   // the last vertex is the first one, and no corner
  const double largest_;  // coordinate
  std::vector<double> s_; // arc lengths
  std::vector<int> stop_before_, stop_after_;

public:
  Polyline_fit(const std::vector<Vector>& p, const std::vector<char>& stop, double tolerance, bool periodic,
               double largest)
      : p_(p), stop_(stop), tolerance_(tolerance), periodic_(periodic), largest_(largest), s_(p.size(), 0),
        stop_before_(p.size(), 0), stop_after_(p.size(), static_cast<int>(p.size()) - 1) {
    const int n = static_cast<int>(p.size());
    for (int k = 1; k < n; ++k) {
      s_[k] = s_[k - 1] + length(p[k] - p[k - 1]);
      stop_before_[k] = stop_[k - 1] ? k - 1 : stop_before_[k - 1];
    }
    for (int k = n - 2; k >= 0; --k) stop_after_[k] = stop_[k + 1] ? k + 1 : stop_after_[k + 1];
  }

  // Takes the longest piece that is found, again and again. Rounds to nearest.
  std::vector<Piece> pieces(std::vector<int>& vertices) const {
    const int n = static_cast<int>(p_.size()) - 1;
    std::vector<Piece> result;
    vertices.assign(1, 0);
    const Joint first = joint(0, periodic_ ? Side::both : Side::after);
    Joint start = first;
    for (int i = 0, steps = 1; i < n;) {
      const int target = stop_after_[i];
      std::optional<Piece> best;
      Joint best_end;
      const auto succeeds = [&](int count) {
        const int j = i + count;
        const Joint end = j < target ? joint(j, Side::both) : periodic_ && j == n ? first : joint(j, Side::before);
        std::optional<Piece> piece = fitted(i, j, start, end);
        if (!piece && count == 1) piece = short_piece(i, start, end);
        if (!piece) return false;
        best = std::move(piece);
        best_end = end;
        return true;
      };
      int good = 0, bad = target - i + 1; // numbers of segments
      for (int count = (std::min)(steps, target - i); good < bad - 1;) {
        (succeeds(count) ? good : bad) = count;
        if (bad == 1) throw Error(Error_code::unreachable_tolerance, "fit: near the vertex " + std::to_string(i));
        if (bad <= target - i && good > 0 && bad - good <= 1 + good / 64) break;
        count = good == 0 ? bad / 2 : bad > target - i ? (std::min)(2 * good, target - i) : (good + bad) / 2;
      }
      steps = good;
      i += good;
      vertices.push_back(i);
      result.push_back(std::move(*best));
      start = i < n && stop_[i] ? joint(i, Side::after) : best_end;
    }
    return result;
  }

  // Proves that the pieces are near: with intervals, under the protection of the rounding mode. Every vertex is within `radius` of the
  // given one in each coordinate.
  Result proved(const std::vector<Piece>& pieces, std::vector<int> vertices, double radius) const {
    typedef Interval_nt<false> Interval;
    Result result{{}, std::move(vertices), 0};
    const Interval all(tolerance_), error(Interval(radius) * Interval(static_cast<double>(p_[0].dimension())));
    const Interval rest = all - error;
    if (!(rest.inf() > 0)) throw Error(Error_code::unreachable_tolerance, "fit: the points are too long");
    const double bound = (rest * rest).inf();
    double worst = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      if (!near_polyline<Interval>(pieces[k], result.vertices[k], bound, worst))
        throw Error(Error_code::unreachable_tolerance, "fit: near the vertex " + std::to_string(result.vertices[k]));
      result.points.insert(result.points.end(), pieces[k].points.begin() + (k == 0 ? 0 : 1), pieces[k].points.end());
    }
    const Interval distance = CGAL::sqrt(Interval(worst)) + error;
    result.squared_distance = (distance * distance).sup();
    return result;
  }

private:
  static double length(const Vector& v) { return std::sqrt(dot(v, v)); }
  static Vector rounded(Vector v) {
    for (int x = 0; x < v.dimension(); ++x) v[x] = std::nearbyint(v[x]);
    return v;
  }

  // The point at an arc length, on the segments between two vertices.
  Vector point_at(double s, int first, int last) const {
    const int k = static_cast<int>(std::upper_bound(s_.begin() + first + 1, s_.begin() + last, s) - s_.begin()) - 1;
    const double t = (std::min)((std::max)((s - s_[k]) / (s_[k + 1] - s_[k]), 0.), 1.);
    return p_[k] + t * (p_[k + 1] - p_[k]);
  }
  Vector point_at(double s) const {
    const double total = s_.back();
    if (periodic_) s -= std::floor(s / total) * total;
    return point_at(s, 0, static_cast<int>(p_.size()) - 1);
  }

  // A cubic polynomial near a window of the polyline, in a parameter that is 0 at the vertex and 1 at the end of the window.
  struct Window {
    std::array<Vector, 4> c;
    double residual; // the largest one
  };
  // By least squares; at a corner or an end through the vertex.
  Window window(int k, double w, Side side) const {
    constexpr int half = 8;
    const int from = side == Side::after ? 0 : -half, to = side == Side::before ? 0 : half,
              least = side == Side::both ? 0 : 1;
    std::vector<Vector> x;
    std::array<std::array<double, 4>, 4> a{};
    std::array<Vector, 4> b;
    b.fill(Vector(p_[k].dimension()));
    for (int i = from; i <= to; ++i) {
      const double t = i / double(half);
      x.push_back(point_at(s_[k] + t * w) - p_[k]);
      const std::array<double, 4> power = {1, t, t * t, t * t * t};
      for (int r = least; r < 4; ++r) {
        for (int c = least; c < 4; ++c) a[r][c] += power[r] * power[c];
        b[r] += power[r] * x.back();
      }
    }
    if (least == 1) a[0][0] = 1;
    Window result{{}, 0};
    result.c.fill(Vector(p_[k].dimension()));
    for (int d = 0; d < p_[k].dimension(); ++d) {
      const std::array<double, 4> c =
          solve_positive_definite(a, std::array<double, 4>{b[0][d], b[1][d], b[2][d], b[3][d]});
      for (int r = least; r < 4; ++r) result.c[r][d] = c[r];
    }
    for (int i = from; i <= to; ++i) {
      const double t = i / double(half);
      const Vector e = result.c[0] + t * (result.c[1] + t * (result.c[2] + t * result.c[3])) - x[i - from];
      result.residual = (std::max)(result.residual, length(e));
    }
    return result;
  }

  // The joint at a vertex: of the cubic polynomial on the largest window, of those that are doubled, in which it is near.
  Joint joint(int k, Side side) const {
    const int n = static_cast<int>(p_.size()) - 1, before = k == 0 && periodic_ ? n : k;
    const double length_before = before > 0 ? s_[before] - s_[before - 1] : 0,
                 length_after = k < n ? s_[k + 1] - s_[k] : 0;
    double w = side == Side::before  ? length_before
               : side == Side::after ? length_after
                                     : (std::min)(length_before, length_after),
           limit = side == Side::before  ? s_[k] - s_[stop_before_[k]]
                   : side == Side::after ? s_[stop_after_[k]] - s_[k]
                                         : (std::min)(s_[k] - s_[stop_before_[k]], s_[stop_after_[k]] - s_[k]);
    if (periodic_) limit = s_.back() / 2;
    std::optional<Window> best;
    double width = w;
    for (w = (std::min)(w, limit);; w = (std::min)(2 * w, limit)) {
      const Window next = window(k, w, side);
      if (!(next.residual <= tolerance_ / 4)) break;
      best = next;
      width = w;
      if (w == limit) break;
    }
    if (best) {
      const double speed = length(best->c[1]), leg = (std::max)(width / 4096, 64.);
      if (speed > width / 16) {
        const Vector normal = best->c[2] - (dot(best->c[2], best->c[1]) / (speed * speed)) * best->c[1];
        const double curvature = 2 * leg * leg / (speed * speed) * degree / (degree - 1);
        return {rounded(p_[k] + best->c[0]), rounded((leg / speed) * best->c[1]), rounded(curvature * normal)};
      }
    }
    // in a zigzag, or where the polyline turns back
    Vector direction(p_[k].dimension());
    if (before > 0 && side != Side::after) direction += (p_[before] - p_[before - 1]) / length_before;
    if (k < n && side != Side::before) direction += (p_[k + 1] - p_[k]) / length_after;
    double d = length(direction);
    const double leg = (std::max)(tolerance_ / 16, 64.);
    if (!(d > 1e-7)) {
      direction = p_[before] - p_[before - 1];
      d = length_before;
    }
    return {rounded(p_[k]), rounded((leg / d) * direction), Vector(p_[k].dimension())};
  }

  // x(t) - p, x'(t)
  std::array<Vector, 2> offset(const Piece& piece, double t, const Vector& p) const {
    std::array<Vector, degree + 1> b = piece.points;
    for (int m = degree; m > 1; --m)
      for (int i = 0; i < m; ++i) b[i] += t * (b[i + 1] - b[i]);
    const Vector leg = b[1] - b[0];
    return {b[0] + t * leg - p, double(degree) * leg};
  }
  // The parameter of the point that is next to p, nearer than t.
  double projected(const Piece& piece, double t, const Vector& p) const {
    const std::array<Vector, 2> x = offset(piece, t, p);
    const double square = dot(x[1], x[1]);
    return square > 0 ? t - dot(x[0], x[1]) / square : t;
  }

  // The same between two parameters, also where the curve is slow: each step halves the interval where it leaves it.
  double parameter_between(const Piece& piece, double low, double high, const Vector& p) const {
    double t = low + (high - low) / 2;
    for (int repetition = 0; repetition < 40; ++repetition) {
      const std::array<Vector, 2> x = offset(piece, t, p);
      const double slope = dot(x[0], x[1]), square = dot(x[1], x[1]);
      (slope > 0 ? high : low) = t;
      const double last = t, next = square > 0 ? t - slope / square : low;
      t = low < next && next < high ? next : low + (high - low) / 2;
      if (std::abs(t - last) <= 1e-9 * t) break;
    }
    return t;
  }

  // The control points for multiples of the legs, b f at the start and at the end.
  void set_points(Piece& piece, const Joint& start, const Joint& end, const std::array<double, unknowns>& x) const {
    const double b = x[0], a = x[free_points];
    piece.points[0] = start.point;
    piece.points[1] = start.point + b * start.leg;
    piece.points[degree] = end.point;
    piece.points[degree - 1] = end.point - a * end.leg;
    if constexpr (free_points == 2) {
      piece.points[2] = start.point + x[1] * start.leg + (b * b) * start.second_difference;
      piece.points[3] = end.point - x[3] * end.leg + (a * a) * end.second_difference;
    }
  }
  // Whether nothing in that was rounded, for integers.
  bool is_exact(const Piece& piece, const Joint& start, const Joint& end, const std::array<double, unknowns>& x) const {
    const auto is_small = [&](double factor, const Vector& v) {
      return std::all_of(v.begin(), v.end(), [&](double c) { return std::abs(factor * c) < largest_; });
    };
    for (const Vector& b : piece.points)
      if (!is_small(1, b)) return false;
    for (int k = 0; k < unknowns; ++k) {
      const Joint& joint = k < free_points ? start : end;
      if (!is_small(x[k], joint.leg)) return false;
      if (free_points == 2 && k % 2 == 0 && !is_zero(joint.second_difference) &&
          !(x[k] * x[k] < largest_ && is_small(x[k] * x[k], joint.second_difference)))
        return false;
    }
    return true;
  }

  // A piece from the vertex i to the vertex j by least squares, if it is near.
  std::optional<Piece> fitted(int i, int j, const Joint& start, const Joint& end) const {
    const int samples = (std::min)((std::max)(4 * (j - i), 8), most_samples);
    const double total = s_[j] - s_[i];
    std::array<Vector, most_samples + 1> x;
    std::array<double, most_samples + 1> u;
    for (int k = 0; k <= samples; ++k) {
      u[k] = k / double(samples);
      x[k] = point_at(s_[i] + u[k] * total, i, j);
    }
    const std::array<double, 2> lengths = {length(start.leg), length(end.leg)};
    std::array<double, unknowns> handles; // where the search starts
    for (int k = 0; k < unknowns; ++k) handles[k] = (1 + k % free_points) * total / degree / lengths[k / free_points];
    const std::array<double, unknowns> natural = handles;
    Piece piece;
    for (int repetition = 0; repetition < 5; ++repetition) {
      solve(start, end, x, u, samples, natural, handles);
      set_points(piece, start, end, handles);
      for (int k = 1; k < samples; ++k) u[k] = (std::min)((std::max)(projected(piece, u[k], x[k]), u[k - 1]), 1.);
    }
    for (int k = 0; k < unknowns; ++k) {
      handles[k] = std::nearbyint(handles[k]);
      if (k % free_points == 0) handles[k] = (std::max)(handles[k], 1.);
    }
    set_points(piece, start, end, handles);
    for (int k = 1; k < samples; ++k) {
      const Vector d = offset(piece, u[k], x[k])[0];
      if (!(dot(d, d) <= tolerance_ * tolerance_)) return std::nullopt;
    }
    if (!is_exact(piece, start, end, handles)) return std::nullopt;
    std::vector<double>& t = piece.parameters;
    t.assign(1, 0);
    t.reserve(j - i + 1);
    for (int k = i + 1; k < j; ++k) {
      const double place = (s_[k] - s_[i]) / total * samples;
      const int cell = (std::min)(static_cast<int>(place), samples - 1);
      const double guess = u[cell] + (place - cell) * (u[cell + 1] - u[cell]);
      t.push_back((std::min)((std::max)(projected(piece, guess, p_[k]), t.back()), 1.));
    }
    t.push_back(1);
    if (!near(piece, i)) return std::nullopt;
    return piece;
  }

  // One step of least squares: the multiples of the legs, with the curvature of those before.
  void solve(const Joint& start, const Joint& end, const std::array<Vector, most_samples + 1>& x,
             const std::array<double, most_samples + 1>& u, int samples, const std::array<double, unknowns>& natural,
             std::array<double, unknowns>& handles) const {
    std::array<std::array<double, unknowns>, unknowns> a{};
    std::array<double, unknowns> r{};
    const double start_square = dot(start.leg, start.leg), end_square = dot(end.leg, end.leg),
                 product = dot(start.leg, end.leg);
    for (int k = 1; k < samples; ++k) {
      const double t = u[k], s = 1 - t;
      std::array<double, degree + 1> b; // Bernstein polynomials
      if constexpr (degree == 3)
        b = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
      else
        b = {s * s * s * s * s,      5 * s * s * s * s * t, 10 * s * s * s * t * t,
             10 * s * s * t * t * t, 5 * s * t * t * t * t, t * t * t * t * t};
      double at_start = 0, at_end = 0;
      for (int i = 0; i <= free_points; ++i) {
        at_start += b[i];
        at_end += b[degree - i];
      }
      Vector rest = x[k] - at_start * start.point - at_end * end.point;
      if constexpr (free_points == 2)
        rest -= (b[2] * handles[0] * handles[0]) * start.second_difference +
                (b[3] * handles[2] * handles[2]) * end.second_difference;
      const double with_start = dot(rest, start.leg), with_end = dot(rest, end.leg);
      for (int i = 0; i < free_points; ++i) {
        r[i] += b[1 + i] * with_start;
        r[free_points + i] -= b[degree - 1 - i] * with_end;
        for (int j = 0; j < free_points; ++j) {
          a[i][j] += b[1 + i] * b[1 + j] * start_square;
          a[free_points + i][free_points + j] += b[degree - 1 - i] * b[degree - 1 - j] * end_square;
          a[i][free_points + j] -= b[1 + i] * b[degree - 1 - j] * product;
        }
      }
    }
    for (int i = 0; i < unknowns; ++i) { // a little towards the natural ones: then it is never singular
      for (int j = 0; j < i; ++j) a[i][j] = a[j][i];
      const double weight = 1e-4 * samples * (i < free_points ? start_square : end_square);
      a[i][i] += weight;
      r[i] += weight * natural[i];
    }
    handles = solve_positive_definite(a, r);
    for (int i = 0; i < unknowns; i += free_points)
      if (!(handles[i] > 0 && handles[i] < 4 * degree * natural[i])) handles[i] = natural[i] / 4;
  }

  // A piece along one segment, with handles that are so short that it is near.
  std::optional<Piece> short_piece(int i, const Joint& start, const Joint& end) const {
    const Vector chord = p_[i + 1] - p_[i];
    const double total = s_[i + 1] - s_[i];
    const auto multiple = [&](const Joint& j) {
      const double leg = length(j.leg), cosine = dot(j.leg, chord) / (leg * total),
                   sine = cosine < 0 ? 1 : std::sqrt((std::max)(1 - cosine * cosine, 0.)),
                   bend = std::sqrt(length(j.second_difference));
      double h = total / degree / leg;
      if (sine > 0) h = (std::min)(h, tolerance_ / 4 / (sine * leg));
      if (bend > 0) h = (std::min)(h, std::sqrt(tolerance_ / 8) / bend);
      return (std::max)(std::floor(h / free_points), 1.);
    };
    std::array<double, unknowns> handles;
    for (int k = 0; k < unknowns; ++k) handles[k] = (1 + k % free_points) * multiple(k < free_points ? start : end);
    Piece piece;
    set_points(piece, start, end, handles);
    piece.parameters = {0, 1};
    if (!is_exact(piece, start, end, handles) || !near(piece, i)) return std::nullopt;
    return piece;
  }

  bool near(const Piece& piece, int first) const {
    double worst = 0, size = 0;
    for (const Vector& x : piece.points)
      for (const double c : Vector(x - piece.points[0])) size = (std::max)(size, std::abs(c));
    const double tolerance = tolerance_ * (1 - 0x1p-20) - size * 0x1p-46; // so that intervals prove it
    return tolerance > 0 && near_polyline<double>(piece, first, tolerance * tolerance, worst);
  }

  // The distance: x and p run monotonically along both, over [t0, t1] and along a segment at one time. There x is a Bezier curve, and
  // so is x - p, which is not larger than the largest of its control points. So no point of either is farther from the other
  // than that, nor is it the distance of Frechet.

  template <class NT> using Vector_of = Coordinate_vector<NT, N>;
  template <class NT> using Points_of = std::array<Vector_of<NT>, degree + 1>;

  static double upper(double x) { return x; }
  static double upper(const Interval_nt<false>& x) { return x.sup(); }

  template <class NT> static Vector_of<NT> over(const Vector& v) {
    if constexpr (std::is_same_v<NT, double>)
      return v;
    else {
      Vector_of<NT> r(v.dimension());
      for (int x = 0; x < v.dimension(); ++x) r[x] = NT(v[x]);
      return r;
    }
  }

  // Point and derivatives, as many as there are free points, at a parameter: as differences of control points.
  template <class NT> struct Place {
    double t;
    std::array<Vector_of<NT>, free_points + 1> x;
    Vector_of<NT> p; // the point of the polyline
  };
  template <class NT> static Place<NT> place(Points_of<NT> b, double t, const Vector_of<NT>& p) {
    const NT at(t);
    const auto step = [&](int m) {
      for (int i = 0; i < m; ++i) b[i] += at * (b[i + 1] - b[i]);
    };
    for (int m = degree; m > free_points; --m) step(m);
    Place<NT> result{t, {}, p};
    if constexpr (free_points == 2) {
      result.x[2] = NT(degree * (degree - 1)) * (b[2] - b[1] - (b[1] - b[0]));
      step(2);
    }
    result.x[1] = NT(degree) * (b[1] - b[0]);
    step(1);
    result.x[0] = b[0];
    return result;
  }

  template <class NT>
  bool near_segment(const Piece& piece, const Points_of<NT>& b, const Place<NT>& from, const Place<NT>& to,
                    double squared_tolerance, double& worst, int halvings) const {
    const NT h = NT(to.t) - NT(from.t);
    double gap = 0;
    for (int i = 0; i <= free_points; ++i)
      for (const int sign : {1, -1}) {
        const Place<NT>&at = sign == 1 ? from : to, &other = sign == 1 ? to : from;
        const NT part = NT(i) / NT(degree), step = NT(sign) * h * part;
        Vector_of<NT> d = at.x[0] + step * at.x[1] - (at.p + part * (other.p - at.p));
        if constexpr (free_points == 2)
          if (i == 2) d += (h * h / NT(degree * (degree - 1))) * at.x[2];
        const double square = upper(dot(d, d));
        if (i == 0 && !(square <= squared_tolerance)) return false;
        gap = (std::max)(gap, square);
      }
    constexpr int refinements = std::is_same_v<NT, double> ? 0 : 4; // for a close bound
    const bool suffices = gap <= squared_tolerance;
    if (suffices && (gap <= worst || halvings >= refinements)) {
      worst = (std::max)(worst, gap);
      return true;
    }
    if (halvings == most_halvings) return false;
    const Vector_of<NT> middle = (from.p + to.p) / NT(2);
    Vector p = piece.points[0];
    for (int x = 0; x < p.dimension(); ++x) p[x] += upper(middle[x]);
    const Place<NT> between = place<NT>(b, parameter_between(piece, from.t, to.t, p), middle);
    double of_halves = worst;
    const bool halves = near_segment(piece, b, from, between, squared_tolerance, of_halves, halvings + 1) &&
                        near_segment(piece, b, between, to, squared_tolerance, of_halves, halvings + 1);
    if (halves || suffices) worst = halves ? of_halves : (std::max)(worst, gap);
    return halves || suffices;
  }

  // Whether the piece from the vertex `first` on is near; if so, `worst` is at least the square of its distance.
  template <class NT> bool near_polyline(const Piece& piece, int first, double squared_tolerance, double& worst) const {
    Points_of<NT> b; // from the first one, which is the origin: small numbers have small errors
    const Vector_of<NT> origin = over<NT>(piece.points[0]);
    for (int i = 0; i <= degree; ++i) b[i] = over<NT>(piece.points[i]) - origin;
    Place<NT> from = place<NT>(b, 0, over<NT>(p_[first]) - origin);
    for (std::size_t k = 1; k < piece.parameters.size(); ++k) {
      Place<NT> to = place<NT>(b, piece.parameters[k], over<NT>(p_[first + static_cast<int>(k)]) - origin);
      if (!near_segment(piece, b, from, to, squared_tolerance, worst, 0)) return false;
      from = std::move(to);
    }
    return true;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_POLYLINE_FIT_H
