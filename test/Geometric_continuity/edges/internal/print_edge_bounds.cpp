// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes the bounds of the rounding errors of the filter for edges as theorems for Gappa: for both
// conditions of Rounded_edge_end, each way of rounding, and both ends of its range, between which
// values are scaled by powers of two.

#include "support/Gappa_term.h"

#include <CGAL/Geometric_continuity/edges/internal/Edge_equations.h>

#include <array>
#include <string>

namespace {

using namespace CGAL::Geometric_continuity::internal;

typedef Gappa_term Term;
typedef std::array<Term, 3> Vector;

// Numbers up to 2^exponent.
Vector differences(int exponent) {
  return {Term::rounded_once(exponent), Term::rounded_once(exponent), Term::rounded_once(exponent)};
}

// Products of the normal with second differences, which are those of two vectors and have the sum
// of their bounds.
class Products {
  Term mixed_, along_, first_, second_;

  static Term product(const Vector& normal, int exponent) {
    return dot_form(normal, minus(differences(exponent - 1), differences(exponent - 1)));
  }

public:
  Products(const Vector& normal, int exponent)
      : mixed_(product(normal, exponent)), along_(product(normal, exponent)), first_(product(normal, exponent)),
        second_(product(normal, exponent)) {}

  const Term& mixed() const { return mixed_; }
  const Term& along() const { return along_; }
  const Term& across(int side) const { return side == 0 ? first_ : second_; }
};

} // namespace

int main(int argc, char** argv) {
  const Theorem_arguments arguments(argc, argv);
  const Edge_rounding rounding;
  // Half of the margin of the bounds is left for what the filter computes.
  const double factor = arguments.factor * (1 - 0x1p-21);
  for (const int exponent : {-100, 100}) {
    const std::string prefix = arguments.folder + (exponent < 0 ? "/space_small_" : "/space_large_");
    const Vector d = differences(exponent), a = differences(exponent), b = differences(exponent),
                 normal = cross_form(d, a), n2 = cross_form(d, b), n3 = cross_form(b, a);
    write_theorems(prefix + "g1", dot_form(normal, b), factor * rounding.tangent_planes, 3 * exponent);
    const auto whole = [] { return Term::whole_factor(); };
    const Edge_factors<Term> w{whole(), whole(), {whole(), whole()}};
    const Products products(normal, exponent);
    for (std::size_t i = 0; i < 3; ++i)
      write_theorems(prefix + "g2_" + std::to_string(i), second_order_form(normal[i], n2[i], n3[i], w, products),
                     factor * rounding.curvatures, 7 * exponent);
  }
}
