// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Writes the bounds of the rounding errors of the filter for joins as theorems for Gappa: for each
// form of Join_equations, each way of rounding, and both ends of the range of Join_filter, between
// which values are scaled by powers of two.

#include "support/Gappa_term.h"

#include <CGAL/Geometric_continuity/joins/internal/Join_input.h>

#include <array>
#include <string>
#include <utility>

namespace {

using namespace CGAL::Geometric_continuity::internal;

typedef Gappa_term Term;

const char* name_of(Join_question form) {
  constexpr const char* names[] = {"c0", "c1", "c2", "c3", "g1", "g2", "g3", "f3", "curvature_vector", "torsion"};
  return names[static_cast<int>(form)];
}

// Differences up to 2^exponent.
template <int N> Differences<Term, N> differences(bool from_first_differences, int exponent) {
  const auto first = [&](int k) { return Term::rounded_once(exponent - k); };
  const auto difference = [&](int k) -> Term {
    if (k == 0 || !from_first_differences) return first(0);
    if (k == 1) return first(1) - first(1);
    return (first(2) - first(2)) - (first(2) - first(2));
  };
  const auto vector = [&](int k) -> std::array<Term, N> {
    if constexpr (N == 2)
      return {difference(k), difference(k)};
    else
      return {difference(k), difference(k), difference(k)};
  };
  return {vector(0), vector(1), vector(2)};
}

// Writes theorems on each form whose value it is asked about.
class Theorems {
  const std::string prefix_;
  const double factor_;
  const int exponent_; // of the bound of all differences
  const Join_rounding rounding_;
  int count_ = 0;

public:
  Theorems(std::string prefix, double factor, int exponent, const Join_rounding& rounding)
      : prefix_(std::move(prefix)), factor_(factor), exponent_(exponent), rounding_(rounding) {}

  static constexpr bool exact = false;
  bool operator()(Join_question form, const Term& x) {
    // Half of the margin that Join_rounding adds is left for what the filter computes.
    const double error = rounding_.error[static_cast<int>(form)] * (1 - 0x1p-21);
    write_theorems(prefix_ + name_of(form) + '_' + std::to_string(count_++), x, factor_ * error,
                   exponent_ * form_degree(form));
    return true;
  }
};

template <int N, class Weights>
void geometric(Theorems theorems, const Differences<Term, N>& a, const Differences<Term, N>& b, const Weights& w) {
  const Join_equations<Term, N, Weights, Theorems> equations(a, b, w, theorems);
  (void)equations.tangents_parallel();
  (void)equations.g2(equations.ratio());
  (void)equations.g3(equations.ratio());
  (void)equations.curvature_vectors_equal();
  if constexpr (N == 3) {
    (void)equations.f3(equations.ratio());
    (void)equations.torsions_equal();
  }
}

template <int N> void all(const Theorem_arguments& arguments, int exponent) {
  const std::string prefix =
      arguments.folder + "/" + (N == 2 ? "plane" : "space") + (exponent < 0 ? "_small_" : "_large_");
  const auto whole = [] { return Term::whole_factor(); };
  const auto rounded = [] { return Term::factor("16b-52"); };
  Theorems theorems(prefix, arguments.factor, exponent, Join_rounding());
  const Differences<Term, N> a = differences<N>(true, exponent), b = differences<N>(true, exponent);
  geometric<N>(theorems, a, b, Degree_factors<Term>{whole(), whole(), whole(), whole(), whole()});

  const Parametric_degree_factors<Term> w{whole(), whole(), whole(), whole(), whole(), whole()};
  const Join_equations<Term, N, Parametric_degree_factors<Term>, Theorems> parametric(a, b, w, theorems);
  (void)parametric.template derivatives_equal<1>();
  (void)parametric.template derivatives_equal<2>();
  (void)parametric.template derivatives_equal<3>();

  geometric<N>(Theorems(prefix + "weighted_", arguments.factor, exponent, Rounding_of_weighted_ends::value()),
               differences<N>(false, exponent), differences<N>(false, exponent),
               Weighted_degree_factors<Join_question::g3, Term>{rounded(), rounded(), rounded(), rounded(), rounded(),
                                                                rounded()});
}

} // namespace

int main(int argc, char** argv) {
  const Theorem_arguments arguments(argc, argv);
  for (const int exponent : {-100, 100}) {
    all<2>(arguments, exponent);
    all<3>(arguments, exponent);
  }
}
