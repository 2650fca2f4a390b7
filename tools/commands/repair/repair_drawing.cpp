// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/repair/repair_drawing.h"

#include "commands/drawings/Subpath_joins.h"
#include "commands/drawings/segment_joins.h"
#include "commands/repair/path_text.h"
#include "files/progress.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/IO/json.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

// Calls f(i, grade, n) for each join of a subpath, as verify decides them, behind the segment i,
// with n segments that are looked through; the grade is empty where it is not known.
template <class Function>
void for_each_join(const Drawing_element& element, const Drawing_subpath& path, const GC::Corner_threshold& bound,
                   Function f) {
  Subpath_joins(element, path).for_each([&](std::size_t i, std::size_t, std::size_t looked_through, const auto& right) {
    f(i, segment_class(path.segments[i], right, bound), looked_through);
  });
}

// The element of a path that is mapped like this, instead of as it is drawn.
Drawing_element mapped(const Drawing_element& element, const std::optional<Drawing_transform>& map) {
  Drawing_element result = element;
  result.transform = map.value_or(Drawing_transform());
  return result;
}

bool is_drawn(Path_role role) { return role == Path_role::drawn || role == Path_role::repetition; }

// The joins of a drawing.
struct Drawing_joins {
  Grade_counts drawn, defined; // the latter are not drawn
  std::size_t undecided = 0;

  // Adds the joins of a subpath as it is drawn, if it is. Returns whether there are kinks.
  bool add(const Drawing_element& element, const Drawing_subpath& path, Path_role role,
           const GC::Corner_threshold& bound) {
    bool has_kinks = false;
    for_each_join(element, path, bound, [&](std::size_t, const std::optional<GC::Visual_class>& grade, std::size_t) {
      has_kinks = has_kinks || grade == GC::Visual_class::kink;
      if (role == Path_role::repeated) return; // they are counted where they are drawn
      if (grade)
        ++(is_drawn(role) ? drawn : defined)[*grade];
      else
        ++undecided;
    });
    return has_kinks;
  }
};

// The map by which an element is drawn, where that changes angles.
std::optional<Drawing_transform> skewing_map(const Drawing_element& element, Path_role role) {
  const auto& m = element.transform.matrix();
  const bool is_similarity = m[0] * m[0] + m[1] * m[1] == m[2] * m[2] + m[3] * m[3] && m[0] * m[2] + m[1] * m[3] == 0;
  return is_drawn(role) && !is_similarity ? std::optional<Drawing_transform>(element.transform) : std::nullopt;
}

// Returns whether a curve is read as it was computed. One that has become straight by a handle at
// its node is read as a line.
bool is_read_as(const Grid_curve& read, const Grid_curve& computed) {
  if (read.arc && computed.arc)
    return read.arc->start() == computed.arc->start() && read.arc->end() == computed.arc->end() &&
           read.written->rx == computed.written->rx && read.written->ry == computed.written->ry;
  if (read.points.empty() || computed.points.empty()) return false;
  if (read.points.size() == computed.points.size()) {
    if (computed.offsets.empty()) return read.points == computed.points;
    for (std::size_t k = 0; k < computed.points.size(); ++k)
      if (exact_point(read, k) != exact_point(computed, k)) return false;
    return true;
  }
  const std::size_t last = computed.points.size() - 1;
  return read.points.size() == 2 && is_line(computed) && exact_point(read, 0) == exact_point(computed, 0) &&
         exact_point(read, 1) == exact_point(computed, last);
}

[[noreturn]] void refuse_to_write(const std::string& place) {
  throw std::logic_error(place + ": what would be written is not what was computed; nothing is written");
}

// Counts the joins of shapes and paths when a drawing is read for repair.
class Counting_handler : public Drawing_handler {
protected:
  const GC::Corner_threshold& bound_;

public:
  Drawing_joins joins;

  explicit Counting_handler(const GC::Corner_threshold& bound) : bound_(bound) {}

