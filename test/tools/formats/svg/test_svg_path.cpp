// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE svg_path
#include "support/test.h"

#include "formats/svg/Css_transform.h"
#include "formats/svg/Svg_transform.h"
#include "formats/svg/Svg_viewport.h"
#include "formats/svg/read_svg_path.h"
#include "formats/svg/svg_shapes.h"
#include <CGAL/Geometric_continuity/joins/path_continuity.h>
#include <CGAL/Sqrt_extension.h>

typedef GC::Svg_subpath<Exact_2> Subpath;
typedef GC::Svg_segment<Exact_2> Segment;
typedef GC::Svg_transform<Exact_2> Transform;
typedef Exact_2::Point Point;
typedef std::vector<Point> Points;

namespace {

constexpr unsigned seed = 20261121;

std::string text(const Q& x) {
  return written_by([&](std::ostream& os) { GC::write_number(os, x); });
}

std::string text(const Point& p) { return text(p.x()) + ',' + text(p.y()); }

// Number, letter and control points of each segment; "Z" ends a closed subpath, "|" an open one.
std::string text(const std::vector<Subpath>& path) {
  std::string s;
  for (const Subpath& subpath : path) {
    for (const Segment& segment : subpath.segments) {
      s += std::to_string(segment.command) + segment.letter;
      if (segment.arc())
        s += " arc " + text(segment.start()) + ' ' + text(segment.end());
      else
        for (const Point& p : *segment.bezier()) s += ' ' + text(p);
      s += "; ";
    }
    s += subpath.closed ? "Z" : "|";
  }
  return s;
}

std::string read(const std::string& data) { return text(GC::read_svg_path<Exact_2>(data)); }

// The only arc of a path.
GC::Elliptical_arc<Exact_2> arc(const std::string& data) {
  const std::vector<Subpath> path = GC::read_svg_path<Exact_2>(data);
  BOOST_REQUIRE_EQUAL(path.size(), 1u);
  BOOST_REQUIRE_EQUAL(path[0].segments.size(), 1u);
  BOOST_REQUIRE(path[0].segments[0].arc());
  return *path[0].segments[0].arc();
}

GC::Curve_jet<Exact_2> jet(const Point& p, const Q& x1, const Q& y1, const Q& x2, const Q& y2) {
  return GC::Curve_jet<Exact_2>(p, {Exact_2::Vector(x1, y1), Exact_2::Vector(x2, y2)});
}

// The G orders of the joins from left to right, the closing one last; "?" is undecided.
std::string orders(const Subpath& subpath) {
  std::string s;
  const std::size_t n = subpath.segments.size();
  for (std::size_t i = 0; i < (subpath.closed ? n : n - 1); ++i) {
    const auto join = GC::continuity(subpath.segments[i], subpath.segments[(i + 1) % n]);
    s += join ? std::to_string(join->g_order) : "?";
  }
  return s;
}

std::string orders(const std::string& data) { return orders(GC::read_svg_path<Exact_2>(data).at(0)); }

template <class Function> std::string error(Function f) {
  try {
    f();
  } catch (const GC::Error& e) {
    BOOST_CHECK(e.code() == GC::Error_code::malformed_input);
    return e.what();
  }
  return "no error";
}

// The text is refused at this character, for this reason.
void check_refused(const std::string& data, int character, const std::string& reason) {
  const std::string message = error([&] { read(data); });
  const std::string expected = "path data, character " + std::to_string(character) + ": ";
  BOOST_CHECK_MESSAGE(message.find(expected) != std::string::npos && message.find(reason) != std::string::npos,
                      data << " gives '" << message << "' instead of '" << expected << reason << "'");
}

// A random decimal with up to three digits behind the point, as text.
std::string random_decimal(std::mt19937& random) {
  const int n = std::uniform_int_distribution<int>(-99999, 99999)(random);
  const std::string digits = std::to_string(std::abs(n)), sign = n < 0 ? "-" : "";
  switch (random() % 4) {
  case 0: return sign + digits;
  case 1: return sign + digits + "e-2";
  case 2: return sign + "." + digits;
  default: return sign + digits.substr(0, digits.size() - 1) + "." + digits.back();
  }
}

Q random_rational(std::mt19937& random) {
  std::uniform_int_distribution<int> numerator(-1000000, 1000000), denominator(1, 1000000);
  const Q p(numerator(random)), q(denominator(random));
  return Q(p / q);
}

Transform random_transform(std::mt19937& random) {
  for (;;) {
    std::array<Q, 6> m;
    for (Q& x : m) x = random_rational(random);
    const Transform map(m);
    if (map.determinant() != 0) return map;
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(every_command_absolute_and_relative) {
  BOOST_CHECK_EQUAL(read("M1 2L3 4"), "2L 1,2 3,4; |");
  BOOST_CHECK_EQUAL(read("m1 2l3 4"), "2l 1,2 4,6; |");
  BOOST_CHECK_EQUAL(read("M1 2H5V7"), "2H 1,2 5,2; 3V 5,2 5,7; |");
  BOOST_CHECK_EQUAL(read("M1 2h5v7"), "2h 1,2 6,2; 3v 6,2 6,9; |");
  BOOST_CHECK_EQUAL(read("M1 2C3 4 5 6 7 9"), "2C 1,2 3,4 5,6 7,9; |");
  BOOST_CHECK_EQUAL(read("M1 2c3 4 5 6 7 9"), "2c 1,2 4,6 6,8 8,11; |");
  BOOST_CHECK_EQUAL(read("M1 2Q3 4 5 7"), "2Q 1,2 3,4 5,7; |");
  BOOST_CHECK_EQUAL(read("M1 2q3 4 5 7"), "2q 1,2 4,6 6,9; |");
  BOOST_CHECK_EQUAL(read("M1 2A5 6 0 0 1 3 4"), "2A arc 1,2 3,4; |");
  BOOST_CHECK_EQUAL(read("M1 2a5 6 0 0 1 3 4"), "2a arc 1,2 4,6; |");
}

BOOST_AUTO_TEST_CASE(smooth_commands_reflect_the_last_handle) {
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4S7 8 9 9"), "2C 0,0 1,1 2,3 4,4; 3S 4,4 6,5 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0c1 1 2 3 4 4s3 4 5 5"), "2c 0,0 1,1 2,3 4,4; 3s 4,4 6,5 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0Q1 2 4 4T9 9t1 2"), "2Q 0,0 1,2 4,4; 3T 4,4 7,6 9,9; 4t 9,9 11,12 10,11; |");
  // not after a command of another kind; the handle is then at the node
  BOOST_CHECK_EQUAL(read("M1 1S7 8 9 9"), "2S 1,1 1,1 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0Q1 2 4 4S7 8 9 9"), "2Q 0,0 1,2 4,4; 3S 4,4 4,4 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4L5 5S7 8 9 9"), "2C 0,0 1,1 2,3 4,4; 3L 4,4 5,5; 4S 5,5 5,5 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4A3 3 0 0 1 5 5S7 8 9 9"),
                    "2C 0,0 1,1 2,3 4,4; 3A arc 4,4 5,5; 4S 5,5 5,5 7,8 9,9; |");
  // a quadratic without a handle is a line, and the next one has none either
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4T9 9T1 1"), "2C 0,0 1,1 2,3 4,4; 3T 4,4 9,9; 4T 9,9 14,14 1,1; |");
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4M5 5S7 8 9 9"), "2C 0,0 1,1 2,3 4,4; |4S 5,5 5,5 7,8 9,9; |");
  BOOST_CHECK_EQUAL(read("M0 0C1 1 2 3 4 4ZS7 8 9 9"), "2C 0,0 1,1 2,3 4,4; 3Z 4,4 0,0; Z4S 0,0 0,0 7,8 9,9; |");
}

BOOST_AUTO_TEST_CASE(implicit_repetitions_count_as_commands) {
  BOOST_CHECK_EQUAL(read("M0 0 1 0 1 1"), "2L 0,0 1,0; 3L 1,0 1,1; |");
  BOOST_CHECK_EQUAL(read("m1 1 1 0 0 1"), "2l 1,1 2,1; 3l 2,1 2,2; |");
  BOOST_CHECK_EQUAL(read("M0 0h1 2 3"), "2h 0,0 1,0; 3h 1,0 3,0; 4h 3,0 6,0; |");
  BOOST_CHECK_EQUAL(read("M0 0c1 1 2 1 3 0 1 1 2 1 3 0"), "2c 0,0 1,1 2,1 3,0; 3c 3,0 4,1 5,1 6,0; |");
  BOOST_CHECK_EQUAL(read("M0 0a1 1 0 0 1 1 1 1 1 0 0 1 1 1"), "2a arc 0,0 1,1; 3a arc 1,1 2,2; |");
}

