// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H
#define CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H

#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// The fairest blend of a family, by the method of Levenberg and Marquardt, and where the search
// starts: blends of least energy, and fair ones with less freedom. Deterministic; nothing is
// allocated.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

// The blend of least energy with the automatic shape, times e^a at the start and e^b at the end.
template <Blend_kind kind, int M>
typename Fair_family<kind, M>::Unknowns least_energy(const Fair_family<kind, M>& f, double a = 0, double b = 0) {
  typedef Coordinate_vector<double, M> Vector;
  const double beta = std::exp(a), eta = std::exp(b);
  const Vector origin(M);
  if constexpr (kind == Blend_kind::g2) {
    const Quintic_parameters<double> p =
        Minimal_energy<3>()(Quintic_ends<double, M>(origin, f.chord, beta * f.start.d[0], eta * f.end.d[0],
                                                    (beta * beta) * f.start.d[1], (eta * eta) * f.end.d[1]));
    return {a, 20 * p.s1, b, 20 * p.s2};
  } else {
    const std::array<Vector, 4> phi = {origin, f.start.d[0], f.start.d[1], f.start.d[2]},
                                psi = {f.chord, f.end.d[0], f.end.d[1], f.end.d[2]};
    const Septic_parameters<double> p =
        Minimal_energy_g3<4>()(Septic_ends<double, M>(phi, psi, Shape_parameters<double>(beta, eta)));
    if constexpr (kind == Blend_kind::g3)
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, b, p.end.beta2 / eta, p.end.beta3 / eta};
    else
      return {a, p.start.beta2 / beta, p.start.beta3 / beta, p.start.mu / (beta * beta),
              b, p.end.beta2 / eta,    p.end.beta3 / eta,    p.end.mu / (eta * eta)};
  }
}

// G2 for G3, and G3 for F3.
// unreachable: computed by the compiler
constexpr Blend_kind simpler_kind(Blend_kind kind) { return kind == Blend_kind::f3 ? Blend_kind::g3 : Blend_kind::g2; }

template <Blend_kind kind, int M> Fair_family<simpler_kind(kind), M> simpler_family(const Fair_family<kind, M>& f) {
  constexpr Blend_kind simpler = simpler_kind(kind);
  const auto end = [](const Fair_end<kind, M>& e) {
    Fair_end<simpler, M> s;
    for (int k = 0; k < Fair_end<simpler, M>::order; ++k) s.d[k] = e.d[k];
    s.direction = e.direction;
    return s;
  };
  return {f.chord, end(f.start), end(f.end)};
}

// A G3 end from a G2 one, with the tangential part of its third derivative g3.
template <int M>
typename Fair_end<Blend_kind::g3, M>::Unknowns
with_more_freedom(const Fair_end<Blend_kind::g3, M>& end, const typename Fair_end<Blend_kind::g2, M>::Unknowns& x,
                  const Coordinate_vector<double, M>& g3) {
  const double e = std::exp(x[0]);
  // equivalent [* -> +, 4]: where a search starts
  const Coordinate_vector<double, M> u = e * end.d[0], w = (e * e) * end.d[1], z = (e * e * e) * end.d[2];
  return {x[0], x[1], dot(g3 - z - (3 * x[1]) * w, u) / dot(u, u)};
}

// The blend of this kind that is the given one of a simpler kind, or as near to it as possible.
template <int M>
typename Fair_family<Blend_kind::f3, M>::Unknowns
with_more_freedom(const Fair_family<Blend_kind::f3, M>&, const Fair_family<Blend_kind::g3, M>&,
                  const typename Fair_family<Blend_kind::g3, M>::Unknowns& x) {
  return {x[0], x[1], x[2], 3 * x[1], x[3], x[4], x[5], 3 * x[4]};
}
template <int M>
typename Fair_family<Blend_kind::g3, M>::Unknowns
with_more_freedom(const Fair_family<Blend_kind::g3, M>& f, const Fair_family<Blend_kind::g2, M>& simpler,
                  const typename Fair_family<Blend_kind::g2, M>::Unknowns& x) {
  const typename Fair_family<Blend_kind::g2, M>::Points b = simpler.points(x); // without the origin
  const auto s = with_more_freedom<M>(f.start, {x[0], x[1]}, 60. * (b[2] - 3. * b[1] + 3. * b[0])),
             // equivalent [- -> +, 2]: where a search starts
      e = with_more_freedom<M>(f.end, {x[2], x[3]}, 60. * (b[4] - 3. * b[3] + 3. * b[2] - b[1]));
  return {s[0], s[1], s[2], e[0], e[1], e[2]};
}

enum class Shape_choice { free, given };