  bool takes_paths() const override { return true; }
  void subpath(const Drawing_element& element, int, const Drawing_subpath& path) override {
    joins.add(element, path, Path_role::drawn, bound_);
  }
  void not_read(const Drawing_element&, const std::string&) override {}

protected:
  // Counts the joins of a path, up to an error, of which the text is returned. Calls
  // note(has_kinks) behind each subpath.
  template <class Note>
  std::string count(const Drawing_element& element, const Path_data& path, GC::Svg_path_places* places, Note note) {
    GC::Svg_path_reader<Drawing_traits> reader(path.value, "d", places);
    for (;;) {
      std::string error;
      std::optional<Drawing_subpath> subpath;
      try {
        subpath = reader.next();
      } catch (const GC::Error& e) {
        error = GC::svg_reason(e);
        subpath = reader.before_error();
      }
      if (subpath) {
        subpath->leave_out_points();
        if (element.is_filled) subpath->join_ends();
        const std::optional<Drawing_transform> map =
            is_drawn(path.role) ? std::optional<Drawing_transform>(element.transform) : std::nullopt;
        note(joins.add(mapped(element, map), map ? subpath->transform(*map) : *subpath, path.role, bound_));
      }
      if (!subpath || !error.empty()) return error;
    }
  }
};

// Repairs the paths of a drawing.
class Drawing_mender : public Counting_handler {
  const std::string& text_;
  const Repair_options& options_;
  Repair_report& report_;
  std::string result_;
  std::size_t read_ = 0, paths_ = 0;
  Progress progress_{"paths"};

public:
  std::vector<std::string> data; // of each path, as it will be

  Drawing_mender(const std::string& text, const Repair_options& options, Repair_report& report)
      : Counting_handler(options.bound), text_(text), options_(options), report_(report) {}

  std::string result() {
    result_.append(text_, read_, std::string::npos);
    return std::move(result_);
  }

  void subpath(const Drawing_element& element, int number, const Drawing_subpath& path) override {
    Counting_handler::subpath(element, number, path);
    for_each_join(element, path, bound_, [&](std::size_t i, const std::optional<GC::Visual_class>& grade, std::size_t) {
      const std::string command = std::to_string(path.segments[i].command);
      if (grade == GC::Visual_class::kink)
        report_.add_unread(element.text() + ", behind command " + command,
                           members(element) + ",\"curve\":" + std::to_string(i), "no handle can move");
    });
  }

  void not_read(const Drawing_element& element, const std::string& reason) override {
    report_.add_uncovered(element.text(), members(element), reason);
  }

  void path(const Drawing_element& element, const Path_data& path) override {
    progress_.step(paths_++, [&] { return path.text.refusal().empty() ? part(path.text[0]) : 0; });
    if (path.role == Path_role::repetition) {
      count(element, path, nullptr, [](bool) {});
      return;
    }
    data.push_back(path.value);
    std::string refusal = path.text.refusal();
    Path_decimals decimals;
    bool has_kinks = false;
    GC::Svg_path_places places;
    const std::string error = count(element, path, &places, [&](bool kinks) {
      has_kinks = has_kinks || kinks;
      decimals.add(path.value, places);
      places.commands.clear();
      places.numbers.clear();
    });
    if (!error.empty()) return report_.add_uncovered(element.text(), members(element), error + "; it is left as it is");
    decimals.add(path.value, places);
    if (!has_kinks && !options_.harmonise && refusal.empty()) return;
    if (!refusal.empty()) return report_.add_unread(element.text(), members(element), refusal);
    const std::optional<Drawing_transform> map = skewing_map(element, path.role);
    const std::vector<Text_edit> edits = repair(element, path, map, decimals);
    for (const Text_edit& edit : edits) {
      result_.append(text_, read_, path.text[edit.range.begin] - read_) += edit.text;
      read_ = path.text[edit.range.end];
    }
  }

private:
  double part(std::size_t position) const {
    return text_.empty() ? 0 : static_cast<double>(position) / static_cast<double>(text_.size());
  }