BOOST_AUTO_TEST_CASE(subpaths_and_closing) {
  BOOST_CHECK_EQUAL(read(""), "");
  BOOST_CHECK_EQUAL(read(" \t\r\n"), "");
  BOOST_CHECK_EQUAL(read("M1 1"), "");
  BOOST_CHECK_EQUAL(read("M1 1Z"), "Z");
  BOOST_CHECK_EQUAL(read("M0 0H1V1Z"), "2H 0,0 1,0; 3V 1,0 1,1; 4Z 1,1 0,0; Z");
  BOOST_CHECK_EQUAL(read("M0 0H1V1L0 0Z"), "2H 0,0 1,0; 3V 1,0 1,1; 4L 1,1 0,0; Z");
  BOOST_CHECK_EQUAL(read("M0 0H1V1L0 0"), "2H 0,0 1,0; 3V 1,0 1,1; 4L 1,1 0,0; |");
  // the next subpath starts where the closed one did, also for a relative M
  BOOST_CHECK_EQUAL(read("M1 2h1v1zl5 5"), "2h 1,2 2,2; 3v 2,2 2,3; 4z 2,3 1,2; Z5l 1,2 6,7; |");
  BOOST_CHECK_EQUAL(read("M1 2h1v1zm5 5h1"), "2h 1,2 2,2; 3v 2,2 2,3; 4z 2,3 1,2; Z6h 6,7 7,7; |");
  BOOST_CHECK_EQUAL(read("M1 2h1m5 5h1m1 1"), "2h 1,2 2,2; |4h 7,7 8,7; |");
}

BOOST_AUTO_TEST_CASE(numbers_need_no_separators_and_are_exact) {
  BOOST_CHECK_EQUAL(read("M1.5.5-.5-3"), "2L 3/2,1/2 -1/2,-3; |");
  BOOST_CHECK_EQUAL(read("M1e3-1E-1L+.1e+1,0.1"), "2L 1000,-1/10 1,1/10; |");
  BOOST_CHECK_EQUAL(read("M 0 , 0\n,\t3.\r\f,5.e1"), "2L 0,0 3,50; |");
  BOOST_CHECK_EQUAL(read("M0,0-1-1+1+1"), "2L 0,0 -1,-1; 3L -1,-1 1,1; |");
  BOOST_CHECK_EQUAL(read("M0 0l.1.2l.1.2l.1.2"), "2l 0,0 1/10,1/5; 3l 1/10,1/5 1/5,2/5; 4l 1/5,2/5 3/10,3/5; |");
  const double x = GC::read_svg_path<Double_2>("M0.1 0L1 1")[0].segments[0].start().x();
  BOOST_CHECK_EQUAL(x, 0.1);
}

BOOST_AUTO_TEST_CASE(arc_flags_may_be_glued) {
  const std::string expected = "2A arc 0,0 3/2,5/2; |";
  for (const char* data : {"M0 0A9 9 0 0 1 1.5 2.5", "M0 0A9 9 0 0,1,1.5,2.5", "M0 0A9 9 0 011.5 2.5",
                           "M0 0A9,9,0,01,1.5,2.5", "M0 0A9 9 0 0 11.5 2.5"}) {
    BOOST_CHECK_EQUAL(read(data), expected);
    BOOST_CHECK(arc(data).start_jet_over<Q>(3, Q(2)) == arc("M0 0A9 9 0 0 1 1.5 2.5").start_jet_over<Q>(3, Q(2)));
  }
  BOOST_CHECK_EQUAL(read("M0 0a9 9 0 11.5.5 9 9 0 10-.5-.5"), "2a arc 0,0 1/2,1/2; 3a arc 1/2,1/2 0,0; |");
}

// On the circle of radius 5 around (0, 0) or (6, 0), from (3, -4) to (3, 4).
BOOST_AUTO_TEST_CASE(the_four_arcs_between_two_points) {
  const Point p(3, -4), q(3, 4);
  const auto both = [&](const std::string& flags) {
    const GC::Elliptical_arc<Exact_2> a = arc("M3-4A5 5 0 " + flags + " 3 4");
    BOOST_REQUIRE(a.is_rational());
    return std::array<GC::Curve_jet<Exact_2>, 2>{*a.start_jet(2), *a.end_jet(2)};
  };
  BOOST_CHECK(both("01")[0] == jet(p, 4, 3, -3, 4));
  BOOST_CHECK(both("01")[1] == jet(q, -4, 3, -3, -4));
  BOOST_CHECK(both("10")[0] == jet(p, -4, -3, -3, 4));
  BOOST_CHECK(both("10")[1] == jet(q, 4, -3, -3, -4));
  BOOST_CHECK(both("00")[0] == jet(p, -4, 3, 3, 4));
  BOOST_CHECK(both("00")[1] == jet(q, 4, 3, 3, -4));
  BOOST_CHECK(both("11")[0] == jet(p, 4, -3, 3, 4));
  BOOST_CHECK(both("11")[1] == jet(q, -4, -3, 3, -4));
  // the derivatives go on with period 4
  const GC::Curve_jet<Exact_2> five = *arc("M3-4A5 5 0 01 3 4").start_jet(5);
  BOOST_CHECK(five[3] == Q(-1) * five[1] && five[4] == Q(-1) * five[2] && five[5] == five[1]);
}

BOOST_AUTO_TEST_CASE(arcs_with_unusual_radii_and_rotations) {
  // too small radii are enlarged: the centre is the midpoint, also when the factor is not rational
  BOOST_CHECK(arc("M0 0A1 1 0 0 1 4 0").start_jet(2) == jet(Point(0, 0), 0, -2, 2, 0));
  BOOST_CHECK(arc("M0 0A1 2 0 0 1 4 0").start_jet(2) == jet(Point(0, 0), 0, -4, 2, 0));
  BOOST_CHECK(arc("M0 0A2 2 0 0 1 4.4 0").start_jet(2) == jet(Point(0, 0), 0, Q(-11, 5), Q(11, 5), 0));
  BOOST_CHECK(arc("M0 0A1 1 0 0 1 2 4").start_jet(2) == jet(Point(0, 0), 2, -1, 1, 2));
  BOOST_CHECK(arc("M0 0A1 1 0 1 0 2 4").end_jet(2) == jet(Point(2, 4), 2, -1, -1, -2));
  BOOST_CHECK(arc("M0 0A-1-2 0 0 1 4 0").start_jet(3) == arc("M0 0A1 2 0 0 1 4 0").start_jet(3));
  // without a radius it is a line; between equal points it is nothing, but counts
  BOOST_CHECK_EQUAL(read("M0 0A0 1 0 0 1 4 0A1 0 0 0 1 5 0"), "2A 0,0 4,0; 3A 4,0 5,0; |");
  BOOST_CHECK_EQUAL(read("M0 0A1 1 0 0 1 0 0L1 1"), "3L 0,0 1,1; |");
  // by an odd multiple of 90 degrees the radii change places, by an even one nothing changes
  const GC::Curve_jet<Exact_2> upright = *arc("M0 0A2 1 0 0 1 2 1").start_jet(3);
  // around (0, 1)
  BOOST_CHECK(arc("M0 0A2 1 0 0 1 2 1").start_jet(2) == jet(Point(0, 0), 2, 0, 0, 1));
  for (const char* turned : {"1 2 90", "1 2 -90", "1 2 450", "2 1 180", "2 1 -360", "2 1 3.6e2"})
    BOOST_CHECK(arc("M0 0A" + std::string(turned) + " 0 1 2 1").start_jet(3) == upright);
  // of a circle any rotation is known, of an ellipse multiples of 45 degrees are
  BOOST_CHECK(arc("M0 0A5 5 30 0 1 5 5").start_jet(3) == arc("M0 0A5 5 0 0 1 5 5").start_jet(3));
  BOOST_CHECK(!arc("M0 0A5 4 30 0 1 5 5").is_known());
  BOOST_CHECK_EQUAL(orders("M0 0A5 4 30 0 1 5 5L9 9"), "0");
  BOOST_CHECK_EQUAL(orders("M9 9L0 0A5 4 1e-3 0 1 5 5"), "0");
}

// Halves of ellipses have rational derivatives, and other parts have those with one square root.
BOOST_AUTO_TEST_CASE(arcs_that_are_rotated_by_multiples_of_45_degrees) {
  for (const char* turned : {"7 4 45", "7 4 -135", "7 4 405", "4 7 135", "4 7 -45", "-7 4 225"}) {
    const auto a = arc("M0 0A" + std::string(turned) + " 0 1 16 24");
    BOOST_REQUIRE(a.is_known() && a.is_rational());
    const GC::Curve_jet<Exact_2> jet = *a.start_jet(2);
    const Q r[2] = {Q(0) - jet[2][0], Q(0) - jet[2][1]}, t[2] = {jet[1][0], jet[1][1]};
    // half of the ellipse with x - c and x' as conjugate radii: (u, v) . (u', v') = 0 for u = (x +
    // y) / 7, v = (y - x) / 4
    BOOST_CHECK(r[0] == -8 && r[1] == -12);
    BOOST_CHECK_EQUAL(Q((r[0] + r[1]) * (t[0] + t[1]) / 49 + (r[1] - r[0]) * (t[1] - t[0]) / 16), 0);
    BOOST_CHECK(Q(r[0] * t[1] - r[1] * t[0]) > 0);
  }
  BOOST_CHECK_EQUAL(orders("M-9 0L0 0A7 4 45 0 1 33 65H9"), "11"); // with horizontal tangents
  BOOST_CHECK_EQUAL(orders("M-9 0L0 0A7 4 44.999 0 1 33 65H9"), "00");
  const auto irrational = arc("M0 0A5 4 45 0 1 5 5.5");
  BOOST_CHECK(irrational.is_known() && !irrational.is_rational());
  // point by point symmetric: a turning point
  BOOST_CHECK_EQUAL(orders("M0 0A5 4 45 0 1 5 5.5A5 4 45 0 0 10 11"), "1");
  BOOST_CHECK_EQUAL(orders("M100,20a6,3,45,0,1-6,0z"), "00");
}

