// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H

#include "commands/repair/grid_contour.h"
#include "commands/repair/grid_number.h"

#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

// The plane curves of a .g2 text as one contour, and where their coordinates stand. The grid is
// that of the decimals with the most digits behind the point among all coordinates, or another one,
// beside which the nodes may lie.
class G2_curves_text {
  const std::string& text_;
  std::vector<GC::G2_curve_text> curves_;
  std::vector<std::string> reasons_; // of each curve that is not on a grid
  std::string refusal_;
  int decimals_ = 0;
  bool fit_ = true;

  std::string_view word(const GC::G2_curve_text::Written_number& x) const {
    return std::string_view(text_).substr(x.begin, x.end - x.begin);
  }

  struct Text_place {
    std::size_t begin, end;
  };

  // Where the knots of a curve stand: they are the words before its coordinates.
  std::vector<Text_place> knot_places(const GC::G2_curve_text& curve) const {
    static const char* const space = " \t\r\n\f\v";
    std::vector<Text_place> places(static_cast<std::size_t>(curve.points + curve.order));
    std::size_t end = curve.coordinates.front().begin;
    for (std::size_t k = places.size(); k-- > 0;) {
      const std::size_t last = text_.find_last_not_of(space, end - 1), before = text_.find_last_of(space, last);
      places[k] = {before == std::string::npos ? 0 : before + 1, last + 1};
      end = places[k].begin;
    }
    return places;
  }

  void read_decimals(const GC::G2_curve_text& curve) {
    for (const GC::G2_curve_text::Written_number& c : curve.coordinates) {
      const std::optional<Grid_number> x = Grid_number::read(word(c));
      if (x && x->decimals <= Grid_number::max_decimals)
        decimals_ = (std::max)(decimals_, x->decimals);
      else
        fit_ = false;
    }
  }

  Grid_curve curve_on_grid(const GC::G2_curve_text& read) const {
    Grid_curve curve;
    for (std::size_t k = 0; k < read.coordinates.size(); k += 2) {
      const auto coordinate = [&](std::size_t i) {
        return Grid_number::read(word(read.coordinates[i]))->on_grid(decimals_);
      };
      const std::optional<std::int64_t> x = coordinate(k), y = coordinate(k + 1);
      if (!x || !y) {
        curve.points.clear();
        curve.reason = "a coordinate is too large for the decimals of the file";
        return curve;
      }
      curve.points.push_back({*x, *y});
    }
    return curve;
  }

  static std::vector<Drawing_traits::Point> points(const GC::G2_curve_text& read) {
    std::vector<Drawing_traits::Point> result;
    for (std::size_t k = 0; k < read.coordinates.size(); k += 2)
      result.emplace_back(read.coordinates[k].value.value(), read.coordinates[k + 1].value.value());
    return result;
  }

  template <class Function> Grid_contour contour(int decimals, Function curve) const {
    Grid_contour result;
    result.decimals = decimals;
    result.takes_fractions = true;
    for (std::size_t i = 0; i < curves_.size(); ++i)
      result.curves.push_back(reasons_[i].empty() ? curve(curves_[i]) : Grid_curve{{}, reasons_[i]});
    return result;
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
      reasons_.push_back(curve.rational                ? "a rational curve"
                         : curve.points != curve.order ? "a curve with inner knots"
                                                       : "");
      if (refusal_.empty() && reasons_.back().empty()) read_decimals(curve);
    }
  }

  // Why nothing can be repaired; empty otherwise.
  const std::string& refusal() const { return refusal_; }

  // Returns whether all coordinates are decimals on one grid.
  bool fits() const { return fit_; }

  // The curves on their own grid. \pre fits()
  Grid_contour contour() const {
    return contour(decimals_, [&](const GC::G2_curve_text& read) { return curve_on_grid(read); });
  }

  // The curves beside the grid of so many decimals.
  Grid_contour contour_beside_grid(int decimals) const {
    Grid_contour result =
        contour(decimals, [&](const GC::G2_curve_text& read) { return curve_beside_grid(points(read), decimals); });
    result.is_beside_grid = true;
    return result;
  }

  // How many decimals a coarse grid has that holds the curves.
  int coarser_decimals(std::int64_t longest) const {
    std::vector<Drawing_traits::Point> nodes;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (!reasons_[i].empty()) continue;
      const std::vector<Drawing_traits::Point> p = points(curves_[i]);
      nodes.push_back(p.front());
      nodes.push_back(p.back());
    }
    return ::coarser_decimals(nodes, longest);
  }

  // Returns the text in which some curves run the other way: their control points change places,
  // and so do the distances of their knots.
  std::string with_reversed(const std::vector<bool>& reversed) const {
    std::string result;
    std::size_t done = 0;
    const auto put = [&](const Text_place& place, const std::string& text) {
      if (text == text_.substr(place.begin, place.end - place.begin)) return;
      result.append(text_, done, place.begin - done) += text;
      done = place.end;
    };
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (!reversed[c]) continue;
      const std::vector<GC::G2_curve_text::Written_number>& x = curves_[c].coordinates;
      const std::vector<Text_place> knots = knot_places(curves_[c]);
      std::vector<Grid_fraction> values;
      for (const Text_place& k : knots)
        values.push_back(GC::Decimal(std::string_view(text_).substr(k.begin, k.end - k.begin)).value());
      for (std::size_t k = 0; k < knots.size(); ++k) {
        const Grid_fraction value = values.front() + values.back() - values[knots.size() - 1 - k];
        if (value != values[k]) put(knots[k], Grid_contour().text(value));
      }
      const std::size_t width = x.size() / static_cast<std::size_t>(curves_[c].points);
      for (std::size_t k = 0; k < x.size(); ++k)
        put({x[k].begin, x[k].end}, std::string(word(x[x.size() - width - k / width * width + k % width])));
    }
    return result.append(text_, done, std::string::npos);
  }

  // Returns the text with the control points of a contour that was one of these.
  std::string with(const Grid_contour& contour) const {
    std::string result;
    std::size_t done = 0;
    for (std::size_t c = 0; c < contour.curves.size(); ++c) {
      if (contour.curves[c].points.empty()) continue;
      const Grid_fraction unit = power_of_ten(-contour.decimals);
      for (std::size_t k = 0; k < contour.curves[c].points.size(); ++k) {
        const Drawing_traits::Point p = exact_point(contour.curves[c], k);
        for (const std::size_t i : {0, 1}) {
          const GC::G2_curve_text::Written_number& w = curves_[c].coordinates[2 * k + i];
          const Grid_fraction x = i == 0 ? p.x() : p.y();
          if (Grid_fraction(x * unit) == w.value.value()) continue;
          result.append(text_, done, w.begin - done) += contour.text(x);
          done = w.end;
        }
      }
    }
    return result.append(text_, done, std::string::npos);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_G2_CURVES_TEXT_H
