// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/Cad_answer.h"
#include "formats/cad/model_bytes.h"
#include "formats/cad/opencascade/cad_solid.h"
#include "formats/cad/opencascade/read_model.h"
#include "formats/cad/opencascade/write_model.h"
#include "formats/cad/opencascade/write_shell.h"

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

// The program that reads STEP, IGES and BREP for `geometric_continuity`, see Cad_answer.h. A
// damaged file can lead OpenCASCADE astray: to a crash, to a loop without end, to any amount of
// memory. Then only this process ends.

namespace {

// Limits the memory to what is taken already and so many bytes more; no crash leaves a file.
void limit_memory(rlim_t bytes) {
  rlim_t pages = 0; // that are taken
  std::ifstream("/proc/self/statm") >> pages;
  rlimit limit;
  if (::getrlimit(RLIMIT_AS, &limit) == 0) {
    limit.rlim_cur = (std::min)(limit.rlim_max, pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + bytes);
    ::setrlimit(RLIMIT_AS, &limit);
  }
  limit = {0, 0};
  ::setrlimit(RLIMIT_CORE, &limit);
}

// Ends this process when the other end of its standard input is closed: whoever asked is no longer
// there.
void end_with_parent() {
  std::thread([] {
    char c;
    while (::read(STDIN_FILENO, &c, 1) > 0) {
    }
    ::_exit(EXIT_FAILURE);
  }).detach();
}

// Takes the standard output for the answer: what others write there is lost.
int answer_descriptor() {
  const int result = ::dup(STDOUT_FILENO), nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  return result;
}

void write(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0) ::_exit(EXIT_FAILURE); // there is nobody to whom it could be told
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

Cad_model read(const std::string& name, const Cad_reading& reading) {
  Shape_of_file file = read_shape(name, reading);
  const std::size_t sewn = reading.sewing ? sew(file, *reading.sewing) : 0;
  Cad_model model = cad_model(file.shape, reading);
  add_labels(file.shape, file.labels, model);
  model.lost = std::move(file.lost);
  model.open_shells = open_shells(file.closed_shells);
  model.sewn = sewn;
  return model;
}

bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
}

Shell_model read_shell(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string bytes = text.str();
  Byte_reader reader(bytes);
  Shell_model shell;
  reader(shell);
  return shell;
}

// Writes the answer, and ends the process without giving back what it holds.
[[noreturn]] void answer(int descriptor, Cad_answer answer, std::string_view text) {
  write(descriptor, cad_build);
  write(descriptor, std::string(1, static_cast<char>(answer)));
  write(descriptor, text);
  ::_exit(EXIT_SUCCESS);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "geometric_continuity_cad: reads and writes CAD models for geometric_continuity\n";
    return EXIT_FAILURE;
  }
  const int descriptor = answer_descriptor();
  end_with_parent();
  limit_memory(std::strtoull(argv[3], nullptr, 10));
  try {
    if (has_ending(argv[1], ".shapes")) {
      write_model(argv[1], argv[2]);
      answer(descriptor, Cad_answer::model, "");
    }
    if (has_ending(argv[1], ".shell")) {
      write_shell(read_shell(argv[1]), argv[2]);
      answer(descriptor, Cad_answer::model, "");
    }
    Byte_writer bytes;
    if (argv[2] == std::string_view("solid")) {
      bytes(cad_solid(read_shape(argv[1], Cad_reading())));
      answer(descriptor, Cad_answer::model, bytes.bytes());
    }
    Cad_reading reading;
    const std::string request = from_hexadecimal(argv[2]);
    Byte_reader bytes_of_request(request);
    bytes_of_request(reading);
    bytes(read(argv[1], reading));
    answer(descriptor, Cad_answer::model, bytes.bytes());
  } catch (const Standard_OutOfMemory&) {
    answer(descriptor, Cad_answer::no_memory, "");
  } catch (const std::bad_alloc&) {
    answer(descriptor, Cad_answer::no_memory, "");
  } catch (const Standard_Failure& e) {
    const char* const text = e.GetMessageString();
    answer(descriptor, Cad_answer::bad_file,
           std::string("OpenCASCADE: ") + e.DynamicType()->Name() +
               (text == nullptr || *text == '\0' ? "" : std::string(": ") + text));
  } catch (const std::exception& e) {
    answer(descriptor, Cad_answer::bad_file, e.what());
  }
}
