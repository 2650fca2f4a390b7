// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/svg/svg_drawing.h"

#include "files/input.h"
#include "formats/svg/Drawing_document.h"
#include "formats/svg/Drawing_frame.h"

#include "formats/svg/read_svg_path.h"
#include "formats/svg/svg_shapes.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace {

// The elements that use elements repeat may have this size together, as written: so many bytes, or
// this many times the size of the drawing if that is more.
constexpr std::size_t free_repetition = 1 << 24, most_repetitions = 10;
constexpr std::size_t most_nested = 256; // elements in each other, with those that are repeated

const char* const what_follows = "; what follows is not read";

// The largest number of digits behind the point, when exponents are written out.
int most_decimals(std::string_view text) {
  int most = 0;
  const char *p = text.data(), *const end = p + text.size();
  const auto digit = [&] { return p != end && '0' <= *p && *p <= '9'; };
  while (p != end) {
    if (!digit() && *p != '.') {
      ++p;
      continue;
    }
    int decimals = 0, exponent = 0;
    while (digit()) ++p;
    if (p != end && *p == '.')
      for (++p; digit(); ++p) ++decimals;
    if (p != end && (*p == 'e' || *p == 'E')) {
      ++p;
      if (p != end && *p == '+') ++p;
      p = std::from_chars(p, end, exponent).ptr;
    }
    most = (std::max)(most, decimals - exponent);
  }
  return most;
}

// Goes through the elements of a drawing, and through those that use elements repeat, and hands on
// what they draw.
class Drawing_walk {
  // A part that is traversed: the elements from one on, and those that a use element repeats in its
  // place.
  struct Part {
    std::size_t next, end;
    std::size_t frames;      // how many there are below
    std::size_t use, target; // numbers; no element in the outermost part
    Repeated_size size;      // of the viewport
  };
  // An element that holds what comes next, up to another one.
  struct Open_frame {
    Drawing_frame frame;
    std::size_t end;
  };

  const std::string& file_;
  const Drawing_document& document_;
  Drawing_handler& handler_;
  const bool takes_paths_ = handler_.takes_paths();
  std::vector<Part> parts_;
  std::vector<Open_frame> frames_;
  // the elements that use elements draw, where paths are taken
  std::set<std::size_t> repeated_;
  std::size_t repetition_ = 0;                // bytes
  mutable std::vector<std::size_t> ordinals_; // of the elements, once one was asked for

  const Drawing_node& node(std::size_t i) const { return document_.nodes[i]; }
  bool is_repetition() const { return parts_.size() > 1; }
  std::size_t none() const { return document_.nodes.size(); }

  Drawing_element element(std::size_t i) const {
    const Drawing_node& n = node(i);
    Drawing_element e{file_, std::string(n.name), n.attributes.text("id"), n.line};
    e.path = [this, i] { return path(i); };
    e.tag = n.tag;
    e.tag_begin = n.tag_begin;
    if (!is_repetition()) return e;
    e.tag = {};
    const auto text = [&](const Part& part) { return element_text(node(part.use)); };
    e.repeated_by = text(parts_.back());
    if (parts_.size() > 2) e.repeated_by += " in " + text(parts_[1]); // which tells which one it is
    return e;
  }
  // Which element it is, in the repetition that is gone through.
  std::string path(std::size_t i) const {
    std::string text;
    for (std::size_t k = 1; k < parts_.size(); ++k) text += path_in_document(parts_[k].use) + '>';
    return text + path_in_document(i);
  }

  std::string path_in_document(std::size_t i) const {
    if (ordinals_.empty()) count_ordinals();
    std::string text;
    for (;; i = node(i).parent) {
      const std::string &id = node(i).attributes.text("id"), rest = text.empty() ? "" : '/' + text;
      if (!id.empty()) return std::string(node(i).name) + '#' + id + rest;
      text = std::string(node(i).name) + '[' + std::to_string(ordinals_[i]) + ']' + rest;
      if (node(i).parent == i) return text;
    }
  }

