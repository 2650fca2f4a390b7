// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_knot_text.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_weighted_points.h>
#include <CGAL/Geometric_continuity/curves/Rational_bspline_curve.h>

#include <algorithm>
#include <deque>
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
  typedef typename Traits::FT FT;
  typedef typename Source::FT Number;
  typedef typename Homogeneous_traits<Traits>::Point Row; // a control point with its weight
  static constexpr internal::G2_shape shape = internal::G2_shape::spline;
  static constexpr int highest_order = 16; // of a curve that is cut span by span

  internal::G2_parser<Source> parser_;
  internal::G2_size size_{0, 1}; // of the current curve
  internal::G2_knot_text<Number> text_{1};
  int points_read_ = 0;
  Work_limit limit_;
  std::deque<FT> knots_;                      // u_k-p, ..., u_k+p+1, where k is the number of the last point
  std::deque<typename Traits::Point> points_; // b_k-p, ..., b_k of a polynomial curve
  std::deque<Row> rows_;                      // (w b, w) of a rational one
  std::vector<Rational_bezier_curve<Traits>>
      pieces_; // of a curve that is read as a whole: what is left, the next one last

public:
  /// Reads from `is`, which must outlive the reader. Error messages begin with `name`. The limit is that for each piece.
  /// \throws Error `cannot_read_file` when the stream is not good
  G2_piece_reader(std::istream& is, std::string name, Work_limit limit = Work_limit())
      : parser_(is, std::move(name), internal::g2_curves, internal::G2_weights::allowed), limit_(limit) {}

  /// Returns the next piece, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error as `G2_bspline_reader` does, `work_limit`
  std::optional<Rational_bezier_curve<Traits>> next() {
    for (;;) {
      if (!pieces_.empty()) {
        const Rational_bezier_curve<Traits> piece = std::move(pieces_.back());
        pieces_.pop_back();
        return piece;
      }
      while (points_read_ < size_.points)
        if (read_point()) return pieces().front();
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
    rows_.clear();
    while (static_cast<int>(knots_.size()) < 2 * degree() + 1) knots_.push_back(FT(text_.take()));
    if (size_.order > highest_order) read_whole_curve();
  }

  void read_whole_curve() {
    while (points_read_ < size_.points) {
      append_point();
      if (points_read_ >= size_.order) knots_.push_back(FT(text_.take()));
    }
    pieces_ = pieces();
    std::reverse(pieces_.begin(), pieces_.end());
  }

  void append_point() {
    if (parser_.rational()) {
      const auto row = parser_.read_homogeneous_point(points_read_++, size_.points);
      parser_.checked([&] { rows_.push_back(converted<Homogeneous_traits<Traits>>(row)); });
    } else
      points_.push_back(converted<Traits>(coordinates<Source>(parser_.read_point(points_read_++, size_.points))));
  }
  template <class Target, class Numbers> static typename Target::Point converted(const Numbers& x) {
    Coordinates<Target> y(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) y[i] = internal::nearest_number<FT>(x[i]);
    return to_point<Target>(y);
  }

  // Returns whether the point belongs to the end of a span, which is then the one in the middle of the knots.
  bool read_point() {
    append_point();
    if (points_read_ < size_.order) return false;
    if (points_read_ > size_.order) {
      knots_.pop_front();
      if (parser_.rational())
        rows_.pop_front();
      else
        points_.pop_front();
    }
    knots_.push_back(FT(text_.take()));
    return knots_[degree()] < knots_[degree() + 1];
  }

  // Of the curve of the points and knots that are there.
  std::vector<Rational_bezier_curve<Traits>> pieces() const {
    const Knot_vector<FT> knots(degree(), std::vector<FT>(knots_.begin(), knots_.end()));
    std::vector<Rational_bezier_curve<Traits>> pieces;
    if (parser_.rational())
      parser_.checked([&] {
        for (const auto& piece :
             Bspline_curve<Homogeneous_traits<Traits>>(rows_.begin(), rows_.end(), knots).bezier_pieces(limit_))
          pieces.emplace_back(piece);
      });
    else
      for (const auto& piece : Bspline_curve<Traits>(points_.begin(), points_.end(), knots).bezier_pieces(limit_))
        pieces.emplace_back(piece);
    return pieces;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_PIECE_READER_H
