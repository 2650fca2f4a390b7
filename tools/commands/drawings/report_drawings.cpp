// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/chains/join_report.h"
#include "commands/drawings/Subpath_joins.h"
#include "commands/drawings/read_drawing.h"
#include "commands/work_limit.h"
#include "files/input.h"
#include "files/progress.h"
#include "reports/report_joins.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

// Measures the joins of all subpaths that it receives.
class Drawing_page : public Drawing_handler {
  typedef GC::Svg_segment<Drawing_traits> Segment;
  const Report_demand& demand_;
  Report_page& page_;
  const bool several_;
  std::size_t subpaths_ = 0, looked_through_ = 0;
  Progress progress_{"joins"};
  std::function<void()> show_progress_ = [] {};
  double part_of_drawing_ = 0; // that has been measured

public:
  Drawing_page(const Report_demand& demand, Report_page& page, bool several)
      : demand_(demand), page_(page), several_(several) {}

  void read(const Arguments& files) {
    const Reading_position position(files);
    for (std::size_t i = 0; i < files.size(); ++i) {
      const bool is_toolpath = is_toolpath_file(files[i]);
      page_.down = !is_toolpath;
      Input input(files[i]);
      part_of_drawing_ = 0;
      show_progress_ = [&] { progress_.step(page_.total(), [&] { return position.part(i, part_of_drawing_); }); };
      input.after_each_block(show_progress_);
      read_drawing(files[i], is_toolpath, input, *this);
      show_progress_ = [] {};
    }
    page_.summary = counted(page_.total(), "join") + " in " + counted(subpaths_, "subpath");
    if (looked_through_ != 0) page_.summary += "; rounding: " + counted(looked_through_, "segment") + " looked through";
  }

  void progress(double part) override { part_of_drawing_ = part; }

  void subpath(const Drawing_element& element, int number, const Drawing_subpath& path) override {
    const std::size_t n = path.segments.size(), group = subpaths_++;
    Report_outline drawn(n);
    const auto drawing = [&](std::size_t i) {
      if (!drawn[i]) drawn[i] = drawn_curve(path.segments[i], group);
      return drawn[i];
    };
    std::shared_ptr<const Report_outline> outline;
    for (const Segment& s : path.segments) page_.include({CGAL::to_double(s.end().x()), CGAL::to_double(s.end().y())});
    const Subpath_joins joins(element, path);
    looked_through_ += joins.rounding();
    joins.for_each([&](std::size_t i, std::size_t right_number, std::size_t looked_through, const Segment& right) {
      const Segment& left = path.segments[i];
      Report_item item = within_work_limit(
          [&] { return command_words(left) + (' ' + command_text(left)) + " and " + command_text(right); },
          [&] { return measured_join(left, right, demand_); });
      show_progress_();
      if (!page_.count(item.grade, item.severity)) return;
      item.number = page_.total();
      item.place = (several_ ? element.file + ": " : "") + element.text() + ", subpath " + std::to_string(number) +
                   ", " + command_words(left) + ' ' + command_text(left) + " - " + command_text(right);
      if (looked_through != 0) item.marks.push_back("rounding looked through");
      if (!outline && n <= most_curves_of_outline) {
        for (std::size_t j = 0; j < n; ++j) drawing(j);
        outline = std::make_shared<const Report_outline>(drawn);
      }
      item.outline = outline;
      item.left = drawing(i);
      item.right = drawing(right_number);
      page_.add(std::move(item));
    });
  }

  void not_read(const Drawing_element& element, const std::string& reason) override {
    page_.leave_out("element", reason,
                    (several_ ? element.file + ": " : "") + element.text() + ": not verified, " + reason);
  }
};

} // namespace

void report_drawings(const Arguments& files, const Report_demand& demand, Report_page& page) {
  Drawing_page drawing(demand, page, files.size() > 1);
  drawing.read(files);
  page.finish();
}
