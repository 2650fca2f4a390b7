// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_BERNSTEIN_TENSOR_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_BERNSTEIN_TENSOR_H

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/algebra/Bernstein_polynomial.h>

#include <cstddef>
#include <utility>
#include <vector>

// Polynomials in several variables on the unit cube, in tensor-product Bernstein form: the range of
// the coefficients encloses the range of the polynomial, and both agree at the corners. Farin,
// "Curves and Surfaces for CAGD", chapter 15.

namespace CGAL {
namespace Geometric_continuity {

// A polynomial \f$ \sum_i c_i \prod_k B_{i_k}^n(t_k) \f$ on \f$ [0, 1]^m \f$ of the same degree `n`
// in each of the `m` variables. The coefficient with the indices \f$ i_0, \dots, i_{m-1} \f$ has
// the number \f$ \sum_k i_k (n+1)^k \f$.
// \tparam FT a field number type, or intervals
template <class FT_> class Bernstein_tensor {
public:
  typedef FT_ FT; // the number type

  // Constructs a polynomial from \f$ (n+1)^m \f$ coefficients.
  // \throws Error `negative_count` when `variables` or `degree` is negative,
  //   `wrong_number_of_points` for another number of coefficients
  Bernstein_tensor(int variables, int degree, std::vector<FT> coefficients)
      : variables_(variables), degree_(degree), c_(std::move(coefficients)) {
    if (variables < 0 || degree < 0) throw Error(Error_code::negative_count, "Bernstein_tensor");
    if (c_.size() != power(variables)) throw Error(Error_code::wrong_number_of_points, "Bernstein_tensor");
  }

  // Returns the number `m` of variables.
  int variables() const { return variables_; }
  // Returns the degree `n` in each variable.
  int degree() const { return degree_; }
  // Returns all coefficients.
  const std::vector<FT>& coefficients() const { return c_; }
  // Returns the coefficient with a number.
  const FT& operator[](std::size_t i) const { return c_[i]; }

  // Returns the number of the coefficient that is the value at a corner, where bit `k` of `corner`
  // is \f$ t_k \f$.
  std::size_t corner_index(std::size_t corner) const {
    std::size_t index = 0;
    for (int k = 0; k < variables_; ++k)
      if ((corner >> k & 1) != 0) index += static_cast<std::size_t>(degree_) * power(k);
    return index;
  }

  // Returns the value at a point with `m` coordinates, which may lie outside of the unit cube.
  // \f$ O(m n^{m+1}) \f$
  // \throws Error `dimension_mismatch` for another number of coordinates
  FT operator()(const std::vector<FT>& t) const {
    if (t.size() != static_cast<std::size_t>(variables_))
      throw Error(Error_code::dimension_mismatch, "Bernstein_tensor: the coordinates of a point");
    std::vector<FT> c = c_, line(degree_ + 1, FT(0));
    // the last variable first: then what remains lies in the first places
    for (int k = variables_ - 1; k >= 0; --k)
      for (std::size_t i = 0; i < power(k); ++i) {
        for (int j = 0; j <= degree_; ++j) line[j] = c[i + j * power(k)];
        c[i] = Geometric_continuity::bernstein_value(line, degree_, t[k]);
      }
    return c[0];
  }

  // Returns the parts with \f$ t_k \f$ in [0, t] and in [t, 1], each reparametrised to the unit
  // cube. \f$ O(n^{m+1}) \f$ \throws Error `parameter_outside_domain` when there is no such
  // variable
  std::pair<Bernstein_tensor, Bernstein_tensor> split(int variable, const FT& t) const {
    if (variable < 0 || variables_ <= variable)
      throw Error(Error_code::parameter_outside_domain, "Bernstein_tensor::split: the variable");
    const std::size_t stride = power(variable), block = stride * (degree_ + 1);
    std::pair<Bernstein_tensor, Bernstein_tensor> parts(*this, *this);
    std::vector<FT> right(degree_ + 1, FT(0)), left(degree_ + 1, FT(0));
    for (std::size_t begin = 0; begin < c_.size(); begin += block)
      for (std::size_t i = begin; i < begin + stride; ++i) {
        for (int j = 0; j <= degree_; ++j) right[j] = c_[i + j * stride];
        Geometric_continuity::bernstein_split(right, degree_, t, left);
        for (int j = 0; j <= degree_; ++j) {
          parts.first.c_[i + j * stride] = left[j];
          parts.second.c_[i + j * stride] = right[j];
        }
      }
    return parts;
  }

  // Returns the sum of polynomials of the same degree. \throws Error `dimension_mismatch` for other
  // ones
  friend Bernstein_tensor operator+(Bernstein_tensor x, const Bernstein_tensor& y) {
    check_same(x, y);
    for (std::size_t i = 0; i < x.c_.size(); ++i) x.c_[i] += y.c_[i];
    return x;
  }
  // Returns the difference of polynomials of the same degree. \throws Error `dimension_mismatch`
  // for other ones
  friend Bernstein_tensor operator-(Bernstein_tensor x, const Bernstein_tensor& y) {
    check_same(x, y);
    for (std::size_t i = 0; i < x.c_.size(); ++i) x.c_[i] -= y.c_[i];
    return x;
  }

  // Returns the product of polynomials in the same variables, whose degree is the sum of the
  // degrees:
  // \f$ c_k = \sum_{i+j=k} a_i b_j \prod \binom{n_a}{i} \binom{n_b}{j} / \binom{n_a+n_b}{k} \f$.
  // \f$ O((n_a+1)^m (n_b+1)^m) \f$ \throws Error `dimension_mismatch` for other numbers of
  // variables
  friend Bernstein_tensor operator*(const Bernstein_tensor& x, const Bernstein_tensor& y) {
    if (x.variables_ != y.variables_) throw Error(Error_code::dimension_mismatch, "product of Bernstein_tensors");
    const Bernstein_tensor a = x.scaled(false), b = y.scaled(false);
    Bernstein_tensor product(x.variables_, x.degree_ + y.degree_);
    std::vector<std::size_t> place_a, place_b; // of each coefficient in the product
    for (std::size_t i = 0; i < a.c_.size(); ++i) place_a.push_back(a.place_in(product, i));
    for (std::size_t j = 0; j < b.c_.size(); ++j) place_b.push_back(b.place_in(product, j));
    for (std::size_t i = 0; i < a.c_.size(); ++i)
      for (std::size_t j = 0; j < b.c_.size(); ++j) product.c_[place_a[i] + place_b[j]] += FT(a.c_[i] * b.c_[j]);
    return product.scaled(true);
  }

private:
  int variables_, degree_;
  std::vector<FT> c_;

  Bernstein_tensor(int variables, int degree) : variables_(variables), degree_(degree), c_(power(variables), FT(0)) {}

  // (n + 1)^k
  std::size_t power(int k) const {
    std::size_t p = 1;
    for (; k > 0; --k) p *= static_cast<std::size_t>(degree_) + 1;
    return p;
  }

  // The number that the coefficient i has in a polynomial of another degree.
  std::size_t place_in(const Bernstein_tensor& other, std::size_t i) const {
    std::size_t place = 0;
    for (int k = 0; k < variables_; ++k, i /= degree_ + 1) place += i % (degree_ + 1) * other.power(k);
    return place;
  }

  // The coefficients times the binomial coefficients of all their indices, or divided by them.
  Bernstein_tensor scaled(bool divide) const {
    const std::vector<FT> binomials = binomial_coefficients<FT>(degree_);
    Bernstein_tensor result = *this;
    for (std::size_t i = 0; i < c_.size(); ++i) {
      std::size_t rest = i;
      for (int k = 0; k < variables_; ++k, rest /= degree_ + 1) {
        const FT& binomial = binomials[rest % (degree_ + 1)];
        if (divide)
          result.c_[i] /= binomial;
        else
          result.c_[i] *= binomial;
      }
    }
    return result;
  }

  static void check_same(const Bernstein_tensor& x, const Bernstein_tensor& y) {
    if (x.variables_ != y.variables_ || x.degree_ != y.degree_)
      throw Error(Error_code::dimension_mismatch, "sum of Bernstein_tensors");
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_FONT_BERNSTEIN_TENSOR_H
