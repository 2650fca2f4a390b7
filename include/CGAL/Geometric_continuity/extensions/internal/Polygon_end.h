// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_INTERNAL_POLYGON_END_H
#define CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_INTERNAL_POLYGON_END_H

#include <CGAL/Geometric_continuity/curves/Bezier_curve.h>
#include <CGAL/Geometric_continuity/numbers/internal/checked_numbers.h>
#include <CGAL/Geometric_continuity/numbers/internal/common_words.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

// c with v = c p, empty if there is none. \pre p is not zero
template <class FT, int N>
std::optional<FT> coefficient(const Coordinate_vector<FT, N>& v, const Coordinate_vector<FT, N>& p) {
  const FT pp = dot(p, p), pv = dot(p, v);
  if (pp * v != pv * p) return std::nullopt;
  return FT(pv / pp);
}

// The integrals over [0, 1] of (B_i^m)'' (B_j^m)''. With n = m - 2 the second derivative is m (m-1)
// times the second difference of the Bernstein polynomials of degree n, and the integral of B_k^n
// B_l^n is w_kl / (2n+1), w_kl = C(n,k) C(n,l) / C(2n,k+l), see squared_norm(). \pre m >= 2
template <class FT> class Second_derivative_products {
  const int m_, n_ = m_ - 2;
  std::vector<std::vector<FT>> w_; // w_kl for l >= k at [k][l - k]

public:
  explicit Second_derivative_products(int m) : m_(m) {
    if (Work_meter* const work =
            // the numbers have about 2 n digits in base 2, and each is used nine times
        scope_of<FT>())
      // equivalent [+ -> -, 1]: an estimate of work
      work->charge_fractions(12. * m * m, static_cast<std::size_t>(1 + m / 32));
    FT diagonal(1);
    for (int k = 0; k <= n_; ++k) {
      w_.emplace_back(1, diagonal);
      for (int l = k; l < n_; ++l)
        w_[k].push_back(FT(w_[k].back() * FT(FT(FT(n_ - l) * FT(k + l + 1)) / FT(FT(l + 1) * FT(2 * n_ - k - l)))));
      if (k < n_) diagonal = FT(w_[k][1] * FT(FT(FT(2) * FT(n_ - k)) / FT(2 * n_ - 2 * k - 1)));
    }
  }

  // Those of i with all j from 0 to m.
  std::vector<FT> row(int i) const {
    const FT leading = FT(FT(m_) * FT(m_ - 1)), factor = FT(leading * leading / FT(2 * n_ + 1));
    std::vector<FT> products;
    for (int j = 0; j <= m_; ++j) {
      FT sum(0);
      for (int k = (std::max)(i - 2, 0); k <= (std::min)(i, n_); ++k)
        for (int l = (std::max)(j - 2, 0); l <= (std::min)(j, n_); ++l) {
          const FT& w = k <= l ? w_[k][l - k] : w_[l][k - l];
          const int c = (i - k == 1 ? -2 : 1) * (j - l == 1 ? -2 : 1);
          sum += FT(c) * w;
        }
      products.push_back(FT(factor * sum));
    }
    return products;
  }
};

// The last n points of the polygon, in its order.
template <std::size_t n, class Traits, int Degree>
std::array<typename Traits::Point, n> last_points(const Bezier_curve<Traits, Degree>& curve, const char* place) {
  const int points = curve.degree() + 1, k = static_cast<int>(n);
  if (points < k)
    throw Error(Error_code::wrong_number_of_points,
                std::string(place) + ": they do not exist for degree " + std::to_string(curve.degree()));
  std::array<typename Traits::Point, n> last;
  for (int i = 0; i < k; ++i) last[i] = curve.control_point(points - k + i);
  return last;
}

