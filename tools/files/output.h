// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_H

#include "commands/command_line.h"

#include "files/atomic_file.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

// Returns whether the name of a file stands for standard output.
inline bool is_standard_output(const std::string& name) { return name == "-" || name == "/dev/stdout"; }

// Returns whether the name is that of a device, a pipe or the like, which says nothing about the
// format.
inline bool has_no_format(const std::string& name) {
  std::error_code ignored;
  return is_standard_output(name) || std::filesystem::is_other(name, ignored);
}

// The last letters of a name, in lower case, e.g. ".svg".
inline std::string extension(const std::string& name) {
  std::string text = std::filesystem::path(name).extension().string();
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// Refuses the name that an option gives to a picture unless it ends with .svg.
inline void check_picture_name(const Command_line& line, const std::string& option) {
  const std::string name = line.text(option);
  if (!has_no_format(name) && extension(name) != ".svg")
    throw std::invalid_argument("--" + option + ": " + name + ": the picture is SVG, and the name must end with .svg");
}

// The endings of names that say what a file is.
inline const Arguments& known_endings() {
  static const Arguments endings = {
      // texts
      ".g2", ".json", ".jsonl", ".ndjson", ".sarif", ".xml", ".html", ".htm", ".csv", ".gcode",
      // pictures
      ".svg", ".svgz", ".pdf", ".ps", ".eps", ".ai", ".png", ".jpg", ".jpeg", ".gif",
      // meshes
      ".webp", ".bmp", ".tif", ".tiff", ".off", ".obj", ".ply", ".stl", ".gltf", ".glb",
      // models
      ".3mf", ".amf", ".wrl", ".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".dxf",
      // fonts
      ".dwg", ".fcstd", ".3dm", ".sat", ".x_t", ".ttf", ".otf", ".ttc", ".otc", ".woff",
      //
      ".woff2", ".eot", ".pfb", ".pfa", ".pfm", ".afm", ".cff", ".t1", ".dfont", ".designspace",
      // packed
      ".sfd", ".ufo", ".glif", ".glyphs", ".gz", ".bz2", ".xz", ".zst", ".zip", ".tar"};
  return endings;
}

// Refuses the name that an option gives to a file when it says that this is something else than
// what is written, which has the first one of these endings, or another one of them. `hint` tells
// how to get the other format.
inline void check_output_name(const Command_line& line, const std::string& option, const Arguments& endings,
                              const std::string& hint = "") {
  const std::string name = line.text(option), ending = extension(name);
  if (name.empty()) throw std::invalid_argument("--" + option + ": the name is empty");
  const auto has = [&](const Arguments& list) { return std::count(list.begin(), list.end(), ending) != 0; };
  if (!has_no_format(name) && has(known_endings()) && !has(endings))
    throw std::invalid_argument("--" + option + ": " + name + ": the format is " + endings.front() + ", not " + ending +
                                hint);
}

// Returns the name of what will be written: behind all links, also those that lead to a file that
// is not there yet.
inline std::filesystem::path behind_links(std::filesystem::path path) {
  std::error_code error;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(path, error); ++links)
    // an absolute path replaces the other one
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
}

// Returns whether two names of output files lead to one file.
inline bool lead_to_one_file(const std::string& a, const std::string& b) {
  if (is_standard_output(a) || is_standard_output(b)) return is_standard_output(a) && is_standard_output(b);
  if (has_no_format(a)) return false;
  std::error_code error;
  return std::filesystem::equivalent(a, b, error) || behind_links(a) == behind_links(b);
}

// Checks the names of --plot, a picture, and --output, as far as they are given.
inline void check_outputs(const Command_line& line) {
  if (line.has("plot")) check_picture_name(line, "plot");
  if (line.has("output") && line.has("plot") && lead_to_one_file(line.text("output"), line.text("plot")))
    throw std::invalid_argument("--output and --plot: both are written to " + line.text("plot"));
}

// Where the report of a command goes: not to standard output when --output or --plot is written
// there.
inline std::ostream& report_stream(const Command_line& line) {
  return is_standard_output(line.text("output")) || is_standard_output(line.text("plot")) ? std::cerr : std::cout;
}

// Writes a file as a whole or not at all, or to standard output.
template <class Writer> void write_output(const std::string& file, Writer writer) {
  if (is_standard_output(file))
    writer(static_cast<std::ostream&>(std::cout));
  else
    CGAL::Geometric_continuity::write_file_atomically(file, writer);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_H
