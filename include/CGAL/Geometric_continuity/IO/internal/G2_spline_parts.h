// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H

#include <CGAL/Geometric_continuity/IO/internal/G2_parser.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/curves/Rational_curve.h>

#include <cstddef>
#include <istream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The knots of a spline as they are read, equal ones once with their multiplicity, and then as they
// are taken, from the first on.
template <class Number> class G2_knot_runs {
  struct Run {
    Number knot;
    std::size_t multiplicity;
  };

  std::vector<Run> runs_;
  std::size_t size_ = 0, run_ = 0, taken_ = 0; // taken of the current run

public:
  typedef Number value_type;

  void clear() {
    runs_.clear();
    size_ = run_ = taken_ = 0;
  }

  std::size_t size() const { return size_; }
  const Number& front() const { return runs_.front().knot; }
  const Number& back() const { return runs_.back().knot; }

  void push_back(const Number& knot) {
    if (size_++ > 0 && knot == back())
      ++runs_.back().multiplicity;
    else
      runs_.push_back({knot, 1});
  }

  // Returns one knot after the other, from the first on. \pre not called more often than there are
  // knots
  const Number& take() {
    if (taken_ == runs_[run_].multiplicity) {
      ++run_;
      taken_ = 0;
    }
    ++taken_;
    return runs_[run_].knot;
  }
};

// Knots of floating-point type as they are, others as they stand in the text, which takes less
// memory.
template <class FT> using G2_knot = std::conditional_t<std::is_floating_point_v<FT>, FT, Decimal>;

// A part of a B-spline curve: a curve of these knots and control points, which has one span or, if
// it is the whole curve, more.
template <class FT> struct G2_spline_part {
  typedef typename Exact_field<FT>::type Exact;

  int degree = 0, dimension = 0;
  bool rational = false;
  std::vector<G2_knot<FT>> knots;
  std::vector<FT> coordinates;    // of one point after the other, if polynomial
  std::vector<Exact> homogeneous; // (w x, w) of one point after the other, if rational
};

// Reads the curves of a text in parts, one for each span: the curve of the points and knots that
// belong to it, which has this one span; curves of an order above `highest_order` as a whole.
template <class FT, int N, class Concurrency_tag = Sequential_tag> class G2_spline_parts {
  typedef G2_spline_part<FT> Part;

  G2_parser<FT, N, Concurrency_tag> parser_;
  const int highest_order_;
  G2_size size_{0, 1}; // of the current curve
  G2_knot_runs<G2_knot<FT>> knots_;
  int points_read_ = 0;
  Part part_; // u_k-p, ..., u_k+p+1 and b_k-p, ..., b_k, where k is the number of the last point

public:
  G2_spline_parts(std::istream& is, std::string name, int highest_order)
      : parser_(is, std::move(name), g2_curves, G2_weights::allowed), highest_order_(highest_order) {}

  // Reads the next part. Returns false at the end.
  bool next(Part& part) {
    for (;;) {
      if (points_read_ < size_.points) {
        if (!read_point()) continue;
        if (points_read_ == size_.points)
          std::swap(part, part_); // its memory is used again
        else
          part = part_;
        return true;
      }
      if (!parser_.next_object()) return false;
      start_curve();
    }
  }

  // The line of the last number that was read.
  long long line() const { return parser_.line(); }

  // Calls f(), and refuses what is wrong with the part that has been read.
  template <class Function> auto checked(Function f) const { return parser_.checked(f); }

private:
  bool is_cut() const { return size_.order <= highest_order_; }

  void start_curve() {
    size_ = parser_.read_size(G2_shape::spline);
    knots_.clear();
    parser_.read_knots(knots_, size_, G2_shape::spline);
    points_read_ = 0;
    part_.degree = size_.order - 1;
    part_.dimension = parser_.dimension();
    part_.rational = parser_.rational();
    part_.knots.clear();
    part_.coordinates.clear();
    part_.homogeneous.clear();
    // equivalent [* -> +, 1]: memory only
    part_.knots.reserve(2 * size_.order);
    while (static_cast<int>(part_.knots.size()) < 2 * part_.degree + 1) part_.knots.push_back(knots_.take());
  }

  // Returns whether the point belongs to the end of a part. The knots of a span are then in the
  // middle of those that are there.
  bool read_point() {
    const std::size_t width = static_cast<std::size_t>(part_.dimension + part_.rational);
    if (is_cut() && points_read_ >= size_.order) {
      part_.knots.erase(part_.knots.begin());
      if (part_.rational)
        part_.homogeneous.erase(part_.homogeneous.begin(),
                                part_.homogeneous.begin() + static_cast<std::ptrdiff_t>(width));
      else
        part_.coordinates.erase(part_.coordinates.begin(),
                                part_.coordinates.begin() + static_cast<std::ptrdiff_t>(width));
    }
    if (part_.rational) {
      if (points_read_ == 0) part_.homogeneous.reserve(width * size_.order);
      for (std::size_t i = 0; i < width; ++i)
        part_.homogeneous.push_back(parser_.read_homogeneous_coordinate(points_read_, size_.points));
    } else {
      if (points_read_ == 0) part_.coordinates.reserve(width * size_.order);
      for (std::size_t i = 0; i < width; ++i)
        part_.coordinates.push_back(parser_.read_coordinate(static_cast<int>(i), points_read_, size_.points));
    }
    ++points_read_;
    if (points_read_ < size_.order) return false;
    part_.knots.push_back(knots_.take());
    return is_cut() ? part_.knots[part_.degree] < part_.knots[part_.degree + 1] : points_read_ == size_.points;
  }
};

// The number of a part as a number of a curve: as it is, from the text, or the nearest one.
template <class FT, class Number> FT curve_number(const Number& x) {
  if constexpr (std::is_same_v<Number, Decimal>)
    return nearest_number<FT>(x.value());
  else
    return nearest_number<FT>(x);
}

template <class FT, class Part> Knot_vector<FT> knots_of(const Part& part) {
  std::vector<FT> knots;
  for (const auto& knot : part.knots) knots.push_back(curve_number<FT>(knot));
  return {part.degree, std::move(knots)};
}

// The points of a traits class with these coordinates, one point after the other.
template <class Traits, class Number>
std::vector<typename Traits::Point> points_of_numbers(const std::vector<Number>& numbers, int dimension) {
  std::vector<typename Traits::Point> points;
  for (std::size_t first = 0; first < numbers.size(); first += static_cast<std::size_t>(dimension)) {
    Coordinates<Traits> x(dimension);
    for (int i = 0; i < dimension; ++i)
      x[i] = curve_number<typename Traits::FT>(numbers[first + static_cast<std::size_t>(i)]);
    points.push_back(to_point<Traits>(x));
  }
  return points;
}

// The curve of a part, with numbers converted before anything is computed. \pre part.rational is
// false
template <class Traits, class Part> Bspline_curve<Traits> polynomial_curve(const Part& part) {
  const auto points = points_of_numbers<Traits>(part.coordinates, part.dimension);
  return {points.begin(), points.end(), knots_of<typename Traits::FT>(part)};
}

// Makes a rational curve of its parts.
template <class Traits, class Part> Rational_bspline_curve<Traits> rational_curve(const Part& part) {
  typedef Rational_bspline_curve<Traits> Curve;
  const auto rows = points_of_numbers<Homogeneous_traits<Traits>>(part.homogeneous, part.dimension + 1);
  return Curve(typename Curve::Homogeneous(rows.begin(), rows.end(), knots_of<typename Traits::FT>(part)));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_SPLINE_PARTS_H