namespace {

// The angle of the tangents of an arc from (0, 0) with the x-axis, in degrees, at its start and its
// end: by the formulas of the implementation notes of SVG, in floating-point numbers.
std::array<double, 2> tangents_of_svg(double rx, double ry, double rotation, bool large, bool sweep, double x,
                                      double y) {
  const double radian = std::acos(-1.) / 180, c = std::cos(rotation * radian), s = std::sin(rotation * radian);
  const double x1 = (-c * x - s * y) / 2, y1 = (s * x - c * y) / 2;
  const double lambda = x1 * x1 / (rx * rx) + y1 * y1 / (ry * ry), grow = std::sqrt((std::max)(lambda, 1.));
  rx *= grow;
  ry *= grow;
  const double root =
      (large == sweep ? -1 : 1) * std::sqrt((std::max)(0., (rx * rx * ry * ry - rx * rx * y1 * y1 - ry * ry * x1 * x1) /
                                                               (rx * rx * y1 * y1 + ry * ry * x1 * x1)));
  const double cx = root * rx * y1 / ry, cy = -root * ry * x1 / rx;
  const auto tangent = [&](double u, double v) {
    const double du = (sweep ? -1 : 1) * rx / ry * (v - cy), dv = (sweep ? 1 : -1) * ry / rx * (u - cx);
    return std::atan2(s * du + c * dv, c * du - s * dv) / radian;
  };
  return {tangent(x1, y1), tangent(-x1, -y1)};
}

} // namespace

// The enclosed angles between an arc and the x-axis are those of SVG's own formulas.
BOOST_AUTO_TEST_CASE(tangents_of_rotated_ellipses) {
  int arcs = 0;
  for (const char* rotation : {"30", "-60", "22.5", "10.7", "120", "135", "200", "1e-3", "45", "-301.25", "1e6"})
    for (const char* radii : {"5 4", "3 8", "1 2", "100 1"})
      for (const char* flags : {"00", "01", "10", "11"})
        for (const char* end : {"5 5", "-2 7", "1 0", "0 -3"}) {
          std::istringstream numbers(std::string(radii) + ' ' + rotation + ' ' + end);
          double rx, ry, angle, x, y;
          numbers >> rx >> ry >> angle >> x >> y;
          const std::array<double, 2> expected = tangents_of_svg(rx, ry, angle, flags[0] == '1', flags[1] == '1', x, y);
          const std::string text = std::string("M-1 0L0 0A") + radii + ' ' + rotation + ' ' + flags + ' ' + end + "h1";
          const Subpath path = GC::read_svg_path<Exact_2>(text)[0];
          for (int i = 0; i < 2; ++i) {
            const auto angle_there = GC::tangent_angle(path.segments[i], path.segments[i + 1]);
            const GC::Enclosure degrees = GC::in_degrees(*angle_there);
            const double size = std::abs(expected[i]);
            BOOST_CHECK_MESSAGE(degrees.upper - degrees.lower < 1e-9 && std::abs(degrees.lower - size) < 1e-6,
                                text << ": " << degrees << " instead of " << size);
            const auto rounded = GC::tangent_angle<Exact_2>(path.segments[i].rounded(), path.segments[i + 1].rounded());
            BOOST_CHECK_SMALL(GC::in_degrees(*rounded).lower - degrees.lower, 1e-6);
            const auto grade = GC::visual_class(path.segments[i], path.segments[i + 1]);
            BOOST_CHECK(grade == (size > 5 ? GC::Visual_class::corner : GC::Visual_class::kink));
          }
          ++arcs;
        }
  BOOST_CHECK_EQUAL(arcs, 704);
}

// Halves of ellipses of one shape, and arcs that are symmetric to their join, have one tangent
// exactly, though it is not rational.
BOOST_AUTO_TEST_CASE(joins_of_rotated_ellipses) {
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A2 1 30 0 1 0 0Z"), "33");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A1 2 120 0 1 0 0Z"), "33");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A1 .5 -330 1 1 0 0Z"), "33");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A1 .5 30 0 1 2 1"), "1"); // a smaller half
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A2 1 30 0 0 8 4"), "1");  // a turning point
  // the same of less than halves
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A9 4 30 0 0 8 4"), "1");
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 1 0 4 2A9 4 30 1 1 8 4"), "1");   // and of more
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A18 8 30 0 0 12 6"), "1"); // and twice as large
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A9 4 30 0 0 12 6"), "0");
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A9 4 30 0 1 8 4"), "0");
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A9 4 30 0 1 0 0Z"), "00"); // a lens
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 0 1 4 2A9 4 30 1 1 0 0Z"), "33"); // the rest of the ellipse
  BOOST_CHECK_EQUAL(orders("M0 0A9 4 30 1 0 4 2A9 4 30 0 0 0 0Z"), "33");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A2 1 31 0 1 0 0Z"), "00");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A2 1.1 30 0 1 0 0Z"), "00");
  BOOST_CHECK_EQUAL(orders("M0 0A2 1 30 0 1 4 2A2 1 30 0 0 0 0Z"), "00"); // back on itself
  // angles: 0 exactly, 180 exactly
  const auto angle = [](const std::string& text) {
    const Subpath path = GC::read_svg_path<Exact_2>(text)[0];
    return *GC::tangent_angle(path.segments[0], path.segments[1]);
  };
  BOOST_CHECK_EQUAL(angle("M0 0A2 1 30 0 1 4 2A2 1 30 0 1 0 0").upper, 0);
  const GC::Enclosure back = angle("M0 0A2 1 30 0 1 4 2A2 1 30 0 0 0 0");
  BOOST_CHECK(back.lower < std::acos(-1.) + 1e-15 && std::acos(-1.) - 1e-15 < back.upper &&
              back.upper - back.lower < 1e-15);
  // a curve with a handle at the node has no tangent
  const Subpath retracted = GC::read_svg_path<Exact_2>("M0 0A2 1 30 0 1 4 2C4 2 5 3 6 5")[0];
  BOOST_CHECK(!GC::continuity<Exact_2>(retracted.segments[0], retracted.segments[1])->regular);
  BOOST_CHECK(GC::visual_class<Exact_2>(retracted.segments[0], retracted.segments[1]) == GC::Visual_class::corner);
  const Subpath path = GC::read_svg_path<Exact_2>("M0 0A2 1 30 0 1 4 2A2 1 30 0 1 0 0")[0];
  const GC::Svg_transform<Exact_2> skew({Q(3), Q(1), Q(-2), Q(5), Q(7), Q(11)});
  BOOST_CHECK_EQUAL(
      GC::continuity<Exact_2>(path.segments[0].transform(skew), path.segments[1].transform(skew))->g_order, 3);
}

BOOST_AUTO_TEST_CASE(joins_of_arcs) {
  BOOST_CHECK_EQUAL(orders("M0 0h4a4 4 0 0 1 4 4v4a4 4 0 01-4 4h-4"), "1111");
  BOOST_CHECK_EQUAL(orders("M115,60A55,55,0,1,1,60,5,55,55,0,0,1,115,60Z"), "33");
  BOOST_CHECK_EQUAL(orders("M2 0a2 1 0 0 1-2 1 2 1 0 0 1-2-1 2 1 0 0 1 2-1 2 1 0 0 1 2 1z"), "3333");
  BOOST_CHECK_EQUAL(orders("M0 0A1 1 0 0 1 2 0A1 1 0 0 0 4 0"), "1"); // S shape
  BOOST_CHECK_EQUAL(orders("M0 0A1 1 0 0 1 2 0A1 1 0 0 1 4 0"), "0"); // cusp
  // centres that are not rational: D = 99, equal or opposite curvature, proved in the field with
  // the root of 99
  BOOST_CHECK_EQUAL(orders("M0 0A5 5 0 0 1 1 0A5 5 0 0 0 2 0"), "1");
  BOOST_CHECK_EQUAL(orders("M0 0A5 5 0 0 1 1 0A5 5 0 0 1 2 0"), "0");
  // D = 99 again, other curvature
  BOOST_CHECK_EQUAL(orders("M0 0A5 5 0 0 1 1 0A10 10 0 0 0 3 0"), "1");
  BOOST_CHECK_EQUAL(orders("M0 0A5 5 0 0 1 1 0L2 0"), "0");
  BOOST_CHECK_EQUAL(orders("M-1 0L0 0A5 5 0 0 1 1 0"), "0");
  // roots of 99 and 63: two extensions
  BOOST_CHECK_EQUAL(orders("M0 0A5 5 0 0 1 1 0A4 4 0 0 0 2 0"), "0");
  const std::vector<Subpath> s = GC::read_svg_path<Exact_2>("M0 0A5 5 0 0 1 1 0A5 5 0 0 0 2 0");
  const auto join = GC::continuity(s[0].segments[0], s[0].segments[1]);
  BOOST_CHECK(join->regular && *join->tangent_equal && *join->curvature_equal && !*join->curvature_vector_equal);
  const std::vector<Subpath> t = GC::read_svg_path<Exact_2>("M0 0A5 5 0 0 1 1 0A5 5 0 0 0 2 1");
  // with two different roots
  BOOST_CHECK(*GC::continuity(t[0].segments[0], t[0].segments[1])->curvature_equal);
}

