// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/fonts/font_sources.h"
#include "commands/fonts/verify_instances.h"
#include "commands/kink_options.h"
#include "commands/repair/chain_direction.h"
#include "commands/repair/repair_contour.h"
#include "commands/repair/repair_drawing.h"
#include "commands/repair/repair_font.h"
#include "commands/repair/repair_report.h"
#include "commands/repair/write_font.h"
#include "commands/roads/repair_roads.h"
#include "commands/roads/road_options.h"
#include "files/Unpacked_bytes.h"
#include "files/output.h"
#include "formats/font/Font_face.h"
#include "formats/font/Font_tables.h"
#include "formats/font/font_files.h"
#include "formats/g2_text/g2_curves_text.h"
#include "formats/input_formats.h"
#include "formats/opendrive/read_opendrive.h"
#include "formats/svg/svg_drawing.h"
#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/text.h>
#include <CGAL/Geometric_continuity/Traits.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const repair_usage = R"(usage: geometric_continuity repair FILE.svg|FILE.g2|FONT|SOURCE|ROAD.xodr
       -o FILE [OPTIONS]

Makes the kinks of a drawing, or of a chain of plane curves, exactly G1 by
moving handles, not nodes, on the grid of the file: the decimals of each path,
or of the curves. Of all allowed positions it takes the one that changes the
curves least, and if possible one that keeps joins G2; the report names a join
that falls to G1. A kink is an angle of at most --kink-angle degrees, as it is
drawn; corners, lines, arcs and smooth joins stay as they are. Where a handle
lies at its node the point behind it moves. Where an arc meets a kink, the other
handle moves to its tangent. The handle of a quadratic belongs to both of its
nodes, and moves only where neither is harmed. No handle moves farther than
--max-move units of the last decimal; the default is one unit more than twice
the offset of the kink.

With --to G2 the lengths of handles are changed, too, so that the curvatures
agree: exactly where the grid allows it, otherwise as nearly as possible. If
need be, handles at free ends and corners get other lengths as well. The report
tells the jump that is left. No change harms a join that is G2. A second repair
changes nothing.

Where numbers have more digits than a grid of their last decimal can hold (17
digits, fractions, handles longer than 2^28 units), nodes keep all of theirs,
and handles move to whole units of a coarser grid from their nodes: the finest
on which the drawing is no longer than 2^27 units. The report tells the unit.
Where this grid has no position near enough, one handle moves to a short decimal
multiple of the other one, or of a line, which takes more decimals. --grid UNIT
takes another grid, such as 0.001, also a finer one than that of the file, which
mends what is "not on this grid"; then no other positions are taken.

An arc with another radius, or with another end where it is free, may make a
kink vanish exactly. The report tells such numbers where no handle can move, and
--arcs takes the first of them that is a short decimal. In a chain, --reverse
reverses the curves that run backwards, as few as leave the fewest gaps, and
--close GAP closes gaps up to this width: both ends move to the middle, with the
handles that are theirs alone, or one end to the other where fewer joins would
be harmed.

Nothing else in the file changes. In drawings only numbers in the attribute d of
paths change, and a shorthand S or T becomes C or Q where its handle moves. The
reader of verify reads and decides the result again before it replaces FILE,
which may be the input. Joins are counted as verify counts them. Paths that are
defined and not drawn are repaired, too, and counted apart. A drawing that is
packed by gzip is refused. Units are those of each path.

A font is written where FILE ends with .ttf, .otf, .woff or .woff2, a collection
where it ends with .ttc or .otc: fontTools, in the Python that
GEOMETRIC_CONTINUITY_PYTHON names or in python3, moves the handles, every table
that need not change keeps its bytes, and what is written is decided again. The
masters of a variable font (gvar or CFF2) are mended together: at each node that
is no corner in any of them the handles get one ratio or one direction in all
masters, by the least moves on the grid, so that no instance has a kink; all
instances are verified with --max-kink 0. These moves can be long; --max-move
bounds them. Other joins stay. With --to G2 the curvatures of all masters are
made to agree as well, and the report tells the largest jump that is left at a
master or halfway between two.
-o FILE.json is the list of moves in the units of the font instead, which
scripts of font editors can apply, {"moves":[{"glyph":"S","index":54,
"contour":0,"point":7,"node":[x,y],"from":[x,y],"to":[x,y]},...]}. A component
is named once, with the glyphs that use it: "used_by". Joins are counted as
verify counts them, those of components in each glyph that has them: kinks,
bends of two lines, and what is off by rounding, by at most --off-by units.
Handles move at all of them, and kinks must not be left. Where TrueType leaves
out nodes between two handles, these handles do not move, and where such a node
lies on half a unit, no handle of its contour does.

