// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Structures of arrays: the same numbers as one by one, exactly with rational numbers, and within rounding with doubles.

#define BOOST_TEST_MODULE batches
#define BOOST_TEST_DYN_LINK

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity.h>
#include <CGAL/Geometric_continuity/blends/blend_batch.h>
#include <CGAL/Geometric_continuity/curves/Jet_polynomials.h>
#include <CGAL/Geometric_continuity/curves/evaluate_batch.h>
#include <CGAL/Geometric_continuity/local/curvature_batch.h>
#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace GC = CGAL::Geometric_continuity;
typedef CGAL::Exact_rational Exact;
template <class FT> using Traits = GC::Traits_3<CGAL::Simple_cartesian<FT>>;
template <class FT> using Point = typename Traits<FT>::Point;

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), GC::Error,                                                                 \
                        [](const GC::Error& e) { return e.code() == GC::Error_code::expected; })

namespace {

std::mt19937 engine(2026);

template <class FT> FT number() { // in [-1, 1]
  const int x = static_cast<int>(engine() % 2001) - 1000;
  return FT(FT(x) / FT(1000));
}
template <class FT> Point<FT> point() {
  const FT x = number<FT>(), y = number<FT>(), z = number<FT>();
  return Point<FT>(x, y, z);
}
template <class FT> std::vector<Point<FT>> points(int n) {
  std::vector<Point<FT>> p;
  for (int i = 0; i < n; ++i) p.push_back(point<FT>());
  return p;
}

// Equal for exact numbers. The doubles of these tests come from sums of a few hundred products of numbers up to `size`.
template <class FT> bool same(const FT& x, const FT& y, double size) {
  if constexpr (std::is_same_v<FT, double>)
    return std::abs(x - y) <= 0x1p-44 * size;
  else
    return x == y;
}

// The same curve with exact numbers.
template <class Curve> GC::Bezier_curve<Traits<Exact>> exact_curve(const Curve& curve) {
  std::vector<Point<Exact>> p;
  for (const auto& x : curve) p.emplace_back(Exact(x.x()), Exact(x.y()), Exact(x.z()));
  return {p.begin(), p.end(), Exact(curve.domain().first), Exact(curve.domain().second)};
}

// The bounds of the errors of jets, in space, for a curve whose numbers are taken as they are.
struct Bounds {
  int m;
  double a, h;
  double points[3], differences[3]; // the largest of each coordinate

