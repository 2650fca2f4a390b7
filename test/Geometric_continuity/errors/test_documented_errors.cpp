// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The errors that the reference names for public functions, where no test of a module has them:
// what is refused, and by which code.

#define BOOST_TEST_MODULE documented_errors

#include "support/test.h"

#include <CGAL/Geometric_continuity.h>

typedef GC::Traits_2<CGAL::Simple_cartesian<double>> D2;
typedef GC::Traits_3<CGAL::Simple_cartesian<double>> D3;
typedef GC::Traits_d<CGAL::Cartesian_d<double>> Dd;
typedef D2::Point P2;
typedef D2::Vector V2;
typedef D3::Point P3;
typedef D3::Vector V3;
typedef GC::Bezier_curve<D2> C2;
typedef GC::Bezier_curve<D3> C3;
typedef GC::Bezier_curve<Dd> Cd;

const double inf = std::numeric_limits<double>::infinity(), huge = 1e308;
Dd::Point point(std::initializer_list<double> c) { return Dd::Point(int(c.size()), c.begin(), c.end()); }
Dd::Vector vector(std::initializer_list<double> c) { return Dd::Vector(int(c.size()), c.begin(), c.end()); }
const C2 c2{P2(0, 0), P2(1, 1), P2(2, 1), P2(3, 0)};
const C3 c3{P3(0, 0, 0), P3(1, 1, 0), P3(2, 1, 1), P3(3, 0, 0)};
const Cd d2{point({0, 0}), point({1, 1}), point({2, 1}), point({3, 0})};
const Cd d3{point({3, 0, 0}), point({4, 1, 0}), point({5, 1, 1}), point({6, 0, 0})};

BOOST_AUTO_TEST_CASE(algebra) {
  typedef GC::Basis_matrix<double> Basis;
  const Basis infinite(Basis::Rows{{{{1, 0, 0, inf}}, {{0, 1, 0, 0}}, {{0, 0, 1, 0}}, {{0, 0, 0, 1}}}});
  CHECK_ERROR(GC::blending_functions(infinite), not_finite);
  CHECK_ERROR(GC::change_of_basis(infinite, GC::bezier_matrix<double>()), not_finite);
  typedef GC::Bernstein_polynomial<double> B;
  CHECK_ERROR(GC::is_nonnegative(B{1, inf}), not_finite);
  CHECK_ERROR(GC::is_partition_of_unity(std::vector<B>{B{1, inf}}), not_finite);
  CHECK_ERROR(GC::has_convex_hull_property(std::vector<B>{B{1, inf}}), not_finite);
  CHECK_ERROR(B(std::vector<double>()), wrong_number_of_points);
  typedef GC::Coordinate_vector<double, 3> Triple;
  CHECK_ERROR(Triple(2), dimension_mismatch);
  typedef GC::Coordinate_vector<double, 0> Any;
  CHECK_ERROR(GC::cross_product(Any(3), Any(2)), dimension_mismatch);
  CHECK_ERROR(GC::cross_product(Any(2), Any(3)), dimension_mismatch);
}

// The name of each code is that of the enumeration.
BOOST_AUTO_TEST_CASE(names_of_codes) {
  CHECK_ERROR(throw GC::Error(GC::Error_code::nonpositive_curvature, "f"), nonpositive_curvature);
  BOOST_CHECK_EQUAL(GC::to_string(GC::Error_code::nonpositive_curvature), "nonpositive_curvature");
  BOOST_CHECK_EQUAL(GC::to_string(GC::Error_code::zero_tangent), "zero_tangent");
  BOOST_CHECK_EQUAL(GC::to_string(GC::Error_code::cannot_write_file), "cannot_write_file");
  const int past_the_last = static_cast<int>(GC::Error_code::cannot_write_file) + 1;
  BOOST_CHECK_EQUAL(GC::to_string(static_cast<GC::Error_code>(past_the_last)), "unknown");
}

