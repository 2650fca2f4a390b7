// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_FILE_H

#include <cstddef>
#include <optional>
#include <string>

// The formats of CAD models, which the extensions of files tell.
enum class Cad_format { step, iges, brep };

// Returns the format of a CAD file, or nothing for other files.
inline std::optional<Cad_format> cad_format(const std::string& file) {
  const std::size_t dot = file.rfind('.');
  std::string extension = dot == std::string::npos ? "" : file.substr(dot);
  for (char& c : extension)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".step" || extension == ".stp") return Cad_format::step;
  if (extension == ".iges" || extension == ".igs") return Cad_format::iges;
  if (extension == ".brep" || extension == ".brp") return Cad_format::brep;
  return std::nullopt;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_CAD_FILE_H
