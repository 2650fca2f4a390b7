// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/models/exact_models.h"
#include "commands/models/model_json.h"
#include "commands/models/round_solid.h"
#include "commands/work_limit.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"
#include "formats/solids/patches_of_solid.h"
#include "formats/solids/read_solid.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace {

const char* const round_edges_usage =
    R"(usage: geometric_continuity round-edges MODEL.g2... --set-back R [OPTIONS]
       geometric_continuity round-edges SOLID.step|.brep|.off --set-back R ...

Rounds the edges of a solid with plane faces and straight edges, three of which
meet at each vertex. The result is closed. A solid is a CAD model, a polygon
mesh, or a model .g2 of plane surfaces without a boundary. Each edge is cut off
at the distance R in both faces. Chains of edges are replaced by B-spline
surfaces of the degrees 5 and 5: C2 along the chain, and G2 with the faces and
each other along whole edges, which is decided exactly on the numbers that are
written. A .g2 has them cut into patches with four edges, a CAD model has
trimmed faces that share their edges.

A CAD model may also have walls, cylinders and extrusions, which meet planes at
right angles: plates with rounded outlines, holes and bosses. An outline that is
smooth is rounded as a whole, with one surface for each of its edges: exactly G2
with the wall and the plane, and along the outline as smooth as this is. Corners
of lines break in a mitre. The result is a CAD model.

--set-back EDGE=R gives one edge its own distance, with the number by which
`verify` names it, such as 7, or 0u0 in a .g2. --edges 0,3,5 rounds only these;
where one other edge of a vertex stays sharp, blends meet in a mitre, and where
two do, they run out at the face. Errors name an edge or a vertex, and where
cuts are too long for each other, the bound.

The sharp edges of other models .g2 are rounded where two surfaces meet. Both
are trimmed back from the edge. The distance of their new edges from the old one
is R within one per cent, and exactly R where the surface is linear across the
edge and its length across is rational. A surface of degree 5 across leads from
one new edge to the other. It is G2 with both along the whole new edges. Edges
that are G2 stay. So do edges where the largest angle between the normals is
less than --min-kink, or greater than --max-kink, because these are intended.
Where more than two surfaces meet at the end of a rounded edge, a hole is left
open: the report names it. It also names blends that may be folded, which
happens where they lack room. --open does so with solids, too.

Exact arithmetic on numbers of thousands of digits can take long: --max-work N
allows N steps, about N nanoseconds, for each edge instead of 4000000000.

examples:
  geometric_continuity round-edges box.g2 --set-back 0.5 -o rounded.g2 \
      --plot rounded.svg
  geometric_continuity round-edges part.step --set-back 2 --set-back 7=1 \
      -o rounded.step

Exit code: 0 when all blends are proved to be G2 along their edges and not to be
folded, 1 when one is not (the files are written nevertheless), 2 on bad input.
)";

double angle(const Command_line& line, const char* option, double otherwise) {
  const double degrees = line.number<double>(option, otherwise);
  if (!(0 <= degrees && degrees <= 180))
    throw std::invalid_argument(std::string("--") + option + ": " + line.text(option) +
                                " is not between 0 and 180 degrees");
  return degrees;
}

std::string numbers(const std::vector<std::size_t>& values) {
  std::string text;
  for (std::size_t x : values) text += (text.empty() ? "" : ", ") + std::to_string(x);
  return text;
}

// A corner as a list of coordinates.
std::string point_text(const Exact_space::Point& p, const char* separator) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    std::ostringstream os;
    os << p[i];
    text += (i > 0 ? separator : "") + os.str();
  }
  return text;
}

template <class Surface> void write_text(std::ostream& os, const GC::Rounded_model<Surface>& model) {
  std::size_t number = model.surfaces.size();
  for (const auto& b : model.blends) {
    os << b.patch_a << ' ' << b.edge_a << " - " << b.patch_b << ' ' << b.edge_b << ": " << rounded(b.angle.upper, 4)
       << " degrees, rounded by surface " << number++ << ": " << b.with_a << " and " << b.with_b;
    if (b.fold)
      os << "; may be folded near (" << rounded(CGAL::to_double(b.fold->u.first), 4) << ", "
         << rounded(CGAL::to_double(b.fold->v.first), 4) << ')';
    os << '\n';
  }
  for (const auto& c : model.corners)
    os << "a hole at (" << point_text(c.point, ", ") << "), between the surfaces " << numbers(c.patches) << '\n';
  os << counted(model.surfaces.size(), "surface") << ", " << counted(model.blends.size(), "edge") << " rounded, "
     << counted(model.corners.size(), "corner") << " left open";
  if (model.meant > 0) os << "; " << model.meant << " beyond --max-kink";
  if (model.slight > 0) os << "; " << model.slight << " below --min-kink";
  if (model.not_rounded > 0) os << "; " << model.not_rounded << " with vanishing normals or more than two surfaces";
  os << '\n';
  if (!model.blends.empty())
    os << (model.is_g2() ? "G2 along all new edges, proved exactly\n" : "not G2 along all new edges\n");
}

