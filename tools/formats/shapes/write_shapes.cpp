// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/shapes/write_shapes.h"

#include "files/output.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/write_cad.h"
#include "formats/shapes/Shape_text.h"
#include "formats/shapes/svg_paths.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

constexpr int most_decimals = 300;

std::vector<Shape_text> shapes_of(const std::string& g2) {
  std::istringstream is(g2);
  std::vector<Shape_text> shapes;
  for (Shape_text shape; shape.read(is);) shapes.push_back(shape);
  return shapes;
}

// A number as the shortest decimal that leads to the nearest double.
std::string shortest(const std::string& number) {
  std::ostringstream os;
  GC::write_number(os, GC::parse_number<double>(number));
  return os.str();
}

// A number with so many digits behind the point, rounded to the nearest, without zeros at the end.
std::string with_decimals(const std::string& number, int digits) {
  typedef CGAL::Exact_rational Exact;
  typedef CGAL::Fraction_traits<Exact> Fractions;
  Exact x = GC::parse_number<Exact>(number);
  const bool negative = x < 0;
  if (negative) x = -x;
  for (int i = 0; i < digits; ++i) x *= 10;
  x += Exact(1) / 2;
  Fractions::Numerator_type p;
  Fractions::Denominator_type q;
  Fractions::Decompose()(x, p, q);
  std::ostringstream os;
  os << Fractions::Numerator_type(p / q);
  std::string text = os.str();
  if (digits > 0) {
    if (text.size() <= static_cast<std::size_t>(digits))
      text.insert(0, static_cast<std::size_t>(digits) + 1 - text.size(), '0');
    text.insert(text.size() - static_cast<std::size_t>(digits), ".");
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return negative && text != "0" ? '-' + text : text;
}

// The text with each fraction and each long decimal rounded; the integers, with the headers among
// them, stay.
void write_decimals(std::ostream& os, const std::string& g2, const std::string& digits) {
  typedef CGAL::Exact_rational Exact;
  std::size_t rounded = 0, doubles = 0;
  const auto number = [&](const std::string& token) {
    if (token.find_first_of("/.eE") == std::string::npos) return token;
    const std::string text = digits.empty() ? shortest(token) : with_decimals(token, std::stoi(digits));
    const Exact given = GC::parse_number<Exact>(token);
    if (GC::parse_number<Exact>(text) != given) {
      const bool is_double = digits.empty() && Exact(GC::parse_number<double>(token)) == given;
      ++(is_double ? doubles : rounded);
    }
    return text;
  };
  std::istringstream is(g2);
  for (std::string line; std::getline(is, line);) {
    std::istringstream tokens(line);
    const char* separator = "";
    for (std::string token; tokens >> token; separator = " ") os << separator << number(token);
    os << '\n';
  }
  if (rounded != 0)
    std::cerr << rounded << (rounded == 1 ? " number is" : " numbers are")
              << " rounded by --decimals: the joins of the file are exact no longer, see verify --within\n";
  else if (doubles != 0)
    std::cerr << "the decimals stand for doubles: verify --kernel double decides on the same numbers\n";
}

void write_list(std::ostream& os, std::size_t n, const std::function<void(std::size_t)>& write) {
  os << '[';
  for (std::size_t i = 0; i < n; ++i) {
    if (i != 0) os << ',';
    write(i);
  }
  os << ']';
}

// Curves have `degree` and `knots`, surfaces pairs of both, and their points row by row in u.
void write_shapes_as_json(std::ostream& os, const std::vector<Shape_text>& shapes) {
  const auto write = [&](double x) { GC::write_number(os, x); };
  const auto per_direction = [&](const Shape_text& s, const auto& f) {
    if (s.is_surface())
      write_list(os, 2, [&](std::size_t d) { f(s.directions[d]); });
    else
      f(s.directions[0]);
  };
  os << "{\"shapes\":";
  write_list(os, shapes.size(), [&](std::size_t k) {
    const Shape_text& s = shapes[k];
    // the place of the point (i, j) in the text; a curve has one column
    const std::size_t m = static_cast<std::size_t>(s.directions[0].points), n = s.rows.size() / m;
    const auto net = [&](const auto& f) {
      if (s.is_surface())
        write_list(os, m, [&](std::size_t i) { write_list(os, n, [&](std::size_t j) { f(j * m + i); }); });
      else
        write_list(os, m, f);
    };
    os << (s.is_surface() ? "\n {\"kind\":\"surface\",\"degree\":" : "\n {\"kind\":\"curve\",\"degree\":");
    per_direction(s, [&](const Shape_text::Direction& d) { os << d.degree; });
    os << ",\"knots\":";
    per_direction(s, [&](const Shape_text::Direction& d) {
      write_list(os, d.knots.size(), [&](std::size_t i) { write(Shape_text::number(d.knots[i])); });
    });
    os << ",\"points\":";
    net([&](std::size_t i) {
      write_list(os, static_cast<std::size_t>(s.dimension), [&](std::size_t x) { write(s.coordinate(i, x)); });
    });
    if (s.is_rational) {
      os << ",\"weights\":";
      net([&](std::size_t i) { write(s.weight(i)); });
    }
    os << '}';
  });
  os << "}\n";
}

// A drawing of AutoCAD 2000 with one spline for each curve.
void write_shapes_as_dxf(std::ostream& os, const std::vector<Shape_text>& shapes) {
  const auto pair = [&](int code, const auto& value) { os << code << '\n' << value << '\n'; };
  const auto number = [&](int code, double x) {
    os << code << '\n';
    GC::write_number(os, x);
    os << '\n';
  };
  pair(0, "SECTION"), pair(2, "HEADER"), pair(9, "$ACADVER"), pair(1, "AC1015"), pair(0, "ENDSEC");
  pair(0, "SECTION"), pair(2, "ENTITIES");
  int handle = 0x100;
  for (const Shape_text& s : shapes) {
    if (s.is_surface())
      throw std::invalid_argument("--output: DXF holds curves, and there is a surface; see .g2 and .json");
    if (s.dimension > 3) throw std::invalid_argument("--output: DXF holds curves in the plane and in space");
    const Shape_text::Direction& d = s.directions[0];
    std::ostringstream hexadecimal;
    hexadecimal << std::hex << std::uppercase << handle++;
    pair(0, "SPLINE"), pair(5, hexadecimal.str()), pair(100, "AcDbEntity"), pair(8, "0"), pair(100, "AcDbSpline");
    pair(70, (s.is_rational ? 4 : 0) + (s.dimension == 2 ? 8 : 0));
    pair(71, d.degree), pair(72, d.knots.size()), pair(73, s.rows.size()), pair(74, 0);
    for (const std::string& knot : d.knots) number(40, Shape_text::number(knot));
    if (s.is_rational)
      for (std::size_t i = 0; i < s.rows.size(); ++i) number(41, s.weight(i));
    for (std::size_t i = 0; i < s.rows.size(); ++i)
      for (std::size_t x = 0; x < 3; ++x)
        number(10 * (static_cast<int>(x) + 1), x < static_cast<std::size_t>(s.dimension) ? s.coordinate(i, x) : 0);
  }
  pair(0, "ENDSEC"), pair(0, "EOF");
}

// The shapes in space, over doubles.
std::vector<Spline_numbers> splines_of(const std::vector<Shape_text>& shapes) {
  std::vector<Spline_numbers> splines;
  for (const Shape_text& s : shapes) {
    if (s.dimension != 3 && (s.dimension != 2 || s.is_surface()))
      throw std::invalid_argument(
          "--output: a CAD model holds curves in the plane and in space, and surfaces in space");
    Spline_numbers& spline = splines.emplace_back();
    for (const Shape_text::Direction& d : s.directions) {
      spline.directions.push_back({d.points, d.degree, {}});
      for (const std::string& knot : d.knots) spline.directions.back().knots.push_back(Shape_text::number(knot));
    }
    for (std::size_t i = 0; i < s.rows.size(); ++i)
      spline.points.push_back(
          {s.coordinate(i, 0), s.coordinate(i, 1), s.dimension == 3 ? s.coordinate(i, 2) : 0, s.weight(i)});
  }
  return splines;
}

// Returns whether an ending says that a file is not in the format .g2.
bool is_other_format(const std::string& ending) {
  return ending == ".svg" || ending == ".dxf" || ending == ".json" || cad_format(ending);
}

} // namespace

