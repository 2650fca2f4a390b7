// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/repair/repair_contour.h"
#include "commands/repair/repair_font.h"
#include "commands/repair/repair_report.h"
#include "files/output.h"
#include "files/progress.h"
#include "formats/font/font_files.h"
#include "formats/g2_text/g2_curves_text.h"
#include "formats/svg/Unpacked_bytes.h"
#include "formats/svg/svg_drawing.h"
#include "formats/svg/svg_path_attributes.h"
#include "formats/svg/svg_path_text.h"

#include "formats/svg/read_svg_path.h"
#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits_d.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const repair_usage = R"(usage: geometric_continuity repair FILE.svg|FILE.g2|FONT -o FILE [OPTIONS]

Makes the kinks of a drawing, or of a chain of plane curves, exactly G1 by
moving handles, not nodes, on the grid of the file: the decimals of each path,
or of the curves. Of all positions on the grid the one with the least moves is
taken. A kink is an angle of at most --kink-angle degrees; corners, lines, arcs
and handles that lie at their nodes stay as they are. The handle of a quadratic
belongs to both of its nodes, and moves only where both stay smooth.

With --to G2 the lengths of handles are changed, too, so that the curvatures
agree: exactly where the grid allows it, otherwise as nearly as it does, and the
jump that is left is told. It is not changed where it would harm a join that is
G2. No handle moves farther than --max-move units of the last decimal.

Nothing else in the file changes: of drawings only numbers in the attribute d of
paths, in which a shorthand S or T becomes C or Q where its handle moves. What
is written is read and decided again before it replaces FILE, which may be the
input. A drawing that is packed by gzip is refused. Transforms are not applied:
angles and units are those of each path.

A font is not changed: -o FILE.json is the list of moves in its units, which
scripts of font editors can apply, {"moves":[{"glyph":"S","contour":0,"point":7,
"from":[x,y],"to":[x,y]},...]}. Where TrueType leaves out nodes between two
handles, these handles do not move.

Exit code: 0 when no kink is left, 1 when one is, 2 on bad input.
)";

typedef GC::Traits_d<CGAL::Cartesian_d<CGAL::Exact_rational>> Chain_traits;

// The text of a file; one that is packed is refused.
std::string read_text(const std::string& file) {
  Input input(file);
  if (const std::string_view first = input.beginning(1); !first.empty() && Unpacked_bytes::may_begin(first[0]))
    throw GC::Error(GC::Error_code::malformed_input, input_name(file) + ": packed by gzip; unpack it first");
  return std::string(std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>());
}

// Takes note of nothing: reads a drawing only to refuse what is wrong.
struct Silent_handler : Drawing_handler {
  void subpath(const Drawing_element&, int, const Drawing_subpath&) override {}
  void not_read(const Drawing_element&, const std::string&) override {}
};
void check_drawing(const std::string& text, const std::string& name) {
  std::istringstream is(text);
  Silent_handler handler;
  read_svg_drawing(is, name, handler);
}

void check_curves(const std::string& text, const std::string& name) {
  std::istringstream is(text);
  GC::G2_curve_reader<Chain_traits, GC::Rational_bspline_curve<Chain_traits>> reader(is, name);
  while (reader.next()) {
  }
}

// The grades of the joins of path data, by the reader that `verify` uses. Segments of no length are left out.
Grade_counts path_grades(const std::string& data, const std::string& place, const GC::Kink_bound& bound) {
  typedef GC::Bezier_curve<Drawing_traits> Curve;
  Grade_counts counts;
  GC::Svg_path_reader<Drawing_traits> reader(data, place);
  while (const std::optional<Drawing_subpath> subpath = reader.next()) {
    std::vector<const Curve*> curves;
    for (const auto& segment : subpath->segments) {
      const Curve* const curve = segment.bezier();
      if (curve == nullptr || std::count(curve->begin(), curve->end(), segment.start()) <= curve->degree())
        curves.push_back(curve);
    }
    const std::size_t n = curves.size(), joins = n == 0 || subpath->closed ? n : n - 1;
    for (std::size_t i = 0; i < joins; ++i)
      if (const Curve* const left = curves[i], * const right = curves[(i + 1) % n]; left != nullptr && right != nullptr)
        ++counts[*GC::join_grade(*left, *right, bound)];
  }
  return counts;
}

