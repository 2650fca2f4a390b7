// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/decide_cad.h"
#include "commands/cad/verify_cad.h"
#include "commands/chains/verify_chain.h"
#include "commands/command_line.h"
#include "commands/curvature_options.h"
#include "commands/drawings/read_drawing.h"
#include "commands/drawings/verify_drawings.h"
#include "commands/fonts/font_sources.h"
#include "commands/fonts/verify_fonts.h"
#include "commands/fonts/verify_instances.h"
#include "commands/kink_options.h"
#include "commands/lists/verify_list.h"
#include "commands/roads/rails.h"
#include "commands/roads/road_options.h"
#include "commands/roads/verify_roads.h"
#include "commands/surfaces_hint.h"
#include "commands/tolerances.h"
#include "files/output.h"
#include "formats/cad/read_cad.h"
#include "formats/font/font_files.h"
#include "formats/input_formats.h"
#include "formats/opendrive/read_opendrive.h"
#include "reports/Baseline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

const char* const verify_usage =
    R"(usage: geometric_continuity verify FILE.g2... | FILE.svg... | FONT...
       | SOURCE... | MODEL.step... | TOOLPATH.ngc... | ROAD.xodr...
       | RAIL.ifc... [OPTIONS]

Decides the continuity of every join of the chain that all curves form in the
given order. The decision is exact for the numbers of the files.
  C: equal derivatives
  G: equal derivatives with respect to arc length
  F: equal Frenet frame and curvatures
The inner knots of a curve are joins as well. Where tangents differ, the remark
calls it a kink, of at most --kink-angle degrees, or a corner; in chains,
--require is about every join, also about intended corners.

With --surfaces it finds all edges that the surfaces of the files share, and
decides G1 and G2 along each whole edge and along the knot lines inside
B-spline surfaces. For SVG drawings it decides the joins of every path and
basic shape, and names the element and the commands. It tells what they look
like: a corner, a kink, which is an angle of at most --kink-angle degrees, G1
or G2. Corners are intended, and need not meet --require G1, G2, ... Segments of
no length are left out. In G-code programs (.ngc, .nc, .gcode, ...) it decides
the joins of feed moves in a plane in the same way, and names them by their
lines.

For alignments in IFC 4.3 (.ifc) it proves or refutes the claims of the
segments: one position, direction, curvature, within the precision of the file,
or --gap, --kink and --curvature. --require G1 decides claims up to the
direction. In LandXML (.xml) it compares the numbers that follow from others,
within 0.001.

Of fonts (TrueType, OpenType, Type 1, WOFF; folders with all that is in them) it
grades the joins of each glyph, on the integers of the font:
  corner  the direction changes by more than --kink-angle, which is meant
  kink    it changes by less: a handle is off
  bend    it changes by less between two straight lines
  rounding  the same, by at most one unit of the font, or --off-by units
  G1      no change of direction, but of curvature; a handle at its node
  G2      nor of curvature
The worst kinks come first, those that are off by the most units, then bends.
--require G1 and G2 leave corners, bends and rounding alone; so does the largest
angle that a kink may have, --max-kink. --glyphs a-z,U+00E9,ampersand,#12 takes
characters and ranges of them, names and numbers of glyphs.

--all-instances encloses the largest kink of each join over all instances of a
variable font (TrueType or CFF2 outlines), if it is no corner at the default
instance. This is proved between the masters as well. The report has the axis
values of the largest kink. --max-work is then 50000000 for each join.

Sources of fonts (folders .ufo, .glyphs, .designspace) are decided by the Python
module, where that is installed, with --require, --kink-angle and --json.

