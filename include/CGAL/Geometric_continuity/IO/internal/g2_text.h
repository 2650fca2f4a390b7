// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H

#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/Traits.h>
#include <CGAL/Geometric_continuity/numbers/Exact_field.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <charconv>
#include <cmath>
#include <initializer_list>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// Rational objects of a file: a control point is written as the products w x and the weight w. With
// floating-point numbers the point x is what is kept; the quotient is rounded once when it is read,
// and the product is written exactly, so that it is read back without loss.

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

  // Returns whether a point is infinite; then the rows are to be used instead of points and
  // weights.
  bool infinite() const { return infinite_; }

  // (w x, w)
  std::vector<Row> rows() const {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < points.size(); ++i)
      rows.push_back(homogeneous_point(Geometric_continuity::coordinates<Traits>(points[i]), weights[i]));
    return rows;
  }

private:
  bool infinite_ = false;
};

// The text of the product w x, from which x is read back: of exact numbers the product itself, of
// floating-point numbers the shortest of a few decimals from which x is the nearest quotient, and
// otherwise the exact fraction.
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
      // unreachable: by rounding only: 64 binary digits give nearly every quotient
      if (gives_x(more)) return more;
    }
    return number_text(product);
  } else
    return number_text(FT(w * x));
}

// Writes an object of a class in the `.g2` format, with an empty line after it: one knot vector for
// each parameter, and `points` control points, of which row(j) has the words. The text is complete
// before any of it is written.
template <class FT, class Row_of>
void write_g2_text(std::ostream& os, int object_class, int dimension, bool rational,
                   std::initializer_list<const Knot_vector<FT>*> directions, long long points, Row_of row) {
  std::string text =
      std::to_string(object_class) + " 1 0 0\n" + std::to_string(dimension) + (rational ? " 1\n" : " 0\n");
  const auto add_line = [&text](const auto& words) {
    const char* separator = "";
    for (const auto& word : words) {
      text += separator;
      if constexpr (std::is_same_v<std::decay_t<decltype(word)>, std::string>)
        text += word;
      else
        text += number_text(word);
      separator = " ";
    }
    text += '\n';
  };
  for (const Knot_vector<FT>* knots : directions) {
    text += std::to_string(knots->number_of_coefficients()) + ' ' + std::to_string(knots->degree() + 1) + '\n';
    add_line(*knots);
  }
  for (long long j = 0; j < points; ++j) add_line(row(j));
  text += '\n';
  write_text(os, text);
}

// The words of a control point with its weight.
template <class FT, int N> std::vector<std::string> weighted_row(const Coordinate_vector<FT, N>& x, const FT& w) {
  std::vector<std::string> words;
  for (const FT& xi : x) words.push_back(w == FT(0) ? number_text(xi) : product_text(xi, w));
  words.push_back(number_text(w));
  return words;
}

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_G2_TEXT_H
