// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_FAIREST_SHAPE_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_FAIREST_SHAPE_H

#include <CGAL/FPU.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/Coordinate_vector.h>
#include <CGAL/Geometric_continuity/algebra/internal/Gauss_rule.h>
#include <CGAL/Geometric_continuity/blends/Fair.h>
#include <CGAL/Geometric_continuity/blends/blend_strategies.h>
#include <CGAL/Geometric_continuity/blends/internal/Fair_family.h>
#include <CGAL/Geometric_continuity/blends/internal/Fairness_quadrature.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/numbers/internal/short_numbers.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>
#include <CGAL/Geometric_continuity/surface_blends/Surface_blend_shape.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/Blend_end.h>
#include <CGAL/Geometric_continuity/surface_blends/internal/automatic_shape.h>
#include <CGAL/Geometric_continuity/surfaces/possible_fold.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Fairest_shape.h
/// The mean of the variations of curvature of the curves `u` = const of a blend surface, its
/// minimum over the constants \f$ \beta, \delta \f$ at both ends, and a barrier against folds.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Returns the parameters along a blend at which its curves u = const are looked at: nine, both ends
// among them, and four more for each further span, at most 65.
template <class FT> std::vector<FT> parameters_along(const Knot_vector<FT>& knots) {
  const int last = (std::min)(4 * knots.number_of_spans() + 4, 64);
  const std::pair<FT, FT> domain = knots.domain();
  const FT length = domain.second - domain.first;
  std::vector<FT> parameters;
  for (int k = 0; k < last; ++k) parameters.push_back(FT(domain.first + length * FT(k) / FT(last)));
  parameters.push_back(domain.second); // rounding leads beyond it
  return parameters;
}

// The variation of curvature of one Bezier curve of degree at most 7 by Gauss's quadrature, whose
// nodes are fixed: a cusp between two of them is a large number.
template <int M, bool is_rational> class Variation_of_curvature {
  static constexpr int degree = 7, nodes = 64, derivatives = 4;
  typedef Coordinate_vector<double, M> Vector;

  std::array<double, nodes> weight_;
  // the derivative number k of the Bernstein polynomial number j at each node
  std::array<std::array<std::array<double, degree + 1>, derivatives>, nodes> b_;

public:
  Variation_of_curvature() {
    const Gauss_rule<nodes>& rule = Gauss_rule<nodes>::instance();
    for (int i = 0; i < nodes; ++i) {
      const double z = i % 2 == 0 ? rule.abscissa[i / 2] : -rule.abscissa[i / 2];
      weight_[i] = rule.weight[i / 2] / 2;
      for (int j = 0; j <= degree; ++j) {
        std::vector<double> c(degree + 1, 0.);
        c[j] = 1;
        bernstein_derivatives(c, degree, (1 + z) / 2, derivatives - 1, [&](int k, double x) { b_[i][k][j] = x; });
      }
    }
  }

  // Takes control points, homogeneous ones of a rational curve. Infinite in a cusp.
  double operator()(std::vector<Vector> points) const {
    int q = static_cast<int>(points.size()) - 1;
    points.resize(degree + 1, Vector(points[0].dimension()));
    for (; q < degree; ++q) bernstein_elevate<double>(points, q);
    double length = 0, integral = 0;
    for (int i = 0; i < nodes; ++i) {
      Coordinate_jet<double, M> x(points[0].dimension(), derivatives - 1);
      for (int k = is_rational ? 0 : 1; k < derivatives; ++k)
        for (int j = 0; j <= degree; ++j) x[k] += b_[i][k][j] * points[j];
      const std::array<double, 2> values = variation(x);
      length += weight_[i] * values[0];
      integral += weight_[i] * values[1];
    }
    const double e = length * length * length * integral;
    return e >= 0 ? e : std::numeric_limits<double>::infinity();
  }

private:
  static std::array<double, 2> variation(const Coordinate_jet<double, M>& x) {
    if constexpr (is_rational) {
      const auto y = project(x);
      return Curvature_variation()(Double_derivatives<(M == 0 ? 0 : M - 1)>{y[1], y[2], y[3]});
    } else
      return Curvature_variation()(Double_derivatives<M>{x[1], x[2], x[3]});
  }
};