Of CAD models (.step, .stp, .iges, .igs, .brep, .brp; where the program is
built with OpenCASCADE) it encloses, over each whole edge that two faces share
and each seam, the largest gap of both faces, the largest angle of their
normals and the largest jump of the curvature across the edge, in mm, degrees
and percent, and decides G0, G1 and G2 within --within GAP,ANGLEdeg,CURVATURE%,
or when it is not given within vda-4955, for --require G2 within 0.02,0.1deg,5%.
Geometry is taken as it is in the file; shapes are not healed, unless --sew
DISTANCE lets OpenCASCADE join the boundary edges that are within this distance
(in mm), as most IGES files need.
Boundary edges that lie beside each other and are not joined are not covered,
nor are entities that cannot be read, nor shells that are declared closed and
are open. Each file is read by a separate process, within --time-limit seconds
of processor time. An edge where the angle is at least --kink-angle everywhere
is a corner, and --require only asks that its faces meet. If the angle is that
large in places only, the edge is a fading corner, which may not be intended.
Creases inside of faces are kinks, whatever their angle. A face that comes back
below the other is a fold, and fails; so does a face whose outside is inside.
Where the file has no curve in a parameter plane, the curve in space is
projected. The report tells how far the projection is off, and defects of the
projection alone do not count. Curves without faces, such as those of wires, are
decided where their ends meet: gap, angle and jump of the curvature, for
--require G0, G1, G2, C0, C1 or C2.

Of road networks (ASAM OpenDRIVE 1.4 to 1.8, .xodr) it decides the joins of
reference lines (gap, kink, jump of the curvature), the lengths of paramPoly3,
elevation, superelevation, lane offsets and widths where one record passes into
the next, and the borders of lanes across sections, links and junctions: left
with left, right with right. Numbers are the decimals of the file; distances in
the plane are enclosed as narrowly as the verdict needs. Within --gap (metres),
--kink (radians) and --curvature (1/metre) every reference line must be G1, or
what --require says: G0, G1 or G2. Reference lines of linked roads need not
meet, their lanes must. What a file names and does not have is not covered.

--within 0.001,0.01deg,2% also tells how far each join is from continuous, in
guaranteed bounds. It tells which orders a join has if the ends may be apart by
this gap (in the units of the coordinates), the tangents by this angle (deg or
rad) and the curvature vectors by this part of the larger one. A fourth number
is the jump of the torsions. Bounds that are left out at the end must hold
exactly. --surfaces --within 0.001,0.01deg does so for the largest gap and the
largest angle of the normals along each edge, and also finds the boundary edges
that are that near to each other. Numbers without units are an angle in radians,
a relative curvature, a torsion and possibly a gap, A,K,T[,GAP]; for surfaces
A[,GAP]. Presets are published rules, with lengths in millimetres: class-a is
0.01,0.1deg, class-b 0.02,0.2deg, class-c 0.05,0.5deg, vda-4955 0.02,0.1deg,
mil-std-31000a 0.01,2deg.

--max-curvature K requires of every curve that its curvature is nowhere larger
than K, one over a length in the units of the coordinates, and --min-radius R
that its radius of curvature is nowhere less than R, which is K = 1/R. This is
decided exactly, for the curves between the joins, also of fonts, in units of
the font, and of the plan of roads and alignments; the bound may be reached. Of
CAD models the curves without faces are enclosed, and may exceed the bound by a
billionth of it, since their numbers are rounded. It is not for surfaces.
Corners at the joins are those that --require G1 asks for. Where a curve exceeds
the bound, the report names the place where it is bent most.

examples:
  geometric_continuity verify outline.g2 --closed --require G2
  geometric_continuity verify drawing.svg --require G1 --kink-angle 3

With --format sarif and junit, a join that does not meet the requirement is an
error. Without a requirement, gaps and kinks are notes.

Everything that is given is decided, undecided (the tolerance lies between the
guaranteed bounds, a limit was reached) or not covered (elements of a drawing
that cannot be read, edges of surfaces that are single points, ...), and the
report says how much and why. "proved" and exit code 0 mean that all of it is
decided, unless --allow-undecided and --allow-uncovered leave out the rest.

Exact decisions on numbers of thousands of digits, or of high order and degree,
can take long: --max-work N allows N steps, about N nanoseconds, for each join,
edge or curve, instead of 4000000000.

