// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "arrays.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/joins/deviation.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef GC::Traits_2<Kernel> Plane;
typedef GC::Traits_3<Kernel> Space;
typedef Array_traits<Exact> Exact_traits;
static_assert(std::is_same_v<GC::Predicate_FT<Plane>, Exact>);

// Calls f with both curves over the traits class by which their join is decided.
template <class Function>
auto with_curves(const Numbers& left, const Numbers& right, const std::string& place, Function f) {
  const auto are_in = [&](std::size_t dimension) {
    return left.are_doubles() && right.are_doubles() && left.shape.size() == 2 && right.shape.size() == 2 &&
           left.shape[1] == dimension && right.shape[1] == dimension;
  };
  if (are_in(2)) return f(curve<Plane>(left, place), curve<Plane>(right, place));
  if (are_in(3)) return f(curve<Space>(left, place), curve<Space>(right, place));
  return f(curve<Exact_traits>(left, place), curve<Exact_traits>(right, place));
}

// Calls the function in the plane only.
template <class Function>
auto with_plane_curves(const Numbers& left, const Numbers& right, const std::string& place, Function f) {
  typedef GC::Traits_2<CGAL::Simple_cartesian<Exact>> Exact_plane;
  if (left.are_doubles() && right.are_doubles()) return f(curve<Plane>(left, place), curve<Plane>(right, place));
  return f(curve<Exact_plane>(left, place), curve<Exact_plane>(right, place));
}

// A Bezier curve of doubles where they are. What is known of their steps makes them faster to find.
template <class Traits_, int Degree, bool packed> class Array_curve {
  const Curves_view* view_;
  std::ptrdiff_t index_;

public:
  typedef Traits_ Traits;
  static constexpr int N = GC::dimension_v<Traits>;

  Array_curve(const Curves_view& view, std::ptrdiff_t index) : view_(&view), index_(index) {}

  int degree() const { return Degree == GC::dynamic_degree ? view_->degree : Degree; }
  int dimension() const { return N; }
  std::pair<double, double> domain() const { return {0., 1.}; }
  typename Traits::Point control_point(int j) const {
    const std::ptrdiff_t point_step = packed ? N : view_->point_step, step = packed ? 1 : view_->coordinate_step,
                         curve_step = packed && Degree != GC::dynamic_degree ? N * (Degree + 1) : view_->curve_step;
    const double* const x = view_->first + index_ * curve_step + j * point_step;
    if constexpr (N == 2)
      return {x[0], x[step]};
    else
      return {x[0], x[step], x[2 * step]};
  }
};

} // namespace

template <class Traits, int Degree, bool packed>
struct CGAL::Geometric_continuity::Curve_ends<Array_curve<Traits, Degree, packed>>
    : CGAL::Geometric_continuity::Bezier_ends<Array_curve<Traits, Degree, packed>> {};

namespace {

// The questions, by their names.
template <class Function> void with_question(const std::string& order, Function f) {
  if (order == "C0" || order == "G0" || order == "F0") return f(GC::is_c_join<0>);
  if (order == "C1") return f(GC::is_c_join<1>);
  if (order == "C2") return f(GC::is_c_join<2>);
  if (order == "C3") return f(GC::is_c_join<3>);
  if (order == "G1" || order == "F1") return f(GC::is_g1_join);
  if (order == "G2" || order == "F2") return f(GC::is_g2_join);
  if (order == "G3") return f(GC::is_g3_join);
  if (order == "F3") return f(GC::is_f3_join);
  throw GC::Error(GC::Error_code::parameter_outside_domain,
                  "failing_joins: the order '" + order + "' is none of C0 to C3, G0 to G3, F0 to F3");
}

// The exponent of a double plus one: it overflows into the highest bit for what is infinite or
// undefined, and for nothing else.
std::uint64_t increased_exponent(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return (bits & std::uint64_t(0x7ff) << 52) + (std::uint64_t(1) << 52);
}
bool has_overflown(std::uint64_t exponent) { return exponent >> 63 != 0; }

// Refuses an infinite or undefined coordinate of the curves [begin, end).
void check_finite(const Curves_view& view, std::size_t begin, std::size_t end) {
  const std::ptrdiff_t points = view.degree + 1, d = view.dimension;
  std::uint64_t exponents = 0;
  if (view.is_packed()) {
    const double* const first = view.first + static_cast<std::ptrdiff_t>(begin) * view.curve_step;
    const std::size_t n = (end - begin) * static_cast<std::size_t>(points * d);
    // without a branch, in vectors
    for (std::size_t i = 0; i < n; ++i) exponents |= increased_exponent(first[i]);
    if (!has_overflown(exponents)) return;
  }
  for (std::size_t c = begin; c < end; ++c)
    for (std::ptrdiff_t j = 0; j < points; ++j)
      for (std::ptrdiff_t i = 0; i < d; ++i)
        if (has_overflown(increased_exponent(view.first[static_cast<std::ptrdiff_t>(c) * view.curve_step +
                                                        j * view.point_step + i * view.coordinate_step])))
          throw GC::Error(GC::Error_code::not_finite, "failing_joins: curve " + std::to_string(c));
}

// n Bezier curves of any dimension in an array of shape (n, degree + 1, dimension), as objects of
// their own.
GC::Bezier_curve<Exact_traits> exact_curve(const Numbers& x, std::ptrdiff_t index) {
  const std::size_t d = x.shape[2], size = x.shape[1] * d;
  std::vector<Exact_traits::Point> points;
  for (std::size_t j = 0; j < x.shape[1]; ++j) {
    GC::Coordinates<Exact_traits> c(static_cast<int>(d));
    for (std::size_t i = 0; i < d; ++i)
      c[static_cast<int>(i)] = number<Exact>(x, static_cast<std::size_t>(index) * size + j * d + i);
    points.push_back(GC::to_point<Exact_traits>(c));
  }
  return GC::Bezier_curve<Exact_traits>(points);
}

// The failing joins of n curves: check(begin, end) refuses bad ones, get(i) is the curve number i.
template <class Concurrency_tag, class Check, class Get, class Question>
void find_failing(std::size_t n, const Check& check, const Get& get, const Question& holds, bool closed,
                  const std::function<void()>& pause, std::vector<std::ptrdiff_t>& failing) {
  if (n == 0) return;
  const auto join_holds = [&](std::ptrdiff_t i, std::ptrdiff_t j) { return bool(holds(get(i), get(j))); };
  const boost::counting_iterator<std::ptrdiff_t> first(0);
  const std::size_t part = std::is_convertible_v<Concurrency_tag, CGAL::Parallel_tag> ? 1 << 18 : 1 << 13,
                    parts_between_pauses = (std::size_t(1) << 18) / part, last = n - 1;
  std::size_t parts = 0;
  check(0, 1);
  for (std::size_t begin = 0; begin < last; begin += part) {
    const std::size_t end = (std::min)(last, begin + part);
    check(begin + 1, end + 1);
    for (std::size_t i : GC::failing_joins<Concurrency_tag>(first + static_cast<std::ptrdiff_t>(begin),
                                                            first + static_cast<std::ptrdiff_t>(end + 1), join_holds))
      failing.push_back(static_cast<std::ptrdiff_t>(begin + i));
    if (++parts % parts_between_pauses == 0) pause();
  }
  if (closed && !join_holds(static_cast<std::ptrdiff_t>(last), 0)) failing.push_back(static_cast<std::ptrdiff_t>(last));
}

} // namespace

