// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Corners, kinks, G1 and G2: the angle is compared exactly, handles at the node and lines drawn as
// cubics are seen as they are drawn.

#define BOOST_TEST_MODULE Visual_class

#include "support/enclosures.h"

#include <CGAL/Geometric_continuity/joins/Visual_class.h>
#include <CGAL/Geometric_continuity/joins/Visual_join.h>
#include <CGAL/Geometric_continuity/joins/join_continuity.h>
#include <CGAL/Sqrt_extension.h>
#include <boost/mpl/list.hpp>

typedef GC::Corner_threshold Bound;
using GC::Visual_class;

typedef boost::mpl::list<Epick_2, Double_2, Exact_2, Epeck_2> Kernels;

template <class Traits, int Degree = GC::dynamic_degree>
GC::Bezier_curve<Traits, Degree> curve(const std::vector<std::vector<double>>& rows, double scale = 1) {
  typedef typename Traits::FT FT;
  std::vector<typename Traits::Point> points;
  for (const std::vector<double>& p : rows) points.emplace_back(FT(scale * p[0]), FT(scale * p[1]));
  return GC::Bezier_curve<Traits, Degree>(points.begin(), points.end());
}

// Checks that a join on a grid, where the coordinates are integers and the curves meet, has this
// class.
struct Grid_point {
  std::int64_t x, y;
};

template <class Integer>
void check_on_grid(const std::vector<std::vector<double>>& left, const std::vector<std::vector<double>>& right,
                   const Bound& bound, double scale, double largest, const std::optional<Visual_class>& expected) {
  std::vector<Grid_point> points[2];
  for (std::size_t k = 0; k < 2; ++k)
    for (const std::vector<double>& p : k == 0 ? left : right) {
      for (double x : p)
        if (!(std::abs(scale * x) <= largest) || scale * x != std::floor(scale * x)) return;
      points[k].push_back({static_cast<std::int64_t>(scale * p[0]), static_cast<std::int64_t>(scale * p[1])});
    }
  if (left.back() != right.front()) return;
  const auto degree = [&points](std::size_t k) { return static_cast<int>(points[k].size()) - 1; };
  const GC::Visual_join<Grid_point, Integer> join(points[0].data(), degree(0), points[1].data(), degree(1));
  BOOST_CHECK(join.visual_class(bound) == expected);
  if (!expected) return;
  BOOST_CHECK_EQUAL(join.exceeds(bound), expected == Visual_class::corner);
  typedef GC::Traits_2<CGAL::Simple_cartesian<Q>> Traits;
  const GC::Kink_size size = *kink_size(curve<Traits>(left, scale), curve<Traits>(right, scale)),
                      same = join.kink_size();
  BOOST_CHECK(same.angle == size.angle && same.handle_offset == size.handle_offset && same.severity == size.severity);
}

// Grades a join that both the curves and their images in the other direction have.
template <class Traits>
std::string grade(const std::vector<std::vector<double>>& left, const std::vector<std::vector<double>>& right,
                  const Bound& bound = Bound(), double scale = 1) {
  const auto name = [](const std::optional<Visual_class>& g) { return g ? to_string(*g) : "undefined"; };
  const auto x = curve<Traits>(left, scale), y = curve<Traits>(right, scale);
  const std::optional<Visual_class> image = visual_class(x, y, bound);
  const std::string s = name(image);
  __extension__ typedef __int128 Wide;
  check_on_grid<Wide>(left, right, bound, scale, 0x1p53, image);
  check_on_grid<std::int64_t>(left, right, bound, scale, 0x1p25, image);
  const auto reversed = [](const std::vector<std::vector<double>>& v) {
    return std::vector<std::vector<double>>(v.rbegin(), v.rend());
  };
  BOOST_CHECK_EQUAL(
      s, name(visual_class(curve<Traits>(reversed(right), scale), curve<Traits>(reversed(left), scale), bound)));
  return s;
}

