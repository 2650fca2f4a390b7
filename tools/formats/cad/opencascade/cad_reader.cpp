// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/cad_reader.h"
#include "formats/cad/opencascade/read_model.h"

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

void geometric_continuity_read_cad(const std::string& file, const Cad_reading& reading, Cad_model& model) {
  const Silent_output silence;
  try {
    std::vector<std::string> lost;
    TopoDS_Shape shape = read_shape(file, lost);
    const std::size_t sewn = reading.sewing ? sew(shape, *reading.sewing, lost) : 0;
    model = cad_model(shape, reading);
    model.lost = std::move(lost);
    model.sewn = sewn;
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& e) {
    const char* const text = e.GetMessageString();
    throw std::runtime_error(std::string("OpenCASCADE: ") + e.DynamicType()->Name() +
                             (text == nullptr || *text == '\0' ? "" : std::string(": ") + text));
  }
}
