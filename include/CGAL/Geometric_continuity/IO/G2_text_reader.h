// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H

#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_spline_parts.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// \file G2_text_reader.h
/// Curves and surfaces of the format `.g2` with their numbers as they are written: one by one in
/// constant memory, with the places of the numbers, or on a grid.
///
/// Where the places of the numbers of curves are known a program can change numbers and leave
/// everything else of a text as it is. Surfaces of decimals become surfaces of integers when all
/// coordinates are multiplied by a power of ten and all parameters by another one. No order of
/// continuity along any edge changes by that, and integers up to \f$ 2^{53} \f$ are doubles: so
/// whatever is decided exactly on doubles is decided about the decimals.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// A curve as a text of the format `.g2` writes it.
struct G2_curve_text {
  /// A number, and the bytes of the text from `begin` up to `end` that are it.
  struct Written_number {
    Decimal value;
    std::size_t begin, end;
  };

  int dimension; ///< the dimension of the points
  int points;    ///< the number of control points
  int order;     ///< the degree plus one
  /// each point is followed by its weight, \f$ (w x, w) \f$
  bool rational;
  /// the object is a line (class 120): its control points are not in the text
  bool is_line;
  /// the coordinates of one point after the other, with weights; empty for a line
  std::vector<Written_number> coordinates;
};

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text of the format `.g2`, one after the other, as `G2_piece_reader` does,
/// with the places of their coordinates. Memory: the coordinates of one curve.
class G2_text_reader {
  internal::G2_parser<Decimal, 0> parser_;
  internal::G2_size size_{0, 0};
  std::vector<Decimal> knots_;

public:
  /// Reads from `is`. Messages call it `name`.
  G2_text_reader(std::istream& is, std::string name)
      : parser_(is, std::move(name), internal::g2_curves, internal::G2_weights::allowed) {}

  /// Reads the next curve. Returns false at the end of the text.
  /// \throws Error `malformed_input`, with line and reason; `cannot_read_file`
  bool next(G2_curve_text& curve) {
    if (!parser_.next_object()) return false;
    size_ = parser_.read_size(internal::G2_shape::spline);
    knots_.clear();
    parser_.read_knots(knots_, size_, internal::G2_shape::spline);
    curve = {parser_.dimension(), size_.points, size_.order, parser_.rational(), parser_.is_line(), {}};
    if (curve.is_line) return true;
    const int width = curve.dimension + curve.rational;
    for (int k = 0; k < curve.points; ++k)
      for (int i = 0; i < width; ++i) {
        const Decimal value = parser_.read_coordinate(i, k, curve.points);
        const auto [begin, end] = parser_.place();
        curve.coordinates.push_back({value, begin, end});
      }
    return true;
  }
};

template <class Traits> class G2_surface_text_reader;

/// \ingroup PkgGeometricContinuityIO
/// A polynomial B-spline surface in space as it stands in a text in the `.g2` format, with the
/// numbers as they are written.
class G2_surface_text {
  internal::G2_direction<Decimal> u_, v_;
  std::vector<Decimal> coordinates_;

  template <class> friend class G2_surface_text_reader;
  friend class G2_grid;

  // Returns the surface with number(x) for each coordinate and knot(x) for each knot.
  template <class Traits, class Number, class Knot> Bspline_surface<Traits> surface(Number number, Knot knot) const {
    typedef typename Traits::FT FT;
    std::vector<typename Traits::Point> points;
    points.reserve(coordinates_.size() / 3);
    for (std::size_t k = 0; k < coordinates_.size(); k += 3) {
      Coordinates<Traits> x(3);
      for (int i = 0; i < 3; ++i) x[i] = number(coordinates_[k + static_cast<std::size_t>(i)]);
      points.push_back(to_point<Traits>(x));
    }
    const auto knots = [&](const internal::G2_direction<Decimal>& direction) {
      std::vector<FT> values;
      for (const Decimal& x : direction.knots) values.push_back(knot(x));
      return Knot_vector<FT>(direction.order - 1, std::move(values));
    };
    return Bspline_surface<Traits>(internal::g2_net(points, u_), knots(u_), knots(v_));
  }

public:
  /// Returns the surface. \tparam Traits a model of `GeometricContinuityTraits` of dimension 3 over
  /// `Exact_rational`
  template <class Traits> Bspline_surface<Traits> surface() const {
    const auto value = [](const Decimal& x) { return typename Traits::FT(x.value()); };
    return surface<Traits>(value, value);
  }
};

