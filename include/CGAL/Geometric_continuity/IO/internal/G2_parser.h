// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_plane.h>
#include <CGAL/Geometric_continuity/IO/internal/Token_reader.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// A class of objects of the format, and what it is called in messages.
struct G2_class {
  int number;
  const char* name;   // "curve"
  const char* bezier; // "Bezier curves"
};
constexpr G2_class g2_curves{100, "curve", "Bezier curves"};
constexpr G2_class g2_surfaces{200, "surface", "Bezier patches"};

// Other classes of the format, for messages.
struct G2_other_class {
  int number;
  const char* name;
};
constexpr G2_other_class g2_other_classes[] = {{110, "curve on a surface"},
                                               {130, "circle"},
                                               {140, "ellipse"},
                                               {150, "bounded curve"},
                                               {160, "hyperbola"},
                                               {170, "parabola"},
                                               {210, "bounded surface"},
                                               {260, "cylinder"},
                                               {261, "extrusion"},
                                               {270, "sphere"},
                                               {280, "cone"},
                                               {290, "torus"},
                                               {291, "surface of revolution"},
                                               {292, "disc"}};
constexpr int g2_line = 120;

// Which knots are allowed.
enum class G2_shape {
  bezier, // two, each repeated as often as the order says
  spline  // all that Knot_vector takes
};

// Tells whether rational objects are read.
enum class G2_weights { refused, allowed };

// The numbers of control points and the order in one parameter of a spline.
struct G2_size {
  int points, order;
};

// The text gives these numbers for one parameter of a spline.
template <class FT> struct G2_direction : G2_size { std::vector<FT> knots; };