// One ellipse cut at rational points: the arcs continue each other to any order.
BOOST_AUTO_TEST_CASE(random_arcs_of_one_ellipse) {
  std::mt19937 random(seed);
  for (int i = 0; i < 40; ++i) {
    const Q cx = random_rational(random), cy = random_rational(random), rx = 1 + abs(random_rational(random)),
            ry = 1 + abs(random_rational(random));
    const auto point = [&](const Q& t) { // t = tan(angle/2), within half a turn on either side
      return Point(cx + rx * (1 - t * t) / (1 + t * t), cy + ry * 2 * t / (1 + t * t));
    };
    const Q t[] = {Q(-1 - random_rational(random) * random_rational(random) / 1000000000), Q(1, 3), Q(2)};
    std::vector<Segment> segments;
    for (int j = 0; j < 2; ++j) {
      // of the angle between the points
      const Q sine_sign = (t[j + 1] - t[j]) * (1 + t[j] * t[j + 1]);
      const GC::Elliptical_arc_parameters<Q> parameters{rx, ry, Q(0), sine_sign < 0, true};
      segments.push_back({{GC::Elliptical_arc<Exact_2>(point(t[j]), point(t[j + 1]), parameters)}, j, 'A', 0});
      const GC::Curve_jet<Exact_2> x = *segments[j].arc()->end_jet(2);
      BOOST_REQUIRE_MESSAGE(x[2][0] == cx - x[0][0] && x[2][1] == cy - x[0][1], "seed " << seed << ", case " << i);
    }
    BOOST_CHECK_EQUAL(GC::continuity(segments[0], segments[1], 7)->g_order, 7);
    const Transform map = random_transform(random);
    BOOST_CHECK_EQUAL(GC::continuity(segments[0].transform(map), segments[1].transform(map), 7)->c_order, 7);
  }
}

BOOST_AUTO_TEST_CASE(handles_at_the_node) {
  // straight: a line, however the other handle lies between the ends
  BOOST_CHECK_EQUAL(read("M0 0C0 0 4 2 4 2"), "2C 0,0 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0C0 0 2 1 4 2"), "2C 0,0 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0C2 1 4 2 4 2"), "2C 0,0 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0Q0 0 4 2"), "2Q 0,0 4,2; |");
  BOOST_CHECK_EQUAL(orders("M0 0H4C4 0 9 0 9 0H12"), "33");
  // not straight, beyond an end, or with a tangent: as written
  BOOST_CHECK_EQUAL(read("M0 0C0 0 2 2 4 2"), "2C 0,0 0,0 2,2 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0C0 0 6 3 4 2"), "2C 0,0 0,0 6,3 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0C-2-1 4 2 4 2"), "2C 0,0 -2,-1 4,2 4,2; |");
  BOOST_CHECK_EQUAL(read("M0 0C1 0 2 0 3 0"), "2C 0,0 1,0 2,0 3,0; |");
  BOOST_CHECK_EQUAL(read("M0 0C0 0 1 0 0 0"), "2C 0,0 0,0 1,0 0,0; |");
  const std::vector<Subpath> curved = GC::read_svg_path<Exact_2>("M-1 0H0C0 0 2 2 4 2");
  BOOST_CHECK(!GC::continuity(curved[0].segments[0], curved[0].segments[1])->regular);
  // a segment of no length has no tangent
  BOOST_CHECK_EQUAL(orders("M0 0h1l0 0h1"), "00");
  BOOST_CHECK_EQUAL(orders("M0 0h1c0 0 0 0 0 0h1"), "00");
}

BOOST_AUTO_TEST_CASE(errors_have_a_place_and_a_reason) {
  check_refused("L1 1", 1, "does not begin with the command M");
  check_refused("  1 1", 3, "'1' where the command M is expected");
  check_refused("M", 2, "the end where a number is expected");
  check_refused("M1", 3, "the end where a number is expected");
  check_refused("M1 1 2", 7, "the end where a number is expected");
  check_refused("M1 1X", 5, "'X' is not a command");
  check_refused("M1 1 #", 6, "'#' where a command is expected");
  check_refused("M1 1Z2 2", 6, "'2' where a command is expected");
  check_refused("M,1 1", 2, "',' where a number is expected");
  check_refused("M1,,1", 4, "',' where a number is expected");
  check_refused("M1 1,L2 2", 5, "a comma where a number is expected");
  check_refused("M1 1 2 2,", 9, "a comma where a number is expected");
  check_refused("M1 1L2 --3", 8, "not a number: '-'");
  check_refused("M1 1L2 .", 8, "not a number: '.'");
  check_refused("M1 1L2 e5", 8, "'e' where a number is expected");
  check_refused("M1 1L2 1em", 9, "'e' is not a command");
  check_refused("M1 1L2 1e5000", 8, "decimal exponent beyond");
  check_refused("M1 1L2 1/2", 9, "'/' where a command is expected");
  check_refused("M1 1L2 nan", 8, "'n' where a number is expected");
  check_refused("M1 1A5 5 0 2 1 3 3", 12, "'2' where a flag");
  check_refused("M1 1A5 5 0 1", 13, "the end where a flag");
  check_refused("M1 1A5 5 2e9 0 1 3 3", 10, "an angle beyond");
  check_refused(std::string("M1 1\0", 5), 5, "'\\x00' where a command is expected");
  check_refused("M1 1\xC2\xA0L2 2", 5, "'\\xC2' where a command is expected");
  check_refused("M1 1L" + std::string(5000, '1') + " 1", 6, "number longer than 4096");
  check_refused("M1 1L" + std::string(4000, '1') + " 1", 6, "number of more than 1280 bits");
  check_refused("M1 1L1 1e-386", 8, "number of more than 1280 bits");
  check_refused("M1e200 1l1e-300 1", 10, "a coordinate of more than 1280 bits");
  check_refused("M1 1A1e300 1e-300 0 0 1 2 2", 27, "the sizes of an arc differ too much");
  check_refused("M1 1A1e308 1e308 0 0 1 2 2", 26, "the sizes of an arc differ too much");
  // the range of double
  read("M1e308 1.7976931348623157e308l-1e300 0Q5e-324 0 4.9406564584124654e-324 1");
  BOOST_CHECK(error([] {
                GC::read_svg_path<Exact_2>("M1 x", "a.svg:7: path");
              }).find("a.svg:7: path, character 4: 'x' where a number") != std::string::npos);
  BOOST_CHECK_THROW(GC::read_svg_path<Double_2>("M1e308 1l1e308 1"), GC::Error);
}

BOOST_AUTO_TEST_CASE(transforms) {
  const auto image = [](const std::string& list, const Point& p) {
    return text(GC::parse_svg_transform<Exact_2>(list)(p));
  };
  const Point p(3, 4);
  BOOST_CHECK_EQUAL(image("", p), "3,4");
  BOOST_CHECK_EQUAL(image("matrix(1 2 3 4 5 6)", p), "20,28");
  BOOST_CHECK_EQUAL(image("translate(.1)", p), "31/10,4");
  BOOST_CHECK_EQUAL(image("translate(1-2)", p), "4,2");
  BOOST_CHECK_EQUAL(image("scale(2)", p), "6,8");
  BOOST_CHECK_EQUAL(image(" scale ( 2 , .5 ) ", p), "6,2");
  BOOST_CHECK_EQUAL(image("rotate(90)", p), "-4,3");
  BOOST_CHECK_EQUAL(image("rotate(-90)", p), "4,-3");
  BOOST_CHECK_EQUAL(image("rotate(900)", p), "-3,-4");
  BOOST_CHECK_EQUAL(image("rotate(90,1,1)", p), "-2,3");
  BOOST_CHECK_EQUAL(image("skewX(45)", p), "7,4");
  BOOST_CHECK_EQUAL(image("skewX(-45)", p), "-1,4");
  BOOST_CHECK_EQUAL(image("skewY(135)", p), "3,1");
  // the last one first
  BOOST_CHECK_EQUAL(image("translate(10,0) scale(2)", p), "16,8");
  BOOST_CHECK_EQUAL(image("scale(2),translate(10,0)", p), "26,8");
  BOOST_CHECK_EQUAL(image("scale(2)translate(10,0)rotate(90)", p), "12,6");
  // other angles: a rotation exactly, by nearly the angle; tan() and cos() are within a few ulp of
  // double
  for (const char* angle : {"30", "-12.5", "44.999", "45", "46", "100", "179.9", "-91", "720.5"}) {
    const Transform map = GC::parse_svg_transform<Exact_2>("rotate(" + std::string(angle) + ")");
    const std::array<Q, 6>& m = map.matrix();
    BOOST_CHECK(m[0] * m[0] + m[1] * m[1] == 1 && m[2] == -m[1] && m[3] == m[0]);
    const double radians = std::stod(angle) * std::acos(-1.0) / 180;
    BOOST_CHECK_SMALL(CGAL::to_double(m[0]) - std::cos(radians), 1e-14);
    BOOST_CHECK_SMALL(CGAL::to_double(m[1]) - std::sin(radians), 1e-14);
  }
  for (const char* angle : {"30", "-60", "100", "-179"}) {
    const double t = std::tan(std::stod(angle) * std::acos(-1.0) / 180);
    const Transform map = GC::parse_svg_transform<Exact_2>("skewX(" + std::string(angle) + ")");
    BOOST_CHECK_SMALL(CGAL::to_double(map.matrix()[2]) / t - 1, 1e-14);
  }
  const auto refused = [](const std::string& list) { return error([&] { GC::parse_svg_transform<Exact_2>(list); }); };
  BOOST_CHECK_EQUAL(refused("scale(1) turn(3)"), "malformed_input: transform, character 10: 'turn' is not a transform");
  BOOST_CHECK_EQUAL(refused("skewX(90)"), "malformed_input: transform, character 7: a skew by a right angle");
  BOOST_CHECK_EQUAL(refused("scale(1"), "malformed_input: transform, character 8: the end where ')' is expected");
  for (const char* list :
       {"scale", "scale()", "scale(1,2,3)", "matrix(1 2 3 4 5)", "rotate(1 2)", "skewX(1 2)", "scale(1),", "scale(1,)",
        ",scale(1)", "rotate(30deg)", "matrix(1 2 3 4 5 6 7)", "3", "rotate(1e10)"})
    BOOST_CHECK_NE(refused(list), "no error");
}

