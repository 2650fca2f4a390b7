// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins of segments of paths: the short way for Bezier curves of short numbers answers as the
// general one, and encloses the jets.

#include "support/test.h"

#include <CGAL/Geometric_continuity.h>

BOOST_AUTO_TEST_SUITE(path_continuity)

typedef Exact_2::Point Point;
typedef GC::Bezier_curve<Exact_2> Curve;
typedef GC::Path_segment<Exact_2> Segment;
typedef GC::Path_join<Exact_2> Join;

template <class FT> std::string text(const GC::Join_continuity<FT>& join) {
  std::ostringstream os;
  const auto flag = [](const std::optional<bool>& b) { return !b ? '-' : *b ? 'y' : 'n'; };
  os << join << ' ' << join.regular << flag(join.tangent_equal) << flag(join.curvature_equal)
     << flag(join.curvature_vector_equal);
  return os.str();
}

// Returns whether the enclosures of the derivatives with respect to a parameter of [0, 1] are
// narrow and contain those over a domain.
template <class Jet, class Exact> bool encloses(const Jet& enclosed, const Exact& exact, const Curve& curve) {
  Q power(1);
  for (int k = 0; k <= 3; ++k, power *= curve.domain().second - curve.domain().first)
    for (int i = 0; i < 2; ++i) {
      const Q x = exact[k][i] * power, lower(enclosed[k][i].inf()), upper(enclosed[k][i].sup());
      if (x < lower || upper < x || upper - lower > abs(x) / Q(1e15)) return false;
    }
  return true;
}

// The answers are those about the curves; whether the jets are enclosed, each time they are asked
// for.
bool has_enclosures(const Curve& left, const Curve& right) {
  const Segment x{left}, y{right};
  const Join join(x, y);
  for (const int order : {0, 1, 2, 3, 4, 6})
    BOOST_CHECK_EQUAL(text(*GC::continuity(join, order)), text(GC::continuity(left, right, order)));
  int calls = 0;
  const auto check = [&](const auto& a, const auto& b) {
    ++calls;
    BOOST_CHECK(encloses(a, left.end_jet(3), left) && encloses(b, right.start_jet(3), right));
  };
  const bool enclosed = GC::visit_enclosures(join, check);
  BOOST_CHECK_EQUAL(GC::visit_enclosures(join, check), enclosed);
  BOOST_CHECK_EQUAL(calls, enclosed ? 2 : 0);
  return enclosed;
}

BOOST_AUTO_TEST_CASE(joins_of_curves) {
  const Curve curve =
      Curve{Point(-1, Q(1) / 7), Point(0, 5), Point(2, -3), Point(3, Q(1) / 3), Point(4, Q(-2) / 11), Point(9, 1)}
          .with_domain(Q(0), Q(7));
  const auto [left, right] = curve.split(Q(3));
  const Curve line{left.control_point(5), Point(8, Q(5) / 13)}, far{Point(1, 2), Point(Q(1e30), 2)};
  BOOST_CHECK(has_enclosures(left, right));
  BOOST_CHECK(has_enclosures(left, line) && has_enclosures(line.reverse(), right));
  BOOST_CHECK_EQUAL(GC::continuity(Segment{left}, Segment{right}, 6)->c_order, 6);
  BOOST_CHECK_EQUAL(GC::continuity(Segment{left}, Segment{line}, 6)->c_order, 0);
  // domains whose ends are no short integers, and long coordinates
  for (const Q& end : {Q(Q(15) / Q(2)), Q(1e30)}) {
    const Curve other = right.with_domain(Q(3), end);
    BOOST_CHECK(!has_enclosures(left, other) && !has_enclosures(other.reverse(), line));
  }
  BOOST_CHECK(!has_enclosures(left.with_domain(Q(1) / 2, Q(3)), right) && !has_enclosures(left, far));
}

BOOST_AUTO_TEST_CASE(joins_of_arcs) {
  const auto arc = [](const Q& rotation) {
    return Segment{GC::Elliptical_arc<Exact_2>(Point(1, 0), Point(2, 1), {Q(3), Q(4), rotation, false, true})};
  };
  const Segment line{Curve{Point(0, 0), Point(1, 0)}}, known = arc(Q(90)), rotated = arc(Q(30));
  const auto never = [](const auto&, const auto&) { BOOST_ERROR("called"); };
  for (const Segment& segment : {known, rotated}) {
    BOOST_CHECK(!GC::visit_enclosures(Join(line, segment), never) && !GC::visit_enclosures(Join(segment, line), never));
    BOOST_CHECK(GC::visual_class(line, segment) == GC::Visual_class::corner && GC::tangent_angle(line, segment));
    BOOST_CHECK_EQUAL(GC::continuity(line, segment)->g_order, 0);
  }
  for (const Segment& right : {line, rotated}) {
    BOOST_CHECK(GC::visual_class(rotated, right) == GC::Visual_class::gap && GC::tangent_angle(rotated, right));
    BOOST_CHECK_EQUAL(GC::continuity(rotated, right)->g_order, -1);
  }
  BOOST_CHECK_THROW(GC::continuity(line, rotated, -1), GC::Error);
  const Segment point{Curve{Point(1, 0), Point(1, 0)}};
  BOOST_CHECK(!GC::visual_class(point, rotated) && !GC::tangent_angle(point, rotated));
}

// Half of an ellipse that is turned by hardly anything, and the vertical line that would follow it
// otherwise.
BOOST_AUTO_TEST_CASE(directions_that_differ_by_too_little) {
  const Segment line{Curve{Point(10, 0), Point(10, 1)}};
  Q rotation(1);
  for (int bits = 0; bits < 1200; bits += 100, rotation /= Q(0x1p100)) {
    const Segment arc{GC::Elliptical_arc<Exact_2>(Point(0, 0), Point(10, 0), {Q(5), Q(4), rotation, false, true})};
    BOOST_CHECK_EQUAL(GC::continuity(arc, line).has_value(), bits <= 1000);
    BOOST_CHECK(GC::visual_class(arc, line) == (bits <= 1000 ? std::optional(GC::Visual_class::kink) : std::nullopt));
    // of (25 - 16) / 25 times the rotation, nearly
    const GC::Enclosure angle = *GC::tangent_angle(arc, line);
    BOOST_CHECK(angle.lower <= CGAL::to_double(rotation) && angle.upper < (bits < 500 ? 2e-2 : 1e-150));
  }
}

BOOST_AUTO_TEST_SUITE_END()
