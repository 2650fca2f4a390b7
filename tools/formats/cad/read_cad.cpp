// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/read_cad.h"

#include "files/input.h"
#include "formats/cad/Crash_guard.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/cad_reader.h"

#include <algorithm>
#include <stdexcept>

#include <dlfcn.h>

namespace {

// The function of the module. With its libraries the module takes longer to load than most other work of the program.
decltype(&geometric_continuity_read_cad) load_reader(const std::string& file) {
  void* const module = ::dlopen("geometric_continuity_cad.so", RTLD_NOW | RTLD_LOCAL);
  void* const reader = module == nullptr ? nullptr : ::dlsym(module, "geometric_continuity_read_cad");
  if (reader == nullptr) {
    const char* const reason = ::dlerror();
    throw std::runtime_error(
        file + ": STEP, IGES and BREP are read by an optional part of this program, which is not there: " +
        "install libocct-data-exchange-dev and build the program again (" + (reason == nullptr ? "" : reason) + ')');
  }
  return reinterpret_cast<decltype(&geometric_continuity_read_cad)>(reader);
}

} // namespace

bool are_cad_files(const Arguments& files) {
  const auto number = std::count_if(files.begin(), files.end(), cad_format);
  if (number != 0 && number != static_cast<std::ptrdiff_t>(files.size()))
    throw std::invalid_argument("CAD models (STEP, IGES, BREP) and other files cannot be read together");
  return number != 0;
}

Cad_model read_cad(const std::string& file, const Cad_reading& reading) {
  Input(file).beginning(1); // tells why it cannot be read
  const auto read = load_reader(file);
  const Crash_guard guard(file);
  Cad_model model;
  try {
    read(file, reading, model);
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
  return model;
}
