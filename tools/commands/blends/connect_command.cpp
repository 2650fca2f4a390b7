// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/work_limit.h"
#include "files/input.h"
#include "files/output.h"
#include "formats/shapes/write_shapes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/surface_blends/connect_g1.h>
#include <CGAL/Simple_cartesian.h>

#include <stdexcept>
#include <vector>

namespace {

const char* const connect_usage = R"(usage: geometric_continuity connect C.g2 C1.g2 C2.g2 [OPTIONS] -o RIBBON.g2

Makes two surfaces of degree 6 x 1 that meet with G1 continuity along the cubic
C. At both ends of C their cross derivatives are C1 - C and C2 - C and their
twists are C1' - C' and C2' - C', if these lie in the plane of C1 - C2 and C';
otherwise they are as near to that as possible. The three curves have the same
knots, with inner knots at most double. G1 is decided exactly on the result,
along the whole of C.
Exact arithmetic on numbers of thousands of digits can take long: --max-work N
allows N steps, about N nanoseconds, instead of 4000000000.
examples:
  geometric_continuity connect edge.g2 left.g2 right.g2 -o ribbon.g2
  geometric_continuity connect edge.g2 left.g2 right.g2 --bulge 1/2 \
      -o ribbon.g2
Exit code: 0 when the result is G1, 1 when it is not, e.g. because of a fold, 2
on bad input.
)";

typedef CGAL::Exact_rational FT;
typedef GC::Traits_3<CGAL::Simple_cartesian<FT>> Traits;
typedef GC::Bspline_curve<Traits> Curve;

// Reads the only curve of a file.
Curve read_curve(const std::string& name) {
  Input input(name);
  const std::vector<Curve> curves = GC::read_g2_bsplines<Traits>(input, input_name(name));
  if (curves.size() != 1)
    throw GC::Error(GC::Error_code::malformed_input,
                    input_name(name) + ": " + std::to_string(curves.size()) + " curves where one is expected");
  return curves[0];
}

int connect(const Command_line& line) {
  const Arguments files = line.files();
  const GC::G1_ribbon<Traits> ribbon =
      connect_g1(read_curve(files[0]), read_curve(files[1]), read_curve(files[2]), line.number("bulge", FT(0)));
  std::ostream& report = report_stream(line);
  report << ribbon << '\n';
  bool g1 = true;
  const std::vector<int> spans = ribbon.side1.knots_u().spans();
  const std::vector<GC::Edge_continuity<FT>> continuity = ribbon.continuity();
  for (std::size_t i = 0; i < spans.size(); ++i) {
    report << "on [" << ribbon.side1.knots_u()[spans[i]] << ", " << ribbon.side1.knots_u()[spans[i] + 1]
           << "]: " << continuity[i] << '\n';
    g1 = g1 && continuity[i].g_order >= 1;
  }
  report << (g1 ? "G1 along the whole edge, proved exactly\n" : "not G1 along the whole edge\n");
  write_shapes(line, [&](std::ostream& os) {
    GC::write_g2(os, ribbon.side1);
    GC::write_g2(os, ribbon.side2);
  });
  return g1 ? requirement_met : requirement_not_met;
}

void describe_connect(po::options_description_easy_init add) {
  add("bulge", po::value<std::string>(), "R, bends the surfaces: beta becomes quartic (default 0)");
  add("max-work", po::value<std::string>(), "the steps of work that are allowed");
  add_shape_output(add, "both surfaces");
}

int run_connect(const Command_line& line) {
  if (line.files().size() != 3) throw std::invalid_argument("connect: three files are needed; see --help");
  if (!line.has("output")) throw std::invalid_argument("connect: -o RIBBON.g2 is needed");
  check_shape_output(line);
  const GC::Work_scope each(line.work_limit());
  return within_work_limit([&] { return input_name(line.files()[0]) + ", ..."; }, [&] { return connect(line); });
}

} // namespace

const Command connect_command{"connect", connect_usage, describe_connect, run_connect};
