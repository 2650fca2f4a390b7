// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Rational curves and surfaces in .g2 files: written and read without loss, and refused where the
// text or the type does not allow them.

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/curves/arcs.h>
#include <CGAL/Geometric_continuity/surfaces/elementary_surfaces.h>

BOOST_AUTO_TEST_SUITE(g2_rational)

typedef std::tuple<Exact_2, Double_2> Planar;
typedef std::tuple<Exact_3, Double_3> Space;

constexpr unsigned seed = 2026;

template <class Object> std::string text_of(const Object& object) {
  return written_by([&](std::ostream& os) { GC::write_g2(os, object); });
}
template <class Traits> std::vector<GC::Rational_bspline_curve<Traits>> curves_in(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_rational_bsplines<Traits>(is, "f.g2");
}
template <class Traits> std::vector<GC::Rational_bspline_surface<Traits>> surfaces_in(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_rational_bspline_surfaces<Traits>(is, "f.g2");
}

void check_refused_curve(const std::string& text, const std::string& message) {
  BOOST_CHECK_EQUAL(error_of([&] { curves_in<Exact_2>(text); }), "malformed_input: f.g2:" + message);
}
template <class Traits = Exact_3> void check_refused_surface(const std::string& text, const std::string& message) {
  BOOST_CHECK_EQUAL(error_of([&] { surfaces_in<Traits>(text); }), "malformed_input: f.g2:" + message);
}

TEST_FOR_EACH(curves_are_kept, Traits, Planar) {
  typedef typename Traits::Point Point;
  typedef GC::Rational_bspline_curve<Traits> Curve;
  const GC::Rational_bezier_curve<Traits> arc = GC::circular_arc<Traits>(
                                              Point(0, 0), Point(FT(1) / FT(3), FT(1) / FT(7)), FT(3) / FT(7)),
                                          half = GC::circular_arc<Traits>(Point(1, 2), Point(3, 5), FT(1)),
                                          most = GC::circular_arc<Traits>(Point(1, 2), Point(3, 5), FT(2)),
                                          line(GC::Bezier_curve<Traits>{Point(0, 0), Point(1, 1)});
  const Curve circle = GC::ellipse<Traits>(Point(1, 2), {3, 1}, {-1, 3});
  const std::string text = text_of(circle) + text_of(arc) + text_of(half) + text_of(most) + text_of(line);
  const std::vector<Curve> read = curves_in<Traits>(text);
  BOOST_REQUIRE(read.size() == 5);
  BOOST_CHECK(read[0] == circle && read[1] == Curve(arc) && read[2] == Curve(half) && read[3] == Curve(most));
  BOOST_CHECK(read[4].is_polynomial() && text_of(line).substr(0, 14) == "100 1 0 0\n2 0\n");
  BOOST_CHECK(text_of(read[2]) == text_of(half));
  // piece by piece
  std::istringstream is(text);
  GC::G2_piece_reader<Traits> reader(is, "f.g2");
  std::vector<GC::Rational_bezier_curve<Traits>> pieces, expected = circle.bezier_pieces();
  while (const auto piece = reader.next()) pieces.push_back(*piece);
  BOOST_REQUIRE(pieces.size() == 8);
  for (int i = 0; i < 4; ++i) BOOST_CHECK(pieces[i] == expected[i]);
  BOOST_CHECK(pieces[5] == half && pieces[7] == line);
}

// The products are read back as the points of which they were made, whatever their size.
BOOST_AUTO_TEST_CASE(doubles_are_kept) {
  std::mt19937_64 engine = seeded<std::mt19937_64>(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int n = 0; n < 300; ++n) {
    std::vector<Double_3::Point> points;
    std::vector<double> weights;
    for (int j = 0; j < 5; ++j) {
      const double scale = std::pow(2., 30 * uniform(engine)), x = uniform(engine), y = uniform(engine);
      points.emplace_back(scale * x, y, uniform(engine) / scale);
      weights.push_back((uniform(engine) + 1.01) * std::pow(2., 30 * uniform(engine)));
    }
    const GC::Rational_bezier_curve<Double_3> c(points.begin(), points.end(), weights.begin(), weights.end());
    const std::string text = text_of(c);
    BOOST_CHECK(text.find('/') == std::string::npos); // decimals
    BOOST_CHECK(curves_in<Double_3>(text).front() == GC::Rational_bspline_curve<Double_3>(c));
  }
  // and where a product overflows or underflows
  const std::vector<Double_2::Point> far = {{0, 1e300}, {1e-300, 1}};
  const std::vector<double> heavy = {1e200, 1e-100};
  const GC::Rational_bspline_curve<Double_2> c(far.begin(), far.end(), heavy.begin(), heavy.end(),
                                               GC::Knot_vector<double>(1, 0., 1.));
  BOOST_CHECK(curves_in<Double_2>(text_of(c)).front() == c);
}

