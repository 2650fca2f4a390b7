// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "Request.h"
#include "call.h"

#include "commands/chains/verify_chain.h"
#include "commands/commands.h"
#include "commands/drawings/verify_drawings.h"
#include "commands/fonts/read_fonts.h"
#include "commands/fonts/verify_fonts.h"
#include "commands/repair/repair_drawing.h"
#include "files/Unpacked_bytes.h"
#include "memory_file.h"
#include "reports/report_joins.h"

#include <algorithm>
#include <iostream>
#include <sstream>

// geometric_continuity.mjs calls these functions on files: the commands `verify` and `repair` of
// the program, which print their JSON on standard output, and the curves of drawings and fonts. The
// text of the file follows the options.

namespace {

// While it exists standard output is this stream.
class Captured_output {
  std::streambuf* const before_;

public:
  explicit Captured_output(std::ostream& os) : before_(std::cout.rdbuf(os.rdbuf())) {}
  Captured_output(const Captured_output&) = delete;
  Captured_output& operator=(const Captured_output&) = delete;
  ~Captured_output() { std::cout.rdbuf(before_); }
};

// A report of nothing is a report.
Report_mode json_mode() {
  Report_mode mode;
  mode.format = Report_format::json;
  mode.allow_empty = true;
  return mode;
}

std::optional<Requirement> requirement(Request& request) {
  const std::string text(request.word());
  return text == "-" ? std::nullopt : std::optional<Requirement>(text);
}

void verify_svg(Request& request, std::ostream& os) {
  const int max_order = request.count();
  const std::optional<Requirement> required = requirement(request);
  const Exact degrees = request.exact();
  std::ostringstream degrees_text;
  GC::write_number(degrees_text, degrees);
  const Kink_rule kinks{degrees_text.str(), GC::Corner_threshold(degrees)};
  const Memory_file file("drawing.svg", request.text());
  const Captured_output output(os);
  verify_drawings({file.name()}, required ? (std::max)(max_order, required->order()) : max_order, json_mode(), required,
                  kinks);
}

void repair_svg(Request& request, std::ostream& os) {
  Repair_options options;
  options.bound = GC::Corner_threshold(request.exact());
  options.max_move = request.optional_exact();
  options.harmonise = request.count() != 0;
  const std::string name = "drawing.svg", text = request.text();
  if (!text.empty() && Unpacked_bytes::may_begin(text[0]))
    throw GC::Error(GC::Error_code::malformed_input, name + ": packed by gzip; unpack it first");
  Repair_report report(json_mode());
  const std::string svg = repaired_drawing(text, name, options, report);
  GC::write_json(os << "{\"svg\":", svg);
  report.print(os << ",\"report\":", name);
  os << '}';
}

void verify_g2(Request& request, std::ostream& os) {
  const int max_order = request.count();
  const std::optional<Requirement> required = requirement(request);
  const bool closed = request.count() != 0, surfaces = request.count() != 0;
  const std::optional<Exact> max_curvature = request.optional_exact();
  std::optional<Curvature_bound> bound;
  if (max_curvature) {
    if (surfaces) throw GC::Error(GC::Error_code::malformed_input, "verifyG2: maxCurvature is a bound of curves");
    std::ostringstream text;
    GC::write_number(text, *max_curvature);
    bound = Curvature_bound{*max_curvature, "bent by at most the curvature " + text.str()};
  }
  const Memory_file file("curves.g2", request.text());
  const Captured_output output(os);
  if (surfaces) {
    if (required && (required->kind() != GC::Continuity_kind::G || required->order() > 2))
      throw GC::Error(GC::Error_code::malformed_input, "verifyG2: along an edge G0, G1 and G2 are decided");
    verify_surfaces({file.name()}, json_mode(), required ? std::optional<int>(required->order()) : std::nullopt,
                    std::nullopt);
  } else
    verify_chain({file.name()}, false, closed, json_mode(),
                 {required ? (std::max)(max_order, required->order()) : max_order, required, std::nullopt,
                  GC::Corner_threshold(), bound});
}

// A name of the options: "-" for none.
Glyph_selection glyphs(Request& request) {
  const std::string words(request.word());
  return words == "-" ? Glyph_selection() : Glyph_selection(words);
}

void verify_font(Request& request, std::ostream& os) {
  Font_demand demand;
  const std::optional<Requirement> required = requirement(request);
  if (required) {
    if (required->text() != "G1" && required->text() != "G2")
      throw GC::Error(GC::Error_code::malformed_input, "verifyFont: of fonts G1 and G2 are decided");
    demand.rule.required = required->order() == 1 ? GC::Visual_class::g1 : GC::Visual_class::g2;
  }
  demand.rule.corner = GC::Corner_threshold(request.exact());
  demand.worst = static_cast<std::size_t>(request.count());
  demand.glyphs = glyphs(request);
  const Memory_file file("font", request.text());
  const Captured_output output(os);
  verify_fonts({file.name()}, json_mode(), demand);
}

// The points are the nearest doubles, x and y by turns; with weights it is an arc.
void write_curve(std::ostream& os, const Report_curve& curve) {
  const auto list = [&os](const char* name, const std::vector<double>& numbers) {
    os << name;
    for (std::size_t i = 0; i < numbers.size(); ++i) GC::write_number(os << (i == 0 ? "[" : ","), numbers[i]);
    os << ']';
  };
  list("{\"points\":", curve.points);
  if (!curve.weights.empty()) list(",\"weights\":", curve.weights);
  if (!curve.link.points.empty()) os << ",\"exact\":\"" << curve.link.points << '"';
  os << '}';
}

// Writes all subpaths of a drawing.
class Drawing_curves : public Drawing_handler {
  std::ostream& os_;
  const char* separator_ = "";

public:
  explicit Drawing_curves(std::ostream& os) : os_(os) {}
  void subpath(const Drawing_element& element, int number, const Drawing_subpath& path) override {
    GC::write_json(os_ << separator_ << "{\"element\":", element.name);
    GC::write_json(os_ << ",\"id\":", element.id);
    os_ << ",\"line\":" << element.line << ",\"subpath\":" << number
        << ",\"closed\":" << (path.closed ? "true" : "false") << ",\"curves\":[";
    for (std::size_t i = 0; i < path.segments.size(); ++i)
      write_curve(os_ << (i == 0 ? "" : ","), *drawn_curve(path.segments[i], 0));
    os_ << "]}";
    separator_ = ",\n";
  }
  void not_read(const Drawing_element&, const std::string&) override {}
};

void svg_curves(Request& request, std::ostream& os) {
  std::istringstream text(request.text());
  Drawing_curves curves(os << "{\"subpaths\":[");
  read_svg_drawing(text, "drawing.svg", curves);
  os << "]}";
}

// Writes the outlines of glyphs.
class Font_curves : public Font_visitor {
  std::ostream& os_;
  const char* separator_ = "";

public:
  explicit Font_curves(std::ostream& os) : os_(os) {}
  void begin_font(const Font_face&, const Font_result&) override {}
  Join_counts glyph(const Font_face& font, int glyph, const Glyph_outline& outline, const Font_result&) override {
    GC::write_json(os_ << separator_ << "{\"index\":" << glyph << ",\"name\":", font.glyph_name(glyph));
    os_ << ",\"contours\":[";
    // a power of two: all numbers are exact
    const double steps = static_cast<double>(outline.steps());
    for (std::size_t contour = 0; contour < outline.contours(); ++contour) {
      os_ << (contour == 0 ? "[" : ",[");
      for (const Glyph_segment* s = outline.begin(contour); s != outline.end(contour); ++s) {
        Report_curve curve{{}, {}, 0};
        for (std::size_t i = 0; i <= static_cast<std::size_t>(s->degree); ++i)
          for (const std::int64_t x : {s->points[i].x, s->points[i].y}) curve.points.push_back(double(x) / steps);
        write_curve(os_ << (s == outline.begin(contour) ? "" : ","), curve);
      }
      os_ << ']';
    }
    os_ << "]}";
    separator_ = ",\n";
    return {};
  }
  void end_font(const Font_face&, Font_result&) override {}
};

void font_curves(Request& request, std::ostream& os) {
  const Glyph_selection selection = glyphs(request);
  const Memory_file file("font", request.text());
  Font_curves curves(os << "{\"glyphs\":[");
  read_fonts({file.name()}, selection, curves);
  os << "]}";
}

} // namespace

const std::vector<Module_function> module_functions = {{"verifySvg", verify_svg}, {"repairSvg", repair_svg},
                                                       {"verifyG2", verify_g2},   {"verifyFont", verify_font},
                                                       {"svgCurves", svg_curves}, {"fontCurves", font_curves}};
