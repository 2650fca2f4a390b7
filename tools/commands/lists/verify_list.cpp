// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/lists/verify_list.h"

#include "commands/lists/File_record.h"
#include "files/Child_process.h"
#include "files/atomic_file.h"
#include "files/input.h"
#include "files/output.h"
#include "files/progress.h"
#include "formats/cad/cad_file.h"
#include "reports/words.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include <sys/file.h>

namespace {

namespace GC = CGAL::Geometric_continuity;

// The file to which records are added, and which nobody else writes meanwhile.
class Record_file {
  const std::string name_;
  int descriptor_ = STDOUT_FILENO;
  std::unordered_map<std::string, int> codes_; // of the files that have a record

public:
  explicit Record_file(const std::string& name) : name_(name) {
    if (is_standard_output(name)) return;
    descriptor_ = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND | O_NOCTTY, 0666);
    if (descriptor_ < 0) GC::refuse_to_write(name, errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw std::invalid_argument(name + ": another process writes records there");
    if (!std::filesystem::is_regular_file(name)) return;
    std::ifstream is(name, std::ios::binary);
    const Read_records read =
        for_each_record(is, name, [&](const File_record& r, const std::string&) { codes_[r.file] = r.exit_code; });
    if (::ftruncate(descriptor_, static_cast<off_t>(read.size)) != 0) GC::refuse_to_write(name, errno);
  }
  Record_file(const Record_file&) = delete;
  Record_file& operator=(const Record_file&) = delete;
  ~Record_file() {
    if (descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  }

  // The exit code of a file that has a record.
  std::optional<int> code(const std::string& json_name) const {
    const auto entry = codes_.find(json_name);
    return entry == codes_.end() ? std::nullopt : std::optional<int>(entry->second);
  }

  void add(const std::string& line) {
    const std::string text = line + '\n';
    for (std::size_t i = 0; i < text.size();) {
      const ssize_t n = ::write(descriptor_, text.data() + i, text.size() - i);
      if (n >= 0)
        i += static_cast<std::size_t>(n);
      else if (errno != EINTR)
        GC::refuse_to_write(name_, errno);
    }
  }
};

std::string error_record(const std::string& json_name, const std::string& code, const std::string& message) {
  return "{\"file\":" + json_name + ",\"exit_code\":2,\"error\":{\"code\":" + json_text(code) +
         ",\"message\":" + json_text(message) + "}}";
}

// The record of the messages of a process that gives no answer: the code of an Error, and the last message.
std::string error_record(const std::string& json_name, const std::string& errors) {
  const std::string name = "geometric_continuity: ";
  std::string message = errors.substr(0, errors.find_last_not_of("\n") + 1);
  message = message.substr(message.rfind('\n') + 1);
  if (message.compare(0, name.size(), name) == 0) message = message.substr(name.size());
  const std::string word = message.substr(0, message.find(": "));
  const bool is_code = word.size() < message.size() && word.find('_') != std::string::npos &&
                       word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
  return is_code ? error_record(json_name, word, message.substr(word.size() + 2))
                 : error_record(json_name, "bad_input", message);
}

// Verifies one file in a process of its own.
std::string record_of(const std::string& file, const std::string& json_name, const List_demand& demand) {
  static const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> command{program, "verify", "--json"};
  command.insert(command.end(), demand.options.begin(), demand.options.end());
  if (cad_format(file)) command.push_back("--time-limit=" + rounded(demand.seconds, 17));
  command.push_back(file[0] == '-' ? "./" + file : file);
  constexpr std::uint64_t most_output = std::uint64_t(1) << 30;
  Process_end end;
  try {
    end = Child_process(std::move(command), {demand.seconds, most_output, demand.memory}, true).wait();
  } catch (const std::system_error& e) {
    return error_record(json_name, "no_process", e.what());
  }
  if (end.took_too_long())
    return error_record(json_name, "time_limit", "not decided " + end.time_words(demand.seconds));
  if (end.wrote_too_much) return error_record(json_name, "output_limit", "the record is longer than 1 GiB");
  if (!WIFEXITED(end.status))
    return error_record(json_name, "crash",
                        "the process was ended by the signal " + std::to_string(WTERMSIG(end.status)));
  const int code = WEXITSTATUS(end.status);
  if (code != requirement_met && code != requirement_not_met) return error_record(json_name, end.errors);
  std::string& report = end.output;
  report.erase(std::remove(report.begin(), report.end(), '\n'), report.end()); // none is inside of a string
  Claim_counts claims;
  if (const std::optional<Json_view> member = Json_view::of(report).member("claims"))
    claims = Claim_counts::of(*member);
  return "{\"file\":" + json_name + ",\"exit_code\":" + std::to_string(code) + ",\"claims\":" + claims.json() +
         ",\"report\":" + report + '}';
}

// The names of a list, each once: a line each.
std::vector<std::string> read_list(const std::string& name) {
  Input input(name);
  std::vector<std::string> files;
  std::unordered_set<std::string> known;
  for (std::string line; std::getline(input, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (!line.empty() && known.insert(line).second) files.push_back(line);
  }
  return files;
}

std::size_t number_of_cores() {
  cpu_set_t cores;
  const int n = ::sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 1;
  return static_cast<std::size_t>((std::max)(n, 1));
}

} // namespace

int verify_list(const List_demand& demand) {
  const std::vector<std::string> files = read_list(demand.list);
  if (files.empty()) throw std::invalid_argument("--jsonl: " + input_name(demand.list) + " names no file");
  Record_file records(demand.output);
  std::vector<std::pair<std::string, std::string>> open; // names, and as JSON writes them
  std::array<std::size_t, 3> codes{};
  std::size_t known = 0;
  for (const std::string& file : files) {
    const std::string json_name = json_text(file);
    if (const std::optional<int> code = records.code(json_name)) {
      ++codes[static_cast<std::size_t>(*code)];
      ++known;
    } else
      open.emplace_back(file, json_name);
  }

  Progress progress("files");
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < open.size();) try {
        const std::string line = record_of(open[i].first, open[i].second, demand);
        const int code = File_record::of(line)->exit_code;
        const std::lock_guard<std::mutex> lock(mutex);
        if (error) return;
        records.add(line);
        ++codes[static_cast<std::size_t>(code)];
        ++done;
        progress.step(done, [&] { return double(done) / double(open.size()); });
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!error) error = std::current_exception();
        next = open.size();
      }
  };
  std::vector<std::thread> threads;
  const std::size_t jobs = demand.jobs > 0 ? static_cast<std::size_t>(demand.jobs) : number_of_cores();
  for (std::size_t j = 0; j < (std::min)(jobs, open.size()); ++j) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  progress.clear();
  if (error) std::rethrow_exception(error);

  (is_standard_output(demand.output) ? std::cerr : std::cout)
      << counted(files.size(), "file") << ": " << codes[0] << " with exit code 0, " << codes[1] << " with 1, "
      << codes[2] << " without an answer; " << known << " had a record before\n";
  return codes[2] > 0 ? bad_input : codes[1] > 0 ? requirement_not_met : requirement_met;
}