// ---------------------------------------------------------------- the bound

BOOST_AUTO_TEST_CASE(bounds_are_angles) {
  for (int degrees : {180, 181, -1}) CHECK_ERROR(Bound(degrees), parameter_outside_domain);
  CHECK_ERROR(Bound(std::numeric_limits<double>::quiet_NaN()), not_finite);
  CHECK_ERROR(Bound(std::numeric_limits<double>::infinity()), not_finite);
  CHECK_ERROR(Bound().is_exceeded(0., 0.), zero_direction);
  CHECK_ERROR(Bound().is_exceeded(Q(0), Q(0)), zero_direction);
  CHECK_ERROR(Bound().is_exceeded(std::numeric_limits<double>::infinity(), 1.), not_finite);
  BOOST_CHECK(Bound().degrees() == 5);
  BOOST_CHECK(Bound(Q(1) / 3).degrees() == Q(1) / 3);
  // every angle exceeds 0 degrees
  const Q little = Q(1) / Q(std::numeric_limits<double>::max());
  BOOST_CHECK(!Bound(0).is_exceeded(Q(0), Q(1)) && Bound(0).is_exceeded(Q(0), Q(-1)));
  BOOST_CHECK(Bound(0).is_exceeded(little, Q(1)) && Bound(0).is_exceeded(Q(-little), Q(1)));
  BOOST_CHECK(!Bound(0).is_exceeded(0., 1.) && Bound(0).is_exceeded(5e-324, 1.) && Bound(0).is_exceeded(0., -1.));
}

// An angle and the one that is a little larger.
template <class NT> void check_equality(int degrees, const NT& cross, const NT& dot, const NT& little) {
  BOOST_CHECK(!Bound(degrees).is_exceeded(cross, dot));
  BOOST_CHECK(!Bound(degrees).is_exceeded(NT(-cross), dot));
  BOOST_CHECK(Bound(degrees).is_exceeded(NT(cross + little), NT(dot - little)));
  BOOST_CHECK(!Bound(degrees).is_exceeded(NT(cross - little), NT(dot + little)));
  BOOST_CHECK(!Bound(180 - degrees).is_exceeded(cross, NT(-dot)));
}