--baseline FILE leaves out the findings of a report that --format sarif has
written: only new findings are reported, and only these can make the exit code
1. So a check can begin with files that have findings already. A finding that
has moved, or is better, is known; a finding that is worse is new.

--jsonl LIST verifies each of the files that the text LIST names, one on each
line. Each file has its own process, and all cores are used. When a file is
finished, its record is added to --output: a JSON object on a line, with the
report of --json, or with the error of a file that is bad, crashes or reaches
--time-limit or --memory-limit. A file is skipped if it has a record there with
the same options, the same version of the program, and the same size and SHA-256
of the file. So an interrupted run can be continued. All other files are
verified again. merge adds records up.

--certificate OUT writes, for chains, drawings and --surfaces, the numbers from
which check_certificate OUT proves each verdict again.

Exit code: 0 when every join meets the requirement, 1 when one does not, or
is not decided, 2 on bad input, and when there is no join, unless --allow-empty
accepts that.
)";

// The format that --format or --json asks for.
Report_format report_format(const Command_line& line) {
  const std::string name = line.choice("format", {"text", "json", "sarif", "junit"});
  if (!line.has("json"))
    return name == "text"    ? Report_format::text
           : name == "json"  ? Report_format::json
           : name == "sarif" ? Report_format::sarif
                             : Report_format::junit;
  if (line.has("format") && name != "json") throw std::invalid_argument("--json: not with --format " + name);
  return Report_format::json;
}

// The largest angle that is a kink.
Kink_rule kink_rule(const Command_line& line) {
  return {line.has("kink-angle") ? line.text("kink-angle") : "5", corner_threshold(line)};
}

// The angle that no kink may exceed.
GC::Corner_threshold max_kink(const Command_line& line) {
  const Exact degrees = line.number<Exact>("max-kink", Exact(1) / Exact(2));
  if (degrees < Exact(0) || !(degrees < Exact(90)))
    throw std::invalid_argument("--max-kink: " + line.text("max-kink") + " is not at least 0 and less than 90 degrees");
  return GC::Corner_threshold(degrees);
}

// Returns the demands on all instances of variable fonts.
Instance_demand instance_demand(const Command_line& line) {
  line.refuse({"surfaces", "closed", "within", "sew", "time-limit", "kernel", "max-order", "require", "off-by"},
              "not with --all-instances");
  const bool required = line.has("max-kink");
  return {line.has("glyphs") ? Glyph_selection(line.text("glyphs")) : Glyph_selection(),
          {kink_rule(line).bound, max_kink(line), line.has("max-work") ? line.work_limit() : GC::Kink_search().limit},
          required ? line.text("max-kink") : "0.5",
          required,
          static_cast<std::size_t>(line.integer("worst", 0, 1000000))};
}

// Returns the demands on fonts.
Font_demand font_demand(const Command_line& line, const std::optional<Requirement>& required) {
  line.refuse({"surfaces", "closed", "within", "sew", "time-limit", "kernel", "max-order", "max-work", "certificate"},
              "not for fonts");
  Font_demand demand;
  if (line.has("glyphs")) demand.glyphs = Glyph_selection(line.text("glyphs"));
  demand.worst = static_cast<std::size_t>(line.integer("worst", 0, 1000000));
  demand.is_worst_given = line.has("worst");
  if (demand.is_worst_given) line.refuse({"baseline"}, "not with --worst, which leaves findings out");
  demand.rule.corner = kink_rule(line).bound;
  demand.rule.rounding = rounding_bound(line);
  if (line.has("off-by")) demand.off_by = line.text("off-by");
  if (line.has("max-kink")) {
    demand.max_kink = line.text("max-kink");
    demand.rule.max_kink = max_kink(line);
  }
  if (required) {
    if (required->text() != "G1" && required->text() != "G2")
      throw std::invalid_argument("--require " + required->text() + ": of fonts G1 and G2 are decided");
    demand.rule.required = required->order() == 1 ? GC::Visual_class::g1 : GC::Visual_class::g2;
  }
  return demand;
}

