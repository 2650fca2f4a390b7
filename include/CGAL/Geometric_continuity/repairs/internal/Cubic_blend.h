// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CUBIC_BLEND_H
#define CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CUBIC_BLEND_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

// G2 blends by cubics, of two jets of order 2: P, d1, d2 at the start and Q, e1, e2 at the end.
//
// Where d1, d2 and e1, e2 are parallel and the tangents meet in V in front of P and behind Q, one
// cubic P, V, V, Q has zero curvature at both ends, as the jets have.
//
// In the plane there are two cubics P, B1, C1, M and M, C2, B2, Q,
//
//   B1 = P + h d1,  C1 = B1 + s d1 + 3/2 h^2 d2,  B2 = Q - g e1,  C2 = B2 + 3/2 g^2 e2 - t e1,
//   M = (r C1 + C2) / (1 + r),
//
// which are G2 with the jets for all h, g > 0: their second derivatives are (3h)^2 d2 and
// (3g)^2 e2, up to multiples of the first ones. In M the tangents agree, and the curvatures if
//
//   A2 = r^2 A1,  A1 = (C1 - B1) x (C2 - C1),  A2 = (C2 - C1) x (B2 - C2).
//
// Both are linear in t, because e1 x e1 = 0. The numbers h, g, s, r > 0 are chosen, so that the
// curvature varies little, and rounded; t is one division.
//
// Between ends that are bent to different sides both A1 and A2 may be 0, with an inflection in M:
// a direction u there, g = k h and r are chosen. Then C1 - B1, C2 - C1 and B2 - C2 are parallel to
// u if
//
//   h = (Q - P) x u / (d1 + k e1) x u,  s = -3/2 h^2 d2 x u / d1 x u,  t = 3/2 g^2 e2 x u / e1 x u.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Two jets in the plane.
template <class NT> struct Plane_ends { Coordinate_vector<NT, 2> p, d1, d2, q, e1, e2; };

template <class NT> using Two_cubics = std::array<Coordinate_vector<NT, 2>, 7>;

template <class NT> NT cross(const Coordinate_vector<NT, 2>& a, const Coordinate_vector<NT, 2>& b) {
  return NT(a[0] * b[1] - a[1] * b[0]);
}

// The free numbers of two cubics that bend to one side in M. They have control points if t > 0.
template <class NT> struct Bent_cubics {
  NT h, g, s, r;

  std::optional<Two_cubics<NT>> operator()(const Plane_ends<NT>& e) const {
    typedef Coordinate_vector<NT, 2> Vector;
    const NT factor = NT(3) / NT(2);
    const Vector b1 = e.p + h * e.d1, a = s * e.d1 + NT(factor * h * h) * e.d2, c1 = b1 + a, b2 = e.q - g * e.e1,
                 c = b2 + NT(factor * g * g) * e.e2, m = c - c1, n = b2 - c;
    const NT square = r * r, divisor = cross(m, e.e1) - cross(e.e1, n) + square * cross(a, e.e1);
    if (divisor == NT(0)) return std::nullopt;
    const NT t = (square * cross(a, m) - cross(m, n)) / divisor;
    const Vector c2 = c - t * e.e1;
    if (!(NT(0) < t) || c1 == c2) return std::nullopt;
    return Two_cubics<NT>{e.p, b1, c1, Vector(NT(NT(1) / NT(NT(1) + r)) * (r * c1 + c2)), c2, b2, e.q};
  }
};

// The free numbers of two cubics with an inflection in M. They have control points if s, t >= 0 and
// the curve runs along u in M.
template <class NT> struct Inflected_cubics {
  Coordinate_vector<NT, 2> u;
  NT k, r;

  std::optional<Two_cubics<NT>> operator()(const Plane_ends<NT>& e) const {
    typedef Coordinate_vector<NT, 2> Vector;
    const NT start = cross(e.d1, u), end = cross(e.e1, u), sum = start + k * end;
    if (start == NT(0) || end == NT(0) || sum == NT(0)) return std::nullopt;
    const NT h = cross(Vector(e.q - e.p), u) / sum, g = k * h, h2 = NT(3) / NT(2) * h * h, g2 = NT(3) / NT(2) * g * g,
             s = -h2 * cross(e.d2, u) / start, t = g2 * cross(e.e2, u) / end;
    const Vector b1 = e.p + h * e.d1, c1 = b1 + s * e.d1 + h2 * e.d2, b2 = e.q - g * e.e1,
                 c2 = b2 + g2 * e.e2 - t * e.e1;
    const auto leads_back = [&](const Vector& v) { return bool(dot(v, u) < NT(0)); };
    if (!(NT(0) < h) || s < NT(0) || t < NT(0) || !(NT(0) < dot(Vector(c2 - c1), u)) || leads_back(c1 - b1) ||
        leads_back(b2 - c2))
      return std::nullopt;
    return Two_cubics<NT>{e.p, b1, c1, Vector(NT(NT(1) / NT(NT(1) + r)) * (r * c1 + c2)), c2, b2, e.q};
  }
};

