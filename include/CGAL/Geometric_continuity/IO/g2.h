// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/internal/traits_access.h>

#include <charconv>
#include <cstddef>
#include <exception>
#include <istream>
#include <limits>
#include <locale>
#include <optional>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// The highest order (degree + 1) of a curve that is read from a `.g2` file.
constexpr int max_g2_order = 128;

/// \ingroup PkgGeometricContinuityIO
/// The highest dimension of a curve that is read from a `.g2` file.
constexpr int max_g2_dimension = 16;

namespace internal {

// The words of a text file, with the lines in which they begin. It reads the buffer of the stream, which is neither
// formatted nor influenced by the locale, and holds one word at a time.
class Token_reader {
  std::streambuf* buffer_;
  std::string name_, token_;
  long long line_ = 1, token_line_ = 1;

  int next_character() {
    try {
      const std::streambuf::int_type c = buffer_->sbumpc();
      return c == std::streambuf::traits_type::eof() ? -1 : static_cast<unsigned char>(c);
    } catch (const std::exception& error) {
      throw Error(Error_code::cannot_read_file, name_ + ": " + error.what());
    }
  }

public:
  Token_reader(std::istream& is, std::string name) : buffer_(is.rdbuf()), name_(std::move(name)) {
    if (!is) throw Error(Error_code::cannot_read_file, name_ + ": the stream cannot be read");
  }

  // Moves to the next word, if there is one.
  bool advance() {
    const auto is_space = [](int c) { return c == ' ' || ('\t' <= c && c <= '\r'); };
    token_.clear();
    int c = next_character();
    for (; is_space(c); c = next_character()) line_ += c == '\n';
    if (c == -1) return false;
    token_line_ = line_;
    for (; c != -1 && !is_space(c); c = next_character()) {
      token_ += static_cast<char>(c);
      if (token_.size() > max_number_length)
        refuse("more than " + std::to_string(max_number_length) +
               " characters without a space: " + quoted_token(token_));
    }
    line_ += c == '\n';
    return true;
  }

