// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/internal/traits_access.h>
#include <CGAL/Geometric_continuity/surfaces/Bezier_patch.h>

#include <charconv>
#include <istream>
#include <limits>
#include <locale>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Reads Bézier patches one after the other from a text in SINTEF's `.g2` format, in memory that does not depend on the
/// length of the text.
///
/// Each patch has the words, separated by white space:
/// - `200`, the class of spline surfaces, the version `1 0`, the number of auxiliary integers, and these, which are
///   skipped;
/// - the dimension, and 0 because the surface is not rational;
/// - for `u` and then for `v`: the number of control points, the order (degree + 1), and the knots, as many as both together;
/// - the control points \f$ b_{00}, b_{10}, \dots, b_{p0}, b_{01}, \dots, b_{pq} \f$: the index that belongs to `u` runs
///   fastest.
///
/// Coordinates and knots are read by `parse_number()`, so that a number may also be a fraction `p/q`. The surface must be a
/// Bézier patch: in both directions as many control points as the order says, and two knots, each repeated as often, which
/// are its domain. All patches of a text have one dimension, which is that of `Traits` or, when `Traits` leaves it open,
/// lies between 2 and `max_g2_dimension`. The orders are at most `max_g2_order`.
///
/// \tparam Traits a model of `GeometricContinuityTraits` whose `FT` is accepted by `parse_number()`
template <class Traits> class G2_surface_reader {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  struct Direction { // of a tensor product
    int points = 0, order = 0;
    std::vector<FT> knots;
    std::pair<FT, FT> domain() const { return {knots[order - 1], knots[points]}; }
  };

  internal::Token_reader tokens_;
  int dimension_ = 0; // of the first patch
  bool empty_ = true;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_surface_reader(std::istream& is, std::string name) : tokens_(is, std::move(name)) {}

  /// The next patch, or nothing at the end of the text.
  /// \throws Error `malformed_input` with a text `name:line: reason` for everything that is not described above, and
  ///         for a text without any patch. After an error the reader cannot be used any more.
  /// \throws Error `cannot_read_file` when reading fails for another reason
  std::optional<Bezier_patch<Traits>> next() {
    if (!tokens_.advance()) {
      if (empty_) tokens_.refuse("no surface");
      return std::nullopt;
    }
    empty_ = false;
    read_header();
    read_dimension();
    const Direction u = read_direction("u"), v = read_direction("v");
    std::vector<std::vector<Point>> net(u.points);
    for (int j = 0; j < v.points; ++j)
      for (int i = 0; i < u.points; ++i) net[i].push_back(read_point(j * u.points + i, u.points * v.points));
    return Bezier_patch<Traits>(net, u.domain(), v.domain());
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
  FT read_number(int done, int all, const std::string& parts) {
    if (!tokens_.advance())
      tokens_.refuse("file ends after " + std::to_string(done) + " of " + std::to_string(all) + " " + parts);
    try {
      return internal::number_value<FT>(tokens_.token());
    } catch (const internal::Number_error& error) {
      tokens_.refuse(error.what() + (": " + internal::quoted_token(tokens_.token())));
    }
  }

  void read_header() {
    const int surface_class = integer("the class of the object", 0, std::numeric_limits<int>::max());
    if (surface_class != 200)
      tokens_.refuse(std::to_string(surface_class) + (surface_class == 100 ? " (spline curve)" : "") +
                     " where a surface (200) is expected");
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
      tokens_.refuse("dimension " + std::to_string(dimension) + " after a surface of dimension " +
                     std::to_string(dimension_));
    dimension_ = dimension;
    if (read_integer("rational flag", 0, 1) == 1) tokens_.refuse("rational surfaces are not supported");
  }

  // Everything about one parameter. The knots are kept as a whole; what makes them those of a Bezier patch is checked here.
  Direction read_direction(const std::string& name) {
    Direction d;
    d.points = read_integer("number of control points in " + name, 1);
    d.order = read_integer("order in " + name, 1, max_g2_order);
    const std::string text =
        std::to_string(d.points) + " control points and order " + std::to_string(d.order) + " in " + name;
    if (d.points < d.order) tokens_.refuse(text + ": there must be as many control points as the order says");
    if (d.points > d.order) tokens_.refuse(text + ": inner knots are not supported, only Bezier patches");
    const int all = d.points + d.order;
    for (int i = 0; i < all; ++i) {
      d.knots.push_back(read_number(i, all, "knots in " + name));
      if (i == 0) continue;
      const bool clamped = i < d.order || d.points < i; // the knot must be equal to the one before it
      if (d.knots[i] < d.knots[i - 1])
        tokens_.refuse("the knots in " + name + " decrease at " + internal::quoted_token(tokens_.token()));
      if (clamped && d.knots[i] != d.knots[i - 1])
        tokens_.refuse("the knots in " + name + " are not clamped: knot " + std::to_string(i + 1) + " of " +
                       std::to_string(all) + " must be equal to the one before it");
      if (i == d.points && d.knots[i] == d.knots[d.order - 1])
        tokens_.refuse("the first and the last knots in " + name + " are equal: empty domain");
    }
    return d;
  }

  Point read_point(int done, int all) {
    internal::Coordinates<Traits> x(dimension_);
    for (int i = 0; i < dimension_; ++i) x[i] = read_number(done, all, "control points");
    return internal::to_point<Traits>(x);
  }
};

/// \ingroup PkgGeometricContinuityIO
/// All patches of a text in the `.g2` format, see `G2_surface_reader`.
/// \throws Error as `G2_surface_reader` does
template <class Traits> std::vector<Bezier_patch<Traits>> read_g2_surfaces(std::istream& is, const std::string& name) {
  G2_surface_reader<Traits> reader(is, name);
  std::vector<Bezier_patch<Traits>> patches;
  while (std::optional<Bezier_patch<Traits>> patch = reader.next()) patches.push_back(*std::move(patch));
  return patches;
}

/// \ingroup PkgGeometricContinuityIO
/// Writes a patch in the `.g2` format without loss, see `write_number()`, with an empty line after it. Nothing is
/// written when an error is thrown. Failures of the stream are seen in its state; `write_file_atomically()` reports
/// them.
/// \throws Error as `write_number()` does
template <class Traits> void write_g2(std::ostream& os, const Bezier_patch<Traits>& patch) {
  typedef typename Traits::FT FT;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "200 1 0 0\n" << patch.dimension() << " 0\n";
  const auto write_direction = [&](int order, const std::pair<FT, FT>& domain) {
    text << order << ' ' << order << '\n';
    for (int i = 0; i < 2 * order; ++i) {
      if (i > 0) text << ' ';
      write_number(text, i < order ? domain.first : domain.second);
    }
    text << '\n';
  };
  write_direction(patch.degree_u() + 1, patch.domain_u());
  write_direction(patch.degree_v() + 1, patch.domain_v());
  for (int j = 0; j <= patch.degree_v(); ++j)
    for (int i = 0; i <= patch.degree_u(); ++i) {
      const internal::Coordinates<Traits> x = patch.coordinates(i, j);
      for (int k = 0; k < x.dimension(); ++k) {
        if (k > 0) text << ' ';
        write_number(text, x[k]);
      }
      text << '\n';
    }
  text << '\n';
  const std::string characters = text.str();
  os.write(characters.data(), static_cast<std::streamsize>(characters.size()));
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_SURFACES_H