template <class Surface> void write_json(std::ostream& os, const GC::Rounded_model<Surface>& model) {
  const char* separator = "{\"blends\":[";
  std::size_t number = model.surfaces.size();
  if (model.blends.empty()) os << separator;
  for (const auto& b : model.blends) {
    write_names(os << separator << '\n', b.patch_a, b.edge_a, b.patch_b, b.edge_b);
    os << ",\"surface\":" << number++ << ",\"angle_degrees\":";
    GC::write_json(os, std::optional<GC::Enclosure>(b.angle));
    os << ",\"order_a\":\"" << order(b.with_a) << "\",\"order_b\":\"" << order(b.with_b) << "\",\"possible_fold\":";
    if (b.fold)
      os << "{\"u\":[\"" << b.fold->u.first << "\",\"" << b.fold->u.second << "\"],\"v\":[\"" << b.fold->v.first
         << "\",\"" << b.fold->v.second << "\"]}}";
    else
      os << "null}";
    separator = ",";
  }
  separator = "],\n\"open_corners\":[";
  if (model.corners.empty()) os << separator;
  for (const auto& c : model.corners) {
    os << separator << "\n{\"point\":[\"" << point_text(c.point, "\",\"") << "\"],\"patches\":[" << numbers(c.patches)
       << "],\"blends\":[" << numbers(c.blends) << "]}";
    separator = ",";
  }
  os << "],\n\"summary\":{\"surfaces\":" << model.surfaces.size() << ",\"rounded\":" << model.blends.size()
     << ",\"open_corners\":" << model.corners.size() << ",\"beyond_max_kink\":" << model.meant
     << ",\"below_min_kink\":" << model.slight << ",\"not_rounded\":" << model.not_rounded
     << ",\"g2\":" << boolean(model.is_g2()) << "}}\n";
}

template <class Surface>
int round_edges(const Command_line& line, const std::vector<Surface>& surfaces, const GC::Rounding_of_edges& rounding) {
  const GC::Rounded_model<Surface> model = GC::round_edges(surfaces, rounding);
  std::ostream& report = report_stream(line);
  if (line.has("json"))
    write_json(report, model);
  else
    write_text(report, model);
  std::vector<Surface> all = model.surfaces;
  for (const auto& b : model.blends) all.push_back(b.surface);
  if (line.has("output"))
    write_shapes(line, [&](std::ostream& os) {
      for (const Surface& s : all) GC::write_g2(os, s);
    });
  if (line.has("plot"))
    write_output(line.text("plot"), [&](std::ostream& os) { draw_surfaces(os, all, GC::Svg_surface_style()); });
  for (const auto& b : model.blends)
    if (b.fold) return requirement_not_met;
  return model.is_g2() ? requirement_met : requirement_not_met;
}

void describe_round_edges(po::options_description_easy_init add) {
  add("set-back", po::value<Arguments>()->composing(),
      "R > 0, the distance of the new edges from the old ones; of a solid also EDGE=R, for one edge");
  add("edges", po::value<std::string>(), "of a solid: only these edges, separated by commas");
  add("profile", po::value<std::string>()->default_value("fair"),
      "of a solid: fair, or the part of the distance at which a profile turns, in (0, 1): greater ones are tighter");
  add("open", "trim the surfaces of a solid, too, and leave holes at its corners");
  add("min-kink", po::value<std::string>(), "edges of a smaller angle stay, in degrees (default 5, of a solid 0)");
  add("max-kink", po::value<std::string>(), "edges of a greater angle are meant and stay, in degrees (default 180)");
  add("json", "print the report as JSON");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed for each edge");
  add_shape_output(add, "the model with rounded edges");
  add("plot", po::value<std::string>(), "draw it with isophotes, .svg");
}

std::string number_text(std::size_t edge) { return std::to_string(edge); }
std::string side_text(std::size_t edge) {
  std::ostringstream os;
  os << edge / 4 << ' ' << GC::patch_edges[edge % 4];
  return os.str();
}

int run_round_edges(const Command_line& line) {
  if (line.files().empty()) throw std::invalid_argument("round-edges: no file is given; see --help");
  if (!line.has("set-back")) throw std::invalid_argument("round-edges: --set-back R is needed; see --help");
  const double least = angle(line, "min-kink", 5), greatest = angle(line, "max-kink", 180);
  check_shape_output(line);
  const GC::Work_scope each(line.work_limit());
  const auto name = [&] { return input_name(line.files()[0]); };
  if (is_solid_file(line.files()[0])) {
    line.refuse({"open"}, "only with models .g2");
    if (line.files().size() > 1)
      throw std::invalid_argument("round-edges: one solid is expected, and there are " +
                                  std::to_string(line.files().size()) + " files");
    return within_work_limit(name, [&] {
      const std::variant<Solid, Outlined_solid> solid = read_solid(line.files()[0]);
      if (const auto* outlined = std::get_if<Outlined_solid>(&solid)) return round_outlined_solid(line, *outlined);
      return round_solid(line, std::get<Solid>(solid), number_text);
    });
  }
  return within_work_limit(name, [&] {
    return read_exact_model(line.files()).visit([&](const auto& surfaces) {
      if constexpr (std::is_same_v<typename std::decay_t<decltype(surfaces)>::value_type, Exact_surface>)
        if (!line.has("open"))
          if (const std::optional<Solid> solid = solid_of_patches(surfaces))
            return round_solid(line, *solid, side_text);
      line.refuse({"edges", "profile"}, "only with solids: closed models of plane faces with straight edges");
      const std::string given = line.texts("set-back").back();
      if (line.texts("set-back").size() > 1 || given.find_first_of("=,") != std::string::npos)
        throw std::invalid_argument("--set-back: " + given +
                                    ": one distance for all edges is expected, since this is "
                                    "no closed model of plane faces with straight edges");
      return round_edges(line, surfaces, {Command_line::positive_length("set-back", given), least, greatest});
    });
  });
}

} // namespace

const Command round_edges_command{"round-edges", round_edges_usage, describe_round_edges, run_round_edges};