// The edits of the data of a path, and the data after them.
struct Repaired_path {
  std::vector<Svg_path_text::Edit> edits;
  std::string data;
};

Repaired_path repair_path(const Svg_path_attribute& path, const Repair_options& options, Repair_report& report) {
  const std::string place = path.element.text();
  std::ostringstream members;
  members << "\"element\":\"path\",\"id\":";
  GC::write_json(members, path.element.id);
  members << ",\"line\":" << path.element.line;
  const auto unread = [&](const std::string& reason) {
    report.add_unread(place, members.str(), reason);
    return Repaired_path{{}, path.value};
  };
  if (!path.refusal.empty()) return unread(path.refusal);
  const std::string where = path.element.file + ':' + std::to_string(path.element.line) + ": " + path.element.name +
                            (path.element.id.empty() ? "" : " \"" + path.element.id + '"') + ", d";
  Grade_counts before;
  try {
    before = path_grades(path.value, where, options.bound);
  } catch (const GC::Error& error) { // of a path that is not drawn: others have been read
    return unread(error.what());
  }
  const Svg_path_text text(path.value);
  if (!text.refusal().empty()) {
    report.add_grades(before, before);
    return unread(text.refusal());
  }
  std::vector<Grid_contour> contours = text.subpaths();
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour_repair done = repair(contours[i], options);
    report.add(place + ", subpath " + std::to_string(i + 1), members.str() + ",\"subpath\":" + std::to_string(i + 1),
               contours[i], done, [&](std::size_t curve) {
                 const std::size_t command = text.command(i, curve);
                 return command == 0 ? "segment " + std::to_string(curve + 1) : "command " + std::to_string(command);
               });
  }
  const std::vector<Svg_path_text::Edit> edits = text.edits(contours);
  std::string written;
  std::size_t read = 0;
  for (const Svg_path_text::Edit& edit : edits) {
    written.append(path.value, read, edit.begin - read) += edit.text;
    read = edit.end;
  }
  written.append(path.value, read, std::string::npos);
  const std::vector<Grid_contour> again = Svg_path_text(written).subpaths();
  // The number of decimals may have become smaller.
  const auto same = [](const Grid_contour& x, const Grid_contour& y) {
    return std::equal(x.curves.begin(), x.curves.end(), y.curves.begin(), y.curves.end(),
                      [&](const Grid_curve& c, const Grid_curve& d) {
                        return std::equal(
                            c.points.begin(), c.points.end(), d.points.begin(), d.points.end(),
                            [&](const GC::Grid_vector& p, const GC::Grid_vector& q) { return x.text(p) == y.text(q); });
                      });
  };
  const Grade_counts after = path_grades(written, where, options.bound);
  Grade_counts expected;
  for (const Grid_contour& contour : contours)
    for (const auto& [grade, count] : grades(contour, options.bound)) expected[grade] += count;
  if (after != expected || !std::equal(again.begin(), again.end(), contours.begin(), contours.end(), same))
    throw std::logic_error(where + ": what would be written is not what was computed; nothing is written");
  report.add_grades(before, after);
  return {edits, written};
}

std::string repaired_drawing(const std::string& text, const std::string& name, const Repair_options& options,
                             Repair_report& report) {
  if (text.find('\0') != std::string::npos)
    throw GC::Error(GC::Error_code::malformed_input,
                    name + ": a drawing in UTF-16 is not repaired; convert it to UTF-8");
  check_drawing(text, name);
  std::string result;
  std::vector<std::string> data; // of each path
  std::size_t read = 0;
  Progress progress("paths");
  const std::vector<Svg_path_attribute> paths = svg_path_attributes(text, name);
  for (const Svg_path_attribute& path : paths) {
    progress.step(data.size(), [&] { return static_cast<double>(data.size()) / static_cast<double>(paths.size()); });
    const Repaired_path repaired = repair_path(path, options, report);
    for (const Svg_path_text::Edit& edit : repaired.edits) {
      result.append(text, read, path.position[edit.begin] - read) += edit.text;
      read = path.position[edit.end];
    }
    data.push_back(repaired.data);
  }
  result.append(text, read, std::string::npos);
  const std::vector<Svg_path_attribute> again = svg_path_attributes(result, name);
  if (!std::equal(again.begin(), again.end(), data.begin(), data.end(),
                  [](const Svg_path_attribute& path, const std::string& expected) { return path.value == expected; }))
    throw std::logic_error(name + ": what would be written is not what was computed; nothing is written");
  check_drawing(result, name);
  return result;
}

