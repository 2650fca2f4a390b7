// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CONCLUSION_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CONCLUSION_H

#include "commands/commands.h"
#include "reports/Claims.h"

#include <string>

// The subject of a report.
struct Report_subject {
  std::string noun; // of what is decided, e.g. "join"
  // all of it in a sentence, e.g. "every shared edge and every knot line"
  std::string every;
  // what each must be, e.g. "G1 within the tolerance"; empty when nothing is required
  std::string required = {};
  std::string required_in_json = {};    // e.g. `"required":"G1"`; may be empty
  std::string proof = "proved exactly"; // how
  std::string table_head = {};          // before rows of text
};

// The words at the end of a report. They follow from the classes alone, and are decided nowhere
// else. "proved", `"met":true` and the exit code 0 are only given if everything is decided and met,
// or if the mode allows the undecided things.
class Conclusion {
  const Claims& claims_;
  const Report_mode& mode_;
  const Report_subject& subject_;

  bool is_refused(std::size_t n, bool is_allowed) const { return n > 0 && !is_allowed; }
  bool has_refused() const;

  // Returns whether nothing could be decided at all.
  bool is_empty() const { return claims_.decided() + claims_.undecided() + claims_.known() == 0; }

public:
  Conclusion(const Claims& claims, const Report_mode& mode, const Report_subject& subject)
      : claims_(claims), mode_(mode), subject_(subject) {}

  const Claims& claims() const { return claims_; }
  const Report_subject& subject() const { return subject_; }
  bool is_met() const { return claims_.not_met() == 0 && !has_refused(); }

  // Lines of text.
  std::string text() const;

  // Members of a JSON object: the classes, the requirement and whether it is met; `null` when
  // nothing was decided.
  std::string json() const;

  // Returns the exit code. When nothing was decided and that is not allowed, says so on standard
  // error.
  int exit_code() const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_CONCLUSION_H
