// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/shapes/svg_paths.h"

#include "formats/g2_text/curves.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/repairs/align_handles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

typedef GC::Coordinate_vector<Exact, 2> Plane_vector;
typedef std::vector<Plane_vector> Control_polygon;

// Reads the polynomial pieces of all curves.
std::vector<Control_polygon> plane_pieces(const std::string& g2) {
  std::istringstream is(g2);
  if (g2.compare(0, 3, "200") == 0)
    throw std::invalid_argument(
        "--output: an SVG drawing holds curves, and these are surfaces; see .g2, .json and --plot");
  std::vector<Control_polygon> pieces;
  GC::G2_piece_reader<Program_traits<Exact>> reader(is, "what is written");
  while (const std::optional<Exact_curve> piece = reader.next()) {
    const auto curve = piece->polynomial();
    if (!curve)
      throw std::invalid_argument("--output: an SVG drawing holds no rational curves; see .g2, .dxf and .json");
    if (curve->dimension() != 2)
      throw std::invalid_argument("--output: an SVG drawing holds curves in the plane; see .g2, .dxf and .json");
    Control_polygon points;
    for (int j = 0; j <= curve->degree(); ++j) {
      const auto x = curve->coordinates(j);
      Plane_vector p(2);
      p[0] = x[0];
      p[1] = x[1];
      points.push_back(p);
    }
    pieces.push_back(std::move(points));
  }
  return pieces;
}

// Lowers the degree as far as the curve stays the same: the difference of the highest order is
// zero, and b_j = (m a_j - j b_{j-1}) / (m - j) are the points of degree m - 1.
void lower_degree(Control_polygon& a) {
  while (a.size() > 2) {
    const int m = static_cast<int>(a.size()) - 1;
    Control_polygon difference = a;
    for (int k = m; k > 0; --k)
      for (int j = 0; j < k; ++j)
        difference[static_cast<std::size_t>(j)] =
            difference[static_cast<std::size_t>(j) + 1] - difference[static_cast<std::size_t>(j)];
    if (!is_zero(difference[0])) return;
    Control_polygon b;
    for (int j = 0; j < m; ++j) {
      Plane_vector p = Exact(m) * a[static_cast<std::size_t>(j)];
      if (j > 0) p -= Exact(j) * b.back();
      b.push_back(p / Exact(m - j));
    }
    a = b;
  }
}

// The cubic with the ends and the derivatives there of a curve.
Control_polygon cubic_of(const Control_polygon& a) {
  const Exact third = Exact(static_cast<int>(a.size()) - 1) / 3;
  const std::size_t m = a.size() - 1;
  return {a[0], Plane_vector(a[0] + third * (a[1] - a[0])), Plane_vector(a[m] - third * (a[m] - a[m - 1])), a[m]};
}

// Returns whether a cubic is certainly no farther from a curve than the root of `square`: the
// control points of their difference bound it.
bool is_near(const Control_polygon& a, Control_polygon cubic, const Exact& square) {
  const int m = static_cast<int>(a.size()) - 1;
  cubic.resize(a.size(), Plane_vector(2));
  for (int n = 3; n < m; ++n) GC::bernstein_elevate<Exact>(cubic, n);
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Plane_vector d = a[j] - cubic[j];
    if (dot(d, d) > square) return false;
  }
  return true;
}

void halve(const Control_polygon& a, Control_polygon& left, Control_polygon& right) {
  right = a;
  left.clear();
  for (std::size_t n = a.size(); n > 0; --n) {
    left.push_back(right[0]);
    for (std::size_t j = 0; j + 1 < n; ++j) right[j] = (right[j] + right[j + 1]) / Exact(2);
  }
}

// Appends cubics near a curve.
void add_cubics(const Control_polygon& a, const Exact& square, int depth, std::vector<Control_polygon>& cubics) {
  const Control_polygon cubic = cubic_of(a);
  if (depth == 0 || is_near(a, cubic, square)) return cubics.push_back(cubic);
  Control_polygon left, right;
  halve(a, left, right);
  add_cubics(left, square, depth - 1, cubics);
  add_cubics(right, square, depth - 1, cubics);
}

