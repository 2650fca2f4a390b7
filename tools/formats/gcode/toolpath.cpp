// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/gcode/toolpath.h"

#include "files/input.h"
#include "formats/gcode/Gcode_block.h"

#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_rational Number;
typedef GC::Coordinate_vector<Number, 2> Plane_point;

// X, Y and Z; what the program has not told is empty.
typedef std::array<std::optional<Number>, 3> Position;

Plane_point quarter_turn(const Plane_point& v) {
  Plane_point r(2);
  r[0] = -v[1];
  r[1] = v[0];
  return r;
}

Drawing_traits::Point kernel_point(const Plane_point& x) { return GC::to_point<Drawing_traits>(x); }

// Collects the segments of one subpath after the other, and what is not read.
class Toolpath_builder {
  Drawing_handler& handler_;
  Drawing_element element_;
  Drawing_subpath path_;
  int number_ = 0, decimals_ = 0;
  bool has_units_ = true;
  std::string reason_;
  long long first_line_ = 0, last_line_ = 0; // of what is not read for this reason

  void add(GC::Path_segment<Drawing_traits> segment, long long line, char letter) {
    end_of_unread();
    path_.segments.push_back({std::move(segment), line, letter, 0});
  }

public:
  Toolpath_builder(const std::string& file, Drawing_handler& handler) : handler_(handler) {
    element_.file = file;
    element_.name = "toolpath";
    element_.path = [] { return std::string("toolpath"); };
  }

  // Takes the number of decimals of a coordinate; from a conversion of units on there are none.
  void take_decimals(int decimals, bool is_converted) {
    has_units_ = has_units_ && !is_converted;
    decimals_ = (std::max)(decimals_, decimals);
    element_.decimals = has_units_ ? decimals_ : -1;
  }

  void bezier(const std::vector<Plane_point>& points, long long line, char letter) {
    GC::Path_segment<Drawing_traits> segment;
    segment.curve.emplace<GC::Bezier_curve<Drawing_traits>>(points);
    add(std::move(segment), line, letter);
  }

  // An arc around a point that is as far from one end as from the other. With u from the centre to
  // the start, it is an arc of the unit circle in the coordinates of u and its quarter turn.
  void arc(const Plane_point& start, const Plane_point& end, const Plane_point& centre, bool left, long long line,
           char letter) {
    const Plane_point u = start - centre, v = quarter_turn(u), w = end - centre;
    const Number square = dot(u, u), cosine = dot(w, u) / square, sine = dot(w, v) / square;
    const bool large = left ? sine < 0 : sine > 0;
    const GC::Elliptical_arc<Drawing_traits> unit(Drawing_traits::Point(1, 0), Drawing_traits::Point(cosine, sine),
                                                  {1, 1, 0, large, left});
    const GC::Svg_transform<Drawing_traits> map({u[0], u[1], v[0], v[1], centre[0], centre[1]});
    add({unit.transform(map)}, line, letter);
  }

  void circle(const Plane_point& start, const Plane_point& centre, bool left, long long line, char letter) {
    const Plane_point opposite = Number(2) * centre - start;
    arc(start, opposite, centre, left, line, letter);
    arc(opposite, start, centre, left, line, letter);
  }

  void arc_of_radius(const Plane_point& start, const Plane_point& end, const Number& radius, bool left, long long line,
                     char letter) {
    const Number r = radius < 0 ? Number(-radius) : radius;
    add({GC::Elliptical_arc<Drawing_traits>(kernel_point(start), kernel_point(end), {r, r, 0, radius < 0, left})}, line,
        letter);
  }

  // The tool stops cutting.
  void end_of_subpath() {
    if (path_.segments.empty()) return;
    path_.join_ends();
    element_.line = path_.segments.front().command;
    handler_.subpath(element_, ++number_, path_);
    path_ = {};
  }

  void not_read(const std::string& reason, long long line) {
    end_of_subpath();
    if (reason != reason_) {
      end_of_unread();
      reason_ = reason;
      first_line_ = line;
    }
    last_line_ = line;
  }

  void end_of_unread() {
    if (reason_.empty()) return;
    element_.line = first_line_;
    handler_.not_read(element_,
                      reason_ + (first_line_ == last_line_ ? "" : " (up to line " + std::to_string(last_line_) + ')'));
    reason_.clear();
  }
};

// Executes a program line by line.
class Toolpath_reader {
  static constexpr std::string_view axes_ = "XYZ", offsets_ = "IJK";
  Toolpath_builder path_;
  long long line_ = 0;
  Position position_;
  int motion_ = -1; // ten times the number behind G; -1 for none
  int plane_ = 17;
  bool relative_ = false, absolute_centre_ = false, diameter_ = false;
  bool extrudes_ = false, extrudes_relative_ = false;
  Number extruded_ = 0;
  std::optional<Number> unit_;                          // of the coordinates that are handed on, in millimetres
  Number factor_ = 1;                                   // from the unit of the program to it
  std::optional<std::pair<Number, Number>> last_cubic_; // from the second handle of G5 to its end

