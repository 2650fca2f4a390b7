// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "cad/cad_reader.h"
#include "cad/opencascade/read_model.h"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <iostream>
#include <new>
#include <stdexcept>

namespace {

// As long as it lives, what is written to std::cout is lost.
class Silent_output {
  std::streambuf* const buffer_ = std::cout.rdbuf(nullptr);

public:
  Silent_output() = default;
  Silent_output(const Silent_output&) = delete;
  Silent_output& operator=(const Silent_output&) = delete;
  ~Silent_output() { std::cout.rdbuf(buffer_); } // which clears the state
};

} // namespace

void geometric_continuity_read_cad(const std::string& file, Cad_drawing drawing, Cad_model& model) {
  const Silent_output silence;
  try {
    std::vector<std::string> lost;
    model = cad_model(read_shape(file, lost), drawing);
    model.lost = std::move(lost);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& e) {
    const char* const text = e.GetMessageString();
    throw std::runtime_error(std::string("OpenCASCADE: ") + e.DynamicType()->Name() +
                             (text == nullptr || *text == '\0' ? "" : std::string(": ") + text));
  }
}