void add_shape_output(po::options_description_easy_init& add, const std::string& what) {
  add("output,o", po::value<std::string>(),
      ("write " + what + " to a file, .g2, .json, .step or .brep, or curves as .svg or .dxf").c_str());
  add("decimals", po::value<std::string>()->implicit_value(""),
      "write .g2 with decimals in place of fractions: the shortest that lead to the nearest doubles, as "
      "--kernel double does anyway, or --decimals=N with N digits");
  add("flatness", po::value<std::string>(),
      "R > 0, how far a cubic of an .svg may be from a curve of a higher degree (default 1/10000 of the size)");
}

void check_shape_output(const Command_line& line) {
  check_outputs(line);
  if (line.has("output"))
    check_output_name(line, "output", {".g2", ".svg", ".dxf", ".json", ".step", ".stp", ".brep", ".brp"},
                      "; others are .svg, .dxf, .json, .step and .brep, and tessellate makes triangles of .g2");
  const std::string ending = extension(line.text("output"));
  const bool is_g2 = !is_other_format(ending);
  if (line.has("decimals")) {
    if (!line.has("output") || !is_g2) throw std::invalid_argument("--decimals: only with --output to a file .g2");
    const std::string digits = line.text("decimals");
    if (digits.size() > 3 || digits.find_first_not_of("0123456789") != std::string::npos ||
        (!digits.empty() && std::stoi(digits) > most_decimals))
      throw std::invalid_argument("--decimals: a number of digits up to " + std::to_string(most_decimals) +
                                  " is expected, not " + digits);
  }
  if (line.has("flatness")) {
    if (ending != ".svg") throw std::invalid_argument("--flatness: only with --output to a file .svg");
    line.number("flatness", CGAL::Exact_rational(0));
  }
}

void write_shapes(const Command_line& line, const std::function<void(std::ostream&)>& write) {
  const std::string name = line.text("output"), ending = has_no_format(name) ? "" : extension(name);
  const bool of_doubles = line.has("kernel") && line.text("kernel") == "double";
  if (!is_other_format(ending) && !line.has("decimals") && !of_doubles) return write_output(name, write);
  std::ostringstream g2;
  write(g2);
  write_output(name, [&](std::ostream& os) {
    if (ending == ".svg")
      write_svg_paths(os, g2.str(), line.has("flatness") ? line.number("flatness", CGAL::Exact_rational(0)) : 0);
    else if (ending == ".dxf")
      write_shapes_as_dxf(os, shapes_of(g2.str()));
    else if (cad_format(ending))
      write_cad(os, splines_of(shapes_of(g2.str())), ending);
    else if (ending == ".json")
      write_shapes_as_json(os, shapes_of(g2.str()));
    else
      write_decimals(os, g2.str(), line.text("decimals"));
  });
}
