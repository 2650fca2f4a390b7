// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// B-spline surfaces in .g2 files.

#define BOOST_TEST_MODULE g2_surfaces
#include "support/test.h"
#include "support/words.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>
#include <cstring>

template <class Traits> std::vector<GC::Bspline_surface<Traits>> read(const std::string& text) {
  std::istringstream is(text);
  return GC::read_g2_bspline_surfaces<Traits>(is, "f.g2");
}

template <class Surface> std::string written(const Surface& s) {
  return written_by([&](std::ostream& os) { GC::write_g2(os, s); });
}

// Quadratic in u with an inner knot, not clamped, and linear in v.
const std::string good = "200 1 0 0\n3 0\n4 3\n-1 0 0 1/2 2 2 3\n2 2\n-1 -1 .5 .5\n"
                         "0 0 0\n1 0 0.1\n2 0 0\n3 0 0\n0 1 1/3\n1 1 0\n2 1 1e-1\n3 1 -7\n";

// `good` with the first occurrence of `what` replaced
std::string altered(const std::string& what, const std::string& by) {
  std::string text = good;
  const std::size_t position = text.find(what);
  BOOST_REQUIRE(position != std::string::npos);
  return text.replace(position, what.size(), by);
}

// With `by` in place of `what`, `good` is refused with every number type, and after a good surface
// as well.
struct Refused {
  std::string what, by;
  int line;
  std::string reason;
};
void check_refused(const std::vector<Refused>& rows) {
  for (const auto& [what, by, line, reason] : rows) {
    const std::string text = altered(what, by), before = "malformed_input: f.g2:", after = ": " + reason;
    BOOST_CHECK_EQUAL(error_of([&] { read<Exact_3>(text); }), before + std::to_string(line) + after);
    BOOST_CHECK_EQUAL(error_of([&] { read<Double_3>(text); }), before + std::to_string(line) + after);
    BOOST_CHECK_EQUAL(error_of([&] { read<Exact_3>(good + text); }), before + std::to_string(14 + line) + after);
  }
}

BOOST_AUTO_TEST_CASE(inner_knots_are_read) {
  const std::vector<GC::Bspline_surface<Exact_3>> s = read<Exact_3>(good + "\n\n" + good);
  BOOST_REQUIRE_EQUAL(s.size(), 2);
  BOOST_CHECK(s[0] == s[1]);
  BOOST_CHECK(s[0].knots_u() == GC::Knot_vector<Q>(2, {-1, 0, 0, Q(1) / 2, 2, 2, 3}));
  BOOST_CHECK(s[0].knots_v() == GC::Knot_vector<Q>(1, {-1, -1, Q(1) / 2, Q(1) / 2}));
  typedef Exact_3::Point P;
  BOOST_CHECK(s[0].control_point(1, 0) == P(1, 0, Q(Q(1) / 10))); // u runs fastest; exact decimals
  BOOST_CHECK(s[0].control_point(0, 1) == P(0, 1, Q(Q(1) / 3)));
  BOOST_CHECK(s[0].control_point(3, 1) == P(3, 1, -7));
  BOOST_CHECK_EQUAL(written(s[0]), "200 1 0 0\n3 0\n4 3\n-1 0 0 1/2 2 2 3\n2 2\n-1 -1 1/2 1/2\n"
                                   "0 0 0\n1 0 1/10\n2 0 0\n3 0 0\n0 1 1/3\n1 1 0\n2 1 1/10\n3 1 -7\n\n");
  BOOST_CHECK(read<Exact_3>("200\t1 0 2 7 -8\r\n" + good.substr(good.find('\n')))[0] == s[0]);
  BOOST_CHECK_EQUAL(read<Double_3>(good)[0].control_point(1, 0).z(), 0.1);
  BOOST_CHECK_EQUAL(read<Exact_d>(good)[0].dimension(), 3);
  // all words in one line
  std::string line;
  for (const std::string& word : words_of(good)) line += word + ' ';
  BOOST_CHECK(read<Exact_3>(line)[0] == s[0]);
  // one at a time
  std::istringstream is(good + good);
  GC::G2_bspline_surface_reader<Exact_3> reader(is, "f.g2");
  BOOST_CHECK(reader.next() == s[0]);
  BOOST_CHECK(reader.next() == s[0]);
  BOOST_CHECK(!reader.next());
}

