// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Corner, kink, G1 or G2: exact grades of joins of cubics whose coordinates are integers below
// 2^20, as in letters, against the test with an arc tangent and a tolerance that one writes by
// hand. All answers are compared before anything is timed.

#include "Ratio_table.h"
#include "measure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_2<CGAL::Exact_predicates_inexact_constructions_kernel> Traits;
typedef GC::Bezier_curve<Traits, 3> Cubic;
typedef GC::Bezier_curve<Traits> Curve; // of any degree
typedef Traits::Point Point;
using GC::Visual_class;

Visual_class by_hand(const Cubic& x, const Cubic& y) {
  const auto leg = [](const Cubic& c, int j) { return c.control_point(j) - c.control_point(j - 1); };
  const auto cross = [](const auto& a, const auto& b) { return a.x() * b.y() - a.y() * b.x(); };
  const auto a = leg(x, 3), b = leg(y, 1);
  const double angle = std::atan2(std::abs(cross(a, b)), a * b), degree = std::acos(-1.) / 180;
  if (angle > 5 * degree) return Visual_class::corner;
  if (angle > 1e-9) return Visual_class::kink;
  const double k = cross(leg(x, 2), a) / std::pow(a * a, 1.5), l = cross(b, leg(y, 2)) / std::pow(b * b, 1.5);
  return std::abs(k - l) > 1e-9 * (std::abs(k) + std::abs(l)) ? Visual_class::g1 : Visual_class::g2;
}

struct Joins {
  std::vector<Cubic> left, right;
  std::vector<Curve> left_curves, right_curves; // the same
};

// Joins of one grade; the node anywhere, handles on a primitive direction (x, y) of less than 2^9.
Joins joins(Visual_class grade) {
  Joins result;
  std::mt19937_64 random(2026);
  const auto number = [&](int bits) { return static_cast<double>(random() >> (64 - bits)) - std::ldexp(1, bits - 1); };
  while (result.left.size() < n) {
    const double x = number(9), y = number(9), p = 1 + double(random() % 15), q = 1 + double(random() % 15);
    const Point node(number(19), number(19));
    const auto at = [&](double u, double v) { return Point(node.x() + u, node.y() + v); };
    const double s = number(4), t = number(4), u = number(9), v = number(9);
    const Point corner = at(number(10), number(10));
    const Cubic left({at(number(12), number(12)), at(-2 * p * x + p * p * s + u * x, -2 * p * y + p * p * t + u * y),
                      at(-p * x, -p * y), node});
    const Cubic right({node,
                       grade == Visual_class::corner ? corner
                       : grade == Visual_class::kink ? at(q * x, q * y + 1)
                                                     : at(q * x, q * y),
                       at(2 * q * x + q * q * s + v * x + (grade == Visual_class::g1), 2 * q * y + q * q * t + v * y),
                       at(number(12), number(12))});
    if (GC::visual_class(left, right) != grade) continue;
    check(by_hand(left, right) == grade, "grade by hand");
    check(GC::visual_class(Curve(left), Curve(right)) == grade, "grade of curves of any degree");
    result.left.push_back(left);
    result.right.push_back(right);
    result.left_curves.emplace_back(left);
    result.right_curves.emplace_back(right);
  }
  return result;
}

int main(int argc, char** argv) {
  for (const Visual_class grade : {Visual_class::corner, Visual_class::kink, Visual_class::g1, Visual_class::g2}) {
    const Joins j = joins(grade);
    const auto run = [&](const char* method, auto work) {
      one_by_one((to_string(grade) + " | " + method).c_str(), work);
    };
    run("by hand, double, not certified",
        [j](std::size_t l) { benchmark::DoNotOptimize(by_hand(j.left[l], j.right[l])); });
    run("visual_class, cubics",
        [j](std::size_t l) { benchmark::DoNotOptimize(GC::visual_class(j.left[l], j.right[l])); });
    run("visual_class, curves of any degree",
        [j](std::size_t l) { benchmark::DoNotOptimize(GC::visual_class(j.left_curves[l], j.right_curves[l])); });
    if (grade == Visual_class::kink)
      run("kink_size", [j](std::size_t l) { benchmark::DoNotOptimize(GC::kink_size(j.left[l], j.right[l])); });
  }
  return run_benchmarks(argc, argv);
}