// Chooses the free numbers, for ends that are moved to the origin and divided by their distance,
// with first derivatives of length 1. By a search in four directions, first in the two that leave
// symmetric ends symmetric. Deterministic.
class Cubic_search {
  typedef std::array<double, 4> Place;
  static constexpr double least_step = 1. / 128, least_gain = 1e-7;
  const Plane_ends<double>& ends_;

public:
  struct Candidate {
    bool is_inflected = false;
    Place x = {};
    double fairness = std::numeric_limits<double>::infinity();

    // The logarithms of sqrt(hg), s, sqrt(h/g) and r, base 2.
    Bent_cubics<double> bent() const {
      return {std::exp2(x[0] + x[2]), std::exp2(x[0] - x[2]), std::exp2(x[1]), std::exp2(x[3])};
    }
    // The angle of u in eighths of a right angle, nothing, and the logarithms of k and r.
    Inflected_cubics<double> inflected() const {
      constexpr double unit = 0.19634954084936207;
      Inflected_cubics<double> cubics{{}, std::exp2(x[2]), std::exp2(x[3])};
      cubics.u[0] = std::cos(unit * x[0]);
      cubics.u[1] = std::sin(unit * x[0]);
      return cubics;
    }
  };

  explicit Cubic_search(const Plane_ends<double>& ends) : ends_(ends) {}

  // The fairness is infinite when no two cubics are found.
  Candidate operator()() const {
    const auto changes = {0., -1., 1., -2.5, 2.5};
    Candidate symmetric, any;
    const auto start = [&](const Place& x, bool is_inflected) {
      consider(x, is_inflected, any);
      if (x[2] == 0 && x[3] == 0) consider(x, is_inflected, symmetric);
    };
    for (const double skew : changes)
      for (const double r : changes) {
        for (double h : {-1., -2., -3., -4., -6.})
          for (double s : {0., -1.5, -2.5, -3.5, -5., -7.}) start({h, s, skew, r}, false);
        for (int u = 0; u < 32; ++u) start({double(u), 0, skew, r}, true);
      }
    for (Candidate* const c : {&symmetric, &any})
      if (!std::isinf(c->fairness)) descend(*c);
    return any.fairness < 0.99 * symmetric.fairness ? any : symmetric;
  }

private:
  // Takes other numbers if they are better, and returns whether they are.
  bool consider(const Place& x, bool is_inflected, Candidate& best) const {
    Candidate c{is_inflected, x};
    c.fairness = fairness(is_inflected ? c.inflected()(ends_) : c.bent()(ends_));
    const bool is_better = c.fairness < best.fairness * (1 - least_gain);
    if (is_better) best = c;
    return is_better;
  }

  void descend(Candidate& best) const {
    for (const std::size_t directions : {2, 4})
      for (double step = 0.5; step >= least_step;) {
        bool is_better = false;
        for (std::size_t k = 0; k < directions && !is_better; ++k)
          for (const double change : {step, -step}) {
            Place x = best.x;
            x[k] += change;
            is_better = consider(x, best.is_inflected, best) || is_better;
          }
        if (!is_better) step /= 2;
      }
  }

  // The fairness of both cubics at fixed nodes; infinite where the tangent turns by more than 60
  // degrees from one node to the next, which hide what is between them.
  double fairness(const std::optional<Two_cubics<double>>& points) const {
    constexpr int nodes = 20;
    const Gauss_nodes<3, nodes>& table = Gauss_nodes<3, nodes>::instance();
    if (!points) return std::numeric_limits<double>::infinity();
    double length = 0, sum = 0;
    Coordinate_vector<double, 2> last = ends_.d1;
    for (const std::size_t first : {0, 3})
      for (std::size_t i = 0; i < nodes; ++i) {
        Double_derivatives<2> d{};
        for (std::size_t k = 0; k < 3; ++k)
          for (std::size_t j = 0; j < 4; ++j) d[k] += table.b[k][j][i] * (*points)[first + j];
        const double product = dot(last, d[0]);
        if (!(product > 0 && 4 * product * product > dot(last, last) * dot(d[0], d[0])))
          return std::numeric_limits<double>::infinity();
        last = d[0];
        const std::array<double, 2> values = Curvature_variation()(d);
        length += table.weight[i] * values[0];
        sum += table.weight[i] * values[1];
      }
    return length * length * length * sum;
  }
};

