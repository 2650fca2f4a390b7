// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_JOINED_BEZIER_CURVES_H
#define CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_JOINED_BEZIER_CURVES_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The control points and the knots of a range of Bezier curves, each of which starts exactly where
// the one before it ends; neighbours share a point. The degree is the highest of theirs, and
// `degree` at least; the others are elevated. The pieces keep the lengths of their domains, and
// domains that continue each other are taken over as they are.
// \throws Error `wrong_number_of_points` for an empty range, `dimension_mismatch`,
//   `curves_do_not_meet` when two neighbours do not fit, `empty_domain` when knots become equal by
//   rounding
template <class Traits> struct Joined_bezier_curves {
  typedef typename Traits::FT FT;

  int degree;
  std::vector<typename Traits::Point> points;
  std::vector<FT> knots; // the ends of the domains

  template <class ForwardIterator>
  Joined_bezier_curves(ForwardIterator first, ForwardIterator last, int least_degree, const std::string& place)
      : degree(least_degree) {
    if (first == last) throw Error(Error_code::wrong_number_of_points, place + ": no Bezier curve");
    for (ForwardIterator i = first; i != last; ++i) degree = (std::max)(degree, i->degree());
    knots.push_back(first->domain().first);
    for (; first != last; ++first)
      append(first->elevate(degree - first->degree()), place + ": Bezier curve " + std::to_string(knots.size() - 1));
  }

private:
  void append(const Bezier_curve<Traits>& curve, const std::string& place) {
    if (!points.empty()) {
      const Coordinates<Traits> end = Geometric_continuity::coordinates<Traits>(points.back()),
                                start = curve.coordinates(0);
      if (start.dimension() != end.dimension()) throw Error(Error_code::dimension_mismatch, place);
      if (start != end) throw Error(Error_code::curves_do_not_meet, place);
    }
    const std::pair<FT, FT> domain = curve.domain();
    const FT next = knots.back() == domain.first ? domain.second : FT(knots.back() + (domain.second - domain.first));
    if (!(knots.back() < next)) throw Error(Error_code::empty_domain, place);
    points.insert(points.end(), curve.begin() + (points.empty() ? 0 : 1), curve.end());
    knots.push_back(next);
  }
};

// The curves of the homogeneous points of rational Bezier curves, each multiplied by a factor, so
// that it starts exactly where the one before it ends.
// \throws Error `dimension_mismatch`, `curves_do_not_meet` when two neighbours do not fit
template <class Traits, class ForwardIterator>
std::vector<Bezier_curve<Homogeneous_traits<Traits>>> meeting_homogeneous_curves(ForwardIterator first,
                                                                                 ForwardIterator last) {
  typedef typename Traits::FT FT;
  typedef Bezier_curve<Homogeneous_traits<Traits>> Homogeneous;
  std::vector<Homogeneous> curves;
  for (; first != last; ++first) {
    const Homogeneous c(first->homogeneous());
    if (curves.empty()) {
      curves.push_back(c);
      continue;
    }
    const auto &end = curves.back().control_point(curves.back().degree()), &start = c.control_point(0);
    const int n = start.dimension() - 1;
    if (end.dimension() != n + 1 || affine_point(end) != affine_point(start))
      throw Error(end.dimension() == n + 1 ? Error_code::curves_do_not_meet : Error_code::dimension_mismatch,
                  "Rational_bspline_curve: Bezier curve " + std::to_string(curves.size()));
    const FT factor = FT(end[n] / start[n]);
    // not factor * start, which may be rounded
    std::vector<typename Homogeneous::Point> points{end};
    for (int j = 1; j <= c.degree(); ++j) points.push_back(factor * c.control_point(j));
    curves.emplace_back(points.begin(), points.end(), c.domain().first, c.domain().second);
  }
  return curves;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_CURVES_INTERNAL_JOINED_BEZIER_CURVES_H