// A list of rotations about one centre is one rotation, however long.
BOOST_AUTO_TEST_CASE(rotations_about_one_centre_are_one) {
  const auto map = [](const std::string& list) { return GC::parse_svg_transform<Exact_2>(list).matrix(); };
  const auto repeated = [](const std::string& s, int n) {
    std::string result;
    for (int i = 0; i < n; ++i) result += s;
    return result;
  };
  BOOST_CHECK(map("rotate(30)rotate(60)") == map("rotate(90)"));
  BOOST_CHECK(map("rotate(1)rotate(2),rotate(3)") == map("rotate(6)"));
  BOOST_CHECK(map("rotate(350)rotate(20)") == map("rotate(10)"));
  BOOST_CHECK(map("rotate(30 1 2)rotate(60 1 2)") == map("rotate(90 1 2)"));
  BOOST_CHECK(map("rotate(30)rotate(-30)") == map(""));
  BOOST_CHECK(map(repeated("rotate(1)", 4000)) == map("rotate(40)"));
  BOOST_CHECK(map(repeated("rotate(1e9)", 1000)) == map("rotate(280)")); // 10^12 degrees
  // in their places among the others
  BOOST_CHECK(map("rotate(30)rotate(60)scale(2,3)rotate(90)") == map("rotate(90)scale(2,3)rotate(90)"));
  BOOST_CHECK(map("scale(2,3)rotate(45)rotate(45)") == map("scale(2,3)rotate(90)"));
  BOOST_CHECK(map("rotate(90 1 2)rotate(90 3 4)") ==
              (Transform(map("rotate(90 1 2)")) * Transform(map("rotate(90 3 4)"))).matrix());
  BOOST_CHECK(map("rotate(10 1 2)rotate(10)") ==
              (Transform(map("rotate(10 1 2)")) * Transform(map("rotate(10)"))).matrix());
  BOOST_CHECK_EQUAL(GC::parse_svg_transform<Double_2>("rotate(30)rotate(60)").matrix()[0], 0);
}

// Products are exact as long as their numbers are short; longer ones are rounded, and do not grow
// with the list.
BOOST_AUTO_TEST_CASE(products_of_transforms_stay_short) {
  const std::vector<Subpath> path =
      GC::read_svg_path<Exact_2>("M0 0C1 2 3 3 5 3S7 4 9 2Q10 1 12 3T15 0A5 5 0 0 1 16 0");
  const Transform step = GC::parse_svg_transform<Exact_2>("translate(1,2)rotate(10)scale(.9)");
  Transform product;
  const auto length = [](const Transform& map) {
    std::size_t n = 0;
    for (const Q& x : map.matrix()) n = (std::max)(n, text(x).size());
    return n;
  };
  std::size_t longest = 0;
  for (int i = 1; i <= 500; ++i) {
    product = product * step;
    longest = (std::max)(longest, length(product));
    BOOST_REQUIRE_LE(longest, 2u * 309 + 2); // p/q in decimal digits
    const double radians = std::acos(-1.0) / 18 * i, scale = std::pow(.9, i);
    BOOST_CHECK_CLOSE_FRACTION(CGAL::to_double(product.determinant()) / (scale * scale), 1, 1e-11);
    BOOST_CHECK_SMALL(CGAL::to_double(product.matrix()[0]) / scale - std::cos(radians), 1e-11);
    if (i % 50 == 0) BOOST_CHECK_EQUAL(orders(path[0].transform(product)), orders(path[0]));
  }
  BOOST_CHECK_GT(longest, 300u);
  // short ones are exact
  const Transform third({Q(1, 3), 0, 0, Q(1, 7), 0, Q(1, 11)});
  Transform power;
  Q a(1), d(1);
  for (int i = 0; i < 300; ++i, a /= 3, d /= 7) {
    BOOST_CHECK(power.matrix()[0] == a && power.matrix()[3] == d);
    power = power * third;
  }
  // what rounding would make singular is refused, and so is what floating point cannot hold
  const auto refused = [](const std::string& list) { return error([&] { GC::parse_svg_transform<Exact_2>(list); }); };
  const std::string tiny = "scale(1e-300)";
  BOOST_CHECK_EQUAL(refused(tiny + ' ' + tiny), "malformed_input: transform, character 21: work_limit: Svg_transform: "
                                                "numbers of more than 1024 bits");
  BOOST_CHECK_NE(refused("scale(1e300)scale(1e300)"), "no error");
  BOOST_CHECK_EQUAL(refused("scale(1e-386)"), "malformed_input: transform, character 7: number of more than 1280 bits: "
                                              "'1e-386'");
  BOOST_CHECK_NE(refused("scale(" + std::string(4096, '1') + ")"), "no error");
}

BOOST_AUTO_TEST_CASE(orders_are_the_same_after_any_transform) {
  std::mt19937 random(seed);
  const std::vector<Subpath> paths = GC::read_svg_path<Exact_2>(
      "M0 0C1 2 3 3 5 3S7 4 9 2Q10 1 12 3T15 0A5 5 0 0 1 16 0A5 5 0 0 0 17 0L17 1ZM2 0a2 1 0 "
      "0 1-2 1 2 1 0 0 1-2-1h-1c0 0 1 1 1 2");
  BOOST_REQUIRE_EQUAL(paths.size(), 2u);
  BOOST_CHECK_EQUAL(orders(paths[0]), "11101000");
  BOOST_CHECK_EQUAL(orders(paths[1]), "300");
  for (int i = 0; i < 20; ++i) {
    const Transform map = random_transform(random);
    for (const Subpath& path : paths)
      BOOST_CHECK_MESSAGE(orders(path.transform(map)) == orders(path), "seed " << seed << ", case " << i);
  }
}

BOOST_AUTO_TEST_CASE(basic_shapes) {
  BOOST_CHECK_EQUAL(text({GC::svg_line<Exact_2>(1, 2, 3, 4)}), "2L 1,2 3,4; |");
  BOOST_CHECK_EQUAL(text({GC::read_svg_polyline<Exact_2>(" 1 2 3,4-5-6")}), "2L 1,2 3,4; 3L 3,4 -5,-6; |");
  BOOST_CHECK_EQUAL(text({GC::read_svg_polygon<Exact_2>("1 2 3,4")}), "2L 1,2 3,4; 3Z 3,4 1,2; Z");
  BOOST_CHECK_EQUAL(text({GC::read_svg_polygon<Exact_2>("")}), "|");
  BOOST_CHECK_NE(error([] { GC::read_svg_polygon<Exact_2>("1 2 3"); }), "no error");
  BOOST_CHECK_NE(error([] { GC::read_svg_polygon<Exact_2>("1 2 x"); }), "no error");
  BOOST_CHECK_EQUAL(text({GC::svg_rectangle<Exact_2>(1, 2, 4, 6, 0, 3)}),
                    "2L 1,2 5,2; 3L 5,2 5,8; 4L 5,8 1,8; 5Z 1,8 1,2; Z");
  BOOST_CHECK_EQUAL(
      text({GC::svg_rectangle<Exact_2>(0, 0, 4, 6, 1, 2)}),
      "2L 1,0 3,0; 3A arc 3,0 4,2; 4L 4,2 4,4; 5A arc 4,4 3,6; 6L 3,6 1,6; 7A arc 1,6 0,4; 8L 0,4 0,2; 9A "
      "arc 0,2 1,0; Z");
  BOOST_CHECK_EQUAL(orders(GC::svg_rectangle<Exact_2>(0, 0, 4, 6, 1, 2)), "11111111");
  BOOST_CHECK_EQUAL(orders(GC::svg_rectangle<Exact_2>(0, 0, 4, 6, 9, 9)), "3333");   // an ellipse
  BOOST_CHECK_EQUAL(orders(GC::svg_rectangle<Exact_2>(0, 0, 4, 6, 2, 2)), "113113"); // semicircles
  BOOST_CHECK_EQUAL(orders(GC::svg_ellipse<Exact_2>(1, 2, 3, 4)), "3333");
  BOOST_CHECK(GC::svg_ellipse<Exact_2>(1, 2, 0, 4).segments.empty());
  BOOST_CHECK(GC::svg_rectangle<Exact_2>(1, 2, 0, 4, 0, 0).segments.empty());
  BOOST_CHECK_NE(error([] { GC::svg_ellipse<Exact_2>(1, 2, -1, 4); }), "no error");
  BOOST_CHECK_NE(error([] { GC::svg_rectangle<Exact_2>(0, 0, 4, 6, -1, 2); }), "no error");
}

BOOST_AUTO_TEST_CASE(in_double) {
  const auto path = GC::read_svg_path<Double_2>("M0 0h4a4 4 0 0 1 4 4M0 0A5 5 0 0 1 1 0");
  BOOST_CHECK_EQUAL(GC::continuity(path[0].segments[0], path[0].segments[1])->g_order, 1);
  // the centre is (1/2, -+sqrt(99)/2), up to a few roundings
  BOOST_CHECK_CLOSE(path[1].segments[0].arc()->start_jet(2)->operator[](2)[1], std::sqrt(99.0) / 2, 1e-12);
}