// Returns the mean for a surface that is polynomial, or one of homogeneous points.
template <bool is_rational, class Shape> double mean_variation(const Shape& s) {
  typedef typename Shape::FT FT;
  constexpr int M = Shape::N;
  typedef Coordinate_vector<double, M> Vector;
  static const Variation_of_curvature<M, is_rational> variation;
  const Knot_vector<FT> knots = knots_of_edge(s, Patch_edge::v0);
  std::vector<double> values;
  for (const FT& knot : knots) values.push_back(CGAL::to_double(knot));
  const Knot_vector<double> rounded(knots.degree(), values);
  std::vector<std::vector<Vector>> columns(s.degree_v() + 1);
  for (int j = 0; j <= s.degree_v(); ++j)
    for (int i = 0; i < knots.number_of_coefficients(); ++i) {
      const auto c = s.coordinates(i, j);
      Vector x(c.dimension());
      for (int l = 0; l < c.dimension(); ++l) x[l] = CGAL::to_double(c[l]);
      columns[j].push_back(std::move(x));
    }
  double sum = 0;
  const std::vector<double> parameters = parameters_along(rounded);
  for (const double u : parameters) {
    std::vector<Vector> points;
    for (const std::vector<Vector>& column : columns) points.push_back(bspline_value(rounded, column, u));
    sum += variation(std::move(points));
  }
  return sum / static_cast<double>(parameters.size());
}