  static std::string members(const Drawing_element& element) {
    std::ostringstream os;
    GC::write_json(os << "\"element\":", element.name);
    GC::write_json(os << ",\"id\":", element.id);
    os << ",\"line\":" << element.line;
    return os.str();
  }

  // Returns the edits of the data, after which they are data.back().
  std::vector<Text_edit> repair(const Drawing_element& element, const Path_data& path,
                                const std::optional<Drawing_transform>& map, const Path_decimals& decimals) {
    std::vector<Text_edit> all;
    std::vector<std::pair<std::size_t, Grid_contour>> changed; // with the number of the subpath
    Path_text text(path.value, path.place, decimals, map, element.is_filled);
    const std::string coarse = reason_for_coarser_grid(element, path, map, decimals);
    const bool has_rounding =
                   (!coarse.empty() || options_.change_arcs) && this->has_rounding(element, path, map, decimals),
               may_add_decimals = !coarse.empty() && !has_rounding, adds_ends = !has_rounding;
    for (std::size_t number = 1; text.next(); ++number) {
      bool has_kinks = options_.harmonise;
      const std::string place = element.text() + ", subpath " + std::to_string(number),
                        place_members = members(element) + ",\"subpath\":" + std::to_string(number);
      for_each_join(mapped(element, map), map ? text.subpath().transform(*map) : text.subpath(), bound_,
                    [&](std::size_t i, const auto& grade, std::size_t looked_through) {
                      if (grade != GC::Visual_class::kink) return;
                      has_kinks = true;
                      if (looked_through != 0)
                        report_.add_unread(
                            place + ", behind command " + std::to_string(text.subpath().segments[i].command),
                            place_members + ",\"curve\":" + std::to_string(i),
                            "a segment that is rounding lies between the curves; the kink can be mended without it");
                    });
      if (!has_kinks) continue;
      Grid_contour given = contour_of(text, !coarse.empty());
      given.may_add_decimals = may_add_decimals;
      given.most_decimals = given.decimals + (adds_ends ? 2 : 0);
      const auto unknown = std::find_if(given.curves.begin(), given.curves.end(), is_unknown);
      if (unknown != given.curves.end()) {
        report_.add_unread(place, place_members, unknown->reason);
        continue;
      }
      Grid_contour contour = given;
      Contour_repair done = ::repair(contour, options_);
      if (given.is_beside_grid && done.is_of_use()) report_.add_grid(place, place_members, given.unit(), coarse);
      done.undecided.clear(); // all joins of the drawing are counted in the end
      const auto& segments = text.subpath().segments;
      report_.add(place, place_members, contour, done,
                  [&](std::size_t curve) { return "command " + std::to_string(segments[curve].command); });
      if (done.moves.empty() && done.arcs.empty()) continue;
      for (Text_edit& edit : text.edits(given, contour)) all.push_back(std::move(edit));
      changed.emplace_back(number, std::move(contour));
    }
    if (all.empty()) return all;
    std::string written;
    std::size_t read = 0;
    for (const Text_edit& edit : all) {
      written.append(path.value, read, edit.range.begin - read) += edit.text;
      read = edit.range.end;
    }
    written.append(path.value, read, std::string::npos);
    check(written, path.place, decimals, element.is_filled, changed);
    data.back() = std::move(written);
    return all;
  }

  static bool is_unknown(const Grid_curve& curve) { return curve.points.empty() && !curve.arc; }

  // Returns whether a path has segments that are rounding, by the number of its decimals: no number
  // may get more.
  static bool has_rounding(const Drawing_element& element, const Path_data& path,
                           const std::optional<Drawing_transform>& map, const Path_decimals& decimals) {
    Path_text text(path.value, path.place, decimals, map, element.is_filled);
    const Drawing_element drawn = mapped(element, map);
    while (text.next()) {
      const Drawing_subpath subpath = map ? text.subpath().transform(*map) : text.subpath();
      if (Subpath_joins(drawn, subpath).rounding() != 0) return true;
    }
    return false;
  }

