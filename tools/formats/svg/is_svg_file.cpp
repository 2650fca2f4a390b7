// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/Unpacked_bytes.h"
#include "files/input.h"
#include "formats/svg/svg_drawing.h"

#include <algorithm>
#include <string>

bool is_svg_file(const std::string& file) {
  std::string extension = file.substr((std::min)(file.rfind('.'), file.size()));
  for (char& c : extension)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".svg" || extension == ".svgz") return true;
  const std::string text = beginning_of_text(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (text[first] == '<' || Unpacked_bytes::may_begin(text[0]));
}
