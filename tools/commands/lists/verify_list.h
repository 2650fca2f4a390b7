// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_VERIFY_LIST_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_VERIFY_LIST_H

#include "commands/commands.h"
#include "commands/lists/File_record.h"

#include <cstdint>
#include <string>

// The demands on many files, each of which is verified by a process of its own.
struct List_demand {
  std::string list, output; // the names of files, and where their records are written
  Arguments options;        // of `verify`
  double seconds;           // of processor time that a file may take
  std::uint64_t memory;     // in bytes, that it may take
  int jobs;                 // files at a time; 0: as many as there are cores

  File_limits limits() const { return {seconds, static_cast<double>(memory) / 1048576}; }
};

// Runs `verify --jsonl`: writes one record for each file as it ends, but for those that have one
// which answers the same question about the same content, and returns the exit code of the worst.
int verify_list(const List_demand& demand);

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_VERIFY_LIST_H
