// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/deferred_output.h"
#include "reports/Report.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <map>
#include <utility>
#include <vector>

// JUnit's XML, as programs for continuous integration read it: a suite for each file, in it a test
// case for each finding, and one for all places of the file without one. An error is a failure, a
// warning a test that was skipped, a note a test that has passed.

namespace {

// A text in an attribute or an element of XML, where not all characters are allowed.
std::string xml(const std::string& text) {
  std::string result;
  for (const char c : CGAL::Geometric_continuity::printable(text)) switch (c) {
    case '&': result += "&amp;"; break;
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    case '"': result += "&quot;"; break;
    default: result += c;
    }
  for (const char* const no_character : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"}) // U+FFFE and U+FFFF
    for (std::size_t i; (i = result.find(no_character)) != std::string::npos;) result.replace(i, 3, "\xEF\xBF\xBD");
  return result;
}

class Junit_writer : public Report::Writer {
  struct Suite {
    std::string file;
    std::size_t passed = 0, tests = 0, failures = 0, skipped = 0;
    // of the test cases: where they begin and end
    std::vector<std::pair<std::size_t, std::size_t>> parts;
  };
  std::vector<Suite> suites_;
  std::map<std::string, std::size_t> numbers_; // of the suites
  Deferred_output cases_;

  Suite& suite(const std::string& file) {
    if (!suites_.empty() && suites_.back().file == file) return suites_.back();
    const auto [number, is_new] = numbers_.emplace(file, suites_.size());
    if (is_new) suites_.push_back({file, 0, 0, 0, 0, {}});
    return suites_[number->second];
  }

  static std::string test_case(const std::string& file, const std::string& name) {
    return "  <testcase classname=\"" + xml(file) + "\" name=\"" + xml(name) + '"';
  }

  static std::string counts(const Suite& s) {
    return " tests=\"" + std::to_string(s.tests + (s.passed > 0)) + "\" failures=\"" + std::to_string(s.failures) +
           "\" errors=\"0\" skipped=\"" + std::to_string(s.skipped) + "\">\n";
  }

public:
  void row(const std::string&, const std::string&, const std::string&) override {}

  void find(const Finding& f) override {
    Suite& s = suite(f.file);
    ++s.tests;
    const std::string place = f.file + (f.line > 0 ? ':' + std::to_string(f.line) : "") + ": " + f.place;
    std::string text = test_case(f.file, f.place) + ">\n";
    if (f.level == Finding_level::error) {
      ++s.failures;
      text += "   <failure type=\"" + rule_id(f.rule) + "\" message=\"" + xml(f.message) + "\">" +
              xml(place + ": " + f.message) + "</failure>\n";
    } else if (f.level == Finding_level::warning) {
      ++s.skipped;
      text += "   <skipped message=\"" + xml(f.message) + "\"/>\n";
    } else
      text += "   <system-out>" + xml(place + ": " + f.message) + "</system-out>\n";
    const std::size_t begin = cases_.size();
    cases_.write(text + "  </testcase>\n");
    if (!s.parts.empty() && s.parts.back().second == begin)
      s.parts.back().second = cases_.size();
    else
      s.parts.emplace_back(begin, cases_.size());
  }

  void pass(const std::string& file, std::size_t n) override { suite(file).passed += n; }

  void print(std::ostream& os, const std::string&, const Conclusion& end) override {
    Suite all;
    for (const Suite& s : suites_) {
      all.tests += s.tests + (s.passed > 0);
      all.failures += s.failures;
      all.skipped += s.skipped;
    }
    const std::string places = end.subject().noun + 's';
    os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"geometric_continuity verify\"" << counts(all);
    for (const Suite& s : suites_) {
      os << " <testsuite name=\"" << xml(s.file) << '"' << counts(s);
      for (const auto& [begin, end] : s.parts) cases_.copy_to(os, begin, end);
      if (s.passed > 0)
        os << test_case(s.file, places + " without a finding") << " assertions=\"" << s.passed << "\"/>\n";
      os << " </testsuite>\n";
    }
    os << "</testsuites>\n";
  }
};

} // namespace

std::unique_ptr<Report::Writer> junit_writer() { return std::make_unique<Junit_writer>(); }