  // The numbers of the axes of the plane, first and second, and that across it.
  std::array<std::size_t, 3> plane() const {
    if (plane_ == 18) return {2, 0, 1};
    if (plane_ == 19) return {1, 2, 0};
    return {0, 1, 2};
  }

  void forget_position() { position_ = {}; }

  // The millimetres in the unit of the program.
  void set_unit(const Number& millimetres) {
    if (!unit_) unit_ = millimetres;
    factor_ = millimetres / *unit_;
  }

  // The value of an axis word in the coordinates that are handed on.
  Number length(const Gcode_word& word) {
    path_.take_decimals(word.decimals, factor_ != 1);
    return factor_ * *word.number;
  }

  // Where the move leads; an axis of which that is not known is empty.
  Position target(const Gcode_block& block) {
    Position to = position_;
    for (std::size_t i = 0; i < 3; ++i) {
      const Gcode_word* const word = block.word(axes_[i]);
      if (word == nullptr) continue;
      to[i].reset();
      if (!word->number) continue;
      Number x = length(*word);
      if (i == 0 && diameter_) x /= 2;
      if (!relative_)
        to[i] = x;
      else if (position_[i])
        to[i] = Number(*position_[i] + x);
    }
    return to;
  }

  Plane_point in_plane(const Position& p) const {
    Plane_point r(2);
    for (std::size_t i = 0; i < 2; ++i) r[static_cast<int>(i)] = *p[plane()[i]];
    return r;
  }

  static bool is_number(const Gcode_word* word) { return word == nullptr || word->number; }

  // Moves to `to` along a line, an arc or another curve.
  void feed(const Gcode_block& block, const Position& to) {
    const std::array<std::size_t, 3> axis = plane();
    const auto moves = [&](std::size_t i) { return block.word(axes_[i]) != nullptr && to[i] != position_[i]; };
    const bool is_arc = motion_ == 20 || motion_ == 30;
    const bool across = moves(axis[2]), along = is_arc || moves(axis[0]) || moves(axis[1]);
    const Position from = std::exchange(position_, to);
    if (block.has_any("ABCUVW")) return path_.not_read("it moves a rotary or a second linear axis", line_);
    if (!along) return across ? path_.end_of_subpath() : void();
    for (const Position* p : {&from, &to})
      for (std::size_t i = 0; i < 2; ++i)
        if (!(*p)[axis[i]]) return path_.not_read(unknown(block), line_);
    if (across) return path_.not_read("it moves along three axes at once, and joins are decided in a plane", line_);
    const Plane_point start = in_plane(from), end = in_plane(to);
    switch (motion_) {
    case 10: return path_.bezier({start, end}, line_, '1');
    case 20:
    case 30: return arc(block, start, end);
    default: return spline(block, start, end);
    }
  }

  // Why a position is not known.
  static std::string unknown(const Gcode_block& block) {
    const bool computed = std::any_of(block.words.begin(), block.words.end(), [](const Gcode_word& w) {
      return !w.number && axes_.find(w.letter) != axes_.npos;
    });
    return computed ? "a coordinate is given by a parameter or an expression"
                    : "where the move starts or ends is not told by the program";
  }

  void arc(const Gcode_block& block, const Plane_point& start, const Plane_point& end) {
    const bool left = motion_ == 30;
    const char letter = left ? '3' : '2';
    if (const Gcode_word* const r = block.word('R')) {
      if (!r->number) return path_.not_read("the radius of the arc is given by a parameter or an expression", line_);
      const Number radius = length(*r);
      if (start == end) return path_.not_read("the arc has a radius, and ends where it starts", line_);
      const Plane_point chord = end - start;
      const Number square = dot(chord, chord), diameter = 2 * radius;
      if (diameter * diameter * Number(1002001) / 1000000 < square)
        return path_.not_read("the radius of the arc is less than half the distance of its ends", line_);
      return path_.arc_of_radius(start, end, radius, left, line_, letter);
    }
    const std::array<std::size_t, 3> axis = plane();
    Plane_point centre = start;
    bool is_given = false;
    for (std::size_t i = 0; i < 2; ++i) {
      const Gcode_word* const word = block.word(offsets_[axis[i]]);
      if (!is_number(word))
        return path_.not_read("the centre of the arc is given by a parameter or an expression", line_);
      if (word == nullptr) continue;
      is_given = true;
      const Number x = length(*word);
      centre[static_cast<int>(i)] = absolute_centre_ ? x : Number(start[static_cast<int>(i)] + x);
    }
    if (!is_given || centre == start) return path_.not_read("the arc has no radius and no centre", line_);
    if (start == end) return path_.circle(start, centre, left, line_, letter);
    const Plane_point nearest = centre_on_bisector(start, end, centre);
    if (!are_radii_equal(start - centre, end - centre))
      return path_.not_read("the ends of the arc are not equally far from its centre", line_);
    path_.arc(start, end, nearest, left, line_, letter);
  }