  // Counts the elements of one name in each element, from 1 on.
  void count_ordinals() const {
    std::map<std::pair<std::size_t, std::string_view>, std::size_t> counts;
    for (std::size_t i = 0; i < none(); ++i) ordinals_.push_back(++counts[{node(i).parent, node(i).name}]);
  }

  static std::string element_text(const Drawing_node& n) {
    return Drawing_element{"", std::string(n.name), n.attributes.text("id"), n.line}.text();
  }

  // An element is not read, with all that stands in it.
  void leave_out(std::size_t i, const std::string& reason) {
    handler_.not_read(element(i), reason);
    define(i);
  }

  // Calls action() and returns why the element cannot be read; nothing where it can.
  template <class Action> static std::optional<std::string> refusal(Action action) {
    try {
      action();
      return std::nullopt;
    } catch (const Not_covered& x) {
      return x.reason;
    } catch (const GC::Error& error) {
      return GC::svg_reason(error);
    }
  }

  // Hands on the paths in an element that is not drawn.
  void define(std::size_t begin) {
    if (!takes_paths_ || is_repetition()) return;
    for (std::size_t i = begin; i < node(begin).end; ++i)
      if (node(i).name == "path" && node(i).attributes.has("d")) {
        Drawing_element element = this->element(i);
        element.is_filled = is_filled_where_it_stands(i);
        hand_on(element, node(i), repeated_.count(i) != 0 ? Path_role::repeated : Path_role::defined);
      }
  }

  void hand_on(Drawing_element element, const Drawing_node& n, Path_role role) {
    const std::string& value = n.attributes.text("d");
    element.decimals = most_decimals(value);
    const std::string place = file_ + ':' + std::to_string(n.line) + ": " + element.name +
                              (element.id.empty() ? "" : " \"" + element.id + '"') + ", d";
    handler_.path(element, {value, place, Attribute_text(n.tag, n.tag_begin, "d", value), role});
  }

