// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIRNESS_QUADRATURE_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIRNESS_QUADRATURE_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/internal/Gauss_rule.h>
#include <CGAL/Geometric_continuity/algebra/internal/solve_positive_definite.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/internal/independent_iterations.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

// The fairness E = L^3 int |(dK/ds)_perp|^2 ds of a blend, and its first derivatives, by Gauss's
// quadrature with a fixed number of nodes. With a = d1.d2/g, b = d1.d3/g, g = d1.d1,
//
//   f = M / g^(5/4),   M = d3 - 3a d2 + (3a^2 - b) d1,   E = L^3 int |f|^2 dt,   L = int sqrt(g) dt.
//
// E of any curve, to a precision, is in curves/fairness.h.

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_OFF

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Nodes and weights on [0, 1], and there the derivatives of the Bernstein polynomials.
template <int degree, int nodes> struct Gauss_nodes {
  static_assert(nodes % 4 == 0);
  typedef std::array<double, nodes> Row;

  Row weight, root_of_weight;
  // b[k-1][j]: derivative number k of the polynomial number j
  std::array<std::array<Row, degree + 1>, 3> b;

  static const Gauss_nodes& instance() {
    static const Gauss_nodes table;
    return table;
  }

private:
  Gauss_nodes() {
    const Gauss_rule<nodes>& rule = Gauss_rule<nodes>::instance();
    for (int i = 0; i < nodes; ++i) {
      const bool left = i < nodes / 2;
      const std::size_t from_middle = left ? nodes / 2 - 1 - i : i - nodes / 2;
      // of the node (1 - z)/2
      const double z = left ? rule.abscissa[from_middle] : -rule.abscissa[from_middle];
      weight[i] = rule.weight[from_middle] / 2;
      root_of_weight[i] = std::sqrt(weight[i]);
      for (int j = 0; j <= degree; ++j) {
        std::array<double, degree + 1> c{};
        c[j] = 1;
        int m = degree;
        for (int k = 0; k < 3; ++k) {
          const double factor = m;
          for (int l = 0; l < m; ++l) c[l] = factor * (c[l + 1] - c[l]);
          --m;
          b[k][j][i] = value(c, m, (1 - z) / 2);
        }
      }
    }
  }

  // Returns the value by de Casteljau's algorithm.
  static double value(std::array<double, degree + 1> c, int m, double t) {
    for (; m > 0; --m)
      for (int l = 0; l < m; ++l) c[l] += t * (c[l + 1] - c[l]);
    return c[0];
  }
};

// Half the gradient of E, and the matrix of Gauss and Newton: E(x + h) is near E + 2 g.h + h.Hh.
template <int unknowns> struct Fairness_expansion {
  std::array<double, unknowns> gradient;
  std::array<std::array<double, unknowns>, unknowns> matrix;

  // The step to the minimum of the expansion with damping, where the unknowns that `is_fixed` names
  // do not change.
  template <class Is_fixed> std::array<double, unknowns> step(double damping, const Is_fixed& is_fixed) const {
    std::array<std::array<double, unknowns>, unknowns> damped = matrix;
    std::array<double, unknowns> h;
    for (int k = 0; k < unknowns; ++k) {
      h[k] = -gradient[k];
      damped[k][k] += damping * damped[k][k] + (std::numeric_limits<double>::min)();
    }
    for (int k = 0; k < unknowns; ++k)
      if (is_fixed(k)) {
        for (int l = 0; l < unknowns; ++l) damped[k][l] = damped[l][k] = 0;
        damped[k][k] = 1;
        h[k] = 0;
      }
    return solve_positive_definite(damped, h);
  }
};

