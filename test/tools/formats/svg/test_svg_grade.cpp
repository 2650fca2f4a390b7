// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Corners, kinks and angles between the segments of SVG paths.

#define BOOST_TEST_MODULE svg_grade
#include "support/test.h"

#include "formats/svg/read_svg_path.h"
#include <CGAL/Geometric_continuity/joins/path_continuity.h>

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
