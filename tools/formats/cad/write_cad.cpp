// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/write_cad.h"

#include "formats/cad/model_bytes.h"
#include "formats/cad/read_cad.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace {

// A folder that is gone with its contents when this object is.
class Temporary_folder {
  std::string name_ = (std::filesystem::temp_directory_path() / "geometric_continuity_XXXXXX").string();

public:
  Temporary_folder() {
    if (::mkdtemp(name_.data()) == nullptr)
      throw std::runtime_error(name_ + ": " + std::generic_category().message(errno));
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(name_, ignored);
  }
  std::string file(const std::string& name) const { return name_ + '/' + name; }
};

// Writes the model that the other process makes of what write(os) writes to a file of this ending.
template <class Write>
void write_apart(std::ostream& os, const char* given_ending, const std::string& ending, const Write& write) {
  const Temporary_folder folder;
  const std::string given = folder.file(std::string("model") + given_ending), model = folder.file("model" + ending);
  {
    std::ofstream file(given, std::ios::binary);
    write(file);
    if (!file.flush()) throw std::runtime_error(given + ": " + std::generic_category().message(errno));
  }
  make_cad_model(given, model);
  os << std::ifstream(model, std::ios::binary).rdbuf();
}

} // namespace

void write_cad(std::ostream& os, const std::vector<Spline_numbers>& shapes, const std::string& ending) {
  write_apart(os, ".shapes", ending, [&](std::ostream& file) {
    for (const Spline_numbers& shape : shapes) shape.write(file);
  });
}

void write_cad(std::ostream& os, const Shell_model& shell, const std::string& ending) {
  Byte_writer bytes;
  bytes(shell);
  write_apart(os, ".shell", ending, [&](std::ostream& file) { file << bytes.bytes(); });
}
