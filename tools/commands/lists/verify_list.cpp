// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/lists/verify_list.h"

#include "commands/chains/join_report.h"
#include "commands/lists/File_record.h"
#include "commands/tolerances.h"
#include "files/Child_process.h"
#include "files/atomic_file.h"
#include "files/input.h"
#include "files/output.h"
#include "files/progress.h"
#include "formats/cad/cad_file.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <sys/file.h>

namespace {

namespace GC = CGAL::Geometric_continuity;

// The file to which records are added, and which nobody else writes meanwhile.
class Record_file {
  const std::string name_;
  int descriptor_ = STDOUT_FILENO;
  std::unordered_map<std::string, File_record> records_; // the last one of each name

  void open() {
    descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_APPEND | O_NOCTTY, 0666);
    if (descriptor_ < 0) GC::refuse_to_write(name_, errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw std::invalid_argument(name_ + ": another process writes records there");
  }

  Read_records read() {
    std::ifstream is(name_, std::ios::binary);
    std::vector<std::size_t> corrupt;
    const Read_records read = for_each_record(
        is, [&](const File_record& r, const std::string&, std::size_t) { records_.insert_or_assign(r.name, r); },
        [&](std::size_t number) { corrupt.push_back(number); });
    if (read.corrupt > 0 && read.records == 0) // a file of something else
      throw GC::Error(GC::Error_code::malformed_input,
                      name_ + ':' + std::to_string(corrupt[0]) +
                          ": no record, as verify --jsonl writes them, nor is any other line");
    Corrupt_lines say("verify", name_, "it is left out, and what has no other record is asked again");
    for (const std::size_t number : corrupt) say(number);
    return read;
  }

  // Leaves the lines out that are no records.
  void rewrite() {
    GC::write_file_atomically(name_, [&](std::ostream& os) {
      std::ifstream is(name_, std::ios::binary);
      for_each_record(
          is, [&](const File_record&, const std::string& line, std::size_t) { os << line << '\n'; },
          [](std::size_t) {});
    });
    ::close(std::exchange(descriptor_, STDOUT_FILENO));
    open();
  }

public:
  explicit Record_file(const std::string& name) : name_(name) {
    if (is_standard_output(name)) return;
    open();
    try {
      if (!std::filesystem::is_regular_file(name)) return;
      const Read_records records = read();
      if (records.corrupt > 0)
        rewrite();
      else if (::ftruncate(descriptor_, static_cast<off_t>(records.size)) != 0)
        GC::refuse_to_write(name, errno);
    } catch (...) {
      close();
      throw;
    }
  }
  Record_file(const Record_file&) = delete;
  Record_file& operator=(const Record_file&) = delete;
  ~Record_file() { close(); }

  // The exit code of a file that has a record which answers the question.
  std::optional<int> code(const std::string& file, const File_question& question, const File_state& state,
                          const File_limits& limits) const {
    const auto entry = records_.find(file);
    if (entry == records_.end() || !entry->second.answers(question, state, limits)) return std::nullopt;
    return entry->second.exit_code;
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

private:
  void close() const {
    if (descriptor_ != STDOUT_FILENO) ::close(descriptor_);
  }
};

// Returns the value of an option in one form for all texts with the same meaning. Numbers become
// fractions, presets of tolerances become their bounds, and files become their hashes.
std::string normal_value(const std::string& name, const std::string& value) {
  if (name == "require") return Requirement(value).text();
  if (name == "baseline") {
    const File_state state(value);
    if (state.sha256 == "null") throw std::invalid_argument("--baseline: " + value + " is no file that can be read");
    return "sha256:" + state.sha256.substr(1, 64);
  }
  const auto fraction = [](const Exact& x) {
    std::ostringstream os;
    GC::write_number(os, x);
    return os.str();
  };
  if (name != "within") try {
      return fraction(GC::parse_number<Exact>(value));
    } catch (const std::exception&) {
      return value; // which each file refuses
    }
  std::string text;
  for (const tolerances::Item& item : tolerances::items(tolerances::bounds_of(value)))
    text += (text.empty() ? "" : ",") + fraction(item.number()) + item.unit();
  return text;
}

// The options that are not as they are without being given, in the order of their names.
File_question question_of(const Arguments& options) {
  static const std::set<std::string> of_one_form = {"require",  "baseline", "within", "kink-angle",
                                                    "max-kink", "off-by",   "sew",    "max-work"},
                                     defaults = {"--kink-angle=5", "--off-by=1", "--max-order=3", "--worst=10",
                                                 "--kernel=exact"};
  File_question question{{}, GEOMETRIC_CONTINUITY_VERSION};
  for (const std::string& option : options) {
    std::string text = option;
    const std::size_t equals = option.find('=');
    if (equals != std::string::npos && of_one_form.count(option.substr(2, equals - 2)) != 0)
      text = option.substr(0, equals + 1) + normal_value(option.substr(2, equals - 2), option.substr(equals + 1));
    if (defaults.count(text) == 0) question.options.push_back(GC::printable(text));
  }
  return question;
}

// The question for a file, and the previous record of it.
struct Asked_file {
  const std::string& name;
  const List_demand& demand;
  const File_question& asked;
  const File_state& state;

