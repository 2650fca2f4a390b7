// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Joins over axes: their vectors and corners at single instances. The largest kinks over all of
// them are in test_largest_kink.cpp.

#define BOOST_TEST_MODULE variable_joins
#include "support/test.h"

#include "formats/font/Variable_join.h"

typedef GC::Variable_join::FT FT;
typedef GC::Variable_vector::Vector Vector;

// One axis: the outgoing side is (1, 0) and turns to (1, 1).
BOOST_AUTO_TEST_CASE(corners_at_instances) {
  const std::vector<GC::Variation_region> regions{GC::Variation_region({{0, 1, 1}})};
  const GC::Variable_vector incoming{Vector{FT(2), FT(0)}, {Vector{FT(0), FT(0)}}},
      outgoing{Vector{FT(1), FT(0)}, {Vector{FT(0), FT(1)}}}, vanishing{Vector{FT(-1), FT(0)}, {Vector{FT(1), FT(0)}}};
  const auto scalars = [&](const FT& x) { return region_scalars(regions, {x}); };
  const GC::Variable_join join{incoming, outgoing};
  const GC::Corner_threshold bound(FT(5));
  BOOST_CHECK(is_corner(join, scalars(FT(-1)), bound) == false);
  BOOST_CHECK(is_corner(join, scalars(FT(0)), bound) == false);
  BOOST_CHECK(is_corner(join, scalars(FT(1)), bound) == true);
  // the slope 0.08748866 is the tangent of 5 degrees
  BOOST_CHECK(is_corner(join, scalars(FT(0.0874)), bound) == false);
  BOOST_CHECK(is_corner(join, scalars(FT(0.0875)), bound) == true);
  const GC::Variable_join singular{incoming, vanishing};
  BOOST_CHECK(is_corner(singular, scalars(FT(0)), bound) == true); // turns back
  BOOST_CHECK(!is_corner(singular, scalars(FT(1)), bound).has_value());
}

BOOST_AUTO_TEST_CASE(zero_vectors) {
  const Vector o{FT(0), FT(0)}, x{FT(1), FT(0)}, y{FT(0), FT(1)};
  BOOST_CHECK((GC::Variable_vector{o, {}}.is_zero()));
  BOOST_CHECK((GC::Variable_vector{o, {o, o}}.is_zero()));
  for (const Vector& v : {x, y}) {
    BOOST_CHECK((!GC::Variable_vector{v, {o}}.is_zero()));
    BOOST_CHECK((!GC::Variable_vector{o, {o, v}}.is_zero()));
  }
}

// Only regions that rise and fall on one side of the default count.
BOOST_AUTO_TEST_CASE(axes_that_count) {
  for (const GC::Region_axis& axis : {GC::Region_axis{0, 0.5, 1}, {0, 1, 1}, {-1, -1, 0}, {0.25, 0.25, 0.25}})
    BOOST_CHECK(axis.counts());
  for (const GC::Region_axis& axis :
       {GC::Region_axis{-1, 0, 1}, {0, 0, 1}, {0.5, 0.25, 1}, {0, 1, 0.5}, {-0.5, 0.25, 1}, {-1, -0.5, 0.25}})
    BOOST_CHECK(!axis.counts());
}
