// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_spline_parts.h>
#include <CGAL/Geometric_continuity/curves/Rational_bspline_curve.h>

#include <algorithm>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text in the `.g2` format, rational or not, piece by piece: for each span of a B-spline curve its Bézier
/// curve, with the span as domain, as `Rational_bspline_curve::bezier_pieces()` returns them, and then those of the next curve. The
/// pieces of polynomial curves have the weights 1. The curve as a
/// whole is never there. Of a curve, only the knots as they are written and what belongs to one span are kept, so that a
/// text with millions of control points needs less memory than it has characters. A curve of an order above 16 is read as a
/// whole: to cut it span by span would take much longer. Texts are accepted as by
/// `G2_bspline_reader`; what is wrong in a curve is refused when it is reached, which may be after its first pieces.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Source a model of `GeometricContinuityTraits` of the same dimension. Numbers are read as `Source::FT`, which
///   `parse_number()` accepts, and converted to `Traits::FT` before anything is computed
template <class Traits, class Source = Traits> class G2_piece_reader {
  static constexpr int highest_order = 16; // of a curve that is cut span by span

  internal::G2_spline_parts<typename Source::FT, dimension_v<Traits>> parts_;
  std::vector<Rational_bezier_curve<Traits>> pieces_; // of the last part: what is left, the next one last

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_piece_reader(std::istream& is, std::string name) : parts_(is, std::move(name), highest_order) {}

  /// Returns the next piece, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error as `G2_bspline_reader` does, `work_limit`
  std::optional<Rational_bezier_curve<Traits>> next() {
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

private:
  template <class Curve> void add_pieces(const Curve& curve) {
    for (const auto& piece : curve.bezier_pieces()) pieces_.emplace_back(piece);
    std::reverse(pieces_.begin(), pieces_.end());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