BOOST_AUTO_TEST_CASE(the_locale_does_not_matter) {
  const std::locale old = std::locale::global(continental());
  const std::string path = read("M1.5,2.5 1234567.5 0"),
                    map = text(GC::parse_svg_transform<Exact_2>("scale(1.5,2)")(Point(1, 1)));
  const std::string message = error([] { read("M" + std::string(2000, ' ')); });
  std::locale::global(old);
  BOOST_CHECK_EQUAL(path, "2L 3/2,5/2 2469135/2,0; |");
  BOOST_CHECK_EQUAL(map, "3/2,2");
  BOOST_CHECK(contains(message, "character 2002:"));
}

// Random paths are written in random spellings and read back: every control point is the same.
BOOST_AUTO_TEST_CASE(random_round_trips) {
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    std::string data = "M", expected;
    // with a separator only where it is needed
    const auto number = [&](const std::string& decimal, bool first) {
      const char c = decimal[0];
      const bool glued =
          first || c == '-' ||
          (c == '.' && data.find_first_of(".e", data.find_last_of("+- ,McLlQqCHhVv")) != std::string::npos);
      if (!glued || random() % 2 == 0) data += !first && random() % 2 == 0 ? "," : " ";
      data += decimal;
      return GC::parse_number<Q>(decimal);
    };
    Q x = number(random_decimal(random), true), y = number(random_decimal(random), false);
    const int commands = 1 + static_cast<int>(random() % 8);
    for (int n = 2; n < 2 + commands; ++n) {
      const char letter = "LlCcQqHhVv"[random() % 10];
      const bool relative = letter >= 'a';
      const Q ox = relative ? x : Q(0), oy = relative ? y : Q(0);
      data += letter;
      expected += std::to_string(n) + letter + ' ' + text(Point(x, y));
      const int points = letter == 'C' || letter == 'c' ? 3 : letter == 'Q' || letter == 'q' ? 2 : 1;
      for (int j = 0; j < points; ++j) {
        const bool vertical = letter == 'V' || letter == 'v', horizontal = letter == 'H' || letter == 'h';
        if (!vertical) x = ox + number(random_decimal(random), j == 0);
        if (!horizontal) y = oy + number(random_decimal(random), j == 0 && vertical);
        expected += ' ' + text(Point(x, y));
      }
      expected += "; ";
    }
    BOOST_CHECK_MESSAGE(read(data) == expected + '|', "seed " << seed << ": " << data << "\n"
                                                              << read(data) << "\n"
                                                              << expected);
  }
}

BOOST_AUTO_TEST_CASE(rational_square_roots) {
  std::mt19937 random(seed);
  BOOST_CHECK(GC::rational_square_root(Q(0)) == Q(0));
  for (int i = 0; i < 100; ++i) {
    const Q x = 1 + abs(random_rational(random)), square = x * x, other = square * 2;
    BOOST_CHECK(GC::rational_square_root(square) == x);
    BOOST_CHECK(!GC::rational_square_root(other));
  }
}

BOOST_AUTO_TEST_CASE(lengths) {
  const auto length = [](const std::string& text) { return GC::parse_svg_length<Q>(text, "x"); };
  BOOST_CHECK(length(" 1.5 ") == Q(3, 2));
  BOOST_CHECK(length("-2px") == Q(-2));
  BOOST_CHECK(length("1in") == Q(96));
  BOOST_CHECK(length("2.54cm") == Q(96));
  BOOST_CHECK(length("1e1mm\n") == Q(4800, 127));
  BOOST_CHECK(length("3pt") == Q(4));
  BOOST_CHECK(length("1pc") == Q(16));
  BOOST_CHECK(length("101.6Q") == Q(96) && length("1IN") == Q(96));
  for (const char* relative :
       {"%", "em", "ex", "ch", "ic", "rem", "lh", "vw", "vh", "vi", "vb", "vmin", "vmax", "EM"}) {
    BOOST_CHECK(!length("1" + std::string(relative)));
    BOOST_CHECK(!length(" 1e3" + std::string(relative) + '\n'));
  }
  BOOST_CHECK_EQUAL(GC::parse_svg_length<double>("0.5in").value(), 48);
  const auto message = [&](const std::string& text) { return error([&] { length(text); }); };
  BOOST_CHECK_EQUAL(message("1m"), "malformed_input: x, character 1: 'm' is not a unit of length");
  BOOST_CHECK_EQUAL(message("1junk2px"), "malformed_input: x, character 1: 'junk2px' is not a unit of length");
  BOOST_CHECK_EQUAL(message("1 2px"), "malformed_input: x, character 1: ' 2px' is not a unit of length");
  BOOST_CHECK_EQUAL(message("1,"), "malformed_input: x, character 1: ',' is not a unit of length");
  for (const char* text : {"",    " ",      "px",    "1 2", "1 px",  "1 %", "1,px", "1pxx", "1px2", "1px px",
                           "nan", "1e9999", "1e386", "1e",  "1e+px", "1/2", "--1",  "+-1",  ".",    "1..2"})
    BOOST_CHECK_NE(message(text), "no error");
  BOOST_CHECK_NE(error([] { GC::parse_svg_length<double>("1e308in"); }), "no error");
}

// The jets at the ends of segments of each kind, in the field and in an extension of it.
BOOST_AUTO_TEST_CASE(jets_at_the_ends_of_segments) {
  const std::vector<Subpath> path = GC::read_svg_path<Exact_2>("M0 0C1 2 3 4 5 6A5 5 0 0 1 6 6");
  const Segment &cubic = path[0].segments[0], &circle = path[0].segments[1];
  BOOST_CHECK(cubic.is_known() && cubic.radicand() == 0);
  BOOST_CHECK((cubic.start_jet_over<Q>(2, Q(0)) == cubic.bezier()->start_jet(2)));
  BOOST_CHECK((cubic.end_jet_over<Q>(2, Q(0)) == cubic.bezier()->end_jet(2)));
  BOOST_CHECK(circle.is_known() && circle.has_length() && cubic.has_length());
  BOOST_CHECK_EQUAL(circle.radicand(), 99);
  typedef CGAL::Sqrt_extension<Q, Q> Field;
  const Field root(Q(0), Q(1), Q(99));
  const auto start = circle.start_jet_over<Field>(2, root), end = circle.end_jet_over<Field>(2, root);
  for (const auto& x : {start, end}) // on the circle of radius 5 around x + x''
    BOOST_CHECK(x[2][0] * x[2][0] + x[2][1] * x[2][1] == Field(25));
  BOOST_CHECK(start[0][0] + start[2][0] == end[0][0] + end[2][0] && start[0][1] + start[2][1] == end[0][1] + end[2][1]);
  BOOST_CHECK(!GC::read_svg_path<Exact_2>("M0 0A5 4 30 0 1 5 5")[0].segments[0].is_known());
}

BOOST_AUTO_TEST_CASE(what_is_no_arc_is_refused) {
  typedef GC::Elliptical_arc<Exact_2> Arc;
  const Point p(0, 0), q(1, 0);
  CHECK_ERROR((Arc(p, p, {1, 1})), zero_direction);
  CHECK_ERROR((Arc(p, q, {0, 1})), parameter_outside_domain);
  CHECK_ERROR((Arc(p, q, {1, 0})), parameter_outside_domain);
  CHECK_ERROR((Arc(p, q, {1, 2, Q(1000000001)})), parameter_outside_domain);
  const Arc unknown(p, q, {1, 2, 30});
  CHECK_ERROR((unknown.start_jet_over<Q>(1, Q(0))), parameter_outside_domain);
  CHECK_ERROR((unknown.end_jet_over<Q>(1, Q(0))), parameter_outside_domain);
  CHECK_ERROR((Arc(p, q, {1, 1}).start_jet_over<Q>(-1, Q(0))), negative_count);
  const Segment line = GC::svg_line<Exact_2>(0, 0, 1, 1).segments[0];
  CHECK_ERROR((line.end_jet_over<Q>(-1, Q(0))), negative_count);
  CHECK_ERROR((GC::continuity(line, line, -1)), negative_count);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_refused) {
  typedef GC::Elliptical_arc<Double_2> Arc;
  const Double_2::Point p(0, 0), q(1, 0);
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    CHECK_ERROR((Arc(p, Double_2::Point(bad, 0), {1, 1})), not_finite);
    CHECK_ERROR((Arc(Double_2::Point(0, bad), q, {1, 1})), not_finite);
    CHECK_ERROR((Arc(p, q, {bad, 1})), not_finite);
    CHECK_ERROR((Arc(p, q, {1, bad})), not_finite);
    CHECK_ERROR((Arc(p, q, {1, 2, bad})), not_finite);
    CHECK_ERROR((GC::Svg_transform<Double_2>({1, 0, 0, 1, 0, bad})), not_finite);
    CHECK_ERROR((GC::svg_line<Double_2>(0, 1, bad, 3)), not_finite);
    CHECK_ERROR((GC::svg_ellipse<Double_2>(0, 1, bad, 3)), not_finite);
    CHECK_ERROR((GC::svg_rectangle<Double_2>(0, 1, bad, 3, 0, 0)), not_finite);
    CHECK_ERROR((GC::svg_rectangle<Double_2>(0, 1, 2, 3, 0, bad)), not_finite);
  }
  // sizes that differ so much that of lambda, 1/lambda, k_x or k_y nothing is left
  CHECK_ERROR((Arc(p, q, {1e200, 1e200})), parameter_outside_domain);
  CHECK_ERROR((Arc(p, q, {1e155, 1e155})), parameter_outside_domain);
  CHECK_ERROR((Arc(p, {1, 1}, {1e200, 1e-200})), parameter_outside_domain);
  CHECK_ERROR((Arc(p, {1, 1}, {1e-200, 1e200})), parameter_outside_domain);
  CHECK_ERROR((GC::parse_svg_transform<Double_2>("scale(1e200)scale(1e200)")), not_finite);
  // sums beyond the largest number are found where they stand
  const auto message = [](const char* data) { return error([&] { GC::read_svg_path<Double_2>(data); }); };
  for (const char* data : {"M1e308 0l1e308 0", "M1e308 0h1e308", "M-1e308-1e308Q1e308 0 1e308 1T0 0"})
    BOOST_CHECK_MESSAGE(message(data).find("path data, character ") != std::string::npos &&
                            message(data).find("outside the range") != std::string::npos,
                        data << ": " << message(data));
  BOOST_CHECK(message("M0 0A1e200 1e200 0 0 1 1 0").find("path data, character ") != std::string::npos);
}

