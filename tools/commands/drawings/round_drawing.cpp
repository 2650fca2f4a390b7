// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/drawings/round_drawing.h"

#include "commands/drawings/segment_joins.h"
#include "commands/kink_options.h"
#include "commands/repair/decimal_text.h"
#include "files/input.h"
#include "files/output.h"
#include "formats/svg/read_svg_path.h"
#include "formats/svg/svg_drawing.h"
#include "reports/words.h"

#include <CGAL/Fraction_traits.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/join_predicates.h>
#include <CGAL/Geometric_continuity/repairs/round_corners.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Fraction;
typedef GC::Bezier_curve<Drawing_traits> Plane_curve;
typedef GC::Coordinate_vector<Fraction, 2> Plane_point;

Plane_point point_of(const Plane_curve& c, int j) { return c.coordinates(j); }

// The number with so many digits behind the point that is nearest to another one.
Fraction with_digits(const Fraction& x, int digits) {
  typedef CGAL::Fraction_traits<Fraction> Parts;
  Fraction scale(1);
  for (int i = 0; i < digits; ++i) scale *= 10;
  const bool negative = x < 0;
  Parts::Numerator_type p;
  Parts::Denominator_type q;
  Parts::Decompose()(Fraction((negative ? Fraction(-x) : x) * scale + Fraction(1) / 2), p, q);
  const Fraction r = Fraction(Parts::Numerator_type(p / q)) / scale;
  return negative ? Fraction(-r) : r;
}

// Rounds to so many digits from the first that is not zero on.
Fraction with_significant_digits(const Fraction& x, int digits) {
  const double size = std::abs(CGAL::to_double(x));
  if (size == 0) return x;
  return with_digits(x, (std::max)(0, digits - 1 - static_cast<int>(std::floor(std::log10(size)))));
}

// Writes a finite decimal as it is, and another number as a double.
void write_decimal(std::ostream& os, const Fraction& x) {
  if (const std::optional<std::string> text = decimal_text(x))
    os << *text;
  else
    GC::write_number(os, CGAL::to_double(x));
}

// How corners are rounded.
struct Rounding_demand {
  GC::Corner_threshold bound;
  Fraction size;          // a distance or a radius, in the units of the drawing
  bool is_radius = false; // of a circle that touches both sides: cuts are where it does
  bool with_arcs = false; // between lines, arcs of this circle
};

// A subpath of Bezier curves whose corners are rounded, in the coordinates of its element.
class Rounded_subpath {
  const Rounding_demand& demand_;
  const Fraction size_;             // in the coordinates of the element
  const int decimals_;              // of the coordinates
  std::vector<Plane_curve> curves_; // in the place of an arc its chord
  std::vector<std::string> arcs_;   // of each curve, the numbers of an arc before its end; or empty
  const bool closed_;
  std::vector<bool> is_corner_; // behind each curve

  std::size_t next(std::size_t i) const { return i + 1 == curves_.size() ? 0 : i + 1; }

  // The parameter of the point at exactly the distance that is asked for, where its coordinates are
  // short decimals and no less of the line is to be cut off.
  std::optional<Fraction> exact_cut(const Plane_curve& line, bool from_end, const Fraction& wanted,
                                    double distance) const {
    const Plane_point chord = point_of(line, 1) - point_of(line, 0);
    const std::optional<Fraction> length = GC::rational_square_root(Fraction(dot(chord, chord)));
    if (!length || distance < CGAL::to_double(wanted)) return std::nullopt;
    const Fraction t = from_end ? Fraction(1 - wanted / *length) : Fraction(wanted / *length);
    const Plane_point p = point_of(line, 0) + t * chord;
    return rounded(p) == p ? std::optional<Fraction>(t) : std::nullopt;
  }

  // The parameter of the point at a distance along a curve from its start, or from its end, as a
  // short decimal: by the lengths of chords.
  Fraction cut(const Plane_curve& c, bool from_end, const Fraction& wanted, double distance, bool is_arc) const {
    if (c.degree() == 1)
      if (const std::optional<Fraction> t = exact_cut(c, from_end, wanted, distance)) return *t;
    if (is_arc) {
      const Plane_point chord = point_of(c, 1) - point_of(c, 0);
      const Fraction t(distance / std::sqrt(CGAL::to_double(dot(chord, chord))));
      return from_end ? Fraction(1 - t) : t;
    }
    constexpr int chords = 256;
    const auto point = [&](int i) {
      const auto p = c(Fraction(from_end ? chords - i : i) / chords);
      return std::pair(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    };
    double length = 0;
    std::pair<double, double> before = point(0);
    for (int i = 1; i <= chords; ++i) {
      const auto p = point(i);
      const double chord = std::hypot(p.first - before.first, p.second - before.second);
      if (length + chord >= distance) {
        const double t = (i - 1 + (chord == 0 ? 0 : (distance - length) / chord)) / chords;
        const Fraction short_t = with_significant_digits(Fraction(t), c.degree() == 1 ? 5 : 3);
        return from_end ? Fraction(1 - short_t) : short_t;
      }
      length += chord;
      before = p;
    }
    return from_end ? Fraction(0) : Fraction(1);
  }

  static double length(const Plane_curve& c) {
    double length = 0;
    for (int i = 0; i < 64; ++i) {
      const auto p = c(Fraction(i) / 64), q = c(Fraction(i + 1) / 64);
      length += std::hypot(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()));
    }
    return length;
  }

