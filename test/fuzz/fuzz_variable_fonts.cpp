// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Variable fonts: what is read is judged at all instances, and the angles at some instances lie
// within the bounds.

#include "fuzz_target.h"

#include "formats/font/Variable_font.h"
#include "formats/font/glyph_parts.h"

#include "formats/font/largest_kink.h"

namespace {

typedef CGAL::Exact_rational Exact;

constexpr int max_glyphs = 8;        // of which the joins are judged
constexpr std::size_t max_joins = 8; // of each glyph

void check(const GC::Variable_join& join, const GC::Variable_outline& glyph, const GC::Variable_font& font) {
  const GC::Corner_threshold bound;
  const GC::Kink_search search{0.01, 1e-5, GC::Work_limit(100000)};
  const GC::Largest_kink kink = GC::largest_kink(join, glyph.regions, font.ranges(), bound, search);
  require(0 <= kink.angle.lower && kink.angle.lower <= kink.angle.upper && kink.angle.upper < 3.2,
          "bounds are in order");
  const auto check_at = [&](const std::vector<Exact>& wanted) {
    std::vector<Exact> instance;
    for (std::size_t k = 0; k < font.axes().size(); ++k) {
      const GC::Variation_axis& axis = font.axes()[k];
      instance.push_back((std::max)(Exact(axis.range().lowest), (std::min)(Exact(axis.range().highest), wanted[k])));
      const Exact value = axis.user_value(instance.back());
      require(axis.minimum <= value && value <= axis.maximum, "an instance has values for users");
    }
    const auto [cross, dot] = join.products(GC::region_scalars(glyph.regions, instance));
    if (cross == 0 && dot == 0) return;
    require(GC::angle_enclosure(Exact(cross * cross), dot).lower <= kink.angle.upper, "no angle is above the bound");
    require(kink.verdict != GC::Verdict::proved || !bound.is_exceeded(cross, dot), "what is proved is true");
  };
  for (int i = -3; i <= 3; ++i) check_at(std::vector<Exact>(font.axes().size(), Exact(i) / 3));
  for (std::size_t r = 0; r < (std::min)(glyph.regions.size(), std::size_t(4)); ++r) {
    std::vector<Exact> peaks;
    for (const GC::Region_axis& axis : glyph.regions[r].axes()) peaks.push_back(Exact(axis.peak));
    check_at(peaks);
  }
}

void read(std::string_view bytes, std::size_t face) {
  const GC::Variable_font font{GC::Font_tables(bytes, face)};
  for (int i = 0; i < (std::min)(font.glyph_count(), max_glyphs); ++i)
    accepts([&] {
      const GC::Variable_outline glyph = font.glyph(i);
      const std::vector<GC::Outline_join> joins = GC::outline_joins(glyph);
      require(joins.size() <= glyph.points.size(), "a join is at a point");
      for (std::size_t j = 0; j < (std::min)(joins.size(), max_joins); ++j) check(joins[j].join, glyph, font);
      require(GC::glyph_parts(font, glyph.components).size() <= max_glyph_parts, "a glyph has parts");
    });
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzz_text(data, size);
  accepts([&] {
    const std::size_t faces = GC::Font_tables::face_count(bytes);
    for (std::size_t face = 0; face < (std::min)(faces, std::size_t(2)); ++face) accepts([&] { read(bytes, face); });
  });
  return 0;
}