  // Returns the elements from the root on to one of them, as selectors see them.
  std::vector<Styled_element> path_to(std::size_t i) const {
    std::vector<Styled_element> path;
    for (std::size_t k = i;; k = node(k).parent) {
      const Drawing_attributes& a = node(k).attributes;
      path.push_back({node(k).name, a.text("id"), a.text("class")});
      if (k == node(k).parent) break;
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  // Why the outline of an element may be another one than is written; nothing where it may not.
  std::optional<std::string> change(std::size_t i, const Drawing_attributes& attributes) const {
    if (node(i).animated_in_line != 0) return "it is animated in line " + std::to_string(node(i).animated_in_line);
    if (document_.sheets.is_empty()) return std::nullopt;
    return document_.sheets.change(path_to(i), has_transform(attributes));
  }

  // Style sheets are not applied: an element counts as filled where a rule may fill it, and where
  // one of them speaks of the property and the element does not. A style comes before a rule that
  // is not important, and a rule before an attribute.
  bool is_filled(std::size_t i, bool inherited) const {
    const Drawing_attributes& attributes = node(i).attributes;
    const bool has_style = attributes.has("style fill");
    if (document_.sheets.has_fills() && document_.sheets.may_fill(path_to(i), has_style)) return true;
    const std::string_view value =
        Style_text::trimmed(std::string_view(attributes.text(has_style ? "style fill" : "fill")));
    if (value.empty() || value == "inherit") return inherited || document_.sheets_set_fill;
    return value != "none" && value != "transparent";
  }

  // Takes an element that is not drawn there.
  bool is_filled_where_it_stands(std::size_t i) const {
    const std::size_t parent = node(i).parent;
    return is_filled(i, parent == i || is_filled_where_it_stands(parent));
  }

  // Visits an element. Returns whether to go on with those that it holds.
  bool visit(std::size_t i) {
    const Drawing_node& n = node(i);
    const Part& part = parts_.back();
    const bool is_target = i == part.target;
    if (is_skipped_in_drawings(n.name) && !(is_target && n.name == "symbol")) {
      define(i);
      return false;
    }
    Drawing_attributes styled;
    const Drawing_attributes* attributes = &n.attributes;
    Drawing_frame frame = frames_.empty() ? Drawing_frame() : frames_.back().frame;
    const std::optional<std::string> reason = refusal([&] {
      if (n.attributes.has("style")) {
        styled = styled_attributes(n, document_.sheets, frames_.empty());
        attributes = &styled;
      }
      if (const std::optional<std::string> changed = change(i, *attributes)) throw Not_covered{*changed};
      if (frames_.empty() && (document_.sheets.is_empty() || attributes->has("viewBox")))
        frame.viewport = outermost_viewport(*attributes);
      frame.is_filled = is_filled(i, frame.is_filled);
      place(*attributes, frame);
      if (n.name == "symbol" || (n.name == "svg" && !frames_.empty()))
        frame = inner_frame(frame, *attributes, is_target ? part.size : Repeated_size());
      if (frames_.size() >= most_nested)
        throw Not_covered{"elements are nested deeper than " + std::to_string(most_nested) +
                          ", with those that are repeated"};
    });
    if (reason) {
      leave_out(i, *reason);
      return false;
    }
    draw(i, *attributes, frame);
    if (n.end == i + 1 || n.name == "use") return false;
    frames_.push_back({std::move(frame), n.end});
    return true;
  }

  static void place(const Drawing_attributes& attributes, Drawing_frame& frame) {
    if (!has_transform(attributes)) return;
    const Drawing_map map = own_transform(attributes, frame.viewport);
    try {
      frame = frame.inner(map);
    } catch (const GC::Error& error) {
      throw Not_covered{"transform, with the groups around: " + GC::svg_reason(error)};
    }
  }

  void draw(std::size_t i, const Drawing_attributes& a, const Drawing_frame& frame) {
    const std::string_view name = node(i).name;
    if (name == "path")
      draw_path(i, a, frame);
    else if (name == "polyline" || name == "polygon")
      draw_points(i, a, frame);
    else if (name == "use")
      repeat(i, a, frame);
    else if (name == "line" || name == "circle" || name == "ellipse" || name == "rect") {
      Drawing_subpath path;
      const auto read = [&] { path = shape(name, Drawing_lengths(a, frame.viewport)); };
      if (const std::optional<std::string> reason = refusal(read)) return handler_.not_read(element(i), *reason);
      Drawing_element shape_element = placed(i, frame);
      shape_element.has_percentages = a.has_percentages();
      hand_on(shape_element, 1, std::move(path));
    }
  }

  Drawing_element placed(std::size_t i, const Drawing_frame& frame) const {
    Drawing_element e = element(i);
    e.transform = frame.map;
    e.is_filled = frame.is_filled;
    return e;
  }

  static Drawing_subpath shape(std::string_view name, const Drawing_lengths& a) {
    const Drawing_number zero(0);
    if (name == "line") return GC::svg_line<Drawing_traits>(a.x("x1"), a.y("y1"), a.x("x2"), a.y("y2"));
    if (name == "circle") {
      const Drawing_number r = a.radius("r").value_or(zero);
      return GC::svg_ellipse<Drawing_traits>(a.x("cx"), a.y("cy"), r, r);
    }
    // when one radius is missing, it is equal to the other one
    const bool is_horizontal = a.is_given("rx"), is_vertical = a.is_given("ry");
    const Drawing_number rx = (is_horizontal ? a.width("rx") : a.height("ry")).value_or(zero),
                         ry = (is_vertical ? a.height("ry") : a.width("rx")).value_or(zero);
    if (name == "ellipse") return GC::svg_ellipse<Drawing_traits>(a.x("cx"), a.y("cy"), rx, ry);
    return GC::svg_rectangle<Drawing_traits>(a.x("x"), a.y("y"), a.width("width").value_or(zero),
                                             a.height("height").value_or(zero), rx, ry);
  }

  void draw_path(std::size_t i, const Drawing_attributes& a, const Drawing_frame& frame) {
    const Drawing_node& n = node(i);
    const std::string& value = a.text("d");
    Drawing_element element = placed(i, frame);
    if (Style_text::trimmed(value) == "none" || !a.has("d")) return;
    if (takes_paths_) {
      const bool is_drawn = frame.map.determinant() != 0;
      if (!is_repetition()) return hand_on(element, n, is_drawn ? Path_role::drawn : Path_role::defined);
      if (is_drawn) hand_on(element, n, Path_role::repetition);
      return;
    }
    element.decimals = most_decimals(value);
    Attribute_lines lines(n.tag, n.line, "d", value);
    element.lines = &lines;
    GC::Svg_path_reader<Drawing_traits> reader(value, "d");
    for (int number = 1;; ++number) {
      std::optional<Drawing_subpath> subpath;
      std::string error;
      try {
        subpath = reader.next();
      } catch (const GC::Error& e) {
        error = GC::svg_reason(e);
        subpath = reader.before_error();
      }
      if (subpath) hand_on(element, number, *std::move(subpath));
      if (!error.empty()) return handler_.not_read(element, error + what_follows);
      if (!subpath) return;
    }
  }

  void draw_points(std::size_t i, const Drawing_attributes& a, const Drawing_frame& frame) {
    Drawing_element element = placed(i, frame);
    const std::string& points = a.text("points");
    element.decimals = a.has("points") ? most_decimals(points) : -1;
    std::string error;
    hand_on(element, 1,
            element.name == "polygon" ? GC::read_svg_polygon<Drawing_traits>(points, "points", &error)
                                      : GC::read_svg_polyline<Drawing_traits>(points, "points", &error));
    if (!error.empty()) handler_.not_read(element, error + what_follows);
  }

  void hand_on(const Drawing_element& element, int number, Drawing_subpath subpath) {
    subpath.leave_out_points();
    if (element.is_filled) subpath.join_ends();
    if (subpath.segments.empty() && subpath.left_out == 0) return;
    const Drawing_map& map = element.transform;
    if (map.matrix() == Drawing_map().matrix())
      handler_.subpath(element, number, subpath);
    else if (map.determinant() != 0)
      handler_.subpath(element, number, subpath.transform(map));
    else if (number == 1)
      handler_.not_read(element, "it is not drawn, because its transform is not invertible");
  }

  // Returns the element that a use element repeats. Throws Not_covered where there is none.
  std::size_t target(std::size_t use) const {
    const Drawing_node& n = node(use);
    const std::string_view id = Drawing_document::reference(n);
    if (!n.attributes.has("href")) throw Not_covered{"it does not say which element it repeats"};
    if (id.empty()) throw Not_covered{"the element that it repeats stands in another file"};
    const std::size_t found = document_.find(id);
    if (found == none()) throw Not_covered{"there is no element \"" + std::string(id) + "\" in this file to repeat"};
    const bool repeats_itself =
        (found <= use && use < node(found).end) ||
        std::any_of(parts_.begin(), parts_.end(), [&](const Part& p) { return p.target == found; });
    if (repeats_itself) throw Not_covered{"it repeats itself"};
    return found;
  }

  // Goes on with what a use element repeats.
  void repeat(std::size_t i, const Drawing_attributes& a, Drawing_frame frame) {
    Part part{};
    part.use = i;
    const std::optional<std::string> reason = refusal([&] {
      part.target = part.next = target(i);
      part.end = node(part.next).end;
      const std::string name(node(part.target).name);
      if (name == "text" || name == "image") return; // no outline
      if (is_skipped_in_drawings(name) && name != "symbol")
        throw Not_covered{"it repeats a " + name + ", which is not drawn"};
      const Drawing_lengths lengths(a, frame.viewport);
      const bool has_size = name == "symbol" || name == "svg";
      if (has_size) part.size = {lengths.width("width"), lengths.height("height")};
      frame = frame.inner(GC::Svg_transform_product<Drawing_traits>::translation(lengths.x("x"), lengths.y("y")));
      const std::size_t end = part.end == none() ? document_.bytes : node(part.end).bytes_before;
      repetition_ += end - node(part.target).bytes_before;
      if (repetition_ > (std::max)(free_repetition, most_repetitions * document_.bytes))
        throw Not_covered{"more than " + std::to_string(free_repetition >> 20) +
                          " MiB of elements, and ten times the drawing, would be repeated"};
    });
    if (reason) return leave_out(i, *reason);
    part.frames = frames_.size();
    frames_.push_back({std::move(frame), part.end});
    parts_.push_back(part);
  }

  // Finds what the use elements repeat that are drawn.
  void find_repeated() {
    std::vector<std::pair<std::size_t, std::size_t>> ranges{{0, none()}};
    while (!ranges.empty()) {
      auto& [next, end] = ranges.back();
      if (next == end) {
        ranges.pop_back();
        continue;
      }
      const std::size_t i = next;
      const bool is_first = ranges.size() == 1 || repeated_.insert(i).second;
      next = is_skipped_in_drawings(node(i).name) && node(i).name != "symbol" ? node(i).end : i + 1;
      if (ranges.size() == 1 && node(i).name == "symbol") next = node(i).end;
      if (node(i).name != "use" || !is_first) continue;
      const std::size_t found = document_.find(Drawing_document::reference(node(i)));
      if (found != none() && repeated_.count(found) == 0) ranges.emplace_back(found, node(found).end);
    }
  }

public:
  Drawing_walk(const std::string& file, const Drawing_document& document, Drawing_handler& handler)
      : file_(file), document_(document), handler_(handler) {}

  void operator()() {
    for (const long long line : document_.outside_sheets) leave_out_sheet("xml-stylesheet", line);
    for (const long long line : document_.sheets.imports) leave_out_sheet("style", line);
    if (takes_paths_) find_repeated();
    parts_.push_back({0, none(), 0, none(), none(), {}});
    while (!parts_.empty()) {
      Part& part = parts_.back();
      if (part.next == part.end) {
        frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(part.frames), frames_.end());
        parts_.pop_back();
        continue;
      }
      const std::size_t i = part.next;
      // the first frame of a repetition is that of the use element
      while (frames_.size() > part.frames && frames_.back().end <= i) frames_.pop_back();
      if (!is_repetition()) handler_.progress(double(node(i).bytes_before) / double(document_.bytes));
      const std::size_t number = parts_.size() - 1;
      const bool goes_on = visit(i);
      parts_[number].next = goes_on ? i + 1 : node(i).end;
    }
  }

private:
  void leave_out_sheet(const char* name, long long line) {
    handler_.not_read({file_, name, "", line}, "a style sheet in another file may change elements");
  }
};

} // namespace

std::string Drawing_element::text() const {
  return name + (id.empty() ? "" : " \"" + id + '"') + " (line " + std::to_string(line) + ')' +
         (repeated_by.empty() ? "" : ", repeated by " + repeated_by);
}

void read_svg_drawing(std::istream& stream, const std::string& name, Drawing_handler& handler) {
  const Drawing_tags tags = handler.takes_paths() ? Drawing_tags::all : Drawing_tags::with_lines;
  const Drawing_document document = read_drawing_document(stream, name, tags);
  Drawing_walk(name, document, handler)();
}

void read_svg_drawing(const std::string& file, Drawing_handler& handler) {
  Input stream(file);
  read_svg_drawing(stream, input_name(file), handler);
}