GC::Join_continuity<Exact> continuity(const Numbers& left, const Numbers& right, std::optional<int> max_order) {
  return with_curves(left, right, "continuity", [&](const auto& a, const auto& b) {
    return max_order ? GC::continuity(a, b, *max_order) : GC::continuity(a, b);
  });
}

GC::Join_deviation deviation(const Numbers& left, const Numbers& right) {
  return with_curves(left, right, "deviation", [](const auto& a, const auto& b) { return GC::deviation(a, b); });
}

GC::Order_within order_within(const Numbers& left, const Numbers& right, const GC::Join_tolerance& tolerance) {
  return with_curves(left, right, "order_within",
                     [&](const auto& a, const auto& b) { return GC::order_within(a, b, tolerance); });
}

GC::Verdict is_c_within(const Numbers& left, const Numbers& right, int order, const GC::Join_tolerance& tolerance) {
  return with_curves(left, right, "failing_joins",
                     [&](const auto& a, const auto& b) { return GC::is_c_within(a, b, order, tolerance); });
}

std::optional<GC::Visual_class> visual_class(const Numbers& left, const Numbers& right, const Exact& kink_angle) {
  const GC::Corner_threshold bound{kink_angle};
  return with_plane_curves(left, right, "visual_class",
                           [&](const auto& a, const auto& b) { return GC::visual_class(a, b, bound); });
}

std::optional<GC::Kink_size> kink_size(const Numbers& left, const Numbers& right) {
  return with_plane_curves(left, right, "kink_size", [](const auto& a, const auto& b) { return GC::kink_size(a, b); });
}

std::vector<std::ptrdiff_t> failing_joins(const Curves_view& curves, const std::string& order, bool closed,
                                          bool parallel, const std::function<void()>& pause) {
  std::vector<std::ptrdiff_t> failing;
  const auto check = [&](std::size_t begin, std::size_t end) { check_finite(curves, begin, end); };
  with_question(order, [&](const auto& holds) {
    const auto find = [&](const auto& get) {
      if (parallel)
        find_failing<CGAL::Parallel_if_available_tag>(curves.number, check, get, holds, closed, pause, failing);
      else
        find_failing<CGAL::Sequential_tag>(curves.number, check, get, holds, closed, pause, failing);
    };
    const auto in_place = [&](auto traits, auto degree) {
      typedef decltype(traits) Traits;
      constexpr int m = decltype(degree)::value;
      if (m != GC::dynamic_degree && curves.is_packed())
        find([&](std::ptrdiff_t i) { return Array_curve<Traits, m, true>(curves, i); });
      else
        find([&](std::ptrdiff_t i) { return Array_curve<Traits, m, false>(curves, i); });
    };
    typedef std::integral_constant<int, 3> Cubic;
    typedef std::integral_constant<int, GC::dynamic_degree> Any;
    if (curves.dimension == 2)
      curves.degree == 3 ? in_place(Plane(), Cubic()) : in_place(Plane(), Any());
    else
      curves.degree == 3 ? in_place(Space(), Cubic()) : in_place(Space(), Any());
  });
  return failing;
}

std::vector<std::ptrdiff_t> failing_joins(const Numbers& curves, const std::string& order, bool closed,
                                          const std::function<void()>& pause) {
  std::vector<std::ptrdiff_t> failing;
  with_question(order, [&](const auto& holds) {
    find_failing<CGAL::Sequential_tag>(
        curves.shape[0], [](std::size_t, std::size_t) {}, [&](std::ptrdiff_t i) { return exact_curve(curves, i); },
        holds, closed, pause, failing);
  });
  return failing;
}