Of road networks (.xodr) the joins of reference lines are repaired where the gap
exceeds --gap, or the kink --kink, and they are no more than --max-move metres
and --kink-angle degrees off. Where the end of a road is free, each piece behind
the gap starts at the enclosed end of the one before. Where only its start is
free, the pieces before the gap move. Where both ends are linked, the longer of
both pieces becomes three clothoids, whose joins are proved to be G2; its
curvatures at the ends stay, and its length changes by what the gap was. Other
bytes of the file stay, and all that verify decides is counted before and after.

The source of a font, a folder .ufo, .glyphs or .designspace with its UFOs, is
repaired by the Python module, where that is installed: masters with compatible
contours together, other outlines each by itself, with --to G2 the curvatures,
too.

examples:
  geometric_continuity repair drawing.svg -o drawing.svg
  geometric_continuity repair font.otf -o smooth.otf

Exit code: 0 when no kink is left, 1 when one is, when curves of a chain do not
meet (see --close and --reverse), or when not all joins are decided (an arc of a
rotated ellipse) or covered (an element that is not read), unless
--allow-undecided and --allow-uncovered leave them out; 2 on bad input.
)";

typedef GC::Traits_d<CGAL::Cartesian_d<CGAL::Exact_rational>> Chain_traits;

// The text of a file; one that is packed is refused.
std::string read_text(const std::string& file) {
  Input input(file);
  if (const std::string_view first = input.beginning(1); !first.empty() && Unpacked_bytes::may_begin(first[0]))
    throw GC::Error(GC::Error_code::malformed_input, input_name(file) + ": packed by gzip; unpack it first");
  return std::string(std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>());
}

// Reads the curves, calling f(curve) for each.
template <class Function> void for_each_curve(const std::string& text, const std::string& name, Function f) {
  std::istringstream is(text);
  GC::G2_curve_reader<Chain_traits, GC::Rational_bspline_curve<Chain_traits>> reader(is, name);
  while (const auto curve = reader.next()) f(*curve);
}

void check_curves(const std::string& text, const std::string& name) {
  for_each_curve(text, name, [](const auto&) {});
}

// Returns which curves, which are in the plane, run backwards.
Chain_reversal backward_curves(const std::string& text, const std::string& name, bool closed,
                               const CGAL::Exact_rational& gap) {
  std::vector<Curve_ends> ends;
  for_each_curve(text, name, [&](const auto& curve) {
    const auto point = [&](const CGAL::Exact_rational& t) {
      const auto p = curve(t);
      return Drawing_traits::Point(p[0], p[1]);
    };
    ends.push_back({point(curve.domain().first), point(curve.domain().second)});
  });
  return find_reversal(ends, closed, gap);
}

std::string curve_numbers(const std::vector<bool>& curves) {
  std::string numbers;
  std::size_t count = 0;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (curves[i] && ++count <= 10) numbers += (count == 1 ? "" : ", ") + std::to_string(i);
  return (count == 1 ? "curve " : "curves ") + numbers + (count > 10 ? ", ..." : "");
}