// The decimals in which a drawing is written: so many that its size has 27 bits, which handles on a
// grid may have.
class Decimal_grid {
  int decimals_ = 0;
  Exact unit_ = 1;

public:
  explicit Decimal_grid(const Exact& size) {
    const Exact most(1 << 27);
    for (; size != 0 && size <= most * unit_ / 10; ++decimals_) unit_ /= 10;
    for (; size > most * unit_; --decimals_) unit_ *= 10;
  }

  GC::Grid_vector rounded(const Plane_vector& p) const {
    const auto nearest = [this](const Exact& x) { return std::llround(CGAL::to_double(Exact(x / unit_))); };
    return {nearest(p[0]), nearest(p[1])};
  }

  void write(std::ostream& os, std::int64_t x) const {
    std::string text = std::to_string((std::abs)(x));
    if (decimals_ < 0 && x != 0) text += 'e' + std::to_string(-decimals_);
    if (decimals_ > 0) {
      const std::size_t n = static_cast<std::size_t>(decimals_);
      if (text.size() <= n) text.insert(0, n + 1 - text.size(), '0');
      text.insert(text.size() - n, ".");
      text.erase(text.find_last_not_of('0') + 1);
      if (text.back() == '.') text.pop_back();
    }
    os << (x < 0 && text != "0" ? " -" : " ") << text;
  }
};

// A path of lines and cubics, each of which starts where the one before it ends, on a grid.
class Grid_path {
  std::vector<std::vector<GC::Grid_vector>> pieces_;
  bool closed_;

  static constexpr std::int64_t most_squared_move_ = std::int64_t(1) << 26; // in units: 6/100000 of the size
  static constexpr std::int64_t parts_of_line_ = 1000;

  // Moves the end of a line so that it has whole parts, whose multiples are handles of its
  // direction.
  void divide(std::size_t k) {
    std::vector<GC::Grid_vector>& line = pieces_[k];
    const GC::Grid_vector chord = line[1] - line[0], d = GC::primitive(chord);
    if (line[0] == line[1] || GC::squared_length(d) <= GC::squared_length(chord) / 100000) return;
    const auto part = [](std::int64_t x) { return std::llround(static_cast<double>(x) / parts_of_line_); };
    const GC::Grid_vector moved = line[0] + parts_of_line_ * GC::Grid_vector{part(chord.x), part(chord.y)},
                          by = moved - line[1];
    line[1] = moved;
    if (k + 1 == pieces_.size() && !closed_) return;
    std::vector<GC::Grid_vector>& next = pieces_[(k + 1) % pieces_.size()];
    next[0] = moved;
    if (next.size() > 2) next[1] = next[1] + by;
  }

  // Makes the handles at a join parallel again: those of cubics are moved, lines stay.
  static void align(std::vector<GC::Grid_vector>& left, std::vector<GC::Grid_vector>& right) {
    const GC::Grid_vector node = right[0], zero{0, 0};
    const GC::Grid_vector a = node - left[left.size() - 2], b = right[1] - node;
    if (a == zero || b == zero || (left.size() == 2 && right.size() == 2)) return;
    GC::Aligned_handles handles{a, b};
    if (left.size() == 2)
      handles.right = GC::align_handle(b, a);
    else if (right.size() == 2)
      handles.left = GC::align_handle(a, b);
    else if (const auto found = GC::align_handles(a, b, most_squared_move_))
      handles = *found;
    if (GC::squared_length(handles.left - a) > most_squared_move_ ||
        GC::squared_length(handles.right - b) > most_squared_move_)
      return;
    if (left.size() > 2) left[left.size() - 2] = node - handles.left;
    if (right.size() > 2) right[1] = node + handles.right;
  }

