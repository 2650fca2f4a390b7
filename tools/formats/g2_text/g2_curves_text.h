// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H

#include "commands/repair/grid_contour.h"
#include "commands/repair/grid_number.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The plane curves of a .g2 text as one contour, and where their coordinates stand. The grid is that of the decimals with the most digits
// behind the point among all coordinates.
class G2_curves_text {
  struct Word {
    std::size_t begin, end;
  };

  const std::string& text_;
  std::vector<Word> words_;
  std::vector<std::size_t> first_coordinate_; // of each curve, as the number of a word
  Grid_contour contour_;
  std::string refusal_;

  std::string_view word(std::size_t i) const {
    return std::string_view(text_).substr(words_[i].begin, words_[i].end - words_[i].begin);
  }
  std::size_t integer(std::size_t i) const { return std::strtoul(std::string(word(i)).c_str(), nullptr, 10); }

  void split() {
    const std::string_view space = " \t\n\v\f\r", mark = "\xEF\xBB\xBF";
    std::size_t i = text_.compare(0, mark.size(), mark) == 0 ? mark.size() : 0;
    while ((i = text_.find_first_not_of(space, i)) != std::string::npos) {
      const std::size_t end = (std::min)(text_.find_first_of(space, i), text_.size());
      words_.push_back({i, end});
      i = end;
    }
  }

  // The decimals of a curve, or why it has none.
  std::string read_decimals(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      const std::optional<Grid_number> x = Grid_number::read(word(i));
      if (!x || x->decimals > Grid_number::max_decimals)
        return "a coordinate that is no decimal of at most 15 digits: " + std::string(word(i).substr(0, 30));
      contour_.decimals = (std::max)(contour_.decimals, x->decimals);
    }
    return "";
  }

  void read_points(Grid_curve& curve, std::size_t first, std::size_t points) {
    for (std::size_t k = 0; k < points; ++k) {
      const auto coordinate = [&](std::size_t i) {
        return Grid_number::read(word(first + 2 * k + i))->on_grid(contour_.decimals);
      };
      const std::optional<std::int64_t> x = coordinate(0), y = coordinate(1);
      if (!x || !y) {
        curve.points.clear();
        curve.reason = "a coordinate is too large for the decimals of the file";
        return;
      }
      curve.points.push_back({*x, *y});
    }
  }

public:
  // Takes a text that the reader of curves accepts and that outlives this.
  explicit G2_curves_text(const std::string& text) : text_(text) {
    split();
    std::vector<std::size_t> numbers_of_points;
    for (std::size_t i = 0; i < words_.size() && refusal_.empty();) {
      if (integer(i) != 100) {
        refusal_ = "only splines, of class 100, are repaired, and there is one of class " + std::string(word(i));
        break;
      }
      i += 4 + integer(i + 3); // the class, its version, and words that are not used
      const std::size_t dimension = integer(i), n = integer(i + 2), order = integer(i + 3);
      const bool rational = integer(i + 1) != 0;
      if (dimension != 2)
        refusal_ = "only curves in the plane are repaired, and these have dimension " + std::to_string(dimension);
      i += 4 + n + order;
      contour_.curves.push_back({{},
                                 rational     ? "a rational curve"
                                 : n != order ? "a curve with inner knots"
                                              : "",
                                 false});
      first_coordinate_.push_back(i);
      numbers_of_points.push_back(n);
      const std::size_t count = n * (dimension + rational);
      std::string& reason = contour_.curves.back().reason;
      if (reason.empty()) reason = read_decimals(i, count);
      i += count;
    }
    for (std::size_t k = 0; k < contour_.curves.size() && refusal_.empty(); ++k)
      if (contour_.curves[k].reason.empty())
        read_points(contour_.curves[k], first_coordinate_[k], numbers_of_points[k]);
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
          const Word& w = words_[first_coordinate_[c] + 2 * k + static_cast<std::size_t>(i)];
          result.append(text_, done, w.begin - done) += contour_.text(x);
          done = w.end;
        }
      }
    return result.append(text_, done, std::string::npos);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