// The chain on the grid that is asked for, on its own, or where this is too fine on a coarser one,
// for a reason.
Grid_contour chain_contour(const G2_curves_text& curves, const Repair_options& options, bool closed,
                           std::string& reason) {
  const auto is_unknown = [](const Grid_curve& c) {
    return c.points.empty() && c.reason.find("too large") != std::string::npos;
  };
  Grid_contour contour;
  if (options.grid_decimals)
    contour = curves.contour_beside_grid(*options.grid_decimals);
  else if (curves.fits()) {
    contour = curves.contour();
    contour.closed = closed;
    reason = std::any_of(contour.curves.begin(), contour.curves.end(), is_unknown)
                 ? "a coordinate is too large for its decimals"
                 : needs_coarser_grid(contour, options);
  } else
    reason = "its numbers are no decimals of at most 15 digits";
  if (!reason.empty()) {
    contour = curves.contour_beside_grid(curves.coarser_decimals(longest_beside_grid(options)));
    contour.may_add_decimals = true;
  }
  contour.closed = closed;
  return contour;
}

std::string repaired_chain(const std::string& given, const std::string& name, const Command_line& line,
                           const Repair_options& options, Repair_report& report) {
  const bool closed = line.has("closed");
  check_curves(given, name);
  const G2_curves_text given_curves(given, name);
  if (!given_curves.refusal().empty())
    throw GC::Error(GC::Error_code::malformed_input, name + ": " + given_curves.refusal());
  std::string reason;
  const Grade_counts before = grades(chain_contour(given_curves, options, closed, reason), options.bound);
  std::string text = given;
  if (line.has("reverse") || before.count(GC::Visual_class::gap) != 0) {
    const Chain_reversal found = backward_curves(given, name, closed, options.close.value_or(0));
    if (line.has("reverse")) {
      text = given_curves.with_reversed(found.curves);
      for (std::size_t i = 0; i < found.curves.size(); ++i)
        if (found.curves[i]) report.add_reversed(i);
    } else if (found.gaps_after < found.gaps_before)
      report.add_hint("chain: " + curve_numbers(found.curves) + " reversed would close " +
                      counted(found.gaps_before - found.gaps_after, "gap") + "; --reverse does that");
  }
  const G2_curves_text curves(text, name);
  Grid_contour contour = chain_contour(curves, options, closed, reason);
  const Contour_repair done = repair(contour, options);
  if (contour.is_beside_grid && done.is_of_use())
    report.add_grid("chain", "\"element\":\"chain\"", contour.unit(), reason);
  report.add("chain", "\"element\":\"chain\"", contour, done,
             [](std::size_t curve) { return "curve " + std::to_string(curve); });
  std::string result = curves.with(contour);
  check_curves(result, name);
  const G2_curves_text written(result, name);
  Grid_contour again = contour.is_beside_grid ? written.contour_beside_grid(contour.decimals) : written.contour();
  again.closed = closed;
  report.add_grades(before, grades(again, options.bound));
  return result;
}

// The endings of the fonts that are written.
const Arguments& written_fonts() {
  static const Arguments endings{".ttf", ".otf", ".woff", ".woff2", ".ttc", ".otc"};
  return endings;
}

bool is_font_name(const std::string& file) {
  return std::count(written_fonts().begin(), written_fonts().end(), extension(file)) != 0;
}

bool ends_like_a_collection(const std::string& file) {
  const std::string ending = extension(file);
  return ending == ".ttc" || ending == ".otc";
}

bool is_variable_font(const std::string& bytes) {
  try {
    const std::string unpacked = bytes.compare(0, 3, "wOF") == 0 ? Font_face(bytes).unpacked() : bytes;
    return GC::Font_tables(unpacked).has("fvar");
  } catch (const std::exception&) { // no font of that kind: the reader of fonts says what it is
    return false;
  }
}

// The demand that every join of a font is smooth at every instance.
Instance_demand smooth_instances(const Repair_options& options) {
  return {Glyph_selection(), {options.bound, GC::Corner_threshold(0), GC::Kink_search().limit}, "0", true, 20};
}

// Mends the masters of a variable font together, and verifies all instances of what is written.
int repair_variable_font(const Command_line& line, const std::string& bytes, const Repair_options& options,
                         const Report_mode& mode) {
  line.refuse({"off-by"}, "not where the masters of a variable font are mended together");
  const std::string file = line.files()[0], output = line.text("output");
  Arguments numbers{line.text("to"), line.text("kink-angle")};
  if (line.has("max-move")) numbers.push_back(line.text("max-move"));
  const Written_font written = font_with_mended_masters(bytes, numbers, extension(output), input_name(file));
  write_output(output, [&](std::ostream& os) { os << written.bytes; });
  std::istringstream messages(written.messages);
  for (std::string message; std::getline(messages, message);) std::cout << GC::printable(message) << '\n';
  return verify_instances({output}, mode, smooth_instances(options));
}