BOOST_AUTO_TEST_CASE(angles_that_are_the_bound) {
  const Q little = Q(1) / (Q(1e50) * Q(1e50));
  for (double size : {1., 3., 1e-200, 1e200}) {
    BOOST_CHECK(!Bound(45).is_exceeded(size, size));
    BOOST_CHECK(Bound(45).is_exceeded(size, std::nextafter(size, 0)));
    BOOST_CHECK(!Bound(45).is_exceeded(std::nextafter(size, 0), size));
    BOOST_CHECK(!Bound(135).is_exceeded(size, -size));
    BOOST_CHECK(Bound(135).is_exceeded(std::nextafter(size, 0), -size));
    BOOST_CHECK(!Bound(90).is_exceeded(size, 0.));
    BOOST_CHECK(Bound(90).is_exceeded(size, -std::numeric_limits<double>::denorm_min()));
    BOOST_CHECK(!Bound(90).is_exceeded(size, std::numeric_limits<double>::denorm_min()));
  }
  const Bound tiny(Q(1) / (Q(1e300) * Q(1e300) * Q(1e300)));
  BOOST_CHECK(!tiny.is_exceeded(0., 1e300) && !tiny.is_exceeded(Q(0), Q(1)) && tiny.is_exceeded(0., -1.));
  BOOST_CHECK(tiny.is_exceeded(1e-300, 1e300) && tiny.is_exceeded(1e-308, 1e308));
  BOOST_CHECK(tiny.is_exceeded(Q(1), Q(57 / tiny.degrees())) && !tiny.is_exceeded(Q(1), Q(58 / tiny.degrees())));
  const std::int64_t large = std::numeric_limits<std::int64_t>::max();
  BOOST_CHECK(!Bound(45).is_exceeded(large, large));
  BOOST_CHECK(!Bound(45).is_exceeded(-large, large));
  BOOST_CHECK(Bound(45).is_exceeded(large, large - 1));
  BOOST_CHECK(!Bound(45).is_exceeded(large - 1, large));
  check_equality<Q>(45, 7, 7, little);
  check_equality<Q>(90, 7, 0, little);
  check_equality<CGAL::Epeck::FT>(45, 7, 7, little);

  typedef CGAL::Sqrt_extension<Q, Q> Field;
  const Field root_3(0, 1, 3), root_2(0, 1, 2);
  check_equality<Field>(30, 1, root_3, Field(little));
  check_equality<Field>(60, root_3, 1, Field(little));
  check_equality<Field>(15, 1, Field(2) + root_3, Field(little));
  check_equality<Field>(75, Field(2) + root_3, 1, Field(little));
  check_equality<Field>(120, root_3, -1, Field(little));
  BOOST_CHECK(!Bound(Q(45) / 2).is_exceeded(Field(root_2 - Field(1)), Field(1)));
  BOOST_CHECK(Bound(Q(45) / 2).is_exceeded(Field(root_2 - Field(1) + Field(little)), Field(1)));
  typedef CGAL::Sqrt_extension<Field, Q> Tower;
  // tan(7.5 degrees) in a field of two roots
  const Tower tower_2(Field(0), Field(1), 2), tower_3((Field(root_3)));
  const Tower tangent = tower_2 * tower_3 - tower_3 + tower_2 - Tower(Field(2));
  BOOST_CHECK(!Bound(Q(15) / 2).is_exceeded(tangent, Tower(Field(1))));
  BOOST_CHECK(Bound(Q(15) / 2).is_exceeded(Tower(tangent + Tower(Field(little))), Tower(Field(1))));
}

// A tangent with 90 digits, from a multi-precision library.
const char tangent_of_5[] =
    "0.0874886635259240052220186694349614581194542763681082291452366622216414273026128416191237324";

BOOST_AUTO_TEST_CASE(angles_near_five_degrees) {
  for (int digits = 3; digits <= 88; ++digits) {
    Q numerator = 0, denominator = 1;
    for (int i = 2; i < 2 + digits; ++i) {
      numerator = 10 * numerator + Q(tangent_of_5[i] - '0');
      denominator *= 10;
    }
    BOOST_CHECK(!Bound().is_exceeded(numerator, denominator));
    BOOST_CHECK(Bound().is_exceeded(Q(numerator + 1), denominator));
    BOOST_CHECK(Bound().is_exceeded(Q(-numerator - 1), denominator));
    BOOST_CHECK(Bound(175).is_exceeded(numerator, Q(-denominator)));
    BOOST_CHECK(!Bound(175).is_exceeded(Q(numerator + 1), Q(-denominator)));
    BOOST_CHECK(!Bound(85).is_exceeded(denominator, Q(numerator + 1)));
    BOOST_CHECK(Bound(85).is_exceeded(denominator, numerator));
    BOOST_CHECK(Bound(5 - 1 / (denominator * 100)).is_exceeded(Q(numerator + 1), denominator));
  }
  // convergents of the continued fraction: no nearer ones are as short
  BOOST_CHECK(Bound().is_exceeded(175200787808398., 2002554168134981.));
  BOOST_CHECK(!Bound().is_exceeded(217728658904153., 2488649959084553.));
  BOOST_CHECK(Bound().is_exceeded(std::int64_t(774999603829856659), std::int64_t(8858286006394581697)));
  BOOST_CHECK(Bound().is_exceeded(std::int64_t(175200787808398), std::int64_t(2002554168134981)));
  BOOST_CHECK(!Bound().is_exceeded(CGAL::Epeck::FT(217728658904153.), CGAL::Epeck::FT(2488649959084553.)));
}

