// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/command_line.h"
#include "commands/lists/File_record.h"
#include "files/input.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <functional>
#include <iostream>
#include <unordered_map>
#include <utility>

namespace {

namespace GC = CGAL::Geometric_continuity;

const char* const merge_usage = R"(usage: geometric_continuity merge RECORDS... [OPTIONS]

Adds up the records that verify --jsonl has written, of one run or of many on
different machines: how many files met the requirement, what was given, decided
and left open in all of them, and which files did not meet it or have no answer.
A file that has the same record twice counts once. A last line that an
interruption has cut off is left out, and said.

example:
  geometric_continuity merge part-*.jsonl

Exit code: that of the worst file, 0, 1 or 2 (no answer), and 2 on bad input,
when a line is cut off, and when there is no record.
)";

void describe_merge(po::options_description_easy_init add) { add("json", "print the sums as JSON"); }

int run_merge(const Command_line& line) {
  if (line.files().empty()) throw std::invalid_argument("merge: no file is given; see --help");
  std::unordered_map<std::string, std::size_t> known; // the hash of the record of each file
  std::array<std::size_t, 3> codes{};
  Claim_counts claims;
  std::vector<File_record> failing;
  std::size_t cut_off = 0;
  for (const std::string& name : line.files()) {
    Input input(name);
    const Read_records read =
        for_each_record(input, input_name(name), [&](const File_record& record, const std::string& text) {
          const std::size_t hash = std::hash<std::string>()(text);
          const auto [entry, is_new] = known.emplace(record.file, hash);
          if (!is_new) {
            if (entry->second != hash)
              throw GC::Error(GC::Error_code::malformed_input,
                              input_name(name) + ": another record of the file " + record.file);
            return;
          }
          ++codes[static_cast<std::size_t>(record.exit_code)];
          claims += record.claims;
          if (record.exit_code != 0) failing.push_back(record);
        });
    if (read.is_cut_off) {
      std::cerr << "geometric_continuity: merge: " << GC::printable(input_name(name))
                << ": the last line is cut off, and left out\n";
      ++cut_off;
    }
  }
  if (known.empty()) throw std::invalid_argument("merge: there is no record");
  if (line.has("json")) {
    std::vector<std::string> objects;
    for (const File_record& r : failing)
      objects.push_back("\n  {\"file\":" + r.file + ",\"exit_code\":" + std::to_string(r.exit_code) +
                        ",\"claims\":" + r.claims.json() + '}');
    std::cout << "{\"files\":" << known.size() << ",\"exit_codes\":{\"0\":" << codes[0] << ",\"1\":" << codes[1]
              << ",\"2\":" << codes[2] << "},\"cut_off\":" << cut_off << ",\n \"claims\":" << claims.json()
              << ",\n \"failing\":" << json_array(objects) << "}\n";
  } else {
    for (const File_record& r : failing)
      std::cout << r.file << ": "
                << (r.exit_code == bad_input ? std::string("no answer")
                                             : std::to_string(r.claims.counts[2]) + " not met, " +
                                                   std::to_string(r.claims.counts[3] + r.claims.counts[4]) +
                                                   " open, of " + std::to_string(r.claims.counts[0]))
                << '\n';
    std::cout << counted(known.size(), "file") << ": " << codes[0] << " with exit code 0, " << codes[1] << " with 1, "
              << codes[2] << " without an answer\n";
    constexpr std::array<const char*, 5> words = {"given", "decided", "not met", "undecided", "not covered"};
    for (std::size_t i = 0; i < claims.counts.size(); ++i)
      std::cout << (i == 0 ? "" : ", ") << words[i] << ' ' << claims.counts[i];
    std::cout << '\n';
  }
  return codes[2] + cut_off > 0 ? bad_input : codes[1] > 0 ? requirement_not_met : requirement_met;
}

} // namespace

const Command merge_command{"merge", merge_usage, describe_merge, run_merge};
