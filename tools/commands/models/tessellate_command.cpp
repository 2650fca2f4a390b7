// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "files/output.h"
#include "files/progress.h"
#include "formats/g2_text/surfaces.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/mesh.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const tessellate_usage = R"(usage: geometric_continuity tessellate MODEL.g2... -o OUT [OPTIONS]

Writes triangles for the surfaces of the files, without cracks along the edges
that they have in common. The name of the output tells the format unless
--format does, as it must for standard output.
The triangles of closed surfaces are turned outwards.
Points in exact numbers can take long: --max-work N allows N steps, about N
nanoseconds, instead of 4000000000.
examples:
  geometric_continuity tessellate model.g2 --tolerance 0.001 -o model.stl
  geometric_continuity tessellate model.g2 --grid 8 -o - --format off
Exit code: 0 when the triangles are written, 2 on bad input.
)";

// Names the options by which the work is bounded.
template <class Traits, class Surface, class Mode>
GC::Tessellation<Traits> tessellate(const std::vector<Surface>& model, const Mode& mode, std::size_t max_triangles) {
  Progress patches("patches cut");
  std::optional<Progress> triangles;
  try {
    return GC::tessellate(model, mode, max_triangles, [&](GC::Tessellation_stage stage, std::size_t n) {
      if (stage == GC::Tessellation_stage::patches) return patches.step(n);
      if (!triangles) {
        patches.clear();
        triangles.emplace("triangles");
      }
      triangles->step(n);
    });
  } catch (const GC::Error& error) {
    if (error.code() != GC::Error_code::work_limit) throw;
    throw std::runtime_error(std::string(error.what()) + "; see --grid, --tolerance, --max-triangles and --max-work");
  }
}

// The format of --format, or that of the name of the output.
GC::Mesh_format output_format(const Command_line& line) {
  const std::string name = line.text("output");
  if (!line.has("format") && has_no_format(name))
    throw std::invalid_argument("tessellate -o " + name + ": --format off|ply|obj|stl is needed");
  if (!line.has("format")) return GC::mesh_format(name);
  const std::string format = '.' + line.choice("format", {"off", "ply", "obj", "stl"}), ending = extension(name);
  if (!has_no_format(name) && ending != format)
    throw std::invalid_argument("--format: not with " + name + ", which ends with '" + ending + "'");
  return GC::mesh_format(format);
}

template <class FT> int write_triangles(const Command_line& line, GC::Mesh_format format) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
  const Surface_model<Traits> model = read_surfaces<Traits>(line.files());
  const std::size_t most =
      static_cast<std::size_t>(line.integer("max-triangles", 1, (std::numeric_limits<int>::max)()));
  const GC::Tessellation<Traits> mesh = model.visit([&](const auto& surfaces) {
    const GC::Work_scope scope(line.work_limit(), "tessellate");
    return line.has("grid")
               ? tessellate<Traits>(surfaces, GC::Uniform_grid{line.integer("grid")}, most)
               : tessellate<Traits>(surfaces, GC::Chord_tolerance{line.number<double>("tolerance", 0.01)}, most);
  });
  write_output(line.text("output"), [&](std::ostream& os) { GC::write_mesh(os, mesh, format); });
  report_stream(line) << model.size() << " surfaces: " << mesh.points.size() << " points, " << mesh.triangles.size()
                      << " triangles, " << GC::mesh_edges(mesh.triangles) << '\n';
  return requirement_met;
}

void describe_tessellate(po::options_description_easy_init add) {
  add("output,o", po::value<std::string>(),
      "write the triangles; the name, with .off, .ply, .obj or .stl, tells the format");
  add("format", po::value<std::string>(), "off, ply, obj or stl, for standard output and devices");
  add("tolerance", po::value<std::string>(), "R, the largest distance between surfaces and triangles (default 0.01)");
  add("grid", po::value<int>(), "instead: N times N cells for each polynomial patch");
  add("max-triangles", po::value<int>()->default_value(GC::max_tessellation_triangles),
      "more triangles are refused before any is made");
  add("kernel", po::value<std::string>()->default_value("double"), "exact or double");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed with --kernel exact");
}

int run_tessellate(const Command_line& line) {
  if (line.files().empty()) throw std::invalid_argument("tessellate: no file is given; see --help");
  if (!line.has("output")) throw std::invalid_argument("tessellate: -o OUT.off|ply|obj|stl is needed");
  if (line.has("grid") && line.has("tolerance"))
    throw std::invalid_argument("tessellate: --grid and --tolerance exclude each other");
  const GC::Mesh_format format = output_format(line);
  if (line.choice("kernel", {"exact", "double"}) == "exact") return write_triangles<CGAL::Exact_rational>(line, format);
  line.refuse({"max-work"}, "only with --kernel exact");
  return write_triangles<double>(line, format);
}

} // namespace

const Command tessellate_command{"tessellate", tessellate_usage, describe_tessellate, run_tessellate};
