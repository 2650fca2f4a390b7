// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Extrema of curvature and inflections: of curves where they are known, and of random ones, where
// dense sampling finds them.

#include "support/test.h"

#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/curves/fairness.h>

BOOST_AUTO_TEST_SUITE(curvature_extrema)

typedef std::tuple<Exact_2, Epeck_2, Epick_2, Double_2, Exact_d, Double_d> Planar_traits;
typedef std::tuple<Exact_3, Epeck_3, Double_3, Exact_d, Double_d> Space_traits;
typedef std::vector<std::vector<double>> Rows;

constexpr unsigned seed = 2026;

template <class Traits> std::vector<typename Traits::Point> points(const Rows& rows) {
  std::vector<typename Traits::Point> p;
  for (const std::vector<double>& row : rows) {
    GC::Coordinates<Traits> x(static_cast<int>(row.size()));
    for (int i = 0; i < x.dimension(); ++i) x[i] = typename Traits::FT(row[i]);
    p.push_back(GC::to_point<Traits>(x));
  }
  return p;
}
template <class Traits> GC::Bezier_curve<Traits> bezier(const Rows& rows, double a = 0, double b = 1) {
  const std::vector<typename Traits::Point> p = points<Traits>(rows);
  return GC::Bezier_curve<Traits>(p.begin(), p.end(), typename Traits::FT(a), typename Traits::FT(b));
}
template <class Traits> GC::Curvature_extrema measured(const Rows& rows, double a = 0, double b = 1) {
  return GC::curvature_extrema(bezier<Traits>(rows, a, b));
}

bool holds(const GC::Enclosure& e, double x, double width = 1e-9) {
  return e.lower <= x && x <= e.upper && e.upper - e.lower <= width * (1 + std::abs(x));
}

// Every coordinate of a row multiplied by a number, and moved.
Rows mapped(Rows rows, double factor, double shift) {
  for (std::vector<double>& row : rows)
    for (double& x : row) x = factor * x + shift;
  return rows;
}
Rows mirrored(Rows rows) {
  for (std::vector<double>& row : rows) row[1] = -row[1];
  return rows;
}
Rows reversed(const Rows& rows) { return Rows(rows.rbegin(), rows.rend()); }
Rows in_space(Rows rows, int dimension) {
  for (std::vector<double>& row : rows) row.resize(dimension, 0.25);
  return rows;
}