/// \ingroup PkgGeometricContinuityIO
/// The powers of ten that make integers of all coordinates and of all knots of some surfaces.
class G2_grid {
  // The unit of coordinates, or of knots.
  struct Axis {
    int exponent = 0;

    void include(const Decimal& x) {
      if (x.is_decimal()) exponent = (std::min)(exponent, x.exponent());
    }
    // Returns whether this is an integer that is a double.
    bool has(const Decimal& x) const {
      std::int64_t n = 0;
      return x.on_grid(exponent, n) && -limit <= n && n <= limit;
    }
    bool has(const std::vector<Decimal>& numbers) const {
      return std::all_of(numbers.begin(), numbers.end(), [this](const Decimal& x) { return has(x); });
    }
    double operator()(const Decimal& x) const {
      std::int64_t n = 0;
      x.on_grid(exponent, n);
      return static_cast<double>(n);
    }
  };
  static constexpr std::int64_t limit = std::int64_t(1) << 53;
  Axis coordinates_, knots_;

public:
  /// Makes the grids fine enough for a surface.
  void include(const G2_surface_text& surface) {
    for (const Decimal& x : surface.coordinates_) coordinates_.include(x);
    for (const auto* direction : {&surface.u_, &surface.v_})
      for (const Decimal& x : direction->knots) knots_.include(x);
  }

  /// Returns the exponent of the power of ten that is the unit of the coordinates.
  int exponent_of_coordinates() const { return coordinates_.exponent; }
  /// Returns the exponent of the power of ten that is the unit of the knots.
  int exponent_of_knots() const { return knots_.exponent; }

  /// Appends the surfaces in these units. Returns false, and appends nothing, unless all surfaces
  /// have been included and all numbers are integers up to \f$ 2^{53} \f$.
  /// \tparam Traits a model of `GeometricContinuityTraits` of dimension 3 over `double`
  template <class Traits>
  bool append(const std::vector<G2_surface_text>& texts, std::vector<Bspline_surface<Traits>>& surfaces) const {
    for (const G2_surface_text& text : texts)
      if (!coordinates_.has(text.coordinates_) || !knots_.has(text.u_.knots) || !knots_.has(text.v_.knots))
        return false;
    std::vector<Bspline_surface<Traits>> result;
    result.reserve(texts.size());
    for (const G2_surface_text& text : texts) result.push_back(text.surface<Traits>(coordinates_, knots_));
    surfaces.insert(surfaces.end(), result.begin(), result.end());
    return true;
  }
};