  std::string answer(int exit_code, const std::string& members) const {
    return '{' + File_record::json_name(name) + ",\"exit_code\":" + std::to_string(exit_code) + ',' + members;
  }

  // Returns the question of the answer, which precedes the report.
  std::string question() const {
    return ',' + asked.json() + ",\"size\":" + state.size + ",\"sha256\":" + state.sha256;
  }

  std::string error(const std::string& code, const std::string& message) const {
    return answer(bad_input, "\"error\":{\"code\":" + json_text(code) + ",\"message\":" + json_text(message) + "}," +
                                 demand.limits().json() + question() + '}');
  }

  // The record of the messages of a process that gives no answer: the code of an Error, and the
  // last message.
  std::string error(const std::string& errors) const {
    const std::string program = "geometric_continuity: ";
    std::string message = errors.substr(0, errors.find_last_not_of("\n") + 1);
    message = message.substr(message.rfind('\n') + 1);
    if (message.compare(0, program.size(), program) == 0) message = message.substr(program.size());
    const std::string word = message.substr(0, message.find(": "));
    const bool is_code = word.size() < message.size() && word.find('_') != std::string::npos &&
                         word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
    return is_code ? error(word, message.substr(word.size() + 2)) : error("bad_input", message);
  }
};

// Verifies one file in a process of its own.
std::string record_of(const std::string& file, const File_state& state, const List_demand& demand,
                      const File_question& question) {
  static const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const Asked_file asked{file, demand, question, state};
  std::vector<std::string> command{program, "verify", "--json"};
  command.insert(command.end(), demand.options.begin(), demand.options.end());
  if (cad_format(file)) command.push_back("--time-limit=" + rounded(demand.seconds, 17));
  command.push_back(file[0] == '-' ? "./" + file : file);
  constexpr std::uint64_t most_output = std::uint64_t(1) << 30;
  Process_end end;
  try {
    end = Child_process(std::move(command), {demand.seconds, most_output, demand.memory}, true).wait();
  } catch (const std::system_error& e) {
    return asked.error("no_process", e.what());
  }
  if (end.took_too_long()) return asked.error("time_limit", "not decided " + end.time_words(demand.seconds));
  if (end.wrote_too_much) return asked.error("output_limit", "the record is longer than 1 GiB");
  if (!WIFEXITED(end.status))
    return asked.error("crash", "the process was ended by the signal " + std::to_string(WTERMSIG(end.status)));
  const int code = WEXITSTATUS(end.status);
  if (code != requirement_met && code != requirement_not_met) return asked.error(end.errors);
  std::string& report = end.output;
  // none is inside of a string
  report.erase(std::remove(report.begin(), report.end(), '\n'), report.end());
  Claim_counts claims;
  if (const std::optional<Json_view> member = Json_view::of(report).member("claims"))
    claims = Claim_counts::of(*member);
  return asked.answer(code, "\"claims\":" + claims.json() + asked.question() + ",\"report\":" + report + '}');
}

// The names of a list, each once: a line each, or each ended by a null character, as find -print0
// writes them.
std::vector<std::string> read_list(const std::string& name) {
  Input input(name);
  const std::string text{std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>()};
  const char end = text.find('\0') == std::string::npos ? '\n' : '\0';
  std::vector<std::string> files;
  std::unordered_set<std::string> known;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t size = (std::min)(text.find(end, begin), text.size()) - begin;
    std::string file = text.substr(begin, size);
    begin += size + 1;
    if (end == '\n' && !file.empty() && file.back() == '\r') file.pop_back();
    if (!file.empty() && known.insert(file).second) files.push_back(std::move(file));
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
  const File_question question = question_of(demand.options);
  Record_file records(demand.output);
  std::array<std::size_t, 3> codes{};
  std::size_t known = 0, done = 0;
  Progress progress("files");
  std::atomic<std::size_t> next{0};
  std::exception_ptr error;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < files.size();) try {
        const File_state state(files[i]);
        const std::optional<int> before = records.code(files[i], question, state, demand.limits());
        const std::string line = before ? std::string() : record_of(files[i], state, demand, question);
        const int code = before ? *before : File_record::of(line)->exit_code;
        const std::lock_guard<std::mutex> lock(mutex);
        if (error) return;
        if (before)
          ++known;
        else
          records.add(line);
        ++codes[static_cast<std::size_t>(code)];
        ++done;
        progress.step(done, [&] { return double(done) / double(files.size()); });
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (!error) error = std::current_exception();
        next = files.size();
      }
  };
  std::vector<std::thread> threads;
  const std::size_t jobs = demand.jobs > 0 ? static_cast<std::size_t>(demand.jobs) : number_of_cores();
  for (std::size_t j = 0; j < (std::min)(jobs, files.size()); ++j) threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  progress.clear();
  if (error) std::rethrow_exception(error);

  (is_standard_output(demand.output) ? std::cerr : std::cout)
      << counted(files.size(), "file") << ": " << codes[0] << " with exit code 0, " << codes[1] << " with 1, "
      << codes[2] << " without an answer; " << known << " had a record before\n";
  return codes[2] > 0 ? bad_input : codes[1] > 0 ? requirement_not_met : requirement_met;
}
