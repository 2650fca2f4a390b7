// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_STATE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_STATE_H

#include "files/Sha256.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

// The state of a file, by which it is recognised. Folders, pipes and devices have none.
struct File_state {
  bool is_told = false;
  // as JSON writes them; null where there is nothing that can be read
  std::string size = "null", sha256 = "null";

  File_state() = default;
  explicit File_state(const std::string& file) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    is_told = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
    if (!std::filesystem::is_regular_file(status)) return;
    std::ifstream stream(file, std::ios::binary);
    Sha256 hash;
    std::uint64_t bytes = 0;
    std::vector<char> block(std::size_t(1) << 16);
    while (stream) {
      stream.read(block.data(), static_cast<std::streamsize>(block.size()));
      const std::size_t n = static_cast<std::size_t>(stream.gcount());
      hash.add(std::string_view(block.data(), n));
      bytes += n;
    }
    if (stream.bad() || !stream.eof()) return;
    size = std::to_string(bytes);
    sha256 = '"' + hash.finish() + '"';
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_STATE_H