BOOST_AUTO_TEST_CASE(splines) {
  typedef GC::Knot_vector<double> K;
  const K k(2, std::vector<double>{0, 0, 0, 1, 2, 2, 2}), l(2, std::vector<double>{0, 0, 0, 3, 3, 3}),
      m(2, std::vector<double>{0, 0, 0, 2, 2, 2});
  const std::vector<double> c{1, 2, 3, 4}, e{1, 2, 3};
  CHECK_ERROR(GC::bspline_basis(k, 3.), parameter_outside_domain);
  CHECK_ERROR(GC::bspline_value(k, c, -1.), parameter_outside_domain);
  CHECK_ERROR(GC::bspline_derivatives(k, e, 2, .5, 1), wrong_number_of_points);
  CHECK_ERROR(GC::bspline_derivatives(k, c, 2, .5, -1), negative_count);
  CHECK_ERROR(GC::bspline_refine(k, c, l), parameter_outside_domain);
  CHECK_ERROR(GC::bspline_refine(k, c, m), knot_multiplicity);
  CHECK_ERROR(GC::bspline_insert(k, c, 1., 3), knot_multiplicity);
  CHECK_ERROR(GC::bspline_smoothness(k, c, 0.), parameter_outside_domain);
  CHECK_ERROR(GC::bspline_smoothness(k, e, 1.), wrong_number_of_points);
  CHECK_ERROR(GC::product_knots(k, l), parameter_outside_domain);
  CHECK_ERROR(GC::bspline_product(k, c, l, e), parameter_outside_domain);
  typedef GC::Bspline_function<double> F;
  CHECK_ERROR(F(k, e), wrong_number_of_points);
  CHECK_ERROR(F(k, std::vector<double>{1, 2, 3, inf}), not_finite);
  CHECK_ERROR((F(k, c) + F(l, e)), parameter_outside_domain);
  CHECK_ERROR(K(0, std::vector<double>{0, 1e-300, 1}).reverse(), knot_multiplicity);
  CHECK_ERROR(K(1, std::vector<double>{0, 0, 1e-300, 2e-300, 3e-300, 1, 1}).reverse(), knot_multiplicity);
  typedef GC::Bspline_curve<D2> S;
  const S s(std::vector<P2>{P2(0, 0), P2(1, 1), P2(2, 0), P2(3, 3)}, k);
  CHECK_ERROR(s.multiply(F(l, e)), parameter_outside_domain);
  CHECK_ERROR(s.multiply(F(k, std::vector<double>{huge, huge, huge, huge})), not_finite);
  CHECK_ERROR(GC::product(F(l, e), s), parameter_outside_domain);
  CHECK_ERROR(GC::product(F(k, std::vector<double>{huge, huge, huge, huge}), s), not_finite);
  CHECK_ERROR(s.right_jet(.5, -1), negative_count);
  CHECK_ERROR(s.span_end_jets(-1), negative_count);
  CHECK_ERROR(s.left_jet_over<Q>(7., 1), parameter_outside_domain);
  CHECK_ERROR(s.left_jet_over<Q>(1., -1), negative_count);
  const std::vector<GC::Coordinate_vector<double, 0>> mixed{
      GC::Coordinate_vector<double, 0>(2), GC::Coordinate_vector<double, 0>(2), GC::Coordinate_vector<double, 0>(3),
      GC::Coordinate_vector<double, 0>(2)};
  typedef GC::Bspline_function<double, GC::Coordinate_vector<double, 0>> Fd;
  CHECK_ERROR(Fd(k, mixed), dimension_mismatch);
  const K twice(1, std::vector<double>{0, 0, 1, 1, 2, 2});
  for (int span : {0, 2, 4, 9}) CHECK_ERROR(GC::bspline_derivatives(twice, c, span, .5, 1), parameter_outside_domain);
}

