// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_MARKUP_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_MARKUP_H

#include <CGAL/Geometric_continuity/IO/figures/internal/svg_projection.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

/// \file svg_markup.h
/// The elements of SVG that an `Svg_figure` consists of: numbers, text, lines and paths in pixels.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// At most two decimals, whatever the locale, and always finite.
inline std::string svg_number(double x) {
  const double most = 1e6;
  if (!(x < most)) x = std::isnan(x) ? 0 : most;
  if (x < -most) x = -most;
  const long n = std::lround(100 * x), fraction = std::labs(n) % 100;
  std::string s = (n < 0 ? "-" : "") + std::to_string(std::labs(n) / 100);
  if (fraction != 0) s += (fraction < 10 ? ".0" : ".") + std::to_string(fraction % 10 == 0 ? fraction / 10 : fraction);
  return s;
}

inline std::string svg_pair(const Svg_pixel& p) { return svg_number(p[0]) + ' ' + svg_number(p[1]); }

// ---- text

inline const char* svg_fonts() { return "Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif"; }

inline std::string svg_escape(const std::string& text) {
  std::string s;
  for (char c : text) switch (c) {
    case '&': s += "&amp;"; break;
    case '<': s += "&lt;"; break;
    case '>': s += "&gt;"; break;
    case '"': s += "&quot;"; break;
    default: s += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
    }
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
  if (text.empty()) return text;
  return "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(y) + "\" font-size=\"" + svg_number(size) +
         "\" fill=\"" + colour + "\" text-anchor=\"" + anchor + '"' + more + '>' + svg_escape(text) + "</text>\n";
}

// ---- lines; the colours differ in lightness and stay distinct for the colour-blind

struct Stroke_style {
  const char* colour;
  double width;
  const char* dashes;
};
constexpr Stroke_style svg_given{"#2f4058", 2, ""}, svg_blend{"#d55e00", 2.6, ""}, svg_polygon{"#8c8c8c", 0.9, ""},
    svg_teeth{"#a6cbe6", 0.7, ""}, svg_cut_teeth{"#d3e5f2", 0.7, ""}, svg_envelope{"#3787c0", 1.1, ""},
    svg_ring{"#222222", 1.4, ""}, svg_grid{"#e3e3e3", 0.8, ""}, svg_shadow{"#cdcdcd", 2.4, ""},
    svg_plumb{"#b4b4b4", 0.8, "2 3"}, svg_axes{"#8c8c8c", 1, ""}, svg_construction{"#008060", 1.1, "5 4"};

inline std::string svg_stroke(const Stroke_style& line, const std::string& path) {
  if (path.empty()) return path;
  const std::string dashes = line.dashes;
  return std::string("<path fill=\"none\" stroke=\"") + line.colour + "\" stroke-width=\"" + svg_number(line.width) +
         (dashes.empty() ? dashes : "\" stroke-dasharray=\"" + dashes) + "\" d=\"" + path + "\"/>\n";
}

// A white disk with a rim.
inline std::string svg_disk(const Svg_pixel& p, double radius, const Stroke_style& rim) {
  return "<circle cx=\"" + svg_number(p[0]) + "\" cy=\"" + svg_number(p[1]) + "\" r=\"" + svg_number(radius) +
         "\" fill=\"#ffffff\" stroke=\"" + rim.colour + "\" stroke-width=\"" + svg_number(rim.width) + "\"/>\n";
}

inline std::string svg_polyline(const std::vector<Svg_pixel>& points) {
  std::string path;
  for (const Svg_pixel& p : points) path += (path.empty() ? 'M' : 'L') + svg_pair(p);
  return path;
}

inline std::string svg_cubic(const Svg_pixel& b1, const Svg_pixel& b2, const Svg_pixel& b3) {
  return 'C' + svg_pair(b1) + ' ' + svg_pair(b2) + ' ' + svg_pair(b3);
}

