// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_WEIGHTED_POINTS_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_WEIGHTED_POINTS_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/local/Homogeneous_traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>

#include <charconv>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file G2_weighted_points.h
/// Rational objects of a file: a control point is written as the products \f$ w x \f$ and the weight \f$ w \f$. With floating-point
/// numbers the point \f$ x \f$ is what is kept; the quotient is rounded once when it is read, and the product is written
/// exactly, so that it is read back without loss.

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// The control points and weights of a rational object, as they are read one after the other.
template <class Traits, class Exact> class G2_weighted_points {
  typedef typename Traits::FT FT;
  typedef typename Homogeneous_traits<Traits>::Point Row;

public:
  std::vector<typename Traits::Point> points; // of the weight 0, directions
  std::vector<FT> weights;

  // Throws Number_error when a number is too large for floating-point numbers.
  template <class Exact_row> void push_back(const Exact_row& exact) {
    const int n = exact.dimension() - 1;
    const auto x = affine_point(exact);
    Coordinates<Traits> point(n);
    for (int i = 0; i < n; ++i) point[i] = nearest_number<FT>(Exact(x[i]));
    points.push_back(to_point<Traits>(point));
    weights.push_back(nearest_number<FT>(exact[n]));
    infinite_ = infinite_ || weights.back() == FT(0);
  }

  // Whether a point is infinite; then the rows are to be used instead of points and weights.
  bool infinite() const { return infinite_; }

  // (w x, w)
  std::vector<Row> rows() const {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < points.size(); ++i)
      rows.push_back(homogeneous_point(coordinates<Traits>(points[i]), weights[i]));
    return rows;
  }

private:
  bool infinite_ = false;
};

// The text of the product w x, from which x is read back: of exact numbers the product itself, of floating-point numbers the
// shortest of a few decimals from which x is the nearest quotient, and otherwise the exact fraction.
template <class FT> std::string product_text(const FT& x, const FT& w) {
  if constexpr (std::is_floating_point_v<FT>) {
    typedef typename Exact_field<FT>::type Exact;
    check_finite(x, "write_number");
    check_finite(w, "write_number");
    const Exact weight = number_value<Exact>(number_text(w)); // as it will be read
    const auto gives_x = [&](const std::string& text) {
      return nearest_number<FT>(Exact(number_value<Exact>(text) / weight)) == x;
    };
    const Exact product = Exact(weight * Exact(x));
    const double size = CGAL::to_double(product);
    if (std::isfinite(size) && (size != 0 || x == FT(0))) {
      const std::string text = number_text(FT(size));
      if (gives_x(text)) return text;
      const long double longer = size + static_cast<long double>(CGAL::to_double(Exact(product - Exact(size))));
      char digits[64];
      const std::string more(digits, std::to_chars(digits, digits + sizeof digits, longer).ptr);
      if (gives_x(more)) return more;
    }
    return number_text(product);
  } else
    return number_text(FT(w * x));
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_WEIGHTED_POINTS_H