/// \ingroup PkgGeometricContinuityIO
/// Reads the surfaces of a text in the `.g2` format one after the other, polynomial ones with the
/// numbers as they are written.
/// \tparam Traits a model of `GeometricContinuityTraits` of dimension 3 over `Exact_rational`, for
///   rational surfaces
template <class Traits> class G2_surface_text_reader {
  typedef typename Traits::FT FT;

  internal::G2_parser<Decimal, 3> parser_;
  long long line_ = 0;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_surface_text_reader(std::istream& is, std::string name)
      : parser_(is, std::move(name), internal::g2_surfaces, internal::G2_weights::allowed) {}

  /// Reads the next surface, and calls `f` with a `G2_surface_text`, or with a
  /// `Rational_bspline_surface<Traits>` if it has weights. Returns false, without a call, at the
  /// end of the text.
  /// \throws Error as `G2_surface_reader` does
  template <class Function> bool visit_next(Function f) {
    if (!parser_.next_object()) return false;
    line_ = parser_.line();
    G2_surface_text text;
    text.u_ = parser_.read_direction(internal::G2_shape::spline, " in u");
    text.v_ = parser_.read_direction(internal::G2_shape::spline, " in v");
    const long long all = static_cast<long long>(text.u_.points) * text.v_.points;
    if (parser_.rational()) {
      f(read_rational(text, all));
      return true;
    }
    // the text may be wrong
    text.coordinates_.reserve(static_cast<std::size_t>(3 * (std::min)(all, 64LL)));
    for (long long k = 0; k < all; ++k)
      for (int i = 0; i < 3; ++i) text.coordinates_.push_back(parser_.read_coordinate(i, k, all));
    f(std::move(text));
    return true;
  }

  /// Returns the line of the text, from 1 on, behind the header of the last surface.
  long long line() const { return line_; }

private:
  Rational_bspline_surface<Traits> read_rational(const G2_surface_text& text, long long all) {
    internal::G2_weighted_points<Traits, FT> w;
    for (long long k = 0; k < all; ++k) {
      const auto row = parser_.read_homogeneous_point(k, all);
      Coordinate_vector<FT, 4> values(4);
      for (int i = 0; i < 4; ++i) values[i] = FT(row[i].value());
      parser_.checked([&] { w.push_back(values); });
    }
    const auto direction = [](const internal::G2_direction<Decimal>& d) {
      internal::G2_direction<FT> result;
      result.points = d.points;
      result.order = d.order;
      for (const Decimal& x : d.knots) result.knots.push_back(FT(x.value()));
      return result;
    };
    return parser_.checked([&] {
      return internal::rational_g2_surface<Rational_bspline_surface<Traits>>(w, direction(text.u_), direction(text.v_));
    });
  }
};

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text in the `.g2` format, rational or not, piece by piece: for each span
/// of a B-spline curve its Bézier curve, with the span as domain, as
/// `Rational_bspline_curve::bezier_pieces()` returns them, and then those of the next curve. The
/// pieces of polynomial curves have the weights 1. The curve as a
/// whole is never there. Of a curve, only the knots as they are written and what belongs to one
/// span are kept, so that a text with millions of control points needs less memory than it has
/// characters. A curve of an order above 16 is read as a whole: to cut it span by span would take
/// much longer. Texts are accepted as by `G2_bspline_reader`; what is wrong in a curve is refused
/// when it is reached, which may be after its first pieces.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Source a model of `GeometricContinuityTraits` of the same dimension. Numbers are read as
///   `Source::FT`, which `parse_number()` accepts, and converted to `Traits::FT` before anything is
///   computed
template <class Traits, class Source = Traits> class G2_piece_reader {
  static constexpr int highest_order = 16; // of a curve that is cut span by span

  internal::G2_spline_parts<typename Source::FT, dimension_v<Traits>> parts_;
  // of the last part: what is left, the next one last
  std::vector<Rational_bezier_curve<Traits>> pieces_;

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_piece_reader(std::istream& is, std::string name) : parts_(is, std::move(name), highest_order) {}

  /// Returns the next piece, or nothing at the end of the text. After an error the reader cannot be
  /// used any more.
  /// \throws Error as `G2_bspline_reader` does, `work_limit`
  std::optional<Rational_bezier_curve<Traits>> next();

private:
  template <class Curve> void add_pieces(const Curve& curve) {
    for (const auto& piece : curve.bezier_pieces()) pieces_.emplace_back(piece);
    std::reverse(pieces_.begin(), pieces_.end());
  }
};

template <class Traits, class Source>
std::optional<Rational_bezier_curve<Traits>> G2_piece_reader<Traits, Source>::next() {
  while (pieces_.empty()) {
    internal::G2_spline_part<typename Source::FT> part;
    if (!parts_.next(part)) return std::nullopt;
    if (part.rational)
      parts_.checked([&] { add_pieces(internal::rational_curve<Traits>(part)); });
    else
      add_pieces(internal::polynomial_curve<Traits>(part));
  }
  std::optional<Rational_bezier_curve<Traits>> piece(std::move(pieces_.back()));
  pieces_.pop_back();
  return piece;
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H