BOOST_AUTO_TEST_CASE(random_angles) {
  std::mt19937_64 random = seeded<std::mt19937_64>(17);
  const double pi = std::acos(-1.);
  const auto number = [&](int bits) {
    return static_cast<std::int64_t>(random() >> (64 - bits)) - (1LL << (bits - 1));
  };
  for (int i = 0; i < 20000; ++i) {
    const Q degrees = Q(static_cast<double>(1 + random() % 179999)) / 1000;
    const Bound bound(degrees);
    const int bits = 2 + static_cast<int>(random() % 60);
    const std::int64_t c = number(bits), d = number(bits);
    if (c == 0 && d == 0) continue;
    const double angle = std::atan2(std::abs(static_cast<double>(c)), static_cast<double>(d)) * 180 / pi,
                 difference = angle - CGAL::to_double(degrees);
    const bool exceeded = bound.is_exceeded(c, d);
    if (std::abs(difference) > 1e-9) BOOST_CHECK_EQUAL(exceeded, difference > 0);
    BOOST_CHECK_EQUAL(exceeded, bound.is_exceeded(Q(c), Q(d)));
    const std::optional<bool> rounded = bound.is_exceeded(double(c), double(d), 1e-9 * std::abs(double(d)));
    if (rounded) BOOST_CHECK_EQUAL(*rounded, exceeded);
  }
}

// ---------------------------------------------------------------- joins

BOOST_AUTO_TEST_CASE_TEMPLATE(plain_joins, Traits, Kernels) {
  const std::vector<std::vector<double>> left = {{-3, 0}, {-2, 0}, {-1, 0}, {0, 0}};
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{1, 0}, {2, 0}}), "gap");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 1}}), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {-1, 0}}), "corner"); // a cusp
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {-1, 0}}, Bound(179)), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {100, 1}}), "kink");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {100, 1}}, Bound(Q(1) / 2)), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 0}, {2, 1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 0}, {2, 0}, {3, 1}}), "G2");
  BOOST_CHECK_EQUAL(grade<Traits>({{-2, 1}, {-1, 0}, {0, 0}}, {{0, 0}, {1, 0}, {2, 1}}), "G2");
  BOOST_CHECK_EQUAL(grade<Traits>({{-2, 1}, {-1, 0}, {0, 0}}, {{0, 0}, {1, 0}, {2, -1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 1}}, Bound(45)), "kink");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 1}}, Bound(Q(44999999) / 1000000)), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 1}}, Bound(90)), "kink");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {-1, 0x1p50}}, Bound(90)), "corner");
  // the convergents of the tangent of 5 degrees
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {2002554168134981, 175200787808398}}), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {2488649959084553, 217728658904153}}), "kink");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(large_and_small_numbers, Traits, Kernels) {
  const std::vector<std::vector<double>> left = {{-3, 1}, {-2, 0}, {-1, 0}, {0, 0}};
  for (double scale : {0x1p-1000, 0x1p-500, 0x1p-30, 0x1p500, 0x1p900}) {
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {100, 1}}, Bound(), scale), "kink");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 1}}, Bound(), scale), "corner");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 0}, {2, 1}}, Bound(), scale), "G1");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {1, 0}, {2, 0}}, Bound(), scale), "G2");
  }
  // legs that cannot be subtracted without rounding: parallel as rounded, and parallel
  const double far = 0x1p53;
  BOOST_CHECK_EQUAL(grade<Traits>({{-far, -far}, {1, 1}}, {{1, 1}, {far, far}}), "G2");
  BOOST_CHECK_EQUAL(grade<Traits>({{-far, 2 - far}, {1, 1}}, {{1, 1}, {far, far}}), "kink");
  BOOST_CHECK_EQUAL(grade<Traits>({{-far, -far}, {1, 1}}, {{1, 1}, {far, far}}, Bound(Q(1) / Q(1e30))), "G2");
  BOOST_CHECK_EQUAL(grade<Traits>({{-far, 2 - far}, {1, 1}}, {{1, 1}, {far, far}}, Bound(Q(1) / Q(1e30))), "corner");
}