TEST_FOR_EACH(surfaces_are_kept, Traits, Space) {
  typedef typename Traits::Point Point;
  std::vector<std::vector<Point>> net(3);
  std::vector<std::vector<FT>> weights(3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) {
      net[i].push_back(Point(i, j, FT(i * j) / FT(7)));
      weights[i].push_back(FT(1 + i + 2 * j) / FT(3));
    }
  const GC::Rational_bspline_surface<Traits> s(
      net, weights, GC::Knot_vector<FT>(1, {FT(0), FT(0), FT(1), FT(2), FT(2)}), GC::Knot_vector<FT>(3, FT(0), FT(1)));
  const std::string text = text_of(s);
  BOOST_CHECK(text.substr(0, 14) == "200 1 0 0\n3 1\n");
  BOOST_CHECK(surfaces_in<Traits>(text).front() == s);
  const GC::Rational_bezier_patch<Traits> patch(net, weights);
  BOOST_CHECK(surfaces_in<Traits>(text_of(patch)).front() == GC::Rational_bspline_surface<Traits>(patch));
  const GC::Bspline_surface<Traits> plain(net, s.knots_u(), s.knots_v());
  BOOST_CHECK(*surfaces_in<Traits>(text_of(plain)).front().polynomial() == plain);
  BOOST_CHECK(text_of(GC::Rational_bspline_surface<Traits>(plain)) == text_of(plain));
}

// The products as other programs write them.
BOOST_AUTO_TEST_CASE(products_are_divided) {
  const auto c = curves_in<Exact_2>("100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n2 0 2\n.5 .5 .5\n0 4 4\n").front();
  BOOST_CHECK(c.control_point(0) == Exact_2::Point(1, 0) && c.control_point(1) == Exact_2::Point(1, 1) &&
              c.weight(1) == Q(1) / Q(2));
  const auto d = curves_in<Double_2>("100 1 0 0\n2 1\n2 2\n0 0 1 1\n.1 .3 .3\n1 0 1\n")
                     .front(); // divided before anything is rounded
  BOOST_CHECK(d.control_point(0) == Double_2::Point(1. / 3, 1));
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_refused) {
  const std::string head = "100 1 0 0\n2 1\n3 3\n0 0 0 1 1 1\n";
  check_refused_curve(head + "0 0 1\n1 1 -1\n1 0 1\n", "7: zero_weight: Rational_bspline_curve: weights");
  check_refused_curve(head + "0 0 1\n1 1 1\n1 0\n", "7: file ends after 2 of 3 control points");
  check_refused_curve("100 1 0 0\n2 2\n", "2: the rational flag is '2' where an integer from 0 to 1 is expected");
  std::istringstream pieces(head + "0 0 1\n1 1 -1\n1 0 1\n"), polynomial(head + "0 0 1\n1 1 1\n1 0 1\n");
  BOOST_CHECK_EQUAL(error_of([&] { GC::G2_piece_reader<Exact_2>(pieces, "f.g2").next(); }),
                    "malformed_input: f.g2:7: zero_weight: Rational_bspline_curve: weights");
  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_curves<Exact_2>(polynomial, "f.g2"); }),
                    "malformed_input: f.g2:2: a rational curve where a polynomial one is expected");
  check_refused_surface("200 1 0 0\n3 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n0 0 0 1\n1 0 0 -1\n0 1 0 1\n1 1 0 1\n",
                        "10: zero_weight: Rational_bspline_surface: weights");
}