  const std::string& token() const { return token_; }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw Error(Error_code::malformed_input, name_ + ":" + std::to_string(token_line_) + ": " + reason);
  }
};

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Reads curves one after the other from a text in SINTEF's `.g2` format, in memory that does not depend on the
/// length of the text.
///
/// Each curve has the words, separated by white space:
/// - `100`, the class of spline curves, the version `1 0`, the number of auxiliary integers, and these, which are
///   skipped;
/// - the dimension, and 0 because the curve is not rational;
/// - the number of control points and the order (degree + 1);
/// - the knots, as many as both together;
/// - the control points.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`. A B-spline curve
/// needs at least as many control points as its order, and knots as `Knot_vector` does. A Bézier curve has as many
/// control points as its order, and two knots `a < b`, each repeated as often as the order says; its domain is [a, b].
/// All curves of a text have one dimension, which is that of `Traits` or, when `Traits` leaves it open, lies between 2
/// and `max_g2_dimension`. The order is at most `max_g2_order`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
/// \tparam Curve `Bezier_curve<Traits>` (curves with inner knots are refused) or `Bspline_curve<Traits>`
template <class Traits, class Curve = Bezier_curve<Traits>> class G2_curve_reader {
  static constexpr bool bezier = std::is_same_v<Curve, Bezier_curve<Traits>>;
  static_assert(bezier || std::is_same_v<Curve, Bspline_curve<Traits>>);

  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  internal::Token_reader tokens_;
  int dimension_ = 0; // of the first curve
  bool empty_ = true;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_curve_reader(std::istream& is, std::string name) : tokens_(is, std::move(name)) {}

  /// The next curve, or nothing at the end of the text.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is not described above, and
  ///         for a text without any curve. After an error the reader cannot be used any more.
  /// \throws Error `cannot_read_file` when reading fails for another reason
  std::optional<Curve> next() {
    if (!tokens_.advance()) {
      if (empty_) tokens_.refuse("no curve");
      return std::nullopt;
    }
    empty_ = false;
    read_header();
    read_dimension();
    const Size size = read_size();
    std::vector<FT> knots;
    for (long long i = 0; i < size.knots(); ++i) knots.push_back(read_knot(knots, size));
    std::vector<Point> points;
    for (int j = 0; j < size.points; ++j) points.push_back(read_point(j, size.points));
    if constexpr (bezier)
      return Curve(points.begin(), points.end(), knots.front(), knots.back());
    else
      return Curve(points.begin(), points.end(), Knot_vector<FT>(size.order - 1, std::move(knots)));
  }

private:
  struct Size {
    int points, order;
    long long knots() const { return static_cast<long long>(points) + order; }
  };

  // The integer in the current word.
  int integer(const std::string& what, int low, int high) const {
    const std::string& token = tokens_.token();
    const char* const end = token.data() + token.size();
    int value = 0;
    const std::from_chars_result result = std::from_chars(token.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || value < low || high < value) {
      const std::string range = "an integer from " + std::to_string(low) + " to " + std::to_string(high);
      tokens_.refuse(what + " is " + internal::quoted_token(token) + " where " +
                     (low == high ? std::to_string(low) : range) + " is expected");
    }
    return value;
  }

  int read_integer(const std::string& what, int low = 0, int high = std::numeric_limits<int>::max()) {
    if (!tokens_.advance()) tokens_.refuse("file ends before the " + what);
    return integer("the " + what, low, high);
  }

  // One of the numbers of a list of which `done` of `all` parts are complete.
  FT read_number(long long done, long long all, const char* parts) {
    if (!tokens_.advance())
      tokens_.refuse("file ends after " + std::to_string(done) + " of " + std::to_string(all) + " " + parts);
    try {
      return internal::number_value<FT>(tokens_.token());
    } catch (const internal::Number_error& error) {
      tokens_.refuse(error.what() + (": " + internal::quoted_token(tokens_.token())));
    }
  }

  void read_header() {
    const int curve_class = integer("the class of the object", 0, std::numeric_limits<int>::max());
    if (curve_class != 100)
      tokens_.refuse(std::to_string(curve_class) + (curve_class == 200 ? " (spline surface)" : "") +
                     " where a curve (100) is expected");
    read_integer("major version", 1, 1);
    read_integer("minor version", 0, 0);
    const int auxiliary = read_integer("number of auxiliary values");
    for (int i = 0; i < auxiliary; ++i) {
      if (!tokens_.advance())
        tokens_.refuse("file ends after " + std::to_string(i) + " of " + std::to_string(auxiliary) +
                       " auxiliary values");
      integer("an auxiliary value", std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    }
  }

  void read_dimension() {
    constexpr int fixed = internal::dimension_v<Traits>;
    const int dimension = fixed == 0 ? read_integer("dimension", 2, max_g2_dimension) : read_integer("dimension");
    if (fixed != 0 && dimension != fixed)
      tokens_.refuse("dimension " + std::to_string(dimension) + " where " + std::to_string(fixed) + " is expected");
    if (dimension_ != 0 && dimension != dimension_)
      tokens_.refuse("dimension " + std::to_string(dimension) + " after a curve of dimension " +
                     std::to_string(dimension_));
    dimension_ = dimension;
    if (read_integer("rational flag", 0, 1) == 1) tokens_.refuse("rational curves are not supported");
  }

  Size read_size() {
    const int points = read_integer("number of control points", 1);
    const int order = read_integer("order", 1, max_g2_order);
    const std::string text = std::to_string(points) + " control points and order " + std::to_string(order);
    if (points < order)
      tokens_.refuse(text + ": there must be " + (bezier ? "" : "at least ") +
                     "as many control points as the order says");
    if (bezier && points > order) tokens_.refuse(text + ": inner knots are not supported, only Bezier curves");
    return {points, order};
  }

  // The knot after those that have been read.
  FT read_knot(const std::vector<FT>& knots, const Size& size) {
    const std::size_t i = knots.size(), order = size.order;
    const FT knot = read_number(i, size.knots(), "knots");
    if (i > 0 && knot < knots.back()) refuse_decreasing_knots();
    if (i == static_cast<std::size_t>(size.points) && knot == knots[order - 1])
      tokens_.refuse(bezier
                         ? "the first and the last knots are equal: empty domain"
                         : text_of_knot(order, size) + " is equal to knot " + std::to_string(i + 1) + ": empty domain");
    if (bezier && i % order != 0 && knot != knots.back())
      tokens_.refuse("the knots are not clamped: " + text_of_knot(i + 1, size) + " must be equal to the one before it");
    if (i >= order && knot == knots[i - order])
      tokens_.refuse(text_of_knot(i + 1, size) + " is repeated more than " + std::to_string(order) + " times");
    return knot;
  }

  static std::string text_of_knot(std::size_t number, const Size& size) {
    return "knot " + std::to_string(number) + " of " + std::to_string(size.knots());
  }

  void refuse_decreasing_knots() const {
    tokens_.refuse("the knots decrease at " + internal::quoted_token(tokens_.token()));
  }

  Point read_point(int done, int all) {
    internal::Coordinates<Traits> x(dimension_);
    for (int i = 0; i < dimension_; ++i) x[i] = read_number(done, all, "control points");
    return internal::to_point<Traits>(x);
  }
};

/// \ingroup PkgGeometricContinuityIO
/// The reader of B-spline curves.
template <class Traits> using G2_bspline_reader = G2_curve_reader<Traits, Bspline_curve<Traits>>;

namespace internal {

template <class Traits, class Curve> std::vector<Curve> read_g2(std::istream& is, const std::string& name) {
  G2_curve_reader<Traits, Curve> reader(is, name);
  std::vector<Curve> curves;
  while (std::optional<Curve> curve = reader.next()) curves.push_back(*std::move(curve));
  return curves;
}

// The text of a curve, with an empty line after it.
template <class Curve> std::string g2_text(const Curve& curve, const Knot_vector<typename Curve::FT>& knots) {
  const auto write_line = [](std::ostream& os, const auto& numbers) {
    bool first = true;
    for (const auto& x : numbers) {
      if (!first) os << ' ';
      write_number(os, x);
      first = false;
    }
    os << '\n';
  };
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "100 1 0 0\n"
       << curve.dimension() << " 0\n"
       << knots.number_of_coefficients() << ' ' << knots.degree() + 1 << '\n';
  write_line(text, knots);
  for (int j = 0; j < knots.number_of_coefficients(); ++j) write_line(text, curve.coordinates(j));
  text << '\n';
  return text.str();
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// All curves of a text in the `.g2` format, which are Bézier curves, see `G2_curve_reader`.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bezier_curve<Traits>> read_g2_curves(std::istream& is, const std::string& name) {
  return internal::read_g2<Traits, Bezier_curve<Traits>>(is, name);
}

/// \ingroup PkgGeometricContinuityIO
/// All curves of a text in the `.g2` format as B-spline curves, see `G2_curve_reader`.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bspline_curve<Traits>> read_g2_bsplines(std::istream& is, const std::string& name) {
  return internal::read_g2<Traits, Bspline_curve<Traits>>(is, name);
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a curve in the `.g2` format without loss, see `write_number()`, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports
/// them.
/// \throws Error as `write_number()` does
template <class Traits, int Degree> void write_g2(std::ostream& os, const Bezier_curve<Traits, Degree>& curve) {
  const std::pair<typename Traits::FT, typename Traits::FT> domain = curve.domain();
  const std::string text =
      internal::g2_text(curve, Knot_vector<typename Traits::FT>(curve.degree(), domain.first, domain.second));
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a B-spline curve in the same way.
template <class Traits> void write_g2(std::ostream& os, const Bspline_curve<Traits>& curve) {
  const std::string text = internal::g2_text(curve, curve.knots());
  os.write(text.data(), static_cast<std::streamsize>(text.size()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