const Rows parabola = {{-1, 1}, {0, -1}, {1, 1}};       // y = x^2
const Rows s_curve = {{0, 0}, {1, 2}, {2, -2}, {3, 0}}; // turns right, then left
const Rows two_inflections = {{-3, 2}, {4, -1}, {2, -2}, {2, 4}};
// nearly a quarter of a circle
const Rows quarter = {{1, 0}, {1, 0.55078125}, {0.55078125, 1}, {0, 1}};
const Rows undulation = {{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {1, 1}};   // y = x^4
const Rows flat_s = {{-5, -1}, {-3, 1}, {-1, -1}, {1, 1}, {3, -1}, {5, 1}}; // y = (x/5)^5

// Counts by dense sampling how often the curvature of a planar curve turns, and how often it
// changes its sign.
std::array<int, 2> sampled(const Rows& rows) {
  const GC::Bezier_curve<Double_d> curve = bezier<Double_d>(rows);
  constexpr int n = 4000;
  int turns = 0, changes = 0;
  double last = 0, direction = 0;
  for (int i = 0; i <= n; ++i) {
    const GC::Curve_jet<Double_d> jet = curve.jet(i / static_cast<double>(n), 2);
    double kappa;
    if (rows.front().size() == 2) {
      const GC::Signed_square<double> k = *GC::signed_curvature(jet);
      kappa = k.sign * std::sqrt(k.square);
    } else
      kappa = std::sqrt(*GC::curvature_squared(jet));
    if (i > 0) {
      if (kappa * last < 0) ++changes;
      if ((kappa - last) * direction < 0) ++turns;
      direction = kappa - last;
    }
    last = kappa;
  }
  return {turns, changes};
}

Rows random_rows(std::mt19937& engine, int degree, int dimension, int spread) {
  Rows rows;
  for (int i = 0; i <= degree; ++i) {
    rows.emplace_back();
    for (int k = 0; k < dimension; ++k)
      rows.back().push_back((static_cast<int>(engine() % 2001) - 1000) / 1024. + (k == 0 ? spread * i : 0));
  }
  return rows;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_parabola_has_one_extremum, Traits, Planar_traits) {
  const GC::Curvature_extrema c = measured<Traits>(parabola, 3, 5);
  BOOST_REQUIRE_EQUAL(c.extrema.size(), 1u);
  BOOST_CHECK(c.size() == 1 && &*c.begin() == &c.extrema[0] && c.end() - c.begin() == 1);
  BOOST_CHECK(c.extrema[0].maximum);
  BOOST_CHECK((c.extrema[0].parameter == GC::Enclosure{4, 4}) && (c.extrema[0].curvature == GC::Enclosure{2, 2}));
  BOOST_CHECK(c.inflections.empty());
  BOOST_CHECK((c.greatest.curvature == GC::Enclosure{2, 2}) && holds(c.least.curvature, 2 / std::pow(5, 1.5), 1e-15));
  BOOST_CHECK((c.least.parameter == GC::Enclosure{3, 3}) && (c.largest() == GC::Enclosure{2, 2}));
  const GC::Curvature_extrema d = measured<Traits>(mirrored(parabola));
  BOOST_REQUIRE_EQUAL(d.extrema.size(), 1u);
  BOOST_CHECK(!d.extrema[0].maximum && (d.extrema[0].curvature == GC::Enclosure{-2, -2}));
  BOOST_CHECK((d.least.curvature == GC::Enclosure{-2, -2}) && (d.largest() == GC::Enclosure{2, 2}));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_s_has_one_inflection, Traits, Planar_traits) {
  const GC::Curvature_extrema c = measured<Traits>(s_curve);
  BOOST_REQUIRE_EQUAL(c.inflections.size(), 1u);
  BOOST_CHECK((c.inflections[0] == GC::Enclosure{0.5, 0.5}));
  BOOST_REQUIRE_EQUAL(c.extrema.size(), 2u);
  BOOST_CHECK(!c.extrema[0].maximum && c.extrema[1].maximum);
  BOOST_CHECK(c.extrema[0].curvature.lower == -c.extrema[1].curvature.upper);
}

BOOST_AUTO_TEST_CASE(the_cube_of_x) {
  const Q third = Q(Q(1) / Q(3));
  typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Traits;
  const std::vector<Traits::Point> p = {Traits::Point(-1, -1), Traits::Point(-third, 1), Traits::Point(third, -1),
                                        Traits::Point(1, 1)};
  const GC::Curvature_extrema c = GC::curvature_extrema(GC::Bezier_curve<Traits>(p.begin(), p.end(), Q(-1), Q(1)));
  const double x = std::pow(45, -0.25), kappa = 6 * x / std::pow(1.2, 1.5);
  BOOST_REQUIRE_EQUAL(c.extrema.size(), 2u);
  BOOST_CHECK(holds(c.extrema[0].parameter, -x) && holds(c.extrema[1].parameter, x));
  BOOST_CHECK(holds(c.extrema[0].curvature, -kappa) && holds(c.extrema[1].curvature, kappa));
  BOOST_CHECK(c.inflections.size() == 1 && (c.inflections[0] == GC::Enclosure{0, 0}));
  BOOST_CHECK(text(c).find("2 extrema of curvature, 1 inflection, curvature from [-1.7") == 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(other_planar_curves, Traits, Planar_traits) {
  // an undulation is the minimum of the curvature and no inflection
  const GC::Curvature_extrema u = measured<Traits>({{-1, 1}, {-0.5, -1}, {0, 1}, {0.5, -1}, {1, 1}});
  BOOST_CHECK_EQUAL(u.inflections.size(), 0u); // (2t - 1)^4
  BOOST_REQUIRE_EQUAL(u.extrema.size(), 3u);
  BOOST_CHECK(!u.extrema[1].maximum && (u.extrema[1].curvature == GC::Enclosure{0, 0}) &&
              (u.extrema[1].parameter == GC::Enclosure{0.5, 0.5}));
  // the slope of the curvature has a double zero at the inflection, and does not change its sign
  const GC::Curvature_extrema f = measured<Traits>(flat_s);
  BOOST_CHECK(f.inflections.size() == 1 && (f.inflections[0] == GC::Enclosure{0.5, 0.5}));
  BOOST_CHECK_EQUAL(f.extrema.size(), 2u);
  // at an end of the domain nothing is counted
  BOOST_CHECK_EQUAL(measured<Traits>(undulation).inflections.size(), 0u);
  BOOST_CHECK_EQUAL(measured<Traits>(undulation).extrema.size(), 1u);
  BOOST_CHECK((measured<Traits>(undulation).least.curvature == GC::Enclosure{0, 0}));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(lines_and_cusps, Traits, Planar_traits) {
  const GC::Curvature_extrema c = measured<Traits>({{0, 0}, {1, 1}, {4, 4}});
  BOOST_CHECK(c.extrema.empty() && c.inflections.empty());
  BOOST_CHECK((c.greatest.curvature == GC::Enclosure{0, 0}) && (c.least.curvature == GC::Enclosure{0, 0}));
  BOOST_CHECK((measured<Traits>({{0, 0}, {1, 1}}).largest() == GC::Enclosure{0, 0}));
  CHECK_ERROR(measured<Traits>({{0, 0}, {1, 1}, {0, 1}, {1, 0}}), zero_tangent);
  CHECK_ERROR(measured<Traits>({{0, 0}, {0, 0}, {0, 1}, {1, 0}}), zero_tangent);
  CHECK_ERROR(measured<Traits>({{0, 0}, {1, 0}, {0, 0}}), zero_tangent); // there and back
  CHECK_ERROR(measured<Traits>({{1, 1}, {1, 1}}), zero_tangent);
  CHECK_ERROR(measured<Traits>({{1, 1}}), zero_tangent);
}

// A planar curve has the same inflections in any space; there they are minima of the curvature.
BOOST_AUTO_TEST_CASE_TEMPLATE(planar_curves_in_space, Traits, Space_traits) {
  const GC::Curvature_extrema c = measured<Traits>(in_space(s_curve, 3));
  BOOST_REQUIRE_EQUAL(c.inflections.size(), 1u);
  BOOST_CHECK((c.inflections[0] == GC::Enclosure{0.5, 0.5}));
  BOOST_REQUIRE_EQUAL(c.extrema.size(), 3u);
  BOOST_CHECK(c.extrema[0].maximum && !c.extrema[1].maximum && c.extrema[2].maximum);
  BOOST_CHECK((c.extrema[1].parameter == GC::Enclosure{0.5, 0.5}) && (c.least.curvature == GC::Enclosure{0, 0}));
  const GC::Curvature_extrema f = measured<Traits>(in_space(flat_s, 3));
  BOOST_CHECK(f.inflections.size() == 1 && f.extrema.size() == 3);
  const GC::Curvature_extrema u = measured<Traits>(in_space({{-1, 1}, {-0.5, -1}, {0, 1}, {0.5, -1}, {1, 1}}, 3));
  BOOST_CHECK(u.inflections.empty() && u.extrema.size() == 3);
  BOOST_CHECK(measured<Traits>({{0, 0, 0}, {1, 1, 1}, {4, 4, 4}}).extrema.empty());
}

BOOST_AUTO_TEST_CASE(random_curves_against_samples) {
  std::mt19937 engine(seed);
  BOOST_TEST_MESSAGE("seed " << seed);
  for (int dimension : {2, 3, 4})
    for (int degree = 2; degree <= (dimension == 2 ? 7 : 5); ++degree)
      for (int run = 0; run < 6; ++run) {
        const Rows rows = random_rows(engine, degree, dimension, 1);
        const GC::Curvature_extrema c = measured<Double_d>(rows);
        const std::array<int, 2> s = sampled(rows);
        BOOST_TEST_CONTEXT("dimension " << dimension << ", degree " << degree << ", run " << run) {
          BOOST_CHECK_EQUAL(c.extrema.size(), static_cast<std::size_t>(s[0]));
          BOOST_CHECK_EQUAL(c.inflections.size(), static_cast<std::size_t>(s[1]));
        }
        for (std::size_t i = 1; i < c.extrema.size(); ++i) {
          BOOST_CHECK(c.extrema[i].maximum != c.extrema[i - 1].maximum);
          BOOST_CHECK(c.extrema[i - 1].parameter.upper < c.extrema[i].parameter.lower);
        }
      }
}

BOOST_AUTO_TEST_CASE(similar_and_reversed_curves) {
  std::mt19937 engine(seed + 1);
  for (int run = 0; run < 12; ++run) {
    const int dimension = 2 + run % 2;
    const Rows rows = random_rows(engine, 3 + run % 3, dimension, 1);
    const GC::Curvature_extrema c = measured<Exact_d>(rows), scaled = measured<Exact_d>(mapped(rows, 4, 3), 2, 10),
                                back = measured<Exact_d>(reversed(rows)), mirror = measured<Exact_d>(mirrored(rows));
    const std::size_t n = c.extrema.size();
    BOOST_REQUIRE(scaled.extrema.size() == n && back.extrema.size() == n && mirror.extrema.size() == n);
    BOOST_CHECK(scaled.inflections.size() == c.inflections.size() && back.inflections.size() == c.inflections.size());
    for (std::size_t i = 0; i < n; ++i) {
      BOOST_CHECK(scaled.extrema[i].maximum == c.extrema[i].maximum);
      BOOST_CHECK(holds(scaled.extrema[i].curvature, c.extrema[i].curvature.lower / 4, 1e-8) ||
                  std::abs(4 * scaled.extrema[i].curvature.lower - c.extrema[i].curvature.lower) <
                      1e-8 * std::abs(c.extrema[i].curvature.lower));
      const bool turned = dimension == 2; // then the curvature changes its sign
      BOOST_CHECK(back.extrema[n - 1 - i].maximum == (c.extrema[i].maximum != turned));
      BOOST_CHECK(mirror.extrema[i].maximum == (c.extrema[i].maximum != turned));
    }
  }
}

// The counts of a curve are those of its pieces, with what is at the knots.
TEST_FOR_EACH(pieces, Traits, Planar_traits) {
  typedef GC::Bezier_curve<Traits> Bezier;
  const auto of = [](const std::vector<Bezier>& curves) {
    return GC::curvature_extrema(GC::Composite_bezier_curve<Traits>(curves.begin(), curves.end()));
  };
  for (const Rows& rows : {parabola, s_curve, quarter, Rows{{0, 0}, {1, 3}, {3, -2}, {4, 4}, {6, 0}, {7, 1}}}) {
    const Bezier whole = bezier<Traits>(rows);
    const GC::Curvature_extrema c = GC::curvature_extrema(whole);
    for (double u : {0.25, 0.5, 0.625}) { // 1/2 is an extremum or an inflection of the first three
      const auto parts = whole.split(FT(u));
      const GC::Curvature_extrema d = of({parts.first, parts.second});
      BOOST_CHECK_EQUAL(d.extrema.size(), c.extrema.size());
      BOOST_CHECK_EQUAL(d.inflections.size(), c.inflections.size());
    }
  }
  // a parabola, a straight line, and a parabola that bends the other way: curvature falls to 2,
  // jumps to 0, and so on
  const Bezier left = bezier<Traits>({{-2, 0}, {-1, 0}, {-0, 2}}), line = bezier<Traits>({{0, 2}, {1, 4}}, 1, 2),
               right = bezier<Traits>({{1, 4}, {2, 6}, {3, 6}}, 2, 3);
  const GC::Curvature_extrema bent = of({left, line, right});
  BOOST_REQUIRE_EQUAL(bent.inflections.size(), 1u);
  BOOST_CHECK((bent.inflections[0] == GC::Enclosure{1, 1}));
  // rises, falls along the first parabola, jumps down to 0, jumps down, falls and rises
  BOOST_CHECK_EQUAL(bent.extrema.size(),
                    GC::curvature_extrema(left).extrema.size() + GC::curvature_extrema(right).extrema.size());
  // two parabolas that bend to the same side with a line between: a minimum, the line
  const Bezier same = bezier<Traits>({{1, 4}, {2, 6}, {2, 8}}, 2, 3);
  const GC::Curvature_extrema plateau = of({left, line, same});
  BOOST_CHECK(plateau.inflections.empty());
  BOOST_REQUIRE(plateau.extrema.size() >= 1);
  bool found = false;
  for (const GC::Curvature_extremum& e : plateau.extrema)
    found = found || (!e.maximum && e.curvature == GC::Enclosure{0, 0} && e.parameter == GC::Enclosure{1, 1});
  BOOST_CHECK(found);
}

// With floating-point numbers the Bezier pieces of a B-spline curve would be rounded; it is decided
// as it is given.
TEST_FOR_EACH(splines, Traits, Planar_traits) {
  const std::vector<typename Traits::Point> p =
      points<Traits>({{0, 0}, {0.1, 1}, {1.3, 1.7}, {2, -1}, {3, 0.3}, {4, 0}});
  std::vector<FT> knots;
  for (double u : {0., 0., 0., 0., 0.1, 0.7, 1., 1., 1., 1.}) knots.push_back(FT(u));
  const GC::Bspline_curve<Traits> curve(p.begin(), p.end(), GC::Knot_vector<FT>(3, knots));
  const GC::Curvature_extrema c = GC::curvature_extrema(curve), back = GC::curvature_extrema(curve.reverse());
  std::size_t inner = 0;
  for (const GC::Bezier_curve<Traits>& piece : curve.bezier_pieces())
    inner += GC::curvature_extrema(piece).extrema.size();
  // the curvature is continuous
  BOOST_CHECK(inner <= c.extrema.size() && c.extrema.size() <= inner + 2);
  BOOST_CHECK_EQUAL(back.inflections.size(), c.inflections.size());
  BOOST_CHECK_EQUAL(back.extrema.size(), c.extrema.size());
}

BOOST_AUTO_TEST_CASE(pieces_in_space) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<Q>> Traits;
  const GC::Bezier_curve<Traits> whole = bezier<Traits>(in_space(s_curve, 3));
  const auto parts = whole.split(Q(Q(1) / Q(2)));
  const std::vector<GC::Bezier_curve<Traits>> curves = {parts.first, parts.second};
  const GC::Curvature_extrema c =
      GC::curvature_extrema(GC::Composite_bezier_curve<Traits>(curves.begin(), curves.end()));
  BOOST_CHECK(c.inflections.size() == 1 && (c.inflections[0] == GC::Enclosure{0.5, 0.5}));
  BOOST_CHECK(c.extrema.size() == 3);
  // where the plane turns by more than a right angle there is none
  const Rows next = {{3, 0, 0.25}, {4, 2, 0.25}, {5, 2, 1}};
  const std::vector<GC::Bezier_curve<Traits>> turned = {whole, bezier<Traits>(next, 1, 2)};
  BOOST_CHECK_EQUAL(
      GC::curvature_extrema(GC::Composite_bezier_curve<Traits>(turned.begin(), turned.end())).inflections.size(), 1u);
}

// Extrema at 1/3, which is no binary fraction, where the speed or the curvature is nearly zero:
// they have bounds all the same.
BOOST_AUTO_TEST_CASE(extrema_that_are_hard_to_enclose) {
  typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Traits;
  // the Bezier curve with these coefficients of powers of t - 1/3
  const auto curve = [](const std::vector<Q>& x, const std::vector<Q>& y) {
    const int n = static_cast<int>(x.size()) - 1;
    std::vector<Traits::Point> p;
    for (int j = 0; j <= n; ++j) { // by blossoms
      const auto blossom = [&](const std::vector<Q>& c) {
        Q sum(0);
        // the mean of all products of k of the arguments 1 - 1/3, j times, and -1/3
        for (int k = 0; k <= n; ++k) {
          Q mean(0), all(1);
          for (int ones = 0; ones <= k; ++ones) {
            Q term(1);
            for (int i = 0; i < ones; ++i) term *= Q(j - i) / Q(i + 1) * Q(2) / Q(3);
            for (int i = 0; i < k - ones; ++i) term *= Q(n - j - i) / Q(i + 1) / Q(-3);
            mean += term;
          }
          for (int i = 0; i < k; ++i) all *= Q(n - i) / Q(i + 1);
          sum += c[k] * mean / all;
        }
        return sum;
      };
      p.emplace_back(blossom(x), blossom(y));
    }
    return GC::Bezier_curve<Traits>(p.begin(), p.end());
  };
  const double e = std::ldexp(1, -60), third = 1 / 3.;
  const auto has_extremum = [&](const GC::Curvature_extrema& c, double kappa) {
    bool found = false;
    for (const GC::Curvature_extremum& x : c)
      found = found || (holds(x.parameter, third, 1e-12) && x.curvature.lower <= kappa && kappa <= x.curvature.upper);
    return found;
  };
  // (s^3 + e s, s^2) has the curvature 2 / e^2 at s = 0
  const GC::Curvature_extrema sharp = GC::curvature_extrema(curve({Q(0), Q(e), Q(0), Q(1)}, {Q(0), Q(0), Q(1), Q(0)}));
  BOOST_CHECK(has_extremum(sharp, 2 / (e * e)) || has_extremum(sharp, -2 / (e * e)));
  BOOST_CHECK(std::isfinite(sharp.largest().upper));
  // y'' = s^2 + e^2 over x = s
  const GC::Curvature_extrema flat =
      GC::curvature_extrema(curve({Q(0), Q(1), Q(0), Q(0), Q(0)}, {Q(0), Q(0), Q(e * e / 2), Q(0), Q(Q(1) / Q(12))}));
  BOOST_CHECK(has_extremum(flat, e * e));
  BOOST_CHECK(flat.inflections.empty());
}

BOOST_AUTO_TEST_CASE(counts_of_extrema_are_written) {
  BOOST_CHECK_EQUAL(text(measured<Double_d>(parabola)).find("1 extremum of curvature, 0 inflections, curvature from "),
                    0);
  BOOST_CHECK(contains(text(measured<Double_d>(two_inflections)), " of curvature, 2 inflections, curvature from "));
}

// The place where the curvature exceeds a bound, on a curve with these control points.
template <class Traits>
std::optional<GC::Curvature_excess> excess(const Rows& rows, const typename Traits::FT& bound, double a = 0,
                                           double b = 1) {
  return GC::curvature_excess(bezier<Traits>(rows, a, b), bound);
}

// The largest curvature of a parabola is 2: the bound may be reached.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_bound_on_the_curvature, Traits, Planar_traits) {
  const double below = 2 - 0x1p-40;
  for (const Rows& rows : {parabola, mirrored(parabola)}) {
    BOOST_CHECK(!excess<Traits>(rows, 2, 3, 5));
    const std::optional<GC::Curvature_excess> e = excess<Traits>(rows, below, 3, 5);
    BOOST_REQUIRE(e && !e->unbounded && e->piece == 0);
    const double kappa = rows == parabola ? 2 : -2;
    BOOST_CHECK((e->parameter == GC::Enclosure{4, 4}) && (e->curvature == GC::Enclosure{kappa, kappa}));
  }
  CHECK_ERROR(excess<Traits>(parabola, -1), unreachable_tolerance);
  CHECK_ERROR(GC::curvature_excess(bezier<Traits>(parabola), infinity), not_finite);
}

// Places without a first derivative: what is drawn there counts.
BOOST_AUTO_TEST_CASE_TEMPLATE(bounds_where_there_is_no_derivative, Traits, Planar_traits) {
  const auto is_unbounded_at = [](const Rows& rows, double u) {
    const std::optional<GC::Curvature_excess> e = excess<Traits>(rows, 1e9);
    return e && e->unbounded && e->parameter.lower <= u && u <= e->parameter.upper && std::isinf(e->curvature.upper);
  };
  BOOST_CHECK(!excess<Traits>({{0, 0}, {1, 1}, {4, 4}}, 0) && !excess<Traits>({{1, 1}, {1, 1}}, 0));
  BOOST_CHECK(!excess<Traits>({{1, 1}}, 0) && !excess<Traits>({{0, 0}, {0, 0}, {3, 1}, {3, 1}}, 0));
  BOOST_CHECK(is_unbounded_at({{0, 0}, {1, 1}, {0, 1}, {1, 0}}, 0.5)); // a cusp
  BOOST_CHECK(is_unbounded_at({{0, 0}, {2, 0}, {1, 0}}, 2 / 3.));      // there and back, along a line
  BOOST_CHECK(is_unbounded_at({{0, 0}, {0, 0}, {0, 1}, {1, 0}}, 0) &&
              is_unbounded_at({{0, 0}, {0, 1}, {1, 0}, {1, 0}}, 1));
  // the parabola y = x^2 at x = t^2, which stands still at its vertex, and at x = (2t - 1)^2, which
  // turns back there
  const Rows still = {{0, 0}, {0, 0}, {1, 0}, {3, 0}, {6, 36}},
             back = {{6, 36}, {-6, -36}, {-2, 36}, {-6, -36}, {6, 36}};
  BOOST_CHECK(!excess<Traits>(still, 2) && is_unbounded_at(back, 0.5));
  const std::optional<GC::Curvature_excess> e = excess<Traits>(still, 2 - 0x1p-20);
  BOOST_REQUIRE(e && !e->unbounded);
  BOOST_CHECK(2 - 0x1p-20 < e->curvature.lower && e->curvature.upper < 2 && e->parameter.upper < 0.01);
}

BOOST_AUTO_TEST_CASE(random_bounds) {
  std::mt19937 engine = seeded(seed + 2);
  std::size_t exceeded = 0;
  for (int dimension : {2, 3, 4})
    for (int degree = 2; degree <= 5; ++degree)
      for (int run = 0; run < 6; ++run) {
        const Rows rows = random_rows(engine, degree, dimension, 1);
        const GC::Enclosure largest = measured<Double_d>(rows).largest();
        BOOST_CHECK(!excess<Double_d>(rows, largest.upper));
        const double below = largest.lower * (1 - 0x1p-40);
        const std::optional<GC::Curvature_excess> e = excess<Double_d>(rows, below);
        BOOST_REQUIRE(e);
        BOOST_CHECK(below < (std::max)(-e->curvature.lower, e->curvature.upper));
        // the same over another field, for half of the bound, and for a curve of several pieces
        BOOST_CHECK(excess<Exact_d>(rows, Q(largest.lower) / Q(2)) && !excess<Exact_d>(rows, Q(largest.upper)));
        const auto parts = bezier<Exact_d>(rows).split(Q(1) / Q(3));
        const std::vector<GC::Bezier_curve<Exact_d>> pieces = {parts.first, parts.second};
        const auto f =
            GC::curvature_excess(GC::Composite_bezier_curve<Exact_d>(pieces.begin(), pieces.end()), Q(below));
        BOOST_REQUIRE(f && f->piece == std::size_t(e->parameter.lower > 1 / 3.));
        exceeded += f->piece;
      }
  BOOST_CHECK(10 < exceeded && exceeded < 62);
}

// An arc of a circle of radius 5 has the curvature 1/5, exactly.
BOOST_AUTO_TEST_CASE(bounds_of_rational_curves) {
  const auto arc = GC::circular_arc<Exact_2>({1, 2}, {4, 6}, Q(1) / Q(2));
  BOOST_CHECK(!GC::curvature_excess(arc, Q(1) / Q(5)));
  BOOST_CHECK(GC::curvature_excess(arc, Q(199999) / Q(1000000)));
  const auto ellipse = GC::ellipse<Exact_3>({0, 0, 0}, {3, 0, 0}, {0, 2, 0}); // at its vertices 3/4 and 2/9
  BOOST_CHECK(!GC::curvature_excess(ellipse, 0.75) && GC::curvature_excess(ellipse, 0.75 - 0x1p-30));
}

BOOST_AUTO_TEST_SUITE_END()
