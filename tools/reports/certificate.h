// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CERTIFICATE_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CERTIFICATE_H

#include "commands/commands.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/joins/join_result.h>

#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// The certificates that `verify` writes, a JSON object in each line: the first says what is
// certified, the last how many lines are between them. The page "Certificates" of the manual
// describes the members.

namespace GC = CGAL::Geometric_continuity;

// Writes the certificate of a report, line by line. Without a stream it does nothing.
class Certificate {
  std::ostream* const os_;
  std::size_t lines_ = 0;

public:
  // The subject is "chain", "drawings" or "model". More members begin with a comma.
  Certificate(std::ostream* os, const std::string& kind, const Arguments& files, const std::string& members = {})
      : os_(os) {
    if (os_ == nullptr) return;
    *os_ << "{\"certificate\":\"" << kind << "\",\"version\":1" << members << ",\"files\":[";
    for (std::size_t i = 0; i < files.size(); ++i) *os_ << (i == 0 ? "" : ",") << json_text(files[i]);
    *os_ << "]}\n";
  }

  explicit operator bool() const { return os_ != nullptr; }

  // Writes the members of a line, without braces.
  void add(const std::string& members) {
    *os_ << '{' << members << "}\n";
    ++lines_;
  }

  // Writes the last line.
  void finish() {
    if (os_ != nullptr) *os_ << "{\"lines\":" << lines_ << "}\n";
  }
};

// Exact numbers are strings, and vectors and lists of them are arrays.
inline void write_exact(std::ostream& os, const CGAL::Exact_rational& x) {
  GC::write_number(os << '"', x);
  os << '"';
}
template <class Range> void write_exact(std::ostream& os, const Range& range) {
  os << '[';
  const char* separator = "";
  for (const auto& x : range) {
    write_exact(os << separator, x);
    separator = ",";
  }
  os << ']';
}

// The members of a line about a join.
template <class FT, int N> std::string certificate_members(const GC::Join_certificate<FT, N>& c) {
  std::ostringstream os;
  const auto write_jet = [&](const char* name, const GC::Coordinate_jet<FT, N>& jet) {
    os << name;
    for (int j = 0; j <= jet.order(); ++j) write_exact(os << (j == 0 ? "[" : ","), jet[j]);
    os << ']';
  };
  const auto write_residual = [&](const char* name, const std::optional<GC::Coordinate_vector<FT, N>>& residual) {
    if (residual) write_exact(os << name, *residual);
  };
  write_jet("\"x\":", c.left);
  write_jet(",\"y\":", c.right);
  os << ",\"c_order\":" << c.c_order;
  write_residual(",\"c_residual\":", c.c_residual);
  os << ",\"g_order\":" << c.g_order;
  write_exact(os << ",\"betas\":", c.betas);
  write_residual(",\"g_residual\":", c.g_residual);
  os << ",\"f_order\":" << c.f_order;
  write_exact(os << ",\"f_factors\":", c.f_factors);
  write_residual(",\"f_residual\":", c.f_residual);
  return os.str();
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CERTIFICATE_H
