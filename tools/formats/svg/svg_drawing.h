// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H

#include "formats/svg/Svg_segment.h"
#include "formats/svg/Svg_transform.h"
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits_2.h>
#include <CGAL/Simple_cartesian.h>

#include <istream>
#include <string>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Drawing_traits;
typedef GC::Svg_subpath<Drawing_traits> Drawing_subpath;

// Where an element of a drawing stands, for reports.
struct Drawing_element {
  std::string file, name, id; // the id may be empty
  long long line;
  GC::Svg_transform<Drawing_traits> transform = {}; // from its own coordinates to those of the drawing
  int decimals = -1; // of the numbers of a path or a polygon as they are written, at most; otherwise -1

  // Returns the name, the id and the line, e.g. path "leaf" (line 12).
  std::string text() const;
};

// Receives what is found in a drawing.
class Drawing_handler {
public:
  virtual ~Drawing_handler() = default;

  // Receives a subpath of a path or of a basic shape, in the coordinates of the drawing. The subpaths of an element are
  // numbered from 1 on.
  virtual void subpath(const Drawing_element& element, int number, const Drawing_subpath& subpath) = 0;

  // Receives an element that would draw something, but cannot be read.
  virtual void not_read(const Drawing_element& element, const std::string& reason) = 0;
};

// Reads all paths and basic shapes that the SVG file draws, in order; at no time more than one element and one subpath
// are in memory. What is defined but not drawn (defs, symbols, clip paths, ...) is skipped. The name "-" is standard
// input. The text may be packed by gzip, whatever the name.
//
// Entities are read when the file itself declares them and they expand to no more than 1 MiB, or ten times the length of
// the file; no other file is ever opened. Throws GC::Error with file, line and reason: `malformed_input` for what is not
// well-formed or no SVG, for references to other entities, for elements nested deeper than 256, and for errors in path
// data, transforms and lengths; `work_limit` for more than 256 MiB unpacked and for sizes that differ too much;
// `cannot_read_file` with the reason of the system.
void read_svg_drawing(const std::string& file, Drawing_handler& handler);

// Reads a drawing from a stream; the name is used in messages.
void read_svg_drawing(std::istream& stream, const std::string& name, Drawing_handler& handler);

// Returns whether a file is an SVG drawing: by its name, or because it begins like XML or is packed by gzip.
bool is_svg_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H
