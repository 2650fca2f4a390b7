// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Bezier patches in .g2 files.

#define BOOST_TEST_MODULE g2_patches
#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <ios>

template <class Traits = Exact_3> std::vector<GC::Bezier_patch<Traits>> read(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_surfaces<Traits>(is, "file.g2");
}

const std::string good = "200 1 0 0\n3 0\n3 3\n0 0 0 2 2 2\n2 2\n-1 -1 .5 .5\n"
                         "0 0 0\n1 0 0.1\n2 0 0\n0 1 1/3\n1 1 0\n2 1 1e-1\n";

// `good` with the first occurrence of `what` replaced must be refused with this message
void check_refused(const std::string& what, const std::string& by, const std::string& message) {
  std::string altered = good;
  const std::size_t position = altered.find(what);
  BOOST_REQUIRE(position != std::string::npos);
  altered.replace(position, what.size(), by);
  BOOST_CHECK_EXCEPTION(read(altered), GC::Error, [&](const GC::Error& e) {
    BOOST_CHECK_EQUAL(e.what(), "malformed_input: file.g2:" + message);
    return e.code() == GC::Error_code::malformed_input;
  });
}

BOOST_AUTO_TEST_CASE(g2_surfaces_are_read) {
  const std::vector<GC::Bezier_patch<Exact_3>> s = read(good + "\n" + good);
  BOOST_REQUIRE_EQUAL(s.size(), 2);
  BOOST_CHECK(s[0] == s[1]);
  BOOST_CHECK_EQUAL(s[0].degree_u(), 2);
  BOOST_CHECK_EQUAL(s[0].degree_v(), 1);
  BOOST_CHECK(s[0].domain_u() == std::make_pair(Q(0), Q(2)));
  BOOST_CHECK(s[0].domain_v() == std::make_pair(Q(-1), Q(Q(1) / Q(2))));
  typedef Exact_3::Point P;
  // u runs fastest; exact decimals
  BOOST_CHECK(s[0].control_point(1, 0) == P(1, 0, Q(Q(1) / Q(10))));
  BOOST_CHECK(s[0].control_point(0, 1) == P(0, 1, Q(Q(1) / Q(3))));
  BOOST_CHECK(s[0].control_point(2, 1) == P(2, 1, Q(Q(1) / Q(10))));
  // auxiliary values and other white space
  BOOST_CHECK(read("200\t1 0 2 7 -8 \r\n" + good.substr(good.find('\n')))[0] == s[0]);
  // written and read again
  for (const GC::Bezier_patch<Exact_3>& patch : {s[0], s[0].swap_parameters().elevate(1, 2)}) {
    std::ostringstream os;
    GC::write_g2(os, patch);
    const std::vector<GC::Bezier_patch<Exact_3>> back = read(os.str());
    BOOST_REQUIRE_EQUAL(back.size(), 1);
    BOOST_CHECK(back[0] == patch);
  }
  std::ostringstream os;
  GC::write_g2(os, s[0]);
  BOOST_CHECK_EQUAL(os.str(), "200 1 0 0\n3 0\n3 3\n0 0 0 2 2 2\n2 2\n-1 -1 1/2 1/2\n"
                              "0 0 0\n1 0 1/10\n2 0 0\n0 1 1/3\n1 1 0\n2 1 1/10\n\n");
  const GC::Bezier_patch<GC::Traits_3<CGAL::Epick>> rounded = read<GC::Traits_3<CGAL::Epick>>(good)[0];
  BOOST_CHECK_EQUAL(rounded.control_point(1, 0).z(), 0.1);
  std::ostringstream of_rounded;
  GC::write_g2(of_rounded, rounded);
  BOOST_CHECK(read<GC::Traits_3<CGAL::Epick>>(of_rounded.str())[0] == rounded);
  // a reader gives one patch at a time
  std::istringstream is(good + good);
  GC::G2_surface_reader<Exact_3> reader(is, "file.g2");
  BOOST_CHECK(reader.next());
  BOOST_CHECK(reader.next());
  BOOST_CHECK(!reader.next());
}

