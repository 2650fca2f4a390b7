// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers, texts and outlines of pictures, and places of labels at the edges of a panel.

#include "support/test.h"

#include <Geometric_continuity_figures/internal/Svg_contours.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>
#include <Geometric_continuity_figures/internal/svg_text.h>

BOOST_AUTO_TEST_SUITE(svg_markup)

using namespace CGAL::Geometric_continuity::internal;

// Numbers and texts of any kind are written into a picture.
BOOST_AUTO_TEST_CASE(numbers_texts_and_outlines) {
  BOOST_CHECK_EQUAL(svg_number(std::nan("")), "0");
  BOOST_CHECK_EQUAL(svg_number(std::numeric_limits<double>::infinity()), "1000000");
  BOOST_CHECK_EQUAL(svg_number(-1e300), "-1000000");
  for (double x : {1e3, 1e-3, 3.0}) // also where the logarithm is rounded to the next whole number
    for (double y : {std::nextafter(x, 0.), x}) {
      const Round_step step = round_step(y);
      BOOST_CHECK(step.value() <= y && y < 2.5 * step.value());
    }
  BOOST_CHECK_EQUAL(svg_escape("a\x7f\tb"), "a  b");
  const auto outline = [](const std::vector<std::pair<double, double>>& points) {
    std::vector<Svg_pixel> polygon;
    for (const auto& p : points) polygon.push_back(svg_vector({p.first, p.second}));
    return svg_outline(polygon);
  };
  BOOST_CHECK_EQUAL(outline({{1, 1}, {1.01, 1.01}, {3, 1}, {3, 2}}), outline({{1, 1}, {3, 1}, {3, 2}}));
  // a line that comes back to where it starts is no point
  const std::vector<Svg_pixel> there_and_back{svg_vector({1., 1.}), svg_vector({5., 4.}), svg_vector({1., 1.})};
  BOOST_CHECK(svg_simplified(there_and_back, {0.1, 0.1, 0.1}, false) == there_and_back);
  BOOST_CHECK_EQUAL(svg_simplified(there_and_back, {9., 9., 9.}, false).size(), 2u);
  // a letter of two bytes at the end of a word that is wider than the line
  const std::string letters = "\xc3\xa4\xc3\xa4\xc3\xa4";
  for (const std::string& line : wrapped_lines(letters, 10, 1)) BOOST_CHECK_EQUAL(line, "\xc3\xa4");
  BOOST_CHECK_EQUAL(wrapped_lines(letters, 10, 1).size(), 3u);
  BOOST_CHECK_EQUAL(wrapped_lines("mm", 10, 1).size(), 2u);
}

// Points that are taken or drawn outside of a panel, on each side, do not matter; points across its
// edge do.
BOOST_AUTO_TEST_CASE(places_of_labels_at_the_edges) {
  const Svg_pixel middle = svg_vector({50., 40.}), half = svg_vector({10., 10.}), wide = svg_vector({200., 200.});
  const Svg_label_places empty(100, 80);
  const Svg_pixel best = *empty.place(middle, 20);
  for (const Svg_pixel& p : {svg_vector({-20., 40.}), svg_vector({120., 40.}), svg_vector({50., -20.}),
                             svg_vector({50., 100.}), svg_vector({-20., -20.})}) {
    Svg_label_places places(100, 80);
    BOOST_CHECK(empty.is_in_panel(middle) && !empty.is_in_panel(p));
    places.take(p, half);
    places.add_point(p);
    BOOST_CHECK(*places.place(middle, 20) == best);
    places.take(p, wide);
    BOOST_CHECK(!places.place(middle, 20));
  }
}

BOOST_AUTO_TEST_SUITE_END()