// Curvatures that are compared by short products, by rounded ones and by long ones.
BOOST_AUTO_TEST_CASE_TEMPLATE(curvatures_on_grids, Traits, Kernels) {
  for (double scale : {1., 0x1p10, 0x1p20, 0x1p22, 0x1p23, 0x1p24, 0x1p40, 0x1p45}) {
    for (double more : {-1., 0., 1.}) {
      const std::vector<std::vector<double>> left = {{-2 * scale, -scale}, {-scale, 0}, {0, 0}},
                                             right = {{0, 0}, {scale, 0}, {2 * scale, more - scale}};
      BOOST_CHECK_EQUAL(grade<Traits>(left, right), more == 0 ? "G2" : "G1");
      BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {3 * scale, 0}, {0, more - 9 * scale}}), more == 0 ? "G2" : "G1");
    }
    BOOST_CHECK_EQUAL(grade<Traits>({{-2 * scale, scale}, {-scale, 0}, {0, 0}}, {{0, 0}, {scale, 0}, {2, -scale}}),
                      "G1");
    BOOST_CHECK_EQUAL(grade<Traits>({{0, -scale}, {0, 0}}, {{0, 0}, {0, 2 * scale}, {0, 3 * scale}, {1, 0}}), "G2");
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(lines_as_cubics, Traits, Kernels) {
  const std::vector<std::vector<double>> line = {{-3, 0}, {0, 0}}, bend = {{0, 0}, {1, 0}, {2, 1}},
                                         flat = {{0, 0}, {1, 0}, {2, 0}, {3, 1}};
  for (const std::vector<std::vector<double>>& left : {line,
                                                       {{-3, 0}, {-2, 0}, {-1, 0}, {0, 0}},
                                                       {{-3, 0}, {-3, 0}, {0, 0}, {0, 0}},
                                                       {{-3, 0}, {-2, 0}, {0, 0}, {0, 0}},
                                                       {{-3, 0}, {-1, 0}, {-1, 0}, {0, 0}, {0, 0}},
                                                       {{-3, 0}, {-3, 0}, {-2, 0}, {-1, 0}, {0, 0}, {0, 0}}}) {
    BOOST_CHECK_EQUAL(grade<Traits>(left, bend), "G1");
    BOOST_CHECK_EQUAL(grade<Traits>(left, flat), "G2");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {2, 0}}), "G2");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 0}, {2, 0}, {2, 0}}), "G2");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 0}, {50, 1}, {50, 1}}), "kink");
    BOOST_CHECK_EQUAL(grade<Traits>(left, {{0, 0}, {0, 0}, {0, 2}, {0, 2}}), "corner");
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(retracted_handles, Traits, Kernels) {
  const std::vector<std::vector<double>> line = {{-3, 0}, {0, 0}}, bend = {{-3, 1}, {-2, 0}, {-1, 0}, {0, 0}};
  // one leg is zero, two are, on both sides
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {1, 0}, {2, 1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(bend, {{0, 0}, {0, 0}, {1, 0}, {2, 1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {0, 0}, {1, 0}, {2, 1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>({{-2, 1}, {-1, 0}, {0, 0}, {0, 0}}, {{0, 0}, {0, 0}, {1, 0}, {2, 1}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {100, 1}, {200, 50}}), "kink");
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {0, 1}, {2, 1}}), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {-1, 0}, {2, 1}}), "corner"); // a cusp
  // on the chord, but not in order: it goes beyond its end, or turns back
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {3, 0}, {2, 0}}), "G1");
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {-1, 0}, {2, 0}}), "corner");
  BOOST_CHECK_EQUAL(grade<Traits>({{-2, 0}, {1, 0}, {0, 0}, {0, 0}}, {{0, 0}, {2, 0}}), "corner");
  // near a line
  BOOST_CHECK_EQUAL(grade<Traits>(line, {{0, 0}, {0, 0}, {1, 0}, {2, 0x1p-40}}), "G1");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(curves_of_no_length, Traits, Kernels) {
  BOOST_CHECK_EQUAL(grade<Traits>({{-1, 0}, {0, 0}}, {{0, 0}, {0, 0}, {0, 0}}), "undefined");
  BOOST_CHECK_EQUAL(grade<Traits>({{0, 0}}, {{0, 0}, {0, 1}}), "undefined");
  BOOST_CHECK_EQUAL(grade<Traits>({{0, 0}, {0, 0}}, {{1, 0}, {2, 1}}), "gap");
  BOOST_CHECK(!kink_size(curve<Traits>({{-1, 0}, {0, 0}}), curve<Traits>({{0, 0}, {0, 0}})));
  BOOST_CHECK(!kink_size(curve<Traits>({{0, 0}, {0, 0}}), curve<Traits>({{0, 0}, {1, 0}})));
  // the bound that is not given is five degrees
  const auto usual = [](double y) {
    return visual_class(curve<Traits>({{-1, 0}, {0, 0}}), curve<Traits>({{0, 0}, {1, y}}));
  };
  BOOST_CHECK(usual(0.0874) == GC::Visual_class::kink && usual(0.0875) == GC::Visual_class::corner);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite) {
  typedef GC::Traits_2<CGAL::Epick> Traits;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double x : {infinity, -infinity, nan}) {
    CHECK_ERROR(visual_class(curve<Traits>({{0, 0}, {x, 0}}), curve<Traits>({{x, 0}, {2, 0}})), not_finite);
    CHECK_ERROR(visual_class(curve<Traits>({{x, 0}, {0, 0}}), curve<Traits>({{0, 0}, {2, 0}})), not_finite);
    CHECK_ERROR(visual_class(curve<Traits>({{-1, 0}, {0, 0}}), curve<Traits>({{0, 0}, {2, x}})), not_finite);
    CHECK_ERROR(kink_size(curve<Traits>({{-1, 0}, {0, 0}}), curve<Traits>({{0, 0}, {2, x}})), not_finite);
  }
}

