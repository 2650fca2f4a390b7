// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_knot_text.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>

#include <deque>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text in the `.g2` format piece by piece: for each span of a B-spline curve its Bézier curve, with
/// the span as domain, as `Bspline_curve::bezier_pieces()` returns them, and then those of the next curve. The curve as a
/// whole is never there. Of a curve, only the knots as they are written and what belongs to one span are kept, so that a
/// text with millions of control points needs less memory than it has characters. Texts are accepted as by
/// `G2_bspline_reader`; what is wrong in a curve is refused when it is reached, which may be after its first pieces.
///
/// \tparam Traits a model of `GeometricContinuityTraits`
/// \tparam Source a model of `GeometricContinuityTraits` of the same dimension. Numbers are read as `Source::FT`, which
///   `parse_number()` accepts, and converted to `Traits::FT` before anything is computed
template <class Traits, class Source = Traits> class G2_piece_reader {
  typedef typename Traits::FT FT;
  typedef typename Source::FT Number;
  static constexpr internal::G2_shape shape = internal::G2_shape::spline;

  internal::G2_parser<Source> parser_;
  internal::G2_size size_{0, 1}; // of the current curve
  internal::G2_knot_text<Number> text_{1};
  int points_read_ = 0;
  std::deque<FT> knots_;                      // u_k-p, ..., u_k+p+1, where k is the number of the last point
  std::deque<typename Traits::Point> points_; // b_k-p, ..., b_k

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_piece_reader(std::istream& is, std::string name) : parser_(is, std::move(name), internal::g2_curves) {}

  /// Returns the next piece, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error as `G2_bspline_reader` does
  std::optional<Bezier_curve<Traits>> next() {
    for (;;) {
      while (points_read_ < size_.points)
        if (read_point()) return piece();
      if (!parser_.next_object()) return std::nullopt;
      start_curve();
    }
  }

private:
  int degree() const { return size_.order - 1; }

  void start_curve() {
    size_ = parser_.read_size(shape);
    text_ = internal::G2_knot_text<Number>(size_.order);
    parser_.read_knots(text_, size_, shape);
    points_read_ = 0;
    knots_.clear();
    points_.clear();
    while (static_cast<int>(knots_.size()) < 2 * degree() + 1) knots_.push_back(FT(text_.take()));
  }

  // Returns whether the point belongs to the end of a span, which is then the one in the middle of the knots.
  bool read_point() {
    const Coordinates<Source> x = coordinates<Source>(parser_.read_point(points_read_, size_.points));
    Coordinates<Traits> y(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) y[i] = FT(x[i]);
    points_.push_back(to_point<Traits>(y));
    if (++points_read_ < size_.order) return false;
    if (points_read_ > size_.order) {
      knots_.pop_front();
      points_.pop_front();
    }
    knots_.push_back(FT(text_.take()));
    return knots_[degree()] < knots_[degree() + 1];
  }

  Bezier_curve<Traits> piece() {
    const Bspline_curve<Traits> spline(points_.begin(), points_.end(),
                                       Knot_vector<FT>(degree(), std::vector<FT>(knots_.begin(), knots_.end())));
    return spline.bezier_pieces().front();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