// Repairs a font: writes the moves, or the font where the output has the name of one.
int repair_font(const Command_line& line, const Repair_options& options, const Report_mode& mode) {
  line.refuse({"arcs", "closed", "close", "grid", "json", "reverse"}, "not with fonts");
  const std::string file = line.files()[0], name = input_name(file), output = line.text("output");
  const bool font = is_font_name(output);
  if (!font) {
    if (!is_standard_output(output) && !is_standard_input(file) && lead_to_one_file(file, output))
      throw std::invalid_argument("--output: a font of a format that is not written; give a name that ends with .ttf, "
                                  ".otf, .woff or .woff2, or with .json for the moves");
    check_output_name(line, "output", {".json"},
                      "; fonts are written as .ttf, .otf, .woff and .woff2, and the Python module mends sources (UFO, "
                      "Glyphs)");
  }
  const std::string bytes = read_bytes(file);
  const bool is_collection = bytes.compare(0, 4, "ttcf") == 0, as_collection = ends_like_a_collection(output);
  if (font && is_collection != as_collection)
    throw std::invalid_argument("--output: " + output + ": " +
                                (is_collection ? "a collection of fonts is written as .ttc or .otc"
                                               : "a single font is written as .ttf, .otf, .woff or .woff2"));
  if (font && is_variable_font(bytes)) return repair_variable_font(line, bytes, options, mode);
  const Font_repair done = repair_font(bytes, name, options, rounding_bound(line));
  if (font) {
    const Written_font written = font_with_moves(bytes, done.moves, extension(output), file);
    if (repair_font(written.bytes, output, options, rounding_bound(line)).before != done.after)
      throw std::logic_error(name + ": the font that fontTools writes has other joins than the moves make");
    write_output(output, [&](std::ostream& os) { os << written.bytes; });
  } else
    write_output(output, [&](std::ostream& os) { os << done.moves; });
  const Report_subject subject = repair_subject();
  const Conclusion end(done.claims, mode, subject);
  report_stream(line) << done.text << end.text();
  return end.exit_code();
}

// The decimals of the grid that is asked for, if one is.
std::optional<int> grid_decimals(const Command_line& line) {
  if (!line.has("grid")) return std::nullopt;
  const CGAL::Exact_rational unit = line.number("grid", CGAL::Exact_rational(1));
  constexpr int most = 30;
  for (int decimals = -most; decimals <= most; ++decimals)
    if (unit == power_of_ten(-decimals)) return decimals;
  throw std::invalid_argument("--grid: '" + line.text("grid") + "' is no power of ten such as 0.001");
}

void describe_repair(po::options_description_easy_init add) {
  add("output,o", po::value<std::string>(), "the file to write, which may be the input");
  add("to", po::value<std::string>()->default_value("G1"), "G1 or G2");
  add("kink-angle", po::value<std::string>()->default_value("5"), "the largest angle of a kink, in degrees, up to 45");
  add("max-move", po::value<std::string>(),
      "how far a handle may move, in units of the last decimal; by default one more than twice the offset of the kink, "
      "and for --to G2 a tenth of the shorter handle, at least 1; for road networks in metres, by default 0.05");
  add("grid", po::value<std::string>(),
      "handles move to whole multiples of this power of ten from their nodes, e.g. 0.001; by default that of the last "
      "decimal, or where that is too fine, the smallest that the size of the drawing allows, which the report tells");
  describe_road_tolerances(add);
  add("off-by", po::value<std::string>(),
      "for fonts: up to so many units a handle may be off because of rounding, which is counted apart from kinks; 1 if "
      "not given");
  add("close", po::value<std::string>(),
      "of chains: gaps of up to this width, in coordinates, are closed; both ends move to the middle, or one to the "
      "other where that harms fewer joins");
  add("arcs",
      "of drawings: where no handle can move, an arc of a kink gets another radius, or another end where that is "
      "free, if the kink vanishes exactly and the number is a short decimal");
  add("reverse", "of chains: curves that run backwards are reversed, as few as leave the fewest gaps");
  add("closed", "the last curve of the chain leads back to the first");
  add("allow-undecided", "undecided joins and edges do not fail a requirement");
  add("allow-uncovered", "parts that are not covered do not fail a requirement");
  add("json", "print JSON");
}

