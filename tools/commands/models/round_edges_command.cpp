// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/models/exact_models.h"
#include "commands/models/model_json.h"
#include "commands/work_limit.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/models/round_edges.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const round_edges_usage =
    R"(usage: geometric_continuity round-edges MODEL.g2... --set-back R [OPTIONS]

Rounds the sharp edges of a model: both surfaces at such an edge are trimmed
back from it, so that their new edges are about R away from the old one, within
one per cent, and exactly where the surface is linear across the edge and its
length across is rational; and a surface of degree 5 across leads from the one
new edge to the other. It is G2 with both along the whole new edges, which is
decided exactly on the numbers that are written: the surfaces of the model, then
the blends.

Edges stay that are G2, and those where the largest angle between the normals is
less than --min-kink or, as they are meant, greater than --max-kink. Where more
than two surfaces meet at the end of a rounded edge, a hole is left open: the
report names it. It also names blends that may be folded, as they are where they
have not enough room.

Exact arithmetic on numbers of thousands of digits can take long: --max-work N
allows N steps, about N nanoseconds, for each edge instead of 4000000000.

examples:
  geometric_continuity round-edges box.g2 --set-back 0.5 -o rounded.g2 \
      --plot rounded.svg
  geometric_continuity round-edges model.g2 --set-back 2 --max-kink 60 --json

Exit code: 0 when all blends are proved to be G2 along both edges and not to be
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
  add("set-back", po::value<std::string>(), "R > 0, the distance of the new edges from the old ones");
  add("min-kink", po::value<std::string>(), "edges of a smaller angle stay, in degrees (default 5)");
  add("max-kink", po::value<std::string>(), "edges of a greater angle are meant and stay, in degrees (default 180)");
  add("json", "print the report as JSON");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed for each edge");
  add_shape_output(add, "the model with rounded edges");
  add("plot", po::value<std::string>(), "draw it with isophotes, .svg");
}

int run_round_edges(const Command_line& line) {
  if (line.files().empty()) throw std::invalid_argument("round-edges: no file is given; see --help");
  const std::optional<double> set_back = line.length("set-back");
  if (!set_back) throw std::invalid_argument("round-edges: --set-back R is needed; see --help");
  const GC::Rounding_of_edges rounding{*set_back, angle(line, "min-kink", 5), angle(line, "max-kink", 180)};
  check_shape_output(line);
  const GC::Work_scope each(line.work_limit());
  return within_work_limit([&] { return input_name(line.files()[0]); },
                           [&] {
                             return read_exact_model(line.files()).visit([&](const auto& surfaces) {
                               return round_edges(line, surfaces, rounding);
                             });
                           });
}

} // namespace

const Command round_edges_command{"round-edges", round_edges_usage, describe_round_edges, run_round_edges};
