// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Repaired drawings: path data, drawn as it is and skewed, is repaired and read again as by
// `verify`. No join is worse than it was, a corner stays a corner, no kink is left where that is
// said, and what is repaired again stays as it is.

#include "fuzz_target.h"

#include "commands/drawings/segment_joins.h"
#include "commands/repair/repair_drawing.h"
#include "formats/svg/svg_drawing.h"

namespace {

typedef std::vector<std::optional<GC::Visual_class>> Grades;

struct Grading_handler : Drawing_handler {
  const GC::Corner_threshold& bound;
  Grades grades;

  explicit Grading_handler(const GC::Corner_threshold& largest_kink) : bound(largest_kink) {}

  void subpath(const Drawing_element&, int, const Drawing_subpath& path) override {
    const std::size_t n = path.segments.size();
    for (std::size_t i = 0; i < path.joins(); ++i)
      grades.push_back(segment_class(path.segments[i], path.segments[(i + 1) % n], bound));
  }
  void not_read(const Drawing_element&, const std::string&) override {}
};

Grades grades(const std::string& drawing, const GC::Corner_threshold& bound) {
  std::istringstream stream(drawing);
  Grading_handler handler(bound);
  read_svg_drawing(stream, "fuzz.svg", handler);
  return handler.grades;
}

void check_join(const std::optional<GC::Visual_class>& before, const std::optional<GC::Visual_class>& after) {
  require(before.has_value() == after.has_value(), "what is decided stays so");
  if (!before) return;
  require((*before == GC::Visual_class::corner) == (*after == GC::Visual_class::corner), "a corner stays a corner");
  require((std::min)(*before, GC::Visual_class::g1) <= *after, "no join is worse");
}

// How the drawing is repaired; with the exit code.
std::string repaired(const std::string& drawing, const Repair_options& options, int& code) {
  const Report_mode mode{Report_format::text, false, false, true, false};
  Repair_report report(mode);
  std::string result = repaired_drawing(drawing, "fuzz.svg", options, report);
  std::ostringstream os;
  code = report.print(os, "fuzz.svg");
  return result;
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string path(fuzz_text(data, size));
  if (size > 600 || path.find_first_of(std::string("<&\"\0", 4)) != std::string::npos) return 0;
  const std::string drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"" + path +
                              "\"/><path transform=\"skewX(20)\" d=\"" + path + "\"/></svg>\n";
  enum Way { kinks, curvatures, arcs, on_grid };
  for (const Way way : {kinks, curvatures, arcs, on_grid}) {
    Repair_options options;
    options.harmonise = way == curvatures;
    options.change_arcs = way == arcs;
    if (way == on_grid) options.grid_decimals = 3;
    Grades before;
    int code = 0;
    std::string result;
    { // what follows takes about as much work, and must not be refused
      const CGAL::Geometric_continuity::Work_scope limited(GC::Work_limit(500000000), "a fuzz input");
      if (!accepts([&] { before = grades(drawing, options.bound); })) return 0;
      if (!accepts([&] { result = repaired(drawing, options, code); })) return 0;
    }
    const Grades after = grades(result, options.bound);
    require(before.size() == after.size(), "there are as many joins as before");
    for (std::size_t i = 0; i < before.size(); ++i) check_join(before[i], after[i]);
    require(code != 0 || std::count(after.begin(), after.end(), GC::Visual_class::kink) == 0,
            "no kink is left where that is said");
    require(repaired(result, options, code) == result, "what is repaired again stays as it is");
  }
  return 0;
}