BOOST_AUTO_TEST_CASE(curves) {
  CHECK_ERROR((C2(std::vector<P2>{P2(0, 0), P2(1, 1)}, 1, 1)), empty_domain);
  CHECK_ERROR(GC::taylor_polynomial_at_end(c2, -1), negative_count);
  CHECK_ERROR(GC::taylor_polynomial_at_end(C2{P2(huge, 0), P2(-huge, 1), P2(huge, 1)}, 2), not_finite);
  const std::vector<C2> one{c2};
  const GC::Composite_bezier_curve<D2> s(one.begin(), one.end());
  CHECK_ERROR(s.right_jet(0.5, -1), negative_count);
  CHECK_ERROR(s.segment_before(7.), parameter_outside_domain);
  const std::vector<Cd> dd{d2, d3};
  CHECK_ERROR((GC::Composite_bezier_curve<Dd>(dd.begin(), dd.end())), dimension_mismatch);
  typedef GC::Cubic_blended_curve<Dd, GC::Bezier_basis> Bd;
  CHECK_ERROR(Bd({point({0, 0}), point({1, 1}), point({2, 1}), point({3, 0, 1})}), dimension_mismatch);
  typedef GC::Cubic_blended_curve<D2, GC::Bezier_basis> B2;
  CHECK_ERROR(B2(c2).bezier(1, 1), empty_domain);
  const std::vector<Dd::Point> mixed{point({0, 0}), point({1, 1}), point({2, 1}), point({3, 0, 1})};
  CHECK_ERROR(GC::piecewise_cubic<Dd>(mixed, GC::Catmull_rom_basis()), dimension_mismatch);
  CHECK_ERROR(
      GC::piecewise_cubic<D2>(std::vector<P2>{P2(0, 0), P2(inf, 1), P2(2, 1), P2(3, 0)}, GC::Catmull_rom_basis()),
      not_finite);
  CHECK_ERROR(GC::piecewise_hermite<Dd>(
                  mixed, std::vector<Dd::Vector>{vector({1, 1}), vector({1, 1}), vector({1, 1}), vector({1, 1})}),
              dimension_mismatch);
  CHECK_ERROR(GC::piecewise_hermite<D2>(std::vector<P2>{P2(0, 0), P2(inf, 1)}, std::vector<V2>{V2(1, 1), V2(1, 0)}),
              not_finite);
  typedef GC::Rational_bezier_curve<D2> R;
  typedef GC::Rational_bezier_curve<Dd> Rd;
  typedef GC::Rational_bspline_curve<D2> N;
  const std::vector<P2> p{P2(0, 0), P2(1, 1), P2(2, 0)};
  const std::vector<P2> far{P2(-huge, 0), P2(huge, 0)};
  const std::vector<double> w{1, 1, 1};
  CHECK_ERROR(R(p, std::vector<double>{1, 1}), wrong_number_of_points);
  typedef GC::Rational_bezier_curve<D2, 2> R2;
  CHECK_ERROR(R2(p, std::vector<double>{1, 1, 1, 1}), wrong_number_of_points);
  typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Exact;
  const std::vector<Exact::Point> exact{Exact::Point(0, 0), Exact::Point(1, 1), Exact::Point(2, 0)};
  // zero at 1/3
  const GC::Rational_bezier_curve<Exact> almost(exact, std::vector<Q>{Q(1), Q(Q(-2) + Q(1e-60)), Q(4)});
  CHECK_ERROR(almost.positive_parts(), work_limit);
  CHECK_ERROR(almost.bounding_box(), work_limit);
  const std::vector<Rd> of_two{Rd(std::vector<Dd::Point>{point({0, 0}), point({1, 1}), point({2, 0})}, w),
                               Rd(std::vector<Dd::Point>{point({2, 0, 0}), point({1, 1, 1}), point({2, 0, 0})}, w)};
  CHECK_ERROR((GC::Rational_bspline_curve<Dd>(of_two.begin(), of_two.end())), dimension_mismatch);
  CHECK_ERROR(GC::circular_arc(P3(0, 0, 0), P3(1, 0, 0), V3(0, 0, 1), 0.), empty_domain);
  typedef GC::Jet_polynomials<double, 3, 3, 2> Polynomials;
  CHECK_ERROR(Polynomials(GC::Bezier_curve<Dd, 3>(d2.begin(), d2.end())), dimension_mismatch);
  const std::vector<P2> zeros(3, P2(0, 0));
  CHECK_ERROR(GC::fit(zeros, 0.1), wrong_number_of_points);
  CHECK_ERROR(GC::fit(zeros, 0.1, GC::Closure::closed), wrong_number_of_points);
  CHECK_ERROR(R(p, std::vector<double>{1, 0, 0}), zero_weight);
  CHECK_ERROR(R(p, std::vector<double>{1, -9, 1}), zero_weight);
  CHECK_ERROR(R(p, w, 2, 1), empty_domain);
  CHECK_ERROR(R(p, std::vector<double>{1, inf, 1}), not_finite);
  CHECK_ERROR(R(std::vector<P2>{P2(0, 0), P2(1, inf), P2(2, 0)}, w), not_finite);
  CHECK_ERROR(R(p, w, -huge, huge), not_finite);
  CHECK_ERROR(Rd(std::vector<Dd::Point>{point({0, 0}), point({1, 1}), point({2, 0, 0})}, w), dimension_mismatch);
  const GC::Knot_vector<double> k(2, std::vector<double>{0, 0, 0, 1, 1, 1});
  CHECK_ERROR(N(p, std::vector<double>{1, 1}, k), wrong_number_of_points);
  CHECK_ERROR(N(std::vector<P2>{P2(0, 0), P2(1, 1)}, std::vector<double>{1, 1}, k), wrong_number_of_points);
  CHECK_ERROR(N(p, std::vector<double>{1, -9, 1}, k), zero_weight);
  CHECK_ERROR(N(p, std::vector<double>{1, inf, 1}, k), not_finite);
  const std::vector<R> apart{R(p, w), R(p, w)}, none;
  CHECK_ERROR(N(apart.begin(), apart.end()), curves_do_not_meet);
  CHECK_ERROR(N(none.begin(), none.end()), wrong_number_of_points);
  CHECK_ERROR(R(p, std::vector<double>{3, 2, 1}).jet(1.5, 1), zero_weight);
  CHECK_ERROR(N(p, w, k).span_end_jets(-1), negative_count);
  CHECK_ERROR(N(p, w, k).jet(.5, -1), negative_count);
  CHECK_ERROR(GC::circular_arc(P2(0, 0), P2(1, 0), inf), not_finite);
  CHECK_ERROR(GC::circular_arc_through(P2(0, 0), P2(1, inf), P2(2, 0)), not_finite);
  CHECK_ERROR(GC::circular_arc_through<Dd>(point({0, 0}), point({1, 1}), point({1, 0, 0})), dimension_mismatch);
  CHECK_ERROR(GC::circular_arc_with_tangent(P2(0, 0), V2(1, inf), P2(2, 0)), not_finite);
  CHECK_ERROR(GC::circular_arc_with_tangent<Dd>(point({0, 0}), vector({1, 1}), point({1, 0, 0})), dimension_mismatch);
  CHECK_ERROR(GC::conic_arc(P2(0, 0), V2(1, inf), P2(2, 0), V2(1, -1), P2(1, 0.1)), not_finite);
  CHECK_ERROR(GC::conic_arc<Dd>(point({0, 0}), vector({1, 1}), point({2, 0, 0}), vector({1, -1}), point({1, 0.1})),
              dimension_mismatch);
  CHECK_ERROR(GC::ellipse(P2(0, 0), V2(1, inf), V2(0, 1)), not_finite);
  CHECK_ERROR(GC::ellipse<Dd>(point({0, 0}), vector({1, 1, 1}), vector({0, 1})), dimension_mismatch);
  CHECK_ERROR(GC::elliptical_arc(P2(0, 0), V2(1, inf), V2(0, 1), 1), not_finite);
  CHECK_ERROR(GC::elliptical_arc<Dd>(point({0, 0}), vector({1, 1, 1}), vector({0, 1}), 1), dimension_mismatch);
  CHECK_ERROR(GC::convex_hull_weights(d2, point({1, 1, 1})), dimension_mismatch);
  CHECK_ERROR(GC::convex_hull_weights(c2, P2(1, inf)), not_finite);
  CHECK_ERROR(GC::count_crossings(c2, P2(1, inf), V2(0, 1)), not_finite);
  CHECK_ERROR(GC::count_crossings(c2, P2(1, 1), V2(0, inf)), not_finite);
  CHECK_ERROR(GC::end_invariants(C2{P2(huge, huge), P2(-huge, 0), P2(0, huge)}), not_finite);
  CHECK_ERROR(GC::curvature_extrema(C2{P2(0, 0), P2(1, 1), P2(0, 1), P2(1, 0)}), zero_tangent);
  CHECK_ERROR(GC::curvature_extrema(C2{P2(0, 0), P2(0, 0)}), zero_tangent);
  CHECK_ERROR(GC::curvature_extrema(C2{P2(0, 0), P2(1e-320, 0), P2(1, 1)}), not_finite);
  CHECK_ERROR(GC::interpolation_parameters<Dd>(mixed.begin(), mixed.end(), GC::Parametrisation::chordal),
              dimension_mismatch);
  CHECK_ERROR(GC::interpolation_parameters<D2>(far.begin(), far.end(), GC::Parametrisation::chordal), not_finite);
  std::vector<P2> out;
  const GC::Knot_vector<double> jump(1, std::vector<double>{0, 0, 1, 1, 2, 2});
  CHECK_ERROR(GC::chord_polyline(GC::Bspline_curve<D2>(std::vector<P2>{P2(0, 0), P2(1, 1), P2(2, 0), P2(3, 3)}, jump),
                                 0.1, std::back_inserter(out)),
              curves_do_not_meet);
}

