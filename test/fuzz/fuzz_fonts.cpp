// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Fonts: all glyphs of all fonts of a file, as the program reads them. Their joins are graded on
// integers as by the library.

#include "fuzz_target.h"

#include "commands/fonts/Glyph_join.h"
#include "commands/fonts/Graded_joins.h"
#include "formats/font/Font_face.h"
#include "formats/font/Glyph_selection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/joins/Visual_class.h>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef GC::Bezier_curve<GC::Traits_2<Kernel>> Curve;

constexpr int max_glyphs = 20; // of one font

Curve curve(const Glyph_segment& segment) {
  std::vector<Kernel::Point_2> points;
  for (int i = 0; i <= segment.degree; ++i) {
    const Glyph_point& p = segment.points[static_cast<std::size_t>(i)];
    points.emplace_back(static_cast<double>(p.x), static_cast<double>(p.y)); // below 2^52
  }
  return Curve(points.begin(), points.end());
}

void check_outline(const Glyph_outline& outline, const GC::Corner_threshold& bound) {
  std::size_t joins = 0;
  for (std::size_t contour = 0; contour < outline.contours(); ++contour) {
    const Glyph_segment *const begin = outline.begin(contour), *const end = outline.end(contour), *left = end - 1;
    require(begin != end, "a contour has segments");
    for (const Glyph_segment* right = begin; right != end; left = right++, ++joins) {
      require(!right->has_no_length(), "a segment has a length");
      require(left->end() == right->start(), "a segment starts where the one before it ends");
      const Glyph_join join(*left, *right, outline.steps());
      if (joins < 200) // which are many for one input
        require(GC::visual_class(curve(*left), curve(*right), bound) == join.on_grid().visual_class(bound),
                "the grade is that of the library");
    }
  }
  require(joins == outline.size(), "a contour has as many joins as segments");
  Join_rule rule;
  rule.corner = bound;
  rule.required = GC::Visual_class::g2;
  const Join_counts counts = grade_joins(outline, rule, [](auto&&...) {});
  require(counts.joins() == joins, "each join is counted");
  require(counts.failing() == counts[Glyph_grade::kink] + counts[Glyph_grade::g1], "what is not G2 fails");
}

void check_font(std::string_view bytes, int index, int& fonts) {
  static const GC::Corner_threshold bound;
  const Font_face font(bytes, index);
  fonts = (std::min)(font.fonts_of_file(), 4);
  require(!font.has_outlines() || font.units_per_em() > 0, "an em has units");
  std::vector<std::string> missing;
  Glyph_selection("a-z,U+00E9,ampersand,#0-#3").glyphs(font, missing);
  font.name();
  Glyph_outline outline;
  for (int glyph = 0; glyph < (std::min)(font.glyphs(), max_glyphs); ++glyph) {
    require(!font.glyph_name(glyph).empty(), "a glyph has a name");
    try {
      font.read(glyph, outline);
      check_outline(outline, bound);
    } catch (const Font_error& error) {
      require(error.what()[0] != '\0', "what is not read has a reason");
    }
  }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz_text(data, size);
  int fonts = 1;
  for (int i = 0; i < fonts; ++i) try {
      check_font(bytes, i, fonts);
    } catch (const Font_error& error) {
      require(error.what()[0] != '\0', "what is not read has a reason");
    }
  return 0;
}