  // At most 3/4 of a curve with one corner, and 3/8 of one with two, are cut off.
  double longest_cut(std::size_t i, bool at_end) const {
    const std::size_t before = i == 0 ? curves_.size() - 1 : i - 1;
    const bool other = at_end ? is_corner_[before] : is_corner_[i];
    return length(curves_[i]) * (other ? 0.375 : 0.75);
  }

  static Plane_curve part(const Plane_curve& c, const Fraction& a, const Fraction& b) {
    Plane_curve r = c;
    if (b < 1) r = r.split(b).first;
    if (0 < a) r = r.split(a).second;
    return r.with_domain(0, 1);
  }

  static Plane_curve cubic(const Plane_point& a, const Plane_point& b, const Plane_point& c, const Plane_point& d) {
    return Plane_curve(std::vector<Plane_point>{a, b, c, d});
  }

  // A handle in the direction of a vector, of short decimals if that is one.
  static Plane_point handle(const Plane_point& node, const Plane_point& direction, const Plane_point& wanted) {
    const Fraction square = dot(direction, direction);
    const Fraction ratio = square == 0 ? square : Fraction(dot(wanted - node, direction) / square);
    if (!(0 < ratio)) throw GC::Error(GC::Error_code::not_representable, "a handle has no length in short decimals");
    return node + with_significant_digits(ratio, 6) * direction;
  }

  Plane_point rounded(const Plane_point& p) const {
    Plane_point r(2);
    for (int i = 0; i < 2; ++i) r[i] = with_digits(p[i], decimals_ + 4);
    return r;
  }

  // The arc with both cuts of a corner as ends: its chord in the result, and the text of its other
  // numbers.
  void add_arc(const Plane_curve& left, const Plane_curve& right, const Fraction& radius,
               std::vector<Plane_curve>& result, std::vector<std::string>& arcs) const {
    const Plane_point u = point_of(left, 1) - point_of(left, 0), v = point_of(right, 1) - point_of(right, 0);
    std::ostringstream text;
    for (int i = 0; i < 2; ++i) write_decimal(text << ' ', radius);
    text << " 0 0 " << (Fraction(u[0] * v[1]) > Fraction(u[1] * v[0]) ? 1 : 0);
    result.push_back(Plane_curve{std::vector<Plane_point>{point_of(left, 1), point_of(right, 0)}});
    arcs.resize(result.size());
    arcs.back() = text.str();
  }

  // A line whose ends have short decimals where they are those of arcs.
  Plane_curve with_short_ends(const Plane_curve& line, bool at_start, bool at_end) const {
    const auto short_point = [&](const Plane_point& p, bool is_cut) {
      Plane_point r = p;
      for (int i = 0; i < 2 && is_cut; ++i) r[i] = with_digits(p[i], decimals_ + 7);
      return r;
    };
    return Plane_curve(
        std::vector<Plane_point>{short_point(point_of(line, 0), at_start), short_point(point_of(line, 1), at_end)});
  }

  void add_blend(const Plane_curve& left, const Plane_curve& right, const Plane_point& corner,
                 std::vector<Plane_curve>& result) const {
    const int m = left.degree();
    const Plane_point p = point_of(left, m), q = point_of(right, 0);
    if (m == 1 && right.degree() == 1) return result.push_back(cubic(p, corner, corner, q));
    const Plane_point d = p - point_of(left, m - 1), e = point_of(right, 1) - q;
    const auto blend = GC::blend(left, right, GC::Cubics());
    const std::size_t n = static_cast<std::size_t>(blend.number_of_segments());
    const Plane_curve first(blend.segment(0)), last(blend.segment(static_cast<int>(n) - 1));
    const Plane_point b1 = handle(p, d, point_of(first, 1)), b2 = handle(q, Fraction(-1) * e, point_of(last, 2));
    if (n == 1) return result.push_back(cubic(p, b1, b2, q));
    const Plane_point c1 = rounded(point_of(first, 2)), c2 = rounded(point_of(last, 1)), chord = c2 - c1;
    const Plane_point middle = handle(c1, chord, point_of(last, 0));
    result.push_back(cubic(p, b1, c1, middle));
    result.push_back(cubic(middle, c2, b2, q));
  }

public:
  std::size_t corners = 0, exact = 0; // rounded, and those with exactly continuous curvature
  std::size_t arcs = 0, smaller = 0;  // those that are arcs, and of these with a smaller radius
  std::size_t at_arcs = 0;            // corners that stay