// Elementary classes: lines with ends are curves of degree 1, all others are refused with their
// name and a way out.
BOOST_AUTO_TEST_CASE(elementary_classes) {
  const std::string line = "120 1 0 0\n2\n1 2\n3 1/2\n1\n-1 4\n";
  for (const auto& c : {curves_in<Exact_2>(line).front(),
                        curves_in<Exact_2>(line + text_of(curves_in<Exact_2>(line).front())).back()}) {
    BOOST_CHECK(c.degree() == 1 && c.domain() == std::make_pair(Q(-1), Q(4)) && c.is_polynomial());
    BOOST_CHECK(c(Q(2)) == Exact_2::Point(7, 3));
  }
  BOOST_CHECK(curves_in<Double_2>("120 1 0 0\n2\n0 0\n1 .1\n1\n0 3\n").front().end_jet(0).point() ==
              Double_2::Point(3, 0.3)); // rounded once
  std::istringstream pieces(line + line);
  GC::G2_piece_reader<Exact_2> reader(pieces, "f.g2");
  BOOST_CHECK(reader.next()->degree() == 1 && reader.next()->control_point(1) == Exact_2::Point(13, 4) &&
              !reader.next());
  check_refused_curve("120 1 0 0\n2\n1 2\n3 1\n0\n", "5: a line without ends; a curve has two");
  check_refused_curve("120 1 0 0\n2\n1 2\n3 1\n1\n2 2\n", "6: the ends of a line do not increase: empty domain");
  check_refused_curve("130 1 0 0\n2\n",
                      "1: 130 (circle) where a curve (100) is expected; its numbers, such as angles in "
                      "radians, are not exact: write it as a rational spline");
  check_refused_curve("250 1 0 0\n", "1: 250 (plane) where a curve (100) is expected");
  check_refused_surface("120 1 0 0\n3\n", "1: 120 (line) where a surface (200) is expected");
}