std::string repaired_chain(const std::string& text, const std::string& name, bool closed, const Repair_options& options,
                           Repair_report& report) {
  check_curves(text, name);
  const G2_curves_text curves(text, name);
  if (!curves.refusal().empty()) throw GC::Error(GC::Error_code::malformed_input, name + ": " + curves.refusal());
  Grid_contour contour = curves.contour();
  contour.closed = closed;
  const Grade_counts before = grades(contour, options.bound);
  const Contour_repair done = repair(contour, options);
  report.add("chain", "\"element\":\"chain\"", contour, done,
             [](std::size_t curve) { return "curve " + std::to_string(curve + 1); });
  std::string result = curves.with(contour);
  check_curves(result, name);
  Grid_contour again = G2_curves_text(result, name).contour();
  again.closed = closed;
  report.add_grades(before, grades(again, options.bound));
  return result;
}

// Writes the moves that would repair a font.
int repair_font(const Command_line& line, const Repair_options& options) {
  line.refuse({"closed", "json"}, "not with fonts");
  const std::string file = line.files()[0], output = line.text("output");
  if (!is_standard_output(output) && !is_standard_input(file) && lead_to_one_file(file, output))
    throw std::invalid_argument("--output: the font itself, which is not changed; the moves are written as JSON");
  const Font_repair done = repair_font(read_bytes(file), input_name(file), options);
  write_output(output, [&](std::ostream& os) { os << done.moves; });
  report_stream(line) << done.text;
  return done.after.count(GC::Join_grade::kink) == 0 ? requirement_met : requirement_not_met;
}

} // namespace

int repair_command(const Arguments& arguments) {
  const Command_line line(repair_usage, arguments, [](po::options_description_easy_init add) {
    add("output,o", po::value<std::string>(), "the file to write, which may be the input");
    add("to", po::value<std::string>()->default_value("G1"), "G1 or G2");
    add("kink-angle", po::value<std::string>()->default_value("5"),
        "the largest angle of a kink, in degrees, up to 45");
    add("max-move", po::value<std::string>(),
        "how far a handle may move, in units of the last decimal; a tenth of the shorter handle, at least 1, unless it "
        "is given");
    add("closed", "the last curve of the chain leads back to the first");
    add("json", "print JSON");
  });
  if (line.help()) return requirement_met;
  if (line.files().size() != 1) throw std::invalid_argument("repair: one file is needed; see --help");
  if (!line.has("output")) throw std::invalid_argument("repair: -o FILE is needed");
  Repair_options options;
  options.harmonise = line.choice("to", {"G1", "G2"}) == "G2";
  const CGAL::Exact_rational angle = line.number("kink-angle", CGAL::Exact_rational(5));
  if (angle <= 0 || angle > 45)
    throw std::invalid_argument("--kink-angle: " + line.text("kink-angle") + " is not above 0 and at most 45 degrees");
  options.bound = GC::Kink_bound(angle);
  if (line.has("max-move")) {
    options.max_move = line.number("max-move", CGAL::Exact_rational(1));
    if (*options.max_move <= 0) throw std::invalid_argument("--max-move: not a positive number of units");
  }
  const std::string file = line.files()[0], name = input_name(file), output = line.text("output");
  if (output.empty()) throw std::invalid_argument("--output: the name is empty");
  if (is_font_file(file)) return repair_font(line, options);
  const bool drawing = is_svg_file(file);
  if (drawing) line.refuse({"closed"}, "not with drawings");
  if (!drawing) check_g2_name(line, "output");
  Repair_report report(line.has("json"));
  const std::string text = read_text(file);
  const std::string result = drawing ? repaired_drawing(text, name, options, report)
                                     : repaired_chain(text, name, line.has("closed"), options, report);
  write_output(output, [&](std::ostream& os) { os << result; });
  report.print(report_stream(line), name);
  return report.has_kinks() ? requirement_not_met : requirement_met;
}