  static Plane_point centre_on_bisector(const Plane_point& start, const Plane_point& end, const Plane_point& centre) {
    const Plane_point middle = (start + end) / Number(2), normal = quarter_turn(end - start);
    return middle + (dot(centre - middle, normal) / dot(normal, normal)) * normal;
  }

  // |r - s| <= d for the lengths r, s of u, v and the larger d of 0.005 mm and r/1000: in squares,
  // (r^2 + s^2 - d^2)^2 <= 4 r^2 s^2 unless the left side is negative before it is squared.
  bool are_radii_equal(const Plane_point& u, const Plane_point& v) const {
    const Number rr = dot(u, u), ss = dot(v, v), fixed = Number(5) / 1000 / unit_.value_or(Number(1));
    const Number dd = (std::max)(Number(fixed * fixed), Number(rr / 1000000)), rest = rr + ss - dd;
    return rest < 0 || rest * rest <= 4 * rr * ss;
  }

  // Cubics and quadratics, with the handles relative to the ends.
  void spline(const Gcode_block& block, const Plane_point& start, const Plane_point& end) {
    if (plane_ != 17) return path_.not_read("splines lie in the plane G17", line_);
    const std::string_view letters = motion_ == 51 ? "IJ" : "IJPQ";
    std::array<Number, 4> handle{0, 0, 0, 0};
    std::size_t given = 0;
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (const Gcode_word* const word = block.word(letters[i])) {
        if (!word->number) return path_.not_read("a handle is given by a parameter or an expression", line_);
        handle[i] = length(*word);
        ++given;
      } else if (i < 2 && last_cubic_ && motion_ == 50 && !block.has_any("IJ")) // the handle before is mirrored
        handle[i] = i == 0 ? last_cubic_->first : last_cubic_->second;
      else if (i >= 2)
        return path_.not_read("a cubic without P and Q", line_);
    if (given == 0) return path_.not_read("a spline without handles", line_);
    const auto moved = [](const Plane_point& p, const Number& x, const Number& y) {
      Plane_point r(2);
      r[0] = p[0] + x;
      r[1] = p[1] + y;
      return r;
    };
    if (motion_ == 51) {
      path_.bezier({start, moved(start, handle[0], handle[1]), end}, line_, '5');
      return last_cubic_.reset();
    }
    path_.bezier({start, moved(start, handle[0], handle[1]), moved(end, handle[2], handle[3]), end}, line_, '5');
    last_cubic_ = {Number(-handle[2]), Number(-handle[3])};
  }

  // Returns whether material flows during the move.
  bool extrudes(const Gcode_block& block) {
    const Gcode_word* const e = block.word('E');
    if (e == nullptr) return false;
    extrudes_ = true;
    if (!e->number) return true;
    const Number before = std::exchange(extruded_, *e->number);
    return extrudes_relative_ ? *e->number > 0 : *e->number > before;
  }

  void move(const Gcode_block& block) {
    const bool extrudes = this->extrudes(block);
    const bool is_arc = motion_ == 20 || motion_ == 30;
    if (!block.has_any("XYZABCUVW") && !(is_arc && block.has_any("IJKR"))) return;
    if (motion_ != 50) last_cubic_.reset();
    if (motion_ == 10 || is_arc || motion_ == 50 || motion_ == 51) {
      if (extrudes_ && !extrudes) {
        path_.end_of_subpath();
        position_ = target(block);
        return;
      }
      if (!unit_) unit_ = Number(1);
      const Position to = target(block);
      return feed(block, to);
    }
    path_.end_of_subpath();
    const Position to = target(block);
    if (motion_ == 0 || motion_ == 730 || (810 <= motion_ && motion_ <= 890)) { // rapid moves and holes
      position_ = to;
      return;
    }
    forget_position();
    path_.not_read(motion_ == -1 ? "a position without a move before it"
                                 : "G" + code_text(motion_) + " is not a move that is verified",
                   line_);
  }

  static std::string code_text(int code) {
    return std::to_string(code / 10) + (code % 10 == 0 ? "" : "." + std::to_string(code % 10));
  }