// Reads the parts of the objects of one class in a `.g2` text, one after the other. Everything that
// is not as it should be is refused with file, line and reason. `FT` is the type of the numbers;
// `N` is the dimension, or 0 where the text tells it.
template <class FT, int N, class Concurrency_tag = Sequential_tag> class G2_parser {
  typedef G2_direction<FT> Direction;

  Token_reader<Concurrency_tag> tokens_;
  G2_class class_;
  G2_weights weights_;
  int dimension_ = 0; // of the first object
  bool empty_ = true, rational_ = false, is_line_ = false, is_plane_ = false;
  bool at_header_ = false;      // whether the current word is the first of the next object
  std::vector<FT> line_knots_;  // of a line or plane, which is read as a whole: a spline of order 2
  std::vector<FT> line_points_; // and the coordinates of its ends or corners

public:
  // A point, and a point with its weight, in homogeneous coordinates (w x, w), as exact numbers.
  typedef typename Exact_field<FT>::type Exact;
  typedef Coordinate_vector<FT, N> Row;
  typedef Coordinate_vector<Exact, (N == 0 ? 0 : N + 1)> Homogeneous_row;

  G2_parser(std::istream& is, std::string name, const G2_class& object_class, G2_weights weights = G2_weights::refused)
      : tokens_(is, std::move(name)), class_(object_class), weights_(weights) {}

  // The line of the last word that was read.
  long long line() const { return tokens_.line(); }

  // The last word that was read: where it begins in the text, in bytes, and where it ends.
  std::pair<std::size_t, std::size_t> place() const {
    return {tokens_.place(), tokens_.place() + tokens_.token().size()};
  }

  // Returns whether the current object is a line, whose control points are not in the text.
  bool is_line() const { return is_line_; }

  // Returns whether the current object has weights.
  bool rational() const { return rational_; }

  // Reads the header and the dimension of the next object. Returns false at the end of the text.
  bool next_object() {
    if (!at_header_ && !tokens_.advance()) {
      if (empty_) tokens_.refuse(std::string("no ") + class_.name);
      return false;
    }
    empty_ = at_header_ = false;
    read_header();
    read_dimension();
    if (is_line_)
      read_line();
    else if (is_plane_)
      read_plane();
    else
      read_rational_flag();
    return true;
  }

  // Reads the number of points and the order; for Bezier shapes they are equal. `in` names the
  // parameter of a surface, e.g. " in u".
  G2_size read_size(G2_shape shape, const char* in = "") {
    if (is_line_ || is_plane_) return {2, 2};
    const bool bezier = shape == G2_shape::bezier;
    const int points = read_integer("number of control points", 1, (std::numeric_limits<int>::max)(), in),
              order = read_integer("order", 1, max_g2_order, in);
    const auto refuse = [&](const std::string& reason) {
      tokens_.refuse(std::to_string(points) + " control points and order " + std::to_string(order) + in + ": " +
                     reason);
    };
    if (points < order)
      refuse(std::string("there must be ") + (bezier ? "" : "at least ") + "as many control points as the order says");
    if (bezier && points > order) refuse(std::string("inner knots are not supported, only ") + class_.bezier);
    return {points, order};
  }

  // Appends all knots, as `Knot_vector` takes them, to an empty sequence; for Bezier shapes there
  // are no inner knots.
  template <class Knots> void read_knots(Knots& knots, const G2_size& size, G2_shape shape, const char* in = "") {
    const std::size_t all = static_cast<std::size_t>(size.points) + size.order;
    if (is_line_ || is_plane_) {
      for (int i = 0; i < 4; ++i) knots.push_back(typename Knots::value_type(line_knots_[i]));
      line_knots_.erase(line_knots_.begin(), line_knots_.begin() + 4);
    }
    // the number of the first knot that is equal to the last one
    for (std::size_t first = 0; knots.size() < all;) knots.push_back(read_knot(knots, first, size, all, shape, in));
  }

  // Reads the size and the knots in one parameter.
  Direction read_direction(G2_shape shape, const char* in = "") {
    Direction d{read_size(shape, in), {}};
    read_knots(d.knots, d, shape, in);
    return d;
  }

  // The number of coordinates of a point.
  int dimension() const { return dimension_; }

  // Reads the control point after `done` of `all`.
  Row read_point(long long done, long long all) {
    Row x(dimension_);
    for (int i = 0; i < dimension_; ++i) x[i] = read_coordinate(i, done, all);
    return x;
  }

  // Reads one coordinate of the control point after `done` of `all`.
  FT read_coordinate(int i, long long done, long long all) {
    return is_line_ || is_plane_ ? line_points_[static_cast<std::size_t>(done * dimension_ + i)]
                                 : read_number<FT>(done, all, "control points");
  }

  // Reads one homogeneous coordinate of the control point after `done` of `all` of a rational
  // object.
  Exact read_homogeneous_coordinate(long long done, long long all) {
    return read_number<Exact>(done, all, "control points");
  }

  // Reads the control point after `done` of `all` of a rational object.
  Homogeneous_row read_homogeneous_point(long long done, long long all) {
    Homogeneous_row row(dimension_ + 1);
    for (int i = 0; i <= dimension_; ++i) row[i] = read_homogeneous_coordinate(done, all);
    return row;
  }

  // Returns f(), and refuses what is wrong with the object that has been read: a denominator that
  // is not positive, or a quotient that is too large.
  template <class Function> auto checked(Function f) const {
    try {
      return f();
    } catch (const Error& error) {
      if (error.code() == Error_code::work_limit) throw;
      tokens_.refuse(error.what());
    } catch (const Number_error& error) {
      tokens_.refuse(std::string("a control point: ") + error.what());
    }
  }

private:
  // The integer in the current word.
  int integer(const char* article, const char* what, int low, int high, const char* in = "") const {
    const std::string_view token = tokens_.token();
    const char* const end = token.data() + token.size();
    int value = 0;
    const std::from_chars_result result = std::from_chars(token.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value < low || high < value) {
      const std::string range = "an integer from " + std::to_string(low) + " to " + std::to_string(high);
      tokens_.refuse(std::string(article) + what + in + " is " + quoted_token(token) + " where " +
                     (low == high ? std::to_string(low) : range) + " is expected");
    }
    return value;
  }

  int read_integer(const char* what, int low = 0, int high = (std::numeric_limits<int>::max)(), const char* in = "") {
    if (!tokens_.advance()) tokens_.refuse(std::string("file ends before the ") + what + in);
    return integer("the ", what, low, high, in);
  }

  // Reads one of the numbers of a list of which `done` of `all` parts are complete.
  template <class Number> Number read_number(long long done, long long all, const char* parts, const char* in = "") {
    if (!tokens_.advance())
      tokens_.refuse("file ends after " + std::to_string(done) + " of " + std::to_string(all) + " " + parts + in);
    try {
      return tokens_.template number<Number>();
    } catch (const Number_error& error) {
      tokens_.refuse(error.what() + (": " + quoted_token(tokens_.token())));
    }
  }

  void read_header() {
    const int number = integer("the ", "class of the object", 0, (std::numeric_limits<int>::max)());
    is_line_ = number == g2_line && class_.number == g2_curves.number;
    is_plane_ = number == g2_plane && class_.number == g2_surfaces.number;
    if (number != class_.number && !is_line_ && !is_plane_) {
      std::string known, way_out;
      for (const G2_class& other : {g2_curves, g2_surfaces})
        if (number == other.number) known = std::string(" (spline ") + other.name + ")";
      if (number == g2_line) known = " (line)";
      if (number == g2_plane) known = " (plane)";
      for (const G2_other_class& other : g2_other_classes)
        if (number == other.number) {
          known = std::string(" (") + other.name + ")";
          way_out = "; its numbers, such as angles in radians, are not exact: write it as a rational spline";
        }
      tokens_.refuse(std::to_string(number) + known + " where a " + class_.name + " (" + std::to_string(class_.number) +
                     ") is expected" + way_out);
    }
    read_integer("major version", 1, 1);
    read_integer("minor version", 0, 0);
    const int auxiliary = read_integer("number of auxiliary values");
    for (int i = 0; i < auxiliary; ++i) {
      if (!tokens_.advance())
        tokens_.refuse("file ends after " + std::to_string(i) + " of " + std::to_string(auxiliary) +
                       " auxiliary values");
      integer("an ", "auxiliary value", (std::numeric_limits<int>::min)(), (std::numeric_limits<int>::max)());
    }
  }

  void read_dimension() {
    constexpr int fixed = N;
    const int dimension = fixed == 0 ? read_integer("dimension", 2, max_g2_dimension) : read_integer("dimension");
    if (fixed != 0 && dimension != fixed)
      tokens_.refuse("dimension " + std::to_string(dimension) + " where " + std::to_string(fixed) + " is expected");
    if (dimension_ != 0 && dimension != dimension_)
      tokens_.refuse("dimension " + std::to_string(dimension) + " after a " + class_.name + " of dimension " +
                     std::to_string(dimension_));
    dimension_ = dimension;
  }

  // The coordinates of lines and planes are computed in this field.
  typedef std::conditional_t<std::is_same_v<FT, Decimal>, Exact_rational, typename Exact_field<FT>::type>
      Elementary_number;

  // The location, the direction, 1 for a line with ends, and the parameters of these.
  void read_line() {
    typedef Elementary_number Number;
    rational_ = false;
    std::vector<Number> location, direction, ends;
    for (std::vector<Number>* row : {&location, &direction})
      for (int i = 0; i < dimension_; ++i) row->push_back(read_number<Number>(0, 1, "lines"));
    if (read_integer("flag of the ends of a line", 0, 1) == 0) tokens_.refuse("a line without ends; a curve has two");
    for (int i = 0; i < 2; ++i) ends.push_back(read_number<Number>(0, 1, "lines"));
    if (!(ends[0] < ends[1])) tokens_.refuse("the ends of a line do not increase: empty domain");
    checked([&] {
      line_knots_.clear();
      line_points_.clear();
      for (const Number& t : ends) {
        for (int i = 0; i < dimension_; ++i)
          line_points_.push_back(nearest_number<FT>(Number(location[i] + t * direction[i])));
        for (int k = 0; k < 2; ++k) line_knots_.push_back(nearest_number<FT>(t));
      }
    });
  }

  // A plane, and 1 if its parameters change places, or 0, or neither.
  void read_plane() {
    typedef Elementary_number Number;
    rational_ = false;
    if (dimension_ != 3) tokens_.refuse("a plane of dimension " + std::to_string(dimension_) + " where 3 is expected");
    G2_plane<Number> plane =
        read_g2_plane<Number>([this] { return read_number<Number>(0, 1, "planes"); },
                              [this](const char* what, int low, int high) { return read_integer(what, low, high); },
                              [this](const char* reason) { tokens_.refuse(reason); });
    at_header_ = tokens_.advance();
    if (at_header_ && (tokens_.token() == "0" || tokens_.token() == "1")) {
      plane.swapped = tokens_.token() == "1";
      at_header_ = false;
    }
    checked([&] {
      line_knots_.clear();
      line_points_.clear();
      for (const std::pair<Number, Number>& ends : plane.intervals())
        for (const Number& t : {ends.first, ends.first, ends.second, ends.second})
          line_knots_.push_back(nearest_number<FT>(t));
      const std::vector<typename G2_plane<Number>::Vector> corners = *plane.corners();
      for (const typename G2_plane<Number>::Vector& corner : corners)
        for (const Number& x : corner) line_points_.push_back(nearest_number<FT>(x));
    });
    if (!(line_knots_[1] < line_knots_[2] && line_knots_[5] < line_knots_[6]))
      tokens_.refuse("the ends of the domain of a plane are the same floating-point number");
  }

  void read_rational_flag() {
    rational_ = read_integer("rational flag", 0, 1) == 1;
    if (rational_ && weights_ == G2_weights::refused)
      tokens_.refuse(std::string("a rational ") + class_.name + " where a polynomial one is expected");
  }

  // Reads the knot after those that are there; the knots from number `first` on are equal to the
  // last one.
  template <class Knots>
  typename Knots::value_type read_knot(const Knots& knots, std::size_t& first, const G2_size& size, std::size_t all,
                                       G2_shape shape, const char* in) {
    typedef typename Knots::value_type Knot;
    const bool bezier = shape == G2_shape::bezier;
    const std::size_t i = knots.size(), order = size.order;
    const auto name = [all](std::size_t number) {
      return "knot " + std::to_string(number) + " of " + std::to_string(all);
    };
    const Knot knot = read_number<Knot>(i, all, "knots", in);
    if (i > 0 && !(knot == knots.back())) {
      if (knot < knots.back())
        tokens_.refuse(std::string("the knots") + in + " decrease at " + quoted_token(tokens_.token()));
      first = i;
    }
    if constexpr (std::is_floating_point_v<Knot>)
      if (i > 0 && !std::isfinite(knot - knots.front()))
        tokens_.refuse(std::string("the difference of the knots") + in +
                       " is outside the range of floating-point numbers");
    if (i == static_cast<std::size_t>(size.points) && first < order)
      tokens_.refuse((bezier ? std::string("the first and the last knots") + in + " are equal"
                             : name(order) + in + " is equal to knot " + std::to_string(i + 1)) +
                     ": empty domain");
    if (bezier && i % order != 0 && first == i)
      tokens_.refuse(std::string("the knots") + in + " are not clamped: " + name(i + 1) +
                     " must be equal to the one before it");
    if (i >= order && first + order <= i)
      tokens_.refuse(name(i + 1) + in + " is repeated more than " + std::to_string(order) + " times");
    return knot;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H