int repair_roads(const Command_line& line, const Report_mode& mode) {
  line.refuse({"arcs", "closed", "close", "grid", "off-by", "reverse"}, "not with road networks");
  if (line.text("to") != "G1") throw std::invalid_argument("--to: road networks are repaired to G1 only");
  check_output_name(line, "output", {".xodr", ".xml"});
  Road_repair repair;
  read_road_tolerances(line, repair.demand);
  repair.max_move = line.number("max-move", repair.max_move);
  if (!(repair.max_move > 0)) throw std::invalid_argument("--max-move: not a positive length");
  repair.max_kink = GC::in_radians(line.number("kink-angle", CGAL::Exact_rational(5))).lower;
  int code = requirement_not_met;
  const std::string file = line.files()[0],
                    result = repaired_roads(read_text(file), input_name(file), repair, mode, report_stream(line), code);
  write_output(line.text("output"), [&](std::ostream& os) { os << result; });
  return code;
}

int run_repair(const Command_line& line) {
  if (line.files().size() != 1) throw std::invalid_argument("repair: one file is needed; see --help");
  if (!line.has("output")) throw std::invalid_argument("repair: -o FILE is needed");
  Repair_options options;
  options.harmonise = line.choice("to", {"G1", "G2"}) == "G2";
  const CGAL::Exact_rational angle = line.number("kink-angle", CGAL::Exact_rational(5));
  if (angle <= 0 || angle > 45)
    throw std::invalid_argument("--kink-angle: " + line.text("kink-angle") + " is not above 0 and at most 45 degrees");
  options.bound = GC::Corner_threshold(angle);
  if (line.has("max-move")) {
    options.max_move = line.number("max-move", CGAL::Exact_rational(1));
    if (*options.max_move <= 0) throw std::invalid_argument("--max-move: not a positive number of units");
  }
  options.grid_decimals = grid_decimals(line);
  options.change_arcs = line.has("arcs");
  if (line.has("close")) {
    options.close = line.number("close", CGAL::Exact_rational(1));
    if (*options.close <= 0)
      throw std::invalid_argument("--close: '" + line.text("close") + "' is not a positive length");
  }
  const Report_mode mode{line.has("json") ? Report_format::json : Report_format::text, line.has("allow-undecided"),
                         line.has("allow-uncovered"), true, false};
  const std::string file = line.files()[0], name = input_name(file), output = line.text("output");
  if (output.empty()) throw std::invalid_argument("--output: the name is empty");
  if (is_road_file(file)) return repair_roads(line, mode);
  line.refuse({"gap", "kink", "curvature"}, "only for road networks");
  if (is_font_source(file)) return repair_font_source(line);
  if (is_font_file(file)) return repair_font(line, options, mode);
  const bool drawing = is_svg_file(file);
  if (drawing)
    line.refuse({"closed", "close", "reverse"}, "not with drawings, whose curves meet");
  else
    line.refuse({"arcs"}, "only for drawings");
  line.refuse({"off-by"}, "only for fonts");
  check_output_name(line, "output", drawing ? Arguments{".svg", ".xml"} : Arguments{".g2"});
  Repair_report report(mode);
  const std::string text = read_text(file);
  const std::string result =
      drawing ? repaired_drawing(text, name, options, report) : repaired_chain(text, name, line, options, report);
  write_output(output, [&](std::ostream& os) { os << result; });
  return report.print(report_stream(line), name);
}

} // namespace

const Command repair_command{"repair", repair_usage, describe_repair, run_repair};