BOOST_AUTO_TEST_CASE(malformed_g2_surfaces_are_refused) {
  check_refused(good, "", "1: no surface");
  check_refused("200", "100", "1: 100 (spline curve) where a surface (200) is expected");
  check_refused(
      "200", "210",
      "1: 210 (bounded surface) where a surface (200) is expected; its numbers, such as angles in radians, are not "
      "exact: write it as a rational spline");
  check_refused("200", "2x0", "1: the class of the object is '2x0' where an integer from 0 to 2147483647 is expected");
  check_refused("200 1", "200 2", "1: the major version is '2' where 1 is expected");
  check_refused("200 1 0", "200 1 1", "1: the minor version is '1' where 0 is expected");
  check_refused("200 1 0 0", "200 1 0 -1",
                "1: the number of auxiliary values is '-1' where an integer from 0 to 2147483647 is expected");
  check_refused("200 1 0 0", "200 1 0 1 1.5",
                "1: an auxiliary value is '1.5' where an integer from -2147483648 to 2147483647 is expected");
  check_refused(good, "200 1 0 3 1 2", "1: file ends after 2 of 3 auxiliary values");
  check_refused("\n3 0\n", "\n2 0\n", "2: dimension 2 where 3 is expected");
  check_refused("\n3 0\n", "\n3 1\n", "2: a rational surface where a polynomial one is expected");
  check_refused("\n3 3\n", "\n0 3\n",
                "3: the number of control points in u is '0' where an integer from 1 to 2147483647 is expected");
  check_refused("\n3 3\n", "\n3 129\n", "3: the order in u is '129' where an integer from 1 to 128 is expected");
  check_refused("\n3 3\n", "\n2 3\n",
                "3: 2 control points and order 3 in u: there must be as many control points as the order says");
  check_refused("\n2 2\n", "\n3 2\n",
                "5: 3 control points and order 2 in v: inner knots are not supported, only Bezier patches");
  check_refused("0 0 0 2 2 2", "0 0 1 2 2 2",
                "4: the knots in u are not clamped: knot 3 of 6 must be equal to the one before it");
  check_refused("0 0 0 2 2 2", "0 0 0 2 2 3",
                "4: the knots in u are not clamped: knot 6 of 6 must be equal to the one before it");
  check_refused("0 0 0 2 2 2", "0 0 0 2 1 2", "4: the knots in u decrease at '1'");
  check_refused("0 0 0 2 2 2", "0 0 0 -2 -2 -2", "4: the knots in u decrease at '-2'");
  check_refused("-1 -1 .5 .5", "1 1 1 1", "6: the first and the last knots in v are equal: empty domain");
  check_refused("1/3", "1/0", "10: zero denominator: '1/0'");
  check_refused("1/3", "nan", "10: not a number: 'nan'");
  check_refused("2 1 1e-1", "2 1", "12: file ends after 5 of 6 control points");
  check_refused("2 1 1e-1", "2 1 1e-1 5", "12: 5 where a surface (200) is expected");
  check_refused("\n2 1 1e-1\n", "", "11: file ends after 5 of 6 control points");
  check_refused(good, "200 1 0 0 3 0 3 3 0 0 0 2", "1: file ends after 4 of 6 knots in u");
  check_refused(good, "200 1 0 0 3 0 3", "1: file ends before the order in u");
  check_refused("\n2 1 1e-1\n", "\n2 1 1e-1\n200 1 0 0\n4 0\n", "14: dimension 4 where 3 is expected");
  typedef GC::Traits_d<CGAL::Cartesian_d<Q>> Traits;
  CHECK_ERROR(read<Traits>(good + "200 1 0 0\n4 0\n"), malformed_input);
  BOOST_CHECK_EQUAL(read<Traits>(good)[0].dimension(), 3);
  std::istringstream bad(good);
  bad.setstate(std::ios::failbit);
  CHECK_ERROR(GC::read_g2_surfaces<Exact_3>(bad, "file.g2"), cannot_read_file);
  std::ostringstream os;
  typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Double_3;
  const Double_3::Point huge(1e308, 0, 0);
  const GC::Bezier_patch<Double_3> patch({{huge, huge}, {huge, huge}});
  const auto overflow = [](const Double_3::Point& p) { return Double_3::Point(p.x() * 10, 0, 0); };
  CHECK_ERROR(GC::write_g2(os, patch.transform(overflow)), not_finite);
  BOOST_CHECK(os.str().empty());
}