template <Blend_kind kind, int M> class Fair_minimum {
  typedef Fair_family<kind, M> Family;
  typedef typename Family::Unknowns Unknowns;
  template <int nodes> using Quadrature = Fairness_quadrature<kind, M, nodes>;
  static constexpr int unknowns = Family::unknowns, shape_unknowns[2] = {0, Family::End::unknowns};
  static constexpr double log2 = 0.6931471805599453;
  // The logarithm of a shape parameter changes by no more: a factor of 4.
  static constexpr double most_change = 2 * log2;
  static constexpr double longest_step = 0.75; // of the same
  static constexpr double precision = 1e-3;    // of E, as far as the expansion tells
  static constexpr double agreement = 1e-2;    // of two quadratures
  // when they see the same curve, which almost has a cusp
  static constexpr double rough_agreement = 0.5;
  // E of a curve that nobody can tell from an arc of a circle
  static constexpr double negligible = 1e-6;
  // E of a curve near which there may be a better one
  static constexpr double doubtful = 400;
  static constexpr double ugly = 5e3;         // E of a curve that nobody would draw
  static constexpr int most_iterations = 100; // of one descent
  static constexpr int patience = 4;          // iterations, after which a descent is given up
  static constexpr double hopeless = 3;       // when its E is so many times that of another one

  const Family& family_;
  const Shape_choice shape_;
  const Unknowns automatic_; // the blend of least energy with the automatic shape
  // the logarithms of the changes that shorten the tangents to the diameters of curvature
  const std::array<double, 2> short_;

public:
  Unknowns x;                   // the blend that was found, rounded
  double before = 0, after = 0; // E of the automatic blend, and of x
  int iterations = 0;
  bool converged = false;

  // `rounded(x)` is a blend near x whose numbers are short.
  template <class Rounding>
  Fair_minimum(const Family& family, Shape_choice shape, const Rounding& rounded)
      : family_(family), shape_(shape),
        automatic_(least_energy(family)), short_{shortening(family.start), shortening(family.end)},
        x(rounded(automatic_)), after(std::numeric_limits<double>::infinity()) {
    // a curve that is almost a cusp needs more nodes
    const auto search = [&](const Unknowns& y) {
      descend<24>(y, rounded) || descend<48>(y, rounded) || descend<96>(y, rounded);
    };
    search(start());
    if constexpr (kind == Blend_kind::g2) { // the others start from what is found here
      if (!(after < doubtful))
        for (const Unknowns& y : long_starts()) search(y);
      if (!(after < ugly))
        for (const std::pair<double, Unknowns>& y : starts_from_everywhere())
          if (y.first < std::numeric_limits<double>::infinity()) search(y.second);
    }
    if (!(after <= before)) { // nothing is better, or was found
      x = rounded(automatic_);
      // equivalent [+ -> -, 1]: how near the values of two searches are that count as one
      converged = converged && after <= (1 + agreement) * before + negligible;
      after = before;
    }
    if constexpr (kind == Blend_kind::g2)
      if (shape == Shape_choice::free && !(after < ugly)) shorten(rounded(least_energy(family, short_[0], short_[1])));
  }

private:
  // A tangent that is longer than the diameter of the circle of curvature makes the blend leave it
  // at once.
  static double shortening(const typename Family::End& end) {
    const double g = dot(end.d[0], end.d[0]), h = dot(end.d[0], end.d[1]) / g;
    const typename Family::Vector normal = end.d[1] - h * end.d[0];
    const double ratio = 2 * std::sqrt(g / dot(normal, normal)); // the diameter to the tangent
    return ratio < 1 ? std::log(ratio) : 0;
  }

  // Takes y, which at least is not far away, where it is fairer than x, or where x is an automatic
  // blend with a cusp that no quadrature sees.
  void shorten(const Unknowns& y) {
    Quadrature<96> quadrature(family_);
    const double e = quadrature.value(y);
    const bool turns_back = quadrature.turns_back();
    quadrature.value(x);
    if (!(e < after) && (turns_back || !quadrature.turns_back())) return;
    x = y;
    after = e;
    before = (std::max)(before, e);
    converged = false;
  }

  // The automatic blend, or the fair one with less freedom where that is better.
  Unknowns start() {
    if constexpr (kind != Blend_kind::g2) {
      const auto simpler = simpler_family(family_);
      const Fair_minimum<simpler_kind(kind), M> minimum(simpler, shape_, [](const auto& y) { return y; });
      iterations = minimum.iterations;
      const Unknowns y = with_more_freedom(family_, simpler, minimum.x);
      Quadrature<24> quadrature(family_);
      if (quadrature.value(y) < quadrature.value(automatic_)) return y;
    }
    return automatic_;
  }

  // Blends with the longest tangents: curves that turn in a wide bow, where the automatic blend
  // leads to a narrow one. Chosen by trial on some thousand pairs; the same for the reversed blend.
  std::array<Unknowns, 4> long_starts() const {
    const bool free = shape_ == Shape_choice::free;
    const double a = free ? short_[0] + most_change : 0, b = free ? short_[1] + most_change : 0;
    return {{{a, 4, b, 2}, {a, -2, b, -4}, {a, -12, b, 2}, {a, -2, b, 12}}};
  }

  // The automatic blend may be in the reach of a bad minimum only, as when it has a small loop.
  // Returns the blends of a coarse grid that have the least E, with different shapes where the
  // shape is free.
  std::array<std::pair<double, Unknowns>, 4> starts_from_everywhere() const {
    Quadrature<24> quadrature(family_);
    std::array<std::pair<double, Unknowns>, 4> best; // in increasing order
    best.fill({std::numeric_limits<double>::infinity(), automatic_});
    const bool free = shape_ == Shape_choice::free;
    const int reach = free ? 2 : 0;
    const double start = free ? short_[0] : 0, end = free ? short_[1] : 0;
    for (int a = -reach; a <= reach; ++a)
      for (int b = -reach; b <= reach; ++b) {
        std::pair<double, Unknowns> y = best.back();
        for (double s : {-4., -2., 0., 2.})
          for (double t : {-2., 0., 2., 4.}) {
            const Unknowns z = {start + a * log2, s, end + b * log2, t};
            const double e = quadrature.value(z);
            if (e < y.first) y = {e, z};
          }
        if (!(y.first < best.back().first)) continue;
        best.back() = y;
        std::sort(best.begin(), best.end());
      }
    return best;
  }

  // Minimises the quadrature with so many nodes, from y. Takes what was found if it is better than
  // x, unless twice as many nodes see another curve; returns whether they agree.
  template <int nodes, class Rounding> bool descend(Unknowns y, const Rounding& rounded) {
    Quadrature<nodes> quadrature(family_);
    const std::pair<double, bool> found = minimise(quadrature, y);
    if (found.first > after) return true; // nothing is gained here
    Quadrature<2 * nodes> finer(family_);
    before = (std::max)(before, finer.value(automatic_)); // few nodes may miss a cusp
    const double difference = std::abs(finer.value(y) - found.first);
    const bool agreed = difference <= agreement * (found.first + negligible) && !finer.turns_back();
    y = rounded(y);
    const double e = finer.value(y);
    if ((agreed || (difference < rough_agreement * found.first && !finer.turns_back())) && e < after) {
      x = y;
      after = e;
      converged = agreed && found.second;
    }
    return agreed;
  }

  double least_change(int k) const { return short_[k == shape_unknowns[0] ? 0 : 1] - most_change; }

  bool is_fixed(int k, const Unknowns& y, const Unknowns& gradient) const {
    for (int shape : shape_unknowns)
      if (k == shape)
        return shape_ == Shape_choice::given || (y[k] >= most_change && gradient[k] < 0) ||
               // equivalent [&& gradient[k] > 0 -> nothing, 1]: a search that begins with the
               //   shortest tangents keeps them; the searches from the other starts are compared
               //   with it
               (y[k] <= least_change(k) && gradient[k] > 0);
    return false;
  }

  // Starts from y; returns the least value that was found, which is that of y then, and whether it
  // is a minimum.
  template <int nodes> std::pair<double, bool> minimise(Quadrature<nodes>& quadrature, Unknowns& y) {
    double here = quadrature.value(y), damping = 1e-2;
    Fairness_expansion<unknowns> expansion = quadrature.expand(y);
    for (int i = 0; i < most_iterations; ++i, ++iterations) {
      Work_meter::pause();
      if (!(here <= (std::numeric_limits<double>::max)())) break;
      if (i >= patience && here > hopeless * after) break; // than what was found from another start
      const Unknowns next = step(y, expansion, damping);
      double gain = 0; // as the expansion predicts it
      for (int k = 0; k < unknowns; ++k) {
        const double h = next[k] - y[k];
        gain -= 2 * expansion.gradient[k] * h;
        for (int l = 0; l < unknowns; ++l) gain -= h * expansion.matrix[k][l] * (next[l] - y[l]);
      }
      if (gain * (1 + damping) <= precision * (here + negligible)) return {here, true};
      if (!(gain > 1e-3 * precision * (here + negligible))) break;
      const double value = quadrature.value(next);
      if (value < here) {
        const double ratio = (here - value) / gain;
        damping = (std::max)(damping * (ratio > 0.75 ? 0.1 : ratio < 0.25 ? 2 : 0.5), 1e-9);
        y = next;
        here = value;
        expansion = quadrature.expand(y);
      } else
        damping *= 8;
    }
    return {here, false};
  }

  // The minimum of the expansion with damping, not too far away.
  Unknowns step(const Unknowns& y, const Fairness_expansion<unknowns>& e, double damping) const {
    const Unknowns h = e.step(damping, [&](int k) { return is_fixed(k, y, e.gradient); });
    double longest = 0;
    for (int k : shape_unknowns) longest = (std::max)(longest, std::abs(h[k]));
    const double part = longest > longest_step ? longest_step / longest : 1;
    Unknowns next;
    for (int k = 0; k < unknowns; ++k) next[k] = y[k] + part * h[k];
    for (int k : shape_unknowns) next[k] = (std::min)((std::max)(next[k], least_change(k)), most_change);
    return next;
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_BLENDS_INTERNAL_FAIR_MINIMUM_H
