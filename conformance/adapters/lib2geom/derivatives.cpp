// SPDX-License-Identifier: CC0-1.0

// Reads path data from its argument. Prints for each path if it is closed, and for each segment
// position and derivatives at its start and at its end.
#include <2geom/path-sink.h>
#include <2geom/pathvector.h>
#include <2geom/svg-path-parser.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    for (const Geom::Path& path : Geom::parse_svg_path(argv[1])) {
      std::printf("path %d\n", path.closed() ? 1 : 0);
      for (Geom::Path::const_iterator c = path.begin(); c != path.end_default(); ++c) {
        if (c->isDegenerate()) continue;
        for (int end = 0; end < 2; ++end)
          for (const Geom::Point& d : c->pointAndDerivatives(end, 3)) std::printf("%.17g %.17g ", d.x(), d.y());
        std::printf("\n");
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