// Returns the demands on CAD models.
Cad_demand cad_demand(const Command_line& line, const std::optional<Requirement>& required) {
  line.refuse({"surfaces", "closed", "kernel", "max-order", "certificate"}, "not for CAD models");
  const bool asks_curvature = required && required->order() > 1;
  Cad_demand demand = demand_within(line.has("within") ? line.text("within")
                                    : asks_curvature   ? default_cad_tolerance_of_curvature
                                                       : default_cad_tolerance,
                                    kink_rule(line).bound);
  if (!required) return demand;
  if (required->kind() == GC::Continuity_kind::F || required->order() > 2)
    throw std::invalid_argument("--require " + required->text() +
                                ": of CAD models G0, G1 and G2 are decided, of curves without faces C0 to C2, too");
  if (required->order() > demand.most)
    throw std::invalid_argument("--require " + required->text() + ": needs more bounds than --within " +
                                demand.tolerance + " has; for " + required->text() + " e.g. 0.02,0.1deg,5%");
  demand.order = required->order();
  demand.kind = required->kind();
  return demand;
}

void describe_verify(po::options_description_easy_init add) {
  add("surfaces", "the files hold the patches of a model");
  add("closed", "the last curve leads back to the first");
  add("max-order", po::value<int>()->default_value(3), "the highest order to decide, from 0 to 32");
  add("require", po::value<std::string>(), "the order that every join must have: C1, G2, F3, ...");
  add("within", po::value<std::string>(),
      "the tolerance: GAP,ANGLEdeg,CURVATURE%[,TORSION], or a preset; with --surfaces GAP,ANGLEdeg");
  add("kink-angle", po::value<std::string>(),
      "the largest angle that is a kink, in degrees, instead of 5; what is larger is a corner, which in drawings, "
      "fonts and CAD models is meant and need not meet a requirement of G orders");
  describe_curvature_bound(add);
  describe_road_tolerances(add);
  add("lane-borders", "for road networks: the borders of lanes must have the order of --require, too");
  add("sew", po::value<std::string>(), "for CAD models: join boundary edges that are within this distance, in mm");
  add("time-limit", po::value<std::string>(),
      "for CAD models: the seconds of processor time that reading one file may take, 60 if not given; with --jsonl, "
      "those that deciding one file may take");
  add("jsonl", po::value<std::string>(),
      "verify each of the files whose names stand in this file, and write their records");
  add("output,o", po::value<std::string>(),
      "with --jsonl: the file to which records are added, instead of standard output");
  add("memory-limit", po::value<std::string>(), "with --jsonl: the MiB that one file may take, 4096 if not given");
  add("jobs", po::value<int>()->default_value(0),
      "with --jsonl: files at a time, by default as many as there are cores");
  add("baseline", po::value<std::string>(), "report only what this report in the format SARIF does not have");
  add("all-instances", "of variable fonts: enclose the largest kink of each join over all instances");
  add("max-kink", po::value<std::string>(),
      "for fonts: require that no kink exceeds this angle in degrees, with --all-instances in no instance; it has no "
      "default: without it no angle is required, and --all-instances counts the kinks of more than 0.5");
  add("off-by", po::value<std::string>(),
      "for fonts: up to so many units a handle may be off because of rounding, which meets each requirement; 1 "
      "if not given");
  add("glyphs", po::value<std::string>(), "for fonts: the glyphs to verify, e.g. a-z,U+00E9,ampersand");
  add("worst", po::value<int>()->default_value(10),
      "for fonts: how many joins to show of each, in JSON of each glyph; SARIF and JUnit have all if it is not given");
  add("allow-undecided", "undecided joins and edges do not fail a requirement");
  add("allow-uncovered", "parts that are not covered do not fail a requirement");
  add("allow-empty", "accept that there is no join");
  add("summary", "print only the counts and what does not meet the requirement; so it is on a terminal for more than "
                 "5000 joins");
  add("format", po::value<std::string>()->default_value("text"),
      "text; json: for programs; sarif: SARIF 2.1.0, for code scanning; junit: JUnit's XML, for continuous "
      "integration");
  add("json", "the same as --format json");
  add("certificate", po::value<std::string>(),
      "write for each join or edge the numbers from which check_certificate proves the verdict again");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed for one join, edge or curve");
  add("kernel", po::value<std::string>()->default_value("exact"),
      "exact: the numbers as written; double: each number is first rounded to a double, then all is exact");
}

