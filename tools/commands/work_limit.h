// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_WORK_LIMIT_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_WORK_LIMIT_H

#include <CGAL/Geometric_continuity/Error.h>

#include <stdexcept>
#include <string>

// Returns work(). If that is refused because it would be too much, the message names the object,
// name(), and the option.
template <class Name, class Work> auto within_work_limit(Name name, Work work) {
  try {
    return work();
  } catch (const CGAL::Geometric_continuity::Error& e) {
    if (e.code() != CGAL::Geometric_continuity::Error_code::work_limit) throw;
    throw std::runtime_error(name() + ": " + e.what() + "; --max-work N allows N steps");
  }
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_WORK_LIMIT_H
