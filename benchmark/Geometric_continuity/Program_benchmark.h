// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_BENCHMARK_PROGRAM_BENCHMARK_H
#define GEOMETRIC_CONTINUITY_BENCHMARK_PROGRAM_BENCHMARK_H

#include "generated_files.h"
#include "measured_process.h"
#include "reading_limit.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <stdlib.h>
#include <unistd.h>

// A folder for files, which is removed with all of them.
class Temporary_folder {
  std::filesystem::path path_;

public:
  Temporary_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "benchmark_program_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) system_failure(name);
    path_ = name;
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string operator/(const char* name) const { return (path_ / name).string(); }
};

// Arguments of the program, and its goal: at most so many times the limit; on two cores, so many
// times faster than the first command of the file on one.
struct Command {
  std::vector<std::string> arguments;
  double goal;
  int cores = 1;
  int code = 0; // with which the program ends
};

// Runs a program on generated files, in turns with the reading limit, and prints what both cost,
// their ratios and the goals.
class Program_benchmark {
  static constexpr int runs = 5;
  static constexpr double memory_goal = 64; // MiB
  const Temporary_folder folder_;
  const std::string program_;
  std::ostringstream json_;

  static void print_title(const std::string& file) {
    std::cout << '\n' << file << "\n   elapsed   processor        memory        ratio         goal\n";
  }
  void print(const std::string& file, const std::string& command, const Cost& cost, const std::string& ratio,
             const std::string& goal, bool met) {
    const char* const verdict = goal.empty() ? "" : met ? "met" : "NOT MET";
    std::cout << std::fixed << std::setprecision(3) << std::setw(8) << cost.elapsed << " s" << std::setw(10)
              << cost.processor << " s" << std::setprecision(1) << std::setw(10) << cost.mebibytes << " MiB"
              << std::setw(13) << ratio << std::setw(13) << goal << "  " << std::left << std::setw(9) << verdict
              << std::right << command << std::endl;
    json_ << (json_.tellp() == 0 ? "" : ",") << "\n  {\"name\": \"program | " << file << " | " << command
          << "\", \"real_time\": " << cost.elapsed << ", \"cpu_time\": " << cost.processor
          << ", \"time_unit\": \"s\", \"mebibytes\": " << cost.mebibytes << "}";
  }
  static std::string rounded(double x, const char* unit) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << x << unit;
    return text.str();
  }
  static std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
  }

  [[noreturn]] void execute(const std::vector<std::string>& arguments) const {
    std::vector<char*> words{const_cast<char*>(program_.c_str())};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program_.c_str(), words.data());
    system_failure(program_);
  }
  // Waits for the program; when it fails, its messages are printed as well.
  Cost wait(const Measured_process& process, const std::vector<std::string>& arguments, int code = 0) const {
    try {
      return process.wait(program_ + ' ' + joined(arguments), code);
    } catch (const std::exception&) {
      std::ifstream messages(folder_ / "messages");
      for (std::string line; std::getline(messages, line);) std::cerr << line << '\n';
      throw;
    }
  }
  Cost run(const Command& command, const std::string& path, int cores, const std::string& output) const {
    std::vector<std::string> arguments = command.arguments;
    arguments.push_back(path);
    const Measured_process process([&] {
      use_cores(cores);
      write_to(output, STDOUT_FILENO);
      write_to(folder_ / "messages", STDERR_FILENO);
      execute(arguments);
    });
    return wait(process, arguments, command.code);
  }
  Cost run_limit(const std::string& path, std::int64_t numbers) const {
    const Measured_process process([&] {
      use_cores(1);
      read_numbers(path, numbers);
    });
    return process.wait("the reading limit");
  }
  void check_answer(const std::string& path, const std::string& answer) const {
    std::ifstream lines(path);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(answer, 0) == 0) return;
    throw std::runtime_error("wrong result: no line of the output begins with \"" + answer + '"');
  }

public:
  explicit Program_benchmark(const std::string& program) : program_(program) {}

  // write(stream) writes the file and returns how many numbers it has at least; the first command
  // must say the answer.
  template <class Write>
  void measure(const char* name, Write write, const std::vector<Command>& commands, const std::string& answer) {
    const std::string path = folder_ / name;
    std::ofstream os(path, std::ios::binary);
    const std::int64_t numbers = write(os);
    os.close();
    if (!os) throw std::runtime_error(path + ": cannot be written");
    print_title(name + (": " + std::to_string(std::filesystem::file_size(path)) + " bytes, ") +
                std::to_string(numbers) + " numbers");
    run(commands[0], path, 1, folder_ / "output");
    check_answer(folder_ / "output", answer);

    std::vector<Cost> costs; // of the limit, then of the commands
    for (int i = 0; i < runs; ++i) {
      std::vector<Cost> now{run_limit(path, numbers)};
      for (const Command& command : commands) now.push_back(run(command, path, command.cores, "/dev/null"));
      if (i == 0) costs = now;
      for (std::size_t k = 0; k < now.size(); ++k) costs[k] = best(costs[k], now[k]);
    }
    const Cost limit = costs[0];
    print(name, "the reading limit", limit, "1.00 x", "", true);
    for (std::size_t k = 0; k < commands.size(); ++k) {
      const Command& command = commands[k];
      const Cost& cost = costs[k + 1];
      const std::string text = joined(command.arguments);
      const double ratio = cost.processor / limit.processor, speedup = costs[1].elapsed / cost.elapsed;
      if (command.cores == 1)
        print(name, text, cost, rounded(ratio, " x"), rounded(command.goal, " x"), ratio <= command.goal);
      else
        print(name, text + ", two cores", cost, rounded(speedup, " faster"), rounded(command.goal, " faster"),
              speedup >= command.goal);
    }
    std::filesystem::remove(path);
  }

  // Many curves through a pipe, which the program cannot hold in memory.
  void measure_memory(int cubics) {
    const std::vector<std::string> arguments = {"verify", "--require", "G2", "--summary", "-"};
    int ends[2];
    if (::pipe(ends) != 0) system_failure("pipe");
    const Measured_process writer([&] {
      ::close(ends[0]);
      if (::dup2(ends[1], STDOUT_FILENO) < 0) system_failure("dup2");
      ::close(ends[1]);
      write_cubics(std::cout, cubics);
    });
    const Measured_process reader([&] {
      ::close(ends[1]);
      if (::dup2(ends[0], STDIN_FILENO) < 0) system_failure("dup2");
      ::close(ends[0]);
      write_to(folder_ / "output", STDOUT_FILENO);
      write_to(folder_ / "messages", STDERR_FILENO);
      execute(arguments);
    });
    ::close(ends[0]);
    ::close(ends[1]);
    const Cost cost = wait(reader, arguments);
    writer.wait("writing cubics");
    check_answer(folder_ / "output", std::to_string(cubics - 1) + " joins: " + std::to_string(cubics - 1) + " G2");
    print_title("a pipe: " + std::to_string(cubics) + " cubics");
    print("a pipe", joined(arguments), cost, "", rounded(memory_goal, " MiB"), cost.mebibytes < memory_goal);
  }

  void write_json(std::ostream& os) const { os << "{\"benchmarks\": [" << json_.str() << "\n]}\n"; }
};

#endif // GEOMETRIC_CONTINUITY_BENCHMARK_PROGRAM_BENCHMARK_H
