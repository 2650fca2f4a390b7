// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H

#include "formats/svg/Attribute_text.h"
#include "formats/svg/Svg_subpath.h"
#include "formats/svg/Svg_transform.h"
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Simple_cartesian.h>

#include <functional>
#include <istream>
#include <string>
#include <string_view>

namespace GC = CGAL::Geometric_continuity;

typedef GC::Traits_2<CGAL::Simple_cartesian<CGAL::Exact_rational>> Drawing_traits;
typedef GC::Svg_subpath<Drawing_traits> Drawing_subpath;

// Where an element of a drawing stands, for reports.
struct Drawing_element {
  std::string file, name, id; // the id may be empty
  long long line;
  // from its own coordinates to those of the drawing
  GC::Svg_transform<Drawing_traits> transform = {};
  Attribute_lines* lines = nullptr; // of the data of a path, while it is handed on
  // of the numbers of a path or a polygon as they are written, at most; otherwise -1
  int decimals = -1;
  bool is_filled = false;       // so that where a subpath ends at its start there is a join
  bool has_percentages = false; // so that its size depends on the viewport
  // the use elements that draw it, e.g. use "u" (line 20); empty where it stands
  std::string repeated_by = {};

  // Tells which element it is without lines, while it is handed on: by its id, otherwise from the
  // nearest element around it that has one, or from the outermost one, on, e.g. g#leaves/path[3];
  // what repeats it comes before it.
  std::function<std::string()> path = [] { return std::string(); };

  // The tag as it is written, and where it begins in the file, where paths are taken; empty in a
  // repetition.
  std::string_view tag = {};
  std::size_t tag_begin = 0;

  // Returns the name, the id, the line and what repeats it, e.g. path "leaf" (line 12), repeated by
  // use "u" (line 20).
  std::string text() const;

  // Returns the line on which a command of the path, or of a program, begins; that of the element
  // for shapes.
  long long line_of(const GC::Svg_segment<Drawing_traits>& segment) const {
    if ('0' <= segment.letter && segment.letter <= '9') return segment.command;
    return lines == nullptr ? line : (*lines)[segment.place];
  }
};

// How a path is drawn.
enum class Path_role {
  drawn,     // where it stands
  defined,   // not at all
  repeated,  // by use elements, and not where it stands
  repetition // by a use element; it is handed on in its own place, too
};

// The attribute d of a path.
struct Path_data {
  const std::string& value;
  const std::string place;   // for messages
  const Attribute_text text; // where the value stands
  const Path_role role;
};

// Receives what is found in a drawing.
class Drawing_handler {
public:
  virtual ~Drawing_handler() = default;

  // Receives a subpath of a path or of a basic shape, in the coordinates of the drawing, without
  // its segments of no length, of which there may be no other. The
  // subpaths of an element are numbered from 1 on.
  virtual void subpath(const Drawing_element& element, int number, const Drawing_subpath& subpath) = 0;

  // Receives an element that would draw something, but cannot be read, or not as a whole: what it
  // draws as far as it is read is received before it. Other elements in it are not received.
  virtual void not_read(const Drawing_element& element, const std::string& reason) = 0;

  // Returns whether path() is to receive all paths, also those that are defined and not drawn, in
  // place of the subpaths of those that are.
  virtual bool takes_paths() const { return false; }
  virtual void path(const Drawing_element&, const Path_data&) {}

  // Tells which part of the drawing has been received, from 0 to 1.
  virtual void progress(double) {}
};

// Reads all paths and basic shapes that the SVG file draws, in order; at no time more than one
// subpath is in memory besides the elements as they are written. What is defined but not drawn
// (defs, symbols, clip paths, ...) is skipped. The name "-" is standard input. The text may be
// packed by gzip, whatever the name.
//
// The coordinates are those of the outermost element svg: those of its contents, without its own
// view box. A use element draws what it refers to in the same file, and is not received itself;
// together they may repeat 16 MiB of elements, or ten times the length of the drawing. An element
// with an attribute that cannot be read, that a style sheet or an animation may change, or whose
// size is not known is not read, nor is what stands in it; of path data and points with an error
// that is what follows it.
//
// Entities are read when the file itself declares them and they expand to no more than 1 MiB, or
// ten times the length of the file; no other file is ever opened. Throws GC::Error with file, line
// and reason: `malformed_input` for what is not well-formed or no SVG, for references to other
// entities, and for elements nested deeper than 256; `work_limit` for more than 256 MiB unpacked;
// `cannot_read_file` with the reason of the system.
void read_svg_drawing(const std::string& file, Drawing_handler& handler);

// Reads a drawing from a stream; the name is used in messages.
void read_svg_drawing(std::istream& stream, const std::string& name, Drawing_handler& handler);

// Returns whether a file is an SVG drawing: by its name, or because it begins like XML or is packed
// by gzip.
bool is_svg_file(const std::string& file);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_DRAWING_H