// The last n points of a polygon of degree m and the ratio beta of a polygon that continues it:
// what the families of alternatives have in common. F is the number type of the kernel or the field
// in which predicates are decided.
template <class Traits, std::size_t n> class Polygon_end {
  static constexpr int N = dimension_v<Traits>;

public:
  typedef typename Traits::FT FT;
  typedef typename Traits::Point Point;
  typedef typename Traits::Vector Vector;
  typedef Predicate_FT<Traits> Field;

  int degree() const { return m_; }
  const FT& beta() const { return beta_; }

protected:
  template <class F> using Coordinates_over = Coordinate_vector<F, N>;
  typedef Coordinates_over<FT> Coordinates;

  Polygon_end(const std::array<Point, n>& last_points, int m, const FT& beta, const char* place)
      : m_(m), beta_(beta), place_(place) {
    if (m + 1 < static_cast<int>(n))
      throw Error(Error_code::wrong_number_of_points,
                  std::string(place) + ": they do not exist for degree " + std::to_string(m));
    if (!(FT(0) < beta)) throw Error(Error_code::nonpositive_beta, place);
    check_finite(beta, place);
    for (std::size_t i = 0; i < n; ++i) points_[i] = Geometric_continuity::coordinates<Traits>(last_points[n - 1 - i]);
    for (std::size_t i = 0; i < n; ++i) {
      if (points_[i].dimension() != points_[0].dimension()) throw Error(Error_code::dimension_mismatch, place);
      for (const FT& x : points_[i]) check_finite(x, place);
    }
    if (dot(p(), p()) == FT(0)) throw Error(Error_code::zero_tangent, place);
  }

  // the point b_{-i} and the differences
  template <class F = FT> Coordinates_over<F> b(int i) const { return convert<F>(points_[i]); }
  template <class F = FT> Coordinates_over<F> p() const { return b<F>(0) - b<F>(1); }
  template <class F = FT> Coordinates_over<F> r() const { return b<F>(2) - b<F>(1); }
  template <class F = FT> Coordinates_over<F> s() const { return b<F>(2) - b<F>(3); }

  Coordinates coordinates(const Point& point) const {
    const Coordinates c = Geometric_continuity::coordinates<Traits>(point);
    if (c.dimension() != points_[0].dimension()) throw Error(Error_code::dimension_mismatch, place_);
    for (const FT& x : c) check_finite(x, place_);
    return c;
  }
  Coordinates_over<Field> in_field(const Point& point) const { return convert<Field>(coordinates(point)); }

  FT finite(FT x) const {
    check_finite(x, place_);
    return x;
  }
  Point to_point(const Coordinates& c) const {
    for (const FT& x : c) check_finite(x, place_);
    return Geometric_continuity::to_point<Traits>(c);
  }

  // The point b_k for which the polygon b_0, ..., b_m has the least energy, where b holds b_0, ...,
  // b_{k-1} and the range b_{k+1}, ..., b_m: the derivative sum_j E_kj b_j vanishes.
  template <class InputIterator>
  Coordinates least_energy_point(std::vector<Coordinates> b, InputIterator first, InputIterator last) const {
    const int k = static_cast<int>(b.size());
    b.push_back(Coordinates(points_[0].dimension()));
    for (; first != last; ++first) b.push_back(coordinates(*first));
    if (static_cast<int>(b.size()) != m_ + 1)
      throw Error(Error_code::wrong_number_of_points,
                  std::string(place_) + ": " + std::to_string(m_ - k) + " points must be given");
    Coordinates sum(points_[0].dimension());
    const std::vector<FT> products = Second_derivative_products<FT>(m_).row(k);
    for (int j = 0; j <= m_; ++j) sum -= products[j] * b[j];
    return sum / products[k];
  }

private:
  std::array<Coordinates, n> points_; // from the end inwards
  int m_;
  FT beta_;
  const char* place_;

  template <class F> static Coordinates_over<F> convert(const Coordinates& c) {
    Coordinates_over<F> x(c.dimension());
    for (int i = 0; i < c.dimension(); ++i) x[i] = to_field<F>(c[i]);
    return x;
  }
};

} // namespace internal
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_EXTENSIONS_INTERNAL_POLYGON_END_H
