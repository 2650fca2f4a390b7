// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_EDGE_FUNCTION_H
#define CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_EDGE_FUNCTION_H

#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>
#include <CGAL/Geometric_continuity/algebra/sign_pattern.h>
#include <CGAL/Geometric_continuity/numbers/Work_limit.h>
#include <CGAL/Geometric_continuity/splines/Bspline_function.h>
#include <CGAL/Geometric_continuity/splines/Knot_vector.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <ostream>
#include <utility>
#include <vector>

/// \file Edge_function.h
/// A number, a polynomial or a spline that depends on the parameter along an edge: the free
/// functions in the shape of a blend surface.

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityConstruction
/// A function of the parameter along an edge, whose domain is mapped to [0, 1]: a spline, of which
/// numbers and polynomials are the ones without inner knots.
/// \tparam FT a field number type
template <class FT_> class Edge_function {
public:
  typedef FT_ FT; ///< the number type

private:
  Bspline_function<FT> f_; // on [0, 1], clamped

  struct On_unit_interval {};
  Edge_function(Bspline_function<FT> f, On_unit_interval) : f_(std::move(f)) {}

public:
  /// Constructs a polynomial from its Bernstein coefficients, a number from one.
  /// \throws Error `wrong_number_of_points` without coefficients, `not_finite`
  Edge_function(std::initializer_list<FT> coefficients) : Edge_function(Bernstein_polynomial<FT>(coefficients)) {}
  /// Constructs a polynomial. \throws Error `not_finite`
  Edge_function(const Bernstein_polynomial<FT>& p) : f_(Knot_vector<FT>(p.degree(), FT(0), FT(1)), p.coefficients()) {}
  /// Constructs a spline; its domain is mapped to [0, 1].
  Edge_function(const Bspline_function<FT>& f)
      : f_(on_interval({FT(0), FT(1)}, f.knots().is_clamped() ? f : f.clamp())) {}

  /// Returns the degree.
  int degree() const { return f_.degree(); }
  /// Returns the knots, from 0 to 1.
  const Knot_vector<FT>& knots() const { return f_.knots(); }
  /// Returns the number of coefficients \f$ c_i \f$ of the spline over the knots.
  int number_of_coefficients() const { return f_.knots().number_of_coefficients(); }
  /// Returns \f$ c_i \f$; of a number there is only \f$ c_0 \f$, of a polynomial these are
  /// Bernstein coefficients.
  const FT& operator[](int i) const { return f_[i]; }
  /// Returns the value at `t` in [0, 1]. \throws Error `parameter_outside_domain`
  FT operator()(const FT& t) const { return f_(t); }

  /// Returns the spline on another domain, to which [0, 1] is mapped. \throws Error `empty_domain`
  Bspline_function<FT> over(const std::pair<FT, FT>& domain) const { return on_interval(domain, f_); }

  /// Decides whether the function is a number.
  bool is_number() const { return f_.coefficients().size() == 1; }

  /// Decides whether the function is positive on [0, 1], on both sides of each knot; exactly, also
  /// of floating-point numbers.
  bool is_positive() const { return is_number() ? bool(FT(0) < f_.coefficients()[0]) : is_positive_function(); }

  /// Returns the product.
  friend Edge_function operator*(const Edge_function& f, const Edge_function& g) {
    return Edge_function(f.f_ * g.f_, On_unit_interval());
  }
  /// Returns the sum, in the larger of the two degrees and over the knots of both.
  friend Edge_function operator+(const Edge_function& f, const Edge_function& g) {
    return Edge_function(f.f_ + g.f_, On_unit_interval());
  }

  /// Decides whether knots and coefficients are equal.
  friend bool operator==(const Edge_function& f, const Edge_function& g) { return f.f_ == g.f_; }
  /// Decides whether a knot or a coefficient is different.
  friend bool operator!=(const Edge_function& f, const Edge_function& g) { return !(f == g); }

  /// Writes the coefficients, separated by spaces, and then ` over ` and the inner knots if there
  /// are any.
  friend std::ostream& operator<<(std::ostream& os, const Edge_function& f) {
    for (int i = 0; i < f.number_of_coefficients(); ++i) os << (i == 0 ? "" : " ") << f[i];
    const char* separator = " over ";
    for (const auto& knot : f.knots().inner_knots())
      for (int i = 0; i < knot.multiplicity; ++i, separator = " ") os << separator << knot.value;
    return os;
  }

private:
  // Is a function that is no number positive?
  bool is_positive_function() const {
    const std::vector<FT>& c = f_.coefficients();
    // mostly
    if (std::all_of(c.begin(), c.end(), [](const FT& x) { return FT(0) < x; })) return true;
    const internal::Work_on_part work("Edge_function::is_positive");
    const std::vector<FT> pieces = internal::bernstein_pieces(f_.knots(), f_.coefficients());
    const std::ptrdiff_t n = degree() + 1;
    for (auto piece = pieces.begin(); piece != pieces.end(); piece += n)
      if (sign_pattern(Bernstein_polynomial<FT>(piece, piece + n)) != Sign_pattern::positive) return false;
    return true;
  }

  static Bspline_function<FT> on_interval(const std::pair<FT, FT>& to, const Bspline_function<FT>& f) {
    return Bspline_function<FT>(f.knots().on_domain(to.first, to.second), f.coefficients());
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_SURFACE_BLENDS_EDGE_FUNCTION_H
