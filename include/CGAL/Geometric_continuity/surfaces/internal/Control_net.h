// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_CONTROL_NET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_CONTROL_NET_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file Control_net.h
/// The control points of a tensor-product surface and what all such surfaces do with them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The degrees to which surfaces are raised end here, so that a wrong number can fill neither memory
// nor time.
constexpr int most_raised_degree = 4096;

inline void check_elevation(int degree, int times, const char* place) {
  check_count(times, place);
  if (times > 0 && times > most_raised_degree - degree)
    throw Error(Error_code::work_limit, std::string(place) + ": a degree above " + std::to_string(most_raised_degree));
}

// Exchanges rows and columns. The first function takes rows of constant i, with so many columns;
// the second one also reverses the order of the rows.
template <class T> std::vector<T> transposed(const std::vector<T>& net, int rows, int columns) {
  std::vector<T> r;
  r.reserve(net.size());
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) r.push_back(net[static_cast<std::size_t>(i) * columns + j]);
  return r;
}
template <class T> std::vector<T> reversed_rows(const std::vector<T>& net, int columns) {
  std::vector<T> r;
  r.reserve(net.size());
  for (auto row = net.end(); row != net.begin(); row -= columns) r.insert(r.end(), row - columns, row);
  return r;
}

// Tells whether this is a range of ranges.
template <class Net, class = void> constexpr bool is_net = false;
template <class Net>
constexpr bool is_net<Net, std::void_t<decltype(std::begin(*std::begin(std::declval<const Net&>())))>> = true;

// The points b_ij in rows of constant i. `surface` is the name of the surface, for messages.
template <class Traits> class Control_net {
  typedef typename Traits::Point Point;

  int rows_ = 0, columns_ = 0;
  std::vector<Point> points_; // b_ij at i columns + j

public:
  typedef typename std::vector<Point>::const_iterator const_iterator;

  // Takes a range of ranges. There must be at least one point, rows of one length, points of one
  // dimension and finite coordinates.
  template <class Net> Control_net(const Net& net, const char* surface) {
    static_assert(is_net<Net>, "a control net is a range of rows, each of which is a range of points, as in "
                               "{{p, q}, {r, s}}; Bezier_patch<Traits>(1, 1, points) takes the degrees and one list");
    if constexpr (is_net<Net>) { // so that there is one error
      for (const auto& row : net) {
        const int n = static_cast<int>(std::distance(std::begin(row), std::end(row)));
        if (rows_ > 0 && n != columns_)
          throw Error(Error_code::wrong_number_of_points, std::string(surface) + ": " + std::to_string(n) +
                                                              " control points in row " + std::to_string(rows_) +
                                                              " after " + std::to_string(columns_));
        points_.insert(points_.end(), std::begin(row), std::end(row));
        columns_ = n;
        ++rows_;
      }
    }
    if (points_.empty()) throw Error(Error_code::wrong_number_of_points, std::string(surface) + ": no control point");
    check(surface);
  }

  // Takes rows * columns points, at least one.
  Control_net(int rows, int columns, std::vector<Point> points, const char* surface)
      : rows_(rows), columns_(columns), points_(std::move(points)) {
    if (rows_ < 1 || columns_ < 1 ||
        points_.size() != static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_))
      throw Error(Error_code::wrong_number_of_points, std::string(surface) + ": " + std::to_string(points_.size()) +
                                                          " control points in " + std::to_string(rows_) + " rows of " +
                                                          std::to_string(columns_));
    check(surface);
  }

  // Takes as many points that are known to be such: nothing is checked.
  Control_net(int rows, int columns, std::vector<Point> points)
      : rows_(rows), columns_(columns), points_(std::move(points)) {}

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int dimension() const { return Traits().compute_dimension_object()(points_[0]); }
  const Point& operator()(int i, int j) const { return points_[static_cast<std::size_t>(i) * columns_ + j]; }
  Coordinates<Traits> coordinates(int i, int j) const {
    return Geometric_continuity::coordinates<Traits>((*this)(i, j));
  }
  const_iterator begin() const { return points_.begin(); }
  const_iterator end() const { return points_.end(); }

  // b_0j, b_1j, ...
  std::vector<Coordinates<Traits>> column(int j) const {
    std::vector<Coordinates<Traits>> c;
    for (int i = 0; i < rows_; ++i) c.push_back(coordinates(i, j));
    return c;
  }

  // The net b_ji.
  Control_net transpose() const { return Control_net(columns_, rows_, transposed(points_, rows_, columns_)); }
  // Returns the net with the rows in reverse order.
  Control_net reverse_rows() const { return Control_net(rows_, columns_, reversed_rows(points_, columns_)); }

  // The images of the points under a map.
  template <class Map> Control_net transform(const Map& map, const char* surface) const {
    std::vector<Point> points;
    for (const Point& p : points_) points.push_back(map(p));
    return Control_net(rows_, columns_, std::move(points), surface);
  }

  friend bool operator==(const Control_net& a, const Control_net& b) {
    return a.rows_ == b.rows_ && a.columns_ == b.columns_ && a.points_ == b.points_;
  }

  // Writes one row to a line, each after the end of the line before it.
  friend std::ostream& operator<<(std::ostream& os, const Control_net& net) {
    for (int i = 0; i < net.rows_; ++i) {
      os << '\n';
      for (int j = 0; j < net.columns_; ++j) os << (j > 0 ? " " : "") << net.coordinates(i, j);
    }
    return os;
  }

private:
  void check(const char* surface) const {
    const auto refuse = [&](Error_code code, int i, int j) {
      throw Error(code, std::string(surface) + ": control point " + std::to_string(i) + ", " + std::to_string(j));
    };
    const int d = dimension_v<Traits> == 0 ? dimension() : dimension_v<Traits>;
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j) {
        const Point& p = (*this)(i, j);
        if (dimension_v<Traits> == 0 && Traits().compute_dimension_object()(p) != d)
          refuse(Error_code::dimension_mismatch, i, j);
        if constexpr (std::is_floating_point_v<typename Traits::FT>)
          for (int k = 0; k < d; ++k)
            if (!std::isfinite(Traits().compute_coordinate_object()(p, k))) refuse(Error_code::not_finite, i, j);
      }
  }
};

// The control points b_ij with i and j in two closed ranges.
template <class Traits>
std::vector<std::vector<typename Traits::Point>> part_of_net(const Control_net<Traits>& net, int first_i, int last_i,
                                                             int first_j, int last_j) {
  std::vector<std::vector<typename Traits::Point>> part;
  for (int i = first_i; i <= last_i; ++i) part.emplace_back(&net(i, first_j), &net(i, last_j) + 1);
  return part;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_CONTROL_NET_H
