// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_G2_END_JET_READER_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_G2_END_JET_READER_H

#include <CGAL/Geometric_continuity/IO/internal/G2_spline_parts.h>
#include <CGAL/Geometric_continuity/curves/Bspline_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_end_jets.h>

#include <istream>
#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Reads the curves of a text in the `.g2` format piece by piece as `G2_piece_reader` does, but of each piece only the jets at its
/// ends, as `Rational_bspline_curve::span_end_jets()` returns them. That is what the decision of all joins needs, and of high orders much
/// faster.
///
/// \tparam Traits, Source as those of `G2_piece_reader`
template <class Traits, class Source = Traits> class G2_end_jet_reader {
  internal::G2_spline_parts<Traits, Source, Curve_end_jets<Traits>> parts_;
  int order_;
  Work_limit limit_;

public:
  /// Reads jets of this order from `is`, which must outlive the reader. Error messages begin with `name`. The limit is that for
  /// each piece.
  /// \throws Error `negative_count` for a negative order, `cannot_read_file` when the stream is not good
  G2_end_jet_reader(std::istream& is, std::string name, int order, Work_limit limit = Work_limit())
      : parts_(is, std::move(name)), order_(order), limit_(limit) {
    internal::check_count(order, "G2_end_jet_reader");
  }

  /// Returns the jets of the next piece, or nothing at the end of the text. After an error the reader cannot be used any more.
  /// \throws Error as `G2_bspline_reader` does, `work_limit`
  std::optional<Curve_end_jets<Traits>> next() {
    return parts_.next([this](const auto& curve) { return curve.span_end_jets(order_, limit_); });
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_G2_END_JET_READER_H
