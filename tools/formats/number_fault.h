// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_NUMBER_FAULT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_NUMBER_FAULT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <string>

// Why a text is not read as a number, e.g. "not a number" or "decimal exponent beyond 4096": what
// parse_number() has thrown, without the code of the error and the text.
inline std::string number_fault(const CGAL::Geometric_continuity::Error& error) {
  const std::string what = error.what();
  const std::size_t begin = to_string(error.code()).size() + 2, end = what.find(": '", begin);
  return what.substr(begin, end == std::string::npos ? end : end - begin);
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_NUMBER_FAULT_H
