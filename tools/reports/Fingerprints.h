// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINGERPRINTS_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINGERPRINTS_H

#include "reports/finding.h"
#include "reports/words.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <system_error>
#include <unordered_map>

// The names of fingerprints in SARIF. Neither depends on the rule, on lines or on the size of the
// defect.
constexpr const char *place_fingerprint = "filePlace/v2", *defect_fingerprint = "fileDefect/v2";

// The fingerprint of older reports, which contained the rule and lines.
constexpr const char* old_fingerprint = "ruleFilePlace/v1";

// The path of a file as seen from the folder in which the program runs, which is the root of a
// checkout in continuous integration; the whole path when the file lies outside of it.
inline std::string path_in_folder(const std::string& file) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::current_path(error), whole = (folder / file).lexically_normal(),
                              relative = whole.lexically_relative(folder);
  if (error) return file;
  return relative.empty() || *relative.begin() == ".." ? whole.string() : relative.string();
}

// Makes the fingerprints of the findings of a report, each of its own.
class Fingerprint_maker {
  std::unordered_map<std::uint64_t, std::size_t> places_, defects_; // how often each hash has been
  std::string file_, path_;                                         // of the last finding

  static std::uint64_t hash(std::initializer_list<const std::string*> texts) {
    std::uint64_t hash = 14695981039346656037u; // FNV-1a
    const auto add = [&hash](char c) { hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u; };
    for (const std::string* const text : texts) {
      for (const char c : *text) add(c);
      add('\n');
    }
    return hash;
  }

  static std::string numbered(std::uint64_t hash, std::unordered_map<std::uint64_t, std::size_t>& times) {
    constexpr char hex[] = "0123456789abcdef";
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += hex[hash >> shift & 15];
    return digits + ':' + std::to_string(++times[hash]);
  }

public:
  Fingerprints operator()(const Finding& f) {
    if (path_.empty() || file_ != f.file) path_ = path_in_folder(file_ = f.file);
    const std::string &object = f.object.empty() ? f.place : f.object, &shape = f.shape.empty() ? object : f.shape;
    return {numbered(hash({&path_, &f.kind, &object, &f.spot}), places_),
            numbered(hash({&path_, &f.kind, &shape, f.shape.empty() ? &f.spot : &shape}), defects_)};
  }
};

// A measure in JSON, as a member of an object.
inline std::string json_member(const char* name, const Measure& measure) {
  return std::string("\"") + name + "\":{\"quantity\":\"" + measure.quantity +
         "\",\"bounds\":" + json_text(std::optional<CGAL::Geometric_continuity::Enclosure>(measure.bounds)) + '}';
}

// The properties of a finding as members of an object, with its measures; may be empty.
inline std::string json_properties(const Finding& f) {
  std::string text = f.properties;
  const auto add = [&text](const char* name, const std::optional<Measure>& measure) {
    if (measure) text += (text.empty() ? "" : ",") + json_member(name, *measure);
  };
  add("measure", f.measure);
  add("behind", f.behind);
  return text;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_FINGERPRINTS_H