  template <class Curve>
  explicit Bounds(const Curve& curve)
      : m(curve.degree()), a(CGAL::to_double(curve.domain().first)),
        h(CGAL::to_double(curve.domain().second) - CGAL::to_double(curve.domain().first)) {
    for (int i = 0; i < 3; ++i) {
      points[i] = differences[i] = 0;
      for (int j = 0; j <= m; ++j) {
        const double x = CGAL::to_double(curve.coordinates(j)[i]);
        points[i] = std::max(points[i], std::abs(x));
        if (j > 0)
          differences[i] = std::max(differences[i], std::abs(x - CGAL::to_double(curve.coordinates(j - 1)[i])));
      }
    }
  }
  double factor(int j) const { // m!/(m-j)! / h^j
    double f = 1;
    for (int l = 0; l < j; ++l) f *= (m - l) / h;
    return f;
  }
  // what Jet_polynomials promises
  double prepared(double u, int j, int i) const {
    const double x = std::max(1.0, std::abs(2 * (u - a) / h - 1));
    return 8 * (m + 1) * std::ldexp(1, m - 53) * factor(j) * (j == 0 ? points[i] : differences[i]) *
           std::pow(x, std::max(m - j, 0));
  }
  // In the domain each level of de Casteljau's algorithm adds an error of at most 5 roundings of the largest point R, a
  // difference of order j multiplies it by 2^j; the parameter is off by 3 roundings, and the derivative of the j-th one is at
  // most 2^(j+1) m R; the factor has at most 3j roundings.
  double single(int j, int i) const { return 16 * (m + 1) * std::ldexp(1, j - 53) * factor(j) * points[i]; }
};

// The jets of order 4, in batches and one by one from the prepared curve.
template <class FT, class Curve, class Prepared> void check_jets(const Curve& curve, const Prepared& prepared) {
  std::vector<FT> parameters{curve.domain().first, curve.domain().second};
  for (int i = 0; i < 35; ++i) parameters.push_back(FT(curve.domain().first + number<FT>()));
  GC::Jet_arrays<FT, 3, 4> jets;
  GC::evaluate<CGAL::Parallel_if_available_tag>(curve, parameters.data(), parameters.size(), jets);
  BOOST_REQUIRE_EQUAL(jets.size(), parameters.size());
  const Bounds bounds(curve);
  const GC::Bezier_curve<Traits<Exact>> exactly = exact_curve(curve);
  for (std::size_t l = 0; l < parameters.size(); ++l) {
    const GC::Curve_jet<Traits<FT>> jet = curve.jet(parameters[l], 4);
    const GC::Curve_jet<Traits<Exact>> exact_jet = exactly.jet(Exact(parameters[l]), 4);
    const GC::Coordinate_jet<FT, 3> one = prepared(parameters[l]);
    for (int j = 0; j <= 4; ++j)
      for (int i = 0; i < 3; ++i) {
        const FT x = jets.jet(l)[j][i];
        if (std::is_same_v<FT, Exact> || curve.degree() > 9) // beyond, evaluate() takes the way of jet()
          BOOST_CHECK_EQUAL(x, jet[j][i]);
        else {
          const double bound = bounds.prepared(CGAL::to_double(parameters[l]), j, i);
          BOOST_CHECK_LE(CGAL::to_double(abs(Exact(Exact(x) - exact_jet[j][i]))), bound);
          BOOST_CHECK_LE(CGAL::to_double(abs(Exact(Exact(one[j][i]) - exact_jet[j][i]))), bound);
        }
        if (std::is_same_v<FT, Exact>) BOOST_CHECK_EQUAL(one[j][i], jet[j][i]);
      }
  }
}

// A curve of a degree known at compile time, the same with its degree forgotten, and prepared.
template <class FT, int degree> void check_fixed_degree(const FT& a, const FT& b) {
  const std::vector<Point<FT>> p = points<FT>(degree + 1);
  const GC::Bezier_curve<Traits<FT>, degree> curve(p.begin(), p.end(), a, b);
  const GC::Bezier_curve<Traits<FT>> dynamic(curve);
  const GC::Jet_polynomials<FT, 3, degree, 4> polynomials(curve);
  check_jets<FT>(curve, [&](const FT& u) { return polynomials.jet(u); });
  check_jets<FT>(dynamic, [&](const FT& u) { return polynomials.jet(u); });

  BOOST_CHECK_EQUAL(curve(a), p[0]); // exactly, also with doubles
  BOOST_CHECK_EQUAL(curve(b), p[degree]);
  BOOST_CHECK_EQUAL(curve.jet(b, 3).point(), p[degree]);
  const Bounds bounds(curve);
  const GC::Bezier_curve<Traits<Exact>> exactly = exact_curve(curve);
  for (int l = 0; l <= 20; ++l) {
    const FT u = FT(a + FT(l) / FT(20) * (b - a));
    BOOST_CHECK(curve.template jet<2>(u) == curve.jet(u, 2));
    BOOST_CHECK(dynamic.template jet<2>(u) == dynamic.jet(u, 2));
    for (int k : {0, 1, 2, 3, 4, 7}) {
      const GC::Curve_jet<Traits<FT>> jet = curve.jet(u, k);
      const GC::Curve_jet<Traits<Exact>> exact_jet = exactly.jet(Exact(u), k);
      BOOST_REQUIRE_EQUAL(jet.order(), k);
      for (int j = 0; j <= k; ++j)
        for (int i = 0; i < 3; ++i) {
          const Exact error = Exact(Exact(jet[j][i]) - exact_jet[j][i]);
          const double bound = std::is_same_v<FT, Exact> ? 0 : bounds.single(j, i);
          BOOST_CHECK_LE(CGAL::to_double(abs(error)), bound);
        }
      if (k == 0) BOOST_CHECK_EQUAL(curve(u), jet.point());
    }
  }
}

template <class FT> void check_grid(int p, int q) {
  std::vector<std::vector<Point<FT>>> net;
  for (int i = 0; i <= p; ++i) net.push_back(points<FT>(q + 1));
  const GC::Bezier_patch<Traits<FT>> patch(net, {FT(-1), FT(1)}, {FT(2), FT(5)});
  std::vector<FT> u, v;
  for (int i = 0; i < 5; ++i) u.push_back(number<FT>());
  for (int i = 0; i < 9; ++i) v.push_back(FT(FT(3) + number<FT>()));
  GC::Surface_grid<FT> grid;
  GC::evaluate_grid<GC::Grid_normals::unnormalised, CGAL::Parallel_if_available_tag>(patch, u, v, grid);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const Point<FT> x = patch(u[i], v[j]);
      const auto normal = patch.normal(u[i], v[j]);
      for (int k = 0; k < 3; ++k) {
        BOOST_CHECK(same(grid.points(k)[i * v.size() + j], x[k], 1));
        BOOST_CHECK(same(grid.normals(k)[i * v.size() + j], normal[k], 8 * (p + 1) * (q + 1)));
      }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(jets) {
  for (int degree : {0, 3, 4, 9, 10, 11}) {
    const auto b = points<double>(degree + 1);
    const GC::Bezier_curve<Traits<double>> rounded(b.begin(), b.end(), 2, 3);
    check_jets<double>(rounded, [&](double u) { return rounded.jet(u, 4); });
    const auto c = points<Exact>(degree + 1);
    const GC::Bezier_curve<Traits<Exact>> exact(c.begin(), c.end(), Exact(1) / 3, 2);
    check_jets<Exact>(exact, [&](const Exact& u) { return exact.jet(u, 4); });
  }
  check_fixed_degree<Exact, 0>(0, 1);
  check_fixed_degree<Exact, 1>(Exact(-1) / 7, 5);
  check_fixed_degree<Exact, 5>(Exact(1) / 3, 2);
  check_fixed_degree<double, 1>(0, 1);
  check_fixed_degree<double, 2>(0.1, 0.7);
  check_fixed_degree<double, 5>(-3, 46); // 49 * (1 / 49) is not 1 in double
  GC::Jet_arrays<double, 2, 1> plane;
  typedef GC::Traits_d<CGAL::Cartesian_d<double>> Any;
  const double x[] = {1, 2, 3};
  const Any::Point p(3, x, x + 3);
  CHECK_ERROR(GC::evaluate(GC::Bezier_curve<Any>{p, p}, x, 3, plane), dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(curvatures) {
  const int n = 600;
  GC::Jet_arrays<double, 3, 3> jets(n);
  std::vector<GC::Curve_jet<Traits<double>>> single;
  for (int l = 0; l < n; ++l) {
    const auto d = points<double>(4);
    const auto vector = [&](int j) { return d[j] - CGAL::ORIGIN; };
    single.push_back({d[0], {vector(1), vector(2), vector(3)}});
    if (l == 7) single.back() = {d[0], {CGAL::NULL_VECTOR, vector(2), vector(3)}}; // no tangent
    if (l == 300) single.back() = {d[0], {vector(1), 2 * vector(1), vector(3)}};   // no curvature
    jets.set(l, single.back());
  }
  std::vector<double> kappa(n, -1), tau(n, -1);
  BOOST_CHECK_EQUAL(GC::curvature_and_torsion<CGAL::Parallel_if_available_tag>(jets, kappa.data(), tau.data()), 2);
  for (int l = 0; l < n; ++l) {
    const auto square = GC::curvature_squared(single[l]);
    const auto torsion = GC::torsion(single[l]);
    BOOST_CHECK_EQUAL(torsion.has_value(), l != 7 && l != 300);
    BOOST_CHECK_CLOSE_FRACTION(kappa[l], square ? std::sqrt(*square) : 0, 1e-9);
    BOOST_CHECK_CLOSE_FRACTION(tau[l], torsion.value_or(0), 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(blends) {
  const int n = 20;
  GC::Jet_arrays<Exact, 3, 2> phi(n), psi(n);
  std::vector<GC::Curve_jet<Traits<Exact>>> left, right;
  for (int l = 0; l < n; ++l)
    for (auto* side : {&left, &right}) {
      const auto d = points<Exact>(3);
      side->push_back({d[0], {d[1] - CGAL::ORIGIN, d[2] - CGAL::ORIGIN}});
      (side == &left ? phi : psi).set(l, side->back());
    }
  GC::Blend_arrays<Exact, 3> gamma;
  const auto check = [&](const auto& strategy) {
    GC::blend<CGAL::Parallel_if_available_tag>(phi, psi, strategy, gamma);
    for (int l = 0; l < n; ++l) {
      const auto single = GC::blend(left[l], right[l], strategy);
      for (int j = 0; j <= 5; ++j)
        for (int i = 0; i < 3; ++i) BOOST_CHECK_EQUAL(gamma.array(j, i)[l], single.control_point(j)[i]);
    }
  };
  check(GC::Minimal_energy<3>());
  check(GC::Matching_second_derivative());
  for (int i = 0; i < 3; ++i) psi.array(1, i)[13] = 0;
  BOOST_CHECK_EXCEPTION(GC::blend(phi, psi, GC::Normal_offset(), gamma), GC::Error, [](const GC::Error& e) {
    return e.code() == GC::Error_code::zero_tangent &&
           std::string(e.what()).find("second curve number 13") != std::string::npos;
  });
  psi.resize(n - 1);
  CHECK_ERROR(GC::blend(phi, psi, GC::Normal_offset(), gamma), wrong_number_of_points);
}

BOOST_AUTO_TEST_CASE(grids) {
  for (int p : {0, 1, 3, 6})
    for (int q : {0, 1, 2, 4, 7}) {
      check_grid<double>(p, q);
      check_grid<Exact>(p, q);
    }
}

BOOST_AUTO_TEST_CASE(unit_normals) {
  // a cone: the normal vanishes at its apex, v = 0
  const GC::Bezier_patch<Traits<double>> cone{{{0, 0, 0}, {1, 0, 1}}, {{0, 0, 0}, {0, 1, 1}}};
  const std::vector<double> u{0, 0.25, 1}, v{0, 0.5, 1};
  GC::Surface_grid<double> grid;
  GC::evaluate_grid(cone, u, v, grid);
  for (std::size_t l = 0; l < 9; ++l) {
    const double x = grid.normals(0)[l], y = grid.normals(1)[l], z = grid.normals(2)[l];
    const double length = std::sqrt(x * x + y * y + z * z);
    if (l % 3 == 0)
      BOOST_CHECK_EQUAL(length, 0);
    else
      BOOST_CHECK_CLOSE_FRACTION(length, 1, 1e-15);
  }
}

BOOST_AUTO_TEST_CASE(spline_grids) {
  const GC::Knot_vector<Exact> knots_u(2, {0, 0, 0, 1, 2, 2, 3, 3, 3}), knots_v(1, {0, 0, 2, 3, 3});
  std::vector<std::vector<Point<Exact>>> net;
  for (int i = 0; i < knots_u.number_of_coefficients(); ++i)
    net.push_back(points<Exact>(knots_v.number_of_coefficients()));
  const GC::Bspline_surface<Traits<Exact>> surface(net, knots_u, knots_v);
  std::vector<Exact> u{0, Exact(1) / 3, 1, Exact(3) / 2, 2, Exact(5) / 2, 3}, v{0, 1, 2, Exact(8) / 3, 3};
  GC::Surface_grid<Exact> grid;
  GC::evaluate_grid<GC::Grid_normals::unnormalised>(surface, u, v, grid);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const auto normal = surface.normal(u[i], v[j]);
      for (int k = 0; k < 3; ++k) {
        BOOST_CHECK_EQUAL(grid.points(k)[i * v.size() + j], surface(u[i], v[j])[k]);
        BOOST_CHECK_EQUAL(grid.normals(k)[i * v.size() + j], normal[k]);
      }
    }
  std::swap(u[1], u[2]);
  CHECK_ERROR(GC::evaluate_grid<GC::Grid_normals::unnormalised>(surface, u, v, grid), wrong_number_of_points);
  u = {0, 4};
  CHECK_ERROR(GC::evaluate_grid<GC::Grid_normals::unnormalised>(surface, u, v, grid), parameter_outside_domain);
}
