// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_PAGE_H
#define GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_PAGE_H

#include "reports/Claims.h"
#include "reports/report_item.h"

#include <array>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// E.g. "G1".
const char* report_grade_name(Report_grade grade);

// The page of `report`: what is counted, the worst joins, and what is drawn.
class Report_page {
  const std::size_t most_;
  // a heap with the least bad one in front, as soon as there are as many as allowed
  std::vector<Report_item> items_;
  std::array<std::size_t, number_of_report_grades> counts_{};
  std::size_t total_ = 0;
  Claims claims_;
  std::vector<double> low_, high_; // of all points

public:
  std::string title, summary;
  std::vector<std::string> notes; // what is not covered, and the like
  int dimension = 2;
  bool down = false;        // the second coordinate grows downwards
  bool is_of_fonts = false; // with their grades; severities are in parts of an em
  bool is_of_cad_models = false;
  std::string empty = "There is no join."; // what stands in place of the list where it is empty
  // the address of geometric_continuity.html, to which joins are linked; empty for none
  std::string join_page;
  // the numbers of the items are shown; otherwise their places have numbers
  bool is_numbered = true;
  std::optional<Report_model> model;
  std::optional<Report_roads> roads;

  // A page that shows at most so many joins.
  explicit Report_page(std::size_t most) : most_(most) {}

  // Takes note of one more join of a grade that the page has; its number is total() + 1. Returns
  // whether it may be among those that are shown: then its item is to be passed to add(). The
  // reason is that of an undecided one.
  bool count(Report_grade grade, double rank, const std::string& reason = "no grade could be proved");
  void add(Report_item item);

  // Takes note of a thing that was given and is not covered, or of several, and of its place in
  // words, if that is to be shown.
  void leave_out(const char* noun, const std::string& reason, const std::string& note, std::size_t n = 1);

  const Claims& claims() const { return claims_; }

  // Returns whether its joins may have this grade.
  bool has(Report_grade grade) const;

  // Includes points in the whole, of the extent of which the severities of kinks are given in per
  // mille.
  void include(const std::vector<double>& points);
  double extent() const;

  std::size_t total() const { return total_; }
  std::size_t left_out() const { return total_ - items_.size(); }
  const std::vector<Report_item>& items() const { return items_; }

  // Sorts the joins, the worst first, and states in the notes how many are left out.
  void finish();

  // Numbers the edges of the items in their order.
  void number_edges();

  // Writes the page, one file of HTML that needs no other. Texts are escaped. Throws GC::Error
  // `not_finite`, with the place, for coordinates that are no finite floating-point numbers.
  void write(std::ostream& os) const;
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_REPORTS_REPORT_PAGE_H
