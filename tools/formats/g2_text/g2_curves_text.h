// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H

#include "commands/repair/grid_contour.h"
#include "commands/repair/grid_number.h"

#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

// The plane curves of a .g2 text as one contour, and where their coordinates stand. The grid is
// that of the decimals with the most digits behind the point among all coordinates.
class G2_curves_text {
  const std::string& text_;
  std::vector<GC::G2_curve_text> curves_;
  Grid_contour contour_;
  std::string refusal_;

  std::string_view word(const GC::G2_curve_text::Written_number& x) const {
    return std::string_view(text_).substr(x.begin, x.end - x.begin);
  }

  // The decimals of a curve, or why it has none.
  std::string read_decimals(const GC::G2_curve_text& curve) {
    for (const GC::G2_curve_text::Written_number& c : curve.coordinates) {
      const std::optional<Grid_number> x = Grid_number::read(word(c));
      if (!x || x->decimals > Grid_number::max_decimals)
        return "a coordinate that is no decimal of at most 15 digits: " + std::string(word(c).substr(0, 30));
      contour_.decimals = (std::max)(contour_.decimals, x->decimals);
    }
    return "";
  }

  void read_points(Grid_curve& curve, const GC::G2_curve_text& read) {
    for (std::size_t k = 0; k < read.coordinates.size(); k += 2) {
      const auto coordinate = [&](std::size_t i) {
        return Grid_number::read(word(read.coordinates[i]))->on_grid(contour_.decimals);
      };
      const std::optional<std::int64_t> x = coordinate(k), y = coordinate(k + 1);
      if (!x || !y) {
        curve.points.clear();
        curve.reason = "a coordinate is too large for the decimals of the file";
        return;
      }
      curve.points.push_back({*x, *y});
    }
  }

public:
  // Takes a text, which outlives this. Throws GC::Error as the reader of `.g2` does.
  G2_curves_text(const std::string& text, const std::string& name) : text_(text) {
    std::istringstream is(text);
    GC::G2_text_reader reader(is, name);
    for (GC::G2_curve_text curve; refusal_.empty() && reader.next(curve); curves_.push_back(curve)) {
      if (curve.is_line)
        refusal_ = "only splines, of class 100, are repaired, and there is one of class 120";
      else if (curve.dimension != 2)
        refusal_ = "only curves in the plane are repaired, and these have dimension " + std::to_string(curve.dimension);
      const char* const reason = curve.rational                ? "a rational curve"
                                 : curve.points != curve.order ? "a curve with inner knots"
                                                               : "";
      contour_.curves.push_back({{}, reason, false});
      if (contour_.curves.back().reason.empty()) contour_.curves.back().reason = read_decimals(curve);
    }
    for (std::size_t k = 0; k < curves_.size() && refusal_.empty(); ++k)
      if (contour_.curves[k].reason.empty()) read_points(contour_.curves[k], curves_[k]);
  }

  // Why nothing can be repaired; empty otherwise.
  const std::string& refusal() const { return refusal_; }
  const Grid_contour& contour() const { return contour_; }

  // Returns the text with the control points of another contour.
  std::string with(const Grid_contour& contour) const {
    std::string result;
    std::size_t done = 0;
    for (std::size_t c = 0; c < contour.curves.size(); ++c)
      for (std::size_t k = 0; k < contour.curves[c].points.size(); ++k) {
        const GC::Grid_vector &p = contour.curves[c].points[k], &old = contour_.curves[c].points[k];
        for (const auto& [x, before, i] : {std::array<std::int64_t, 3>{p.x, old.x, 0}, {p.y, old.y, 1}}) {
          if (x == before) continue;
          const GC::G2_curve_text::Written_number& w = curves_[c].coordinates[2 * k + static_cast<std::size_t>(i)];
          result.append(text_, done, w.begin - done) += contour_.text(x);
          done = w.end;
        }
      }
    return result.append(text_, done, std::string::npos);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
