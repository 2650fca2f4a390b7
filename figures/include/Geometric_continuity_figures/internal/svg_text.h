// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_TEXT_H
#define GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_TEXT_H

#include <CGAL/Geometric_continuity/IO/internal/utf8.h>
#include <Geometric_continuity_figures/internal/Svg_view.h>
#include <Geometric_continuity_figures/internal/svg_markup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

/// \file svg_text.h
/// Text in a picture: titles, captions, labels, the legend, and the document around all.

namespace CGAL {
namespace Geometric_continuity {

namespace internal {

inline const char* svg_fonts() { return "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif"; }

// Characters that XML does not allow become U+FFFD, and control characters become spaces.
inline std::string svg_escape(const std::string& text) {
  std::string s;
  for_each_utf8_character(text, [&](const Utf8_character& c) {
    switch (c.code) {
    case '&': s += "&amp;"; break;
    case '<': s += "&lt;"; break;
    case '>': s += "&gt;"; break;
    case '"': s += "&quot;"; break;
    case 0xFFFE:
    case 0xFFFF: s += replacement_bytes; break;
    default:
      if (c.code < ' ' || c.code == 0x7F)
        s += ' ';
      else
        s += c.well_formed ? c.bytes : replacement_bytes;
    }
  });
  return s;
}

// Estimated for UTF-8 and a wide font.
inline double svg_text_width(const std::string& text, double size) {
  double width = 0;
  for (char c : text)
    if ((c & 0xC0) != 0x80) width += std::strchr(" .,:;'|!()[]fijlrt", c) ? 0.36 : std::strchr("mwMW@", c) ? 0.9 : 0.63;
  return width * size;
}

// The text in lines that fit, broken between words, or within a word that is longer than a line.
inline std::vector<std::string> wrapped_lines(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::string line, word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const bool space = i == text.size() || static_cast<unsigned char>(text[i]) <= ' ';
    if (!space) word += text[i];
    const bool long_word = svg_text_width(word, size) > width && (i + 1 == text.size() || (text[i + 1] & 0xC0) != 0x80);
    if ((!space && !long_word) || word.empty()) continue;
    if (!line.empty() && svg_text_width(line + ' ' + word, size) > width) {
      lines.push_back(line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    word.clear();
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

inline std::string svg_text(double x, double y, double size, const char* colour, const char* anchor,
                            const std::string& text, const std::string& more = std::string()) {
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" font-size=\"" + svg_number(size) +
         "\" fill=\"" + colour + "\" text-anchor=\"" + anchor + '"' + more + '>' + svg_escape(text) + "</text>\n";
}

// Returns the name of a curve in the legend.
inline std::string name_of(const Svg_style& style) {
  if (!style.name.empty()) return style.name;
  return style.role == Svg_role::given ? "given curve" : style.role == Svg_role::result ? "result" : "construction";
}

// The names of what is drawn, each beside a sample, 26 pixels wide.
class Svg_legend {
  struct Item {
    std::string name, sample;
    double width;
  };
  std::vector<Item> items_;

public:
  void add(const std::string& name, const std::string& sample) {
    items_.push_back({name, sample, 60 + svg_text_width(name, 11.5)});
  }

  // As many to a line as fit; moves y below them.
  std::string lines(double width, double edge, double& y) const {
    std::string s;
    for (std::size_t first = 0, last; first < items_.size(); first = last) {
      double used = items_[first].width;
      for (last = first + 1; last < items_.size() && used + items_[last].width <= width - 2 * edge; ++last)
        used += items_[last].width;
      double x = edge;
      for (std::size_t i = first; i < last; ++i) {
        s += "<g transform=\"translate(" + svg_number(x) + ' ' + svg_number(y + 12) + ")\">\n" + items_[i].sample +
             svg_text(34, 4, 11.5, "#444444", "start", items_[i].name) + "</g>\n";
        x += items_[i].width;
      }
      y += 22;
    }
    return s;
  }
};

// The lines of the title, from `y` on; moves y below them.
inline std::string svg_title(const std::string& title, double edge, double width, double& y) {
  std::string s;
  for (const std::string& line : wrapped_lines(title, 19, width - 2 * edge)) {
    s += svg_text(edge, y + 14, 17, "#222222", "start", line, " font-weight=\"600\"");
    y += 24;
  }
  return s;
}

// A picture on white.
inline std::string svg_document(const std::string& title, double width, double height, const std::string& body) {
  const std::string w = svg_number(width), h = svg_number(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w +
         "\" height=\"" + h + "\" viewBox=\"0 0 " + w + ' ' + h + "\" font-family=\"" + svg_fonts() +
         "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title>" + svg_escape(title) +
         "</title>\n<rect width=\"" + w + "\" height=\"" + h + "\" fill=\"#ffffff\"/>\n" + body + "</svg>\n";
}

// Holds the drawing of a panel as points, and finds the places that it leaves for labels. The
// points are kept in square cells, so that a label only looks at the points around it. Points
// outside of the panel are farther from a label than the edge.
class Svg_label_places {
  static constexpr double cell = 2;               // pixels
  static constexpr std::size_t most_in_cell = 16; // more are not seen to make a difference
  static constexpr double far_away = 12;          // pixels; farther is not better

  double width_, height_;
  std::size_t columns_;
  std::vector<std::vector<Svg_pixel>> cells_;
  std::vector<bool> taken_; // by labels and marks, cell by cell

public:
  Svg_label_places(double width, double height)
      : width_(width), height_(height), columns_(number(width) + 1), cells_(columns_ * (number(height) + 1)),
        taken_(cells_.size(), false) {}

  bool is_in_panel(const Svg_pixel& p) const { return 0 <= p[0] && p[0] <= width_ && 0 <= p[1] && p[1] <= height_; }

  // No label is to touch a box with this centre, such as that of a label.
  void take(const Svg_pixel& centre, const Svg_pixel& half) {
    for_each_cell(centre, half, [&](std::size_t k) { taken_[k] = true; });
  }
  static Svg_pixel half_size(double text_width) { return svg_vector({0.5 * text_width, 4.5}); }

  void add_point(const Svg_pixel& p) {
    if (!is_in_panel(p)) return;
    std::vector<Svg_pixel>& points = cells_[number(p[1]) * columns_ + number(p[0])];
    if (points.size() < most_in_cell) points.push_back(p);
  }

  void add_segment(const Svg_pixel& p, const Svg_pixel& q, int pieces) {
    for (int i = 0; i <= pieces; ++i) add_point(p + i / double(pieces) * (q - p));
  }

  // Where a label beside p is farthest from all that is drawn and from the edge of the panel, among
  // eight places that are not taken; if all are, among eight that are farther away, and so on; none
  // if there is no room.
  std::optional<Svg_pixel> place(const Svg_pixel& p, double text_width) const {
    const Svg_pixel half = half_size(text_width);
    std::optional<Svg_pixel> best;
    for (double gap : {8.0, 18.0, 30.0, 44.0}) {
      double best_distance = -1e6;
      for (const Svg_pixel& d :
           {svg_vector({0.0, -1.0}), svg_vector({0.0, 1.0}), svg_vector({1.0, 0.0}), svg_vector({-1.0, 0.0}),
            svg_vector({0.7, -0.8}), svg_vector({-0.7, -0.8}), svg_vector({0.7, 0.8}), svg_vector({-0.7, 0.8})}) {
        const Svg_pixel q = p + svg_vector({d[0] * (half[0] + gap), d[1] * (half[1] + gap)});
        if (!is_in_panel(q) || is_taken(q, half)) continue;
        const double distance = free_distance(q, half, best_distance);
        if (distance > best_distance) {
          best = q;
          best_distance = distance;
        }
      }
      if (best) return best;
    }
    return best;
  }

private:
  static std::size_t number(double x) { return static_cast<std::size_t>(x / cell); }

  template <class Function> void for_each_cell(const Svg_pixel& centre, const Svg_pixel& half, Function f) const {
    const Svg_pixel low = centre - half, high = centre + half;
    // equivalent [>= -> >, 2]: a box that only touches the panel
    if (!(low[0] <= width_ && high[0] >= 0 && low[1] <= height_ && high[1] >= 0)) return;
    const std::size_t last_x = number((std::min)(width_, high[0])), last_y = number((std::min)(height_, high[1]));
    for (std::size_t y = number((std::max)(0.0, low[1])); y <= last_y; ++y)
      for (std::size_t x = number((std::max)(0.0, low[0])); x <= last_x; ++x) f(y * columns_ + x);
  }

  bool is_taken(const Svg_pixel& centre, const Svg_pixel& half) const {
    bool result = false;
    for_each_cell(centre, half, [&](std::size_t k) { result = result || taken_[k]; });
    return result;
  }

  // The distance of the box with this centre from what is drawn and from the edge, negative beyond
  // the edge. Once it is not greater than `enough`, it need not be exact.
  double free_distance(const Svg_pixel& centre, const Svg_pixel& half, double enough) const {
    const double low_x = centre[0] - half[0], high_x = centre[0] + half[0], low_y = centre[1] - half[1],
                 high_y = centre[1] + half[1];
    // equivalent [2 -> 3, 3]: a margin of labels, one pixel wider
    double distance = (std::min)({far_away, low_x - 2, width_ - high_x - 2, low_y - 2, height_ - high_y - 2});
    const double least = (std::max)(0.0, enough);
    const auto look_around = [&](double reach) {
      const std::size_t first = number((std::max)(0.0, low_x - reach)),
                        last = number((std::min)(width_, high_x + reach)),
                        end = number((std::min)(height_, high_y + reach));
      for (std::size_t y = number((std::max)(0.0, low_y - reach)); y <= end; ++y)
        for (std::size_t x = first; x <= last; ++x)
          for (const Svg_pixel& o : cells_[y * columns_ + x]) {
            const Svg_pixel away = svg_vector({(std::max)(0.0, std::abs(o[0] - centre[0]) - half[0]),
                                               (std::max)(0.0, std::abs(o[1] - centre[1]) - half[1])});
            distance = (std::min)(distance, svg_length(away));
            if (distance <= least) return;
          }
    };
    if (distance > least) look_around(0); // where most boxes are found to be taken
    if (distance > least) look_around(distance);
    return distance;
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_FIGURES_INTERNAL_SVG_TEXT_H
