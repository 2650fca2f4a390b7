// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BROWSER_MODULE_MEMORY_FILE_H
#define GEOMETRIC_CONTINUITY_BROWSER_MODULE_MEMORY_FILE_H

#include <string>

// The one file that there is for the readers of the program, in memory: open() knows its name while
// this object exists. Precondition: there is no other one.
class Memory_file {
  const std::string name_;

public:
  Memory_file(std::string name, std::string bytes);
  Memory_file(const Memory_file&) = delete;
  Memory_file& operator=(const Memory_file&) = delete;
  ~Memory_file();
  const std::string& name() const { return name_; }
};

#endif // GEOMETRIC_CONTINUITY_BROWSER_MODULE_MEMORY_FILE_H
