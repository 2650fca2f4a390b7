// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/input.h"
#include "formats/svg/Unpacked_bytes.h"
#include "formats/svg/svg_drawing.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

namespace {

// What the file begins with, without a byte order mark and the zeros of UTF-16. Of pipes only standard input is looked
// into, because others cannot be opened twice.
std::string beginning(const std::string& file) {
  std::error_code error;
  if (!is_standard_input(file) && !std::filesystem::is_regular_file(file, error)) return "";
  std::string text(Input(file).beginning(256));
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\0' || (c & 0x80) != 0; }), text.end());
  return text;
}

} // namespace

bool is_svg_file(const std::string& file) {
  std::string extension = file.substr((std::min)(file.rfind('.'), file.size()));
  for (char& c : extension)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (extension == ".svg" || extension == ".svgz") return true;
  const std::string text = beginning(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && (text[first] == '<' || Unpacked_bytes::may_begin(text[0]));
}
