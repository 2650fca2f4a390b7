// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H

#include "files/input.h"
#include "reports/Json_view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>

// How many things of a file, or of many files, are in each class, in the order of their names.
struct Claim_counts {
  static constexpr std::array<const char*, 5> names = {"given", "decided", "not_met", "undecided", "not_covered"};
  std::array<std::uint64_t, 5> counts{};

  Claim_counts& operator+=(const Claim_counts& x) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += x.counts[i];
    return *this;
  }

  std::string json() const {
    std::string text;
    for (std::size_t i = 0; i < counts.size(); ++i)
      text += (i == 0 ? "{\"" : ",\"") + std::string(names[i]) + "\":" + std::to_string(counts[i]);
    return text + '}';
  }

  // Of the object `claims` of a report, where what is open is an array with a count for each reason, or of a record.
  static Claim_counts of(const Json_view& claims) {
    Claim_counts result;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::optional<Json_view> value = claims.member(names[i]);
      if (!value) continue;
      if (const std::optional<std::uint64_t> n = value->count()) result.counts[i] = *n;
      value->for_elements([&](const Json_view& reason) {
        if (const auto n = reason.member("count"))
          if (const auto count = n->count()) result.counts[i] += *count;
      });
    }
    return result;
  }
};

// A line of the output of `verify --jsonl`.
struct File_record {
  std::string file; // as JSON writes it, with quotation marks
  int exit_code;
  Claim_counts claims;

  // Reads a line. Returns nothing for what is no record.
  static std::optional<File_record> of(const std::string& line) {
    try {
      const Json_view object = Json_view::of(line);
      const std::optional<Json_view> file = object.member("file"), code = object.member("exit_code");
      if (!file || !file->string() || !code || !code->count() || *code->count() > 2) return std::nullopt;
      File_record record{std::string(file->text()), static_cast<int>(*code->count()), {}};
      if (const std::optional<Json_view> claims = object.member("claims")) record.claims = Claim_counts::of(*claims);
      return record;
    } catch (const CGAL::Geometric_continuity::Error&) {
      return std::nullopt;
    }
  }
};

// What has been read of a text of records.
struct Read_records {
  std::uint64_t size = 0;  // the bytes of whole lines
  bool is_cut_off = false; // a last line without its end follows, as an interruption leaves it
};

// Calls f(record, line) for each record of a text. Throws Error `malformed_input` for a whole line that is no record.
template <class Function> Read_records for_each_record(std::istream& is, const std::string& name, Function f) {
  namespace GC = CGAL::Geometric_continuity;
  Read_records read;
  std::size_t number = 0;
  for (std::string line; std::getline(is, line);) {
    if (is.eof()) {
      read.is_cut_off = true;
      break;
    }
    ++number;
    const std::optional<File_record> record = File_record::of(line);
    if (!record)
      throw GC::Error(GC::Error_code::malformed_input,
                      name + ':' + std::to_string(number) + ": no record, as verify --jsonl writes them");
    f(*record, line);
    read.size += line.size() + 1;
  }
  return read;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H