  // Returns why all subpaths of a path need coarser grids than that of its decimals; empty where
  // they do not, or where a grid is asked for.
  std::string reason_for_coarser_grid(const Drawing_element& element, const Path_data& path,
                                      const std::optional<Drawing_transform>& map,
                                      const Path_decimals& decimals) const {
    if (options_.grid_decimals) return "";
    if (!decimals.fit) return "its numbers have more digits than a grid of their last decimal";
    Path_text text(path.value, path.place, decimals, map, element.is_filled);
    while (text.next()) {
      const Grid_contour own = text.contour();
      if (std::any_of(own.curves.begin(), own.curves.end(), is_unknown))
        return "a coordinate is too large for its decimals";
      if (const std::string reason = needs_coarser_grid(own, options_); !reason.empty()) return reason;
    }
    return "";
  }

  // The subpath on the grid that is asked for, on that of its decimals or on a coarser one.
  Grid_contour contour_of(const Path_text& text, bool coarse) const {
    if (!coarse && !options_.grid_decimals) return text.contour();
    return text.contour_beside_grid(options_.grid_decimals ? *options_.grid_decimals
                                                           : text.coarser_decimals(longest_beside_grid(options_)));
  }

  // Returns whether what is written draws what was computed.
  static void check(const std::string& written, const std::string& place, const Path_decimals& decimals, bool is_filled,
                    const std::vector<std::pair<std::size_t, Grid_contour>>& changed) {
    Path_text text(written, place, decimals, std::nullopt, is_filled);
    auto expected = changed.begin();
    for (std::size_t number = 1; text.next(); ++number)
      if (expected != changed.end() && expected->first == number) {
        const Grid_contour& contour = expected->second;
        const std::vector<Grid_curve>
            read = (contour.is_beside_grid ? text.contour_beside_grid(contour.decimals) : text.contour()).curves,
            &computed = contour.curves;
        if (!std::equal(read.begin(), read.end(), computed.begin(), computed.end(), is_read_as)) refuse_to_write(place);
        ++expected;
      }
    if (expected != changed.end()) refuse_to_write(place);
  }
};

// Counts the joins of what is to be written, whose path data must be as expected.
class Result_reader : public Counting_handler {
  const std::vector<std::string>& expected_;
  std::size_t paths_ = 0;

public:
  Result_reader(const GC::Corner_threshold& bound, const std::vector<std::string>& expected)
      : Counting_handler(bound), expected_(expected) {}

  void path(const Drawing_element& element, const Path_data& path) override {
    if (path.role != Path_role::repetition && (paths_ == expected_.size() || path.value != expected_[paths_++]))
      refuse_to_write(path.place);
    count(element, path, nullptr, [](bool) {});
  }

  bool has_read_all() const { return paths_ == expected_.size(); }
};

} // namespace

std::string repaired_drawing(const std::string& text, const std::string& name, const Repair_options& options,
                             Repair_report& report) {
  if (text.find('\0') != std::string::npos)
    throw GC::Error(GC::Error_code::malformed_input,
                    name + ": a drawing in UTF-16 is not repaired; convert it to UTF-8");
  Drawing_mender mender(text, options, report);
  std::istringstream given(text);
  read_svg_drawing(given, name, mender);
  std::string result = mender.result();
  Result_reader reader(options.bound, mender.data);
  std::istringstream written(result);
  read_svg_drawing(written, name, reader);
  if (!reader.has_read_all()) refuse_to_write(name);
  report.add_grades(mender.joins.drawn, reader.joins.drawn);
  report.add_definitions(mender.joins.defined, reader.joins.defined);
  report.add_undecided(reader.joins.undecided);
  return result;
}