BOOST_AUTO_TEST_CASE(bezier_patches_and_splines_are_one_format) {
  typedef Exact_3::Point P;
  const GC::Bezier_patch<Exact_3> patch({{P(0, 0, 0), P(0, 1, 2), P(0, 2, 0)}, {P(1, 0, 0), P(1, 1, 5), P(1, 2, 1)}},
                                        {Q(1), Q(3)}, {Q(0), Q(Q(1) / 7)});
  const auto read_patches = [](const std::string& text) {
    std::istringstream is(text);
    return GC::read_g2_surfaces<Exact_3>(is, "f.g2");
  };
  const std::string text = written(patch);
  BOOST_CHECK_EQUAL(text, written(GC::Bspline_surface<Exact_3>(patch)));
  BOOST_CHECK(read<Exact_3>(text).at(0) == GC::Bspline_surface<Exact_3>(patch));
  BOOST_CHECK(read_patches(text).at(0) == patch);
  // what splines may have and patches may not
  const std::string start = "200 1 0 0\n3 0\n3 3\n0 0 ", rest = "\n1 1\n0 1\n0 0 0\n1 0 0\n2 0 1\n",
                    not_clamped = "4: the knots in u are not clamped: knot ",
                    end = " of 6 must be equal to the one before it";
  BOOST_CHECK_EQUAL(read_patches(start + "0 2 2 2" + rest).at(0).degree_v(), 0);
  const std::pair<std::string, std::string> refused[] = {
      {"", "1: no surface"},
      {good, "3: 4 control points and order 3 in u: inner knots are not supported, only Bezier patches"},
      {start + "1 2 2 2" + rest, not_clamped + "3" + end},
      {start + "0 2 2 3" + rest, not_clamped + "6" + end},
      {start + "0 2 1 2" + rest, "4: the knots in u decrease at '1'"},
      {start + "0 0 0 0" + rest, "4: the first and the last knots in u are equal: empty domain"},
      {"200 1 0 0\n3 0\n2 3\n",
       "3: 2 control points and order 3 in u: there must be as many control points as the order says"}};
  for (const auto& [wrong, message] : refused)
    BOOST_CHECK_EQUAL(error_of([&, &wrong = wrong] { read_patches(wrong); }), "malformed_input: f.g2:" + message);
}

BOOST_AUTO_TEST_CASE(surfaces_are_written_without_loss) {
  std::mt19937_64 random = seeded<std::mt19937_64>(20260722);
  const auto rational = [&] { return Q(Q(int(random() % 2000001) - 1000000) / Q(1 + int(random() % 1000000))); };
  const auto finite = [&] {
    double x;
    do {
      const std::uint64_t bits = random();
      std::memcpy(&x, &bits, sizeof x);
    } while (!std::isfinite(x));
    return x;
  };
  const auto knots = [&](int degree, auto number) {
    typedef decltype(number()) FT;
    std::vector<FT> u;
    while (u.size() < 2u * degree + 5) {
      const FT t = number();
      for (int i = 1 + int(random() % (degree + 1)); i > 0; --i) u.push_back(t);
    }
    std::sort(u.begin(), u.end());
    return GC::Knot_vector<FT>(degree, u);
  };
  const auto check = [&](auto traits, auto number) {
    typedef decltype(traits) Traits;
    std::string text;
    std::vector<GC::Bspline_surface<Traits>> surfaces;
    for (int i = 0; i < 20; ++i) {
      const auto u = knots(1 + i % 4, number), v = knots(1 + i % 3, number);
      std::vector<std::vector<typename Traits::Point>> net(u.number_of_coefficients());
      for (auto& row : net)
        for (int j = 0; j < v.number_of_coefficients(); ++j) row.push_back({number(), number(), number()});
      surfaces.emplace_back(net, u, v);
      text += written(surfaces.back());
    }
    BOOST_CHECK(read<Traits>(text) == surfaces);
  };
  check(Exact_3(), rational);
  check(Double_3(), finite);
}

