// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Calls a fuzz target with each file that is named, and each file of each folder. Usage:
// replay_NAME FILE_OR_FOLDER...

#include "fuzz_target.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char* argv[]) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : std::vector<std::string>(argv + 1, argv + argc))
    if (std::filesystem::is_directory(name))
      for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(name))
        files.push_back(entry.path());
    else
      files.push_back(name);
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& file : files) {
    std::cout << file.string() << std::endl; // before a target ends the process
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) {
      std::cerr << file.string() << ": cannot be read\n";
      return 1;
    }
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  }
  std::cout << files.size() << " inputs\n";
  return files.empty() ? 1 : 0;
}