int run_verify(const Command_line& line, std::ostream* certificate);

int run_verify_list(const Command_line& line) {
  if (!line.files().empty()) throw std::invalid_argument("--jsonl: the files are those of the list, and no others");
  line.refuse({"certificate", "format", "json"}, "not with --jsonl");
  if (line.has("output")) check_output_name(line, "output", {".jsonl", ".ndjson", ".json"});
  const double mebibytes = line.number("memory-limit", 4096.);
  if (!(mebibytes >= 16 && mebibytes < 1e9))
    throw std::invalid_argument("--memory-limit: '" + line.text("memory-limit") + "' is not at least 16 MiB");
  return verify_list({line.text("jsonl"), line.has("output") ? line.text("output") : "-",
                      line.given_options({"jsonl", "output", "memory-limit", "jobs", "time-limit"}),
                      line.seconds("time-limit", 60), static_cast<std::uint64_t>(mebibytes * 1048576),
                      line.integer("jobs", 0, 4096)});
}

// With --certificate, which is written as a whole or not at all.
int run_verify(const Command_line& line) {
  if (line.has("jsonl")) return run_verify_list(line);
  line.refuse({"output", "memory-limit", "jobs"}, "only with --jsonl");
  if (!line.has("certificate")) return run_verify(line, nullptr);
  const std::string output = line.text("certificate");
  if (is_standard_output(output)) throw std::invalid_argument("--certificate: standard output is that of the report");
  for (const std::string& file : line.files())
    if (!is_standard_input(file) && lead_to_one_file(file, output))
      throw std::invalid_argument("--certificate: " + output + " is a file that is verified");
  check_output_name(line, "certificate", {".txt"});
  line.refuse({"within", "kernel", "all-instances", "baseline", "max-curvature", "min-radius"},
              "not with --certificate, which certifies exact orders");
  int code = bad_input;
  GC::write_file_atomically(output, [&](std::ostream& os) { code = run_verify(line, &os); });
  return code;
}

