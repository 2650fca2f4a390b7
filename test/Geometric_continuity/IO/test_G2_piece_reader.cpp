// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Curves in .g2 files that are read piece by piece.

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/G2_span_reader.h>
#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>

BOOST_AUTO_TEST_SUITE(G2_piece_reader)

typedef std::vector<GC::Rational_bezier_curve<Exact_2>> Pieces;

template <class Source> Pieces read_pieces(const std::string& text) {
  std::istringstream is(text);
  GC::G2_piece_reader<Exact_2, Source> reader(is, "f.g2");
  Pieces pieces;
  while (const std::optional<GC::Rational_bezier_curve<Exact_2>> piece = reader.next()) pieces.push_back(*piece);
  return pieces;
}

// Returns whether the jets at the ends of these pieces are read.
template <class Number> bool reads_ends(const std::string& text, int order, const Pieces& pieces) {
  std::istringstream is(text);
  GC::G2_span_reader<Exact_2, Number> reader(is, "f.g2", order);
  GC::G2_span<Exact_2, Number> span;
  for (const GC::Rational_bezier_curve<Exact_2>& piece : pieces) {
    if (!reader.next(span)) return false;
    const GC::Curve_end_jets<Exact_2>& ends = span.jets();
    if (ends.start_jet(order) != piece.start_jet(order) || ends.end_jet(order) != piece.end_jet(order)) return false;
  }
  return !reader.next(span);
}

// The pieces of the curves that are read as a whole.
Pieces pieces_of_curves(const std::string& text) {
  std::istringstream is(text);
  Pieces pieces;
  for (const GC::Bspline_curve<Exact_2>& curve : GC::read_g2_bsplines<Exact_2>(is, "f.g2"))
    for (const auto& piece : curve.bezier_pieces()) pieces.push_back(piece);
  return pieces;
}

// Splines of all degrees, with knots of all multiplicities, also outside of the domain and at its
// ends. The numbers are halves of integers, which are the same in floating point.
BOOST_AUTO_TEST_CASE(the_pieces_are_those_of_the_curves) {
  std::mt19937 random = seeded(20261122);
  std::ostringstream text;
  for (int i = 0; i < 200; ++i) {
    const int order = i % 25 == 0 ? 15 + i / 25 % 4 : 1 + i % 6, points = order + static_cast<int>(random() % 12);
    // in halves; u_{j + order} > u_j, and the domain is not empty
    std::vector<int> knots(points + order);
    for (int j = 0; j < points + order; ++j) {
      knots[j] = j == 0 ? -3 : knots[j - 1] + (random() % 3 == 0 ? static_cast<int>(random() % 4) : 0);
      if (j >= order && knots[j] == knots[j - order]) ++knots[j];
      if (j == points && knots[j] == knots[order - 1]) ++knots[j];
    }
    text << "100 1 0 0 2 0\n" << points << ' ' << order << '\n';
    for (int u : knots) text << u << "/2 ";
    for (int j = 0; j < 2 * points; ++j) text << '\n' << static_cast<int>(random() % 100) * 0.5;
    text << "\n\n";
  }
  const Pieces expected = pieces_of_curves(text.str());
  BOOST_CHECK_GT(expected.size(), 400);
  BOOST_CHECK(read_pieces<Exact_2>(text.str()) == expected);
  BOOST_CHECK(read_pieces<Double_2>(text.str()) == expected);
  for (int order : {0, 3, 20}) BOOST_CHECK(reads_ends<GC::Decimal>(text.str(), order, expected));
  BOOST_CHECK(reads_ends<double>(text.str(), 3, expected));
  std::istringstream is(text.str());
  CHECK_ERROR((GC::G2_span_reader<Exact_2>(is, "f.g2", -1)), negative_count);
}

// Numbers are rounded where the source says so, and before anything is computed.
BOOST_AUTO_TEST_CASE(numbers_of_the_source) {
  const std::string text = "100 1 0 0\n2 0\n3 2\n0 0 .1 1 1\n0 0\n.1 .2\n1 0\n";
  const Pieces exact = read_pieces<Exact_2>(text), rounded = read_pieces<Double_2>(text);
  BOOST_REQUIRE_EQUAL(exact.size(), 2);
  BOOST_REQUIRE_EQUAL(rounded.size(), 2);
  BOOST_CHECK(exact[0].domain().second == Q(1) / 10);
  BOOST_CHECK(rounded[0].domain().second == Q(0.1));
  BOOST_CHECK(rounded[1].control_point(0).y() == Q(0.2));
}

// In the words of the reader of whole curves, with line and reason, wherever the text is wrong.
BOOST_AUTO_TEST_CASE(refused_as_whole_curves) {
  const std::string header = "100 1 0 0\n2 0\n", points = "\n0 0\n1 2\n3 4\n5 6\n";
  for (const std::string& text :
       {std::string(), header, header + "4 3\n0 0 0 1/2 2 2\n1" + points, header + "4 3\n0 0 1\n.5 2 2 2" + points,
        header + "4 3\n0 0 0\n0 2 2 2" + points, header + "4 3\n0 1 2 2 2 3 4" + points,
        header + "4 3\n0 0 0 1 1 1\n1" + points, header + "4 5\n" + points, header + "4 129\n" + points,
        header + "2147483647 3\n0 0 0 1 2 x" + points, header + "5 3\n0 0 0 1 2 3 3 3" + points,
        header + "40 3\n0" + points, header + "4 3\n0 0 0 1 2 2 2\n0 0\n1 2\n3 4\n5 six\n",
        header + "4 3\n0 0 0 1 2 2 2" + points + "100 1 0 0\n3 0\n", header + "4 3\n0 0 0 1 2 2 2" + points + "200"}) {
    const std::string expected = error_of([&] { pieces_of_curves(text); });
    BOOST_CHECK_NE(expected, "no error");
    BOOST_CHECK_EQUAL(error_of([&] { read_pieces<Exact_2>(text); }), expected);
  }
  // with rounded numbers
  const std::string far_apart = header + "2 2\n-1e308 -1e308 1e308 1e308\n0 0 1 1\n";
  BOOST_CHECK_EQUAL(
      error_of([&] { read_pieces<Double_2>(far_apart); }),
      "malformed_input: f.g2:4: the difference of the knots is outside the range of floating-point numbers");
}

BOOST_AUTO_TEST_SUITE_END()