  static bool is_smooth(const Control_polygon& left, const Control_polygon& right) {
    const Plane_vector a = left.back() - left[left.size() - 2], b = right[1] - right[0];
    return Exact(a[0] * b[1]) == Exact(a[1] * b[0]) && dot(a, b) > 0;
  }

public:
  Grid_path(const std::vector<Control_polygon>& path, const Decimal_grid& grid)
      : closed_(path.back().back() == path[0][0]) {
    for (const Control_polygon& a : path) {
      pieces_.emplace_back();
      for (const Plane_vector& p : a) pieces_.back().push_back(grid.rounded(p));
    }
    std::vector<bool> smooth(path.size()); // at the start of each piece
    const auto before = [&](std::size_t k) { return (k + path.size() - 1) % path.size(); };
    for (std::size_t k = closed_ ? 0 : 1; k < path.size(); ++k) smooth[k] = is_smooth(path[before(k)], path[k]);
    for (std::size_t k = 0; k < path.size(); ++k)
      if (path[k].size() == 2 && (smooth[k] || smooth[(k + 1) % path.size()])) divide(k);
    for (std::size_t k = 0; k < path.size(); ++k)
      if (smooth[k]) align(pieces_[before(k)], pieces_[k]);
  }

  void write(std::ostream& os, const Decimal_grid& grid) const {
    const auto write = [&](const GC::Grid_vector& p) {
      grid.write(os, p.x);
      grid.write(os, p.y);
    };
    os << "<path d=\"M";
    write(pieces_[0][0]);
    for (const std::vector<GC::Grid_vector>& a : pieces_) {
      os << (a.size() == 2 ? "\nL" : "\nC");
      for (std::size_t j = 1; j < a.size(); ++j) write(a[j]);
    }
    os << (closed_ ? "\nZ\"/>\n" : "\"/>\n");
  }
};

} // namespace

void write_svg_paths(std::ostream& os, const std::string& g2, const Exact& flatness) {
  std::vector<Control_polygon> pieces = plane_pieces(g2);
  std::array<Exact, 2> least{0, 0}, most{1, 1};
  bool is_first = true;
  for (const Control_polygon& a : pieces)
    for (const Plane_vector& p : a) {
      for (std::size_t i = 0; i < 2; ++i) {
        const Exact& x = p[static_cast<int>(i)];
        if (is_first || x < least[i]) least[i] = x;
        if (is_first || most[i] < x) most[i] = x;
      }
      is_first = false;
    }
  const Exact width = most[0] - least[0], height = most[1] - least[1], size = (std::max)(width, height);
  const Exact tolerance = flatness == 0 ? Exact(size / 10000) : flatness;
  std::size_t curves = 0, cubics = 0;
  std::vector<std::vector<Control_polygon>> paths;
  for (Control_polygon& a : pieces) {
    lower_degree(a);
    if (paths.empty() || paths.back().back().back() != a[0]) paths.emplace_back();
    if (a.size() == 3)
      a = {a[0], Plane_vector((a[0] + Exact(2) * a[1]) / Exact(3)), Plane_vector((a[2] + Exact(2) * a[1]) / Exact(3)),
           a[2]};
    if (a.size() <= 4) {
      if (a.size() > 1) paths.back().push_back(a);
    } else {
      const std::size_t before = paths.back().size();
      add_cubics(a, tolerance * tolerance, 20, paths.back());
      ++curves;
      cubics += paths.back().size() - before;
    }
    if (paths.back().empty()) paths.pop_back();
  }
  const double margin = CGAL::to_double(size) / 50;
  const auto number = [&](double x) { GC::write_number(os << ' ', x); };
  os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
  GC::write_number(os, CGAL::to_double(least[0]) - margin);
  number(-CGAL::to_double(most[1]) - margin);
  number(CGAL::to_double(width) + 2 * margin);
  number(CGAL::to_double(height) + 2 * margin);
  os << "\">\n<g transform=\"scale(1 -1)\" fill=\"none\" stroke=\"black\" stroke-width=\"";
  GC::write_number(os, CGAL::to_double(size) / 300);
  os << "\">\n";
  const Decimal_grid grid(size);
  for (const std::vector<Control_polygon>& path : paths) Grid_path(path, grid).write(os, grid);
  os << "</g>\n</svg>\n";
  if (curves == 0) return;
  std::cerr << curves << (curves == 1 ? " curve" : " curves") << " of a degree above 3 " << (curves == 1 ? "is" : "are")
            << " drawn by " << cubics << " cubics within " << CGAL::to_double(tolerance)
            << ", with the same tangents; see --flatness\n";
}
