// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// B-spline curves in .g2 files.

#include "support/splines.h"

#include <CGAL/Geometric_continuity/IO/g2.h>

TEST_FOR_EACH(splines_in_files, K, Kernels) {
  repeat<FT>(10, [](Random<FT>& random) {
    std::vector<Curve3<K>> curves;
    for (int p = 0; p <= 4; ++p) curves.push_back(random.template curve<Traits3<K>>(random.knots(p, p + 1), 3));
    std::stringstream text;
    for (const Curve3<K>& curve : curves) GC::write_g2(text, curve);
    BOOST_CHECK(GC::read_g2_bsplines<Traits3<K>>(text, "f.g2") == curves);
    // a Bezier curve is written and read as both
    const std::vector<Bezier3<K>> pieces = curves[3].bezier_pieces();
    std::stringstream bezier, spline;
    for (const Bezier3<K>& piece : pieces) {
      GC::write_g2(bezier, piece);
      GC::write_g2(spline, Curve3<K>(piece));
    }
    BOOST_CHECK_EQUAL(bezier.str(), spline.str());
    BOOST_CHECK(GC::read_g2_curves<Traits3<K>>(spline, "f.g2") == pieces);
    const std::vector<Curve3<K>> read = GC::read_g2_bsplines<Traits3<K>>(bezier, "f.g2");
    BOOST_REQUIRE_EQUAL(read.size(), pieces.size());
    for (std::size_t i = 0; i < read.size(); ++i) BOOST_CHECK(read[i] == Curve3<K>(pieces[i]));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(refused_splines_in_files, K, Kernels) {
  typedef GC::Traits_2<K> Traits;
  typedef typename K::FT FT;
  const auto text = [](const std::string& size, const std::string& knots) {
    return "100 1 0 0\n2 0\n" + size + "\n" + knots + "\n0 0\n1 2\n3 4\n5 6\n";
  };
  const auto error = [&](const std::string& size, const std::string& knots) {
    std::istringstream is(text(size, knots));
    return error_of([&] { GC::read_g2_bsplines<Traits>(is, "f.g2"); });
  };
  const auto refused = [](int line, const std::string& reason) {
    return "malformed_input: f.g2:" + std::to_string(line) + ": " + reason;
  };
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2 2"), "no error");
  BOOST_CHECK_EQUAL(error("4 3", "-2 -1 0 1/2 2 3 4"), "no error");
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1/2 2 2\n1"), refused(5, "the knots decrease at '1'"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 1\n.5 2 2 2"), refused(5, "the knots decrease at '.5'"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0\n0 2 2 2"), refused(5, "knot 4 of 7 is repeated more than 3 times"));
  BOOST_CHECK_EQUAL(error("4 3", "0 1 2 2 2 3 4"), refused(4, "knot 3 of 7 is equal to knot 5: empty domain"));
  BOOST_CHECK_EQUAL(error("4 3", "0 0 0 1 1 1\n1"), refused(5, "knot 7 of 7 is repeated more than 3 times"));
  BOOST_CHECK_EQUAL(error("4 5", ""), refused(3, "4 control points and order 5: there must be at least as many control "
                                                 "points as the order says"));
  BOOST_CHECK_EQUAL(error("2147483647 3", "0 0 0 1 2 x"), refused(4, "not a number: 'x'"));
  BOOST_CHECK_EQUAL(error("5 3", "0 0 0 1 2 3 3 3"), refused(8, "file ends after 4 of 5 control points"));
  BOOST_CHECK_EQUAL(error("40 3", "0"), refused(8, "file ends after 9 of 43 knots"));
  std::istringstream inner(text("4 3", "0 0 0 1/2 2 2 2"));
  BOOST_CHECK_EQUAL(error_of([&] { GC::read_g2_curves<Traits>(inner, "f.g2"); }),
                    refused(3, "4 control points and order 3: inner knots are not supported, only Bezier curves"));
  // numbers as written
  std::istringstream good(text("4 3", "0 0 0 1/4 2 2 2"));
  const GC::Bspline_curve<Traits> c = GC::read_g2_bsplines<Traits>(good, "f.g2").at(0);
  BOOST_CHECK(c.knots() == GC::Knot_vector<FT>(2, FT(0), FT(2), {{ratio<FT>(1, 4), 1}}));
  BOOST_CHECK(c.control_point(3) == typename K::Point_2(5, 6));
  std::ostringstream os;
  GC::write_g2(os, c);
  BOOST_CHECK_EQUAL(os.str(), "100 1 0 0\n2 0\n4 3\n0 0 0 " + std::string(exact_v<FT> ? "1/4" : "0.25") +
                                  " 2 2 2\n0 0\n1 2\n3 4\n5 6\n\n");
}