// The sum of the variations of curvature of the curves u = const of a blend of polynomial surfaces,
// as a function of x = (log beta, delta / beta) at both ends, beta in units of that of a given
// shape; its minimum by the method of Levenberg and Marquardt.
template <int M> class Summed_fairness {
  typedef Fair_family<Blend_kind::g2, M> Family;
  typedef Fairness_quadrature<Blend_kind::g2, M, 24> Quadrature;

public:
  typedef typename Family::Unknowns Unknowns;

private:
  static constexpr int unknowns = Family::unknowns, shape_unknowns[2] = {0, Family::End::unknowns};
  static constexpr double most_change = 2.772588722239781; // of log beta: a factor of 16
  static constexpr double longest_step = 0.75, shortest_step = 0.01;
  static constexpr double precision = 1e-3; // relative, of the sum, as far as the expansion tells
  static constexpr int most_iterations = 60;

  std::vector<Family> families_;
  std::vector<Quadrature> quadratures_;

public:
  // Takes the derivatives of both surfaces across their edges at some parameters, one after the
  // other, and the dimension of each.
  Summed_fairness(const Coordinate_jet<double, 0>& start, const Coordinate_jet<double, 0>& end, int dimension,
                  double beta, double eta) {
    double largest = 0;
    for (int i = 0; i < start[0].dimension(); ++i) largest = (std::max)(largest, std::abs(end[0][i] - start[0][i]));
    const double scale = largest > 0 ? std::ldexp(1., -std::ilogb(largest)) : 1;
    for (int first = 0; first < start[0].dimension(); first += dimension) {
      std::array<Coordinate_vector<double, 0>, 5> v; // the chord, T and W at both ends
      v.fill(Coordinate_vector<double, 0>(dimension));
      for (int i = 0; i < dimension; ++i) {
        const int k = first + i;
        v[0][i] = scale * (end[0][k] - start[0][k]);
        v[1][i] = scale * beta * start[1][k];
        v[2][i] = scale * beta * beta * start[2][k];
        v[3][i] = scale * eta * end[1][k];
        v[4][i] = scale * eta * eta * end[2][k];
      }
      const std::array<Coordinate_vector<double, M>, 5> x = in_family(std::move(v));
      families_.push_back({x[0], {{x[1], x[2]}, 1}, {{x[3], x[4]}, -1}});
    }
    quadratures_.reserve(families_.size());
    for (const Family& f : families_) quadratures_.emplace_back(f);
  }

  double value(const Unknowns& x) {
    double sum = 0;
    for (Quadrature& q : quadratures_) sum += q.value(x);
    return sum;
  }

  // Goes down from x. No step leads to where is_folded(x).
  template <class Is_folded> Unknowns minimum(Unknowns x, const Is_folded& is_folded) {
    double here = value(x), damping = 1e-2;
    Fairness_expansion<unknowns> expansion = expand(x);
    for (int i = 0; i < most_iterations && here <= (std::numeric_limits<double>::max)(); ++i) {
      Work_meter::pause();
      const Unknowns next = step(x, expansion, damping);
      double gain = 0; // as the expansion predicts it
      for (int k = 0; k < unknowns; ++k) {
        const double h = next[k] - x[k];
        gain -= 2 * expansion.gradient[k] * h;
        for (int l = 0; l < unknowns; ++l) gain -= h * expansion.matrix[k][l] * (next[l] - x[l]);
      }
      if (!(gain * (1 + damping) > precision * here && gain > 1e-3 * precision * here)) break;
      const double there = value(next);
      if (there < here && !is_folded(next)) {
        const double ratio = (here - there) / gain;
        damping = (std::max)(damping * (ratio > 0.75 ? 0.1 : ratio < 0.25 ? 2 : 0.5), 1e-9);
        x = next;
        here = there;
        expansion = expand(x);
      } else
        damping *= 8;
    }
    return x;
  }

  // Goes on from x where no expansion is known, by the best of all steps that change one number:
  // along the border of where is_folded(x), and for another function than the sum.
  template <class Function, class Is_folded>
  static Unknowns minimum_by_steps(Unknowns x, const Function& value, const Is_folded& is_folded) {
    double here = value(x);
    for (double h = longest_step; h > shortest_step;) {
      Work_meter::pause();
      std::vector<std::pair<double, Unknowns>> steps;
      for (int k = 0; k < unknowns; ++k)
        for (const double sign : {-1., 1.}) {
          const bool is_shape = k == shape_unknowns[0] || k == shape_unknowns[1];
          Unknowns next = x;
          next[k] += sign * h * (is_shape ? 1 : 8);
          if (is_shape && std::abs(next[k]) > most_change) continue;
          if (const double there = value(next); there < (1 - precision) * here) steps.emplace_back(there, next);
        }
      std::sort(steps.begin(), steps.end());
      const auto best =
          std::find_if(steps.begin(), steps.end(), [&](const auto& step) { return !is_folded(step.second); });
      if (best == steps.end())
        h /= 2;
      else
        std::tie(here, x) = *best;
    }
    return x;
  }

private:
  static std::array<Coordinate_vector<double, M>, 5> in_family(std::array<Coordinate_vector<double, 0>, 5> v) {
    if constexpr (M == 3) { // dimension 2, too
      std::array<Coordinate_vector<double, M>, 5> x;
      for (std::size_t j = 0; j < 5; ++j) {
        x[j] = Coordinate_vector<double, M>(M);
        for (int i = 0; i < v[j].dimension(); ++i) x[j][i] = v[j][i];
      }
      return x;
    } else
      return orthonormal_coordinates<M>(std::move(v));
  }

  // Expands at the x of the last call of value().
  Fairness_expansion<unknowns> expand(const Unknowns& x) {
    Fairness_expansion<unknowns> sum{};
    for (Quadrature& q : quadratures_) {
      const Fairness_expansion<unknowns> e = q.expand(x);
      for (int k = 0; k < unknowns; ++k) {
        sum.gradient[k] += e.gradient[k];
        for (int l = 0; l < unknowns; ++l) sum.matrix[k][l] += e.matrix[k][l];
      }
    }
    return sum;
  }

  // The minimum of the expansion with damping, not too far away.
  static Unknowns step(const Unknowns& x, const Fairness_expansion<unknowns>& e, double damping) {
    const Unknowns h = e.step(damping, [&](int k) {
      const bool of_shape = k == shape_unknowns[0] || k == shape_unknowns[1];
      return of_shape && ((x[k] >= most_change && e.gradient[k] < 0) || (x[k] <= -most_change && e.gradient[k] > 0));
    });
    double longest = 0;
    for (int k : shape_unknowns) longest = (std::max)(longest, std::abs(h[k]));
    const double part = longest > longest_step ? longest_step / longest : 1;
    Unknowns next;
    for (int k = 0; k < unknowns; ++k) next[k] = x[k] + part * h[k];
    for (int k : shape_unknowns) next[k] = (std::min)((std::max)(next[k], -most_change), most_change);
    return next;
  }
};

