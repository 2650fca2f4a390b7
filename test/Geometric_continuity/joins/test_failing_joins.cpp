// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Many joins at once: the same answers as one by one, on one core and on several.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <deque>

BOOST_AUTO_TEST_SUITE(failing_joins)

typedef std::vector<std::size_t> Indices;
template <class FT> using Traits = GC::Traits_2<CGAL::Simple_cartesian<FT>>;
template <class FT> using Curve = GC::Bezier_curve<Traits<FT>, 2>;

// Pieces of the parabola y = x^2, in thirds if the numbers allow it; those in `bent` have their
// middle point moved, so that they have no common tangent with their neighbours.
template <class FT> std::vector<Curve<FT>> parabola(int n, const std::set<int>& bent) {
  typedef typename Traits<FT>::Point Point;
  const FT unit = std::is_same_v<FT, double> ? FT(1) : FT(FT(1) / FT(3));
  std::vector<Curve<FT>> curves;
  for (int i = 0; i < n; ++i) {
    const FT x(i), y(i + 1), half(FT(2 * i + 1) / FT(2)), middle(x * y + FT(bent.count(i) ? 1 : 0));
    curves.push_back({Point(x * unit, x * x * unit), Point(half * unit, middle * unit), Point(y * unit, y * y * unit)});
  }
  return curves;
}

template <class Tag, class FT> void check_chain(int n, const std::set<int>& bent) {
  std::set<std::size_t> expected;
  for (const int i : bent) {
    if (i > 0) expected.insert(i - 1);
    if (i + 1 < n) expected.insert(i);
  }
  const Indices truth(expected.begin(), expected.end());
  const std::vector<Curve<FT>> curves = parabola<FT>(n, bent);
  BOOST_CHECK(GC::failing_joins<Tag>(curves.begin(), curves.end(), GC::is_g2_join) == truth);
  Indices one_by_one;
  for (int i = 0; i + 1 < n; ++i)
    if (!GC::is_g2_join(curves[i], curves[i + 1])) one_by_one.push_back(i);
  BOOST_CHECK(one_by_one == truth);
  if (n > 0) // the chain as pairs
    BOOST_CHECK(GC::failing_joins<Tag>(curves.begin(), curves.end() - 1, curves.begin() + 1, curves.end(),
                                       GC::is_g2_join) == truth);
}

template <class Tag, class FT> void check_chains(int n) {
  check_chain<Tag, FT>(0, {});
  check_chain<Tag, FT>(1, {0});
  check_chain<Tag, FT>(2, {});
  check_chain<Tag, FT>(2, {1});
  check_chain<Tag, FT>(n, {});
  check_chain<Tag, FT>(n, {0, n - 1});
  std::set<int> all, some;
  std::mt19937 engine(2026);
  for (int i = 0; i < n; ++i) {
    all.insert(i);
    if (engine() % 50 == 0) some.insert(i);
  }
  check_chain<Tag, FT>(n, some);
  // a bent piece between two bent pieces: a join that fails on both sides
  check_chain<Tag, FT>(n, all);
}

// enough for several blocks
BOOST_AUTO_TEST_CASE(doubles_sequential) { check_chains<CGAL::Sequential_tag, double>(10000); }
BOOST_AUTO_TEST_CASE(doubles_parallel) { check_chains<CGAL::Parallel_if_available_tag, double>(10000); }
BOOST_AUTO_TEST_CASE(rational_numbers) { check_chains<CGAL::Parallel_if_available_tag, CGAL::Exact_rational>(2500); }

// Left and right curves in two other kinds of containers.
BOOST_AUTO_TEST_CASE(pairs_of_curves) {
  const std::vector<Curve<double>> curves = parabola<double>(3000, {1, 1500, 2998});
  const std::vector<Curve<double>> left(curves.begin(), curves.end() - 1);
  const std::deque<Curve<double>> right(curves.begin() + 1, curves.end());
  const Indices truth = {0, 1, 1499, 1500, 2997, 2998};
  BOOST_CHECK(GC::failing_joins(left.begin(), left.end(), right.begin(), right.end(), GC::is_g2_join) == truth);
  BOOST_CHECK(GC::failing_joins<CGAL::Parallel_if_available_tag>(left.begin(), left.end(), right.begin(), right.end(),
                                                                 GC::is_g2_join) == truth);
}

BOOST_AUTO_TEST_CASE(numbers_of_curves_differ) {
  const std::vector<Curve<double>> curves = parabola<double>(5, {});
  CHECK_ERROR(GC::failing_joins(curves.begin(), curves.end(), curves.begin(), curves.end() - 1, GC::is_g2_join),
              wrong_number_of_points);
  CHECK_ERROR(GC::failing_joins(curves.begin(), curves.begin(), curves.begin(), curves.end(), GC::is_g2_join),
              wrong_number_of_points);
}

// An exception of a predicate reaches the caller, also from another thread.
template <class Tag> void check_exception() {
  const std::vector<int> numbers(5000, 1);
  const auto throws = [](int, int) -> bool { throw std::domain_error("join"); };
  BOOST_CHECK_THROW((void)GC::failing_joins<Tag>(numbers.begin(), numbers.end(), throws), std::domain_error);
}
BOOST_AUTO_TEST_CASE(exceptions) {
  check_exception<CGAL::Sequential_tag>();
  check_exception<CGAL::Parallel_if_available_tag>();
}

// The limit of the work on each object holds for all threads that take part.
template <class Tag> void check_limit() {
  const std::vector<int> numbers(1000000, 1);
  const GC::Work_scope each(GC::Work_limit(7));
  const auto has_limit = [](int, int) { return GC::Work_scope::limit_of_each().steps() == 7; };
  BOOST_CHECK_EQUAL(GC::failing_joins<Tag>(numbers.begin(), numbers.end(), has_limit).size(), 0u);
}
BOOST_AUTO_TEST_CASE(limits_of_work) {
  check_limit<CGAL::Sequential_tag>();
  check_limit<CGAL::Parallel_if_available_tag>();
  BOOST_CHECK_EQUAL(GC::Work_scope::limit_of_each().steps(), GC::Work_limit::default_steps);
}

BOOST_AUTO_TEST_SUITE_END()