// A plane with exact axes is a surface of degree 1 by 1.
BOOST_AUTO_TEST_CASE(planes) {
  const std::string axes = "250 1 0 0\n3\n1 2 3\n0 0 1\n3/5 4/5 0\n";
  const auto corners = [](const auto& s) {
    return std::vector<Exact_3::Point>{s.control_point(0, 0), s.control_point(1, 0), s.control_point(0, 1),
                                       s.control_point(1, 1)};
  };
  const auto interval = [](int a, int b) { return std::make_pair(Q(a), Q(b)); };
  // (1, 2, 3) + u (3, 4, 0)/5 + v (-4, 3, 0)/5
  const std::vector<Exact_3::Point> points = {{1, 2, 3}, {7, 10, 3}, {-3, 5, 3}, {3, 13, 3}};
  std::string all;
  for (const std::string end : {"1\n0 10\n0 5\n", "1\n0 10 0 5\n0\n", "11\n0 10\n0 5\n2 3\n-1 1\n0\n",
                                "11 0 10 0 5 2 3 -1 1", "1 0 10 0 5 1\n"}) {
    const GC::Rational_bspline_surface<Exact_3> s = surfaces_in<Exact_3>(axes + end).front();
    const bool swapped = end.back() == '\n' && end[end.size() - 2] == '1' && end[0] == '1' && end[1] == ' ';
    std::vector<Exact_3::Point> expected = points;
    if (swapped) std::swap(expected[1], expected[2]);
    BOOST_CHECK(corners(s) == expected && s.is_polynomial() && s.degree_u() == 1 && s.degree_v() == 1);
    const bool domain = end[1] == '1';
    BOOST_CHECK(s.domain_u() == (domain ? interval(2, 3) : swapped ? interval(0, 5) : interval(0, 10)));
    BOOST_CHECK(s.domain_v() == (domain ? interval(-1, 1) : swapped ? interval(0, 10) : interval(0, 5)));
    all += axes + end + "\n" + text_of(s);
  }
  BOOST_CHECK_EQUAL(surfaces_in<Exact_3>(all).size(), 10u); // what follows is read as well
  // axes of rational lengths, as rational and as floating-point numbers
  const std::string longer = "250 1 0 0\n3\n0 0 0\n2 -2 1\n.1 .2 .2\n1\n0 3\n0 3\n";
  BOOST_CHECK((corners(surfaces_in<Exact_3>(longer).front()) ==
               std::vector<Exact_3::Point>{{0, 0, 0}, {1, 2, 2}, {-2, -1, 2}, {-1, 1, 4}}));
  BOOST_CHECK(surfaces_in<Double_3>(longer).front().control_point(1, 1) == Double_3::Point(-1, 1, 4));
  std::istringstream patches(longer);
  BOOST_CHECK_EQUAL(GC::read_g2_surfaces<Exact_3>(patches, "f.g2").size(), 1u); // as a Bezier_patch

  const std::string not_exact =
      ": a plane whose axes are no unit vectors at right angles in exact numbers: write it as a "
      "spline surface of the orders 2";
  for (const std::string wrong : {"0 0 1\n1 0 1e-9", "0 0 1\n3/5 0 4/5", "1 1 0\n0 0 1", "0 0 0\n1 0 0",
                                  "0 0 1\n0.7071067811865475 0.7071067811865475 0"})
    check_refused_surface("250 1 0 0\n3\n0 0 0\n" + wrong + "\n1\n0 1\n0 1\n", "5" + not_exact);
  std::string far = longer;
  far.replace(far.find("0 0 0"), 5, "1e400 0 0");
  BOOST_CHECK(surfaces_in<Exact_3>(far).front().degree_u() == 1);
  check_refused_surface<Double_3>(far, "8: a control point: outside the range of floating-point numbers");
  for (const std::string bounds : {"1 1.0000000000000000000000001\n0 1\n", "0 1\n1 1.0000000000000000000000001\n"})
    check_refused_surface<Double_3>(longer.substr(0, longer.find("\n1\n") + 3) + bounds,
                                    "8: the ends of the domain of a plane are the same floating-point number");
  check_refused_surface(axes + "0\n", "6: a plane without bounds; a surface has four edges");
  check_refused_surface(axes + "7\n", "6: the flag of the bounds of a plane is neither 0 nor 1 nor 11");
  check_refused_surface(axes + "1\n0 1\n2 2\n\n100", "8: the bounds of a plane do not increase: empty domain");
  check_refused_surface(axes + "11\n0 1\n1 2\n3 3 0 1", "9: the bounds of a plane do not increase: empty domain");
  check_refused_surface(axes + "1\n0 1 0 1\n2\n", "8: 2 where a surface (200) is expected");
  check_refused_surface(axes + "1\n0 1 0", "7: file ends after 0 of 1 planes");
  check_refused_surface<Exact_2>("250 1 0 0\n2\n", "2: a plane of dimension 2 where 3 is expected");
  check_refused_surface<Double_3>(axes + "1\n1 1.00000000000000000001 0 1\n",
                                  "7: the ends of the domain of a plane are the same floating-point number");
}

// (u-v)^2 + epsilon: that it costs too much to know whether this is positive is not an error of the
// text.
BOOST_AUTO_TEST_CASE(denominators_close_to_zero) {
  const auto with = [](const Q& epsilon) {
    std::ostringstream os;
    os << "200 1 0 0\n3 1\n3 3\n0 0 0 1 1 1\n3 3\n0 0 0 1 1 1\n";
    for (int j = 0; j < 3; ++j) // v is the slower one
      for (int i = 0; i < 3; ++i) os << "0 0 0 " << Q(Q((i == 2) + (j == 2)) - Q(i * j) / Q(2) + epsilon) << '\n';
    return os.str();
  };
  const Q small = Q(1) / Q(1 << 30);
  BOOST_CHECK_EQUAL(surfaces_in<Exact_3>(with(Q(1) / Q(1024))).size(), 1u);
  BOOST_CHECK_EQUAL(error_of([&] { surfaces_in<Exact_3>(with(Q(0))); }).substr(0, 24), "malformed_input: f.g2:15");
  CHECK_ERROR(surfaces_in<Exact_3>(with(Q(small * small))), work_limit);
}

BOOST_AUTO_TEST_SUITE_END()
