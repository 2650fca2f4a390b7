// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/internal/traits_access.h>

#include <charconv>
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
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`. The curve must
/// be a Bézier curve: as many control points as its order, and two knots `a < b`, each repeated as often as the order
/// says. Its domain is [a, b]. All curves of a text have one dimension, which is that of `Traits` or, when `Traits`
/// leaves it open, lies between 2 and `max_g2_dimension`. The order is at most `max_g2_order`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
template <class Traits> class G2_curve_reader {
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
  std::optional<Bezier_curve<Traits>> next() {
    if (!tokens_.advance()) {
      if (empty_) tokens_.refuse("no curve");
      return std::nullopt;
    }
    empty_ = false;
    read_header();
    read_dimension();
    const int order = read_order();
    const std::pair<FT, FT> domain = read_domain(order);
    std::vector<Point> points;
    for (int j = 0; j < order; ++j) points.push_back(read_point(j, order));
    return Bezier_curve<Traits>(points.begin(), points.end(), domain.first, domain.second);
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
  FT read_number(int done, int all, const char* parts) {
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

  int read_order() {
    const int points = read_integer("number of control points", 1);
    const int order = read_integer("order", 1, max_g2_order);
    const std::string text = std::to_string(points) + " control points and order " + std::to_string(order);
    if (points < order) tokens_.refuse(text + ": there must be as many control points as the order says");
    if (points > order) tokens_.refuse(text + ": inner knots are not supported, only Bezier curves");
    return order;
  }

  std::pair<FT, FT> read_domain(int order) {
    FT ends[2];
    for (int i = 0; i < 2 * order; ++i) {
      const FT knot = read_number(i, 2 * order, "knots");
      FT& end = ends[i / order];
      if (i % order == 0) {
        end = knot;
        if (i == order && end < ends[0]) refuse_decreasing_knots();
        if (i == order && end == ends[0]) tokens_.refuse("the first and the last knots are equal: empty domain");
      } else if (knot < end)
        refuse_decreasing_knots();
      else if (knot != end)
        tokens_.refuse("the knots are not clamped: knot " + std::to_string(i + 1) + " of " + std::to_string(2 * order) +
                       " must be equal to the one before it");
    }
    return {ends[0], ends[1]};
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
/// All curves of a text in the `.g2` format, see `G2_curve_reader`.
/// \throws Error as `G2_curve_reader` does
template <class Traits> std::vector<Bezier_curve<Traits>> read_g2_curves(std::istream& is, const std::string& name) {
  G2_curve_reader<Traits> reader(is, name);
  std::vector<Bezier_curve<Traits>> curves;
  while (std::optional<Bezier_curve<Traits>> curve = reader.next()) curves.push_back(*std::move(curve));
  return curves;
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a curve in the `.g2` format without loss, see `write_number()`, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports
/// them.
/// \throws Error as `write_number()` does
template <class Traits, int Degree> void write_g2(std::ostream& os, const Bezier_curve<Traits, Degree>& curve) {
  typedef typename Traits::FT FT;
  const int order = curve.degree() + 1;
  const std::pair<FT, FT> domain = curve.domain();
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "100 1 0 0\n" << curve.dimension() << " 0\n" << order << ' ' << order << '\n';
  for (int i = 0; i < 2 * order; ++i) {
    if (i > 0) text << ' ';
    write_number(text, i < order ? domain.first : domain.second);
  }
  text << '\n';
  for (int j = 0; j < order; ++j) {
    const internal::Coordinates<Traits> x = curve.coordinates(j);
    for (int i = 0; i < x.dimension(); ++i) {
      if (i > 0) text << ' ';
      write_number(text, x[i]);
    }
    text << '\n';
  }
  text << '\n';
  const std::string characters = text.str();
  os.write(characters.data(), static_cast<std::streamsize>(characters.size()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_H