// Blends two jets of order 2 by cubics, in an exact field.
template <class Field, int N> class Cubic_blend {
  typedef Coordinate_vector<Field, N> Vector;
  const Coordinate_jet<Field, N>&phi_, &psi_;
  const Vector chord_;

public:
  std::vector<Vector> points; // of one cubic, or of two
  Field ratio = Field(0);     // of the lengths of both domains

  // `single` tells whether one cubic is taken where there is one.
  // \throws Error `dimension_mismatch`, `not_representable` when there are no such cubics;
  //   `zero_direction`
  Cubic_blend(const Coordinate_jet<Field, N>& phi, const Coordinate_jet<Field, N>& psi, bool single,
              const std::string& place)
      : phi_(phi), psi_(psi), chord_(psi[0] - phi[0]) {
    if (is_zero(chord_)) throw Error(Error_code::zero_direction, place + ": both ends lie in one point");
    const bool is_straight = is_parallel(phi[1], phi[2]) && is_parallel(psi[1], psi[2]);
    if (is_straight && (set_line() || (single && set_corner()))) return;
    if (phi.dimension() != 2)
      throw Error(Error_code::dimension_mismatch,
                  place + ": two cubics join ends in the plane; in space one joins lines that meet in a corner, and "
                          "quintics all others");
    if (!set_two())
      throw Error(Error_code::not_representable,
                  place + ": no two cubics are found that join these ends without turning back; a quintic does");
  }

private:
  static bool is_parallel(const Vector& a, const Vector& b) {
    const Field ab = dot(a, b);
    return Field(dot(a, a) * dot(b, b)) == Field(ab * ab);
  }

  // Takes a straight line, where both ends lie on one.
  bool set_line() {
    const bool is_line = is_parallel(phi_[1], psi_[1]) && is_parallel(phi_[1], chord_) &&
                         Field(0) < Field(dot(phi_[1], psi_[1])) && Field(0) < Field(dot(phi_[1], chord_));
    const Field third = Field(1) / Field(3);
    if (is_line) points = {phi_[0], phi_[0] + third * chord_, psi_[0] - third * chord_, psi_[0]};
    return is_line;
  }

  // Takes P, V, V, Q where V = P + x d1 = Q - y e1 with x, y > 0. In space lines whose points are
  // rounded hardly meet: they may be as far apart as rounding leads them.
  bool set_corner() {
    const Vector &u = phi_[1], &v = psi_[1];
    const Field uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(chord_, u), wv = dot(chord_, v),
                determinant = uu * vv - uv * uv;
    if (determinant == Field(0)) return false;
    const Field x = (wu * vv - wv * uv) / determinant, y = (wv * uu - wu * uv) / determinant;
    const Vector apart = chord_ - x * u - y * v;
    const Field allowed = Field(dot(chord_, chord_)) * Field(1e-24);
    if (!(Field(0) < x && Field(0) < y) || allowed < Field(dot(apart, apart))) return false;
    const Vector corner = phi_[0] + x * u;
    points = {phi_[0], corner, corner, psi_[0]};
    return true;
  }

  bool set_two() {
    const double length = size(chord_), first = length / size(phi_[1]), last = length / size(psi_[1]);
    const auto in_chords = [&](const Vector& v, double factor) {
      return plane<double>([&](int i) { return CGAL::to_double(v[i]) * (factor / length); });
    };
    const auto exact = [](const Vector& v) { return plane<Field>([&](int i) { return v[i]; }); };
    const Plane_ends<double> d{in_chords(chord_, 0), in_chords(phi_[1], first), in_chords(phi_[2], first * first),
                               in_chords(chord_, 1), in_chords(psi_[1], last),  in_chords(psi_[2], last * last)};
    const Plane_ends<Field> e{exact(phi_[0]), exact(phi_[1]), exact(phi_[2]),
                              exact(psi_[0]), exact(psi_[1]), exact(psi_[2])};
    const Cubic_search::Candidate found = Cubic_search(d)();
    if (std::isinf(found.fairness)) return false;
    for (const int bits : {10, 30}) {
      const auto short_number = [bits](double x) { return rounded(x, bits); };
      const Bent_cubics<double> b = found.bent();
      const Inflected_cubics<double> i = found.inflected();
      ratio = short_number(b.r);
      const std::optional<Two_cubics<Field>> cubics =
          found.is_inflected ? Inflected_cubics<Field>{plane<Field>([&](int c) { return short_number(i.u[c]); }),
                                                       short_number(i.k * last / first), ratio}(e)
                             : Bent_cubics<Field>{short_number(b.h * first), short_number(b.g * last),
                                                  short_number(b.s * first), ratio}(e);
      if (!cubics) continue;
      for (const Coordinate_vector<Field, 2>& p : *cubics) {
        points.push_back(phi_[0]);
        for (int c = 0; c < 2; ++c) points.back()[c] = p[c];
      }
      return true;
    }
    return false;
  }

  template <class NT, class Coordinate> static Coordinate_vector<NT, 2> plane(Coordinate coordinate) {
    Coordinate_vector<NT, 2> v;
    for (int i = 0; i < 2; ++i) v[i] = coordinate(i);
    return v;
  }

  static double size(const Vector& v) { return std::sqrt(CGAL::to_double(Field(dot(v, v)))); }

  // The nearest number with so many binary digits.
  static Field rounded(double x, int bits) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return Field(std::ldexp(std::round(std::ldexp(mantissa, bits)), exponent - bits));
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_REPAIRS_INTERNAL_CUBIC_BLEND_H