// The least energy, where a strategy that looks for a fair blend starts.
template <class Strategy> struct Unfair { typedef void type; };
template <> struct Unfair<Fair> { typedef Minimal_energy<3> type; };
template <> struct Unfair<Fair_g3> { typedef Minimal_energy_g3<4> type; };
template <> struct Unfair<Fair_f3> { typedef Minimal_energy_g3<4> type; };

// Looks for a shape among those with constants. `Make` returns the blend of a shape.
template <class Kind, class Shape, class Make> class Shape_search {
  typedef std::array<Across_edge, 2> Across;
  struct Candidate {
    Across across;
    Shape shape;
    double fairness;
  };

  // `Fairest` goes down to so many minima, folded or not, and to as many from where is no fold. To
  // find such places, it looks for folds in so many patches.
  static constexpr int descents = 4, most_patches = 1024;

  const std::pair<typename Kind::End, typename Kind::End> ends_;
  const int order_;
  const Both_samples<Kind> samples_; // at the Greville abscissae
  const Make& make_;

public:
  Shape_search(std::pair<typename Kind::End, typename Kind::End> ends, int order, const Make& make)
      : ends_(std::move(ends)), order_(order), samples_(sampled_ends<Kind>(ends_, order)), make_(make) {}

  template <class Strategy> Shape chosen(const Strategy& strategy) const { return shape(across(strategy)); }

  // Returns the shape of a fair strategy, or one between it and that of least energy that has no
  // fold.
  template <class Strategy> Shape unfolded(const Strategy& strategy) const {
    const Across fair = across(strategy);
    const Shape result = shape(fair);
    if (!is_folded(result)) return result;
    const Across start = across(typename Unfair<Strategy>::type());
    for (double t : {0.5, 0.25, 0.125, 0.}) {
      const Shape between = shape(between_both(start, fair, t));
      if (!is_folded(between)) return between;
    }
    return result;
  }

  Shape fairest() const {
    const Protect_FPU_rounding<true> to_nearest(CGAL_FE_TONEAREST);
    return dimension() <= 3 ? fairest_in<3>() : fairest_in<5>();
  }

private:
  // of the space
  int dimension() const { return ends_.first.edge[0].dimension() - (Kind::is_rational ? 1 : 0); }

  template <class Strategy> Across across(const Strategy& strategy) const {
    return chosen_across_edges(strategy, samples_[0].jet, samples_[1].jet);
  }
  Shape shape(const Across& across) const { return shape_across<Kind, Shape>(across, samples_, order_); }

  // A blend that cannot be constructed, or decided within the limit, counts as folded.
  bool is_folded(const Shape& shape) const {
    constexpr int N = dimension_v<typename Kind::Traits>;
    if constexpr (N == 3 || N == 0) {
      if (dimension() != 3) return false;
      try {
        return bool(possible_fold(make_(shape)));
      } catch (const Error& e) {
        if (e.code() != Error_code::work_limit && e.code() != Error_code::zero_weight) throw;
        return true;
      }
    } else
      return false;
  }
  Candidate candidate(const Across& across) const {
    Candidate c{across, shape(across), std::numeric_limits<double>::infinity()};
    try {
      const typename Kind::Surface s = make_(c.shape);
      if constexpr (Kind::is_rational)
        c.fairness = mean_variation<true>(s.homogeneous());
      else
        c.fairness = mean_variation<false>(s);
    } catch (const Error& e) {
      if (e.code() != Error_code::zero_weight) throw;
    }
    return c;
  }

  static Across between_both(const Across& x, const Across& y, double t) {
    Across r;
    for (int e : {0, 1}) {
      r[e][0] = short_double<ratio_digits>(x[e][0] * std::pow(y[e][0] / x[e][0], t));
      for (int k : {1, 2}) r[e][k] = short_part(x[e][k] + t * (y[e][k] - x[e][k]), r[e][0]);
    }
    return r;
  }

  // In dimension M, or less.
  template <int M> Shape fairest_in() const {
    typedef typename Summed_fairness<M>::Unknowns Unknowns;
    const Across unit = across(Minimal_energy<3>());
    const auto &k = ends_.first.knots, &l = ends_.second.knots;
    const auto parameters = parameters_along(k.number_of_spans() < l.number_of_spans() ? l : k);
    const Both_samples<Kind> samples = samples_at<Kind>(ends_, parameters, 2);
    Summed_fairness<M> sum(samples[0].jet, samples[1].jet, dimension(), unit[0][0], unit[1][0]);
    const auto across_at = [&](const Unknowns& x) {
      Across r;
      for (int e : {0, 1}) {
        const double beta = short_double<ratio_digits>(unit[e][0] * std::exp(x[2 * e]));
        r[e] = {beta, short_part(beta * x[2 * e + 1], beta), 0};
      }
      return r;
    };
    const auto unknowns_of = [&](const Across& y) {
      return Unknowns{std::log(y[0][0] / unit[0][0]), y[0][1] / y[0][0], std::log(y[1][0] / unit[1][0]),
                      y[1][1] / y[1][0]};
    };
    const auto nowhere = [](const Unknowns&) { return false; };
    const auto is_folded_at = [&](const Unknowns& x) { return is_folded(shape(across_at(x))); };
    const auto is_fairer = [](const Candidate& x, const Candidate& y) { return x.fairness < y.fairness; };
    // The sum is the mean of rational blends but for their denominators.
    const auto mean_at = [&](const Unknowns& x) {
      return Kind::is_rational ? candidate(across_at(x)).fairness : sum.value(x);
    };

    std::vector<Candidate> found;
    std::vector<std::pair<double, Unknowns>> starts;
    const auto start = [&](const Unknowns& x) { starts.emplace_back(sum.value(x), x); };
    for (const Across& y : {unit, across(Matching_second_derivative()), across(Minimal_energy<2>()), across(Fair())}) {
      found.push_back(candidate(y));
      start(unknowns_of(y));
    }
    const auto start_at_grid = [&](const std::array<double, 4>& shapes, const std::vector<double>& deltas) {
      for (const double beta : shapes)
        for (const double eta : shapes)
          for (const double delta : deltas)
            for (const double zeta : deltas) start({beta, delta, eta, zeta});
      std::sort(starts.begin(), starts.end());
    };
    start_at_grid({-0.5, 0.5, 1.5, 2.5}, {-10, 0, 10});

    // There are several minima where surfaces are steep. The least one seldom has a fold.
    for (int i = 0; i < descents; ++i) found.push_back(candidate(across_at(sum.minimum(starts[i].second, nowhere))));
    std::stable_sort(found.begin(), found.end(), is_fairer);
    if constexpr (Kind::is_rational)
      found.insert(found.begin(),
                   candidate(across_at(sum.minimum_by_steps(unknowns_of(found[0].across), mean_at, nowhere))));
    if (!is_folded(found[0].shape)) return found[0].shape;

    // Otherwise the fairest without a fold may lie where folds begin.
    std::vector<Candidate> unfolded;
    int patches = most_patches;
    const auto look_for_unfolded = [&](std::size_t trials) {
      for (std::size_t i = 0; i < trials && unfolded.size() < descents && patches > 0; ++i) {
        patches -= (std::max)(k.number_of_spans(), l.number_of_spans());
        const Unknowns x = starts[i].second;
        if (is_folded_at(x)) continue;
        const Unknowns near = sum.minimum(x, is_folded_at);
        unfolded.push_back(candidate(across_at(sum.minimum_by_steps(near, mean_at, is_folded_at))));
      }
    };
    look_for_unfolded(64);
    if (unfolded.size() < descents) {
      starts.clear();
      start_at_grid({-1, 0, 1, 2}, {-15, -5, 5, 15});
      look_for_unfolded(starts.size());
    }
    const auto best = std::min_element(unfolded.begin(), unfolded.end(), is_fairer);
    for (const Candidate& x : found) {
      if (best != unfolded.end() && !is_fairer(x, *best)) return best->shape;
      if (!is_folded(x.shape)) return x.shape;
    }
    return best != unfolded.end() ? best->shape : found[0].shape;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_INTERNAL_FAIREST_SHAPE_H