  // `arc_text` returns the numbers of an arc before its end, as they are written.
  template <class Arc_text>
  Rounded_subpath(const Drawing_subpath& path, const Rounding_demand& demand, const Fraction& size, int decimals,
                  Arc_text arc_text)
      : demand_(demand), size_(size), decimals_((std::max)(decimals, 0)), closed_(path.closed) {
    for (const auto& segment : path.segments) {
      arcs_.push_back(segment.arc() ? arc_text(segment) : "");
      curves_.push_back(segment.arc() ? Plane_curve{segment.start(), segment.end()}
                                      : segment.bezier()->with_domain(0, 1));
    }
    is_corner_.assign(curves_.size(), false);
    for (std::size_t i = 0; i < path.joins(); ++i) {
      const std::size_t j = next(i);
      if (segment_class(path.segments[i], path.segments[j], demand_.bound) != GC::Visual_class::corner) continue;
      is_corner_[i] = arcs_[i].empty() && arcs_[j].empty();
      ++(is_corner_[i] ? corners : at_arcs);
    }
  }

  // Writes the path data.
  void write(std::ostream& os) {
    const std::size_t n = curves_.size();
    std::vector<Fraction> from(n, Fraction(0)), to(n, Fraction(1));
    std::vector<Fraction> radius(n, Fraction(0)); // of arcs
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_corner_[i]) continue;
      const Plane_curve &left = curves_[i], &right = curves_[next(i)];
      const Fraction wanted = demand_.is_radius ? corner_distance(left, right, size_) : size_;
      const bool is_arc = demand_.with_arcs && left.degree() == 1 && right.degree() == 1;
      const double longest = (std::min)(longest_cut(i, true), longest_cut(next(i), false)),
                   d = (std::min)(CGAL::to_double(wanted), longest);
      to[i] = cut(left, true, wanted, d, is_arc);
      from[next(i)] = cut(right, false, wanted, d, is_arc);
      if (!is_arc) continue;
      const bool is_short = longest < CGAL::to_double(wanted);
      radius[i] =
          is_short ? with_significant_digits(Fraction(CGAL::to_double(size_) * longest / CGAL::to_double(wanted)), 12)
                   : size_;
      ++arcs;
      smaller += is_short;
    }
    std::vector<Plane_curve> parts, result;
    std::vector<std::string> arc_texts; // of the result
    const auto is_arc_behind = [&](std::size_t i) { return Fraction(0) < radius[i]; };
    for (std::size_t i = 0; i < n; ++i) {
      parts.push_back(part(curves_[i], from[i], to[i]));
      const bool at_start = is_arc_behind(i == 0 ? n - 1 : i - 1), at_end = is_arc_behind(i);
      if (at_start || at_end) parts.back() = with_short_ends(parts.back(), at_start, at_end);
    }
    for (std::size_t i = 0; i < n; ++i) {
      result.push_back(parts[i]);
      arc_texts.resize(result.size());
      arc_texts.back() = arcs_[i];
      if (!is_corner_[i]) continue;
      if (is_arc_behind(i)) {
        add_arc(parts[i], parts[next(i)], radius[i], result, arc_texts);
        continue;
      }
      const std::size_t before = result.size();
      add_blend(parts[i], parts[next(i)], point_of(curves_[next(i)], 0), result);
      std::vector<Plane_curve> chain(result.begin() + static_cast<std::ptrdiff_t>(before) - 1, result.end());
      chain.push_back(parts[next(i)]);
      if (GC::failing_joins(chain, GC::is_g2_join).empty()) ++exact;
    }
    const auto write_point = [](std::ostream& stream, const Plane_point& p) {
      write_decimal(stream << ' ', p[0]);
      write_decimal(stream << ' ', p[1]);
    };
    write_point(os << 'M', point_of(result[0], 0));
    arc_texts.resize(result.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Plane_curve& c = result[i];
      if (!arc_texts[i].empty()) {
        write_point(os << 'A' << arc_texts[i], point_of(c, 1));
        continue;
      }
      os << "?LQC"[c.degree()];
      for (int j = 1; j <= c.degree(); ++j) write_point(os, point_of(c, j));
    }
    if (closed_) os << 'Z';
  }
};

