// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_RATIONAL_NET_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_RATIONAL_NET_H

#include <CGAL/Geometric_continuity/curves/internal/denominator.h>
#include <CGAL/Geometric_continuity/curves/internal/positive_parts.h>
#include <CGAL/Geometric_continuity/local/Homogeneous_traits.h>
#include <CGAL/Geometric_continuity/surfaces/internal/Control_net.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// \file Rational_net.h
/// The control points and weights of a rational tensor-product surface and what all such surfaces do with them.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The points b_ij as given, with a weight w_ij each. Points of the weight 0 are infinite when they come from homogeneous points,
// otherwise they contribute nothing and are the origin.
template <class Traits> class Rational_net {
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;

  Control_net<Traits> points_;
  std::vector<FT> weights_; // w_ij at i columns + j

public:
  // All weights are 1.
  explicit Rational_net(Control_net<Traits> points)
      : points_(std::move(points)),
        weights_(static_cast<std::size_t>(points_.rows()) * static_cast<std::size_t>(points_.columns()), FT(1)) {}

  // From points and a range of ranges of weights. `surface` is the name of the surface, for messages.
  template <class Weights>
  Rational_net(const Control_net<Traits>& points, const Weights& weights, const char* surface)
      : Rational_net(finite(points, weights_of(points, weights, surface), surface)) {}

  // From the homogeneous points of a polynomial surface, in its order.
  template <class Iterator>
  Rational_net(int rows, int columns, Iterator first, Iterator last, const char* surface)
      : points_(rows, columns, affine_points(first, last), surface) {
    for (; first != last; ++first) weights_.push_back((*first)[first->dimension() - 1]);
    check_finite_weights(weights_, surface);
  }

  int rows() const { return points_.rows(); }
  int columns() const { return points_.columns(); }
  const Control_net<Traits>& points() const { return points_; }
  const std::vector<FT>& weights() const { return weights_; }
  const FT& weight(int i, int j) const { return weights_[static_cast<std::size_t>(i) * columns() + j]; }

  // (w_ij b_ij, w_ij), multiplied in the field.
  template <class Field = FT> auto homogeneous(int i, int j) const {
    return homogeneous_point(Geometric_continuity::coordinates<Traits, Field>(points_(i, j)),
                             to_field<Field>(weight(i, j)));
  }
  // The coordinate number x of it.
  FT homogeneous_coordinate(int i, int j, int x) const {
    const FT& w = weight(i, j);
    if (x == points_.dimension()) return w;
    const FT y = FT(Traits().compute_coordinate_object()(points_(i, j), x));
    return w == FT(0) ? y : FT(w * y);
  }
  std::vector<std::vector<typename Homogeneous_traits<Traits>::Point>> homogeneous() const {
    std::vector<std::vector<typename Homogeneous_traits<Traits>::Point>> net(rows());
    for (int i = 0; i < rows(); ++i)
      for (int j = 0; j < columns(); ++j) net[i].push_back(homogeneous(i, j));
    return net;
  }

  bool is_polynomial() const {
    return std::all_of(weights_.begin(), weights_.end(), [&](const FT& w) { return bool(w == weights_[0]); });
  }

  Rational_net transpose() const {
    Rational_net r(points_.transpose());
    auto w = r.weights_.begin();
    for (int j = 0; j < columns(); ++j)
      for (int i = 0; i < rows(); ++i) *w++ = weight(i, j);
    return r;
  }
  Rational_net reverse_rows() const {
    Rational_net r(points_.reverse_rows());
    auto w = r.weights_.begin();
    for (int i = rows(); i-- > 0;)
      for (int j = 0; j < columns(); ++j) *w++ = weight(i, j);
    return r;
  }
  Rational_net reverse_columns() const { return transpose().reverse_rows().transpose(); }

  // The images under an affine map of points.
  template <class Map> Rational_net transform(const Map& map, const char* surface) const {
    std::vector<Point> images;
    auto w = weights_.begin();
    for (const Point& p : points_) images.push_back(image_of_control_point<Traits>(map, p, *w++));
    return Rational_net(Control_net<Traits>(rows(), columns(), std::move(images), surface), weights_);
  }

  friend bool operator==(const Rational_net& a, const Rational_net& b) {
    return a.points_ == b.points_ && a.weights_ == b.weights_;
  }

  // The control points, then the weights, one row to a line.
  friend std::ostream& operator<<(std::ostream& os, const Rational_net& net) {
    os << net.points_ << "\nweights:";
    for (int i = 0; i < net.rows(); ++i)
      for (int j = 0; j < net.columns(); ++j) os << (j == 0 ? '\n' : ' ') << net.weight(i, j);
    return os;
  }

private:
  Rational_net(Control_net<Traits> points, std::vector<FT> weights)
      : points_(std::move(points)), weights_(std::move(weights)) {}

  template <class Weights>
  static std::vector<FT> weights_of(const Control_net<Traits>& points, const Weights& rows, const char* surface) {
    std::vector<FT> weights;
    int i = 0;
    for (const auto& row : rows) {
      const int n = static_cast<int>(std::distance(std::begin(row), std::end(row)));
      if (n != points.columns()) refuse(std::to_string(n) + " weights in row " + std::to_string(i), surface);
      weights.insert(weights.end(), std::begin(row), std::end(row));
      ++i;
    }
    if (i != points.rows()) refuse(std::to_string(i) + " rows of weights", surface);
    check_finite_weights(weights, surface);
    return weights;
  }
  static void refuse(const std::string& what, const char* surface) {
    throw Error(Error_code::wrong_number_of_points, std::string(surface) + ": " + what);
  }

  // Without infinite points.
  static Rational_net finite(const Control_net<Traits>& points, std::vector<FT> weights, const char* surface) {
    std::vector<Point> p(points.begin(), points.end());
    for (std::size_t k = 0; k < p.size(); ++k)
      if (weights[k] == FT(0)) p[k] = to_point<Traits>(Coordinates<Traits>(points.dimension()));
    return Rational_net(Control_net<Traits>(points.rows(), points.columns(), std::move(p), surface),
                        std::move(weights));
  }

  template <class Iterator> static std::vector<Point> affine_points(Iterator first, Iterator last) {
    std::vector<Point> points;
    for (; first != last; ++first) points.push_back(to_point<Traits>(affine_point(*first)));
    return points;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACES_INTERNAL_RATIONAL_NET_H