  // Executes one word G. Returns whether the axis words of the line belong to it.
  bool execute_g(int code, const Gcode_block& block) {
    switch (code) {
    case 70:
    case 80: diameter_ = code == 70; return false;
    case 170:
    case 180:
    case 190:
      if (plane_ != code / 10) path_.end_of_subpath();
      plane_ = code / 10;
      return false;
    case 200:
    case 210: set_unit(code == 200 ? Number(254) / 10 : Number(1)); return false;
    case 900:
    case 910: relative_ = code == 910; return false;
    case 901:
    case 911: absolute_centre_ = code == 901; return false;
    case 100:
    case 280:
    case 281:
    case 300:
    case 301:
    case 530:
      path_.end_of_subpath();
      forget_position();
      return true;
    case 920:
    case 921:
    case 922:
    case 923:
      path_.end_of_subpath();
      if (const Gcode_word* const e = block.word('E'); e != nullptr && e->number) extruded_ = *e->number;
      if (code == 920 && block.has_any("XYZ"))
        position_ = [&] {
          const bool relative = std::exchange(relative_, false);
          const Position p = target(block);
          relative_ = relative;
          return p;
        }();
      else if (code != 920)
        forget_position();
      return true;
    case 40: return true; // a dwell
    default: break;
    }
    if (540 <= code && code <= 593) {
      path_.end_of_subpath();
      forget_position();
      return false;
    }
    if (code == 0 || code == 10 || code == 20 || code == 30 || code == 50 || code == 51 || code == 52 || code == 53 ||
        code == 330 || code == 331 || (380 <= code && code <= 389) || code == 730 || code == 740 || code == 760 ||
        (810 <= code && code <= 890)) {
      motion_ = code;
      return false;
    }
    if (code == 800) {
      motion_ = -1;
      return false;
    }
    static const std::set<int> without_effect = {400, 410, 411, 420, 421, 430, 431, 432, 490, 520,
                                                 610, 611, 640, 930, 940, 950, 960, 970, 980, 990};
    if (without_effect.count(code) != 0) return false;
    path_.end_of_subpath();
    forget_position();
    path_.not_read("G" + code_text(code) + " is not known", line_);
    return true;
  }

  // Ten times the number of a code; -1 for what is none.
  static int code(const Number& number) {
    return number < 0 || 1000 < number ? -1 : static_cast<int>(CGAL::to_double(number * 10) + 0.5);
  }

  // Executes a line. Returns whether the program goes on.
  bool execute(const Gcode_block& block) {
    if (!block.error.empty()) {
      forget_position();
      path_.not_read(block.error, line_);
      return true;
    }
    if (block.is_control) {
      path_.not_read("subprograms, loops and conditions are not followed, and the program is not read beyond", line_);
      return false;
    }
    if (block.is_optional) {
      if (!block.words.empty()) {
        forget_position();
        path_.not_read("an optional line", line_);
      }
      return true;
    }
    bool axes_are_taken = false;
    for (const Gcode_word& word : block.words) {
      if (word.letter != 'G' && word.letter != 'M') continue;
      if (!word.number) {
        forget_position();
        path_.not_read("a code is given by a parameter or an expression", line_);
        return true;
      }
      const int code = this->code(*word.number);
      if (word.letter == 'G')
        axes_are_taken = execute_g(code, block) || axes_are_taken;
      else if (code == 20 || code == 300)
        return false;
      else if (code == 820 || code == 830)
        extrudes_relative_ = code == 830;
      else if (code == 980) {
        path_.not_read("subprograms are not followed, and the program is not read beyond", line_);
        return false;
      }
    }
    if (!axes_are_taken) move(block);
    return true;
  }

public:
  Toolpath_reader(const std::string& name, Drawing_handler& handler) : path_(name, handler) {}

  void read(std::istream& stream) {
    bool has_begun = false;
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      const Gcode_block block(line);
      if (block.is_mark ? has_begun : !execute(block)) break; // a second sign is the end
      has_begun = has_begun || block.is_mark || !block.words.empty();
    }
    path_.end_of_subpath();
    path_.end_of_unread();
  }
};

} // namespace

void read_toolpath(std::istream& stream, const std::string& name, Drawing_handler& handler) {
  Toolpath_reader(name, handler).read(stream);
}

bool begins_as_gcode(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == ';' || c == '(' || c == '%')
      i = (std::min)(text.find('\n', i), text.size());
    else if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      ++i;
    else
      return i + 1 < text.size() && std::string_view("GMTNOgmtno").find(c) != std::string_view::npos &&
             '0' <= text[i + 1] && text[i + 1] <= '9';
  }
  return false;
}

bool is_toolpath_file(const std::string& file) {
  std::string ending = file.substr((std::min)(file.rfind('.'), file.size()));
  for (char& c : ending)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const char* known : {".ngc", ".nc", ".gcode", ".gco", ".cnc", ".tap"})
    if (ending == known) return true;
  return (ending.empty() || ending.find('/') != std::string::npos || is_standard_input(file)) &&
         begins_as_gcode(beginning_of_text(file));
}