// The tag of a shape as that of a path with this data.
std::string tag_of_path(std::string_view tag, const std::string& data) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  const auto is_end = [&](char c) { return is_space(c) || c == '/' || c == '>'; };
  std::size_t i = static_cast<std::size_t>(std::find_if(tag.begin(), tag.end(), is_end) - tag.begin());
  const std::string_view name = tag.substr(1, i - 1);
  const std::size_t colon = name.find(':');
  std::string result =
      '<' + std::string(colon == std::string_view::npos ? "" : name.substr(0, colon + 1)) + "path d=\"" + data + '"';
  while (i < tag.size() && tag[i] != '/' && tag[i] != '>') {
    const std::size_t begin = i;
    while (is_space(tag[i])) ++i;
    const std::size_t attribute = i;
    while (i < tag.size() && tag[i] != '=' && !is_end(tag[i])) ++i;
    const std::string_view key = tag.substr(attribute, i - attribute);
    if (key.empty()) {
      result += tag.substr(begin, i - begin);
      continue;
    }
    i = tag.find_first_of("\"'", i);
    if (i == std::string_view::npos) break; // not well-formed, which the reader refuses
    i = tag.find(tag[i], i + 1) + 1;
    bool is_geometry = false;
    for (const char* known : {"points", "x", "y", "width", "height", "rx", "ry"})
      is_geometry = is_geometry || key == known;
    if (!is_geometry) result += tag.substr(begin, i - begin);
  }
  return result.append(tag.substr(i));
}

// Rounds the corners of a drawing that it receives.
class Drawing_rounder : public Drawing_handler {
  const std::string& text_;
  const Rounding_demand demand_;
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };
  std::vector<Edit> edits_;

  // The distance or radius in the coordinates of the element, for which the drawing is scaled by
  // the root of the determinant.
  Fraction own_size(const Drawing_element& element) const {
    const double scale = std::sqrt(std::abs(CGAL::to_double(element.transform.determinant())));
    return scale == 1 || !(scale > 0) ? demand_.size
                                      : Fraction(demand_.size / with_significant_digits(Fraction(scale), 9));
  }

  // Returns path data of all subpaths with rounded corners; empty where there is none, or where it
  // is not possible.
  template <class Arc_text>
  std::string rounded(const Drawing_element& element, const std::vector<Drawing_subpath>& paths, Arc_text arc_text) {
    std::ostringstream data;
    std::size_t found = 0, exact = 0, at_arcs = 0, by_arcs = 0, of_smaller = 0;
    for (const Drawing_subpath& path : paths) {
      if (path.segments.empty()) continue;
      Rounded_subpath rounded(path, demand_, own_size(element), element.decimals, arc_text);
      try {
        rounded.write(data);
      } catch (const GC::Error& error) {
        leave(element, std::string("no cubics are found: ") + error.what());
        return "";
      }
      found += rounded.corners;
      exact += rounded.exact;
      at_arcs += rounded.at_arcs;
      by_arcs += rounded.arcs;
      of_smaller += rounded.smaller;
    }
    if (at_arcs != 0) leave(element, counted(at_arcs, "corner") + " at an arc");
    if (found == 0) return "";
    corners += found;
    exact_corners += exact;
    arcs += by_arcs;
    smaller += of_smaller;
    ++elements;
    return data.str();
  }

  void leave(const Drawing_element& element, const std::string& reason) {
    left.push_back(element.text() + ": " + reason);
  }