BOOST_AUTO_TEST_CASE(local) {
  typedef GC::Curve_jet<D2> J;
  typedef GC::Curve_jet<Dd> Jd;
  CHECK_ERROR(Jd(2, -1), negative_count);
  CHECK_ERROR(Jd(-1, 2), negative_count);
  CHECK_ERROR(J(3, 2), dimension_mismatch);
  typedef GC::Curve_end_jets<Dd> Ed;
  CHECK_ERROR(Ed(d2.start_jet(2), d3.end_jet(2)), dimension_mismatch);
  CHECK_ERROR(Ed(d2.start_jet(2), d2.end_jet(1)), jet_order_too_low);
  CHECK_ERROR(Ed(d2, -1), negative_count);
  typedef GC::Coordinate_jet<double, 0> Empty;
  CHECK_ERROR(Ed(Empty(), Empty()), jet_order_too_low);
  CHECK_ERROR(GC::lift(Empty(), std::vector<double>{1}), jet_order_too_low);
  CHECK_ERROR(Ed(d2, 2).end_jet_over<Q>(3), jet_order_too_low);
  CHECK_ERROR(Ed(d2, 2).end_jet_over<Q>(-1), negative_count);
  CHECK_ERROR(GC::signed_curvature(J(P2(0, 0), {V2(1e-200, 0), V2(0, 1e200)})), not_finite);
  CHECK_ERROR(GC::frenet_matrix(GC::Curve_jet<D2>(P2(0, 0), {V2(1e-200, 0), V2(0, 1e200)})), not_finite);
  CHECK_ERROR(GC::frenet_frame_derivatives(GC::Curve_jet<D2>(P2(0, 0), {V2(1e-200, 0), V2(0, 1e200)})), not_finite);
  CHECK_ERROR(GC::project(GC::Coordinate_jet<double, 3>()), jet_order_too_low);
  CHECK_ERROR((*GC::frenet_matrix(c2.start_jet(2)))(std::vector<GC::Coordinate_vector<double, 0>>{
                  GC::Coordinate_vector<double, 0>(3), GC::Coordinate_vector<double, 0>(3)}),
              dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(joins) {
  CHECK_ERROR(GC::deviation(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::order_within(d2, d3, GC::Join_tolerance{}), dimension_mismatch);
  CHECK_ERROR(GC::is_c_join<1>(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::is_g1_join(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::is_g2_join(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::is_g3_join(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::is_f3_join(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::has_equal_curvature_vector(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::has_equal_torsion(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::continuity(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::continuity(GC::Curve_jet<D2>(), GC::Curve_jet<D2>(), 1), jet_order_too_low);
  const GC::Coordinate_jet<Q, 0> in_plane(2, 3), in_space(3, 3);
  CHECK_ERROR(GC::join_certificate(in_plane, in_space, GC::Join_continuity<Q>(), 3), dimension_mismatch);
  CHECK_ERROR(GC::is_curvature_continuous(c2, C2{P2(3, 0), P2(4, -1)}), wrong_number_of_points);
  CHECK_ERROR(GC::is_torsion_continuous(c3, C3{P3(3, 0, 0), P3(4, -1, 0)}), wrong_number_of_points);
  CHECK_ERROR(GC::Corner_threshold(-1), parameter_outside_domain);
  CHECK_ERROR(GC::Corner_threshold(180), parameter_outside_domain);
  CHECK_ERROR(GC::Corner_threshold(inf), not_finite);
  const std::vector<C2> chain{c2, C2{P2(3, 0), P2(4, -1), P2(5, -1), P2(6, 0)}};
  CHECK_ERROR(GC::chain_continuity(chain, -1), negative_count);
  CHECK_ERROR(GC::chain_joins(chain, -1), negative_count);
  const GC::Composite_bezier_curve<D2> s(chain.begin(), chain.end());
  const GC::Bspline_curve<D2> n(chain.begin(), chain.end());
  CHECK_ERROR(GC::chain_continuity(s, -1), negative_count);
  CHECK_ERROR(GC::knot_continuities(n, -1), negative_count);
  CHECK_ERROR(GC::knot_continuity(n, n.knots()[4], -1), negative_count);
  CHECK_ERROR(GC::order_within(chain[0], chain[1], GC::Join_tolerance{})(-1), negative_count);
  CHECK_ERROR(GC::order_within(chain[0], chain[1], GC::Join_tolerance{})(4), jet_order_too_low);
}

BOOST_AUTO_TEST_CASE(extensions) {
  CHECK_ERROR(GC::midpoint_construction<Dd>(point({0, 0}), point({1, 1}), point({2, 1, 1})), dimension_mismatch);
  const auto a = GC::curvature_alternatives(d3, 1.);
  CHECK_ERROR(a.parameter_of(point({1, 1})), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(surfaces) {
  typedef GC::Bezier_patch<Dd> Sd;
  typedef GC::Bezier_patch<D3> S3;
  const std::vector<Dd::Point> p2{point({0, 0}), point({0, 1}), point({1, 0}), point({1, 1})};
  const Sd s(1, 1, p2),
      t(1, 1, std::vector<Dd::Point>{point({0, 0, 0}), point({0, 1, 0}), point({1, 0, 0}), point({1, 1, 0})});
  typedef GC::Patch_edge E;
  CHECK_ERROR(GC::edge_rows(s, E::u0), dimension_mismatch);
  CHECK_ERROR(GC::edge_rows_over<Q>(s, E::u0), dimension_mismatch);
  CHECK_ERROR(GC::spline_edge_rows(s, E::u0), dimension_mismatch);
  CHECK_ERROR(GC::nearer_direction(s, E::u0, t, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::common_edges(s, s), dimension_mismatch);
  CHECK_ERROR(GC::is_g0_edge(s, E::u0, s, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::is_g1_edge(s, E::u0, s, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::is_g2_edge(s, E::u0, s, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::is_g3_edge(s, E::u0, s, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::deviation(s, E::u0, s, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::order_within(s, E::u0, s, E::u1, GC::Edge_tolerance{}), dimension_mismatch);
  CHECK_ERROR(GC::possible_fold(s), dimension_mismatch);
  CHECK_ERROR(GC::blend(s, E::u0, t, E::u1), dimension_mismatch);
  CHECK_ERROR(GC::parallelogram<Dd>(point({0, 0}), vector({1, 0, 0}), vector({0, 1})), dimension_mismatch);
  CHECK_ERROR(GC::parallelogram<Dd>(point({0, 0}), vector({1, 0}), vector({0, 1, 0})), dimension_mismatch);
  typedef GC::Rational_bezier_curve<Dd> Profile;
  CHECK_ERROR(
      GC::bezier_patch(GC::Extrusion_surface_3<Profile>(
          Profile(std::vector<Dd::Point>{point({0, 0}), point({1, 1})}, std::vector<double>{1, 2}), vector({0, 0, 1}))),
      dimension_mismatch);
  CHECK_ERROR(GC::parallelogram(P3(0, 0, 0), V3(1, inf, 0), V3(0, 1, 0)), not_finite);
  CHECK_ERROR(GC::cylinder<Dd>(point({0, 0, 0}), vector({1, 0, 0}), vector({0, 1, 0}), vector({0, 0})),
              dimension_mismatch);
  CHECK_ERROR(GC::cylinder(P3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), V3(0, 0, inf)), not_finite);
  CHECK_ERROR(GC::cone<Dd>(point({0, 0, 0}), vector({1, 0, 0}), vector({0, 1, 0}), vector({0, 0}), 1),
              dimension_mismatch);
  CHECK_ERROR(GC::cone(P3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), V3(0, 0, inf), 1), not_finite);
  CHECK_ERROR(GC::ellipsoid<Dd>(point({0, 0, 0}), vector({1, 0, 0}), vector({0, 1, 0}), vector({0, 0})),
              dimension_mismatch);
  CHECK_ERROR(GC::ellipsoid(P3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), V3(0, 0, inf)), not_finite);
  CHECK_ERROR(GC::torus<Dd>(point({0, 0, 0}), vector({1, 0, 0}), vector({0, 1, 0}), vector({0, 0}), 1),
              dimension_mismatch);
  CHECK_ERROR(GC::torus(P3(0, 0, 0), V3(1, 0, 0), V3(0, 1, 0), V3(0, 0, inf), 1), not_finite);
  CHECK_ERROR(GC::full_revolution(d2, point({0, 0, 0}), vector({0, 0, 1})), dimension_mismatch);
  CHECK_ERROR(GC::full_revolution(c3, P3(0, 0, 0), V3(0, 0, inf)), not_finite);
  const std::vector<P3> q{P3(0, 0, 0), P3(0, 1, 0), P3(1, 0, 0), P3(1, 1, 0)};
  const S3 flat(1, 1, q);
  CHECK_ERROR((GC::Rational_bezier_patch<D3>({{q[0], q[1]}, {q[2], q[3]}}, {{1, 1}, {1}})), wrong_number_of_points);
  CHECK_ERROR((GC::set_back_parameter(flat, E::u0, inf)), parameter_outside_domain);
  CHECK_ERROR((GC::set_back_parameter(flat, E::u0, std::nan(""))), parameter_outside_domain);
  CHECK_ERROR(GC::round_edge(s, E::u0, s, E::u0, .1, .1), dimension_mismatch);
  GC::Surface_grid<double> grid;
  CHECK_ERROR(GC::evaluate_grid(s, std::vector<double>{0, 1}, std::vector<double>{0, 1}, grid), dimension_mismatch);
  typedef GC::Edge_function<double> F;
  CHECK_ERROR(F(std::initializer_list<double>{}), wrong_number_of_points);
  CHECK_ERROR(F({1, inf}), not_finite);
  CHECK_ERROR((F({1, 2})(2)), parameter_outside_domain);
  typedef GC::Extrusion_surface_3<C3> X;
  typedef GC::Revolution_surface_3<C3> V;
  CHECK_ERROR((X(c3, V3(0, 0, huge))(0, huge)), not_finite);
  CHECK_ERROR((V(c3, P3(0, 0, 0), V3(0, 0, 1))(0, huge)), not_finite);
  CHECK_ERROR(GC::extrusion_continuity(c3, C3{P3(3, 0, 0), P3(4, 0, 0)}, V3(0, 0, inf)), not_finite);
  CHECK_ERROR(GC::revolution_continuity(d2, d2, point({0, 0}), vector({0, 1})), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(blends) {
  CHECK_ERROR(GC::representable_blend(d2, d3), dimension_mismatch);
  CHECK_ERROR(GC::automatic_shape(c2.end_jet(0), c2.start_jet(1)), jet_order_too_low);
  CHECK_ERROR(GC::automatic_shape(c2.end_jet(1), c2.start_jet(0)), jet_order_too_low);
  GC::Jet_arrays<double, 2, 2> jets;
  GC::Blend_arrays<double, 2> blends;
  for (const GC::Shape_parameters<double>& shape :
       {GC::Shape_parameters<double>{-1, 1}, GC::Shape_parameters<double>{1, 0}})
    CHECK_ERROR(GC::blend(jets, jets, GC::Matching_second_derivative(), shape, blends), nonpositive_beta);
  CHECK_ERROR(GC::representable_blend(C2{P2(0, 0)}, c2), wrong_number_of_points);
}
