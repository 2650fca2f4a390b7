// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_PYTHON_GEOMETRY_H
#define GEOMETRIC_CONTINUITY_PYTHON_GEOMETRY_H

#include <CGAL/Geometric_continuity/joins/Corner_threshold.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The module calls these functions of the package. They take arrays, return arrays and records, and
// do not depend on Python. All of them may run without the lock of the interpreter. Where all
// numbers are doubles, decisions are those of `Exact_predicates_inexact_constructions_kernel`.

namespace GC = CGAL::Geometric_continuity;

typedef GC::Exact_field<double>::type Exact;

// Numbers of any shape, the last index runs fastest: all as doubles where that loses nothing,
// otherwise all exact.
struct Numbers {
  std::vector<std::size_t> shape;
  std::vector<double> doubles;
  std::vector<Exact> exact; // empty where the doubles are all there is to know
  bool rounded = false;     // whether a floating-point number is among what was given

  bool are_doubles() const { return exact.empty(); }
  std::size_t size() const { return exact.empty() ? doubles.size() : exact.size(); }
};

// A curve over its knots: a row of `points` for each control point. With `exact`, its numbers are
// those of `points.exact`.
struct Curve_numbers {
  int degree = 0;
  Numbers points, knots;
};

// The nearest double, in a tie the even one.
double nearest_double(const Exact& x);

// How a curve is constructed: on doubles, or exactly.
enum class Field_of_results { doubles, exact };

GC::Join_continuity<Exact> continuity(const Numbers& left, const Numbers& right, std::optional<int> max_order);
GC::Join_deviation deviation(const Numbers& left, const Numbers& right);
GC::Order_within order_within(const Numbers& left, const Numbers& right, const GC::Join_tolerance& tolerance);
GC::Verdict is_c_within(const Numbers& left, const Numbers& right, int order, const GC::Join_tolerance& tolerance);
std::optional<GC::Visual_class> visual_class(const Numbers& left, const Numbers& right, const Exact& kink_angle);
std::optional<GC::Kink_size> kink_size(const Numbers& left, const Numbers& right);

// n Bezier curves of one degree in the plane or in space, in the memory of somebody else; the steps
// between curves, points and coordinates in doubles.
struct Curves_view {
  const double* first;
  std::size_t number;
  int degree, dimension;
  std::ptrdiff_t curve_step, point_step, coordinate_step;

  // Returns whether all numbers follow each other.
  bool is_packed() const {
    return coordinate_step == 1 && point_step == dimension && curve_step == (degree + 1) * point_step;
  }
};

// The joins of consecutive curves, or if closed also that of the last one with the first, that do
// not have the order, e.g. "G2". Between parts that take some milliseconds it calls `pause`, whose
// exceptions it passes on.
std::vector<std::ptrdiff_t> failing_joins(const Curves_view& curves, const std::string& order, bool closed,
                                          bool parallel, const std::function<void()>& pause);

// Takes an array of shape (n, degree + 1, dimension), in any dimension.
std::vector<std::ptrdiff_t> failing_joins(const Numbers& curves, const std::string& order, bool closed,
                                          const std::function<void()>& pause);

// Returns the strategies of blends: those of degree 5, those of degree 7, and free.
std::vector<std::string> strategy_names();

struct Blend_numbers {
  Numbers points; // of the blend
  Exact beta, eta;
  bool fallback_start = false, fallback_end = false;
  std::optional<std::array<double, 2>> fairness; // at first, and of what was found
  bool converged = true;
};
Blend_numbers blend(const Numbers& left, const Numbers& right, const std::string& strategy,
                    const std::optional<Exact>& beta, const std::optional<Exact>& eta, const Numbers& parameters,
                    Field_of_results field);

struct Representable_numbers {
  Numbers phi, gamma, psi;
  double moved;
};
Representable_numbers representable_blend(const Numbers& left, const Numbers& right, const std::string& strategy);

// Three clothoids, a row x, y, heading, curvatures, length for each; and the gaps, kinks and jumps
// of the four joins.
struct Clothoid_numbers {
  Numbers segments;
  std::vector<GC::Enclosure> gaps, kinks, jumps;
};
Clothoid_numbers clothoid_blend(const Numbers& start, const Numbers& end);

struct Corner_numbers {
  Numbers left, blend, knots, right; // knots of cubics
  Exact left_cut, right_cut;
};
// By a distance, or by that of a circle with a radius.
Corner_numbers round_corner(const Numbers& left, const Numbers& right, double size, bool is_radius,
                            const std::string& strategy, Field_of_results field);

double fairness(const Numbers& curve);

// The place where the curvature of a Bezier curve exceeds a bound, with these weights, or none, and
// with these two ends of its domain.
struct Excess_numbers {
  GC::Enclosure parameter, curvature;
  bool unbounded;
};
std::optional<Excess_numbers> curvature_excess(const Numbers& points, const Numbers& weights, const Numbers& domain,
                                               const Exact& bound);

Curve_numbers interpolate(const Numbers& points, bool closed, const std::string& parametrisation,
                          const Numbers& parameters, Field_of_results field);

struct Fair_spline_numbers : Curve_numbers {
  Exact moved;
  std::vector<int> rounded;
};
Fair_spline_numbers interpolate_fair(const Numbers& points, bool closed, Field_of_results field);

struct Fitted_numbers : Curve_numbers {
  std::vector<int> vertices, corners;
  double distance;
};
Fitted_numbers fit(const Numbers& points, const Exact& tolerance, int order, bool closed, double corner_angle,
                   Field_of_results field);

struct Edge_record {
  int g_order;
  std::string defect, text;
  bool reversed, coplanar, collapsed, normal_vanishes, whole_a, whole_b;
  std::optional<double> largest_angle; // radians, an upper bound
};
Edge_record edge_continuity(const Numbers& a, const std::string& edge_a, const Numbers& b, const std::string& edge_b);
// Along the edge that they have in common; where both are one object, along two of its edges.
Edge_record edge_continuity(const Numbers& a, const Numbers& b);

// The second surface, matched to the first one along edges, exactly.
struct Matched_numbers {
  Numbers points;
  std::pair<std::string, std::string> edges;
  std::vector<std::pair<std::string, Exact>> shape; // names and numbers, those up to the order
  Edge_record before;
  bool has_order; // along the whole edge, which is proved
};
// `shape` has the names of what is given; all else is the nearest, also the edges without names.
Matched_numbers match(const Numbers& a, const std::string& edge_a, const Numbers& b, const std::string& edge_b,
                      int order, const std::vector<std::pair<std::string, Exact>>& shape);

#endif // GEOMETRIC_CONTINUITY_PYTHON_GEOMETRY_H