public:
  std::size_t corners = 0, exact_corners = 0, elements = 0, arcs = 0, smaller = 0;
  std::vector<std::string> left; // elements, with the reasons

  Drawing_rounder(const std::string& text, const Rounding_demand& demand) : text_(text), demand_(demand) {}

  bool takes_paths() const override { return true; }

  void path(const Drawing_element& element, const Path_data& path) override {
    if (path.role == Path_role::repetition) return;
    if (!path.text.refusal().empty()) return leave(element, path.text.refusal());
    std::vector<Drawing_subpath> subpaths;
    GC::Svg_path_places places;
    try {
      GC::Svg_path_reader<Drawing_traits> reader(path.value, "d", &places);
      while (std::optional<Drawing_subpath> subpath = reader.next()) {
        subpath->leave_out_points();
        if (element.is_filled) subpath->join_ends();
        subpaths.push_back(*std::move(subpath));
      }
    } catch (const GC::Error& error) {
      return leave(element, GC::svg_reason(error));
    }
    const auto arc_text = [&](const auto& segment) {
      std::string numbers;
      const std::size_t first = places.commands[static_cast<std::size_t>(segment.command) - 1].first_number;
      for (std::size_t i = first; i < first + 5; ++i) {
        const GC::Text_range& range = places.numbers[i];
        numbers += ' ' + path.value.substr(range.begin, range.end - range.begin);
      }
      return numbers;
    };
    const std::string data = rounded(element, subpaths, arc_text);
    if (!data.empty()) edits_.push_back({path.text[0], path.text[path.value.size()], data});
  }

  void subpath(const Drawing_element& element, int, const Drawing_subpath& path) override {
    if (element.tag.empty() || element.name == "circle" || element.name == "ellipse" || element.name == "line") return;
    const bool is_rounded =
        std::any_of(path.segments.begin(), path.segments.end(), [](const auto& s) { return s.arc(); });
    if (is_rounded) return; // a rectangle with rx and ry
    if (element.has_percentages) return leave(element, "its size depends on the viewport");
    const std::string data =
        rounded(element, {path.transform(element.transform.inverse())}, [](const auto&) { return std::string(); });
    if (data.empty()) return;
    const std::size_t end = element.tag_begin + element.tag.size();
    edits_.push_back({element.tag_begin, end, tag_of_path(element.tag, data)});
    if (element.tag[element.tag.size() - 2] == '/') return;
    const std::string name(element.tag.substr(1, element.tag.find_first_of(" \t\r\n>") - 1));
    const std::size_t close = text_.find("</" + name, end), colon = name.find(':');
    const std::size_t local = colon == std::string::npos ? 0 : colon + 1;
    edits_.push_back({close + 2 + local, close + 2 + name.size(), "path"});
  }

  void not_read(const Drawing_element& element, const std::string& reason) override { leave(element, reason); }

  std::string result() {
    std::sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
    std::string result;
    std::size_t read = 0;
    for (const Edit& edit : edits_) {
      result.append(text_, read, edit.begin - read) += edit.text;
      read = edit.end;
    }
    return result.append(text_, read, std::string::npos);
  }
};

} // namespace

Exit_code round_drawing(const Command_line& line) {
  const Arguments files = line.files();
  if (files.size() != 1) throw std::invalid_argument("blend --corners: one drawing is needed; see --help");
  if (!line.has("corners")) throw std::invalid_argument("blend of a drawing: --corners all is needed; see --help");
  if (line.text("corners") != "all")
    throw std::invalid_argument("--corners: all corners of a drawing are rounded: all");
  const bool is_radius = line.has("radius");
  const char* const option = is_radius ? "radius" : "distance";
  if (is_radius && line.has("distance")) throw std::invalid_argument("--distance and --radius: one of them");
  if (!is_radius && !line.has("distance")) throw std::invalid_argument("--corners: --distance is needed, or --radius");
  if (!is_radius) line.refuse({"cubic"}, "corners of drawings are rounded by cubics, unless --radius asks for arcs");
  if (!line.has("output")) throw std::invalid_argument("blend of a drawing: -o OUT.svg is needed");
  check_output_name(line, "output", {".svg", ".xml"});
  const Fraction size = line.number(option, Fraction(0));
  if (!(Fraction(0) < size))
    throw std::invalid_argument("--" + std::string(option) + ": " + line.text(option) + " is not positive");
  Input input(files[0]);
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  Drawing_rounder rounder(text, {corner_threshold(line), size, is_radius, is_radius && !line.has("cubic")});
  std::istringstream stream(text);
  read_svg_drawing(stream, input_name(files[0]), rounder);
  const std::string result = rounder.result();
  write_output(line.text("output"), [&](std::ostream& os) { os << result; });
  std::ostream& report = report_stream(line);
  report << counted(rounder.corners, "corner") << " of " << counted(rounder.elements, "element")
         << (rounder.corners == 1 ? " is rounded" : " are rounded");
  const char* separator = ": ";
  if (rounder.arcs != 0) {
    report << separator << counted(rounder.arcs, "arc");
    if (rounder.smaller != 0) report << " (" << rounder.smaller << " of a smaller radius on short sides)";
    separator = ", ";
  }
  if (rounder.corners != rounder.arcs)
    report << separator << rounder.exact_corners << " with exactly continuous curvature, "
           << rounder.corners - rounder.arcs - rounder.exact_corners
           << " with tangents that are so exactly, and curvature up to rounding";
  report << '\n';
  for (const std::string& left : rounder.left) report << "left as it is: " << GC::printable(left) << '\n';
  return requirement_met;
}
