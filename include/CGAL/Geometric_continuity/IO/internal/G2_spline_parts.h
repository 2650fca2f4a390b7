// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H

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
namespace internal {

// Reads the curves of a text piece by piece, one for each span. A curve is cut in parts: for each span the curve of the points
// and knots that belong to it, which has this one span; curves of an order above 16 as a whole, as it would take longer to cut
// them span by span. Numbers are converted to Traits::FT before anything is computed.
template <class Traits, class Source, class Piece> class G2_spline_parts {
  typedef typename Traits::FT FT;
  typedef typename Source::FT Number;
  typedef typename Homogeneous_traits<Traits>::Point Row;
  static constexpr G2_shape shape = G2_shape::spline;
  static constexpr int highest_order = 16; // of a curve that is cut span by span

  G2_parser<Source> parser_;
  G2_size size_{0, 1}; // of the current curve
  G2_knot_text<Number> text_{1};
  int points_read_ = 0;
  std::deque<FT> knots_;                      // u_k-p, ..., u_k+p+1, where k is the number of the last point
  std::deque<typename Traits::Point> points_; // b_k-p, ..., b_k of a polynomial curve
  std::deque<Row> rows_;                      // (w b, w) of a rational one
  std::vector<Piece> pieces_;                 // of the last part: what is left, the next one last

public:
  G2_spline_parts(std::istream& is, std::string name) : parser_(is, std::move(name), g2_curves, G2_weights::allowed) {}

  // The next piece, or nothing at the end; cut(curve) are the pieces of a B-spline curve, rational or not.
  template <class Cut> std::optional<Piece> next(Cut cut) {
    while (pieces_.empty()) {
      if (points_read_ < size_.points) {
        if (!read_point()) continue;
        pieces_ = parser_.rational() ? parser_.checked([&] { return cut(rational_curve()); }) : cut(curve());
        std::reverse(pieces_.begin(), pieces_.end());
      } else if (parser_.next_object())
        start_curve();
      else
        return std::nullopt;
    }
    std::optional<Piece> piece(std::move(pieces_.back()));
    pieces_.pop_back();
    return piece;
  }

private:
  int degree() const { return size_.order - 1; }
  bool is_cut() const { return size_.order <= highest_order; }

  void start_curve() {
    size_ = parser_.read_size(shape);
    text_ = G2_knot_text<Number>(size_.order);
    parser_.read_knots(text_, size_, shape);
    points_read_ = 0;
    knots_.clear();
    points_.clear();
    rows_.clear();
    while (static_cast<int>(knots_.size()) < 2 * degree() + 1) knots_.push_back(FT(text_.take()));
  }

  // Returns whether the point belongs to the end of a part. The knots of a span are then in the middle of those that are there.
  bool read_point() {
    if (parser_.rational()) {
      const auto row = parser_.read_homogeneous_point(points_read_++, size_.points);
      parser_.checked([&] { rows_.push_back(converted<Homogeneous_traits<Traits>>(row)); });
    } else
      points_.push_back(converted<Traits>(coordinates<Source>(parser_.read_point(points_read_++, size_.points))));
    if (points_read_ < size_.order) return false;
    if (is_cut() && points_read_ > size_.order) {
      knots_.pop_front();
      if (parser_.rational())
        rows_.pop_front();
      else
        points_.pop_front();
    }
    knots_.push_back(FT(text_.take()));
    return is_cut() ? knots_[degree()] < knots_[degree() + 1] : points_read_ == size_.points;
  }

  template <class Target, class Numbers> static typename Target::Point converted(const Numbers& x) {
    Coordinates<Target> y(x.dimension());
    for (int i = 0; i < x.dimension(); ++i) y[i] = nearest_number<FT>(x[i]);
    return to_point<Target>(y);
  }

  Knot_vector<FT> knots() const { return {degree(), std::vector<FT>(knots_.begin(), knots_.end())}; }
  Bspline_curve<Traits> curve() const { return {points_.begin(), points_.end(), knots()}; }
  Rational_bspline_curve<Traits> rational_curve() const {
    return Rational_bspline_curve<Traits>(
        typename Rational_bspline_curve<Traits>::Homogeneous(rows_.begin(), rows_.end(), knots()));
  }
};

} // namespace internal

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H