template <Blend_kind kind, int M, int nodes> class Fairness_quadrature {
  typedef Fair_family<kind, M> Family;
  typedef typename Family::Unknowns Unknowns;
  typedef typename Family::End End;
  typedef std::array<double, nodes> Row;
  typedef std::array<Row, M> Rows;
  static constexpr int degree = Family::degree, unknowns = Family::unknowns;

  const Family& family_;
  const Gauss_nodes<degree, nodes>& table_ = Gauss_nodes<degree, nodes>::instance();

  // These are taken at all nodes.
  std::array<Rows, 3> d_;                  // the derivatives
  Row speed_, over_g_, a_, e_, scale_;     // sqrt(g), 1/g, a, 3a^2 - b, sqrt(weight) / g^(5/4)
  Rows f_;                                 // f times sqrt(weight)
  std::array<Rows, unknowns> derivatives_; // of f, without that of L
  double length_ = 0, sum_ = 0;

public:
  explicit Fairness_quadrature(const Family& family) : family_(family) {}

  // E; infinite where the quadrature has no number, as when the derivative vanishes at a node.
  double value(const Unknowns& x) {
    evaluate(x);
    const double e = length_ * length_ * length_ * sum_;
    return e >= 0 ? e : std::numeric_limits<double>::infinity();
  }

  // The integral of |(dK/ds)_perp|^2 ds, for the x of the last call of value().
  double integral() const { return sum_; }

  // Returns whether the tangent turns by more than a right angle from one node to the next: the
  // last blend has a cusp, or almost.
  bool turns_back() const {
    for (int i = 0; i + 1 < nodes; ++i) {
      double product = 0;
      for (int c = 0; c < M; ++c) product += d_[0][c][i] * d_[0][c][i + 1];
      if (!(product > 0)) return true;
    }
    return false;
  }

  // Returns whether the tangent turns by less than 60 degrees from the start of the last blend to
  // the first node, from one node to the next, and on to the end: then no bend is hidden between
  // them.
  bool is_resolved() const {
    const auto turns = [](double product, double square, double other) {
      return !(product > 0 && 4 * product * product > square * other);
    };
    std::array<double, 2> ends{}, squares{};
    for (int c = 0; c < M; ++c)
      for (const int end : {0, 1}) {
        const double x = (end == 0 ? family_.start : family_.end).d[0][c];
        ends[end] += x * d_[0][c][end * (nodes - 1)];
        squares[end] += x * x;
      }
    for (const int end : {0, 1}) {
      const double speed = speed_[end * (nodes - 1)];
      if (turns(ends[end], squares[end], speed * speed)) return false;
    }
    for (int i = 0; i + 1 < nodes; ++i) {
      double product = 0;
      for (int c = 0; c < M; ++c) product += d_[0][c][i] * d_[0][c][i + 1];
      if (turns(product, speed_[i] * speed_[i], speed_[i + 1] * speed_[i + 1])) return false;
    }
    return true;
  }

  // Expands at the x of the last call of value().
  Fairness_expansion<unknowns> expand(const Unknowns& x) {
    Fairness_expansion<unknowns> r;
    // of each derivative: that of L / L, its product with f
    std::array<double, unknowns> relative_length, product;
    const auto starts = family_.start.tangents(Family::start_of(x));
    const auto ends = family_.end.tangents(Family::end_of(x));
    for (int k = 0; k < unknowns; ++k) {
      const bool at_start = k < End::unknowns;
      relative_length[k] = differentiate(at_start ? starts[k] : ends[k - End::unknowns], at_start, derivatives_[k]);
      product[k] = dot(derivatives_[k], f_);
    }
    const double cube = length_ * length_ * length_;
    for (int k = 0; k < unknowns; ++k) {
      r.gradient[k] = cube * (product[k] + 1.5 * relative_length[k] * sum_);
      for (int l = 0; l <= k; ++l)
        r.matrix[k][l] = r.matrix[l][k] =
            cube * (dot(derivatives_[k], derivatives_[l]) +
                    1.5 * (relative_length[k] * product[l] + relative_length[l] * product[k]) +
                    2.25 * relative_length[k] * relative_length[l] * sum_);
    }
    return r;
  }

  // Finds half of the gradient of the integral, and the matrix of the products of the derivatives
  // of f, when the control points at one end move by h; at the x of the last call of value().
  template <int number, class At_start>
  void products(const std::array<typename End::Points, number>& h, At_start at_start,
                std::array<std::array<double, number>, number>& matrix, std::array<double, number>& gradient) const {
    std::array<Rows, number> derivatives;
    Rows f{};
    if constexpr (M == 2) {
      Turned t;
      turn(t);
      f[0] = t.f;
      for (int k = 0; k < number; ++k) differentiate_turned(t, h[k], at_start(k), derivatives[k]);
    } else {
      f = f_;
      for (int k = 0; k < number; ++k) differentiate(h[k], at_start(k), derivatives[k]);
    }
    for (int k = 0; k < number; ++k) {
      gradient[k] = dot(derivatives[k], f);
      for (int l = 0; l <= k; ++l) matrix[k][l] = matrix[l][k] = dot(derivatives[k], derivatives[l]);
    }
  }

private:
  static double sum(const Row& x) {
    std::array<double, 4> lanes{};
    for (int i = 0; i < nodes; i += 4)
      for (int l = 0; l < 4; ++l) lanes[l] += x[i + l];
    return lanes[0] + lanes[1] + (lanes[2] + lanes[3]);
  }
  static double dot(const Rows& x, const Rows& y) {
    Row products{};
    for (int c = 0; c < M; ++c) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) products[i] += x[c][i] * y[c][i];
    return sum(products);
  }
  static void dot(const Rows& x, const Rows& y, Row& products) {
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) products[i] = x[0][i] * y[0][i];
    for (int c = 1; c < M; ++c) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) products[i] += x[c][i] * y[c][i];
  }

  void evaluate(const Unknowns& x) {
    const typename Family::Points p = family_.points(x);
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < M; ++c) {
        Row& row = d_[k][c];
        CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
        for (int i = 0; i < nodes; ++i) row[i] = table_.b[k][1][i] * p[0][c];
        for (int j = 2; j <= degree; ++j) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
        for (int i = 0; i < nodes; ++i) row[i] += table_.b[k][j][i] * p[j - 1][c];
      }
    Row g, first, second;
    dot(d_[0], d_[0], g);
    dot(d_[0], d_[1], first);
    dot(d_[0], d_[2], second);
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) speed_[i] = std::sqrt(g[i]);
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) scale_[i] = std::sqrt(speed_[i]);
    Row lengths;
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) {
      over_g_[i] = 1 / g[i];
      a_[i] = first[i] * over_g_[i];
      e_[i] = 3 * a_[i] * a_[i] - second[i] * over_g_[i];
      scale_[i] = table_.root_of_weight[i] * over_g_[i] / scale_[i];
      lengths[i] = table_.weight[i] * speed_[i];
    }
    for (int c = 0; c < M; ++c) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i)
      f_[c][i] = scale_[i] * (d_[2][c][i] - 3 * a_[i] * d_[1][c][i] + e_[i] * d_[0][c][i]);
    length_ = sum(lengths);
    sum_ = dot(f_, f_);
  }

  // The derivatives of the basis of a control point at an end, number j from there.
  static constexpr int basis(bool at_start, int j) { return at_start ? j + 1 : degree - 1 - j; }

  // In the plane, f across the tangent: m (d1 x d3 - 3a d1 x d2) with m = sqrt(weight) / g^(7/4).
  // Its derivative is that of this number, and along the tangent, with which it turns, f (d1 x dd1)
  // / g.
  struct Turned {
    Row f, m, second; // d1 x d2
  };
  void turn(Turned& t) const {
    const auto& [d1, d2, d3] = d_;
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) {
      t.m[i] = scale_[i] / speed_[i];
      t.second[i] = d1[0][i] * d2[1][i] - d1[1][i] * d2[0][i];
      t.f[i] = t.m[i] * (d1[0][i] * d3[1][i] - d1[1][i] * d3[0][i] - 3 * a_[i] * t.second[i]);
    }
  }
  void differentiate_turned(const Turned& t, const typename End::Points& h, bool at_start, Rows& df) const {
    const auto& [d1, d2, d3] = d_;
    const Row &a1 = table_.b[0][basis(at_start, 0)], &a2 = table_.b[1][basis(at_start, 0)],
              &a3 = table_.b[2][basis(at_start, 0)], &b1 = table_.b[0][basis(at_start, 1)],
              &b2 = table_.b[1][basis(at_start, 1)], &b3 = table_.b[2][basis(at_start, 1)];
    const double px = h[0][0], py = h[0][1], qx = h[1][0], qy = h[1][1];
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) {
      const double x1 = a1[i] * px + b1[i] * qx, y1 = a1[i] * py + b1[i] * qy, x2 = a2[i] * px + b2[i] * qx,
                   y2 = a2[i] * py + b2[i] * qy, x3 = a3[i] * px + b3[i] * qx, y3 = a3[i] * py + b3[i] * qy,
                   along = (d1[0][i] * x1 + d1[1][i] * y1) * over_g_[i],
                   da =
                       (d1[0][i] * x2 + d1[1][i] * y2 + d2[0][i] * x1 + d2[1][i] * y1) * over_g_[i] - 2 * a_[i] * along,
                   second = x1 * d2[1][i] - y1 * d2[0][i] + d1[0][i] * y2 - d1[1][i] * x2,
                   third = x1 * d3[1][i] - y1 * d3[0][i] + d1[0][i] * y3 - d1[1][i] * x3;
      df[1][i] = t.f[i] * (d1[0][i] * y1 - d1[1][i] * x1) * over_g_[i];
      df[0][i] = t.m[i] * (third - 3 * (da * t.second[i] + a_[i] * second)) - 3.5 * along * t.f[i];
    }
  }

  // The derivative of f, times sqrt(weight), when the control points at one end move by h; returns
  // that of L, divided by L.
  double differentiate(const typename End::Points& h, bool at_start, Rows& df) const {
    std::array<Rows, 3> dd;
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < M; ++c) {
        Row& row = dd[k][c];
        for (int j = 0; j < End::order; ++j) {
          const Row& b = table_.b[k][basis(at_start, j)];
          if (j == 0) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
          for (int i = 0; i < nodes; ++i) row[i] = b[i] * h[j][c];
          else CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS for (int i = 0; i < nodes; ++i) row[i] +=
              b[i] * h[j][c];
        }
      }
    Row p11, p12, p21, p13, p31, da, db, dg, lengths;
    dot(d_[0], dd[0], p11);
    dot(d_[0], dd[1], p12);
    dot(dd[0], d_[1], p21);
    dot(d_[0], dd[2], p13);
    dot(dd[0], d_[2], p31);
    CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i) {
      const double b = 3 * a_[i] * a_[i] - e_[i];
      da[i] = (p12[i] + p21[i] - 2 * a_[i] * p11[i]) * over_g_[i];
      db[i] = (p13[i] + p31[i] - 2 * b * p11[i]) * over_g_[i];
      dg[i] = 2.5 * p11[i] * over_g_[i];
      lengths[i] = table_.weight[i] * p11[i] * over_g_[i] * speed_[i];
    }
    for (int c = 0; c < M; ++c) CGAL_GEOMETRIC_CONTINUITY_INDEPENDENT_ITERATIONS
    for (int i = 0; i < nodes; ++i)
      df[c][i] = scale_[i] * (dd[2][c][i] - 3 * a_[i] * dd[1][c][i] + e_[i] * dd[0][c][i] - 3 * da[i] * d_[1][c][i] +
                              (6 * a_[i] * da[i] - db[i]) * d_[0][c][i]) -
                 dg[i] * f_[c][i];
    return sum(lengths) / length_;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

CGAL_GEOMETRIC_CONTINUITY_LOOP_WARNINGS_ON

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIRNESS_QUADRATURE_H
