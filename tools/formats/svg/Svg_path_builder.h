// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_BUILDER_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_BUILDER_H

#include "formats/svg/Svg_subpath.h"
#include "formats/svg/svg_size.h"
#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {

// A straight cubic or quadratic with a handle that is retracted into its node, as editors write
// lines: all control points lie between the ends. Its first derivative vanishes at the node, that
// of the line does not.
template <class FT> bool is_line_with_retracted_handle(const std::vector<Coordinate_vector<FT, 2>>& points) {
  typedef Coordinate_vector<FT, 2> Coordinates;
  const std::size_t m = points.size() - 1;
  if (points[1] != points[0] && points[m - 1] != points[m]) return false;
  const Coordinates chord = points[m] - points[0];
  if (is_zero(chord)) return false;
  for (std::size_t j = 1; j < m; ++j) {
    const Coordinates handle = points[j] - points[0];
    const FT along = dot(chord, handle);
    if (FT(chord[0] * handle[1]) != FT(chord[1] * handle[0]) || along < FT(0) || dot(chord, chord) < along)
      return false;
  }
  return true;
}

// Executes the commands of path data, in absolute coordinates, and collects the segments of one
// subpath after the other.
template <class Traits> class Svg_path_builder {
public:
  typedef typename Traits::FT FT;
  typedef Coordinate_vector<FT, 2> Coordinates;

private:
  std::deque<Svg_segment<Traits>> segments_; // which are not copied when there are more of them
  std::optional<Svg_subpath<Traits>> complete_;
  Coordinates start_{2}, current_{2}, control_{2}; // control_: the last handle
  int control_degree_ = 1;                         // of the curve to which it belongs
  long long commands_ = 0;
  char letter_ = 'M';
  std::size_t place_ = 0;

  void finish(bool closed) {
    if (!closed && segments_.empty()) return;
    complete_.emplace();
    complete_->closed = closed;
    complete_->segments.swap(segments_);
  }

  void add(std::vector<Coordinates> points) {
    if (points.size() > 2 && is_line_with_retracted_handle(points)) points.erase(points.begin() + 1, points.end() - 1);
    Svg_segment<Traits>& segment = segments_.emplace_back();
    segment.curve.template emplace<Bezier_curve<Traits>>(points);
    segment.command = commands_;
    segment.letter = letter_;
    segment.place = place_;
    current_ = std::move(points.back());
  }

  void add_line(const Coordinates& x) {
    std::vector<Coordinates> points;
    points.reserve(2);
    points.push_back(current_);
    points.push_back(x);
    add(std::move(points));
  }

public:
  // Each command is announced, also when it draws nothing.
  void begin_command(char letter, std::size_t place) {
    letter_ = letter;
    place_ = place;
    ++commands_;
  }

  const Coordinates& current() const { return current_; }

  void move_to(const Coordinates& x) {
    finish(false);
    start_ = current_ = x;
    control_degree_ = 1;
  }

  void line_to(const Coordinates& x) {
    add_line(x);
    control_degree_ = 1;
  }

  // With the current point, the inner control points and the end of a curve of degree 2 or 3.
  void curve_to(std::vector<Coordinates> points) {
    control_ = points[points.size() - 2];
    control_degree_ = static_cast<int>(points.size()) - 1;
    add(std::move(points));
  }

  // The last handle reflected at the current point, when the last command drew a curve of this
  // degree.
  Coordinates reflected_control(int degree) const {
    if (control_degree_ != degree) return current_;
    Coordinates x;
    for (int i = 0; i < 2; ++i) x[i] = short_sum(short_sum(current_[i], current_[i]), FT(-control_[i]));
    return x;
  }

  // An arc without a radius is a line, and one between equal points is nothing.
  void arc_to(const Elliptical_arc_parameters<FT>& parameters, const Coordinates& x) {
    control_degree_ = 1;
    if (x == current_) return;
    if (parameters.rx == FT(0) || parameters.ry == FT(0)) return add_line(x);
    const Elliptical_arc<Traits> arc(to_point<Traits>(current_), to_point<Traits>(x), parameters);
    if (!has_short_parts<max_svg_radicand_bits>(arc.radicand()) ||
        !has_short_parts<max_svg_ratio_bits>(FT(parameters.rx / parameters.ry)))
      throw Error(Error_code::work_limit, "the sizes of an arc differ too much");
    segments_.push_back({{arc}, commands_, letter_, place_});
    current_ = x;
  }

  // With a line to the start where that is missing.
  void close() {
    if (current_ != start_) add_line(start_);
    finish(true);
    current_ = start_;
    control_degree_ = 1;
  }

  void end() { finish(false); }

  // The subpath that the last command has completed.
  std::optional<Svg_subpath<Traits>> take_complete() {
    std::optional<Svg_subpath<Traits>> result = std::move(complete_);
    complete_.reset();
    return result;
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_SVG_SVG_PATH_BUILDER_H
