// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "command_line.h"
#include "input.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/mesh.h>
#include <CGAL/Geometric_continuity/Traits_3.h>
#include <CGAL/Geometric_continuity/models/tessellate.h>
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const usage = R"(usage: geometric_continuity tessellate MODEL.g2... -o OUT [OPTIONS]

Writes triangles for the surfaces of the files, without cracks along the edges
that they have in common.
)";

// Names the options by which the work is bounded.
template <class Traits, class Mode>
GC::Tessellation<Traits> tessellate(const std::vector<GC::Bspline_surface<Traits>>& model, const Mode& mode,
                                    std::size_t max_triangles) {
  try {
    return GC::tessellate(model, mode, max_triangles);
  } catch (const GC::Error& error) {
    if (error.code() != GC::Error_code::work_limit) throw;
    throw std::runtime_error(std::string(error.what()) + "; see --grid, --tolerance and --max-triangles");
  }
}

template <class FT> int tessellate(const Command_line& line) {
  typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
  const std::vector<GC::Bspline_surface<Traits>> model = read_surfaces<Traits>(line.files());
  const std::size_t most = static_cast<std::size_t>(line.integer("max-triangles"));
  const GC::Tessellation<Traits> mesh =
      line.has("grid") ? tessellate(model, GC::Uniform_grid{line.integer("grid")}, most)
                       : tessellate(model, GC::Chord_tolerance{line.number<double>("tolerance", 0.01)}, most);
  GC::write_mesh(line.text("output"), mesh);
  std::cout << model.size() << " surfaces: " << mesh.points.size() << " points, " << mesh.triangles.size()
            << " triangles, " << GC::mesh_edges(mesh.triangles) << '\n';
  return requirement_met;
}

} // namespace

int tessellate_command(const Arguments& arguments) {
  const Command_line line(usage, arguments, [](po::options_description_easy_init add) {
    add("output,o", po::value<std::string>(),
        "write the triangles; the name, with .off, .ply, .obj or .stl, tells the format");
    add("tolerance", po::value<std::string>(), "R, the largest distance between surfaces and triangles (default 0.01)");
    add("grid", po::value<int>(), "instead: N times N cells for each polynomial patch");
    add("max-triangles", po::value<int>()->default_value(GC::max_tessellation_triangles),
        "more triangles are refused before any is made");
    add("kernel", po::value<std::string>()->default_value("double"), "exact or double");
  });
  if (line.help()) return requirement_met;
  if (line.files().empty()) throw std::invalid_argument("tessellate: no file is given; see --help");
  if (!line.has("output")) throw std::invalid_argument("tessellate: -o OUT.off|ply|obj|stl is needed");
  if (line.has("grid") && line.has("tolerance"))
    throw std::invalid_argument("tessellate: --grid and --tolerance exclude each other");
  if (line.integer("max-triangles") < 1) throw std::invalid_argument("--max-triangles: not positive");
  GC::mesh_format(line.text("output")); // refused before anything is computed
  return line.choice("kernel", {"exact", "double"}) == "exact" ? tessellate<CGAL::Exact_rational>(line)
                                                               : tessellate<double>(line);
}