// Small integers, where all grades occur: against continuity(), the cross product and 90 digits of
// the tangent.
BOOST_AUTO_TEST_CASE_TEMPLATE(random_joins, Traits, Kernels) {
  std::mt19937 random = seeded(2026);
  const auto number = [&](int size) { return static_cast<double>(static_cast<int>(random() % (2 * size + 1)) - size); };
  Q tangent = 0, unit = 1;
  for (int i = 2; i < 90; ++i) tangent += Q(tangent_of_5[i] - '0') * (unit /= 10);
  std::map<std::string, int> count;
  for (int i = 0; i < 1500; ++i) {
    const double x = 1 + double(random() % 30), y = number(3), k = 1 + double(random() % 3);
    const std::vector<std::vector<double>> left = {{number(9), number(9)},
                                                   {-2 * x + number(1), -2 * y + number(1)},
                                                   {-x, -y},
                                                   {0, 0}},
                                           right = {{0, 0},
                                                    {k * x, k * y + (i % 3 == 0 ? number(2) : 0)},
                                                    {2 * k * x + number(1), 2 * k * y + number(1)},
                                                    {number(9), number(9)}};
    const Q c = Q(x) * Q(right[1][1]) - Q(y) * Q(right[1][0]), d = Q(x) * Q(right[1][0]) + Q(y) * Q(right[1][1]);
    const int order = GC::continuity(curve<Traits>(left), curve<Traits>(right)).g_order;
    const std::string expected = order >= 2                                    ? "G2"
                                 : order == 1                                  ? "G1"
                                 : d <= 0 || (c < 0 ? Q(-c) : c) > tangent * d ? "corner"
                                                                               : "kink";
    BOOST_CHECK_EQUAL(grade<Traits>(left, right), expected);
    ++count[expected];
  }
  BOOST_CHECK_EQUAL(count.size(), 4);
}

