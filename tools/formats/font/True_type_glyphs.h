// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_GLYPHS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_GLYPHS_H

#include "formats/font/Font_error.h"
#include "formats/font/Glyph_outline.h"
#include "formats/font/True_type_outlines.h"
#include "formats/font/leaf_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_TRIGONOMETRY_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

// The glyphs of a TrueType font that FreeType has opened, and unpacked if need be, at the default
// instance: their points are exactly those of the table 'glyf', also where a component is scaled.
// Damaged tables are read as FreeType reads them, whose words for errors these are.
class True_type_glyphs {
  typedef CGAL::Geometric_continuity::True_type_outline Outline;
  typedef CGAL::Geometric_continuity::Glyph_component Component;
  static constexpr std::size_t max_points = 0x7ffb; // of a glyph, as to FreeType
  static constexpr const char *invalid_outline = "invalid outline", *invalid_composite = "invalid composite glyph";

  FT_Face face_;
  std::string glyphs_, places_; // tables 'glyf' and 'loca'
  std::size_t place_size_ = 2, place_count_ = 0;

  // The parts of which a glyph consists in the end, and their outlines.
  struct Leaves {
    std::vector<Glyph_part> parts = {};
    std::vector<Outline> outlines = {};
    std::size_t points = 0;
  };

  std::size_t table_size(FT_ULong tag) const {
    FT_ULong size = 0;
    return FT_Load_Sfnt_Table(face_, tag, 0, nullptr, &size) == 0 ? size : 0;
  }
  std::string table(FT_ULong tag, FT_ULong size) const {
    std::string bytes(size, '\0');
    if (size == 0 || FT_Load_Sfnt_Table(face_, tag, 0, reinterpret_cast<FT_Byte*>(bytes.data()), &size) != 0) return {};
    return bytes;
  }

  std::size_t place(std::size_t glyph) const {
    std::size_t x = 0;
    for (std::size_t i = place_size_ * glyph; i < place_size_ * (glyph + 1); ++i)
      x = x << 8 | static_cast<unsigned char>(places_[i]);
    return place_size_ == 2 ? 2 * x : x;
  }

  // Returns the bytes of a glyph; none where its place is outside of the table, but the last place
  // is taken for the end of the table.
  std::string_view bytes_of(std::size_t glyph) const {
    if (place_count_ <= glyph) return {};
    const std::size_t begin = place(glyph);
    std::size_t end = glyph + 1 < place_count_ ? place(glyph + 1) : begin;
    if (glyph + 2 == place_count_) end = (std::min)(end, glyphs_.size());
    if (glyphs_.size() < begin || glyphs_.size() < end) return {};
    return std::string_view(glyphs_).substr(begin, (end < begin ? glyphs_.size() : end) - begin);
  }

  Outline outline(int glyph) const {
    const std::string_view bytes = bytes_of(static_cast<std::size_t>(glyph));
    if (bytes.empty()) return {};
    Outline result;
    try {
      result = CGAL::Geometric_continuity::read_true_type_outline({bytes, "glyph"});
    } catch (const CGAL::Geometric_continuity::Error&) {
      const bool is_composite = (bytes[0] & 0x80) != 0 && bytes.size() >= 10;
      throw Font_error(is_composite ? invalid_composite : invalid_outline);
    }
    if (result.points.size() > max_points) throw Font_error(invalid_outline);
    for (const Component& component : result.components)
      if (component.glyph >= face_->num_glyphs) throw Font_error(invalid_composite);
    return result;
  }

  Leaves leaves(const std::vector<Component>& components) const {
    Leaves result;
    append_leaf_parts(
        components, result.parts,
        [&](int glyph) {
          Outline part = outline(glyph);
          const std::vector<Component> inner = part.components;
          if (inner.empty()) {
            check_coordinates(part);
            result.points += part.points.size();
            if (result.points > max_points) throw Font_error("array allocation size too large");
            result.outlines.push_back(std::move(part));
          }
          return inner;
        },
        [&](const Component& component, std::size_t first, std::size_t begin) {
          return offset(component, result, first, begin);
        });
    return result;
  }

  // Where a component stands whose own parts begin at `begin`; the glyph of which it is one begins
  // at `first`.
  static Part_offset offset(const Component& component, const Leaves& leaves, std::size_t first, std::size_t begin) {
    const Part_matrix m = part_matrix(component);
    if (!component.has_offset) {
      const auto has_points = [](const Outline& outline) { return !outline.points.empty(); };
      if (std::none_of(leaves.outlines.begin() + static_cast<std::ptrdiff_t>(begin), leaves.outlines.end(), has_points))
        return {};
      const Part_offset to = point(leaves, first, begin, component.x),
                        from = point(leaves, begin, leaves.parts.size(), component.y);
      return Glyph_part{component.glyph, {-m.xx, -m.xy, -m.yx, -m.yy, m.shift}, to}(from);
    }
    if (!component.scales_offset) return {component.x, component.y};
    if (m.is_diagonal() && m.xx > 0 && m.yy > 0)
      return Part_offset::reduced(component.x * m.xx, component.y * m.yy, m.shift);
    // rounded, as by FreeType
    const auto scaled = [&m](int x, std::int64_t a, std::int64_t b) -> std::int64_t {
      const std::int64_t unit = std::int64_t(0x10000) >> m.shift;
      FT_Vector column{static_cast<FT_Pos>(a * unit), static_cast<FT_Pos>(b * unit)};
      return FT_MulFix(x, FT_Vector_Length(&column));
    };
    return {scaled(component.x, m.xx, m.xy), scaled(component.y, m.yy, m.yx)};
  }

