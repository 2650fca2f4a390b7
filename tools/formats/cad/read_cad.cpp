// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/cad/read_cad.h"

#include "files/input.h"
#include "formats/cad/Cad_answer.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/model_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
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
  throw std::runtime_error("STEP, IGES and BREP are read by an optional part of this program, which is not there: "
                           "install libocct-data-exchange-dev and build the program again");
}

// Both ends of a pipe, which no other program inherits.
class Pipe {
  std::array<int, 2> ends_;

public:
  Pipe() {
    if (::pipe(ends_.data()) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    for (const int end : ends_) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close(0);
    close(1);
  }
  int operator[](std::size_t i) const { return ends_[i]; }
  void close(std::size_t i) {
    if (ends_[i] >= 0) ::close(ends_[i]);
    ends_[i] = -1;
  }
};

// The process that reads a file. It ends at the latest with this object, or with this program, however that ends.
class Reader_process {
  Pipe life_, answer_;
  pid_t process_ = -1;

  // Returns how it has ended, as waitpid() does; nothing if it goes on.
  std::optional<int> end(int options) {
    int status = 0;
    pid_t ended;
    while ((ended = ::waitpid(process_, &status, options)) < 0 && errno == EINTR) {
    }
    if (ended == 0) return std::nullopt;
    process_ = -1;
    return status;
  }

public:
  explicit Reader_process(std::vector<std::string> command) {
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, life_[0], STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, answer_[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int error = ::posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::system_error(error, std::generic_category(), command[0]);
    life_.close(0);
    answer_.close(1);
  }
  Reader_process(const Reader_process&) = delete;
  Reader_process& operator=(const Reader_process&) = delete;
  ~Reader_process() {
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    end(0);
  }

  // Returns all that it writes. Throws std::runtime_error when it takes longer or writes more than is allowed, or crashes.
  std::string answer(double seconds, std::uint64_t most) {
    typedef std::chrono::steady_clock Clock;
    const Clock::time_point begin = Clock::now();
    const auto check_time = [&] { // returns what is left
      const double left = seconds - std::chrono::duration<double>(Clock::now() - begin).count();
      if (left > 0) return left;
      std::ostringstream os;
      os << "not read within " << seconds << " seconds, the limit of --time-limit: the file is damaged or large";
      throw std::runtime_error(os.str());
    };
    std::string text;
    for (std::vector<char> buffer(std::size_t(1) << 16);;) {
      pollfd waiting{answer_[0], POLLIN, 0};
      if (::poll(&waiting, 1, static_cast<int>(std::ceil(1000 * check_time()))) <= 0) continue;
      const ssize_t n = ::read(answer_[0], buffer.data(), buffer.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(n));
      if (text.size() > most) throw std::runtime_error("the library that reads it does not end: the file is damaged");
    }
    std::optional<int> status;
    while (!(status = end(WNOHANG)))
      std::this_thread::sleep_for(std::chrono::duration<double>((std::min)(check_time(), 1e-3)));
    if (WIFSIGNALED(*status)) throw std::runtime_error("the library that reads it crashes: the file is damaged");
    return text;
  }
};

// Reads a file in a process of its own. Throws std::runtime_error with the reason, without the name of the file.
Cad_model read_apart(const std::string& file, const Cad_reading& reading) {
  const std::uint64_t memory = memory_for(file);
  Byte_writer request;
  request(reading);
  const std::string answer =
      Reader_process({reader_program(), file, hexadecimal(request.bytes()), std::to_string(memory)})
          .answer(reading.time_limit, memory);
  const std::size_t begin = cad_build.size();
  if (answer.size() <= begin) throw std::runtime_error("the library that reads it fails: the file is damaged");
  if (answer.compare(0, begin, cad_build) != 0)
    throw std::runtime_error("the program and its part that reads CAD models are not of one build");
  const std::string_view text = std::string_view(answer).substr(begin + 1);
  switch (static_cast<Cad_answer>(answer[begin])) {
  case Cad_answer::model: {
    Cad_model model;
    Byte_reader bytes(text);
    bytes(model);
    if (!bytes.is_at_end()) throw std::runtime_error("damaged bytes of a model");
    return model;
  }
  case Cad_answer::no_memory:
    throw std::runtime_error("not read with " + std::to_string(memory >> 20) +
                             " MB of memory, which are allowed for a file of this size: it is damaged");
  case Cad_answer::bad_file: break;
  }
  throw std::runtime_error(std::string(text));
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
  try {
    return read_apart(file, reading);
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
}