// ---------------------------------------------------------------- sizes

BOOST_AUTO_TEST_CASE_TEMPLATE(sizes_of_kinks, Traits, Kernels) {
  const double pi = std::acos(-1.);
  const auto size = [](const std::vector<std::vector<double>>& left, const std::vector<std::vector<double>>& right) {
    return *kink_size(curve<Traits>(left), curve<Traits>(right));
  };
  const auto near = [](const GC::Enclosure& e, double x) {
    BOOST_CHECK(e.lower <= e.upper && e.upper - e.lower <= 1e-14 * x);
    BOOST_CHECK_CLOSE(e.lower, x, 1e-12);
  };
  // (30, 40) to (33, 44) turned by one unit: |a x b| = 30, over the longer handle of 55 or so
  const GC::Kink_size k = size({{-30, -40}, {0, 0}}, {{0, 0}, {33, 45}});
  near(k.angle, std::atan2(30., 30 * 33 + 40 * 45));
  near(k.handle_offset, 30 / std::hypot(33, 45));
  near(k.severity, std::atan2(30., 2790.) * 50);
  const GC::Kink_size right_angle = size({{-3, 0}, {0, 0}}, {{0, 0}, {0, 4}});
  near(right_angle.angle, pi / 2);
  near(GC::in_degrees(right_angle.angle), 90);
  BOOST_CHECK(right_angle.handle_offset == (GC::Enclosure{3, 3}));
  const GC::Kink_size cusp = size({{-3, 0}, {0, 0}}, {{0, 0}, {-4, 0}});
  near(GC::in_degrees(cusp.angle), 180);
  BOOST_CHECK(cusp.handle_offset == (GC::Enclosure{3, 3}));
  const GC::Kink_size none = size({{-3, 0}, {0, 0}}, {{0, 0}, {4, 0}, {5, 5}});
  BOOST_CHECK(none.angle == (GC::Enclosure{0, 0}) && none.handle_offset == none.angle && none.severity == none.angle);
  // the handles that are seen
  const GC::Kink_size retracted = size({{-9, 1}, {-3, 0}, {0, 0}, {0, 0}}, {{0, 0}, {0, 0}, {4, 1}, {9, 9}});
  near(retracted.handle_offset, 3 / std::hypot(4, 1));

  std::ostringstream text;
  text << size({{-20, 0}, {0, 0}}, {{0, 0}, {20, 1}});
  BOOST_CHECK_EQUAL(text.str(), "angle [0.0499583, 0.0499584], handle off by [0.998752, 0.998753], severity "
                                "[0.999167, 0.999168]");
}

BOOST_AUTO_TEST_CASE(degrees_enclose) {
  // pi with 60 digits; x degrees are x pi/180 radians
  const Q pi = Q("314159265358979323846264338327950288419716939937510582097494") /
               Q("100000000000000000000000000000000000000000000000000000000000");
  std::mt19937_64 random = seeded<std::mt19937_64>(7);
  for (int i = 0; i < 1000; ++i) {
    const double digits = static_cast<double>(random() >> 11);
    const double x = std::ldexp(digits, -52 - static_cast<int>(random() % 200));
    const GC::Enclosure e = GC::in_degrees({x, x});
    BOOST_CHECK(Q(e.lower) * pi <= Q(x) * 180 && Q(x) * 180 <= Q(e.upper) * (pi + Q(1e-59)));
    BOOST_CHECK_LE(enclosures::ulps(e), 4);
  }
  BOOST_CHECK(GC::in_degrees({0, 0}) == (GC::Enclosure{0, 0}));
}

BOOST_AUTO_TEST_CASE(names) {
  std::ostringstream text;
  for (Visual_class g :
       {Visual_class::gap, Visual_class::corner, Visual_class::kink, Visual_class::g1, Visual_class::g2})
    text << g << ' ';
  BOOST_CHECK_EQUAL(text.str(), "gap corner kink G1 G2 ");
}