  // The point of this number among those of some leaves.
  static Part_offset point(const Leaves& leaves, std::size_t begin, std::size_t end, int number) {
    std::size_t left = static_cast<std::size_t>(number);
    for (std::size_t i = begin; i < end; ++i) {
      const auto& points = leaves.outlines[i].points;
      if (left < points.size()) return leaves.parts[i]({points[left].x, points[left].y});
      left -= points.size();
    }
    throw Font_error(invalid_composite);
  }

  // Draws an outline in halves of a unit. Two control points in succession have their midpoint on
  // the curve.
  static void draw(const Outline& glyph, Glyph_outline& outline) {
    std::size_t begin = 0;
    for (const int contour_end : glyph.contour_ends) {
      std::size_t next = begin, end = static_cast<std::size_t>(contour_end);
      begin = end;
      const auto on_curve = [&](std::size_t i) { return glyph.points[i].on_curve; };
      const auto at = [&](std::size_t i) { return Glyph_point{2 * glyph.points[i].x, 2 * glyph.points[i].y}; };
      const auto middle = [](const Glyph_point& p, const Glyph_point& q) {
        return Glyph_point{(p.x + q.x) / 2, (p.y + q.y) / 2};
      };
      const Glyph_point start = on_curve(next)      ? at(next++)
                                : on_curve(end - 1) ? at(--end)
                                                    : middle(at(next), at(end - 1));
      Glyph_point from = start;
      while (next != end) {
        const Glyph_point p = at(next++);
        if (on_curve(next - 1)) {
          outline.add({1, {from, p}});
          from = p;
          continue;
        }
        const Glyph_point to = next == end ? start : on_curve(next) ? at(next++) : middle(p, at(next));
        outline.add({2, {from, p, to}});
        from = to;
      }
      outline.add({1, {from, start}});
      outline.end_contour();
    }
  }

  static void check_coordinates(const Outline& glyph) {
    for (const auto& p : glyph.points)
      if (std::abs(p.x) > Glyph_outline::max_coordinate || std::abs(p.y) > Glyph_outline::max_coordinate)
        refuse_coordinate(Glyph_outline::max_coordinate);
  }

public:
  explicit True_type_glyphs(FT_Face face) : face_(face), glyphs_(table(TTAG_glyf, table_size(TTAG_glyf))) {
    if (const auto* head = static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD)))
      place_size_ = head->Index_To_Loc_Format == 0 ? 2 : 4;
    // FreeType reads beyond a table that is said to be shorter than it is, or leaves out the last
    // glyphs.
    const std::size_t count = (std::max)((std::min)(table_size(TTAG_loca) / place_size_, std::size_t(0x10000)),
                                         static_cast<std::size_t>(face->num_glyphs) + 1);
    places_ = table(TTAG_loca, static_cast<FT_ULong>(count * place_size_));
    if (!places_.empty()) place_count_ = count;
  }

  // The glyphs without components of which a glyph consists; none if it has no components. Throws
  // Font_error.
  std::vector<Glyph_part> parts(int glyph) const { return leaves(outline(glyph).components).parts; }

  // Reads the outline of a glyph. Components that have changed, in halves of a unit, are taken as
  // they are now. Throws Font_error.
  void read(int glyph, Glyph_outline& outline, const std::map<int, Glyph_outline>* changed) const {
    const Outline own = this->outline(glyph);
    if (own.components.empty()) {
      check_coordinates(own);
      return draw(own, outline);
    }
    const Leaves all = leaves(own.components);
    int shift = 1;
    for (const Glyph_part& part : all.parts) shift = (std::max)({shift, part.matrix.shift + 1, part.offset.shift});
    Glyph_outline drawn;
    const std::int64_t most = Glyph_outline::max_coordinate << shift;
    for (std::size_t i = 0; i < all.parts.size(); ++i) {
      const Glyph_part& part = all.parts[i];
      drawn.clear();
      if (changed != nullptr && changed->count(part.glyph) != 0)
        drawn = changed->at(part.glyph);
      else
        draw(all.outlines[i], drawn);
      // of halves of a unit
      const std::int64_t factor = std::int64_t(1) << (shift - 1 - part.matrix.shift),
                         unit = std::int64_t(1) << (shift - part.offset.shift);
      outline.begin_part(part.glyph);
      outline.append(drawn, [&](const Glyph_point& p) {
        Glyph_point q = part.matrix(p);
        q = {factor * q.x + unit * part.offset.x, factor * q.y + unit * part.offset.y};
        if (std::abs(q.x) > most || std::abs(q.y) > most) refuse_coordinate(Glyph_outline::max_coordinate);
        return q;
      });
    }
    outline.set_shift(shift);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_TRUE_TYPE_GLYPHS_H
