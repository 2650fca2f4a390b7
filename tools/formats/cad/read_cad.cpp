// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/read_cad.h"

#include "files/Child_process.h"
#include "files/input.h"
#include "formats/cad/Cad_answer.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/model_bytes.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

// The memory that the reader of a file may take: enough for each entity of a text.
std::uint64_t memory_for(const std::string& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return (std::uint64_t(2) << 30) + (error ? 0 : 256 * static_cast<std::uint64_t>(size));
}

// The program that reads, next to this one or where it is installed.
std::string reader_program() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* const place : {"", GEOMETRIC_CONTINUITY_CAD_FOLDER}) {
    const std::filesystem::path program = folder / place / "geometric_continuity_cad";
    if (::access(program.c_str(), X_OK) == 0) return program;
  }
  throw std::runtime_error(
      "STEP, IGES and BREP are read and written by an optional part of this program, which is not there: "
      "install the package geometric-continuity-cad, or libocct-data-exchange-dev and build the "
      "program again");
}

// Returns all that the process writes which reads a file. Throws std::runtime_error when it takes
// longer or writes more than is allowed, or crashes.
std::string answer(std::vector<std::string> command, double seconds, std::uint64_t most) {
  const Process_end end = Child_process(std::move(command), {seconds, most}, false).wait();
  if (end.took_too_long())
    throw std::runtime_error("not read " + end.time_words(seconds) + ": the file is damaged or large");
  if (end.wrote_too_much) throw std::runtime_error("the library that reads it does not end: the file is damaged");
  if (WIFSIGNALED(end.status)) throw std::runtime_error("the library that reads it crashes: the file is damaged");
  return end.output;
}

// The text behind the build and the kind of an answer. Throws std::runtime_error with the reason
// for which there is none.
std::string_view content(const std::string& answer, std::uint64_t memory) {
  const std::size_t begin = cad_build.size();
  if (answer.size() <= begin) throw std::runtime_error("the library that reads it fails: the file is damaged");
  if (answer.compare(0, begin, cad_build) != 0)
    throw std::runtime_error("the program and its part that reads CAD models are not of one build");
  const std::string_view text = std::string_view(answer).substr(begin + 1);
  switch (static_cast<Cad_answer>(answer[begin])) {
  case Cad_answer::model: return text;
  case Cad_answer::no_memory:
    throw std::runtime_error("not read with " + std::to_string(memory >> 20) +
                             " MB of memory, which are allowed for a file of this size: it is damaged");
  case Cad_answer::bad_file: break;
  }
  throw std::runtime_error(std::string(text));
}

// Reads what the process answers that reads a file in this way. Throws std::runtime_error with the
// name of the file and the reason.
template <class Answer> Answer read_apart(const std::string& file, const std::string& reading, double seconds) {
  Input(file).beginning(1); // tells why it cannot be read
  try {
    const std::uint64_t memory = memory_for(file);
    const std::string answer = ::answer({reader_program(), file, reading, std::to_string(memory)}, seconds, memory);
    Answer result;
    Byte_reader bytes(content(answer, memory));
    bytes(result);
    if (!bytes.is_at_end()) throw std::runtime_error("damaged bytes of a model");
    return result;
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
}

} // namespace

bool are_cad_files(const Arguments& files) {
  const auto number = std::count_if(files.begin(), files.end(), cad_format);
  if (number != 0 && number != static_cast<std::ptrdiff_t>(files.size()))
    throw std::invalid_argument("CAD models (STEP, IGES, BREP) and other files cannot be read together");
  return number != 0;
}

Cad_model read_cad(const std::string& file, const Cad_reading& reading) {
  Byte_writer request;
  request(reading);
  return read_apart<Cad_model>(file, hexadecimal(request.bytes()), reading.time_limit);
}

Cad_solid read_cad_solid(const std::string& file) {
  return read_apart<Cad_solid>(file, "solid", Cad_reading().time_limit);
}

void make_cad_model(const std::string& given, const std::string& model) {
  const std::uint64_t memory = memory_for(given);
  content(answer({reader_program(), given, model, std::to_string(memory)}, 600, memory), memory);
}
