// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_OPENDRIVE_READ_OPENDRIVE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_OPENDRIVE_READ_OPENDRIVE_H

#include <CGAL/Geometric_continuity/models/Road_network.h>

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

// The roads of a file in ASAM OpenDRIVE.
struct Opendrive_file {
  GC::Road_network network;
  std::string root; // the name of the root element
  int digits = 0;   // the most significant digits of a coordinate or a heading of its geometries
  // Attributes of the revision that are no numbers, with their values.
  std::vector<std::pair<std::string, std::string>> odd_revision;
  long long header_line = 0;
  // The places of a geometry in the text, in bytes: of its first tag, of its shape, and its end.
  struct Geometry_text {
    std::size_t begin, tag_end, shape_begin, shape_end, end;
  };
  std::vector<std::vector<Geometry_text>> texts; // in the order of the roads and of the file
};

// Reads a road network, of the versions 1.4 to 1.8; the text may be packed by gzip. Each number is
// the decimal that is written, exactly. Elements are known by their names, in any namespace or
// none, and those that say nothing of the shape of roads are left out.
//
// Throws GC::Error with file, line and reason: `malformed_input` for what is not well-formed, for
// another root element than OpenDRIVE without a road in it, for a number that is missing or none,
// for lengths below 0, and for geometries without exactly one shape; `cannot_read_file` with the
// reason of the system.
Opendrive_file read_opendrive(const std::string& file);
Opendrive_file read_opendrive(std::istream& stream, const std::string& name);

// Returns whether a text begins as a file in OpenDRIVE does.
bool begins_as_opendrive(std::string_view text);

// Returns whether a file is in OpenDRIVE: by its name, or by how it begins.
bool is_road_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_OPENDRIVE_READ_OPENDRIVE_H
