// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H

/// \file IO/G2_text_reader.h
/// Curves of the format `.g2` with the places of their numbers, so that a program can change numbers and leave everything
/// else of a text as it is.

#include <CGAL/Geometric_continuity/IO/Text_number.h>
#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>

#include <cstddef>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// A curve as a text of the format `.g2` writes it.
struct G2_curve_text {
  /// A number, and the bytes of the text from `begin` up to `end` that are it.
  struct Written_number {
    Text_number value;
    std::size_t begin, end;
  };

  int dimension;                           ///< of the points
  int points;                              ///< the number of control points
  int order;                               ///< the degree plus one
  bool rational;                           ///< each point is followed by its weight, \f$ (w x, w) \f$
  bool is_line;                            ///< the object is a line (class 120): its control points are not in the text
  std::vector<Written_number> coordinates; ///< of one point after the other, with weights; empty for a line
};

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text of the format `.g2`, one after the other, as `G2_piece_reader` does, with the places of
/// their coordinates. Memory: the coordinates of one curve.
class G2_text_reader {
  internal::G2_parser<Text_number, 0> parser_;
  internal::G2_size size_{0, 0};
  std::vector<Text_number> knots_;

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
        const Text_number value = parser_.read_coordinate(i, k, curve.points);
        const auto [begin, end] = parser_.place();
        curve.coordinates.push_back({value, begin, end});
      }
    return true;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_TEXT_READER_H
