// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H

#include "commands/commands.h"
#include "commands/lists/File_state.h"
#include "reports/Json_view.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

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

  // Reads the object `claims` of a report, in which open things are an array with a count for each
  // reason, or of a record.
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

// The question that a file was asked, and the program that asked it.
struct File_question {
  std::vector<std::string> options; // that matter for the answer, in one order and one form
  std::string version;              // of the program

  bool operator==(const File_question& x) const { return options == x.options && version == x.version; }

  // As it stands in a record.
  std::string json() const {
    std::vector<std::string> texts;
    for (const std::string& option : options) texts.push_back(json_text(option));
    return "\"asked\":" + json_array(texts) + ",\"version\":" + json_text(version);
  }
};

// The limits for a file. An answer does not depend on them, but its existence may.
struct File_limits {
  double seconds = 0, mebibytes = 0;

  std::string json() const {
    return "\"limits\":{\"seconds\":" + rounded(seconds, 17) + ",\"mebibytes\":" + rounded(mebibytes, 17) + '}';
  }
};

// A line of the output of `verify --jsonl`.
struct File_record {
  std::string name; // the bytes of the name of the file
  int exit_code;
  Claim_counts claims = {};
  std::shared_ptr<const File_question> question = {}; // records of old versions have none
  File_limits limits = {};                            // of what has no answer
  std::string size = {}, sha256 = {};                 // of the file, as they are written

  // The members that name a file: its name, and its bytes where it is no UTF-8, so that not all of
  // them can be written.
  static std::string json_name(const std::string& name) {
    std::string text = "\"file\":" + json_text(name);
    if (CGAL::Geometric_continuity::is_utf8(name)) return text;
    constexpr char hex[] = "0123456789abcdef";
    text += ",\"name_bytes\":\"";
    for (const char c : name)
      text += {hex[static_cast<unsigned char>(c) / 16], hex[static_cast<unsigned char>(c) % 16]};
    return text + '"';
  }

  // Returns whether it answers a question about a file that is now in this state. A file without an
  // answer is asked again where more is allowed.
  bool answers(const File_question& asked, const File_state& state, const File_limits& now) const {
    return question && *question == asked && state.is_told && size == state.size && sha256 == state.sha256 &&
           (exit_code != bad_input || (now.seconds <= limits.seconds && now.mebibytes <= limits.mebibytes));
  }

  // Reads a line. Returns nothing for what is no record.
  static std::optional<File_record> of(const std::string& line) {
    const auto is_plain = [](char c) { return ' ' <= c; }; // of ASCII
    if (!std::all_of(line.begin(), line.end(), is_plain) &&
        (!CGAL::Geometric_continuity::is_utf8(line) ||
         std::any_of(line.begin(), line.end(), [](char c) { return '\0' <= c && c < ' '; })))
      return std::nullopt; // which is not written
    try {
      File_record record{{}, -1};
      File_question question;
      bool has_name = false, is_asked = false, has_version = false;
      Json_view::of(line).for_members([&](std::string_view key, const Json_view& value) {
        const std::optional<std::string> text = value.decoded();
        if (key == "file" && text && !has_name) {
          record.name = *text;
          has_name = true;
        } else if (key == "name_bytes") {
          const std::optional<std::string> name = bytes_of(text.value_or(""));
          has_name = name.has_value();
          record.name = name.value_or("");
        } else if (key == "exit_code" && value.count() && *value.count() <= 2)
          record.exit_code = static_cast<int>(*value.count());
        else if (key == "claims")
          record.claims = Claim_counts::of(value);
        else if (key == "asked") {
          is_asked = true;
          value.for_elements(
              [&](const Json_view& option) { question.options.push_back(option.decoded().value_or("")); });
        } else if (key == "version") {
          has_version = true;
          question.version = text.value_or("");
        } else if (key == "limits") {
          const std::optional<Json_view> seconds = value.member("seconds"), mebibytes = value.member("mebibytes");
          if (seconds && mebibytes) record.limits = {seconds->number().value_or(0), mebibytes->number().value_or(0)};
        } else if (key == "size")
          record.size = value.text();
        else if (key == "sha256")
          record.sha256 = value.text();
        return key != "report"; // which is the last one
      });
      if (!has_name || record.exit_code < 0) return std::nullopt;
      if (is_asked && has_version) record.question = std::make_shared<const File_question>(std::move(question));
      return record;
    } catch (const CGAL::Geometric_continuity::Error&) {
      return std::nullopt;
    }
  }

private:
  static std::optional<std::string> bytes_of(std::string_view hex) {
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
      unsigned char byte = 0;
      const char* const end = hex.data() + (std::min)(i + 2, hex.size());
      const std::from_chars_result read = std::from_chars(hex.data() + i, end, byte, 16);
      if (read.ec != std::errc() || read.ptr != hex.data() + i + 2) return std::nullopt;
      bytes += static_cast<char>(byte);
    }
    return bytes.empty() ? std::nullopt : std::optional<std::string>(bytes);
  }
};

// The records that have been read from a text.
struct Read_records {
  std::uint64_t size = 0;  // the bytes of whole lines
  std::size_t records = 0; // among them
  std::size_t corrupt = 0; // lines that are no records
  bool is_cut_off = false; // a last line without its end follows, as an interruption leaves it
};

// Calls f(record, line, number) for each record of a text, and corrupt(number) for each whole line
// that is none, with the numbers of the lines, from 1 on.
template <class Function, class Corrupt> Read_records for_each_record(std::istream& is, Function f, Corrupt corrupt) {
  Read_records read;
  std::shared_ptr<const File_question> question; // most records have the same one
  std::size_t number = 0;
  for (std::string line; std::getline(is, line);) {
    if (is.eof()) {
      read.is_cut_off = true;
      break;
    }
    ++number;
    read.size += line.size() + 1;
    if (std::optional<File_record> record = File_record::of(line)) {
      ++read.records;
      if (question && record->question && *question == *record->question)
        record->question = question;
      else
        question = record->question;
      f(*record, line, number);
    } else {
      ++read.corrupt;
      corrupt(number);
    }
  }
  return read;
}

// Says on standard error that lines of a file are no records, and what follows from that: of each
// of the first ones, then how many there are.
class Corrupt_lines {
  static constexpr std::size_t most_ = 10;
  const std::string place_, command_, consequence_;
  std::size_t lines_ = 0;

  void say(const std::string& text) const {
    std::cerr << "geometric_continuity: " << command_ << ": " << CGAL::Geometric_continuity::printable(text) << '\n';
  }

public:
  Corrupt_lines(const std::string& command, const std::string& file, const std::string& consequence)
      : place_(file), command_(command), consequence_(consequence) {}
  Corrupt_lines(const Corrupt_lines&) = delete;
  Corrupt_lines& operator=(const Corrupt_lines&) = delete;
  ~Corrupt_lines() {
    if (lines_ > most_) say(place_ + ": " + std::to_string(lines_ - most_) + " more lines are no records");
  }
  void operator()(std::size_t number) {
    if (++lines_ <= most_)
      say(place_ + ':' + std::to_string(number) + ": no record, as verify --jsonl writes them; " + consequence_);
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_LISTS_FILE_RECORD_H