// An arc of any size is that of size 1, scaled: by powers of two exactly.
BOOST_AUTO_TEST_CASE(arcs_of_all_sizes) {
  typedef GC::Elliptical_arc<Double_2> Arc;
  // around the origin
  const auto quarter = [](double r) { return Arc({0, r}, {-r, 0}, {r, r, 0, false, true}); };
  const auto half = [](double r) { return Arc({3 * r, r}, {-3 * r, -r}, {2 * r, r}); };
  BOOST_CHECK(*quarter(2).start_jet(2) == (GC::Curve_jet<Double_2>({0, 2}, {{-2, 0}, {0, -2}})));
  for (const double size : {0x1p-900, 0x1p-600, 0x1p600, 0x1p900})
    for (const auto& [arc, scaled] : {std::pair(quarter(2), quarter(2 * size)), std::pair(half(2), half(2 * size))})
      for (int j = 0; j <= 3; ++j) {
        BOOST_CHECK(size * (*arc.start_jet(3))[j] == (*scaled.start_jet(3))[j]);
        BOOST_CHECK(size * (*arc.end_jet(3))[j] == (*scaled.end_jet(3))[j]);
      }
}

// Arcs with rational ends as rational curves: on all four arcs of an ellipse through two points,
// and on its halves.
BOOST_AUTO_TEST_CASE(arcs_are_rational_curves) {
  const auto on_ellipse = [](const GC::Rational_bezier_curve<Exact_2, 2>& c, const Exact_2::Point& centre, const Q& rx,
                             const Q& ry) {
    for (int i = 0; i <= 8; ++i) {
      const Exact_2::Vector x = c(Q(i) / 8) - centre;
      if (x.x() * x.x() / (rx * rx) + x.y() * x.y() / (ry * ry) != 1) return false;
    }
    return true;
  };
  for (const std::string flags : {"0 0", "0 1", "1 0", "1 1"})
    for (const std::string radii : {"5 10", "4 7"}) {
      const GC::Elliptical_arc<Exact_2> a = arc("M0 0A" + radii + " 0 " + flags + " 8 0");
      const GC::Rational_bezier_curve<Exact_2, 2> c = *a.curve();
      BOOST_CHECK(c.start_jet(0).point() == a.start() && c.end_jet(0).point() == a.end());
      BOOST_CHECK(GC::continuity(GC::Curve_jet<Exact_2>(c.start_jet(4)), *a.start_jet(4)).g_order == 4);
      BOOST_CHECK(GC::continuity(GC::Curve_jet<Exact_2>(c.end_jet(4)), *a.end_jet(4)).g_order == 4);
      const bool half = radii == "4 7";
      const int side = flags == "0 0" || flags == "1 1" ? 1 : -1; // of the centre
      BOOST_CHECK(on_ellipse(c, Exact_2::Point(4, half ? Q(0) : Q(-6 * side)), half ? 4 : 5, half ? 7 : 10));
      BOOST_CHECK_EQUAL(c.weight(1) < 0, !half && flags[0] == '1');
    }
  const GC::Elliptical_arc<Exact_2> irrational = arc("M0 0A5 5 0 0 0 7 0"); // its centre is
  BOOST_CHECK(irrational.is_known() && !irrational.is_rational() && !irrational.curve());
  BOOST_CHECK(!irrational.start_jet(1) && !irrational.end_jet(1));
}

// Where commands and numbers stand.
BOOST_AUTO_TEST_CASE(places) {
  const std::string data = " M0,0 1.5-2e1h.5.5zm 3 , 4a1 2 3 01.5 6\nC 1 2,3 4 5 6";
  GC::Svg_path_places places;
  GC::Svg_path_reader<Exact_2> reader(data, "path data", &places);
  const auto texts = [&](std::size_t command) {
    std::string s;
    const std::size_t end =
        command + 1 < places.commands.size() ? places.commands[command + 1].first_number : places.numbers.size();
    for (std::size_t k = places.commands[command].first_number; k < end; ++k)
      s += data.substr(places.numbers[k].begin, places.numbers[k].end - places.numbers[k].begin) + ' ';
    return s;
  };
  const auto first = reader.next();
  BOOST_CHECK_EQUAL(first->segments.size(), 4u);
  BOOST_CHECK_EQUAL(places.commands.size(), 5u);
  BOOST_CHECK_EQUAL(texts(0) + '|' + texts(1) + '|' + texts(2) + '|' + texts(3) + '|' + texts(4),
                    "0 0 |1.5 -2e1 |.5 |.5 |");
  BOOST_CHECK(places.commands[0].is_given && !places.commands[1].is_given && !places.commands[3].is_given);
  BOOST_CHECK_EQUAL(places.commands[1].letter, 'L');
  for (const auto& segment : first->segments)
    BOOST_CHECK_EQUAL(segment.place, places.commands[static_cast<std::size_t>(segment.command - 1)].begin);
  BOOST_CHECK_EQUAL(data[first->segments[1].place], 'h');
  places.forget_before(6);
  BOOST_CHECK(places.commands.empty() && places.numbers.empty());
  const auto second = reader.next();
  BOOST_CHECK_EQUAL(second->segments.size(), 2u);
  BOOST_CHECK_EQUAL(second->segments[0].command, 7);
  BOOST_CHECK_EQUAL(texts(0) + '|' + texts(1) + '|' + texts(2), "3 4 |1 2 3 0 1 .5 6 |1 2 3 4 5 6 ");
  places.forget_before(8);
  BOOST_CHECK_EQUAL(texts(0), "1 2 3 4 5 6 ");
}

BOOST_AUTO_TEST_CASE(segments_of_no_length) {
  GC::Svg_subpath<Exact_2> s = GC::read_svg_path<Exact_2>("M0 0h1h0c0 0 0 0 0 0v1l0 0z").at(0);
  BOOST_CHECK_EQUAL(s.segments.size(), 6u);
  s.leave_out_points();
  BOOST_CHECK_EQUAL(s.segments.size(), 3u);
  BOOST_CHECK_EQUAL(s.left_out, 3u);
  BOOST_CHECK(s.segments[0].end() == s.segments[1].start());
  s = GC::read_svg_path<Exact_2>("M0 0c1 1 2 2 0 0").at(0); // there and back
  s.leave_out_points();
  BOOST_CHECK_EQUAL(s.left_out, 0u);
}

// After an error there is what its subpath draws before the command.
BOOST_AUTO_TEST_CASE(paths_up_to_an_error) {
  const auto before_error = [](const std::string& data) {
    GC::Svg_path_reader<Exact_2> reader(data);
    std::string s;
    try {
      while (const std::optional<Subpath> subpath = reader.next()) s += text({*subpath});
      return s + "no error";
    } catch (const GC::Error&) {
      const std::optional<Subpath> rest = reader.before_error();
      return s + '!' + (rest ? text({*rest}) : "");
    }
  };
  BOOST_CHECK_EQUAL(before_error("M0 0L1 1 2"), "!2L 0,0 1,1; |");
  BOOST_CHECK_EQUAL(before_error("M0 0h1zM2 2h1 X"), "2h 0,0 1,0; 3z 1,0 0,0; Z!5h 2,2 3,2; |");
  BOOST_CHECK_EQUAL(before_error("M0 0h1M"), "!2h 0,0 1,0; |");
  BOOST_CHECK_EQUAL(before_error("M0 0C1 1 2 2 3"), "!");
  BOOST_CHECK_EQUAL(before_error("M0 0h1zx"), "2h 0,0 1,0; 3z 1,0 0,0; Z!");
  BOOST_CHECK_EQUAL(before_error("x"), "!");
  std::string reason;
  BOOST_CHECK_EQUAL(text({GC::read_svg_polygon<Exact_2>("0 0 1 0 1 1 2", "points", &reason)}),
                    "2L 0,0 1,0; 3L 1,0 1,1; |");
  BOOST_CHECK_EQUAL(reason, "points, character 14: the end where a number is expected");
  reason.clear();
  BOOST_CHECK_EQUAL(text({GC::read_svg_polygon<Exact_2>("0 0 1 0", "points", &reason)}), "2L 0,0 1,0; 3Z 1,0 0,0; Z");
  BOOST_CHECK_EQUAL(reason, "");
}