int run_verify(const Command_line& line, std::ostream* certificate) {
  if (line.files().empty()) throw std::invalid_argument("verify: no file is given; see --help");
  std::optional<Requirement> required;
  if (line.has("require")) required = Requirement(line.text("require"));
  const Arguments files = line.files();
  if (std::any_of(files.begin(), files.end(), is_font_source)) return verify_font_sources(line);
  std::optional<Baseline> baseline;
  if (line.has("baseline")) baseline.emplace(line.text("baseline"));
  const Report_mode mode{report_format(line),
                         line.has("allow-undecided"),
                         line.has("allow-uncovered"),
                         line.has("allow-empty"),
                         line.has("summary"),
                         certificate,
                         baseline ? &*baseline : nullptr};
  const std::optional<Curvature_bound> bound = curvature_bound(line);
  const auto refuse_bound = [&](const std::string& reason) { line.refuse({"max-curvature", "min-radius"}, reason); };
  if (line.has("all-instances")) {
    refuse_bound("not with --all-instances");
    if (!are_fonts(files)) throw std::invalid_argument("--all-instances: only for fonts");
    return verify_instances(files, mode, instance_demand(line));
  }
  if (are_fonts(files)) {
    Font_demand demand = font_demand(line, required);
    demand.bound = bound;
    return verify_fonts(files, mode, demand);
  }
  line.refuse({"glyphs", "worst", "max-kink", "off-by"}, "only for fonts");
  const GC::Work_scope each(line.work_limit());
  if (are_cad_files(files)) {
    Cad_demand demand = cad_demand(line, required);
    demand.curvature = bound;
    return verify_cad(files, mode, demand, {Cad_drawing::none, line.length("sew"), line.seconds("time-limit", 60)});
  }
  line.refuse({"sew", "time-limit"}, "only for CAD models");
  const auto roads = std::count_if(files.begin(), files.end(), is_road_file);
  if (roads != 0) {
    if (roads != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("road networks (.xodr) and other files cannot be verified together");
    Road_demand demand = road_demand(line, required);
    demand.bound = bound;
    return verify_roads(files, mode, demand);
  }
  line.refuse({"lane-borders"}, "only for road networks");
  const auto rails = std::count_if(files.begin(), files.end(), is_rail_file);
  if (rails != 0) {
    if (rails != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("alignments (.ifc, LandXML) and other files cannot be verified together");
    Rail_demand demand = rail_demand(line, required);
    demand.bound = bound;
    return verify_rails(files, mode, demand);
  }
  line.refuse({"gap", "kink", "curvature"}, "only for road networks and alignments");
  const auto drawings = std::count_if(files.begin(), files.end(), is_drawing_file);
  if (drawings != 0) {
    if (drawings != static_cast<std::ptrdiff_t>(files.size()))
      throw std::invalid_argument("drawings (.svg), toolpaths (.ngc) and curves (.g2) cannot be verified together");
    line.refuse({"surfaces", "closed", "within", "kernel"}, "not for drawings and toolpaths");
    if (certificate != nullptr && std::any_of(files.begin(), files.end(), is_toolpath_file))
      throw std::invalid_argument("--certificate: not for toolpaths");
  }
  if (line.has("surfaces")) {
    refuse_bound("not with --surfaces: it bounds curves, not the normal curvatures of surfaces");
    line.refuse({"closed", "max-order", "kernel", "kink-angle"}, "not with --surfaces");
    std::optional<GC::Edge_tolerance> tolerance;
    if (line.has("within")) tolerance = parse_tolerances(line.text("within"), true).edges();
    if (required && (required->kind() != GC::Continuity_kind::G || required->order() > 2))
      throw std::invalid_argument("--require " + required->text() + ": along an edge G0, G1 and G2 are decided");
    if (tolerance && required && required->order() > 1)
      throw std::invalid_argument("--require " + required->text() + ": within a tolerance, G0 and G1 are decided");
    return verify_surfaces(files, mode, required ? std::optional<int>(required->order()) : std::nullopt, tolerance);
  }
  Join_demand demand{line.integer("max-order", 0, 32), required, {}, kink_rule(line).bound, bound};
  if (required) demand.max_order = (std::max)(demand.max_order, required->order());
  if (line.has("within")) demand.tolerance = parse_tolerances(line.text("within"), false);
  if (required && demand.tolerance && required->order() > (required->kind() == GC::Continuity_kind::C ? 2 : 3))
    throw std::invalid_argument("--require " + required->text() +
                                ": within a tolerance, G or F up to 3 and C up to 2 are decided");
  if (drawings != 0) return verify_drawings(files, demand.max_order, mode, required, kink_rule(line), bound);
  const bool rounded = line.choice("kernel", {"exact", "double"}) == "double";
  if (bound && std::any_of(files.begin(), files.end(), is_standard_input))
    throw std::invalid_argument("--max-curvature, --min-radius: the curves are read twice, which standard input cannot "
                                "be; write them to a file");
  return with_hint_of_surfaces(files, [&] { return verify_chain(files, rounded, line.has("closed"), mode, demand); });
}

} // namespace

const Command verify_command{"verify", verify_usage, describe_verify, run_verify};