BOOST_AUTO_TEST_CASE(nothing_is_written_when_a_number_cannot_be_written) {
  typedef CGAL::Quotient<CGAL::MP_Float> Approximate;
  typedef GC::Traits_3<CGAL::Simple_cartesian<Approximate>> Traits;
  const Traits::Point p(1, 2, Approximate(CGAL::MP_Float(0.1), CGAL::MP_Float(3)));
  std::ostringstream os;
  const GC::Bezier_patch<Traits> patch({{p, p}, {p, p}});
  CHECK_ERROR(GC::write_g2(os, patch), cannot_write_file);
  const Double_3::Point huge(1e308, 0, 0);
  const auto overflow = [](const Double_3::Point& q) { return Double_3::Point(q.x() * 10, 0, 0); };
  CHECK_ERROR(GC::write_g2(os, GC::Bezier_patch<Double_3>({{huge, huge}, {huge, huge}}).transform(overflow)),
              not_finite);
  BOOST_CHECK_EQUAL(os.str(), "");
}

BOOST_AUTO_TEST_CASE(no_surface) {
  for (const std::string text : {"", " \n\n\t\n"})
    BOOST_CHECK_EQUAL(error_of([&] { read<Exact_3>(text); }), "malformed_input: f.g2:1: no surface");
  std::istringstream bad(good), bad_patches(good);
  bad.setstate(std::ios::failbit);
  bad_patches.setstate(std::ios::failbit);
  CHECK_ERROR(GC::read_g2_bspline_surfaces<Exact_3>(bad, "f.g2"), cannot_read_file);
  CHECK_ERROR(GC::read_g2_surfaces<Exact_3>(bad_patches, "f.g2"), cannot_read_file);
}

// Curves have the same rules, which are tested with them.
BOOST_AUTO_TEST_CASE(wrong_headers) {
  check_refused(
      {{"200", "100", 1, "100 (spline curve) where a surface (200) is expected"},
       {"200", "210", 1,
        "210 (bounded surface) where a surface (200) is expected; its numbers, such as angles in radians, "
        "are not exact: write it as a rational spline"},
       {"200", "2x0", 1, "the class of the object is '2x0' where an integer from 0 to 2147483647 is expected"},
       {good, "200 1 0 2000000000 5\n 6", 2, "file ends after 2 of 2000000000 auxiliary values"},
       {"\n3 0\n", "\n2 0\n", 2, "dimension 2 where 3 is expected"},
       {"\n3 0\n", "\n3 1\n", 2, "a rational surface where a polynomial one is expected"},
       {"\n3 0\n", "\n3 2\n", 2, "the rational flag is '2' where an integer from 0 to 1 is expected"},
       {"3 1 -7", "3 1 -7 5", 14, "5 where a surface (200) is expected"}}); // a number too many
  BOOST_CHECK_EQUAL(error_of([&] { read<Exact_d>(good + "200 1 0 0\n4 0\n"); }),
                    "malformed_input: f.g2:16: dimension 4 after a surface of dimension 3");
  BOOST_CHECK_EQUAL(error_of([&] { read<Exact_d>("200 1 0 0\n17 0\n"); }),
                    "malformed_input: f.g2:2: the dimension is '17' where an integer from 2 to 16 is expected");
}

BOOST_AUTO_TEST_CASE(wrong_counts) {
  const std::string points = " where an integer from 1 to 2147483647 is expected",
                    order = " where an integer from 1 to 128 is expected";
  for (const std::string n : {"0", "-4", "4.0", "4e0", "four", "99999999999999999999", "nan"})
    check_refused({{"\n4 3\n", "\n" + n + " 3\n", 3, "the number of control points in u is '" + n + "'" + points},
                   {"\n4 3\n", "\n4 " + n + "\n", 3, "the order in u is '" + n + "'" + order},
                   {"\n2 2\n", "\n" + n + " 2\n", 5, "the number of control points in v is '" + n + "'" + points},
                   {"\n2 2\n", "\n2 " + n + "\n", 5, "the order in v is '" + n + "'" + order}});
  // counts that only pretend need no memory
  std::string much = "200 1 0 0\n3 0\n1000 1\n";
  for (int direction = 0; direction < 2; ++direction) {
    for (int i = 0; i <= 1000; ++i) much += std::to_string(i) + ' ';
    if (direction == 0) much += "\n1000 1\n";
  }
  check_refused({{"\n4 3\n", "\n129 129\n", 3, "the order in u is '129'" + order},
                 {"\n4 3\n", "\n2 3\n", 3,
                  "2 control points and order 3 in u: there must be at least as many control points as the order says"},
                 {good, "200 1 0 0 3 0 2147483647 128 0 1", 1, "file ends after 2 of 2147483775 knots in u"},
                 {good, much, 6, "file ends after 0 of 1000000 control points"}});
}

