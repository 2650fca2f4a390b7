// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_PATH_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_PATH_TEXT_H

#include "commands/repair/grid_contour.h"
#include "formats/svg/read_svg_path.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A piece of text that takes the place of another one.
struct Text_edit {
  GC::Text_range range;
  std::string text;
};

// The decimals of the coordinates of path data.
struct Path_decimals {
  int most = 0;           // digits behind the point
  std::size_t finest = 0; // how many coordinates have that many
  bool fit = true;        // a grid of these decimals holds each of them

  void add(std::string_view data, const GC::Svg_path_places& places);
};

// Path data as contours on its grid, one subpath after the other: the text stays as it is but for
// the numbers that must change. The grid is that of the decimals with the most digits behind the
// point among the coordinates, or another one, beside which the nodes may lie.
class Path_text {
  const std::string_view data_;
  Path_decimals decimals_; // as they will be
  const std::optional<Drawing_transform> map_;
  const bool is_filled_;
  GC::Svg_path_places places_;
  GC::Svg_path_reader<Drawing_traits> reader_;
  Drawing_subpath subpath_;
  Grid_contour contour_;

  std::optional<GC::Grid_vector> on_grid(const Drawing_traits::Point& point) const;
  Grid_curve curve(const GC::Svg_segment<Drawing_traits>& segment) const;
  template <class Curve> Grid_contour contour_of(int decimals, Curve curve) const;
  Grid_curve arc(const GC::Svg_segment<Drawing_traits>& segment, int decimals) const;
  std::string_view number(std::size_t index) const;

  // A number as it will be when it changes by so many units.
  std::string moved_text(std::size_t index, const Drawing_traits::FT& by, const Grid_contour& contour) const;
  void forget();

public:
  // Takes path data, whose places are named `place` in messages, with its decimals, the map by
  // which it is drawn, and whether it is filled.
  Path_text(std::string_view data, const std::string& place, const Path_decimals& decimals,
            const std::optional<Drawing_transform>& map, bool is_filled)
      : data_(data), decimals_(decimals), map_(map), is_filled_(is_filled), reader_(data, place, &places_) {}

  // Reads the next subpath. Returns false at the end.
  bool next();

  // The subpath, without segments of no length, and the same on the grid of the path.
  const Drawing_subpath& subpath() const { return subpath_; }
  Grid_contour contour() const;

  // The subpath beside the grid of so many decimals, and how many a coarse one has that holds it.
  Grid_contour contour_beside_grid(int decimals) const;
  int coarser_decimals(std::int64_t longest) const;

  // Returns the edits, in order, that move the handles of the subpath, and change its arcs, from
  // how they are in one contour to how they are in another one. A path on its own grid keeps it:
  // the last number with the most decimals keeps them.
  std::vector<Text_edit> edits(const Grid_contour& from, const Grid_contour& to);
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_REPAIR_PATH_TEXT_H
