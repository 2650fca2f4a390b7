// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_KINKS_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_KINKS_H

#include "formats/font/Variable_font.h"
#include "reports/Report.h"

#include "formats/font/largest_kink.h"

#include <cstddef>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The demands on the joins of variable fonts.
struct Instance_bounds {
  // above it an angle of the default instance is a corner, which is meant
  GC::Corner_threshold corner;
  GC::Corner_threshold max_kink; // which no instance of the other joins should exceed
  GC::Work_limit limit;          // for each join
};

// The counts of joins over all instances.
struct Instance_counts {
  std::size_t joins = 0;
  std::size_t corners = 0;      // at the default instance
  std::size_t no_direction = 0; // a handle has no length at the default instance: not covered
  std::size_t proved = 0, refuted = 0, undecided = 0;
  std::size_t smooth = 0;   // of the proved ones: the angle is 0 in every instance
  std::size_t vanishes = 0; // of these three: a handle has no length at some instance

  Instance_counts& operator+=(const Instance_counts& other);
};

// A join whose angle is not zero in every instance.
struct Instance_kink {
  int glyph, part; // the glyph of which the outline is: another one where that is stretched
  int contour, point;
  double x, y; // at the default instance
  GC::Largest_kink kink;
  GC::Enclosure initial_angle; // at the default instance, in radians
  // at the instance of the kink: the angle times the shorter handle over the em
  double severity;
  std::string glyph_name = {}, part_name = {}, font_name = {};
  std::vector<std::string> instance = {}; // one text for each axis, e.g. "wght 650"
};

// The results about the joins of a glyph.
struct Instance_joins {
  Instance_counts counts;
  std::vector<Instance_kink> kinks;             // those whose angle is not zero in every instance
  std::vector<GC::Outline_join> without_length; // which are not covered
};

// Decides joins of a glyph, which are those of an outline that is the glyph's or a part of it.
void judge_instances(int glyph, int part, const GC::Variable_outline& outline,
                     const std::vector<GC::Outline_join>& joins, const GC::Variable_font& font,
                     const Instance_bounds& bounds, Instance_joins& result);

// The value of an axis for people.
std::string axis_text(const GC::Variation_axis& axis, const GC::Variation_axis::FT& normalised);

// The values of the axes, e.g. "wght 650".
std::vector<std::string> instance_texts(const std::vector<GC::Variation_axis>& axes, const GC::Largest_kink& kink);

// The axes as an array of JSON objects.
std::string axes_json(const std::vector<GC::Variation_axis>& axes);

// Returns whether a kink is to be shown before another one: first by what the eye sees.
bool shown_before(const Instance_kink& x, const Instance_kink& y);

// E.g. "12 joins: 4 corners, ...".
std::string counts_text(const Instance_counts& counts, const std::string& max_kink);

// The members of a JSON object.
std::string counts_json(const Instance_counts& counts);

// A sentence without the place.
std::string kink_text(const Instance_kink& kink);

// A table for people.
std::string kinks_table(const std::vector<Instance_kink>& kinks, const std::string& indentation);

// The members of a JSON object.
std::string kink_json(const Instance_kink& kink, const std::vector<GC::Variation_axis>& axes);

// An array of such objects.
std::string kinks_json(const std::vector<Instance_kink>& kinks, const std::vector<GC::Variation_axis>& axes);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_FONTS_INSTANCE_KINKS_H