// A curve through points that lie close together, with the tangents of Catmull and Rom.
inline std::string svg_smooth_path(const std::vector<Svg_pixel>& p) {
  if (p.size() < 2) return std::string();
  std::string path = 'M' + svg_pair(p[0]);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    const Svg_pixel d0 = p[i + 1] - p[i == 0 ? 0 : i - 1], d1 = p[(std::min)(i + 2, p.size() - 1)] - p[i];
    path += svg_cubic(p[i] + d0 / 6.0, p[i + 1] - d1 / 6.0, p[i + 1]);
  }
  return path;
}

// The Bezier curve with these points: one cubic up to degree 3, else Hermite pieces, whose error is at most
// h^4/384 max |x''''| and is kept below 1/50.
inline std::string svg_curve_path(std::vector<Svg_pixel> b) {
  const int m = static_cast<int>(b.size()) - 1;
  std::string path = 'M' + svg_pair(b[0]);
  if (m <= 3) {
    b.resize(4);
    for (int n = m; n < 3; ++n) bernstein_elevate<double>(b, n);
    if (b[0] == b[3]) { // in two parts, for some viewers lose a cubic with a chord of length 0
      std::vector<Svg_pixel> left = b;
      bernstein_split(b, 3, 0.5, left);
      path += svg_cubic(left[1], left[2], left[3]);
    }
    return path + svg_cubic(b[1], b[2], b[3]);
  }
  std::vector<Svg_pixel> d = b;
  for (int j = 0; j < 4; ++j) difference_step(d, m - j);
  double most = 0;
  for (int j = 0; j <= m - 4; ++j) most = (std::max)(most, double(m) * (m - 1) * (m - 2) * (m - 3) * svg_length(d[j]));
  const int pieces = 1 + static_cast<int>((std::min)(200.0, std::pow(most / (384 * 0.02), 0.25)));
  for (int i = 0; i < pieces; ++i) {
    const Coordinate_jet<double, 2> start = polygon_jet(b, i / double(pieces), 1),
                                    end = polygon_jet(b, (i + 1) / double(pieces), 1);
    path += svg_cubic(start[0] + start[1] / (3.0 * pieces), end[0] - end[1] / (3.0 * pieces), end[0]);
  }
  return path;
}

// Where a label beside p is farthest from all that is drawn and from the edge of the panel, among eight places.
inline Svg_pixel svg_label_place(const Svg_pixel& p, double text_width, const std::vector<Svg_pixel>& drawn,
                                 const Svg_pixel& panel_size) {
  const Svg_pixel half = svg_vector({0.5 * text_width, 4.5});
  Svg_pixel best = p;
  double best_distance = -1e6;
  for (const Svg_pixel& d :
       {svg_vector({0.0, -1.0}), svg_vector({0.0, 1.0}), svg_vector({1.0, 0.0}), svg_vector({-1.0, 0.0}),
        svg_vector({0.7, -0.8}), svg_vector({-0.7, -0.8}), svg_vector({0.7, 0.8}), svg_vector({-0.7, 0.8})}) {
    const Svg_pixel q = p + svg_vector({d[0] * (half[0] + 8), d[1] * (half[1] + 8)});
    double distance = 12; // farther is not better
    for (const Svg_pixel& o : drawn) {
      Svg_pixel away(2); // from the box of the text
      for (int i : {0, 1}) away[i] = (std::max)(0.0, std::abs(o[i] - q[i]) - half[i]);
      distance = (std::min)(distance, svg_length(away));
    }
    for (int i : {0, 1}) distance = (std::min)({distance, q[i] - half[i] - 2, panel_size[i] - q[i] - half[i] - 2});
    if (distance > best_distance) {
      best = q;
      best_distance = distance;
    }
  }
  return best;
}

// Samples, 26 pixels wide, with their names.
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

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_FIGURES_INTERNAL_SVG_MARKUP_H
