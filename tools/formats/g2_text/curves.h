// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_CURVES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_CURVES_H

#include "files/input.h"
#include "files/progress.h"

#include <CGAL/Cartesian_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>
#include <CGAL/Geometric_continuity/local/Curve_jet.h>

#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// One instantiation for each number type serves all dimensions.
template <class FT> using Program_traits = GC::Traits_d<CGAL::Cartesian_d<FT>>;
template <class FT>
using Program_curve = GC::Rational_bezier_curve<Program_traits<FT>>; // polynomial ones have the weights 1
typedef CGAL::Exact_rational Exact;
typedef Program_curve<Exact> Exact_curve;
typedef GC::Curve_end_jets<Program_traits<Exact>> Exact_ends;

// Returns the curve with the same control points, weights and domain, as exact numbers.
template <class FT> Exact_curve exact(const Program_curve<FT>& curve) {
  if constexpr (std::is_same_v<FT, Exact>)
    return curve;
  else {
    std::vector<Exact_curve::Homogeneous::Point> rows;
    for (int j = 0; j <= curve.degree(); ++j) {
      const GC::Coordinate_vector<FT, 0> x = curve.coordinates(j);
      GC::Coordinate_vector<Exact, 0> c(x.dimension());
      for (int i = 0; i < x.dimension(); ++i) c[i] = Exact(x[i]);
      rows.push_back(GC::homogeneous_point(c, Exact(curve.weight(j))));
    }
    return Exact_curve(
        Exact_curve::Homogeneous(rows.begin(), rows.end(), Exact(curve.domain().first), Exact(curve.domain().second)));
  }
}

// Returns the curve that a reader of the file has before him to which this one is written: floating-point numbers are written as
// the shortest decimals that lead back to them, which are other numbers.
template <class FT> Exact_curve as_written(const Program_curve<FT>& curve) {
  if constexpr (std::is_same_v<FT, Exact>)
    return curve;
  else {
    std::stringstream text;
    GC::write_g2(text, curve);
    return *GC::G2_piece_reader<Program_traits<Exact>>(text, "what is written").next();
  }
}

// Returns a curve of which all weights are equal without them. Throws std::invalid_argument for any other, with what needs that.
template <class FT>
GC::Bezier_curve<Program_traits<FT>> polynomial(const Program_curve<FT>& curve, const std::string& what) {
  if (const std::optional<GC::Bezier_curve<Program_traits<FT>>> c = curve.polynomial()) return *c;
  throw std::invalid_argument(what + " needs polynomial curves, and one of these is rational");
}

// Reads the curves of several files piece by piece, one file after the other. A curve with inner knots is cut into its spans; only
// one of them is kept in memory. Reader is `G2_piece_reader` or `G2_span_reader`.
template <class Reader> class Curve_stream {
  std::vector<std::string> files_;
  Reading_position position_;
  std::size_t next_file_ = 0;
  std::unique_ptr<Input> input_;
  std::function<void(std::optional<Reader>&, std::istream&, const std::string&)> open_;
  std::optional<Reader> reader_;
  int dimension_ = 0;

public:
  // The options are the last arguments of the readers.
  template <class... Options>
  explicit Curve_stream(const std::vector<std::string>& files, Options... options)
      : files_(files), position_(files),
        open_([options...](std::optional<Reader>& reader, std::istream& is, const std::string& name) {
          reader.emplace(is, name, options...);
        }) {}

  // Returns which part of the files has been read, from 0 to 1; 0 when that is not known.
  double part_read() { return input_ ? position_.part(next_file_ - 1, *input_) : 0; }

  // Returns the number of the file of the last piece, from 1 on, and its name.
  std::size_t file_number() const { return next_file_; }
  std::string file() const { return input_name(files_[next_file_ - 1]); }

  // Returns the line of the file in which the last number of the last piece stands.
  long long line() const { return reader_->line(); }

  // Reads the next piece: an optional curve, or a span. Returns false after the last one.
  template <class Piece> bool next(Piece& piece) {
    for (;;) {
      if (reader_)
        if (const int dimension = read(*reader_, piece)) {
          if (dimension_ != 0 && dimension != dimension_)
            throw GC::Error(GC::Error_code::dimension_mismatch, file() + ": dimension " + std::to_string(dimension) +
                                                                    " after a curve of dimension " +
                                                                    std::to_string(dimension_));
          dimension_ = dimension;
          return true;
        }
      if (next_file_ == files_.size()) return false;
      const std::string& name = files_[next_file_++];
      reader_.reset();
      input_ = std::make_unique<Input>(name);
      open_(reader_, *input_, input_name(name));
    }
  }

private:
  // These return the dimension, or 0 at the end.
  template <class Curve> static int read(Reader& reader, std::optional<Curve>& curve) {
    curve = reader.next();
    return curve ? curve->dimension() : 0;
  }
  template <class Span> static int read(Reader& reader, Span& span) { return reader.next(span) ? span.dimension() : 0; }
};

// Reads all curves of several files.
template <class FT> std::vector<Program_curve<FT>> read_curves(const std::vector<std::string>& files) {
  Curve_stream<GC::G2_piece_reader<Program_traits<FT>>> stream(files);
  std::vector<Program_curve<FT>> curves;
  for (std::optional<Program_curve<FT>> curve; stream.next(curve);) curves.push_back(*curve);
  return curves;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_CURVES_H
