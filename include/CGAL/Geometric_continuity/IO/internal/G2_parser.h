// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_elementary.h>
#include <CGAL/Geometric_continuity/IO/internal/Token_reader.h>
#include <CGAL/Geometric_continuity/IO/limits.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/local/coordinates.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <limits>
#include <string>
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

// Whether rational objects are read.
enum class G2_weights { refused, allowed };

// The numbers of control points and the order in one parameter of a spline.
struct G2_size {
  int points, order;
};

// What the text says of one parameter of a spline.
template <class FT> struct G2_direction : G2_size { std::vector<FT> knots; };

// Knots are kept in a vector, or as in `G2_knot_text`.
template <class FT> void append_knot(std::vector<FT>& knots, const FT& knot, const std::string&) {
  knots.push_back(knot);
}
template <class Knots, class FT> void append_knot(Knots& knots, const FT& knot, const std::string& word) {
  knots.append(knot, word);
}

// Reads the parts of the objects of one class in a `.g2` text, one after the other. Everything that is not as it should
// be is refused with file, line and reason.
template <class Traits> class G2_parser {
  typedef typename Traits::FT FT;
  typedef G2_direction<FT> Direction;

  Token_reader tokens_;
  G2_class class_;
  G2_weights weights_;
  int dimension_ = 0; // of the first object
  bool empty_ = true, rational_ = false, is_line_ = false, is_plane_ = false;
  bool at_header_ = false;                          // whether the current word is the first of the next object
  std::vector<FT> line_knots_;                      // of a line or plane, which is read as a whole: a spline of order 2
  std::vector<typename Traits::Point> line_points_; // and its ends or corners

public:
  // A point with its weight, in homogeneous coordinates (w x, w), as exact numbers.
  typedef typename Exact_field<FT>::type Exact;
  typedef Coordinate_vector<Exact, (dimension_v<Traits> == 0 ? 0 : dimension_v<Traits> + 1)> Homogeneous_row;

  G2_parser(std::istream& is, std::string name, const G2_class& object_class, G2_weights weights = G2_weights::refused)
      : tokens_(is, std::move(name)), class_(object_class), weights_(weights) {}

  // Whether the current object has weights.
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

  // Reads the number of points and the order; for Bezier shapes they are equal. `in` names the parameter of a surface,
  // e.g. " in u".
  G2_size read_size(G2_shape shape, const std::string& in = "") {
    if (is_line_ || is_plane_) return {2, 2};
    const bool bezier = shape == G2_shape::bezier;
    const int points = read_integer("number of control points" + in, 1),
              order = read_integer("order" + in, 1, max_g2_order);
    const std::string text = std::to_string(points) + " control points and order " + std::to_string(order) + in + ": ";
    if (points < order)
      tokens_.refuse(text + "there must be " + (bezier ? "" : "at least ") +
                     "as many control points as the order says");
    if (bezier && points > order) tokens_.refuse(text + "inner knots are not supported, only " + class_.bezier);
    return {points, order};
  }

  // Appends all knots, as `Knot_vector` takes them; for Bezier shapes there are no inner knots.
  template <class Knots>
  void read_knots(Knots& knots, const G2_size& size, G2_shape shape, const std::string& in = "") {
    const std::size_t all = static_cast<std::size_t>(size.points) + size.order;
    if (is_line_ || is_plane_) {
      for (int i = 0; i < 4; ++i) append_knot(knots, line_knots_[i], number_text(line_knots_[i]));
      line_knots_.erase(line_knots_.begin(), line_knots_.begin() + 4);
    }
    while (knots.size() < all) {
      const FT knot = read_knot(knots, size, all, shape, in);
      append_knot(knots, knot, tokens_.token());
    }
  }

  // Reads the size and the knots in one parameter.
  Direction read_direction(G2_shape shape, const std::string& in = "") {
    Direction d{read_size(shape, in), {}};
    read_knots(d.knots, d, shape, in);
    return d;
  }

  // Reads the control point after `done` of `all`.
  typename Traits::Point read_point(long long done, long long all) {
    if (is_line_ || is_plane_) return line_points_[static_cast<std::size_t>(done)];
    Coordinates<Traits> x(dimension_);
    for (int i = 0; i < dimension_; ++i) x[i] = read_number<FT>(done, all, "control points");
    return to_point<Traits>(x);
  }

  // Reads the control point after `done` of `all` of a rational object.
  Homogeneous_row read_homogeneous_point(long long done, long long all) {
    Homogeneous_row row(dimension_ + 1);
    for (int i = 0; i <= dimension_; ++i) row[i] = read_number<Exact>(done, all, "control points");
    return row;
  }

  // Returns f(), and refuses what is wrong with the object that has been read: a denominator that is not positive, or a quotient
  // that is too large.
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
  int integer(const std::string& what, int low, int high) const {
    const std::string& token = tokens_.token();
    const char* const end = token.data() + token.size();
    int value = 0;
    const std::from_chars_result result = std::from_chars(token.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value < low || high < value) {
      const std::string range = "an integer from " + std::to_string(low) + " to " + std::to_string(high);
      tokens_.refuse(what + " is " + quoted_token(token) + " where " + (low == high ? std::to_string(low) : range) +
                     " is expected");
    }
    return value;
  }

  int read_integer(const std::string& what, int low = 0, int high = (std::numeric_limits<int>::max)()) {
    if (!tokens_.advance()) tokens_.refuse("file ends before the " + what);
    return integer("the " + what, low, high);
  }

  // One of the numbers of a list of which `done` of `all` parts are complete.
  template <class Number> Number read_number(long long done, long long all, const std::string& parts) {
    if (!tokens_.advance())
      tokens_.refuse("file ends after " + std::to_string(done) + " of " + std::to_string(all) + " " + parts);
    try {
      return number_value<Number>(tokens_.token());
    } catch (const Number_error& error) {
      tokens_.refuse(error.what() + (": " + quoted_token(tokens_.token())));
    }
  }

  void read_header() {
    const int number = integer("the class of the object", 0, (std::numeric_limits<int>::max)());
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
      integer("an auxiliary value", (std::numeric_limits<int>::min)(), (std::numeric_limits<int>::max)());
    }
  }

  void read_dimension() {
    constexpr int fixed = dimension_v<Traits>;
    const int dimension = fixed == 0 ? read_integer("dimension", 2, max_g2_dimension) : read_integer("dimension");
    if (fixed != 0 && dimension != fixed)
      tokens_.refuse("dimension " + std::to_string(dimension) + " where " + std::to_string(fixed) + " is expected");
    if (dimension_ != 0 && dimension != dimension_)
      tokens_.refuse("dimension " + std::to_string(dimension) + " after a " + class_.name + " of dimension " +
                     std::to_string(dimension_));
    dimension_ = dimension;
  }

  // The location, the direction, 1 for a line with ends, and the parameters of these.
  void read_line() {
    rational_ = false;
    std::vector<Exact> location, direction, ends;
    for (std::vector<Exact>* row : {&location, &direction})
      for (int i = 0; i < dimension_; ++i) row->push_back(read_number<Exact>(0, 1, "lines"));
    if (read_integer("flag of the ends of a line", 0, 1) == 0) tokens_.refuse("a line without ends; a curve has two");
    for (int i = 0; i < 2; ++i) ends.push_back(read_number<Exact>(0, 1, "lines"));
    if (!(ends[0] < ends[1])) tokens_.refuse("the ends of a line do not increase: empty domain");
    checked([&] {
      line_knots_.clear();
      line_points_.clear();
      for (const Exact& t : ends) {
        Coordinates<Traits> x(dimension_);
        for (int i = 0; i < dimension_; ++i) x[i] = nearest_number<FT>(Exact(location[i] + t * direction[i]));
        line_points_.push_back(to_point<Traits>(x));
        for (int k = 0; k < 2; ++k) line_knots_.push_back(nearest_number<FT>(t));
      }
    });
  }

  // A plane, and 1 if its parameters change places, or 0, or neither.
  void read_plane() {
    rational_ = false;
    if (dimension_ != 3) tokens_.refuse("a plane of dimension " + std::to_string(dimension_) + " where 3 is expected");
    G2_plane<Exact> plane =
        read_g2_plane<Exact>([this] { return read_number<Exact>(0, 1, "planes"); },
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
      for (const std::pair<Exact, Exact>& ends : plane.intervals())
        for (const Exact& t : {ends.first, ends.first, ends.second, ends.second})
          line_knots_.push_back(nearest_number<FT>(t));
      const std::vector<std::array<Exact, 3>> corners = *plane.corners();
      for (const std::array<Exact, 3>& corner : corners) {
        Coordinates<Traits> x(3);
        for (int i = 0; i < 3; ++i) x[i] = nearest_number<FT>(corner[i]);
        line_points_.push_back(to_point<Traits>(x));
      }
    });
    if (!(line_knots_[1] < line_knots_[2] && line_knots_[5] < line_knots_[6]))
      tokens_.refuse("the ends of the domain of a plane are the same floating-point number");
  }

  void read_rational_flag() {
    rational_ = read_integer("rational flag", 0, 1) == 1;
    if (rational_ && weights_ == G2_weights::refused)
      tokens_.refuse(std::string("a rational ") + class_.name + " where a polynomial one is expected");
  }

  // Reads the knot after those that are there.
  template <class Knots>
  FT read_knot(const Knots& knots, const G2_size& size, std::size_t all, G2_shape shape, const std::string& in) {
    const bool bezier = shape == G2_shape::bezier;
    const std::size_t i = knots.size(), order = size.order;
    const auto name = [all](std::size_t number) {
      return "knot " + std::to_string(number) + " of " + std::to_string(all);
    };
    const FT knot = read_number<FT>(i, all, "knots" + in);
    if (i > 0 && knot < knots.back())
      tokens_.refuse("the knots" + in + " decrease at " + quoted_token(tokens_.token()));
    if constexpr (std::is_floating_point_v<FT>)
      if (i > 0 && !std::isfinite(knot - knots.front()))
        tokens_.refuse("the difference of the knots" + in + " is outside the range of floating-point numbers");
    if (i == static_cast<std::size_t>(size.points) && knot == knots[order - 1])
      tokens_.refuse((bezier ? "the first and the last knots" + in + " are equal"
                             : name(order) + in + " is equal to knot " + std::to_string(i + 1)) +
                     ": empty domain");
    if (bezier && i % order != 0 && knot != knots.back())
      tokens_.refuse("the knots" + in + " are not clamped: " + name(i + 1) + " must be equal to the one before it");
    if (i >= order && knot == knots[i - order])
      tokens_.refuse(name(i + 1) + in + " is repeated more than " + std::to_string(order) + " times");
    return knot;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_PARSER_H
