// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/lists/File_record.h"
#include "files/input.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

namespace GC = CGAL::Geometric_continuity;

const char* const merge_usage = R"(usage: geometric_continuity merge RECORDS... [OPTIONS]

Adds up the records that verify --jsonl has written, of one run or of many on
different machines: how many files met the requirement, what was given, decided
and left open in all of them, which files did not meet it or have no answer, and
what was asked. A file that has the same record twice counts once. Of several
records in one text that answer the same question, the last one counts. Records
of one file with different options, versions of the program or content are
refused. Lines that are no records, and a last line that an interruption has cut
off, are left out and reported.

example:
  geometric_continuity merge part-*.jsonl

Exit code: that of the worst file, 0, 1 or 2 (no answer), and 2 on bad input,
when a line is cut off or no record, and when there is no record.
)";

void describe_merge(po::options_description_easy_init add) { add("json", "print the sums as JSON"); }

// A record and where it stands.
struct Placed_record {
  File_record record;
  std::size_t hash; // of its line
  const std::string* file;
  std::size_t line;

  std::string place() const { return input_name(*file) + ':' + std::to_string(line); }
};

typedef std::shared_ptr<const File_question> Question;

std::string question_words(const Question& question) {
  if (!question) return "a question that is not told";
  std::string text;
  for (const std::string& option : question->options) text += (text.empty() ? "" : " ") + option;
  return text.empty() ? "no options" : text;
}

// A name for people, with its bytes where it is no UTF-8.
std::string shown_name(const File_record& record) {
  const std::string bytes = File_record::json_name(record.name), name = json_text(record.name);
  const std::size_t hex = bytes.find(",\"name_bytes\":");
  return hex == std::string::npos ? name : name + " (bytes " + bytes.substr(hex + 15, bytes.size() - hex - 16) + ')';
}

// Two records of a file do not go together: says why.
[[noreturn]] void refuse_both(const Placed_record& x, const Placed_record& y) {
  const std::string both = " (" + x.place() + ") and ", end = " (" + y.place() + ')';
  const Question &a = x.record.question, &b = y.record.question;
  std::string reason;
  if (!a != !b || (a && a->options != b->options))
    reason = "asked were " + question_words(a) + both + question_words(b) + end + "; add up each question for itself";
  else if (a && a->version != b->version)
    reason = "they are of the versions " + a->version + both + b->version + end + "; verify --jsonl asks again";
  else if (x.record.sha256 != y.record.sha256)
    reason = "the file has changed, its sha256 is " + x.record.sha256 + both + y.record.sha256 + end +
             "; verify --jsonl asks again";
  else
    reason = "they differ, see " + x.place() + " and " + y.place();
  throw GC::Error(GC::Error_code::malformed_input,
                  y.place() + ": another record of the file " + shown_name(y.record) + ": " + reason);
}

// The records of one text, in order; the last one of each file.
class Records_of_text {
  std::vector<Placed_record> records_;
  std::unordered_map<std::string, std::size_t> numbers_;

public:
  std::size_t corrupt = 0;
  bool is_cut_off = false;

  // The name must live as long as its records.
  explicit Records_of_text(const std::string& file) {
    Input input(file);
    Corrupt_lines say("merge", input_name(file), "it is left out");
    const Read_records read = for_each_record(
        input,
        [&](const File_record& record, const std::string& line, std::size_t number) {
          add({record, std::hash<std::string>()(line), &file, number});
        },
        [&](std::size_t number) { say(number); });
    corrupt = read.corrupt;
    is_cut_off = read.is_cut_off;
  }

  std::vector<Placed_record>& records() { return records_; }

private:
  void add(Placed_record record) {
    const auto [entry, is_new] = numbers_.emplace(record.record.name, records_.size());
    if (is_new) return records_.push_back(std::move(record));
    Placed_record& before = records_[entry->second];
    const Question &a = before.record.question, &b = record.record.question;
    if (a && b && a->options != b->options) refuse_both(before, record);
    before = std::move(record); // it was asked again
  }
};

int run_merge(const Command_line& line) {
  const Arguments files = line.files();
  if (files.empty()) throw std::invalid_argument("merge: no file is given; see --help");
  std::unordered_map<std::string, Placed_record> known;
  std::array<std::size_t, 3> codes{};
  Claim_counts claims;
  std::vector<File_record> failing;
  std::vector<Question> questions; // different ones
  std::size_t cut_off = 0, corrupt = 0;
  for (const std::string& name : files) {
    Records_of_text text(name);
    for (Placed_record& placed : text.records()) {
      const auto [entry, is_new] = known.try_emplace(placed.record.name, std::move(placed));
      if (!is_new) {
        if (entry->second.hash != placed.hash) refuse_both(entry->second, placed);
        continue;
      }
      const File_record& record = entry->second.record;
      ++codes[static_cast<std::size_t>(record.exit_code)];
      claims += record.claims;
      if (record.exit_code != 0) failing.push_back(record);
      const auto is_asked = [&](const Question& q) {
        return q == record.question || (q && record.question && *q == *record.question);
      };
      if (std::none_of(questions.begin(), questions.end(), is_asked)) questions.push_back(record.question);
    }
    corrupt += text.corrupt;
    if (text.is_cut_off) {
      std::cerr << "geometric_continuity: merge: " << GC::printable(input_name(name))
                << ": the last line is cut off, and left out\n";
      ++cut_off;
    }
  }
  if (known.empty()) throw std::invalid_argument("merge: there is no record");
  if (line.has("json")) {
    std::vector<std::string> objects, asked;
    for (const Question& question : questions) asked.push_back(question ? '{' + question->json() + '}' : "null");
    for (const File_record& r : failing)
      objects.push_back("\n  {" + File_record::json_name(r.name) + ",\"exit_code\":" + std::to_string(r.exit_code) +
                        ",\"claims\":" + r.claims.json() + '}');
    std::cout << "{\"files\":" << known.size() << ",\"exit_codes\":{\"0\":" << codes[0] << ",\"1\":" << codes[1]
              << ",\"2\":" << codes[2] << "},\"cut_off\":" << cut_off << ",\"corrupt\":" << corrupt
              << ",\n \"questions\":" << json_array(asked) << ",\n \"claims\":" << claims.json()
              << ",\n \"failing\":" << json_array(objects) << "}\n";
  } else {
    for (const File_record& r : failing)
      std::cout << shown_name(r) << ": "
                << (r.exit_code == bad_input ? std::string("no answer")
                                             : std::to_string(r.claims.counts[2]) + " not met, " +
                                                   std::to_string(r.claims.counts[3] + r.claims.counts[4]) +
                                                   " open, of " + std::to_string(r.claims.counts[0]))
                << '\n';
    std::cout << counted(known.size(), "file") << ": " << codes[0] << " with exit code 0, " << codes[1] << " with 1, "
              << codes[2] << " without an answer\n";
    for (const Question& question : questions)
      std::cout << "asked: " << question_words(question) << (question ? ", version " + question->version : "") << '\n';
    constexpr std::array<const char*, 5> words = {"given", "decided", "not met", "undecided", "not covered"};
    for (std::size_t i = 0; i < claims.counts.size(); ++i)
      std::cout << (i == 0 ? "" : ", ") << words[i] << ' ' << claims.counts[i];
    std::cout << '\n';
  }
  return codes[2] + cut_off + corrupt > 0 ? bad_input : codes[1] > 0 ? requirement_not_met : requirement_met;
}

} // namespace

const Command merge_command{"merge", merge_usage, describe_merge, run_merge};
