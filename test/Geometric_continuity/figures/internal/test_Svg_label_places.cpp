// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The places of labels in a picture, compared with those that a search through all points finds.

#include "support/test.h"

#include <Geometric_continuity_figures/internal/svg_text.h>

BOOST_AUTO_TEST_SUITE(places_of_labels)

using GC::internal::Svg_label_places;
using GC::internal::Svg_pixel;
using GC::internal::svg_vector;

namespace {

constexpr double width = 120, height = 90;

// How far a box is from the edge and from all points, at most 12.
double free_distance(const Svg_pixel& q, const Svg_pixel& half, const std::vector<Svg_pixel>& drawn) {
  double distance = (std::min)(
      {12.0, q[0] - half[0] - 2, width - q[0] - half[0] - 2, q[1] - half[1] - 2, height - q[1] - half[1] - 2});
  for (const Svg_pixel& o : drawn) {
    const double dx = (std::max)(0.0, std::abs(o[0] - q[0]) - half[0]),
                 dy = (std::max)(0.0, std::abs(o[1] - q[1]) - half[1]);
    distance = (std::min)(distance, std::sqrt(dx * dx + dy * dy));
  }
  return distance;
}

// The first with the greatest distance of the eight places, as far as they are in the panel; of
// those farther away if none is.
std::optional<Svg_pixel> place(const Svg_pixel& p, double text_width, const std::vector<Svg_pixel>& drawn) {
  const Svg_pixel half = svg_vector({0.5 * text_width, 4.5});
  const std::array<std::array<double, 2>, 8> directions = {
      {{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {0.7, -0.8}, {-0.7, -0.8}, {0.7, 0.8}, {-0.7, 0.8}}};
  for (double gap : {8., 18., 30., 44.}) {
    std::vector<Svg_pixel> places;
    for (const auto& d : directions) {
      const Svg_pixel q = p + svg_vector({d[0] * (half[0] + gap), d[1] * (half[1] + gap)});
      if (0 <= q[0] && q[0] <= width && 0 <= q[1] && q[1] <= height) places.push_back(q);
    }
    if (places.empty()) continue;
    return *std::max_element(places.begin(), places.end(), [&](const Svg_pixel& a, const Svg_pixel& b) {
      return free_distance(a, half, drawn) < free_distance(b, half, drawn);
    });
  }
  return std::nullopt;
}

} // namespace

// A point at a distance of 11 pixels, in the last cell where one less than 12 may be.
BOOST_AUTO_TEST_CASE(the_last_cell_counts) {
  const Svg_pixel p = svg_vector({50.0, 40.0}), above = svg_vector({50.0, 27.5}), below = svg_vector({50.0, 52.5});
  Svg_label_places places(width, height);
  BOOST_CHECK(places.place(p, 19) == above);
  const Svg_pixel right = svg_vector({50 + 9.5 + 11, 27.5});
  places.add_point(right);
  BOOST_CHECK(place(p, 19, {right}) == below && places.place(p, 19) == below);
}

BOOST_AUTO_TEST_CASE(the_freest_of_eight_places) {
  const unsigned seed = 20261122;
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(-30, width + 30), y(-30, height + 30), text(0, 40);
  for (int points : {0, 1, 5, 40, 200, 800}) { // of which few share a cell
    Svg_label_places places(width, height);
    std::vector<Svg_pixel> drawn;
    for (int i = 0; i < points; ++i) {
      drawn.push_back(svg_vector({x(random), y(random)}));
      places.add_point(drawn.back());
    }
    for (int i = 0; i < 200; ++i) {
      const Svg_pixel p = svg_vector({x(random), y(random)});
      const double text_width = text(random);
      BOOST_CHECK(places.place(p, text_width) == place(p, text_width, drawn));
    }
  }
}

// A crowd of points hides no other, and a point that is not finite does no harm.
BOOST_AUTO_TEST_CASE(crowds) {
  Svg_label_places places(width, height);
  for (int i = 0; i < 100000; ++i) places.add_point(svg_vector({60.0 + 1e-6 * i, 20.0}));
  places.add_point(svg_vector({60.0, 70.0}));
  places.add_point(svg_vector({std::nan(""), 0.0}));
  places.add_point(svg_vector({HUGE_VAL, -HUGE_VAL}));
  const Svg_pixel above = places.place(svg_vector({60.0, 32.5}), 10).value(),
                  below = places.place(svg_vector({60.0, 57.5}), 10).value();
  BOOST_CHECK(above[1] > 32.5 || above[0] != 60);
  BOOST_CHECK(below[1] < 57.5 || below[0] != 60);
  // a segment is as its ends and the points between them
  Svg_label_places segment(width, height), same(width, height);
  segment.add_segment(svg_vector({10.0, 40.0}), svg_vector({50.0, 40.0}), 4);
  for (double x : {10.0, 20.0, 30.0, 40.0, 50.0}) same.add_point(svg_vector({x, 40.0}));
  for (double x = 0; x < width; x += 5) {
    const Svg_pixel p = svg_vector({x, 48.0});
    BOOST_CHECK(segment.place(p, 12) == same.place(p, 12));
  }
}

// Labels at one point keep clear of each other, until there is no room.
BOOST_AUTO_TEST_CASE(labels_do_not_overlap) {
  Svg_label_places places(width, height);
  const Svg_pixel p = svg_vector({60.0, 45.0}), half = Svg_label_places::half_size(14);
  std::vector<Svg_pixel> labels;
  while (const std::optional<Svg_pixel> q = places.place(p, 14)) {
    for (const Svg_pixel& other : labels)
      BOOST_CHECK(std::abs((*q)[0] - other[0]) >= 2 * half[0] - 1e-9 ||
                  std::abs((*q)[1] - other[1]) >= 2 * half[1] - 1e-9);
    places.take(*q, half);
    labels.push_back(*q);
    BOOST_REQUIRE_LT(labels.size(), 100);
  }
  BOOST_CHECK_GE(labels.size(), 12);
  const Svg_label_places panel(10, 20);
  for (const Svg_pixel& p :
       {svg_vector({11.0, 5.0}), svg_vector({-1.0, 5.0}), svg_vector({5.0, -1.0}), svg_vector({5.0, 21.0})})
    BOOST_CHECK(!panel.is_in_panel(p));
  for (const Svg_pixel& p : {svg_vector({0.0, 0.0}), svg_vector({10.0, 20.0}), svg_vector({5.0, 15.0})})
    BOOST_CHECK(panel.is_in_panel(p));
}

BOOST_AUTO_TEST_SUITE_END()