BOOST_AUTO_TEST_CASE(wrong_knots) {
  const std::string u = "-1 0 0 1/2 2 2 3", v = "-1 -1 .5 .5";
  check_refused({{u, "-1 0 0 1/2 2 1 3", 4, "the knots in u decrease at '1'"},
                 {u, "-1 -2 0 1/2 2 2 3", 4, "the knots in u decrease at '-2'"},
                 {v, "-1 -1 .5 .25", 6, "the knots in v decrease at '.25'"},
                 {u, "0 0 0 0 2 2 3", 4, "knot 4 of 7 in u is repeated more than 3 times"},
                 {u, "-1 0 0 2 2 2 2", 4, "knot 7 of 7 in u is repeated more than 3 times"},
                 {u, "-1 0 1 1 1 2 3", 4, "knot 3 of 7 in u is equal to knot 5: empty domain"},
                 {v, "1 1 1 1", 6, "knot 2 of 4 in v is equal to knot 3: empty domain"},
                 {v, "1/2 .5 5e-1 1", 6, "knot 2 of 4 in v is equal to knot 3: empty domain"},
                 {u, "-1 0 0 nan 2 2 3", 4, "not a number: 'nan'"},
                 {u, "-inf 0 0 1/2 2 2 3", 4, "not a number: '-inf'"},
                 {u, "-1 0 0 1/0 2 2 3", 4, "zero denominator: '1/0'"}});
}

BOOST_AUTO_TEST_CASE(wrong_coordinates) {
  check_refused({{"1/3", "nan", 11, "not a number: 'nan'"},
                 {"1/3", "1/0", 11, "zero denominator: '1/0'"},
                 {"1/3", std::string(100000, '1'), 11,
                  "more than 4096 characters without a space: '" + std::string(40, '1') + "...'"}});
  BOOST_CHECK_EQUAL(error_of([&] { read<Double_3>(altered("1/3", "1e309")); }),
                    "malformed_input: f.g2:11: outside the range of floating-point numbers: '1e309'");
  BOOST_CHECK_EQUAL(read<Exact_3>(altered("1/3", "1e309")).size(), 1); // an exact number
}

// However a text is cut or one of its words replaced: it is read, or refused with file, line and
// reason.
BOOST_AUTO_TEST_CASE(every_word_is_checked) {
  const std::vector<std::string> words = words_of(good);
  const auto joined = [](const std::vector<std::string>& w) {
    std::string text;
    for (const std::string& x : w) text += x + '\n'; // word i is in line i + 1
    return text;
  };
  for (std::size_t n = 1; n < words.size(); ++n) {
    const std::string error = error_of([&] { read<Exact_3>(joined({words.begin(), words.begin() + n})); });
    BOOST_CHECK_EQUAL(error.find("malformed_input: f.g2:" + std::to_string(n) + ": file ends "), 0);
  }
  int refused = 0;
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const std::string bad :
         {"nan", "inf", "1/0", "-1", "0", "1", "2147483647", "99999999999999999999", "1e5000", "x", "\xFF", "1 1"}) {
      std::vector<std::string> changed = words;
      changed[i] = bad;
      const std::string error = error_of([&] { read<Exact_3>(joined(changed)); });
      if (error == "no error") continue;
      ++refused;
      BOOST_CHECK_EQUAL(error.find("malformed_input: f.g2:"), 0);
    }
  BOOST_CHECK_GT(refused, 8 * int(words.size())); // all but some natural numbers
}