// A transform of CSS is that of SVG with the same numbers; getCTM() of a browser gives these, too.
BOOST_AUTO_TEST_CASE(transforms_of_css) {
  const GC::Svg_viewport<Q> viewport{Q(40), Q(20)}, unknown;
  const auto css = [&](const std::string& list) {
    return GC::parse_css_transform<Exact_2>(list, "t", viewport).matrix();
  };
  const auto svg = [](const std::string& list) { return GC::parse_svg_transform<Exact_2>(list).matrix(); };
  BOOST_CHECK(css(" rotate( 30DEG )rotate(60deg) ") == svg("rotate(90)"));
  BOOST_CHECK(css("translate(50%,10%) translateX(-1in)") == svg("translate(20 2)translate(-96)"));
  BOOST_CHECK(css("scale(50%) scaleY(2)") == svg("scale(.5)scale(1 2)"));
  BOOST_CHECK(css("skew(45deg, -45deg) skewY(10deg)") == svg("matrix(1 -1 1 1 0 0)skewY(10)"));
  BOOST_CHECK(css("matrix(1,2,3,4,5,6)") == svg("matrix(1 2 3 4 5 6)"));
  for (const char* bad :
       {"", "scale", "scale(", "scale(1 2)", "scale(1,2,3)", "scale(1px)", "translate(1)", "rotate(1)", "rotate(1x)",
        "skewX(90deg)", "rotateX(1deg)", "translate(calc(1px))", "scale(1) x", "translate(1em)", "scale(1,)"})
    BOOST_CHECK_MESSAGE(error([&] { css(bad); }).find("malformed_input: t") == 0, bad);
  BOOST_CHECK_NE(error([&] { GC::parse_css_transform<Exact_2>("translate(1%)", "t", unknown); }), "no error");
  const auto origin = [&](const std::string& s) {
    const std::array<Q, 2> p = GC::parse_css_origin<Q>(s, "o", viewport, GC::Css_units::needed);
    return text(Point(p[0], p[1]));
  };
  BOOST_CHECK_EQUAL(origin("10% 1px") + ' ' + origin("TOP") + ' ' + origin("bottom right") + ' ' + origin("3px") + ' ' +
                        origin("0 0 0"),
                    "4,1 20,0 40,20 3,10 0,0");
  for (const char* bad : {"", "1 1", "left right", "top bottom", "0 0 1px", "x"})
    BOOST_CHECK_NE(error([&] { origin(bad); }), "no error");
}

BOOST_AUTO_TEST_CASE(view_boxes) {
  const Transform map = GC::svg_view_box_map<Exact_2>(GC::parse_svg_view_box<Q>("5,5,10,10"),
                                                      GC::parse_svg_aspect_ratio("xMaxYMid meet"), 30, 20);
  BOOST_CHECK_EQUAL(text(map(Point(5, 5))) + ' ' + text(map(Point(15, 15))), "10,0 30,20");
  for (const char* bad : {"xMidYmid", "xMid", "xMidYMid meet slice", "xMidYMid fit", "", "defer xMidYMid", "XMidYMid"})
    BOOST_CHECK_NE(error([&] { GC::parse_svg_aspect_ratio(bad); }), "no error");
  for (const char* bad : {"", "1 2 3", "1 2 3 4 5", "1 2 3 4,", "1 2 -3 4", "1 2 3 4px"})
    BOOST_CHECK_NE(error([&] { GC::parse_svg_view_box<Q>(bad); }), "no error");
}

// Corners, kinks and angles between the segments of paths.
BOOST_AUTO_TEST_SUITE(grades)

const double degree = std::acos(-1.) / 180;

// The join of the first two segments.
template <class Traits = Exact_2>
std::string grade(const std::string& path, const GC::Corner_threshold& bound = GC::Corner_threshold()) {
  const GC::Svg_subpath<Traits> s = GC::read_svg_path<Traits>(path).at(0);
  const std::optional<GC::Visual_class> g = GC::visual_class(s.segments.at(0), s.segments.at(1), bound);
  return g ? to_string(*g) : "undefined";
}
std::optional<GC::Enclosure> angle(const std::string& path) {
  const GC::Svg_subpath<Exact_2> s = GC::read_svg_path<Exact_2>(path).at(0);
  return GC::tangent_angle(s.segments.at(0), s.segments.at(1));
}

BOOST_AUTO_TEST_CASE(curves) {
  BOOST_CHECK_EQUAL(grade("M0 0h1v1"), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0h1v1", GC::Corner_threshold(90)), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0h1l100 1"), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0h1c1 0 2 1 3 3"), "G1");
  BOOST_CHECK_EQUAL(grade("M0 0h1c1 0 2 0 3 3"), "G2");
  BOOST_CHECK_EQUAL(grade("M0 0h1h1"), "G2");
  BOOST_CHECK_EQUAL(grade("M0 0h1h-1"), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0h1c0 0 2 0 3 3"), "G1");
  BOOST_CHECK_EQUAL(grade("M0 0h1c0 0 0 2 3 3"), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0h1h0"), "undefined");
  BOOST_CHECK(!angle("M0 0h1h0"));
  BOOST_CHECK(*angle("M0 0h1h7") == (GC::Enclosure{0, 0}));
  BOOST_CHECK_CLOSE(angle("M0 0h1v1")->lower, 90 * degree, 1e-12);
  BOOST_CHECK_CLOSE(angle("M0 0h1c0 0 0 2 3 3")->lower, 90 * degree, 1e-12);
  const GC::Svg_subpath<Exact_2> x = GC::read_svg_path<Exact_2>("M0 0h1v1").at(0),
                                 y = GC::read_svg_path<Exact_2>("M5 5A1 1 0 0 1 6 6").at(0);
  BOOST_CHECK(GC::visual_class(x.segments[0], y.segments[0]) == GC::Visual_class::gap);
  BOOST_CHECK(GC::visual_class(x.segments[1], x.segments[0]) == GC::Visual_class::gap);
}

BOOST_AUTO_TEST_CASE(arcs) {
  // a quarter of a circle, and the tangent and other lines at its end
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1v1"), "G1");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1l1 100"), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1h1"), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1v-1"), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1a1 1 0 0 1 -1 1"), "G2");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1a2 2 0 0 1 -2 2"), "G1");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1c0 0 0 2 1 2"), "G1"); // a handle at the node
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 1h0"), "undefined");
  // an ellipse with its axes turned by 30 degrees
  BOOST_CHECK_EQUAL(grade("M0 0a3 4 30 0 1 1 1h1"), "corner");
  BOOST_CHECK_CLOSE(angle("M0 0a3 4 30 0 1 1 1h1")->lower, 61.62596896642784 * degree, 1e-12);
  // with one square root and with two: a sixth of a circle, 30 degrees from its chord on both sides
  const Q little = Q(1) / Q(1e60);
  BOOST_CHECK_EQUAL(grade("M0 0h1a1 1 0 0 1 1 0", GC::Corner_threshold(30)), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0h1a1 1 0 0 1 1 0", GC::Corner_threshold(30 - little)), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 0a1 1 0 0 1 1 0", GC::Corner_threshold(60)), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 0a1 1 0 0 1 1 0", GC::Corner_threshold(60 - little)), "corner");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 0a1 1 0 0 0 1 0"), "G1");
  BOOST_CHECK_EQUAL(grade("M0 0a1 1 0 0 1 1 0a1 1 0 0 1 0 1", GC::Corner_threshold(150)), "kink");
  BOOST_CHECK_EQUAL(grade("M0 0a5 5 0 0 1 1 0a7 7 0 0 0 1 0"), "kink");
  BOOST_CHECK_EQUAL(grade<Double_2>("M0 0a5 5 0 0 1 1 0a7 7 0 0 0 1 0"), "kink");
  BOOST_CHECK_EQUAL(grade<Double_2>("M0 0a5 5 0 0 1 1 0h9"), "corner");
}

// Arcs of circles over one chord: half of the angle of the arc is that between the arc and its
// chord.
BOOST_AUTO_TEST_CASE(random_arcs) {
  std::mt19937 random = seeded(12);
  for (int i = 0; i < 300; ++i) {
    const int x = 1 + static_cast<int>(random() % 9), y = static_cast<int>(random() % 9),
              u = static_cast<int>(random() % 19) - 9, v = 1 + static_cast<int>(random() % 9),
              r = 5 + static_cast<int>(random() % 9), s = 5 + static_cast<int>(random() % 9);
    if (x * x + y * y > 4 * r * r || u * u + v * v > 4 * s * s) continue;
    const int first = static_cast<int>(random() % 2), second = static_cast<int>(random() % 2);
    std::ostringstream path;
    path << "M0 0a" << r << ' ' << r << " 0 0 " << first << ' ' << x << ' ' << y << 'a' << s << ' ' << s << " 0 0 "
         << second << ' ' << u << ' ' << v;
    const double end = std::atan2(y, x) + (first ? 1 : -1) * std::asin(std::hypot(x, y) / (2 * r)),
                 start = std::atan2(v, u) - (second ? 1 : -1) * std::asin(std::hypot(u, v) / (2 * s));
    const double expected = std::acos(std::cos(end - start));
    const GC::Enclosure e = *angle(path.str());
    BOOST_CHECK(e.lower <= e.upper && e.upper - e.lower <= 1e-12);
    BOOST_CHECK_SMALL(e.lower - expected, 1e-7);
    if (std::abs(expected - 5 * degree) > 1e-6 && expected > 1e-6)
      BOOST_CHECK_EQUAL(grade(path.str()), expected > 5 * degree ? "corner" : "kink");
  }
}

BOOST_AUTO_TEST_SUITE_END()
